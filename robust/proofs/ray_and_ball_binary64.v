(* SPDX-License-Identifier: Apache-2.0 *)
(* RayAndBall on all of binary64. *)
From Coq Require Import Reals Bool List.
From Filters Require Import model constants filters steps tactics format floats float_steps float_guards float_run.
From Filters Require Import ray_and_ball.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.

Section Ray.
Variables (ox oy oz vx vy vz kx ky kz radius : float) (answer : sign).
Hypothesis (UP : up radius).
Let arguments := [ox; oy; oz; vx; vy; vz; kx; ky; kz; radius].

Theorem ray_and_ball_start_binary64 :
  ray_and_ball_start binary64 float floats ox oy oz vx vy vz kx ky kz radius answer ->
  correct answer arguments
    ((ox - kx) * (ox - kx) + (oy - ky) * (oy - ky) + (oz - kz) * (oz - kz) - radius * radius).
Proof.
intros R. unfold ray_and_ball_start in R. float_run R.
apply (ray_and_ball_start_right binary64 ox oy oz vx vy vz kx ky kz radius);
  [fits|now apply up_value|unfold ray_and_ball_start; repeat advance; exact R].
Qed.

Theorem ray_and_ball_slope_binary64 :
  ray_and_ball_slope binary64 float floats ox oy oz vx vy vz kx ky kz radius answer ->
  correct answer arguments
    ((ox - kx) * vx + (oy - ky) * vy + (oz - kz) * vz).
Proof.
intros R. unfold ray_and_ball_slope in R. float_run R.
apply (ray_and_ball_slope_right binary64 ox oy oz vx vy vz kx ky kz radius);
  [fits|now apply up_value|unfold ray_and_ball_slope; repeat advance; exact R].
Qed.

Theorem ray_and_ball_enters_binary64 :
  ray_and_ball_enters binary64 float floats ox oy oz vx vy vz kx ky kz radius answer ->
  correct answer arguments
    (((ox - kx) * vx + (oy - ky) * vy + (oz - kz) * vz) * ((ox - kx) * vx + (oy - ky) * vy + (oz - kz) * vz) - (vx *
    vx + vy * vy + vz * vz) * ((ox - kx) * (ox - kx) + (oy - ky) * (oy - ky) + (oz - kz) * (oz - kz) - radius *
    radius)).
Proof.
intros R. unfold ray_and_ball_enters in R. float_run R.
apply (ray_and_ball_enters_right binary64 ox oy oz vx vy vz kx ky kz radius);
  [fits|now apply up_value|unfold ray_and_ball_enters; repeat advance; exact R].
Qed.
End Ray.
