(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * A slab test around the end of a segment, in floats

    The rest of claim S11, for float32 and float64: from p to q, in a slab [lo, hi] that holds q, fast/list_caster.cpp
    finds the parameter 1 between the slab's ends as it computes them. *)
Require Import Reals Lra ZArith Lia.
Require Import Flocq.Core.Core Flocq.Prop.Relative.
Require Import Gnomon.RoundingModel Gnomon.ShaftClaims.
Open Scope R_scope.

Section Floats.
Context {F : Format}.
#[local] Existing Instance prec_positive.
#[local] Existing Instance valid_format.

Lemma exponent_at_0 : format_exp 0 = (- prec)%Z.
Proof. unfold format_exp, FLT_exp; generalize prec_at_least_24 range_is_ieee range_is_large; lia. Qed.
Lemma exponent_at_1 : format_exp 1 = (1 - prec)%Z.
Proof. unfold format_exp, FLT_exp; generalize prec_at_least_24 range_is_ieee range_is_large; lia. Qed.
Lemma one_is_float : is_float 1.
Proof. apply (is_float_bpow 0); generalize prec_at_least_24 range_is_ieee range_is_large; lia. Qed.

Lemma just_above_one x : x < 1 + u -> fl x <= 1.
Proof.
  intro H; apply round_N_le_midp; [exact valid_format|exact one_is_float|].
  rewrite succ_eq_pos by lra; change 1 with (bpow radix2 0) at 3; rewrite ulp_bpow; change (0 + 1)%Z with 1%Z.
  rewrite exponent_at_1.
  replace (1 - prec)%Z with (1 + - prec)%Z by lia; rewrite bpow_plus; change (bpow radix2 1) with 2.
  unfold u in H; lra.
Qed.
Lemma just_below_one x : 1 - u <= x -> 1 - u <= fl x.
Proof.
  intro H; replace (1 - u) with (fl (1 - u)); [apply fl_le; exact H|]; apply fl_of_float.
  replace (1 - u) with (pred radix2 format_exp 1).
  - apply generic_format_pred; [exact valid_format|exact one_is_float].
  - change 1 with (bpow radix2 0); rewrite pred_bpow, exponent_at_0; reflexivity.
Qed.

(** The rounded inverse, where it is not denormal. *)
Lemma inverse_is_near x : bpow radix2 (emin + prec - 1) <= Rabs x -> exists e, Rabs e < u /\ fl x = x * (1 + e).
Proof.
  intro N; destruct (relative_error_N_FLX'_ex radix2 prec prec_positive (fun z => negb (Z.even z)) x) as [e [E V]].
  exists e; split.
  - apply Rle_lt_trans with (1 := E); unfold u_ro.
    replace (/ 2 * bpow radix2 (- prec + 1)) with u by (unfold u; rewrite bpow_plus; simpl; lra).
    generalize u_positive; intro P; apply Rmult_lt_reg_r with (1 + u); [lra|].
    unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; nra.
  - unfold fl, format_exp; rewrite round_FLT_FLX by exact N; exact V.
Qed.

(** [widen]: what the far end is multiplied by; fast/list_caster.cpp takes about 1 + 8 u. *)
Theorem box_around_the_end_is_not_missed lo hi p q widen : lo <= q <= hi -> 0 < fl (q - p) ->
  bpow radix2 (emin + prec - 1) <= / fl (q - p) -> 1 + 2 * u <= widen ->
  let inverse := fl (/ fl (q - p)) in
  fl (fl (lo - p) * inverse) <= 1 <= fl (fl (fl (hi - p) * inverse) * widen).
Proof.
  intros I P N W; cbv zeta; destruct (inverse_is_near (/ fl (q - p))) as [e [E V]].
  - rewrite Rabs_pos_eq; [exact N|left; apply Rinv_0_lt_compat; exact P].
  - rewrite V; replace (/ fl (q - p) * (1 + e)) with ((1 + e) / fl (q - p)) by (unfold Rdiv; ring).
    generalize u_positive (u_times_small 1); intros Pu Su.
    apply (end_within_slab_is_never_missed fl) with (u := u); auto using fl_le, just_above_one, just_below_one.
    + split; lra.
    + apply fl_of_float; exact one_is_float.
    + assert (u * u <= u * / 16777216) by (apply Rmult_le_compat_l; [lra|apply u_small]); nra.
Qed.
End Floats.
