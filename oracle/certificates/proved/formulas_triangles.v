(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of segments and rays that meet triangles. *)
Require Import ZArith List Arith.
From Certificates Require Import hulls solids language formulas_vectors formulas_solids formulas_heights
  formulas_nearest.
Import ListNotations.
Local Open Scope check_scope.

Section checks.
Context {A : Type}.
Notation T := (term A). Notation C := (cond A).

Definition outer_product (p q : list T) : list T :=
  match p, q with
  | [a; b; c], [x; y; z] => [b * z - c * y; c * x - a * z; a * y - b * x]
  | _, _ => []
  end.
Definition no_vector (x : list T) : C := all (fun t => t = zero) x.
Definition has_area (points : list (list A)) : C :=
  match points with
  | [a; b; c] =>
      ~ no_vector (outer_product (difference (leaves b) (leaves a)) (difference (leaves c) (leaves a)))
  | _ => No
  end.

(** [x] is the point of the hull with these weights. *)
Definition has_weights (w : list A) (points : list (list A)) (x : list T) : C :=
  are_weights w points /\ same_vector (mixed 3 w points) x.
(** A plane with no corner in front of it, [outside] in front, and x not behind: what leads from x to there and further
    is in front of it. *)
Definition plane_keeps (plane : list A) (corners : list (list A)) (outside x : list T) : C :=
  match plane with
  | [n1; n2; n3; d] =>
      let n := leaves [n1; n2; n3] in
      all (fun p => inner n (leaves p) <= Leaf d) corners /\ Leaf d < inner n outside /\ Leaf d <= inner n x
  | _ => No
  end.
Definition is_empty {B : Type} (l : list B) : C := if_so (length l =? 0).

Inductive common_facts :=
| plane_separates (n : list A) (d : A)
| common_part (t weights before after : list A).

(** [segment_triangle] *)
Definition check_segment_triangle (a b : list A) (points : list (list A)) (w : common A) (facts : common_facts) : C :=
  let way := difference (leaves b) (leaves a) in
  let x t := at_term (leaves a) way (Leaf t) in
  let starts t before := is_empty before /\ Leaf t = zero \/ plane_keeps before points (leaves a) (x t) in
  let ends t after := is_empty after /\ (Leaf t = one \/ no_vector way) \/ plane_keeps after points (leaves b) (x t) in
  of_length 3 a /\ of_length 3 b /\ are_points 3 3 points /\
  match w, facts with
  | no_point, plane_separates n d =>
      of_length 3 n /\ Leaf d < inner (leaves n) (leaves a) /\ Leaf d < inner (leaves n) (leaves b) /\
      all (fun p => inner (leaves n) (leaves p) < Leaf d) points
  | common_point t p, common_part [t0] weights before after =>
      zero <= Leaf t0 /\ Leaf t0 <= one /\ has_weights weights points (x t0) /\ starts t0 before /\ ends t0 after /\
      Leaf t = Leaf t0 /\ same_vector (leaves p) (x t0)
  | common_segment p q, common_part [t0; t1] [w0; w1; w2; u0; u1; u2] before after =>
      zero <= Leaf t0 /\ Leaf t0 < Leaf t1 /\ Leaf t1 <= one /\ ~ no_vector way /\
      has_weights [w0; w1; w2] points (x t0) /\ has_weights [u0; u1; u2] points (x t1) /\
      starts t0 before /\ ends t1 after /\ same_vector (leaves p) (x t0) /\ same_vector (leaves q) (x t1)
  | _, _ => No
  end.

Inductive ray_facts :=
| plane_until (n : list A) (d until : A)
| ray_part (t weights before after : list A).

(** [ray_triangle] *)
Definition check_ray_triangle (o v : list A) (points : list (list A)) (w : ray_common A) (facts : ray_facts) : C :=
  let x t := at_term (leaves o) (leaves v) (Leaf t) in
  let starts t before := is_empty before /\ Leaf t = zero \/ plane_keeps before points (leaves o) (x t) in
  let leaves_it t after := plane_keeps after points (at_term (leaves o) (leaves v) (Leaf t + one)) (x t) in
  of_length 3 o /\ of_length 3 v /\ not_zero v /\ are_points 3 3 points /\
  match w, facts with
  | ray_misses, plane_until n d until =>
      of_length 3 n /\ Leaf d < inner (leaves n) (leaves o) /\ Leaf d < inner (leaves n) (x until) /\
      all (fun p => inner (leaves n) (leaves p) < Leaf d) points /\
      all (fun p => zero < inner (leaves v) (difference (x until) (leaves p))) points
  | ray_hits t p within, ray_part [t0] weights before after =>
      zero <= Leaf t0 /\ has_weights weights points (x t0) /\ starts t0 before /\ leaves_it t0 after /\
      Leaf t = Leaf t0 /\ same_vector (leaves p) (x t0) /\
      let inside := has_area points /\ all (fun a => zero < Leaf a) weights in
      if within then inside else ~ inside
  | ray_enters t p, ray_part [t0; t1] [w0; w1; w2; u0; u1; u2] before after =>
      zero <= Leaf t0 /\ Leaf t0 < Leaf t1 /\ has_weights [w0; w1; w2] points (x t0) /\
      has_weights [u0; u1; u2] points (x t1) /\ starts t0 before /\ (is_empty after \/ leaves_it t0 after) /\
      Leaf t = Leaf t0 /\ same_vector (leaves p) (x t0)
  | _, _ => No
  end.
End checks.
Arguments common_facts : clear implicits. Arguments ray_facts : clear implicits.
