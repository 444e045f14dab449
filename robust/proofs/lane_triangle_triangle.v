(* SPDX-License-Identifier: Apache-2.0 *)
(* Two triangles in a lane: fifteen signs decide. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model floats lanes lane_bounds lane_turns lane_values lane_faces lane_moderate.
From Filters Require Import lane_triangle_filters lane_volumes lane_volume_bounds lane_triangles lane_triangle_pairs
  lane_triangle_lines.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.

Lemma equal_beside x y s t : sign_at x (fst s) (snd s) -> sign_at y (fst t) (snd t) -> known_side s = true ->
  known_side t = true -> x = y -> beside s t = true.
Proof.
intros [A B] [C D] K L ->. unfold beside, known_side in *.
destruct (fst s), (snd s), (fst t), (snd t); try discriminate;
  try reflexivity; intuition lra.
Qed.
Lemma beside_signs x y z s t u : sign_at x (fst s) (snd s) -> sign_at y (fst t) (snd t) -> sign_at z (fst u) (snd u) ->
  beside s t && beside s u = true -> (x > 0 /\ y > 0 /\ z > 0) \/ (x < 0 /\ y < 0 /\ z < 0).
Proof.
intros [A B] [C D] [E F] [K L]%andb_prop. unfold beside in *.
destruct (fst s), (snd s), (fst t), (snd t), (fst u), (snd u); try discriminate; intuition lra.
Qed.
Lemma known_nonzero x s : sign_at x (fst s) (snd s) -> known_side s = true -> x <> 0.
Proof. intros [A B] [K|K]%orb_prop; [specialize (A K)|specialize (B K)]; lra. Qed.

(* Beside one edge lies another, as seen from either. *)
Definition beside_edge ax ay az bx by_ bz px py pz qx qy qz :=
  rise ax ay az px py pz qx qy qz (bx - ax) (by_ - ay) (bz - az).
Lemma swapped ax ay az bx by_ bz px py pz qx qy qz s : sign_at (beside_edge ax ay az bx by_ bz px py pz qx qy qz)
  (fst s)
  (snd s) -> sign_at (beside_edge px py pz qx qy qz ax ay az bx by_ bz) (fst s) (snd s).
Proof.
intros S. replace (beside_edge px py pz qx qy qz ax ay az bx by_ bz)
  with (beside_edge ax ay az bx by_ bz px py pz qx qy qz);
  [exact S|]. unfold beside_edge, rise, face_exact. ring.
Qed.
Lemma edge_says ax ay az bx by_ bz px py pz qx qy qz rx ry rz ab bc ca start stop :
  sign_at (beside_edge ax ay az bx by_ bz px py pz qx qy qz) (fst ab) (snd ab) ->
  sign_at (beside_edge ax ay az bx by_ bz qx qy qz rx ry rz) (fst bc) (snd bc) ->
  sign_at (beside_edge ax ay az bx by_ bz rx ry rz px py pz) (fst ca) (snd ca) ->
  sign_at (volume px py pz qx qy qz rx ry rz ax ay az) (fst start) (snd start) ->
  sign_at (volume px py pz qx qy qz rx ry rz bx by_ bz) (fst stop) (snd stop) ->
  signs_of_segment ax ay az (bx - ax) (by_ - ay) (bz - az) px py pz qx qy qz rx ry rz ab bc ca start stop.
Proof.
intros A B C D E. split; [exact (conj A (conj B (conj C D)))|]. cbv zeta.
replace (volume px py pz qx qy qz rx ry rz bx by_ bz) with (volume px py pz qx qy qz rx ry rz ax ay az +
  rise px py pz qx qy qz rx ry rz (bx - ax) (by_ - ay) (bz - az)) in E; [exact E|]. unfold volume, rise, face_exact.
  ring.
Qed.

Section Signs.
Variables ax ay az bx by_ bz cx cy cz px py pz qx qy qz rx ry rz : R.
Variables s0 s1 s2 s3 s4 s5 s6 s7 s8 s9 s10 s11 s12 s13 s14 : bool * bool.
Definition signs_of_corners :=
  sign_at (volume ax ay az bx by_ bz cx cy cz px py pz) (fst s0) (snd s0) /\
  sign_at (volume ax ay az bx by_ bz cx cy cz qx qy qz) (fst s1) (snd s1) /\
  sign_at (volume ax ay az bx by_ bz cx cy cz rx ry rz) (fst s2) (snd s2) /\
  sign_at (volume px py pz qx qy qz rx ry rz ax ay az) (fst s3) (snd s3) /\
  sign_at (volume px py pz qx qy qz rx ry rz bx by_ bz) (fst s4) (snd s4) /\
  sign_at (volume px py pz qx qy qz rx ry rz cx cy cz) (fst s5) (snd s5).
Definition signs_of_edges :=
  sign_at (beside_edge ax ay az bx by_ bz px py pz qx qy qz) (fst s6) (snd s6) /\
  sign_at (beside_edge ax ay az bx by_ bz qx qy qz rx ry rz) (fst s7) (snd s7) /\
  sign_at (beside_edge ax ay az bx by_ bz rx ry rz px py pz) (fst s8) (snd s8) /\
  sign_at (beside_edge bx by_ bz cx cy cz px py pz qx qy qz) (fst s9) (snd s9) /\
  sign_at (beside_edge bx by_ bz cx cy cz qx qy qz rx ry rz) (fst s10) (snd s10) /\
  sign_at (beside_edge bx by_ bz cx cy cz rx ry rz px py pz) (fst s11) (snd s11) /\
  sign_at (beside_edge cx cy cz ax ay az px py pz qx qy qz) (fst s12) (snd s12) /\
  sign_at (beside_edge cx cy cz ax ay az qx qy qz rx ry rz) (fst s13) (snd s13) /\
  sign_at (beside_edge cx cy cz ax ay az rx ry rz px py pz) (fst s14) (snd s14).
Let apart := beside s0 s1 && beside s0 s2 || beside s3 s4 && beside s3 s5.
Let sure := known_side s0 && known_side s1 && known_side s2 && known_side s3 && known_side s4 && known_side s5.
Let crosses := false || (negb (beside s3 s4) && on_one_side s6 s7 s8 || negb (beside s0 s1) && on_one_side s6 s9 s12) ||
  (negb (beside s4 s5) && on_one_side s9 s10 s11 || negb (beside s1 s2) && on_one_side s7 s10 s13) ||
  (negb (beside s5 s3) && on_one_side s12 s13 s14 || negb (beside s2 s0) && on_one_side s8 s11 s14).
Hypothesis corners : signs_of_corners.
Notation not_in_both := (forall x y z, ~ in_both ax ay az bx by_ bz cx cy cz px py pz qx qy qz rx ry rz x y z).

Lemma apart_says : apart = true -> not_in_both.
Proof.
intros A x y z (i & j & k & l & m & n & M & _). destruct corners as (S0 & S1 & S2 & S3 & S4 & S5).
destruct (heights_cancel _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ M) as [Z1 Z2].
destruct M as (WI & WL & _). apply orb_prop in A as [A|A].
- apply (no_sum _ _ _ _ _ _ WL (beside_signs _ _ _ _ _ _ S0 S1 S2 A)). exact Z1.
- apply (no_sum _ _ _ _ _ _ WI (beside_signs _ _ _ _ _ _ S3 S4 S5 A)). exact Z2.
Qed.
Hypothesis known : sure = true.
Hypothesis parted : apart = false.
Lemma all_known : known_side s0 = true /\ known_side s1 = true /\ known_side s2 = true /\ known_side s3 = true /\
  known_side s4 = true /\ known_side s5 = true.
Proof. unfold sure in known. bools. repeat (split; [assumption|]). assumption. Qed.
Lemma not_parallel : ~ (volume px py pz qx qy qz rx ry rz ax ay az = volume px py pz qx qy qz rx ry rz bx by_ bz /\
  volume px py pz qx qy qz rx ry rz bx by_ bz = volume px py pz qx qy qz rx ry rz cx cy cz).
Proof.
destruct all_known as (_ & _ & _ & K3 & K4 & K5). destruct corners as (_ & _ & _ & S3 & S4 & S5). intros [Q1 Q2].
destruct (orb_false_elim _ _ parted) as [_ A]. rewrite (equal_beside _ _ _ _ S3 S4), (equal_beside _ _ _ _ S3 S5) in A;
  try assumption; [discriminate A|]. exact (eq_trans Q1 Q2).
Qed.
Hypothesis edges : signs_of_edges.
Lemma six_edges :
  signs_of_segment ax ay az (bx - ax) (by_ - ay) (bz - az) px py pz qx qy qz rx ry rz s6 s7 s8 s3 s4 /\
  signs_of_segment bx by_ bz (cx - bx) (cy - by_) (cz - bz) px py pz qx qy qz rx ry rz s9 s10 s11 s4 s5 /\
  signs_of_segment cx cy cz (ax - cx) (ay - cy) (az - cz) px py pz qx qy qz rx ry rz s12 s13 s14 s5 s3 /\
  signs_of_segment px py pz (qx - px) (qy - py) (qz - pz) ax ay az bx by_ bz cx cy cz s6 s9 s12 s0 s1 /\
  signs_of_segment qx qy qz (rx - qx) (ry - qy) (rz - qz) ax ay az bx by_ bz cx cy cz s7 s10 s13 s1 s2 /\
  signs_of_segment rx ry rz (px - rx) (py - ry) (pz - rz) ax ay az bx by_ bz cx cy cz s8 s11 s14 s2 s0.
Proof.
destruct corners as (S0 & S1 & S2 & S3 & S4 & S5). destruct edges as (S6 & S7 & S8 & S9 & S10 & S11 & S12 & S13 & S14).
split; [|split; [|split; [|split; [|split]]]]; apply edge_says; try assumption; apply swapped; assumption.
Qed.
Lemma crosses_says : crosses = true -> in_a_segment ax ay az bx by_ bz cx cy cz px py pz qx qy qz rx ry rz.
Proof.
intros S. destruct all_known as (G0 & G1 & G2 & G3 & G4 & G5). assert (N := not_parallel).
destruct six_edges as (EA & EB & EC & EP & EQ & ER).
assert (P : volume ax ay az bx by_ bz cx cy cz px py pz <> 0) by (destruct corners as (S0 & _);
  exact (known_nonzero _ _ S0 G0)).
assert (X : forall i j k l m n, meeting ax ay az bx by_ bz cx cy cz px py pz qx qy qz rx ry rz i j k l m n ->
  (0 < i /\ 0 < j /\ 0 < k /\ 0 < l /\ 0 < m /\ n = 0) \/ (0 < i /\ 0 < j /\ 0 < k /\ 0 < l /\ m = 0 /\ 0 < n) \/
  (0 < i /\ 0 < j /\ 0 < k /\ l = 0 /\ 0 < m /\ 0 < n) \/ (0 < i /\ 0 < j /\ k = 0 /\ 0 < l /\ 0 < m /\ 0 < n) \/
  (0 < i /\ j = 0 /\ 0 < k /\ 0 < l /\ 0 < m /\ 0 < n) \/ (i = 0 /\ 0 < j /\ 0 < k /\ 0 < l /\ 0 < m /\ 0 < n) ->
  in_a_segment ax ay az bx by_ bz cx cy cz px py pz qx qy qz rx ry rz).
{ intros i j k l m n M Z. assert (R : forall x, exists f, (f = 1 \/ f = -1) /\ 0 <= f * x).
  { intros x. destruct (Rle_or_lt 0 x); [exists 1|exists (-1)]; split; auto; lra. }
  assert (Y : exists f, (f = 1 \/ f = -1) /\ Forall (fun p => 0 < fst p \/ fst p = 0 /\ 0 <= snd p)
    (slopes ax ay az bx by_ bz cx cy cz px py pz qx qy qz rx ry rz i j k l m n f)).
  { unfold slopes. match goal with |- exists f, _ /\ Forall _ [(_, f * ?x0); (_, f * ?x1); (_, f * ?x2); (_, f * ?x3);
      (_, f * ?x4); (_, f * ?x5)] =>
      destruct Z as [Z|[Z|[Z|[Z|[Z|Z]]]]]; destruct Z as (Z0 & Z1 & Z2 & Z3 & Z4 & Z5);
      [destruct (R x5) as (f & O & L)|destruct (R x4) as (f & O & L)|destruct (R x3) as (f & O & L)|
       destruct (R x2) as (f & O & L)|destruct (R x1) as (f & O & L)|destruct (R x0) as (f & O & L)] end;
    exists f; (split; [exact O|]); repeat (apply Forall_cons; [simpl; auto|]); apply Forall_nil. }
  destruct Y as (f & O & F).
  exact (crossing_in_a_segment _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ f M O P N F). }
assert (C : forall p1 p2 p3 q1 q2 q3 a1 a2 a3 b1 b2 b3 c1 c2 c3 t u v w,
  common (fun t => 0 <= t <= 1) p1 p2 p3 (q1 - p1) (q2 - p2) (q3 - p3) a1 a2 a3 b1 b2 b3 c1 c2 c3 t u v w ->
  weights u v w /\ (1 - t) * p1 + t * q1 = u * a1 + v * b1 + w * c1 /\
  (1 - t) * p2 + t * q2 = u * a2 + v * b2 + w * c2 /\ (1 - t) * p3 + t * q3 = u * a3 + v * b3 + w * c3).
{ intros * (_ & U & V & W & T & E1 & E2 & E3). repeat split; lra. }
unfold crosses in S. clear N P.
repeat apply orb_prop in S as [S|S]; try discriminate S; apply andb_prop in S as [B I]; apply negb_true_iff in B.
- destruct (segment_crosses _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ EA) as (t & T & (u & v & w & U & V & W & M) & _);
    auto.
  apply C in M as (M & E1 & E2 & E3). apply (X (1 - t) t 0 u v w); [|lra].
  split; [repeat split; lra|]. split; [exact M|]. repeat split; lra.
- destruct (segment_crosses _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ EP) as (t & T & (u & v & w & U & V & W & M) & _);
    auto.
  apply C in M as (M & E1 & E2 & E3). apply (X u v w (1 - t) t 0); [|lra].
  split; [exact M|]. split; [repeat split; lra|]. repeat split; lra.
- destruct (segment_crosses _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ EB) as (t & T & (u & v & w & U & V & W & M) & _);
    auto.
  apply C in M as (M & E1 & E2 & E3). apply (X 0 (1 - t) t u v w); [|lra].
  split; [repeat split; lra|]. split; [exact M|]. repeat split; lra.
- destruct (segment_crosses _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ EQ) as (t & T & (u & v & w & U & V & W & M) & _);
    auto.
  apply C in M as (M & E1 & E2 & E3). apply (X u v w 0 (1 - t) t); [|lra].
  split; [exact M|]. split; [repeat split; lra|]. repeat split; lra.
- destruct (segment_crosses _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ EC) as (t & T & (u & v & w & U & V & W & M) & _);
    auto.
  apply C in M as (M & E1 & E2 & E3). apply (X t 0 (1 - t) u v w); [|lra].
  split; [repeat split; lra|]. split; [exact M|]. repeat split; lra.
- destruct (segment_crosses _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ ER) as (t & T & (u & v & w & U & V & W & M) & _);
    auto.
  apply C in M as (M & E1 & E2 & E3). apply (X u v w t 0 (1 - t)); [|lra].
  split; [exact M|]. split; [repeat split; lra|]. repeat split; lra.
Qed.
Hypothesis edges_known : forallb known_side [s6; s7; s8; s9; s10; s11; s12; s13; s14] = true.
Lemma passes_say : crosses = false -> not_in_both.
Proof.
intros S. assert (N := not_parallel). destruct six_edges as (EA & EB & EC & EP & EQ & ER).
assert (D : forall e f g s t, known_side e = true -> known_side f = true -> known_side g = true ->
  negb (beside s t) && on_one_side e f g = false -> on_both_sides e f g || beside s t = true).
{ intros [[] []] [[] []] [[] []] s t; unfold known_side, on_one_side, on_both_sides; cbn [fst snd orb andb]; intros;
    try discriminate;
    destruct (beside s t); now rewrite ?orb_true_r. }
cbn [forallb] in edges_known. rewrite andb_true_r in edges_known. rewrite !andb_true_iff in edges_known.
destruct edges_known as (K6 & K7 & K8 & K9 & K10 & K11 & K12 & K13 & K14).
unfold crosses in S. rewrite !orb_false_iff in S. destruct S as [[[_ [A P]] [B Q]] [C R]].
apply D in A, P, B, Q, C, R; try assumption.
intros x y z (i & j & k & l & m & n & M & _). revert M. apply edges_decide; try assumption; intros t u v w;
  (eapply segment_passes; [first [exact EA|exact EB|exact EC|exact EP|exact EQ|exact ER]|assumption]).
Qed.
End Signs.

(* Signs of values that are certain; the value over the plane of b is the opposite of the volume. *)
Notation nothing := (false, false).
Lemma nothing_says t : sign_at t (fst nothing) (snd nothing).
Proof. split; discriminate. Qed.
Lemma turned_says z b t : signed z b (- t) -> above (size z) b = true ->
  sign_at t (fst (turned (sign_of z))) (snd (turned (sign_of z))).
Proof. intros S A. apply sign_opposite. exact (certain_says _ _ _ S A). Qed.
Lemma one_side_is x y z : negb (xorb (negative_lane x) (negative_lane y) || xorb (negative_lane x) (negative_lane z)) =
  on_one_side (sign_of x) (sign_of y) (sign_of z).
Proof. unfold on_one_side, sign_of. cbn [fst snd]. now destruct (negative_lane x), (negative_lane y),
  (negative_lane z). Qed.
Lemma together_is x y z : on_one_side (sign_of x) (sign_of y) (sign_of z) =
  beside (sign_of x) (sign_of y) && beside (sign_of x) (sign_of z).
Proof. unfold on_one_side, beside, sign_of. cbn [fst snd]. now destruct (negative_lane x), (negative_lane y),
  (negative_lane z). Qed.
Lemma differ_is x y : xorb (negative_lane x) (negative_lane y) = negb (beside (sign_of x) (sign_of y)).
Proof. unfold beside, sign_of. cbn [fst snd]. now destruct (negative_lane x), (negative_lane y). Qed.
Lemma turned_is s t : beside (turned s) (turned t) = beside s t.
Proof. apply orb_comm. Qed.
Lemma finite_size x : finite x -> finite (size x).
Proof. now destruct x. Qed.
Ltac name_dot n s t d := let e := eval cbv beta iota delta [dot cross] in (dot (cross s t) d) in set (n := e).

(* Where it answers, all numbers are finite; where none, there is no common point; where a segment, there is more than
   one, and all are on one line. `others`: whether all other lanes are certainly apart. *)
Theorem lane_triangle_triangle_right fused others
    (ax ay az bx by_ bz cx cy cz px py pz qx qy qz rx ry rz : float) :
  let '(known, set) := lane_triangle_triangle fused others ax ay az bx by_ bz cx cy cz px py pz qx qy qz rx ry rz in
  known = true -> Forall finite [ax; ay; az; bx; by_; bz; cx; cy; cz; px; py; pz; qx; qy; qz; rx; ry; rz] /\
  (set = true -> in_a_segment ax ay az bx by_ bz cx cy cz px py pz qx qy qz rx ry rz) /\
  (set = false -> forall x y z, ~ in_both ax ay az bx by_ bz cx cy cz px py pz qx qy qz rx ry rz x y z).
Proof.
unfold lane_triangle_triangle. set (x1 := minus bx ax). set (y1 := minus by_ ay). set (z1 := minus bz az).
set (x2 := minus cx ax). set (y2 := minus cy ay). set (z2 := minus cz az).
set (x3 := minus px ax). set (y3 := minus py ay). set (z3 := minus pz az).
set (x4 := minus qx ax). set (y4 := minus qy ay). set (z4 := minus qz az).
set (x5 := minus rx ax). set (y5 := minus ry ay). set (z5 := minus rz az). cbv zeta.
match goal with |- context [lane_moderate ?x ?y ?z] => set (X := x); set (Y := y); set (Z := z) end.
set (b := lane_bound_of fused X Y Z). set (decidable := lane_moderate X Y Z).
name_dot a0 (x1, y1, z1) (x2, y2, z2) (x3, y3, z3). name_dot a1 (x1, y1, z1) (x2, y2, z2) (x4, y4, z4).
name_dot a2 (x1, y1, z1) (x2, y2, z2) (x5, y5, z5).
name_dot p0 (x3, y3, z3) (x4, y4, z4) (x1, y1, z1). name_dot p1 (x4, y4, z4) (x5, y5, z5) (x1, y1, z1).
name_dot p2 (x5, y5, z5) (x3, y3, z3) (x1, y1, z1).
name_dot q0 (x3, y3, z3) (x4, y4, z4) (x2, y2, z2). name_dot q1 (x4, y4, z4) (x5, y5, z5) (x2, y2, z2).
name_dot q2 (x5, y5, z5) (x3, y3, z3) (x2, y2, z2). name_dot o (x3, y3, z3) (x4, y4, z4) (x5, y5, z5).
set (m0 := minus (number 0 0) q0). set (m1 := minus (number 0 0) q1). set (m2 := minus (number 0 0) q2).
set (r0 := plus (minus q0 p0) (minus a1 a0)). set (r1 := plus (minus q1 p1) (minus a2 a1)).
set (r2 := plus (minus q2 p2) (minus a0 a2)).
set (u1 := minus (minus o p0) (plus p1 p2)). set (u2 := plus (plus o m0) (plus m1 m2)).
match goal with |- context [above ?l b] => match l with context [lesser] => set (least := l) end end.
set (ca := above (size a0) b && above (size a1) b && above (size a2) b).
set (cb := above (size o) b && above (size u1) b && above (size u2) b).
assert (G : decidable = true -> ca = true \/ cb = true ->
  Forall finite [ax; ay; az; bx; by_; bz; cx; cy; cz; px; py; pz; qx; qy; qz; rx; ry; rz] /\
  (ca = true -> sign_at (volume ax ay az bx by_ bz cx cy cz px py pz) (fst (sign_of a0)) (snd (sign_of a0)) /\
    sign_at (volume ax ay az bx by_ bz cx cy cz qx qy qz) (fst (sign_of a1)) (snd (sign_of a1)) /\
    sign_at (volume ax ay az bx by_ bz cx cy cz rx ry rz) (fst (sign_of a2)) (snd (sign_of a2))) /\
  (cb = true ->
    sign_at (volume px py pz qx qy qz rx ry rz ax ay az) (fst (turned (sign_of o))) (snd (turned (sign_of o))) /\
    sign_at (volume px py pz qx qy qz rx ry rz bx by_ bz) (fst (turned (sign_of u1))) (snd (turned (sign_of u1))) /\
    sign_at (volume px py pz qx qy qz rx ry rz cx cy cz) (fst (turned (sign_of u2))) (snd (turned (sign_of u2)))) /\
  (above least b = true -> signs_of_edges ax ay az bx by_ bz cx cy cz px py pz qx qy qz rx ry rz (sign_of p0)
    (sign_of p1)
    (sign_of p2) (sign_of r0) (sign_of r1) (sign_of r2) (sign_of m0) (sign_of m1) (sign_of m2))).
{ intros M CC.
  assert (K : Forall known [x1; y1; z1; x2; y2; z2; x3; y3; z3; x4; y4; z4; x5; y5; z5]).
  { destruct CC as [C|C]; apply andb_prop in C as [[C0 C1]%andb_prop C2]; apply known_above in C0, C1, C2.
    - unfold a0 in C0. unfold a1 in C1. unfold a2 in C2. all_known. repeat constructor; assumption.
    - unfold u1 in C1. unfold u2 in C2. knowns.
      assert (KP : known p0) by assumption. assert (KM : known m0) by assumption. unfold m0 in KM. knowns.
      assert (KQ : known q0) by assumption. clear - C0 KP KQ. unfold o in C0. unfold p0 in KP. unfold q0 in KQ.
      all_known. repeat constructor; assumption. }
  clear CC. repeat apply Forall_cons_iff in K as [? K]. clear K.
  assert (L : forall a b c d e, known a -> known b -> known c -> known d -> known e ->
    largest (greater_of (greater_of (size a) (size b)) (greater_of (greater_of (size c) (size d)) (size e))) [a; b; c;
      d; e]).
  { intros. apply (largest_greater _ _ [_; _] [_; _; _]); [apply (largest_greater _ _ [_] [_])|
      apply (largest_greater _ _ [_; _] [_]); [apply (largest_greater _ _ [_] [_])|]]; now apply largest_size. }
  assert (LX : largest X [x1; x2; x3; x4; x5]) by now apply L.
  assert (LY : largest Y [y1; y2; y3; y4; y5]) by now apply L.
  assert (LZ : largest Z [z1; z2; z3; z4; z5]) by now apply L. clear L.
  destruct (moderate_says _ _ _ (proj1 LX) (proj1 LY) (proj1 LZ) M) as (SX & SY & SZ).
  destruct (volume_bound fused X Y Z SX SY SZ) as [FB B]. fold b in FB, B. set (U := units X Y Z) in *.
  assert (T := units_three _ _ _ SX SY SZ). assert (R := total_room _ _ _ _ _ _ _ _ _ T T T).
  change (0 <= total U U U <= room / 128) in R. set (E := total U U U) in *.
  destruct LX as [_ LX], LY as [_ LY], LZ as [_ LZ].
  specialize (LX (proj1 (proj1 SX))). specialize (LY (proj1 (proj1 SY))). specialize (LZ (proj1 (proj1 SZ))).
  clearbody X Y Z. all_finite.
  assert (V1 : vector (x1, y1, z1) (bx - ax, by_ - ay, bz - az) U) by displaced.
  assert (V2 : vector (x2, y2, z2) (cx - ax, cy - ay, cz - az) U) by displaced.
  assert (V3 : vector (x3, y3, z3) (px - ax, py - ay, pz - az) U) by displaced.
  assert (V4 : vector (x4, y4, z4) (qx - ax, qy - ay, qz - az) U) by displaced.
  assert (V5 : vector (x5, y5, z5) (rx - ax, ry - ay, rz - az) U) by displaced.
  split.
  { repeat match goal with H : finite ?x |- _ => unfold x in H; apply minus_finite in H as (? & ? & _) end.
    repeat constructor; assumption. }
  assert (A0 := det_says _ _ _ _ _ _ _ _ _ V1 V2 V3 : one_volume E a0 _).
  assert (A1 := det_says _ _ _ _ _ _ _ _ _ V1 V2 V4 : one_volume E a1 _).
  assert (A2 := det_says _ _ _ _ _ _ _ _ _ V1 V2 V5 : one_volume E a2 _).
  assert (P0 := det_says _ _ _ _ _ _ _ _ _ V3 V4 V1 : one_volume E p0 _).
  assert (P1 := det_says _ _ _ _ _ _ _ _ _ V4 V5 V1 : one_volume E p1 _).
  assert (P2 := det_says _ _ _ _ _ _ _ _ _ V5 V3 V1 : one_volume E p2 _).
  assert (Q0 := det_says _ _ _ _ _ _ _ _ _ V3 V4 V2 : one_volume E q0 _).
  assert (Q1 := det_says _ _ _ _ _ _ _ _ _ V4 V5 V2 : one_volume E q1 _).
  assert (Q2 := det_says _ _ _ _ _ _ _ _ _ V5 V3 V2 : one_volume E q2 _).
  assert (O := det_says _ _ _ _ _ _ _ _ _ V3 V4 V5 : one_volume E o _).
  assert (M0 := lane_opposite _ _ _ _ Q0 : one_volume E m0 _).
  assert (M1 := lane_opposite _ _ _ _ Q1 : one_volume E m1 _).
  assert (M2 := lane_opposite _ _ _ _ Q2 : one_volume E m2 _).
  assert (S1 : forall z t, one_volume E z t -> signed z b t)
    by (intros; apply (signed_one E R b FB 42); [exact B|lra|assumption]).
  assert (VM := volumes_minus E R). assert (VP := volumes_plus E R). assert (SP := signed_four_plus E R b FB B).
  assert (SM := signed_four_minus E R b FB B). assert (F4 := finite_four E R).
  clear - A0 A1 A2 P0 P1 P2 Q0 Q1 Q2 O M0 M1 M2 S1 VM VP SP SM F4 FB.
  split; [|split].
  - intros [[C0 C1]%andb_prop C2]%andb_prop. split; [|split].
    + assert (G := certain_says _ _ _ (S1 _ _ A0) C0). by_ring.
    + assert (G := certain_says _ _ _ (S1 _ _ A1) C1). by_ring.
    + assert (G := certain_says _ _ _ (S1 _ _ A2) C2). by_ring.
  - intros [[C0 C1]%andb_prop C2]%andb_prop. split; [|split]; apply sign_opposite.
    + assert (G := certain_says _ _ _ (S1 _ _ O) C0). by_ring.
    + assert (G := certain_says _ _ _ (SM _ _ _ _ (VM _ _ _ _ O P0) (VP _ _ _ _ P1 P2)) C1). by_ring.
    + assert (G := certain_says _ _ _ (SP _ _ _ _ (VP _ _ _ _ O M0) (VP _ _ _ _ M1 M2)) C2). by_ring.
  - assert (R0 := SP _ _ _ _ (VM _ _ _ _ Q0 P0) (VM _ _ _ _ A1 A0)). fold r0 in R0.
    assert (R1 := SP _ _ _ _ (VM _ _ _ _ Q1 P1) (VM _ _ _ _ A2 A1)). fold r1 in R1.
    assert (R2 := SP _ _ _ _ (VM _ _ _ _ Q2 P2) (VM _ _ _ _ A0 A2)). fold r2 in R2.
    destruct (F4 _ _ _ _ (VM _ _ _ _ Q0 P0) (VM _ _ _ _ A1 A0)) as [FR0 _]. fold r0 in FR0.
    destruct (F4 _ _ _ _ (VM _ _ _ _ Q1 P1) (VM _ _ _ _ A2 A1)) as [FR1 _]. fold r1 in FR1.
    destruct (F4 _ _ _ _ (VM _ _ _ _ Q2 P2) (VM _ _ _ _ A0 A2)) as [FR2 _]. fold r2 in FR2.
    intros C. unfold least in C.
    repeat (rewrite above_lesser in C; [apply andb_prop in C as [C ?]|repeat apply finite_lesser; apply finite_size;
      first [exact (proj1 P0)|exact (proj1 P1)|exact (proj1 P2)|exact (proj1 M0)|exact (proj1 M1)|exact (proj1
        M2)|assumption]..|exact FB]).
    unfold signs_of_edges, beside_edge. refine (conj _ (conj _ (conj _ (conj _ (conj _ (conj _ (conj _ (conj _
      _)))))))).
    + assert (G := certain_says p0 b _ (S1 _ _ P0) ltac:(assumption)). by_ring.
    + assert (G := certain_says p1 b _ (S1 _ _ P1) ltac:(assumption)). by_ring.
    + assert (G := certain_says p2 b _ (S1 _ _ P2) ltac:(assumption)). by_ring.
    + assert (G := certain_says r0 b _ R0 ltac:(assumption)). by_ring.
    + assert (G := certain_says r1 b _ R1 ltac:(assumption)). by_ring.
    + assert (G := certain_says r2 b _ R2 ltac:(assumption)). by_ring.
    + assert (G := certain_says m0 b _ (S1 _ _ M0) ltac:(assumption)). by_ring.
    + assert (G := certain_says m1 b _ (S1 _ _ M1) ltac:(assumption)). by_ring.
    + assert (G := certain_says m2 b _ (S1 _ _ M2) ltac:(assumption)). by_ring. }
rewrite !one_side_is, !differ_is. rewrite <- (turned_is (sign_of o)), <- (turned_is (sign_of u1)),
  <- (turned_is (sign_of u2)).
set (apart := ca && on_one_side (sign_of a0) (sign_of a1) (sign_of a2)).
set (apart' := cb && on_one_side (sign_of o) (sign_of u1) (sign_of u2)).
clearbody decidable ca cb least.
(* One plane has all corners of the other on one side. *)
assert (W : decidable = true -> apart' || apart = true ->
  Forall finite [ax; ay; az; bx; by_; bz; cx; cy; cz; px; py; pz; qx; qy; qz; rx; ry; rz] /\
  forall x y z, ~ in_both ax ay az bx by_ bz cx cy cz px py pz qx qy qz rx ry rz x y z).
{ intros M [[C S]%andb_prop|[C S]%andb_prop]%orb_prop; rewrite together_is in S.
  - destruct (G M (or_intror C)) as (F & _ & N & _). split; [exact F|]. destruct (N C) as (N3 & N4 & N5).
    rewrite <- (turned_is _ (sign_of u1)), <- (turned_is _ (sign_of u2)) in S.
    apply (apart_says _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ nothing nothing nothing _ _ _
      (conj (nothing_says _) (conj (nothing_says _) (conj (nothing_says _) (conj N3 (conj N4 N5)))))).
    apply orb_true_iff. now right.
  - destruct (G M (or_introl C)) as (F & N & _). split; [exact F|]. destruct (N C) as (N0 & N1 & N2).
    apply (apart_says _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ nothing nothing nothing
      (conj N0 (conj N1 (conj N2 (conj (nothing_says _) (conj (nothing_says _) (nothing_says _))))))).
    apply orb_true_iff. now left. }
destruct (others && (decidable && apart && true)) eqn:Q.
{ apply andb_prop in Q as [_ [[M A]%andb_prop _]%andb_prop]. intros _.
  destruct (W M ltac:(rewrite A; apply orb_true_r)) as [F N]. split; [exact F|]. split; [discriminate|auto]. }
intros [M K]%andb_prop. destruct (apart' || apart) eqn:A.
{ destruct (W M eq_refl) as [F N]. split; [exact F|]. split; [|auto]. intros S. now rewrite andb_false_r in S. }
rewrite orb_false_l in K. apply andb_prop in K as [[CB CA]%andb_prop CL].
destruct (G M (or_introl CA)) as (F & N & N' & D).
destruct (N CA) as (N0 & N1 & N2). destruct (N' CB) as (N3 & N4 & N5). specialize (D CL). split; [exact F|].
clear W G Q F N N'. apply orb_false_elim in A as [A' A]. unfold apart, apart' in A, A'. rewrite CA in A.
rewrite CB in A'. rewrite together_is in A, A'.
rewrite <- (turned_is _ (sign_of u1)), <- (turned_is _ (sign_of u2)) in A'. rewrite andb_true_l in A, A'.
rewrite andb_true_r.
assert (C : signs_of_corners ax ay az bx by_ bz cx cy cz px py pz qx qy qz rx ry rz (sign_of a0) (sign_of a1)
  (sign_of a2)
  (turned (sign_of o)) (turned (sign_of u1)) (turned (sign_of u2)))
    by exact (conj N0 (conj N1 (conj N2 (conj N3 (conj N4 N5))))).
assert (P : beside (sign_of a0) (sign_of a1) && beside (sign_of a0) (sign_of a2) ||
  beside (turned (sign_of o)) (turned (sign_of u1)) && beside (turned (sign_of o)) (turned (sign_of u2)) = false)
  by (apply orb_false_iff; now split).
assert (H : known_side (sign_of a0) && known_side (sign_of a1) && known_side (sign_of a2)
  && known_side (turned (sign_of o)) &&
  known_side (turned (sign_of u1)) && known_side (turned (sign_of u2)) = true).
{ now rewrite !known_sign, !known_turned. }
split; intros S.
- exact (crosses_says _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ C H P D S).
- refine (passes_say _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ C H P D _ S).
  cbn [forallb]. now rewrite !known_sign.
Qed.
