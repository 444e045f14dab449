(* SPDX-License-Identifier: Apache-2.0 *)
(* plane on all of binary64. Nothing guards the offset: where it is finite, the value of the polynomial may overflow
   although the terms do not (each is rounded in a mode of its own). Then its sign is that of another rounding. *)
From Coq Require Import Reals ZArith Lra Lia Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model constants filters steps tactics format floats float_steps float_guards float_run.
From Filters Require Import plane.
Import ListNotations.
Open Scope R_scope.
#[local] Existing Instances p53 fexp_valid below_1024.
#[local] Coercion value : float >-> R.

Lemma finite_mag x : finite x -> mag x 1024.
Proof. intros F. split; [exact F|]. apply Rlt_le, abs_B2R_lt_emax. Qed.
(* a sum of a number below 2^900 and a finite one *)
Lemma wide_sum p x r y k : used p r -> within p k -> (k <=? 900)%Z = true -> used (Plain x) y ->
  Rabs (r + y) < bpow radix2 1024.
Proof.
intros P W K%Z.leb_le [(x' & _ & _ & ->)|(a & b & [] & _)]. pose proof (used_mag _ _ _ P W).
pose proof (abs_B2R_le_emax_minus_prec 53 1024 _ x') as L. fold (value x') in L.
assert (bpow radix2 k < bpow radix2 (1024 - 53)) by (apply bpow_lt; lia).
apply Rle_lt_trans with (1 := Rabs_triang _ _). lra.
Qed.
(* the value, or where it is infinite another rounding of the same sum *)
Definition stands (z : float) r := (finite z /\ r = value z) \/
  (exists s, z = B754_infinity s /\ (if s then r <= - bpow radix2 1023 else bpow radix2 1023 <= r)).
Lemma outcome_stands r z : outcome r z -> Rabs r < bpow radix2 1024 -> exists z0, rounded binary64 r z0 /\ stands z z0.
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
Lemma add_stands p x z k : add floats p (Plain x) z -> within p k -> (k <=? 900)%Z = true -> finite x ->
  exists z0, add M (real p) (Plain (value x)) z0 /\ stands z z0.
Proof.
intros S W K F. assert (X : whole (Plain x)) by now split.
destruct (add_used _ _ _ S (or_intror (conj (within_whole _ _ W) X))) as (r & y & P & Y & O).
destruct (outcome_stands _ _ O (wide_sum _ _ _ _ _ P W K Y)) as (z0 & Z & D). exists z0. split; [|exact D].
exists r, y. split; [now apply used_uses|]. split; [exact (used_uses _ _ Y)|exact Z].
Qed.
Lemma stands_greater x y b z : greater floats x y b -> stands x z -> mag y 1022 -> greater M z (value y) b.
Proof.
intros S [[F ->]|(s & -> & D)] [Y L]; [now apply greater_real|].
destruct S as (x' & y' & X & Y' & E). pose proof (finite_reads _ _ Y' Y) as F.
assert (bpow radix2 1022 < bpow radix2 1023) by (apply bpow_lt; lia). apply abs_le in L.
exists z, (value y). split; [now left|]. split; [now left|].
destruct X as [->|(X & _)]; [|discriminate].
rewrite E. destruct s, y'; try discriminate; simpl; split; intros; try easy; lra.
Qed.
Lemma stands_abs x z : stands x z -> stands (Babs x) (Rabs z).
Proof.
intros [[F ->]|(s & -> & D)].
- left. split; [exact (proj1 (abs_mag _ _ (finite_mag _ F)))|]. now rewrite value_abs.
- right. exists false. split; [reflexivity|]. pose proof (bpow_gt_0 radix2 1023).
  destruct s; [rewrite Rabs_left1|rewrite Rabs_right]; lra.
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
Lemma finite_abs x : finite (Babs x) <-> finite x.
Proof. unfold finite. now rewrite is_finite_Babs. Qed.
Lemma right_finite p x z : add floats p (Plain x) z -> finite z -> finite x.
Proof.
intros A F. destruct (add_used _ _ _ A (or_introl F)) as (r & y & _ & [(x' & X & G & _)|(d & e & [] & _)] & _).
eauto using reads_finite.
Qed.
Lemma terms_real p x z k : add floats p (Plain x) z -> finite z -> within p k -> (k <=? 900)%Z = true ->
  add M (real p) (Plain (value x)) (value z).
Proof.
intros S F W K. destruct (add_used _ _ _ S (or_introl F)) as (r & y & P & Y & O). exists r, y.
split; [now apply used_uses|]. split; [exact (used_uses _ _ Y)|].
apply outcome_rounded; auto. right. exact (wide_sum _ _ _ _ _ P W K Y).
Qed.

Theorem plane_binary64 (nx ny nz offset px py pz : float) answer :
  plane binary64 float floats nx ny nz offset px py pz answer ->
  correct answer [nx; ny; nz; offset; px; py; pz] (nx * px + ny * py + nz * pz + offset).
Proof.
intros R. unfold plane in R. float_guards R.
lazymatch goal with
| V : add floats _ (Plain offset) ?v, T : add floats ?p (Plain (Babs offset)) ?terms, C : mul floats _ ?terms ?t,
  A : add floats (Product _ ?terms ?t) _ ?bound, K : greater floats (Babs ?v) ?bound true, U : up ?bound |- _ =>
  pose proof (bound_terms _ _ _ _ _ C A (bound_finite _ _ K U)) as F; pose proof (finite_mag _ F) as B';
  pose proof (right_finite _ _ _ T F) as F'; rewrite finite_abs in F'; pose proof (finite_mag _ F') as B'' end.
split; [intros _; all_finite|].
apply plane_right with binary64; [fits|]. unfold plane. repeat advance.
lazymatch goal with V : add floats (Plain ?r) (Plain offset) ?v |- _ => lazymatch goal with B : mag r ?k |- _ =>
  destruct (add_stands _ _ _ k V (conj B I) eq_refl F') as (v0 & V0 & D); exists v0; split; [exact V0|clear V] end end.
repeat advance.
lazymatch goal with T : add floats (Product ?a ?b ?t) (Plain (Babs offset)) ?terms |- _ => exists (value terms);
  split; [as_real; let W := within_of (Product a b t) in exact (terms_real _ _ _ _ T F W eq_refl)|clear T] end.
repeat advance.
lazymatch goal with K : greater floats (Babs ?v) ?b true, B : mag ?b ?k |- _ => exists true;
  split; [exact (stands_greater _ _ _ _ K (stands_abs _ _ D) (mag_up b k 1022 B ltac:(discriminate)))|clear K] end.
repeat advance.
lazymatch goal with K : greater floats ?v ?b ?s, B : mag ?b ?k |- _ => exists s;
  split; [exact (stands_greater _ _ _ _ K D (mag_up b k 1022 B ltac:(discriminate)))|exact R] end.
Qed.
