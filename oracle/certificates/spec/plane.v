(* SPDX-License-Identifier: Apache-2.0 *)
(** What the answers claim of points, segments, lines and rays of the plane. The files of this folder speak of points,
    sets and distances of the real plane and real space, [numbers] of doubles, and of nothing else: no rational number,
    certificate or algorithm occurs in them. They are all that one has to read to trust it. Shapes are closed sets. *)
Require Import Reals List. Open Scope R_scope.
Definition vec2 (A : Type) : Type := A * A.
Definition seg2 (A : Type) : Type := vec2 A * vec2 A.
Definition along (s : seg2 R) (t : R) : vec2 R :=
  let '((ax, ay), (bx, by_)) := s in (ax + t * (bx - ax), ay + t * (by_ - ay)).
Definition on_segment (s : seg2 R) (p : vec2 R) : Prop := exists t, 0 <= t <= 1 /\ p = along s t.
Definition on_line (s : seg2 R) (p : vec2 R) : Prop := exists t, p = along s t.
(** The parameter of a point on a segment; on one of length 0 it is 0. *)
Definition parameter (s : seg2 R) (t : R) (p : vec2 R) : Prop :=
  0 <= t <= 1 /\ p = along s t /\ (fst s = snd s -> t = 0).
Definition before (p q : vec2 R) : Prop := fst p < fst q \/ (fst p = fst q /\ snd p < snd q).
(** [orientation]: with d = p1 - p0 and d turned by a quarter counter-clockwise, which is (-d.y, d.x),
    p = p0 + t d + h turned d, and the sign of h is the side. *)
Inductive side := left | right | on.
Definition beside (p0 p1 p : vec2 R) (t h : R) : Prop :=
  let dx := fst p1 - fst p0 in let dy := snd p1 - snd p0 in
  fst p = fst p0 + t * dx + h * - dy /\ snd p = snd p0 + t * dy + h * dx.
Definition orientation_spec (p0 p1 p : vec2 R) (w : side) : Prop :=
  match w with
  | left => p0 <> p1 /\ exists t h, beside p0 p1 p t h /\ 0 < h
  | right => p0 <> p1 /\ exists t h, beside p0 p1 p t h /\ h < 0
  | on => p0 = p1 \/ on_line (p0, p1) p
  end.
(** [point_on_segment] *)
Inductive incidence (A : Type) := off | at_parameter (t : A). Arguments off {A}. Arguments at_parameter {A}.
Definition point_on_segment_spec (p : vec2 R) (s : seg2 R) (w : incidence R) : Prop :=
  match w with off => ~ on_segment s p | at_parameter t => parameter s t p end.
(** [segment_segment]: the answer is the set of the common points, exactly. *)
Inductive meeting (A : Type) := apart | point (ta tb : A) (p : vec2 A) | overlap (p q : vec2 A).
Arguments apart {A}. Arguments point {A}. Arguments overlap {A}.
Definition segment_segment_spec (a b : seg2 R) (w : meeting R) : Prop :=
  match w with
  | apart => forall x, ~ (on_segment a x /\ on_segment b x)
  | point ta tb p => (forall x, on_segment a x /\ on_segment b x <-> x = p) /\ parameter a ta p /\ parameter b tb p
  | overlap p q => (forall x, on_segment a x /\ on_segment b x <-> on_segment (p, q) x) /\ before p q
  end.
(** [line_line]: lines through two points *)
Inductive lines (A : Type) := crossing (ta tb : A) (p : vec2 A) | parallel | same.
Arguments crossing {A}. Arguments parallel {A}. Arguments same {A}.
Definition line_line_spec (a b : seg2 R) (w : lines R) : Prop :=
  fst a <> snd a /\ fst b <> snd b /\
  match w with
  | crossing ta tb p => (forall x, on_line a x /\ on_line b x <-> x = p) /\ p = along a ta /\ p = along b tb
  | parallel => forall x, ~ (on_line a x /\ on_line b x)
  | same => forall x, on_line a x <-> on_line b x
  end.
(** [ray_segment]: the ray from o in the direction d, which is not 0; an overlap runs in the ray's direction *)
Definition on_ray_at (o d : vec2 R) (t : R) (p : vec2 R) : Prop :=
  0 <= t /\ p = (fst o + t * fst d, snd o + t * snd d).
Definition on_ray (o d p : vec2 R) : Prop := exists t, on_ray_at o d t p.
Inductive hit (A : Type) := missed | hit_point (t : A) (p : vec2 A) | hit_overlap (t : A) (p q : vec2 A).
Arguments missed {A}. Arguments hit_point {A}. Arguments hit_overlap {A}.
Definition ray_segment_spec (o d : vec2 R) (s : seg2 R) (w : hit R) : Prop :=
  d <> (0, 0) /\
  match w with
  | missed => forall x, ~ (on_ray o d x /\ on_segment s x)
  | hit_point t p => (forall x, on_ray o d x /\ on_segment s x <-> x = p) /\ on_ray_at o d t p
  | hit_overlap t p q => (forall x, on_ray o d x /\ on_segment s x <-> on_segment (p, q) x) /\
                         on_ray_at o d t p /\ exists u, t < u /\ on_ray_at o d u q
  end.
