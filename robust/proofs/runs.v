(* SPDX-License-Identifier: Apache-2.0 *)
(* The theorems about floats say something: every filter has a run on whatever numbers it is given, in every rounding
   mode. For that its constants have to be numbers of binary64. *)
From Coq Require Import Reals ZArith Lra Lia Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model constants filters steps format floats float_steps float_run.
Open Scope R_scope.
#[local] Existing Instances p53 fexp_valid below_1024.

Lemma number r : generic_format radix2 fexp r -> Rabs r < bpow radix2 1024 -> exists x, constant floats r x.
Proof.
intros G L. pose proof (binary_normalize_correct 53 1024 _ _ mode_NE (Ztrunc (scaled_mantissa radix2 fexp r))
  (cexp radix2 fexp r) false) as N. cbv zeta in N. change (SpecFloat.fexp 53 1024) with fexp in N.
unfold generic_format in G. rewrite <- G, round_generic, Rlt_bool_true in N by (auto with typeclass_instances).
eexists. split; apply N.
Qed.
Lemma power_number r k : r = bpow radix2 k -> fair k -> exists x, constant floats r x.
Proof.
intros -> K%fair_k. apply number.
- apply generic_format_bpow. unfold fexp, FLT_exp. lia.
- rewrite Rabs_right by (apply Rle_ge, bpow_ge_0). apply bpow_lt. lia.
Qed.
(* relative c d, as (c 2^51 + d) / 2^104 *)
Lemma relative_number c d m s : (c * 2 ^ 51 + d = m * 2 ^ s)%Z ->
  ((0 <=? s) && (s <=? 50) && (Z.abs m <? 2 ^ 53))%Z = true ->
  exists x, constant floats (relative (IZR c) (IZR d) (u binary64)) x.
Proof.
intros E [[S0%Z.leb_le S1%Z.leb_le]%andb_prop L%Z.ltb_lt]%andb_prop.
assert (R : relative (IZR c) (IZR d) (u binary64) = F2R (Float radix2 m (s - 104))).
{ unfold F2R. cbn [Fnum Fexp]. unfold Zminus. rewrite bpow_plus, <- IZR_Zpower, <- Rmult_assoc, <- mult_IZR by lia.
  change (Zpower radix2 s) with (2 ^ s)%Z. rewrite <- E, plus_IZR, mult_IZR. change (2 ^ 51)%Z with (Zpower radix2 51).
  rewrite IZR_Zpower by lia. unfold relative. cbn [u binary64].
  replace (bpow radix2 (-52)) with (2 * bpow radix2 (-53)) by (change 2 with (bpow radix2 1); now rewrite <- bpow_plus).
  replace (bpow radix2 (- (104))) with (bpow radix2 (-53) * bpow radix2 (-51)) by (now rewrite <- bpow_plus).
  assert (P : bpow radix2 51 * bpow radix2 (-51) = 1) by (now rewrite <- bpow_plus).
  assert (Q : bpow radix2 (-51) = 4 * bpow radix2 (-53))
    by (change 4 with (bpow radix2 2); now rewrite <- bpow_plus).
  set (a := bpow radix2 (-53)) in *. set (b := bpow radix2 51) in *. rewrite Q in *.
  replace ((IZR c * b + IZR d) * (a * (4 * a))) with (IZR c * a * (b * (4 * a)) + 4 * IZR d * a * a) by ring.
  rewrite P. field. }
rewrite R. apply number.
- apply generic_format_FLT. exists (Float radix2 m (s - 104)); [reflexivity|exact L|simpl; lia].
- rewrite <- F2R_Zabs. apply Rlt_trans with (bpow radix2 53 * bpow radix2 (s - 104)).
  + unfold F2R. cbn [Fnum Fexp]. apply Rmult_lt_compat_r; [apply bpow_gt_0|].
    change (bpow radix2 53) with (IZR (2 ^ 53)). now apply IZR_lt.
  + rewrite <- bpow_plus. apply bpow_lt. lia.
Qed.

(* c u *)
Lemma units_number c : (Z.abs c <? 2 ^ 53)%Z = true -> exists x, constant floats (IZR c * u binary64) x.
Proof.
intros L%Z.ltb_lt. change (IZR c * u binary64) with (F2R (Float radix2 c (-52))). apply number.
- apply generic_format_FLT. exists (Float radix2 c (-52)); [reflexivity|exact L|simpl; lia].
- rewrite <- F2R_Zabs. apply Rlt_trans with (bpow radix2 53 * bpow radix2 (-52)).
  + unfold F2R. cbn [Fnum Fexp]. apply Rmult_lt_compat_r; [apply bpow_gt_0|].
    change (bpow radix2 53) with (IZR (2 ^ 53)). now apply IZR_lt.
  + rewrite <- bpow_plus. apply bpow_lt. lia.
Qed.

Ltac some_constant := lazymatch goal with
  | |- exists x, constant floats 0 x => exists (B754_zero false); now split
  | |- exists x, constant floats (relative (IZR ?c) (IZR ?d) _) x =>
    let s := eval vm_compute in (Z.max 0 (Z.log2 (c * 2 ^ 51) - 52)) in
    let m := eval vm_compute in ((c * 2 ^ 51 + d) / 2 ^ s)%Z in exact (relative_number c d m s eq_refl eq_refl)
  | |- exists x, constant floats (IZR ?c * u binary64) x => exact (units_number c eq_refl)
  | |- exists x, constant floats ?r x =>
    let k := power_of_two r in apply (power_number r k); [is_power|reflexivity] end.
(* to the end of the text, every operation in mode m *)
Section Mode.
Variable m : mode.
Lemma some_product x y : exists z, mul floats x y z.
Proof. exists (Bmult m x y), m, x, y. repeat split; now left. Qed.
Lemma some_sum p q : exists z, add floats p q z.
Proof. exists (Bplus m (plain p) (plain q)), m. left. exists (plain p), (plain q). repeat split; now left. Qed.
Lemma some_difference p q : exists z, sub floats p q z.
Proof. exists (Bminus m (plain p) (plain q)), m. left. exists (plain p), (plain q). repeat split; now left. Qed.
Lemma some_root x : exists z, square_root floats x z.
Proof. exists (Bsqrt m x), m, x. split; now left. Qed.
Lemma some_greater x y : exists b, greater floats x y b.
Proof. eexists. exists x, y. repeat split; now left. Qed.
Lemma some_at_most x y : exists b, at_most floats x y b.
Proof. eexists. exists x, y. repeat split; now left. Qed.
End Mode.
Lemma step A T (P : T -> Prop) (Q : T -> A -> Prop) : (exists z, P z) -> (forall z, exists answer, Q z answer) ->
  exists answer, exists z, P z /\ Q z answer.
Proof. intros [z p] E. destruct (E z). eauto. Qed.
Ltac in_mode m := repeat (refine (step _ _ _ _ _ _);
  [cbv beta; lazymatch goal with
   | |- exists z, mul _ ?x ?y z => exact (some_product m x y)
   | |- exists z, add _ ?p ?q z => exact (some_sum m p q)
   | |- exists z, sub _ ?p ?q z => exact (some_difference m p q)
   | |- exists z, square_root _ ?x z => exact (some_root m x)
   | |- exists z, choose _ ?b ?x ?y z => exists (if b then x else y); now left
   | |- exists b, greater _ ?x ?y b => exact (some_greater x y)
   | |- exists b, at_most _ ?x ?y b => exact (some_at_most x y)
   | |- _ => some_constant end|]; let z := fresh "z" in intros z; cbv beta).
Ltac runs f m := unfold f; in_mode m; now eexists.

Theorem cross_sign_runs (m : mode) a b c d : exists answer, cross_sign binary64 float floats a b c d answer.
Proof. runs cross_sign m. Qed.
Theorem orientation_runs (m : mode) a b c d e f : exists answer, orientation binary64 float floats a b c d e f answer.
Proof. runs orientation m. Qed.
Theorem circle_runs (m : mode) a b c : exists answer, circle binary64 float floats a b c answer.
Proof. runs circle m. Qed.
Theorem elevation_runs (m : mode) a b c d : exists answer, elevation binary64 float floats a b c d answer.
Proof. runs elevation m. Qed.
Theorem plane_runs (m : mode) a b c d e f g : exists answer, plane binary64 float floats a b c d e f g answer.
Proof. runs plane m. Qed.
Theorem face_side_runs (m : mode) a b c d e f g h i j k l : exists answer,
  face_side binary64 float floats a b c d e f g h i j k l answer.
Proof. runs face_side m. Qed.
Theorem ray_rise_runs (m : mode) a b c d e f g h i j k l o p q : exists answer,
  ray_rise binary64 float floats a b c d e f g h i j k l o p q answer.
Proof. runs ray_rise m. Qed.
Theorem ray_beside_ca_runs (m : mode) a b c d e f g h i j k l o p q : exists answer,
  ray_beside_ca binary64 float floats a b c d e f g h i j k l o p q answer.
Proof. runs ray_beside_ca m. Qed.
Theorem ray_beside_ab_runs (m : mode) a b c d e f g h i j k l o p q : exists answer,
  ray_beside_ab binary64 float floats a b c d e f g h i j k l o p q answer.
Proof. runs ray_beside_ab m. Qed.
Theorem ray_beside_bc_runs (m : mode) a b c d e f g h i j k l o p q : exists answer,
  ray_beside_bc binary64 float floats a b c d e f g h i j k l o p q answer.
Proof. runs ray_beside_bc m. Qed.
Theorem ray_height_runs (m : mode) a b c d e f g h i j k l o p q : exists answer,
  ray_height binary64 float floats a b c d e f g h i j k l o p q answer.
Proof. runs ray_height m. Qed.
Theorem ray_and_ball_runs (m : mode) a b c d e f g h i j : exists answer,
  ray_and_ball binary64 float floats a b c d e f g h i j answer.
Proof. runs ray_and_ball m. Qed.
Theorem spheres_runs (m : mode) a b c d e f g h : exists answer, spheres binary64 float floats a b c d e f g h answer.
Proof. runs spheres m. Qed.
Theorem ball_and_box_2_runs (m : mode) a b c d e f g : exists answer,
  ball_and_box_2 binary64 float floats a b c d e f g answer.
Proof. runs ball_and_box_2 m. Qed.
Theorem ball_and_box_3_runs (m : mode) a b c d e f g h i j : exists answer,
  ball_and_box_3 binary64 float floats a b c d e f g h i j answer.
Proof. runs ball_and_box_3 m. Qed.
Theorem sweep_start_runs (m : mode) a b c d e f g h i j k l o p : exists answer,
  sweep_start binary64 float floats a b c d e f g h i j k l o p answer.
Proof. runs sweep_start m. Qed.
Theorem sweep_slope_at_start_runs (m : mode) a b c d e f g h i j k l o p : exists answer,
  sweep_slope_at_start binary64 float floats a b c d e f g h i j k l o p answer.
Proof. runs sweep_slope_at_start m. Qed.
Theorem sweep_slope_at_end_runs (m : mode) a b c d e f g h i j k l o p : exists answer,
  sweep_slope_at_end binary64 float floats a b c d e f g h i j k l o p answer.
Proof. runs sweep_slope_at_end m. Qed.
Theorem sweep_end_runs (m : mode) a b c d e f g h i j k l o p : exists answer,
  sweep_end binary64 float floats a b c d e f g h i j k l o p answer.
Proof. runs sweep_end m. Qed.
Theorem velocity_apart_runs (m : mode) a b c d e f g h i j k l o p q r s t v w x y z z1 : exists answer,
  velocity_apart binary64 float floats a b c d e f g h i j k l o p q r s t v w x y z z1 answer.
Proof. runs velocity_apart m. Qed.
Theorem segments_runs (m : mode) a b c d e f g h : exists answer, segments binary64 float floats a b c d e f g h answer.
Proof. runs segments m. Qed.
Theorem ray_runs (m : mode) a b c d e f g h : exists answer, ray binary64 float floats a b c d e f g h answer.
Proof. runs ray m. Qed.
Theorem sweep_passage_runs (m : mode) a b c d e f g h i j k l o p : exists answer,
  sweep_passage binary64 float floats a b c d e f g h i j k l o p answer.
Proof. runs sweep_passage m. Qed.
Theorem point_in_obb_runs (m : mode) a b c d e f g h i j k l o p q : exists answer,
  point_in_obb binary64 float floats a b c d e f g h i j k l o p q answer.
Proof. runs point_in_obb m. Qed.
Theorem heights_meeting_runs (m : mode) a b c d e f g h i j k : exists answer,
  heights_meeting binary64 float floats a b c d e f g h i j k answer.
Proof. runs heights_meeting m. Qed.

Section Obb.
Variables (m : mode) (x y z : nat -> float) (wx wy wz : float) (sizes : nat -> float) (sum : float).
Lemma size_runs a b c : exists s t, add floats (Plain (Babs a)) (Plain (Babs b)) t /\
  add floats (Plain t) (Plain (Babs c)) s.
Proof.
destruct (some_sum m (Plain (Babs a)) (Plain (Babs b))) as [t T].
destruct (some_sum m (Plain t) (Plain (Babs c))) as [s S]. eauto.
Qed.
Theorem obb_axes_runs : exists sizes sum, obb_axes binary64 float floats x y z wx wy wz sizes sum.
Proof.
destruct (size_runs (x 0%nat) (y 0%nat) (z 0%nat)) as (s0 & t0 & T0 & S0).
destruct (size_runs (x 1%nat) (y 1%nat) (z 1%nat)) as (s1 & t1 & T1 & S1).
destruct (size_runs (x 2%nat) (y 2%nat) (z 2%nat)) as (s2 & t2 & T2 & S2).
destruct (size_runs (x 3%nat) (y 3%nat) (z 3%nat)) as (s3 & t3 & T3 & S3).
destruct (size_runs (x 4%nat) (y 4%nat) (z 4%nat)) as (s4 & t4 & T4 & S4).
destruct (size_runs (x 5%nat) (y 5%nat) (z 5%nat)) as (s5 & t5 & T5 & S5).
destruct (size_runs wx wy wz) as (sw & tw & TW & SW).
destruct (some_sum m (Plain s0) (Plain s1)) as [a A]. destruct (some_sum m (Plain a) (Plain s2)) as [b B].
destruct (some_sum m (Plain s3) (Plain s4)) as [c C]. destruct (some_sum m (Plain c) (Plain s5)) as [d D].
destruct (some_sum m (Plain b) (Plain d)) as [e E]. destruct (some_sum m (Plain sw) (Plain e)) as [s S].
exists (fun i => match i with 0 => s0 | 1 => s1 | 2 => s2 | 3 => s3 | 4 => s4 | _ => s5 end)%nat, s.
unfold obb_axes. exists t0. split; [exact T0|]. split; [exact S0|]. exists t1. split; [exact T1|]. split; [exact S1|].
exists t2. split; [exact T2|]. split; [exact S2|]. exists t3. split; [exact T3|]. split; [exact S3|].
exists t4. split; [exact T4|]. split; [exact S4|]. exists t5. split; [exact T5|]. split; [exact S5|].
exists tw. split; [exact TW|]. exists sw. split; [exact SW|]. exists a. split; [exact A|]. exists b. split; [exact B|].
exists c. split; [exact C|]. exists d. split; [exact D|]. exists e. split; [exact E|exact S].
Qed.
Theorem obb_volume_runs i : exists answer, obb_volume binary64 float floats x y z wx wy wz sizes sum i answer.
Proof. runs obb_volume m. Qed.
Theorem obb_axis_runs v w others : exists answer,
  obb_axis binary64 float floats x y z wx wy wz sizes sum v w others answer.
Proof. runs obb_axis m. Qed.
End Obb.
