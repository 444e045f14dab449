(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of points of segments and triangles that are nearest to something. *)
Require Import ZArith List Arith.
From Certificates Require Import solids language formulas_vectors formulas_solids.
Import ListNotations.
Local Open Scope check_scope.

Section checks.
Context {A : Type}.
Notation T := (term A). Notation C := (cond A).

Fixpoint total (w : list A) : T := match w with [] => zero | a :: w' => Leaf a + total w' end.
Fixpoint mixed (n : nat) (w : list A) (points : list (list A)) : list T :=
  match w, points with
  | a :: w', p :: points' => sum_of (scaled (Leaf a) (leaves p)) (mixed n w' points')
  | _, _ => repeat zero n
  end.
Definition are_points (count n : nat) (points : list (list A)) : C :=
  of_length count points /\ all (of_length n) points.
Definition are_weights (w : list A) (points : list (list A)) : C :=
  if_so (length w =? length points) /\ all (fun a => zero <= Leaf a) w /\ total w = one.
(** No way from x to one of the points leads towards y. *)
Definition none_nearer (points : list (list A)) (x y : list T) : C :=
  all (fun p => zero <= inner (difference x y) (difference (leaves p) x)) points.
Definition of_distance (x y : list T) (square distance : A) : C :=
  Leaf square = inner (difference x y) (difference x y) /\ zero <= Leaf distance /\
  Leaf distance * Leaf distance = Leaf square.

Definition closest_point_proves n points (p x : list A) (square distance : A) (w : list A) : C :=
  of_length n p /\ are_weights w points /\ same_vector (leaves x) (mixed n w points) /\
  none_nearer points (mixed n w points) (leaves p) /\ of_distance (leaves p) (mixed n w points) square distance.

(** [closest_point_on_segment], kind [root] *)
Definition check_closest_point_on_segment points (p x : list A) (square distance : A) (w : list A) : C :=
  let n := length p in
  if_so (two_or_three p) /\ are_points 2 n points /\ closest_point_proves n points p x square distance w.

(** [closest_point_on_triangle], kind [root] *)
Definition check_closest_point_on_triangle points (p x : list A) (square distance : A) (w : list A) : C :=
  are_points 3 3 points /\ closest_point_proves 3 points p x square distance w.

(** [segment_segment_distance], kind [root] *)
Definition check_segment_segment_distance (a0 a1 b0 b1 x y : list A) (square distance : A) (on_a on_b : list A) : C :=
  let n := length a0 in
  let a := [a0; a1] in let b := [b0; b1] in let x' := mixed n on_a a in let y' := mixed n on_b b in
  let v := difference (leaves a1) (leaves a0) in let u := difference (leaves b1) (leaves b0) in
  let along := inner v u in
  if_so (two_or_three a0) /\ are_points 2 n a /\ are_points 2 n b /\ are_weights on_a a /\ are_weights on_b b /\
  same_vector (leaves x) x' /\ same_vector (leaves y) y' /\ none_nearer a x' y' /\ none_nearer b y' x' /\
  (along = zero \/ ~ inner v v * inner u u = along * along \/ same_vector x' (leaves a0) \/
   zero < along /\ same_vector y' (leaves b0) \/ along < zero /\ same_vector y' (leaves b1)) /\
  of_distance x' y' square distance.
End checks.
