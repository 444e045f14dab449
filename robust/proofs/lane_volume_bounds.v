(* SPDX-License-Identifier: Apache-2.0 *)
(* The bounds of determinants in a lane: finite, and enough for four of them, or for three that have a ray's direction.
   Also what the sizes are that they are made of. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model constants steps format floats ghost lanes.
From Filters Require Import lane_bounds lane_turns lane_values lane_segments lane_faces lane_moderate.
From Filters Require Import lane_triangle_filters lane_volumes.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.
#[local] Existing Instances p53 fexp_valid below_1024.
#[local] Opaque plus minus times multiply_add.

(* x is at least t with k roundings, less d for underflow. *)
Definition floored k d x t := 0 <= x /\ 0 <= t /\ 0 <= d /\ t * (1 - INR k * v) <= x + d.
Lemma floored_self x : 0 <= x -> floored 0 0 x x.
Proof. intros P. repeat split; simpl; lra. Qed.
Lemma floored_more j k d e x t : (j <= k)%nat -> d <= e -> floored j d x t -> floored k e x t.
Proof.
intros K D (X & T & P & L). repeat split; try lra. apply le_INR in K. pose proof v_small.
assert (t * (1 - INR k * v) <= t * (1 - INR j * v)) by (apply Rmult_le_compat_l; nra). lra.
Qed.
Lemma floored_times k d (x y : float) t : finite (times x y) -> floored k d x t -> 0 <= value y -> (k <= 15)%nat ->
  floored (S k) (d * y + eta) (times x y) (t * y).
Proof.
intros (_ & _ & E)%times_finite (X & T & P & L) Y K. pose proof v_small. pose proof eta_pos.
assert (XY : 0 <= x * y) by now apply Rmult_le_pos. assert (TY : 0 <= t * y) by now apply Rmult_le_pos.
assert (DY : 0 <= d * y) by now apply Rmult_le_pos.
assert (IK : 0 <= INR k <= 15) by (split; [apply pos_INR|replace 15 with (INR 15) by (simpl; lra); now apply le_INR]).
rewrite E. split; [now apply rnd_pos|]. split; [exact TY|]. split; [lra|].
destruct (rnd_any (x * y)) as (e & h & B1 & B2 & ->). apply abs_le in B1, B2. rewrite S_INR.
assert (x * y * (1 - v) <= x * y * (1 + e)) by (apply Rmult_le_compat_l; lra).
assert (G : t * y * (1 - INR k * v) <= x * y + d * y).
{ replace (t * y * (1 - INR k * v)) with (t * (1 - INR k * v) * y) by ring.
  replace (x * y + d * y) with ((x + d) * y) by ring. now apply Rmult_le_compat_r. }
assert ((t * y * (1 - INR k * v) - d * y) * (1 - v) <= x * y * (1 - v)) by (apply Rmult_le_compat_r; lra).
assert (0 <= t * y * (INR k * v * v)) by (apply Rmult_le_pos; [exact TY|apply Rmult_le_pos; [apply Rmult_le_pos;
  lra|lra]]).
nra.
Qed.
Lemma floored_plus k d e (x y : float) s t : finite (plus x y) -> floored k d x s -> floored k e y t -> (k <= 15)%nat ->
  floored (S k) (d + e) (plus x y) (s + t).
Proof.
intros (_ & _ & E)%plus_finite (X & S0 & P & L) (Y & T & Q & L') K. pose proof v_small.
assert (IK : 0 <= INR k <= 15) by (split; [apply pos_INR|replace 15 with (INR 15) by (simpl; lra); now apply le_INR]).
rewrite E. split; [apply rnd_pos; lra|]. split; [lra|]. split; [lra|].
destruct (rnd_sum x y (held_value _) (held_value _)) as (r & B & ->). apply abs_le in B. rewrite S_INR.
assert ((x + y) * (1 - v) <= (x + y) * (1 + r)) by (apply Rmult_le_compat_l; lra).
assert (((s + t) * (1 - INR k * v) - (d + e)) * (1 - v) <= (x + y) * (1 - v)) by (apply Rmult_le_compat_r; lra).
assert (0 <= (s + t) * (INR k * v * v)) by (apply Rmult_le_pos; [lra|apply Rmult_le_pos; [apply Rmult_le_pos;
  lra|lra]]).
nra.
Qed.

(* A size that is moderate, and its unit. *)
Definition sized (X : float) := mag X 330 /\ 0 <= value X.
Definition unit_of (X : float) := value X * (1 + 2 * v).
Lemma unit_of_sized X : sized X -> unit (unit_of X).
Proof.
intros [[_ L] P]. rewrite Rabs_right in L by lra. pose proof v_small. unfold unit, unit_of.
replace top with (bpow radix2 330 * 2); [|change 331%Z with (330 + 1)%Z; rewrite bpow_plus; reflexivity].
split; [apply Rmult_le_pos; lra|apply Rmult_le_compat; lra].
Qed.
Lemma paid_is : 65536 * (eta * (top + top + top + 4)) <= paid /\ 65536 * (rest + spare) * v <= paid.
Proof.
assert (T : 4 <= top) by (change 4 with (bpow radix2 2); apply bpow_le; lia).
assert (E : eta * (top + top + top + 4) <= bpow radix2 (-742)).
{ change (-742)%Z with (-1074 + 332)%Z. rewrite bpow_plus. change 332%Z with (1 + 331)%Z. rewrite (bpow_plus radix2 1).
  unfold eta. change (bpow radix2 1) with 2. pose proof (bpow_gt_0 radix2 (-1074)). nra. }
assert (V : (rest + spare) * v <= bpow radix2 (-728)).
{ pose proof (bpow_le radix2 (-1010) (-676) ltac:(lia)). unfold v. change (-728)%Z with (-676 + -52)%Z.
  rewrite bpow_plus.
  pose proof (bpow_gt_0 radix2 (-52)). nra. }
assert (P : paid = 65536 * bpow radix2 (-716)).
{ change 65536 with (bpow radix2 16). rewrite <- bpow_plus. reflexivity. }
rewrite P. pose proof (bpow_le radix2 (-742) (-716) ltac:(lia)). pose proof (bpow_le radix2 (-728) (-716) ltac:(lia)).
lra.
Qed.
(* c v times a size, and what pays for underflow. *)
Lemma bound_least fused (m : float) e c k d t : mag m 1000 -> floored k d m t -> (k <= 8)%nat ->
  d <= eta * (top + top + top + 4) -> bpow radix2 e = c * v -> 1 <= c <= 256 -> (-60 <= e <= 0)%Z ->
  let b := multiply_add fused m (number 1 e) (number 1 (-700)) in
  finite b /\ (c - 1 / 4) * v * t + paid / 4 <= value b.
Proof.
intros M (MP & T & _ & L) K D C LC LE b. pose proof v_small. pose proof eta_pos.
destruct (number_value 1 e) as [_ V1]; [lia|lia|]. destruct (number_value 1 (-700)) as [_ V2]; [lia|lia|].
rewrite Rmult_1_l in V1, V2. assert (F : mag b (1000 + 1)).
{ apply (mag_multiply_add fused _ _ _ 1000 0 1000); try lia; [exact M|apply mag_number; lia|apply mag_number; lia]. }
split; [apply F|]. assert (P : 16 * eta <= paid).
{ destruct paid_is as [P _]. assert (4 * eta <= eta * (top + top + top + 4)) by (pose proof (bpow_gt_0 radix2 331);
    nra). lra. }
pose proof (multiply_add_least fused m _ _ (proj1 F) MP ltac:(rewrite V1; apply bpow_ge_0) ltac:(rewrite V2;
  exact P)) as G.
rewrite V1, V2, C in G. fold b in G. destruct paid_is as [PD _].
assert (IK : 0 <= INR k <= 8) by (split; [apply pos_INR|replace 8 with (INR 8) by (simpl; lra); now apply le_INR]).
assert (T8 : t * (1 - 8 * v) - d <= m).
{ assert (t * (1 - 8 * v) <= t * (1 - INR k * v)) by (apply Rmult_le_compat_l; nra). lra. }
assert (CV : 0 <= (1 - 3 * v) * (c * v) <= 1) by (rewrite v_is; nra).
assert (Q : (1 - 3 * v) * (c * v) * (t * (1 - 8 * v) - d) <= (1 - 3 * v) * (c * v) * m) by (apply Rmult_le_compat_l;
  lra).
assert (D0 : (1 - 3 * v) * (c * v) * d <= 1 * paid / 65536).
{ destruct (Rle_or_lt 0 d) as [N|N]; [|pose proof (bpow_gt_0 radix2 (-700)); nra].
  assert ((1 - 3 * v) * (c * v) * d <= 1 * d) by (apply Rmult_le_compat_r; lra). lra. }
assert (R : (c - 1 / 4) * v * t <= (1 - 3 * v) * (c * v) * (t * (1 - 8 * v))).
{ assert ((c - 1 / 4) <= (1 - 3 * v) * c * (1 - 8 * v)) by (rewrite v_is; nra).
  assert (0 <= v * t) by (apply Rmult_le_pos; lra). nra. }
pose proof (bpow_gt_0 radix2 (-700)). lra.
Qed.

(* The greatest of magnitudes that are not NaN. *)
Definition magnitude (m : float) := is_nan m = false /\ up m.
Definition largest (m : float) l := magnitude m /\ (finite m -> Forall (fun x : float => finite x /\ Rabs x <= m) l).
Lemma magnitude_greater a b : magnitude a -> magnitude b -> magnitude (greater_of a b).
Proof. intros A B. unfold greater_of. now destruct (above a b). Qed.
Lemma greater_parts a b : magnitude a -> magnitude b -> finite (greater_of a b) ->
  finite a /\ finite b /\ a <= greater_of a b /\ b <= greater_of a b.
Proof.
intros [NA UA] [NB UB]. unfold greater_of. destruct (above a b) eqn:A; intros F.
- assert (FB : finite b) by exact (above_bound _ _ A UB). apply (above_finite _ _ F FB) in A.
  repeat split; try assumption; lra.
- assert (FA : finite a).
  { destruct (finite_case a) as [E|[->|[->| ->]]]; [exact E|discriminate UA| |discriminate NA].
    exfalso. destruct b as [|[]| |]; try discriminate F; discriminate A. }
  assert (~ value b < value a) by (rewrite <- (above_finite _ _ FA F), A; discriminate).
  repeat split; try assumption; lra.
Qed.
Lemma largest_size x : known x -> largest (size x) [x].
Proof.
intros K. split; [split; [now destruct x|apply up_size]|]. intros F. apply size_finite in F as [F E].
constructor; [|constructor]. rewrite E. split; [exact F|apply Rle_refl].
Qed.
Lemma largest_greater a b k l : largest a k -> largest b l -> largest (greater_of a b) (k ++ l).
Proof.
intros [A LA] [B LB]. split; [now apply magnitude_greater|]. intros F.
destruct (greater_parts a b A B F) as (FA & FB & P & Q). apply Forall_app.
split; [apply Forall_impl with (2 := LA FA)|apply Forall_impl with (2 := LB FB)]; intros x [X L]; (split;
  [exact X|lra]).
Qed.
Lemma sized_parts a b : magnitude a -> magnitude b -> sized (greater_of a b) -> sized a /\ sized b.
Proof.
intros A B [[F L] P]. destruct (greater_parts a b A B F) as (FA & FB & LA & LB). destruct A as [_ A], B as [_ B].
apply up_value in A, B. rewrite Rabs_right in L by lra.
repeat split; try assumption; rewrite Rabs_right; lra.
Qed.
Lemma moderate_says X Y Z : magnitude X -> magnitude Y -> magnitude Z -> lane_moderate X Y Z = true ->
  sized X /\ sized Y /\ sized Z.
Proof.
intros MX MY MZ M. unfold lane_moderate in M. assert (MG := magnitude_greater _ _ MX MY).
assert (MH := magnitude_greater _ _ MG MZ). set (g := greater_of X Y) in *.
assert (S : sized (greater_of g Z)).
{ set (h := greater_of g Z) in *. destruct (number_value 1 330) as [F V]; [lia|lia|]. rewrite Rmult_1_l in V.
  destruct MH as [N U]. assert (FH : finite h).
  { destruct (finite_case h) as [E|[E|[E|E]]]; [exact E|rewrite E in *; discriminate..]. }
  apply (above_finite _ _ F FH) in M. rewrite V in M. apply up_value in U.
  split; [split; [exact FH|rewrite Rabs_right; lra]|exact U]. }
destruct (sized_parts _ _ MG MZ S) as [SG SZ]. destruct (sized_parts _ _ MX MY SG). now split.
Qed.
Definition units X Y Z := (unit_of X, unit_of Y, unit_of Z).
Lemma units_three X Y Z : sized X -> sized Y -> sized Z -> three (unit_of X) (unit_of Y) (unit_of Z).
Proof. repeat split; apply unit_of_sized; assumption. Qed.

(* The bound of four determinants. *)
Lemma volume_bound fused X Y Z : sized X -> sized Y -> sized Z ->
  let U := units X Y Z in let b := lane_bound_of fused X Y Z in
  finite b /\ 42 * v * total U U U + paid / 4 <= b.
Proof.
intros SX SY SZ U b. destruct SX as [MX PX], SY as [MY PY], SZ as [MZ PZ].
assert (M1 : mag (times X Y) 660) by (apply (mag_product _ _ 330 330); auto; lia).
assert (M2 : mag (times (times X Y) Z) 990) by (apply (mag_product _ _ 660 330); auto; lia).
assert (F1 := floored_times _ _ _ _ _ (proj1 M1) (floored_self _ PX) PY ltac:(lia)).
assert (F2 := floored_times _ _ _ _ _ (proj1 M2) F1 PZ ltac:(lia)).
assert (LZ : value Z <= top).
{ destruct MZ as [_ L]. rewrite Rabs_right in L by lra. apply Rle_trans with (1 := L). apply bpow_le. lia. }
pose proof eta_pos. pose proof (bpow_gt_0 radix2 331) as T0.
destruct (bound_least fused _ (-45) 256 _ _ _ (mag_more _ _ 1000 M2 ltac:(lia)) F2 ltac:(lia)) as [F L]; try lia;
  try lra.
- rewrite Rmult_0_l, Rplus_0_l. assert (eta * Z <= eta * top) by (apply Rmult_le_compat_l; lra). nra.
- rewrite v_is. simpl. lra.
- split; [exact F|]. change (value b) with (value (multiply_add fused (times (times X Y) Z) (number 1 (-45))
    (number 1 (-700)))).
  unfold U, units, total. set (W := value X * value Y * value Z) in *.
  assert (0 <= W) by (unfold W; apply Rmult_le_pos; [now apply Rmult_le_pos|assumption]).
  replace ((unit_of Y * unit_of Z + unit_of Z * unit_of Y)
    * unit_of X + (unit_of Z * unit_of X + unit_of X * unit_of Z) * unit_of Y +
    (unit_of X * unit_of Y + unit_of Y * unit_of X) * unit_of Z) with (6 * ((1 + 2 * v) ^ 3) * W) by (unfold unit_of,
      W; ring).
  assert (Q : 42 * 6 * (1 + 2 * v) ^ 3 <= 256 - 1 / 4) by (rewrite v_is; simpl; lra).
  pose proof v_small. assert (0 <= v * W) by (apply Rmult_le_pos; lra).
  replace (42 * v * (6 * (1 + 2 * v) ^ 3 * W)) with (42 * 6 * (1 + 2 * v) ^ 3 * (v * W)) by ring.
  replace ((256 - 1 / 4) * v * W) with ((256 - 1 / 4) * (v * W)) in L by ring. nra.
Qed.
(* The bound of three that have a direction of another size. *)
Lemma ray_bound fused dx dy dz X Y Z : sized dx -> sized dy -> sized dz -> sized X -> sized Y -> sized Z ->
  let U := units X Y Z in let W := units dx dy dz in
  let b := multiply_add fused (plus (times dx (times Y Z)) (times (plus (times dy Z) (times dz Y)) X)) (number 1 (-47))
    (number 1 (-700)) in
  finite b /\ 31 * v * total W U U + paid / 4 <= value b /\ total U U W = total W U U.
Proof.
intros [MP PP] [MQ PQ] [MR PR] [MX PX] [MY PY] [MZ PZ] U W b.
assert (M1 : mag (times Y Z) 660) by (apply (mag_product _ _ 330 330); auto; lia).
assert (M2 : mag (times dx (times Y Z)) 990) by (apply (mag_product _ _ 330 660); auto; lia).
assert (M3 : mag (times dy Z) 660) by (apply (mag_product _ _ 330 330); auto; lia).
assert (M4 : mag (times dz Y) 660) by (apply (mag_product _ _ 330 330); auto; lia).
assert (M5 := mag_plus _ _ _ M3 M4 ltac:(lia)). change (660 + 1)%Z with 661%Z in M5.
assert (M6 : mag (times (plus (times dy Z) (times dz Y)) X) 991) by (apply (mag_product _ _ 661 330); auto; lia).
assert (M7 := mag_plus _ _ _ (mag_more _ _ 991 M2 ltac:(lia)) M6 ltac:(lia)).
assert (F1 := floored_times _ _ _ _ _ (proj1 M1) (floored_self _ PY) PZ ltac:(lia)).
assert (F2 : floored 2 (eta * dx + eta) (times dx (times Y Z)) (dx * (Y * Z))).
{ assert (C : value (times dx (times Y Z)) = value (times (times Y Z) dx)).
  { destruct (times_finite _ _ (proj1 M2)) as (_ & _ & ->).
    assert (M : mag (times (times Y Z) dx) 990) by (apply (mag_product _ _ 660 330); auto; lia).
    destruct (times_finite _ _ (proj1 M)) as (_ & _ & ->). f_equal. ring. }
  assert (M : mag (times (times Y Z) dx) 990) by (apply (mag_product _ _ 660 330); auto; lia).
  assert (K := floored_times _ _ _ _ _ (proj1 M) F1 PP ltac:(lia)). rewrite <- C in K.
  rewrite Rmult_0_l, Rplus_0_l in K. now rewrite (Rmult_comm (value dx) (Y * Z)). }
assert (F3 := floored_times _ _ _ _ _ (proj1 M3) (floored_self _ PQ) PZ ltac:(lia)).
assert (F4 := floored_times _ _ _ _ _ (proj1 M4) (floored_self _ PR) PY ltac:(lia)).
assert (F5 := floored_plus _ _ _ _ _ _ _ (proj1 M5) F3 F4 ltac:(lia)).
assert (F6 := floored_times _ _ _ _ _ (proj1 M6) F5 PX ltac:(lia)). pose proof eta_pos.
assert (F7 := floored_plus _ _ _ _ _ _ _ (proj1 M7) (floored_more 2 3 _ _ _ _ ltac:(lia) (Rle_refl _) F2)
  F6 ltac:(lia)).
pose proof (bpow_gt_0 radix2 331) as T0.
assert (LT : forall x : float, mag x 330 -> 0 <= value x -> value x <= top).
{ intros x [_ L] N. rewrite Rabs_right in L by lra. apply Rle_trans with (1 := L). apply bpow_le. lia. }
apply LT in PX as LX; [|exact MX]. apply LT in PP as LP; [|exact MP]. apply LT in PZ as LZ; [|exact MZ].
apply LT in PY as LY; [|exact MY].
destruct (bound_least fused _ (-47) 64 _ _ _ (mag_more _ _ 1000 M7 ltac:(lia)) F7 ltac:(lia)) as [F L]; try lia;
  try lra.
- assert (eta * dx <= eta * top) by (apply Rmult_le_compat_l; lra).
  assert (eta * X <= eta * top) by (apply Rmult_le_compat_l; lra). rewrite !Rmult_0_l, !Rplus_0_l. lra.
- rewrite v_is. simpl. lra.
- split; [exact F|]. split; [|unfold U, W, units, total; ring]. fold b in L.
  set (S0 := value dx * (value Y * value Z) + (value dy * value Z + value dz * value Y) * value X) in *.
  assert (0 <= S0).
  { unfold S0. repeat (apply Rplus_le_le_0_compat || apply Rmult_le_pos); assumption. }
  replace (total W U U) with (2 * ((1 + 2 * v) ^ 3) * S0) by (unfold U, W, units, total, unit_of, S0; ring).
  assert (K : 31 * 2 * (1 + 2 * v) ^ 3 <= 64 - 1 / 4) by (rewrite v_is; simpl; lra).
  pose proof v_small. assert (0 <= v * S0) by (apply Rmult_le_pos; lra).
  replace (31 * v * (2 * (1 + 2 * v) ^ 3 * S0)) with (31 * 2 * (1 + 2 * v) ^ 3 * (v * S0)) by ring.
  replace ((64 - 1 / 4) * v * S0) with ((64 - 1 / 4) * (v * S0)) in L by ring. nra.
Qed.
