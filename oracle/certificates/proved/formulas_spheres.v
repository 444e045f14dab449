(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of balls around points, whose radius is a number with a root. *)
Require Import ZArith List Arith.
From Certificates Require Import motion solids language formulas_vectors formulas_solids formulas_slabs formulas_bounds
  formulas_nearest formulas_motion.
Import ListNotations.
Local Open Scope check_scope.

Section checks.
Context {A : Type}.
Notation T := (term A). Notation C := (cond A).

Fixpoint greatest (l : list T) : T :=
  match l with [] => zero | [t] => t | t :: l' => Max t (greatest l') end.

Inductive sphere_facts := farthest_point (place : nat) | support (places : list nat) (weights : list A).
(** [bounding_sphere], kinds [farthest_point] and [support] *)
Definition check_bounding_sphere (points : list (list A)) (method : sphere_method) (c : list A) (radius : surd A)
    (facts : sphere_facts) : C :=
  let '(Surd x y k) := radius in
  let x := Leaf x in let y := Leaf y in let k := Leaf k in
  let beyond f p := f (squared_distance c p - (x * x + y * y * k)) (zero - Num 2 * x * y) k in
  let at_end f place := at_index place points (beyond is_zero) /\ on_each 3 f in
  if_so (negb (length points =? 0)) /\ all (of_length 3) points /\ of_length 3 c /\ zero <= k /\ not_negative x y k /\
  all (beyond not_positive) points /\
  match method, facts with
  | around_box, farthest_point place => at_end (fun axis => Num 2 * coordinate axis c =
      greatest (map (coordinate axis) points) - greatest (map (fun p => zero - coordinate axis p) points)) place
  | around_mean, farthest_point place => at_end (fun axis => Num (Z.of_nat (length points)) * coordinate axis c =
      fold_right Add zero (map (coordinate axis) points)) place
  | smallest, support places weights =>
      let on_it := chosen_from points places in
      are_places points places /\ are_weights weights on_it /\ same_vector (leaves c) (mixed 3 weights on_it) /\
      all (beyond is_zero) on_it
  | _, _ => No
  end.
End checks.
Arguments sphere_facts : clear implicits.
