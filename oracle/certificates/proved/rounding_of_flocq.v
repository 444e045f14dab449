(* SPDX-License-Identifier: Apache-2.0 *)
(** What the specification calls rounded is what Flocq, the library of floating-point numbers, rounds to: so each real
    number has a rounding, and it is the one of IEEE 754. *)
Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Certificates Require Import numbers formulas_rounding sound_rounding.
Open Scope R_scope.

#[local] Instance p53 : Prec_gt_0 53. Proof. reflexivity. Qed.
Notation exponents := (FLT_exp (-1074) 53).
Definition flocq (x : R) : R := round radix2 exponents ZnearestE x.

Lemma two_bpow : forall e, two e = bpow radix2 e.
Proof. intro e. symmetry. apply (bpow_powerRZ radix2). Qed.
Lemma binary_in_format : forall y, binary 53 y -> generic_format radix2 exponents y.
Proof.
  intros y [m [e [-> h]]]. apply generic_format_FLT. exists (Float radix2 m e); simpl; [| apply h | lia].
  unfold F2R. simpl. change (powerRZ 2 e) with (two e). rewrite two_bpow. reflexivity.
Qed.
Lemma beyond_greatest : forall y, two 1024 <= Rabs y -> 2 * 9007199254740992 * two 970 <= Rabs y.
Proof.
  intros y h. change 1024%Z with (54 + 970)%Z in h. rewrite two_plus, (two_whole 54) in h by lia.
  change (2 ^ 54)%Z with 18014398509481984%Z in h. lra.
Qed.
Lemma greatest_binary : binary 53 (IZR greatest) /\ binary 53 (- IZR greatest).
Proof.
  assert (b : binary 53 (IZR greatest)).
  { rewrite greatest_is. exists 9007199254740991%Z, 971%Z. split; [reflexivity | lia]. }
  split; [auto | apply binary_opp, b].
Qed.

Section of_number.
Variable x : R.
Hypothesis hx : Rabs x < IZR limit.
Let d := flocq x.
Lemma d_nearest : generic_format radix2 exponents d /\
  forall y, generic_format radix2 exponents y -> Rabs (d - x) <= Rabs (y - x).
Proof. apply (round_N_pt radix2 exponents (fun n => negb (Z.even n)) x). Qed.
Lemma d_in_range : Rabs d < two 1024.
Proof.
  destruct (Rlt_le_dec (Rabs d) (two 1024)) as [| h]; auto. exfalso. apply beyond_greatest in h.
  destruct d_nearest as [_ n], greatest_binary as [g1 g2].
  assert (n1 := n _ (binary_in_format _ g1)). assert (n2 := n _ (binary_in_format _ g2)). clear n.
  rewrite greatest_is, two_971 in *. assert (l := hx). rewrite limit_two in l. assert (p := two_pos 970).
  revert h n1 n2 l. generalize d (two 970) p. clear. intros. magnitudes.
Qed.
Lemma exponent_of : forall m e, d = F2R (Float radix2 m e) -> e = cexp radix2 exponents d -> d <> 0 ->
  (Z.abs m < 2 ^ 53 /\ -1074 <= e <= 971)%Z.
Proof.
  intros m e f c nz. assert (top := mag_le_bpow radix2 d 1024 nz). rewrite <- two_bpow in top.
  specialize (top d_in_range). unfold cexp, FLT_exp in c.
  assert (a := bpow_mag_gt radix2 d). assert (le : (mag radix2 d <= 53 + e)%Z) by lia.
  apply (bpow_le radix2) in le. rewrite <- !two_bpow, two_plus, (two_whole 53) in * by lia.
  split; [| lia]. apply (grows e). rewrite f in a. unfold F2R in a. simpl in a. rewrite <- two_bpow in a.
  rewrite Rabs_mult, (Rabs_pos_eq (two e)), <- abs_IZR in a by (left; apply two_pos).
  rewrite f in le. unfold F2R in le. simpl in le. rewrite <- two_bpow in le. lra.
Qed.
Lemma d_binary : binary 53 d.
Proof.
  destruct (Req_dec d 0) as [-> | nz]; [exists 0%Z, 0%Z; split; [ring | lia] |].
  destruct d_nearest as [f _]. unfold generic_format in f.
  destruct (exponent_of _ _ f eq_refl nz) as [a b].
  exists (Ztrunc (scaled_mantissa radix2 exponents d)), (cexp radix2 exponents d). split; [| lia].
  rewrite f at 1. unfold F2R. simpl. rewrite <- two_bpow. reflexivity.
Qed.
Lemma d_even : Rnd_NE_pt radix2 exponents x d.
Proof.
  assert (e : Exists_NE radix2 exponents) by (apply exists_NE_FLT; first [reflexivity | right; lia]).
  apply (round_NE_pt radix2 exponents).
Qed.

Theorem rounds_as_flocq : rounded_spec x (finite (flocq x)).
Proof.
  apply finite_nearest; auto. split; [apply d_binary |]. intros y hy. fold d.
  destruct d_nearest as [_ n]. assert (ny := n y (binary_in_format y hy)).
  rewrite (Rabs_minus_sym x d), (Rabs_minus_sym x y). split; auto. intro same.
  destruct d_even as [_ [[g [f [c even]]] | only]].
  - right. destruct (Req_dec d 0) as [-> | nz]; [exists 0%Z, 0%Z; split; [ring | lia] |].
    destruct g as [m e]. unfold canonical in c. simpl in c, even. rewrite <- f in c.
    assert (h := exponent_of m e f c nz). replace d with (IZR m * two e).
    + apply even_is_binary; auto. constants. lia.
    + rewrite f. unfold F2R. simpl. rewrite two_bpow. reflexivity.
  - left. apply only. split; [apply binary_in_format, hy |]. intros z hz. rewrite <- same. apply n, hz.
Qed.
End of_number.
