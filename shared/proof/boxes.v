(** Rejection by boxes: Sweep::misses, Region::mayOverlap. *)
From Coq Require Import ZArith QArith List Lia Lqa Bool.
From Platon Require Import fraction sweep point obstacle obstacle_exact collision.
Import ListNotations.
Open Scope Z_scope.

Record Box := box { low : Point; high : Point }.
Definition overlapsBox (p q : Box) : bool :=
  (x (low p) <=? x (high q)) && (x (low q) <=? x (high p)) && (y (low p) <=? y (high q)) && (y (low q) <=? y (high p)).
(** Convex::bounds, boundsOf of a segment, Box::grown and Sweep::bounds *)
Definition boundsOfShape (vertices : list Point) : Box :=
  box (point (lowest (point 1 0) vertices) (lowest (point 0 1) vertices))
      (point (highest (point 1 0) vertices) (highest (point 0 1) vertices)).
Definition boundsOf (s : Segment) : Box :=
  box (point (Z.min (x (a s)) (x (b s))) (Z.min (y (a s)) (y (b s))))
      (point (Z.max (x (a s)) (x (b s))) (Z.max (y (a s)) (y (b s)))).
Definition grown (margin : Z) (area : Box) : Box :=
  box (point (x (low area) - margin) (y (low area) - margin)) (point (x (high area) + margin) (y (high area) + margin)).
Definition boundsOfSweep (vertices : list Point) (position displacement : Point) (margin : Z) : Box :=
  let shape := boundsOfShape vertices in
  grown margin
    (box (point (x position + Z.min 0 (x displacement) + x (low shape)) (y position + Z.min 0 (y displacement) + y (low shape)))
         (point (x position + Z.max 0 (x displacement) + x (high shape)) (y position + Z.max 0 (y displacement) + y (high shape)))).

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

(** A segment is not missed if the shape overlaps it at a place that is within the margin of the path along both axes. *)
Definition isBeside (margin : Z) (p q : Place) : Prop :=
  (- inject_Z margin <= px p - px q <= inject_Z margin)%Q /\ (- inject_Z margin <= py p - py q <= inject_Z margin)%Q.

Theorem boxes_with_margin_reject_soundly vertices s position displacement margin t p : vertices <> [] -> during t ->
  isBeside margin p (pathAt position displacement t) -> overlaps vertices s p ->
  overlapsBox (boundsOfSweep vertices position displacement margin) (boundsOf s) = true.
Proof.
  intros NE T [MX MY] (share & R & S). destruct (inside_bounds _ _ NE S) as [X Y].
  unfold minusQ, along in X, Y; unfold pathAt in MX, MY; cbn [px py] in X, Y, MX, MY.
  pose proof (between_ends (x (a s)) (x (b s)) share R) as XS. pose proof (between_ends (y (a s)) (y (b s)) share R) as YS.
  pose proof (between_ends 0 (x displacement) t T) as XD. pose proof (between_ends 0 (y displacement) t T) as YD.
  rewrite Z.sub_0_r in XD, YD. change (inject_Z 0) with 0%Q in XD, YD.
  unfold overlapsBox, boundsOfSweep, boundsOf, grown; cbn [x y low high].
  rewrite !andb_true_iff, !Z.leb_le.
  set (shape := boundsOfShape vertices) in *.
  repeat split; apply inject_le; rewrite ?inject_sub, ?inject_Z_plus; lra.
Qed.

Theorem boxes_reject_soundly vertices s position displacement t : vertices <> [] -> during t ->
  overlaps vertices s (pathAt position displacement t) ->
  overlapsBox (boundsOfSweep vertices position displacement 0) (boundsOf s) = true.
Proof.
  intros NE T O. apply (boxes_with_margin_reject_soundly vertices s position displacement 0 t _ NE T) with (2 := O).
  unfold isBeside. change (inject_Z 0) with 0%Q. split; lra.
Qed.
