(** A shape overlaps a segment if and only if its position is inside of all half planes of the obstacle. *)
From Coq Require Import ZArith QArith List Lia Lqa.
From Platon Require Import fraction point obstacle.
Import ListNotations.
Open Scope Z_scope.

(** ** An overlap is on the inner side of every half plane *)

Lemma in_edges vertices e : In e (edges vertices) <-> exists ends, In ends (neighbours vertices) /\ e = edgeOf ends.
Proof.
  unfold edges. rewrite in_map_iff. split; intros (ends & H & K); exists ends; auto.
Qed.

(* Seen from a place inside, each vertex is to the left of the one before. *)
Lemma turns_left vertices q u v : strictlyInside vertices q -> In (u, v) (neighbours vertices) ->
  (0 < (inject_Z (x u) - px q) * (inject_Z (y v) - py q) - (inject_Z (y u) - py q) * (inject_Z (x v) - px q))%Q.
Proof.
  intros S N. assert (E : In (edgeOf (u, v)) (edges vertices)) by (apply in_edges; exists (u, v); auto).
  specialize (S _ E). unfold edgeOf, dotQ, dot in S; simpl in S. unfold Z.sub in S.
  rewrite !inject_Z_plus, !inject_Z_mult, !inject_Z_plus, !inject_Z_opp, !inject_Z_plus, !inject_Z_opp in S.
  lra || nra.
Qed.

(* Around a place inside there are vertices in every direction. *)
Lemma surrounded vertices q n : vertices <> [] -> strictlyInside vertices q -> n <> point 0 0 ->
  exists v, In v vertices /\ (inject_Z (dot n v) < dotQ n q)%Q.
Proof.
  intros NE S N.
  destruct (largest (fun v => - inject_Z (dot n v))%Q vertices NE) as (low & Hlow & L).
  destruct (Qlt_le_dec (inject_Z (dot n low)) (dotQ n q)) as [G | G]; [exists low; auto | exfalso].
  set (D := fun v => (inject_Z (dot n v) - dotQ n q)%Q).
  set (C := fun v => (inject_Z (x n) * (inject_Z (y v) - py q) - inject_Z (y n) * (inject_Z (x v) - px q))%Q).
  assert (D0 : forall v, In v vertices -> (0 <= D v)%Q).
  { intros v Hv. specialize (L v Hv). unfold D. lra. }
  assert (NN : (0 < inject_Z (x n) * inject_Z (x n) + inject_Z (y n) * inject_Z (y n))%Q).
  { rewrite <- !inject_Z_mult, <- inject_Z_plus. apply (inject_lt 0).
    destruct n as [nx ny]; simpl in *. assert (nx <> 0 \/ ny <> 0) by (destruct (Z.eq_dec nx 0); [right; congruence | left; assumption]). nia. }
  assert (T : forall u v, In (u, v) (neighbours vertices) -> (0 < D u * C v - C u * D v)%Q).
  { intros u v H. pose proof (turns_left vertices q u v S H) as P.
    assert (E : (D u * C v - C u * D v ==
      (inject_Z (x n) * inject_Z (x n) + inject_Z (y n) * inject_Z (y n)) *
      ((inject_Z (x u) - px q) * (inject_Z (y v) - py q) - (inject_Z (y u) - py q) * (inject_Z (x v) - px q)))%Q).
    { unfold D, C, dot, dotQ. rewrite !inject_Z_plus, !inject_Z_mult. ring. }
    rewrite E. nra. }
  assert (D1 : forall v, In v vertices -> (0 < D v)%Q).
  { intros v Hv. destruct (has_successor vertices v Hv) as (s & Hs & Is). destruct (has_predecessor vertices v Hv) as (p & Hp & Ip).
    apply T in Hs, Hp. pose proof (D0 v Hv). pose proof (D0 s Is). pose proof (D0 p Ip).
    destruct (Qlt_le_dec 0 (D v)) as [K | K]; [assumption | exfalso].
    assert (Z0 : (D v == 0)%Q) by lra. rewrite Z0 in *.
    destruct (Qlt_le_dec 0 (C v)) as [G' | G']; nra. }
  destruct (largest (fun v => C v / D v)%Q vertices NE) as (v & Hv & M).
  destruct (has_successor vertices v Hv) as (s & Hs & Is). apply T in Hs. specialize (M s Is).
  pose proof (D1 v Hv) as Dv. pose proof (D1 s Is) as Ds.
  assert (Cv : (C v == C v / D v * D v)%Q) by (field; lra).
  assert (Cs : (C s == C s / D s * D s)%Q) by (field; lra).
  rewrite Cv, Cs in Hs. set (tv := (C v / D v)%Q) in *. set (ts := (C s / D s)%Q) in *.
  assert ((0 < D v * D s)%Q) by nra. nra.
Qed.

Lemma perpendicular_zero s : isPoint s = false -> perpendicular (minus (b s) (a s)) <> point 0 0.
Proof.
  unfold isPoint, perpendicular, minus; simpl. intros H K. injection K as K1 K2.
  apply Bool.andb_false_iff in H as [H | H]; apply Z.eqb_neq in H; lia.
Qed.

(* All points of a segment are at one height over it. *)
Lemma dotQ_left_along s share :
  (dotQ (perpendicular (minus (b s) (a s))) (along s share) == inject_Z (dot (perpendicular (minus (b s) (a s))) (a s)))%Q.
Proof.
  rewrite dotQ_along.
  assert (E : dot (perpendicular (minus (b s) (a s))) (b s) - dot (perpendicular (minus (b s) (a s))) (a s) = 0)
    by (unfold dot, perpendicular, minus; simpl; ring).
  rewrite E. ring.
Qed.

Theorem overlap_is_in_all vertices s p : vertices <> [] -> overlaps vertices s p ->
  forall h, In h (halfPlanes vertices s) -> isIn h p.
Proof.
  intros NE (share & R & S) h H. unfold halfPlanes in H. apply in_app_iff in H as [H | H].
  - destruct (isPoint s) eqn:P; [contradiction |].
    pose proof (perpendicular_zero s P) as N. set (left := perpendicular (minus (b s) (a s))) in *.
    assert (N' : opposite left <> point 0 0).
    { intros E. apply N. destruct left as [lx ly]. unfold opposite in E; simpl in E. injection E as E1 E2. f_equal; lia. }
    pose proof (dotQ_left_along s share) as A. fold left in A.
    unfold sideHalfPlanes in H. fold left in H. unfold isIn. destruct H as [<- | [<- | []]]; simpl.
    + destruct (surrounded _ _ _ NE S N) as (v & Hv & L). rewrite dotQ_minus, A in L.
      destruct (lowest_spec left vertices NE) as [M _]. specialize (M v Hv). apply inject_le in M.
      rewrite inject_sub. lra.
    + destruct (surrounded _ _ _ NE S N') as (v & Hv & L). rewrite dotQ_opposite, dot_opposite, inject_Z_opp, dotQ_minus, A in L.
      destruct (highest_spec left vertices NE) as [M _]. specialize (M v Hv). apply inject_le in M.
      rewrite inject_sub, dotQ_opposite. lra.
  - apply in_map_iff in H as (e & <- & He). specialize (S e He). unfold isIn, edgeHalfPlane; simpl.
    pose proof (along_at_most (inwards e) s share R) as A. rewrite dotQ_minus in S. rewrite inject_sub. lra.
Qed.

(** ** A place on the inner side of every half plane is an overlap *)

Definition sumOf (f : Point -> Z) (l : list Point) : Z := fold_right (fun v sum => f v + sum) 0 l.

Lemma sumOf_positive f l : (forall v, In v l -> 0 <= f v) -> (exists v, In v l /\ 0 < f v) -> 0 < sumOf f l.
Proof.
  induction l as [| h t IH]; intros P (v & Hv & V); [contradiction |]. simpl.
  assert (N : 0 <= sumOf f t).
  { clear IH Hv. assert (Q : forall v, In v t -> 0 <= f v) by (intros; apply P; right; assumption).
    clear P. induction t as [| h' t' IH]; simpl; [lia |]. pose proof (Q h' (or_introl eq_refl)).
    assert (0 <= sumOf f t') by (apply IH; intros; apply Q; right; assumption). lia. }
  destruct Hv as [-> | Hv]; [lia |]. pose proof (P h (or_introl eq_refl)).
  assert (0 < sumOf f t); [| lia]. apply IH; [intros; apply P; right; assumption | exists v; auto].
Qed.

Lemma sumOf_dot n l : sumOf (dot n) l = x n * sumOf x l + y n * sumOf y l.
Proof. induction l as [| h t IH]; simpl; [ring |]. rewrite IH. unfold dot. ring. Qed.

Lemma sumOf_minus f c l : sumOf (fun v => f v - c) l = sumOf f l - c * Z.of_nat (length l).
Proof. induction l as [| h t IH]; [simpl; ring |]. cbn [sumOf fold_right length]. fold (sumOf (fun v => f v - c) t). rewrite IH. fold (sumOf f t). lia. Qed.

Lemma isLeftOf_support ends v : isLeftOf ends v = dot (inwards (edgeOf ends)) v - support (edgeOf ends).
Proof. unfold isLeftOf, edgeOf, dot, minus; simpl. ring. Qed.

Lemma isLeftOf_ends ends : isLeftOf ends (fst ends) = 0 /\ isLeftOf ends (snd ends) = 0.
Proof. unfold isLeftOf, dot, perpendicular, minus; simpl. split; ring. Qed.

Lemma point_dec (u v : Point) : {u = v} + {u <> v}.
Proof. decide equality; apply Z.eq_dec. Qed.

Lemma third l (u v : Point) : (3 <= length l)%nat -> NoDup l -> exists w, In w l /\ w <> u /\ w <> v.
Proof.
  intros L D. destruct l as [| p [| q [| r t]]]; simpl in L; try lia.
  inversion D as [| ? ? D1 D2]; subst. inversion D2 as [| ? ? D3 D4]; subst. simpl in *.
  assert (p <> q /\ p <> r /\ q <> r) as (PQ & PR & QR) by (repeat split; intros E; subst; tauto).
  destruct (point_dec p u) as [Pu | Pu], (point_dec p v) as [Pv | Pv];
    try (exists p; repeat split; auto; fail);
    destruct (point_dec q u) as [Qu | Qu], (point_dec q v) as [Qv | Qv];
    try (exists q; repeat split; auto; fail);
    exists r; (repeat split; auto); congruence.
Qed.

Lemma left_of_all vertices ends v : strictlyConvex vertices -> In ends (neighbours vertices) -> In v vertices ->
  0 <= isLeftOf ends v.
Proof.
  intros (_ & _ & C) E V. destruct (isLeftOf_ends ends) as [A B].
  destruct (point_dec v (fst ends)) as [-> | U]; [lia |]. destruct (point_dec v (snd ends)) as [-> | W]; [lia |].
  specialize (C ends v E V U W). lia.
Qed.

(* The mean of the vertices is strictly inside. *)
Lemma mean_is_inside vertices : strictlyConvex vertices -> exists c, strictlyInside vertices c.
Proof.
  intros C. pose proof C as (L & D & A). set (n := Z.of_nat (length vertices)).
  assert (P : 0 < n) by (unfold n; lia). assert (PQ : (0 < inject_Z n)%Q) by (apply (inject_lt 0); assumption).
  exists (place (inject_Z (sumOf x vertices) / inject_Z n) (inject_Z (sumOf y vertices) / inject_Z n)).
  intros e He. apply in_edges in He as (ends & E & ->).
  assert (G : 0 < sumOf (fun v => dot (inwards (edgeOf ends)) v - support (edgeOf ends)) vertices).
  { apply sumOf_positive.
    - intros v V. rewrite <- isLeftOf_support. apply (left_of_all vertices); assumption.
    - destruct (third vertices (fst ends) (snd ends) L D) as (w & W & W1 & W2). exists w. split; [assumption |].
      rewrite <- isLeftOf_support. apply A; assumption. }
  rewrite sumOf_minus in G. fold n in G. rewrite sumOf_dot in G.
  set (e := edgeOf ends) in *. clearbody e. apply inject_lt in G.
  rewrite inject_sub, inject_Z_plus, !inject_Z_mult in G. unfold dotQ; simpl.
  set (sx := inject_Z (sumOf x vertices)) in *. set (sy := inject_Z (sumOf y vertices)) in *.
  change (inject_Z 0) with 0%Q in *. set (q := inject_Z n) in *. set (k := inject_Z (support e)) in *.
  set (nx := inject_Z (x (inwards e))) in *. set (ny := inject_Z (y (inwards e))) in *.
  assert (NQ : ~ (q == 0)%Q) by (intros E0; rewrite E0 in PQ; apply (Qlt_irrefl 0); exact PQ).
  assert (X : (sx == sx / q * q)%Q) by (field; exact NQ). assert (Y : (sy == sy / q * q)%Q) by (field; exact NQ).
  rewrite X, Y in G. set (tx := (sx / q)%Q) in *. set (ty := (sy / q)%Q) in *. clearbody tx ty. clear X Y.
  assert (F : (nx * (tx * q) + ny * (ty * q) - k * q == (nx * tx + ny * ty - k) * q)%Q) by ring. rewrite F in G.
  set (w := (nx * tx + ny * ty)%Q) in *. clearbody w. apply Qnot_le_lt. intros N.
  assert (0 <= (k - w) * q)%Q by (apply Qmult_le_0_compat; lra). lra.
Qed.

(* Between a vertex and a place strictly inside, all places but the vertex are strictly inside. *)
Lemma between_is_inside vertices v c share : strictlyConvex vertices -> In v vertices -> strictlyInside vertices c ->
  (0 < share <= 1)%Q ->
  strictlyInside vertices (place (inject_Z (x v) + share * (px c - inject_Z (x v))) (inject_Z (y v) + share * (py c - inject_Z (y v)))).
Proof.
  intros C V I [S0 S1] e He. specialize (I e He). apply in_edges in He as (ends & E & ->).
  pose proof (left_of_all vertices ends v C E V) as L. rewrite isLeftOf_support in L.
  set (e := edgeOf ends) in *. clearbody e. assert (LQ : (0 <= inject_Z (dot (inwards e) v) - inject_Z (support e))%Q).
  { rewrite <- inject_sub. apply (inject_le 0). assumption. }
  rewrite <- dotQ_exactly in LQ. unfold dotQ, exactly in *; simpl in *.
  set (nx := inject_Z (x (inwards e))) in *. set (ny := inject_Z (y (inwards e))) in *.
  set (k := inject_Z (support e)) in *. set (vx := inject_Z (x v)) in *. set (vy := inject_Z (y v)) in *.
  assert (F : (nx * (vx + share * (px c - vx)) + ny * (vy + share * (py c - vy)) ==
    (1 - share) * (nx * vx + ny * vy) + share * (nx * px c + ny * py c))%Q) by ring.
  rewrite F. set (h := (nx * vx + ny * vy)%Q) in *. set (g := (nx * px c + ny * py c)%Q) in *. clearbody h g. clear F.
  assert (0 <= (1 - share) * (h - k))%Q by (apply Qmult_le_0_compat; lra).
  assert (0 < share * (g - k))%Q by (apply Qmult_lt_0_compat; lra). lra.
Qed.

Lemma dotQ_between n v c share :
  (dotQ n (place (inject_Z (x v) + share * (px c - inject_Z (x v))) (inject_Z (y v) + share * (py c - inject_Z (y v)))) ==
    inject_Z (dot n v) + share * (dotQ n c - inject_Z (dot n v)))%Q.
Proof. rewrite <- dotQ_exactly. unfold dotQ, exactly; simpl. ring. Qed.

(* If vertices are on both sides of a line, a place strictly inside is on it. *)
Lemma crosses_line vertices n h low high : strictlyConvex vertices -> In low vertices -> In high vertices ->
  (inject_Z (dot n low) < h)%Q -> (h < inject_Z (dot n high))%Q ->
  exists z, strictlyInside vertices z /\ (dotQ n z == h)%Q.
Proof.
  intros C Hl Hh L H. destruct (mean_is_inside vertices C) as (c & I).
  assert (G : forall v, In v vertices -> ~ (inject_Z (dot n v) - dotQ n c == 0)%Q ->
    (0 < (inject_Z (dot n v) - h) / (inject_Z (dot n v) - dotQ n c) <= 1)%Q ->
    exists z, strictlyInside vertices z /\ (dotQ n z == h)%Q).
  { intros v V N R. eexists. split; [exact (between_is_inside vertices v c _ C V I R) |].
    rewrite dotQ_between. set (u := inject_Z (dot n v)) in *. set (w := dotQ n c) in *. clearbody u w.
    field. exact N. }
  destruct (Qlt_le_dec (dotQ n c) h) as [K | K].
  - apply (G high Hh); [lra |]. set (u := (inject_Z (dot n high) - h)%Q). set (w := (inject_Z (dot n high) - dotQ n c)%Q).
    assert (0 < u)%Q by (unfold u; lra). assert (u <= w)%Q by (unfold u, w; lra).
    split; [apply Qlt_shift_div_l; lra | apply Qle_shift_div_r; lra].
  - apply (G low Hl); [lra |]. set (u := (inject_Z (dot n low) - h)%Q). set (w := (inject_Z (dot n low) - dotQ n c)%Q).
    assert (u < 0)%Q by (unfold u; lra). assert (w <= u)%Q by (unfold u, w; lra).
    assert (F : (u / w == (- u) / (- w))%Q) by (field; repeat split; intros E0; lra). rewrite F.
    split; [apply Qlt_shift_div_l; lra | apply Qle_shift_div_r; lra].
Qed.

(* A place at the height of a segment is on its line. *)
Lemma on_line s q : isPoint s = false ->
  (dotQ (perpendicular (minus (b s) (a s))) q == inject_Z (dot (perpendicular (minus (b s) (a s))) (a s)))%Q ->
  exists r, (px q == px (along s r))%Q /\ (py q == py (along s r))%Q.
Proof.
  intros P H. unfold isPoint in P.
  set (dx := inject_Z (x (b s) - x (a s))). set (dy := inject_Z (y (b s) - y (a s))).
  assert (N : ~ (dx * dx + dy * dy == 0)%Q).
  { unfold dx, dy. rewrite <- !inject_Z_mult, <- inject_Z_plus. unfold Qeq; simpl. rewrite !Z.mul_1_r. intros E0.
    pose proof (Z.square_nonneg (x (b s) - x (a s))). pose proof (Z.square_nonneg (y (b s) - y (a s))).
    assert (X : (x (b s) - x (a s)) * (x (b s) - x (a s)) = 0) by lia.
    assert (Y : (y (b s) - y (a s)) * (y (b s) - y (a s)) = 0) by lia.
    apply Z.mul_eq_0 in X. apply Z.mul_eq_0 in Y.
    apply Bool.andb_false_iff in P as [P | P]; apply Z.eqb_neq in P; lia. }
  assert (K : (dx * (py q - inject_Z (y (a s))) == dy * (px q - inject_Z (x (a s))))%Q).
  { rewrite <- dotQ_exactly in H. unfold dotQ, exactly, perpendicular, minus in H; simpl in H.
    rewrite inject_Z_opp in H. fold dx dy in H. lra. }
  exists ((dx * (px q - inject_Z (x (a s))) + dy * (py q - inject_Z (y (a s)))) / (dx * dx + dy * dy))%Q.
  unfold along; simpl. fold dx dy. set (wx := (px q - inject_Z (x (a s)))%Q) in *. set (wy := (py q - inject_Z (y (a s)))%Q) in *.
  assert (X : (px q == inject_Z (x (a s)) + wx)%Q) by (unfold wx; ring).
  assert (Y : (py q == inject_Z (y (a s)) + wy)%Q) by (unfold wy; ring).
  split; [rewrite X | rewrite Y]; apply Qplus_inj_l.
  - assert (F : ((dx * wx + dy * wy) / (dx * dx + dy * dy) * dx == (dx * dx * wx + dy * (dx * wy)) / (dx * dx + dy * dy))%Q)
      by (field; exact N).
    rewrite F, K. field. exact N.
  - assert (F : ((dx * wx + dy * wy) / (dx * dx + dy * dy) * dy == (dx * (dy * wx) + dy * dy * wy) / (dx * dx + dy * dy))%Q)
      by (field; exact N).
    rewrite F, <- K. field. exact N.
Qed.

Lemma strictlyInside_eq vertices p q : (px p == px q)%Q -> (py p == py q)%Q -> strictlyInside vertices p -> strictlyInside vertices q.
Proof. intros X Y S e He. specialize (S e He). unfold dotQ in *. rewrite <- X, <- Y. assumption. Qed.

Theorem in_all_is_overlap vertices s p : strictlyConvex vertices ->
  (forall h, In h (halfPlanes vertices s) -> isIn h p) -> overlaps vertices s p.
Proof.
  intros C H.
  assert (NE : vertices <> []) by (destruct C as (L & _); destruct vertices; simpl in L; [lia | discriminate]).
  assert (E : forall e, In e (edges vertices) ->
    (dotQ (inwards e) p + (inject_Z (support e) - inject_Z (Z.max (dot (inwards e) (a s)) (dot (inwards e) (b s)))) < 0)%Q).
  { intros e He. specialize (H (edgeHalfPlane s e)). unfold isIn, edgeHalfPlane in H; simpl in H. rewrite inject_sub in H.
    apply H. unfold halfPlanes. apply in_app_iff. right. apply in_map_iff. exists e. auto. }
  destruct (isPoint s) eqn:P.
  - exists 0%Q. split; [lra |]. intros e He. specialize (E e He). rewrite dotQ_minus, dotQ_along.
    unfold isPoint in P. apply andb_prop in P as [X Y]. apply Z.eqb_eq in X, Y.
    assert (B : dot (inwards e) (b s) = dot (inwards e) (a s)) by (unfold dot; rewrite X, Y; reflexivity).
    rewrite B, Z.max_id in E. lra.
  - (* somewhere on its line the segment's point is inside, *)
    assert (Z0 : exists r, strictlyInside vertices (minusQ (along s r) p)).
    { set (left := perpendicular (minus (b s) (a s))).
      destruct (lowest_spec left vertices NE) as [_ (low & Hl & L)]. destruct (highest_spec left vertices NE) as [_ (high & Hh & G)].
      assert (A : isIn (halfPlane left (lowest left vertices - dot left (a s))) p).
      { apply H. unfold halfPlanes. rewrite P. simpl. auto. }
      assert (B : isIn (halfPlane (opposite left) (dot left (a s) - highest left vertices)) p).
      { apply H. unfold halfPlanes. rewrite P. simpl. auto. }
      unfold isIn in A, B; simpl in A, B. rewrite inject_sub in A, B. rewrite dotQ_opposite in B. rewrite L in A. rewrite G in B.
      destruct (crosses_line vertices left (inject_Z (dot left (a s)) - dotQ left p) low high C Hl Hh ltac:(lra) ltac:(lra)) as (z & I & Q).
      destruct (on_line s (place (px z + px p) (py z + py p)) P) as (r & X & Y).
      { fold left. unfold dotQ in *; cbn [px py]. lra. }
      exists r. apply (strictlyInside_eq vertices z); [| | exact I]; unfold minusQ; cbn [px py] in *; lra. }
    (* and so it is at the nearest point of the segment. *)
    destruct Z0 as (r & I).
    assert (K : forall e, In e (edges vertices) ->
      (inject_Z (support e) < dotQ (inwards e) (minusQ (along s 0) p))%Q \/ (inject_Z (support e) < dotQ (inwards e) (minusQ (along s 1) p))%Q).
    { intros e He. specialize (E e He). rewrite !dotQ_minus, !dotQ_along, inject_sub.
      destruct (Z.max_spec (dot (inwards e) (a s)) (dot (inwards e) (b s))) as [[_ M] | [_ M]]; rewrite M in E; [right | left]; lra. }
    destruct (Qlt_le_dec r 0) as [R0 | R0]; [| destruct (Qlt_le_dec 1 r) as [R1 | R1]].
    + exists 0%Q. split; [lra |]. intros e He. specialize (I e He). destruct (K e He) as [J | J]; [assumption |].
      rewrite dotQ_minus, dotQ_along in *. set (u := inject_Z (dot _ (a s))) in *. set (d := inject_Z (_ - _)) in *. nra.
    + exists 1%Q. split; [lra |]. intros e He. specialize (I e He). destruct (K e He) as [J | J]; [| assumption].
      rewrite dotQ_minus, dotQ_along in *. set (u := inject_Z (dot _ (a s))) in *. set (d := inject_Z (_ - _)) in *. nra.
    + exists r. split; [lra | assumption].
Qed.

(** The shape at p overlaps the segment if and only if p is on the inner side of all half planes of the obstacle. *)
Theorem obstacle_is_exact vertices s p : strictlyConvex vertices ->
  (overlaps vertices s p <-> forall h, In h (halfPlanes vertices s) -> isIn h p).
Proof.
  intros C. split; [| apply in_all_is_overlap; assumption]. apply overlap_is_in_all.
  destruct C as (L & _). destruct vertices; simpl in L; [lia | discriminate].
Qed.
