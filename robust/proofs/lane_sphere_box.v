(* SPDX-License-Identifier: Apache-2.0 *)
(* A ball and a box in a lane: the square of the radius, and that of how far the center is beyond the box. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model constants steps format floats ghost lanes.
From Filters Require Import lane_bounds lane_filters lane_turns lane_values lane_sums lane_boxes.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.

(* How far c is beyond low .. high. *)
Definition beyond (c low high : R) := Rmax (Rmax (low - c) (c - high)) 0.

(* That many points of the interval are as near, and in its interior some nearly so. *)
Lemma beyond_least c low high x : within low high x -> beyond c low high * beyond c low high <= (x - c) * (x - c).
Proof.
intros [L H]. destruct (Rle_or_lt c low) as [C|C]; [|destruct (Rle_or_lt high c) as [D|D]].
- replace (beyond c low high) with (low - c) by (unfold beyond, Rmax; repeat destruct Rle_dec; lra). nra.
- replace (beyond c low high) with (c - high) by (unfold beyond, Rmax; repeat destruct Rle_dec; lra). nra.
- replace (beyond c low high) with 0 by (unfold beyond, Rmax; repeat destruct Rle_dec; lra).
  pose proof (Rle_0_sqr (x - c)). unfold Rsqr in *. lra.
Qed.
Lemma a_little b w eps : 0 <= b -> 0 < w -> 0 < eps -> exists t, 0 < t < w /\ (b + t) * (b + t) < b * b + eps.
Proof.
intros B W E. set (K := 2 * w * b + w * w). assert (P : 0 < K) by (unfold K; nra).
assert (S : exists s, 0 < s < 1 /\ s * K < eps).
{ exists (eps / (eps + K)). assert (I : 0 < / (eps + K)) by (apply Rinv_0_lt_compat; lra).
  assert (J : (eps + K) * / (eps + K) = 1) by (apply Rinv_r; lra). unfold Rdiv.
  set (i := / (eps + K)) in *. clearbody i. split; [split; nra|].
  assert (0 < eps * (eps * i)) by (apply Rmult_lt_0_compat; [lra|apply Rmult_lt_0_compat; lra]).
  replace (eps * i * K) with (eps * ((eps + K) * i) - eps * (eps * i)) by ring. rewrite J. lra. }
destruct S as (s & S & L). exists (s * w). split; [nra|]. unfold K in L. assert (s * s <= s) by nra.
assert (s * s * (w * w) <= s * (w * w)) by (apply Rmult_le_compat_r; nra). nra.
Qed.
Lemma beyond_near c low high eps : low < high -> 0 < eps ->
  exists x, inside low high x /\ (x - c) * (x - c) < beyond c low high * beyond c low high + eps.
Proof.
intros L E. destruct (Rle_or_lt c low) as [C|C]; [|destruct (Rle_or_lt high c) as [D|D]].
- destruct (a_little (low - c) (high - low) eps) as (t & T & Q); [lra..|]. exists (low + t).
  split; [unfold inside; lra|].
  replace (beyond c low high) with (low - c) by (unfold beyond, Rmax; repeat destruct Rle_dec; lra).
  now replace (low + t - c) with (low - c + t) by ring.
- destruct (a_little (c - high) (high - low) eps) as (t & T & Q); [lra..|]. exists (high - t).
  split; [unfold inside; lra|].
  replace (beyond c low high) with (c - high) by (unfold beyond, Rmax; repeat destruct Rle_dec; lra).
  replace ((high - t - c) * (high - t - c)) with ((c - high + t) * (c - high + t)) by ring. exact Q.
- exists c. split; [unfold inside; lra|].
  replace (beyond c low high) with 0 by (unfold beyond, Rmax; repeat destruct Rle_dec; lra). lra.
Qed.

(* The greatest of two differences and 0 is rounded as one of them. *)
Lemma rnd_max x y : rnd (Rmax x y) = Rmax (rnd x) (rnd y).
Proof.
unfold Rmax. destruct (Rle_dec x y) as [L|L]; destruct (Rle_dec (rnd x) (rnd y)) as [M|M]; try reflexivity.
- exfalso. apply M. now apply rnd_le.
- apply Rle_antisym; [exact M|]. apply rnd_le. lra.
Qed.
Lemma way_says (c low high : float) : finite (minus low c) -> finite (minus c high) ->
  let way := greater_of (greater_of (minus low c) (minus c high)) zero in
  finite way /\ est 1 0 way (beyond c low high) (beyond c low high).
Proof.
intros A B way. destruct zero_is as [Z VZ]. destruct (greater_value _ _ A B) as [G VG].
destruct (greater_value _ _ G Z) as [W VW]. split; [exact W|]. unfold way. rewrite VW, VG, VZ.
destruct (minus_finite _ _ A) as (_ & _ & ->). destruct (minus_finite _ _ B) as (_ & _ & ->).
replace (Rmax (Rmax (rnd (low - c)) (rnd (c - high))) 0) with (rnd (beyond c low high))
  by (unfold beyond; now rewrite !rnd_max, rnd_0).
assert (P : 0 <= beyond c low high) by apply Rmax_r.
assert (E : exists e, Rabs e <= v /\ rnd (beyond c low high) = beyond c low high * (1 + e)).
{ unfold beyond. apply Rmax_case; [apply Rmax_case|].
  - apply rnd_difference; apply held_value.
  - apply rnd_difference; apply held_value.
  - exists 0. rewrite rnd_0, Rabs_R0. pose proof v_small. split; lra. }
destruct E as (e & E & ->). apply est_exact. rewrite <- (Rabs_right (beyond c low high)) at 3 by lra.
apply off_rounded; auto using v_small. apply off_self.
Qed.

(* Where it answers, all numbers are finite, the ball and the box have an interior; where they are disjoint, every point
   of the box is farther than the radius, and where they overlap, one of its interior is nearer. *)
Theorem lane_sphere_box_2_right fused (cx cy r lx ly hx hy : float) :
  let '(known, set) := lane_sphere_box_2 fused cx cy r lx ly hx hy in
  known = true -> Forall finite [cx; cy; r; lx; ly; hx; hy] /\ (0 < r /\ lx < hx /\ ly < hy) /\
  (set = true -> forall x y, within lx hx x -> within ly hy y ->
    (x - cx) * (x - cx) + (y - cy) * (y - cy) > r * r) /\
  (set = false -> exists x y, inside lx hx x /\ inside ly hy y /\
    (x - cx) * (x - cx) + (y - cy) * (y - cy) < r * r).
Proof.
cbv beta zeta delta [lane_sphere_box_2].
set (wx := greater_of (greater_of (minus lx cx) _) _). set (wy := greater_of (greater_of (minus ly cy) _) _).
set (outside := multiply_add fused wy wy (times wx wx)). set (inner := times r r).
change (multiply_add fused (plus inner outside) _ _) with (bound fused (-50) (plus inner outside)).
intros [A [[T E]%andb_prop G]%andb_prop]%andb_prop. apply total_finite in T; [|ups].
assert (UI : up inner) by (unfold inner; ups). assert (UO : up outside) by (unfold outside; ups).
destruct (bound_says _ _ _ _ A ltac:(now apply up_plus) ltac:(lia)) as (M & _ & _).
destruct (plus_finite _ _ M) as (FI & FO & _). assert (FO' := FO). unfold inner in FI. unfold outside in FO'. finites.
match type of E with above ?e _ = true => change (is_positive e) in E end.
apply lesser_positive in E as [EX EY]; [|now apply minus_number..].
apply positive_difference in EX, EY; try assumption. apply positive_value in G; [|assumption].
destruct (way_says cx lx hx) as [FX WX]; [assumption..|]. destruct (way_says cy ly hy) as [FY WY]; [assumption..|].
fold wx in FX, WX. fold wy in FY, WY.
set (bx := beyond cx lx hx) in *. set (by_ := beyond cy ly hy) in *.
assert (D : (negative_lane (minus inner outside) = true -> r * r < by_ * by_ + bx * bx) /\
  (negative_lane (minus inner outside) = false -> r * r > by_ * by_ + bx * bx)).
{ apply (balls_right fused); auto using square_nonneg.
  - unfold inner. squares.
  - unfold outside in *. within ltac:(eapply of_multiply_add; [exact FO|exact WY|exact WY|
      eapply of_times; [assumption|exact WX|exact WX]]).
  - apply Rplus_le_le_0_compat; apply square_nonneg. }
split; [repeat constructor; assumption|]. split; [auto|]. split; intros S.
- intros x y X Y. apply D in S. apply (beyond_least cx) in X. apply (beyond_least cy) in Y.
  fold bx in X. fold by_ in Y. lra.
- apply D in S. set (eps := (r * r - (by_ * by_ + bx * bx)) / 2).
  destruct (beyond_near cx lx hx eps EX) as (x & X & X'); [unfold eps; lra|].
  destruct (beyond_near cy ly hy eps EY) as (y & Y & Y'); [unfold eps; lra|].
  exists x, y. split; [exact X|]. split; [exact Y|]. fold bx in X'. fold by_ in Y'. unfold eps in *. lra.
Qed.

Theorem lane_sphere_box_3_right fused (cx cy cz r lx ly lz hx hy hz : float) :
  let '(known, set) := lane_sphere_box_3 fused cx cy cz r lx ly lz hx hy hz in
  known = true -> Forall finite [cx; cy; cz; r; lx; ly; lz; hx; hy; hz] /\ (0 < r /\ lx < hx /\ ly < hy /\ lz < hz) /\
  (set = true -> forall x y z, within lx hx x -> within ly hy y -> within lz hz z ->
    (x - cx) * (x - cx) + (y - cy) * (y - cy) + (z - cz) * (z - cz) > r * r) /\
  (set = false -> exists x y z, inside lx hx x /\ inside ly hy y /\ inside lz hz z /\
    (x - cx) * (x - cx) + (y - cy) * (y - cy) + (z - cz) * (z - cz) < r * r).
Proof.
cbv beta zeta delta [lane_sphere_box_3].
set (wx := greater_of (greater_of (minus lx cx) _) _). set (wy := greater_of (greater_of (minus ly cy) _) _).
set (wz := greater_of (greater_of (minus lz cz) _) _).
set (outside := multiply_add fused wz wz (multiply_add fused wy wy (times wx wx))). set (inner := times r r).
change (multiply_add fused (plus inner outside) _ _) with (bound fused (-50) (plus inner outside)).
intros [A [[T E]%andb_prop G]%andb_prop]%andb_prop. apply total_finite in T; [|ups].
assert (UI : up inner) by (unfold inner; ups). assert (UO : up outside) by (unfold outside; ups).
destruct (bound_says _ _ _ _ A ltac:(now apply up_plus) ltac:(lia)) as (M & _ & _).
destruct (plus_finite _ _ M) as (FI & FO & _). assert (FO' := FO). unfold inner in FI. unfold outside in FO'. finites.
match type of E with above ?e _ = true => change (is_positive e) in E end.
apply lesser_positive in E as [EX EZ]; [|repeat apply lesser_number; now apply minus_number..].
apply lesser_positive in EX as [EX EY]; [|now apply minus_number..].
apply positive_difference in EX, EY, EZ; try assumption. apply positive_value in G; [|assumption].
destruct (way_says cx lx hx) as [FX WX]; [assumption..|]. destruct (way_says cy ly hy) as [FY WY]; [assumption..|].
destruct (way_says cz lz hz) as [FZ WZ]; [assumption..|].
fold wx in FX, WX. fold wy in FY, WY. fold wz in FZ, WZ.
set (bx := beyond cx lx hx) in *. set (by_ := beyond cy ly hy) in *. set (bz := beyond cz lz hz) in *.
assert (D : (negative_lane (minus inner outside) = true -> r * r < bz * bz + (by_ * by_ + bx * bx)) /\
  (negative_lane (minus inner outside) = false -> r * r > bz * bz + (by_ * by_ + bx * bx))).
{ apply (balls_right fused); auto using square_nonneg.
  - unfold inner. squares.
  - unfold outside in *. within ltac:(eapply of_multiply_add; [exact FO|exact WZ|exact WZ|
      eapply of_multiply_add; [assumption|exact WY|exact WY|eapply of_times; [assumption|exact WX|exact WX]]]).
  - repeat apply Rplus_le_le_0_compat; apply square_nonneg. }
split; [repeat constructor; assumption|]. split; [auto|]. split; intros S.
- intros x y z X Y Z. apply D in S. apply (beyond_least cx) in X. apply (beyond_least cy) in Y.
  apply (beyond_least cz) in Z. fold bx in X. fold by_ in Y. fold bz in Z. lra.
- apply D in S. set (eps := (r * r - (bz * bz + (by_ * by_ + bx * bx))) / 3).
  destruct (beyond_near cx lx hx eps EX) as (x & X & X'); [unfold eps; lra|].
  destruct (beyond_near cy ly hy eps EY) as (y & Y & Y'); [unfold eps; lra|].
  destruct (beyond_near cz lz hz eps EZ) as (z & Z & Z'); [unfold eps; lra|].
  exists x, y, z. split; [exact X|]. split; [exact Y|]. split; [exact Z|].
  fold bx in X'. fold by_ in Y'. fold bz in Z'. unfold eps in *. lra.
Qed.
