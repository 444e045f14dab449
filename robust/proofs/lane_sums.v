(* SPDX-License-Identifier: Apache-2.0 *)
(* Planes and balls in a lane. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model constants steps format floats ghost lanes.
From Filters Require Import lane_bounds lane_filters lane_turns lane_values.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.

Lemma up_bound fused c m : up m -> (-60 <= c <= 0)%Z -> up (bound fused c m).
Proof. intros. apply up_multiply_add; [assumption|apply up_number; lia|apply up_number; lia]. Qed.
(* the sign is certain: of E, at the last operation, and L, of the bound's size *)
Lemma signs j k D t T m B c e : est j spare D t T -> least_of k spare m T -> (j <= 16)%nat -> (k <= 16)%nat ->
  c <= 64 -> INR j + 1 / 2 <= c -> bpow radix2 e = c * v ->
  (1 - 3 * v) * (bpow radix2 e * m) + bpow radix2 (-1001) <= B ->
  (B < - D * (1 + v) -> t < 0) /\ (B < D * (1 + v) -> t > 0).
Proof. intros E L. pose proof (bpow_ge_0 radix2 (-1010)). apply (beyond_all j k spare spare D t T m B c e E L); lra.
  Qed.
Ltac within tac := eapply est_more; cycle 2; [tac|cbn; lia|small_rest].
Ltac at_least := eapply least_more; cycle 2; [lows_of|cbn; lia|small_rest].

(* normal . point + offset; the last sum cannot make the sign wrong. C = 4 v, three roundings before it. *)
Theorem lane_point_plane_right fused (nx ny nz offset x y z : float) :
  let '(known, set) := lane_point_plane fused nx ny nz offset x y z in
  certain known set [nx; ny; nz; offset; x; y; z] (nx * x + ny * y + nz * z + offset) /\
  (known = true -> ~ (value nx = 0 /\ value ny = 0 /\ value nz = 0)).
Proof.
cbv beta zeta delta [lane_point_plane]. set (p := times nx x). set (q := times ny y). set (r := times nz z).
set (m := plus (plus (plus (size p) (size q)) (size r)) (size offset)).
set (s := plus (plus p q) r). change (multiply_add _ _ _ _) with (bound fused (-51) m).
set (products := plus (plus (size p) (size q)) (size r)) in *.
assert (U : up m) by (unfold m, products; ups). assert (UB := up_bound fused (-51) m U ltac:(lia)).
enough (W : above (size (plus s offset)) (bound fused (-51) m) && above products (number 0 0) = true ->
  Forall finite [nx; ny; nz; offset; x; y; z] /\
  (negative_lane (plus s offset) = true -> nx * x + ny * y + nz * z + offset < 0) /\
  (negative_lane (plus s offset) = false -> nx * x + ny * y + nz * z + offset > 0) /\
  ~ (value nx = 0 /\ value ny = 0 /\ value nz = 0)).
{ split; [intros K; destruct (W K) as (? & ? & ? & _); auto|intros K; now apply W]. }
intros [A G]%andb_prop. destruct (bound_says _ _ _ _ A U ltac:(lia)) as (M & FB & BL).
assert (PB := up_value _ UB). set (b := bound fused (-51) m) in *. clearbody b. clear UB.
assert (M' := M). unfold m, products in M'. finites.
assert (D1 : dominated p (size p)) by (now apply dominated_size). assert (D2 : dominated q (size q)) by (now apply
  dominated_size).
assert (D3 : dominated r (size r)) by (now apply dominated_size).
assert (D4 := dominated_plus _ _ _ _ D1 D2 ltac:(assumption)). assert (D5 := dominated_plus _ _ _ _ D4 D3
  ltac:(assumption)).
fold s in D5. destruct D5 as (FS & _ & _). destruct (sure_plus s offset b FS ltac:(assumption) PB FB A) as [SN SP].
unfold s, m, products, p, q, r in *. finites.
assert (E : est 3 spare (plus (plus (times nx x) (times ny y)) (times nz z) + offset) (nx * x + ny * y + nz * z +
  offset)
  (Rabs nx * Rabs x + Rabs ny * Rabs y + Rabs nz * Rabs z + Rabs offset)) 
  by (within ltac:(eapply est_sum; [ests|apply of_given])).
assert (L : least_of 4 spare (plus products (size offset))
  (Rabs nx * Rabs x + Rabs ny * Rabs y + Rabs nz * Rabs z + Rabs offset)) by (unfold products; at_least).
destruct (signs _ _ _ _ _ _ _ 4 (-51) E L ltac:(lia) ltac:(lia) ltac:(lra) ltac:(simpl; lra) ltac:(rewrite v_is;
  simpl; lra) BL)
  as [N P].
split; [repeat constructor; assumption|]. split; [intros K; now apply N, SN|]. split; [intros K; now apply P, SP|].
intros (Z1 & Z2 & Z3). destruct (number_value 0 0) as [FZ VZ]; [lia|lia|]. rewrite Rmult_0_l in VZ.
assert (FP : finite products) by (unfold m in M; now apply plus_finite in M).
apply (above_finite _ _ FP FZ) in G. rewrite VZ in G.
assert (Q : forall n0 c : float, finite (times n0 c) -> value n0 = 0 -> value (size (times n0 c)) = 0).
{ intros n0 c (_ & _ & E0)%times_finite Z0. unfold size, value in *. rewrite B2R_Babs, E0, Z0, Rmult_0_l, rnd_0,
  Rabs_R0. reflexivity. }
unfold products, p, q, r in *.
destruct (plus_finite _ _ FP) as (F1 & _ & V1). destruct (plus_finite _ _ F1) as (_ & _ & V2).
rewrite V1, V2, (Q nx x), (Q ny y), (Q nz z) in G by assumption.
replace (0 + 0) with 0 in G by ring. rewrite rnd_0 in G. replace (0 + 0) with 0 in G by ring. rewrite rnd_0 in G. lra.
Qed.

(* Balls: the square of the radii's sum less that of the distance. C = 8 v, five roundings. *)
Lemma lesser_above x y z : finite x -> finite y -> finite z -> above (lesser x y) z = true ->
  value z < value x /\ value z < value y.
Proof.
unfold lesser. intros X Y Z A. destruct (above y x) eqn:Q.
- apply (above_finite _ _ X Z) in A. apply (above_finite _ _ Y X) in Q. lra.
- apply (above_finite _ _ Y Z) in A. assert (~ value x < value y) by (rewrite <- (above_finite _ _ Y X), Q;
  discriminate). lra.
Qed.
Definition square r := r * r.
Lemma square_nonneg r : 0 <= r * r. Proof. exact (Rle_0_sqr r). Qed.
Lemma square_abs r : Rabs r * Rabs r = square r.
Proof. unfold square. rewrite <- Rabs_mult. apply Rabs_right. nra. Qed.

(* A difference of two numbers that are not negative, with its bound. *)
Lemma balls_right fused inside outside (i o : R) : est 5 (spare / 8) (value inside) i i -> est 5 (spare / 8) (value
  outside) o o ->
  up inside -> up outside -> 0 <= i -> 0 <= o ->
  (finite (plus inside outside) -> finite inside /\ finite outside) ->
  above (size (minus inside outside)) (bound fused (-50) (plus inside outside)) = true ->
  (negative_lane (minus inside outside) = true -> i < o) /\ (negative_lane (minus inside outside) = false -> i > o).
Proof.
intros EI EO UI UO PI PO FF A. assert (U : up (plus inside outside)) by now apply up_plus.
destruct (bound_says _ _ _ _ A U ltac:(lia)) as (M & FB & BL). assert (PB := up_value _ (up_bound fused (-50) _ U
  ltac:(lia))).
destruct (FF M) as [FI FO]. set (b := bound fused (-50) (plus inside outside)) in *. clearbody b.
destruct (sure_minus inside outside b FI FO PB FB A) as [SN SP].
pose proof (bpow_gt_0 radix2 (-1010)) as sp.
assert (E : est 5 spare (value inside - value outside) (i - o) (i + o)).
{ eapply est_more; cycle 2; [apply (est_difference _ _ _ _ _ _ _ _ _ _ EI EO)|cbn; lia|lra]. }
assert (low_of : forall z r, est 5 (spare / 8) z r r -> least_of 6 (spare / 8) z r).
{ intros z r (x' & [O1 O2] & D). exists x'. split; [|apply abs_le in D; lra]. pose proof v_tiny as V.
  assert (0 <= r) by (pose proof (Rabs_pos r); lra).
  assert (K : (1 + v) ^ 5 - 1 <= 6 * v /\ (1 - v) ^ 6 <= 1 - (1 + v) ^ 5 + 1).
  { pose proof (bernoulli_up v v_small 5 ltac:(simpl; lra)). pose proof (bernoulli_up v v_small 1). simpl INR in *.
    split; [rewrite v_is; simpl; lra|rewrite v_is; simpl; lra]. }
  destruct K as [K1 K2]. apply abs_le in O2.
  assert (((1 + v) ^ 5 - 1) * r <= 6 * v * r) by (apply Rmult_le_compat_r; lra).
  assert ((1 - v) ^ 6 * r <= (1 - (1 + v) ^ 5 + 1) * r) by (apply Rmult_le_compat_r; lra).
  assert (v * r <= / 1048576 * r) by (apply Rmult_le_compat_r; lra). split; lra. }
assert (L : least_of 7 spare (value (plus inside outside)) (i + o)).
{ eapply least_more; cycle 2.
  - apply (low_plus 6 6 (spare / 8) (spare / 8)); auto; lra.
  - cbn. lia.
  - lra. }
destruct (signs _ _ _ _ _ _ _ 8 (-50) E L ltac:(lia) ltac:(lia) ltac:(lra) ltac:(simpl; lra) ltac:(rewrite v_is;
  simpl; lra) BL)
  as [N P].
split; intros K; [specialize (N (SN K))|specialize (P (SP K))]; lra.
Qed.
Lemma est_of_squares j A x t T : est j A x t T -> T = t -> est j A x t t.
Proof. now intros E ->. Qed.
Ltac squares := eapply est_of_squares; [within ltac:(idtac; ests)|rewrite !square_abs; unfold square; ring].
Ltac zero_value := let V := fresh "V0" in let F := fresh "F0" in
  destruct (number_value 0 0) as [F V]; [lia|lia|]; rewrite Rmult_0_l in V.

Theorem lane_spheres_2_right fused (ax ay ar bx by_ br : float) :
  let '(known, set) := lane_spheres_2 fused ax ay ar bx by_ br in
  certain known set [ax; ay; ar; bx; by_; br]
    ((ar + br) * (ar + br) - ((by_ - ay) * (by_ - ay) + (bx - ax) * (bx - ax))) /\
  (known = true -> value ar > 0 /\ value br > 0).
Proof.
cbv beta zeta delta [lane_spheres_2]. set (reach := plus ar br). set (dx := minus bx ax). set (dy := minus by_ ay).
set (outside := multiply_add fused dy dy (times dx dx)). set (inside := times reach reach).
change (multiply_add fused (plus inside outside) _ _) with (bound fused (-50) (plus inside outside)).
enough (W : above (size (minus inside outside)) (bound fused (-50) (plus inside outside)) && above (lesser ar br)
  (number 0 0) = true ->
  (Forall finite [ax; ay; ar; bx; by_; br] /\ (value ar > 0 /\ value br > 0)) /\
  (negative_lane (minus inside outside) = true -> (ar + br) * (ar + br) < (by_ - ay) * (by_ - ay) + (bx - ax) * (bx -
    ax)) /\
  (negative_lane (minus inside outside) = false -> (ar + br) * (ar + br) > (by_ - ay) * (by_ - ay) + (bx - ax) * (bx
    - ax))).
{ split; intros K; destruct (W K) as ((F & P) & S1 & S2); [|exact P]. split; [exact F|].
  split; intros N; [specialize (S1 N)|specialize (S2 N)]; lra. }
intros [A G]%andb_prop. assert (UI : up inside) by (unfold inside; ups). assert (UO : up outside) by (unfold outside;
  ups).
destruct (bound_says _ _ _ _ A ltac:(now apply up_plus) ltac:(lia)) as (M & _ & _).
subst inside outside reach dx dy. finites. zero_value.
apply (lesser_above ar br) in G; try assumption. rewrite V0 in G. destruct G as [G1 G2].
split; [split; [repeat constructor; assumption|split; lra]|].
eapply (balls_right fused); eauto.
all: try (intros _; split; assumption).
all: try solve [squares].
all: repeat apply Rplus_le_le_0_compat; apply square_nonneg.
Qed.
Theorem lane_spheres_3_right fused (ax ay az ar bx by_ bz br : float) :
  let '(known, set) := lane_spheres_3 fused ax ay az ar bx by_ bz br in
  certain known set [ax; ay; az; ar; bx; by_; bz; br] ((ar + br) * (ar + br) -
    ((bz - az) * (bz - az) + ((by_ - ay) * (by_ - ay) + (bx - ax) * (bx - ax)))) /\
  (known = true -> value ar > 0 /\ value br > 0).
Proof.
cbv beta zeta delta [lane_spheres_3]. set (reach := plus ar br). set (dx := minus bx ax). set (dy := minus by_ ay).
set (dz := minus bz az). set (outside := multiply_add fused dz dz (multiply_add fused dy dy (times dx dx))).
set (inside := times reach reach).
change (multiply_add fused (plus inside outside) _ _) with (bound fused (-50) (plus inside outside)).
set (o := (bz - az) * (bz - az) + ((by_ - ay) * (by_ - ay) + (bx - ax) * (bx - ax))).
enough (W : above (size (minus inside outside)) (bound fused (-50) (plus inside outside)) && above (lesser ar br)
  (number 0 0) = true ->
  (Forall finite [ax; ay; az; ar; bx; by_; bz; br] /\ (value ar > 0 /\ value br > 0)) /\
  (negative_lane (minus inside outside) = true -> (ar + br) * (ar + br) < o) /\
  (negative_lane (minus inside outside) = false -> (ar + br) * (ar + br) > o)).
{ split; intros K; destruct (W K) as ((F & P) & S1 & S2); [|exact P]. split; [exact F|].
  split; intros N; [specialize (S1 N)|specialize (S2 N)]; lra. }
intros [A G]%andb_prop. assert (UI : up inside) by (unfold inside; ups). assert (UO : up outside) by (unfold outside;
  ups).
destruct (bound_says _ _ _ _ A ltac:(now apply up_plus) ltac:(lia)) as (M & _ & _).
subst inside outside reach dx dy dz. finites. zero_value.
apply (lesser_above ar br) in G; try assumption. rewrite V0 in G. destruct G as [G1 G2].
split; [split; [repeat constructor; assumption|split; lra]|].
subst o; eapply (balls_right fused); eauto.
all: try (intros _; split; assumption).
all: try solve [squares].
all: repeat apply Rplus_le_le_0_compat; apply square_nonneg.
Qed.
