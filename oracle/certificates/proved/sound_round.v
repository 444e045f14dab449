(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of capsules and triangles, or boxes along the axes, are enough, and their specifications leave no
    choice. *)
Require Import Reals Qreals QArith Lra Lia List Arith Bool.
From Certificates Require Import solids hulls language formulas_vectors formulas_solids formulas_nearest
  formulas_capsules sound_solids sound_vectors sound_motion sound_nearest sound_capsules unique_solids.
Import ListNotations.
Open Scope R_scope.

(** ** What a capsule has in common with a convex set: x and y are nearest points of its segment and of the set. *)
Section capsule_and_set.
Variables (points : list (list R)) (S : list R -> Prop) (x y : list R) (r : R).
Hypothesis (pa : forall p, In p points -> length p = 3%nat) (hx : hull 3 points x).
Hypothesis (ly : length y = 3%nat) (hr : 0 <= r).
Hypothesis nearest_x : forall z, hull 3 points z -> 0 <= dot (minus x y) (minus z x).
Hypothesis nearest_y : forall v, length v = 3%nat -> S v -> 0 <= dot (minus y x) (minus v y).

Lemma set_apart : r * r < sqdist x y -> forall z, length z = 3%nat -> ~ (capsule points r z /\ S z).
Proof.
  intros far z lz [(p & hp & d) s]. assert (lx := hull_length _ _ _ pa hx). assert (lp := hull_length _ _ _ pa hp).
  destruct (pair_nearest 3 x y p z lx ly lp lz) as [g _]; auto. lra.
Qed.
Lemma set_tangent : sqdist x y = r * r -> flat points -> forall z, ~ (interior 3 (capsule points r) z /\ S z).
Proof.
  intros e f z [i s]. assert (lz := proj1 i). assert (lx := hull_length _ _ _ pa hx).
  assert (pb : forall p, In p [y; z] -> length p = 3%nat) by (intros p [<- | [<- | []]]; auto).
  assert (k := nearest_y z lz s). rewrite dot_minus in k by (rewrite ?minus_length; congruence).
  assert (hy : hull 3 [y; z] y).
  { exists [1; 0]. split; [auto|]. split; [intros a [<- | [<- | []]]; lra|]. split; [simpl; lra|].
    clear - ly lz. destruct y as [|y0 [|y1 [|y2 [|]]]]; try discriminate.
    destruct z as [|z0 [|z1 [|z2 [|]]]]; try discriminate. simpl. repeat (f_equal; try ring). }
  assert (hz : hull 3 [y; z] z).
  { exists [0; 1]. split; [auto|]. split; [intros a [<- | [<- | []]]; lra|]. split; [simpl; lra|].
    clear - ly lz. destruct y as [|y0 [|y1 [|y2 [|]]]]; try discriminate.
    destruct z as [|z0 [|z1 [|z2 [|]]]]; try discriminate. simpl. repeat (f_equal; try ring). }
  assert (nb : forall v, hull 3 [y; z] v -> 0 <= dot (minus y x) (minus v y)).
  { intros v hv. assert (lv := hull_length _ _ _ pb hv).
    assert (m : dot (minus y x) y <= dot (minus y x) v).
    { apply (hull_above 3 [y; z]); auto. intros p [<- | [<- | []]]; lra. }
    rewrite dot_minus by (rewrite ?minus_length; congruence). lra. }
  apply (capsules_tangent points [y; z] x y r 0 pa pb hx hy hr (Rle_refl 0) nearest_x nb ltac:(rewrite e; ring) f z).
  split; [auto|]. exists z. split; [auto|]. rewrite sqdist_self. lra.
Qed.
End capsule_and_set.

(** ** A triangle *)
Theorem capsule_triangle_sound : forall a r points w facts on_a on_b,
  decide (check_capsule_triangle a r points w facts on_a on_b) = true ->
  capsule_triangle_spec (map rl a) (Q2R r) (map rl points) w.
Proof.
  intros a r points w facts on_a on_b h. apply decide_means in h. destruct h as (pa & hr & pb & wa & wb & h).
  apply points_mean in pa, pb. apply (weights_mean 3) in wa, wb. rewrite <- mixed_means in wa, wb. simpl in hr.
  split; [split; assumption|]. split; [assumption|]. assert (pa' := proj2 pa). assert (pb' := proj2 pb).
  set (x := values (mixed 3 on_a a)) in *. set (y := values (mixed 3 on_b points)) in *.
  assert (lx := hull_length _ _ _ pa' wa). assert (ly := hull_length _ _ _ pb' wb).
  assert (fa : flat (map rl a)) by (eapply flat_points; [eauto | lia]).
  unfold gap_proves, gap_decides in h. cbv zeta in h.
  set (way := difference (mixed 3 on_a a) (mixed 3 on_b points)) in *.
  assert (q : value Q2R (inner way way) = sqdist x y).
  { unfold way. rewrite inner_means, difference_means, <- sqdist_dot; auto. fold x y. congruence. }
  assert (nearest_x : means Q2R (none_nearer a (mixed 3 on_a a) (mixed 3 on_b points)) ->
    forall z, hull 3 (map rl a) z -> 0 <= dot (minus x y) (minus z x)).
  { intro n. apply (none_nearer_means 3 a); auto. apply (counted _ _ _ pa). }
  assert (nearest_y : means Q2R (none_nearer points (mixed 3 on_b points) (mixed 3 on_a a)) ->
    forall z, length z = 3%nat -> hull 3 (map rl points) z -> 0 <= dot (minus y x) (minus z y)).
  { intros n z _. apply (none_nearer_means 3 points); auto. apply (counted _ _ _ pb). }
  destruct w, facts; try (simpl in h; tauto).
  - destruct h as ((na & nb) & far). simpl in far. rewrite q in far. intros z hz c.
    apply (set_apart (map rl a) (hull 3 (map rl points)) x y (Q2R r)) with z; auto. apply (hull_length _ _ _ pb' hz).
  - destruct h as ((na & nb) & e). simpl in e. rewrite q in e. split.
    + exists y. split; [auto|]. exists x. split; [auto | lra].
    + intros z hz i. apply (set_tangent (map rl a) (hull 3 (map rl points)) x y (Q2R r)) with z; auto.
  - destruct h as (e & z). simpl in e, z. rewrite q in e. split.
    + exists y. split; [auto|]. exists x. auto.
    + intros v _ i. rewrite z in i. apply (flat_has_no_interior (map rl a) v) in i; auto.
  - destruct h as (e & _). simpl in e. rewrite q in e. exists y. split; [auto|].
    apply (interior_subset 3 (ball x (Q2R r))); [intros u _ hb; exists x; auto | apply inside_ball; auto; congruence].
Qed.
Theorem capsule_triangle_unique : forall a r points v w,
  capsule_triangle_spec a r points v -> capsule_triangle_spec a r points w -> v = w.
Proof. intros a r points v w (_ & _ & g) (_ & _ & h). apply (flat_contact_unique _ _ _ _ g h). Qed.

Lemma nearer_within : forall p c d t, length p = length c -> length d = length c -> 0 <= t <= 1 ->
  sqdist p (plus c (times (1 - t) d)) <= (1 - t) * sqdist p (plus c d) + t * sqdist p c.
Proof.
  induction p as [|a p IH]; intros [|b c] [|e d] t lp ld ht; simpl in *; try discriminate; try lra.
  assert (g := IH c d t ltac:(lia) ltac:(lia) ht).
  assert (k : 0 <= t * (1 - t) * (e * e)).
  { apply Rmult_le_pos; [apply Rmult_le_pos; lra | apply square]. }
  lra.
Qed.
(** What is nearer than r to c + d is also nearer than that to some point on the way from there to c. *)
Lemma nearer_on_the_way : forall p r c d, length p = length c -> length d = length c -> sqdist p (plus c d) < r * r ->
  exists t, 0 < t < 1 /\ sqdist p (plus c (times (1 - t) d)) < r * r.
Proof.
  intros p r c d lp ld near. assert (f0 := sqdist_nonneg p (plus c d)). assert (f1 := sqdist_nonneg p c).
  set (g := r * r - sqdist p (plus c d)). set (t := g / (g + sqdist p c + 1)).
  assert (hg : 0 < g) by (unfold g; lra).
  assert (e : t * (g + sqdist p c + 1) = g) by (unfold t; field; lra).
  assert (ht : 0 < t) by (apply Rdiv_lt_0_compat; lra).
  assert (tg : 0 < t * g) by (apply Rmult_lt_0_compat; auto).
  assert (tf : 0 <= t * sqdist p c) by (apply Rmult_le_pos; lra).
  assert (below : t < 1).
  { apply (Rmult_lt_reg_r (g + sqdist p c + 1)); [lra|]. rewrite e. lra. }
  exists t. split; [lra|]. assert (k := nearer_within p c d t lp ld ltac:(lra)).
  assert (0 <= t * sqdist p (plus c d)) by (apply Rmult_le_pos; lra). unfold g in *. lra.
Qed.

(** ** A box along the axes *)
Theorem capsule_aabb_sound : forall points r low high w facts on_a y,
  decide (check_capsule_aabb points r low high w facts on_a y) = true ->
  capsule_aabb_spec (map rl points) (Q2R r) (rl low) (rl high) w.
Proof.
  intros points r low high w facts on_a y h. apply decide_means in h. unfold check_capsule_aabb in h. cbv zeta in h.
  destruct h as (pa & hr & ll & lh & v & wa & ly & b & h). apply points_mean in pa. simpl in hr.
  rewrite of_length_means in ll, lh, ly. rewrite on_each_means in v, b.
  apply (weights_mean 3) in wa. rewrite <- mixed_means in wa. assert (pa' := proj2 pa).
  set (x := values (mixed 3 on_a points)) in *. assert (lx := hull_length _ _ _ pa' wa).
  assert (ll' := rl_length low). rewrite ll in ll'. assert (lh' := rl_length high). rewrite lh in lh'.
  assert (ly' := rl_length y). rewrite ly in ly'.
  assert (fa : flat (map rl points)) by (eapply flat_points; [eauto | lia]).
  split.
  { do 3 (split; [auto|]). intros k hk. specialize (v k hk). simpl in v. rewrite !coordinate_means in v. auto. }
  split; [split; assumption|].
  assert (hy : box (rl low) (rl high) (rl y)).
  { intros k hk. rewrite ly' in hk. specialize (b k hk). simpl means in b. rewrite !coordinate_means in b. auto. }
  unfold gap_decides in h. set (way := difference (mixed 3 on_a points) (leaves y)) in *.
  assert (q : value Q2R (inner way way) = sqdist x (rl y)).
  { unfold way. rewrite inner_means, difference_means, leaves_mean, <- sqdist_dot; auto. unfold x in lx. congruence. }
  assert (at_x : forall k, value Q2R (nth k (mixed 3 on_a points) zero) = nth k x 0).
  { intro k. change 0 with (value Q2R zero). unfold x, values. rewrite map_nth. auto. }
  set (near := (none_nearer points (mixed 3 on_a points) (leaves y) /\ on_each 3 (fun k => _))%check) in h.
  assert (nearest : means Q2R near -> (forall z, hull 3 (map rl points) z -> 0 <= dot (minus x (rl y)) (minus z x)) /\
    forall z, length z = 3%nat -> box (rl low) (rl high) z -> 0 <= dot (minus (rl y) x) (minus z (rl y))).
  { intros (na & nb). split.
    - intros z hz. assert (g := none_nearer_means 3 points _ _ (counted _ _ _ pa) lx na z hz).
      rewrite leaves_mean in g. exact g.
    - intros z lz hz. rewrite on_each_means in nb.
      assert (each : forall k, (k < 3)%nat -> 0 <= (nth k (rl y) 0 - nth k x 0) * (nth k z 0 - nth k (rl y) 0)).
      { intros k hk. specialize (nb k hk). simpl means in nb. rewrite at_x, !coordinate_means in nb.
        specialize (hz k ltac:(rewrite lz; auto)). destruct nb as [[up | up] [down | down]].
        - replace (nth k (rl y) 0 - nth k x 0) with 0 by lra. lra.
        - apply Rmult_le_pos; lra.
        - replace ((nth k (rl y) 0 - nth k x 0) * (nth k z 0 - nth k (rl y) 0)) with
            ((nth k x 0 - nth k (rl y) 0) * (nth k (rl y) 0 - nth k z 0)) by ring. apply Rmult_le_pos; lra.
        - replace (nth k z 0 - nth k (rl y) 0) with 0 by lra. lra. }
      clear - each lx ly' lz. destruct x as [|x0 [|x1 [|x2 [|]]]]; try discriminate.
      destruct (rl y) as [|y0 [|y1 [|y2 [|]]]]; try discriminate. destruct z as [|z0 [|z1 [|z2 [|]]]]; try discriminate.
      assert (e0 := each 0%nat ltac:(lia)). assert (e1 := each 1%nat ltac:(lia)). assert (e2 := each 2%nat ltac:(lia)).
      simpl in *. lra. }
  destruct w, facts; try (simpl in h; tauto).
  - destruct h as (n & far). simpl in far. rewrite q in far. destruct (nearest n) as [na nb].
    unfold contact_spec. apply (set_apart (map rl points) _ x (rl y)); auto.
  - destruct h as (n & e). simpl in e. rewrite q in e. destruct (nearest n) as [na nb]. split.
    + exists (rl y). split; [auto|]. split; [exists x; split; [auto | lra] | auto].
    + intros z [i j]. apply interior_in in j.
      apply (set_tangent (map rl points) (box (rl low) (rl high)) x (rl y) (Q2R r)) with z; auto.
  - destruct h as (e & z). simpl in e. rewrite q in e. split.
    + exists (rl y). split; [auto|]. split; [exists x; split; [auto | lra] | auto].
    + intros u [i j]. simpl means in z. rewrite !coordinate_means in z.
      assert (j0 := interior_box _ _ _ _ 0%nat j ltac:(lia)). assert (j1 := interior_box _ _ _ _ 1%nat j ltac:(lia)).
      assert (j2 := interior_box _ _ _ _ 2%nat j ltac:(lia)). destruct z as [z | [z | [z | z]]]; try lra.
      simpl in z. rewrite z in i. apply (flat_has_no_interior (map rl points) u) in i; auto.
  - destruct h as (e & nz). simpl in e. rewrite q in e. simpl means in nz. rewrite !coordinate_means in nz.
    set (c := times (1 / 2) (plus (rl low) (rl high))).
    assert (lc : length c = 3%nat) by (unfold c; rewrite times_length, plus_length; congruence).
    assert (ld : length (minus (rl y) c) = 3%nat) by (rewrite minus_length; congruence).
    assert (back : plus c (minus (rl y) c) = rl y).
    { clear - ly' lc. destruct c as [|c0 [|c1 [|c2 [|]]]]; try discriminate.
      destruct (rl y) as [|y0 [|y1 [|y2 [|]]]]; try discriminate. simpl. repeat (f_equal; try ring). }
    destruct (nearer_on_the_way x (Q2R r) c (minus (rl y) c)) as (t & ht & m); try congruence.
    set (z := plus c (times (1 - t) (minus (rl y) c))) in *.
    assert (lz : length z = 3%nat) by (unfold z; rewrite plus_length; rewrite ?times_length; congruence).
    exists z. split.
    + apply (interior_subset 3 (ball x (Q2R r))); [intros u _ hb; exists x; auto | apply inside_ball; auto; congruence].
    + rewrite <- lz. apply inside_box. intros k hk. rewrite lz in hk. assert (hyk := hy k ltac:(rewrite ly'; auto)).
      assert (strict : nth k (rl low) 0 < nth k (rl high) 0).
      { destruct k as [|[|[|]]]; try lia; destruct (Req_dec (nth 0 (rl low) 0) (nth 0 (rl high) 0));
          destruct (Req_dec (nth 1 (rl low) 0) (nth 1 (rl high) 0));
          destruct (Req_dec (nth 2 (rl low) 0) (nth 2 (rl high) 0)); try tauto; lra. }
      assert (form : nth k z 0 = (1 - t) * nth k (rl y) 0 + t * ((nth k (rl low) 0 + nth k (rl high) 0) / 2)).
      { unfold z, c. clear - ll' lh' ly' hk. destruct (rl low) as [|l0 [|l1 [|l2 [|]]]]; try discriminate.
        destruct (rl high) as [|h0 [|h1 [|h2 [|]]]]; try discriminate.
        destruct (rl y) as [|y0 [|y1 [|y2 [|]]]]; try discriminate. destruct k as [|[|[|]]]; try lia; simpl; field. }
      rewrite form. split; [|clear form].
      * assert (0 <= (1 - t) * (nth k (rl y) 0 - nth k (rl low) 0)) by (apply Rmult_le_pos; lra).
        assert (0 < t * (nth k (rl high) 0 - nth k (rl low) 0)) by (apply Rmult_lt_0_compat; lra). lra.
      * assert (0 <= (1 - t) * (nth k (rl high) 0 - nth k (rl y) 0)) by (apply Rmult_le_pos; lra).
        assert (0 < t * (nth k (rl high) 0 - nth k (rl low) 0)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.
Theorem capsule_aabb_unique : forall points r low high v w, capsule_aabb_spec points r low high v ->
  capsule_aabb_spec points r low high w -> v = w.
Proof. intros points r low high v w (_ & _ & g) (_ & _ & h). apply (contact_unique _ _ _ _ _ g h). Qed.
