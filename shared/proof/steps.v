(** Why nothing ever overlaps (I1): induction over the operations of steps. docs/exactness.md says it in words. *)
From Coq Require Import ZArith QArith List Lia Lqa Bool.
From Platon Require Import sweep point obstacle obstacle_exact winding collision boxes near.
Import ListNotations.
Open Scope Z_scope.

(** A map: the segments of each part. The number of a segment is its place in this list. *)
Record World := world { segmentsOf : nat -> list Segment }.

(** An instance of a body, and the numbers of the segments that it passes because it overlaps them. *)
Record Instance := instance { part : nat; shape : list Point; position : Point; passed : list nat }.

(** Rules::pierce: whether they let an instance pass a segment. The answer may depend on where the instance is. *)
Definition Rules := Instance -> nat -> bool.

Definition isSegment (w : World) (i : Instance) (k : nat) (s : Segment) : Prop := nth_error (segmentsOf w (part i)) k = Some s.
Definition overlapsNow (i : Instance) (s : Segment) : Prop := overlaps (shape i) s (exactly (position i)).

(** A segment blocks an instance unless the rules let it pass, or it is overlapped since it passed it. *)
Definition blocks (w : World) (rules : Rules) (i : Instance) (k : nat) (s : Segment) : Prop :=
  isSegment w i k s /\ rules i k = false /\ ~ In k (passed i).

(** The invariant. *)
Definition isFree (w : World) (rules : Rules) (body : list Instance) : Prop :=
  forall i, In i body -> forall k s, blocks w rules i k s -> ~ overlapsNow i s.
Definition allConvex (body : list Instance) : Prop := forall i, In i body -> strictlyConvex (shape i).

(** ** What a step does *)

(** What the collider compares the way of a shape with: every segment that blocks it there, and possibly more. *)
Definition findsAll (w : World) (rules : Rules) (i : Instance) (moving : list Point) (displacement : Point) (found : list nat) : Prop :=
  forall k s t, blocks w rules i k s -> during t -> overlapsAt moving s (position i) displacement t -> In k found.

(** Collider::isFree: nothing that blocks the instance is met by a shape on a straight way from its position. *)
Definition isFoundFree (w : World) (rules : Rules) (i : Instance) (moving : list Point) (displacement : Point) : Prop :=
  exists found, findsAll w rules i moving displacement found /\
    forall k s, In k found -> blocks w rules i k s -> clipAgainst moving s (position i) displacement 0 = None.

(** After an operation, an instance passes what it overlaps of what it passed before or what the rules let it pass. *)
Definition passesOn (w : World) (rules : Rules) (before after : Instance) : Prop :=
  forall k s, isSegment w after k s ->
    (In k (passed after) <-> overlapsNow after s /\ (In k (passed before) \/ rules before k = true)).

(** A straight move of an instance. *)
Definition moved (w : World) (rules : Rules) (before after : Instance) (displacement : Point) : Prop :=
  part after = part before /\ shape after = shape before /\
  position after = point (x (position before) + x displacement) (y (position before) + y displacement) /\
  passesOn w rules before after /\ isFoundFree w rules before (shape before) displacement.

(** A rotation: the hull, which contains the shape before and after, is found free. *)
Definition contains (hull inner : list Point) : Prop := forall q, strictlyInside inner q -> strictlyInside hull q.
Definition rotatedTo (w : World) (rules : Rules) (before after : Instance) : Prop :=
  part after = part before /\ position after = position before /\ strictlyConvex (shape after) /\ passesOn w rules before after /\
  exists hull, strictlyConvex hull /\ contains hull (shape before) /\ contains hull (shape after) /\
    isFoundFree w rules before hull (point 0 0).

(** An instance that is inserted: found free at its place. It passes what it overlaps there and the rules let it pass. *)
Definition inserted (w : World) (rules : Rules) (i : Instance) : Prop :=
  strictlyConvex (shape i) /\ isFoundFree w rules i (shape i) (point 0 0) /\
  forall k s, isSegment w i k s -> (In k (passed i) <-> overlapsNow i s /\ rules i k = true).

(** The beginning of a step, which may have other rules: what is overlapped is passed until it is left. *)
Definition begun (w : World) (before after : Instance) : Prop :=
  part after = part before /\ shape after = shape before /\ position after = position before /\
  forall k s, isSegment w after k s -> (In k (passed after) <-> overlapsNow before s).

Inductive operation (w : World) (rules : Rules) : list Instance -> list Instance -> Prop :=
| moves : forall before after, Forall2 (fun i j => exists d, moved w rules i j d) before after -> operation w rules before after
| rotates : forall before after, Forall2 (rotatedTo w rules) before after -> operation w rules before after
| inserts : forall body i, inserted w rules i -> operation w rules body (body ++ [i])
| removes : forall before after, (forall i, In i after -> In i before) -> operation w rules before after.

(** What happens to a body in any number of steps, each with rules that are allowed. *)
Inductive history (w : World) (allowed : Rules -> Prop) : Rules -> list Instance -> Rules -> list Instance -> Prop :=
| nothing : forall rules body, history w allowed rules body rules body
| operates : forall rules first next others last,
    operation w rules first next -> history w allowed rules next others last -> history w allowed rules first others last
| begins : forall rules new first next others last,
    allowed new -> Forall2 (begun w) first next -> history w allowed new next others last -> history w allowed rules first others last.

(** ** The proof *)

Lemma overlaps_eq vertices s p q : (px p == px q)%Q -> (py p == py q)%Q -> overlaps vertices s p -> overlaps vertices s q.
Proof.
  intros X Y (share & R & S). exists share. split; [assumption |].
  apply (strictlyInside_eq vertices (minusQ (along s share) p)); [| | assumption]; unfold minusQ; cbn [px py]; lra.
Qed.

Lemma path_start position displacement : (px (pathAt position displacement 0) == px (exactly position))%Q /\
  (py (pathAt position displacement 0) == py (exactly position))%Q.
Proof. unfold pathAt, exactly; cbn [px py]. split; ring. Qed.

Lemma path_end position displacement :
  (px (pathAt position displacement 1) == px (exactly (point (x position + x displacement) (y position + y displacement))))%Q /\
  (py (pathAt position displacement 1) == py (exactly (point (x position + x displacement) (y position + y displacement))))%Q.
Proof. unfold pathAt, exactly; cbn [px py x y]. rewrite !inject_Z_plus. split; ring. Qed.

Lemma overlaps_at_start vertices s p d : overlaps vertices s (exactly p) -> overlapsAt vertices s p d 0.
Proof.
  intros O. destruct (path_start p d) as [X Y]. unfold overlapsAt. apply (overlaps_eq _ _ (exactly p)); [lra | lra | assumption].
Qed.

(* On its whole way, a shape that was found free overlaps nothing that blocks the instance. *)
Lemma free_on_the_way w rules i moving displacement k s t :
  strictlyConvex moving -> isFoundFree w rules i moving displacement -> blocks w rules i k s -> during t ->
  ~ overlapsAt moving s (position i) displacement t.
Proof.
  intros C (found & F & H) B T O. pose proof (H k s (F k s t B T O) B) as K. apply (misses_exactly _ _ _ _ C) with (t := t) in K; [contradiction | assumption].
Qed.

(** On the way of every move, no instance overlaps a segment that blocks it. *)
Theorem moves_are_free w rules before after displacement k s t :
  strictlyConvex (shape before) -> moved w rules before after displacement -> blocks w rules before k s -> during t ->
  ~ overlapsAt (shape before) s (position before) displacement t.
Proof. intros C (_ & _ & _ & _ & F). apply (free_on_the_way w rules before _ displacement k); assumption. Qed.

(* What blocks after an operation and is overlapped has blocked before it. *)
Lemma blocked_before w rules before after k s : part after = part before -> passesOn w rules before after ->
  blocks w rules after k s -> overlapsNow after s -> blocks w rules before k s.
Proof.
  intros E P (I & _ & N) O. pose proof (proj2 (P k s I)) as Q. unfold blocks, isSegment in *. rewrite <- E.
  split; [assumption |]. destruct (rules before k) eqn:R; [exfalso; apply N; apply Q; auto |].
  split; [reflexivity |]. intros J. apply N. apply Q. auto.
Qed.

Lemma moved_is_free w rules before after displacement k s :
  strictlyConvex (shape before) -> moved w rules before after displacement -> blocks w rules after k s -> ~ overlapsNow after s.
Proof.
  intros C M B O. pose proof M as (Ep & Es & Eq & P & _). pose proof (blocked_before w rules before after k s Ep P B O) as B'.
  apply (moves_are_free w rules before after displacement k s 1 C M B' ltac:(unfold during; lra)).
  unfold overlapsNow in O. rewrite Es, Eq in O. destruct (path_end (position before) displacement) as [X Y].
  apply (overlaps_eq _ _ _ (pathAt (position before) displacement 1)) in O; [exact O | lra | lra].
Qed.

Lemma rotated_is_free w rules before after k s : rotatedTo w rules before after -> blocks w rules after k s -> ~ overlapsNow after s.
Proof.
  intros (Ep & Eq & _ & P & hull & C & _ & A & F) B O. pose proof (blocked_before w rules before after k s Ep P B O) as B'.
  apply (free_on_the_way w rules before hull (point 0 0) k s 0 C F B' ltac:(unfold during; lra)). apply overlaps_at_start.
  destruct O as (share & R & S). exists share. rewrite Eq in S. auto.
Qed.

Lemma inserted_is_free w rules i k s : inserted w rules i -> blocks w rules i k s -> ~ overlapsNow i s.
Proof.
  intros (C & F & _) B O. apply (free_on_the_way w rules i (shape i) (point 0 0) k s 0 C F B ltac:(unfold during; lra)).
  apply overlaps_at_start. assumption.
Qed.

Lemma each_before (relation : Instance -> Instance -> Prop) before after j : Forall2 relation before after -> In j after -> exists i, In i before /\ relation i j.
Proof.
  intros E. induction E as [| i' j' before after R E IH]; intros J; [contradiction |].
  destruct J as [<- | J]; [exists i'; split; [left; reflexivity | assumption] |].
  destruct (IH J) as (i & I & K). exists i. split; [right; assumption | assumption].
Qed.

Theorem operations_keep_free w rules before after :
  operation w rules before after -> allConvex before -> isFree w rules before -> allConvex after /\ isFree w rules after.
Proof.
  intros O C F. destruct O as [before after E | before after E | body i I | before after H].
  - split.
    + intros j J. destruct (each_before _ _ _ j E J) as (i & I & d & (_ & Es & _)). rewrite Es. auto.
    + intros j J k s B. destruct (each_before _ _ _ j E J) as (i & I & d & M). apply (moved_is_free w rules i j d k s (C i I) M B).
  - split.
    + intros j J. destruct (each_before _ _ _ j E J) as (i & I & (_ & _ & K & _)). assumption.
    + intros j J k s B. destruct (each_before _ _ _ j E J) as (i & I & R). apply (rotated_is_free w rules i j k s R B).
  - split.
    + intros j J. apply in_app_iff in J as [J | [<- | []]]; [exact (C j J) | apply I].
    + intros j J k s B. apply in_app_iff in J as [J | [<- | []]]; [exact (F j J k s B) | exact (inserted_is_free w rules i k s I B)].
  - split; intros j J; [exact (C j (H j J)) | exact (F j (H j J))].
Qed.

Theorem beginnings_keep_free w rules before after :
  Forall2 (begun w) before after -> allConvex before -> allConvex after /\ isFree w rules after.
Proof.
  intros E C. split.
  - intros j J. destruct (each_before _ _ _ j E J) as (i & I & (_ & Es & _)). rewrite Es. auto.
  - intros j J k s (I' & _ & N) O. destruct (each_before _ _ _ j E J) as (i & I & (Ep & Es & Eq & P)). apply N. apply (P k s I').
    unfold overlapsNow in *. rewrite <- Es, <- Eq. assumption.
Qed.

(** Whatever happens to a body in however many steps, no instance overlaps a segment that blocks it (I1). *)
Theorem nothing_ever_overlaps w allowed rules first others last : history w allowed rules first others last ->
  allConvex first -> isFree w rules first -> allConvex last /\ isFree w others last.
Proof.
  intros H. induction H as [rules body | rules first next others last O H IH | rules new first next others last A B H IH]; intros C F.
  - auto.
  - destruct (operations_keep_free w rules first next O C F). auto.
  - destruct (beginnings_keep_free w new first next B C). auto.
Qed.

Lemma same_segment w i j k s : part j = part i -> isSegment w j k s -> isSegment w i k s.
Proof. unfold isSegment. intros ->. auto. Qed.

(** A wall, which no rules ever let anybody pass, and which is not overlapped at first, is never overlapped. *)
Definition isWall (p k : nat) (rules : Rules) : Prop := forall i, part i = p -> rules i k = false.
Definition isClearOf (w : World) (p k : nat) (body : list Instance) : Prop :=
  forall i s, In i body -> part i = p -> isSegment w i k s -> ~ In k (passed i) /\ ~ overlapsNow i s.

Theorem walls_are_never_overlapped w p k rules first others last : history w (isWall p k) rules first others last ->
  isWall p k rules -> allConvex first -> isFree w rules first -> isClearOf w p k first -> isClearOf w p k last.
Proof.
  intros H. induction H as [rules body | rules first next others last O H IH | rules new first next others last A B H IH]; intros W C F K.
  - assumption.
  - destruct (operations_keep_free w rules first next O C F) as [C' F']. apply IH; try assumption.
    assert (G : forall i j s, In i first -> part j = part i -> passesOn w rules i j -> part j = p -> isSegment w j k s -> ~ In k (passed j)).
    { intros i j s I Ei P Ep S Q. destruct (proj1 (P k s S) Q) as [_ [Q' | Q']].
      - apply (proj1 (K i s I ltac:(congruence) (same_segment w i j k s Ei S))). assumption.
      - rewrite (W i) in Q'; [discriminate | congruence]. }
    assert (N : forall i s, In i next -> part i = p -> isSegment w i k s -> ~ In k (passed i)).
    { destruct O as [before after E | before after E | body i I | before after R]; intros j s J Ep S Q.
      - destruct (each_before _ _ _ j E J) as (i & I & d & (Ei & _ & _ & P & _)). exact (G i j s I Ei P Ep S Q).
      - destruct (each_before _ _ _ j E J) as (i & I & (Ei & _ & _ & P & _)). exact (G i j s I Ei P Ep S Q).
      - apply in_app_iff in J as [J | [<- | []]]; [apply (proj1 (K j s J Ep S)); assumption |].
        destruct I as (_ & _ & P). destruct (proj1 (P k s S) Q) as [_ Q']. rewrite (W i Ep) in Q'. discriminate.
      - apply (proj1 (K j s (R j J) Ep S)). assumption. }
    intros i s I Ep S. pose proof (N i s I Ep S) as Q. split; [assumption |]. apply (F' i I k s). split; [assumption | split; [apply W; assumption | assumption]].
  - destruct (beginnings_keep_free w new first next B C) as [C' F']. apply IH; try assumption.
    intros j s J Ep S. destruct (each_before _ _ _ j B J) as (i & I & (Ei & Es & Eq & P)).
    pose proof (same_segment w i j k s Ei S) as S'. destruct (K i s I ltac:(congruence) S') as [_ O].
    split; [intros Q; apply O; apply (P k s S); assumption | unfold overlapsNow in *; rewrite Es, Eq; assumption].
Qed.

(** ** One premise, for moves beside a leg: what is near to the leg is all that such a move can meet (Collider::isFreeInLeg). *)

(** The segments that the leg of an instance has listed: all that block it and that neither their box nor the clip of the leg
    excludes, with the margin kNear. *)
Definition listsAll (w : World) (rules : Rules) (i : Instance) (leg : Point) (listed : list nat) : Prop :=
  forall k s, blocks w rules i k s -> overlapsBox (boundsOfSweep (shape i) (position i) leg kNear) (boundsOf s) = true ->
    clipAgainst (shape i) s (position i) leg kNear <> None -> In k listed.

Theorem near_list_finds_all w rules i f from to at_ listed : strictlyConvex (shape i) -> isRotation (fromHome f) ->
  position i = placeOf f from -> isNearLeg from to at_ = true ->
  listsAll w rules i (minus (placeOf f to) (position i)) listed ->
  findsAll w rules i (shape i) (minus (placeOf f at_) (position i)) listed.
Proof.
  intros C R P N L k s t I T O. rewrite P in *. destruct (near_segments_suffice f from to at_ (shape i) s t C R N T O) as [A B].
  apply (L k s I); rewrite P; assumption.
Qed.

(** ** The premises can be met: a square begins a step, moves to a wall, and stops where it touches it; a second instance is
    inserted, both rotate, and one is removed. *)

Definition square : list Point := [point (-1) (-1); point 1 (-1); point 1 1; point (-1) 1].
Definition wall : World := world (fun _ => [segment (point 5 (-9)) (point 5 9)]).
Definition always_blocks : Rules := fun _ _ => false.
Definition at_ (p : Z) : Instance := instance 0 square (point p 0) [].

Lemma square_is_convex : strictlyConvex square.
Proof. apply valid_is_convex. vm_compute. reflexivity. Qed.

Lemma is_wall i k s : isSegment wall i k s -> k = 0%nat /\ s = segment (point 5 (-9)) (point 5 9).
Proof. unfold isSegment. destruct k as [| [| k]]; [intros E; injection E as <-; auto | discriminate | discriminate]. Qed.

Lemma is_found_free p d : (p = 0 /\ (d = 0 \/ d = 4)) \/ (p = 4 /\ d = 0) -> isFoundFree wall always_blocks (at_ p) square (point d 0).
Proof.
  intros A. exists [0%nat]. split.
  - intros k s t (I & _) _ _. destruct (is_wall _ _ _ I) as [-> _]. left. reflexivity.
  - intros k s _ (I & _). destruct (is_wall _ _ _ I) as [_ ->]. destruct A as [[-> [-> | ->]] | [-> ->]]; vm_compute; reflexivity.
Qed.

Lemma is_not_overlapped p s k : p = 0 \/ p = 4 -> isSegment wall (at_ p) k s -> ~ overlapsNow (at_ p) s.
Proof.
  intros A I O. destruct (is_wall _ _ _ I) as [_ ->]. apply overlaps_at_start with (d := point 0 0) in O.
  refine (proj1 (misses_exactly _ _ _ (point 0 0) square_is_convex) _ 0%Q _ O); [| unfold during; lra].
  destruct A as [-> | ->]; vm_compute; reflexivity.
Qed.

Lemma passes_nothing p before : p = 0 \/ p = 4 -> passed before = [] -> passesOn wall always_blocks before (at_ p).
Proof. intros A E k s I. split; [intros [] |]. intros [O _]. exact (is_not_overlapped p s k A I O). Qed.

Theorem premises_can_be_met :
  allConvex [at_ 0] /\ isFree wall always_blocks [at_ 0] /\ isClearOf wall 0 0 [at_ 0] /\
  history wall (isWall 0 0) always_blocks [at_ 0] always_blocks [at_ 4].
Proof.
  split; [intros i [<- | []]; apply square_is_convex |]. split; [| split].
  - intros i [<- | []] k s (I & _). apply (is_not_overlapped 0 s k); auto.
  - intros i s [<- | []] _ I. split; [intros [] |]. apply (is_not_overlapped 0 s 0); auto.
  - eapply (begins _ _ always_blocks always_blocks [at_ 0] [at_ 0]); [unfold isWall, always_blocks; auto | |].
    { constructor; [| constructor]. repeat split; [intros [] |]. intros O. exfalso. eapply (is_not_overlapped 0); eauto. }
    eapply operates with (next := [at_ 4]).
    { apply moves. constructor; [| constructor]. exists (point 4 0).
      split; [reflexivity | split; [reflexivity | split; [reflexivity | split]]]; [apply passes_nothing | apply is_found_free]; auto. }
    eapply operates with (next := [at_ 4; at_ 0]).
    { apply (inserts _ _ [at_ 4] (at_ 0)). split; [apply square_is_convex |]. split; [apply (is_found_free 0 0); auto |].
      intros k s I. split; [intros [] |]. intros [O _]. exact (is_not_overlapped 0 s k (or_introl eq_refl) I O). }
    eapply operates with (next := [at_ 4; at_ 0]).
    { assert (R : forall p, p = 0 \/ p = 4 -> rotatedTo wall always_blocks (at_ p) (at_ p)).
      { intros p A. split; [reflexivity | split; [reflexivity | split; [apply square_is_convex | split]]]; [apply passes_nothing; auto |].
        exists square. split; [apply square_is_convex | split; [intros q Q; exact Q | split; [intros q Q; exact Q |]]].
        apply is_found_free. intuition. }
      apply rotates. constructor; [apply R; auto | constructor; [apply R; auto | constructor]]. }
    eapply operates; [| apply nothing]. apply removes. intros i [<- | []]. left. reflexivity.
Qed.
