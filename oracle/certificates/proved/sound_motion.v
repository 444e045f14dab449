(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of moving balls are enough, also where the time is irrational, and their specifications leave no
    choice. *)
Require Import Reals Qreals QArith Lra Lia List Arith Bool.
From Certificates Require Import motion solids language formulas_vectors formulas_solids formulas_slabs formulas_motion
  sound_solids sound_vectors.
Import ListNotations.
Open Scope R_scope.

Definition r_surd (t : surd Q) : R := let '(Surd p q k) := t in surd_value (Surd (Q2R p) (Q2R q) (Q2R k)).

(** ** Places at a time *)
Lemma at_time_length : forall start way t, length start = length way -> length (at_time start way t) = length way.
Proof. intros. unfold at_time. rewrite plus_length; rewrite times_length; auto. Qed.
Lemma dot_at_time : forall n start way t, length start = length way ->
  dot n (at_time start way t) = dot n start + t * dot n way.
Proof. intros. unfold at_time. rewrite dot_plus, dot_times; auto. rewrite times_length; auto. Qed.
Lemma square_at_time : forall g r t, length g = length r ->
  dot (at_time g r t) (at_time g r t) = dot g g + 2 * dot g r * t + dot r r * (t * t).
Proof.
  intros g r t l. rewrite dot_at_time, !(dot_sym (at_time g r t)), !dot_at_time, (dot_sym r g) by auto. ring.
Qed.
Lemma gap_at_time : forall c v d w t, length c = length d -> length v = length c -> length w = length c ->
  sqdist (at_time c v t) (at_time d w t) =
  dot (minus c d) (minus c d) + 2 * dot (minus c d) (minus v w) * t + dot (minus v w) (minus v w) * (t * t).
Proof.
  intros c v d w t l1 l2 l3. rewrite sqdist_dot by (rewrite !at_time_length; congruence).
  assert (e : minus (at_time c v t) (at_time d w t) = at_time (minus c d) (minus v w) t).
  { revert v d w l1 l2 l3. unfold at_time, times. induction c as [|a c IH]; intros [|b v] [|e d] [|f w] l1 l2 l3;
      simpl in *; try discriminate; auto.
    rewrite IH by lia. f_equal. ring. }
  rewrite e. apply square_at_time. rewrite !minus_length; congruence.
Qed.

(** ** Balls meet where their centers are no farther apart than the sum of the radii *)
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

Lemma not_positive_means : forall p q k, 0 <= value Q2R k ->
  (means Q2R (not_positive p q k) <-> value Q2R p + value Q2R q * sqrt (value Q2R k) <= 0).
Proof. intros p q k hk. rewrite <- not_positive_iff by auto. reflexivity. Qed.
Lemma not_negative_means : forall p q k, 0 <= value Q2R k ->
  (means Q2R (not_negative p q k) <-> 0 <= value Q2R p + value Q2R q * sqrt (value Q2R k)).
Proof.
  intros p q k hk. unfold not_negative. rewrite not_positive_means by auto.
  change (value Q2R (zero - ?t)%check) with (0 - value Q2R t). lra.
Qed.
Lemma is_zero_means : forall p q k, 0 <= value Q2R k ->
  (means Q2R (is_zero p q k) <-> value Q2R p + value Q2R q * sqrt (value Q2R k) = 0).
Proof.
  intros p q k hk. unfold is_zero. simpl means. fold (@means Q Q2R). split.
  - intros [a b]. apply not_positive_means in a; auto. apply (not_negative_means p q k hk) in b. lra.
  - intro e. split; [apply not_positive_means | apply (not_negative_means p q k hk)]; auto; lra.
Qed.
Section at_root.
Variables (c b a x y k : term Q).
Hypothesis hk : 0 <= value Q2R k.
Let t := value Q2R x + value Q2R y * sqrt (value Q2R k).
Lemma zero_at_means : means Q2R (zero_at c b a x y k) -> value Q2R c + value Q2R b * t + value Q2R a * (t * t) = 0.
Proof.
  intro h. apply is_zero_means in h; auto. simpl in h. assert (s := sqrt_def _ hk). unfold t.
  set (r := sqrt (value Q2R k)) in *. rewrite <- s in h. lra.
Qed.
Lemma falls_at_means : means Q2R (falls_at b a x y k) -> value Q2R b + 2 * value Q2R a * t <= 0.
Proof. intro h. apply not_positive_means in h; auto. simpl in h. unfold t. lra. Qed.
Lemma rises_at_means : means Q2R (rises_at b a x y k) -> 0 <= value Q2R b + 2 * value Q2R a * t.
Proof. intro h. apply not_negative_means in h; auto. simpl in h. unfold t. lra. Qed.
End at_root.

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

Lemma stays_positive_means : forall ends c b a kind t, 0 <= value Q2R a -> 0 <= t -> (means Q2R ends -> t <= 1) ->
  means Q2R (stays_positive ends c b a kind) -> 0 < value Q2R c + value Q2R b * t + value Q2R a * (t * t).
Proof.
  intros ends c b a kind t ha t0 t1 h. unfold stays_positive in h.
  assert (q := square t). assert (0 <= value Q2R a * (t * t)) by (apply Rmult_le_pos; auto).
  destruct kind; simpl in h; try tauto.
  - destruct h as [hc hb]. assert (0 <= value Q2R b * t) by (apply Rmult_le_pos; auto). lra.
  - destruct h as (hc & e & h1 & d). assert (t1' := t1 e).
    assert (0 <= (1 - t) * - (2 * value Q2R a + value Q2R b)) by (apply Rmult_le_pos; lra).
    assert (0 <= value Q2R a * ((1 - t) * (1 - t))) by (apply Rmult_le_pos; [auto | apply square]). lra.
  - destruct h as [hc d]. apply Rnot_le_lt; intro n. assert (s := square (2 * value Q2R a * t + value Q2R b)).
    assert (0 <= value Q2R a * - (value Q2R c + value Q2R b * t + value Q2R a * (t * t))) by (apply Rmult_le_pos; lra).
    lra.
Qed.
Lemma first_zero_means : forall c b a answer kind facts (meet : R -> Prop), 0 <= value Q2R a ->
  (forall t, meet t <-> value Q2R c + value Q2R b * t + value Q2R a * (t * t) <= 0) ->
  means Q2R (first_zero_proves c b a answer kind facts) -> first_time_spec meet (option_map r_surd answer).
Proof.
  intros c b a answer kind facts meet ha core [_ h]. destruct answer as [[x y k] |].
  - destruct kind; try (simpl in h; tauto).
    + destruct h as (hc & hk & z). apply (is_zero_means _ _ (Leaf k) hk) in z. simpl in z, hc. simpl. rewrite z.
      split; [lra|]. split; [apply core; lra | intros; lra].
    + cbv zeta in h. destruct h as (hc & hk & pos & one & z & f). change (~ means Q2R (not_positive (Leaf x) (Leaf y)
        (Leaf k))) in pos. rewrite (not_positive_means _ _ (Leaf k) hk) in pos.
      apply (not_positive_means _ _ (Leaf k) hk) in one.
      apply (zero_at_means _ _ _ _ _ (Leaf k) hk) in z. apply (falls_at_means _ _ _ _ (Leaf k) hk) in f.
      simpl in hc, pos, one, z, f. simpl. set (t := Q2R x + Q2R y * sqrt (Q2R k)) in *.
      split; [unfold t in *; lra|]. split; [apply core; lra|]. intros u hu m. apply core in m.
      assert (g := before_first_root _ _ _ t u ha hc z f). lra.
  - simpl. intros u hu m. apply core in m.
    assert (g := stays_positive_means Yes c b a kind u ha ltac:(lra) ltac:(intro; lra) h). lra.
Qed.

Theorem swept_sphere_sphere_sound : forall p r v o s w answer kind facts,
  decide (check_swept_sphere_sphere p r v o s w answer kind facts) = true ->
  swept_sphere_sphere_spec (rl p) (Q2R r) (rl v) (rl o) (Q2R s) (rl w) (option_map r_surd answer).
Proof.
  intros p r v o s w answer kind facts h. apply decide_means in h. unfold check_swept_sphere_sphere in h. cbv zeta in h.
  destruct h as (l1 & l2 & l3 & l4 & hr & hs & h). rewrite of_length_means in l1, l2, l3, l4. simpl in hr, hs.
  unfold swept_sphere_sphere_spec, swept_ball, proper_ball. rewrite !rl_length.
  do 4 (split; [auto|]).
  eapply first_zero_means; [| |exact h].
  - rewrite inner_means, difference_means, !leaves_mean. apply dot_self.
  - intro t. rewrite meet_iff; auto; try (rewrite at_time_length, rl_length; auto; rewrite !rl_length; congruence).
    rewrite gap_at_time by (rewrite !rl_length; congruence). simpl.
    rewrite !inner_means, !difference_means, !leaves_mean. lra.
Qed.
(** What is so no later than another thing, and never unless that is, is first so at the same time. *)
Lemma first_time_sooner : forall (M N : R -> Prop) w, (forall t, M t -> N t) ->
  (forall t, 0 <= t -> N t -> exists s, 0 <= s <= t /\ M s) -> first_time_spec M w -> first_time_spec N w.
Proof.
  intros M N [t |] holds sooner h; simpl in *.
  - destruct h as (i & m & before). split; [auto|]. split; [auto|]. intros u iu nu.
    destruct (sooner u ltac:(lra) nu) as (s & is & ms). apply (before s); [lra | auto].
  - intros u iu nu. destruct (sooner u ltac:(lra) nu) as (s & is & ms). apply (h s); [lra | auto].
Qed.
Lemma first_time_unique : forall meet x y, first_time_spec meet x -> first_time_spec meet y -> x = y.
Proof.
  intros meet [t |] [u |] g h; auto; simpl in g, h.
  - destruct g as (g1 & g2 & g3), h as (h1 & h2 & h3).
    destruct (Rtotal_order t u) as [l | [-> | l]]; auto; exfalso; [apply (h3 t) | apply (g3 u)]; auto; lra.
  - destruct g as (g1 & g2 & _). exfalso. apply (h t); auto.
  - destruct h as (h1 & h2 & _). exfalso. apply (g u); auto.
Qed.
Theorem swept_sphere_sphere_unique : forall c r v d s w x y,
  swept_sphere_sphere_spec c r v d s w x -> swept_sphere_sphere_spec c r v d s w y -> x = y.
Proof. intros c r v d s w x y (_ & _ & _ & _ & g) (_ & _ & _ & _ & h). apply (first_time_unique _ _ _ g h). Qed.

(** ** A ball meets a plane where its center is no farther from it than the radius. *)
Lemma ball_meets_plane : forall c r n d, length c = 3%nat -> length n = 3%nat -> nonzero n ->
  ((exists x, length x = 3%nat /\ ball c r x /\ dot n x + d = 0) <->
   (dot n c + d) * (dot n c + d) <= r * r * dot n n).
Proof.
  intros c r n d lc ln nz. apply dot_nonzero in nz. split.
  - intros (x & lx & b & e). unfold ball in b. rewrite sqdist_dot in b by congruence.
    assert (g := cauchy n (minus c x) ltac:(rewrite minus_length; congruence)).
    rewrite !(dot_minus n) in g by congruence. replace (dot n c + d) with (dot n c - dot n x) by lra.
    apply Rle_trans with (1 := g). rewrite (Rmult_comm (r * r)). apply Rmult_le_compat_l; lra.
  - intro h. set (e := (dot n c + d) / dot n n). exists (minus c (times e n)).
    assert (l : length c = length (times e n)) by (rewrite times_length; congruence).
    assert (q : e * dot n n = dot n c + d) by (unfold e; field; lra).
    split; [rewrite minus_length, times_length; auto|]. split.
    + unfold ball. rewrite sqdist_dot by (rewrite minus_length; auto).
      assert (m : minus c (minus c (times e n)) = times e n).
      { clear - l. revert l. generalize (times e n). induction c as [|a c IH]; intros [|b x] l; simpl in *;
          try discriminate; auto. rewrite IH by lia. f_equal. lra. }
      rewrite m, times_dot, dot_times. apply (Rmult_le_reg_r (dot n n)); [auto|].
      replace (e * (e * dot n n) * dot n n) with ((e * dot n n) * (e * dot n n)) by ring. rewrite q. auto.
    + rewrite dot_minus, dot_times by auto. lra.
Qed.
Lemma approach_means : forall e r v n answer kind facts, means Q2R (approach_proves e r v n answer kind facts) ->
  first_time_spec (fun t => (value Q2R e + t * dot (rl n) (rl v)) * (value Q2R e + t * dot (rl n) (rl v)) <=
    Q2R r * Q2R r * dot (rl n) (rl n)) (option_map r_surd answer).
Proof.
  intros e r v n answer kind facts h. eapply first_zero_means; [| |exact h].
  - apply square.
  - intro t. simpl. rewrite !inner_means, !leaves_mean. lra.
Qed.
Theorem swept_sphere_plane_sound : forall c r v n d answer kind facts,
  decide (check_swept_sphere_plane c r v n d answer kind facts) = true ->
  swept_sphere_plane_spec (rl c) (Q2R r) (rl v) (rl n) (Q2R d) (option_map r_surd answer).
Proof.
  intros c r v n d answer kind facts h. apply decide_means in h. unfold check_swept_sphere_plane in h. cbv zeta in h.
  destruct h as (l1 & hr & l2 & l3 & nz & h). rewrite of_length_means in l1, l2, l3. simpl in hr.
  apply not_zero_means in nz. unfold swept_sphere_plane_spec, swept_ball, proper_ball. rewrite !rl_length.
  split; [auto|]. do 3 (split; [auto|]). apply approach_means in h.
  assert (core : forall t, (exists x, length x = 3%nat /\ ball (at_time (rl c) (rl v) t) (Q2R r) x /\
      dot (rl n) x + Q2R d = 0) <-> (value Q2R (height n d c) + t * dot (rl n) (rl v)) *
      (value Q2R (height n d c) + t * dot (rl n) (rl v)) <= Q2R r * Q2R r * dot (rl n) (rl n)).
  { intro t. rewrite ball_meets_plane; auto; [|rewrite at_time_length, rl_length; auto; rewrite !rl_length; congruence
      | rewrite rl_length; auto].
    rewrite dot_at_time by (rewrite !rl_length; congruence). unfold height. simpl.
    rewrite !inner_means, !leaves_mean. lra. }
  revert h. apply first_time_sooner.
  - intros t m. apply core. exact m.
  - intros t t0 m. exists t. split; [lra|]. apply core. exact m.
Qed.
Theorem swept_sphere_plane_unique : forall c r v n d x y,
  swept_sphere_plane_spec c r v n d x -> swept_sphere_plane_spec c r v n d y -> x = y.
Proof. intros c r v n d x y (_ & _ & _ & _ & g) (_ & _ & _ & _ & h). apply (first_time_unique _ _ _ g h). Qed.
