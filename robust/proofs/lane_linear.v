(* SPDX-License-Identifier: Apache-2.0 *)
(* Linear functions of a point in a box: what an edge's line and a face's plane have in common. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool List.
From Flocq Require Import Core Mult_error IEEE754.BinarySingleNaN.
From Filters Require Import model constants steps format floats ghost lanes.
From Filters Require Import lane_bounds lane_turns lane_values lane_sums lane_faces lane_beside.
From Filters Require Import lane_shape_filters lane_linear_filters.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.
#[local] Existing Instances p53 fexp_valid below_1024.

(* Beyond neither end, as comparisons find; and then in fact. *)
Definition in_box (o m x : float) := above o x = false /\ above x m = false.
Definition between (o m x : float) := finite x /\ o <= x <= m.
Lemma in_box_between o m x : finite o -> finite m -> in_box o m x -> known x -> between o m x.
Proof.
intros O M [A B] K. destruct (finite_case x) as [F|[->|[->| ->]]].
- split; [exact F|].
  split; apply Rnot_lt_le; intros L; [apply (above_finite o x O F) in L|apply (above_finite x m F M) in L]; congruence.
- now destruct o as [| | |[]].
- now destruct m as [| | |[]].
- discriminate K.
Qed.

(* c stands for r, of a magnitude of E at most, M is E as computed. *)
Definition spans (c : float) r (M : float) E := finite c /\ Rabs c <= M /\ est 1 0 c r E.
Lemma displaced o m x y : finite (minus m o) -> between o m x -> between o m y ->
  spans (minus x y) (x - y) (minus m o) (m - o).
Proof.
intros F (X & LX) (Y & LY). destruct (minus_finite _ _ F) as (M & O & V).
assert (L : Rabs (x - y) <= m - o) by (apply Rabs_le; lra).
assert (B : Rabs (rnd (x - y)) <= minus m o) by (rewrite V, rnd_abs; now apply rnd_le).
assert (Z : finite (minus x y) /\ value (minus x y) = rnd (x - y)).
{ pose proof (below_high (minus m o)) as H. pose proof (Rle_abs (minus m o)) as P. unfold minus.
  clear V L. cases_of (Bminus_correct 53 1024 _ _ mode_NE x y X Y); [now intros (V & Z & _)|].
  fold (rnd (x - y)) in L. exfalso. lra. }
destruct Z as [Z V']. split; [exact Z|]. split; [now rewrite V'|].
destruct (of_difference x y Z) as (x' & [O1 O2] & D). exists x'. split; [|exact D]. split; [exact L|].
apply Rle_trans with (1 := O2). apply Rmult_le_compat_l; [|exact L]. simpl. pose proof v_small. lra.
Qed.

(* What cannot overflow: multiples of 2^1021. *)
Notation unit := (bpow radix2 1021).
Definition up_to (n : Z) (z : float) := finite z /\ Rabs z <= IZR n * unit.
Lemma held_units n : (0 <= n < 8)%Z -> held (IZR n * unit).
Proof. intros N. apply generic_format_FLT. exists (Float radix2 n 1021); [reflexivity|simpl; lia|simpl; lia]. Qed.
Lemma units n : (0 <= n < 8)%Z -> IZR n * unit < high.
Proof.
intros N. replace high with (8 * unit); [|now change 8 with (bpow radix2 3); rewrite <- bpow_plus].
apply Rmult_lt_compat_r; [apply bpow_gt_0|now apply IZR_lt].
Qed.
Lemma outcome_up_to n r z : (0 <= n < 8)%Z -> outcome r z -> Rabs r <= IZR n * unit -> up_to n z.
Proof.
intros N (m & O) L. assert (C : Rabs (round radix2 fexp (round_mode m) r) <= IZR n * unit).
{ apply abs_round_le_generic; auto with typeclass_instances. exact (held_units n N). }
pose proof (units n N). destruct O as [(_ & Z & E)|[(O & _)|(_ & Z & E)]]; [|lra|]; (split; [exact Z|]);
  rewrite E; [exact C|].
rewrite Rabs_R0. apply Rmult_le_pos; [apply IZR_le; lia|apply bpow_ge_0].
Qed.
Lemma up_to_times n x y : (0 <= n < 8)%Z -> finite x -> finite y -> Rabs (x * y) <= IZR n * unit ->
  up_to n (times x y).
Proof. intros N X Y. apply outcome_up_to; [exact N|]. now apply outcome_mul. Qed.
Lemma up_to_plus n m x y : (0 <= n)%Z -> (0 <= m)%Z -> (n + m < 8)%Z -> up_to n x -> up_to m y ->
  up_to (n + m) (plus x y).
Proof.
intros N M S (X & LX) (Y & LY). apply (outcome_up_to (n + m) (x + y)); [lia|now apply outcome_add|].
rewrite plus_IZR. pose proof (Rabs_triang x y). lra.
Qed.
Lemma up_to_minus n m x y : (0 <= n)%Z -> (0 <= m)%Z -> (n + m < 8)%Z -> up_to n x -> up_to m y ->
  up_to (n + m) (minus x y).
Proof.
intros N M S (X & LX) (Y & LY). apply (outcome_up_to (n + m) (x - y)); [lia|now apply outcome_sub|].
rewrite plus_IZR. pose proof (Rabs_triang x (- y)). rewrite Rabs_Ropp in *. unfold Rminus. lra.
Qed.
Lemma up_to_multiply_add fused n m x y z : (0 <= n)%Z -> (0 <= m)%Z -> (n + m < 8)%Z ->
  finite x -> finite y -> Rabs (x * y) <= IZR n * unit -> up_to m z -> up_to (n + m) (multiply_add fused x y z).
Proof.
intros N M S X Y L Z. unfold multiply_add. destruct fused.
- destruct Z as (Z & LZ). apply (outcome_up_to (n + m) (x * y + z)); [lia|now apply outcome_fma|].
  rewrite plus_IZR. pose proof (Rabs_triang (x * y) z). lra.
- apply up_to_plus; auto. apply up_to_times; auto. lia.
Qed.
Lemma finite_opposite x : finite (negated x) <-> finite x.
Proof. now destruct x. Qed.
Lemma value_opposite (x : float) : value (negated x) = - x.
Proof. apply B2R_Bopp. Qed.
Lemma up_to_opposite n x : up_to n x -> up_to n (negated x).
Proof. intros (F & L). split; [now apply finite_opposite|]. now rewrite value_opposite, Rabs_Ropp. Qed.
Lemma of_opposite j A (x : float) t T : est j A x t T -> est j A (negated x) (- t) T.
Proof.
rewrite value_opposite. intros (x' & [P Q] & L). exists (- x'). split.
- split; [now rewrite Rabs_Ropp|]. replace (- x' - - t) with (- (x' - t)) by ring. now rewrite Rabs_Ropp.
- replace (- x - - x') with (- (x - x')) by ring. now rewrite Rabs_Ropp.
Qed.

(* The error: 32 v of the size, and 2^-1000. *)
Definition error_of (s : float) : float := bound false (-51) (times (number 1 3) s).
Lemma held_units_of x : held x -> rnd (8 * x) = 8 * x.
Proof.
intros H. apply rnd_held. change 8 with (bpow radix2 3). rewrite Rmult_comm.
apply mult_bpow_pos_exact_FLT; [exact H|lia].
Qed.
Lemma error_finite s : finite (error_of s) -> finite s.
Proof. unfold error_of, bound, multiply_add. intros F. finites. assumption. Qed.
Lemma error_says s : up s -> finite (error_of s) -> finite s /\ s < unit /\ 0 <= error_of s /\
  (1 - 3 * v) * (bpow radix2 (-48) * s) + bpow radix2 (-1001) <= error_of s.
Proof.
intros U F. assert (E8 : up (number 1 3)) by (apply up_number; lia).
assert (U8 : up (times (number 1 3) s)) by (now apply up_times).
assert (A : above (size (B754_infinity false)) (error_of s) = true) by (destruct (error_of s); easy).
destruct (bound_says false (-51) (times (number 1 3) s) _ A U8 ltac:(lia)) as (M & _ & BL).
destruct (times_finite _ _ M) as (_ & S & V). destruct (number_value 1 3) as [_ V8]; [lia|lia|].
rewrite V8, Rmult_1_l in V. change (bpow radix2 3) with 8 in V. rewrite held_units_of in V by apply held_value.
split; [exact S|]. split; [|split].
- pose proof (below_high (times (number 1 3) s)) as H. rewrite V in H. pose proof (Rle_abs (8 * s)) as P.
  replace high with (8 * unit) in H by (change 8 with (bpow radix2 3); now rewrite <- bpow_plus). lra.
- apply up_value, up_multiply_add; [exact U8|apply up_number; lia|apply up_number; lia].
- rewrite V in BL. replace (bpow radix2 (-51) * (8 * s)) with (bpow radix2 (-48) * s) in BL; [exact BL|].
  change (bpow radix2 (-48)) with (bpow radix2 (-51 + 3)). rewrite bpow_plus. change (bpow radix2 3) with 8. ring.
Qed.

(* The sign of a value of j roundings, of terms q times as large as those of the size. *)
Lemma linear_signs j k q e (z s : float) t T : up s -> finite (error_of s) -> finite z ->
  est j spare z t (q * T) -> least_of k (spare / 8) s T -> (j <= 16)%nat -> (k <= 16)%nat -> 0 <= q <= 8 ->
  bpow radix2 e * q = bpow radix2 (-48) -> INR j + 1 / 2 <= 32 / q -> 32 / q <= 64 -> bpow radix2 e = 32 / q * v ->
  above (size z) (error_of s) = true ->
  (negative_lane z = true -> t < 0) /\ (negative_lane z = false -> t > 0).
Proof.
intros U FE FZ E L J K Q EQ JQ Q64 EV A. destruct (error_says s U FE) as (FS & _ & P & BL).
assert (L' : least_of k spare (q * s) (q * T)).
{ destruct L as (s' & [L1 L2] & L3). exists (q * s'). pose proof (bpow_gt_0 radix2 (-1010)). split; [split|].
  - apply Rmult_le_pos; lra.
  - replace ((1 - v) ^ k * (q * T)) with (q * ((1 - v) ^ k * T)) by ring. apply Rmult_le_compat_l; lra.
  - assert (q * (s' - spare / 8) <= q * s) by (apply Rmult_le_compat_l; lra).
    assert (q * (spare / 8) <= 8 * (spare / 8)) by (apply Rmult_le_compat_r; lra). lra. }
assert (BL' : (1 - 3 * v) * (bpow radix2 e * (q * s)) + bpow radix2 (-1001) <= error_of s).
{ replace (bpow radix2 e * (q * s)) with (bpow radix2 (-48) * s) by (rewrite <- EQ; ring). exact BL. }
destruct (signs _ _ _ _ _ _ _ (32 / q) e E L' J K Q64 JQ EV BL') as [N S].
assert (FZ' : finite (size z)) by (now destruct z).
apply (above_finite _ _ FZ' FE) in A. assert (SZ : value (size z) = Rabs z) by apply B2R_Babs. rewrite SZ in A.
destruct (sign_value z) as [S1 S2]. pose proof v_small. split; intros B.
- apply N. specialize (S1 B). rewrite Rabs_left1 in A by exact S1. nra.
- apply S. specialize (S2 B). rewrite Rabs_right in A by lra. nra.
Qed.

Lemma below_unit r : rnd r < unit -> r < unit.
Proof.
intros L. apply Rnot_le_lt. intros H. apply Rlt_not_le in L. apply L. rewrite <- (rnd_held unit); [now apply rnd_le|].
replace unit with (1 * unit) by ring. now apply held_units.
Qed.
Lemma extent_up o m x : finite (minus m o) -> between o m x -> up (minus m o).
Proof.
intros F (_ & L). apply up_finite; [exact F|]. destruct (minus_finite _ _ F) as (_ & _ & ->). apply rnd_pos. lra.
Qed.
Lemma low_extent o m x : finite (minus m o) -> between o m x -> least_of 1 0 (minus m o) (m - o).
Proof.
intros F (_ & L). destruct (minus_finite _ _ F) as (M & O & V). rewrite V.
apply (least_sum_held m (- o)); [apply held_value|apply generic_format_opp, held_value|lra].
Qed.
Lemma up_extent o m x : known x -> in_box o m x -> up (minus m o).
Proof.
intros K [A B]. destruct (finite_case o) as [O|[->|[->| ->]]], (finite_case m) as [M|[->|[->| ->]]],
  (finite_case x) as [X|[->|[->| ->]]]; try discriminate; try exact I; try reflexivity;
  try (now destruct o); try (now destruct m); try (now destruct x).
apply (outcome_up _ _ (outcome_sub mode_NE m o M O)).
assert (~ x < o) by (rewrite <- (above_finite _ _ O X), A; discriminate).
assert (~ m < x) by (rewrite <- (above_finite _ _ X M), B; discriminate). lra.
Qed.
Lemma in_box_spans o m x : finite (minus m o) -> known x -> in_box o m x -> between o m x /\
  spans (minus x o) (x - o) (minus m o) (m - o).
Proof.
intros F K B. destruct (minus_finite _ _ F) as (M & O & _). assert (W := in_box_between o m x O M B K).
split; [exact W|]. apply displaced; [exact F|exact W|]. destruct W as (_ & W). split; [exact O|lra].
Qed.
Lemma product_within (c d m M s : float) : Rabs c <= m -> Rabs d <= M -> rnd (m * M) <= s -> s < unit ->
  Rabs (c * d) <= 1 * unit.
Proof.
intros L K P Q. rewrite Rabs_mult. assert (Rabs c * Rabs d <= m * M) by (apply Rmult_le_compat;
  auto using Rabs_pos). pose proof (below_unit (m * M) ltac:(lra)). lra.
Qed.

Lemma span_product (c d M N : float) r s E F : spans c r M E -> spans d s N F -> M * N < unit ->
  Rabs (c * d) <= 1 * unit.
Proof.
intros (_ & L & _) (_ & K & _) U. rewrite Rabs_mult. assert (Rabs c * Rabs d <= M * N) by (apply Rmult_le_compat;
  auto using Rabs_pos). lra.
Qed.

(* The turn of an edge. *)
Definition turn (a0 a1 b0 b1 p0 p1 : R) := (b0 - a0) * (p1 - a1) - (b1 - a1) * (p0 - a0).
Section Line.
Variables (fused : bool) (ox oy mx my ax ay bx by_ px py : float).
Let X := minus mx ox.
Let Y := minus my oy.
Let k := minus (negated (times (minus ay by_) (minus ax ox))) (times (minus bx ax) (minus ay oy)).
Let z : float := multiply_add fused (minus ay by_) (minus px ox) (multiply_add fused (minus bx ax) (minus py oy) k).
Hypotheses (KAX : known ax) (KAY : known ay) (KBX : known bx) (KBY : known by_) (KPX : known px) (KPY : known py)
  (AX : in_box ox mx ax) (AY : in_box oy my ay) (BX : in_box ox mx bx) (BY : in_box oy my by_)
  (PX : in_box ox mx px) (PY : in_box oy my py) (FE : finite (error_of (times X Y))).

Lemma line_of_coordinates : Forall finite [ox; oy; mx; my; ax; ay; bx; by_; px; py; z] /\
  (above (size z) (error_of (times X Y)) = true ->
    (negative_lane z = true -> turn ax ay bx by_ px py < 0) /\
    (negative_lane z = false -> turn ax ay bx by_ px py > 0)).
Proof.
assert (FS := error_finite _ FE). destruct (times_finite _ _ FS) as (FX & FY & V).
assert (UX : up X) by (now apply (up_extent _ _ ax)). assert (UY : up Y) by (now apply (up_extent _ _ ay)).
assert (U : up (times X Y)) by (now apply up_times). destruct (error_says _ U FE) as (_ & S1 & _).
assert (XY : X * Y < unit) by (apply below_unit; now rewrite <- V).
destruct (minus_finite _ _ FX) as (MX & OX & _). destruct (minus_finite _ _ FY) as (MY & OY & _).
destruct (in_box_spans _ _ _ FX KAX AX) as (WAX & EX), (in_box_spans _ _ _ FY KAY AY) as (WAY & EY),
  (in_box_spans _ _ _ FX KPX PX) as (WPX & DX), (in_box_spans _ _ _ FY KPY PY) as (WPY & DY).
assert (WBX := in_box_between _ _ _ OX MX BX KBX). assert (WBY := in_box_between _ _ _ OY MY BY KBY).
assert (A := displaced _ _ _ _ FY WAY WBY). assert (B := displaced _ _ _ _ FX WBX WAX).
fold X in EX, DX, B. fold Y in A, EY, DY.
assert (P1 := span_product _ _ _ _ _ _ _ _ EX A XY). assert (P2 := span_product _ _ _ _ _ _ _ _ B EY XY).
assert (P3 := span_product _ _ _ _ _ _ _ _ B DY XY). assert (P4 := span_product _ _ _ _ _ _ _ _ DX A XY).
rewrite (Rmult_comm (minus ax ox)) in P1. rewrite (Rmult_comm (minus px ox)) in P4.
set (a := minus ay by_) in *. set (b := minus bx ax) in *. set (e0 := minus ax ox) in *. set (e1 := minus ay oy) in *.
set (d0 := minus px ox) in *. set (d1 := minus py oy) in *.
destruct A as (FA & _ & A), B as (FB & _ & B), EX as (FE0 & _ & EX), EY as (FE1 & _ & EY), DX as (FD0 & _ & DX),
  DY as (FD1 & _ & DY).
assert (Q1 := up_to_times 1 a e0 ltac:(lia) FA FE0 P1). assert (Q2 := up_to_times 1 b e1 ltac:(lia) FB FE1 P2).
assert (Q3 := up_to_minus 1 1 _ _ ltac:(lia) ltac:(lia) ltac:(lia) (up_to_opposite _ _ Q1) Q2).
assert (Q4 := up_to_multiply_add fused 1 2 b d1 _ ltac:(lia) ltac:(lia) ltac:(lia) FB FD1 P3 Q3).
assert (Q5 := up_to_multiply_add fused 1 3 a d0 _ ltac:(lia) ltac:(lia) ltac:(lia) FA FD0 P4 Q4).
change (up_to (1 + 1) k) in Q3. change (up_to (1 + 2) (multiply_add fused b d1 k)) in Q4.
change (up_to (1 + 3) z) in Q5.
split; [repeat constructor; first [assumption|apply WAX|apply WAY|apply WBX|apply WBY|apply WPX|apply WPY|apply Q5]|].
set (x := mx - ox) in *. set (y := my - oy) in *.
assert (E : est 6 spare (value z) ((ay - by_) * (px - ox) + ((bx - ax) * (py - oy) +
  (- ((ay - by_) * (ax - ox)) - (bx - ax) * (ay - oy)))) (4 * (x * y))).
{ replace (4 * (x * y)) with (y * x + (x * y + (y * x + x * y))) by ring.
  eapply est_more; cycle 2.
  - eapply of_multiply_add; [apply Q5|exact A|exact DX|].
    eapply of_multiply_add; [apply Q4|exact B|exact DY|].
    eapply of_minus; [apply Q3|apply of_opposite|].
    + eapply of_times; [apply Q1|exact A|exact EX].
    + eapply of_times; [apply Q2|exact B|exact EY].
  - cbn. lia.
  - small_rest. }
assert (L : least_of 3 (spare / 8) (times X Y) (x * y)).
{ rewrite V. eapply least_more; cycle 2.
  - eapply least_times; [now apply (low_extent _ _ ax)|now apply (low_extent _ _ ay)].
  - cbn. lia.
  - small_rest. }
intros W. replace (turn ax ay bx by_ px py) with ((ay - by_) * (px - ox) + ((bx - ax) * (py - oy) +
  (- ((ay - by_) * (ax - ox)) - (bx - ax) * (ay - oy)))) by (unfold turn; ring).
apply (linear_signs 6 3 4 (-50) z (times X Y) _ (x * y)); auto; try lia; try lra.
- apply Q5.
- change 4 with (bpow radix2 2). rewrite <- bpow_plus. reflexivity.
- simpl. lra.
- rewrite v_is. simpl. lra.
Qed.
End Line.

Section Plane.
Variables (fused : bool) (o1 o2 o3 g1 g2 g3 a1 a2 a3 p1 p2 p3 c1 c2 c3 m1 m2 m3 s : float) (t1 t2 t3 T1 T2 T3 : R).
Let own := plus (plus (times m1 (minus g1 o1)) (times m2 (minus g2 o2))) (times m3 (minus g3 o3)).
Let k := plus (plus (times c1 (minus a1 o1)) (times c2 (minus a2 o2))) (times c3 (minus a3 o3)).
Let z : float := multiply_add fused c1 (minus p1 o1) (multiply_add fused c2 (minus p2 o2)
  (multiply_add fused c3 (minus p3 o3) (negated k))).
Hypotheses (C1 : coordinate c1 m1 t1 T1) (C2 : coordinate c2 m2 t2 T2) (C3 : coordinate c3 m3 t3 T3)
  (KA1 : known a1) (KA2 : known a2) (KA3 : known a3) (KP1 : known p1) (KP2 : known p2) (KP3 : known p3)
  (A1 : in_box o1 g1 a1) (A2 : in_box o2 g2 a2) (A3 : in_box o3 g3 a3)
  (P1 : in_box o1 g1 p1) (P2 : in_box o2 g2 p2) (P3 : in_box o3 g3 p3)
  (SO : not_below s own = true) (FE : finite (error_of s)).

Lemma plane_of_coordinates : Forall finite [own; p1; p2; p3; z] /\ (above (size z) (error_of s) = true ->
  let t := t1 * (p1 - a1) + t2 * (p2 - a2) + t3 * (p3 - a3) in
  (negative_lane z = true -> t < 0) /\ (negative_lane z = false -> t > 0)).
Proof.
destruct C1 as [U1 D1], C2 as [U2 D2], C3 as [U3 D3].
assert (UX := up_extent _ _ _ KA1 A1). assert (UY := up_extent _ _ _ KA2 A2). assert (UZ := up_extent _ _ _ KA3 A3).
assert (UO : up own) by (unfold own; ups). assert (FS := error_finite _ FE).
assert (FO : finite own).
{ unfold not_below in SO. destruct (finite_case own) as [F|[E|[E|E]]]; [exact F|rewrite E in UO; discriminate UO| |];
    rewrite E in SO; now destruct s. }
assert (LO : own <= s) by (now apply (not_below_finite _ _ FS FO)).
assert (US : up s) by (apply up_finite; [exact FS|]; apply up_value in UO; lra).
destruct (error_says _ US FE) as (_ & S1 & _).
destruct (plus_finite _ _ FO) as (FO1 & FX3 & V). destruct (plus_finite _ _ FO1) as (FX1 & FX2 & V1).
destruct (times_finite _ _ FX1) as (FM1 & FX & V3). destruct (times_finite _ _ FX2) as (FM2 & FY & V4).
destruct (times_finite _ _ FX3) as (FM3 & FZ & V5).
specialize (D1 FM1). specialize (D2 FM2). specialize (D3 FM3).
destruct D1 as ((FC1 & _ & B1) & E1 & L1), D2 as ((FC2 & _ & B2) & E2 & L2), D3 as ((FC3 & _ & B3) & E3 & L3).
destruct (in_box_spans _ _ _ FX KA1 A1) as (_ & F1 & M1 & R1), (in_box_spans _ _ _ FY KA2 A2) as (_ & F2 & M2 & R2),
  (in_box_spans _ _ _ FZ KA3 A3) as (WA & F3 & M3 & R3), (in_box_spans _ _ _ FX KP1 P1) as (W1 & G1 & N1 & Q1),
  (in_box_spans _ _ _ FY KP2 P2) as (W2 & G2 & N2 & Q2), (in_box_spans _ _ _ FZ KP3 P3) as (W3 & G3 & N3 & Q3).
assert (H1 := up_value _ (up_times _ _ U1 UX)). assert (H2 := up_value _ (up_times _ _ U2 UY)).
assert (H3 := up_value _ (up_times _ _ U3 UZ)).
assert (H12 : rnd (m1 * minus g1 o1) <= plus (times m1 (minus g1 o1)) (times m2 (minus g2 o2)) /\
  rnd (m2 * minus g2 o2) <= plus (times m1 (minus g1 o1)) (times m2 (minus g2 o2))).
{ rewrite V1, <- V3, <- V4.
  split; [rewrite <- (rnd_held (times m1 _)) at 1|rewrite <- (rnd_held (times m2 _)) at 1]; try apply held_value;
    apply rnd_le; lra. }
assert (H4 := up_value _ (up_plus _ _ (up_times _ _ U1 UX) (up_times _ _ U2 UY))).
assert (H123 : value (plus (times m1 (minus g1 o1)) (times m2 (minus g2 o2))) <= own /\
  rnd (m3 * minus g3 o3) <= own).
{ unfold own. rewrite V, <- V5.
  split; [rewrite <- (rnd_held (plus _ (times m2 _))) at 1|rewrite <- (rnd_held (times m3 _)) at 1];
    try apply held_value; apply rnd_le; lra. }
assert (I1 : rnd (m1 * minus g1 o1) <= s) by lra. assert (I2 : rnd (m2 * minus g2 o2) <= s) by lra.
assert (I3 : rnd (m3 * minus g3 o3) <= s) by lra.
assert (J1 := product_within _ _ _ _ _ B1 N1 I1 S1).
assert (J2 := product_within _ _ _ _ _ B2 N2 I2 S1).
assert (J3 := product_within _ _ _ _ _ B3 N3 I3 S1).
assert (DK : dominated k own).
{ unfold k, own. repeat apply dominated_plus; try apply dominated_times; try assumption; repeat split; assumption. }
destruct DK as (FK & _ & BK).
assert (QK : up_to 1 (negated k)) by (apply up_to_opposite; split; [exact FK|lra]).
assert (Y3 := up_to_multiply_add fused 1 1 c3 (minus p3 o3) _ ltac:(lia) ltac:(lia) ltac:(lia) FC3 G3 J3 QK).
assert (Y2 := up_to_multiply_add fused 1 2 c2 (minus p2 o2) _ ltac:(lia) ltac:(lia) ltac:(lia) FC2 G2 J2 Y3).
assert (Y1 := up_to_multiply_add fused 1 3 c1 (minus p1 o1) _ ltac:(lia) ltac:(lia) ltac:(lia) FC1 G1 J1 Y2).
fold z in Y1. destruct (plus_finite _ _ FK) as (FK1 & FT3 & _). destruct (plus_finite _ _ FK1) as (FT1 & FT2 & _).
split; [repeat constructor; first [exact FO|apply W1|apply W2|apply W3|apply Y1]|].
set (x := g1 - o1) in *. set (y := g2 - o2) in *. set (w := g3 - o3) in *.
assert (E : est 11 spare z (t1 * (p1 - o1) + (t2 * (p2 - o2) + (t3 * (p3 - o3) +
  - (t1 * (a1 - o1) + t2 * (a2 - o2) + t3 * (a3 - o3))))) (2 * (T1 * x + T2 * y + T3 * w))).
{ replace (2 * (T1 * x + T2 * y + T3 * w)) with (T1 * x + (T2 * y + (T3 * w + (T1 * x + T2 * y + T3 * w)))) by ring.
  eapply est_more; cycle 2.
  - eapply of_multiply_add; [apply Y1|exact E1|exact Q1|].
    eapply of_multiply_add; [apply Y2|exact E2|exact Q2|].
    eapply of_multiply_add; [apply Y3|exact E3|exact Q3|].
    apply of_opposite. eapply of_plus; [exact FK|eapply of_plus; [exact FK1| |]|];
      (eapply of_times; [assumption|eassumption|eassumption]).
  - cbn. lia.
  - small_rest. }
assert (L : least_of 9 (spare / 8) s (T1 * x + T2 * y + T3 * w)).
{ assert (Q : least_of 9 (spare / 8) own (T1 * x + T2 * y + T3 * w)).
  - eapply least_more; cycle 2.
    + pose proof eta_pos. unfold own. eapply low_plus;
        [exact FO|ups|ups| | |eapply low_plus; [exact FO1|ups|ups| | | |]|];
      try (eapply low_times; [assumption|eassumption|]; eapply low_extent; [assumption|]); try lra; eassumption.
    + cbn. lia.
    + small_rest.
  - destruct Q as (q & Q & LQ). exists q. split; [exact Q|lra]. }
intros A t. replace t with (t1 * (p1 - o1) + (t2 * (p2 - o2) + (t3 * (p3 - o3) +
  - (t1 * (a1 - o1) + t2 * (a2 - o2) + t3 * (a3 - o3))))) by (unfold t; ring).
apply (linear_signs 11 9 2 (-49) z s _ (T1 * x + T2 * y + T3 * w)); auto; try lia; try lra.
- apply Y1.
- change 2 with (bpow radix2 1). rewrite <- bpow_plus. reflexivity.
- simpl. lra.
- rewrite v_is. simpl. lra.
Qed.
End Plane.
