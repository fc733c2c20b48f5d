(** The clip of a path against the half planes of an obstacle: shared/physics/sweep.cpp.

    A path is given by its signed distances from each half plane at both ends, times the length of the normal. At the
    time t between 0 and 1, the distance is start + t (end - start); negative is inside. *)
From Coq Require Import ZArith QArith List Lia Lqa Bool.
From Platon Require Import fraction.
Import ListNotations.
Open Scope Z_scope.

Record EndDistances := end_distances { start : Z; finish : Z }.

Record ClipInterval :=
  clip_interval { enter : Fraction; exit : Fraction; entered : option nat; endsInside : bool }.

Definition whole : ClipInterval := clip_interval (fraction 0 1) (fraction 1 1) None true.

(** ** The function: the branches of the C++, in its order *)

(** Sweep::cross *)
Definition cross (interval : ClipInterval) (distances : EndDistances) (halfPlane : nat) : ClipInterval :=
  if 0 <=? start distances then
    let time := fraction (start distances) (start distances - finish distances) in
    if match entered interval with None => false | Some _ => at_most time (enter interval) end then interval
    else clip_interval time (exit interval) (Some halfPlane) (endsInside interval)
  else
    let time := fraction (- start distances) (finish distances - start distances) in
    clip_interval (enter interval)
      (if endsInside interval || less time (exit interval) then time else exit interval)
      (entered interval) false.

(** Sweep::intersect *)
Definition intersect (interval : ClipInterval) (distances : EndDistances) (halfPlane : nat) : option ClipInterval :=
  if (start distances <? 0) && (finish distances <? 0) then Some interval
  else if (0 <=? start distances) && (0 <=? finish distances) then None
  else Some (cross interval distances halfPlane).

(** Sweep::isEmpty *)
Definition isEmpty (interval : ClipInterval) : bool :=
  match entered interval with
  | None => false
  | Some _ => negb (endsInside interval) && at_most (exit interval) (enter interval)
  end.

(** Sweep::clipToHalfPlanes, whose half planes are numbered from [index] on *)
Fixpoint clipFrom (interval : ClipInterval) (index : nat) (distances : list EndDistances) : option ClipInterval :=
  match distances with
  | [] => if isEmpty interval then None else Some interval
  | first :: others =>
      match intersect interval first index with
      | None => None
      | Some next => clipFrom next (S index) others
      end
  end.

Definition clip (distances : list EndDistances) : option ClipInterval := clipFrom whole 0 distances.

(** ** What it means *)

Definition distanceAt (d : EndDistances) (t : Q) : Q := inject_Z (start d) + t * inject_Z (finish d - start d).
Definition isInside (distances : list EndDistances) (t : Q) : Prop := forall d, In d distances -> (distanceAt d t < 0)%Q.
Definition during (t : Q) : Prop := (0 <= t <= 1)%Q.

(** A path enters and leaves a half plane. *)
Definition enters (d : EndDistances) : Prop := 0 <= start d /\ finish d < 0.
Definition leaves (d : EndDistances) : Prop := start d < 0 /\ 0 <= finish d.
Definition enterTime (d : EndDistances) : Fraction := fraction (start d) (start d - finish d).
Definition leaveTime (d : EndDistances) : Fraction := fraction (- start d) (finish d - start d).

Lemma enterTime_valid d : enters d -> valid (enterTime d).
Proof. unfold enters, valid; simpl; lia. Qed.

Lemma leaveTime_valid d : leaves d -> valid (leaveTime d).
Proof. unfold leaves, valid; simpl; lia. Qed.

Lemma value_times f : valid f -> (value f * inject_Z (denominator f) == inject_Z (numerator f))%Q.
Proof.
  unfold valid, value; intros H. unfold Qeq; simpl. rewrite Pos.mul_1_r, Z2Pos.id by assumption. ring.
Qed.

Lemma after_entering d t : enters d -> ((distanceAt d t < 0)%Q <-> (value (enterTime d) < t)%Q).
Proof.
  intros H. pose proof (value_times _ (enterTime_valid d H)) as V. destruct H as [Hs Hf].
  assert (P : (0 < inject_Z (start d - finish d))%Q) by (apply (inject_lt 0); lia).
  unfold distanceAt. cbn [enterTime numerator denominator] in V. rewrite inject_sub in *.
  set (s := inject_Z (start d)) in *. set (f := inject_Z (finish d)) in *. set (v := value (enterTime d)) in *.
  split; intros L; nra.
Qed.

Lemma before_leaving d t : leaves d -> ((distanceAt d t < 0)%Q <-> (t < value (leaveTime d))%Q).
Proof.
  intros H. pose proof (value_times _ (leaveTime_valid d H)) as V. destruct H as [Hs Hf].
  assert (P : (0 < inject_Z (finish d - start d))%Q) by (apply (inject_lt 0); lia).
  unfold distanceAt. cbn [leaveTime numerator denominator] in V. rewrite inject_sub in *. rewrite inject_Z_opp in V.
  set (s := inject_Z (start d)) in *. set (f := inject_Z (finish d)) in *. set (v := value (leaveTime d)) in *.
  split; intros L; nra.
Qed.

Lemma inside_throughout d t : start d < 0 -> finish d < 0 -> during t -> (distanceAt d t < 0)%Q.
Proof.
  intros Hs Hf [T0 T1]. unfold distanceAt. rewrite inject_sub.
  apply inject_lt in Hs, Hf. change (inject_Z 0) with 0%Q in *. nra.
Qed.

Lemma outside_throughout d t : 0 <= start d -> 0 <= finish d -> during t -> ~ (distanceAt d t < 0)%Q.
Proof.
  intros Hs Hf [T0 T1] L. unfold distanceAt in L. rewrite inject_sub in L.
  apply inject_le in Hs, Hf. change (inject_Z 0) with 0%Q in *. nra.
Qed.

Lemma enterTime_range d : enters d -> (0 <= value (enterTime d) < 1)%Q.
Proof.
  intros H. pose proof (after_entering d 0 H) as A. pose proof (after_entering d 1 H) as B. destruct H as [Hs Hf].
  unfold distanceAt in *. rewrite inject_sub in *. apply inject_le in Hs. apply inject_lt in Hf. change (inject_Z 0) with 0%Q in *.
  split.
  - apply Qnot_lt_le. intros L. apply A in L. lra.
  - apply B. lra.
Qed.

Lemma leaveTime_range d : leaves d -> (0 < value (leaveTime d) <= 1)%Q.
Proof.
  intros H. pose proof (before_leaving d 0 H) as A. pose proof (before_leaving d 1 H) as B. destruct H as [Hs Hf].
  unfold distanceAt in *. rewrite inject_sub in *. apply inject_lt in Hs. apply inject_le in Hf. change (inject_Z 0) with 0%Q in *.
  split.
  - apply A. lra.
  - apply Qnot_lt_le. intros L. apply B in L. lra.
Qed.

(** ** What is known after some of the half planes *)

Record Known (done : list EndDistances) (interval : ClipInterval) : Prop := {
  (* none of them excludes the path *)
  no_excluder : forall d, In d done -> start d < 0 \/ finish d < 0;
  enter_valid : valid (enter interval);
  exit_valid : valid (exit interval);
  starts_inside : entered interval = None -> enter interval = fraction 0 1 /\ forall d, In d done -> start d < 0;
  entered_last : forall k, entered interval = Some k ->
    (exists d, nth_error done k = Some d /\ enters d /\ enter interval = enterTime d) /\
    (forall d, In d done -> enters d -> (value (enterTime d) <= value (enter interval))%Q) /\
    (forall j d, (j < k)%nat -> nth_error done j = Some d -> enters d -> (value (enterTime d) < value (enter interval))%Q);
  ends_in : endsInside interval = true -> exit interval = fraction 1 1 /\ forall d, In d done -> finish d < 0;
  left_first : endsInside interval = false ->
    (exists d, In d done /\ leaves d /\ exit interval = leaveTime d) /\
    (forall d, In d done -> leaves d -> (value (exit interval) <= value (leaveTime d))%Q)
}.

Lemma known_at_first : Known [] whole.
Proof.
  constructor; simpl; try discriminate; try (unfold valid; simpl; lia); try (intros; contradiction);
    intros _; (split; [reflexivity | intros; contradiction]).
Qed.

Lemma in_snoc (d e : EndDistances) l : In d (l ++ [e]) <-> In d l \/ d = e.
Proof. rewrite in_app_iff. simpl. intuition. Qed.

Lemma nth_snoc (l : list EndDistances) e k d :
  nth_error (l ++ [e]) k = Some d -> nth_error l k = Some d \/ (k = length l /\ d = e).
Proof.
  intros H. destruct (Nat.lt_ge_cases k (length l)) as [L | L].
  - left. rewrite nth_error_app1 in H; assumption.
  - right. assert (k < length (l ++ [e]))%nat by (apply nth_error_Some; congruence).
    rewrite app_length in *. simpl in *. assert (k = length l) by lia. subst.
    rewrite nth_error_app2, Nat.sub_diag in H by lia. simpl in H. split; congruence.
Qed.

Lemma nth_kept (l : list EndDistances) e k d : nth_error l k = Some d -> nth_error (l ++ [e]) k = Some d.
Proof. intros H. rewrite nth_error_app1; [assumption | apply nth_error_Some; congruence]. Qed.

Lemma nth_last (l : list EndDistances) e : nth_error (l ++ [e]) (length l) = Some e.
Proof. rewrite nth_error_app2, Nat.sub_diag by lia. reflexivity. Qed.

(* A half plane that the path neither enters nor leaves changes nothing. *)
Lemma known_inside done i d : Known done i -> start d < 0 -> finish d < 0 -> Known (done ++ [d]) i.
Proof.
  intros K Hs Hf. destruct K as [E V W S N I L].
  constructor; try assumption.
  - intros e He. apply in_snoc in He as [He | ->]; auto.
  - intros H. destruct (S H) as [Q A]. split; [assumption |]. intros e He. apply in_snoc in He as [He | ->]; auto.
  - intros k Hk. destruct (N k Hk) as (D & A & B). split; [| split].
    + destruct D as (e & D & rest). exists e. split; [apply nth_kept | ]; assumption.
    + intros e He Hn. apply in_snoc in He as [He | ->]; [auto | unfold enters in Hn; lia].
    + intros j e Hj He Hn. apply nth_snoc in He as [He | [_ ->]]; [eauto | unfold enters in Hn; lia].
  - intros H. destruct (I H) as [Q A]. split; [assumption |]. intros e He. apply in_snoc in He as [He | ->]; auto.
  - intros H. destruct (L H) as [D A]. split.
    + destruct D as (e & D & rest). exists e. split; [apply in_snoc; auto | assumption].
    + intros e He Hn. apply in_snoc in He as [He | ->]; [auto | unfold leaves in Hn; lia].
Qed.

Lemma known_entering done i d : Known done i -> enters d -> Known (done ++ [d]) (cross i d (length done)).
Proof.
  intros K D. pose proof (enterTime_valid d D) as T. pose proof D as [Hs Hf].
  destruct K as [E V W S N I L]. unfold cross. rewrite (proj2 (Z.leb_le _ _) Hs).
  fold (enterTime d).
  assert (E' : forall e, In e (done ++ [d]) -> start e < 0 \/ finish e < 0).
  { intros e He. apply in_snoc in He as [He | ->]; auto. }
  assert (I' : endsInside i = true -> exit i = fraction 1 1 /\ forall e, In e (done ++ [d]) -> finish e < 0).
  { intros H. destruct (I H) as [Q A]. split; [assumption |]. intros e He. apply in_snoc in He as [He | ->]; auto. }
  assert (L' : endsInside i = false ->
    (exists e, In e (done ++ [d]) /\ leaves e /\ exit i = leaveTime e) /\
    (forall e, In e (done ++ [d]) -> leaves e -> (value (exit i) <= value (leaveTime e))%Q)).
  { intros H. destruct (L H) as [F A]. split.
    - destruct F as (e & F & rest). exists e. split; [apply in_snoc; auto | assumption].
    - intros e He Hn. apply in_snoc in He as [He | ->]; [auto | unfold leaves in Hn; lia]. }
  (* Either it is entered no later than another one, *)
  destruct (entered i) as [k |] eqn:Ek; [destruct (at_most (enterTime d) (enter i)) eqn:Et |].
  { constructor; try assumption.
    - intros H; congruence.
    - intros k' Hk'. destruct (N k' ltac:(congruence)) as (F & A & B). split; [| split].
      + destruct F as (e & F & rest). exists e. split; [apply nth_kept | ]; assumption.
      + intros e He Hn. apply in_snoc in He as [He | ->]; [auto |]. apply at_most_is_order; assumption.
      + intros j e Hj He Hn. apply nth_snoc in He as [He | [Hl ->]]; [eauto |].
        exfalso. destruct F as (e & F & _). assert (k' < length done)%nat by (apply nth_error_Some; congruence). lia. }
  (* or it is entered later, or first. *)
  all: constructor; simpl; try assumption; try discriminate; intros k' Hk'; injection Hk' as <-; (split; [| split]).
  - exists d. split; [apply nth_last |]. auto.
  - apply not_at_most in Et; [| assumption | assumption].
    intros e He Hn. apply in_snoc in He as [He | ->]; [| lra].
    destruct (N k eq_refl) as (_ & A & _). specialize (A e He Hn). lra.
  - apply not_at_most in Et; [| assumption | assumption].
    intros j e Hj He Hn. apply nth_snoc in He as [He | [Hl ->]]; [| lia].
    destruct (N k eq_refl) as (_ & A & _). apply nth_error_In in He. specialize (A e He Hn). lra.
  - exists d. split; [apply nth_last |]. auto.
  - intros e He Hn. apply in_snoc in He as [He | ->]; [| lra].
    destruct (S eq_refl) as [_ A]. specialize (A e He). unfold enters in Hn. lia.
  - intros j e Hj He Hn. apply nth_snoc in He as [He | [Hl ->]]; [| lia].
    destruct (S eq_refl) as [_ A]. apply nth_error_In in He. specialize (A e He). unfold enters in Hn. lia.
Qed.

Lemma known_leaving done i d k : Known done i -> leaves d -> Known (done ++ [d]) (cross i d k).
Proof.
  intros K D. pose proof (leaveTime_valid d D) as T. pose proof D as [Hs Hf].
  destruct K as [E V W S N I L]. unfold cross. replace (0 <=? start d) with false by (symmetry; apply Z.leb_gt; lia).
  fold (leaveTime d).
  constructor; simpl; try assumption; try discriminate.
  - intros e He. apply in_snoc in He as [He | ->]; auto.
  - destruct (endsInside i || less (leaveTime d) (exit i)); assumption.
  - intros H. destruct (S H) as [Q A]. split; [assumption |]. intros e He. apply in_snoc in He as [He | ->]; auto.
  - intros k' Hk'. destruct (N k' Hk') as (F & A & B). split; [| split].
    + destruct F as (e & F & rest). exists e. split; [apply nth_kept | ]; assumption.
    + intros e He Hn. apply in_snoc in He as [He | ->]; [auto | unfold enters in Hn; lia].
    + intros j e Hj He Hn. apply nth_snoc in He as [He | [_ ->]]; [eauto | unfold enters in Hn; lia].
  - intros _. destruct (endsInside i) eqn:Ee; simpl.
    + destruct (I eq_refl) as [_ A]. split.
      * exists d. split; [apply in_snoc; auto | auto].
      * intros e He Hn. apply in_snoc in He as [He | ->]; [| lra]. specialize (A e He). unfold leaves in Hn. lia.
    + destruct (L eq_refl) as [(e & F & G & H) A]. destruct (less (leaveTime d) (exit i)) eqn:Et.
      * apply less_is_order in Et; [| assumption | assumption]. split.
        -- exists d. split; [apply in_snoc; auto | auto].
        -- intros e' He Hn. apply in_snoc in He as [He | ->]; [| lra]. specialize (A e' He Hn). lra.
      * apply not_less in Et; [| assumption | assumption]. split.
        -- exists e. split; [apply in_snoc; auto | auto].
        -- intros e' He Hn. apply in_snoc in He as [He | ->]; [auto | assumption].
Qed.

Lemma known_next done i d next :
  Known done i -> intersect i d (length done) = Some next -> Known (done ++ [d]) next.
Proof.
  intros K. unfold intersect.
  destruct (start d <? 0) eqn:Es, (finish d <? 0) eqn:Ef; simpl;
    destruct (0 <=? start d) eqn:Es', (0 <=? finish d) eqn:Ef'; simpl; intros H; try discriminate;
    injection H as <-; rewrite ?Z.ltb_lt, ?Z.ltb_ge, ?Z.leb_le, ?Z.leb_gt in *; try lia.
  - apply known_inside; [assumption | lia | lia].
  - apply known_leaving; [assumption | split; lia].
  - apply known_entering; [assumption | split; lia].
Qed.

Lemma excluded i d k : intersect i d k = None -> 0 <= start d /\ 0 <= finish d.
Proof.
  unfold intersect. destruct ((start d <? 0) && (finish d <? 0)); [discriminate |].
  destruct (0 <=? start d) eqn:Es, (0 <=? finish d) eqn:Ef; simpl; try discriminate.
  rewrite Z.leb_le in *. auto.
Qed.

(** The times between the last entry and the first exit. *)
Definition isBetween (interval : ClipInterval) (t : Q) : Prop :=
  (entered interval <> None -> (value (enter interval) < t)%Q) /\
  (endsInside interval = false -> (t < value (exit interval))%Q).

Lemma inside_is_between distances i t :
  Known distances i -> during t -> (isInside distances t <-> isBetween i t).
Proof.
  intros [E V W S N I L] T. unfold isInside, isBetween. split.
  - intros A. split.
    + intros H. destruct (entered i) as [k |] eqn:Ek; [| congruence].
      destruct (N k eq_refl) as ((d & F & G & ->) & _). apply after_entering; [assumption |].
      apply A. eapply nth_error_In; eassumption.
    + intros H. destruct (L H) as ((d & F & G & ->) & _). apply before_leaving; auto.
  - intros [A B] d Hd. destruct (Z.lt_ge_cases (start d) 0) as [Hs | Hs], (Z.lt_ge_cases (finish d) 0) as [Hf | Hf].
    + apply inside_throughout; assumption.
    + assert (D : leaves d) by (split; lia). apply before_leaving; [assumption |].
      destruct (endsInside i) eqn:Ee; [destruct (I eq_refl) as [_ C]; specialize (C d Hd); lia |].
      destruct (L eq_refl) as (_ & C). specialize (C d Hd D). specialize (B eq_refl). lra.
    + assert (D : enters d) by (split; lia). apply after_entering; [assumption |].
      destruct (entered i) as [k |] eqn:Ek; [| destruct (S eq_refl) as [_ C]; specialize (C d Hd); lia].
      destruct (N k eq_refl) as (_ & C & _). specialize (C d Hd D). specialize (A ltac:(discriminate)). lra.
    + destruct (E d Hd); lia.
Qed.

Lemma enter_range distances i : Known distances i -> (0 <= value (enter i) < 1)%Q.
Proof.
  intros [E V W S N I L]. destruct (entered i) as [k |] eqn:Ek.
  - destruct (N k eq_refl) as ((d & _ & G & ->) & _). apply enterTime_range; assumption.
  - destruct (S eq_refl) as [-> _]. unfold value; simpl. split; [apply Qle_refl | reflexivity].
Qed.

Lemma exit_range distances i : Known distances i -> (0 < value (exit i) <= 1)%Q.
Proof.
  intros [E V W S N I L]. destruct (endsInside i) eqn:Ee.
  - destruct (I eq_refl) as [-> _]. unfold value; simpl. split; [reflexivity | apply Qle_refl].
  - destruct (L eq_refl) as ((d & _ & G & ->) & _). apply leaveTime_range; assumption.
Qed.

(* A time between, if there is one. *)
Lemma empty_is_between distances i :
  Known distances i -> (isEmpty i = false <-> exists t, during t /\ isBetween i t).
Proof.
  intros K. pose proof (enter_range _ _ K) as A. pose proof (exit_range _ _ K) as B.
  pose proof (enter_valid _ _ K) as V. pose proof (exit_valid _ _ K) as W.
  unfold isEmpty, isBetween, during. destruct (entered i) as [k |] eqn:Ek; [destruct (endsInside i) eqn:Ee |]; simpl.
  - split; [intros _ | auto]. exists 1%Q. split; [lra |]. split; [intros _; lra | discriminate].
  - split.
    + intros H. apply not_at_most in H; [| assumption | assumption].
      exists ((value (enter i) + value (exit i)) * (1 # 2))%Q. split; [lra |]. split; intros _; lra.
    + intros (t & T & F & G). specialize (F ltac:(discriminate)). specialize (G eq_refl).
      destruct (at_most (exit i) (enter i)) eqn:H; [| reflexivity].
      apply at_most_is_order in H; [| assumption | assumption]. lra.
  - split; [intros _ | auto]. exists 0%Q. split; [lra |]. split; [congruence | intros _; lra].
Qed.

(** ** The theorems *)

Lemma clipFrom_known distances : forall done i,
  Known done i ->
  match clipFrom i (length done) distances with
  | Some result => Known (done ++ distances) result /\ isEmpty result = false
  | None => forall t, during t -> ~ isInside (done ++ distances) t
  end.
Proof.
  induction distances as [| d rest IH]; intros done i K; simpl.
  - rewrite app_nil_r. destruct (isEmpty i) eqn:H; [| auto].
    intros t T J. assert (isEmpty i = false); [| congruence].
    apply (empty_is_between _ _ K). exists t. split; [assumption |]. apply (inside_is_between _ _ _ K T). assumption.
  - destruct (intersect i d (length done)) as [next |] eqn:H.
    + specialize (IH (done ++ [d]) next (known_next _ _ _ _ K H)).
      rewrite app_length, Nat.add_comm in IH. simpl in IH. rewrite <- app_assoc in IH. exact IH.
    + intros t T J. apply excluded in H as [Hs Hf]. apply (outside_throughout d t Hs Hf T). apply J.
      apply in_app_iff. simpl. auto.
Qed.

Lemma clip_known distances :
  match clip distances with
  | Some result => Known distances result /\ isEmpty result = false
  | None => forall t, during t -> ~ isInside distances t
  end.
Proof. exact (clipFrom_known distances [] whole known_at_first). Qed.

(** A miss: at no time between 0 and 1 is the path inside. *)
Theorem miss_is_exact distances : clip distances = None <-> forall t, during t -> ~ isInside distances t.
Proof.
  pose proof (clip_known distances) as K. destruct (clip distances) as [i |]; [| split; auto].
  destruct K as [K H]. split; [discriminate |]. intros A. exfalso.
  apply (empty_is_between _ _ K) in H as (t & T & B). apply (A t T). apply (inside_is_between _ _ _ K T). assumption.
Qed.

(** An overlap at the start: at time 0/1, without a half plane that is entered. *)
Theorem start_is_exact distances i :
  clip distances = Some i -> (entered i = None <-> isInside distances 0).
Proof.
  intros C. pose proof (clip_known distances) as K. rewrite C in K. destruct K as [K _].
  assert (T : during 0) by (unfold during; lra). rewrite (inside_is_between _ _ _ K T). unfold isBetween.
  pose proof (enter_range _ _ K) as A. pose proof (exit_range _ _ K) as B. split.
  - intros ->. split; [congruence | intros _; lra].
  - intros [F _]. destruct (entered i); [| reflexivity]. specialize (F ltac:(discriminate)). lra.
Qed.

Theorem time_at_start distances i : clip distances = Some i -> entered i = None -> enter i = fraction 0 1.
Proof.
  intros C H. pose proof (clip_known distances) as K. rewrite C in K. destruct K as [K _].
  apply (starts_inside _ _ K H).
Qed.

(** A hit: its time is at least 0 and below 1, *)
Theorem time_is_in_range distances i : clip distances = Some i -> (0 <= value (enter i) < 1)%Q.
Proof.
  intros C. pose proof (clip_known distances) as K. rewrite C in K. destruct K as [K _]. apply (enter_range _ _ K).
Qed.

(** until then the path is outside, *)
Theorem outside_until_hit distances i k t :
  clip distances = Some i -> entered i = Some k -> during t -> (t <= value (enter i))%Q -> ~ isInside distances t.
Proof.
  intros C H T L J. pose proof (clip_known distances) as K. rewrite C in K. destruct K as [K _].
  apply (inside_is_between _ _ _ K T) in J as [F _]. specialize (F ltac:(congruence)). lra.
Qed.

(** from then until the exit it is inside, *)
Theorem inside_until_exit distances i t :
  clip distances = Some i -> (value (enter i) < t)%Q -> (t < value (exit i))%Q -> isInside distances t.
Proof.
  intros C A B. pose proof (clip_known distances) as K. rewrite C in K. destruct K as [K _].
  pose proof (enter_range _ _ K). pose proof (exit_range _ _ K).
  assert (T : during t) by (unfold during; lra).
  apply (inside_is_between _ _ _ K T). split; auto.
Qed.

(** and then outside, unless it ends inside. *)
Theorem outside_after_exit distances i t :
  clip distances = Some i -> endsInside i = false -> during t -> (value (exit i) <= t)%Q -> ~ isInside distances t.
Proof.
  intros C H T L J. pose proof (clip_known distances) as K. rewrite C in K. destruct K as [K _].
  apply (inside_is_between _ _ _ K T) in J as [_ F]. specialize (F H). lra.
Qed.

Theorem end_is_exact distances i : clip distances = Some i -> (endsInside i = true <-> isInside distances 1).
Proof.
  intros C. pose proof (clip_known distances) as K. rewrite C in K. destruct K as [K _].
  assert (T : during 1) by (unfold during; lra). rewrite (inside_is_between _ _ _ K T). unfold isBetween.
  pose proof (enter_range _ _ K) as A. pose proof (exit_range _ _ K) as B. split.
  - intros H. split; [intros _; lra | congruence].
  - intros [_ F]. destruct (endsInside i); [reflexivity |]. specialize (F eq_refl). lra.
Qed.

(** An exit comes after the entry, and not after the end. *)
Theorem exit_is_in_range distances i :
  clip distances = Some i -> (value (enter i) < value (exit i) <= 1)%Q.
Proof.
  intros C. pose proof (clip_known distances) as K. rewrite C in K. destruct K as [K H].
  pose proof (enter_range _ _ K) as A. pose proof (exit_range _ _ K) as B. split; [| lra].
  destruct (endsInside i) eqn:E.
  - destruct (ends_in _ _ K E) as [-> _]. unfold value at 2; simpl. lra.
  - destruct (entered i) as [k |] eqn:F.
    + unfold isEmpty in H. rewrite F, E in H. simpl in H.
      apply not_at_most in H; [assumption | apply (exit_valid _ _ K) | apply (enter_valid _ _ K)].
    + destruct (starts_inside _ _ K F) as [-> _]. unfold value at 1; simpl. lra.
Qed.

(** The half plane of a hit is the first one, in their order, of those that are entered last; the path leads in. *)
Theorem hit_plane distances i k :
  clip distances = Some i -> entered i = Some k ->
  exists d, nth_error distances k = Some d /\ enters d /\ enter i = enterTime d /\ finish d - start d < 0 /\
    (forall j e, nth_error distances j = Some e -> enters e -> (value (enterTime e) <= value (enterTime d))%Q) /\
    (forall j e, (j < k)%nat -> nth_error distances j = Some e -> enters e ->
      (value (enterTime e) < value (enterTime d))%Q).
Proof.
  intros C H. pose proof (clip_known distances) as K. rewrite C in K. destruct K as [K _].
  destruct (entered_last _ _ K k H) as ((d & F & G & Q) & A & B). exists d. rewrite Q in *.
  repeat split; try assumption; try apply G.
  - destruct G; lia.
  - intros j e He. apply A. eapply nth_error_In; eassumption.
Qed.

(** Touching at the start: moving in is a hit at time 0, sliding along and moving away are misses. *)
Theorem touching_moving_in distances i k d :
  clip distances = Some i -> entered i = Some k -> nth_error distances k = Some d -> start d = 0 ->
  (value (enter i) == 0)%Q.
Proof.
  intros C H D Z0. destruct (hit_plane _ _ _ C H) as (e & F & _ & -> & _).
  assert (e = d) by congruence. subst. unfold value, enterTime; simpl. rewrite Z0. reflexivity.
Qed.

Theorem touching_sliding_along distances d :
  In d distances -> start d = 0 -> 0 <= finish d -> clip distances = None.
Proof.
  intros D S F. apply miss_is_exact. intros t T J. apply (outside_throughout d t); auto. lia.
Qed.
