(* SPDX-License-Identifier: Apache-2.0 *)
(* A ball and a box with any half axes in a lane, whatever is guessed. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import zonotope.
From Filters Require Import model constants steps format floats ghost lanes.
From Filters Require Import lane_bounds lane_filters lane_turns lane_values lane_sums lane_segments lane_boxes.
From Filters Require Import lane_shape_filters lane_faces lane_moderate lane_solid_filters lane_cores.
From Filters Require Import lane_round_solids.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.
#[local] Existing Instances p53 fexp_valid below_1024.
#[local] Opaque plus minus times multiply_add.

Section Three.
Variables (fused : bool) (wx wy wz ex ey ez fx fy fz gx gy gz reach : float).
Variables (WX WY WZ EX EY EZ FX FY FZ GX GY GZ r : R).
Hypotheses (NWX : near wx WX) (NWY : near wy WY) (NWZ : near wz WZ).
Hypotheses (NEX : near ex EX) (NEY : near ey EY) (NEZ : near ez EZ).
Hypotheses (NFX : near fx FX) (NFY : near fy FY) (NFZ : near fz FZ).
Hypotheses (NGX : near gx GX) (NGY : near gy GY) (NGZ : near gz GZ) (NR : near reach r).
Hypothesis OK : lane_cores_3_moderate wx wy wz ex ey ez fx fy fz gx gy gz reach = true.
Definition distance_3 p q s := square_of (WX - p * EX - q * FX - s * GX) (WY - p * EY - q * FY - s * GY)
  (WZ - p * EZ - q * FZ - s * GZ).

Lemma moderate_3 : mag (most_3 wx ex fx gx) 250 /\ mag (most_3 wy ey fy gy) 250 /\ mag (most_3 wz ez fz gz) 250 /\
  mag reach 250 /\ 0 < r.
Proof.
destruct (moderate_says (most_3 wx ex fx gx) (most_3 wy ey fy gy) (most_3 wz ez fz gz) reach) as (A & B & C & D & P).
- apply up_most_3.
- apply up_most_3.
- apply up_most_3.
- exact OK.
- repeat (split; [assumption|]). exact (near_positive _ _ NR P).
Qed.
Lemma cores_3_right t0 t1 t2 :
  let '(nears, aparts) := lane_cores_3 fused wx wy wz ex ey ez fx fy fz gx gy gz reach t0 t1 t2 in
  (nears = true -> exists p q s, Rabs p <= 1 /\ Rabs q <= 1 /\ Rabs s <= 1 /\ distance_3 p q s < r * r) /\
  (aparts = true -> forall p q s, Rabs p <= 1 -> Rabs q <= 1 -> Rabs s <= 1 -> r * r < distance_3 p q s).
Proof.
destruct moderate_3 as (MX & MY & MZ & MR & R0).
assert (low : finite (number (-1) 0) /\ value (number (-1) 0) = -1).
{ destruct (number_value (-1) 0) as [A B]; [lia|lia|]. split; [exact A|]. rewrite B. simpl. ring. }
destruct low as [FL VL].
set (p := greater_of (lesser t0 one) (number (-1) 0)). set (q := greater_of (lesser t1 one) (number (-1) 0)).
set (s := greater_of (lesser t2 one) (number (-1) 0)).
assert (part : forall t, finite (greater_of (lesser t one) (number (-1) 0)) /\
  Rabs (greater_of (lesser t one) (number (-1) 0)) <= 1).
{ intros t. destruct (part_says t (number (-1) 0) FL ltac:(rewrite VL; lra)) as [A B]. split; [exact A|].
  rewrite VL in B. apply Rabs_le. lra. }
destruct (part t0) as [FP LP]. destruct (part t1) as [FQ LQ]. destruct (part t2) as [FS LS]. fold p in FP, LP.
fold q in FQ, LQ. fold s in FS, LS.
destruct (coordinate_3 wx ex fx gx p q s _ _ _ _ NWX NEX NFX NGX MX FP LP FQ LQ FS LS) as (MBX & EBX & LBX).
destruct (coordinate_3 wy ey fy gy p q s _ _ _ _ NWY NEY NFY NGY MY FP LP FQ LQ FS LS) as (MBY & EBY & LBY).
destruct (coordinate_3 wz ez fz gz p q s _ _ _ _ NWZ NEZ NFZ NGZ MZ FP LP FQ LQ FS LS) as (MBZ & EBZ & LBZ).
destruct (most_3_says wx ex fx gx _ _ _ _ NWX NEX NFX NGX MX) as (MWX & MEX & MFX & MGX & LX).
destruct (most_3_says wy ey fy gy _ _ _ _ NWY NEY NFY NGY MY) as (MWY & MEY & MFY & MGY & LY).
destruct (most_3_says wz ez fz gz _ _ _ _ NWZ NEZ NFZ NGZ MZ) as (MWZ & MEZ & MFZ & MGZ & LZ).
destruct (reach_says reach r MR NR) as (MI & UI & EI).
assert (UX := up_most_3 wx ex fx gx). assert (UY := up_most_3 wy ey fy gy). assert (UZ := up_most_3 wz ez fz gz).
destruct (most_square _ _ _ 4 _ _ _ MX MY MZ UX UY UZ ltac:(lia) LX LY LZ) as (MM & UM & LM).
cbv beta zeta delta [lane_cores_3]. fold p q s.
set (bx := minus (minus (minus wx (times p ex)) (times q fx)) (times s gx)) in *.
set (by_ := minus (minus (minus wy (times p ey)) (times q fy)) (times s gy)) in *.
set (bz := minus (minus (minus wz (times p ez)) (times q fz)) (times s gz)) in *.
fold (most_2 wx ex fx) (most_2 wy ey fy) (most_2 wz ez fz).
fold (most_3 wx ex fx gx) (most_3 wy ey fy gy) (most_3 wz ez fz gz).
set (mx := most_3 wx ex fx gx) in *. set (my := most_3 wy ey fy gy) in *. set (mz := most_3 wz ez fz gz) in *.
fold (dot3 mx my mz mx my mz) (dot3 bx by_ bz bx by_ bz) (dot3 bx by_ bz wx wy wz) (dot3 bx by_ bz ex ey ez).
fold (dot3 bx by_ bz fx fy fz) (dot3 bx by_ bz gx gy gz) (dot3 (size bx) (size by_) (size bz) mx my mz).
destruct (square_says bx by_ bz MBX MBY MBZ) as (MQ & UQ & EQ). rewrite !orb_false_l.
split.
- intros A. exists p, q, s. repeat (split; [assumption|]).
  apply (near_says fused (times reach reach) (dot3 bx by_ bz bx by_ bz) (dot3 mx my mz mx my mz) _ _
    (square_of (Rabs WX + Rabs EX + Rabs FX + Rabs GX) (Rabs WY + Rabs EY + Rabs FY + Rabs GY)
      (Rabs WZ + Rabs EZ + Rabs FZ + Rabs GZ))); try assumption.
  exact (displaced_says bx by_ bz _ _ _ _ _ _ (proj1 MQ) EBX EBY EBZ LBX LBY LBZ).
- intros [A A']%andb_prop p' q' s' LP' LQ' LS'. clear EBX EBY EBZ LBX LBY LBZ.
  destruct (product_says bx by_ bz _ _ _ _ _ _ MBX MBY MBZ MWX MWY MWZ NWX NWY NWZ) as [MW EW].
  destruct (product_says bx by_ bz _ _ _ _ _ _ MBX MBY MBZ MEX MEY MEZ NEX NEY NEZ) as [ME EE].
  destruct (product_says bx by_ bz _ _ _ _ _ _ MBX MBY MBZ MFX MFY MFZ NFX NFY NFZ) as [MF EF].
  destruct (product_says bx by_ bz _ _ _ _ _ _ MBX MBY MBZ MGX MGY MGZ NGX NGY NGZ) as [MG EG].
  destruct (most_says bx by_ bz _ _ _ 4 _ _ _ MBX MBY MBZ MX MY MZ UX UY UZ ltac:(lia) LX LY LZ) as (MO & UO & LO).
  clearbody bx by_ bz mx my mz. clear MBX MBY MBZ MM UM LM LX LY LZ.
  apply mag_size in ME, MF, MG. apply of_size in EE, EF, EG.
  set (w := dot3 bx by_ bz wx wy wz) in *. set (e := size (dot3 bx by_ bz ex ey ez)) in *.
  set (f := size (dot3 bx by_ bz fx fy fz)) in *. set (g := size (dot3 bx by_ bz gx gy gz)) in *.
  set (o := dot3 (size bx) (size by_) (size bz) mx my mz) in *. clearbody w e f g o.
  assert (M1 : mag (minus w e) 506) by (apply (mag_minus _ _ 505); assumption || lia).
  assert (M2 : mag (minus (minus w e) f) 507).
  { apply (mag_minus _ _ 506); [exact M1|apply (mag_more _ 505); [exact MF|lia]|lia]. }
  assert (M3 : mag (minus (minus (minus w e) f) g) 508).
  { apply (mag_minus _ _ 507); [exact M2|apply (mag_more _ 505); [exact MG|lia]|lia]. }
  pose proof eta_pos.
  assert (E1 := of_minus 4 4 _ _ _ _ _ _ _ _ (proj1 M1) EW EE).
  assert (E2 := of_minus 5 4 _ _ _ _ _ _ _ _ (proj1 M2) E1 EF).
  assert (E3 := of_minus 6 4 _ _ _ _ _ _ _ _ (proj1 M3) E2 EG).
  apply (est_more _ 7 _ (220 * eta)) in E3; [|cbn; lia|lra].
  apply est_units with (T' := Rabs bx * (Rabs WX + Rabs EX + Rabs FX + Rabs GX) +
    Rabs by_ * (Rabs WY + Rabs EY + Rabs FY + Rabs GY) + Rabs bz * (Rabs WZ + Rabs EZ + Rabs FZ + Rabs GZ)) in E3;
    [|right; ring].
  destruct (apart_says fused _ o _ _ _ _ _ _ M3 MO UO MI MQ UI UQ EI EQ E3 LO A A') as [G0 G1].
  unfold distance_3, square_of. apply (longer bx by_ bz _ _ _ _ _ G0 G1).
  pose proof (from_minus_1 p' (bx * EX + by_ * EY + bz * EZ) LP').
  pose proof (from_minus_1 q' (bx * FX + by_ * FY + bz * FZ) LQ').
  pose proof (from_minus_1 s' (bx * GX + by_ * GY + bz * GZ) LS'). lra.
Qed.
End Three.

(* A displacement that is shorter than the reach, from a point of the box: from one of its interior too. *)
Lemma inside_too WX WY WZ PX PY PZ r2 : square_of (WX - PX) (WY - PY) (WZ - PZ) < r2 ->
  exists l, 0 < l < 1 /\ square_of (WX - l * PX) (WY - l * PY) (WZ - l * PZ) < r2.
Proof.
unfold square_of. set (DX := WX - PX). set (DY := WY - PY). set (DZ := WZ - PZ). intros L.
set (d := DX * DX + DY * DY + DZ * DZ) in *. set (c := DX * PX + DY * PY + DZ * PZ).
set (e := PX * PX + PY * PY + PZ * PZ). assert (E0 : 0 <= e) by (unfold e; nra).
set (K := 2 * Rabs c + e). assert (K0 : 0 <= K) by (unfold K; pose proof (Rabs_pos c); lra).
set (g := r2 - d). assert (G : 0 < g) by (unfold g; lra).
set (s := g / (g + K + 1)). assert (I : 0 < / (g + K + 1)) by (apply Rinv_0_lt_compat; lra).
assert (J : (g + K + 1) * / (g + K + 1) = 1) by (apply Rinv_r; lra).
assert (S : 0 < s < 1 /\ s * K < g).
{ unfold s, Rdiv. set (i := / (g + K + 1)) in *. clearbody i. assert (0 < g * i) by now apply Rmult_lt_0_compat.
  assert (0 <= K * i) by (apply Rmult_le_pos; lra). split; [split; lra|].
  assert (g * i * K = g * (K * i)) by ring. assert (K * i < 1) by lra. nra. }
destruct S as [[S0 S1] S2]. clearbody s. exists (1 - s). split; [lra|].
replace (WX - (1 - s) * PX) with (DX + s * PX) by (unfold DX; ring).
replace (WY - (1 - s) * PY) with (DY + s * PY) by (unfold DY; ring).
replace (WZ - (1 - s) * PZ) with (DZ + s * PZ) by (unfold DZ; ring).
replace ((DX + s * PX) * (DX + s * PX) + (DY + s * PY) * (DY + s * PY) + (DZ + s * PZ) * (DZ + s * PZ)) with
  (d + s * (2 * c + s * e)) by (unfold d, c, e; ring).
assert (2 * c + s * e <= K). { unfold K. pose proof (Rle_abs c).
  assert (s * e <= 1 * e) by (apply Rmult_le_compat_r; lra). lra. }
assert (s * (2 * c + s * e) <= s * K) by (apply Rmult_le_compat_l; lra). unfold g in *. lra.
Qed.

(* Half axes that are certainly independent. *)
Lemma normal_says (a b c d : float) : mag a 250 -> mag b 250 -> mag c 250 -> mag d 250 ->
  mag (minus (times a b) (times c d)) 501 /\
  est 2 0 (minus (times a b) (times c d)) (a * b - c * d) (Rabs a * Rabs b + Rabs c * Rabs d + spare).
Proof.
intros A B C D. assert (MA : mag (times a b) 500) by (eapply mag_product; eauto; lia).
assert (MC : mag (times c d) 500) by (eapply mag_product; eauto; lia).
assert (M : mag (minus (times a b) (times c d)) 501) by (apply (mag_minus _ _ 500); assumption || lia).
split; [exact M|]. pose proof eta_pos. apply est_absorb with (A := 4 * eta); [lia|exact absorbed|].
apply est_more with (i := 2%nat) (A := 2 * (eta + eta)); [lia|lra|].
apply (of_minus 1 1); [apply M| |]; (apply (of_times 0 0); [assumption || apply MA || apply MC|apply of_given|apply
  of_given]).
Qed.
Definition extent_exact ux uy uz := Rabs ux + Rabs uy + Rabs uz.
Lemma extent_says (ux uy uz : float) : mag ux 250 -> mag uy 250 -> mag uz 250 ->
  mag (extent ux uy uz) 252 /\ up (extent ux uy uz) /\ least_of 3 0 (extent ux uy uz) (extent_exact ux uy uz).
Proof.
intros X Y Z. apply mag_size in X, Y, Z. assert (XY := mag_plus _ _ _ X Y ltac:(lia)).
assert (M : mag (extent ux uy uz) 252) by (apply (mag_plus _ _ 251); [exact XY|apply (mag_more _ 250);
  [exact Z|lia]|lia]).
split; [exact M|]. split; [unfold extent; ups|].
apply least_extent; [apply M| | |]; (apply least_more with (3 := low_of_given _); [lia|lra]).
Qed.
Lemma independent_says fused (ux uy uz vx vy vz wx wy wz : float) : mag ux 250 -> mag uy 250 -> mag uz 250 ->
  mag vx 250 -> mag vy 250 -> mag vz 250 -> mag wx 250 -> mag wy 250 -> mag wz 250 ->
  above (size (dot3 (minus (times uy vz) (times uz vy)) (minus (times uz vx) (times ux vz))
    (minus (times ux vy) (times uy vx)) wx wy wz))
    (multiply_add fused (times (times (extent ux uy uz) (extent vx vy vz)) (extent wx wy wz)) sixteen least) = true ->
  volume ux uy uz vx vy vz wx wy wz <> 0.
Proof.
intros UX UY UZ VX VY VZ WX WY WZ A.
destruct (normal_says uy vz uz vy UY VZ UZ VY) as [MX EX]. destruct (normal_says uz vx ux vz UZ VX UX VZ) as [MY EY].
destruct (normal_says ux vy uy vx UX VY UY VX) as [MZ EZ].
destruct (extent_says ux uy uz UX UY UZ) as (MU & UU & LU). destruct (extent_says vx vy vz VX VY VZ) as (MV & UV &
  LV).
destruct (extent_says wx wy wz WX WY WZ) as (MW & UW & LW).
set (nx := minus (times uy vz) (times uz vy)) in *. set (ny := minus (times uz vx) (times ux vz)) in *.
set (nz := minus (times ux vy) (times uy vx)) in *. clearbody nx ny nz.
set (su := extent ux uy uz) in *. set (sv := extent vx vy vz) in *. set (sw := extent wx wy wz) in *.
  clearbody su sv sw.
assert (MD : mag (dot3 nx ny nz wx wy wz) 753) by (apply (mag_dot3 _ _ _ _ _ _ 501 250 751); assumption || lia).
assert (MUV : mag (times su sv) 504) by (eapply mag_product; eauto; lia).
assert (MUVW : mag (times (times su sv) sw) 756) by (eapply mag_product; eauto; lia).
assert (ME : mag (multiply_add fused (times (times su sv) sw) sixteen least) 709).
{ apply (mag_multiply_add fused _ _ _ 756 (-48) 708); try lia; [exact MUVW|apply mag_number; lia|apply mag_number;
  lia]. }
apply (above_finite _ _ (proj1 (mag_size _ _ MD)) (proj1 ME)) in A. rewrite size_value in A.
destruct some_is as (SP & BIG & S1). pose proof eta_some as EE. pose proof eta_pos as EP. pose proof v_small as Hv.
destruct sixteen_is as [_ V16]. destruct least_is as [_ VL].
assert (UM : up (times (times su sv) sw)) by (apply up_times; [now apply up_times|exact UW]).
pose proof (multiply_add_least fused _ _ _ (proj1 ME) (up_value _ UM) ltac:(rewrite V16; lra) ltac:(rewrite VL;
  lra)) as B.
rewrite V16, VL in B. set (err := value (multiply_add fused (times (times su sv) sw) sixteen least)) in *.
  clearbody err.
(* the value *)
assert (E : est 5 (10 * eta) (dot3 nx ny nz wx wy wz)
  ((uy * vz - uz * vy) * wx + (uz * vx - ux * vz) * wy + (ux * vy - uy * vx) * wz)
  ((Rabs uy * Rabs vz + Rabs uz * Rabs vy + spare) * Rabs wx + (Rabs uz * Rabs vx + Rabs ux * Rabs vz + spare) * Rabs
    wy +
   (Rabs ux * Rabs vy + Rabs uy * Rabs vx + spare) * Rabs wz)).
{ destruct MD as [F _]. unfold dot3 in *. destruct (plus_finite _ _ F) as (F1 & F2 & _).
  destruct (plus_finite _ _ F1) as (F3 & F4 & _).
  apply est_more with (i := 5%nat) (A := 2 * (2 * (eta + eta) + eta)); [lia|lra|].
  apply (of_plus 4 3); [exact F|apply (of_plus 3 3); [exact F1| |]|];
    (apply (of_times 2 0); [assumption|assumption|apply of_given]). }
assert (V : volume ux uy uz vx vy vz wx wy wz =
  (uy * vz - uz * vy) * wx + (uz * vx - ux * vz) * wy + (ux * vy - uy * vx) * wz).
{ unfold volume. coordinates. }
rewrite <- V in E.
(* its units, without what pays for underflow in the normal *)
assert (S3 : spare * (Rabs wx + Rabs wy + Rabs wz) <= some / 8).
{ apply Rle_trans with (spare * (3 * bpow radix2 250)).
  - apply Rmult_le_compat_l; [apply bpow_ge_0|]. destruct WX as [_ L1], WY as [_ L2], WZ as [_ L3]. lra.
  - assert (spare * bpow radix2 250 <= some / 1024); [|pose proof (bpow_ge_0 radix2 250); lra].
    rewrite <- bpow_plus. pose proof (bpow_le radix2 (-1010 + 250) (-510 + -10) ltac:(lia)) as L.
    rewrite (bpow_plus radix2 (-510)) in L. replace (bpow radix2 (-10)) with (/ 1024) in L by reflexivity. lra. }
set (T := (Rabs uy * Rabs vz + Rabs uz * Rabs vy) * Rabs wx + (Rabs uz * Rabs vx + Rabs ux * Rabs vz) * Rabs wy +
  (Rabs ux * Rabs vy + Rabs uy * Rabs vx) * Rabs wz).
assert (LT : Rabs (volume ux uy uz vx vy vz wx wy wz) <= T).
{ assert (D : forall a b c d, Rabs (a * b - c * d) <= Rabs a * Rabs b + Rabs c * Rabs d).
  { intros. unfold Rminus. apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_Ropp, !Rabs_mult. lra. }
  rewrite V. apply Rle_trans with (1 := Rabs_triang _ _). unfold T. apply Rplus_le_compat.
  - apply Rle_trans with (1 := Rabs_triang _ _). rewrite !Rabs_mult.
    apply Rplus_le_compat; (apply Rmult_le_compat_r; [apply Rabs_pos|apply D]).
  - rewrite Rabs_mult. apply Rmult_le_compat_r; [apply Rabs_pos|apply D]. }
match type of E with est _ _ _ _ ?t => replace t with (T + spare * (Rabs wx + Rabs wy + Rabs wz)) in E
  by (unfold T; ring) end.
apply est_less with (B := some / 4) (T := T) (D := spare * (Rabs wx + Rabs wy + Rabs wz)) in E; [|exact LT| |lra|lia].
2:{ apply Rmult_le_pos; [apply bpow_ge_0|]. pose proof (Rabs_pos wx). pose proof (Rabs_pos wy).
  pose proof (Rabs_pos wz). lra. }
apply est_units with (T' := extent_exact ux uy uz * extent_exact vx vy vz * extent_exact wx wy wz) in E.
2:{ unfold T, extent_exact.
  assert (P : forall a b c, 0 <= Rabs a * Rabs b * Rabs c) by (intros; repeat apply Rmult_le_pos; apply Rabs_pos).
  pose proof (P ux vx wx). pose proof (P ux vx wy). pose proof (P ux vx wz). pose proof (P ux vy wx).
  pose proof (P ux vy wy). pose proof (P ux vz wx). pose proof (P ux vz wz). pose proof (P uy vx wx).
  pose proof (P uy vx wy). pose proof (P uy vy wx). pose proof (P uy vy wy). pose proof (P uy vy wz).
  pose proof (P uy vz wy). pose proof (P uy vz wz). pose proof (P uz vx wx). pose proof (P uz vx wz).
  pose proof (P uz vy wy). pose proof (P uz vy wz). pose proof (P uz vz wx). pose proof (P uz vz wy).
  pose proof (P uz vz wz). pose proof (P ux vy wz). pose proof (P ux vz wy). pose proof (P uy vx wz).
  pose proof (P uy vz wx). pose proof (P uz vx wy). pose proof (P uz vy wx). lra. }
(* the bound's *)
assert (L : least_of 11 (some / 4) (times (times su sv) sw)
  (extent_exact ux uy uz * extent_exact vx vy vz * extent_exact wx wy wz)).
{ apply exact_least in LU, LV, LW. destruct LU as [U0 LU], LV as [V0 LV], LW as [W0 LW].
  destruct (times_finite _ _ (proj1 MUV)) as (_ & _ & E1). destruct (times_finite _ _ (proj1 MUVW)) as (_ & _ & E2).
  rewrite E2, E1. destruct (rnd_any (su * sv)) as (e & h & B1 & B2 & Q). pose proof (up_value _ UU).
    pose proof (up_value _ UV).
  pose proof (up_value _ UW). pose proof (up_value _ (up_times _ _ UU UV)) as PT. rewrite E1 in PT. rewrite Q in *.
  apply abs_le in B1, B2. set (t := su * sv * (1 + e) + h) in *.
  pose proof (down v v_small 3) as D3. pose proof (down v v_small 7) as D7.
  set (X := extent_exact ux uy uz) in *. set (Y := extent_exact vx vy vz) in *. set (Z := extent_exact wx wy wz) in *.
  assert (P : (1 - v) ^ 7 * (X * Y) <= t + eta).
  { assert (P1 : (1 - v) ^ 3 * X * ((1 - v) ^ 3 * Y) <= su * sv) by (apply Rmult_le_compat; try lra;
    apply Rmult_le_pos; lra).
    assert (P2 : (1 - v) ^ 3 * X * ((1 - v) ^ 3 * Y) * (1 - v) <= su * sv * (1 + e)).
    { apply Rmult_le_compat; try lra. apply Rmult_le_pos; apply Rmult_le_pos; lra. }
    replace ((1 - v) ^ 7 * (X * Y)) with ((1 - v) ^ 3 * X * ((1 - v) ^ 3 * Y) * (1 - v)) by ring. unfold t. lra. }
  clearbody t. destruct (rnd_any (t * sw)) as (e' & h' & B3 & B4 & ->). apply abs_le in B3, B4.
  assert (P3 : (1 - v) ^ 7 * (X * Y) * ((1 - v) ^ 3 * Z) <= (t + eta) * sw).
  { apply Rmult_le_compat; try lra; repeat apply Rmult_le_pos; lra. }
  assert (P4 : t * sw * (1 - v) <= t * sw * (1 + e')) by (apply Rmult_le_compat_l; [now apply Rmult_le_pos|lra]).
  assert (P5 : eta * sw <= some / 65536).
  { apply Rle_trans with (2 := BIG). rewrite Rmult_comm. apply Rmult_le_compat_r; [lra|]. destruct MW as [_ L].
    rewrite Rabs_right in L by lra. apply Rle_trans with (1 := L). apply bpow_le. lia. }
  exists ((1 - v) ^ 11 * (X * Y * Z)). split; [split; [repeat apply Rmult_le_pos; lra|lra]|].
  replace ((1 - v) ^ 11 * (X * Y * Z)) with ((1 - v) ^ 7 * (X * Y) * ((1 - v) ^ 3 * Z) * (1 - v)) by ring.
  assert ((1 - v) ^ 7 * (X * Y) * ((1 - v) ^ 3 * Z) * (1 - v) <= (t + eta) * sw * (1 - v)) by (apply
    Rmult_le_compat_r; lra).
  assert (eta * sw * (1 - v) <= eta * sw * 1) by (apply Rmult_le_compat_l; [apply Rmult_le_pos|]; lra). lra. }
destruct (beyond_by (some / 2) 5 11 _ _ _ _ _ _ err 16 (-49) ltac:(lra) E L) as [SN SP']; try lra; try lia.
- simpl. lra.
- rewrite v_is. simpl. lra.
- replace (bpow radix2 (-49)) with (16 * v) by (rewrite v_is; simpl; lra). lra.
- assert (E0 : 0 <= err). { pose proof (up_value _ UM). assert (0 <= 16 * v * times (times su sv) sw) by (apply
  Rmult_le_pos; lra). nra. }
  set (D := value (dot3 nx ny nz wx wy wz)) in *. destruct (Rle_or_lt 0 D) as [P|P].
  + rewrite Rabs_right in A by lra. enough (volume ux uy uz vx vy vz wx wy wz > 0) by lra. apply SP'. nra.
  + rewrite Rabs_left in A by lra. enough (volume ux uy uz vx vy vz wx wy wz < 0) by lra. apply SN. nra.
Qed.

(* Where it answers, all numbers are finite, the radius is positive, and the half axes are independent; where the ball
   and the box are disjoint, every point of the box is farther than the radius, and where they overlap, one of its
   interior is nearer. *)
Theorem lane_sphere_obb_right fused guesses (cx cy cz r mx my mz ux uy uz vx vy vz wx wy wz : float) :
  let '(known, set) := lane_sphere_obb fused guesses cx cy cz r mx my mz ux uy uz vx vy vz wx wy wz in
  known = true -> Forall finite [cx; cy; cz; r; mx; my; mz; ux; uy; uz; vx; vy; vz; wx; wy; wz] /\ 0 < r /\
  volume ux uy uz vx vy vz wx wy wz <> 0 /\
  (set = true -> forall x y z, in_box at_most_1 mx my mz ux uy uz vx vy vz wx wy wz x y z ->
    (x - cx) * (x - cx) + (y - cy) * (y - cy) + (z - cz) * (z - cz) > r * r) /\
  (set = false -> exists x y z, in_box less_than_1 mx my mz ux uy uz vx vy vz wx wy wz x y z /\
    (x - cx) * (x - cx) + (y - cy) * (y - cy) + (z - cz) * (z - cz) < r * r).
Proof.
cbv beta zeta delta [lane_sphere_obb].
intros [[OK K]%andb_prop A]%andb_prop.
assert (OK' := OK). cbv beta zeta delta [lane_cores_3_moderate] in OK'.
destruct (moderate_says (most_3 (minus cx mx) ux vx wx) (most_3 (minus cy my) uy vy wy) (most_3 (minus cz mz) uz vz
  wz) r
  (up_most_3 _ _ _ _) (up_most_3 _ _ _ _) (up_most_3 _ _ _ _) OK') as (MX & MY & MZ & MR & R0). clear OK'.
assert (parts : forall w e f g, finite (most_3 w e f g) -> finite w).
{ intros w e f g F. unfold most_3, most_2 in F. finites. assumption. }
assert (NX := near_difference _ _ (parts _ _ _ _ (proj1 MX))).
  assert (NY := near_difference _ _ (parts _ _ _ _ (proj1 MY))).
assert (NZ := near_difference _ _ (parts _ _ _ _ (proj1 MZ))). clear parts.
destruct (most_3_says _ _ _ _ _ _ _ _ NX (near_given ux) (near_given vx) (near_given wx) MX) as (MWX & MUX & MVX &
  MWX' & _).
destruct (most_3_says _ _ _ _ _ _ _ _ NY (near_given uy) (near_given vy) (near_given wy) MY) as (MWY & MUY & MVY &
  MWY' & _).
destruct (most_3_says _ _ _ _ _ _ _ _ NZ (near_given uz) (near_given vz) (near_given wz) MZ) as (MWZ & MUZ & MVZ &
  MWZ' & _).
pose proof (cores_3_right fused _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ NX NY NZ (near_given ux)
  (near_given uy)
  (near_given uz) (near_given vx) (near_given vy) (near_given vz) (near_given wx) (near_given wy) (near_given wz)
  (near_given r) OK) as C.
apply (independent_says fused ux uy uz vx vy vz wx wy wz) in A; try assumption.
split.
{ destruct (minus_finite _ _ (proj1 MWX)) as (? & ? & _). destruct (minus_finite _ _ (proj1 MWY)) as (? & ? & _).
  destruct (minus_finite _ _ (proj1 MWZ)) as (? & ? & _).
  repeat constructor; first [assumption | apply MR | apply MUX | apply MUY | apply MUZ | apply MVX | apply MVY
    | apply MVZ | apply MWX' | apply MWY' | apply MWZ']. }
split; [exact R0|]. split; [exact A|]. split; intros S.
- apply existsb_exists in S as ([[t0 t1] t2] & _ & S). specialize (C t0 t1 t2).
  destruct (lane_cores_3 fused _ _ _ _ _ _ _ _ _ _ _ _ _ t0 t1 t2) as [nears aparts]. destruct C as [_ C].
  intros x y z (p & q & s & LP & LQ & LS & X & Y & Z). specialize (C S p q s LP LQ LS).
  unfold distance_3, square_of in C. rewrite X, Y, Z. lra.
- rewrite S, orb_false_r in K. apply existsb_exists in K as ([[t0 t1] t2] & _ & K). specialize (C t0 t1 t2).
  destruct (lane_cores_3 fused _ _ _ _ _ _ _ _ _ _ _ _ _ t0 t1 t2) as [nears aparts]. destruct C as [C _].
  destruct (C K) as (p & q & s & LP & LQ & LS & L). unfold distance_3 in L.
  destruct (inside_too (cx - mx) (cy - my) (cz - mz) (p * ux + q * vx + s * wx) (p * uy + q * vy + s * wy)
    (p * uz + q * vz + s * wz) (r * r)) as (l & L01 & L').
  { apply Rle_lt_trans with (2 := L). right. unfold square_of. ring. }
  exists (mx + l * p * ux + l * q * vx + l * s * wx), (my + l * p * uy + l * q * vy + l * s * wy),
    (mz + l * p * uz + l * q * vz + l * s * wz). split.
  + exists (l * p), (l * q), (l * s).
    assert (T : forall a, Rabs a <= 1 -> less_than_1 (l * a)).
    { intros a LA. unfold less_than_1. rewrite Rabs_mult, (Rabs_right l) by lra. pose proof (Rabs_pos a). nra. }
    repeat (split; [now apply T|]). auto.
  + apply Rle_lt_trans with (2 := L'). right. unfold square_of. ring.
Qed.
