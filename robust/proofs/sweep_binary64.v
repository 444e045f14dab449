(* SPDX-License-Identifier: Apache-2.0 *)
(* slope_at_start, slope_at_end, end and passage of Sweep on all of binary64. *)
From Coq Require Import Reals Bool List.
From Filters Require Import model constants filters steps tactics format floats float_steps float_guards float_run.
From Filters Require Import sweep sweep_passage.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.

Section Sweep.
Variables (acx acy acz ra bcx bcy bcz rb vax vay vaz vbx vby vbz : float) (answer : sign).
Hypotheses (RA : up ra) (RB : up rb).
Let arguments := [acx; acy; acz; ra; bcx; bcy; bcz; rb; vax; vay; vaz; vbx; vby; vbz].

Theorem sweep_slope_at_start_binary64 :
  sweep_slope_at_start binary64 float floats acx acy acz ra bcx bcy bcz rb vax vay vaz vbx vby vbz answer ->
  correct answer arguments ((acx - bcx) * (vax - vbx) + (acy - bcy) * (vay - vby) + (acz - bcz) * (vaz - vbz)).
Proof.
intros R. unfold sweep_slope_at_start in R. float_run R.
apply (sweep_slope_at_start_right binary64 acx acy acz ra bcx bcy bcz rb vax vay vaz vbx vby vbz);
  [fits|now apply up_value|now apply up_value|unfold sweep_slope_at_start; repeat advance; exact R].
Qed.

Theorem sweep_slope_at_end_binary64 :
  sweep_slope_at_end binary64 float floats acx acy acz ra bcx bcy bcz rb vax vay vaz vbx vby vbz answer ->
  correct answer arguments ((vax - vbx) * ((vax - vbx) + (acx - bcx)) + (vay - vby) * ((vay - vby) + (acy - bcy)) +
    (vaz - vbz) * ((vaz - vbz) + (acz - bcz))).
Proof.
intros R. unfold sweep_slope_at_end in R. float_run R.
apply (sweep_slope_at_end_right binary64 acx acy acz ra bcx bcy bcz rb vax vay vaz vbx vby vbz);
  [fits|now apply up_value|now apply up_value|unfold sweep_slope_at_end; repeat advance; exact R].
Qed.

Theorem sweep_end_binary64 :
  sweep_end binary64 float floats acx acy acz ra bcx bcy bcz rb vax vay vaz vbx vby vbz answer ->
  correct answer arguments (((vax - vbx) + (acx - bcx)) * ((vax - vbx) + (acx - bcx)) +
    ((vay - vby) + (acy - bcy)) * ((vay - vby) + (acy - bcy)) +
    ((vaz - vbz) + (acz - bcz)) * ((vaz - vbz) + (acz - bcz)) - (ra + rb) * (ra + rb)).
Proof.
intros R. unfold sweep_end in R. float_run R.
apply (sweep_end_right binary64 acx acy acz ra bcx bcy bcz rb vax vay vaz vbx vby vbz);
  [fits|now apply up_value|now apply up_value|unfold sweep_end; repeat advance; exact R].
Qed.

Theorem sweep_passage_binary64 :
  sweep_passage binary64 float floats acx acy acz ra bcx bcy bcz rb vax vay vaz vbx vby vbz answer ->
  let x := (acy - bcy) * (vaz - vbz) - (acz - bcz) * (vay - vby) in
  let y := (acz - bcz) * (vax - vbx) - (acx - bcx) * (vaz - vbz) in
  let z := (acx - bcx) * (vay - vby) - (acy - bcy) * (vax - vbx) in
  correct answer arguments (x * x + y * y + z * z - (ra + rb) * (ra + rb) *
    ((vax - vbx) * (vax - vbx) + (vay - vby) * (vay - vby) + (vaz - vbz) * (vaz - vbz))).
Proof.
intros R x y z. unfold sweep_passage in R. float_run R.
apply (sweep_passage_right binary64 acx acy acz ra bcx bcy bcz rb vax vay vaz vbx vby vbz);
  [fits|now apply up_value|now apply up_value|unfold sweep_passage; repeat advance; exact R].
Qed.
End Sweep.
