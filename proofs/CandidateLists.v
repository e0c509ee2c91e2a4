(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * Candidate lists

    The paper's four strategies, the emitter list, the rule for volumes that enclose a reference box, mailbox marks and
    the cast of a ray by a stack, as functions on trees of items with any number of children. Nothing is assumed of
    bounding volumes and of how they are classified but what each theorem names: what holds for any classification also
    holds for one that rounds. *)
Require Import List Bool Arith Lia ZArith QArith.
Import ListNotations.
Local Open Scope nat_scope.

Inductive category := Outside | Overlap | Inside.
(** Ratio open with the ratio of children, not outside, above which a volume stays closed. *)
Inductive strategy := KeepClosed | AlwaysOpen | OverlapOpen | RatioOpen (ratio : Q).
(** [single]: ratio open opens a volume with one child, or none, that is not outside, whatever the ratio; [mailbox]:
    where ratio open keeps an overlapping volume, its children that are outside are marked. *)
Record options := Options { chosen : strategy; single : bool; mailbox : bool }.

Section Trees.
Context {bound : Type}.

(** A primitive's bound is its own box. *)
Inductive item := Primitive (name : nat) (b : bound) | Volume (b : bound) (children : list item).
Definition bound_of i := match i with Primitive _ b => b | Volume b _ => b end.

Lemma item_induction (P : item -> Prop) : (forall n b, P (Primitive n b)) ->
  (forall b children, (forall c, In c children -> P c) -> P (Volume b children)) -> forall i, P i.
Proof.
  intros HP HV; fix self 1; intros [n b|b children]; [apply HP|apply HV].
  induction children as [|c rest IH]; [intros c []|].
  intros d [E|D]; [subst d; apply self|exact (IH d D)].
Qed.

Fixpoint primitives i : list nat :=
  match i with Primitive n _ => [n] | Volume _ children => flat_map primitives children end.
Definition below l := flat_map primitives l.

(** ** The lists *)

(** What a shaft says of volumes: the category, and whether one encloses a reference box (never, without that rule). *)
Record tests := Tests { classify : bound -> category; encloses : bound -> bool }.

Definition is_overlap c := match c with Overlap => true | _ => false end.
Definition kept t i := match classify t (bound_of i) with Outside => false | _ => true end.
Definition count (l : list item) : Q := inject_Z (Z.of_nat (length l)).
Definition few r t children : bool := Qle_bool (count (filter (kept t) children)) (r * count children).

Definition opens o t b children : bool :=
  encloses t b ||
  match chosen o with
  | KeepClosed => false
  | AlwaysOpen => true
  | OverlapOpen => is_overlap (classify t b)
  | RatioOpen r => is_overlap (classify t b) &&
                   (few r t children || (single o && (length (filter (kept t) children) <=? 1)))
  end.
Definition marks o t b : bool :=
  mailbox o && match chosen o with RatioOpen _ => is_overlap (classify t b) | _ => false end.

(** The list below one item; a volume with marks is written without the children that are marked. *)
Fixpoint candidates o t (i : item) : list item :=
  match classify t (bound_of i) with
  | Outside => []
  | _ => match i with
         | Primitive _ _ => [i]
         | Volume b children =>
             if opens o t b children then flat_map (candidates o t) children
             else [Volume b (if marks o t b then filter (kept t) children else children)]
         end
  end.

(** The emitter list: [e] tells what encloses the emitter's box. *)
Fixpoint emitter_list (e : bound -> bool) i : list item :=
  match i with
  | Volume b children => if e b then flat_map (emitter_list e) children else [i]
  | Primitive _ _ => [i]
  end.

Lemma candidates_eq o t i : candidates o t i =
  if kept t i then
    match i with
    | Primitive _ _ => [i]
    | Volume b children =>
        if opens o t b children then flat_map (candidates o t) children
        else [Volume b (if marks o t b then filter (kept t) children else children)]
    end
  else [].
Proof. unfold kept; destruct i; cbn [candidates bound_of]; destruct (classify t b); reflexivity. Qed.

Lemma below_app l m : below (l ++ m) = below l ++ below m.
Proof. apply flat_map_app. Qed.
Lemma in_below p l : In p (below l) <-> exists i, In i l /\ In p (primitives i).
Proof. apply in_flat_map. Qed.
Lemma below_flat_map p (f : item -> list item) l :
  In p (below (flat_map f l)) <-> exists i, In i l /\ In p (below (f i)).
Proof.
  rewrite in_below; split.
  - intros [i [I P]]; apply in_flat_map in I; destruct I as [j [J I]].
    exists j; split; [exact J|apply in_below; exists i; auto].
  - intros [j [J P]]; apply in_below in P; destruct P as [i [I P]].
    exists i; split; [apply in_flat_map; exists j; auto|exact P].
Qed.
Lemma below_one p i : In p (below [i]) <-> In p (primitives i).
Proof. unfold below; simpl; rewrite app_nil_r; reflexivity. Qed.

(** Only what is below an item can be below its candidates. *)
Lemma below_candidates o t i p : In p (below (candidates o t i)) -> In p (primitives i).
Proof.
  induction i as [n b|b children IH] using item_induction; rewrite candidates_eq;
    (destruct (kept t _); [|intros []]).
  - intro H; apply below_one in H; exact H.
  - destruct (opens o t b children); intro H.
    + apply below_flat_map in H; destruct H as [c [C H]]; apply in_flat_map; exists c; auto.
    + apply below_one in H; simpl in H; apply in_flat_map in H; destruct H as [c [C H]].
      apply in_flat_map; exists c; split; [|exact H].
      destruct (marks o t b); [apply filter_In in C; tauto|exact C].
Qed.

(** ** The ray by the stack *)

(** A ray tests the volume of each item, and what is in it when the volume is met. *)
Variable met : bound -> bool.
Variable hit : nat -> bool.
Fixpoint blocked i : bool :=
  match i with
  | Primitive n b => met b && hit n
  | Volume b children => met b && existsb blocked children
  end.
(** [None]: the fuel is used up. A volume that is met has its children pushed one after the other. *)
Fixpoint cast (fuel : nat) (stack : list item) : option bool :=
  match fuel, stack with
  | O, _ => None
  | S _, [] => Some false
  | S n, Primitive p b :: rest => if met b && hit p then Some true else cast n rest
  | S n, Volume b children :: rest => cast n (if met b then rev children ++ rest else rest)
  end.

Fixpoint size i : nat :=
  match i with Primitive _ _ => 1 | Volume _ children => S (list_sum (map size children)) end.
Definition size_of l := list_sum (map size l).

Lemma size_of_app l m : size_of (l ++ m) = size_of l + size_of m.
Proof. unfold size_of; rewrite map_app; apply list_sum_app. Qed.
Lemma size_of_rev l : size_of (rev l) = size_of l.
Proof.
  induction l as [|i l IH]; [reflexivity|]; simpl rev; rewrite size_of_app, IH; unfold size_of; simpl; lia.
Qed.
Lemma existsb_rev {T} (f : T -> bool) l : existsb f (rev l) = existsb f l.
Proof.
  induction l as [|x l IH]; [reflexivity|]; simpl rev; rewrite existsb_app, IH; simpl.
  rewrite orb_false_r; apply orb_comm.
Qed.

(** The stack ends, and a ray is blocked when an item of the list is. *)
Theorem cast_ends fuel stack : size_of stack < fuel -> cast fuel stack = Some (existsb blocked stack).
Proof.
  revert stack; induction fuel as [|n IH]; intros stack F; [lia|].
  destruct stack as [|[p b|b children] rest]; [reflexivity| |]; unfold size_of in F; simpl in F.
  - simpl; destruct (met b && hit p); [reflexivity|]; apply IH; unfold size_of; lia.
  - simpl; destruct (met b); simpl.
    + rewrite IH; [|rewrite size_of_app, size_of_rev; unfold size_of; lia].
      rewrite existsb_app, existsb_rev; reflexivity.
    + apply IH; unfold size_of; lia.
Qed.
End Trees.
Arguments item : clear implicits.
Arguments tests : clear implicits.
