(* SPDX-License-Identifier: Apache-2.0 *)
(* RayAndTriangle on all of binary64. *)
From Coq Require Import Reals Bool List.
From Filters Require Import model constants filters steps tactics format floats float_steps float_guards float_run.
From Filters Require Import ray_and_triangle.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.

Theorem ray_rise_binary64 (ox oy oz vx vy vz ax ay az bx by_ bz cx cy cz : float) answer :
  ray_rise binary64 float floats ox oy oz vx vy vz ax ay az bx by_ bz cx cy cz answer ->
  correct answer [ox; oy; oz; vx; vy; vz; ax; ay; az; bx; by_; bz; cx; cy; cz]
    ((bx - ax) * (vy * (cz - az) - vz * (cy - ay)) + (by_ - ay) * (vz * (cx - ax) - vx * (cz - az)) + (bz - az) * (vx
    * (cy - ay) - vy * (cx - ax))).
Proof.
intros R. unfold ray_rise in R. float_run R.
apply (ray_rise_right binary64 ox oy oz vx vy vz ax ay az bx by_ bz cx cy cz);
  [fits|unfold ray_rise; repeat advance; exact R].
Qed.

Theorem ray_beside_ca_binary64 (ox oy oz vx vy vz ax ay az bx by_ bz cx cy cz : float) answer :
  ray_beside_ca binary64 float floats ox oy oz vx vy vz ax ay az bx by_ bz cx cy cz answer ->
  correct answer [ox; oy; oz; vx; vy; vz; ax; ay; az; bx; by_; bz; cx; cy; cz]
    ((ox - ax) * (vy * (cz - az) - vz * (cy - ay)) + (oy - ay) * (vz * (cx - ax) - vx * (cz - az)) + (oz - az) * (vx *
    (cy - ay) - vy * (cx - ax))).
Proof.
intros R. unfold ray_beside_ca in R. float_run R.
apply (ray_beside_ca_right binary64 ox oy oz vx vy vz ax ay az bx by_ bz cx cy cz);
  [fits|unfold ray_beside_ca; repeat advance; exact R].
Qed.

Theorem ray_beside_ab_binary64 (ox oy oz vx vy vz ax ay az bx by_ bz cx cy cz : float) answer :
  ray_beside_ab binary64 float floats ox oy oz vx vy vz ax ay az bx by_ bz cx cy cz answer ->
  correct answer [ox; oy; oz; vx; vy; vz; ax; ay; az; bx; by_; bz; cx; cy; cz]
    (vx * ((oy - ay) * (bz - az) - (oz - az) * (by_ - ay)) + vy * ((oz - az) * (bx - ax) - (ox - ax) * (bz - az)) + vz
    * ((ox - ax) * (by_ - ay) - (oy - ay) * (bx - ax))).
Proof.
intros R. unfold ray_beside_ab in R. float_run R.
apply (ray_beside_ab_right binary64 ox oy oz vx vy vz ax ay az bx by_ bz cx cy cz);
  [fits|unfold ray_beside_ab; repeat advance; exact R].
Qed.

Theorem ray_beside_bc_binary64 (ox oy oz vx vy vz ax ay az bx by_ bz cx cy cz : float) answer :
  ray_beside_bc binary64 float floats ox oy oz vx vy vz ax ay az bx by_ bz cx cy cz answer ->
  correct answer [ox; oy; oz; vx; vy; vz; ax; ay; az; bx; by_; bz; cx; cy; cz]
    ((bx - ax) * (vy * (cz - az) - vz * (cy - ay)) + (by_ - ay) * (vz * (cx - ax) - vx * (cz - az)) + (bz - az) * (vx
    * (cy - ay) - vy * (cx - ax)) - ((ox - ax) * (vy * (cz - az) - vz * (cy - ay)) + (oy - ay) * (vz * (cx - ax) - vx
    * (cz - az)) + (oz - az) * (vx * (cy - ay) - vy * (cx - ax))) - (vx * ((oy - ay) * (bz - az) - (oz - az) * (by_ -
    ay)) + vy * ((oz - az) * (bx - ax) - (ox - ax) * (bz - az)) + vz * ((ox - ax) * (by_ - ay) - (oy - ay) * (bx -
    ax)))).
Proof.
intros R. unfold ray_beside_bc in R. float_run R.
apply (ray_beside_bc_right binary64 ox oy oz vx vy vz ax ay az bx by_ bz cx cy cz);
  [fits|unfold ray_beside_bc; repeat advance; exact R].
Qed.

Theorem ray_height_binary64 (ox oy oz vx vy vz ax ay az bx by_ bz cx cy cz : float) answer :
  ray_height binary64 float floats ox oy oz vx vy vz ax ay az bx by_ bz cx cy cz answer ->
  correct answer [ox; oy; oz; vx; vy; vz; ax; ay; az; bx; by_; bz; cx; cy; cz]
    ((cx - ax) * ((oy - ay) * (bz - az) - (oz - az) * (by_ - ay)) + (cy - ay) * ((oz - az) * (bx - ax) - (ox - ax) *
    (bz - az)) + (cz - az) * ((ox - ax) * (by_ - ay) - (oy - ay) * (bx - ax))).
Proof.
intros R. unfold ray_height in R. float_run R.
apply (ray_height_right binary64 ox oy oz vx vy vz ax ay az bx by_ bz cx cy cz);
  [fits|unfold ray_height; repeat advance; exact R].
Qed.
