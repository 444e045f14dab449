(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of an axis-aligned box and an oriented one. *)
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
End checks.
Arguments box_facts : clear implicits.
