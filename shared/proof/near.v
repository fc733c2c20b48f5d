(** The segments that are near to a leg suffice for a move beside it: Collider::isNearLeg, isFreeInLeg. *)
From Coq Require Import ZArith QArith List Lia Lqa Bool.
From Platon Require Import fraction sweep point obstacle obstacle_exact polygon collision boxes rounding.
Import ListNotations.
Open Scope Z_scope.

(** ** Near in the frame of the home instance *)

Definition squared (p : Place) : Q := (px p * px p + py p * py p)%Q.
Definition squaredLength (p : Point) : Z := x p * x p + y p * y p.
Definition maxNorm (p : Point) : Z := Z.max (Z.abs (x p)) (Z.abs (y p)).
Definition kBeside := 6.
Definition kNear := 12.

(** Collider::isNearLeg, of a leg from [from] to [to] *)
Definition isNearLeg (from to at_ : Point) : bool :=
  let moved := minus at_ from in
  let path := minus to from in
  ((x at_ =? x to) && (y at_ =? y to)) ||
  (maxNorm moved <=? kBeside) || (maxNorm (minus at_ to) <=? kBeside) ||
  (negb ((x path =? 0) && (y path =? 0)) &&
   (0 <=? dot path moved) && (dot path moved <=? squaredLength path) && (Z.abs (cross path moved) <=? kBeside * maxNorm path)).

Lemma small_square (p : Point) (t : Q) : (0 <= t <= 1)%Q -> maxNorm p <= kBeside ->
  (squared (place (t * inject_Z (x p)) (t * inject_Z (y p))) <= 72)%Q.
Proof.
  unfold maxNorm, kBeside, squared; cbn [px py]. intros [T0 T1] M.
  assert (X : (inject_Z (x p) * inject_Z (x p) <= 36)%Q) by (rewrite <- inject_Z_mult; apply (inject_le _ 36); nia).
  assert (Y : (inject_Z (y p) * inject_Z (y p) <= 36)%Q) by (rewrite <- inject_Z_mult; apply (inject_le _ 36); nia).
  set (u := inject_Z (x p)) in *. set (w := inject_Z (y p)) in *. clearbody u w.
  assert (T : (t * t <= 1)%Q) by nra. assert (U : (0 <= u * u)%Q) by nra. assert (W : (0 <= w * w)%Q) by nra.
  assert (A : (t * t * (u * u) <= 1 * (u * u))%Q) by (apply Qmult_le_compat_r; assumption).
  assert (B : (t * t * (w * w) <= 1 * (w * w))%Q) by (apply Qmult_le_compat_r; assumption).
  assert (E : (t * u * (t * u) + t * w * (t * w) == t * t * (u * u) + t * t * (w * w))%Q) by ring. rewrite E. lra.
Qed.

(** Each place of a move that is near to a leg is within 6 times the root of 2 of a place of the leg. *)
Theorem near_is_near from to at_ t : isNearLeg from to at_ = true -> (0 <= t <= 1)%Q ->
  exists r, (0 <= r <= 1)%Q /\
    (squared (minusQ (pathAt from (minus at_ from) t) (pathAt from (minus to from) r)) <= 72)%Q.
Proof.
  intros H T. assert (D : forall r, (squared (minusQ (pathAt from (minus at_ from) t) (pathAt from (minus to from) r)) ==
    squared (place (t * inject_Z (x at_ - x from) - r * inject_Z (x to - x from)) (t * inject_Z (y at_ - y from) - r * inject_Z (y to - y from))))%Q).
  { intros r. unfold squared, minusQ, pathAt, minus; cbn [x y px py]. ring. }
  unfold isNearLeg in H. rewrite !orb_true_iff, !andb_true_iff, negb_true_iff, !Z.eqb_eq, !Z.leb_le in H.
  destruct H as [[[[X Y] | M] | M] | [[[N A] B] C]].
  - exists t. split; [assumption |]. rewrite D, X, Y. unfold squared; cbn [px py].
    assert (E : ((t * inject_Z (x to - x from) - t * inject_Z (x to - x from)) * (t * inject_Z (x to - x from) - t * inject_Z (x to - x from)) +
      (t * inject_Z (y to - y from) - t * inject_Z (y to - y from)) * (t * inject_Z (y to - y from) - t * inject_Z (y to - y from)) == 0)%Q) by ring.
    rewrite E. lra.
  - exists 0%Q. split; [lra |]. rewrite D. pose proof (small_square (minus at_ from) t T M) as S.
    unfold squared, minus in *; cbn [x y px py] in *.
    set (u := inject_Z (x at_ - x from)) in *. set (w := inject_Z (y at_ - y from)) in *. clearbody u w. lra.
  - exists t. split; [assumption |]. rewrite D. pose proof (small_square (minus at_ to) t T M) as S.
    unfold squared, minus in *; cbn [x y px py] in *. rewrite !inject_sub in *. lra.
  - (* the foot of the place on the leg *)
    set (path := minus to from) in *. set (moved := minus at_ from) in *.
    assert (L : 0 < squaredLength path).
    { unfold squaredLength. apply andb_false_iff in N as [N | N]; apply Z.eqb_neq in N; nia. }
    assert (K : cross path moved * cross path moved <= 36 * squaredLength path).
    { unfold kBeside, squaredLength in *. assert (maxNorm path * maxNorm path <= x path * x path + y path * y path) by (unfold maxNorm; nia).
      assert (0 <= maxNorm path) by (unfold maxNorm; lia).
      assert (Z.abs (cross path moved) * Z.abs (cross path moved) <= (6 * maxNorm path) * (6 * maxNorm path)) by nia.
      rewrite Z.abs_square in *. nia. }
    set (l := inject_Z (squaredLength path)). assert (LQ : (0 < l)%Q) by (apply (inject_lt 0); assumption).
    set (along := inject_Z (dot path moved)). assert (AQ : (0 <= along)%Q) by (apply (inject_le 0); assumption).
    assert (BQ : (along <= l)%Q) by (apply inject_le; assumption).
    assert (NL : ~ (l == 0)%Q) by (intros E; rewrite E in LQ; apply (Qlt_irrefl 0); exact LQ).
    assert (R : (0 <= along / l <= 1)%Q) by (split; [apply Qle_shift_div_l; lra | apply Qle_shift_div_r; lra]).
    exists (t * (along / l))%Q. split; [split; nra |]. rewrite D.
    assert (KQ : (inject_Z (cross path moved) * inject_Z (cross path moved) <= 36 * l)%Q).
    { unfold l. rewrite <- inject_Z_mult. change 36%Q with (inject_Z 36). rewrite <- inject_Z_mult. apply inject_le. assumption. }
    set (c := inject_Z (cross path moved)) in *.
    (* the rest is across the leg *)
    assert (F : (squared (place (t * inject_Z (x at_ - x from) - t * (along / l) * inject_Z (x to - x from))
      (t * inject_Z (y at_ - y from) - t * (along / l) * inject_Z (y to - y from))) == t * t * (c * c / l))%Q).
    { unfold squared; cbn [px py]. unfold c, along, l, cross, dot, squaredLength in *. unfold path, moved, minus in *; cbn [x y] in *.
      unfold Z.sub in *. repeat (rewrite inject_Z_plus || rewrite inject_Z_opp || rewrite inject_Z_mult).
      field. intros E. apply NL. repeat (rewrite inject_Z_plus || rewrite inject_Z_opp || rewrite inject_Z_mult). rewrite <- E. ring. }
    rewrite F. assert (G : (c * c / l <= 36)%Q) by (apply Qle_shift_div_r; lra).
    assert (G0 : (0 <= c * c / l)%Q) by (apply Qle_shift_div_l; [assumption | nra]).
    set (g := (c * c / l)%Q) in *. clearbody g. destruct T as [T0 T1]. assert (t * t <= 1)%Q by nra. nra.
Qed.

Lemma square_positive (q : Q) : (0 <= q * q)%Q.
Proof. nra. Qed.

(** In the frame of an instance: rotated, by a cosine and a sine that are rounded, and with the roundings of both places,
    each less than a subunit along both axes together, it is within 12 subunits. *)
Theorem near_in_every_frame (c s u v ex ey : Q) : (c * c + s * s <= 101 # 100)%Q -> (u * u + v * v <= 72)%Q ->
  (ex * ex + ey * ey <= 2)%Q ->
  ((c * u - s * v + ex) * (c * u - s * v + ex) + (s * u + c * v + ey) * (s * u + c * v + ey) <= 144)%Q.
Proof.
  intros R D E. set (a := (c * u - s * v)%Q). set (b := (s * u + c * v)%Q).
  assert (L : (a * a + b * b == (c * c + s * s) * (u * u + v * v))%Q) by (unfold a, b; ring).
  assert (P : (0 <= u * u + v * v)%Q) by nra.
  assert (M : (a * a + b * b <= (101 # 100) * 72)%Q).
  { rewrite L. apply Qle_trans with ((101 # 100) * (u * u + v * v))%Q.
    - apply Qmult_le_compat_r; assumption.
    - apply (Qmult_le_l _ _ (101 # 100)); [reflexivity | exact D]. }
  clearbody a b. clear L.
  assert (S : (0 <= (a - 5 * ex) * (a - 5 * ex) + (b - 5 * ey) * (b - 5 * ey))%Q).
  { pose proof (square_positive (a - 5 * ex)). pose proof (square_positive (b - 5 * ey)). lra. }
  assert (F : ((a + ex) * (a + ex) + (b + ey) * (b + ey) == a * a + b * b + 2 * (a * ex + b * ey) + (ex * ex + ey * ey))%Q) by ring.
  assert (G : ((a - 5 * ex) * (a - 5 * ex) + (b - 5 * ey) * (b - 5 * ey) ==
    a * a + b * b - 10 * (a * ex + b * ey) + 25 * (ex * ex + ey * ey))%Q) by ring.
  rewrite F. rewrite G in S. set (t := (a * ex + b * ey)%Q) in *. set (m := (a * a + b * b)%Q) in *.
  set (e := (ex * ex + ey * ey)%Q) in *. clearbody t m e. lra.
Qed.

(** A place within 12 subunits of one that overlaps a segment is inside of all half planes moved outwards by 12. *)
Theorem near_is_within_margin h p q : isIn h p -> (squared (minusQ q p) <= 144)%Q -> isIn (shifted kNear h) q.
Proof.
  unfold isIn, shifted, squared, minusQ, dotQ, kNear; cbn [normal offset px py]. intros I D.
  set (nx := inject_Z (x (normal h))) in *. set (ny := inject_Z (y (normal h))) in *.
  rewrite inject_sub, inject_Z_mult. change (inject_Z 12) with 12%Q.
  set (o := inject_Z (oneNorm (normal h))). set (k := inject_Z (offset h)) in *.
  set (u := (px q - px p)%Q) in *. set (v := (py q - py p)%Q) in *.
  assert (O : (0 <= o)%Q) by (apply (inject_le 0); unfold oneNorm; lia).
  assert (N : (nx * nx + ny * ny <= o * o)%Q).
  { unfold nx, ny, o. rewrite <- !inject_Z_mult, <- inject_Z_plus. apply inject_le. unfold oneNorm.
    pose proof (Z.abs_nonneg (x (normal h))). pose proof (Z.abs_nonneg (y (normal h))).
    rewrite <- (Z.abs_square (x (normal h))), <- (Z.abs_square (y (normal h))). nia. }
  assert (E : (nx * px q + ny * py q == nx * px p + ny * py p + (nx * u + ny * v))%Q) by (unfold u, v; ring).
  rewrite E. assert (W : (nx * u + ny * v <= 12 * o)%Q); [| lra].
  (* Cauchy and Schwarz *)
  assert (CS : ((nx * u + ny * v) * (nx * u + ny * v) <= (nx * nx + ny * ny) * (u * u + v * v))%Q).
  { assert (0 <= (nx * v - ny * u) * (nx * v - ny * u))%Q by apply square_positive.
    assert (F : ((nx * nx + ny * ny) * (u * u + v * v) == (nx * u + ny * v) * (nx * u + ny * v) + (nx * v - ny * u) * (nx * v - ny * u))%Q) by ring.
    rewrite F. lra. }
  set (w := (nx * u + ny * v)%Q) in *. set (n := (nx * nx + ny * ny)%Q) in *. set (d := (u * u + v * v)%Q) in *.
  assert (N0 : (0 <= n)%Q) by (unfold n; pose proof (square_positive nx); pose proof (square_positive ny); lra).
  assert (D0 : (0 <= d)%Q) by (unfold d; pose proof (square_positive u); pose proof (square_positive v); lra). clearbody w n d. clear E.
  assert (B : (n * d <= o * o * 144)%Q).
  { apply Qle_trans with (o * o * d)%Q; [apply Qmult_le_compat_r; assumption |].
    assert (0 <= o * o)%Q by nra. set (m := (o * o)%Q) in *. clearbody m. nra. }
  apply Qnot_lt_le. intros L. assert (0 <= 12 * o)%Q by lra.
  assert (12 * o * (12 * o) < w * w)%Q by nra. lra.
Qed.

(** ** In the frame of an instance *)

(** Rotation, with 30 fractional bits, and Placement. *)
Record Rotation := rotation { cosine : Z; sine : Z }.
Record Placement := placement { fromHome : Rotation; homeAnchor : Point; anchor : Point }.

Definition rotate (v : Point) (r : Rotation) : Point :=
  point (shiftRounded 30 (x v * cosine r - y v * sine r)) (shiftRounded 30 (x v * sine r + y v * cosine r)).
(** Placement::at *)
Definition placeOf (f : Placement) (home : Point) : Point :=
  let moved := rotate (minus home (homeAnchor f)) (fromHome f) in point (x (anchor f) + x moved) (y (anchor f) + y moved).

(** The rotation by 0°, which the C++ does not carry out, changes nothing. *)
Theorem rotation_by_none v : rotate v (rotation (2 ^ 30) 0) = v.
Proof.
  assert (E : forall n, shiftRounded 30 (n * 2 ^ 30) = n).
  { intros n. rewrite shiftRounded_is_divideRounded by lia. destruct (divideRounded_is_nearest (n * 2 ^ 30) (2 ^ 30) ltac:(lia)) as [A _].
    set (q := divideRounded _ _) in *. clearbody q. change (2 ^ 30) with 1073741824 in *. lia. }
  destruct v as [vx vy]. unfold rotate; cbn [x y cosine sine]. rewrite !Z.mul_0_r, Z.sub_0_r, Z.add_0_l, !E. reflexivity.
Qed.

(** A vector grows by less than half a percent when it is rotated. What rotationOf gives for each angle is a rotation: a test
    asks for all (AngleTest.IsARotationAsTheProofDefinesIt). *)
Definition isRotation (r : Rotation) : Prop :=
  Z.abs (cosine r) <= 2 ^ 30 /\ Z.abs (sine r) <= 2 ^ 30 /\ 100 * (cosine r * cosine r + sine r * sine r) <= 101 * 2 ^ 60.

Lemma rounded_by_half n : exists e, (- (1 # 2) <= e <= 1 # 2)%Q /\ (inject_Z (shiftRounded 30 n) == inject_Z n / inject_Z (2 ^ 30) + e)%Q.
Proof.
  rewrite shiftRounded_is_divideRounded by lia. destruct (divideRounded_is_nearest n (2 ^ 30) ltac:(lia)) as [A _].
  set (q := divideRounded n (2 ^ 30)) in *. clearbody q. exists (inject_Z q - inject_Z n / inject_Z (2 ^ 30))%Q. split; [| ring].
  change (2 ^ 30) with 1073741824 in *. assert (B : - 1073741824 <= 2 * (q * 1073741824 - n) <= 1073741824) by lia. destruct B as [L U].
  apply inject_le in L, U. rewrite inject_Z_mult, inject_sub, inject_Z_mult in L, U.
  change (inject_Z 1073741824) with (1073741824 # 1)%Q in *. change (inject_Z (-1073741824)) with (-1073741824 # 1)%Q in *.
  change (inject_Z 2) with (2 # 1)%Q in *. set (u := inject_Z q) in *. set (w := inject_Z n) in *. clearbody u w.
  assert (E : (w / (1073741824 # 1) == w * (1 # 1073741824))%Q) by reflexivity. rewrite E. split; lra.
Qed.

Definition scaled (n : Z) : Q := (inject_Z n / inject_Z (2 ^ 30))%Q.

Lemma place_in_frame f p : exists ex ey, (- (1 # 2) <= ex <= 1 # 2)%Q /\ (- (1 # 2) <= ey <= 1 # 2)%Q /\
  let c := scaled (cosine (fromHome f)) in let s := scaled (sine (fromHome f)) in
  let u := inject_Z (x p - x (homeAnchor f)) in let v := inject_Z (y p - y (homeAnchor f)) in
  (inject_Z (x (placeOf f p)) == inject_Z (x (anchor f)) + (c * u - s * v + ex))%Q /\
  (inject_Z (y (placeOf f p)) == inject_Z (y (anchor f)) + (s * u + c * v + ey))%Q.
Proof.
  unfold placeOf, rotate, minus; cbn [x y].
  set (u := x p - x (homeAnchor f)). set (v := y p - y (homeAnchor f)). set (cz := cosine (fromHome f)). set (sz := sine (fromHome f)).
  destruct (rounded_by_half (u * cz - v * sz)) as (ex & EX & X). destruct (rounded_by_half (u * sz + v * cz)) as (ey & EY & Y).
  exists ex, ey. split; [exact EX | split; [exact EY |]]. cbv zeta. rewrite !inject_Z_plus, X, Y, inject_sub, inject_Z_plus, !inject_Z_mult.
  unfold scaled, Qdiv. set (k := (/ inject_Z (2 ^ 30))%Q). clearbody k. split; ring.
Qed.

(* Of three roundings, at most the sum of two remains. *)
Lemma roundings_remain t r a b g : (0 <= t <= 1)%Q -> (0 <= r <= 1)%Q -> (- (1 # 2) <= a <= 1 # 2)%Q -> (- (1 # 2) <= b <= 1 # 2)%Q ->
  (- (1 # 2) <= g <= 1 # 2)%Q -> let e := (t * (g - a) - r * (b - a))%Q in (e * e <= 1)%Q.
Proof.
  intros T R A B G e. assert (E : (-1 <= e <= 1)%Q); [| nra].
  assert (M : forall w z, (0 <= w)%Q -> (- (1 # 2) <= z <= 1 # 2)%Q -> (- (1 # 2) * w <= w * z <= (1 # 2) * w)%Q).
  { intros w z W Z0. assert (0 <= w * (z + (1 # 2)))%Q by (apply Qmult_le_0_compat; lra).
    assert (0 <= w * ((1 # 2) - z))%Q by (apply Qmult_le_0_compat; lra). lra. }
  pose proof (M t g ltac:(lra) G) as TG. pose proof (M r b ltac:(lra) B) as RB.
  assert (F : (e == t * g - r * b + (r - t) * a)%Q) by (unfold e; ring). rewrite F.
  destruct (Qlt_le_dec r t) as [L | L].
  - pose proof (M (t - r)%Q a ltac:(lra) A) as D. assert (N : ((r - t) * a == - ((t - r) * a))%Q) by ring. rewrite N. lra.
  - pose proof (M (r - t)%Q a ltac:(lra) A) as D. lra.
Qed.

(* The difference between a place of one straight move of an instance and a place of another, which begins at the same place:
   that of the home instance, rotated, and what remains of the roundings. *)
Lemma difference_in_frame f from to at_ t r : (0 <= t <= 1)%Q -> (0 <= r <= 1)%Q ->
  let d := minusQ (pathAt from (minus at_ from) t) (pathAt from (minus to from) r) in
  let c := scaled (cosine (fromHome f)) in let s := scaled (sine (fromHome f)) in
  exists ex ey, (ex * ex + ey * ey <= 2)%Q /\
    let moved := minusQ (pathAt (placeOf f from) (minus (placeOf f at_) (placeOf f from)) t)
                        (pathAt (placeOf f from) (minus (placeOf f to) (placeOf f from)) r) in
    (px moved == c * px d - s * py d + ex)%Q /\ (py moved == s * px d + c * py d + ey)%Q.
Proof.
  intros T R d c s.
  destruct (place_in_frame f from) as (ax & ay & AX & AY & EAX & EAY). destruct (place_in_frame f to) as (bx & by_ & BX & BY & EBX & EBY).
  destruct (place_in_frame f at_) as (gx & gy & GX & GY & EGX & EGY). fold c s in EAX, EAY, EBX, EBY, EGX, EGY.
  exists (t * (gx - ax) - r * (bx - ax))%Q, (t * (gy - ay) - r * (by_ - ay))%Q. split.
  - pose proof (roundings_remain t r ax bx gx T R AX BX GX) as X. pose proof (roundings_remain t r ay by_ gy T R AY BY GY) as Y.
    cbv zeta in X, Y. lra.
  - unfold d, minusQ, pathAt, minus; cbn [x y px py]. rewrite !inject_sub, EAX, EAY, EBX, EBY, EGX, EGY, !inject_sub. clearbody c s. split; ring.
Qed.

Lemma scaled_rotation f : isRotation f -> (scaled (cosine f) * scaled (cosine f) + scaled (sine f) * scaled (sine f) <= 101 # 100)%Q.
Proof.
  intros (_ & _ & H). apply inject_le in H. rewrite !inject_Z_mult, inject_Z_plus, !inject_Z_mult in H.
  unfold scaled, Qdiv. set (u := inject_Z (cosine f)) in *. set (w := inject_Z (sine f)) in *. clearbody u w.
  set (k := (/ inject_Z (2 ^ 30))%Q). assert (K : (k * k * inject_Z (2 ^ 60) == 1)%Q) by reflexivity.
  assert (P : (0 <= k * k)%Q) by (vm_compute; discriminate).
  change (inject_Z 100) with (100 # 1)%Q in H. change (inject_Z 101) with (101 # 1)%Q in H.
  set (z := inject_Z (2 ^ 60)) in *. clearbody k z.
  assert (M : (0 <= k * k * ((101 # 1) * z - (100 # 1) * (u * u + w * w)))%Q) by (apply Qmult_le_0_compat; lra).
  assert (E : (k * k * ((101 # 1) * z - (100 # 1) * (u * u + w * w)) == (101 # 1) * (k * k * z) - (100 # 1) * (u * k * (u * k) + w * k * (w * k)))%Q) by ring.
  rewrite E, K in M. lra.
Qed.

(** Wherever an instance overlaps a segment on a move that is near to a leg, the segment is near to the leg: neither its box
    nor the clip of the leg, both with the margin kNear, exclude it. So it is enough to compare the move with those. *)
Theorem near_segments_suffice f from to at_ vertices s t : strictlyConvex vertices -> isRotation (fromHome f) ->
  isNearLeg from to at_ = true -> during t ->
  overlapsAt vertices s (placeOf f from) (minus (placeOf f at_) (placeOf f from)) t ->
  overlapsBox (boundsOfSweep vertices (placeOf f from) (minus (placeOf f to) (placeOf f from)) kNear) (boundsOf s) = true /\
  clipAgainst vertices s (placeOf f from) (minus (placeOf f to) (placeOf f from)) kNear <> None.
Proof.
  intros C K N T O. destruct (near_is_near from to at_ t N T) as (r & R & D).
  destruct (difference_in_frame f from to at_ t r T R) as (ex & ey & E & X & Y).
  pose proof (near_in_every_frame _ _ _ _ _ _ (scaled_rotation _ K) D E) as W. unfold overlapsAt in O.
  set (p := pathAt (placeOf f from) (minus (placeOf f at_) (placeOf f from)) t) in *.
  set (q := pathAt (placeOf f from) (minus (placeOf f to) (placeOf f from)) r) in *.
  rewrite <- X, <- Y in W. unfold minusQ in W; cbn [px py] in W.
  split.
  - apply (boxes_with_margin_reject_soundly vertices s _ _ kNear r p); [destruct C as (L & _); destruct vertices; [simpl in L; lia | discriminate] | exact R | | exact O].
    fold q. unfold isBeside, kNear. change (inject_Z 12) with (12 # 1)%Q. set (u := (px p - px q)%Q) in *. set (v := (py p - py q)%Q) in *.
    clearbody u v. clear - W. pose proof (square_positive u). pose proof (square_positive v). split; nra.
  - intros M. apply (proj1 (misses_exactly_with_margin vertices s _ _ kNear) M r R). intros h H. fold q.
    apply (near_is_within_margin h p q); [apply (proj1 (obstacle_is_exact vertices s p C) O h H) |].
    unfold squared, minusQ; cbn [px py]. apply Qle_trans with (2 := W). apply Qle_lteq. right. ring.
Qed.
