(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * The power of two that shorten() scales by

    Outside the safe range shorten() scales the normal by 2^-ilogb(larger component). [code_prescale_is_prescaled]: the
    larger component then lies in [1, 2), so ShortenedPlane.v's [prescaled] holds; and a plane's normal is never 0
    ([normal_is_not_zero]). *)
Require Import Reals Lra Psatz ZArith Lia.
Require Import Flocq.Core.Core Flocq.Prop.Mult_error.
Require Import Gnomon.Boxes Gnomon.PlaneSet Gnomon.RoundingModel Gnomon.BoxTestCertified Gnomon.ShortenedPlane.
Open Scope R_scope.

Section Prescale.
Context {F : Format}.

(** std::ilogb: the e with 2^e <= |x| < 2^(e+1), denormals included. *)
Definition ilogb (x : R) : BinNums.Z := (mag radix2 x - 1)%Z.
Definition in_safe_range (larger : R) : bool :=
  if Rle_dec (bpow radix2 (- safe_exponent)) larger then
    if Rle_dec larger (bpow radix2 safe_exponent) then true else false else false.
Definition code_prescale (n0 n1 n : R) : R :=
  let larger := Rmax (Rabs n0) (Rabs n1) in
  if in_safe_range larger then n else scalbn n (- ilogb larger).

Lemma scaled_to_one x : is_float x -> 0 < x ->
  scalbn x (- ilogb x) = x * bpow radix2 (- ilogb x) /\ 1 <= x * bpow radix2 (- ilogb x) < 2.
Proof.
  intros Fx P; unfold ilogb; set (m := mag radix2 x).
  assert (N : x <> 0) by lra.
  assert (Pp : Prec_gt_0 prec) by (unfold Prec_gt_0; generalize prec_at_least_24; lia).
  split.
  - unfold scalbn; apply fl_of_float, (mult_bpow_exact_FLT radix2 emin prec); [exact Fx|].
    fold m; generalize range_is_ieee range_is_large prec_at_least_24; lia.
  - pose proof (bpow_mag_le radix2 x N) as L; pose proof (bpow_mag_gt radix2 x) as U; fold m in L, U.
    rewrite Rabs_pos_eq in L, U by lra; pose proof (bpow_gt_0 radix2 (- (m - 1))) as B.
    assert (E1 : bpow radix2 (m - 1) * bpow radix2 (- (m - 1)) = 1)
      by (rewrite <- bpow_plus; replace (m - 1 + - (m - 1))%Z with 0%Z by lia; reflexivity).
    assert (E2 : bpow radix2 m * bpow radix2 (- (m - 1)) = 2)
      by (rewrite <- bpow_plus; replace (m + - (m - 1))%Z with 1%Z by lia; reflexivity).
    split; [rewrite <- E1; apply Rmult_le_compat_r; lra|rewrite <- E2; apply Rmult_lt_compat_r; lra].
Qed.

Theorem code_prescale_is_prescaled n0 n1 : is_float n0 -> is_float n1 -> n0 <> 0 \/ n1 <> 0 ->
  prescaled n0 n1 (code_prescale n0 n1 n0) (code_prescale n0 n1 n1).
Proof.
  intros F0 F1 N; unfold code_prescale, in_safe_range; cbv zeta.
  set (l := Rmax (Rabs n0) (Rabs n1)).
  destruct Rle_dec as [L|L]; [destruct Rle_dec as [U|U]; [apply as_it_is; fold l; lra|]|]; apply to_one;
  clear L; try clear U.
  all: assert (Fl : is_float l) by (unfold l, Rmax; destruct Rle_dec; apply is_float_abs; assumption).
  all: assert (P : 0 < l) by (unfold l; destruct N as [N|N];
       [eapply Rlt_le_trans; [apply Rabs_pos_lt, N|apply Rmax_l]|eapply Rlt_le_trans; [apply Rabs_pos_lt, N|apply Rmax_r]]).
  all: destruct (scaled_to_one l Fl P) as [E [B0 B1]]; pose proof (bpow_gt_0 radix2 (- ilogb l)) as K.
  all: assert (A : forall n, Rabs (scalbn n (- ilogb l)) = scalbn (Rabs n) (- ilogb l))
    by (intro n; unfold scalbn; rewrite <- fl_abs, Rabs_mult, (Rabs_pos_eq (bpow _ _)) by lra; reflexivity).
  all: assert (M : forall n, Rabs n <= l -> scalbn (Rabs n) (- ilogb l) <= scalbn l (- ilogb l))
    by (intros n Hn; apply fl_le, Rmult_le_compat_r; lra).
  all: rewrite !A; pose proof (M n0 (Rmax_l _ _)); pose proof (M n1 (Rmax_r _ _)).
  all: assert (Q : Rmax (scalbn (Rabs n0) (- ilogb l)) (scalbn (Rabs n1) (- ilogb l)) = scalbn l (- ilogb l)).
  all: try (apply Rle_antisym; [apply Rmax_lub; assumption|];
       assert (C : l = Rabs n0 \/ l = Rabs n1) by (unfold l, Rmax; destruct Rle_dec; auto);
       destruct C as [C|C]; rewrite C at 1; [apply Rmax_l|apply Rmax_r]).
  all: rewrite Q, E; lra.
Qed.

(** Differences of different floats do not round to 0. *)
Theorem normal_is_not_zero A B f g : float_box A -> float_box B -> extreme A B f -> extreme B A g ->
  code_n0 A B f g <> 0 /\ code_n1 A B f g <> 0.
Proof.
  intros FA FB Ef Eg; unfold extreme in *; pose proof u_small.
  assert (K : forall h x y, is_float x -> is_float y -> x <> y -> sgn h * Rabs (fl (x - y)) <> 0).
  { intros h x y Fx Fy N; destruct (fl_minus x y Fx Fy) as [e [He E]]; apply Rabs_le_inv in He; rewrite E.
    apply Rmult_integral_contrapositive_currified; [destruct h as [? []]; unfold sgn; simpl; lra|].
    apply Rabs_no_R0, Rmult_integral_contrapositive_currified; lra. }
  split; apply K; auto; intro E; rewrite E in *; lra.
Qed.

(** So shorten() always has what ShortenedPlane.v asks of it. *)
Theorem shorten_can_always_scale A B f g : float_box A -> float_box B -> extreme A B f -> extreme B A g ->
  let n0 := code_n0 A B f g in let n1 := code_n1 A B f g in
  prescaled n0 n1 (code_prescale n0 n1 n0) (code_prescale n0 n1 n1).
Proof.
  intros FA FB Ef Eg n0 n1; destruct (normal_is_not_zero A B f g FA FB Ef Eg) as [N0 N1].
  assert (S : forall h z, is_float z -> is_float (sgn h * z)).
  { intros [i []] z Fz; unfold sgn, snd; [|rewrite Rmult_1_l; exact Fz].
    replace (-1 * z) with (- z) by ring; apply is_float_opp, Fz. }
  apply code_prescale_is_prescaled; auto; apply S, is_float_abs, fl_is_float.
Qed.
End Prescale.
