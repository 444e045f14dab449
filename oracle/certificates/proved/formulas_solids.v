(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of balls and boxes. Points are lists of coordinates. *)
Require Import ZArith List Arith.
From Certificates Require Import solids language.
Import ListNotations.
Local Open Scope check_scope.

Section checks.
Context {A : Type}.
Notation T := (term A). Notation C := (cond A).

Fixpoint squared_distance (x y : list A) : T :=
  match x, y with
  | a :: x', b :: y' => (Leaf a - Leaf b) * (Leaf a - Leaf b) + squared_distance x' y'
  | _, _ => zero
  end.
Definition two_or_three (l : list A) : bool := orb (length l =? 2) (length l =? 3).
Definition as_long (x y : list A) : C := if_so (length x =? length y).

Inductive solid_facts :=
| distance (squared : A)
| tangent (x : list A)
| no_interior (x : list A)
| common_interior_point (x : list A)
| nearest_point (x : list A)
| separating_axis (axis : nat) (v : A)
| supporting_axis (x : list A) (axis : nat)
| flat_axis (x : list A) (axis : nat).

(** [sphere_sphere] *)
Definition check_sphere_sphere (c : list A) (r : A) (d : list A) (s : A) (w : contact) (facts : solid_facts) : C :=
  let reach := (Leaf r + Leaf s) * (Leaf r + Leaf s) in
  let in_ball c r x := squared_distance c x <= Leaf r * Leaf r in
  let inside c r x := squared_distance c x < Leaf r * Leaf r in
  if_so (two_or_three c) /\ as_long d c /\ zero <= Leaf r /\ zero <= Leaf s /\
  match w, facts with
  | disjoint, distance q => Leaf q = squared_distance c d /\ reach < Leaf q
  | touching, tangent x => as_long x c /\ in_ball c r x /\ in_ball d s x /\ squared_distance c d = reach
  | touching, no_interior x => as_long x c /\ in_ball c r x /\ in_ball d s x /\ (Leaf r = zero \/ Leaf s = zero)
  | overlapping, common_interior_point x => as_long x c /\ inside c r x /\ inside d s x
  | _, _ => No
  end.

Definition coordinate (k : nat) (x : list A) : T := nth k (map Leaf x) zero.
Fixpoint on_each (n : nat) (f : nat -> C) : C := match n with 0%nat => Yes | S k => on_each k f /\ f k end.

(** [aabb_aabb] *)
Definition check_aabb_aabb (la ha lb hb : list A) (w : contact) (facts : solid_facts) : C :=
  let n := length la in
  let c := coordinate in
  let in_box l h x := on_each n (fun k => c k l <= c k x /\ c k x <= c k h) in
  let inside l h x := on_each n (fun k => c k l < c k x /\ c k x < c k h) in
  let valid l h := on_each n (fun k => c k l <= c k h) in
  if_so (two_or_three la) /\ as_long ha la /\ as_long lb la /\ as_long hb la /\ valid la ha /\ valid lb hb /\
  match w, facts with
  | disjoint, separating_axis k v =>
      if_so (k <? n) /\ (c k ha < Leaf v /\ Leaf v < c k lb \/ c k hb < Leaf v /\ Leaf v < c k la)
  | touching, supporting_axis x k =>
      if_so (k <? n) /\ as_long x la /\ in_box la ha x /\ in_box lb hb x /\
      (c k ha <= c k x /\ c k x <= c k lb \/ c k hb <= c k x /\ c k x <= c k la)
  | touching, flat_axis x k =>
      if_so (k <? n) /\ as_long x la /\ in_box la ha x /\ in_box lb hb x /\ (c k la = c k ha \/ c k lb = c k hb)
  | overlapping, common_interior_point x => as_long x la /\ inside la ha x /\ inside lb hb x
  | _, _ => No
  end.

(** [sphere_aabb] *)
Definition check_sphere_aabb (p : list A) (r : A) (l h : list A) (w : contact) (facts : solid_facts) : C :=
  let n := length p in
  let c := coordinate in
  let in_box x := on_each n (fun k => c k l <= c k x /\ c k x <= c k h) in
  let inside x := on_each n (fun k => c k l < c k x /\ c k x < c k h) in
  let nearest x :=
    on_each n (fun k => (c k x <= c k p \/ c k x = c k l) /\ (c k p <= c k x \/ c k x = c k h)) in
  let q x := squared_distance p x in
  if_so (two_or_three p) /\ as_long l p /\ as_long h p /\ zero <= Leaf r /\ on_each n (fun k => c k l <= c k h) /\
  match w, facts with
  | disjoint, nearest_point x => as_long x p /\ in_box x /\ nearest x /\ Leaf r * Leaf r < q x
  | touching, tangent x => as_long x p /\ in_box x /\ nearest x /\ q x = Leaf r * Leaf r
  | touching, flat_axis x k => if_so (k <? n) /\ as_long x p /\ in_box x /\ q x <= Leaf r * Leaf r /\ c k l = c k h
  | overlapping, common_interior_point x => as_long x p /\ inside x /\ q x < Leaf r * Leaf r
  | _, _ => No
  end.
End checks.
Arguments solid_facts : clear implicits.
