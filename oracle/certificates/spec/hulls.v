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
Definition closest_point_on_triangle_spec t p x s d : Prop := points_of 3 3 t /\ closest_point_spec 3 t p x s d.
(** Of the pairs that are as near as any, the one whose x is nearest to the first of a *)
Definition nearest_pair n (a b : list (list R)) (x y : list R) : Prop := hull n a x /\ hull n b y /\
  forall x' y', hull n a x' -> hull n b y' -> sqdist x y <= sqdist x' y' /\
    (sqdist x' y' = sqdist x y -> sqdist (hd nil a) x <= sqdist (hd nil a) x').
Definition segment_segment_distance_spec a b (x y : list R) (square distance : R) : Prop :=
  exists n, (n = 2 \/ n = 3)%nat /\ points_of 2 n a /\ points_of 2 n b /\ nearest_pair n a b x y /\
  distance_spec x y square distance.
(** A capsule is all that is no farther than r from a segment. *)
Definition capsule points (r : R) x : Prop := exists y, hull 3 points y /\ sqdist y x <= r * r.
Definition proper_capsule points r : Prop := points_of 2 3 points /\ 0 <= r.
Definition sphere_capsule_spec c (r : R) points (s : R) (w : contact) : Prop :=
  proper_ball 3 c r /\ proper_capsule points s /\ contact_spec 3 (ball c r) (capsule points s) w.
Definition capsule_with p r S w : Prop := proper_capsule p r /\ contact_spec 3 (capsule p r) S w.
Definition capsule_capsule_spec a r b s w := proper_capsule b s /\ capsule_with a r (capsule b s) w.
Definition capsule_aabb_spec p r low high w := proper_box 3 low high /\ capsule_with p r (box low high) w.
(** A triangle F has no interior: it overlaps a solid S where it has a point inside of it. *)
Definition flat_contact_spec (F S : list R -> Prop) (w : contact) : Prop :=
  match w with
  | disjoint => forall x, F x -> ~ S x
  | touching => (exists x, F x /\ S x) /\ forall x, F x -> ~ interior 3 S x
  | overlapping => exists x, F x /\ interior 3 S x
  end.
Definition triangle_with p S w : Prop := points_of 3 3 p /\ flat_contact_spec (hull 3 p) S w.
Definition sphere_triangle_spec c r points w := proper_ball 3 c r /\ triangle_with points (ball c r) w.
Definition capsule_triangle_spec p r points w := proper_capsule p r /\ triangle_with points (capsule p r) w.
Definition triangle_aabb_spec points low high w := proper_box 3 low high /\ triangle_with points (box low high) w.
(** An oriented box is all center + u h + v i + w j with -1 <= u, v, w <= 1, the half axes h, i, j being independent. *)
Definition obb (center : list R) (axes : list (list R)) (x : list R) : Prop :=
  exists u, length u = 3%nat /\ (forall a, In a u -> -1 <= a <= 1) /\ x = plus center (combined 3 u axes).
Definition right_obb (center : list R) (axes : list (list R)) : Prop :=
  length center = 3%nat /\ points_of 3 3 axes /\ forall u, length u = 3%nat -> nonzero u -> nonzero (combined 3 u axes).
Definition point_in_obb_spec center axes p (w : location) : Prop :=
  right_obb center axes /\ location_spec 3 (obb center axes) p w.
Definition obb_obb_spec c a d b w := right_obb c a /\ right_obb d b /\ contact_spec 3 (obb c a) (obb d b) w.
Definition triangle_obb_spec points c axes w := right_obb c axes /\ triangle_with points (obb c axes) w.
Definition aabb_obb_spec l h c a w := proper_box 3 l h /\ right_obb c a /\ contact_spec 3 (box l h) (obb c a) w.
Definition sphere_obb_spec c r o a w := proper_ball 3 c r /\ right_obb o a /\ contact_spec 3 (ball c r) (obb o a) w.
Definition capsule_obb_spec p r center axes w := right_obb center axes /\ capsule_with p r (obb center axes) w.
Definition obb_plane_spec c axes n d (w : contact) : Prop := right_obb c axes /\ over_half_space (obb c axes) n d w.
Definition capsule_plane_spec p r n d (w : contact) := proper_capsule p r /\ over_half_space (capsule p r) n d w.
Definition swept_capsule_plane_spec p r v n d w := proper_capsule p r /\ length v = 3%nat /\ length n = 3%nat /\
  nonzero n /\
  first_time_spec (fun t => exists x, length x = 3%nat /\ capsule p r x /\ dot n (at_time x v t) + d = 0) w.
(** * What a segment, a ray or a triangle has in common with a triangle *)
Inductive common (A : Type) := no_point | common_point (t : A) (p : list A) | common_segment (p q : list A).
Arguments no_point {A}. Arguments common_point {A}. Arguments common_segment {A}.
Definition segment_triangle_spec a b points (w : common R) : Prop :=
  length a = 3%nat /\ length b = 3%nat /\ points_of 3 3 points /\
  let passage := passage_spec (segment_in (hull 3 points) a b) in let at_t := at_time a (minus b a) in
  match w with
  | no_point => passage None
  | common_point t p => passage (Some (t, t)) /\ p = at_t t
  | common_segment p q => exists s t, s < t /\ passage (Some (s, t)) /\ p = at_t s /\ q = at_t t
  end.
Definition on_one_line (S : list R -> Prop) : Prop := exists x v, forall y, S y -> exists t, y = at_time x v t.
(** Of one common point it is told whether it is within a triangle that has an area; of more, only the first is told. *)
Inductive ray_common (A : Type) :=
  ray_misses | ray_hits (t : A) (p : list A) (within : bool) | ray_enters (t : A) (p : list A).
Arguments ray_misses {A}. Arguments ray_hits {A}. Arguments ray_enters {A}.
Definition ray_triangle_spec o d points (w : ray_common R) : Prop :=
  length o = 3%nat /\ length d = 3%nat /\ nonzero d /\ points_of 3 3 points /\
  let meets := ray_in (hull 3 points) o d in
  match w with
  | ray_misses => forall t, ~ meets t
  | ray_hits t p within => (forall u, meets u <-> u = t) /\ p = at_time o d t /\
      (within = true <-> ~ on_one_line (hull 3 points) /\ mixture (Rlt 0) 3 points p)
  | ray_enters t p => meets t /\ p = at_time o d t /\ (forall u, meets u -> t <= u) /\ exists u, t < u /\ meets u
  end.
Inductive dimension := common_none | common_one | common_line | common_area.
Definition triangle_triangle_spec a b (w : dimension) : Prop := points_of 3 3 a /\ points_of 3 3 b /\
  let both x := hull 3 a x /\ hull 3 b x in
  match w with
  | common_none => forall x, ~ both x
  | common_one => exists x, forall y, both y <-> y = x
  | common_line => on_one_line both /\ exists x y, both x /\ both y /\ x <> y
  | common_area => ~ on_one_line both
  end.
(** * Convex meshes: vertices, and faces of places among them. No vertex is in front of the plane of a face, and what is
    behind all these planes is the hull of the vertices: so both are the solid. *)
Definition plane_of (vertices : list (list R)) (face : list nat) (normal : list R) (offset : R) : Prop :=
  length normal = 3%nat /\ nonzero normal /\ (forall k, In k face -> dot normal (nth k vertices nil) + offset = 0) /\
  forall v, In v vertices -> half_space normal offset v.
Definition convex_mesh (vertices : list (list R)) (faces : list (list nat)) : Prop :=
  (forall v, In v vertices -> length v = 3%nat) /\
  (forall face, In face faces -> exists normal offset, plane_of vertices face normal offset) /\
  forall x, length x = 3%nat -> (hull 3 vertices x <-> forall face normal offset,
    In face faces -> plane_of vertices face normal offset -> half_space normal offset x).
Definition point_in_convex_polyhedron_spec vertices faces p (w : location) : Prop :=
  convex_mesh vertices faces /\ location_spec 3 (hull 3 vertices) p w.
(** [convex_distance]: two that have no common point have two nearest ones. *)
Definition convex_distance_spec va fa vb fb (w : option (list R * list R)) (square distance : R) : Prop :=
  convex_mesh va fa /\ convex_mesh vb fb /\
  match w with
  | None => (exists x, hull 3 va x /\ hull 3 vb x) /\ square = 0 /\ distance = 0
  | Some (x, y) => x <> y /\ nearest_pair 3 va vb x y /\ distance_spec x y square distance
  end.
Definition sphere_convex_spec c r v f w :=
  proper_ball 3 c r /\ convex_mesh v f /\ contact_spec 3 (ball c r) (hull 3 v) w.
Definition capsule_convex_spec p r v f w := convex_mesh v f /\ capsule_with p r (hull 3 v) w.
