(** What Convex::fault checks, in shared/physics/convex.cpp, and what is known of closed lists of edges. *)
From Coq Require Import ZArith List Lia Bool.
From Platon Require Import point obstacle obstacle_exact.
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
