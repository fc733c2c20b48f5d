(** What is known of a clip after some of the half planes: the induction of sweep_exact.v. *)
From Coq Require Import ZArith QArith List Lia Lqa Bool.
From Platon Require Import fraction sweep.
Import ListNotations.
Open Scope Z_scope.

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
