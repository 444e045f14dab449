(* SPDX-License-Identifier: Apache-2.0 *)
(* Numbers of a lane that cannot overflow, with what their roundings add up to. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model constants steps format floats ghost lanes.
From Filters Require Import lane_bounds lane_filters lane_turns lane_values lane_segments.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.
#[local] Existing Instances p53 fexp_valid below_1024.

Lemma few j : (j <= 16)%nat -> 0 <= (1 + v) ^ j - 1 <= 1.
Proof.
intros J. pose proof (upward v v_small j). pose proof (upward_more v v_small j 16 J).
assert ((1 + v) ^ 16 <= 2) by (rewrite v_is; simpl; lra). lra.
Qed.

(* In greater units, and in smaller ones. *)
Lemma est_units j A x t T T' : est j A x t T -> T <= T' -> est j A x t T'.
Proof.
intros (x' & [O1 O2] & L) LE. exists x'. split; [split; [lra|]|exact L]. apply Rle_trans with (1 := O2).
apply Rmult_le_compat_l; [|exact LE]. pose proof (upward v v_small j). lra.
Qed.
Lemma est_to j A x t T : est j A x t T -> Rabs t <= T /\ Rabs (x - t) <= ((1 + v) ^ j - 1) * T + A.
Proof.
intros (x' & [O1 O2] & L). split; [exact O1|]. replace (x - t) with (x - x' + (x' - t)) by ring.
pose proof (Rabs_triang (x - x') (x' - t)). lra.
Qed.
Lemma est_from j A x t T : Rabs t <= T -> 0 <= A -> Rabs (x - t) <= ((1 + v) ^ j - 1) * T + A -> est j A x t T.
Proof.
intros O P L. assert (T0 : 0 <= T) by (pose proof (Rabs_pos t); lra).
assert (K0 : 0 <= ((1 + v) ^ j - 1) * T).
{ apply Rmult_le_pos; [|exact T0]. pose proof (upward v v_small j). lra. }
set (K := ((1 + v) ^ j - 1) * T) in *. destruct (Rle_or_lt (Rabs (x - t)) K) as [Q|Q].
- exists x. split; [now split|]. now rewrite Rminus_diag_eq, Rabs_R0 by reflexivity.
- destruct (Rle_or_lt 0 (x - t)) as [S|S].
  + rewrite Rabs_right in L, Q by lra. exists (t + K).
    split; [split; [exact O|]; fold K; rewrite Rabs_right; lra|rewrite Rabs_right; lra].
  + rewrite Rabs_left in L, Q by lra. exists (t - K).
    split; [split; [exact O|]; fold K; rewrite Rabs_left1; lra|rewrite Rabs_left1; lra].
Qed.
Lemma est_less j A B x t T D : est j A x t (T + D) -> Rabs t <= T -> 0 <= D -> A + D <= B -> (j <= 16)%nat ->
  est j B x t T.
Proof.
intros E O P L J. pose proof (est_nonneg _ _ _ _ _ E). apply est_to in E as [_ E]. pose proof (few j J) as K.
apply est_from; [exact O|lra|]. set (k := (1 + v) ^ j - 1) in *. assert (k * D <= 1 * D) by (apply Rmult_le_compat_r;
  lra). lra.
Qed.

(* What multiply_add gives at least, of numbers that are not negative. *)
Lemma multiply_add_least fused (m c k : float) : finite (multiply_add fused m c k) -> 0 <= value m -> 0 <= value c ->
  16 * eta <= value k -> (1 - 3 * v) * (value c * value m) + value k / 2 <= value (multiply_add fused m c k).
Proof.
intros F M C K. apply multiply_add_finite in F as (_ & _ & _ & E). rewrite (Rmult_comm (value m)) in E.
assert (P : 0 <= value c * value m) by now apply Rmult_le_pos. set (y := value c * value m) in *.
set (d := value k) in *. pose proof v_small. pose proof eta_pos. clearbody y d.
assert (0 <= v * y) by (apply Rmult_le_pos; lra). assert (v * d <= 1 / 16 * d) by (apply Rmult_le_compat_r; lra).
assert (0 <= v * v * y) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra).
assert (0 <= v * eta) by (apply Rmult_le_pos; lra).
destruct E as [->| ->].
- destruct (rnd_any (y + d)) as (e & h & B1 & B2 & ->). apply abs_le in B1, B2.
  assert ((y + d) * (1 - v) <= (y + d) * (1 + e)) by (apply Rmult_le_compat_l; lra). lra.
- destruct (rnd_any y) as (e & h & B1 & B2 & Q). pose proof (rnd_pos y P). rewrite Q in *. apply abs_le in B1, B2.
  assert (y * (1 - v) <= y * (1 + e)) by (apply Rmult_le_compat_l; lra). set (y' := y * (1 + e) + h) in *.
  assert (Y : y * (1 - v) - eta <= y') by (unfold y'; lra). clearbody y'.
  destruct (rnd_any (y' + d)) as (e' & h' & B3 & B4 & ->). apply abs_le in B3, B4.
  assert ((y' + d) * (1 - v) <= (y' + d) * (1 + e')) by (apply Rmult_le_compat_l; lra).
  assert ((y * (1 - v) - eta + d) * (1 - v) <= (y' + d) * (1 - v)) by (apply Rmult_le_compat_r; lra). lra.
Qed.

(* Finite, with j roundings, where no sum or product of units exceeds 2^1017. *)
Notation room := (bpow radix2 1017).
Definition lane j A (x : float) t T := finite x /\ est j A x t T.
Lemma room_is : 1 <= room. Proof. change 1 with (bpow radix2 0). apply bpow_le. lia. Qed.
Lemma lane_given x : finite x -> lane 0 0 x x (Rabs x).
Proof. intros F. split; [exact F|apply of_given]. Qed.
Lemma lane_difference x y : finite (minus x y) -> lane 1 0 (minus x y) (x - y) (Rabs (x - y)).
Proof. intros F. split; [exact F|now apply of_difference]. Qed.
Lemma lane_units j A x t T T' : lane j A x t T -> T <= T' -> lane j A x t T'.
Proof. intros [F E] L. split; [exact F|exact (est_units _ _ _ _ _ _ E L)]. Qed.
Lemma lane_size j A x t T : lane j A x t T -> lane j A (size x) (Rabs t) T.
Proof. intros [F E]. split; [now destruct x|now apply of_size]. Qed.
Lemma lane_mag j A x t T k : lane j A x t T -> (j <= 16)%nat -> A <= bpow radix2 k -> T <= bpow radix2 k -> mag x (k
  + 2).
Proof.
intros [F E] J LA LT. split; [exact F|]. apply est_to in E as [O E]. pose proof (few j J) as K.
set (c := (1 + v) ^ j - 1) in *. assert (P : 0 <= T) by (pose proof (Rabs_pos t); lra).
assert (c * T <= 1 * T) by (apply Rmult_le_compat_r; lra). rewrite bpow_plus. change (bpow radix2 2) with 4.
replace (value x) with (t + (value x - t)) by ring. pose proof (Rabs_triang t (value x - t)). lra.
Qed.
Ltac mags X := eapply (lane_mag _ _ _ _ _ 1017) in X; [|lia|pose proof room_is; lra|assumption].
Lemma lane_plus i j k A B x y s t S T : lane i A x s S -> lane j B y t T -> Nat.max i j = k -> (k <= 15)%nat ->
  S <= room -> T <= room -> A <= 1 -> B <= 1 ->
  lane (Datatypes.S k) (2 * (A + B)) (plus x y) (s + t) (S + T).
Proof.
intros X Y <- K LS LT LA LB. assert (F : finite (plus x y)).
{ assert (MX := X). assert (MY := Y). mags MX. mags MY. apply (mag_plus _ _ _ MX MY). lia. }
split; [exact F|]. apply of_plus; [exact F|apply X|apply Y].
Qed.
Lemma lane_minus i j k A B x y s t S T : lane i A x s S -> lane j B y t T -> Nat.max i j = k -> (k <= 15)%nat ->
  S <= room -> T <= room -> A <= 1 -> B <= 1 ->
  lane (Datatypes.S k) (2 * (A + B)) (minus x y) (s - t) (S + T).
Proof.
intros X Y <- K LS LT LA LB. assert (F : finite (minus x y)).
{ assert (MX := X). assert (MY := Y). mags MX. mags MY. apply (mag_minus _ _ _ MX MY). lia. }
split; [exact F|]. apply of_minus; [exact F|apply X|apply Y].
Qed.
Lemma lane_times i j x y s t S T : lane i 0 x s S -> lane j 0 y t T -> (i <= 16)%nat -> (j <= 16)%nat ->
  S * T <= room -> lane (Datatypes.S (i + j)) eta (times x y) (s * t) (S * T).
Proof.
intros [FX X] [FY Y] I J L. assert (F : finite (times x y)).
{ apply (mag_times x y 1019 FX FY); [|lia]. apply est_to in X as [OX X]. apply est_to in Y as [OY Y].
  assert (D : forall i a b B, (i <= 16)%nat -> Rabs b <= B -> Rabs (a - b) <= ((1 + v) ^ i - 1) * B + 0 ->
    Rabs a <= 2 * B).
  { intros n a b B N O E. pose proof (few n N) as K. assert (P : 0 <= B) by (pose proof (Rabs_pos b); lra).
    set (c := (1 + v) ^ n - 1) in *. assert (c * B <= 1 * B) by (apply Rmult_le_compat_r; lra).
    replace a with (b + (a - b)) by ring. pose proof (Rabs_triang b (a - b)). lra. }
  apply (D _ _ _ _ I OX) in X. apply (D _ _ _ _ J OY) in Y. rewrite Rabs_mult.
  apply Rle_trans with (2 * S * (2 * T)); [apply Rmult_le_compat; auto using Rabs_pos|].
  change 1019%Z with (2 + 1017)%Z. rewrite bpow_plus. change (bpow radix2 2) with 4. lra. }
split; [exact F|]. now apply of_times.
Qed.
Lemma lane_absorbed j A x t T : lane j A x t T -> (1 <= j)%nat -> A <= 64 * eta -> lane j 0 x t (T + spare).
Proof.
intros [F E] J L. split; [exact F|]. apply est_absorb with (A := A); [exact J| |exact E].
apply Rle_trans with (1 := L). unfold eta, v. pose proof (bpow_gt_0 radix2 (-1074)).
replace (/ 2 * bpow radix2 (-52) * spare) with (/ 2 * bpow radix2 (-1062)).
- assert (64 * bpow radix2 (-1074) <= bpow radix2 (-1062)); [|lra].
  change 64 with (bpow radix2 6). rewrite <- bpow_plus. apply bpow_le. lia.
- change (-1062)%Z with (-52 + -1010)%Z. rewrite bpow_plus. ring.
Qed.

(* How large numbers are at most. *)
Lemma mag_product x y i j k : mag x i -> mag y j -> (i + j = k)%Z -> (-1000 <= k <= 1022)%Z -> mag (times x y) k.
Proof.
intros [X LX] [Y LY] <- K. apply mag_times; try assumption. rewrite Rabs_mult, bpow_plus.
apply Rmult_le_compat; auto using Rabs_pos.
Qed.
Lemma mag_multiply_add fused a b c i j k : mag a i -> mag b j -> mag c k -> (i + j <= k)%Z -> (-1000 <= k <= 1000)%Z
  ->
  (-1000 <= i + j)%Z -> mag (multiply_add fused a b c) (k + 1).
Proof.
intros A B C L K J. unfold multiply_add. destruct fused.
- destruct A as [FA A], B as [FB B], C as [FC C].
  apply (outcome_mag _ _ _ (outcome_fma mode_NE a b c FA FB FC)).
  + rewrite bpow_plus. simpl (bpow radix2 1). apply Rle_trans with (1 := Rabs_triang _ _).
    assert (Rabs (a * b) <= bpow radix2 k); [|lra]. rewrite Rabs_mult.
    apply Rle_trans with (bpow radix2 i * bpow radix2 j); [apply Rmult_le_compat; auto using Rabs_pos|].
    rewrite <- bpow_plus. now apply bpow_le.
  + unfold fair. apply andb_true_intro. split; apply Z.leb_le; lia.
- apply mag_plus; [|exact C|lia]. apply mag_more with (i + j)%Z; [|exact L]. eapply mag_product; eauto; lia.
Qed.
Lemma mag_number m e k : (Z.abs m < 2 ^ 53)%Z -> (-1074 <= e <= 971)%Z -> (Z.abs m <= 2 ^ (k - e))%Z -> (e <= k)%Z ->
  mag (number m e) k.
Proof.
intros M E L K. destruct (number_value m e M E) as [F V]. split; [exact F|]. rewrite V, Rabs_mult.
rewrite (Rabs_right (bpow radix2 e)) by (apply Rle_ge, bpow_ge_0). rewrite <- abs_IZR.
replace (bpow radix2 k) with (IZR (2 ^ (k - e)) * bpow radix2 e).
- apply Rmult_le_compat_r; [apply bpow_ge_0|now apply IZR_le].
- change 2%Z with (radix_val radix2) at 1. rewrite IZR_Zpower by lia. rewrite <- bpow_plus. f_equal. ring.
Qed.
