(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * The certified ball test as a whole

    form_certified_ball_shaft and classify(Shaft, Ball), from the coordinates of two boxes and a ball to the answer, as
    one function with every rounding. [certified_ball_test_is_right]: outside and inside are right. The range is
    unbounded here; BallOverflow.v says what overflow of a plane's value does. *)
Require Import Reals Lra Psatz ZArith List Bool.
Require Import Flocq.Core.Core.
Require Import Gnomon.Boxes Gnomon.PlaneSet Gnomon.BoxTest Gnomon.SlabBox.
Require Import Gnomon.RoundingModel Gnomon.PlaneError Gnomon.BoxTestCertified Gnomon.ShortenedNormal.
Require Import Gnomon.BallThreshold Gnomon.BallTestCertified Gnomon.ShortenedPlane Gnomon.BallSlack Gnomon.Prescale.
Require Import Gnomon.Overflow Gnomon.CertifiedBoxTest.
Open Scope R_scope.

Section Whole.
Context {F : Format}.

(** ** Set-up: set_ball_threshold *)
Record ball_plane := BallPlane { m0 : R; m1 : R; offset_d : R; outside_at : R; inside_at : R; decides : bool }.
Definition form_ball_plane (A B : box) (f g : face) : ball_plane :=
  let x := extent_magnitude A B (fst f) in let y := extent_magnitude A B (fst g) in
  let n0 := code_n0 A B f g in let n1 := code_n1 A B f g in
  let s0 := code_prescale n0 n1 n0 in let s1 := code_prescale n0 n1 n1 in
  let m0 := code_m s0 s1 s0 in let m1 := code_m s0 s1 s1 in
  BallPlane m0 m1 (plane_d m0 m1 (coord A f) (coord A g))
    (code_outside m0 m1 (coord A f) (coord A g) (coord B f) (coord B g) x y)
    (code_inside m0 m1 (coord A f) (coord A g) x y)
    (le_bool (fl (x + y)) code_largest_safe).
Definition ball_value (p : ball_plane) (f g : face) (c : point) : R :=
  plane_value (m0 p) (m1 p) (offset_d p) (c (fst f)) (c (fst g)).

(** ** The test *)
Definition extent_apart (A B : box) (c : point) (i : axis) : R :=
  code_apart (Rmin (lo A i) (lo B i)) (Rmax (hi A i) (hi B i)) (c i).
Definition code_distance (A B : box) (c : point) : R :=
  code_squared_distance (extent_apart A B c X) (extent_apart A B c Y) (extent_apart A B c Z).
Definition code_within_sides (A B : box) (c : point) (r : R) : bool :=
  let reach := fl (r * (1 + side_factor * u)) in
  all_axes (fun i => le_bool reach (fl (c i - Rmin (lo A i) (lo B i))) &&
                     le_bool reach (fl (Rmax (hi A i) (hi B i) - c i))).
Definition certified_ball_test (A B : box) (c : point) (r : R) : category :=
  let plane fg := form_ball_plane A B (fst fg) (snd fg) in
  let at_centre fg := ball_value (plane fg) (fst fg) (snd fg) c in
  if negb (le_bool (code_distance A B c) (code_square_bound r)) then outside
  else if negb (le_bool r code_largest_safe) then overlap
  else if existsb (fun fg => decides (plane fg) && negb (le_bool (at_centre fg) (fl (r + outside_at (plane fg)))))
                  (plane_pairs A B) then outside
  else if code_within_sides A B c r &&
          forallb (fun fg => decides (plane fg) && le_bool (at_centre fg) (fl (- inside_at (plane fg) - r)))
                  (plane_pairs A B) then inside
  else overlap.

(** ** Its answers *)
Lemma le_bool_false x y : negb (le_bool x y) = true -> x > y.
Proof. unfold le_bool; destruct Rle_dec; simpl; [discriminate|lra]. Qed.

Lemma extent_sides_float A B i : float_box A -> float_box B ->
  is_float (Rmin (lo A i) (lo B i)) /\ is_float (Rmax (hi A i) (hi B i)).
Proof.
  intros FA FB; pose proof (FA (i, MIN)); pose proof (FA (i, MAX)); pose proof (FB (i, MIN)); pose proof (FB (i, MAX)).
  unfold coord, fst, snd, Rmin, Rmax in *; repeat destruct Rle_dec; auto.
Qed.

(** Arvo's distance above the bound: the ball misses even the extent box. *)
Lemma distance_culls_right A B c r : valid A -> valid B -> float_box A -> float_box B -> (forall i, is_float (c i)) ->
  code_distance A B c > code_square_bound r -> ~ exists z, hull A B z /\ within_ball c r z.
Proof.
  intros wA wB FA FB Fc H [z [Hz I]].
  set (D := fun i => apart (Rmin (lo A i) (lo B i)) (Rmax (hi A i) (hi B i)) (c i)).
  assert (K : forall i, 0 <= extent_apart A B c i <= D i * (1 + u)).
  { intro i; destruct (extent_sides_float A B i FA FB); apply code_apart_at_most; auto.
    pose proof (wA i); pose proof (Rmin_l (lo A i) (lo B i)); pose proof (Rmax_l (hi A i) (hi B i)); lra. }
  pose proof (squared_distance_slack _ _ _ _ _ _ r (K X) (K Y) (K Z) H) as S.
  pose proof (shaft_within_extent A B z wA wB Hz) as E.
  assert (L : forall i, D i * D i <= (c i - z i) * (c i - z i)).
  { intro i; specialize (E i); unfold D, apart.
    set (l := Rmin (lo A i) (lo B i)) in *; set (h := Rmax (hi A i) (hi B i)) in *.
    pose proof (Rle_0_sqr (c i - z i)) as Q; unfold Rsqr in Q.
    assert (M : Rmax (Rmax (l - c i) (c i - h)) 0 <= Rabs (c i - z i)).
    { pose proof (Rle_abs (c i - z i)); pose proof (Rle_abs (- (c i - z i))) as Q'; rewrite Rabs_Ropp in Q'.
      repeat apply Rmax_lub; try apply Rabs_pos; lra. }
    replace ((c i - z i) * (c i - z i)) with (Rabs (c i - z i) * Rabs (c i - z i))
      by (rewrite <- Rabs_mult; apply Rabs_pos_eq; lra).
    apply Rmult_le_compat; try apply Rmax_r; exact M. }
  pose proof (L X); pose proof (L Y); pose proof (L Z); unfold within_ball in I; lra.
Qed.

Lemma sides_are_right A B c r : float_box A -> float_box B -> (forall i, is_float (c i)) -> is_float r -> 0 <= r ->
  code_within_sides A B c r = true ->
  forall i, c i - Rmin (lo A i) (lo B i) >= r /\ Rmax (hi A i) (hi B i) - c i >= r.
Proof.
  intros FA FB Fc Fr Hr H i; unfold code_within_sides in H; cbv zeta in H; rewrite all_axes_is in H; specialize (H i).
  rewrite andb_true_iff, !le_bool_is in H; destruct (extent_sides_float A B i FA FB).
  split; apply side_slack; auto; apply Rle_ge; tauto.
Qed.
Lemma coordinate_of_ball c r z i : 0 <= r -> within_ball c r z -> Rabs (z i - c i) <= r.
Proof.
  intros Hr I; apply Rsqr_incr_0_var; [|exact Hr]; rewrite <- Rsqr_abs; unfold Rsqr, within_ball in *.
  pose proof (Rle_0_sqr (c X - z X)) as Q0; pose proof (Rle_0_sqr (c Y - z Y)) as Q1.
  pose proof (Rle_0_sqr (c Z - z Z)) as Q2; unfold Rsqr in *; destruct i; lra.
Qed.

Theorem certified_ball_test_is_right A B c r :
  valid A -> valid B -> float_box A -> float_box B -> (forall i, is_float (c i)) -> is_float r -> 0 <= r ->
  match certified_ball_test A B c r with
  | outside => ~ exists z, hull A B z /\ within_ball c r z
  | inside => forall z, within_ball c r z -> hull A B z
  | overlap => True
  end.
Proof.
  intros wA wB FA FB Fc Fr Hr; unfold certified_ball_test; cbv zeta.
  destruct (negb (le_bool (code_distance A B c) (code_square_bound r))) eqn:D.
  { apply le_bool_false in D; apply distance_culls_right; auto. }
  destruct (negb (le_bool r code_largest_safe)); [exact I|].
  destruct existsb eqn:O.
  - apply existsb_exists in O; destruct O as [[f g] [J O]]; simpl in O.
    apply plane_pairs_are in J; destruct J as [N [Ef Eg]].
    apply andb_true_iff in O; destruct O as [_ O]; apply le_bool_false in O.
    exact (certified_ball_cull_is_right A B f g _ _ wA wB FA FB N Ef Eg (shorten_can_always_scale A B f g FA FB Ef Eg)
             c r Hr Fr O).
  - clear O; destruct (_ && _) eqn:In; [|exact I].
    apply andb_true_iff in In; destruct In as [S P]; rewrite forallb_forall in P.
    pose proof (sides_are_right A B c r FA FB Fc Fr Hr S) as K.
    assert (E : in_extent A B c) by (intro i; specialize (K i); lra).
    intros z Hz; apply shaft_is_extent_and_planes; auto; split.
    + intro i; specialize (K i); pose proof (coordinate_of_ball c r z i Hr Hz) as Q; apply Rabs_le_inv in Q; lra.
    + intros f g N Ef Eg; specialize (P (f, g)); rewrite plane_pairs_are in P; specialize (P (conj N (conj Ef Eg))).
      apply andb_true_iff in P; destruct P as [_ P]; apply le_bool_is in P.
      exact (certified_ball_is_behind A B f g _ _ wA wB FA FB N Ef Eg (shorten_can_always_scale A B f g FA FB Ef Eg)
               c r Hr Fr E P z Hz).
Qed.
End Whole.

(** For the two formats that the code is compiled for. *)
Definition float32_ball_test_is_right := @certified_ball_test_is_right float32.
Definition float64_ball_test_is_right := @certified_ball_test_is_right float64.
