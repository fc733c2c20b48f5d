(** What touches what at the time of a hit, and which of several edges counts: Sweep::hitOf, cross in
    shared/physics/sweep.cpp. *)
From Coq Require Import ZArith QArith Qabs List Lia Lqa Bool.
From Platon Require Import fraction sweep sweep_exact point obstacle obstacle_exact collision hit.
Import ListNotations.
Open Scope Z_scope.

(** Where a vertex of the shape is when the shape is at p. *)
Definition vertexAt (p : Place) (v : Point) : Place := place (px p + inject_Z (x v)) (py p + inject_Z (y v)).

Lemma dotQ_vertexAt n p v : (dotQ n (vertexAt p v) == dotQ n p + inject_Z (dot n v))%Q.
Proof. rewrite <- dotQ_exactly. unfold dotQ, vertexAt, exactly; cbn [px py]. ring. Qed.

Lemma along_normal s n : dot n (b s) = dot n (a s) + dot n (minus (b s) (a s)).
Proof. unfold dot, minus; cbn [x y]. ring. Qed.

Lemma support_is_lowest vertices ends : strictlyConvex vertices -> In ends (neighbours vertices) ->
  (forall v, In v vertices -> support (edgeOf ends) <= dot (inwards (edgeOf ends)) v) /\
  dot (inwards (edgeOf ends)) (fst ends) = support (edgeOf ends) /\ dot (inwards (edgeOf ends)) (snd ends) = support (edgeOf ends).
Proof.
  intros C E. split; [intros v V; pose proof (left_of_all _ _ _ C E V) as L; rewrite isLeftOf_support in L; lia |].
  destruct (isLeftOf_ends ends) as [A B]. rewrite isLeftOf_support in A, B. lia.
Qed.

(* The half plane of a hit on the line of the segment; its offset is that of the lowest vertex, which is the feature. *)
Lemma half_plane_of_line vertices s h i : strictlyConvex vertices -> isSideHit vertices s h i \/ isEdgeHit vertices s h i ->
  side (hitOf vertices s i) = kSegment ->
  let f := feature (hitOf vertices s i) in
  isPoint s = false /\ normal_ (hitOf vertices s i) = normal h /\ dot (normal h) (a s) = dot (normal h) (b s) /\
  In f vertices /\ (forall v, In v vertices -> dot (normal h) f <= dot (normal h) v) /\
  offset h = dot (normal h) f - dot (normal h) (a s).
Proof.
  intros C H S. cbv zeta. destruct H as [(P & N & O & H) | (ends & E & H & J)].
  - assert (NE : vertices <> []) by (destruct C as (L & _); destruct vertices; cbn in L; [lia | discriminate]).
    rewrite H; cbn [makeHit normal_ feature].
    destruct (feature_of_side vertices (normal h) NE) as (before & after & V & M & _).
    split; [assumption |]. split; [reflexivity |]. split.
    { destruct N as [-> | ->]; unfold dot, opposite, perpendicular, minus; cbn [x y]; ring. }
    split; [rewrite V at 2; apply in_app_iff; right; left; reflexivity |]. split; [assumption |].
    rewrite (feature_is_lowest _ _ NE). assumption.
  - cbv zeta in J. destruct (support_is_lowest _ _ C E) as (M & U & _). pose proof (along_normal s (normal h)) as L.
    destruct ((dot (normal h) (minus (b s) (a s)) =? 0) && negb (isPoint s)) eqn:T; [| rewrite J in S; discriminate].
    apply andb_prop in T as [T P]. apply Z.eqb_eq in T. apply negb_true_iff in P.
    rewrite J; cbn [makeHit normal_ feature]. rewrite H in *; cbn [edgeHalfPlane normal offset] in *.
    split; [assumption |]. split; [reflexivity |]. split; [lia |].
    split; [destruct ends as [u w]; exact (in_combine_l _ _ _ _ E) |]. split; [intros v V; rewrite U; auto | lia].
Qed.

(** A side of the segment is touched: the normal is across the segment. At the time of the hit, the feature, a vertex of the
    shape, is on the line of the segment, and no vertex is beyond this line. (The feature can be beyond an end of the segment,
    when an edge of the shape lies along it.) *)
Theorem side_touches vertices s position displacement i : strictlyConvex vertices ->
  clipAgainst vertices s position displacement 0 = Some i -> side (hitOf vertices s i) = kSegment ->
  let h := hitOf vertices s i in
  let p := pathAt position displacement (value (time h)) in
  a s <> b s /\ dot (normal_ h) (a s) = dot (normal_ h) (b s) /\ In (feature h) vertices /\
  (dotQ (normal_ h) (vertexAt p (feature h)) == inject_Z (dot (normal_ h) (a s)))%Q /\
  (forall v, In v vertices -> (inject_Z (dot (normal_ h) (a s)) <= dotQ (normal_ h) (vertexAt p v))%Q).
Proof.
  intros C R S. cbv zeta. rewrite (proj1 (times_of_hit _ _ _)).
  destruct (half_plane_of_hit _ _ _ _ _ R ltac:(congruence)) as (k & h & _ & H & _ & _ & B).
  set (p := pathAt _ _ _) in *. clearbody p.
  destruct (half_plane_of_line _ _ _ _ C H S) as (P & -> & A & F & M & O). set (f := feature _) in *. clearbody f.
  rewrite O, inject_sub in B. split; [intros Q; unfold isPoint in P; rewrite Q, !Z.eqb_refl in P; discriminate |].
  split; [assumption |]. split; [assumption |]. split; [rewrite dotQ_vertexAt; lra |].
  intros v V. specialize (M v V). apply inject_le in M. rewrite dotQ_vertexAt. lra.
Qed.

(** An end of the segment is touched: the normal is that of an edge of the shape. At the time of the hit, the feature, an end
    of the segment, is on the line of this edge, and neither end is on its inner side. *)
Theorem end_touches vertices s position displacement i : strictlyConvex vertices ->
  clipAgainst vertices s position displacement 0 = Some i -> side (hitOf vertices s i) = kSegmentEnd ->
  let h := hitOf vertices s i in
  let p := pathAt position displacement (value (time h)) in
  (feature h = a s \/ feature h = b s) /\
  (exists ends, In ends (neighbours vertices) /\ normal_ h = inwards (edgeOf ends) /\
    (inject_Z (dot (normal_ h) (feature h)) == dotQ (normal_ h) (vertexAt p (fst ends)))%Q /\
    (inject_Z (dot (normal_ h) (feature h)) == dotQ (normal_ h) (vertexAt p (snd ends)))%Q) /\
  dot (normal_ h) (a s) <= dot (normal_ h) (feature h) /\ dot (normal_ h) (b s) <= dot (normal_ h) (feature h).
Proof.
  intros C R S. cbv zeta. rewrite (proj1 (times_of_hit _ _ _)).
  destruct (half_plane_of_hit _ _ _ _ _ R ltac:(congruence)) as (k & h & _ & H & _ & _ & B).
  set (p := pathAt _ _ _) in *. clearbody p.
  destruct H as [(_ & _ & _ & J) | (ends & E & H & J)]; [rewrite J in S; discriminate |]. cbv zeta in J.
  destruct (_ && _); [rewrite J in S; discriminate |]. rewrite J; cbn [makeHit normal_ feature].
  destruct (support_is_lowest _ _ C E) as (_ & U & W). pose proof (along_normal s (normal h)) as L.
  set (f := if 0 <? dot (normal h) (minus (b s) (a s)) then b s else a s).
  assert (F : (f = a s \/ f = b s) /\ dot (normal h) f = Z.max (dot (normal h) (a s)) (dot (normal h) (b s))).
  { unfold f. destruct (Z.ltb_spec 0 (dot (normal h) (minus (b s) (a s)))); split; auto; lia. }
  destruct F as [F M]. clearbody f. split; [assumption |]. rewrite H in *. cbn [edgeHalfPlane normal offset] in *.
  split; [| lia]. exists ends. split; [assumption |]. split; [reflexivity |].
  rewrite !dotQ_vertexAt, U, W, M. rewrite inject_sub in B.
  split; lra.
Qed.

Lemma small_enough (t g c : Q) : (0 < t -> 0 < g -> 0 <= c -> exists e, 0 < e /\ e < t /\ e * c <= g)%Q.
Proof.
  intros T G C. destruct (Qlt_le_dec g (t * (1 # 2) * c)) as [L | L]; [| exists (t * (1 # 2))%Q; repeat split; lra].
  assert (P : (0 < c)%Q) by (apply Qnot_le_lt; intros N; assert (E : (c == 0)%Q) by lra; rewrite E in L; lra).
  exists (g / c)%Q. split; [apply Qlt_shift_div_l; lra |]. split; [apply Qlt_shift_div_r; [assumption | nra] |].
  assert (E : (g / c * c == g)%Q) by (field; lra). lra.
Qed.

(* The points of a segment, seen from one of its ends. *)
Lemma along_from s share f o : (0 <= share <= 1)%Q -> (f = a s /\ o = b s) \/ (f = b s /\ o = a s) ->
  exists r, (0 <= r <= 1)%Q /\ forall n, (dotQ n (along s share) == inject_Z (dot n f) + r * inject_Z (dot n o - dot n f))%Q.
Proof.
  intros R [[-> ->] | [-> ->]]; [exists share | exists (1 - share)%Q]; (split; [lra |]); intros n; rewrite dotQ_along; [reflexivity |].
  rewrite !inject_sub. ring.
Qed.

Lemma dotQ_later n position displacement t e : (dotQ n (minusQ (pathAt position displacement (t + e)) (pathAt position displacement t)) ==
  e * inject_Z (dot n displacement))%Q.
Proof. unfold dotQ, minusQ, pathAt, dot; cbn [px py]. rewrite inject_Z_plus, !inject_Z_mult. ring. Qed.

(** Not only the line of the edge: at the time of the hit, the end is in the shape or on its border. *)
Theorem end_is_on_the_border vertices s position displacement i : strictlyConvex vertices ->
  clipAgainst vertices s position displacement 0 = Some i -> side (hitOf vertices s i) = kSegmentEnd ->
  let h := hitOf vertices s i in
  let p := pathAt position displacement (value (time h)) in
  forall e, In e (edges vertices) -> (inject_Z (support e) <= dotQ (inwards e) (minusQ (exactly (feature h)) p))%Q.
Proof.
  intros C R S. cbv zeta. rewrite (proj1 (times_of_hit _ _ _)). intros e He. apply Qnot_lt_le. intros G.
  destruct (half_plane_of_hit _ _ _ _ _ R ltac:(congruence)) as (k & h & _ & H & _ & V & B).
  destruct H as [(_ & _ & _ & J) | (ends & E & H & J)]; [rewrite J in S; discriminate |]. cbv zeta in J.
  destruct (_ && _) eqn:P in J; [rewrite J in S; discriminate |]. rewrite J in G; cbn [makeHit feature] in G.
  pose proof (along_normal s (normal h)) as L. set (slope := dot (normal h) (minus (b s) (a s))) in *.
  set (f := if 0 <? slope then b s else a s) in *. set (o := if 0 <? slope then a s else b s).
  assert (F : (f = a s /\ o = b s) \/ (f = b s /\ o = a s)) by (unfold f, o; destruct (0 <? slope); auto).
  (* the other end is on the outer side, or the same *)
  assert (K : dot (normal h) f = Z.max (dot (normal h) (a s)) (dot (normal h) (b s)) /\ (dot (normal h) o < dot (normal h) f \/ o = f)).
  { unfold f, o. apply andb_false_iff in P as [P | P].
    - apply Z.eqb_neq in P. destruct (Z.ltb_spec 0 slope); split; lia.
    - apply negb_false_iff in P. unfold isPoint in P. apply andb_prop in P as [X Y]. apply Z.eqb_eq in X, Y.
      assert (Q : a s = b s) by (destruct (a s), (b s); cbn in *; congruence). rewrite Q. split; [| destruct (_ <? _)]; auto.
      rewrite Z.max_id. destruct (_ <? _); reflexivity. }
  destruct K as [M K]. clearbody f o. clear P J L. clear slope.
  assert (Hh : normal h = inwards (edgeOf ends) /\ offset h = support (edgeOf ends) - dot (normal h) f)
    by (rewrite M, H; split; reflexivity).
  destruct Hh as [Nh Oh]. clear H M S. rewrite Oh, inject_sub in B. set (n := normal h) in *. clearbody n.
  assert (E0 : In (edgeOf ends) (edges vertices)) by (apply in_edges; eauto). set (e0 := edgeOf ends) in *. clearbody e0.
  (* soon after the hit there is an overlap, *)
  set (w := inject_Z (dot n displacement)) in *. assert (W : (w < 0)%Q) by (apply (inject_lt _ 0); assumption).
  set (w' := inject_Z (dot (inwards e) displacement)). set (m := inject_Z (dot (inwards e) o - dot (inwards e) f)).
  rewrite dotQ_minus, dotQ_exactly in G. pose proof (exit_is_in_range _ _ R) as [T _].
  set (p := dotQ (inwards e) (pathAt _ _ _)) in *. set (g := (inject_Z (support e) - (inject_Z (dot (inwards e) f) - p))%Q).
  destruct (small_enough (value (exit i) - value (enter i)) g (- w * Qabs m + Qabs w')) as (t & T0 & T1 & T2); [lra | unfold g; lra | |].
  { pose proof (Qabs_nonneg m). pose proof (Qabs_nonneg w'). nra. }
  destruct (hits_exactly _ _ _ _ _ C R) as (Z0 & X & _ & _ & O).
  destruct (proj2 (O (value (enter i) + t)%Q ltac:(unfold during; lra))) as (share & Rs & I); [split; left; lra |].
  (* near to the end of the segment. *)
  destruct (along_from s share f o Rs F) as (r & Rr & D). pose proof (I e0 E0) as I0. specialize (I e He). rewrite <- Nh in I0.
  rewrite dotQ_minus, D in I, I0. pose proof (dotQ_later n position displacement (value (enter i)) t) as Q0.
  pose proof (dotQ_later (inwards e) position displacement (value (enter i)) t) as Q1.
  rewrite dotQ_minus in Q0, Q1. fold w in Q0. fold w' p in Q1. fold m in I.
  assert (A : (r * m <= t * (- w * Qabs m))%Q).
  { destruct K as [K | ->]; [| assert (Em : (m == 0)%Q) by (unfold m; rewrite Z.sub_diag; reflexivity); rewrite Em; cbn; nra].
    assert (K1 : (inject_Z (dot n o - dot n f) <= - (1))%Q) by (apply (inject_le _ (-1)); lia).
    set (k' := inject_Z (dot n o - dot n f)) in *. assert (r <= t * - w)%Q by nra.
    pose proof (Qle_Qabs m). pose proof (Qabs_nonneg m). set (q := Qabs m) in *. clearbody q m. nra. }
  pose proof (Qle_Qabs (- w')) as B'. rewrite Qabs_opp in B'. set (q' := Qabs w') in *. set (q := Qabs m) in *.
  assert (t * - w' <= t * q')%Q by nra. unfold g in T2. lra.
Qed.

(** ** Precedence *)

(** Of half planes that are entered at the same time the first counts: the sides of the segment come before the edges of the
    shape, and these in their order. *)
Theorem earlier_takes_precedence vertices s position displacement margin i j k h :
  clipAgainst vertices s position displacement margin = Some i -> entered i = Some k ->
  (j < k)%nat -> nth_error (halfPlanes vertices s) j = Some h ->
  let d := endDistancesTo position displacement margin h in
  enters d -> (value (enterTime d) < value (enter i))%Q.
Proof.
  intros R E L N d D. destruct (hit_plane _ _ _ R E) as (e & _ & _ & T & _ & _ & B). rewrite T.
  apply (B j); [assumption | | assumption]. unfold distances. rewrite nth_error_map, N. reflexivity.
Qed.

(* Two normals in one direction have products in one proportion, *)
Lemma parallel_products m n c d v : c * x m = d * x n -> c * y m = d * y n -> c * dot m v = d * dot n v.
Proof.
  intros X Y. unfold dot. transitivity (c * x m * x v + c * y m * y v); [ring |]. rewrite X, Y. ring.
Qed.

(* so do the distances of half planes on whose lines the same places are, which are entered at one time. *)
Lemma parallel_half_planes position displacement margin g h c d : 0 < c -> 0 < d ->
  c * x (normal g) = d * x (normal h) -> c * y (normal g) = d * y (normal h) -> c * offset g = d * offset h ->
  let dg := endDistancesTo position displacement margin g in
  let dh := endDistancesTo position displacement margin h in
  enters dh -> enters dg /\ (value (enterTime dh) <= value (enterTime dg))%Q.
Proof.
  intros C D X Y O dg dh E. pose proof (parallel_products _ _ _ _ position X Y) as P.
  pose proof (parallel_products _ _ _ _ displacement X Y) as V.
  assert (M : c * (oneNorm (normal g) * margin) = d * (oneNorm (normal h) * margin)).
  { transitivity ((Z.abs (c * x (normal g)) + Z.abs (c * y (normal g))) * margin);
      [| rewrite X, Y]; unfold oneNorm; rewrite !Z.abs_mul, ?(Z.abs_eq c), ?(Z.abs_eq d) by lia; ring. }
  assert (S : c * start dg = d * start dh) by (unfold dg, dh, endDistancesTo; cbn [start]; lia).
  assert (F : c * finish dg = d * finish dh) by (unfold dg, dh, endDistancesTo; cbn [finish]; lia).
  clearbody dg dh. clear X Y O P V M. assert (G : enters dg) by (unfold enters in *; nia). split; [assumption |].
  apply at_most_is_order; [apply enterTime_valid; assumption | apply enterTime_valid; assumption |].
  apply Z.leb_le. cbn [enterTime numerator denominator]. apply Z.eq_le_incl. apply (Z.mul_reg_l _ _ (c * d)); [nia |].
  transitivity (d * start dh * (c * start dg - c * finish dg)); [ring |].
  transitivity (c * start dg * (d * start dh - d * finish dh)); [rewrite S, F; ring | ring].
Qed.

Lemma parallel_offsets vertices s m n f c d : vertices <> [] -> 0 < c -> 0 < d ->
  c * x m = d * x n -> c * y m = d * y n -> In f vertices -> (forall v, In v vertices -> dot n f <= dot n v) ->
  c * (lowest m vertices - dot m (a s)) = d * (dot n f - dot n (a s)).
Proof.
  intros NE C D X Y F M. destruct (lowest_spec m vertices NE) as [L (v & V & E)]. specialize (L f F). specialize (M v V).
  pose proof (parallel_products _ _ _ _ f X Y). pose proof (parallel_products _ _ _ _ v X Y).
  pose proof (parallel_products _ _ _ _ (a s) X Y). rewrite E in *.
  set (mv := dot m v) in *. set (mf := dot m f) in *. set (nv := dot n v) in *. set (nf := dot n f) in *.
  clearbody mv mf nv nf. nia.
Qed.

(** After a clip, a hit on the line of the segment is one of its sides (the half planes 0 and 1), never a parallel edge of the
    shape: the side is entered at the same time, and comes first. *)
Theorem parallel_edge_is_never_hit vertices s position displacement margin i : strictlyConvex vertices ->
  clipAgainst vertices s position displacement margin = Some i -> side (hitOf vertices s i) = kSegment ->
  entered i = Some 0%nat \/ entered i = Some 1%nat.
Proof.
  intros C R S. destruct (entered i) as [k |] eqn:E; [| unfold hitOf in S; rewrite E in S; discriminate].
  destruct k as [| [| k]]; [auto | auto | exfalso]. destruct (hit_plane _ _ _ R E) as (e & Ne & De & T & V & _).
  unfold distances in Ne. rewrite nth_error_map in Ne. destruct (nth_error (halfPlanes vertices s) _) as [h |] eqn:N; [| discriminate].
  injection Ne as <-. cbn [endDistancesTo start finish] in V. pose proof (hit_of_half_plane _ _ _ _ _ E N) as H.
  assert (NE : vertices <> []) by (destruct C as (L & _); destruct vertices; cbn in L; [lia | discriminate]).
  destruct (half_plane_of_line _ _ _ _ C H S) as (P & _ & A & F & M & O).
  (* A side with the same direction contradicts. *)
  assert (G : forall j m c d, (j < 2)%nat -> 0 < c -> 0 < d -> c * x m = d * x (normal h) -> c * y m = d * y (normal h) ->
    nth_error (halfPlanes vertices s) j = Some (halfPlane m (lowest m vertices - dot m (a s))) -> False).
  { intros j m c d J Hc Hd X Y K. pose proof (parallel_offsets _ s _ _ _ _ _ NE Hc Hd X Y F M) as Q. rewrite <- O in Q.
    destruct (parallel_half_planes position displacement margin (halfPlane m _) h c d Hc Hd X Y Q De) as [B L].
    pose proof (earlier_takes_precedence _ _ _ _ _ _ j _ _ R E ltac:(lia) K B) as W. rewrite T in W. lra. }
  set (left := perpendicular (minus (b s) (a s))) in *.
  set (n := normal h) in *. set (dx := x (b s) - x (a s)). set (dy := y (b s) - y (a s)).
  assert (D : 0 < dx * dx + dy * dy).
  { assert (dx <> 0 \/ dy <> 0) by (unfold isPoint, dx, dy in *; apply andb_false_iff in P as [P | P]; apply Z.eqb_neq in P; lia).
    clearbody dx dy. nia. }
  assert (Z0 : x n * dx + y n * dy = 0) by (unfold dot in A; unfold dx, dy; lia).
  assert (X : dot n left * - dy = (dx * dx + dy * dy) * x n).
  { transitivity (x n * (dy * dy) - dx * (y n * dy)); [unfold dot, left, perpendicular, minus; cbn [x y]; fold dx dy; ring |].
    replace (y n * dy) with (- (x n * dx)) by lia. ring. }
  assert (Y : dot n left * dx = (dx * dx + dy * dy) * y n).
  { transitivity (y n * (dx * dx) - dy * (x n * dx)); [unfold dot, left, perpendicular, minus; cbn [x y]; fold dx dy; ring |].
    replace (x n * dx) with (- (y n * dy)) by lia. ring. }
  assert (K : nth_error (halfPlanes vertices s) 0 = Some (halfPlane left (lowest left vertices - dot left (a s)))).
  { unfold halfPlanes. rewrite P. reflexivity. }
  assert (K' : nth_error (halfPlanes vertices s) 1 =
    Some (halfPlane (opposite left) (lowest (opposite left) vertices - dot (opposite left) (a s)))).
  { unfold halfPlanes. rewrite P. cbn. fold left. do 2 f_equal. rewrite highest_is_lowest, dot_opposite. lia. }
  set (m := dot n left) in *. clearbody m. destruct (Z.lt_trichotomy m 0) as [L | [L | L]].
  - apply (G 1%nat (opposite left) (- m) (dx * dx + dy * dy)); try assumption; try lia;
      unfold opposite, left, perpendicular, minus; cbn [x y]; fold dx dy; lia.
  - subst m. assert (x n = 0 /\ y n = 0) as [Nx Ny] by (split; nia). unfold dot in V. fold n in V. rewrite Nx, Ny in V. lia.
  - apply (G 0%nat left m (dx * dx + dy * dy)); try assumption; try lia.
Qed.
