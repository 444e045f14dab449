(* SPDX-License-Identifier: Apache-2.0 *)
(* Greatest numbers, and sums that infinities and NaN never leave, where some may be among them. *)
From Coq Require Import Reals ZArith Lra Lia Bool.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model constants steps format floats float_steps float_guards float_run.
Open Scope R_scope.
#[local] Existing Instances p53 fexp_valid below_1024.

Lemma number_abs x : finite x -> is_nan (Babs x) = false.
Proof. now destruct x. Qed.
Lemma number_reads x x' : reads x x' -> is_nan x = false -> is_nan x' = false.
Proof. now intros [->|(_ & _ & s & ->)]. Qed.
Lemma sum_number x y z : add floats (Plain x) (Plain y) z -> is_nan x = false -> is_nan y = false -> up x -> up y ->
  is_nan z = false.
Proof.
intros (m & [(x' & y' & X & Y & Z)|[(a & b & y' & [] & _)|(x' & a & b & _ & [] & _)]]) NX NY UX UY.
assert (N : is_nan (Bplus m x' y') = false).
{ apply (number_reads _ _ X) in NX. apply (number_reads _ _ Y) in NY. apply (reads_up _ _ X) in UX.
  apply (reads_up _ _ Y) in UY. clear X Y Z. destruct (finite_or x') as [A|A]; [destruct (finite_or y') as [B|B]|].
  - destruct (outcome_add m x' y' A B) as (m' & [(_ & F & _)|[(_ & s & _ & _ & E)|(_ & F & _)]]);
      try (now destruct (Bplus m x' y')).
    unfold binary_overflow in E. destruct (overflow_to_inf m' s), (Bplus m x' y'); easy.
  - destruct x', y'; simpl in *; subst; easy.
  - destruct x', y'; simpl in *; subst; easy. }
destruct Z as [->|(_ & _ & s & ->)]; [exact N|reflexivity].
Qed.

(* of n . p finite, each factor is finite *)
Lemma product_finites a b t r : used (Product a b t) r -> mul floats a b t -> finite a /\ finite b.
Proof.
intros [(x & X & F & _)|(c & d & [C D] & A & B & _)] S; [|eauto using reads_finite].
pose proof (reads_finite _ _ X F) as T. destruct (mul_used _ _ _ S (or_introl T)) as (c & d & C & D & A & B & _).
eauto using reads_finite.
Qed.
Lemma terms_finite a b c d e f s t v s1 t1 : mul floats a b s -> mul floats c d t ->
  add floats (Product a b s) (Product c d t) v -> mul floats e f t1 -> add floats (Plain v) (Product e f t1) s1 ->
  finite s1 -> finite a /\ finite c /\ finite e.
Proof.
intros S T A S' B F. destruct (add_used _ _ _ B (or_introl F)) as (x & y & X & Y & _).
assert (V : finite v) by (destruct X as [(x' & X & G & _)|(k & l & [] & _)]; eauto using reads_finite).
destruct (add_used _ _ _ A (or_introl V)) as (k & l & K & L & _).
repeat split; [apply (product_finites _ _ _ _ K S)|apply (product_finites _ _ _ _ L T)|].
apply (product_finites _ _ _ _ Y S').
Qed.

(* the greater of two is not large: nor is either *)
Lemma greater_mag x y b z k : greater floats x y b -> choose floats b x y z -> mag z k -> (0 <= k)%Z -> up x -> up y ->
  is_nan x = false -> mag x k /\ mag y k.
Proof.
intros (x' & y' & X & Y & E) C [Z L] K UX UY NX.
assert (T : least <= bpow radix2 k) by (apply bpow_le; lia).
assert (B : forall v w, reads v w -> finite v -> Rabs (value w) <= bpow radix2 k -> mag v k)
  by (intros v w V F W; exact (reads_back v w k V F W K)).
pose proof (reads_up _ _ X UX) as UX'. pose proof (reads_up _ _ Y UY) as UY'.
pose proof (number_reads _ _ X NX) as NX'.
pose proof (up_value _ UX') as PX. pose proof (up_value _ UY') as PY.
destruct b.
- pose proof (B _ _ C (reads_finite _ _ C Z) L) as MX. split; [exact MX|].
  pose proof (finite_reads _ _ X (proj1 MX)) as FX. destruct (reads_mag _ _ _ X MX) as [_ LX].
  destruct (finite_or y') as [FY|FY].
  + apply (B _ _ Y (reads_finite _ _ Y FY)). rewrite (compared _ _ _ FX FY eq_refl) in E.
    destruct (Rcompare_spec (value x') (value y')); try discriminate. rewrite Rabs_right in * by lra. lra.
  + exfalso. destruct y' as [|s| |]; simpl in *; try easy; try subst s; destruct x'; easy.
- pose proof (B _ _ C (reads_finite _ _ C Z) L) as MY. split; [|exact MY].
  pose proof (finite_reads _ _ Y (proj1 MY)) as FY. destruct (reads_mag _ _ _ Y MY) as [_ LY].
  destruct (finite_or x') as [FX|FX].
  + apply (B _ _ X (reads_finite _ _ X FX)). rewrite (compared _ _ _ FX FY eq_refl) in E.
    destruct (Rcompare_spec (value x') (value y')); try discriminate; rewrite Rabs_right in * by lra; lra.
  + exfalso. destruct x' as [|s| |]; simpl in *; try easy; try subst s; destruct y'; easy.
Qed.

(* s - s is no number where s is none *)
Lemma difference_finite s d c : sub floats (Plain s) (Plain s) d -> at_most floats d c true -> finite s.
Proof.
intros (m & [(x & y & X & Y & Z)|[(a & b & y' & [] & _)|(x' & a & b & _ & [] & _)]]) (d' & c' & D & _ & E).
destruct (finite_or s) as [F|F]; [exact F|]. exfalso.
assert (x = s /\ y = s) as [-> ->]
  by (destruct X as [->|[X _]], Y as [->|[Y _]]; try (now destruct s); now split).
assert (N : Bminus m s s = B754_nan) by (destruct s as [|[]| |]; easy).
rewrite N in Z. destruct Z as [->|[Z _]]; [|discriminate Z]. destruct D as [->|[D _]]; easy.
Qed.
