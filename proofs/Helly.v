(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * Helly's theorem on the line

    Convex sets of real numbers (intervals, rays, points; open, closed or half open) that meet pairwise have a
    common point. This is what turns "some s satisfies all inequalities" into a test of pairs. *)
Require Import Reals Lra List.
Open Scope R_scope.

Definition convex_set (P : R -> Prop) : Prop :=
  forall x y z, P x -> P y -> x <= z <= y -> P z.

Lemma helly_three (P Q W : R -> Prop) :
  convex_set P -> convex_set Q -> convex_set W ->
  (exists s, P s /\ Q s) -> (exists s, P s /\ W s) -> (exists s, Q s /\ W s) ->
  exists s, P s /\ Q s /\ W s.
Proof.
  intros cP cQ cW [u [Pu Qu]] [v [Pv Wv]] [w [Qw Ww]].
  (* the median of u, v, w *)
  assert (M : exists m, (u <= m <= v \/ v <= m <= u) /\
                        (u <= m <= w \/ w <= m <= u) /\
                        (v <= m <= w \/ w <= m <= v)).
  { destruct (Rle_dec u v); destruct (Rle_dec v w); destruct (Rle_dec u w);
      solve [ exists u; lra | exists v; lra | exists w; lra ]. }
  destruct M as [m [[H|H] [[H'|H'] [H''|H'']]]]; exists m; repeat split; eauto.
Qed.

Theorem helly_on_the_line : forall (l : list (R -> Prop)) (P : R -> Prop),
  (exists s, P s) -> convex_set P -> (forall Q, In Q l -> convex_set Q) ->
  (forall Q, In Q l -> exists s, P s /\ Q s) ->
  (forall Q W, In Q l -> In W l -> exists s, Q s /\ W s) ->
  exists s, P s /\ forall Q, In Q l -> Q s.
Proof.
  induction l as [|Q l IH]; intros P nP cP cl PQ QW.
  - destruct nP as [s Ps]; exists s; split; [exact Ps | intros ? []].
  - destruct (IH (fun s => P s /\ Q s)) as [s [[Ps Qs] Hs]].
    + apply PQ; left; reflexivity.
    + intros x y z [Px Qx] [Py Qy] L; split.
      * exact (cP x y z Px Py L).
      * exact (cl Q (or_introl eq_refl) x y z Qx Qy L).
    + intros W i; apply cl; right; exact i.
    + intros W i.
      destruct (helly_three P Q W) as [s Hs]; auto using in_eq, in_cons.
      exists s; tauto.
    + intros W V i j; apply QW; right; assumption.
    + exists s; split; [exact Ps|].
      intros W [<-|i]; [exact Qs | exact (Hs W i)].
Qed.
