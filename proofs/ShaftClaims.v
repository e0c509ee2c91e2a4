(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * Short claims about the shaft

    S1, S10, S11 and S19 of the paper's claims, each a few lines from what other files prove, and what is left of S11,
    S12 and S14 where numbers are rounded. *)
Require Import Reals Lra.
Require Import Gnomon.Boxes Gnomon.PlaneSet Gnomon.BoxTest.
Open Scope R_scope.

(** S1: a ray that starts on one reference item and ends on the other stays in the shaft. *)
Theorem every_segment_lies_in_the_shaft A B a b s x : in_box A a -> in_box B b -> 0 <= s <= 1 ->
  (forall i, x i = lerp s (a i) (b i)) -> hull A B x.
Proof. intros Ha Hb Hs E; exists s, a, b; split; [exact Hs|split; [exact Ha|split; [exact Hb|exact E]]]. Qed.

(** S10: what meets a reference box meets the shaft. The items may be of any form. *)
Theorem overlaps_reference_overlaps_shaft A B (item : point -> Prop) : valid A -> valid B ->
  (exists x, item x /\ (in_box A x \/ in_box B x)) -> exists x, item x /\ hull A B x.
Proof. intros wA wB [x [I H]]; exists x; split; [exact I|apply hull_contains; assumption]. Qed.

(** S11: what encloses a reference box is hit by every ray. *)
Theorem encloses_reference_is_always_hit A B (item : point -> Prop) a b : in_box A a -> in_box B b ->
  (forall x, in_box A x -> item x) \/ (forall x, in_box B x -> item x) ->
  exists s x, 0 <= s <= 1 /\ (forall i, x i = lerp s (a i) (b i)) /\ item x.
Proof.
  intros Ha Hb [H|H]; [exists 0, a|exists 1, b]; (split; [lra|split; [intro i; unfold lerp; ring|auto]]).
Qed.

(** S19: the paper computes the offset from either box's edge. In real numbers that is the same plane; in floats it is
    not: [BallTestCertified.other_edge] bounds the difference. *)
Theorem offset_from_either_edge A B f g x : fst f <> fst g -> on_edge A f g x \/ on_edge B f g x ->
  offset (edge_plane A B f g) = dot (normal (edge_plane A B f g)) x.
Proof. intros N H; symmetry; apply plane_contains_edges; assumption. Qed.

(** ** Rounded

    Rounding keeps order and 0, and changes no rounded number; range unbounded. *)
Section Rounded.
Variable rnd : R -> R.
Hypothesis rnd_le : forall x y, x <= y -> rnd x <= rnd y.
Hypothesis rnd_0 : rnd 0 = 0.
Hypothesis rnd_rnd : forall x, rnd (rnd x) = rnd x.

Lemma rnd_nonpos x : x <= 0 -> rnd x <= 0.
Proof. intro H; rewrite <- rnd_0; apply rnd_le; exact H. Qed.
Lemma rnd_nonneg x : 0 <= x -> 0 <= rnd x.
Proof. intro H; rewrite <- rnd_0; apply rnd_le; exact H. Qed.

(** S11: a ray's start p lies in a slab, [lo, hi]; then so does the parameter 0 in the slab's interval as computed,
    whatever the rounded inverse of the direction. The far end may be multiplied by anything positive. *)
Theorem start_within_slab_is_never_missed lo hi p inverse widen : lo <= p <= hi -> 0 <= widen ->
  let enter := rnd (rnd ((if Rlt_dec inverse 0 then hi else lo) - p) * inverse) in
  let leave := rnd (rnd (rnd ((if Rlt_dec inverse 0 then lo else hi) - p) * inverse) * widen) in
  enter <= 0 <= leave.
Proof.
  intros [L H] W; destruct (Rlt_dec inverse 0) as [N|N]; cbv zeta; split.
  - apply rnd_nonpos; assert (A := rnd_nonneg (hi - p) ltac:(lra)); nra.
  - apply rnd_nonneg, Rmult_le_pos; [|exact W]; apply rnd_nonneg; assert (A := rnd_nonpos (lo - p) ltac:(lra)); nra.
  - apply rnd_nonpos; assert (A := rnd_nonpos (lo - p) ltac:(lra)); nra.
  - apply rnd_nonneg, Rmult_le_pos; [|exact W]; apply rnd_nonneg; assert (A := rnd_nonneg (hi - p) ltac:(lra)); nra.
Qed.

(** S11: a ray's end q lies in a slab; then so does the parameter 1, if the end is rounded alike, and the inverse of the
    direction has a relative error below u: no overflow nor underflow. ([SlabRay] has it for floats.) Without the
    widening, 1 - u might be the slab's far end, and another slab's near end 1. Written for ascending rays; descending
    ones mirror them. *)
Variable u : R.
Hypothesis u_small : 0 <= u < 1.
Hypothesis rnd_1 : rnd 1 = 1.
Hypothesis just_above_one : forall x, x < 1 + u -> rnd x <= 1.
Hypothesis just_below_one : forall x, 1 - u <= x -> 1 - u <= rnd x.
Theorem end_within_slab_is_never_missed lo hi p q e widen : lo <= q <= hi -> 0 < rnd (q - p) ->
  Rabs e < u -> 1 <= (1 - u) * widen -> let inverse := (1 + e) / rnd (q - p) in
  let enter := rnd (rnd (lo - p) * inverse) in let leave := rnd (rnd (rnd (hi - p) * inverse) * widen) in
  enter <= 1 <= leave.
Proof.
  intros [L H] P E W; cbv zeta; set (d := rnd (q - p)) in *; set (inverse := (1 + e) / d).
  assert (B : - u < e < u) by (unfold Rabs in E; destruct (Rcase_abs e); lra).
  assert (Ei : d * inverse = 1 + e) by (unfold inverse; field; lra).
  assert (Pi : 0 <= inverse) by (unfold inverse; apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; exact P]).
  assert (A : rnd (lo - p) <= d) by (apply rnd_le; lra).
  assert (C : d <= rnd (hi - p)) by (apply rnd_le; lra).
  split; [apply just_above_one; nra|].
  assert (D : 1 - u <= rnd (rnd (hi - p) * inverse)) by (apply just_below_one; nra).
  rewrite <- rnd_1; apply rnd_le; nra.
Qed.

(** S12: of n children no more than all are kept, also by rounded counts and a rounded share. *)
Theorem share_of_all_is_never_exceeded ratio kept children : kept <= children -> 0 <= children -> 1 <= ratio ->
  rnd kept <= rnd (ratio * rnd children).
Proof.
  intros K C R1; apply Rle_trans with (rnd children); [apply rnd_le; exact K|].
  rewrite <- rnd_rnd at 1; apply rnd_le; assert (A := rnd_nonneg _ C); nra.
Qed.

(** S14: where the emitter's edge (x, y) gave the offset, the value of a corner that does not come after it in the
    direction of the rounded normal is never positive. The near corner of an item that meets the emitter does not. *)
Theorem naive_plane_keeps_items_at_its_own_box n0 n1 x y near_x near_y :
  n0 * near_x <= n0 * x -> n1 * near_y <= n1 * y ->
  rnd (rnd (rnd (n0 * near_x) + rnd (n1 * near_y)) - rnd (rnd (n0 * x) + rnd (n1 * y))) <= 0.
Proof.
  intros H0 H1; apply rnd_nonpos.
  assert (rnd (rnd (n0 * near_x) + rnd (n1 * near_y)) <= rnd (rnd (n0 * x) + rnd (n1 * y))); [|lra].
  apply rnd_le, Rplus_le_compat; apply rnd_le; assumption.
Qed.
End Rounded.
