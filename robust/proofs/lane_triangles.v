(* SPDX-License-Identifier: Apache-2.0 *)
(* Segments and rays with triangles in a lane: what the signs of volumes say. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model floats lanes lane_shape_filters lane_faces.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.

(* Of d, with the normal of a plane through a, b and c; the volume of four points. *)
Definition rise ax ay az bx by_ bz cx cy cz dx dy dz :=
  face_exact (bx - ax) (by_ - ay) (bz - az) (cx - ax) (cy - ay) (cz - az) dx dy dz.
Definition volume ax ay az bx by_ bz cx cy cz px py pz :=
  rise ax ay az bx by_ bz cx cy cz (px - ax) (py - ay) (pz - az).

(* The point at t of the line from p along w, with weights of the corners. *)
Definition common (low : R -> Prop) px py pz wx wy wz ax ay az bx by_ bz cx cy cz t i j k :=
  low t /\ 0 <= i /\ 0 <= j /\ 0 <= k /\ i + j + k = 1 /\ px + t * wx = i * ax + j * bx + k * cx /\
  py + t * wy = i * ay + j * by_ + k * cy /\ pz + t * wz = i * az + j * bz + k * cz.

Section Line.
Variables px py pz wx wy wz ax ay az bx by_ bz cx cy cz : R.
Let at_p := volume ax ay az bx by_ bz cx cy cz px py pz.
Let along := rise ax ay az bx by_ bz cx cy cz wx wy wz.
(* Of the line with each edge. *)
Let ab := rise px py pz ax ay az bx by_ bz wx wy wz.
Let bc := rise px py pz bx by_ bz cx cy cz wx wy wz.
Let ca := rise px py pz cx cy cz ax ay az wx wy wz.

Lemma edges_sum : ab + bc + ca = along.
Proof. unfold ab, bc, ca, along, rise, face_exact. ring. Qed.
Lemma crossing_x : along * px - at_p * wx = bc * ax + ca * bx + ab * cx.
Proof. unfold ab, bc, ca, along, at_p, volume, rise, face_exact. ring. Qed.
Lemma crossing_y : along * py - at_p * wy = bc * ay + ca * by_ + ab * cy.
Proof. unfold ab, bc, ca, along, at_p, volume, rise, face_exact. ring. Qed.
Lemma crossing_z : along * pz - at_p * wz = bc * az + ca * bz + ab * cz.
Proof. unfold ab, bc, ca, along, at_p, volume, rise, face_exact. ring. Qed.

Variable low : R -> Prop.
Notation is_common := (common low px py pz wx wy wz ax ay az bx by_ bz cx cy cz).

(* In the plane, and of the weights two products for each corner. *)
Lemma common_in_plane t i j k : is_common t i j k -> at_p + t * along = 0.
Proof.
intros (_ & _ & _ & _ & S & X & Y & Z). assert (K : k = 1 - i - j) by lra. subst k.
replace (at_p + t * along) with (rise ax ay az bx by_ bz cx cy cz (px + t * wx - ax) (py + t * wy - ay)
    (pz + t * wz - az))
  by (unfold at_p, along, volume, rise, face_exact; ring).
rewrite X, Y, Z. unfold rise, face_exact. ring.
Qed.
Lemma common_weights t i j k : is_common t i j k -> i * ab = k * bc /\ j * bc = i * ca /\ k * ca = j * ab.
Proof.
intros (_ & _ & _ & _ & S & X & Y & Z).
assert (UX : i * (ax - px) + j * (bx - px) + k * (cx - px) = t * wx).
{ replace (t * wx) with (i * ax + j * bx + k * cx - (i + j + k) * px) by (rewrite S; lra). ring. }
assert (UY : i * (ay - py) + j * (by_ - py) + k * (cy - py) = t * wy).
{ replace (t * wy) with (i * ay + j * by_ + k * cy - (i + j + k) * py) by (rewrite S; lra). ring. }
assert (UZ : i * (az - pz) + j * (bz - pz) + k * (cz - pz) = t * wz).
{ replace (t * wz) with (i * az + j * bz + k * cz - (i + j + k) * pz) by (rewrite S; lra). ring. }
assert (V : forall x y z, face_exact (i * (ax - px) + j * (bx - px) + k * (cx - px))
  (i * (ay - py) + j * (by_ - py) + k * (cy - py)) (i * (az - pz) + j * (bz - pz) + k * (cz - pz)) x y z wx wy wz = 0).
{ intros. rewrite UX, UY, UZ. unfold face_exact. ring. }
repeat split; apply Rminus_diag_uniq.
- rewrite <- (V (bx - px) (by_ - py) (bz - pz)). unfold ab, bc, rise, face_exact. ring.
- rewrite <- (V (cx - px) (cy - py) (cz - pz)). unfold bc, ca, rise, face_exact. ring.
- rewrite <- (V (ax - px) (ay - py) (az - pz)). unfold ca, ab, rise, face_exact. ring.
Qed.

(* Two edges on different sides of the line: nothing is common. *)
Lemma outside_says t i j k : (ab > 0 \/ bc > 0 \/ ca > 0) -> (ab < 0 \/ bc < 0 \/ ca < 0) -> ~ is_common t i j k.
Proof.
intros P N C. destruct (common_weights t i j k C) as (A & B & D). destruct C as (_ & I & J & K & S & _).
assert (Q : forall x y s r, 0 <= x -> 0 <= y -> x * s = y * r -> s > 0 -> r < 0 -> x = 0 /\ y = 0).
{ intros x y s r X Y E G L. assert (0 <= x * s) by nra. assert (y * r <= 0) by nra.
  split; [destruct (Rmult_integral x s); lra|destruct (Rmult_integral y r); lra]. }
destruct P as [P|[P|P]], N as [N|[N|N]]; try lra.
- destruct (Q i k ab bc I K A P N) as [-> ->]. assert (j = 1) as -> by lra. lra.
- destruct (Q j k ab ca J K) as [-> ->]; try lra. assert (i = 1) as -> by lra. lra.
- destruct (Q k i bc ab K I) as [-> ->]; try lra. assert (j = 1) as -> by lra. lra.
- destruct (Q j i bc ca J I) as [-> ->]; try lra. assert (k = 1) as -> by lra. lra.
- destruct (Q k j ca ab K J) as [-> ->]; try lra. assert (i = 1) as -> by lra. lra.
- destruct (Q i j ca bc I J) as [-> ->]; try lra. assert (k = 1) as -> by lra. lra.
Qed.

(* All three on one side, and the line crosses the plane at t: that point is common, and no other. *)
Lemma inside_says t : (ab > 0 /\ bc > 0 /\ ca > 0) \/ (ab < 0 /\ bc < 0 /\ ca < 0) -> at_p + t * along = 0 -> low t ->
  (exists i j k, 0 < i /\ 0 < j /\ 0 < k /\ is_common t i j k) /\ forall t' i j k, is_common t' i j k -> t' = t.
Proof.
intros E T L. pose proof edges_sum as S. assert (N : along <> 0) by lra. split.
- assert (H : at_p = - t * along) by lra.
  assert (W : forall x, (0 < along -> 0 < x) -> (along < 0 -> x < 0) -> 0 < x / along).
  { intros x P M. unfold Rdiv. destruct (Rtotal_order along 0) as [Q|[Q|Q]]; [|lra|].
    - rewrite <- (Rmult_opp_opp x). apply Rmult_lt_0_compat; [specialize (M Q); lra|].
      pose proof (Rinv_lt_0_compat _ Q). lra.
    - apply Rmult_lt_0_compat; [exact (P Q)|now apply Rinv_0_lt_compat]. }
  exists (bc / along), (ca / along), (ab / along).
  assert (I : 0 < bc / along) by (apply W; lra). assert (J : 0 < ca / along) by (apply W; lra).
  assert (K : 0 < ab / along) by (apply W; lra). split; [exact I|]. split; [exact J|]. split; [exact K|].
  split; [exact L|]. split; [lra|]. split; [lra|]. split; [lra|].
  assert (M : forall x w a b c, along * x - at_p * w = bc * a + ca * b + ab * c ->
    x + t * w = bc / along * a + ca / along * b + ab / along * c).
  { intros x w a b c Q. rewrite H in Q. replace (bc / along * a + ca / along * b + ab / along * c) with
      ((bc * a + ca * b + ab * c) / along) by (field; exact N). rewrite <- Q. field. exact N. }
  split; [rewrite <- S; field; lra|]. auto using crossing_x, crossing_y, crossing_z.
- intros t' i j k C. apply common_in_plane in C. apply Rmult_eq_reg_r with along; [lra|exact N].
Qed.
End Line.

Definition sign_at s (b c : bool) := (b = true -> s > 0) /\ (c = true -> s < 0).
Lemma sides_sign known arguments exact : sides_right known arguments exact -> sign_at exact (fst known) (snd known).
Proof. intros [P N]. split; intros K; [now apply P|now apply N]. Qed.
Lemma sides_finite known arguments exact : sides_right known arguments exact ->
  fst known || snd known = true -> Forall finite arguments.
Proof. intros [P N] [K|K]%orb_prop; [now apply P|now apply N]. Qed.

(* The decision, of the signs alone: at_p and the direction's, or the other end's. *)
Ltac bools := repeat match goal with
  | H : _ && _ = true |- _ => apply andb_prop in H as [? ?]
  | H : _ || _ = true |- _ => apply orb_prop in H as [?|?]
  | H : negb _ = true |- _ => apply negb_true_iff in H end.
Ltac signs_of := repeat match goal with S : sign_at _ ?b ?c, H : ?b = true |- _ => apply (proj1 S) in H
  | S : sign_at _ ?b ?c, H : ?c = true |- _ => apply (proj2 S) in H end.

(* Where it answers none, no point of the segment is in the triangle; where a point, exactly one is, inside of both. *)
Theorem lane_segment_triangle_right fused (px py pz qx qy qz ax ay az bx by_ bz cx cy cz : float) :
  let '(known, set) := lane_segment_triangle fused px py pz qx qy qz ax ay az bx by_ bz cx cy cz in
  let is_common := common (fun t => 0 <= t <= 1) px py pz (qx - px) (qy - py) (qz - pz) ax ay az bx by_ bz cx cy cz in
  known = true -> Forall finite [px; py; pz; qx; qy; qz; ax; ay; az; bx; by_; bz; cx; cy; cz] /\
  (set = true -> exists t, 0 < t < 1 /\ (exists i j k, 0 < i /\ 0 < j /\ 0 < k /\ is_common t i j k) /\
    forall t' i j k, is_common t' i j k -> t' = t) /\
  (set = false -> forall t i j k, ~ is_common t i j k).
Proof.
cbv beta zeta delta [lane_segment_triangle].
assert (SP := lane_face_side_right fused ax ay az bx by_ bz cx cy cz px py pz).
assert (SQ := lane_face_side_right fused ax ay az bx by_ bz cx cy cz qx qy qz).
assert (AB := sides_sign _ _ _ (lane_face_side_right fused px py pz qx qy qz ax ay az bx by_ bz)).
assert (BC := sides_sign _ _ _ (lane_face_side_right fused px py pz qx qy qz bx by_ bz cx cy cz)).
assert (CA := sides_sign _ _ _ (lane_face_side_right fused px py pz qx qy qz cx cy cz ax ay az)).
set (at_p := lane_face_side fused ax ay az bx by_ bz cx cy cz px py pz) in *.
set (at_q := lane_face_side fused ax ay az bx by_ bz cx cy cz qx qy qz) in *.
set (ab := lane_face_side fused px py pz qx qy qz ax ay az bx by_ bz) in *.
set (bc := lane_face_side fused px py pz qx qy qz bx by_ bz cx cy cz) in *.
set (ca := lane_face_side fused px py pz qx qy qz cx cy cz ax ay az) in *.
intros [[KP KQ]%andb_prop K]%andb_prop.
assert (FP := sides_finite _ _ _ SP KP). assert (FQ := sides_finite _ _ _ SQ KQ).
apply sides_sign in SP, SQ. clearbody at_p at_q ab bc ca.
set (vp := volume ax ay az bx by_ bz cx cy cz px py pz). change (sign_at vp (fst at_p) (snd at_p)) in SP.
set (along := rise ax ay az bx by_ bz cx cy cz (qx - px) (qy - py) (qz - pz)).
assert (EQ : face_exact (bx - ax) (by_ - ay) (bz - az) (cx - ax) (cy - ay) (cz - az) (qx - ax) (qy - ay) (qz - az) =
  vp + along) by (unfold vp, along, volume, rise, face_exact; ring). rewrite EQ in SQ. clear EQ.
assert (EQ : forall ax ay az bx by_ bz, face_exact (qx - px) (qy - py) (qz - pz) (ax - px) (ay - py) (az - pz) (bx - px)
  (by_ - py) (bz - pz) = rise px py pz ax ay az bx by_ bz (qx - px) (qy - py) (qz - pz))
  by (intros; unfold rise, face_exact; ring). rewrite EQ in AB, BC, CA. clear EQ.
split.
{ repeat apply Forall_cons_iff in FP as [? FP]. repeat apply Forall_cons_iff in FQ as [? FQ].
  repeat constructor; assumption. }
split.
- intros [I A]%andb_prop. apply negb_true_iff, orb_false_elim in A as [A1 A2].
  assert (T : exists t, 0 < t < 1 /\ vp + t * along = 0).
  { assert (O : (vp > 0 /\ vp + along < 0) \/ (vp < 0 /\ vp + along > 0)).
    { clear - KP KQ A1 A2 SP SQ. destruct (fst at_p), (snd at_p), (fst at_q), (snd at_q); try discriminate;
      destruct SP, SQ;
      intuition lra. }
    exists (vp / - along). assert (along <> 0) by lra. split; [|field; assumption].
    destruct O as [[O1 O2]|[O1 O2]].
    - split; [apply Rdiv_lt_0_compat; lra|]. apply Rmult_lt_reg_r with (- along); [lra|]. field_simplify; lra.
    - replace (vp / - along) with (- vp / along) by (field; assumption).
      split; [apply Rdiv_lt_0_compat; lra|]. apply Rmult_lt_reg_r with along; [lra|]. field_simplify; lra. }
  destruct T as (t & T & Z). exists t. split; [exact T|]. apply inside_says; [|exact Z|lra].
  bools; signs_of; auto.
- intros N t i j k C. pose proof (common_in_plane _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ C) as Z.
  fold vp along in Z. assert (T : 0 <= t <= 1) by apply C.
  assert (A : (fst at_p && fst at_q) || (snd at_p && snd at_q) = true -> False).
  { intros A. destruct (Rle_or_lt 0 along) as [M|M]; bools; signs_of; nra. }
  assert (O : (fst ab || fst bc || fst ca) && (snd ab || snd bc || snd ca) = true -> False).
  { intros [O1 O2]%andb_prop. apply (outside_says _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ t i j k) in C; [exact C| |];
      [clear O2|clear O1]; bools; signs_of; auto. }
  apply andb_false_iff in N as [N|N].
  + rewrite N, orb_false_r in K. apply orb_prop in K as [K|K]; auto.
  + apply negb_false_iff in N. auto.
Qed.

(* The same of a ray, which has an origin and a direction; the direction is not 0. *)
Theorem lane_ray_triangle_right fused (px py pz wx wy wz ax ay az bx by_ bz cx cy cz : float) :
  let '(known, set) := lane_ray_triangle fused px py pz wx wy wz ax ay az bx by_ bz cx cy cz in
  let is_common := common (fun t => 0 <= t) px py pz wx wy wz ax ay az bx by_ bz cx cy cz in
  known = true -> Forall finite [px; py; pz; wx; wy; wz; ax; ay; az; bx; by_; bz; cx; cy; cz] /\
  ~ (value wx = 0 /\ value wy = 0 /\ value wz = 0) /\
  (set = true -> exists t, 0 < t /\ (exists i j k, 0 < i /\ 0 < j /\ 0 < k /\ is_common t i j k) /\
    forall t' i j k, is_common t' i j k -> t' = t) /\
  (set = false -> forall t i j k, ~ is_common t i j k).
Proof.
cbv beta zeta delta [lane_ray_triangle].
assert (SP := lane_face_side_right fused ax ay az bx by_ bz cx cy cz px py pz).
assert (SW := lane_face_leading_right fused ax ay az bx by_ bz cx cy cz wx wy wz).
assert (AB := sides_sign _ _ _ (lane_face_leading_right fused px py pz ax ay az bx by_ bz wx wy wz)).
assert (BC := sides_sign _ _ _ (lane_face_leading_right fused px py pz bx by_ bz cx cy cz wx wy wz)).
assert (CA := sides_sign _ _ _ (lane_face_leading_right fused px py pz cx cy cz ax ay az wx wy wz)).
set (at_p := lane_face_side fused ax ay az bx by_ bz cx cy cz px py pz) in *.
set (at_w := lane_face_leading fused ax ay az bx by_ bz cx cy cz wx wy wz) in *.
set (ab := lane_face_leading fused px py pz ax ay az bx by_ bz wx wy wz) in *.
set (bc := lane_face_leading fused px py pz bx by_ bz cx cy cz wx wy wz) in *.
set (ca := lane_face_leading fused px py pz cx cy cz ax ay az wx wy wz) in *.
intros [[KP KW]%andb_prop K]%andb_prop.
assert (FP := sides_finite _ _ _ SP KP). assert (FW := sides_finite _ _ _ SW KW).
apply sides_sign in SP, SW. clearbody at_p at_w ab bc ca.
set (vp := volume ax ay az bx by_ bz cx cy cz px py pz). change (sign_at vp (fst at_p) (snd at_p)) in SP.
set (along := rise ax ay az bx by_ bz cx cy cz wx wy wz). change (sign_at along (fst at_w) (snd at_w)) in SW.
split.
{ repeat apply Forall_cons_iff in FP as [? FP]. repeat apply Forall_cons_iff in FW as [? FW].
  repeat constructor; assumption. }
split.
{ intros (Z1 & Z2 & Z3).
  assert (Z : along = 0) by (unfold along; rewrite Z1, Z2, Z3; unfold rise, face_exact; ring).
  bools; signs_of; lra. }
split.
- intros [I A]%andb_prop. apply negb_true_iff, orb_false_elim in A as [A1 A2].
  assert (T : exists t, 0 < t /\ vp + t * along = 0).
  { assert (O : (vp > 0 /\ along < 0) \/ (vp < 0 /\ along > 0)).
    { clear - KP KW A1 A2 SP SW. destruct (fst at_p), (snd at_p), (fst at_w), (snd at_w); try discriminate;
      destruct SP, SW;
      intuition lra. }
    exists (vp / - along). assert (along <> 0) by lra. split; [|field; assumption].
    destruct O as [[O1 O2]|[O1 O2]]; [apply Rdiv_lt_0_compat; lra|].
    replace (vp / - along) with (- vp / along) by (field; assumption). apply Rdiv_lt_0_compat; lra. }
  destruct T as (t & T & Z). exists t. split; [exact T|]. apply inside_says; [|exact Z|lra].
  bools; signs_of; auto.
- intros N t i j k C. pose proof (common_in_plane _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ C) as Z.
  fold vp along in Z. assert (T : 0 <= t) by apply C.
  assert (A : (fst at_p && fst at_w) || (snd at_p && snd at_w) = true -> False).
  { intros A. bools; signs_of; nra. }
  assert (O : (fst ab || fst bc || fst ca) && (snd ab || snd bc || snd ca) = true -> False).
  { intros [O1 O2]%andb_prop. apply (outside_says _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ t i j k) in C; [exact C| |];
      [clear O2|clear O1]; bools; signs_of; auto. }
  apply andb_false_iff in N as [N|N].
  + rewrite N, orb_false_r in K. apply orb_prop in K as [K|K]; auto.
  + apply negb_false_iff in N. auto.
Qed.
