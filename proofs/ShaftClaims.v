(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * Short claims about the shaft

    S1, S10, S11 and S19 of the paper's claims, each a few lines from what other files prove. *)
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
