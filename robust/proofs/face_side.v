(* SPDX-License-Identifier: Apache-2.0 *)
(* FacePlane::side of face_filter.h. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Filters Require Import model constants filters steps ghost tactics.
Open Scope R_scope.

Theorem face_side_right F ax ay az bx by_ bz cx cy cz px py pz answer : fits F (quarter F) 1 1 ->
  face_side F R (reals F) ax ay az bx by_ bz cx cy cz px py pz answer ->
  let exact := ((by_ - ay) * (cz - az) - (bz - az) * (cy - ay)) * (px - ax) + ((bz - az) * (cx - ax) - (bx - ax) * (cz
    - az)) * (py - ay)
    + ((bx - ax) * (cy - ay) - (by_ - ay) * (cx - ax)) * (pz - az) in
  (answer = positive -> exact > 0) /\ (answer = negative -> exact < 0).
Proof.
intros G R exact. unfold face_side in R. unpack. constants. flags R. nonneg. guarded G. parts G. differences G.
normal G 14 176 8%Z.  steps G.
polynomial G 512%Z Right; [constant_is_enough G 176%nat|answers R Right].
Qed.
