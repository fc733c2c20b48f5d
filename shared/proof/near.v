(** The segments that suffice: the half planes that are relevant for a box (Obstacle::findRelevant), and the segments
    that are near to a leg (Collider::isNearLeg). *)
From Coq Require Import ZArith QArith List Lia Lqa Bool.
From Platon Require Import fraction point obstacle convex collision.
Import ListNotations.
Open Scope Z_scope.

(** ** Relevant half planes *)

Definition isInBox (area : Box) (p : Place) : Prop :=
  (inject_Z (x (low area)) <= px p <= inject_Z (x (high area)))%Q /\
  (inject_Z (y (low area)) <= py p <= inject_Z (y (high area)))%Q.

(** The corner of the box that is farthest along the normal. *)
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

(** A place in the box is inside of all half planes if it is inside of those that are relevant. *)
Theorem relevant_suffice area hs p : isInBox area p ->
  ((forall h, In h hs -> isIn h p) <-> forall h, In h hs -> isRelevant area h = true -> isIn h p).
Proof.
  intros [X Y]. split; [auto |]. intros A h H. destruct (isRelevant area h) eqn:R; [auto |].
  unfold isRelevant in R. apply Z.leb_gt in R. unfold isIn, dotQ.
  pose proof (farthest_along (x (normal h)) _ _ _ X) as FX. pose proof (farthest_along (y (normal h)) _ _ _ Y) as FY.
  unfold dot, farthest in R; cbn [x y] in R. apply inject_lt in R. rewrite !inject_Z_plus in R. change (inject_Z 0) with 0%Q in R. lra.
Qed.

(** ** Segments near to a leg *)

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
