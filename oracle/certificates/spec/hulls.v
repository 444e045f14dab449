(* SPDX-License-Identifier: Apache-2.0 *)
(** What the answers claim of segments and triangles, and of nearest points. *)
Require Import Reals List. From Certificates Require Import solids motion. Open Scope R_scope.

(** The sum of multiples of points of n dimensions, and all that is between the points: a segment, a triangle *)
Fixpoint combined (n : nat) (w : list R) (points : list (list R)) : list R :=
  match w, points with a :: w', p :: points' => plus (times a p) (combined n w' points') | _, _ => repeat 0 n end.
Definition mixture (weight : R -> Prop) (n : nat) (points : list (list R)) (x : list R) : Prop :=
  exists w, length w = length points /\ (forall a, In a w -> weight a) /\ fold_right Rplus 0 w = 1 /\
  x = combined n w points.
Definition hull : nat -> list (list R) -> list R -> Prop := mixture (Rle 0).
Definition points_of (count n : nat) (points : list (list R)) : Prop :=
  length points = count /\ forall p, In p points -> length p = n.

Definition distance_spec (x y : list R) (square distance : R) : Prop :=
  square = sqdist x y /\ 0 <= distance /\ distance * distance = square.
Definition closest_point_spec n points (p x : list R) (square distance : R) : Prop :=
  length p = n /\ hull n points x /\ (forall y, hull n points y -> sqdist p x <= sqdist p y) /\
  distance_spec p x square distance.
Definition closest_point_on_segment_spec points p x (square distance : R) : Prop :=
  exists n, (n = 2 \/ n = 3)%nat /\ points_of 2 n points /\ closest_point_spec n points p x square distance.
Definition closest_point_on_triangle_spec points p x (square distance : R) : Prop :=
  points_of 3 3 points /\ closest_point_spec 3 points p x square distance.
(** Of the pairs that are as near as any, the one whose x is nearest to the beginning of a *)
Definition segment_segment_distance_spec (a b : list (list R)) (x y : list R) (square distance : R) : Prop :=
  exists n, (n = 2 \/ n = 3)%nat /\ points_of 2 n a /\ points_of 2 n b /\ hull n a x /\ hull n b y /\
  (forall x' y', hull n a x' -> hull n b y' -> sqdist x y <= sqdist x' y' /\
     (sqdist x' y' = sqdist x y -> sqdist (hd nil a) x <= sqdist (hd nil a) x')) /\
  distance_spec x y square distance.
(** A capsule is all that is no farther than r from a segment. *)
Definition capsule points (r : R) x : Prop := exists y, hull 3 points y /\ sqdist y x <= r * r.
Definition sphere_capsule_spec c (r : R) points (s : R) (w : contact) : Prop :=
  proper_ball 3 c r /\ points_of 2 3 points /\ 0 <= s /\ contact_spec 3 (ball c r) (capsule points s) w.
Definition capsule_capsule_spec a (r : R) b (s : R) (w : contact) : Prop :=
  points_of 2 3 a /\ points_of 2 3 b /\ 0 <= r /\ 0 <= s /\ contact_spec 3 (capsule a r) (capsule b s) w.
(** A triangle F has no interior: it overlaps a solid S where it has a point inside of it. *)
Definition flat_contact_spec (F S : list R -> Prop) (w : contact) : Prop :=
  match w with
  | disjoint => forall x, F x -> ~ S x
  | touching => (exists x, F x /\ S x) /\ forall x, F x -> ~ interior 3 S x
  | overlapping => exists x, F x /\ interior 3 S x
  end.
Definition sphere_triangle_spec c (r : R) points (w : contact) : Prop :=
  proper_ball 3 c r /\ points_of 3 3 points /\ flat_contact_spec (hull 3 points) (ball c r) w.
Definition triangle_aabb_spec points low high (w : contact) : Prop :=
  points_of 3 3 points /\ proper_box 3 low high /\ flat_contact_spec (hull 3 points) (box low high) w.
(** An oriented box is all center + u h + v i + w j with -1 <= u, v, w <= 1, the half axes h, i, j being independent. *)
Definition obb (center : list R) (axes : list (list R)) (x : list R) : Prop :=
  exists u, length u = 3%nat /\ (forall a, In a u -> -1 <= a <= 1) /\ x = plus center (combined 3 u axes).
Definition right_obb (center : list R) (axes : list (list R)) : Prop :=
  length center = 3%nat /\ points_of 3 3 axes /\ forall u, length u = 3%nat -> nonzero u -> nonzero (combined 3 u axes).
Definition point_in_obb_spec center axes p (w : location) : Prop :=
  right_obb center axes /\ location_spec 3 (obb center axes) p w.
Definition obb_obb_spec center_a axes_a center_b axes_b (w : contact) : Prop :=
  right_obb center_a axes_a /\ right_obb center_b axes_b /\
  contact_spec 3 (obb center_a axes_a) (obb center_b axes_b) w.
