(* SPDX-License-Identifier: Apache-2.0 *)
(* push.h: v + t n, with one bound for t and for all that follows. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Filters Require Import arithmetic enclosed nearest enclosures add_multiply along.
Open Scope R_scope.

Section Push.
Variable choice : Z -> bool.
Hypothesis symmetric : forall x, choice x = negb (choice (- (x + 1))).
Notation rnd := (nearest choice).

(* t is X but for d: a head below G, a tail *)
Lemma pushed_right start s t v V X G d a other : exactly start s -> factors 0 v V ->
  (exists h, exactly (share_head t) h /\ digits kept h /\ Rabs h <= G /\
    let l := value (share_tail t) in
    Rabs l <= 12 / 5 * T * G /\ Rabs (X - (h + l)) <= d /\
    (1 + / 2 ^ 40) * d + 59 / 4 * E * G <= value (share_error t)) ->
  enclosed_push rnd start t v (Some a) -> value a = nearest other (s + X * V).
Proof.
intros Hs (hv & Hv & Dv & V1 & V2 & V3) (h & Hh & Dh & BG & Bl & BX & Be) R. cbv zeta in *.
destruct R as (x & (t1 & -> & sum & R & t3 & -> & t4 & -> & t5 & (x1 & x2 & S1 & S2 & ->) & low &
  (x3 & x4 & S3 & S4 & ->) & t7 & -> & t8 & -> & m & (x5 & x6 & S5 & S6 & ->) & ->) & t9 &
  (x7 & x8 & S7 & S8 & ->) & above & (x9 & x10 & S9 & S10 & ->) & t11 & (x11 & x12 & S11 & S12 & ->) & below &
  (x13 & x14 & S13 & S14 & ->) & b & C & t13 & (x15 & x16 & S15 & S16 & ->) & A).
destruct b; [|discriminate]. injection A as ->. destruct C as [C _]. specialize (C eq_refl).
rewrite (exactly_value _ _ Hh), (exactly_value _ _ Hv) in *.
pose proof (head_product h hv Dh Dv) as D.
assert (Hp : exactly (Product h hv (rnd (h * hv))) (h * hv)).
{ split; [exact D|]. intros y [-> | ->]; [now apply nearest_exact|reflexivity]. }
destruct (two_sum_right choice symmetric _ _ _ _ _ Hp Hs R) as (k & q & -> & Hk & Dq & Exact).
cbn [seen value magnitude pair_low pair_high enclosed_high enclosed_low enclosed_error] in *.
rewrite (exactly_value _ _ Hs) in *.
subst x3 x4 x7 x8 x9 x10 x11 x12 x13 x14 x15 x16.
assert (WV : value (factor_whole v) = V) by (clear - V3; bounds; lra). rewrite WV in *.
set (l := value (share_tail t)) in *. set (e := value (share_error t)) in *. set (tv := value (factor_tail v)) in *.
(* all in units of |V| *)
destruct (size hv) as [H0 H1], (size V) as [Q0 Q1].
assert (BV : Rabs hv <= (1 + / 2 ^ 23) * Rabs V).
{ assert (K : Rabs (hv - V) <= / 2 ^ 24 * Rabs hv) by (clear - V1 V2 H0; bounds; apply le_abs; numbers).
  assert (Rabs hv <= Rabs (hv - V) + Rabs V) by (replace hv with ((hv - V) + V) at 1 by ring; apply Rabs_triang).
  numbers. }
set (Q := Rabs V) in *. assert (G0 : 0 <= G) by (apply Rle_trans with (2 := BG), Rabs_pos).
assert (d0 : 0 <= d) by (apply Rle_trans with (2 := BX), Rabs_pos).
assert (B1 : Rabs tv <= (1 + / 2 ^ 19) * T * Q) by (clear - V2 BV Q0; numbers).
assert (B2 : Rabs (V - (hv + tv)) <= (1 + / 2 ^ 19) * E * Q) by (clear - V1 BV Q0; numbers).
rewrite <- (Rmult_1_l G) in BG. rewrite <- (Rmult_1_l d) in BX. assert (BQ : Rabs V <= 1 * Q) by (unfold Q; lra).
pose proof (prod_le _ _ _ _ _ _ BG BV) as P1. pose proof (prod_le _ _ _ _ _ _ BG B1) as P2.
pose proof (prod_le _ _ _ _ _ _ BG B2) as P3. pose proof (prod_le _ _ _ _ _ _ Bl BQ) as P4.
pose proof (prod_le _ _ _ _ _ _ BX BQ) as P5.
assert (P6 : (1 + / 2 ^ 40) * (d * Q) + 59 / 4 * E * (G * Q) <= e * Q).
{ apply Rle_trans with (((1 + / 2 ^ 40) * d + 59 / 4 * E * G) * Q); [right; ring|]. now apply Rmult_le_compat_r. }
assert (P0 : 0 <= G * Q) by now apply Rmult_le_pos. assert (W0 : 0 <= d * Q) by now apply Rmult_le_pos.
set (P := G * Q) in *. set (W := d * Q) in *. destruct (size s) as [s0 s1]. set (S := Rabs s) in *.
assert (Na : Rabs (x1 - h * tv) <= (1 + / 2 ^ 18) * E * P).
{ destruct S1 as [-> | ->]; [pose proof (near choice _ _ P2); apply le_abs; numbers|].
  rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. numbers. }
assert (Nb : Rabs (x2 - l * V) <= 12 / 5 * E * P).
{ destruct S2 as [-> | ->]; [pose proof (near choice _ _ P4); apply le_abs; numbers|].
  rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. numbers. }
set (v1 := h * hv) in *. set (v2 := h * tv) in *. set (v3 := l * V) in *.
set (v4 := h * (V - (hv + tv))) in *. set (v5 := (X - (h + l)) * V) in *.
assert (Same : s + X * V = s + v1 + v2 + v3 + v4 + v5) by (unfold v1, v2, v3, v4, v5; ring).
rewrite Same. clearbody v1 v2 v3 v4 v5.
assert (B3 : Rabs (x1 + x2) <= (17 / 5 + / 2 ^ 17) * T * P) by (clear - P2 P4 Na Nb P0; bounds; apply le_abs; numbers).
pose proof (near choice _ _ B3) as N3. set (y := rnd (x1 + x2)) in *. clearbody y.
assert (B4 : Rabs (v1 + s) <= (1 + / 2 ^ 23) * P + S) by (clear - P1 s1; bounds; apply le_abs; numbers).
pose proof (near choice _ _ B4) as N4. rewrite <- Hk in N4.
assert (B5 : Rabs (q + y) <= (17 / 5 + / 2 ^ 16) * T * P + u * (P + S) + / 2 ^ 22 * u * P).
{ clear - N3 B3 N4 Exact P0. bounds. apply le_abs; numbers. }
pose proof (near choice _ _ B5) as N5. set (low := rnd (q + y)) in *. clearbody low.
(* the margin *)
assert (eQ : 0 <= e * Q) by (clear - P6 W0 P0; numbers). assert (cS : 0 <= cut * S) by (clear - s0; numbers).
apply product_seen in S5; [|exact eQ]. apply product_seen in S6; [|exact cS].
set (z := e * Q) in *. clearbody z.
destruct (near_pos choice (x5 + x6)) as [N6 _]; [clear - S5 S6 eQ cS; numbers|]. set (m := rnd (x5 + x6)) in *.
clearbody m. assert (M0 : 0 <= m) by (clear - N6 S5 S6 eQ cS; numbers).
set (L := (17 / 5 + / 2 ^ 15) * T * P + u * (P + S) + / 2 ^ 21 * u * P + 2 * u * u * S).
assert (B6 : Rabs low <= L) by (unfold L; clear - N5 B5 P0 s0; bounds; apply le_abs; numbers).
assert (B7 : Rabs (low + m) <= L + m) by (clear - B6 M0; bounds; apply le_abs; lra).
assert (B8 : Rabs (low - m) <= L + m) by (clear - B6 M0; bounds; apply le_abs; lra).
pose proof (near choice _ _ B7) as N7. pose proof (near choice _ _ B8) as N8.
set (up := rnd (low + m)) in *. set (down := rnd (low - m)) in *.
rewrite Rplus_0_r, (nearest_exact choice (rnd _)) in * by apply nearest_digits.
set (I := s + v1 + v2 + v3 + v4 + v5) in *.
assert (Off : Rabs (I - (k + low)) <= W + (56 / 5 + / 2 ^ 14) * E * P + / 2 ^ 27 * E * S).
{ unfold I. clear - N3 N5 Exact Na Nb P3 P5 P0 s0 W0. bounds. apply le_abs; numbers. }
assert (Room : (1 - 3 * u) * (z + cut * S) <= m) by (clear - N6 S5 S6 eQ cS; numbers).
destruct (Rle_or_lt (z + S) 0) as [Z|Z].
- (* all is zero *)
  assert (P = 0 /\ W = 0 /\ S = 0) as (-> & -> & ->) by (clear - P6 Z P0 W0 s0 eQ; numbers).
  assert (k = 0) as -> by (clear - N4 B4; bounds; numbers).
  assert (I = 0) as -> by (unfold L in *; clear - Off B6; bounds; numbers).
  assert (U : 0 <= 0 + up) by (unfold L in *; clear - N7 B6 M0; bounds; numbers).
  assert (Dn : 0 + down <= 0) by (unfold L in *; clear - N8 B6 M0; bounds; numbers).
  assert (Z0 : forall c, nearest c 0 = 0) by (intros c; apply round_0; auto with typeclass_instances).
  pose proof (nearest_le choice _ _ U). pose proof (nearest_le choice _ _ Dn). rewrite !Z0 in *. lra.
- assert (U : I < k + up) by (unfold L in *; clear - N7 Off Room P6 P0 W0 s0 M0 Z eQ; bounds; numbers).
  assert (Dn : k + down < I) by (unfold L in *; clear - N8 Off Room P6 P0 W0 s0 M0 Z eQ; bounds; numbers).
  pose proof (nearest_le choice (k + down) I ltac:(lra)). pose proof (nearest_le choice I (k + up) ltac:(lra)).
  rewrite (no_tie choice other I (k + down) (k + up)) by lra. lra.
Qed.

(* A t that is exact, as the text has it. *)
Theorem enclosed_push_right p s q t f v sh V a other : exactly p s -> exactly q t -> exactly f V ->
  share_of_number rnd q sh -> factor_of_number rnd f v -> enclosed_push rnd p sh v (Some a) ->
  value a = nearest other (s + t * V).
Proof.
intros Hs Ht HV (x & Fx & t2 & -> & ->) Fv R.
destruct (factor_of_number_right choice q t x Ht Fx) as (h & Hh & Dh & X1 & X2 & _). cbv zeta in *.
pose proof (factor_of_number_right choice f V v HV Fv) as FV.
refine (pushed_right p s _ v V t (Rabs h) ((1 + / 2 ^ 20) * E * Rabs h) a other Hs FV _ R).
exists h. cbn [share_head share_tail share_error value magnitude]. cbv zeta. rewrite (exactly_value _ _ Ht).
destruct (size h) as [H0 H1]. split; [exact Hh|]. split; [exact Dh|]. split; [lra|]. split; [numbers|].
split; [exact X1|].
assert (K : (1 - / 2 ^ 23) * Rabs h <= Rabs t).
{ assert (B : Rabs (t - h) <= / 2 ^ 24 * Rabs h) by (clear - X1 X2 H0; bounds; apply le_abs; numbers).
  assert (Rabs h <= Rabs (t - h) + Rabs t); [|lra].
  rewrite Rabs_minus_sym. replace h with ((h - t) + t) at 1 by ring. apply Rabs_triang. }
destruct (size t) as [T0 _]. set (y := Rabs t) in *. set (z := Rabs h) in *.
destruct (near_pos choice (16 * E * y)) as [N _]; [numbers|]. clear - K H0 N. numbers.
Qed.
End Push.
