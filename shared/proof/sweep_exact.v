(** The clip of a path against half planes is exact. *)
From Coq Require Import ZArith QArith List Lia Lqa Bool.
From Platon Require Import fraction sweep clip_known.
Import ListNotations.
Open Scope Z_scope.

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

(** The denominators are positive, so that [value] is the quotient. *)
Theorem denominators_are_positive distances i : clip distances = Some i -> valid (enter i) /\ valid (exit i).
Proof.
  intros C. pose proof (clip_known distances) as K. rewrite C in K. destruct K as [K _].
  split; [apply (enter_valid _ _ K) | apply (exit_valid _ _ K)].
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
