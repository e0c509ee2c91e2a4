(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * The rounding error of one plane evaluation

    ShaftPlane::value computes ((n0 x) + (n1 y)) + d, with d = -((n0 a0) + (n1 a1)) from set-up; every operation
    rounds. [plane_value_error]: when n0 and n1 carry one rounding each, the result differs from the exact
    N0 (x - a0) + N1 (y - a1) by at most 4.000002 u S + 5 eta. It holds for all real x and y, floats or not,
    which is what allows one threshold for all boxes. *)
Require Import Reals Lra Psatz ZArith.
Require Import Flocq.Core.Core.
Require Import Gnomon.RoundingModel.
Open Scope R_scope.

Section PlaneError.
Context {F : Format}.

(** As the code computes: form_plane and ShaftPlane::value. *)
Definition plane_d (n0 n1 a0 a1 : R) : R := - fl (fl (n0 * a0) + fl (n1 * a1)).
Definition plane_value (n0 n1 d x y : R) : R := fl (fl (fl (n0 * x) + fl (n1 * y)) + d).

(** Exactly. *)
Definition exact_value (N0 N1 a0 a1 x y : R) : R := N0 * (x - a0) + N1 * (y - a1).
Definition magnitude_sum (N0 N1 a0 a1 x y : R) : R :=
  Rabs N0 * (Rabs x + Rabs a0) + Rabs N1 * (Rabs y + Rabs a1).

Lemma plane_d_is_float n0 n1 a0 a1 : is_float (plane_d n0 n1 a0 a1).
Proof. apply is_float_opp, fl_is_float. Qed.

Lemma six_terms A B C D P Q :
  Rabs (A + B - (C + D) + (P - Q)) <= Rabs A + Rabs B + (Rabs C + Rabs D) + (Rabs P + Rabs Q).
Proof.
  unfold Rminus; repeat (eapply Rle_trans; [apply Rabs_triang|apply Rplus_le_compat]); rewrite ?Rabs_Ropp;
  try apply Rabs_triang; lra.
Qed.

Theorem plane_value_error N0 N1 e0 e1 a0 a1 x y :
  Rabs e0 <= u -> Rabs e1 <= u ->
  let n0 := N0 * (1 + e0) in let n1 := N1 * (1 + e1) in
  Rabs (plane_value n0 n1 (plane_d n0 n1 a0 a1) x y - exact_value N0 N1 a0 a1 x y)
    <= 4.000002 * u * magnitude_sum N0 N1 a0 a1 x y + 5 * eta.
Proof.
  intros H1 H2 n0 n1.
  destruct (fl_any (n0 * x)) as [e3 [t3 [H3 [T3 E3]]]].
  destruct (fl_any (n1 * y)) as [e4 [t4 [H4 [T4 E4]]]].
  destruct (fl_plus (fl (n0 * x)) (fl (n1 * y)) (fl_is_float _) (fl_is_float _)) as [e5 [H5 E5]].
  destruct (fl_any (n0 * a0)) as [e6 [t6 [H6 [T6 E6]]]].
  destruct (fl_any (n1 * a1)) as [e7 [t7 [H7 [T7 E7]]]].
  destruct (fl_plus (fl (n0 * a0)) (fl (n1 * a1)) (fl_is_float _) (fl_is_float _)) as [e8 [H8 E8]].
  destruct (fl_plus (fl (fl (n0 * x) + fl (n1 * y))) (plane_d n0 n1 a0 a1)
              (fl_is_float _) (plane_d_is_float _ _ _ _)) as [e9 [H9 E9]].
  set (th := fun p q s t => (1 + p) * (1 + q) * (1 + s) * (1 + t) - 1).
  assert (E : plane_value n0 n1 (plane_d n0 n1 a0 a1) x y - exact_value N0 N1 a0 a1 x y =
     N0 * x * th e0 e3 e5 e9 + N1 * y * th e1 e4 e5 e9
   - (a0 * N0 * th e0 e6 e8 e9 + a1 * N1 * th e1 e7 e8 e9)
   + ((t3 + t4) * ((1 + e5) * (1 + e9)) - (t6 + t7) * ((1 + e8) * (1 + e9)))).
  { unfold plane_value; rewrite E9; unfold plane_d; rewrite E8, E5, E3, E4, E6, E7.
    unfold n0, n1, th, exact_value; ring. }
  rewrite E; clear E.
  assert (M : forall A B p q s t, Rabs p <= u -> Rabs q <= u -> Rabs s <= u -> Rabs t <= u ->
     Rabs (A * B * th p q s t) <= Rabs A * Rabs B * (4.000002 * u)).
  { intros; rewrite 2!Rabs_mult; apply Rmult_le_compat_l; [|apply factor4; assumption].
    apply Rmult_le_pos; apply Rabs_pos. }
  pose proof (M N0 x _ _ _ _ H1 H3 H5 H9).
  pose proof (M N1 y _ _ _ _ H2 H4 H5 H9).
  pose proof (M a0 N0 _ _ _ _ H1 H6 H8 H9).
  pose proof (M a1 N1 _ _ _ _ H2 H7 H8 H9).
  pose proof (underflow2 _ _ _ _ T3 T4 H5 H9).
  pose proof (underflow2 _ _ _ _ T6 T7 H8 H9).
  unfold magnitude_sum; eapply Rle_trans; [apply six_terms|]; lra.
Qed.

(** The same kernel when the normal is taken as it is (no rounding of its own) and the offset as the number that
    was stored: what balls need. *)
Theorem plane_value_error_as_stored m0 m1 d x y : is_float d ->
  Rabs (plane_value m0 m1 d x y - (m0 * x + m1 * y + d))
    <= u * (3.000001 * (Rabs m0 * Rabs x + Rabs m1 * Rabs y) + Rabs d) + 2.5 * eta.
Proof.
  intro Fd.
  destruct (fl_any (m0 * x)) as [e3 [t3 [H3 [T3 E3]]]].
  destruct (fl_any (m1 * y)) as [e4 [t4 [H4 [T4 E4]]]].
  destruct (fl_plus (fl (m0 * x)) (fl (m1 * y)) (fl_is_float _) (fl_is_float _)) as [e5 [H5 E5]].
  destruct (fl_plus (fl (fl (m0 * x) + fl (m1 * y))) d (fl_is_float _) Fd) as [e9 [H9 E9]].
  set (th := fun p q s => (1 + p) * (1 + q) * (1 + s) - 1).
  replace (plane_value m0 m1 d x y - (m0 * x + m1 * y + d)) with
    (m0 * x * th e3 e5 e9 + m1 * y * th e4 e5 e9 - (- (d * e9) + 0)
     + ((t3 + t4) * ((1 + e5) * (1 + e9)) - 0)) by
    (unfold plane_value; rewrite E9, E5, E3, E4; unfold th; ring).
  assert (M : forall A B p q s, Rabs p <= u -> Rabs q <= u -> Rabs s <= u ->
     Rabs (A * B * th p q s) <= Rabs A * Rabs B * (3.000001 * u)).
  { intros; rewrite 2!Rabs_mult; apply Rmult_le_compat_l; [|apply factor3; assumption].
    apply Rmult_le_pos; apply Rabs_pos. }
  pose proof (M m0 x _ _ _ H3 H5 H9).
  pose proof (M m1 y _ _ _ H4 H5 H9).
  pose proof (underflow2 _ _ _ _ T3 T4 H5 H9).
  assert (Rabs (- (d * e9)) <= Rabs d * u).
  { rewrite Rabs_Ropp, Rabs_mult; apply Rmult_le_compat_l; auto using Rabs_pos. }
  eapply Rle_trans; [apply six_terms|]; rewrite !Rabs_R0; lra.
Qed.
End PlaneError.
