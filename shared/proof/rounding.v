(** Divisions that round: shared/include/platon/exact/integer.h. The division of C++ rounds towards zero: [Z.quot]. *)
From Coq Require Import ZArith Lia.
Open Scope Z_scope.

Definition divideFloor (numerator denominator : Z) : Z :=
  let quotient := Z.quot numerator denominator in
  if Z.rem numerator denominator <? 0 then quotient - 1 else quotient.

Definition divideCeiling (numerator denominator : Z) : Z :=
  let quotient := Z.quot numerator denominator in
  if 0 <? Z.rem numerator denominator then quotient + 1 else quotient.

Definition divideRounded (numerator denominator : Z) : Z :=
  let half := Z.quot denominator 2 in
  if 0 <=? numerator then Z.quot (numerator + half) denominator else - Z.quot (- numerator + half) denominator.

(** A shift to the right rounds towards minus infinity. *)
Definition shiftRounded (bits value : Z) : Z :=
  Z.shiftr (value + 2 ^ (bits - 1) - (if value <? 0 then 1 else 0)) bits.

(** The largest integer that is at most the quotient. *)
Theorem divideFloor_is_floor n d : 0 < d -> divideFloor n d * d <= n < (divideFloor n d + 1) * d.
Proof.
  intros D. unfold divideFloor. pose proof (Z.quot_rem' n d) as E. set (q := Z.quot n d) in *. set (r := Z.rem n d) in *.
  assert (R : - d < r < d).
  { pose proof (Z.rem_bound_abs n d ltac:(lia)) as B. fold r in B. lia. }
  clearbody q r. destruct (Z.ltb_spec r 0); nia.
Qed.

(** The smallest integer that is at least the quotient. *)
Theorem divideCeiling_is_ceiling n d : 0 < d -> (divideCeiling n d - 1) * d < n <= divideCeiling n d * d.
Proof.
  intros D. unfold divideCeiling. pose proof (Z.quot_rem' n d) as E. set (q := Z.quot n d) in *. set (r := Z.rem n d) in *.
  assert (R : - d < r < d).
  { pose proof (Z.rem_bound_abs n d ltac:(lia)) as B. fold r in B. lia. }
  clearbody q r. destruct (Z.ltb_spec 0 r); nia.
Qed.

(** The nearest integer; of two, the one farther from zero. *)
Theorem divideRounded_is_nearest n d : 0 < d ->
  2 * Z.abs (n - divideRounded n d * d) <= d /\
  (2 * Z.abs (n - divideRounded n d * d) = d -> Z.abs n < Z.abs (divideRounded n d * d)).
Proof.
  intros D. unfold divideRounded. rewrite (Z.quot_div_nonneg d 2) by lia.
  pose proof (Z.div_mod d 2 ltac:(lia)) as H. pose proof (Z.mod_pos_bound d 2 ltac:(lia)) as HB.
  set (h := d / 2) in *. set (m := d mod 2) in *. clearbody h m.
  destruct (Z.leb_spec 0 n) as [N | N].
  - rewrite Z.quot_div_nonneg by lia. pose proof (Z.div_mod (n + h) d ltac:(lia)) as E.
    pose proof (Z.mod_pos_bound (n + h) d D) as B. pose proof (Z.div_pos (n + h) d ltac:(lia) D) as Q.
    set (q := (n + h) / d) in *. set (r := (n + h) mod d) in *. clearbody q r. nia.
  - rewrite Z.quot_div_nonneg by lia. pose proof (Z.div_mod (- n + h) d ltac:(lia)) as E.
    pose proof (Z.mod_pos_bound (- n + h) d D) as B. pose proof (Z.div_pos (- n + h) d ltac:(lia) D) as Q.
    set (q := (- n + h) / d) in *. set (r := (- n + h) mod d) in *. clearbody q r. nia.
Qed.

Theorem divideRounded_is_symmetric n d : 0 < d -> divideRounded (- n) d = - divideRounded n d.
Proof.
  intros D. unfold divideRounded. destruct (Z.leb_spec 0 n) as [N | N], (Z.leb_spec 0 (- n)) as [M | M]; try lia.
  - assert (n = 0) by lia. subst. simpl. rewrite Z.quot_div_nonneg, Z.quot_div_nonneg by (try apply Z.quot_pos; lia).
    rewrite Z.div_small; [reflexivity |]. split; [apply Z.div_pos; lia | apply Z.div_lt; lia].
  - rewrite Z.opp_involutive. reflexivity.
Qed.

(* Two integers that are nearest, with the same choice at a tie, are equal. *)
Definition isNearest (n d q : Z) : Prop :=
  2 * Z.abs (n - q * d) <= d /\ (2 * Z.abs (n - q * d) = d -> Z.abs n < Z.abs (q * d)).

Lemma nearest_not_below n d p q : 0 < d -> isNearest n d p -> isNearest n d q -> ~ p < q.
Proof.
  intros D [P P'] [Q Q'] L. assert (M : 1 * d <= (q - p) * d) by (apply Z.mul_le_mono_nonneg_r; lia).
  rewrite Z.mul_sub_distr_r in M. assert (E : q * d - p * d = d) by lia.
  assert (2 * Z.abs (n - p * d) = d) by lia. assert (2 * Z.abs (n - q * d) = d) by lia.
  assert (A : Z.abs n < Z.abs (p * d)) by auto. assert (B : Z.abs n < Z.abs (q * d)) by auto.
  assert (C : 0 <= p * d \/ p * d <= (-1) * d).
  { destruct (Z_le_gt_dec 0 p); [left; apply Z.mul_nonneg_nonneg; lia | right; apply Z.mul_le_mono_nonneg_r; lia]. }
  set (u := p * d) in *. set (w := q * d) in *. clearbody u w. lia.
Qed.

Lemma nearest_is_unique n d p q : 0 < d -> isNearest n d p -> isNearest n d q -> p = q.
Proof.
  intros D P Q. pose proof (nearest_not_below n d p q D P Q). pose proof (nearest_not_below n d q p D Q P). lia.
Qed.

(** A shift rounds as the division does. *)
Theorem shiftRounded_is_divideRounded bits value : 0 < bits -> shiftRounded bits value = divideRounded value (2 ^ bits).
Proof.
  intros B. assert (D : 0 < 2 ^ bits) by (apply Z.pow_pos_nonneg; lia).
  apply (nearest_is_unique value (2 ^ bits)); [assumption | | apply divideRounded_is_nearest; assumption].
  unfold isNearest, shiftRounded. rewrite Z.shiftr_div_pow2 by lia.
  assert (H : 2 ^ bits = 2 * 2 ^ (bits - 1)) by (rewrite <- Z.pow_succ_r by lia; f_equal; lia).
  set (c := if value <? 0 then 1 else 0). assert (C : (value < 0 /\ c = 1) \/ (0 <= value /\ c = 0)).
  { unfold c. destruct (Z.ltb_spec value 0); [left | right]; split; lia. }
  rewrite H in *. set (h := 2 ^ (bits - 1)) in *. clearbody h c.
  pose proof (Z.div_mod (value + h - c) (2 * h) ltac:(lia)) as E. pose proof (Z.mod_pos_bound (value + h - c) (2 * h) D) as R.
  set (q := (value + h - c) / (2 * h)) in *. set (r := (value + h - c) mod (2 * h)) in *. clearbody q r.
  assert (V : value = 2 * h * q + r - h + c) by lia. destruct C as [[C ->] | [C ->]]; split; nia.
Qed.
