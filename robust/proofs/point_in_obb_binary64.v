(* SPDX-License-Identifier: Apache-2.0 *)
(* point_in_obb on all of binary64. *)
From Coq Require Import Reals Bool List.
From Filters Require Import model constants filters steps tactics format floats float_steps float_guards float_run.
From Filters Require Import obb point_in_obb.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.

Theorem point_in_obb_binary64 (cx cy cz ux uy uz vx vy vz wx wy wz px py pz : float) answer :
  point_in_obb binary64 float floats cx cy cz ux uy uz vx vy vz wx wy wz px py pz answer ->
  let volume := Rabs (triple ux uy uz vx vy vz wx wy wz) in
  let along := fun vx vy vz wx wy wz => Rabs (triple vx vy vz wx wy wz (px - cx) (py - cy) (pz - cz)) in
  let along_u := along vx vy vz wx wy wz in let along_v := along wx wy wz ux uy uz in
  let along_w := along ux uy uz vx vy vz in
  (answer <> None -> Forall finite [cx; cy; cz; ux; uy; uz; vx; vy; vz; wx; wy; wz; px; py; pz]) /\
  (answer = Some Outside -> volume > 0 /\ (along_u > volume \/ along_v > volume \/ along_w > volume)) /\
  (answer = Some Inside -> volume > 0 /\ along_u < volume /\ along_v < volume /\ along_w < volume).
Proof.
intros R volume along along_u along_v along_w. unfold point_in_obb in R. unpack.
match type of R with answer = if negb ?a || negb ?b then _ else _ =>
  destruct a; [|subst; repeat split; discriminate || easy];
  destruct b; [|subst; repeat split; discriminate || easy] end.
float_constants. rising. guards. back. split; [intros _; all_finite|].
apply point_in_obb_right with binary64; [fits|unfold point_in_obb; repeat advance; exact R].
Qed.
