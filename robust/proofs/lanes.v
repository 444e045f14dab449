(* SPDX-License-Identifier: Apache-2.0 *)
(* A lane of the filters of robust/batch/isa: functions on all of binary64, rounded to nearest, nothing flushed. What
   lanes.py writes from their C++ text is made of these. No sum of a product is contracted but that of multiply_add,
   which an instruction set rounds once (fused) or twice. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Flocq Require Import Core Relative Plus_error IEEE754.BinarySingleNaN.
From Filters Require Import model constants steps format floats.
Open Scope R_scope.
#[local] Existing Instances p53 fexp_valid below_1024.

Definition number m e : float := binary_normalize 53 1024 _ _ mode_NE m e false.
Definition plus : float -> float -> float := Bplus mode_NE.
Definition minus : float -> float -> float := Bminus mode_NE.
Definition times : float -> float -> float := Bmult mode_NE.
Definition multiply_add (fused : bool) a b c := if fused then Bfma mode_NE a b c else plus (times a b) c.
Definition size (x : float) : float := Babs x.
Definition negated (x : float) : float := Bopp x.
Definition infinity : float := B754_infinity false.
Definition above (x y : float) := match Bcompare x y with Some Gt => true | _ => false end.
Definition not_below (x y : float) := match Bcompare x y with Some Gt => true | Some Eq => true | _ => false end.
Definition equal (x y : float) := match Bcompare x y with Some Eq => true | _ => false end.
Definition negative_lane (x : float) := Bsign x.
(* The second where one of them is NaN, and of two zeros. *)
Definition lesser (x y : float) := if above y x then x else y.
Definition greater_of (x y : float) := if above x y then x else y.

Definition rnd r := round radix2 fexp ZnearestE r.
Definition v := / 2 * bpow radix2 (-52).
Definition eta := / 2 * bpow radix2 (-1074).
Notation high := (bpow radix2 1024).

Lemma v_is : v = / 9007199254740992. Proof. unfold v. simpl. lra. Qed.
Lemma eta_pos : 0 < eta. Proof. unfold eta. pose proof (bpow_gt_0 radix2 (-1074)). lra. Qed.

(* Real numbers that lanes hold. *)
Definition held r := generic_format radix2 fexp r.
Lemma held_value x : held (value x). Proof. apply generic_format_B2R. Qed.
Lemma held_rnd r : held (rnd r). Proof. apply generic_format_round; auto with typeclass_instances. Qed.
Lemma held_abs r : held r -> held (Rabs r). Proof. apply generic_format_abs. Qed.
Lemma rnd_le x y : x <= y -> rnd x <= rnd y. Proof. apply round_le; auto with typeclass_instances. Qed.
Lemma rnd_0 : rnd 0 = 0. Proof. apply round_0; auto with typeclass_instances. Qed.
Lemma rnd_held x : held x -> rnd x = x. Proof. apply round_generic; auto with typeclass_instances. Qed.
Lemma rnd_pos x : 0 <= x -> 0 <= rnd x. Proof. rewrite <- rnd_0 at 2. apply rnd_le. Qed.
Lemma rnd_neg x : x <= 0 -> rnd x <= 0. Proof. rewrite <- rnd_0 at 2. apply rnd_le. Qed.
Lemma rnd_opp x : rnd (- x) = - rnd x.
Proof. unfold rnd. rewrite round_NE_opp. reflexivity. Qed.
Lemma rnd_abs x : Rabs (rnd x) = rnd (Rabs x).
Proof.
destruct (Rle_or_lt 0 x) as [P|P].
- now rewrite !Rabs_right by (apply Rle_ge; auto using rnd_pos).
- rewrite (Rabs_left x P), rnd_opp, Rabs_left1; [reflexivity|]. apply rnd_neg. lra.
Qed.
Lemma rnd_sum x y : held x -> held y -> exists e, Rabs e <= v /\ rnd (x + y) = (x + y) * (1 + e).
Proof.
intros X Y. destruct (FLT_plus_error_N_ex radix2 (-1074) 53 (fun x => negb (Z.even x)) x y X Y) as (e & E & Z).
exists e. split; [|exact Z]. apply Rle_trans with (1 := E). unfold u_ro, v.
replace (- (53) + 1)%Z with (-52)%Z by ring. pose proof (bpow_gt_0 radix2 (-52)).
apply Rmult_le_reg_r with (1 + / 2 * bpow radix2 (-52)); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. nra.
Qed.
Lemma rnd_difference x y : held x -> held y -> exists e, Rabs e <= v /\ rnd (x - y) = (x - y) * (1 + e).
Proof. intros X Y. apply rnd_sum; [exact X|]. now apply generic_format_opp. Qed.
Lemma rnd_any x : exists e h, Rabs e <= v /\ Rabs h <= eta /\ rnd x = x * (1 + e) + h.
Proof.
destruct (error_N_FLT radix2 (-1074) 53 eq_refl (fun x => negb (Z.even x)) x) as (e & h & E & H & _ & Z).
exists e, h. split; [|split]; [|exact H|exact Z]. unfold v. apply Rle_trans with (1 := E).
replace (- (53) + 1)%Z with (-52)%Z by ring. lra.
Qed.

(* What an operation gives that is finite. *)
Lemma not_finite_overflow (z : float) s : B2SF z = binary_overflow 53 1024 mode_NE s -> z = B754_infinity s.
Proof. unfold binary_overflow. simpl. destruct z; simpl; congruence. Qed.
Ltac cases_of correct := generalize correct; cbv zeta; change (SpecFloat.fexp 53 1024) with fexp;
  change (@B2R 53 1024) with value; change (round_mode mode_NE) with ZnearestE;
  match goal with |- (if Rlt_bool ?a ?b then _ else _) -> _ => destruct (Rlt_bool_spec a b) as [L|L] end.
Lemma plus_finite x y : finite (plus x y) -> finite x /\ finite y /\ value (plus x y) = rnd (value x + value y).
Proof.
intros Z. assert (F : finite x /\ finite y) by (destruct x as [|[]| |], y as [|[]| |]; try discriminate Z; now split).
destruct F as [X Y]. split; [exact X|]. split; [exact Y|]. unfold plus in *.
cases_of (Bplus_correct 53 1024 _ _ mode_NE x y X Y); [now intros [-> _]|].
intros [E%not_finite_overflow _]. rewrite E in Z. discriminate Z.
Qed.
Lemma minus_finite x y : finite (minus x y) -> finite x /\ finite y /\ value (minus x y) = rnd (value x - value y).
Proof.
intros Z. assert (F : finite x /\ finite y) by (destruct x as [|[]| |], y as [|[]| |]; try discriminate Z; now split).
destruct F as [X Y]. split; [exact X|]. split; [exact Y|]. unfold minus in *.
cases_of (Bminus_correct 53 1024 _ _ mode_NE x y X Y); [now intros [-> _]|].
intros [E%not_finite_overflow _]. rewrite E in Z. discriminate Z.
Qed.
Lemma times_finite x y : finite (times x y) -> finite x /\ finite y /\ value (times x y) = rnd (value x * value y).
Proof.
intros Z. assert (F : finite x /\ finite y) by (destruct x as [|[]| |], y as [|[]| |]; try discriminate Z; now split).
destruct F as [X Y]. split; [exact X|]. split; [exact Y|]. unfold times in *.
cases_of (Bmult_correct 53 1024 _ _ mode_NE x y); [now intros [-> _]|].
intros E%not_finite_overflow. rewrite E in Z. discriminate Z.
Qed.
Lemma multiply_add_finite fused a b c : finite (multiply_add fused a b c) -> finite a /\ finite b /\ finite c /\
  (value (multiply_add fused a b c) = rnd (value a * value b + value c) \/
   value (multiply_add fused a b c) = rnd (rnd (value a * value b) + value c)).
Proof.
unfold multiply_add. destruct fused; intros Z.
- assert (F : finite a /\ finite b /\ finite c).
  { destruct a as [[]|[]| |[]], b as [[]|[]| |[]], c as [[]|[]| |[]]; try discriminate Z; repeat split. }
  destruct F as (A & B & C). split; [exact A|]. split; [exact B|]. split; [exact C|]. left.
  cases_of (Bfma_correct 53 1024 _ _ mode_NE a b c A B C); [now intros [-> _]|].
  intros E%not_finite_overflow. rewrite E in Z. discriminate Z.
- apply plus_finite in Z as (P & C & E). apply times_finite in P as (A & B & EP).
  split; [exact A|]. split; [exact B|]. split; [exact C|]. right. now rewrite E, EP.
Qed.
Lemma size_finite x : finite (size x) -> finite x /\ value (size x) = Rabs (value x).
Proof. intros Z. split; [now destruct x|apply B2R_Babs]. Qed.
Lemma number_value m e : (Z.abs m < 2 ^ 53)%Z -> (-1074 <= e <= 971)%Z ->
  finite (number m e) /\ value (number m e) = IZR m * bpow radix2 e.
Proof.
intros M E. assert (G : held (F2R (Float radix2 m e))).
{ apply generic_format_FLT. exists (Float radix2 m e); [reflexivity|exact M|simpl; lia]. }
unfold number. cases_of (binary_normalize_correct 53 1024 _ _ mode_NE m e false).
- intros (V & F & _). split; [exact F|]. rewrite V. now apply rnd_held.
- exfalso. apply Rle_not_lt in L. apply L. change (Rabs (rnd (F2R (Float radix2 m e))) < high).
  rewrite (rnd_held _ G), <- F2R_Zabs. apply Rlt_le_trans with (bpow radix2 (53 + e)).
  + rewrite bpow_plus. apply Rmult_lt_compat_r; [apply bpow_gt_0|]. simpl Fnum. change (bpow radix2 53) with (IZR (2
    ^ 53)).
    now apply IZR_lt.
  + apply bpow_le. lia.
Qed.

(* Comparisons. *)
Lemma above_true x y : above x y = true -> finite y -> (finite x /\ value y < value x) \/ x = B754_infinity false.
Proof.
unfold above. intros A Y. destruct (is_finite x) eqn:X.
- left. split; [exact X|]. rewrite Bcompare_correct in A by assumption. revert A.
  change (@B2R 53 1024) with value. destruct (Rcompare_spec (value x) (value y)); easy.
- right. destruct x as [|[]| |], y as [|[]| |]; try discriminate X; try discriminate Y; try discriminate A; reflexivity.
Qed.
Lemma above_finite x y : finite x -> finite y -> above x y = true <-> value y < value x.
Proof.
intros X Y. unfold above. rewrite Bcompare_correct by assumption. change (@B2R 53 1024) with value.
destruct (Rcompare_spec (value x) (value y)); split; intros; try easy; lra.
Qed.
Lemma above_bound x y : above x y = true -> up y -> finite y.
Proof. unfold above. destruct x as [|[]| |], y as [|[]| |]; intros A U; try discriminate; reflexivity. Qed.
Lemma not_below_finite x y : finite x -> finite y -> not_below x y = true <-> value y <= value x.
Proof.
intros X Y. unfold not_below. rewrite Bcompare_correct by assumption. change (@B2R 53 1024) with value.
destruct (Rcompare_spec (value x) (value y)); split; intros; try easy; lra.
Qed.

(* Not negative, or NaN. *)
Lemma up_size x : up (size x). Proof. now destruct x. Qed.
Lemma finite_case (x : float) : finite x \/ x = B754_infinity true \/ x = B754_infinity false \/ x = B754_nan.
Proof. destruct x as [|[]| |]; auto; left; reflexivity. Qed.
Lemma up_plus x y : up x -> up y -> up (plus x y).
Proof.
intros X Y. destruct (finite_case x) as [A|[->|[->| ->]]]; try discriminate X;
  destruct (finite_case y) as [B|[->|[->| ->]]]; try discriminate Y; try reflexivity; try (now destruct x); try (now
    destruct y).
apply (outcome_up _ _ (outcome_add mode_NE x y A B)). apply up_value in X, Y. lra.
Qed.
Lemma up_times x y : up x -> up y -> up (times x y).
Proof.
intros X Y. destruct (finite_case x) as [A|[->|[->| ->]]]; try discriminate X;
  destruct (finite_case y) as [B|[->|[->| ->]]]; try discriminate Y; try reflexivity;
  try (destruct x as [| | |[]]; try discriminate X; easy); try (destruct y as [| | |[]]; try discriminate Y; easy).
apply (outcome_up _ _ (outcome_mul mode_NE x y A B)). apply up_value in X, Y. nra.
Qed.
Lemma up_multiply_add fused a b c : up a -> up b -> up c -> up (multiply_add fused a b c).
Proof.
intros A B C. unfold multiply_add. destruct fused; [|now apply up_plus, C; apply up_times].
destruct (is_finite a && is_finite b && is_finite c) eqn:Q.
2:{ destruct a as [|[]| |[]], b as [|[]| |[]], c as [|[]| |[]]; try discriminate; easy. }
apply andb_prop in Q as [[X Y]%andb_prop Z].
apply (outcome_up _ _ (outcome_fma mode_NE a b c X Y Z)). apply up_value in A, B, C. nra.
Qed.
Lemma up_number m e : (0 <= m < 2 ^ 53)%Z -> (-1074 <= e <= 971)%Z -> up (number m e).
Proof.
intros M E. destruct (number_value m e) as [F V]; [lia|exact E|]. apply up_finite; [exact F|]. rewrite V.
apply Rmult_le_pos; [apply IZR_le; lia|apply bpow_ge_0].
Qed.
