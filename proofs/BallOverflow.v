(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * Overflow of a ball's plane value does no harm

    The centre of a ball may lie anywhere, so the value can overflow to plus infinity, and the ball is culled then.
    [huge_value_is_beyond]: the value of unbounded range is in that case far above r + outside too. Overflow to minus
    infinity culls nothing. [ball_overflow_culls_rightly]: so, for every plane that decides, a cull with overflow is one
    of CertifiedBallTest.v, which proves it right. *)
Require Import Reals Lra Psatz ZArith List Bool Lia.
Require Import Flocq.Core.Core.
Require Import Gnomon.Boxes Gnomon.PlaneSet Gnomon.BoxTest.
Require Import Gnomon.RoundingModel Gnomon.PlaneError Gnomon.BoxTestCertified Gnomon.ShortenedNormal.
Require Import Gnomon.BallThreshold Gnomon.BallTestCertified Gnomon.ShortenedPlane Gnomon.Prescale.
Require Import Gnomon.Overflow Gnomon.CertifiedBoxTest Gnomon.CertifiedBallTest.
Open Scope R_scope.

Section BallOverflow.
Context {F : Format}.

(** Products with a component of a shortened normal, which is at most 1, don't overflow. *)
Lemma product_at_most m v : Rabs m <= 1 -> is_float v -> Rabs (fl (m * v)) <= Rabs v.
Proof.
  intros Hm Fv; pose proof (fl_of_float (Rabs v) (is_float_abs v Fv)) as E.
  rewrite <- fl_abs, <- E; apply fl_le; rewrite Rabs_mult.
  pose proof (Rabs_pos v); rewrite <- (Rmult_1_l (Rabs v)) at 2; apply Rmult_le_compat_r; lra.
Qed.

Lemma delivered_cases z : (delivered z = Number (fl z) /\ Rabs (fl z) < range) \/
  (delivered z = Infinite true /\ range <= fl z) \/ (delivered z = Infinite false /\ fl z <= - range).
Proof.
  unfold delivered; destruct Rlt_dec as [L|L]; [left; auto|right].
  assert (R0 : 0 < range) by apply bpow_gt_0; apply Rnot_lt_le in L.
  destruct Rlt_dec as [P|P]; [left|right]; (split; [reflexivity|]).
  - assert (0 <= fl z) by (apply fl_nonneg; lra); rewrite Rabs_pos_eq in L; lra.
  - assert (fl z <= 0) by (rewrite <- fl_0; apply fl_le; lra); rewrite Rabs_left1 in L; lra.
Qed.

Lemma as_large_as k z : (0 <= k <= 8)%Z -> bpow radix2 (emax - k) <= z -> bpow radix2 (emax - k) <= fl z.
Proof.
  intros Hk H; rewrite <- (fl_of_float (bpow radix2 (emax - k))); [apply fl_le, H|].
  apply is_float_bpow; generalize range_is_ieee prec_at_least_24 range_is_large; lia.
Qed.

Theorem huge_value_is_beyond m0 m1 d x y r threshold :
  Rabs m0 <= 1 -> Rabs m1 <= 1 -> is_float x -> is_float y -> Rabs x < range -> Rabs y < range ->
  Rabs d <= 2 * largest_safe -> 0 <= r <= largest_safe -> 0 <= threshold <= largest_safe ->
  ieee_add (Number r) (Number threshold) = Number (fl (r + threshold)) /\
  (above (ieee_value m0 m1 d x y) (fl (r + threshold)) -> plane_value m0 m1 d x y > fl (r + threshold)).
Proof.
  intros H0 H1 Fx Fy Rx Ry Hd Hr Ht; pose proof safe_positive as S; pose proof range_is as R.
  assert (B : 0 <= fl (r + threshold) <= 2 * largest_safe) by (split; [apply fl_nonneg|apply fl_at_most_2]; lra).
  split; [simpl; apply delivered_as_it_is; rewrite Rabs_pos_eq; lra|intro H].
  pose proof (product_at_most m0 x H0 Fx); pose proof (product_at_most m1 y H1 Fy).
  unfold ieee_value, ieee_mul in H; unfold plane_value.
  destruct (delivered_cases (m0 * x)) as [[E0 _]|[[_ E0]|[_ E0]]];
  [|pose proof (Rle_abs (fl (m0 * x))); lra|pose proof (Rle_abs (- fl (m0 * x))) as Q; rewrite Rabs_Ropp in Q; lra].
  destruct (delivered_cases (m1 * y)) as [[E1 _]|[[_ E1]|[_ E1]]];
  [|pose proof (Rle_abs (fl (m1 * y))); lra|pose proof (Rle_abs (- fl (m1 * y))) as Q; rewrite Rabs_Ropp in Q; lra].
  rewrite E0, E1 in H; simpl in H; apply Rabs_le_inv in Hd.
  set (s := fl (m0 * x) + fl (m1 * y)) in *.
  destruct (delivered_cases s) as [[E2 _]|[[E2 L2]|[E2 L2]]]; rewrite E2 in H; simpl in H; try discriminate.
  - destruct (delivered_cases (fl s + d)) as [[E3 _]|[[E3 L3]|[E3 L3]]]; rewrite E3 in H; simpl in H;
    try discriminate; [exact H|lra].
  - assert (E4 : bpow radix2 (emax - 6) = 4 * largest_safe).
    { unfold largest_safe; replace (emax - 6)%Z with (2 + (emax - 8))%Z by lia.
      rewrite bpow_plus; change (bpow radix2 2) with 4; ring. }
    pose proof (as_large_as 6 (fl s + d)) as P; rewrite E4 in P.
    assert (4 * largest_safe <= fl (fl s + d)) by (apply P; [lia|lra]); lra.
Qed.

(** ** The planes that set_ball_threshold lets decide meet these conditions *)
Lemma fl_at_most z : 0 <= z -> fl z <= z * 1.0000001 + eta.
Proof.
  intro H; destruct (fl_any_bounds z H) as [_ L]; pose proof u_small.
  assert (z * (1 + u) <= z * 1.0000001) by (apply Rmult_le_compat_l; lra); lra.
Qed.

Theorem deciding_ball_plane_is_small A B f g :
  valid A -> valid B -> float_box A -> float_box B -> fst f <> fst g -> extreme A B f -> extreme B A g ->
  let p := form_ball_plane A B f g in decides p = true ->
  Rabs (m0 p) <= 1 /\ Rabs (m1 p) <= 1 /\ Rabs (offset_d p) <= 2 * largest_safe /\ 0 <= outside_at p <= largest_safe.
Proof.
  intros wA wB FA FB N Ef Eg p D; unfold p, form_ball_plane, decides in D; apply le_bool_is in D.
  destruct (shortened_plane_is_short A B f g _ _ wA wB FA FB N Ef Eg (shorten_can_always_scale A B f g FA FB Ef Eg))
    as [c [d0 [d1 [t0 [t1 M]]]]].
  set (x := extent_magnitude A B (fst f)) in *; set (y := extent_magnitude A B (fst g)) in *.
  set (n0 := code_n0 A B f g) in *; set (n1 := code_n1 A B f g) in *.
  unfold p, form_ball_plane; fold x y n0 n1; simpl.
  set (s0 := code_prescale n0 n1 n0) in *; set (s1 := code_prescale n0 n1 n1) in *.
  set (m0 := code_m s0 s1 s0) in *; set (m1 := code_m s0 s1 s1) in *.
  pose proof u_positive as U0; pose proof u_small as U; pose proof eta_positive as T0; pose proof eta_small as Et.
  assert (SQ : bpow radix2 0 <= largest_safe)
    by (apply bpow_le; generalize range_is_large prec_at_least_24; lia); simpl in SQ.
  pose proof (short _ _ _ _ _ _ _ _ _ _ _ M) as Sh; unfold ball_shortening in Sh.
  assert (M0 : Rabs m0 <= 1).
  { pose proof (Sh 1 0 1 ltac:(lra) ltac:(lra)) as K; rewrite Rabs_R0, Rabs_R1 in K; lra. }
  assert (M1 : Rabs m1 <= 1).
  { pose proof (Sh 0 1 1 ltac:(lra) ltac:(lra)) as K; rewrite Rabs_R0, Rabs_R1 in K; lra. }
  destruct (largest_safe_bounds) as [LS _].
  assert (x0 : 0 <= x) by apply magnitude_not_negative; assert (y0 : 0 <= y) by apply magnitude_not_negative.
  assert (Fx : is_float x) by (apply extent_magnitude_float; auto).
  assert (Fy : is_float y) by (apply extent_magnitude_float; auto).
  assert (XY : x + y <= largest_safe * 1.0000002).
  { assert (P : 0 <= x + y) by lra; destruct (fl_plus_bounds x y Fx Fy P) as [L _].
    assert ((x + y) * 0.9999999 <= (x + y) * (1 - u)) by (apply Rmult_le_compat_l; lra); lra. }
  assert (CM : forall b h, b = A \/ b = B -> Rabs (coord b h) <= extent_magnitude A B (fst h)).
  { intros b h E; apply extent_magnitude_covers, coord_in_extent; auto. }
  pose proof (CM A f (or_introl eq_refl)) as A0; pose proof (CM A g (or_introl eq_refl)) as A1.
  pose proof (CM B f (or_intror eq_refl)) as B0; pose proof (CM B g (or_intror eq_refl)) as B1.
  fold x in A0, B0; fold y in A1, B1.
  (* products and sums of products *)
  assert (PS : forall a b v w, 0 <= a <= 1 -> 0 <= b <= 1 -> 0 <= v -> 0 <= w ->
            0 <= product_sum a v b w <= (v + w) * 1.0000003 + 4 * eta).
  { intros a b v w Ha Hb Hv Hw.
    assert (Q0 : 0 <= a * v <= v) by (split; [apply Rmult_le_pos; lra|]; rewrite <- (Rmult_1_l v) at 2; apply Rmult_le_compat_r; lra).
    assert (Q1 : 0 <= b * w <= w) by (split; [apply Rmult_le_pos; lra|]; rewrite <- (Rmult_1_l w) at 2; apply Rmult_le_compat_r; lra).
    pose proof (fl_at_most _ (proj1 Q0)); pose proof (fl_at_most _ (proj1 Q1)).
    pose proof (fl_nonneg _ (proj1 Q0)); pose proof (fl_nonneg _ (proj1 Q1)).
    unfold product_sum; split; [apply fl_nonneg; lra|].
    assert (Q2 : 0 <= fl (a * v) + fl (b * w)) by lra; pose proof (fl_at_most _ Q2); lra. }
  assert (W0 : 0 <= Rabs m0 <= 1) by (split; [apply Rabs_pos|exact M0]).
  assert (W1 : 0 <= Rabs m1 <= 1) by (split; [apply Rabs_pos|exact M1]).
  split; [exact M0|split; [exact M1|split]].
  - (* the offset *)
    pose proof (plane_d_error m0 m1 (coord A f) (coord A g)) as E.
    assert (V : Rabs m0 * Rabs (coord A f) + Rabs m1 * Rabs (coord A g) <= x + y).
    { apply Rplus_le_compat; [rewrite <- (Rmult_1_l x)|rewrite <- (Rmult_1_l y)];
      apply Rmult_le_compat; try apply Rabs_pos; lra. }
    set (V0 := Rabs m0 * Rabs (coord A f) + Rabs m1 * Rabs (coord A g)) in *.
    assert (V1 : 0 <= V0) by (unfold V0; apply Rplus_le_le_0_compat; apply Rmult_le_pos; apply Rabs_pos).
    assert (2.0000001 * u * V0 <= 0.000001 * V0) by (apply Rmult_le_compat_r; lra).
    assert (V2 : Rabs (m0 * coord A f + m1 * coord A g) <= V0)
      by (eapply Rle_trans; [apply Rabs_triang|]; rewrite !Rabs_mult; unfold V0; lra).
    pose proof (Rabs_triang (plane_d m0 m1 (coord A f) (coord A g) + (m0 * coord A f + m1 * coord A g))
                            (- (m0 * coord A f + m1 * coord A g))) as T; rewrite Rabs_Ropp in T.
    replace (plane_d m0 m1 (coord A f) (coord A g) + (m0 * coord A f + m1 * coord A g) + - (m0 * coord A f + m1 * coord A g))
      with (plane_d m0 m1 (coord A f) (coord A g)) in T by ring; lra.
  - unfold code_outside, ball_outside_p, ball_outside_d, ball_outside_b.
    pose proof (PS _ _ x y W0 W1 x0 y0) as P.
    pose proof (PS _ _ _ _ W0 W1 (Rabs_pos (coord A f)) (Rabs_pos (coord A g))) as DD.
    pose proof (PS _ _ _ _ W0 W1 (Rabs_pos (fl (coord B f - coord A f))) (Rabs_pos (fl (coord B g - coord A g)))) as BB.
    assert (G : forall b a w, Rabs b <= w -> Rabs a <= w -> Rabs (fl (b - a)) <= 2 * w * 1.0000001 + eta).
    { intros b a w Hb Ha; rewrite <- fl_abs; eapply Rle_trans; [apply fl_at_most, Rabs_pos|].
      assert (Rabs (b - a) <= 2 * w) by (unfold Rminus; eapply Rle_trans; [apply Rabs_triang|rewrite Rabs_Ropp; lra]); lra. }
    pose proof (G _ _ _ B0 A0); pose proof (G _ _ _ B1 A1).
    set (P' := product_sum (Rabs m0) x _ y) in *; set (D' := product_sum _ (Rabs (coord A f)) _ _) in *.
    set (B' := product_sum _ (Rabs (fl (coord B f - coord A f))) _ _) in *.
    assert (q1 : 0 <= 3 * P') by lra; assert (q2 : 0 <= 3 * D') by lra; assert (q3 : 0 <= 2 * B') by lra.
    pose proof (fl_at_most _ q1); pose proof (fl_at_most _ q2); pose proof (fl_at_most _ q3).
    pose proof (fl_nonneg _ q1); pose proof (fl_nonneg _ q2); pose proof (fl_nonneg _ q3).
    assert (q4 : 0 <= fl (3 * P') + fl (3 * D')) by lra; pose proof (fl_at_most _ q4); pose proof (fl_nonneg _ q4).
    assert (q5 : 0 <= fl (fl (3 * P') + fl (3 * D')) + fl (2 * B')) by lra; pose proof (fl_at_most _ q5); pose proof (fl_nonneg _ q5).
    set (T := fl (fl (fl (3 * P') + fl (3 * D')) + fl (2 * B'))) in *.
    assert (T1 : T <= 11 * largest_safe) by lra.
    assert (I : 0 <= fl (fl inflate * u) <= 0.001).
    { assert (i0 : 0 <= inflate) by (unfold inflate; lra); pose proof (fl_at_most _ i0); pose proof (fl_nonneg _ i0).
      assert (i1 : fl inflate <= 2) by (unfold inflate in *; lra).
      assert (i2 : 0 <= fl inflate * u) by (apply Rmult_le_pos; lra); pose proof (fl_at_most _ i2).
      assert (fl inflate * u <= 2 * / 16777216) by (apply Rmult_le_compat; lra).
      split; [apply fl_nonneg; exact i2|lra]. }
    set (iu := fl (fl inflate * u)) in *.
    assert (q6 : 0 <= iu * T <= 0.001 * (11 * largest_safe)) by (split; [apply Rmult_le_pos|apply Rmult_le_compat]; lra).
    pose proof (fl_at_most _ (proj1 q6)); pose proof (fl_nonneg _ (proj1 q6)).
    assert (UF : 0 <= code_underflow x y <= 0.1 * largest_safe).
    { unfold code_underflow; assert (c0 : 0 <= 1 + x) by lra; pose proof (fl_at_most _ c0); pose proof (fl_nonneg _ c0).
      assert (c1 : 0 <= fl (1 + x) + y) by lra; pose proof (fl_at_most _ c1); pose proof (fl_nonneg _ c1).
      assert (SN : 0 < smallest_normal <= 0.001).
      { split; [apply bpow_gt_0|]; apply Rle_trans with (bpow radix2 (-10)); [|simpl; lra].
        unfold smallest_normal; apply bpow_le; generalize range_is_ieee range_is_large prec_at_least_24; lia. }
      set (w := fl (fl (1 + x) + y)) in *; assert (w1 : w <= 4 * largest_safe) by lra.
      assert (c2 : 0 <= smallest_normal * w <= 0.001 * (4 * largest_safe)) by (split; [apply Rmult_le_pos|apply Rmult_le_compat]; lra).
      pose proof (fl_at_most _ (proj1 c2)); split; [apply fl_nonneg; lra|lra]. }
    set (v := fl (iu * T)) in *; assert (q7 : 0 <= v + code_underflow x y) by lra.
    pose proof (fl_at_most _ q7); split; [apply fl_nonneg; exact q7|lra].
Qed.

Theorem ball_overflow_culls_rightly A B f g c r :
  valid A -> valid B -> float_box A -> float_box B -> fst f <> fst g -> extreme A B f -> extreme B A g ->
  (forall i, is_float (c i) /\ Rabs (c i) < range) -> 0 <= r <= code_largest_safe ->
  let p := form_ball_plane A B f g in decides p = true ->
  greater (ieee_value (m0 p) (m1 p) (offset_d p) (c (fst f)) (c (fst g)))
          (ieee_add (Number r) (Number (outside_at p))) = true ->
  ball_value p f g c > fl (r + outside_at p).
Proof.
  intros wA wB FA FB N Ef Eg Fc Hr p D H.
  destruct (deciding_ball_plane_is_small A B f g wA wB FA FB N Ef Eg D) as [M0 [M1 [Hd Ho]]]; fold p in M0, M1, Hd, Ho.
  destruct (largest_safe_bounds) as [LS _].
  assert (Hr' : 0 <= r <= largest_safe) by lra.
  destruct (Fc (fst f)) as [F0 R0], (Fc (fst g)) as [F1 R1].
  destruct (huge_value_is_beyond _ _ _ _ _ _ _ M0 M1 F0 F1 R0 R1 Hd Hr' Ho) as [E K].
  apply K; rewrite E in H; unfold above; destruct ieee_value as [v|[]|]; simpl in H; try discriminate; [|reflexivity].
  destruct Rlt_dec as [L|]; [exact L|discriminate].
Qed.
End BallOverflow.
