(* SPDX-License-Identifier: Apache-2.0 *)
(** OCaml code of the formulas. Only the integers are replaced, by those of the library Zarith; fractions stay Coq's. *)
Require Import ZArith QArith Extraction.
Require Import ExtrOcamlBasic.

Extract Inductive positive => "Whole.t"
  ["(fun p -> Whole.succ (Whole.shift_left p 1))" "(fun p -> Whole.shift_left p 1)" "Whole.one"]
  "Whole.of_positive".
Extract Inductive Z => "Whole.t" ["Whole.zero" "(fun p -> p)" "Whole.neg"] "Whole.of_sign".
Extract Constant Pos.mul => "Whole.mul".
Extract Constant Z.mul => "Whole.mul".
Extract Constant Z.add => "Whole.add".
Extract Constant Z.opp => "Whole.neg".
Extract Constant Z.leb => "Whole.leq".
Extract Constant Zeq_bool => "Whole.equal".
