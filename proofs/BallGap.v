(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * The stated gap of the certified ball test

    What the certified test keeps wrongly would not be outside exactly if the ball's radius were larger by
    base + 32 u r. [shortened_is_long]: the shortened normal is no shorter than 1 - 14 u. [kept_ball_is_near] and
    [refused_ball_is_near]: what that makes of the two comparisons with a plane. [kept_by_distance_is_near]: the same
    for the distance to the extent box. [kept_ball_grown_is_kept]: a ball that the certified test does not call outside
    is not outside by the paper's sphere test in real numbers, when grown by the stated gap. *)
Require Import Reals Lra Psatz ZArith List Bool.
Require Import Flocq.Core.Core.
Require Import Gnomon.Boxes Gnomon.PlaneSet Gnomon.BoxTest Gnomon.BallDistance Gnomon.BallAgainstPlane.
Require Import Gnomon.RoundingModel Gnomon.PlaneError Gnomon.BoxTestCertified Gnomon.ShortenedNormal.
Require Import Gnomon.BallThreshold Gnomon.BallTestCertified Gnomon.ShortenedPlane Gnomon.BallSlack.
Require Import Gnomon.SlabBox Gnomon.CertifiedBoxTest Gnomon.Prescale Gnomon.CertifiedBallTest.
Open Scope R_scope.

Section Long.
Context {F : Format}.
Variables n0 n1 : R.
Hypothesis safe : bpow radix2 (- safe_exponent) <= Rmax (Rabs n0) (Rabs n1) <= bpow radix2 safe_exponent.
Let L := sqrt (n0 * n0 + n1 * n1).

Lemma code_length_at_most : code_length n0 n1 <= L * (1 + 2.01 * u).
Proof.
  pose proof u_positive as U0; pose proof u_small as U; pose proof eta_positive as T0.
  pose proof (L_positive n0 n1 safe) as L0; fold L in L0.
  assert (Q0 : 0 <= n0 * n0) by nra; assert (Q1 : 0 <= n1 * n1) by nra.
  destruct (fl_any_bounds _ Q0) as [_ A0], (fl_any_bounds _ Q1) as [_ A1].
  pose proof (fl_nonneg _ Q0) as P0; pose proof (fl_nonneg _ Q1) as P1.
  set (q0 := fl (n0 * n0)) in *; set (q1 := fl (n1 * n1)) in *.
  assert (P : 0 <= q0 + q1) by lra.
  destruct (fl_plus_bounds q0 q1 (fl_is_float _) (fl_is_float _) P) as [_ S].
  pose proof (eta_below_square n0 n1 safe) as E1; pose proof (eta_below_L n0 n1 safe) as E2; pose proof (L_square n0 n1) as L2.
  fold L in E1, E2, L2.
  set (w := 1 + u + u * u * / 100).
  assert (Sq : fl (q0 + q1) <= (L * w) * (L * w)).
  { eapply Rle_trans; [exact S|].
    apply Rle_trans with ((L * L * (1 + u) + 2 * (u * u * / 512 * (L * L))) * (1 + u)).
    - apply Rmult_le_compat_r; [lra|].
      assert (L * L * (1 + u) = (n0 * n0 + n1 * n1) * (1 + u)) by (rewrite L2; ring); lra.
    - replace (L * w * (L * w)) with (L * L * (w * w)) by ring.
      replace ((L * L * (1 + u) + 2 * (u * u * / 512 * (L * L))) * (1 + u)) with
        (L * L * ((1 + u + u * u * / 256) * (1 + u))) by field.
      apply Rmult_le_compat_l; [nra|]; unfold w; nra. }
  assert (R : sqrt (fl (q0 + q1)) <= L * w).
  { rewrite <- (sqrt_Rsqr (L * w)) by (apply Rmult_le_pos; unfold w; nra); apply sqrt_le_1_alt; exact Sq. }
  unfold code_length; fold q0 q1.
  assert (R0 : 0 <= sqrt (fl (q0 + q1))) by apply sqrt_pos.
  destruct (fl_any_bounds _ R0) as [_ B].
  eapply Rle_trans; [exact B|].
  apply Rle_trans with (L * w * (1 + u) + u * u * / 512 * L).
  - assert (sqrt (fl (q0 + q1)) * (1 + u) <= L * w * (1 + u)) by (apply Rmult_le_compat_r; lra); lra.
  - replace (L * w * (1 + u) + u * u * / 512 * L) with (L * (w * (1 + u) + u * u * / 512)) by ring.
    apply Rmult_le_compat_l; [lra|]; unfold w; nra.
Qed.

Lemma code_scale_at_least : 1 - 12.1 * u <= code_scale n0 n1 * L.
Proof.
  pose proof u_positive as U0; pose proof u_small as U; pose proof (L_positive n0 n1 safe) as L0; fold L in L0.
  pose proof code_length_at_most as K; pose proof (code_length_at_least n0 n1 safe) as K'; fold L in K'.
  pose proof (eta_times_L n0 n1 safe) as E; fold L in E.
  unfold code_scale, ball_shortening, scaling_error; set (l := code_length n0 n1) in *.
  assert (W : 0 < L * (1 - 2 * u)) by (apply Rmult_lt_0_compat; lra).
  assert (l0 : 0 < l) by lra.
  set (z := (1 - (5 + 4) * u) / l).
  assert (Z0 : 0 <= z) by (unfold z; apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat, l0]).
  destruct (fl_any_bounds _ Z0) as [B _].
  assert (ZL : 1 - 9 * u <= z * L * (1 + 2.01 * u)).
  { replace (1 - 9 * u) with (z * l) by (unfold z; field; lra).
    replace (z * L * (1 + 2.01 * u)) with (z * (L * (1 + 2.01 * u))) by ring; apply Rmult_le_compat_l; lra. }
  assert (ZL' : 1 - 11.02 * u <= z * L).
  { apply Rmult_le_reg_r with (1 + 2.01 * u); [lra|]; eapply Rle_trans; [|exact ZL]; nra. }
  apply Rle_trans with ((z * (1 - u) - eta) * L); [|apply Rmult_le_compat_r; lra].
  replace ((z * (1 - u) - eta) * L) with (z * L * (1 - u) - eta * L) by ring.
  assert ((1 - 11.02 * u) * (1 - u) <= z * L * (1 - u)) by (apply Rmult_le_compat_r; lra); nra.
Qed.

(** The shortened normal, as a vector of floats. *)
Theorem shortened_is_long :
  (1 - 14 * u) * (1 - 14 * u) <= code_m n0 n1 n0 * code_m n0 n1 n0 + code_m n0 n1 n1 * code_m n0 n1 n1.
Proof.
  pose proof u_positive as U0; pose proof u_small as U; pose proof eta_positive as T0.
  pose proof (L_positive n0 n1 safe) as L0; pose proof (L_square n0 n1) as L2; fold L in L0, L2.
  pose proof code_scale_at_least as S; destruct (code_scale_bounds n0 n1 safe) as [s0 S']; fold L in S'.
  pose proof (eta_below_u) as Eu.
  set (s := code_scale n0 n1) in *.
  (* each component, from below, squared *)
  assert (K : forall n, n * n <= L * L -> (n * s) * (n * s) * (1 - 2 * u) - 2.1 * eta <= code_m n0 n1 n * code_m n0 n1 n).
  { intros n Hn; unfold code_m; fold s.
    destruct (fl_any (n * s)) as [e [t [He [Ht ->]]]]; apply Rabs_le_inv in He; apply Rabs_le_inv in Ht.
    assert (V : (n * s) * (n * s) <= 1).
    { replace (n * s * (n * s)) with (n * n * (s * s)) by ring.
      apply Rle_trans with (L * L * (s * s)); [apply Rmult_le_compat_r; [nra|exact Hn]|].
      replace (L * L * (s * s)) with ((s * L) * (s * L)) by ring.
      assert (0 <= s * L) by (apply Rmult_le_pos; lra); assert (s * L <= 1) by nra; nra. }
    set (v := n * s) in *.
    assert (V1 : -1 <= v <= 1) by nra.
    assert (V2 : -1.01 * eta <= v * (1 + e) * t <= 1.01 * eta).
    { assert (-1.01 <= v * (1 + e) <= 1.01) by nra; split; nra. }
    assert (v * v * (1 - 2 * u) <= v * v * ((1 + e) * (1 + e))) by (apply Rmult_le_compat_l; [apply Rle_0_sqr|clear - He; nra]).
    pose proof (Rle_0_sqr t) as T2; unfold Rsqr in T2; lra. }
  pose proof (K n0 ltac:(nra)) as K0; pose proof (K n1 ltac:(nra)) as K1.
  assert (E : (s * L) * (s * L) * (1 - 2 * u) - 4.2 * eta <=
              code_m n0 n1 n0 * code_m n0 n1 n0 + code_m n0 n1 n1 * code_m n0 n1 n1).
  { replace (s * L * (s * L)) with (s * s * (n0 * n0 + n1 * n1)) by (rewrite <- L2; ring); lra. }
  eapply Rle_trans; [|exact E].
  assert ((1 - 12.1 * u) * (1 - 12.1 * u) <= s * L * (s * L)) by (apply Rmult_le_compat; lra).
  assert ((1 - 12.1 * u) * (1 - 12.1 * u) * (1 - 2 * u) <= s * L * (s * L) * (1 - 2 * u)) by (apply Rmult_le_compat_r; lra).
  assert ((1 - 14 * u) * (1 - 14 * u) <= (1 - 12.1 * u) * (1 - 12.1 * u) * (1 - 2 * u) - u * u) by (clear - U0 U; nra).
  pose proof (Rle_0_sqr u) as UU; unfold Rsqr in UU; lra.
Qed.
End Long.

Section Gap.
Context {F : Format}.
Variables (A B : box) (f g : face) (m0 m1 c d0 d1 t0 t1 : R).
Hypotheses (wA : valid A) (wB : valid B) (FA : float_box A) (FB : float_box B)
           (N : fst f <> fst g) (Ef : extreme A B f) (Eg : extreme B A g)
           (M : short_normal A B f g m0 m1 c d0 d1 t0 t1)
           (long : (1 - 14 * u) * (1 - 14 * u) <= m0 * m0 + m1 * m1).
Let a0 := coord A f. Let a1 := coord A g. Let b0 := coord B f. Let b1 := coord B g.
Let x := extent_magnitude A B (fst f). Let y := extent_magnitude A B (fst g).
Let d := plane_d m0 m1 a0 a1.
Let P := Rabs m0 * x + Rabs m1 * y.
Let N0 := true_n0 A B f g. Let N1 := true_n1 A B f g.
Let value (z : point) := plane_value m0 m1 d (z (fst f)) (z (fst g)).
(** The exact value of the centre, and the length of the exact normal: their quotient is the signed distance. *)
Let exact (z : point) := true_value A B f g (z (fst f)) (z (fst g)).
Let normal_length := sqrt (N0 * N0 + N1 * N1).

Lemma exact_normal_is_long : 1 - 16.2 * u <= c * normal_length.
Proof.
  pose proof u_positive as U0; pose proof u_small as U; pose proof eta_positive as T0; pose proof (eta_below_u) as Eu.
  destruct M as [_ c0 D0 D1 S0 S1 E0 E1 Q _ _]; fold N0 N1 in E0, E1, Q.
  assert (L0 : 0 <= normal_length) by apply sqrt_pos.
  assert (L2 : normal_length * normal_length = N0 * N0 + N1 * N1) by (apply sqrt_sqrt; nra).
  assert (K : forall n e t m, Rabs e <= 2.0000001 * u -> Rabs t <= 2.1 * eta -> c * Rabs n <= 1 -> m = c * n * (1 + e) + t ->
            m * m <= (c * n) * (c * n) * (1 + 4.1 * u) + 5 * eta).
  { intros n e t m He Ht Hn ->; apply Rabs_le_inv in He; apply Rabs_le_inv in Ht.
    assert (V : -1 <= c * n <= 1).
    { rewrite <- (Rabs_pos_eq c) in Hn by lra; rewrite <- Rabs_mult in Hn; apply Rabs_le_inv in Hn; exact Hn. }
    set (v := c * n) in *.
    assert (-1.01 <= v * (1 + e) <= 1.01) by nra.
    assert (v * (1 + e) * t <= 1.01 * (2.1 * eta)) by nra.
    assert (t * t <= 0.1 * eta).
    { assert (Es : eta <= 0.001) by (pose proof eta_small; lra).
      assert (0 <= (2.1 * eta - t) * (2.1 * eta + t)) by (apply Rmult_le_pos; lra).
      assert (eta * eta <= 0.001 * eta) by (apply Rmult_le_compat_r; lra); lra. }
    assert (v * v * ((1 + e) * (1 + e)) <= v * v * (1 + 4.1 * u))
      by (apply Rmult_le_compat_l; [apply Rle_0_sqr|clear - He U0 U; nra]).
    lra. }
  pose proof (Q 1 0 1 ltac:(lra) ltac:(lra)) as Q0; pose proof (Q 0 1 1 ltac:(lra) ltac:(lra)) as Q1.
  rewrite Rabs_R0, Rabs_R1 in Q0, Q1.
  pose proof (K N0 d0 t0 m0 D0 S0 ltac:(lra) E0) as K0; pose proof (K N1 d1 t1 m1 D1 S1 ltac:(lra) E1) as K1.
  assert (V : (1 - 14 * u) * (1 - 14 * u) <= (c * normal_length) * (c * normal_length) * (1 + 4.1 * u) + 10 * eta).
  { replace (c * normal_length * (c * normal_length)) with (c * c * (normal_length * normal_length)) by ring.
    rewrite L2; lra. }
  assert (C0 : 0 <= c * normal_length) by (apply Rmult_le_pos; lra); set (v := c * normal_length) in *; clearbody v.
  apply Rsqr_incr_0_var; [|exact C0]; unfold Rsqr.
  apply Rmult_le_reg_r with (1 + 4.1 * u); [lra|]; nra.
Qed.

(** How far the computed value is from the exact one, scaled by c, for a centre up to R outside the extent box. *)
Lemma value_near_exact z R : 0 <= R -> Rabs (z (fst f)) <= x + R -> Rabs (z (fst g)) <= y + R ->
  Rabs (c * exact z - value z) <= u * (10.1 * P) + 10 * u * R + eta * (6 + 5 * (x + y) + 10 * R).
Proof.
  intros R0 Zx Zy; pose proof u_positive as U0; pose proof u_small as U; pose proof eta_positive as T0.
  destruct (xy_facts A B f g wA wB) as [x0 [y0 [Hax [Hay _]]]]; fold x in x0, Hax; fold y in y0, Hay; fold a0 in Hax; fold a1 in Hay.
  pose proof (short _ _ _ _ _ _ _ _ _ _ _ M 1 1 1.4143 ltac:(lra) ltac:(lra)) as MM; unfold ball_shortening in MM.
  rewrite Rabs_R1 in MM.
  destruct M as [_ c0 D0 D1 S0 S1 E0 E1 _ _ _]; fold N0 N1 in E0, E1.
  pose proof (plane_value_error_as_stored m0 m1 d (z (fst f)) (z (fst g)) (plane_d_is_float _ _ _ _)) as VE.
  fold (value z) in VE; apply Rabs_le_inv in VE.
  pose proof (plane_d_error m0 m1 a0 a1) as DE; fold d in DE; apply Rabs_le_inv in DE.
  pose proof (d_magnitude A f g m0 m1) as DM; fold a0 a1 d in DM.
  set (D := Rabs m0 * Rabs a0 + Rabs m1 * Rabs a1) in *.
  assert (DP : 0 <= D <= P).
  { unfold D, P; split; [apply Rplus_le_le_0_compat; apply Rmult_le_pos; apply Rabs_pos|].
    apply Rplus_le_compat; apply Rmult_le_compat_l; auto using Rabs_pos. }
  pose proof (turned_component_at_most c m0 N0 d0 t0 (z (fst f)) a0 (x + R) D0 S0 E0 Zx ltac:(lra) ltac:(lra)) as G0.
  pose proof (turned_component_at_most c m1 N1 d1 t1 (z (fst g)) a1 (y + R) D1 S1 E1 Zy ltac:(lra) ltac:(lra)) as G1.
  apply Rabs_le_inv in G0; apply Rabs_le_inv in G1.
  assert (MC : Rabs m0 * Rabs (z (fst f)) + Rabs m1 * Rabs (z (fst g)) <= P + 1.4143 * R).
  { assert (Rabs m0 * Rabs (z (fst f)) <= Rabs m0 * (x + R)) by (apply Rmult_le_compat_l; auto using Rabs_pos).
    assert (Rabs m1 * Rabs (z (fst g)) <= Rabs m1 * (y + R)) by (apply Rmult_le_compat_l; auto using Rabs_pos).
    assert ((Rabs m0 + Rabs m1) * R <= 1.4143 * R); [apply Rmult_le_compat_r; [exact R0|]|unfold P; lra].
    assert ((1 - 5 * u) * 1.4143 <= 1.4143) by lra; lra. }
  assert (U1 : u * (3.000001 * (Rabs m0 * Rabs (z (fst f)) + Rabs m1 * Rabs (z (fst g))) + Rabs d) <=
               u * (3.000001 * (P + 1.4143 * R) + (D * 1.000001 + 2.5 * eta))) by (apply Rmult_le_compat_l; lra).
  assert (U2 : u * (2.5 * eta) <= / 16777216 * (2.5 * eta)) by (apply Rmult_le_compat_r; lra).
  assert (UD : u * D <= u * P) by (apply Rmult_le_compat_l; lra).
  assert (UR : 0 <= u * R) by (apply Rmult_le_pos; lra).
  assert (UP : 0 <= u * P) by (apply Rmult_le_pos; lra).
  assert (ER : 0 <= eta * R) by (apply Rmult_le_pos; lra).
  assert (EX : 0 <= eta * x) by (apply Rmult_le_pos; lra).
  assert (EY : 0 <= eta * y) by (apply Rmult_le_pos; lra).
  assert (MR : (Rabs m0 * (x + R) + Rabs m1 * (y + R)) * (4.001 * u) <= (P + 1.4143 * R) * (4.001 * u)).
  { apply Rmult_le_compat_r; [lra|].
    assert ((Rabs m0 + Rabs m1) * R <= 1.4143 * R); [apply Rmult_le_compat_r; [exact R0|]|unfold P; lra].
    assert ((1 - 5 * u) * 1.4143 <= 1.4143) by lra; lra. }
  apply Rabs_le; unfold exact, true_value, exact_value; fold N0 N1 a0 a1; split; lra.
Qed.

(** StatedGap::base of a plane, as computed, and what is added for balls whose distance underflows. *)
Definition gap_p : R := 60.
Definition gap_underflow : R := 4.
Definition code_base (outside inside p underflow : R) : R :=
  fl (fl (fl inflate * fl (Rmax outside inside + fl (u * fl (gap_p * p)))) + fl (gap_underflow * underflow)).

Let outside := code_outside m0 m1 a0 a1 b0 b1 x y.
Let inside := code_inside m0 m1 a0 a1 x y.
Let base := code_base outside inside (product_sum (Rabs m0) x (Rabs m1) y) (code_underflow x y).

Lemma P_not_negative : 0 <= P.
Proof.
  destruct (xy_facts A B f g wA wB) as [x0 [y0 _]].
  unfold P; apply Rplus_le_le_0_compat; apply Rmult_le_pos; auto using Rabs_pos.
Qed.
Lemma thresholds_not_negative : 0 <= outside /\ 0 <= inside.
Proof.
  pose proof P_not_negative as P0; pose proof u_positive as U0; pose proof u_small as U; pose proof eta_positive as T0.
  destruct (xy_facts A B f g wA wB) as [x0 [y0 _]]; fold x in x0; fold y in y0.
  assert (FX : is_float x) by (apply extent_magnitude_float; auto).
  assert (FY : is_float y) by (apply extent_magnitude_float; auto).
  pose proof (code_outside_at_least m0 m1 a0 a1 b0 b1 x y x0 y0 FX FY (FA f) (FA g) (FB f) (FB g)) as O; fold outside P in O.
  pose proof (code_inside_at_least m0 m1 a0 a1 x y x0 y0 FX FY) as I; fold inside P in I.
  assert (NN : forall p q r s, 0 <= Rabs p * Rabs q + Rabs r * Rabs s)
    by (intros; apply Rplus_le_le_0_compat; apply Rmult_le_pos; apply Rabs_pos).
  pose proof (NN m0 a0 m1 a1); pose proof (NN m0 (b0 - a0) m1 (b1 - a1)).
  assert (0 <= eta * (1 + x + y)) by (apply Rmult_le_pos; lra).
  split; apply Rmult_le_reg_r with (1 - u); try lra.
  - eapply Rle_trans; [|exact O]; rewrite Rmult_0_l.
    apply Rplus_le_le_0_compat; [apply Rmult_le_pos|]; lra.
  - eapply Rle_trans; [|exact I]; rewrite Rmult_0_l.
    apply Rplus_le_le_0_compat; [apply Rmult_le_pos|]; lra.
Qed.

Lemma base_at_least : 1.0008 * Rmax outside inside + 59 * (u * P) + 1000000 * (eta * (1 + x + y)) <= base.
Proof.
  pose proof P_not_negative as P0; pose proof u_positive as U0; pose proof u_small as U; pose proof eta_positive as T0.
  pose proof eta_small as Es; destruct thresholds_not_negative as [o0 i0].
  destruct (xy_facts A B f g wA wB) as [x0 [y0 _]]; fold x in x0; fold y in y0.
  assert (FX : is_float x) by (apply extent_magnitude_float; auto).
  assert (FY : is_float y) by (apply extent_magnitude_float; auto).
  destruct (product_sum_at_least (Rabs m0) x (Rabs m1) y) as [p0 p1]; auto using Rabs_pos; fold P in p1.
  destruct (code_underflow_at_least x y x0 y0 FX FY) as [w0 w1].
  assert (Fm : is_float (Rmax outside inside)) by (unfold Rmax; destruct Rle_dec; apply fl_is_float).
  unfold base, code_base, gap_p, gap_underflow; set (p := product_sum _ x _ y) in *; set (w := code_underflow x y) in *.
  assert (m0' : 0 <= Rmax outside inside) by (eapply Rle_trans; [exact o0|apply Rmax_l]).
  set (mx := Rmax outside inside) in *.
  assert (q1 : 0 <= 60 * p) by lra; pose proof (fl_at_least _ q1); pose proof (fl_nonneg _ q1) as r1.
  set (p60 := fl (60 * p)) in *.
  assert (q2 : 0 <= u * p60) by (apply Rmult_le_pos; lra); pose proof (fl_at_least _ q2); pose proof (fl_nonneg _ q2) as r2.
  assert (q3 : u * (60 * P * 0.999999 - 130 * eta) <= u * p60) by (apply Rmult_le_compat_l; lra).
  set (v := fl (u * p60)) in *.
  pose proof (fl_sum_at_least mx v m0' r2 Fm (fl_is_float _)).
  assert (q4 : 0 <= mx + v) by lra; pose proof (fl_nonneg _ q4) as r4; set (s := fl (mx + v)) in *.
  assert (I : 1.00098 <= fl inflate) by (eapply Rle_trans; [|apply fl_near]; unfold inflate; lra).
  assert (q5 : 1.00098 * s <= fl inflate * s) by (apply Rmult_le_compat_r; lra).
  assert (q6 : 0 <= fl inflate * s) by lra; pose proof (fl_at_least _ q6); pose proof (fl_nonneg _ q6) as r6.
  assert (q7 : 0 <= 4 * w) by lra; pose proof (fl_at_least _ q7); pose proof (fl_nonneg _ q7) as r7.
  pose proof (fl_sum_at_least _ _ r6 r7 (fl_is_float _) (fl_is_float _)).
  assert (u * (130 * eta) <= / 16777216 * (130 * eta)) by (apply Rmult_le_compat_r; lra).
  assert (eta * 1 <= eta * (1 + x + y)) by (apply Rmult_le_compat_l; lra).
  assert (0 <= u * P) by (apply Rmult_le_pos; lra).
  lra.
Qed.

(** A little less than what is stated, so that the roundings of its last sums are paid for: code_gap_at_least. *)
Let gap (r rho : R) := 0.9999 * base + 31 * u * r + rho.

(** A centre as near to the extent box as a ball that the distance test kept: R on each axis. [rho] is what the test
    may keep beyond r (1 + 11 u), the root of some eta. *)
Lemma gap_pays_for z r R rho v : 0 <= r -> 0 <= rho -> 0 <= R <= r * 1.001 + rho ->
  Rabs (z (fst f)) <= x + R -> Rabs (z (fst g)) <= y + R -> v <= Rmax outside inside ->
  (r + v) * (1 + u) + (u * (10.1 * P) + 10 * u * R + eta * (6 + 5 * (x + y) + 10 * R)) <=
  (r + gap r rho) * (1 - 16.2 * u).
Proof.
  intros Hr Hrho HR Zx Zy Hv; pose proof base_at_least as BB; pose proof P_not_negative as P0.
  pose proof u_positive as U0; pose proof u_small as U; pose proof eta_positive as T0; pose proof (eta_below_u) as Eu.
  destruct (xy_facts A B f g wA wB) as [x0 [y0 _]]; fold x in x0; fold y in y0.
  destruct thresholds_not_negative as [o0 i0].
  assert (M0 : 0 <= Rmax outside inside) by (eapply Rle_trans; [exact o0|apply Rmax_l]).
  set (mx := Rmax outside inside) in *; unfold gap.
  assert (e1 : 0 <= eta * (1 + x + y)) by (apply Rmult_le_pos; lra).
  set (ex := eta * (1 + x + y)) in *.
  assert (e2 : eta * (6 + 5 * (x + y)) <= 6 * ex) by (unfold ex; assert (0 <= eta * (x + y)) by (apply Rmult_le_pos; lra); lra).
  assert (e3 : eta * (10 * R) <= 0.001 * (u * R)).
  { assert (eta <= 0.0001 * u) by nra. assert (eta * R <= 0.0001 * u * R) by (apply Rmult_le_compat_r; lra); lra. }
  assert (e4 : u * R <= u * (r * 1.001 + rho)) by (apply Rmult_le_compat_l; lra).
  assert (ur : 0 <= u * r) by (apply Rmult_le_pos; lra); assert (urho : 0 <= u * rho) by (apply Rmult_le_pos; lra).
  assert (uP : 0 <= u * P) by (apply Rmult_le_pos; lra); assert (um : 0 <= u * mx) by (apply Rmult_le_pos; lra).
  assert (v1 : (r + v) * (1 + u) <= (r + mx) * (1 + u)) by (apply Rmult_le_compat_r; lra).
  assert (c0 : 0 <= 1 - 16.2 * u) by lra.
  assert (B2 : (r + (0.9999 * (1.0008 * mx + 59 * (u * P) + 1000000 * ex) + 31 * u * r + rho)) * (1 - 16.2 * u) <=
               (r + (0.9999 * base + 31 * u * r + rho)) * (1 - 16.2 * u)) by (apply Rmult_le_compat_r; lra).
  eapply Rle_trans; [|exact B2].
  assert (U3 : u * mx <= / 16777216 * mx) by (apply Rmult_le_compat_r; lra).
  assert (U4 : u * (u * P) <= / 16777216 * (u * P)) by (apply Rmult_le_compat_r; lra).
  assert (U5 : u * (u * r) <= / 16777216 * (u * r)) by (apply Rmult_le_compat_r; lra).
  assert (U6 : u * ex <= / 16777216 * ex) by (apply Rmult_le_compat_r; lra).
  assert (U7 : u * rho <= / 16777216 * rho) by (apply Rmult_le_compat_r; lra).
  lra.
Qed.

(** A plane that keeps the ball: grown by the gap, the ball is not beyond the exact plane. *)
Theorem kept_ball_is_near z r R rho : 0 <= r -> is_float r -> 0 <= rho -> 0 <= R <= r * 1.001 + rho ->
  Rabs (z (fst f)) <= x + R -> Rabs (z (fst g)) <= y + R ->
  value z <= fl (r + outside) -> exact z <= (r + gap r rho) * normal_length.
Proof.
  intros Hr Fr Hrho HR Zx Zy V; destruct thresholds_not_negative as [o0 i0].
  pose proof (value_near_exact z R (proj1 HR) Zx Zy) as E; apply Rabs_le_inv in E.
  pose proof (gap_pays_for z r R rho outside Hr Hrho HR Zx Zy (Rmax_l _ _)) as G.
  assert (RO : 0 <= r + outside) by lra.
  destruct (fl_plus_bounds r outside Fr (fl_is_float _) RO) as [_ Up].
  pose proof exact_normal_is_long as L; destruct M as [_ c0 _ _ _ _ _ _ _ _ _].
  assert (X : c * exact z <= (r + gap r rho) * (1 - 16.2 * u)) by lra.
  pose proof base_at_least as BB; pose proof P_not_negative as P0; pose proof u_positive as U0; pose proof eta_positive as T0.
  destruct (xy_facts A B f g wA wB) as [x0 [y0 _]]; fold x in x0; fold y in y0.
  assert (0 <= u * P) by (apply Rmult_le_pos; lra); assert (0 <= eta * (1 + x + y)) by (apply Rmult_le_pos; lra).
  pose proof (Rmax_l outside inside); assert (0 <= u * r) by (apply Rmult_le_pos; lra).
  assert (G0 : 0 <= r + gap r rho) by (unfold gap; lra).
  apply Rmult_le_reg_l with c; [exact c0|]; eapply Rle_trans; [exact X|].
  replace (c * ((r + gap r rho) * normal_length)) with ((r + gap r rho) * (c * normal_length)) by ring.
  apply Rmult_le_compat_l; assumption.
Qed.

(** A plane that does not accept the ball as inside: grown by the gap, the ball is not behind the exact plane, or just
    touches it. *)
Theorem refused_ball_is_near z r : 0 <= r -> is_float r -> in_extent A B z ->
  value z > fl (- inside - r) -> - ((r + gap r 0) * normal_length) < exact z.
Proof.
  intros Hr Fr E V; destruct thresholds_not_negative as [o0 i0].
  pose proof (extent_magnitude_covers A B _ _ (E (fst f))) as Zx; fold x in Zx.
  pose proof (extent_magnitude_covers A B _ _ (E (fst g))) as Zy; fold y in Zy.
  assert (Zx' : Rabs (z (fst f)) <= x + 0) by lra; assert (Zy' : Rabs (z (fst g)) <= y + 0) by lra.
  pose proof (value_near_exact z 0 (Rle_refl 0) Zx' Zy') as W; apply Rabs_le_inv in W.
  assert (HR : 0 <= 0 <= r * 1.001 + 0) by lra.
  pose proof (gap_pays_for z r 0 0 inside Hr (Rle_refl 0) HR Zx' Zy' (Rmax_r _ _)) as G.
  replace (- inside - r) with (- (inside + r)) in V by ring; rewrite fl_opp in V.
  assert (RO : 0 <= inside + r) by lra.
  destruct (fl_plus_bounds inside r (fl_is_float _) Fr RO) as [_ Up].
  pose proof exact_normal_is_long as L; destruct M as [_ c0 _ _ _ _ _ _ _ _ _].
  assert (X : - ((r + gap r 0) * (1 - 16.2 * u)) < c * exact z) by lra.
  pose proof base_at_least as BB; pose proof P_not_negative as P0; pose proof u_positive as U0; pose proof eta_positive as T0.
  destruct (xy_facts A B f g wA wB) as [x0 [y0 _]]; fold x in x0; fold y in y0.
  assert (0 <= u * P) by (apply Rmult_le_pos; lra); assert (0 <= eta * (1 + x + y)) by (apply Rmult_le_pos; lra).
  pose proof (Rmax_l outside inside); assert (0 <= u * r) by (apply Rmult_le_pos; lra).
  assert (G0 : 0 <= r + gap r 0) by (unfold gap; lra).
  apply Rmult_lt_reg_l with c; [exact c0|]; eapply Rle_lt_trans; [|exact X].
  replace (c * - ((r + gap r 0) * normal_length)) with (- ((r + gap r 0) * (c * normal_length))) by ring.
  apply Ropp_le_contravar, Rmult_le_compat_l; assumption.
Qed.
End Gap.

(** ** The distance to the extent box *)
Section Distance.
Context {F : Format}.

Lemma code_apart_at_least l h c : l <= h -> is_float l -> is_float h -> is_float c ->
  apart l h c * (1 - u) <= code_apart l h c.
Proof.
  intros L Fl Fh Fc; pose proof u_positive as U0; pose proof u_small as U.
  destruct (fl_minus l c Fl Fc) as [e [He E]], (fl_minus c h Fc Fh) as [e' [He' E']].
  apply Rabs_le_inv in He; apply Rabs_le_inv in He'; unfold code_apart, apart; rewrite E, E'.
  assert (K : forall z d, - u <= d <= u -> z * (1 - u) <= Rmax (z * (1 + d)) 0).
  { intros z d Hd; destruct (Rle_lt_dec z 0) as [C|C].
    - eapply Rle_trans; [|apply Rmax_r]; assert (0 <= - z * (1 - u)) by (apply Rmult_le_pos; lra); lra.
    - eapply Rle_trans; [|apply Rmax_l]; apply Rmult_le_compat_l; lra. }
  pose proof (K (l - c) e He) as K0; pose proof (K (c - h) e' He') as K1.
  set (p := (l - c) * (1 + e)) in *; set (q := (c - h) * (1 + e')) in *.
  assert (M0 : Rmax p 0 <= Rmax (Rmax p q) 0) by (apply Rle_max_compat_r, Rmax_l).
  assert (M1 : Rmax q 0 <= Rmax (Rmax p q) 0) by (apply Rle_max_compat_r, Rmax_r).
  pose proof (Rmax_r (Rmax p q) 0); set (m := Rmax (Rmax p q) 0) in *.
  unfold Rmax; repeat destruct Rle_dec; lra.
Qed.

Lemma code_squared_distance_at_least X Y Z x y z : 0 <= X -> 0 <= Y -> 0 <= Z ->
  X * (1 - u) <= x -> Y * (1 - u) <= y -> Z * (1 - u) <= z ->
  (X * X + Y * Y + Z * Z) * (1 - 5 * u) - 3 * eta <= code_squared_distance x y z.
Proof.
  intros X0 Y0 Z0 Hx Hy Hz; pose proof u_positive as U0; pose proof u_small as U; pose proof eta_positive as T0.
  assert (Q : forall a b, 0 <= a -> a * (1 - u) <= b -> a * a * (1 - 3 * u) - eta <= fl (b * b) /\ 0 <= fl (b * b)).
  { intros a b Ha Hb; assert (A0 : 0 <= a * (1 - u)) by (apply Rmult_le_pos; lra).
    assert (P : 0 <= b * b) by (apply Rmult_le_pos; lra); destruct (fl_any_bounds _ P) as [L _].
    split; [|apply fl_nonneg, P].
    assert ((a * (1 - u)) * (a * (1 - u)) <= b * b) by (apply Rmult_le_compat; lra).
    assert ((a * (1 - u)) * (a * (1 - u)) * (1 - u) <= b * b * (1 - u)) by (apply Rmult_le_compat_r; lra).
    assert (a * a * (1 - 3 * u) <= a * a * ((1 - u) * (1 - u) * (1 - u))) by (apply Rmult_le_compat_l; nra); lra. }
  destruct (Q X x X0 Hx) as [A0 B0], (Q Y y Y0 Hy) as [A1 B1], (Q Z z Z0 Hz) as [A2 B2]; clear Q.
  unfold code_squared_distance; rewrite Rplus_0_l, (fl_of_float (fl (x * x))) by apply fl_is_float.
  set (p := fl (x * x)) in *; set (q := fl (y * y)) in *; set (r := fl (z * z)) in *.
  assert (S0 : 0 <= p + q) by lra.
  destruct (fl_plus_bounds p q (fl_is_float _) (fl_is_float _) S0) as [L _]; pose proof (fl_nonneg _ S0).
  set (s := fl (p + q)) in *; assert (S1 : 0 <= s + r) by lra.
  destruct (fl_plus_bounds s r (fl_is_float _) (fl_is_float _) S1) as [L' _].
  eapply Rle_trans; [|exact L'].
  assert (XX : forall a : R, 0 <= a * a) by (intro; nra); pose proof (XX X); pose proof (XX Y); pose proof (XX Z).
  set (D := X * X + Y * Y + Z * Z); assert (D0 : 0 <= D) by (unfold D; lra).
  assert (T : (p + q + r) * (1 - u) <= s + r) by (assert (r * (1 - u) <= r * 1) by (apply Rmult_le_compat_l; lra); lra).
  assert (T2 : D * (1 - 3 * u) - 3 * eta <= p + q + r) by (unfold D; lra).
  assert (T3 : (D * (1 - 3 * u) - 3 * eta) * ((1 - u) * (1 - u)) <= (p + q + r) * ((1 - u) * (1 - u)))
    by (apply Rmult_le_compat_r; nra).
  assert (T4 : (p + q + r) * (1 - u) * (1 - u) <= (s + r) * (1 - u)) by (apply Rmult_le_compat_r; lra).
  assert (D * (1 - 5 * u) <= D * ((1 - 3 * u) * ((1 - u) * (1 - u)))) by (apply Rmult_le_compat_l; nra).
  assert (eta * ((1 - u) * (1 - u)) <= eta * 1) by (apply Rmult_le_compat_l; nra); lra.
Qed.

Lemma code_square_bound_at_most r : code_square_bound r <= r * r * (1 + 13.1 * u) + 10.2 * eta.
Proof.
  pose proof u_positive as U0; pose proof u_small as U; pose proof eta_positive as T0.
  assert (R0 : 0 <= r * r) by nra; destruct (fl_any_bounds _ R0) as [_ A]; pose proof (fl_nonneg _ R0) as A0.
  unfold code_square_bound, square_factor; set (s := fl (r * r)) in *.
  assert (B0 : 0 <= s * (1 + 10 * u)) by (apply Rmult_le_pos; lra).
  destruct (fl_any_bounds _ B0) as [_ B]; pose proof (fl_nonneg _ B0) as C0.
  set (t := fl (s * (1 + 10 * u))) in *.
  assert (D0 : 0 <= t + square_offset * (2 * eta)) by (unfold square_offset; lra).
  destruct (fl_plus_bounds t _ (fl_is_float _) square_offset_is_float D0) as [_ C].
  eapply Rle_trans; [exact C|]; unfold square_offset.
  assert (S : s * ((1 + 10 * u) * (1 + u) * (1 + u)) <= (r * r * (1 + u) + eta) * ((1 + 10 * u) * (1 + u) * (1 + u)))
    by (apply Rmult_le_compat_r; [nra|lra]).
  assert (V : t * (1 + u) <= (s * (1 + 10 * u) * (1 + u) + eta) * (1 + u)) by (apply Rmult_le_compat_r; lra).
  assert (K : (1 + u) * ((1 + 10 * u) * (1 + u) * (1 + u)) <= 1 + 13.1 * u) by (clear - U0 U; nra).
  assert (K2 : (1 + 10 * u) * (1 + u) * (1 + u) <= 1.01) by (clear - U0 U; nra).
  assert (r * r * ((1 + u) * ((1 + 10 * u) * (1 + u) * (1 + u))) <= r * r * (1 + 13.1 * u)) by (apply Rmult_le_compat_l; lra).
  assert (eta * ((1 + 10 * u) * (1 + u) * (1 + u)) <= eta * 1.01) by (apply Rmult_le_compat_l; lra).
  assert (eta * u <= eta * 0.01) by (apply Rmult_le_compat_l; lra); lra.
Qed.

Theorem kept_by_distance_is_near A B c r rho : valid A -> valid B -> float_box A -> float_box B ->
  (forall i, is_float (c i)) -> 0 <= r -> 0 <= rho -> 14 * eta <= rho * rho ->
  code_distance A B c <= code_square_bound r ->
  let reach := r * (1 + 9.2 * u) + rho in
  BallAgainstPlane.squared_distance_to_extent A B c <= reach * reach /\
  forall i, Rabs (c i) <= extent_magnitude A B i + reach.
Proof.
  intros wA wB FA FB Fc Hr Hrho Er H reach; pose proof u_positive as U0; pose proof u_small as U; pose proof eta_positive as T0.
  set (D := fun i => apart (Rmin (lo A i) (lo B i)) (Rmax (hi A i) (hi B i)) (c i)).
  assert (K : forall i, 0 <= D i /\ D i * (1 - u) <= extent_apart A B c i).
  { intro i; split; [apply Rmax_r|]; destruct (extent_sides_float A B i FA FB); apply code_apart_at_least; auto.
    pose proof (wA i); pose proof (Rmin_l (lo A i) (lo B i)); pose proof (Rmax_l (hi A i) (hi B i)); lra. }
  destruct (K X) as [X0 KX], (K Y) as [Y0 KY], (K Z) as [Z0 KZ].
  pose proof (code_squared_distance_at_least _ _ _ _ _ _ X0 Y0 Z0 KX KY KZ) as L.
  pose proof (code_square_bound_at_most r) as B'; unfold code_distance in H.
  set (S := D X * D X + D Y * D Y + D Z * D Z) in *.
  assert (R0 : 0 <= r * r) by nra; assert (S0 : 0 <= S) by (unfold S; nra).
  assert (S1 : S * (1 - 5 * u) <= r * r * (1 + 13.1 * u) + 13.2 * eta) by lra.
  assert (S2 : S <= r * r * (1 + 18.2 * u) + 13.3 * eta).
  { apply Rmult_le_reg_r with (1 - 5 * u); [lra|]; eapply Rle_trans; [exact S1|].
    assert (r * r * (1 + 13.1 * u) <= r * r * ((1 + 18.2 * u) * (1 - 5 * u))) by (apply Rmult_le_compat_l; nra).
    assert (13.3 * eta * 0.999 <= 13.3 * eta * (1 - 5 * u)) by (apply Rmult_le_compat_l; lra); lra. }
  assert (rr0 : 0 <= r * (1 + 9.2 * u)) by (apply Rmult_le_pos; lra).
  assert (S3 : S <= reach * reach).
  { unfold reach; eapply Rle_trans; [exact S2|].
    assert (r * r * (1 + 18.2 * u) <= r * r * ((1 + 9.2 * u) * (1 + 9.2 * u))) by (apply Rmult_le_compat_l; nra).
    assert (0 <= r * (1 + 9.2 * u) * rho) by (apply Rmult_le_pos; lra); lra. }
  assert (Q0 : 0 <= reach) by (unfold reach; lra).
  split.
  - eapply Rle_trans; [|exact S3]; right.
    unfold BallAgainstPlane.squared_distance_to_extent, BallDistance.sum_over_axes, BallDistance.distance_to_interval, S, D, apart.
    assert (M : forall a b, Rmax 0 (Rmax a b) = Rmax (Rmax a b) 0) by (intros; apply Rmax_comm); rewrite !M; ring.
  - intro i.
    assert (Di : D i <= reach).
    { apply Rsqr_incr_0_var; [|exact Q0]; unfold Rsqr; eapply Rle_trans; [|exact S3]; unfold S.
      pose proof (Rle_0_sqr (D X)); pose proof (Rle_0_sqr (D Y)); pose proof (Rle_0_sqr (D Z)); unfold Rsqr in *.
      destruct i; lra. }
    unfold D, apart in Di.
    set (l := Rmin (lo A i) (lo B i)) in *; set (h := Rmax (hi A i) (hi B i)) in *.
    pose proof (Rmax_l (Rmax (l - c i) (c i - h)) 0); pose proof (Rmax_l (l - c i) (c i - h)); pose proof (Rmax_r (l - c i) (c i - h)).
    unfold extent_magnitude; fold l h.
    pose proof (Rmax_l (Rabs l) (Rabs h)); pose proof (Rmax_r (Rabs l) (Rabs h)).
    pose proof (Rle_abs h); pose proof (Rle_abs (- l)) as Al; rewrite Rabs_Ropp in Al.
    apply Rabs_le; lra.
Qed.

(** A side of the extent box that does not accept the ball as inside. *)
Theorem refused_side_is_near c l r : is_float c -> is_float l -> 0 <= r ->
  fl (c - l) < fl (r * (1 + side_factor * u)) -> c - l < r * (1 + 6.2 * u) + 1.1 * eta.
Proof.
  intros Fc Fl Hr H; pose proof u_positive as U0; pose proof u_small as U; pose proof eta_positive as T0.
  assert (ru : 0 <= r * u) by (apply Rmult_le_pos; lra).
  destruct (Rle_lt_dec (c - l) 0) as [C|C]; [assert (0 <= r * (6.2 * u)) by lra; lra|].
  assert (P : 0 <= c - l) by lra.
  assert (Q : 0 <= r * (1 + side_factor * u)) by (unfold side_factor; lra).
  assert (Fo : is_float (- l)) by apply is_float_opp, Fl.
  destruct (fl_plus_bounds c (- l) Fc Fo P) as [L _]; destruct (fl_any_bounds _ Q) as [_ G]; unfold side_factor in *.
  change (c + - l) with (c - l) in L.
  apply Rnot_le_lt; intro K.
  assert (K1 : (r * (1 + 6.2 * u) + 1.1 * eta) * (1 - u) <= (c - l) * (1 - u)) by (apply Rmult_le_compat_r; lra).
  assert (K2 : r * ((1 + 4 * u) * (1 + u)) <= r * ((1 + 6.2 * u) * (1 - u)))
    by (apply Rmult_le_compat_l; [exact Hr|clear - U0 U; nra]).
  assert (eta * (1.1 * u) <= eta * 0.01) by (apply Rmult_le_compat_l; lra).
  lra.
Qed.

(** ** The whole test *)
Definition gap_per_radius : R := 32.
(** stated_gap.at(r) for one base: base + root first, then the radius. *)
Definition code_gap (base root r : R) : R := fl (fl (base + root) + fl (gap_per_radius * u * r)).

Lemma code_gap_at_least base root r : is_float base -> is_float root -> 0 <= base -> 0 <= root -> 0 <= r ->
  16 * eta <= root -> 0.9999 * base + 31 * u * r + 0.9 * root <= code_gap base root r.
Proof.
  intros Fb Fr B0 T0 R0 E; pose proof u_positive as U0; pose proof u_small as U; pose proof eta_positive as H0.
  assert (P : 0 <= base + root) by lra; pose proof (fl_sum_at_least base root B0 T0 Fb Fr); pose proof (fl_nonneg _ P).
  assert (Q : 0 <= gap_per_radius * u * r) by (unfold gap_per_radius; repeat apply Rmult_le_pos; lra).
  pose proof (fl_at_least _ Q); pose proof (fl_nonneg _ Q).
  unfold code_gap; set (p := fl (base + root)) in *; set (q := fl (gap_per_radius * u * r)) in *.
  assert (0 <= p) by assumption; assert (0 <= q) by assumption.
  pose proof (fl_sum_at_least p q ltac:(assumption) ltac:(assumption) (fl_is_float _) (fl_is_float _)).
  unfold gap_per_radius in *; assert (0 <= u * r) by (apply Rmult_le_pos; lra); lra.
Qed.

Definition plane_base (A B : box) (f g : face) : R :=
  let p := form_ball_plane A B f g in
  let x := extent_magnitude A B (fst f) in let y := extent_magnitude A B (fst g) in
  code_base (outside_at p) (inside_at p) (product_sum (Rabs (m0 p)) x (Rabs (m1 p)) y) (code_underflow x y).

Theorem kept_ball_grown_is_kept A B c r base root :
  valid A -> valid B -> float_box A -> float_box B -> (forall i, is_float (c i)) -> is_float r ->
  0 <= r <= code_largest_safe -> is_float base -> is_float root -> 0 <= base -> 16 * eta <= root -> 20 * eta <= root * root ->
  (forall f g, fst f <> fst g -> extreme A B f -> extreme B A g ->
     decides (form_ball_plane A B f g) = true /\ plane_base A B f g <= base) ->
  certified_ball_test A B c r <> outside ->
  ~ BallAgainstPlane.sphere_test_says_outside A B c (r + code_gap base root r).
Proof.
  intros wA wB FA FB Fc Fr [Hr Hr'] Fb Fro B0 E1 E2 G H.
  pose proof u_positive as U0; pose proof u_small as U; pose proof eta_positive as T0.
  unfold certified_ball_test in H; cbv zeta in H.
  destruct (negb (le_bool (code_distance A B c) (code_square_bound r))) eqn:D; [congruence|].
  apply negb_false_iff, le_bool_is in D.
  assert (Lr : negb (le_bool r code_largest_safe) = false) by (apply negb_false_iff, le_bool_is; exact Hr').
  rewrite Lr in H; clear Lr.
  destruct existsb eqn:O in H; [congruence|clear H].
  set (rho := 0.9 * root).
  assert (rho0 : 0 <= rho) by (unfold rho; lra).
  assert (rho2 : 14 * eta <= rho * rho) by (unfold rho; lra).
  assert (root0 : 0 <= root) by lra.
  destruct (kept_by_distance_is_near A B c r rho wA wB FA FB Fc Hr rho0 rho2 D) as [Q K]; cbv zeta in K.
  pose proof (code_gap_at_least base root r Fb Fro B0 root0 Hr E1) as CG; fold rho in CG.
  assert (ur : 0 <= u * r) by (apply Rmult_le_pos; lra).
  set (reach := r * (1 + 9.2 * u) + rho) in *.
  assert (reach0 : 0 <= reach <= r * 1.001 + rho).
  { unfold reach; split; [|assert (u * r <= / 16777216 * r) by (apply Rmult_le_compat_r; lra); lra].
    assert (0 <= r * (1 + 9.2 * u)) by (apply Rmult_le_pos; lra); lra. }
  intros [S|[f [g [N [Ef [Eg S]]]]]].
  - assert (reach <= r + code_gap base root r) by (unfold reach; lra).
    assert (reach * reach <= (r + code_gap base root r) * (r + code_gap base root r)) by (apply Rmult_le_compat; lra).
    lra.
  - destruct (G f g N Ef Eg) as [De Ba].
    destruct (shortened_plane_is_short A B f g _ _ wA wB FA FB N Ef Eg (shorten_can_always_scale A B f g FA FB Ef Eg))
      as [cc [d0 [d1 [t0 [t1 M]]]]].
    pose proof (shorten_can_always_scale A B f g FA FB Ef Eg) as PS; cbv zeta in PS.
    assert (safe : bpow radix2 (- safe_exponent) <=
       Rmax (Rabs (code_prescale (code_n0 A B f g) (code_n1 A B f g) (code_n0 A B f g)))
            (Rabs (code_prescale (code_n0 A B f g) (code_n1 A B f g) (code_n1 A B f g))) <= bpow radix2 safe_exponent).
    { assert (Sg : forall h z, is_float z -> is_float (sgn h * z)).
      { intros [i []] z Fz; unfold sgn, snd; [|rewrite Rmult_1_l; exact Fz].
        replace (-1 * z) with (- z) by ring; apply is_float_opp, Fz. }
      destruct (prescaled_is_safe _ _ _ _ (Sg f _ (is_float_abs _ (fl_is_float _))) (Sg g _ (is_float_abs _ (fl_is_float _))) PS)
        as [k [_ [_ SS]]]; exact SS. }
    pose proof (shortened_is_long _ _ safe) as Lo.
    assert (V : ball_value (form_ball_plane A B f g) f g c <= fl (r + outside_at (form_ball_plane A B f g))).
    { apply le_bool_is; destruct le_bool eqn:LB; [reflexivity|exfalso].
      assert (X : existsb (fun fg => decides (form_ball_plane A B (fst fg) (snd fg)) &&
        negb (le_bool (ball_value (form_ball_plane A B (fst fg) (snd fg)) (fst fg) (snd fg) c)
          (fl (r + outside_at (form_ball_plane A B (fst fg) (snd fg)))))) (plane_pairs A B) = true); [|congruence].
      apply existsb_exists; exists (f, g); split; [apply plane_pairs_are; auto|simpl fst; simpl snd; rewrite De, LB; reflexivity]. }
    pose proof (kept_ball_is_near A B f g _ _ cc d0 d1 t0 t1 wA wB FA FB M Lo c r reach rho Hr Fr rho0 reach0
                  (K (fst f)) (K (fst g)) V) as R.
    cbv zeta in S; pose proof (true_value_is_the_plane A B f g c N) as TV.
    change (true_value A B f g (c (fst f)) (c (fst g)) <=
            (r + (0.9999 * plane_base A B f g + 31 * u * r + rho)) *
            sqrt (true_n0 A B f g * true_n0 A B f g + true_n1 A B f g * true_n1 A B f g)) in R; rewrite TV in R.
    set (n0 := true_n0 A B f g) in *; set (n1 := true_n1 A B f g) in *.
    assert (LN : BallAgainstPlane.length (normal (edge_plane A B f g)) = sqrt (n0 * n0 + n1 * n1)).
    { unfold BallAgainstPlane.length; f_equal; rewrite dot_edge_plane by exact N; unfold n0, n1, true_n0, true_n1, edge_plane.
      clear - N; destruct f as [[] []], g as [[] []]; cbv [sgn coord fst snd normal axis_eqb] in *; try congruence; ring. }
    rewrite LN in S.
    pose proof (sqrt_pos (n0 * n0 + n1 * n1)).
    assert ((r + (0.9999 * plane_base A B f g + 31 * u * r + rho)) * sqrt (n0 * n0 + n1 * n1) <=
            (r + code_gap base root r) * sqrt (n0 * n0 + n1 * n1)) by (apply Rmult_le_compat_r; lra).
    lra.
Qed.
End Distance.
