(* SPDX-License-Identifier: Apache-2.0 *)
(* What a guard says of numbers that may be infinite or NaN: a comparison with NaN is false, a sum of numbers that are
   not negative is at least each of them; and tactics that take a run on floats to one on real numbers. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model constants steps tactics format floats float_steps.
Open Scope R_scope.
#[local] Existing Instances p53 fexp_valid below_1024.

Lemma up_abs x : up (Babs x).
Proof. now destruct x. Qed.
Lemma reads_up x x' : reads x x' -> up x -> up x'.
Proof. now intros [->|(_ & _ & s & ->)]. Qed.
Lemma yields_up r f z : yields r f z -> up f -> up z.
Proof. now intros [->|(_ & _ & s & ->)]. Qed.
Definition infinite (x : float) := match x with B754_nan | B754_infinity _ => True | _ => False end.
Lemma finite_or x : finite x \/ infinite x.
Proof. destruct x; simpl; auto; left; reflexivity. Qed.

Lemma plus_up m x y : up x -> up y -> up (Bplus m x y).
Proof.
intros X Y. destruct (finite_or x) as [A|A]; [destruct (finite_or y) as [B|B]|].
- apply (outcome_up _ _ (outcome_add m x y A B)). apply up_value in X, Y. lra.
- destruct x, y; simpl in *; subst; easy.
- destruct x, y; simpl in *; subst; easy.
Qed.
(* a square root *)
Lemma outcome_root m x : finite x -> up x -> outcome (sqrt (value x)) (Bsqrt m x).
Proof.
intros X U. destruct (Bsqrt_correct 53 1024 _ _ m x) as (E & Z & _). exists m. left.
change (SpecFloat.fexp 53 1024) with fexp in E. change (@B2R 53 1024) with value in E. rewrite <- E.
split; [apply abs_B2R_lt_emax|]. split; [|reflexivity]. unfold finite. rewrite Z.
destruct x as [s|s| |s e k B]; simpl in U; try easy. now rewrite U.
Qed.
Lemma root_used x z : square_root floats x z -> finite x -> up x ->
  exists x', reads x x' /\ outcome (sqrt (value x')) z.
Proof.
intros (m & x' & X & Z) F U. exists x'. split; [exact X|].
apply outcome_yields with (2 := Z). apply outcome_root; eauto using finite_reads, reads_up.
Qed.
Lemma root_up x z : square_root floats x z -> up x -> up z.
Proof.
intros (m & x' & X & Z) U. apply (yields_up _ _ _ Z). apply (reads_up _ _ X) in U. destruct (finite_or x') as [F|F].
- exact (outcome_up _ _ (outcome_root m x' F U) (sqrt_pos _)).
- destruct x'; simpl in *; subst; easy.
Qed.
Lemma root_real x z k : square_root floats x z -> mag z k -> fair k -> finite x -> up x ->
  square_root M (value x) (value z).
Proof.
intros S Z K F U. destruct (root_used x z S F U) as (x' & X & O). exists (value x').
split; [now apply reads_read|]. now apply mag_rounded with k.
Qed.
Lemma root_mag x z k j : square_root floats x z -> mag x k -> up x -> (k <= 2 * j)%Z -> fair j -> mag z j.
Proof.
intros S X U J K. destruct (root_used x z S (proj1 X) U) as (x' & X' & O).
apply (outcome_mag _ _ _ O); [|exact K]. rewrite Rabs_right by apply Rle_ge, sqrt_pos.
apply (reads_mag _ _ _ X') in X as [_ L]. rewrite <- (sqrt_square (bpow radix2 j)) by apply bpow_ge_0.
apply sqrt_le_1_alt. rewrite <- bpow_plus. apply Rle_trans with (1 := Rle_abs _), Rle_trans with (1 := L).
apply bpow_le. lia.
Qed.

(* the factors of a product that is not negative: twice the same number, each time read as it is or as zero, or two
   numbers that are not negative *)
Definition factors a b := (exists x, reads x a /\ reads x b) \/ (up a /\ up b).
Lemma factors_nonneg a b : factors a b -> 0 <= value a * value b.
Proof.
intros [(x & A & B)|[A%up_value B%up_value]]; [|now apply Rmult_le_pos].
destruct A as [->|(_ & _ & s & ->)], B as [->|(_ & _ & t & ->)]; rewrite ?value_zero; nra.
Qed.
Lemma factors_sign a b : factors a b -> finite a /\ finite b \/ a = b \/ (up a /\ up b).
Proof.
intros [(x & A & B)|U]; auto. destruct A as [->|(F & _ & s & ->)]; [destruct B as [->|(E & _ & t & ->)]; auto|].
- left. now split.
- left. split; [reflexivity|]. now apply finite_reads with x.
Qed.
Lemma mult_up m a b : factors a b -> up (Bmult m a b).
Proof.
intros D. destruct (finite_or a) as [A|A]; [destruct (finite_or b) as [B|B]|].
- exact (outcome_up _ _ (outcome_mul m a b A B) (factors_nonneg _ _ D)).
- destruct (factors_sign _ _ D) as [[_ E]|[->|[U V]]]; [now destruct b| now destruct b|].
  destruct a, b; simpl in *; subst; easy.
- destruct (factors_sign _ _ D) as [[E _]|[->|[U V]]]; [now destruct a| |].
  + destruct b; simpl in *; try easy. apply xorb_nilpotent.
  + destruct a, b; simpl in *; subst; easy.
Qed.
Lemma fma_up m a b y : factors a b -> up y -> up (Bfma m a b y).
Proof.
intros D Y. destruct (finite_or a) as [A|A]; [destruct (finite_or b) as [B|B]; [destruct (finite_or y) as [C|C]|]|].
- apply (outcome_up _ _ (outcome_fma m a b y A B C)). apply up_value in Y. apply factors_nonneg in D. lra.
- destruct a, b, y; simpl in *; subst; easy.
- destruct (factors_sign _ _ D) as [[_ E]|[->|[U V]]]; [now destruct b| now destruct b|].
  destruct a, b, y; simpl in *; subst; easy.
- destruct (factors_sign _ _ D) as [[E _]|[->|[U V]]]; [now destruct a| |].
  + destruct b, y; simpl in *; rewrite ?xorb_nilpotent; subst; easy.
  + destruct a, b, y; simpl in *; subst; easy.
Qed.

(* an operand that is not negative: such a number, or the product of such factors *)
Definition rises (p : operand float) :=
  match p with Plain x => up x | Product a b t => (a = b \/ (up a /\ up b)) /\ mul floats a b t end.
Lemma rises_factors p a b : rises p -> fused p a b -> factors a b.
Proof.
destruct p as [|c d t]; [easy|]. intros [[->|[C D]] _] [A B]; [left; eauto|right; eauto using reads_up].
Qed.
Lemma rises_up p : rises p -> up (plain p).
Proof.
destruct p as [x|a b t]; [easy|]. intros [D (m & x & y & X & Y & Z)]. apply (yields_up _ _ _ Z), mult_up.
destruct D as [->|[A B]]; [left; eauto|right; eauto using reads_up].
Qed.
Lemma add_up p q z : add floats p q z -> rises p -> rises q -> up z.
Proof.
intros (m & [(x & y & X & Y & Z)|[(a & b & y & P & Y & Z)|(x & a & b & X & P & Z)]]) A B; apply (yields_up _ _ _ Z).
- apply plus_up; eauto using rises_up, reads_up.
- apply fma_up; eauto using rises_up, reads_up, rises_factors.
- apply fma_up; eauto using rises_up, reads_up, rises_factors.
Qed.
Lemma greater_up x c : greater floats x c true -> finite c -> value c = 0 -> up x.
Proof.
intros (x' & c' & X & C & E) F V. assert (V' : value c' = 0) by (destruct C as [->|(_ & _ & s & ->)]; easy).
pose proof (finite_reads _ _ C F) as F'. destruct (finite_or x) as [A|A].
- apply up_finite; [exact A|]. rewrite (compared x' c' _ (finite_reads _ _ X A) F' eq_refl) in E.
  destruct (Rcompare_spec (value x') (value c')); try discriminate.
  destruct X as [->|(_ & _ & s & ->)]; [lra|]. rewrite value_zero in *. lra.
- destruct X as [->|(B & _)]; [|now destruct x]. destruct x as [|s| |]; simpl in *; try easy.
  destruct s; [|reflexivity]. destruct c'; discriminate.
Qed.

(* the guard, and back to what is in the sum *)
Lemma guard_mag z h k : at_most floats z h true -> finite h -> value h = bpow radix2 k -> (-1022 <=? k)%Z = true ->
  up z -> mag z k.
Proof.
intros (z' & h' & Z & H & E) F V K%Z.leb_le U. assert (h' = h) as ->.
{ destruct H as [->|(_ & L & _)]; [reflexivity|]. exfalso. rewrite V, Rabs_right in L by (apply Rle_ge, bpow_ge_0).
  assert (k < -1022)%Z by (apply (lt_bpow radix2); exact L). lia. }
destruct Z as [->|(A & L & _)].
- destruct (finite_or z) as [A|A].
  + split; [exact A|]. rewrite (compared z h _ A F eq_refl) in E. rewrite V in E. apply up_value in U.
    rewrite Rabs_right by lra. destruct (Rcompare_spec (value z) (bpow radix2 k)); try discriminate; lra.
  + exfalso. destruct z as [|s| |]; simpl in A, U; try easy; try subst s; destruct h; discriminate.
- split; [exact A|]. apply Rle_trans with (1 := Rlt_le _ _ L). now apply bpow_le.
Qed.
Lemma bound_finite x y : greater floats x y true -> up y -> finite y.
Proof.
intros (x' & y' & X & [->|(Y & _)] & E) U; [|exact Y]. destruct (finite_or y) as [A|A]; [exact A|]. exfalso.
destruct y as [|s| |]; simpl in A, U; try easy; try subst s; destruct x' as [|[]| |[]]; discriminate.
Qed.
Lemma used_up p r : used p r -> rises p -> 0 <= r.
Proof.
intros [(x & X & _ & ->)|(a & b & P & _ & _ & ->)] U.
- apply up_value. eauto using reads_up, rises_up.
- apply factors_nonneg. eauto using rises_factors.
Qed.
Definition part k (p : operand float) :=
  match p with Plain x => mag x (k + 1) | Product a b _ => a = b -> forall j, (k + 2 <= 2 * j)%Z -> mag a j end.
Lemma outcome_back r z k : outcome r z -> mag z k -> fair k -> Rabs r <= bpow radix2 (k + 1).
Proof.
intros (m & O) [Z L] K%fair_k. apply Rnot_lt_le. intros N. pose proof (bpow_gt_0 radix2 k).
assert (B : bpow radix2 k < bpow radix2 (k + 1)) by (apply bpow_lt; lia).
destruct O as [(_ & _ & E)|[(_ & s & _ & _ & E)|(S & _ & E)]].
- assert (T : bpow radix2 (k + 1) <= Rabs (round radix2 fexp (round_mode m) r)); [|rewrite <- E in T; lra].
  apply abs_round_ge_generic; auto with typeclass_instances; [|lra].
  apply generic_format_bpow. unfold fexp, FLT_exp. lia.
- destruct (overflowed _ _ _ E Z) as [T _]. assert (bpow radix2 k <= bpow radix2 1023) by (apply bpow_le; lia). lra.
- assert (least <= bpow radix2 (k + 1)) by (apply bpow_le; lia). lra.
Qed.
Lemma reads_back x x' k : reads x x' -> finite x -> Rabs (value x') <= bpow radix2 k -> (0 <= k)%Z -> mag x k.
Proof.
intros [->|(_ & L & _)] F B K; (split; [exact F|]); [exact B|]. apply Rle_trans with (1 := Rlt_le _ _ L).
apply bpow_le. lia.
Qed.
Lemma square_back x a b k j : reads x a -> reads x b -> finite x -> Rabs (value a * value b) <= bpow radix2 k ->
  (k <= 2 * j)%Z -> (0 <= j)%Z -> mag x j.
Proof.
assert (T : (0 <= j)%Z -> least <= bpow radix2 j) by (intros; apply bpow_le; lia).
intros [->|(_ & L & _)] B F P K J; specialize (T J); [|split; [exact F|lra]].
destruct B as [->|(_ & L & _)]; [|split; [exact F|lra]]. split; [exact F|]. rewrite Rabs_mult in P.
assert (E : bpow radix2 k <= bpow radix2 j * bpow radix2 j) by (rewrite <- bpow_plus; apply bpow_le; lia).
pose proof (bpow_gt_0 radix2 j). apply Rnot_lt_le. intros N. nra.
Qed.
Lemma used_part p r k : used p r -> rises p -> r <= bpow radix2 (k + 1) -> fair (k + 1) -> (0 <= k)%Z -> part k p.
Proof.
intros D U L K K0. pose proof (used_up _ _ D U).
assert (B : Rabs r <= bpow radix2 (k + 1)) by (rewrite Rabs_right; lra).
destruct D as [(x & X & F & ->)|(a & b & P & A & _ & ->)].
- pose proof (reads_back _ _ _ X (reads_finite _ _ X F) B ltac:(lia)) as Y. destruct p as [y|c d t]; [exact Y|].
  intros -> j J. destruct U as [_ S]. cbn in Y.
  destruct (mul_used _ _ _ S (or_introl (proj1 Y))) as (a & b & A & C & FA & _ & O).
  pose proof (outcome_back _ _ _ O Y K). apply (square_back _ _ _ (k + 1 + 1) j A C); auto; try lia.
  eauto using reads_finite.
- destruct p as [y|c d t]; [easy|]. intros -> j J. destruct P as [X Y].
  apply (square_back _ _ _ (k + 1) j X Y); auto; try lia. eauto using reads_finite.
Qed.
Lemma add_parts p q z k : add floats p q z -> mag z k -> rises p -> rises q -> fair (k + 1) -> (0 <=? k)%Z = true ->
  part k p /\ part k q.
Proof.
intros S Z P Q K1 K%Z.leb_le. destruct (add_used _ _ _ S (or_introl (proj1 Z))) as (x & y & X & Y & O).
assert (K' : fair k) by (apply fair_k in K1; apply andb_true_intro; split; apply Z.leb_le; lia).
pose proof (outcome_back _ _ _ O Z K') as B. pose proof (used_up _ _ X P). pose proof (used_up _ _ Y Q).
rewrite Rabs_right in B by lra. split; [apply used_part with x|apply used_part with y]; auto; lra || lia.
Qed.
