(* SPDX-License-Identifier: Apache-2.0 *)
(* Sums and products of numbers that are multiples of one unit: binary64, with gradual underflow or flushed to zero,
   computes them as if exponents had no end. *)
From Coq Require Import Reals ZArith List Lra Lia.
From Flocq Require Import Core.
From Filters Require Import arithmetic enclosed nearest enclosures window.
Open Scope R_scope.

Definition unit e p := forall x, seen p x -> multiple e x.
Lemma unit_value e p : unit e p -> multiple e (value p).
Proof. intros U. apply U, seen_value. Qed.
Lemma unit_down d e p : (d <= e)%Z -> unit e p -> unit d p.
Proof. intros L U x S. apply multiple_down with e; auto. Qed.
Lemma unit_negated e p : unit e p -> unit e (negated p).
Proof. intros U x S. rewrite <- (Ropp_involutive x). apply multiple_opp, U. now apply seen_negated. Qed.
Lemma unit_magnitude e p : unit e p -> unit e (magnitude p).
Proof. intros U x ->. now apply multiple_abs, unit_value. Qed.
Lemma unit_head e p : unit e p -> unit e (head kept p).
Proof. intros U x ->. apply multiple_round; auto with typeclass_instances. now apply unit_value. Qed.
Lemma unit_constant m e c : c = IZR m * bpow radix2 e -> unit e (Plain c).
Proof. intros -> x ->. now exists m. Qed.
Lemma unit_zero e : unit e (Plain 0).
Proof. intros x ->. exists 0%Z. ring. Qed.

(* What a processor may make of a result: with gradual underflow, or flushed to zero. Neither has a say where all is a
   multiple of the least normal number; nor has a processor that reads smaller numbers as zero. *)
Definition gradual choice := rounds (Znearest choice).
Definition flushed choice x := if Rlt_dec (Rabs (gradual choice x)) (bpow radix2 (-1022)) then 0 else gradual choice x.
Definition computes choice processor := forall x, multiple (-1022) x -> processor x = nearest choice x.
Theorem gradual_computes choice : computes choice (gradual choice).
Proof. intros x M. apply round_same with (-1022)%Z; auto with typeclass_instances. lia. Qed.
Theorem flushed_computes choice : computes choice (flushed choice).
Proof.
intros x M. rewrite <- gradual_computes by exact M. unfold flushed. destruct (Rlt_dec _ _) as [L|L]; [|reflexivity].
destruct (multiple_zero_or _ _ M) as [->|Z]; [symmetry; now apply round_0; auto with typeclass_instances|exfalso].
apply Rlt_not_le with (1 := L). apply abs_round_ge_generic; auto with typeclass_instances.
apply generic_format_bpow. unfold FLT_exp. simpl. lia.
Qed.
Theorem window_right choice first rest : Forall double (first :: rest) -> in_window (Znearest choice) first rest ->
  Forall (fun x => unit (-152) (Plain x) /\ Rabs x <= most) (first :: rest).
Proof.
intros D W. apply in_window_right in W; auto with typeclass_instances. rewrite Forall_forall in *. intros x I.
destruct (W x I) as [M B]. split; [|exact B]. intros y ->. exact M.
Qed.

Section Range.
Variable choice : Z -> bool.
Notation rnd := (nearest choice).
Variable processor : R -> R.
Hypothesis normal : computes choice processor.

Lemma processor_is e x : (-1022 <= e)%Z -> multiple e x -> processor x = rnd x.
Proof. intros L M. apply normal. now apply multiple_down with e. Qed.
Lemma unit_rounded e x : multiple e x -> unit e (Plain (rnd x)).
Proof. intros M y ->. apply multiple_round; auto with typeclass_instances. Qed.

Lemma added_same e p q z : (-1022 <= e)%Z -> unit e p -> unit e q -> added processor p q z ->
  added rnd p q z /\ unit e z.
Proof.
intros L P Q (x & y & X & Y & ->). assert (M : multiple e (x + y)) by (apply multiple_plus; auto).
rewrite (processor_is e) by assumption. split; [now exists x, y|now apply unit_rounded].
Qed.
Lemma subtracted_same e p q z : (-1022 <= e)%Z -> unit e p -> unit e q -> subtracted processor p q z ->
  subtracted rnd p q z /\ unit e z.
Proof.
intros L P Q (x & y & X & Y & ->). assert (M : multiple e (x - y)) by (apply multiple_minus; auto).
rewrite (processor_is e) by assumption. split; [now exists x, y|now apply unit_rounded].
Qed.
Lemma multiplied_same d e p q z : (-1022 <= d + e)%Z -> unit d p -> unit e q -> multiplied processor p q z ->
  multiplied rnd p q z /\ unit (d + e) z.
Proof.
intros L P Q ->. assert (M : multiple (d + e) (value p * value q)) by (apply multiple_times; now apply unit_value).
rewrite (processor_is (d + e)) by assumption. split; [reflexivity|]. intros x [-> | ->]; [|exact M].
now apply (unit_rounded _ _ M).
Qed.

Definition unit_pair e r := unit e (pair_high r) /\ unit e (pair_low r).
Definition unit_factor e f := unit e (factor_whole f) /\ unit e (factor_head f) /\ unit e (factor_tail f).
Definition unit_term e t := unit e (term2_head t) /\ unit e (term2_tail t).
Definition unit_sum e s := unit e (sum_high s) /\ unit e (sum_low s) /\ unit e (sum_size s).
(* the error in a smaller unit *)
Definition unit_enclosed e f r := (f <= e - 78)%Z /\ unit e (enclosed_high r) /\ unit e (enclosed_low r) /\
  unit f (enclosed_error r).

Ltac unpack := repeat match goal with H : exists _, _ |- _ => destruct H | H : _ /\ _ |- _ => destruct H end.
Ltac units := cbn [factor_head factor_whole factor_tail pair_high pair_low term2_head term2_tail sum_high sum_low
  sum_size enclosed_high enclosed_low enclosed_error]; auto using unit_head, unit_magnitude, unit_negated, unit_zero.
Ltac run e := repeat match goal with
  | H : added processor ?p ?q ?z |- _ =>
    destruct (added_same e p q z ltac:(lia) ltac:(units) ltac:(units) H); clear H
  | H : subtracted processor ?p ?q ?z |- _ =>
    destruct (subtracted_same e p q z ltac:(lia) ltac:(units) ltac:(units) H); clear H end.
Ltac done := repeat (eexists; split; [eassumption|]); eauto.

Lemma two_sum_same e a b r : (-1022 <= e)%Z -> unit e a -> unit e b -> two_sum processor a b r ->
  two_sum rnd a b r /\ unit_pair e r.
Proof. intros L A B R. unfold two_sum in *. unpack. subst. run e. split; [done|now split]. Qed.
Lemma difference_same e a b r : (-1022 <= e)%Z -> unit e a -> unit e b -> difference processor a b r ->
  difference rnd a b r /\ unit_pair e r.
Proof. intros L A B R. unfold difference in *. unpack. subst. run e. split; [done|now split]. Qed.
Lemma factor_of_pair_same e p f : (-1022 <= e)%Z -> unit_pair e p -> factor_of_pair processor p f ->
  factor_of_pair rnd p f /\ unit_factor e f.
Proof. intros L [A B] R. unfold factor_of_pair in *. unpack. subst. run e. split; [done|]. repeat split; units. Qed.
Lemma factor_of_number_same e p f : (-1022 <= e)%Z -> unit e p -> factor_of_number processor p f ->
  factor_of_number rnd p f /\ unit_factor e f.
Proof. intros L A R. unfold factor_of_number in *. unpack. subst. run e. split; [done|]. repeat split; units. Qed.
Lemma factor_of_enclosed_same e f x r : (-1022 <= e)%Z -> unit_enclosed e f x -> factor_of_enclosed processor x r ->
  factor_of_enclosed rnd x r /\ unit_factor e r.
Proof.
intros L (_ & A & B & _) R. unfold factor_of_enclosed in *. unpack. subst. run e. split; [done|]. repeat split; units.
Qed.
Lemma product_same d e f g r : (-1022 <= d + e)%Z -> unit_factor d f -> unit_factor e g -> product processor f g r ->
  product rnd f g r /\ unit_term (d + e) r.
Proof.
intros L (A & B & C) (A' & B' & C') R. unfold product in *. unpack. subst.
repeat match goal with H : multiplied processor ?p ?q ?z |- _ =>
  destruct (multiplied_same d e p q z L ltac:(assumption) ltac:(assumption) H); clear H end.
run (d + e)%Z. split; [done|now split].
Qed.
Lemma sum_plus_same e s t r : (-1022 <= e)%Z -> unit_sum e s -> unit_term e t -> sum_plus processor s t r ->
  sum_plus rnd s t r /\ unit_sum e r.
Proof.
intros L (A & B & C) (A' & B') (p & R & rest). apply two_sum_same with (e := e) in R as [R [P Q]]; auto.
unpack. subst. run e. split; [exists p; split; [exact R|done]|]. repeat split; auto.
Qed.
Lemma sum_first_same e t r : unit_term e t -> sum_first t r -> unit_sum e r.
Proof. intros [A B] ->. repeat split; units. Qed.
Lemma sum_minus_same e s t r : (-1022 <= e)%Z -> unit_sum e s -> unit_term e t -> sum_minus processor s t r ->
  sum_minus rnd s t r /\ unit_sum e r.
Proof.
intros L S [A B] (x & -> & y & P & ->). apply (sum_plus_same e) in P as [P U]; auto.
- split; [|exact U]. eexists. split; [reflexivity|]. now exists y.
- split; units.
Qed.
Lemma sum_plus_number_same e s p r : (-1022 <= e)%Z -> unit_sum e s -> unit e p -> sum_plus_number processor s p r ->
  sum_plus_number rnd s p r /\ unit_sum e r.
Proof.
intros L S A (x & P & ->). apply (sum_plus_same e) in P as [P U]; auto; [|split; units]. split; [now exists x|exact U].
Qed.
Lemma sum_value_same e s r : (-944 <= e)%Z -> unit_sum e s -> sum_value processor s r ->
  sum_value rnd s r /\ unit_enclosed e (e - 78) r.
Proof.
intros L (A & B & C) (t & M & ->). apply (multiplied_same (-78) e) in M as [M U]; [|lia| |exact C].
- split; [now exists t|]. repeat split; auto; [lia|]. cbn [enclosed_error].
  now replace (e - 78)%Z with (-78 + e)%Z by ring.
- apply unit_constant with (2 * sum_terms s + 12)%Z. unfold cut, half_ulp. simpl. lra.
Qed.

(* the products of an error's computation *)
Lemma five_quarters : unit (-2) (Plain (5 / 4)).
Proof. apply unit_constant with 5%Z. simpl. lra. Qed.
Lemma add_same e f x y r : (-1020 <= f)%Z -> unit_enclosed e f x -> unit_enclosed e f y -> add processor x y r ->
  add rnd x y r /\ unit_enclosed e (f - 2) r.
Proof.
intros L (Le & A & B & C) (_ & A' & B' & C') (p & R & rest).
apply two_sum_same with (e := e) in R as [R [P Q]]; auto; [|lia].
assert (U3 : unit (-53) (Plain (3 * half_ulp))) by (apply unit_constant with 3%Z; unfold half_ulp; simpl; lra).
pose proof five_quarters as U5. destruct rest as (t1 & R1 & t2 & R2 & t3 & R3 & t4 & R4 & t5 & R5 & t6 & R6 & t7 & R7 &
  t8 & R8 & ->).
apply (added_same e) in R1 as [R1 V1]; [|lia|units|units]. apply (added_same e) in R2 as [R2 V2]; [|lia|units|units].
apply (added_same e) in R3 as [R3 V3]; [|lia|units|units]. apply (added_same e) in R4 as [R4 V4]; [|lia|units|units].
apply (added_same f) in R5 as [R5 V5]; [|lia|units|units].
apply (multiplied_same (-2) f) in R6 as [R6 V6]; [|lia|units|units].
apply (multiplied_same (-53) e) in R7 as [R7 V7]; [|lia|units|units].
apply (unit_down (f - 2)) in V6; [|lia]. apply (unit_down (f - 2)) in V7; [|lia].
apply (added_same (f - 2)) in R8 as [R8 V8]; [|lia|units|units].
split; [exists p; split; [exact R|done]|]. repeat split; auto. lia.
Qed.
Lemma subtract_same e f x y r : (-1020 <= f)%Z -> unit_enclosed e f x -> unit_enclosed e f y ->
  subtract processor x y r -> subtract rnd x y r /\ unit_enclosed e (f - 2) r.
Proof.
intros L X (Le & A & B & C) (t & N & s & R & ->). apply (add_same e f) in R as [R U]; auto.
- split; [|exact U]. exists t. split; [exact N|]. now exists s.
- unfold negate in N. subst t. repeat split; auto; cbn [enclosed_high enclosed_low]; units.
Qed.
Lemma multiply_same d e f g h x y r : (-1020 <= f)%Z -> (-1020 <= g)%Z -> (-1020 <= h)%Z ->
  (h <= d + g)%Z -> (h <= e + f)%Z -> unit_enclosed d f x ->
  unit_enclosed e g y -> multiply processor x y r -> multiply rnd x y r /\ unit_enclosed (d + e) (h - 2) r.
Proof.
intros Lf Lg L H1 H2 X Y (p & F & q & G & t & P & rest).
apply (factor_of_enclosed_same d f) in F as [F FU]; [|destruct X, Y; lia|exact X].
apply (factor_of_enclosed_same e g) in G as [G GU]; [|destruct X, Y; lia|exact Y].
apply (product_same d e) in P as [P PU]; [|destruct X, Y; lia|exact FU|exact GU].
destruct X as (Lx & A & B & C), Y as (Ly & A' & B' & C'), FU as (D1 & D2 & D3), GU as (E1 & E2 & E3), PU as (P1 & P2).
destruct rest as (t3 & R3 & t4 & R4 & t5 & R5 & t6 & R6 & t7 & R7 & t8 & R8 & ->). pose proof five_quarters as U5.
assert (U10 : unit (-78) (Plain (10 * cut))) by (apply unit_constant with 10%Z; unfold cut, half_ulp; simpl; lra).
apply (multiplied_same d g) in R3 as [R3 V3]; [|lia|units|units]. apply (unit_down h) in V3; [|lia].
apply (multiplied_same e f) in R4 as [R4 V4]; [|lia|units|units]. apply (unit_down h) in V4; [|lia].
apply (added_same h) in R5 as [R5 V5]; [|lia|units|units].
apply (multiplied_same (-2) h) in R6 as [R6 V6]; [|lia|units|units]. apply (unit_down (h - 2)) in V6; [|lia].
apply (multiplied_same (-78) (d + e)) in R7 as [R7 V7]; [|lia|units|units]. apply (unit_down (h - 2)) in V7; [|lia].
apply (added_same (h - 2)) in R8 as [R8 V8]; [|lia|units|units].
split; [exists p; split; [exact F|]; exists q; split; [exact G|]; exists t; split; [exact P|done]|].
repeat split; auto. lia.
Qed.
Lemma rounded_same e f x r : (-1020 <= f)%Z -> unit_enclosed e f x -> rounded processor x r -> rounded rnd x r.
Proof.
intros L (Le & A & B & C) (t & R1 & t1 & R2 & m & R3 & t3 & R4 & a & R5 & t5 & R6 & b & R7 & c & R8 & z & R9 & ->).
pose proof five_quarters as U5.
assert (U2 : unit (-53) (Plain (2 * half_ulp))) by (apply unit_constant with 2%Z; unfold half_ulp; simpl; lra).
apply (unit_down (f - 2)) in A; [|lia]. pose proof B as B'. apply (unit_down (f - 2)) in B'; [|lia].
apply (multiplied_same (-2) f) in R1 as [R1 V1]; [|lia|units|units]. apply (unit_down (f - 2)) in V1; [|lia].
apply (multiplied_same (-53) e) in R2 as [R2 V2]; [|lia|units|units]. apply (unit_down (f - 2)) in V2; [|lia].
apply (added_same (f - 2)) in R3 as [R3 V3]; [|lia|units|units].
apply (added_same (f - 2)) in R4 as [R4 V4]; [|lia|units|units].
apply (added_same (f - 2)) in R5 as [R5 V5]; [|lia|units|units].
apply (subtracted_same (f - 2)) in R6 as [R6 V6]; [|lia|units|units].
apply (added_same (f - 2)) in R7 as [R7 V7]; [|lia|units|units].
apply (added_same (f - 2)) in R9 as [R9 V9]; [|lia|units|units].
exists t; split; [exact R1|]. exists t1; split; [exact R2|]. exists m; split; [exact R3|].
exists t3; split; [exact R4|]. exists a; split; [exact R5|]. exists t5; split; [exact R6|].
exists b; split; [exact R7|]. exists c; split; [exact R8|]. exists z; split; [exact R9|reflexivity].
Qed.
End Range.
