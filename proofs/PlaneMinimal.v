(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * Which planes can be left out

    Of the box test: none ([every_plane_excludes_a_box_of_its_own]). The box that a plane alone excludes is the culled
    edge of the extent box, from end to end, and there is one plane for each culled edge ([one_plane_a_culled_edge]).

    Of the volume, almost none: leaving a plane out leaves the set of points as it was exactly when both boxes are
    flat, at different places, on the axis that the plane is parallel to ([plane_cuts_volume_exactly_when]). So claim
    S18 holds but for flat boxes, and claim S9 ("a plane may cut nothing from the volume and still be needed for
    boxes") is right about planes too: [plane_without_volume_but_needed]. The paper's Figure 4 is about a side of the
    extent box: [side_without_volume_but_needed]. *)
Require Import Reals Lra Psatz List Bool.
Require Import Gnomon.Boxes Gnomon.PlaneSet Gnomon.BoxTest Gnomon.Corners.
Import ListNotations.
Open Scope R_scope.

(** Signed value of the plane at x, outwards; its sign is that of the distance. *)
Definition value_of (A B : box) (f g : face) (x : point) : R :=
  dot (normal (edge_plane A B f g)) x - offset (edge_plane A B f g).

(** (p, q) makes a plane of the shaft, and another one than (f, g) does. *)
Definition other_plane (A B : box) (f g p q : face) : Prop :=
  fst p <> fst q /\ extreme A B p /\ extreme B A q /\ (p, q) <> (f, g).

(** Where the extent box ends on a face, outwards, and the edge of the extent box on two faces. *)
Definition extent_reach (A B : box) (f : face) : R := Rmax (reach A f) (reach B f).
Definition extent_edge (A B : box) (f g : face) : box :=
  Box (fun k => if axis_eqb k (fst f) then sgn f * extent_reach A B f else
                if axis_eqb k (fst g) then sgn g * extent_reach A B g else Rmin (lo A k) (lo B k))
      (fun k => if axis_eqb k (fst f) then sgn f * extent_reach A B f else
                if axis_eqb k (fst g) then sgn g * extent_reach A B g else Rmax (hi A k) (hi B k)).

(** The paper's culled edges: edges of the extent box that are no part of A's edge or of B's. *)
Definition culled_edge (A B : box) (f g : face) : Prop :=
  ~ (reach A f = extent_reach A B f /\ reach A g = extent_reach A B g) /\
  ~ (reach B f = extent_reach A B f /\ reach B g = extent_reach A B g).

Theorem one_plane_a_culled_edge A B f g :
  culled_edge A B f g <-> (extreme A B f /\ extreme B A g) \/ (extreme B A f /\ extreme A B g).
Proof.
  unfold culled_edge, extent_reach, extreme, Rmax; repeat destruct Rle_dec; split; intros; lra.
Qed.

Lemma value_from_a A B f g x : fst f <> fst g ->
  value_of A B f g x = (reach B g - reach A g) * (sgn f * x (fst f) - reach A f) +
                       (reach A f - reach B f) * (sgn g * x (fst g) - reach A g).
Proof. intro N; unfold value_of; rewrite dot_edge_plane, offset_edge_plane by auto; ring. Qed.
Lemma value_from_b A B f g x : fst f <> fst g ->
  value_of A B f g x = (reach B g - reach A g) * (sgn f * x (fst f) - reach B f) +
                       (reach A f - reach B f) * (sgn g * x (fst g) - reach B g).
Proof. intro N; unfold value_of; rewrite dot_edge_plane, offset_edge_plane by auto; ring. Qed.

Lemma width b i s : valid b -> 0 <= reach b (i, s) + reach b (i, flip s).
Proof. intro w; specialize (w i); destruct s; cbv [sgn coord flip fst snd]; lra. Qed.
Lemma sgn_flip i s : sgn (i, flip s) = - sgn (i, s).
Proof. destruct s; unfold sgn; simpl; ring. Qed.
Lemma side_cases s t : t = s \/ t = flip s.
Proof. destruct s, t; auto. Qed.

(** ** Boxes *)

(** T is the culled edge. It lies in the extent box, and every other plane has one of its points behind it. *)
Theorem every_plane_excludes_a_box_of_its_own A B f g :
  valid A -> valid B -> fst f <> fst g -> extreme A B f -> extreme B A g ->
  let T := extent_edge A B f g in
  valid T /\ (forall i, Rmin (lo A i) (lo B i) <= lo T i /\ hi T i <= Rmax (hi A i) (hi B i)) /\
  beyond (edge_plane A B f g) T /\
  forall p q, other_plane A B f g p q -> ~ beyond (edge_plane A B p q) T.
Proof.
  intros wA wB N Ef Eg T.
  assert (V : valid T).
  { intro k; unfold T, extent_edge; simpl; pose proof (wA k).
    pose proof (Rmin_l (lo A k) (lo B k)); pose proof (Rmax_l (hi A k) (hi B k)).
    destruct axis_eqb; [lra|]; destruct axis_eqb; lra. }
  assert (Rf : extent_reach A B f = reach A f) by (apply Rmax_left; unfold extreme in Ef; lra).
  assert (Rg : extent_reach A B g = reach B g) by (apply Rmax_right; unfold extreme in Eg; lra).
  (* near sides of T on the six faces *)
  assert (nf : near_reach T f = reach A f).
  { rewrite <- Rf; unfold T, extent_edge, near_reach; destruct f as [i s], g as [j t]; simpl in N.
    destruct s; simpl; destruct i; simpl; unfold sgn; simpl; ring. }
  assert (ng : near_reach T g = reach B g).
  { rewrite <- Rg; unfold T, extent_edge, near_reach; destruct f as [i s], g as [j t]; simpl in N.
    destruct t; simpl; destruct i, j; try congruence; simpl; unfold sgn; simpl; ring. }
  assert (nf' : near_reach T (opposite f) = - reach A f).
  { rewrite <- Rf; unfold T, extent_edge, near_reach, opposite; destruct f as [i s], g as [j t]; simpl in N.
    destruct s; simpl; destruct i; simpl; unfold sgn; simpl; ring. }
  assert (ng' : near_reach T (opposite g) = - reach B g).
  { rewrite <- Rg; unfold T, extent_edge, near_reach, opposite; destruct f as [i s], g as [j t]; simpl in N.
    destruct t; simpl; destruct i, j; try congruence; simpl; unfold sgn; simpl; ring. }
  assert (nk : forall h, fst h <> fst f -> fst h <> fst g ->
            near_reach T h <= reach A h /\ near_reach T h <= reach B h).
  { intros [k s] Nf Ng; unfold T, extent_edge, near_reach; simpl in *.
    pose proof (wA k); pose proof (wB k).
    pose proof (Rmin_l (lo A k) (lo B k)); pose proof (Rmin_r (lo A k) (lo B k)).
    pose proof (Rmax_l (hi A k) (hi B k)); pose proof (Rmax_r (hi A k) (hi B k)).
    assert (E : forall i, k <> i -> axis_eqb k i = false) by (intros i; destruct k, i; simpl; congruence).
    destruct s; rewrite !E by auto; unfold sgn, coord; simpl; lra. }
  split; [exact V|split; [|split]].
  - intro k; unfold T, extent_edge; simpl; pose proof (wA k); pose proof (wB k).
    pose proof (Rmin_l (lo A k) (lo B k)); pose proof (Rmin_r (lo A k) (lo B k)).
    pose proof (Rmax_l (hi A k) (hi B k)); pose proof (Rmax_r (hi A k) (hi B k)).
    assert (E : forall i, axis_eqb k i = true -> k = i) by (intros i; destruct k, i; simpl; congruence).
    destruct (axis_eqb k (fst f)) eqn:Kf; [|destruct (axis_eqb k (fst g)) eqn:Kg; [|lra]].
    + apply E in Kf; subst k; destruct f as [i []]; cbv [sgn coord fst snd] in *; lra.
    + apply E in Kg; subst k; destruct g as [i []]; cbv [sgn coord fst snd] in *; lra.
  - apply beyond_iff_near_corner; auto; rewrite nf, ng, offset_edge_plane; unfold extreme in *.
    assert (0 < (reach A f - reach B f) * (reach B g - reach A g)) by (apply Rmult_lt_0_compat; lra); lra.
  - intros p q [Npq [Ep [Eq D]]] O; apply beyond_iff_near_corner in O; auto.
    rewrite offset_edge_plane in O; unfold extreme in *.
    pose proof (width A (fst f) (snd f) wA) as WAf; pose proof (width A (fst g) (snd g) wA) as WAg.
    pose proof (width B (fst f) (snd f) wB) as WBf; pose proof (width B (fst g) (snd g) wB) as WBg.
    rewrite <- !surjective_pairing in WAf, WAg, WBf, WBg.
    fold (opposite f) in WAf, WBf; fold (opposite g) in WAg, WBg.
    (* how a face lies to f and g *)
    assert (C : forall h, h = f \/ h = opposite f \/ h = g \/ h = opposite g \/ (fst h <> fst f /\ fst h <> fst g)).
    { clear - N; intros h; destruct f as [[] []], g as [[] []], h as [[] []]; simpl in N; try congruence;
      cbv [opposite flip fst snd]; auto 6; right; right; right; right; split; discriminate. }
    (* a face of A, or of B, on which T's near side is no farther out than that box *)
    assert (LA : forall h, extreme A B h -> h <> f -> near_reach T h <= reach A h /\ near_reach T h <= reach B h).
    { intros h Eh Nh; unfold extreme in Eh; destruct (C h) as [->|[->|[->|[->|[? ?]]]]]; try congruence; try lra; auto.
      all: try (rewrite nf'); try (rewrite ng'); lra. }
    assert (LB : forall h, extreme B A h -> h <> g -> near_reach T h <= reach A h /\ near_reach T h <= reach B h).
    { intros h Eh Nh; unfold extreme in Eh; destruct (C h) as [->|[->|[->|[->|[? ?]]]]]; try congruence; try lra; auto.
      all: try (rewrite nf'); try (rewrite ng'); lra. }
    assert (dp : p = f \/ p <> f) by (destruct p as [[] []], f as [[] []]; (left; reflexivity) || (right; discriminate)).
    assert (dq : q = g \/ q <> g) by (destruct q as [[] []], g as [[] []]; (left; reflexivity) || (right; discriminate)).
    set (n0 := reach B q - reach A q) in *; set (n1 := reach A p - reach B p) in *.
    assert (n00 : 0 < n0) by (unfold n0; lra); assert (n10 : 0 < n1) by (unfold n1; lra).
    destruct dp as [->|dp].
    + assert (dq' : q <> g) by congruence; destruct (LB q Eq dq') as [L _]; rewrite nf in O.
      assert (n1 * near_reach T q <= n1 * reach A q) by (apply Rmult_le_compat_l; lra); lra.
    + destruct (LA p Ep dp) as [L L'].
      destruct dq as [->|dq].
      * rewrite ng in O.
        assert (n0 * near_reach T p <= n0 * reach B p) by (apply Rmult_le_compat_l; lra).
        assert (n0 * reach B p + n1 * reach B g = n0 * reach A p + n1 * reach A g) by (unfold n0, n1; ring); lra.
      * destruct (LB q Eq dq) as [M _].
        assert (n0 * near_reach T p <= n0 * reach A p) by (apply Rmult_le_compat_l; lra).
        assert (n1 * near_reach T q <= n1 * reach A q) by (apply Rmult_le_compat_l; lra); lra.
Qed.

(** ** Points *)

(** Both boxes are flat, at different places, on the axis that the plane of f and g is parallel to. *)
Definition flat_apart (A B : box) (f g : face) : Prop :=
  exists k, k <> fst f /\ k <> fst g /\ lo A k = hi A k /\ lo B k = hi B k /\ lo A k <> lo B k.

Lemma below_zero_when_small a b : exists e, 0 < e /\ forall e', 0 < e' <= e ->
  a < 0 \/ (a <= 0 /\ b <= 0) -> a + e' * b <= 0.
Proof.
  destruct (Rlt_dec a 0) as [H|H].
  - pose proof (Rabs_pos b); exists (- a / (Rabs b + 1)).
    assert (E : - a / (Rabs b + 1) * (Rabs b + 1) = - a) by (field; lra).
    split; [apply Rmult_lt_reg_r with (Rabs b + 1); lra|intros e' He _].
    assert (e' * Rabs b <= e' * (Rabs b + 1)) by (apply Rmult_le_compat_l; lra).
    assert (e' * (Rabs b + 1) <= - a / (Rabs b + 1) * (Rabs b + 1)) by (apply Rmult_le_compat_r; lra).
    assert (e' * b <= e' * Rabs b) by (apply Rmult_le_compat_l; [lra|apply Rle_abs]); lra.
  - exists 1; split; [lra|intros e' He [K|[K L]]]; [lra|].
    assert (0 <= e' * - b) by (apply Rmult_le_pos; lra); lra.
Qed.
Lemma small_for_every_face (Q : face -> R -> Prop) :
  (forall h, exists e, 0 < e /\ forall e', 0 < e' <= e -> Q h e') ->
  exists e, 0 < e /\ forall e', 0 < e' <= e -> forall h, Q h e'.
Proof.
  intro H.
  assert (L : forall l, exists e, 0 < e /\ forall e', 0 < e' <= e -> forall h, In h l -> Q h e').
  { induction l as [|h l [e [E K]]]; [exists 1; split; [lra|intros ? ? ? []]|].
    destruct (H h) as [d [D M]]; exists (Rmin d e); split; [apply Rmin_glb_lt; lra|].
    pose proof (Rmin_l d e); pose proof (Rmin_r d e).
    intros e' He h' [<-|I]; [apply M|apply K; [|exact I]]; lra. }
  destruct (L faces) as [e [E K]]; exists e; split; [exact E|].
  intros e' He h; apply K; auto using every_face_listed.
Qed.

Theorem plane_cuts_volume_exactly_when A B f g :
  valid A -> valid B -> fst f <> fst g -> extreme A B f -> extreme B A g ->
  ((exists x, in_extent A B x /\ value_of A B f g x > 0 /\
      forall p q, other_plane A B f g p q -> value_of A B p q x <= 0) <-> ~ flat_apart A B f g).
Proof.
  intros wA wB N Ef Eg; split.
  - (* the planes of f and g with the axis k leave nothing to cut *)
    intros [x [_ [V P]]] [k [Kf [Kg [FA [FB D]]]]].
    assert (O : forall s t, s = flip t -> extreme B A (k, s) -> extreme A B (k, t) -> False).
    { intros s t -> Es Et.
      assert (P1 : value_of A B f (k, flip t) x <= 0).
      { apply P; repeat split; simpl; auto; intro E; inversion E; subst; simpl in Kg; congruence. }
      assert (P2 : value_of A B (k, t) g x <= 0).
      { apply P; repeat split; simpl; auto; intro E; inversion E; subst; simpl in Kf; congruence. }
      rewrite value_from_a in V, P1, P2 by (simpl; auto); unfold extreme in *.
      assert (RA : reach A (k, flip t) = - reach A (k, t))
        by (clear - FA; destruct t; cbv [flip sgn coord fst snd]; lra).
      assert (RB : reach B (k, flip t) = - reach B (k, t))
        by (clear - FB; destruct t; cbv [flip sgn coord fst snd]; lra).
      rewrite RA, RB, sgn_flip in P1; simpl fst in *.
      set (a := reach A f) in *; set (b := reach B f) in *; set (c := reach A g) in *; set (d := reach B g) in *.
      set (v := reach A (k, t)) in *; set (w := reach B (k, t)) in *.
      set (X := sgn f * x (fst f)) in *; set (Y := sgn g * x (fst g)) in *; set (z := sgn (k, t) * x k) in *.
      replace (- sgn (k, t) * x k) with (- z) in P1 by (unfold z; ring).
      assert (0 < (v - w) * ((d - c) * (X - a) + (a - b) * (Y - c))) by (apply Rmult_lt_0_compat; lra).
      assert (0 <= (d - c) * - ((- w - - v) * (X - a) + (a - b) * (- z - - v)))
        by (apply Rmult_le_pos; lra).
      assert (0 <= (a - b) * - ((d - c) * (z - v) + (v - w) * (Y - c))) by (apply Rmult_le_pos; lra).
      lra. }
    apply D; destruct (Rtotal_order (lo A k) (lo B k)) as [L|[L|L]]; [|exact L|]; exfalso;
    [apply (O MAX MIN)|apply (O MIN MAX)]; auto; unfold extreme; cbv [sgn coord fst snd]; lra.
  - intro NF; unfold extreme in Ef, Eg.
    (* the middle of the plane's edge, moved out by e on both faces *)
    set (x := fun e k => if axis_eqb k (fst f) then sgn f * ((reach A f + reach B f) / 2 + e) else
                         if axis_eqb k (fst g) then sgn g * ((reach A g + reach B g) / 2 + e) else
                         (lo A k + hi A k + lo B k + hi B k) / 4).
    assert (S : forall h z, sgn h * (sgn h * z) = z)
      by (intros h z; rewrite <- Rmult_assoc, sgn_squared; ring).
    assert (xf : forall e, sgn f * x e (fst f) = (reach A f + reach B f) / 2 + e).
    { intro e; unfold x; replace (axis_eqb (fst f) (fst f)) with true by (destruct f as [[] ?]; reflexivity).
      apply S. }
    assert (xg : forall e, sgn g * x e (fst g) = (reach A g + reach B g) / 2 + e).
    { intro e; unfold x; replace (axis_eqb (fst g) (fst g)) with true by (destruct g as [[] ?]; reflexivity).
      replace (axis_eqb (fst g) (fst f)) with false by (destruct f as [[] ?], g as [[] ?]; simpl in *; congruence).
      apply S. }
    (* a face h: how far x is from the middle of A and B there *)
    assert (C : forall h, exists a b, (forall e, sgn h * x e (fst h) - (reach A h + reach B h) / 2 = a + e * b) /\
       a <= 0 /\
       ((h = f \/ h = g) /\ b = 1 \/
        (h = opposite f \/ h = opposite g) /\ b = -1 /\ a = - ((reach A h + reach A (opposite h) + reach B h + reach B (opposite h)) / 2) \/
        (fst h <> fst f /\ fst h <> fst g) /\ b = 0 /\ (extreme A B h \/ extreme B A h -> a < 0))).
    { intro h.
      pose proof (width A (fst h) (snd h) wA) as WA; pose proof (width B (fst h) (snd h) wB) as WB.
      rewrite <- surjective_pairing in WA, WB; fold (opposite h) in WA, WB.
      assert (M : h = f \/ h = opposite f \/ h = g \/ h = opposite g \/ (fst h <> fst f /\ fst h <> fst g)).
      { clear - N; destruct f as [[] []], g as [[] []], h as [[] []]; simpl in N; try congruence;
        cbv [opposite flip fst snd]; auto 6; right; right; right; right; split; discriminate. }
      assert (OO : forall k, opposite (opposite k) = k) by (intros [? []]; reflexivity).
      assert (SO : forall k, sgn (opposite k) = - sgn k) by (intros [? ?]; apply sgn_flip).
      destruct M as [->|[->|[->|[->|[Nf Ng]]]]].
      - exists 0, 1; split; [intro e; rewrite xf; ring|split; [lra|left; auto]].
      - exists (- ((reach A (opposite f) + reach A (opposite (opposite f)) + reach B (opposite f) +
                    reach B (opposite (opposite f))) / 2)), (-1).
        split; [intro e|split; [lra|right; left; auto]].
        pose proof (xf e) as K; rewrite OO; replace (sgn (opposite f) * x e (fst (opposite f))) with
          (- (sgn f * x e (fst f))) by (rewrite SO; simpl; ring); rewrite K; lra.
      - exists 0, 1; split; [intro e; rewrite xg; ring|split; [lra|left; auto]].
      - exists (- ((reach A (opposite g) + reach A (opposite (opposite g)) + reach B (opposite g) +
                    reach B (opposite (opposite g))) / 2)), (-1).
        split; [intro e|split; [lra|right; left; auto]].
        pose proof (xg e) as K; rewrite OO; replace (sgn (opposite g) * x e (fst (opposite g))) with
          (- (sgn g * x e (fst g))) by (rewrite SO; simpl; ring); rewrite K; lra.
      - exists (- ((reach A h + reach A (opposite h) + reach B h + reach B (opposite h)) / 4)), 0.
        split; [|split; [lra|right; right; split; [auto|split; [reflexivity|]]]].
        + intro e; unfold x.
          replace (axis_eqb (fst h) (fst f)) with false
            by (destruct f as [[] ?], h as [[] ?]; simpl in *; congruence).
          replace (axis_eqb (fst h) (fst g)) with false
            by (destruct g as [[] ?], h as [[] ?]; simpl in *; congruence).
          destruct h as [k []]; cbv [opposite flip sgn coord fst snd]; field.
        + intro E; apply Rnot_le_lt; intro L; apply NF; exists (fst h).
          unfold extreme in E; destruct h as [k []]; cbv [opposite flip sgn coord fst snd] in *;
          repeat split; auto; lra. }
    destruct (small_for_every_face (fun p e => forall q, other_plane A B f g p q -> value_of A B p q (x e) <= 0))
      as [e0 [E0 K0]].
    { intro p; destruct (small_for_every_face (fun q e => other_plane A B f g p q -> value_of A B p q (x e) <= 0))
        as [e [E K]]; [|exists e; auto].
      intro q; destruct (C p) as [a [b [H [L M]]]], (C q) as [a' [b' [H' [L' M']]]].
      set (n0 := reach B q - reach A q); set (n1 := reach A p - reach B p).
      destruct (below_zero_when_small (n0 * a + n1 * a') (n0 * b + n1 * b')) as [e [E K]].
      exists e; split; [exact E|intros e' He [Npq [Ep [Eq D]]]].
      assert (V : value_of A B p q (x e') = n0 * a + n1 * a' + e' * (n0 * b + n1 * b')).
      { replace (n0 * a + n1 * a' + e' * (n0 * b + n1 * b')) with (n0 * (a + e' * b) + n1 * (a' + e' * b')) by ring.
        rewrite <- H, <- H', value_from_a by auto; unfold n0, n1; field. }
      rewrite V; apply K; [exact He|clear V K E].
      unfold extreme in Ep, Eq.
      assert (n00 : 0 < n0) by (unfold n0; lra); assert (n10 : 0 < n1) by (unfold n1; lra).
      assert (Z0 : 0 <= n0 * - a) by (apply Rmult_le_pos; lra); assert (Z1 : 0 <= n1 * - a') by (apply Rmult_le_pos; lra).
      assert (ST : a < 0 \/ a' < 0 -> n0 * a + n1 * a' < 0 \/ n0 * a + n1 * a' <= 0 /\ n0 * b + n1 * b' <= 0).
      { intros [Q|Q]; left; [assert (0 < n0 * - a) by (apply Rmult_lt_0_compat; lra)
                            |assert (0 < n1 * - a') by (apply Rmult_lt_0_compat; lra)]; lra. }
      destruct M as [[Hp Bp]|[[Hp [Bp Ap]]|[Hp [Bp Ap]]]]; [| |apply ST; left; apply Ap; left; exact Ep].
      2: destruct M' as [[Hq Bq]|[[Hq [Bq Aq]]|[Hq [Bq Aq]]]]; [| |apply ST; right; apply Aq; right; exact Eq].
      1: destruct M' as [[Hq Bq]|[[Hq [Bq Aq]]|[Hq [Bq Aq]]]]; [| |apply ST; right; apply Aq; right; exact Eq].
      + exfalso; destruct Hp as [-> | ->]; [|lra]; destruct Hq as [-> | ->]; [lra|congruence].
      + apply ST; right; destruct Hp as [-> | ->]; [|lra].
        destruct Hq as [-> | ->]; [simpl in Npq; congruence|].
        assert (OO : opposite (opposite g) = g) by (destruct g as [? []]; reflexivity); rewrite OO in Aq.
        pose proof (width A (fst g) (snd g) wA) as WA; rewrite <- surjective_pairing in WA; fold (opposite g) in WA; lra.
      + apply ST; left; destruct Hq as [-> | ->]; [lra|].
        destruct Hp as [-> | ->]; [|simpl in Npq; congruence].
        assert (OO : opposite (opposite f) = f) by (destruct f as [? []]; reflexivity); rewrite OO in Ap.
        pose proof (width B (fst f) (snd f) wB) as WB; rewrite <- surjective_pairing in WB; fold (opposite f) in WB; lra.
      + right; subst b b'; lra. }
    set (e := Rmin e0 (Rmin ((reach A f - reach B f) / 2) ((reach B g - reach A g) / 2))).
    pose proof (Rmin_l e0 (Rmin ((reach A f - reach B f) / 2) ((reach B g - reach A g) / 2))) as e1.
    pose proof (Rmin_r e0 (Rmin ((reach A f - reach B f) / 2) ((reach B g - reach A g) / 2))) as e2.
    pose proof (Rmin_l ((reach A f - reach B f) / 2) ((reach B g - reach A g) / 2)) as e3.
    pose proof (Rmin_r ((reach A f - reach B f) / 2) ((reach B g - reach A g) / 2)) as e4.
    assert (e5 : 0 < e) by (unfold e; repeat apply Rmin_glb_lt; lra); fold e in e1, e2.
    assert (W : forall h, sgn h * x e (fst h) <= Rmax (reach A h) (reach B h)).
    { intro h; pose proof (Rmax_l (reach A h) (reach B h)); pose proof (Rmax_r (reach A h) (reach B h)).
      destruct (C h) as [a [b [H' [L M]]]]; specialize (H' e).
      destruct M as [[[-> | ->] _]|[[_ [-> _]]|[_ [-> _]]]]; [rewrite xf|rewrite xg| |]; lra. }
    exists (x e); split; [|split].
    + intro k; pose proof (W (k, MIN)) as W0; pose proof (W (k, MAX)) as W1; cbv [sgn coord fst snd] in W0, W1.
      rewrite !Rmult_1_l in W1; split; [|exact W1].
      unfold Rmin, Rmax in *; destruct (Rle_dec (lo A k) (lo B k)), (Rle_dec (-1 * lo A k) (-1 * lo B k)); lra.
    + rewrite value_from_a, xf, xg by auto.
      assert (0 < e * ((reach B g - reach A g) + (reach A f - reach B f))) by (apply Rmult_lt_0_compat; lra); lra.
    + intros p q; apply K0; lra.
Qed.

(** Two points: each of their six planes cuts nothing from the others, and each is needed for boxes. *)
Theorem plane_without_volume_but_needed :
  exists A B f g T, valid A /\ valid B /\ valid T /\ fst f <> fst g /\ extreme A B f /\ extreme B A g /\
    (forall x, in_extent A B x -> (forall p q, other_plane A B f g p q -> value_of A B p q x <= 0) ->
       value_of A B f g x <= 0) /\
    beyond (edge_plane A B f g) T /\ ~ beyond_extent A B T /\
    forall p q, other_plane A B f g p q -> ~ beyond (edge_plane A B p q) T.
Proof.
  set (A := Box (fun _ => 0) (fun _ => 0)); set (B := Box (fun _ => 1) (fun _ => 1)).
  assert (wA : valid A) by (intro; simpl; lra); assert (wB : valid B) by (intro; simpl; lra).
  assert (N : fst (X, MIN) <> fst (Y, MAX)) by (simpl; discriminate).
  assert (Ef : extreme A B (X, MIN)) by (unfold extreme, sgn, coord; simpl; lra).
  assert (Eg : extreme B A (Y, MAX)) by (unfold extreme, sgn, coord; simpl; lra).
  destruct (every_plane_excludes_a_box_of_its_own A B _ _ wA wB N Ef Eg) as [V [I [O P]]].
  exists A, B, (X, MIN), (Y, MAX), (extent_edge A B (X, MIN) (Y, MAX)); repeat split; auto.
  - intros x E Q; apply Rnot_lt_le; intro L.
    assert (F : ~ flat_apart A B (X, MIN) (Y, MAX)) by (apply plane_cuts_volume_exactly_when; auto; exists x; auto).
    apply F; exists Z; simpl; repeat split; try discriminate; lra.
  - intros [i D]; specialize (I i); specialize (V i); lra.
Qed.

(** ** Sides of the extent box

    None can be left out of the box test either: a large box just beyond a side is excluded by that side alone. *)
Lemma large_for_every_face (Q : face -> R -> Prop) :
  (forall h, exists m, forall m', m <= m' -> Q h m') -> exists m, forall m', m <= m' -> forall h, Q h m'.
Proof.
  intro H.
  assert (L : forall l, exists m, forall m', m <= m' -> forall h, In h l -> Q h m').
  { induction l as [|h l [e K]]; [exists 0; intros ? ? ? []|].
    destruct (H h) as [d M]; exists (Rmax d e); pose proof (Rmax_l d e); pose proof (Rmax_r d e).
    intros m' Hm h' [<-|I]; [apply M|apply K; [|exact I]]; lra. }
  destruct (L faces) as [m K]; exists m; intros m' Hm h; apply K; auto using every_face_listed.
Qed.

Theorem every_side_excludes_a_box_of_its_own A B f : valid A -> valid B ->
  exists T, valid T /\ near_reach T f > extent_reach A B f /\
    (forall h, h <> f -> near_reach T h <= extent_reach A B h) /\
    forall p q, fst p <> fst q -> extreme A B p -> extreme B A q -> ~ beyond (edge_plane A B p q) T.
Proof.
  intros wA wB.
  set (n0 := fun q => reach B q - reach A q); set (n1 := fun p => reach A p - reach B p).
  destruct (large_for_every_face (fun p m => forall q,
     extent_reach A B f + 1 <= m /\ n0 q / n1 p - reach A q <= m /\ n1 p / n0 q - reach B p <= m /\ - reach A p <= m))
     as [m K].
  { intro p; destruct (large_for_every_face (fun q m =>
      extent_reach A B f + 1 <= m /\ n0 q / n1 p - reach A q <= m /\ n1 p / n0 q - reach B p <= m /\ - reach A p <= m))
      as [m K]; [|exists m; auto].
    intro q; exists (Rmax (Rmax (extent_reach A B f + 1) (n0 q / n1 p - reach A q))
                         (Rmax (n1 p / n0 q - reach B p) (- reach A p))).
    intros m' Hm; repeat split; (eapply Rle_trans; [|exact Hm]).
    - eapply Rle_trans; [|apply Rmax_l]; apply Rmax_l.
    - eapply Rle_trans; [|apply Rmax_l]; apply Rmax_r.
    - eapply Rle_trans; [|apply Rmax_r]; apply Rmax_l.
    - eapply Rle_trans; [|apply Rmax_r]; apply Rmax_r. }
  specialize (K m (Rle_refl m)).
  set (r := extent_reach A B f + 1).
  set (T := Box (fun k => if axis_eqb k (fst f) then match snd f with MIN => - m | MAX => r end else - Rabs m)
                (fun k => if axis_eqb k (fst f) then match snd f with MIN => - r | MAX => m end else Rabs m)).
  assert (Hr : r <= m) by apply (K (X, MIN) (X, MIN)).
  assert (nf : near_reach T f = r) by (unfold T, near_reach; destruct f as [[] []]; simpl; ring).
  assert (nh : forall h, h <> f -> near_reach T h <= - m).
  { intros [i s] D; pose proof (Rle_abs m).
    unfold T, near_reach; destruct f as [[] []], i, s; try congruence; simpl; lra. }
  assert (V : valid T).
  { intro k; unfold T; simpl; pose proof (Rabs_pos m); destruct axis_eqb; [destruct (snd f)|]; lra. }
  exists T; split; [exact V|split; [rewrite nf; unfold r; lra|split]].
  - intros h D; pose proof (nh h D); pose proof (K h h); unfold extent_reach.
    pose proof (Rmax_l (reach A h) (reach B h)); lra.
  - intros p q N Ep Eq O; apply beyond_iff_near_corner in O; auto; rewrite offset_edge_plane in O.
    unfold extreme in *; destruct (K p q) as [_ [K1 [K2 K3]]]; pose proof (K q q) as [_ [_ [_ K4]]].
    assert (P0 : 0 < n0 q) by (unfold n0; lra); assert (P1 : 0 < n1 p) by (unfold n1; lra).
    fold (n0 q) (n1 p) in O.
    assert (D1 : n1 p * (n0 q / n1 p) = n0 q) by (field; lra).
    assert (D0 : n0 q * (n1 p / n0 q) = n1 p) by (field; lra).
    assert (dp : p = f \/ p <> f) by (destruct p as [[] []], f as [[] []]; (left; reflexivity) || (right; discriminate)).
    assert (dq : q = f \/ q <> f) by (destruct q as [[] []], f as [[] []]; (left; reflexivity) || (right; discriminate)).
    destruct dp as [->|dp]; [|destruct dq as [->|dq]].
    + pose proof (nh q ltac:(congruence)).
      assert (E : r = reach A f + 1) by (unfold r, extent_reach; rewrite Rmax_left; lra).
      rewrite nf, E in O.
      assert (n1 f * near_reach T q <= n1 f * (reach A q - n0 q / n1 f)) by (apply Rmult_le_compat_l; lra); lra.
    + pose proof (nh p dp).
      assert (E : r = reach B f + 1) by (unfold r, extent_reach; rewrite Rmax_right; lra).
      rewrite nf, E in O.
      assert (n0 f * near_reach T p <= n0 f * (reach B p - n1 p / n0 f)) by (apply Rmult_le_compat_l; lra).
      assert (n0 f * reach A p + n1 p * reach A f = n0 f * reach B p + n1 p * reach B f) by (unfold n0, n1; ring); lra.
    + pose proof (nh p dp); pose proof (nh q dq).
      assert (n0 q * near_reach T p <= n0 q * reach A p) by (apply Rmult_le_compat_l; lra).
      assert (n1 p * near_reach T q <= n1 p * reach A q) by (apply Rmult_le_compat_l; lra); lra.
Qed.

(** Figure 4: a point light above a rectangle. The side MAX_Y of the extent box follows from two of the planes, for
    points; by the theorem above it is needed for boxes. *)
Theorem side_without_volume_but_needed :
  exists A B f T, valid A /\ valid B /\ valid T /\
    (forall x, (forall p q, fst p <> fst q -> extreme A B p -> extreme B A q -> value_of A B p q x <= 0) ->
       sgn f * x (fst f) <= extent_reach A B f) /\
    near_reach T f > extent_reach A B f /\
    (forall h, h <> f -> near_reach T h <= extent_reach A B h) /\
    forall p q, fst p <> fst q -> extreme A B p -> extreme B A q -> ~ beyond (edge_plane A B p q) T.
Proof.
  set (A := Box (fun k => match k with Y => 1 | _ => 0 end) (fun k => match k with Y => 1 | _ => 0 end)).
  set (B := Box (fun k => match k with Y => 0 | _ => -1 end) (fun k => match k with Y => 0 | _ => 1 end)).
  assert (wA : valid A) by (intros []; simpl; lra); assert (wB : valid B) by (intros []; simpl; lra).
  destruct (every_side_excludes_a_box_of_its_own A B (Y, MAX) wA wB) as [T [V [O [H P]]]].
  exists A, B, (Y, MAX), T; repeat split; auto.
  intros x Q.
  assert (E : extreme A B (Y, MAX)) by (unfold extreme, sgn, coord; simpl; lra).
  assert (E0 : extreme B A (X, MIN)) by (unfold extreme, sgn, coord; simpl; lra).
  assert (E1 : extreme B A (X, MAX)) by (unfold extreme, sgn, coord; simpl; lra).
  assert (D0 : fst (Y, MAX) <> fst (X, MIN)) by (simpl; discriminate).
  assert (D1 : fst (Y, MAX) <> fst (X, MAX)) by (simpl; discriminate).
  pose proof (Q _ _ D0 E E0) as Q0; pose proof (Q _ _ D1 E E1) as Q1.
  rewrite value_from_a in Q0, Q1 by assumption; unfold extent_reach; cbv [sgn coord fst snd A B lo hi] in *.
  rewrite Rmax_left by lra; lra.
Qed.
