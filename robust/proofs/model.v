(* SPDX-License-Identifier: Apache-2.0 *)
(* What a filter of robust/kernel runs on. filters.v, which extract.py writes from the C++ headers, says what each one
   computes on any such machine. *)
From Coq Require Import Reals ZArith Bool.
Open Scope R_scope.

Inductive sign := negative | unknown | positive.
Inductive location := Inside | Outside.
Inductive meeting := meeting_unknown | meets_at_start | meets_later | meets_never.
Definition two_to (e : Z) := powerRZ 2 e.
Arguments two_to : simpl never.

(* What is added: a number, or one that is the product of a and b, which a compiler may contract to FMA. *)
Inductive operand (T : Type) := Plain (x : T) | Product (a b t : T).
Arguments Plain {T}. Arguments Product {T}.

(* Relations, for a machine may answer this or that: add p q z says that z is a possible sum of p and q. *)
Record machine (T : Type) := {
  constant : R -> T -> Prop;
  magnitude : T -> T;
  opposite : T -> T;
  square_root : T -> T -> Prop;
  mul : T -> T -> T -> Prop;
  add : operand T -> operand T -> T -> Prop;
  sub : operand T -> operand T -> T -> Prop;
  greater : T -> T -> bool -> Prop;
  at_most : T -> T -> bool -> Prop;
  choose : bool -> T -> T -> T -> Prop;
  signed : T -> bool -> Prop }.
Arguments constant {T}. Arguments magnitude {T}. Arguments opposite {T}. Arguments square_root {T}.
Arguments mul {T}. Arguments add {T}. Arguments sub {T}.
Arguments greater {T}. Arguments at_most {T}. Arguments choose {T}. Arguments signed {T}.

(* u = 2^(1 - precision), n the least normal number, and 2^(max_exponent / k) for k = 3, 4, 6. *)
Record format := { u : R; n : R; third : R; quarter : R; sixth : R }.

(* The model of filters.h. An operation's result is exact * (1 + e) + h, |e| <= u, |h| <= n, and never of the wrong
   sign; a number below n may be read as zero by every operation on its own, by one that chooses too (x86's minimum with
   DAZ; a branch does not); a product may be contracted in one sum and not in another. That holds in every rounding mode,
   with FTZ and DAZ or without: format.v. A zero has any sign bit. *)
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
  opposite := Ropp;
  square_root x z := exists x', read x x' /\ rounded (sqrt x') z;
  mul x y z := exists x' y', read x x' /\ read y y' /\ rounded (x' * y') z;
  add p q z := exists x' y', uses p x' /\ uses q y' /\ rounded (x' + y') z;
  sub p q z := exists x' y', uses p x' /\ uses q y' /\ rounded (x' - y') z;
  greater x y b := exists x' y', read x x' /\ read y y' /\ (b = true <-> x' > y');
  at_most x y b := exists x' y', read x x' /\ read y y' /\ (b = true <-> x' <= y');
  choose b x y z := read (if b then x else y) z;
  signed x b := (x < 0 -> b = true) /\ (0 < x -> b = false) |}.

(* Rounding is monotone, and leaves the numbers of the format as they are: where two of them that are not negative are
   added, the sum is not less than either, unless it is flushed to zero. *)
Definition grows x y z := 0 <= x -> 0 <= y -> (x <= z /\ y <= z) \/ (z = 0 /\ x + y < n F).
Definition growing : machine R := {|
  constant := constant reals;
  magnitude := Rabs;
  opposite := Ropp;
  square_root := square_root reals;
  mul := mul reals;
  add p q z := exists x' y', uses p x' /\ uses q y' /\ rounded (x' + y') z /\
    match p, q with Plain _, Plain _ => grows x' y' z | _, _ => True end;
  sub := sub reals;
  greater := greater reals;
  at_most := at_most reals;
  choose := choose reals;
  signed := signed reals |}.

(* The same where all operations read alike: every number below n as zero, or none. *)
Variable zeros : bool.
Definition seen x := if zeros then if Rlt_dec (Rabs x) (n F) then 0 else x else x.
Definition seen_of (p : operand R) (x' : R) :=
  match p with Plain x => x' = seen x | Product a b t => x' = seen t \/ x' = seen a * seen b end.
Definition one_mode : machine R := {|
  constant r x := x = r;
  magnitude := Rabs;
  opposite := Ropp;
  square_root x z := rounded (sqrt (seen x)) z;
  mul x y z := rounded (seen x * seen y) z;
  add p q z := exists x' y', seen_of p x' /\ seen_of q y' /\ rounded (x' + y') z;
  sub p q z := exists x' y', seen_of p x' /\ seen_of q y' /\ rounded (x' - y') z;
  greater x y b := b = true <-> seen x > seen y;
  at_most x y b := b = true <-> seen x <= seen y;
  choose b x y z := z = (if b then x else y) \/ z = seen (if b then x else y);
  signed x b := (x < 0 -> b = true) /\ (0 < x -> b = false) |}.
End Model.
