(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * How many planes a shaft has

    The number of planes depends only on which box is the extreme one on each of the six faces: A, B or neither
    (a tie). That is 3^6 patterns, and Coq's kernel goes through all of them. *)
Require Import Reals Lra Psatz List Bool Arith Lia.
Require Import Gnomon.Boxes Gnomon.PlaneSet.
Import ListNotations.
Open Scope R_scope.

Definition crosses (w : face -> owner) (fg : face * face) : bool :=
  match w (fst fg), w (snd fg) with box_A, box_B | box_B, box_A => true | _, _ => false end.
Definition count_for (w : face -> owner) : nat := length (filter (crosses w) pairs).

Lemma plane_count_by_pattern A B : length (planes A B) = count_for (extreme_box A B).
Proof.
  unfold planes, count_for; induction pairs as [|[f g] l IH]; [reflexivity|].
  cbn [flat_map filter]; rewrite app_length, IH; unfold crosses, planes_of_pair; simpl fst; simpl snd.
  destruct (extreme_box A B f), (extreme_box A B g); reflexivity.
Qed.

Definition pattern (a b c d e f : owner) : face -> owner := fun k =>
  match k with (X,MIN) => a | (X,MAX) => b | (Y,MIN) => c | (Y,MAX) => d | (Z,MIN) => e | (Z,MAX) => f end.
Lemma count_for_pattern w : count_for w =
  count_for (pattern (w (X,MIN)) (w (X,MAX)) (w (Y,MIN)) (w (Y,MAX)) (w (Z,MIN)) (w (Z,MAX))).
Proof.
  unfold count_for; f_equal; apply filter_ext; intros [[[] []] [[] []]]; reflexivity.
Qed.
Definition for_all_owners (P : owner -> bool) : bool := P box_A && P box_B && P neither.
Lemma for_all_owners_spec P : for_all_owners P = true -> forall w, P w = true.
Proof. unfold for_all_owners; rewrite !andb_true_iff; intros [[? ?] ?] []; assumption. Qed.

Lemma npl_table_le8 :
  for_all_owners (fun a => for_all_owners (fun b => for_all_owners (fun c => for_all_owners (fun d => for_all_owners (fun e => for_all_owners (fun f =>
    Nat.leb (count_for (pattern a b c d e f)) 8)))))) = true.
Proof. vm_compute; reflexivity. Qed.

Theorem at_most_eight_planes A B : (length (planes A B) <= 8)%nat.
Proof.
  rewrite plane_count_by_pattern, count_for_pattern; apply Nat.leb_le.
  pose proof npl_table_le8 as H.
  repeat (match type of H with for_all_owners _ = true => eapply for_all_owners_spec in H; cbv beta in H end).
  exact H.
Qed.

(** 8 is reached *)
Definition exA : box := Box (fun i => match i with Z => -1 | _ => -2 end) (fun i => match i with Z => 1 | _ => 2 end).
Definition exB : box := Box (fun i => match i with Z => -2 | _ => -1 end) (fun i => match i with Z => 2 | _ => 1 end).
Theorem eight_planes_reached : valid exA /\ valid exB /\ length (planes exA exB) = 8%nat.
Proof.
  split; [intros []; simpl; lra|split; [intros []; simpl; lra|]].
  rewrite plane_count_by_pattern.
  assert (E : forall f, extreme_box exA exB f = match fst f with Z => box_B | _ => box_A end).
  { intros [[] []]; simpl fst; (apply extreme_box_A || apply extreme_box_B); cbv [extreme sgn coord fst snd]; simpl; lra. }
  rewrite count_for_pattern, !E; vm_compute; reflexivity.
Qed.

(** ** Which counts occur (claims S3 and S4)

    Without ties a shaft has 0, 4, 6 or 8 planes; with a tie 0 to 6, so never 7 in any case. *)
Definition count_is_one_of (allowed : list nat) (w : face -> owner) : bool :=
  existsb (Nat.eqb (count_for w)) allowed.
Definition no_tie_in (w : face -> owner) : bool :=
  forallb (fun f => match w f with neither => false | _ => true end) faces.

Lemma counts_by_enumeration :
  for_all_owners (fun a => for_all_owners (fun b => for_all_owners (fun c =>
  for_all_owners (fun d => for_all_owners (fun e => for_all_owners (fun f =>
    let w := pattern a b c d e f in
    if no_tie_in w then count_is_one_of [0; 4; 6; 8]%nat w
    else count_is_one_of [0; 1; 2; 3; 4; 5; 6]%nat w)))))) = true.
Proof. vm_compute; reflexivity. Qed.

Lemma no_tie_in_pattern w : no_tie_in w =
  no_tie_in (pattern (w (X,MIN)) (w (X,MAX)) (w (Y,MIN)) (w (Y,MAX)) (w (Z,MIN)) (w (Z,MAX))).
Proof. reflexivity. Qed.

Theorem possible_plane_counts A B :
  ((forall f, extreme A B f \/ extreme B A f) -> In (length (planes A B)) [0; 4; 6; 8]%nat) /\
  ((exists f, coord A f = coord B f) -> In (length (planes A B)) [0; 1; 2; 3; 4; 5; 6]%nat).
Proof.
  assert (K : forall l w, count_is_one_of l w = true -> In (count_for w) l).
  { intros l w H; apply existsb_exists in H; destruct H as [n [I E]]; apply Nat.eqb_eq in E; congruence. }
  pose proof counts_by_enumeration as H.
  set (w := extreme_box A B).
  eapply for_all_owners_spec with (w := w (X,MIN)) in H; cbv beta in H.
  eapply for_all_owners_spec with (w := w (X,MAX)) in H; cbv beta in H.
  eapply for_all_owners_spec with (w := w (Y,MIN)) in H; cbv beta in H.
  eapply for_all_owners_spec with (w := w (Y,MAX)) in H; cbv beta in H.
  eapply for_all_owners_spec with (w := w (Z,MIN)) in H; cbv beta in H.
  eapply for_all_owners_spec with (w := w (Z,MAX)) in H; cbv beta in H.
  cbv zeta in H; rewrite <- no_tie_in_pattern in H.
  rewrite plane_count_by_pattern, count_for_pattern; fold w; split.
  - intro N; apply K; replace (no_tie_in w) with true in H; [exact H|].
    symmetry; apply forallb_forall; intros f _; unfold w.
    destruct (N f) as [E|E]; [apply extreme_box_A in E|apply extreme_box_B in E]; rewrite E; reflexivity.
  - intros [f E]; apply K; replace (no_tie_in w) with false in H; [exact H|].
    symmetry; destruct (no_tie_in w) eqn:T; [exfalso|reflexivity].
    unfold no_tie_in in T; rewrite forallb_forall in T; specialize (T f (every_face_listed f)).
    unfold w in T; destruct (extreme_box A B f) eqn:W; try discriminate;
    [apply extreme_box_A in W|apply extreme_box_B in W]; unfold extreme in W; rewrite E in W; lra.
Qed.

(** No planes: exactly when one box lies within the other, or the boxes are equal on two of the three axes. *)
Definition within (A B : box) : Prop := forall i, lo B i <= lo A i /\ hi A i <= hi B i.
Definition equal_but_on (i : axis) (A B : box) : Prop :=
  forall j, j <> i -> lo A j = lo B j /\ hi A j = hi B j.

Lemma no_pair_crosses w : count_for w = 0%nat <->
  forall f g, fst f <> fst g -> w f = box_A -> w g <> box_B.
Proof.
  unfold count_for; split.
  - intros H f g N Ef Eg.
    assert (C : In (f, g) pairs \/ In (g, f) pairs).
    { destruct f as [[] []], g as [[] []]; simpl in N; try congruence; simpl; tauto. }
    apply length_zero_iff_nil in H.
    assert (K1 : crosses w (f, g) = true) by (unfold crosses; cbn [fst snd]; rewrite Ef, Eg; reflexivity).
    assert (K2 : crosses w (g, f) = true) by (unfold crosses; cbn [fst snd]; rewrite Ef, Eg; reflexivity).
    destruct C as [C|C]; [pose proof (proj2 (filter_In (crosses w) _ _) (conj C K1)) as I
                         |pose proof (proj2 (filter_In (crosses w) _ _) (conj C K2)) as I];
    rewrite H in I; destruct I.
  - intro H; apply length_zero_iff_nil.
    destruct (filter (crosses w) pairs) as [|[f g] l] eqn:E; [reflexivity|exfalso].
    assert (I : In (f, g) (filter (crosses w) pairs)) by (rewrite E; left; reflexivity).
    apply filter_In in I; destruct I as [I C].
    assert (N : fst f <> fst g).
    { simpl in I; repeat (destruct I as [I|I]; [inversion I; simpl; discriminate|]); destruct I. }
    unfold crosses in C; simpl fst in C; simpl snd in C.
    destruct (w f) eqn:Ef, (w g) eqn:Eg; try discriminate.
    + exact (H f g N Ef Eg).
    + exact (H g f (not_eq_sym N) Eg Ef).
Qed.

Theorem no_planes_exactly_when A B :
  planes A B = [] <-> within A B \/ within B A \/ exists i, equal_but_on i A B.
Proof.
  rewrite <- length_zero_iff_nil, plane_count_by_pattern, no_pair_crosses.
  assert (D : forall f, extreme A B f \/ extreme B A f \/ sgn f * coord A f = sgn f * coord B f)
    by (intro f; unfold extreme; lra).
  split.
  - intro H.
    assert (K : forall f g, fst f <> fst g -> extreme A B f -> extreme B A g -> False).
    { intros f g N Ef Eg; apply (H f g N); [apply extreme_box_A|apply extreme_box_B]; assumption. }
    assert (W : forall P Q, (forall f, ~ extreme P Q f) -> within P Q).
    { intros P Q n i; pose proof (n (i, MIN)) as n1; pose proof (n (i, MAX)) as n2.
      unfold extreme, sgn, coord, fst, snd in n1, n2; lra. }
    assert (F : forall P Q, (exists f, extreme P Q f) \/ (forall f, ~ extreme P Q f)).
    { intros P Q.
      assert (dec : forall f, {extreme P Q f} + {~ extreme P Q f}) by (intro; apply Rlt_dec).
      destruct (dec (X,MIN)); [left; eauto|]; destruct (dec (X,MAX)); [left; eauto|].
      destruct (dec (Y,MIN)); [left; eauto|]; destruct (dec (Y,MAX)); [left; eauto|].
      destruct (dec (Z,MIN)); [left; eauto|]; destruct (dec (Z,MAX)); [left; eauto|].
      right; intros [[] []]; assumption. }
    destruct (F A B) as [[f Ef]|NA]; [|left; apply W, NA].
    destruct (F B A) as [[g Eg]|NB]; [|right; left; apply W, NB].
    right; right; exists (fst f); intros j Nj.
    assert (fst f = fst g) as Efg.
    { destruct f as [[] sf], g as [[] sg']; simpl; try reflexivity; exfalso;
      eapply K; try eassumption; simpl; discriminate. }
    assert (T : forall s, sgn (j, s) * coord A (j, s) = sgn (j, s) * coord B (j, s)).
    { intro s; destruct (D (j, s)) as [E|[E|E]]; [exfalso|exfalso|exact E].
      - apply (K (j, s) g); auto; simpl; congruence.
      - apply (K f (j, s)); auto; simpl; congruence. }
    pose proof (T MIN) as T1; pose proof (T MAX) as T2; cbv [sgn coord fst snd] in T1, T2; lra.
  - intros H [i s] [j t] N Ef Eg; apply extreme_box_A in Ef; apply extreme_box_B in Eg.
    simpl in N; unfold extreme in *.
    destruct H as [H|[H|[k H]]].
    + specialize (H i); destruct s; cbv [sgn coord fst snd] in *; lra.
    + specialize (H j); destruct t; cbv [sgn coord fst snd] in *; lra.
    + assert (C : i <> k \/ j <> k) by (destruct i, j, k; try congruence; try (left; discriminate); right; discriminate).
      destruct C as [C|C]; specialize (H _ C); [destruct s|destruct t]; cbv [sgn coord fst snd] in *; lra.
Qed.
