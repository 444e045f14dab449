(* SPDX-License-Identifier: Apache-2.0 *)
(* A number that no guard bounds: where it is finite, a sum that it is in may overflow although the sum of magnitudes
   does not (each is rounded in a mode of its own). Then another rounding of it, of the same sign, stands for it. *)
From Coq Require Import Reals ZArith Lra Lia Bool.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model constants steps format floats float_steps float_guards.
Open Scope R_scope.
#[local] Existing Instances p53 fexp_valid below_1024.

Lemma finite_mag x : finite x -> mag x 1024.
Proof. intros F. split; [exact F|]. apply Rlt_le, abs_B2R_lt_emax. Qed.
Lemma finite_abs x : finite (Babs x) <-> finite x.
Proof. unfold finite. now rewrite is_finite_Babs. Qed.

(* a number below 2^970 and a finite one, added or taken off *)
Definition low_enough k := (k <=? 970)%Z = true.
Lemma wide_sum p x r y k : used p r -> within p k -> low_enough k -> used (Plain x) y ->
  Rabs (r + y) < bpow radix2 1024 /\ Rabs (y - r) < bpow radix2 1024.
Proof.
intros P W K%Z.leb_le [(x' & _ & _ & ->)|(a & b & [] & _)]. pose proof (used_mag _ _ _ P W).
pose proof (abs_B2R_le_emax_minus_prec 53 1024 _ x') as L. fold (value x') in L.
assert (bpow radix2 k < bpow radix2 (1024 - 53)) by (apply bpow_lt; lia).
split; [|unfold Rminus]; apply Rle_lt_trans with (1 := Rabs_triang _ _); rewrite ?Rabs_Ropp; lra.
Qed.

(* the value, or where it is infinite another rounding of the same sum, at least 2^k *)
Definition stands k (z : float) r := (finite z /\ r = value z) \/
  (exists s, z = B754_infinity s /\ (if s then r <= - bpow radix2 k else bpow radix2 k <= r)).
Lemma outcome_stands r z : outcome r z -> Rabs r < bpow radix2 1024 ->
  exists z0, rounded binary64 r z0 /\ stands 1023 z z0.
Proof.
intros O L. destruct (finite_or z) as [F|F].
{ exists (value z). split; [|left; auto]. now apply outcome_rounded; auto. }
exists (round radix2 fexp Ztrunc r). split; [apply (result_rounded Ztrunc); now left|]. right.
destruct O as (m & [(_ & Z & _)|[(N & s & S1 & S2 & E)|(_ & Z & _)]]); try (now destruct z). exists s.
unfold binary_overflow in E. destruct (overflow_to_inf m s); [|destruct z; easy].
split; [destruct z; try easy; simpl in E; congruence|].
assert (P : generic_format radix2 fexp (bpow radix2 1023)) by (apply generic_format_bpow; unfold fexp, FLT_exp; lia).
assert (B : bpow radix2 1023 < bpow radix2 1024) by (apply bpow_lt; lia).
assert (big : bpow radix2 1023 <= Rabs r).
{ apply Rnot_lt_le. intros S. apply Rlt_le in S.
  apply (abs_round_le_generic radix2 fexp (round_mode m)) in S; [lra|exact P]. }
destruct s.
- specialize (S1 eq_refl). rewrite Rabs_left1 in big by exact S1.
  apply round_le_generic; [apply _|apply _|now apply generic_format_opp|lra].
- specialize (S2 eq_refl). rewrite Rabs_right in big by lra. apply round_ge_generic; [apply _|apply _|exact P|lra].
Qed.
Lemma stands_less k j z r : stands k z r -> (j <= k)%Z -> stands j z r.
Proof.
intros [S|(s & E & L)] J; [now left|right]. exists s. split; [exact E|].
assert (bpow radix2 j <= bpow radix2 k) by now apply bpow_le. destruct s; lra.
Qed.
Lemma add_stands p x z k : add floats p (Plain x) z -> within p k -> low_enough k -> finite x ->
  exists z0, add M (real p) (Plain (value x)) z0 /\ stands 1023 z z0.
Proof.
intros S W K F. assert (X : whole (Plain x)) by now split.
destruct (add_used _ _ _ S (or_intror (conj (within_whole _ _ W) X))) as (r & y & P & Y & O).
destruct (outcome_stands _ _ O (proj1 (wide_sum _ _ _ _ _ P W K Y))) as (z0 & Z & D). exists z0. split; [|exact D].
exists r, y. split; [now apply used_uses|]. split; [exact (used_uses _ _ Y)|exact Z].
Qed.
Lemma stands_greater k x y b z j : greater floats x y b -> stands k x z -> mag y j -> (j < k)%Z ->
  greater M z (value y) b.
Proof.
intros S [[F ->]|(s & -> & D)] [Y L] J; [now apply greater_real|].
destruct S as (x' & y' & X & Y' & E). pose proof (finite_reads _ _ Y' Y) as F.
assert (bpow radix2 j < bpow radix2 k) by now apply bpow_lt. apply abs_le in L.
exists z, (value y). split; [now left|]. split; [now left|].
destruct X as [->|(X & _)]; [|discriminate].
rewrite E. destruct s, y'; try discriminate; simpl; split; intros; try easy; lra.
Qed.
Lemma greater_stands k x y b z j : greater floats y x b -> stands k x z -> mag y j -> (j < k)%Z ->
  greater M (value y) z b.
Proof.
intros S [[F ->]|(s & -> & D)] [Y L] J; [now apply greater_real|].
destruct S as (y' & x' & Y' & X & E). pose proof (finite_reads _ _ Y' Y) as F.
assert (bpow radix2 j < bpow radix2 k) by now apply bpow_lt. apply abs_le in L.
exists (value y), z. split; [now left|]. split; [now left|].
destruct X as [->|(X & _)]; [|discriminate].
rewrite E. destruct s, y'; try discriminate; simpl; split; intros; try easy; lra.
Qed.
Lemma stands_abs k x z : stands k x z -> stands k (Babs x) (Rabs z).
Proof.
intros [[F ->]|(s & -> & D)].
- left. split; [exact (proj1 (abs_mag _ _ (finite_mag _ F)))|]. now rewrite value_abs.
- right. exists false. split; [reflexivity|]. pose proof (bpow_gt_0 radix2 k).
  destruct s; [rewrite Rabs_left1|rewrite Rabs_right]; lra.
Qed.

(* on from such a number *)
Lemma uses_itself p : uses binary64 (real p) (value (plain p)).
Proof. destruct p; [now left|left; now left]. Qed.
Lemma rounded_itself r : rounded binary64 r r.
Proof.
split; [|auto]. exists 0, 0. rewrite Rabs_R0. cbn [u n binary64]. repeat split; try apply bpow_ge_0. ring.
Qed.
Lemma infinity_read s x' : reads (B754_infinity s) x' -> x' = B754_infinity s.
Proof. now intros [->|[]]. Qed.
Lemma stands_add k x q z x0 j : add floats (Plain x) q z -> stands k x x0 -> within q j -> low_enough j ->
  (j < k <= 1023)%Z -> exists z0, add M (Plain x0) (real q) z0 /\ stands (k - 1) z z0.
Proof.
intros S [[F ->]|(s & -> & D)] W K J.
- assert (X : whole (Plain x)) by now split.
  destruct (add_used _ _ _ S (or_intror (conj X (within_whole _ _ W)))) as (r & y & P & Y & O).
  rewrite Rplus_comm in O.
  destruct (outcome_stands _ _ O (proj1 (wide_sum _ _ _ _ _ Y W K P))) as (z0 & Z & T). exists z0.
  split; [|apply stands_less with (1 := T); lia]. rewrite Rplus_comm in Z.
  exists r, y. split; [exact (used_uses _ _ P)|]. split; [now apply used_uses|exact Z].
- exists (x0 + value (plain q)). split.
  { exists x0, (value (plain q)). split; [now left|]. split; [apply uses_itself|apply rounded_itself]. }
  right. exists s. pose proof (within_whole _ _ W) as V. split.
  + destruct S as (m & [(x & y & X & Y & Z)|[(a & b & y & [] & _)|(x & a & b & X & P & Z)]]);
      apply infinity_read in X; subst x.
    * pose proof (finite_reads _ _ Y (proj1 V)) as F. destruct Z as [->|[]]; destruct y; easy.
    * destruct (whole_fused _ _ _ V P) as [A B]. destruct Z as [->|[]]; destruct a, b; easy.
  + destruct W as [[_ W%abs_le] _]. assert (T : bpow radix2 k = 2 * bpow radix2 (k - 1))
      by (change 2 with (bpow radix2 1); rewrite <- bpow_plus; f_equal; lia).
    assert (bpow radix2 j <= bpow radix2 (k - 1)) by (apply bpow_le; lia). destruct s; lra.
Qed.
Lemma stands_sub k x q z x0 j : sub floats (Plain x) q z -> stands k x x0 -> within q j -> low_enough j ->
  (j < k <= 1023)%Z -> exists z0, sub M (Plain x0) (real q) z0 /\ stands (k - 1) z z0.
Proof.
intros S [[F ->]|(s & -> & D)] W K J.
- assert (X : whole (Plain x)) by now split.
  destruct (sub_used _ _ _ S (or_intror (conj X (within_whole _ _ W)))) as (r & y & P & Y & O).
  destruct (outcome_stands _ _ O (proj2 (wide_sum _ _ _ _ _ Y W K P))) as (z0 & Z & T). exists z0.
  split; [|apply stands_less with (1 := T); lia].
  exists r, y. split; [exact (used_uses _ _ P)|]. split; [now apply used_uses|exact Z].
- exists (x0 - value (plain q)). split.
  { exists x0, (value (plain q)). split; [now left|]. split; [apply uses_itself|apply rounded_itself]. }
  right. exists s. pose proof (within_whole _ _ W) as V. split.
  + destruct S as (m & [(x & y & X & Y & Z)|[(a & b & y & [] & _)|(x & a & b & X & P & Z)]]);
      apply infinity_read in X; subst x.
    * pose proof (finite_reads _ _ Y (proj1 V)) as F. destruct Z as [->|[]]; destruct y; easy.
    * destruct (whole_fused _ _ _ V P) as [A B]. destruct Z as [->|[]]; destruct a, b; easy.
  + destruct W as [[_ W%abs_le] _]. assert (T : bpow radix2 k = 2 * bpow radix2 (k - 1))
      by (change 2 with (bpow radix2 1); rewrite <- bpow_plus; f_equal; lia).
    assert (bpow radix2 j <= bpow radix2 (k - 1)) by (apply bpow_le; lia). destruct s; lra.
Qed.

(* a bound that an infinity or NaN is in is beaten by nothing *)
Lemma product_finite x y z : mul floats x y z -> finite z -> finite y.
Proof.
intros S Z. destruct (mul_used _ _ _ S (or_introl Z)) as (a & b & A & B & _ & F & _). eauto using reads_finite.
Qed.
Lemma bound_terms c terms t a b : mul floats c terms t -> add floats (Product c terms t) (Plain a) b -> finite b ->
  finite terms.
Proof.
intros S A F. destruct (add_used _ _ _ A (or_introl F)) as (x & y & [(t' & T & G & _)|(d & e & [_ E] & _ & G & _)] & _).
- apply (product_finite _ _ _ S). eauto using reads_finite.
- eauto using reads_finite.
Qed.
Lemma right_finite p x z : add floats p (Plain x) z -> finite z -> finite x.
Proof.
intros A F. destruct (add_used _ _ _ A (or_introl F)) as (r & y & _ & [(x' & X & G & _)|(d & e & [] & _)] & _).
eauto using reads_finite.
Qed.
Lemma left_finite p x z : add floats (Plain x) p z -> finite z -> finite x.
Proof.
intros A F. destruct (add_used _ _ _ A (or_introl F)) as (y & r & [(x' & X & G & _)|(d & e & [] & _)] & _).
eauto using reads_finite.
Qed.
Lemma opposite_bound_finite x y : greater floats (Bopp y) x true -> up y -> finite y.
Proof.
intros (y' & x' & Y & X & E) U. destruct (finite_or y) as [A|A]; [exact A|]. exfalso.
assert (y' = Bopp y) as -> by (destruct Y as [->|[Y _]]; [reflexivity|destruct y; easy]).
destruct y as [|s| |]; simpl in A, U; try easy; try subst s; destruct x' as [|[]| |[]]; discriminate.
Qed.
Lemma terms_real p x z k : add floats p (Plain x) z -> finite z -> within p k -> low_enough k ->
  add M (real p) (Plain (value x)) (value z).
Proof.
intros S F W K. destruct (add_used _ _ _ S (or_introl F)) as (r & y & P & Y & O). exists r, y.
split; [now apply used_uses|]. split; [exact (used_uses _ _ Y)|].
apply outcome_rounded; auto. right. exact (proj1 (wide_sum _ _ _ _ _ P W K Y)).
Qed.
Lemma more_terms_real x q z k : add floats (Plain x) q z -> finite z -> within q k -> low_enough k ->
  add M (Plain (value x)) (real q) (value z).
Proof.
intros S F W K. destruct (add_used _ _ _ S (or_introl F)) as (y & r & Y & Q & O). exists y, r.
split; [exact (used_uses _ _ Y)|]. split; [now apply used_uses|].
apply outcome_rounded; auto. right. rewrite Rplus_comm. exact (proj1 (wide_sum _ _ _ _ _ Q W K Y)).
Qed.
Lemma less_real x q z k : sub floats (Plain x) q z -> finite z -> within q k -> low_enough k ->
  sub M (Plain (value x)) (real q) (value z).
Proof.
intros S F W K. destruct (sub_used _ _ _ S (or_introl F)) as (y & r & Y & Q & O). exists y, r.
split; [exact (used_uses _ _ Y)|]. split; [now apply used_uses|].
apply outcome_rounded; auto. right. exact (proj2 (wide_sum _ _ _ _ _ Q W K Y)).
Qed.
Lemma off_real p x z k : sub floats p (Plain x) z -> finite z -> within p k -> low_enough k ->
  sub M (real p) (Plain (value x)) (value z).
Proof.
intros S F W K. destruct (sub_used _ _ _ S (or_introl F)) as (r & y & P & Y & O). exists r, y.
split; [now apply used_uses|]. split; [exact (used_uses _ _ Y)|].
apply outcome_rounded; auto. right. rewrite Rabs_minus_sym. exact (proj2 (wide_sum _ _ _ _ _ P W K Y)).
Qed.
