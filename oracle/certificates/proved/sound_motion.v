(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of moving balls are enough, also where the time is irrational. *)
Require Import Reals Qreals QArith Lra Lia List Arith Bool.
From Certificates Require Import motion solids language formulas_vectors formulas_solids formulas_motion sound_solids.
Import ListNotations.
Open Scope R_scope.

Definition r_swept (w : swept Q) : swept R :=
  match w with first_at (Surd p q k) => first_at (Surd (Q2R p) (Q2R q) (Q2R k)) | never => never end.

(** ** Balls meet where their centers are no farther apart than the sum of the radii *)
Lemma moved_length : forall c v t, length v = length c -> length (moved c v t) = length c.
Proof. induction c as [|a c IH]; intros [|b v] t l; simpl in *; try discriminate; auto. Qed.

Lemma meet_iff : forall n c r d s, length c = n -> length d = n -> 0 <= r -> 0 <= s ->
  ((exists x, length x = n /\ ball c r x /\ ball d s x) <-> sqdist c d <= (r + s) * (r + s)).
Proof.
  intros n c r d s lc ld hr hs. split.
  - intros [x [lx [a b]]]. unfold ball in a, b. rewrite sqdist_sym in b.
    apply (triangle r s c d x); auto; congruence.
  - intro h. destruct (Req_dec (r + s) 0) as [z | nz].
    + assert (zr : r = 0) by lra. assert (zs : s = 0) by lra. rewrite z in h. rewrite zr, zs in *.
      assert (e : c = d) by (apply sqdist_zero; [congruence | lra]). subst d.
      exists c. unfold ball. rewrite sqdist_self. split; [auto | lra].
    + set (k := s / (r + s)). exists (further (- k) c d).
      assert (g := sqdist_nonneg c d). split; [rewrite further_length; congruence |]. unfold ball.
      rewrite further_away, further_moved.
      assert (k1 : (1 + - k) * (r + s) = r) by (unfold k; field; auto).
      assert (k2 : k * (r + s) = s) by (unfold k; field; auto).
      split.
      * replace (r * r) with ((1 + - k) * (1 + - k) * ((r + s) * (r + s))) by (transitivity (((1 + - k) * (r + s)) *
          ((1 + - k) * (r + s))); [ring | rewrite k1; auto]).
        apply Rmult_le_compat_l; auto; apply square.
      * replace (s * s) with (k * k * ((r + s) * (r + s))) by (transitivity ((k * (r + s)) * (k * (r + s)));
          [ring | rewrite k2; auto]).
        replace (- k * - k) with (k * k) by ring. apply Rmult_le_compat_l; auto; apply square.
Qed.

Lemma products_means : forall p o v w t, length o = length p -> length v = length p -> length w = length p ->
  sqdist (moved (rl p) (rl v) t) (moved (rl o) (rl w) t) =
  sqdist (rl p) (rl o) + 2 * value Q2R (products p o v w) * t + sqdist (rl v) (rl w) * (t * t).
Proof.
  induction p as [|a p IH]; intros [|b o] [|x v] [|y w] t l1 l2 l3; simpl in *; try discriminate; try ring.
  rewrite IH; auto. ring.
Qed.

(** ** The sign of p + q sqrt(k) *)
Lemma not_positive_iff : forall p q k, 0 <= k ->
  ((p <= 0 /\ (q <= 0 \/ q * q * k <= p * p) \/ q <= 0 /\ p * p <= q * q * k) <-> p + q * sqrt k <= 0).
Proof.
  intros p q k hk. assert (h0 := sqrt_pos k). assert (h2 := sqrt_def k hk). set (h := sqrt k) in *.
  assert (z2 : q * q * k = (q * h) * (q * h)) by (rewrite <- h2; ring). rewrite z2.
  assert (down : q <= 0 -> q * h <= 0) by (intro; assert (0 <= - q * h) by (apply Rmult_le_pos; lra); lra).
  assert (up : 0 <= q -> 0 <= q * h) by (intro; apply Rmult_le_pos; lra).
  set (z := q * h) in *. split.
  - intros [[a [b | b]] | [a b]].
    + apply down in b; lra.
    + destruct (Rle_lt_dec z (- p)); [lra|]. exfalso. assert (- p * - p < z * z) by (apply Rmult_le_0_lt_compat;
        lra). lra.
    + apply down in a. destruct (Rle_lt_dec p (- z)); [lra|]. exfalso.
      assert (- z * - z < p * p) by (apply Rmult_le_0_lt_compat; lra). lra.
  - intro a. destruct (Rle_lt_dec p 0) as [b | b].
    + left; split; auto. destruct (Rle_lt_dec q 0) as [c | c]; auto. right.
      assert (0 <= z) by (apply up; lra). replace (p * p) with (- p * - p) by ring. apply Rmult_le_compat; lra.
    + right. split.
      * destruct (Rle_lt_dec q 0); auto. exfalso. assert (0 <= z) by (apply up; lra). lra.
      * replace (z * z) with (- z * - z) by ring. apply Rmult_le_compat; lra.
Qed.

(** ** The first zero of c + b t + a t^2 *)
Lemma before_first_root : forall a b c t u, 0 <= a -> 0 < c -> c + b * t + a * (t * t) = 0 -> b + 2 * a * t <= 0 ->
  u < t ->
  0 < c + b * u + a * (u * u).
Proof.
  intros a b c t u ha hc z d l. apply Rnot_le_lt; intro n.
  assert (e : c + b * u + a * (u * u) = (t - u) * (a * (t - u)) - (t - u) * (b + 2 * a * t)).
  { replace (c + b * u + a * (u * u)) with (c + b * u + a * (u * u) - (c + b * t + a * (t * t))) by lra. ring. }
  assert (0 <= (t - u) * (a * (t - u))) by (apply Rmult_le_pos; [lra | apply Rmult_le_pos; lra]).
  assert (0 <= (t - u) * - (b + 2 * a * t)) by (apply Rmult_le_pos; lra).
  assert (s1 : a * ((t - u) * (t - u)) = 0) by lra. assert (s2 : (b + 2 * a * t) * (t - u) = 0) by lra.
  assert (0 < (t - u) * (t - u)) by (apply Rmult_lt_0_compat; lra).
  apply Rmult_integral in s1, s2. destruct s1 as [s1 | s1]; [|lra]. destruct s2 as [s2 | s2]; [|lra].
  subst a. assert (b = 0) by lra. subst b. lra.
Qed.

Theorem swept_sphere_sphere_sound : forall p r v o s w answer facts,
  decide (check_swept_sphere_sphere p r v o s w answer facts) = true ->
  swept_sphere_sphere_spec (rl p) (Q2R r) (rl v) (rl o) (Q2R s) (rl w) (r_swept answer).
Proof.
  intros p r v o s w answer facts H. apply decide_means in H. unfold check_swept_sphere_sphere, not_negative,
    not_positive in H.
  cbv zeta in H. simpl in H. rewrite !if_so_means, !Nat.eqb_eq in H. destruct H as (l1 & l2 & l3 & l4 & hr & hs & H).
  unfold swept_sphere_sphere_spec. rewrite !rl_length. do 6 (split; auto).
  assert (core : forall t, meet (rl p) (Q2R r) (rl v) (rl o) (Q2R s) (rl w) t <->
    (sqdist (rl p) (rl o) - (Q2R r + Q2R s) * (Q2R r + Q2R s)) + 2 * value Q2R (products p o v w) * t + sqdist (rl v)
      (rl w) * (t * t) <= 0).
  { intro t. unfold meet. rewrite meet_iff; auto; try (rewrite moved_length; rewrite ?rl_length; congruence).
    rewrite products_means; try congruence. lra. }
  assert (ha := sqdist_nonneg (rl v) (rl w)).
  destruct answer as [[x y k] |]; destruct facts; simpl in H; try tauto;
    rewrite ?squared_distance_means in H; destruct H as ((<- & <- & <-) & H) || destruct H as ((ec & eb & ea) & H);
    try (rewrite <- ec, <- eb, <- ea in *); simpl.
  - destruct H as (hc & hk & n & m). apply not_positive_iff in n, m; auto.
    assert (z : Q2R x + Q2R y * sqrt (Q2R k) = 0) by lra. rewrite z. split; [lra|]. split; [apply core; lra | intros;
      lra].
  - destruct H as (hc & hk & pos & one & f & g & d). rewrite not_positive_iff in pos, one, f, g, d; auto.
    assert (k2 := sqrt_def _ hk). set (h := sqrt (Q2R k)) in *. set (t := Q2R x + Q2R y * h).
    assert (t2 : t * t = Q2R x * Q2R x + Q2R y * Q2R y * Q2R k + 2 * Q2R x * Q2R y * h) by (unfold t; rewrite <- k2;
      ring).
    assert (zero : Q2R c + Q2R b * t + Q2R a * (t * t) = 0) by (rewrite t2; unfold t; lra).
    split; [unfold t in *; lra|]. split; [apply core; lra|].
    intros u hu meets. apply core in meets.
    assert (q := before_first_root (Q2R a) (Q2R b) (Q2R c) t u ha hc zero). 
    assert (Q2R b + 2 * Q2R a * t <= 0) by (unfold t; lra). lra.
  - destruct H as (hc & hb). intros u hu meets. apply core in meets.
    assert (0 <= Q2R b * u) by (apply Rmult_le_pos; lra). assert (0 <= Q2R a * (u * u)) by (apply Rmult_le_pos;
      [auto | apply square]). lra.
  - destruct H as (hc & h1 & d). intros u hu meets. apply core in meets.
    assert (0 <= (1 - u) * - (2 * Q2R a + Q2R b)) by (apply Rmult_le_pos; lra).
    assert (0 <= Q2R a * ((1 - u) * (1 - u))) by (apply Rmult_le_pos; [auto | apply square]). lra.
  - destruct H as (hc & d). intros u hu meets. apply core in meets.
    assert (q := square (2 * Q2R a * u + Q2R b)).
    assert (0 <= Q2R a * - (Q2R c + Q2R b * u + Q2R a * (u * u))) by (apply Rmult_le_pos; lra). lra.
Qed.
