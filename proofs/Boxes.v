(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * Boxes and the shaft between them

    A point is a function from the three axes to the reals; a box is two points; the shaft ([hull A B]) is the set
    of all points on segments from A to B. [hull_is_union_of_boxes] shows that it is the union of the boxes
    (1-s)A + sB, and three lemmas at the end that it is the convex hull: convex, around both boxes, least. *)
Require Import Reals Lra Psatz List Bool.
Import ListNotations.
Open Scope R_scope.

Inductive axis := X | Y | Z.
Inductive side := MIN | MAX.
Definition face := (axis * side)%type.
Definition axis_eqb (i j : axis) : bool :=
  match i, j with X, X | Y, Y | Z, Z => true | _, _ => false end.
Definition faces : list face := [(X,MIN);(X,MAX);(Y,MIN);(Y,MAX);(Z,MIN);(Z,MAX)].
Lemma every_face_listed f : In f faces.
Proof. destruct f as [[] []]; simpl; tauto. Qed.

Definition point := axis -> R.
Record box := Box { lo : point; hi : point }.
Definition valid (b : box) : Prop := forall i, lo b i <= hi b i.
Definition in_box (b : box) (x : point) : Prop := forall i, lo b i <= x i <= hi b i.

(** S = convex hull of A and B *)
Definition hull (A B : box) (x : point) : Prop :=
  exists s a b, 0 <= s <= 1 /\ in_box A a /\ in_box B b /\
                forall i, x i = (1 - s) * a i + s * b i.

(** coordinate of a face, and its outward sign *)
Definition coord (b : box) (f : face) : R :=
  match snd f with MIN => lo b (fst f) | MAX => hi b (fst f) end.
Definition sgn (f : face) : R := match snd f with MIN => -1 | MAX => 1 end.

Definition lerp (s a b : R) : R := (1 - s) * a + s * b.

Lemma finite_choice (P : axis -> R -> Prop) :
  (forall i, exists y, P i y) -> exists x : point, forall i, P i (x i).
Proof.
  intro H; destruct (H X) as [x hx], (H Y) as [y hy], (H Z) as [z hz].
  exists (fun i => match i with X => x | Y => y | Z => z end); intros []; assumption.
Qed.

Lemma segment_split s la ha lb hb x :
  0 <= s <= 1 -> la <= ha -> lb <= hb -> lerp s la lb <= x <= lerp s ha hb ->
  exists a b, la <= a <= ha /\ lb <= b <= hb /\ x = lerp s a b.
Proof.
  unfold lerp; intros Hs Ha Hb Hx.
  destruct (Rle_lt_dec (lerp s ha hb) (lerp s la lb)) as [E|E]; unfold lerp in E.
  - exists la, lb; lra.
  - set (w := (1 - s) * ha + s * hb - ((1 - s) * la + s * lb)).
    assert (Hw : 0 < w) by (unfold w; lra).
    set (t := (x - ((1 - s) * la + s * lb)) / w).
    assert (Et : t * w = x - ((1 - s) * la + s * lb)) by (unfold t; field; lra).
    assert (T0 : 0 <= t).
    { apply Rmult_le_reg_r with w; [exact Hw|]. rewrite Et; lra. }
    assert (T1 : t <= 1).
    { apply Rmult_le_reg_r with w; [exact Hw|]. rewrite Et; unfold w; lra. }
    exists (la + t * (ha - la)), (lb + t * (hb - lb)).
    split; [nra|split; [nra|]].
    replace x with (t * w + ((1 - s) * la + s * lb)) by (rewrite Et; ring).
    unfold w; ring.
Qed.

Theorem hull_is_union_of_boxes A B : valid A -> valid B -> forall x,
  hull A B x <-> exists s, 0 <= s <= 1 /\
    forall i, lerp s (lo A i) (lo B i) <= x i <= lerp s (hi A i) (hi B i).
Proof.
  intros wA wB x; split.
  - intros [s [a [b [Hs [Ha [Hb E]]]]]]; exists s; split; [exact Hs|].
    intro i; rewrite E; unfold lerp; specialize (Ha i); specialize (Hb i); nra.
  - intros [s [Hs H]].
    destruct (finite_choice (fun i a => exists b, lo A i <= a <= hi A i /\
                lo B i <= b <= hi B i /\ x i = lerp s a b)) as [a Ha].
    { intro i; apply segment_split; auto. }
    destruct (finite_choice (fun i b => lo A i <= a i <= hi A i /\
                lo B i <= b <= hi B i /\ x i = lerp s (a i) b) Ha) as [b Hb].
    exists s, a, b; repeat split; try apply Hs; try apply Hb.
Qed.

(** hull really is the convex hull: convex, contains A and B, least such *)
Lemma hull_convex A B x y w z : valid A -> valid B -> 0 <= w <= 1 -> hull A B x -> hull A B y ->
  (forall i, z i = lerp w (x i) (y i)) -> hull A B z.
Proof.
  intros wA wB Hw Hx Hy E.
  apply hull_is_union_of_boxes in Hx; auto; apply hull_is_union_of_boxes in Hy; auto; apply hull_is_union_of_boxes; auto.
  destruct Hx as [s [Hs Hx]], Hy as [t [Ht Hy]].
  exists (lerp w s t); split; [unfold lerp; nra|].
  intro i; rewrite E; specialize (Hx i); specialize (Hy i); unfold lerp in *.
  split.
  - apply Rle_trans with ((1-w)*((1 - s) * lo A i + s * lo B i) + w*((1 - t) * lo A i + t * lo B i)); [right; ring|].
    apply Rplus_le_compat; apply Rmult_le_compat_l; lra.
  - apply Rle_trans with ((1-w)*((1 - s) * hi A i + s * hi B i) + w*((1 - t) * hi A i + t * hi B i)); [|right; ring].
    apply Rplus_le_compat; apply Rmult_le_compat_l; lra.
Qed.
Lemma hull_contains A B x : valid A -> valid B -> in_box A x \/ in_box B x -> hull A B x.
Proof.
  intros wA wB [H|H]; apply hull_is_union_of_boxes; auto; [exists 0|exists 1]; split; try lra;
  intro i; specialize (H i); unfold lerp; lra.
Qed.
Lemma hull_least A B (C : point -> Prop) :
  (forall x y z w, 0 <= w <= 1 -> C x -> C y -> (forall i, z i = lerp w (x i) (y i)) -> C z) ->
  (forall x, in_box A x -> C x) -> (forall x, in_box B x -> C x) ->
  forall x, hull A B x -> C x.
Proof.
  intros cC hA hB x [s [a [b [Hs [Ha [Hb E]]]]]].
  apply (cC a b x s); auto.
Qed.
