(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of oriented boxes and of capsules, at rest and in motion, over planes are enough, and their
    specifications leave no choice. *)
Require Import Reals Qreals QArith Lra Lia List Arith Bool.
From Certificates Require Import solids motion hulls language formulas_vectors formulas_solids formulas_slabs
  formulas_nearest formulas_obbs formulas_motion formulas_half_spaces sound_solids sound_vectors sound_slabs
  sound_motion sound_nearest sound_capsules sound_obbs unique_solids unique_slabs.
Import ListNotations.
Open Scope R_scope.

Theorem obb_plane_sound : forall c axes n d w facts, decide (check_obb_plane c axes n d w facts) = true ->
  obb_plane_spec (rl c) (map rl axes) (rl n) (Q2R d) w.
Proof.
  intros c axes n d w facts h. apply decide_means in h. unfold check_obb_plane in h. cbv zeta in h.
  destruct h as (right & ln & nz & h). apply right_box_means in right. destruct right as [right ind].
  rewrite of_length_means in ln. apply not_zero_means in nz. assert (ln' := rl_length n). rewrite ln in ln'.
  split; [auto|]. do 2 (split; [auto|]).
  assert (above : forall z, obb (rl c) (map rl axes) z ->
    dot (rl n) (rl c) - rreach (rl n) (map rl axes) <= dot (rl n) z).
  { intros z hz. apply (obb_reach (times (-1) (rl n))) in hz; auto.
    rewrite rreach_opposite, !times_dot in hz. lra. }
  destruct w, facts as [u | u | u | u | u k]; try (simpl in h; tauto).
  - destruct h as (_ & e & far). simpl in e, far. rewrite !inner_means, ?height_means, reach_means, placed_means,
      !leaves_mean in *.
    intros z lz [hz s]. unfold half_space in s. assert (g := above z hz). lra.
  - destruct h as (hu & e & far). simpl in e, far. rewrite !inner_means, ?height_means, reach_means, placed_means,
      !leaves_mean in *. apply within_one_means in hu. destruct hu as [lu hu].
    set (x := plus (rl c) (combined 3 (rl u) (map rl axes))) in *.
    assert (hx : obb (rl c) (map rl axes) x) by (exists (rl u); auto). split.
    + exists x. split; [apply (obb_length _ _ _ right hx)|]. split; [auto|]. unfold half_space. lra.
    + intros z [hz s]. apply half_space_interior in s; auto. assert (g := above z (interior_in _ _ _ hz)). lra.
  - destruct h as (hu & low). simpl in low. rewrite inner_means, placed_means, leaves_mean in low.
    apply inside_one_means in hu. destruct hu as [lu hu]. exists (plus (rl c) (combined 3 (rl u) (map rl axes))).
    assert (i := obb_inside (rl c) (map rl axes) (rl u) right ind lu hu). split; [auto|].
    apply interior_half_space; auto. apply (proj1 i).
Qed.
Theorem obb_plane_unique : forall c axes n d v w, obb_plane_spec c axes n d v -> obb_plane_spec c axes n d w -> v = w.
Proof. intros c axes n d v w (_ & _ & _ & g) (_ & _ & _ & h). apply (contact_unique _ _ _ _ _ g h). Qed.

(** The normal leads from y, a point of the half-space, to x, or y is x: from what is as high as x, or higher, to what
    is in the half-space it is no less far, and farther to what is behind the plane. *)
Lemma as_far_from_half_space : forall N d x y q z, length x = length N -> length y = length N -> length q = length N ->
  length z = length N -> nonzero N -> 0 <= dot N (minus x y) -> dot N (minus x y) * (dot N y + d) = 0 ->
  dot N (minus x y) * dot N (minus x y) = dot (minus x y) (minus x y) * dot N N -> dot N x <= dot N q ->
  (dot N z + d <= 0 -> sqdist x y <= sqdist q z) /\
  (dot N z + d < 0 -> 0 < sqdist x y -> sqdist x y < sqdist q z).
Proof.
  intros N d x y q z lx ly lq lz nz ha hz hp hq. apply dot_nonzero in nz.
  assert (lm : length (minus q z) = length N) by (rewrite minus_length; congruence).
  assert (c := cauchy N (minus q z) ltac:(congruence)). rewrite dot_minus in c by congruence.
  rewrite <- !sqdist_dot in * by congruence. rewrite dot_minus in * by congruence.
  set (a := dot N x - dot N y) in *. set (b := dot N q - dot N z) in *.
  destruct (Req_dec a 0) as [e | e].
  { rewrite e in hp. assert (zero : sqdist x y = 0).
    { assert (m : sqdist x y * dot N N = 0) by lra. apply Rmult_integral in m. destruct m; [auto | lra]. }
    rewrite zero. split; [intros; apply sqdist_nonneg | intros; lra]. }
  assert (on : dot N y + d = 0) by (destruct (Rmult_integral _ _ hz); [tauto | auto]).
  split; [intro low | intros low _].
  - assert (m : a * a <= b * b) by (apply Rmult_le_compat; unfold a, b in *; lra).
    apply (Rmult_le_reg_l (dot N N)); lra.
  - assert (m : a * a < b * b) by (apply Rmult_le_0_lt_compat; unfold a, b in *; lra).
    apply (Rmult_lt_reg_l (dot N N)); lra.
Qed.

Theorem capsule_plane_sound : forall points r n d w facts weights,
  decide (check_capsule_plane points r n d w facts weights) = true ->
  capsule_plane_spec (map rl points) (Q2R r) (rl n) (Q2R d) w.
Proof.
  intros points r n d w facts weights h. apply decide_means in h. unfold check_capsule_plane in h. cbv zeta in h.
  destruct h as (pp & hr & ln & nz & hw & m & h). apply points_mean in pp. simpl in hr. rewrite of_length_means in ln.
  apply not_zero_means in nz. assert (ln' := rl_length n). rewrite ln in ln'.
  assert (hp := proj2 pp). apply (weights_mean 3) in hw.
  set (x := combined 3 (rl weights) (map rl points)) in *.
  assert (lx := hull_length _ _ _ hp hw).
  split; [split; auto|]. do 2 (split; [auto|]).
  assert (low : forall q, hull 3 (map rl points) q -> dot (rl n) x <= dot (rl n) q).
  { intros q hq. rewrite all_means in m. apply (hull_above 3 (map rl points)); auto.
    intros p ip. apply in_map_iff in ip. destruct ip as [p' [<- ip]]. specialize (m p' ip). simpl in m.
    rewrite !inner_means, !leaves_mean, mixed_means in m. auto. }
  destruct w, facts as [y | y | y | y | y k]; try (simpl in h; tauto).
  - destruct h as (ly & (h1 & h2 & h3 & h4) & far). simpl in h1, h2, h3, h4, far.
    rewrite of_length_means in ly. assert (ly' := rl_length y). rewrite ly in ly'.
    rewrite ?height_means, !inner_means, !difference_means, !leaves_mean, !mixed_means in *. fold x in h2, h3, h4, far.
    intros z lz [(q & hq & near) s]. unfold half_space in s. assert (lq := hull_length _ _ _ hp hq).
    rewrite <- sqdist_dot in far by congruence.
    destruct (as_far_from_half_space (rl n) (Q2R d) x (rl y) q z) as [g _]; try congruence; auto. specialize (g s). lra.
  - destruct h as (ly & (h1 & h2 & h3 & h4) & e). simpl in h1, h2, h3, h4, e.
    rewrite of_length_means in ly. assert (ly' := rl_length y). rewrite ly in ly'.
    rewrite ?height_means, !inner_means, !difference_means, !leaves_mean, !mixed_means in *. fold x in h2, h3, h4, e.
    rewrite <- sqdist_dot in e by congruence. split.
    + exists (rl y). split; [auto|]. split; [exists x; split; [auto | lra] | auto].
    + intros z [i s]. assert (lz := proj1 i). apply half_space_interior in s; auto.
      destruct (Req_dec (Q2R r) 0) as [zero | pos].
      { rewrite zero in i. apply (flat_has_no_interior (map rl points) z) in i; auto.
        destruct points as [|p0 [|p1 [|]]]; try (destruct pp; discriminate). apply flat_pair; apply hp; simpl; auto. }
      apply interior_in in i. destruct i as (q & hq & near). assert (lq := hull_length _ _ _ hp hq).
      destruct (as_far_from_half_space (rl n) (Q2R d) x (rl y) q z) as [_ g]; try congruence; auto.
      assert (0 < Q2R r * Q2R r) by (apply Rmult_lt_0_compat; lra). specialize (g s ltac:(lra)). lra.
  - destruct h as (ly & h1 & near). simpl in h1, near.
    rewrite of_length_means in ly. assert (ly' := rl_length y). rewrite ly in ly'.
    rewrite ?height_means, !inner_means, !difference_means, !leaves_mean, !mixed_means in *. fold x in near.
    rewrite <- sqdist_dot in near by congruence. exists (rl y). split; [|apply interior_half_space; auto].
    apply (interior_subset 3 (ball x (Q2R r))); [intros v _ hv; exists x; auto|]. apply inside_ball; auto.
Qed.
Theorem capsule_plane_unique : forall points r n d v w, capsule_plane_spec points r n d v ->
  capsule_plane_spec points r n d w -> v = w.
Proof. intros points r n d v w (_ & _ & _ & g) (_ & _ & _ & h). apply (contact_unique _ _ _ _ _ g h). Qed.

(** ** A capsule meets a plane where the ball around some point of its segment does. *)
Lemma capsule_meets_plane : forall points r n d v t, points_of 2 3 points -> length v = 3%nat -> length n = 3%nat ->
  nonzero n -> ((exists x, length x = 3%nat /\ capsule points r x /\ dot n (at_time x v t) + d = 0) <->
    exists q, hull 3 points q /\ (dot n q + d + t * dot n v) * (dot n q + d + t * dot n v) <= r * r * dot n n).
Proof.
  intros points r n d v t pp lv ln nz. split.
  - intros (x & lx & (q & hq & near) & on). exists q. split; [auto|]. assert (lq := hull_length _ _ _ (proj2 pp) hq).
    rewrite dot_at_time in on by congruence.
    replace (dot n q + d + t * dot n v) with (dot n q + (d + t * dot n v)) by ring.
    apply ball_meets_plane; auto. exists x. split; [auto|]. split; [exact near | lra].
  - intros (q & hq & h). assert (lq := hull_length _ _ _ (proj2 pp) hq).
    replace (dot n q + d + t * dot n v) with (dot n q + (d + t * dot n v)) in h by ring.
    apply ball_meets_plane in h; auto. destruct h as (x & lx & near & on). exists x. split; [auto|].
    split; [exists q; auto|]. rewrite dot_at_time by congruence. lra.
Qed.
(** What is at the height h at the start, no nearer than e on the same side, does not come within k before that does. *)
Lemma nearer_comes_first : forall e h s t k, 0 <= t -> 0 <= k -> e = 0 \/ 0 < e <= h \/ h <= e < 0 ->
  (h + t * s) * (h + t * s) <= k * k -> exists u, 0 <= u <= t /\ (e + u * s) * (e + u * s) <= k * k.
Proof.
  assert (positive : forall e h s t k, 0 <= t -> 0 <= k -> 0 < e <= h -> (h + t * s) * (h + t * s) <= k * k ->
    exists u, 0 <= u <= t /\ (e + u * s) * (e + u * s) <= k * k).
  { intros e h s t k ht hk i near. destruct (Rle_lt_dec e k) as [l | l].
    { exists 0. split; [lra|]. replace (e + 0 * s) with e by ring. apply Rmult_le_compat; lra. }
    assert (low : h + t * s <= k).
    { apply Rnot_lt_le; intro m. assert (k * k < (h + t * s) * (h + t * s)) by (apply Rmult_le_0_lt_compat; lra). lra. }
    assert (down : s < 0).
    { apply Rnot_le_lt; intro m. assert (0 <= t * s) by (apply Rmult_le_pos; auto). lra. }
    exists ((e - k) / - s). assert (at_k : (e - k) / - s * s = k - e) by (field; lra).
    split; [split|].
    - apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; lra].
    - apply (Rmult_le_reg_r (- s)); lra.
    - rewrite at_k. replace (e + (k - e)) with k by ring. lra. }
  intros e h s t k ht hk [-> | [i | i]] near.
  - exists 0. split; [lra|]. assert (0 <= k * k) by (apply Rmult_le_pos; auto). lra.
  - apply (positive e h s t k); auto.
  - destruct (positive (- e) (- h) (- s) t k) as (u & iu & near'); auto; try lra.
    exists u. split; [auto|]. lra.
Qed.
Lemma on_both_sides : forall p q n d, length p = 3%nat -> length q = 3%nat ->
  (dot n p + d) * (dot n q + d) <= 0 -> exists x, hull 3 [p; q] x /\ dot n x + d = 0.
Proof.
  intros p q n d lp lq h. set (a := dot n p + d) in *. set (b := dot n q + d) in *.
  assert (lengths : forall x, In x [p; q] -> length x = 3%nat) by (intros x [<- | [<- | []]]; auto).
  assert (mix : forall u w, 0 <= u -> 0 <= w -> u + w = 1 -> hull 3 [p; q] (combined 3 [u; w] [p; q]) /\
    dot n (combined 3 [u; w] [p; q]) + d = u * a + w * b).
  { intros u w hu hw one. split.
    - exists [u; w]. split; [auto|]. split; [intros x [<- | [<- | []]]; auto|]. split; [simpl; lra | auto].
    - rewrite !dot_combined by (auto; intros x i; apply lengths; simpl in *; tauto).
      change (combined 3 [] []) with (repeat 0 3). rewrite dot_zeros. unfold a, b.
      replace d with ((u + w) * d) at 1 by (rewrite one; ring). ring. }
  destruct (Req_dec a b) as [e | e].
  - assert (z : a = 0).
    { rewrite <- e in h. destruct (Req_dec a 0); auto. assert (0 < a * a) by (apply Rsqr_pos_lt; auto). lra. }
    destruct (mix 1 0) as [m1 m2]; try lra. eexists. split; [exact m1|]. rewrite m2, <- e, z. ring.
  - assert (opposite : 0 <= b / (b - a) /\ 0 <= - a / (b - a)).
    { destruct (Rle_lt_dec a b) as [l | l].
      - assert (0 < / (b - a)) by (apply Rinv_0_lt_compat; lra).
        assert (a <= 0 /\ 0 <= b) as [sa sb].
        { split; apply Rnot_lt_le; intro m.
          - assert (0 < a * b) by (apply Rmult_lt_0_compat; lra). lra.
          - assert (0 < - a * - b) by (apply Rmult_lt_0_compat; lra). lra. }
        split; apply Rmult_le_pos; lra.
      - assert (0 < / (a - b)) by (apply Rinv_0_lt_compat; lra).
        assert (b <= 0 /\ 0 <= a) as [sa sb].
        { split; apply Rnot_lt_le; intro m.
          - assert (0 < a * b) by (apply Rmult_lt_0_compat; lra). lra.
          - assert (0 < - a * - b) by (apply Rmult_lt_0_compat; lra). lra. }
        replace (b / (b - a)) with (- b * / (a - b)) by (field; lra).
        replace (- a / (b - a)) with (a * / (a - b)) by (field; lra). split; apply Rmult_le_pos; lra. }
    destruct (mix (b / (b - a)) (- a / (b - a))) as [m1 m2]; try tauto; [field; lra|].
    eexists. split; [exact m1|]. rewrite m2. field. lra.
Qed.
(** The first contact with a point of the segment than which no other is nearer to the plane *)
Lemma nearest_point_first : forall points r n d v x w, points_of 2 3 points -> length v = 3%nat -> length n = 3%nat ->
  nonzero n -> 0 <= r -> hull 3 points x ->
  let e := dot n x + d in
  (forall q, hull 3 points q -> e = 0 \/ 0 < e <= dot n q + d \/ dot n q + d <= e < 0) ->
  first_time_spec (fun t => (e + t * dot n v) * (e + t * dot n v) <= r * r * dot n n) w ->
  first_time_spec (fun t => exists x, length x = 3%nat /\ capsule points r x /\ dot n (at_time x v t) + d = 0) w.
Proof.
  intros points r n d v x w pp lv ln nz hr hx e nearest. assert (pos := dot_self n).
  assert (reach : r * r * dot n n = (r * sqrt (dot n n)) * (r * sqrt (dot n n))).
  { assert (s := sqrt_def _ pos). rewrite <- s at 1. ring. }
  apply first_time_sooner; intros t.
  - intro m. apply capsule_meets_plane; auto. exists x. auto.
  - intros ht m. apply capsule_meets_plane in m; auto. destruct m as (q & hq & m). rewrite reach in m |- *.
    apply (nearer_comes_first e (dot n q + d)); auto. apply Rmult_le_pos; [auto | apply sqrt_pos].
Qed.

Theorem swept_capsule_plane_sound : forall points r v n d answer kind facts,
  decide (check_swept_capsule_plane points r v n d answer kind facts) = true ->
  swept_capsule_plane_spec (map rl points) (Q2R r) (rl v) (rl n) (Q2R d) (option_map r_surd answer).
Proof.
  intros points r v n d answer kind facts h. apply decide_means in h. unfold check_swept_capsule_plane in h.
  cbv zeta in h. destruct h as (pp & hr & lv & ln & nz & h). apply points_mean in pp. simpl in hr.
  rewrite of_length_means in lv, ln. apply not_zero_means in nz. assert (lv' := rl_length v). rewrite lv in lv'.
  assert (ln' := rl_length n). rewrite ln in ln'.
  destruct points as [|p [|q [|]]]; try (simpl in h; tauto). simpl map in *.
  assert (lp : length (rl p) = 3%nat) by (apply (proj2 pp); simpl; auto).
  assert (lq : length (rl q) = 3%nat) by (apply (proj2 pp); simpl; auto).
  unfold swept_capsule_plane_spec. split; [split; [auto | lra]|]. do 3 (split; [auto|]).
  assert (corner : forall c, c = rl p \/ c = rl q -> hull 3 [rl p; rl q] c).
  { intros c [-> | ->]; [exists [1; 0] | exists [0; 1]]; (split; [auto|]); (split; [intros a [<- | [<- | []]]; lra|]);
      (split; [simpl; lra|]); destruct (rl p) as [|p0 [|p1 [|p2 [|]]]]; try discriminate;
      destruct (rl q) as [|q0 [|q1 [|q2 [|]]]]; try discriminate; unfold times; simpl; repeat (f_equal; try ring). }
  assert (above : forall c, (forall a, a = rl p \/ a = rl q -> c <= dot (rl n) a) -> forall x,
    hull 3 [rl p; rl q] x -> c <= dot (rl n) x).
  { intros c low x hx. apply (hull_above 3 [rl p; rl q]); auto; [apply (proj2 pp)|]. intros a [<- | [<- | []]]; auto. }
  assert (below : forall c, (forall a, a = rl p \/ a = rl q -> dot (rl n) a <= c) -> forall x,
    hull 3 [rl p; rl q] x -> dot (rl n) x <= c).
  { intros c high x hx. assert (g : - c <= dot (times (-1) (rl n)) x); [|rewrite times_dot in g; lra].
    apply (hull_above 3 [rl p; rl q]); auto; [apply (proj2 pp)|].
    intros a [<- | [<- | []]]; rewrite times_dot; [assert (g := high (rl p) ltac:(auto)) |
      assert (g := high (rl q) ltac:(auto))]; lra. }
  assert (end_first : forall c, c = p \/ c = q -> let e := dot (rl n) (rl c) + Q2R d in
    0 < (dot (rl n) (rl p) + Q2R d) * (dot (rl n) (rl q) + Q2R d) ->
    (forall a, a = rl p \/ a = rl q -> e * e <= (dot (rl n) a + Q2R d) * (dot (rl n) a + Q2R d)) ->
    means Q2R (approach_proves (height n d c) r v n answer kind facts) ->
    first_time_spec (fun t => exists x, length x = 3%nat /\ capsule [rl p; rl q] (Q2R r) x /\
      dot (rl n) (at_time x (rl v) t) + Q2R d = 0) (option_map r_surd answer)).
  { intros c ic e one_side least m. apply approach_means in m.
    assert (ve : value Q2R (height n d c) = e) by (unfold height, e; simpl; rewrite inner_means, !leaves_mean; lra).
    rewrite ve in m. apply (nearest_point_first _ _ _ _ _ (rl c)); auto.
    { apply corner. destruct ic as [-> | ->]; auto. }
    fold e. intros x hx. right. set (a := dot (rl n) (rl p) + Q2R d) in *. set (b := dot (rl n) (rl q) + Q2R d) in *.
    assert (ee : e = a \/ e = b) by (destruct ic as [-> | ->]; auto).
    assert (la := least (rl p) ltac:(auto)). assert (lb := least (rl q) ltac:(auto)). fold a in la. fold b in lb.
    destruct (Rlt_le_dec 0 a) as [sa | sa].
    - assert (sb : 0 < b). { apply Rnot_le_lt; intro z. assert (0 <= a * - b) by (apply Rmult_le_pos; lra). lra. }
      left. split; [destruct ee; lra|]. assert (g : e - Q2R d <= dot (rl n) x); [|lra]. apply above; auto.
      intros c' ic'. assert (l := least c' ic'). apply Rnot_lt_le; intro z.
      assert (0 < dot (rl n) c' + Q2R d) by (destruct ic' as [-> | ->]; auto).
      assert ((dot (rl n) c' + Q2R d) * (dot (rl n) c' + Q2R d) < e * e) by (apply Rmult_le_0_lt_compat; lra). lra.
    - assert (sa' : a < 0). { destruct sa as [sa | sa]; auto. rewrite sa in one_side. lra. }
      assert (sb : b < 0). { apply Rnot_le_lt; intro z. assert (0 <= - a * b) by (apply Rmult_le_pos; lra). lra. }
      right. split; [|destruct ee; lra]. assert (g : dot (rl n) x <= e - Q2R d); [|lra]. apply below; auto.
      intros c' ic'. assert (l := least c' ic'). apply Rnot_lt_le; intro z.
      assert (dot (rl n) c' + Q2R d < 0) by (destruct ic' as [-> | ->]; auto).
      assert (- (dot (rl n) c' + Q2R d) * - (dot (rl n) c' + Q2R d) < - e * - e) by (apply Rmult_le_0_lt_compat; lra).
      lra. }
  assert (vp : value Q2R (height n d p) = dot (rl n) (rl p) + Q2R d)
    by (unfold height; simpl; rewrite inner_means, !leaves_mean; lra).
  assert (vq : value Q2R (height n d q) = dot (rl n) (rl q) + Q2R d)
    by (unfold height; simpl; rewrite inner_means, !leaves_mean; lra).
  destruct h as [[cross m] | [one_side [[near m] | [near m]]]].
  - change (value Q2R (height n d p) * value Q2R (height n d q) <= value Q2R zero) in cross. rewrite vp, vq in cross.
    simpl value in cross.
    destruct (on_both_sides _ _ _ _ lp lq cross) as (x & hx & on). apply approach_means in m.
    apply (nearest_point_first _ _ _ _ _ x); auto; rewrite on; auto.
  - change (0 < value Q2R (height n d p) * value Q2R (height n d q)) in one_side.
    change (value Q2R (height n d p) * value Q2R (height n d p) <= value Q2R (height n d q) * value Q2R (height n d q))
      in near. rewrite vp, vq in *. apply (end_first p); auto. intros a [-> | ->]; lra.
  - change (0 < value Q2R (height n d p) * value Q2R (height n d q)) in one_side.
    change (value Q2R (height n d q) * value Q2R (height n d q) <= value Q2R (height n d p) * value Q2R (height n d p))
      in near. rewrite vp, vq in *. apply (end_first q); auto. intros a [-> | ->]; lra.
Qed.
Theorem swept_capsule_plane_unique : forall p r v n d x y, swept_capsule_plane_spec p r v n d x ->
  swept_capsule_plane_spec p r v n d y -> x = y.
Proof. intros p r v n d x y (_ & _ & _ & _ & g) (_ & _ & _ & _ & h). apply (first_time_unique _ _ _ g h). Qed.
