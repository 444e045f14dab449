(* SPDX-License-Identifier: Apache-2.0 *)
(* plane of plane_filter.h; the offset has no guard. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Filters Require Import model constants filters steps ghost tactics.
Open Scope R_scope.

Theorem plane_right F nx ny nz offset px py pz answer : fits F (third F) 1 1 ->
  plane F R (reals F) nx ny nz offset px py pz answer ->
  let exact := nx * px + ny * py + nz * pz + offset in
  (answer = positive -> exact > 0) /\ (answer = negative -> exact < 0).
Proof.
intros G R exact. unfold plane in R. unpack. constants. flags R. nonneg. guarded G. parts G.
normal G 6 48 4%Z. inputs G (nx, ny, nz, px, py, pz, offset). steps G.
polynomial G 64%Z Right; [constant_is_enough G 48%nat|answers R Right].
Qed.
