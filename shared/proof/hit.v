(** The collision that belongs to the result of a clip: Sweep::hitOf in shared/physics/sweep.cpp. *)
From Coq Require Import ZArith QArith List Lia Lqa Bool.
From Platon Require Import fraction sweep point obstacle collision.
Import ListNotations.
Open Scope Z_scope.

(** Hit and Hit::Side. Two names end in _, as their own belong to ClipInterval and to HalfPlane. *)
Inductive Side := kInside | kSegment | kSegmentEnd.
Record Hit := hit { time : Fraction; exit_ : Fraction; normal_ : Point; feature : Point; side : Side }.

(** ** The function: the branches of the C++, in its order *)

Definition makeHit (interval : ClipInterval) (normal feature : Point) (side : Side) : Hit :=
  hit (enter interval) (exit interval) normal feature side.

Definition origin := point 0 0.
Definition insideHit (interval : ClipInterval) : Hit := makeHit interval origin origin kInside.

(** The hit of an edge of the shape, which is given by its number. *)
Definition edgeHit (interval : ClipInterval) (vertices : list Point) (number : nat) (s : Segment) : Hit :=
  let normal := inwards (nth number (edges vertices) (edge origin 0)) in
  let along := dot normal (minus (b s) (a s)) in
  if (along =? 0) && negb (isPoint s) then makeHit interval normal (nth number vertices origin) kSegment
  else makeHit interval normal (if 0 <? along then b s else a s) kSegmentEnd.

(** Obstacle::sideFeature; [lowest] of the C++ is the product of [best]. *)
Definition sideFeature (vertices : list Point) (normal : Point) : Point :=
  fold_left (fun best v => if dot normal v <? dot normal best then v else best) vertices (hd origin vertices).

(** Sweep::hitOf *)
Definition hitOf (vertices : list Point) (s : Segment) (interval : ClipInterval) : Hit :=
  match entered interval with
  | None => insideHit interval
  | Some k =>
      let sides := if isPoint s then 0%nat else 2%nat in
      if (sides <=? k)%nat then edgeHit interval vertices (k - sides) s
      else
        let left := perpendicular (minus (b s) (a s)) in
        let normal := if (k =? 0)%nat then left else opposite left in
        makeHit interval normal (sideFeature vertices normal) kSegment
  end.

(** ** The feature of a side *)

(** It is a vertex, none has a smaller product with the normal, and those before it have larger ones. *)
Theorem feature_of_side vertices n : vertices <> [] ->
  exists before after, vertices = before ++ sideFeature vertices n :: after /\
    (forall v, In v vertices -> dot n (sideFeature vertices n) <= dot n v) /\
    (forall v, In v before -> dot n (sideFeature vertices n) < dot n v).
Proof.
  intros NE. unfold sideFeature. set (f := fun best v => if dot n v <? dot n best then v else best).
  assert (T : forall p q, dot n q < dot n p -> f p q = q) by (intros p q L; unfold f; apply Z.ltb_lt in L; rewrite L; reflexivity).
  assert (K : forall p q, dot n p <= dot n q -> f p q = p) by (intros p q L; unfold f; apply Z.ltb_ge in L; rewrite L; reflexivity).
  clearbody f. (* Of a vertex and those that follow: *)
  assert (G : forall l first, exists before after, first :: l = before ++ fold_left f l first :: after /\
    (forall v, In v (first :: l) -> dot n (fold_left f l first) <= dot n v) /\
    (forall v, In v before -> dot n (fold_left f l first) < dot n v)).
  { induction l as [| v l IH]; intros first; cbn [fold_left].
    - exists [], []. split; [reflexivity |]. split; [intros v [<- | []]; lia | intros v []].
    - destruct (Z.lt_ge_cases (dot n v) (dot n first)) as [L | L]; [rewrite (T _ _ L) | rewrite (K _ _ L)].
      + destruct (IH v) as (before & after & E & M & S). set (best := fold_left f l v) in *. clearbody best.
        pose proof (M v (or_introl eq_refl)) as Mv. exists (first :: before), after. split; [rewrite E; reflexivity |].
        split; intros w [<- | W]; [lia | apply M; assumption | lia | apply S; assumption].
      + destruct (IH first) as (before & after & E & M & S). set (best := fold_left f l first) in *. clearbody best.
        pose proof (M first (or_introl eq_refl)) as Mf. destruct before as [| first' before]; injection E as <- E.
        * exists [], (v :: l). split; [reflexivity |]. split; [| intros w []].
          intros w [<- | [<- | W]]; [lia | lia | apply M; right; assumption].
        * exists (first :: v :: before), after. split; [rewrite E; reflexivity |].
          pose proof (S first (or_introl eq_refl)) as Sf.
          split; intros w [<- | [<- | W]]; [lia | lia | apply M; right; assumption | lia | lia | apply S; right; assumption]. }
  destruct vertices as [| h t]; [congruence |]. cbn [hd fold_left].
  rewrite (K h h (Z.le_refl _)). apply G.
Qed.

Lemma feature_is_lowest vertices n : vertices <> [] -> dot n (sideFeature vertices n) = lowest n vertices.
Proof.
  intros NE. destruct (feature_of_side vertices n NE) as (before & after & E & M & _).
  destruct (lowest_spec n vertices NE) as [L (v & V & Q)]. specialize (M v V).
  assert (F : In (sideFeature vertices n) vertices) by (rewrite E at 2; apply in_app_iff; right; left; reflexivity).
  specialize (L _ F). lia.
Qed.

(** ** The half plane of a hit *)

(* A side of the segment, *)
Definition isSideHit vertices s (h : HalfPlane) (i : ClipInterval) : Prop :=
  isPoint s = false /\ (normal h = perpendicular (minus (b s) (a s)) \/ normal h = opposite (perpendicular (minus (b s) (a s)))) /\
  offset h = lowest (normal h) vertices - dot (normal h) (a s) /\
  hitOf vertices s i = makeHit i (normal h) (sideFeature vertices (normal h)) kSegment.

(* or an edge of the shape. *)
Definition isEdgeHit vertices s (h : HalfPlane) (i : ClipInterval) : Prop :=
  exists ends, In ends (neighbours vertices) /\ h = edgeHalfPlane s (edgeOf ends) /\
    let along := dot (normal h) (minus (b s) (a s)) in
    hitOf vertices s i =
      if (along =? 0) && negb (isPoint s) then makeHit i (normal h) (fst ends) kSegment
      else makeHit i (normal h) (if 0 <? along then b s else a s) kSegmentEnd.

Lemma nth_combine {A B} (l : list A) : forall (r : list B) k pair, nth_error (combine l r) k = Some pair -> nth_error l k = Some (fst pair).
Proof.
  induction l as [| u l IH]; intros r k pair H; [destruct k; discriminate |]. destruct r as [| w r]; [destruct k; discriminate |].
  destruct k as [| k]; cbn in *; [injection H as <-; reflexivity | exact (IH r k pair H)].
Qed.

Lemma edge_hit vertices s i k h : nth_error (map (edgeHalfPlane s) (edges vertices)) k = Some h ->
  hitOf vertices s i = edgeHit i vertices k s -> isEdgeHit vertices s h i.
Proof.
  unfold edges. rewrite map_map, nth_error_map. intros N H.
  destruct (nth_error (neighbours vertices) k) as [ends |] eqn:E; [| discriminate]. injection N as <-.
  exists ends. split; [exact (nth_error_In _ _ E) |]. split; [reflexivity |]. cbn zeta. rewrite H. unfold edgeHit.
  assert (N : nth_error (edges vertices) k = Some (edgeOf ends)) by (unfold edges; rewrite nth_error_map, E; reflexivity).
  rewrite (nth_error_nth _ _ _ N), (nth_error_nth _ _ _ (nth_combine _ _ _ _ E)). reflexivity.
Qed.

Lemma hit_of_half_plane vertices s i k h : entered i = Some k -> nth_error (halfPlanes vertices s) k = Some h ->
  isSideHit vertices s h i \/ isEdgeHit vertices s h i.
Proof.
  intros E N. assert (H : hitOf vertices s i = hitOf vertices s i) by reflexivity. unfold hitOf in H at 2. rewrite E in H.
  unfold halfPlanes in N. destruct (isPoint s) eqn:P; cbn [Nat.leb] in H.
  - right. apply (edge_hit _ _ _ k); [exact N |]. rewrite H, Nat.sub_0_r. reflexivity.
  - destruct k as [| [| k]]; cbn in N.
    + left. injection N as <-. repeat split; auto.
    + left. injection N as <-. repeat split; auto. cbn [normal offset]. rewrite highest_is_lowest, dot_opposite. lia.
    + right. apply (edge_hit _ _ _ k); [exact N |]. rewrite H. cbn [Nat.leb]. do 2 f_equal. lia.
Qed.

Lemma half_plane_of_hit vertices s position displacement i :
  clipAgainst vertices s position displacement 0 = Some i -> side (hitOf vertices s i) <> kInside ->
  exists k h, entered i = Some k /\ (isSideHit vertices s h i \/ isEdgeHit vertices s h i) /\
    nth_error (halfPlanes vertices s) k = Some h /\ dot (normal h) displacement < 0 /\
    (dotQ (normal h) (pathAt position displacement (value (enter i))) + inject_Z (offset h) == 0)%Q.
Proof.
  intros R S. destruct (entered i) as [k |] eqn:E; [| exfalso; apply S; unfold hitOf; rewrite E; reflexivity].
  destruct (entered_half_plane _ _ _ _ _ _ R E) as (h & N & F & B). exists k, h.
  split; [reflexivity |]. split; [exact (hit_of_half_plane _ _ _ _ _ E N) | auto].
Qed.

(** ** The theorems *)

(** The times are those of the clip. *)
Theorem times_of_hit vertices s i : time (hitOf vertices s i) = enter i /\ exit_ (hitOf vertices s i) = exit i.
Proof.
  unfold hitOf, edgeHit, insideHit. cbv zeta. destruct (entered i) as [k |]; [| auto].
  destruct (_ <=? k)%nat; [destruct (_ && _) |]; auto.
Qed.

(** A hit is "inside" if and only if the shape overlaps the segment at the start. *)
Theorem side_tells_the_start vertices s position displacement i : strictlyConvex vertices ->
  clipAgainst vertices s position displacement 0 = Some i ->
  (side (hitOf vertices s i) = kInside <-> overlapsAt vertices s position displacement 0).
Proof.
  intros C R. rewrite <- (begins_inside_exactly _ _ _ _ _ C R). unfold hitOf, edgeHit, insideHit. cbv zeta.
  destruct (entered i) as [k |]; [| cbn; tauto].
  destruct (_ <=? k)%nat; [destruct (_ && _) |]; cbn; (split; discriminate).
Qed.

(** The normal is (0, 0) if the hit is "inside". Otherwise the path leads against it, so that it is not (0, 0), and it is
    that of a half plane of the obstacle, on whose boundary the path is at the time of the hit. *)
Theorem normal_of_hit vertices s position displacement i :
  clipAgainst vertices s position displacement 0 = Some i ->
  let h := hitOf vertices s i in
  (side h = kInside -> normal_ h = point 0 0) /\
  (side h <> kInside -> dot (normal_ h) displacement < 0 /\
    exists half, In half (halfPlanes vertices s) /\ normal half = normal_ h /\
      (dotQ (normal half) (pathAt position displacement (value (time h))) + inject_Z (offset half) == 0)%Q).
Proof.
  intros R. cbv zeta. rewrite (proj1 (times_of_hit _ _ _)). split.
  - unfold hitOf, edgeHit, insideHit. cbv zeta. destruct (entered i) as [k |]; [| reflexivity].
    destruct (_ <=? k)%nat; [destruct (_ && _) |]; discriminate.
  - intros S. destruct (half_plane_of_hit _ _ _ _ _ R S) as (k & h & _ & H & N & V & B).
    assert (M : normal_ (hitOf vertices s i) = normal h).
    { destruct H as [(_ & _ & _ & ->) | (ends & _ & _ & ->)]; [reflexivity |]. destruct (_ && _); reflexivity. }
    rewrite M. split; [assumption |]. exists h. split; [exact (nth_error_In _ _ N) | auto].
Qed.
