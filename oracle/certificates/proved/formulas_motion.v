(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of moving balls: the first zero of a polynomial. *)
Require Import ZArith List Arith.
From Certificates Require Import motion solids language formulas_vectors formulas_solids formulas_slabs.
Import ListNotations.
Local Open Scope check_scope.

Section checks.
Context {A : Type}.
Notation T := (term A). Notation C := (cond A).

(** The sign of p + q sqrt(k), k >= 0, is found by squares. *)
Definition not_positive (p q k : T) : C :=
  p <= zero /\ (q <= zero \/ q * q * k <= p * p) \/ q <= zero /\ p * p <= q * q * k.
Definition not_negative (p q k : T) : C := not_positive (zero - p) (zero - q) k.
Definition is_zero (p q k : T) : C := not_positive p q k /\ not_negative p q k.

(** What holds of c + b t + a t^2 at t = x + y sqrt(k): it is 0; and of its slope. *)
Definition zero_at (c b a x y k : T) : C := is_zero (c + b * x + a * (x * x + y * y * k)) (b * y + Num 2 * a * x * y) k.
Definition falls_at (b a x y k : T) : C := not_positive (b + Num 2 * a * x) (Num 2 * a * y) k.
Definition rises_at (b a x y k : T) : C := not_negative (b + Num 2 * a * x) (Num 2 * a * y) k.

Inductive zero_kind := start | first_root | receding | too_late | no_root.
(** The polynomial is positive for 0 <= t, or (with [ends]) for 0 <= t <= 1. *)
Definition stays_positive (ends : C) (c b a : T) (kind : zero_kind) : C :=
  zero < c /\
  match kind with
  | receding => zero <= b
  | too_late => ends /\ zero < c + b + a /\ Num 2 * a + b <= zero
  | no_root => b * b < Num 4 * a * c
  | _ => No
  end.
Definition first_zero_proves (c b a : T) (answer : option (surd A)) (kind : zero_kind) (facts : list A) : C :=
  same_vector (leaves facts) [c; b; a] /\
  match answer, kind with
  | Some (Surd x y k), start => c <= zero /\ zero <= Leaf k /\ is_zero (Leaf x) (Leaf y) (Leaf k)
  | Some (Surd x y k), first_root =>
      let x := Leaf x in let y := Leaf y in let k := Leaf k in
      zero < c /\ zero <= k /\ ~ not_positive x y k /\ not_positive (x - one) y k /\
      zero_at c b a x y k /\ falls_at b a x y k
  | None, _ => stays_positive Yes c b a kind
  | _, _ => No
  end.

(** [swept_sphere_sphere] *)
Definition check_swept_sphere_sphere (p : list A) (r : A) (v : list A) (o : list A) (s : A) (w : list A)
    (answer : option (surd A)) (kind : zero_kind) (facts : list A) : C :=
  let gap := difference (leaves p) (leaves o) in let rate := difference (leaves v) (leaves w) in
  of_length 3 p /\ of_length 3 v /\ of_length 3 o /\ of_length 3 w /\ zero <= Leaf r /\ zero <= Leaf s /\
  first_zero_proves (inner gap gap - (Leaf r + Leaf s) * (Leaf r + Leaf s)) (Num 2 * inner gap rate) (inner rate rate)
    answer kind facts.

(** (e + t N . v)^2 - r^2 N . N is at most 0 where the ball around a center of the height e, in units of |N|, meets the
    plane. *)
Definition approach_proves (e : T) (r : A) (v n : list A) : option (surd A) -> zero_kind -> list A -> C :=
  let rise := inner (leaves n) (leaves v) in
  first_zero_proves (e * e - Leaf r * Leaf r * inner (leaves n) (leaves n)) (Num 2 * e * rise) (rise * rise).

(** [swept_sphere_plane] *)
Definition check_swept_sphere_plane (c : list A) (r : A) (v n : list A) (d : A) (answer : option (surd A))
    (kind : zero_kind) (facts : list A) : C :=
  of_length 3 c /\ zero <= Leaf r /\ of_length 3 v /\ of_length 3 n /\ not_zero n /\
  approach_proves (height n d c) r v n answer kind facts.
End checks.
