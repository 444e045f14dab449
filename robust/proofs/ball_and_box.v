(* SPDX-License-Identifier: Apache-2.0 *)
(* ball_and_box of sphere_box_filter.h. beyond_interval is the comment's: of two differences of one sign each, the
  greater. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Filters Require Import model constants filters steps ghost tactics squares cross_sign.
Open Scope R_scope.

Lemma ball_and_box_enough u : 0 < u <= 1/1024 -> enough_squares u 1 5 (3 * u + 3 * u ^ 2) (relative 6 18 u).
Proof. prove_enough. Qed.

Lemma ball_and_box_2_enough u : 0 < u <= 1/1024 -> enough_squares u 1 4 (3 * u + 3 * u ^ 2) (relative 6 18 u).
Proof. prove_enough. Qed.

Theorem ball_and_box_2_right F b0 b1 radius beyond0 extent0 beyond1 extent1 answer : fits F (third F) 1 1 ->
  Near F b0 beyond0 -> Near F b1 beyond1 -> ball_and_box_2 F R (reals F) radius beyond0 extent0 beyond1 extent1 answer
    ->
  let exact := radius * radius - (b0 * b0 + b1 * b1) in
  (answer = positive -> exact > 0) /\ (answer = negative -> exact < 0).
Proof.
intros G (d0 & D0 & C0) (d1 & D1 & C1) R exact. unfold ball_and_box_2 in R. unpack. constants. flags R.
squares_nonneg. squared_guard G. square_parts G. normal G 6 18 4%Z. inputs G radius. steps G.
assert (Hf : 0 < u F <= 1/1024) by (destruct G; lra).
compare_squares G 64%Z (3 * u F + 3 * u F ^ 2) (ball_and_box_2_enough (u F) Hf) Pos Neg P' Q' W1 W2.
unfold exact. signs R Pos Neg P' Q' W1 W2.
Qed.

Theorem ball_and_box_3_right F b0 b1 b2 radius beyond0 extent0 beyond1 extent1 beyond2 extent2 answer : fits F (third
  F) 1 1 ->
  Near F b0 beyond0 -> Near F b1 beyond1 -> Near F b2 beyond2 -> ball_and_box_3 F R (reals F) radius beyond0 extent0
    beyond1 extent1 beyond2 extent2 answer ->
  let exact := radius * radius - (b0 * b0 + (b1 * b1 + b2 * b2)) in
  (answer = positive -> exact > 0) /\ (answer = negative -> exact < 0).
Proof.
intros G (d0 & D0 & C0) (d1 & D1 & C1) (d2 & D2 & C2) R exact. unfold ball_and_box_3 in R. unpack. constants. flags R.
squares_nonneg. squared_guard G. square_parts G. normal G 6 18 4%Z. inputs G radius. steps G.
assert (Hf : 0 < u F <= 1/1024) by (destruct G; lra).
compare_squares G 64%Z (3 * u F + 3 * u F ^ 2) (ball_and_box_enough (u F) Hf) Pos Neg P' Q' W1 W2.
unfold exact. signs R Pos Neg P' Q' W1 W2.
Qed.
