(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of courses through boxes and balls, and of moving boxes, are enough, and their specifications leave no
    choice. *)
Require Import Reals Qreals QArith Lra Lia List Arith Bool.
From Certificates Require Import motion solids language formulas_vectors formulas_solids formulas_heights
  formulas_capsules formulas_motion formulas_courses sound_solids sound_vectors sound_heights sound_capsules
  sound_motion.
Import ListNotations.
Open Scope R_scope.

(** ** Boxes *)
Lemma on_some_means : forall f n, means Q2R (on_some n f) -> exists k, (k < n)%nat /\ means Q2R (f k).
Proof.
  induction n as [|n IH]; simpl; [tauto|]. intros [h | h].
  - destruct (IH h) as (k & a & b). exists k. split; [lia | auto].
  - exists n. split; [lia | auto].
Qed.
Lemma highest_of_box_means : forall n low high x, length low = length n -> length high = length n ->
  length x = length n -> box (rl low) (rl high) x -> dot (rl n) x <= value Q2R (highest_of_box n low high).
Proof.
  intros n low high x e1 e2 e3 b.
  assert (c : forall k, (k < length n)%nat -> nth k (rl low) 0 <= nth k x 0 <= nth k (rl high) 0)
    by (intros k hk; apply b; lia).
  clear b. revert low high x e1 e2 e3 c.
  induction n as [|c n IH]; intros [|l low] [|h high] [|a x] e1 e2 e3 b; simpl in *; try discriminate; try lra.
  assert (g := IH low high x ltac:(lia) ltac:(lia) ltac:(lia) ltac:(intros k hk; apply (b (S k)); lia)).
  assert (b0 := b O ltac:(lia)). simpl in b0.
  assert (m1 := Rmax_l (Q2R c * Q2R l) (Q2R c * Q2R h)). assert (m2 := Rmax_r (Q2R c * Q2R l) (Q2R c * Q2R h)).
  destruct (Rle_lt_dec 0 (Q2R c)).
  - assert (0 <= Q2R c * (Q2R h - a)) by (apply Rmult_le_pos; lra). lra.
  - assert (0 <= - Q2R c * (a - Q2R l)) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma is_box_means : forall n low high, means Q2R (is_box n low high) -> proper_box n (rl low) (rl high).
Proof.
  intros n low high (h & ll & lh & v). rewrite if_so_means, orb_true_iff, !Nat.eqb_eq in h.
  rewrite of_length_means in ll, lh. unfold proper_box. rewrite !rl_length. do 3 (split; [auto|]). intros k hk.
  rewrite on_each_means in v. specialize (v k hk). simpl in v. rewrite !coordinate_means in v. auto.
Qed.
Lemma nth_values : forall x k, value Q2R (nth k x zero) = nth k (values x) 0.
Proof. intros x k. change 0 with (value Q2R zero). unfold values. rewrite map_nth. auto. Qed.
Lemma box_holds_means : forall low high x, length x = length low -> means Q2R (box_holds low high x) ->
  box (rl low) (rl high) (values x).
Proof.
  intros low high x l h k hk. unfold values in hk. rewrite map_length, l in hk. unfold box_holds in h.
  rewrite on_each_means in h. specialize (h k hk). simpl means in h. rewrite !coordinate_means, nth_values in h.
  exact h.
Qed.
Lemma nth_at_time : forall start way t k, length start = length way -> (k < length way)%nat ->
  nth k (at_time start way t) 0 = nth k start 0 + t * nth k way 0.
Proof.
  unfold at_time, times. induction start as [|a start IH]; intros [|b way] t k l hk; simpl in *; try discriminate;
    try lia.
  destruct k; auto. apply IH; lia.
Qed.

(** ** Courses *)
Definition still (way : list R) : Prop := forall v, In v way -> v = 0.
Definition course (ends : bool) (way : list R) (t : R) : Prop :=
  0 <= t /\ if ends then t <= 1 /\ (still way -> t = 0) else True.
Lemma passage_of_same : forall (P P' : R -> Prop) w, (forall t, P t <-> P' t) -> passage_spec P w -> passage_spec P' w.
Proof.
  intros P P' [[first last] |] e h; simpl in *.
  - split; [tauto|]. intro t. rewrite <- e. apply h.
  - intros t i. apply (h t), e, i.
Qed.
Lemma passage_unique : forall P v w, passage_spec P v -> passage_spec P w -> v = w.
Proof.
  intros P [[f l] |] [[g m] |] a b; auto; simpl in a, b.
  - destruct a as [a1 a], b as [b1 b]. assert (x := proj1 (a g) (proj2 (b g) ltac:(lra))).
    assert (y := proj1 (a m) (proj2 (b m) ltac:(lra))). assert (z := proj1 (b f) (proj2 (a f) ltac:(lra))).
    assert (w := proj1 (b l) (proj2 (a l) ltac:(lra))). do 2 f_equal; lra.
  - destruct a as [a1 a]. exfalso. apply (b f), a. lra.
  - destruct b as [b1 b]. exfalso. apply (a g), b. lra.
Qed.
Lemma ray_course : forall S o d w, passage_spec (fun t => course false d t /\ S (at_time o d t)) w ->
  passage_spec (ray_in S o d) w.
Proof. intros S o d w. apply passage_of_same. intro t. unfold course, ray_in. tauto. Qed.
Lemma same_ends : forall x y, length x = length y -> (x = y <-> still (minus y x)).
Proof.
  unfold still. induction x as [|p x IH]; intros [|q y] e; simpl in *; try discriminate.
  - split; [intros _ v [] | auto].
  - specialize (IH y ltac:(lia)). split.
    + intro g. injection g; intros g1 g2. intros v [<- | i]; [lra | apply IH; auto].
    + intro g. f_equal; [assert (k := g (q - p) ltac:(auto)); lra | apply IH; intros; apply g; auto].
Qed.
Lemma segment_course : forall S a b w, length a = length b ->
  passage_spec (fun t => course true (minus b a) t /\ S (at_time a (minus b a) t)) w -> passage_spec (segment_in S a
    b) w.
Proof.
  intros S a b w l. apply passage_of_same. intro t. unfold course, segment_in. rewrite (same_ends a b l). tauto.
Qed.

(** ** Through boxes *)
Definition r_times (w : option (Q * Q)) : option (R * R) :=
  option_map (fun times => (Q2R (fst times), Q2R (snd times))) w.
Lemma still_means : forall way, means Q2R (is_still way) <-> still (values way).
Proof.
  intro way. unfold is_still, still. rewrite all_means. split.
  - intros g v i. apply in_map_iff in i. destruct i as (t & <- & i). exact (g t i).
  - intros g t i. apply g. apply in_map; auto.
Qed.
Lemma box_passage_means : forall (ends : bool) start way low high w facts,
  length (values start) = length low -> length (values way) = length low -> length high = length low ->
  means Q2R (box_passage_proves ends start way low high w facts) ->
  passage_spec (fun t => course ends (values way) t /\ box (rl low) (rl high) (at_time (values start) (values way) t))
    (r_times w).
Proof.
  intros ends start way low high w facts ls lw lh h. unfold box_passage_proves in h. cbv zeta in h.
  assert (term_length : forall t, length (at_term start way t) = length low).
  { intro t. rewrite <- (map_length (value Q2R)). fold (values (at_term start way t)).
    rewrite at_term_means, at_time_length; congruence. }
  assert (held : forall t, box (rl low) (rl high) (at_time (values start) (values way) t) <-> forall k,
    (k < length low)%nat -> nth k (rl low) 0 <= nth k (values start) 0 + t * nth k (values way) 0 <= nth k (rl high) 0).
  { intro t. unfold box. rewrite at_time_length, lw by congruence. split; intros b k hk.
    - rewrite <- nth_at_time by lia. apply b; auto.
    - rewrite nth_at_time by lia. apply b; auto. }
  destruct w as [[first last] |], facts as [| n]; try (simpl in h; tauto).
  - destruct h as (h0 & i1 & c1 & le & e1 & i2 & c2). simpl in h0, le.
    apply box_holds_means in i1; auto. apply box_holds_means in i2; auto. rewrite at_term_means in i1, i2.
    simpl value in i1, i2. rewrite held in i1, i2.
    assert (moves : forall t (f : nat -> bool), means Q2R (on_some (length low) t) -> (forall k, means Q2R (t k) ->
      nth k (values way) 0 <> 0) -> ~ still (values way)).
    { intros t f c g z. apply on_some_means in c. destruct c as (k & hk & c). apply (g k c), z, nth_In. lia. }
    assert (last0 : if ends then still (values way) -> Q2R last = 0 else True).
    { destruct ends; auto. intro z.
      destruct c2 as [[[_ c2] | [c2 _]] | c2]; [exact c2 | exfalso; apply c2; apply still_means; exact z | exfalso].
      revert z. apply (moves _ (fun _ => true) c2). intros k g. simpl in g. rewrite !nth_values in g. lra. }
    simpl. split; [exact le|]. intro t. rewrite held. split.
    + intros [[t0 t1] b]. split.
      * destruct c1 as [c1 | c1]; [simpl in c1; lra|]. apply on_some_means in c1. destruct c1 as (k & hk & c1).
        simpl means in c1. change (value Q2R zero) with 0 in c1.
        rewrite !coordinate_means, !nth_values, at_term_means, nth_at_time in c1 by lia.
        assert (g := b k hk). simpl value in c1. destruct c1 as [[a z] | [a z]]; apply Rnot_lt_le; intro l.
        -- assert (0 < (Q2R first - t) * - nth k (values way) 0) by (apply Rmult_lt_0_compat; lra). lra.
        -- assert (0 < (Q2R first - t) * nth k (values way) 0) by (apply Rmult_lt_0_compat; lra). lra.
      * destruct c2 as [c2 | c2].
        -- destruct ends; [|simpl in c2; tauto]. destruct t1 as [t2 t1]. destruct c2 as [[z c2] | [_ c2]];
             simpl in c2; [|lra]. apply still_means in z. rewrite t1; [lra | exact z].
        -- apply on_some_means in c2. destruct c2 as (k & hk & c2).
           simpl means in c2. change (value Q2R zero) with 0 in c2.
           rewrite !coordinate_means, !nth_values, at_term_means, nth_at_time in c2 by lia.
           assert (g := b k hk). simpl value in c2. destruct c2 as [[a z] | [a z]]; apply Rnot_lt_le; intro l.
           ++ assert (0 < (t - Q2R last) * nth k (values way) 0) by (apply Rmult_lt_0_compat; lra). lra.
           ++ assert (0 < (t - Q2R last) * - nth k (values way) 0) by (apply Rmult_lt_0_compat; lra). lra.
    + intros [t1 t2]. split.
      * split; [lra|]. destruct ends; auto. simpl in e1. split; [lra|]. intro z. specialize (last0 z). lra.
      * intros k hk. specialize (i1 k hk). specialize (i2 k hk). set (v := nth k (values way) 0) in *.
        destruct (Rle_lt_dec 0 v).
        -- assert (0 <= (t - Q2R first) * v) by (apply Rmult_le_pos; lra).
           assert (0 <= (Q2R last - t) * v) by (apply Rmult_le_pos; lra). lra.
        -- assert (0 <= (t - Q2R first) * - v) by (apply Rmult_le_pos; lra).
           assert (0 <= (Q2R last - t) * - v) by (apply Rmult_le_pos; lra). lra.
  - destruct h as (ln & far & h). rewrite of_length_means in ln. simpl in far. rewrite inner_means, leaves_mean in far.
    simpl. intros t [[t0 t1] b].
    assert (lt : length (at_time (values start) (values way) t) = length n) by (rewrite at_time_length; congruence).
    assert (g := highest_of_box_means n low high _ ltac:(congruence) ltac:(congruence) lt b).
    rewrite dot_at_time in g by congruence.
    destruct ends; simpl in h; rewrite ?inner_means, ?leaves_mean in h.
    + destruct t1 as [t1 _]. set (s := dot (rl n) (values start)) in *. set (m := dot (rl n) (values way)) in *.
      set (H := value Q2R (highest_of_box n low high)) in *.
      assert (0 <= t * (s + m - H)) by (apply Rmult_le_pos; lra).
      assert (0 <= (1 - t) * (s - H)) by (apply Rmult_le_pos; lra).
      destruct (Req_dec t 0) as [-> | nz]; [lra|]. assert (0 < t * (s + m - H)) by (apply Rmult_lt_0_compat; lra). lra.
    + assert (0 <= t * dot (rl n) (values way)) by (apply Rmult_le_pos; auto). lra.
Qed.
Lemma as_long_means : forall (x y : list Q), means Q2R (as_long x y) -> length x = length y.
Proof. intros x y h. unfold as_long in h. rewrite if_so_means, Nat.eqb_eq in h. exact h. Qed.
Theorem ray_aabb_sound : forall o d low high w facts, decide (check_ray_aabb o d low high w facts) = true ->
  ray_aabb_spec (rl o) (rl d) (rl low) (rl high) (r_times w).
Proof.
  intros o d low high w facts h. apply decide_means in h. destruct h as (b & ld & nz & h). apply is_box_means in b.
  apply as_long_means in ld. apply not_zero_means in nz. unfold ray_aabb_spec, ray_through. rewrite !rl_length.
  do 3 (split; [auto|]). destruct b as (_ & ll & lh & _). rewrite rl_length in ll, lh. apply ray_course.
  rewrite <- (leaves_mean o), <- (leaves_mean d). apply (box_passage_means false _ _ _ _ _ facts); auto;
    rewrite ?leaves_mean, ?rl_length; congruence.
Qed.
Theorem segment_aabb_sound : forall a b low high w facts, decide (check_segment_aabb a b low high w facts) = true ->
  segment_aabb_spec (rl a) (rl b) (rl low) (rl high) (r_times w).
Proof.
  intros a b low high w facts h. apply decide_means in h. destruct h as (x & lb & h). apply is_box_means in x.
  apply as_long_means in lb. unfold segment_aabb_spec, segment_through. rewrite !rl_length.
  do 2 (split; [auto|]). destruct x as (_ & ll & lh & _). rewrite rl_length in ll, lh.
  apply segment_course; [rewrite !rl_length; congruence|]. rewrite <- way_means, <- (leaves_mean a).
  apply (box_passage_means true _ _ _ _ _ facts); auto; try congruence.
  - rewrite leaves_mean, rl_length. congruence.
  - rewrite way_means, minus_length; rewrite !rl_length; congruence.
Qed.
Theorem ray_aabb_unique : forall o d low high v w, ray_aabb_spec o d low high v -> ray_aabb_spec o d low high w -> v =
  w.
Proof. intros o d low high v w (_ & _ & _ & g) (_ & _ & _ & h). apply (passage_unique _ _ _ g h). Qed.
Theorem segment_aabb_unique : forall a b low high v w,
  segment_aabb_spec a b low high v -> segment_aabb_spec a b low high w -> v = w.
Proof. intros a b low high v w (_ & _ & g) (_ & _ & h). apply (passage_unique _ _ _ g h). Qed.

(** ** Through balls *)
Definition r_surds (w : option (surd Q * surd Q)) : option (R * R) :=
  option_map (fun times => (r_surd (fst times), r_surd (snd times))) w.
Section polynomial.
Variables (c b a : R).
Let f (t : R) : R := c + b * t + a * (t * t).
Lemma before_falling_zero : forall t u, 0 < a -> f t = 0 -> b + 2 * a * t <= 0 -> u < t -> 0 < f u.
Proof.
  intros t u ha z d l. assert (0 < a * ((t - u) * (t - u))) by (apply Rmult_lt_0_compat; auto; apply
    Rmult_lt_0_compat; lra).
  assert (0 <= (t - u) * - (b + 2 * a * t)) by (apply Rmult_le_pos; lra). unfold f in *. lra.
Qed.
Lemma after_rising_zero : forall t u, 0 < a -> f t = 0 -> 0 <= b + 2 * a * t -> t < u -> 0 < f u.
Proof.
  intros t u ha z d l. assert (0 < a * ((u - t) * (u - t))) by (apply Rmult_lt_0_compat; auto; apply
    Rmult_lt_0_compat; lra).
  assert (0 <= (u - t) * (b + 2 * a * t)) by (apply Rmult_le_pos; lra). unfold f in *. lra.
Qed.
Lemma between_not_positive : forall s t u, 0 <= a -> f s <= 0 -> f u <= 0 -> s <= t <= u -> f t <= 0.
Proof.
  intros s t u ha hs hu i. destruct (Req_dec s u) as [e | ne].
  - assert (t = s) by lra. subst t. auto.
  - apply (Rmult_le_reg_l (u - s)); [lra|]. rewrite Rmult_0_r.
    replace ((u - s) * f t) with ((u - t) * f s + (t - s) * f u - a * ((t - s) * (u - t)) * (u - s)) by (unfold f;
      ring).
    assert (0 <= (u - t) * - f s) by (apply Rmult_le_pos; lra).
    assert (0 <= (t - s) * - f u) by (apply Rmult_le_pos; lra).
    assert (0 <= a * ((t - s) * (u - t)) * (u - s)).
    { apply Rmult_le_pos; [|lra]. apply Rmult_le_pos; auto. apply Rmult_le_pos; lra. }
    lra.
Qed.
End polynomial.
Lemma still_square : forall way, dot way way = 0 <-> still way.
Proof.
  intro way. split.
  - intros z v i. apply zero_vector in z. destruct (Req_dec v 0) as [|n]; auto. exfalso. apply z. exists v; auto.
  - unfold still. induction way as [|v way IH]; intro h; simpl; auto.
    rewrite (h v), IH; simpl; auto; [ring|]. intros u i. apply h. simpl; auto.
Qed.
Lemma ball_passage_means : forall (ends : bool) from way r w kind, length (values from) = length (values way) ->
  (ends = false -> nonzero (values way)) -> means Q2R (ball_passage_proves ends from way r w kind) ->
  passage_spec (fun t => course ends (values way) t /\
    dot (at_time (values from) (values way) t) (at_time (values from) (values way) t) <= Q2R r * Q2R r) (r_surds w).
Proof.
  intros ends from way r w kind l nz h. unfold ball_passage_proves in h. cbv zeta in h.
  set (C := (inner from from - Leaf r * Leaf r)%check) in *. set (B := (Num 2 * inner from way)%check) in *.
  set (Aq := inner way way) in *. set (c := value Q2R C). set (b := value Q2R B). set (a := value Q2R Aq).
  set (f := fun t => c + b * t + a * (t * t)).
  apply (passage_of_same (fun t => course ends (values way) t /\ f t <= 0)).
  { intro t. rewrite square_at_time by auto. unfold f, c, b, a, C, B, Aq. simpl. rewrite !inner_means.
    split; intros [p q]; (split; [exact p | lra]). }
  assert (ea : a = dot (values way) (values way)) by apply inner_means.
  assert (ha : 0 <= a) by (rewrite ea; apply dot_self).
  assert (moving : 0 < a -> ~ still (values way)) by (intros p s; apply still_square in s; lra).
  assert (goes : ends = false -> 0 < a) by (intro e; rewrite ea; apply dot_nonzero; auto).
  destruct w as [[[x y k] [x' y' k']] |], kind as [kind |]; try solve [destruct h].
  - destruct h as (hk & hk' & first & last). unfold r_surds, r_surd, surd_value. simpl option_map. simpl in hk, hk'.
    set (s := Q2R x + Q2R y * sqrt (Q2R k)). set (u := Q2R x' + Q2R y' * sqrt (Q2R k')). 
    assert (hf : s = 0 /\ c <= 0 \/ 0 < a /\ 0 < s /\ f s = 0 /\ b + 2 * a * s <= 0 /\ (if ends then s <= 1 else True)).
    { destruct first as [[z g] | (g & pos & z & d & e)].
      - left. apply (is_zero_means _ _ (Leaf k) hk) in z. split; [exact z | exact g].
      - right. change (~ means Q2R (not_positive (Leaf x) (Leaf y) (Leaf k))) in pos.
        rewrite (not_positive_means _ _ (Leaf k) hk) in pos. apply (zero_at_means _ _ _ _ _ (Leaf k) hk) in z.
        apply (falls_at_means _ _ _ _ (Leaf k) hk) in d. simpl in pos. fold s in pos.
        split; [exact g|]. split; [lra|]. split; [exact z|]. split; [exact d|].
        destruct ends; auto. apply (not_positive_means _ _ (Leaf k) hk) in e. simpl in e. unfold s. lra. }
    assert (hl : a = 0 /\ u = 0 \/ 0 < a /\ ends = true /\ u = 1 /\ f 1 <= 0 \/
      0 < a /\ 0 <= u /\ f u = 0 /\ 0 <= b + 2 * a * u /\ (if ends then u <= 1 else True)).
    { destruct last as [[g z] | [[g z] | (g & pos & z & d & e)]].
      - left. apply (is_zero_means _ _ (Leaf k') hk') in z. split; [exact g | exact z].
      - right; left. destruct ends; [|simpl in z; tauto]. destruct z as [z e].
        apply (is_zero_means _ _ (Leaf k') hk') in z. change (c + b + a <= 0) in e. simpl in z. unfold u, f.
        split; [exact g|]. split; [auto|]. lra.
      - right; right. apply (not_negative_means _ _ (Leaf k') hk') in pos.
        apply (zero_at_means _ _ _ _ _ (Leaf k') hk') in z. apply (rises_at_means _ _ _ _ (Leaf k') hk') in d.
        split; [exact g|]. split; [exact pos|]. split; [exact z|]. split; [exact d|].
        destruct ends; auto. apply (not_positive_means _ _ (Leaf k') hk') in e. simpl in e. unfold u. lra. }
    clearbody s u. clear first last.
    assert (f0 : f 0 = c) by (unfold f; ring).
    assert (fs : 0 <= s /\ f s <= 0) by (destruct hf as [[-> g] | g]; lra).
    assert (fu : 0 <= u /\ f u <= 0).
    { destruct hl as [[g ->] | [(g & _ & -> & g1) | g]]; [|lra|lra]. rewrite f0. split; [lra|].
      destruct hf as [g1 | g1]; lra. }
    assert (le : s <= u).
    { destruct hf as [[-> _] | (g & g1 & g2 & g3 & g4)]; [lra|].
      destruct hl as [g5 | [(_ & e & -> & _) | (_ & _ & _ & g5 & _)]]; [lra | rewrite e in g4; lra |].
      apply Rnot_lt_le; intro bad. assert (0 < a * (s - u)) by (apply Rmult_lt_0_compat; lra). lra. }
    simpl. split; [exact le|]. intro t. split.
    + intros [[t0 t1] ft]. split.
      * destruct hf as [[-> _] | (g & _ & z & d & _)]; [lra|]. apply Rnot_lt_le; intro bad.
        assert (q := before_falling_zero c b a s t g z d bad). change (0 < f t) in q. lra.
      * destruct hl as [[g ->] | [(g & e & -> & _) | (g & _ & z & d & _)]].
        -- destruct ends; [|specialize (goes eq_refl); lra]. destruct t1 as [_ t1]. rewrite t1; [lra|].
           apply still_square. lra.
        -- rewrite e in t1. lra.
        -- apply Rnot_lt_le; intro bad. assert (q := after_rising_zero c b a u t g z d bad). change (0 < f t) in q. lra.
    + intro i. split; [split; [lra|]|].
      * destruct ends; auto. split.
        -- destruct hl as [[_ ->] | [(_ & _ & -> & _) | g]]; lra.
        -- intro z. destruct hl as [[_ ->] | [(g & _) | (g & _)]]; [lra | apply moving in g; tauto ..].
      * apply (between_not_positive c b a s t u); tauto.
  - simpl. intros t [[t0 t1] g].
    assert (q : 0 < f t); [|lra]. apply (stays_positive_means (if ends then Yes else No) C B Aq kind t); auto.
    destruct ends; [intros _; tauto | intros []].
Qed.
Lemma ball_at_time : forall c r o d t, length o = length c -> length d = length c ->
  (ball c r (at_time o d t) <-> dot (at_time (minus o c) d t) (at_time (minus o c) d t) <= r * r).
Proof.
  intros c r o d t l1 l2. unfold ball. rewrite sqdist_sym, sqdist_dot by (rewrite at_time_length; congruence).
  assert (e : minus (at_time o d t) c = at_time (minus o c) d t); [|rewrite e; tauto].
  revert o d l1 l2. unfold at_time, times. induction c as [|a c IH]; intros [|b o] [|e d] l1 l2; simpl in *;
    try discriminate; auto.
  rewrite IH by lia. f_equal. ring.
Qed.
Lemma is_ball_means : forall n c r, means Q2R (is_ball n c r) -> proper_ball n (rl c) (Q2R r).
Proof.
  intros n c r (h & l & p). rewrite if_so_means, orb_true_iff, !Nat.eqb_eq in h. rewrite of_length_means in l.
  unfold proper_ball. rewrite rl_length. auto.
Qed.
Theorem ray_sphere_sound : forall o d c r w kind, decide (check_ray_sphere o d c r w kind) = true ->
  ray_sphere_spec (rl o) (rl d) (rl c) (Q2R r) (r_surds w).
Proof.
  intros o d c r w kind h. apply decide_means in h. destruct h as (b & ld & nz & h). apply is_ball_means in b.
  apply as_long_means in ld. apply not_zero_means in nz. unfold ray_sphere_spec, ray_through. rewrite !rl_length.
  do 3 (split; [auto|]). destruct b as (_ & lc & _). rewrite rl_length in lc. apply ray_course.
  apply ball_passage_means in h; rewrite ?difference_means, ?leaves_mean in *; auto.
  - eapply passage_of_same; [|exact h]. intro t. cbv beta. rewrite ball_at_time; [tauto | rewrite !rl_length;
      congruence ..].
  - rewrite minus_length; rewrite !rl_length; congruence.
Qed.
Theorem segment_sphere_sound : forall a b c r w kind, decide (check_segment_sphere a b c r w kind) = true ->
  segment_sphere_spec (rl a) (rl b) (rl c) (Q2R r) (r_surds w).
Proof.
  intros a b c r w kind h. apply decide_means in h. destruct h as (x & lb & h). apply is_ball_means in x.
  apply as_long_means in lb. unfold segment_sphere_spec, segment_through. rewrite !rl_length.
  do 2 (split; [auto|]). destruct x as (_ & lc & _). rewrite rl_length in lc.
  assert (lm : length (minus (rl b) (rl a)) = length (rl c)) by (rewrite minus_length; rewrite !rl_length; congruence).
  apply segment_course; [rewrite !rl_length; congruence|].
  apply ball_passage_means in h; rewrite ?difference_means, ?leaves_mean in *; [| |discriminate].
  - eapply passage_of_same; [|exact h]. intro t. cbv beta. rewrite ball_at_time; auto; [tauto|].
    rewrite !rl_length; congruence.
  - rewrite lm, minus_length; rewrite !rl_length; congruence.
Qed.
Theorem ray_sphere_unique : forall o d c r v w, ray_sphere_spec o d c r v -> ray_sphere_spec o d c r w -> v = w.
Proof. intros o d c r v w (_ & _ & _ & g) (_ & _ & _ & h). apply (passage_unique _ _ _ g h). Qed.
Theorem segment_sphere_unique : forall a b c r v w,
  segment_sphere_spec a b c r v -> segment_sphere_spec a b c r w -> v = w.
Proof. intros a b c r v w (_ & _ & g) (_ & _ & h). apply (passage_unique _ _ _ g h). Qed.

(** ** Boxes that move *)
Theorem swept_aabb_aabb_sound : forall la ha lb hb v w facts,
  decide (check_swept_aabb_aabb la ha lb hb v w facts) = true ->
  swept_aabb_aabb_spec (rl la) (rl ha) (rl lb) (rl hb) (rl v) (option_map Q2R w).
Proof.
  intros la ha lb hb v w facts h. apply decide_means in h. unfold check_swept_aabb_aabb in h. cbv zeta in h.
  destruct h as (ba & bb & h). apply is_box_means in ba, bb. unfold swept_aabb_aabb_spec. rewrite rl_length.
  split; [auto|]. split; [auto|]. destruct ba as (_ & l1 & l2 & _), bb as (_ & l3 & l4 & _). rewrite rl_length in *.
  assert (lv := rl_length v).
  assert (meets : forall p t, length p = length v -> means Q2R (box_holds lb hb (leaves p)) ->
    means Q2R (box_holds la ha (difference (leaves p) (scaled t (leaves v)))) ->
    exists x, length x = length v /\ box (rl la) (rl ha) x /\ box (rl lb) (rl hb) (at_time x (rl v) (value Q2R t))).
  { intros p t lp hb' ha'. apply box_holds_means in hb'; [|unfold leaves; rewrite map_length; congruence].
    assert (e : values (difference (leaves p) (scaled t (leaves v))) = minus (rl p) (times (value Q2R t) (rl v))).
    { rewrite difference_means, scaled_means, !leaves_mean. auto. }
    assert (lm : length (minus (rl p) (times (value Q2R t) (rl v))) = length v).
    { rewrite minus_length; rewrite times_length, !rl_length; congruence. }
    apply box_holds_means in ha'.
    - rewrite e in ha'. rewrite leaves_mean in hb'. exists (minus (rl p) (times (value Q2R t) (rl v))).
      split; [auto|]. split; [auto|]. unfold at_time. rewrite plus_minus; auto. rewrite times_length, !rl_length; auto.
    - rewrite <- (map_length (value Q2R)). fold (values (difference (leaves p) (scaled t (leaves v)))). congruence. }
  assert (bounds : forall n x t, length n = length v -> length x = length v -> box (rl la) (rl ha) x ->
    box (rl lb) (rl hb) (at_time x (rl v) t) ->
    value Q2R (lowest_of_box n lb hb) <= value Q2R (highest_of_box n la ha) + t * dot (rl n) (rl v)).
  { intros n x t ln lx ha' hb'.
    assert (g := highest_of_box_means n la ha x ltac:(congruence) ltac:(congruence) ltac:(congruence) ha').
    assert (lt : length (at_time x (rl v) t) = length n) by (rewrite at_time_length; congruence).
    assert (k := lowest_of_box_means n lb hb _ ltac:(congruence) ltac:(congruence) lt
      ltac:(intros k hk; apply hb'; congruence)).
    rewrite dot_at_time in k by congruence. lra. }
  destruct w as [t |], facts as [p | p n | n]; try (simpl in h; tauto).
  - destruct h as (z & lp & hb' & ha'). simpl in z. rewrite of_length_means in lp.
    simpl. split; [lra|]. split; [apply (meets p (Leaf t)); auto | intros; lra].
  - destruct h as (t0 & t1 & (lp & hb' & ha') & ln & sp & e). rewrite of_length_means in lp, ln. simpl in t0, t1, sp, e.
    rewrite inner_means, !leaves_mean in sp, e. simpl. split; [lra|]. split; [apply (meets p (Leaf t)); auto|].
    intros u hu (x & lx & ba & bb). assert (g := bounds n x u ln lx ba bb).
    assert (0 < (Q2R t - u) * dot (rl n) (rl v)) by (apply Rmult_lt_0_compat; lra). lra.
  - destruct h as (ln & e & f). rewrite of_length_means in ln. simpl in e, f. rewrite inner_means, !leaves_mean in f.
    simpl. intros u hu (x & lx & ba & bb). assert (g := bounds n x u ln lx ba bb).
    set (m := dot (rl n) (rl v)) in *. set (H := value Q2R (highest_of_box n la ha)) in *.
    set (L := value Q2R (lowest_of_box n lb hb)) in *.
    assert (0 <= (1 - u) * (L - H)) by (apply Rmult_le_pos; lra).
    assert (0 <= u * (L - H - m)) by (apply Rmult_le_pos; lra).
    destruct (Req_dec u 0) as [-> | nz]; [lra|]. assert (0 < u * (L - H - m)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.
Theorem swept_aabb_aabb_unique : forall la ha lb hb v x y,
  swept_aabb_aabb_spec la ha lb hb v x -> swept_aabb_aabb_spec la ha lb hb v y -> x = y.
Proof. intros la ha lb hb v x y (_ & _ & g) (_ & _ & h). apply (first_time_unique _ _ _ g h). Qed.
