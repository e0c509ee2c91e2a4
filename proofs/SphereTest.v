(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * How far outside a ball can be that the sphere test keeps

    The paper's sphere test keeps a ball when its centre is within r of the extent box and of every plane's
    half-space, normals being of unit length. Such a ball may miss the shaft (claim S6). [kept_cube_meets]: the cube
    around it meets the shaft, because the cube passes the box test, which is exact. So the shaft is less than sqrt 3
    radii away ([kept_ball_is_nearer]), and no smaller factor will do ([sqrt3_is_approached]). *)
Require Import Reals Lra Psatz List Bool.
Require Import Gnomon.Boxes Gnomon.PlaneSet Gnomon.BoxTest Gnomon.BallDistance Gnomon.BallAgainstPlane.
Import ListNotations.
Open Scope R_scope.

(** n.c - d <= r |n|, without dividing by the length of the normal *)
Definition sphere_test_keeps (A B : box) (c : point) (r : R) : Prop :=
  squared_distance_to_extent A B c <= r ^ 2 /\
  forall f g, fst f <> fst g -> extreme A B f -> extreme B A g ->
    dot (normal (edge_plane A B f g)) c - offset (edge_plane A B f g)
      <= r * sqrt (dot (normal (edge_plane A B f g)) (normal (edge_plane A B f g))).

(** The test as a whole: what it does not call outside. *)
Lemma keeps_exactly_when_not_outside A B c r :
  sphere_test_keeps A B c r <-> ~ sphere_test_says_outside A B c r.
Proof.
  unfold sphere_test_keeps, sphere_test_says_outside, BallAgainstPlane.length; split.
  - intros [D P] [O|[f [g [N [Ef [Eg O]]]]]]; [lra|].
    specialize (P f g N Ef Eg); cbv zeta in O; lra.
  - intro K; split; [apply Rnot_gt_le; intro O; apply K; left; exact O|].
    intros f g N Ef Eg; apply Rnot_gt_le; intro O; apply K; right; exists f, g; auto.
Qed.

Definition cube (c : point) (r : R) : box := Box (fun i => c i - r) (fun i => c i + r).

Lemma normal_square A B f g : fst f <> fst g ->
  dot (normal (edge_plane A B f g)) (normal (edge_plane A B f g)) =
  (reach B g - reach A g) ^ 2 + (reach A f - reach B f) ^ 2.
Proof.
  intro N; destruct f as [[] []], g as [[] []];
  cbv [dot sgn coord fst snd normal edge_plane axis_eqb] in *; try congruence; ring.
Qed.

Lemma root_below_sum u v : 0 < u -> 0 < v -> sqrt (u ^ 2 + v ^ 2) < u + v.
Proof.
  intros U V; rewrite <- (sqrt_pow2 (u + v)) by lra; apply sqrt_lt_1_alt; nra.
Qed.

(** How far c is from the extent box on one axis. *)
Definition excess (A B : box) (c : point) (i : axis) : R :=
  distance_to_interval (c i) (Rmin (lo A i) (lo B i)) (Rmax (hi A i) (hi B i)).

Lemma excess_reaches A B c i :
  0 <= excess A B c i /\
  Rmin (lo A i) (lo B i) <= c i + excess A B c i /\ c i - excess A B c i <= Rmax (hi A i) (hi B i).
Proof.
  unfold excess, distance_to_interval.
  pose proof (Rmax_l 0 (Rmax (Rmin (lo A i) (lo B i) - c i) (c i - Rmax (hi A i) (hi B i)))).
  pose proof (Rmax_r 0 (Rmax (Rmin (lo A i) (lo B i) - c i) (c i - Rmax (hi A i) (hi B i)))).
  pose proof (Rmax_l (Rmin (lo A i) (lo B i) - c i) (c i - Rmax (hi A i) (hi B i))).
  pose proof (Rmax_r (Rmin (lo A i) (lo B i) - c i) (c i - Rmax (hi A i) (hi B i))).
  repeat split; lra.
Qed.

Lemma excess_at_most A B c r i : 0 <= r -> squared_distance_to_extent A B c <= r ^ 2 -> excess A B c i <= r.
Proof.
  intros R0 D; destruct (excess_reaches A B c i) as [E _].
  assert (excess A B c i ^ 2 <= r ^ 2); [|nra].
  eapply Rle_trans; [|exact D]; unfold squared_distance_to_extent, sum_over_axes.
  pose proof (pow2_ge_0 (excess A B c X)); pose proof (pow2_ge_0 (excess A B c Y));
  pose proof (pow2_ge_0 (excess A B c Z)); unfold excess in *; destruct i; lra.
Qed.

(** A box around c, given by its half sides, that no side and no plane of the shaft excludes meets the shaft. *)
Lemma box_around_meets A B c (h : point) : valid A -> valid B ->
  (forall i, excess A B c i <= h i) ->
  (forall f g, fst f <> fst g -> extreme A B f -> extreme B A g ->
     dot (normal (edge_plane A B f g)) c - offset (edge_plane A B f g)
       <= (reach B g - reach A g) * h (fst f) + (reach A f - reach B f) * h (fst g)) ->
  exists x, hull A B x /\ in_box (Box (fun i => c i - h i) (fun i => c i + h i)) x.
Proof.
  intros wA wB E P; set (T := Box (fun i => c i - h i) (fun i => c i + h i)).
  assert (wT : valid T).
  { intro i; destruct (excess_reaches A B c i) as [? _]; specialize (E i); simpl; lra. }
  destruct (outside_or_meets A B T wA wB wT) as [[[i O]|[p [I O]]]|M]; [| |exact M]; exfalso.
  - destruct (excess_reaches A B c i) as [_ [? ?]]; specialize (E i); simpl in O; lra.
  - destruct (proj1 (planes_are_the_papers A B p)) as [f [g [N [Ef [Eg [S1 S2]]]]]].
    { exists p; repeat split; auto. }
    assert (O' : beyond (edge_plane A B f g) T).
    { intros x Hx; specialize (O x Hx); unfold dot in *; rewrite !S2, S1; exact O. }
    apply beyond_iff_near_corner in O'; auto.
    specialize (P f g N Ef Eg); rewrite dot_edge_plane in P by auto.
    assert (F : forall k, near_reach T k = sgn k * c (fst k) - h (fst k)).
    { intros [k []]; cbv [near_reach T lo hi sgn fst snd]; ring. }
    rewrite !F in O'; lra.
Qed.

(** The bounding cube of a kept ball passes the box test, so it meets the shaft. *)
Theorem kept_cube_meets A B c r : valid A -> valid B -> 0 <= r -> sphere_test_keeps A B c r ->
  exists x, hull A B x /\ in_box (cube c r) x.
Proof.
  intros wA wB R0 [E P]; apply (box_around_meets A B c (fun _ => r) wA wB).
  - intro i; apply excess_at_most; assumption.
  - intros f g N Ef Eg; specialize (P f g N Ef Eg); rewrite normal_square in P by auto.
    unfold extreme in Ef, Eg.
    pose proof (root_below_sum (reach B g - reach A g) (reach A f - reach B f)) as S.
    assert (r * sqrt ((reach B g - reach A g) ^ 2 + (reach A f - reach B f) ^ 2) <=
            r * ((reach B g - reach A g) + (reach A f - reach B f))) by (apply Rmult_le_compat_l; lra).
    lra.
Qed.

Theorem kept_ball_is_near A B c r : valid A -> valid B -> 0 <= r -> sphere_test_keeps A B c r ->
  exists x, hull A B x /\ squared_distance x c <= 3 * r ^ 2.
Proof.
  intros wA wB R0 K; destruct (kept_cube_meets A B c r wA wB R0 K) as [x [H I]].
  exists x; split; [exact H|].
  assert (Q : forall i, (x i - c i) ^ 2 <= r ^ 2) by (intro i; specialize (I i); simpl in I; nra).
  unfold squared_distance, sum_over_axes; generalize (Q X), (Q Y), (Q Z); lra.
Qed.

(** The planes leave room, as both components of their normals differ from 0: one amount for all. *)
Lemma one_for_all_faces (P : face -> R -> Prop) :
  (forall f, exists d, 0 < d /\ forall e, e <= d -> P f e) -> exists d, 0 < d /\ forall f e, e <= d -> P f e.
Proof.
  intro H; destruct (H (X,MIN)) as [d1 [D1 H1]], (H (X,MAX)) as [d2 [D2 H2]], (H (Y,MIN)) as [d3 [D3 H3]],
    (H (Y,MAX)) as [d4 [D4 H4]], (H (Z,MIN)) as [d5 [D5 H5]], (H (Z,MAX)) as [d6 [D6 H6]].
  assert (M : exists d, 0 < d /\ d <= d1 /\ d <= d2 /\ d <= d3 /\ d <= d4 /\ d <= d5 /\ d <= d6).
  { exists (Rmin d1 (Rmin d2 (Rmin d3 (Rmin d4 (Rmin d5 d6))))); unfold Rmin; repeat destruct Rle_dec; lra. }
  destruct M as [d [D [? [? [? [? [? ?]]]]]]]; exists d; split; [exact D|].
  intros [[] []] e E; [apply H1|apply H2|apply H3|apply H4|apply H5|apply H6]; lra.
Qed.

Definition room_at (A B : box) (c : point) (r : R) (f g : face) (e : R) : Prop :=
  fst f <> fst g -> extreme A B f -> extreme B A g ->
  dot (normal (edge_plane A B f g)) c - offset (edge_plane A B f g)
    <= (r - e) * ((reach B g - reach A g) + (reach A f - reach B f)).

Lemma planes_leave_room A B c r : 0 < r -> sphere_test_keeps A B c r ->
  exists d, 0 < d /\ forall f e, e <= d -> forall g, room_at A B c r f g e.
Proof.
  intros R0 [_ P]; apply one_for_all_faces; intro f.
  destruct (one_for_all_faces (fun g e => room_at A B c r f g e)) as [d [D H]].
  2: { exists d; split; [exact D|]; intros e E g; apply H; exact E. }
  intro g; unfold room_at.
  destruct (Rlt_dec (reach B f) (reach A f)) as [Ef|Ef]; [|exists 1; split; [lra|intros; unfold extreme in *; lra]].
  destruct (Rlt_dec (reach A g) (reach B g)) as [Eg|Eg]; [|exists 1; split; [lra|intros; unfold extreme in *; lra]].
  set (u := reach B g - reach A g) in *; set (v := reach A f - reach B f) in *.
  assert (U : 0 < u) by (unfold u; lra); assert (V : 0 < v) by (unfold v; lra).
  pose proof (root_below_sum u v U V) as S.
  assert (W : 0 < u + v) by lra.
  exists (r * (u + v - sqrt (u ^ 2 + v ^ 2)) / (u + v)); split.
  - apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; lra|exact W].
  - intros e E N _ _; specialize (P f g N Ef Eg); rewrite normal_square in P by auto; fold u v in P.
    assert (e * (u + v) <= r * (u + v - sqrt (u ^ 2 + v ^ 2))).
    { apply Rmult_le_reg_r with (/ (u + v)); [apply Rinv_0_lt_compat; exact W|].
      rewrite Rmult_assoc, Rinv_r, Rmult_1_r by lra; exact E. }
    lra.
Qed.

(** So a box that is smaller than the cube on two axes at least passes, too: the shaft is nearer than sqrt 3 radii. *)
Theorem kept_ball_is_nearer A B c r : valid A -> valid B -> 0 < r -> sphere_test_keeps A B c r ->
  exists x, hull A B x /\ squared_distance x c < 3 * r ^ 2.
Proof.
  intros wA wB R0 K; destruct (planes_leave_room A B c r R0 K) as [d0 [D0 P]]; destruct K as [E _].
  set (d := Rmin d0 (r / 2)).
  assert (D : 0 < d /\ d <= d0 /\ d <= r / 2) by (unfold d, Rmin; destruct Rle_dec; lra).
  set (h := fun i => Rmax (excess A B c i) (r - d)).
  assert (H1 : forall i, excess A B c i <= h i) by (intro i; apply Rmax_l).
  assert (H2 : forall i, r - d <= h i) by (intro i; apply Rmax_r).
  destruct (box_around_meets A B c h wA wB H1) as [x [Hx I]].
  - intros f g N Ef Eg.
    assert (Q : d <= d0) by lra.
    pose proof (P f d Q g N Ef Eg) as L; unfold extreme in Ef, Eg.
    pose proof (H2 (fst f)); pose proof (H2 (fst g)).
    assert ((reach B g - reach A g) * (r - d) <= (reach B g - reach A g) * h (fst f)) by (apply Rmult_le_compat_l; lra).
    assert ((reach A f - reach B f) * (r - d) <= (reach A f - reach B f) * h (fst g)) by (apply Rmult_le_compat_l; lra).
    lra.
  - exists x; split; [exact Hx|].
    (* h^2 <= excess^2 + (r - d)^2 on each axis, and the squares of the excesses sum up to r^2 *)
    assert (Q : forall i, (x i - c i) ^ 2 <= h i ^ 2).
    { intro i; specialize (I i); simpl in I; specialize (H2 i); nra. }
    assert (T : forall i, h i ^ 2 <= r ^ 2) by
      (intro i; assert (h i <= r) by (apply Rmax_lub; [apply excess_at_most; [lra|exact E]|lra]);
       specialize (H2 i); nra).
    assert (S : (r - d) ^ 2 < r ^ 2) by nra.
    assert (L : forall i, h i ^ 2 = r ^ 2 -> excess A B c i ^ 2 = r ^ 2).
    { intros i Hi; unfold h, Rmax in Hi; destruct Rle_dec; lra. }
    assert (G : forall i, h i ^ 2 < r ^ 2 \/ excess A B c i ^ 2 = r ^ 2).
    { intro i; destruct (Rle_lt_or_eq_dec _ _ (T i)); auto. }
    assert (E' : excess A B c X ^ 2 + excess A B c Y ^ 2 + excess A B c Z ^ 2 <= r ^ 2) by exact E.
    pose proof (pow2_ge_0 (excess A B c X)); pose proof (pow2_ge_0 (excess A B c Y));
    pose proof (pow2_ge_0 (excess A B c Z)); assert (0 < r ^ 2) by nra.
    unfold squared_distance, sum_over_axes; generalize (Q X), (Q Y), (Q Z), (T X), (T Y), (T Z).
    destruct (G X), (G Y), (G Z); lra.
Qed.

(** A light at the origin, a square at x = -M, and a ball around (1, 1, 1), beyond the light, of radius 1 + 1/M. *)
Definition light : box := Box (fun _ => 0) (fun _ => 0).
Definition square (M : R) : box :=
  Box (fun i => match i with X => - M | _ => -1 end) (fun i => match i with X => - M | _ => 1 end).

Lemma light_is_far M x : 2 <= M -> hull light (square M) x -> 3 <= squared_distance x (fun _ => 1).
Proof.
  intros HM H; apply hull_is_union_of_boxes in H; [|intros []; simpl; lra|intros []; simpl; lra].
  destruct H as [s [Hs H]]; generalize (H X), (H Y), (H Z); unfold lerp, light, square; simpl; intros.
  unfold squared_distance, sum_over_axes.
  assert (x X = - (s * M)) by lra.
  assert ((1 - s) ^ 2 <= (x Y - 1) ^ 2) by nra.
  assert ((1 - s) ^ 2 <= (x Z - 1) ^ 2) by nra.
  assert (0 <= s * (M - 2)) by nra.
  assert ((1 + s * M) ^ 2 = (x X - 1) ^ 2) by (replace (x X) with (- (s * M)) by auto; ring).
  assert (0 <= (s * M) ^ 2) by apply pow2_ge_0.
  nra.
Qed.

Lemma light_ball_is_kept M : 2 <= M -> sphere_test_keeps light (square M) (fun _ => 1) (1 + / M).
Proof.
  intro HM; assert (I : 0 < / M) by (apply Rinv_0_lt_compat; lra).
  assert (MI : M * / M = 1) by (field; lra).
  split.
  - unfold squared_distance_to_extent, sum_over_axes, light, square, distance_to_interval, Rmin, Rmax; simpl.
    repeat destruct Rle_dec; nra.
  - intros f g N Ef Eg; rewrite normal_square by auto.
    assert (R1 : M <= sqrt (1 + M ^ 2)).
    { rewrite <- (sqrt_pow2 M) at 1 by lra; apply sqrt_le_1_alt; nra. }
    assert (R2 : M + 1 <= (1 + / M) * sqrt (1 + M ^ 2)) by nra.
    unfold extreme in Ef, Eg.
    destruct f as [[] []], g as [[] []]; cbv [sgn coord light square lo hi fst snd] in Ef, Eg, N;
    try congruence; try lra;
    cbv [dot offset normal edge_plane axis_eqb sgn coord light square lo hi fst snd];
    match goal with |- _ <= (1 + / M) * sqrt ?e => replace e with (1 + M ^ 2) by ring end; lra.
Qed.

(** No factor below 3 would do: sqrt 3 radii are the supremum. *)
Theorem sqrt3_is_approached q : q < 3 -> exists A B c r, valid A /\ valid B /\ 0 < r /\ sphere_test_keeps A B c r /\
  forall x, hull A B x -> q * r ^ 2 < squared_distance x c.
Proof.
  intro Q; set (M := 2 + 9 / (3 - q)).
  assert (I : 0 < / (3 - q)) by (apply Rinv_0_lt_compat; lra).
  assert (HM : 2 <= M) by (unfold M, Rdiv; nra).
  assert (J : 0 < / M) by (apply Rinv_0_lt_compat; lra).
  assert (MI : M * / M = 1) by (field; lra).
  assert (E : (M - 2) * (3 - q) = 9) by (unfold M; field; lra).
  exists light, (square M), (fun _ => 1), (1 + / M).
  split; [intros []; simpl; lra|]; split; [intros []; simpl; lra|]; split; [lra|].
  split; [apply light_ball_is_kept; exact HM|].
  intros x H; apply Rlt_le_trans with 3; [|apply light_is_far with M; auto].
  assert (J1 : / M <= / 2) by (apply Rinv_le_contravar; lra).
  destruct (Rle_lt_dec q 0); [nra|].
  (* q (1 + 1/M)^2 <= q + 9/M < 3 *)
  assert (q * (1 + / M) ^ 2 <= q + 9 * / M) by nra.
  assert (9 * / M < 3 - q) by nra.
  lra.
Qed.
