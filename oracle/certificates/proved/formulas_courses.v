(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of rays and segments through boxes and balls, and of boxes that move. *)
Require Import ZArith List Arith.
From Certificates Require Import motion solids language formulas_vectors formulas_solids formulas_heights
  formulas_capsules formulas_motion.
Import ListNotations.
Local Open Scope check_scope.

Section checks.
Context {A : Type}.
Notation T := (term A). Notation C := (cond A).

Fixpoint on_some (n : nat) (f : nat -> C) : C := match n with 0%nat => No | S k => on_some k f \/ f k end.
(** The greatest n . x of a box *)
Fixpoint highest_of_box (n low high : list A) : T :=
  match n, low, high with
  | c :: n', l :: low', h :: high' => Max (Leaf c * Leaf l) (Leaf c * Leaf h) + highest_of_box n' low' high'
  | _, _, _ => zero
  end.
Definition is_box (n : nat) (low high : list A) : C :=
  if_so (orb (n =? 2) (n =? 3)) /\ of_length n low /\ of_length n high /\
  on_each n (fun k => coordinate k low <= coordinate k high).
Definition box_holds (low high : list A) (x : list T) : C :=
  on_each (length low) (fun k => coordinate k low <= nth k x zero /\ nth k x zero <= coordinate k high).

(** A course is start + t way for 0 <= t, and where it [ends] for t <= 1; without a way it is its start. *)
Inductive course_facts := passage | beyond_box (n : list A).
Definition is_still (way : list T) : C := all (fun t => t = zero) way.
Definition box_passage_proves (ends : bool) (start way : list T) (low high : list A) (w : option (A * A))
    (facts : course_facts) : C :=
  let x t k := nth k (at_term start way t) zero in
  let v k := nth k way zero in
  let comes_in t := on_some (length low) (fun k => v k < zero /\ x t k = coordinate k high \/
                                                   zero < v k /\ x t k = coordinate k low) in
  let goes_out t := on_some (length low) (fun k => zero < v k /\ x t k = coordinate k high \/
                                                   v k < zero /\ x t k = coordinate k low) in
  match w, facts with
  | Some (first, last), passage =>
      let first := Leaf first in let last := Leaf last in
      zero <= first /\ box_holds low high (at_term start way first) /\ (first = zero \/ comes_in first) /\
      first <= last /\ (if ends then last <= one else Yes) /\ box_holds low high (at_term start way last) /\
      ((if ends then is_still way /\ last = zero \/ ~ is_still way /\ last = one else No) \/ goes_out last)
  | None, beyond_box n =>
      let at_start := inner (leaves n) start in let rate := inner (leaves n) way in
      of_length (length low) n /\ highest_of_box n low high < at_start /\
      (if ends then highest_of_box n low high < at_start + rate else zero <= rate)
  | _, _ => No
  end.

(** [ray_aabb] *)
Definition check_ray_aabb (o d low high : list A) (w : option (A * A)) (facts : course_facts) : C :=
  is_box (length o) low high /\ as_long d o /\ not_zero d /\
  box_passage_proves false (leaves o) (leaves d) low high w facts.

(** [segment_aabb] *)
Definition check_segment_aabb (a b low high : list A) (w : option (A * A)) (facts : course_facts) : C :=
  is_box (length a) low high /\ as_long b a /\
  box_passage_proves true (leaves a) (difference (leaves b) (leaves a)) low high w facts.

(** The polynomial c + b t + a t^2 is the squared distance from the center less the squared radius. It is zero first and
    last, or the course begins or ends where it is not positive. The [kind] is of no use where there is an answer. *)
Definition ball_passage_proves (ends : bool) (from way : list T) (r : A) (w : option (surd A * surd A))
    (kind : option zero_kind) : C :=
  let c := inner from from - Leaf r * Leaf r in let b := Num 2 * inner from way in let a := inner way way in
  let until x y k := if ends then not_positive (x - one) y k else Yes in
  match w, kind with
  | Some (Surd x y k, Surd x' y' k'), None =>
      let x := Leaf x in let y := Leaf y in let k := Leaf k in
      let x' := Leaf x' in let y' := Leaf y' in let k' := Leaf k' in
      zero <= k /\ zero <= k' /\
      (is_zero x y k /\ c <= zero \/
       zero < a /\ ~ not_positive x y k /\ zero_at c b a x y k /\ falls_at b a x y k /\ until x y k) /\
      (a = zero /\ is_zero x' y' k' \/
       zero < a /\ (if ends then is_zero (x' - one) y' k' /\ c + b + a <= zero else No) \/
       zero < a /\ not_negative x' y' k' /\ zero_at c b a x' y' k' /\ rises_at b a x' y' k' /\ until x' y' k')
  | None, Some kind => stays_positive (if ends then Yes else No) c b a kind
  | _, _ => No
  end.
Definition is_ball (n : nat) (c : list A) (r : A) : C :=
  if_so (orb (n =? 2) (n =? 3)) /\ of_length n c /\ zero <= Leaf r.

(** [ray_sphere] *)
Definition check_ray_sphere (o d c : list A) (r : A) (w : option (surd A * surd A)) (kind : option zero_kind) : C :=
  is_ball (length o) c r /\ as_long d o /\ not_zero d /\
  ball_passage_proves false (difference (leaves o) (leaves c)) (leaves d) r w kind.

(** [segment_sphere] *)
Definition check_segment_sphere (a b c : list A) (r : A) (w : option (surd A * surd A)) (kind : option zero_kind) : C :=
  is_ball (length a) c r /\ as_long b a /\
  ball_passage_proves true (difference (leaves a) (leaves c)) (difference (leaves b) (leaves a)) r w kind.

Inductive contact_facts := start_in_both (p : list A) | first_contact (p n : list A) | never_in_both (n : list A).

(** [swept_aabb_aabb] *)
Definition check_swept_aabb_aabb (la ha lb hb v : list A) (w : option A) (facts : contact_facts) : C :=
  let size := length v in
  let both p t := of_length size p /\ box_holds lb hb (leaves p) /\
    box_holds la ha (difference (leaves p) (scaled t (leaves v))) in
  is_box size la ha /\ is_box size lb hb /\
  match w, facts with
  | Some t, start_in_both p => Leaf t = zero /\ both p (Leaf t)
  | Some t, first_contact p n =>
      let speed := inner (leaves n) (leaves v) in
      zero < Leaf t /\ Leaf t <= one /\ both p (Leaf t) /\ of_length size n /\ zero < speed /\
      highest_of_box n la ha + Leaf t * speed <= lowest_of_box n lb hb
  | None, never_in_both n => of_length size n /\ highest_of_box n la ha < lowest_of_box n lb hb /\
      highest_of_box n la ha + inner (leaves n) (leaves v) < lowest_of_box n lb hb
  | _, _ => No
  end.
End checks.
Arguments course_facts : clear implicits. Arguments contact_facts : clear implicits.
