(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of a ball that moves and a box at rest. *)
Require Import ZArith List Arith.
From Certificates Require Import motion solids language formulas_vectors formulas_solids formulas_motion
  formulas_courses.
Import ListNotations.
Local Open Scope check_scope.

Section checks.
Context {A : Type}.
Notation T := (term A). Notation C := (cond A).

(** On an axis the center is under the interval of the box, level with it or over it. *)
Inductive axis_side := under | level | over.
Inductive rounded_box_facts := touching_at_start (p : list A) | on_sides (s : list axis_side) | never_near (n : list A).
Definition sum_of_three (f : nat -> T) : T := f 0%nat + (f 1%nat + f 2%nat).

(** [swept_sphere_aabb] at t = x + y sqrt(k): [gap] + t [rate] is the displacement from the box, where the center is on
    these sides, and f + b t + a t^2 its square less that of the radius. *)
Definition check_swept_sphere_aabb (c : list A) (r : A) (v low high : list A) (answer : option (surd A))
    (facts : rounded_box_facts) : C :=
  is_ball 3 c r /\ of_length 3 v /\ is_box 3 low high /\
  match answer, facts with
  | Some (Surd x y k), touching_at_start p =>
      let way := difference (leaves c) (leaves p) in
      zero <= Leaf k /\ is_zero (Leaf x) (Leaf y) (Leaf k) /\ of_length 3 p /\ box_holds low high (leaves p) /\
      inner way way <= Leaf r * Leaf r
  | Some (Surd x y k), on_sides s =>
      let x := Leaf x in let y := Leaf y in let k := Leaf k in
      let side_at i := nth i s level in
      let c i := coordinate i c in let v i := coordinate i v in
      let low i := coordinate i low in let high i := coordinate i high in
      let gap i := match side_at i with under => c i - low i | level => zero | over => c i - high i end in
      let rate i := match side_at i with level => zero | _ => v i end in
      let up_to i bound := not_positive (c i - bound + v i * x) (v i * y) k in
      let from i bound := not_negative (c i - bound + v i * x) (v i * y) k in
      let placed i := match side_at i with
        | under => up_to i (low i) | over => from i (high i) | level => from i (low i) /\ up_to i (high i) end in
      let comes_in i := zero < v i /\ up_to i (low i) \/ v i < zero /\ from i (high i) in
      let a := sum_of_three (fun i => rate i * rate i) in
      let b := Num 2 * sum_of_three (fun i => gap i * rate i) in
      let f := sum_of_three (fun i => gap i * gap i) - Leaf r * Leaf r in
      zero <= k /\ ~ not_positive x y k /\ not_positive (x - one) y k /\ on_each 3 placed /\ on_some 3 comes_in /\
      zero_at f b a x y k /\ falls_at b a x y k
  | None, never_near n =>
      let height := inner (leaves n) (leaves c) - highest_of_box n low high in
      let far h := zero < h /\ Leaf r * Leaf r * inner (leaves n) (leaves n) < h * h in
      of_length 3 n /\ far height /\ far (height + inner (leaves n) (leaves v))
  | _, _ => No
  end.
End checks.
Arguments rounded_box_facts : clear implicits.
