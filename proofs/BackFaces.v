(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * Faces that no blocker is lost with

    S21: which faces of solids can be culled for an emitter, from the faces' planes alone; and S22: which neighbours of
    the receiver. q is a point of the emitter, p one of the receiver, and a segment between them is open. *)
Require Import Reals Lra Psatz List.
Require Import Gnomon.Boxes.
Import ListNotations.
Local Open Scope R_scope.

(** A face's plane: n.x - c, positive in front. *)
Record half := Half { outward : point; reach : R }.
Definition value h x := outward h X * x X + outward h Y * x Y + outward h Z * x Z - reach h.
Definition between s (q p : point) : point := fun i => lerp s (q i) (p i).
(** A convex solid is what lies behind all its faces; a face is what of it is in the face's plane. *)
Definition solid hs x := forall h, In h hs -> value h x <= 0.
Definition on_face hs h x := In h hs /\ solid hs x /\ value h x = 0.
(** Facing away from all of the emitter, or edge-on. *)
Definition back (emitter : point -> Prop) h := forall q, emitter q -> value h q <= 0.

Lemma value_between h s q p : value h (between s q p) = lerp s (value h q) (value h p).
Proof. unfold value, between, lerp; ring. Qed.
Lemma value_ext h x y : (forall i, x i = y i) -> value h x = value h y.
Proof. intro E; unfold value; rewrite !E; reflexivity. Qed.

(** From q to a point x of a convex solid: q is in it, or the way there enters it by a face that q is in front of. *)
Lemma entered_by_a_front_face hs q x : solid hs x -> solid hs q \/
  exists s h, 0 < s <= 1 /\ on_face hs h (between s q x) /\ 0 < value h q.
Proof.
  induction hs as [|h hs IH]; intro S; [left; intros k []|].
  assert (Sx : value h x <= 0) by (apply S; left; reflexivity).
  assert (Cross : 0 < value h q -> forall s0, 0 <= s0 <= 1 -> 0 <= value h (between s0 q x) ->
      solid hs (between s0 q x) -> exists s, 0 < s <= 1 /\ on_face (h :: hs) h (between s q x)).
  { intros P s0 Hs0 V0 K0; set (s := value h q / (value h q - value h x)).
    assert (Es : s * (value h q - value h x) = value h q) by (unfold s; field; lra).
    assert (B : 0 < s <= 1) by (split; [apply Rmult_lt_reg_r with (value h q - value h x)|
                                        apply Rmult_le_reg_r with (value h q - value h x)]; lra).
    rewrite value_between in V0; unfold lerp in V0.
    assert (L : s0 <= s) by (apply Rmult_le_reg_r with (value h q - value h x); lra).
    exists s; split; [exact B|split; [left; reflexivity|]].
    assert (Z0 : value h (between s q x) = 0) by (rewrite value_between; unfold lerp; lra).
    split; [|exact Z0]; intros k [E|I]; [subst k; lra|].
    assert (K1 := K0 k I); assert (K2 := S k (or_intror I)); rewrite value_between in *; unfold lerp in *.
    destruct (Rlt_le_dec s0 1) as [C|C]; [|replace s with 1 by lra; lra].
    assert (T := Rmult_le_compat_l (1 - s) _ _ ltac:(lra) K1).
    assert (U : (s - s0) * value k x <= 0) by nra.
    apply Rmult_le_reg_l with (1 - s0); [lra|]; lra. }
  destruct IH as [Q|[s0 [k [Hs [[I [K Ek]] Pk]]]]]; [intros k I; apply S; right; exact I| |].
  - destruct (Rle_lt_dec (value h q) 0) as [N|P].
    + left; intros k [E|I]; [subst k; exact N|apply Q; exact I].
    + right; destruct (Cross P 0) as [s [Hs F]]; [lra|rewrite value_between; unfold lerp; lra| |exists s, h; auto].
      intros k I; rewrite value_between; specialize (Q k I); unfold lerp; lra.
  - right; destruct (Rle_lt_dec (value h (between s0 q x)) 0) as [N|P].
    + exists s0, k; split; [exact Hs|split; [|exact Pk]]; split; [right; exact I|split; [|exact Ek]].
      intros j [E|J]; [subst j; exact N|apply K; exact J].
    + assert (Pq : 0 < value h q) by (rewrite value_between in P; unfold lerp in P; nra).
      destruct (Cross Pq s0) as [s [Hs' F]]; [lra|lra|exact K|exists s, h; auto].
Qed.

(** S21 for convex solids. When a face hides q from p, one does that is no back face; nor is it a face that p is on, or
    in front of: the receiver's own face can be left out as well. q must be outside the solid; p may be anywhere. *)
Theorem back_faces_can_be_culled hs (emitter : point -> Prop) q p s h : emitter q -> ~ solid hs q ->
  0 < s < 1 -> on_face hs h (between s q p) ->
  exists s' h', 0 < s' < 1 /\ on_face hs h' (between s' q p) /\ ~ back emitter h' /\ value h' p < 0.
Proof.
  intros Eq Nq Hs [I [K E]].
  destruct (entered_by_a_front_face hs q (between s q p) K) as [Q|[r [k [Hr [F Pk]]]]]; [elim (Nq Q)|].
  assert (Same : forall i, between r q (between s q p) i = between (r * s) q p i)
    by (intro i; unfold between, lerp; ring).
  exists (r * s), k; split; [nra|].
  destruct F as [J [G Z0]]; split; [split; [exact J|split]|split].
  - intros j Ij; rewrite <- (value_ext j _ _ Same); apply G; exact Ij.
  - rewrite <- (value_ext k _ _ Same); exact Z0.
  - intro B; specialize (B q Eq); lra.
  - rewrite (value_ext k _ _ Same), value_between in Z0; unfold lerp in Z0; assert (0 < r * s < 1) by nra; nra.
Qed.

(** An emitter that is a face of the solid itself sees none of it: then nothing is lost either. *)
Theorem own_solid_of_the_emitter_hides_nothing hs e q p s : In e hs -> 0 <= value e q -> 0 < value e p -> 0 < s < 1 ->
  ~ solid hs (between s q p).
Proof. intros I Q P Hs K; specialize (K e I); rewrite value_between in K; unfold lerp in K; nra. Qed.

(** Where q is inside, all is lost: to its centre the cube [-1, 1]^3 has back faces alone, and hides (3, 0, 0). *)
Definition axis_half i c r := Half (fun j => if axis_eqb i j then c else 0) r.
Definition cube_faces := [axis_half X 1 1; axis_half X (-1) 1; axis_half Y 1 1; axis_half Y (-1) 1;
                          axis_half Z 1 1; axis_half Z (-1) 1].
Theorem emitter_inside_loses_all : exists hs q p s h, 0 < s < 1 /\ on_face hs h (between s q p) /\
  (forall k, In k hs -> back (fun x => x = q) k).
Proof.
  exists cube_faces, (fun _ => 0), (fun i => match i with X => 3 | _ => 0 end), (1/3), (axis_half X 1 1).
  split; [lra|split; [split; [left; reflexivity|split]|]].
  - intros k I; simpl in I; repeat (destruct I as [I|I]; [subst k; unfold value, between, lerp; simpl; lra|]).
    destruct I.
  - unfold value, between, lerp; simpl; lra.
  - intros k I x E; subst x; simpl in I.
    repeat (destruct I as [I|I]; [subst k; unfold value; simpl; lra|]); destruct I.
Qed.

(** ** Solids of any form

    The segment from q reaches the solid first at y. Near y the solid is what lies behind all of some planes through y
    (a face, a convex edge or corner), or behind one of them (a reflex one). Then one of these is in front to q. *)
Definition near eps (y x : point) := forall i, Rabs (x i - y i) < eps.

Lemma point_before (q y : point) eps : 0 < eps -> exists s, 0 <= s < 1 /\
  forall t, s <= t <= 1 -> near eps y (between t q y).
Proof.
  intro P; set (m := 1 + Rabs (q X - y X) + Rabs (q Y - y Y) + Rabs (q Z - y Z)).
  assert (M : forall i, Rabs (q i - y i) < m).
  { intros []; unfold m; assert (A := Rabs_pos (q X - y X)); assert (B := Rabs_pos (q Y - y Y));
      assert (C := Rabs_pos (q Z - y Z)); lra. }
  assert (Pm : 0 < m) by (specialize (M X); assert (A := Rabs_pos (q X - y X)); lra).
  set (w := eps / (m + eps)).
  assert (Ew : w * (m + eps) = eps) by (unfold w; field; lra).
  assert (Hw : 0 < w <= 1) by (split; [apply Rmult_lt_reg_r with (m + eps)|apply Rmult_le_reg_r with (m + eps)]; lra).
  exists (1 - w); split; [lra|]; intros t Ht i; unfold between, lerp.
  replace ((1 - t) * q i + t * y i - y i) with ((1 - t) * (q i - y i)) by ring.
  rewrite Rabs_mult, (Rabs_pos_eq (1 - t)) by lra; specialize (M i).
  assert (A := Rabs_pos (q i - y i)); apply Rle_lt_trans with (w * Rabs (q i - y i)).
  - apply Rmult_le_compat_r; lra.
  - assert (w * Rabs (q i - y i) < w * m) by (apply Rmult_lt_compat_l; lra); nra.
Qed.

Section AnySolid.
Variable inside : point -> Prop.
Variable q y : point.
Hypothesis outside_before : forall s, 0 <= s < 1 -> ~ inside (between s q y).

Theorem first_point_is_on_a_front_face hs eps : 0 < eps -> (forall x, near eps y x -> inside x <-> solid hs x) ->
  solid hs y -> exists h, In h hs /\ value h y = 0 /\ 0 < value h q.
Proof.
  intros P L Sy; destruct (point_before q y eps P) as [s [Hs N]].
  set (a := between s q y).
  assert (Na : ~ solid hs a) by (intro S; apply (outside_before s Hs); apply L; [apply N; lra|exact S]).
  destruct (entered_by_a_front_face hs a y Sy) as [S|[r [h [Hr [[I [G E]] V]]]]]; [elim (Na S)|].
  assert (Same : forall i, between r a y i = between (s + r * (1 - s)) q y i)
    by (intro i; unfold a, between, lerp; ring).
  assert (R1 : r = 1).
  { destruct (Rlt_le_dec r 1) as [C|C]; [exfalso|lra].
    apply (outside_before (s + r * (1 - s))); [nra|]; apply L; [apply N; nra|].
    intros k Ik; rewrite <- (value_ext k _ _ Same); apply G; exact Ik. }
  subst r; exists h; split; [exact I|].
  rewrite value_between in E; unfold a in V; rewrite value_between in V; unfold lerp in *.
  assert (value h y = 0) by lra; split; [assumption|nra].
Qed.
Theorem first_point_at_a_reflex_edge hs eps : 0 < eps ->
  (forall x, near eps y x -> inside x <-> exists h, In h hs /\ value h x <= 0) ->
  (forall h, In h hs -> value h y = 0) -> forall h, In h hs -> 0 < value h q.
Proof.
  intros P L Z0 h I; destruct (point_before q y eps P) as [s [Hs N]].
  assert (V : 0 < value h (between s q y)).
  { apply Rnot_le_lt; intro C; apply (outside_before s Hs); apply L; [apply N; lra|]; exists h; auto. }
  rewrite value_between, (Z0 h I) in V; unfold lerp in V; nra.
Qed.
End AnySolid.

(** ** S22 *)

(** What lies behind the receiver's plane or in it hides nothing in front: the exact test for neighbours loses none. *)
Theorem exact_neighbours_hide_nothing plane (polygon : point -> Prop) p q s :
  (forall x, polygon x -> value plane x <= 0) -> 0 <= value plane p -> 0 < value plane q -> 0 < s < 1 ->
  ~ polygon (between s p q).
Proof. intros B P Q Hs K; specialize (B _ K); rewrite value_between in B; unfold lerp in B; nra. Qed.

(** Any tolerance loses some: half of it above the receiver, the square z = 0, |x| <= 1, |y| <= 1, a like square hides
    all of it from a light at (0, 0, 1 + tolerance). *)
Theorem tolerance_loses_a_blocker tolerance : 0 < tolerance ->
  let sheet z x := x Z = z /\ Rabs (x X) <= 1 /\ Rabs (x Y) <= 1 in
  forall p, sheet 0 p -> exists s, 0 < s < 1 /\
    sheet (tolerance / 2) (between s p (fun i => match i with Z => 1 + tolerance | _ => 0 end)).
Proof.
  intros P sheet p [Ez [Ex Ey]]; set (s := tolerance / 2 / (1 + tolerance)).
  assert (E : s * (1 + tolerance) = tolerance / 2) by (unfold s; field; lra).
  assert (Hs : 0 < s < 1) by (split; apply Rmult_lt_reg_r with (1 + tolerance); lra).
  exists s; split; [exact Hs|]; unfold sheet, between, lerp; rewrite Ez; split; [lra|].
  rewrite !Rmult_0_r, !Rplus_0_r, !Rabs_mult, (Rabs_pos_eq (1 - s)) by lra.
  assert (A := Rabs_pos (p X)); assert (B := Rabs_pos (p Y)); split; nra.
Qed.
