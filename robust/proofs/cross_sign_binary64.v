(* SPDX-License-Identifier: Apache-2.0 *)
(* cross_sign, orientation and elevation of filters.h on all of binary64. *)
From Coq Require Import Reals Bool List.
From Filters Require Import model constants filters steps tactics format floats float_steps float_guards float_run.
From Filters Require Import cross_sign elevation.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.

Lemma given_near x l a k : given x l a -> mag x k -> fair k -> Forall finite l /\ Near binary64 a (value x).
Proof.
intros [|p q S] B K.
- split; [repeat constructor; apply B|]. apply near_input, fits_third.
- destruct (sub_finite _ _ _ S (proj1 B)). split; [now repeat constructor|].
  apply (near_difference binary64 fits_third). exact (sub_real _ _ _ k S B K).
Qed.
Ltac near A := lazymatch type of A with given ?x ?l ?a =>
  let B := bound_of x in let N := fresh "N" in destruct (given_near x l a _ A B eq_refl) as [? N] end.

Theorem cross_sign_binary64 vx vy wx wy a b c d va vb vc vd answer :
  given vx va a -> given vy vb b -> given wx vc c -> given wy vd d ->
  cross_sign binary64 float floats vx vy wx wy answer -> correct answer (va ++ vb ++ vc ++ vd) (a * d - b * c).
Proof.
intros A B C D R. unfold cross_sign in R. float_guards R. near A. near B. near C. near D.
split; [intros _; rewrite !Forall_app; auto|].
apply cross_sign_right with binary64 (value vx) (value vy) (value wx) (value wy); auto; [fits|].
unfold cross_sign. repeat advance. exact R.
Qed.

Theorem orientation_binary64 (p0x p0y p1x p1y px py : float) answer :
  orientation binary64 float floats p0x p0y p1x p1y px py answer ->
  correct answer [p0x; p0y; p1x; p1y; px; py] ((p1x - p0x) * (py - p0y) - (p1y - p0y) * (px - p0x)).
Proof.
intros R. unfold orientation in R. float_run R.
apply orientation_right with binary64; [fits|unfold orientation; repeat advance; exact R].
Qed.

Theorem elevation_binary64 (slope intercept px py : float) answer :
  elevation binary64 float floats slope intercept px py answer ->
  correct answer [slope; intercept; px; py] (py - (slope * px + intercept)).
Proof.
intros R. unfold elevation in R. float_run R.
apply elevation_right with binary64; [fits|unfold elevation; repeat advance; exact R].
Qed.
