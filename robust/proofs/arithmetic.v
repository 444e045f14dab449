(* SPDX-License-Identifier: Apache-2.0 *)
(* What the numbers of robust/kernel/enclosed/enclosed.h are made of; enclosed.v, which extract.py writes from its text, says
   what each function computes. *)
From Coq Require Import Reals ZArith Bool.
From Flocq Require Import Core.
Open Scope R_scope.

(* A number, or one that is the product of a and b, rounded to t: where it is added a compiler may contract it. *)
Inductive number := Plain (x : R) | Product (a b t : R).
Definition value p := match p with Plain x => x | Product _ _ t => t end.
Definition seen p x := match p with Plain y => x = y | Product a b t => x = t \/ x = a * b end.
Definition negated p := match p with Plain x => Plain (- x) | Product a b t => Product (- a) b (- t) end.
Definition magnitude p := Plain (Rabs (value p)).
(* cut to k digits *)
Definition head (k : Z) p := Plain (round radix2 (FLX_exp k) Ztrunc (value p)).

(* Each operation rounds its exact result. *)
Section Operations.
Variable rnd : R -> R.
Definition added p q z := exists x y, seen p x /\ seen q y /\ z = Plain (rnd (x + y)).
Definition subtracted p q z := exists x y, seen p x /\ seen q y /\ z = Plain (rnd (x - y)).
Definition multiplied p q z := z = Product (value p) (value q) (rnd (value p * value q)).
Definition divided p q z := z = Plain (rnd (value p / value q)).
Definition rooted p z := z = Plain (rnd (sqrt (value p))).
Definition at_most p q b := b = true <-> value p <= value q.
End Operations.
