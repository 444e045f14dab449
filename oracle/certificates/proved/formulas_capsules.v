(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of capsules and triangles that solids meet. *)
Require Import ZArith List Arith.
From Certificates Require Import solids language formulas_vectors formulas_solids formulas_nearest.
Import ListNotations.
Local Open Scope check_scope.

Section checks.
Context {A : Type}.
Notation T := (term A). Notation C := (cond A).

Inductive gap_facts := nearest_points | tangent_points | without_interior | near_points.
(** [near]: points of two cores are the nearest, q being the square of their distance; [flat]: one of what is no farther
    from the cores than radii, of the sum [reach], has no interior. *)
Definition gap_decides (near : C) (q reach : T) (flat : C) (w : contact) (facts : gap_facts) : C :=
  match w, facts with
  | disjoint, nearest_points => near /\ reach * reach < q
  | touching, tangent_points => near /\ q = reach * reach
  | touching, without_interior => q <= reach * reach /\ flat
  | overlapping, near_points => q < reach * reach /\ ~ flat
  | _, _ => No
  end.
(** x and y are points of the hulls of a and b. *)
Definition gap_proves (a : list (list A)) (x : list T) (b : list (list A)) (y : list T) (reach : T) (flat : C)
    (w : contact) (facts : gap_facts) : C :=
  let near := none_nearer a x y /\ none_nearer b y x in
  gap_decides near (inner (difference x y) (difference x y)) reach flat w facts.

(** [sphere_capsule] *)
Definition check_sphere_capsule (c : list A) (r : A) (points : list (list A)) (s : A) (w : contact) (facts : gap_facts)
    (weights : list A) : C :=
  of_length 3 c /\ are_points 2 3 points /\ zero <= Leaf r /\ zero <= Leaf s /\ are_weights weights points /\
  gap_proves [c] (leaves c) points (mixed 3 weights points) (Leaf r + Leaf s) (Leaf r = zero \/ Leaf s = zero) w facts.

(** [capsule_capsule] *)
Definition check_capsule_capsule (a : list (list A)) (r : A) (b : list (list A)) (s : A) (w : contact)
    (facts : gap_facts) (on_a on_b : list A) : C :=
  are_points 2 3 a /\ are_points 2 3 b /\ zero <= Leaf r /\ zero <= Leaf s /\ are_weights on_a a /\
    are_weights on_b b /\
  gap_proves a (mixed 3 on_a a) b (mixed 3 on_b b) (Leaf r + Leaf s) (Leaf r = zero \/ Leaf s = zero) w facts.

(** [sphere_triangle] *)
Definition check_sphere_triangle (c : list A) (r : A) (points : list (list A)) (w : contact) (facts : gap_facts)
    (weights : list A) : C :=
  of_length 3 c /\ zero <= Leaf r /\ are_points 3 3 points /\ are_weights weights points /\
  gap_proves [c] (leaves c) points (mixed 3 weights points) (Leaf r) (Leaf r = zero) w facts.

(** [capsule_triangle] *)
Definition check_capsule_triangle (a : list (list A)) (r : A) (points : list (list A)) (w : contact) (facts : gap_facts)
    (on_a on_b : list A) : C :=
  are_points 2 3 a /\ zero <= Leaf r /\ are_points 3 3 points /\ are_weights on_a a /\ are_weights on_b points /\
  gap_proves a (mixed 3 on_a a) points (mixed 3 on_b points) (Leaf r) (Leaf r = zero) w facts.

(** [capsule_aabb] *)
Definition check_capsule_aabb (points : list (list A)) (r : A) (low high : list A) (w : contact) (facts : gap_facts)
    (on_a y : list A) : C :=
  let c := coordinate in let x := mixed 3 on_a points in let x_at k := nth k x zero in
  let way := difference x (leaves y) in
  let near := none_nearer points x (leaves y) /\
    on_each 3 (fun k => (x_at k <= c k y \/ c k y = c k high) /\ (c k y <= x_at k \/ c k y = c k low)) in
  let flat := Leaf r = zero \/ c 0 low = c 0 high \/ c 1 low = c 1 high \/ c 2 low = c 2 high in
  are_points 2 3 points /\ zero <= Leaf r /\ of_length 3 low /\ of_length 3 high /\
  on_each 3 (fun k => c k low <= c k high) /\ are_weights on_a points /\ of_length 3 y /\
  on_each 3 (fun k => c k low <= c k y /\ c k y <= c k high) /\
  gap_decides near (inner way way) (Leaf r) flat w facts.

(** The least n . x of a box *)
Fixpoint lowest_of_box (n low high : list A) : T :=
  match n, low, high with
  | c :: n', l :: low', h :: high' =>
      lowest_of_box n' low' high' - Max (zero - Leaf c * Leaf l) (zero - Leaf c * Leaf h)
  | _, _, _ => zero
  end.
Inductive between_facts :=
| plane_between (n : list A) (offset : A)
| plane_touched (weights n : list A) (offset : A)
| box_is_flat (weights : list A) (axis : nat)
| weights_inside (weights : list A).

(** [triangle_aabb] *)
Definition check_triangle_aabb (points : list (list A)) (low high : list A) (w : contact) (facts : between_facts) : C :=
  let c := coordinate in
  let point weights k := nth k (mixed 3 weights points) zero in
  let in_box weights := on_each 3 (fun k => c k low <= point weights k /\ point weights k <= c k high) in
  let inside weights := on_each 3 (fun k => c k low < point weights k /\ point weights k < c k high) in
  are_points 3 3 points /\ of_length 3 low /\ of_length 3 high /\ on_each 3 (fun k => c k low <= c k high) /\
  match w, facts with
  | disjoint, plane_between n d => of_length 3 n /\ not_zero n /\ Leaf d < lowest_of_box n low high /\
      all (fun p => inner (leaves n) (leaves p) < Leaf d) points
  | touching, plane_touched weights n d => of_length 3 n /\ not_zero n /\ Leaf d <= lowest_of_box n low high /\
      all (fun p => inner (leaves n) (leaves p) <= Leaf d) points /\ are_weights weights points /\ in_box weights
  | touching, box_is_flat weights k =>
      if_so (k <? 3) /\ c k low = c k high /\ are_weights weights points /\ in_box weights
  | overlapping, weights_inside weights => are_weights weights points /\ inside weights
  | _, _ => No
  end.
End checks.
Arguments between_facts : clear implicits.
