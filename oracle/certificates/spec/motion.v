(* SPDX-License-Identifier: Apache-2.0 *)
(** What the answers claim of rays and segments through solids, and of shapes that move along straight lines. *)
Require Import Reals List. From Certificates Require Import solids. Open Scope R_scope.
(** A time that is written with a root is p + q sqrt(k). *)
Inductive surd (A : Type) := Surd (p q k : A). Arguments Surd {A}.
Definition surd_value (t : surd R) : R := let '(Surd p q k) := t in p + q * sqrt k.

(** * When a ray or a segment is in a set; one of length 0 is there at the time 0 alone. *)
Definition ray_in (S : list R -> Prop) start way (t : R) : Prop := 0 <= t /\ S (at_time start way t).
Definition segment_in (S : list R -> Prop) a b (t : R) : Prop :=
  0 <= t <= 1 /\ (a = b -> t = 0) /\ S (at_time a (minus b a) t).
(** That is so from the first such time to the last, if there are any. *)
Definition passage_spec (inside : R -> Prop) (w : option (R * R)) : Prop :=
  match w with
  | Some (first, last) => first <= last /\ forall t, inside t <-> first <= t <= last
  | None => forall t, ~ inside t
  end.
Definition ray_through S o d w : Prop := length d = length o /\ nonzero d /\ passage_spec (ray_in S o d) w.
Definition segment_through S a b w : Prop := length b = length a /\ passage_spec (segment_in S a b) w.
Definition ray_aabb_spec o d l h w : Prop := proper_box (length o) l h /\ ray_through (box l h) o d w.
Definition segment_aabb_spec a b l h w : Prop := proper_box (length a) l h /\ segment_through (box l h) a b w.
Definition ray_sphere_spec o d c r w : Prop := proper_ball (length o) c r /\ ray_through (ball c r) o d w.
Definition segment_sphere_spec a b c r w : Prop := proper_ball (length a) c r /\ segment_through (ball c r) a b w.

(** * The first time in [0, 1] at which shapes that move have a common point; of two boxes the first moves *)
Definition first_time_spec (meet : R -> Prop) (w : option R) : Prop :=
  match w with
  | Some t => 0 <= t <= 1 /\ meet t /\ forall u, 0 <= u < t -> ~ meet u
  | None => forall u, 0 <= u <= 1 -> ~ meet u
  end.
Definition swept_ball c r v (S : R -> list R -> Prop) t : Prop := proper_ball 3 c r /\ length v = 3%nat /\
  first_time_spec (fun t => exists x, length x = 3%nat /\ ball (at_time c v t) r x /\ S t x) t.
Definition swept_sphere_sphere_spec c r v d s w t : Prop := proper_ball 3 d s /\ length w = 3%nat /\
  swept_ball c r v (fun t => ball (at_time d w t) s) t.
Definition swept_sphere_plane_spec c r v normal offset t : Prop := length normal = 3%nat /\ nonzero normal /\
  swept_ball c r v (fun _ x => dot normal x + offset = 0) t.
Definition swept_sphere_aabb_spec c r v l h t : Prop := proper_box 3 l h /\ swept_ball c r v (fun _ => box l h) t.
Definition swept_aabb_aabb_spec la ha lb hb v t : Prop := proper_box (length v) la ha /\ proper_box (length v) lb hb /\
  first_time_spec (fun t => exists x, length x = length v /\ box la ha x /\ box lb hb (at_time x v t)) t.
