(* SPDX-License-Identifier: Apache-2.0 *)
(* The second stage of a turn: numbers with their rounding errors. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN Pff2Flocq.
From Filters Require Import model constants steps format floats ghost lanes.
From Filters Require Import lane_bounds lane_filters lane_turns lane_values lane_sums lane_segments lane_boxes.
From Filters Require Import lane_shape_filters lane_faces lane_ray_box lane_moderate lane_close_filters.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.
#[local] Existing Instances p53 fexp_valid below_1024.

Lemma even_symmetric x : negb (Z.even x) = negb (negb (Z.even (- (x + 1)))).
Proof. rewrite Z.even_opp, Z.even_add. simpl (Z.even 1). destruct (Z.even x); reflexivity. Qed.
(* A difference and its error, which is exact. *)
Lemma difference_says (x y : float) : let '(head, tail) := lane_difference x y in finite head -> finite tail ->
  finite x /\ finite y /\ head + tail = x - y /\ Rabs tail <= v * Rabs (x - y).
Proof.
unfold lane_difference. intros FH FT.
destruct (plus_finite _ _ FT) as (F1 & F2 & E). destruct (minus_finite _ _ F1) as (FX & FXP & E1).
destruct (minus_finite _ _ F2) as (FYP & FY & E2). destruct (minus_finite _ _ FH) as (_ & _ & EH).
destruct (plus_finite _ _ FXP) as (_ & _ & EXP). destruct (minus_finite _ _ FYP) as (_ & _ & EYP).
set (h := minus x y) in *. set (yp := minus x h) in *. set (xp := plus h yp) in *.
set (t := plus (minus x xp) (minus yp y)) in *. split; [exact FX|]. split; [exact FY|].
pose proof (TwoSum_correct (-1074) 53 (fun x => negb (Z.even x)) eq_refl ltac:(lia) even_symmetric x (- y)
  (held_value x) (generic_format_opp _ _ _ (held_value y))) as T. cbv zeta in T.
change (rnd (x - y) + rnd (rnd (x - rnd (rnd (x - y) - rnd (rnd (x - y) - x))) + rnd (- y - rnd (rnd (x - y) - x))) =
  x - y) in T. rewrite <- EH in T.
assert (YP : rnd (h - x) = - yp) by (rewrite EYP, <- rnd_opp; f_equal; ring). rewrite YP in T.
replace (h - - yp) with (h + yp) in T by ring. rewrite <- EXP, <- E1 in T.
replace (- y - - yp) with (yp - y) in T by ring. rewrite <- E2, <- E in T. split; [exact T|].
destruct (rnd_difference x y (held_value x) (held_value y)) as (e & B & Z). rewrite Z in EH.
replace (value t) with (- e * (x - y)) by lra. rewrite Rabs_mult, Rabs_Ropp.
apply Rmult_le_compat_r; [apply Rabs_pos|exact B].
Qed.

(* A product that is rounded once with its sum. *)
Lemma fma_finite (a b c : float) : finite (multiply_add true a b c) ->
  finite a /\ finite b /\ finite c /\ value (multiply_add true a b c) = rnd (a * b + c).
Proof.
intros Z. destruct (multiply_add_finite true a b c Z) as (A & B & C & _). split; [exact A|]. split; [exact B|].
split; [exact C|]. unfold multiply_add in *.
cases_of (Bfma_correct 53 1024 _ _ mode_NE a b c A B C); [now intros [-> _]|].
intros E%not_finite_overflow. rewrite E in Z. discriminate Z.
Qed.
#[local] Opaque plus minus times multiply_add.

(* A product and its error. *)
Lemma rnd_off r : Rabs (rnd r - r) <= v * Rabs r + eta.
Proof.
destruct (rnd_any r) as (e & h & B & H & ->). replace (r * (1 + e) + h - r) with (e * r + h) by ring.
apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_mult.
assert (Rabs e * Rabs r <= v * Rabs r) by (apply Rmult_le_compat_r; [apply Rabs_pos|exact B]). lra.
Qed.
Lemma product_parts (a b : float) : finite (multiply_add true a b (minus zero (times a b))) ->
  finite a /\ finite b /\ Rabs (times a b - a * b) <= v * Rabs (a * b) + eta /\
  Rabs (value (multiply_add true a b (minus zero (times a b))) - (a * b - times a b)) <= v * (v * Rabs (a * b) + eta) + eta.
Proof.
intros F. destruct (fma_finite _ _ _ F) as (A & B & C & E). destruct (minus_finite _ _ C) as (_ & FH & EC).
destruct zero_is as [_ VZ]. rewrite VZ in EC. destruct (times_finite _ _ FH) as (_ & _ & EH).
replace (0 - times a b) with (- times a b) in EC by ring.
rewrite rnd_held in EC by (apply generic_format_opp, held_value).
split; [exact A|]. split; [exact B|]. assert (O : Rabs (times a b - a * b) <= v * Rabs (a * b) + eta).
{ rewrite EH. apply rnd_off. }
split; [exact O|]. rewrite E, EC. replace (a * b + - times a b) with (a * b - times a b) by ring.
apply Rle_trans with (1 := rnd_off _). apply Rplus_le_compat_r. apply Rmult_le_compat_l; [pose proof v_small; lra|].
now rewrite Rabs_minus_sym.
Qed.

(* An error of a difference, in units of the rounded one. *)
Lemma tail_small h t d : h + t = d -> Rabs t <= v * Rabs d -> Rabs t <= 17 / 16 * v * Rabs h.
Proof.
intros <- L. pose proof (Rabs_triang h t). pose proof v_tiny. pose proof (Rabs_pos h). pose proof (Rabs_pos t).
assert (v * Rabs (h + t) <= v * (Rabs h + Rabs t)) by (apply Rmult_le_compat_l; lra).
assert (v * Rabs t <= / 1048576 * Rabs t) by (apply Rmult_le_compat_r; lra).
assert (0 <= v * Rabs h) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma twice_v a : 0 <= a -> 0 <= v * (v * a).
Proof. intros. pose proof v_small. apply Rmult_le_pos; [lra|]. apply Rmult_le_pos; lra. Qed.
(* The products of heads and tails. *)
Lemma crossed_says (u u' s s' : float) : finite (multiply_add true u s' (times s u')) ->
  Rabs u' <= 17 / 16 * v * Rabs u -> Rabs s' <= 17 / 16 * v * Rabs s -> let X := Rabs (u * s) in
  Rabs (u * s' + s * u') <= 9 / 4 * v * X /\ Rabs (u' * s') <= 5 / 4 * v * (v * X) + 0 /\
  Rabs (value (multiply_add true u s' (times s u')) - (u * s' + s * u')) <= 4 * v * (v * X) + 3 * eta.
Proof.
intros F LU LS X. destruct (fma_finite _ _ _ F) as (_ & _ & FT & E). destruct (times_finite _ _ FT) as (_ & _ & ET).
pose proof v_tiny as V. pose proof eta_pos as P. assert (XP : 0 <= X) by apply Rabs_pos.
assert (K1 : Rabs (u * s') <= 17 / 16 * v * X).
{ unfold X. rewrite !Rabs_mult. pose proof (Rmult_le_compat_l _ _ _ (Rabs_pos u) LS). lra. }
assert (K2 : Rabs (s * u') <= 17 / 16 * v * X).
{ unfold X. rewrite !Rabs_mult. pose proof (Rmult_le_compat_l _ _ _ (Rabs_pos s) LU). lra. }
assert (K3 : Rabs (u' * s') <= 5 / 4 * v * (v * X) + 0).
{ rewrite Rabs_mult. apply Rle_trans with (17 / 16 * v * Rabs u * (17 / 16 * v * Rabs s)).
  - apply Rmult_le_compat; auto using Rabs_pos.
  - unfold X. rewrite Rabs_mult. assert (0 <= v * (v * (Rabs u * Rabs s))).
    { apply twice_v, Rmult_le_pos; apply Rabs_pos. } lra. }
assert (VX : 0 <= v * X) by (apply Rmult_le_pos; lra).
assert (VVX : 0 <= v * (v * X)) by (apply Rmult_le_pos; lra).
assert (VS : v * (v * X) <= / 1048576 * (v * X)) by (apply Rmult_le_compat_r; lra).
pose proof (Rabs_triang (u * s') (s * u')) as T1. split; [lra|]. split; [exact K3|].
pose proof (rnd_off (s * u')) as O1. rewrite <- ET in O1.
assert (VK : v * Rabs (s * u') <= v * (17 / 16 * v * X)) by (apply Rmult_le_compat_l; lra).
pose proof (rnd_off (u * s' + times s u')) as O2. rewrite <- E in O2.
set (p := value (times s u')) in *. set (f := value (multiply_add true u s' (times s u'))) in *. clearbody p f.
pose proof (Rabs_triang (f - (u * s' + p)) (p - s * u')) as T2.
replace (f - (u * s' + p) + (p - s * u')) with (f - (u * s' + s * u')) in T2 by ring.
pose proof (Rabs_triang (u * s' + s * u') (p - s * u')) as T3.
replace (u * s' + s * u' + (p - s * u')) with (u * s' + p) in T3 by ring.
assert (M : Rabs (u * s' + p) <= 9 / 4 * v * X + eta) by lra.
apply (Rmult_le_compat_l v) in M; [|lra]. assert (v * eta <= / 1048576 * eta) by (apply Rmult_le_compat_r; lra). lra.
Qed.

(* The value and the exact turn. A: the products of heads; S: what is computed of them. *)
Lemma turn_says L R l r us wt f g f0 g0 u's' w't' A d m1 m2 m3 z :
  0 <= A -> Rabs us + Rabs wt <= A -> (* the exact products *)
  Rabs (L - us) <= v * Rabs us + eta -> Rabs (l - (us - L)) <= v * (v * Rabs us + eta) + eta ->
  Rabs (R - wt) <= v * Rabs wt + eta -> Rabs (r - (wt - R)) <= v * (v * Rabs wt + eta) + eta ->
  Rabs f0 <= 9 / 4 * v * Rabs us -> Rabs u's' <= 5 / 4 * v * (v * Rabs us) + 0 ->
  Rabs (f - f0) <= 4 * v * (v * Rabs us) + 3 * eta ->
  Rabs g0 <= 9 / 4 * v * Rabs wt -> Rabs w't' <= 5 / 4 * v * (v * Rabs wt) + 0 ->
  Rabs (g - g0) <= 4 * v * (v * Rabs wt) + 3 * eta ->
  Rabs (d - (L - R)) <= v * Rabs (L - R) -> Rabs (m1 - (l - r)) <= v * Rabs (l - r) ->
  Rabs (m2 - (f - g)) <= v * Rabs (f - g) -> Rabs (m3 - (m1 + m2)) <= v * Rabs (m1 + m2) ->
  Rabs (z - (d + m3)) <= v * Rabs (d + m3) ->
  let T := us + f0 + u's' - (wt + g0 + w't') in
  180 * v * (v * A) + 1000 * eta < Rabs z -> (z < 0 -> T < 0) /\ (0 < z -> T > 0).
Proof.
intros A0 LA L1 L2 R1 R2 F1 F2 F3 G1 G2 G3 D1 M1 M2 M3 Z1 T B. pose proof v_tiny as V. pose proof eta_pos as P.
pose proof (Rabs_pos us). pose proof (Rabs_pos wt). set (X := Rabs us) in *. set (Y := Rabs wt) in *.
assert (small : forall a, 0 <= a -> 0 <= v * a <= / 1048576 * a).
{ intros a PA. split; [apply Rmult_le_pos; lra|apply Rmult_le_compat_r; lra]. }
assert (VX := small X ltac:(lra)). assert (VY := small Y ltac:(lra)). assert (VA := small A A0).
assert (VVX := small (v * X) ltac:(lra)). assert (VVY := small (v * Y) ltac:(lra)).
assert (VVA := small (v * A) ltac:(lra)). assert (VE := small eta ltac:(lra)).
assert (LV : v * X + v * Y <= v * A). { rewrite <- Rmult_plus_distr_l. apply Rmult_le_compat_l; lra. }
assert (LVV : v * (v * X) + v * (v * Y) <= v * (v * A)). { rewrite <- Rmult_plus_distr_l. apply Rmult_le_compat_l; lra. }
assert (VVVA := small (v * (v * A)) ltac:(lra)).
(* l - r and f - g, and what their roundings are off *)
set (l0 := us - L) in *. set (r0 := wt - R) in *.
assert (B1 : Rabs (l - r - (l0 - r0)) <= v * (v * A) + 3 * eta).
{ pose proof (Rabs_triang (l - l0) (- (r - r0))) as Q. rewrite Rabs_Ropp in Q.
  replace (l - l0 + - (r - r0)) with (l - r - (l0 - r0)) in Q by ring. lra. }
assert (B2 : Rabs (l0 - r0) <= v * A + 2 * eta).
{ unfold l0, r0. rewrite Rabs_minus_sym in L1, R1. pose proof (Rabs_triang (us - L) (- (wt - R))) as Q.
  rewrite Rabs_Ropp in Q. replace (us - L + - (wt - R)) with (us - L - (wt - R)) in Q by ring. lra. }
assert (B3 : Rabs (f - g - (f0 - g0)) <= 4 * (v * (v * A)) + 6 * eta).
{ pose proof (Rabs_triang (f - f0) (- (g - g0))) as Q. rewrite Rabs_Ropp in Q.
  replace (f - f0 + - (g - g0)) with (f - g - (f0 - g0)) in Q by ring. lra. }
assert (B4 : Rabs (f0 - g0) <= 9 / 4 * (v * A)).
{ pose proof (Rabs_triang f0 (- g0)) as Q. rewrite Rabs_Ropp in Q. fold (f0 - g0) in Q. lra. }
assert (B5 : Rabs (u's' - w't') <= 5 / 4 * (v * (v * A))).
{ pose proof (Rabs_triang u's' (- w't')) as Q. rewrite Rabs_Ropp in Q. fold (u's' - w't') in Q. lra. }
assert (B6 : Rabs (l - r) <= 9 / 8 * (v * A) + 5 * eta).
{ pose proof (Rabs_triang (l - r - (l0 - r0)) (l0 - r0)) as Q.
  replace (l - r - (l0 - r0) + (l0 - r0)) with (l - r) in Q by ring. lra. }
assert (B7 : Rabs (f - g) <= 19 / 8 * (v * A) + 6 * eta).
{ pose proof (Rabs_triang (f - g - (f0 - g0)) (f0 - g0)) as Q.
  replace (f - g - (f0 - g0) + (f0 - g0)) with (f - g) in Q by ring. lra. }
assert (C6 := Rmult_le_compat_l v _ _ ltac:(lra) B6). assert (C7 := Rmult_le_compat_l v _ _ ltac:(lra) B7).
assert (B8 : Rabs (m1 + m2) <= 15 / 4 * (v * A) + 12 * eta).
{ pose proof (Rabs_triang (m1 - (l - r)) (l - r)) as Q1. replace (m1 - (l - r) + (l - r)) with m1 in Q1 by ring.
  pose proof (Rabs_triang (m2 - (f - g)) (f - g)) as Q2. replace (m2 - (f - g) + (f - g)) with m2 in Q2 by ring.
  pose proof (Rabs_triang m1 m2). lra. }
assert (C8 := Rmult_le_compat_l v _ _ ltac:(lra) B8).
assert (B9 : Rabs m3 <= 4 * (v * A) + 13 * eta).
{ pose proof (Rabs_triang (m3 - (m1 + m2)) (m1 + m2)) as Q.
  replace (m3 - (m1 + m2) + (m1 + m2)) with m3 in Q by ring. lra. }
assert (B10 : Rabs (m3 - (T - (L - R))) <= 15 * (v * (v * A)) + 12 * eta).
{ replace (m3 - (T - (L - R))) with ((m3 - (m1 + m2)) + (m1 - (l - r)) + (m2 - (f - g)) + (l - r - (l0 - r0)) +
    (f - g - (f0 - g0)) + - (u's' - w't')) by (unfold T, l0, r0; ring).
  assert (six : forall a b c e g1 h, Rabs (a + b + c + e + g1 + - h) <=
    Rabs a + Rabs b + Rabs c + Rabs e + Rabs g1 + Rabs h).
  { intros a b c e g1 h. pose proof (Rabs_triang (a + b + c + e + g1) (- h)). rewrite Rabs_Ropp in *.
    pose proof (Rabs_triang (a + b + c + e) g1). pose proof (Rabs_triang (a + b + c) e).
    pose proof (Rabs_triang (a + b) c). pose proof (Rabs_triang a b). lra. }
  apply Rle_trans with (1 := six _ _ _ _ _ _). lra. }
set (Q := d + m3) in *. assert (BD : Rabs (L - R) <= 9 / 8 * Rabs d).
{ pose proof (Rabs_triang (L - R - d) d) as W. replace (L - R - d + d) with (L - R) in W by ring.
  rewrite Rabs_minus_sym in D1. pose proof (small _ (Rabs_pos (L - R))). pose proof (Rabs_pos d). lra. }
assert (BQ : Rabs d <= Rabs Q + Rabs m3).
{ pose proof (Rabs_triang Q (- m3)) as W. rewrite Rabs_Ropp in W. unfold Q in W at 1.
  replace (d + m3 + - m3) with d in W by ring. exact W. }
assert (BB : Rabs (Q - T) <= / 1024 * Rabs Q + 20 * (v * (v * A)) + 14 * eta).
{ pose proof (Rabs_triang (d - (L - R)) (m3 - (T - (L - R)))) as W.
  replace (d - (L - R) + (m3 - (T - (L - R)))) with (Q - T) in W by (unfold Q; ring).
  assert (N := small _ (Rabs_pos (L - R))). assert (v * Rabs (L - R) <= v * (9 / 8 * (Rabs Q + 4 * (v * A) + 13 * eta)))
    by (apply Rmult_le_compat_l; lra).
  assert (N' := small _ (Rabs_pos Q)). lra. }
assert (ZQ : Rabs z <= 9 / 8 * Rabs Q).
{ pose proof (Rabs_triang (z - Q) Q) as W. replace (z - Q + Q) with z in W by ring.
  assert (N' := small _ (Rabs_pos Q)). lra. }
assert (S1 : Rabs (Q - T) < Rabs Q) by lra. assert (S2 : Rabs (z - Q) < Rabs Q).
{ assert (N' := small _ (Rabs_pos Q)). lra. }
split; intros S.
- assert (Q < 0). { apply Rnot_le_lt. intros N. rewrite (Rabs_right Q) in S2 by lra. apply Rabs_def2 in S2. lra. }
  rewrite (Rabs_left Q) in S1 by assumption. apply Rabs_def2 in S1. lra.
- assert (0 < Q). { apply Rnot_le_lt. intros N. rewrite (Rabs_left1 Q) in S2 by lra. apply Rabs_def2 in S2. lra. }
  rewrite (Rabs_right Q) in S1 by lra. apply Rabs_def2 in S1. lra.
Qed.

Lemma difference_off (x y : float) : finite (minus x y) -> Rabs (minus x y - (x - y)) <= v * Rabs (x - y).
Proof.
intros (_ & _ & ->)%minus_finite. destruct (rnd_difference x y (held_value _) (held_value _)) as (e & B & ->).
replace ((x - y) * (1 + e) - (x - y)) with (e * (x - y)) by ring. rewrite Rabs_mult.
apply Rmult_le_compat_r; [apply Rabs_pos|exact B].
Qed.
Lemma sum_off (x y : float) : finite (plus x y) -> Rabs (plus x y - (x + y)) <= v * Rabs (x + y).
Proof.
intros (_ & _ & ->)%plus_finite. destruct (rnd_sum x y (held_value _) (held_value _)) as (e & B & ->).
replace ((x + y) * (1 + e) - (x + y)) with (e * (x + y)) by ring. rewrite Rabs_mult.
apply Rmult_le_compat_r; [apply Rabs_pos|exact B].
Qed.

(* Where the turn is known, all numbers are finite and the turn is that. *)
Theorem lane_close_turn_right (px py qx qy rx ry : float) :
  let '(u, u') := lane_difference qx px in let '(w, w') := lane_difference qy py in
  let '(s, s') := lane_difference ry py in let '(t, t') := lane_difference rx px in
  sides_right (lane_close_turn u u' w w' s s' t t') [px; py; qx; qy; rx; ry]
    ((qx - px) * (ry - py) - (qy - py) * (rx - px)).
Proof.
pose proof (difference_says qx px) as DU. pose proof (difference_says qy py) as DW.
pose proof (difference_says ry py) as DS. pose proof (difference_says rx px) as DT.
destruct (lane_difference qx px) as [u u']. destruct (lane_difference qy py) as [w w'].
destruct (lane_difference ry py) as [s s']. destruct (lane_difference rx px) as [t t'].
unfold lane_close_turn. apply sides_of.
set (L := times u s). set (R := times w t). set (l := multiply_add true u s (minus zero L) : float).
set (r := multiply_add true w t (minus zero R) : float). set (f := multiply_add true u s' (times s u') : float).
set (g := multiply_add true w t' (times t w') : float). set (d := minus L R). set (m1 := minus l r). set (m2 := minus f g).
set (m3 := plus m1 m2). set (z := plus d m3). set (b1 := multiply_add true (size z) (number 1 (-50)) small : float).
set (b2 := multiply_add true (plus (size L) (size R)) (number 1 (-98)) b1 : float). intros A.
assert (U1 : up b1) by (unfold b1; ups). assert (U2 : up b2).
{ unfold b2. apply up_multiply_add; [ups|apply up_number; lia|exact U1]. }
pose proof (above_bound _ _ A U2) as F2. destruct (fma_finite _ _ _ F2) as (FS & _ & F1 & _).
destruct (fma_finite _ _ _ F1) as (FZ & _ & _ & _). destruct (size_finite _ FZ) as [FZ' VZ].
apply (above_finite _ _ FZ F2) in A. rewrite VZ in A.
destruct small_is as [_ VS]. destruct (number_value 1 (-50)) as [_ V50]; [lia|lia|]. rewrite Rmult_1_l in V50.
destruct (number_value 1 (-98)) as [_ V98]; [lia|lia|]. rewrite Rmult_1_l in V98.
pose proof (bpow_gt_0 radix2 (-50)) as P50. pose proof (bpow_gt_0 radix2 (-98)) as P98. pose proof eta_pos as PE.
assert (TE : 65536 * eta <= tiny).
{ pose proof eta_spare. pose proof (bpow_le radix2 (-1010) (-1000) ltac:(lia)). lra. }
pose proof (multiply_add_least true (size z) (number 1 (-50)) small F1 (up_value _ (up_size _)) ltac:(rewrite V50; lra)
  ltac:(rewrite VS; lra)) as B1. fold b1 in B1. rewrite VS in B1. pose proof v_tiny as V.
assert (B1' : tiny / 2 <= b1).
{ assert (0 <= (1 - 3 * v) * (number 1 (-50) * size z)); [|lra]. rewrite V50.
  apply Rmult_le_pos; [lra|]. apply Rmult_le_pos; [lra|apply up_value, up_size]. }
pose proof (multiply_add_least true (plus (size L) (size R)) (number 1 (-98)) b1 F2 (up_value _ (up_plus _ _ (up_size _)
  (up_size _))) ltac:(rewrite V98; lra) ltac:(lra)) as B2. fold b2 in B2. rewrite V98 in B2.
destruct (plus_finite _ _ FZ') as (FD & FM3 & _). destruct (plus_finite _ _ FM3) as (FM1 & FM2 & _).
destruct (minus_finite _ _ FM1) as (Fl & Fr & _). destruct (minus_finite _ _ FM2) as (Ff & Fg & _).
destruct (product_parts u s Fl) as (FU & FSS & L1 & L2). destruct (product_parts w t Fr) as (FW & FT & R1 & R2).
destruct (fma_finite _ _ _ Ff) as (_ & FS' & FSU & _). destruct (times_finite _ _ FSU) as (_ & FU' & _).
destruct (fma_finite _ _ _ Fg) as (_ & FT' & FTW & _). destruct (times_finite _ _ FTW) as (_ & FW' & _).
destruct (DU FU FU') as (N1 & N2 & EU & TU). destruct (DW FW FW') as (N3 & N4 & EW & TW).
destruct (DS FSS FS') as (N5 & N6 & ES & TS). destruct (DT FT FT') as (N7 & N8 & ET & TT).
apply (tail_small _ _ _ EU) in TU. apply (tail_small _ _ _ EW) in TW. apply (tail_small _ _ _ ES) in TS.
apply (tail_small _ _ _ ET) in TT.
destruct (crossed_says u u' s s' Ff TU TS) as (C1 & C2 & C3). destruct (crossed_says w w' t t' Fg TW TT) as (G1 & G2 & G3).
fold L l in L1, L2. fold R r in R1, R2. fold f in C3. fold g in G3.
split; [repeat constructor; assumption|].
assert (SZ := sum_off d m3 FZ'). fold z in SZ.
assert (K : 180 * v * (v * (Rabs (u * s) + Rabs (w * t))) + 1000 * eta < Rabs z).
{ destruct (plus_finite _ _ FS) as (_ & _ & ESUM).
  destruct (rnd_sum (size L) (size R) (held_value _) (held_value _)) as (e & BE & Z). rewrite Z in ESUM.
  rewrite !size_value in ESUM. apply abs_le in BE.
  assert (H1 : Rabs (u * s) <= 17 / 16 * Rabs L + 2 * eta).
  { pose proof (Rabs_triang (u * s - L) L) as Q. replace (u * s - L + L) with (u * s) in Q by ring.
    rewrite Rabs_minus_sym in L1.
    pose proof (Rmult_le_compat_r _ _ _ (Rabs_pos (u * s)) (proj2 V)). pose proof (Rabs_pos L). lra. }
  assert (H2 : Rabs (w * t) <= 17 / 16 * Rabs R + 2 * eta).
  { pose proof (Rabs_triang (w * t - R) R) as Q. replace (w * t - R + R) with (w * t) in Q by ring.
    rewrite Rabs_minus_sym in R1.
    pose proof (Rmult_le_compat_r _ _ _ (Rabs_pos (w * t)) (proj2 V)). pose proof (Rabs_pos R). lra. }
  set (S := Rabs L + Rabs R) in *. assert (S0 : 0 <= S) by (unfold S; pose proof (Rabs_pos L); pose proof (Rabs_pos R); lra).
  assert (E98 : bpow radix2 (-98) = 256 * v * v) by (rewrite v_is; simpl; lra).
  assert (VVS := twice_v S S0).
  assert (M : 200 * (v * (v * S)) <= (1 - 3 * v) * (bpow radix2 (-98) * plus (size L) (size R))).
  { rewrite ESUM, E98. replace ((1 - 3 * v) * (256 * v * v * (S * (1 + e)))) with
      (v * (v * S) * (256 * ((1 - 3 * v) * (1 + e)))) by ring.
    replace (200 * (v * (v * S))) with (v * (v * S) * 200) by ring. apply Rmult_le_compat_l; [exact VVS|]. nra. }
  assert (Q : v * (v * (Rabs (u * s) + Rabs (w * t))) <= v * (v * (17 / 16 * S + 4 * eta))).
  { apply Rmult_le_compat_l; [lra|]. apply Rmult_le_compat_l; [lra|]. unfold S. lra. }
  assert (v * (v * eta) <= eta).
  { assert (v * eta <= 1 * eta) by (apply Rmult_le_compat_r; lra).
    assert (v * (v * eta) <= 1 * (v * eta)) by (apply Rmult_le_compat_r; [apply Rmult_le_pos|]; lra). lra. }
  lra. }
assert (T := turn_says L R l r (u * s) (w * t) f g (u * s' + s * u') (w * t' + t * w') (u' * s') (w' * t')
  (Rabs (u * s) + Rabs (w * t)) d m1 m2 m3 z).
specialize (T ltac:(pose proof (Rabs_pos (u * s)); pose proof (Rabs_pos (w * t)); lra) (Rle_refl _) L1 L2 R1 R2 C1 C2 C3
  G1 G2 G3 (difference_off _ _ FD) (difference_off _ _ FM1) (difference_off _ _ FM2) (sum_off _ _ FM3) SZ K).
cbv zeta in T. destruct T as [TN TP].
assert (X : (qx - px) * (ry - py) - (qy - py) * (rx - px) =
  u * s + (u * s' + s * u') + u' * s' - (w * t + (w * t' + t * w') + w' * t')).
{ rewrite <- EU, <- EW, <- ES, <- ET. ring. }
rewrite X. assert (Z0 : value z <> 0).
{ intros Z. rewrite Z, Rabs_R0 in K. assert (0 <= v * (v * (Rabs (u * s) + Rabs (w * t)))).
  { apply twice_v. pose proof (Rabs_pos (u * s)). pose proof (Rabs_pos (w * t)). lra. } lra. }
destruct (sign_value z) as [SN SP]. split; intros S.
- apply TN. specialize (SN S). lra.
- apply TP. specialize (SP S). lra.
Qed.
