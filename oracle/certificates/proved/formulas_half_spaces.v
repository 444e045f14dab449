(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of oriented boxes and capsules over planes. *)
Require Import ZArith List Arith.
From Certificates Require Import solids motion language formulas_vectors formulas_solids formulas_slabs formulas_nearest
  formulas_obbs formulas_motion.
Import ListNotations.
Local Open Scope check_scope.

Section checks.
Context {A : Type}.
Notation T := (term A). Notation C := (cond A).

(** [obb_plane]: the facts' points are coefficients of the half axes. *)
Definition check_obb_plane (center : list A) (axes : list (list A)) (n : list A) (d : A) (w : contact)
    (facts : plane_facts A) : C :=
  let at_point u := inner (leaves n) (placed center axes u) + Leaf d in
  let lowest u := at_point u = height n d center - reach (leaves n) axes in
  right_box center axes /\ of_length 3 n /\ not_zero n /\
  match w, facts with
  | disjoint, lowest_point u => within_one u /\ lowest u /\ zero < at_point u
  | touching, lowest_point u => within_one u /\ lowest u /\ at_point u = zero
  | overlapping, common_point_inside u => inside_one u /\ at_point u < zero
  | _, _ => No
  end.

(** [capsule_plane]: the weights give the lowest point of the segment. *)
Definition check_capsule_plane (points : list (list A)) (r : A) (n : list A) (d : A) (w : contact)
    (facts : plane_facts A) (weights : list A) : C :=
  let x := mixed 3 weights points in
  let beyond y := difference x (leaves y) in
  let along y := inner (leaves n) (beyond y) in
  let apart y := inner (beyond y) (beyond y) in
  let nearest y :=
    height n d y <= zero /\ zero <= along y /\ along y * height n d y = zero /\
    along y * along y = apart y * inner (leaves n) (leaves n) in
  are_points 2 3 points /\ zero <= Leaf r /\ of_length 3 n /\ not_zero n /\ are_weights weights points /\
  all (fun p => inner (leaves n) x <= inner (leaves n) (leaves p)) points /\
  match w, facts with
  | disjoint, nearest_in_half_space y => of_length 3 y /\ nearest y /\ Leaf r * Leaf r < apart y
  | touching, tangent_to_plane y => of_length 3 y /\ nearest y /\ apart y = Leaf r * Leaf r
  | overlapping, common_point_inside y => of_length 3 y /\ height n d y < zero /\ apart y < Leaf r * Leaf r
  | _, _ => No
  end.

(** [swept_capsule_plane]: the end that is nearer to the plane, or the point of the segment that is on it *)
Definition check_swept_capsule_plane (points : list (list A)) (r : A) (v n : list A) (d : A) (answer : option (surd A))
    (kind : zero_kind) (facts : list A) : C :=
  let proves e := approach_proves e r v n answer kind facts in
  are_points 2 3 points /\ zero <= Leaf r /\ of_length 3 v /\ of_length 3 n /\ not_zero n /\
  match points with
  | [p; q] =>
      let a := height n d p in let b := height n d q in
      (a * b <= zero /\ proves zero) \/
      (zero < a * b /\ (a * a <= b * b /\ proves a \/ b * b <= a * a /\ proves b))
  | _ => No
  end.
End checks.
