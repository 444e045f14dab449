(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of discs, half-spaces and slabs, and of the point of a box that is nearest to another. *)
Require Import ZArith List Arith.
From Certificates Require Import solids language formulas_vectors formulas_solids.
Import ListNotations.
Local Open Scope check_scope.

Section checks.
Context {A : Type}.
Notation T := (term A). Notation C := (cond A).

(** [implicit_circle] *)
Definition check_implicit_circle (c : list A) (r : A) (p : list A) (w : location) (distance radius : A) : C :=
  of_length 2 c /\ of_length 2 p /\ zero <= Leaf r /\
  Leaf distance = squared_distance c p /\ Leaf radius = Leaf r * Leaf r /\
  match w with
  | inside => Leaf distance < Leaf radius
  | boundary => Leaf distance = Leaf radius
  | outside => Leaf radius < Leaf distance
  end.

Definition height (normal : list A) (offset : A) (x : list A) : T := inner (leaves normal) (leaves x) + Leaf offset.

Inductive plane_facts :=
| nearest_in_half_space (x : list A)
| tangent_to_plane (x : list A)
| common_point_inside (x : list A)
| lowest_point (x : list A)
| flat_box (x : list A) (axis : nat).

(** [sphere_plane] *)
Definition check_sphere_plane (c : list A) (r : A) (n : list A) (d : A) (w : contact) (facts : plane_facts) : C :=
  let beyond x := difference (leaves c) (leaves x) in
  let along x := inner (leaves n) (beyond x) in
  let nearest x :=
    height n d x <= zero /\ zero <= along x /\ along x * height n d x = zero /\
    along x * along x = inner (beyond x) (beyond x) * inner (leaves n) (leaves n) in
  of_length 3 c /\ of_length 3 n /\ zero <= Leaf r /\ not_zero n /\
  match w, facts with
  | disjoint, nearest_in_half_space x => of_length 3 x /\ nearest x /\ Leaf r * Leaf r < squared_distance c x
  | touching, tangent_to_plane x => of_length 3 x /\ nearest x /\ squared_distance c x = Leaf r * Leaf r
  | overlapping, common_point_inside x => of_length 3 x /\ height n d x < zero /\ squared_distance c x < Leaf r * Leaf r
  | _, _ => No
  end.

(** [aabb_plane] *)
Definition check_aabb_plane (low high n : list A) (d : A) (w : contact) (facts : plane_facts) : C :=
  let c := coordinate in
  let in_box x := on_each 3 (fun k => c k low <= c k x /\ c k x <= c k high) in
  let lowest x := on_each 3 (fun k => (c k n <= zero \/ c k x = c k low) /\ (zero <= c k n \/ c k x = c k high)) in
  of_length 3 low /\ of_length 3 high /\ of_length 3 n /\ not_zero n /\ on_each 3 (fun k => c k low <= c k high) /\
  match w, facts with
  | disjoint, lowest_point x => of_length 3 x /\ in_box x /\ lowest x /\ zero < height n d x
  | touching, lowest_point x => of_length 3 x /\ in_box x /\ lowest x /\ height n d x = zero
  | touching, flat_box x k => of_length 3 x /\ in_box x /\ height n d x <= zero /\ if_so (k <? 3) /\ c k low = c k high
  | overlapping, common_point_inside x =>
      of_length 3 x /\ on_each 3 (fun k => c k low < c k x /\ c k x < c k high) /\ height n d x < zero
  | _, _ => No
  end.

Definition slab_value (s : slab A) (x : list A) : T := inner (leaves (fst s)) (leaves x).
Definition least (s : slab A) : T := Leaf (fst (snd s)).
Definition most (s : slab A) : T := Leaf (snd (snd s)).
Definition right_slab (s : slab A) : C := of_length 3 (fst s) /\ not_zero (fst s) /\ least s <= most s.
Definition right_slabs (l : list (slab A)) : C := if_so (negb (length l =? 0)) /\ all right_slab l.
Definition at_index {B} (k : nat) (l : list B) (f : B -> C) : C :=
  match nth_error l k with Some s => f s | None => No end.

Inductive slab_facts := all_values (v : list A) | end_of_slab (k : nat) (v : A) | beyond_slab (k : nat) (v : A).

(** [point_in_kdop] *)
Definition check_point_in_kdop (slabs : list (slab A)) (p : list A) (w : location) (facts : slab_facts) : C :=
  let holds s := least s <= slab_value s p /\ slab_value s p <= most s in
  right_slabs slabs /\ of_length 3 p /\
  match w, facts with
  | inside, all_values v =>
      same_vector (leaves v) (map (fun s => slab_value s p) slabs) /\
      all (fun s => least s < slab_value s p /\ slab_value s p < most s) slabs
  | boundary, end_of_slab k v =>
      at_index k slabs (fun s => Leaf v = slab_value s p /\ (Leaf v = least s \/ Leaf v = most s)) /\ all holds slabs
  | outside, beyond_slab k v =>
      at_index k slabs (fun s => Leaf v = slab_value s p /\ (Leaf v < least s \/ most s < Leaf v))
  | _, _ => No
  end.

Inductive slabs_facts := separating_slab (k : nat) (v : A) | touching_slab (k : nat) (v : list A)
  | common_values (v : list A).

(** [kdop_kdop] *)
Definition check_kdop_kdop (a b : list (slab A)) (w : contact) (facts : slabs_facts) : C :=
  let both := combine a b in
  let each_with v f := if_so (length v =? length both) /\ all f (combine v both) in
  right_slabs a /\ right_slabs b /\ if_so (length a =? length b) /\
  all (fun p => same_vector (leaves (fst (fst p))) (leaves (fst (snd p)))) both /\
  match w, facts with
  | disjoint, separating_slab k v =>
      at_index k both (fun p => most (fst p) < Leaf v /\ Leaf v < least (snd p) \/ most (snd p) < Leaf v /\
        Leaf v < least (fst p))
  | touching, touching_slab k v =>
      each_with v (fun q => let '(x, (s, t)) := q in
        least s <= Leaf x /\ Leaf x <= most s /\ least t <= Leaf x /\ Leaf x <= most t) /\
      at_index k both (fun p => let '(s, t) := p in
        least s = most s \/ least t = most t \/ most s = least t \/ most t = least s)
  | overlapping, common_values v =>
      each_with v (fun q => let '(x, (s, t)) := q in
        least s < Leaf x /\ Leaf x < most s /\ least t < Leaf x /\ Leaf x < most t)
  | _, _ => No
  end.

(** [closest_point_on_aabb], kind [multipliers] *)
Definition check_closest_point_on_aabb (p low high x lower upper : list A) : C :=
  let n := length p in
  let c := coordinate in
  if_so (two_or_three p) /\ as_long low p /\ as_long high p /\ as_long x p /\ as_long lower p /\ as_long upper p /\
  on_each n (fun k => c k low <= c k high) /\
  on_each n (fun k => c k low <= c k x /\ c k x <= c k high) /\
  on_each n (fun k => zero <= c k lower /\ zero <= c k upper /\ (c k lower = zero \/ c k x = c k low) /\
                      (c k upper = zero \/ c k x = c k high) /\ c k x - c k p = c k lower - c k upper).
End checks.
Arguments plane_facts : clear implicits. Arguments slab_facts : clear implicits.
  Arguments slabs_facts : clear implicits.
