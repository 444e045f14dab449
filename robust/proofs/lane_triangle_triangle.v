(* SPDX-License-Identifier: Apache-2.0 *)
(* Two triangles in a lane: fifteen signs decide. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model floats lanes lane_shape_filters lane_faces lane_triangles lane_triangle_pairs.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.

Definition known_side (s : bool * bool) := fst s || snd s.
Lemma beside_known s t : beside s t = true -> known_side s = true /\ known_side t = true.
Proof. destruct s as [[] []], t as [[] []]; now split. Qed.
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
(* The volume of four corners, seen from the other edge. *)
Lemma swapped ax ay az bx by_ bz px py pz qx qy qz :
  face_exact (bx - ax) (by_ - ay) (bz - az) (px - ax) (py - ay) (pz - az) (qx - ax) (qy - ay) (qz - az) =
  face_exact (qx - px) (qy - py) (qz - pz) (ax - px) (ay - py) (az - pz) (bx - px) (by_ - py) (bz - pz).
Proof. unfold face_exact. ring. Qed.

(* Where it answers, all numbers are finite; where none, there is no common point; where a segment, there is more than
   one, and all are on one line. `others`: whether all other lanes that are certain are apart. *)
Theorem lane_triangle_triangle_right fused others
    (ax ay az bx by_ bz cx cy cz px py pz qx qy qz rx ry rz : float) :
  let '(known, set) := lane_triangle_triangle fused others ax ay az bx by_ bz cx cy cz px py pz qx qy qz rx ry rz in
  known = true -> Forall finite [ax; ay; az; bx; by_; bz; cx; cy; cz; px; py; pz; qx; qy; qz; rx; ry; rz] /\
  (set = true -> in_a_segment ax ay az bx by_ bz cx cy cz px py pz qx qy qz rx ry rz) /\
  (set = false -> forall x y z, ~ in_both ax ay az bx by_ bz cx cy cz px py pz qx qy qz rx ry rz x y z).
Proof.
cbv beta zeta delta [lane_triangle_triangle].
assert (F0 := lane_face_side_right fused ax ay az bx by_ bz cx cy cz px py pz).
assert (F1 := lane_face_side_right fused ax ay az bx by_ bz cx cy cz qx qy qz).
assert (F2 := lane_face_side_right fused ax ay az bx by_ bz cx cy cz rx ry rz).
assert (F3 := lane_face_side_right fused px py pz qx qy qz rx ry rz ax ay az).
assert (F4 := lane_face_side_right fused px py pz qx qy qz rx ry rz bx by_ bz).
assert (F5 := lane_face_side_right fused px py pz qx qy qz rx ry rz cx cy cz).
assert (S6 := sides_sign _ _ _ (lane_face_side_right fused ax ay az bx by_ bz px py pz qx qy qz)).
assert (S7 := sides_sign _ _ _ (lane_face_side_right fused ax ay az bx by_ bz qx qy qz rx ry rz)).
assert (S8 := sides_sign _ _ _ (lane_face_side_right fused ax ay az bx by_ bz rx ry rz px py pz)).
assert (S9 := sides_sign _ _ _ (lane_face_side_right fused bx by_ bz cx cy cz px py pz qx qy qz)).
assert (S10 := sides_sign _ _ _ (lane_face_side_right fused bx by_ bz cx cy cz qx qy qz rx ry rz)).
assert (S11 := sides_sign _ _ _ (lane_face_side_right fused bx by_ bz cx cy cz rx ry rz px py pz)).
assert (S12 := sides_sign _ _ _ (lane_face_side_right fused cx cy cz ax ay az px py pz qx qy qz)).
assert (S13 := sides_sign _ _ _ (lane_face_side_right fused cx cy cz ax ay az qx qy qz rx ry rz)).
assert (S14 := sides_sign _ _ _ (lane_face_side_right fused cx cy cz ax ay az rx ry rz px py pz)).
set (s0 := lane_face_side fused ax ay az bx by_ bz cx cy cz px py pz) in *.
set (s1 := lane_face_side fused ax ay az bx by_ bz cx cy cz qx qy qz) in *.
set (s2 := lane_face_side fused ax ay az bx by_ bz cx cy cz rx ry rz) in *.
set (s3 := lane_face_side fused px py pz qx qy qz rx ry rz ax ay az) in *.
set (s4 := lane_face_side fused px py pz qx qy qz rx ry rz bx by_ bz) in *.
set (s5 := lane_face_side fused px py pz qx qy qz rx ry rz cx cy cz) in *.
set (s6 := lane_face_side fused ax ay az bx by_ bz px py pz qx qy qz) in *.
set (s7 := lane_face_side fused ax ay az bx by_ bz qx qy qz rx ry rz) in *.
set (s8 := lane_face_side fused ax ay az bx by_ bz rx ry rz px py pz) in *.
set (s9 := lane_face_side fused bx by_ bz cx cy cz px py pz qx qy qz) in *.
set (s10 := lane_face_side fused bx by_ bz cx cy cz qx qy qz rx ry rz) in *.
set (s11 := lane_face_side fused bx by_ bz cx cy cz rx ry rz px py pz) in *.
set (s12 := lane_face_side fused cx cy cz ax ay az px py pz qx qy qz) in *.
set (s13 := lane_face_side fused cx cy cz ax ay az qx qy qz rx ry rz) in *.
set (s14 := lane_face_side fused cx cy cz ax ay az rx ry rz px py pz) in *.
clearbody s0 s1 s2 s3 s4 s5 s6 s7 s8 s9 s10 s11 s12 s13 s14.
assert (S0 := sides_sign _ _ _ F0). assert (S1 := sides_sign _ _ _ F1). assert (S2 := sides_sign _ _ _ F2).
assert (S3 := sides_sign _ _ _ F3). assert (S4 := sides_sign _ _ _ F4). assert (S5 := sides_sign _ _ _ F5).
assert (T6 := S6). assert (T7 := S7). assert (T8 := S8). assert (T9 := S9). assert (T10 := S10). assert (T11 := S11).
assert (T12 := S12). assert (T13 := S13). assert (T14 := S14).
rewrite swapped in T6, T7, T8, T9, T10, T11, T12, T13, T14.
assert (EA : signs_of_edge ax ay az bx by_ bz px py pz qx qy qz rx ry rz s6 s7 s8 s3 s4) by exact (conj S6 (conj S7
  (conj S8 (conj S3 S4)))).
assert (EB : signs_of_edge bx by_ bz cx cy cz px py pz qx qy qz rx ry rz s9 s10 s11 s4 s5) by exact (conj S9 (conj S10
  (conj S11 (conj S4 S5)))).
assert (EC : signs_of_edge cx cy cz ax ay az px py pz qx qy qz rx ry rz s12 s13 s14 s5 s3) by exact (conj S12 (conj
  S13 (conj S14 (conj S5 S3)))).
assert (EP : signs_of_edge px py pz qx qy qz ax ay az bx by_ bz cx cy cz s6 s9 s12 s0 s1) by exact (conj T6 (conj T9
  (conj T12 (conj S0 S1)))).
assert (EQ : signs_of_edge qx qy qz rx ry rz ax ay az bx by_ bz cx cy cz s7 s10 s13 s1 s2) by exact (conj T7 (conj T10
  (conj T13 (conj S1 S2)))).
assert (ER : signs_of_edge rx ry rz px py pz ax ay az bx by_ bz cx cy cz s8 s11 s14 s2 s0) by exact (conj T8 (conj T11
  (conj T14 (conj S2 S0)))).
clear S6 S7 S8 S9 S10 S11 S12 S13 S14 T6 T7 T8 T9 T10 T11 T12 T13 T14.
fold (beside s0 s1) (beside s0 s2) (beside s3 s4) (beside s3 s5) (beside s4 s5) (beside s5 s3) (beside s1 s2) (beside
  s2 s0).
fold (known_side s0) (known_side s1) (known_side s2) (known_side s3) (known_side s4) (known_side s5).
fold (on_both_sides s6 s7 s8) (on_both_sides s9 s10 s11) (on_both_sides s12 s13 s14).
fold (on_both_sides s6 s9 s12) (on_both_sides s7 s10 s13) (on_both_sides s8 s11 s14).
fold (on_one_side s6 s7 s8) (on_one_side s9 s10 s11) (on_one_side s12 s13 s14).
fold (on_one_side s6 s9 s12) (on_one_side s7 s10 s13) (on_one_side s8 s11 s14).
set (apart := beside s0 s1 && beside s0 s2 || beside s3 s4 && beside s3 s5).
match goal with |- context [if _ && negb (?c && _) then _ else _] => set (sure := c) end.
(* What planes alone decide. *)
assert (W : apart = true \/ sure = true ->
  Forall finite [ax; ay; az; bx; by_; bz; cx; cy; cz; px; py; pz; qx; qy; qz; rx; ry; rz]).
{ intros W. assert (G : known_side s0 = true /\ known_side s1 = true /\ known_side s2 = true \/
    known_side s3 = true /\ known_side s4 = true /\ known_side s5 = true).
  { destruct W as [W|W].
    - apply orb_prop in W as [[W1 W2]%andb_prop|[W1 W2]%andb_prop]; apply beside_known in W1, W2; tauto.
    - unfold sure in W. apply andb_prop in W as [[[[[G0 G1]%andb_prop G2]%andb_prop _]%andb_prop _]%andb_prop _].
    auto. }
  clear - F0 F1 F2 F3 F4 F5 G. destruct G as [(G0 & G1 & G2)|(G0 & G1 & G2)].
  - apply (sides_finite _ _ _ F0) in G0. apply (sides_finite _ _ _ F1) in G1. apply (sides_finite _ _ _ F2) in G2.
    repeat apply Forall_cons_iff in G0 as [? G0]. repeat apply Forall_cons_iff in G1 as [? G1].
    repeat apply Forall_cons_iff in G2 as [? G2]. repeat constructor; assumption.
  - apply (sides_finite _ _ _ F3) in G0. apply (sides_finite _ _ _ F4) in G1. apply (sides_finite _ _ _ F5) in G2.
    repeat apply Forall_cons_iff in G0 as [? G0]. repeat apply Forall_cons_iff in G1 as [? G1].
    repeat apply Forall_cons_iff in G2 as [? G2]. repeat constructor; assumption. }
assert (NA : apart = true -> forall x y z, ~ in_both ax ay az bx by_ bz cx cy cz px py pz qx qy qz rx ry rz x y z).
{ intros A x y z (i & j & k & l & m & n & M & _).
destruct (heights_cancel _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ M)
    as [Z1 Z2]. destruct M as (WI & WL & _). apply orb_prop in A as [A|A].
  - apply (no_sum _ _ _ _ _ _ WL (beside_signs _ _ _ _ _ _ S0 S1 S2 A)). exact Z1.
  - apply (no_sum _ _ _ _ _ _ WI (beside_signs _ _ _ _ _ _ S3 S4 S5 A)). exact Z2. }
assert (D : sure = true -> apart = false -> known_side s0 = true /\ known_side s1 = true /\ known_side s2 = true /\
  known_side s3 = true /\ known_side s4 = true /\ known_side s5 = true /\
  ~ (volume px py pz qx qy qz rx ry rz ax ay az = volume px py pz qx qy qz rx ry rz bx by_ bz /\
     volume px py pz qx qy qz rx ry rz bx by_ bz = volume px py pz qx qy qz rx ry rz cx cy cz)).
{ intros K A. unfold sure in K. repeat apply andb_prop in K as [K ?]. repeat (split; [assumption|]).
  intros [Q1 Q2]. apply orb_false_elim in A as [_ A]. rewrite (equal_beside _ _ _ _ S3 S4) in A; try assumption.
  rewrite (equal_beside _ _ _ _ S3 S5) in A; try assumption; [discriminate A|]. exact (eq_trans Q1 Q2). }
clear F0 F1 F2 F3 F4 F5. clearbody apart sure. destruct (others && negb (sure && negb apart)).
{ intros K. split; [auto|]. split; [discriminate|auto]. }
intros K. split.
{ apply orb_prop in K as [K|K]; [auto|]. apply andb_prop in K. tauto. }
destruct apart.
{ split; [|auto]. intros S. apply andb_prop in S as [_ S]. discriminate S. }
rewrite andb_true_r. rewrite orb_false_l in K. apply andb_prop in K as [KS K].
destruct (D KS eq_refl) as (G0 & G1 & G2 & G3 & G4 & G5 & N). clear D W NA KS.
assert (P := known_nonzero _ _ S0 G0). change (volume ax ay az bx by_ bz cx cy cz px py pz <> 0) in P.
split; intros S.
- assert (X : forall i j k l m n, meeting ax ay az bx by_ bz cx cy cz px py pz qx qy qz rx ry rz i j k l m n ->
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
    destruct Y as (f & O & F). exact (crossing_in_a_segment _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ f M O P N
      F). }
  clear K N P S0 S1 S2 S3 S4 S5.
  assert (C : forall p1 p2 p3 q1 q2 q3 a1 a2 a3 b1 b2 b3 c1 c2 c3 t u v w,
    common (fun t => 0 <= t <= 1) p1 p2 p3 (q1 - p1) (q2 - p2) (q3 - p3) a1 a2 a3 b1 b2 b3 c1 c2 c3 t u v w ->
    weights u v w /\ (1 - t) * p1 + t * q1 = u * a1 + v * b1 + w * c1 /\
    (1 - t) * p2 + t * q2 = u * a2 + v * b2 + w * c2 /\ (1 - t) * p3 + t * q3 = u * a3 + v * b3 + w * c3).
  { intros * (_ & U & V & W & T & E1 & E2 & E3). repeat split; lra. }
  bools; try discriminate.
  + destruct (edge_crosses _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ EA) as (t & u & v & w & T & U & V & W & M); auto.
    apply C in M as (M & E1 & E2 & E3). apply (X (1 - t) t 0 u v w); [|lra].
    split; [repeat split; lra|]. split; [exact M|]. repeat split; lra.
  + destruct (edge_crosses _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ EP) as (t & u & v & w & T & U & V & W & M); auto.
    apply C in M as (M & E1 & E2 & E3). apply (X u v w (1 - t) t 0); [|lra].
    split; [exact M|]. split; [repeat split; lra|]. repeat split; lra.
  + destruct (edge_crosses _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ EB) as (t & u & v & w & T & U & V & W & M); auto.
    apply C in M as (M & E1 & E2 & E3). apply (X 0 (1 - t) t u v w); [|lra].
    split; [repeat split; lra|]. split; [exact M|]. repeat split; lra.
  + destruct (edge_crosses _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ EQ) as (t & u & v & w & T & U & V & W & M); auto.
    apply C in M as (M & E1 & E2 & E3). apply (X u v w 0 (1 - t) t); [|lra].
    split; [exact M|]. split; [repeat split; lra|]. repeat split; lra.
  + destruct (edge_crosses _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ EC) as (t & u & v & w & T & U & V & W & M); auto.
    apply C in M as (M & E1 & E2 & E3). apply (X t 0 (1 - t) u v w); [|lra].
    split; [repeat split; lra|]. split; [exact M|]. repeat split; lra.
  + destruct (edge_crosses _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ ER) as (t & u & v & w & T & U & V & W & M); auto.
    apply C in M as (M & E1 & E2 & E3). apply (X u v w t 0 (1 - t)); [|lra].
    split; [exact M|]. split; [repeat split; lra|]. repeat split; lra.
- clear P G0 G1 G2 G3 G4 G5 S0 S1 S2 S3 S4 S5. rewrite S, orb_false_l in K.
  repeat match goal with H : _ && _ = true |- _ => apply andb_prop in H as [? ?] end.
  intros x y z (i & j & k & l & m & n & M & _). revert M. apply edges_decide; try assumption; intros t u v w;
    (eapply edge_passes; [first [exact EA|exact EB|exact EC|exact EP|exact EQ|exact ER]|assumption]).
Qed.
