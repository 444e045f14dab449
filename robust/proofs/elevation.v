(* SPDX-License-Identifier: Apache-2.0 *)
(* elevation of filters.h. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Filters Require Import model constants filters steps ghost tactics.
Open Scope R_scope.

(* P and Q: the product m where it is added, and where its magnitude is; S: the computed sum *)
Theorem wrong_sign u m c y P Q S : 0 < u <= 1/16 ->
  Rabs (P - m) <= u * Rabs m -> Rabs (Q - m) <= u * Rabs m -> Rabs (S - (P + c)) <= u * Rabs (P + c) ->
  let K := u / (1 - 2 * u) in
  (y <= m + c -> y - S <= K * (Rabs Q + Rabs c + Rabs y)) /\ (m + c <= y -> S - y <= K * (Rabs Q + Rabs c + Rabs y)).
Proof.
intros Hu HP HQ HS K.
assert (EK : K * (1 - 2 * u) = u) by (unfold K; field; lra).
assert (K0 : 0 < K) by (unfold K; apply Rdiv_lt_0_compat; lra).
assert (LQ : (1 - u) * Rabs m <= Rabs Q).
{ generalize (Rabs_triang_inv m (m - Q)). replace (m - (m - Q)) with Q by ring. rewrite (Rabs_minus_sym m Q). lra. }
assert (LS : (1 - u) * Rabs (P + c) <= Rabs S).
{ generalize (Rabs_triang_inv (P + c) (P + c - S)). replace (P + c - (P + c - S)) with S by ring.
  rewrite (Rabs_minus_sym (P + c) S). lra. }
generalize (Rabs_pos m) (Rabs_pos (P + c)) (Rabs_pos c) (Rabs_pos y) (Rabs_pos Q); intros.
assert (R0 : 0 <= K * (Rabs Q + Rabs c + Rabs y)) by (apply Rmult_le_pos; lra).
assert (main : forall V, V <= u * (Rabs m + Rabs (P + c)) -> (0 <= V -> Rabs S <= V + Rabs y) ->
  V <= K * (Rabs Q + Rabs c + Rabs y)).
{ intros V HV HY. destruct (Rle_or_lt 0 V) as [V0|V0]; [specialize (HY V0)|lra].
  apply Rle_trans with (K * ((1 - u) * (Rabs m + Rabs (P + c)) - V)); [|apply Rmult_le_compat_l; lra].
  assert (V * (1 - u) <= u * (Rabs m + Rabs (P + c)) * (1 - u)) by (apply Rmult_le_compat_r; lra).
  apply Rmult_le_reg_r with (1 - 2 * u); [lra|].
  replace (K * ((1 - u) * (Rabs m + Rabs (P + c)) - V) * (1 - 2 * u))
    with (K * (1 - 2 * u) * ((1 - u) * (Rabs m + Rabs (P + c)) - V)) by ring.
  rewrite EK. lra. }
apply abs_le in HP, HS.
split; intros L; apply main; try lra; intros V0.
- replace S with (y - (y - S)) at 1 by ring. apply Rle_trans with (1 := Rabs_triang _ _).
  rewrite Rabs_Ropp, (Rabs_right (y - S)); lra.
- replace S with (y + (S - y)) at 1 by ring. apply Rle_trans with (1 := Rabs_triang _ _).
  rewrite (Rabs_right (S - y)); lra.
Qed.
Lemma elevation_enough u : 0 < u <= 1/16 -> (1 + u) * (u / (1 - 2 * u)) <= (1 - u) ^ 4 * relative 2 10 u.
Proof.
intros Hu. unfold relative. apply Rmult_le_reg_r with (1 - 2 * u); [lra|].
replace ((1 + u) * (u / (1 - 2 * u)) * (1 - 2 * u)) with ((1 + u) * u) by (field; lra). powers u Hu. lra.
Qed.

Theorem elevation_right F slope intercept px py answer : fits F (third F) 1 1 ->
  elevation F R (reals F) slope intercept px py answer ->
  let exact := py - (slope * px + intercept) in
  (answer = positive -> exact > 0) /\ (answer = negative -> exact < 0).
Proof.
intros G R exact. unfold elevation in R. unpack. constants. flags R. nonneg. guarded G. parts G.
normal G 2 10 2%Z. inputs G (slope, intercept, px, py). steps G.
bounded G 64%Z lows_here Pos Neg.
match type of Pos with _ -> (py - (?P + intercept) * (1 + ?es)) * (1 + ?e) > _ * (?C * (Rabs ?Q + _ + _)) =>
  pose proof (Rabs_pos Q); pose proof (Rabs_pos intercept); pose proof (Rabs_pos py);
  set (T := Rabs Q + Rabs intercept + Rabs py) in *; assert (T0 : 0 <= T) by (unfold T; lra);
  assert (K0 : 0 < u F / (1 - 2 * u F)) by (apply Rdiv_lt_0_compat; lra);
  destruct (beyond (u F) Hu (py - (P + intercept) * (1 + es)) e (u F / (1 - 2 * u F) * T) ((1 - u F) ^ 4 * (C * T)))
    as [P' Q']; [assumption|apply Rmult_le_pos; lra| |];
  [ apply Rle_trans with ((1 + u F) * (u F / (1 - 2 * u F)) * T); [right; ring|];
    rewrite <- (Rmult_assoc ((1 - u F) ^ 4)); apply Rmult_le_compat_r; [exact T0|apply (elevation_enough (u F) Hu)] |];
  destruct (wrong_sign (u F) (slope * px) intercept py P Q ((P + intercept) * (1 + es)) Hu) as [W1 W2];
    [apply rounding; assumption|apply rounding; assumption|apply rounding; assumption|] end.
fold T in W1, W2. clear - Pos Neg P' Q' W1 W2 R. unfold exact. signs R Pos Neg P' Q' W1 W2.
Qed.
