(* SPDX-License-Identifier: Apache-2.0 *)
(** What the answers claim of solids: whether two have a common point, and whether one is inside both. *)
Require Import Reals List. Open Scope R_scope.
(** * Space of n dimensions: lists of n real numbers *)
Fixpoint sqdist (x y : list R) : R :=
  match x, y with a :: x', b :: y' => (a - b) * (a - b) + sqdist x' y' | _, _ => 0 end.
(** A set holds all points around x that are nearer than some e > 0. *)
Definition interior (n : nat) (S : list R -> Prop) (x : list R) : Prop :=
  length x = n /\ exists e, 0 < e /\ forall y, length y = n -> sqdist x y < e * e -> S y.
Inductive contact := disjoint | touching | overlapping.
Definition contact_spec (n : nat) (S T : list R -> Prop) (w : contact) : Prop :=
  match w with
  | disjoint => forall x, length x = n -> ~ (S x /\ T x)
  | touching => (exists x, length x = n /\ S x /\ T x) /\ forall x, ~ (interior n S x /\ interior n T x)
  | overlapping => exists x, interior n S x /\ interior n T x
  end.
Inductive location := inside | boundary | outside.
Definition location_spec (n : nat) (S : list R -> Prop) (x : list R) (w : location) : Prop :=
  length x = n /\
  match w with
  | inside => interior n S x
  | boundary => S x /\ ~ interior n S x
  | outside => ~ S x
  end.
Definition ball (c : list R) (r : R) (x : list R) : Prop := sqdist c x <= r * r.
Definition box (low high x : list R) : Prop :=
  forall k, (k < length x)%nat -> nth k low 0 <= nth k x 0 <= nth k high 0.
(** Discs and rectangles for n = 2, balls and boxes for n = 3 *)
Definition proper_ball (n : nat) (c : list R) (r : R) : Prop := (n = 2 \/ n = 3)%nat /\ length c = n /\ 0 <= r.
Definition proper_box (n : nat) (low high : list R) : Prop := (n = 2 \/ n = 3)%nat /\ length low = n /\
  length high = n /\ forall k, (k < n)%nat -> nth k low 0 <= nth k high 0.
Definition sphere_sphere_spec (c : list R) (r : R) (d : list R) (s : R) (w : contact) : Prop :=
  exists n, proper_ball n c r /\ proper_ball n d s /\ contact_spec n (ball c r) (ball d s) w.
Definition aabb_aabb_spec (la ha lb hb : list R) (w : contact) : Prop :=
  exists n, proper_box n la ha /\ proper_box n lb hb /\ contact_spec n (box la ha) (box lb hb) w.
Definition sphere_aabb_spec (c : list R) (r : R) (l h : list R) (w : contact) : Prop :=
  exists n, proper_ball n c r /\ proper_box n l h /\ contact_spec n (ball c r) (box l h) w.
Definition implicit_circle_spec c r p (w : location) : Prop := proper_ball 2 c r /\ location_spec 2 (ball c r) p w.

(** * Half-spaces and slabs of space *)
Fixpoint dot (x y : list R) : R := match x, y with a :: x', b :: y' => a * b + dot x' y' | _, _ => 0 end.
Definition nonzero (x : list R) : Prop := exists a, In a x /\ a <> 0.
(** The plane normal . x + offset = 0 and what is behind it, where the normal does not point *)
Definition half_space (normal : list R) (offset : R) (x : list R) : Prop := dot normal x + offset <= 0.
Definition over_half_space (S : list R -> Prop) (normal : list R) (offset : R) (w : contact) : Prop :=
  length normal = 3%nat /\ nonzero normal /\ contact_spec 3 S (half_space normal offset) w.
Definition sphere_plane_spec c r n d (w : contact) : Prop := proper_ball 3 c r /\ over_half_space (ball c r) n d w.
Definition aabb_plane_spec l h n d (w : contact) : Prop := proper_box 3 l h /\ over_half_space (box l h) n d w.
(** A slab (normal, (low, high)), and the solid that several have in common, a k-DOP *)
Definition slab (A : Type) : Type := list A * (A * A).
Definition in_slab (s : slab R) (x : list R) : Prop := let '(n, (low, high)) := s in low <= dot n x <= high.
Definition kdop (slabs : list (slab R)) (x : list R) : Prop := forall s, In s slabs -> in_slab s x.
Definition proper_slab (s : slab R) : Prop :=
  let '(n, (low, high)) := s in length n = 3%nat /\ nonzero n /\ low <= high.
Definition point_in_kdop_spec (slabs : list (slab R)) (p : list R) (w : location) : Prop :=
  slabs <> nil /\ (forall s, In s slabs -> proper_slab s) /\ location_spec 3 (kdop slabs) p w.
(** [kdop_kdop] compares the slabs of each normal as intervals, and no more: [touching] where some pair of them has one
    number in common alone. *)
Definition shared (s t : slab R) (v : R) : Prop :=
  fst (snd s) <= v <= snd (snd s) /\ fst (snd t) <= v <= snd (snd t).
Definition kdop_kdop_spec (a b : list (slab R)) (w : contact) : Prop :=
  a <> nil /\ (forall s, In s a \/ In s b -> proper_slab s) /\ map fst a = map fst b /\
  let each (P : slab R -> slab R -> Prop) := forall s t, In (s, t) (combine a b) -> P s t in
  let some (P : slab R -> slab R -> Prop) := exists s t, In (s, t) (combine a b) /\ P s t in
  match w with
  | disjoint => some (fun s t => forall v, ~ shared s t v)
  | touching => each (fun s t => exists v, shared s t v) /\
                some (fun s t => forall u v, shared s t u -> shared s t v -> u = v)
  | overlapping => each (fun s t => exists u v, u < v /\ shared s t u /\ shared s t v)
  end.

(** * Sums and multiples of vectors *)
Fixpoint plus (x y : list R) : list R := match x, y with a :: x', b :: y' => a + b :: plus x' y' | _, _ => nil end.
Fixpoint minus (x y : list R) : list R := match x, y with a :: x', b :: y' => a - b :: minus x' y' | _, _ => nil end.
Definition times (t : R) (x : list R) : list R := map (Rmult t) x.
(** The place at the time t of what starts there and moves by [way] in a unit of time *)
Definition at_time (start way : list R) (t : R) : list R := plus start (times t way).
(** [closest_point_on_aabb], of the plane and of space *)
Definition closest_point_on_aabb_spec (p low high x : list R) : Prop :=
  exists n, proper_box n low high /\ length p = n /\ length x = n /\ box low high x /\
  forall y, length y = n -> box low high y -> sqdist p x <= sqdist p y.
(** The least interval, box or slabs around points *)
Definition least_interval (values : list R) (low high : R) : Prop :=
  In low values /\ In high values /\ forall v, In v values -> low <= v <= high.
Definition aabb_of_points_spec (points : list (list R)) (low high : list R) : Prop :=
  exists n, (n = 2 \/ n = 3)%nat /\ length low = n /\ length high = n /\ (forall p, In p points -> length p = n) /\
  forall k, (k < n)%nat -> least_interval (map (fun p => nth k p 0) points) (nth k low 0) (nth k high 0).
Definition kdop_of_points_spec (points normals : list (list R)) (slabs : list (R * R)) : Prop :=
  (forall p, In p points -> length p = 3%nat) /\ (forall n, In n normals -> length n = 3%nat /\ nonzero n) /\
  normals <> nil /\ Forall2 (fun n s => least_interval (map (dot n) points) (fst s) (snd s)) normals slabs.
(** [bounding_sphere]: the least ball around its center that holds all points. The center is the middle of their box, or
    their mean, or such that no other ball that holds them is smaller. *)
Inductive sphere_method := around_box | around_mean | smallest.
Definition bounding_sphere_spec (points : list (list R)) (method : sphere_method) (c : list R) (r : R) : Prop :=
  let holds d s := proper_ball 3 d s /\ forall p, In p points -> ball d s p in
  points <> nil /\ (forall p, In p points -> length p = 3%nat) /\ holds c r /\ (forall s, holds c s -> r <= s) /\
  match method with
  | around_box => exists low high, aabb_of_points_spec points low high /\ c = times (1 / 2) (plus low high)
  | around_mean => c = times (1 / INR (length points)) (fold_right plus (repeat 0 3) points)
  | smallest => forall d s, holds d s -> r <= s
  end.
