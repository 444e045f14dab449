(* SPDX-License-Identifier: Apache-2.0 *)
(* Polynomials of degree three whose roundings are taken for independent, operation by operation: what is known of a
   computed number is one proposition, and each operation has one lemma, so that a run can be taken in pieces. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Filters Require Import model constants steps ghost.
Open Scope R_scope.

Section Tracked.
Variables (F : format) (H : R).
Hypothesis G : fits F H 1 1.
Notation u := (u F). Notation n := (n F). Notation M := (reals F).
Let Hu : 0 < u <= 1/16 := fits_u F H 1 1 G.

(* x is at most m H^(k + 1) / 1024, and c n H^k / 1024 away from a ghost that came of t, a polynomial of which T is the
   sum of the terms' magnitudes, by at most j roundings of each term. *)
Definition tracked k c m j x t T := small H (S k) m x /\ exists x0, close F H k c x x0 /\ off u j x0 t T.
(* what is added *)
Definition added k c m j p t T := forall x, uses F p x -> tracked k c m j x t T.
(* j roundings, and one of the whole *)
Definition rounded_once k c j x t T := exists x0 e, Rabs e <= u /\ close F H k c x (x0 * (1 + e)) /\ off u j x0 t T.

Lemma small_more k m l x : small H k m x -> (m <= l)%Z -> small H k l x.
Proof.
intros [A B] L. split; [lia|]. apply Rle_trans with (1 := B). pose proof (pow_one F H 1 1 G k).
apply Rmult_le_compat_r; [lra|]. apply IZR_le in L. unfold q. lra.
Qed.
Lemma tracked_input x m : small H 1 m x -> tracked 0 0 m 0 x x (Rabs x).
Proof. intros B. split; [exact B|]. exists x. split; [apply input_close|apply off_self]. Qed.
Lemma tracked_difference a b x m : sub M (Plain a) (Plain b) x -> small H 1 m x ->
  tracked 0 3074 m 1 x (a - b) (Rabs (a - b)).
Proof.
intros S B. split; [exact B|]. destruct (difference_close F H 1 1 G a b x _ S eq_refl) as (e & E & N).
exists ((a - b) * (1 + e)). split; [exact N|]. apply off_rounded; [apply off_self|exact E].
Qed.
Lemma tracked_abs k c m j x t T : tracked k c m j x t T -> tracked k c m j (Rabs x) (Rabs t) T.
Proof.
intros (B & x0 & C & O & L). split; [now apply abs_small|]. exists (Rabs x0). split; [now apply abs_close|].
split; [now rewrite Rabs_Rabsolu|]. apply Rle_trans with (2 := L), Rabs_triang_inv2.
Qed.
Lemma tracked_zero k : tracked k 0 0 0 0 0 0.
Proof.
split; [split; [lia|]|exists 0; split; [apply input_close|]].
- rewrite Rabs_R0. unfold q. lra.
- rewrite <- Rabs_R0 at 3. apply off_self.
Qed.
Lemma added_plain k c m j x t T : tracked k c m j x t T -> added k (c + 1024) m j (Plain x) t T.
Proof.
intros (B & x0 & C & O) x' U. split; [exact (read_small F H _ _ _ _ B U)|]. exists x0. split; [|exact O].
exact (read_close F H 1 1 G _ _ _ _ _ C U).
Qed.
Lemma added_product k1 c1 m1 i x s S k2 c2 m2 j y t T z : tracked k1 c1 m1 i x s S -> tracked k2 c2 m2 j y t T ->
  mul M x y z -> added (Datatypes.S (k1 + k2)) (c_product 1 1 c1 m1 c2 m2 + 1024) (m_product 1 1 m1 m2)
    (Datatypes.S (i + j)) (Product x y z) (s * t) (S * T).
Proof.
intros (B1 & x0 & C1 & O1) (B2 & y0 & C2 & O2) Z z' U.
pose proof (mul_small F H 1 1 G _ _ _ _ _ _ _ _ B1 B2 Z eq_refl) as B.
destruct (mul_close F H 1 1 G _ _ _ _ _ _ _ _ _ _ _ _ C1 B1 C2 B2 Z eq_refl) as (e & E & N).
destruct (use_product F H 1 1 G _ _ _ _ _ _ _ _ _ _ _ _ _ _ C1 B1 C2 B2 N E U eq_refl) as (e' & E' & _ & N').
split; [exact (use_product_small F H 1 1 G _ _ _ _ _ _ _ _ B1 B2 B U)|]. exists (x0 * y0 * (1 + e')).
split; [exact N'|]. now apply (off_mul u Hu i j).
Qed.

Section Sums.
Variables (k : nat) (p r : operand R) (z : R) (c1 m1 : Z) (i : nat) (s S : R) (c2 m2 : Z) (j : nat) (t T : R) (l : nat).
Hypothesis A1 : added k c1 m1 i p s S.
Hypothesis A2 : added k c2 m2 j r t T.
Hypothesis Hl : Nat.max i j = l.
Lemma sum_once : add M p r z -> rounded_once k (c_rounded 1 (c1 + c2)) l z (s + t) (S + T).
Proof.
intros (x' & y' & U1 & U2 & R). destruct (A1 _ U1) as (_ & x0 & C1 & O1), (A2 _ U2) as (_ & y0 & C2 & O2).
destruct (add_close F H 1 1 G _ _ _ _ _ _ _ _ _ _ _ C1 C2 R (Nat.max_id k) eq_refl) as (e & E & N).
exists (x0 + y0), e. split; [exact E|]. split; [exact N|]. now apply (off_sum u Hu i j).
Qed.
Lemma difference_once : sub M p r z -> rounded_once k (c_rounded 1 (c1 + c2)) l z (s - t) (S + T).
Proof.
intros (x' & y' & U1 & U2 & R). destruct (A1 _ U1) as (_ & x0 & C1 & O1), (A2 _ U2) as (_ & y0 & C2 & O2).
destruct (sub_close F H 1 1 G _ _ _ _ _ _ _ _ _ _ _ C1 C2 R (Nat.max_id k) eq_refl) as (e & E & N).
exists (x0 - y0), e. split; [exact E|]. split; [exact N|]. now apply (off_difference u Hu i j).
Qed.
Lemma tracked_once c x t' T' m : rounded_once k c l x t' T' -> small H (Datatypes.S k) m x ->
  tracked k c m (Datatypes.S l) x t' T'.
Proof.
intros (x0 & e & E & C & O) B. split; [exact B|]. exists (x0 * (1 + e)). split; [exact C|]. now apply off_rounded.
Qed.
Lemma tracked_sum : add M p r z ->
  tracked k (c_rounded 1 (c1 + c2)) (up 1025 (m1 + m2) + 1) (Datatypes.S l) z (s + t) (S + T).
Proof.
intros Z. apply tracked_once; [now apply sum_once|]. destruct Z as (x' & y' & U1 & U2 & R).
destruct (A1 _ U1) as [B1 _], (A2 _ U2) as [B2 _].
exact (add_small F H 1 1 G _ _ _ _ _ _ _ _ _ B1 B2 R (Nat.max_id k) eq_refl).
Qed.
Lemma tracked_sub : sub M p r z ->
  tracked k (c_rounded 1 (c1 + c2)) (up 1025 (m1 + m2) + 1) (Datatypes.S l) z (s - t) (S + T).
Proof.
intros Z. apply tracked_once; [now apply difference_once|]. destruct Z as (x' & y' & U1 & U2 & R).
destruct (A1 _ U1) as [B1 _], (A2 _ U2) as [B2 _].
exact (sub_small F H 1 1 G _ _ _ _ _ _ _ _ _ B1 B2 R (Nat.max_id k) eq_refl).
Qed.
End Sums.
Lemma sum_of k x y z c1 m1 i s S c2 m2 j t T : tracked k c1 m1 i x s S -> tracked k c2 m2 j y t T ->
  add M (Plain x) (Plain y) z -> tracked k (c_rounded 1 (c1 + 1024 + (c2 + 1024))) (up 1025 (m1 + m2) + 1)
    (Datatypes.S (Nat.max i j)) z (s + t) (S + T).
Proof.
intros A B Z. exact (tracked_sum _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ (added_plain _ _ _ _ _ _ _ A)
  (added_plain _ _ _ _ _ _ _ B) eq_refl Z).
Qed.

(* x is not negative, and (1 - u)^i t is left of t, but for c n H^k / 1024 *)
Definition least k c i x t := 0 <= x /\ exists x0, close F H k c x x0 /\ low u i x0 t.
Lemma least_input x : least 0 0 0 (Rabs x) (Rabs x).
Proof. split; [apply Rabs_pos|]. exists (Rabs x). split; [apply input_close|apply low_self, Rabs_pos]. Qed.
Lemma least_difference a b x : sub M (Plain a) (Plain b) x -> least 0 3074 1 (Rabs x) (Rabs (a - b)).
Proof.
intros S. split; [apply Rabs_pos|]. destruct (difference_close F H 1 1 G a b x _ S eq_refl) as (e & E & N).
exists (Rabs ((a - b) * (1 + e))). split; [now apply abs_close|now apply low_abs_rounded].
Qed.
Lemma least_sum k c1 i x s c2 j y t z : least k c1 i x s -> least k c2 j y t -> add M (Plain x) (Plain y) z ->
  least k (c_rounded 1 (c1 + 1024 + (c2 + 1024))) (S (Nat.max i j)) z (s + t).
Proof.
intros (X & x0 & C1 & L1) (Y & y0 & C2 & L2) Z. split; [exact (sum_nonneg F x y z X Y Z)|].
destruct Z as (x' & y' & U1 & U2 & R).
destruct (add_close F H 1 1 G _ _ _ _ _ _ _ _ _ _ _ (read_close F H 1 1 G _ _ _ _ _ C1 U1)
  (read_close F H 1 1 G _ _ _ _ _ C2 U2) R (Nat.max_id k) eq_refl) as (e & E & N).
exists ((x0 + y0) * (1 + e)). split; [exact N|]. now apply (low_add u Hu i j).
Qed.
Lemma least_more k c i j x t : (i <= j)%nat -> least k c i x t -> least k c j x t.
Proof. intros L (X & x0 & C & B). split; [exact X|]. exists x0. split; [exact C|]. now apply (low_more u Hu i). Qed.
Lemma product_nonneg x y z : 0 <= x -> 0 <= y -> mul M x y z -> 0 <= z.
Proof. intros X Y (x' & y' & [->|[-> _]] & [->|[-> _]] & _ & P & _); apply P; nra. Qed.
Lemma least_product k1 c1 m1 i x s k2 c2 m2 j y t z : least k1 c1 i x s -> small H (S k1) m1 x -> least k2 c2 j y t ->
  small H (S k2) m2 y -> mul M x y z -> least (S (k1 + k2)) (c_product 1 1 c1 m1 c2 m2) (S (i + j)) z (s * t).
Proof.
intros (X & x0 & C1 & L1) B1 (Y & y0 & C2 & L2) B2 Z. split; [exact (product_nonneg x y z X Y Z)|].
destruct (mul_close F H 1 1 G _ _ _ _ _ _ _ _ _ _ _ _ C1 B1 C2 B2 Z eq_refl) as (e & E & N).
exists (x0 * y0 * (1 + e)). split; [exact N|]. now apply (low_mul u Hu i j).
Qed.

(* an error bound with an absolute term of num n H^k *)
Definition bounding k num c i B t :=
  0 <= B /\ exists P e, Rabs e <= u /\ close F H k c B ((P + IZR num * (n * H ^ k)) * (1 + e)) /\ low u i P t.
Lemma bound k num C mC c i x t z A B : least k c i x t -> n <= C <= q mC -> mul M C x z ->
  A = IZR num * (n * H ^ k) -> (0 <= num)%Z -> add M (Product C x z) (Plain A) B ->
  bounding k num (c_rounded 1 (c_rounded 1 (up mC (c + 1024)) + 1024 + 1024)) (S i) B (C * t).
Proof.
intros (X & x0 & C1 & L) HC Z -> N0 S. pose proof (basics F H 1 1 G) as B0.
pose proof (pow_one F H 1 1 G k) as P1. apply IZR_le in N0.
assert (A0 : 0 <= IZR num * (n * H ^ k)) by (apply Rmult_le_pos; [lra|apply Rmult_le_pos; lra]).
pose proof (product_nonneg C x z ltac:(lra) X Z) as Z0.
destruct S as (z' & a' & U1 & U2 & R). split.
- destruct R as (_ & R & _). apply R. apply Rplus_le_le_0_compat; [|destruct U2 as [->|[-> _]]; lra].
  destruct U1 as [[->|[-> _]]|(c' & x' & [->|[-> _]] & [->|[-> _]] & ->)]; try lra; nra.
- destruct (times_close F H 1 1 G k c C mC x x0 z _ HC C1 Z eq_refl) as (e & E & _ & U).
  destruct (U z' _ U1 eq_refl) as (e1 & E1 & _ & N1).
  destruct (add_close F H 1 1 G _ _ _ _ _ _ _ _ _ _ _ N1 (read_close F H 1 1 G _ _ _ _ _ (input_close F H k _) U2) R
    (Nat.max_id k) eq_refl) as (e2 & E2 & N2).
  exists (C * x0 * (1 + e1)), e2. split; [exact E2|]. split; [exact N2|]. apply (low_times u Hu C i); auto; lra.
Qed.

Section Decided.
Variables (k : nat) (num cV : Z) (j : nat) (V t T : R) (cB : Z) (i : nat) (B X : R).
Hypothesis HV : rounded_once k cV j V t T.
Hypothesis HB : bounding k num cB i B X.
Hypothesis paid : (cV + cB + 1024 <= num * 1023)%Z.
Hypothesis enough : (1 + u) * ((1 + u) ^ j - 1) * T <= (1 - u) ^ S i * X.
Lemma sign_is_right s : greater M (Rabs V) B true -> greater M V 0 s -> (s = true -> t > 0) /\ (s = false -> t < 0).
Proof.
intros K Q. destruct HV as (x0 & e & E & C & O), HB as (_ & P & e' & E' & C' & L).
exact (certain_polynomial F H 1 1 G _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ C E C' E' L eq_refl paid K Q O enough).
Qed.
Lemma not_zero : greater M (Rabs V) B true -> t <> 0.
Proof.
intros K. destruct (Rlt_or_le 0 V) as [P|P].
- destruct (sign_is_right true K) as [Q _]; [|specialize (Q eq_refl); lra].
  exists V, 0. split; [now left|]. split; [now left|]. tauto.
- destruct (sign_is_right false K) as [_ Q]; [|specialize (Q eq_refl); lra].
  exists V, 0. split; [now left|]. split; [now left|]. split; [discriminate|lra].
Qed.
Lemma beyond_bound : greater M V B true -> t > 0.
Proof.
intros (V' & B' & RV & RB & [K _]). specialize (K eq_refl). destruct HB as [B0 _].
assert (V' = V) as -> by (destruct RV as [->|[-> _]]; [easy|destruct RB as [->|[-> _]]; lra]).
assert (P : V > 0) by (destruct RB as [->|[-> _]]; lra).
destruct (sign_is_right true) as [Q _]; [| |now apply Q].
- exists V, B'. rewrite Rabs_right by lra. split; [now left|]. split; [exact RB|]. tauto.
- exists V, 0. split; [now left|]. split; [now left|]. tauto.
Qed.
End Decided.
End Tracked.

(* no more than what is known of it *)
Ltac in_reach G := match goal with B : small _ 1 _ ?a |- small _ 1 _ ?a =>
  apply (small_more _ _ G _ _ _ _ B); vm_compute; discriminate end.
