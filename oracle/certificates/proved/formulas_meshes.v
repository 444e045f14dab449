(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of meshes that are closed and convex. *)
Require Import ZArith List Arith Bool.
From Certificates Require Import solids language formulas_vectors formulas_slabs formulas_bounds formulas_nearest
  formulas_triangles formulas_capsules.
Import ListNotations.
Local Open Scope check_scope.

Definition edges_of (face : list nat) : list (nat * nat) :=
  match face with [i; j; k] => [(i, j); (j, k); (k, i)] | _ => [] end.
Definition same_edge : forall e f : nat * nat, {e = f} + {e <> f}.
Proof. decide equality; apply Nat.eq_dec. Defined.
(** Every edge is there once, and once in the other direction. *)
Definition is_closed (faces : list (list nat)) : bool :=
  let edges := flat_map edges_of faces in
  let once e := count_occ same_edge edges e =? 1 in
  forallb (fun e => (once e && once (snd e, fst e))%bool) edges.
(** Three different vertices of so many *)
Definition is_face (count : nat) (face : list nat) : bool :=
  match face with
  | [i; j; k] => ((i <? count) && (j <? count) && (k <? count) && negb (i =? j) && negb (j =? k) && negb (k =? i))%bool
  | _ => false
  end.

Section checks.
Context {A : Type}.
Notation T := (term A). Notation C := (cond A).

(** Six times the volume between a face and x; positive where the face is seen counter-clockwise. *)
Definition height_over (vertices : list (list A)) (face : list nat) (x : list T) : T :=
  match face with
  | [i; j; k] =>
      let corner k := leaves (nth k vertices nil) in
      inner (outer_product (difference (corner j) (corner i)) (difference (corner k) (corner i)))
        (difference x (corner i))
  | _ => zero
  end.
Definition right_mesh (vertices : list (list A)) (faces : list (list nat)) : C :=
  all (of_length 3) vertices /\ if_so (4 <=? length faces) /\ if_so (forallb (is_face (length vertices)) faces) /\
  if_so (is_closed faces).
(** No vertex is in front of a face, and some are behind. [side] is one, or -one where the faces are clockwise. *)
Definition convex_mesh_from (side : T) (vertices : list (list A)) (faces : list (list nat)) : C :=
  all (fun face => all (fun v => side * height_over vertices face (leaves v) <= zero) vertices /\
                   ~ all (fun v => height_over vertices face (leaves v) = zero) vertices) faces.

Inductive mesh_facts := separating_face (face : nat) | barycentric (corners : list nat) (weights : list A).
(** [point_in_convex_polyhedron] *)
Definition check_point_in_convex_polyhedron (vertices : list (list A)) (faces : list (list nat)) (p : list A)
    (w : location) (facts : mesh_facts) : C :=
  let height face := height_over vertices face (leaves p) in
  let from side := convex_mesh_from side vertices faces /\
    match w, facts with
    | outside, separating_face f => at_index f faces (fun face => zero < side * height face)
    | outside, _ => No
    | _, barycentric corners weights =>
        let some := chosen_from vertices corners in
        let on_a_face := ~ all (fun face => ~ height face = zero) faces in
        of_length 4 corners /\ are_places vertices corners /\ are_weights weights some /\
        same_vector (leaves p) (mixed 3 weights some) /\
        match w with boundary => on_a_face | _ => ~ on_a_face end
    | _, _ => No
    end in
  right_mesh vertices faces /\ of_length 3 p /\ (from one \/ from (zero - one)).

(** No way from x to one of the points leads against the direction. *)
Definition none_before (points : list (list A)) (direction x : list T) : C :=
  all (fun p => zero <= inner direction (difference (leaves p) x)) points.
Inductive distance_facts := meets_at (on_a on_b : list A) | nearest_at (on_a on_b first : list A).
(** [convex_distance], kinds [common_point] and [root] *)
Definition check_convex_distance (va : list (list A)) (fa : list (list nat)) (vb : list (list A)) (fb : list (list nat))
    (w : option (list A * list A)) (square distance : A) (facts : distance_facts) : C :=
  let convex vertices faces := right_mesh vertices faces /\
    (convex_mesh_from one vertices faces \/ convex_mesh_from (zero - one) vertices faces) in
  convex va fa /\ convex vb fb /\
  match w, facts with
  | None, meets_at on_a on_b =>
      are_weights on_a va /\ are_weights on_b vb /\ same_vector (mixed 3 on_a va) (mixed 3 on_b vb) /\
      Leaf square = zero /\ Leaf distance = zero
  | Some (x, y), nearest_at on_a on_b first =>
      let x := leaves x in let y := leaves y in
      are_weights on_a va /\ are_weights on_b vb /\ same_vector x (mixed 3 on_a va) /\
      same_vector y (mixed 3 on_b vb) /\ none_nearer va x y /\ none_nearer vb y x /\ ~ same_vector x y /\
      of_length 3 first /\ none_before va (leaves first) x /\
      none_before vb (difference (difference x (leaves (hd nil va))) (leaves first)) y /\
      of_distance x y square distance
  | _, _ => No
  end.

(** The mesh is closed and convex; x and y are points of the hulls of a core and of its vertices; w is the contact. *)
Definition round_meets (points : list (list A)) (x : list T) (r : A) (va : list (list A)) (fa : list (list nat))
    (w : contact) (facts : gap_facts) (weights : list A) : C :=
  zero <= Leaf r /\ (right_mesh va fa /\ (convex_mesh_from one va fa \/ convex_mesh_from (zero - one) va fa)) /\
  are_weights weights va /\ gap_proves points x va (mixed 3 weights va) (Leaf r) (Leaf r = zero) w facts.
(** [sphere_convex] *)
Definition check_sphere_convex (c : list A) (r : A) (va : list (list A)) (fa : list (list nat)) (w : contact)
    (facts : gap_facts) (weights : list A) : C :=
  of_length 3 c /\ round_meets [c] (leaves c) r va fa w facts weights.
(** [capsule_convex] *)
Definition check_capsule_convex (points : list (list A)) (r : A) (va : list (list A)) (fa : list (list nat))
    (w : contact) (facts : gap_facts) (on_a on_b : list A) : C :=
  are_points 2 3 points /\ are_weights on_a points /\ round_meets points (mixed 3 on_a points) r va fa w facts on_b.
End checks.
Arguments mesh_facts : clear implicits. Arguments distance_facts : clear implicits.
