(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of bodies that bounce, collide, or are pushed back. *)
Require Import ZArith List Arith.
From Certificates Require Import response language formulas_response.
Import ListNotations.
Local Open Scope check_scope.

Section checks.
Context {A : Type}.
Notation T := (term A). Notation C := (cond A).

(** [reflect_wall], kind [components] *)
Definition check_reflect_wall (v : vec3 A) (w : axis) (after : vec3 A) (first last : A) : C :=
  let '(x, y, z) := term3 v in
  Leaf first = inner3 (term3 v) (term3 v) /\ Leaf last = inner3 (term3 after) (term3 after) /\ Leaf first = Leaf last /\
  same3 (term3 after) (match w with
    | along_x => (zero - x, y, z) | along_y => (x, zero - y, z) | along_z => (x, y, zero - z) end).

Definition impulse_proves (a b : A * vec3 A) (n : vec3 A) (e : T) (v w : vec3 A) (j first last : A) : C :=
  let change m one other := scaled3 (Leaf m) (gap3 (term3 one) (term3 other)) in
  positive_masses [a; b] /\ ~ same3 (term3 n) zero3 /\
  same3 (change (fst a) v (snd a)) (scaled3 (Leaf j) (term3 n)) /\
  same3 (change (fst b) w (snd b)) (scaled3 (zero - Leaf j) (term3 n)) /\
  inner3 (term3 n) (gap3 (term3 v) (term3 w)) = (zero - e) * inner3 (term3 n) (gap3 (term3 (snd a)) (term3 (snd b))) /\
  Leaf first = doubled_energies [a; b] zero3 /\ Leaf last = doubled_energies [(fst a, v); (fst b, w)] zero3.

(** [elastic_collision], kind [impulse] *)
Definition check_elastic_collision (a b : A * vec3 A) (n v w : vec3 A) (j first last : A) : C :=
  impulse_proves a b n one v w j first last /\ Leaf last = Leaf first.

(** [restitution_collision], kind [impulse] *)
Definition check_restitution_collision (a b : A * vec3 A) (n : vec3 A) (e : A) (v w : vec3 A) (j first last : A) : C :=
  zero <= Leaf e /\ Leaf e <= one /\ impulse_proves a b n (Leaf e) v w j first last /\ Leaf last <= Leaf first /\
  (Leaf e < one \/ Leaf last = Leaf first).

Inductive force_facts := no_contact | foot_and_along (foot along : vec3 A).

(** [penalty_force] *)
Definition check_penalty_force (p v n : vec3 A) (d k c : A) (force : vec3 A) (facts : force_facts) : C :=
  let height x := inner3 (term3 n) (term3 x) + Leaf d in
  ~ same3 (term3 n) zero3 /\
  match facts with
  | no_contact => zero <= height p /\ same3 (term3 force) zero3
  | foot_and_along foot along =>
      let way := gap3 (term3 foot) (term3 p) in let u := term3 along in
      height p < zero /\ height foot = zero /\ same3 (outer3 way (term3 n)) zero3 /\ same3 (outer3 u (term3 n)) zero3 /\
      inner3 (gap3 (term3 v) u) (term3 n) = zero /\
      same3 (term3 force) (gap3 (scaled3 (Leaf k) way) (scaled3 (Leaf c) u))
  end.

Definition rigid : Type := (A * vec3 (vec3 A)) * (vec3 A * vec3 A * vec3 A).
Definition mapped (m : vec3 (vec3 A)) (x : vec3 T) : vec3 T :=
  let '(a, b, c) := m in (inner3 (term3 a) x, inner3 (term3 b) x, inner3 (term3 c) x).
(** Symmetric, with positive leading minors *)
Definition right_mass (body : rigid) : C :=
  let '((mass, (a, b, c)), _) := body in
  let '(a1, a2, a3) := term3 a in let '(b1, b2, b3) := term3 b in let '(c1, c2, c3) := term3 c in
  let '(m1, m2, m3) := outer3 (term3 a) (term3 b) in
  zero < Leaf mass /\ b1 = a2 /\ c1 = a3 /\ c2 = b3 /\ zero < a1 /\ zero < m3 /\
  zero < inner3 (m1, m2, m3) (term3 c).
Definition motion_at (body : rigid) (v w p : vec3 A) : vec3 T :=
  let '(_, (position, _, _)) := body in velocity_term (position, v, w) p.
Definition motion_before (body : rigid) (p : vec3 A) : vec3 T :=
  let '(_, (position, v, w)) := body in velocity_term (position, v, w) p.
Definition is_pushed (body : rigid) (p : vec3 A) (push : vec3 T) (v w : vec3 A) : C :=
  let '((mass, inertia), (position, velocity, turn)) := body in
  same3 (scaled3 (Leaf mass) (gap3 (term3 v) (term3 velocity))) push /\
  same3 (mapped inertia (gap3 (term3 w) (term3 turn))) (outer3 (gap3 (term3 p) (term3 position)) push).
Definition doubled_energy (body : rigid) (v w : vec3 A) : T :=
  let '((mass, inertia), _) := body in
  Leaf mass * inner3 (term3 v) (term3 v) + inner3 (term3 w) (mapped inertia (term3 w)).

(** [rigid_body_collision], kind [impulse_at] *)
Definition check_rigid_body_collision (a b : rigid) (p n : vec3 A) (e : A) (va wa vb wb : vec3 A)
    (j first last : A) : C :=
  let n' := term3 n in
  right_mass a /\ right_mass b /\ ~ same3 n' zero3 /\ zero <= Leaf e /\ Leaf e <= one /\
  is_pushed a p (scaled3 (Leaf j) n') va wa /\ is_pushed b p (scaled3 (zero - Leaf j) n') vb wb /\
  inner3 n' (gap3 (motion_at a va wa p) (motion_at b vb wb p)) =
    (zero - Leaf e) * inner3 n' (gap3 (motion_before a p) (motion_before b p)) /\
  Leaf first = doubled_energy a (snd (fst (snd a))) (snd (snd a)) +
    doubled_energy b (snd (fst (snd b))) (snd (snd b)) /\
  Leaf last = doubled_energy a va wa + doubled_energy b vb wb /\
  Leaf last <= Leaf first /\ (Leaf e < one \/ Leaf last = Leaf first).
End checks.
Arguments force_facts : clear implicits. Arguments rigid : clear implicits.
