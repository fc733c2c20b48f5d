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
