(* SPDX-License-Identifier: Apache-2.0 *)
(* Square roots of enclosures. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Filters Require Import arithmetic enclosed nearest enclosures add_multiply quotients.
Open Scope R_scope.

Section Root.
Variable choice : Z -> bool.
Hypothesis symmetric : forall x, choice x = negb (choice (- (x + 1))).
Notation rnd := (nearest choice).
Notation encloses := (encloses choice).

(* A rounded root squared. *)
Lemma root_squared x s : 0 <= x -> s = rnd (sqrt x) -> 0 <= s /\ Rabs (s * s - x) <= (2 + / 2 ^ 10) * u * x.
Proof.
intros P ->. pose proof (sqrt_pos x) as Q. destruct (near_pos choice (sqrt x) Q) as [A B].
set (s := rnd (sqrt x)) in *. set (y := sqrt x) in *. assert (YY : y * y = x) by now apply sqrt_sqrt.
assert (S0 : 0 <= s) by numbers. split; [exact S0|].
assert (M1 : ((1 - u) * y) * ((1 - u) * y) <= s * s) by (apply Rmult_le_compat; try assumption; numbers).
assert (M2 : s * s <= ((1 + u) * y) * ((1 + u) * y)) by (apply Rmult_le_compat; assumption).
replace (((1 - u) * y) * ((1 - u) * y)) with ((1 - u) * (1 - u) * x) in M1 by (rewrite <- YY; ring).
replace (((1 + u) * y) * ((1 + u) * y)) with ((1 + u) * (1 + u) * x) in M2 by (rewrite <- YY; ring).
clear - M1 M2 P. apply le_abs. numbers.
Qed.
Lemma squares_near x y a : 0 < y -> 0 <= x -> Rabs (x * x - y * y) <= a * (y * y) -> Rabs (x - y) <= a * y.
Proof.
intros Y X L. apply Rmult_le_reg_r with (x + y); [lra|]. rewrite <- (Rabs_right (x + y)) at 1 by lra.
rewrite <- Rabs_mult. replace ((x - y) * (x + y)) with (x * x - y * y) by ring. apply Rle_trans with (1 := L).
assert (0 <= a) by (apply Rmult_le_reg_r with (y * y); [nra|pose proof (Rabs_pos (x * x - y * y)); lra]).
replace (a * y * (x + y)) with (a * (y * y) + a * y * x) by ring.
assert (0 <= a * y * x) by (repeat apply Rmult_le_pos; lra). lra.
Qed.

Lemma root_near h l k v L s r rest i low : float h -> 0 < h -> L <= (1 + / 2 ^ 40) / 16 * h -> 0 <= L ->
  Rabs v <= L -> Rabs (l - v) <= u * L -> Rabs (k - v) <= u * L -> s = rnd (sqrt (rnd (h + l))) ->
  r = round radix2 (FLX_exp 26) Ztrunc s -> rest = rnd (rnd (h - r * r) + k) -> i = rnd (1 / rnd (s + r)) ->
  (low = rnd (rest * i) \/ low = rest * i) -> let Y := sqrt (h + k) in
  0 < Y /\ 0 < r /\ 0 < i /\ (1 - / 2 ^ 18) / 2 <= i * Y /\ Rabs (Y - (r + low)) <= 7 * E * r.
Proof.
intros Dh Ph BL L0 Bv Bl Bk Hs Hr Hrest Hi Hlow Y.
set (x := rnd (h + l)) in *. set (n := h + k) in *.
assert (B1 : 0 <= h + l <= 2 * h) by (bounds; numbers).
destruct (near_pos choice (h + l)) as [Nx1 Nx2]; [lra|]. fold x in Nx1, Nx2.
assert (Hn : 15 / 16 * (1 - / 2 ^ 30) * h <= n <= 17 / 16 * (1 + / 2 ^ 30) * h) by (unfold n; bounds; numbers).
assert (X0 : 0 <= x) by numbers.
destruct (root_squared x s X0 Hs) as [S0 SS].
assert (En : h + l = n + (l - v) - (k - v)) by (unfold n; ring).
assert (SN : Rabs (s * s - n) <= (7 / 2) * u * n).
{ replace (s * s - n) with ((s * s - x) + (x - (h + l)) + (l - v) - (k - v)) by (unfold n; ring).
  clear Hlow. bounds. apply le_abs. numbers. }
assert (N0 : 0 < n) by lra.
assert (Y0 : 0 < Y) by now apply sqrt_lt_R0. assert (YY : Y * Y = n) by (apply sqrt_sqrt; lra).
rewrite <- YY in SN. pose proof (squares_near _ _ _ Y0 S0 SN) as SY.
assert (Ps : 0 < s) by (clear - SY Y0; bounds; numbers).
pose proof (head_near s) as Rs. rewrite <- Hr in Rs.
assert (R0 : 0 <= r).
{ rewrite Hr, <- head_0. apply round_le; auto with typeclass_instances. }
rewrite (Rabs_right r) in Rs by lra.
assert (Pr : 0 < r) by (clear - Rs Ps R0; bounds; numbers).
assert (RR : Rabs (n - r * r) <= (2 + / 2 ^ 20) * T * (r * r)).
{ replace (n - r * r) with ((s - r) * (s + r) - (s * s - Y * Y)) by (rewrite <- YY; ring).
  assert (A : Rabs (s + r) <= (2 + T) * r) by (clear - Rs Ps Pr; bounds; apply le_abs; lra).
  pose proof (prod_le _ _ _ _ _ _ Rs A) as P. assert (YR : Y * Y <= 2 * (r * r)).
  { assert (YB : Y <= 5 / 4 * r) by (clear - SY Rs Pr Y0; bounds; numbers).
    assert (M : Y * Y <= (5 / 4 * r) * (5 / 4 * r)) by (apply Rmult_le_compat; lra).
    pose proof (Rmult_le_pos r r R0 R0). lra. }
  pose proof (Rmult_lt_0_compat _ _ Pr Pr). set (v1 := (s - r) * (s + r)) in *. clear - P SN YR H.
  bounds. apply le_abs. numbers. }
pose proof (Rmult_lt_0_compat _ _ Pr Pr) as PRR.
pose proof (head_digits s) as Dr. rewrite <- Hr in Dr.
assert (Exact : float (h - r * r)).
{ apply near_difference; [exact Dh|now apply head_product|]. rewrite (Rabs_right h) by lra.
  replace (h - r * r) with ((n - r * r) - (k - v) - v) by (unfold n; ring).
  assert (r * r <= 3 / 2 * h) by (clear - RR Hn Ph PRR; bounds; numbers).
  clear - H RR Bk Bv BL Ph L0. bounds. apply le_abs. numbers. }
rewrite (nearest_exact choice _ Exact) in Hrest. replace (h - r * r + k) with (n - r * r) in Hrest by (unfold n; ring).
pose proof (near choice _ _ RR) as Nr. rewrite <- Hrest in Nr.
set (D := Y + r).
assert (PD : 0 < D) by (unfold D; lra). assert (ND : D <> 0) by lra.
assert (HW : Rabs (rnd (s + r) - D) <= 3 * u * Rabs D).
{ rewrite (Rabs_right D) by lra. destruct (near_pos choice (s + r)) as [A B]; [lra|].
  assert (Y <= (1 + / 2 ^ 10) * r) by (clear - SY Rs Pr Y0; bounds; numbers).
  unfold D. clear - A B SY Y0 Pr H. bounds. apply le_abs. numbers. }
pose proof (inverse_near choice 3 _ D ND ltac:(lra) HW) as I. rewrite <- Hi in I.
assert (YD : (2 - / 2 ^ 20) * Y <= D <= (2 + / 2 ^ 20) * Y).
{ unfold D. clear - SY Rs Pr Y0. bounds. split; numbers. }
assert (I0 : 0 < i).
{ apply Rmult_lt_reg_r with D; [exact PD|]. clear - I. bounds. numbers. }
split; [exact Y0|]. split; [exact Pr|]. split; [exact I0|]. split.
- assert (A : i * D <= i * ((2 + / 2 ^ 20) * Y)) by (apply Rmult_le_compat_l; lra).
  clear - A I. replace (i * ((2 + / 2 ^ 20) * Y)) with ((2 + / 2 ^ 20) * (i * Y)) in A by ring. bounds. numbers.
- apply Rmult_le_reg_r with D; [exact PD|]. rewrite <- (Rabs_right D) at 1 by lra. rewrite <- Rabs_mult.
  replace ((Y - (r + low)) * D) with ((n - r * r) - low * D) by (unfold D; rewrite <- YY; ring).
  assert (N5 : Rabs (low * D - rest) <= 11 / 2 * u * Rabs rest).
  { assert (A : Rabs (rest * i * D - rest) <= 17 / 4 * u * Rabs rest).
    { replace (rest * i * D - rest) with ((i * D - 1) * rest) by ring. rewrite Rabs_mult.
      apply Rmult_le_compat_r; [apply Rabs_pos|]. lra. }
    assert (A' : Rabs ((low - rest * i) * D) <= u * Rabs (rest * i * D)).
    { apply scaled. destruct Hlow as [-> | ->]; [apply le_abs, near, Rle_refl|].
      rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. pose proof (Rabs_pos (rest * i)). numbers. }
    destruct (size_between _ _ _ A) as [B _]. pose proof (Rabs_pos rest) as P.
    replace (low * D - rest) with ((low - rest * i) * D + (rest * i * D - rest)) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _). clear - A A' B P. numbers. }
  assert (B5 : Rabs rest <= (2 + / 2 ^ 19) * T * (r * r)) by (clear - Nr RR PRR; bounds; apply le_abs; numbers).
  assert (N6 : Rabs (low * D - rest) <= (11 + / 2 ^ 10) * E * (r * r)) by (clear - N5 B5 PRR; numbers).
  assert (DR : (2 - / 2 ^ 19) * r <= D) by (unfold D; clear - SY Rs Pr Y0; bounds; numbers).
  assert (DR' : (2 - / 2 ^ 19) * (r * r) <= r * D).
  { replace ((2 - / 2 ^ 19) * (r * r)) with (r * ((2 - / 2 ^ 19) * r)) by ring. apply Rmult_le_compat_l; lra. }
  replace (n - r * r - low * D) with (- (rest - (n - r * r)) - (low * D - rest)) by ring.
  replace (7 * E * r * D) with (7 * E * (r * D)) by ring.
  clear - Nr N6 DR' PRR. bounds. apply le_abs. numbers.
Qed.

Theorem square_root_right x r X b : encloses x X -> settled rnd x b -> b = true -> 0 < value (enclosed_high x) ->
  square_root rnd x r -> encloses r (sqrt X).
Proof.
intros EX St Hb Ph R. pose proof EX as (h & Hh & SL & SE & BX).
pose proof (settled_right choice _ _ _ _ EX Hh St Hb) as Small. rewrite (exactly_value _ _ Hh) in Ph.
rewrite (Rabs_right h) in Small by lra.
destruct R as (t & (x1 & l & S1 & Sl & ->) & s & -> & t2 & (x2 & x3 & S2 & S3 & ->) & i & -> & t4 & -> & t5 &
  (x4 & x5 & S4 & S5 & ->) & rest & (x6 & k & S6 & Sk & ->) & t7 & -> & t8 & -> & t9 & -> & t10 & -> & t11 &
  (x9 & x10 & S9 & S10 & ->) & ->).
pose proof (proj2 Hh _ S1) as ->. pose proof (proj2 Hh _ S4) as ->. cbn [seen value head] in *. subst x2 x3 x6.
set (s := rnd (sqrt (rnd (h + l)))) in *. set (r := round radix2 (FLX_exp kept) Ztrunc s) in *.
pose proof (head_digits s : digits kept r) as Dr. pose proof (head_product r r Dr Dr) as Drr.
assert (x5 = r * r) as -> by (destruct S5 as [-> | ->]; [now apply nearest_exact|reflexivity]).
pose proof (seen_near choice _ _ SL Sl) as Nl. pose proof (seen_near choice _ _ SL Sk) as Nk.
destruct (size (value (enclosed_low x))) as [L0 L1]. set (v := value (enclosed_low x)) in *. set (L := Rabs v) in *.
pose proof (error_nonneg choice _ _ _ EX (seen_value _)) as E0. set (e := value (enclosed_error x)) in *.
pose proof (BX k e Sk (seen_value _)) as Bk.
set (i := rnd (1 / rnd (s + r))) in *. set (rest := rnd (rnd (h - r * r) + k)) in *.
assert (BL : L <= (1 + / 2 ^ 40) / 16 * h) by lra.
assert (K : forall low, (low = rnd (rest * i) \/ low = rest * i) -> let Y := sqrt (h + k) in
  0 < Y /\ 0 < r /\ 0 < i /\ (1 - / 2 ^ 18) / 2 <= i * Y /\ Rabs (Y - (r + low)) <= 7 * E * r).
{ intros low Hl. apply (root_near h l k v L s r rest i low); auto; try apply Hh. unfold L. lra. }
exists r. cbn [enclosed_high enclosed_low enclosed_error].
split; [apply exactly_plain; now apply digits_up with kept|]. split; [easy|]. split; [easy|].
intros low z Hl ->. destruct (K low Hl) as (Y0 & R0 & I0 & IY & Off). set (Y := sqrt (h + k)) in *.
assert (N0 : 7 / 8 * h <= h + k) by (clear - BL L0 L1 Nk Ph; bounds; numbers).
assert (YY : Y * Y = h + k) by (apply sqrt_sqrt; lra).
assert (PX : 9 / 16 * (Y * Y) <= X) by (rewrite YY; clear - Small L0 E0 Bk N0 Ph; bounds; numbers).
assert (Q0 : 0 <= X) by (pose proof (Rmult_lt_0_compat _ _ Y0 Y0); lra).
pose proof (sqrt_pos X) as Q. pose proof (sqrt_sqrt X Q0) as QQ. set (y := sqrt X) in *.
assert (YB : 3 / 4 * Y <= y).
{ apply Rnot_lt_le. intros C. assert (y * y < 3 / 4 * Y * (3 / 4 * Y)) by (apply Rmult_le_0_lt_compat; lra). lra. }
assert (D : Rabs (y - Y) * (7 / 4 * Y) <= e).
{ apply Rle_trans with (Rabs (y - Y) * Rabs (y + Y)).
  - apply Rmult_le_compat_l; [apply Rabs_pos|]. rewrite Rabs_right; lra.
  - rewrite <- Rabs_mult. replace ((y - Y) * (y + Y)) with (X - (h + k)) by (rewrite <- YY, <- QQ; ring). exact Bk. }
assert (D' : Rabs (y - Y) * (7 / 4) * ((1 - / 2 ^ 18) / 2) <= e * i).
{ apply Rle_trans with (Rabs (y - Y) * (7 / 4) * (i * Y)).
  - apply Rmult_le_compat_l; [|exact IY]. pose proof (Rabs_pos (y - Y)). lra.
  - replace (Rabs (y - Y) * (7 / 4) * (i * Y)) with (Rabs (y - Y) * (7 / 4 * Y) * i) by ring.
    apply Rmult_le_compat_r; lra. }
names (5 / 4) S9. names (8 * E) S10.
destruct (near_pos choice (5 / 4 * e)) as [N1 _]; [lra|]. set (t8 := rnd (5 / 4 * e)) in *.
assert (T8 : 0 <= t8) by numbers.
apply product_seen in S9; [|apply Rmult_le_pos; lra]. apply product_seen in S10; [|numbers].
assert (N2 : (1 - u) * (5 / 4 * (e * i)) <= t8 * i).
{ replace ((1 - u) * (5 / 4 * (e * i))) with ((1 - u) * (5 / 4 * e) * i) by ring. apply Rmult_le_compat_r; lra. }
assert (EI : 0 <= e * i) by (apply Rmult_le_pos; lra).
replace (y - (r + low)) with ((y - Y) + (Y - (r + low))) by ring.
set (ti := t8 * i) in *. set (ei := e * i) in *. clearbody ti ei.
pose proof (Rabs_pos (y - Y)) as DP.
destruct (near_pos choice (x9 + x10)) as [N3 _]; [clear - S9 S10 N2 R0 EI; numbers|].
apply Rle_trans with (1 := Rabs_triang _ _). clear - N3 S9 S10 N2 R0 EI D' Off DP. numbers.
Qed.
End Root.
