(** A shape that moves along a straight path and a segment: Sweep::against in shared/physics/sweep.cpp. *)
From Coq Require Import ZArith QArith List Lia Lqa Bool.
From Platon Require Import fraction sweep point obstacle.
Import ListNotations.
Open Scope Z_scope.

(** Obstacle::HalfPlane::oneNorm *)
Definition oneNorm (n : Point) : Z := Z.abs (x n) + Z.abs (y n).

(** Sweep::endDistancesTo, of a path from [position] by [displacement] *)
Definition endDistancesTo (position displacement : Point) (margin : Z) (h : HalfPlane) : EndDistances :=
  let start := dot (normal h) position + offset h - oneNorm (normal h) * margin in
  end_distances start (start + dot (normal h) displacement).

Definition distances (vertices : list Point) (s : Segment) (position displacement : Point) (margin : Z) : list EndDistances :=
  map (endDistancesTo position displacement margin) (halfPlanes vertices s).

(** Sweep::clip *)
Definition clipAgainst vertices s position displacement margin : option ClipInterval :=
  clip (distances vertices s position displacement margin).

(** Where the path is at a time. *)
Definition pathAt (position displacement : Point) (t : Q) : Place :=
  place (inject_Z (x position) + t * inject_Z (x displacement)) (inject_Z (y position) + t * inject_Z (y displacement)).

(** A half plane, moved outwards by the margin. *)
Definition shifted (margin : Z) (h : HalfPlane) : HalfPlane := halfPlane (normal h) (offset h - oneNorm (normal h) * margin).

Lemma distance_is_of_place position displacement margin h t :
  (distanceAt (endDistancesTo position displacement margin h) t ==
    dotQ (normal (shifted margin h)) (pathAt position displacement t) + inject_Z (offset (shifted margin h)))%Q.
Proof.
  unfold distanceAt, endDistancesTo, pathAt, shifted, dotQ; cbn [start finish px py normal offset]. rewrite Z.add_simpl_l.
  unfold dot. rewrite !inject_sub, !inject_Z_plus, !inject_Z_mult. ring.
Qed.

Lemma inside_is_in_all vertices s position displacement margin t :
  isInside (distances vertices s position displacement margin) t <->
  forall h, In h (halfPlanes vertices s) -> isIn (shifted margin h) (pathAt position displacement t).
Proof.
  unfold isInside, distances. split.
  - intros A h H. unfold isIn. rewrite <- distance_is_of_place. apply A. apply in_map. assumption.
  - intros A d D. apply in_map_iff in D as (h & <- & H). rewrite distance_is_of_place. apply A. assumption.
Qed.

Lemma not_shifted h : shifted 0 h = h.
Proof. destruct h. unfold shifted; simpl. f_equal. lia. Qed.

Lemma inside_is_overlap vertices s position displacement t : strictlyConvex vertices ->
  (isInside (distances vertices s position displacement 0) t <-> overlaps vertices s (pathAt position displacement t)).
Proof.
  intros C. rewrite inside_is_in_all, (obstacle_is_exact _ _ _ C).
  split; intros A h H; specialize (A h H); rewrite not_shifted in *; assumption.
Qed.

(** ** The theorems: what the sweep says is true of the shape and the segment *)

(** Whether the moving shape overlaps the segment at a time. *)
Definition overlapsAt vertices s position displacement t : Prop := overlaps vertices s (pathAt position displacement t).

Theorem misses_exactly vertices s position displacement : strictlyConvex vertices ->
  (clipAgainst vertices s position displacement 0 = None <->
   forall t, during t -> ~ overlapsAt vertices s position displacement t).
Proof.
  intros C. unfold clipAgainst. rewrite miss_is_exact.
  split; intros A t T O; apply (A t T); apply inside_is_overlap; assumption.
Qed.

Theorem begins_inside_exactly vertices s position displacement i : strictlyConvex vertices ->
  clipAgainst vertices s position displacement 0 = Some i ->
  (entered i = None <-> overlapsAt vertices s position displacement 0).
Proof. intros C R. rewrite (start_is_exact _ _ R). apply inside_is_overlap. assumption. Qed.

Theorem hits_exactly vertices s position displacement i k : strictlyConvex vertices ->
  clipAgainst vertices s position displacement 0 = Some i -> entered i = Some k ->
  (0 <= value (enter i) < 1)%Q /\
  (forall t, during t -> (t <= value (enter i))%Q -> ~ overlapsAt vertices s position displacement t) /\
  (forall t, (value (enter i) < t)%Q -> (t < value (exit i))%Q -> overlapsAt vertices s position displacement t) /\
  (endsInside i = false ->
    forall t, during t -> (value (exit i) <= t)%Q -> ~ overlapsAt vertices s position displacement t) /\
  (endsInside i = true <-> overlapsAt vertices s position displacement 1).
Proof.
  intros C R H. split; [| split; [| split; [| split]]].
  - exact (time_is_in_range _ _ R).
  - intros t T L O. apply (outside_until_hit _ _ _ t R H T L). apply inside_is_overlap; assumption.
  - intros t A B. apply inside_is_overlap; [assumption |]. exact (inside_until_exit _ _ t R A B).
  - intros E t T L O. apply (outside_after_exit _ _ t R E T L). apply inside_is_overlap; assumption.
  - rewrite (end_is_exact _ _ R). apply inside_is_overlap. assumption.
Qed.

(** The normal of a hit is that of the first half plane, in their order, of those entered last. The path leads into it,
    and is on its boundary at the time of the hit. *)
Theorem normal_of_hit vertices s position displacement i k :
  clipAgainst vertices s position displacement 0 = Some i -> entered i = Some k ->
  exists h, nth_error (halfPlanes vertices s) k = Some h /\ dot (normal h) displacement < 0 /\
    (dotQ (normal h) (pathAt position displacement (value (enter i))) + inject_Z (offset h) == 0)%Q.
Proof.
  intros R H. destruct (hit_plane _ _ _ R H) as (d & N & E & T & F & _).
  unfold distances in N. rewrite nth_error_map in N. destruct (nth_error (halfPlanes vertices s) k) as [h |] eqn:M; [| discriminate].
  injection N as <-. exists h. split; [reflexivity |]. split; [simpl in F; lia |].
  pose proof (distance_is_of_place position displacement 0 h (value (enter i))) as D. rewrite not_shifted in D. rewrite <- D.
  rewrite T. pose proof (value_times _ (enterTime_valid _ E)) as V. cbn [enterTime numerator denominator] in V.
  unfold distanceAt. rewrite inject_sub in *. set (u := inject_Z (start _)) in *. set (w := inject_Z (finish _)) in *.
  set (z := value _) in *. clearbody u w z. lra.
Qed.
(** The same with a margin, of the half planes moved outwards. *)
Theorem misses_exactly_with_margin vertices s position displacement margin :
  clipAgainst vertices s position displacement margin = None <->
  forall t, during t -> ~ (forall h, In h (halfPlanes vertices s) -> isIn (shifted margin h) (pathAt position displacement t)).
Proof.
  unfold clipAgainst. rewrite miss_is_exact.
  split; intros A t T O; apply (A t T); apply inside_is_in_all; assumption.
Qed.

(** ** Rejection by boxes *)

Record Box := box { low : Point; high : Point }.
Definition overlapsBox (p q : Box) : bool :=
  (x (low p) <=? x (high q)) && (x (low q) <=? x (high p)) && (y (low p) <=? y (high q)) && (y (low q) <=? y (high p)).
(** Convex::bounds, boundsOf of a segment, and Sweep::bounds without a margin *)
Definition leftwards := point (-1) 0.
Definition boundsOfShape (vertices : list Point) : Box :=
  box (point (lowest (point 1 0) vertices) (lowest (point 0 1) vertices))
      (point (highest (point 1 0) vertices) (highest (point 0 1) vertices)).
Definition boundsOf (s : Segment) : Box :=
  box (point (Z.min (x (a s)) (x (b s))) (Z.min (y (a s)) (y (b s))))
      (point (Z.max (x (a s)) (x (b s))) (Z.max (y (a s)) (y (b s)))).
Definition boundsOfSweep (vertices : list Point) (position displacement : Point) : Box :=
  let shape := boundsOfShape vertices in
  box (point (x position + Z.min 0 (x displacement) + x (low shape)) (y position + Z.min 0 (y displacement) + y (low shape)))
      (point (x position + Z.max 0 (x displacement) + x (high shape)) (y position + Z.max 0 (y displacement) + y (high shape))).

Lemma between_ends (u v : Z) (share : Q) : (0 <= share <= 1)%Q ->
  (inject_Z (Z.min u v) <= inject_Z u + share * inject_Z (v - u) <= inject_Z (Z.max u v))%Q.
Proof.
  intros [S0 S1]. rewrite inject_sub.
  pose proof (proj2 (inject_le _ _) (Z.le_min_l u v)) as A. pose proof (proj2 (inject_le _ _) (Z.le_min_r u v)) as B.
  pose proof (proj2 (inject_le _ _) (Z.le_max_l u v)) as C. pose proof (proj2 (inject_le _ _) (Z.le_max_r u v)) as D.
  set (p := inject_Z u) in *. set (q := inject_Z v) in *. set (l := inject_Z (Z.min u v)) in *. set (h := inject_Z (Z.max u v)) in *.
  clearbody p q l h. split; nra.
Qed.

Lemma inside_bounds vertices q : vertices <> [] -> strictlyInside vertices q ->
  (inject_Z (x (low (boundsOfShape vertices))) <= px q <= inject_Z (x (high (boundsOfShape vertices))))%Q /\
  (inject_Z (y (low (boundsOfShape vertices))) <= py q <= inject_Z (y (high (boundsOfShape vertices))))%Q.
Proof.
  intros NE S. unfold boundsOfShape; cbn [x y low high].
  assert (L : forall n, n <> point 0 0 -> (inject_Z (lowest n vertices) < dotQ n q)%Q).
  { intros n N. destruct (surrounded vertices q n NE S N) as (v & V & G).
    destruct (lowest_spec n vertices NE) as [A _]. specialize (A v V). apply inject_le in A. lra. }
  assert (H : forall n, n <> point 0 0 -> (dotQ n q < inject_Z (highest n vertices))%Q).
  { intros n N. assert (N' : opposite n <> point 0 0).
    { intros E. apply N. destruct n as [nx ny]. unfold opposite in E; simpl in E. injection E as E1 E2. f_equal; lia. }
    destruct (surrounded vertices q (opposite n) NE S N') as (v & V & G). rewrite dotQ_opposite, dot_opposite, inject_Z_opp in G.
    destruct (highest_spec n vertices NE) as [A _]. specialize (A v V). apply inject_le in A. lra. }
  pose proof (L (point 1 0) ltac:(discriminate)) as L1. pose proof (L (point 0 1) ltac:(discriminate)) as L2.
  pose proof (H (point 1 0) ltac:(discriminate)) as H1. pose proof (H (point 0 1) ltac:(discriminate)) as H2.
  unfold dotQ in *; cbn [x y] in *. change (inject_Z 1) with 1%Q in *. change (inject_Z 0) with 0%Q in *.
  split; split; lra.
Qed.

Theorem boxes_reject_soundly vertices s position displacement t : vertices <> [] -> during t ->
  overlaps vertices s (pathAt position displacement t) ->
  overlapsBox (boundsOfSweep vertices position displacement) (boundsOf s) = true.
Proof.
  intros NE T (share & R & S). destruct (inside_bounds _ _ NE S) as [X Y].
  unfold minusQ, along, pathAt in X, Y; cbn [px py] in X, Y.
  pose proof (between_ends (x (a s)) (x (b s)) share R) as XS. pose proof (between_ends (y (a s)) (y (b s)) share R) as YS.
  pose proof (between_ends 0 (x displacement) t T) as XD. pose proof (between_ends 0 (y displacement) t T) as YD.
  rewrite Z.sub_0_r in XD, YD. change (inject_Z 0) with 0%Q in XD, YD.
  unfold overlapsBox, boundsOfSweep, boundsOf; cbn [x y low high].
  rewrite !andb_true_iff, !Z.leb_le.
  set (shape := boundsOfShape vertices) in *.
  repeat split; apply inject_le; rewrite ?inject_Z_plus; lra.
Qed.
