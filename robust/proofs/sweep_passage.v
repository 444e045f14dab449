(* SPDX-License-Identifier: Apache-2.0 *)
(* Sweep::passage of sweep_filter.h. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Filters Require Import model constants filters steps ghost tactics.
Open Scope R_scope.

Theorem sweep_passage_right F acx acy acz ra bcx bcy bcz rb vax vay vaz vbx vby vbz answer : fits F (sixth F) 1 1 -> 0
  <= ra -> 0 <= rb ->
  sweep_passage F R (reals F) acx acy acz ra bcx bcy bcz rb vax vay vaz vbx vby vbz answer ->
  let x := (acy - bcy) * (vaz - vbz) - (acz - bcz) * (vay - vby) in
  let y := (acz - bcz) * (vax - vbx) - (acx - bcx) * (vaz - vbz) in
  let z := (acx - bcx) * (vay - vby) - (acy - bcy) * (vax - vbx) in
  let exact := x * x + y * y + z * z - (ra + rb) * (ra + rb) *
    ((vax - vbx) * (vax - vbx) + (vay - vby) * (vay - vby) + (vaz - vbz) * (vaz - vbz)) in
  (answer = positive -> exact > 0) /\ (answer = negative -> exact < 0).
Proof.
intros G RA RB R x y z exact. unfold sweep_passage in R. unpack. constants. flags R. nonneg. guarded G. parts G.
differences G. sum_of_inputs G ra rb. normal G 22 1024 12%Z. steps G.
polynomial G 4096%Z Right; [constant_is_enough G 1024%nat|answers R Right].
Qed.
