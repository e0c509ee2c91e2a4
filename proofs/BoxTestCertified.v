(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * The certified box test never lies

    form_certified_box_shaft gives every plane one threshold; classify(Shaft, Box) culls T when the rounded value of
    T's near corner is above it, and calls T inside when T lies within the extent box and every plane's rounded value
    of T's far corner is at most minus the threshold. [certified_cull_is_right], [certified_inside_is_right]: both
    are never wrong, whatever the size of T. [certified_keep_is_near]: what a plane should have culled and did not
    has an exact value of at most twice the threshold. [certified_not_beyond]: a plane whose value is at most minus
    the threshold really does not cull (so the answer `certain` is true).

    Why one threshold is enough: if T meets the shaft there is a real point p in both. T's near corner comes before
    p in the direction of the normal, and rounding is monotone: the computed value of the near corner is at most the
    value that the same operations would give for p, which is at most 0 + the error bound at p, a point of the
    extent box. *)
Require Import Reals Lra Psatz List ZArith.
Require Import Flocq.Core.Core.
Require Import Gnomon.Boxes Gnomon.PlaneSet Gnomon.BoxTest.
Require Import Gnomon.RoundingModel Gnomon.PlaneError Gnomon.BoxThreshold.
Open Scope R_scope.

Section Certified.
Context {F : Format}.

Definition float_box (b : box) : Prop := forall f, is_float (coord b f).

(** form_plane: differences, made positive, then turned outwards. *)
Definition code_n0 (A B : box) (f g : face) : R := sgn f * Rabs (fl (coord B g - coord A g)).
Definition code_n1 (A B : box) (f g : face) : R := sgn g * Rabs (fl (coord A f - coord B f)).
Definition code_value (A B : box) (f g : face) (x y : R) : R :=
  plane_value (code_n0 A B f g) (code_n1 A B f g)
    (plane_d (code_n0 A B f g) (code_n1 A B f g) (coord A f) (coord A g)) x y.

(** magnitude(): the largest absolute coordinate on the axis within the extent box. *)
Definition extent_magnitude (A B : box) (i : axis) : R :=
  Rmax (Rabs (Rmin (lo A i) (lo B i))) (Rabs (Rmax (hi A i) (hi B i))).
Definition code_threshold (A B : box) (f g : face) : R :=
  box_threshold (code_n0 A B f g) (code_n1 A B f g) (coord A f) (coord A g)
    (extent_magnitude A B (fst f)) (extent_magnitude A B (fst g)).

(** The coordinates that near_value and far_value take: the near corner has the opposite faces. *)
Definition near_coord (T : box) (f : face) : R :=
  match snd f with MIN => hi T (fst f) | MAX => lo T (fst f) end.

(** The exact plane, its normal turned outwards. *)
Definition true_n0 (A B : box) (f g : face) : R := sgn f * (reach B g - reach A g).
Definition true_n1 (A B : box) (f g : face) : R := sgn g * (reach A f - reach B f).
Definition true_value (A B : box) (f g : face) (x y : R) : R :=
  exact_value (true_n0 A B f g) (true_n1 A B f g) (coord A f) (coord A g) x y.

Lemma true_value_is_the_plane A B f g x : fst f <> fst g ->
  true_value A B f g (x (fst f)) (x (fst g)) =
  dot (normal (edge_plane A B f g)) x - offset (edge_plane A B f g).
Proof.
  intro N; rewrite dot_edge_plane, offset_edge_plane by auto.
  unfold true_value, exact_value, true_n0, true_n1.
  destruct f as [i []], g as [j []]; cbv [sgn coord fst snd]; ring.
Qed.

Lemma extent_magnitude_float A B i : float_box A -> float_box B -> is_float (extent_magnitude A B i).
Proof.
  intros FA FB; unfold extent_magnitude.
  pose proof (FA (i, MIN)); pose proof (FA (i, MAX)); pose proof (FB (i, MIN)); pose proof (FB (i, MAX)).
  unfold coord, fst, snd in *.
  assert (K : forall x y, is_float x -> is_float y -> is_float (Rmax x y))
    by (intros; unfold Rmax; destruct Rle_dec; assumption).
  assert (L : forall x y, is_float x -> is_float y -> is_float (Rmin x y))
    by (intros; unfold Rmin; destruct Rle_dec; assumption).
  apply K; apply is_float_abs; auto.
Qed.
Lemma extent_magnitude_covers A B x i :
  Rmin (lo A i) (lo B i) <= x <= Rmax (hi A i) (hi B i) -> Rabs x <= extent_magnitude A B i.
Proof.
  intro H; unfold extent_magnitude.
  pose proof (Rmax_l (Rabs (Rmin (lo A i) (lo B i))) (Rabs (Rmax (hi A i) (hi B i)))).
  pose proof (Rmax_r (Rabs (Rmin (lo A i) (lo B i))) (Rabs (Rmax (hi A i) (hi B i)))).
  pose proof (Rle_abs (Rmax (hi A i) (hi B i))); pose proof (Rle_abs (- Rmin (lo A i) (lo B i))) as K.
  rewrite Rabs_Ropp in K; apply Rabs_le; lra.
Qed.

Section OnePlane.
Variables (A B : box) (f g : face).
Hypotheses (wA : valid A) (wB : valid B) (FA : float_box A) (FB : float_box B)
           (N : fst f <> fst g) (Ef : extreme A B f) (Eg : extreme B A g).

(** The computed normal is the true one with one rounding a component. *)
Lemma code_normal : exists e0 e1, Rabs e0 <= u /\ Rabs e1 <= u /\
  code_n0 A B f g = true_n0 A B f g * (1 + e0) /\ code_n1 A B f g = true_n1 A B f g * (1 + e1).
Proof.
  destruct (fl_minus _ _ (FB g) (FA g)) as [e0 [H0 E0]], (fl_minus _ _ (FA f) (FB f)) as [e1 [H1 E1]].
  exists e0, e1; repeat split; auto.
  - unfold code_n0, true_n0; rewrite E0, Rabs_mult.
    pose proof u_positive; pose proof u_small; apply Rabs_le_inv in H0; rewrite (Rabs_pos_eq (1 + e0)) by lra.
    unfold extreme in Eg; destruct g as [j []]; cbv [sgn coord fst snd] in *;
    [rewrite Rabs_left by lra|rewrite Rabs_pos_eq by lra]; ring.
  - unfold code_n1, true_n1; rewrite E1, Rabs_mult.
    pose proof u_positive; pose proof u_small; apply Rabs_le_inv in H1; rewrite (Rabs_pos_eq (1 + e1)) by lra.
    unfold extreme in Ef; destruct f as [i []]; cbv [sgn coord fst snd] in *;
    [rewrite Rabs_left by lra|rewrite Rabs_pos_eq by lra]; ring.
Qed.

(** The error bound holds within the extent box, and the threshold covers it. *)
Lemma value_within_threshold x y :
  Rmin (lo A (fst f)) (lo B (fst f)) <= x <= Rmax (hi A (fst f)) (hi B (fst f)) ->
  Rmin (lo A (fst g)) (lo B (fst g)) <= y <= Rmax (hi A (fst g)) (hi B (fst g)) ->
  Rabs (code_value A B f g x y - true_value A B f g x y) <= code_threshold A B f g.
Proof.
  intros Hx Hy; destruct code_normal as [e0 [e1 [H0 [H1 [E0 E1]]]]].
  unfold code_value, code_threshold; rewrite E0, E1.
  eapply Rle_trans; [apply plane_value_error; auto|].
  apply box_threshold_is_enough; auto using extent_magnitude_float, extent_magnitude_covers.
Qed.

(** Rounding is monotone: a corner that comes before p in the direction of the normal has no larger value. *)
Lemma value_monotone x y x' y' : sgn f * x <= sgn f * x' -> sgn g * y <= sgn g * y' ->
  code_value A B f g x y <= code_value A B f g x' y'.
Proof.
  intros Hx Hy; unfold code_value, plane_value.
  apply fl_le, Rplus_le_compat_r, fl_le, Rplus_le_compat; apply fl_le.
  - unfold code_n0; pose proof (Rabs_pos (fl (coord B g - coord A g))).
    destruct f as [i []]; unfold sgn, snd in *; nra.
  - unfold code_n1; pose proof (Rabs_pos (fl (coord A f - coord B f))).
    destruct g as [j []]; unfold sgn, snd in *; nra.
Qed.

(** A value above the threshold proves T outside; T may be of any size, and need not even be of floats. *)
Theorem certified_cull_is_right T :
  code_value A B f g (near_coord T f) (near_coord T g) > code_threshold A B f g ->
  ~ exists x, hull A B x /\ in_box T x.
Proof.
  intros H [p [Hp Tp]].
  pose proof (shaft_within_extent A B p wA wB Hp) as E.
  pose proof (value_within_threshold (p (fst f)) (p (fst g)) (E _) (E _)) as K; apply Rabs_le_inv in K.
  pose proof (hull_within_plane A B f g p wA wB N Ef Eg Hp) as I.
  rewrite true_value_is_the_plane in K by auto.
  assert (M : code_value A B f g (near_coord T f) (near_coord T g) <=
              code_value A B f g (p (fst f)) (p (fst g))).
  { pose proof (Tp (fst f)); pose proof (Tp (fst g)).
    apply value_monotone; [destruct f as [i []]|destruct g as [j []]]; cbv [near_coord sgn fst snd] in *; lra. }
  lra.
Qed.

(** The same in outward coordinates: a and b are where A and B reach on face f, c and d on face g. *)
Lemma beyond_near_coordinates a b c d x y : b < a -> c < d -> x <= a -> y <= d ->
  (d - c) * (x - a) + (a - b) * (y - c) > 0 -> b <= x /\ c <= y.
Proof.
  intros Hf Hg Hx Hy V; split; apply Rnot_lt_le; intro K.
  - assert ((a - b) * (y - c) <= (a - b) * (d - c)) by (apply Rmult_le_compat_l; lra).
    assert ((d - c) * (x - a) <= (d - c) * (b - a)) by (apply Rmult_le_compat_l; lra); lra.
  - assert ((a - b) * (y - c) <= (a - b) * 0) by (apply Rmult_le_compat_l; lra).
    assert ((d - c) * (x - a) <= (d - c) * 0) by (apply Rmult_le_compat_l; lra); lra.
Qed.
Lemma near_corner_not_past_extent T h :
  (forall i, lo T i <= Rmax (hi A i) (hi B i) /\ Rmin (lo A i) (lo B i) <= hi T i) ->
  near_reach T h <= Rmax (reach A h) (reach B h).
Proof.
  intro M; destruct h as [i []]; specialize (M i); cbv [near_reach sgn coord fst snd].
  - pose proof (Rmax_l (-1 * lo A i) (-1 * lo B i)); pose proof (Rmax_r (-1 * lo A i) (-1 * lo B i)).
    destruct M as [_ M]; revert M; unfold Rmin; destruct Rle_dec; lra.
  - rewrite !Rmult_1_l; apply M.
Qed.
Lemma near_corner_back T h :
  (forall i, lo T i <= Rmax (hi A i) (hi B i) /\ Rmin (lo A i) (lo B i) <= hi T i) ->
  Rmin (reach A h) (reach B h) <= near_reach T h ->
  Rmin (lo A (fst h)) (lo B (fst h)) <= near_coord T h <= Rmax (hi A (fst h)) (hi B (fst h)).
Proof.
  intros M K; destruct h as [i []]; specialize (M i); cbv [near_reach near_coord sgn coord fst snd] in *;
  (split; [|]); try apply M; pose proof (wA i); pose proof (wB i).
  - pose proof (Rmax_l (hi A i) (hi B i)); pose proof (Rmax_r (hi A i) (hi B i)).
    revert K; unfold Rmin; destruct Rle_dec; lra.
  - pose proof (Rmin_l (lo A i) (lo B i)); pose proof (Rmin_r (lo A i) (lo B i)).
    revert K; unfold Rmin at 1; destruct Rle_dec; lra.
Qed.

(** A near corner that lies beyond the plane, of a box that meets the extent box, lies within the extent box. *)
Lemma beyond_near_corner_within T :
  (forall i, lo T i <= Rmax (hi A i) (hi B i) /\ Rmin (lo A i) (lo B i) <= hi T i) ->
  true_value A B f g (near_coord T f) (near_coord T g) > 0 ->
  (Rmin (lo A (fst f)) (lo B (fst f)) <= near_coord T f <= Rmax (hi A (fst f)) (hi B (fst f))) /\
  (Rmin (lo A (fst g)) (lo B (fst g)) <= near_coord T g <= Rmax (hi A (fst g)) (hi B (fst g))).
Proof.
  intros M V; unfold extreme in Ef, Eg.
  assert (V' : (reach B g - reach A g) * (near_reach T f - reach A f) +
               (reach A f - reach B f) * (near_reach T g - reach A g) > 0).
  { eapply Rlt_le_trans; [exact V|apply Req_le]; unfold true_value, exact_value, true_n0, true_n1.
    clear; destruct f as [i []], g as [j []]; cbv [sgn coord near_coord near_reach fst snd]; ring. }
  pose proof (near_corner_not_past_extent T f M) as X1; rewrite Rmax_left in X1 by lra.
  pose proof (near_corner_not_past_extent T g M) as Y1; rewrite Rmax_right in Y1 by lra.
  destruct (beyond_near_coordinates _ _ _ _ _ _ Ef Eg X1 Y1 V') as [X2 Y2].
  split; apply near_corner_back; auto; [rewrite Rmin_right|rewrite Rmin_left]; lra.
Qed.

Theorem certified_not_beyond T :
  (forall i, lo T i <= Rmax (hi A i) (hi B i) /\ Rmin (lo A i) (lo B i) <= hi T i) ->
  code_value A B f g (near_coord T f) (near_coord T g) <= - code_threshold A B f g ->
  true_value A B f g (near_coord T f) (near_coord T g) <= 0.
Proof.
  intros M V; apply Rnot_lt_le; intro P.
  destruct (beyond_near_corner_within T M P) as [X Y].
  pose proof (value_within_threshold _ _ X Y) as K; apply Rabs_le_inv in K; lra.
Qed.

Theorem certified_keep_is_near T :
  (forall i, lo T i <= Rmax (hi A i) (hi B i) /\ Rmin (lo A i) (lo B i) <= hi T i) ->
  code_value A B f g (near_coord T f) (near_coord T g) <= code_threshold A B f g ->
  true_value A B f g (near_coord T f) (near_coord T g) <= 2 * code_threshold A B f g.
Proof.
  intros M V; destruct (Rle_lt_dec (true_value A B f g (near_coord T f) (near_coord T g)) 0) as [P|P].
  - pose proof (value_within_threshold (coord A f) (coord A g)) as K.
    assert (X : forall h, Rmin (lo A (fst h)) (lo B (fst h)) <= coord A h <= Rmax (hi A (fst h)) (hi B (fst h))).
    { intro h; pose proof (wA (fst h)).
      pose proof (Rmin_l (lo A (fst h)) (lo B (fst h))); pose proof (Rmax_l (hi A (fst h)) (hi B (fst h))).
      destruct h as [k []]; cbv [coord fst snd] in *; lra. }
    specialize (K (X f) (X g)); pose proof (Rabs_pos (code_value A B f g (coord A f) (coord A g) -
      true_value A B f g (coord A f) (coord A g))); lra.
  - destruct (beyond_near_corner_within T M P) as [X Y].
    pose proof (value_within_threshold _ _ X Y) as K; apply Rabs_le_inv in K; lra.
Qed.
End OnePlane.

(** All planes together: what the test calls inside is inside. *)
Theorem certified_inside_is_right A B T :
  valid A -> valid B -> valid T -> float_box A -> float_box B ->
  (forall i, Rmin (lo A i) (lo B i) <= lo T i /\ hi T i <= Rmax (hi A i) (hi B i)) ->
  (forall f g, fst f <> fst g -> extreme A B f -> extreme B A g ->
     code_value A B f g (coord T f) (coord T g) <= - code_threshold A B f g) ->
  forall x, in_box T x -> hull A B x.
Proof.
  intros wA wB wT FA FB E P; apply inside_test_is_exact; auto; split; [exact E|].
  intros f g N Ef Eg; specialize (P f g N Ef Eg).
  assert (X : forall h, Rmin (lo A (fst h)) (lo B (fst h)) <= coord T h <= Rmax (hi A (fst h)) (hi B (fst h))).
  { intro h; specialize (E (fst h)); specialize (wT (fst h)); destruct h as [k []]; cbv [coord fst snd] in *; lra. }
  pose proof (value_within_threshold A B f g FA FB N Ef Eg (coord T f) (coord T g) (X f) (X g)) as K; apply Rabs_le_inv in K.
  assert (V : true_value A B f g (coord T f) (coord T g) <= 0) by lra.
  rewrite offset_edge_plane; unfold true_value, exact_value, true_n0, true_n1, far_reach in *.
  clear - V; destruct f as [i []], g as [j []]; cbv [sgn coord fst snd] in *; lra.
Qed.
End Certified.

(** For the two formats that the code is compiled for. *)
Definition float32_cull_is_right := @certified_cull_is_right float32.
Definition float64_cull_is_right := @certified_cull_is_right float64.
