(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * The stated gap of the certified box test

    box_gap() computes 2 threshold / (|n0| + |n1|), inflated; all of it rounds. [box_gap_is_enough]: that is at least
    the exact 2 threshold / (|N0| + |N1|). So a box that a plane keeps is, when grown by the gap on all sides, not
    beyond that plane exactly ([kept_box_grown_is_not_beyond]); and one whose far corner a plane does not accept, grown
    likewise, has a point beyond it ([refused_box_grown_is_not_behind]). For the whole shaft: [kept_box_grown_meets]. *)
Require Import Reals Lra Psatz ZArith List Bool Lia.
Require Import Flocq.Core.Core.
Require Import Gnomon.Boxes Gnomon.PlaneSet Gnomon.BoxTest Gnomon.SlabBox.
Require Import Gnomon.RoundingModel Gnomon.PlaneError Gnomon.BoxThreshold Gnomon.BoxTestCertified.
Require Import Gnomon.Overflow Gnomon.CertifiedBoxTest.
Open Scope R_scope.

Section Gap.
Context {F : Format}.

Definition gap_inflation : R := 16.
Definition code_box_gap (n0 n1 threshold : R) : R :=
  fl (fl (fl (fl (2 * threshold) / fl (Rabs n0 + Rabs n1)) * (1 + gap_inflation * u)) + 2 * eta).

Definition grown (T : box) (gap : R) : box := Box (fun i => lo T i - gap) (fun i => hi T i + gap).

Lemma two_eta_is_float : is_float (2 * eta).
Proof.
  replace (2 * eta) with (bpow radix2 emin); [apply is_float_bpow; lia|].
  unfold eta; replace emin with (1 + (emin - 1))%Z at 1 by lia.
  rewrite bpow_plus; change (bpow radix2 1) with 2; ring.
Qed.

Theorem box_gap_is_enough N0 N1 e0 e1 t :
  Rabs e0 <= u -> Rabs e1 <= u -> is_float t -> 0 <= t -> N0 <> 0 ->
  let n0 := N0 * (1 + e0) in let n1 := N1 * (1 + e1) in is_float n0 -> is_float n1 ->
  2 * t <= code_box_gap n0 n1 t * (Rabs N0 + Rabs N1).
Proof.
  intros H0 H1 Ft T0 Z0 n0 n1 F0 F1.
  pose proof u_positive as U0; pose proof u_small as U; pose proof eta_positive as E0.
  assert (K : forall N e, Rabs e <= u -> Rabs N * (1 - u) <= Rabs (N * (1 + e)) <= Rabs N * (1 + u)).
  { intros N e He; apply Rabs_le_inv in He; rewrite Rabs_mult, (Rabs_pos_eq (1 + e)) by lra.
    split; apply Rmult_le_compat_l; try apply Rabs_pos; lra. }
  pose proof (K N0 e0 H0) as K0; pose proof (K N1 e1 H1) as K1; fold n0 in K0; fold n1 in K1.
  set (L := Rabs N0 + Rabs N1); assert (L0 : 0 < L) by (unfold L; pose proof (Rabs_pos_lt N0 Z0); pose proof (Rabs_pos N1); lra).
  assert (P : 0 <= Rabs n0 + Rabs n1) by (pose proof (Rabs_pos n0); pose proof (Rabs_pos n1); lra).
  destruct (fl_plus_bounds _ _ (is_float_abs _ F0) (is_float_abs _ F1) P) as [A A'].
  assert (l1 : L * (1 - u) <= Rabs n0 + Rabs n1 <= L * (1 + u)) by (unfold L; lra).
  assert (l2 : fl (Rabs n0 + Rabs n1) <= L * (1 + u) * (1 + u))
    by (eapply Rle_trans; [exact A'|apply Rmult_le_compat_r; lra]).
  assert (l3 : 0 < fl (Rabs n0 + Rabs n1)).
  { eapply Rlt_le_trans; [|exact A]; apply Rmult_lt_0_compat; [|lra].
    eapply Rlt_le_trans; [|apply l1]; apply Rmult_lt_0_compat; lra. }
  assert (t2 : 2 * t * (1 - u) <= fl (2 * t)).
  { replace (2 * t) with (t + t) by ring; apply fl_plus_bounds; auto; lra. }
  unfold code_box_gap, gap_inflation; set (l := fl (Rabs n0 + Rabs n1)) in *.
  set (w := fl (2 * t)) in *; set (z := 2 * t / L).
  assert (zL : z * L = 2 * t) by (unfold z; field; lra).
  assert (z0 : 0 <= z) by (unfold z; apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat, L0]).
  assert (w0 : 0 <= w) by (eapply Rle_trans; [|exact t2]; apply Rmult_le_pos; lra).
  assert (q1 : z * (1 - 3 * u - 3 * (u * u)) <= w / l).
  { apply Rmult_le_reg_r with l; [exact l3|]; replace (w / l * l) with w by (field; lra).
    assert (c0 : 0 <= 1 - 3 * u - 3 * (u * u)) by (clear - U0 U; nra).
    apply Rle_trans with (z * (1 - 3 * u - 3 * (u * u)) * (L * (1 + u) * (1 + u))).
    - apply Rmult_le_compat_l; [apply Rmult_le_pos; assumption|exact l2].
    - replace (z * (1 - 3 * u - 3 * (u * u)) * (L * (1 + u) * (1 + u))) with
        (z * L * ((1 - 3 * u - 3 * (u * u)) * ((1 + u) * (1 + u)))) by ring; rewrite zL.
      eapply Rle_trans; [|exact t2]; apply Rmult_le_compat_l; [lra|clear - U0 U; nra]. }
  assert (q0 : 0 <= w / l) by (apply Rmult_le_pos; [exact w0|left; apply Rinv_0_lt_compat, l3]).
  destruct (fl_any_bounds _ q0) as [Q _]; pose proof (fl_nonneg _ q0) as Q0; set (q := fl (w / l)) in *.
  assert (g0 : 0 <= q * (1 + 16 * u)) by (apply Rmult_le_pos; lra).
  destruct (fl_any_bounds _ g0) as [G _]; pose proof (fl_nonneg _ g0) as G0; set (g := fl (q * (1 + 16 * u))) in *.
  assert (S0 : 0 <= g + 2 * eta) by lra.
  destruct (fl_plus_bounds g (2 * eta) (fl_is_float _) two_eta_is_float S0) as [S _].
  enough (z <= fl (g + 2 * eta)) by (rewrite <- zL; apply Rmult_le_compat_r; lra).
  destruct (Rle_lt_dec z (2 * eta)) as [C|C].
  - rewrite <- (fl_of_float (2 * eta) two_eta_is_float) in C; eapply Rle_trans; [exact C|]; apply fl_le; lra.
  - eapply Rle_trans; [|exact S].
    assert (b1 : z * (1 - 4.1 * u) - eta <= q).
    { assert (z * (1 - 3 * u - 3 * (u * u)) * (1 - u) <= w / l * (1 - u)) by (apply Rmult_le_compat_r; lra).
      assert (z * (1 - 4.1 * u) <= z * ((1 - 3 * u - 3 * (u * u)) * (1 - u))) by (apply Rmult_le_compat_l; [exact z0|clear - U0 U; nra]).
      lra. }
    assert (b2 : (z * (1 - 4.1 * u) - eta) * ((1 + 16 * u) * (1 - u)) <= q * ((1 + 16 * u) * (1 - u)))
      by (apply Rmult_le_compat_r; [clear - U0 U; nra|exact b1]).
    assert (b3 : z * (1 + 10.8 * u) <= z * ((1 - 4.1 * u) * ((1 + 16 * u) * (1 - u)))) by (apply Rmult_le_compat_l; [exact z0|clear - U0 U; nra]).
    assert (b4 : eta * ((1 + 16 * u) * (1 - u)) <= eta * (1 + 15 * u)) by (apply Rmult_le_compat_l; [lra|clear - U0 U; nra]).
    assert (b5 : z * (1 + 10.8 * u) - 15 * (u * eta) <= g + 2 * eta) by lra.
    assert (b6 : u * (2 * eta) <= u * z) by (apply Rmult_le_compat_l; lra).
    assert (b6' : 0 <= u * eta) by (apply Rmult_le_pos; lra).
    assert (b7 : z * (1 + 3 * u) <= g + 2 * eta) by lra.
    assert (b8 : z * (1 + 3 * u) * (1 - u) <= (g + 2 * eta) * (1 - u)) by (apply Rmult_le_compat_r; lra).
    assert (b9 : z * 1 <= z * ((1 + 3 * u) * (1 - u))) by (apply Rmult_le_compat_l; [exact z0|clear - U0 U; nra]).
    lra.
Qed.

Section OnePlane.
Variables (A B : box) (f g : face).
Hypotheses (wA : valid A) (wB : valid B) (FA : float_box A) (FB : float_box B)
           (N : fst f <> fst g) (Ef : extreme A B f) (Eg : extreme B A g).
Let gap := code_box_gap (code_n0 A B f g) (code_n1 A B f g) (code_threshold A B f g).
Let growth := Rabs (true_n0 A B f g) + Rabs (true_n1 A B f g).

Lemma threshold_not_negative : 0 <= code_threshold A B f g.
Proof.
  pose proof (value_within_threshold A B f g FA FB N Ef Eg (coord A f) (coord A g)
    (coord_in_extent A B wA wB A f (or_introl eq_refl)) (coord_in_extent A B wA wB A g (or_introl eq_refl))) as V.
  pose proof (Rabs_pos (code_value A B f g (coord A f) (coord A g) - true_value A B f g (coord A f) (coord A g))); lra.
Qed.

Lemma gap_pays : 2 * code_threshold A B f g <= gap * growth.
Proof.
  destruct (code_normal A B f g FA FB N Ef Eg) as [e0 [e1 [H0 [H1 [E0 E1]]]]].
  assert (S : forall h z, is_float z -> is_float (sgn h * z)).
  { intros [i []] z Fz; unfold sgn, snd; [|rewrite Rmult_1_l; exact Fz].
    replace (-1 * z) with (- z) by ring; apply is_float_opp, Fz. }
  assert (F0 : is_float (code_n0 A B f g)) by (apply S, is_float_abs, fl_is_float).
  assert (F1 : is_float (code_n1 A B f g)) by (apply S, is_float_abs, fl_is_float).
  unfold gap, growth; rewrite E0, E1 in *; apply box_gap_is_enough; auto.
  - apply fl_is_float.
  - unfold code_threshold at 1; apply threshold_not_negative.
  - unfold true_n0, extreme in *; destruct f as [i []], g as [j []]; cbv [sgn coord fst snd] in *; lra.
Qed.

(** Growing T by some length on all sides lowers the near value, and raises the far one, by that times |N0| + |N1|. *)
Lemma grown_near T r : true_value A B f g (near_coord (grown T r) f) (near_coord (grown T r) g) =
  true_value A B f g (near_coord T f) (near_coord T g) - r * growth.
Proof.
  unfold growth, true_value, exact_value, true_n0, true_n1, extreme, grown in *.
  destruct f as [i []], g as [j []]; cbv [sgn coord near_coord fst snd lo hi] in *;
  repeat first [rewrite Rabs_pos_eq by lra | rewrite Rabs_left by lra]; ring.
Qed.
Lemma grown_far T r : true_value A B f g (coord (grown T r) f) (coord (grown T r) g) =
  true_value A B f g (coord T f) (coord T g) + r * growth.
Proof.
  unfold growth, true_value, exact_value, true_n0, true_n1, extreme, grown in *.
  destruct f as [i []], g as [j []]; cbv [sgn coord fst snd lo hi] in *;
  repeat first [rewrite Rabs_pos_eq by lra | rewrite Rabs_left by lra]; ring.
Qed.
Lemma growth_not_negative : 0 <= growth.
Proof. unfold growth; pose proof (Rabs_pos (true_n0 A B f g)); pose proof (Rabs_pos (true_n1 A B f g)); lra. Qed.

Theorem kept_box_grown_is_not_beyond T r : valid T -> 0 <= r -> gap <= r ->
  (forall i, lo T i <= Rmax (hi A i) (hi B i) /\ Rmin (lo A i) (lo B i) <= hi T i) ->
  code_value A B f g (near_coord T f) (near_coord T g) <= code_threshold A B f g ->
  ~ beyond (edge_plane A B f g) (grown T r).
Proof.
  intros wT R0 R M V O.
  assert (wG : valid (grown T r)) by (intro i; specialize (wT i); unfold grown; simpl; lra).
  apply beyond_iff_near_corner in O; auto; rewrite offset_edge_plane in O.
  pose proof (certified_keep_is_near A B f g wA wB FA FB N Ef Eg T M V) as K; pose proof gap_pays as G.
  assert (gap * growth <= r * growth) by (apply Rmult_le_compat_r; [apply growth_not_negative|exact R]).
  pose proof (grown_near T r) as E.
  assert (X : true_value A B f g (near_coord (grown T r) f) (near_coord (grown T r) g) > 0); [|lra].
  clear - O; unfold true_value, exact_value, true_n0, true_n1.
  destruct f as [i []], g as [j []]; cbv [sgn coord near_coord near_reach fst snd] in *; lra.
Qed.

Theorem refused_box_grown_is_not_behind T r : valid T -> 0 <= r -> gap <= r ->
  (forall i, Rmin (lo A i) (lo B i) <= lo T i /\ hi T i <= Rmax (hi A i) (hi B i)) ->
  code_value A B f g (coord T f) (coord T g) > - code_threshold A B f g ->
  ~ forall x, in_box (grown T r) x -> hull A B x.
Proof.
  intros wT R0 R M V O.
  assert (wG : valid (grown T r)) by (intro i; specialize (wT i); unfold grown; simpl; lra).
  apply inside_test_is_exact in O; auto; destruct O as [_ O]; specialize (O f g N Ef Eg); rewrite offset_edge_plane in O.
  pose proof (value_within_threshold A B f g FA FB N Ef Eg _ _ (far_in_extent A B T wT M f) (far_in_extent A B T wT M g)) as K.
  apply Rabs_le_inv in K; pose proof gap_pays as G; pose proof (grown_far T r) as E.
  assert (gap * growth <= r * growth) by (apply Rmult_le_compat_r; [apply growth_not_negative|exact R]).
  assert (X : true_value A B f g (coord (grown T r) f) (coord (grown T r) g) <= 0); [|lra].
  clear - O; unfold true_value, exact_value, true_n0, true_n1, far_reach in *.
  destruct f as [i []], g as [j []]; cbv [sgn coord fst snd] in *; lra.
Qed.
End OnePlane.

(** Every plane armed, r at least every plane's gap: what is not called outside meets the shaft when grown by r. *)
Theorem kept_box_grown_meets A B T r : valid A -> valid B -> valid T -> float_box A -> float_box B -> 0 <= r ->
  (forall f g, fst f <> fst g -> extreme A B f -> extreme B A g ->
     outside_threshold (form_certified_plane A B f g) <> Infinite true /\
     code_box_gap (code_n0 A B f g) (code_n1 A B f g) (code_threshold A B f g) <= r) ->
  fst (certified_box_test A B T) <> outside -> exists z, hull A B z /\ in_box (grown T r) z.
Proof.
  intros wA wB wT FA FB R0 G H.
  assert (wG : valid (grown T r)) by (intro i; specialize (wT i); unfold grown; simpl; lra).
  unfold certified_box_test in H; cbv zeta in H.
  destruct (meets_extent A B T) eqn:M; simpl negb in H; cbv iota in H; [|simpl in H; congruence].
  pose proof (proj1 (meets_extent_is A B T) M) as M'.
  destruct existsb eqn:O in H; [simpl in H; congruence|clear H].
  destruct (outside_or_meets A B (grown T r) wA wB wG) as [[[i H]|[q [I H]]]|H]; [exfalso|exfalso|exact H].
  - specialize (M' i); unfold grown in H; simpl in H; lra.
  - destruct (proj1 (planes_are_the_papers A B q)) as [f [g [N [Ef [Eg [Q1 Q2]]]]]].
    { exists q; repeat split; auto. }
    destruct (G f g N Ef Eg) as [D Gr].
    assert (H' : beyond (edge_plane A B f g) (grown T r)).
    { intros z Hz; specialize (H z Hz); unfold dot in *; rewrite !Q2, Q1; exact H. }
    assert (K : greater (value (form_certified_plane A B f g) (near_coord T f) (near_coord T g))
                        (outside_threshold (form_certified_plane A B f g)) = false).
    { destruct greater eqn:K; [|reflexivity]; rewrite <- O; symmetry; apply existsb_exists.
      exists (f, g); split; [apply plane_pairs_are; auto|exact K]. }
    destruct (armed_or_disarmed A B f g wA wB FA FB) as [[_ D']|[D' S]]; [congruence|].
    apply (kept_box_grown_is_not_beyond A B f g wA wB FA FB N Ef Eg T r wT R0 Gr M'); [|exact H'].
    rewrite D' in K; unfold value in K; simpl in K.
    destruct (Rle_lt_dec (true_value A B f g (near_coord T f) (near_coord T g)) 0) as [P|P].
    + exfalso; apply beyond_iff_near_corner in H'; auto; rewrite offset_edge_plane in H'.
      pose proof (grown_near A B f g N Ef Eg T r) as E.
      pose proof (growth_not_negative A B f g) as GN.
      assert (0 <= r * (Rabs (true_n0 A B f g) + Rabs (true_n1 A B f g))) by (apply Rmult_le_pos; assumption).
      assert (X : true_value A B f g (near_coord (grown T r) f) (near_coord (grown T r) g) > 0); [|lra].
      clear - H'; unfold true_value, exact_value, true_n0, true_n1.
      destruct f as [i []], g as [j []]; cbv [sgn coord near_coord near_reach fst snd] in *; lra.
    + destruct (beyond_near_corner_within A B f g wA wB Ef Eg T M' P) as [Hx Hy].
      fold (ieee_value (code_n0 A B f g) (code_n1 A B f g) (plane_d (code_n0 A B f g) (code_n1 A B f g) (coord A f) (coord A g))
            (near_coord T f) (near_coord T g)) in K.
      rewrite (value_within_extent A B f g FA FB S) in K by assumption; simpl in K.
      destruct Rlt_dec; [discriminate|lra].
Qed.
End Gap.
