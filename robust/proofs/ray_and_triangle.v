(* SPDX-License-Identifier: Apache-2.0 *)
(* RayAndTriangle of ray_filter.h. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Filters Require Import model constants filters steps ghost tactics.
Open Scope R_scope.

Theorem ray_rise_right F ox oy oz vx vy vz ax ay az bx by_ bz cx cy cz answer : fits F (quarter F) 1 1 ->
  ray_rise F R (reals F) ox oy oz vx vy vz ax ay az bx by_ bz cx cy cz answer ->
  let exact :=
    (bx - ax) * (vy * (cz - az) - vz * (cy - ay)) + (by_ - ay) * (vz * (cx - ax) - vx * (cz - az)) + (bz - az) * (vx *
    (cy - ay) - vy * (cx - ax)) in
  (answer = positive -> exact > 0) /\ (answer = negative -> exact < 0).
Proof.
intros G R exact. unfold ray_rise in R. unpack. constants. flags R. nonneg. guarded G. parts G. differences G.
inputs G (vx, vy, vz). normal G 16 288 9%Z. steps G.
polynomial G 1024%Z Right; [constant_is_enough G 288%nat|answers R Right].
Qed.

Theorem ray_beside_ca_right F ox oy oz vx vy vz ax ay az bx by_ bz cx cy cz answer : fits F (quarter F) 1 1 ->
  ray_beside_ca F R (reals F) ox oy oz vx vy vz ax ay az bx by_ bz cx cy cz answer ->
  let exact :=
    (ox - ax) * (vy * (cz - az) - vz * (cy - ay)) + (oy - ay) * (vz * (cx - ax) - vx * (cz - az)) + (oz - az) * (vx *
    (cy - ay) - vy * (cx - ax)) in
  (answer = positive -> exact > 0) /\ (answer = negative -> exact < 0).
Proof.
intros G R exact. unfold ray_beside_ca in R. unpack. constants. flags R. nonneg. guarded G. parts G. differences G.
inputs G (vx, vy, vz). normal G 16 288 9%Z. steps G.
polynomial G 1024%Z Right; [constant_is_enough G 288%nat|answers R Right].
Qed.

Theorem ray_beside_ab_right F ox oy oz vx vy vz ax ay az bx by_ bz cx cy cz answer : fits F (quarter F) 1 1 ->
  ray_beside_ab F R (reals F) ox oy oz vx vy vz ax ay az bx by_ bz cx cy cz answer ->
  let exact :=
    vx * ((oy - ay) * (bz - az) - (oz - az) * (by_ - ay)) + vy * ((oz - az) * (bx - ax) - (ox - ax) * (bz - az)) + vz
    * ((ox - ax) * (by_ - ay) - (oy - ay) * (bx - ax)) in
  (answer = positive -> exact > 0) /\ (answer = negative -> exact < 0).
Proof.
intros G R exact. unfold ray_beside_ab in R. unpack. constants. flags R. nonneg. guarded G. parts G. differences G.
inputs G (vx, vy, vz). normal G 16 288 9%Z. steps G.
polynomial G 1024%Z Right; [constant_is_enough G 288%nat|answers R Right].
Qed.

Theorem ray_beside_bc_right F ox oy oz vx vy vz ax ay az bx by_ bz cx cy cz answer : fits F (quarter F) 1 1 ->
  ray_beside_bc F R (reals F) ox oy oz vx vy vz ax ay az bx by_ bz cx cy cz answer ->
  let exact :=
    (bx - ax) * (vy * (cz - az) - vz * (cy - ay)) + (by_ - ay) * (vz * (cx - ax) - vx * (cz - az)) + (bz - az) * (vx *
    (cy - ay) - vy * (cx - ax)) - ((ox - ax) * (vy * (cz - az) - vz * (cy - ay)) + (oy - ay) * (vz * (cx - ax) - vx *
    (cz - az)) + (oz - az) * (vx * (cy - ay) - vy * (cx - ax))) - (vx * ((oy - ay) * (bz - az) - (oz - az) * (by_ -
    ay)) + vy * ((oz - az) * (bx - ax) - (ox - ax) * (bz - az)) + vz * ((ox - ax) * (by_ - ay) - (oy - ay) * (bx -
    ax))) in
  (answer = positive -> exact > 0) /\ (answer = negative -> exact < 0).
Proof.
intros G R exact. unfold ray_beside_bc in R. unpack. constants. flags R. nonneg. guarded G. parts G. differences G.
inputs G (vx, vy, vz). normal G 16 288 9%Z. steps G.
polynomial G 1024%Z Right; [constant_is_enough G 288%nat|answers R Right].
Qed.

Theorem ray_height_right F ox oy oz vx vy vz ax ay az bx by_ bz cx cy cz answer : fits F (quarter F) 1 1 ->
  ray_height F R (reals F) ox oy oz vx vy vz ax ay az bx by_ bz cx cy cz answer ->
  let exact :=
    (cx - ax) * ((oy - ay) * (bz - az) - (oz - az) * (by_ - ay)) + (cy - ay) * ((oz - az) * (bx - ax) - (ox - ax) *
    (bz - az)) + (cz - az) * ((ox - ax) * (by_ - ay) - (oy - ay) * (bx - ax)) in
  (answer = positive -> exact > 0) /\ (answer = negative -> exact < 0).
Proof.
intros G R exact. unfold ray_height in R. unpack. constants. flags R. nonneg. guarded G. parts G. differences G.
inputs G (vx, vy, vz). normal G 16 288 9%Z. steps G.
polynomial G 1024%Z Right; [constant_is_enough G 288%nat|answers R Right].
Qed.
