(* SPDX-License-Identifier: Apache-2.0 *)
(* window.h: what its two guards give; range.v says what follows for sums and products. *)
From Coq Require Import Reals ZArith List Lra Lia.
From Flocq Require Import Core.
From Filters Require Import arithmetic enclosed nearest enclosures.
Open Scope R_scope.

Definition rounds mode := round radix2 (FLT_exp (-1074) 53) mode.
Notation double := (generic_format radix2 (FLT_exp (-1074) 53)).
#[local] Instance FLT_valid : Valid_exp (FLT_exp (-1074) 53). Proof. now apply FLT_exp_valid. Qed.

(* Whether 1 + tiny <= 1 - tiny. *)
Definition told mode := rounds mode (1 + tiny) <= rounds mode (1 - tiny).
Lemma one_double : double 1.
Proof. change 1 with (bpow radix2 0). apply generic_format_bpow. unfold FLT_exp. simpl. lia. Qed.
Lemma near_one choice x : Rabs (x - 1) <= tiny -> rounds (Znearest choice) x = 1.
Proof.
intros L. unfold tiny in L. pose proof L as L'. assert (D : double (rounds (Znearest choice) x)) by 
  (apply generic_format_round; auto with typeclass_instances).
pose proof (round_N_pt radix2 (FLT_exp (-1074) 53) choice x) as [_ N]. specialize (N 1 one_double).
fold (rounds (Znearest choice) x) in *. set (z := rounds (Znearest choice) x) in *.
rewrite (Rabs_minus_sym 1 x) in N. apply (Rle_trans _ _ _ N) in L. clear N.
assert (B : Rabs (z - 1) <= / 2 ^ 59) by (clear D; bounds; apply le_abs; lra).
apply generic_format_FLX_FLT in D.
assert (M : multiple (-53) z).
{ replace (-53)%Z with (-1 + 1 - 53)%Z by reflexivity. apply multiple_of_digits; [reflexivity|exact D|right].
  change (bpow radix2 (-1)) with (/ 2). rewrite Rabs_right; bounds; lra. }
assert (M1 : multiple (-53) (z - 1)) by (apply multiple_minus; [exact M|]; exists (2 ^ 53)%Z; simpl; lra).
destruct (multiple_zero_or _ _ M1) as [Z|Z]; [lra|]. exfalso.
assert (/ 2 ^ 53 <= Rabs (z - 1)) by (apply Rle_trans with (2 := Z); simpl; lra). lra.
Qed.
Theorem rounds_to_nearest_right : (forall choice, told (Znearest choice)) /\
  ~ told Zfloor /\ ~ told Zceil /\ ~ told Ztrunc.
Proof.
assert (T0 : 0 < tiny) by (unfold tiny; lra). assert (T1 : tiny < 1) by (unfold tiny; lra).
assert (P : forall mode, Valid_rnd mode -> rounds mode 1 = 1) by (intros; apply round_generic; auto using one_double).
assert (F : 1 <= rounds Zfloor (1 + tiny)).
{ apply Rle_trans with (rounds Zfloor 1); [right; symmetry; auto with typeclass_instances|].
  apply round_le; auto with typeclass_instances. lra. }
assert (C : rounds Zceil (1 - tiny) <= 1).
{ apply Rle_trans with (rounds Zceil 1); [|right; auto with typeclass_instances].
  apply round_le; auto with typeclass_instances. lra. }
split; [|split; [|split]].
- intros choice. unfold told. rewrite !near_one; [apply Rle_refl| |]; apply le_abs; lra.
- unfold told. intros E.
  destruct (round_DN_pt radix2 (FLT_exp (-1074) 53) (1 - tiny)) as (_ & B & _).
  change (rounds Zfloor (1 - tiny) <= 1 - tiny) in B. lra.
- unfold told. intros E.
  destruct (round_UP_pt radix2 (FLT_exp (-1074) 53) (1 + tiny)) as (_ & B & _).
  change (1 + tiny <= rounds Zceil (1 + tiny)) in B. lra.
- unfold told, rounds. rewrite !round_ZR_DN by lra. intros E.
  destruct (round_DN_pt radix2 (FLT_exp (-1074) 53) (1 - tiny)) as (_ & B & _). unfold rounds in F. lra.
Qed.

(* Window::holds of one lane's numbers: no bit set, and the sum of sizes. *)
Definition in_window mode first rest := Forall (fun x => x = 0 \/ least <= Rabs x) (first :: rest) /\
  fold_left (fun s x => rounds mode (s + Rabs x)) rest (Rabs first) <= most.
Lemma sum_of_sizes mode {V : Valid_rnd mode} xs s : double s -> 0 <= s -> Forall double xs ->
  fold_left (fun s x => rounds mode (s + Rabs x)) xs s <= most -> s <= most /\ Forall (fun x => Rabs x <= most) xs.
Proof.
revert s. induction xs as [|x xs IH]; intros s D S F L; [split; [exact L|constructor]|].
inversion F as [|? ? Dx Fx]; subst. pose proof (Rabs_pos x) as P.
destruct (IH (rounds mode (s + Rabs x))) as [A B]; auto.
- apply generic_format_round; auto with typeclass_instances.
- apply round_ge_generic; auto with typeclass_instances; [apply generic_format_0|lra].
- assert (s <= rounds mode (s + Rabs x)) by (apply round_ge_generic; auto with typeclass_instances; lra).
  assert (Rabs x <= rounds mode (s + Rabs x)).
  { apply round_ge_generic; auto using generic_format_abs with typeclass_instances. lra. }
  split; [lra|]. constructor; [lra|exact B].
Qed.
Theorem in_window_right mode {V : Valid_rnd mode} x xs : Forall double (x :: xs) -> in_window mode x xs ->
  Forall (fun y => multiple (-152) y /\ Rabs y <= most) (x :: xs).
Proof.
intros D [S L]. inversion D as [|? ? Dx Dxs]; subst.
destruct (sum_of_sizes mode xs (Rabs x)) as [A B]; auto using generic_format_abs, Rabs_pos.
assert (C : Forall (fun y => Rabs y <= most) (x :: xs)) by now constructor.
rewrite Forall_forall in *. intros y I. split; [|now apply C].
replace (-152)%Z with (-100 + 1 - 53)%Z by reflexivity.
apply multiple_of_digits; [reflexivity|now apply generic_format_FLX_FLT with (-1074)%Z, D|].
destruct (S y I) as [->|Y]; [now left|right]. apply Rle_trans with (2 := Y). unfold least. simpl. lra.
Qed.
