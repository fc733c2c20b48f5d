(** The obstacle of a segment for a convex shape: shared/physics/obstacle.cpp. *)
From Coq Require Import ZArith QArith List Lia Lqa.
From Platon Require Import fraction point.
Import ListNotations.
Open Scope Z_scope.

(** ** Definitions *)

(** Obstacle::HalfPlane: the positions p with dot normal p + offset < 0. *)
Record HalfPlane := halfPlane { normal : Point; offset : Z }.
Definition isIn (h : HalfPlane) (p : Place) : Prop := (dotQ (normal h) p + inject_Z (offset h) < 0)%Q.

Record Segment := segment { a : Point; b : Point }.

(** An edge of a shape: Convex::deriveFromVertices. The normal points into the shape. *)
Record Edge := edge { inwards : Point; support : Z }.
Definition edgeOf (ends : Point * Point) : Edge :=
  let n := perpendicular (minus (snd ends) (fst ends)) in edge n (dot n (fst ends)).
Definition edges (vertices : list Point) : list Edge := map edgeOf (neighbours vertices).

(** Obstacle::edgeHalfPlane *)
Definition edgeHalfPlane (s : Segment) (e : Edge) : HalfPlane :=
  halfPlane (inwards e) (support e - Z.max (dot (inwards e) (a s)) (dot (inwards e) (b s))).

(** Obstacle::sideHalfPlanes *)
Definition lowest (n : Point) (vertices : list Point) : Z :=
  fold_left (fun low v => Z.min low (dot n v)) vertices (dot n (hd (point 0 0) vertices)).
Definition highest (n : Point) (vertices : list Point) : Z :=
  fold_left (fun high v => Z.max high (dot n v)) vertices (dot n (hd (point 0 0) vertices)).
Definition opposite (n : Point) : Point := point (- x n) (- y n).
Definition sideHalfPlanes (vertices : list Point) (s : Segment) : list HalfPlane :=
  let left := perpendicular (minus (b s) (a s)) in
  let height := dot left (a s) in
  [halfPlane left (lowest left vertices - height); halfPlane (opposite left) (height - highest left vertices)].

(** All half planes of an obstacle, in their order. *)
Definition isPoint (s : Segment) : bool := (x (a s) =? x (b s)) && (y (a s) =? y (b s)).
Definition halfPlanes (vertices : list Point) (s : Segment) : list HalfPlane :=
  (if isPoint s then [] else sideHalfPlanes vertices s) ++ map (edgeHalfPlane s) (edges vertices).

(** ** What they mean *)

(** A place is strictly inside of a shape: strictly to the left of every edge. *)
Definition strictlyInside (vertices : list Point) (p : Place) : Prop :=
  forall e, In e (edges vertices) -> (inject_Z (support e) < dotQ (inwards e) p)%Q.

(** The points of a segment. *)
Definition along (s : Segment) (share : Q) : Place :=
  place (inject_Z (x (a s)) + share * inject_Z (x (b s) - x (a s)))
        (inject_Z (y (a s)) + share * inject_Z (y (b s) - y (a s))).

(** The shape at the position p overlaps the segment. *)
Definition overlaps (vertices : list Point) (s : Segment) (p : Place) : Prop :=
  exists share, (0 <= share <= 1)%Q /\ strictlyInside vertices (minusQ (along s share) p).

(** Strictly convex and counter-clockwise: every vertex is to the left of every edge, but for its ends. *)
Definition isLeftOf (ends : Point * Point) (v : Point) : Z :=
  dot (perpendicular (minus (snd ends) (fst ends))) (minus v (fst ends)).
Definition strictlyConvex (vertices : list Point) : Prop :=
  (3 <= length vertices)%nat /\ NoDup vertices /\
  forall ends v, In ends (neighbours vertices) -> In v vertices -> v <> fst ends -> v <> snd ends -> 0 < isLeftOf ends v.

(** ** Products along a segment *)

Lemma dotQ_along n s share :
  (dotQ n (along s share) == inject_Z (dot n (a s)) + share * inject_Z (dot n (b s) - dot n (a s)))%Q.
Proof.
  unfold dotQ, along, dot; simpl. unfold Z.sub. rewrite !inject_Z_plus, !inject_Z_opp, !inject_Z_plus, !inject_Z_mult.
  ring.
Qed.

Lemma along_at_most n s share : (0 <= share <= 1)%Q ->
  (dotQ n (along s share) <= inject_Z (Z.max (dot n (a s)) (dot n (b s))))%Q.
Proof.
  intros [H0 H1]. rewrite dotQ_along, inject_sub.
  pose proof (proj2 (inject_le _ _) (Z.le_max_l (dot n (a s)) (dot n (b s)))) as A.
  pose proof (proj2 (inject_le _ _) (Z.le_max_r (dot n (a s)) (dot n (b s)))) as B.
  set (u := inject_Z (dot n (a s))) in *. set (v := inject_Z (dot n (b s))) in *.
  set (m := inject_Z (Z.max _ _)) in *. nra.
Qed.

Lemma lowest_spec n vertices : vertices <> [] ->
  (forall v, In v vertices -> lowest n vertices <= dot n v) /\ (exists v, In v vertices /\ lowest n vertices = dot n v).
Proof.
  intros H. destruct vertices as [| h t]; [congruence |]. unfold lowest; simpl hd.
  assert (G : forall l z, (forall v, In v l -> fold_left (fun low v => Z.min low (dot n v)) l z <= dot n v) /\
    fold_left (fun low v => Z.min low (dot n v)) l z <= z /\
    (fold_left (fun low v => Z.min low (dot n v)) l z = z \/
     exists v, In v l /\ fold_left (fun low v => Z.min low (dot n v)) l z = dot n v)).
  { induction l as [| h' t' IH]; intros z; simpl; [split; [intros _ [] | split; [lia | auto]] |].
    destruct (IH (Z.min z (dot n h'))) as (P & Q & R). split; [| split].
    - intros v [<- | Hv]; [lia | auto].
    - lia.
    - destruct R as [R | (v & Hv & R)]; [| right; exists v; auto].
      destruct (Z.min_spec z (dot n h')) as [[_ M] | [_ M]]; [left; lia | right; exists h'; split; [auto | lia]]. }
  destruct (G (h :: t) (dot n h)) as (P & _ & R). split; [exact P |].
  destruct R as [R | R]; [| exact R]. exists h. split; [left; reflexivity | exact R].
Qed.

Lemma dotQ_opposite n q : (dotQ (opposite n) q == - dotQ n q)%Q.
Proof. unfold dotQ, opposite; simpl. rewrite !inject_Z_opp. ring. Qed.

Lemma dot_opposite n v : dot (opposite n) v = - dot n v.
Proof. unfold dot, opposite; simpl. ring. Qed.

(* Seen the other way round, the highest is the lowest. *)
Lemma highest_is_lowest n vertices : highest n vertices = - lowest (opposite n) vertices.
Proof.
  unfold highest, lowest. rewrite dot_opposite. generalize (dot n (hd (point 0 0) vertices)).
  induction vertices as [| h t IH]; intros z; simpl; [lia |]. rewrite IH, dot_opposite. do 2 f_equal. lia.
Qed.

Lemma highest_spec n vertices : vertices <> [] ->
  (forall v, In v vertices -> dot n v <= highest n vertices) /\ (exists v, In v vertices /\ highest n vertices = dot n v).
Proof.
  intros H. destruct (lowest_spec (opposite n) vertices H) as [A (v & V & E)]. rewrite highest_is_lowest. split.
  - intros w W. specialize (A w W). rewrite dot_opposite in A. lia.
  - exists v. split; [assumption |]. rewrite E, dot_opposite. lia.
Qed.
