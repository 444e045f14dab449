(* SPDX-License-Identifier: Apache-2.0 *)
(* Linear functions in a lane: the turn of an edge, the side of a face, the box and the error that all share. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model constants steps format floats ghost lanes.
From Filters Require Import lane_bounds lane_turns lane_values lane_sums lane_boxes lane_faces lane_beside lane_linear.
From Filters Require Import lane_shape_filters lane_linear_filters.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.
#[local] Existing Instances p53 fexp_valid below_1024.

Lemma up_not_below s t : up t -> not_below s t = true -> up s.
Proof.
unfold not_below. destruct (finite_case t) as [T|[->|[->| ->]]], (finite_case s) as [S|[->|[->| ->]]]; intros U N;
  try exact I; try reflexivity; try discriminate; try (now destruct s); try (now destruct t).
apply up_finite; [exact S|]. apply up_value in U. apply (not_below_finite _ _ S T) in N. lra.
Qed.
Lemma up_error s : up s -> up (error_of s).
Proof. intros U. apply up_bound; [ups|lia]. Qed.
Ltac boxed := match goal with
  | H : _ || _ = false |- _ => apply orb_false_iff in H as [? H]; boxed
  | _ => idtac end.

Definition line_error (o0 o1 g0 g1 : float) : float := lane_error_of_linear (lane_size_of_lines o0 o1 g0 g1).
Definition line_value fused (o0 o1 a0 a1 b0 b1 d0 d1 : float) : float :=
  let '(n0, n1, n2) := lane_line_numbers a0 a1 b0 b1 o0 o1 in lane_linear_2 fused n0 n1 n2 d0 d1.

(* Of an edge and a point in the box: where the value exceeds the error, the numbers are finite and the turn has its
   sign; where numbers and error are finite, so is the value. *)
Theorem lane_line_right fused (o0 o1 g0 g1 a0 a1 b0 b1 p0 p1 : float) :
  in_box o0 g0 a0 -> in_box o1 g1 a1 -> in_box o0 g0 b0 -> in_box o1 g1 b1 ->
  let '(beyond, d0, d1) := lane_framed_2 o0 o1 g0 g1 p0 p1 in
  let z := line_value fused o0 o1 a0 a1 b0 b1 d0 d1 in
  let error := line_error o0 o1 g0 g1 in
  beyond = false ->
  certain (above (size z) error) (negative_lane z) [o0; o1; g0; g1; a0; a1; b0; b1; p0; p1]
    (turn a0 a1 b0 b1 p0 p1) /\
  (finite error -> Forall finite [a0; a1; b0; b1; p0; p1] -> finite z).
Proof.
intros A0 A1 B0 B1. cbv beta zeta delta [lane_framed_2]. intros BE. simpl orb in BE.
apply orb_false_iff in BE as [[P0 Q0]%orb_false_iff [P1 Q1]%orb_false_iff].
assert (W := fun KAX KAY KBX KBY KPX KPY => line_of_coordinates fused o0 o1 g0 g1 a0 a1 b0 b1 p0 p1
  KAX KAY KBX KBY KPX KPY A0 A1 B0 B1 (conj P0 Q0) (conj P1 Q1)).
change (line_error o0 o1 g0 g1) with (error_of (times (minus g0 o0) (minus g1 o1))).
set (s := times (minus g0 o0) (minus g1 o1)) in *.
match type of W with _ -> _ -> _ -> _ -> _ -> _ -> _ -> Forall finite [_; _; _; _; _; _; _; _; _; _; ?x] /\ _ =>
  change (line_value fused o0 o1 a0 a1 b0 b1 (minus p0 o0) (minus p1 o1)) with x; set (z := x) in * end.
split.
- intros A. assert (K := known_above _ _ A). unfold z in K. knowns.
  assert (U : up s) by (apply up_times; [now apply (up_extent _ _ a0)|now apply (up_extent _ _ a1)]).
  assert (FE := above_bound _ _ A (up_error _ U)).
  destruct W as [F S]; try assumption. split; [|now apply S].
  repeat apply Forall_cons_iff in F as [? F]. repeat constructor; assumption.
- intros FE F. repeat apply Forall_cons_iff in F as [? F].
  assert (KF : forall x : float, finite x -> known x) by (now intros []).
  destruct W as [F' _]; auto. repeat apply Forall_cons_iff in F' as [? F']. assumption.
Qed.

Definition plane_size (a0 a1 a2 b0 b1 b2 c0 c1 c2 o o0 o1 o2 g0 g1 g2 : float) : float :=
  let '(_, _, _, _, _, _, t0, t1, t2) := lane_plane_numbers a0 a1 a2 b0 b1 b2 c0 c1 c2 o in
  lane_size_of_plane t0 t1 t2 o0 o1 o2 g0 g1 g2.
Definition plane_value fused (a0 a1 a2 b0 b1 b2 c0 c1 c2 o o0 o1 o2 d0 d1 d2 : float) : float :=
  let '(x0, x1, x2, y0, y1, y2, _, _, _) := lane_plane_numbers a0 a1 a2 b0 b1 b2 c0 c1 c2 o in
  let '(n0, n1, n2, n3) := lane_plane_function x0 x1 x2 y0 y1 y2 o0 o1 o2 in
  lane_linear_3 fused n0 n1 n2 n3 d0 d1 d2.
Definition volume (a0 a1 a2 b0 b1 b2 c0 c1 c2 p0 p1 p2 : R) :=
  face_exact (b0 - a0) (b1 - a1) (b2 - a2) (c0 - a0) (c1 - a1) (c2 - a2) (p0 - a0) (p1 - a1) (p2 - a2).

(* The same of a face, outwards: o is 1 or -1. The size s is that of the face at least. *)
Theorem lane_plane_right fused (a0 a1 a2 b0 b1 b2 c0 c1 c2 o s o0 o1 o2 g0 g1 g2 p0 p1 p2 : float) :
  finite o -> value o = 1 \/ value o = -1 -> in_box o0 g0 a0 -> in_box o1 g1 a1 -> in_box o2 g2 a2 ->
  not_below s (plane_size a0 a1 a2 b0 b1 b2 c0 c1 c2 o o0 o1 o2 g0 g1 g2) = true ->
  let '(beyond, d0, d1, d2) := lane_framed_3 o0 o1 o2 g0 g1 g2 p0 p1 p2 in
  let z := plane_value fused a0 a1 a2 b0 b1 b2 c0 c1 c2 o o0 o1 o2 d0 d1 d2 in
  let error := lane_error_of_linear s in
  beyond = false ->
  certain (above (size z) error) (negative_lane z) [a0; a1; a2; b0; b1; b2; c0; c1; c2; p0; p1; p2]
    (o * volume a0 a1 a2 b0 b1 b2 c0 c1 c2 p0 p1 p2) /\
  (finite error -> Forall finite [a0; a1; a2; p0; p1; p2] -> finite z).
Proof.
intros FO O A0 A1 A2 SO. cbv beta zeta delta [lane_framed_3]. intros BE. simpl orb in BE.
apply orb_false_iff in BE as [[[P0 Q0]%orb_false_iff [P1 Q1]%orb_false_iff]%orb_false_iff [P2 Q2]%orb_false_iff].
change (lane_error_of_linear s) with (error_of s).
unfold plane_size, plane_value, lane_plane_numbers, lane_size_of_plane, lane_plane_function, lane_linear_3 in *.
cbv beta zeta in *.
set (s1 := minus b0 a0) in *. set (s2 := minus b1 a1) in *. set (s3 := minus b2 a2) in *.
set (t1 := minus c0 a0) in *. set (t2 := minus c1 a1) in *. set (t3 := minus c2 a2) in *.
change (plus (plus (size (times s2 t3)) (size (times s3 t2))) small) with (terms_of s2 t3 s3 t2) in SO.
change (plus (plus (size (times s3 t1)) (size (times s1 t3))) small) with (terms_of s3 t1 s1 t3) in SO.
change (plus (plus (size (times s1 t2)) (size (times s2 t1))) small) with (terms_of s1 t2 s2 t1) in SO.
change (minus (times s2 t3) (times s3 t2)) with (difference_of s2 t3 s3 t2).
change (minus (times s3 t1) (times s1 t3)) with (difference_of s3 t1 s1 t3).
change (minus (times s1 t2) (times s2 t1)) with (difference_of s1 t2 s2 t1).
assert (UT : forall p q r w, up (terms_of p q r w)) by exact up_terms.
set (own := plus (plus _ _) _) in SO.
(* the coordinates of the normal, where they are finite *)
assert (N : forall x y : float, finite (minus x y) -> near (minus x y) (x - y)) by (intros; now apply near_difference).
assert (C : forall b c a b' c' a' : float, let p := minus b a in let q := minus c' a' in let r := minus b' a' in
  let w := minus c a in
  coordinate (times o (difference_of p q r w)) (terms_of p q r w)
    (o * ((b - a) * (c' - a') - (b' - a') * (c - a)))
    (total_of (b - a) (c' - a') (b' - a') (c - a))).
{ intros b c a b' c' a'. cbv zeta. apply coordinate_outwards; [assumption..|]. split; [apply up_terms|]. intros F.
  assert (F' := F). unfold terms_of in F'. finites. apply coordinate_says; auto. }
assert (W := fun KA0 KA1 KA2 KP0 KP1 KP2 FE => plane_of_coordinates fused o0 o1 o2 g0 g1 g2 a0 a1 a2 p0 p1 p2
  _ _ _ _ _ _ s _ _ _ _ _ _ (C b1 c1 a1 b2 c2 a2) (C b2 c2 a2 b0 c0 a0) (C b0 c0 a0 b1 c1 a1)
  KA0 KA1 KA2 KP0 KP1 KP2 A0 A1 A2 (conj P0 Q0) (conj P1 Q1) (conj P2 Q2) SO FE).
cbv zeta in W. change (minus b0 a0) with s1 in W. change (minus b1 a1) with s2 in W. change (minus b2 a2) with s3 in W.
change (minus c0 a0) with t1 in W. change (minus c1 a1) with t2 in W. change (minus c2 a2) with t3 in W.
match goal with |- certain (above (size ?x) _) _ _ _ /\ _ => set (z := x) in * end.
split.
- intros A. assert (K := known_above _ _ A). unfold z in K. knowns.
  assert (UO : up own).
  { unfold own. ups; try apply UT; [apply (up_extent _ _ a0)|apply (up_extent _ _ a1)|apply (up_extent _ _ a2)];
    assumption. }
  assert (FE := above_bound _ _ A (up_error _ (up_not_below _ _ UO SO))).
  destruct W as [F S]; try assumption. split.
  + repeat apply Forall_cons_iff in F as [? F]. unfold own, terms_of, s1, s2, s3, t1, t2, t3 in *. finites.
    repeat constructor; assumption.
  + replace (o * volume a0 a1 a2 b0 b1 b2 c0 c1 c2 p0 p1 p2) with
      (o * ((b1 - a1) * (c2 - a2) - (b2 - a2) * (c1 - a1)) * (p0 - a0) +
       o * ((b2 - a2) * (c0 - a0) - (b0 - a0) * (c2 - a2)) * (p1 - a1) +
       o * ((b0 - a0) * (c1 - a1) - (b1 - a1) * (c0 - a0)) * (p2 - a2)) by (unfold volume, face_exact; ring).
    exact (S A).
- intros FE F. repeat apply Forall_cons_iff in F as [? F].
  assert (KF : forall x : float, finite x -> known x) by (now intros []).
  destruct W as [F' _]; auto. repeat apply Forall_cons_iff in F' as [? F']. assumption.
Qed.

(* The box, as it grows. *)
Lemma grown (o g p : float) : finite o -> finite g -> finite p ->
  (finite (lesser p o) /\ lesser p o <= o /\ lesser p o <= p) /\
  (finite (greater_of p g) /\ g <= greater_of p g /\ p <= greater_of p g).
Proof.
intros O G P. destruct (lesser_value _ _ P O) as [FL L], (greater_value _ _ P G) as [FG M].
pose proof (Rmin_l p o). pose proof (Rmin_r p o). pose proof (Rmax_l p g). pose proof (Rmax_r p g).
rewrite L, M. repeat split; assumption.
Qed.
Lemma in_box_of (o g p : float) : finite o -> finite g -> finite p -> o <= p <= g -> in_box o g p.
Proof.
intros O G P L. split; apply not_true_is_false; intros A;
  [apply (above_finite _ _ O P) in A|apply (above_finite _ _ P G) in A]; lra.
Qed.
Definition add_2 '(o0, o1, g0, g1) '(p0, p1) := lane_box_add_2 o0 o1 g0 g1 p0 p1.
Definition box_2 (points : list (float * float)) :=
  match points with [] => (zero, zero, zero, zero) | (x, y) :: _ => fold_left add_2 points (x, y, x, y) end.
Definition finite_2 (p : float * float) := finite (fst p) /\ finite (snd p).
Lemma grown_2 points : Forall finite_2 points -> forall o0 o1 g0 g1,
  finite o0 -> finite o1 -> finite g0 -> finite g1 ->
  let '(l0, l1, m0, m1) := fold_left add_2 points (o0, o1, g0, g1) in
  (finite l0 /\ finite l1 /\ finite m0 /\ finite m1) /\ (l0 <= o0 /\ l1 <= o1 /\ g0 <= m0 /\ g1 <= m1) /\
  Forall (fun p : float * float => l0 <= value (fst p) <= m0 /\ l1 <= value (snd p) <= m1) points.
Proof.
induction 1 as [|[p0 p1] points [P0 P1] _ IH]; intros o0 o1 g0 g1 O0 O1 G0 G1; simpl fold_left.
- repeat split; try assumption; try apply Rle_refl. constructor.
- cbn [fst snd] in P0, P1. destruct (grown _ _ _ O0 G0 P0) as [(F0 & A0 & B0) (F1 & A1 & B1)].
  destruct (grown _ _ _ O1 G1 P1) as [(F2 & A2 & B2) (F3 & A3 & B3)].
  specialize (IH _ _ _ _ F0 F2 F1 F3). destruct (fold_left add_2 points _) as [[[l0 l1] m0] m1].
  destruct IH as (F & (L0 & L1 & M0 & M1) & All). split; [exact F|]. split; [repeat split; lra|].
  constructor; [cbn [fst snd]; repeat split; lra|exact All].
Qed.
Lemma box_2_right points : Forall finite_2 points -> let '(o0, o1, g0, g1) := box_2 points in
  Forall (fun p => in_box o0 g0 (fst p) /\ in_box o1 g1 (snd p)) points.
Proof.
intros F. destruct points as [|[x y] points]; [constructor|]. unfold box_2.
assert (F' := F). apply Forall_inv in F' as [X Y]. simpl in X, Y. assert (G := grown_2 _ F x y x y X Y X Y).
destruct (fold_left add_2 _ _) as [[[o0 o1] g0] g1]. destruct G as ((O0 & O1 & G0 & G1) & _ & All).
rewrite Forall_forall in *. intros p I. destruct (F p I), (All p I). split; now apply in_box_of.
Qed.

Definition add_3 '(o0, o1, o2, g0, g1, g2) '(p0, p1, p2) := lane_box_add_3 o0 o1 o2 g0 g1 g2 p0 p1 p2.
Definition box_3 (points : list (float * float * float)) := match points with
  | [] => (zero, zero, zero, zero, zero, zero)
  | (x, y, z) :: _ => fold_left add_3 points (x, y, z, x, y, z) end.
Definition finite_3 (p : float * float * float) := let '(x, y, z) := p in finite x /\ finite y /\ finite z.
Lemma grown_3 points : Forall finite_3 points -> forall o0 o1 o2 g0 g1 g2,
  finite o0 -> finite o1 -> finite o2 -> finite g0 -> finite g1 -> finite g2 ->
  let '(l0, l1, l2, m0, m1, m2) := fold_left add_3 points (o0, o1, o2, g0, g1, g2) in
  (finite l0 /\ finite l1 /\ finite l2 /\ finite m0 /\ finite m1 /\ finite m2) /\
  (l0 <= o0 /\ l1 <= o1 /\ l2 <= o2 /\ g0 <= m0 /\ g1 <= m1 /\ g2 <= m2) /\
  Forall (fun '(p0, p1, p2) => l0 <= value p0 <= m0 /\ l1 <= value p1 <= m1 /\ l2 <= value p2 <= m2) points.
Proof.
induction 1 as [|[[p0 p1] p2] points (P0 & P1 & P2) _ IH]; intros o0 o1 o2 g0 g1 g2 O0 O1 O2 G0 G1 G2;
  simpl fold_left.
- repeat split; try assumption; try apply Rle_refl. constructor.
- destruct (grown _ _ _ O0 G0 P0) as [(F0 & A0 & B0) (F1 & A1 & B1)].
  destruct (grown _ _ _ O1 G1 P1) as [(F2 & A2 & B2) (F3 & A3 & B3)].
  destruct (grown _ _ _ O2 G2 P2) as [(F4 & A4 & B4) (F5 & A5 & B5)].
  specialize (IH _ _ _ _ _ _ F0 F2 F4 F1 F3 F5). destruct (fold_left add_3 points _) as [[[[[l0 l1] l2] m0] m1] m2].
  destruct IH as (F & (L0 & L1 & L2 & M0 & M1 & M2) & All). split; [exact F|]. split; [repeat split; lra|].
  constructor; [repeat split; lra|exact All].
Qed.
Lemma box_3_right points : Forall finite_3 points -> let '(o0, o1, o2, g0, g1, g2) := box_3 points in
  Forall (fun '(p0, p1, p2) => in_box o0 g0 p0 /\ in_box o1 g1 p1 /\ in_box o2 g2 p2) points.
Proof.
intros F. destruct points as [|[[x y] z] points]; [constructor|]. unfold box_3.
assert (F' := F). apply Forall_inv in F' as (X & Y & Z). assert (G := grown_3 _ F x y z x y z X Y Z X Y Z).
destruct (fold_left add_3 _ _) as [[[[[o0 o1] o2] g0] g1] g2].
destruct G as ((O0 & O1 & O2 & G0 & G1 & G2) & _ & All). rewrite Forall_forall in *.
intros [[p0 p1] p2] I. destruct (F _ I) as (? & ? & ?), (All _ I) as (? & ? & ?).
split; [|split]; now apply in_box_of.
Qed.

(* The greatest size; infinite where one of them is NaN. *)
Lemma greater_size_says s t : known s -> up s -> let r := lane_greater_size s t in
  known r /\ up r /\ (finite r -> finite s /\ s <= r /\ not_below r t = true).
Proof.
intros K U r. unfold r, lane_greater_size, lesser, greater_of. clear r.
assert (I : above infinity t = true -> t = B754_infinity true \/ finite t)
  by (destruct (finite_case t) as [T|[->|[->| ->]]]; auto; discriminate).
destruct (above infinity t) eqn:A.
- destruct (finite_case s) as [S|[->|[->| ->]]]; try discriminate K; try discriminate U.
  + destruct (I eq_refl) as [->|T].
    * assert (above (B754_infinity true) s = false) as -> by now destruct s. split; [exact K|]. split; [exact U|].
      intros _. split; [exact S|]. split; [apply Rle_refl|now destruct s].
    * destruct (above t s) eqn:B.
      -- apply (above_finite _ _ T S) in B. split; [now destruct t|].
         split; [apply up_finite; [exact T|]; apply up_value in U; lra|].
         intros _. split; [exact S|]. split; [lra|]. apply (not_below_finite _ _ T T). lra.
      -- split; [exact K|]. split; [exact U|]. intros _. split; [exact S|]. split; [apply Rle_refl|].
         apply (not_below_finite _ _ S T). apply Rnot_lt_le. intros C. apply (above_finite _ _ T S) in C. congruence.
  + assert (above t (B754_infinity false) = false) as ->
      by (destruct (I eq_refl) as [->|T]; [reflexivity|now destruct t]).
    now repeat split.
- destruct (above infinity s) eqn:B; [now repeat split|]. split; [exact K|]. split; [exact U|]. intros S.
  exfalso. now destruct s.
Qed.
Lemma greatest_size ts : forall s, known s -> up s -> let r := fold_left lane_greater_size ts s in
  known r /\ up r /\ (finite r -> finite s /\ s <= r /\ Forall (fun t => not_below r t = true) ts).
Proof.
induction ts as [|t ts IH]; intros s K U; simpl.
- split; [exact K|]. split; [exact U|]. intros F. split; [exact F|]. split; [apply Rle_refl|constructor].
- destruct (greater_size_says s t K U) as (K' & U' & W). destruct (IH _ K' U') as (KR & UR & WR).
  split; [exact KR|]. split; [exact UR|]. intros F. destruct (WR F) as (F' & L & All). destruct (W F') as (S & L' & N).
  split; [exact S|]. split; [lra|]. constructor; [|exact All].
  set (r := fold_left lane_greater_size ts (lane_greater_size s t)) in *. set (m := lane_greater_size s t) in *.
  clearbody r m. destruct (finite_case t) as [T|[->|[->| ->]]].
  + apply (not_below_finite _ _ F T). apply (not_below_finite _ _ F' T) in N. lra.
  + now destruct r.
  + now destruct m.
  + now destruct m.
Qed.
