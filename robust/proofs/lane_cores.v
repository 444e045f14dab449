(* SPDX-License-Identifier: Apache-2.0 *)
(* Cores of round solids in a lane, one guess: what its signs prove. All magnitudes are at most 2^250, so that nothing
   overflows. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model constants steps format floats ghost lanes.
From Filters Require Import lane_bounds lane_filters lane_turns lane_values lane_sums lane_segments lane_boxes.
From Filters Require Import lane_shape_filters lane_faces lane_moderate.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.
#[local] Existing Instances p53 fexp_valid below_1024.

Notation least := (number 1 (-500)).
Notation sixteen := (number 1 (-49)).
Notation some := (bpow radix2 (-510)).
Notation one := (number 1 0).

(* How large numbers are at most. *)
Definition dot3 ax ay az bx by_ bz := plus (plus (times ax bx) (times ay by_)) (times az bz).
Lemma mag_dot3 ax ay az bx by_ bz i j k : mag ax i -> mag ay i -> mag az i -> mag bx j -> mag by_ j -> mag bz j ->
  (i + j = k)%Z -> (-1000 <= k <= 1000)%Z -> mag (dot3 ax ay az bx by_ bz) (k + 2).
Proof.
intros AX AY AZ BX BY BZ E K. replace (k + 2)%Z with (k + 1 + 1)%Z by ring.
apply mag_plus; [apply mag_plus; [|..|lia]|apply mag_more with k; [|lia]|lia]; eapply mag_product; eauto; lia.
Qed.
#[local] Opaque plus minus times multiply_add.
Lemma least_is : finite least /\ value least = 1024 * some.
Proof.
destruct (number_value 1 (-500)) as [F V]; [lia|lia|]. split; [exact F|]. rewrite V, Rmult_1_l.
change 1024 with (bpow radix2 10). rewrite <- bpow_plus. reflexivity.
Qed.
Lemma sixteen_is : finite sixteen /\ value sixteen = 16 * v.
Proof.
destruct (number_value 1 (-49)) as [F V]; [lia|lia|]. split; [exact F|]. rewrite V, Rmult_1_l, v_is. simpl. lra.
Qed.
Lemma one_is : finite one /\ value one = 1. Proof. split; [reflexivity|].
  destruct (number_value 1 0) as [_ ->]; [lia|lia|]. simpl. lra. Qed.
(* 2^-510 is far more than what underflows, even times 2^508. *)
Lemma some_is : 0 < some /\ bpow radix2 520 * eta <= some / 65536 /\ some <= 1.
Proof.
split; [apply bpow_gt_0|]. split.
- unfold eta. pose proof (bpow_le radix2 (520 + -1074) (-510 + -16) ltac:(lia)) as L. rewrite !bpow_plus in L.
  replace (bpow radix2 (-16)) with (/ 65536) in L by reflexivity.
  pose proof (bpow_gt_0 radix2 520). pose proof (bpow_gt_0 radix2 (-1074)).
  assert (0 < bpow radix2 520 * bpow radix2 (-1074)) by now apply Rmult_lt_0_compat. lra.
- change 1 with (bpow radix2 0). apply bpow_le. lia.
Qed.
Lemma eta_some : 65536 * eta <= some.
Proof.
destruct some_is as (P & L & _). pose proof eta_pos. pose proof (bpow_le radix2 16 520 ltac:(lia)) as B.
replace (bpow radix2 16) with 65536 in B by reflexivity. nra.
Qed.

Lemma est_low j A x t : (j <= 3)%nat -> est j A x t t -> least_of 4 A x t.
Proof.
intros J E. assert (P := est_nonneg _ _ _ _ _ E). apply est_to in E as [O E].
  assert (T : 0 <= t) by (pose proof (Rabs_pos t); lra).
pose proof (upward_more v v_small j 3 J). assert (K : (1 - v) ^ 4 + ((1 + v) ^ 3 - 1) <= 1) by (rewrite v_is; simpl;
  lra).
exists ((1 - v) ^ 4 * t). split; [split; [exact T|lra]|]. apply abs_le in E.
assert (((1 + v) ^ j - 1) * t <= ((1 + v) ^ 3 - 1) * t) by (apply Rmult_le_compat_r; lra).
assert (((1 - v) ^ 4 + ((1 + v) ^ 3 - 1)) * t <= 1 * t) by (apply Rmult_le_compat_r; lra). lra.
Qed.

(* Points that are nearer than the reach. *)
Lemma near_says fused (inner square m : float) r2 b2 T : mag inner 500 -> mag square 508 -> mag m 502 -> up m ->
  up inner -> est 3 eta inner r2 r2 -> est 13 (some / 4) square b2 T -> least_of 11 (10 * eta) m T ->
  above (minus inner square) (multiply_add fused (plus m inner) sixteen least) = true -> b2 < r2.
Proof.
intros MI MS MM UM UI EI ES LM A. pose proof (mag_plus _ _ _ MM (mag_more _ _ 502 MI ltac:(lia)) ltac:(lia)) as MP.
change (502 + 1)%Z with 503%Z in MP. destruct some_is as (SP & _ & S1). pose proof eta_some as ES'.
  pose proof eta_pos as EP.
assert (ME : mag (multiply_add fused (plus m inner) sixteen least) 456).
{ apply (mag_multiply_add fused _ _ _ 503 (-48) 455); try lia; [exact MP|apply mag_number; lia|apply mag_number;
  lia]. }
assert (MD : mag (minus inner square) 509).
{ apply (mag_minus _ _ 508); [apply (mag_more _ 500); [exact MI|lia]|exact MS|lia]. }
apply (above_finite _ _ (proj1 MD) (proj1 ME)) in A. destruct (minus_finite _ _ (proj1 MD)) as (_ & _ & V).
destruct sixteen_is as [_ V16]. destruct least_is as [_ VL].
pose proof (multiply_add_least fused _ _ _ (proj1 ME) (up_value _ (up_plus _ _ UM UI)) ltac:(rewrite V16;
  pose proof v_small; lra)
  ltac:(rewrite VL; lra)) as B. rewrite V16, VL in B.
assert (E : est 13 (some / 2) (inner - square) (r2 - b2) (r2 + T)).
{ apply est_more with (i := 13%nat) (A := eta + some / 4); [lia|lra|].
  exact (est_difference 3 13 _ _ _ _ _ _ _ _ EI ES). }
assert (L : least_of 12 (some / 2) (plus m inner) (T + r2)).
{ apply least_more with (i := 12%nat) (A := 2 * (10 * eta + eta)); [lia|lra|].
  apply (low_plus 11 4); try assumption; try lra; [apply MP|]. apply (est_low 3); [lia|exact EI]. }
rewrite V in A. destruct (rnd_difference inner square (held_value _) (held_value _)) as (e & Q & Z). rewrite Z in A.
apply abs_le in Q. pose proof v_small. rewrite (Rplus_comm T) in L.
destruct (beyond_by (some / 2) 13 12 _ _ _ _ _ _ (value (multiply_add fused (plus m inner) sixteen least)) 16 (-49)
  ltac:(lra) E L) as [_ P]; try lra; try lia.
- simpl. lra.
- rewrite v_is. simpl. lra.
- replace (bpow radix2 (-49)) with (16 * v) by (rewrite v_is; simpl; lra). lra.
- enough (r2 - b2 > 0) by lra. apply P.
  assert (0 <= value (multiply_add fused (plus m inner) sixteen least)).
  { assert (0 <= 16 * v * plus m inner); [|nra]. pose proof (up_value _ (up_plus _ _ UM UI)). nra. }
  destruct (Rle_or_lt 0 (inner - square)); nra.
Qed.

(* A direction along which the way leads farther than the edges and the reach. *)
Notation more_than_1 := (number 562949953421313 (-49)).
Lemma more_is : finite more_than_1 /\ value more_than_1 = 1 + 16 * v.
Proof.
destruct (number_value 562949953421313 (-49)) as [F V]; [lia|lia|]. split; [exact F|]. rewrite V, v_is. simpl. lra.
Qed.
Lemma apart_says fused (g m inner square : float) G U r2 b2 : mag g 508 -> mag m 505 -> up m -> mag inner 500 ->
  mag square 508 -> up inner -> up square -> est 3 eta inner r2 r2 -> est 3 (10 * eta) square b2 b2 ->
  est 7 (220 * eta) g G U -> least_of 7 (10 * eta) m U ->
  let gap := minus g (multiply_add fused m sixteen least) in above gap zero = true ->
  above (times gap gap) (multiply_add fused (times inner square) more_than_1 least) = true ->
  0 < G /\ r2 * b2 < G * G.
Proof.
intros MG MM UM MI MS UI US EI ES EG LM gap A0 A. destruct some_is as (SP & BIG & S1). pose proof eta_some as EE.
pose proof eta_pos as EP. destruct sixteen_is as [_ V16]. destruct least_is as [_ VL]. destruct more_is as [_ VM].
assert (ME : mag (multiply_add fused m sixteen least) 458).
{ apply (mag_multiply_add fused _ _ _ 505 (-48) 457); try lia; [exact MM|apply mag_number; lia|apply mag_number;
  lia]. }
assert (MD : mag gap 509).
{ apply (mag_minus _ _ 508); [exact MG|apply (mag_more _ 458); [exact ME|lia]|lia]. }
assert (MDD : mag (times gap gap) 1018) by (eapply mag_product; eauto; lia).
assert (MIS : mag (times inner square) 1008) by (eapply mag_product; eauto; lia).
assert (MR : mag (multiply_add fused (times inner square) more_than_1 least) 1010 \/ True) by now right.
pose proof (above_bound _ _ A) as FR.
assert (UR : up (multiply_add fused (times inner square) more_than_1 least)).
{ apply up_multiply_add; [now apply up_times|apply up_number; lia|apply up_number; lia]. }
specialize (FR UR). clear MR UR. destruct zero_is as [FZ VZ].
apply (above_finite _ _ (proj1 MD) FZ) in A0. apply (above_finite _ _ (proj1 MDD) FR) in A. rewrite VZ in A0.
pose proof v_small as Hv.
pose proof (multiply_add_least fused _ _ _ (proj1 ME) (up_value _ UM) ltac:(rewrite V16; lra) ltac:(rewrite VL;
  lra)) as B.
pose proof (multiply_add_least fused _ _ _ FR (up_value _ (up_times _ _ UI US)) ltac:(rewrite VM; lra)
  ltac:(rewrite VL; lra)) as C. rewrite V16, VL in B. rewrite VM, VL in C.
destruct (minus_finite _ _ (proj1 MD)) as (_ & _ & VD). destruct (times_finite _ _ (proj1 MDD)) as (_ & _ & VDD).
destruct (times_finite _ _ (proj1 MIS)) as (_ & _ & VIS).
destruct (rnd_difference g (value (multiply_add fused m sixteen least)) (held_value _) (held_value _)) as (e & Q & Z).
fold gap in VD. set (err := value (multiply_add fused m sixteen least)) in *.
set (rhs := value (multiply_add fused (times inner square) more_than_1 least)) in *. clearbody err rhs.
(* the gap is no greater than the exact one, but for its last rounding *)
apply est_to in EG as [OG EG]. apply abs_le in EG. destruct LM as (m' & [U0 LM] & LM').
assert (K7 : (1 + v) ^ 7 - 1 <= 8 * v) by (rewrite v_is; simpl; lra).
assert (D7 : 15 * v <= (1 - 3 * v) * (16 * v) * (1 - v) ^ 7) by (rewrite v_is; simpl; lra).
assert (GE : g - err <= G).
{ assert (((1 + v) ^ 7 - 1) * U <= 8 * v * U) by (apply Rmult_le_compat_r; lra).
  assert (Q' : (1 - 3 * v) * (16 * v) * ((1 - v) ^ 7 * U - 10 * eta) <= (1 - 3 * v) * (16 * v) * m).
  { apply Rmult_le_compat_l; [nra|lra]. }
  assert (15 * v * U <= (1 - 3 * v) * (16 * v) * (1 - v) ^ 7 * U) by (apply Rmult_le_compat_r; lra).
  assert ((1 - 3 * v) * (16 * v) * (10 * eta) <= 1 * (10 * eta)) by (apply Rmult_le_compat_r; [lra|nra]).
  assert (0 <= v * U) by (apply Rmult_le_pos; lra). lra. }
rewrite Z in VD. clear Z. fold gap in VD. apply abs_le in Q. set (d := value gap) in *. clearbody d.
match type of VD with d = (?a - ?b) * _ => set (q := a - b) in * end.
assert (GQ : q <= G) by exact GE. clearbody q.
assert (Q0 : 0 < q). { apply Rnot_le_lt. intros N. assert (q * (1 + e) <= 0) by nra. lra. }
assert (DG : d <= G * (1 + v)).
{ rewrite VD. apply Rmult_le_compat; lra. }
assert (G0 : 0 < G) by lra. split; [exact G0|].
(* their squares *)
destruct (rnd_any (d * d)) as (e1 & h1 & B1 & B2 & Z1). rewrite VDD, Z1 in A. apply abs_le in B1, B2.
assert (DD : d * d <= G * G * ((1 + v) * (1 + v))).
{ replace (G * G * ((1 + v) * (1 + v))) with (G * (1 + v) * (G * (1 + v))) by ring. apply Rmult_le_compat; lra. }
assert (DD' : d * d * (1 + e1) <= G * G * (1 + v) ^ 3).
{ replace ((1 + v) ^ 3) with ((1 + v) * (1 + v) * (1 + v)) by ring. rewrite <- Rmult_assoc.
  apply Rmult_le_compat; try lra. nra. }
destruct (rnd_any (inner * square)) as (e2 & h2 & B3 & B4 & Z2). rewrite VIS, Z2 in C. apply abs_le in B3, B4.
assert (PI := up_value _ UI). assert (PS := up_value _ US).
apply (est_low 3) in EI; [|lia]. apply (est_low 3) in ES; [|lia].
destruct EI as (i' & [R0 LI] & LI'). destruct ES as (s' & [S0 LS] & LS').
destruct MI as [_ TI]. destruct MS as [_ TS]. rewrite Rabs_right in TI, TS by lra.
set (I := value inner) in *. set (S := value square) in *. clearbody I S.
assert (LOW : (1 - v) ^ 8 * (r2 * b2) - some / 8 <= I * S).
{ assert (P : (1 - v) ^ 4 * r2 * ((1 - v) ^ 4 * b2) <= (I + eta) * (S + 10 * eta)).
  { pose proof (down v v_small 4). apply Rmult_le_compat; try lra; apply Rmult_le_pos; lra. }
  replace ((1 - v) ^ 8 * (r2 * b2)) with ((1 - v) ^ 4 * r2 * ((1 - v) ^ 4 * b2)) by ring.
  assert (I * eta <= bpow radix2 520 * eta).
  { apply Rmult_le_compat_r; [lra|]. apply Rle_trans with (1 := TI). apply bpow_le. lia. }
  assert (S * eta <= bpow radix2 520 * eta).
  { apply Rmult_le_compat_r; [lra|]. apply Rle_trans with (1 := TS). apply bpow_le. lia. }
  assert (eta * eta <= 1 * eta) by (apply Rmult_le_compat_r; lra). lra. }
assert (LOW' : (1 - v) * (I * S) - eta <= I * S * (1 + e2) + h2).
{ assert (0 <= I * S) by (now apply Rmult_le_pos). assert (I * S * (1 - v) <= I * S * (1 + e2)) by (apply
  Rmult_le_compat_l; lra).
  lra. }
set (X := I * S * (1 + e2) + h2) in *. clearbody X. set (P := r2 * b2) in *.
assert (P0 : 0 <= P) by (now apply Rmult_le_pos). clearbody P.
assert (W : (1 - 3 * v) * ((1 + 16 * v) * ((1 - v) * ((1 - v) ^ 8 * P - some / 8) - eta)) + 1024 * some / 2 <= rhs).
{ apply Rle_trans with (2 := C). apply Rplus_le_compat_r. apply Rmult_le_compat_l; [lra|].
  apply Rmult_le_compat_l; [lra|]. apply Rle_trans with (2 := LOW'). apply Rplus_le_compat_r.
  apply Rmult_le_compat_l; lra. }
assert (K : (1 + v) ^ 3 <= (1 - 3 * v) * ((1 + 16 * v) * ((1 - v) * (1 - v) ^ 8))) by (rewrite v_is; simpl; lra).
apply (Rmult_le_compat_r P) in K; [|exact P0].
assert (SM : (1 - 3 * v) * ((1 + 16 * v) * ((1 - v) * (some / 8) + eta)) <= 2 * (some / 8 + eta)).
{ apply Rle_trans with (1 * (2 * ((1 - v) * (some / 8) + eta))).
  - apply Rmult_le_compat; try lra; [apply Rmult_le_pos; nra|]. apply Rmult_le_compat_r; nra.
  - nra. }
apply Rmult_lt_reg_r with ((1 + v) ^ 3); [apply pow_lt; lra|]. rewrite (Rmult_comm P). lra.
Qed.

(* In space: a displacement that is longer along some direction is longer. *)
Lemma longer bx by_ bz dx dy dz G r2 : 0 < G -> r2 * (bx * bx + by_ * by_ + bz * bz) < G * G ->
  G <= bx * dx + by_ * dy + bz * dz -> r2 < dx * dx + dy * dy + dz * dz.
Proof.
intros P L D. set (b2 := bx * bx + by_ * by_ + bz * bz) in *. set (d2 := dx * dx + dy * dy + dz * dz).
assert (C : (bx * dx + by_ * dy + bz * dz) * (bx * dx + by_ * dy + bz * dz) <= b2 * d2).
{ unfold b2, d2. pose proof (Rle_0_sqr (bx * dy - by_ * dx)). pose proof (Rle_0_sqr (by_ * dz - bz * dy)).
  pose proof (Rle_0_sqr (bz * dx - bx * dz)). unfold Rsqr in *. lra. }
assert (Q : G * G <= (bx * dx + by_ * dy + bz * dz) * (bx * dx + by_ * dy + bz * dz)) by (apply Rmult_le_compat; lra).
apply Rnot_le_lt. intros N. assert (B0 : 0 <= b2) by (unfold b2; nra).
apply (Rmult_le_compat_l b2) in N; [|exact B0]. lra.
Qed.

(* What a guess becomes: a number of the interval, whatever it was. *)
Lemma part_says t (low : float) : finite low -> low <= 1 -> let p := greater_of (lesser t one) low in
  finite p /\ low <= p <= 1.
Proof.
intros F L p. destruct one_is as [F1 V1]. assert (K : p = greater_of one low \/ p = low \/ (finite t)).
{ destruct (finite_case t) as [H|[->|[->| ->]]]; [now right; right|right; left|left|left]; try reflexivity.
  unfold p. replace (lesser (B754_infinity true) one) with (B754_infinity true : float) by reflexivity.
  unfold greater_of. replace (above (B754_infinity true) low) with false; [reflexivity|].
    now destruct low as [|[]| |[]]. }
destruct K as [->|[->|T]].
- destruct (greater_value _ _ F1 F) as [FP VP]. split; [exact FP|]. rewrite VP, V1. rewrite Rmax_left; lra.
- split; [exact F|lra].
- destruct (lesser_value _ _ T F1) as [FL VL]. destruct (greater_value _ _ FL F) as [FP VP].
  split; [exact FP|]. unfold p. rewrite VP, VL, V1. split; [apply Rmax_r|]. apply Rmax_lub; [apply Rmin_r|exact L].
Qed.

(* Where all magnitudes add up to 2^250 at most. *)
Lemma moderate_says (mx my mz reach : float) : up mx -> up my -> up mz ->
  not_below (number 1 250) (plus (plus (plus mx my) mz) reach) && not_below reach (number 1 (-250)) = true ->
  mag mx 250 /\ mag my 250 /\ mag mz 250 /\ mag reach 250 /\ 0 < value reach.
Proof.
intros UX UY UZ [A B]%andb_prop. destruct (number_value 1 250) as [F V]; [lia|lia|]. rewrite Rmult_1_l in V.
destruct (number_value 1 (-250)) as [F' V']; [lia|lia|]. rewrite Rmult_1_l in V'.
assert (UR : up reach).
{ destruct (finite_case reach) as [R|[->|[->| ->]]]; try reflexivity; [|vm_compute in B; discriminate B].
  apply up_finite; [exact R|]. apply (not_below_finite _ _ R F') in B. rewrite V' in B.
  pose proof (bpow_ge_0 radix2 (-250)). lra. }
set (t := plus (plus (plus mx my) mz) reach) in *. assert (UT : up t) by (unfold t; repeat apply up_plus; assumption).
assert (FT : finite t).
{ destruct t as [|[]| |]; try reflexivity; try discriminate UT; vm_compute in A; discriminate A. }
apply (not_below_finite _ _ F FT) in A. rewrite V in A. unfold t in *. clear t UT.
destruct (plus_finite _ _ FT) as (F3 & FR & _). destruct (plus_least _ _ FT) as [L3 LR]; [ups|ups|].
destruct (plus_finite _ _ F3) as (F2 & FZ & _). destruct (plus_least _ _ F3) as [L2 LZ]; [ups|ups|].
destruct (plus_finite _ _ F2) as (FX & FY & _). destruct (plus_least _ _ F2) as [LX LY]; [ups|ups|].
apply (not_below_finite _ _ FR F') in B. rewrite V' in B. pose proof (bpow_gt_0 radix2 (-250)).
pose proof (up_value _ UX). pose proof (up_value _ UY). pose proof (up_value _ UZ).
repeat split; try assumption; try (rewrite Rabs_right; lra). lra.
Qed.

(* Products of a direction that is exact as it was computed. *)
Lemma product_says (bx by_ bz wx wy wz : float) WX WY WZ : mag bx 253 -> mag by_ 253 -> mag bz 253 -> mag wx 250 ->
  mag wy 250 -> mag wz 250 -> near wx WX -> near wy WY -> near wz WZ ->
  mag (dot3 bx by_ bz wx wy wz) 505 /\ est 4 (10 * eta) (dot3 bx by_ bz wx wy wz) (bx * WX + by_ * WY + bz * WZ)
    (Rabs bx * Rabs WX + Rabs by_ * Rabs WY + Rabs bz * Rabs WZ).
Proof.
intros BX BY BZ MX MY MZ [NX _] [NY _] [NZ _].
assert (M : mag (dot3 bx by_ bz wx wy wz) 505) by (apply (mag_dot3 _ _ _ _ _ _ 253 250 503); assumption || lia).
split; [exact M|]. destruct M as [F _]. unfold dot3 in *. destruct (plus_finite _ _ F) as (F1 & F2 & _).
destruct (plus_finite _ _ F1) as (F3 & F4 & _). pose proof eta_pos.
apply est_more with (i := 4%nat) (A := 2 * (2 * (eta + eta) + eta)); [lia|lra|].
apply (of_plus 3 2); [exact F|apply (of_plus 2 2); [exact F1| |]|];
  (apply (of_times 0 1); [assumption|apply of_given|assumption]).
Qed.
Lemma square_says (bx by_ bz : float) : mag bx 253 -> mag by_ 253 -> mag bz 253 ->
  mag (dot3 bx by_ bz bx by_ bz) 508 /\ up (dot3 bx by_ bz bx by_ bz) /\
  est 3 (10 * eta) (dot3 bx by_ bz bx by_ bz) (bx * bx + by_ * by_ + bz * bz) (bx * bx + by_ * by_ + bz * bz).
Proof.
intros BX BY BZ.
assert (M : mag (dot3 bx by_ bz bx by_ bz) 508) by (apply (mag_dot3 _ _ _ _ _ _ 253 253 506); assumption || lia).
split; [exact M|]. split; [unfold dot3; ups|]. destruct M as [F _]. unfold dot3 in *.
  destruct (plus_finite _ _ F) as (F1 & F2 & _).
destruct (plus_finite _ _ F1) as (F3 & F4 & _). pose proof eta_pos.
apply est_more with (i := 3%nat) (A := 2 * (2 * (eta + eta) + eta)); [lia|lra|].
assert (S : forall b : float, finite (times b b) -> est 1 eta (times b b) (b * b) (b * b)).
{ intros b FB. apply est_of_squares with (T := Rabs b * Rabs b); [|now rewrite square_abs].
  apply (of_times 0 0); [exact FB|apply of_given|apply of_given]. }
apply (of_plus 2 1); [exact F|apply (of_plus 1 1); [exact F1| |]|]; now apply S.
Qed.
Lemma most_says (bx by_ bz mx my mz : float) k MX MY MZ : mag bx 253 -> mag by_ 253 -> mag bz 253 -> mag mx 250 ->
  mag my 250 -> mag mz 250 -> up mx -> up my -> up mz -> (k <= 4)%nat ->
  least_of k 0 mx MX -> least_of k 0 my MY -> least_of k 0 mz MZ ->
  mag (dot3 (size bx) (size by_) (size bz) mx my mz) 505 /\ up (dot3 (size bx) (size by_) (size bz) mx my mz) /\
  least_of 7 (10 * eta) (dot3 (size bx) (size by_) (size bz) mx my mz) (Rabs bx * MX + Rabs by_ * MY + Rabs bz * MZ).
Proof.
intros BX BY BZ TX TY TZ UX UY UZ K LX LY LZ. assert (M : mag (dot3 (size bx) (size by_) (size bz) mx my mz) 505).
{ apply (mag_dot3 _ _ _ _ _ _ 253 250 503); try lia; try assumption; now apply mag_size. }
split; [exact M|]. assert (UU : forall b m, up m -> up (times (size b) m)) by (intros; ups).
split; [unfold dot3; ups|]. destruct M as [F _]. unfold dot3 in *. destruct (plus_finite _ _ F) as (F1 & F2 & _).
destruct (plus_finite _ _ F1) as (F3 & F4 & _). pose proof eta_pos.
assert (T : forall b m MM, finite (times (size b) m) -> least_of k 0 (value m) MM ->
  least_of 5 eta (value (times (size b) m)) (Rabs b * MM)).
{ intros b m MM FB L. apply least_more with (i := Datatypes.S (0 + k)) (A := eta); [lia|lra|].
  apply low_times; [exact FB|apply low_of_given|exact L]. }
apply least_more with (i := 7%nat) (A := 2 * (2 * (eta + eta) + eta)); [lia|lra|].
apply (low_plus 6 5); [exact F|ups|ups|lra|lra|apply (low_plus 5 5); [exact F1|ups|ups|lra|lra| |]|]; now apply T.
Qed.

(* The square of the displacement, with its roundings, in units of the magnitudes. *)
Notation bit_more := (bpow radix2 (-1010)).
Lemma displaced_says (bx by_ bz : float) BX BY BZ MX MY MZ : finite (dot3 bx by_ bz bx by_ bz) ->
  est 5 0 bx BX (MX + bit_more) -> est 5 0 by_ BY (MY + bit_more) -> est 5 0 bz BZ (MZ + bit_more) ->
  Rabs BX <= MX <= bpow radix2 252 -> Rabs BY <= MY <= bpow radix2 252 -> Rabs BZ <= MZ <= bpow radix2 252 ->
  est 13 (some / 4) (dot3 bx by_ bz bx by_ bz) (BX * BX + BY * BY + BZ * BZ) (MX * MX + MY * MY + MZ * MZ).
Proof.
intros F EX EY EZ [LX TX] [LY TY] [LZ TZ]. unfold dot3 in *. destruct (plus_finite _ _ F) as (F1 & F2 & _).
destruct (plus_finite _ _ F1) as (F3 & F4 & _). pose proof eta_pos. destruct some_is as (SP & _ & _).
  pose proof eta_some.
pose proof (Rabs_pos BX). pose proof (Rabs_pos BY). pose proof (Rabs_pos BZ).
  pose proof (bpow_gt_0 radix2 (-1010)) as P.
assert (BIG : bpow radix2 252 * bit_more <= some / 65536).
{ pose proof (bpow_le radix2 (252 + -1010) (-510 + -16) ltac:(lia)) as L. rewrite !bpow_plus in L.
  replace (bpow radix2 (-16)) with (/ 65536) in L by reflexivity. lra. }
assert (ONE : bit_more <= 1) by (change 1 with (bpow radix2 0); apply bpow_le; lia).
assert (B252 : 1 <= bpow radix2 252) by (change 1 with (bpow radix2 0); apply bpow_le; lia).
set (b := bit_more) in *. clearbody b. set (c := bpow radix2 252) in *. clearbody c.
assert (sq : forall B M, Rabs B <= M -> Rabs (B * B) <= M * M).
{ intros B M L. rewrite Rabs_mult. apply Rmult_le_compat; auto using Rabs_pos. }
apply est_less with (A := 10 * eta) (D := 2 * b * (MX + MY + MZ) + 3 * (b * b)); [| | | |lia].
- replace (MX * MX + MY * MY + MZ * MZ + (2 * b * (MX + MY + MZ) + 3 * (b * b))) with
    ((MX + b) * (MX + b) + (MY + b) * (MY + b) + (MZ + b) * (MZ + b)) by ring.
  apply est_more with (i := 13%nat) (A := 2 * (2 * (eta + eta) + eta)); [lia|lra|].
  apply (of_plus 12 11); [exact F|apply (of_plus 11 11); [exact F1| |]|]; now apply (of_times 5 5).
- pose proof (sq _ _ LX). pose proof (sq _ _ LY). pose proof (sq _ _ LZ).
  pose proof (Rabs_triang (BX * BX + BY * BY) (BZ * BZ)). pose proof (Rabs_triang (BX * BX) (BY * BY)). lra.
- assert (0 <= b * (MX + MY + MZ)) by (apply Rmult_le_pos; lra). nra.
- assert (b * (MX + MY + MZ) <= b * (3 * c)) by (apply Rmult_le_compat_l; lra).
  assert (b * b <= b * c) by (apply Rmult_le_compat_l; lra). lra.
Qed.
