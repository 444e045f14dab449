(* SPDX-License-Identifier: Apache-2.0 *)
(* Two boxes with any half axes in a lane: what the filter computes along one axis, and of the half axes of a box. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import zonotope obb.
From Filters Require Import model constants steps format floats ghost lanes.
From Filters Require Import lane_bounds lane_filters lane_turns lane_values lane_sums lane_segments lane_boxes.
From Filters Require Import lane_shape_filters lane_faces lane_ray_box lane_moderate lane_solid_filters.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.
#[local] Existing Instances p53 fexp_valid below_1024.
#[local] Opaque plus minus times multiply_add.

Definition four (p q r s k : nat) := nth k [p; q; r; s] p.

Section Boxes.
Variables (fused : bool) (x y z : nat -> float) (ax ay az bx by_ bz : float).
Notation sz := (lane_obb_size x y z).
Notation wx := (minus bx ax).
Notation wy := (minus by_ ay).
Notation wz := (minus bz az).
Definition way_size : float := plus (plus (size wx) (size wy)) (size wz).
Definition sum : float := plus (plus (plus (plus (plus (plus way_size (sz 0%nat)) (sz 1%nat)) (sz 2%nat)) (sz 3%nat))
  (sz 4%nat))
  (sz 5%nat).
Definition size_at i := Rabs (x i) + Rabs (y i) + Rabs (z i).
Definition all_sizes := Rabs (bx - ax) + Rabs (by_ - ay) + Rabs (bz - az) + six size_at.
Definition sizes_of e f : float := multiply_add fused (times (sz e) (number 1 8)) (sz f) small.
Definition units e f := size_at e * size_at f + spare.

Lemma up_sz i : up (sz i). Proof. unfold lane_obb_size. ups. Qed.
Lemma up_way : up way_size. Proof. unfold way_size. ups. Qed.
Lemma up_sum : up sum.
Proof. unfold sum. repeat first [apply up_sz|apply up_way|apply up_plus]. Qed.
Lemma size_at_pos i : 0 <= size_at i.
Proof. unfold size_at. pose proof (Rabs_pos (x i)). pose proof (Rabs_pos (y i)). pose proof (Rabs_pos (z i)). lra.
  Qed.
Lemma sum_parts : finite sum -> finite way_size /\ forall i, (i < 6)%nat -> finite (sz i).
Proof.
unfold sum. intros F. destruct (plus_finite _ _ F) as (F5 & S5 & _). destruct (plus_finite _ _ F5) as (F4 & S4 & _).
destruct (plus_finite _ _ F4) as (F3 & S3 & _). destruct (plus_finite _ _ F3) as (F2 & S2 & _).
destruct (plus_finite _ _ F2) as (F1 & S1 & _). destruct (plus_finite _ _ F1) as (F0 & S0 & _).
split; [exact F0|]. intros i I. do 6 (destruct i as [|i]; [assumption|]). lia.
Qed.
Lemma edge_finite i : finite (sz i) -> finite (x i) /\ finite (y i) /\ finite (z i).
Proof. unfold lane_obb_size. intros F. finites. auto. Qed.
Lemma way_finite : finite way_size -> finite wx /\ finite wy /\ finite wz.
Proof. unfold way_size. intros F. finites. auto. Qed.
Lemma sz_least i : finite (sz i) -> least_of 3 0 (sz i) (size_at i).
Proof.
intros F. unfold lane_obb_size, size_at. apply least_extent; [exact F| | |];
  (apply least_more with (3 := low_of_given _); [lia|lra]).
Qed.
Lemma sum_least : finite sum -> least_of 9 0 sum all_sizes.
Proof.
intros F. destruct (sum_parts F) as [W S]. destruct (way_finite W) as (WX & WY & WZ).
assert (more : forall a b A B j, least_of j 0 (value a) A -> (3 <= j)%nat -> least_of 3 0 (value b) B ->
  finite (plus a b) -> up a -> up b -> least_of (Datatypes.S j) 0 (value (plus a b)) (A + B)).
{ intros a b A B j X J Y Q UA UB. apply least_more with (i := Datatypes.S (Nat.max j 3)) (A := 2 * (0 + 0));
  [lia|lra|].
  apply low_plus; auto; lra. }
assert (L : least_of 3 0 way_size (Rabs (bx - ax) + Rabs (by_ - ay) + Rabs (bz - az))).
{ unfold way_size. apply least_extent; [exact W| | |]; now apply low_of_difference. }
unfold sum in *. destruct (plus_finite _ _ F) as (F5 & _). destruct (plus_finite _ _ F5) as (F4 & _).
destruct (plus_finite _ _ F4) as (F3 & _). destruct (plus_finite _ _ F3) as (F2 & _).
destruct (plus_finite _ _ F2) as (F1 & _). pose proof up_way as U. pose proof up_sz as V.
assert (Z := fun i I => sz_least i (S i I)). set (w := way_size) in *. clearbody w. set (s := sz) in *. clearbody s.
pose proof (more _ _ _ _ _ L ltac:(lia) (Z 0%nat ltac:(lia)) F1 U (V _)) as L1.
assert (U1 := up_plus _ _ U (V 0%nat)).
pose proof (more _ _ _ _ _ L1 ltac:(lia) (Z 1%nat ltac:(lia)) F2 U1 (V _)) as L2.
assert (U2 := up_plus _ _ U1 (V 1%nat)).
pose proof (more _ _ _ _ _ L2 ltac:(lia) (Z 2%nat ltac:(lia)) F3 U2 (V _)) as L3.
assert (U3 := up_plus _ _ U2 (V 2%nat)).
pose proof (more _ _ _ _ _ L3 ltac:(lia) (Z 3%nat ltac:(lia)) F4 U3 (V _)) as L4.
assert (U4 := up_plus _ _ U3 (V 3%nat)).
pose proof (more _ _ _ _ _ L4 ltac:(lia) (Z 4%nat ltac:(lia)) F5 U4 (V _)) as L5.
assert (U5 := up_plus _ _ U4 (V 4%nat)).
pose proof (more _ _ _ _ _ L5 ltac:(lia) (Z 5%nat ltac:(lia)) F U5 (V _)) as L6.
replace all_sizes with (Rabs (bx - ax) + Rabs (by_ - ay) + Rabs (bz - az) + size_at 0 + size_at 1 + size_at 2 +
  size_at 3 + size_at 4 + size_at 5) by (unfold all_sizes, six; ring). exact L6.
Qed.

(* What a bound's size is at least, and that products of three are less than can overflow. *)
Lemma sizes_right e f : finite (times (sizes_of e f) sum) -> finite sum /\ units e f <= room /\
  units e f * all_sizes <= room /\ least_of 20 spare (times (sizes_of e f) sum / 256) (units e f * all_sizes).
Proof.
intros F. destruct (times_finite _ _ F) as (F1 & FS & E). assert (F1' := F1). unfold sizes_of in F1'.
destruct (multiply_add_finite _ _ _ _ F1') as (F2 & F3 & _). destruct (times_finite _ _ F2) as (F4 & _ & _).
assert (X := times_exact _ F2). replace (bpow radix2 8) with 256 in X by reflexivity.
pose proof (up_value _ (up_sz e)) as PE. pose proof (up_value _ (up_sz f)) as PF.
pose proof (sz_least e F4) as LE. pose proof (sz_least f F3) as LF. pose proof (sum_least FS) as LS.
apply exact_least in LE, LF, LS. destruct small_is as [_ VS]. pose proof eta_pos. pose proof eta_spare.
assert (ST : 1024 * spare = tiny).
{ change 1024 with (bpow radix2 10). rewrite <- bpow_plus. reflexivity. }
pose proof (multiply_add_least fused _ _ _ F1 ltac:(rewrite X; lra) PF ltac:(rewrite VS; lra)) as L.
fold (sizes_of e f) in L. rewrite X, VS in L.
destruct LE as [E0 LE], LF as [E1 LF], LS as [E2 LS].
pose proof v_small as Hv. pose proof (down v v_small 3) as D3.
assert (D10 : (1 - v) ^ 10 <= (1 - 3 * v) * ((1 - v) ^ 3 * (1 - v) ^ 3)) by (rewrite v_is; simpl; lra).
assert (N0 : 0 <= units e f) by (unfold units; pose proof (bpow_gt_0 radix2 (-1010)); nra).
assert (L10 : (1 - v) ^ 10 * units e f <= sizes_of e f / 256).
{ unfold units. assert (P : (1 - v) ^ 3 * size_at e * ((1 - v) ^ 3 * size_at f) <= sz e * sz f).
  { apply Rmult_le_compat; try assumption; apply Rmult_le_pos; lra. }
  assert (Q : (1 - v) ^ 10 * (size_at e * size_at f) <= (1 - 3 * v) * (sz e * sz f)).
  { apply Rle_trans with ((1 - 3 * v) * ((1 - v) ^ 3 * (1 - v) ^ 3) * (size_at e * size_at f)).
    - apply Rmult_le_compat_r; [now apply Rmult_le_pos|exact D10].
    - rewrite Rmult_assoc. apply Rmult_le_compat_l; [lra|]. lra. }
  pose proof (down v v_small 10) as [_ D]. pose proof (bpow_gt_0 radix2 (-1010)).
  assert ((1 - v) ^ 10 * spare <= 1 * spare) by (apply Rmult_le_compat_r; lra). lra. }
assert (HI : high = 128 * room).
{ change 128 with (bpow radix2 7). rewrite <- bpow_plus. reflexivity. }
assert (top : forall q : float, value q < high).
{ intros q. apply Rle_lt_trans with (1 := Rle_abs _). apply below_high. }
pose proof (top (sizes_of e f)) as T1. pose proof (top (times (sizes_of e f) sum)) as T2.
pose proof room_is. split; [exact FS|].
assert (K10 : 1 / 2 <= (1 - v) ^ 10) by (rewrite v_is; simpl; lra).
assert (K20 : 3 / 4 <= (1 - v) ^ 20) by (rewrite v_is; simpl; lra).
assert (R : (1 - v) ^ 20 * (units e f * all_sizes) - eta <= times (sizes_of e f) sum / 256).
{ rewrite E. destruct (rnd_any (sizes_of e f * sum)) as (d & h & B1 & B2 & ->). apply abs_le in B1, B2.
  assert (P : (1 - v) ^ 10 * units e f * ((1 - v) ^ 9 * all_sizes) <= sizes_of e f / 256 * sum).
  { pose proof (down v v_small 10). pose proof (down v v_small 9). apply Rmult_le_compat; try assumption;
    apply Rmult_le_pos; lra. }
  assert (G : forall a b, a / 256 * b = a * b / 256) by (intros; field). rewrite G in P. clear G.
  set (w := sizes_of e f * sum) in *.
  assert (0 <= (1 - v) ^ 10 * units e f * ((1 - v) ^ 9 * all_sizes)).
  { pose proof (down v v_small 10). pose proof (down v v_small 9). repeat apply Rmult_le_pos; lra. }
  assert (w * (1 - v) <= w * (1 + d)) by (apply Rmult_le_compat_l; lra).
  replace ((1 - v) ^ 20 * (units e f * all_sizes)) with
    ((1 - v) ^ 10 * units e f * ((1 - v) ^ 9 * all_sizes) * (1 - v)) by ring.
  assert ((1 - v) ^ 10 * units e f * ((1 - v) ^ 9 * all_sizes) * (1 - v) <= w / 256 * (1 - v))
    by (apply Rmult_le_compat_r; lra). lra. }
assert (EW : eta <= 1).
{ unfold eta. pose proof (bpow_le radix2 (-1074) 0 ltac:(lia)) as B. simpl (bpow radix2 0) in B. lra. }
split; [|split].
- assert (1 / 2 * units e f <= (1 - v) ^ 10 * units e f) by (apply Rmult_le_compat_r; lra). lra.
- assert (3 / 4 * (units e f * all_sizes) <= (1 - v) ^ 20 * (units e f * all_sizes)).
  { apply Rmult_le_compat_r; [now apply Rmult_le_pos|exact K20]. }
  assert (4 <= room); [|lra]. change 4 with (bpow radix2 2). apply bpow_le. lia.
- exists ((1 - v) ^ 20 * (units e f * all_sizes)). split; [split; [now apply Rmult_le_pos|lra]|lra].
Qed.

(* The normal, and its product with a vector. *)
Definition normal_x e f : float := minus (times (y e) (z f)) (times (z e) (y f)).
Definition normal_y e f : float := minus (times (z e) (x f)) (times (x e) (z f)).
Definition normal_z e f : float := minus (times (x e) (y f)) (times (y e) (x f)).
Definition along e f (dx dy dz : float) : float :=
  plus (plus (times (normal_x e f) dx) (times (normal_y e f) dy)) (times (normal_z e f) dz).
Definition along_exact e f := triple (x e) (y e) (z e) (x f) (y f) (z f).
Lemma coordinate_lane (a b c d : float) N : finite a -> finite b -> finite c -> finite d ->
  Rabs a * Rabs b + Rabs c * Rabs d + spare <= N -> N <= room ->
  lane 2 0 (minus (times a b) (times c d)) (a * b - c * d) N.
Proof.
intros A B C D L R. pose proof (bpow_gt_0 radix2 (-1010)). pose proof eta_pos. pose proof eta_spare.
assert (0 <= Rabs a * Rabs b) by (apply Rmult_le_pos; apply Rabs_pos).
assert (0 <= Rabs c * Rabs d) by (apply Rmult_le_pos; apply Rabs_pos).
assert (EW : eta <= 1).
{ unfold eta. pose proof (bpow_le radix2 (-1074) 0 ltac:(lia)) as Q. simpl (bpow radix2 0) in Q. lra. }
assert (P : lane 1 eta (times a b) (a * b) (Rabs a * Rabs b)).
{ apply (lane_times 0 0); [now apply lane_given..|lia|lia|lra]. }
assert (Q : lane 1 eta (times c d) (c * d) (Rabs c * Rabs d)).
{ apply (lane_times 0 0); [now apply lane_given..|lia|lia|lra]. }
apply lane_units with (2 := L). apply lane_absorbed with (A := 2 * (eta + eta)); [|lia|lra].
apply (lane_minus 1 1 1); auto; try lia; lra.
Qed.
Lemma normal_lane e f : finite (sz e) -> finite (sz f) -> units e f <= room ->
  lane 2 0 (normal_x e f) (y e * z f - z e * y f) (units e f) /\
  lane 2 0 (normal_y e f) (z e * x f - x e * z f) (units e f) /\
  lane 2 0 (normal_z e f) (x e * y f - y e * x f) (units e f).
Proof.
intros E F R. apply edge_finite in E as (X & Y & Z), F as (X' & Y' & Z').
assert (P : forall a b : float, 0 <= Rabs a * Rabs b) by (intros; apply Rmult_le_pos; apply Rabs_pos).
pose proof (P (x e) (x f)). pose proof (P (x e) (y f)). pose proof (P (x e) (z f)).
pose proof (P (y e) (x f)). pose proof (P (y e) (y f)). pose proof (P (y e) (z f)).
pose proof (P (z e) (x f)). pose proof (P (z e) (y f)). pose proof (P (z e) (z f)). clear P.
split; [|split]; apply coordinate_lane; try assumption; unfold units, size_at; lra.
Qed.
Lemma along_lane j e f dx dy dz ux uy uz : finite (sz e) -> finite (sz f) -> units e f <= room ->
  lane j 0 dx ux (Rabs ux) -> lane j 0 dy uy (Rabs uy) -> lane j 0 dz uz (Rabs uz) -> (j <= 1)%nat ->
  units e f * (Rabs ux + Rabs uy + Rabs uz) <= room ->
  lane (5 + j) (10 * eta) (along e f dx dy dz) (along_exact e f ux uy uz) (units e f * (Rabs ux + Rabs uy + Rabs uz)).
Proof.
intros E F R X Y Z J L. destruct (normal_lane e f E F R) as (NX & NY & NZ). pose proof eta_pos. pose proof eta_spare.
assert (EW : 1048576 * eta <= 1).
{ apply Rle_trans with (1 := eta_spare). pose proof (bpow_le radix2 (-1010) 0 ltac:(lia)) as B.
  simpl (bpow radix2 0) in B. lra. }
assert (N0 : 0 <= units e f).
{ unfold units. pose proof (size_at_pos e). pose proof (size_at_pos f). pose proof (bpow_gt_0 radix2 (-1010)). nra. }
set (N := units e f) in *. pose proof (Rmult_le_pos _ _ N0 (Rabs_pos ux)).
  pose proof (Rmult_le_pos _ _ N0 (Rabs_pos uy)).
pose proof (Rmult_le_pos _ _ N0 (Rabs_pos uz)).
assert (TX := lane_times _ _ _ _ _ _ _ _ NX X ltac:(lia) ltac:(lia) ltac:(lra)).
assert (TY := lane_times _ _ _ _ _ _ _ _ NY Y ltac:(lia) ltac:(lia) ltac:(lra)).
assert (TZ := lane_times _ _ _ _ _ _ _ _ NZ Z ltac:(lia) ltac:(lia) ltac:(lra)).
assert (XY := lane_plus _ _ _ _ _ _ _ _ _ _ _ TX TY (Nat.max_id _) ltac:(lia) ltac:(lra) ltac:(lra) ltac:(lra)
  ltac:(lra)).
assert (XYZ := lane_plus _ _ (4 + j) _ _ _ _ _ _ _ _ XY TZ ltac:(lia) ltac:(lia) ltac:(lra) ltac:(lra) ltac:(lra)
  ltac:(lra)).
unfold along, along_exact, triple. fold N. replace (N * (Rabs ux + Rabs uy + Rabs uz)) with
  (N * Rabs ux + N * Rabs uy + N * Rabs uz) by ring.
replace (10 * eta) with (2 * (2 * (eta + eta) + eta)) by ring. exact XYZ.
Qed.

Definition error e f : float := bound fused (-58) (times (sizes_of e f) sum).
Lemma up_sizes e f : up (times (sizes_of e f) sum).
Proof.
pose proof (up_sz e). pose proof (up_sz f). pose proof up_sum. unfold sizes_of. apply up_times; [|assumption].
apply up_multiply_add; [apply up_times; [assumption|apply up_number; lia]|assumption|apply up_number; lia].
Qed.
(* The sign of a value is certain beyond the error: of E, before its last operation. *)
Lemma error_says j D t m B : est j spare D t m -> (j <= 7)%nat -> forall e f, m <= units e f * all_sizes ->
  least_of 20 spare (times (sizes_of e f) sum / 256) (units e f * all_sizes) ->
  (1 - 3 * v) * (bpow radix2 (-58) * times (sizes_of e f) sum) + bpow radix2 (-1001) <= B ->
  (B < - D * (1 + v) -> t < 0) /\ (B < D * (1 + v) -> t > 0).
Proof.
intros E J e f L LO BL. apply est_units with (2 := L) in E. pose proof (bpow_gt_0 radix2 (-1010)).
replace (bpow radix2 (-58) * times (sizes_of e f) sum) with (bpow radix2 (-50) * (times (sizes_of e f) sum / 256)) in
  BL.
2:{ change (-50)%Z with (8 + -58)%Z. rewrite bpow_plus. change (bpow radix2 8) with 256. field. }
apply (beyond_by spare j 20 spare spare D t (units e f * all_sizes) (times (sizes_of e f) sum / 256) B 8 (-50));
  try assumption; try lra; try lia.
- apply Rle_trans with (7 + 1 / 2); [|lra]. apply Rplus_le_compat_r.
  replace 7 with (INR 7) by (simpl; lra). now apply le_INR.
- rewrite v_is. simpl. lra.
- replace (512 * spare) with (bpow radix2 (-1001)); [exact BL|].
  change 512 with (bpow radix2 9). rewrite <- bpow_plus. reflexivity.
Qed.

Definition reach_exact e f k := Rabs (along_exact e f (x k) (y k) (z k)).
Definition gap_exact e f p q r s := Rabs (along_exact e f (bx - ax) (by_ - ay) (bz - az)) -
  (reach_exact e f p + reach_exact e f q + (reach_exact e f r + reach_exact e f s)).
Definition reach_of e f k : float := size (along e f (x k) (y k) (z k)).
Definition gap e f p q r s : float := minus (size (along e f wx wy wz))
  (plus (plus (reach_of e f p) (reach_of e f q)) (plus (reach_of e f r) (reach_of e f s))).

Lemma gap_right e f p q r s : finite sum -> (e < 6)%nat -> (f < 6)%nat -> different (four p q r s) ->
  above (size (gap e f p q r s)) (error e f) = true ->
  (negative_lane (gap e f p q r s) = true -> gap_exact e f p q r s < 0) /\
  (negative_lane (gap e f p q r s) = false -> gap_exact e f p q r s > 0).
Proof.
intros FS IE IF D A. destruct (bound_says _ _ _ _ A (up_sizes e f) ltac:(lia)) as (M & FB & BL).
destruct (sizes_right e f M) as (_ & R1 & R2 & LO). destruct (sum_parts FS) as [FW FE].
destruct (way_finite FW) as (WX & WY & WZ).
assert (I : forall k, (k < 4)%nat -> (four p q r s k < 6)%nat) by apply D.
assert (IP := I 0%nat ltac:(lia)). assert (IQ := I 1%nat ltac:(lia)). assert (IR := I 2%nat ltac:(lia)).
assert (IS := I 3%nat ltac:(lia)). cbn [four nth] in IP, IQ, IR, IS. clear I.
pose proof (four_of_six size_at (four p q r s) size_at_pos D) as Q. cbn [four nth] in Q.
assert (N0 : 0 <= units e f).
{ unfold units. pose proof (size_at_pos e). pose proof (size_at_pos f). pose proof (bpow_gt_0 radix2 (-1010)). nra. }
pose proof (Rmult_le_compat_l _ _ _ N0 Q) as QN. unfold all_sizes in R2, LO.
set (W := Rabs (bx - ax) + Rabs (by_ - ay) + Rabs (bz - az)) in *.
assert (W0 : 0 <= W) by (unfold W; pose proof (Rabs_pos (bx - ax)); pose proof (Rabs_pos (by_ - ay));
  pose proof (Rabs_pos (bz - az)); lra).
pose proof (size_at_pos p) as PP. pose proof (size_at_pos q) as PQ. pose proof (size_at_pos r) as PR.
pose proof (size_at_pos s) as PS. set (N := units e f) in *.
apply (Rmult_le_pos _ _ N0) in W0, PP, PQ, PR, PS. pose proof eta_pos. pose proof eta_spare.
assert (EW : 1048576 * eta <= 1).
{ apply Rle_trans with (1 := eta_spare). pose proof (bpow_le radix2 (-1010) 0 ltac:(lia)) as B.
  simpl (bpow radix2 0) in B. lra. }
assert (AW := along_lane 1 e f _ _ _ _ _ _ (FE e IE) (FE f IF) R1 (lane_difference _ _ WX) (lane_difference _ _ WY)
  (lane_difference _ _ WZ) ltac:(lia) ltac:(fold W N; lra)). fold W N in AW.
assert (AK : forall k, (k < 6)%nat -> N * size_at k <= room ->
  lane 5 (10 * eta) (reach_of e f k) (reach_exact e f k) (N * size_at k)).
{ intros k K L. destruct (edge_finite k (FE k K)) as (X & Y & Z). apply lane_size.
  exact (along_lane 0 e f _ _ _ _ _ _ (FE e IE) (FE f IF) R1 (lane_given _ X) (lane_given _ Y) (lane_given _ Z)
    ltac:(lia) L). }
assert (AP := AK p IP ltac:(lra)). assert (AQ := AK q IQ ltac:(lra)). assert (AR := AK r IR ltac:(lra)).
assert (AS := AK s IS ltac:(lra)). clear AK.
assert (PQ' := lane_plus _ _ 5 _ _ _ _ _ _ _ _ AP AQ eq_refl ltac:(lia) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)).
assert (RS' := lane_plus _ _ 5 _ _ _ _ _ _ _ _ AR AS eq_refl ltac:(lia) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)).
assert (ALL := lane_plus _ _ 6 _ _ _ _ _ _ _ _ PQ' RS' eq_refl ltac:(lia) ltac:(lra) ltac:(lra) ltac:(lra)
  ltac:(lra)).
apply lane_size in AW. destruct AW as [F1 E1]. destruct ALL as [F2 E2].
assert (PB := up_value _ (up_bound fused (-58) _ (up_sizes e f) ltac:(lia))).
fold (error e f) in FB, BL, PB. destruct (sure_minus _ _ (error e f) F1 F2 PB FB A) as [SN SP].
assert (E := est_difference _ _ _ _ _ _ _ _ _ _ E1 E2).
apply (est_more _ 7 _ spare) in E; [|cbn; lia|lra].
destruct (error_says 7 _ _ _ (value (error e f)) E ltac:(lia) e f) as [SN' SP'].
- unfold all_sizes. fold W N. lra.
- unfold all_sizes. fold W N. exact LO.
- exact BL.
- split; intros K; [exact (SN' (SN K))|exact (SP' (SP K))].
Qed.

(* Half axes that are certainly independent. *)
Lemma volume_right k : (k + 2 < 6)%nat -> lane_obb_volume fused x y z sum k = true ->
  finite sum /\ along_exact k (S k) (x (S (S k))) (y (S (S k))) (z (S (S k))) <> 0.
Proof.
intros I A. change (above (size (along k (S k) (x (S (S k))) (y (S (S k))) (z (S (S k))))) (error k (S k)) = true) in
  A.
destruct (bound_says _ _ _ _ A (up_sizes k (S k)) ltac:(lia)) as (M & FB & BL).
destruct (sizes_right k (S k) M) as (FS & R1 & R2 & LO). split; [exact FS|].
destruct (sum_parts FS) as [_ FE]. destruct (edge_finite (S (S k)) (FE (S (S k)) ltac:(lia))) as (X & Y & Z).
assert (N0 : 0 <= units k (S k)).
{ unfold units. pose proof (size_at_pos k). pose proof (size_at_pos (S k)). pose proof (bpow_gt_0 radix2 (-1010)).
  nra. }
assert (L : units k (S k) * size_at (S (S k)) <= units k (S k) * all_sizes).
{ apply Rmult_le_compat_l; [exact N0|]. unfold all_sizes.
  pose proof (one_of_six size_at (S (S k)) size_at_pos ltac:(lia)).
  pose proof (Rabs_pos (bx - ax)). pose proof (Rabs_pos (by_ - ay)). pose proof (Rabs_pos (bz - az)). lra. }
destruct (along_lane 0 k (S k) _ _ _ _ _ _ (FE k ltac:(lia)) (FE (S k) ltac:(lia)) R1 (lane_given _ X) (lane_given _
  Y)
  (lane_given _ Z) ltac:(lia) ltac:(apply Rle_trans with (1 := L); exact R2)) as [F E].
pose proof eta_pos. pose proof eta_spare. apply (est_more _ 7 _ spare) in E; [|lia|lra].
destruct (error_says 7 _ _ _ (value (error k (S k))) E ltac:(lia) k (S k) L LO BL) as [SN SP].
fold (error k (S k)) in FB. assert (FZ := F). assert (FA : finite (size (along k (S k) (x (S (S k))) (y (S (S k)))
  (z (S (S k)))))) by (now destruct (along k (S k) (x (S (S k))) (y (S (S k))) (z (S (S k))))).
apply (above_finite _ _ FA FB) in A. rewrite size_value in A.
assert (PB := up_value _ (up_bound fused (-58) _ (up_sizes k (S k)) ltac:(lia))). fold (error k (S k)) in PB.
set (D := value (along k (S k) _ _ _)) in *. pose proof v_small.
destruct (Rle_or_lt 0 D) as [P|P].
- rewrite Rabs_right in A by lra. enough (along_exact k (S k) (x (S (S k))) (y (S (S k))) (z (S (S k))) > 0) by lra.
  apply SP. nra.
- rewrite Rabs_left in A by lra. enough (along_exact k (S k) (x (S (S k))) (y (S (S k))) (z (S (S k))) < 0) by lra.
  apply SN. nra.
Qed.

End Boxes.
