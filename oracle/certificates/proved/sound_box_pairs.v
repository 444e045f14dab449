(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of an oriented box and an axis-aligned one, or a triangle, are enough, and their specifications leave
    no choice. *)
Require Import Reals Qreals QArith Lra Lia List Arith Bool.
From Certificates Require Import solids hulls language formulas_vectors formulas_solids formulas_nearest formulas_obbs
  formulas_courses formulas_box_pairs sound_solids sound_vectors sound_nearest sound_capsules sound_courses
  sound_obbs unique_solids.
Import ListNotations.
Open Scope R_scope.

Theorem aabb_obb_sound : forall low high c axes w facts, decide (check_aabb_obb low high c axes w facts) = true ->
  aabb_obb_spec (rl low) (rl high) (rl c) (map rl axes) w.
Proof.
  intros low high c axes w facts h. apply decide_means in h. unfold check_aabb_obb in h. cbv zeta in h.
  destruct h as (hb & right & h). apply is_box_means in hb. apply right_box_means in right.
  destruct right as [right ind]. assert (lc := proj1 right). assert (ll := proj1 (proj2 hb)).
  assert (lh := proj1 (proj2 (proj2 hb))). rewrite rl_length in ll, lh.
  split; [auto|]. split; [auto|].
  set (x := fun u => plus (rl c) (combined 3 (rl u) (map rl axes))).
  assert (at_axis : forall u k, value Q2R (nth k (placed c axes u) zero) = nth k (x u) 0).
  { intros u k. unfold x. rewrite <- placed_means. change 0 with (value Q2R zero). unfold values.
    rewrite map_nth. auto. }
  assert (in_obb : forall u, means Q2R (within_one u) -> obb (rl c) (map rl axes) (x u) /\ length (x u) = 3%nat).
  { intros u m. apply within_one_means in m. assert (o : obb (rl c) (map rl axes) (x u)) by (exists (rl u); tauto).
    split; [auto | apply (obb_length _ _ _ right o)]. }
  assert (common : forall u, means Q2R (within_one u) -> means Q2R (on_each 3 (fun k =>
      coordinate k low <= nth k (placed c axes u) zero /\ nth k (placed c axes u) zero <= coordinate k high)%check) ->
    exists y, length y = 3%nat /\ box (rl low) (rl high) y /\ obb (rl c) (map rl axes) y).
  { intros u m b. destruct (in_obb u m) as [o lo]. exists (x u). split; [auto|]. split; [|auto].
    intros k hk. rewrite lo in hk. rewrite on_each_means in b. specialize (b k hk). simpl means in b.
    rewrite at_axis, !coordinate_means in b. exact b. }
  assert (below : forall n y, length n = 3%nat -> length y = 3%nat -> box (rl low) (rl high) y ->
    dot (rl n) y <= value Q2R (highest_of_box n low high)).
  { intros n y ln ly b. apply highest_of_box_means; congruence || auto. }
  assert (above : forall n y, obb (rl c) (map rl axes) y ->
    dot (rl n) (rl c) - rreach (rl n) (map rl axes) <= dot (rl n) y).
  { intros n y o. apply (obb_reach (times (-1) (rl n))) in o; auto. rewrite rreach_opposite, !times_dot in o. lra. }
  destruct w, facts as [n | u n | u k | u]; try (simpl in h; tauto).
  - destruct h as (ln & far). rewrite of_length_means in ln. simpl in far.
    rewrite reach_means, inner_means, !leaves_mean in far. intros y ly [b o].
    assert (g := below n y ln ly b). assert (k := above n y o). lra.
  - destruct h as (ln & nz & e & m & b). rewrite of_length_means in ln. simpl in e. apply not_zero_means in nz.
    rewrite reach_means, inner_means, !leaves_mean in e. split; [apply (common u); auto|].
    intros y [i j]. assert (ln' := rl_length n). rewrite ln in ln'.
    assert (g : interior 3 (half_space (rl n) (- value Q2R (highest_of_box n low high))) y).
    { apply (interior_subset 3 (box (rl low) (rl high))); auto. intros z lz bz. unfold half_space.
      assert (g := below n z ln lz bz). lra. }
    apply half_space_interior in g; auto. assert (k := above n y (interior_in _ _ _ j)). lra.
  - destruct h as (k3 & e & m & b). rewrite if_so_means, Nat.ltb_lt in k3. simpl in e. rewrite !coordinate_means in e.
    split; [apply (common u); auto|]. intros y [i _]. assert (B := interior_box _ _ _ _ _ i k3). lra.
  - destruct h as (m & b). apply inside_one_means in m. destruct m as [lu hu].
    assert (i := obb_inside (rl c) (map rl axes) (rl u) right ind lu hu). fold (x u) in i. exists (x u).
    split; [|auto]. assert (lo := proj1 i). rewrite <- lo at 1. apply inside_box.
    intros k hk. rewrite lo in hk. rewrite on_each_means in b. specialize (b k hk). simpl means in b.
    rewrite at_axis, !coordinate_means in b. exact b.
Qed.
Theorem aabb_obb_unique : forall l h c axes v w, aabb_obb_spec l h c axes v -> aabb_obb_spec l h c axes w -> v = w.
Proof. intros l h c axes v w (_ & _ & g) (_ & _ & k). apply (contact_unique _ _ _ _ _ g k). Qed.

Lemma below_all : forall (f : list R -> R) b l, (forall p, In p l -> f p < b) ->
  exists m, m < b /\ forall p, In p l -> f p <= m.
Proof.
  intros f b l. induction l as [|a l IH]; intro h.
  - exists (b - 1). split; [lra | intros p []].
  - destruct IH as (m & lt & le); [intros; apply h; simpl; auto|]. exists (Rmax (f a) m). split.
    + apply Rmax_lub_lt; auto. apply h; simpl; auto.
    + intros p [<- | i]; [apply Rmax_l|]. apply Rle_trans with m; [auto | apply Rmax_r].
Qed.
Theorem triangle_obb_sound : forall points c axes w facts, decide (check_triangle_obb points c axes w facts) = true ->
  triangle_obb_spec (map rl points) (rl c) (map rl axes) w.
Proof.
  intros points c axes w facts h. apply decide_means in h. unfold check_triangle_obb in h. cbv zeta in h.
  destruct h as (pb & right & h). apply points_mean in pb. apply right_box_means in right.
  destruct right as [right ind]. split; [auto|]. split; [auto|]. assert (pb' := proj2 pb).
  set (lowest := fun n => dot (rl n) (rl c) - rreach (rl n) (map rl axes)).
  assert (above : forall n y, obb (rl c) (map rl axes) y -> lowest n <= dot (rl n) y).
  { intros n y o. apply (obb_reach (times (-1) (rl n))) in o; auto. rewrite rreach_opposite, !times_dot in o.
    unfold lowest. lra. }
  assert (below : forall n m x, (forall p, In p (map rl points) -> dot (rl n) p <= m) -> hull 3 (map rl points) x ->
    dot (rl n) x <= m).
  { intros n m x low hx. assert (k : - m <= dot (times (-1) (rl n)) x).
    { apply (hull_above 3 (map rl points)); auto. intros p i. rewrite times_dot. specialize (low p i). lra. }
    rewrite times_dot in k. lra. }
  destruct w, facts as [n | u v n | u v]; try (simpl in h; tauto).
  - destruct h as (_ & far). rewrite all_means in far. intros x hx o.
    destruct (below_all (dot (rl n)) (lowest n) (map rl points)) as (m & lt & le).
    { intros p i. apply in_map_iff in i. destruct i as [t [<- i]]. specialize (far t i). simpl in far.
      rewrite reach_means, !inner_means, !leaves_mean in far. unfold lowest. lra. }
    assert (k := below n m x le hx). assert (g := above n x o). lra.
  - destruct h as (ln & nz & low & hv & wu & e). rewrite of_length_means in ln. rewrite all_means in low.
    apply not_zero_means in nz. apply within_one_means in hv. apply (weights_mean 3) in wu.
    rewrite <- mixed_means in wu. rewrite same_vector_means, placed_means in e. split.
    + exists (values (mixed 3 u points)). split; [auto|]. rewrite e. exists (rl v). tauto.
    + intros x hx i. assert (ln' := rl_length n). rewrite ln in ln'.
      assert (k : dot (rl n) x <= lowest n).
      { apply below; auto. intros p j. apply in_map_iff in j. destruct j as [t [<- j]]. specialize (low t j).
        simpl in low. rewrite reach_means, !inner_means, !leaves_mean in low. unfold lowest. lra. }
      assert (j : interior 3 (half_space (times (-1) (rl n)) (lowest n)) x).
      { apply (interior_subset 3 (obb (rl c) (map rl axes))); auto. intros z lz o. unfold half_space.
        rewrite times_dot. assert (g := above n z o). lra. }
      apply half_space_interior in j.
      * rewrite times_dot in j. lra.
      * rewrite times_length; auto.
      * destruct nz as [d [k' nd]]. exists (-1 * d). split; [apply in_map; auto | lra].
  - destruct h as (hv & wu & e). apply inside_one_means in hv. apply (weights_mean 3) in wu.
    rewrite <- mixed_means in wu. rewrite same_vector_means, placed_means in e.
    exists (values (mixed 3 u points)). split; [auto|]. rewrite e. apply obb_inside; tauto.
Qed.
Theorem triangle_obb_unique : forall points c axes v w, triangle_obb_spec points c axes v ->
  triangle_obb_spec points c axes w -> v = w.
Proof. intros points c axes v w (_ & _ & g) (_ & _ & h). apply (flat_contact_unique _ _ _ _ g h). Qed.
