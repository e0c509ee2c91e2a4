(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * Rounded arithmetic, for float32 and float64 at once

    A format is a precision and a smallest exponent (Flocq's FLT). [fl] rounds to nearest, ties to even, with
    gradual underflow and an unbounded range; what overflow does is treated apart, in Overflow.v. [u] is the unit
    roundoff and [eta] half of the smallest denormal, as in fast/strict_float.h. *)
Require Import Reals Lra Psatz ZArith Lia.
Require Import Flocq.Core.Core Flocq.Prop.Relative Flocq.Prop.Plus_error.
Open Scope R_scope.

(** [safe_exponent]: numbers between 2^-safe and 2^safe can be squared, and lose nothing that matters to underflow. *)
Class Format := {
  prec : Z;
  emin : Z;
  emax : Z;
  safe_exponent : Z;
  prec_at_least_24 : (24 <= prec)%Z;
  range_is_ieee : (emin = 3 - emax - prec)%Z;
  range_is_large : (4 * prec <= emax)%Z;
  safe_exponent_positive : (1 <= safe_exponent)%Z;
  squares_are_safe : (emin + 2 * safe_exponent + 2 * prec + 8 <= 0)%Z
}.

(** What C++ calls float and double on every machine that gnomon runs on. *)
Program Definition float32 : Format := {| prec := 24; emin := -149; emax := 128; safe_exponent := 40 |}.
Solve All Obligations with (simpl; lia).
Program Definition float64 : Format := {| prec := 53; emin := -1074; emax := 1024; safe_exponent := 300 |}.
Solve All Obligations with (simpl; lia).

Section Rounding.
Context {F : Format}.

#[local] Instance prec_positive : Prec_gt_0 prec.
Proof. unfold Prec_gt_0; generalize prec_at_least_24; lia. Qed.

Definition format_exp := FLT_exp emin prec.
Definition fl (x : R) : R := round radix2 format_exp ZnearestE x.
Definition is_float (x : R) : Prop := generic_format radix2 format_exp x.
Definition u : R := bpow radix2 (- prec).
Definition eta : R := bpow radix2 (emin - 1).

Lemma u_positive : 0 < u. Proof. apply bpow_gt_0. Qed.
Lemma eta_positive : 0 < eta. Proof. apply bpow_gt_0. Qed.
Lemma u_small : u <= / 16777216.
Proof.
  replace (/ 16777216) with (bpow radix2 (-24)) by reflexivity.
  apply bpow_le; generalize prec_at_least_24; lia.
Qed.
(** The form in which small things are dropped: u times anything is a sixteen-millionth of it. *)
Lemma u_times_small z : 0 <= z -> 0 <= u * z <= z * / 16777216.
Proof. intro H; generalize u_positive, u_small; intros; split; nra. Qed.

#[local] Instance valid_format : Valid_exp format_exp.
Proof. apply FLT_exp_valid; exact prec_positive. Qed.

Lemma fl_is_float x : is_float (fl x).
Proof. apply generic_format_round; [exact valid_format|apply valid_rnd_N]. Qed.
Lemma fl_of_float x : is_float x -> fl x = x.
Proof. intro H; apply round_generic; [apply valid_rnd_N|exact H]. Qed.
Lemma fl_le x y : x <= y -> fl x <= fl y.
Proof. apply round_le; [exact valid_format|apply valid_rnd_N]. Qed.
Lemma fl_0 : fl 0 = 0.
Proof. apply round_0, valid_rnd_N. Qed.
Lemma fl_nonneg x : 0 <= x -> 0 <= fl x.
Proof. intro H; rewrite <- fl_0; apply fl_le, H. Qed.
Lemma fl_opp x : fl (- x) = - fl x.
Proof. unfold fl; apply round_NE_opp. Qed.
Lemma fl_abs x : fl (Rabs x) = Rabs (fl x).
Proof. unfold fl; apply round_NE_abs; exact valid_format. Qed.
Lemma is_float_opp x : is_float x -> is_float (- x).
Proof. apply generic_format_opp. Qed.
Lemma is_float_abs x : is_float x -> is_float (Rabs x).
Proof. apply generic_format_abs. Qed.
Lemma is_float_bpow e : (emin <= e)%Z -> is_float (bpow radix2 e).
Proof.
  intro H; apply generic_format_bpow; unfold format_exp, FLT_exp.
  generalize prec_at_least_24; lia.
Qed.

(** Sums and differences of floats have a relative error of at most u, also where they are denormal. *)
Lemma fl_plus x y : is_float x -> is_float y ->
  exists e, Rabs e <= u /\ fl (x + y) = (x + y) * (1 + e).
Proof.
  intros Fx Fy.
  destruct (FLT_plus_error_N_ex radix2 emin prec (fun x => negb (Z.even x)) x y) as [e [He E]]; auto.
  exists e; split; [|exact E].
  eapply Rle_trans; [exact He|]; eapply Rle_trans; [apply u_rod1pu_ro_le_u_ro|].
  unfold u_ro, u; replace (- prec + 1)%Z with (1 + - prec)%Z by lia; rewrite bpow_plus; change (bpow radix2 1) with 2; lra.
Qed.
Lemma fl_minus x y : is_float x -> is_float y ->
  exists e, Rabs e <= u /\ fl (x - y) = (x - y) * (1 + e).
Proof. intros Fx Fy; apply fl_plus; [exact Fx|apply is_float_opp; exact Fy]. Qed.

(** Any other result has in addition the error of underflow. *)
Lemma fl_any z : exists e t, Rabs e <= u /\ Rabs t <= eta /\ fl z = z * (1 + e) + t.
Proof.
  destruct (error_N_FLT radix2 emin prec prec_positive (fun x => negb (Z.even x)) z)
    as [e [t [He [Ht [_ E]]]]].
  exists e, t; repeat split; [| |exact E].
  - eapply Rle_trans; [exact He|]; unfold u.
    replace (- prec + 1)%Z with (1 + - prec)%Z by lia; rewrite bpow_plus; change (bpow radix2 1) with 2; lra.
  - eapply Rle_trans; [exact Ht|]; unfold eta.
    replace emin with (1 + (emin - 1))%Z at 1 by lia; rewrite bpow_plus; change (bpow radix2 1) with 2; lra.
Qed.

(** Two-sided forms for results that are not negative. *)
Lemma fl_any_bounds z : 0 <= z -> z * (1 - u) - eta <= fl z <= z * (1 + u) + eta.
Proof.
  intro H; destruct (fl_any z) as [e [t [He [Ht ->]]]].
  apply Rabs_le_inv in He; apply Rabs_le_inv in Ht.
  assert (z * (1 - u) <= z * (1 + e) <= z * (1 + u)) by (split; apply Rmult_le_compat_l; lra); lra.
Qed.
Lemma fl_plus_bounds x y : is_float x -> is_float y -> 0 <= x + y ->
  (x + y) * (1 - u) <= fl (x + y) <= (x + y) * (1 + u).
Proof.
  intros Fx Fy H; destruct (fl_plus x y Fx Fy) as [e [He ->]]; apply Rabs_le_inv in He.
  split; apply Rmult_le_compat_l; lra.
Qed.

(** Products of factors 1 + e. *)
Lemma factors p q a b : Rabs (p - 1) <= a * u -> Rabs (q - 1) <= b * u -> 0 <= a <= 1000 -> 0 <= b <= 1000 ->
  Rabs (p * q - 1) <= (a + b + a * b * / 16777216) * u.
Proof.
  intros Hp Hq Ha Hb.
  replace (p * q - 1) with ((p - 1) + (q - 1) + (p - 1) * (q - 1)) by ring.
  assert (K : Rabs ((p - 1) * (q - 1)) <= a * b * / 16777216 * u).
  { rewrite Rabs_mult; apply Rle_trans with ((a * u) * (b * u)).
    - apply Rmult_le_compat; auto using Rabs_pos.
    - generalize u_positive, u_small; intros.
      replace (a * u * (b * u)) with ((a * b) * (u * u)) by ring.
      replace (a * b * / 16777216 * u) with ((a * b) * (/ 16777216 * u)) by ring.
      apply Rmult_le_compat_l; [nra|]; apply Rmult_le_compat_r; lra. }
  eapply Rle_trans; [apply Rabs_triang|]; pose proof (Rabs_triang (p - 1) (q - 1)); lra.
Qed.
Lemma factor1 e : Rabs e <= u -> Rabs (1 + e - 1) <= 1 * u.
Proof. intro H; replace (1 + e - 1) with e by ring; lra. Qed.
Lemma factor2 e1 e2 : Rabs e1 <= u -> Rabs e2 <= u -> Rabs ((1 + e1) * (1 + e2) - 1) <= 2.0000001 * u.
Proof.
  intros; eapply Rle_trans; [apply factors with (a := 1) (b := 1); auto using factor1; lra|].
  apply Rmult_le_compat_r; [generalize u_positive|]; lra.
Qed.
Lemma factor3 e1 e2 e3 : Rabs e1 <= u -> Rabs e2 <= u -> Rabs e3 <= u ->
  Rabs ((1 + e1) * (1 + e2) * (1 + e3) - 1) <= 3.000001 * u.
Proof.
  intros; eapply Rle_trans; [apply factors with (a := 2.0000001) (b := 1); auto using factor1, factor2; lra|].
  apply Rmult_le_compat_r; [generalize u_positive|]; lra.
Qed.
Lemma factor4 e1 e2 e3 e4 : Rabs e1 <= u -> Rabs e2 <= u -> Rabs e3 <= u -> Rabs e4 <= u ->
  Rabs ((1 + e1) * (1 + e2) * (1 + e3) * (1 + e4) - 1) <= 4.000002 * u.
Proof.
  intros; eapply Rle_trans; [apply factors with (a := 3.000001) (b := 1); auto using factor1, factor3; lra|].
  apply Rmult_le_compat_r; [generalize u_positive|]; lra.
Qed.
(** Two underflows that pass through two more roundings. *)
Lemma underflow2 t t' e e' : Rabs t <= eta -> Rabs t' <= eta -> Rabs e <= u -> Rabs e' <= u ->
  Rabs ((t + t') * ((1 + e) * (1 + e'))) <= 2.5 * eta.
Proof.
  intros Ht Ht' He He'; rewrite Rabs_mult.
  pose proof (factor2 e e' He He') as K; generalize u_positive, u_small; intros.
  assert (Rabs ((1 + e) * (1 + e')) <= 1.25).
  { replace ((1 + e) * (1 + e')) with ((1 + e) * (1 + e') - 1 + 1) by ring.
    eapply Rle_trans; [apply Rabs_triang|]; rewrite Rabs_R1; lra. }
  replace (2.5 * eta) with ((2 * eta) * 1.25) by lra.
  apply Rmult_le_compat; try apply Rabs_pos; [|assumption].
  eapply Rle_trans; [apply Rabs_triang|lra].
Qed.
End Rounding.
