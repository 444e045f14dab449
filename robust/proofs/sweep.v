(* SPDX-License-Identifier: Apache-2.0 *)
(* slope_at_start, slope_at_end and end of Sweep of sweep_filter.h. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Filters Require Import model constants filters steps ghost tactics.
Open Scope R_scope.

Theorem sweep_slope_at_start_right F acx acy acz ra bcx bcy bcz rb vax vay vaz vbx vby vbz answer : fits F (third F) 1
  1 -> 0 <= ra -> 0 <= rb ->
  sweep_slope_at_start F R (reals F) acx acy acz ra bcx bcy bcz rb vax vay vaz vbx vby vbz answer ->
  let exact := (acx - bcx) * (vax - vbx) + (acy - bcy) * (vay - vby) + (acz - bcz) * (vaz - vbz) in
  (answer = positive -> exact > 0) /\ (answer = negative -> exact < 0).
Proof.
intros G RA RB R exact. unfold sweep_slope_at_start in R. unpack. constants. flags R. nonneg. guarded G. parts G.
differences G. sum_of_inputs G ra rb. normal G 10 96 6%Z. steps G.
polynomial G 512%Z Right; [constant_is_enough G 96%nat|answers R Right].
Qed.

Theorem sweep_slope_at_end_right F acx acy acz ra bcx bcy bcz rb vax vay vaz vbx vby vbz answer : fits F (third F) 1 1
  -> 0 <= ra -> 0 <= rb ->
  sweep_slope_at_end F R (reals F) acx acy acz ra bcx bcy bcz rb vax vay vaz vbx vby vbz answer ->
  let exact := (vax - vbx) * ((vax - vbx) + (acx - bcx)) + (vay - vby) * ((vay - vby) + (acy - bcy)) + (vaz - vbz) *
    ((vaz - vbz) + (acz - bcz)) in
  (answer = positive -> exact > 0) /\ (answer = negative -> exact < 0).
Proof.
intros G RA RB R exact. unfold sweep_slope_at_end in R. unpack. constants. flags R. nonneg. guarded G. parts G.
differences G. sum_of_inputs G ra rb. normal G 12 128 8%Z. steps G.
polynomial G 512%Z Right; [constant_is_enough G 128%nat|answers R Right].
Qed.

Theorem sweep_end_right F acx acy acz ra bcx bcy bcz rb vax vay vaz vbx vby vbz answer : fits F (third F) 1 1 -> 0 <=
  ra -> 0 <= rb ->
  sweep_end F R (reals F) acx acy acz ra bcx bcy bcz rb vax vay vaz vbx vby vbz answer ->
  let exact := ((vax - vbx) + (acx - bcx)) * ((vax - vbx) + (acx - bcx)) + ((vay - vby) + (acy - bcy)) * ((vay - vby)
    + (acy - bcy)) + ((vaz - vbz) + (acz - bcz)) * ((vaz - vbz) + (acz - bcz)) - (ra + rb) * (ra + rb) in
  (answer = positive -> exact > 0) /\ (answer = negative -> exact < 0).
Proof.
intros G RA RB R exact. unfold sweep_end in R. unpack. constants. flags R. nonneg. guarded G. parts G.
differences G. sum_of_inputs G ra rb. normal G 14 256 8%Z. steps G.
polynomial G 512%Z Right; [constant_is_enough G 256%nat|answers R Right].
Qed.
