(* SPDX-License-Identifier: Apache-2.0 *)
(* circle, spheres, ball_and_box and Sweep::start on all of binary64. *)
From Coq Require Import Reals Bool List.
From Filters Require Import model constants filters steps tactics format floats float_steps float_guards float_run.
From Filters Require Import circle spheres ball_and_box sweep_start cross_sign cross_sign_binary64.
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

Theorem ball_and_box_2_binary64 (radius beyond0 extent0 beyond1 extent1 : float) l0 b0 l1 b1 answer :
  given beyond0 l0 b0 -> given beyond1 l1 b1 ->
  ball_and_box_2 binary64 float floats radius beyond0 extent0 beyond1 extent1 answer ->
  correct answer ([radius; extent0; extent1] ++ l0 ++ l1) (radius * radius - (b0 * b0 + b1 * b1)).
Proof.
intros B0 B1 R. unfold ball_and_box_2 in R. float_guards R. near B0. near B1.
split; [intros _; rewrite !Forall_app; repeat split; auto; all_finite|].
apply ball_and_box_2_right with binary64 (value beyond0) (value extent0) (value beyond1) (value extent1); auto; [fits|].
unfold ball_and_box_2. repeat advance. exact R.
Qed.

Theorem ball_and_box_3_binary64 (radius beyond0 extent0 beyond1 extent1 beyond2 extent2 : float) l0 b0 l1 b1 l2 b2
  answer : given beyond0 l0 b0 -> given beyond1 l1 b1 -> given beyond2 l2 b2 ->
  ball_and_box_3 binary64 float floats radius beyond0 extent0 beyond1 extent1 beyond2 extent2 answer ->
  correct answer ([radius; extent0; extent1; extent2] ++ l0 ++ l1 ++ l2)
    (radius * radius - (b0 * b0 + (b1 * b1 + b2 * b2))).
Proof.
intros B0 B1 B2 R. unfold ball_and_box_3 in R. float_guards R. near B0. near B1. near B2.
split; [intros _; rewrite !Forall_app; repeat split; auto; all_finite|].
apply ball_and_box_3_right with binary64 (value beyond0) (value extent0) (value beyond1) (value extent1)
  (value beyond2) (value extent2); auto; [fits|].
unfold ball_and_box_3. repeat advance. exact R.
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
