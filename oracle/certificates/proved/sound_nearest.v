(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of nearest points are enough, and their specifications leave no choice. *)
Require Import Reals Qreals QArith Lra Lia List Arith Bool.
From Certificates Require Import solids hulls language formulas_vectors formulas_solids formulas_nearest sound_solids
  sound_vectors unique_slabs.
Import ListNotations.
Open Scope R_scope.

(** ** What is between points *)
Lemma dot_zeros : forall v n, dot v (repeat 0 n) = 0.
Proof. induction v as [|a v IH]; intros [|n]; simpl; auto. rewrite IH; ring. Qed.
Lemma combined_length : forall n l w, (forall p, In p l -> length p = n) -> length (combined n w l) = n.
Proof.
  induction l as [|p l IH]; intros [|a w] h; simpl; try apply repeat_length.
  assert (e := IH w ltac:(intros; apply h; simpl; auto)).
  rewrite plus_length; auto. rewrite times_length, e. apply h; simpl; auto.
Qed.
Lemma hull_length : forall n l x, (forall p, In p l -> length p = n) -> hull n l x -> length x = n.
Proof. intros n l x h (w & _ & _ & _ & ->). apply combined_length; auto. Qed.
Lemma dot_combined : forall n v w p a l, (forall q, In q (p :: l) -> length q = n) ->
  dot v (combined n (a :: w) (p :: l)) = a * dot v p + dot v (combined n w l).
Proof.
  intros n v w p a l h. simpl. rewrite dot_plus, dot_times; auto.
  rewrite times_length, combined_length; [apply h; simpl; auto | intros; apply h; simpl; auto].
Qed.
Lemma hull_above : forall n l v c x, (forall p, In p l -> length p = n) -> hull n l x ->
  (forall p, In p l -> c <= dot v p) -> c <= dot v x.
Proof.
  intros n l v c x h (w & lw & pos & one & ->) above.
  assert (g : c * fold_right Rplus 0 w <= dot v (combined n w l)); [|rewrite one in g; lra]. clear one.
  revert w lw pos. induction l as [|p l IH]; intros [|a w] lw pos; try discriminate.
  - simpl. rewrite dot_zeros. lra.
  - rewrite dot_combined by auto. simpl fold_right.
    assert (i := IH ltac:(intros; apply h; simpl; auto) ltac:(intros; apply above; simpl; auto) w
      ltac:(simpl in lw; lia) ltac:(intros; apply pos; simpl; auto)).
    assert (0 <= a * (dot v p - c)).
    { apply Rmult_le_pos; [apply pos; simpl; auto|]. assert (q := above p ltac:(simpl; auto)). lra. }
    lra.
Qed.
Lemma hull_middle : forall n l x y, hull n l x -> hull n l y -> hull n l (middle x y).
Proof.
  intros n l x y (w & lw & pw & ow & ->) (u & lu & pu & ou & ->). exists (middle w u).
  split; [rewrite middle_length; congruence|].
  assert (len : length w = length u) by congruence. split; [|split].
  - clear - len pw pu. revert u len pu. induction w as [|a w IH]; intros [|b u] len pu c i; simpl in *; try tauto;
      try discriminate.
    destruct i as [<- | i]; [assert (ha := pw a ltac:(auto)); assert (hb := pu b ltac:(auto)); lra|].
    apply (IH ltac:(auto) u ltac:(lia)); auto.
  - replace 1 with ((fold_right Rplus 0 w + fold_right Rplus 0 u) / 2) by lra. clear - len.
    revert u len. induction w as [|a w IH]; intros [|b u] len; simpl in *; try discriminate; [lra|].
    rewrite IH by lia. lra.
  - assert (zeros : repeat 0 n = middle (repeat 0 n) (repeat 0 n)).
    { induction n as [|n IH]; simpl; auto. rewrite <- IH. f_equal. lra. }
    assert (sums : forall a b c d, length a = length b -> length c = length d -> length a = length c ->
      middle (plus a c) (plus b d) = plus (middle a b) (middle c d)).
    { induction a as [|a0 a IH]; intros [|b0 b] [|c0 c] [|d0 d] e f g; simpl in *; try discriminate; auto.
      rewrite IH by lia. f_equal. lra. }
    assert (multiples : forall a b p, middle (times a p) (times b p) = times ((a + b) / 2) p).
    { intros a b p. induction p as [|c p IH]; simpl; auto. fold (times a p) (times b p). rewrite IH. unfold times.
        simpl. f_equal. lra. }
    clear - len lw zeros sums multiples. revert w u lw len. induction l as [|p l IH]; intros [|a w] [|b u] lw len;
      simpl in *; try discriminate; auto.
    rewrite <- IH by lia. clear IH.
    assert (same : forall w u, length w = length l -> length w = length u ->
      length (combined n w l) = length (combined n u l)).
    { clear. induction l as [|p l IH]; intros [|a w] [|b u] e f; simpl in *; try discriminate; auto.
      assert (g := IH w u ltac:(lia) ltac:(lia)). assert (len : forall x y z : list R,
        length x = length y -> length y = length z -> length x = length z) by congruence.
      assert (k : forall c d (s t : list R), length s = length t ->
        length (plus (times c p) s) = length (plus (times d p) t)).
      { intros c d s t m. clear - m. unfold times. revert s t m. induction p as [|q p IH]; intros [|s0 s] [|t0 t] m;
          simpl in *; try discriminate; auto. }
      apply k; auto. }
    clear lw. revert same. generalize (combined n w l) (combined n u l). intros s t _.
    rewrite <- multiples. clear. revert s t. unfold times. induction p as [|c p IH]; intros [|s0 s] [|t0 t]; simpl;
      auto.
    rewrite IH. f_equal. lra.
Qed.

(** ** What the formulas mean *)
Lemma mixed_means : forall n points w, values (mixed n w points) = combined n (rl w) (map rl points).
Proof.
  assert (zeros : forall n, values (repeat zero n) = repeat 0 n).
  { unfold values. induction n; simpl; auto. rewrite IHn; auto. }
  induction points as [|p points IH]; intros [|a w]; simpl; auto.
  rewrite sum_means, scaled_means, leaves_mean, IH. auto.
Qed.
Lemma points_mean : forall count n points, means Q2R (are_points count n points) -> points_of count n (map rl points).
Proof.
  intros count n points [l h]. rewrite of_length_means in l. rewrite all_means in h. split; [rewrite map_length; auto|].
  intros p i. apply in_map_iff in i. destruct i as [q [<- i]]. specialize (h q i). rewrite of_length_means in h.
  rewrite rl_length; auto.
Qed.
Lemma weights_mean : forall n w points, means Q2R (are_weights w points) ->
  hull n (map rl points) (combined n (rl w) (map rl points)).
Proof.
  intros n w points (l & pos & one). rewrite if_so_means, Nat.eqb_eq in l. rewrite all_means in pos.
  exists (rl w). rewrite rl_length, map_length. split; [auto|]. split; [|split; auto].
  - intros a i. apply in_map_iff in i. destruct i as [q [<- i]]. exact (pos q i).
  - assert (e : forall u, value Q2R (total u) = fold_right Rplus 0 (rl u)) by (induction u; simpl; auto; rewrite IHu;
      auto).
    rewrite <- e. exact one.
Qed.
Lemma none_nearer_means : forall n points x y, points_of (length points) n (map rl points) -> length (values x) = n ->
  means Q2R (none_nearer points x y) -> forall z, hull n (map rl points) z ->
  0 <= dot (minus (values x) (values y)) (minus z (values x)).
Proof.
  intros n points x y [_ hp] lx h z hz. unfold none_nearer in h. rewrite all_means in h.
  rewrite dot_minus by (rewrite (hull_length n _ z hp hz); auto).
  assert (g : dot (minus (values x) (values y)) (values x) <= dot (minus (values x) (values y)) z); [|lra].
  apply (hull_above n (map rl points)); auto. intros p i. assert (lp := hp p i). apply in_map_iff in i.
  destruct i as [q [<- i]]. specialize (h q i). simpl in h. rewrite inner_means, !difference_means, leaves_mean in h.
  rewrite dot_minus in h by congruence. lra.
Qed.
Lemma distance_means : forall x y s d, length (values x) = length (values y) -> means Q2R (of_distance x y s d) ->
  distance_spec (values x) (values y) (Q2R s) (Q2R d).
Proof.
  intros x y s d l (e & p & q). simpl in e. rewrite inner_means, difference_means in e.
  split; [|auto]. rewrite sqdist_dot; auto.
Qed.

Lemma closest_means : forall n points p x s d w, points_of (length points) n (map rl points) ->
  means Q2R (closest_point_proves n points p x s d w) ->
  closest_point_spec n (map rl points) (rl p) (rl x) (Q2R s) (Q2R d).
Proof.
  intros n points p x s d w hp (lp & hw & e & near & dist). rewrite of_length_means in lp.
  assert (lp' := rl_length p). rewrite lp in lp'. assert (hx := weights_mean n w points hw).
  rewrite same_vector_means, leaves_mean in e.
  rewrite <- (mixed_means n points w), <- e in hx. assert (lx := hull_length n _ _ (proj2 hp) hx).
  assert (nn := none_nearer_means n points (mixed n w points) (leaves p) hp ltac:(rewrite <- e; auto) near).
  rewrite <- e, leaves_mean in nn. apply distance_means in dist; [|rewrite <- e, leaves_mean; congruence].
  rewrite <- e, leaves_mean in dist. split; [auto|]. split; [auto|]. split; [|auto].
  intros y hy. assert (ly := hull_length n _ _ (proj2 hp) hy). apply nearest_by_angle; try congruence.
  specialize (nn y hy). rewrite minus_dot in * by congruence. lra.
Qed.
Theorem closest_point_on_segment_sound : forall points p x s d w,
  decide (check_closest_point_on_segment points p x s d w) = true ->
  closest_point_on_segment_spec (map rl points) (rl p) (rl x) (Q2R s) (Q2R d).
Proof.
  intros points p x s d w h. apply decide_means in h. destruct h as (n & hp & h). rewrite if_so_means in n.
  apply two_or_three_means in n. apply points_mean in hp. exists (length p). split; [auto|]. split; [auto|].
  apply (closest_means _ _ _ _ _ _ w); auto. split; [rewrite map_length; auto | apply hp].
Qed.
Theorem closest_point_on_triangle_sound : forall points p x s d w,
  decide (check_closest_point_on_triangle points p x s d w) = true ->
  closest_point_on_triangle_spec (map rl points) (rl p) (rl x) (Q2R s) (Q2R d).
Proof.
  intros points p x s d w h. apply decide_means in h. destruct h as (hp & h). apply points_mean in hp.
  split; [auto|]. apply (closest_means _ _ _ _ _ _ w); auto. split; [rewrite map_length; auto | apply hp].
Qed.

Lemma distance_unique : forall x y s d s' d', distance_spec x y s d -> distance_spec x y s' d' -> s = s' /\ d = d'.
Proof.
  intros x y s d s' d' (-> & p & e) (-> & p' & e'). split; auto. rewrite <- e' in e.
  assert (f : (d - d') * (d + d') = 0) by lra. destruct (Rmult_integral _ _ f); lra.
Qed.
Lemma closest_unique : forall n points p x s d x' s' d', (forall q, In q points -> length q = n) ->
  closest_point_spec n points p x s d -> closest_point_spec n points p x' s' d' -> x = x' /\ s = s' /\ d = d'.
Proof.
  intros n points p x s d x' s' d' hp (lp & hx & nx & dx) (_ & hx' & nx' & dx').
  assert (lx := hull_length _ _ _ hp hx). assert (lx' := hull_length _ _ _ hp hx').
  assert (q := middle_nearer p x x' ltac:(congruence) ltac:(congruence)).
  assert (g := nx _ (hull_middle _ _ _ _ hx hx')). assert (g' := nx' _ (hull_middle _ _ _ _ hx hx')).
  assert (e : x = x') by (apply sqdist_zero; [congruence | lra]). split; auto. subst x'.
  apply (distance_unique p x); auto.
Qed.
Theorem closest_point_on_segment_unique : forall points p x s d x' s' d',
  closest_point_on_segment_spec points p x s d -> closest_point_on_segment_spec points p x' s' d' ->
  x = x' /\ s = s' /\ d = d'.
Proof.
  intros points p x s d x' s' d' (n & _ & [_ hp] & g) (m & _ & _ & h).
  assert (e : m = n) by (rewrite <- (proj1 g), <- (proj1 h); auto). subst m. apply (closest_unique n points p); auto.
Qed.
Theorem closest_point_on_triangle_unique : forall points p x s d x' s' d',
  closest_point_on_triangle_spec points p x s d -> closest_point_on_triangle_spec points p x' s' d' ->
  x = x' /\ s = s' /\ d = d'.
Proof. intros points p x s d x' s' d' [[_ hp] g] [_ h]. apply (closest_unique 3 points p); auto. Qed.

(** ** Pairs *)
Lemma pair_nearest : forall n x y x' y', length x = n -> length y = n -> length x' = n -> length y' = n ->
  0 <= dot (minus x y) (minus x' x) -> 0 <= dot (minus y x) (minus y' y) ->
  sqdist x y <= sqdist x' y' /\ (sqdist x' y' <= sqdist x y -> minus x y = minus x' y').
Proof.
  intros n x y x' y' lx ly lx' ly' h k. rewrite dot_minus in h, k by congruence.
  rewrite (minus_dot y x) in k by congruence. rewrite (minus_dot y x) in k by congruence.
  rewrite (minus_dot x y) in h by congruence. rewrite (minus_dot x y) in h by congruence.
  assert (lu : length (minus x y) = n) by (rewrite minus_length; congruence).
  assert (lu' : length (minus x' y') = n) by (rewrite minus_length; congruence).
  assert (s := sqdist_nonneg (minus x y) (minus x' y')).
  assert (e : dot (minus x y) (minus x' y') >= dot (minus x y) (minus x y)).
  { rewrite !(dot_minus (minus x y)), !(minus_dot x y) by congruence. lra. }
  assert (f : sqdist (minus x y) (minus x' y') = sqdist x y - 2 * dot (minus x y) (minus x' y') + sqdist x' y').
  { rewrite (sqdist_dot (minus x y)), square_of_difference, <- !sqdist_dot by congruence. auto. }
  rewrite (sqdist_dot x y) in * by congruence. split; [lra|]. intro m. apply sqdist_zero; [congruence | lra].
Qed.
Lemma on_segment_form : forall n p q x, length p = n -> length q = n -> hull n [p; q] x ->
  exists t, 0 <= t <= 1 /\ length x = n /\ forall v, dot v x = dot v p + t * (dot v q - dot v p).
Proof.
  intros n p q x lp lq (w & lw & pos & one & ->). destruct w as [|a [|b [|]]]; try discriminate.
  assert (ha := pos a ltac:(simpl; auto)). assert (hb := pos b ltac:(simpl; auto)). simpl in one.
  assert (all : forall z, In z [p; q] -> length z = n) by (intros z [<- | [<- | []]]; auto).
  exists b. split; [lra|]. split; [apply combined_length; auto|]. intro v.
  rewrite !dot_combined by (auto; intros; apply all; simpl; auto). simpl combined. rewrite dot_zeros.
  replace a with (1 - b) by lra. ring.
Qed.
Lemma least_parameter : forall t t' s s' vv vu uu, 0 <= t -> 0 <= t' -> 0 <= s' <= 1 -> 0 <= vv ->
  (t' - t) * vv = (s' - s) * vu -> (t' - t) * vu = (s' - s) * uu ->
  vu = 0 \/ vv * uu <> vu * vu \/ t * t * vv = 0 \/ (0 < vu /\ s * s * uu = 0) \/ (vu < 0 /\
    (s - 1) * (s - 1) * uu = 0) ->
  t * t * vv <= t' * t' * vv.
Proof.
  intros t t' s s' vv vu uu ht ht' hs hv e f h. destruct (Rle_lt_dec t t') as [l | l].
  - apply Rmult_le_compat_r; auto. apply Rmult_le_compat; auto.
  - assert (g : (t' - t) * vv <= 0) by (assert (0 <= (t - t') * vv) by (apply Rmult_le_pos; lra); lra).
    assert (stop : 0 <= (t' - t) * vv -> t * t * vv <= t' * t' * vv).
    { intro k. assert (z : (t' - t) * vv = 0) by lra. destruct (Rmult_integral _ _ z) as [i | ->]; lra. }
    destruct h as [-> | [h | [h | [[h k] | [h k]]]]].
    + apply stop. lra.
    + exfalso. apply h. assert (z : (t' - t) * (vv * uu - vu * vu) = 0).
      { transitivity ((t' - t) * vv * uu - (t' - t) * vu * vu); [ring|]. rewrite e, f. ring. }
      destruct (Rmult_integral _ _ z); lra.
    + rewrite h. apply Rmult_le_pos; auto. apply Rmult_le_pos; auto.
    + apply stop. rewrite e. destruct (Rmult_integral _ _ k) as [i | ->].
      * assert (s = 0) by (destruct (Rmult_integral _ _ i); auto). subst s. apply Rmult_le_pos; lra.
      * exfalso. assert (z : (t' - t) * vu = 0) by lra. destruct (Rmult_integral _ _ z); lra.
    + apply stop. rewrite e. destruct (Rmult_integral _ _ k) as [i | ->].
      * assert (s = 1) by (destruct (Rmult_integral _ _ i); lra). subst s.
        assert (0 <= (1 - s') * - vu) by (apply Rmult_le_pos; lra). lra.
      * exfalso. assert (z : (t' - t) * vu = 0) by lra. destruct (Rmult_integral _ _ z); lra.
Qed.
Lemma sqdist_form : forall n p q x t, length p = n -> length q = n -> length x = n ->
  (forall v, dot v x = dot v p + t * (dot v q - dot v p)) ->
  sqdist p x = t * t * dot (minus q p) (minus q p) /\ sqdist q x = (t - 1) * (t - 1) * dot (minus q p) (minus q p).
Proof.
  intros n p q x t lp lq lx h. rewrite !sqdist_dot, !square_of_difference by congruence.
  assert (hx := h x). assert (hp := h p). assert (hq := h q). rewrite (dot_sym x p), (dot_sym x q) in hx.
  rewrite (dot_sym q p) in *. rewrite hx, hp, hq. split; ring.
Qed.
Theorem segment_segment_distance_sound : forall a0 a1 b0 b1 x y s d on_a on_b,
  decide (check_segment_segment_distance a0 a1 b0 b1 x y s d on_a on_b) = true ->
  segment_segment_distance_spec (map rl [a0; a1]) (map rl [b0; b1]) (rl x) (rl y) (Q2R s) (Q2R d).
Proof.
  intros a0 a1 b0 b1 x y s d on_a on_b h. apply decide_means in h. unfold check_segment_segment_distance in h.
  cbv zeta in h. set (n := length a0) in *. set (a := [a0; a1]) in *. set (b := [b0; b1]) in *.
  destruct h as (hn & pa & pb & wa & wb & ex & ey & na & nb & first & dist). rewrite if_so_means in hn.
  apply two_or_three_means in hn. apply points_mean in pa, pb. apply (weights_mean n) in wa, wb.
  rewrite same_vector_means, leaves_mean in ex, ey. rewrite <- (mixed_means n), <- ex in wa.
  rewrite <- (mixed_means n), <- ey in wb.
  assert (lx := hull_length _ _ _ (proj2 pa) wa). assert (ly := hull_length _ _ _ (proj2 pb) wb).
  assert (na' := none_nearer_means n a _ _ pa ltac:(rewrite <- ex; auto) na).
  assert (nb' := none_nearer_means n b _ _ pb ltac:(rewrite <- ey; auto) nb).
  apply distance_means in dist; [|rewrite <- ex, <- ey; congruence]. rewrite <- ex, <- ey in *. clear na nb.
  exists n. split; [exact hn|]. do 2 (split; [assumption|]). split; [|exact dist]. do 2 (split; [assumption|]).
  intros x' y' hx' hy'. assert (lx' := hull_length _ _ _ (proj2 pa) hx').
    assert (ly' := hull_length _ _ _ (proj2 pb) hy').
  destruct (pair_nearest n (rl x) (rl y) x' y') as [g k]; auto. split; auto. intro e.
  assert (k' := k ltac:(lra)). clear k.
  assert (p0 : length (rl a0) = n) by (apply pa; simpl; auto). assert (p1 : length (rl a1) = n) by (apply pa; simpl;
    auto).
  assert (q0 : length (rl b0) = n) by (apply pb; simpl; auto). assert (q1 : length (rl b1) = n) by (apply pb; simpl;
    auto).
  destruct (on_segment_form n _ _ _ p0 p1 wa) as (t & ht & _ & ft).
  destruct (on_segment_form n _ _ _ p0 p1 hx') as (t' & ht' & _ & ft').
  destruct (on_segment_form n _ _ _ q0 q1 wb) as (r & hr & _ & fr).
  destruct (on_segment_form n _ _ _ q0 q1 hy') as (r' & hr' & _ & fr').
  destruct (sqdist_form n _ _ _ t p0 p1 lx ft) as [sx _]. destruct (sqdist_form n _ _ _ t' p0 p1 lx' ft') as [sx' _].
  destruct (sqdist_form n _ _ _ r q0 q1 ly fr) as [sy0 sy1].
  simpl map. simpl hd. rewrite sx, sx'.
  set (v := minus (rl a1) (rl a0)) in *. set (u := minus (rl b1) (rl b0)) in *.
  assert (lv : length v = n) by (unfold v; rewrite minus_length; congruence).
  assert (lu : length u = n) by (unfold u; rewrite minus_length; congruence).
  assert (move : forall z, (t' - t) * dot z v = (r' - r) * dot z u).
  { intro z. assert (m : dot z (minus (rl x) (rl y)) = dot z (minus x' y')) by congruence.
    rewrite !dot_minus in m by congruence. rewrite ft, ft', fr, fr' in m. unfold v, u.
      rewrite !dot_minus by congruence. lra. }
  apply (least_parameter t t' r r' (dot v v) (dot v u) (dot u u)); try lra; try apply dot_self.
  { apply move. } { rewrite (dot_sym v u). apply move. }
  simpl in first. rewrite !inner_means, !difference_means, !same_vector_means, !leaves_mean in first. fold v u in first.
  rewrite <- ex, <- ey in first. destruct first as [f | [f | [f | [[f f'] | [f f']]]]].
  - auto.
  - right; left. exact f.
  - right; right; left. rewrite <- sx, f. apply sqdist_self.
  - right; right; right; left. split; auto. rewrite <- sy0, f'. apply sqdist_self.
  - right; right; right; right. split; auto. rewrite <- sy1, f'. apply sqdist_self.
Qed.

Lemma middles_nearer : forall x y u v, length x = length y -> length u = length x -> length v = length x ->
  2 * sqdist (middle x u) (middle y v) <= sqdist x y + sqdist u v.
Proof.
  induction x as [|a x IH]; intros [|b y] [|c u] [|d v] l1 l2 l3; simpl in *; try discriminate; try lra.
  assert (h := IH y u v ltac:(lia) ltac:(lia) ltac:(lia)). assert (q := square ((a - b) - (c - d))).
  replace (((a + c) / 2 - (b + d) / 2) * ((a + c) / 2 - (b + d) / 2)) with
    ((a - b + (c - d)) * (a - b + (c - d)) / 4) by field. lra.
Qed.
Lemma nearest_pair_unique : forall n a b x y x' y', (forall p, In p a -> length p = n) ->
  (forall p, In p b -> length p = n) -> a <> [] -> nearest_pair n a b x y -> nearest_pair n a b x' y' ->
  x = x' /\ y = y'.
Proof.
  intros n a b x y x' y' pa pb some (hx & hy & near) (hx' & hy' & near').
  destruct a as [|a0 a]; [tauto|]. assert (l0 := pa a0 ltac:(simpl; auto)). simpl hd in *.
  assert (lx := hull_length _ _ _ pa hx). assert (lx' := hull_length _ _ _ pa hx').
  assert (ly := hull_length _ _ _ pb hy). assert (ly' := hull_length _ _ _ pb hy').
  destruct (near _ _ hx' hy') as [g1 g2]. destruct (near' _ _ hx hy) as [h1 h2].
  assert (q := middles_nearer x y x' y' ltac:(congruence) ltac:(congruence) ltac:(congruence)).
  destruct (near _ _ (hull_middle _ _ _ _ hx hx') (hull_middle _ _ _ _ hy hy')) as [g3 g4].
  assert (g5 := g4 ltac:(lra)). specialize (g2 ltac:(lra)). specialize (h2 ltac:(lra)).
  assert (k := middle_nearer a0 x x' ltac:(congruence) ltac:(congruence)).
  assert (e : x = x') by (apply sqdist_zero; [congruence | lra]). subst x'. split; auto.
  assert (k' := middle_nearer x y y' ltac:(congruence) ltac:(congruence)).
  destruct (near _ _ hx (hull_middle _ _ _ _ hy hy')) as [g6 _]. apply sqdist_zero; [congruence | lra].
Qed.
Theorem segment_segment_distance_unique : forall a b x y s d x' y' s' d',
  segment_segment_distance_spec a b x y s d -> segment_segment_distance_spec a b x' y' s' d' ->
  x = x' /\ y = y' /\ s = s' /\ d = d'.
Proof.
  intros a b x y s d x' y' s' d' (n & _ & [ca pa] & [_ pb] & near & dist) (m & _ & [_ pa'] & _ & near' & dist').
  assert (some : a <> []) by (destruct a; discriminate).
  assert (e : m = n).
  { destruct a as [|a0 a]; [tauto|]. rewrite <- (pa' a0), <- (pa a0) by (simpl; auto). auto. }
  subst m. destruct (nearest_pair_unique n a b x y x' y' pa pb some near near') as [<- <-].
  destruct (distance_unique x y s d s' d' dist dist') as [<- <-]. auto.
Qed.
