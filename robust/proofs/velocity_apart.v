(* SPDX-License-Identifier: Apache-2.0 *)
(* velocity_apart of contact_filter.h. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Filters Require Import model constants filters steps ghost tactics.
Open Scope R_scope.

Theorem velocity_apart_right F pax pay paz vax vay vaz wax way waz pbx pby pbz vbx vby vbz wbx wby wbz px py pz nx ny
  nz answer : fits F (quarter F) 1 1 ->
  velocity_apart F R (reals F) pax pay paz vax vay vaz wax way waz pbx pby pbz vbx vby vbz wbx wby wbz px py pz nx ny
    nz answer ->
  let exact := nx * ((vax + (way * (pz - paz) - waz * (py - pay))) - (vbx + (wby * (pz - pbz) - wbz * (py - pby)))) +
    ny * ((vay + (waz * (px - pax) - wax * (pz - paz))) - (vby + (wbz * (px - pbx) - wbx * (pz - pbz)))) +
    nz * ((vaz + (wax * (py - pay) - way * (px - pax))) - (vbz + (wbx * (py - pby) - wby * (px - pbx)))) in
  (answer = positive -> exact > 0) /\ (answer = negative -> exact < 0).
Proof.
intros G R exact. unfold velocity_apart in R. unpack. constants. flags R. nonneg. guarded G. parts G.
differences G. normal G 14 224 8%Z. inputs G (vax, vay, vaz, wax, way, waz, vbx, vby, vbz, wbx, wby, wbz, nx, ny, nz).
  steps G.
polynomial G 512%Z Right; [constant_is_enough G 224%nat|answers R Right].
Qed.
