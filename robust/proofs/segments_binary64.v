(* SPDX-License-Identifier: Apache-2.0 *)
(* segments and ray of filters.h on all of binary64. *)
From Coq Require Import Reals Bool List.
From Filters Require Import model constants filters steps tactics format floats float_steps float_guards float_run.
From Filters Require Import segments ray.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.

Theorem segments_binary64 (aax aay abx aby bax bay bbx bby : float) answer :
  segments binary64 float floats aax aay abx aby bax bay bbx bby answer ->
  let rs := (abx - aax) * (bby - bay) - (aby - aay) * (bbx - bax) in
  let rf := (abx - aax) * (aay - bay) - (aby - aay) * (aax - bax) in
  let sf := (bbx - bax) * (aay - bay) - (bby - bay) * (aax - bax) in
  correct answer [aax; aay; abx; aby; bax; bay; bbx; bby] (Rabs (sf + rf - rs) + Rabs (sf - rf) - Rabs rs).
Proof.
intros R rs rf sf. unfold segments in R. float_run R.
apply segments_right with binary64; [fits|unfold segments; repeat advance; exact R].
Qed.

Theorem ray_binary64 (ox oy vx vy sax say sbx sby : float) answer :
  ray binary64 float floats ox oy vx vy sax say sbx sby answer ->
  let vs := vx * (sby - say) - vy * (sbx - sax) in
  let vf := vx * (say - oy) - vy * (sax - ox) in
  let fs := (sax - ox) * (sby - say) - (say - oy) * (sbx - sax) in
  let one := Rabs vs - Rabs (2 * vf + vs) in
  let two := Rabs (fs + vs) - Rabs (fs - vs) in
  correct answer [ox; oy; vx; vy; sax; say; sbx; sby] (Rabs (one - two) - (one + two)).
Proof.
intros R vs vf fs one two. unfold ray in R. float_run R.
apply ray_right with binary64; [fits|unfold ray; repeat advance; exact R].
Qed.
