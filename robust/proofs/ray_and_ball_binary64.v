(* SPDX-License-Identifier: Apache-2.0 *)
(* RayAndBall on all of binary64. *)
From Coq Require Import Reals Bool List.
From Filters Require Import model constants filters steps tactics format floats float_steps float_guards float_run.
From Filters Require Import ray_and_ball.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.

Theorem ray_and_ball_binary64 (ox oy oz vx vy vz kx ky kz radius : float) answer : up radius ->
  ray_and_ball binary64 float floats ox oy oz vx vy vz kx ky kz radius answer ->
  let start := (ox - kx) * (ox - kx) + (oy - ky) * (oy - ky) + (oz - kz) * (oz - kz) - radius * radius in
  let slope := (ox - kx) * vx + (oy - ky) * vy + (oz - kz) * vz in
  let value := slope * slope - (vx * vx + vy * vy + vz * vz) * start in
  (answer <> unknown -> Forall finite [ox; oy; oz; vx; vy; vz; kx; ky; kz; radius]) /\
  (answer = positive -> value > 0 /\ (start < 0 \/ slope < 0)) /\
  (answer = negative -> value < 0 \/ (start > 0 /\ slope > 0)).
Proof.
intros UP R start slope value. unfold ray_and_ball in R. unpack.
match type of R with _ = (if negb ?c then unknown else _) =>
  destruct c eqn:C; cbn [negb] in R; [|subst; repeat split; congruence] end.
apply andb_prop in C as [C C']. apply andb_prop in C as [C C'']. subst.
float_constants. rising. repeat guards. back. split; [intros _; all_finite|].
apply (ray_and_ball_right binary64 ox oy oz vx vy vz kx ky kz radius);
  [fits|now apply up_value|unfold ray_and_ball; repeat advance; reflexivity].
Qed.
