(* SPDX-License-Identifier: Apache-2.0 *)
(* Ghost runs: what relative errors alone do to a value (off) and to a bound (low). *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Filters Require Import model steps.
Open Scope R_scope.

Section Ghost.
Variable u : R.
Hypothesis Hu : 0 < u <= 1/16.

(* x came of t by roundings: at least (1 - u)^j of it is left *)
Definition low j x t := 0 <= t /\ (1 - u) ^ j * t <= x.
(* x came of t, a polynomial of which T is the sum of the terms' magnitudes, by at most j roundings of each term *)
Definition off j x t T := Rabs t <= T /\ Rabs (x - t) <= ((1 + u) ^ j - 1) * T.

Lemma ratio e : Rabs e <= u -> 1 - u <= 1 + e <= 1 + u.
Proof. intros E%abs_le. lra. Qed.
Lemma rounding x e : Rabs e <= u -> Rabs (x * (1 + e) - x) <= u * Rabs x.
Proof.
intros E. replace (x * (1 + e) - x) with (e * x) by ring. rewrite Rabs_mult.
apply Rmult_le_compat_r; [apply Rabs_pos|exact E].
Qed.
Lemma near x y d : Rabs (x - y) <= d -> Rabs y - d <= Rabs x <= Rabs y + d.
Proof.
intros L. pose proof (Rabs_triang_inv x y). pose proof (Rabs_triang_inv y x). rewrite (Rabs_minus_sym y x) in *. lra.
Qed.
Lemma down j : 0 < (1 - u) ^ j <= 1.
Proof. split; [apply pow_lt; lra|]. induction j; simpl; [lra|]. assert (0 < (1 - u) ^ j) by (apply pow_lt; lra). nra.
  Qed.
Lemma down_more i j : (i <= j)%nat -> (1 - u) ^ j <= (1 - u) ^ i.
Proof.
intros L. replace j with (i + (j - i))%nat by lia. rewrite pow_add. pose proof (down i). pose proof (down (j - i)). nra.
Qed.
Lemma upward j : 1 <= (1 + u) ^ j.
Proof. apply pow_R1_Rle. lra. Qed.
Lemma upward_more i j : (i <= j)%nat -> (1 + u) ^ i <= (1 + u) ^ j.
Proof. intros. apply Rle_pow; [lra|assumption]. Qed.

Lemma low_self x : 0 <= x -> low 0 x x.
Proof. intros. split; simpl; lra. Qed.
Lemma low_pos j x t : low j x t -> 0 <= x.
Proof. intros [P L]. pose proof (down j). nra. Qed.
Lemma low_abs_rounded x e : Rabs e <= u -> low 1 (Rabs (x * (1 + e))) (Rabs x).
Proof.
intros E%ratio. split; [apply Rabs_pos|]. rewrite Rabs_mult, (Rabs_right (1 + e)), pow_1, Rmult_comm by lra.
apply Rmult_le_compat_l; [apply Rabs_pos|lra].
Qed.
Lemma low_sum_rounded x e : 0 <= x -> Rabs e <= u -> low 1 (x * (1 + e)) (Rabs x).
Proof.
intros P E%ratio. rewrite Rabs_right by lra. split; [exact P|]. rewrite pow_1, Rmult_comm.
apply Rmult_le_compat_l; lra.
Qed.
Lemma low_rounded j x t e : low j x t -> Rabs e <= u -> low (S j) (x * (1 + e)) t.
Proof.
intros L E%ratio. pose proof (low_pos _ _ _ L). destruct L as [P L]. split; [exact P|]. pose proof (down j).
rewrite <- tech_pow_Rmult, Rmult_assoc, Rmult_comm. apply Rmult_le_compat; try lra. apply Rmult_le_pos; lra.
Qed.
Lemma low_mul i j x y s t e k : low i x s -> low j y t -> Rabs e <= u -> S (i + j) = k -> low k (x * y * (1 + e)) (s *
  t).
Proof.
intros X Y E <-. apply low_rounded; [|exact E]. destruct X as [P L], Y as [Q K]. split; [now apply Rmult_le_pos|].
pose proof (down i). pose proof (down j). rewrite pow_add.
replace ((1 - u) ^ i * (1 - u) ^ j * (s * t)) with ((1 - u) ^ i * s * ((1 - u) ^ j * t)) by ring.
apply Rmult_le_compat; try assumption; apply Rmult_le_pos; lra.
Qed.
Lemma low_more i j x t : (i <= j)%nat -> low i x t -> low j x t.
Proof.
intros L [P K]. split; [exact P|]. apply Rle_trans with (2 := K). apply Rmult_le_compat_r; [exact P|now apply
  down_more].
Qed.
Lemma low_add i j x y s t e k : low i x s -> low j y t -> Rabs e <= u -> S (Nat.max i j) = k -> low k ((x + y) * (1 +
  e)) (s + t).
Proof.
intros X Y E <-. apply low_rounded; [|exact E]. apply low_more with (j := Nat.max i j) in X; [|lia].
apply low_more with (j := Nat.max i j) in Y; [|lia]. destruct X as [P L], Y as [Q K]. split; lra.
Qed.
(* C x: the last product of a bound *)
Lemma low_times C i x t e k : 0 <= C -> low i x t -> Rabs e <= u -> S i = k -> low k (C * x * (1 + e)) (C * t).
Proof. intros P X E <-. apply (low_mul 0 i C x C t e); auto. now apply low_self. Qed.

Lemma off_self x : off 0 x x (Rabs x).
Proof. split; [lra|]. rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. simpl. lra. Qed.
Lemma off_size j x t T : off j x t T -> 0 <= T /\ Rabs x <= (1 + u) ^ j * T.
Proof.
intros [A B]. pose proof (Rabs_pos t). split; [lra|]. replace x with (t + (x - t)) by ring.
apply Rle_trans with (1 := Rabs_triang _ _). lra.
Qed.
Lemma off_by j k x t T : (1 + u) ^ j - 1 <= k -> off j x t T -> 0 <= T /\ Rabs t <= T /\ Rabs (x - t) <= k * T.
Proof.
intros L [A B]. assert (P : 0 <= T) by (apply Rle_trans with (2 := A), Rabs_pos).
repeat split; [exact P|exact A|]. apply Rle_trans with (1 := B). now apply Rmult_le_compat_r.
Qed.
Lemma off_rounded j x t T e : off j x t T -> Rabs e <= u -> off (S j) (x * (1 + e)) t T.
Proof.
intros O E. destruct (off_size _ _ _ _ O) as [P S]. destruct O as [A B]. split; [exact A|].
replace (x * (1 + e) - t) with (x - t + x * e) by ring. apply Rle_trans with (1 := Rabs_triang _ _).
pose proof (mul_le _ _ _ _ S E). simpl. lra.
Qed.
Lemma off_more i j x t T : (i <= j)%nat -> off i x t T -> off j x t T.
Proof.
intros L O. destruct (off_size _ _ _ _ O) as [P _]. destruct O as [A B]. split; [exact A|]. apply Rle_trans with (1 :=
  B).
apply Rmult_le_compat_r; [exact P|]. pose proof (upward_more _ _ L). lra.
Qed.
Lemma off_mul i j x y s t S T e k : off i x s S -> off j y t T -> Rabs e <= u -> Datatypes.S (i + j) = k ->
  off k (x * y * (1 + e)) (s * t) (S * T).
Proof.
intros X Y E <-. apply off_rounded; [|exact E]. destruct (off_size _ _ _ _ X) as [P SX]. destruct (off_size _ _ _ _ Y)
  as [Q SY].
destruct X as [A B], Y as [C D]. split; [now apply mul_le|].
replace (x * y - s * t) with ((x - s) * y + s * (y - t)) by ring. apply Rle_trans with (1 := Rabs_triang _ _).
pose proof (mul_le _ _ _ _ B SY). pose proof (mul_le _ _ _ _ A D). rewrite pow_add.
pose proof (upward i). pose proof (upward j). lra.
Qed.
Lemma off_sum i j x y s t S T k : off i x s S -> off j y t T -> Nat.max i j = k -> off k (x + y) (s + t) (S + T).
Proof.
intros X Y <-. apply off_more with (j := Nat.max i j) in X; [|lia]. apply off_more with (j := Nat.max i j) in Y; [|lia].
destruct X as [A B], Y as [C D]. apply abs_le in A, B, C, D. split; apply le_abs; lra.
Qed.
Lemma off_difference i j x y s t S T k : off i x s S -> off j y t T -> Nat.max i j = k -> off k (x - y) (s - t) (S + T).
Proof.
intros X [C D] K. unfold Rminus. apply (off_sum i j); auto. split; [now rewrite Rabs_Ropp|].
replace (- y - - t) with (- (y - t)) by ring. now rewrite Rabs_Ropp.
Qed.
Lemma off_add i j x y s t S T e k : off i x s S -> off j y t T -> Rabs e <= u -> Datatypes.S (Nat.max i j) = k ->
  off k ((x + y) * (1 + e)) (s + t) (S + T).
Proof. intros X Y E <-. apply off_rounded; [|exact E]. now apply (off_sum i j). Qed.
Lemma off_sub i j x y s t S T e k : off i x s S -> off j y t T -> Rabs e <= u -> Datatypes.S (Nat.max i j) = k ->
  off k ((x - y) * (1 + e)) (s - t) (S + T).
Proof. intros X Y E <-. apply off_rounded; [|exact E]. now apply (off_difference i j). Qed.

(* rule (4): the last operation cannot make a sign wrong *)
Lemma decided j D e t T X : off j D t T -> Rabs e <= u -> (1 + u) * ((1 + u) ^ j - 1) * T <= X ->
  (D * (1 + e) > X -> t > 0) /\ (D * (1 + e) < - X -> t < 0).
Proof.
intros O E%ratio L. destruct (off_size _ _ _ _ O) as [P _]. destruct O as [_ B]. apply abs_le in B.
pose proof (upward j). set (K := ((1 + u) ^ j - 1) * T) in *.
assert (K0 : 0 <= K) by (apply Rmult_le_pos; lra). replace ((1 + u) * ((1 + u) ^ j - 1) * T) with ((1 + u) * K) in L
  by (unfold K; ring).
split; intros S; [apply Rnot_le_lt|apply Rnot_lt_le in S || apply Rnot_le_lt]; intros N.
- destruct (Rle_or_lt D 0); nra.
- destruct (Rle_or_lt 0 D); nra.
Qed.

Lemma beyond D e K X : Rabs e <= u -> 0 <= K -> (1 + u) * K <= X ->
  (D * (1 + e) > X -> D > K) /\ (D * (1 + e) < - X -> D < - K).
Proof.
intros E%ratio K0 L. split; intros S; apply Rnot_le_lt; intros N.
- destruct (Rle_or_lt D 0); nra.
- destruct (Rle_or_lt 0 D); nra.
Qed.

(* the same in units of a product of extents *)
Lemma beyond_extents V e K C X Y m : Rabs e <= u -> 0 <= K -> 0 <= X -> 0 <= Y -> (1 + u) * K <= (1 - u) ^ m * C ->
  (V * (1 + e) > (1 - u) ^ m * (C * X * Y) -> V > K * (X * Y)) /\
  (V * (1 + e) < - ((1 - u) ^ m * (C * X * Y)) -> V < - (K * (X * Y))).
Proof.
intros E K0 PX PY L. assert (P : 0 <= X * Y) by (now apply Rmult_le_pos).
apply beyond; [exact E|now apply Rmult_le_pos|].
apply Rle_trans with ((1 + u) * K * (X * Y)); [right; ring|].
apply Rle_trans with ((1 - u) ^ m * C * (X * Y)); [now apply Rmult_le_compat_r|right; ring].
Qed.

(* rule (5): of (1 - u)^m C and (1 + u) ((1 + u)^j - 1) *)
Lemma power k : 0 < u ^ S k <= u ^ k / 16.
Proof. assert (0 < u ^ k) by (apply pow_lt; lra). simpl. split; nra. Qed.
Lemma bernoulli_down m : 1 - INR m * u <= (1 - u) ^ m.
Proof.
induction m as [|m IH]; [simpl; lra|]. rewrite S_INR, <- tech_pow_Rmult. pose proof (pos_INR m).
apply Rle_trans with ((1 - u) * (1 - INR m * u)); [|apply Rmult_le_compat_l; lra]. nra.
Qed.
Lemma bernoulli_up j : INR j * u <= 1 -> (1 + u) ^ j <= 1 + INR j * u + (INR j * u) ^ 2.
Proof.
induction j as [|j IH]; [simpl; lra|]. rewrite S_INR. intros L. pose proof (pos_INR j) as P.
assert (L' : INR j * u <= 1) by lra. specialize (IH L'). rewrite <- tech_pow_Rmult.
apply Rle_trans with ((1 + u) * (1 + INR j * u + (INR j * u) ^ 2)); [apply Rmult_le_compat_l; lra|].
set (J := INR j) in *. assert (0 <= u ^ 2) by (apply pow2_ge_0). assert (J * u * (J * u ^ 2) <= 1 * (J * u ^ 2)) by
  (apply Rmult_le_compat_r; nra).
nra.
Qed.
(* enough for every u that is not large: c = 2 j, and d u pays for the rest *)
Lemma enough (j m d : nat) : INR j * u <= 1 -> INR d - INR m * INR j - INR j ^ 2 - INR j >= (INR d * INR m + INR j ^
  2) * u ->
  (1 + u) * ((1 + u) ^ j - 1) <= (1 - u) ^ m * (INR j * u + INR d * u * u).
Proof.
intros L E. pose proof (bernoulli_up j L). pose proof (bernoulli_down m). pose proof (pos_INR j). pose proof (pos_INR
  m). pose proof (pos_INR d).
set (J := INR j) in *. set (D := INR d) in *. set (N := INR m) in *.
apply Rle_trans with ((1 + u) * (J * u + (J * u) ^ 2)); [apply Rmult_le_compat_l; lra|].
apply Rle_trans with ((1 - N * u) * (J * u + D * u * u)).
- assert (0 <= u * u) by nra. assert (0 <= (D - N * J - J ^ 2 - J - (D * N + J ^ 2) * u) * (u * u)) by (apply
  Rmult_le_pos; lra). nra.
- apply Rmult_le_compat_r; [nra|lra].
Qed.
End Ghost.

(* u^(k+1) <= u^k / 16: with these, inequalities between polynomials in u are linear *)
Ltac powers u Hu :=
  pose proof (power u Hu 1); pose proof (power u Hu 2); pose proof (power u Hu 3); pose proof (power u Hu 4);
  pose proof (power u Hu 5); pose proof (power u Hu 6); pose proof (power u Hu 7); pose proof (power u Hu 8);
  pose proof (power u Hu 9); pose proof (power u Hu 10); pose proof (power u Hu 11); pose proof (power u Hu 12).

Section Certain.
Variables (F : format) (H : R) (w v : Z).
Hypothesis G : fits F H w v.
Notation u := (u F). Notation n := (n F). Notation M := (reals F).

Lemma fits_u : 0 < u <= 1/16.
Proof. pose proof (basics F H w v G). lra. Qed.

(* A value and a bound whose ghosts are V0 and (P + A) (1 + e), A = num n H^k: where the filter answers, V0 is beyond
   what is left of P, for A pays for what both runs are off. *)
Theorem certain_ghost k cV cB V V0 B P A e s i T num : close F H k cV V V0 -> close F H k cB B ((P + A) * (1 + e)) ->
  Rabs e <= u -> low u i P T -> A = IZR num * (n * H ^ k) -> (cV + cB + 1024 <= num * (1024 - w))%Z ->
  greater M (Rabs V) B true -> greater M V 0 s ->
  (s = true -> V0 > (1 - u) ^ S i * T) /\ (s = false -> V0 < - ((1 - u) ^ S i * T)).
Proof.
intros CV CB E L EA N K S. pose proof fits_u as Hu. pose proof (basics F H w v G) as B0.
pose proof (down u Hu i) as Di. destruct L as [T0 L]. apply (ratio u) in E. pose proof (n_pow F H w v G k) as NP.
assert (num0 : (0 <= num)%Z). { destruct CV as [? _], CB as [? _]. pose proof (w_high _ _ _ _ G). nia. }
apply IZR_le in num0.
apply (certain F H w v G k (num * (1024 - w)) cV cB V V0 B ((P + A) * (1 + e)) ((1 - u) ^ Datatypes.S i * T) s); auto.
- assert (X : (1 - u) ^ Datatypes.S i * T <= P * (1 + e)).
  { rewrite <- tech_pow_Rmult, Rmult_assoc, Rmult_comm. apply Rmult_le_compat; try lra. apply Rmult_le_pos; lra. }
  assert (Y : q (num * (1024 - w)) * (n * H ^ k) <= A * (1 + e)).
  { rewrite EA. set (N0 := n * H ^ k) in *. unfold q. rewrite mult_IZR, minus_IZR.
    replace (IZR num * (1024 - IZR w) / 1024 * N0) with (IZR num * N0 * (1 - q w)) by (unfold q; lra).
    apply Rmult_le_compat_l; [apply Rmult_le_pos; lra|lra]. }
  lra.
- apply Rmult_le_pos; [apply pow_le; lra|exact T0].
Qed.

(* The same for a polynomial whose terms' roundings are taken for independent: its sign is the exact one. *)
Theorem certain_polynomial k cV cB V D e' B P A e s i T num j t TT : close F H k cV V (D * (1 + e')) -> Rabs e' <= u ->
  close F H k cB B ((P + A) * (1 + e)) -> Rabs e <= u -> low u i P T -> A = IZR num * (n * H ^ k) ->
  (cV + cB + 1024 <= num * (1024 - w))%Z -> greater M (Rabs V) B true -> greater M V 0 s ->
  off u j D t TT -> (1 + u) * ((1 + u) ^ j - 1) * TT <= (1 - u) ^ S i * T ->
  (s = true -> t > 0) /\ (s = false -> t < 0).
Proof.
intros CV E' CB E L EA N K S O C. destruct (certain_ghost _ _ _ _ _ _ _ _ _ _ _ _ _ CV CB E L EA N K S) as [X Y].
destruct (decided u fits_u _ _ _ _ _ _ O E' C). split; auto.
Qed.
End Certain.

Lemma power_fine u k : 0 < u <= 1/1024 -> 0 < u ^ S k <= u ^ k / 1024.
Proof. intros Hu. assert (0 < u ^ k) by (apply pow_lt; lra). simpl. split; nra. Qed.
Ltac fine_powers u Hu :=
  pose proof (power_fine u 1 Hu); pose proof (power_fine u 2 Hu); pose proof (power_fine u 3 Hu);
  pose proof (power_fine u 4 Hu); pose proof (power_fine u 5 Hu); pose proof (power_fine u 6 Hu);
  pose proof (power_fine u 7 Hu); pose proof (power_fine u 8 Hu); pose proof (power_fine u 9 Hu).

(* the ghost of a bound, from below: in units of the exact differences, or (here) of the computed ones *)
Ltac lows_here Hu := match goal with
  | L : low _ _ ?x _ |- low _ _ ?x _ => exact L
  | |- low _ _ ((?x + ?y) * (1 + ?e)) _ => eapply low_add; [exact Hu| | |eassumption|reflexivity]; lows_here Hu
  | |- low _ _ (?x * ?y * (1 + ?e)) _ => eapply low_mul; [exact Hu| | |eassumption|reflexivity]; lows_here Hu
  | |- low _ _ (Rabs ?x) _ => apply low_self; apply Rabs_pos
  | |- low _ _ ?x _ => apply low_self; lra
  end.
Ltac lows Hu := match goal with
  | |- low _ _ ((?x + ?y) * (1 + ?e)) _ => is_var x; is_var y; apply low_sum_rounded; [lra|eassumption]
  | |- low _ _ ((?x + ?y) * (1 + ?e)) _ => eapply low_add; [exact Hu| | |eassumption|reflexivity]; lows Hu
  | |- low _ _ (?x * ?y * (1 + ?e)) _ => eapply low_mul; [exact Hu| | |eassumption|reflexivity]; lows Hu
  | |- low _ _ (Rabs (?x * (1 + ?e))) _ => apply low_abs_rounded; [exact Hu|eassumption]
  | |- low _ _ (Rabs ?x) _ => apply low_self; apply Rabs_pos
  | |- low _ _ ?x _ => apply low_self; lra
  end.
Ltac offs Hu := match goal with
  | |- off _ _ ((?x - ?y) * (1 + ?e)) _ _ => is_var x; is_var y; apply off_rounded; [apply off_self|assumption]
  | |- off _ _ ((?x + ?y) * (1 + ?e)) _ _ => is_var x; is_var y; apply off_rounded; [apply off_self|assumption]
  | |- off _ _ ((?x + ?y) * (1 + ?e)) _ _ => eapply off_add; [exact Hu| | |eassumption|reflexivity]; offs Hu
  | |- off _ _ ((?x - ?y) * (1 + ?e)) _ _ => eapply off_sub; [exact Hu| | |eassumption|reflexivity]; offs Hu
  | |- off _ _ (?x * ?y * (1 + ?e)) _ _ => eapply off_mul; [exact Hu| | |eassumption|reflexivity]; offs Hu
  | |- off _ _ (?x * (1 + ?e)) _ _ => eapply off_rounded; [|eassumption]; offs Hu
  | |- off _ _ ?x _ _ => apply off_self
  end.
Ltac offs_last Hu := match goal with
  | |- off _ _ (?x + ?y) _ _ => eapply off_sum; [exact Hu| | |reflexivity]; offs Hu
  | |- off _ _ (?x - ?y) _ _ => eapply off_difference; [exact Hu| | |reflexivity]; offs Hu end.
