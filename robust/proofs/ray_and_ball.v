(* SPDX-License-Identifier: Apache-2.0 *)
(* RayAndBall of ray_filter.h. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Filters Require Import model constants filters steps ghost tactics.
Open Scope R_scope.

Lemma square_of_size x : x * x = Rabs x * Rabs x.
Proof. rewrite <- Rabs_mult. symmetry. apply Rabs_pos_eq, Rle_0_sqr. Qed.

Theorem ray_and_ball_start_right F ox oy oz vx vy vz kx ky kz radius answer : fits F (sixth F) 1 1 -> 0 <= radius ->
  ray_and_ball_start F R (reals F) ox oy oz vx vy vz kx ky kz radius answer ->
  let exact :=
    (ox - kx) * (ox - kx) + (oy - ky) * (oy - ky) + (oz - kz) * (oz - kz) - radius * radius in
  (answer = positive -> exact > 0) /\ (answer = negative -> exact < 0).
Proof.
intros G UP R exact. unfold ray_and_ball_start in R. unpack. constants. flags R. nonneg. guarded G. parts G.
differences G. inputs G (vx, vy, vz, radius). normal G 10 128 6%Z. steps G.
polynomial G 512%Z Right; [rewrite (square_of_size radius); constant_is_enough G 128%nat|answers R Right].
Qed.

Theorem ray_and_ball_slope_right F ox oy oz vx vy vz kx ky kz radius answer : fits F (sixth F) 1 1 -> 0 <= radius ->
  ray_and_ball_slope F R (reals F) ox oy oz vx vy vz kx ky kz radius answer ->
  let exact :=
    (ox - kx) * vx + (oy - ky) * vy + (oz - kz) * vz in
  (answer = positive -> exact > 0) /\ (answer = negative -> exact < 0).
Proof.
intros G UP R exact. unfold ray_and_ball_slope in R. unpack. constants. flags R. nonneg. guarded G. parts G.
differences G. inputs G (vx, vy, vz, radius). normal G 10 96 6%Z. steps G.
polynomial G 512%Z Right; [constant_is_enough G 96%nat|answers R Right].
Qed.

Theorem ray_and_ball_enters_right F ox oy oz vx vy vz kx ky kz radius answer : fits F (sixth F) 1 1 -> 0 <= radius ->
  ray_and_ball_enters F R (reals F) ox oy oz vx vy vz kx ky kz radius answer ->
  let exact :=
    ((ox - kx) * vx + (oy - ky) * vy + (oz - kz) * vz) * ((ox - kx) * vx + (oy - ky) * vy + (oz - kz) * vz) - (vx * vx
    + vy * vy + vz * vz) * ((ox - kx) * (ox - kx) + (oy - ky) * (oy - ky) + (oz - kz) * (oz - kz) - radius * radius) in
  (answer = positive -> exact > 0) /\ (answer = negative -> exact < 0).
Proof.
intros G UP R exact. unfold ray_and_ball_enters in R. unpack. constants. flags R. nonneg. guarded G. parts G.
differences G. inputs G (vx, vy, vz, radius). normal G 20 640 11%Z. steps G.
polynomial G 4096%Z Right; [rewrite (square_of_size radius); constant_is_enough G 640%nat|answers R Right].
Qed.
