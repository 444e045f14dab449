(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of bodies. *)
Require Import ZArith List Arith.
From Certificates Require Import response language.
Import ListNotations.
Local Open Scope check_scope.

Section checks.
Context {A : Type}.
Notation T := (term A). Notation C := (cond A).

Definition term3 (p : vec3 A) : vec3 T := let '(a, b, c) := p in (Leaf a, Leaf b, Leaf c).
Definition sum3 (p q : vec3 T) : vec3 T := let '(a, b, c) := p in let '(x, y, z) := q in (a + x, b + y, c + z).
Definition gap3 (p q : vec3 T) : vec3 T := let '(a, b, c) := p in let '(x, y, z) := q in (a - x, b - y, c - z).
Definition scaled3 (t : T) (p : vec3 T) : vec3 T := let '(a, b, c) := p in (t * a, t * b, t * c).
Definition inner3 (p q : vec3 T) : T := let '(a, b, c) := p in let '(x, y, z) := q in a * x + b * y + c * z.
Definition outer3 (p q : vec3 T) : vec3 T :=
  let '(a, b, c) := p in let '(x, y, z) := q in (b * z - c * y, c * x - a * z, a * y - b * x).
Definition same3 (p q : vec3 T) : C := let '(a, b, c) := p in let '(x, y, z) := q in a = x /\ b = y /\ c = z.
Definition zero3 : vec3 T := (zero, zero, zero).

(** [damped_reflection], kind [decomposition] *)
Definition check_damped_reflection (v n : vec3 A) (k : A) (after along across : vec3 A) : C :=
  let u := term3 along in let w := term3 across in
  ~ same3 (term3 n) zero3 /\ same3 (sum3 u w) (term3 v) /\ same3 (outer3 u (term3 n)) zero3 /\
  inner3 w (term3 n) = zero /\ same3 (term3 after) (gap3 w (scaled3 (Leaf k) u)).

(** [reflect_plane], kind [decomposition] *)
Definition check_reflect_plane (v n after along across : vec3 A) : C :=
  let u := term3 along in let w := term3 across in
  ~ same3 (term3 n) zero3 /\ same3 (sum3 u w) (term3 v) /\ same3 (outer3 u (term3 n)) zero3 /\
  inner3 w (term3 n) = zero /\ same3 (term3 after) (gap3 w u).

Fixpoint positive_masses (l : list (A * vec3 A)) : C :=
  match l with [] => Yes | (m, _) :: l' => zero < Leaf m /\ positive_masses l' end.
Fixpoint momenta (l : list (A * vec3 A)) : vec3 T :=
  match l with [] => zero3 | (m, v) :: l' => sum3 (scaled3 (Leaf m) (term3 v)) (momenta l') end.
Fixpoint masses (l : list (A * vec3 A)) : T := match l with [] => zero | (m, _) :: l' => Leaf m + masses l' end.
Fixpoint doubled_energies (l : list (A * vec3 A)) (seen_from : vec3 T) : T :=
  match l with
  | [] => zero
  | (m, v) :: l' => let u := gap3 (term3 v) seen_from in Leaf m * inner3 u u + doubled_energies l' seen_from
  end.

(** [momentum], kind [sum] *)
Definition check_momentum (l : list (A * vec3 A)) (p : vec3 A) : C := positive_masses l /\ same3 (term3 p) (momenta l).

(** [kinetic_energy], kind [centre] *)
Definition check_kinetic_energy (l : list (A * vec3 A)) (energy mass : A) (centre : vec3 A) (of_centre seen : A) : C :=
  let c := term3 centre in
  positive_masses l /\ Leaf mass = masses l /\ same3 (scaled3 (Leaf mass) c) (momenta l) /\
  (zero < Leaf mass \/ same3 c zero3) /\ Leaf of_centre = Leaf mass * inner3 c c /\ Leaf seen = doubled_energies l c /\
  Num 2 * Leaf energy = doubled_energies l zero3 /\ Num 2 * Leaf energy = Leaf of_centre + Leaf seen.

(** [inelastic_collision], kind [momentum] *)
Definition check_inelastic_collision (a b : A * vec3 A) (v momentum : vec3 A) : C :=
  positive_masses [a; b] /\ same3 (term3 momentum) (momenta [a; b]) /\
  same3 (scaled3 (Leaf (fst a) + Leaf (fst b)) (term3 v)) (term3 momentum).

Definition velocity_term (body : vec3 A * vec3 A * vec3 A) (p : vec3 A) : vec3 T :=
  let '(position, v, turn) := body in sum3 (term3 v) (outer3 (term3 turn) (gap3 (term3 p) (term3 position))).

(** [contact_state], kind [point_velocities] *)
Definition check_contact_state (a b : vec3 A * vec3 A * vec3 A) (p n : vec3 A) (w : contact_state)
    (of_a of_b : vec3 A) : C :=
  let rate := inner3 (term3 n) (gap3 (term3 of_a) (term3 of_b)) in
  ~ same3 (term3 n) zero3 /\ same3 (term3 of_a) (velocity_term a p) /\ same3 (term3 of_b) (velocity_term b p) /\
  match w with separating => zero < rate | resting => rate = zero | colliding => rate < zero end.
End checks.
