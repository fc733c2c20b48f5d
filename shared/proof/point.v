(** Points of the lattice and rational ones: shared/include/platon/exact/point.h. *)
From Coq Require Import ZArith QArith List Lia Lqa.
Import ListNotations.
Open Scope Z_scope.

Record Point := point { x : Z; y : Z }.
Record Place := place { px : Q; py : Q }.

Definition dot (n p : Point) : Z := x n * x p + y n * y p.
Definition perpendicular (p : Point) : Point := point (- y p) (x p).
Definition minus (p q : Point) : Point := point (x p - x q) (y p - y q).

(** A lattice point as a rational one, and the same products of those. *)
Definition exactly (p : Point) : Place := place (inject_Z (x p)) (inject_Z (y p)).
Definition dotQ (n : Point) (p : Place) : Q := (inject_Z (x n) * px p + inject_Z (y n) * py p)%Q.
Definition minusQ (p q : Place) : Place := place (px p - px q) (py p - py q).

Lemma dotQ_exactly n p : (dotQ n (exactly p) == inject_Z (dot n p))%Q.
Proof. unfold dotQ, dot; simpl. rewrite inject_Z_plus, !inject_Z_mult. reflexivity. Qed.

Lemma dotQ_minus n p q : (dotQ n (minusQ p q) == dotQ n p - dotQ n q)%Q.
Proof. unfold dotQ, minusQ; simpl. ring. Qed.

(** The successors in a closed list: each pair of neighbours, the last one with the first. *)
Definition rotate1 {A} (l : list A) : list A := match l with [] => [] | first :: others => others ++ [first] end.
Definition neighbours {A} (l : list A) : list (A * A) := combine l (rotate1 l).

Lemma rotate1_length {A} (l : list A) : length (rotate1 l) = length l.
Proof. destruct l; simpl; [reflexivity |]. rewrite app_length; simpl. lia. Qed.

Lemma rotate1_in {A} (l : list A) a : In a (rotate1 l) <-> In a l.
Proof. destruct l; simpl; [tauto |]. rewrite in_app_iff; simpl. tauto. Qed.

Lemma combine_left {A B} (l : list A) : forall (r : list B) a,
  length l = length r -> In a l -> exists b, In (a, b) (combine l r).
Proof.
  induction l as [| h t IH]; intros r a H J; [contradiction |]. destruct r as [| h' t']; [discriminate |].
  simpl in *. destruct J as [-> | J]; [exists h'; auto |].
  destruct (IH t' a ltac:(lia) J) as (b & K). exists b. auto.
Qed.

Lemma combine_right {A B} (l : list A) : forall (r : list B) b,
  length l = length r -> In b r -> exists a, In (a, b) (combine l r).
Proof.
  induction l as [| h t IH]; intros r b H J; destruct r as [| h' t']; try discriminate; try contradiction.
  simpl in *. destruct J as [-> | J]; [exists h; auto |].
  destruct (IH t' b ltac:(lia) J) as (a & K). exists a. auto.
Qed.

Lemma has_successor {A} (l : list A) a : In a l -> exists b, In (a, b) (neighbours l) /\ In b l.
Proof.
  intros H. destruct (combine_left l (rotate1 l) a (eq_sym (rotate1_length l)) H) as (b & K).
  exists b. split; [assumption |]. apply in_combine_r in K. apply rotate1_in; assumption.
Qed.

Lemma has_predecessor {A} (l : list A) b : In b l -> exists a, In (a, b) (neighbours l) /\ In a l.
Proof.
  intros H. apply rotate1_in in H. destruct (combine_right l (rotate1 l) b (eq_sym (rotate1_length l)) H) as (a & K).
  exists a. split; [assumption |]. apply in_combine_l in K. assumption.
Qed.

(** Of the elements of a list, one with the largest value. *)
Lemma largest {A} (f : A -> Q) (l : list A) : l <> [] -> exists a, In a l /\ forall b, In b l -> (f b <= f a)%Q.
Proof.
  induction l as [| h t IH]; [congruence |]. intros _. destruct t as [| h' t'].
  - exists h. split; [left; reflexivity |]. intros b [-> | []]. apply Qle_refl.
  - destruct (IH ltac:(discriminate)) as (a & Ha & L). destruct (Qlt_le_dec (f h) (f a)) as [C | C].
    + exists a. split; [right; assumption |]. intros b [-> | Hb]; [lra | auto].
    + exists h. split; [left; reflexivity |]. intros b [-> | Hb]; [lra |]. specialize (L b Hb). lra.
Qed.
