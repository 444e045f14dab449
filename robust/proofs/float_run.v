(* SPDX-License-Identifier: Apache-2.0 *)
(* Tactics that take a run on floats that answers a sign to a run on real numbers, where NAME_right holds. *)
From Coq Require Import Reals ZArith Lra Lia Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model constants steps tactics format floats float_steps float_guards.
Import ListNotations.
Open Scope R_scope.

(* What is claimed of an answer: with an infinity or NaN among the arguments it is unknown; a sign is the exact one. *)
Definition correct answer (arguments : list float) exact := (answer <> unknown -> Forall finite arguments) /\
  (answer = positive -> exact > 0) /\ (answer = negative -> exact < 0).
Lemma unknown_correct arguments exact : correct unknown arguments exact.
Proof. now repeat split. Qed.

Lemma fits_third : fits binary64 (third binary64) 1 1. Proof. apply (in_binary64 Zfloor). Qed.
Lemma fits_quarter : fits binary64 (quarter binary64) 1 1. Proof. apply (in_binary64 Zfloor). Qed.
Lemma fits_sixth : fits binary64 (sixth binary64) 1 1. Proof. apply (in_binary64 Zfloor). Qed.
Ltac fits := first [exact fits_third | exact fits_quarter | exact fits_sixth].

(* constants *)
Lemma product_of_powers a b i j k : a = bpow radix2 i -> b = bpow radix2 j -> (i + j)%Z = k -> a * b = bpow radix2 k.
Proof. intros -> -> <-. symmetry. apply bpow_plus. Qed.
Lemma constant_mag r c : constant floats r c -> 0 <= r <= bpow radix2 (-10) -> mag c (-10) /\ up c.
Proof.
intros [F <-] L. split; [split; [exact F|]|apply up_finite; [exact F|apply L]]. rewrite Rabs_right by lra. apply L.
Qed.
Lemma relative_small c d : 0 <= c <= 1024 -> 0 <= d <= 1024 -> 0 <= relative c d (u binary64) <= bpow radix2 (-10).
Proof.
intros C D. unfold relative. cbn [u binary64]. pose proof (bpow_gt_0 radix2 (-52)).
assert (L : bpow radix2 (-52) <= bpow radix2 (-30)) by (apply bpow_le; lia). simpl (bpow radix2 (-30)) in L.
simpl (bpow radix2 (-10)). set (u0 := bpow radix2 (-52)) in *. clearbody u0. assert (0 <= d * u0 <= 1) by nra. nra.
Qed.
Lemma absolute_small c r k : 0 <= c <= 4096 -> r = bpow radix2 k -> (k <=? 900)%Z = true ->
  0 <= c * (n binary64 * r) <= bpow radix2 (-10).
Proof.
intros C -> K%Z.leb_le. change (n binary64) with (bpow radix2 (-1022)). rewrite <- bpow_plus.
assert (P : bpow radix2 (-1022 + k) <= bpow radix2 (-30)) by (apply bpow_le; lia). simpl (bpow radix2 (-30)) in P.
pose proof (bpow_ge_0 radix2 (-1022 + k)). simpl (bpow radix2 (-10)). split; [apply Rmult_le_pos; lra|nra].
Qed.
Lemma units_small c : 0 <= c <= 1024 -> 0 <= c * u binary64 <= bpow radix2 (-10).
Proof.
intros C. cbn [u binary64]. pose proof (bpow_gt_0 radix2 (-52)).
assert (L : bpow radix2 (-52) <= bpow radix2 (-30)) by (apply bpow_le; lia). simpl (bpow radix2 (-30)) in L.
simpl (bpow radix2 (-10)). split; [apply Rmult_le_pos; lra|nra].
Qed.
Lemma two_to_small e : (e <=? -10)%Z = true -> 0 <= two_to e <= bpow radix2 (-10).
Proof.
intros E%Z.leb_le. assert (T : two_to e = bpow radix2 e) by (symmetry; apply (bpow_powerRZ radix2)). rewrite T.
split; [apply bpow_ge_0|now apply bpow_le].
Qed.
Ltac power_of_two r := lazymatch r with
  | third binary64 => constr:(341%Z) | quarter binary64 => constr:(255%Z) | sixth binary64 => constr:(170%Z)
  | n binary64 => constr:((-1022)%Z) | two_to ?e => e | IZR ?z => eval vm_compute in (Z.log2 z)
  | ?a * ?b => let i := power_of_two a in let j := power_of_two b in eval vm_compute in (i + j)%Z end.
Ltac is_power := lazymatch goal with
  | |- ?a * ?b = _ => let i := power_of_two a in let j := power_of_two b in
    apply (product_of_powers a b i j); [is_power|is_power|reflexivity]
  | |- two_to _ = _ => symmetry; apply (bpow_powerRZ radix2)
  | |- _ => reflexivity end.
Ltac small_constant := lazymatch goal with
  | |- 0 <= relative _ _ _ <= _ => apply relative_small; lra
  | |- 0 <= _ * (n binary64 * ?r) <= _ =>
    let k := power_of_two r in apply (absolute_small _ r k); [lra|is_power|reflexivity]
  | |- 0 <= _ * u binary64 <= _ => apply units_small; lra
  | |- 0 <= two_to _ <= _ => apply two_to_small; reflexivity
  | |- 0 <= 0 <= _ => split; [apply Rle_refl|apply bpow_ge_0] end.
Ltac float_constants := change (@magnitude float floats) with (@Babs 53 1024) in *;
  change (@opposite float floats) with (@Bopp 53 1024) in *;
  repeat match goal with S : constant floats ?r ?c |- _ =>
    lazymatch goal with _ : finite c |- _ => fail | _ => idtac end;
    pose proof (proj1 S : finite c);
    try (let B := fresh "B" in let U := fresh "U" in destruct (constant_mag r c S ltac:(small_constant)) as [B U]) end.

(* from the guard back *)
Ltac rise := lazymatch goal with
  | |- rises (Plain (Babs ?x)) => exact (up_abs x)
  | |- rises (Plain ?x) => match goal with U : up x |- _ => exact U end
  | |- rises (Product ?x ?x ?t) => match goal with S : mul floats x x t |- _ => exact (conj (or_introl eq_refl) S) end
  | |- rises (Product ?x ?y ?t) => match goal with U : up x, V : up y, S : mul floats x y t |- _ =>
      exact (conj (or_intror (conj U V)) S) end end.
Ltac rising :=
  repeat match goal with S : greater floats ?x ?c true, F : finite ?c, C : constant floats 0 ?c |- _ =>
    lazymatch goal with _ : up x |- _ => fail | _ => pose proof (greater_up x c S F (proj2 C)) end end;
  repeat match goal with S : add floats ?p ?q ?z |- _ =>
    lazymatch goal with _ : up z |- _ => fail | _ => idtac end;
    let U := fresh "U" in assert (U : up z) by (apply (add_up p q z S); rise) end.
Ltac guards := match goal with S : at_most floats ?z ?h true, U : up ?z, C : constant floats ?r ?h |- _ =>
  lazymatch goal with _ : mag z _ |- _ => fail | _ => idtac end;
  let k := power_of_two r in let B := fresh "B" in
  assert (B : mag z k) by (apply (guard_mag z h k S (proj1 C)); [apply (eq_trans (proj2 C)); is_power
    |reflexivity|exact U]) end.
Definition parted (z : float) := True.
Ltac parted k P := lazymatch type of P with
  | part _ (Plain ?x) => let k' := eval vm_compute in (k + 1)%Z in
    lazymatch goal with
    | _ : mag x _ |- _ => idtac
    | _ => let B := fresh "B" in pose proof (P : mag x k') as B;
      lazymatch x with Babs ?y => lazymatch goal with _ : mag y _ |- _ => idtac | _ => pose proof (mag_abs y k' B) end
        | _ => idtac end end
  | part _ (Product ?x ?x _) => let j := eval vm_compute in ((k + 3) / 2)%Z in
    lazymatch goal with _ : mag x _ |- _ => idtac | _ => pose proof (P eq_refl j ltac:(discriminate)) end end; clear P.
Ltac back := repeat match goal with B : mag ?z ?k, S : add floats ?p ?q ?z |- _ =>
  lazymatch goal with _ : parted z |- _ => fail | _ => idtac end;
  let P := fresh "P" in let Q := fresh "Q" in
  destruct (add_parts p q z k S B ltac:(rise) ltac:(rise) eq_refl eq_refl) as [P Q];
  assert (parted z) by exact I; parted k P; parted k Q end.

(* and on, operation by operation, in the order of the text *)
Ltac know x := lazymatch goal with _ : mag x _ |- _ => idtac | _ =>
  lazymatch x with
  | Babs ?y => match goal with B : mag y ?k |- _ => pose proof (abs_mag y k B) end
  | Bopp ?y => match goal with B : mag y ?k |- _ => pose proof (opp_mag y k B) end end end.
Ltac mag_of x := lazymatch goal with B : mag x ?k |- _ => k end.
Ltac bound_of x := lazymatch goal with B : mag x _ |- _ => B end.
Ltac know_operand p := lazymatch p with Plain ?x => know x | Product ?a ?b ?t => know a; know b; know t end.
Ltac within_of p := lazymatch p with
  | Plain ?x => let k := mag_of x in let B := bound_of x in constr:(conj B I : within (Plain x) k)
  | Product ?a ?b ?t => let i := mag_of a in let j := mag_of b in let l := mag_of t in
    let A := bound_of a in let B := bound_of b in let C := bound_of t in
    let k := eval vm_compute in (Z.max l (i + j)) in
    constr:(within_product a b t i j l k A B C eq_refl : within (Product a b t) k) end.
Ltac exponent A := lazymatch type of A with within _ ?k => k end.
Ltac forward S := lazymatch type of S with
  | mul floats ?x ?y ?z => lazymatch goal with _ : mag z _ |- _ => idtac | _ => know x; know y;
      let i := mag_of x in let j := mag_of y in let A := bound_of x in let B := bound_of y in
      let k := eval vm_compute in (i + j)%Z in pose proof (mul_mag x y z i j k S A B eq_refl eq_refl) end
  | choose floats ?b ?x ?y ?z => lazymatch goal with _ : mag z _ |- _ => idtac | _ => know x; know y;
      let i := mag_of x in let j := mag_of y in let A := bound_of x in let B := bound_of y in
      let k := eval vm_compute in (Z.max i j) in pose proof (choose_mag b x y z i j k S A B eq_refl) end
  | square_root floats ?x ?z => lazymatch goal with _ : mag z _ |- _ => idtac | U : up x |- _ =>
      let i := mag_of x in let A := bound_of x in let j := eval vm_compute in ((i + 1) / 2)%Z in
      pose proof (root_mag x z i j S A U ltac:(discriminate) eq_refl) end
  | ?op floats ?p ?q ?z => lazymatch goal with _ : mag z _ |- _ => idtac | _ => know_operand p; know_operand q;
      let A := within_of p in let B := within_of q in
      let i := exponent A in let j := exponent B in let k := eval vm_compute in (Z.max i j + 1)%Z in
      let step := lazymatch op with @add _ => constr:(add_mag) | @sub _ => constr:(sub_mag) end in
      pose proof (step p q z i j k S A B eq_refl eq_refl) end end.
Ltac is_finite x := lazymatch goal with
  | F : finite x |- _ => F
  | B : mag x _ |- _ => constr:(proj1 B) end.
Ltac as_real := repeat match goal with |- context [magnitude M (value ?x)] =>
  change (magnitude M (value x)) with (Rabs (value x)); rewrite <- (value_abs x)
  | |- context [opposite M (value ?x)] =>
  change (opposite M (value x)) with (- value x); rewrite <- (value_opp x) end.
Ltac result S z lemma := forward S; exists (value z);
  split; [as_real; let B := bound_of z in exact (lemma _ _ z _ S B eq_refl)|clear S].
Ltac advance := lazymatch goal with
  | |- exists z, mul M _ _ z /\ _ =>
      lazymatch reverse goal with S : mul floats _ _ ?z |- _ => result S z mul_real end
  | |- exists z, add M _ _ z /\ _ =>
      lazymatch reverse goal with S : add floats _ _ ?z |- _ => result S z add_real end
  | |- exists z, sub M _ _ z /\ _ =>
      lazymatch reverse goal with S : sub floats _ _ ?z |- _ => result S z sub_real end
  | |- exists z, choose M _ _ _ z /\ _ => lazymatch reverse goal with S : choose floats ?b ?x ?y ?z |- _ =>
      forward S; exists (value z); split; [as_real; exact (choose_real b x y z S)|clear S] end
  | |- exists z, square_root M _ z /\ _ => lazymatch reverse goal with S : square_root floats ?x ?z, U : up ?x |- _ =>
      forward S; exists (value z); let X := is_finite x in let B := bound_of z in
      split; [exact (root_real x z _ S B eq_refl X U)|clear S] end
  | |- exists z, constant M _ z /\ _ =>
      lazymatch reverse goal with S : constant floats _ ?z |- _ =>
      exists (value z); split; [exact (proj2 S)|clear S] end
  | |- exists b, greater M _ _ b /\ _ => lazymatch reverse goal with S : greater floats ?x ?y ?b |- _ =>
      exists b; know x; let X := is_finite x in let Y := is_finite y in
      split; [as_real; exact (greater_real x y b S X Y)|clear S] end
  | |- exists b, at_most M _ _ b /\ _ => lazymatch reverse goal with S : at_most floats ?x ?y ?b |- _ =>
      exists b; let X := is_finite x in let Y := is_finite y in
      split; [as_real; exact (at_most_real x y b S X Y)|clear S] end end.

(* an argument is finite where it, or a difference that it is in, is not large *)
Lemma sub_finite a b z : sub floats (Plain a) (Plain b) z -> finite z -> finite a /\ finite b.
Proof.
intros S Z. destruct (sub_used _ _ _ S (or_introl Z)) as (x & y & [(a' & A & F & _)|(c & d & [] & _)] & Y & _).
destruct Y as [(b' & B & E & _)|(c & d & [] & _)]. eauto using reads_finite.
Qed.
Lemma add_finite a b z : add floats (Plain a) (Plain b) z -> finite z -> finite a /\ finite b.
Proof.
intros S Z. destruct (add_used _ _ _ S (or_introl Z)) as (x & y & [(a' & A & F & _)|(c & d & [] & _)] & Y & _).
destruct Y as [(b' & B & E & _)|(c & d & [] & _)]. eauto using reads_finite.
Qed.
Ltac finite_argument := match goal with
  | B : mag ?x _ |- finite ?x => exact (proj1 B)
  | B : mag ?z _, S : sub floats (Plain ?a) (Plain ?b) ?z |- finite ?a => exact (proj1 (sub_finite a b z S (proj1 B)))
  | B : mag ?z _, S : sub floats (Plain ?a) (Plain ?b) ?z |- finite ?b => exact (proj2 (sub_finite a b z S (proj1 B)))
  | B : mag ?z _, S : add floats (Plain ?a) (Plain ?b) ?z |- finite ?a => exact (proj1 (add_finite a b z S (proj1 B)))
  | B : mag ?z _, S : add floats (Plain ?a) (Plain ?b) ?z |- finite ?b => exact (proj2 (add_finite a b z S (proj1 B)))
  end.

(* all flags but the sign's are true, or the answer is unknown *)
Ltac float_flags R := repeat match type of R with _ = (if negb ?c then unknown else _) =>
    let C := fresh "C" in destruct c eqn:C; cbn [negb] in R; [|subst; apply unknown_correct] end;
  repeat match goal with C : (_ && _)%bool = true |- _ => apply andb_prop in C; destruct C end;
  repeat match goal with C : ?b = true |- _ => is_var b; subst b end.
Ltac float_guards R := unpack; float_flags R; float_constants; rising; repeat guards; back.
Ltac all_finite := repeat apply Forall_cons; try apply Forall_nil; finite_argument.
Ltac float_run R := float_guards R; split; [intros _; all_finite|].
Ltac real_sub S := lazymatch type of S with sub floats ?p ?q ?z =>
  let B := bound_of z in exact (sub_real p q z _ S B eq_refl) end.

(* A number that a filter starts from: an argument of the decision, or a computed difference of two. *)
Inductive given (x : float) : list float -> R -> Prop :=
  | argument : given x [x] (value x)
  | difference a b : sub floats (Plain b) (Plain a) x -> given x [a; b] (value b - value a).
