(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of heights over lines and planes, and of rays and segments that meet a plane. *)
Require Import ZArith List Arith.
From Certificates Require Import solids planes language formulas_vectors formulas_slabs.
Import ListNotations.
Local Open Scope check_scope.

Section checks.
Context {A : Type}.
Notation T := (term A). Notation C := (cond A).

Definition elevation_of (h : T) (w : elevation) : C :=
  match w with above => zero < h | level_with => h = zero | below => h < zero end.

(** [explicit_line], kind [height] *)
Definition check_explicit_line (slope intercept : A) (p : A * A) (w : elevation) (h : A) : C :=
  Leaf h = Leaf (snd p) - (Leaf slope * Leaf (fst p) + Leaf intercept) /\ elevation_of (Leaf h) w.

(** [point_ground_plane], kind [height] *)
Definition check_point_ground_plane (p : list A) (w : elevation) (h : A) : C :=
  match p with (x :: y :: z :: nil)%list => Leaf h = Leaf y /\ elevation_of (Leaf h) w | _ => No end.

(** [point_plane], kind [root] *)
Definition check_point_plane (n : list A) (d : A) (p : list A) (w : plane_side) (distance : A) : C :=
  let e := height n d p in
  of_length 3 n /\ of_length 3 p /\ not_zero n /\
  Leaf distance * Leaf distance * inner (leaves n) (leaves n) = e * e /\
  match w with
  | front => zero < e /\ zero < Leaf distance
  | on_plane => e = zero /\ Leaf distance = zero
  | back => e < zero /\ Leaf distance < zero
  end.

Definition at_term (start way : list T) (t : T) : list T := sum_of start (scaled t way).

(** What ray and segment share: the heights over the plane at t = 0 and at t = 1 *)
Definition heights_prove (ends : bool) (start way : list T) (n : list A) (d : A) (w : line_plane A)
    (first second : A) : C :=
  let climb := Leaf second - Leaf first in
  Leaf first = inner (leaves n) start + Leaf d /\ climb = inner (leaves n) way /\
  match w with
  | inside_plane => Leaf first = zero /\ Leaf second = zero
  | misses_plane =>
      if ends then zero < Leaf first * Leaf second else ~ (Leaf first = zero) /\ zero <= Leaf first * climb
  | crosses_plane t p =>
      ~ (climb = zero) /\ zero <= Leaf t /\ (if ends then Leaf t <= one else Yes) /\
      Leaf first + Leaf t * climb = zero /\
      same_vector (leaves p) (at_term start way (Leaf t))
  end.

(** [ray_plane], kind [heights] *)
Definition check_ray_plane (origin direction n : list A) (d : A) (w : line_plane A) (first second : A) : C :=
  of_length 3 origin /\ of_length 3 direction /\ of_length 3 n /\ not_zero direction /\ not_zero n /\
  heights_prove false (leaves origin) (leaves direction) n d w first second.

(** [segment_plane], kind [heights] *)
Definition check_segment_plane (a b n : list A) (d : A) (w : line_plane A) (first second : A) : C :=
  of_length 3 a /\ of_length 3 b /\ of_length 3 n /\ not_zero n /\
  heights_prove true (leaves a) (difference (leaves b) (leaves a)) n d w first second.
End checks.
