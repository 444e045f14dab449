(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of numbers that are rounded: of x + y sqrt(k), with k = 0 for a fraction, and of the double m 2^e. *)
Require Import ZArith Bool.
From Certificates Require Import numbers motion language formulas_motion.
Local Open Scope Z_scope.

(** 2^p in a few squarings; 2^e as [scale e] over [scale (- e)], of which one is 1 *)
Fixpoint power_of_two (p : positive) : Z :=
  match p with
  | xH => 2
  | xO p => let half := power_of_two p in half * half
  | xI p => let half := power_of_two p in 2 * (half * half)
  end.
Definition scale (e : Z) : Z := match e with Zpos p => power_of_two p | _ => 1 end.

Definition least_normal : Z := 4503599627370496. (* 2^52 *)
Definition most_digits : Z := 9007199254740991. (* 2^53 - 1 *)
Definition greatest : Z := most_digits * power_of_two 971.
Definition limit : Z := 18014398509481983 * power_of_two 970. (* 2^1024 - 2^970 *)
Definition is_double (m e : Z) : bool := Z.leb (Z.abs m) most_digits && (Z.leb (-1074) e && Z.leb e 971).
(** No double nearer to 0 has a smaller unit, but that below 2^52 2^e. *)
Definition has_all_digits (m e : Z) : bool := Z.leb e (-1074) || Z.leb least_normal (Z.abs m).
(** How far the next double towards 0 is, in halves of 2^e, for m > 0 *)
Definition gap (m e : Z) : Z := if Zeq_bool m least_normal then if Z.leb e (-1074) then 2 else 1 else 2.
Definition next (m e : Z) : Z := if Z.leb 0 m then 2 * m + 2 else 2 * m + gap (- m) e.

Local Open Scope check_scope.
Section checks.
Context {A : Type}.
Notation T := (term A). Notation C := (cond A).

Definition at_most (x y k b : T) : C := not_positive (x - b) y k.
Definition at_least (x y k b : T) : C := not_positive (b - x) (zero - y) k.
Definition equals (x y : T) (m e : Z) : C := y = zero /\ Num (scale (- e)) * x = Num (m * scale e).

(** Between the middles to the next doubles, in quarters of 2^e, for m >= 0; a middle itself goes to an even m. *)
Definition near (x y k : T) (m e : Z) : C :=
  let quarters := Num (4 * scale (- e)) in let x := quarters * x in let y := quarters * y in
  let low := Num ((4 * m - gap m e) * scale e) in let high := Num ((4 * m + 2) * scale e) in
  if Z.even m then at_least x y k low /\ at_most x y k high else ~ at_most x y k low /\ ~ at_least x y k high.

Definition rounds_to_nearest (t : surd A) (w : double (Z * Z)) : C :=
  let '(Surd x y k) := t in let x := Leaf x in let y := Leaf y in let k := Leaf k in
  zero <= k /\
  match w with
  | finite (m, e) =>
      if_so (is_double m e) /\
      (equals x y m e \/
       if_so (has_all_digits m e) /\
       (if Z.leb 0 m then near x y k m e else near (zero - x) (zero - y) k (- m) e))
  | infinity => at_least x y k (Num limit)
  | minus_infinity => at_least (zero - x) (zero - y) k (Num limit)
  end.

(** Not below the double, and below the next one, in halves of 2^e *)
Definition down (x y k : T) (w : double (Z * Z)) : C :=
  zero <= k /\
  match w with
  | finite (m, e) =>
      let halves := Num (2 * scale (- e)) in let x' := halves * x in let y' := halves * y in
      if_so (is_double m e) /\
      (equals x y m e \/
       if_so (has_all_digits m e) /\ at_least x' y' k (Num (2 * m * scale e)) /\
       (if_so (Z.leb most_digits m && Z.leb 971 e) \/ ~ at_least x' y' k (Num (next m e * scale e))))
  | infinity => No
  | minus_infinity => ~ at_least x y k (Num (- greatest))
  end.
Definition rounds_down (t : surd A) (w : double (Z * Z)) : C :=
  let '(Surd x y k) := t in down (Leaf x) (Leaf y) (Leaf k) w.
Definition rounds_up (t : surd A) (w : double (Z * Z)) : C :=
  let '(Surd x y k) := t in
  down (zero - Leaf x) (zero - Leaf y) (Leaf k)
    match w with finite (m, e) => finite (- m, e)%Z | infinity => minus_infinity | minus_infinity => infinity end.
End checks.
