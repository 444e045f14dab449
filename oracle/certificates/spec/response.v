(* SPDX-License-Identifier: Apache-2.0 *)
(** What the answers claim of bodies: momentum, energy, and velocities after a collision. *)
Require Import Reals List.
Open Scope R_scope.

Definition vec3 (A : Type) : Type := A * A * A.
Definition add3 (p q : vec3 R) : vec3 R := let '(a, b, c) := p in let '(x, y, z) := q in (a + x, b + y, c + z).
Definition times3 (t : R) (p : vec3 R) : vec3 R := let '(a, b, c) := p in (t * a, t * b, t * c).
Definition minus3 (p q : vec3 R) : vec3 R := add3 p (times3 (-1) q).
Definition dot3 (p q : vec3 R) : R := let '(a, b, c) := p in let '(x, y, z) := q in a * x + b * y + c * z.
Definition cross3 (p q : vec3 R) : vec3 R :=
  let '(a, b, c) := p in let '(x, y, z) := q in (b * z - c * y, c * x - a * z, a * y - b * x).

(** The velocity v is u + w with u along the normal and w across it; what is along it is reversed and damped. *)
Definition damped_reflection_spec (v n : vec3 R) (k : R) (after : vec3 R) : Prop :=
  n <> (0, 0, 0) /\
  exists s w, v = add3 (times3 s n) w /\ dot3 w n = 0 /\ after = minus3 w (times3 (k * s) n).
Definition reflect_plane_spec (v n after : vec3 R) : Prop := damped_reflection_spec v n 1 after.

(** Bodies are pairs (mass, velocity). *)
Definition total_momentum (bodies : list (R * vec3 R)) : vec3 R :=
  fold_right (fun body sum => add3 (times3 (fst body) (snd body)) sum) (0, 0, 0) bodies.
Definition total_energy (bodies : list (R * vec3 R)) : R :=
  fold_right (fun body sum => fst body * dot3 (snd body) (snd body) / 2 + sum) 0 bodies.
Definition have_mass (bodies : list (R * vec3 R)) : Prop := forall body, In body bodies -> 0 < fst body.
Definition momentum_spec (bodies : list (R * vec3 R)) (p : vec3 R) : Prop := have_mass bodies /\ p = total_momentum bodies.
Definition kinetic_energy_spec (bodies : list (R * vec3 R)) (e : R) : Prop := have_mass bodies /\ e = total_energy bodies.
(** Two bodies that stick together keep their momentum. *)
Definition inelastic_collision_spec (a b : R * vec3 R) (v : vec3 R) : Prop :=
  have_mass (a :: b :: nil) /\ total_momentum (a :: b :: nil) = times3 (fst a + fst b) v.

(** A moving body is (position, velocity, angular velocity). The normal leads from b to a. *)
Definition velocity_at (body : vec3 R * vec3 R * vec3 R) (p : vec3 R) : vec3 R :=
  let '(position, v, turn) := body in add3 v (cross3 turn (minus3 p position)).
Inductive contact_state := separating | resting | colliding.
Definition contact_state_spec (a b : vec3 R * vec3 R * vec3 R) (p n : vec3 R) (w : contact_state) : Prop :=
  n <> (0, 0, 0) /\
  let rate := dot3 n (minus3 (velocity_at a p) (velocity_at b p)) in
  match w with separating => 0 < rate | resting => rate = 0 | colliding => rate < 0 end.
