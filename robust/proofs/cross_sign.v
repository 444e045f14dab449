(* SPDX-License-Identifier: Apache-2.0 *)
(* cross_sign, and orientation, of filters.h: where they answer a sign, the exact polynomial has it. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Filters Require Import model constants filters steps ghost tactics cross.
Open Scope R_scope.

Lemma cross_enough u : 0 < u <= 1/16 -> (1 + u) * ((3 * u + u ^ 3) / 2) <= (1 - u) ^ 5 * relative 3 12 u.
Proof. intros Hu. unfold relative. powers u Hu. lra. Qed.

Section CrossSign.
Variable F : format.
Hypothesis G : fits F (third F) 1 1.
(* x is a, or a computed difference of two numbers of the input whose exact difference is a *)
Definition Near a x := exists e, Rabs e <= u F /\ close F (third F) 0 3074 x (a * (1 + e)).

Theorem cross_sign_right a b c d vx vy wx wy answer : Near a vx -> Near b vy -> Near c wx -> Near d wy ->
  cross_sign F R (reals F) vx vy wx wy answer ->
  (answer = positive -> a * d - b * c > 0) /\ (answer = negative -> a * d - b * c < 0).
Proof.
intros (e1 & E1 & N1) (e2 & E2 & N2) (e3 & E3 & N3) (e4 & E4 & N4) R. unfold cross_sign in R. unpack. constants.
flags R. nonneg. guarded G. parts G. pose proof (fits_u _ _ _ _ G) as Hu.
assert (HC : n F <= relative 3 12 (u F) <= q 2). { destruct G. unfold relative, q. split; nra. }
assert (C0 : 0 <= relative 3 12 (u F)) by (destruct G; lra).
steps G.
bounded G 64%Z lows_here Pos Neg.
in_extents G Pos ((3 * u F + u F ^ 3) / 2) (cross_enough (u F) Hu) P' Q'.
pose proof (wrong_sign (u F) Hu a b c d e1 e4 e2 e3 e12 e13 E1 E4 E2 E3 E12 E13) as W1.
  pose proof (wrong_sign (u F) Hu c d a b e3 e2 e4 e1 e13 e12 E3 E2 E4 E1 E13 E12) as W2. cbv zeta in W1, W2.
rewrite (Rplus_comm (Rabs (c * _))), (Rplus_comm (Rabs (d * _))) in W2.
clear - Pos Neg P' Q' W1 W2 R. signs R Pos Neg P' Q' W1 W2.
Qed.

Lemma near_difference a b x : sub (reals F) (Plain b) (Plain a) x -> Near (b - a) x.
Proof. intros S. destruct (difference_close F (third F) 1 1 G b a x _ S eq_refl) as (e & E & C). now exists e. Qed.
Lemma near_input x : Near x x.
Proof.
exists 0. rewrite Rabs_R0, Rplus_0_r, Rmult_1_r. destruct G. split; [lra|]. split; [lia|].
rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. unfold q. simpl. lra.
Qed.

Theorem orientation_right p0x p0y p1x p1y px py answer : orientation F R (reals F) p0x p0y p1x p1y px py answer ->
  let exact := (p1x - p0x) * (py - p0y) - (p1y - p0y) * (px - p0x) in
  (answer = positive -> exact > 0) /\ (answer = negative -> exact < 0).
Proof.
intros (vx & V & vy & W & wx & X & wy & Y & R) exact. apply near_difference in V, W, X, Y.
exact (cross_sign_right _ _ _ _ _ _ _ _ _ V W X Y R).
Qed.
End CrossSign.
