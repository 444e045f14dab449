(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of a ball that moves and a box at rest are enough, also where the time is irrational, and their
    specification leaves no choice. *)
Require Import Reals Qreals QArith Lra Lia List Arith.
From Certificates Require Import motion solids language formulas_vectors formulas_solids formulas_motion
  formulas_courses formulas_swept_balls sound_solids sound_vectors sound_motion sound_courses.
Import ListNotations.
Open Scope R_scope.

(** ** On an axis: the center at p, its displacement d from the interval from l to h *)
Definition displaced (p d l h : R) : Prop := p <= l /\ d = p - l \/ l <= p <= h /\ d = 0 \/ h <= p /\ d = p - h.
Definition comes_in (p v l h : R) : Prop := 0 < v /\ p <= l \/ v < 0 /\ h <= p.
Lemma leads_away : forall p d l h x, displaced p d l h -> l <= x <= h -> 0 <= d * (p - d - x).
Proof.
  intros p d l h x [[a ->] | [[a ->] | [a ->]]] b; [| lra |].
  - assert (0 <= (l - p) * (x - l)) by (apply Rmult_le_pos; lra). lra.
  - assert (0 <= (p - h) * (h - x)) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma was_outside : forall p d l h v x s, displaced p d l h -> l <= x <= h -> comes_in p v l h -> 0 < s ->
  p - s * v - x <> d.
Proof.
  intros p d l h v x s a b c hs e. destruct c as [[hv c] | [hv c]].
  - assert (0 < s * v) by (apply Rmult_lt_0_compat; auto). destruct a as [[a ->] | [[a ->] | [a ->]]]; lra.
  - assert (0 < s * - v) by (apply Rmult_lt_0_compat; lra). destruct a as [[a ->] | [[a ->] | [a ->]]]; lra.
Qed.
Lemma apart_before : forall p d l h v x : nat -> R, forall r s,
  (forall i, (i < 3)%nat -> displaced (p i) (d i) (l i) (h i) /\ l i <= x i <= h i) ->
  (exists i, (i < 3)%nat /\ comes_in (p i) (v i) (l i) (h i)) -> 0 < s ->
  let sum f := f 0%nat + (f 1%nat + f 2%nat) in
  sum (fun i => d i * d i) = r * r -> sum (fun i => d i * v i) <= 0 ->
  r * r < sum (fun i => (p i - s * v i - x i) * (p i - s * v i - x i)).
Proof.
  intros p d l h v x r s each (i & hi & c) hs sum e f. unfold sum in *. apply Rnot_le_lt; intro near.
  assert (a0 := leads_away _ _ _ _ _ (proj1 (each O ltac:(lia))) (proj2 (each O ltac:(lia)))).
  assert (a1 := leads_away _ _ _ _ _ (proj1 (each 1%nat ltac:(lia))) (proj2 (each 1%nat ltac:(lia)))).
  assert (a2 := leads_away _ _ _ _ _ (proj1 (each 2%nat ltac:(lia))) (proj2 (each 2%nat ltac:(lia)))).
  assert (g : 0 <= s * - (d 0%nat * v 0%nat + (d 1%nat * v 1%nat + d 2%nat * v 2%nat))) by (apply Rmult_le_pos; lra).
  set (w := fun i => p i - s * v i - x i - d i).
  assert (q : forall i, 0 <= w i * w i) by (intro; apply square).
  assert (total : w 0%nat * w 0%nat + (w 1%nat * w 1%nat + w 2%nat * w 2%nat) <= 0) by (unfold w; lra).
  assert (z : w i * w i = 0).
  { assert (q0 := q 0%nat). assert (q1 := q 1%nat). assert (q2 := q 2%nat).
    destruct i as [|[|[|i]]]; [lra | lra | lra | lia]. }
  apply (was_outside _ _ _ _ (v i) (x i) s (proj1 (each i hi)) (proj2 (each i hi)) c hs).
  unfold w in z. apply Rmult_integral in z. lra.
Qed.

(** ** In space *)
Lemma three : forall {B} (x : list B), length x = 3%nat -> exists a b c, x = [a; b; c].
Proof. intros B [|a [|b [|c [|d x]]]] l; try discriminate. eauto. Qed.
Lemma sqdist_at_time : forall c v x t, length c = 3%nat -> length v = 3%nat -> length x = 3%nat ->
  let w i := nth i c 0 + t * nth i v 0 - nth i x 0 in
  sqdist (at_time c v t) x = w 0%nat * w 0%nat + (w 1%nat * w 1%nat + w 2%nat * w 2%nat).
Proof.
  intros c v x t lc lv lx. destruct (three c lc) as (c0 & c1 & c2 & ->). destruct (three v lv) as (v0 & v1 & v2 & ->).
  destruct (three x lx) as (x0 & x1 & x2 & ->). simpl. ring.
Qed.

Theorem swept_sphere_aabb_sound : forall c r v low high answer facts,
  decide (check_swept_sphere_aabb c r v low high answer facts) = true ->
  swept_sphere_aabb_spec (rl c) (Q2R r) (rl v) (rl low) (rl high) (option_map r_surd answer).
Proof.
  intros c r v low high answer facts h. apply decide_means in h. unfold check_swept_sphere_aabb in h. cbv zeta in h.
  destruct h as (hc & lv & hb & h). apply is_ball_means in hc. apply is_box_means in hb. rewrite of_length_means in lv.
  assert (lv' : length (rl v) = 3%nat) by (rewrite rl_length; auto). split; [auto|]. split; [auto|]. split; [auto|].
  destruct hc as (_ & lc & hr), hb as (_ & ll & lh & order). assert (lc' := lc). rewrite rl_length in lc'.
  destruct answer as [[x y k] |], facts as [p | sides | n]; try (simpl in h; tauto).
  - destruct h as (hk & z & lp & i & near). rewrite of_length_means in lp. apply (is_zero_means _ _ (Leaf k) hk) in z.
    simpl in z, near. rewrite inner_means, difference_means, !leaves_mean in near.
    apply box_holds_means in i; [|unfold leaves; rewrite map_length, lp, <- ll, rl_length; auto].
    rewrite leaves_mean in i. simpl. rewrite z. split; [lra|]. split; [|intros; lra].
    exists (rl p). rewrite rl_length. split; [auto|]. split; [|auto]. unfold ball.
    rewrite sqdist_at_time by (rewrite ?rl_length; congruence).
    rewrite <- sqdist_dot in near by (rewrite !rl_length; congruence).
    destruct (three c lc') as (c0 & c1 & c2 & ->). destruct (three p lp) as (p0 & p1 & p2 & ->).
    simpl in near. simpl nth. lra.
  - destruct h as (hk & pos & one & placed & comes & z & f). simpl in hk.
    change (~ means Q2R (not_positive (Leaf x) (Leaf y) (Leaf k))) in pos.
    rewrite (not_positive_means _ _ (Leaf k) hk) in pos. apply (not_positive_means _ _ (Leaf k) hk) in one.
    apply (zero_at_means _ _ _ _ _ (Leaf k) hk) in z. apply (falls_at_means _ _ _ _ (Leaf k) hk) in f.
    simpl in pos, one. simpl option_map. unfold r_surd, surd_value.
    set (t := Q2R x + Q2R y * sqrt (Q2R k)) in *.
    set (C := fun i => nth i (rl c) 0). set (V := fun i => nth i (rl v) 0).
    set (L := fun i => nth i (rl low) 0). set (H := fun i => nth i (rl high) 0).
    set (d := fun i => match nth i sides level with
      under => C i + t * V i - L i | level => 0 | over => C i + t * V i - H i end).
    assert (up_to : forall i b, means Q2R (not_positive (coordinate i c - b + coordinate i v * Leaf x)%check
        (coordinate i v * Leaf y)%check (Leaf k)) <-> C i + t * V i <= value Q2R b).
    { intros i b. rewrite (not_positive_means _ _ (Leaf k) hk). simpl value. rewrite !coordinate_means. unfold C, V, t.
      split; intro; lra. }
    assert (from : forall i b, means Q2R (not_negative (coordinate i c - b + coordinate i v * Leaf x)%check
        (coordinate i v * Leaf y)%check (Leaf k)) <-> value Q2R b <= C i + t * V i).
    { intros i b. rewrite (not_negative_means _ _ (Leaf k) hk). simpl value. rewrite !coordinate_means. unfold C, V, t.
      split; intro; lra. }
    assert (D : forall i, (i < 3)%nat -> displaced (C i + t * V i) (d i) (L i) (H i)).
    { intros i hi. rewrite on_each_means in placed. specialize (placed i hi). unfold displaced, d.
      destruct (nth i sides level).
      - apply up_to in placed. rewrite coordinate_means in placed. fold (L i) in placed. lra.
      - destruct placed as [a b]. apply from in a. apply up_to in b. rewrite coordinate_means in a, b.
        fold (L i) in a. fold (H i) in b. lra.
      - apply from in placed. rewrite coordinate_means in placed. fold (H i) in placed. lra. }
    assert (I : exists i, (i < 3)%nat /\ comes_in (C i + t * V i) (V i) (L i) (H i)).
    { apply on_some_means in comes. destruct comes as (i & hi & comes). exists i. split; [auto|]. unfold comes_in.
      destruct comes as [[a b] | [a b]]; simpl in a; rewrite coordinate_means in a; fold (V i) in a;
        [apply up_to in b | apply from in b]; rewrite coordinate_means in b;
        [fold (L i) in b | fold (H i) in b]; lra. }
    set (rate := fun i => match nth i sides level with level => 0 | _ => V i end).
    set (gap := fun i => match nth i sides level with under => C i - L i | level => 0 | over => C i - H i end).
    assert (dg : forall i, d i = gap i + t * rate i)
      by (intro i; unfold d, gap, rate; destruct (nth i sides level); lra).
    assert (dv : forall i, d i * V i = d i * rate i) by (intro i; unfold d, rate; destruct (nth i sides level); lra).
    assert (rate_means : forall i, value Q2R match nth i sides level with level => zero | _ => coordinate i v end =
      rate i) by (intro i; unfold rate; destruct (nth i sides level); simpl; rewrite ?coordinate_means; auto).
    assert (gap_means : forall i, value Q2R match nth i sides level with
        under => (coordinate i c - coordinate i low)%check | level => zero
        | over => (coordinate i c - coordinate i high)%check end = gap i)
      by (intro i; unfold gap; destruct (nth i sides level); simpl; rewrite ?coordinate_means; auto).
    unfold sum_of_three in z, f. cbn [value] in z, f. rewrite ?gap_means, ?rate_means in z, f.
    fold t in z, f.
    assert (square_d : d 0%nat * d 0%nat + (d 1%nat * d 1%nat + d 2%nat * d 2%nat) = Q2R r * Q2R r)
      by (rewrite !dg; lra).
    assert (falls : d 0%nat * V 0%nat + (d 1%nat * V 1%nat + d 2%nat * V 2%nat) <= 0) by (rewrite !dv, !dg; lra).
    assert (sides_of : forall i, (i < 3)%nat -> L i <= H i) by (intros i hi; apply order; auto).
    split; [unfold t in *; lra|]. split.
    + exists (map (fun i => C i + t * V i - d i) [0; 1; 2]%nat). split; [auto|]. split.
      * unfold ball. rewrite sqdist_at_time by auto. simpl nth. fold (C 0%nat) (C 1%nat) (C 2%nat).
        fold (V 0%nat) (V 1%nat) (V 2%nat). right. rewrite <- square_d. ring.
      * intros i hi. change (length (map (fun i => C i + t * V i - d i) [0; 1; 2]%nat)) with 3%nat in hi.
        assert (e := D i hi). assert (o := sides_of i hi). fold (L i) (H i). unfold displaced in e.
        destruct i as [|[|[|i]]]; [| | | lia]; simpl nth; lra.
    + intros u hu (q & lq & b & i). unfold ball in b. rewrite sqdist_at_time in b by auto.
      assert (far := apart_before (fun i => C i + t * V i) d L H V (fun i => nth i q 0) (Q2R r) (t - u)
        ltac:(intros j hj; split; [auto | apply i; lia]) I ltac:(lra) square_d falls).
      cbv beta in far. unfold C, V in far. lra.
  - destruct h as (ln & (p0 & f0) & (p1 & f1)). rewrite of_length_means in ln. cbn [means value] in p0, f0, p1, f1.
    read_vectors p0. read_vectors f0. read_vectors p1. read_vectors f1. simpl option_map. intros u hu (q & lq & b & i).
    assert (g := highest_of_box_means n low high q). rewrite rl_length in ll, lh.
    specialize (g ltac:(congruence) ltac:(congruence) ltac:(congruence) i).
    assert (l1 : length (rl n) = 3%nat) by (rewrite rl_length; auto).
    assert (la : length (at_time (rl c) (rl v) u) = 3%nat) by (rewrite at_time_length; congruence).
    unfold ball in b. rewrite sqdist_dot in b by congruence.
    assert (k := cauchy (rl n) (minus (at_time (rl c) (rl v) u) q) ltac:(rewrite minus_length; congruence)).
    rewrite dot_minus, dot_at_time in k by congruence.
    set (N := dot (rl n) (rl n)) in *. set (W := dot (minus _ q) (minus _ q)) in *.
    set (X := dot (rl n) (rl c)) in *. set (Y := dot (rl n) (rl v)) in *. set (Z := dot (rl n) q) in *.
    set (M := value Q2R (highest_of_box n low high)) in *. assert (nn : 0 <= N) by apply dot_self.
    assert (kW : N * W <= Q2R r * Q2R r * N) by (rewrite (Rmult_comm _ N); apply Rmult_le_compat_l; auto).
    assert (hull : exists m, 0 < m /\ Q2R r * Q2R r * N < m * m /\ m <= X + u * Y - Z).
    { destruct (Rle_lt_dec 0 Y).
      - exists (X - M). assert (0 <= u * Y) by (apply Rmult_le_pos; lra). repeat split; auto; lra.
      - exists (X - M + Y). assert (0 <= (1 - u) * - Y) by (apply Rmult_le_pos; lra). repeat split; auto; lra. }
    destruct hull as (m & m0 & m1 & m2). assert (m * m <= (X + u * Y - Z) * (X + u * Y - Z)) by
      (apply Rmult_le_compat; lra). lra.
Qed.
Theorem swept_sphere_aabb_unique : forall c r v l h x y,
  swept_sphere_aabb_spec c r v l h x -> swept_sphere_aabb_spec c r v l h y -> x = y.
Proof. intros c r v l h x y (_ & _ & _ & g) (_ & _ & _ & k). apply (first_time_unique _ _ _ g k). Qed.
