(** A shape that moves along a straight path and a segment: Sweep::against in shared/physics/sweep.cpp. *)
From Coq Require Import ZArith QArith List Lia Lqa Bool.
From Platon Require Import fraction sweep clip_known sweep_exact point obstacle obstacle_exact.
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

(** The shape overlaps the segment after [enter], or from the start if no half plane is entered, and before [exit], or to
    the end if it ends inside; at no other time of the move. *)
Theorem hits_exactly vertices s position displacement i : strictlyConvex vertices ->
  clipAgainst vertices s position displacement 0 = Some i ->
  (0 <= value (enter i))%Q /\ (value (enter i) < value (exit i) <= 1)%Q /\
  (entered i = None -> enter i = fraction 0 1) /\ (endsInside i = true -> exit i = fraction 1 1) /\
  (forall t, during t -> (overlapsAt vertices s position displacement t <->
    ((value (enter i) < t)%Q \/ entered i = None) /\ ((t < value (exit i))%Q \/ endsInside i = true))).
Proof.
  intros C R. pose proof (time_is_in_range _ _ R) as A. pose proof (exit_is_in_range _ _ R) as B.
  pose proof (clip_known (distances vertices s position displacement 0)) as K. unfold clipAgainst in R. rewrite R in K. destruct K as [K _].
  split; [lra |]. split; [exact B |]. split; [apply (starts_inside _ _ K) |]. split; [apply (ends_in _ _ K) |].
  intros t T. unfold overlapsAt. rewrite <- (inside_is_overlap _ _ _ _ _ C), (inside_is_between _ _ _ K T). unfold isBetween.
  destruct (entered i), (endsInside i); intuition congruence.
Qed.

(** The path leads into the half plane that is entered, and is on its boundary at the time of the hit. *)
Theorem entered_half_plane vertices s position displacement i k :
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
