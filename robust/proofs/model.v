(* SPDX-License-Identifier: Apache-2.0 *)
(* What a filter of robust/kernel runs on. filters.v, which extract.py writes from the C++ headers, says what each one
   computes on any such machine. *)
From Coq Require Import Reals Bool.
Open Scope R_scope.

Inductive sign := negative | unknown | positive.
Inductive location := Inside | Outside.

(* What is added: a number, or one that is the product of a and b, which a compiler may contract to FMA. *)
Inductive operand (T : Type) := Plain (x : T) | Product (a b t : T).
Arguments Plain {T}. Arguments Product {T}.

(* Relations, for a machine may answer this or that: add p q z says that z is a possible sum of p and q. *)
Record machine (T : Type) := {
  constant : R -> T -> Prop;
  magnitude : T -> T;
  mul : T -> T -> T -> Prop;
  add : operand T -> operand T -> T -> Prop;
  sub : operand T -> operand T -> T -> Prop;
  greater : T -> T -> bool -> Prop;
  at_most : T -> T -> bool -> Prop;
  choose : bool -> T -> T -> T -> Prop }.
Arguments constant {T}. Arguments magnitude {T}. Arguments mul {T}. Arguments add {T}. Arguments sub {T}.
Arguments greater {T}. Arguments at_most {T}. Arguments choose {T}.

(* u = 2^(1 - precision), n the least normal number, and 2^(max_exponent / k) for k = 3, 4, 6. *)
Record format := { u : R; n : R; third : R; quarter : R; sixth : R }.

(* The model of filters.h. An operation's result is exact * (1 + e) + h, |e| <= u, |h| <= n, and never of the wrong
   sign; a number below n may be read as zero by every operation on its own, by one that chooses too; a product may be
   contracted in one sum and not in another. That holds in every rounding mode, with FTZ and DAZ or without: format.v. *)
Section Model.
Variable F : format.
Definition read (x x' : R) := x' = x \/ (x' = 0 /\ Rabs x < n F).
Definition rounded (r z : R) :=
  (exists e h, Rabs e <= u F /\ Rabs h <= n F /\ z = r * (1 + e) + h) /\ (0 <= r -> 0 <= z) /\ (r <= 0 -> z <= 0).
Definition uses (p : operand R) (x' : R) :=
  match p with
  | Plain x => read x x'
  | Product a b t => read t x' \/ exists a' b', read a a' /\ read b b' /\ x' = a' * b'
  end.
Definition reals : machine R := {|
  constant r x := x = r;
  magnitude := Rabs;
  mul x y z := exists x' y', read x x' /\ read y y' /\ rounded (x' * y') z;
  add p q z := exists x' y', uses p x' /\ uses q y' /\ rounded (x' + y') z;
  sub p q z := exists x' y', uses p x' /\ uses q y' /\ rounded (x' - y') z;
  greater x y b := exists x' y', read x x' /\ read y y' /\ (b = true <-> x' > y');
  at_most x y b := exists x' y', read x x' /\ read y y' /\ (b = true <-> x' <= y');
  choose b x y z := read (if b then x else y) z |}.
End Model.
