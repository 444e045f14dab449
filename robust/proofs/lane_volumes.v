(* SPDX-License-Identifier: Apache-2.0 *)
(* Determinants of three displacements in a lane, in units of the greatest magnitudes of coordinates by axis. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model constants steps format floats ghost lanes.
From Filters Require Import lane_bounds lane_turns lane_values lane_sums lane_segments lane_faces lane_moderate.
From Filters Require Import lane_triangle_filters.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.
#[local] Existing Instances p53 fexp_valid below_1024.
#[local] Opaque plus minus times multiply_add.

(* What underflows: spare for a coordinate of a vector product, rest for a determinant; paid is what pays for it. *)
Notation rest := (bpow radix2 (-676)).
Notation paid := (bpow radix2 (-700)).
Notation top := (bpow radix2 331).
Definition unit X := 0 <= X <= top.
Lemma small_rests : 0 < spare <= / 1048576 /\ 0 < rest <= / 1048576 /\ eta <= / 1048576.
Proof.
assert (T : forall e, (e <= -20)%Z -> 0 < bpow radix2 e <= / 1048576).
{ intros e E. split; [apply bpow_gt_0|]. apply Rle_trans with (bpow radix2 (-20)); [now apply bpow_le|]. right.
  reflexivity. }
split; [apply T; lia|]. split; [apply T; lia|]. unfold eta. pose proof (T (-1074)%Z ltac:(lia)). lra.
Qed.
Lemma unit_product X Y : unit X -> unit Y -> 0 <= X * Y <= bpow radix2 662.
Proof.
intros [A B] [C D]. change 662%Z with (331 + 331)%Z. rewrite bpow_plus.
split; [now apply Rmult_le_pos|apply Rmult_le_compat; lra].
Qed.
Lemma unit_volume X Y Z : unit X -> unit Y -> unit Z -> 0 <= X * Y * Z <= bpow radix2 993.
Proof.
intros A B C. pose proof (unit_product _ _ A B). destruct C. change 993%Z with (662 + 331)%Z. rewrite bpow_plus.
split; [now apply Rmult_le_pos|apply Rmult_le_compat; lra].
Qed.
Lemma rooms : 1024 * bpow radix2 662 <= room /\ 1024 * bpow radix2 993 <= room /\ 1024 * top <= room.
Proof.
assert (T : forall e, (e <= 1007)%Z -> 1024 * bpow radix2 e <= room).
{ intros e E. change 1024 with (bpow radix2 10). rewrite <- bpow_plus. apply bpow_le. lia. }
repeat split; apply T; lia.
Qed.
Lemma spare_of_units : spare * (top + top + top) + spare <= rest.
Proof.
assert (E : spare * (top + top + top) = 3 * bpow radix2 (-679)).
{ change (-679)%Z with (-1010 + 331)%Z. rewrite bpow_plus. ring. }
rewrite E. pose proof (bpow_le radix2 (-1010) (-679) ltac:(lia)). change (-676)%Z with (3 + -679)%Z. rewrite bpow_plus.
change (bpow radix2 3) with 8. pose proof (bpow_gt_0 radix2 (-679)). lra.
Qed.

(* A coordinate with one rounding, or none, in units of its axis. *)
Definition entry (d : float) r X := lane 1 0 d r X.
Lemma entry_minus (p q : float) X : finite (minus p q) -> Rabs (minus p q) <= X ->
  entry (minus p q) (p - q) (X * (1 + 2 * v)).
Proof.
intros F L. split; [exact F|]. pose proof v_small. assert (P : 0 <= X) by (pose proof (Rabs_pos (minus p q)); lra).
destruct (minus_finite _ _ F) as (_ & _ & E). rewrite E in *.
destruct (rnd_difference p q (held_value _) (held_value _)) as (e & B & Q). rewrite Q in *. apply abs_le in B.
rewrite Rabs_mult, (Rabs_right (1 + e)) in L by lra. pose proof (Rabs_pos (p - q)) as N.
assert (T : Rabs (p - q) <= X * (1 + 2 * v)).
{ assert (Rabs (p - q) * (1 - v) <= X) by nra. rewrite v_is in *. nra. }
apply est_exact. split; [exact T|]. replace ((p - q) * (1 + e) - (p - q)) with ((p - q) * e) by ring.
rewrite Rabs_mult. replace ((1 + v) ^ 1 - 1) with v by ring. rewrite Rmult_comm.
apply Rmult_le_compat; auto using Rabs_pos. apply Rabs_le. lra.
Qed.
Lemma entry_given (d : float) X : finite d -> Rabs d <= X -> entry d d (X * (1 + 2 * v)).
Proof.
intros F L. pose proof v_small. pose proof (Rabs_pos d). apply lane_units with (Rabs d); [|nra].
split; [exact F|]. apply est_more with (3 := of_given d); [lia|apply Rle_refl].
Qed.

Definition three X Y Z := unit X /\ unit Y /\ unit Z.
Definition vector '(d1, d2, d3) '(r1, r2, r3) '(X, Y, Z) := three X Y Z /\ entry d1 r1 X /\ entry d2 r2 Y /\
  entry d3 r3 Z.
Definition cross '(s1, s2, s3) '(t1, t2, t3) := (minus (times s2 t3) (times s3 t2), minus (times s3 t1) (times s1 t3),
  minus (times s1 t2) (times s2 t1)).
Definition dot '(a1, a2, a3) '(b1, b2, b3) := lane_dot a1 a2 a3 b1 b2 b3.
Definition det '(s1, s2, s3) '(t1, t2, t3) '(d1, d2, d3) := face_exact s1 s2 s3 t1 t2 t3 d1 d2 d3.
(* The six products, of units. *)
Definition total '(A1, A2, A3) '(B1, B2, B3) '(C1, C2, C3) :=
  (A2 * B3 + A3 * B2) * C1 + (A3 * B1 + A1 * B3) * C2 + (A1 * B2 + A2 * B1) * C3.

Lemma minor_says (p q r w : float) p' q' r' w' A B C D : entry p p' A -> entry q q' B -> entry r r' C -> entry w w' D ->
  unit A -> unit B -> unit C -> unit D ->
  lane 4 0 (minus (times p q) (times r w)) (p' * q' - r' * w') (A * B + C * D + spare).
Proof.
intros P Q R W UA UB UC UD. destruct small_rests as (S & _ & E). pose proof eta_pos. destruct rooms as (L & _).
pose proof (unit_product _ _ UA UB). pose proof (unit_product _ _ UC UD).
assert (K1 := lane_times _ _ _ _ _ _ _ _ P Q ltac:(lia) ltac:(lia) ltac:(lra)).
assert (K2 := lane_times _ _ _ _ _ _ _ _ R W ltac:(lia) ltac:(lia) ltac:(lra)).
assert (K := lane_minus _ _ _ _ _ _ _ _ _ _ _ K1 K2 eq_refl ltac:(cbn;
  lia) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)).
apply lane_absorbed in K; [exact K|cbn; lia|lra].
Qed.
Lemma term_says (c d : float) c' d' P Q A : lane 4 0 c c' (P + Q + spare) -> entry d d' A ->
  0 <= P <= bpow radix2 662 -> 0 <= Q <= bpow radix2 662 -> unit A ->
  let T := (P + Q + spare) * A in lane 6 eta (times c d) (c' * d') T /\ 0 <= T <= room / 128 /\
    T <= (P + Q) * A + spare * top.
Proof.
intros C D LP LQ [A0 A1] T. destruct small_rests as (S & _). destruct rooms as (_ & L & L').
assert (B : bpow radix2 662 * top = bpow radix2 993) by (rewrite <- bpow_plus; reflexivity).
assert (PA : 0 <= (P + Q) * A <= 2 * bpow radix2 993).
{ split; [apply Rmult_le_pos; lra|]. rewrite <- B, <- Rmult_assoc. apply Rmult_le_compat; lra. }
assert (SA : 0 <= spare * A <= spare * top) by (split; [apply Rmult_le_pos; lra|apply Rmult_le_compat_l; lra]).
assert (ST : spare * top <= top) by nra.
assert (TE : T = (P + Q) * A + spare * A) by (unfold T; ring). split; [|lra].
apply (lane_times _ _ _ _ _ _ _ _ C D); try lia. fold T. lra.
Qed.
(* A determinant, with eight roundings. *)
Lemma det_says s t d s' t' d' A B C : vector s s' A -> vector t t' B -> vector d d' C ->
  lane 8 0 (dot (cross s t) d) (det s' t' d') (total A B C + rest).
Proof.
destruct s as [[s1 s2] s3], t as [[t1 t2] t3], d as [[d1 d2] d3], s' as [[s1' s2'] s3'], t' as [[t1' t2'] t3'],
  d' as [[d1' d2'] d3'], A as [[A1 A2] A3], B as [[B1 B2] B3], C as [[C1 C2] C3].
intros ((UA1 & UA2 & UA3) & S1 & S2 & S3) ((UB1 & UB2 & UB3) & T1 & T2 & T3) ((UC1 & UC2 & UC3) & D1 & D2 & D3).
assert (M1 := minor_says _ _ _ _ _ _ _ _ _ _ _ _ S2 T3 S3 T2 UA2 UB3 UA3 UB2).
assert (M2 := minor_says _ _ _ _ _ _ _ _ _ _ _ _ S3 T1 S1 T3 UA3 UB1 UA1 UB3).
assert (M3 := minor_says _ _ _ _ _ _ _ _ _ _ _ _ S1 T2 S2 T1 UA1 UB2 UA2 UB1).
assert (P := unit_product). pose proof small_rests as (S & R & E). pose proof eta_pos.
destruct (term_says _ _ _ _ _ _ _ M1 D1 (P _ _ UA2 UB3) (P _ _ UA3 UB2) UC1) as (K1 & L1 & Q1).
destruct (term_says _ _ _ _ _ _ _ M2 D2 (P _ _ UA3 UB1) (P _ _ UA1 UB3) UC2) as (K2 & L2 & Q2).
destruct (term_says _ _ _ _ _ _ _ M3 D3 (P _ _ UA1 UB2) (P _ _ UA2 UB1) UC3) as (K3 & L3 & Q3).
assert (K := lane_plus _ _ 6 _ _ _ _ _ _ _ _ K1 K2 eq_refl ltac:(lia) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)).
assert (K' := lane_plus _ _ 7 _ _ _ _ _ _ _ _ K K3 eq_refl ltac:(lia) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)).
apply lane_absorbed in K'; [|lia|lra]. cbn [dot cross det total]. unfold lane_dot, face_exact.
apply lane_units with (1 := K'). pose proof spare_of_units. lra.
Qed.

(* What a value says of a number: its sign, where it is beyond the bound. *)
Definition signed (z b : float) t := above (size z) b = true ->
  (negative_lane z = true -> t < 0) /\ (negative_lane z = false -> t > 0).
Lemma power_up k : (k <= 15)%nat -> (1 + v) * ((1 + v) ^ k - 1) <= (INR k + 1 / 4) * v.
Proof.
intros K. assert (IK : 0 <= INR k <= 15)
  by (split; [apply pos_INR|replace 15 with (INR 15) by (simpl; lra); now apply le_INR]).
pose proof (bernoulli_up v v_small k ltac:(rewrite v_is; lra)) as B. set (J := INR k) in *.
apply Rle_trans with ((1 + v) * (J * v + (J * v) ^ 2)); [apply Rmult_le_compat_l; [pose proof v_small; lra|lra]|].
rewrite v_is. nra.
Qed.
Lemma sign_by k D t T B : est k 0 D t T -> (k <= 15)%nat -> (INR k + 1 / 4) * v * T <= B ->
  0 <= B /\ (B < - D * (1 + v) -> t < 0) /\ (B < D * (1 + v) -> t > 0).
Proof.
intros E K L. apply est_to in E as [O E]. rewrite Rplus_0_r in E. pose proof (power_up k K) as P. pose proof v_small.
assert (T0 : 0 <= T) by (pose proof (Rabs_pos t); lra).
assert (Q : 0 <= (1 + v) * (((1 + v) ^ k - 1) * T) <= B).
{ split; [|apply Rle_trans with (2 := L); rewrite <- Rmult_assoc; now apply Rmult_le_compat_r].
  pose proof (upward v v_small k). apply Rmult_le_pos; [lra|apply Rmult_le_pos; lra]. }
set (q := ((1 + v) ^ k - 1) * T) in *. apply abs_le in E. split; [lra|].
split; intros G; apply Rnot_le_lt; intros N; nra.
Qed.
(* Of whatever is rounded last; the last sum or difference cannot make a sign wrong. *)
Lemma signed_lane j (z b : float) t T : lane j 0 z t T -> (j <= 15)%nat -> finite b -> (INR j + 1 / 4) * v * T <= b ->
  signed z b t.
Proof.
intros [F E] J FB L A. destruct (sign_by _ _ _ _ _ E J L) as (PB & N & P). pose proof v_small.
apply above_true in A as [[FS A]|A]; [|destruct z; discriminate|exact FB]. rewrite size_value in A.
destruct (sign_value z) as [S1 S2]. unfold negative_lane.
split; intros Q; [apply N; specialize (S1 Q); rewrite Rabs_left1 in A by exact S1; nra|
  apply P; specialize (S2 Q); rewrite Rabs_right in A by lra; nra].
Qed.
Lemma signed_plus i j k x y s t S T b : lane i 0 x s S -> lane j 0 y t T -> Nat.max i j = k -> (k <= 15)%nat ->
  finite b -> (INR k + 1 / 4) * v * (S + T) <= value b -> signed (plus x y) b (s + t).
Proof.
intros X Y <- K FB L G. assert (E := est_sum _ _ _ _ _ _ _ _ _ _ (proj2 X) (proj2 Y)). rewrite Rplus_0_l in E.
destruct (sign_by _ _ _ _ _ E K L) as (PB & N & P). destruct (sure_plus _ _ _ (proj1 X) (proj1 Y) PB FB G) as [SN SP].
split; intros Q; auto.
Qed.
Lemma signed_minus i j k x y s t S T b : lane i 0 x s S -> lane j 0 y t T -> Nat.max i j = k -> (k <= 15)%nat ->
  finite b -> (INR k + 1 / 4) * v * (S + T) <= value b -> signed (minus x y) b (s - t).
Proof.
intros X Y <- K FB L G. assert (E := est_difference _ _ _ _ _ _ _ _ _ _ (proj2 X) (proj2 Y)). rewrite Rplus_0_l in E.
destruct (sign_by _ _ _ _ _ E K L) as (PB & N & P). destruct (sure_minus _ _ _ (proj1 X) (proj1 Y) PB FB G) as [SN SP].
split; intros Q; auto.
Qed.
