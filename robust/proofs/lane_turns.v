(* SPDX-License-Identifier: Apache-2.0 *)
(* The turn of three points in a lane, with a bound on the sum of the products and not on that of their magnitudes. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model constants steps format floats ghost lanes.
From Filters Require Import lane_bounds lane_filters.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.

(* What is claimed of a lane: where it is known, its numbers are finite, and the sign of the exact value is that. *)
Definition certain (known set : bool) (arguments : list float) exact := known = true ->
  Forall finite arguments /\ (set = true -> exact < 0) /\ (set = false -> exact > 0).

(* A product of two differences has the sign of the exact one, or is 0. *)
Lemma rnd_product_sign a b : (0 <= a * b -> 0 <= rnd (rnd a * rnd b)) /\ (a * b <= 0 -> rnd (rnd a * rnd b) <= 0).
Proof.
destruct (Rle_or_lt 0 a) as [A|A]; destruct (Rle_or_lt 0 b) as [B|B].
- pose proof (rnd_pos a A). pose proof (rnd_pos b B). split; intros P.
  + apply rnd_pos. nra.
  + assert (Z : a = 0 \/ b = 0) by (apply Rmult_integral; nra).
    destruct Z as [->| ->]; rewrite rnd_0, ?Rmult_0_l, ?Rmult_0_r, rnd_0; apply Rle_refl.
- pose proof (rnd_pos a A). pose proof (rnd_neg b (Rlt_le _ _ B)). split; intros P.
  + assert (Z : a = 0 \/ b = 0) by (apply Rmult_integral; nra).
    destruct Z as [->| ->]; rewrite rnd_0, ?Rmult_0_l, ?Rmult_0_r, rnd_0; apply Rle_refl.
  + apply rnd_neg. nra.
- pose proof (rnd_neg a (Rlt_le _ _ A)). pose proof (rnd_pos b B). split; intros P.
  + assert (Z : a = 0 \/ b = 0) by (apply Rmult_integral; nra).
    destruct Z as [->| ->]; rewrite rnd_0, ?Rmult_0_l, ?Rmult_0_r, rnd_0; apply Rle_refl.
  + apply rnd_neg. nra.
- pose proof (rnd_neg a (Rlt_le _ _ A)). pose proof (rnd_neg b (Rlt_le _ _ B)). split; intros P.
  + apply rnd_pos. nra.
  + exfalso. nra.
Qed.
Lemma product_of_differences a b c d : held a -> held b -> held c -> held d ->
  Rabs (rnd (rnd (a - b) * rnd (c - d)) - (a - b) * (c - d)) <= (3 + / 8) * v * Rabs ((a - b) * (c - d)) + eta.
Proof.
intros A B C D. pose proof (est_times _ _ _ _ _ _ _ _ (est_minus_held a b A B) (est_minus_held c d C D)) as (x & [_
  O] & L).
rewrite <- Rabs_mult in O. set (t := (a - b) * (c - d)) in *. set (z := rnd (rnd (a - b) * rnd (c - d))) in *.
replace (z - t) with ((z - x) + (x - t)) by ring. apply Rle_trans with (1 := Rabs_triang _ _).
assert (((1 + v) ^ 3 - 1) * Rabs t <= (3 + / 8) * v * Rabs t).
{ apply Rmult_le_compat_r; [apply Rabs_pos|]. rewrite v_is. simpl. lra. }
simpl in O, H. lra.
Qed.

Lemma eta_spare : 1048576 * eta <= spare.
Proof.
unfold eta. pose proof (bpow_gt_0 radix2 (-1074)).
assert (T : bpow radix2 (-1074) <= bpow radix2 (-1030)) by (apply bpow_le; lia).
replace spare with (1048576 * bpow radix2 (-1030)); [lra|]. change 1048576 with (bpow radix2 20).
rewrite <- bpow_plus. reflexivity.
Qed.
Lemma v_tiny : 0 < v <= / 1048576. Proof. rewrite v_is. lra. Qed.

(* l and r are exact, L and R computed. C = (7/2) v is enough. *)
Definition close_to l L := Rabs (L - l) <= (3 + / 8) * v * Rabs l + eta /\ (0 <= l -> 0 <= L) /\ (l <= 0 -> L <= 0).
Lemma close_opp l L : close_to l L -> close_to (- l) (- L).
Proof.
intros (C & P & N). split; [|split; intros; [assert (L <= 0) by (apply N; lra)|assert (0 <= L) by (apply P; lra)]; lra].
rewrite Rabs_Ropp. now replace (- L - - l) with (- (L - l)) by ring; rewrite Rabs_Ropp.
Qed.
Lemma turn_of_positive l r L R : close_to l L -> close_to r R -> 0 <= l <= r -> R < L ->
  (1 + v) * (L - R) < (7 / 2 - 1 / 16) * v * Rabs (L + R) + spare.
Proof.
intros (CL & PL & _) (CR & PR & _) [P N] G. specialize (PL P). specialize (PR ltac:(lra)).
rewrite (Rabs_right l) in CL by lra. rewrite (Rabs_right r) in CR by lra. rewrite Rabs_right by lra.
apply abs_le in CL, CR. pose proof eta_pos. pose proof eta_spare. pose proof v_tiny.
assert (W : 0 <= v * l) by (apply Rmult_le_pos; lra).
assert (VW : 0 <= v * (v * l) <= / 1048576 * (v * l)).
{ split; [apply Rmult_le_pos; lra|apply Rmult_le_compat_r; lra]. }
assert (VE : 0 <= v * eta <= / 1048576 * eta) by (split; [apply Rmult_le_pos; lra|apply Rmult_le_compat_r; lra]).
assert (RL : l - (3 + / 8) * v * l - eta <= R).
{ assert (0 <= (1 - (3 + / 8) * v) * (r - l)) by (apply Rmult_le_pos; lra). lra. }
assert (D : L - R <= 2 * ((3 + / 8) * v * l) + 2 * eta) by lra.
assert (S : 2 * l - 2 * ((3 + / 8) * v * l) - 2 * eta <= L + R) by lra.
apply (Rmult_le_compat_l v) in D; [|lra]. apply (Rmult_le_compat_l v) in S; [|lra]. lra.
Qed.
Lemma turn_positive l r L R m B : close_to l L -> close_to r R -> (1 - v) * Rabs (L + R) <= m ->
  (1 - 3 * v) * (7 / 2 * v * m) + spare <= B -> B < (L - R) * (1 + v) -> l > r.
Proof.
intros CL CR M BL G. apply Rnot_le_lt. intros N. pose proof v_tiny. pose proof (Rabs_pos (L + R)) as PM.
assert (sp : 0 < spare) by apply bpow_gt_0. set (X := Rabs (L + R)) in *.
assert (PX : 0 <= v * X) by (apply Rmult_le_pos; lra).
assert (VX : 0 <= v * (v * X) <= / 1048576 * (v * X)).
{ split; [apply Rmult_le_pos; lra|apply Rmult_le_compat_r; lra]. }
assert (K : (7 / 2 - 1 / 16) * v * X + spare <= B).
{ assert (E1 : v * ((1 - v) * X) <= v * m) by (apply Rmult_le_compat_l; lra).
  assert (E2 : (1 - 3 * v) * (v * ((1 - v) * X)) <= (1 - 3 * v) * (v * m)) by (apply Rmult_le_compat_l; lra).
  assert (0 <= v * (v * (v * X))) by (apply Rmult_le_pos; lra). lra. }
assert (P : 0 < L - R). { apply Rnot_le_lt. intros Q. assert ((L - R) * (1 + v) <= 0) by nra. lra. }
destruct (Rle_or_lt 0 l) as [Q|Q].
- pose proof (turn_of_positive l r L R CL CR ltac:(lra) ltac:(lra)) as T. fold X in T. lra.
- destruct (Rle_or_lt r 0) as [W|W].
  + pose proof (turn_of_positive (- r) (- l) (- R) (- L) (close_opp _ _ CR) (close_opp _ _ CL) ltac:(lra) ltac:(lra))
    as T.
    replace (- R + - L) with (- (L + R)) in T by ring. rewrite Rabs_Ropp in T. fold X in T. lra.
  + destruct CL as (_ & _ & CL), CR as (_ & CR & _). specialize (CL (Rlt_le _ _ Q)). specialize (CR (Rlt_le _ _ W)).
    lra.
Qed.

Theorem lane_turn_right fused (px py qx qy x y : float) : let '(value, bound) := lane_turn fused px py qx qy x y in
  certain (above (size value) bound) (negative_lane value) [px; py; qx; qy; x; y]
    ((qx - px) * (y - py) - (qy - py) * (x - px)).
Proof.
unfold lane_turn. set (l := times (minus qx px) (minus y py)). set (r := times (minus qy py) (minus x px)).
intros A. change (multiply_add _ _ _ _) with (bound fused (-51) (size (plus l r))) in A.
destruct (bound_says _ _ _ _ A (up_size _) ltac:(lia)) as (M & FB & BL).
apply size_finite in M as [S ES]. destruct (plus_finite _ _ S) as (FL & FR & EP).
destruct (times_finite _ _ FL) as (F1 & F2 & EL). destruct (times_finite _ _ FR) as (F3 & F4 & ER).
destruct (minus_finite _ _ F1) as (? & ? & E1). destruct (minus_finite _ _ F2) as (? & ? & E2).
destruct (minus_finite _ _ F3) as (? & ? & E3). destruct (minus_finite _ _ F4) as (? & ? & E4).
split; [repeat constructor; assumption|]. rewrite ES, EP in BL.
assert (PB : 0 <= value (bound fused (-51) (size (plus l r)))).
{ apply up_value, up_multiply_add; [apply up_size|apply up_number; lia|apply up_number; lia]. }
set (b := bound fused (-51) (size (plus l r))) in *. clearbody b.
assert (CL : close_to ((qx - px) * (y - py)) l).
{ unfold l. rewrite EL, E1, E2. split; [apply product_of_differences; apply held_value|]. apply rnd_product_sign. }
assert (CR : close_to ((qy - py) * (x - px)) r).
{ unfold r. rewrite ER, E3, E4. split; [apply product_of_differences; apply held_value|]. apply rnd_product_sign. }
assert (SM : (1 - v) * Rabs (value l + value r) <= Rabs (rnd (value l + value r))).
{ destruct (rnd_sum (value l) (value r) (held_value l) (held_value r)) as (e & E & ->). rewrite Rabs_mult, Rmult_comm.
  apply Rmult_le_compat_l; [apply Rabs_pos|]. apply abs_le in E. pose proof v_tiny. rewrite Rabs_right; lra. }
set (m := Rabs (rnd (value l + value r))) in *. clearbody m.
assert (BB : (1 - 3 * v) * (7 / 2 * v * m) + spare <= value b).
{ assert (C : bpow radix2 (-51) = 4 * v) by (rewrite v_is; simpl; lra). rewrite C in BL.
  assert (spare <= bpow radix2 (-1001)) by (apply bpow_le; lia). pose proof v_tiny.
  assert (0 <= m) by (pose proof (Rabs_pos (value l + value r)); nra).
  assert (0 <= (1 - 3 * v) * (v * m)) by (apply Rmult_le_pos; [lra|apply Rmult_le_pos; lra]). lra. }
destruct (sure_minus l r b FL FR PB FB A) as [SN SP]. split; intros N.
- specialize (SN N). replace (- (value l - value r)) with (value r - value l) in SN by ring.
  rewrite Rplus_comm in SM. pose proof (turn_positive _ _ _ _ _ _ CR CL SM BB SN). lra.
- specialize (SP N). pose proof (turn_positive _ _ _ _ _ _ CL CR SM BB SP). lra.
Qed.

Theorem lane_orientation_right fused (px py qx qy x y : float) :
  let '(known, set) := lane_orientation fused px py qx qy x y in
  certain known set [px; py; qx; qy; x; y] ((qx - px) * (y - py) - (qy - py) * (x - px)).
Proof. exact (lane_turn_right fused px py qx qy x y). Qed.

(* A known point is off the line. *)
Theorem lane_point_on_segment_right fused (x y ax ay bx by_ : float) :
  let '(known, _) := lane_point_on_segment fused x y ax ay bx by_ in
  known = true -> Forall finite [ax; ay; bx; by_; x; y] /\ (bx - ax) * (y - ay) - (by_ - ay) * (x - ax) <> 0.
Proof.
cbv beta zeta delta [lane_point_on_segment]. intros A. destruct (lane_turn_right fused ax ay bx by_ x y A) as (F & N
  & P).
split; [exact F|]. match type of N with negative_lane ?z = true -> _ => destruct (negative_lane z) end.
- specialize (N eq_refl). lra.
- specialize (P eq_refl). lra.
Qed.
