(* SPDX-License-Identifier: Apache-2.0 *)
(* circle of filters.h: v is a computed difference of two points. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Filters Require Import model constants filters steps ghost tactics squares.
Open Scope R_scope.

Lemma circle_enough u : 0 < u <= 1/1024 -> enough_squares u 1 4 (5 / 2 * u + 3 * u ^ 2) (relative 5 16 u).
Proof. prove_enough. Qed.

Theorem circle_right F px py cx cy vx vy radius answer : fits F (third F) 1 1 ->
  sub (reals F) (Plain px) (Plain cx) vx -> sub (reals F) (Plain py) (Plain cy) vy ->
  circle F R (reals F) vx vy radius answer ->
  let exact := radius * radius - ((px - cx) * (px - cx) + (py - cy) * (py - cy)) in
  (answer = positive -> exact > 0) /\ (answer = negative -> exact < 0).
Proof.
intros G X Y R exact. unfold circle in R. unpack. constants. flags R. squares_nonneg. squared_guard G. square_parts G.
difference G X. difference G Y. normal G 5 16 3%Z. inputs G radius. steps G.
assert (Hf : 0 < u F <= 1/1024) by (destruct G; lra).
compare_squares G 64%Z (5 / 2 * u F + 3 * u F ^ 2) (circle_enough (u F) Hf) Pos Neg P' Q' W1 W2.
unfold exact. signs R Pos Neg P' Q' W1 W2.
Qed.
