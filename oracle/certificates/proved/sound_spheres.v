(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of balls around points are enough, and their specification leaves no choice. *)
Require Import Reals Qreals QArith Lra Lia List Arith Bool.
From Certificates Require Import motion hulls solids language formulas_vectors formulas_solids formulas_slabs
  formulas_bounds formulas_nearest formulas_motion formulas_spheres sound_solids sound_vectors sound_slabs unique_slabs
  sound_nearest sound_motion sound_bounds.
Import ListNotations.
Open Scope R_scope.

(** ** The smallest ball *)
Lemma squares_ordered : forall r s, 0 <= r -> 0 <= s -> r * r <= s * s -> r <= s.
Proof.
  intros r s hr hs h. apply Rnot_lt_le. intro l. assert (s * s < r * r) by (apply Rmult_le_0_lt_compat; lra). lra.
Qed.
(** From any other center, one of the points on the boundary, among which the center is, is farther. *)
Lemma balanced_is_smallest : forall support c r d s, (forall p, In p support -> length p = 3%nat) -> length d = 3%nat ->
  0 <= r -> 0 <= s -> hull 3 support c -> (forall p, In p support -> sqdist c p = r * r) ->
  (forall p, In p support -> sqdist d p <= s * s) -> r <= s.
Proof.
  intros support c r d s lp ld hr hs hc on within. apply squares_ordered; auto.
  assert (lc := hull_length _ _ _ lp hc).
  assert (g := hull_above 3 support (minus d c) ((dot d d - dot c c + (r * r - s * s)) / 2) c lp hc).
  assert (h := g ltac:(intros p i; specialize (on p i); specialize (within p i); specialize (lp p i);
    rewrite sqdist_dot, square_of_difference in on, within by congruence; rewrite minus_dot by congruence; lra)).
  rewrite minus_dot in h by congruence. assert (k := dot_self (minus d c)).
  rewrite square_of_difference in k by congruence. lra.
Qed.
Definition holds (points : list (list R)) (d : list R) (s : R) : Prop :=
  proper_ball 3 d s /\ forall p, In p points -> ball d s p.
(** Of two centers, the middle needs less than both. *)
Lemma smallest_center : forall points c r d, points <> nil -> (forall p, In p points -> length p = 3%nat) ->
  holds points c r -> holds points d r -> (forall x s, holds points x s -> r <= s) -> c = d.
Proof.
  intros points c r d some lp [(_ & lc & hr) hc] [(_ & ld & _) hd] least.
  apply sqdist_zero; [congruence|]. apply Rnot_lt_le. intro l.
  set (q := r * r - sqdist c d / 4).
  assert (below : forall p, In p points -> sqdist (middle c d) p <= q).
  { intros p i. specialize (lp p i). specialize (hc p i). specialize (hd p i). unfold ball in hc, hd.
    assert (m := middle_nearer p c d ltac:(congruence) ltac:(congruence)).
    rewrite (sqdist_sym c p) in hc. rewrite (sqdist_sym d p) in hd. rewrite sqdist_sym. unfold q. lra. }
  destruct points as [|p points]; [tauto|].
  assert (q0 : 0 <= q).
  { assert (a := below p ltac:(simpl; auto)). assert (b := sqdist_nonneg (middle c d) p). lra. }
  assert (root := sqrt_def q q0). assert (root0 := sqrt_pos q).
  assert (h : r <= sqrt q).
  { apply (least (middle c d)). split.
    - split; [auto|]. split; [rewrite middle_length; congruence | auto].
    - intros x i. unfold ball. rewrite root. auto. }
  assert (r * r <= q) by (rewrite <- root; apply Rmult_le_compat; auto). unfold q in *. lra.
Qed.

(** ** What the formulas mean *)
Lemma greatest_means : forall l, l <> nil ->
  In (value Q2R (greatest l)) (values l) /\ forall v, In v (values l) -> v <= value Q2R (greatest l).
Proof.
  induction l as [|t [|u l] IH]; intro some; [tauto | |].
  - simpl. split; [auto|]. intros v [<- | []]. lra.
  - destruct (IH ltac:(discriminate)) as [a b]. change (value Q2R (greatest (t :: u :: l))) with
      (Rmax (value Q2R t) (value Q2R (greatest (u :: l)))).
    change (values (t :: u :: l)) with (value Q2R t :: values (u :: l)). split.
    + unfold Rmax. destruct (Rle_dec (value Q2R t) (value Q2R (greatest (u :: l)))); [right | left]; auto.
    + intros v [<- | i]; [apply Rmax_l|]. eapply Rle_trans; [apply b; auto | apply Rmax_r].
Qed.
Lemma coordinates_mean : forall points k, values (map (coordinate k) points) = map (fun p => nth k p 0) (map rl points).
Proof. intros. unfold values. rewrite !map_map. apply map_ext. intro p. apply coordinate_means. Qed.
Lemma box_middle : forall points c, points <> nil -> (forall p, In p (map rl points) -> length p = 3%nat) ->
  length (rl c) = 3%nat ->
  means Q2R (on_each 3 (fun axis => Num 2 * coordinate axis c =
    greatest (map (coordinate axis) points) - greatest (map (fun p => zero - coordinate axis p) points))%check) ->
  exists low high, aabb_of_points_spec (map rl points) low high /\ rl c = times (1 / 2) (plus low high).
Proof.
  intros points c some lp lc h. rewrite on_each_means in h.
  set (up := fun k => value Q2R (greatest (map (coordinate k) points))).
  set (down := fun k => - value Q2R (greatest (map (fun p => zero - coordinate k p)%check points))).
  assert (some' : forall B (f : list Q -> B), map f points <> nil)
    by (intros B f; destruct points; [tauto | discriminate]).
  exists [down 0%nat; down 1%nat; down 2%nat], [up 0%nat; up 1%nat; up 2%nat]. split.
  - exists 3%nat. split; [auto|]. split; [auto|]. split; [auto|]. split; [exact lp|]. intros k hk.
    assert (u := greatest_means (map (coordinate k) points) (some' _ _)).
    assert (d := greatest_means (map (fun p => zero - coordinate k p)%check points) (some' _ _)).
    rewrite coordinates_mean in u.
    assert (opposite : values (map (fun p => zero - coordinate k p)%check points) =
      map Ropp (map (fun p => nth k p 0) (map rl points))).
    { rewrite <- coordinates_mean. unfold values. rewrite !map_map. apply map_ext. intro p. apply Rminus_0_l. }
    rewrite opposite in d. destruct d as [d0 d1].
    assert (ends : least_interval (map (fun p => nth k p 0) (map rl points)) (down k) (up k)).
    { split; [|split].
      - apply in_map_iff in d0. destruct d0 as (x & e & i). unfold down. rewrite <- e, Ropp_involutive. exact i.
      - apply u.
      - intros v i. split; [|apply u; auto]. assert (a := d1 (- v) ltac:(apply in_map; auto)). unfold down. lra. }
    destruct k as [|[|[|k]]]; [exact ends | exact ends | exact ends | lia].
  - apply same_coordinates; [rewrite lc; reflexivity|]. intros k hk.
    change (length (times (1 / 2) (plus [down 0%nat; down 1%nat; down 2%nat] [up 0%nat; up 1%nat; up 2%nat])))
      with 3%nat in hk.
    assert (e := h k hk). simpl in e. rewrite coordinate_means in e.
    assert (e' : nth k (rl c) 0 = 1 / 2 * (down k + up k)) by (unfold down, up; lra).
    destruct k as [|[|[|k]]]; [exact e' | exact e' | exact e' | lia].
Qed.
Lemma total_coordinate : forall points k, (forall p, In p points -> length p = 3%nat) -> (k < 3)%nat ->
  length (fold_right plus (repeat 0 3) points) = 3%nat /\
  nth k (fold_right plus (repeat 0 3) points) 0 = fold_right Rplus 0 (map (fun p => nth k p 0) points).
Proof.
  intros points k lp hk. induction points as [|p points IH].
  - split; [reflexivity|]. destruct k as [|[|[|k]]]; auto; lia.
  - destruct (IH ltac:(intros; apply lp; simpl; auto)) as [l e]. assert (lq := lp p ltac:(simpl; auto)).
    cbn [fold_right map]. split; [rewrite plus_length; congruence|]. rewrite <- e. clear e IH lp.
    revert l. generalize (fold_right plus (repeat 0 3) points). intros x l.
    destruct p as [|p0 [|p1 [|p2 [|]]]]; try discriminate. destruct x as [|x0 [|x1 [|x2 [|]]]]; try discriminate.
    destruct k as [|[|[|k]]]; auto; lia.
Qed.
Lemma nth_times : forall t x k, nth k (times t x) 0 = t * nth k x 0.
Proof. unfold times. induction x as [|a x IH]; intros [|k]; simpl; auto; ring. Qed.
Lemma sum_means_all : forall l, value Q2R (fold_right Add zero l) = fold_right Rplus 0 (values l).
Proof. induction l as [|t l IH]; simpl; auto. rewrite IH; auto. Qed.
Lemma mean_of_points : forall points c, points <> nil -> (forall p, In p (map rl points) -> length p = 3%nat) ->
  length (rl c) = 3%nat ->
  means Q2R (on_each 3 (fun axis => Num (Z.of_nat (length points)) * coordinate axis c =
    fold_right Add zero (map (coordinate axis) points))%check) ->
  rl c = times (1 / INR (length (map rl points))) (fold_right plus (repeat 0 3) (map rl points)).
Proof.
  intros points c some lp lc h. rewrite on_each_means in h.
  assert (n0 : INR (length points) <> 0) by (apply not_0_INR; destruct points; [tauto | discriminate]).
  destruct (total_coordinate (map rl points) 0 lp ltac:(lia)) as [len _].
  apply same_coordinates; [rewrite times_length; congruence|]. intros k hk. rewrite times_length, len in hk.
  assert (e := h k hk). simpl in e. rewrite coordinate_means, sum_means_all, coordinates_mean in e.
  rewrite <- INR_IZR_INZ in e. destruct (total_coordinate (map rl points) k lp hk) as [_ f]. rewrite <- f in e.
  rewrite map_length, nth_times, <- e. field. auto.
Qed.

Theorem bounding_sphere_sound : forall points method c radius facts,
  decide (check_bounding_sphere points method c radius facts) = true ->
  bounding_sphere_spec (map rl points) method (rl c) (r_surd radius).
Proof.
  intros points method c [x y k] facts h. apply decide_means in h. unfold check_bounding_sphere in h. cbv zeta in h.
  destruct h as (some & lp & lc & hk & hr & inside & h). rewrite if_so_means, negb_true_iff, Nat.eqb_neq in some.
  rewrite all_means in lp. rewrite all_means in inside. rewrite of_length_means in lc. simpl in hk.
  apply not_negative_means in hr; [|exact hk].
  simpl in hr. set (r := r_surd (Surd x y k)).
  assert (er : r = Q2R x + Q2R y * sqrt (Q2R k)) by reflexivity. rewrite <- er in hr.
  assert (root := sqrt_def (Q2R k) hk).
  assert (square_r : r * r = Q2R x * Q2R x + Q2R y * Q2R y * Q2R k + 2 * Q2R x * Q2R y * sqrt (Q2R k)).
  { transitivity (Q2R x * Q2R x + Q2R y * Q2R y * (sqrt (Q2R k) * sqrt (Q2R k)) + 2 * Q2R x * Q2R y * sqrt (Q2R k));
      [rewrite er; ring | rewrite root; ring]. }
  assert (some' : points <> nil) by (destruct points; [simpl in some; tauto | discriminate]).
  assert (some'' : map rl points <> nil) by (destruct points; [tauto | discriminate]).
  assert (lp' : forall p, In p (map rl points) -> length p = 3%nat).
  { intros p i. apply in_map_iff in i. destruct i as (q & <- & i). specialize (lp q i). rewrite of_length_means in lp.
    rewrite rl_length; auto. }
  assert (lc' : length (rl c) = 3%nat) by (rewrite rl_length; auto).
  assert (proper : proper_ball 3 (rl c) r) by (split; [auto | split; auto]).
  assert (in_it : forall p, In p (map rl points) -> ball (rl c) r p).
  { intros p i. apply in_map_iff in i. destruct i as (q & <- & i). specialize (inside q i).
    cbv beta in inside. apply not_positive_means in inside; [|exact hk]. simpl in inside.
    rewrite squared_distance_means in inside.
    unfold ball. rewrite square_r. lra. }
  assert (ends : forall q, means Q2R (is_zero
    (squared_distance c q - (Leaf x * Leaf x + Leaf y * Leaf y * Leaf k))%check
    (zero - Num 2 * Leaf x * Leaf y)%check (Leaf k)) -> sqdist (rl c) (rl q) = r * r).
  { intros q z. apply is_zero_means in z; [|exact hk]. simpl in z. rewrite squared_distance_means in z.
    rewrite square_r. lra. }
  assert (reaches : forall q, In q points -> sqdist (rl c) (rl q) = r * r ->
    forall s, holds (map rl points) (rl c) s -> r <= s).
  { intros q i e s [(_ & _ & hs) g]. apply squares_ordered; auto. rewrite <- e. apply (g (rl q)). apply in_map; auto. }
  unfold bounding_sphere_spec. cbv zeta. split; [exact some''|]. split; [exact lp'|].
  split; [split; [exact proper | exact in_it]|].
  destruct method, facts as [place | places weights]; try solve [destruct h].
  - destruct h as [at_place h]. apply at_index_means in at_place. destruct at_place as (q & i & z). apply ends in z.
    split; [apply (reaches q); auto|]. apply box_middle; auto.
  - destruct h as [at_place h]. apply at_index_means in at_place. destruct at_place as (q & i & z). apply ends in z.
    split; [apply (reaches q); auto|]. apply mean_of_points; auto.
  - destruct h as (hp & hw & ec & on). rewrite all_means in on. assert (from := chosen_means _ _ hp).
    apply (weights_mean 3) in hw. rewrite same_vector_means, leaves_mean, mixed_means in ec. rewrite <- ec in hw.
    assert (least : forall d s, holds (map rl points) d s -> r <= s).
    { intros d s [(_ & ld & hs) g].
      apply (balanced_is_smallest (map rl (chosen_from points places)) (rl c) r d s); auto.
      - intros p i. apply in_map_iff in i. destruct i as (q & <- & i). apply lp'. apply in_map; auto.
      - intros p i. apply in_map_iff in i. destruct i as (q & <- & i). apply ends, on; auto.
      - intros p i. apply in_map_iff in i. destruct i as (q & <- & i). apply g. apply in_map; auto. }
    split; [apply least | exact least].
Qed.
Theorem bounding_sphere_unique : forall points method c r d s,
  bounding_sphere_spec points method c r -> bounding_sphere_spec points method d s -> c = d /\ r = s.
Proof.
  intros points method c r d s (some & lp & hc & lc & g) (_ & _ & hd & ld & h).
  assert (same : c = d -> c = d /\ r = s).
  { intros <-. split; auto. assert (a := lc s hd). assert (b := ld r hc). lra. }
  destruct method.
  - apply same. destruct g as (l & u & a & ->), h as (l' & u' & b & ->).
    destruct (aabb_of_points_unique _ _ _ _ _ a b) as [-> ->]. auto.
  - apply same. rewrite g, h. auto.
  - assert (e : r = s) by (assert (a := g d s hd); assert (b := h c r hc); lra). subst s. split; auto.
    apply (smallest_center points c r d some lp hc hd g).
Qed.
