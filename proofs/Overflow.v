(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * Overflow does no harm

    The other files compute with an unbounded range. Here results can be infinite, as in IEEE arithmetic: an operation
    whose rounded result reaches 2^emax gives an infinity. A plane is armed only when the rounded sum
    |n0| (x + |a0|) + |n1| (y + |a1|) is at most 2^(emax - 8) (kLargestSafe is just below). [overflow_never_culls]:
    then a near corner's value can overflow to minus infinity only (T may be huge), which culls nothing; in every
    other case it is the number that the theorems are about. [no_overflow_within_extent]: at points of the extent box
    nothing overflows at all. *)
Require Import Reals Lra Psatz ZArith Lia.
Require Import Flocq.Core.Core.
Require Import Gnomon.RoundingModel Gnomon.PlaneError Gnomon.BoxThreshold.
Open Scope R_scope.

Section Overflow.
Context {F : Format}.

Inductive ieee := Number (x : R) | Infinite (positive : bool) | NotANumber.
Definition range : R := bpow radix2 emax.
Definition delivered (x : R) : ieee :=
  if Rlt_dec (Rabs (fl x)) range then Number (fl x) else Infinite (if Rlt_dec 0 x then true else false).
Definition ieee_mul (x y : R) : ieee := delivered (x * y).
Definition ieee_add (v w : ieee) : ieee :=
  match v, w with
  | Number x, Number y => delivered (x + y)
  | Infinite p, Number _ | Number _, Infinite p => Infinite p
  | Infinite p, Infinite q => if Bool.eqb p q then Infinite p else NotANumber
  | _, _ => NotANumber
  end.
(** ShaftPlane::value of finite numbers, and the comparison `value > threshold`. *)
Definition ieee_value (n0 n1 d x y : R) : ieee :=
  ieee_add (ieee_add (ieee_mul n0 x) (ieee_mul n1 y)) (Number d).
Definition above (v : ieee) (threshold : R) : Prop :=
  match v with Number x => x > threshold | Infinite positive => positive = true | NotANumber => False end.

Definition largest_safe : R := bpow radix2 (emax - 8).

Lemma range_is : range = 256 * largest_safe.
Proof.
  unfold range, largest_safe; replace emax with (8 + (emax - 8))%Z at 1 by lia.
  rewrite bpow_plus; change (bpow radix2 8) with 256; ring.
Qed.
Lemma fl_at_most_power k x : (0 <= k <= 8)%Z -> x <= bpow radix2 (emax - k) -> fl x <= bpow radix2 (emax - k).
Proof.
  intros Hk H; rewrite <- (fl_of_float (bpow radix2 (emax - k))); [apply fl_le, H|].
  apply is_float_bpow; generalize range_is_ieee prec_at_least_24 range_is_large; lia.
Qed.
Lemma fl_at_most_2 x : x <= 2 * largest_safe -> fl x <= 2 * largest_safe.
Proof.
  assert (E : 2 * largest_safe = bpow radix2 (emax - 7)).
  { unfold largest_safe; replace (emax - 7)%Z with (1 + (emax - 8))%Z by lia.
    rewrite bpow_plus; change (bpow radix2 1) with 2; ring. }
  rewrite E; apply fl_at_most_power; lia.
Qed.
Lemma fl_at_most_4 x : x <= 4 * largest_safe -> fl x <= 4 * largest_safe.
Proof.
  assert (E : 4 * largest_safe = bpow radix2 (emax - 6)).
  { unfold largest_safe; replace (emax - 6)%Z with (2 + (emax - 8))%Z by lia.
    rewrite bpow_plus; change (bpow radix2 2) with 4; ring. }
  rewrite E; apply fl_at_most_power; lia.
Qed.
Lemma safe_positive : 0 < largest_safe. Proof. apply bpow_gt_0. Qed.

(** What is not too large is delivered as it is, or is minus infinity. *)
Lemma delivered_from_above x : fl x <= 4 * largest_safe ->
  delivered x = Number (fl x) \/ delivered x = Infinite false.
Proof.
  intro H; unfold delivered; pose proof range_is; pose proof safe_positive.
  destruct Rlt_dec as [L|L]; [left; reflexivity|right].
  destruct Rlt_dec as [P|P]; [exfalso; apply L|reflexivity].
  assert (0 <= fl x) by (apply fl_nonneg; lra); rewrite Rabs_pos_eq; lra.
Qed.
Lemma delivered_as_it_is x : Rabs (fl x) <= 4 * largest_safe -> delivered x = Number (fl x).
Proof.
  intro H; unfold delivered; pose proof range_is; pose proof safe_positive.
  destruct Rlt_dec as [L|L]; [reflexivity|exfalso; apply L; lra].
Qed.

Theorem overflow_never_culls n0 n1 d x y threshold :
  fl (n0 * x) <= largest_safe -> fl (n1 * y) <= largest_safe -> d <= largest_safe ->
  above (ieee_value n0 n1 d x y) threshold -> plane_value n0 n1 d x y > threshold.
Proof.
  intros H0 H1 Hd; pose proof safe_positive as S.
  unfold ieee_value, ieee_mul, plane_value.
  destruct (delivered_from_above (n0 * x)) as [E0|E0]; [lra| |];
  (destruct (delivered_from_above (n1 * y)) as [E1|E1]; [lra| |]); rewrite E0, E1; simpl; try discriminate.
  assert (Q : fl (fl (n0 * x) + fl (n1 * y)) <= 2 * largest_safe) by (apply fl_at_most_2; lra).
  destruct (delivered_from_above (fl (n0 * x) + fl (n1 * y))) as [E2|E2]; [lra| |]; rewrite E2; simpl;
  try discriminate.
  assert (R : fl (fl (fl (n0 * x) + fl (n1 * y)) + d) <= 4 * largest_safe) by (apply fl_at_most_4; lra).
  destruct (delivered_from_above (fl (fl (n0 * x) + fl (n1 * y)) + d)) as [E3|E3]; [lra| |]; rewrite E3; simpl;
  [auto|discriminate].
Qed.

Lemma fl_abs_at_most (bound : R) x : (forall z, z <= bound -> fl z <= bound) -> Rabs x <= bound -> Rabs (fl x) <= bound.
Proof.
  intros B H; apply Rabs_le_inv in H; apply Rabs_le; split; [|apply B; lra].
  assert (K : fl (- x) <= bound) by (apply B; lra); rewrite fl_opp in K; lra.
Qed.

Theorem no_overflow_within_extent n0 n1 d x y :
  Rabs (fl (n0 * x)) <= largest_safe -> Rabs (fl (n1 * y)) <= largest_safe -> Rabs d <= largest_safe ->
  ieee_value n0 n1 d x y = Number (plane_value n0 n1 d x y).
Proof.
  intros H0 H1 Hd; pose proof safe_positive as S.
  unfold ieee_value, ieee_mul, plane_value; rewrite !delivered_as_it_is by lra; simpl.
  assert (Q : Rabs (fl (fl (n0 * x) + fl (n1 * y))) <= 2 * largest_safe).
  { apply fl_abs_at_most; [apply fl_at_most_2|]; eapply Rle_trans; [apply Rabs_triang|lra]. }
  rewrite delivered_as_it_is by lra; simpl; rewrite delivered_as_it_is; [reflexivity|].
  apply fl_abs_at_most; [apply fl_at_most_4|]; eapply Rle_trans; [apply Rabs_triang|lra].
Qed.

(** An armed plane meets their conditions: for a near corner, whose components times the normal's are at most those of
    the extent box, and for every point of the extent box. *)
Theorem armed_is_safe n0 n1 a0 a1 x y :
  0 <= x -> 0 <= y -> is_float x -> is_float y -> is_float a0 -> is_float a1 ->
  box_sum n0 n1 a0 a1 x y <= largest_safe ->
  Rabs (plane_d n0 n1 a0 a1) <= largest_safe /\
  (forall v, n0 * v <= Rabs n0 * x -> fl (n0 * v) <= largest_safe) /\
  (forall v, n1 * v <= Rabs n1 * y -> fl (n1 * v) <= largest_safe) /\
  (forall v, Rabs v <= x -> Rabs (fl (n0 * v)) <= largest_safe) /\
  (forall v, Rabs v <= y -> Rabs (fl (n1 * v)) <= largest_safe).
Proof.
  intros Hx Hy Fx Fy Fa0 Fa1 S; unfold box_sum in S.
  assert (G : forall n v a, 0 <= v -> is_float v -> is_float a ->
            Rabs n * v <= Rabs n * fl (v + Rabs a) /\ Rabs n * Rabs a <= Rabs n * fl (v + Rabs a) /\
            0 <= fl (Rabs n * fl (v + Rabs a))).
  { intros n v a Hv Fv Fa; pose proof (Rabs_pos a).
    assert (v <= fl (v + Rabs a)) by (rewrite <- (fl_of_float v Fv) at 1; apply fl_le; lra).
    assert (Rabs a <= fl (v + Rabs a))
      by (rewrite <- (fl_of_float (Rabs a)) at 1 by (apply is_float_abs, Fa); apply fl_le; lra).
    repeat split; try (apply Rmult_le_compat_l; [apply Rabs_pos|assumption]).
    apply fl_nonneg, Rmult_le_pos; [apply Rabs_pos|lra]. }
  destruct (G n0 x a0 Hx Fx Fa0) as [X1 [A1 W0]], (G n1 y a1 Hy Fy Fa1) as [Y1 [B1 W1]]; clear G.
  set (w0 := fl (Rabs n0 * fl (x + Rabs a0))) in *; set (w1 := fl (Rabs n1 * fl (y + Rabs a1))) in *.
  assert (L0 : w0 <= largest_safe).
  { eapply Rle_trans; [|exact S]; rewrite <- (fl_of_float w0) at 1 by apply fl_is_float; apply fl_le; lra. }
  assert (L1 : w1 <= largest_safe).
  { eapply Rle_trans; [|exact S]; rewrite <- (fl_of_float w1) at 1 by apply fl_is_float; apply fl_le; lra. }
  assert (P0 : forall z, Rabs z <= Rabs n0 * fl (x + Rabs a0) -> Rabs (fl z) <= w0)
    by (intros z Hz; rewrite <- fl_abs; apply fl_le, Hz).
  assert (P1 : forall z, Rabs z <= Rabs n1 * fl (y + Rabs a1) -> Rabs (fl z) <= w1)
    by (intros z Hz; rewrite <- fl_abs; apply fl_le, Hz).
  repeat split.
  - unfold plane_d; rewrite Rabs_Ropp, <- fl_abs; eapply Rle_trans; [|exact S]; apply fl_le.
    assert (Rabs (fl (n0 * a0)) <= w0) by (apply P0; rewrite Rabs_mult; exact A1).
    assert (Rabs (fl (n1 * a1)) <= w1) by (apply P1; rewrite Rabs_mult; exact B1).
    eapply Rle_trans; [apply Rabs_triang|lra].
  - intros v Hv; eapply Rle_trans; [|exact L0]; apply fl_le; lra.
  - intros v Hv; eapply Rle_trans; [|exact L1]; apply fl_le; lra.
  - intros v Hv; eapply Rle_trans; [apply P0|exact L0].
    rewrite Rabs_mult; eapply Rle_trans; [|exact X1]; apply Rmult_le_compat_l; [apply Rabs_pos|exact Hv].
  - intros v Hv; eapply Rle_trans; [apply P1|exact L1].
    rewrite Rabs_mult; eapply Rle_trans; [|exact Y1]; apply Rmult_le_compat_l; [apply Rabs_pos|exact Hv].
Qed.
End Overflow.
