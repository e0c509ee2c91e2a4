(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * The certified ball test never lies about a plane

    The plane test of classify(Shaft, Ball) on the data of form_certified_ball_shaft. [ball_cull_is_right]: a
    rounded value above r + outside proves that the ball misses the shaft. [ball_behind_plane_is_right]: for a
    centre within the extent box, a rounded value of at most -inside - r proves the whole ball behind the plane. *)
Require Import Reals Lra Psatz ZArith.
Require Import Flocq.Core.Core.
Require Import Gnomon.Boxes Gnomon.PlaneSet Gnomon.BoxTest.
Require Import Gnomon.RoundingModel Gnomon.PlaneError Gnomon.BoxTestCertified Gnomon.ShortenedNormal Gnomon.BallThreshold.
Open Scope R_scope.

Section BallPlane.
Context {F : Format}.

(** |c - p| <= r, without a square root. *)
Definition within_ball (c : point) (r : R) (p : point) : Prop :=
  (c X - p X) * (c X - p X) + (c Y - p Y) * (c Y - p Y) + (c Z - p Z) * (c Z - p Z) <= r * r.

Lemma two_axes_of_ball c r p i j : i <> j -> within_ball c r p ->
  (c i - p i) * (c i - p i) + (c j - p j) * (c j - p j) <= r * r.
Proof.
  intros N H; unfold within_ball in H.
  pose proof (Rle_0_sqr (c X - p X)) as HX; pose proof (Rle_0_sqr (c Y - p Y)) as HY.
  pose proof (Rle_0_sqr (c Z - p Z)) as HZ; unfold Rsqr in *.
  destruct i, j; try congruence; lra.
Qed.

(** What shorten() makes of a plane's normal, [k] being its power of two: ShortenedNormal.v. The sign of a component
    survives, as every step is a product with something that is not negative. *)
Record short_normal (A B : box) (f g : face) (m0 m1 c d0 d1 t0 t1 : R) : Prop := {
  short : forall q0 q1 r, 0 <= r -> q0 * q0 + q1 * q1 <= r * r ->
            Rabs m0 * Rabs q0 + Rabs m1 * Rabs q1 <= (1 - ball_shortening * u) * r;
  factor_positive : 0 < c;
  d0_small : Rabs d0 <= 2.0000001 * u;  d1_small : Rabs d1 <= 2.0000001 * u;
  t0_small : Rabs t0 <= 2.1 * eta;      t1_small : Rabs t1 <= 2.1 * eta;
  m0_is : m0 = c * true_n0 A B f g * (1 + d0) + t0;
  m1_is : m1 = c * true_n1 A B f g * (1 + d1) + t1;
  true_short : forall q0 q1 r, 0 <= r -> q0 * q0 + q1 * q1 <= r * r ->
            c * (Rabs (true_n0 A B f g) * Rabs q0 + Rabs (true_n1 A B f g) * Rabs q1) <= (1 - 4 * u) * r;
  m0_outward : 0 <= sgn f * m0;
  m1_outward : 0 <= sgn g * m1
}.

Lemma plane_d_error m0 m1 a0 a1 :
  Rabs (plane_d m0 m1 a0 a1 + (m0 * a0 + m1 * a1)) <=
    2.0000001 * u * (Rabs m0 * Rabs a0 + Rabs m1 * Rabs a1) + 2.5 * eta.
Proof.
  destruct (fl_any (m0 * a0)) as [e6 [t6 [H6 [T6 E6]]]].
  destruct (fl_any (m1 * a1)) as [e7 [t7 [H7 [T7 E7]]]].
  destruct (fl_plus (fl (m0 * a0)) (fl (m1 * a1)) (fl_is_float _) (fl_is_float _)) as [e8 [H8 E8]].
  replace (plane_d m0 m1 a0 a1 + (m0 * a0 + m1 * a1)) with
    (- (m0 * a0 * ((1 + e6) * (1 + e8) - 1)) + - (m1 * a1 * ((1 + e7) * (1 + e8) - 1)) - (0 + 0)
     + (0 - (t6 + t7) * ((1 + e8) * (1 + 0)))) by (unfold plane_d; rewrite E8, E6, E7; ring).
  assert (M : forall m a e, Rabs e <= u -> Rabs (- (m * a * ((1 + e) * (1 + e8) - 1))) <=
            Rabs m * Rabs a * (2.0000001 * u)).
  { intros m a e He; rewrite Rabs_Ropp, 2!Rabs_mult; apply Rmult_le_compat_l;
    [apply Rmult_le_pos; apply Rabs_pos|apply factor2; auto]. }
  assert (Z : Rabs 0 <= u) by (rewrite Rabs_R0; generalize u_positive; lra).
  pose proof (underflow2 t6 t7 e8 0 T6 T7 H8 Z); pose proof (M m0 a0 e6 H6); pose proof (M m1 a1 e7 H7).
  eapply Rle_trans; [apply six_terms|]; rewrite !Rabs_R0; lra.
Qed.

(** What rounding the normal changes of one component's share of the value, within w of the origin. *)
Lemma turned_component_at_most c m n e t v a w : Rabs e <= 2.0000001 * u -> Rabs t <= 2.1 * eta ->
  m = c * n * (1 + e) + t -> Rabs v <= w -> Rabs a <= w -> 0 <= w ->
  Rabs (c * n * (v - a) - m * (v - a)) <= Rabs m * w * (4.001 * u) + 4.4 * (eta * w).
Proof.
  intros He Ht Em Hv Ha Hw; pose proof u_positive as U0; pose proof u_small as U; pose proof eta_positive as T0.
  assert (VA : Rabs (v - a) <= 2 * w)
    by (unfold Rminus; eapply Rle_trans; [apply Rabs_triang|rewrite Rabs_Ropp; lra]).
  assert (CN : Rabs (c * n) <= (Rabs m + 2.1 * eta) * 1.00001).
  { assert (Rabs (c * n) * (1 - 2.0000001 * u) <= Rabs (m - t)).
    { replace (m - t) with (c * n * (1 + e)) by (rewrite Em; ring).
      rewrite (Rabs_mult (c * n)); apply Rmult_le_compat_l; [apply Rabs_pos|].
      apply Rabs_le_inv in He; rewrite Rabs_pos_eq; lra. }
    assert (Rabs (m - t) <= Rabs m + Rabs t)
      by (unfold Rminus; eapply Rle_trans; [apply Rabs_triang|rewrite Rabs_Ropp; lra]).
    pose proof (Rabs_pos (c * n)).
    assert (Rabs (c * n) * (1 - 0.000001) <= Rabs (c * n) * (1 - 2.0000001 * u))
      by (apply Rmult_le_compat_l; lra).
    lra. }
  assert (X1 : Rabs (c * n * e * (v - a)) <= (Rabs m + 2.1 * eta) * 1.00001 * (2.0000001 * u) * (2 * w)).
  { rewrite (Rabs_mult (c * n * e)), (Rabs_mult (c * n) e).
    apply Rmult_le_compat; auto using Rabs_pos; [apply Rmult_le_pos; apply Rabs_pos|].
    apply Rmult_le_compat; auto using Rabs_pos. }
  assert (X2 : Rabs (t * (v - a)) <= 2.1 * eta * (2 * w))
    by (rewrite Rabs_mult; apply Rmult_le_compat; auto using Rabs_pos).
  replace (c * n * (v - a) - m * (v - a)) with (- (c * n * e * (v - a)) + - (t * (v - a))) by (rewrite Em; ring).
  eapply Rle_trans; [apply Rabs_triang|]; rewrite !Rabs_Ropp.
  assert (EW : 0 <= eta * w) by (apply Rmult_le_pos; lra).
  pose proof (u_times_small _ EW) as [UE0 UE].
  assert (MW : 0 <= u * (Rabs m * w)) by (repeat apply Rmult_le_pos; auto using Rabs_pos; lra).
  lra.
Qed.

Section OnePlane.
Variables (A B : box) (f g : face) (m0 m1 c d0 d1 t0 t1 : R).
Hypotheses (wA : valid A) (wB : valid B) (FA : float_box A) (FB : float_box B)
           (N : fst f <> fst g) (Ef : extreme A B f) (Eg : extreme B A g)
           (M : short_normal A B f g m0 m1 c d0 d1 t0 t1).
Let a0 := coord A f. Let a1 := coord A g. Let b0 := coord B f. Let b1 := coord B g.
Let x := extent_magnitude A B (fst f). Let y := extent_magnitude A B (fst g).
Let d := plane_d m0 m1 a0 a1.
Let P := Rabs m0 * x + Rabs m1 * y.
Let D := Rabs m0 * Rabs a0 + Rabs m1 * Rabs a1.
Let W := Rabs m0 * Rabs (b0 - a0) + Rabs m1 * Rabs (b1 - a1).

Lemma corner_magnitude (b : box) h : b = A \/ b = B ->
  Rabs (coord b h) <= extent_magnitude A B (fst h).
Proof.
  intro E; apply extent_magnitude_covers.
  pose proof (wA (fst h)); pose proof (wB (fst h)).
  pose proof (Rmin_l (lo A (fst h)) (lo B (fst h))); pose proof (Rmin_r (lo A (fst h)) (lo B (fst h))).
  pose proof (Rmax_l (hi A (fst h)) (hi B (fst h))); pose proof (Rmax_r (hi A (fst h)) (hi B (fst h))).
  destruct E as [-> | ->], h as [k []]; cbv [coord fst snd] in *; lra.
Qed.

Lemma xy_facts : 0 <= x /\ 0 <= y /\ Rabs a0 <= x /\ Rabs a1 <= y /\
  Rabs (b0 - a0) <= 2 * x /\ Rabs (b1 - a1) <= 2 * y.
Proof.
  pose proof (corner_magnitude A f (or_introl eq_refl)); pose proof (corner_magnitude A g (or_introl eq_refl)).
  pose proof (corner_magnitude B f (or_intror eq_refl)); pose proof (corner_magnitude B g (or_intror eq_refl)).
  fold a0 x in H; fold a1 y in H0; fold b0 x in H1; fold b1 y in H2.
  pose proof (Rabs_pos a0); pose proof (Rabs_pos a1).
  assert (K : forall p q, Rabs (p - q) <= Rabs p + Rabs q)
    by (intros; unfold Rminus; eapply Rle_trans; [apply Rabs_triang|rewrite Rabs_Ropp; lra]).
  pose proof (K b0 a0); pose proof (K b1 a1); repeat split; lra.
Qed.

(** The edge of B lies in the plane only nearly, as the components of the normal carry different roundings (claim S19
    in floats): by at most 2.001 u W and underflow. *)
Lemma other_edge : m0 * (b0 - a0) + m1 * (b1 - a1) <= 2.001 * u * W + 9 * eta * (x + y).
Proof.
  pose proof u_positive as U0; pose proof u_small as U; pose proof eta_positive as T0.
  destruct xy_facts as [x0 [y0 [_ [_ [Hx Hy]]]]].
  destruct M as [_ c0 D0 D1 S0 S1 E0 E1 _ _ _].
  set (K := c * true_n0 A B f g * (b0 - a0)).
  assert (K' : c * true_n1 A B f g * (b1 - a1) = - K).
  { unfold K, true_n0, true_n1, a0, a1, b0, b1.
    destruct f as [i []], g as [j []]; cbv [sgn coord fst snd]; ring. }
  assert (V0 : m0 * (b0 - a0) = K + K * d0 + t0 * (b0 - a0)) by (unfold K; rewrite E0; ring).
  assert (V1 : m1 * (b1 - a1) = - K - K * d1 + t1 * (b1 - a1)).
  { replace (- K - K * d1) with (- K * (1 + d1)) by ring; rewrite <- K', E1; ring. }
  assert (Q : forall s z, Rabs s <= 2.0000001 * u -> Rabs (z * s) <= Rabs z * (2.0000001 * u))
    by (intros; rewrite Rabs_mult; apply Rmult_le_compat_l; auto using Rabs_pos).
  assert (R0 : Rabs (t0 * (b0 - a0)) <= 2.1 * eta * (2 * x))
    by (rewrite Rabs_mult; apply Rmult_le_compat; auto using Rabs_pos).
  assert (R1 : Rabs (t1 * (b1 - a1)) <= 2.1 * eta * (2 * y))
    by (rewrite Rabs_mult; apply Rmult_le_compat; auto using Rabs_pos).
  pose proof (Q d0 K D0) as Q0; pose proof (Q d1 K D1) as Q1.
  (* |K| from W *)
  assert (L0 : Rabs K - Rabs K * (2.0000001 * u) - 2.1 * eta * (2 * x) <= Rabs m0 * Rabs (b0 - a0)).
  { rewrite <- Rabs_mult, V0.
    pose proof (Rabs_triang (K + K * d0 + t0 * (b0 - a0)) (- (K * d0) + - (t0 * (b0 - a0)))) as T.
    pose proof (Rabs_triang (- (K * d0)) (- (t0 * (b0 - a0)))) as T'; rewrite !Rabs_Ropp in T'.
    replace (K + K * d0 + t0 * (b0 - a0) + (- (K * d0) + - (t0 * (b0 - a0)))) with K in T by ring; lra. }
  assert (L1 : Rabs K - Rabs K * (2.0000001 * u) - 2.1 * eta * (2 * y) <= Rabs m1 * Rabs (b1 - a1)).
  { rewrite <- Rabs_mult, V1.
    pose proof (Rabs_triang (- K - K * d1 + t1 * (b1 - a1)) (K * d1 + - (t1 * (b1 - a1)))) as T.
    pose proof (Rabs_triang (K * d1) (- (t1 * (b1 - a1)))) as T'; rewrite Rabs_Ropp in T'.
    replace (- K - K * d1 + t1 * (b1 - a1) + (K * d1 + - (t1 * (b1 - a1)))) with (- K) in T by ring.
    rewrite Rabs_Ropp in T; lra. }
  pose proof (Rabs_pos K) as k0.
  assert (KU : Rabs K * (2.0000001 * u) <= Rabs K * 0.00001) by (apply Rmult_le_compat_l; lra).
  assert (K2 : Rabs K <= (W + 4.2 * eta * (x + y)) * 0.50001) by (unfold W; lra).
  assert (K3 : Rabs K * (2.0000001 * u) <= (W + 4.2 * eta * (x + y)) * 0.50001 * (2.0000001 * u))
    by (apply Rmult_le_compat_r; lra).
  assert (W0 : 0 <= W) by (unfold W; apply Rplus_le_le_0_compat; apply Rmult_le_pos; apply Rabs_pos).
  assert (UW : 0 <= u * W) by (apply Rmult_le_pos; lra).
  assert (EX : 0 <= eta * (x + y)) by (apply Rmult_le_pos; lra).
  pose proof (u_times_small _ EX) as [_ US].
  apply Rabs_le_inv in Q0; apply Rabs_le_inv in Q1; apply Rabs_le_inv in R0; apply Rabs_le_inv in R1.
  lra.
Qed.

(** No point of the shaft is more than that beyond the edge of A, measured with the shortened normal. *)
Lemma shaft_behind_shortened p : hull A B p ->
  m0 * p (fst f) + m1 * p (fst g) - (m0 * a0 + m1 * a1) <= 2.001 * u * W + 9 * eta * (x + y).
Proof.
  intro Hp; apply hull_is_union_of_boxes in Hp; auto; destruct Hp as [s [Hs H]].
  pose proof other_edge as O.
  assert (G : forall h m, 0 <= sgn h * m ->
            m * p (fst h) - m * coord A h <= s * (m * (coord B h - coord A h))).
  { intros h m Hm; specialize (H (fst h)); unfold lerp in H.
    destruct h as [k []]; cbv [sgn coord fst snd] in *.
    - assert (- m * ((1 - s) * lo A k + s * lo B k) <= - m * p k) by (apply Rmult_le_compat_l; lra); lra.
    - assert (m * p k <= m * ((1 - s) * hi A k + s * hi B k)) by (apply Rmult_le_compat_l; lra); lra. }
  pose proof (G f m0 (m0_outward _ _ _ _ _ _ _ _ _ _ _ M)) as G0.
  pose proof (G g m1 (m1_outward _ _ _ _ _ _ _ _ _ _ _ M)) as G1.
  fold a0 b0 in G0; fold a1 b1 in G1.
  destruct xy_facts as [x0 [y0 _]]; pose proof u_positive; pose proof eta_positive.
  assert (W0 : 0 <= W) by (unfold W; apply Rplus_le_le_0_compat; apply Rmult_le_pos; apply Rabs_pos).
  assert (uW : 0 <= u * W) by (apply Rmult_le_pos; lra).
  assert (exy : 0 <= eta * (x + y)) by (apply Rmult_le_pos; lra).
  assert (0 <= 2.001 * u * W + 9 * eta * (x + y)) by lra.
  set (e := m0 * (b0 - a0) + m1 * (b1 - a1)) in *; set (E := 2.001 * u * W + 9 * eta * (x + y)) in *.
  assert (s * e <= E).
  { apply Rle_trans with (s * E); [apply Rmult_le_compat_l; lra|].
    rewrite <- (Rmult_1_l E) at 2; apply Rmult_le_compat_r; lra. }
  unfold e in *; lra.
Qed.

Let outside := code_outside m0 m1 a0 a1 b0 b1 x y.
Let inside := code_inside m0 m1 a0 a1 x y.
Let value (z : point) := plane_value m0 m1 d (z (fst f)) (z (fst g)).

Lemma d_magnitude : Rabs d <= D * 1.000001 + 2.5 * eta.
Proof.
  pose proof (plane_d_error m0 m1 a0 a1) as E; fold d D in E.
  pose proof u_positive; pose proof u_small.
  assert (D0 : 0 <= D) by (unfold D; apply Rplus_le_le_0_compat; apply Rmult_le_pos; apply Rabs_pos).
  assert (2.0000001 * u * D <= 0.000001 * D) by (apply Rmult_le_compat_r; lra).
  assert (Rabs (m0 * a0 + m1 * a1) <= D).
  { eapply Rle_trans; [apply Rabs_triang|]; rewrite !Rabs_mult; unfold D; lra. }
  pose proof (Rabs_triang (d + (m0 * a0 + m1 * a1)) (- (m0 * a0 + m1 * a1))) as T.
  rewrite Rabs_Ropp in T.
  replace (d + (m0 * a0 + m1 * a1) + - (m0 * a0 + m1 * a1)) with d in T by ring; lra.
Qed.

Theorem ball_cull_is_right z r : 0 <= r -> is_float r ->
  value z > fl (r + outside) -> ~ exists p, hull A B p /\ within_ball z r p.
Proof.
  intros Hr Fr V [p [Hp Bp]].
  pose proof u_positive as U0; pose proof u_small as U; pose proof eta_positive as T0.
  destruct xy_facts as [x0 [y0 _]].
  pose proof (shaft_within_extent A B p wA wB Hp) as E.
  pose proof (extent_magnitude_covers A B _ _ (E (fst f))) as Px; fold x in Px.
  pose proof (extent_magnitude_covers A B _ _ (E (fst g))) as Py; fold y in Py.
  pose proof (two_axes_of_ball z r p _ _ N Bp) as Q2.
  pose proof (short _ _ _ _ _ _ _ _ _ _ _ M _ _ _ Hr Q2) as Q.
  pose proof (shaft_behind_shortened p Hp) as S.
  pose proof (plane_value_error_as_stored m0 m1 d (z (fst f)) (z (fst g)) (plane_d_is_float _ _ _ _)) as VE.
  fold (value z) in VE; apply Rabs_le_inv in VE; destruct VE as [_ VE].
  pose proof (plane_d_error m0 m1 a0 a1) as DE; fold d D in DE; apply Rabs_le_inv in DE.
  pose proof d_magnitude as DM.
  assert (Fo : is_float outside) by apply fl_is_float.
  assert (FX : is_float x) by (apply extent_magnitude_float; auto).
  assert (FY : is_float y) by (apply extent_magnitude_float; auto).
  pose proof (code_outside_at_least m0 m1 a0 a1 b0 b1 x y x0 y0 FX FY (FA f) (FA g) (FB f) (FB g)) as O.
  fold outside P D W in O.
  set (q0 := z (fst f) - p (fst f)) in *; set (q1 := z (fst g) - p (fst g)) in *.
  assert (Z0 : z (fst f) = p (fst f) + q0) by (unfold q0; ring).
  assert (Z1 : z (fst g) = p (fst g) + q1) by (unfold q1; ring).
  rewrite Z0, Z1 in VE; clearbody q0 q1.
  set (QQ := Rabs m0 * Rabs q0 + Rabs m1 * Rabs q1) in *.
  assert (MQ : m0 * q0 + m1 * q1 <= QQ).
  { unfold QQ; rewrite <- !Rabs_mult; pose proof (Rle_abs (m0 * q0)); pose proof (Rle_abs (m1 * q1)); lra. }
  assert (MC : Rabs m0 * Rabs (p (fst f) + q0) + Rabs m1 * Rabs (p (fst g) + q1) <= P + QQ).
  { assert (G : forall m v q w, Rabs v <= w -> Rabs m * Rabs (v + q) <= Rabs m * w + Rabs m * Rabs q).
    { intros m v q w Hw; rewrite <- Rmult_plus_distr_l; apply Rmult_le_compat_l; [apply Rabs_pos|].
      eapply Rle_trans; [apply Rabs_triang|lra]. }
    pose proof (G m0 _ q0 _ Px); pose proof (G m1 _ q1 _ Py); unfold P, QQ; lra. }
  assert (QQ0 : 0 <= QQ) by (unfold QQ; apply Rplus_le_le_0_compat; apply Rmult_le_pos; apply Rabs_pos).
  assert (P0 : 0 <= P) by (unfold P; apply Rplus_le_le_0_compat; apply Rmult_le_pos; auto using Rabs_pos).
  assert (D0 : 0 <= D) by (unfold D; apply Rplus_le_le_0_compat; apply Rmult_le_pos; apply Rabs_pos).
  assert (W0 : 0 <= W) by (unfold W; apply Rplus_le_le_0_compat; apply Rmult_le_pos; apply Rabs_pos).
  assert (uP : 0 <= u * P) by (apply Rmult_le_pos; lra); assert (uD : 0 <= u * D) by (apply Rmult_le_pos; lra).
  assert (uW : 0 <= u * W) by (apply Rmult_le_pos; lra).
  assert (ex : 0 <= eta * x) by (apply Rmult_le_pos; lra); assert (ey : 0 <= eta * y) by (apply Rmult_le_pos; lra).
  assert (o0 : 0 <= outside) by (apply Rmult_le_reg_r with (1 - u); lra).
  assert (RO : 0 <= r + outside) by lra.
  destruct (fl_plus_bounds r outside Fr Fo RO) as [RB _].
  unfold ball_shortening in Q.
  (* what multiplies u *)
  set (C := Rabs m0 * Rabs (p (fst f) + q0) + Rabs m1 * Rabs (p (fst g) + q1)) in *.
  assert (U1 : u * (3.000001 * C + Rabs d) <= u * (3.000001 * (P + QQ) + (D * 1.000001 + 2.5 * eta)))
    by (apply Rmult_le_compat_l; lra).
  assert (U2 : u * (2.5 * eta) <= / 16777216 * (2.5 * eta)) by (apply Rmult_le_compat_r; lra).
  assert (QR : QQ * (1 + 3.000001 * u) <= (1 - 5 * u) * r * (1 + 3.000001 * u)) by (apply Rmult_le_compat_r; lra).
  assert (QR2 : (1 - 5 * u) * r * (1 + 3.000001 * u) <= r * (1 - u)).
  { replace ((1 - 5 * u) * r * (1 + 3.000001 * u)) with (r * ((1 - 5 * u) * (1 + 3.000001 * u))) by ring.
    apply Rmult_le_compat_l; [exact Hr|]; clear - U0 U; nra. }
  clearbody C P D W QQ outside d.
  lra.
Qed.

Theorem ball_behind_plane_is_right z r : 0 <= r -> is_float r -> in_extent A B z ->
  value z <= fl (- inside - r) ->
  forall p, within_ball z r p ->
    dot (normal (edge_plane A B f g)) p <= offset (edge_plane A B f g).
Proof.
  intros Hr Fr E V p Bp.
  pose proof u_positive as U0; pose proof u_small as U; pose proof eta_positive as T0.
  destruct xy_facts as [x0 [y0 [Hax [Hay _]]]].
  pose proof (extent_magnitude_covers A B _ _ (E (fst f))) as Zx; fold x in Zx.
  pose proof (extent_magnitude_covers A B _ _ (E (fst g))) as Zy; fold y in Zy.
  assert (Bp' : within_ball p r z) by (unfold within_ball in *; lra).
  pose proof (two_axes_of_ball p r z _ _ N Bp') as Q2.
  pose proof (true_short _ _ _ _ _ _ _ _ _ _ _ M _ _ _ Hr Q2) as Q.
  pose proof (plane_value_error_as_stored m0 m1 d (z (fst f)) (z (fst g)) (plane_d_is_float _ _ _ _)) as VE.
  fold (value z) in VE; apply Rabs_le_inv in VE; destruct VE as [VE _].
  pose proof (plane_d_error m0 m1 a0 a1) as DE; fold d D in DE; apply Rabs_le_inv in DE.
  pose proof d_magnitude as DM.
  assert (FX : is_float x) by (apply extent_magnitude_float; auto).
  assert (FY : is_float y) by (apply extent_magnitude_float; auto).
  pose proof (code_inside_at_least m0 m1 a0 a1 x y x0 y0 FX FY) as I; fold inside P D in I.
  assert (P0 : 0 <= P) by (unfold P; apply Rplus_le_le_0_compat; apply Rmult_le_pos; auto using Rabs_pos).
  assert (D0 : 0 <= D) by (unfold D; apply Rplus_le_le_0_compat; apply Rmult_le_pos; apply Rabs_pos).
  assert (uP : 0 <= u * P) by (apply Rmult_le_pos; lra); assert (uD : 0 <= u * D) by (apply Rmult_le_pos; lra).
  assert (ex : 0 <= eta * x) by (apply Rmult_le_pos; lra); assert (ey : 0 <= eta * y) by (apply Rmult_le_pos; lra).
  (* the bound after its rounding *)
  assert (I0 : 0 <= inside) by (apply Rmult_le_reg_r with (1 - u); lra).
  assert (RI : fl (- inside - r) <= - ((inside + r) * (1 - u))).
  { replace (- inside - r) with (- (inside + r)) by ring; rewrite fl_opp.
    assert (S0 : 0 <= inside + r) by lra.
    destruct (fl_plus_bounds inside r (fl_is_float _) Fr S0); lra. }
  (* the turned normal *)
  destruct M as [_ c0 D0' D1' S0' S1' E0' E1' _ _ _].
  set (n0 := true_n0 A B f g) in *; set (n1 := true_n1 A B f g) in *.
  set (z0 := z (fst f)) in *; set (z1 := z (fst g)) in *.
  pose proof (turned_component_at_most c m0 n0 d0 t0 z0 a0 x D0' S0' E0' Zx Hax x0) as TU0.
  pose proof (turned_component_at_most c m1 n1 d1 t1 z1 a1 y D1' S1' E1' Zy Hay y0) as TU1.
  apply Rabs_le_inv in TU0; apply Rabs_le_inv in TU1.
  (* the value at the centre *)
  assert (MC : Rabs m0 * Rabs z0 + Rabs m1 * Rabs z1 <= P)
    by (unfold P; apply Rplus_le_compat; apply Rmult_le_compat_l; auto using Rabs_pos).
  assert (U1 : u * (3.000001 * (Rabs m0 * Rabs z0 + Rabs m1 * Rabs z1) + Rabs d) <=
               u * (3.000001 * P + (D * 1.000001 + 2.5 * eta))) by (apply Rmult_le_compat_l; lra).
  assert (U2 : u * (2.5 * eta) <= / 16777216 * (2.5 * eta)) by (apply Rmult_le_compat_r; lra).
  assert (CENTRE : c * n0 * (z0 - a0) + c * n1 * (z1 - a1) <= - (r * (1 - u))).
  { unfold P in *; lra. }
  (* from the centre to p *)
  set (q0 := p (fst f) - z0) in *; set (q1 := p (fst g) - z1) in *.
  assert (STEP : c * (n0 * q0 + n1 * q1) <= (1 - 4 * u) * r).
  { eapply Rle_trans; [|exact Q]; apply Rmult_le_compat_l; [left; exact c0|]; rewrite <- !Rabs_mult.
    pose proof (Rle_abs (n0 * q0)); pose proof (Rle_abs (n1 * q1)); lra. }
  assert (UR : 0 <= u * r) by (apply Rmult_le_pos; lra).
  assert (ALL : c * true_value A B f g (p (fst f)) (p (fst g)) <= 0).
  { unfold true_value, exact_value; fold n0 n1 a0 a1; unfold q0, q1 in *; lra. }
  apply Rnot_lt_le; intro O.
  assert (T : 0 < true_value A B f g (p (fst f)) (p (fst g))) by (rewrite true_value_is_the_plane by auto; lra).
  assert (0 < c * true_value A B f g (p (fst f)) (p (fst g))) by (apply Rmult_lt_0_compat; auto); lra.
Qed.
End OnePlane.
End BallPlane.
