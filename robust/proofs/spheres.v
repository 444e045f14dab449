(* SPDX-License-Identifier: Apache-2.0 *)
(* spheres of sphere_filter.h. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Filters Require Import model constants filters steps ghost tactics squares.
Open Scope R_scope.

Lemma spheres_enough u : 0 < u <= 1/1024 -> enough_squares u 3 5 (4 * u + 3 * u ^ 2) (relative 8 24 u).
Proof. prove_enough. Qed.

Theorem spheres_right F acx acy acz ra bcx bcy bcz rb answer : fits F (third F) 1 1 -> 0 <= ra -> 0 <= rb ->
  spheres F R (reals F) acx acy acz ra bcx bcy bcz rb answer ->
  let exact := (ra + rb) * (ra + rb) -
    ((bcx - acx) * (bcx - acx) + (bcy - acy) * (bcy - acy) + (bcz - acz) * (bcz - acz)) in
  (answer = positive -> exact > 0) /\ (answer = negative -> exact < 0).
Proof.
intros G RA RB R exact. unfold spheres in R. unpack. constants. flags R. squares_nonneg. squared_guard G. square_parts
  G.
differences G. sum_of_inputs G ra rb. normal G 8 24 5%Z. steps G.
assert (Hf : 0 < u F <= 1/1024) by (destruct G; lra).
compare_squares G 64%Z (4 * u F + 3 * u F ^ 2) (spheres_enough (u F) Hf) Pos Neg P' Q' W1 W2.
unfold exact. signs R Pos Neg P' Q' W1 W2.
Qed.
