(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of capsules and triangles are enough, and their specifications leave no choice. *)
Require Import Reals Qreals QArith Lra Lia List Arith Bool.
From Certificates Require Import solids hulls language formulas_vectors formulas_solids formulas_nearest
  formulas_capsules
  sound_solids sound_vectors sound_motion sound_nearest unique_solids.
Import ListNotations.
Open Scope R_scope.

(** ** Capsules *)
Definition flat (points : list (list R)) : Prop :=
  exists n c, length n = 3%nat /\ nonzero n /\ forall p, In p points -> dot n p = c.
Lemma flat_pair : forall p q, length p = 3%nat -> length q = 3%nat -> flat [p; q].
Proof.
  intros [|p1 [|p2 [|p3 [|]]]] [|q1 [|q2 [|q3 [|]]]] lp lq; try discriminate.
  destruct (Req_dec (p1 - q1) 0) as [z | z].
  - exists [1; 0; 0], p1. repeat split; [exists 1; split; [left; auto | lra]|].
    intros x [<- | [<- | []]]; simpl; lra.
  - exists [- (p2 - q2); p1 - q1; 0], (- (p2 - q2) * p1 + (p1 - q1) * p2). repeat split.
    { exists (p1 - q1). split; [right; left; auto | auto]. }
    intros x [<- | [<- | []]]; simpl; ring.
Qed.
Lemma flat_has_no_interior : forall points x, (forall p, In p points -> length p = 3%nat) -> flat points ->
  ~ interior 3 (capsule points 0) x.
Proof.
  intros points x hp (n & c & ln & nz & e) i.
  assert (all : forall y, hull 3 points y -> dot n y = c).
  { intros y hy. apply Rle_antisym.
    - assert (g : - c <= dot (times (-1) n) y).
      { apply (hull_above 3 points); auto. intros p ip. rewrite times_dot, (e p ip). lra. }
      rewrite times_dot in g. lra.
    - apply (hull_above 3 points); auto. intros p ip. rewrite (e p ip). lra. }
  assert (sub : forall y, length y = 3%nat -> capsule points 0 y -> dot n y = c).
  { intros y ly (z & hz & d). rewrite Rmult_0_l in d. assert (lz := hull_length _ _ _ hp hz).
    apply sqdist_zero in d; [|congruence]. subst; auto. }
  assert (a : interior 3 (half_space n (- c)) x).
  { apply (interior_subset 3 (capsule points 0)); auto. intros y ly h. unfold half_space. rewrite (sub y ly h). lra. }
  apply half_space_interior in a; auto. assert (lx := proj1 i). assert (k := interior_in _ _ _ i).
    apply (sub x lx) in k. lra.
Qed.

Section two_capsules.
Variables (a b : list (list R)) (x y : list R) (r s : R).
Hypothesis (pa : forall p, In p a -> length p = 3%nat) (pb : forall p, In p b -> length p = 3%nat).
Hypothesis (hx : hull 3 a x) (hy : hull 3 b y) (hr : 0 <= r) (hs : 0 <= s).
Let lx := hull_length 3 a x pa hx.
Let ly := hull_length 3 b y pb hy.
Hypothesis nearest_a : forall z, hull 3 a z -> 0 <= dot (minus x y) (minus z x).
Hypothesis nearest_b : forall z, hull 3 b z -> 0 <= dot (minus y x) (minus z y).

Lemma capsules_apart : (r + s) * (r + s) < sqdist x y -> forall z, length z = 3%nat -> ~ (capsule a r z /\
  capsule b s z).
Proof.
  intros far z lz [(p & hp & dp) (q & hq & dq)].
  assert (lp := hull_length _ _ _ pa hp). assert (lq := hull_length _ _ _ pb hq). rewrite (sqdist_sym q z) in dq.
  assert (t := triangle r s p q z ltac:(congruence) ltac:(congruence) hr hs dp dq).
  destruct (pair_nearest 3 x y p q lx ly lp lq) as [g _]; auto. lra.
Qed.

(** Planes through the capsules' common point, across the way between the nearest points *)
Lemma capsules_tangent : sqdist x y = (r + s) * (r + s) -> flat a -> forall z,
  ~ (interior 3 (capsule a r) z /\ capsule b s z).
Proof.
  intros e fa z [ia ib]. destruct (Req_dec (r + s) 0) as [zero | pos].
  { assert (r = 0) by lra. subst r. apply (flat_has_no_interior a z) in ia; auto. }
  set (n := minus y x). assert (ln : length n = 3%nat) by (unfold n; rewrite minus_length; congruence).
  assert (en : dot n n = (r + s) * (r + s)) by (unfold n; rewrite <- sqdist_dot by congruence; rewrite sqdist_sym;
    auto).
  assert (q : 0 < dot n n) by (rewrite en; apply Rmult_lt_0_compat; lra).
  assert (nz : nonzero n).
  { clear - q. induction n as [|c n IH]; simpl in q; [lra|]. destruct (Req_dec c 0) as [-> | h].
    - destruct IH as [d [i h]]; [lra|]. exists d. split; [right; auto | auto].
    - exists c. split; [left; auto | auto]. }
  assert (reach : forall p u t, length p = 3%nat -> length u = 3%nat -> 0 <= t -> sqdist p u <= t * t ->
    dot n u - dot n p <= t * (r + s) /\ dot n p - dot n u <= t * (r + s)).
  { intros p u t lp lu ht d. assert (c := cauchy n (minus u p)). rewrite minus_length in c by congruence.
    specialize (c ltac:(congruence)). rewrite dot_minus in c by congruence. rewrite <- sqdist_dot in c by congruence.
    rewrite (sqdist_sym u p), en in c. assert (rs : 0 <= r + s) by lra.
    assert (m : (r + s) * (r + s) * sqdist p u <= (r + s) * (r + s) * (t * t)) by (apply Rmult_le_compat_l; auto;
      apply square).
    assert (k : (dot n u - dot n p) * (dot n u - dot n p) <= (t * (r + s)) * (t * (r + s))) by lra.
    assert (tr : 0 <= t * (r + s)) by (apply Rmult_le_pos; auto).
    split; apply Rnot_lt_le; intro bad;
      [assert (w : (t * (r + s)) * (t * (r + s)) < (dot n u - dot n p) * (dot n u - dot n p)) by (apply
        Rmult_le_0_lt_compat; lra)
      |assert (w : (t * (r + s)) * (t * (r + s)) < (dot n p - dot n u) * (dot n p - dot n u)) by (apply
        Rmult_le_0_lt_compat; lra)];
      lra. }
  assert (ax : dot n y = dot n x + (r + s) * (r + s)) by (rewrite <- en; unfold n at 4;
    rewrite dot_minus by congruence; ring).
  assert (flip : forall v, dot (minus x y) v = - dot n v) by (intro v; unfold n; rewrite !minus_dot by congruence;
    ring).
  assert (ba : interior 3 (half_space n (- (dot n x + r * (r + s)))) z).
  { apply (interior_subset 3 (capsule a r)); auto. intros u lu (p & hp & d). assert (lp := hull_length _ _ _ pa hp).
    assert (g := nearest_a p hp). rewrite flip, dot_minus in g by congruence.
    destruct (reach p u r lp lu hr d) as [k _]. unfold half_space. lra. }
  apply half_space_interior in ba; auto.
  destruct ib as (p & hp & d). assert (lp := hull_length _ _ _ pb hp).
  assert (g := nearest_b p hp). fold n in g. rewrite dot_minus in g by congruence.
  destruct (reach p z s lp (proj1 ia) hs d) as [_ k]. lra.
Qed.
End two_capsules.

Lemma capsules_meet : forall a b x y r s, (forall p, In p a -> length p = 3%nat) -> (forall p,
  In p b -> length p = 3%nat) ->
  hull 3 a x -> hull 3 b y -> 0 <= r -> 0 <= s -> sqdist x y <= (r + s) * (r + s) ->
  exists z, length z = 3%nat /\ capsule a r z /\ capsule b s z.
Proof.
  intros a b x y r s pa pb hx hy hr hs d.
  destruct (proj2 (meet_iff 3 x r y s (hull_length _ _ _ pa hx) (hull_length _ _ _ pb hy) hr hs) d) as (z & lz & u & v).
  exists z. split; [auto|]. split; [exists x | exists y]; auto.
Qed.
Lemma capsules_overlap : forall a b x y r s, (forall p, In p a -> length p = 3%nat) -> (forall p,
  In p b -> length p = 3%nat) ->
  hull 3 a x -> hull 3 b y -> 0 < r -> 0 < s -> sqdist x y < (r + s) * (r + s) ->
  exists z, interior 3 (capsule a r) z /\ interior 3 (capsule b s) z.
Proof.
  intros a b x y r s pa pb hx hy hr hs d. assert (lx := hull_length _ _ _ pa hx).
    assert (ly := hull_length _ _ _ pb hy).
  set (k := s / (r + s)). set (z := further (- k) x y).
  assert (lz : length z = 3%nat) by (unfold z; rewrite further_length; congruence).
  assert (k1 : (1 + - k) * (r + s) = r) by (unfold k; field; lra).
  assert (k2 : k * (r + s) = s) by (unfold k; field; lra).
  assert (k0 : 0 < k) by (apply Rdiv_lt_0_compat; lra).
  assert (kr : 0 < 1 + - k).
  { apply (Rmult_lt_reg_r (r + s)); lra. }
  exists z. split.
  - apply (interior_subset 3 (ball x r)); [intros u _ h; exists x; auto|]. apply inside_ball; auto; [lra|].
    unfold z. rewrite further_away. replace (r * r) with ((1 + - k) * (1 + - k) * ((r + s) * (r + s)))
      by (transitivity (((1 + - k) * (r + s)) * ((1 + - k) * (r + s))); [ring | rewrite k1; auto]).
    apply Rmult_lt_compat_l; auto. apply Rmult_lt_0_compat; auto.
  - apply (interior_subset 3 (ball y s)); [intros u _ h; exists y; auto|]. apply inside_ball; auto; [lra|].
    unfold z. rewrite further_moved. replace (s * s) with (- k * - k * ((r + s) * (r + s)))
      by (transitivity ((k * (r + s)) * (k * (r + s))); [ring | rewrite k2; auto]).
    apply Rmult_lt_compat_l; auto. replace (- k * - k) with (k * k) by ring. apply Rmult_lt_0_compat; auto.
Qed.

Lemma hull_of_one : forall c x, length c = 3%nat -> (hull 3 [c] x <-> x = c).
Proof.
  intros [|c1 [|c2 [|c3 [|]]]] x len; try discriminate. split.
  - intros (w & lw & _ & one & ->). destruct w as [|t [|]]; try discriminate. simpl in one. simpl.
    assert (t = 1) by lra. subst t. repeat (f_equal; try ring).
  - intros ->. exists [1]. split; [auto|]. split; [intros a [<- | []]; lra|]. split; [simpl; ring|].
    simpl. repeat (f_equal; try ring).
Qed.
Lemma contact_of_same_sets : forall n S T S' T' w, (forall x, length x = n -> (S x <-> S' x)) ->
  (forall x, length x = n -> (T x <-> T' x)) -> contact_spec n S T w -> contact_spec n S' T' w.
Proof.
  intros n S T S' T' w hS hT.
  assert (iS : forall x, interior n S x <-> interior n S' x) by (intro; split; apply interior_subset; intros y l;
    apply hS; auto).
  assert (iT : forall x, interior n T x <-> interior n T' x) by (intro; split; apply interior_subset; intros y l;
    apply hT; auto).
  destruct w; simpl.
  - intros h x l [p q]. apply (h x l). split; [apply hS | apply hT]; auto.
  - intros [(x & l & p & q) h]. split.
    + exists x. split; [auto|]. split; [apply hS | apply hT]; auto.
    + intros y [p' q']. apply (h y). split; [apply iS | apply iT]; auto.
  - intros (x & p & q). exists x. split; [apply iS | apply iT]; auto.
Qed.

Lemma gap_means : forall a x b y r s w facts, points_of (length a) 3 (map rl a) -> points_of (length b) 3 (map rl b) ->
  flat (map rl a) -> flat (map rl b) -> hull 3 (map rl a) (values x) -> hull 3 (map rl b) (values y) ->
  0 <= Q2R r -> 0 <= Q2R s ->
  means Q2R (gap_proves a x b y (Leaf r + Leaf s)%check (Leaf r = zero \/ Leaf s = zero)%check w facts) ->
  contact_spec 3 (capsule (map rl a) (Q2R r)) (capsule (map rl b) (Q2R s)) w.
Proof.
  intros a x b y r s w facts pa pb fa fb hx hy hr hs h. assert (pa' := proj2 pa). assert (pb' := proj2 pb).
  assert (lx := hull_length _ _ _ pa' hx). assert (ly := hull_length _ _ _ pb' hy).
  unfold gap_proves, gap_decides in h. cbv zeta in h.
  assert (q : value Q2R (inner (difference x y) (difference x y)) = sqdist (values x) (values y)).
  { rewrite inner_means, difference_means, <- sqdist_dot; auto; congruence. }
  destruct w, facts; try (simpl in h; tauto).
  - destruct h as ((na & nb) & far). simpl in far. rewrite q in far.
    unfold contact_spec. apply (capsules_apart _ _ (values x) (values y)); auto;
      [apply (none_nearer_means 3 a) | apply (none_nearer_means 3 b)]; auto.
  - destruct h as ((na & nb) & e). simpl in e. rewrite q in e. split.
    + apply (capsules_meet _ _ (values x) (values y)); auto. lra.
    + intros z [i j]. apply interior_in in j.
      apply (capsules_tangent (map rl a) (map rl b) (values x) (values y) (Q2R r) (Q2R s)) with z; auto;
        [apply (none_nearer_means 3 a) | apply (none_nearer_means 3 b)]; auto.
  - destruct h as (e & z). simpl in e, z. rewrite q in e. split.
    + apply (capsules_meet _ _ (values x) (values y)); auto.
    + intros u [i j]. destruct z as [z | z]; rewrite z in *.
      * apply (flat_has_no_interior (map rl a) u) in i; auto.
      * apply (flat_has_no_interior (map rl b) u) in j; auto.
  - destruct h as (e & z). simpl in e, z. rewrite q in e.
    apply (capsules_overlap _ _ (values x) (values y)); auto; lra.
Qed.

Lemma flat_points : forall count points, points_of count 3 points -> (0 < count <= 2)%nat -> flat points.
Proof.
  intros count points [l h] c. destruct points as [|p [|q [|]]]; simpl in l; try lia.
  - destruct (flat_pair p p) as (n & d & g); try (apply h; simpl; auto). exists n, d. destruct g as (g1 & g2 & g3).
    repeat split; auto. intros x [<- | []]. apply g3; simpl; auto.
  - apply flat_pair; apply h; simpl; auto.
Qed.
Lemma counted : forall count n (points : list (list Q)), points_of count n (map rl points) ->
  points_of (length points) n (map rl points).
Proof. intros count n points [_ h]. split; [apply map_length | auto]. Qed.

Theorem capsule_capsule_sound : forall a r b s w facts on_a on_b,
  decide (check_capsule_capsule a r b s w facts on_a on_b) = true ->
  capsule_capsule_spec (map rl a) (Q2R r) (map rl b) (Q2R s) w.
Proof.
  intros a r b s w facts on_a on_b h. apply decide_means in h. destruct h as (pa & pb & hr & hs & wa & wb & h).
  apply points_mean in pa, pb. apply (weights_mean 3) in wa, wb. rewrite <- mixed_means in wa, wb. simpl in hr, hs.
  do 2 (split; [split; assumption|]).
  eapply gap_means; try exact h; try assumption; try (eapply counted; eauto); try (eapply flat_points; [eauto | lia]).
Qed.
Theorem sphere_capsule_sound : forall c r points s w facts weights,
  decide (check_sphere_capsule c r points s w facts weights) = true ->
  sphere_capsule_spec (rl c) (Q2R r) (map rl points) (Q2R s) w.
Proof.
  intros c r points s w facts weights h. apply decide_means in h. destruct h as (lc & pb & hr & hs & wb & h).
  rewrite of_length_means in lc. assert (lc' := rl_length c). rewrite lc in lc'.
  apply points_mean in pb. apply (weights_mean 3) in wb. rewrite <- mixed_means in wb. simpl in hr, hs.
  do 2 (split; [split; auto|]).
  assert (pc : points_of 1 3 (map rl [c])) by (split; [auto | intros p [<- | []]; auto]).
  apply (contact_of_same_sets 3 (capsule (map rl [c]) (Q2R r)) (capsule (map rl points) (Q2R s))); [|tauto|].
  - intros x _. unfold ball. split.
    + intros (y & hy & d). simpl in hy. rewrite (hull_of_one (rl c) y lc') in hy. subst y. auto.
    + intro d. exists (rl c). split; [apply hull_of_one; auto | auto].
  - eapply gap_means; try exact h; try assumption; try (eapply counted; eauto); try (eapply flat_points; [eauto | lia]).
    rewrite leaves_mean. apply hull_of_one; auto.
Qed.
Theorem capsule_capsule_unique : forall a r b s v w,
  capsule_capsule_spec a r b s v -> capsule_capsule_spec a r b s w -> v = w.
Proof. intros a r b s v w (_ & _ & g) (_ & _ & h). apply (contact_unique _ _ _ _ _ g h). Qed.
Theorem sphere_capsule_unique : forall c r b s v w, sphere_capsule_spec c r b s v -> sphere_capsule_spec c r b s w ->
  v = w.
Proof. intros c r b s v w (_ & _ & g) (_ & _ & h). apply (contact_unique _ _ _ _ _ g h). Qed.

(** ** Triangles *)
Lemma flat_contact_unique : forall F S v w, flat_contact_spec F S v -> flat_contact_spec F S w -> v = w.
Proof.
  intros F S [] [] g h; auto; exfalso; simpl in g, h.
  - destruct h as [(x & p & q) _]. apply (g x); auto.
  - destruct h as (x & p & q). apply (g x); auto. apply (interior_in 3); auto.
  - destruct g as [(x & p & q) _]. apply (h x); auto.
  - destruct g as [_ g], h as (x & p & q). apply (g x); auto.
  - destruct g as (x & p & q). apply (h x); auto. apply (interior_in 3); auto.
  - destruct h as [_ h], g as (x & p & q). apply (h x); auto.
Qed.
Theorem sphere_triangle_sound : forall c r points w facts weights,
  decide (check_sphere_triangle c r points w facts weights) = true ->
  sphere_triangle_spec (rl c) (Q2R r) (map rl points) w.
Proof.
  intros c r points w facts weights h. apply decide_means in h. destruct h as (lc & hr & pb & wb & h).
  rewrite of_length_means in lc. assert (lc' := rl_length c). rewrite lc in lc'.
  apply points_mean in pb. apply (weights_mean 3) in wb. rewrite <- mixed_means in wb. simpl in hr.
  split; [split; auto|]. split; [auto|]. set (y := values (mixed 3 weights points)) in *.
  assert (pb' := proj2 pb). assert (ly := hull_length _ _ _ pb' wb).
  unfold gap_proves, gap_decides in h. cbv zeta in h.
  assert (q : value Q2R (inner (difference (leaves c) (mixed 3 weights points)) (difference (leaves c) (mixed 3
    weights points))) = sqdist (rl c) y).
  { rewrite inner_means, difference_means, leaves_mean. fold y. rewrite <- sqdist_dot; auto; congruence. }
  assert (near : means Q2R (none_nearer points (mixed 3 weights points) (leaves c)) ->
    forall z, hull 3 (map rl points) z -> sqdist (rl c) y <= sqdist (rl c) z).
  { intros nb z hz. assert (lz := hull_length _ _ _ pb' hz).
    assert (g := none_nearer_means 3 points _ _ (counted _ _ _ pb) ly nb z hz). rewrite leaves_mean in g. fold y in g.
    apply nearest_by_angle; try congruence. rewrite minus_dot in * by congruence. lra. }
  destruct w, facts; try (simpl in h; tauto).
  - destruct h as ((_ & nb) & far). simpl in far. rewrite q in far. intros z hz b. unfold ball in b.
    assert (g := near nb z hz). lra.
  - destruct h as ((_ & nb) & e). simpl in e. rewrite q in e. split.
    + exists y. split; auto. unfold ball. lra.
    + intros z hz i. assert (g := near nb z hz). apply interior_ball in i; auto; lra.
  - destruct h as (e & z). simpl in e, z. rewrite q in e. split.
    + exists y. split; auto.
    + intros u _ i. apply interior_ball in i; auto. assert (g := sqdist_nonneg (rl c) u). rewrite z in i. lra.
  - destruct h as (e & z). simpl in e. rewrite q in e. exists y. split; auto. apply inside_ball; auto.
Qed.
Theorem sphere_triangle_unique : forall c r points v w,
  sphere_triangle_spec c r points v -> sphere_triangle_spec c r points w -> v = w.
Proof. intros c r points v w (_ & _ & g) (_ & _ & h). apply (flat_contact_unique _ _ _ _ g h). Qed.

Lemma lowest_of_box_means : forall n low high x, length low = length n -> length high = length n ->
  length x = length n ->
  (forall k, (k < length n)%nat -> nth k (rl low) 0 <= nth k x 0 <= nth k (rl high) 0) ->
  value Q2R (lowest_of_box n low high) <= dot (rl n) x.
Proof.
  induction n as [|c n IH]; intros [|l low] [|h high] [|a x] e1 e2 e3 b; simpl in *; try discriminate; try lra.
  assert (g := IH low high x ltac:(lia) ltac:(lia) ltac:(lia) ltac:(intros k hk; apply (b (S k)); lia)).
  assert (b0 := b O ltac:(lia)). simpl in b0.
  assert (m1 := Rmax_l (0 - Q2R c * Q2R l) (0 - Q2R c * Q2R h)).
    assert (m2 := Rmax_r (0 - Q2R c * Q2R l) (0 - Q2R c * Q2R h)).
  destruct (Rle_lt_dec 0 (Q2R c)).
  - assert (0 <= Q2R c * (a - Q2R l)) by (apply Rmult_le_pos; lra). lra.
  - assert (0 <= - Q2R c * (Q2R h - a)) by (apply Rmult_le_pos; lra). lra.
Qed.
Theorem triangle_aabb_sound : forall points low high w facts,
  decide (check_triangle_aabb points low high w facts) = true ->
  triangle_aabb_spec (map rl points) (rl low) (rl high) w.
Proof.
  intros points low high w facts h. apply decide_means in h. unfold check_triangle_aabb in h. cbv zeta in h.
  destruct h as (pb & ll & lh & v & h). apply points_mean in pb. rewrite of_length_means in ll, lh.
  unfold triangle_aabb_spec, triangle_with, proper_box. rewrite !rl_length. split; [|split; [auto|]].
  { do 3 (split; [auto|]). intros k hk. rewrite on_each_means in v. specialize (v k hk). simpl in v.
    rewrite !coordinate_means in v. auto. }
  assert (pb' := proj2 pb).
  assert (point : forall weights k, value Q2R (nth k (mixed 3 weights points) zero) = nth k (values (mixed 3 weights
    points)) 0).
  { intros weights k. change 0 with (value Q2R zero). unfold values. rewrite map_nth. auto. }
  assert (lowest : forall n x, length n = 3%nat -> length x = 3%nat -> box (rl low) (rl high) x ->
    value Q2R (lowest_of_box n low high) <= dot (rl n) x).
  { intros n x ln lx b. apply lowest_of_box_means; try congruence. intros k hk. apply b. congruence. }
  assert (in_box : forall weights, hull 3 (map rl points) (values (mixed 3 weights points)) ->
    means Q2R (on_each 3 (fun k => coordinate k low <= nth k (mixed 3 weights points) zero /\
      nth k (mixed 3 weights points) zero <= coordinate k high)%check) ->
    box (rl low) (rl high) (values (mixed 3 weights points))).
  { intros weights hy m k hk. rewrite (hull_length _ _ _ pb' hy) in hk. rewrite on_each_means in m. specialize (m k hk).
    simpl means in m. rewrite point, !coordinate_means in m. exact m. }
  destruct w, facts; try (simpl in h; tauto).
  - destruct h as (ln & _ & d & below). rewrite of_length_means in ln. rewrite all_means in below. simpl in d.
    intros x hx b. assert (g := lowest n x ln (hull_length _ _ _ pb' hx) b).
    assert (k : - Q2R offset <= dot (times (-1) (rl n)) x).
    { apply (hull_above 3 (map rl points)); auto. intros p i. apply in_map_iff in i. destruct i as [t [<- i]].
      specialize (below t i). simpl in below. rewrite inner_means, !leaves_mean in below. rewrite times_dot. lra. }
    rewrite times_dot in k. lra.
  - destruct h as (ln & nz & d & below & wb & b). rewrite of_length_means in ln. rewrite all_means in below. simpl in d.
    apply not_zero_means in nz. apply (weights_mean 3) in wb. rewrite <- mixed_means in wb. split.
    + exists (values (mixed 3 weights points)). split; auto.
    + intros x hx i.
      assert (k : - Q2R offset <= dot (times (-1) (rl n)) x).
      { apply (hull_above 3 (map rl points)); auto. intros p j. apply in_map_iff in j. destruct j as [t [<- j]].
        specialize (below t j). simpl in below. rewrite inner_means, !leaves_mean in below. rewrite times_dot. lra. }
      rewrite times_dot in k. assert (ln' := rl_length n). rewrite ln in ln'.
      assert (j : interior 3 (half_space (times (-1) (rl n)) (Q2R offset)) x).
      { apply (interior_subset 3 (box (rl low) (rl high))); auto. intros z lz bz. unfold half_space. rewrite times_dot.
        assert (g := lowest n z ln lz bz). lra. }
      apply half_space_interior in j.
      * rewrite times_dot in j. lra.
      * rewrite times_length; auto.
      * destruct nz as [c [ic nc]]. exists (-1 * c). split; [apply in_map; auto | lra].
  - destruct h as (k & e & wb & b). rewrite if_so_means, Nat.ltb_lt in k. simpl in e. rewrite !coordinate_means in e.
    apply (weights_mean 3) in wb. rewrite <- mixed_means in wb. split.
    + exists (values (mixed 3 weights points)). split; auto.
    + intros x _ i. assert (B := interior_box _ _ _ _ _ i k). lra.
  - destruct h as (wb & b). apply (weights_mean 3) in wb. rewrite <- mixed_means in wb.
    exists (values (mixed 3 weights points)). split; auto. rewrite <- (hull_length _ _ _ pb' wb) at 1. apply inside_box.
    intros k hk. rewrite (hull_length _ _ _ pb' wb) in hk. rewrite on_each_means in b. specialize (b k hk).
    simpl means in b. rewrite point, !coordinate_means in b. exact b.
Qed.
Theorem triangle_aabb_unique : forall points low high v w,
  triangle_aabb_spec points low high v -> triangle_aabb_spec points low high w -> v = w.
Proof. intros points low high v w (_ & _ & g) (_ & _ & h). apply (flat_contact_unique _ _ _ _ g h). Qed.
