(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of an oriented box and an axis-aligned one, or a triangle. *)
Require Import ZArith List Arith.
From Certificates Require Import solids language formulas_vectors formulas_solids formulas_nearest formulas_obbs
  formulas_courses.
Import ListNotations.
Local Open Scope check_scope.

Section checks.
Context {A : Type}.
Notation T := (term A). Notation C := (cond A).

Inductive box_facts :=
| past_aabb (n : list A)
| touched_aabb (u n : list A)
| flat_aabb (u : list A) (axis : nat)
| inside_aabb (u : list A).

(** [aabb_obb]: n leads from the axis-aligned box to the other, u are coefficients of the half axes. *)
Definition check_aabb_obb (low high center : list A) (axes : list (list A)) (w : contact) (facts : box_facts) : C :=
  let c := coordinate in
  let gap n := inner (leaves n) (leaves center) - reach (leaves n) axes - highest_of_box n low high in
  let at_axis u k := nth k (placed center axes u) zero in
  let common u := within_one u /\ on_each 3 (fun k => c k low <= at_axis u k /\ at_axis u k <= c k high) in
  is_box 3 low high /\ right_box center axes /\
  match w, facts with
  | disjoint, past_aabb n => of_length 3 n /\ zero < gap n
  | touching, touched_aabb u n => of_length 3 n /\ not_zero n /\ gap n = zero /\ common u
  | touching, flat_aabb u k => if_so (k <? 3) /\ c k low = c k high /\ common u
  | overlapping, inside_aabb u =>
      inside_one u /\ on_each 3 (fun k => c k low < at_axis u k /\ at_axis u k < c k high)
  | _, _ => No
  end.

Inductive corners_facts := below_along (n : list A) | corners_touch (u v n : list A) | corners_inside (u v : list A).

(** [triangle_obb]: n leads from the triangle to the box, u are weights of the corners, v coefficients. *)
Definition check_triangle_obb (points : list (list A)) (center : list A) (axes : list (list A)) (w : contact)
    (facts : corners_facts) : C :=
  let lowest n := inner (leaves n) (leaves center) - reach (leaves n) axes in
  let height n p := inner (leaves n) (leaves p) in
  let common u v := are_weights u points /\ same_vector (mixed 3 u points) (placed center axes v) in
  are_points 3 3 points /\ right_box center axes /\
  match w, facts with
  | disjoint, below_along n => of_length 3 n /\ all (fun p => height n p < lowest n) points
  | touching, corners_touch u v n =>
      of_length 3 n /\ not_zero n /\ all (fun p => height n p <= lowest n) points /\ within_one v /\ common u v
  | overlapping, corners_inside u v => inside_one v /\ common u v
  | _, _ => No
  end.
End checks.
Arguments box_facts : clear implicits. Arguments corners_facts : clear implicits.
