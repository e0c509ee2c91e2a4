(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * A ball meets the shaft: the least distance over s

    The squared distance from c to the box (1-s)A + sB, as a function of s, is convex and continuous; the ball of
    radius r around c meets the shaft exactly when the minimum over 0 <= s <= 1 is at most r^2. *)
Require Import Reals Lra Psatz List Bool Arith Lia.
Require Import Gnomon.Boxes.
Open Scope R_scope.

Definition distance_to_interval (c l h : R) : R := Rmax 0 (Rmax (l - c) (c - h)).
Definition sum_over_axes (v : axis -> R) : R := v X + v Y + v Z.
Definition squared_distance (x c : point) : R := sum_over_axes (fun i => (x i - c i) ^ 2).
Definition squared_distance_at (A B : box) (c : point) (s : R) : R :=
  sum_over_axes (fun i => distance_to_interval (c i) (lerp s (lo A i) (lo B i)) (lerp s (hi A i) (hi B i)) ^ 2).

Lemma sum3_le u v : (forall i, u i <= v i) -> sum_over_axes u <= sum_over_axes v.
Proof. intro H; unfold sum_over_axes; generalize (H X), (H Y), (H Z); lra. Qed.

Lemma dist1_le c l h x : l <= x <= h -> distance_to_interval c l h ^ 2 <= (x - c) ^ 2.
Proof.
  intro H; rewrite <- (pow2_abs (x - c)); apply pow_incr; split; [apply Rmax_l|].
  unfold distance_to_interval; pose proof (Rle_abs (x - c)); pose proof (Rle_abs (- (x - c))) as K.
  rewrite Rabs_Ropp in K; repeat apply Rmax_lub; lra.
Qed.
Lemma dist1_ex c l h : l <= h -> exists x, l <= x <= h /\ (x - c) ^ 2 = distance_to_interval c l h ^ 2.
Proof.
  intro H; destruct (Rle_lt_dec c l); [exists l|destruct (Rle_lt_dec h c); [exists h|exists c]];
  (split; [lra|]); unfold distance_to_interval, Rmax; repeat destruct Rle_dec; nra.
Qed.

Theorem ball_meets_iff_some_s A B c r2 : valid A -> valid B ->
  ((exists x, hull A B x /\ squared_distance x c <= r2) <-> exists s, 0 <= s <= 1 /\ squared_distance_at A B c s <= r2).
Proof.
  intros wA wB; split.
  - intros [x [Hx D]]; apply hull_is_union_of_boxes in Hx; auto; destruct Hx as [s [Hs H]].
    exists s; split; [exact Hs|]; eapply Rle_trans; [|exact D].
    apply sum3_le; intro i; apply dist1_le; apply H.
  - intros [s [Hs D]].
    destruct (finite_choice (fun i x =>
      lerp s (lo A i) (lo B i) <= x <= lerp s (hi A i) (hi B i) /\
      (x - c i) ^ 2 = distance_to_interval (c i) (lerp s (lo A i) (lo B i)) (lerp s (hi A i) (hi B i)) ^ 2)) as [x Hx].
    { intro i; apply dist1_ex; specialize (wA i); specialize (wB i); unfold lerp; nra. }
    exists x; split.
    + apply hull_is_union_of_boxes; auto; exists s; split; [exact Hs|]; intro i; apply Hx.
    + eapply Rle_trans; [|exact D]; apply sum3_le; intro i; right; apply Hx.
Qed.

(** f is convex on R, so it can be minimised by bisection or piece by piece *)
Lemma dist1_convex c l h l' h' w : 0 <= w <= 1 ->
  distance_to_interval c (lerp w l l') (lerp w h h') <= lerp w (distance_to_interval c l h) (distance_to_interval c l' h').
Proof.
  intro W; unfold distance_to_interval at 1; unfold lerp.
  assert (K : forall c l h, 0 <= distance_to_interval c l h /\ l - c <= distance_to_interval c l h /\ c - h <= distance_to_interval c l h).
  { intros; unfold distance_to_interval, Rmax; repeat destruct Rle_dec; lra. }
  destruct (K c l h) as [? [? ?]], (K c l' h') as [? [? ?]].
  repeat apply Rmax_lub; nra.
Qed.
Theorem squared_distance_convex A B c s t w : 0 <= w <= 1 ->
  squared_distance_at A B c (lerp w s t) <= lerp w (squared_distance_at A B c s) (squared_distance_at A B c t).
Proof.
  intro W; unfold squared_distance_at.
  apply Rle_trans with (sum_over_axes (fun i =>
    lerp w (distance_to_interval (c i) (lerp s (lo A i) (lo B i)) (lerp s (hi A i) (hi B i)) ^ 2)
           (distance_to_interval (c i) (lerp t (lo A i) (lo B i)) (lerp t (hi A i) (hi B i)) ^ 2))).
  2: right; unfold sum_over_axes, lerp; ring.
  apply sum3_le; intro i.
  replace (lerp (lerp w s t) (lo A i) (lo B i)) with
    (lerp w (lerp s (lo A i) (lo B i)) (lerp t (lo A i) (lo B i))) by (unfold lerp; ring).
  replace (lerp (lerp w s t) (hi A i) (hi B i)) with
    (lerp w (lerp s (hi A i) (hi B i)) (lerp t (hi A i) (hi B i))) by (unfold lerp; ring).
  set (l := lerp s _ _); set (l' := lerp t (lo A i) _); set (h := lerp s (hi A i) _); set (h' := lerp t _ _).
  pose proof (dist1_convex (c i) l h l' h' w W) as K; unfold lerp in *.
  set (p := distance_to_interval (c i) l h) in *; set (q := distance_to_interval (c i) l' h') in *.
  assert (0 <= distance_to_interval (c i) ((1 - w) * l + w * l') ((1 - w) * h + w * h')) by apply Rmax_l.
  set (z := distance_to_interval _ _ _) in *.
  apply Rle_trans with (((1 - w) * p + w * q) ^ 2); [nra|].
  assert (0 <= w * (1 - w) * (p - q) ^ 2) by (apply Rmult_le_pos; [nra|apply pow2_ge_0]).
  nra.
Qed.

(** the literal minimum form *)
Lemma Rmax_abs x y : Rmax x y = (x + y + Rabs (x - y)) / 2.
Proof. unfold Rmax, Rabs; destruct Rle_dec, Rcase_abs; lra. Qed.
Lemma squared_distance_continuous A B c s : continuity_pt (squared_distance_at A B c) s.
Proof.
  assert (M : forall f g, continuity f -> continuity g -> continuity (fun s => Rmax (f s) (g s))).
  { intros f g cf cg x.
    apply continuity_pt_locally_ext with (f := fun s => (f s + g s + Rabs (f s - g s)) * / 2) (a := 1); [lra| |].
    - intros; symmetry; apply Rmax_abs.
    - apply (continuity_mult (fun s => f s + g s + Rabs (f s - g s)) (fun _ => / 2));
      [|apply continuity_const; intros ? ?; reflexivity].
      apply (continuity_plus (fun s => f s + g s) (fun s => Rabs (f s - g s))).
      + apply (continuity_plus f g); auto.
      + apply (continuity_comp (fun s => f s - g s) Rabs); [apply (continuity_minus f g); auto|apply Rcontinuity_abs]. }
  revert s; change (continuity (squared_distance_at A B c)).
  assert (L : forall a b, continuity (fun s => lerp s a b)) by (intros; unfold lerp; reg).
  assert (K : forall a, continuity (fun _ => a)) by (intros; apply continuity_const; intros ? ?; reflexivity).
  assert (D : forall i, continuity (fun s => distance_to_interval (c i) (lerp s (lo A i) (lo B i)) (lerp s (hi A i) (hi B i)) ^ 2)).
  { intro i.
    assert (E : continuity (fun s => distance_to_interval (c i) (lerp s (lo A i) (lo B i)) (lerp s (hi A i) (hi B i)))).
    { unfold distance_to_interval; apply M; [apply K|apply M].
      - apply (continuity_minus (fun s => lerp s _ _) (fun _ => c i)); auto.
      - apply (continuity_minus (fun _ => c i) (fun s => lerp s _ _)); auto. }
    refine (continuity_comp _ (fun x => x ^ 2) E _).
    apply derivable_continuous, derivable_pow. }
  unfold squared_distance_at, sum_over_axes.
  exact (continuity_plus _ _ (continuity_plus _ _ (D X) (D Y)) (D Z)).
Qed.
Theorem ball_test_is_a_minimum A B c r2 : valid A -> valid B ->
  exists m, 0 <= m <= 1 /\ (forall s, 0 <= s <= 1 -> squared_distance_at A B c m <= squared_distance_at A B c s) /\
  ((exists x, hull A B x /\ squared_distance x c <= r2) <-> squared_distance_at A B c m <= r2).
Proof.
  intros wA wB.
  destruct (continuity_ab_min (squared_distance_at A B c) 0 1) as [m [H Hm]]; [lra|intros; apply squared_distance_continuous|].
  exists m; split; [exact Hm|split; [exact H|]].
  rewrite ball_meets_iff_some_s by auto; split.
  - intros [s [Hs K]]; eapply Rle_trans; [apply H; exact Hs|exact K].
  - intro K; exists m; auto.
Qed.
