(* SPDX-License-Identifier: Apache-2.0 *)
(* Heights::meeting on all of binary64. Nothing guards the offset: overflow.v. *)
From Coq Require Import Reals ZArith Lra Lia Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model constants filters steps tactics format floats float_steps float_guards float_run.
From Filters Require Import overflow heights_meeting.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.

Lemma some_mul a b : exists z, mul M a b z.
Proof. exists (a * b), a, b. split; [now left|]. split; [now left|apply rounded_itself]. Qed.
Lemma some_add p q : exists z, add M p q z.
Proof.
assert (U : forall p, exists x, uses binary64 p x) by (intros [x|a b x]; exists x; [|left]; now left).
destruct (U p) as [x X], (U q) as [y Y]. exists (x + y), x, y. split; [exact X|]. split; [exact Y|apply rounded_itself].
Qed.
Lemma some_more a b : exists b', greater M a b b'.
Proof.
destruct (Rlt_dec b a) as [L|L]; [exists true|exists false]; exists a, b; (split; [now left|]); (split; [now left|]);
  split; try easy; lra.
Qed.

(* sums with the offset, with the height and with what bounds it *)
Ltac wide := lazymatch goal with |- exists z, add M _ _ z /\ _ =>
  lazymatch reverse goal with S : add floats ?p ?q ?z |- _ => exists (value z); split; [as_real;
    lazymatch goal with F : finite z |- _ => first
      [let W := within_of p in exact (terms_real _ _ _ _ S F W eq_refl)
      |let W := within_of q in exact (more_terms_real _ _ _ _ S F W eq_refl)] end|clear S] end end.
Ltac from_height := lazymatch goal with
  | |- exists z, add M (Plain (value ?r)) (Plain (value ?d)) z /\ _ =>
    lazymatch reverse goal with S : add floats (Plain r) (Plain d) ?z, F : finite d |- _ =>
      let W := within_of (Plain r) in let z0 := fresh "z" in let Z := fresh "Z" in let D := fresh "D" in
      destruct (add_stands _ _ _ _ S W eq_refl F) as (z0 & Z & D); exists z0; split; [exact Z|clear Z S] end
  | |- exists z, sub M (Plain (magnitude M ?x)) ?q z /\ _ =>
    lazymatch reverse goal with S : sub floats (Plain (Babs ?y)) ?p ?z, D : stands _ ?y x |- _ =>
      let W := within_of p in let z0 := fresh "z" in let Z := fresh "Z" in let D' := fresh "D" in
      destruct (stands_sub _ _ _ _ _ _ S (stands_abs _ _ _ D) W eq_refl ltac:(lia)) as (z0 & Z & D');
      exists z0; split; [exact Z|clear Z S] end
  | |- exists z, add M (Plain ?x) (Plain (value ?t)) z /\ _ =>
    lazymatch reverse goal with S : add floats (Plain ?y) (Plain t) ?z, D : stands _ ?y x |- _ =>
      let W := within_of (Plain t) in let z0 := fresh "z" in let Z := fresh "Z" in let D' := fresh "D" in
      destruct (stands_add _ _ _ _ _ _ S D W eq_refl ltac:(lia)) as (z0 & Z & D');
      exists z0; split; [exact Z|clear Z S] end
  | |- exists b, greater M ?x ?y b /\ _ =>
    lazymatch reverse goal with S : greater floats ?x' ?y' ?b |- _ => exists b; split; [as_real; first
      [match goal with D : stands _ x' x |- _ => know y'; let B := bound_of y' in
        exact (stands_greater _ _ _ _ _ _ S D B ltac:(reflexivity)) end
      |match goal with D : stands _ y' y |- _ => know x'; let B := bound_of x' in
        exact (greater_stands _ _ _ _ _ _ S D B ltac:(reflexivity)) end]|clear S] end end.
Ltac whole_run := repeat first [advance | wide | from_height].

(* what no answer rests on *)
Ltac any := lazymatch goal with
  | |- exists z, mul M ?a ?b z /\ _ => let z := fresh "z" in destruct (some_mul a b) as [z ?]
  | |- exists z, add M ?p ?q z /\ _ => let z := fresh "z" in destruct (some_add p q) as [z ?]
  | |- exists b, greater M ?x ?y b /\ _ => let b := fresh "b" in destruct (some_more x y) as [b ?] end;
  eexists; split; [eassumption|].

(* With an infinity or NaN among the arguments the answer is unknown. *)
Theorem heights_meeting_binary64 (cx cy cz r vx vy vz nx ny nz d : float) answer : up r ->
  heights_meeting binary64 float floats cx cy cz r vx vy vz nx ny nz d answer ->
  let height := nx * cx + ny * cy + nz * cz + d in
  let rise := nx * vx + ny * vy + nz * vz in
  let reach := r * sqrt (nx * nx + ny * ny + nz * nz) in
  let at_end := if Rlt_dec height 0 then - (height + rise) else height + rise in
  (answer <> meeting_unknown -> Forall finite [cx; cy; cz; r; vx; vy; vz; nx; ny; nz; d]) /\
  (answer = meets_at_start -> Rabs height < reach) /\
  (answer = meets_later -> Rabs height > reach /\ at_end < reach) /\
  (answer = meets_never -> Rabs height > reach /\ at_end > reach).
Proof.
intros UR R height rise reach at_end. unfold heights_meeting in R. unpack.
match type of R with _ = (if negb ?c then _ else _) => destruct c eqn:C; cbn [negb] in R;
  [|subst; repeat split; intros; discriminate || easy] end.
repeat match goal with C : (_ && _)%bool = true |- _ => apply andb_prop in C; destruct C end.
repeat match goal with C : ?b = true |- _ => is_var b; subst b end.
float_constants. rising.
match goal with S : square_root floats ?x ?z, U : up ?x |- _ => pose proof (root_up x z S U) end. rising.
(* the normal is bounded by its squares, all else by the sum *)
match goal with S : at_most floats ?z ?h true, U : up ?z, C : constant floats (two_to 900) ?h |- _ =>
  pose proof (guard_mag z h 900 S (proj1 C) (eq_trans (proj2 C) ltac:(is_power)) eq_refl U) end. back.
do 2 match goal with S : add floats (Plain (Babs nx)) (Plain (Babs ny)) ?t, S' : add floats (Plain ?t) _ _ |- _ =>
  first [progress forward S | forward S'] end.
repeat guards. back.
assert (K : answer = meeting_unknown \/ answer <> meeting_unknown) by (destruct answer; auto; right; discriminate).
destruct K as [->|K]; [repeat split; intros; discriminate || easy|].
lazymatch goal with
| G1 : greater floats (Bopp ?e) _ ?b1, G2 : greater floats _ ?e ?b2, E : add floats (Product _ ?a ?t) _ ?e,
  A : add floats (Plain ?p) (Product r _ _) ?a, D : add floats _ (Plain (Babs d)) ?p,
  X : mul floats _ ?a ?t, U : up ?e |- _ =>
  assert (Fe : finite e) by (lazymatch type of R with _ = (if b1 then _ else if negb b2 then _ else _) =>
    destruct b1; [exact (opposite_bound_finite _ _ G1 U)|
    destruct b2; [exact (bound_finite _ _ G2 U)|destruct (K R)]] end);
  pose proof (bound_terms _ _ _ _ _ X E Fe) as Fa; pose proof (left_finite _ _ _ A Fa) as Fp;
  pose proof (right_finite _ _ _ D Fp) as Fd; rewrite finite_abs in Fd; clear Fe;
  pose proof (finite_mag _ Fa); pose proof (finite_mag _ Fp); pose proof (finite_mag _ Fd) end.
split; [intros _; all_finite|].
apply heights_meeting_right with binary64.
1, 2, 3: apply (in_binary64 Zfloor).
{ exact (up_value _ UR). }
lazymatch type of R with _ = (if ?b then _ else if negb ?b' then _ else if ?b6 then _ else if ?b7 then _ else _) =>
  destruct b; [|destruct b'; cbn [negb] in R; [|destruct (K R)]] end.
- unfold heights_meeting. whole_run.
  any. lazymatch goal with E : mul floats ?c ?z _, C : constant floats (7 * _) ?c |- _ =>
    lazymatch goal with S : add floats _ _ z |- _ => clear S end end.
  whole_run. any. advance. any. any. any. exact R.
- lazymatch goal with
  | G1 : greater floats _ ?e ?b1, G2 : greater floats (Bopp ?e) _ ?b2, E : add floats (Product _ ?a ?t) _ ?e,
    X : mul floats _ ?a ?t, U : up ?e |- _ =>
    assert (Fe : finite e) by (lazymatch type of R with _ = (if b1 then _ else if b2 then _ else _) =>
      destruct b1; [exact (bound_finite _ _ G1 U)|destruct b2; [exact (opposite_bound_finite _ _ G2 U)|destruct (K R)]]
      end);
    pose proof (bound_terms _ _ _ _ _ X E Fe) as Fl; clear Fe; pose proof (finite_mag _ Fl) end.
  unfold heights_meeting. whole_run. exact R.
Qed.
