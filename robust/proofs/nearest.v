(* SPDX-License-Identifier: Apache-2.0 *)
(* Rounding to nearest with 53 digits and exponents without end, ties to even or away from zero; heads of 26 digits. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core Relative Sterbenz Plus_error Pff2Flocq.
From Filters Require Import arithmetic enclosed.
Open Scope R_scope.

Notation u := half_ulp.
Notation E := cut.
Definition digits k x := generic_format radix2 (FLX_exp k) x.
Notation float := (digits precision).
Definition multiple e x := exists m, x = IZR m * bpow radix2 e.

#[export] Instance p53 : Prec_gt_0 53. Proof. reflexivity. Qed.
#[export] Instance p26 : Prec_gt_0 26. Proof. reflexivity. Qed.
#[export] Instance p52 : Prec_gt_0 52. Proof. reflexivity. Qed.

Lemma abs_le x a : Rabs x <= a -> - a <= x <= a.
Proof.
intros H. split; [|apply Rle_trans with (2 := H), Rle_abs]. generalize (Rle_abs (- x)); rewrite Rabs_Ropp; lra.
Qed.
Lemma le_abs x a : - a <= x <= a -> Rabs x <= a.
Proof. intros. apply Rabs_le; lra. Qed.
Lemma prod_le x y a b A B : Rabs x <= a * A -> Rabs y <= b * B -> Rabs (x * y) <= a * b * (A * B).
Proof.
intros X Y. rewrite Rabs_mult. replace (a * b * (A * B)) with ((a * A) * (b * B)) by ring.
apply Rmult_le_compat; auto using Rabs_pos.
Qed.

(* multiples of a power of two *)
Lemma multiple_plus e x y : multiple e x -> multiple e y -> multiple e (x + y).
Proof. intros [m ->] [k ->]. exists (m + k)%Z. rewrite plus_IZR. ring. Qed.
Lemma multiple_opp e x : multiple e x -> multiple e (- x).
Proof. intros [m ->]. exists (- m)%Z. rewrite opp_IZR. ring. Qed.
Lemma multiple_minus e x y : multiple e x -> multiple e y -> multiple e (x - y).
Proof. intros X Y. apply multiple_plus; [|apply multiple_opp]; assumption. Qed.
Lemma multiple_times d e x y : multiple d x -> multiple e y -> multiple (d + e) (x * y).
Proof. intros [m ->] [k ->]. exists (m * k)%Z. rewrite mult_IZR, bpow_plus. ring. Qed.
Lemma multiple_abs e x : multiple e x -> multiple e (Rabs x).
Proof. intros X. unfold Rabs. destruct (Rcase_abs x); [now apply multiple_opp|exact X]. Qed.
Lemma multiple_down d e x : (d <= e)%Z -> multiple e x -> multiple d x.
Proof.
intros L [m ->]. exists (m * 2 ^ (e - d))%Z. change 2%Z with (radix_val radix2).
rewrite mult_IZR, IZR_Zpower, Rmult_assoc, <- bpow_plus by lia. do 2 f_equal. ring.
Qed.
Lemma multiple_of_digits k e x : (0 < k)%Z -> digits k x -> (x = 0 \/ bpow radix2 e <= Rabs x) ->
  multiple (e + 1 - k) x.
Proof.
intros K D [->|L].
- exists 0%Z. ring.
- assert (N : x <> 0) by (intros ->; rewrite Rabs_R0 in L; pose proof (bpow_gt_0 radix2 e); lra).
  destruct (ex_shift radix2 (FLX_exp k) x (e + 1 - k)) as [m ->]; [assumption| |now exists m].
  unfold cexp, FLX_exp. assert (e + 1 <= mag radix2 x)%Z; [|lia]. apply mag_ge_bpow.
  now replace (e + 1 - 1)%Z with e by ring.
Qed.
Lemma multiple_zero_or e x : multiple e x -> x = 0 \/ bpow radix2 e <= Rabs x.
Proof.
intros [m ->]. destruct (Z.eq_dec m 0) as [->|N]; [left; ring|right].
rewrite Rabs_mult, (Rabs_right (bpow _ _)) by (apply Rle_ge, bpow_ge_0).
rewrite <- abs_IZR. assert (1 <= IZR (Z.abs m)) by (apply IZR_le; lia). pose proof (bpow_gt_0 radix2 e). nra.
Qed.

Section Rounds.
Variable mode : R -> Z.
Context {V : Valid_rnd mode}.
Lemma multiple_round fexp {W : Valid_exp fexp} e x : multiple e x -> multiple e (round radix2 fexp mode x).
Proof. intros [m ->]. destruct (round_repr_same_exp radix2 fexp mode m e) as [m' H]. now exists m'. Qed.
End Rounds.
Lemma bounded_below m e k : (0 <= k)%Z -> Rabs (IZR m * bpow radix2 e) < bpow radix2 (e + k) -> (Z.abs m < 2 ^ k)%Z.
Proof.
intros K L. apply lt_IZR. change (2 ^ k)%Z with (radix_val radix2 ^ k)%Z. rewrite IZR_Zpower by exact K.
apply Rmult_lt_reg_r with (bpow radix2 e); [apply bpow_gt_0|]. rewrite <- bpow_plus, (Z.add_comm k), abs_IZR.
rewrite Rabs_mult, (Rabs_right (bpow _ _)) in L by (apply Rle_ge, bpow_ge_0). exact L.
Qed.
Lemma digits_of_multiple k e x : (0 < k)%Z -> multiple e x -> Rabs x < bpow radix2 (e + k) -> digits k x.
Proof.
intros K [m ->] L. apply bounded_below in L; [|lia].
apply generic_format_FLX. now exists (Float radix2 m e).
Qed.
Lemma subnormal_too emin x : float x -> multiple emin x -> generic_format radix2 (FLT_exp emin 53) x.
Proof.
intros D X. destruct (Rle_or_lt (bpow radix2 (emin + 53 - 1)) (Rabs x)) as [B|B].
- now apply generic_format_FLT_FLX.
- destruct X as [m ->]. apply generic_format_FLT. exists (Float radix2 m emin); simpl; auto; [|lia].
  change (Z.abs m < 2 ^ 53)%Z. apply bounded_below with emin; [lia|]. apply Rlt_le_trans with (1 := B), bpow_le. lia.
Qed.

(* binary64 with gradual underflow rounds such multiples as if exponents had no end *)
Lemma round_same mode {V : Valid_rnd mode} e emin x : (emin <= e)%Z -> multiple e x ->
  round radix2 (FLT_exp emin 53) mode x = round radix2 (FLX_exp 53) mode x.
Proof.
intros L X. destruct (Rle_or_lt (bpow radix2 (emin + 53 - 1)) (Rabs x)) as [B|B]; [now apply round_FLT_FLX|].
apply multiple_down with (1 := L) in X.
assert (D : float x).
{ apply digits_of_multiple with emin; [reflexivity|exact X|]. apply Rlt_le_trans with (1 := B), bpow_le.
  unfold precision. lia. }
rewrite !round_generic; auto using subnormal_too with typeclass_instances.
Qed.

Section Nearest.
Variable choice : Z -> bool.
Hypothesis symmetric : forall x, choice x = negb (choice (- (x + 1))).
Definition nearest := round radix2 (FLX_exp 53) (Znearest choice).
Notation cut_to_head := (round radix2 (FLX_exp 26) Ztrunc).

Lemma nearest_digits x : float (nearest x).
Proof. apply generic_format_round; auto with typeclass_instances. Qed.
Lemma nearest_exact x : float x -> nearest x = x.
Proof. intros. apply round_generic; auto with typeclass_instances. Qed.
Lemma nearest_le x y : x <= y -> nearest x <= nearest y.
Proof. intros. apply round_le; auto with typeclass_instances. Qed.
Lemma u_is : / 2 * bpow radix2 (- (53) + 1) = u.
Proof. unfold u, bpow. simpl. lra. Qed.
Lemma near x B : Rabs x <= B -> - (u * B) <= nearest x - x <= u * B.
Proof.
intros L. apply abs_le. apply Rle_trans with (1 := relative_error_N_FLX radix2 53 eq_refl choice x).
rewrite u_is. apply Rmult_le_compat_l; [unfold u; lra|exact L].
Qed.
Lemma near_pos x : 0 <= x -> (1 - u) * x <= nearest x <= (1 + u) * x.
Proof. intros P. pose proof (near x x ltac:(rewrite Rabs_right; lra)). lra. Qed.
Lemma near_own x : Rabs (nearest x - x) <= u * Rabs (nearest x).
Proof. rewrite <- u_is. exact (relative_error_N_FLX_round radix2 53 eq_refl choice x). Qed.

Lemma nearest_opp x : nearest (- x) = - nearest x.
Proof.
unfold nearest. rewrite round_N_opp. f_equal. apply round_ext. intros y. unfold Znearest.
now rewrite <- symmetric.
Qed.

(* 2Sum is exact. *)
Lemma two_sum_exact a b s o : float a -> float b -> s = nearest (a + b) -> o = nearest (s - a) ->
  s + nearest (nearest (a - nearest (s - o)) + nearest (b - o)) = a + b.
Proof.
intros A B -> ->.
assert (N : exists e, (e <= 0)%Z /\ multiple e a /\ multiple e b).
{ assert (M : forall x, float x -> exists e, multiple e x).
  { intros x X. destruct (Req_dec x 0) as [->|N]; [exists 0%Z, 0%Z; ring|].
    exists (mag radix2 x - 1 + 1 - precision)%Z. apply multiple_of_digits; [reflexivity|exact X|right].
    now apply bpow_mag_le. }
  destruct (M a A) as [d D], (M b B) as [e H]. exists (Z.min 0 (Z.min d e)).
  split; [lia|]. split; [apply multiple_down with d|apply multiple_down with e]; auto; lia. }
destruct N as (e & L & MA & MB).
pose proof (TwoSum_correct e 53 choice eq_refl L symmetric a b (subnormal_too _ _ A MA) (subnormal_too _ _ B MB)) as T.
assert (R : forall x, multiple e x -> round radix2 (FLT_exp e 53) (Znearest choice) x =
  round radix2 (FLX_exp 53) (Znearest choice) x).
{ intros. apply round_same with e; auto with typeclass_instances. apply Z.le_refl. }
cbv zeta in T. rewrite !R in T by repeat (assumption || apply multiple_plus || apply multiple_opp ||
  (apply multiple_round; auto with typeclass_instances)).
exact T.
Qed.
Lemma difference_exact a b s o : float a -> float b -> s = nearest (a - b) -> o = nearest (a - s) ->
  s + nearest (nearest (a - nearest (s + o)) + nearest (o - b)) = a - b.
Proof.
intros A B Hs Ho.
assert (N : - o = nearest (s - a)) by (rewrite Ho, <- nearest_opp; f_equal; ring).
pose proof (two_sum_exact a (- b) s (- o) A (generic_format_opp _ _ _ B) Hs N) as T.
replace (s + o) with (s - - o) by ring. replace (o - b) with (- b - - o) by ring. exact T.
Qed.

(* heads *)
Lemma head_digits x : digits 26 (cut_to_head x).
Proof. apply generic_format_round; auto with typeclass_instances. Qed.
Lemma digits_up j k x : (j <= k)%Z -> digits j x -> digits k x.
Proof. intros L. apply generic_inclusion_mag. unfold FLX_exp. lia. Qed.
Lemma digits_product j k x y : digits j x -> digits k y -> (0 < j)%Z -> (0 < k)%Z -> digits (j + k) (x * y).
Proof.
intros X Y J K. apply FLX_format_generic in X; [|exact J]. apply FLX_format_generic in Y; [|exact K].
destruct X as [[m e] -> M], Y as [[n f] -> N]. apply generic_format_FLX.
exists (Float radix2 (m * n) (e + f)); simpl in *.
- unfold F2R. simpl. rewrite mult_IZR, bpow_plus. ring.
- rewrite Z.abs_mul, Z.pow_add_r by lia. apply Z.mul_lt_mono_nonneg; auto using Z.abs_nonneg.
Qed.
Lemma head_product x y : digits 26 x -> digits 26 y -> float (x * y).
Proof. intros X Y. apply digits_up with (26 + 26)%Z; [easy|]. now apply digits_product. Qed.
Lemma head_0 : cut_to_head 0 = 0.
Proof. apply round_0; auto with typeclass_instances. Qed.
Lemma head_near x : Rabs (x - cut_to_head x) <= / 2 ^ 25 * Rabs (cut_to_head x).
Proof.
destruct (Req_dec x 0) as [->|N]; [rewrite head_0, Rminus_0_r, Rabs_R0; lra|].
pose proof (error_lt_ulp radix2 (FLX_exp 26) Ztrunc x N) as L. rewrite Rabs_minus_sym. apply Rlt_le.
apply Rlt_le_trans with (1 := L). rewrite ulp_neq_0 by exact N. unfold cexp, FLX_exp.
assert (B : bpow radix2 (mag radix2 x - 1) <= Rabs (cut_to_head x)).
{ apply abs_round_ge_generic; auto with typeclass_instances; [|now apply bpow_mag_le].
  apply generic_format_bpow. unfold FLX_exp. lia. }
replace (mag radix2 x - 26)%Z with (- (25) + (mag radix2 x - 1))%Z by ring. rewrite bpow_plus.
replace (/ 2 ^ 25) with (bpow radix2 (- (25))) by (unfold bpow; simpl; lra).
apply Rmult_le_compat_l; [apply bpow_ge_0|exact B].
Qed.
Lemma head_rest x : float x -> float (x - cut_to_head x).
Proof.
intros D. destruct (Req_dec x 0) as [->|N]; [now rewrite head_0, Rminus_0_r|].
assert (M : multiple (mag radix2 x - 1 + 1 - precision) x).
{ apply multiple_of_digits; [reflexivity|exact D|]. right. now apply bpow_mag_le. }
apply digits_of_multiple with (mag radix2 x - 1 + 1 - precision)%Z; [reflexivity| |].
- apply multiple_minus; [exact M|]. apply multiple_round; auto with typeclass_instances.
- rewrite Rabs_minus_sym. pose proof (error_lt_ulp radix2 (FLX_exp 26) Ztrunc x N) as L.
  apply Rlt_le_trans with (1 := L). rewrite ulp_neq_0 by exact N. unfold cexp, FLX_exp. apply bpow_le.
  unfold precision. lia.
Qed.
End Nearest.
