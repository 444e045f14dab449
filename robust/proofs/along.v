(* SPDX-License-Identifier: Apache-2.0 *)
(* Points along a line, and the rounding test. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Filters Require Import arithmetic enclosed nearest enclosures sums add_multiply quotients.
Open Scope R_scope.

Section Along.
Variable choice : Z -> bool.
Hypothesis symmetric : forall x, choice x = negb (choice (- (x + 1))).
Notation rnd := (nearest choice).
Notation encloses := (encloses choice).

(* t is X, but for e: a head, a tail rounded, which may be beyond its bound by e *)
Theorem along_factor_right start s t error v c X V r : exactly start s -> 0 <= c <= 6 / 5 -> factors c v V ->
  (exists h X0, exactly (factor_head t) h /\ digits kept h /\
    let e := value error in let l := value (factor_tail t) in 0 <= e /\ Rabs (X - X0) <= e /\
    Rabs (X0 - (h + l)) <= (1 + / 2 ^ 20) * E * Rabs h /\ Rabs l <= (1 + / 2 ^ 20) * T * Rabs h + e) ->
  along_factor rnd start t error v r -> encloses r (s + X * V).
Proof.
intros Hs C (hv & Hv & Dv & V1 & V2 & V3) (h & X0 & Hh & Dh & E0 & BX & B0 & Bl) R.
destruct R as (p & (p1 & -> & p2 & -> & p3 & -> & p4 & (x1 & x2 & S1 & S2 & ->) & ->) & s1 & F & s2 & A & q & Q & t5 &
  -> & t6 & -> & t7 & (e0 & x6 & Se & S6 & ->) & ->).
destruct A as (s3 & A & ->).
rewrite (exactly_value _ _ Hh), (exactly_value _ _ Hv) in *. cbv zeta in *.
cbn [value magnitude] in *. names (5 / 4) S6.
set (l := value (factor_tail t)) in *. set (e := value error) in *. set (wv := value (factor_whole v)) in *.
destruct (product_tail choice h l hv (value (factor_tail v)) wv (rnd (x1 + x2)) c e X0 V) as [P1 P2]; auto; try lra.
{ exists x1, x2. auto. }
set (w := e * Rabs hv) in *. destruct (size hv) as [H0 H1], (size (h * hv)) as [M0 _].
assert (w0 : 0 <= w) by now apply Rmult_le_pos.
destruct (first_holds choice _ (X0 * V) _ w w0 F) as [M H].
{ exists (h * hv). cbn [term2_head term2_tail]. pose proof (head_product h hv Dh Dv) as D. split.
  - split; [exact D|]. intros y [-> | ->]; [now apply nearest_exact|reflexivity].
  - split; [easy|]. intros y ->. split; [|exact P2]. apply Rle_trans with (1 := P1). clear - C M0.
    assert (c * Rabs (h * hv) <= 6 / 5 * Rabs (h * hv)) by (apply Rmult_le_compat_r; lra). numbers. }
destruct (plus_holds choice symmetric _ _ M 1 w _ s _ H ltac:(lia) (number_term choice _ _ Hs) A) as [M' H'].
destruct (value_holds choice _ _ M' _ w _ H' ltac:(lia) Q) as (k & Hk & Sl & _ & B).
exists k. cbn [enclosed_high enclosed_low enclosed_error]. split; [exact Hk|]. split; [exact Sl|]. split; [easy|].
intros y z Sy ->. destruct (B y e0 Sy Se) as [e00 Off]. change (IZR (1 + 1)) with 2 in Off.
assert (WV : (1 - / 2 ^ 22) * Rabs hv <= Rabs wv).
{ assert (K : Rabs (hv - wv) <= / 2 ^ 22 * Rabs hv).
  { assert (K : c * u * Rabs hv <= 6 / 5 * u * Rabs hv) by (apply Rmult_le_compat_r; [lra|numbers]).
    clear - V1 V2 V3 K H0. bounds. apply le_abs. numbers. }
  destruct (size_between _ _ _ K) as [K1 _]. lra. }
assert (WW : (1 - / 2 ^ 22) * w <= e * Rabs wv).
{ unfold w. replace ((1 - / 2 ^ 22) * (e * Rabs hv)) with (e * ((1 - / 2 ^ 22) * Rabs hv)) by ring.
  now apply Rmult_le_compat_l. }
assert (BV : Rabs V <= (1 + / 2 ^ 23) * Rabs hv) by (clear - V1 V2 H0 H1; bounds; apply le_abs; numbers).
assert (BX1 : Rabs (X - X0) <= 1 * e) by lra. pose proof (prod_le _ _ _ _ _ _ BX1 BV) as BXV. fold w in BXV.
destruct (near_pos choice (5 / 4 * e)) as [N1 _]; [lra|]. set (t5 := rnd (5 / 4 * e)) in *.
assert (T5 : 0 <= t5) by numbers. apply product_seen in S6; [|apply Rmult_le_pos; [exact T5|apply Rabs_pos]].
assert (N2 : (1 - u) * (5 / 4 * (e * Rabs wv)) <= t5 * Rabs wv).
{ replace ((1 - u) * (5 / 4 * (e * Rabs wv))) with ((1 - u) * (5 / 4 * e) * Rabs wv) by ring.
  apply Rmult_le_compat_r; [apply Rabs_pos|exact N1]. }
set (a := t5 * Rabs wv) in *. set (b := e * Rabs wv) in *. clearbody a b.
destruct (near_pos choice (e0 + x6)) as [N3 _]; [clear - e00 S6 N2 WW w0; numbers|].
replace (s + X * V - (k + y)) with ((X0 * V + s - (k + y)) + (X - X0) * V) by ring.
apply Rle_trans with (1 := Rabs_triang _ _). clear - N3 e00 S6 N2 WW w0 Off BXV. numbers.
Qed.
Theorem along_right start s t v c X V r : exactly start s -> encloses t X -> quotient t -> 0 <= c <= 6 / 5 ->
  factors c v V -> along rnd start t v r -> encloses r (s + X * V).
Proof.
intros Hs EX (q & Hq & Dq & Bq) C FV (r' & R & ->).
apply (along_factor_right start s _ _ v c X V r' Hs C FV) with (2 := R). exists q, (q + value (enclosed_low t)).
cbv zeta. cbn [factor_head factor_tail]. split; [exact Hq|]. split; [exact Dq|].
split; [exact (error_nonneg choice _ _ _ EX (seen_value _))|]. split.
2: { split; [|exact Bq]. rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. destruct (size q). numbers. }
destruct EX as (h & Hh & _ & _ & B). pose proof (exactly_value _ _ Hq) as <-. rewrite (exactly_value _ _ Hh).
apply B; apply seen_value.
Qed.

(* Two numbers that are both nearest to x lie to either side of it, as far. *)
Lemma no_tie other x y z : y < x < z -> rnd y = rnd z -> nearest other x = rnd x.
Proof.
intros I E.
assert (N : forall c t g, float g -> Rabs (nearest c t - t) <= Rabs (g - t)).
{ intros c t g G. exact (proj2 (round_N_pt radix2 (FLX_exp 53) c t) g G). }
pose proof (nearest_le choice y x ltac:(lra)) as Y. pose proof (nearest_le choice x z ltac:(lra)) as Z.
pose proof (N choice y _ (nearest_digits other x)) as Ny. pose proof (N choice z _ (nearest_digits other x)) as Nz.
pose proof (N choice x _ (nearest_digits other x)) as Nx. pose proof (N other x _ (nearest_digits choice x)) as No.
replace (rnd y) with (rnd x) in * by lra. replace (rnd z) with (rnd x) in * by lra.
set (a := rnd x) in *. set (b := nearest other x) in *. clearbody a b.
unfold Rabs in *. repeat destruct Rcase_abs; lra.
Qed.

(* What is answered is X rounded to nearest, wherever ties go: a number between two is none that is answered. *)
Theorem rounded_right x X a other : encloses x X -> rounded rnd x (Some a) -> value a = nearest other X.
Proof.
intros EX R. pose proof (error_nonneg choice _ _ _ EX (seen_value _)) as E0. destruct EX as (h & Hh & SL & SE & B).
destruct R as (t & -> & t1 & -> & m & (x1 & x2 & S1 & S2 & ->) & t3 & (l & x4 & Sl & S4 & ->) & above &
  (x5 & x6 & S5 & S6 & ->) & t5 & (k & x8 & Sk & S8 & ->) & below & (x9 & x10 & S9 & S10 & ->) & b & C & t7 &
  (x11 & x12 & S11 & S12 & ->) & A).
destruct b; [|discriminate]. injection A as ->. destruct C as [C _]. specialize (C eq_refl).
pose proof (proj2 Hh _ S5) as ->. pose proof (proj2 Hh _ S9) as ->. cbn [seen value magnitude] in *.
subst x4 x6 x8 x10 x11 x12.
set (m := rnd (x1 + x2)) in *. rewrite Rplus_0_r, (nearest_exact choice (rnd _)) by apply nearest_digits.
pose proof (B l _ Sl (seen_value _)) as Bl. pose proof (B k _ Sk (seen_value _)) as Bk.
pose proof (low_size choice _ _ SL Sl) as Ll. pose proof (low_size choice _ _ SL Sk) as Lk.
set (e := value (enclosed_error x)) in *. destruct (size (value (enclosed_low x))) as [L0 _].
set (L := Rabs (value (enclosed_low x))) in *.
names (5 / 4) S1. names (2 * u) S2.
apply product_seen in S1; [|lra]. apply product_seen in S2; [|numbers].
destruct (near_pos choice (x1 + x2)) as [N _]; [numbers|]. fold m in N. assert (M0 : 0 <= m) by numbers.
assert (A1 : Rabs (l + m) <= (1 + u) * L + m) by (clear - Ll M0; bounds; apply le_abs; numbers).
assert (A2 : Rabs (k - m) <= (1 + u) * L + m) by (clear - Lk M0; bounds; apply le_abs; numbers).
pose proof (near choice _ _ A1) as N1. pose proof (near choice _ _ A2) as N2.
set (up := rnd (l + m)) in *. set (down := rnd (k - m)) in *.
destruct (Rle_or_lt (e + L) 0) as [Z|P].
- (* one number *)
  assert (X = h) as -> by (clear - Bk Lk Z E0 L0; bounds; numbers). destruct Hh as [D _].
  assert (U : 0 <= up) by (clear - N1 N S1 S2 Ll L0 E0 M0 Z; bounds; numbers).
  assert (V : down <= 0) by (clear - N2 N S1 S2 Lk L0 E0 M0 Z; bounds; numbers).
  pose proof (nearest_le choice h (h + up) ltac:(lra)). pose proof (nearest_le choice (h + down) h ltac:(lra)).
  rewrite (nearest_exact other h) by exact D. pose proof (nearest_exact choice h D). lra.
- assert (U : X < h + up) by (clear - Bl N1 N S1 S2 L0 E0 M0 P; bounds; numbers).
  assert (V : h + down < X) by (clear - Bk N2 N S1 S2 L0 E0 M0 P; bounds; numbers).
  pose proof (nearest_le choice (h + down) X ltac:(lra)). pose proof (nearest_le choice X (h + up) ltac:(lra)).
  rewrite (no_tie other X (h + down) (h + up)) by lra. lra.
Qed.
End Along.

(* The zero of that answer: a sum with +0 is never -0. *)
From Flocq Require Import IEEE754.BinarySingleNaN IEEE754.Binary.
Theorem zero_is_positive prec_ok emax_ok nan s :
  Bplus 53 1024 prec_ok emax_ok nan mode_NE (B754_zero 53 1024 s) (B754_zero 53 1024 false) = B754_zero 53 1024 false.
Proof. now destruct s. Qed.
