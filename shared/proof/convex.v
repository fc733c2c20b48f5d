(** Valid shapes: Convex::fault in shared/physics/convex.cpp. *)
From Coq Require Import ZArith List Lia Bool.
From Platon Require Import point obstacle.
Import ListNotations.
Open Scope Z_scope.

(** ** What fault() checks *)

Definition cross (p q : Point) : Z := x p * y q - y p * x q.
Definition isCoordinate (z : Z) : bool := (- 2 ^ 29 <? z) && (z <? 2 ^ 29).
Definition inRange (p : Point) : bool := isCoordinate (x p) && isCoordinate (y p).

(** The directions of the edges. *)
Definition difference (ends : Point * Point) : Point := minus (snd ends) (fst ends).
Definition directions (vertices : list Point) : list Point := map difference (neighbours vertices).

(** inSameHalfPlane *)
Definition lower (d : Point) : bool := (y d <? 0) || ((y d =? 0) && (x d <? 0)).
Definition changes (ds : list Point) : nat :=
  length (filter (fun pair => xorb (lower (fst pair)) (lower (snd pair))) (neighbours ds)).

(** Whether fault() is empty. *)
Definition isValid (vertices : list Point) : bool :=
  (3 <=? length vertices)%nat && forallb inRange vertices &&
  forallb (fun pair => 0 <? cross (fst pair) (snd pair)) (neighbours (directions vertices)) &&
  (changes (directions vertices) =? 2)%nat.

(** ** Cyclic lists *)

Lemma combine_snoc {A B} (l : list A) : forall (r : list B) a b, length l = length r ->
  combine (l ++ [a]) (r ++ [b]) = combine l r ++ [(a, b)].
Proof.
  induction l as [| h t IH]; intros r a b L; destruct r as [| h' t']; try discriminate; simpl; [reflexivity |].
  rewrite IH; [reflexivity | simpl in L; lia].
Qed.

Lemma neighbours_rotate {A} (l : list A) : neighbours (rotate1 l) = rotate1 (neighbours l).
Proof.
  destruct l as [| h t]; [reflexivity |]. destruct t as [| h' t']; [reflexivity |].
  transitivity (combine ((h' :: t') ++ [h]) ((t' ++ [h]) ++ [h'])); [reflexivity |].
  rewrite combine_snoc; [reflexivity |]. rewrite app_length; simpl; lia.
Qed.

Lemma map_rotate {A B} (f : A -> B) l : map f (rotate1 l) = rotate1 (map f l).
Proof. destruct l; simpl; [reflexivity |]. rewrite map_app. reflexivity. Qed.

Lemma directions_rotate vertices : directions (rotate1 vertices) = rotate1 (directions vertices).
Proof. unfold directions. rewrite neighbours_rotate, map_rotate. reflexivity. Qed.

Lemma filter_rotate {A} (f : A -> bool) l : length (filter f (rotate1 l)) = length (filter f l).
Proof. destruct l as [| h t]; simpl; [reflexivity |]. rewrite filter_app, app_length. simpl. destruct (f h); simpl; lia. Qed.

Lemma changes_rotate ds : changes (rotate1 ds) = changes ds.
Proof. unfold changes. rewrite neighbours_rotate. apply filter_rotate. Qed.

(* Any pair of neighbours can be made the first one. *)
Fixpoint rotateBy {A} (n : nat) (l : list A) : list A := match n with O => l | S m => rotate1 (rotateBy m l) end.

Lemma rotateBy_app {A} (l r : list A) : rotateBy (length l) (l ++ r) = r ++ l.
Proof.
  revert r. induction l as [| h t IH]; intros r; [simpl; rewrite app_nil_r; reflexivity |].
  assert (G : forall n (k : list A), rotateBy n (rotate1 k) = rotate1 (rotateBy n k)).
  { induction n as [| n IHn]; intros k; simpl; [reflexivity |]. rewrite IHn. reflexivity. }
  simpl. rewrite <- G. simpl. rewrite <- app_assoc. rewrite IH. rewrite <- app_assoc. reflexivity.
Qed.

Lemma neighbours_rotateBy {A} n (l : list A) : neighbours (rotateBy n l) = rotateBy n (neighbours l).
Proof. induction n as [| n IH]; simpl; [reflexivity |]. rewrite neighbours_rotate, IH. reflexivity. Qed.

Lemma rotateBy_in {A} n (l : list A) a : In a (rotateBy n l) <-> In a l.
Proof. induction n as [| n IH]; simpl; [tauto |]. rewrite rotate1_in. assumption. Qed.

Lemma rotateBy_length {A} n (l : list A) : length (rotateBy n l) = length l.
Proof. induction n as [| n IH]; simpl; [reflexivity |]. rewrite rotate1_length. assumption. Qed.

Lemma make_first {A} (l : list A) u v : In (u, v) (neighbours l) ->
  exists n rest, neighbours (rotateBy n l) = (u, v) :: rest.
Proof.
  intros H. apply in_split in H as (before & after & E). exists (length before). rewrite neighbours_rotateBy, E.
  rewrite rotateBy_app. exists (after ++ before). reflexivity.
Qed.

(** ** Sums along a path *)

Fixpoint differences (from : Point) (path : list Point) : list Point :=
  match path with [] => [] | next :: others => minus next from :: differences next others end.

Lemma last_cons {A} (t : list A) : forall h d, last (h :: t) d = last t h.
Proof.
  induction t as [| a t IH]; intros h d; [reflexivity |]. transitivity (last (a :: t) d); [reflexivity |].
  rewrite (IH a d), (IH a h). reflexivity.
Qed.

Lemma differences_app from path : forall more, differences from (path ++ more) = differences from path ++ differences (last path from) more.
Proof.
  revert from. induction path as [| h t IH]; intros from more; [reflexivity |].
  cbn [app differences]. rewrite IH, (last_cons t h from). reflexivity.
Qed.

Lemma combine_differences from path last :
  map difference (combine (from :: path) (path ++ [last])) = differences from (path ++ [last]).
Proof.
  revert from. induction path as [| h t IH]; intros from; [reflexivity |].
  change (difference (from, h) :: map difference (combine (h :: t) (t ++ [last])) = minus h from :: differences h (t ++ [last])).
  rewrite IH. reflexivity.
Qed.

Lemma sum_of_differences d from path : sumOf (cross d) (differences from path) = cross d (minus (last path from) from).
Proof.
  revert from. induction path as [| h t IH]; intros from; [unfold cross, minus; simpl; ring |].
  cbn [differences sumOf fold_right]. fold (sumOf (cross d) (differences h t)). rewrite IH.
  rewrite (last_cons t h from). unfold cross, minus; simpl. ring.
Qed.

Lemma sumOf_app f l r : sumOf f (l ++ r) = sumOf f l + sumOf f r.
Proof. induction l as [| h t IH]; simpl; [ring |]. rewrite IH. ring. Qed.

(** ** Directions in one half plane are ordered by their angle *)

Definition isUpper (d : Point) : Prop := 0 < y d \/ (y d = 0 /\ 0 < x d).

Lemma lower_or_upper d : d <> point 0 0 -> (lower d = false <-> isUpper d).
Proof.
  unfold lower, isUpper. rewrite orb_false_iff, andb_false_iff, !Z.ltb_ge, Z.eqb_neq. destruct d as [u v]; simpl.
  intros N. assert (u <> 0 \/ v <> 0) by (destruct (Z.eq_dec u 0); [right; congruence | left; assumption]). lia.
Qed.

Lemma lower_is_opposite d : d <> point 0 0 -> (lower d = true <-> isUpper (opposite d)).
Proof.
  unfold lower, isUpper, opposite. rewrite orb_true_iff, andb_true_iff, !Z.ltb_lt, Z.eqb_eq. destruct d as [u v]; simpl.
  intros N. assert (u <> 0 \/ v <> 0) by (destruct (Z.eq_dec u 0); [right; congruence | left; assumption]). lia.
Qed.

Lemma cross_nonzero d e : 0 < cross d e -> d <> point 0 0 /\ e <> point 0 0.
Proof. unfold cross. intros H. split; intros ->; simpl in H; lia. Qed.

Lemma cross_opposite d e : cross d (opposite e) = - cross d e.
Proof. unfold cross, opposite; simpl. ring. Qed.

Lemma cross_opposites d e : cross (opposite d) (opposite e) = cross d e.
Proof. unfold cross, opposite; simpl. ring. Qed.

Lemma cross_swap d e : cross e d = - cross d e.
Proof. unfold cross. ring. Qed.

Lemma upper_next d e f : isUpper d -> isUpper e -> isUpper f -> 0 <= cross d e -> 0 < cross e f -> 0 < cross d f.
Proof.
  unfold isUpper, cross. destruct d as [dx dy], e as [ex ey], f as [fx fy]; simpl. intros D E F P Q.
  assert (I : (dx * fy - dy * fx) * ey = fy * (dx * ey - dy * ex) + dy * (ex * fy - ey * fx)) by ring.
  destruct E as [E | [-> E]].
  - destruct D as [D | [-> D]].
    + assert (0 < (dx * fy - dy * fx) * ey); [| nia]. rewrite I. destruct F as [F | [-> F]]; nia.
    + destruct F as [F | [-> F]]; nia.
  - assert (0 < fy) by nia. destruct D as [D | [-> D]]; nia.
Qed.

(** ** Locally convex, with one winding: convex *)

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

(** ** Convex: locally convex, with one winding *)

(* The corner at v: the direction into it, and the one out of it. *)
Lemma corner vertices d e : (3 <= length vertices)%nat -> In (d, e) (neighbours (directions vertices)) ->
  exists n u v w rest, rotateBy n vertices = u :: v :: w :: rest /\ d = minus v u /\ e = minus w v.
Proof.
  intros L P. destruct (make_first (directions vertices) d e P) as (n & rest0 & E).
  assert (K : directions (rotateBy n vertices) = rotateBy n (directions vertices)).
  { clear. induction n as [| n IH]; simpl; [reflexivity |]. rewrite directions_rotate, IH. reflexivity. }
  rewrite <- K in E. exists n. pose proof (rotateBy_length n vertices) as M.
  destruct (rotateBy n vertices) as [| u [| v [| w rest]]]; simpl in M; try lia.
  exists u, v, w, rest. split; [reflexivity |]. unfold neighbours, directions in E.
  destruct rest; simpl in E; injection E as <- <- _; auto.
Qed.

Lemma rotate1_nodup {A} (l : list A) : NoDup l -> NoDup (rotate1 l).
Proof.
  destruct l as [| h t]; [auto |]. simpl. intros N. apply NoDup_cons_iff in N as [N M].
  apply (NoDup_Add (a := h) (l := t)); [| split; assumption]. rewrite <- (app_nil_r t) at 1. apply Add_app.
Qed.

Lemma rotateBy_nodup {A} n (l : list A) : NoDup l -> NoDup (rotateBy n l).
Proof. intros N. induction n as [| n IH]; simpl; [assumption | apply rotate1_nodup; assumption]. Qed.

Lemma rotateBy_neighbours {A} n (l : list A) pair : In pair (neighbours (rotateBy n l)) <-> In pair (neighbours l).
Proof. rewrite neighbours_rotateBy. apply rotateBy_in. Qed.

Lemma corner_is_convex vertices n u v w rest z : strictlyConvex vertices -> rotateBy n vertices = u :: v :: w :: rest ->
  In z vertices -> z <> v ->
  0 < cross (minus v u) (minus w v) /\ 0 <= cross (minus v u) (minus z v) /\ 0 <= cross (minus w v) (minus z v).
Proof.
  intros C E Z N. pose proof C as (L & D & A).
  pose proof (rotateBy_nodup n vertices D) as D'. rewrite E in D'.
  assert (P : In (u, v) (neighbours vertices)) by (apply (rotateBy_neighbours n); rewrite E; destruct rest; simpl; auto).
  assert (Q : In (v, w) (neighbours vertices)) by (apply (rotateBy_neighbours n); rewrite E; destruct rest; simpl; auto).
  assert (W : In w vertices) by (apply (rotateBy_in n); rewrite E; simpl; auto).
  apply NoDup_cons_iff in D' as [D1 D']. apply NoDup_cons_iff in D' as [D2 _]. simpl in D1, D2.
  split; [| split].
  - assert (K : 0 < isLeftOf (u, v) w) by (apply (A _ w P W); simpl; intros ->; tauto).
    rewrite isLeftOf_cross in K. unfold cross, minus in *; simpl in *. lia.
  - pose proof (left_of_all vertices (u, v) z C P Z) as K. rewrite isLeftOf_cross in K. unfold cross, minus in *; simpl in *. lia.
  - pose proof (left_of_all vertices (v, w) z C Q Z) as K. rewrite isLeftOf_cross in K. exact K.
Qed.

(* A combination of upper directions is upper. *)
Lemma upper_cone ax ay bx by_ rx ry g h k : 0 < g -> 0 <= h -> 0 <= k ->
  (0 < ay \/ ay = 0 /\ 0 < ax) -> (0 < by_ \/ by_ = 0 /\ 0 < bx) ->
  rx * g = ax * h + bx * k -> ry * g = ay * h + by_ * k -> rx <> 0 \/ ry <> 0 -> 0 < ry \/ ry = 0 /\ 0 < rx.
Proof.
  intros G H K A B X Y N.
  assert (U : 0 <= ay * h) by (destruct A as [A | [-> A]]; [apply Z.mul_nonneg_nonneg; lia | lia]).
  assert (V : 0 <= by_ * k) by (destruct B as [B | [-> B]]; [apply Z.mul_nonneg_nonneg; lia | lia]).
  assert (R : 0 <= ry) by nia. destruct (Z.eq_dec ry 0) as [-> | M]; [right; split; [reflexivity |] | left; lia].
  assert (U0 : ay * h = 0) by lia. assert (V0 : by_ * k = 0) by lia.
  assert (S : 0 <= ax * h).
  { destruct A as [A | [_ A]]; [apply Z.mul_eq_0 in U0 as [U0 | ->]; lia | apply Z.mul_nonneg_nonneg; lia]. }
  assert (T : 0 <= bx * k).
  { destruct B as [B | [_ B]]; [apply Z.mul_eq_0 in V0 as [V0 | ->]; lia | apply Z.mul_nonneg_nonneg; lia]. }
  assert (0 <= rx) by nia. lia.
Qed.

(* A vertex at which the directions change from upper to lower is above all others; from lower to upper, below. *)
Lemma top_is_alone x d e q : d <> point 0 0 -> e <> point 0 0 -> q <> point 0 0 -> lower d = x -> lower e = negb x ->
  0 < cross d e -> 0 <= cross d q -> 0 <= cross e q -> lower q = negb x.
Proof.
  intros Nd Ne Nq D E P A B.
  assert (D' : isUpper (opposite (opposite (turned x d)))) by (rewrite opposite_twice; apply turned_upper; assumption).
  pose proof (turned_lower x e Ne E) as E'.
  (* q = (cross d q * e + cross e q * (- d)) / cross d e *)
  assert (X : point.x q * cross d e = point.x e * cross d q - point.x d * cross e q) by (unfold cross; ring).
  assert (Y : point.y q * cross d e = point.y e * cross d q - point.y d * cross e q) by (unfold cross; ring).
  rewrite opposite_twice in D'.
  assert (G : isUpper (opposite (turned x q))).
  { assert (N : point.x q <> 0 \/ point.y q <> 0).
    { destruct q as [qx qy]; simpl. destruct (Z.eq_dec qx 0); [right; congruence | left; assumption]. }
    unfold isUpper in *.
    apply (upper_cone (point.x (opposite (turned x e))) (point.y (opposite (turned x e))) (point.x (turned x d)) (point.y (turned x d))
             _ _ (cross d e) (cross d q) (cross e q)); try assumption; destruct x; unfold turned, opposite; cbn [point.x point.y]; lia. }
  destruct x; simpl in *.
  - rewrite opposite_twice in G. apply lower_or_upper; assumption.
  - apply lower_is_opposite; assumption.
Qed.

(* Each pair of successive directions with its corner. *)
Definition corners (vertices : list Point) : list ((Point * Point) * Point) :=
  combine (neighbours (directions vertices)) (rotate1 vertices).

Lemma combine_rotate {A B} (l : list A) (r : list B) : length l = length r ->
  combine (rotate1 l) (rotate1 r) = rotate1 (combine l r).
Proof. destruct l, r; simpl; try discriminate; [reflexivity |]. intros L. apply combine_snoc. lia. Qed.

Lemma neighbours_length {A} (l : list A) : length (neighbours l) = length l.
Proof. unfold neighbours. rewrite combine_length, rotate1_length. lia. Qed.

Lemma corners_length vertices : length (neighbours (directions vertices)) = length vertices.
Proof. rewrite neighbours_length. unfold directions. rewrite map_length. apply neighbours_length. Qed.

Lemma corners_rotateBy n vertices : corners (rotateBy n vertices) = rotateBy n (corners vertices).
Proof.
  induction n as [| n IH]; simpl; [reflexivity |]. rewrite <- IH. unfold corners.
  rewrite directions_rotate, neighbours_rotate. apply combine_rotate. rewrite corners_length, rotate1_length. reflexivity.
Qed.

Lemma corner_at vertices d e v : (3 <= length vertices)%nat -> In ((d, e), v) (corners vertices) ->
  exists n u w rest, rotateBy n vertices = u :: v :: w :: rest /\ d = minus v u /\ e = minus w v.
Proof.
  intros L P. apply in_split in P as (before & after & E). exists (length before).
  pose proof (corners_rotateBy (length before) vertices) as K. rewrite E, rotateBy_app in K.
  pose proof (rotateBy_length (length before) vertices) as M.
  destruct (rotateBy (length before) vertices) as [| u [| v' [| w rest]]]; simpl in M; try lia.
  exists u, w, rest. unfold corners, neighbours, directions in K.
  destruct rest; simpl in K; injection K as <- <- <- _; auto.
Qed.

Lemma minus_nonzero p q : p <> q -> minus p q <> point 0 0.
Proof. destruct p as [a b], q as [c d]. unfold minus; simpl. intros N E. injection E as E1 E2. apply N. f_equal; lia. Qed.

Lemma top vertices d e v x z : strictlyConvex vertices -> In ((d, e), v) (corners vertices) ->
  lower d = x -> lower e = negb x -> In z vertices -> z <> v -> lower (minus z v) = negb x.
Proof.
  intros C P D E Z N. pose proof C as (L & _ & _). destruct (corner_at vertices d e v L P) as (n & u & w & rest & F & Ed & Ee).
  destruct (corner_is_convex vertices n u v w rest z C F Z N) as (K & A & B). rewrite <- Ed, <- Ee in *.
  destruct (cross_nonzero d e K) as [Nd Ne].
  apply (top_is_alone x d e); auto. apply minus_nonzero. assumption.
Qed.

Lemma lower_opposite d : d <> point 0 0 -> lower (opposite d) = negb (lower d).
Proof.
  intros N. assert (N' : opposite d <> point 0 0).
  { destruct d as [a b]. unfold opposite; simpl. intros E. injection E as E1 E2. apply N. f_equal; lia. }
  destruct (lower d) eqn:E; simpl.
  - apply lower_is_opposite in E; [| assumption]. apply lower_or_upper; assumption.
  - apply lower_or_upper in E; [| assumption]. apply lower_is_opposite; [assumption |]. rewrite opposite_twice. assumption.
Qed.

(* There is one change from each kind of direction to the other. *)
Lemma one_top vertices x c1 v1 c2 v2 : strictlyConvex vertices -> In (c1, v1) (corners vertices) -> In (c2, v2) (corners vertices) ->
  lower (fst c1) = x -> lower (snd c1) = negb x -> lower (fst c2) = x -> lower (snd c2) = negb x -> v1 = v2.
Proof.
  intros C P Q A B D E. destruct (point_dec v1 v2) as [| N]; [assumption | exfalso].
  destruct c1 as [d1 e1], c2 as [d2 e2]; simpl in *.
  assert (V1 : In v1 vertices) by (apply rotate1_in; apply in_combine_r in P; assumption).
  assert (V2 : In v2 vertices) by (apply rotate1_in; apply in_combine_r in Q; assumption).
  pose proof (top vertices d1 e1 v1 x v2 C P A B V2 ltac:(congruence)) as K.
  pose proof (top vertices d2 e2 v2 x v1 C Q D E V1 N) as M.
  assert (O : minus v1 v2 = opposite (minus v2 v1)) by (unfold minus, opposite; simpl; f_equal; lia).
  rewrite O, lower_opposite, K in M; [destruct x; discriminate | apply minus_nonzero; congruence].
Qed.

Lemma one_change x path : forall from, lower from = negb x -> path <> [] -> lower (last path from) = x ->
  (forall l f g r, from :: path = l ++ f :: g :: r -> lower f = x -> lower g = negb x -> False) ->
  changesFrom (negb x) (map lower path) = 1%nat.
Proof.
  assert (Z0 : forall p from, lower from = x ->
    (forall l f g r, from :: p = l ++ f :: g :: r -> lower f = x -> lower g = negb x -> False) ->
    changesFrom x (map lower p) = O).
  { induction p as [| h t IH]; intros from F H; [reflexivity |]. simpl.
    assert (E : lower h = x).
    { destruct (bool_dec (lower h) x) as [K | K]; [assumption | exfalso]. apply (H [] from h t eq_refl F). destruct x, (lower h); simpl; congruence. }
    rewrite E. replace (xorb x x) with false by (destruct x; reflexivity). simpl. apply (IH h E).
    intros l f g r K. apply (H (from :: l) f g r). simpl. rewrite K. reflexivity. }
  induction path as [| h t IH]; intros from F N L H; [congruence |]. simpl. destruct (bool_dec (lower h) x) as [K | K].
  - rewrite K. replace (xorb (negb x) x) with true by (destruct x; reflexivity). rewrite (Z0 t h K); [reflexivity |].
    intros l f g r M. apply (H (from :: l) f g r). simpl. rewrite M. reflexivity.
  - assert (E : lower h = negb x) by (destruct x, (lower h); simpl; congruence). rewrite E.
    replace (xorb (negb x) (negb x)) with false by (destruct x; reflexivity). simpl. apply (IH h E).
    + intros ->. simpl in L. congruence.
    + rewrite (last_cons t h from) in L. assumption.
    + intros l f g r M. apply (H (from :: l) f g r). simpl. rewrite M. reflexivity.
Qed.

Lemma directions_of u v rest : directions (u :: v :: rest) = minus v u :: differences v (rest ++ [u]).
Proof.
  unfold directions, neighbours. cbn [rotate1 app].
  change (difference (u, v) :: map difference (combine (v :: rest) (rest ++ [u])) = minus v u :: differences v (rest ++ [u])).
  rewrite combine_differences. reflexivity.
Qed.

Lemma directions_sum c u v rest : sumOf (cross c) (directions (u :: v :: rest)) = 0.
Proof.
  rewrite directions_of. change (sumOf (cross c) (differences u (v :: rest ++ [u])) = 0). rewrite sum_of_differences.
  rewrite (last_cons (rest ++ [u]) v u), last_last. unfold cross, minus; simpl. ring.
Qed.

(* The directions are not all of one kind. *)
Lemma some_change u v rest : (forall d, In d (directions (u :: v :: rest)) -> d <> point 0 0) ->
  changes (directions (u :: v :: rest)) <> O.
Proof.
  intros N C. set (ds := directions (u :: v :: rest)) in *. assert (E : exists d0 others, ds = d0 :: others) by (unfold ds; rewrite directions_of; eauto).
  destruct E as (d0 & others & E). rewrite E, changes_from_first in C.
  assert (A : forall d, In d ds -> isUpper (turned (lower d0) d)).
  { intros d D. apply turned_upper; [apply N; assumption |]. apply (never_changes _ _ C). rewrite E in D. apply in_app_iff. simpl in *. tauto. }
  pose proof (directions_sum (turned (lower d0) (point 1 0)) u v rest) as SY. fold ds in SY.
  pose proof (directions_sum (turned (lower d0) (point 0 (-1))) u v rest) as SX. fold ds in SX.
  assert (Y : forall d, cross (turned (lower d0) (point 1 0)) d = y (turned (lower d0) d))
    by (intros d; destruct (lower d0); unfold turned, cross, opposite; cbn [x y]; ring).
  assert (X : forall d, cross (turned (lower d0) (point 0 (-1))) d = x (turned (lower d0) d))
    by (intros d; destruct (lower d0); unfold turned, cross, opposite; cbn [x y]; ring).
  destruct (Exists_dec (fun d => 0 < y (turned (lower d0) d)) ds (fun d => Z_lt_dec 0 _)) as [P | P].
  - apply Exists_exists in P as (d & D & P). assert (0 < sumOf (cross (turned (lower d0) (point 1 0))) ds); [| lia].
    apply sumOf_positive; [intros e F; rewrite Y; destruct (A e F) as [G | [G _]]; lia | exists d; rewrite Y; auto].
  - assert (Q : forall d, In d ds -> 0 < x (turned (lower d0) d)).
    { intros d D. destruct (A d D) as [G | [_ G]]; [| assumption]. exfalso. apply P. apply Exists_exists. eauto. }
    assert (0 < sumOf (cross (turned (lower d0) (point 0 (-1)))) ds); [| lia].
    apply sumOf_positive; [intros e F; rewrite X; specialize (Q e F); lia |].
    exists d0. rewrite X. assert (I : In d0 ds) by (rewrite E; left; reflexivity). auto.
Qed.

Theorem convex_is_valid vertices : strictlyConvex vertices -> (forall v, In v vertices -> inRange v = true) -> isValid vertices = true.
Proof.
  intros C R. pose proof C as (L & D & A).
  assert (T : forall d e, In (d, e) (neighbours (directions vertices)) -> 0 < cross d e).
  { intros d e P. destruct (corner vertices d e L P) as (n & u & v & w & rest & E & -> & ->).
    assert (W : In u vertices) by (apply (rotateBy_in n); rewrite E; simpl; auto).
    assert (N : u <> v). { pose proof (rotateBy_nodup n vertices D) as K. rewrite E in K. apply NoDup_cons_iff in K as [K _]. simpl in K. intros ->. tauto. }
    apply (corner_is_convex vertices n u v w rest u C E W N). }
  unfold isValid. rewrite !andb_true_iff, Nat.leb_le, Nat.eqb_eq, !forallb_forall.
  split; [split; [split; [assumption | assumption] |] |].
  { intros [d e] P. apply Z.ltb_lt. apply T. assumption. }
  (* some change, *)
  destruct vertices as [| u0 [| v0 rest0]]; [simpl in L; lia | simpl in L; lia |]. set (vertices := u0 :: v0 :: rest0) in *.
  assert (N0 : changes (directions vertices) <> O).
  { apply some_change. intros d I. destruct (has_successor _ _ I) as (e & S & _). apply T in S. apply (cross_nonzero d e S). }
  unfold changes in N0. destruct (filter _ (neighbours (directions vertices))) as [| [d e] others] eqn:F; [simpl in N0; congruence |].
  assert (P : In (d, e) (neighbours (directions vertices)) /\ xorb (lower d) (lower e) = true).
  { apply (proj1 (filter_In (fun pair => xorb (lower (fst pair)) (lower (snd pair))) (d, e) _)). rewrite F. left. reflexivity. }
  destruct P as [P X]. set (k := lower d). assert (Ee : lower e = negb k) by (unfold k; destruct (lower d), (lower e); simpl in *; congruence).
  (* which shall be the first one; *)
  clear F N0 others. assert (LC : length (neighbours (directions vertices)) = length (rotate1 vertices)) by (rewrite corners_length, rotate1_length; reflexivity).
  destruct (combine_left (neighbours (directions vertices)) (rotate1 vertices) (d, e) LC P) as (v & Q).
  apply in_split in Q as (before & after & Q). set (n := length before).
  pose proof (corners_rotateBy n vertices) as K. unfold corners in K at 2. rewrite Q in K. unfold n in K. rewrite rotateBy_app in K. fold n in K.
  assert (CH : changes (directions vertices) = changes (directions (rotateBy n vertices))).
  { clear. induction n as [| n IH]; simpl; [reflexivity |]. rewrite directions_rotate, changes_rotate. assumption. }
  rewrite CH. set (V := rotateBy n vertices) in *.
  assert (CV : strictlyConvex V).
  { split; [unfold V; rewrite rotateBy_length; assumption |]. split; [apply rotateBy_nodup; assumption |].
    intros ends w I W. apply A; [apply (rotateBy_neighbours n); assumption | apply (rotateBy_in n); assumption]. }
  pose proof (rotateBy_length n vertices) as M. fold V in M.
  assert (S : exists rest, directions V = d :: e :: rest /\ corners V = ((d, e), v) :: after ++ before /\ NoDup (map snd (corners V))).
  { assert (ND : NoDup (map snd (corners V))).
    { unfold corners. assert (G : forall (l : list (Point * Point)) (r : list Point), length l = length r -> map snd (combine l r) = r).
      { induction l as [| h t IH]; intros r Lr; destruct r; simpl in *; try discriminate; [reflexivity |]. rewrite IH; [reflexivity | lia]. }
      rewrite G; [apply rotate1_nodup; apply rotateBy_nodup; assumption | rewrite corners_length, rotate1_length; reflexivity]. }
    destruct V as [| p [| q [| r t]]]; simpl in M, L; try lia. unfold corners in K at 1. unfold neighbours, directions in K.
    exists (skipn 2 (directions (p :: q :: r :: t))). split; [| split; [exact K | exact ND]].
    destruct t; simpl in K; injection K as <- <- _ _; reflexivity. }
  destruct S as (rest & SD & SC & ND). rewrite SD, changes_from_first.
  change (((if xorb (lower d) (lower e) then 1 else 0) + changesFrom (lower e) (map lower (rest ++ [d])))%nat = 2%nat).
  rewrite X, Ee. change (S (changesFrom (negb k) (map lower (rest ++ [d]))) = 2%nat). apply f_equal.
  (* there is no other. *)
  apply (one_change k (rest ++ [d]) e Ee); [destruct rest; discriminate | rewrite last_last; reflexivity |].
  intros l f g r H Hf Hg.
  assert (I : In (f, g) (combine (e :: rest) (rest ++ [d]))).
  { clear - H. assert (G : forall rs e0 l0, e0 :: rs ++ [d] = l0 ++ f :: g :: r -> In (f, g) (combine (e0 :: rs) (rs ++ [d]))).
    { induction rs as [| h t IH]; intros e0 l0 E.
      - destruct l0 as [| a l0]; simpl in E; [injection E as -> -> _; left; reflexivity |]. injection E as _ E.
        apply (f_equal (@length Point)) in E. rewrite app_length in E. simpl in E. lia.
      - destruct l0 as [| a l0]; simpl in E; [injection E as -> -> _; left; reflexivity |]. injection E as _ E. right. exact (IH h l0 E). }
    exact (G rest e l H). }
  assert (J : exists v2, In ((f, g), v2) (after ++ before)).
  { assert (B : neighbours (directions V) = (d, e) :: combine (e :: rest) (rest ++ [d])) by (rewrite SD; reflexivity).
    assert (Y : map fst (corners V) = neighbours (directions V)).
    { unfold corners. assert (G : forall (l0 : list (Point * Point)) (r0 : list Point), length l0 = length r0 -> map fst (combine l0 r0) = l0).
      { induction l0 as [| h t IH]; intros r0 Lr; destruct r0; simpl in *; try discriminate; [reflexivity |]. rewrite IH; [reflexivity | lia]. }
      apply G. rewrite corners_length, rotate1_length. reflexivity. }
    rewrite SC, B in Y. apply (f_equal (@tl (Point * Point))) in Y.
    change (map fst (after ++ before) = combine (e :: rest) (rest ++ [d])) in Y. rewrite <- Y in I. apply in_map_iff in I as ([[f' g'] v2] & E & I). simpl in E.
    injection E as -> ->. exists v2. assumption. }
  destruct J as (v2 & J).
  assert (EQ : v = v2).
  { apply (one_top V k (d, e) v (f, g) v2 CV); try assumption; try (rewrite SC; left; reflexivity); try (rewrite SC; right; assumption); reflexivity. }
  subst v2. rewrite SC in ND. simpl in ND. apply NoDup_cons_iff in ND as [ND _]. apply ND. apply in_map_iff. exists ((f, g), v). auto.
Qed.

(** A shape is valid if and only if it is strictly convex, counter-clockwise, and in range. *)
Theorem valid_if_and_only_if_convex vertices :
  isValid vertices = true <-> strictlyConvex vertices /\ (forall v, In v vertices -> inRange v = true).
Proof.
  split.
  - intros V. split; [apply valid_is_convex; assumption |]. unfold isValid in V. rewrite !andb_true_iff, !forallb_forall in V. tauto.
  - intros [C R]. apply convex_is_valid; assumption.
Qed.
