(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of discs, half-spaces and slabs are enough. *)
Require Import Reals Qreals QArith Lra Lia List Arith Bool.
From Certificates Require Import solids language formulas_vectors formulas_solids formulas_slabs sound_solids
  sound_vectors.
Import ListNotations.
Open Scope R_scope.

Theorem implicit_circle_sound : forall c r p w distance radius,
  decide (check_implicit_circle c r p w distance radius) = true -> implicit_circle_spec (rl c) (Q2R r) (rl p) w.
Proof.
  intros c r p w distance radius h. apply decide_means in h. unfold check_implicit_circle in h. simpl in h.
  rewrite !of_length_means, squared_distance_means in h. destruct h as (lc & lp & hr & ed & er & h).
  assert (lc' := rl_length c). assert (lp' := rl_length p). rewrite lc in lc'. rewrite lp in lp'.
  split; [split; auto|]. split; [auto|].
  destruct w; simpl in h; rewrite ed, er in h.
  - apply inside_ball; auto.
  - split; [unfold ball; lra|]. intro i. apply interior_ball in i; auto; lra.
  - unfold ball; lra.
Qed.

Lemma height_means : forall n d x, value Q2R (height n d x) = dot (rl n) (rl x) + Q2R d.
Proof. intros; unfold height; simpl. rewrite inner_means, !leaves_mean; auto. Qed.

(** The point of a half-space that is nearest to c: the normal leads from it to c, or it is c. *)
Lemma nearest_of_half_space : forall n N d c x y, length N = n -> length c = n -> length x = n -> length y = n ->
  nonzero N -> dot N x + d <= 0 -> 0 <= dot N (minus c x) -> dot N (minus c x) * (dot N x + d) = 0 ->
  dot N (minus c x) * dot N (minus c x) = dot (minus c x) (minus c x) * dot N N ->
  half_space N d y -> sqdist c x <= sqdist c y.
Proof.
  intros n N d c x y lN lc lx ly nz hx ha hz hp hy. unfold half_space in hy.
  apply nearest_by_angle; try congruence. apply dot_nonzero in nz.
  assert (lm : length (minus c x) = n) by (rewrite minus_length; congruence).
  assert (ly' : length (minus y x) = n) by (rewrite minus_length; congruence).
  set (v := minus c x) in *. set (a := dot N v) in *.
  assert (l : length (times (dot N N) v) = length (times a N)) by (rewrite !times_length; congruence).
  assert (z : dot (minus (times (dot N N) v) (times a N)) (minus (times (dot N N) v) (times a N)) = 0).
  { rewrite square_of_difference, !times_dot, !dot_times, (dot_sym v N) by auto. fold a.
    transitivity (dot N N * (dot v v * dot N N - a * a)); [ring | rewrite <- hp; ring]. }
  assert (e : dot (minus y x) (minus (times (dot N N) v) (times a N)) = 0).
  { assert (lk : length (minus y x) = length (minus (times (dot N N) v) (times a N))).
    { rewrite (minus_length (times (dot N N) v)), times_length; congruence. }
    assert (k := cauchy _ _ lk). rewrite z in k.
    assert (g := square (dot (minus y x) (minus (times (dot N N) v) (times a N)))).
    assert (q : dot (minus y x) (minus (times (dot N N) v) (times a N)) * dot (minus y x) (minus (times (dot N N) v)
      (times a N)) = 0) by lra.
    destruct (Rmult_integral _ _ q); auto. }
  rewrite dot_minus, !dot_times in e by auto. rewrite (dot_sym (minus y x) v), (dot_sym (minus y x) N),
    (dot_minus N) in e by congruence.
  assert (le : a * (dot N y - dot N x) <= 0).
  { destruct (Req_dec a 0) as [za | na]; [rewrite za; lra|].
    assert (t : dot N x + d = 0) by (destruct (Rmult_integral _ _ hz); [tauto | auto]).
    assert (0 <= a * - (dot N y - dot N x)) by (apply Rmult_le_pos; lra). lra. }
  apply Rnot_lt_le; intro p. assert (0 < dot N N * dot v (minus y x)) by (apply Rmult_lt_0_compat; auto). lra.
Qed.

Theorem sphere_plane_sound : forall c r n d w facts, decide (check_sphere_plane c r n d w facts) = true ->
  sphere_plane_spec (rl c) (Q2R r) (rl n) (Q2R d) w.
Proof.
  intros c r n d w facts h. apply decide_means in h. unfold check_sphere_plane in h. cbv zeta in h.
  destruct h as (lc & ln & hr & nz & h). rewrite of_length_means in lc, ln. apply not_zero_means in nz. simpl in hr.
  assert (lc' := rl_length c). assert (ln' := rl_length n). rewrite lc in lc'. rewrite ln in ln'.
  split; [split; auto|]. do 2 (split; [auto|]).
  destruct w, facts; simpl in h; try tauto; rewrite of_length_means in h;
    rewrite ?inner_means, ?difference_means, ?leaves_mean, ?squared_distance_means in h;
    assert (lx := rl_length x).
  - destruct h as (l & (h1 & h2 & h3 & h4) & far). rewrite l in lx. intros y ly [b s]. unfold ball in b.
    assert (g := nearest_of_half_space 3 (rl n) (Q2R d) (rl c) (rl x) y ln' lc' lx ly nz h1 h2 h3 h4 s). lra.
  - destruct h as (l & (h1 & h2 & h3 & h4) & e). rewrite l in lx. split.
    + exists (rl x). unfold ball, half_space. split; [auto|]. lra.
    + intros y [b s]. assert (ly := proj1 b). apply interior_in in s.
      apply interior_ball in b; auto.
      assert (g := nearest_of_half_space 3 (rl n) (Q2R d) (rl c) (rl x) y ln' lc' lx ly nz h1 h2 h3 h4 s). lra.
  - destruct h as (l & h1 & h2). rewrite l in lx. exists (rl x).
    split; [apply inside_ball; auto | apply interior_half_space; auto].
Qed.

Lemma lowest : forall n low high x y, length x = length n -> length y = length n ->
  (forall k, (k < length n)%nat -> nth k low 0 <= nth k y 0 <= nth k high 0) ->
  (forall k, (k < length n)%nat -> (nth k n 0 <= 0 \/ nth k x 0 = nth k low 0) /\
    (0 <= nth k n 0 \/ nth k x 0 = nth k high 0)) ->
  dot n x <= dot n y.
Proof.
  induction n as [|c n IH]; intros low high [|a x] [|b y] lx ly hb hl; simpl in *; try discriminate; try lra.
  assert (g : dot n x <= dot n y).
  { apply (IH (tl low) (tl high)); try lia; intros k hk; [specialize (hb (S k) ltac:(lia)) | specialize (hl (S k)
      ltac:(lia))];
      simpl in *; destruct low, high; simpl in *; destruct k; auto. }
  specialize (hb O ltac:(lia)). specialize (hl O ltac:(lia)). simpl in hb, hl.
  destruct (Rlt_le_dec c 0) as [s | s].
  - destruct hl as [_ [hl | hl]]; [lra|]. assert (0 <= - c * (a - b)) by (apply Rmult_le_pos; lra). lra.
  - destruct (Req_dec c 0) as [-> | ne]; [lra|]. destruct hl as [[hl | hl] _]; [lra|].
    assert (0 <= c * (b - a)) by (apply Rmult_le_pos; lra). lra.
Qed.

Theorem aabb_plane_sound : forall low high n d w facts, decide (check_aabb_plane low high n d w facts) = true ->
  aabb_plane_spec (rl low) (rl high) (rl n) (Q2R d) w.
Proof.
  intros low high n d w facts h. apply decide_means in h. unfold check_aabb_plane in h. cbv zeta in h.
  destruct h as (ll & lh & ln & nz & v & h). rewrite of_length_means in ll, lh, ln. apply not_zero_means in nz.
  assert (ln' := rl_length n). rewrite ln in ln'.
  unfold aabb_plane_spec, proper_box. rewrite !rl_length. split; [|do 2 (split; [auto|])].
  { do 3 (split; [auto|]). intros k hk. rewrite on_each_means in v. specialize (v k hk). simpl in v.
    rewrite !coordinate_means in v. auto. }
  assert (low_means : forall x y, length x = 3%nat -> length y = 3%nat -> box (rl low) (rl high) y ->
    means Q2R (on_each 3 (fun k => (coordinate k n <= zero \/ coordinate k x = coordinate k low) /\
                                   (zero <= coordinate k n \/ coordinate k x = coordinate k high))%check) ->
    dot (rl n) (rl x) <= dot (rl n) y).
  { intros x y lx ly b m. apply (lowest (rl n) (rl low) (rl high)); rewrite ?rl_length, ?ln; auto.
    - intros k hk. apply b. lia.
    - intros k hk. rewrite on_each_means in m. specialize (m k hk). simpl in m. rewrite !coordinate_means in m. auto. }
  destruct w, facts; try (simpl in h; tauto).
  - destruct h as (l & b & m & far). rewrite of_length_means in l. simpl in far.
      rewrite inner_means, !leaves_mean in far.
    intros y ly [b' s]. assert (g := low_means x y l ly b' m). unfold half_space in s. lra.
  - destruct h as (l & b & m & e). rewrite of_length_means in l. simpl in e. rewrite inner_means, !leaves_mean in e.
    apply box_means in b; auto. split.
    + exists (rl x). rewrite rl_length. unfold half_space. split; [auto | split; [auto | lra]].
    + intros y [b' s]. assert (ly := proj1 s). apply interior_in in b'. assert (g := low_means x y l ly b' m).
      apply half_space_interior in s; auto. lra.
  - destruct h as (l & b & hh & k & e). rewrite of_length_means in l. simpl in hh, e.
      rewrite inner_means, !leaves_mean in hh.
    rewrite if_so_means, Nat.ltb_lt in k. rewrite !coordinate_means in e. apply box_means in b; auto. split.
    + exists (rl x). rewrite rl_length. auto.
    + intros y [b' _]. assert (B := interior_box _ _ _ _ _ b' k). lra.
  - destruct h as (l & b & hh). rewrite of_length_means in l. simpl in hh. rewrite inner_means, !leaves_mean in hh.
    exists (rl x). split; [apply inside_means; auto | apply interior_half_space; auto]. rewrite rl_length; auto.
Qed.

Definition r_slab (s : slab Q) : slab R := (rl (fst s), (Q2R (fst (snd s)), Q2R (snd (snd s)))).
Lemma slab_value_means : forall s x, value Q2R (slab_value s x) = dot (rl (fst s)) (rl x).
Proof. intros; unfold slab_value. rewrite inner_means, !leaves_mean; auto. Qed.
Lemma right_slabs_mean : forall l, means Q2R (right_slabs l) ->
  map r_slab l <> nil /\ forall s, In s (map r_slab l) -> proper_slab s.
Proof.
  intros l [h k]. rewrite if_so_means, negb_true_iff, Nat.eqb_neq in h. rewrite all_means in k. split.
  - destruct l; simpl in *; [tauto | discriminate].
  - intros s i. apply in_map_iff in i. destruct i as [t [<- i]]. destruct (k t i) as (a & b & c).
    rewrite of_length_means in a. unfold proper_slab, r_slab. rewrite rl_length. split; [auto|]. split;
      [apply not_zero_means; auto | auto].
Qed.
Lemma at_index_means : forall {B} k (l : list B) f, means Q2R (at_index k l f) -> exists s, In s l /\ means Q2R (f s).
Proof.
  unfold at_index; intros B k l f h. destruct (nth_error l k) eqn:e; simpl in h; [|tauto].
  exists b; split; auto. eapply nth_error_In; eauto.
Qed.

(** A slab is what two half-spaces have in common. *)
Lemma slab_interior : forall s x, length (fst s) = 3%nat -> length x = 3%nat ->
  fst (snd s) < dot (fst s) x < snd (snd s) -> interior 3 (in_slab s) x.
Proof.
  intros [n [low high]] x ln lx h; simpl in *.
  apply (interior_subset 3 (fun y => half_space n (- high) y /\ half_space (times (-1) n) low y)).
  - intros y _ [a b]. unfold half_space in a, b. rewrite times_dot in b. simpl. lra.
  - apply interior_both; apply interior_half_space; rewrite ?times_length; auto; [lra|].
    rewrite times_dot. lra.
Qed.
Lemma interior_slab : forall s x, proper_slab s -> interior 3 (in_slab s) x ->
  fst (snd s) < dot (fst s) x < snd (snd s).
Proof.
  intros [n [low high]] x (ln & nz & lh) h; simpl in *. split.
  - assert (g : interior 3 (half_space (times (-1) n) low) x).
    { apply (interior_subset 3 (in_slab (n, (low, high)))); auto. intros y _ [a b]. unfold half_space.
        rewrite times_dot. lra. }
    apply half_space_interior in g.
    + rewrite times_dot in g. lra.
    + rewrite times_length; auto.
    + destruct nz as [a [i na]]. exists (-1 * a). split; [apply in_map; auto | lra].
  - assert (g : interior 3 (half_space n (- high)) x).
    { apply (interior_subset 3 (in_slab (n, (low, high)))); auto. intros y _ [a b]. unfold half_space. lra. }
    apply half_space_interior in g; auto. lra.
Qed.

Theorem point_in_kdop_sound : forall slabs p w facts, decide (check_point_in_kdop slabs p w facts) = true ->
  point_in_kdop_spec (map r_slab slabs) (rl p) w.
Proof.
  intros slabs p w facts h. apply decide_means in h. unfold check_point_in_kdop in h. cbv zeta in h.
  destruct h as (right & lp & h). rewrite of_length_means in lp. apply right_slabs_mean in right.
    destruct right as [some right].
  assert (lp' := rl_length p). rewrite lp in lp'. split; [auto|]. split; [auto|]. split; [auto|].
  destruct w, facts; try (simpl in h; tauto).
  - destruct h as [_ h]. rewrite all_means in h. unfold kdop.
    apply (interior_each (B := slab R) 3 in_slab); auto. intros s i. assert (k := right s i).
    apply in_map_iff in i. destruct i as [t [<- i]]. specialize (h t i). simpl in h. rewrite slab_value_means in h.
    destruct k as (l & _). apply slab_interior; auto.
  - destruct h as [e h]. rewrite all_means in h. split.
    + intros s i. apply in_map_iff in i. destruct i as [t [<- i]]. specialize (h t i). simpl in h.
        rewrite slab_value_means in h. auto.
    + intro ki. apply at_index_means in e. destruct e as [s [i e]]. simpl in e. rewrite slab_value_means in e.
      assert (j : interior 3 (in_slab (r_slab s)) (rl p)).
      { apply (interior_subset 3 (kdop (map r_slab slabs))); auto. intros y _ g. apply g, in_map; auto. }
      apply interior_slab in j; [|apply right, in_map; auto]. simpl in j. lra.
  - apply at_index_means in h. destruct h as [s [i e]]. simpl in e. rewrite slab_value_means in e.
    intro held. assert (j := held (r_slab s) (in_map _ _ _ i)). simpl in j. lra.
Qed.

Lemma combine_map : forall a b, combine (map r_slab a) (map r_slab b) = map (fun p => (r_slab (fst p),
  r_slab (snd p))) (combine a b).
Proof. induction a as [|s a IH]; intros [|t b]; simpl; auto. rewrite IH; auto. Qed.
Lemma with_each : forall {B D} (v : list B) (l : list D) x, length v = length l -> In x l -> exists y, In (y,
  x) (combine v l).
Proof.
  induction v as [|y v IH]; intros [|z l] x e i; simpl in *; try tauto; try discriminate.
  destruct i as [-> | i]; [exists y; auto|]. destruct (IH l x) as [u hu]; auto. exists u; auto.
Qed.

Theorem kdop_kdop_sound : forall a b w facts, decide (check_kdop_kdop a b w facts) = true ->
  kdop_kdop_spec (map r_slab a) (map r_slab b) w.
Proof.
  intros a b w facts h. apply decide_means in h. unfold check_kdop_kdop in h. cbv zeta in h.
  destruct h as (ra & rb & lab & same & h). rewrite if_so_means, Nat.eqb_eq in lab. rewrite all_means in same.
  apply right_slabs_mean in ra, rb. split; [tauto|]. split; [intros s [i | i]; [apply ra | apply rb]; auto|]. split.
  { clear - lab same. revert b lab same. induction a as [|s a IH]; intros [|t b] l same; simpl in *;
      try discriminate; auto.
    rewrite (IH b); auto. f_equal. specialize (same (s, t) (or_introl eq_refl)). simpl in same.
    apply same_vector_means in same. rewrite !leaves_mean in same. auto. }
  assert (each : forall s t, In (s, t) (combine (map r_slab a) (map r_slab b)) -> exists p, In p (combine a b) /\
    s = r_slab (fst p) /\ t = r_slab (snd p)).
  { intros s t i. rewrite combine_map in i. apply in_map_iff in i. destruct i as [p [e i]]. injection e;
      intros <- <-. exists p; auto. }
  assert (some : forall p, In p (combine a b) -> In (r_slab (fst p),
    r_slab (snd p)) (combine (map r_slab a) (map r_slab b))).
  { intros p i. rewrite combine_map. apply (in_map (fun p => (r_slab (fst p), r_slab (snd p)))); auto. }
  cbv zeta. destruct w, facts; try (simpl in h; tauto).
  - apply at_index_means in h. destruct h as [p [i e]]. exists (r_slab (fst p)), (r_slab (snd p)).
    split; [apply some; auto|]. intros u [c d]. simpl in *. lra.
  - destruct h as [[l h] e]. rewrite if_so_means, Nat.eqb_eq in l. rewrite all_means in h. split.
    + intros s t i. destruct (each s t i) as (p & ip & -> & ->). destruct (with_each _ _ _ l ip) as [x ix].
      specialize (h _ ix). destruct p as [s t]. simpl in h. exists (Q2R x). unfold shared; simpl. tauto.
    + apply at_index_means in e. destruct e as [[s t] [i e]]. exists (r_slab s), (r_slab t).
      split; [apply (some (s, t)); auto|]. unfold shared; simpl in *. intros; lra.
  - destruct h as [l h]. rewrite if_so_means, Nat.eqb_eq in l. rewrite all_means in h. intros s t i.
    destruct (each s t i) as (p & ip & -> & ->). destruct (with_each _ _ _ l ip) as [x ix]. specialize (h _ ix).
    destruct p as [s t]. simpl in h. exists (Q2R x), (Rmin (Q2R (snd (snd s))) (Q2R (snd (snd t)))). unfold shared;
      simpl.
    assert (m1 := Rmin_l (Q2R (snd (snd s))) (Q2R (snd (snd t)))).
      assert (m2 := Rmin_r (Q2R (snd (snd s))) (Q2R (snd (snd t)))).
    assert (Q2R x < Rmin (Q2R (snd (snd s))) (Q2R (snd (snd t)))) by (apply Rmin_glb_lt; tauto). lra.
Qed.

Theorem closest_point_on_aabb_sound : forall p low high x lower upper,
  decide (check_closest_point_on_aabb p low high x lower upper) = true ->
  closest_point_on_aabb_spec (rl p) (rl low) (rl high) (rl x).
Proof.
  intros p low high x lower upper h. apply decide_means in h. unfold check_closest_point_on_aabb, as_long in h.
    cbv zeta in h.
  simpl in h. rewrite !if_so_means, !Nat.eqb_eq in h. destruct h as (n & l1 & l2 & lx & _ & _ & v & b & m).
  apply two_or_three_means in n. exists (length p). unfold proper_box. rewrite !rl_length.
  split; [|do 2 (split; [auto|])].
  { do 3 (split; [auto|]). intros k hk. rewrite on_each_means in v. specialize (v k hk). simpl in v.
    rewrite !coordinate_means in v. auto. }
  apply box_means in b; auto. split; auto. intros y ly by_.
  apply nearest; rewrite ?rl_length; auto. intros k hk. rewrite on_each_means in m. specialize (m k hk). simpl in m.
  rewrite !coordinate_means in m. assert (bk := by_ k ltac:(lia)).
  set (P := nth k (rl p) 0) in *; set (X := nth k (rl x) 0) in *; set (Y := nth k y 0) in *.
  set (L := nth k (rl low) 0) in *; set (H := nth k (rl high) 0) in *; set (a := nth k (rl lower) 0) in *;
    set (u := nth k (rl upper) 0) in *.
  destruct m as (ha & hu & ea & eu & e).
  assert (0 <= a * (Y - X)) by (destruct ea as [-> | ->]; [lra | apply Rmult_le_pos; lra]).
  assert (0 <= u * (X - Y)) by (destruct eu as [-> | ->]; [lra | apply Rmult_le_pos; lra]).
  assert (g := square (Y - X)).
  replace ((P - Y) * (P - Y)) with ((P - X) * (P - X) + (Y - X) * (Y - X) + 2 * ((X - P) * (Y - X))) by ring.
  rewrite e. lra.
Qed.
