(* SPDX-License-Identifier: Apache-2.0 *)
(* Quotients of enclosures. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Filters Require Import arithmetic enclosed nearest enclosures add_multiply.
Open Scope R_scope.

Section Divide.
Variable choice : Z -> bool.
Hypothesis symmetric : forall x, choice x = negb (choice (- (x + 1))).
Notation rnd := (nearest choice).
Notation encloses := (encloses choice).

(* A number other than zero: its factor, and the inverse of that, rounded. *)
Definition divides d D := exists D0 w, factors (3 / 2) (divisor_value d) D0 /\
  let e := value (divisor_error d) in let h := value (factor_head (divisor_value d)) in
  Rabs (D - D0) <= e /\ e <= / 14 * Rabs h /\ 0 <= e /\ h <> 0 /\
  w = value (factor_whole (divisor_value d)) /\ value (divisor_inverse d) = rnd (1 / w).

Lemma divisor_right x X b d : encloses x X -> settled rnd x b -> b = true -> value (enclosed_high x) <> 0 ->
  divisor_of rnd x d -> divides d X.
Proof.
intros EX S B N (f & F & i & -> & ->).
destruct (factor_of_enclosed_right choice x X b f EX S B F) as (X0 & FX & BX & BE & E0 & H).
exists X0, (value (factor_whole f)). cbn [divisor_value divisor_error divisor_inverse]. cbv zeta.
repeat (split; [assumption|]). split; [|easy]. intros Z. rewrite Z, Rabs_R0 in H. apply N.
destruct (size (value (enclosed_high x))) as [P Q]. lra.
Qed.

Lemma size_between x y a : Rabs (x - y) <= a -> Rabs x <= Rabs y + a /\ Rabs y <= Rabs x + a.
Proof.
intros L. generalize (Rabs_triang_inv x y) (Rabs_triang_inv y x). rewrite (Rabs_minus_sym y x). lra.
Qed.

(* the inverse of a number that is rounded *)
Lemma inverse_near c w D : D <> 0 -> 0 <= c <= 4 -> Rabs (w - D) <= c * u * Rabs D ->
  Rabs (rnd (1 / w) * D - 1) <= (c + 5 / 4) * u.
Proof.
intros H C W. pose proof (Rabs_pos_lt _ H) as P. set (a := Rabs D) in *.
assert (W4 : c * u * a <= / 2 ^ 50 * a) by (apply Rmult_le_compat_r; numbers).
destruct (size_between _ _ _ W) as [_ W2]. fold a in W2.
assert (Pw : 0 < Rabs w) by numbers. assert (Nw : w <> 0) by (intros Z; rewrite Z, Rabs_R0 in Pw; lra).
assert (Q : Rabs (D / w) <= 1 + / 2 ^ 49).
{ unfold Rdiv. rewrite Rabs_mult, Rabs_inv. apply Rmult_le_reg_r with (Rabs w); [exact Pw|].
  rewrite Rmult_assoc, Rinv_l by lra. fold a. numbers. }
assert (Q2 : Rabs ((w - D) / w) <= c * u * (1 + / 2 ^ 49)).
{ replace ((w - D) / w) with ((w - D) / D * (D / w)) by (field; auto). rewrite Rabs_mult.
  apply Rmult_le_compat; auto using Rabs_pos. unfold Rdiv. rewrite Rabs_mult, Rabs_inv. fold a.
  apply Rmult_le_reg_r with a; [exact P|]. rewrite Rmult_assoc, Rinv_l by lra. lra. }
assert (N : Rabs (rnd (1 / w) - 1 / w) <= u * Rabs (1 / w)) by (apply le_abs, near, Rle_refl).
assert (N' : Rabs ((rnd (1 / w) - 1 / w) * D) <= u * (1 + / 2 ^ 49)).
{ rewrite Rabs_mult. apply Rle_trans with (u * Rabs (1 / w) * a); [apply Rmult_le_compat_r; [lra|exact N]|].
  rewrite Rmult_assoc. unfold a. rewrite <- Rabs_mult. replace (1 / w * D) with (D / w) by (field; exact Nw).
  apply Rmult_le_compat_l; [numbers|exact Q]. }
replace (rnd (1 / w) * D - 1) with ((rnd (1 / w) - 1 / w) * D - (w - D) / w) by (field; exact Nw).
clear - C Q2 N'. bounds. apply le_abs. numbers.
Qed.

Lemma scaled x y c D : Rabs x <= c * Rabs y -> Rabs (x * D) <= c * Rabs (y * D).
Proof. intros L. rewrite !Rabs_mult, <- Rmult_assoc. apply Rmult_le_compat_r; [apply Rabs_pos|exact L]. Qed.

(* What is left of n, and that times the inverse; S = |q D|, L bounds the low part, which may be seen as l or as k. *)
Lemma rest_near n l k q h t D J L r1 b r2 r3 low : 0 <= L -> Rabs l <= (1 + u) * L -> Rabs k <= (1 + u) * L ->
  Rabs (l - k) <= 2 * u * L -> Rabs (J * D - 1) <= 3 * u -> h <> 0 ->
  Rabs (D - (h + t)) <= (1 + / 2 ^ 20) * E * Rabs h -> Rabs t <= (1 + / 2 ^ 20) * T * Rabs h ->
  q = round radix2 (FLX_exp 26) Ztrunc (rnd (rnd (n + l) * J)) -> r1 = rnd (n - q * h) ->
  (b = rnd (q * t) \/ b = q * t) -> r2 = rnd (r1 - b) -> r3 = rnd (r2 + k) ->
  (low = rnd (r3 * J) \/ low = r3 * J) -> let S := Rabs (q * D) in
  Rabs (n + k - q * D) <= (1 + / 2 ^ 24) * T * S + 2 * u * L /\
  Rabs (n + k - (q + low) * D) <= (10 + / 2 ^ 10) * E * S + 3 * u * L /\
  Rabs (low * D) <= (1 + / 2 ^ 20) * T * S + 5 * u * L.
Proof.
intros L0 Bl Bk Blk BJ H Bd Bt Hq H1 Hb H2 H3 Hlow S.
set (N := n + l) in *. set (s := rnd N) in *. set (m := rnd (s * J)) in *.
assert (Ns : Rabs (s - N) <= u * Rabs N) by (apply le_abs, near, Rle_refl).
assert (Nm : Rabs (m - s * J) <= u * Rabs (s * J)) by (apply le_abs, near, Rle_refl).
pose proof (head_near m) as Nq. rewrite <- Hq in Nq.
apply (scaled _ _ _ D) in Nm. apply (scaled _ _ _ D) in Nq. fold S in Nq.
assert (Hh : Rabs h <= (1 + / 2 ^ 23) * Rabs D).
{ destruct (size_between D h (/ 2 ^ 24 * Rabs h)) as [_ B]; [|pose proof (Rabs_pos h); numbers].
  destruct (size h) as [P _]. bounds. apply le_abs. numbers. }
assert (Bd' : Rabs (D - (h + t)) <= (1 + / 2 ^ 19) * E * Rabs D) by (destruct (size h), (size D); numbers).
assert (Bt' : Rabs t <= (1 + / 2 ^ 19) * T * Rabs D) by (destruct (size h), (size D); numbers).
apply (scaled _ _ _ q) in Bd', Bt'. rewrite (Rmult_comm D q) in Bd', Bt'. fold S in Bd', Bt'.
rewrite (Rmult_comm t q) in Bt'.
assert (BsJ : Rabs ((J * D - 1) * s) <= 3 * u * Rabs s).
{ rewrite Rabs_mult. apply Rmult_le_compat_r; [apply Rabs_pos|exact BJ]. }
assert (BsN : Rabs s <= (1 + u) * Rabs N).
{ destruct (size_between _ _ _ Ns) as [B _]. lra. }
assert (BsJD : Rabs (s * J * D) <= (1 + 3 * u) * Rabs s).
{ destruct (size_between (s * J * D) s (3 * u * Rabs s)) as [B _]; [|lra].
  replace (s * J * D - s) with ((J * D - 1) * s) by ring. exact BsJ. }
destruct (size q) as [Pq _], (size (q * D)) as [PS PS']. fold S in PS, PS'.
assert (Y : Rabs (N - q * D) <= (1 + / 2 ^ 25) * T * S).
{ assert (B : Rabs (N - q * D) <= T * S + (5 + / 2 ^ 20) * u * Rabs N).
  { pose proof (Rabs_pos N) as A0. replace (N - q * D) with
      (- (s - N) - (J * D - 1) * s - (m - s * J) * D + (m - q) * D) by ring.
    assert (A1 : Rabs ((m - s * J) * D) <= (1 + / 2 ^ 30) * u * Rabs N) by (clear - Nm BsN BsJD A0; numbers).
    assert (A2 : Rabs ((J * D - 1) * s) <= 3 * (1 + / 2 ^ 30) * u * Rabs N) by (clear - BsJ BsN A0; numbers).
    clear - Ns A0 A1 A2 Nq.
    set (v1 := (J * D - 1) * s) in *. set (v2 := (m - s * J) * D) in *. set (v3 := (m - q) * D) in *.
    bounds. apply le_abs. numbers. }
  destruct (size_between _ _ _ B) as [B' _]. fold S in B'. clear - B B' PS. numbers. }
clear Ns Nm Nq BsJ BsN BsJD Bd Bt.
assert (BN : Rabs (n + k - q * D) <= (1 + / 2 ^ 25) * T * S + 2 * u * L).
{ replace (n + k - q * D) with ((N - q * D) - (l - k)) by (unfold N; ring). bounds. apply le_abs. lra. }
split; [clear - BN PS; numbers|].
set (x := q * D) in *. set (dh := (D - (h + t)) * q) in *. set (qt := q * t) in *.
assert (Eh : q * h = x - dh - qt) by (unfold x, dh, qt; ring). rewrite Eh in H1. clearbody dh qt.
assert (B1 : Rabs (n - (x - dh - qt)) <= (2 + / 2 ^ 18) * T * S + (1 + u) * L).
{ clear - Y Bd' Bt' Bl L0 PS. subst N. bounds. apply le_abs. numbers. }
pose proof (near choice _ _ B1) as N1. rewrite <- H1 in N1.
assert (Nb : Rabs (b - qt) <= (1 + / 2 ^ 18) * E * S).
{ destruct Hb as [-> | ->]; [pose proof (near choice _ _ Bt') as A; apply le_abs; clear - A PS; numbers|].
  rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. clear - PS. numbers. }
assert (B2 : Rabs (r1 - b) <= (1 + / 2 ^ 22) * T * S + (1 + 3 * u) * L).
{ replace (r1 - b) with ((N - x) - l + dh + (r1 - (n - (x - dh - qt))) - (b - qt)) by (unfold N; ring).
  clear - N1 Y Bl Nb Bd' L0 PS. bounds. apply le_abs. numbers. }
pose proof (near choice _ _ B2) as N2. rewrite <- H2 in N2.
assert (B3 : Rabs (r2 + k) <= (1 + / 2 ^ 21) * T * S + (4 + / 2 ^ 10) * u * L).
{ replace (r2 + k) with ((N - x) - (l - k) + dh + (r1 - (n - (x - dh - qt))) - (b - qt) + (r2 - (r1 - b)))
    by (unfold N; ring).
  clear - N1 N2 Y Blk Nb Bd' L0 PS. bounds. apply le_abs. numbers. }
pose proof (near choice _ _ B3) as N3. rewrite <- H3 in N3.
assert (B4 : Rabs r3 <= (1 + / 2 ^ 20 - / 2 ^ 22) * T * S + (4 + / 2 ^ 9) * u * L)
  by (clear - N3 B3 L0 PS; bounds; apply le_abs; numbers).
assert (N4 : Rabs (r3 - (n + k - x)) <= (6 + / 2 ^ 12) * E * S + (2 + / 2 ^ 10) * u * L).
{ replace (r3 - (n + k - x)) with ((r1 - (n - (x - dh - qt))) + dh - (b - qt) + (r2 - (r1 - b)) + (r3 - (r2 + k)))
    by ring.
  clear - N1 N2 N3 Nb Bd' L0 PS. bounds. apply le_abs. numbers. }
assert (N5 : Rabs (low * D - r3) <= (4 + / 2 ^ 20) * u * Rabs r3).
{ assert (A : Rabs (r3 * J * D - r3) <= 3 * u * Rabs r3).
  { replace (r3 * J * D - r3) with ((J * D - 1) * r3) by ring. rewrite Rabs_mult.
    apply Rmult_le_compat_r; [apply Rabs_pos|exact BJ]. }
  assert (A' : Rabs ((low - r3 * J) * D) <= u * Rabs (r3 * J * D)).
  { apply scaled. destruct Hlow as [-> | ->]; [apply le_abs, near, Rle_refl|].
    rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. pose proof (Rabs_pos (r3 * J)). numbers. }
  destruct (size_between _ _ _ A) as [B _]. pose proof (Rabs_pos r3) as P.
  replace (low * D - r3) with ((low - r3 * J) * D + (r3 * J * D - r3)) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _). clear - A A' B P. numbers. }
assert (N6 : Rabs (low * D - r3) <= (4 + / 2 ^ 12) * E * S + / 2 ^ 20 * u * L).
{ pose proof (Rabs_pos r3) as P. clear - N5 B4 P PS L0. numbers. }
split.
- replace (n + k - (q + low) * D) with (- (r3 - (n + k - x)) - (low * D - r3)) by (unfold x; ring).
  clear - N4 N6 PS L0. bounds. apply le_abs. numbers.
- replace (low * D) with (r3 + (low * D - r3)) by ring. clear - B4 N6 PS L0. bounds. apply le_abs. numbers.
Qed.

(* N / D for N and D that are off by g and e *)
Lemma quotient_off N n D d q low L g e : d <> 0 -> Rabs (D - d) <= e -> e <= / 13 * Rabs d -> 0 <= e -> 0 <= L ->
  Rabs (N - n) <= g -> Rabs (n - (q + low) * d) <= (10 + / 2 ^ 10) * E * Rabs (q * d) + 3 * u * L ->
  Rabs (low * d) <= (1 + / 2 ^ 20) * T * Rabs (q * d) + 5 * u * L -> let i := / Rabs d in
  Rabs (N / D - (q + low)) <=
    13 / 12 * (g * i + (1 + / 2 ^ 24) * (Rabs q * (e * i))) + 11 * E * Rabs q + 4 * u * (L * i) /\ D <> 0.
Proof.
intros Nd Bd Be E0 L0 Bg Bn Bl i. pose proof (Rabs_pos_lt _ Nd) as Pd. destruct (size_between _ _ _ Bd) as [_ B].
assert (PD : 12 / 13 * Rabs d <= Rabs D) by lra. assert (ND : D <> 0) by (intros Z; rewrite Z, Rabs_R0 in PD; lra).
assert (i0 : 0 < i) by now apply Rinv_0_lt_compat.
assert (Si : Rabs d * i = 1) by (unfold i; apply Rinv_r; lra).
assert (Bk : / Rabs D <= 13 / 12 * i).
{ unfold i. apply Rmult_le_reg_r with (Rabs D); [lra|]. rewrite Rinv_l by lra.
  apply Rle_trans with (13 / 12 * / Rabs d * (12 / 13 * Rabs d)); [right; field; lra|].
  apply Rmult_le_compat_l; [|exact PD]. fold i. lra. }
assert (Ei : e * i <= / 13).
{ apply Rmult_le_reg_r with (Rabs d); [exact Pd|]. rewrite Rmult_assoc, (Rmult_comm i), Si. lra. }
assert (Ei0 : 0 <= e * i) by (apply Rmult_le_pos; lra).
assert (g0 : 0 <= g) by (pose proof (Rabs_pos (N - n)); lra).
assert (Q : Rabs (q + low) <= (1 + / 2 ^ 24) * Rabs q + 5 * u * (L * i)).
{ apply Rmult_le_reg_r with (Rabs d); [exact Pd|]. rewrite <- Rabs_mult, Rmult_plus_distr_r.
  apply Rle_trans with (1 := Rabs_triang _ _).
  replace (((1 + / 2 ^ 24) * Rabs q + 5 * u * (L * i)) * Rabs d) with
    ((1 + / 2 ^ 24) * (Rabs q * Rabs d) + 5 * u * L * (Rabs d * i)) by ring.
  rewrite Si, <- Rabs_mult. pose proof (Rabs_pos (q * d)). numbers. }
assert (M : Rabs ((q + low) * (d - D)) <= ((1 + / 2 ^ 24) * Rabs q + 5 * u * (L * i)) * e).
{ rewrite Rabs_mult. apply Rmult_le_compat; auto using Rabs_pos. now rewrite Rabs_minus_sym. }
set (W := g + ((10 + / 2 ^ 10) * E * Rabs (q * d) + 3 * u * L) + ((1 + / 2 ^ 24) * Rabs q + 5 * u * (L * i)) * e) in *.
assert (HW : Rabs (N - (q + low) * D) <= W).
{ replace (N - (q + low) * D) with ((N - n) + (n - (q + low) * d) + (q + low) * (d - D)) by ring.
  unfold W. bounds. apply le_abs. lra. }
split; [|exact ND].
replace (N / D - (q + low)) with ((N - (q + low) * D) * / D) by (field; exact ND).
rewrite Rabs_mult, Rabs_inv.
apply Rle_trans with (W * (13 / 12 * i)).
{ apply Rmult_le_compat; auto using Rabs_pos. apply Rlt_le, Rinv_0_lt_compat. lra. }
unfold W. rewrite Rabs_mult.
replace ((g + ((10 + / 2 ^ 10) * E * (Rabs q * Rabs d) + 3 * u * L) +
  ((1 + / 2 ^ 24) * Rabs q + 5 * u * (L * i)) * e) * (13 / 12 * i)) with
  (13 / 12 * (g * i + (1 + / 2 ^ 24) * (Rabs q * (e * i)) + (10 + / 2 ^ 10) * E * Rabs q * (Rabs d * i) +
   3 * u * (L * i) + 5 * u * (L * i * (e * i)))) by ring.
rewrite Si. assert (Li : 0 <= L * i) by (apply Rmult_le_pos; lra).
assert (LE : L * i * (e * i) <= L * i * / 13) by (apply Rmult_le_compat_l; assumption).
pose proof (Rabs_pos q). clear - LE Li H. numbers.
Qed.

(* high is its head, and low is small beside it, but for the error *)
Definition quotient r := exists q, exactly (enclosed_high r) q /\ digits kept q /\
  Rabs (value (enclosed_low r)) <= (1 + / 2 ^ 20) * T * Rabs q + value (enclosed_error r).

Lemma error_at_least g1 q e J i L t7 t8 t9 c t12 t13 t14 z : 0 <= g1 -> 0 <= Rabs q -> 0 <= e -> 0 <= L -> 0 < i ->
  (1 - 4 * u) * i <= Rabs J ->
  seen (Product (Rabs q) e (rnd (Rabs q * e))) t7 -> t8 = rnd (g1 + t7) ->
  seen (Product (40 * u) L (rnd (40 * u * L))) t9 -> c = rnd (t8 + t9) -> t12 = rnd (5 / 4 * c) ->
  seen (Product t12 (Rabs J) (rnd (t12 * Rabs J))) t13 ->
  seen (Product (14 * E) (Rabs q) (rnd (14 * E * Rabs q))) t14 ->
  z = rnd (t13 + t14) -> 6 / 5 * (g1 * i) + 6 / 5 * (Rabs q * (e * i)) + 40 * u * (L * i) + 12 * E * Rabs q <= z.
Proof.
intros G0 Q0 E0 L0 i0 HJ H7 -> H9 -> -> H13 H14 ->. set (a := Rabs q) in *. set (j := Rabs J) in *.
assert (P : 0 <= a * e) by now apply Rmult_le_pos.
apply product_seen in H7; [|exact P]. apply product_seen in H9; [|numbers]. apply product_seen in H14; [|numbers].
destruct (near_pos choice (g1 + t7)) as [N1 _]; [numbers|]. set (t8 := rnd (g1 + t7)) in *.
destruct (near_pos choice (t8 + t9)) as [N2 _]; [numbers|]. set (c := rnd (t8 + t9)) in *.
destruct (near_pos choice (5 / 4 * c)) as [N3 _]; [numbers|]. set (t12 := rnd (5 / 4 * c)) in *.
assert (M : 5 / 4 * (1 - / 2 ^ 40) * (g1 + a * e + 40 * u * L) <= t12) by numbers.
assert (T0 : 0 <= t12) by numbers.
assert (W : 5 / 4 * (1 - / 2 ^ 40) * (g1 + a * e + 40 * u * L) * ((1 - 4 * u) * i) <= t12 * j).
{ apply Rmult_le_compat; [numbers|numbers|exact M|exact HJ]. }
apply product_seen in H13; [|apply Rmult_le_pos; [exact T0|apply Rabs_pos]].
replace (5 / 4 * (1 - / 2 ^ 40) * (g1 + a * e + 40 * u * L) * ((1 - 4 * u) * i)) with
  (5 / 4 * (1 - / 2 ^ 40) * (1 - 4 * u) * (g1 * i + a * (e * i) + 40 * u * (L * i))) in W by ring.
assert (P1 : 0 <= g1 * i) by (apply Rmult_le_pos; lra). assert (P2 : 0 <= L * i) by (apply Rmult_le_pos; lra).
assert (P3 : 0 <= a * (e * i)) by (rewrite <- Rmult_assoc; apply Rmult_le_pos; lra).
set (tj := t12 * j) in *. set (gi := g1 * i) in *. set (aei := a * (e * i)) in *. set (Li := L * i) in *.
clear - P1 P2 P3 W H13 H14 Q0. clearbody a tj gi aei Li.
destruct (near_pos choice (t13 + t14)) as [N _]; numbers.
Qed.

Theorem divide_right n d r N D : encloses n N -> divides d D -> divide rnd n d r -> encloses r (N / D) /\ D <> 0 /\
  quotient r.
Proof.
intros EN (D0 & w & FD & BD & BE & E0 & H & Hw & HJ) R. pose proof EN as (hn & Hh & SL & SE & BN).
destruct R as (t & (x1 & l & S1 & Sl & ->) & t1 & -> & t2 & -> & t3 & (x3 & x4 & S3 & S4 & ->) & t4 & -> & t5 &
  (x5 & b & S5 & Sb & ->) & r3 & (x7 & k & S7 & Sk & ->) & t7 & -> & t8 & (g1 & z7 & Sg & S7' & ->) & t9 & -> & c &
  (z8 & z9 & S8 & S9 & ->) & t11 & -> & t12 & -> & t13 & -> & t14 & -> & t15 & (z13 & z14 & S13 & S14 & ->) & ->).
pose proof (proj2 Hh _ S1) as ->. pose proof (proj2 Hh _ S3) as ->.
destruct FD as (h & Hf & Df & F1 & F2 & F3). pose proof (exactly_value _ _ Hf) as Vf.
cbv zeta in *. rewrite Vf in *. rewrite HJ in *. rewrite <- Hw in *.
cbn [value seen magnitude head] in *. subst x5 x7 z8. rewrite HJ in S13.
set (J := rnd (1 / w)) in *. set (t := value (factor_tail (divisor_value d))) in *.
set (q := round radix2 (FLX_exp kept) Ztrunc (rnd (rnd (hn + l) * J))) in *.
pose proof (head_digits (rnd (rnd (hn + l) * J)) : digits kept q) as Dq.
pose proof (head_product q h Dq Df) as Dqh.
assert (x4 = q * h) as -> by (destruct S4 as [-> | ->]; [now apply nearest_exact|reflexivity]).
destruct (size h) as [P0 P1]. assert (DH : Rabs (D0 - h) <= / 2 ^ 24 * Rabs h) by (bounds; apply le_abs; numbers).
destruct (size_between _ _ _ DH) as [DH1 DH2].
pose proof (Rabs_pos_lt _ H) as Ph. assert (PD : 0 < Rabs D0) by numbers.
assert (ND : D0 <> 0) by (intros Z; rewrite Z, Rabs_R0 in PD; lra).
assert (BJ : Rabs (J * D0 - 1) <= 3 * u) by
  (apply Rle_trans with (1 := inverse_near (13 / 8) w D0 ND ltac:(lra) ltac:(numbers)); numbers).
set (v := value (enclosed_low n)) in *.
pose proof (low_size choice _ _ SL Sl) as Ll. pose proof (low_size choice _ _ SL Sk) as Lk.
pose proof (seen_near choice _ _ SL Sl) as Nl. pose proof (seen_near choice _ _ SL Sk) as Nk.
fold v in Ll, Lk, Nl, Nk. destruct (size v) as [L0 _]. set (L := Rabs v) in *.
assert (Llk : Rabs (l - k) <= 2 * u * L) by (clear - Nl Nk; bounds; apply le_abs; lra).
set (r1 := rnd (hn - q * h)) in *. set (r2 := rnd (r1 - b)) in *. set (r3 := rnd (r2 + k)) in *.
assert (K : forall low, (low = rnd (r3 * J) \/ low = r3 * J) ->
  Rabs (hn + k - (q + low) * D0) <= (10 + / 2 ^ 10) * E * Rabs (q * D0) + 3 * u * L /\
  Rabs (low * D0) <= (1 + / 2 ^ 20) * T * Rabs (q * D0) + 5 * u * L).
{ intros low Sl'. now destruct (rest_near hn l k q h t D0 J L r1 b r2 r3 low L0 Ll Lk Llk BJ H F1 F2 eq_refl eq_refl Sb
    eq_refl eq_refl Sl') as [_ K]. }
assert (i0 : 0 < / Rabs D0) by now apply Rinv_0_lt_compat. assert (Si : Rabs D0 * / Rabs D0 = 1) by (apply Rinv_r; lra).
assert (Ji : (1 - 4 * u) * / Rabs D0 <= Rabs J).
{ apply Rmult_le_reg_r with (Rabs D0); [exact PD|]. rewrite Rmult_assoc, (Rmult_comm (/ _)), Si, <- Rabs_mult.
  destruct (size_between _ _ _ BJ) as [_ B]. rewrite Rabs_R1 in B. numbers. }
pose proof (error_nonneg choice _ _ _ EN Sg) as G0.
pose proof (error_at_least g1 q (value (divisor_error d)) J (/ Rabs D0) L z7 _ z9 _ _ z13 z14 _ G0 (Rabs_pos q) E0 L0 i0
  Ji S7' eq_refl S9 eq_refl eq_refl S13 S14 eq_refl) as At.
set (err := rnd (z13 + z14)) in *. clearbody err. clear S13 S14 S7' S9 Hh S1 S3 EN.
assert (Eh : value (divisor_error d) <= / 13 * Rabs D0) by (clear - DH2 BE P0; numbers).
set (e := value (divisor_error d)) in *.
assert (P2 : 0 <= Rabs q * (e * / Rabs D0)) by (apply Rmult_le_pos; [apply Rabs_pos|apply Rmult_le_pos; lra]).
assert (P3 : 0 <= L * / Rabs D0) by (apply Rmult_le_pos; lra).
assert (P4 : 0 <= g1 * / Rabs D0) by (apply Rmult_le_pos; lra). pose proof (Rabs_pos q) as P5.
split; [|split].
- exists q. cbn [enclosed_high enclosed_low enclosed_error].
  split; [apply exactly_plain; now apply digits_up with kept|]. split; [easy|]. split; [easy|]. intros low z Sl' ->.
  destruct (K low Sl') as [K1 K2].
  destruct (quotient_off N (hn + k) D D0 q low L g1 e ND BD Eh E0 L0 (BN k g1 Sk Sg) K1 K2) as [Off _].
  apply Rle_trans with (1 := Off). clear - At P2 P3 P4 P5. numbers.
- destruct (K _ (or_intror eq_refl)) as [K1 K2].
  now destruct (quotient_off N (hn + k) D D0 q _ L g1 e ND BD Eh E0 L0 (BN k g1 Sk Sg) K1 K2) as [_ Z].
- exists q. cbn [enclosed_high enclosed_low enclosed_error value].
  split; [apply exactly_plain; now apply digits_up with kept|]. split; [exact Dq|].
  destruct (K _ (or_introl eq_refl)) as [_ K2]. set (low := rnd (r3 * J)) in *.
  apply Rle_trans with ((1 + / 2 ^ 20) * T * Rabs q + 5 * u * (L * / Rabs D0)); [|clear - At P2 P3 P4 P5; numbers].
  apply Rmult_le_reg_r with (Rabs D0); [exact PD|]. rewrite <- Rabs_mult. apply Rle_trans with (1 := K2).
  rewrite Rabs_mult. replace (((1 + / 2 ^ 20) * T * Rabs q + 5 * u * (L * / Rabs D0)) * Rabs D0) with
    ((1 + / 2 ^ 20) * T * (Rabs q * Rabs D0) + 5 * u * L * (Rabs D0 * / Rabs D0)) by ring. rewrite Si. lra.
Qed.
End Divide.
