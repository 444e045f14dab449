(* SPDX-License-Identifier: Apache-2.0 *)
(** What the answers claim of points over lines and planes, and of rays and segments that meet planes. *)
Require Import Reals List. From Certificates Require Import solids. Open Scope R_scope.
(** A height compared with that of the ground: y = slope x + intercept for [explicit_line], y = 0 for
    [point_ground_plane] *)
Inductive elevation := above | level_with | below.
Definition elevation_spec (y ground : R) (w : elevation) : Prop :=
  match w with above => ground < y | level_with => y = ground | below => y < ground end.
Definition explicit_line_spec slope intercept (p : R * R) w : Prop :=
  elevation_spec (snd p) (slope * fst p + intercept) w.
Definition point_ground_plane_spec p w : Prop := length p = 3%nat /\ elevation_spec (nth 1 p 0) 0 w.
(** [point_plane]: the point is its foot on the plane and from there the signed distance along the normal, which is
    taken for a vector of length 1. *)
Inductive plane_side := front | on_plane | back.
Definition point_plane_spec (normal : list R) (offset : R) (p : list R) (w : plane_side) (distance : R) : Prop :=
  length normal = 3%nat /\ length p = 3%nat /\ nonzero normal /\
  (exists foot, length foot = 3%nat /\ dot normal foot + offset = 0 /\
     p = plus foot (times (distance / sqrt (dot normal normal)) normal)) /\
  match w with front => 0 < distance | on_plane => distance = 0 | back => distance < 0 end.

(** * The times of a ray, and of a segment *)
Definition of_ray (t : R) : Prop := 0 <= t.
Definition of_segment (t : R) : Prop := 0 <= t <= 1.
Inductive line_plane (A : Type) := misses_plane | crosses_plane (t : A) (p : list A) | inside_plane.
Arguments misses_plane {A}. Arguments crosses_plane {A}. Arguments inside_plane {A}.
Definition line_plane_spec (times : R -> Prop) start way normal (offset : R) (w : line_plane R) : Prop :=
  let on_the_plane t := dot normal (at_time start way t) + offset = 0 in
  match w with
  | misses_plane => forall t, times t -> ~ on_the_plane t
  | crosses_plane t p => times t /\ p = at_time start way t /\ forall u, times u -> (on_the_plane u <-> u = t)
  | inside_plane => forall t, times t -> on_the_plane t
  end.
Definition ray_plane_spec origin direction normal (offset : R) (w : line_plane R) : Prop :=
  length origin = 3%nat /\ length direction = 3%nat /\ length normal = 3%nat /\ nonzero direction /\ nonzero normal /\
  line_plane_spec of_ray origin direction normal offset w.
Definition segment_plane_spec a b normal (offset : R) (w : line_plane R) : Prop :=
  length a = 3%nat /\ length b = 3%nat /\ length normal = 3%nat /\ nonzero normal /\
  line_plane_spec of_segment a (minus b a) normal offset w.
