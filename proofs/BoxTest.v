(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * The box test is exact

    The paper's test says "outside" when T lies beyond the extent box or beyond a plane. In real arithmetic that is
    right in both directions: outside exactly when the shaft and T have no common point. One direction is geometry
    (everything tested against contains the shaft). The other is Helly's theorem: T meets the shaft when some s
    satisfies six linear inequalities; where every two of them have a common s all have; and where two have none,
    an extent side or a plane says so. *)
Require Import Reals Lra Psatz List Bool Arith.
Require Import Gnomon.Helly Gnomon.Boxes Gnomon.PlaneSet.
Import ListNotations.
Open Scope R_scope.
Notation reach A f := (sgn f * coord A f).

Definition beyond_extent (A B T : box) : Prop :=
  exists i, hi T i < Rmin (lo A i) (lo B i) \/ lo T i > Rmax (hi A i) (hi B i).

Definition test_says_outside (A B T : box) : Prop :=
  beyond_extent A B T \/ exists p, In p (planes A B) /\ beyond p T.

(** Inequality of face f: at the parameter s, the box (1-s)A + sB reaches as far as the near side of T. *)
Definition fits (A B T : box) (f : face) (s : R) : Prop :=
  0 <= s <= 1 /\ lerp s (sgn f * coord A f) (sgn f * coord B f) >= near_reach T f.

Lemma meets_iff_one_s_fits_all A B T : valid A -> valid B -> valid T ->
  ((exists x, hull A B x /\ in_box T x) <-> exists s, forall f, fits A B T f s).
Proof.
  intros wA wB wT; split.
  - intros [x [Hx Ht]]; apply hull_is_union_of_boxes in Hx; auto; destruct Hx as [s [Hs H]].
    exists s; intros [i []]; (split; [exact Hs|]); specialize (H i); specialize (Ht i);
    cbv [lerp sgn coord near_reach fst snd] in *; lra.
  - intros [s H]; destruct (H (X,MIN)) as [Hs _].
    exists (fun i => Rmax (lerp s (lo A i) (lo B i)) (lo T i)).
    assert (K : forall i, lerp s (lo A i) (lo B i) <= lerp s (hi A i) (hi B i) /\
              lerp s (lo A i) (lo B i) <= hi T i /\ lo T i <= lerp s (hi A i) (hi B i)).
    { intro i; destruct (H (i,MIN)) as [_ H1]; destruct (H (i,MAX)) as [_ H2];
      cbv [lerp sgn coord near_reach fst snd] in *; specialize (wA i); specialize (wB i);
      repeat split; nra. }
    split.
    + apply hull_is_union_of_boxes; auto; exists s; split; [exact Hs|].
      intro i; destruct (K i) as [K1 [K2 K3]]; split; [apply Rmax_l | apply Rmax_lub; lra].
    + intro i; destruct (K i) as [K1 [K2 K3]]; split; [apply Rmax_r | apply Rmax_lub; auto].
Qed.

Lemma fits_is_convex A B T f : convex_set (fits A B T f).
Proof.
  unfold convex_set, fits, lerp; generalize (sgn f * coord A f) (sgn f * coord B f) (near_reach T f).
  intros a b t x y z [? ?] [? ?] ?; split; [lra|].
  destruct (Rle_dec a b); nra.
Qed.

Theorem outside_is_never_wrong A B T : valid A -> valid B -> valid T ->
  test_says_outside A B T -> ~ exists x, hull A B x /\ in_box T x.
Proof.
  intros wA wB wT [[i E]|[p [I O]]] [x [Hx Ht]].
  - apply hull_is_union_of_boxes in Hx; auto; destruct Hx as [s [Hs H]]; specialize (H i); specialize (Ht i).
    unfold lerp in H.
    pose proof (Rmin_l (lo A i) (lo B i)); pose proof (Rmin_r (lo A i) (lo B i)).
    pose proof (Rmax_l (hi A i) (hi B i)); pose proof (Rmax_r (hi A i) (hi B i)).
    destruct E; nra.
  - destruct (proj1 (planes_are_the_papers A B p)) as [f [g [N [Ef [Eg [E1 E2]]]]]].
    { exists p; repeat split; auto. }
    pose proof (hull_within_plane A B f g x wA wB N Ef Eg Hx) as K.
    pose proof (O x Ht) as L; unfold dot in *; rewrite !E2, E1 in K; lra.
Qed.

Lemma crossing a b t : a >= t -> b < t ->
  exists s, 0 <= s <= 1 /\ (a - b) * s = a - t.
Proof.
  intros Ha Hb; exists ((a - t) / (a - b)).
  assert (E : (a - b) * ((a - t) / (a - b)) = a - t) by (field; lra).
  split; [split|exact E]; apply Rmult_le_reg_l with (a - b); lra.
Qed.

(** A satisfies f but not g, B satisfies g but not f *)
Lemma crossing_pair_meets A B T f g : valid A -> valid B -> valid T ->
  reach A f >= near_reach T f -> reach B f < near_reach T f -> reach A g < near_reach T g -> reach B g >= near_reach T g ->
  test_says_outside A B T \/ exists s, fits A B T f s /\ fits A B T g s.
Proof.
  intros wA wB wT H1 H2 H3 H4.
  destruct (crossing _ _ _ H1 H2) as [s [Hs E]].
  assert (Cf : fits A B T f s) by (split; [exact Hs|unfold lerp; lra]).
  destruct f as [i u], g as [j v].
  assert (D : i = j \/ i <> j) by (destruct i, j; (left; reflexivity) || (right; discriminate)).
  destruct D as [<-|N].
  - (* same axis: follows from lo <= hi *)
    right; exists s; split; [exact Cf|split; [exact Hs|]]; unfold lerp.
    specialize (wA i); specialize (wB i); specialize (wT i).
    destruct u, v; cbv [sgn coord near_reach fst snd] in *; nra.
  - (* different axes: this is the plane test *)
    set (f := (i, u)) in *; set (g := (j, v)) in *.
    destruct (Rlt_le_dec (offset (edge_plane A B f g))
       ((reach B g - reach A g) * near_reach T f + (reach A f - reach B f) * near_reach T g)) as [P|P].
    + left; right.
      destruct (proj2 (planes_are_the_papers A B (edge_plane A B f g))) as [q [I [Q1 Q2]]].
      { exists f, g; repeat split; auto; unfold extreme; lra. }
      exists q; split; [exact I|].
      assert (O : beyond (edge_plane A B f g) T)
        by (apply beyond_iff_near_corner; auto; unfold extreme; lra).
      intros x Hx; specialize (O x Hx); unfold dot in *; rewrite !Q2, Q1; exact O.
    + right; exists s; split; [exact Cf|split; [exact Hs|]].
      rewrite offset_edge_plane in P; unfold lerp.
      set (a := reach A f) in *; set (b := reach B f) in *; set (c := reach A g) in *; set (d := reach B g) in *.
      set (t := near_reach T f) in *; set (w := near_reach T g) in *.
      apply Rle_ge; apply Rmult_le_reg_l with (a - b); [lra|].
      replace ((a - b) * ((1 - s) * c + s * d)) with ((a - b) * c + ((a - b) * s) * (d - c)) by ring.
      rewrite E; nra.
Qed.

Lemma extent_face A B T f : reach A f < near_reach T f -> reach B f < near_reach T f -> test_says_outside A B T.
Proof.
  intros H1 H2; left; exists (fst f); destruct f as [i []]; cbv [sgn coord near_reach fst snd] in *.
  - left; apply Rmin_glb_lt; lra.
  - right; apply Rmax_lub_lt; lra.
Qed.

Lemma pair_meets A B T f g : valid A -> valid B -> valid T ->
  test_says_outside A B T \/ exists s, fits A B T f s /\ fits A B T g s.
Proof.
  intros wA wB wT.
  destruct (Rlt_le_dec (reach A f) (near_reach T f)) as [a|a], (Rlt_le_dec (reach B f) (near_reach T f)) as [b|b];
  [left; exact (extent_face _ _ _ f a b)| | |];
  destruct (Rlt_le_dec (reach A g) (near_reach T g)) as [c|c], (Rlt_le_dec (reach B g) (near_reach T g)) as [d|d];
  try (left; exact (extent_face _ _ _ g c d));
  try (right; exists 0; unfold fits, lerp; lra);
  try (right; exists 1; unfold fits, lerp; lra).
  - destruct (crossing_pair_meets A B T g f) as [?|[s [? ?]]]; auto; try lra; right; exists s; auto.
  - apply crossing_pair_meets; auto; lra.
Qed.

Lemma or_forall (D : Prop) (P : face -> Prop) : (forall f, D \/ P f) -> D \/ forall f, P f.
Proof.
  intro H; destruct (H (X,MIN)), (H (X,MAX)), (H (Y,MIN)), (H (Y,MAX)), (H (Z,MIN)), (H (Z,MAX));
  auto; right; intros [[] []]; assumption.
Qed.

Theorem outside_or_meets A B T : valid A -> valid B -> valid T ->
  test_says_outside A B T \/ exists x, hull A B x /\ in_box T x.
Proof.
  intros wA wB wT.
  destruct (or_forall (test_says_outside A B T)
     (fun f => forall g, exists s, fits A B T f s /\ fits A B T g s)) as [?|H]; auto.
  { intro f; apply or_forall; intro g; apply pair_meets; auto. }
  right; apply meets_iff_one_s_fits_all; auto.
  destruct (helly_on_the_line (map (fits A B T) faces) (fits A B T (X,MIN))) as [s [_ Hs]].
  - destruct (H (X,MIN) (X,MIN)) as [s [? _]]; exists s; auto.
  - apply fits_is_convex.
  - intros Q I; apply in_map_iff in I; destruct I as [f [<- _]]; apply fits_is_convex.
  - intros Q I; apply in_map_iff in I; destruct I as [f [<- _]]; apply H.
  - intros Q W I J; apply in_map_iff in I; apply in_map_iff in J.
    destruct I as [f [<- _]], J as [g [<- _]]; apply H.
  - exists s; intro f; apply Hs; apply in_map; apply every_face_listed.
Qed.

Theorem box_test_is_exact A B T : valid A -> valid B -> valid T ->
  (test_says_outside A B T <-> ~ exists x, hull A B x /\ in_box T x).
Proof.
  intros wA wB wT; split; [apply outside_is_never_wrong; auto|].
  intro H; destruct (outside_or_meets A B T wA wB wT); tauto.
Qed.

(** ** Inside

    The shaft is the intersection of its extent box and its half-spaces (claim S18, the half about sufficiency), so
    T lies inside exactly when all of T does so; for a plane that is a matter of the far corner. *)
Definition in_extent (A B : box) (x : point) : Prop :=
  forall i, Rmin (lo A i) (lo B i) <= x i <= Rmax (hi A i) (hi B i).

Lemma shaft_within_extent A B x : valid A -> valid B -> hull A B x -> in_extent A B x.
Proof.
  intros wA wB H i; apply hull_is_union_of_boxes in H; auto; destruct H as [s [Hs H]]; specialize (H i).
  unfold lerp in H.
  pose proof (Rmin_l (lo A i) (lo B i)); pose proof (Rmin_r (lo A i) (lo B i)).
  pose proof (Rmax_l (hi A i) (hi B i)); pose proof (Rmax_r (hi A i) (hi B i)).
  split; nra.
Qed.

Theorem shaft_is_extent_and_planes A B x : valid A -> valid B ->
  (hull A B x <-> in_extent A B x /\
     forall f g, fst f <> fst g -> extreme A B f -> extreme B A g ->
       dot (normal (edge_plane A B f g)) x <= offset (edge_plane A B f g)).
Proof.
  intros wA wB; split.
  - intro H; split; [apply shaft_within_extent; auto|].
    intros; apply hull_within_plane; auto.
  - intros [E P].
    set (T := Box x x).
    assert (wT : valid T) by (intro i; simpl; lra).
    assert (Ix : in_box T x) by (intro i; simpl; lra).
    destruct (outside_or_meets A B T wA wB wT) as [O|[y [Hy Ty]]].
    + exfalso; destruct O as [[i O]|[p [I O]]].
      * specialize (E i); simpl in O; lra.
      * destruct (proj1 (planes_are_the_papers A B p)) as [f [g [N [Ef [Eg [E1 E2]]]]]].
        { exists p; repeat split; auto. }
        specialize (P f g N Ef Eg); specialize (O x Ix); unfold dot in *; rewrite !E2, E1 in P; lra.
    + apply hull_is_union_of_boxes in Hy; auto; apply hull_is_union_of_boxes; auto.
      destruct Hy as [s [Hs Hy]]; exists s; split; [exact Hs|].
      intro i; specialize (Hy i); specialize (Ty i); simpl in Ty.
      replace (x i) with (y i) by lra; exact Hy.
Qed.

(** The value of the far corner of T on face f, counted outwards. *)
Definition far_reach (T : box) (f : face) : R := sgn f * coord T f.

Lemma behind_iff_far_corner A B f g T : valid T -> fst f <> fst g -> extreme A B f -> extreme B A g ->
  ((forall x, in_box T x -> dot (normal (edge_plane A B f g)) x <= offset (edge_plane A B f g)) <->
   (reach B g - reach A g) * far_reach T f + (reach A f - reach B f) * far_reach T g
     <= offset (edge_plane A B f g)).
Proof.
  intros wT N Ef Eg; unfold extreme in *; split.
  - intro H.
    specialize (H (fun k => if axis_eqb k (fst f) then coord T f else
                            if axis_eqb k (fst g) then coord T g else lo T k)).
    rewrite dot_edge_plane in H by auto.
    assert (I : forall k, axis_eqb k k = true) by (intros []; reflexivity).
    assert (J : axis_eqb (fst g) (fst f) = false)
      by (destruct f as [[] ?], g as [[] ?]; simpl in *; congruence).
    rewrite !I, J in H; apply H; clear H; intro k; generalize (wT k).
    destruct k, f as [[] []], g as [[] []]; cbv [sgn coord fst snd axis_eqb] in *; intro; try congruence; lra.
  - intros H x Hx; rewrite dot_edge_plane by auto.
    assert (F : forall h, sgn h * x (fst h) <= far_reach T h).
    { intros [i []]; specialize (Hx i); cbv [sgn coord far_reach fst snd]; lra. }
    generalize (F f), (F g); intros; nra.
Qed.

Theorem inside_test_is_exact A B T : valid A -> valid B -> valid T ->
  ((forall x, in_box T x -> hull A B x) <->
   (forall i, Rmin (lo A i) (lo B i) <= lo T i /\ hi T i <= Rmax (hi A i) (hi B i)) /\
   (forall f g, fst f <> fst g -> extreme A B f -> extreme B A g ->
      (reach B g - reach A g) * far_reach T f + (reach A f - reach B f) * far_reach T g
        <= offset (edge_plane A B f g))).
Proof.
  intros wA wB wT; split.
  - intro H; split.
    + intro i; split.
      * apply (shaft_within_extent A B (lo T)); auto; apply H; intro k; split; [lra|apply wT].
      * apply (shaft_within_extent A B (hi T)); auto; apply H; intro k; split; [apply wT|lra].
    + intros f g N Ef Eg; apply behind_iff_far_corner; auto.
      intros x Hx; apply hull_within_plane; auto.
  - intros [E P] x Hx; apply shaft_is_extent_and_planes; auto; split.
    + intro i; specialize (E i); specialize (Hx i); lra.
    + intros f g N Ef Eg; revert x Hx; apply behind_iff_far_corner; auto.
Qed.
