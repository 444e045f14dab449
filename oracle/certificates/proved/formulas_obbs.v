(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of oriented boxes. *)
Require Import ZArith List Arith.
From Certificates Require Import solids language formulas_vectors formulas_solids formulas_nearest
  formulas_capsules.
Import ListNotations.
Local Open Scope check_scope.

Section checks.
Context {A : Type}.
Notation T := (term A). Notation C := (cond A).

Definition at3 (k : nat) (x : list A) : T := coordinate k x.
Definition outer (p q : list A) : list T :=
  [at3 1 p * at3 2 q - at3 2 p * at3 1 q; at3 2 p * at3 0 q - at3 0 p * at3 2 q; at3 0 p * at3 1 q - at3 1 p * at3 0 q].
Definition right_box (center : list A) (axes : list (list A)) : C :=
  of_length 3 center /\ are_points 3 3 axes /\
  match axes with [h; i; j] => ~ inner (leaves h) (outer i j) = zero | _ => No end.
Definition size (t : T) : T := Max t (zero - t).
Fixpoint reach (n : list T) (axes : list (list A)) : T :=
  match axes with [] => zero | h :: axes' => size (inner n (leaves h)) + reach n axes' end.
Definition within_one (u : list A) : C := of_length 3 u /\ all (fun a => size (Leaf a) <= one) u.
Definition inside_one (u : list A) : C := of_length 3 u /\ all (fun a => size (Leaf a) < one) u.
Definition placed (center : list A) (axes : list (list A)) (u : list A) : list T :=
  sum_of (leaves center) (mixed 3 u axes).

Inductive obb_facts := beyond_plane (n : list A) | coefficients (u : list A).

(** [point_in_obb] *)
Definition check_point_in_obb (center : list A) (axes : list (list A)) (p : list A) (w : location) (facts :
  obb_facts) : C :=
  right_box center axes /\ of_length 3 p /\
  match w, facts with
  | outside, beyond_plane n => of_length 3 n /\
      reach (leaves n) axes < inner (leaves n) (difference (leaves p) (leaves center))
  | boundary, coefficients u => within_one u /\ ~ inside_one u /\ same_vector (leaves p) (placed center axes u)
  | inside, coefficients u => inside_one u /\ same_vector (leaves p) (placed center axes u)
  | _, _ => No
  end.

Inductive obbs_facts := apart_along (n : list A) | touch_along (u v n : list A) | common_inside (u v : list A).

(** [obb_obb] *)
Definition check_obb_obb (ca : list A) (a : list (list A)) (cb : list A) (b : list (list A)) (w : contact)
    (facts : obbs_facts) : C :=
  let way n := inner (leaves n) (difference (leaves cb) (leaves ca)) in
  let both n := reach (leaves n) a + reach (leaves n) b in
  right_box ca a /\ right_box cb b /\
  match w, facts with
  | disjoint, apart_along n => of_length 3 n /\ both n < way n
  | touching, touch_along u v n => of_length 3 n /\ not_zero n /\ way n = both n /\ within_one u /\ within_one v /\
      same_vector (placed ca a u) (placed cb b v)
  | overlapping, common_inside u v => inside_one u /\ inside_one v /\ same_vector (placed ca a u) (placed cb b v)
  | _, _ => No
  end.

(** [sphere_obb] *)
Definition check_sphere_obb (c : list A) (r : A) (center : list A) (axes : list (list A)) (w : contact)
    (facts : gap_facts) (u : list A) : C :=
  let x := placed center axes u in let way := difference (leaves c) x in
  let near := reach way axes <= inner way (difference x (leaves center)) in
  of_length 3 c /\ zero <= Leaf r /\ right_box center axes /\ within_one u /\
  gap_decides near (inner way way) (Leaf r) (Leaf r = zero) w facts.

(** [capsule_obb] *)
Definition check_capsule_obb (points : list (list A)) (r : A) (center : list A) (axes : list (list A)) (w : contact)
    (facts : gap_facts) (on_a on_b : list A) : C :=
  let x := mixed 3 on_a points in let y := placed center axes on_b in let way := difference x y in
  let near := none_nearer points x y /\ reach way axes <= inner way (difference y (leaves center)) in
  are_points 2 3 points /\ zero <= Leaf r /\ right_box center axes /\ are_weights on_a points /\ within_one on_b /\
  gap_decides near (inner way way) (Leaf r) (Leaf r = zero) w facts.
End checks.
Arguments obb_facts : clear implicits. Arguments obbs_facts : clear implicits.
