(* SPDX-License-Identifier: Apache-2.0 *)
(* On which side of a face's plane a point lies: a product with a normal, and its bound. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model constants steps format floats ghost lanes.
From Filters Require Import lane_bounds lane_turns lane_values lane_sums.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.
#[local] Existing Instances p53 fexp_valid below_1024.

(* What a bound dominates is finite where the bound is. *)
Lemma dominated_minus x y m k : dominated x m -> dominated y k -> finite (plus m k) -> dominated (minus x y) (plus m k).
Proof.
intros (X & M & LX) (Y & K & LY) F. pose proof (plus_finite _ _ F) as (_ & _ & E).
assert (B : Rabs (rnd (value x - value y)) <= value (plus m k)).
{ rewrite E, rnd_abs. apply rnd_le. unfold Rminus. apply Rle_trans with (1 := Rabs_triang _ _).
  rewrite Rabs_Ropp. lra. }
pose proof (below_high (plus m k)) as H. rewrite Rabs_right in H by (pose proof (Rabs_pos (rnd (value x - value y)));
  lra).
assert (Z : finite (minus x y) /\ value (minus x y) = rnd (value x - value y)).
{ unfold minus. cases_of (Bminus_correct 53 1024 _ _ mode_NE x y X Y); [now intros (V & Z & _)|].
  fold (rnd (value x - value y)) in L. lra. }
destruct Z as [Z V]. split; [exact Z|]. split; [exact F|]. now rewrite V.
Qed.
Lemma dominated_times x y m k : dominated x m -> dominated y k -> finite (times m k) ->
  dominated (times x y) (times m k).
Proof.
intros (X & M & LX) (Y & K & LY) F. pose proof (times_finite _ _ F) as (_ & _ & E).
assert (B : Rabs (rnd (value x * value y)) <= value (times m k)).
{ rewrite E, rnd_abs. apply rnd_le. rewrite Rabs_mult. apply Rmult_le_compat; auto using Rabs_pos. }
pose proof (below_high (times m k)) as H. rewrite Rabs_right in H by (pose proof (Rabs_pos (rnd (value x * value y)));
  lra).
assert (Z : finite (times x y) /\ value (times x y) = rnd (value x * value y)).
{ unfold times. cases_of (Bmult_correct 53 1024 _ _ mode_NE x y).
  - intros (V & Z & _). split; [|exact V]. unfold finite in *. now rewrite Z, X, Y.
  - fold (rnd (value x * value y)) in L. lra. }
destruct Z as [Z V]. split; [exact Z|]. split; [exact F|]. now rewrite V.
Qed.
Lemma dominated_more x m t : dominated x m -> up t -> finite (plus m t) -> dominated x (plus m t).
Proof.
intros (X & M & L) T F. pose proof (plus_finite _ _ F) as (_ & _ & E). split; [exact X|]. split; [exact F|].
apply Rle_trans with (1 := L). rewrite E, <- (rnd_held (value m)) at 1 by apply held_value. apply rnd_le.
apply up_value in T. lra.
Qed.

Notation small := (number 1 (-1000)).
Lemma small_is : finite small /\ value small = tiny.
Proof. destruct (number_value 1 (-1000)) as [F V]; [lia|lia|]. now rewrite Rmult_1_l in V. Qed.
Lemma absorbed : 4 * eta <= v * spare.
Proof.
unfold eta, v. pose proof (bpow_gt_0 radix2 (-1074)).
replace (/ 2 * bpow radix2 (-52) * spare) with (/ 2 * bpow radix2 (-1062)).
- assert (4 * bpow radix2 (-1074) <= bpow radix2 (-1062)); [|lra].
  change 4 with (bpow radix2 2). rewrite <- bpow_plus. apply bpow_le. lia.
- change (-1062)%Z with (-52 + -1010)%Z. rewrite bpow_plus. ring.
Qed.

(* A number with one rounding, or none. *)
Definition near (x : float) r := est 1 0 x r (Rabs r) /\ least_of 1 0 (size x) (Rabs r).
Lemma near_difference x y : finite (minus x y) -> near (minus x y) (x - y).
Proof. intros F. split; [now apply of_difference|now apply low_of_difference]. Qed.
Lemma near_given x : near x x.
Proof.
split; [apply est_more with (3 := of_given x)|apply least_more with (3 := low_of_given x)]; auto; apply Rle_refl.
Qed.

(* A coordinate of the normal, with what its terms add up to: 2^-1010 more pays for what underflows in it. *)
Definition difference_of p q r w := minus (times p q) (times r w).
Definition terms_of p q r w := plus (plus (size (times p q)) (size (times r w))) small.
Definition total_of p' q' r' w' := Rabs p' * Rabs q' + Rabs r' * Rabs w' + spare.
Lemma up_terms p q r w : up (terms_of p q r w).
Proof. unfold terms_of. ups. Qed.
Lemma coordinate_says p q r w p' q' r' w' : near p p' -> near q q' -> near r r' -> near w w' ->
  finite (terms_of p q r w) -> let T := total_of p' q' r' w' in
  dominated (difference_of p q r w) (terms_of p q r w) /\
  est 4 0 (difference_of p q r w) (p' * q' - r' * w') T /\ least_of 5 0 (terms_of p q r w) T.
Proof.
intros [P1 P2] [Q1 Q2] [R1 R2] [W1 W2] F T. unfold terms_of in F. destruct (plus_finite _ _ F) as (F1 & _ & E).
destruct (plus_finite _ _ F1) as (F2 & F3 & _). apply size_finite in F2 as [F2 _]. apply size_finite in F3 as [F3 _].
assert (D : dominated (difference_of p q r w) (plus (size (times p q)) (size (times r w)))).
{ apply dominated_minus; [now apply dominated_size..|exact F1]. }
split; [apply dominated_more; [exact D|ups|exact F]|]. pose proof (bpow_gt_0 radix2 (-1010)) as sp. split.
- assert (K : est 4 (4 * eta) (difference_of p q r w) (p' * q' - r' * w') (Rabs p' * Rabs q' + Rabs r' * Rabs w')).
  { eapply est_more; cycle 2.
    - eapply of_minus; [apply D|eapply of_times; [exact F2|exact P1|exact Q1]|
        eapply of_times; [exact F3|exact R1|exact W1]].
    - cbn. lia.
    - lra. }
  unfold T, total_of. apply est_absorb with (A := 4 * eta);
    [lia|exact absorbed|exact K].
- assert (K : least_of 4 (4 * eta) (plus (size (times p q)) (size (times r w)))
    (Rabs p' * Rabs q' + Rabs r' * Rabs w')).
  { pose proof eta_pos. eapply least_more; cycle 2.
    - eapply low_plus; [exact F1|ups|ups| | |eapply low_of_times; [exact F2|exact P2|exact Q2]|
        eapply low_of_times; [exact F3|exact R2|exact W2]]; lra.
    - cbn. lia.
    - lra. }
  destruct K as (x' & [K1 K2] & K3). destruct small_is as [_ V]. unfold terms_of. rewrite E, V.
  clear E.
  match type of K3 with _ <= ?q => set (x := q) in * end. set (S := Rabs p' * Rabs q' + Rabs r' * Rabs w') in *.
  assert (HT : held tiny) by (rewrite <- V; apply held_value).
  destruct (rnd_sum x tiny (held_value _) HT) as (e & B & ->). exists ((x + tiny) * (1 + e)). split; [|lra].
  unfold T, total_of. fold S. split; [lra|]. apply abs_le in B. pose proof v_small as Hv. pose proof eta_pos.
  pose proof eta_spare. assert (ST : 1024 * spare = tiny).
  { change 1024 with (bpow radix2 10). rewrite <- bpow_plus. reflexivity. }
  pose proof (down v v_small 4) as D4. set (p4 := (1 - v) ^ 4) in *. replace ((1 - v) ^ 5) with (p4 * (1 - v)) by
    (unfold p4; ring).
  assert (p4 * (S + spare) <= x + tiny) by nra.
  assert (0 <= p4 * (S + spare)) by (apply Rmult_le_pos; lra).
  assert (p4 * (S + spare) * (1 - v) <= (x + tiny) * (1 + e)) by (apply Rmult_le_compat; lra). lra.
Qed.
(* A product of such a coordinate. *)
Lemma term_says (c m d : float) t T d' : dominated c m -> up m -> est 4 0 c t T -> least_of 5 0 m T -> near d d' ->
  finite (times m (size d)) -> dominated (times c d) (times m (size d)) /\
  est 6 eta (times c d) (t * d') (T * Rabs d') /\ least_of 7 eta (times m (size d)) (T * Rabs d').
Proof.
intros D U E L [N1 N2] F. destruct (times_finite _ _ F) as (_ & F' & _). apply size_finite in F' as [F' _].
assert (D' : dominated (times c d) (times m (size d)))
  by (apply dominated_times; [exact D|now apply dominated_size|exact F]).
split; [exact D'|]. split.
- eapply est_more; cycle 2; [eapply of_times; [apply D'|exact E|exact N1]|cbn; lia|lra].
- eapply least_more; cycle 2; [eapply low_times; [exact F|exact L|exact N2]|cbn; lia|lra].
Qed.

(* The sign of a displacement's product with a vector that has coordinates like these. *)
Definition coordinate (c m : float) t T := up m /\
  (finite m -> dominated c m /\ est 4 0 c t T /\ least_of 5 0 m T).
Lemma product_right fused (c1 m1 d1 c2 m2 d2 c3 m3 d3 : float) t1 T1 d1' t2 T2 d2' t3 T3 d3' :
  coordinate c1 m1 t1 T1 -> coordinate c2 m2 t2 T2 -> coordinate c3 m3 t3 T3 ->
  near d1 d1' -> near d2 d2' -> near d3 d3' ->
  let z := plus (plus (times c1 d1) (times c2 d2)) (times c3 d3) in
  let terms := plus (plus (times m1 (size d1)) (times m2 (size d2))) (times m3 (size d3)) in
  above (size z) (bound fused (-50) terms) = true ->
  (negative_lane z = true -> t1 * d1' + t2 * d2' + t3 * d3' < 0) /\
  (negative_lane z = false -> t1 * d1' + t2 * d2' + t3 * d3' > 0).
Proof.
intros [U1 C1] [U2 C2] [U3 C3] D1 D2 D3 z terms A. assert (U : up terms) by (unfold terms; ups).
destruct (bound_says _ _ _ _ A U ltac:(lia)) as (M & FB & BL). assert (PB := up_value _ (up_bound fused (-50) _ U
  ltac:(lia))).
set (b := bound fused (-50) terms) in *. clearbody b. unfold terms in M.
destruct (plus_finite _ _ M) as (M1 & F3 & _). destruct (plus_finite _ _ M1) as (F1 & F2 & _).
destruct (times_finite _ _ F1) as (FM1 & _). destruct (times_finite _ _ F2) as (FM2 & _).
destruct (times_finite _ _ F3) as (FM3 & _).
destruct (C1 FM1) as (DM1 & E1 & L1). destruct (C2 FM2) as (DM2 & E2 & L2). destruct (C3 FM3) as (DM3 & E3 & L3).
destruct (term_says _ _ _ _ _ _ DM1 U1 E1 L1 D1 F1) as (X1 & E1' & L1').
destruct (term_says _ _ _ _ _ _ DM2 U2 E2 L2 D2 F2) as (X2 & E2' & L2').
destruct (term_says _ _ _ _ _ _ DM3 U3 E3 L3 D3 F3) as (X3 & E3' & L3').
assert (X12 := dominated_plus _ _ _ _ X1 X2 M1). destruct X12 as (F12 & _). destruct X3 as (FX3 & _).
destruct (sure_plus _ _ b F12 FX3 PB FB A) as [SN SP].
assert (E : est 7 spare (plus (times c1 d1) (times c2 d2) + times c3 d3) (t1 * d1' + t2 * d2' + t3 * d3')
  (T1 * Rabs d1' + T2 * Rabs d2' + T3 * Rabs d3'))
  by (within ltac:(eapply est_sum; [eapply of_plus; [exact F12|exact E1'|exact E2']|exact E3'])).
assert (L : least_of 9 spare terms (T1 * Rabs d1' + T2 * Rabs d2' + T3 * Rabs d3')).
{ pose proof eta_pos. unfold terms. eapply least_more; cycle 2.
  - eapply low_plus; [exact M|ups..| | |eapply low_plus; [exact M1|ups..| | |exact L1'|exact L2']|exact L3']; lra.
  - cbn. lia.
  - small_rest. }
destruct (signs _ _ _ _ _ _ _ 8 (-50) E L ltac:(lia) ltac:(lia) ltac:(lra) ltac:(simpl; lra) ltac:(rewrite v_is;
  simpl; lra) BL) as [N P].
split; intros K; [exact (N (SN K))|exact (P (SP K))].
Qed.

(* And with the normal of a face. *)
Definition face_exact s1 s2 s3 t1 t2 t3 d1 d2 d3 :=
  (s2 * t3 - s3 * t2) * d1 + (s3 * t1 - s1 * t3) * d2 + (s1 * t2 - s2 * t1) * d3.

(* Where the side is known, the numbers are finite, and the exact volume has that sign. *)
Definition sides_right (known : bool * bool) (arguments : list float) exact :=
  (fst known = true -> Forall finite arguments /\ exact > 0) /\
  (snd known = true -> Forall finite arguments /\ exact < 0).
(* A side is known of what the bound lets through, with the sign of the value. *)
Lemma sides_of known below arguments exact : (known = true -> Forall finite arguments /\
  (below = true -> exact < 0) /\ (below = false -> exact > 0)) ->
  sides_right (known && negb below, known && below) arguments exact.
Proof.
intros W. split; intros [A B]%andb_prop; destruct (W A) as (F & N & P); (split; [exact F|]).
- apply negb_true_iff in B. exact (P B).
- exact (N B).
Qed.
