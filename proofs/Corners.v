(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * Near and far corners

    The corner of a box that comes first, or last, in the direction of a plane's normal is picked by the signs of the
    normal's components ([sign_picks_near_and_far_corner]); in the numbering of faces that the code uses, the near
    corner's coordinates are those of the faces (far + 3) mod 6 ([opposite_is_plus_three_mod_six],
    [corners_of_a_plane]). This is claim S5. The two corners' values differ by the box's extent along the normal,
    whatever the plane's offset ([far_is_near_plus_extent]): claim S8 for boxes. *)
Require Import Reals Lra Psatz List Bool Arith.
Require Import Gnomon.Boxes Gnomon.PlaneSet Gnomon.BoxTest.
Open Scope R_scope.

Definition near_corner (n : point) (T : box) : point := fun i => if Rlt_dec 0 (n i) then lo T i else hi T i.
Definition far_corner (n : point) (T : box) : point := fun i => if Rlt_dec 0 (n i) then hi T i else lo T i.

Theorem sign_picks_near_and_far_corner n T : valid T ->
  in_box T (near_corner n T) /\ in_box T (far_corner n T) /\
  forall x, in_box T x -> dot n (near_corner n T) <= dot n x <= dot n (far_corner n T).
Proof.
  intro wT; split; [|split].
  - intro i; unfold near_corner; specialize (wT i); destruct Rlt_dec; lra.
  - intro i; unfold far_corner; specialize (wT i); destruct Rlt_dec; lra.
  - intros x Hx; unfold dot.
    assert (K : forall i, n i * near_corner n T i <= n i * x i <= n i * far_corner n T i).
    { intro i; specialize (Hx i); unfold near_corner, far_corner; destruct Rlt_dec.
      - split; apply Rmult_le_compat_l; lra.
      - assert (- n i * x i <= - n i * hi T i) by (apply Rmult_le_compat_l; lra).
        assert (- n i * lo T i <= - n i * x i) by (apply Rmult_le_compat_l; lra); lra. }
    pose proof (K X); pose proof (K Y); pose proof (K Z); lra.
Qed.

(** ** The numbering: 0..2 are MIN_X, MIN_Y, MIN_Z, 3..5 are MAX_X, MAX_Y, MAX_Z. *)
Definition flip (s : side) : side := match s with MIN => MAX | MAX => MIN end.
Definition opposite (f : face) : face := (fst f, flip (snd f)).
Definition number (f : face) : nat :=
  match fst f with X => 0 | Y => 1 | Z => 2 end + match snd f with MIN => 0 | MAX => 3 end.

Theorem opposite_is_plus_three_mod_six f : number (opposite f) = ((number f + 3) mod 6)%nat.
Proof. destruct f as [[] []]; reflexivity. Qed.

(** For a plane of the shaft, with far faces f and g; the third coordinate is multiplied by 0. *)
Theorem corners_of_a_plane A B T f g : fst f <> fst g -> extreme A B f -> extreme B A g ->
  let n := normal (edge_plane A B f g) in
  far_corner n T (fst f) = coord T f /\ far_corner n T (fst g) = coord T g /\
  near_corner n T (fst f) = coord T (opposite f) /\ near_corner n T (fst g) = coord T (opposite g).
Proof.
  intros N Ef Eg n; destruct (plane_normal A B f g N Ef Eg) as [P [Q _]]; fold n in P, Q.
  unfold far_corner, near_corner.
  destruct f as [i []], g as [j []]; cbv [sgn coord opposite flip fst snd] in *;
  repeat destruct Rlt_dec; repeat split; lra.
Qed.

(** ** One evaluation is enough *)

(** The extent of the box along n: what its diameter 2 r is for a ball, for n of length 1. *)
Definition extent_along (n : point) (T : box) : R :=
  Rabs (n X) * (hi T X - lo T X) + Rabs (n Y) * (hi T Y - lo T Y) + Rabs (n Z) * (hi T Z - lo T Z).

Theorem far_is_near_plus_extent n T :
  dot n (far_corner n T) = dot n (near_corner n T) + extent_along n T.
Proof.
  assert (K : forall i, n i * far_corner n T i = n i * near_corner n T i + Rabs (n i) * (hi T i - lo T i)).
  { intro i; unfold far_corner, near_corner; destruct Rlt_dec;
    [rewrite Rabs_pos_eq by lra|rewrite Rabs_left1 by lra]; ring. }
  unfold dot, extent_along; rewrite !K; ring.
Qed.

(** Outside compares the near value with 0; inside the same value plus the extent. *)
Theorem inside_is_outside_plus_extent n d T : valid T ->
  let value := dot n (near_corner n T) - d in
  ((forall x, in_box T x -> dot n x > d) <-> value > 0) /\
  ((forall x, in_box T x -> dot n x <= d) <-> value + extent_along n T <= 0).
Proof.
  intros wT value; destruct (sign_picks_near_and_far_corner n T wT) as [I [J K]].
  pose proof (far_is_near_plus_extent n T) as E; unfold value; split; split; intro H.
  - specialize (H _ I); lra.
  - intros x Hx; specialize (K x Hx); lra.
  - specialize (H _ J); lra.
  - intros x Hx; specialize (K x Hx); lra.
Qed.
