(* SPDX-License-Identifier: Apache-2.0 *)
(* Two boxes in a lane: the signs of differences, which rounding keeps or makes 0 (robust/kernel/filters/box_differences.h). *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model constants steps format floats ghost lanes.
From Filters Require Import lane_bounds lane_filters lane_turns lane_values.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.
#[local] Existing Instances p53 fexp_valid below_1024.

Notation zero := (number 0 0).
Notation greatest := (number 9007199254740991 971).
Definition is_positive x := above x zero = true.

Lemma zero_is : finite zero /\ value zero = 0.
Proof. split; reflexivity. Qed.
Lemma positive_up x : is_positive x -> up x.
Proof. unfold is_positive. destruct x as [|[]| |[]]; try discriminate; reflexivity. Qed.
Lemma positive_value x : finite x -> is_positive x -> 0 < value x.
Proof. intros F P. destruct zero_is as [Z V]. rewrite <- V. now apply (above_finite x zero F Z). Qed.
Lemma of_positive x : finite x -> 0 < value x -> is_positive x.
Proof. intros F P. destruct zero_is as [Z V]. apply (above_finite x zero F Z). now rewrite V. Qed.
Lemma positive_size x : negative_lane x = false -> is_positive (size x) -> is_positive x.
Proof. unfold is_positive. destruct x as [[]|[]| |[]]; easy. Qed.

(* Neither of these is NaN where the whole is not. *)
Lemma plus_number x y : is_nan (plus x y) = false -> is_nan x = false /\ is_nan y = false.
Proof. destruct x, y; try discriminate; split; reflexivity. Qed.
Lemma minus_number x y : finite x -> finite y -> is_nan (minus x y) = false.
Proof.
intros X Y. unfold minus. cases_of (Bminus_correct 53 1024 _ _ mode_NE x y X Y).
- intros (_ & Z & _). now destruct (Bminus mode_NE x y).
- intros [E%not_finite_overflow _]. now rewrite E.
Qed.
Lemma lesser_either x y : lesser x y = x \/ lesser x y = y.
Proof. unfold lesser. destruct (above y x); auto. Qed.
Lemma lesser_number x y : is_nan x = false -> is_nan y = false -> is_nan (lesser x y) = false.
Proof. destruct (lesser_either x y) as [->| ->]; auto. Qed.
Lemma lesser_positive x y : is_nan x = false -> is_nan y = false -> is_positive (lesser x y) ->
  is_positive x /\ is_positive y.
Proof.
intros X Y. destruct (finite_case x) as [FX|[->|[->| ->]]]; try discriminate X;
  destruct (finite_case y) as [FY|[->|[->| ->]]]; try discriminate Y.
- unfold lesser. destruct (above y x) eqn:Q; intros P; (split; [|]); try exact P.
  + apply of_positive; [exact FY|]. apply (above_finite _ _ FY FX) in Q. apply positive_value in P; [lra|exact FX].
  + apply of_positive; [exact FX|]. apply positive_value in P; [|exact FY].
    assert (~ value x < value y) by (rewrite <- (above_finite _ _ FY FX), Q; discriminate). lra.
- destruct x as [|[]| |[]]; try discriminate FX; intros P; discriminate P.
- destruct x as [|[]| |[]]; try discriminate FX; intros P; (split; [exact P|reflexivity]).
- destruct y as [|[]| |[]]; try discriminate FY; intros P; discriminate P.
- intros P; discriminate P.
- intros P; discriminate P.
- destruct y as [|[]| |[]]; try discriminate FY; intros P; (split; [reflexivity|exact P]).
- intros P; discriminate P.
- intros _. split; reflexivity.
Qed.
Lemma lesser_value x y : finite x -> finite y -> finite (lesser x y) /\ value (lesser x y) = Rmin x y.
Proof.
intros X Y. unfold lesser. destruct (above y x) eqn:Q.
- apply (above_finite _ _ Y X) in Q. rewrite Rmin_left by lra. auto.
- assert (~ value x < value y) by (rewrite <- (above_finite _ _ Y X), Q; discriminate). rewrite Rmin_right by lra. auto.
Qed.
Lemma greater_value x y : finite x -> finite y -> finite (greater_of x y) /\ value (greater_of x y) = Rmax x y.
Proof.
intros X Y. unfold greater_of. destruct (above x y) eqn:Q.
- apply (above_finite _ _ X Y) in Q. rewrite Rmax_left by lra. auto.
- assert (~ value y < value x) by (rewrite <- (above_finite _ _ X Y), Q; discriminate). rewrite Rmax_right by lra. auto.
Qed.

(* A total that is no greater than the greatest number of the format is not NaN, and finite if it is not negative. *)
Lemma total_number t : not_below greatest t = true -> is_nan t = false.
Proof. destruct t; try reflexivity. intros N. vm_compute in N. discriminate N. Qed.
Lemma total_finite t : not_below greatest t = true -> up t -> finite t.
Proof. destruct t as [|[]| |]; try reflexivity; intros N U; try discriminate U; vm_compute in N; discriminate N. Qed.

(* The sign of a difference is right, whatever overflows. *)
Lemma difference_sign x y : finite x -> finite y -> is_positive (size (minus x y)) ->
  (negative_lane (minus x y) = true -> value x < value y) /\ (negative_lane (minus x y) = false -> value y < value x).
Proof.
intros X Y P. destruct zero_is as [Z V].
destruct (sure_minus x y zero X Y ltac:(rewrite V; lra) Z P) as [SN SP]. rewrite V in *. pose proof v_small.
split; intros K; [specialize (SN K)|specialize (SP K)]; nra.
Qed.
Lemma positive_difference x y : finite x -> finite y -> is_positive (minus x y) -> value y < value x.
Proof.
intros X Y P. apply difference_sign; try assumption.
- unfold is_positive in *. destruct (minus x y) as [[]|[]| |[]]; easy.
- unfold is_positive in *. destruct (minus x y) as [[]|[]| |[]]; easy.
Qed.

(* Two intervals, by the least of the upper ends less the greatest of the lower ones. *)
Definition depth_of a_min a_max b_min b_max := minus (lesser a_max b_max) (greater_of a_min b_min).
Lemma depth_says a_min a_max b_min b_max : finite a_min -> finite a_max -> finite b_min -> finite b_max ->
  let d := depth_of a_min a_max b_min b_max in
  is_nan d = false /\ (is_positive d -> Rmax a_min b_min < Rmin a_max b_max) /\
  (is_positive (size d) -> negative_lane d = true -> Rmin a_max b_max < Rmax a_min b_min).
Proof.
intros A B C D d. destruct (lesser_value _ _ B D) as [FL VL]. destruct (greater_value _ _ A C) as [FG VG].
split; [now apply minus_number|]. rewrite <- VL, <- VG. split.
- now apply positive_difference.
- intros P N. now apply (proj1 (difference_sign _ _ FL FG P)).
Qed.

(* What is in an interval, and what is in its interior. *)
Definition within (low high x : R) := low <= x <= high.
Definition inside (low high x : R) := low < x < high.
Lemma apart_says a_min a_max b_min b_max x : Rmin a_max b_max < Rmax a_min b_min ->
  within a_min a_max x -> within b_min b_max x -> False.
Proof. unfold within, Rmin, Rmax. repeat destruct Rle_dec; lra. Qed.
Lemma common_says a_min a_max b_min b_max : Rmax a_min b_min < Rmin a_max b_max ->
  exists x, inside a_min a_max x /\ inside b_min b_max x.
Proof.
intros L. exists ((Rmax a_min b_min + Rmin a_max b_max) / 2). unfold inside.
pose proof (Rmax_l a_min b_min). pose proof (Rmax_r a_min b_min). pose proof (Rmin_l a_max b_max).
pose proof (Rmin_r a_max b_max). lra.
Qed.

Ltac numbers_of N := repeat match goal with
  | H : is_nan (plus _ _) = false |- _ => apply plus_number in H as [? ?] end.
Ltac parts_positive := repeat match goal with
  | H : is_positive (lesser _ _) |- _ =>
      apply lesser_positive in H as [? ?]; [|repeat apply lesser_number; assumption|
        repeat apply lesser_number; assumption] end.
Ltac depths := repeat match goal with
  | |- context [minus (lesser ?b ?d) (greater_of ?a ?c)] => fold (depth_of a b c d) end.

(* Where it answers, all numbers are finite and both boxes have an interior; disjoint boxes have no common point, and
   overlapping ones a point in the interior of both. *)
Theorem lane_boxes_2_right fused (ax ay aX aY bx by_ bX bY : float) :
  let '(known, set) := lane_boxes_2 fused ax ay aX aY bx by_ bX bY in
  known = true -> Forall finite [ax; ay; aX; aY; bx; by_; bX; bY] /\ (ax < aX /\ ay < aY /\ bx < bX /\ by_ < bY) /\
  (set = true -> forall x y, ~ (within ax aX x /\ within ay aY y /\ within bx bX x /\ within by_ bY y)) /\
  (set = false -> exists x y, inside ax aX x /\ inside ay aY y /\ inside bx bX x /\ inside by_ bY y).
Proof.
cbv beta zeta delta [lane_boxes_2]. depths. intros [[T E]%andb_prop D]%andb_prop.
match type of E with above ?q _ = true => set (e := q) in E end.
match type of D with above (size ?q) _ = true => set (d := q) in * end.
change (is_positive e) in E. change (is_positive (size d)) in D.
assert (N := total_number _ T). numbers_of N. unfold e in E. parts_positive.
apply total_finite in T; [|repeat apply up_plus; now apply positive_up]. finites.
split; [repeat constructor; assumption|]. split; [repeat split; now apply positive_difference|].
destruct (depth_says ax aX bx bX) as (N1 & P1 & M1); [assumption..|].
destruct (depth_says ay aY by_ bY) as (N2 & P2 & M2); [assumption..|].
split; intros S.
- intros x y (X1 & Y1 & X2 & Y2). unfold d in *.
  destruct (lesser_either (depth_of ax aX bx bX) (depth_of ay aY by_ bY)) as [K|K]; rewrite K in *.
  + exact (apart_says _ _ _ _ _ (M1 D S) X1 X2).
  + exact (apart_says _ _ _ _ _ (M2 D S) Y1 Y2).
- apply positive_size in D; [|exact S]. unfold d in D. parts_positive.
  destruct (common_says ax aX bx bX) as (x & ? & ?); [auto|].
  destruct (common_says ay aY by_ bY) as (y & ? & ?); [auto|].
  exists x, y. auto.
Qed.

Theorem lane_boxes_3_right fused (ax ay az aX aY aZ bx by_ bz bX bY bZ : float) :
  let '(known, set) := lane_boxes_3 fused ax ay az aX aY aZ bx by_ bz bX bY bZ in
  known = true -> Forall finite [ax; ay; az; aX; aY; aZ; bx; by_; bz; bX; bY; bZ] /\
  (ax < aX /\ ay < aY /\ az < aZ /\ bx < bX /\ by_ < bY /\ bz < bZ) /\
  (set = true -> forall x y z, ~ (within ax aX x /\ within ay aY y /\ within az aZ z /\
    within bx bX x /\ within by_ bY y /\ within bz bZ z)) /\
  (set = false -> exists x y z, inside ax aX x /\ inside ay aY y /\ inside az aZ z /\
    inside bx bX x /\ inside by_ bY y /\ inside bz bZ z).
Proof.
cbv beta zeta delta [lane_boxes_3]. depths. intros [[T E]%andb_prop D]%andb_prop.
match type of E with above ?q _ = true => set (e := q) in E end.
match type of D with above (size ?q) _ = true => set (d := q) in * end.
change (is_positive e) in E. change (is_positive (size d)) in D.
assert (N := total_number _ T). numbers_of N. unfold e in E. parts_positive.
apply total_finite in T; [|repeat apply up_plus; now apply positive_up]. finites.
split; [repeat constructor; assumption|]. split; [repeat split; now apply positive_difference|].
destruct (depth_says ax aX bx bX) as (N1 & P1 & M1); [assumption..|].
destruct (depth_says ay aY by_ bY) as (N2 & P2 & M2); [assumption..|].
destruct (depth_says az aZ bz bZ) as (N3 & P3 & M3); [assumption..|].
split; intros S.
- intros x y z (X1 & Y1 & Z1 & X2 & Y2 & Z2). unfold d in *.
  destruct (lesser_either (lesser (depth_of ax aX bx bX) (depth_of ay aY by_ bY)) (depth_of az aZ bz bZ)) as [K|K];
    rewrite K in *; [|exact (apart_says _ _ _ _ _ (M3 D S) Z1 Z2)].
  destruct (lesser_either (depth_of ax aX bx bX) (depth_of ay aY by_ bY)) as [K'|K']; rewrite K' in *.
  + exact (apart_says _ _ _ _ _ (M1 D S) X1 X2).
  + exact (apart_says _ _ _ _ _ (M2 D S) Y1 Y2).
- apply positive_size in D; [|exact S]. unfold d in D. parts_positive.
  destruct (common_says ax aX bx bX) as (x & ? & ?); [auto|].
  destruct (common_says ay aY by_ bY) as (y & ? & ?); [auto|].
  destruct (common_says az aZ bz bZ) as (z & ? & ?); [auto|]. exists x, y, z. repeat (split; [assumption|]). assumption.
Qed.
