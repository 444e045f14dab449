(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of oriented boxes are enough, and their specifications leave no choice. *)
Require Import Reals Qreals QArith Lra Lia List Arith Bool.
From Certificates Require Import solids hulls language formulas_vectors formulas_solids formulas_nearest
  formulas_capsules formulas_obbs sound_solids sound_vectors sound_slabs sound_nearest sound_capsules sound_round
  unique_solids unique_slabs.
Import ListNotations.
Open Scope R_scope.

(** ** Along a direction *)
Definition rsize (t : R) : R := Rmax t (0 - t).
Lemma rsize_bounds : forall t, t <= rsize t /\ - t <= rsize t /\ 0 <= rsize t.
Proof. intro t. assert (a := Rmax_l t (0 - t)). assert (b := Rmax_r t (0 - t)). unfold rsize. lra. Qed.
Lemma rsize_below : forall t c, rsize t <= c <-> - c <= t <= c.
Proof.
  intros t c. split.
  - intro h. destruct (rsize_bounds t) as (a & b & _). lra.
  - intro h. apply Rmax_lub; lra.
Qed.
Lemma rsize_less : forall t c, rsize t < c <-> - c < t < c.
Proof.
  intros t c. split.
  - intro h. destruct (rsize_bounds t) as (a & b & _). lra.
  - intro h. apply Rmax_lub_lt; lra.
Qed.
Fixpoint rreach (n : list R) (axes : list (list R)) : R :=
  match axes with [] => 0 | h :: axes' => rsize (dot n h) + rreach n axes' end.
Lemma reach_means : forall n axes, value Q2R (reach n axes) = rreach (values n) (map rl axes).
Proof. induction axes as [|h axes IH]; simpl; auto. rewrite inner_means, leaves_mean, IH. auto. Qed.
Lemma combined_reach : forall v axes u, (forall p, In p axes -> length p = 3%nat) -> (forall a,
  In a u -> -1 <= a <= 1) ->
  dot v (combined 3 u axes) <= rreach v axes.
Proof.
  induction axes as [|h axes IH]; intros [|a u] hp hu.
  - change (combined 3 [] []) with (repeat 0 3). rewrite dot_zeros. simpl. lra.
  - change (combined 3 (a :: u) []) with (repeat 0 3). rewrite dot_zeros. simpl. lra.
  - change (combined 3 [] (h :: axes)) with (repeat 0 3). rewrite dot_zeros. assert (0 <= rreach v (h :: axes)); [|lra].
    clear. induction (h :: axes) as [|g l IH]; simpl; [lra|]. destruct (rsize_bounds (dot v g)) as (_ & _ & p). lra.
  - rewrite dot_combined by auto. simpl rreach.
    assert (i := IH u ltac:(intros; apply hp; simpl; auto) ltac:(intros; apply hu; simpl; auto)).
    assert (b := hu a ltac:(simpl; auto)). destruct (rsize_bounds (dot v h)) as (p & q & r).
    assert (a * dot v h <= rsize (dot v h)).
    { destruct (Rle_lt_dec 0 a).
      - assert (0 <= a * (rsize (dot v h) - dot v h)) by (apply Rmult_le_pos; lra).
        assert (0 <= (1 - a) * rsize (dot v h)) by (apply Rmult_le_pos; lra). lra.
      - assert (0 <= - a * (rsize (dot v h) + dot v h)) by (apply Rmult_le_pos; lra).
        assert (0 <= (1 + a) * rsize (dot v h)) by (apply Rmult_le_pos; lra). lra. }
    lra.
Qed.
Lemma obb_reach : forall v c axes x, right_obb c axes -> obb c axes x -> dot v x <= dot v c + rreach v axes.
Proof.
  intros v c axes x (lc & [_ hp] & _) (u & lu & hu & ->).
  rewrite dot_plus by (rewrite combined_length; auto). assert (g := combined_reach v axes u hp hu). lra.
Qed.
Lemma obb_length : forall c axes x, right_obb c axes -> obb c axes x -> length x = 3%nat.
Proof. intros c axes x (lc & [_ hp] & _) (u & _ & _ & ->). rewrite plus_length, combined_length;
  auto. rewrite combined_length; auto. Qed.
Lemma rreach_opposite : forall n axes, rreach (times (-1) n) axes = rreach n axes.
Proof.
  induction axes as [|h axes IH]; simpl; auto. rewrite IH, times_dot. f_equal. unfold rsize.
  replace (-1 * dot n h) with (0 - dot n h) by ring. replace (0 - (0 - dot n h)) with (dot n h) by ring.
    apply Rmax_comm.
Qed.

(** ** Coefficients, by Cramer's rule: the box as three slabs *)
Definition independent (axes : list (list R)) : Prop :=
  exists n0 n1 n2, length n0 = 3%nat /\ length n1 = 3%nat /\ length n2 = 3%nat /\
  (forall u0 u1 u2, dot n0 (combined 3 [u0; u1; u2] axes) = u0 /\ dot n1 (combined 3 [u0; u1; u2] axes) = u1 /\
     dot n2 (combined 3 [u0; u1; u2] axes) = u2) /\
  forall x, length x = 3%nat -> combined 3 [dot n0 x; dot n1 x; dot n2 x] axes = x.

Lemma right_box_means : forall c axes, means Q2R (right_box c axes) ->
  right_obb (rl c) (map rl axes) /\ independent (map rl axes).
Proof.
  intros c axes (lc & pa & nz). rewrite of_length_means in lc. apply points_mean in pa.
  assert (lc' := rl_length c). rewrite lc in lc'.
  assert (ind : independent (map rl axes)).
  { destruct axes as [|h [|i [|j [|]]]]; try (simpl in nz; tauto). simpl in nz.
    rewrite inner_means, leaves_mean in nz. unfold outer, at3 in nz. simpl values in nz.
    unfold values in nz. simpl map in nz. simpl value in nz. rewrite !coordinate_means in nz.
    destruct pa as [l hp]. simpl map in *.
    assert (lh := hp (rl h) ltac:(simpl; auto)). assert (li := hp (rl i) ltac:(simpl; auto)).
    assert (lj := hp (rl j) ltac:(simpl; auto)). clear - nz lh li lj.
    destruct (rl h) as [|h0 [|h1 [|h2 [|]]]]; try discriminate. destruct (rl i) as [|i0 [|i1 [|i2 [|]]]];
      try discriminate.
    destruct (rl j) as [|j0 [|j1 [|j2 [|]]]]; try discriminate. simpl in nz.
    set (det := h0 * (i1 * j2 - i2 * j1) + (h1 * (i2 * j0 - i0 * j2) + (h2 * (i0 * j1 - i1 * j0) + 0))) in *.
    assert (e : det = h0 * (i1 * j2 - i2 * j1) + h1 * (i2 * j0 - i0 * j2) + h2 * (i0 * j1 - i1 * j0)) by (unfold det;
      ring).
    clearbody det.
    exists [(i1 * j2 - i2 * j1) / det; (i2 * j0 - i0 * j2) / det; (i0 * j1 - i1 * j0) / det].
    exists [(j1 * h2 - j2 * h1) / det; (j2 * h0 - j0 * h2) / det; (j0 * h1 - j1 * h0) / det].
    exists [(h1 * i2 - h2 * i1) / det; (h2 * i0 - h0 * i2) / det; (h0 * i1 - h1 * i0) / det].
    do 3 (split; [auto|]). split.
    - intros. simpl. repeat split; apply (Rmult_eq_reg_r det); auto; field_simplify; auto; rewrite e; ring.
    - intros [|x0 [|x1 [|x2 [|]]]] lx; try discriminate. simpl.
      f_equal; [|f_equal; [|f_equal]]; apply (Rmult_eq_reg_r det); auto; field_simplify; auto; rewrite e; ring. }
  split; [|exact ind]. split; [auto|]. split; [auto|]. intros u lu [a [i na]].
  destruct ind as (n0 & n1 & n2 & _ & _ & _ & d & _). destruct u as [|u0 [|u1 [|u2 [|]]]]; try discriminate.
  assert (l3 := combined_length 3 (map rl axes) [u0; u1; u2] (proj2 pa)). destruct (d u0 u1 u2) as (d0 & d1 & d2).
  set (y := combined 3 [u0; u1; u2] (map rl axes)) in *.
  assert (zero : (forall b, In b y -> b = 0) -> forall v, dot v y = 0).
  { clear. intros z v. revert v. induction y as [|b y IH]; intros [|c v]; simpl; auto.
    rewrite (z b) by (simpl; auto). rewrite IH by (intros; apply z; simpl; auto). ring. }
  assert (cases : nonzero y \/ forall b, In b y -> b = 0).
  { clear. induction y as [|b y IH]; [right; simpl; tauto|]. destruct (Req_dec b 0) as [-> | nb].
    - destruct IH as [(c & i & nc) | IH]; [left; exists c; simpl; auto | right].
      intros b [<- | i]; auto.
    - left. exists b. simpl; auto. }
  destruct cases as [k | k]; auto. exfalso. rewrite zero in d0, d1, d2 by auto.
  destruct i as [<- | [<- | [<- | []]]]; auto.
Qed.

Lemma obb_coefficients : forall c axes x, right_obb c axes -> forall n0 n1 n2, 
  (forall u0 u1 u2, dot n0 (combined 3 [u0; u1; u2] axes) = u0 /\ dot n1 (combined 3 [u0; u1; u2] axes) = u1 /\
     dot n2 (combined 3 [u0; u1; u2] axes) = u2) -> obb c axes x ->
  forall n, In n [n0; n1; n2] -> -1 <= dot n x - dot n c <= 1.
Proof.
  intros c axes x (lc & [_ hp] & _) n0 n1 n2 d (u & lu & hu & ->) n i.
  rewrite dot_plus by (rewrite combined_length; auto). destruct u as [|u0 [|u1 [|u2 [|]]]]; try discriminate.
  destruct (d u0 u1 u2) as (d0 & d1 & d2).
  destruct i as [<- | [<- | [<- | []]]]; [rewrite d0 | rewrite d1 | rewrite d2];
    [assert (g := hu u0 ltac:(simpl; auto)) | assert (g := hu u1 ltac:(simpl;
      auto)) | assert (g := hu u2 ltac:(simpl; auto))]; lra.
Qed.
Lemma obb_inside : forall c axes u, right_obb c axes -> independent axes -> length u = 3%nat ->
  (forall a, In a u -> -1 < a < 1) -> interior 3 (obb c axes) (plus c (combined 3 u axes)).
Proof.
  intros c axes u (lc & [l hp] & _) (n0 & n1 & n2 & l0 & l1 & l2 & d & back) lu hu.
  assert (lx : length (plus c (combined 3 u axes)) = 3%nat) by (rewrite plus_length, combined_length; auto;
    rewrite combined_length; auto).
  set (slab_of n := (n, (dot n c - 1, dot n c + 1)) : slab R).
  apply (interior_subset 3 (fun y => forall s, In s (map slab_of [n0; n1; n2]) -> in_slab s y)).
  - intros y ly h. assert (lm : length (minus y c) = 3%nat) by (rewrite minus_length; congruence).
    exists [dot n0 (minus y c); dot n1 (minus y c); dot n2 (minus y c)]. split; [auto|]. split.
    + assert (s0 := h (slab_of n0) ltac:(simpl; auto)). assert (s1 := h (slab_of n1) ltac:(simpl; auto)).
      assert (s2 := h (slab_of n2) ltac:(simpl; auto)). simpl in s0, s1, s2.
      intros a [<- | [<- | [<- | []]]]; rewrite dot_minus by congruence; lra.
    + rewrite back by auto. clear - ly lc. revert c lc ly. 
      destruct y as [|y0 [|y1 [|y2 [|]]]]; try discriminate. intros [|c0 [|c1 [|c2 [|]]]] lc ly; try discriminate.
      simpl. repeat (f_equal; try ring).
  - apply (interior_each (B := slab R) 3 in_slab); auto. intros s i. apply in_map_iff in i. destruct i as [n [<- i]].
    assert (ln : length n = 3%nat) by (destruct i as [<- | [<- | [<- | []]]]; auto).
    apply slab_interior; auto. simpl. rewrite dot_plus by (rewrite combined_length; auto).
    destruct u as [|u0 [|u1 [|u2 [|]]]]; try discriminate. destruct (d u0 u1 u2) as (d0 & d1 & d2).
    destruct i as [<- | [<- | [<- | []]]]; [rewrite d0 | rewrite d1 | rewrite d2];
      [assert (g := hu u0 ltac:(simpl; auto)) | assert (g := hu u1 ltac:(simpl;
        auto)) | assert (g := hu u2 ltac:(simpl; auto))]; lra.
Qed.
Lemma inside_obb : forall c axes u, right_obb c axes -> independent axes -> length u = 3%nat ->
  interior 3 (obb c axes) (plus c (combined 3 u axes)) -> forall a, In a u -> -1 < a < 1.
Proof.
  intros c axes u right (n0 & n1 & n2 & l0 & l1 & l2 & d & back) lu h.
  assert (one : forall n, In n [n0; n1; n2] -> length n = 3%nat -> nonzero n ->
    -1 < dot n (plus c (combined 3 u axes)) - dot n c < 1).
  { intros n i ln nz. assert (g : interior 3 (in_slab (n, (dot n c - 1, dot n c + 1))) (plus c (combined 3 u axes))).
    { apply (interior_subset 3 (obb c axes)); auto. intros y ly hy. simpl.
      assert (k := obb_coefficients c axes y right n0 n1 n2 d hy n i). lra. }
    apply interior_slab in g; [simpl in g; lra|]. split; [auto|]. split; [auto | simpl; lra]. }
  destruct right as (lc & [l hp] & _).
  assert (nonz : forall n y, dot n y = 1 -> nonzero n).
  { intros n y e. clear - e. revert y e. induction n as [|b n IH]; intros [|z y] e; simpl in e; try lra.
    destruct (Req_dec b 0) as [-> | nb].
    - destruct (IH y) as (a & i & na); [lra|]. exists a. simpl; auto.
    - exists b. simpl; auto. }
  assert (z0 : nonzero n0) by (eapply nonz; apply (proj1 (d 1 0 0))).
  assert (z1 : nonzero n1) by (eapply nonz; apply (proj1 (proj2 (d 0 1 0)))).
  assert (z2 : nonzero n2) by (eapply nonz; apply (proj2 (proj2 (d 0 0 1)))).
  assert (o0 := one n0 ltac:(simpl; auto) l0 z0). assert (o1 := one n1 ltac:(simpl; auto) l1 z1).
  assert (o2 := one n2 ltac:(simpl; auto) l2 z2). rewrite dot_plus in o0, o1, o2 by (rewrite combined_length; auto).
  destruct u as [|u0 [|u1 [|u2 [|]]]]; try discriminate. destruct (d u0 u1 u2) as (d0 & d1 & d2).
  rewrite d0 in o0. rewrite d1 in o1. rewrite d2 in o2. intros a [<- | [<- | [<- | []]]]; lra.
Qed.

Lemma placed_means : forall c axes u, values (placed c axes u) = plus (rl c) (combined 3 (rl u) (map rl axes)).
Proof. intros; unfold placed. rewrite sum_means, leaves_mean, mixed_means. auto. Qed.
Lemma within_one_means : forall u, means Q2R (within_one u) -> length (rl u) = 3%nat /\
  forall a, In a (rl u) -> -1 <= a <= 1.
Proof.
  intros u [l h]. rewrite of_length_means in l. rewrite all_means in h. split; [rewrite rl_length; auto|].
  intros a i. apply in_map_iff in i. destruct i as [q [<- i]]. apply (rsize_below (Q2R q) 1). exact (h q i).
Qed.
Lemma inside_one_means : forall u, means Q2R (inside_one u) <-> length (rl u) = 3%nat /\
  forall a, In a (rl u) -> -1 < a < 1.
Proof.
  intro u. unfold inside_one. simpl means. rewrite of_length_means, all_means, rl_length. split; intros [l h]; split;
    auto.
  - intros a i. apply in_map_iff in i. destruct i as [q [<- i]]. apply (rsize_less (Q2R q) 1). exact (h q i).
  - intros q i. simpl. apply (rsize_less (Q2R q) 1). apply h. apply in_map; auto.
Qed.

Theorem point_in_obb_sound : forall c axes p w facts, decide (check_point_in_obb c axes p w facts) = true ->
  point_in_obb_spec (rl c) (map rl axes) (rl p) w.
Proof.
  intros c axes p w facts h. apply decide_means in h. destruct h as (right & lp & h). rewrite of_length_means in lp.
  assert (lp' := rl_length p). rewrite lp in lp'. apply right_box_means in right. destruct right as [right ind].
  assert (lc := proj1 right). split; [auto|]. split; [auto|].
  destruct w, facts; try (simpl in h; tauto).
  - destruct h as [i e]. rewrite same_vector_means, leaves_mean, placed_means in e. rewrite inside_one_means in i.
    rewrite e. apply obb_inside; tauto.
  - destruct h as (i & ni & e). rewrite same_vector_means, leaves_mean, placed_means in e.
    apply within_one_means in i. change (~ means Q2R (inside_one u)) in ni. rewrite inside_one_means in ni. split.
    + exists (rl u). tauto.
    + intro k. apply ni. split; [tauto|]. rewrite e in k. apply (inside_obb (rl c) (map rl axes)); tauto.
  - destruct h as [ln far]. simpl in far. rewrite reach_means, inner_means, difference_means, !leaves_mean in far.
    intro k. apply (obb_reach (rl n)) in k; auto. rewrite dot_minus in far by congruence. lra.
Qed.
Theorem point_in_obb_unique : forall c axes p v w, point_in_obb_spec c axes p v -> point_in_obb_spec c axes p w ->
  v = w.
Proof. intros c axes p v w [_ g] [_ h]. apply (location_unique _ _ _ _ _ g h). Qed.

Theorem obb_obb_sound : forall ca a cb b w facts, decide (check_obb_obb ca a cb b w facts) = true ->
  obb_obb_spec (rl ca) (map rl a) (rl cb) (map rl b) w.
Proof.
  intros ca a cb b w facts h. apply decide_means in h. unfold check_obb_obb in h. cbv zeta in h.
  destruct h as (ra & rb & h). apply right_box_means in ra, rb. destruct ra as [ra ia], rb as [rb ib].
  assert (la := proj1 ra). assert (lb := proj1 rb). split; [auto|]. split; [auto|].
  assert (gap : forall n x, obb (rl ca) (map rl a) x -> obb (rl cb) (map rl b) x ->
    dot (rl n) (minus (rl cb) (rl ca)) <= rreach (rl n) (map rl a) + rreach (rl n) (map rl b)).
  { intros n x ha hb. apply (obb_reach (rl n)) in ha; auto. apply (obb_reach (times (-1) (rl n))) in hb; auto.
    rewrite rreach_opposite, !times_dot in hb. rewrite dot_minus by congruence. lra. }
  destruct w, facts; try (simpl in h; tauto).
  - destruct h as [_ far]. simpl in far. rewrite !reach_means, inner_means, difference_means, !leaves_mean in far.
    intros x lx [ha hb]. assert (g := gap n x ha hb). lra.
  - destruct h as (ln & nz & e & hu & hv & s). simpl in e.
    rewrite !reach_means, inner_means, difference_means, !leaves_mean in e. apply not_zero_means in nz.
    rewrite same_vector_means, !placed_means in s. apply within_one_means in hu, hv.
    rewrite of_length_means in ln. assert (ln' := rl_length n). rewrite ln in ln'. split.
    + exists (plus (rl ca) (combined 3 (rl u) (map rl a))).
      assert (oa : obb (rl ca) (map rl a) (plus (rl ca) (combined 3 (rl u) (map rl a)))) by (exists (rl u); tauto).
      split; [apply (obb_length (rl ca) (map rl a)); auto|]. split; auto. exists (rl v). tauto.
    + intros x [ja jb]. rewrite dot_minus in e by congruence.
      assert (k : interior 3 (half_space (rl n) (- (dot (rl n) (rl ca) + rreach (rl n) (map rl a)))) x).
      { apply (interior_subset 3 (obb (rl ca) (map rl a))); auto. intros y ly hy. unfold half_space.
        apply (obb_reach (rl n)) in hy; auto. lra. }
      apply half_space_interior in k; auto. apply interior_in in jb. apply (obb_reach (times (-1) (rl n))) in jb; auto.
      rewrite rreach_opposite, !times_dot in jb. lra.
  - destruct h as (hu & hv & s). rewrite same_vector_means, !placed_means in s. rewrite inside_one_means in hu, hv.
    exists (plus (rl ca) (combined 3 (rl u) (map rl a))). split; [apply obb_inside; tauto|].
    rewrite s. apply obb_inside; tauto.
Qed.
Theorem obb_obb_unique : forall ca a cb b v w, obb_obb_spec ca a cb b v -> obb_obb_spec ca a cb b w -> v = w.
Proof. intros ca a cb b v w (_ & _ & g) (_ & _ & h). apply (contact_unique _ _ _ _ _ g h). Qed.

(** ** A ball *)
Lemma times_plus : forall t x y, times t (plus x y) = plus (times t x) (times t y).
Proof. unfold times; induction x as [|a x IH]; intros [|b y]; simpl; auto. rewrite IH. f_equal; ring. Qed.
Lemma times_times : forall s t x, times s (times t x) = times (s * t) x.
Proof. intros; unfold times. rewrite map_map. apply map_ext. intro; ring. Qed.
Lemma combined_times : forall t axes u, combined 3 (times t u) axes = times t (combined 3 u axes).
Proof.
  assert (zeros : forall t, times t (repeat 0 3) = repeat 0 3) by (intro; simpl; repeat (f_equal; try ring)).
  induction axes as [|h axes IH]; intros [|a u]; try (symmetry; apply zeros).
  change (plus (times (t * a) h) (combined 3 (times t u) axes) = times t (plus (times a h) (combined 3 u axes))).
  rewrite IH, times_plus, times_times. auto.
Qed.
(** If a point of a box is inside of a ball, there are points of its interior that are. *)
Lemma ball_reaches_inside : forall p r c axes u, length p = 3%nat -> 0 <= r -> right_obb c axes -> independent axes ->
  length u = 3%nat -> (forall a, In a u -> -1 <= a <= 1) -> sqdist p (plus c (combined 3 u axes)) < r * r ->
  exists z, interior 3 (ball p r) z /\ interior 3 (obb c axes) z.
Proof.
  intros p r c axes u lp hr right ind lu hu near. assert (lc := proj1 right).
  assert (hp := proj2 (proj1 (proj2 right))).
  set (d := combined 3 u axes) in *. assert (ld : length d = 3%nat) by (apply combined_length; auto).
  destruct (nearer_on_the_way p r c d) as (t & ht & m); try congruence.
  exists (plus c (times (1 - t) d)). split.
  - apply inside_ball; auto. rewrite plus_length; rewrite times_length; congruence.
  - unfold d. rewrite <- combined_times. apply obb_inside; auto; [rewrite times_length; auto|].
    intros a i. apply in_map_iff in i. destruct i as [b [<- i]]. assert (hb := hu b i).
    assert (0 <= (1 - t) * (1 - b)) by (apply Rmult_le_pos; lra).
    assert (0 <= (1 - t) * (1 + b)) by (apply Rmult_le_pos; lra). lra.
Qed.
Theorem sphere_obb_sound : forall c r center axes w facts u,
  decide (check_sphere_obb c r center axes w facts u) = true ->
  sphere_obb_spec (rl c) (Q2R r) (rl center) (map rl axes) w.
Proof.
  intros c r center axes w facts u h. apply decide_means in h. unfold check_sphere_obb in h. cbv zeta in h.
  destruct h as (lc & hr & right & hu & h). rewrite of_length_means in lc. assert (lc' := rl_length c).
  rewrite lc in lc'. simpl in hr. apply right_box_means in right. destruct right as [right ind].
  apply within_one_means in hu. destruct hu as [lu hu]. assert (lo := proj1 right).
  split; [split; auto|]. split; [auto|].
  set (x := plus (rl center) (combined 3 (rl u) (map rl axes))).
  assert (hx : obb (rl center) (map rl axes) x) by (exists (rl u); auto).
  assert (lx := obb_length _ _ _ right hx).
  unfold gap_decides in h.
  assert (q : value Q2R (inner (difference (leaves c) (placed center axes u)) (difference (leaves c) (placed center axes
    u))) = sqdist (rl c) x).
  { rewrite inner_means, difference_means, leaves_mean, placed_means. fold x. rewrite <- sqdist_dot; auto; congruence. }
  assert (near : means Q2R (reach (difference (leaves c) (placed center axes u)) axes <=
    inner (difference (leaves c) (placed center axes u)) (difference (placed center axes u) (leaves center)))%check ->
    forall y, obb (rl center) (map rl axes) y -> sqdist (rl c) x <= sqdist (rl c) y).
  { intros m y hy. simpl in m. rewrite reach_means, inner_means, !difference_means, !leaves_mean, placed_means in m.
    fold x in m. assert (ly := obb_length _ _ _ right hy). apply nearest_by_angle; try congruence.
    apply (obb_reach (minus (rl c) x)) in hy; auto. rewrite dot_minus in * by congruence. lra. }
  destruct w, facts; try (simpl in h; tauto).
  - destruct h as (n & far). simpl in far. rewrite q in far. intros z lz [b o]. unfold ball in b.
    assert (g := near n z o). lra.
  - destruct h as (n & e). simpl in e. rewrite q in e. split.
    + exists x. split; [auto|]. split; auto. unfold ball. lra.
    + intros z [b o]. apply interior_in in o. apply interior_ball in b; auto. assert (g := near n z o). lra.
  - destruct h as (e & z). simpl in e, z. rewrite q in e. split.
    + exists x. auto.
    + intros v [b _]. apply interior_ball in b; auto. assert (g := sqdist_nonneg (rl c) v). rewrite z in b. lra.
  - destruct h as (e & _). simpl in e. rewrite q in e. apply (ball_reaches_inside _ _ _ _ (rl u)); auto.
Qed.
Theorem sphere_obb_unique : forall c r center axes v w, sphere_obb_spec c r center axes v ->
  sphere_obb_spec c r center axes w -> v = w.
Proof. intros c r center axes v w (_ & _ & g) (_ & _ & h). apply (contact_unique _ _ _ _ _ g h). Qed.

(** ** A capsule *)
Theorem capsule_obb_sound : forall points r center axes w facts on_a on_b,
  decide (check_capsule_obb points r center axes w facts on_a on_b) = true ->
  capsule_obb_spec (map rl points) (Q2R r) (rl center) (map rl axes) w.
Proof.
  intros points r center axes w facts on_a on_b h. apply decide_means in h. unfold check_capsule_obb in h.
  cbv zeta in h.
  destruct h as (pa & hr & right & wa & hu & h). apply points_mean in pa. simpl in hr.
  apply right_box_means in right. destruct right as [right ind]. assert (lo := proj1 right).
  apply (weights_mean 3) in wa. rewrite <- mixed_means in wa. apply within_one_means in hu. destruct hu as [lu hu].
  split; [assumption|]. split; [split; assumption|]. assert (pa' := proj2 pa).
  set (x := values (mixed 3 on_a points)) in *.
  set (y := plus (rl center) (combined 3 (rl on_b) (map rl axes))).
  assert (hy : obb (rl center) (map rl axes) y) by (exists (rl on_b); auto).
  assert (lx := hull_length _ _ _ pa' wa). assert (ly := obb_length _ _ _ right hy).
  assert (fa : flat (map rl points)) by (eapply flat_points; [eauto | lia]).
  unfold gap_decides in h.
  set (way := difference (mixed 3 on_a points) (placed center axes on_b)) in *.
  assert (ew : values way = minus x y) by (unfold way; rewrite difference_means, placed_means; auto).
  assert (q : value Q2R (inner way way) = sqdist x y).
  { rewrite inner_means, ew, <- sqdist_dot; auto; congruence. }
  set (near := (none_nearer points (mixed 3 on_a points) (placed center axes on_b) /\ _ <= _)%check) in h.
  assert (nearest : means Q2R near -> (forall z, hull 3 (map rl points) z -> 0 <= dot (minus x y) (minus z x)) /\
    forall v, length v = 3%nat -> obb (rl center) (map rl axes) v -> 0 <= dot (minus y x) (minus v y)).
  { intros (na & nb). split.
    - intros z hz. assert (g := none_nearer_means 3 points _ _ (counted _ _ _ pa) lx na z hz).
      rewrite placed_means in g. exact g.
    - intros v lv hv. apply (obb_reach (minus x y)) in hv; auto. simpl in nb.
      rewrite reach_means, inner_means, difference_means, leaves_mean, placed_means, ew in nb. fold y in nb.
      rewrite dot_minus in nb by (rewrite ?minus_length; congruence).
      rewrite dot_minus by (rewrite ?minus_length; congruence). rewrite !minus_dot in * by congruence. lra. }
  destruct w, facts; try (simpl in h; tauto).
  - destruct h as (n & far). simpl in far. rewrite q in far. destruct (nearest n) as [na nb].
    unfold contact_spec. apply (set_apart (map rl points) _ x y); auto.
  - destruct h as (n & e). simpl in e. rewrite q in e. destruct (nearest n) as [na nb]. split.
    + exists y. split; [auto|]. split; [exists x; split; [auto | lra] | auto].
    + intros z [i j]. apply interior_in in j.
      apply (set_tangent (map rl points) (obb (rl center) (map rl axes)) x y (Q2R r)) with z; auto.
  - destruct h as (e & z). simpl in e, z. rewrite q in e. split.
    + exists y. split; [auto|]. split; [exists x; split; [auto | lra] | auto].
    + intros v [i _]. rewrite z in i. apply (flat_has_no_interior (map rl points) v) in i; auto.
  - destruct h as (e & _). simpl in e. rewrite q in e.
    destruct (ball_reaches_inside x (Q2R r) (rl center) (map rl axes) (rl on_b)) as (z & i & j); auto.
    exists z. split; [|auto]. apply (interior_subset 3 (ball x (Q2R r))); auto. intros u _ hb. exists x. auto.
Qed.
Theorem capsule_obb_unique : forall points r center axes v w, capsule_obb_spec points r center axes v ->
  capsule_obb_spec points r center axes w -> v = w.
Proof. intros points r center axes v w (_ & _ & g) (_ & _ & h). apply (contact_unique _ _ _ _ _ g h). Qed.
