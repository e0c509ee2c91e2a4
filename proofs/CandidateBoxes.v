(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * Candidate lists of boxes

    What [CandidateClaims] says, for boxes that are classified exactly against the shaft of two boxes; S14; and the
    counterexamples to S13 where strategies differ and to S20 by number of items. *)
Require Import Reals Lra ZArith List Bool Arith Lia QArith.
Require Import Gnomon.Boxes Gnomon.CandidateLists Gnomon.CandidateClaims.
Import ListNotations.
Local Open Scope R_scope.

Section Exact.
(** Bounds are boxes, or numbers that mean boxes. *)
Context {bound : Type}.
Variable real : bound -> box.
Definition holds b x := in_box (real b) x.

(** The three answers are right, and a volume encloses a reference box when it holds all of it. Whatever is disjoint is
    outside, so that a box without points is. *)
Definition exact (A B : box) (t : tests bound) : Prop := forall b,
  (classify t b = Outside <-> forall x, holds b x -> ~ hull A B x) /\
  (classify t b = Inside <-> (exists x, holds b x) /\ forall x, holds b x -> hull A B x) /\
  (encloses t b = true <-> (forall x, in_box A x -> holds b x) \/ (forall x, in_box B x -> holds b x)).

Lemma hull_mono A B A' B' x : (forall y, in_box A' y -> in_box A y) -> (forall y, in_box B' y -> in_box B y) ->
  hull A' B' x -> hull A B x.
Proof. intros HA HB [s [a [b [Hs [Ha [Hb E]]]]]]; exists s, a, b; auto. Qed.

(** S13 for boxes: with one strategy, smaller reference boxes bring no other primitives below the candidates. *)
Theorem sub_shaft_of_boxes A B A' B' t t' o i p :
  (forall y, in_box A' y -> in_box A y) -> (forall y, in_box B' y -> in_box B y) -> exact A B t -> exact A' B' t' ->
  In p (below (candidates o t' i)) -> In p (below (candidates o t i)).
Proof.
  intros HA HB E E'; apply sub_shaft_within_parent.
  - intros b C; apply E'; intros x Hx S; destruct (E b) as [[D _] _]; apply (D C x Hx).
    apply (hull_mono A B A' B'); assumption.
  - intros b C; apply E; destruct (E' b) as [_ [[D _] _]]; destruct (D C) as [N S]; split; [exact N|].
    intros x Hx; apply (hull_mono A B A' B'); auto.
  - intros b C; apply E'; destruct (E b) as [_ [_ [D _]]]; destruct (D C) as [H|H]; [left|right]; auto.
Qed.

(** S14: an item with a point in the emitter's box, or in the receiver's, is not outside. *)
Theorem item_at_the_emitter_is_not_outside A B t i x : valid A -> valid B -> exact A B t ->
  holds (bound_of i) x -> in_box A x \/ in_box B x -> classify t (bound_of i) <> Outside.
Proof.
  intros wA wB E H I C; destruct (E (bound_of i)) as [[D _] _]; apply (D C x H); apply hull_contains; assumption.
Qed.

(** S16 for boxes: the answer for a segment between the reference boxes is the same by every list and by the whole
    hierarchy. *)
Theorem every_strategy_answers_segments_alike A B t o i shape met hit a b fuel :
  exact A B t -> in_box A a -> in_box B b ->
  let ray x := exists s, 0 <= s <= 1 /\ forall j, x j = lerp s (a j) (b j) in
  (forall p, hit p = true -> exists x, shape p x /\ ray x) -> (forall c x, holds c x -> ray x -> met c = true) ->
  bounded holds shape i -> (size_of (candidates o t i) < fuel)%nat -> (size_of [i] < fuel)%nat ->
  cast met hit fuel (candidates o t i) = cast met hit fuel [i].
Proof.
  intros E Ha Hb ray Hhit Hmet W F1 F2.
  rewrite (the_hierarchy_casts_alike holds shape ray met hit Hhit Hmet i fuel W F2).
  apply (every_strategy_casts_alike holds shape (hull A B) t) with (ray := ray); auto.
  - intros c x C Hx S; destruct (E c) as [[D _] _]; exact (D C x Hx S).
  - intros x [s [Hs Ex]]; exists s, a, b; auto.
Qed.

(** The emitter list changes no list, and needs no test of the emitter. *)
Theorem emitter_list_of_boxes A B t (e : bound -> bool) o i : valid A -> valid B -> exact A B t ->
  (forall b, e b = true -> forall x, in_box A x -> holds b x) ->
  flat_map (candidates o t) (emitter_list e i) = candidates o t i.
Proof.
  intros wA wB E He; apply emitter_list_changes_nothing; intros b B'; split.
  - intro C; destruct (E b) as [[D _] _]; assert (L : in_box A (lo A)) by (intro j; specialize (wA j); lra).
    apply (D C (lo A) (He b B' _ L)); apply hull_contains; auto.
  - apply E; left; apply He; exact B'.
Qed.
End Exact.

(** ** Counterexamples

    Boxes with whole coordinates, and shafts between unit cubes on the X axis: both are [0, 1] in Y and Z, so that the
    shaft is its extent box, [l, h] in X. *)
Notation int := BinNums.Z.
Record zbox := ZBox { x0 : int; x1 : int; y0 : int; y1 : int; z0 : int; z1 : int }.
Definition real_of b := Box (fun i => IZR match i with X => x0 b | Y => y0 b | Z => z0 b end)
                            (fun i => IZR match i with X => x1 b | Y => y1 b | Z => z1 b end).
Definition cube x := ZBox x (x + 1) 0 1 0 1.
Definition meets b c := ((x0 b <=? x1 c) && (x0 c <=? x1 b) && (y0 b <=? y1 c) && (y0 c <=? y1 b) &&
                         (z0 b <=? z1 c) && (z0 c <=? z1 b))%Z.
Definition within b c := ((x0 c <=? x0 b) && (x1 b <=? x1 c) && (y0 c <=? y0 b) && (y1 b <=? y1 c) &&
                          (z0 c <=? z0 b) && (z1 b <=? z1 c))%Z.
Definition has_points b := ((x0 b <=? x1 b) && (y0 b <=? y1 b) && (z0 b <=? z1 b))%Z.
Definition shaft_of l h := ZBox l (h + 1) 0 1 0 1.
Definition tests_of l h : tests zbox := Tests
  (fun b => if has_points b && meets b (shaft_of l h) then if within b (shaft_of l h) then Inside else Overlap
            else Outside)
  (fun b => within (cube l) b || within (cube h) b).

Lemma shaft_is_a_box l h x : (l <= h)%Z ->
  (hull (real_of (cube l)) (real_of (cube h)) x <-> in_box (real_of (shaft_of l h)) x).
Proof.
  intro L; assert (LR := IZR_le _ _ L).
  assert (V : forall c, valid (real_of (cube c))) by (intros c []; simpl; rewrite ?plus_IZR; lra).
  rewrite hull_is_union_of_boxes by apply V; unfold in_box; simpl; split.
  - intros [s [Hs H]] i; specialize (H i); destruct i; simpl in *; unfold lerp in H; rewrite ?plus_IZR in *; nra.
  - intro H.
    assert (K : exists s, 0 <= s <= 1 /\ lerp s (IZR l) (IZR h) <= x X <= lerp s (IZR l) (IZR h) + 1).
    { assert (HX := H X); simpl in HX; rewrite plus_IZR in HX; unfold lerp.
      destruct (Rle_lt_dec (IZR h) (x X)) as [C|C]; [exists 1; lra|].
      exists ((x X - IZR l) / (IZR h - IZR l)); split; [|split]; try (right; field; lra).
      - split; [apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; lra]|].
        apply Rmult_le_reg_r with (IZR h - IZR l); [lra|].
        unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; lra.
      - replace ((1 - (x X - IZR l) / (IZR h - IZR l)) * IZR l + (x X - IZR l) / (IZR h - IZR l) * IZR h + 1)
          with (x X + 1) by (field; lra); lra. }
    destruct K as [s [Hs K]]; exists s; split; [exact Hs|].
    intro i; specialize (H i); destruct i; simpl in *; unfold lerp in *; rewrite ?plus_IZR in *; lra.
Qed.

Lemma meets_iff b c : has_points b = true -> has_points c = true ->
  (meets b c = true <-> exists x, in_box (real_of b) x /\ in_box (real_of c) x).
Proof.
  unfold has_points, meets; rewrite !andb_true_iff, !Z.leb_le; intros Pb Pc; split.
  - intro M; exists (fun i => IZR match i with X => Z.max (x0 b) (x0 c) | Y => Z.max (y0 b) (y0 c)
                                    | Z => Z.max (z0 b) (z0 c) end).
    split; intros []; simpl; split; apply IZR_le; lia.
  - intros [x [Hb Hc]]; assert (D : forall i, IZR (match i with X => x0 b | Y => y0 b | Z => z0 b end) <=
      IZR (match i with X => x1 c | Y => y1 c | Z => z1 c end) /\
      IZR (match i with X => x0 c | Y => y0 c | Z => z0 c end) <=
      IZR (match i with X => x1 b | Y => y1 b | Z => z1 b end)).
    { intro i; specialize (Hb i); specialize (Hc i); destruct i; simpl in *; lra. }
    destruct (D X) as [DX DX'], (D Y) as [DY DY'], (D Z) as [DZ DZ']; apply le_IZR in DX, DX', DY, DY', DZ, DZ'; lia.
Qed.
Lemma within_iff b c : has_points b = true ->
  (within b c = true <-> forall x, in_box (real_of b) x -> in_box (real_of c) x).
Proof.
  unfold has_points, within; rewrite !andb_true_iff, !Z.leb_le; intro Pb; split.
  - intros W x H i; specialize (H i); destruct i; simpl in *; destruct W as [[[[[W1 W2] W3] W4] W5] W6];
      apply IZR_le in W1, W2, W3, W4, W5, W6; lra.
  - intro H; assert (L : in_box (real_of c) (lo (real_of b))).
    { apply H; intros []; simpl; split; apply IZR_le; lia. }
    assert (U : in_box (real_of c) (hi (real_of b))).
    { apply H; intros []; simpl; split; apply IZR_le; lia. }
    destruct (L X) as [LX _], (L Y) as [LY _], (L Z) as [LZ _], (U X) as [_ UX], (U Y) as [_ UY], (U Z) as [_ UZ];
      apply le_IZR in LX, LY, LZ, UX, UY, UZ; simpl in *; lia.
Qed.
Lemma no_points b x : has_points b = false -> ~ in_box (real_of b) x.
Proof.
  intros P H; apply not_true_iff_false in P; apply P; unfold has_points; rewrite !andb_true_iff, !Z.leb_le.
  assert (A : forall i, lo (real_of b) i <= hi (real_of b) i) by (intro i; specialize (H i); lra).
  assert (AX := A X); assert (AY := A Y); assert (AZ := A Z); simpl in *; apply le_IZR in AX, AY, AZ; auto.
Qed.
Lemma cube_has_points c : has_points (cube c) = true.
Proof. unfold has_points; simpl; rewrite !andb_true_iff, !Z.leb_le; lia. Qed.

(** The tests are exact. *)
Lemma tests_are_exact l h : (l <= h)%Z -> exact real_of (real_of (cube l)) (real_of (cube h)) (tests_of l h).
Proof.
  intros L b; assert (S := shaft_is_a_box l h); unfold holds; simpl.
  assert (PS : has_points (shaft_of l h) = true).
  { unfold has_points; simpl; rewrite !andb_true_iff, !Z.leb_le; lia. }
  split; [|split].
  - destruct (has_points b) eqn:P; simpl.
    + destruct (meets b (shaft_of l h)) eqn:M.
      * apply meets_iff in M; auto; destruct M as [x [Hx Hs]]; destruct (within b _); (split; [discriminate|]);
          intro D; elim (D x Hx); apply S; assumption.
      * split; [|reflexivity]; intros _ x Hx Hs; apply S in Hs; [|exact L].
        apply not_true_iff_false in M; apply M; apply meets_iff; auto; exists x; auto.
    + split; [|reflexivity]; intros _ x Hx; elim (no_points b x P Hx).
  - destruct (has_points b) eqn:P; simpl.
    + split.
      * destruct (meets b (shaft_of l h)) eqn:M; [|discriminate]; destruct (within b _) eqn:W; [|discriminate].
        intros _; split.
        -- apply meets_iff in M; auto; destruct M as [x [Hx _]]; exists x; exact Hx.
        -- intros x Hx; apply S; [exact L|]; apply (proj1 (within_iff b _ P)); assumption.
      * intros [[x Hx] H].
        replace (meets b (shaft_of l h)) with true.
        -- replace (within b (shaft_of l h)) with true; [reflexivity|].
           symmetry; apply within_iff; [exact P|]; intros y Hy; apply S; auto.
        -- symmetry; apply meets_iff; auto; exists x; split; [exact Hx|]; apply S; auto.
    + split; [discriminate|]; intros [[x Hx] _]; elim (no_points b x P Hx).
  - rewrite orb_true_iff, !within_iff by apply cube_has_points; reflexivity.
Qed.

(** Emitter at 0, receiver at 8; [beside] leaves the shaft in Y. *)
Definition beside n x l h := Primitive n (ZBox x (x + 1) l h 0 1).
Definition at_cube n x := Primitive n (cube x).

(** S13 where the sub-shaft goes by another strategy, or another ratio: the parent opens the volume and drops primitive
    2; the sub-shaft, which may even be the parent itself, keeps it closed. *)
Definition two_strategies := Volume (ZBox 2 5 0 9 0 1) [beside 1 2 0 2; beside 2 4 8 9].
Theorem sub_shaft_by_another_strategy : exists t t' A B A' B', exact real_of A B t /\ exact real_of A' B' t' /\
  (forall y, in_box A' y -> in_box A y) /\ (forall y, in_box B' y -> in_box B y) /\
  below (candidates (Options OverlapOpen true true) t two_strategies) = [1%nat] /\
  below (candidates (Options KeepClosed true true) t' two_strategies) = [1%nat; 2%nat] /\
  below (candidates (Options (RatioOpen (1 # 2)) false false) t two_strategies) = [1%nat] /\
  below (candidates (Options (RatioOpen (2 # 5)) false false) t' two_strategies) = [1%nat; 2%nat].
Proof.
  exists (tests_of 0 8), (tests_of 0 8), (real_of (cube 0)), (real_of (cube 8)), (real_of (cube 0)), (real_of (cube 8)).
  split; [apply tests_are_exact; lia|split; [apply tests_are_exact; lia|]].
  split; [trivial|split; [trivial|repeat split; reflexivity]].
Qed.

(** S20 by items: one volume on the emitter list, which reaches out of the shaft as its two primitives do. *)
Definition one_volume := Volume (ZBox 2 5 0 3 0 1) [beside 1 2 0 2; beside 2 4 0 3].
Theorem opening_lengthens_the_list : exists t A B, exact real_of A B t /\ let e b := within (cube 0) b in
  length (emitter_list e one_volume) = 1%nat /\
  length (flat_map (candidates (Options OverlapOpen true true) t) (emitter_list e one_volume)) = 2%nat /\
  length (flat_map (candidates (Options AlwaysOpen true true) t) (emitter_list e one_volume)) = 2%nat /\
  length (flat_map (candidates (Options (RatioOpen 1) true true) t) (emitter_list e one_volume)) = 2%nat.
Proof.
  exists (tests_of 0 8), (real_of (cube 0)), (real_of (cube 8)); split; [apply tests_are_exact; lia|].
  repeat split; reflexivity.
Qed.
(** With the rule for enclosing volumes keep closed does so too: the volume encloses the receiver. *)
Definition around_the_receiver := Volume (ZBox 6 9 0 3 0 1) [beside 1 6 0 2; at_cube 2 8].
Theorem enclosing_lengthens_the_list : exists t A B, exact real_of A B t /\ let e b := within (cube 0) b in
  length (emitter_list e around_the_receiver) = 1%nat /\
  length (flat_map (candidates (Options KeepClosed true true) t) (emitter_list e around_the_receiver)) = 2%nat.
Proof.
  exists (tests_of 0 8), (real_of (cube 0)), (real_of (cube 8)); split; [apply tests_are_exact; lia|].
  split; reflexivity.
Qed.
