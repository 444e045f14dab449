(* SPDX-License-Identifier: Apache-2.0 *)
(* binary64 satisfies the model: every rounding mode, gradual underflow or flush to zero, numbers below the least normal
   one read as zero or not, products contracted or not, each operation on its own; where nothing overflows. *)
From Coq Require Import Reals Lra ZArith Lia Psatz.
From Flocq Require Import Core Relative.
From Filters Require Import model constants steps.
Open Scope R_scope.

Definition binary64 := {| u := bpow radix2 (-52); n := bpow radix2 (-1022); third := bpow radix2 341;
  quarter := bpow radix2 255; sixth := bpow radix2 170 |}.
Definition fexp := FLT_exp (-1074) 53.
#[local] Instance p53 : Prec_gt_0 53. Proof. reflexivity. Qed.
#[local] Instance fexp_valid : Valid_exp fexp. Proof. apply FLT_exp_valid. reflexivity. Qed.

Section Machine.
Variable rnd : R -> Z.
Context {V : Valid_rnd rnd}.

(* what may come out for the exact result r: r rounded, or zero for a result below n *)
Definition result r z := z = round radix2 fexp rnd r \/ (z = 0 /\ Rabs r < n binary64).

Theorem result_rounded r z : result r z -> rounded binary64 r z.
Proof.
unfold rounded. cbn [u n binary64]. intros [->|[-> Hr]].
- split; [|split].
  + destruct (Rle_or_lt (bpow radix2 (-1022)) (Rabs r)) as [L|L].
    * destruct (relative_error_FLT_ex radix2 (-1074) 53 eq_refl rnd r L) as (e & He & E).
      exists e, 0. rewrite Rabs_R0. split; [exact (Rlt_le _ _ He)|]. split; [apply bpow_ge_0|]. unfold fexp.
      rewrite E. ring.
    * exists 0, (round radix2 fexp rnd r - r). rewrite Rabs_R0. split; [apply bpow_ge_0|]. split; [|ring].
      apply Rle_trans with (ulp radix2 fexp r); [apply error_le_ulp; auto with typeclass_instances|].
      unfold fexp. rewrite (ulp_FLT_small radix2 (-1074) 53); [apply bpow_le; lia|].
      apply Rlt_le_trans with (1 := L). apply bpow_le. lia.
  + intros P. rewrite <- (round_0 radix2 fexp rnd). apply round_le; auto with typeclass_instances.
  + intros P. rewrite <- (round_0 radix2 fexp rnd). apply round_le; auto with typeclass_instances.
- split; [|split; intros; lra].
  exists 0, (- r). rewrite Rabs_R0, Rabs_Ropp. split; [apply bpow_ge_0|]. split; [exact (Rlt_le _ _ Hr)|ring].
Qed.

(* one instruction each; of a sum of two products, a fused operation leaves one unrounded *)
Definition read64 := read binary64.
Definition exact_product (p : operand R) z :=
  match p with Plain _ => False | Product a b _ => exists a' b', read64 a a' /\ read64 b b' /\ z = a' * b' end.
Definition rounded_operand (p : operand R) z := match p with Plain x => read64 x z | Product _ _ t => read64 t z end.
Definition operands p q x y := (rounded_operand p x /\ rounded_operand q y) \/ (exact_product p x /\ rounded_operand q
  y) \/
  (rounded_operand p x /\ exact_product q y).
Definition machine64 : machine R := {|
  constant r x := x = r;
  magnitude := Rabs;
  opposite := Ropp;
  square_root x z := exists x', read64 x x' /\ result (sqrt x') z;
  mul x y z := exists x' y', read64 x x' /\ read64 y y' /\ result (x' * y') z;
  add p q z := exists x y, operands p q x y /\ result (x + y) z;
  sub p q z := exists x y, operands p q x y /\ result (x - y) z;
  greater x y b := exists x' y', read64 x x' /\ read64 y y' /\ (b = true <-> x' > y');
  at_most x y b := exists x' y', read64 x x' /\ read64 y y' /\ (b = true <-> x' <= y');
  choose b x y z := read64 (if b then x else y) z;
  signed x b := (x < 0 -> b = true) /\ (0 < x -> b = false) |}.

Lemma operands_model p q x y : operands p q x y -> uses binary64 p x /\ uses binary64 q y.
Proof. destruct p, q; unfold operands, rounded_operand, exact_product, uses, read64; intuition. Qed.

Theorem in_binary64 : fits binary64 (third binary64) 1 1 /\ fits binary64 (quarter binary64) 1 1 /\
  fits binary64 (sixth binary64) 1 1 /\ fits binary64 (two_to 500) 1 1 /\ n binary64 <= two_to (-1022) /\
  two_to (-52) <= u binary64 /\
  (forall x y z, mul machine64 x y z -> mul (reals binary64) x y z) /\
  (forall x z, square_root machine64 x z -> square_root (reals binary64) x z) /\
  (forall p q z, add machine64 p q z -> add (reals binary64) p q z) /\
  (forall p q z, sub machine64 p q z -> sub (reals binary64) p q z).
Proof.
assert (A : forall k, (1 <= k)%Z -> fits binary64 (bpow radix2 k) 1 1).
{ intros k K. assert (T : 2 <= bpow radix2 k) by (change 2 with (bpow radix2 1); now apply bpow_le).
  assert (U : bpow radix2 (-52) <= / 1024) by (change (/ 1024) with (bpow radix2 (-10)); apply bpow_le; lia).
  assert (N : bpow radix2 (-1022) <= bpow radix2 (-52)) by (apply bpow_le; lia).
  pose proof (bpow_gt_0 radix2 (-52)). pose proof (bpow_gt_0 radix2 (-1022)).
  split; cbn [u n binary64]; try lra; try lia. }
split; [apply A; lia|]. split; [apply A; lia|]. split; [apply A; lia|].
assert (T : forall e, two_to e = bpow radix2 e) by (intros e; symmetry; apply (bpow_powerRZ radix2)).
rewrite !T. split; [apply A; lia|]. split; [apply Rle_refl|]. split; [apply Rle_refl|].
split; [|split; [|split]].
- intros x y z (x' & y' & X & Y & Z). exists x', y'. auto using result_rounded.
- intros x z (x' & X & Z). exists x'. auto using result_rounded.
- intros p q z (x & y & O & Z). apply operands_model in O as [X Y]. exists x, y. auto using result_rounded.
- intros p q z (x & y & O & Z). apply operands_model in O as [X Y]. exists x, y. auto using result_rounded.
Qed.

(* of numbers of the format *)
Theorem growing_in_binary64 x y z : generic_format radix2 fexp x -> generic_format radix2 fexp y ->
  add machine64 (Plain x) (Plain y) z -> add (growing binary64) (Plain x) (Plain y) z.
Proof.
intros X Y (x' & y' & O & Z). assert (R : forall v v', generic_format radix2 fexp v -> read64 v v' ->
  generic_format radix2 fexp v') by (intros v v' W [->|[-> _]]; [exact W|apply generic_format_0]).
assert (XY : generic_format radix2 fexp x' /\ generic_format radix2 fexp y')
  by (destruct O as [[A B]|[[[] _]|[_ []]]]; split; eauto).
destruct XY as [X' Y']. apply operands_model in O as [A B]. exists x', y'.
split; [exact A|]. split; [exact B|]. split; [now apply result_rounded|]. intros Px Py.
destruct Z as [->|[-> L]]; [left|right; split; [easy|apply Rle_lt_trans with (2 := L), Rle_abs]].
split; [rewrite <- (round_generic radix2 fexp rnd x' X') at 1|rewrite <- (round_generic radix2 fexp rnd y' Y') at 1];
  apply round_le; auto with typeclass_instances; lra.
Qed.
End Machine.

(* to nearest with ties to even and away, down, up, to zero *)
Theorem all_modes : Valid_rnd ZnearestE /\ Valid_rnd ZnearestA /\ Valid_rnd Zfloor /\ Valid_rnd Zceil /\ Valid_rnd
  Ztrunc.
Proof.
repeat split; auto with typeclass_instances;
  try apply valid_rnd_N; try apply valid_rnd_DN; try apply valid_rnd_UP; try apply valid_rnd_ZR.
Qed.
