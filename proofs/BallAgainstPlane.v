(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * The sphere test

    A ball against a half-space ([ball_beyond_exactly_when], [ball_behind_exactly_when]), and the paper's test made of
    it: it culls no ball that meets the shaft ([sphere_test_culls_nothing_that_meets], the safe half of claim S6), and
    lets balls pass that do not ([sphere_test_has_false_positives], the other half). What the paper prints for "fully
    inside the plane" is wrong ([printed_inside_test_is_wrong], claim S7); with the sign and the comparison turned,
    T <= -radius, it is exact, and the whole inside test with it ([ball_inside_test_is_exact]). Its comparison is the
    outside one plus the diameter ([inside_is_outside_plus_diameter], claim S8). *)
Require Import Reals Lra Psatz List Bool.
Require Import Gnomon.Boxes Gnomon.PlaneSet Gnomon.BoxTest Gnomon.BallDistance.
Open Scope R_scope.

Definition in_ball (c : point) (r : R) (x : point) : Prop := squared_distance x c <= r ^ 2.
Definition length (n : point) : R := sqrt (dot n n).

Lemma dot_self n : 0 <= dot n n.
Proof. unfold dot; nra. Qed.
Lemma length_squared n : length n * length n = dot n n.
Proof. apply sqrt_sqrt, dot_self. Qed.
Lemma length_nonneg n : 0 <= length n.
Proof. apply sqrt_pos. Qed.

Lemma abs_at_most x r : Rabs x <= r -> - r <= x <= r.
Proof. unfold Rabs; destruct Rcase_abs; lra. Qed.

(** |n . (x - c)| <= |n| r *)
Lemma reach_of_ball n c r x : 0 <= r -> in_ball c r x -> Rabs (dot n x - dot n c) <= r * length n.
Proof.
  intros Hr Hx; unfold in_ball in Hx.
  set (w := fun i => x i - c i).
  assert (E : dot n x - dot n c = dot n w) by (unfold dot, w; ring); rewrite E.
  assert (W : dot w w <= r * r) by (unfold squared_distance, sum_over_axes, dot, w in *; lra).
  apply Rsqr_incr_0_var; [|apply Rmult_le_pos; [exact Hr|apply length_nonneg]].
  rewrite <- Rsqr_abs; unfold Rsqr.
  replace (r * length n * (r * length n)) with (r * r * (length n * length n)) by ring; rewrite length_squared.
  apply Rle_trans with (dot w w * dot n n); [|apply Rmult_le_compat_r; [apply dot_self|exact W]].
  unfold dot; set (p := n X); set (q := n Y); set (t := n Z); set (a := w X); set (b := w Y); set (d := w Z).
  assert (0 <= (p * b - q * a) ^ 2) by apply pow2_ge_0; assert (0 <= (p * d - t * a) ^ 2) by apply pow2_ge_0.
  assert (0 <= (q * d - t * b) ^ 2) by apply pow2_ge_0; lra.
Qed.

(** The points of the ball that reach farthest, and least far. *)
Lemma ball_reaches n c r (s : R) : 0 <= r -> (s = 1 \/ s = -1) ->
  exists x, in_ball c r x /\ dot n x = dot n c + s * (r * length n).
Proof.
  intros Hr Hs; pose proof (length_squared n) as L; pose proof (length_nonneg n) as L0.
  destruct (Req_dec (length n) 0) as [Z0|Z0].
  - exists c; split.
    + unfold in_ball, squared_distance, sum_over_axes; nra.
    + rewrite Z0; ring.
  - exists (fun i => c i + s * r / length n * n i).
    assert (K : s * s = 1) by (destruct Hs as [-> | ->]; ring).
    set (k := s * r / length n); assert (D : k * dot n n = s * (r * length n)) by (rewrite <- L; unfold k; field; exact Z0).
    assert (D2 : k * k * dot n n = r * r).
    { rewrite <- L; unfold k; replace (s * r / length n * (s * r / length n) * (length n * length n)) with
        (s * s * (r * r)) by (field; exact Z0); rewrite K; ring. }
    split.
    + unfold in_ball, squared_distance, sum_over_axes; right.
      replace (r ^ 2) with (k * k * dot n n) by (rewrite D2; ring); unfold dot; ring.
    + rewrite <- D; unfold dot; ring.
Qed.

Theorem ball_beyond_exactly_when n d c r : 0 <= r ->
  ((forall x, in_ball c r x -> dot n x > d) <-> dot n c - d > r * length n).
Proof.
  intro Hr; split; intro H.
  - destruct (ball_reaches n c r (-1) Hr) as [x [I E]]; [right; reflexivity|]; specialize (H x I); lra.
  - intros x I; pose proof (reach_of_ball n c r x Hr I) as K; apply abs_at_most in K; lra.
Qed.
Theorem ball_behind_exactly_when n d c r : 0 <= r ->
  ((forall x, in_ball c r x -> dot n x <= d) <-> dot n c - d <= - (r * length n)).
Proof.
  intro Hr; split; intro H.
  - destruct (ball_reaches n c r 1 Hr) as [x [I E]]; [left; reflexivity|]; specialize (H x I); lra.
  - intros x I; pose proof (reach_of_ball n c r x Hr I) as K; apply abs_at_most in K; lra.
Qed.

(** ** Claim S7: normals of length 1, T the paper's value *)
Theorem inside_plane_exactly_when n d c r : 0 <= r -> length n = 1 ->
  ((forall x, in_ball c r x -> dot n x <= d) <-> dot n c - d <= - r).
Proof. intros Hr L; rewrite (ball_behind_exactly_when n d c r Hr), L, Rmult_1_r; tauto. Qed.

(** "If T > -Sphere.radius, then the sphere is fully inside the plane": neither implies the other. *)
Theorem printed_inside_test_is_wrong :
  (exists n d c r, 0 < r /\ length n = 1 /\ dot n c - d > - r /\ ~ forall x, in_ball c r x -> dot n x <= d) /\
  (exists n d c r, 0 < r /\ length n = 1 /\ ~ dot n c - d > - r /\ forall x, in_ball c r x -> dot n x <= d).
Proof.
  set (n := fun i => match i with X => 1 | _ => 0 end).
  assert (L : length n = 1).
  { unfold length; replace (dot n n) with 1 by (unfold dot, n; ring); apply sqrt_1. }
  assert (V : forall v, dot n (fun _ => v) = v) by (intro; unfold dot, n; ring).
  split; [exists n, 0, (fun _ => 0), 1|exists n, 0, (fun _ => -2), 1]; rewrite V; repeat split; auto; try lra.
  - intro H; apply inside_plane_exactly_when in H; auto; [rewrite V in H|]; lra.
  - apply inside_plane_exactly_when; auto; [|rewrite V]; lra.
Qed.

(** ** Claim S8: one value is compared with 0 twice, the second time plus the diameter *)
Theorem inside_is_outside_plus_diameter n d c r : 0 <= r -> length n = 1 ->
  let value := dot n c - d - r in
  ((forall x, in_ball c r x -> dot n x > d) <-> value > 0) /\
  ((forall x, in_ball c r x -> dot n x <= d) <-> value + 2 * r <= 0).
Proof.
  intros Hr L value; unfold value.
  rewrite (ball_beyond_exactly_when n d c r Hr), (inside_plane_exactly_when n d c r Hr L), L, Rmult_1_r.
  split; split; lra.
Qed.

(** ** The test of the paper: Arvo's distance to the extent box, then the planes *)
Definition squared_distance_to_extent (A B : box) (c : point) : R :=
  sum_over_axes (fun i => distance_to_interval (c i) (Rmin (lo A i) (lo B i)) (Rmax (hi A i) (hi B i)) ^ 2).
Definition sphere_test_says_outside (A B : box) (c : point) (r : R) : Prop :=
  squared_distance_to_extent A B c > r ^ 2 \/
  exists f g, fst f <> fst g /\ extreme A B f /\ extreme B A g /\
    let p := edge_plane A B f g in dot (normal p) c - offset p > r * length (normal p).

Theorem sphere_test_culls_nothing_that_meets A B c r : valid A -> valid B -> 0 <= r ->
  sphere_test_says_outside A B c r -> ~ exists x, hull A B x /\ in_ball c r x.
Proof.
  intros wA wB Hr H [x [Hx I]]; destruct H as [H|[f [g [N [Ef [Eg H]]]]]].
  - pose proof (shaft_within_extent A B x wA wB Hx) as E; unfold in_ball in I.
    assert (squared_distance_to_extent A B c <= squared_distance x c); [|lra].
    apply sum3_le; intro i; apply dist1_le; apply E.
  - pose proof (hull_within_plane A B f g x wA wB N Ef Eg Hx).
    pose proof (proj2 (ball_beyond_exactly_when _ _ c r Hr) H x I); lra.
Qed.

(** A segment from (0,0,0) to (1,1,0), and a ball near (1,1,0), in the angle between the extent box and a plane. *)
Theorem sphere_test_has_false_positives :
  exists A B c r, valid A /\ valid B /\ 0 <= r /\
    ~ sphere_test_says_outside A B c r /\ ~ exists x, hull A B x /\ in_ball c r x.
Proof.
  set (A := Box (fun _ => 0) (fun _ => 0)).
  set (B := Box (fun k => match k with Z => 0 | _ => 1 end) (fun k => match k with Z => 0 | _ => 1 end)).
  set (c := fun k => match k with X => 1.5 | Y => 0.75 | Z => 0 end).
  assert (wA : valid A) by (intro; simpl; lra); assert (wB : valid B) by (intros []; simpl; lra).
  exists A, B, c, 0.55; split; [exact wA|split; [exact wB|split; [lra|split]]].
  - intros [H|[f [g [N [Ef [Eg H]]]]]].
    + apply Rgt_not_le in H; apply H; clear H.
      unfold squared_distance_to_extent, sum_over_axes, distance_to_interval, c, A, B; simpl.
      rewrite !(Rmin_left 0 1), !(Rmax_right 0 1), !(Rmin_left 0 0), !(Rmax_left 0 0) by lra.
      assert (D : forall a b v, 0 <= v -> a <= v -> b <= v -> 0 <= Rmax 0 (Rmax a b) <= v)
        by (intros; split; [apply Rmax_l|repeat apply Rmax_lub; lra]).
      pose proof (D (0 - 1.5) (1.5 - 1) 0.5 ltac:(lra) ltac:(lra) ltac:(lra)) as D0.
      pose proof (D (0 - 0.75) (0.75 - 1) 0 ltac:(lra) ltac:(lra) ltac:(lra)) as D1.
      pose proof (D (0 - 0) (0 - 0) 0 ltac:(lra) ltac:(lra) ltac:(lra)) as D2.
      set (p := Rmax 0 (Rmax (0 - 1.5) (1.5 - 1))) in *; set (q := Rmax 0 (Rmax (0 - 0.75) (0.75 - 1))) in *.
      set (t := Rmax 0 (Rmax (0 - 0) (0 - 0))) in *; nra.
    + set (p := edge_plane A B f g) in *.
      assert (L : length (normal p) * length (normal p) = 2 /\ dot (normal p) c - offset p <= 0.75).
      { rewrite length_squared; unfold p, extreme in *; destruct f as [[] []], g as [[] []];
        cbv [dot edge_plane normal offset sgn coord axis_eqb fst snd A B c lo hi] in *; try congruence; lra. }
      destruct L as [L V]; pose proof (length_nonneg (normal p)); cbv zeta in H; nra.
  - intros [x [Hx I]]; apply hull_is_union_of_boxes in Hx; auto; destruct Hx as [s [Hs H]].
    pose proof (H X) as HX; pose proof (H Y) as HY; pose proof (H Z) as HZ.
    unfold lerp, A, B in *; simpl in *; unfold in_ball, squared_distance, sum_over_axes, c in I.
    assert (x X = s) by lra; assert (x Y = s) by lra; assert (x Z = 0) by lra.
    replace (x X) with s in I by lra; replace (x Y) with s in I by lra; replace (x Z) with 0 in I by lra.
    assert (0 <= (1 - s) * (2.5 + 2 * (1 - s))) by nra; nra.
Qed.

(** ** Inside *)
Theorem ball_inside_test_is_exact A B c r : valid A -> valid B -> 0 <= r ->
  ((forall x, in_ball c r x -> hull A B x) <->
   (forall i, c i - Rmin (lo A i) (lo B i) >= r /\ Rmax (hi A i) (hi B i) - c i >= r) /\
   (forall f g, fst f <> fst g -> extreme A B f -> extreme B A g ->
      let p := edge_plane A B f g in dot (normal p) c - offset p <= - (r * length (normal p)))).
Proof.
  intros wA wB Hr; split.
  - intro H; split.
    + intro i.
      assert (K : forall s, s = 1 \/ s = -1 -> exists x, in_ball c r x /\ x i = c i + s * r).
      { intros s Hs; exists (fun k => if axis_eqb k i then c k + s * r else c k); split.
        - unfold in_ball, squared_distance, sum_over_axes; destruct i, Hs as [-> | ->]; simpl; lra.
        - destruct i; reflexivity. }
      destruct (K (-1)) as [x [I E]]; auto; destruct (K 1) as [y [J E']]; auto.
      pose proof (shaft_within_extent A B x wA wB (H x I) i); pose proof (shaft_within_extent A B y wA wB (H y J) i); lra.
    + intros f g N Ef Eg p; apply ball_behind_exactly_when; auto.
      intros x I; apply hull_within_plane; auto.
  - intros [E P] x I; apply shaft_is_extent_and_planes; auto; split.
    + intro i; specialize (E i).
      assert (K : Rabs (x i - c i) <= r).
      { apply Rsqr_incr_0_var; [|exact Hr]; rewrite <- Rsqr_abs; unfold Rsqr.
        unfold in_ball, squared_distance, sum_over_axes in I.
        assert (0 <= (x X - c X) ^ 2) by apply pow2_ge_0; assert (0 <= (x Y - c Y) ^ 2) by apply pow2_ge_0.
        assert (0 <= (x Z - c Z) ^ 2) by apply pow2_ge_0; destruct i; lra. }
      apply abs_at_most in K; lra.
    + intros f g N Ef Eg; pose proof (P f g N Ef Eg) as Q; cbv zeta in Q.
      apply (proj2 (ball_behind_exactly_when _ _ c r Hr) Q x I).
Qed.

(** The same comparison without the square root, as slab_ball.cpp writes it. *)
Lemma behind_without_root v r n : 0 <= r ->
  (v <= - (r * length n) <-> v <= 0 /\ v * v >= r * r * dot n n).
Proof.
  intro Hr; rewrite <- length_squared; pose proof (length_nonneg n) as L.
  assert (P : 0 <= r * length n) by (apply Rmult_le_pos; assumption).
  replace (r * r * (length n * length n)) with ((r * length n) * (r * length n)) by ring; set (w := r * length n) in *.
  split; [intro; split; nra|intros [? ?]; nra].
Qed.
