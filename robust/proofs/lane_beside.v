(* SPDX-License-Identifier: Apache-2.0 *)
(* Points beside rings and convex solids in a lane: the turn of an edge, and the side of a face. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model constants steps format floats ghost lanes.
From Filters Require Import lane_bounds lane_filters lane_turns lane_values lane_sums lane_boxes lane_shape_filters.
From Filters Require Import lane_faces lane_ray_box.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.
#[local] Existing Instances p53 fexp_valid below_1024.

(* The differences of two ends of an edge from a point are those of Turn. *)
Theorem lane_turn_seen_right fused (x y ax ay bx by_ : float) :
  let '(value, bound) := lane_turn_seen fused (minus ax x) (minus ay y) (minus bx x) (minus by_ y) in
  certain (above (size value) bound) (negative_lane value) [x; y; ax; ay; bx; by_]
    ((ax - x) * (by_ - y) - (ay - y) * (bx - x)).
Proof. exact (lane_turn_right fused x y ax ay bx by_). Qed.

(* A coordinate of the normal, or its opposite. *)
Lemma coordinate_outwards (o c m : float) t T : finite o -> value o = 1 \/ value o = -1 -> coordinate c m t T ->
  coordinate (times o c) m (o * t) T.
Proof.
intros FO O [U C]. split; [exact U|]. intros FM. destruct (C FM) as ((FC & _ & D) & E & LM).
assert (K : rnd (o * c) = o * c).
{ apply rnd_held. destruct O as [-> | ->]; [rewrite Rmult_1_l; apply held_value|].
  replace (-1 * c) with (- c) by ring. apply generic_format_opp, held_value. }
assert (A : forall r, Rabs (o * r) = Rabs r).
{ intros r. rewrite Rabs_mult. destruct O as [-> | ->]; [|change (-1) with (- (1)); rewrite Rabs_Ropp];
  rewrite Rabs_R1; ring. }
assert (Z : finite (times o c) /\ value (times o c) = o * c).
{ unfold times. cases_of (Bmult_correct 53 1024 _ _ mode_NE o c).
  - intros (V & Z & _). split; [unfold finite in *; now rewrite Z, FO, FC|]. rewrite V. exact K.
  - exfalso. fold (rnd (value o * value c)) in L. rewrite K, A in L. pose proof (below_high c). lra. }
destruct Z as [Z V]. split; [|split; [|exact LM]].
- split; [exact Z|]. split; [exact FM|]. now rewrite V, A.
- rewrite V. apply exact_est in E as [E1 E2]. apply est_exact. split; [now rewrite A|].
  replace (o * c - o * t) with (o * (c - t)) by ring. now rewrite A.
Qed.

(* The side of a face, outwards: o is 1 or -1. *)
Theorem lane_side_of_face_right fused (ax ay az bx by_ bz cx cy cz o px py pz : float) :
  finite o -> value o = 1 \/ value o = -1 ->
  let '(n0, n1, n2, n3, n4, n5, n6, n7, n8) := lane_plane_numbers ax ay az bx by_ bz cx cy cz o in
  sides_right (lane_side_of_face fused n0 n1 n2 n3 n4 n5 n6 n7 n8 px py pz)
    [ax; ay; az; bx; by_; bz; cx; cy; cz; px; py; pz]
    (o * face_exact (bx - ax) (by_ - ay) (bz - az) (cx - ax) (cy - ay) (cz - az) (px - ax) (py - ay) (pz - az)).
Proof.
intros FO O. cbv beta zeta delta [lane_plane_numbers lane_side_of_face].
set (s1 := minus bx ax). set (s2 := minus by_ ay). set (s3 := minus bz az).
set (t1 := minus cx ax). set (t2 := minus cy ay). set (t3 := minus cz az).
set (d1 := minus px ax). set (d2 := minus py ay). set (d3 := minus pz az).
set (terms := plus (plus (times (terms_of s2 t3 s3 t2) (size d1)) (times (terms_of s3 t1 s1 t3) (size d2)))
  (times (terms_of s1 t2 s2 t1) (size d3))).
set (z := plus (plus (times (times o (difference_of s2 t3 s3 t2)) d1) (times (times o (difference_of s3 t1 s1 t3)) d2))
  (times (times o (difference_of s1 t2 s2 t1)) d3)).
set (exact := face_exact _ _ _ _ _ _ _ _ _). set (b := bound fused (-50) terms).
change (sides_right (above z b, above (minus zero z) b) [ax; ay; az; bx; by_; bz; cx; cy; cz; px; py; pz] (o * exact)).
assert (U : up terms) by (unfold terms, terms_of; ups). assert (UB : up b) by (apply up_bound; [exact U|lia]).
enough (W : above (size z) b = true -> Forall finite [ax; ay; az; bx; by_; bz; cx; cy; cz; px; py; pz] /\
  (negative_lane z = true -> o * exact < 0) /\ (negative_lane z = false -> o * exact > 0)).
{ split; intros A; simpl in A; pose proof (above_bound _ _ A UB) as FB.
  - destruct (above_itself _ _ A UB FB) as [A' N]. destruct (W A') as (F & _ & P). auto.
  - destruct (above_opposite _ _ A UB FB) as [A' N]. destruct (W A') as (F & P & _). auto. }
intros A. destruct (bound_says _ _ _ _ A U ltac:(lia)) as (M & _). unfold terms, terms_of in M.
unfold s1, s2, s3, t1, t2, t3, d1, d2, d3 in M. finites. split; [repeat constructor; assumption|].
assert (C : forall p q r w p' q' r' w', near p p' -> near q q' -> near r r' -> near w w' ->
  coordinate (times o (difference_of p q r w)) (terms_of p q r w) (o * (p' * q' - r' * w')) (total_of p' q' r' w'))
  by (intros; apply coordinate_outwards; [assumption..|]; split; [apply up_terms|now apply coordinate_says]).
assert (S1 : near s1 (bx - ax)) by (now apply near_difference).
assert (S2 : near s2 (by_ - ay)) by (now apply near_difference).
assert (S3 : near s3 (bz - az)) by (now apply near_difference).
assert (T1 : near t1 (cx - ax)) by (now apply near_difference).
assert (T2 : near t2 (cy - ay)) by (now apply near_difference).
assert (T3 : near t3 (cz - az)) by (now apply near_difference).
assert (D1 : near d1 (px - ax)) by (now apply near_difference).
assert (D2 : near d2 (py - ay)) by (now apply near_difference).
assert (D3 : near d3 (pz - az)) by (now apply near_difference).
replace (o * exact) with (o * ((by_ - ay) * (cz - az) - (bz - az) * (cy - ay)) * (px - ax) +
  o * ((bz - az) * (cx - ax) - (bx - ax) * (cz - az)) * (py - ay) +
  o * ((bx - ax) * (cy - ay) - (by_ - ay) * (cx - ax)) * (pz - az)) by (unfold exact, face_exact; ring).
exact (product_right fused _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ (C _ _ _ _ _ _ _ _ S2 T3 S3 T2)
  (C _ _ _ _ _ _ _ _ S3 T1 S1 T3) (C _ _ _ _ _ _ _ _ S1 T2 S2 T1) D1 D2 D3 A).
Qed.
