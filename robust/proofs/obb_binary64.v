(* SPDX-License-Identifier: Apache-2.0 *)
(* ObbAxes on all of binary64: for any assignment of six edges. *)
From Coq Require Import Reals ZArith Lia Bool List.
From Filters Require Import model constants filters steps tactics format floats float_steps float_guards float_run.
From Filters Require Import obb.
Open Scope R_scope.
#[local] Coercion value : float >-> R.

Section Obb.
Variables (x y z : nat -> float) (ax ay az bx by_ bz wx wy wz : float) (sizes : nat -> float) (sum : float).
Hypothesis WX : sub floats (Plain bx) (Plain ax) wx.
Hypothesis WY : sub floats (Plain by_) (Plain ay) wy.
Hypothesis WZ : sub floats (Plain bz) (Plain az) wz.
Notation reals_of f := (fun i : nat => value (f i)).

(* Where the guard holds, no edge, size or coordinate of the way is infinite, NaN or large, and what was computed of
   them is what is computed of real numbers. *)
Definition sound := (forall i, (i < 6)%nat -> mag (x i) 265 /\ mag (y i) 265 /\ mag (z i) 265 /\ mag (sizes i) 265) /\
  (mag wx 265 /\ mag wy 265 /\ mag wz 265 /\ mag sum 265) /\
  obb_axes binary64 R M (reals_of x) (reals_of y) (reals_of z) wx wy wz (reals_of sizes) sum.
Ltac advance_given := cbv beta; lazymatch goal with
  | |- add M _ _ (value ?z) /\ _ => lazymatch reverse goal with S : add floats _ _ z |- _ =>
      split; [as_real; let B := bound_of z in exact (add_real _ _ z _ S B eq_refl)|clear S] end
  | |- _ => advance end.
Ltac up_to := match goal with B : mag ?x ?i |- mag ?x ?k => exact (mag_up x i k B ltac:(discriminate)) end.
Theorem obb_axes_binary64 h : obb_axes binary64 float floats x y z wx wy wz sizes sum ->
  constant floats (quarter binary64) h -> at_most floats sum h true -> sound.
Proof.
intros R C A. unfold obb_axes in R. unpack. float_constants. rising. guards. back.
split; [|split].
- intros i I. do 6 (destruct i as [|i]; [clear I; split; [|split; [|split]]; up_to|]). lia.
- split; [|split; [|split]]; up_to.
- unfold obb_axes. repeat advance_given. as_real. let B := bound_of sum in exact (add_real _ _ sum _ R B eq_refl).
Qed.

Ltac edge E i I := let X := fresh "X" in let Y := fresh "Y" in let Z := fresh "Z" in let S := fresh "S" in
  destruct (E i I) as (X & Y & Z & S).
Lemma axis_real v w others answer : obb_axes binary64 float floats x y z wx wy wz sizes sum ->
  obb_axis binary64 float floats x y z wx wy wz sizes sum v w others answer ->
  (v < 6)%nat -> (w < 6)%nat -> different others -> answer <> unknown -> sound /\
  obb_axis binary64 R M (reals_of x) (reals_of y) (reals_of z) wx wy wz (reals_of sizes) sum v w others answer.
Proof.
intros A R V W D N. unfold obb_axis in R. unpack.
match type of R with _ = (if negb ?c then unknown else _) =>
  destruct c eqn:B; cbn [negb] in R; [apply andb_prop in B as [-> ->]|congruence] end.
float_constants.
match goal with C : constant floats (quarter _) ?h, S : at_most floats sum ?h true |- _ =>
  pose proof (obb_axes_binary64 h A C S) as P end.
split; [exact P|]. destruct P as (E & (MX & MY & MZ & MS) & _). clear A WX WY WZ.
edge E v V. edge E w W.
edge E (others 0%nat) (proj1 D 0%nat ltac:(lia)). edge E (others 1%nat) (proj1 D 1%nat ltac:(lia)).
edge E (others 2%nat) (proj1 D 2%nat ltac:(lia)). edge E (others 3%nat) (proj1 D 3%nat ltac:(lia)). clear E.
unfold obb_axis. repeat advance_given. exact R.
Qed.
Ltac real_ways P := let W := fresh "W" in destruct P as (_ & W & _); destruct W as (? & ? & ? & _).

(* n = v x w for edges v and w, and four different others *)
Theorem obb_axis_binary64 v w others answer : obb_axes binary64 float floats x y z wx wy wz sizes sum ->
  obb_axis binary64 float floats x y z wx wy wz sizes sum v w others answer ->
  (v < 6)%nat -> (w < 6)%nat -> different others ->
  let along := triple (x v) (y v) (z v) (x w) (y w) (z w) in
  let reach := fun k => Rabs (along (x (others k)) (y (others k)) (z (others k))) in
  let exact := Rabs (along (bx - ax) (by_ - ay) (bz - az)) -
    (reach 0%nat + reach 1%nat + (reach 2%nat + reach 3%nat)) in
  (answer <> unknown -> sound) /\ (answer = positive -> exact > 0) /\ (answer = negative -> exact < 0).
Proof.
intros A R V W D along reach exact. split; [intros N; exact (proj1 (axis_real _ _ _ _ A R V W D N))|].
assert (K : answer = unknown \/ answer <> unknown) by (destruct answer; auto; right; discriminate).
destruct K as [->|N]; [split; discriminate|]. destruct (axis_real _ _ _ _ A R V W D N) as [P Q].
apply (obb_axis_right binary64 fits_quarter (reals_of x) (reals_of y) (reals_of z) ax ay az bx by_ bz wx wy wz
  (reals_of sizes) sum) with (v := v) (w := w) (others := others); auto; [| | |apply P]; real_ways P;
  [real_sub WX|real_sub WY|real_sub WZ].
Qed.

Theorem obb_volume_binary64 v w others answer i : obb_axes binary64 float floats x y z wx wy wz sizes sum ->
  obb_axis binary64 float floats x y z wx wy wz sizes sum v w others answer ->
  (v < 6)%nat -> (w < 6)%nat -> different others -> answer <> unknown ->
  obb_volume binary64 float floats x y z wx wy wz sizes sum i true -> (i + 2 < 6)%nat ->
  triple (x i) (y i) (z i) (x (i + 1)%nat) (y (i + 1)%nat) (z (i + 1)%nat) (x (i + 2)%nat) (y (i + 2)%nat)
    (z (i + 2)%nat) <> 0.
Proof.
intros A R V W D N S I. destruct (axis_real _ _ _ _ A R V W D N) as [P Q].
apply (obb_volume_right binary64 fits_quarter (reals_of x) (reals_of y) (reals_of z) ax ay az bx by_ bz wx wy wz
  (reals_of sizes) sum) with (v := v) (w := w) (others := others) (answer := answer); auto; try apply P.
1,2,3: real_ways P; [real_sub WX || real_sub WY || real_sub WZ].
destruct P as (E & (MX & MY & MZ & MS) & _). clear A R Q WX WY WZ.
unfold obb_volume in S. unpack. float_constants. assert (I0 : (i < 6)%nat) by lia. assert (I1 : (i + 1 < 6)%nat) by lia.
edge E i I0. edge E (i + 1)%nat I1. edge E (i + 2)%nat I. clear E. subst.
unfold obb_volume. repeat advance_given. reflexivity.
Qed.
End Obb.
