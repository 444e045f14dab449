(* SPDX-License-Identifier: Apache-2.0 *)
(* circle, spheres and Sweep::start on all of binary64. *)
From Coq Require Import Reals Bool List.
From Filters Require Import model constants filters steps tactics format floats float_steps float_guards float_run.
From Filters Require Import circle spheres sweep_start.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.

Theorem circle_binary64 (px py cx cy vx vy radius : float) answer :
  sub floats (Plain px) (Plain cx) vx -> sub floats (Plain py) (Plain cy) vy ->
  circle binary64 float floats vx vy radius answer ->
  correct answer [px; py; cx; cy; radius] (radius * radius - ((px - cx) * (px - cx) + (py - cy) * (py - cy))).
Proof.
intros X Y R. unfold circle in R. float_run R.
apply circle_right with binary64 (value vx) (value vy); [fits|real_sub X|real_sub Y|].
clear X Y. unfold circle. repeat advance. exact R.
Qed.

Theorem spheres_binary64 (acx acy acz ra bcx bcy bcz rb : float) answer : up ra -> up rb ->
  spheres binary64 float floats acx acy acz ra bcx bcy bcz rb answer ->
  correct answer [acx; acy; acz; ra; bcx; bcy; bcz; rb] ((ra + rb) * (ra + rb) -
    ((bcx - acx) * (bcx - acx) + (bcy - acy) * (bcy - acy) + (bcz - acz) * (bcz - acz))).
Proof.
intros RA RB R. unfold spheres in R. float_run R.
apply spheres_right with binary64; [fits|now apply up_value|now apply up_value|unfold spheres; repeat advance; exact R].
Qed.

Theorem sweep_start_binary64 (acx acy acz ra bcx bcy bcz rb vax vay vaz vbx vby vbz : float) answer : up ra -> up rb ->
  sweep_start binary64 float floats acx acy acz ra bcx bcy bcz rb vax vay vaz vbx vby vbz answer ->
  correct answer [acx; acy; acz; ra; bcx; bcy; bcz; rb; vax; vay; vaz; vbx; vby; vbz]
    ((acx - bcx) * (acx - bcx) + (acy - bcy) * (acy - bcy) + (acz - bcz) * (acz - bcz) - (ra + rb) * (ra + rb)).
Proof.
intros RA RB R. unfold sweep_start in R. float_run R.
apply (sweep_start_right binary64 acx acy acz ra bcx bcy bcz rb vax vay vaz vbx vby vbz);
  [fits|now apply up_value|now apply up_value|unfold sweep_start; repeat advance; exact R].
Qed.
