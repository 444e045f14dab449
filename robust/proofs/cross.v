(* SPDX-License-Identifier: Apache-2.0 *)
(* The ghost run of cross_sign, whose polynomial has the wrong sign: the argument of the comment in filters.h. *)
From Coq Require Import Reals Lra Psatz.
From Filters Require Import steps.
Open Scope R_scope.

Section Cross.
Variable u : R.
Hypothesis Hu : 0 < u <= 1/16.
Let K := (3 * u + u ^ 3) / 2.

(* l (1 + u) - r (1 - u) is greatest against (sqrt l + sqrt r)^2 where l is as great and r as small as can be *)
Lemma quadratic s t : 0 <= s -> 0 <= t -> s * (1 - u) <= t * (1 + u) ->
  s * s * (1 + u) - t * t * (1 - u) <= K * ((s + t) * (s + t)).
Proof.
intros Hs Ht H. unfold K.
assert (F : (3 * u + u ^ 3) / 2 * ((s + t) * (s + t)) - (s * s * (1 + u) - t * t * (1 - u))
  = (t * (1 + u) - s * (1 - u)) * (s * ((1 + u - (3 * u + u ^ 3) / 2) / (1 - u)) + t * (((3 * u + u ^ 3) / 2 + 1 - u)
    / (1 + u))))
  by (field; lra).
assert (0 <= (t * (1 + u) - s * (1 - u)) * (s * ((1 + u - (3 * u + u ^ 3) / 2) / (1 - u)) + t * (((3 * u + u ^ 3) / 2
  + 1 - u) / (1 + u)))).
{ assert (0 < u ^ 3 <= 1/16) by (simpl; assert (0 < u * u <= 1/16) by nra; nra).
  apply Rmult_le_pos; [lra|]. apply Rplus_le_le_0_compat; apply Rmult_le_pos; try lra; apply Rlt_le, Rdiv_lt_0_compat;
    lra. }
lra.
Qed.

Lemma ratio e : Rabs e <= u -> 1 - u <= 1 + e <= 1 + u.
Proof. intros H%abs_le. lra. Qed.

(* both products positive, the left one not greater *)
Lemma one_side p q e1 e2 e3 e4 e5 e6 X Y :
  Rabs e1 <= u -> Rabs e2 <= u -> Rabs e3 <= u -> Rabs e4 <= u -> Rabs e5 <= u -> Rabs e6 <= u ->
  0 <= p <= q ->
  let l := p * (1 + e1) * (1 + e2) in let r := q * (1 + e3) * (1 + e4) in
  l + r + 2 * sqrt (l * r) <= X * Y ->
  l * (1 + e5) - r * (1 + e6) <= K * (X * Y).
Proof.
intros H1%ratio H2%ratio H3%ratio H4%ratio H5%ratio H6%ratio Hpq l r HXY.
assert (Hl : 0 <= l) by (unfold l; repeat apply Rmult_le_pos; lra).
assert (Hr : 0 <= r) by (unfold r; repeat apply Rmult_le_pos; lra).
assert (Hl' : l <= p * ((1 + u) * (1 + u))) by (unfold l; rewrite Rmult_assoc; apply Rmult_le_compat_l; nra).
assert (Hr' : p * ((1 - u) * (1 - u)) <= r).
{ unfold r. rewrite Rmult_assoc. apply Rmult_le_compat; nra. }
apply Rle_trans with (l * (1 + u) - r * (1 - u)); [nra|].
assert (HK : 0 <= K) by (unfold K; simpl; nra).
apply Rle_trans with (K * ((sqrt l + sqrt r) * (sqrt l + sqrt r))).
- rewrite <- (sqrt_sqrt l Hl) at 1. rewrite <- (sqrt_sqrt r Hr) at 1.
  apply quadratic; auto using sqrt_pos.
  replace (1 - u) with (sqrt ((1 - u) * (1 - u))) by (apply sqrt_square; lra).
  replace (1 + u) with (sqrt ((1 + u) * (1 + u))) by (apply sqrt_square; lra).
  rewrite <- !sqrt_mult by nra. apply sqrt_le_1; nra.
- apply Rmult_le_compat_l; [exact HK|]. rewrite sqrt_mult in HXY by assumption.
  generalize (sqrt_sqrt l Hl) (sqrt_sqrt r Hr); nra.
Qed.

Lemma cauchy a b c d : Rabs (a * d) + Rabs (b * c) + 2 * sqrt (Rabs (a * d) * Rabs (b * c)) <= (Rabs a + Rabs c) *
  (Rabs b + Rabs d).
Proof.
rewrite !Rabs_mult.
generalize (Rabs_pos a) (Rabs_pos b) (Rabs_pos c) (Rabs_pos d).
generalize (Rabs a) (Rabs b) (Rabs c) (Rabs d). clear. intros a b c d A B C D.
assert (P1 : 0 <= a * b) by (apply Rmult_le_pos; assumption). assert (P2 : 0 <= c * d) by (apply Rmult_le_pos;
  assumption).
replace (a * d * (b * c)) with ((a * b) * (c * d)) by ring. rewrite sqrt_mult by assumption.
generalize (sqrt_sqrt _ P1) (sqrt_sqrt _ P2) (Rle_0_sqr (sqrt (a * b) - sqrt (c * d))). unfold Rsqr. nra.
Qed.

Lemma below x y : x <= 0 -> 0 <= y -> x * y <= 0.
Proof. intros X Y. rewrite <- (Rmult_0_l y). apply Rmult_le_compat_r; assumption. Qed.

(* v.x w.y - v.y w.x with exact v.x = a, v.y = b, w.x = c, w.y = d *)
Theorem wrong_sign a b c d e1 e2 e3 e4 e5 e6 :
  Rabs e1 <= u -> Rabs e2 <= u -> Rabs e3 <= u -> Rabs e4 <= u -> Rabs e5 <= u -> Rabs e6 <= u ->
  a * d <= b * c ->
  let vx := a * (1 + e1) in let wy := d * (1 + e2) in let vy := b * (1 + e3) in let wx := c * (1 + e4) in
  vx * wy * (1 + e5) - vy * wx * (1 + e6) <= K * ((Rabs vx + Rabs wx) * (Rabs vy + Rabs wy)).
Proof.
intros H1 H2 H3 H4 H5 H6 H vx wy vy wx.
pose proof (cauchy vx vy wx wy) as HC.
assert (HK : 0 <= K) by (unfold K; simpl; nra).
assert (L : vx * wy = (a * d) * (1 + e1) * (1 + e2)) by (unfold vx, wy; ring).
assert (R : vy * wx = (b * c) * (1 + e3) * (1 + e4)) by (unfold vy, wx; ring).
pose proof (ratio _ H1) as R1; pose proof (ratio _ H2) as R2; pose proof (ratio _ H3) as R3;
pose proof (ratio _ H4) as R4; pose proof (ratio _ H5) as R5; pose proof (ratio _ H6) as R6.
assert (P12 : 0 < (1 + e1) * (1 + e2)) by (apply Rmult_lt_0_compat; lra). assert (P34 : 0 < (1 + e3) * (1 + e4)) by
  (apply Rmult_lt_0_compat; lra).
destruct (Rle_or_lt 0 (a * d)) as [Hp|Hp].
- assert (Rabs (vx * wy) = vx * wy) by (apply Rabs_right, Rle_ge; rewrite L, Rmult_assoc; apply Rmult_le_pos; lra).
  assert (Rabs (vy * wx) = vy * wx) by (apply Rabs_right, Rle_ge; rewrite R, Rmult_assoc; apply Rmult_le_pos; lra).
  rewrite H0, H7 in HC. rewrite L, R in *. apply one_side; auto.
- destruct (Rle_or_lt 0 (b * c)) as [Hq|Hq].
  + apply Rle_trans with 0.
    * assert (N1 : vx * wy <= 0) by (rewrite L, Rmult_assoc; apply below; lra).
      assert (N2 : 0 <= vy * wx) by (rewrite R, Rmult_assoc; apply Rmult_le_pos; lra).
      assert (vx * wy * (1 + e5) <= 0) by (apply below; lra). assert (0 <= vy * wx * (1 + e6)) by (apply Rmult_le_pos;
        lra). lra.
    * apply Rmult_le_pos; [exact HK|]. apply Rmult_le_pos; apply Rplus_le_le_0_compat; apply Rabs_pos.
  + (* both negative: the same with the products exchanged *)
    assert (Rabs (vx * wy) = - (vx * wy)) by (apply Rabs_left1; rewrite L, Rmult_assoc; apply below; lra).
    assert (Rabs (vy * wx) = - (vy * wx)) by (apply Rabs_left1; rewrite R, Rmult_assoc; apply below; lra).
    replace (vx * wy * (1 + e5) - vy * wx * (1 + e6)) with
      ((- (b * c)) * (1 + e3) * (1 + e4) * (1 + e6) - (- (a * d)) * (1 + e1) * (1 + e2) * (1 + e5)) by (rewrite L, R;
        ring).
    apply one_side; auto; try lra.
    replace (- (b * c) * (1 + e3) * (1 + e4)) with (- (vy * wx)) by (rewrite R; ring).
    replace (- (a * d) * (1 + e1) * (1 + e2)) with (- (vx * wy)) by (rewrite L; ring).
    replace (- (vy * wx) * - (vx * wy)) with (Rabs (vx * wy) * Rabs (vy * wx)) by (rewrite H0, H7; ring). lra.
Qed.
End Cross.
