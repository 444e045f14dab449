(* SPDX-License-Identifier: Apache-2.0 *)
(* Two segments in a lane: the value of filters::segments, of whose sign segments.v says what it means. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model constants steps format floats ghost lanes.
From Filters Require Import lane_bounds lane_filters lane_turns lane_values lane_sums.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.
#[local] Existing Instances p53 fexp_valid below_1024.

(* The exact value, as in segments.v. *)
Definition segments_value rx ry sx sy fx fy :=
  let rs := rx * sy - ry * sx in let rf := rx * fy - ry * fx in let sf := sx * fy - sy * fx in
  Rabs (sf + rf - rs) + Rabs (sf - rf) - Rabs rs.

(* No overflow: powers of two that grow by one with each sum. *)
Lemma mag_minus x y k : mag x k -> mag y k -> (-1000 <= k <= 1022)%Z -> mag (minus x y) (k + 1).
Proof.
intros [X LX] [Y LY] K. apply (outcome_mag _ _ _ (outcome_sub mode_NE x y X Y)).
- rewrite bpow_plus. simpl (bpow radix2 1). apply abs_le in LX, LY. apply Rabs_le. lra.
- unfold fair. apply andb_true_intro. split; apply Z.leb_le; lia.
Qed.
Lemma mag_plus x y k : mag x k -> mag y k -> (-1000 <= k <= 1022)%Z -> mag (plus x y) (k + 1).
Proof.
intros [X LX] [Y LY] K. apply (outcome_mag _ _ _ (outcome_add mode_NE x y X Y)).
- rewrite bpow_plus. simpl (bpow radix2 1). apply abs_le in LX, LY. apply Rabs_le. lra.
- unfold fair. apply andb_true_intro. split; apply Z.leb_le; lia.
Qed.
Lemma mag_times x y k : finite x -> finite y -> Rabs (value x * value y) <= bpow radix2 k -> (-1000 <= k <= 1022)%Z ->
  mag (times x y) k.
Proof.
intros X Y L K. apply (outcome_mag _ _ _ (outcome_mul mode_NE x y X Y) L).
unfold fair. apply andb_true_intro. split; apply Z.leb_le; lia.
Qed.
Lemma mag_size x k : mag x k -> mag (size x) k.
Proof. intros [F L]. split; [now destruct x|]. unfold size, value. now rewrite B2R_Babs, Rabs_Rabsolu. Qed.
Lemma mag_more x j k : mag x j -> (j <= k)%Z -> mag x k.
Proof. intros [F L] K. split; [exact F|]. apply Rle_trans with (1 := L). now apply bpow_le. Qed.

Lemma plus_least x y : finite (plus x y) -> up x -> up y -> value x <= value (plus x y) /\ value y <= value (plus x y).
Proof.
intros F U V. destruct (plus_finite _ _ F) as (X & Y & ->). apply up_value in U, V.
split; [rewrite <- (rnd_held (value x)) at 1 by apply held_value|rewrite <- (rnd_held (value y)) at 1 by apply
  held_value];
  apply rnd_le; lra.
Qed.
Lemma size_value x : value (size x) = Rabs (value x). Proof. apply B2R_Babs. Qed.

(* Three magnitudes, and their sum. *)
Definition extent x y z := plus (plus (size x) (size y)) (size z).
Lemma extent_least x y z : finite (extent x y z) ->
  Rabs (value x) <= value (extent x y z) /\ Rabs (value y) <= value (extent x y z) /\ Rabs (value z) <= value (extent
    x y z).
Proof.
unfold extent. intros F. destruct (plus_finite _ _ F) as (F' & _ & _).
destruct (plus_least _ _ F) as [A B]; [ups|ups|]. destruct (plus_least _ _ F') as [C D]; [ups|ups|].
rewrite !size_value in *. repeat split; lra.
Qed.
Lemma extent_below_high (x : float) k : value x * bpow radix2 k < high -> value x < bpow radix2 (1024 - k).
Proof.
intros L. apply Rmult_lt_reg_r with (bpow radix2 k); [apply bpow_gt_0|]. rewrite <- bpow_plus.
now replace (1024 - k + k)%Z with 1024%Z by ring.
Qed.

(* The same definitions, of differences. *)
Definition segments_lane rx ry sx sy fx fy :=
  let rs := minus (times rx sy) (times ry sx) in let rf := minus (times rx fy) (times ry fx) in
  let sf := minus (times sx fy) (times sy fx) in
  (plus (size (minus (plus sf rf) rs)) (size (minus sf rf)), size rs).
Definition segments_size rx ry sx sy fx fy := times (times (extent rx sx fx) (number 1 8)) (extent ry sy fy).

(* A product by a power of two that does not overflow is exact. *)
Lemma times_exact x : finite (times x (number 1 8)) -> value (times x (number 1 8)) = value x * bpow radix2 8.
Proof.
intros F. destruct (times_finite _ _ F) as (_ & _ & E). destruct (number_value 1 8) as [_ V]; [lia|lia|].
rewrite V, Rmult_1_l in E. rewrite E. apply rnd_held.
destruct (FLT_format_generic _ _ _ _ (held_value x)) as [[m e] H1 H2 H3].
apply generic_format_FLT. exists (Float radix2 m (e + 8)); simpl in *; [|exact H2|lia].
rewrite H1. unfold F2R. simpl. rewrite bpow_plus. simpl. ring.
Qed.
Lemma product_extents rx ry sx sy fx fy a b : finite (segments_size rx ry sx sy fx fy) ->
  Rabs a <= value (extent rx sx fx) -> Rabs b <= value (extent ry sy fy) -> Rabs (a * b) <= bpow radix2 1016.
Proof.
unfold segments_size. intros F A B. destruct (times_finite _ _ F) as (F1 & F2 & E). destruct (times_finite _ _ F1) as
  (F3 & _ & E1).
clear E1. set (x := extent rx sx fx) in *. set (y := extent ry sy fy) in *.
assert (Px : 0 <= value x) by (pose proof (Rabs_pos a); lra). assert (Py : 0 <= value y) by (pose proof (Rabs_pos b);
  lra).
assert (X := times_exact x F1).
pose proof (below_high (times (times x (number 1 8)) y)) as L. rewrite E, X in L.
apply Rle_lt_trans with (1 := Rle_abs _) in L. apply held_high in L.
rewrite Rabs_mult. apply Rle_trans with (value x * value y); [apply Rmult_le_compat; auto using Rabs_pos|].
apply Rmult_le_reg_r with (bpow radix2 8); [apply bpow_gt_0|]. rewrite <- bpow_plus. change (1016 + 8)%Z with 1024%Z.
  lra.
Qed.

Lemma segments_fit rx ry sx sy fx fy : finite (segments_size rx ry sx sy fx fy) ->
  let '(w, m) := segments_lane rx ry sx sy fx fy in finite w /\ finite m.
Proof.
intros F. assert (F' := F). unfold segments_size in F'. destruct (times_finite _ _ F') as (F1 & Fy & _).
destruct (times_finite _ _ F1) as (Fx & _ & _). destruct (extent_least _ _ _ Fx) as (X1 & X2 & X3).
destruct (extent_least _ _ _ Fy) as (Y1 & Y2 & Y3). unfold extent in Fx, Fy. finites.
assert (P : forall x y : float, finite x -> finite y -> Rabs (value x) <= value (extent rx sx fx) ->
  Rabs (value y) <= value (extent ry sy fy) -> mag (times x y) 1016).
{ intros x y X Y LX LY. apply mag_times; auto; [|lia]. exact (product_extents _ _ _ _ _ _ _ _ F LX LY). }
assert (Q : forall x y : float, finite x -> finite y -> Rabs (value x) <= value (extent rx sx fx) ->
  Rabs (value y) <= value (extent ry sy fy) -> mag (times y x) 1016).
{ intros x y X Y LX LY. apply mag_times; auto; [|lia]. rewrite Rmult_comm. exact (product_extents _ _ _ _ _ _ _ _ F
  LX LY). }
unfold segments_lane.
assert (RS : mag (minus (times rx sy) (times ry sx)) 1017) by (apply (mag_minus _ _ 1016); [apply P|apply Q|lia]; auto).
assert (RF : mag (minus (times rx fy) (times ry fx)) 1017) by (apply (mag_minus _ _ 1016); [apply P|apply Q|lia]; auto).
assert (SF : mag (minus (times sx fy) (times sy fx)) 1017) by (apply (mag_minus _ _ 1016); [apply P|apply Q|lia]; auto).
assert (U1 := mag_plus _ _ _ SF RF ltac:(lia)). assert (U2 := mag_minus _ _ _ SF RF ltac:(lia)).
assert (U3 := mag_minus _ _ _ U1 (mag_more _ _ 1018 RS ltac:(lia)) ltac:(lia)).
assert (U4 := mag_plus _ _ _ (mag_size _ _ U3) (mag_more _ _ 1019 (mag_size _ _ U2) ltac:(lia)) ltac:(lia)).
split; [apply U4|apply (mag_size _ _ RS)].
Qed.

(* Seven roundings of twelve products, which are at most twice the product of the extents. C = 16 v is enough, and so
   is (15/2) v in these units. *)
Lemma segments_sizes a b c d e f : 0 <= a -> 0 <= b -> 0 <= c -> 0 <= d -> 0 <= e -> 0 <= f ->
  (c * f + d * e + (a * f + b * e) + (a * d + b * c)) + (c * f + d * e + (a * f + b * e)) + (a * d + b * c)
    <= 2 * ((a + c + e) * (b + d + f)).
Proof. intros. assert (0 <= a * b) by nra. assert (0 <= c * d) by nra. assert (0 <= e * f) by nra. lra. Qed.

(* Sums of three magnitudes have no term for underflow, and the product by 2^8 is exact. *)
Lemma least_extent x y z : finite (plus (plus (size x) (size y)) (size z)) -> forall a b c,
  least_of 1 0 (value (size x)) a -> least_of 1 0 (value (size y)) b -> least_of 1 0 (value (size z)) c ->
  least_of 3 0 (value (plus (plus (size x) (size y)) (size z))) (a + b + c).
Proof.
intros F a b c X Y Z. destruct (plus_finite _ _ F) as (F' & _ & _).
eapply least_more; cycle 2; [eapply low_plus; [exact F|ups|ups| | |eapply low_plus; [exact F'|ups|ups| | |exact
  X|exact Y]|exact Z]
  |cbn; lia|]; lra.
Qed.
Lemma least_scaled x y S T : finite (times (times x (number 1 8)) y) -> least_of 3 0 (value x) S -> least_of 3 0
  (value y) T ->
  least_of 7 spare (value (times (times x (number 1 8)) y) / 128) (2 * (S * T)).
Proof.
intros F X Y. destruct (times_finite _ _ F) as (F1 & _ & E). rewrite (times_exact x F1) in E.
assert (X8 : least_of 3 0 (value x * bpow radix2 8) (S * 256)).
{ destruct X as (x' & [P L] & D). exists (x' * 256). simpl (bpow radix2 8). split; [split; [lra|]|lra].
  rewrite <- Rmult_assoc. apply Rmult_le_compat_r; lra. }
pose proof (least_times _ _ _ _ _ _ X8 Y) as (z & [P L] & D). rewrite <- E in D.
exists (z / 128). split; [split; [lra|]|small_rest].
replace ((1 - v) ^ 7 * (2 * (S * T))) with ((1 - v) ^ 7 * (S * 256 * T) / 128) by field. simpl Nat.add in L. lra.
Qed.

Theorem lane_segment_segment_right fused (a0x a0y a1x a1y b0x b0y b1x b1y : float) :
  let '(known, set) := lane_segment_segment fused a0x a0y a1x a1y b0x b0y b1x b1y in
  certain known set [a0x; a0y; a1x; a1y; b0x; b0y; b1x; b1y]
    (segments_value (a1x - a0x) (a1y - a0y) (b1x - b0x) (b1y - b0y) (a0x - b0x) (a0y - b0y)).
Proof.
cbv beta zeta delta [lane_segment_segment].
set (rx := minus a1x a0x). set (ry := minus a1y a0y). set (sx := minus b1x b0x). set (sy := minus b1y b0y).
set (fx := minus a0x b0x). set (fy := minus a0y b0y).
change (times _ (plus (plus (size ry) _) _)) with (segments_size rx ry sx sy fx fy).
set (w := fst (segments_lane rx ry sx sy fx fy)). set (m := size (minus (times rx sy) (times ry sx))).
change (plus (size (minus (plus _ _) _)) _) with w. set (z := segments_size rx ry sx sy fx fy).
change (multiply_add _ _ _ _) with (bound fused (-57) z). intros A.
assert (U : up z) by (unfold z, segments_size, extent; ups).
destruct (bound_says _ _ _ _ A U ltac:(lia)) as (FZ & FB & BL). assert (PB := up_value _ (up_bound fused (-57) _ U
  ltac:(lia))).
set (b := bound fused (-57) z) in *. clearbody b.
pose proof (segments_fit _ _ _ _ _ _ FZ) as FW. cbv beta zeta delta [segments_lane] in FW. change (finite w /\ finite
  m) in FW.
destruct FW as [FW FM]. destruct (sure_minus w m b FW FM PB FB A) as [SN SP]. clear A.
unfold z in FZ, BL, U. clear z. unfold segments_size, extent in *. unfold w, segments_lane in *. cbn [fst] in *.
  unfold m in *. clear w m.
subst rx ry sx sy fx fy. finites.
split; [repeat constructor; assumption|].
set (a := Rabs (a1x - a0x)). set (c := Rabs (b1x - b0x)). set (e := Rabs (a0x - b0x)).
set (b' := Rabs (a1y - a0y)). set (d := Rabs (b1y - b0y)). set (f := Rabs (a0y - b0y)).
match type of SN with negative_lane (minus ?x (size ?y)) = true -> _ =>
  assert (E : est 7 spare (value x - value (size y))
    (segments_value (a1x - a0x) (a1y - a0y) (b1x - b0x) (b1y - b0y) (a0x - b0x) (a0y - b0y))
    ((c * f + d * e + (a * f + b' * e) + (a * d + b' * c)) + (c * f + d * e + (a * f + b' * e)) + (a * d + b' * c)))
      end.
{ unfold segments_value. cbv zeta. within ltac:(eapply est_difference; [ests|ests]). }
assert (E2 : forall D t T T', est 7 spare D t T -> T <= T' -> est 7 spare D t T').
{ intros D t T T' (x' & [O1 O2] & L) LE. exists x'. split; [split; [lra|]|exact L]. apply Rle_trans with (1 := O2).
  apply Rmult_le_compat_r || idtac. pose proof (upward v v_small 7). nra. }
apply E2 with (T' := 2 * ((a + c + e) * (b' + d + f))) in E; [|apply segments_sizes; apply Rabs_pos]. clear E2.
match type of BL with (1 - 3 * v) * (_ * value (times (times ?x _) ?y)) + _ <= _ =>
  assert (L : least_of 7 spare (value (times (times x (number 1 8)) y) / 128) (2 * ((a + c + e) * (b' + d + f)))) end.
{ apply least_scaled; [assumption| |]; (apply least_extent; [assumption| | |]); apply low_of_difference; assumption. }
replace (bpow radix2 (-57)) with (bpow radix2 (-50) / 128) in BL by (simpl; lra).
replace (bpow radix2 (-50) / 128 * value (times (times (plus (plus (size (minus a1x a0x)) (size (minus b1x b0x)))
  (size (minus a0x b0x))) (number 1 8)) (plus (plus (size (minus a1y a0y)) (size (minus b1y b0y))) (size (minus a0y
    b0y)))))
  with (bpow radix2 (-50) * (value (times (times (plus (plus (size (minus a1x a0x)) (size (minus b1x b0x)))
  (size (minus a0x b0x))) (number 1 8)) (plus (plus (size (minus a1y a0y)) (size (minus b1y b0y))) (size (minus a0y
    b0y)))) / 128))
  in BL by (unfold Rdiv; ring).
destruct (signs _ _ _ _ _ _ _ 8 (-50) E L ltac:(lia) ltac:(lia) ltac:(lra) ltac:(simpl; lra) ltac:(rewrite v_is;
  simpl; lra) BL)
  as [N P].
split; intros K; [exact (N (SN K))|exact (P (SP K))].
Qed.
