(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * What holds of candidate lists

    S12, S13, S16 and S20 of the paper's claims, and that the emitter list changes no candidate list. *)
Require Import List Bool Arith Lia ZArith QArith.
Require Import Gnomon.CandidateLists.
Import ListNotations.
Local Open Scope nat_scope.

Section Claims.
Context {bound : Type}.
Notation item := (item bound).
Notation tests := (tests bound).

Section Casting.
Context {point : Type}.
(** A bound's points, a primitive's points. *)
Variable holds : bound -> point -> Prop.
Variable shape : nat -> point -> Prop.

(** Every volume holds its children's, and every primitive's own box the primitive. *)
Inductive bounded : item -> Prop :=
| bounded_primitive n b : (forall x, shape n x -> holds b x) -> bounded (Primitive n b)
| bounded_volume b children :
    (forall c, In c children -> bounded c /\ forall x, holds (bound_of c) x -> holds b x) ->
    bounded (Volume b children).

Lemma bound_holds_primitives i p x : bounded i -> In p (primitives i) -> shape p x -> holds (bound_of i) x.
Proof.
  induction i as [n b|b children IH] using item_induction; intros W P S; inversion W as [n' b' H|b' c' H]; subst.
  - destruct P as [E|[]]; subst; auto.
  - simpl in P; apply in_flat_map in P; destruct P as [c [C P]]; destruct (H c C) as [Wc Hc]; apply Hc; auto.
Qed.

(** The shaft's points; what is classified as outside has none of them. *)
Variable shaft : point -> Prop.
Variable t : tests.
Hypothesis outside_misses : forall b x, classify t b = Outside -> holds b x -> shaft x -> False.

Lemma meeting_is_kept i x : holds (bound_of i) x -> shaft x -> kept t i = true.
Proof.
  intros H S; unfold kept; destruct (classify t (bound_of i)) eqn:E; try reflexivity.
  exfalso; apply (outside_misses (bound_of i) x); auto.
Qed.

(** No list loses a primitive that meets the shaft, marks or not. *)
Theorem every_list_is_sound o i p x : bounded i -> In p (primitives i) -> shape p x -> shaft x ->
  In p (below (candidates o t i)).
Proof.
  intros W P S X; induction i as [n b|b children IH] using item_induction; rewrite candidates_eq;
    (rewrite (meeting_is_kept _ x); [|eapply bound_holds_primitives; eassumption|exact X]).
  - apply below_one; exact P.
  - simpl in P; apply in_flat_map in P; destruct P as [c [C P]].
    inversion W as [|b' c' H]; subst; destruct (H c C) as [Wc Hc].
    destruct (opens o t b children).
    + apply below_flat_map; exists c; auto.
    + apply below_one; simpl; apply in_flat_map; exists c; split; [|exact P].
      destruct (marks o t b); [|exact C]; apply filter_In; split; [exact C|].
      apply (meeting_is_kept c x); [apply (bound_holds_primitives c p x)|]; assumption.
Qed.

Lemma candidates_bounded o i : bounded i -> forall c, In c (candidates o t i) -> bounded c.
Proof.
  induction i as [n b|b children IH] using item_induction; intros W c; rewrite candidates_eq; destruct (kept t _);
    try (intros []; fail).
  - intros [E|[]]; subst; exact W.
  - inversion W as [|b' c' H]; subst; destruct (opens o t b children).
    + intro I; apply in_flat_map in I; destruct I as [d [D I]]; apply (IH d D); [apply H; exact D|exact I].
    + intros [E|[]]; subst; constructor; intros d D; apply H.
      destruct (marks o t b); [apply filter_In in D; tauto|exact D].
Qed.

(** A ray in the shaft. A hit is one; a volume may be said to be met when it is not, but not the other way. *)
Variable ray : point -> Prop.
Hypothesis ray_in_shaft : forall x, ray x -> shaft x.
Variable met : bound -> bool.
Variable hit : nat -> bool.
Hypothesis hit_right : forall p, hit p = true -> exists x, shape p x /\ ray x.
Hypothesis met_right : forall b x, holds b x -> ray x -> met b = true.

Lemma blocked_iff i : bounded i -> (blocked met hit i = true <-> exists p, In p (primitives i) /\ hit p = true).
Proof.
  induction i as [n b|b children IH] using item_induction; intro W; inversion W as [n' b' H|b' c' H]; subst; simpl;
    rewrite andb_true_iff; split.
  - intros [_ K]; exists n; auto.
  - intros [p [[E|[]] K]]; subst; split; [|exact K].
    destruct (hit_right p K) as [x [Sx Rx]]; apply (met_right b x); auto.
  - intros [_ K]; apply existsb_exists in K; destruct K as [c [C K]].
    apply IH in K; [|exact C|apply H; exact C]; destruct K as [p [P K]].
    exists p; split; [apply in_flat_map; exists c; auto|exact K].
  - intros [p [P K]]; destruct (hit_right p K) as [x [Sx Rx]].
    assert (P' := P); apply in_flat_map in P'; destruct P' as [c [C P']]; split.
    + apply (met_right b x); [|exact Rx]; apply H with c; [exact C|].
      apply (bound_holds_primitives c p x); auto; apply H; exact C.
    + apply existsb_exists; exists c; split; [exact C|]; apply IH; [exact C|apply H; exact C|exists p; auto].
Qed.

(** A list that loses nothing that meets the shaft, of primitives of the tree, answers as all of these do. *)
Lemma sound_lists_cast_alike (l : list item) (i : item) fuel : (forall c, In c l -> bounded c) ->
  (forall p, In p (below l) -> In p (primitives i)) ->
  (forall p x, In p (primitives i) -> shape p x -> shaft x -> In p (below l)) ->
  size_of l < fuel -> cast met hit fuel l = Some (existsb hit (primitives i)).
Proof.
  intros W S K F; rewrite cast_ends by exact F; f_equal; apply eq_true_iff_eq; rewrite !existsb_exists; split.
  - intros [c [C B]]; apply blocked_iff in B; [|apply W; exact C]; destruct B as [p [P H]].
    exists p; split; [|exact H]; apply S; apply in_below; exists c; auto.
  - intros [p [P H]]; destruct (hit_right p H) as [x [Sx Rx]].
    assert (B := K p x P Sx (ray_in_shaft x Rx)); apply in_below in B; destruct B as [c [C B]].
    exists c; split; [exact C|]; apply blocked_iff; [apply W; exact C|exists p; auto].
Qed.

(** S16: the ray's answer by any list is that of all primitives, *)
Theorem every_strategy_casts_alike o i fuel : bounded i -> size_of (candidates o t i) < fuel ->
  cast met hit fuel (candidates o t i) = Some (existsb hit (primitives i)).
Proof.
  intro W; apply sound_lists_cast_alike.
  - apply candidates_bounded; exact W.
  - apply below_candidates.
  - intros p x; apply every_list_is_sound; exact W.
Qed.
(** and that of the whole hierarchy. *)
Theorem the_hierarchy_casts_alike i fuel : bounded i -> size_of [i] < fuel ->
  cast met hit fuel [i] = Some (existsb hit (primitives i)).
Proof.
  intros W F; rewrite cast_ends by exact F; f_equal; apply eq_true_iff_eq.
  simpl; rewrite orb_false_r, blocked_iff by exact W; rewrite existsb_exists; reflexivity.
Qed.
End Casting.

(** ** S12 *)

Lemma filter_shorter {T} (f : T -> bool) l : length (filter f l) <= length l.
Proof. induction l as [|x l IH]; [reflexivity|]; simpl; destruct (f x); simpl; lia. Qed.

(** A ratio of one or more opens every overlapping volume, as overlap open does, however volumes are classified and
    whatever the other options are. *)
Theorem ratio_one_is_overlap_open r s m m' (t : tests) (i : item) : (1 <= r)%Q ->
  candidates (Options (RatioOpen r) s m) t i = candidates (Options OverlapOpen s m') t i.
Proof.
  intro R; induction i as [n b|b children IH] using item_induction; rewrite !candidates_eq; destruct (kept t _) eqn:K;
    try reflexivity.
  assert (F : few r t children = true).
  { unfold few; apply Qle_bool_iff; unfold count.
    apply Qle_trans with (1 * inject_Z (Z.of_nat (length children)))%Q.
    - rewrite Qmult_1_l; rewrite <- Zle_Qle; apply Nat2Z.inj_le; apply filter_shorter.
    - apply Qmult_le_compat_r; [exact R|]; change 0%Q with (inject_Z 0); rewrite <- Zle_Qle; lia. }
  unfold opens, marks; cbn [chosen single mailbox]; rewrite F, !andb_true_r, andb_false_r.
  destruct (encloses t b || is_overlap (classify t b)) eqn:E.
  - rewrite !flat_map_concat_map; f_equal; apply map_ext_in; exact IH.
  - apply orb_false_iff in E; destruct E as [_ E]; rewrite E, andb_false_r; reflexivity.
Qed.

(** No ratio below one does: a volume of two or more, all of them overlapping, stays closed. *)
Theorem ratio_below_one_is_not r s m m' (t : tests) (b : bound) :
  (r < 1)%Q -> classify t b = Overlap -> encloses t b = false ->
  exists i, candidates (Options (RatioOpen r) s m) t i <> candidates (Options OverlapOpen s m') t i.
Proof.
  intros R C E; exists (Volume b [Primitive 0 b; Primitive 1 b]).
  assert (K : forall n, kept t (Primitive n b) = true) by (intro n; unfold kept; simpl; rewrite C; reflexivity).
  assert (F : few r t [Primitive 0 b; Primitive 1 b] = false).
  { apply not_true_is_false; intro F; unfold few in F; apply Qle_bool_iff in F; simpl in F; rewrite !K in F.
    unfold count in F; simpl in F; change (inject_Z 2) with (2#1) in F.
    apply (Qlt_irrefl (2#1)); eapply Qle_lt_trans; [exact F|].
    setoid_replace (2#1) with (1 * (2#1))%Q at 2 by reflexivity; apply Qmult_lt_compat_r; [reflexivity|exact R]. }
  rewrite !candidates_eq; unfold kept at 1 3; simpl bound_of; rewrite C; unfold opens; rewrite E, C; cbn [chosen orb].
  rewrite F; simpl filter; rewrite !K; simpl; rewrite !andb_false_r.
  rewrite ?C; discriminate.
Qed.

(** ** S13 *)

Section Nested.
(** The tests of a shaft and of one within it. *)
Variable t t' : tests.
Hypothesis outside_too : forall b, classify t b = Outside -> classify t' b = Outside.
Hypothesis inside_already : forall b, classify t' b = Inside -> classify t b = Inside.
Hypothesis encloses_too : forall b, encloses t b = true -> encloses t' b = true.

Lemma kept_already i : kept t' i = true -> kept t i = true.
Proof.
  unfold kept; destruct (classify t (bound_of i)) eqn:E; try reflexivity.
  rewrite (outside_too _ E); trivial.
Qed.
Lemma filter_length_mono {T} (f g : T -> bool) l : (forall x, f x = true -> g x = true) ->
  length (filter f l) <= length (filter g l).
Proof.
  intro H; induction l as [|x l IH]; [reflexivity|]; simpl; specialize (H x).
  destruct (f x), (g x); simpl; try lia; discriminate H; reflexivity.
Qed.

(** What the parent's list opens, the sub-shaft's opens as well. *)
Lemma opened_too o b children : opens o t b children = true -> classify t' b <> Outside ->
  opens o t' b children = true.
Proof.
  unfold opens; intros H N.
  destruct (encloses t b) eqn:E; [rewrite (encloses_too _ E); reflexivity|].
  simpl in H; destruct (encloses t' b); [reflexivity|]; simpl.
  assert (L : is_overlap (classify t b) = true -> is_overlap (classify t' b) = true).
  { intro L; destruct (classify t' b) eqn:C; [elim N; reflexivity|reflexivity|].
    rewrite (inside_already _ C) in L; discriminate L. }
  assert (M := filter_length_mono (kept t') (kept t) children kept_already).
  destruct (chosen o) as [| | |r]; auto.
  apply andb_true_iff in H; destruct H as [H1 H2]; rewrite (L H1); simpl.
  apply orb_true_iff in H2; apply orb_true_iff; destruct H2 as [H2|H2]; [left|right].
  - unfold few in *; apply Qle_bool_iff in H2; apply Qle_bool_iff; eapply Qle_trans; [|exact H2].
    unfold count; rewrite <- Zle_Qle; lia.
  - apply andb_true_iff in H2; destruct H2 as [H2 H3]; rewrite H2; apply Nat.leb_le in H3; apply Nat.leb_le; lia.
Qed.

(** Primitives below the sub-shaft's candidates are below the parent's: one strategy, one set of options. *)
Theorem sub_shaft_within_parent o i p :
  In p (below (candidates o t' i)) -> In p (below (candidates o t i)).
Proof.
  induction i as [n b|b children IH] using item_induction; rewrite (candidates_eq o t'), (candidates_eq o t).
  - destruct (kept t' _) eqn:K'; [|intros []]; rewrite (kept_already _ K'); trivial.
  - destruct (kept t' _) eqn:K'; [|intros []]; rewrite (kept_already _ K').
    assert (N : classify t' b <> Outside) by (intro C; unfold kept in K'; simpl in K'; rewrite C in K'; discriminate).
    destruct (opens o t b children) eqn:O.
    + rewrite (opened_too o b children O N); intro H; apply below_flat_map in H; destruct H as [c [C H]].
      apply below_flat_map; exists c; auto.
    + assert (Q : In p (below (candidates o t' (Volume b children))) -> exists c, In c children /\
                    (marks o t b = true -> kept t c = true) /\ In p (primitives c)).
      { rewrite candidates_eq, K'; destruct (opens o t' b children).
        - intro H; apply below_flat_map in H; destruct H as [c [C H]]; exists c; split; [exact C|].
          assert (P := below_candidates o t' c p H); split; [|exact P]; intros _.
          rewrite candidates_eq in H; destruct (kept t' c) eqn:Kc; [apply kept_already; exact Kc|destruct H].
        - intro H; apply below_one in H; simpl in H; apply in_flat_map in H; destruct H as [c [C H]].
          exists c; destruct (marks o t' b) eqn:M.
          + apply filter_In in C; destruct C as [C Kc].
            split; [exact C|split; [intros _; apply kept_already; exact Kc|exact H]].
          + split; [exact C|split; [|exact H]]; intro Mt; exfalso.
            unfold marks in M, Mt; destruct (mailbox o); [|discriminate Mt]; simpl in M, Mt.
            destruct (chosen o); try discriminate Mt.
            destruct (classify t' b) eqn:C'; [apply N; reflexivity|discriminate M|].
            rewrite (inside_already _ C') in Mt; discriminate Mt. }
      rewrite candidates_eq, K' in Q; intro H; destruct (Q H) as [c [C [M P]]].
      apply below_one; simpl; apply in_flat_map; exists c; split; [|exact P].
      destruct (marks o t b); [apply filter_In; auto|exact C].
Qed.
End Nested.

(** Made from the parent's list, a sub-shaft's list is within it whatever the strategies and tests. *)
Theorem list_from_the_parents_within o o' t t' (i : item) p :
  In p (below (flat_map (candidates o' t') (candidates o t i))) -> In p (below (candidates o t i)).
Proof.
  intro H; apply below_flat_map in H; destruct H as [c [C H]]; apply in_below; exists c; split; [exact C|].
  apply (below_candidates o' t'); exact H.
Qed.
(** And it loses nothing that meets the sub-shaft. *)
Theorem list_from_the_parents_is_sound {point} (holds : bound -> point -> Prop) shape
    (shaft shaft' : point -> Prop) o o' t t' i p x :
  (forall b y, classify t b = Outside -> holds b y -> shaft y -> False) ->
  (forall b y, classify t' b = Outside -> holds b y -> shaft' y -> False) -> (forall y, shaft' y -> shaft y) ->
  bounded holds shape i -> In p (primitives i) -> shape p x -> shaft' x ->
  In p (below (flat_map (candidates o' t') (candidates o t i))).
Proof.
  intros H H' S W P Sx Sp.
  assert (B := every_list_is_sound holds shape shaft t H o i p x W P Sx (S x Sp)).
  apply in_below in B; destruct B as [c [C B]]; apply below_flat_map; exists c; split; [exact C|].
  apply (every_list_is_sound holds shape shaft' t' H' o' c p x); auto.
  apply (candidates_bounded holds shape t o i W c C).
Qed.

(** S16 for such a list: a ray of the sub-shaft is answered as by all primitives. *)
Theorem nested_lists_cast_alike {point} (holds : bound -> point -> Prop) shape (shaft shaft' ray : point -> Prop)
    o o' t t' met hit i fuel :
  (forall b y, classify t b = Outside -> holds b y -> shaft y -> False) ->
  (forall b y, classify t' b = Outside -> holds b y -> shaft' y -> False) -> (forall y, shaft' y -> shaft y) ->
  (forall y, ray y -> shaft' y) -> (forall p, hit p = true -> exists x, shape p x /\ ray x) ->
  (forall b x, holds b x -> ray x -> met b = true) -> bounded holds shape i ->
  size_of (flat_map (candidates o' t') (candidates o t i)) < fuel ->
  cast met hit fuel (flat_map (candidates o' t') (candidates o t i)) = Some (existsb hit (primitives i)).
Proof.
  intros H H' S R Hit Met W; apply sound_lists_cast_alike with holds shape shaft' ray; auto.
  - intros c C; apply in_flat_map in C; destruct C as [d [D C]].
    apply (candidates_bounded holds shape t' o' d); [|exact C]; apply (candidates_bounded holds shape t o i W d D).
  - intros p P; apply (below_candidates o t); apply (list_from_the_parents_within o o' t t'); exact P.
  - intros p x P Sx Sp; apply (list_from_the_parents_is_sound holds shape shaft shaft' o o' t t' i p x); auto.
Qed.

(** ** The emitter list, S20 *)

(** What encloses the emitter is opened in every shaft from it: its list is as good a start as the root. *)
Theorem emitter_list_changes_nothing o t (e : bound -> bool) i :
  (forall b, e b = true -> classify t b <> Outside /\ encloses t b = true) ->
  flat_map (candidates o t) (emitter_list e i) = candidates o t i.
Proof.
  intro H; induction i as [n b|b children IH] using item_induction; [apply app_nil_r|].
  cbn [emitter_list]; destruct (e b) eqn:E; [|apply app_nil_r].
  destruct (H b E) as [N C]; rewrite candidates_eq; unfold kept, opens; simpl bound_of; rewrite C; simpl.
  replace (match classify t b with Outside => false | _ => true end) with true by (destruct (classify t b); congruence).
  clear N C E; induction children as [|c rest IHr]; [reflexivity|]; simpl; rewrite flat_map_app; f_equal.
  - apply IH; left; reflexivity.
  - apply IHr; intros d D; apply IH; right; exact D.
Qed.

(** By primitives a list made from the emitter list is at most that list. *)
Theorem superstructured_within_emitter_list o t e (i : item) p :
  In p (below (flat_map (candidates o t) (emitter_list e i))) -> In p (below (emitter_list e i)).
Proof.
  intro H; apply below_flat_map in H; destruct H as [c [C H]]; apply in_below; exists c; split; [exact C|].
  apply (below_candidates o t); exact H.
Qed.
(** By items too, where no volume is opened. *)
Theorem superstructured_keep_closed_is_shorter s m t e (i : item) : (forall b, encloses t b = false) ->
  length (flat_map (candidates (Options KeepClosed s m) t) (emitter_list e i)) <= length (emitter_list e i).
Proof.
  intro H; induction (emitter_list e i) as [|c rest IH]; [reflexivity|].
  simpl flat_map; rewrite app_length; simpl length.
  assert (length (candidates (Options KeepClosed s m) t c) <= 1); [|lia].
  rewrite candidates_eq; destruct (kept t c); [|simpl; lia]; destruct c as [n b|b children]; [simpl; lia|].
  unfold opens; rewrite H; simpl; lia.
Qed.
End Claims.
