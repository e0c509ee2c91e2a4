(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * The box test by slabs in s

    fast/slab_box.cpp, step by step, in real numbers: an interval of s is cut by six inequalities p + q s >= 0; T is
    outside when nothing is left of it, and inside when each of its eight corners has an interval of its own.
    [slab_box_is_exact]: all three answers are right. *)
Require Import Reals Lra Psatz List Bool.
Require Import Gnomon.Boxes Gnomon.PlaneSet Gnomon.BoxTest.
Import ListNotations.
Open Scope R_scope.

Inductive category := outside | overlap | inside.

(** SInterval *)
Record interval := Interval { from : R; to : R }.
Definition whole : interval := Interval 0 1.
Definition is_empty (i : interval) : bool := if Rle_dec (from i) (to i) then false else true.
Definition cut (p q : R) (i : interval) : interval :=
  if Rlt_dec 0 q then Interval (Rmax (from i) (- p / q)) (to i)
  else if Rlt_dec q 0 then Interval (from i) (Rmin (to i) (- p / q))
  else if Rlt_dec p 0 then Interval (from i) (-1)
  else i.

(** interval_of: the s for which x lies between the two sides of (1-s)a + sb on the axis. *)
Definition interval_of (A B : box) (i : axis) (x : R) : interval :=
  cut (x - lo A i) (lo A i - lo B i) (cut (hi A i - x) (hi B i - hi A i) whole).

Definition cut_by_axis (A B T : box) (i : axis) (s : interval) : interval :=
  cut (hi T i - lo A i) (lo A i - lo B i) (cut (hi A i - lo T i) (hi B i - hi A i) s).
Definition common_s (A B T : box) : interval :=
  cut_by_axis A B T Z (cut_by_axis A B T Y (cut_by_axis A B T X whole)).

(** One corner of T a choice of sides. *)
Definition corner_has_its_s (A B T : box) (u v w : side) : bool :=
  let x := interval_of A B X (coord T (X, u)) in
  let y := interval_of A B Y (coord T (Y, v)) in
  let z := interval_of A B Z (coord T (Z, w)) in
  if Rle_dec (Rmax (Rmax (from x) (from y)) (from z)) (Rmin (Rmin (to x) (to y)) (to z)) then true else false.
Definition every_corner_has_its_s (A B T : box) : bool :=
  forallb (fun u => forallb (fun v => forallb (corner_has_its_s A B T u v) [MIN; MAX]) [MIN; MAX]) [MIN; MAX].

Definition classify_by_slabs (A B T : box) : category :=
  if is_empty (common_s A B T) then outside
  else if every_corner_has_its_s A B T then inside else overlap.

(** ** It is exact *)

(** `to` = -1 is as good as no interval, as `from` never becomes negative. *)
Definition has (i : interval) (s : R) : Prop := from i <= s <= to i.
Lemma cut_is p q i s : 0 <= from i -> (has (cut p q i) s <-> has i s /\ 0 <= p + q * s) /\ 0 <= from (cut p q i).
Proof.
  intro H; unfold cut, has; destruct Rlt_dec as [P|P]; [|destruct Rlt_dec as [M|M]; [|destruct Rlt_dec as [O|O]]]; simpl.
  - assert (E : q * (- p / q) = - p) by (field; lra).
    assert (K : - p / q <= s <-> 0 <= p + q * s).
    { split; intro L.
      - assert (q * (- p / q) <= q * s) by (apply Rmult_le_compat_l; lra); lra.
      - apply Rmult_le_reg_l with q; lra. }
    pose proof (Rmax_l (from i) (- p / q)); pose proof (Rmax_r (from i) (- p / q)).
    split; [split|lra].
    + intros [L L']; assert (- p / q <= s) by lra; tauto || (split; [lra|tauto]).
    + intros [[L L'] V]; apply K in V; split; [apply Rmax_lub|]; lra.
  - assert (E : - q * (- p / q) = p) by (field; lra).
    assert (K : s <= - p / q <-> 0 <= p + q * s).
    { split; intro L.
      - assert (- q * s <= - q * (- p / q)) by (apply Rmult_le_compat_l; lra); lra.
      - apply Rmult_le_reg_l with (- q); lra. }
    pose proof (Rmin_l (to i) (- p / q)); pose proof (Rmin_r (to i) (- p / q)).
    split; [split|lra].
    + intros [L L']; assert (s <= - p / q) by lra; split; [lra|tauto].
    + intros [[L L'] V]; apply K in V; split; [|apply Rmin_glb]; lra.
  - assert (q = 0) by lra; subst q; split; [split; intros; lra|exact H].
  - assert (q = 0) by lra; subst q; split; [split; intros; lra|exact H].
Qed.

Lemma empty_is i : is_empty i = true <-> ~ exists s, has i s.
Proof.
  unfold is_empty, has; destruct Rle_dec as [L|L]; split; intro H; try discriminate; auto.
  - exfalso; apply H; exists (from i); lra.
  - intros [s Hs]; lra.
Qed.

Lemma common_s_is A B T s : has (common_s A B T) s <-> forall f, fits A B T f s.
Proof.
  unfold common_s, cut_by_axis.
  pose proof (fun p q i H => proj1 (cut_is p q i s H)) as C; pose proof (fun p q i H => proj2 (cut_is p q i s H)) as D.
  assert (W : 0 <= from whole) by (simpl; lra).
  rewrite !C by (repeat apply D; exact W); unfold has, whole, fits, lerp; simpl; split.
  - intros H [[] []]; cbv [sgn coord near_reach fst snd]; lra.
  - intro H; pose proof (H (X, MIN)); pose proof (H (X, MAX)); pose proof (H (Y, MIN)); pose proof (H (Y, MAX)).
    pose proof (H (Z, MIN)); pose proof (H (Z, MAX)); cbv [sgn coord near_reach fst snd] in *; lra.
Qed.

Theorem slab_outside_is_exact A B T : valid A -> valid B -> valid T ->
  (is_empty (common_s A B T) = true <-> ~ exists x, hull A B x /\ in_box T x).
Proof.
  intros wA wB wT; rewrite empty_is, meets_iff_one_s_fits_all by assumption.
  split; intros H [s K]; apply H; exists s; apply common_s_is; exact K.
Qed.

Definition corner (T : box) (u v w : side) : point :=
  fun i => match i with X => coord T (X, u) | Y => coord T (Y, v) | Z => coord T (Z, w) end.
Lemma interval_of_is A B i x s : has (interval_of A B i x) s <->
  0 <= s <= 1 /\ lerp s (lo A i) (lo B i) <= x <= lerp s (hi A i) (hi B i).
Proof.
  unfold interval_of.
  pose proof (fun p q i H => proj1 (cut_is p q i s H)) as C; pose proof (fun p q i H => proj2 (cut_is p q i s H)) as D.
  assert (W : 0 <= from whole) by (simpl; lra).
  rewrite !C by (repeat apply D; exact W); unfold has, whole, lerp; simpl; lra.
Qed.
Lemma corner_has_its_s_is A B T u v w : valid A -> valid B ->
  (corner_has_its_s A B T u v w = true <-> hull A B (corner T u v w)).
Proof.
  intros wA wB; unfold corner_has_its_s; rewrite hull_is_union_of_boxes by assumption.
  set (x := interval_of A B X _); set (y := interval_of A B Y _); set (z := interval_of A B Z _).
  pose proof (Rmax_l (Rmax (from x) (from y)) (from z)) as M1; pose proof (Rmax_r (Rmax (from x) (from y)) (from z)) as M2.
  pose proof (Rmax_l (from x) (from y)) as M3; pose proof (Rmax_r (from x) (from y)) as M4.
  pose proof (Rmin_l (Rmin (to x) (to y)) (to z)) as N1; pose proof (Rmin_r (Rmin (to x) (to y)) (to z)) as N2.
  pose proof (Rmin_l (to x) (to y)) as N3; pose proof (Rmin_r (to x) (to y)) as N4.
  assert (K : forall s, has x s /\ has y s /\ has z s <->
    0 <= s <= 1 /\ forall i, lerp s (lo A i) (lo B i) <= corner T u v w i <= lerp s (hi A i) (hi B i)).
  { intro s; unfold x, y, z; rewrite !interval_of_is; split.
    - intros [[? ?] [[_ ?] [_ ?]]]; split; [assumption|intros []; assumption].
    - intros [? H]; repeat split; try lra; try apply (H X); try apply (H Y); apply (H Z). }
  unfold has in K; destruct Rle_dec as [L|L]; split; intro H; try discriminate; auto.
  - set (s := Rmax (Rmax (from x) (from y)) (from z)) in *; exists s; apply K; lra.
  - destruct H as [s H]; apply K in H; exfalso; apply L.
    apply Rle_trans with s; repeat apply Rmax_lub; repeat apply Rmin_glb; lra.
Qed.

Lemma every_corner_is A B T : valid A -> valid B ->
  (every_corner_has_its_s A B T = true <-> forall u v w, hull A B (corner T u v w)).
Proof.
  intros wA wB; unfold every_corner_has_its_s; split.
  - intros H u v w; rewrite forallb_forall in H.
    assert (I : forall s, In s [MIN; MAX]) by (intros []; simpl; auto).
    specialize (H u (I u)); cbv beta in H; rewrite forallb_forall in H.
    specialize (H v (I v)); cbv beta in H; rewrite forallb_forall in H.
    apply corner_has_its_s_is; auto.
  - intro H; apply forallb_forall; intros u _; apply forallb_forall; intros v _; apply forallb_forall; intros w _.
    apply corner_has_its_s_is; auto.
Qed.

(** Corners are enough: every plane has a corner of T as T's farthest point. *)
Lemma corners_inside_all_inside A B T : valid A -> valid B -> valid T ->
  ((forall u v w, hull A B (corner T u v w)) <-> forall x, in_box T x -> hull A B x).
Proof.
  intros wA wB wT; split.
  - intro H; apply inside_test_is_exact; auto; split.
    + intro i; split.
      * pose proof (shaft_within_extent A B _ wA wB (H MIN MIN MIN) i); destruct i; simpl in *; unfold coord in *; simpl in *; lra.
      * pose proof (shaft_within_extent A B _ wA wB (H MAX MAX MAX) i); destruct i; simpl in *; unfold coord in *; simpl in *; lra.
    + intros f g N Ef Eg.
      assert (K : exists u v w, corner T u v w (fst f) = coord T f /\ corner T u v w (fst g) = coord T g).
      { destruct f as [[] s], g as [[] t]; simpl in N; try congruence;
        [exists s, t, MIN|exists s, MIN, t|exists t, s, MIN|exists MIN, s, t|exists t, MIN, s|exists MIN, t, s];
        split; reflexivity. }
      destruct K as [u [v [w [K0 K1]]]].
      pose proof (hull_within_plane A B f g _ wA wB N Ef Eg (H u v w)) as P.
      rewrite dot_edge_plane, K0, K1 in P by auto; exact P.
  - intros H u v w; apply H; intro i; pose proof (wT i); destruct i; simpl; unfold coord; simpl;
    [destruct u|destruct v|destruct w]; lra.
Qed.

Theorem slab_box_is_exact A B T : valid A -> valid B -> valid T ->
  match classify_by_slabs A B T with
  | outside => ~ exists x, hull A B x /\ in_box T x
  | inside => forall x, in_box T x -> hull A B x
  | overlap => (exists x, hull A B x /\ in_box T x) /\ ~ forall x, in_box T x -> hull A B x
  end.
Proof.
  intros wA wB wT; unfold classify_by_slabs.
  pose proof (slab_outside_is_exact A B T wA wB wT) as O.
  pose proof (every_corner_is A B T wA wB) as C; pose proof (corners_inside_all_inside A B T wA wB wT) as I.
  destruct (is_empty _); [apply O; reflexivity|].
  destruct (every_corner_has_its_s A B T); [apply I, C; reflexivity|split].
  - destruct (outside_or_meets A B T wA wB wT) as [H|H]; [|exact H].
    apply box_test_is_exact in H; auto; apply O in H; discriminate.
  - intro H; discriminate (proj2 C (proj2 I H)).
Qed.
