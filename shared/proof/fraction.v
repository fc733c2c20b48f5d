(** Quotients of integers: shared/include/platon/exact/fraction.h. *)
From Coq Require Import ZArith QArith Lia Lqa.
Open Scope Z_scope.

Record Fraction := fraction { numerator : Z; denominator : Z }.

(** The comparisons of the C++: crosswise. *)
Definition less (a b : Fraction) : bool := numerator a * denominator b <? numerator b * denominator a.
Definition at_most (a b : Fraction) : bool := numerator a * denominator b <=? numerator b * denominator a.

(** What a fraction stands for. *)
Definition valid (f : Fraction) : Prop := 0 < denominator f.
Definition value (f : Fraction) : Q := numerator f # Z.to_pos (denominator f).

Theorem less_is_order a b : valid a -> valid b -> (less a b = true <-> (value a < value b)%Q).
Proof.
  unfold valid, less, value, Qlt; simpl. intros Ha Hb.
  rewrite !Z2Pos.id by assumption. rewrite Z.ltb_lt. reflexivity.
Qed.

Theorem at_most_is_order a b : valid a -> valid b -> (at_most a b = true <-> (value a <= value b)%Q).
Proof.
  unfold valid, at_most, value, Qle; simpl. intros Ha Hb.
  rewrite !Z2Pos.id by assumption. rewrite Z.leb_le. reflexivity.
Qed.

Lemma not_less a b : valid a -> valid b -> less a b = false -> (value b <= value a)%Q.
Proof.
  intros Ha Hb H. destruct (Qlt_le_dec (value a) (value b)) as [L | L]; [| assumption].
  apply less_is_order in L; congruence.
Qed.

Lemma not_at_most a b : valid a -> valid b -> at_most a b = false -> (value b < value a)%Q.
Proof.
  intros Ha Hb H. destruct (Qlt_le_dec (value b) (value a)) as [L | L]; [assumption |].
  apply at_most_is_order in L; congruence.
Qed.

(** Integers as quotients. *)

Lemma inject_le m n : (inject_Z m <= inject_Z n)%Q <-> m <= n.
Proof. unfold Qle; simpl. lia. Qed.

Lemma inject_lt m n : (inject_Z m < inject_Z n)%Q <-> m < n.
Proof. unfold Qlt; simpl. lia. Qed.

Lemma inject_sub m n : (inject_Z (m - n) == inject_Z m - inject_Z n)%Q.
Proof. unfold Z.sub. rewrite inject_Z_plus, inject_Z_opp. reflexivity. Qed.
