(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * The plane set

    Where A is strictly the extreme box on a face f, and B on a face g of another axis, the shaft has a plane
    through the edge of A on (f, g) and that of B. This file says that these planes are what they should be: they
    contain both edges, point outwards, have the whole shaft behind them, and a box lies beyond one exactly when
    its near corner does. *)
Require Import Reals Lra Psatz List Bool Arith.
Require Import Gnomon.Boxes.
Import ListNotations.
Open Scope R_scope.

(** A is strictly the extreme one on face f *)
Definition extreme (A B : box) (f : face) : Prop := sgn f * coord B f < sgn f * coord A f.

(** planes  n . x = d *)
Record plane := Plane { normal : point; offset : R }.
Definition dot (n x : point) : R := n X * x X + n Y * x Y + n Z * x Z.
Definition beyond (p : plane) (T : box) : Prop :=
  forall x, in_box T x -> dot (normal p) x > offset p.

(** the plane parallel to the third axis through the edges (f,g) of A and of B:
    n_i = (b2-a2), n_j = (a1-b1), d = a1*n_i + a2*n_j, times the sign that turns
    it outwards when A is the extreme one on f and B on g. *)
Definition edge_plane (A B : box) (f g : face) : plane :=
  let a1 := coord A f in let a2 := coord A g in
  let b1 := coord B f in let b2 := coord B g in
  let e := sgn f * sgn g in
  let ni := e * (b2 - a2) in let nj := e * (a1 - b1) in
  Plane (fun k => if axis_eqb k (fst f) then ni else
                  if axis_eqb k (fst g) then nj else 0)
        (a1 * ni + a2 * nj).

(** three-way comparison: which box is the strictly extreme one on f *)
Inductive owner := box_A | box_B | neither.
Definition extreme_box (A B : box) (f : face) : owner :=
  if Rlt_dec (sgn f * coord B f) (sgn f * coord A f) then box_A else
  if Rlt_dec (sgn f * coord A f) (sgn f * coord B f) then box_B else neither.

(** the plane set, as the code builds it: the 12 unordered pairs of faces on
    different axes *)
Definition pairs : list (face * face) :=
  [((X,MIN),(Y,MIN));((X,MIN),(Y,MAX));((X,MAX),(Y,MIN));((X,MAX),(Y,MAX));
   ((X,MIN),(Z,MIN));((X,MIN),(Z,MAX));((X,MAX),(Z,MIN));((X,MAX),(Z,MAX));
   ((Y,MIN),(Z,MIN));((Y,MIN),(Z,MAX));((Y,MAX),(Z,MIN));((Y,MAX),(Z,MAX))].

Definition planes_of_pair (A B : box) (fg : face * face) : list plane :=
  let (f, g) := fg in
  match extreme_box A B f, extreme_box A B g with
  | box_A, box_B => [edge_plane A B f g]
  | box_B, box_A => [edge_plane B A f g]
  | _, _ => []
  end.
Definition planes (A B : box) : list plane := flat_map (planes_of_pair A B) pairs.

Lemma extreme_box_A A B f : extreme_box A B f = box_A <-> extreme A B f.
Proof. unfold extreme_box, extreme; destruct Rlt_dec; [|destruct Rlt_dec]; split; intros; try discriminate; try reflexivity; lra. Qed.
Lemma extreme_box_B A B f : extreme_box A B f = box_B <-> extreme B A f.
Proof. unfold extreme_box, extreme; destruct Rlt_dec; [|destruct Rlt_dec]; split; intros; try discriminate; try reflexivity; lra. Qed.

(** equality of planes, coefficient by coefficient *)
Definition same_plane (p q : plane) : Prop := offset p = offset q /\ forall k, normal p k = normal q k.
Lemma edge_plane_symmetric A B f g : fst f <> fst g -> same_plane (edge_plane A B f g) (edge_plane B A g f).
Proof.
  intro N; split; [simpl; ring|intro k].
  destruct k, f as [[] []], g as [[] []]; cbv [sgn coord fst snd normal edge_plane axis_eqb] in *;
  try congruence; ring.
Qed.
(** the list is exactly the set of the paper *)
Theorem planes_are_the_papers A B p :
  (exists q, In q (planes A B) /\ same_plane q p) <->
  (exists f g, fst f <> fst g /\ extreme A B f /\ extreme B A g /\ same_plane (edge_plane A B f g) p).
Proof.
  unfold planes; split.
  - intros [q [H E]]; apply in_flat_map in H; destruct H as [[f g] [I H]]; simpl in H.
    assert (N : fst f <> fst g).
    { simpl in I; repeat (destruct I as [I|I]; [inversion I; simpl; discriminate|]); destruct I. }
    destruct (extreme_box A B f) eqn:Ef, (extreme_box A B g) eqn:Eg; simpl in H; try tauto;
    destruct H as [<-|[]]; rewrite ?extreme_box_A, ?extreme_box_B in *.
    + exists f, g; auto.
    + exists g, f; repeat split; auto.
      * destruct E as [E _]; rewrite <- E; apply edge_plane_symmetric; auto.
      * intro k; destruct E as [_ E]; rewrite <- E; apply edge_plane_symmetric; auto.
  - intros [f [g [N [Ef [Eg [E1 E2]]]]]].
    assert (C : In (f, g) pairs \/ In (g, f) pairs).
    { destruct f as [[] []], g as [[] []]; simpl in N; try congruence; simpl; tauto. }
    destruct C as [C|C].
    + exists (edge_plane A B f g); split; [|split; auto].
      apply in_flat_map; exists (f, g); split; [exact C|].
      simpl; rewrite (proj2 (extreme_box_A A B f) Ef), (proj2 (extreme_box_B A B g) Eg); left; reflexivity.
    + exists (edge_plane B A g f); split.
      * apply in_flat_map; exists (g, f); split; [exact C|].
        simpl; rewrite (proj2 (extreme_box_A A B f) Ef), (proj2 (extreme_box_B A B g) Eg); left; reflexivity.
      * destruct (edge_plane_symmetric B A g f) as [S1 S2]; auto.
        split; [congruence | intro k; rewrite S2; auto].
Qed.

(** the plane contains every point of the two edges *)
Definition on_edge (b : box) (f g : face) (x : point) :=
  x (fst f) = coord b f /\ x (fst g) = coord b g.
Lemma plane_contains_edges A B f g x : fst f <> fst g ->
  on_edge A f g x \/ on_edge B f g x -> dot (normal (edge_plane A B f g)) x = offset (edge_plane A B f g).
Proof.
  intros N [[H1 H2]|[H1 H2]]; unfold dot, edge_plane; simpl; rewrite <- ?H1, <- ?H2;
  destruct f as [[] []], g as [[] []]; simpl in *; try congruence; rewrite ?H1, ?H2; ring.
Qed.
(** it is parallel to the third axis, its normal is not zero and points outwards
    on both faces *)
Lemma plane_normal A B f g : fst f <> fst g -> extreme A B f -> extreme B A g ->
  let n := normal (edge_plane A B f g) in
  0 < sgn f * n (fst f) /\ 0 < sgn g * n (fst g) /\
  forall k, k <> fst f -> k <> fst g -> n k = 0.
Proof.
  intros N Ef Eg; unfold extreme in *.
  destruct f as [[] []], g as [[] []]; cbv [sgn coord fst snd normal edge_plane axis_eqb] in *;
  try congruence; (split; [lra|split; [lra|intros [] ? ?; congruence]]).
Qed.

(** The value of the near corner of T on face f, counted outwards: no point of T reaches less far. *)
Definition near_reach (T : box) (f : face) : R :=
  match snd f with MIN => - hi T (fst f) | MAX => lo T (fst f) end.

Notation reach A f := (sgn f * coord A f).

Lemma dot_edge_plane A B f g x : fst f <> fst g ->
  dot (normal (edge_plane A B f g)) x =
  (reach B g - reach A g) * (sgn f * x (fst f)) + (reach A f - reach B f) * (sgn g * x (fst g)).
Proof.
  intro N; destruct f as [[] []], g as [[] []];
  cbv [dot sgn coord fst snd normal edge_plane axis_eqb] in *; try congruence; ring.
Qed.
Lemma offset_edge_plane A B f g :
  offset (edge_plane A B f g) = (reach B g - reach A g) * reach A f + (reach A f - reach B f) * reach A g.
Proof.
  destruct f as [i []], g as [j []]; cbv [offset sgn coord fst snd edge_plane]; ring.
Qed.

(** T is strictly beyond iff its inmost corner is: the test as coded *)
Lemma beyond_iff_near_corner A B f g T : valid T -> fst f <> fst g -> extreme A B f -> extreme B A g ->
  (beyond (edge_plane A B f g) T <->
   (reach B g - reach A g) * near_reach T f + (reach A f - reach B f) * near_reach T g > offset (edge_plane A B f g)).
Proof.
  intros wT N Ef Eg; unfold beyond, extreme in *; split.
  - intro H.
    specialize (H (fun k => if axis_eqb k (fst f) then sgn f * near_reach T f else
                            if axis_eqb k (fst g) then sgn g * near_reach T g else lo T k)).
    rewrite dot_edge_plane in H by auto.
    assert (I : forall k, axis_eqb k k = true) by (intros []; reflexivity).
    assert (J : axis_eqb (fst g) (fst f) = false)
      by (destruct f as [[] ?], g as [[] ?]; simpl in *; congruence).
    rewrite !I, J in H.
    replace (sgn f * (sgn f * near_reach T f)) with (near_reach T f) in H by (destruct f as [? []]; unfold sgn; simpl; ring).
    replace (sgn g * (sgn g * near_reach T g)) with (near_reach T g) in H by (destruct g as [? []]; unfold sgn; simpl; ring).
    apply H; clear H; intro k; generalize (wT k).
    destruct k, f as [[] []], g as [[] []]; cbv [sgn near_reach fst snd axis_eqb] in *; intro; try congruence; lra.
  - intros H x Hx; rewrite dot_edge_plane by auto.
    assert (F : forall h, near_reach T h <= sgn h * x (fst h)).
    { intros [i []]; specialize (Hx i); cbv [sgn near_reach fst snd]; lra. }
    generalize (F f), (F g); intros; nra.
Qed.

Lemma sgn_squared f : sgn f * sgn f = 1.
Proof. destruct f as [? []]; unfold sgn; simpl; ring. Qed.

(** the hull lies in the closed inner half-space of every plane *)
Lemma hull_within_plane A B f g x : valid A -> valid B -> fst f <> fst g ->
  extreme A B f -> extreme B A g -> hull A B x ->
  dot (normal (edge_plane A B f g)) x <= offset (edge_plane A B f g).
Proof.
  intros wA wB N Ef Eg H; apply hull_is_union_of_boxes in H; auto; destruct H as [s [Hs H]].
  rewrite dot_edge_plane, offset_edge_plane by auto; unfold extreme in *.
  assert (F : forall h, sgn h * x (fst h) <= lerp s (reach A h) (reach B h)).
  { intros [i []]; specialize (H i); cbv [lerp sgn coord fst snd] in *; lra. }
  generalize (F f), (F g); unfold lerp.
  set (a := reach A f) in *; set (b := reach B f) in *; set (c := reach A g) in *; set (d := reach B g) in *.
  intros H1 H2.
  apply Rle_trans with ((d - c) * ((1 - s) * a + s * b) + (a - b) * ((1 - s) * c + s * d)).
  - apply Rplus_le_compat; apply Rmult_le_compat_l; lra.
  - right; ring.
Qed.
