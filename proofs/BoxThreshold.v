(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * The threshold of a plane for boxes, computed in floating point

    set_box_threshold computes sum = |n0| (x + |a0|) + |n1| (y + |a1|) and threshold = 5 u sum + 512 two_eta,
    every operation rounded. [box_threshold_is_enough]: that number is at least the error bound of
    PlaneError.v, 4.000002 u S + 5 eta: what 5 is larger than 4.000002 pays for all these roundings. *)
Require Import Reals Lra Psatz ZArith.
Require Import Flocq.Core.Core.
Require Import Gnomon.RoundingModel Gnomon.PlaneError.
Open Scope R_scope.

Section BoxThreshold.
Context {F : Format}.

(** CertifiedConstants::box_plane, and the multiple of two_eta that set_box_threshold adds. *)
Definition box_plane : R := 5.
Definition box_underflow : R := 512.

(** As the code computes; x and y are the largest magnitudes of coordinates in the extent box. *)
Definition box_sum (n0 n1 a0 a1 x y : R) : R :=
  fl (fl (Rabs n0 * fl (x + Rabs a0)) + fl (Rabs n1 * fl (y + Rabs a1))).
Definition box_threshold (n0 n1 a0 a1 x y : R) : R :=
  fl (fl (box_plane * u * box_sum n0 n1 a0 a1 x y) + box_underflow * (2 * eta)).

Lemma box_underflow_is_float : is_float (box_underflow * (2 * eta)).
Proof.
  replace (box_underflow * (2 * eta)) with (bpow radix2 (emin + 9)); [apply is_float_bpow; lia|].
  unfold box_underflow, eta; replace (emin + 9)%Z with (10 + (emin - 1))%Z by lia.
  rewrite bpow_plus; change (bpow radix2 10) with 1024; lra.
Qed.

(** One term of the sum loses at most three roundings and one underflow. *)
Lemma term_at_least N e v a : Rabs e <= u -> 0 <= v -> is_float v -> is_float a ->
  let n := N * (1 + e) in
  Rabs N * (v + Rabs a) * (1 - 0.0000002) - eta <= fl (Rabs n * fl (v + Rabs a)).
Proof.
  intros He Hv Fv Fa n.
  pose proof u_positive as U0; pose proof u_small as U.
  assert (B0 : 0 <= v + Rabs a) by (pose proof (Rabs_pos a); lra).
  destruct (fl_plus_bounds v (Rabs a) Fv (is_float_abs _ Fa) B0) as [L _].
  assert (K : Rabs N * (1 - u) <= Rabs n).
  { unfold n; rewrite Rabs_mult; apply Rmult_le_compat_l; [apply Rabs_pos|].
    apply Rabs_le_inv in He; rewrite Rabs_pos_eq; lra. }
  assert (M : Rabs N * (1 - u) * ((v + Rabs a) * (1 - u)) <= Rabs n * fl (v + Rabs a)).
  { apply Rmult_le_compat; auto; apply Rmult_le_pos; auto using Rabs_pos; lra. }
  assert (P : 0 <= Rabs n * fl (v + Rabs a)) by (apply Rmult_le_pos; [apply Rabs_pos|apply fl_nonneg; auto]).
  destruct (fl_any_bounds _ P) as [Q _].
  set (w := Rabs n * fl (v + Rabs a)) in *.
  assert (R : Rabs N * (v + Rabs a) * ((1 - u) * (1 - u)) <= w) by lra.
  assert (Z : 0 <= Rabs N * (v + Rabs a)) by (apply Rmult_le_pos; auto using Rabs_pos).
  set (z := Rabs N * (v + Rabs a)) in *.
  assert ((1 - u) * (1 - u) >= 1 - 2 * u) by nra.
  assert (R2 : z * (1 - 2 * u) <= w) by nra.
  assert (R3 : z * (1 - 2 * / 16777216) <= w) by nra.
  assert (R4 : w * (1 - / 16777216) <= w * (1 - u)) by nra.
  nra.
Qed.

Theorem box_threshold_is_enough N0 N1 e0 e1 a0 a1 x y px py :
  Rabs e0 <= u -> Rabs e1 <= u -> is_float a0 -> is_float a1 -> is_float x -> is_float y ->
  Rabs px <= x -> Rabs py <= y ->
  4.000002 * u * magnitude_sum N0 N1 a0 a1 px py + 5 * eta
    <= box_threshold (N0 * (1 + e0)) (N1 * (1 + e1)) a0 a1 x y.
Proof.
  intros H0 H1 Fa0 Fa1 Fx Fy Px Py.
  pose proof u_positive as U0; pose proof u_small as U; pose proof eta_positive as T0.
  assert (x0 : 0 <= x) by (pose proof (Rabs_pos px); lra).
  assert (y0 : 0 <= y) by (pose proof (Rabs_pos py); lra).
  set (n0 := N0 * (1 + e0)); set (n1 := N1 * (1 + e1)).
  set (s := Rabs N0 * (x + Rabs a0) + Rabs N1 * (y + Rabs a1)).
  assert (S0 : 0 <= magnitude_sum N0 N1 a0 a1 px py <= s).
  { unfold magnitude_sum, s; split.
    - apply Rplus_le_le_0_compat; apply Rmult_le_pos; auto using Rabs_pos; apply Rplus_le_le_0_compat; apply Rabs_pos.
    - apply Rplus_le_compat; apply Rmult_le_compat_l; auto using Rabs_pos; lra. }
  assert (T : box_sum n0 n1 a0 a1 x y >= s * (1 - 0.0000004) - 3 * eta).
  { pose proof (term_at_least N0 e0 x a0 H0 x0 Fx Fa0) as L0; cbv zeta in L0; fold n0 in L0.
    pose proof (term_at_least N1 e1 y a1 H1 y0 Fy Fa1) as L1; cbv zeta in L1; fold n1 in L1.
    unfold box_sum.
    assert (G : forall n v a, 0 <= v -> 0 <= fl (Rabs n * fl (v + Rabs a))).
    { intros; apply fl_nonneg, Rmult_le_pos; [apply Rabs_pos|apply fl_nonneg].
      pose proof (Rabs_pos a); lra. }
    pose proof (G n0 x a0 x0) as G0; pose proof (G n1 y a1 y0) as G1.
    set (w0 := fl (Rabs n0 * _)) in *; set (w1 := fl (Rabs n1 * _)) in *.
    assert (W : 0 <= w0 + w1) by lra.
    destruct (fl_plus_bounds w0 w1 (fl_is_float _) (fl_is_float _) W) as [L _].
    assert ((w0 + w1) * (1 - / 16777216) <= (w0 + w1) * (1 - u)) by (apply Rmult_le_compat_l; lra).
    assert (s * (1 - 0.0000002) - 2 * eta <= w0 + w1) by (unfold s; lra).
    lra. }
  assert (B0 : 0 <= box_sum n0 n1 a0 a1 x y).
  { unfold box_sum; apply fl_nonneg, Rplus_le_le_0_compat; apply fl_nonneg, Rmult_le_pos; try apply Rabs_pos;
    apply fl_nonneg; [pose proof (Rabs_pos a0)|pose proof (Rabs_pos a1)]; lra. }
  unfold box_threshold, box_plane; set (B := box_sum n0 n1 a0 a1 x y) in *.
  assert (C0 : 0 <= 5 * u * B) by (apply Rmult_le_pos; lra).
  destruct (fl_any_bounds _ C0) as [C _].
  pose proof (fl_nonneg _ C0) as C1.
  pose proof box_underflow_is_float as FU.
  destruct (fl_plus_bounds (fl (5 * u * B)) (box_underflow * (2 * eta)) (fl_is_float _) FU) as [D _];
    [unfold box_underflow; lra|].
  eapply Rle_trans; [|exact D]; unfold box_underflow.
  set (w := fl (5 * u * B)) in *.
  assert (us : 0 <= u * s) by (apply Rmult_le_pos; lra).
  assert (uB : u * s * (1 - 0.0000004) - u * (3 * eta) <= u * B).
  { replace (u * s * (1 - 0.0000004) - u * (3 * eta)) with (u * (s * (1 - 0.0000004) - 3 * eta)) by ring.
    apply Rmult_le_compat_l; lra. }
  assert (E0 : 0 <= 3 * eta) by lra; pose proof (u_times_small _ E0).
  assert (5 * (u * B) * (1 - / 16777216) <= 5 * u * B * (1 - u)).
  { replace (5 * (u * B)) with (5 * u * B) by ring; apply Rmult_le_compat_l; lra. }
  assert ((w + 512 * (2 * eta)) * (1 - / 16777216) <= (w + 512 * (2 * eta)) * (1 - u))
    by (apply Rmult_le_compat_l; lra).
  assert (u * magnitude_sum N0 N1 a0 a1 px py <= u * s) by (apply Rmult_le_compat_l; lra).
  lra.
Qed.
End BoxThreshold.
