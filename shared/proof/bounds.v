(** Every intermediate result of a sweep fits the C++ type in which it stands: the bounds that
    shared/include/platon/physics/sweep.h and obstacle.h state. *)
From Coq Require Import ZArith List Lia.
From Platon Require Import sweep point obstacle obstacle_exact collision relevant.
Import ListNotations.
Open Scope Z_scope.

Definition fits (bits z : Z) : Prop := - 2 ^ (bits - 1) <= z < 2 ^ (bits - 1).
Definition below (bits z : Z) : Prop := - 2 ^ bits < z < 2 ^ bits.

(** ** What is given *)

(** Coordinates are below 2^29, and margins below 2^29, too; Tolerances::kNear is 12. *)
Definition isPoint29 (p : Point) : Prop := below 29 (x p) /\ below 29 (y p).
Definition isMargin (margin : Z) : Prop := 0 <= margin < 2 ^ 29.

Lemma product m n u v : 0 <= m -> 0 <= n -> below m u -> below n v -> - 2 ^ (m + n) < u * v < 2 ^ (m + n).
Proof.
  unfold below. intros M N U V. rewrite Z.pow_add_r by assumption.
  pose proof (Z.pow_pos_nonneg 2 m ltac:(lia) M). pose proof (Z.pow_pos_nonneg 2 n ltac:(lia) N).
  set (p := 2 ^ m) in *. set (q := 2 ^ n) in *. clearbody p q. nia.
Qed.

Lemma product_of p q n v : 0 <= p -> 0 <= q -> below p n -> below q v -> below (p + q) (n * v).
Proof. intros. apply product; assumption. Qed.

Ltac powers := repeat match goal with
  | |- context [2 ^ ?n] => let v := eval vm_compute in (2 ^ n) in change (2 ^ n) with v
  | H : context [2 ^ ?n] |- _ => let v := eval vm_compute in (2 ^ n) in change (2 ^ n) with v in H
  end.
Ltac numbers := unfold isPoint29, isMargin, fits, below in *; powers; lia.

(** ** The normals and offsets of half planes: Obstacle *)

(** An edge of a shape or a segment, and so its normal, in int32. *)
Theorem difference_fits p q : isPoint29 p -> isPoint29 q -> below 30 (x (minus p q)) /\ below 30 (y (minus p q)).
Proof. unfold minus; cbn [x y]. numbers. Qed.

Definition isNormal (n : Point) : Prop := below 30 (x n) /\ below 30 (y n).

Theorem normal_fits p q : isPoint29 p -> isPoint29 q -> isNormal (perpendicular (minus p q)).
Proof. unfold isNormal, perpendicular, minus; cbn [x y]. numbers. Qed.

Theorem normal_in_int32 n : isNormal n -> fits 32 (x n) /\ fits 32 (y n).
Proof. unfold isNormal, fits. numbers. Qed.

(* The products of a normal with what is below 2^bits, and their sum. *)
Lemma products_fit bits n p : 0 <= bits -> isNormal n -> below bits (x p) /\ below bits (y p) ->
  below (30 + bits) (x n * x p) /\ below (30 + bits) (y n * y p) /\ below (31 + bits) (dot n p).
Proof.
  intros B [N M] [C D]. pose proof (product_of 30 bits _ _ ltac:(lia) B N C) as P.
  pose proof (product_of 30 bits _ _ ltac:(lia) B M D) as Q. split; [exact P | split; [exact Q |]].
  unfold dot, below in *. replace (31 + bits) with (Z.succ (30 + bits)) by lia. rewrite Z.pow_succ_r by lia. lia.
Qed.

(** dot(normal, point): both products and their sum, in int64. *)
Theorem dot_fits n p : isNormal n -> isPoint29 p ->
  below 59 (x n * x p) /\ below 59 (y n * y p) /\ below 60 (dot n p).
Proof. exact (products_fit 29 n p ltac:(lia)). Qed.

(** The half plane of an edge. *)
Theorem edge_offset_fits s e : isNormal (inwards e) -> below 60 (support e) -> isPoint29 (a s) -> isPoint29 (b s) ->
  below 60 (Z.max (dot (inwards e) (a s)) (dot (inwards e) (b s))) /\ below 61 (offset (edgeHalfPlane s e)).
Proof.
  intros N S A B. destruct (dot_fits _ _ N A) as (_ & _ & P). destruct (dot_fits _ _ N B) as (_ & _ & Q).
  unfold edgeHalfPlane; cbn [offset]. clear N A B. split; numbers.
Qed.

Theorem support_fits ends : isPoint29 (fst ends) -> isPoint29 (snd ends) ->
  isNormal (inwards (edgeOf ends)) /\ below 60 (support (edgeOf ends)).
Proof.
  intros P Q. pose proof (normal_fits _ _ Q P) as N. split; [exact N |].
  unfold edgeOf; cbn [support]. apply (dot_fits _ _ N P).
Qed.

(** The half planes of the sides. *)
Theorem side_offsets_fit vertices s : vertices <> [] -> (forall v, In v vertices -> isPoint29 v) ->
  isPoint29 (a s) -> isPoint29 (b s) ->
  forall h, In h (sideHalfPlanes vertices s) -> isNormal (normal h) /\ below 61 (offset h).
Proof.
  intros NE V A B h H. pose proof (normal_fits _ _ B A) as N. set (left := perpendicular (minus (b s) (a s))) in *.
  destruct (lowest_spec left vertices NE) as [_ (low & L & EL)]. destruct (highest_spec left vertices NE) as [_ (high & G & EG)].
  destruct (dot_fits left low N (V low L)) as (_ & _ & P). destruct (dot_fits left high N (V high G)) as (_ & _ & Q).
  destruct (dot_fits left (a s) N A) as (_ & _ & R). unfold sideHalfPlanes in H. fold left in H. rewrite EL, EG in H.
  destruct H as [<- | [<- | []]]; cbn [normal offset].
  - split; [exact N |]. clear - P R. numbers.
  - split; [unfold isNormal, opposite in *; cbn [x y]; clear - N; numbers |]. clear - Q R. numbers.
Qed.

(** All half planes of an obstacle. *)
Theorem half_planes_fit vertices s : vertices <> [] -> (forall v, In v vertices -> isPoint29 v) ->
  isPoint29 (a s) -> isPoint29 (b s) ->
  forall h, In h (halfPlanes vertices s) -> isNormal (normal h) /\ below 61 (offset h).
Proof.
  intros NE V A B h H. apply in_app_iff in H as [H | H].
  - destruct (isPoint s); [contradiction | exact (side_offsets_fit _ _ NE V A B h H)].
  - apply in_map_iff in H as (e & <- & H). apply in_edges in H as ([p q] & H & ->).
    pose proof (in_combine_l _ _ _ _ H) as P. apply in_combine_r in H. apply (proj1 (rotate1_in _ _)) in H.
    destruct (support_fits (p, q) (V p P) (V q H)) as [N S]. split; [exact N | apply (edge_offset_fits s _ N S A B)].
Qed.

(** edgeHit: segment.b - segment.a in int32, and its product with a normal, in int64 *)
Theorem edge_hit_fits n s : isNormal n -> isPoint29 (a s) -> isPoint29 (b s) ->
  let along := minus (b s) (a s) in
  below 30 (x along) /\ below 30 (y along) /\
  below 60 (x n * x along) /\ below 60 (y n * y along) /\ below 61 (dot n along).
Proof.
  intros N A B along. pose proof (difference_fits _ _ B A) as D. destruct (products_fit 30 n _ ltac:(lia) N D) as (P & Q & R).
  destruct D. auto.
Qed.

(** ** The distances and times of a path: Sweep *)

(** Obstacle::HalfPlane::oneNorm, in int32 *)
Theorem one_norm_fits n : isNormal n -> 0 <= oneNorm n < 2 ^ 31.
Proof. unfold isNormal, oneNorm. intros N. unfold below in N. powers. lia. Qed.

(** The displacement between two positions, in int32; its product with a normal, in int64. *)
Theorem displacement_product_fits n d : isNormal n -> below 30 (x d) /\ below 30 (y d) ->
  below 60 (x n * x d) /\ below 60 (y n * y d) /\ below 61 (dot n d).
Proof. exact (products_fit 30 n d ltac:(lia)). Qed.

(** Sweep::endDistances, in int64: below 1.5 * 2^62 *)
Theorem distances_fit h position displacement margin : isNormal (normal h) -> below 61 (offset h) -> isPoint29 position ->
  below 30 (x displacement) /\ below 30 (y displacement) -> isMargin margin ->
  let d := endDistancesTo position displacement margin h in
  below 62 (dot (normal h) position + offset h) /\ 0 <= oneNorm (normal h) * margin < 2 ^ 60 /\
  2 * Z.abs (start d) < 3 * 2 ^ 62 /\ 2 * Z.abs (finish d) < 3 * 2 ^ 62 /\ fits 64 (start d) /\ fits 64 (finish d).
Proof.
  intros N O P D M. destruct (dot_fits _ _ N P) as (_ & _ & Q). destruct (displacement_product_fits _ _ N D) as (_ & _ & R).
  pose proof (one_norm_fits _ N) as K.
  assert (S : 0 <= oneNorm (normal h) * margin < 2 ^ 60) by (unfold isMargin in M; powers; nia).
  unfold endDistancesTo; cbn [start finish]. set (u := dot (normal h) position) in *. set (w := dot (normal h) displacement) in *.
  set (m := oneNorm (normal h) * margin) in *. clearbody u w m. clear N P D M K.
  unfold below, fits in *; powers. lia.
Qed.

(** Sweep::clipToSegment computes relative to the position: the ends of the segment are then below 2^30, and the offset,
    which is the distance at the start, below 1.5 * 2^61. *)
Theorem relative_distances_fit e p d : isNormal (inwards e) -> below 60 (support e) ->
  below 30 (x p) /\ below 30 (y p) -> below 30 (x d) /\ below 30 (y d) ->
  let offset := support e - dot (inwards e) p in
  below 61 (dot (inwards e) p) /\ 2 * Z.abs offset < 3 * 2 ^ 61 /\ fits 64 offset /\
  2 * Z.abs (offset + dot (inwards e) d) < 3 * 2 ^ 62 /\ fits 64 (offset + dot (inwards e) d).
Proof.
  intros N S P D. destruct (displacement_product_fits _ _ N P) as (_ & _ & Q). destruct (displacement_product_fits _ _ N D) as (_ & _ & R).
  set (u := dot (inwards e) p) in *. set (w := dot (inwards e) d) in *. clearbody u w. clear N P D. cbv zeta.
  unfold below, fits in *; powers. lia.
Qed.

(** The same of the sides: the offsets are below 1.5 * 2^61, too. *)
Theorem relative_sides_fit vertices s p : vertices <> [] -> (forall v, In v vertices -> isPoint29 v) ->
  isPoint29 (a s) -> isPoint29 (b s) -> isPoint29 p ->
  let left := perpendicular (minus (b (relativeTo p s)) (a (relativeTo p s))) in
  isNormal left /\ below 61 (dot left (a (relativeTo p s))) /\
  below 60 (lowest left vertices) /\ below 60 (highest left vertices) /\
  forall h, In h (sideHalfPlanes vertices (relativeTo p s)) -> isNormal (normal h) /\ 2 * Z.abs (offset h) < 3 * 2 ^ 61.
Proof.
  intros NE V A B P left.
  assert (N : isNormal left) by (unfold left; rewrite relative_difference; apply normal_fits; assumption).
  destruct (lowest_spec left vertices NE) as [_ (u & U & EL)]. destruct (highest_spec left vertices NE) as [_ (w & W & EG)].
  destruct (dot_fits left u N (V u U)) as (_ & _ & L). destruct (dot_fits left w N (V w W)) as (_ & _ & G).
  destruct (displacement_product_fits left _ N (difference_fits _ _ A P)) as (_ & _ & H).
  change (minus (a s) p) with (a (relativeTo p s)) in H. rewrite <- EL in L. rewrite <- EG in G.
  split; [exact N |]. split; [exact H |]. split; [exact L |]. split; [exact G |].
  intros h I. unfold sideHalfPlanes in I. fold left in I. destruct I as [<- | [<- | []]]; cbn [normal offset].
  - split; [exact N |]. clear - H L. numbers.
  - split; [unfold isNormal, opposite in *; cbn [x y]; clear - N; numbers |]. clear - H G. numbers.
Qed.

(** Sweep::endDistances of either, with a margin, in int64: below 2^62 and 1.5 * 2^62 *)
Theorem relative_distances_fit_with_margin h d margin : isNormal (normal h) -> 2 * Z.abs (offset h) < 3 * 2 ^ 61 ->
  below 30 (x d) /\ below 30 (y d) -> isMargin margin ->
  let ends := endDistancesTo (point 0 0) d margin h in
  start ends = offset h - oneNorm (normal h) * margin /\
  below 62 (start ends) /\ 2 * Z.abs (finish ends) < 3 * 2 ^ 62 /\ fits 64 (finish ends).
Proof.
  intros N O D M. destruct (displacement_product_fits _ _ N D) as (_ & _ & R). pose proof (one_norm_fits _ N) as K.
  assert (S : 0 <= oneNorm (normal h) * margin < 2 ^ 60) by (unfold isMargin in M; powers; nia).
  assert (Z0 : dot (normal h) (point 0 0) = 0) by (unfold dot; cbn [x y]; ring).
  unfold endDistancesTo; cbn [start finish]. rewrite Z0. set (w := dot (normal h) d) in *.
  set (m := oneNorm (normal h) * margin) in *. set (o := offset h) in *. clearbody w m o. clear N D M K Z0.
  unfold below, fits in *; powers. lia.
Qed.

(** Sweep::clip: half.offset - dot(half.normal, position_), in int64, is the offset of the half plane of the segment *)
Theorem separating_fits vertices s p : vertices <> [] -> (forall v, In v vertices -> isPoint29 v) ->
  isPoint29 (a s) -> isPoint29 (b s) -> isPoint29 p ->
  forall h, In h (halfPlanes vertices (relativeTo p s)) ->
  below 60 (dot (normal h) p) /\ below 61 (offset h - dot (normal h) p) /\
  In (halfPlane (normal h) (offset h - dot (normal h) p)) (halfPlanes vertices s).
Proof.
  intros NE V A B P h H. rewrite relative_half_planes in H. apply in_map_iff in H as (g & <- & H).
  destruct (half_planes_fit _ _ NE V A B g H) as [N O]. destruct (dot_fits _ _ N P) as (_ & _ & Q).
  unfold relativeHalfPlane; cbn [normal offset]. rewrite Z.add_simpl_r. split; [exact Q |]. split; [exact O |].
  destruct g; exact H.
Qed.

(** The quotients of Sweep::cross, in int64: their numerators and denominators *)
Theorem times_fit h position displacement margin : isNormal (normal h) -> below 61 (offset h) -> isPoint29 position ->
  below 30 (x displacement) /\ below 30 (y displacement) -> isMargin margin ->
  let d := endDistancesTo position displacement margin h in
  fits 64 (start d - finish d) /\ fits 64 (finish d - start d) /\ fits 64 (- start d).
Proof.
  intros N O P D M d. destruct (distances_fit h position displacement margin N O P D M) as (_ & _ & A & _ & _ & _).
  fold d in A. destruct (displacement_product_fits _ _ N D) as (_ & _ & R).
  assert (E : finish d - start d = dot (normal h) displacement) by (unfold d, endDistancesTo; cbn [start finish]; lia).
  unfold below, fits in *; powers. lia.
Qed.

(** The products that compare two quotients, in 128 bits *)
Theorem comparisons_fit m n p q : fits 64 m -> fits 64 n -> fits 64 p -> fits 64 q -> fits 128 (m * q) /\ fits 128 (p * n).
Proof. unfold fits. powers. intros. split; nia. Qed.
