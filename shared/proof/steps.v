(** Why nothing ever overlaps (I1): induction over the operations of steps. docs/exactness.md says it in words. *)
From Coq Require Import ZArith QArith List Lia Lqa Bool.
From Platon Require Import fraction sweep point obstacle collision.
Import ListNotations.
Open Scope Z_scope.

(** A map: the segments of each part. What the rules let a body pass is the same during a step. *)
Record World := world { segmentsOf : nat -> list Segment; pierces : nat -> Segment -> bool }.

(** An instance of a body, and what it passes because it overlaps it. *)
Record Instance := instance { part : nat; shape : list Point; position : Point; passed : list Segment }.

Definition overlapsNow (i : Instance) (s : Segment) : Prop := overlaps (shape i) s (exactly (position i)).

(** A segment blocks an instance unless the rules let it pass, or it is overlapped since it passed it. *)
Definition blocks (w : World) (i : Instance) (s : Segment) : Prop :=
  In s (segmentsOf w (part i)) /\ pierces w (part i) s = false /\ ~ In s (passed i).

(** The invariant. *)
Definition isFree (w : World) (body : list Instance) : Prop :=
  forall i, In i body -> forall s, blocks w i s -> ~ overlapsNow i s.

(** *** What a step does *)

(** What the collider compares a path with: every segment that it can meet, and possibly more. *)
Definition findsAll (w : World) (i : Instance) (displacement : Point) (found : list Segment) : Prop :=
  forall s t, In s (segmentsOf w (part i)) -> during t ->
    overlapsAt (shape i) s (position i) displacement t -> In s found.

(** Collider::isFree *)
Definition isFoundFree (w : World) (i : Instance) (displacement : Point) (found : list Segment) : Prop :=
  forall s, In s found -> blocks w i s -> clipAgainst (shape i) s (position i) displacement 0 = None.

(** What an instance passes after an operation: some of what it overlaps, and all of it that it passed before. *)
Definition stillPassed (before after : Instance) : Prop :=
  forall s, In s (passed before) -> overlapsNow after s -> In s (passed after).

(** A straight move of an instance. *)
Definition moved (w : World) (before after : Instance) (displacement : Point) : Prop :=
  part after = part before /\ shape after = shape before /\
  position after = point (x (position before) + x displacement) (y (position before) + y displacement) /\
  stillPassed before after /\
  exists found, findsAll w before displacement found /\ isFoundFree w before displacement found.

(** An instance that is placed: found free at its place. It passes what the rules let it pass. *)
Definition placed (w : World) (i : Instance) : Prop :=
  exists found, findsAll w i (point 0 0) found /\ isFoundFree w i (point 0 0) found.

(** A turn: the hull of the shape before and after, which contains both, is found free. *)
Definition contains (hull inner : list Point) : Prop := forall q, strictlyInside inner q -> strictlyInside hull q.
Definition turned (w : World) (before after : Instance) : Prop :=
  part after = part before /\ position after = position before /\ stillPassed before after /\
  exists hull, strictlyConvex hull /\ contains hull (shape before) /\ contains hull (shape after) /\
    placed w (instance (part before) hull (position before) (passed before)).

Inductive operation (w : World) : list Instance -> list Instance -> Prop :=
| moves : forall before after displacements,
    length after = length before -> length displacements = length before ->
    (forall n i j d, nth_error before n = Some i -> nth_error after n = Some j -> nth_error displacements n = Some d ->
      moved w i j d) ->
    operation w before after
| insertion : forall body i, placed w i -> operation w body (body ++ [i])
| removal : forall before after, (forall i, In i after -> In i before) -> operation w before after
| turn : forall before after, length after = length before ->
    (forall n i j, nth_error before n = Some i -> nth_error after n = Some j -> turned w i j) ->
    operation w before after.

Inductive steps (w : World) : list Instance -> list Instance -> Prop :=
| nothing : forall body, steps w body body
| more : forall first next last, operation w first next -> steps w next last -> steps w first last.

Definition allConvex (body : list Instance) : Prop := forall i, In i body -> strictlyConvex (shape i).

(** ** The proof *)

Lemma nth_of_in {A} (l : list A) a : In a l -> exists n, nth_error l n = Some a.
Proof. apply In_nth_error. Qed.

Lemma same_nth {A B} (l : list A) (r : list B) n b : length r = length l -> nth_error r n = Some b -> exists a, nth_error l n = Some a.
Proof.
  intros L H. assert (n < length r)%nat by (apply nth_error_Some; congruence).
  destruct (nth_error l n) as [a |] eqn:E; [exists a; reflexivity |]. apply nth_error_None in E. lia.
Qed.

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

(* On its whole way, an instance that was found free overlaps nothing that blocks it. *)
Lemma free_on_the_way w i displacement found s t :
  strictlyConvex (shape i) -> findsAll w i displacement found -> isFoundFree w i displacement found ->
  blocks w i s -> during t -> ~ overlapsAt (shape i) s (position i) displacement t.
Proof.
  intros C F H B T O. destruct B as (I & P & N).
  assert (K : clipAgainst (shape i) s (position i) displacement 0 = None).
  { apply H; [exact (F s t I T O) | unfold blocks; auto]. }
  apply (misses_exactly _ _ _ _ C) with (t := t) in K; [contradiction | assumption].
Qed.

Lemma placed_is_free w i s : strictlyConvex (shape i) -> placed w i -> blocks w i s -> ~ overlapsNow i s.
Proof.
  intros C (found & F & H) B O.
  apply (free_on_the_way w i (point 0 0) found s 0 C F H B ltac:(unfold during; lra)).
  destruct (path_start (position i) (point 0 0)) as [X Y]. apply (overlaps_eq _ _ (exactly (position i))); [lra | lra | assumption].
Qed.

(** On the way of every move, no instance overlaps a segment that blocks it. *)
Theorem moves_are_free w before after displacement s t :
  strictlyConvex (shape before) -> moved w before after displacement -> blocks w before s -> during t ->
  ~ overlapsAt (shape before) s (position before) displacement t.
Proof. intros C (_ & _ & _ & _ & found & F & H). apply (free_on_the_way w before displacement found); assumption. Qed.

Lemma moved_is_free w before after displacement s :
  strictlyConvex (shape before) -> moved w before after displacement -> blocks w after s -> ~ overlapsNow after s.
Proof.
  intros C M (I & P & N) O. pose proof M as (Ep & Es & Eq & K & _).
  assert (B : blocks w before s).
  { split; [congruence | split; [congruence |]]. intros J. apply N. apply K; assumption. }
  apply (moves_are_free w before after displacement s 1 C M B ltac:(unfold during; lra)).
  unfold overlapsNow in O. rewrite Es, Eq in O.
  destruct (path_end (position before) displacement) as [X Y].
  apply (overlaps_eq _ _ _ (pathAt (position before) displacement 1)) in O; [exact O | lra | lra].
Qed.

Lemma contains_overlap hull inner s p : contains hull inner -> overlaps inner s p -> overlaps hull s p.
Proof. intros C (share & R & S). exists share. auto. Qed.

Lemma turned_is_free w before after s : turned w before after -> blocks w after s -> ~ overlapsNow after s.
Proof.
  intros (Ep & Eq & K & hull & C & _ & A & H) (I & P & N) O.
  set (h := instance (part before) hull (position before) (passed before)) in *.
  apply (placed_is_free w h s C H).
  - split; [simpl; congruence | split; [simpl; congruence |]]. simpl. intros J. apply N. apply K; assumption.
  - unfold overlapsNow in *. simpl. rewrite <- Eq. apply (contains_overlap _ (shape after)); assumption.
Qed.

Theorem operations_keep_free w before after :
  allConvex before -> allConvex after -> operation w before after -> isFree w before -> isFree w after.
Proof.
  intros C D O F j J s B. destruct O as [before after displacements L M H | body i H | before after H | before after L H].
  - destruct (nth_of_in _ _ J) as (n & Hn). destruct (same_nth before after n j L Hn) as (i & Hi).
    destruct (same_nth displacements before n i ltac:(lia) Hi) as (d & Hd).
    apply (moved_is_free w i j d s); [apply C; eapply nth_error_In; eassumption | exact (H n i j d Hi Hn Hd) | assumption].
  - apply in_app_iff in J as [J | [-> | []]]; [exact (F j J s B) |].
    apply (placed_is_free w); [apply D; apply in_app_iff; simpl; auto | assumption | assumption].
  - exact (F j (H j J) s B).
  - destruct (nth_of_in _ _ J) as (n & Hn). destruct (same_nth before after n j L Hn) as (i & Hi).
    apply (turned_is_free w i j s); [exact (H n i j Hi Hn) | assumption].
Qed.

(** Whatever a body does in however many steps, no instance overlaps a segment that blocks it (I1). *)
Theorem nothing_ever_overlaps w first last :
  (forall body, steps w first body -> allConvex body) -> steps w first last -> isFree w first -> isFree w last.
Proof.
  intros C S. revert C. induction S as [body | first next last O S IH]; intros C F; [assumption |].
  apply IH.
  - intros body B. apply C. eapply more; eassumption.
  - apply (operations_keep_free w first); [apply C; constructor | | assumption | assumption].
    apply C. eapply more; [eassumption | constructor].
Qed.
