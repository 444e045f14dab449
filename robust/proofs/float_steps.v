(* SPDX-License-Identifier: Apache-2.0 *)
(* Where a guard holds, nothing that it bounds has overflowed: each operation of a run on floats is then one of a run on
   real numbers. Magnitudes are bounded by powers of two: from the guard back to the parts of its sum, and from these on
   to everything that is computed of them. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model constants steps format floats.
Open Scope R_scope.
#[local] Existing Instances p53 fexp_valid below_1024.

Notation M := (reals binary64).
Definition real (p : operand float) : operand R :=
  match p with Plain x => Plain (value x) | Product a b t => Product (value a) (value b) (value t) end.

Lemma value_zero s : value (B754_zero s : float) = 0. Proof. reflexivity. Qed.
Lemma reads_finite x x' : reads x x' -> finite x' -> finite x.
Proof. intros [->|[X _]]; auto. Qed.
Lemma finite_reads x x' : reads x x' -> finite x -> finite x'.
Proof. intros [->|[_ (_ & s & ->)]] X; [exact X|reflexivity]. Qed.
Lemma reads_read x x' : reads x x' -> read binary64 (value x) (value x').
Proof. intros [->|(_ & L & s & ->)]; [now left|right; now split]. Qed.
Lemma yields_finite r f z : yields r f z -> finite z -> finite f.
Proof. intros [->|[X _]]; auto. Qed.
Lemma reads_mag x x' k : reads x x' -> mag x k -> mag x' k.
Proof.
intros [->|(_ & _ & s & ->)] X; [exact X|]. split; [reflexivity|]. rewrite value_zero, Rabs_R0. apply bpow_ge_0.
Qed.

(* what an operand stands for, where all is finite: itself, or the exact product *)
Definition used (p : operand float) r := (exists x, reads (plain p) x /\ finite x /\ r = value x) \/
  (exists a b, fused p a b /\ finite a /\ finite b /\ r = value a * value b).
Definition whole (p : operand float) :=
  finite (plain p) /\ match p with Plain _ => True | Product a b _ => finite a /\ finite b end.
Lemma used_uses p r : used p r -> uses binary64 (real p) r.
Proof.
intros [(x & X & _ & ->)|(a & b & P & _ & _ & ->)]; destruct p as [y|c d t]; cbn in *; try tauto.
- now apply reads_read.
- left. now apply reads_read.
- right. exists (value a), (value b). destruct P. auto using reads_read.
Qed.
Lemma whole_fused p a b : whole p -> fused p a b -> finite a /\ finite b.
Proof. destruct p as [y|c d t]; [easy|]. intros [_ [C D]] [A B]. eauto using finite_reads. Qed.

Lemma plus_finite m x y : finite (Bplus m x y) -> finite x /\ finite y.
Proof. unfold finite. destruct x as [|s| |], y as [|t| |]; simpl; auto; try destruct s, t; easy. Qed.
Lemma minus_finite m x y : finite (Bminus m x y) -> finite x /\ finite y.
Proof. unfold finite. destruct x as [|s| |], y as [|t| |]; simpl; auto; try destruct s, t; easy. Qed.
Lemma fma_finite m a b y : finite (Bfma m a b y) -> finite a /\ finite b /\ finite y.
Proof.
unfold finite. destruct a as [s|s| |s], b as [t|t| |t], y as [v|v| |v]; simpl; auto; destruct s; easy ||
  destruct t; easy || destruct v; easy.
Qed.
Lemma mult_finite m x y : finite (Bmult m x y) -> finite x /\ finite y.
Proof. unfold finite. destruct x as [|s| |], y as [|t| |]; simpl; auto; easy. Qed.
Lemma finite_opp x : finite (Bopp x) <-> finite x.
Proof. unfold finite. now rewrite is_finite_Bopp. Qed.
Lemma value_opp x : value (Bopp x) = - value x. Proof. apply B2R_Bopp. Qed.
Lemma value_abs x : value (Babs x) = Rabs (value x). Proof. apply B2R_Babs. Qed.

Lemma mul_used x y z : mul floats x y z -> finite z \/ (finite x /\ finite y) -> exists x' y',
  reads x x' /\ reads y y' /\ finite x' /\ finite y' /\ outcome (value x' * value y') z.
Proof.
intros (m & x' & y' & X & Y & Z) D. exists x', y'. assert (A : finite x' /\ finite y').
{ destruct D as [D|[]]; [|eauto using finite_reads]. now apply (mult_finite m), (yields_finite _ _ _ Z). }
destruct A. eauto 7 using outcome_yields, outcome_mul.
Qed.
Lemma add_used p q z : add floats p q z -> finite z \/ (whole p /\ whole q) ->
  exists x y, used p x /\ used q y /\ outcome (x + y) z.
Proof.
intros (m & [(x & y & X & Y & Z)|[(a & b & y & P & Y & Z)|(x & a & b & X & P & Z)]]) D.
- assert (A : finite x /\ finite y).
  { destruct D as [D|[[A _] [B _]]]; [|eauto using finite_reads]. now apply (plus_finite m), (yields_finite _ _ _ Z). }
  destruct A. exists (value x), (value y). repeat split; [left; eauto|left; eauto|].
  eauto using outcome_yields, outcome_add.
- assert (A : finite a /\ finite b /\ finite y).
  { destruct D as [D|[A [B _]]]; [now apply (fma_finite m), (yields_finite _ _ _ Z)|].
    destruct (whole_fused _ _ _ A P). eauto using finite_reads. }
  destruct A as (A & B & C). exists (value a * value b), (value y). repeat split; [right; eauto 6|left; eauto|].
  eauto using outcome_yields, outcome_fma.
- assert (A : finite a /\ finite b /\ finite x).
  { destruct D as [D|[[B _] A]]; [now apply (fma_finite m), (yields_finite _ _ _ Z)|].
    destruct (whole_fused _ _ _ A P). eauto using finite_reads. }
  destruct A as (A & B & C). exists (value x), (value a * value b). repeat split; [left; eauto|right; eauto 6|].
  rewrite Rplus_comm. eauto using outcome_yields, outcome_fma.
Qed.
Lemma sub_used p q z : sub floats p q z -> finite z \/ (whole p /\ whole q) ->
  exists x y, used p x /\ used q y /\ outcome (x - y) z.
Proof.
intros (m & [(x & y & X & Y & Z)|[(a & b & y & P & Y & Z)|(x & a & b & X & P & Z)]]) D.
- assert (A : finite x /\ finite y).
  { destruct D as [D|[[A _] [B _]]]; [|eauto using finite_reads]. now apply (minus_finite m), (yields_finite _ _ _ Z). }
  destruct A. exists (value x), (value y). repeat split; [left; eauto|left; eauto|].
  eauto using outcome_yields, outcome_sub.
- assert (A : finite a /\ finite b /\ finite y).
  { destruct D as [D|[A [B _]]].
    - rewrite <- (finite_opp y). now apply (fma_finite m), (yields_finite _ _ _ Z).
    - destruct (whole_fused _ _ _ A P). eauto using finite_reads. }
  destruct A as (A & B & C). exists (value a * value b), (value y). repeat split; [right; eauto 6|left; eauto|].
  apply outcome_yields with (2 := Z). unfold Rminus. rewrite <- value_opp. apply outcome_fma; auto.
  now apply finite_opp.
- assert (A : finite a /\ finite b /\ finite x).
  { destruct D as [D|[[B _] A]].
    - rewrite <- (finite_opp a). now apply (fma_finite m), (yields_finite _ _ _ Z).
    - destruct (whole_fused _ _ _ A P). eauto using finite_reads. }
  destruct A as (A & B & C). exists (value x), (value a * value b). repeat split; [left; eauto|right; eauto 6|].
  apply outcome_yields with (2 := Z). replace (value x - value a * value b) with (value (Bopp a) * value b + value x)
    by (rewrite value_opp; ring). apply outcome_fma; auto. now apply finite_opp.
Qed.

(* an operation whose result is not large is one of the model *)
Lemma mag_rounded r z k : outcome r z -> mag z k -> fair k -> rounded binary64 r (value z).
Proof.
intros O [Z L] K%fair_k. apply outcome_rounded; [exact O|exact Z|]. left. apply Rle_trans with (1 := L).
apply bpow_le. lia.
Qed.
Lemma mul_real x y z k : mul floats x y z -> mag z k -> fair k -> mul M (value x) (value y) (value z).
Proof.
intros S Z K. destruct (mul_used x y z S (or_introl (proj1 Z))) as (x' & y' & X & Y & _ & _ & O).
exists (value x'), (value y'). split; [now apply reads_read|]. split; [now apply reads_read|].
now apply mag_rounded with k.
Qed.
Lemma add_real p q z k : add floats p q z -> mag z k -> fair k -> add M (real p) (real q) (value z).
Proof.
intros S Z K. destruct (add_used p q z S (or_introl (proj1 Z))) as (x & y & X & Y & O).
exists x, y. split; [now apply used_uses|]. split; [now apply used_uses|]. now apply mag_rounded with k.
Qed.
Lemma sub_real p q z k : sub floats p q z -> mag z k -> fair k -> sub M (real p) (real q) (value z).
Proof.
intros S Z K. destruct (sub_used p q z S (or_introl (proj1 Z))) as (x & y & X & Y & O).
exists x, y. split; [now apply used_uses|]. split; [now apply used_uses|]. now apply mag_rounded with k.
Qed.
Lemma compared x y c : finite x -> finite y -> Bcompare x y = c -> c = Some (Rcompare (value x) (value y)).
Proof. intros X Y <-. now apply Bcompare_correct. Qed.
Lemma greater_real x y b : greater floats x y b -> finite x -> finite y -> greater M (value x) (value y) b.
Proof.
intros (x' & y' & X & Y & ->) A B. exists (value x'), (value y'). split; [|split]; auto using reads_read.
rewrite (compared x' y' _ (finite_reads _ _ X A) (finite_reads _ _ Y B) eq_refl).
destruct (Rcompare_spec (value x') (value y')); split; try easy; lra.
Qed.
Lemma at_most_real x y b : at_most floats x y b -> finite x -> finite y -> at_most M (value x) (value y) b.
Proof.
intros (x' & y' & X & Y & ->) A B. exists (value x'), (value y'). split; [|split]; auto using reads_read.
rewrite (compared x' y' _ (finite_reads _ _ X A) (finite_reads _ _ Y B) eq_refl).
destruct (Rcompare_spec (value x') (value y')); split; try easy; lra.
Qed.
Lemma choose_real b x y z : choose floats b x y z -> choose M b (value x) (value y) (value z).
Proof. intros S%reads_read. now destruct b. Qed.

(* forward: what is computed of numbers that are not large is none *)
Definition within (p : operand float) k := mag (plain p) k /\
  match p with Plain _ => True | Product a b _ => exists i j, mag a i /\ mag b j /\ (i + j <= k)%Z end.
Lemma mag_up x i k : mag x i -> (i <= k)%Z -> mag x k.
Proof. intros [X L] K. split; [exact X|]. apply Rle_trans with (1 := L). now apply bpow_le. Qed.
Lemma within_product a b t i j l k : mag a i -> mag b j -> mag t l -> Z.max l (i + j) = k -> within (Product a b t) k.
Proof.
intros A B C <-. split; [apply mag_up with (1 := C); lia|]. exists i, j. repeat split; try apply A; try apply B. lia.
Qed.
Lemma within_whole p k : within p k -> whole p.
Proof. destruct p; intros [[A _] B]; split; auto. destruct B as (i & j & [] & [] & _). auto. Qed.
Lemma product_mag x y i j : mag x i -> mag y j -> Rabs (value x * value y) <= bpow radix2 (i + j).
Proof. intros [_ X] [_ Y]. rewrite bpow_plus. now apply mul_le. Qed.
Lemma used_mag p r k : used p r -> within p k -> Rabs r <= bpow radix2 k.
Proof.
intros [(x & X & _ & ->)|(a & b & P & _ & _ & ->)] [W V].
- now apply (reads_mag _ _ _ X).
- destruct p as [y|c d t]; [easy|]. destruct V as (i & j & C & D & L). destruct P as [A B].
  apply Rle_trans with (bpow radix2 (i + j)); [|now apply bpow_le]. apply product_mag; eauto using reads_mag.
Qed.
Lemma mul_mag x y z i j k : mul floats x y z -> mag x i -> mag y j -> (i + j)%Z = k -> fair k -> mag z k.
Proof.
intros S X Y <- K. destruct (mul_used x y z S) as (x' & y' & X' & Y' & _ & _ & O); [right; split; [apply X|apply Y]|].
apply (outcome_mag _ _ _ O); [|exact K]. apply product_mag; eauto using reads_mag.
Qed.
Lemma sum_le x y i j : Rabs x <= bpow radix2 i -> Rabs y <= bpow radix2 j ->
  Rabs (x + y) <= bpow radix2 (Z.max i j + 1).
Proof.
intros X Y. rewrite bpow_plus. simpl (bpow radix2 1). apply Rle_trans with (1 := Rabs_triang _ _).
assert (bpow radix2 i <= bpow radix2 (Z.max i j)) by (apply bpow_le; lia).
assert (bpow radix2 j <= bpow radix2 (Z.max i j)) by (apply bpow_le; lia). lra.
Qed.
Lemma add_mag p q z i j k : add floats p q z -> within p i -> within q j -> (Z.max i j + 1)%Z = k -> fair k -> mag z k.
Proof.
intros S X Y <- K. destruct (add_used p q z S) as (x & y & X' & Y' & O); [right; eauto using within_whole|].
apply (outcome_mag _ _ _ O); [|exact K]. apply sum_le; eauto using used_mag.
Qed.
Lemma sub_mag p q z i j k : sub floats p q z -> within p i -> within q j -> (Z.max i j + 1)%Z = k -> fair k -> mag z k.
Proof.
intros S X Y <- K. destruct (sub_used p q z S) as (x & y & X' & Y' & O); [right; eauto using within_whole|].
apply (outcome_mag _ _ _ O); [|exact K]. unfold Rminus. apply sum_le; [|rewrite Rabs_Ropp]; eauto using used_mag.
Qed.
Lemma choose_mag b x y z i j k : choose floats b x y z -> mag x i -> mag y j -> Z.max i j = k -> mag z k.
Proof.
intros S X Y <-. apply (reads_mag _ _ _ S). destruct b; [apply mag_up with i|apply mag_up with j]; auto; lia.
Qed.
Lemma abs_mag x k : mag x k -> mag (Babs x) k.
Proof. intros [X L]. split; [unfold finite; now rewrite is_finite_Babs|]. now rewrite value_abs, Rabs_Rabsolu. Qed.
Lemma mag_abs x k : mag (Babs x) k -> mag x k.
Proof.
intros [X L]. unfold finite in X. rewrite is_finite_Babs in X. rewrite value_abs, Rabs_Rabsolu in L. now split.
Qed.
Lemma opp_mag x k : mag x k -> mag (Bopp x) k.
Proof. intros [X L]. split; [now apply finite_opp|]. now rewrite value_opp, Rabs_Ropp. Qed.
