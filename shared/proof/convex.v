(** Convex::fault is empty if and only if the shape is strictly convex, counter-clockwise and in range. *)
From Coq Require Import ZArith List Lia Bool.
From Platon Require Import point obstacle obstacle_exact polygon winding.
Import ListNotations.
Open Scope Z_scope.

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
