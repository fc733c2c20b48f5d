(** What a sweep may leave out: half planes that are not relevant for a box (Obstacle::visitRelevant), all of them if one
    is known to exclude the path (Sweep::isExcluded), and the products with the position (Sweep::clipToSegment). *)
From Coq Require Import ZArith QArith List Lia Lqa Bool.
From Platon Require Import fraction sweep sweep_exact point obstacle collision boxes.
Import ListNotations.
Open Scope Z_scope.

(** ** Half planes that contain the whole box *)

Definition isInBox (area : Box) (p : Place) : Prop :=
  (inject_Z (x (low area)) <= px p <= inject_Z (x (high area)))%Q /\
  (inject_Z (y (low area)) <= py p <= inject_Z (y (high area)))%Q.

(** The corner of the box that is farthest along the normal: Obstacle::findRelevant *)
Definition farthest (n : Point) (area : Box) : Point :=
  point (if 0 <? x n then x (high area) else x (low area)) (if 0 <? y n then y (high area) else y (low area)).
Definition isRelevant (area : Box) (h : HalfPlane) : bool := 0 <=? dot (normal h) (farthest (normal h) area) + offset h.

Lemma farthest_along (n l u : Z) (q : Q) : (inject_Z l <= q <= inject_Z u)%Q ->
  (inject_Z n * q <= inject_Z (n * (if 0 <? n then u else l)))%Q.
Proof.
  intros [L U]. rewrite inject_Z_mult. destruct (Z.ltb_spec 0 n) as [N | N].
  - apply (inject_lt 0) in N. change (inject_Z 0) with 0%Q in N. set (m := inject_Z n) in *. clearbody m. nra.
  - apply inject_le in N. change (inject_Z 0) with 0%Q in N. set (m := inject_Z n) in *. clearbody m. nra.
Qed.

Lemma irrelevant_contains area h p : isInBox area p -> isRelevant area h = false -> isIn h p.
Proof.
  intros [X Y] R. unfold isRelevant in R. apply Z.leb_gt in R. unfold isIn, dotQ.
  pose proof (farthest_along (x (normal h)) _ _ _ X) as FX. pose proof (farthest_along (y (normal h)) _ _ _ Y) as FY.
  unfold dot, farthest in R; cbn [x y] in R. apply inject_lt in R. rewrite !inject_Z_plus in R.
  change (inject_Z 0) with 0%Q in R. lra.
Qed.

(** A place in the box is inside of all half planes if it is inside of those that are relevant. *)
Theorem relevant_suffice area hs p : isInBox area p ->
  ((forall h, In h hs -> isIn h p) <-> forall h, In h hs -> isRelevant area h = true -> isIn h p).
Proof.
  intros A. split; [auto |]. intros I h H. destruct (isRelevant area h) eqn:R; [auto |].
  exact (irrelevant_contains area h p A R).
Qed.

(** Sweep::clipToHalfPlanes, which visits some half planes, in their order and with their numbers. *)
Fixpoint clipVisitedFrom (visits : nat -> bool) (interval : ClipInterval) (index : nat) (distances : list EndDistances) :=
  match distances with
  | [] => if isEmpty interval then None else Some interval
  | first :: others =>
      match (if visits index then intersect interval first index else Some interval) with
      | None => None
      | Some next => clipVisitedFrom visits next (S index) others
      end
  end.
Definition clipVisited (visits : nat -> bool) (distances : list EndDistances) : option ClipInterval :=
  clipVisitedFrom visits whole 0 distances.

(** It may leave out those that contain both ends of the path. *)
Theorem visited_suffice visits distances :
  (forall k d, nth_error distances k = Some d -> visits k = false -> start d < 0 /\ finish d < 0) ->
  clipVisited visits distances = clip distances.
Proof.
  unfold clipVisited, clip. intros A.
  assert (G : forall rest index interval,
    (forall k d, nth_error rest k = Some d -> visits (index + k)%nat = false -> start d < 0 /\ finish d < 0) ->
    clipVisitedFrom visits interval index rest = clipFrom interval index rest).
  { induction rest as [| d rest IH]; intros index interval B; [reflexivity |]. cbn [clipVisitedFrom clipFrom].
    assert (E : (if visits index then intersect interval d index else Some interval) = intersect interval d index).
    { destruct (visits index) eqn:V; [reflexivity |].
      destruct (B 0%nat d eq_refl) as [S F]; [rewrite Nat.add_0_r; assumption |].
      unfold intersect. apply Z.ltb_lt in S, F. rewrite S, F. reflexivity. }
    rewrite E. destruct (intersect interval d index) as [next |]; [| reflexivity].
    apply IH. intros k e K V. apply (B (S k) e K). rewrite <- plus_n_Sm. exact V. }
  apply G. exact A.
Qed.

(** A half plane is visited if it is relevant for a box that contains both ends of the path. Others may be, too. *)
Theorem clip_of_relevant_is_clip vertices s position displacement margin area visits : 0 <= margin ->
  isInBox area (pathAt position displacement 0) -> isInBox area (pathAt position displacement 1) ->
  (forall k h, nth_error (halfPlanes vertices s) k = Some h -> isRelevant area h = true -> visits k = true) ->
  clipVisited visits (distances vertices s position displacement margin) = clipAgainst vertices s position displacement margin.
Proof.
  intros M A B V. apply visited_suffice. intros k d D K. unfold distances in D. rewrite nth_error_map in D.
  destruct (nth_error (halfPlanes vertices s) k) as [h |] eqn:H; [| discriminate]. injection D as <-.
  assert (R : isRelevant area h = false) by (destruct (isRelevant area h) eqn:R; [rewrite (V k h H R) in K; discriminate | reflexivity]).
  assert (W : 0 <= oneNorm (normal h) * margin) by (apply Z.mul_nonneg_nonneg; unfold oneNorm; lia).
  assert (G : forall t, isInBox area (pathAt position displacement t) ->
    (distanceAt (endDistancesTo position displacement margin h) t < 0)%Q).
  { intros t I. rewrite distance_is_of_place. pose proof (irrelevant_contains area h _ I R) as J. unfold isIn in J.
    unfold shifted; cbn [normal offset]. rewrite inject_sub. apply (inject_le 0) in W. change (inject_Z 0) with 0%Q in W.
    set (o := inject_Z (oneNorm (normal h) * margin)) in *. clearbody o. lra. }
  pose proof (G 0%Q A) as G0. pose proof (G 1%Q B) as G1. unfold distanceAt in G0, G1.
  set (d := endDistancesTo position displacement margin h) in *. clearbody d. rewrite inject_sub in *.
  split; apply inject_lt; change (inject_Z 0) with 0%Q; lra.
Qed.

(** ** A half plane that was kept *)

(** Sweep::isExcluded *)
Definition isExcluded (position displacement : Point) (margin : Z) (h : HalfPlane) : bool :=
  let d := endDistancesTo position displacement margin h in (0 <=? start d) && (0 <=? finish d).

(** If one half plane of an obstacle excludes the path, whichever it is, the path misses. *)
Theorem excluded_is_miss vertices s position displacement margin h : In h (halfPlanes vertices s) ->
  isExcluded position displacement margin h = true -> clipAgainst vertices s position displacement margin = None.
Proof.
  intros H E. unfold isExcluded in E. apply andb_true_iff in E as [S F]. apply Z.leb_le in S, F.
  apply miss_is_exact. intros t T J. apply (outside_throughout (endDistancesTo position displacement margin h) t S F T).
  apply J. apply in_map. assumption.
Qed.

(** ** Relative to the position *)

(** Sweep::clipToSegment moves the segment, not the shape. Each half plane keeps its normal, and its offset becomes its
    distance at the position. So half.offset - dot(half.normal, position_) in Sweep::clip is the offset of the half
    plane of the segment itself. *)
Definition relativeTo (position : Point) (s : Segment) : Segment := segment (minus (a s) position) (minus (b s) position).
Definition relativeHalfPlane (position : Point) (h : HalfPlane) : HalfPlane :=
  halfPlane (normal h) (offset h + dot (normal h) position).

Lemma dot_minus n p q : dot n (minus p q) = dot n p - dot n q.
Proof. unfold dot, minus; cbn [x y]. ring. Qed.

Lemma relative_edge s e position : edgeHalfPlane (relativeTo position s) e = relativeHalfPlane position (edgeHalfPlane s e).
Proof. unfold edgeHalfPlane, relativeHalfPlane, relativeTo; cbn [a b normal offset]. rewrite !dot_minus. f_equal. lia. Qed.

Lemma relative_difference s position : minus (b (relativeTo position s)) (a (relativeTo position s)) = minus (b s) (a s).
Proof. unfold relativeTo, minus; cbn [a b x y]. f_equal; lia. Qed.

Lemma relative_sides vertices s position :
  sideHalfPlanes vertices (relativeTo position s) = map (relativeHalfPlane position) (sideHalfPlanes vertices s).
Proof.
  unfold sideHalfPlanes. rewrite relative_difference. set (left := perpendicular _). clearbody left.
  unfold relativeTo, relativeHalfPlane; cbn [a map normal offset]. rewrite dot_minus, dot_opposite.
  f_equal; [f_equal; lia | do 2 f_equal; lia].
Qed.

Theorem relative_half_planes vertices s position :
  halfPlanes vertices (relativeTo position s) = map (relativeHalfPlane position) (halfPlanes vertices s).
Proof.
  unfold halfPlanes. rewrite map_app, map_map. f_equal.
  - assert (E : isPoint (relativeTo position s) = isPoint s).
    { unfold isPoint, relativeTo, minus; cbn [a b x y]. apply eq_true_iff_eq. rewrite !andb_true_iff, !Z.eqb_eq. lia. }
    rewrite E. destruct (isPoint s); [reflexivity | apply relative_sides].
  - apply map_ext. intros e. apply relative_edge.
Qed.

(** So the clip is the same as that of a prebuilt obstacle. *)
Theorem relative_clip vertices s position displacement margin :
  clipAgainst vertices (relativeTo position s) (point 0 0) displacement margin = clipAgainst vertices s position displacement margin.
Proof.
  unfold clipAgainst, distances. rewrite relative_half_planes, map_map. f_equal. apply map_ext. intros h.
  unfold endDistancesTo, relativeHalfPlane; cbn [normal offset]. assert (E : dot (normal h) (point 0 0) = 0) by (unfold dot; cbn [x y]; ring).
  rewrite E. f_equal; lia.
Qed.
