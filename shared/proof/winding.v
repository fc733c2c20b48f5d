(** A polygon that turns left everywhere, with one winding, is convex: Convex::fault, windsOnce. *)
From Coq Require Import ZArith List Lia Bool.
From Platon Require Import point obstacle obstacle_exact polygon.
Import ListNotations.
Open Scope Z_scope.

(* The directions after the first one lead to its left, then back. *)
Definition leadsOutAndBack (d : Point) (ds : list Point) : Prop :=
  exists out back, ds = out ++ back /\ out <> [] /\ (forall e, In e out -> 0 < cross d e) /\
    (forall first others, back = first :: others -> cross d first <= 0 /\ forall e, In e others -> cross d e < 0).

Lemma out_and_back d ds : ds <> [] -> (forall first others, ds = first :: others -> 0 < cross d first) ->
  (forall l e f r, ds = l ++ e :: f :: r -> cross d e <= 0 -> cross d f < 0) -> leadsOutAndBack d ds.
Proof.
  intros NE F P.
  assert (G : forall rest done, ds = done ++ rest -> done <> [] -> (forall e, In e done -> 0 < cross d e) -> leadsOutAndBack d ds).
  { induction rest as [| e t IH]; intros done E ND A.
    - exists done, []. split; [assumption | split; [assumption | split; [assumption | discriminate]]].
    - destruct (Z_lt_le_dec 0 (cross d e)) as [L | L].
      + apply (IH (done ++ [e])); [rewrite <- app_assoc; assumption | destruct done; discriminate |].
        intros f H. apply in_app_iff in H as [H | [<- | []]]; auto.
      + exists done, (e :: t). split; [assumption | split; [assumption | split; [assumption |]]].
        intros first others K. injection K as <- <-. split; [assumption |].
        assert (B : forall u l v, ds = l ++ v :: u -> cross d v <= 0 -> forall f, In f u -> cross d f < 0).
        { induction u as [| w u IHu]; intros l v E' V f H; [contradiction |].
          assert (W : cross d w < 0) by (apply (P l v w u); assumption).
          destruct H as [<- | H]; [assumption |]. apply (IHu (l ++ [v]) w); [rewrite <- app_assoc; assumption | lia | assumption]. }
        exact (B t done e E L). }
  destruct ds as [| e t]; [congruence |]. apply (G t [e]); [reflexivity | discriminate |].
  intros f [<- | []]. eapply F. reflexivity.
Qed.

Lemma sumOf_sign f l : (forall e, In e l -> f e < 0) -> l <> [] -> sumOf f l < 0.
Proof.
  intros A N. assert (H : 0 < sumOf (fun e => - f e) l).
  { apply sumOf_positive; [intros e E; specialize (A e E); lia |].
    destruct l as [| h t]; [congruence |]. exists h. split; [left; reflexivity |]. specialize (A h (or_introl eq_refl)). lia. }
  assert (E : forall k, sumOf (fun e => - f e) k = - sumOf f k) by (induction k as [| h t IH]; simpl; [reflexivity | rewrite IH; lia]).
  rewrite E in H. lia.
Qed.

(* So between its start and its end, at height 0, the path is above. *)
Lemma stays_above d ds before after : leadsOutAndBack d ds -> ds = before ++ after -> before <> [] -> after <> [] ->
  sumOf (cross d) ds = 0 -> 0 < sumOf (cross d) before.
Proof.
  intros (out & back & E & NO & A & B) F NB NA Z0.
  destruct (Nat.le_gt_cases (length before) (length out)) as [L | L].
  - (* the path only leads out *)
    assert (K : exists rest, out = before ++ rest).
    { exists (skipn (length before) out). rewrite E in F. apply (f_equal (firstn (length before))) in F.
      rewrite !firstn_app in F. rewrite firstn_all in F. replace (length before - length before)%nat with O in F by lia.
      replace (length before - length out)%nat with O in F by lia. rewrite !firstn_O, !app_nil_r in F.
      rewrite <- F at 1. rewrite firstn_skipn. reflexivity. }
    destruct K as (rest & K). apply sumOf_positive.
    + intros e H. assert (0 < cross d e); [| lia]. apply A. rewrite K. apply in_app_iff. auto.
    + destruct before as [| h t]; [congruence |]. exists h. split; [left; reflexivity |]. apply A. rewrite K. left. reflexivity.
  - (* what is left leads back *)
    assert (K : exists first others more, back = first :: others /\ others = more ++ after).
    { rewrite E in F. apply (f_equal (skipn (length out))) in F. rewrite !skipn_app in F.
      rewrite skipn_all in F. replace (length out - length out)%nat with O in F by lia.
      replace (length out - length before)%nat with O in F by lia. simpl in F.
      destruct (skipn (length out) before) as [| h t] eqn:S.
      - assert (length (skipn (length out) before) = O) by (rewrite S; reflexivity). rewrite skipn_length in H. lia.
      - exists h, (t ++ after), t. split; [exact F | reflexivity]. }
    destruct K as (first & others & more & K1 & K2). destruct (B first others K1) as [_ C].
    assert (S : sumOf (cross d) after < 0).
    { apply sumOf_sign; [| assumption]. intros e H. apply C. rewrite K2. apply in_app_iff. auto. }
    rewrite F, sumOf_app in Z0. lia.
Qed.

(* Each direction is to the left of the one before. *)
Fixpoint turning (from : Point) (path : list Point) : Prop :=
  match path with [] => True | next :: others => 0 < cross from next /\ turning next others end.

Lemma turning_app from l r : turning from (l ++ r) <-> turning from l /\ turning (last l from) r.
Proof.
  revert from. induction l as [| h t IH]; intros from; [simpl; tauto |].
  cbn [app turning]. rewrite IH, (last_cons t h from). tauto.
Qed.

Lemma turning_nonzero from path e : turning from path -> In e path -> e <> point 0 0.
Proof.
  revert from. induction path as [| h t IH]; intros from T H; [contradiction |]. destruct T as [T T'].
  destruct H as [<- | H]; [apply (cross_nonzero from h T) | apply (IH h T' H)].
Qed.

Fixpoint changesFrom (from : bool) (path : list bool) : nat :=
  match path with [] => O | next :: others => ((if xorb from next then 1 else 0) + changesFrom next others)%nat end.

Lemma changes_from_first d ds : changes (d :: ds) = changesFrom (lower d) (map lower (ds ++ [d])).
Proof.
  unfold changes, neighbours. cbn [rotate1].
  assert (G : forall path from last, length (filter (fun pair => xorb (lower (fst pair)) (lower (snd pair))) (combine (from :: path) (path ++ [last]))) =
    changesFrom (lower from) (map lower (path ++ [last]))).
  { induction path as [| h t IH]; intros from l; simpl.
    - destruct (xorb (lower from) (lower l)); reflexivity.
    - specialize (IH h l). simpl in IH. destruct (xorb (lower from) (lower h)); simpl; rewrite IH; reflexivity. }
  apply G.
Qed.

Lemma never_changes x path : changesFrom x (map lower path) = O -> forall e, In e path -> lower e = x.
Proof.
  induction path as [| h t IH]; intros C e H; [contradiction |]. simpl in C.
  destruct (xorb x (lower h)) eqn:X; [simpl in C; lia |]. apply xorb_eq in X. subst x. simpl in C.
  destruct H as [<- | H]; auto.
Qed.

Lemma changes_once x path : changesFrom x (map lower path) = 1%nat ->
  exists l v, path = l ++ v /\ (forall e, In e l -> lower e = x) /\ (forall e, In e v -> lower e = negb x).
Proof.
  induction path as [| h t IH]; intros C; [discriminate |]. simpl in C. destruct (xorb x (lower h)) eqn:X.
  - exists [], (h :: t). split; [reflexivity |]. split; [intros _ [] |].
    assert (E : lower h = negb x) by (destruct x, (lower h); simpl in *; congruence).
    intros e [<- | H]; [assumption |]. rewrite <- E. apply (never_changes _ t); [simpl in C; lia | assumption].
  - apply xorb_eq in X. rewrite <- X in C. destruct (IH C) as (l & v & -> & A & B). exists (h :: l), v.
    split; [reflexivity |]. split; [intros e [<- | H]; auto | assumption].
Qed.

Lemma changes_twice x path : changesFrom x (map lower path) = 2%nat ->
  exists u l v, path = u ++ l ++ v /\ l <> [] /\ (forall e, In e u -> lower e = x) /\
    (forall e, In e l -> lower e = negb x) /\ (forall e, In e v -> lower e = x).
Proof.
  induction path as [| h t IH]; intros C; [discriminate |]. simpl in C. destruct (xorb x (lower h)) eqn:X.
  - assert (E : lower h = negb x) by (destruct x, (lower h); simpl in *; congruence).
    rewrite E in C. simpl in C. injection C as C. destruct (changes_once _ _ C) as (l & v & -> & A & B).
    exists [], (h :: l), v. split; [reflexivity |]. split; [discriminate |]. split; [intros _ [] |].
    split; [intros e [<- | H]; auto |]. intros e H. rewrite <- (negb_involutive x). auto.
  - apply xorb_eq in X. rewrite <- X in C. destruct (IH C) as (u & l & v & -> & N & A & B & D). exists (h :: u), l, v.
    split; [reflexivity |]. split; [assumption |]. split; [intros e [<- | H]; auto | auto].
Qed.

(* A half plane in which [turn d] is upper, and the other directions of its kind. *)
Definition turned (x : bool) (d : Point) : Point := if x then opposite d else d.

Lemma turned_cross x d e : cross (turned x d) (turned x e) = cross d e.
Proof. destruct x; [apply cross_opposites | reflexivity]. Qed.

Lemma turned_upper x d : d <> point 0 0 -> lower d = x -> isUpper (turned x d).
Proof. intros N E. destruct x; simpl; [apply lower_is_opposite; assumption | apply lower_or_upper; assumption]. Qed.

Lemma opposite_twice d : opposite (opposite d) = d.
Proof. destruct d as [u v]. unfold opposite; simpl. f_equal; lia. Qed.

Lemma turned_lower x d : d <> point 0 0 -> lower d = negb x -> isUpper (opposite (turned x d)).
Proof.
  intros N E. destruct x; simpl in *; [rewrite opposite_twice; apply lower_or_upper; assumption | apply lower_is_opposite; assumption].
Qed.

Lemma upper_chain x d : isUpper (turned x d) -> forall path e,
  isUpper (turned x e) -> 0 <= cross d e -> turning e path -> (forall f, In f path -> isUpper (turned x f)) ->
  forall f, In f path -> 0 < cross d f.
Proof.
  intros D. induction path as [| h t IH]; intros e E C T U f H; [contradiction |]. destruct T as [T T'].
  assert (K : 0 < cross d h).
  { rewrite <- (turned_cross x). apply (upper_next _ (turned x e)); try rewrite turned_cross; auto. apply U. left. reflexivity. }
  destruct H as [<- | H]; [assumption |].
  apply (IH h); [apply U; left; reflexivity | lia | assumption | intros g G; apply U; right; assumption | assumption].
Qed.

Lemma lower_chain x d : isUpper (turned x d) -> forall path e,
  isUpper (opposite (turned x e)) -> cross d e <= 0 -> turning e path -> (forall f, In f path -> isUpper (opposite (turned x f))) ->
  forall f, In f path -> cross d f < 0.
Proof.
  intros D. induction path as [| h t IH]; intros e E C T U f H; [contradiction |]. destruct T as [T T'].
  assert (K : cross d h < 0).
  { assert (0 < cross (turned x d) (opposite (turned x h))); [| rewrite cross_opposite, turned_cross in *; lia].
    apply (upper_next _ (opposite (turned x e))); auto; [apply U; left; reflexivity | |].
    - rewrite cross_opposite, turned_cross. lia.
    - rewrite cross_opposites, turned_cross. assumption. }
  destruct H as [<- | H]; [assumption |].
  apply (IH h); [apply U; left; reflexivity | lia | assumption | intros g G; apply U; right; assumption | assumption].
Qed.

Lemma lower_out_and_back x d path from : isUpper (turned x d) -> turning from path ->
  (forall f, In f path -> isUpper (opposite (turned x f))) ->
  exists out back, path = out ++ back /\ (forall e, In e out -> 0 < cross d e) /\
    (forall first others, back = first :: others -> cross d first <= 0 /\ forall e, In e others -> cross d e < 0).
Proof.
  intros D. revert from. induction path as [| h t IH]; intros from T U.
  - exists [], []. split; [reflexivity | split; [intros _ [] | discriminate]].
  - destruct T as [T T']. destruct (Z_lt_le_dec 0 (cross d h)) as [L | L].
    + destruct (IH h T' (fun f F => U f (or_intror F))) as (out & back & -> & A & B). exists (h :: out), back.
      split; [reflexivity | split; [intros e [<- | H]; auto | assumption]].
    + exists [], (h :: t). split; [reflexivity | split; [intros _ [] |]]. intros first others E. injection E as <- <-.
      split; [assumption |]. apply (lower_chain x d D t h); auto; [apply U; left; reflexivity | intros f F; apply U; right; assumption].
Qed.

Lemma out_and_back_of_winding d ds : turning d (ds ++ [d]) -> changes (d :: ds) = 2%nat -> leadsOutAndBack d ds.
Proof.
  intros T C. rewrite changes_from_first in C. set (x := lower d) in *.
  assert (Nd : d <> point 0 0) by (apply (turning_nonzero d (ds ++ [d]) d T); apply in_app_iff; simpl; auto).
  assert (N : forall e, In e (ds ++ [d]) -> e <> point 0 0) by (intros e; apply (turning_nonzero d _ e T)).
  assert (D : isUpper (turned x d)) by (apply turned_upper; auto).
  destruct (changes_twice x _ C) as (u & l & v' & E & NL & U & L & V').
  (* d itself ends the last block *)
  assert (K : exists v, v' = v ++ [d] /\ ds = u ++ l ++ v).
  { destruct (exists_last (l := v')) as (v & e & ->).
    - intros ->. rewrite app_nil_r in E. destruct (exists_last NL) as (l' & e & ->). rewrite app_assoc in E.
      apply app_inj_tail in E as [_ <-]. specialize (L d ltac:(apply in_app_iff; simpl; auto)). fold x in L. destruct x; discriminate.
    - rewrite !app_assoc in E. apply app_inj_tail in E as [-> <-]. exists v. rewrite <- app_assoc. auto. }
  destruct K as (v & -> & ->). clear E.
  assert (T' := T). rewrite <- !app_assoc in T'. apply turning_app in T' as [TU T']. apply turning_app in T' as [TL TV].
  assert (AU : forall e, In e u -> 0 < cross d e).
  { apply (upper_chain x d D u d D); [unfold cross; lia | assumption |].
    intros f F. apply turned_upper; [apply N; rewrite !in_app_iff; auto | auto]. }
  assert (AV : forall e, In e v -> cross d e < 0).
  { intros e H. apply in_split in H as (v1 & v2 & ->). rewrite <- app_assoc in TV. apply turning_app in TV as [_ TV].
    cbn [app turning] in TV. destruct TV as [_ TV]. rewrite cross_swap. assert (0 < cross e d); [| lia].
    assert (Ne : e <> point 0 0) by (apply N; rewrite !in_app_iff; simpl; auto 6).
    assert (Ue : isUpper (turned x e)) by (apply turned_upper; [assumption | apply V'; rewrite !in_app_iff; simpl; auto]).
    apply (upper_chain x e Ue (v2 ++ [d]) e Ue); [unfold cross; lia | assumption | | apply in_app_iff; simpl; auto].
    intros f F. apply turned_upper; [apply N; rewrite !in_app_iff in *; simpl in *; tauto | apply V'; rewrite !in_app_iff in *; simpl in *; tauto]. }
  destruct (lower_out_and_back x d l (last u d) D TL) as (out & back & E & A & B).
  { intros f F. apply turned_lower; [apply N; rewrite !in_app_iff; auto | auto]. }
  exists (u ++ out), (back ++ v). split; [rewrite E, <- !app_assoc; reflexivity |]. split; [| split].
  - destruct u as [| h t]; [| discriminate]. simpl. intros ->. simpl in E. subst l.
    destruct back as [| f r]; [congruence |]. destruct (B f r eq_refl) as [G _]. simpl in TL. destruct TL as [TL _]. lia.
  - intros e H. apply in_app_iff in H as [H | H]; auto.
  - intros first others F. destruct back as [| f r]; simpl in F.
    + split; [specialize (AV first ltac:(rewrite F; left; reflexivity)); lia |]. intros e H. apply AV. rewrite F. right. assumption.
    + injection F as <- <-. destruct (B f r eq_refl) as [G G']. split; [assumption |].
      intros e H. apply in_app_iff in H as [H | H]; auto.
Qed.

Lemma turning_of_neighbours path : forall from last,
  (forall pair, In pair (combine (from :: path) (path ++ [last])) -> 0 < cross (fst pair) (snd pair)) ->
  turning from (path ++ [last]).
Proof.
  induction path as [| h t IH]; intros from l H.
  - split; [apply (H (from, l)); left; reflexivity | exact I].
  - split; [apply (H (from, h)); left; reflexivity |]. apply IH. intros pair P. apply H. right. exact P.
Qed.

Lemma isLeftOf_cross u v w : isLeftOf (u, v) w = cross (minus v u) (minus w u).
Proof. unfold isLeftOf, cross, dot, perpendicular, minus; simpl. ring. Qed.

(* All vertices but its ends are to the left of the first edge. *)
Lemma left_of_first u v rest w :
  (forall pair, In pair (neighbours (directions (u :: v :: rest))) -> 0 < cross (fst pair) (snd pair)) ->
  changes (directions (u :: v :: rest)) = 2%nat -> In w rest -> 0 < isLeftOf (u, v) w.
Proof.
  intros T C W. set (d := minus v u). set (ds := differences v (rest ++ [u])).
  assert (E : directions (u :: v :: rest) = d :: ds).
  { unfold directions, neighbours. cbn [rotate1 app].
    change (difference (u, v) :: map difference (combine (v :: rest) (rest ++ [u])) = d :: ds).
    rewrite combine_differences. reflexivity. }
  rewrite E in T, C.
  assert (T' : turning d (ds ++ [d])) by (apply turning_of_neighbours; exact T).
  pose proof (out_and_back_of_winding d ds T' C) as L.
  apply in_split in W as (r1 & r2 & ->). unfold ds in *. clear ds.
  assert (F : differences v ((r1 ++ w :: r2) ++ [u]) = differences v (r1 ++ [w]) ++ differences w (r2 ++ [u])).
  { rewrite <- app_assoc. change ((w :: r2) ++ [u]) with ([w] ++ (r2 ++ [u])). rewrite app_assoc, differences_app.
    rewrite last_last. reflexivity. }
  assert (P : 0 < sumOf (cross d) (differences v (r1 ++ [w]))).
  { apply (stays_above d _ _ _ L F).
    - destruct r1; discriminate.
    - destruct r2; discriminate.
    - rewrite sum_of_differences, last_last. unfold d, cross, minus; simpl. ring. }
  rewrite sum_of_differences, last_last in P. rewrite isLeftOf_cross. fold d.
  assert (K : cross d (minus w u) = cross d (minus w v) + cross d d) by (unfold d, cross, minus; simpl; ring).
  assert (Z0 : cross d d = 0) by (unfold cross; ring). lia.
Qed.

Lemma nodup_of_splits {A} (l : list A) : (forall u l1 l2, l = l1 ++ u :: l2 -> ~ In u (l1 ++ l2)) -> NoDup l.
Proof.
  intros H. induction l as [| h t IH]; constructor.
  - apply (H h [] t). reflexivity.
  - apply IH. intros u l1 l2 E I. apply (H u (h :: l1) l2); [rewrite E; reflexivity | right; exact I].
Qed.

Theorem valid_is_convex vertices : isValid vertices = true -> strictlyConvex vertices.
Proof.
  unfold isValid. rewrite !andb_true_iff, Nat.leb_le, Nat.eqb_eq, !forallb_forall. intros (((L & _) & T) & C).
  assert (T' : forall n pair, In pair (neighbours (directions (rotateBy n vertices))) -> 0 < cross (fst pair) (snd pair)).
  { intros n pair P. apply Z.ltb_lt. apply T. revert P. clear. induction n as [| n IH]; simpl; [auto |].
    rewrite directions_rotate, neighbours_rotate, rotate1_in. assumption. }
  assert (C' : forall n, changes (directions (rotateBy n vertices)) = 2%nat).
  { induction n as [| n IH]; simpl; [assumption |]. rewrite directions_rotate, changes_rotate. assumption. }
  assert (G : forall n u v rest w, rotateBy n vertices = u :: v :: rest -> In w rest -> 0 < isLeftOf (u, v) w).
  { intros n u v rest w E W. apply (left_of_first u v rest w); [rewrite <- E; exact (T' n) | rewrite <- E; exact (C' n) | assumption]. }
  (* the list that begins with a vertex, or with an edge *)
  assert (R : forall n, exists u v rest, rotateBy n vertices = u :: v :: rest).
  { intros n. pose proof (rotateBy_length n vertices) as K.
    destruct (rotateBy n vertices) as [| u [| v rest]]; simpl in K; [lia | lia | exists u, v, rest; reflexivity]. }
  split; [assumption | split].
  - apply nodup_of_splits. intros u l1 l2 E I.
    assert (E' : rotateBy (length l1) vertices = u :: l2 ++ l1) by (rewrite E; apply (rotateBy_app l1 (u :: l2))).
    destruct (R (length l1)) as (u' & v & rest & F). rewrite E' in F. injection F as <- F.
    assert (I' : In u (v :: rest)) by (rewrite <- F; apply in_app_iff; apply in_app_iff in I; tauto).
    destruct I' as [-> | I'].
    + (* an edge has a direction *)
      assert (P : In (u, u) (neighbours (rotateBy (length l1) vertices))) by (rewrite E', F; left; reflexivity).
      assert (Q : In (difference (u, u)) (directions (rotateBy (length l1) vertices))) by (apply in_map; assumption).
      destruct (has_successor _ _ Q) as (e & S & _). apply T' in S. apply cross_nonzero in S as [S _]. apply S.
      unfold difference, minus; simpl. f_equal; lia.
    + assert (W : 0 < isLeftOf (u, v) u) by (apply (G (length l1) u v rest u); [rewrite E', F; reflexivity | assumption]).
      pose proof (proj1 (isLeftOf_ends (u, v))) as Z0. simpl in Z0. lia.
  - intros ends w P W U V. destruct ends as [u v]. simpl in U, V. destruct (make_first vertices u v P) as (n & rest0 & E).
    destruct (R n) as (u' & v' & rest & F). assert (X : u' = u /\ v' = v).
    { rewrite F in E. unfold neighbours in E. simpl in E. injection E as -> ->. auto. }
    destruct X as [-> ->]. apply (G n u v rest w F).
    apply (rotateBy_in n) in W. rewrite F in W. destruct W as [W | [W | W]]; congruence.
Qed.
