(* SPDX-License-Identifier: Apache-2.0 *)
(** What the answers claim of bodies: momentum, energy, and velocities after a collision. *)
Require Import Reals List. From Certificates Require Import solids. Open Scope R_scope.
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
Definition momentum_spec bodies (p : vec3 R) : Prop := have_mass bodies /\ p = total_momentum bodies.
Definition kinetic_energy_spec bodies (e : R) : Prop := have_mass bodies /\ e = total_energy bodies.
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
(** [reflect_wall]: what is along the axis is reversed. *)
Inductive axis := along_x | along_y | along_z.
Definition reflect_wall_spec (v : vec3 R) (w : axis) (after : vec3 R) : Prop :=
  let '(x, y, z) := v in
  after = match w with along_x => (- x, y, z) | along_y => (x, - y, z) | along_z => (x, y, - z) end.
(** Two bodies push or pull each other along the normal; how fast they part along it is - e times what it was. *)
Definition restitution_collision_spec (a b : R * vec3 R) (n : vec3 R) (e : R) (v w : vec3 R) : Prop :=
  let before := a :: b :: nil in let after := (fst a, v) :: (fst b, w) :: nil in
  have_mass before /\ n <> (0, 0, 0) /\ 0 <= e <= 1 /\
  (exists push, v = add3 (snd a) (times3 push n)) /\ total_momentum after = total_momentum before /\
  dot3 n (minus3 v w) = - e * dot3 n (minus3 (snd a) (snd b)) /\ total_energy after <= total_energy before.
Definition elastic_collision_spec (a b : R * vec3 R) (n v w : vec3 R) : Prop :=
  restitution_collision_spec a b n 1 v w /\
  total_energy ((fst a, v) :: (fst b, w) :: nil) = total_energy (a :: b :: nil).
(** [penalty_force]: behind the plane n . x + d = 0 a spring pulls to the nearest point of it, and a damper holds back
    what of the velocity is along the normal. *)
Definition penalty_force_spec (p v n : vec3 R) (d stiffness damping : R) (force : vec3 R) : Prop :=
  n <> (0, 0, 0) /\
  (0 <= dot3 n p + d -> force = (0, 0, 0)) /\
  (dot3 n p + d < 0 -> exists t s w, dot3 n (add3 p (times3 t n)) + d = 0 /\ v = add3 (times3 s n) w /\ dot3 w n = 0 /\
     force = minus3 (times3 stiffness (times3 t n)) (times3 damping (times3 s n))).
(** [rigid_body_collision]: a body is ((mass, inertia), (position, velocity, angular velocity)); it is pushed at the
    point p, the other by the opposite push. The points of both at p part e times as fast as they met. *)
Definition rigid_body : Type := (R * vec3 (vec3 R)) * (vec3 R * vec3 R * vec3 R).
Definition matrix_times (m : vec3 (vec3 R)) (x : vec3 R) : vec3 R :=
  let '(a, b, c) := m in (dot3 a x, dot3 b x, dot3 c x).
Definition right_body (body : rigid_body) : Prop :=
  let '((mass, inertia), _) := body in 0 < mass /\
  (forall x y, dot3 x (matrix_times inertia y) = dot3 y (matrix_times inertia x)) /\
  forall x, x <> (0, 0, 0) -> 0 < dot3 x (matrix_times inertia x).
Definition pushed (body : rigid_body) (p push v w : vec3 R) : Prop :=
  let '((mass, inertia), (position, velocity, turn)) := body in times3 mass (minus3 v velocity) = push /\
  matrix_times inertia (minus3 w turn) = cross3 (minus3 p position) push.
Definition rigid_body_collision_spec (a b : rigid_body) (p n : vec3 R) (e : R) (after_a after_b : vec3 R * vec3 R) :
  Prop :=
  let before (body : rigid_body) := velocity_at (snd body) p in
  let after (body : rigid_body) motion := velocity_at (fst (fst (snd body)), fst motion, snd motion) p in
  right_body a /\ right_body b /\ n <> (0, 0, 0) /\ 0 <= e <= 1 /\
  dot3 n (minus3 (after a after_a) (after b after_b)) = - e * dot3 n (minus3 (before a) (before b)) /\
  exists j, pushed a p (times3 j n) (fst after_a) (snd after_a) /\
    pushed b p (times3 (- j) n) (fst after_b) (snd after_b).
(** [simultaneous_collisions]: bodies are (inverse mass, velocity), contacts ((a, b), normal from the b-th to the a-th).
    Allowed are velocities with which none that did approach parts less than e times as fast, and no other approaches;
    what has the inverse mass 0 keeps its own. The answer changes least: by the sum of mass times |change|^2. *)
Definition parting (v : list (list R)) (c : nat * nat * list R) : R :=
  let '(a, b, n) := c in dot n (minus (nth a v nil) (nth b v nil)).
Definition allowed (bodies : list (R * list R)) contacts (e : R) (v : list (list R)) : Prop :=
  Forall2 (fun body after => length after = 3%nat /\ (fst body = 0 -> after = snd body)) bodies v /\
  forall c, In c contacts -> e * Rmax 0 (- parting (map snd bodies) c) <= parting v c.
Fixpoint change (bodies : list (R * list R)) (v : list (list R)) : R :=
  match bodies, v with (w, u) :: bodies', x :: v' => sqdist u x / w + change bodies' v' | _, _ => 0 end.
Definition simultaneous_collisions_spec bodies contacts (e : R) (w : option (list (list R))) : Prop :=
  (forall body, In body bodies -> 0 <= fst body /\ length (snd body) = 3%nat) /\ 0 <= e <= 1 /\
  (forall a b n, In (a, b, n) contacts -> (a < length bodies)%nat /\ (b < length bodies)%nat /\ a <> b /\
     length n = 3%nat /\ nonzero n) /\
  match w with
  | Some v => allowed bodies contacts e v /\ forall u, allowed bodies contacts e u -> change bodies v <= change bodies u
  | None => forall v, ~ allowed bodies contacts e v
  end.
