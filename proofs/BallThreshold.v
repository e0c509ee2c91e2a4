(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * The thresholds of a plane for balls

    set_ball_threshold computes, for a shortened normal m, an outside and an inside threshold from
    P = |m0| X + |m1| Y, D = |m0 a0| + |m1 a1| and B = |m0 (b0 - a0)| + |m1 (b1 - a1)|. The test culls when the
    rounded value at the centre is above r + outside, and may call inside when it is at most -inside - r, sums
    rounded. [code_outside_at_least] and
    [code_inside_at_least] say what these numbers are worth after all their own roundings; BallTestCertified.v says
    that this is enough. *)
Require Import Reals Lra Psatz ZArith.
Require Import Flocq.Core.Core.
Require Import Gnomon.RoundingModel.
Open Scope R_scope.

Section BallThresholds.
Context {F : Format}.

(** CertifiedConstants. *)
Definition ball_outside_p : R := 3.
Definition ball_outside_d : R := 3.
Definition ball_outside_b : R := 2.
Definition ball_inside_p : R := 7.1.
Definition ball_inside_d : R := 3.
(** `inflate`. Both decimal constants are rounded when the code reads them. *)
Definition inflate : R := 1.001.

(** The smallest normal number, in eta's place. *)
Definition smallest_normal : R := bpow radix2 (emin + prec - 1).

Definition product_sum (a x b y : R) : R := fl (fl (a * x) + fl (b * y)).
Definition code_underflow (x y : R) : R := fl (smallest_normal * fl (fl (1 + x) + y)).
Definition code_outside (m0 m1 a0 a1 b0 b1 x y : R) : R :=
  let p := product_sum (Rabs m0) x (Rabs m1) y in
  let d := product_sum (Rabs m0) (Rabs a0) (Rabs m1) (Rabs a1) in
  let b := product_sum (Rabs m0) (Rabs (fl (b0 - a0))) (Rabs m1) (Rabs (fl (b1 - a1))) in
  fl (fl (fl (fl inflate * u) *
          fl (fl (fl (ball_outside_p * p) + fl (ball_outside_d * d)) + fl (ball_outside_b * b)))
      + code_underflow x y).
Definition code_inside (m0 m1 a0 a1 x y : R) : R :=
  let p := product_sum (Rabs m0) x (Rabs m1) y in
  let d := product_sum (Rabs m0) (Rabs a0) (Rabs m1) (Rabs a1) in
  fl (fl (fl (fl inflate * u) * fl (fl (fl ball_inside_p * p) + fl (ball_inside_d * d))) + code_underflow x y).

(** ** What the computed thresholds are at least *)

Lemma eta_small : eta <= u * / 16777216.
Proof.
  unfold eta, u; replace (/ 16777216) with (bpow radix2 (-24)) by reflexivity; rewrite <- bpow_plus.
  apply bpow_le; generalize squares_are_safe safe_exponent_positive prec_at_least_24; lia.
Qed.
Lemma smallest_normal_is : smallest_normal * u = eta.
Proof. unfold smallest_normal, u, eta; rewrite <- bpow_plus; f_equal; lia. Qed.

(** The crude form of a rounding that is good enough here: nothing is lost but 10^-7 and eta. *)
Lemma fl_at_least z : 0 <= z -> z * 0.9999999 - eta <= fl z.
Proof.
  intro H; destruct (fl_any_bounds z H) as [L _]; pose proof u_small.
  assert (z * 0.9999999 <= z * (1 - u)) by (apply Rmult_le_compat_l; lra); lra.
Qed.
Lemma fl_sum_at_least x y : 0 <= x -> 0 <= y -> is_float x -> is_float y -> (x + y) * 0.9999999 <= fl (x + y).
Proof.
  intros Hx Hy Fx Fy; assert (H : 0 <= x + y) by lra.
  destruct (fl_plus_bounds x y Fx Fy H) as [L _]; pose proof u_small.
  assert ((x + y) * 0.9999999 <= (x + y) * (1 - u)) by (apply Rmult_le_compat_l; lra); lra.
Qed.
Lemma product_sum_at_least a x b y : 0 <= a -> 0 <= x -> 0 <= b -> 0 <= y ->
  0 <= product_sum a x b y /\ (a * x + b * y) * 0.9999998 - 2 * eta <= product_sum a x b y.
Proof.
  intros Ha Hx Hb Hy; pose proof eta_positive.
  assert (P : 0 <= a * x) by (apply Rmult_le_pos; auto); assert (Q : 0 <= b * y) by (apply Rmult_le_pos; auto).
  pose proof (fl_at_least _ P); pose proof (fl_at_least _ Q).
  pose proof (fl_nonneg _ P) as P1; pose proof (fl_nonneg _ Q) as Q1.
  unfold product_sum; split; [apply fl_nonneg; lra|].
  pose proof (fl_sum_at_least (fl (a * x)) (fl (b * y)) P1 Q1
               (fl_is_float _) (fl_is_float _)); lra.
Qed.

Lemma float_of_bpow_le e : (emin <= e)%Z -> is_float (bpow radix2 e).
Proof. apply is_float_bpow. Qed.
Lemma one_is_float : is_float 1.
Proof.
  change 1 with (bpow radix2 0); apply is_float_bpow.
  generalize squares_are_safe safe_exponent_positive prec_at_least_24; lia.
Qed.

(** The underflow term is worth more than a million eta (1 + x + y). *)
Lemma code_underflow_at_least x y : 0 <= x -> 0 <= y -> is_float x -> is_float y ->
  0 <= code_underflow x y /\ 1000000 * (eta * (1 + x + y)) <= code_underflow x y.
Proof.
  intros Hx Hy Fx Fy; pose proof u_positive as U0; pose proof u_small as U; pose proof eta_positive as E0.
  assert (H1 : (1 + x) * 0.9999999 <= fl (1 + x)) by (apply fl_sum_at_least; auto using one_is_float; lra).
  assert (H2 : (fl (1 + x) + y) * 0.9999999 <= fl (fl (1 + x) + y))
    by (apply fl_sum_at_least; auto using fl_is_float; lra).
  assert (S0 : 0 < smallest_normal) by apply bpow_gt_0.
  set (w := fl (fl (1 + x) + y)) in *.
  assert (W : (1 + x + y) * 0.999 <= w) by lra.
  assert (Z : 0 <= smallest_normal * w) by (apply Rmult_le_pos; lra).
  split; [apply fl_nonneg; exact Z|].
  unfold code_underflow; fold w; eapply Rle_trans; [|apply fl_at_least; exact Z].
  assert (K : 16777216 * eta <= smallest_normal).
  { rewrite <- smallest_normal_is.
    assert (smallest_normal * u <= smallest_normal * / 16777216) by (apply Rmult_le_compat_l; lra); lra. }
  assert (16777216 * eta * ((1 + x + y) * 0.999) <= smallest_normal * w) by (apply Rmult_le_compat; lra).
  assert (eta * 1 <= eta * (1 + x + y)) by (apply Rmult_le_compat_l; lra).
  lra.
Qed.

Lemma fl_near z : 1 <= z -> z * 0.99999 <= fl z.
Proof.
  intro H; eapply Rle_trans; [|apply fl_at_least; lra]; pose proof eta_small; pose proof u_small; lra.
Qed.
Lemma inflated_u : u * 1.0009 <= fl (fl inflate * u).
Proof.
  pose proof u_positive; pose proof eta_small.
  assert (I : 1.00098 <= fl inflate) by (eapply Rle_trans; [|apply fl_near]; unfold inflate; lra).
  assert (Z : u * 1.00098 <= fl inflate * u) by nra.
  assert (P : 0 <= fl inflate * u) by nra.
  pose proof (fl_at_least _ P); lra.
Qed.

Lemma code_outside_at_least m0 m1 a0 a1 b0 b1 x y :
  0 <= x -> 0 <= y -> is_float x -> is_float y -> is_float a0 -> is_float a1 -> is_float b0 -> is_float b1 ->
  u * (3.002 * (Rabs m0 * x + Rabs m1 * y) + 3.002 * (Rabs m0 * Rabs a0 + Rabs m1 * Rabs a1)
       + 2.0016 * (Rabs m0 * Rabs (b0 - a0) + Rabs m1 * Rabs (b1 - a1))) + 100000 * (eta * (1 + x + y))
  <= code_outside m0 m1 a0 a1 b0 b1 x y * (1 - u).
Proof.
  intros Hx Hy Fx Fy Fa0 Fa1 Fb0 Fb1.
  pose proof u_positive as U0; pose proof u_small as U; pose proof eta_positive as E0; pose proof eta_small as Es.
  destruct (product_sum_at_least (Rabs m0) x (Rabs m1) y) as [p0 p1]; auto using Rabs_pos.
  destruct (product_sum_at_least (Rabs m0) (Rabs a0) (Rabs m1) (Rabs a1)) as [d0 d1]; auto using Rabs_pos.
  destruct (product_sum_at_least (Rabs m0) (Rabs (fl (b0 - a0))) (Rabs m1) (Rabs (fl (b1 - a1)))) as [c0 c1];
    auto using Rabs_pos.
  assert (G : forall m b a, is_float b -> is_float a ->
            Rabs m * Rabs (b - a) * 0.9999999 <= Rabs m * Rabs (fl (b - a))).
  { intros m b a Fb Fa; rewrite Rmult_assoc; apply Rmult_le_compat_l; [apply Rabs_pos|].
    destruct (fl_minus b a Fb Fa) as [e [He ->]]; rewrite Rabs_mult; apply Rmult_le_compat_l; [apply Rabs_pos|].
    apply Rabs_le_inv in He; rewrite Rabs_pos_eq; lra. }
  pose proof (G m0 b0 a0 Fb0 Fa0); pose proof (G m1 b1 a1 Fb1 Fa1); clear G.
  destruct (code_underflow_at_least x y Hx Hy Fx Fy) as [w0 w1].
  assert (NN : forall m z, 0 <= Rabs m * Rabs z) by (intros; apply Rmult_le_pos; apply Rabs_pos).
  pose proof (NN m0 (b0 - a0)); pose proof (NN m1 (b1 - a1)); pose proof (NN m0 a0); pose proof (NN m1 a1).
  assert (0 <= Rabs m0 * x) by (apply Rmult_le_pos; auto using Rabs_pos).
  assert (0 <= Rabs m1 * y) by (apply Rmult_le_pos; auto using Rabs_pos).
  clear NN; unfold code_outside, ball_outside_p, ball_outside_d, ball_outside_b.
  set (P := Rabs m0 * x + Rabs m1 * y) in *.
  set (D := Rabs m0 * Rabs a0 + Rabs m1 * Rabs a1) in *.
  set (B := Rabs m0 * Rabs (b0 - a0) + Rabs m1 * Rabs (b1 - a1)).
  set (p := product_sum _ x _ y) in *; set (d := product_sum _ (Rabs a0) _ _) in *.
  set (b := product_sum _ (Rabs (fl _)) _ _) in *.
  assert (c2 : B * 0.9999996 - 2 * eta <= b) by (unfold B; lra).
  assert (B0 : 0 <= B) by (unfold B; lra); assert (P0 : 0 <= P) by (unfold P; lra).
  assert (D0 : 0 <= D) by (unfold D; lra).
  clearbody P D B p d b.
  assert (q1 : 0 <= 3 * p) by lra; assert (q2 : 0 <= 3 * d) by lra; assert (q3 : 0 <= 2 * b) by lra.
  pose proof (fl_at_least _ q1); pose proof (fl_at_least _ q2); pose proof (fl_at_least _ q3).
  pose proof (fl_nonneg _ q1) as r1; pose proof (fl_nonneg _ q2) as r2; pose proof (fl_nonneg _ q3) as r3.
  pose proof (fl_sum_at_least _ _ r1 r2 (fl_is_float _) (fl_is_float _)).
  assert (r4 : 0 <= fl (fl (3 * p) + fl (3 * d))) by (apply fl_nonneg; lra).
  pose proof (fl_sum_at_least _ _ r4 r3 (fl_is_float _) (fl_is_float _)).
  assert (r5 : 0 <= fl (fl (fl (3 * p) + fl (3 * d)) + fl (2 * b))) by (apply fl_nonneg; lra).
  set (T := fl (fl (fl (3 * p) + fl (3 * d)) + fl (2 * b))) in *.
  assert (T1 : (3 * P + 3 * D + 2 * B) * 0.999998 - 30 * eta <= T) by lra.
  pose proof inflated_u as I; set (iu := fl (fl inflate * u)) in *.
  assert (K : u * 1.0009 * T <= iu * T) by (apply Rmult_le_compat_r; lra).
  assert (K0 : 0 <= iu * T) by (apply Rmult_le_pos; lra).
  pose proof (fl_at_least _ K0); pose proof (fl_nonneg _ K0) as r6.
  pose proof (fl_sum_at_least (fl (iu * T)) (code_underflow x y) r6 w0 (fl_is_float _) (fl_is_float _)).
  set (W := code_underflow x y) in *; set (Z := fl (fl (iu * T) + W)) in *.
  assert (Z * 0.9999999 <= Z * (1 - u)) by (apply Rmult_le_compat_l; [apply fl_nonneg|]; lra).
  assert (V : u * ((3 * P + 3 * D + 2 * B) * 0.999998 - 30 * eta) <= u * T) by (apply Rmult_le_compat_l; lra).
  assert (u * (30 * eta) <= / 16777216 * (30 * eta)) by (apply Rmult_le_compat_r; lra).
  assert (eta * 1 <= eta * (1 + x + y)) by (apply Rmult_le_compat_l; lra).
  assert (0 <= u * P) by (apply Rmult_le_pos; lra); assert (0 <= u * D) by (apply Rmult_le_pos; lra).
  assert (0 <= u * B) by (apply Rmult_le_pos; lra).
  lra.
Qed.

Lemma code_inside_at_least m0 m1 a0 a1 x y :
  0 <= x -> 0 <= y -> is_float x -> is_float y ->
  u * (7.105 * (Rabs m0 * x + Rabs m1 * y) + 3.002 * (Rabs m0 * Rabs a0 + Rabs m1 * Rabs a1))
    + 100000 * (eta * (1 + x + y))
  <= code_inside m0 m1 a0 a1 x y * (1 - u).
Proof.
  intros Hx Hy Fx Fy.
  pose proof u_positive as U0; pose proof u_small as U; pose proof eta_positive as E0; pose proof eta_small as Es.
  destruct (product_sum_at_least (Rabs m0) x (Rabs m1) y) as [p0 p1]; auto using Rabs_pos.
  destruct (product_sum_at_least (Rabs m0) (Rabs a0) (Rabs m1) (Rabs a1)) as [d0 d1]; auto using Rabs_pos.
  destruct (code_underflow_at_least x y Hx Hy Fx Fy) as [w0 w1].
  assert (P0 : 0 <= Rabs m0 * x + Rabs m1 * y)
    by (apply Rplus_le_le_0_compat; apply Rmult_le_pos; auto using Rabs_pos).
  assert (D0 : 0 <= Rabs m0 * Rabs a0 + Rabs m1 * Rabs a1)
    by (apply Rplus_le_le_0_compat; apply Rmult_le_pos; auto using Rabs_pos).
  unfold code_inside, ball_inside_d.
  set (P := Rabs m0 * x + Rabs m1 * y) in *.
  set (D := Rabs m0 * Rabs a0 + Rabs m1 * Rabs a1) in *.
  set (p := product_sum _ x _ y) in *; set (d := product_sum _ (Rabs a0) _ _) in *.
  clearbody P D p d.
  assert (c7 : 7.0999 <= fl ball_inside_p) by (eapply Rle_trans; [|apply fl_near]; unfold ball_inside_p; lra).
  assert (q0 : 7.0999 * p <= fl ball_inside_p * p) by (apply Rmult_le_compat_r; lra).
  assert (q1 : 0 <= fl ball_inside_p * p) by lra; assert (q2 : 0 <= 3 * d) by lra.
  pose proof (fl_at_least _ q1); pose proof (fl_at_least _ q2).
  pose proof (fl_nonneg _ q1) as r1; pose proof (fl_nonneg _ q2) as r2.
  pose proof (fl_sum_at_least _ _ r1 r2 (fl_is_float _) (fl_is_float _)).
  set (T := fl (fl (fl ball_inside_p * p) + fl (3 * d))) in *.
  assert (T0 : 0 <= T) by (apply fl_nonneg; lra).
  assert (T1 : (7.0999 * P + 3 * D) * 0.999998 - 30 * eta <= T) by lra.
  pose proof inflated_u as I; set (iu := fl (fl inflate * u)) in *.
  assert (K : u * 1.0009 * T <= iu * T) by (apply Rmult_le_compat_r; lra).
  assert (K0 : 0 <= iu * T) by (apply Rmult_le_pos; lra).
  pose proof (fl_at_least _ K0); pose proof (fl_nonneg _ K0) as r6.
  pose proof (fl_sum_at_least (fl (iu * T)) (code_underflow x y) r6 w0 (fl_is_float _) (fl_is_float _)).
  set (W := code_underflow x y) in *; set (Z := fl (fl (iu * T) + W)) in *.
  assert (Z * 0.9999999 <= Z * (1 - u)) by (apply Rmult_le_compat_l; [apply fl_nonneg|]; lra).
  assert (V : u * ((7.0999 * P + 3 * D) * 0.999998 - 30 * eta) <= u * T) by (apply Rmult_le_compat_l; lra).
  assert (u * (30 * eta) <= / 16777216 * (30 * eta)) by (apply Rmult_le_compat_r; lra).
  assert (eta * 1 <= eta * (1 + x + y)) by (apply Rmult_le_compat_l; lra).
  assert (0 <= u * P) by (apply Rmult_le_pos; lra); assert (0 <= u * D) by (apply Rmult_le_pos; lra).
  lra.
Qed.
End BallThresholds.
