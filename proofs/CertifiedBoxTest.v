(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * The certified box test as a whole

    form_certified_box_shaft and classify(Shaft, Box), from the coordinates of three boxes to the answer, in arithmetic
    that rounds and overflows; a set-up that overflows anywhere disarms its plane. [certified_box_test_is_right]:
    outside, inside and every answer marked `certain` are right; what is left is "overlap, not certain". *)
Require Import Reals Lra Psatz ZArith List Bool Lia.
Require Import Flocq.Core.Core.
Require Import Gnomon.Boxes Gnomon.PlaneSet Gnomon.BoxTest Gnomon.SlabBox.
Require Import Gnomon.RoundingModel Gnomon.PlaneError Gnomon.BoxThreshold Gnomon.BoxTestCertified Gnomon.Overflow.
Import ListNotations.
Open Scope R_scope.

Section Whole.
Context {F : Format}.

(** ** Operations on numbers, infinities and NaN; Overflow.v has sums. *)
Definition times (v w : ieee) : ieee :=
  match v, w with
  | Number x, Number y => ieee_mul x y
  | Infinite p, Number y | Number y, Infinite p =>
      if Rlt_dec 0 y then Infinite p else if Rlt_dec y 0 then Infinite (negb p) else NotANumber
  | Infinite p, Infinite q => Infinite (eqb p q)
  | _, _ => NotANumber
  end.
Definition negated (v : ieee) : ieee :=
  match v with Number x => Number (- x) | Infinite p => Infinite (negb p) | NotANumber => NotANumber end.
Definition absolute (v : ieee) : ieee :=
  match v with Number x => Number (Rabs x) | Infinite _ => Infinite true | NotANumber => NotANumber end.
(** Times 1 or -1, which is exact. *)
Definition turned (f : face) (v : ieee) : ieee :=
  match snd f with MAX => v | MIN => negated v end.
Definition greater (v w : ieee) : bool :=
  match v, w with
  | Number x, Number y => if Rlt_dec y x then true else false
  | Infinite true, Number _ | Infinite true, Infinite false | Number _, Infinite false => true
  | _, _ => false
  end.
Definition at_most (v w : ieee) : bool :=
  match v, w with
  | Number x, Number y => if Rle_dec x y then true else false
  | Infinite false, Number _ | Number _, Infinite true | Infinite _, Infinite true | Infinite false, Infinite false => true
  | _, _ => false
  end.

(** ** Set-up *)

(** kLargestSafe: the largest float, (1 - u) 2^emax, over 256. *)
Definition code_largest_safe : R := largest_safe * (1 - u).

Record armed_plane := Plane { n0 : ieee; n1 : ieee; d : ieee; outside_threshold : ieee; inside_threshold : ieee }.

Definition form_n0 (A B : box) (f g : face) : ieee := turned f (absolute (ieee_add (Number (coord B g)) (Number (- coord A g)))).
Definition form_n1 (A B : box) (f g : face) : ieee := turned g (absolute (ieee_add (Number (coord A f)) (Number (- coord B f)))).
Definition form_sum (A B : box) (f g : face) : ieee :=
  ieee_add (times (absolute (form_n0 A B f g)) (ieee_add (Number (extent_magnitude A B (fst f))) (Number (Rabs (coord A f)))))
           (times (absolute (form_n1 A B f g)) (ieee_add (Number (extent_magnitude A B (fst g))) (Number (Rabs (coord A g))))).
Definition form_certified_plane (A B : box) (f g : face) : armed_plane :=
  let m0 := form_n0 A B f g in let m1 := form_n1 A B f g in
  let d := negated (ieee_add (times m0 (Number (coord A f))) (times m1 (Number (coord A g)))) in
  if at_most (form_sum A B f g) (Number code_largest_safe) then
    let threshold := ieee_add (times (Number (box_plane * u)) (form_sum A B f g)) (Number (box_underflow * (2 * eta))) in
    Plane m0 m1 d threshold (negated threshold)
  else Plane m0 m1 d (Infinite true) NotANumber.

(** The two loops over the lists: A extreme on f, B on g, on another axis. *)
Definition is_pair (A B : box) (fg : face * face) : bool :=
  negb (axis_eqb (fst (fst fg)) (fst (snd fg))) &&
  match extreme_box A B (fst fg), extreme_box A B (snd fg) with box_A, box_B => true | _, _ => false end.
Definition plane_pairs (A B : box) : list (face * face) := filter (is_pair A B) (list_prod faces faces).

(** ** The test *)
Definition value (p : armed_plane) (x y : R) : ieee :=
  ieee_add (ieee_add (times (n0 p) (Number x)) (times (n1 p) (Number y))) (d p).

Definition all_axes (test : axis -> bool) : bool := test X && test Y && test Z.
Definition le_bool (x y : R) : bool := if Rle_dec x y then true else false.
Definition meets_extent (A B T : box) : bool :=
  all_axes (fun i => le_bool (lo T i) (Rmax (hi A i) (hi B i)) && le_bool (Rmin (lo A i) (lo B i)) (hi T i)).
Definition extent_contains (A B T : box) : bool :=
  all_axes (fun i => le_bool (Rmin (lo A i) (lo B i)) (lo T i) && le_bool (hi T i) (Rmax (hi A i) (hi B i))).

(** The answer, and whether it is certain. *)
Definition certified_box_test (A B T : box) : category * bool :=
  let plane fg := form_certified_plane A B (fst fg) (snd fg) in
  let near fg := value (plane fg) (near_coord T (fst fg)) (near_coord T (snd fg)) in
  let far fg := value (plane fg) (coord T (fst fg)) (coord T (snd fg)) in
  let all := plane_pairs A B in
  if negb (meets_extent A B T) then (outside, true)
  else if existsb (fun fg => greater (near fg) (outside_threshold (plane fg))) all then (outside, true)
  else
    let certain := forallb (fun fg => at_most (near fg) (inside_threshold (plane fg))) all in
    if negb (extent_contains A B T) then (overlap, certain)
    else if forallb (fun fg => at_most (far fg) (inside_threshold (plane fg))) all then (inside, true)
    else (overlap, certain && existsb (fun fg => greater (far fg) (outside_threshold (plane fg))) all).

(** ** An armed plane is the plane that the theorems are about *)
Lemma sum_is_number v w s : ieee_add v w = Number s -> exists x y, v = Number x /\ w = Number y /\ s = fl (x + y).
Proof.
  destruct v as [x|p|], w as [y|q|]; simpl; try discriminate; try (destruct (eqb _ _); discriminate).
  unfold delivered; destruct Rlt_dec; [|discriminate]; intro E; inversion E; eauto.
Qed.
Lemma product_is_number v w s : times v w = Number s -> exists x y, v = Number x /\ w = Number y /\ s = fl (x * y).
Proof.
  destruct v as [x|p|], w as [y|q|]; simpl; try discriminate; try (repeat destruct Rlt_dec; discriminate).
  unfold ieee_mul, delivered; destruct Rlt_dec; [|discriminate]; intro E; inversion E; eauto.
Qed.
Lemma absolute_is_number v x : absolute v = Number x -> exists y, v = Number y /\ x = Rabs y.
Proof. destruct v; simpl; intro E; inversion E; eauto. Qed.
Lemma turned_is_number f v x : turned f v = Number x -> v = Number (sgn f * x).
Proof.
  unfold turned, sgn; destruct (snd f), v; simpl; intro E; inversion E; f_equal; ring.
Qed.

Definition is_armed (p : armed_plane) (m0 m1 e threshold : R) : Prop :=
  p = Plane (Number m0) (Number m1) (Number e) (Number threshold) (Number (- threshold)).

Section OnePlane.
Variables (A B : box) (f g : face).
Hypotheses (wA : valid A) (wB : valid B) (FA : float_box A) (FB : float_box B)
           (N : fst f <> fst g) (Ef : extreme A B f) (Eg : extreme B A g).
Let m0 := code_n0 A B f g. Let m1 := code_n1 A B f g.
Let a0 := coord A f. Let a1 := coord A g.
Let x := extent_magnitude A B (fst f). Let y := extent_magnitude A B (fst g).
Let e := plane_d m0 m1 a0 a1.

Lemma coord_in_extent (b : box) h : b = A \/ b = B ->
  Rmin (lo A (fst h)) (lo B (fst h)) <= coord b h <= Rmax (hi A (fst h)) (hi B (fst h)).
Proof.
  intro E; pose proof (wA (fst h)); pose proof (wB (fst h)).
  pose proof (Rmin_l (lo A (fst h)) (lo B (fst h))); pose proof (Rmin_r (lo A (fst h)) (lo B (fst h))).
  pose proof (Rmax_l (hi A (fst h)) (hi B (fst h))); pose proof (Rmax_r (hi A (fst h)) (hi B (fst h))).
  destruct E as [-> | ->], h as [k []]; cbv [coord fst snd] in *; lra.
Qed.
Lemma magnitude_not_negative i : 0 <= extent_magnitude A B i.
Proof. eapply Rle_trans; [apply Rabs_pos|]; apply Rmax_l. Qed.

Lemma largest_safe_bounds : code_largest_safe <= largest_safe /\ box_underflow * (2 * eta) <= largest_safe.
Proof.
  pose proof safe_positive; pose proof u_positive; split; [unfold code_largest_safe; nra|].
  replace (box_underflow * (2 * eta)) with (bpow radix2 (emin + 9)).
  - apply bpow_le; generalize range_is_ieee prec_at_least_24 range_is_large; lia.
  - unfold box_underflow, eta; replace (emin + 9)%Z with (10 + (emin - 1))%Z by lia.
    rewrite bpow_plus; change (bpow radix2 10) with 1024; lra.
Qed.

(** Set-up overflow disarms: a sum that compares as small enough proves every number behind it finite. *)
Theorem armed_or_disarmed :
  (inside_threshold (form_certified_plane A B f g) = NotANumber /\
   outside_threshold (form_certified_plane A B f g) = Infinite true) \/
  (is_armed (form_certified_plane A B f g) m0 m1 e (code_threshold A B f g) /\
   box_sum m0 m1 a0 a1 x y <= largest_safe).
Proof.
  unfold form_certified_plane.
  destruct (at_most (form_sum A B f g) (Number code_largest_safe)) eqn:S; [right|left; split; reflexivity].
  assert (NN : forall z, fl (Rabs z) >= 0) by (intro; apply Rle_ge, fl_nonneg, Rabs_pos).
  (* all the way back from the sum *)
  destruct (form_sum A B f g) as [s|p|] eqn:Es; unfold at_most in S; try discriminate.
  2: { (* minus infinity: not a sum of absolute values *)
    exfalso; destruct p; try discriminate; revert Es; unfold form_sum.
    assert (P : forall v w, (forall z, v = Number z -> 0 <= z) -> (forall z, w = Number z -> 0 <= z) ->
              (v <> Infinite false) -> (w <> Infinite false) -> ieee_add v w <> Infinite false).
    { intros [z|p|] [z'|q|] V W Pv Pw; simpl; try discriminate; try (destruct p); try (destruct q); simpl;
      try congruence; unfold delivered; destruct Rlt_dec; try discriminate; destruct Rlt_dec; try discriminate.
      exfalso; specialize (V z eq_refl); specialize (W z' eq_refl).
      assert (z + z' = 0) by lra; apply n; replace (z + z') with 0 by lra; rewrite fl_0, Rabs_R0; apply bpow_gt_0. }
    assert (P' : forall v w, (forall z, v = Number z -> 0 <= z) -> (forall z, w = Number z -> 0 <= z) ->
              (v <> Infinite false) -> (w <> Infinite false) -> times v w <> Infinite false /\
              forall z, times v w = Number z -> 0 <= z).
    { intros v w V W Pv Pw; split.
      - destruct v as [z|p|], w as [z'|q|]; simpl; try discriminate.
        + specialize (V z eq_refl); specialize (W z' eq_refl); unfold ieee_mul, delivered.
          assert (0 <= z * z') by (apply Rmult_le_pos; assumption).
          destruct Rlt_dec; try discriminate; destruct Rlt_dec; try discriminate.
          exfalso; apply n; replace (z * z') with 0 by lra; rewrite fl_0, Rabs_R0; apply bpow_gt_0.
        + specialize (V z eq_refl); destruct q; [|congruence]; repeat destruct Rlt_dec; try discriminate; lra.
        + specialize (W z' eq_refl); destruct p; [|congruence]; repeat destruct Rlt_dec; try discriminate; lra.
        + destruct p, q; simpl; congruence.
      - intros z E; apply product_is_number in E; destruct E as [a [b [-> [-> ->]]]].
        apply fl_nonneg, Rmult_le_pos; auto. }
    assert (PA : forall v, absolute v <> Infinite false /\ forall z, absolute v = Number z -> 0 <= z).
    { intros [z|p|]; simpl; split; try discriminate; intros z' E; inversion E; apply Rabs_pos. }
    assert (PS : forall v a, 0 <= v -> ieee_add (Number v) (Number (Rabs a)) <> Infinite false /\
              forall z, ieee_add (Number v) (Number (Rabs a)) = Number z -> 0 <= z).
    { intros v a V; split.
      - apply P; try discriminate; intros z E; inversion E; subst; auto using Rabs_pos.
      - intros z E; apply sum_is_number in E; destruct E as [p [q [Ep [Eq ->]]]]; inversion Ep; inversion Eq; subst.
        apply fl_nonneg; pose proof (Rabs_pos a); lra. }
    assert (PP : forall v w a, 0 <= w -> times (absolute v) (ieee_add (Number w) (Number (Rabs a))) <> Infinite false /\
              forall z, times (absolute v) (ieee_add (Number w) (Number (Rabs a))) = Number z -> 0 <= z).
    { intros v w a W; apply P'; try apply PA; apply PS; exact W. }
    apply P; apply PP; apply magnitude_not_negative. }
  destruct Rle_dec as [Ls|]; [|discriminate]; clear S NN; unfold form_sum in Es.
  destruct largest_safe_bounds as [B1 B2].
  destruct (sum_is_number _ _ _ Es) as [w0 [w1 [E0 [E1 ->]]]].
  destruct (product_is_number _ _ _ E0) as [p0 [q0 [P0 [Q0 ->]]]], (product_is_number _ _ _ E1) as [p1 [q1 [P1 [Q1 ->]]]].
  destruct (sum_is_number _ _ _ Q0) as [? [? [I [J ->]]]]; inversion I; inversion J; subst; clear I J.
  destruct (sum_is_number _ _ _ Q1) as [? [? [I [J ->]]]]; inversion I; inversion J; subst; clear I J.
  apply absolute_is_number in P0; destruct P0 as [z0 [P0 ->]].
  apply absolute_is_number in P1; destruct P1 as [z1 [P1 ->]].
  assert (M0 : z0 = m0 /\ form_n0 A B f g = Number m0).
  { pose proof P0 as K; unfold form_n0 in K; apply turned_is_number, absolute_is_number in K.
    destruct K as [v [K L]]; apply sum_is_number in K; destruct K as [? [? [I [J ->]]]]; inversion I; inversion J; subst.
    assert (z0 = m0); [|subst; auto].
    unfold m0, code_n0; replace (coord B g - coord A g) with (coord B g + - coord A g) by ring; rewrite <- L.
    rewrite <- Rmult_assoc, sgn_squared; ring. }
  assert (M1 : z1 = m1 /\ form_n1 A B f g = Number m1).
  { pose proof P1 as K; unfold form_n1 in K; apply turned_is_number, absolute_is_number in K.
    destruct K as [v [K L]]; apply sum_is_number in K; destruct K as [? [? [I [J ->]]]]; inversion I; inversion J; subst.
    assert (z1 = m1); [|subst; auto].
    unfold m1, code_n1; replace (coord A f - coord B f) with (coord A f + - coord B f) by ring; rewrite <- L.
    rewrite <- Rmult_assoc, sgn_squared; ring. }
  destruct M0 as [-> M0], M1 as [-> M1].
  fold x y a0 a1 in Ls; fold (box_sum m0 m1 a0 a1 x y) in Ls.
  change (fl (fl (Rabs m0 * fl (extent_magnitude A B (fst f) + Rabs (coord A f))) +
              fl (Rabs m1 * fl (extent_magnitude A B (fst g) + Rabs (coord A g))))) with (box_sum m0 m1 a0 a1 x y) in *.
  assert (S1 : box_sum m0 m1 a0 a1 x y <= largest_safe) by lra; split; [|exact S1].
  destruct (armed_is_safe m0 m1 a0 a1 x y) as [Hd [_ [_ [H0 H1]]]];
    auto; try apply magnitude_not_negative; try (apply extent_magnitude_float; assumption); try apply FA.
  pose proof safe_positive as S0.
  assert (A0 : Rabs a0 <= x) by (apply extent_magnitude_covers, coord_in_extent; auto).
  assert (A1 : Rabs a1 <= y) by (apply extent_magnitude_covers, coord_in_extent; auto).
  specialize (H0 a0 A0); specialize (H1 a1 A1).
  unfold is_armed; rewrite M0, M1; fold a0 a1; simpl; unfold ieee_mul.
  rewrite (delivered_as_it_is (m0 * a0)), (delivered_as_it_is (m1 * a1)) by lra; simpl.
  rewrite (delivered_as_it_is (fl (m0 * a0) + fl (m1 * a1)))
    by (unfold plane_d in Hd; rewrite Rabs_Ropp in Hd; lra); simpl.
  assert (B0 : 0 <= box_sum m0 m1 a0 a1 x y).
  { unfold box_sum; apply fl_nonneg, Rplus_le_le_0_compat; apply fl_nonneg, Rmult_le_pos; try apply Rabs_pos;
    apply fl_nonneg; pose proof (Rabs_pos a0); pose proof (Rabs_pos a1);
    pose proof (magnitude_not_negative (fst f)); pose proof (magnitude_not_negative (fst g)); unfold x, y; lra. }
  pose proof u_positive as U0; pose proof u_small as U; pose proof eta_positive as T0.
  assert (T1 : 0 <= fl (box_plane * u * box_sum m0 m1 a0 a1 x y) <= largest_safe).
  { assert (0 <= box_plane * u <= 1) by (unfold box_plane; lra).
    split; [apply fl_nonneg, Rmult_le_pos; lra|].
    unfold largest_safe; apply fl_at_most_power; [lia|]; fold largest_safe.
    apply Rle_trans with (1 * box_sum m0 m1 a0 a1 x y); [apply Rmult_le_compat_r|]; lra. }
  rewrite (delivered_as_it_is (box_plane * u * box_sum m0 m1 a0 a1 x y)) by (rewrite Rabs_pos_eq; lra); simpl.
  assert (T2 : 0 <= box_underflow * (2 * eta)) by (unfold box_underflow; lra).
  assert (T3 : 0 <= fl (fl (box_plane * u * box_sum m0 m1 a0 a1 x y) + box_underflow * (2 * eta)) <= 2 * largest_safe).
  { split; [apply fl_nonneg; lra|apply fl_at_most_2; lra]. }
  rewrite delivered_as_it_is by (rewrite Rabs_pos_eq; lra); simpl; reflexivity.
Qed.

Section Armed.
Hypothesis safe : box_sum m0 m1 a0 a1 x y <= largest_safe.

Lemma armed_facts :
  Rabs e <= largest_safe /\
  (forall v, m0 * v <= Rabs m0 * x -> fl (m0 * v) <= largest_safe) /\
  (forall v, m1 * v <= Rabs m1 * y -> fl (m1 * v) <= largest_safe) /\
  (forall v, Rabs v <= x -> Rabs (fl (m0 * v)) <= largest_safe) /\
  (forall v, Rabs v <= y -> Rabs (fl (m1 * v)) <= largest_safe).
Proof.
  apply armed_is_safe; auto; try apply magnitude_not_negative; try (apply extent_magnitude_float; auto); apply FA.
Qed.

(** Within the extent box the value is a number, the one that the theorems are about. *)
Lemma value_within_extent v w :
  Rmin (lo A (fst f)) (lo B (fst f)) <= v <= Rmax (hi A (fst f)) (hi B (fst f)) ->
  Rmin (lo A (fst g)) (lo B (fst g)) <= w <= Rmax (hi A (fst g)) (hi B (fst g)) ->
  ieee_value m0 m1 e v w = Number (code_value A B f g v w).
Proof.
  intros Hv Hw; destruct armed_facts as [D [_ [_ [H0 H1]]]].
  apply extent_magnitude_covers in Hv; apply extent_magnitude_covers in Hw.
  apply no_overflow_within_extent; auto.
Qed.

(** A near corner of a box that meets the extent box. *)
Lemma near_value_from_above T threshold :
  (forall i, lo T i <= Rmax (hi A i) (hi B i) /\ Rmin (lo A i) (lo B i) <= hi T i) ->
  above (ieee_value m0 m1 e (near_coord T f) (near_coord T g)) threshold ->
  code_value A B f g (near_coord T f) (near_coord T g) > threshold.
Proof.
  intros M H; destruct armed_facts as [D [H0 [H1 _]]].
  assert (K : forall h z, sgn h * near_coord T h * Rabs z <= Rabs (sgn h * Rabs z) * extent_magnitude A B (fst h)).
  { intros h z; rewrite Rabs_mult, Rabs_Rabsolu.
    assert (R1 : Rabs (sgn h) = 1) by (destruct h as [? []]; unfold sgn; simpl; unfold Rabs; destruct Rcase_abs; lra).
    rewrite R1, Rmult_1_l, (Rmult_comm (Rabs z)); apply Rmult_le_compat_r; [apply Rabs_pos|].
    destruct (M (fst h)) as [M0 M1]; unfold extent_magnitude.
    pose proof (Rmax_l (Rabs (Rmin (lo A (fst h)) (lo B (fst h)))) (Rabs (Rmax (hi A (fst h)) (hi B (fst h))))).
    pose proof (Rmax_r (Rabs (Rmin (lo A (fst h)) (lo B (fst h)))) (Rabs (Rmax (hi A (fst h)) (hi B (fst h))))).
    pose proof (Rle_abs (Rmax (hi A (fst h)) (hi B (fst h)))).
    pose proof (Rle_abs (- Rmin (lo A (fst h)) (lo B (fst h)))) as Q; rewrite Rabs_Ropp in Q.
    destruct h as [k []]; cbv [sgn near_coord fst snd] in *; lra. }
  apply overflow_never_culls with (4 := H).
  - apply H0; unfold m0, code_n0, x; pose proof (K f (fl (coord B g - coord A g))); lra.
  - apply H1; unfold m1, code_n1, y; pose proof (K g (fl (coord A f - coord B f))); lra.
  - pose proof (Rle_abs e); lra.
Qed.
End Armed.

(** What the four comparisons of the test mean, armed or not. *)
Let p := form_certified_plane A B f g.

Lemma near_greater T : valid T ->
  (forall i, lo T i <= Rmax (hi A i) (hi B i) /\ Rmin (lo A i) (lo B i) <= hi T i) ->
  greater (value p (near_coord T f) (near_coord T g)) (outside_threshold p) = true ->
  ~ exists z, hull A B z /\ in_box T z.
Proof.
  intros wT M H; unfold p in *; destruct armed_or_disarmed as [[_ D]|[D S]].
  - rewrite D in H; destruct value as [?|[]|]; discriminate.
  - rewrite D in H; unfold value in H; simpl in H.
    apply (certified_cull_is_right A B f g); auto.
    apply near_value_from_above; [exact S|exact M|].
    fold (ieee_value m0 m1 e (near_coord T f) (near_coord T g)) in H.
    destruct (ieee_value m0 m1 e (near_coord T f) (near_coord T g)) as [v|[]|]; simpl in *; try discriminate; auto.
    destruct Rlt_dec; [lra|discriminate].
Qed.

Lemma near_at_most T : valid T ->
  (forall i, lo T i <= Rmax (hi A i) (hi B i) /\ Rmin (lo A i) (lo B i) <= hi T i) ->
  at_most (value p (near_coord T f) (near_coord T g)) (inside_threshold p) = true ->
  ~ beyond (edge_plane A B f g) T.
Proof.
  intros wT M H O; unfold p in *; destruct armed_or_disarmed as [[D _]|[D S]].
  - rewrite D in H; destruct value as [?|[]|]; discriminate.
  - rewrite D in H; unfold value in H; simpl in H.
    fold (ieee_value m0 m1 e (near_coord T f) (near_coord T g)) in H.
    assert (V : true_value A B f g (near_coord T f) (near_coord T g) > 0).
    { apply beyond_iff_near_corner in O; auto; rewrite offset_edge_plane in O.
      unfold true_value, exact_value, true_n0, true_n1; clear - O.
      destruct f as [i []], g as [j []]; cbv [sgn coord near_coord near_reach fst snd] in *; lra. }
    destruct (beyond_near_corner_within A B f g wA wB Ef Eg T M V) as [Hx Hy].
    rewrite value_within_extent in H by assumption; simpl in H; destruct Rle_dec as [L|]; [|discriminate].
    pose proof (certified_not_beyond A B f g wA wB FA FB N Ef Eg T M L); lra.
Qed.

Section Contained.
Variable T : box.
Hypotheses (wT : valid T) (I : forall i, Rmin (lo A i) (lo B i) <= lo T i /\ hi T i <= Rmax (hi A i) (hi B i)).

Lemma far_in_extent h : Rmin (lo A (fst h)) (lo B (fst h)) <= coord T h <= Rmax (hi A (fst h)) (hi B (fst h)).
Proof. specialize (I (fst h)); specialize (wT (fst h)); destruct h as [k []]; cbv [coord fst snd] in *; lra. Qed.

Lemma far_at_most :
  at_most (value p (coord T f) (coord T g)) (inside_threshold p) = true ->
  code_value A B f g (coord T f) (coord T g) <= - code_threshold A B f g.
Proof.
  intro H; unfold p in *; destruct armed_or_disarmed as [[D _]|[D S]].
  - rewrite D in H; destruct value as [?|[]|]; discriminate.
  - rewrite D in H; unfold value in H; simpl in H.
    fold (ieee_value m0 m1 e (coord T f) (coord T g)) in H.
    rewrite value_within_extent in H by (try exact S; apply far_in_extent).
    simpl in H; destruct Rle_dec; [assumption|discriminate].
Qed.
Lemma far_greater :
  greater (value p (coord T f) (coord T g)) (outside_threshold p) = true ->
  ~ forall z, in_box T z -> hull A B z.
Proof.
  intros H J; unfold p in *; destruct armed_or_disarmed as [[_ D]|[D S]].
  - rewrite D in H; destruct value as [?|[]|]; discriminate.
  - rewrite D in H; unfold value in H; simpl in H.
    fold (ieee_value m0 m1 e (coord T f) (coord T g)) in H.
    rewrite value_within_extent in H by (try exact S; apply far_in_extent).
    simpl in H; destruct Rlt_dec as [L|]; [|discriminate].
    pose proof (value_within_threshold A B f g FA FB N Ef Eg _ _ (far_in_extent f) (far_in_extent g)) as K.
    apply Rabs_le_inv in K.
    apply inside_test_is_exact in J; auto; destruct J as [_ J]; specialize (J f g N Ef Eg).
    rewrite offset_edge_plane in J; unfold true_value, exact_value, true_n0, true_n1, far_reach in *; clear - J K L.
    destruct f as [i []], g as [j []]; cbv [sgn coord fst snd] in *; lra.
Qed.
End Contained.
End OnePlane.

Lemma plane_pairs_are A B f g : In (f, g) (plane_pairs A B) <-> fst f <> fst g /\ extreme A B f /\ extreme B A g.
Proof.
  unfold plane_pairs; rewrite filter_In; unfold is_pair; cbn [fst snd].
  rewrite <- extreme_box_A, <- extreme_box_B.
  assert (I : In (f, g) (list_prod faces faces)) by (apply in_prod; apply every_face_listed).
  assert (E : negb (axis_eqb (fst f) (fst g)) = true <-> fst f <> fst g)
    by (destruct f as [[] ?], g as [[] ?]; simpl; split; intro; congruence).
  rewrite andb_true_iff, E; destruct (extreme_box A B f), (extreme_box A B g); split; intros H; repeat split;
  try tauto; destruct H as [? H]; try destruct H; try congruence.
Qed.

Lemma le_bool_is x y : le_bool x y = true <-> x <= y.
Proof. unfold le_bool; destruct Rle_dec; split; intro; try discriminate; auto; lra. Qed.
Lemma all_axes_is t : all_axes t = true <-> forall i, t i = true.
Proof.
  unfold all_axes; rewrite !andb_true_iff; split; [intros [[? ?] ?] []; assumption|intro H; repeat split; apply H].
Qed.
Lemma meets_extent_is A B T : meets_extent A B T = true <->
  forall i, lo T i <= Rmax (hi A i) (hi B i) /\ Rmin (lo A i) (lo B i) <= hi T i.
Proof.
  unfold meets_extent; rewrite all_axes_is; split; intros H i; specialize (H i);
  rewrite andb_true_iff, !le_bool_is in *; exact H.
Qed.
Lemma extent_contains_is A B T : extent_contains A B T = true <->
  forall i, Rmin (lo A i) (lo B i) <= lo T i /\ hi T i <= Rmax (hi A i) (hi B i).
Proof.
  unfold extent_contains; rewrite all_axes_is; split; intros H i; specialize (H i);
  rewrite andb_true_iff, !le_bool_is in *; exact H.
Qed.

Theorem certified_box_test_is_right A B T :
  valid A -> valid B -> valid T -> float_box A -> float_box B ->
  match certified_box_test A B T with
  | (outside, _) => ~ exists z, hull A B z /\ in_box T z
  | (inside, _) => forall z, in_box T z -> hull A B z
  | (overlap, true) => (exists z, hull A B z /\ in_box T z) /\ ~ forall z, in_box T z -> hull A B z
  | (overlap, false) => True
  end.
Proof.
  intros wA wB wT FA FB; unfold certified_box_test; cbv zeta.
  destruct (meets_extent A B T) eqn:M; simpl negb; cbv iota.
  2: { apply box_test_is_exact; auto; left; unfold beyond_extent.
    assert (H : ~ forall i, lo T i <= Rmax (hi A i) (hi B i) /\ Rmin (lo A i) (lo B i) <= hi T i)
      by (intro H; apply meets_extent_is in H; congruence).
    destruct (Rle_dec (lo T X) (Rmax (hi A X) (hi B X))), (Rle_dec (Rmin (lo A X) (lo B X)) (hi T X));
    try (exists X; lra).
    destruct (Rle_dec (lo T Y) (Rmax (hi A Y) (hi B Y))), (Rle_dec (Rmin (lo A Y) (lo B Y)) (hi T Y));
    try (exists Y; lra).
    destruct (Rle_dec (lo T Z) (Rmax (hi A Z) (hi B Z))), (Rle_dec (Rmin (lo A Z) (lo B Z)) (hi T Z));
    try (exists Z; lra).
    exfalso; apply H; intros []; auto. }
  pose proof (proj1 (meets_extent_is A B T) M) as M'.
  destruct existsb eqn:O; [|clear O].
  { apply existsb_exists in O; destruct O as [[f g] [I O]]; simpl in O.
    apply plane_pairs_are in I; destruct I as [N [Ef Eg]]; exact (near_greater A B f g wA wB FA FB N Ef Eg T wT M' O). }
  assert (C : forallb (fun fg => at_most (value (form_certified_plane A B (fst fg) (snd fg)) (near_coord T (fst fg))
              (near_coord T (snd fg))) (inside_threshold (form_certified_plane A B (fst fg) (snd fg)))) (plane_pairs A B)
              = true -> exists z, hull A B z /\ in_box T z).
  { intro C; rewrite forallb_forall in C.
    destruct (outside_or_meets A B T wA wB wT) as [[[i H]|[q [I H]]]|H]; [exfalso|exfalso|exact H].
    - specialize (M' i); lra.
    - destruct (proj1 (planes_are_the_papers A B q)) as [f [g [N [Ef [Eg [Q1 Q2]]]]]].
      { exists q; repeat split; auto. }
      specialize (C (f, g)); rewrite plane_pairs_are in C; specialize (C (conj N (conj Ef Eg))); simpl in C.
      apply (near_at_most A B f g wA wB FA FB N Ef Eg T wT M' C).
      intros z Hz; specialize (H z Hz); unfold dot in *; rewrite !Q2, Q1; exact H. }
  set (certain := forallb _ _) in *.
  destruct (extent_contains A B T) eqn:E; simpl negb; cbv iota.
  - pose proof (proj1 (extent_contains_is A B T) E) as E'.
    destruct (forallb (fun fg => at_most (value (form_certified_plane A B (fst fg) (snd fg)) (coord T (fst fg))
      (coord T (snd fg))) (inside_threshold (form_certified_plane A B (fst fg) (snd fg)))) (plane_pairs A B)) eqn:I.
    + rewrite forallb_forall in I; apply certified_inside_is_right; auto.
      intros f g N Ef Eg; specialize (I (f, g)); rewrite plane_pairs_are in I.
      specialize (I (conj N (conj Ef Eg))); simpl in I; apply far_at_most; auto.
    + destruct certain; simpl; [|exact Logic.I].
      destruct (existsb _ _) eqn:Q; [|exact Logic.I]; split; [apply C; reflexivity|].
      apply existsb_exists in Q; destruct Q as [[f g] [J Q]]; simpl in Q.
      apply plane_pairs_are in J; destruct J as [N [Ef Eg]]; exact (far_greater A B f g wA wB FA FB N Ef Eg T wT E' Q).
  - destruct certain; [|exact Logic.I]; split; [apply C; reflexivity|].
    intro H; assert (extent_contains A B T = true); [|congruence].
    apply extent_contains_is; apply inside_test_is_exact in H; tauto.
Qed.
End Whole.

(** For the two formats that the code is compiled for. *)
Definition float32_box_test_is_right := @certified_box_test_is_right float32.
Definition float64_box_test_is_right := @certified_box_test_is_right float64.
