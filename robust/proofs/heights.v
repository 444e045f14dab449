(* SPDX-License-Identifier: Apache-2.0 *)
(* Heights of height_filter.h: the square root, and comparisons with a bound and with the same below zero. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Filters Require Import model constants filters steps ghost tactics squares.
Open Scope R_scope.

Lemma two_to_plus a b : two_to (a + b) = two_to a * two_to b.
Proof. apply powerRZ_add. lra. Qed.
Lemma two_to_pos e : 0 < two_to e.
Proof. apply powerRZ_lt. lra. Qed.
Lemma two_to_one e : (0 <= e)%Z -> 1 <= two_to e.
Proof.
intros E. unfold two_to. rewrite <- (Z2Nat.id e E), <- pow_powerRZ. apply pow_R1_Rle. lra.
Qed.
Lemma two_to_le a b : (a <= b)%Z -> two_to a <= two_to b.
Proof.
intros L. replace b with (a + (b - a))%Z by lia. rewrite two_to_plus. pose proof (two_to_pos a).
pose proof (two_to_one (b - a) ltac:(lia)). rewrite <- (Rmult_1_r (two_to a)) at 1. apply Rmult_le_compat_l; lra.
Qed.

Lemma off_abs u j x t T : off u j x t T -> off u j (Rabs x) (Rabs t) T.
Proof.
intros [A B]. split; [now rewrite Rabs_Rabsolu|]. apply Rle_trans with (2 := B), Rabs_triang_inv2.
Qed.
Lemma off_opposite u j x t T : off u j x t T -> off u j (- x) (- t) T.
Proof.
intros [A B]. split; [now rewrite Rabs_Ropp|]. replace (- x - - t) with (- (x - t)) by ring. now rewrite Rabs_Ropp.
Qed.
Lemma off_between u j x t : 0 < u <= 1/16 -> between u j x t -> off u j x t t.
Proof.
intros Hu [P [A B]]. split; [rewrite Rabs_right; lra|]. apply le_abs.
assert (1 - (1 - u) ^ j <= (1 + u) ^ j - 1).
{ clear - Hu. induction j as [|j IH]; [simpl; lra|]. rewrite <- !tech_pow_Rmult.
  pose proof (down u Hu j). pose proof (upward u Hu j). nra. }
split; [|lra]. assert ((1 - (1 - u) ^ j) * t <= ((1 + u) ^ j - 1) * t) by (apply Rmult_le_compat_r; lra). lra.
Qed.

Section Heights.
Variables (F : format) (H : R).
Hypothesis G : fits F H 1 1.
Notation u := (u F). Notation n := (n F). Notation M := (reals F).

(* a comparison that says how far beyond its bound a value is *)
Theorem above_ghost k cV cB V V0 B P A e i T num extra : close F H k cV V V0 -> close F H k cB B ((P + A) * (1 + e)) ->
  Rabs e <= u -> low u i P T -> IZR num * (n * H ^ k) <= A -> (cV + cB + 1024 + extra <= num * 1023)%Z ->
  (0 <= extra)%Z -> greater M V B true -> V0 > (1 - u) ^ S i * T + q extra * (n * H ^ k).
Proof.
intros [_ LV] [_ LB] E L EA N X (V' & B' & RV & RB & [K _]). specialize (K eq_refl).
pose proof (basics F H 1 1 G) as Bs. pose proof (fits_u F H 1 1 G) as Hu. pose proof (down u Hu i) as Di.
destruct L as [T0 L]. pose proof (ratio u e E) as E1. pose proof (n_pow F H 1 1 G k) as NP. set (N0 := n * H ^ k) in *.
assert (U : u <= 1 / 1024) by (destruct G; lra).
assert (A0 : 0 <= q cV * N0) by (apply Rle_trans with (2 := LV), Rabs_pos).
assert (A1 : 0 <= q cB * N0) by (apply Rle_trans with (2 := LB), Rabs_pos).
assert (A2 : 0 <= q extra * N0) by (apply Rmult_le_pos; [apply q_nonneg, X|lra]).
assert (Q : q cV + q cB + 1 + q extra <= IZR num * (1023 / 1024)).
{ apply IZR_le in N. rewrite !plus_IZR, mult_IZR in N. unfold q. lra. }
assert (A3 : (q cV + q cB + 1 + q extra) * N0 <= IZR num * (1023 / 1024) * N0) by (apply Rmult_le_compat_r; lra).
assert (D : (1 - u) ^ S i * T <= P * (1 + e)).
{ rewrite <- tech_pow_Rmult, Rmult_assoc, Rmult_comm. apply Rmult_le_compat; try lra. apply Rmult_le_pos; lra. }
assert (D0 : 0 <= (1 - u) ^ S i * T) by (apply Rmult_le_pos; [apply pow_le|]; lra).
assert (C : IZR num * (1023 / 1024) * N0 <= A * (1 + e)).
{ apply Rle_trans with (A * (1023 / 1024)); [lra|]. apply Rmult_le_compat_l; lra. }
apply abs_le in LV, LB.
assert (B' = B) as -> by (destruct RB as [->|[_ R]]; [easy|exfalso; rewrite Rabs_right in R; lra]).
assert (V' = V) as -> by (destruct RV as [->|[-> _]]; [easy|exfalso; lra]). lra.
Qed.
Lemma close_opposite k c x x0 : close F H k c x x0 -> close F H k c (- x) (- x0).
Proof. intros [C L]. split; [exact C|]. replace (- x - - x0) with (- (x - x0)) by ring. now rewrite Rabs_Ropp. Qed.
Lemma greater_opposite x y b : greater M (- x) y b -> greater M (- y) x b.
Proof.
assert (R : forall a a', read F a a' -> read F (- a) (- a')).
{ intros a a' [->|[-> A]]; [now left|right]. rewrite Rabs_Ropp. split; [ring|exact A]. }
intros (x' & y' & X & Y & B). exists (- y'), (- x'). split; [now apply R|]. apply R in X. rewrite Ropp_involutive in X.
split; [exact X|]. rewrite B. lra.
Qed.

(* the root of a sum of three squares that is far from underflow *)
Lemma square_use x a a' : mul M x x a -> uses F (Product x x a) a' ->
  exists e, Rabs e <= u /\ - (4 * n) <= a' - x * x * (1 + e) <= 4 * n.
Proof.
intros (y & z & Y & Z & (e & h & E & Hh & ->) & _) U. pose proof (basics F H 1 1 G).
assert (P : forall y z, read F x y -> read F x z -> - n <= y * z - x * x <= 0).
{ intros y' z' [->|[-> Y']] [->|[-> Z']]; try lra; apply Rabs_def2 in Y' || apply Rabs_def2 in Z'; nra. }
destruct U as [U|(y' & z' & Y' & Z' & ->)].
- exists e. split; [exact E|]. specialize (P _ _ Y Z). apply abs_le in E, Hh.
  assert (- (2 * n) <= (y * z - x * x) * (1 + e) <= 0) by nra.
  assert (R : forall r, read F r a' -> - n <= a' - r <= n).
  { intros r [->|[-> R%Rabs_def2]]; lra. }
  specialize (R _ U). lra.
- exists 0. rewrite Rabs_R0. specialize (P _ _ Y' Z'). split; lra.
Qed.
Lemma sum_rounded x y z x0 y0 c : rounded F (x + y) z -> - (c * n) <= x + y - (x0 + y0) <= c * n -> 0 <= c <= 20 ->
  exists e, Rabs e <= u /\ - ((c + 2) * n) <= z - (x0 + y0) * (1 + e) <= (c + 2) * n.
Proof.
intros ((e & h & E & Hh & ->) & _) L C. exists e. split; [exact E|]. apply abs_le in E, Hh.
pose proof (basics F H 1 1 G). assert (u <= 1 / 1024) by (destruct G; lra).
assert (0 <= c * n) by (apply Rmult_le_pos; lra). assert (c * n <= 20 * n) by (apply Rmult_le_compat_r; lra).
assert (- (c * n) * u <= (x + y - (x0 + y0)) * e <= c * n * u) by (split; nra).
assert (c * n * u <= n) by nra. lra.
Qed.
Theorem root x y z a b c t Q s low : n < low -> 18 * n <= u / 16 * low -> low <= 1 ->
  mul M x x a -> mul M y y b -> mul M z z c -> add M (Product x x a) (Product y y b) t ->
  add M (Plain t) (Product z z c) Q -> at_most M low Q true -> square_root M Q s ->
  between u 3 s (sqrt (x * x + y * y + z * z)).
Proof.
intros L1 L2 L3 A B C (a' & b' & UA & UB & T) (t' & c' & UT & UC & S) (l & Q' & Rl & RQ & K) (Q'' & RQ' & R).
pose proof (basics F H 1 1 G) as Bs. pose proof (fits_u F H 1 1 G) as Hu.
assert (l = low) as -> by (destruct Rl as [->|[_ X]]; [easy|rewrite Rabs_right in X; lra]).
apply proj1 in K. specialize (K eq_refl).
assert (Q' = Q) as -> by (destruct RQ as [->|[-> _]]; [easy|lra]).
assert (Q'' = Q) as -> by (destruct RQ' as [->|[_ X]]; [easy|rewrite Rabs_right in X; lra]). clear Rl RQ RQ'.
destruct (square_use _ _ _ A UA) as (ea & EA & IA). destruct (square_use _ _ _ B UB) as (eb & EB & IB).
destruct (square_use _ _ _ C UC) as (ec & EC & IC). clear A B C UA UB UC.
destruct (sum_rounded _ _ _ (x * x * (1 + ea)) (y * y * (1 + eb)) 8 T ltac:(lra) ltac:(lra)) as (et & ET & IT).
assert (IT' : - n <= t' - t <= n) by (destruct UT as [->|[-> X%Rabs_def2]]; lra).
destruct (sum_rounded _ _ _ ((x * x * (1 + ea) + y * y * (1 + eb)) * (1 + et)) (z * z * (1 + ec)) 15 S
  ltac:(lra) ltac:(lra)) as (es & ES & IS).
match type of IS with _ <= _ - ?g <= _ => eassert (BG : between u _ g _) by betweens Hu; cbn [Nat.max] in BG;
  set (g0 := g) in *; clearbody g0 end. clear - R IS BG L2 L3 L1 K Bs Hu G.
destruct BG as [P [G1 G2]]. set (r2 := x * x + y * y + z * z) in *. clearbody r2.
destruct R as ((e & h & E & Hh & ->) & _). apply abs_le in E, Hh. pose proof (sqrt_pos r2) as R0.
pose proof (sqrt_sqrt r2 P) as RR. set (r := sqrt r2) in *. clearbody r.
pose proof (sqrt_pos Q) as S0. pose proof (sqrt_sqrt Q ltac:(lra)) as SS.
assert (SL : low <= sqrt Q). { destruct (Rle_or_lt 1 (sqrt Q)); nra. }
set (s := sqrt Q) in *. clearbody s.
assert (D : 18 * n <= u / 16 * s /\ 18 * n <= u / 16 * Q) by (split; nra).
assert (U1 : Q * (1 - u / 16) <= (1 + u) ^ 3 * r2) by lra.
assert (U2 : (1 - u) ^ 3 * r2 <= Q * (1 + u / 16)) by lra.
split; [exact R0|].
assert (X1 : s * (1 + e) + h <= s * (1 + u + u / 16)) by nra.
assert (X2 : s * (1 - u - u / 16) <= s * (1 + e) + h) by nra.
clear - X1 X2 U1 U2 R0 RR S0 SS Hu P. set (d := u) in *. clearbody d. powers d Hu.
assert (C1 : (1 + d + d / 16) * (1 + d + d / 16) <= (1 + d) ^ 3 * (1 - d / 16)) by (simpl in *; lra).
assert (C2 : (1 - d) ^ 3 * (1 + d / 16) <= (1 - d - d / 16) * (1 - d - d / 16)) by (simpl in *; lra).
assert (P1 : 0 < (1 + d) ^ 3) by (apply pow_lt; lra). assert (P2 : 0 < (1 - d) ^ 3) by (apply pow_lt; lra).
set (p1 := (1 + d) ^ 3) in *. set (p2 := (1 - d) ^ 3) in *. clearbody p1 p2.
split.
- apply Rle_trans with (2 := X2). apply Rsqr_incr_0; [unfold Rsqr| |]; try (apply Rmult_le_pos; lra).
  apply Rmult_le_reg_r with (1 + d / 16); [lra|].
  apply Rle_trans with (p2 * (p2 * r2 * (1 + d / 16))); [right; rewrite <- RR; ring|].
  apply Rle_trans with (p2 * (Q * (1 + d / 16) * (1 + d / 16))); [apply Rmult_le_compat_l;
    [lra|apply Rmult_le_compat_r; lra]|].
  apply Rle_trans with (Q * (1 + d / 16) * (p2 * (1 + d / 16))); [right; ring|].
  apply Rle_trans with (Q * (1 + d / 16) * ((1 - d - d / 16) * (1 - d - d / 16))); [|right; rewrite <- SS; ring].
  apply Rmult_le_compat_l; [apply Rmult_le_pos; nra|exact C2].
- apply Rle_trans with (1 := X1). apply Rsqr_incr_0; [unfold Rsqr| |]; try (apply Rmult_le_pos; lra).
  apply Rmult_le_reg_r with (1 - d / 16); [lra|].
  apply Rle_trans with (Q * (1 - d / 16) * ((1 + d + d / 16) * (1 + d + d / 16))); [right; rewrite <- SS; ring|].
  apply Rle_trans with (Q * (1 - d / 16) * (p1 * (1 - d / 16))); [apply Rmult_le_compat_l; [nra|exact C1]|].
  apply Rle_trans with (p1 * (1 - d / 16) * (p1 * r2)); [|right; rewrite <- RR; ring].
  rewrite (Rmult_comm (Q * _)). apply Rmult_le_compat_l; [nra|exact U1].
Qed.
Lemma root_size x y z s : between u 3 s (sqrt (x * x + y * y + z * z)) -> small H 1 1048 x -> small H 1 1048 y ->
  small H 1 1048 z -> small H 1 4096 s.
Proof.
intros B [_ X] [_ Y] [_ Z]. pose proof (basics F H 1 1 G) as Bs. pose proof (fits_u F H 1 1 G) as Hu.
pose proof (between_pos u Hu _ _ _ B) as S0. destruct B as [R0 [_ B]]. split; [lia|]. rewrite pow_1 in *.
unfold q in *. rewrite Rabs_right by lra.
assert (R : sqrt (x * x + y * y + z * z) <= 1048 / 1024 * H * 3).
{ apply Rsqr_incr_0; [|exact R0|lra]. rewrite Rsqr_sqrt by nra. unfold Rsqr.
  set (h := 1048 / 1024 * H) in *. assert (Q : forall a, Rabs a <= h -> a * a <= h * h) by (intros a A%abs_le; nra).
  apply Q in X, Y, Z. nra. }
apply Rle_trans with (1 := B). assert (U : u <= 1 / 1024) by (destruct G; lra).
assert ((1 + u) ^ 3 <= 1.01) by (simpl; nra).
apply Rle_trans with (1.01 * (1048 / 1024 * H * 3)); [apply Rmult_le_compat; try lra; apply pow_le; lra|lra].
Qed.
End Heights.
