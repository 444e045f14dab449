(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of moving balls. *)
Require Import ZArith List Arith.
From Certificates Require Import motion solids language formulas_solids.
Import ListNotations.
Local Open Scope check_scope.

Section checks.
Context {A : Type}.
Notation T := (term A). Notation C := (cond A).

(** The sign of p + q sqrt(k), k >= 0, is found by squares. *)
Definition not_positive (p q k : T) : C :=
  p <= zero /\ (q <= zero \/ q * q * k <= p * p) \/ q <= zero /\ p * p <= q * q * k.
Definition not_negative (p q k : T) : C := not_positive (zero - p) (zero - q) k.
Fixpoint products (c d v w : list A) : T :=
  match c, d, v, w with
  | a :: c', b :: d', x :: v', y :: w' => (Leaf a - Leaf b) * (Leaf x - Leaf y) + products c' d' v' w'
  | _, _, _, _ => zero
  end.
Inductive sweep_facts :=
| start (c b a : A) | first_root (c b a : A) | receding (c b a : A) | too_late (c b a : A) | no_root (c b a : A).

(** [swept_sphere_sphere] *)
Definition check_swept_sphere_sphere (p : list A) (r : A) (v : list A) (o : list A) (s : A) (w : list A)
    (answer : swept A) (facts : sweep_facts) : C :=
  let polynomial c b a :=
    Leaf c = squared_distance p o - (Leaf r + Leaf s) * (Leaf r + Leaf s) /\
    Leaf b = Num 2 * products p o v w /\ Leaf a = squared_distance v w in
  if_so (length p =? 3) /\ if_so (length v =? 3) /\ if_so (length o =? 3) /\ if_so (length w =? 3) /\
  zero <= Leaf r /\ zero <= Leaf s /\
  match answer, facts with
  | first_at (Surd x y k), start c b a =>
      polynomial c b a /\ Leaf c <= zero /\ zero <= Leaf k /\
      not_positive (Leaf x) (Leaf y) (Leaf k) /\ not_negative (Leaf x) (Leaf y) (Leaf k)
  | first_at (Surd x y k), first_root c b a =>
      let x := Leaf x in let y := Leaf y in let k := Leaf k in
      let a' := Leaf a in let b' := Leaf b in
      let f0 := Leaf c + b' * x + a' * (x * x + y * y * k) in let f1 := b' * y + Num 2 * a' * x * y in
      polynomial c b a /\ zero < Leaf c /\ zero <= k /\
      ~ not_positive x y k /\ not_positive (x - one) y k /\
      not_positive f0 f1 k /\ not_negative f0 f1 k /\
      not_positive (b' + Num 2 * a' * x) (Num 2 * a' * y) k
  | never, receding c b a => polynomial c b a /\ zero < Leaf c /\ zero <= Leaf b
  | never, too_late c b a =>
      polynomial c b a /\ zero < Leaf c /\ zero < Leaf c + Leaf b + Leaf a /\ Num 2 * Leaf a + Leaf b <= zero
  | never, no_root c b a =>
      polynomial c b a /\ zero < Leaf c /\ Leaf b * Leaf b < Num 4 * Leaf a * Leaf c
  | _, _ => No
  end.
End checks.
Arguments sweep_facts : clear implicits.
