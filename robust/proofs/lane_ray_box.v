(* SPDX-License-Identifier: Apache-2.0 *)
(* Rays with boxes in a lane: comparisons along the axes of the box, and products across the ray and two of them. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model constants steps format floats ghost lanes.
From Filters Require Import lane_bounds lane_turns lane_values lane_sums lane_boxes lane_shape_filters lane_faces.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.
#[local] Existing Instances p53 fexp_valid below_1024.

(* Separating axes of real numbers: o + t w between low and high. Twice the origin as seen from the center, and
   the width. *)
Definition from_center o low high := o - low + (o - high).
Definition axis_apart o w low high := (low > o /\ w <= 0) \/ (o > high /\ w >= 0).
Definition across w0 s0 h0 w1 s1 h1 := Rabs (w0 * s1 - w1 * s0) - (Rabs w0 * h1 + Rabs w1 * h0).

Lemma axis_apart_says o w low high t : axis_apart o w low high -> 0 <= t -> ~ within low high (o + t * w).
Proof. unfold within. intros [[A B]|[A B]] T [C D]; nra. Qed.
Lemma across_sym w0 s0 h0 w1 s1 h1 : across w0 s0 h0 w1 s1 h1 = across w1 s1 h1 w0 s0 h0.
Proof. unfold across. rewrite Rabs_minus_sym. ring. Qed.
Lemma across_says o0 w0 l0 h0 o1 w1 l1 h1 t :
  across w0 (from_center o0 l0 h0) (h0 - l0) w1 (from_center o1 l1 h1) (h1 - l1) > 0 ->
  ~ (within l0 h0 (o0 + t * w0) /\ within l1 h1 (o1 + t * w1)).
Proof.
unfold within, across. intros A [B C]. set (x0 := from_center o0 l0 h0 + 2 * t * w0).
set (x1 := from_center o1 l1 h1 + 2 * t * w1).
assert (X0 : Rabs x0 <= h0 - l0) by (apply Rabs_le; unfold x0, from_center; lra).
assert (X1 : Rabs x1 <= h1 - l1) by (apply Rabs_le; unfold x1, from_center; lra).
replace (w0 * from_center o1 l1 h1 - w1 * from_center o0 l0 h0) with (w0 * x1 - w1 * x0) in A by (unfold x0, x1; ring).
assert (T : Rabs (w0 * x1 - w1 * x0) <= Rabs w0 * Rabs x1 + Rabs w1 * Rabs x0).
{ unfold Rminus. apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_Ropp, !Rabs_mult. apply Rle_refl. }
assert (Rabs w0 * Rabs x1 <= Rabs w0 * (h1 - l1)) by (apply Rmult_le_compat_l; [apply Rabs_pos|exact X1]).
assert (Rabs w1 * Rabs x0 <= Rabs w1 * (h0 - l0)) by (apply Rmult_le_compat_l; [apply Rabs_pos|exact X0]). lra.
Qed.

(* When the ray enters the slab and when it leaves it; where it is parallel, it is in the slab from 0 on. *)
Definition enters o w low high :=
  if Req_EM_T w 0 then 0 else if Rlt_dec 0 w then (low - o) / w else (o - high) / - w.
Definition leaves o w low high := if Rlt_dec 0 w then (high - o) / w else (o - low) / - w.
Lemma fractions x y a b : 0 < a -> 0 < b -> x * b <= y * a -> x / a <= y / b.
Proof.
intros A B L. apply Rmult_le_reg_r with (a * b); [nra|].
replace (x / a * (a * b)) with (x * b) by (field; lra). replace (y / b * (a * b)) with (y * a) by (field; lra). exact L.
Qed.
Lemma enters_in_time o w low high t : low <= high -> ~ axis_apart o w low high -> enters o w low high <= t ->
  (w <> 0 -> t <= leaves o w low high) -> within low high (o + t * w).
Proof.
unfold axis_apart, enters, leaves, within. intros L A E X. destruct (Req_EM_T w 0) as [->|N]; [nra|].
specialize (X N). destruct (Rlt_dec 0 w) as [P|P].
- apply (Rmult_le_compat_r w) in E, X; try lra. replace ((low - o) / w * w) with (low - o) in E by (field; lra).
  replace ((high - o) / w * w) with (high - o) in X by (field; lra). lra.
- apply (Rmult_le_compat_r (- w)) in E, X; try lra.
  replace ((o - high) / - w * - w) with (o - high) in E by (field; lra).
  replace ((o - low) / - w * - w) with (o - low) in X by (field; lra). lra.
Qed.
Lemma leaves_later o w low high : w <> 0 -> ~ axis_apart o w low high -> 0 <= leaves o w low high.
Proof.
unfold axis_apart, leaves. intros N A. destruct (Rlt_dec 0 w) as [P|P].
- assert (0 <= high - o) by lra. apply Rmult_le_pos; [assumption|]. left. now apply Rinv_0_lt_compat.
- assert (0 <= o - low) by lra. apply Rmult_le_pos; [assumption|]. left. apply Rinv_0_lt_compat. lra.
Qed.
Lemma leaves_after o w low high : low <= high -> w <> 0 -> enters o w low high <= leaves o w low high.
Proof.
unfold enters, leaves. intros L N. destruct (Req_EM_T w 0) as [Z|_]; [lra|].
destruct (Rlt_dec 0 w); apply fractions; nra.
Qed.
Lemma enters_before o0 w0 l0 h0 o1 w1 l1 h1 : w1 <> 0 -> ~ axis_apart o1 w1 l1 h1 ->
  across w0 (from_center o0 l0 h0) (h0 - l0) w1 (from_center o1 l1 h1) (h1 - l1) < 0 \/ (w0 = 0 /\ w1 = 0) ->
  enters o0 w0 l0 h0 <= leaves o1 w1 l1 h1.
Proof.
intros N A [M|M]; [|lra]. pose proof (leaves_later _ _ _ _ N A) as Z. unfold enters.
destruct (Req_EM_T w0 0) as [_|N0]; [exact Z|]. clear Z A. unfold across, from_center in M. unfold leaves.
pose proof (Rle_abs (w0 * (o1 - l1 + (o1 - h1)) - w1 * (o0 - l0 + (o0 - h0)))) as P.
pose proof (Rle_abs (- (w0 * (o1 - l1 + (o1 - h1)) - w1 * (o0 - l0 + (o0 - h0))))) as Q. rewrite Rabs_Ropp in Q.
set (m := Rabs (_ - _)) in *. clearbody m.
destruct (Rlt_dec 0 w0) as [P0|P0], (Rlt_dec 0 w1) as [P1|P1]; apply fractions; try lra;
  [rewrite (Rabs_right w0), (Rabs_right w1) in M by lra|rewrite (Rabs_right w0), (Rabs_left w1) in M by lra|
   rewrite (Rabs_left w0), (Rabs_right w1) in M by lra|rewrite (Rabs_left w0), (Rabs_left w1) in M by lra]; lra.
Qed.
(* The ray meets the box when it has entered all slabs, if it does so before it leaves any. *)
Definition pair_meets o0 w0 l0 h0 o1 w1 l1 h1 :=
  across w0 (from_center o0 l0 h0) (h0 - l0) w1 (from_center o1 l1 h1) (h1 - l1) < 0 \/ (w0 = 0 /\ w1 = 0).
Lemma pair_meets_sym o0 w0 l0 h0 o1 w1 l1 h1 :
  pair_meets o0 w0 l0 h0 o1 w1 l1 h1 -> pair_meets o1 w1 l1 h1 o0 w0 l0 h0.
Proof. unfold pair_meets. rewrite across_sym. tauto. Qed.
Lemma meets_2 ox wx lx hx oy wy ly hy : lx <= hx -> ly <= hy -> ~ axis_apart ox wx lx hx -> ~ axis_apart oy wy ly hy ->
  pair_meets ox wx lx hx oy wy ly hy ->
  exists t, 0 <= t /\ within lx hx (ox + t * wx) /\ within ly hy (oy + t * wy).
Proof.
intros LX LY AX AY XY. assert (YX := pair_meets_sym _ _ _ _ _ _ _ _ XY).
set (ex := enters ox wx lx hx). set (ey := enters oy wy ly hy). exists (Rmax 0 (Rmax ex ey)).
pose proof (Rmax_l 0 (Rmax ex ey)). pose proof (Rmax_r 0 (Rmax ex ey)). pose proof (Rmax_l ex ey).
pose proof (Rmax_r ex ey). split; [assumption|].
split; (apply enters_in_time; [assumption|assumption|fold ex ey; lra|intros N; repeat apply Rmax_lub]);
  first [now apply leaves_later|now apply leaves_after|now apply enters_before].
Qed.
Lemma meets_3 ox wx lx hx oy wy ly hy oz wz lz hz : lx <= hx -> ly <= hy -> lz <= hz ->
  ~ axis_apart ox wx lx hx -> ~ axis_apart oy wy ly hy -> ~ axis_apart oz wz lz hz ->
  pair_meets ox wx lx hx oy wy ly hy -> pair_meets oy wy ly hy oz wz lz hz -> pair_meets oz wz lz hz ox wx lx hx ->
  exists t, 0 <= t /\ within lx hx (ox + t * wx) /\ within ly hy (oy + t * wy) /\ within lz hz (oz + t * wz).
Proof.
intros LX LY LZ AX AY AZ XY YZ ZX. assert (YX := pair_meets_sym _ _ _ _ _ _ _ _ XY).
assert (ZY := pair_meets_sym _ _ _ _ _ _ _ _ YZ). assert (XZ := pair_meets_sym _ _ _ _ _ _ _ _ ZX).
set (ex := enters ox wx lx hx). set (ey := enters oy wy ly hy). set (ez := enters oz wz lz hz).
exists (Rmax 0 (Rmax ex (Rmax ey ez))). pose proof (Rmax_l 0 (Rmax ex (Rmax ey ez))).
pose proof (Rmax_r 0 (Rmax ex (Rmax ey ez))). pose proof (Rmax_l ex (Rmax ey ez)).
pose proof (Rmax_r ex (Rmax ey ez)). pose proof (Rmax_l ey ez). pose proof (Rmax_r ey ez). split; [assumption|].
split; [|split]; (apply enters_in_time; [assumption|assumption|fold ex ey ez; lra|intros N; repeat apply Rmax_lub]);
  first [now apply leaves_later|now apply leaves_after|now apply enters_before].
Qed.

(* One axis in a lane. *)
Definition start o low high := plus (minus o low) (minus o high).
Definition size_of o low high := plus (plus (size (minus o low)) (size (minus o high))) (size (minus high low)).
Record axis (s m h : float) (s' S h' : R) := {
  start_fits : dominated s m; width_fits : dominated h m; size_up : up m;
  start_near : est 2 0 s s' S; width_near : est 1 0 h h' (Rabs h'); size_least : least_of 3 0 m (S + Rabs h') }.
Lemma dominated_second x m t : dominated x m -> up t -> finite (plus t m) -> dominated x (plus t m).
Proof.
intros (X & M & L) T F. pose proof (plus_finite _ _ F) as (_ & _ & E). split; [exact X|]. split; [exact F|].
apply Rle_trans with (1 := L). rewrite E, <- (rnd_held (value m)) at 1 by apply held_value. apply rnd_le.
apply up_value in T. lra.
Qed.
Lemma axis_says o low high : finite (size_of o low high) ->
  axis (start o low high) (size_of o low high) (minus high low) (from_center o low high)
    (Rabs (o - low) + Rabs (o - high)) (high - low).
Proof.
unfold size_of. intros F. destruct (plus_finite _ _ F) as (F1 & F2 & _). destruct (plus_finite _ _ F1) as (F3 & F4 & _).
apply size_finite in F2 as [F2 _]. apply size_finite in F3 as [F3 _]. apply size_finite in F4 as [F4 _].
assert (D : dominated (start o low high) (plus (size (minus o low)) (size (minus o high)))).
{ apply dominated_plus; [now apply dominated_size..|exact F1]. }
split.
- apply dominated_more; [exact D|ups|exact F].
- apply dominated_second; [now apply dominated_size|ups|exact F].
- ups.
- unfold from_center. eapply est_more; cycle 2; [eapply of_plus; [apply D|now apply of_difference..]|cbn; lia|lra].
- now apply of_difference.
- eapply least_more; cycle 2; [|apply Nat.le_refl|apply Rle_refl].
  apply (least_more 3 3 (2 * (2 * (0 + 0) + 0)) 0); [lia|lra|].
  apply (low_plus 2 1); try (now ups); try lra; [|now apply low_of_difference].
  apply (low_plus 1 1); try (now ups); try lra; now apply low_of_difference.
Qed.

(* What exceeds a bound that is not negative, and so does the number that it is the opposite of. *)
Lemma above_itself z b : above z b = true -> up b -> finite b -> above (size z) b = true /\ negative_lane z = false.
Proof.
intros A U F. apply above_true in A as [[Z A]| ->]; [|destruct b as [|[]| |]; try discriminate F; now split|exact F].
apply up_value in U. assert (P : 0 < value z) by lra.
assert (N : negative_lane z = false).
{ unfold negative_lane. destruct (Bsign z) eqn:S; [|reflexivity]. apply sign_value in S. lra. }
split; [|exact N]. apply above_finite; [now destruct z|exact F|].
unfold size, value in *. rewrite B2R_Babs, Rabs_right; lra.
Qed.
Lemma above_opposite z b : above (minus zero z) b = true -> up b -> finite b ->
  above (size z) b = true /\ negative_lane z = true.
Proof.
intros A U F. destruct (finite_case z) as [Z|[->|[->| ->]]].
- destruct zero_is as [Z0 V0]. assert (M : finite (minus zero z) /\ value (minus zero z) = - value z).
  { pose proof (held_value z) as H. assert (R : rnd (value zero - value z) = - value z).
    { rewrite V0. replace (0 - value z) with (- value z) by ring. now rewrite rnd_opp, rnd_held. }
    unfold minus. cases_of (Bminus_correct 53 1024 _ _ mode_NE zero z Z0 Z); fold (rnd (value zero - value z)) in *.
    - intros (V & K & _). rewrite V. now split.
    - rewrite R, Rabs_Ropp in L. pose proof (below_high z). lra. }
  destruct M as [M V]. apply (above_finite _ _ M F) in A. rewrite V in A. apply up_value in U.
  assert (N : negative_lane z = true).
  { unfold negative_lane. destruct (Bsign z) eqn:S; [reflexivity|]. apply sign_value in S. lra. }
  split; [|exact N]. apply above_finite; [now destruct z|exact F|].
  unfold size, value in *. rewrite B2R_Babs, Rabs_left1; lra.
- destruct b as [|[]| |]; try discriminate F; now split.
- destruct b as [|[]| |]; try discriminate F; discriminate A.
- destruct b as [|[]| |]; try discriminate F; discriminate A.
Qed.
Lemma dominated_self x : finite x -> up x -> dominated x x.
Proof. intros F U. repeat split; try exact F. apply up_value in U. rewrite Rabs_right; lra. Qed.

(* Four roundings in units of the sizes; C = 8 v. *)
Definition pair_value (w0 s0 h0 w1 s1 h1 : float) :=
  minus (size (minus (times w0 s1) (times w1 s0))) (plus (times (size w0) h1) (times (size w1) h0)).
Definition pair_terms w0 m0 w1 m1 := plus (times (size w0) m1) (times (size w1) m0).
Lemma pair_says fused (w0 s0 m0 h0 w1 s1 m1 h1 : float) s0' S0 h0' s1' S1 h1' :
  axis s0 m0 h0 s0' S0 h0' -> axis s1 m1 h1 s1' S1 h1' ->
  let z := pair_value w0 s0 h0 w1 s1 h1 in let b := bound fused (-50) (pair_terms w0 m0 w1 m1) in
  (above z b = true -> across w0 s0' h0' w1 s1' h1' > 0) /\
  (above (minus zero z) b = true -> across w0 s0' h0' w1 s1' h1' < 0).
Proof.
intros [SF0 WF0 U0 SN0 WN0 L0] [SF1 WF1 U1 SN1 WN1 L1] z b.
assert (U : up (pair_terms w0 m0 w1 m1)) by (unfold pair_terms; ups).
assert (UB : up b) by (apply up_bound; [exact U|lia]).
enough (W : above (size z) b = true -> (negative_lane z = true -> across w0 s0' h0' w1 s1' h1' < 0) /\
  (negative_lane z = false -> across w0 s0' h0' w1 s1' h1' > 0)).
{ split; intros A; pose proof (above_bound _ _ A UB) as FB.
  - destruct (above_itself _ _ A UB FB) as [A' N]. now apply W.
  - destruct (above_opposite _ _ A UB FB) as [A' N]. now apply W. }
intros A. destruct (bound_says _ _ _ _ A U ltac:(lia)) as (M & FB & BL). assert (PB := up_value _ UB).
unfold pair_terms in M. destruct (plus_finite _ _ M) as (M1 & M2 & _).
destruct (times_finite _ _ M1) as (FW0 & _). destruct (times_finite _ _ M2) as (FW1 & _).
assert (FS0 := FW0). apply size_finite in FS0 as [FS0 _]. assert (FS1 := FW1). apply size_finite in FS1 as [FS1 _].
assert (D1 : dominated (times w0 s1) (times (size w0) m1))
  by (apply dominated_times; [now apply dominated_size|exact SF1|exact M1]).
assert (D2 : dominated (times w1 s0) (times (size w1) m0))
  by (apply dominated_times; [now apply dominated_size|exact SF0|exact M2]).
assert (D3 : dominated (times (size w0) h1) (times (size w0) m1))
  by (apply dominated_times; [apply dominated_self; [exact FW0|ups]|exact WF1|exact M1]).
assert (D4 : dominated (times (size w1) h0) (times (size w1) m0))
  by (apply dominated_times; [apply dominated_self; [exact FW1|ups]|exact WF0|exact M2]).
assert (DA := dominated_minus _ _ _ _ D1 D2 M). assert (DB := dominated_plus _ _ _ _ D3 D4 M).
destruct DA as (FA & _). destruct DB as (FC & _). destruct D1 as (F1 & _). destruct D2 as (F2 & _).
destruct D3 as (F3 & _). destruct D4 as (F4 & _).
assert (FA' : finite (size (minus (times w0 s1) (times w1 s0)))) by (now destruct (minus (times w0 s1) (times w1 s0))).
destruct (sure_minus _ _ b FA' FC PB FB A) as [SN SP].
assert (E : est 4 spare (size (minus (times w0 s1) (times w1 s0)) - plus (times (size w0) h1) (times (size w1) h0))
  (across w0 s0' h0' w1 s1' h1') (Rabs w0 * S1 + Rabs w1 * S0 + (Rabs w0 * Rabs h1' + Rabs w1 * Rabs h0'))).
{ unfold across. within ltac:(eapply est_difference;
    [apply of_size; eapply of_minus; [exact FA|eapply of_times; [exact F1|apply of_given|exact SN1]|
      eapply of_times; [exact F2|apply of_given|exact SN0]]|
     eapply of_plus; [exact FC|eapply of_times; [exact F3|apply of_size, of_given|exact WN1]|
      eapply of_times; [exact F4|apply of_size, of_given|exact WN0]]]). }
assert (L : least_of 5 spare (pair_terms w0 m0 w1 m1) (Rabs w0 * (S1 + Rabs h1') + Rabs w1 * (S0 + Rabs h0'))).
{ unfold pair_terms. pose proof eta_pos. eapply least_more; cycle 2.
  - eapply low_plus; [exact M|ups; assumption..| | |eapply low_times; [exact M1|apply low_of_given|exact L1]|
      eapply low_times; [exact M2|apply low_of_given|exact L0]]; lra.
  - cbn. lia.
  - small_rest. }
replace (Rabs w0 * (S1 + Rabs h1') + Rabs w1 * (S0 + Rabs h0')) with
  (Rabs w0 * S1 + Rabs w1 * S0 + (Rabs w0 * Rabs h1' + Rabs w1 * Rabs h0')) in L by ring.
destruct (signs _ _ _ _ _ _ _ 8 (-50) E L ltac:(lia) ltac:(lia) ltac:(lra) ltac:(simpl; lra) ltac:(rewrite v_is;
  simpl; lra) BL) as [N P].
split; intros K; [exact (N (SN K))|exact (P (SP K))].
Qed.

(* Comparisons along an axis, and what asks for directions and widths. *)
Definition axis_bit o w low high := above low o && not_below zero w || above o high && not_below w zero.
Lemma axis_bit_says (o w low high : float) : finite o -> finite w -> finite low -> finite high ->
  (axis_bit o w low high = true -> axis_apart o w low high) /\
  (axis_bit o w low high = false -> ~ axis_apart o w low high).
Proof.
intros O W L H. destruct zero_is as [Z V]. pose proof (above_finite low o L O) as A.
pose proof (above_finite o high O H) as B.
pose proof (not_below_finite zero w Z W) as C. pose proof (not_below_finite w zero W Z) as D. rewrite V in C, D.
unfold axis_bit, axis_apart. destruct (above low o), (above o high), (not_below zero w), (not_below w zero); simpl;
  (split; [intros E|intros E F]); try discriminate; intuition lra.
Qed.
Lemma both_zero w0 w1 : equal (plus (size w0) (size w1)) zero = true -> value w0 = 0 /\ value w1 = 0.
Proof.
intros E. destruct zero_is as [Z V]. assert (F : finite (plus (size w0) (size w1))).
{ destruct (plus (size w0) (size w1)) as [|[]| |]; try reflexivity; discriminate E. }
unfold equal in E. rewrite Bcompare_correct in E by assumption. revert E. change (@B2R 53 1024) with value.
rewrite V. destruct (Rcompare_spec (value (plus (size w0) (size w1))) 0) as [|Q|]; try discriminate. intros _.
destruct (plus_finite _ _ F) as (_ & _ & E). rewrite E in Q. unfold size, value in Q. rewrite !B2R_Babs in Q.
fold (value w0) (value w1) in Q.
destruct (rnd_sum (Rabs w0) (Rabs w1) (held_abs _ (held_value w0)) (held_abs _ (held_value w1))) as (e & B & R).
rewrite R in Q. apply abs_le in B. pose proof v_small. pose proof (Rabs_pos w0). pose proof (Rabs_pos w1).
assert (S : Rabs w0 + Rabs w1 = 0) by nra.
split; [destruct (Req_dec w0 0) as [N|N]|destruct (Req_dec w1 0) as [N|N]]; try exact N; apply Rabs_pos_lt in N; lra.
Qed.
Lemma width_says low high : finite (minus high low) -> 0 <= value (minus high low) -> value low <= value high.
Proof.
intros F P. destruct (minus_finite _ _ F) as (_ & _ & E). rewrite E in P.
destruct (rnd_difference high low (held_value _) (held_value _)) as (e & B & R). rewrite R in P. apply abs_le in B.
pose proof v_small. nra.
Qed.
Lemma not_negative_least x y : finite x -> finite y -> not_below (lesser x y) zero = true ->
  not_below x zero = true /\ not_below y zero = true.
Proof.
intros X Y N. destruct (lesser_value _ _ X Y) as [F V]. destruct zero_is as [Z VZ].
rewrite (not_below_finite _ _ F Z), V in N. pose proof (Rmin_l x y). pose proof (Rmin_r x y).
split; apply not_below_finite; try assumption; lra.
Qed.
Lemma not_negative x : finite x -> not_below x zero = true -> 0 <= value x.
Proof. intros F N. destruct zero_is as [Z V]. rewrite <- V. now apply not_below_finite. Qed.
Lemma no_more w0 w1 : finite (plus w0 (size w1)) -> value w0 = 0 -> value w1 = 0 -> value (plus w0 (size w1)) = 0.
Proof.
intros (_ & _ & ->)%plus_finite -> Z. unfold size, value in *. rewrite B2R_Babs, Z, Rabs_R0, Rplus_0_l. apply rnd_0.
Qed.
Ltac bits := repeat match goal with
  | H : _ || _ = true |- _ => apply orb_prop in H as [H|H]
  | H : _ || _ = false |- _ => apply orb_false_elim in H as [? ?]
  | H : false = true |- _ => discriminate H end.

(* What a pair's lane says, with the bit for two directions that are both 0. *)
Lemma pair_bits fused (o0 w0 l0 h0 o1 w1 l1 h1 : float) : finite (size_of o0 l0 h0) -> finite (size_of o1 l1 h1) ->
  let z := pair_value w0 (start o0 l0 h0) (minus h0 l0) w1 (start o1 l1 h1) (minus h1 l1) in
  let b := bound fused (-50) (pair_terms w0 (size_of o0 l0 h0) w1 (size_of o1 l1 h1)) in
  (above z b = true -> forall t : R, ~ (within l0 h0 (o0 + t * w0) /\ within l1 h1 (o1 + t * w1))) /\
  (above (minus zero z) b || equal (plus (size w0) (size w1)) zero = true -> pair_meets o0 w0 l0 h0 o1 w1 l1 h1).
Proof.
intros F0 F1 z b.
destruct (pair_says fused w0 _ _ _ w1 _ _ _ _ _ _ _ _ _ (axis_says _ _ _ F0) (axis_says _ _ _ F1)) as [P M].
split.
- intros A t. apply across_says. exact (P A).
- intros [A|A]%orb_prop; [left; exact (M A)|right; now apply both_zero].
Qed.

(* Where it answers, all numbers are finite, the direction is not 0, and min <= max; where none, the ray has no point in
   the box, and where hit, it has one. *)
Theorem lane_ray_box_2_right fused (ox oy wx wy lx ly hx hy : float) :
  let '(known, set) := lane_ray_box_2 fused ox oy wx wy lx ly hx hy in
  known = true -> Forall finite [ox; oy; wx; wy; lx; ly; hx; hy] /\ (lx <= hx /\ ly <= hy) /\
  ~ (value wx = 0 /\ value wy = 0) /\
  (set = true -> forall t, 0 <= t -> ~ (within lx hx (ox + t * wx) /\ within ly hy (oy + t * wy))) /\
  (set = false -> exists t, 0 <= t /\ within lx hx (ox + t * wx) /\ within ly hy (oy + t * wy)).
Proof.
cbv beta zeta delta [lane_ray_box_2]. fold (size_of ox lx hx) (size_of oy ly hy).
fold (axis_bit ox wx lx hx) (axis_bit oy wy ly hy). intros [[[T W]%andb_prop H]%andb_prop K]%andb_prop.
apply total_finite in T; [|unfold size_of; ups]. destruct (plus_finite _ _ T) as (T1 & FW & _).
destruct (plus_finite _ _ T1) as (T2 & FY & _). destruct (plus_finite _ _ T2) as (_ & FX & _).
assert (FW' := FW). assert (FX' := FX). assert (FY' := FY). unfold size_of in FX', FY'. finites.
apply not_negative_least in H as [HX HY]; try assumption. apply not_negative, width_says in HX, HY; try assumption.
pose proof (pair_bits fused ox wx lx hx oy wy ly hy FX FY) as [P M].
cbv beta zeta delta [pair_value pair_terms start bound] in P, M.
destruct (axis_bit_says ox wx lx hx) as [PX MX]; try assumption.
destruct (axis_bit_says oy wy ly hy) as [PY MY]; try assumption.
split; [repeat constructor; assumption|]. split; [auto|]. split.
{ intros [Z1 Z2]. apply positive_value in W; [|exact FW]. rewrite no_more in W; try assumption; [lra|].
  apply no_more; try assumption. apply zero_is. }
split; intros S.
- clear K. intros t T0 [X Y]. bits.
  + exact (axis_apart_says _ _ _ _ _ (PX S) T0 X).
  + exact (axis_apart_says _ _ _ _ _ (PY S) T0 Y).
  + exact (P S t (conj X Y)).
- rewrite S, orb_false_l, andb_true_l in K. apply M in K. bits. apply meets_2; auto.
Qed.

Theorem lane_ray_box_3_right fused (ox oy oz wx wy wz lx ly lz hx hy hz : float) :
  let '(known, set) := lane_ray_box_3 fused ox oy oz wx wy wz lx ly lz hx hy hz in
  known = true -> Forall finite [ox; oy; oz; wx; wy; wz; lx; ly; lz; hx; hy; hz] /\
  (lx <= hx /\ ly <= hy /\ lz <= hz) /\ ~ (value wx = 0 /\ value wy = 0 /\ value wz = 0) /\
  (set = true -> forall t, 0 <= t ->
    ~ (within lx hx (ox + t * wx) /\ within ly hy (oy + t * wy) /\ within lz hz (oz + t * wz))) /\
  (set = false -> exists t, 0 <= t /\ within lx hx (ox + t * wx) /\ within ly hy (oy + t * wy) /\
    within lz hz (oz + t * wz)).
Proof.
cbv beta zeta delta [lane_ray_box_3]. fold (size_of ox lx hx) (size_of oy ly hy) (size_of oz lz hz).
fold (axis_bit ox wx lx hx) (axis_bit oy wy ly hy) (axis_bit oz wz lz hz).
intros [[[T W]%andb_prop H]%andb_prop K]%andb_prop.
apply total_finite in T; [|unfold size_of; ups]. destruct (plus_finite _ _ T) as (T1 & FW & _).
destruct (plus_finite _ _ T1) as (T2 & FZ & _). destruct (plus_finite _ _ T2) as (T3 & FY & _).
destruct (plus_finite _ _ T3) as (_ & FX & _). assert (FW' := FW). assert (FX' := FX). assert (FY' := FY).
assert (FZ' := FZ). unfold size_of in FX', FY', FZ'. finites.
apply not_negative_least in H as [H HZ]; try assumption; [|now apply lesser_value].
apply not_negative_least in H as [HX HY]; try assumption.
apply not_negative, width_says in HX, HY, HZ; try assumption.
pose proof (pair_bits fused ox wx lx hx oy wy ly hy FX FY) as [PXY MXY].
pose proof (pair_bits fused oy wy ly hy oz wz lz hz FY FZ) as [PYZ MYZ].
pose proof (pair_bits fused oz wz lz hz ox wx lx hx FZ FX) as [PZX MZX].
cbv beta zeta delta [pair_value pair_terms start bound] in PXY, MXY, PYZ, MYZ, PZX, MZX.
destruct (axis_bit_says ox wx lx hx) as [PX MX]; try assumption.
destruct (axis_bit_says oy wy ly hy) as [PY MY]; try assumption.
destruct (axis_bit_says oz wz lz hz) as [PZ MZ]; try assumption.
split; [repeat constructor; assumption|]. split; [auto|]. split.
{ intros (Z1 & Z2 & Z3). apply positive_value in W; [|exact FW]. rewrite no_more in W; try assumption; [lra|].
  apply no_more; try assumption. apply no_more; try assumption. apply zero_is. }
split; intros S.
- clear K. intros t T0 (X & Y & Z). bits.
  + exact (axis_apart_says _ _ _ _ _ (PX S) T0 X).
  + exact (axis_apart_says _ _ _ _ _ (PY S) T0 Y).
  + exact (axis_apart_says _ _ _ _ _ (PZ S) T0 Z).
  + exact (PXY S t (conj X Y)).
  + exact (PYZ S t (conj Y Z)).
  + exact (PZX S t (conj Z X)).
- rewrite S, orb_false_l, andb_true_l in K. apply andb_prop in K as [[K1 K2]%andb_prop K3].
  apply MXY in K1. apply MYZ in K2. apply MZX in K3. bits. apply meets_3; auto.
Qed.
