(* SPDX-License-Identifier: Apache-2.0 *)
(* The rules of lane_bounds.v for the numbers of a lane, and tactics that go through a filter by them. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model constants steps format floats ghost lanes.
From Filters Require Import lane_bounds lane_turns.
Import ListNotations.
Open Scope R_scope.
#[local] Existing Instances p53 fexp_valid below_1024.

Lemma of_plus i j A B x y s t S T : finite (plus x y) -> est i A (value x) s S -> est j B (value y) t T ->
  est (Datatypes.S (Nat.max i j)) (2 * (A + B)) (value (plus x y)) (s + t) (S + T).
Proof. intros (_ & _ & ->)%plus_finite. apply est_plus; apply held_value. Qed.
Lemma of_minus i j A B x y s t S T : finite (minus x y) -> est i A (value x) s S -> est j B (value y) t T ->
  est (Datatypes.S (Nat.max i j)) (2 * (A + B)) (value (minus x y)) (s - t) (S + T).
Proof. intros (_ & _ & ->)%minus_finite. apply est_minus; apply held_value. Qed.
Lemma of_times i j x y s t S T : finite (times x y) -> est i 0 (value x) s S -> est j 0 (value y) t T ->
  est (Datatypes.S (i + j)) eta (value (times x y)) (s * t) (S * T).
Proof. intros (_ & _ & ->)%times_finite. apply est_times. Qed.
Lemma of_multiply_add fused i j k A x y z s t w S T W : finite (multiply_add fused x y z) ->
  est i 0 (value x) s S -> est j 0 (value y) t T -> est k A (value z) w W ->
  est (Datatypes.S (Nat.max (Datatypes.S (i + j)) k)) (4 * (eta + A)) (value (multiply_add fused x y z)) (s * t + w)
    (S * T + W).
Proof. intros (_ & _ & _ & R)%multiply_add_finite X Y Z. exact (est_multiply_add _ _ _ _ _ _ _ _ _ _ _ _ _ _
  (held_value z) X Y Z R). Qed.
Lemma of_difference x y : finite (minus x y) ->
  est 1 0 (value (minus x y)) (value x - value y) (Rabs (value x - value y)).
Proof. intros (_ & _ & ->)%minus_finite. apply est_minus_held; apply held_value. Qed.
Lemma of_sum x y : finite (plus x y) -> est 1 0 (value (plus x y)) (value x + value y) (Rabs (value x + value y)).
Proof. intros (_ & _ & ->)%plus_finite. apply est_plus_held; apply held_value. Qed.
Lemma of_size j A x t T : est j A (value x) t T -> est j A (value (size x)) (Rabs t) T.
Proof. unfold size, value. rewrite B2R_Babs. apply est_abs. Qed.
Lemma of_given x : est 0 0 (value x) (value x) (Rabs (value x)).
Proof. apply est_held. Qed.

Lemma low_plus i j A B x y S T : finite (plus x y) -> up x -> up y -> 0 <= A -> 0 <= B ->
  least_of i A (value x) S -> least_of j B (value y) T ->
  least_of (Datatypes.S (Nat.max i j)) (2 * (A + B)) (value (plus x y)) (S + T).
Proof. intros (_ & _ & ->)%plus_finite X Y PA PB. apply least_plus; auto using held_value, up_value. Qed.
Lemma low_times i j x y S T : finite (times x y) -> least_of i 0 (value x) S -> least_of j 0 (value y) T ->
  least_of (Datatypes.S (i + j)) eta (value (times x y)) (S * T).
Proof. intros (_ & _ & ->)%times_finite. apply least_times. Qed.
Lemma low_of_times i j x y S T : finite (times x y) -> least_of i 0 (value (size x)) S -> least_of j 0 (value (size
  y)) T ->
  least_of (Datatypes.S (i + j)) eta (value (size (times x y))) (S * T).
Proof.
unfold size, value. rewrite !B2R_Babs. intros (_ & _ & E)%times_finite. unfold value in E. rewrite E. apply
  least_abs_times.
Qed.
Lemma low_of_difference x y : finite (minus x y) -> least_of 1 0 (value (size (minus x y))) (Rabs (value x - value y)).
Proof.
unfold size. intros (_ & _ & E)%minus_finite. unfold value in *. rewrite B2R_Babs, E. apply least_abs_difference;
  apply held_value.
Qed.
Lemma low_of_given x : least_of 0 0 (value (size x)) (Rabs (value x)).
Proof. unfold size, value. rewrite B2R_Babs. apply least_held. Qed.
Lemma low_sum x y : finite (plus x y) -> 0 <= value x -> 0 <= value y -> least_of 1 0 (value (plus x y)) (value x +
  value y).
Proof. intros (_ & _ & ->)%plus_finite X Y. apply least_sum_held; try apply held_value. lra. Qed.
(* whatever is squared *)
Lemma up_square x : up (times x x).
Proof.
destruct (finite_case x) as [F|[->|[->| ->]]]; try reflexivity.
apply (outcome_up _ _ (outcome_mul mode_NE x x F F)). nra.
Qed.
Lemma up_add_square fused x z : up z -> up (multiply_add fused x x z).
Proof.
intros Z. unfold multiply_add. destruct fused; [|now apply up_plus, Z; apply up_square].
destruct (is_finite x && is_finite z) eqn:Q.
2:{ destruct x as [|[]| |[]], z as [|[]| |[]]; try discriminate; easy. }
apply andb_prop in Q as [X F]. apply (outcome_up _ _ (outcome_fma mode_NE x x z X X F)). apply up_value in Z. nra.
Qed.

Definition dominated (x m : float) := finite x /\ finite m /\ Rabs (value x) <= value m.
Lemma held_high r : rnd r < high -> r < high.
Proof.
intros L. apply Rnot_le_lt. intros H. apply Rlt_not_le in L. apply L. rewrite <- (rnd_held high); [now apply rnd_le|].
apply generic_format_bpow. unfold fexp, FLT_exp. lia.
Qed.
Lemma dominated_size x : finite x -> dominated x (size x).
Proof.
intros F. split; [exact F|]. split; [now destruct x|]. unfold size, value. rewrite B2R_Babs. apply Rle_refl.
Qed.
Lemma plus_fits x y : finite x -> finite y -> Rabs (rnd (value x + value y)) < high ->
  finite (plus x y) /\ value (plus x y) = rnd (value x + value y).
Proof.
intros X Y F. unfold plus. cases_of (Bplus_correct 53 1024 _ _ mode_NE x y X Y); [now intros (V & Z & _)|].
fold (rnd (value x + value y)) in L. lra.
Qed.
Lemma dominated_plus x y m k : dominated x m -> dominated y k -> finite (plus m k) -> dominated (plus x y) (plus m k).
Proof.
intros (X & M & L) (Y & K & L') F. pose proof (plus_finite _ _ F) as (_ & _ & E).
assert (B : Rabs (rnd (value x + value y)) <= value (plus m k)).
{ rewrite E, rnd_abs. apply rnd_le. apply Rle_trans with (1 := Rabs_triang _ _). lra. }
pose proof (below_high (plus m k)) as H. rewrite Rabs_right in H by (pose proof (Rabs_pos (rnd (value x + value y)));
  lra).
destruct (plus_fits x y X Y) as [Z V]; [lra|]. split; [exact Z|]. split; [exact F|]. now rewrite V.
Qed.

Ltac finites := repeat match goal with
  | H : finite (plus ?x ?y) |- _ => lazymatch goal with _ : finite x, _ : finite y |- _ => fail | _ =>
      destruct (plus_finite _ _ H) as (? & ? & _) end
  | H : finite (minus ?x ?y) |- _ => lazymatch goal with _ : finite x, _ : finite y |- _ => fail | _ =>
      destruct (minus_finite _ _ H) as (? & ? & _) end
  | H : finite (times ?x ?y) |- _ => lazymatch goal with _ : finite x, _ : finite y |- _ => fail | _ =>
      destruct (times_finite _ _ H) as (? & ? & _) end
  | H : finite (size ?x) |- _ => lazymatch goal with _ : finite x |- _ => fail | _ =>
      destruct (size_finite _ H) as [? _] end
  | H : finite (multiply_add _ ?x ?y ?z) |- _ =>
      lazymatch goal with _ : finite x, _ : finite y, _ : finite z |- _ => fail | _ =>
      destruct (multiply_add_finite _ _ _ _ H) as (? & ? & ? & _) end
  end.
Ltac ups := repeat first [assumption | apply up_size | apply up_square | apply up_add_square | apply up_plus
  | apply up_times | apply up_multiply_add | apply up_number; lia].
Ltac ests := match goal with
  | |- est _ _ (value (minus ?x ?y)) _ _ => is_var x; is_var y; apply of_difference; assumption
  | |- est _ _ (value (plus ?x ?y)) _ _ => is_var x; is_var y; apply of_sum; assumption
  | |- est _ _ (value (plus ?x ?y)) _ _ => eapply of_plus; [assumption|ests|ests]
  | |- est _ _ (value (minus ?x ?y)) _ _ => eapply of_minus; [assumption|ests|ests]
  | |- est _ _ (value (times ?x ?y)) _ _ => eapply of_times; [assumption|ests|ests]
  | |- est _ _ (value (multiply_add _ ?x ?y ?z)) _ _ => eapply of_multiply_add; [assumption|ests|ests|ests]
  | |- est _ _ (value (size ?x)) _ _ => eapply of_size; ests
  | |- est _ _ (value ?x) _ _ => is_var x; apply of_given end.
Ltac nonneg := try apply eta_pos; pose proof eta_pos; lra.
Ltac lows_of := match goal with
  | |- least_of _ _ (value (size (minus ?x ?y))) _ => is_var x; is_var y; apply low_of_difference; assumption
  | |- least_of _ _ (value (size (times ?x ?y))) _ => eapply low_of_times; [assumption|lows_of|lows_of]
  | |- least_of _ _ (value (plus ?x ?y)) _ => eapply low_plus; [assumption|ups|ups| | |lows_of|lows_of]; [nonneg|nonneg]
  | |- least_of _ _ (value (times ?x ?y)) _ => eapply low_times; [assumption|lows_of|lows_of]
  | |- least_of _ _ (value (size ?x)) _ => is_var x; apply low_of_given end.
Ltac small_rest := pose proof eta_pos; pose proof eta_spare; lra.

(* What is not NaN comes of what is not. *)
Definition known (x : float) := is_nan x = false.
Lemma known_plus x y : known (plus x y) -> known x /\ known y.
Proof. destruct x as [|[]| |], y as [|[]| |]; try discriminate; easy. Qed.
Lemma known_minus x y : known (minus x y) -> known x /\ known y.
Proof. destruct x as [|[]| |], y as [|[]| |]; try discriminate; easy. Qed.
Lemma known_times x y : known (times x y) -> known x /\ known y.
Proof. destruct x as [|[]| |], y as [|[]| |]; try discriminate; easy. Qed.
Lemma known_opposite x : known (negated x) -> known x.
Proof. now destruct x. Qed.
Lemma known_multiply_add fused x y z : known (multiply_add fused x y z) -> known x /\ known y /\ known z.
Proof.
unfold multiply_add. destruct fused; [|now intros [[A B]%known_times C]%known_plus].
destruct x as [|[]| |], y as [|[]| |], z as [|[]| |]; try discriminate; easy.
Qed.
Lemma known_above x y : above (size x) y = true -> known x.
Proof. destruct x, y; try discriminate; easy. Qed.
Ltac knowns := repeat match goal with
  | H : known (plus _ _) |- _ => apply known_plus in H as [? ?]
  | H : known (minus _ _) |- _ => apply known_minus in H as [? ?]
  | H : known (times _ _) |- _ => apply known_times in H as [? ?]
  | H : known (negated _) |- _ => apply known_opposite in H
  | H : known (multiply_add _ _ _ _) |- _ => apply known_multiply_add in H as (? & ? & ?) end.
