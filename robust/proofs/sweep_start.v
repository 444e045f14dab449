(* SPDX-License-Identifier: Apache-2.0 *)
(* Sweep::start of sweep_filter.h. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Filters Require Import model constants filters steps ghost tactics squares.
Open Scope R_scope.

Lemma sweep_start_enough u : 0 < u <= 1/1024 -> enough_squares u 3 5 (4 * u + 3 * u ^ 2) (relative 8 20 u).
Proof. prove_enough. Qed.

Theorem sweep_start_right F acx acy acz ra bcx bcy bcz rb vax vay vaz vbx vby vbz answer : fits F (third F) 1 1 -> 0
  <= ra -> 0 <= rb ->
  sweep_start F R (reals F) acx acy acz ra bcx bcy bcz rb vax vay vaz vbx vby vbz answer ->
  let exact := (acx - bcx) * (acx - bcx) + (acy - bcy) * (acy - bcy) + (acz - bcz) * (acz - bcz) -
    (ra + rb) * (ra + rb) in
  (answer = positive -> exact > 0) /\ (answer = negative -> exact < 0).
Proof.
intros G RA RB R exact. unfold sweep_start in R. unpack. constants. flags R. nonneg. guarded G. parts G.
differences G. sum_of_inputs G ra rb. normal G 8 20 5%Z. steps G.
assert (Hf : 0 < u F <= 1/1024) by (destruct G; lra).
compare_squares G 512%Z (4 * u F + 3 * u F ^ 2) (sweep_start_enough (u F) Hf) Pos Neg P' Q' W1 W2.
unfold exact. signs R Pos Neg P' Q' W1 W2.
Qed.
