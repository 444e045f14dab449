(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of points and lines of the plane: what each kind of certificate compares, in the language of
    conditions. *)
Require Import ZArith List Arith.
From Certificates Require Import plane language.
Import ListNotations.
Local Open Scope check_scope.

Section checks.
Context {A : Type}.
Notation T := (term A). Notation C := (cond A).
Definition X (p : vec2 A) : T := Leaf (fst p).
Definition Y (p : vec2 A) : T := Leaf (snd p).

Definition cross (ux uy vx vy : T) : T := ux * vy - uy * vx.
Definition within (t : T) : C := zero <= t /\ t <= one.
Definition same_point (p q : vec2 A) : C := X p = X q /\ Y p = Y q.
Definition at_parameter_of (s : seg2 A) (t : T) (p : vec2 A) : C :=
  let '(a, b) := s in X p = X a + t * (X b - X a) /\ Y p = Y a + t * (Y b - Y a).
Definition level (n p : vec2 A) : T := X n * X p + Y n * Y p.

(** [orientation], kind [determinant] *)
Definition check_orientation (p0 p1 p : vec2 A) (w : side) (determinant : A) : C :=
  let d := Leaf determinant in
  d = cross (X p1 - X p0) (Y p1 - Y p0) (X p - X p0) (Y p - Y p0) /\
  match w with left => zero < d | right => d < zero | on => d = zero end.

Inductive line_facts :=
| weights (wa wb : A)
| separating_line (normal : vec2 A) (offset : A)
| transversal (determinant : A)
| single_point
| supporting_line (normal : vec2 A) (offset : A)
| overlap_facts (on_a on_b : vec2 A)
| level_lines (normal : vec2 A)
| same_line (on_a : vec2 A).

(** [point_on_segment] *)
Definition check_point_on_segment (p : vec2 A) (s : seg2 A) (w : incidence A) (facts : line_facts) : C :=
  let '(a, b) := s in
  match w, facts with
  | at_parameter t, weights wa wb =>
      zero <= Leaf wa /\ zero <= Leaf wb /\ Leaf wa + Leaf wb = one /\
      X p = Leaf wa * X a + Leaf wb * X b /\ Y p = Leaf wa * Y a + Leaf wb * Y b /\
      Leaf t = Leaf wb /\ (~ same_point a b \/ Leaf t = zero)
  | off, separating_line n c =>
      level n p < Leaf c /\ Leaf c < level n a /\ Leaf c < level n b
  | _, _ => No
  end.

Definition not_parallel (a b : seg2 A) (determinant : A) : C :=
  Leaf determinant = cross (X (snd a) - X (fst a)) (Y (snd a) - Y (fst a))
    (X (snd b) - X (fst b)) (Y (snd b) - Y (fst b))
  /\ ~ (Leaf determinant = zero).
Definition end_of_one (s u : A) : C := Leaf s = zero \/ Leaf s = one \/ Leaf u = zero \/ Leaf u = one.

(** [segment_segment] *)
Definition check_segment_segment (a b : seg2 A) (w : meeting A) (facts : line_facts) : C :=
  match w with
  | apart => match facts with
      | separating_line n c =>
          level n (fst a) < Leaf c /\ level n (snd a) < Leaf c /\ Leaf c < level n (fst b) /\ Leaf c < level n (snd b)
      | _ => No end
  | point ta tb p =>
      within (Leaf ta) /\ within (Leaf tb) /\ at_parameter_of a (Leaf ta) p /\ at_parameter_of b (Leaf tb) p /\
      (~ same_point (fst a) (snd a) \/ Leaf ta = zero) /\ (~ same_point (fst b) (snd b) \/ Leaf tb = zero) /\
      match facts with
      | transversal d => not_parallel a b d
      | single_point => same_point (fst a) (snd a) \/ same_point (fst b) (snd b)
      | supporting_line n c =>
          level n (fst a) <= Leaf c /\ level n (snd a) <= Leaf c /\
          Leaf c <= level n (fst b) /\ Leaf c <= level n (snd b) /\
          (~ (level n (fst a) = Leaf c /\ level n (snd a) = Leaf c) \/
           ~ (level n (fst b) = Leaf c /\ level n (snd b) = Leaf c))
      | _ => No end
  | overlap p q => match facts with
      | overlap_facts (s0, s1) (u0, u1) =>
          (X p < X q \/ X p = X q /\ Y p < Y q) /\
          within (Leaf s0) /\ within (Leaf s1) /\ within (Leaf u0) /\ within (Leaf u1) /\
          at_parameter_of a (Leaf s0) p /\ at_parameter_of a (Leaf s1) q /\
          at_parameter_of b (Leaf u0) p /\ at_parameter_of b (Leaf u1) q /\
          end_of_one s0 u0 /\ end_of_one s1 u1
      | _ => No end
  end.

(** [line_line] *)
Definition check_line_line (a b : seg2 A) (w : lines A) (facts : line_facts) : C :=
  ~ same_point (fst a) (snd a) /\ ~ same_point (fst b) (snd b) /\
  match w, facts with
  | crossing ta tb p, transversal d =>
      not_parallel a b d /\ at_parameter_of a (Leaf ta) p /\ at_parameter_of b (Leaf tb) p
  | parallel, level_lines n =>
      level n (fst a) = level n (snd a) /\ level n (fst b) = level n (snd b) /\ ~ (level n (fst a) = level n (fst b))
  | same, same_line (s, t) => at_parameter_of a (Leaf s) (fst b) /\ at_parameter_of a (Leaf t) (snd b)
  | _, _ => No
  end.

Inductive ray_facts :=
| ray_separating_line (normal : vec2 A) (offset : A)
| ray_transversal (su determinant : A)
| ray_single_point
| ray_supporting_line (su : A) (normal : vec2 A) (offset : A)
| ray_overlap_facts (ts us : vec2 A).

Definition ray_at (o d : vec2 A) (t : A) (p : vec2 A) : C :=
  zero <= Leaf t /\ X p = X o + Leaf t * X d /\ Y p = Y o + Leaf t * Y d.

(** [ray_segment] *)
Definition check_ray_segment (o d : vec2 A) (s : seg2 A) (w : hit A) (facts : ray_facts) : C :=
  let '(a, b) := s in
  ~ (X d = zero /\ Y d = zero) /\
  match w with
  | missed => match facts with
      | ray_separating_line n c => level n o < Leaf c /\ level n d <= zero /\ Leaf c < level n a /\ Leaf c < level n b
      | _ => No end
  | hit_point t p => ray_at o d t p /\ match facts with
      | ray_transversal u det =>
          within (Leaf u) /\ at_parameter_of s (Leaf u) p /\
          Leaf det = cross (X d) (Y d) (X b - X a) (Y b - Y a) /\ ~ (Leaf det = zero)
      | ray_single_point => same_point a b /\ same_point p a
      | ray_supporting_line u n c =>
          within (Leaf u) /\ at_parameter_of s (Leaf u) p /\
          level n o <= Leaf c /\ level n d <= zero /\ Leaf c <= level n a /\ Leaf c <= level n b /\
          (level n d < zero \/ ~ (level n a = Leaf c /\ level n b = Leaf c))
      | _ => No end
  | hit_overlap t p q => match facts with
      | ray_overlap_facts (t0, t1) (u0, u1) =>
          Leaf t = Leaf t0 /\ Leaf t0 < Leaf t1 /\ ray_at o d t0 p /\ ray_at o d t1 q /\
          within (Leaf u0) /\ within (Leaf u1) /\ at_parameter_of s (Leaf u0) p /\ at_parameter_of s (Leaf u1) q /\
          (Leaf t0 = zero \/ Leaf u0 = zero \/ Leaf u0 = one) /\ (Leaf u1 = zero \/ Leaf u1 = one)
      | _ => No end
  end.
End checks.
Arguments line_facts : clear implicits. Arguments ray_facts : clear implicits.
