(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * The slacks of the ball's extent tests

    [squared_distance_slack]: the rounded squared distance from the centre to the extent box is compared with the
    rounded r^2 (1 + 10 u) + 8 eta; above it the ball really misses the extent box. [side_slack]: a rounded
    difference c - lo of at least the rounded r (1 + 4 u) proves c - lo >= r, denormals included. *)
Require Import Reals Lra Psatz ZArith Lia.
Require Import Flocq.Core.Core.
Require Import Gnomon.RoundingModel.
Open Scope R_scope.

Section Slack.
Context {F : Format}.

(** CertifiedConstants; the offset in units of two_eta. *)
Definition square_factor : R := 10.
Definition square_offset : R := 4.
Definition side_factor : R := 4.

(** Arvo's distance on one axis, exact and as computed. *)
Definition apart (l h c : R) : R := Rmax (Rmax (l - c) (c - h)) 0.
Definition code_apart (l h c : R) : R := Rmax (Rmax (fl (l - c)) (fl (c - h))) 0.

Definition code_squared_distance (x y z : R) : R :=
  fl (fl (fl (0 + fl (x * x)) + fl (y * y)) + fl (z * z)).
Definition code_square_bound (r : R) : R :=
  fl (fl (fl (r * r) * (1 + square_factor * u)) + square_offset * (2 * eta)).

Lemma code_apart_at_most l h c : l <= h -> is_float l -> is_float h -> is_float c ->
  0 <= code_apart l h c <= apart l h c * (1 + u).
Proof.
  intros L Fl Fh Fc; pose proof u_positive as U0; pose proof u_small as U.
  destruct (fl_minus l c Fl Fc) as [e [He E]], (fl_minus c h Fc Fh) as [e' [He' E']].
  apply Rabs_le_inv in He; apply Rabs_le_inv in He'.
  unfold code_apart, apart; split; [apply Rmax_r|].
  assert (K : forall z d, - u <= d <= u -> z * (1 + d) <= Rmax z 0 * (1 + u)).
  { intros z d Hd; unfold Rmax; destruct Rle_dec as [Hz|Hz].
    - rewrite Rmult_0_l; assert (0 <= (- z) * (1 + d)) by (apply Rmult_le_pos; lra); lra.
    - apply Rmult_le_compat_l; lra. }
  pose proof (K (l - c) e He) as K0; pose proof (K (c - h) e' He') as K1; rewrite <- E in K0; rewrite <- E' in K1.
  assert (M : forall z w, z <= w -> Rmax z 0 * (1 + u) <= Rmax w 0 * (1 + u))
    by (intros; apply Rmult_le_compat_r; [lra|apply Rle_max_compat_r; assumption]).
  pose proof (M _ _ (Rmax_l (l - c) (c - h))); pose proof (M _ _ (Rmax_r (l - c) (c - h))).
  repeat apply Rmax_lub; try lra; apply Rmult_le_pos; [apply Rmax_r|lra].
Qed.

(** (1+u)^5 and the underflow of three squares. *)
Lemma code_squared_distance_at_most x y z x' y' z' :
  0 <= x' <= x * (1 + u) -> 0 <= y' <= y * (1 + u) -> 0 <= z' <= z * (1 + u) ->
  code_squared_distance x' y' z' <= (x * x + y * y + z * z) * (1 + 5.00001 * u) + 3.1 * eta.
Proof.
  intros Hx Hy Hz; pose proof u_positive as U0; pose proof u_small as U; pose proof eta_positive as T0.
  set (v := (1 + u) * (1 + u) * (1 + u)).
  assert (V : 0 <= v <= 1 + 3.000001 * u) by (unfold v; split; nra).
  assert (Q : forall a a', 0 <= a' <= a * (1 + u) -> 0 <= fl (a' * a') <= a * a * v + eta).
  { intros a a' [A0 A1]; assert (P : 0 <= a' * a') by (apply Rmult_le_pos; lra).
    split; [apply fl_nonneg, P|]; destruct (fl_any_bounds _ P) as [_ B].
    assert (a' * a' <= (a * (1 + u)) * (a * (1 + u))) by (apply Rmult_le_compat; lra).
    assert (a' * a' * (1 + u) <= (a * (1 + u)) * (a * (1 + u)) * (1 + u)) by (apply Rmult_le_compat_r; lra).
    unfold v; lra. }
  pose proof (Q _ _ Hx) as Q0; pose proof (Q _ _ Hy) as Q1; pose proof (Q _ _ Hz) as Q2; clear Q.
  unfold code_squared_distance; rewrite Rplus_0_l, (fl_of_float (fl (x' * x'))) by apply fl_is_float.
  set (p := fl (x' * x')) in *; set (q := fl (y' * y')) in *; set (r := fl (z' * z')) in *.
  assert (S0 : 0 <= p + q) by lra.
  destruct (fl_plus_bounds p q (fl_is_float _) (fl_is_float _) S0) as [_ B]; pose proof (fl_nonneg _ S0).
  set (s := fl (p + q)) in *; assert (S1 : 0 <= s + r) by lra.
  destruct (fl_plus_bounds s r (fl_is_float _) (fl_is_float _) S1) as [_ B'].
  eapply Rle_trans; [exact B'|].
  assert (XX : forall a : R, 0 <= a * a) by (intro; nra).
  pose proof (XX x); pose proof (XX y); pose proof (XX z).
  set (D := x * x + y * y + z * z); assert (D0 : 0 <= D) by (unfold D; lra).
  assert (T : s + r <= (D * v + 3 * eta) * (1 + u)).
  { assert ((p + q) * (1 + u) <= ((x * x + y * y) * v + 2 * eta) * (1 + u)) by (apply Rmult_le_compat_r; lra).
    assert ((z * z * v + eta) * 1 <= (z * z * v + eta) * (1 + u)) by (apply Rmult_le_compat_l; lra).
    unfold D; lra. }
  apply Rle_trans with ((D * v + 3 * eta) * (1 + u) * (1 + u)); [apply Rmult_le_compat_r; lra|].
  assert (W : v * ((1 + u) * (1 + u)) <= 1 + 5.00001 * u) by (clear - U0 U V; nra).
  assert (W' : (1 + u) * (1 + u) <= 1.01) by (clear - U0 U; nra).
  assert (D * (v * ((1 + u) * (1 + u))) <= D * (1 + 5.00001 * u)) by (apply Rmult_le_compat_l; lra).
  assert (eta * ((1 + u) * (1 + u)) <= eta * 1.01) by (apply Rmult_le_compat_l; lra).
  lra.
Qed.

Lemma square_offset_is_float : is_float (square_offset * (2 * eta)).
Proof.
  replace (square_offset * (2 * eta)) with (bpow radix2 (emin + 2)); [apply is_float_bpow; lia|].
  unfold square_offset, eta; replace (emin + 2)%Z with (3 + (emin - 1))%Z by lia.
  rewrite bpow_plus; change (bpow radix2 3) with 8; lra.
Qed.
Lemma code_square_bound_at_least r : r * r * (1 + 6 * u) + 5.9 * eta <= code_square_bound r.
Proof.
  pose proof u_positive as U0; pose proof u_small as U; pose proof eta_positive as T0.
  assert (R0 : 0 <= r * r) by nra; destruct (fl_any_bounds _ R0) as [A _]; pose proof (fl_nonneg _ R0) as A0.
  unfold code_square_bound, square_factor; set (s := fl (r * r)) in *.
  assert (B0 : 0 <= s * (1 + 10 * u)) by (apply Rmult_le_pos; lra).
  destruct (fl_any_bounds _ B0) as [B _]; pose proof (fl_nonneg _ B0) as C0.
  set (t := fl (s * (1 + 10 * u))) in *.
  assert (D0 : 0 <= t + square_offset * (2 * eta)) by (unfold square_offset; lra).
  destruct (fl_plus_bounds t _ (fl_is_float _) square_offset_is_float D0) as [C _].
  eapply Rle_trans; [|exact C]; unfold square_offset.
  assert (S : (r * r * (1 - u) - eta) * ((1 + 10 * u) * (1 - u)) <= s * ((1 + 10 * u) * (1 - u)))
    by (apply Rmult_le_compat_r; [apply Rmult_le_pos|]; lra).
  assert (T : (r * r * (1 - u) - eta) * ((1 + 10 * u) * (1 - u)) - eta + 8 * eta <= t + 4 * (2 * eta)) by lra.
  apply Rle_trans with (((r * r * (1 - u) - eta) * ((1 + 10 * u) * (1 - u)) - eta + 8 * eta) * (1 - u));
  [|apply Rmult_le_compat_r; lra].
  assert (K : 1 + 6 * u <= (1 - u) * ((1 + 10 * u) * (1 - u)) * (1 - u)) by (clear - U0 U; nra).
  assert (K2 : (1 + 10 * u) * (1 - u) * (1 - u) <= 1.01) by (clear - U0 U; nra).
  assert (r * r * (1 + 6 * u) <= r * r * ((1 - u) * ((1 + 10 * u) * (1 - u)) * (1 - u)))
    by (apply Rmult_le_compat_l; lra).
  assert (eta * ((1 + 10 * u) * (1 - u) * (1 - u)) <= eta * 1.01) by (apply Rmult_le_compat_l; lra).
  assert (7 * eta * 0.999 <= 7 * eta * (1 - u)) by (apply Rmult_le_compat_l; lra).
  lra.
Qed.

(** x, y, z: what the code computes for the three axes; X, Y, Z: what they should be. *)
Theorem squared_distance_slack X Y Z x y z r :
  0 <= x <= X * (1 + u) -> 0 <= y <= Y * (1 + u) -> 0 <= z <= Z * (1 + u) ->
  code_squared_distance x y z > code_square_bound r -> X * X + Y * Y + Z * Z > r * r.
Proof.
  intros Hx Hy Hz H; apply Rnot_le_gt; intro L.
  pose proof (code_squared_distance_at_most _ _ _ _ _ _ Hx Hy Hz).
  pose proof (code_square_bound_at_least r).
  pose proof u_positive as U0; pose proof eta_positive.
  assert (XX : forall a : R, 0 <= a * a) by (intro; nra).
  pose proof (XX X); pose proof (XX Y); pose proof (XX Z); pose proof (XX r).
  assert ((X * X + Y * Y + Z * Z) * (1 + 5.00001 * u) <= r * r * (1 + 5.00001 * u)) by (apply Rmult_le_compat_r; lra).
  assert (0 <= u * (r * r)) by (apply Rmult_le_pos; lra); lra.
Qed.

(** ** Sides *)

(** Differences of floats that are small enough are exact: both are multiples of the smallest denormal. *)
Lemma small_difference_is_exact x y : is_float x -> is_float y -> Rabs (x - y) <= bpow radix2 (emin + prec) ->
  fl (x - y) = x - y.
Proof.
  intros Fx Fy H; apply fl_of_float.
  assert (P : Prec_gt_0 prec) by (unfold Prec_gt_0; generalize prec_at_least_24; lia).
  assert (G : forall z, is_float z -> FIX_format radix2 emin z)
    by (intros z Fz; apply FIX_format_generic, generic_format_FIX_FLT with (1 := Fz)).
  destruct (G x Fx) as [fx Ex fxe], (G y Fy) as [fy Ey fye].
  apply generic_format_FLT_FIX; [exact P|exact H|].
  apply generic_format_FIX; exists (Float radix2 (Fnum fx - Fnum fy) emin); [|reflexivity].
  rewrite Ex, Ey; unfold F2R; rewrite fxe, fye; simpl; rewrite minus_IZR; ring.
Qed.

Theorem side_slack c l r : is_float c -> is_float l -> is_float r -> 0 <= r ->
  fl (c - l) >= fl (r * (1 + side_factor * u)) -> c - l >= r.
Proof.
  intros Fc Fl Fr Hr H; apply Rle_ge, Rnot_lt_le; intro L.
  pose proof u_positive as U0; pose proof u_small as U; pose proof eta_positive as T0.
  assert (M : r <= fl (r * (1 + side_factor * u))).
  { rewrite <- (fl_of_float r Fr) at 1; apply fl_le; unfold side_factor.
    assert (0 <= r * u) by (apply Rmult_le_pos; lra); lra. }
  assert (N : fl (c - l) <= r) by (rewrite <- (fl_of_float r Fr); apply fl_le; lra).
  destruct (Rle_lt_dec r (bpow radix2 (emin + prec))) as [S|S].
  - assert (0 <= c - l \/ c - l < 0) as [P|P] by lra.
    + rewrite small_difference_is_exact in H; auto; [lra|].
      rewrite Rabs_pos_eq by exact P; lra.
    + assert (fl (c - l) <= 0) by (rewrite <- fl_0; apply fl_le; lra).
      assert (R0 : r = 0) by lra.
      destruct (fl_minus c l Fc Fl) as [e [He E]]; apply Rabs_le_inv in He.
      assert ((c - l) * (1 + e) < 0); [|lra].
      replace 0 with ((c - l) * 0) by ring; apply Rmult_lt_gt_compat_neg_l; lra.
  - assert (Q : 0 <= r * (1 + side_factor * u)) by (apply Rmult_le_pos; unfold side_factor; lra).
    destruct (fl_any_bounds _ Q) as [B _]; unfold side_factor in *.
    assert (E : eta <= u * r).
    { apply Rle_trans with (u * bpow radix2 (emin + prec)); [|apply Rmult_le_compat_l; lra].
      unfold eta, u; rewrite <- bpow_plus; apply bpow_le; lia. }
    assert (K : 1 + 2.9 * u <= (1 + 4 * u) * (1 - u)) by (clear - U0 U; nra).
    assert (r * (1 + 2.9 * u) <= r * ((1 + 4 * u) * (1 - u))) by (apply Rmult_le_compat_l; lra).
    assert (0 < u * r) by (apply Rmult_lt_0_compat; pose proof (bpow_gt_0 radix2 (emin + prec)); lra).
    lra.
Qed.
End Slack.
