(* SPDX-License-Identifier: Apache-2.0 *)
(* Round solids in a lane: a ball and a box with any half axes, and two capsules, whatever is guessed. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model constants steps format floats ghost lanes.
From Filters Require Import lane_bounds lane_filters lane_turns lane_values lane_sums lane_segments lane_boxes.
From Filters Require Import lane_shape_filters lane_faces lane_moderate lane_solid_filters lane_cores.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.
#[local] Existing Instances p53 fexp_valid below_1024.
#[local] Opaque plus minus times multiply_add.

Definition square_of x y z : R := x * x + y * y + z * z.

(* One coordinate of the way and of the edges: the magnitudes together. *)
Definition most_2 w e f := plus (plus (size w) (size e)) (size f).
Definition most_3 w e f g := plus (most_2 w e f) (size g).
Lemma up_most_2 w e f : up (most_2 w e f). Proof. unfold most_2. ups. Qed.
Lemma up_most_3 w e f g : up (most_3 w e f g). Proof. unfold most_3, most_2. ups. Qed.
Lemma most_2_says (w e f : float) W E F : near w W -> near e E -> near f F -> mag (most_2 w e f) 250 ->
  mag w 250 /\ mag e 250 /\ mag f 250 /\ least_of 3 0 (most_2 w e f) (Rabs W + Rabs E + Rabs F).
Proof.
intros [_ LW] [_ LE] [_ LF] [M L]. destruct (extent_least w e f M) as (A & B & C). unfold extent in *.
rewrite Rabs_right in L by (apply Rle_ge, up_value, up_most_2). unfold most_2 in *. assert (M' := M). finites.
split; [split; [assumption|lra]|]. split; [split; [assumption|lra]|]. split; [split; [assumption|lra]|].
now apply least_extent.
Qed.
Lemma most_3_says (w e f g : float) W E F G : near w W -> near e E -> near f F -> near g G ->
  mag (most_3 w e f g) 250 ->
  mag w 250 /\ mag e 250 /\ mag f 250 /\ mag g 250 /\
  least_of 4 0 (most_3 w e f g) (Rabs W + Rabs E + Rabs F + Rabs G).
Proof.
intros NW NE NF NG [M L]. assert (UM := up_most_2 w e f). assert (UG := up_size g).
rewrite Rabs_right in L by (apply Rle_ge, up_value, up_most_3). unfold most_3 in *.
destruct (plus_least _ _ M UM UG) as [A B]. destruct (plus_finite _ _ M) as (FM & FG & _). rewrite size_value in B.
assert (M2 : mag (most_2 w e f) 250).
{ split; [exact FM|]. rewrite Rabs_right by (apply Rle_ge, up_value, UM). lra. }
destruct (most_2_says w e f W E F NW NE NF M2) as (MW & ME & MF & LM).
split; [exact MW|]. split; [exact ME|]. split; [exact MF|]. split; [split; [now apply size_finite in FG|lra]|].
apply least_more with (i := 4%nat) (A := 2 * (0 + 0)); [lia|lra|].
apply (low_plus 3 1); [exact M|exact UM|exact UG|lra|lra|exact LM|apply NG].
Qed.
Lemma units_below k m M : (k <= 4)%nat -> least_of k 0 m M -> m <= bpow radix2 250 -> M <= bpow radix2 252.
Proof.
intros K L%exact_least B. destruct L as [P L]. pose proof (down_more v v_small k 4 K).
assert (1 / 2 <= (1 - v) ^ 4) by (rewrite v_is; simpl; lra).
assert (1 / 2 * M <= (1 - v) ^ k * M) by (apply Rmult_le_compat_r; lra).
replace (bpow radix2 252) with (4 * bpow radix2 250); [pose proof (bpow_gt_0 radix2 250); lra|].
change 4 with (bpow radix2 2). rewrite <- bpow_plus. reflexivity.
Qed.

(* A coordinate of the displacement: numbers p, q, r times the edges less. *)
Lemma times_part (p e : float) E : finite p -> Rabs p <= 1 -> mag e 250 -> near e E ->
  mag (times p e) 250 /\ est 2 eta (times p e) (p * E) (Rabs E).
Proof.
intros FP LP ME [NE _]. assert (MP : mag p 0) by (split; [exact FP|exact LP]).
assert (M : mag (times p e) 250) by (eapply mag_product; eauto; lia). split; [exact M|].
apply est_units with (T := Rabs p * Rabs E).
- apply (of_times 0 1); [apply M|apply of_given|exact NE].
- assert (Rabs p * Rabs E <= 1 * Rabs E) by (apply Rmult_le_compat_r; [apply Rabs_pos|exact LP]). lra.
Qed.
Lemma displaced_2 (w e f p q : float) W E F : near w W -> near e E -> near f F -> mag w 250 -> mag e 250 -> mag f 250
  ->
  finite p -> Rabs p <= 1 -> finite q -> Rabs q <= 1 -> let b := minus (minus w (times p e)) (times q f) in
  mag b 252 /\ est 4 (6 * eta) b (W - p * E - q * F) (Rabs W + Rabs E + Rabs F).
Proof.
intros [NW _] NE NF MW ME MF FP LP FQ LQ b. destruct (times_part p e E FP LP ME NE) as [MP EP].
destruct (times_part q f F FQ LQ MF NF) as [MQ EQ].
assert (M1 : mag (minus w (times p e)) 251) by (apply (mag_minus _ _ 250); auto; lia).
assert (M : mag b 252) by (apply (mag_minus _ _ 251); [exact M1|apply (mag_more _ 250); [exact MQ|lia]|lia]).
split; [exact M|]. pose proof eta_pos. apply est_more with (i := 4%nat) (A := 2 * (2 * (0 + eta) + eta)); [lia|lra|].
apply (of_minus 3 2); [apply M|apply (of_minus 1 2); [apply M1|exact NW|exact EP]|exact EQ].
Qed.
Lemma absorbed_14 : 14 * eta <= v * spare.
Proof.
unfold eta, v. pose proof (bpow_gt_0 radix2 (-1074)).
replace (/ 2 * bpow radix2 (-52) * spare) with (/ 2 * bpow radix2 (-1062)).
- assert (16 * bpow radix2 (-1074) <= bpow radix2 (-1062)); [|lra].
  change 16 with (bpow radix2 4). rewrite <- bpow_plus. apply bpow_le. lia.
- change (-1062)%Z with (-52 + -1010)%Z. rewrite bpow_plus. ring.
Qed.
Lemma less_part W p E : Rabs p <= 1 -> Rabs (W - p * E) <= Rabs W + Rabs E.
Proof.
intros L. unfold Rminus. apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_Ropp, Rabs_mult.
assert (Rabs p * Rabs E <= 1 * Rabs E) by (apply Rmult_le_compat_r; [apply Rabs_pos|exact L]). lra.
Qed.
Lemma coordinate_2 (w e f p q : float) W E F : near w W -> near e E -> near f F -> mag (most_2 w e f) 250 ->
  finite p -> Rabs p <= 1 -> finite q -> Rabs q <= 1 -> let b := minus (minus w (times p e)) (times q f) in
  let B := W - p * E - q * F in let M := Rabs W + Rabs E + Rabs F in
  mag b 253 /\ est 5 0 b B (M + spare) /\ Rabs B <= M <= bpow radix2 252.
Proof.
intros NW NE NF MM FP LP FQ LQ b B M. destruct (most_2_says w e f W E F NW NE NF MM) as (MW & ME & MF & LM).
destruct (displaced_2 w e f p q W E F NW NE NF MW ME MF FP LP FQ LQ) as [MB EB]. fold b B M in MB, EB.
split; [apply (mag_more _ 252); [exact MB|lia]|]. pose proof eta_pos. split.
- apply est_absorb with (A := 14 * eta); [lia|exact absorbed_14|]. apply est_more with (3 := EB); [lia|lra].
- split; [unfold B, M; pose proof (less_part (W - p * E) q F LQ); pose proof (less_part W p E LP); lra|].
  apply (units_below 3 _ _ ltac:(lia) LM). destruct MM as [_ L]. pose proof (Rle_abs (most_2 w e f)). lra.
Qed.
Lemma coordinate_3 (w e f g p q r : float) W E F G : near w W -> near e E -> near f F -> near g G ->
  mag (most_3 w e f g) 250 -> finite p -> Rabs p <= 1 -> finite q -> Rabs q <= 1 -> finite r -> Rabs r <= 1 ->
  let b := minus (minus (minus w (times p e)) (times q f)) (times r g) in
  let B := W - p * E - q * F - r * G in let M := Rabs W + Rabs E + Rabs F + Rabs G in
  mag b 253 /\ est 5 0 b B (M + spare) /\ Rabs B <= M <= bpow radix2 252.
Proof.
intros NW NE NF NG MM FP LP FQ LQ FR LR b B M.
destruct (most_3_says w e f g W E F G NW NE NF NG MM) as (MW & ME & MF & MG & LM).
destruct (displaced_2 w e f p q W E F NW NE NF MW ME MF FP LP FQ LQ) as [MB EB].
destruct (times_part r g G FR LR MG NG) as [MR ER].
assert (M3 : mag b 253) by (apply (mag_minus _ _ 252); [exact MB|apply (mag_more _ 250); [exact MR|lia]|lia]).
split; [exact M3|]. pose proof eta_pos. split.
- apply est_absorb with (A := 14 * eta); [lia|exact absorbed_14|].
  apply est_more with (i := 5%nat) (A := 2 * (6 * eta + eta)); [lia|lra|].
  apply (of_minus 4 2); [apply M3|exact EB|exact ER].
- split; [unfold B, M; pose proof (less_part (W - p * E - q * F) r G LR);
    pose proof (less_part (W - p * E) q F LQ); pose proof (less_part W p E LP); lra|].
  apply (units_below 4 _ _ ltac:(lia) LM). destruct MM as [_ L]. pose proof (Rle_abs (most_3 w e f g)). lra.
Qed.

(* The dot products of all magnitudes, and of the reach. *)
Lemma most_square (mx my mz : float) k MX MY MZ : mag mx 250 -> mag my 250 -> mag mz 250 -> up mx -> up my -> up mz ->
  (k <= 4)%nat -> least_of k 0 mx MX -> least_of k 0 my MY -> least_of k 0 mz MZ ->
  mag (dot3 mx my mz mx my mz) 502 /\ up (dot3 mx my mz mx my mz) /\
  least_of 11 (10 * eta) (dot3 mx my mz mx my mz) (square_of MX MY MZ).
Proof.
intros TX TY TZ UX UY UZ K LX LY LZ.
assert (M : mag (dot3 mx my mz mx my mz) 502) by (apply (mag_dot3 _ _ _ _ _ _ 250 250 500); assumption || lia).
split; [exact M|]. split; [unfold dot3; ups|]. destruct M as [F _]. unfold dot3, square_of in *.
destruct (plus_finite _ _ F) as (F1 & F2 & _). destruct (plus_finite _ _ F1) as (F3 & F4 & _). pose proof eta_pos.
assert (T : forall m MM, finite (times m m) -> least_of k 0 (value m) MM ->
  least_of 9 eta (value (times m m)) (MM * MM)).
{ intros m MM FB L. apply least_more with (i := Datatypes.S (k + k)) (A := eta); [lia|lra|]. now apply low_times. }
apply least_more with (i := 11%nat) (A := 2 * (2 * (eta + eta) + eta)); [lia|lra|].
apply (low_plus 10 9); [exact F|ups|ups|lra|lra|apply (low_plus 9 9); [exact F1|ups|ups|lra|lra| |]|]; now apply T.
Qed.
Lemma reach_says (reach : float) r : mag reach 250 -> near reach r ->
  mag (times reach reach) 500 /\ up (times reach reach) /\ est 3 eta (times reach reach) (r * r) (r * r).
Proof.
intros M [N _]. assert (MR : mag (times reach reach) 500) by (eapply mag_product; eauto; lia).
split; [exact MR|]. split; [ups|]. apply est_of_squares with (T := Rabs r * Rabs r); [|now rewrite square_abs].
apply (of_times 1 1); [apply MR|exact N|exact N].
Qed.
Lemma near_positive (x : float) r : near x r -> 0 < x -> 0 < r.
Proof.
intros [E _] P. apply exact_est in E as [_ E]. apply Rnot_le_lt. intros N. rewrite (Rabs_left1 r) in E by exact N.
apply abs_le in E. pose proof v_small. simpl in E. nra.
Qed.

(* The greatest of t times a number, and how far an edge leads along a direction at most. *)
Lemma farthest_says j A x t T : est j A x t T -> est j A (Rmax x 0) (Rmax t 0) T.
Proof.
intros E. assert (P := est_nonneg _ _ _ _ _ E). apply est_to in E as [O E]. apply est_from; [|exact P|].
- apply Rle_trans with (2 := O). unfold Rmax. destruct Rle_dec; [rewrite Rabs_R0; apply Rabs_pos|lra].
- apply Rle_trans with (2 := E). unfold Rmax. destruct (Rle_dec x 0), (Rle_dec t 0); unfold Rabs;
    repeat destruct Rcase_abs; lra.
Qed.
Lemma from_minus_1 p a : Rabs p <= 1 -> p * a <= Rabs a.
Proof.
intros L. apply Rle_trans with (1 := Rle_abs _). rewrite Rabs_mult.
assert (Rabs p * Rabs a <= 1 * Rabs a) by (apply Rmult_le_compat_r; [apply Rabs_pos|exact L]). lra.
Qed.
Lemma from_0 p a : 0 <= p <= 1 -> p * a <= Rmax a 0.
Proof. intros L. unfold Rmax. destruct (Rle_dec a 0); nra. Qed.
