(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * From form_plane through shorten() to the ball's plane

    Puts the pieces together: the normal that form_plane computes, scaled by a power of two where its larger component
    is out of the safe range, then shortened, has all properties that BallTestCertified.v asks for. *)
Require Import Reals Lra Psatz ZArith Lia.
Require Import Flocq.Core.Core Flocq.Prop.Mult_error.
Require Import Gnomon.Boxes Gnomon.PlaneSet Gnomon.BoxTest.
Require Import Gnomon.RoundingModel Gnomon.PlaneError Gnomon.BoxTestCertified Gnomon.ShortenedNormal.
Require Import Gnomon.BallThreshold Gnomon.BallTestCertified.
Open Scope R_scope.

Section Scaling.
Context {F : Format}.

(** scalbn: a power of two times the number, rounded; in error by at most eta. *)
Definition scalbn (n : R) (e : BinNums.Z) : R := fl (n * bpow radix2 e).

Lemma scalbn_error n e : is_float n -> Rabs (scalbn n e - n * bpow radix2 e) <= eta.
Proof.
  intro Fn; pose proof eta_positive as T0.
  assert (P : Prec_gt_0 prec) by (unfold Prec_gt_0; generalize prec_at_least_24; lia).
  destruct (Z_le_gt_dec (emin + prec - mag radix2 n) e) as [L|L].
  - unfold scalbn; rewrite fl_of_float; [rewrite Rminus_diag_eq by reflexivity; rewrite Rabs_R0; lra|].
    apply (mult_bpow_exact_FLT radix2 emin prec); auto.
  - destruct (Req_dec n 0) as [->|N].
    { unfold scalbn; rewrite Rmult_0_l, fl_0, Rminus_0_r, Rabs_R0; lra. }
    (* denormal: half of the smallest step *)
    unfold scalbn, fl; eapply Rle_trans; [apply error_le_half_ulp; apply FLT_exp_valid; exact P|].
    assert (U : ulp radix2 format_exp (n * bpow radix2 e) = bpow radix2 emin); [apply ulp_FLT_small; [exact P|]|rewrite U].
    2: { unfold eta; replace emin with (1 + (emin - 1))%Z at 1 by lia; rewrite bpow_plus.
      change (bpow radix2 1) with 2; lra. }
    rewrite Rabs_mult, (Rabs_pos_eq (bpow radix2 e)) by apply bpow_ge_0.
    apply Rlt_le_trans with (bpow radix2 (mag radix2 n) * bpow radix2 e).
    + apply Rmult_lt_compat_r; [apply bpow_gt_0|apply bpow_mag_gt].
    + rewrite <- bpow_plus; apply bpow_le; lia.
Qed.

(** What shorten() does before it takes the length: nothing within the safe range, else a scaling that brings the
    larger component to between 1 and 2. *)
Inductive prescaled (n0 n1 : R) : R -> R -> Prop :=
| as_it_is : bpow radix2 (- safe_exponent) <= Rmax (Rabs n0) (Rabs n1) <= bpow radix2 safe_exponent ->
    prescaled n0 n1 n0 n1
| to_one e : 1 <= Rmax (Rabs (scalbn n0 e)) (Rabs (scalbn n1 e)) <= 2 ->
    prescaled n0 n1 (scalbn n0 e) (scalbn n1 e).

Lemma prescaled_is_safe n0 n1 n0' n1' : is_float n0 -> is_float n1 -> prescaled n0 n1 n0' n1' ->
  exists k, scaled_safely k n0 n1 n0' n1'.
Proof.
  intros F0 F1 [S|e S]; pose proof eta_positive as T0.
  - exists 1; split; [lra|split; [|exact S]].
    exists 0, 0; rewrite Rabs_R0; repeat split; try lra; left; auto.
  - exists (bpow radix2 e); split; [apply bpow_gt_0|split].
    + exists (scalbn n0 e - n0 * bpow radix2 e), (scalbn n1 e - n1 * bpow radix2 e).
      repeat split; try (apply scalbn_error; assumption); try ring; right; apply S.
    + split.
      * eapply Rle_trans; [|apply S]; change 1 with (bpow radix2 0); apply bpow_le.
        generalize safe_exponent_positive; lia.
      * eapply Rle_trans; [apply S|]; change 2 with (bpow radix2 1); apply bpow_le.
        generalize safe_exponent_positive; lia.
Qed.

Lemma outward_kept s n n' : (s = 1 \/ s = -1) -> (n' = n \/ exists e, n' = scalbn n e) ->
  0 <= s * n -> 0 <= s * n'.
Proof.
  intros Hs [->|[e ->]] H; [exact H|]; unfold scalbn.
  pose proof (bpow_gt_0 radix2 e) as K; set (k := bpow radix2 e) in *; clearbody k.
  destruct Hs as [-> | ->].
  - rewrite Rmult_1_l in *; apply fl_nonneg, Rmult_le_pos; lra.
  - replace (-1 * fl (n * k)) with (fl (- n * k)); [apply fl_nonneg, Rmult_le_pos; lra|].
    replace (- n * k) with (- (n * k)) by ring; rewrite fl_opp; ring.
Qed.

Theorem shortened_plane_is_short A B f g n0 n1 :
  valid A -> valid B -> float_box A -> float_box B -> fst f <> fst g -> extreme A B f -> extreme B A g ->
  prescaled (code_n0 A B f g) (code_n1 A B f g) n0 n1 ->
  exists c d0 d1 t0 t1, short_normal A B f g (code_m n0 n1 n0) (code_m n0 n1 n1) c d0 d1 t0 t1.
Proof.
  intros wA wB FA FB N Ef Eg S.
  destruct (code_normal A B f g FA FB N Ef Eg) as [e0 [e1 [H0 [H1 [E0 E1]]]]].
  assert (sgn_cases : forall h, sgn h = 1 \/ sgn h = -1) by (intros [i []]; cbv; auto).
  assert (Fs : forall h z, is_float z -> is_float (sgn h * z)).
  { intros h z Fz; destruct (sgn_cases h) as [-> | ->]; [rewrite Rmult_1_l; exact Fz|].
    replace (-1 * z) with (- z) by ring; apply is_float_opp, Fz. }
  assert (F0 : is_float (code_n0 A B f g)) by (apply Fs, is_float_abs, fl_is_float).
  assert (F1 : is_float (code_n1 A B f g)) by (apply Fs, is_float_abs, fl_is_float).
  destruct (prescaled_is_safe _ _ _ _ F0 F1 S) as [k K].
  assert (SC : 0 <= code_scale n0 n1) by (destruct K as [_ [_ K]]; apply (code_scale_bounds n0 n1 K)).
  assert (O : forall h n z, n = sgn h * Rabs z -> forall n', (n' = n \/ exists e, n' = scalbn n e) ->
            0 <= sgn h * code_m n0 n1 n').
  { intros h n z En n' Hn'; pose proof (Rabs_pos z).
    assert (On : 0 <= sgn h * n) by (rewrite En; destruct (sgn_cases h) as [-> | ->]; lra).
    pose proof (outward_kept (sgn h) n n' (sgn_cases h) Hn' On) as P.
    unfold code_m; destruct (sgn_cases h) as [R|R]; rewrite R in *.
    - rewrite Rmult_1_l in *; apply fl_nonneg, Rmult_le_pos; lra.
    - replace (-1 * fl (n' * code_scale n0 n1)) with (fl (- n' * code_scale n0 n1));
      [apply fl_nonneg, Rmult_le_pos; lra|].
      replace (- n' * code_scale n0 n1) with (- (n' * code_scale n0 n1)) by ring; rewrite fl_opp; ring. }
  assert (C0 : n0 = code_n0 A B f g \/ exists e, n0 = scalbn (code_n0 A B f g) e) by (destruct S; eauto).
  assert (C1 : n1 = code_n1 A B f g \/ exists e, n1 = scalbn (code_n1 A B f g) e) by (destruct S; eauto).
  pose proof (O f _ _ eq_refl n0 C0) as O0; pose proof (O g _ _ eq_refl n1 C1) as O1.
  rewrite E0, E1 in K.
  destruct (shorten_is_short _ _ _ _ _ _ _ H0 H1 K) as [Sh [c [d0 [d1 [t0 [t1 [? [? [? [? [? [? [? ?]]]]]]]]]]]]].
  exists c, d0, d1, t0, t1; constructor; auto.
Qed.

(** The two statements about code that starts from boxes. *)
Section Certified.
Variables (A B : box) (f g : face) (n0 n1 : R).
Hypotheses (wA : valid A) (wB : valid B) (FA : float_box A) (FB : float_box B)
           (N : fst f <> fst g) (Ef : extreme A B f) (Eg : extreme B A g)
           (S : prescaled (code_n0 A B f g) (code_n1 A B f g) n0 n1).
Let m0 := code_m n0 n1 n0. Let m1 := code_m n0 n1 n1.
Let value (z : point) := plane_value m0 m1 (plane_d m0 m1 (coord A f) (coord A g)) (z (fst f)) (z (fst g)).
Let x := extent_magnitude A B (fst f). Let y := extent_magnitude A B (fst g).

Theorem certified_ball_cull_is_right z r : 0 <= r -> is_float r ->
  value z > fl (r + code_outside m0 m1 (coord A f) (coord A g) (coord B f) (coord B g) x y) ->
  ~ exists p, hull A B p /\ within_ball z r p.
Proof.
  destruct (shortened_plane_is_short A B f g n0 n1) as [c [d0 [d1 [t0 [t1 M]]]]]; auto.
  intros; eapply ball_cull_is_right; eauto.
Qed.

Theorem certified_ball_is_behind z r : 0 <= r -> is_float r -> in_extent A B z ->
  value z <= fl (- code_inside m0 m1 (coord A f) (coord A g) x y - r) ->
  forall p, within_ball z r p -> dot (normal (edge_plane A B f g)) p <= offset (edge_plane A B f g).
Proof.
  destruct (shortened_plane_is_short A B f g n0 n1) as [c [d0 [d1 [t0 [t1 M]]]]]; auto.
  intros Hr Fr E V; eapply ball_behind_plane_is_right; eauto.
Qed.
End Certified.
End Scaling.
