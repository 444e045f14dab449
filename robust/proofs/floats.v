(* SPDX-License-Identifier: Apache-2.0 *)
(* A machine on all of binary64, with infinities and NaN: Flocq's numbers and operations, each operation in any rounding
   mode, with operands read as zero and results flushed to zero below the least normal number or not, products
   contracted or not. What it computes where nothing overflows is a run of the model (format.v). *)
From Coq Require Import Reals ZArith Lra Lia Bool.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model constants steps format.
Open Scope R_scope.

Definition float := binary_float 53 1024.
#[local] Existing Instances p53 fexp_valid.
#[local] Instance below_1024 : Prec_lt_emax 53 1024. Proof. reflexivity. Qed.
(* the number that it is; of an infinity and of NaN, 0 *)
Definition value (x : float) : R := B2R x.
Definition finite (x : float) := is_finite x = true.
Definition least := bpow radix2 (-1022).

(* Of a number below n any zero may be read; any zero may come out for an exact result r below n. *)
Definition reads (x x' : float) := x' = x \/ (finite x /\ Rabs (value x) < least /\ exists s, x' = B754_zero s).
Definition yields r (z z' : float) := z' = z \/ (finite z /\ Rabs r < least /\ exists s, z' = B754_zero s).

Definition plain (p : operand float) := match p with Plain x => x | Product _ _ t => t end.
Definition fused (p : operand float) (a b : float) :=
  match p with Plain _ => False | Product a' b' _ => reads a' a /\ reads b' b end.
Definition floats : machine float := {|
  constant r x := finite x /\ value x = r;
  magnitude := Babs;
  opposite := Bopp;
  square_root x z := exists m x', reads x x' /\ yields (sqrt (value x')) (Bsqrt m x') z;
  mul x y z := exists m x' y', reads x x' /\ reads y y' /\ yields (value x' * value y') (Bmult m x' y') z;
  add p q z := exists m,
    (exists x y, reads (plain p) x /\ reads (plain q) y /\ yields (value x + value y) (Bplus m x y) z) \/
    (exists a b y, fused p a b /\ reads (plain q) y /\ yields (value a * value b + value y) (Bfma m a b y) z) \/
    (exists x a b, reads (plain p) x /\ fused q a b /\ yields (value a * value b + value x) (Bfma m a b x) z);
  sub p q z := exists m,
    (exists x y, reads (plain p) x /\ reads (plain q) y /\ yields (value x - value y) (Bminus m x y) z) \/
    (exists a b y, fused p a b /\ reads (plain q) y /\ yields (value a * value b - value y) (Bfma m a b (Bopp y)) z) \/
    (exists x a b, reads (plain p) x /\ fused q a b /\ yields (value x - value a * value b) (Bfma m (Bopp a) b x) z);
  greater x y b := exists x' y', reads x x' /\ reads y y' /\
    b = match Bcompare x' y' with Some Gt => true | _ => false end;
  at_most x y b := exists x' y', reads x x' /\ reads y y' /\
    b = match Bcompare x' y' with Some Lt => true | Some Eq => true | _ => false end;
  choose b x y z := reads (if b then x else y) z;
  signed x b := is_nan x = false -> b = Bsign x |}.

(* What an operation on finite numbers may give for the exact result r. *)
Definition outcome r (z : float) := exists m,
  let c := round radix2 fexp (round_mode m) r in
  (Rabs c < bpow radix2 1024 /\ finite z /\ value z = c) \/
  (bpow radix2 1024 <= Rabs c /\ exists s, (s = true -> r <= 0) /\ (s = false -> 0 <= r) /\
    B2SF z = binary_overflow 53 1024 m s) \/
  (Rabs r < least /\ finite z /\ value z = 0).

Lemma sign_value (x : float) : (Bsign x = true -> value x <= 0) /\ (Bsign x = false -> 0 <= value x).
Proof.
unfold value. destruct x as [s|s| |s m e B]; simpl; try (split; intros; lra).
split; intros E; subst; [apply F2R_le_0|apply F2R_ge_0]; simpl; lia.
Qed.
Lemma outcome_yields r (f z : float) : outcome r f -> yields r f z -> outcome r z.
Proof.
intros [m O] [->|(_ & S & s & ->)]; exists m; [exact O|]. right. right. now repeat split.
Qed.
Ltac outcomes m r correct := exists m; generalize correct; cbv zeta; change (SpecFloat.fexp 53 1024) with fexp;
  change (@B2R 53 1024) with value;
  destruct (Rlt_bool_spec (Rabs (round radix2 fexp (round_mode m) r)) (bpow radix2 1024)) as [L|L].
Lemma outcome_mul m x y : finite x -> finite y -> outcome (value x * value y) (Bmult m x y).
Proof.
intros X Y. outcomes m (value x * value y) (Bmult_correct 53 1024 _ _ m x y).
- intros (E & Z & _). left. unfold finite in *. now rewrite Z, X, Y.
- intros E. right. left. split; [exact L|]. exists (xorb (Bsign x) (Bsign y)).
  destruct (sign_value x), (sign_value y). destruct (Bsign x), (Bsign y); simpl;
  repeat split; try discriminate; try exact E; intros _; nra.
Qed.
Lemma outcome_add m x y : finite x -> finite y -> outcome (value x + value y) (Bplus m x y).
Proof.
intros X Y. outcomes m (value x + value y) (Bplus_correct 53 1024 _ _ m x y X Y).
- intros (E & Z & _). left. auto.
- intros [E S]. right. left. split; [exact L|]. exists (Bsign x). destruct (sign_value x), (sign_value y).
  rewrite <- S in *. destruct (Bsign x); repeat split; try discriminate; try exact E; intros _; intuition lra.
Qed.
Lemma outcome_sub m x y : finite x -> finite y -> outcome (value x - value y) (Bminus m x y).
Proof.
intros X Y. outcomes m (value x - value y) (Bminus_correct 53 1024 _ _ m x y X Y).
- intros (E & Z & _). left. auto.
- intros [E S]. right. left. split; [exact L|]. exists (Bsign x). destruct (sign_value x), (sign_value y).
  rewrite S in *. destruct (Bsign y); repeat split; try discriminate; try exact E; simpl in *; intros _;
  intuition lra.
Qed.
Lemma outcome_fma m a b y : finite a -> finite b -> finite y -> outcome (value a * value b + value y) (Bfma m a b y).
Proof.
intros A B Y. outcomes m (value a * value b + value y) (Bfma_correct 53 1024 _ _ m a b y A B Y).
- intros (E & Z & _). left. auto.
- intros E. right. left. split; [exact L|]. exists (Rlt_bool (value a * value b + value y) 0).
  destruct (Rlt_bool_spec (value a * value b + value y) 0); repeat split; try discriminate; try exact E; intros _; lra.
Qed.

Lemma overflowed m s (z : float) : B2SF z = binary_overflow 53 1024 m s -> finite z ->
  bpow radix2 1023 < Rabs (value z) /\ overflow_to_inf m s = false.
Proof.
unfold binary_overflow, finite, value. destruct (overflow_to_inf m s); intros E Z.
- destruct z; discriminate.
- split; [|reflexivity]. rewrite <- SF2R_B2SF, E. unfold SF2R. rewrite <- F2R_Zabs, abs_cond_Zopp.
  change (1024 - 53)%Z with 971%Z. change (bpow radix2 1023) with (bpow radix2 (52 + 971)). rewrite bpow_plus.
  unfold F2R. apply Rmult_lt_compat_r; [apply bpow_gt_0|]. change (bpow radix2 52) with (IZR (2 ^ 52)).
  apply IZR_lt. reflexivity.
Qed.

Lemma round_to_zero r : Rabs (round radix2 fexp Ztrunc r) <= Rabs r.
Proof.
destruct (Rle_or_lt 0 r) as [P|P].
- destruct (round_ZR_pt radix2 fexp r) as [A _]. destruct (A P) as (_ & B & _).
  assert (0 <= round radix2 fexp Ztrunc r) by (rewrite <- (round_0 radix2 fexp Ztrunc); apply round_le; auto with
    typeclass_instances). rewrite !Rabs_right; lra.
- destruct (round_ZR_pt radix2 fexp r) as [_ A]. destruct (A (Rlt_le _ _ P)) as (_ & B & _).
  assert (round radix2 fexp Ztrunc r <= 0) by (rewrite <- (round_0 radix2 fexp Ztrunc); apply round_le; auto with
    typeclass_instances; lra). rewrite (Rabs_left1 r), Rabs_left1; lra.
Qed.
(* an overflow that does not give an infinity rounds towards zero *)
Lemma not_past m s r : overflow_to_inf m s = false -> (s = true -> r <= 0) -> (s = false -> 0 <= r) ->
  Rabs (round radix2 fexp (round_mode m) r) <= Rabs r.
Proof.
intros I S1 S2. apply Rle_trans with (2 := round_to_zero r). right.
destruct m, s; try discriminate I; try reflexivity; unfold round_mode;
  first [now rewrite round_ZR_DN by auto | now rewrite round_ZR_UP by auto].
Qed.

(* without overflow it is an operation of the model *)
Lemma outcome_rounded r z : outcome r z -> finite z ->
  Rabs (value z) <= bpow radix2 1023 \/ Rabs r < bpow radix2 1024 -> rounded binary64 r (value z).
Proof.
intros (m & [(L & _ & ->)|[(L & s & S1 & S2 & E)|(L & _ & ->)]]) Z K.
- apply (result_rounded (round_mode m)). now left.
- exfalso. destruct (overflowed _ _ _ E Z) as [O I]. pose proof (not_past m s r I S1 S2). lra.
- apply (result_rounded (round_mode m)). right. auto.
Qed.

(* not negative, or NaN *)
Definition up (x : float) := match x with B754_infinity s | B754_finite s _ _ _ => s = false | _ => True end.
Lemma up_value x : up x -> 0 <= value x.
Proof. destruct x; simpl; intros U; try apply Rle_refl. subst. apply F2R_ge_0. simpl. lia. Qed.
Lemma up_finite x : finite x -> 0 <= value x -> up x.
Proof.
destruct x as [s|s| |s m e B]; simpl; try easy. intros _ P. destruct s; [|reflexivity]. exfalso.
apply Rle_not_lt in P. apply P. apply F2R_lt_0. simpl. lia.
Qed.
Definition mag (z : float) k := finite z /\ Rabs (value z) <= bpow radix2 k.
Definition fair k := ((-1022 <=? k) && (k <=? 1023))%Z = true.
Lemma fair_k k : fair k -> (-1022 <= k <= 1023)%Z.
Proof. intros F%andb_prop. lia. Qed.

Lemma outcome_up r z : outcome r z -> 0 <= r -> up z.
Proof.
intros (m & [(L & Z & E)|[(L & s & S1 & S2 & E)|(L & Z & E)]]) P.
- apply up_finite; [exact Z|]. rewrite E, <- (round_0 radix2 fexp (round_mode m)).
  apply round_le; auto with typeclass_instances.
- destruct s.
  + assert (r = 0) as -> by (specialize (S1 eq_refl); lra). exfalso.
    rewrite round_0, Rabs_R0 in L by auto with typeclass_instances. pose proof (bpow_gt_0 radix2 1024). lra.
  + unfold binary_overflow in E. destruct (overflow_to_inf m false), z; try discriminate; simpl in E |- *; congruence.
- apply up_finite; [exact Z|]. rewrite E. apply Rle_refl.
Qed.
Lemma outcome_mag r z k : outcome r z -> Rabs r <= bpow radix2 k -> fair k -> mag z k.
Proof.
intros (m & O) L K%fair_k. assert (N : Rabs (round radix2 fexp (round_mode m) r) <= bpow radix2 k).
{ apply abs_round_le_generic; auto with typeclass_instances. apply generic_format_bpow. unfold fexp, FLT_exp. lia. }
assert (bpow radix2 k < bpow radix2 1024) by (apply bpow_lt; lia). pose proof (bpow_gt_0 radix2 k).
destruct O as [(_ & Z & E)|[(O & _)|(_ & Z & E)]]; [|lra|]; (split; [exact Z|]); rewrite E; [exact N|].
rewrite Rabs_R0. lra.
Qed.
