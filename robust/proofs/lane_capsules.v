(* SPDX-License-Identifier: Apache-2.0 *)
(* Two capsules in a lane, whatever is guessed. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model constants steps format floats ghost lanes.
From Filters Require Import lane_bounds lane_filters lane_turns lane_values lane_sums lane_segments lane_boxes.
From Filters Require Import lane_shape_filters lane_faces lane_moderate lane_solid_filters lane_cores.
From Filters Require Import lane_round_solids.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.
#[local] Existing Instances p53 fexp_valid below_1024.
#[local] Opaque plus minus times multiply_add.

Section Two.
Variables (fused : bool) (wx wy wz ex ey ez fx fy fz reach : float).
Variables (WX WY WZ EX EY EZ FX FY FZ r : R).
Hypotheses (NWX : near wx WX) (NWY : near wy WY) (NWZ : near wz WZ).
Hypotheses (NEX : near ex EX) (NEY : near ey EY) (NEZ : near ez EZ).
Hypotheses (NFX : near fx FX) (NFY : near fy FY) (NFZ : near fz FZ) (NR : near reach r).
Hypothesis OK : lane_cores_2_moderate wx wy wz ex ey ez fx fy fz reach = true.
Definition distance_2 p q := square_of (WX - p * EX - q * FX) (WY - p * EY - q * FY) (WZ - p * EZ - q * FZ).

Lemma moderate_2 : mag (most_2 wx ex fx) 250 /\ mag (most_2 wy ey fy) 250 /\ mag (most_2 wz ez fz) 250 /\
  mag reach 250 /\ 0 < r.
Proof.
destruct (moderate_says (most_2 wx ex fx) (most_2 wy ey fy) (most_2 wz ez fz) reach) as (A & B & C & D & P).
- apply up_most_2.
- apply up_most_2.
- apply up_most_2.
- exact OK.
- repeat (split; [assumption|]). exact (near_positive _ _ NR P).
Qed.
Lemma cores_2_right t0 t1 :
  let '(nears, aparts) := lane_cores_2 fused wx wy wz ex ey ez fx fy fz reach t0 t1 in
  (nears = true -> exists p q, 0 <= p <= 1 /\ 0 <= q <= 1 /\ distance_2 p q < r * r) /\
  (aparts = true -> forall p q, 0 <= p <= 1 -> 0 <= q <= 1 -> r * r < distance_2 p q).
Proof.
destruct moderate_2 as (MX & MY & MZ & MR & R0). destruct zero_is as [FL VL].
set (p := greater_of (lesser t0 one) zero). set (q := greater_of (lesser t1 one) zero).
assert (part : forall t, finite (greater_of (lesser t one) zero) /\ 0 <= greater_of (lesser t one) zero <= 1 /\
  Rabs (greater_of (lesser t one) zero) <= 1).
{ intros t. destruct (part_says t zero FL ltac:(rewrite VL; lra)) as [A B]. rewrite VL in B. split; [exact A|].
  split; [exact B|]. apply Rabs_le. lra. }
destruct (part t0) as (FP & IP & LP). destruct (part t1) as (FQ & IQ & LQ). fold p in FP, IP, LP.
  fold q in FQ, IQ, LQ.
destruct (coordinate_2 wx ex fx p q _ _ _ NWX NEX NFX MX FP LP FQ LQ) as (MBX & EBX & LBX).
destruct (coordinate_2 wy ey fy p q _ _ _ NWY NEY NFY MY FP LP FQ LQ) as (MBY & EBY & LBY).
destruct (coordinate_2 wz ez fz p q _ _ _ NWZ NEZ NFZ MZ FP LP FQ LQ) as (MBZ & EBZ & LBZ).
destruct (most_2_says wx ex fx _ _ _ NWX NEX NFX MX) as (MWX & MEX & MFX & LX).
destruct (most_2_says wy ey fy _ _ _ NWY NEY NFY MY) as (MWY & MEY & MFY & LY).
destruct (most_2_says wz ez fz _ _ _ NWZ NEZ NFZ MZ) as (MWZ & MEZ & MFZ & LZ).
destruct (reach_says reach r MR NR) as (MI & UI & EI).
assert (UX := up_most_2 wx ex fx). assert (UY := up_most_2 wy ey fy). assert (UZ := up_most_2 wz ez fz).
destruct (most_square _ _ _ 3 _ _ _ MX MY MZ UX UY UZ ltac:(lia) LX LY LZ) as (MM & UM & LM).
cbv beta zeta delta [lane_cores_2]. fold p q.
set (bx := minus (minus wx (times p ex)) (times q fx)) in *.
set (by_ := minus (minus wy (times p ey)) (times q fy)) in *.
set (bz := minus (minus wz (times p ez)) (times q fz)) in *.
fold (most_2 wx ex fx) (most_2 wy ey fy) (most_2 wz ez fz).
set (mx := most_2 wx ex fx) in *. set (my := most_2 wy ey fy) in *. set (mz := most_2 wz ez fz) in *.
fold (dot3 mx my mz mx my mz) (dot3 bx by_ bz bx by_ bz) (dot3 bx by_ bz wx wy wz) (dot3 bx by_ bz ex ey ez).
fold (dot3 bx by_ bz fx fy fz) (dot3 (size bx) (size by_) (size bz) mx my mz).
destruct (square_says bx by_ bz MBX MBY MBZ) as (MQ & UQ & EQ). rewrite !orb_false_l.
split.
- intros A. exists p, q. repeat (split; [assumption|]).
  apply (near_says fused (times reach reach) (dot3 bx by_ bz bx by_ bz) (dot3 mx my mz mx my mz) _ _
    (square_of (Rabs WX + Rabs EX + Rabs FX) (Rabs WY + Rabs EY + Rabs FY) (Rabs WZ + Rabs EZ + Rabs FZ)));
    try assumption.
  exact (displaced_says bx by_ bz _ _ _ _ _ _ (proj1 MQ) EBX EBY EBZ LBX LBY LBZ).
- intros [A A']%andb_prop p' q' LP' LQ'. clear EBX EBY EBZ LBX LBY LBZ.
  destruct (product_says bx by_ bz _ _ _ _ _ _ MBX MBY MBZ MWX MWY MWZ NWX NWY NWZ) as [MW EW].
  destruct (product_says bx by_ bz _ _ _ _ _ _ MBX MBY MBZ MEX MEY MEZ NEX NEY NEZ) as [ME EE].
  destruct (product_says bx by_ bz _ _ _ _ _ _ MBX MBY MBZ MFX MFY MFZ NFX NFY NFZ) as [MF EF].
  destruct (most_says bx by_ bz _ _ _ 3 _ _ _ MBX MBY MBZ MX MY MZ UX UY UZ ltac:(lia) LX LY LZ) as (MO & UO & LO).
  clearbody bx by_ bz mx my mz. clear MBX MBY MBZ MM UM LM LX LY LZ.
  assert (ahead : forall d t T, mag d 505 -> est 4 (10 * eta) (value d) t T -> mag (greater_of d zero) 505 /\
    est 4 (10 * eta) (value (greater_of d zero)) (Rmax t 0) T).
  { intros d t T [FD LD] E. destruct (greater_value d zero FD FL) as [F V]. rewrite VL in V. rewrite V.
    split; [|now apply farthest_says]. split; [exact F|]. rewrite V. unfold Rmax. destruct Rle_dec; [|exact LD].
    rewrite Rabs_R0. apply bpow_ge_0. }
  apply (ahead _ _ _ ME) in EE. apply (ahead _ _ _ MF) in EF. clear ME MF ahead.
    destruct EE as [ME EE], EF as [MF EF].
  set (w := dot3 bx by_ bz wx wy wz) in *. set (e := greater_of (dot3 bx by_ bz ex ey ez) zero) in *.
  set (f := greater_of (dot3 bx by_ bz fx fy fz) zero) in *.
  set (o := dot3 (size bx) (size by_) (size bz) mx my mz) in *. clearbody w e f o.
  assert (M1 : mag (minus w e) 506) by (apply (mag_minus _ _ 505); assumption || lia).
  assert (M2 : mag (minus (minus w e) f) 507).
  { apply (mag_minus _ _ 506); [exact M1|apply (mag_more _ 505); [exact MF|lia]|lia]. }
  pose proof eta_pos.
  assert (E1 := of_minus 4 4 _ _ _ _ _ _ _ _ (proj1 M1) EW EE).
  assert (E2 := of_minus 5 4 _ _ _ _ _ _ _ _ (proj1 M2) E1 EF).
  apply (est_more _ 7 _ (220 * eta)) in E2; [|cbn; lia|lra].
  apply est_units with (T' := Rabs bx * (Rabs WX + Rabs EX + Rabs FX) +
    Rabs by_ * (Rabs WY + Rabs EY + Rabs FY) + Rabs bz * (Rabs WZ + Rabs EZ + Rabs FZ)) in E2; [|right; ring].
  destruct (apart_says fused _ o _ _ _ _ _ _ (mag_more _ _ 508 M2 ltac:(lia)) MO UO MI MQ UI UQ EI EQ E2 LO A A')
    as [G0 G1].
  unfold distance_2, square_of. apply (longer bx by_ bz _ _ _ _ _ G0 G1).
  pose proof (from_0 p' (bx * EX + by_ * EY + bz * EZ) LP').
  pose proof (from_0 q' (bx * FX + by_ * FY + bz * FZ) LQ'). lra.
Qed.
End Two.

(* The square of the distance of two points, one of each segment. *)
Definition between_axes ax ay az bx by_ bz cx cy cz dx dy dz p q : R := square_of
  (ax + p * (bx - ax) - (cx + q * (dx - cx))) (ay + p * (by_ - ay) - (cy + q * (dy - cy)))
  (az + p * (bz - az) - (cz + q * (dz - cz))).
(* Where it answers, all numbers are finite, and both radii are positive;
  where the capsules are disjoint, no points of
   their axes are as near as the radii together, and where they overlap, some are nearer. *)
Theorem lane_capsule_capsule_right fused guesses (ax ay az bx by_ bz r cx cy cz dx dy dz s : float) :
  let '(known, set) := lane_capsule_capsule fused guesses ax ay az bx by_ bz r cx cy cz dx dy dz s in
  known = true -> Forall finite [ax; ay; az; bx; by_; bz; r; cx; cy; cz; dx; dy; dz; s] /\ 0 < r /\ 0 < s /\
  (set = true -> forall p q, 0 <= p <= 1 -> 0 <= q <= 1 ->
    between_axes ax ay az bx by_ bz cx cy cz dx dy dz p q > (r + s) * (r + s)) /\
  (set = false -> exists p q, 0 <= p <= 1 /\ 0 <= q <= 1 /\
    between_axes ax ay az bx by_ bz cx cy cz dx dy dz p q < (r + s) * (r + s)).
Proof.
cbv beta zeta delta [lane_capsule_capsule].
intros [[OK K]%andb_prop A]%andb_prop.
assert (OK' := OK). cbv beta zeta delta [lane_cores_2_moderate] in OK'.
destruct (moderate_says (most_2 (minus ax cx) (minus ax bx) (minus dx cx)) (most_2 (minus ay cy) (minus ay by_)
  (minus dy cy))
  (most_2 (minus az cz) (minus az bz) (minus dz cz)) (plus r s) (up_most_2 _ _ _) (up_most_2 _ _ _) (up_most_2 _ _ _)
    OK')
  as (MX & MY & MZ & MR & R0). clear OK'.
assert (parts : forall w e f, finite (most_2 w e f) -> finite w /\ finite e /\ finite f).
{ intros w e f F. unfold most_2 in F. finites. auto. }
destruct (parts _ _ _ (proj1 MX)) as (X1 & X2 & X3). destruct (parts _ _ _ (proj1 MY)) as (Y1 & Y2 & Y3).
destruct (parts _ _ _ (proj1 MZ)) as (Z1 & Z2 & Z3). clear parts.
assert (FR := proj1 MR). destruct (plus_finite _ _ FR) as (Fr & Fs & _). destruct zero_is as [FZ VZ].
apply (lesser_above r s) in A; try assumption. rewrite VZ in A. destruct A as [A1 A2].
assert (NR : near (plus r s) (r + s)).
{ split; [now apply of_sum|].
  rewrite (Rabs_right (r + s)) by lra. destruct (low_sum r s FR ltac:(lra) ltac:(lra)) as (x' & L & D).
  exists x'. split; [exact L|]. rewrite size_value, Rabs_right by lra. exact D. }
pose proof (cores_2_right fused _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ (near_difference _ _ X1) (near_difference _ _
  Y1)
  (near_difference _ _ Z1) (near_difference _ _ X2) (near_difference _ _ Y2) (near_difference _ _ Z2)
  (near_difference _ _ X3) (near_difference _ _ Y3) (near_difference _ _ Z3) NR OK) as C.
assert (D : forall p q, distance_2 (ax - cx) (ay - cy) (az - cz) (ax - bx) (ay - by_) (az - bz) (dx - cx) (dy - cy)
  (dz - cz)
  p q = between_axes ax ay az bx by_ bz cx cy cz dx dy dz p q).
{ intros. unfold distance_2, between_axes, square_of. ring. }
split; [finites; repeat constructor; assumption|]. split; [exact A1|]. split; [exact A2|]. split; intros S.
- apply existsb_exists in S as ([t0 t1] & _ & S). specialize (C t0 t1).
  destruct (lane_cores_2 fused _ _ _ _ _ _ _ _ _ _ t0 t1) as [nears aparts]. destruct C as [_ C].
  intros p q LP LQ. specialize (C S p q LP LQ). rewrite D in C. exact C.
- rewrite S, orb_false_r in K. apply existsb_exists in K as ([t0 t1] & _ & K). specialize (C t0 t1).
  destruct (lane_cores_2 fused _ _ _ _ _ _ _ _ _ _ t0 t1) as [nears aparts]. destruct C as [C _].
  destruct (C K) as (p & q & LP & LQ & L). exists p, q. rewrite D in L. auto.
Qed.
