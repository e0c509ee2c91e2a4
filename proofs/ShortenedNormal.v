(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * Normals for balls: shortened to at most 1 - 5 u

    shorten() divides the normal by its computed length and multiplies it by 1 - 9 u, all rounded; it first scales
    by a power of two where squares could overflow or vanish. [shorten_is_short]: whatever the roundings do, the
    result is no longer than 1 - 5 u, and it is the true normal times one common factor, but for two roundings a
    component and underflow; with that common factor the true normal is no longer than 1 - 4 u. *)
Require Import Reals Lra Psatz ZArith Lia.
Require Import Flocq.Core.Core.
Require Import Gnomon.RoundingModel.
Open Scope R_scope.

Section Shorten.
Context {F : Format}.

(** CertifiedConstants::ball_shortening, and the 4 u "that the scaling itself may be wrong by". *)
Definition ball_shortening : R := 5.
Definition scaling_error : R := 4.

(** As the code computes, after the scaling by a power of two. *)
Definition code_length (n0 n1 : R) : R := fl (sqrt (fl (fl (n0 * n0) + fl (n1 * n1)))).
Definition code_scale (n0 n1 : R) : R := fl ((1 - (ball_shortening + scaling_error) * u) / code_length n0 n1).
Definition code_m (n0 n1 n : R) : R := fl (n * code_scale n0 n1).

(** Scaling by a power of two k: exact but for underflow; and where it can underflow, the larger component is at
    least 1 afterwards. The larger component is within the safe range either way. *)
Definition scaled_safely (k n0 n1 n0' n1' : R) : Prop :=
  0 < k /\
  (exists t0 t1, Rabs t0 <= eta /\ Rabs t1 <= eta /\ n0' = k * n0 + t0 /\ n1' = k * n1 + t1 /\
     ((t0 = 0 /\ t1 = 0) \/ 1 <= Rmax (Rabs n0') (Rabs n1'))) /\
  bpow radix2 (- safe_exponent) <= Rmax (Rabs n0') (Rabs n1') <= bpow radix2 safe_exponent.

Lemma cauchy a b c d L r : 0 <= L -> 0 <= r -> a * a + b * b <= L * L -> c * c + d * d <= r * r ->
  Rabs a * Rabs c + Rabs b * Rabs d <= L * r.
Proof.
  intros HL Hr H1 H2.
  assert (E : forall z, Rabs z * Rabs z = z * z) by (intro z; rewrite <- Rabs_mult; apply Rabs_pos_eq; nra).
  rewrite <- (E a), <- (E b) in H1; rewrite <- (E c), <- (E d) in H2.
  pose proof (Rabs_pos a); pose proof (Rabs_pos b); pose proof (Rabs_pos c); pose proof (Rabs_pos d).
  set (p := Rabs a) in *; set (q := Rabs b) in *; set (v := Rabs c) in *; set (w := Rabs d) in *.
  apply Rsqr_incr_0_var; [|apply Rmult_le_pos; auto]; unfold Rsqr.
  apply Rle_trans with ((p * p + q * q) * (v * v + w * w)).
  - assert (0 <= (p * w - q * v) * (p * w - q * v)) by apply Rle_0_sqr; lra.
  - replace (L * r * (L * r)) with ((L * L) * (r * r)) by ring.
    apply Rmult_le_compat; auto; apply Rplus_le_le_0_compat; apply Rmult_le_pos; auto.
Qed.

(** eta against the safe range: squares of safe numbers dwarf it. *)
Lemma eta_tiny : eta <= u * u * / 512 * (bpow radix2 (- safe_exponent) * bpow radix2 (- safe_exponent)).
Proof.
  unfold eta, u; replace (/ 512) with (bpow radix2 (-9)) by reflexivity; rewrite <- !bpow_plus.
  apply bpow_le; generalize squares_are_safe; lia.
Qed.

Section Lengths.
Variables n0 n1 : R.
Hypothesis safe : bpow radix2 (- safe_exponent) <= Rmax (Rabs n0) (Rabs n1) <= bpow radix2 safe_exponent.
Let L := sqrt (n0 * n0 + n1 * n1).

Lemma L_square : L * L = n0 * n0 + n1 * n1.
Proof. unfold L; apply sqrt_sqrt; nra. Qed.
Lemma L_at_least : Rmax (Rabs n0) (Rabs n1) <= L.
Proof.
  unfold L; apply Rmax_lub; rewrite <- sqrt_Rsqr_abs; apply sqrt_le_1_alt; unfold Rsqr; nra.
Qed.
Lemma L_at_most : L <= 2 * bpow radix2 safe_exponent.
Proof.
  pose proof (Rmax_l (Rabs n0) (Rabs n1)); pose proof (Rmax_r (Rabs n0) (Rabs n1)).
  set (s := bpow radix2 safe_exponent) in *; assert (0 < s) by apply bpow_gt_0.
  assert (E : forall z, Rabs z <= s -> z * z <= s * s).
  { intros z Hz; rewrite <- (Rabs_pos_eq (z * z)) by nra; rewrite Rabs_mult.
    apply Rmult_le_compat; auto using Rabs_pos. }
  assert (n0 * n0 <= s * s) by (apply E; lra); assert (n1 * n1 <= s * s) by (apply E; lra).
  unfold L; rewrite <- (sqrt_Rsqr (2 * s)) by lra; apply sqrt_le_1_alt; unfold Rsqr; nra.
Qed.
Lemma L_positive : 0 < L.
Proof. pose proof L_at_least; pose proof (bpow_gt_0 radix2 (- safe_exponent)); lra. Qed.

Lemma eta_below_square : eta <= u * u * / 512 * (L * L).
Proof.
  eapply Rle_trans; [apply eta_tiny|]; pose proof u_positive; pose proof L_at_least.
  pose proof (bpow_gt_0 radix2 (- safe_exponent)).
  apply Rmult_le_compat_l; [nra|]; apply Rmult_le_compat; lra.
Qed.
Lemma safe_below_1 : bpow radix2 (- safe_exponent) <= / 2.
Proof.
  replace (/ 2) with (bpow radix2 (-1)) by reflexivity; apply bpow_le; generalize safe_exponent_positive; lia.
Qed.
Lemma eta_below_L : eta <= u * u * / 512 * L.
Proof.
  eapply Rle_trans; [apply eta_tiny|]; pose proof u_positive; pose proof L_at_least; pose proof safe_below_1.
  pose proof (bpow_gt_0 radix2 (- safe_exponent)).
  apply Rmult_le_compat_l; [nra|]; nra.
Qed.
Lemma eta_times_L : eta * L <= u * u * / 512.
Proof.
  pose proof eta_tiny as T; pose proof L_at_most as M; pose proof safe_below_1; pose proof u_positive.
  pose proof L_positive; pose proof eta_positive; pose proof (bpow_gt_0 radix2 (- safe_exponent)).
  assert (I : bpow radix2 (- safe_exponent) * bpow radix2 safe_exponent = 1)
    by (rewrite <- bpow_plus; replace (- safe_exponent + safe_exponent)%Z with 0%Z by lia; reflexivity).
  set (h := bpow radix2 (- safe_exponent)) in *; set (s := bpow radix2 safe_exponent) in *.
  apply Rle_trans with (u * u * / 512 * (h * h) * (2 * s)).
  - apply Rmult_le_compat; lra.
  - replace (u * u * / 512 * (h * h) * (2 * s)) with (u * u * / 512 * (2 * h * (h * s))) by ring.
    rewrite I; assert (0 <= u * u * / 512) by nra; nra.
Qed.
Lemma eta_below_u : eta <= u * u * / 512.
Proof.
  eapply Rle_trans; [apply eta_tiny|]; pose proof u_positive; pose proof safe_below_1.
  pose proof (bpow_gt_0 radix2 (- safe_exponent)).
  rewrite <- (Rmult_1_r (u * u * / 512)) at 2; apply Rmult_le_compat_l; nra.
Qed.

Lemma code_length_at_least : L * (1 - 2 * u) <= code_length n0 n1.
Proof.
  pose proof u_positive as U0; pose proof u_small as U; pose proof eta_positive as T0; pose proof L_positive as L0.
  assert (Q0 : 0 <= n0 * n0) by nra; assert (Q1 : 0 <= n1 * n1) by nra.
  destruct (fl_any_bounds _ Q0) as [A0 _], (fl_any_bounds _ Q1) as [A1 _].
  pose proof (fl_nonneg _ Q0) as P0; pose proof (fl_nonneg _ Q1) as P1.
  set (q0 := fl (n0 * n0)) in *; set (q1 := fl (n1 * n1)) in *.
  assert (P : 0 <= q0 + q1) by lra.
  destruct (fl_plus_bounds q0 q1 (fl_is_float _) (fl_is_float _) P) as [S _].
  pose proof eta_below_square as E1; pose proof eta_below_L as E2; pose proof L_square as L2.
  set (w := 1 - u - u * u * / 100).
  assert (W0 : 0 < w) by (unfold w; nra).
  assert (Sq : (L * w) * (L * w) <= fl (q0 + q1)).
  { eapply Rle_trans; [|exact S].
    apply Rle_trans with ((L * L * (1 - u) - 2 * (u * u * / 512 * (L * L))) * (1 - u)).
    - replace (L * w * (L * w)) with (L * L * (w * w)) by ring.
      replace ((L * L * (1 - u) - 2 * (u * u * / 512 * (L * L))) * (1 - u)) with
        (L * L * ((1 - u - u * u * / 256) * (1 - u))) by field.
      apply Rmult_le_compat_l; [nra|].
      apply Rmult_le_compat; unfold w; nra.
    - apply Rmult_le_compat_r; [lra|].
      assert (L * L * (1 - u) = (n0 * n0 + n1 * n1) * (1 - u)) by (rewrite L2; ring); lra. }
  assert (R : L * w <= sqrt (fl (q0 + q1))).
  { rewrite <- (sqrt_Rsqr (L * w)) by (apply Rmult_le_pos; lra); apply sqrt_le_1_alt; exact Sq. }
  unfold code_length; fold q0 q1.
  assert (R0 : 0 <= sqrt (fl (q0 + q1))) by apply sqrt_pos.
  destruct (fl_any_bounds _ R0) as [B _].
  eapply Rle_trans; [|exact B].
  apply Rle_trans with (L * w * (1 - u) - u * u * / 512 * L).
  - replace (L * w * (1 - u) - u * u * / 512 * L) with (L * (w * (1 - u) - u * u * / 512)) by ring.
    apply Rmult_le_compat_l; [lra|]; unfold w; nra.
  - assert (L * w * (1 - u) <= sqrt (fl (q0 + q1)) * (1 - u)) by (apply Rmult_le_compat_r; lra); lra.
Qed.

Lemma code_scale_bounds : 0 <= code_scale n0 n1 /\ code_scale n0 n1 * L <= 1 - 6 * u + 5 * (u * u).
Proof.
  pose proof u_positive as U0; pose proof u_small as U; pose proof L_positive as L0.
  pose proof code_length_at_least as K; pose proof eta_times_L as E.
  unfold code_scale, ball_shortening, scaling_error.
  set (l := code_length n0 n1) in *.
  assert (W : 0 < L * (1 - 2 * u)) by (apply Rmult_lt_0_compat; lra).
  assert (l0 : 0 < l) by lra.
  set (z := (1 - (5 + 4) * u) / l).
  assert (Z0 : 0 <= z) by (unfold z; apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat, l0]).
  split; [apply fl_nonneg, Z0|].
  destruct (fl_any_bounds _ Z0) as [_ B].
  assert (ZL : z * L * (1 - 2 * u) <= 1 - 9 * u).
  { replace (z * L * (1 - 2 * u)) with (z * (L * (1 - 2 * u))) by ring.
    replace (1 - 9 * u) with (z * l) by (unfold z; field; lra).
    apply Rmult_le_compat_l; lra. }
  apply Rle_trans with ((z * (1 + u) + eta) * L); [apply Rmult_le_compat_r; lra|].
  assert (ZL' : z * L <= 1 - 7 * u - 13.9 * (u * u)).
  { apply Rmult_le_reg_r with (1 - 2 * u); [lra|]; eapply Rle_trans; [exact ZL|]; nra. }
  replace ((z * (1 + u) + eta) * L) with (z * L * (1 + u) + eta * L) by ring.
  assert (z * L * (1 + u) <= (1 - 7 * u - 13.9 * (u * u)) * (1 + u)) by (apply Rmult_le_compat_r; lra).
  nra.
Qed.

(** The scale does not underflow: the length is at most 2^(safe + 1). *)
Lemma code_scale_positive : 0 < code_scale n0 n1.
Proof.
  pose proof u_positive as U0; pose proof u_small as U.
  assert (room : (emin <= - safe_exponent - 2)%Z /\ (0 <= safe_exponent)%Z /\ (emin <= 0)%Z)
    by (generalize squares_are_safe safe_exponent_positive prec_at_least_24; lia).
  destruct room as [room1 [room2 room3]].
  assert (B : forall e v, (emin <= e)%Z -> v <= bpow radix2 e -> fl v <= bpow radix2 e).
  { intros e v He Hv; rewrite <- (fl_of_float (bpow radix2 e)) by (apply is_float_bpow; exact He).
    apply fl_le, Hv. }
  set (s := bpow radix2 safe_exponent) in *; assert (s0 : 0 < s) by apply bpow_gt_0.
  assert (S2 : bpow radix2 (2 * safe_exponent) = s * s)
    by (unfold s; rewrite <- bpow_plus; f_equal; lia).
  assert (S3 : bpow radix2 (2 * safe_exponent + 2) = (2 * s) * (2 * s)).
  { rewrite bpow_plus, S2; change (bpow radix2 2) with 4; ring. }
  assert (S4 : bpow radix2 (safe_exponent + 1) = 2 * s)
    by (rewrite bpow_plus; change (bpow radix2 1) with 2; unfold s; ring).
  pose proof (Rmax_l (Rabs n0) (Rabs n1)); pose proof (Rmax_r (Rabs n0) (Rabs n1)).
  assert (E : forall z, Rabs z <= s -> z * z <= s * s).
  { intros z Hz; rewrite <- (Rabs_pos_eq (z * z)) by nra; rewrite Rabs_mult.
    apply Rmult_le_compat; auto using Rabs_pos. }
  assert (Q0 : fl (n0 * n0) <= s * s) by (rewrite <- S2; apply B; [lia|]; rewrite S2; apply E; lra).
  assert (Q1 : fl (n1 * n1) <= s * s) by (rewrite <- S2; apply B; [lia|]; rewrite S2; apply E; lra).
  assert (Q : fl (fl (n0 * n0) + fl (n1 * n1)) <= (2 * s) * (2 * s)).
  { rewrite <- S3; apply B; [lia|]; rewrite S3.
    assert (0 <= s * s) by (apply Rmult_le_pos; lra); lra. }
  assert (R : sqrt (fl (fl (n0 * n0) + fl (n1 * n1))) <= 2 * s).
  { rewrite <- (sqrt_Rsqr (2 * s)) by lra; apply sqrt_le_1_alt; exact Q. }
  assert (LE : code_length n0 n1 <= 2 * s) by (unfold code_length; rewrite <- S4; apply B; [lia|]; rewrite S4; exact R).
  pose proof code_length_at_least as LA; pose proof L_positive as L0.
  assert (l0 : 0 < code_length n0 n1).
  { eapply Rlt_le_trans; [|exact LA]; apply Rmult_lt_0_compat; lra. }
  unfold code_scale, ball_shortening, scaling_error.
  apply Rlt_le_trans with (bpow radix2 (- safe_exponent - 2)); [apply bpow_gt_0|].
  rewrite <- (fl_of_float (bpow radix2 (- safe_exponent - 2))) by (apply is_float_bpow; lia); apply fl_le.
  apply Rmult_le_reg_r with (code_length n0 n1); [exact l0|].
  replace ((1 - (5 + 4) * u) / code_length n0 n1 * code_length n0 n1) with (1 - 9 * u) by (field; lra).
  assert (I : bpow radix2 (- safe_exponent - 2) * (2 * s) = / 2).
  { unfold s; replace (2 * bpow radix2 safe_exponent) with (bpow radix2 (safe_exponent + 1)) by exact S4.
    rewrite <- bpow_plus; replace (- safe_exponent - 2 + (safe_exponent + 1))%Z with (-1)%Z by lia; reflexivity. }
  apply Rle_trans with (bpow radix2 (- safe_exponent - 2) * (2 * s)).
  - apply Rmult_le_compat_l; [apply bpow_ge_0|exact LE].
  - rewrite I; lra.
Qed.
End Lengths.

Theorem shorten_is_short N0 N1 e0 e1 k n0 n1 :
  Rabs e0 <= u -> Rabs e1 <= u -> scaled_safely k (N0 * (1 + e0)) (N1 * (1 + e1)) n0 n1 ->
  let m0 := code_m n0 n1 n0 in let m1 := code_m n0 n1 n1 in
  (forall q0 q1 r, 0 <= r -> q0 * q0 + q1 * q1 <= r * r ->
     Rabs m0 * Rabs q0 + Rabs m1 * Rabs q1 <= (1 - ball_shortening * u) * r) /\
  exists c d0 d1 t0 t1, 0 < c /\ Rabs d0 <= 2.0000001 * u /\ Rabs d1 <= 2.0000001 * u /\
    Rabs t0 <= 2.1 * eta /\ Rabs t1 <= 2.1 * eta /\
    m0 = c * N0 * (1 + d0) + t0 /\ m1 = c * N1 * (1 + d1) + t1 /\
    (forall q0 q1 r, 0 <= r -> q0 * q0 + q1 * q1 <= r * r ->
       c * (Rabs N0 * Rabs q0 + Rabs N1 * Rabs q1) <= (1 - 4 * u) * r).
Proof.
  intros H0 H1 [k0 [[t0 [t1 [T0 [T1 [E0 [E1 one]]]]]] safe]] m0 m1.
  pose proof u_positive as U0; pose proof u_small as U; pose proof eta_positive as Et.
  pose proof (L_positive n0 n1 safe) as L0; pose proof (L_square n0 n1) as L2.
  pose proof (L_at_least n0 n1) as Lm.
  destruct (code_scale_bounds n0 n1 safe) as [S0 SL]; pose proof (eta_below_u) as Eu.
  set (L := sqrt (n0 * n0 + n1 * n1)) in *; set (s := code_scale n0 n1) in *.
  assert (S1 : (t0 = 0 /\ t1 = 0) \/ s <= 1).
  { destruct one as [one|one]; [left; exact one|right].
    apply Rmult_le_reg_r with L; [exact L0|]; nra. }
  assert (C : forall q0 q1 r, 0 <= r -> q0 * q0 + q1 * q1 <= r * r ->
            Rabs n0 * Rabs q0 + Rabs n1 * Rabs q1 <= L * r /\ Rabs q0 + Rabs q1 <= 2 * r).
  { intros q0 q1 r Hr Hq; split; [apply cauchy; lra|].
    assert (K : forall q, q * q <= r * r -> Rabs q <= r).
    { intros q Hq'; rewrite <- (Rabs_pos_eq r) by lra; apply Rsqr_le_abs_0; exact Hq'. }
    assert (Rabs q0 <= r) by (apply K; nra); assert (Rabs q1 <= r) by (apply K; nra); lra. }
  split.
  - intros q0 q1 r Hr Hq; destruct (C q0 q1 r Hr Hq) as [C1 C2].
    assert (M : forall n, Rabs (code_m n0 n1 n) <= Rabs n * (s * (1 + u)) + eta).
    { intro n; unfold code_m; rewrite <- fl_abs, Rabs_mult, (Rabs_pos_eq (code_scale n0 n1)) by exact S0.
      fold s; assert (P : 0 <= Rabs n * s) by (apply Rmult_le_pos; auto using Rabs_pos).
      destruct (fl_any_bounds _ P); lra. }
    pose proof (Rabs_pos q0); pose proof (Rabs_pos q1).
    assert (M0 : Rabs m0 * Rabs q0 <= (Rabs n0 * (s * (1 + u)) + eta) * Rabs q0)
      by (apply Rmult_le_compat_r; [apply Rabs_pos|apply M]).
    assert (M1 : Rabs m1 * Rabs q1 <= (Rabs n1 * (s * (1 + u)) + eta) * Rabs q1)
      by (apply Rmult_le_compat_r; [apply Rabs_pos|apply M]).
    assert (K : (s * (1 + u)) * (Rabs n0 * Rabs q0 + Rabs n1 * Rabs q1) <= (s * (1 + u)) * (L * r))
      by (apply Rmult_le_compat_l; [apply Rmult_le_pos; lra|exact C1]).
    assert (K2 : (s * L) * ((1 + u) * r) <= (1 - 6 * u + 5 * (u * u)) * ((1 + u) * r))
      by (apply Rmult_le_compat_r; [apply Rmult_le_pos; lra|exact SL]).
    assert (K3 : eta * (Rabs q0 + Rabs q1) <= u * u * / 512 * (2 * r)) by (apply Rmult_le_compat; lra).
    assert (K4 : ((1 - 6 * u + 5 * (u * u)) * (1 + u) + u * u * / 256) * r <= (1 - 5 * u) * r).
    { apply Rmult_le_compat_r; [exact Hr|]; clear - U0 U; nra. }
    unfold ball_shortening; lra.
  - destruct (fl_any (n0 * s)) as [a0 [b0 [A0 [B0 F0]]]], (fl_any (n1 * s)) as [a1 [b1 [A1 [B1 F1]]]].
    exists (s * k), ((1 + e0) * (1 + a0) - 1), ((1 + e1) * (1 + a1) - 1),
      (s * t0 * (1 + a0) + b0), (s * t1 * (1 + a1) + b1).
    assert (TT : forall t a b, Rabs t <= eta -> Rabs a <= u -> Rabs b <= eta -> t = 0 \/ s <= 1 ->
              Rabs (s * t * (1 + a) + b) <= 2.1 * eta).
    { intros t a b Ht Ha Hb Hs; eapply Rle_trans; [apply Rabs_triang|].
      destruct Hs as [->|Hs].
      - rewrite Rmult_0_r, Rmult_0_l, Rabs_R0; lra.
      - rewrite !Rabs_mult, (Rabs_pos_eq s) by lra.
        apply Rabs_le_inv in Ha; rewrite (Rabs_pos_eq (1 + a)) by lra.
        assert (s * Rabs t <= 1 * eta) by (apply Rmult_le_compat; auto using Rabs_pos).
        assert (s * Rabs t * (1 + a) <= 1 * eta * 1.01)
          by (apply Rmult_le_compat; try lra; apply Rmult_le_pos; auto using Rabs_pos).
        lra. }
    repeat split.
    + apply Rmult_lt_0_compat; [apply code_scale_positive; exact safe|exact k0].
    + apply factor2; auto.
    + apply factor2; auto.
    + apply TT; auto; tauto.
    + apply TT; auto; tauto.
    + unfold m0, code_m; fold s; rewrite F0, E0 at 1; ring.
    + unfold m1, code_m; fold s; rewrite F1, E1 at 1; ring.
    + intros q0 q1 r Hr Hq; destruct (C q0 q1 r Hr Hq) as [C1 C2].
      assert (M : forall N e t n, Rabs e <= u -> Rabs t <= eta -> n = k * (N * (1 + e)) + t -> t = 0 \/ s <= 1 ->
                s * k * Rabs N * (1 - u) <= s * Rabs n + eta).
      { intros N e t n He Ht En Hs.
        assert (X : k * Rabs N * (1 - u) <= Rabs (n - t)).
        { replace (n - t) with (k * N * (1 + e)) by (rewrite En; ring).
          rewrite !Rabs_mult, (Rabs_pos_eq k) by lra; apply Rmult_le_compat_l;
          [apply Rmult_le_pos; auto using Rabs_pos; lra|].
          apply Rabs_le_inv in He; rewrite Rabs_pos_eq; lra. }
        assert (Y : s * (k * Rabs N * (1 - u)) <= s * Rabs (n - t)) by (apply Rmult_le_compat_l; auto).
        destruct Hs as [->|Hs]; [rewrite Rminus_0_r in Y; lra|].
        assert (V : Rabs (n - t) <= Rabs n + Rabs t)
          by (unfold Rminus; eapply Rle_trans; [apply Rabs_triang|rewrite Rabs_Ropp; lra]).
        assert (s * Rabs (n - t) <= s * (Rabs n + Rabs t)) by (apply Rmult_le_compat_l; auto).
        assert (s * Rabs t <= 1 * eta) by (apply Rmult_le_compat; auto using Rabs_pos).
        lra. }
      assert (Z0 : t0 = 0 \/ s <= 1) by tauto; assert (Z1 : t1 = 0 \/ s <= 1) by tauto.
      pose proof (M _ _ _ _ H0 T0 E0 Z0) as M0; pose proof (M _ _ _ _ H1 T1 E1 Z1) as M1.
      pose proof (Rabs_pos q0) as q00; pose proof (Rabs_pos q1) as q10.
      assert (P0 : s * k * Rabs N0 * (1 - u) * Rabs q0 <= (s * Rabs n0 + eta) * Rabs q0)
        by (apply Rmult_le_compat_r; auto).
      assert (P1 : s * k * Rabs N1 * (1 - u) * Rabs q1 <= (s * Rabs n1 + eta) * Rabs q1)
        by (apply Rmult_le_compat_r; auto).
      apply Rmult_le_reg_r with (1 - u); [lra|].
      assert (K : s * (Rabs n0 * Rabs q0 + Rabs n1 * Rabs q1) <= s * (L * r)) by (apply Rmult_le_compat_l; auto).
      assert (K2 : s * L * r <= (1 - 6 * u + 5 * (u * u)) * r) by (apply Rmult_le_compat_r; auto).
      assert (K3 : eta * (Rabs q0 + Rabs q1) <= u * u * / 512 * (2 * r)) by (apply Rmult_le_compat; lra).
      assert (K4 : ((1 - 6 * u + 5 * (u * u)) + u * u * / 256) * r <= ((1 - 4 * u) * (1 - u)) * r).
      { apply Rmult_le_compat_r; [exact Hr|]; clear - U0 U; assert (u * u <= u * / 16777216) by (apply Rmult_le_compat_l; lra); lra. }
      lra.
Qed.
End Shorten.
