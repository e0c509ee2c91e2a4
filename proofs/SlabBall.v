(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * The sphere test by slabs in s

    fast/slab_ball.cpp, step by step, in real numbers. The squared distance from c to the box (1-s)A + sB is a sum over
    its six sides of max(p + q s, 0)^2. Its kinks, -p / q, cut [0, 1] into pieces; on each the function is one
    quadratic, which is minimised. [least_squared_distance_is_the_least]: what comes out is the minimum over
    [0, 1]. [slab_ball_is_exact]: outside exactly when the ball misses the shaft, inside exactly when it lies in it. *)
Require Import Reals Lra Psatz List Bool Sorted.
Require Import Gnomon.Boxes Gnomon.PlaneSet Gnomon.BoxTest Gnomon.BallDistance Gnomon.BallAgainstPlane Gnomon.SlabBox.
Import ListNotations.
Open Scope R_scope.

(** p + q s, the signed distance by which c lies beyond one side of the moving box. *)
Record moving_side := Side { at_0 : R; speed : R }.
Definition at_s (m : moving_side) (s : R) : R := at_0 m + speed m * s.

Definition sum_over {T : Type} (f : T -> R) (l : list T) : R := fold_right (fun x y => f x + y) 0 l.
Definition squared_distance_of (sides : list moving_side) (s : R) : R :=
  sum_over (fun m => Rmax (at_s m s) 0 * Rmax (at_s m s) 0) sides.

Definition left_behind (middle : R) (m : moving_side) : bool := if Rlt_dec 0 (at_s m middle) then true else false.
Definition minimiser (sides : list moving_side) (from to : R) : R :=
  let middle := from + (to - from) / 2 in
  let active := filter (left_behind middle) sides in
  let pq := sum_over (fun m => at_0 m * speed m) active in
  let qq := sum_over (fun m => speed m * speed m) active in
  if Rlt_dec 0 qq then Rmin (Rmax (- pq / qq) from) to else from.

(** The kinks within (0, 1), sorted, between 0 and 1. A side that does not move has none: in C++ -p / 0 is infinite or
    NaN and fails the comparisons. *)
Fixpoint insert (s : R) (kinks : list R) : list R :=
  match kinks with
  | [] => [s]
  | k :: others => if Rle_dec k s then k :: insert s others else s :: k :: others
  end.
Definition add_kink (kinks : list R) (m : moving_side) : list R :=
  if Req_EM_T (speed m) 0 then kinks else
  let s := - at_0 m / speed m in
  if Rlt_dec 0 s then if Rlt_dec s 1 then insert s kinks else kinks else kinks.
Definition kinks_of (sides : list moving_side) : list R := fold_left add_kink sides [0; 1].

Fixpoint pieces (kinks : list R) : list (R * R) :=
  match kinks with
  | x :: ((y :: _) as others) => (x, y) :: pieces others
  | _ => []
  end.

Definition least_over_pieces (sides : list moving_side) : R :=
  fold_right (fun piece least => Rmin least (squared_distance_of sides (minimiser sides (fst piece) (snd piece))))
    (Rmin (squared_distance_of sides 0) (squared_distance_of sides 1)) (pieces (kinks_of sides)).

Definition sides_of (A B : box) (c : point) : list moving_side :=
  flat_map (fun i => [Side (lo A i - c i) (lo B i - lo A i); Side (c i - hi A i) (hi A i - hi B i)]) [X; Y; Z].
Definition least_squared_distance (A B : box) (c : point) : R := least_over_pieces (sides_of A B c).

(** ** The kinks are sorted, contain all that matter, and pieces between neighbours cover [0, 1] *)
Lemma insert_in s l x : In x (insert s l) <-> x = s \/ In x l.
Proof.
  induction l as [|k l IH]; simpl; [intuition|].
  destruct Rle_dec; simpl; rewrite ?IH; intuition.
Qed.
Lemma insert_sorted s l : StronglySorted Rle l -> StronglySorted Rle (insert s l).
Proof.
  induction 1 as [|k l S IH M]; simpl; [repeat constructor|].
  rewrite Forall_forall in M; destruct Rle_dec as [L|L].
  - constructor; [exact IH|]; apply Forall_forall; intros x I; apply insert_in in I; destruct I as [->|I]; auto.
  - constructor; [constructor; [exact S|apply Forall_forall; exact M]|].
    apply Forall_forall; intros x [<-|I]; [lra|]; specialize (M x I); lra.
Qed.

Definition good_kinks (l : list R) : Prop :=
  StronglySorted Rle l /\ In 0 l /\ In 1 l /\ forall x, In x l -> 0 <= x <= 1.
Lemma add_kink_keeps l m : good_kinks l -> good_kinks (add_kink l m) /\ (forall x, In x l -> In x (add_kink l m)) /\
  (speed m <> 0 -> 0 < - at_0 m / speed m < 1 -> In (- at_0 m / speed m) (add_kink l m)).
Proof.
  intros [S [I0 [I1 R01]]]; unfold add_kink.
  destruct Req_EM_T as [Q|Q]; [repeat split; auto; try apply R01; auto; tauto|].
  set (s := - at_0 m / speed m); destruct Rlt_dec as [P|P]; [destruct Rlt_dec as [P'|P']|];
  try (repeat split; auto; try apply R01; auto; intros; lra).
  split; [split; [apply insert_sorted, S|]|split].
  - repeat split; try (apply insert_in; auto); apply insert_in in H; destruct H as [->|H]; try lra; apply R01, H.
  - intros x I; apply insert_in; auto.
  - intros _ _; apply insert_in; auto.
Qed.
Lemma kinks_are_good sides : good_kinks (kinks_of sides) /\
  forall m, In m sides -> speed m <> 0 -> 0 < - at_0 m / speed m < 1 -> In (- at_0 m / speed m) (kinks_of sides).
Proof.
  unfold kinks_of.
  assert (G : good_kinks [0; 1]).
  { split; [repeat constructor; lra|]; simpl; repeat split; auto; destruct H as [<-|[<-|[]]]; lra. }
  revert G; generalize [0; 1]; induction sides as [|m sides IH]; intros l G.
  - split; [exact G|intros ? []].
  - destruct (add_kink_keeps l m G) as [G' [K N]]; destruct (IH _ G') as [GF KF]; simpl; split; [exact GF|].
    intros m' [<-|I] Q P; [|apply KF; auto].
    specialize (N Q P); clear - N; revert N; generalize (add_kink l m); generalize (- at_0 m / speed m).
    induction sides as [|m' sides IH]; intros s l' N; simpl; [exact N|apply IH].
    unfold add_kink; destruct Req_EM_T; [exact N|].
    destruct Rlt_dec; [destruct Rlt_dec; [apply insert_in; auto|exact N]|exact N].
Qed.

(** No kink lies strictly within the piece. *)
Lemma piece_around l : forall x s, StronglySorted Rle (x :: l) -> x <= s -> (exists y, In y l /\ s <= y) ->
  exists a b, In (a, b) (pieces (x :: l)) /\ x <= a <= s /\ s <= b /\ forall k, In k (x :: l) -> k <= a \/ b <= k.
Proof.
  induction l as [|y l IH]; intros x s S L [z [I Lz]]; [destruct I|].
  inversion S as [|? ? S' M]; subst; rewrite Forall_forall in M.
  destruct (Rle_lt_dec s y) as [C|C].
  - exists x, y; repeat split; auto; try lra; [left; reflexivity|].
    inversion S' as [|? ? _ M']; subst; rewrite Forall_forall in M'.
    intros k [<-|[<-|K]]; [left; lra|right; lra|right; auto].
  - destruct (IH y s S') as [a [b [P [La [Lb K]]]]]; [lra| |].
    { destruct I as [<-|I]; [lra|exists z; auto]. }
    assert (x <= y) by (apply M; left; reflexivity).
    exists a, b; repeat split; try lra; [right; exact P|].
    intros k [<-|I']; [left; lra|apply K, I'].
Qed.
Lemma pieces_from_list l : forall a b, In (a, b) (pieces l) -> In a l /\ In b l.
Proof.
  induction l as [|x [|y l] IH]; intros a b H; [destruct H|destruct H|].
  destruct H as [E|H]; [inversion E; subst; simpl; auto|].
  destruct (IH a b H); split; right; assumption.
Qed.

(** ** One piece *)
Lemma sign_within_piece m a b s : a <= s <= b ->
  (speed m <> 0 -> - at_0 m / speed m <= a \/ b <= - at_0 m / speed m) ->
  let middle := a + (b - a) / 2 in
  (0 < at_s m middle -> 0 <= at_s m s) /\ (at_s m middle <= 0 -> at_s m s <= 0).
Proof.
  intros Hs K middle; unfold at_s; destruct (Req_dec (speed m) 0) as [Q|Q].
  { rewrite Q; split; lra. }
  specialize (K Q); set (k := - at_0 m / speed m) in *.
  assert (E : forall t, at_0 m + speed m * t = speed m * (t - k)) by (intro t; unfold k; field; exact Q).
  rewrite !E; assert (Hm : a <= middle <= b) by (unfold middle; lra).
  assert (C : a = b \/ a < b) by lra.
  destruct C as [C|C]; [replace s with middle by (unfold middle; lra); lra|].
  assert (Hm' : a < middle < b) by (unfold middle; lra).
  destruct (Rlt_dec 0 (speed m)) as [P|P], K as [K|K]; split; intro H; try nra.
Qed.

Lemma quadratic_on_piece sides a b s : a <= s <= b ->
  (forall m, In m sides -> speed m <> 0 -> - at_0 m / speed m <= a \/ b <= - at_0 m / speed m) ->
  let active := filter (left_behind (a + (b - a) / 2)) sides in
  squared_distance_of sides s =
    sum_over (fun m => at_0 m * at_0 m) active + 2 * s * sum_over (fun m => at_0 m * speed m) active
    + s * s * sum_over (fun m => speed m * speed m) active.
Proof.
  intros Hs K; unfold squared_distance_of; induction sides as [|m sides IH]; simpl; [ring|].
  rewrite IH by (intros; apply K; [right|]; assumption); clear IH.
  destruct (sign_within_piece m a b s Hs (K m (or_introl eq_refl))) as [P Q].
  assert (B : left_behind (a + (b - a) / 2) m = true /\ 0 <= at_s m s \/
              left_behind (a + (b - a) / 2) m = false /\ at_s m s <= 0).
  { unfold left_behind; destruct Rlt_dec as [L|L]; [left; auto|right; split; [reflexivity|apply Q; lra]]. }
  destruct B as [[-> B]|[-> B]]; [rewrite Rmax_left by exact B; unfold at_s; simpl; ring|].
  rewrite Rmax_right by exact B; ring.
Qed.

Lemma sum_of_squares_nonneg {T : Type} (f : T -> R) l : 0 <= sum_over (fun x => f x * f x) l.
Proof. induction l as [|x l IH]; simpl; [lra|]; assert (0 <= f x * f x) by nra; lra. Qed.
Lemma nothing_moves l : sum_over (fun m => speed m * speed m) l = 0 -> sum_over (fun m => at_0 m * speed m) l = 0.
Proof.
  induction l as [|x l IH]; simpl; intro H; [reflexivity|].
  pose proof (sum_of_squares_nonneg speed l); assert (0 <= speed x * speed x) by nra.
  rewrite IH by lra; assert (Q : speed x = 0) by nra; rewrite Q; ring.
Qed.

Lemma minimiser_within sides a b : a <= b -> a <= minimiser sides a b <= b.
Proof.
  intro L; unfold minimiser; destruct Rlt_dec; [|lra].
  split; [apply Rmin_glb; [apply Rmax_r|exact L]|apply Rmin_r].
Qed.
Lemma minimiser_is_least sides a b s : a <= s <= b ->
  (forall m, In m sides -> speed m <> 0 -> - at_0 m / speed m <= a \/ b <= - at_0 m / speed m) ->
  squared_distance_of sides (minimiser sides a b) <= squared_distance_of sides s.
Proof.
  intros Hs K; assert (L : a <= b) by lra.
  rewrite (quadratic_on_piece sides a b s Hs K),
          (quadratic_on_piece sides a b _ (minimiser_within sides a b L) K).
  unfold minimiser; set (active := filter _ sides).
  pose proof (nothing_moves active) as N; pose proof (sum_of_squares_nonneg speed active) as Q0.
  set (pp := sum_over _ active); set (pq := sum_over (fun m => at_0 m * speed m) active) in *.
  set (qq := sum_over (fun m => speed m * speed m) active) in *.
  destruct Rlt_dec as [Q|Q]; [|rewrite N by lra; replace qq with 0 by lra; lra].
  set (v := - pq / qq); assert (E : pq = - (qq * v)) by (unfold v; field; lra); rewrite E.
  assert (M : (Rmin (Rmax v a) b - v) * (Rmin (Rmax v a) b - v) <= (s - v) * (s - v)).
  { clear - Hs; clearbody v; unfold Rmax; destruct (Rle_dec v a); unfold Rmin; destruct Rle_dec; try lra.
    - assert (0 <= (s - a) * (s - v + (a - v))) by (apply Rmult_le_pos; lra); lra.
    - pose proof (Rle_0_sqr (s - v)); unfold Rsqr in *; lra.
    - assert (0 <= (b - s) * (v - s + (v - b))) by (apply Rmult_le_pos; lra); lra. }
  set (t := Rmin (Rmax v a) b) in *.
  assert (qq * ((t - v) * (t - v)) <= qq * ((s - v) * (s - v))) by (apply Rmult_le_compat_l; lra); lra.
Qed.

(** ** All pieces together *)
Theorem least_over_pieces_is_the_least sides :
  (exists m, 0 <= m <= 1 /\ least_over_pieces sides = squared_distance_of sides m) /\
  forall s, 0 <= s <= 1 -> least_over_pieces sides <= squared_distance_of sides s.
Proof.
  unfold least_over_pieces; destruct (kinks_are_good sides) as [[S [I0 [I1 R01]]] K].
  set (f := fun piece least => Rmin least (squared_distance_of sides (minimiser sides (fst piece) (snd piece)))).
  set (start := Rmin (squared_distance_of sides 0) (squared_distance_of sides 1)); split.
  - assert (P : forall piece, In piece (pieces (kinks_of sides)) ->
              0 <= minimiser sides (fst piece) (snd piece) <= 1).
    { intros [a b] I; simpl; destruct (pieces_from_list _ _ _ I) as [Ia Ib].
      assert (L : a <= b).
      { clear - S I; induction (kinks_of sides) as [|x [|y l] IH]; try destruct I.
        - inversion H; subst; inversion S as [|? ? _ M]; subst; rewrite Forall_forall in M; apply M; left; reflexivity.
        - apply IH; [inversion S; assumption|assumption]. }
      pose proof (R01 a Ia); pose proof (R01 b Ib); pose proof (minimiser_within sides a b L); lra. }
    induction (pieces (kinks_of sides)) as [|piece l IH]; simpl.
    + unfold start, Rmin; destruct Rle_dec; [exists 0|exists 1]; split; auto; lra.
    + destruct IH as [m [Hm E]]; [intros p I; apply P; right; exact I|].
      unfold f at 1; rewrite E; unfold Rmin; destruct Rle_dec; [exists m; auto|].
      exists (minimiser sides (fst piece) (snd piece)); split; [apply P; left|]; reflexivity.
  - intros s Hs.
    assert (F : forall l, fold_right f start l <= start /\ forall a b, In (a, b) l ->
              fold_right f start l <= squared_distance_of sides (minimiser sides a b)).
    { induction l as [|p l [IH0 IH]]; simpl; [split; [lra|intros ? ? []]|].
      set (z := fold_right f start l) in *; unfold f.
      pose proof (Rmin_l z (squared_distance_of sides (minimiser sides (fst p) (snd p)))) as M1.
      pose proof (Rmin_r z (squared_distance_of sides (minimiser sides (fst p) (snd p)))) as M2.
      split; [lra|intros a b [->|I]]; [exact M2|specialize (IH a b I); lra]. }
    destruct (kinks_of sides) as [|x l] eqn:E; [destruct I0|].
    inversion S as [|? ? S' M]; subst; rewrite Forall_forall in M.
    assert (x0 : x = 0).
    { pose proof (R01 x (or_introl eq_refl)); destruct I0 as [->|I0]; [reflexivity|]; specialize (M 0 I0); lra. }
    destruct (piece_around l x s S) as [a [b [P [La [Lb N]]]]]; [lra| |].
    { destruct I1 as [C|I1]; [lra|exists 1; split; [exact I1|lra]]. }
    eapply Rle_trans; [apply (proj2 (F _) a b P)|].
    apply minimiser_is_least; [lra|intros m I Q].
    assert (H01 : 0 <= a /\ b <= 1).
    { destruct (pieces_from_list _ _ _ P) as [Ia Ib]; pose proof (R01 a Ia); pose proof (R01 b Ib); lra. }
    destruct (Rle_lt_dec (- at_0 m / speed m) 0) as [C|C]; [left; lra|].
    destruct (Rle_lt_dec 1 (- at_0 m / speed m)) as [D|D]; [right; lra|].
    apply N, K; auto.
Qed.

Lemma sides_of_is A B c s : valid A -> valid B -> 0 <= s <= 1 ->
  squared_distance_of (sides_of A B c) s = squared_distance_at A B c s.
Proof.
  intros wA wB Hs.
  assert (K : forall i, Rmax (lo A i - c i + (lo B i - lo A i) * s) 0 * Rmax (lo A i - c i + (lo B i - lo A i) * s) 0 +
     Rmax (c i - hi A i + (hi A i - hi B i) * s) 0 * Rmax (c i - hi A i + (hi A i - hi B i) * s) 0 =
     distance_to_interval (c i) (lerp s (lo A i) (lo B i)) (lerp s (hi A i) (hi B i)) ^ 2).
  { intro i; specialize (wA i); specialize (wB i).
    replace (lo A i - c i + (lo B i - lo A i) * s) with (lerp s (lo A i) (lo B i) - c i) by (unfold lerp; ring).
    replace (c i - hi A i + (hi A i - hi B i) * s) with (c i - lerp s (hi A i) (hi B i)) by (unfold lerp; ring).
    assert (L : lerp s (lo A i) (lo B i) <= lerp s (hi A i) (hi B i)) by (unfold lerp; nra).
    set (l := lerp s (lo A i) (lo B i)) in *; set (h := lerp s (hi A i) (hi B i)) in *.
    unfold distance_to_interval, Rmax; repeat destruct Rle_dec; nra. }
  unfold squared_distance_at, sum_over_axes; rewrite <- !K.
  unfold squared_distance_of, sides_of; simpl; unfold at_s; simpl; ring.
Qed.

Theorem least_squared_distance_is_the_least A B c : valid A -> valid B ->
  (exists m, 0 <= m <= 1 /\ least_squared_distance A B c = squared_distance_at A B c m) /\
  forall s, 0 <= s <= 1 -> least_squared_distance A B c <= squared_distance_at A B c s.
Proof.
  intros wA wB; destruct (least_over_pieces_is_the_least (sides_of A B c)) as [[m [Hm E]] L].
  split; [exists m; split; [exact Hm|]|intros s Hs]; rewrite <- sides_of_is by assumption; [exact E|apply L, Hs].
Qed.

(** ** classify_by_slabs of a ball *)
Definition within_sides (A B : box) (c : point) (r : R) : bool :=
  forallb (fun i => if Rle_dec r (c i - Rmin (lo A i) (lo B i)) then
                    if Rle_dec r (Rmax (hi A i) (hi B i) - c i) then true else false else false) [X; Y; Z].
Definition behind (c : point) (r : R) (p : plane) : bool :=
  let value := dot (normal p) c - offset p in
  if Rle_dec value 0 then if Rle_dec (r * r * dot (normal p) (normal p)) (value * value) then true else false else false.
Definition classify_ball_by_slabs (A B : box) (c : point) (r : R) : category :=
  if Rlt_dec (r * r) (least_squared_distance A B c) then outside
  else if within_sides A B c r && forallb (behind c r) (planes A B) then inside else overlap.

Lemma inside_is A B c r : valid A -> valid B -> 0 <= r ->
  (within_sides A B c r && forallb (behind c r) (planes A B) = true <-> forall x, in_ball c r x -> hull A B x).
Proof.
  intros wA wB Hr; rewrite ball_inside_test_is_exact, andb_true_iff by assumption.
  assert (L : forall p, behind c r p = true <-> dot (normal p) c - offset p <= - (r * length (normal p))).
  { intro p; rewrite behind_without_root by exact Hr; unfold behind; cbv zeta.
    destruct Rle_dec; [destruct Rle_dec|]; split; intro H; try discriminate; try reflexivity; try lra. }
  split; intros [H1 H2]; split.
  - unfold within_sides in H1; rewrite forallb_forall in H1; intro i.
    assert (I : In i [X; Y; Z]) by (destruct i; simpl; auto); specialize (H1 i I); cbv beta in H1.
    destruct Rle_dec; [destruct Rle_dec|]; try discriminate; lra.
  - intros f g N Ef Eg; destruct (proj2 (planes_are_the_papers A B (edge_plane A B f g))) as [q [I [Q1 Q2]]].
    { exists f, g; repeat split; auto. }
    rewrite forallb_forall in H2; specialize (H2 q I); apply L in H2; cbv zeta.
    unfold length, dot in *; rewrite !Q2, Q1 in H2; exact H2.
  - unfold within_sides; apply forallb_forall; intros i _; specialize (H1 i).
    destruct Rle_dec; [destruct Rle_dec; [reflexivity|lra]|lra].
  - apply forallb_forall; intros q I; apply L.
    destruct (proj1 (planes_are_the_papers A B q)) as [f [g [N [Ef [Eg [Q1 Q2]]]]]].
    { exists q; repeat split; auto. }
    specialize (H2 f g N Ef Eg); cbv zeta in H2; unfold length, dot in *; rewrite !Q2, Q1 in H2; exact H2.
Qed.

Theorem slab_ball_is_exact A B c r : valid A -> valid B -> 0 <= r ->
  match classify_ball_by_slabs A B c r with
  | outside => ~ exists x, hull A B x /\ in_ball c r x
  | inside => forall x, in_ball c r x -> hull A B x
  | overlap => (exists x, hull A B x /\ in_ball c r x) /\ ~ forall x, in_ball c r x -> hull A B x
  end.
Proof.
  intros wA wB Hr; unfold classify_ball_by_slabs, in_ball.
  pose proof (ball_meets_iff_some_s A B c (r ^ 2) wA wB) as M.
  destruct (least_squared_distance_is_the_least A B c wA wB) as [[m [Hm E]] L].
  destruct Rlt_dec as [O|O].
  - intro K; apply M in K; destruct K as [s [Hs K]]; specialize (L s Hs); lra.
  - pose proof (inside_is A B c r wA wB Hr) as I; unfold in_ball in I.
    destruct (_ && _); [apply I; reflexivity|split].
    + apply M; exists m; split; [exact Hm|lra].
    + intro K; apply I in K; discriminate.
Qed.
