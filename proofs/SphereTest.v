(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * How far outside a ball can be that the sphere test keeps

    The paper's sphere test keeps a ball when its centre is within r of the extent box and of every plane's
    half-space, normals being of unit length. Such a ball may miss the shaft (claim S6). [kept_cube_meets]: the cube
    around it meets the shaft, because the cube passes the box test, which is exact. So the shaft is at most sqrt 3
    radii away ([kept_ball_is_near]); no smaller factor will do ([sqrt3_is_approached]). *)
Require Import Reals Lra Psatz List Bool.
Require Import Gnomon.Boxes Gnomon.PlaneSet Gnomon.BoxTest Gnomon.BallDistance.
Import ListNotations.
Open Scope R_scope.

(** the squared distance from c to the extent box, as Arvo's test computes it *)
Definition squared_distance_to_extent (A B : box) (c : point) : R :=
  sum_over_axes (fun i => distance_to_interval (c i) (Rmin (lo A i) (lo B i)) (Rmax (hi A i) (hi B i)) ^ 2).

(** n.c - d <= r |n|, without dividing by the length of the normal *)
Definition sphere_test_keeps (A B : box) (c : point) (r : R) : Prop :=
  squared_distance_to_extent A B c <= r ^ 2 /\
  forall f g, fst f <> fst g -> extreme A B f -> extreme B A g ->
    dot (normal (edge_plane A B f g)) c - offset (edge_plane A B f g)
      <= r * sqrt (dot (normal (edge_plane A B f g)) (normal (edge_plane A B f g))).

Definition cube (c : point) (r : R) : box := Box (fun i => c i - r) (fun i => c i + r).

Lemma normal_square A B f g : fst f <> fst g ->
  dot (normal (edge_plane A B f g)) (normal (edge_plane A B f g)) =
  (reach B g - reach A g) ^ 2 + (reach A f - reach B f) ^ 2.
Proof.
  intro N; destruct f as [[] []], g as [[] []];
  cbv [dot sgn coord fst snd normal edge_plane axis_eqb] in *; try congruence; ring.
Qed.

Lemma root_at_most_sum u v : 0 <= u -> 0 <= v -> sqrt (u ^ 2 + v ^ 2) <= u + v.
Proof.
  intros U V; rewrite <- (sqrt_pow2 (u + v)) by lra; apply sqrt_le_1_alt; nra.
Qed.

(** Each axis alone is at most what all three are together. *)
Lemma one_of_sum (v : axis -> R) i : (forall j, 0 <= v j) -> v i <= sum_over_axes v.
Proof. intro P; unfold sum_over_axes; generalize (P X), (P Y), (P Z); destruct i; lra. Qed.

Lemma extent_side A B c r i : 0 <= r -> squared_distance_to_extent A B c <= r ^ 2 ->
  Rmin (lo A i) (lo B i) <= c i + r /\ c i - r <= Rmax (hi A i) (hi B i).
Proof.
  intros R0 D.
  set (d := fun j => distance_to_interval (c j) (Rmin (lo A j) (lo B j)) (Rmax (hi A j) (hi B j)) ^ 2).
  assert (P : forall j, 0 <= d j) by (intro j; unfold d; apply pow2_ge_0).
  assert (Q : d i <= r ^ 2) by (eapply Rle_trans; [apply one_of_sum; exact P | exact D]).
  assert (E : distance_to_interval (c i) (Rmin (lo A i) (lo B i)) (Rmax (hi A i) (hi B i)) <= r).
  { assert (0 <= distance_to_interval (c i) (Rmin (lo A i) (lo B i)) (Rmax (hi A i) (hi B i))) by apply Rmax_l.
    unfold d in Q; nra. }
  unfold distance_to_interval in E.
  pose proof (Rmax_r 0 (Rmax (Rmin (lo A i) (lo B i) - c i) (c i - Rmax (hi A i) (hi B i)))).
  pose proof (Rmax_l (Rmin (lo A i) (lo B i) - c i) (c i - Rmax (hi A i) (hi B i))).
  pose proof (Rmax_r (Rmin (lo A i) (lo B i) - c i) (c i - Rmax (hi A i) (hi B i))).
  lra.
Qed.

(** The bounding cube of a kept ball passes the box test, so it meets the shaft. *)
Theorem kept_cube_meets A B c r : valid A -> valid B -> 0 <= r -> sphere_test_keeps A B c r ->
  exists x, hull A B x /\ in_box (cube c r) x.
Proof.
  intros wA wB R0 [E P].
  assert (wT : valid (cube c r)) by (intro i; simpl; lra).
  destruct (outside_or_meets A B (cube c r) wA wB wT) as [[[i O]|[p [I O]]]|M]; [| |exact M]; exfalso.
  - destruct (extent_side A B c r i R0 E); simpl in O; lra.
  - destruct (proj1 (planes_are_the_papers A B p)) as [f [g [N [Ef [Eg [S1 S2]]]]]].
    { exists p; repeat split; auto. }
    assert (O' : beyond (edge_plane A B f g) (cube c r)).
    { intros x Hx; specialize (O x Hx); unfold dot in *; rewrite !S2, S1; exact O. }
    apply beyond_iff_near_corner in O'; auto.
    specialize (P f g N Ef Eg); rewrite normal_square, dot_edge_plane in P by auto.
    unfold extreme in Ef, Eg.
    pose proof (root_at_most_sum (reach B g - reach A g) (reach A f - reach B f)) as S.
    assert (F : forall h, near_reach (cube c r) h = sgn h * c (fst h) - r).
    { intros [i []]; cbv [near_reach cube lo hi sgn fst snd]; ring. }
    rewrite !F in O'.
    assert (S' : r * sqrt ((reach B g - reach A g) ^ 2 + (reach A f - reach B f) ^ 2) <=
                 r * ((reach B g - reach A g) + (reach A f - reach B f))).
    { apply Rmult_le_compat_l; [exact R0 | apply S; lra]. }
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
