(* SPDX-License-Identifier: Apache-2.0 *)
(* segments of filters.h. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Filters Require Import model constants filters steps ghost tactics.
Open Scope R_scope.

Section Wrong.
Variable u : R.
Hypothesis Hu : 0 < u <= 1/1024.
Let k := 4 * u + 7 * u ^ 2.

Lemma off_four x t T : off u 4 x t T -> 0 <= T /\ Rabs t <= T /\ Rabs (x - t) <= k * T.
Proof. apply off_by. unfold k. fine_powers u Hu. lra. Qed.

(* what the roundings of three sums come to *)
Lemma sums_rounded p d m e1 e2 e3 e4 : Rabs e1 <= u -> Rabs e2 <= u -> Rabs e3 <= u -> Rabs e4 <= u ->
  let g := Rabs (p - d) + Rabs m in
  let r := u * (1 + u) ^ 2 * Rabs p + u * (2 + u) * g in
  g - r <= (Rabs ((p * (1 + e1) - d) * (1 + e2)) + Rabs (m * (1 + e3))) * (1 + e4) <= g + r.
Proof.
intros E1 E2 E3 E4 g r. pose proof (near _ _ _ (rounding u m e3 E3)) as RM. set (q := p * (1 + e1) - d) in *.
assert (RQ : Rabs (p - d) - u * Rabs p <= Rabs q <= Rabs (p - d) + u * Rabs p).
{ apply near. replace (q - (p - d)) with (p * (1 + e1) - p) by (unfold q; ring). apply rounding, E1. }
pose proof (near _ _ _ (rounding u q e2 E2)) as RX.
set (X := Rabs (q * (1 + e2))) in *. set (Y := Rabs (m * (1 + e3))) in *.
assert (XY : 0 <= X + Y) by (apply Rplus_le_le_0_compat; apply Rabs_pos).
pose proof (rounding u (X + Y) e4 E4) as RN. rewrite (Rabs_right (X + Y)) in RN by lra. apply abs_le in RN.
assert (u * Rabs q <= u * (Rabs (p - d) + u * Rabs p)) by (apply Rmult_le_compat_l; lra).
assert (u * (X + Y) <= u * (g + u * (1 + u) * Rabs p + u * g)) by (apply Rmult_le_compat_l; unfold g; lra).
unfold r, g in *. clearbody X Y q. clear E1 E2 E3 E4. lra.
Qed.

(* rs0, rf0, sf0: the cross products; rs, rf, sf: as computed; a, b, c: the sums of the magnitudes of their terms *)
Variables rs0 rf0 sf0 rs rf sf a b c E : R.
Hypothesis Ors : off u 4 rs rs0 a.
Hypothesis Orf : off u 4 rf rf0 b.
Hypothesis Osf : off u 4 sf sf0 c.
Hypothesis L : a + b + c <= E.

Theorem segments_wrong e1 e2 e3 e4 : Rabs e1 <= u -> Rabs e2 <= u -> Rabs e3 <= u -> Rabs e4 <= u ->
  let N := (Rabs (((sf + rf) * (1 + e1) - rs) * (1 + e2)) + Rabs ((sf - rf) * (1 + e3))) * (1 + e4) in
  let N0 := Rabs (sf0 + rf0 - rs0) + Rabs (sf0 - rf0) in
  let K := (10 * u + 50 * u ^ 2) * E in
  (N0 <= Rabs rs0 -> N - Rabs rs <= K) /\ (Rabs rs0 <= N0 -> Rabs rs - N <= K).
Proof.
intros E1 E2 E3 E4 N N0 K. pose proof (sums_rounded (sf + rf) rs (sf - rf) e1 e2 e3 e4 E1 E2 E3 E4) as RN.
cbv zeta in RN. fold N in RN. clearbody N. clear e1 e2 e3 e4 E1 E2 E3 E4.
destruct (off_four _ _ _ Ors) as (a0 & A0 & DD), (off_four _ _ _ Orf) as (b0 & B0 & DR),
  (off_four _ _ _ Osf) as (c0 & C0 & DS).
pose proof (near _ _ _ DD) as ND. apply abs_le in DD, DR, DS.
assert (NP : Rabs (sf + rf) <= (1 + k) * (b + c)).
{ assert (Rabs (sf + rf) <= Rabs (sf0 + rf0) + k * (b + c)) by (apply near, le_abs; lra).
  pose proof (Rabs_triang sf0 rf0). lra. }
assert (NQ : Rabs (sf0 + rf0 - rs0) - k * (a + b + c) <= Rabs (sf + rf - rs) <=
  Rabs (sf0 + rf0 - rs0) + k * (a + b + c)) by (apply near, le_abs; lra).
assert (NM : Rabs (sf0 - rf0) - k * (b + c) <= Rabs (sf - rf) <= Rabs (sf0 - rf0) + k * (b + c))
  by (apply near, le_abs; lra).
pose proof (Rabs_pos (sf + rf)) as P0. pose proof (Rabs_pos rs) as Q0.
set (g := Rabs (sf + rf - rs) + Rabs (sf - rf)) in *.
assert (NG : N0 - k * (a + 2 * b + 2 * c) <= g <= N0 + k * (a + 2 * b + 2 * c)) by (unfold g, N0; lra).
assert (g0 : 0 <= g) by (apply Rplus_le_le_0_compat; apply Rabs_pos).
clearbody g N0. clear NQ NM DD DR DS B0 C0 Ors Orf Osf.
generalize dependent (Rabs (sf + rf)). generalize dependent (Rabs rs). generalize dependent (Rabs rs0).
intros d0 A0 d ND Q0 p RN NP P0. unfold K. clear K rs0 rf0 sf0 rs rf sf. set (s := b + c) in *.
fine_powers u Hu. assert (k0 : 0 <= k <= 5 * u) by (unfold k; lra). assert (s0 : 0 <= s) by (unfold s; lra).
assert (E0 : 0 <= E) by (unfold s in *; lra).
assert (LE : k * (a + s) <= k * E) by (apply Rmult_le_compat_l; unfold s; lra).
assert (ka : k * a <= 5 * u * a) by (apply Rmult_le_compat_r; lra).
assert (ua : u * a <= 1/1024 * a) by (apply Rmult_le_compat_r; lra).
assert (T : u * (1 + u) ^ 2 * p <= u * (1 + u) ^ 2 * ((1 + k) * s)) by (apply Rmult_le_compat_l; lra).
assert (V : u * (2 + u) * (1 + k) * a + u * (1 + u) ^ 2 * (1 + k) * s <= (2 * u + 12 * u ^ 2) * E).
{ apply Rle_trans with ((2 * u + 12 * u ^ 2) * (a + s)); [|apply Rmult_le_compat_l; unfold s; lra].
  rewrite (Rmult_plus_distr_l (2 * u + 12 * u ^ 2)). apply Rplus_le_compat; apply Rmult_le_compat_r; unfold k; lra. }
(* where the sign is wrong, the sums come to about |rs| at most *)
assert (W : g <= d + 9 * u * E -> u * (1 + u) ^ 2 * p + u * (2 + u) * g + 2 * k * E <= (10 * u + 50 * u ^ 2) * E).
{ intros W. assert (u * (2 + u) * g <= u * (2 + u) * ((1 + k) * a + 9 * u * E)) by (apply Rmult_le_compat_l; lra).
  assert (X : (2 * k + u * (2 + u) * 9 * u + (2 * u + 12 * u ^ 2)) * E <= (10 * u + 50 * u ^ 2) * E)
    by (apply Rmult_le_compat_r; unfold k; lra).
  lra. }
assert (uE : 0 <= u * E) by (apply Rmult_le_pos; lra).
assert (kE : k * E <= (4 + 1/8) * u * E) by (apply Rmult_le_compat_r; unfold k; lra).
split; intros C.
- specialize (W ltac:(unfold s in *; lra)). unfold s in *; lra.
- apply Rnot_lt_le. intros B.
  assert (K0 : 0 <= (10 * u + 50 * u ^ 2) * E) by (apply Rmult_le_pos; lra).
  assert (p1 : u * (1 + u) ^ 2 * ((1 + k) * s) <= 11/10 * u * E).
  { apply Rle_trans with (11/10 * u * s); [|apply Rmult_le_compat_l; unfold s; lra].
    rewrite <- Rmult_assoc. apply Rmult_le_compat_r; unfold k; lra. }
  assert (g1 : u * (2 + u) * g <= 21/10 * u * g) by (apply Rmult_le_compat_r; lra).
  assert (ug : u * g <= 1/1024 * g) by (apply Rmult_le_compat_r; lra).
  assert (uE' : u * E <= 1/1024 * E) by (apply Rmult_le_compat_r; lra).
  assert (g2 : g <= 11/10 * E) by (unfold s in *; lra).
  assert (ug2 : u * g <= u * (11/10 * E)) by (apply Rmult_le_compat_l; lra).
  specialize (W ltac:(unfold s in *; lra)). unfold s in *; lra.
Qed.
End Wrong.

Lemma nine u : 0 < u <= 1/1024 -> 1 - 9 * u <= (1 - u) ^ 9.
Proof. intros Hu. pose proof (bernoulli_down u ltac:(lra) 9) as B. simpl in B |- *. lra. Qed.
Lemma segments_enough u : 0 < u <= 1/1024 -> (1 + u) * (10 * u + 50 * u ^ 2) <= (1 - u) ^ 9 * relative 24 240 u.
Proof.
intros Hu. pose proof (nine u Hu). unfold relative. pose proof (power_fine u 1 Hu). pose proof (power_fine u 2 Hu).
apply Rle_trans with ((1 - 9 * u) * (24 * (u / 2) + 240 * u * u)); [|apply Rmult_le_compat_r]; lra.
Qed.

(* exact: the greater of |2 sf - rs| and |2 rf - rs|, less |rs| (lemma larger); segments_meet says what that means *)
Theorem segments_right F aax aay abx aby bax bay bbx bby answer : fits F (third F) 1 1 ->
  segments F R (reals F) aax aay abx aby bax bay bbx bby answer ->
  let rs := (abx - aax) * (bby - bay) - (aby - aay) * (bbx - bax) in
  let rf := (abx - aax) * (aay - bay) - (aby - aay) * (aax - bax) in
  let sf := (bbx - bax) * (aay - bay) - (bby - bay) * (aax - bax) in
  let exact := Rabs (sf + rf - rs) + Rabs (sf - rf) - Rabs rs in
  (answer = positive -> exact > 0) /\ (answer = negative -> exact < 0).
Proof.
intros G R rs rf sf exact. unfold segments in R. unpack. constants. flags R. nonneg. guarded G. parts G.
differences G. normal G 24 240 13%Z. steps G.
bounded G 512%Z lows Pos Neg.
assert (Hf : 0 < u F <= 1/1024) by (destruct G; lra).
match type of Pos with _ -> ((Rabs (((?sf1 + ?rf1) * (1 + ?ea) - ?rs1) * (1 + ?eb)) + Rabs (_ * (1 + ?ec))) *
  (1 + ?ed) - _) * _ > _ * (_ * ?X * ?Y) =>
  eassert (Ors : off (u F) _ rs1 _ _) by offs Hu; eassert (Orf : off (u F) _ rf1 _ _) by offs Hu;
  eassert (Osf : off (u F) _ sf1 _ _) by offs Hu; cbn [Nat.add Nat.max] in Ors, Orf, Osf;
  match type of Ors with off _ _ _ _ ?a => match type of Orf with off _ _ _ _ ?b =>
  match type of Osf with off _ _ _ _ ?c =>
    assert (LE : a + b + c <= X * Y) by units;
    destruct (segments_wrong (u F) Hf rs rf sf rs1 rf1 sf1 a b c (X * Y) Ors Orf Osf LE ea eb ec ed) as [W1 W2];
      try assumption end end end end.
in_extents G Pos (10 * u F + 50 * u F ^ 2) (segments_enough (u F) Hf) P' Q'.
clear - Pos Neg P' Q' W1 W2 R. unfold exact. signs R Pos Neg P' Q' W1 W2.
Qed.

Lemma larger s r d : Rabs (s + r - d) + Rabs (s - r) = Rmax (Rabs (2 * s - d)) (Rabs (2 * r - d)).
Proof. unfold Rmax, Rabs. repeat destruct Rcase_abs; destruct Rle_dec; lra. Qed.
Lemma between_ends s d : Rabs (2 * s - d) < Rabs d -> d <> 0 /\ 0 < s / d < 1.
Proof.
intros L. assert (D : d <> 0) by (intros ->; rewrite Rabs_R0 in L; generalize (Rabs_pos (2 * s - 0)); lra).
split; [exact D|]. replace (2 * s - d) with (d * (2 * (s / d) - 1)) in L by (now field).
rewrite Rabs_mult in L. apply Rabs_pos_lt in D. assert (M : Rabs (2 * (s / d) - 1) < 1).
{ apply Rmult_lt_reg_l with (1 := D). lra. } apply Rabs_def2 in M. lra.
Qed.
Lemma not_beyond t d : 0 <= t <= 1 -> Rabs (2 * (t * d) - d) <= Rabs d.
Proof.
intros T. replace (2 * (t * d) - d) with ((2 * t - 1) * d) by ring. rewrite Rabs_mult.
rewrite <- (Rmult_1_l (Rabs d)) at 2. apply Rmult_le_compat_r; [apply Rabs_pos|]. apply le_abs. lra.
Qed.

(* where the answer is negative, they cross within both, nowhere else; where it is positive, they do not meet *)
Theorem segments_meet F aax aay abx aby bax bay bbx bby answer : fits F (third F) 1 1 ->
  segments F R (reals F) aax aay abx aby bax bay bbx bby answer ->
  let meet ta tb :=
    aax + ta * (abx - aax) = bax + tb * (bbx - bax) /\ aay + ta * (aby - aay) = bay + tb * (bby - bay) in
  (answer = negative -> exists ta tb, 0 < ta < 1 /\ 0 < tb < 1 /\ meet ta tb /\
    forall ta' tb', meet ta' tb' -> ta' = ta /\ tb' = tb) /\
  (answer = positive -> forall ta tb, 0 <= ta <= 1 -> 0 <= tb <= 1 -> ~ meet ta tb).
Proof.
intros G A meet. destruct (segments_right _ _ _ _ _ _ _ _ _ _ G A) as [Pos Neg].
set (rs := (abx - aax) * (bby - bay) - (aby - aay) * (bbx - bax)) in *.
set (rf := (abx - aax) * (aay - bay) - (aby - aay) * (aax - bax)) in *.
set (sf := (bbx - bax) * (aay - bay) - (bby - bay) * (aax - bax)) in *.
assert (W : forall ta tb, meet ta tb -> sf = ta * rs /\ rf = tb * rs).
{ intros ta tb [X Y]. assert (FX : aax - bax = tb * (bbx - bax) - ta * (abx - aax)) by lra.
  assert (FY : aay - bay = tb * (bby - bay) - ta * (aby - aay)) by lra.
  unfold sf, rf, rs. rewrite FX, FY. split; ring. }
rewrite larger in Pos, Neg. split.
- intros N. specialize (Neg N).
  destruct (between_ends sf rs) as [D TA]; [generalize (Rmax_l (Rabs (2 * sf - rs)) (Rabs (2 * rf - rs))); lra|].
  destruct (between_ends rf rs) as [_ TB]; [generalize (Rmax_r (Rabs (2 * sf - rs)) (Rabs (2 * rf - rs))); lra|].
  exists (sf / rs), (rf / rs). split; [exact TA|]. split; [exact TB|]. split.
  + clear - D. split; apply Rmult_eq_reg_r with rs; auto; unfold sf, rf, rs in *; field; auto.
  + intros ta tb M. destruct (W ta tb M) as [-> ->]. split; now field.
- intros P ta tb TA TB M. specialize (Pos P). destruct (W ta tb M) as [EA EB]. rewrite EA, EB in Pos.
  generalize (Rmax_lub _ _ _ (not_beyond ta rs TA) (not_beyond tb rs TB)). lra.
Qed.
