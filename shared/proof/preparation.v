(** Every intermediate result of what prepares a sweep fits the C++ type in which it stands: boxes, shapes, what is near
    to a leg, and the positions of instances. *)
From Coq Require Import ZArith List Lia.
From Platon Require Import point obstacle obstacle_exact polygon boxes relevant near rounding bounds.
Import ListNotations.
Open Scope Z_scope.

(** ** Boxes, in int32 *)

Definition isBoxBelow (limit : Z) (area : Box) : Prop :=
  Z.abs (x (low area)) < limit /\ Z.abs (y (low area)) < limit /\
  Z.abs (x (high area)) < limit /\ Z.abs (y (high area)) < limit.
Definition fitsInt32 : Box -> Prop := isBoxBelow (2 ^ 31).

Lemma grown_fits limit area margin : isBoxBelow limit area -> 0 <= margin -> isBoxBelow (limit + margin) (grown margin area).
Proof. unfold isBoxBelow, grown; cbn [low high x y]. lia. Qed.

Lemma sum_below m n u v : Z.abs u < m -> Z.abs v < n -> Z.abs (u + v) < m + n - 1.
Proof. lia. Qed.

Lemma box_at_most limit more area : isBoxBelow limit area -> limit <= more -> isBoxBelow more area.
Proof. unfold isBoxBelow. lia. Qed.

(** Convex::bounds *)
Theorem shape_bounds_fit vertices : vertices <> [] -> (forall v, In v vertices -> isPoint29 v) ->
  isBoxBelow (2 ^ 29) (boundsOfShape vertices).
Proof.
  intros NE V. unfold boundsOfShape, isBoxBelow; cbn [low high x y].
  destruct (lowest_spec (point 1 0) _ NE) as [_ (p & P & ->)]. destruct (lowest_spec (point 0 1) _ NE) as [_ (q & Q & ->)].
  destruct (highest_spec (point 1 0) _ NE) as [_ (r & R & ->)]. destruct (highest_spec (point 0 1) _ NE) as [_ (t & T & ->)].
  apply V in P, Q, R, T. unfold dot; cbn [x y]. clear V NE. numbers.
Qed.

(** Sweep::start: path_, which is Box{position, position}.swept(displacement) *)
Definition pathBox (position displacement : Point) : Box :=
  box (point (x position + Z.min 0 (x displacement)) (y position + Z.min 0 (y displacement)))
      (point (x position + Z.max 0 (x displacement)) (y position + Z.max 0 (y displacement))).

Theorem path_fits from to : isPoint29 from -> isPoint29 to -> isBoxBelow (2 ^ 29) (pathBox from (minus to from)).
Proof. unfold isBoxBelow, pathBox, minus; cbn [low high x y]. numbers. Qed.

(** Sweep::start: bounds_, path_ plus the bounds of the shape and then the margin *)
Theorem sweep_bounds_fit vertices from to margin : vertices <> [] -> (forall v, In v vertices -> isPoint29 v) ->
  isPoint29 from -> isPoint29 to -> 0 <= margin ->
  isBoxBelow (2 ^ 30 - 1) (boundsOfSweep vertices from (minus to from) 0) /\
  isBoxBelow (2 ^ 30 - 1 + margin) (boundsOfSweep vertices from (minus to from) margin).
Proof.
  intros NE V P Q M. pose proof (shape_bounds_fit _ NE V) as S. pose proof (path_fits _ _ P Q) as R.
  set (around := fun m => boundsOfSweep vertices from (minus to from) m).
  assert (B : forall m, 0 <= m -> isBoxBelow (2 ^ 30 - 1 + m) (around m)).
  { intros m W. unfold around, boundsOfSweep. apply grown_fits; [| assumption].
    unfold pathBox, isBoxBelow in *; cbn [low high x y] in *. change (2 ^ 30 - 1) with (2 ^ 29 + 2 ^ 29 - 1).
    repeat split; apply sum_below; tauto. }
  split; [apply (B 0); lia | apply (B margin); assumption].
Qed.

(** Collider: sweep_.bounds().grown(kRegionMargin), with a margin up to 2^30 - 7; Tolerances::kNear is 12 *)
Definition kRegionMargin := 8.

Theorem region_fits vertices from to margin : vertices <> [] -> (forall v, In v vertices -> isPoint29 v) ->
  isPoint29 from -> isPoint29 to -> 0 <= margin <= 2 ^ 30 - 7 ->
  fitsInt32 (grown kRegionMargin (boundsOfSweep vertices from (minus to from) margin)).
Proof.
  intros NE V P Q M. destruct (sweep_bounds_fit _ _ _ margin NE V P Q ltac:(lia)) as [_ B].
  apply (grown_fits _ _ kRegionMargin) in B; [| discriminate]. apply (box_at_most _ _ _ B).
  unfold kRegionMargin. clear - M. powers. lia.
Qed.

(** With a larger margin it does not fit. *)
Theorem region_limit : let far := point (2 ^ 29 - 1) 0 in
  ~ fitsInt32 (grown kRegionMargin (boundsOfSweep [far] far (point 0 0) (2 ^ 30 - 6))).
Proof. intros far (_ & _ & H & _). discriminate H. Qed.

(** Obstacle::findRelevant: relevantMargin *)
Definition relevantMargin (shape : Box) : Z := Z.quot (x (high shape) - x (low shape)) 4.

Theorem relevant_margin_fits shape : isBoxBelow (2 ^ 29) shape -> x (low shape) <= x (high shape) ->
  below 30 (x (high shape) - x (low shape)) /\ 0 <= relevantMargin shape < 2 ^ 28.
Proof.
  unfold isBoxBelow, relevantMargin. intros S O. rewrite Z.quot_div_nonneg by lia. unfold below.
  set (w := x (high shape) - x (low shape)) in *. assert (W : 0 <= w < 2 ^ 30) by (unfold w; powers; lia).
  clearbody w. clear S O.
  pose proof (Z.div_lt_upper_bound w 4 (2 ^ 28) ltac:(lia) ltac:(powers; lia)). pose proof (Z.div_pos w 4 ltac:(lia) ltac:(lia)).
  powers. lia.
Qed.

(** Obstacle::findRelevant: relevantBox_ *)
Theorem relevant_box_fits limit positions shape : isBoxBelow limit positions -> isBoxBelow (2 ^ 29) shape ->
  x (low shape) <= x (high shape) -> isBoxBelow (limit + 2 ^ 28) (grown (relevantMargin shape) positions).
Proof.
  intros P S O. destruct (relevant_margin_fits _ S O) as [_ M].
  apply (box_at_most _ _ _ (grown_fits _ _ _ P (proj1 M))). clear - M. lia.
Qed.

(** Obstacle::findRelevant: dot(half.normal, farthest) + half.offset, in int64. A path and what is near to it is below
    2^29 + 2^12. For positions below 2^30, as the C++ says, the distance is below 1.125 * 2^62. *)
Theorem relevant_distance_fits limit h area : isNormal (normal h) -> below 61 (offset h) ->
  isBoxBelow limit area -> 0 < limit ->
  let n := normal h in let p := farthest n area in
  Z.abs (x n * x p) < 2 ^ 30 * limit /\ Z.abs (y n * y p) < 2 ^ 30 * limit /\ Z.abs (dot n p) < 2 ^ 31 * limit /\
  Z.abs (dot n p + offset h) < 2 ^ 31 * limit + 2 ^ 61.
Proof.
  intros [N M] O A L n p.
  assert (P : Z.abs (x p) < limit /\ Z.abs (y p) < limit).
  { unfold p, farthest, isBoxBelow in *; cbn [x y]. destruct (0 <? x n), (0 <? y n); lia. }
  assert (B : forall u v, below 30 u -> Z.abs v < limit -> Z.abs (u * v) < 2 ^ 30 * limit).
  { intros u v U V. rewrite Z.abs_mul. unfold below in U. apply Z.mul_lt_mono_nonneg; lia. }
  pose proof (B _ _ N (proj1 P)) as X. pose proof (B _ _ M (proj2 P)) as Y. fold n in X, Y. clearbody p. unfold dot.
  set (u := x n * x p) in *. set (w := y n * y p) in *. clearbody u w. clear B P A N M. unfold below in O. powers. lia.
Qed.

Theorem relevant_fits limit positions shape h : isBoxBelow limit positions -> 0 < limit <= 2 ^ 30 ->
  isBoxBelow (2 ^ 29) shape -> x (low shape) <= x (high shape) -> isNormal (normal h) -> below 61 (offset h) ->
  let area := grown (relevantMargin shape) positions in
  let distance := dot (normal h) (farthest (normal h) area) + offset h in
  fitsInt32 area /\ 8 * Z.abs distance < 9 * 2 ^ 62 /\ (limit <= 2 ^ 29 + 2 ^ 12 -> Z.abs distance < 2 ^ 62).
Proof.
  intros P L S E N O area distance. pose proof (relevant_box_fits _ _ _ P S E) as B. fold area in B.
  destruct (relevant_distance_fits (limit + 2 ^ 28) h area N O B ltac:(lia)) as (_ & _ & _ & D). fold distance in D.
  split; [apply (box_at_most _ _ _ B); powers; lia |]. clearbody distance. clear - D L. powers. lia.
Qed.

(** ** Shapes: Convex *)

(* The products of a cross product and their difference: those of a dot product with q turned by a quarter. *)
Lemma crosswise_fit bits p q : 0 <= bits -> isNormal p -> below bits (x q) /\ below bits (y q) ->
  below (30 + bits) (x p * y q) /\ below (30 + bits) (y p * x q) /\ below (31 + bits) (cross p q).
Proof.
  intros B N [C D]. destruct (products_fit bits p (point (y q) (- x q)) B N) as (P & Q & S);
    unfold dot, cross, below in *; cbn [x y] in *; lia.
Qed.

Lemma in_range_fits v : inRange v = true -> isPoint29 v.
Proof. unfold inRange, isCoordinate. rewrite !Bool.andb_true_iff, !Z.ltb_lt. numbers. Qed.

(** Convex::fault: cross(here - previous, next - here), in int64 *)
Theorem turn_fits previous here next : isPoint29 previous -> isPoint29 here -> isPoint29 next ->
  let p := minus here previous in let q := minus next here in
  below 60 (x p * y q) /\ below 60 (y p * x q) /\ below 61 (cross p q).
Proof. intros P H N. apply (crosswise_fit 30); [lia | |]; apply difference_fits; assumption. Qed.

(** appendChain: the same of vertices that are rotated, which may be out of range; they are below 1.5 * 2^29 *)
Definition isRotatedVertex (v : Point) : Prop := Z.abs (x v) <= 3 * 2 ^ 28 /\ Z.abs (y v) <= 3 * 2 ^ 28.

Theorem hull_turn_fits u v w : isRotatedVertex u -> isRotatedVertex v -> isRotatedVertex w ->
  fits 32 (x (minus v u)) /\ fits 32 (y (minus v u)) /\ fits 64 (cross (minus v u) (minus w v)).
Proof.
  unfold isRotatedVertex, minus, cross; cbn [x y]. intros U V W.
  assert (B : forall p q, Z.abs p <= 3 * 2 ^ 29 -> Z.abs q <= 3 * 2 ^ 29 -> Z.abs (p * q) <= 9 * 2 ^ 58).
  { intros p q P Q. rewrite Z.abs_mul. change (9 * 2 ^ 58) with (3 * 2 ^ 29 * (3 * 2 ^ 29)). apply Z.mul_le_mono_nonneg; lia. }
  pose proof (B (x v - x u) (y w - y v) ltac:(powers; lia) ltac:(powers; lia)) as P.
  pose proof (B (y v - y u) (x w - x v) ltac:(powers; lia) ltac:(powers; lia)) as Q.
  set (p := (x v - x u) * (y w - y v)) in *. set (q := (y v - y u) * (x w - x v)) in *. clearbody p q.
  unfold fits. powers. lia.
Qed.

(** Convex::deriveFromVertices: sumX and sumY, in int64, of all vertices and of the first ones at each step *)
Theorem sum_fits f vertices : (forall v, In v vertices -> below 29 (f v)) ->
  Z.abs (sumOf f vertices) <= Z.of_nat (length vertices) * (2 ^ 29 - 1).
Proof.
  induction vertices as [| h t IH]; intros V; [reflexivity |]. cbn [sumOf fold_right length]. fold (sumOf f t).
  specialize (IH (fun v I => V v (or_intror I))). specialize (V h (or_introl eq_refl)). clear - V IH. unfold below in V. lia.
Qed.

(** and its mean: the numerator of divideRounded with half the denominator, in int64, and the result, a coordinate *)
Theorem mean_fits f vertices : vertices <> [] -> Z.of_nat (length vertices) < 2 ^ 32 ->
  (forall v, In v vertices -> below 29 (f v)) ->
  let sum := sumOf f vertices in let count := Z.of_nat (length vertices) in
  fits 64 (Z.abs sum + Z.quot count 2) /\ below 29 (divideRounded sum count).
Proof.
  intros NE L V sum count. pose proof (sum_fits f _ V) as S. fold sum count in S.
  assert (C : 0 < count) by (unfold count; destruct vertices; [congruence | cbn [length]; lia]).
  fold count in L. destruct (divideRounded_is_nearest sum count C) as [D _]. rewrite Z.quot_div_nonneg by lia.
  pose proof (Z.div_lt_upper_bound count 2 (2 ^ 32) ltac:(lia) ltac:(lia)) as H.
  pose proof (Z.div_pos count 2 ltac:(lia) ltac:(lia)) as H0.
  set (c := divideRounded sum count) in *. set (h := count / 2) in *. clearbody sum count c h. clear V NE.
  split; [unfold fits; powers; nia |]. unfold below. powers. nia.
Qed.

(** ** A place near to a leg: Collider::isNearLeg *)

(** The differences and their maxNorm in int32; the sums, std::abs and kBeside * maxNorm(path) in int64. The products in
    them are below 2^60: products_fit and crosswise_fit. *)
Theorem near_leg_fits from to at_ : isPoint29 from -> isPoint29 to -> isPoint29 at_ ->
  let moved := minus at_ from in let path := minus to from in
  isNormal moved /\ isNormal path /\ maxNorm moved < 2 ^ 30 /\ maxNorm (minus at_ to) < 2 ^ 30 /\
  below 61 (dot path moved) /\ below 61 (cross path moved) /\ below 61 (Z.abs (cross path moved)) /\
  below 61 (squaredLength path) /\ below 33 (kBeside * maxNorm path).
Proof.
  intros F T A moved path. pose proof (difference_fits _ _ A F : isNormal moved) as M.
  pose proof (difference_fits _ _ T F : isNormal path) as P. pose proof (difference_fits _ _ A T) as E.
  destruct (products_fit 30 path moved ltac:(lia) P M) as (_ & _ & D).
  destruct (products_fit 30 path path ltac:(lia) P P) as (_ & _ & S).
  destruct (crosswise_fit 30 path moved ltac:(lia) P M) as (_ & _ & C).
  change (squaredLength path) with (dot path path). unfold isNormal, maxNorm, kBeside in *.
  set (u := dot path moved) in *. set (w := dot path path) in *. set (z := cross path moved) in *.
  clearbody u w z moved path. clear F T A. unfold below in *. cbn [Z.add Pos.add Pos.succ] in *. repeat split; powers; lia.
Qed.

(** ** Rotations: Placement::at *)

Lemma sum_of_rotation r : isRotation r -> Z.abs (cosine r) + Z.abs (sine r) <= 3 * 2 ^ 29.
Proof.
  intros (_ & _ & R). rewrite <- (Z.abs_square (cosine r)), <- (Z.abs_square (sine r)) in R.
  set (c := Z.abs (cosine r)) in *. set (s := Z.abs (sine r)) in *. apply Z.le_ngt. intros G.
  pose proof (Z.square_nonneg (c - s)) as D. pose proof (Z.square_lt_mono_nonneg (3 * 2 ^ 29) (c + s) ltac:(powers; lia) G) as Q.
  replace ((c + s) * (c + s)) with (c * c + s * s + 2 * (c * s)) in Q by ring.
  replace ((c - s) * (c - s)) with (c * c + s * s - 2 * (c * s)) in D by ring.
  set (cc := c * c) in *. set (ss := s * s) in *. set (cs := c * s) in *. clearbody cc ss cs. clear G. powers. lia.
Qed.

(* A coordinate of a rotated vector before it is rounded. *)
Lemma weighted_fits limit r u v : isRotation r -> Z.abs u <= limit -> Z.abs v <= limit ->
  2 * Z.abs (u * cosine r - v * sine r) <= limit * (3 * 2 ^ 30) /\ 2 * Z.abs (u * sine r + v * cosine r) <= limit * (3 * 2 ^ 30).
Proof.
  intros R U V. pose proof (sum_of_rotation r R) as W. set (c := cosine r) in *. set (s := sine r) in *. clearbody c s. clear R.
  assert (G : forall m n p q, Z.abs m <= limit -> Z.abs n <= limit -> Z.abs p + Z.abs q <= 3 * 2 ^ 29 ->
    2 * Z.abs (m * p + n * q) <= limit * (3 * 2 ^ 30)).
  { intros m n p q M N K. pose proof (Z.abs_triangle (m * p) (n * q)) as T. rewrite !Z.abs_mul in T.
    assert (Z.abs m * Z.abs p <= limit * Z.abs p) by (apply Z.mul_le_mono_nonneg_r; [apply Z.abs_nonneg | assumption]).
    assert (Z.abs n * Z.abs q <= limit * Z.abs q) by (apply Z.mul_le_mono_nonneg_r; [apply Z.abs_nonneg | assumption]).
    assert (limit * (Z.abs p + Z.abs q) <= limit * (3 * 2 ^ 29)) by (apply Z.mul_le_mono_nonneg_l; lia).
    rewrite Z.mul_add_distr_l in H1. powers. lia. }
  split; [| apply G; [assumption | assumption | lia]].
  replace (u * c - v * s) with (u * c + v * (- s)) by ring. apply G; [assumption | assumption | rewrite Z.abs_opp; lia].
Qed.

(** rotateWide of a vector below 2^31, and the sums of shiftRounded, in int64. Each product is below 2^61. *)
Theorem rotate_wide_fits r u v : isRotation r -> below 31 u -> below 31 v ->
  Z.abs (u * cosine r) < 2 ^ 61 /\ Z.abs (v * sine r) < 2 ^ 61 /\
  forall wide, wide = u * cosine r - v * sine r \/ wide = u * sine r + v * cosine r ->
    Z.abs wide < 2 ^ 62 /\ fits 64 (wide + 2 ^ 29) /\ fits 64 (wide + 2 ^ 29 - 1).
Proof.
  intros R U V. pose proof R as (C & S & _). unfold below in U, V.
  split; [rewrite Z.abs_mul; powers; nia |]. split; [rewrite Z.abs_mul; powers; nia |].
  destruct (weighted_fits (2 ^ 31 - 1) r u v R ltac:(lia) ltac:(lia)) as [P Q].
  intros wide W. assert (D : 2 * Z.abs wide <= (2 ^ 31 - 1) * (3 * 2 ^ 30)) by (destruct W as [-> | ->]; assumption).
  clear - D. unfold fits. powers. lia.
Qed.

(* A rounded coordinate of a vector below 2^30, and its sum with another one *)
Lemma rounded_fits wide other : 2 * Z.abs wide <= (2 ^ 30 - 1) * (3 * 2 ^ 30) -> below 29 other ->
  Z.abs (shiftRounded 30 wide) < 3 * 2 ^ 29 /\ fits 32 (other + shiftRounded 30 wide).
Proof.
  intros W O. rewrite shiftRounded_is_divideRounded by lia.
  destruct (divideRounded_is_nearest wide (2 ^ 30) ltac:(lia)) as [D _]. set (n := divideRounded wide _) in *. clearbody n.
  unfold below, fits in *. powers. lia.
Qed.

(** Placement::at: home - homeAnchor, rotated, and its sum with the anchor, in int32. The sum need not be a coordinate:
    StepState::isEachInRange tests that. *)
Theorem placement_fits f home : isRotation (fromHome f) -> isPoint29 home -> isPoint29 (homeAnchor f) -> isPoint29 (anchor f) ->
  let rotated := rotate (minus home (homeAnchor f)) (fromHome f) in
  isNormal (minus home (homeAnchor f)) /\ Z.abs (x rotated) < 3 * 2 ^ 29 /\ Z.abs (y rotated) < 3 * 2 ^ 29 /\
  fits 32 (x (placeOf f home)) /\ fits 32 (y (placeOf f home)).
Proof.
  intros R H O [AX AY]. pose proof (difference_fits _ _ H O : isNormal _) as M. split; [exact M |]. destruct M as [MX MY].
  unfold placeOf, rotate; cbn [x y]. set (u := x (minus _ _)) in *. set (v := y (minus _ _)) in *. clearbody u v.
  unfold below in MX, MY. destruct (weighted_fits (2 ^ 30 - 1) (fromHome f) u v R ltac:(lia) ltac:(lia)) as [P Q].
  destruct (rounded_fits _ _ P AX) as [P1 P2]. destruct (rounded_fits _ _ Q AY) as [Q1 Q2]. auto.
Qed.
