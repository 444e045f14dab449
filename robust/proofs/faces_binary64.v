(* SPDX-License-Identifier: Apache-2.0 *)
(* FacePlane::side and velocity_apart on all of binary64. *)
From Coq Require Import Reals Bool List.
From Filters Require Import model constants filters steps tactics format floats float_steps float_guards float_run.
From Filters Require Import face_side velocity_apart.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.

Theorem face_side_binary64 (ax ay az bx by_ bz cx cy cz px py pz : float) answer :
  face_side binary64 float floats ax ay az bx by_ bz cx cy cz px py pz answer ->
  correct answer [ax; ay; az; bx; by_; bz; cx; cy; cz; px; py; pz]
    (((by_ - ay) * (cz - az) - (bz - az) * (cy - ay)) * (px - ax) +
     ((bz - az) * (cx - ax) - (bx - ax) * (cz - az)) * (py - ay) +
     ((bx - ax) * (cy - ay) - (by_ - ay) * (cx - ax)) * (pz - az)).
Proof.
intros R. unfold face_side in R. float_run R.
apply face_side_right with binary64; [fits|unfold face_side; repeat advance; exact R].
Qed.

Theorem velocity_apart_binary64 (pax pay paz vax vay vaz wax way waz pbx pby pbz vbx vby vbz wbx wby wbz px py pz nx ny
  nz : float) answer :
  velocity_apart binary64 float floats pax pay paz vax vay vaz wax way waz pbx pby pbz vbx vby vbz wbx wby wbz px py pz
    nx ny nz answer ->
  correct answer [pax; pay; paz; vax; vay; vaz; wax; way; waz; pbx; pby; pbz; vbx; vby; vbz; wbx; wby; wbz; px; py; pz;
    nx; ny; nz]
   (nx * ((vax + (way * (pz - paz) - waz * (py - pay))) - (vbx + (wby * (pz - pbz) - wbz * (py - pby)))) +
    ny * ((vay + (waz * (px - pax) - wax * (pz - paz))) - (vby + (wbz * (px - pbx) - wbx * (pz - pbz)))) +
    nz * ((vaz + (wax * (py - pay) - way * (px - pax))) - (vbz + (wbx * (py - pby) - wby * (px - pbx))))).
Proof.
intros R. unfold velocity_apart in R. float_run R.
apply (velocity_apart_right binary64 pax pay paz vax vay vaz wax way waz pbx pby pbz vbx vby vbz wbx wby wbz px py pz
  nx ny nz); [fits|unfold velocity_apart; repeat advance; exact R].
Qed.
