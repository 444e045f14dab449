(* SPDX-License-Identifier: Apache-2.0 *)
(* + and - of enclosures, and * of settled ones and of any. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core Sterbenz.
From Filters Require Import arithmetic enclosed nearest enclosures.
Open Scope R_scope.

Section Add.
Variable choice : Z -> bool.
Hypothesis symmetric : forall x, choice x = negb (choice (- (x + 1))).
Notation rnd := (nearest choice).
Notation encloses := (encloses choice).

Lemma product_seen a b x : 0 <= a * b -> seen (Product a b (rnd (a * b))) x -> (1 - u) * (a * b) <= x.
Proof. intros P [-> | ->]; [apply near_pos, P|numbers]. Qed.
Lemma error_nonneg x X e : encloses x X -> seen (enclosed_error x) e -> 0 <= e.
Proof.
intros (h & _ & _ & _ & B) S. apply Rle_trans with (2 := B _ _ (seen_value _) S), Rabs_pos.
Qed.
Lemma low_size p x : sound choice p -> seen p x -> Rabs x <= (1 + u) * Rabs (value p).
Proof.
intros S L. pose proof (seen_near choice p x S L). replace x with ((x - value p) + value p) by ring.
apply Rle_trans with (1 := Rabs_triang _ _). lra.
Qed.

Theorem add_right x y r X Y : encloses x X -> encloses y Y -> add rnd x y r -> encloses r (X + Y).
Proof.
intros EX EY R. pose proof EX as (hx & Hx & Lx & Ex & Bx). pose proof EY as (hy & Hy & Ly & Ey & By).
destruct R as (p & R & t1 & (z1 & z2 & S1 & S2 & ->) & size' & (z3 & z4 & S3 & S4 & ->) & t3 &
  (lx & ly & Slx & Sly & ->) & t4 & (z5 & z6 & S5 & S6 & ->) & t5 & (ex & ey & Sex & Sey & ->) & t6 & -> &
  t7 & -> & t8 & (z7 & z8 & S7 & S8 & ->) & ->).
destruct (two_sum_right choice symmetric _ _ _ _ _ Hx Hy R) as (h & l & -> & Hh & Dl & Exact).
cbn [seen value magnitude pair_low pair_high] in *. subst z1 z2 z3 z4 z5 z6.
exists h. cbn [enclosed_high enclosed_low enclosed_error].
split; [apply exactly_plain; rewrite Hh; apply nearest_digits|].
split; [easy|]. split; [easy|]. intros low e -> ->.
specialize (Bx lx ex Slx Sex). specialize (By ly ey Sly Sey).
pose proof (error_nonneg _ _ _ EX Sex) as Ex0. pose proof (error_nonneg _ _ _ EY Sey) as Ey0.
pose proof (low_size _ _ Lx Slx) as Blx. pose proof (low_size _ _ Ly Sly) as Bly.
destruct (size (value (enclosed_low x))) as [A0 _], (size (value (enclosed_low y))) as [B0 _], (size l) as [M0 M1].
set (a := Rabs (value (enclosed_low x))) in *. set (b := Rabs (value (enclosed_low y))) in *. set (m := Rabs l) in *.
assert (C1 : Rabs (lx + ly) <= (1 + u) * (a + b)) by (bounds; apply le_abs; lra).
pose proof (near choice _ _ C1) as N1. set (t := rnd (lx + ly)) in *.
assert (C2 : Rabs (l + t) <= m + (1 + u) * (1 + u) * (a + b)) by (bounds; apply le_abs; numbers).
pose proof (near choice _ _ C2) as N2.
destruct (near_pos choice (a + b)) as [P1 _]; [lra|]. set (s1 := rnd (a + b)) in *.
destruct (near_pos choice (s1 + m)) as [P2 _]; [numbers|]. set (s2 := rnd (s1 + m)) in *.
destruct (near_pos choice (ex + ey)) as [P3 _]; [lra|]. set (s3 := rnd (ex + ey)) in *.
names (5 / 4) S7. names (3 * u) S8. apply product_seen in S7; [|numbers]. apply product_seen in S8; [|numbers].
destruct (near_pos choice (z7 + z8)) as [P4 _]; [numbers|].
clearbody a b m t s1 s2 s3. clear R Hx Hy Lx Ly Ex Ey EX EY Slx Sly Sex Sey.
replace (X + Y - (h + rnd (l + t))) with ((X - (hx + lx)) + (Y - (hy + ly)) - (t - (lx + ly)) - (rnd (l + t) - (l + t)))
  by lra.
bounds. apply le_abs; numbers.
Qed.
Lemma negate_right x r X : encloses x X -> negate x r -> encloses r (- X).
Proof.
intros (h & Hh & L & E & B) ->. exists (- h). cbn [enclosed_high enclosed_low enclosed_error].
split; [now apply exactly_negated|]. split; [now apply sound_negated|]. split; [exact E|]. intros l e Sl Se.
replace (- X - (- h + l)) with (- (X - (h + - l))) by ring. rewrite Rabs_Ropp. apply B; [|exact Se].
now apply seen_negated.
Qed.
Theorem subtract_right x y r X Y : encloses x X -> encloses y Y -> subtract rnd x y r -> encloses r (X - Y).
Proof.
intros HX HY (t & N & s & A & ->). apply (add_right x t s X (- Y) HX); [|exact A]. now apply negate_right with y.
Qed.

(* settled numbers *)
Lemma settled_right x X b h : encloses x X -> exactly (enclosed_high x) h -> settled rnd x b -> b = true ->
  Rabs (value (enclosed_low x)) + value (enclosed_error x) <= (1 + / 2 ^ 40) / 16 * Rabs h.
Proof.
intros EX Hh (t & (z1 & e & S1 & Se & ->) & t1 & -> & b' & C & ->) ->. destruct C as [C _]. specialize (C eq_refl).
names 16 C. cbn [seen value magnitude] in *. subst z1. rewrite (exactly_value _ _ Hh) in C.
pose proof (error_nonneg _ _ _ EX Se) as E0. pose proof (error_nonneg _ _ _ EX (seen_value _)) as E1.
destruct EX as (h' & _ & L & E & _). pose proof (seen_near choice _ _ E Se) as N.
rewrite (Rabs_right (value (enclosed_error x))) in N by lra.
destruct (size (value (enclosed_low x))) as [A0 _]. set (a := Rabs (value (enclosed_low x))) in *.
destruct (near_pos choice (a + e)) as [P1 _]; [lra|].
destruct (near_pos choice (16 * rnd (a + e))) as [P2 _]; [numbers|]. bounds. numbers.
Qed.
Lemma near_difference x y : float x -> float y -> Rabs (x - y) <= / 4 * Rabs x -> float (x - y).
Proof.
intros X Y. unfold Rabs at 2. destruct (Rcase_abs x) as [N|N]; intros L; apply abs_le in L.
- replace (x - y) with (- (- x - - y)) by ring. apply generic_format_opp.
  apply sterbenz; auto using generic_format_opp with typeclass_instances; lra.
- apply sterbenz; auto with typeclass_instances; lra.
Qed.

(* What a settled number is factored to: some number X0 of the enclosure's middle. *)
Lemma factor_of_enclosed_right x X b f : encloses x X -> settled rnd x b -> b = true -> factor_of_enclosed rnd x f ->
  exists X0, factors (3 / 2) f X0 /\ Rabs (X - X0) <= value (enclosed_error x) /\
    value (enclosed_error x) <= / 14 * Rabs (value (factor_head f)) /\ 0 <= value (enclosed_error x) /\
    Rabs (value (enclosed_high x)) <= 2 * Rabs (value (factor_head f)).
Proof.
intros EX HS HB R. pose proof EX as (h & Hh & L & E & B).
pose proof (settled_right _ _ _ _ EX Hh HS HB) as St.
pose proof (error_nonneg _ _ _ EX (seen_value _)) as E0.
destruct R as (w & (h1 & l1 & S1 & Sl1 & ->) & t1 & (h2 & k' & S2 & S3 & ->) & t2 & (z1 & l & S4 & Sl & ->) & ->).
pose proof (proj2 Hh _ S1) as ->. pose proof (proj2 Hh _ S2) as ->. cbn [seen head value] in *. subst k' z1.
cbn [factor_head factor_tail factor_whole].
set (w := rnd (h + l1)) in *. set (k := round radix2 (FLX_exp kept) Ztrunc w) in *.
change (value (head kept (Plain w))) with k.
assert (Dw : float w) by apply nearest_digits.
pose proof (head_digits w : digits kept k) as K. pose proof (head_near w : Rabs (w - k) <= T * Rabs k) as N.
pose proof (seen_near choice _ _ L Sl1) as L1. pose proof (seen_near choice _ _ L Sl) as L2.
destruct (size (value (enclosed_low x))) as [A0 A1], (size k) as [K0 K1], (size h) as [H0 H1].
set (a := Rabs (value (enclosed_low x))) in *. set (v := value (enclosed_low x)) in *.
set (e := value (enclosed_error x)) in *.
assert (Bw : Rabs (h + l1) <= 17 / 16 * (1 + / 2 ^ 30) * Rabs h) by (bounds; apply le_abs; numbers).
pose proof (near choice _ _ Bw) as Nw. fold w in Nw.
assert (Hk : Rabs (h - k) <= (1 + / 2 ^ 20) / 16 * Rabs h + T * Rabs k) by (bounds; apply le_abs; numbers).
assert (Tr : Rabs h <= Rabs (h - k) + Rabs k).
{ replace h with ((h - k) + k) at 1 by ring. apply Rabs_triang. }
assert (Tr' : Rabs k <= Rabs (h - k) + Rabs h).
{ rewrite Rabs_minus_sym. generalize (Rabs_triang_inv k h). lra. }
assert (AC : Rabs h <= 16 / 15 * (1 + / 2 ^ 19) * Rabs k) by numbers.
assert (AC2 : Rabs h <= 2 * Rabs k) by (clear - AC K0; numbers).
assert (Dk : Rabs (h - k) <= / 4 * Rabs h) by numbers.
rewrite (nearest_exact choice (h - k)) in *
  by (apply near_difference; [apply Hh|now apply digits_up with kept|exact Dk]).
set (A := Rabs h) in *. set (C := Rabs k) in *. clearbody a.
assert (Bt : Rabs (h - k + l) <= (1 + / 2 ^ 21) * T * C) by (bounds; apply le_abs; numbers).
pose proof (near choice _ _ Bt) as Nt. pose proof (B l e Sl (seen_value _)) as Be.
exists (h + l). split; [|split; [exact Be|split; [numbers|split; [exact E0|]]]].
2: { rewrite (exactly_value _ _ Hh). exact AC2. }
exists k. cbn [factor_head factor_tail factor_whole]. split; [apply exactly_plain; now apply digits_up with kept|].
split; [exact K|]. cbv zeta. change (value (Plain ?x)) with x. try fold C.
clear EX HS B E Hh Dw K S1 Sl1 S2 Sl L Be.
bounds. repeat split; apply le_abs; numbers.
Qed.

Theorem multiply_right x y r X Y b c : encloses x X -> encloses y Y -> settled rnd x b -> b = true ->
  settled rnd y c -> c = true -> multiply rnd x y r -> encloses r (X * Y).
Proof.
intros EX EY Sx Hb Sy Hc (f & Ff & g & Fg & t & P & t3 & -> & t4 & -> & t5 & (z3 & z4 & S3 & S4 & ->) & t6 & -> &
  t7 & -> & t8 & (z6 & z7 & S6 & S7 & ->) & ->).
destruct (factor_of_enclosed_right _ _ _ _ EX Sx Hb Ff) as (X0 & FX & BX & BE & E0 & _).
destruct (factor_of_enclosed_right _ _ _ _ EY Sy Hc Fg) as (Y0 & FY & BY & BF & F0 & _).
destruct (product_right choice (3 / 2) (3 / 2) f g X0 Y0 t ltac:(lra) FX FY P) as (h & Hh & St & Bt).
exists h. cbn [enclosed_high enclosed_low enclosed_error]. split; [exact Hh|]. split; [exact St|]. split; [easy|].
intros l e Sl ->. destruct (Bt l Sl) as [B1 _]. clear Bt.
destruct FX as (hx & Hx & Dx & X1 & X2 & X3), FY as (hy & Hy & Dy & Y1 & Y2 & Y3).
destruct P as (p & -> & p1 & _ & p2 & _ & p3 & _ & ->). cbn [term2_head term2_tail] in *.
pose proof (exactly_value _ _ Hh) as Vh.
rewrite (exactly_value _ _ Hx) in *. rewrite (exactly_value _ _ Hy) in *. cbn [value magnitude] in *. rewrite Vh in *.
pose proof (head_product hx hy Dx Dy) as Dxy. rewrite (nearest_exact choice _ Dxy) in Vh. subst h.
rewrite Rabs_mult in *.
set (wx := value (factor_whole f)) in *. set (wy := value (factor_whole g)) in *.
set (e := value (enclosed_error x)) in *. set (d := value (enclosed_error y)) in *.
destruct (size hx) as [A0 A1], (size hy) as [C0 C1]. set (A := Rabs hx) in *. set (C := Rabs hy) in *.
assert (SX : Rabs X0 <= (1 + / 2 ^ 23) * A) by (clear Y1 Y2 Y3; bounds; apply le_abs; numbers).
assert (SY : Rabs Y0 <= (1 + / 2 ^ 23) * C) by (clear X1 X2 X3; bounds; apply le_abs; numbers).
assert (WX : (1 - / 2 ^ 22) * A <= Rabs wx).
{ pose proof (Rabs_triang_inv hx (hx - wx)) as R. replace (hx - (hx - wx)) with wx in R by ring.
  assert (Rabs (hx - wx) <= / 2 ^ 22 * A) by (clear Y1 Y2 Y3 R; bounds; apply le_abs; numbers). fold A in R. lra. }
assert (WY : (1 - / 2 ^ 22) * C <= Rabs wy).
{ pose proof (Rabs_triang_inv hy (hy - wy)) as R. replace (hy - (hy - wy)) with wy in R by ring.
  assert (Rabs (hy - wy) <= / 2 ^ 22 * C) by (clear X1 X2 X3 R; bounds; apply le_abs; numbers). fold C in R. lra. }
assert (BX1 : Rabs (X - X0) <= 1 * e) by lra. assert (BY1 : Rabs (Y - Y0) <= 1 * d) by lra.
assert (SY' : Rabs Y <= 15 / 14 * (1 + / 2 ^ 20) * C) by (clear X1 X2 X3 Y1 Y2 Y3; bounds; apply le_abs; numbers).
pose proof (prod_le _ _ _ _ _ _ SX BY1) as Q1. pose proof (prod_le _ _ _ _ _ _ BX1 SY') as Q2.
assert (WX' : (1 - / 2 ^ 22) * (A * d) <= Rabs wx * d) by (rewrite <- Rmult_assoc; now apply Rmult_le_compat_r).
assert (WY' : (1 - / 2 ^ 22) * (e * C) <= Rabs wy * e).
{ rewrite (Rmult_comm e), <- Rmult_assoc. now apply Rmult_le_compat_r. }
assert (P1 : 0 <= A * d) by now apply Rmult_le_pos. assert (P2 : 0 <= e * C) by now apply Rmult_le_pos.
assert (P3 : 0 <= A * C) by now apply Rmult_le_pos.
replace (X * Y - (hx * hy + l)) with ((X0 * Y0 - (hx * hy + l)) + X0 * (Y - Y0) + (X - X0) * Y) by ring.
set (q1 := X0 * (Y - Y0)) in *. set (q2 := (X - X0) * Y) in *. set (q := X0 * Y0 - (hx * hy + l)) in *.
apply product_seen in S3; [|numbers]. apply product_seen in S4; [|numbers].
set (xe := Rabs wx * d) in *. set (ye := Rabs wy * e) in *. set (Ad := A * d) in *. set (eC := e * C) in *.
set (AC := A * C) in *. clearbody q q1 q2 xe ye Ad eC AC.
destruct (near_pos choice (z3 + z4)) as [N1 _]; [numbers|].
names (5 / 4) S6. names (10 * E) S7. apply product_seen in S6; [|numbers]. apply product_seen in S7; [|numbers].
destruct (near_pos choice (z6 + z7)) as [N2 _]; [numbers|].
clear X1 X2 X3 Y1 Y2 Y3 BX BY BX1 BY1 SX SY SY' WX WY. bounds. apply le_abs; numbers.
Qed.

(* any numbers of the format *)
Theorem in_order_right x r X : encloses x X -> float (value (enclosed_low x)) -> in_order rnd x r ->
  exists V, pair_of choice r V /\ Rabs (X - V) <= value (enclosed_error x).
Proof.
intros (h & Hh & L & _ & B) D (t & (l & z & Sl & Sz & ->) & r' & R & ->). cbn [seen] in Sz. subst z.
assert (V : rnd (l + 0) = value (enclosed_low x)).
{ rewrite Rplus_0_r. destruct (enclosed_low x) as [a | a b p]; cbn [seen value] in *.
  - subst l. now apply nearest_exact.
  - destruct Sl as [-> | ->]; [now apply nearest_exact|now symmetry]. }
rewrite V in R. exists (h + value (enclosed_low x)). split.
- apply (two_sum_right choice symmetric _ _ _ _ _ Hh (exactly_plain _ D) R).
- apply B; apply seen_value.
Qed.

Theorem times_right x y r X Y : encloses x X -> encloses y Y -> float (value (enclosed_low x)) ->
  float (value (enclosed_low y)) -> times rnd x y r -> encloses r (X * Y).
Proof.
intros EX EY Dx' Dy' (p & Px & f & Ff & p' & Py & g & Fg & t & P & t5 & -> & t6 & -> & t7 &
  (z5 & z6 & S5 & S6 & ->) & t8 & -> & t9 & (z7 & z8 & S7 & S8 & ->) & t10 & -> & t11 & -> & t12 &
  (z10 & z11 & S10 & S11 & ->) & ->).
destruct (in_order_right _ _ _ EX Dx' Px) as (X0 & OX & BX), (in_order_right _ _ _ EY Dy' Py) as (Y0 & OY & BY).
pose proof (factor_of_pair_right _ _ _ _ OX Ff) as FX. pose proof (factor_of_pair_right _ _ _ _ OY Fg) as FY.
pose proof (error_nonneg _ _ _ EX (seen_value _)) as E0. pose proof (error_nonneg _ _ _ EY (seen_value _)) as F0.
destruct (product_right choice (1 + / 2 ^ 20) (1 + / 2 ^ 20) f g X0 Y0 t ltac:(lra) FX FY P) as (h & Hh & St & Bt).
exists h. cbn [enclosed_high enclosed_low enclosed_error]. split; [exact Hh|]. split; [exact St|]. split; [easy|].
intros l e' Sl ->. destruct (Bt l Sl) as [B1 _]. clear Bt.
destruct FX as (hx & Hx & Dx & X1 & X2 & X3), FY as (hy & Hy & Dy & Y1 & Y2 & Y3).
destruct P as (p0 & -> & p1 & _ & p2 & _ & p3 & _ & ->). cbn [term2_head term2_tail] in *.
pose proof (exactly_value _ _ Hh) as Vh.
rewrite (exactly_value _ _ Hx) in *. rewrite (exactly_value _ _ Hy) in *. cbn [value magnitude seen] in *.
rewrite Vh in *.
pose proof (head_product hx hy Dx Dy) as Dxy. rewrite (nearest_exact choice _ Dxy) in Vh. subst h. subst z7.
rewrite Rabs_mult in *.
set (wx := value (factor_whole f)) in *. set (wy := value (factor_whole g)) in *.
set (e := value (enclosed_error x)) in *. set (d := value (enclosed_error y)) in *.
destruct (size hx) as [A0 A1], (size hy) as [C0 C1]. set (A := Rabs hx) in *. set (C := Rabs hy) in *.
assert (SX : Rabs X0 <= (1 + / 2 ^ 23) * A) by (clear Y1 Y2 Y3; bounds; apply le_abs; numbers).
assert (SY : Rabs Y0 <= (1 + / 2 ^ 23) * C) by (clear X1 X2 X3; bounds; apply le_abs; numbers).
assert (WX : (1 - / 2 ^ 22) * A <= Rabs wx).
{ pose proof (Rabs_triang_inv hx (hx - wx)) as R. replace (hx - (hx - wx)) with wx in R by ring.
  assert (Rabs (hx - wx) <= / 2 ^ 22 * A) by (clear Y1 Y2 Y3 R; bounds; apply le_abs; numbers). fold A in R. lra. }
assert (WY : (1 - / 2 ^ 22) * C <= Rabs wy).
{ pose proof (Rabs_triang_inv hy (hy - wy)) as R. replace (hy - (hy - wy)) with wy in R by ring.
  assert (Rabs (hy - wy) <= / 2 ^ 22 * C) by (clear X1 X2 X3 R; bounds; apply le_abs; numbers). fold C in R. lra. }
assert (BX1 : Rabs (X - X0) <= 1 * e) by lra. assert (BY1 : Rabs (Y - Y0) <= 1 * d) by lra.
pose proof (prod_le _ _ _ _ _ _ SX BY1) as Q1. pose proof (prod_le _ _ _ _ _ _ BX1 SY) as Q2.
pose proof (prod_le _ _ _ _ _ _ BX1 BY1) as Q3.
assert (WX' : (1 - / 2 ^ 22) * (A * d) <= Rabs wx * d) by (rewrite <- Rmult_assoc; now apply Rmult_le_compat_r).
assert (WY' : (1 - / 2 ^ 22) * (e * C) <= Rabs wy * e).
{ rewrite (Rmult_comm e), <- Rmult_assoc. now apply Rmult_le_compat_r. }
assert (P1 : 0 <= A * d) by now apply Rmult_le_pos. assert (P2 : 0 <= e * C) by now apply Rmult_le_pos.
assert (P3 : 0 <= A * C) by now apply Rmult_le_pos. assert (P4 : 0 <= e * d) by now apply Rmult_le_pos.
replace (X * Y - (hx * hy + l)) with
  ((X0 * Y0 - (hx * hy + l)) + X0 * (Y - Y0) + (X - X0) * Y0 + (X - X0) * (Y - Y0)) by ring.
set (q1 := X0 * (Y - Y0)) in *. set (q2 := (X - X0) * Y0) in *. set (q3 := (X - X0) * (Y - Y0)) in *.
set (q := X0 * Y0 - (hx * hy + l)) in *.
apply product_seen in S5; [|numbers]. apply product_seen in S6; [|numbers]. apply product_seen in S8; [|numbers].
set (xe := Rabs wx * d) in *. set (ye := Rabs wy * e) in *. set (Ad := A * d) in *. set (eC := e * C) in *.
set (ed := e * d) in *. set (AC := A * C) in *. clearbody q q1 q2 q3 xe ye ed Ad eC AC.
destruct (near_pos choice (z5 + z6)) as [N1 _]; [numbers|]. set (s1 := rnd (z5 + z6)) in *.
destruct (near_pos choice (s1 + z8)) as [N2 _]; [numbers|]. set (s2 := rnd (s1 + z8)) in *.
names (5 / 4) S10. names (10 * E) S11. apply product_seen in S10; [|numbers]. apply product_seen in S11; [|numbers].
destruct (near_pos choice (z10 + z11)) as [N3 _]; [numbers|]. clearbody s1 s2.
clear X1 X2 X3 Y1 Y2 Y3 BX BY BX1 BY1 SX SY WX WY. bounds. apply le_abs; numbers.
Qed.
End Add.
