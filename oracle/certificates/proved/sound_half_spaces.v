(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of oriented boxes and capsules over planes are enough, and their specifications leave no choice. *)
Require Import Reals Qreals QArith Lra Lia List Arith Bool.
From Certificates Require Import solids hulls language formulas_vectors formulas_solids formulas_slabs formulas_nearest
  formulas_obbs formulas_half_spaces sound_solids sound_vectors sound_slabs sound_nearest sound_capsules sound_obbs
  unique_solids unique_slabs.
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
