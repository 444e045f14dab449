(* SPDX-License-Identifier: Apache-2.0 *)
(* What roundings and underflow add up to in a lane, and when the sign of a value is certain. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model constants steps format floats ghost lanes.
Open Scope R_scope.
#[local] Existing Instances p53 fexp_valid below_1024.

Lemma v_small : 0 < v <= 1/16. Proof. rewrite v_is. lra. Qed.
Notation tiny := (bpow radix2 (-1000)).
Notation spare := (bpow radix2 (-1010)).

(* x stands for t, a sum of terms whose magnitudes add up to T at most: j roundings, and A for underflow. *)
Definition est j A x t T := exists x', off v j x' t T /\ Rabs (x - x') <= A.
(* x is at least T with j roundings, less A for underflow. *)
Definition least_of j A x T := exists x', low v j x' T /\ x' - A <= x.

Lemma est_held a : est 0 0 a a (Rabs a).
Proof. exists a. split; [apply off_self|]. rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. lra. Qed.
Lemma est_exact j x t T : off v j x t T -> est j 0 x t T.
Proof. intros O. exists x. split; [exact O|]. rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. lra. Qed.
Lemma exact_est j x t T : est j 0 x t T -> off v j x t T.
Proof.
intros (x' & O & L). assert (x = x') as ->; [|exact O]. apply Rminus_diag_uniq.
destruct (Req_dec (x - x') 0) as [E|N]; [exact E|]. apply Rabs_pos_lt in N. lra.
Qed.
Lemma est_nonneg j A x t T : est j A x t T -> 0 <= A.
Proof. intros (x' & _ & L). pose proof (Rabs_pos (x - x')). lra. Qed.
Lemma est_minus_held a b : held a -> held b -> est 1 0 (rnd (a - b)) (a - b) (Rabs (a - b)).
Proof.
intros A B. destruct (rnd_difference a b A B) as (e & E & ->). apply est_exact.
apply off_rounded; auto using v_small. apply off_self.
Qed.
Lemma est_plus_held a b : held a -> held b -> est 1 0 (rnd (a + b)) (a + b) (Rabs (a + b)).
Proof.
intros A B. destruct (rnd_sum a b A B) as (e & E & ->). apply est_exact.
apply off_rounded; auto using v_small. apply off_self.
Qed.
Lemma est_more i j A B x t T : (i <= j)%nat -> A <= B -> est i A x t T -> est j B x t T.
Proof. intros I L (x' & O & D). exists x'. split; [apply (off_more v v_small i j); auto|lra]. Qed.
Lemma est_times i j x y s t S T : est i 0 x s S -> est j 0 y t T ->
  est (Datatypes.S (i + j)) eta (rnd (x * y)) (s * t) (S * T).
Proof.
intros X%exact_est Y%exact_est. destruct (rnd_any (x * y)) as (e & h & E & H & ->). exists (x * y * (1 + e)). split.
- now apply (off_mul v v_small i j).
- now replace (x * y * (1 + e) + h - x * y * (1 + e)) with h by ring.
Qed.
Lemma est_sum i j A B x y s t S T : est i A x s S -> est j B y t T ->
  est (Nat.max i j) (A + B) (x + y) (s + t) (S + T).
Proof.
intros (x' & X & P) (y' & Y & Q). exists (x' + y'). split; [now apply (off_sum v v_small i j)|].
replace (x + y - (x' + y')) with ((x - x') + (y - y')) by ring. pose proof (Rabs_triang (x - x') (y - y')). lra.
Qed.
Lemma est_difference i j A B x y s t S T : est i A x s S -> est j B y t T ->
  est (Nat.max i j) (A + B) (x - y) (s - t) (S + T).
Proof.
intros (x' & X & P) (y' & Y & Q). exists (x' - y'). split; [now apply (off_difference v v_small i j)|].
replace (x - y - (x' - y')) with ((x - x') + - (y - y')) by ring.
pose proof (Rabs_triang (x - x') (- (y - y'))). rewrite Rabs_Ropp in *. lra.
Qed.
Lemma est_rounded j A x t T e : est j A x t T -> Rabs e <= v -> est (S j) (2 * A) (x * (1 + e)) t T.
Proof.
intros (x' & O & L) E. exists (x' * (1 + e)). split; [now apply off_rounded; auto using v_small|].
replace (x * (1 + e) - x' * (1 + e)) with ((x - x') * (1 + e)) by ring. rewrite Rabs_mult.
pose proof v_small. apply abs_le in E. rewrite (Rabs_right (1 + e)) by lra. pose proof (Rabs_pos (x - x')). nra.
Qed.
Lemma est_plus i j A B x y s t S T : held x -> held y -> est i A x s S -> est j B y t T ->
  est (Datatypes.S (Nat.max i j)) (2 * (A + B)) (rnd (x + y)) (s + t) (S + T).
Proof. intros HX HY X Y. destruct (rnd_sum x y HX HY) as (e & E & ->). apply est_rounded; [now apply est_sum|exact
  E]. Qed.
Lemma est_minus i j A B x y s t S T : held x -> held y -> est i A x s S -> est j B y t T ->
  est (Datatypes.S (Nat.max i j)) (2 * (A + B)) (rnd (x - y)) (s - t) (S + T).
Proof.
intros HX HY X Y. destruct (rnd_difference x y HX HY) as (e & E & ->). apply est_rounded; [|exact E].
now apply est_difference.
Qed.
Lemma est_abs j A x t T : est j A x t T -> est j A (Rabs x) (Rabs t) T.
Proof.
intros (x' & [P Q] & L). exists (Rabs x'). split.
- split; [now rewrite Rabs_Rabsolu|]. apply Rle_trans with (2 := Q). apply Rabs_triang_inv2.
- apply Rle_trans with (2 := L). apply Rabs_triang_inv2.
Qed.
(* a product and a sum, rounded once or twice *)
Lemma est_multiply_add i j k A x y z r s t w S T W : held z ->
  est i 0 x s S -> est j 0 y t T -> est k A z w W ->
  r = rnd (x * y + z) \/ r = rnd (rnd (x * y) + z) ->
  est (Datatypes.S (Nat.max (Datatypes.S (i + j)) k)) (4 * (eta + A)) r (s * t + w) (S * T + W).
Proof.
intros HZ X Y Z R. pose proof (est_nonneg _ _ _ _ _ Z). pose proof eta_pos. destruct R as [->| ->].
- destruct (rnd_any (x * y + z)) as (e & h & E & HH & ->).
  assert (O : off v (i + j) (x * y) (s * t) (S * T)).
  { apply exact_est in X, Y. destruct (off_size v _ _ _ _ X) as [PX SX].
    destruct (off_size v _ _ _ _ Y) as [PY SY]. destruct X as [XA XB], Y as [YA YB].
    split; [rewrite Rabs_mult; apply Rmult_le_compat; auto using Rabs_pos|].
    replace (x * y - s * t) with ((x - s) * y + s * (y - t)) by ring. apply Rle_trans with (1 := Rabs_triang _ _).
    rewrite !Rabs_mult, pow_add. pose proof (upward v v_small i). pose proof (upward v v_small j).
    assert (Rabs (x - s) * Rabs y <= (((1 + v) ^ i - 1) * S) * ((1 + v) ^ j * T))
      by (apply Rmult_le_compat; auto using Rabs_pos).
    assert (Rabs s * Rabs (y - t) <= S * (((1 + v) ^ j - 1) * T)) by (apply Rmult_le_compat; auto using Rabs_pos).
    lra. }
  apply est_exact in O. assert (M : est (Nat.max (Datatypes.S (i + j)) k) A (x * y + z) (s * t + w) (S * T + W)).
  { apply est_more with (i := Nat.max (i + j) k) (A := 0 + A); [lia|lra|]. now apply est_sum. }
  apply est_rounded with (2 := E) in M. destruct M as (x' & O' & L). exists x'. split; [exact O'|].
  replace ((x * y + z) * (1 + e) + h - x') with ((x * y + z) * (1 + e) - x' + h) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _). lra.
- apply est_more with (i := Datatypes.S (Nat.max (Datatypes.S (i + j)) k)) (A := 2 * (eta + A)); [lia|lra|].
  apply est_plus; auto using held_rnd. now apply est_times.
Qed.
Lemma est_absorb j A x t T theta : (1 <= j)%nat -> A <= v * theta -> est j A x t T -> est j 0 x t (T + theta).
Proof.
intros J L E. pose proof (est_nonneg _ _ _ _ _ E) as P. destruct E as (x' & [O1 O2] & D). pose proof v_small.
assert (0 <= theta) by nra. apply est_exact. split; [lra|]. replace (x - t) with (x - x' + (x' - t)) by ring.
apply Rle_trans with (1 := Rabs_triang _ _). assert (v <= (1 + v) ^ j - 1).
{ pose proof (upward_more v v_small 1 j J). simpl in *. lra. }
assert (v * theta <= ((1 + v) ^ j - 1) * theta) by (apply Rmult_le_compat_r; lra). lra.
Qed.

Lemma least_held a : least_of 0 0 (Rabs a) (Rabs a).
Proof. exists (Rabs a). split; [apply low_self; auto using v_small, Rabs_pos|lra]. Qed.
Lemma least_pos a : 0 <= a -> least_of 0 0 a a.
Proof. exists a. split; [apply low_self; auto using v_small|lra]. Qed.
Lemma least_more i j A B x T : (i <= j)%nat -> A <= B -> least_of i A x T -> least_of j B x T.
Proof. intros I L (x' & O & D). exists x'. split; [apply (low_more v v_small i j); auto|lra]. Qed.
Lemma least_abs_difference a b : held a -> held b -> least_of 1 0 (Rabs (rnd (a - b))) (Rabs (a - b)).
Proof.
intros A B. destruct (rnd_difference a b A B) as (e & E & ->). exists (Rabs ((a - b) * (1 + e))).
split; [|lra]. now apply low_abs_rounded; auto using v_small.
Qed.
Lemma least_sum_held a b : held a -> held b -> 0 <= a + b -> least_of 1 0 (rnd (a + b)) (a + b).
Proof.
intros A B P. destruct (rnd_sum a b A B) as (e & E & ->). exists ((a + b) * (1 + e)). split; [|lra].
rewrite <- (Rabs_right (a + b)) at 2 by lra. now apply low_sum_rounded; auto using v_small.
Qed.
Lemma exact_least j x T : least_of j 0 x T -> low v j x T.
Proof. intros (x' & [P L] & D). split; lra. Qed.
Lemma least_times i j x y S T : least_of i 0 x S -> least_of j 0 y T ->
  least_of (Datatypes.S (i + j)) eta (rnd (x * y)) (S * T).
Proof.
intros X%exact_least Y%exact_least. destruct (rnd_any (x * y)) as (e & h & E & H & ->). exists (x * y * (1 + e)).
  split.
- now apply (low_mul v v_small i j).
- apply abs_le in H. lra.
Qed.
Lemma least_abs_times i j x y S T : least_of i 0 (Rabs x) S -> least_of j 0 (Rabs y) T ->
  least_of (Datatypes.S (i + j)) eta (Rabs (rnd (x * y))) (S * T).
Proof. intros X Y. rewrite rnd_abs, Rabs_mult. now apply least_times. Qed.
Lemma least_plus i j A B x y S T : held x -> held y -> 0 <= A -> 0 <= B -> 0 <= x -> 0 <= y ->
  least_of i A x S -> least_of j B y T ->
  least_of (Datatypes.S (Nat.max i j)) (2 * (A + B)) (rnd (x + y)) (S + T).
Proof.
intros HX HY PA PB PX PY (x' & X & LX) (y' & Y & LY). destruct (rnd_sum x y HX HY) as (e & E & ->).
exists ((x' + y') * (1 + e)). split; [now apply (low_add v v_small i j)|].
apply abs_le in E. pose proof v_small. nra.
Qed.

(* What the bound of by_sign says of a value, infinite or not. *)
Definition bound fused c m := multiply_add fused m (number 1 c) (number 1 (-1000)).
Lemma bound_says fused c m (z : float) : above (size z) (bound fused c m) = true -> up m -> (-60 <= c <= 0)%Z ->
  finite m /\ finite (bound fused c m) /\
  (1 - 3 * v) * (bpow radix2 c * value m) + bpow radix2 (-1001) <= value (bound fused c m).
Proof.
intros A U K. assert (UB : up (bound fused c m)).
{ apply up_multiply_add; [exact U|apply up_number; lia|apply up_number; lia]. }
pose proof (above_bound _ _ A UB) as F. assert (F' := F). unfold bound in F'.
apply multiply_add_finite in F' as (M & _ & _ & E). split; [exact M|]. split; [exact F|].
apply up_value in U. destruct (number_value 1 c) as [_ V1]; [lia|lia|].
destruct (number_value 1 (-1000)) as [_ V2]; [lia|lia|]. fold (bound fused c m) in E. rewrite V1, V2, !Rmult_1_l in E.
set (x := value m) in *. set (C := bpow radix2 c) in *. assert (P : 0 < C) by apply bpow_gt_0.
pose proof v_small. pose proof eta_pos. assert (T : tiny = 2 * bpow radix2 (-1001)).
{ change 2 with (bpow radix2 1). rewrite <- bpow_plus. reflexivity. }
assert (L : eta <= bpow radix2 (-1001) / 16).
{ unfold eta. pose proof (bpow_gt_0 radix2 (-1074)).
  assert (bpow radix2 (-1074) <= bpow radix2 (-1005)) by (apply bpow_le; lia).
  replace (bpow radix2 (-1001)) with (16 * bpow radix2 (-1005)); [lra|]. change 16 with (bpow radix2 4).
  rewrite <- bpow_plus. reflexivity. }
pose proof (bpow_gt_0 radix2 (-1001)) as PT. set (d := bpow radix2 (-1001)) in *.
assert (CX : 0 <= C * x) by nra. rewrite (Rmult_comm x C) in E. rewrite T in E. set (y := C * x) in *.
destruct E as [->| ->].
- destruct (rnd_any (y + 2 * d)) as (e & h & B1 & B2 & ->). apply abs_le in B1, B2.
  assert ((y + 2 * d) * (1 - v) <= (y + 2 * d) * (1 + e)) by (apply Rmult_le_compat_l; lra).
  assert (0 <= v * y) by (apply Rmult_le_pos; lra). assert (v * d <= 1 / 16 * d) by (apply Rmult_le_compat_r; lra).
    lra.
- destruct (rnd_any y) as (e & h & B1 & B2 & Q). pose proof (rnd_pos y CX). rewrite Q in *.
  apply abs_le in B1, B2. assert (Y : y * (1 - v) - eta <= y * (1 + e) + h).
  { assert (y * (1 - v) <= y * (1 + e)) by (apply Rmult_le_compat_l; lra). lra. }
  set (y' := y * (1 + e) + h) in *. clearbody y'. destruct (rnd_any (y' + 2 * d)) as (e' & h' & B3 & B4 & ->).
  apply abs_le in B3, B4.
  assert ((y' + 2 * d) * (1 - v) <= (y' + 2 * d) * (1 + e')) by (apply Rmult_le_compat_l; lra).
  assert ((y * (1 - v) - eta + 2 * d) * (1 - v) <= (y' + 2 * d) * (1 - v)) by (apply Rmult_le_compat_r; lra).
  assert (0 <= v * v * y) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra).
  assert (0 <= v * y) by (apply Rmult_le_pos; lra). assert (v * d <= 1 / 16 * d) by (apply Rmult_le_compat_r; lra).
  assert (0 <= v * eta) by (apply Rmult_le_pos; lra). lra.
Qed.

Lemma below_high (x : float) : Rabs (value x) < high. Proof. apply abs_B2R_lt_emax. Qed.
(* A difference or a sum that exceeds a bound, whatever overflows last. *)
Lemma sure r (z b : float) : 0 <= value b -> finite b -> above (size z) b = true ->
  (exists e, Rabs e <= v /\ rnd r = r * (1 + e)) ->
  (value z = rnd r /\ finite z /\ (r < 0 -> Bsign z = true) /\ (0 < r -> Bsign z = false)) \/
  (high <= Rabs (rnd r) /\ exists s, z = B754_infinity s /\ (s = true -> r <= 0) /\ (s = false -> 0 <= r)) ->
  (negative_lane z = true -> value b < - r * (1 + v)) /\ (negative_lane z = false -> value b < r * (1 + v)).
Proof.
intros P F A (e & E & R) [(V & Z & N1 & N2)|(L & s & -> & S1 & S2)]; apply abs_le in E; pose proof v_small;
  unfold negative_lane.
- apply above_true in A as [[_ A]|A]; [|destruct z; discriminate|exact F]. assert (S : value (size z) = Rabs (value
  z)) by apply B2R_Babs.
  rewrite S, V, R in A.
  destruct (Rtotal_order r 0) as [Q|[Q|Q]].
  + rewrite N1 by exact Q. split; [intros _|discriminate]. rewrite Rabs_left1 in A by nra. nra.
  + subst r. rewrite Rmult_0_l, Rabs_R0 in A. lra.
  + rewrite N2 by exact Q. split; [discriminate|intros _]. rewrite Rabs_right in A by nra. nra.
- rewrite R in L. pose proof (below_high b) as B. rewrite Rabs_right in B by lra. simpl. destruct s.
  + split; [intros _|discriminate]. specialize (S1 eq_refl). rewrite Rabs_left1 in L by nra. nra.
  + split; [discriminate|intros _]. specialize (S2 eq_refl). rewrite Rabs_right in L by nra. nra.
Qed.
Lemma sure_minus x y b : finite x -> finite y -> 0 <= value b -> finite b -> above (size (minus x y)) b = true ->
  let r := value x - value y in
  (negative_lane (minus x y) = true -> value b < - r * (1 + v)) /\
  (negative_lane (minus x y) = false -> value b < r * (1 + v)).
Proof.
intros X Y P F A r. apply (sure r (minus x y) b P F A); [apply rnd_difference; apply held_value|]. unfold minus.
cases_of (Bminus_correct 53 1024 _ _ mode_NE x y X Y); fold r; fold (rnd r) in *.
- intros (V & Z & S). left. split; [exact V|]. split; [exact Z|]. rewrite S.
  split; intros Q; [now rewrite Rcompare_Lt|now rewrite Rcompare_Gt].
- intros [E%not_finite_overflow S]. right. split; [exact L|]. exists (Bsign x). split; [exact E|].
  destruct (sign_value x), (sign_value y). unfold r. rewrite S in *. destruct (Bsign y); simpl in *;
  split; intros; try discriminate; intuition lra.
Qed.
Lemma sure_plus x y b : finite x -> finite y -> 0 <= value b -> finite b -> above (size (plus x y)) b = true ->
  let r := value x + value y in
  (negative_lane (plus x y) = true -> value b < - r * (1 + v)) /\
  (negative_lane (plus x y) = false -> value b < r * (1 + v)).
Proof.
intros X Y P F A r. apply (sure r (plus x y) b P F A); [apply rnd_sum; apply held_value|]. unfold plus.
cases_of (Bplus_correct 53 1024 _ _ mode_NE x y X Y); fold r; fold (rnd r) in *.
- intros (V & Z & S). left. split; [exact V|]. split; [exact Z|]. rewrite S.
  split; intros Q; [now rewrite Rcompare_Lt|now rewrite Rcompare_Gt].
- intros [E%not_finite_overflow S]. right. split; [exact L|]. exists (Bsign x). split; [exact E|].
  destruct (sign_value x), (sign_value y). unfold r. rewrite <- S in *. destruct (Bsign x); simpl in *;
  split; intros; try discriminate; intuition lra.
Qed.

(* j roundings of a value before its last operation, k on the way to its size: a constant of more than j v is enough.
   s is what pays for underflow. *)
Lemma beyond_by s j k A A' D t T m B c e : 0 < s -> est j A D t T -> least_of k A' m T -> A <= s -> A' <= s ->
  0 <= A' -> (j <= 16)%nat -> (k <= 32)%nat -> c <= 64 -> INR j + 1 / 2 <= c -> bpow radix2 e = c * v ->
  (1 - 3 * v) * (bpow radix2 e * m) + 512 * s <= B ->
  (B < - D * (1 + v) -> t < 0) /\ (B < D * (1 + v) -> t > 0).
Proof.
intros sp (x' & [O1 O2] & D1) (m' & [P L] & M) A1 A2 A3 J K C2 C E BL. rewrite E in BL. pose proof v_small as Hv.
assert (T0 : 0 <= T) by (apply Rle_trans with (2 := O1), Rabs_pos).
assert (IJ : 0 <= INR j <= 16) by (split; [apply pos_INR|replace 16 with (INR 16) by (simpl; lra); now apply le_INR]).
assert (IK : 0 <= INR k <= 32) by (split; [apply pos_INR|replace 32 with (INR 32) by (simpl; lra); now apply le_INR]).
assert (V : v = / 9007199254740992) by exact v_is.
assert (JV : INR j * v <= 1) by (rewrite V; lra).
pose proof (bernoulli_up v v_small j JV) as U. pose proof (bernoulli_down v v_small k) as W.
set (J0 := INR j) in *. set (K0 := INR k) in *. set (p := (1 + v) ^ j) in *. set (q := (1 - v) ^ k) in *.
assert (Q1 : (1 + v) * (p - 1) <= (J0 + 1 / 8) * v).
{ assert (J0 * v * (J0 * v) <= / 32 * v) by (rewrite V; nra). assert (p - 1 <= (J0 + / 32) * v) by (simpl in U; lra).
  apply Rle_trans with ((1 + v) * ((J0 + / 32) * v)); [apply Rmult_le_compat_l; lra|]. rewrite V. nra. }
assert (Q2 : (J0 + 1 / 4) * v <= (1 - 3 * v) * (c * v) * q).
{ assert (q >= 1 - 32 * v) by nra. assert ((1 - 3 * v) * q >= 1 - 35 * v) by nra.
  assert (c * v * (1 - 35 * v) <= c * v * ((1 - 3 * v) * q)) by (apply Rmult_le_compat_l; nra).
  assert (c * v * (1 - 35 * v) >= (c - / 4) * v) by (rewrite V; nra). nra. }
assert (Q3 : (J0 + 1 / 4) * v * T - s <= (1 - 3 * v) * (c * v * m)).
{ assert (q * T - A' <= m) by lra. assert (0 <= (1 - 3 * v) * (c * v) <= 1) by (rewrite V; nra).
  assert ((1 - 3 * v) * (c * v) * (q * T - A') <= (1 - 3 * v) * (c * v) * m) by (apply Rmult_le_compat_l; lra).
  assert ((J0 + 1 / 4) * v * T <= (1 - 3 * v) * (c * v) * q * T) by (apply Rmult_le_compat_r; lra). nra. }
assert (Q4 : (1 + v) * ((p - 1) * T) <= (J0 + 1 / 8) * v * T) by nra.
assert (0 <= v * T) by nra. apply abs_le in O2, D1.
split; intros G; apply Rnot_le_lt; intros N; nra.
Qed.
Lemma beyond_all j k A A' D t T m B c e : est j A D t T -> least_of k A' m T -> A <= spare -> A' <= spare ->
  0 <= A' -> (j <= 16)%nat -> (k <= 16)%nat -> c <= 64 -> INR j + 1 / 2 <= c -> bpow radix2 e = c * v ->
  (1 - 3 * v) * (bpow radix2 e * m) + bpow radix2 (-1001) <= B ->
  (B < - D * (1 + v) -> t < 0) /\ (B < D * (1 + v) -> t > 0).
Proof.
intros E L A1 A2 A3 J K C2 C F BL.
apply (beyond_by spare j k A A' D t T m B c e); try assumption; [apply bpow_gt_0|lia|].
replace (512 * spare) with (bpow radix2 (-1001)); [exact BL|].
change 512 with (bpow radix2 9). rewrite <- bpow_plus. reflexivity.
Qed.
