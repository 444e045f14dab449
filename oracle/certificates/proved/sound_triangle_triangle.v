(* SPDX-License-Identifier: Apache-2.0 *)
(** The formula of two triangles is enough, and its specification leaves no choice. *)
Require Import Reals Qreals QArith Lra Lia List Arith Bool.
From Certificates Require Import hulls solids response language formulas_vectors formulas_nearest formulas_triangles
  formulas_triangle_pairs sound_solids sound_vectors sound_nearest sound_courses sound_response sound_triangles
  sound_ray_triangle sound_triangle_pairs.
Import ListNotations.
Open Scope R_scope.

(** ** Vectors along others and across them *)
Lemma across_both : forall n d e : vec3 R, dot3 d n = 0 -> dot3 e n = 0 -> cross3 n (cross3 d e) = (0, 0, 0).
Proof.
  intros [[n0 n1] n2] [[d0 d1] d2] [[e0 e1] e2] h k. simpl in *. rewrite equal3. repeat split.
  - transitivity (d0 * (e0 * n0 + e1 * n1 + e2 * n2) - e0 * (d0 * n0 + d1 * n1 + d2 * n2)); [ring | rewrite h, k; ring].
  - transitivity (d1 * (e0 * n0 + e1 * n1 + e2 * n2) - e1 * (d0 * n0 + d1 * n1 + d2 * n2)); [ring | rewrite h, k; ring].
  - transitivity (d2 * (e0 * n0 + e1 * n1 + e2 * n2) - e2 * (d0 * n0 + d1 * n1 + d2 * n2)); [ring | rewrite h, k; ring].
Qed.
Lemma dot3_times : forall t d e, dot3 d (times3 t e) = t * dot3 d e.
Proof. intros t [[d0 d1] d2] [[e0 e1] e2]. simpl. ring. Qed.
Lemma times3_dot : forall t d e, dot3 (times3 t d) e = t * dot3 d e.
Proof. intros t [[d0 d1] d2] [[e0 e1] e2]. simpl. ring. Qed.
Lemma cross_multiples : forall s t d, cross3 (times3 s d) (times3 t d) = (0, 0, 0).
Proof. intros s t [[d0 d1] d2]. simpl. rewrite equal3. repeat split; ring. Qed.

Section common.
Variables (a b : list (@corner Q)) (x : list R).
Hypothesis (la : of_three a) (lb : of_three b) (xa : supported a x) (xb : supported b x).
Lemma three_corners : forall l, supported l x -> length l = 3%nat.
Proof. intros [|[p k] [|[q m] [|[r n] [|]]]] (u & v & w & h); simpl in h; tauto || auto. Qed.
Lemma along_parallel : forall l y e, of_three l -> supported l x -> ~ means Q2R (has_plane l) -> supported l y ->
  guarded l e -> cross3 (gap x y) e = (0, 0, 0).
Proof.
  intros l y e len hx h hy g. apply (ways_span l x y (fun d => cross3 d e = (0, 0, 0))); auto; [apply linear_cross|].
  intros d gd. apply (parallel l); auto.
Qed.
Lemma both_parallel : forall l y z, of_three l -> supported l x -> ~ means Q2R (has_plane l) -> supported l y ->
  supported l z -> cross3 (gap x y) (gap x z) = (0, 0, 0).
Proof.
  intros l y z len hx h hy hz. apply cross_turned.
  apply (ways_span l x z (fun d => cross3 d (gap x y) = (0, 0, 0))); auto; [apply linear_cross|].
  intros d gd. apply cross_turned. apply (along_parallel l); auto.
Qed.
Lemma across_normal : forall l y, of_three l -> supported l x -> supported l y -> dot3 (gap x y) (rnormal l) = 0.
Proof.
  intros l y len hx hy. apply (ways_span l x y (fun d => dot3 d (rnormal l) = 0)); auto; [apply linear_dot|].
  apply normal_means; auto. apply three_corners; auto.
Qed.
(** The way of the other triangle that leaves the plane of this one *)
Lemma leaves_means : forall l l', of_three l -> supported l x -> of_three l' -> means Q2R (leaves_plane l l') ->
  exists e, guarded l' e /\ dot3 e (rnormal l) <> 0.
Proof.
  intros l l' len hx len' h. destruct (some_way_means _ _ len' h) as (d & ld & g & n).
  exists (tri (values d)). split; [auto|]. intro z. apply n. simpl.
  destruct (normal_means l len (three_corners l hx)) as [ln _]. rewrite inner_three by auto. fold (rnormal l).
  destruct (rnormal l) as [[n0 n1] n2], (tri (values d)) as [[d0 d1] d2]. simpl in *. lra.
Qed.
Lemma on_line : means Q2R (at_most_line a b) -> forall y z, supported a y -> supported b y -> supported a z ->
  supported b z -> cross3 (gap x y) (gap x z) = (0, 0, 0).
Proof.
  intros h y z ya yb za zb. destruct h as [h | [h | h]].
  - apply (both_parallel a); auto.
  - apply (both_parallel b); auto.
  - destruct (decided (has_plane b)) as [pb | pb]; [|apply (both_parallel b); auto].
    destruct (leaves_means a b la xa lb h) as (e & ge & ne).
    destruct (nonzero_or_not (cross3 (gap x y) (gap x z))) as [|m]; auto. exfalso.
    set (M := cross3 (gap x y) (gap x z)) in *.
    assert (ca : cross3 (rnormal a) M = (0, 0, 0)) by (apply across_both; apply across_normal; auto).
    assert (cb : cross3 (rnormal b) M = (0, 0, 0)) by (apply across_both; apply across_normal; auto).
    apply along_normal in ca, cb; auto. destruct ca as [s es], cb as [t et].
    destruct (normal_means b lb (three_corners b xb)) as [lnb dots]. assert (eb := dots e ge).
    rewrite es, dot3_times in ne. rewrite et, dot3_times in eb.
    destruct (Rmult_integral _ _ eb) as [z0 | z0]; [|rewrite z0 in ne; lra].
    assert (zn : rnormal b = (0, 0, 0)).
    { rewrite et, z0. destruct M as [[m0 m1] m2]. simpl. rewrite equal3. repeat split; ring. }
    assert (lb3 := three_corners b xb). apply three_numbers in lb3. destruct lb3 as ([p k] & [q m'] & [r n] & eb3).
    rewrite eb3 in *. destruct pb as (_ & _ & _ & nz). apply nz. apply no_vector_three; auto.
Qed.
Lemma one_only : means Q2R (at_most_point a b) -> forall y, supported a y -> supported b y -> gap x y = (0, 0, 0).
Proof.
  intros h y ya yb.
  assert (none : forall l, of_three l -> supported l x -> supported l y -> ~ means Q2R (has_line l) ->
    gap x y = (0, 0, 0)).
  { intros l len hx hy n. apply (ways_span l x y (fun d => d = (0, 0, 0))); auto; [apply linear_zero|]. intros d g.
    destruct (no_way_means l _ len n d g) as (t & lt & <- & z). apply no_vector_three; auto.
    destruct (decided (no_vector t)) as [i | i]; auto. exfalso. apply z. exact i. }
  assert (leaving : forall l l', of_three l -> supported l x -> supported l y -> of_three l' -> supported l' x ->
    supported l' y -> ~ means Q2R (has_plane l') -> means Q2R (leaves_plane l l') -> gap x y = (0, 0, 0)).
  { intros l l' len hx hy len' hx' hy' n g. destruct (leaves_means l l' len hx len' g) as (e & ge & ne).
    destruct (nonzero_or_not (gap x y)) as [|m]; auto. exfalso.
    assert (c := cross_turned _ _ (along_parallel l' y e len' hx' n hy' ge)). apply along_normal in c; auto.
    destruct c as [t et]. apply ne. rewrite et, times3_dot, across_normal; auto. ring. }
  destruct h as [h | [h | [(na & nb & h) | [(_ & nb & h) | (_ & na & h)]]]].
  - apply (none a); auto.
  - apply (none b); auto.
  - destruct (some_way_means _ _ la h) as (d & ld & gd & h').
    destruct (some_way_means _ _ lb h') as (e & le & ge & n).
    destruct (nonzero_or_not (gap x y)) as [|m]; auto. exfalso.
    assert (ca := cross_turned _ _ (along_parallel a y _ la xa na ya gd)).
    assert (cb := cross_turned _ _ (along_parallel b y _ lb xb nb yb ge)).
    apply along_normal in ca, cb; auto. destruct ca as [s es], cb as [t et]. apply n.
    destruct (outer_means d e ld le) as [lo eo]. apply no_vector_three; auto. rewrite eo, es, et. apply cross_multiples.
  - apply (leaving a b); auto.
  - apply (leaving b a); auto.
Qed.
End common.

Lemma in_combined : forall {B C} (l : list B) (l' : list C) w, length l = length l' -> In w l -> exists u, In (w, u)
  (combine l l').
Proof.
  induction l as [|v l IH]; intros [|u l'] w e i; simpl in *; try discriminate; try tauto.
  destruct i as [-> | i]; [exists u; auto|]. destruct (IH l' w ltac:(lia) i) as [z hz]. exists z. auto.
Qed.
Lemma not_all : forall {B} (f : B -> cond Q) l, ~ means Q2R (all f l) -> exists x, In x l /\ ~ means Q2R (f x).
Proof.
  induction l as [|x l IH]; intro h; [exfalso; apply h; exact I|]. destruct (decided (f x)) as [y | y].
  - destruct IH as (z & i & n); [intro g; apply h; exact (conj y g) | exists z; simpl; auto].
  - exists x. simpl; auto.
Qed.
Lemma gap_zero : forall x y, length x = 3%nat -> length y = 3%nat -> gap x y = (0, 0, 0) -> y = x.
Proof.
  intros x y lx ly h. apply three_numbers in lx, ly. destruct lx as (a & b & c & ->), ly as (d & e & f & ->).
  unfold gap in h. simpl in h. rewrite equal3 in h. repeat (f_equal; try lra).
Qed.
Lemma equal_means : forall x y : list (term Q), length x = 3%nat -> length y = 3%nat ->
  (means Q2R (no_vector (difference x y)) <-> values x = values y).
Proof.
  intros x y lx ly. apply three_numbers in lx, ly. destruct lx as (a & b & c & ->), ly as (d & e & f & ->). simpl.
  split; [intros (h1 & h2 & h3 & _); repeat (f_equal; try lra) | intro h; injection h; intros; lra].
Qed.
Lemma area_means : forall x y z : list (term Q), length x = 3%nat -> length y = 3%nat -> length z = 3%nat ->
  (means Q2R (no_vector (outer_product (difference y x) (difference z x))) <->
   ways_cross (values x) (values y) (values z) = (0, 0, 0)).
Proof.
  intros x y z lx ly lz. apply three_numbers in lx, ly, lz. destruct lx as (a & b & c & ->), ly as (d & e & f & ->),
    lz as (g & h & i & ->). unfold ways_cross. simpl. rewrite equal3. tauto.
Qed.
Theorem triangle_triangle_sound : forall a b w planes on_a on_b,
  decide (check_triangle_triangle a b w planes on_a on_b) = true ->
  triangle_triangle_spec (map rl a) (map rl b) w.
Proof.
  intros a b w planes on_a on_b h. apply decide_means in h. unfold check_triangle_triangle in h. cbv zeta in h.
  destruct h as (pa & pb & lo & wa & wb & same & h). apply points_mean in pa, pb.
  rewrite if_so_means, Nat.eqb_eq in lo. rewrite all_means in wa. rewrite all_means in wb.
  rewrite all_means in same.
  unfold triangle_triangle_spec. do 2 (split; [assumption|]). cbv zeta.
  assert (start : forall l : list (list Q), points_of 3 3 (map rl l) -> of_three (map (fun p => (p, Yes)) l)).
  { intros l [_ hl] c i. apply in_map_iff in i. destruct i as (p & <- & i). simpl. rewrite <- rl_length. apply hl.
    apply in_map; auto. }
  destruct (cut_by_means _ _ _ _ (start a pa) (start b pb) h) as (a' & b' & la & lb & r & s). clear h start.
  set (both := fun x => hull 3 (map rl a) x /\ hull 3 (map rl b) x).
  assert (left_ : forall x, both x -> supported a' x /\ supported b' x).
  { intros x [hx hy]. apply s; apply hull_supported; auto. }
  assert (len : forall x, both x -> length x = 3%nat) by (intros x [hx _]; apply (hull_length 3 _ _ (proj2 pa) hx)).
  set (common := map (fun w => mixed 3 w a) on_a) in *.
  assert (held : forall t, In t common -> both (values t)).
  { intros t i. apply in_map_iff in i. destruct i as (v & <- & i).
    destruct (in_combined on_a on_b v lo i) as [u j]. assert (k := same _ j). simpl fst in k. simpl snd in k.
    assert (hv := weights_mean 3 _ _ (wa v i)). assert (hu := weights_mean 3 _ _ (wb u (in_combine_r _ _ _ _ j))).
    rewrite <- mixed_means in hv, hu. split; [exact hv|]. apply equal_means in k.
    - rewrite k. exact hu.
    - rewrite <- (map_length (value Q2R)). apply (hull_length 3 _ _ (proj2 pa) hv).
    - rewrite <- (map_length (value Q2R)). apply (hull_length 3 _ _ (proj2 pb) hu). }
  assert (len_t : forall t, In t common -> length t = 3%nat).
  { intros t i. rewrite <- (map_length (value Q2R)). apply len, held, i. }
  clear wa wb same lo s. clearbody common. fold both. destruct w, common as [|x others]; try (simpl in r; tauto).
  - intros x hx. destruct (left_ x hx) as [sa sb].
    assert (none : forall l, supported l x -> ~ means Q2R (all (fun c => ~ snd c)%check l)).
    { intros l (u & v & w & hl) n. rewrite all_means in n.
      destruct l as [|[p k] [|[q m] [|[o k'] [|]]]]; try (simpl in hl; tauto). simpl in hl.
      assert (n1 := n (p, k) ltac:(simpl; auto)). assert (n2 := n (q, m) ltac:(simpl; auto)).
      assert (n3 := n (o, k') ltac:(simpl; auto)). simpl in n1, n2, n3.
      destruct hl as (_ & _ & _ & one & _ & wa & wb & wc). destruct wa, wb, wc; try tauto. lra. }
    destruct r as [r | r]; [apply (none a' sa r) | apply (none b' sb r)].
  - destruct r as [_ r]. assert (hx := held x ltac:(simpl; auto)). destruct (left_ _ hx) as [sa sb].
    exists (values x). intro y. split; [|intros ->; exact hx]. intro hy. destruct (left_ y hy) as [ya yb].
    apply gap_zero; auto. apply (one_only a' b'); auto.
  - destruct r as (different & r & _). assert (hx := held x ltac:(simpl; auto)). destruct (left_ _ hx) as [sa sb].
    apply not_all in different. destruct different as (y & iy & ny).
    assert (hy := held y ltac:(simpl; auto)). destruct (left_ _ hy) as [ya yb].
    change (~ means Q2R (no_vector (difference x y))) in ny.
    rewrite equal_means in ny by (apply len_t; simpl; auto).
    split; [|exists (values x), (values y); auto].
    exists (values x), (minus (values y) (values x)). intros z hz. destruct (left_ z hz) as [za zb].
    assert (c := on_line a' b' (values x) la lb sa sb r z (values y) za zb ya yb).
    apply along_normal in c; [|intro e; apply ny; symmetry; apply gap_zero; auto]. destruct c as [t e]. exists t.
    assert (lx := len _ hx). assert (ly := len _ hy). assert (lz := len _ hz). revert e.
    apply three_numbers in lx, ly, lz. destruct lx as (x0 & x1 & x2 & ->), ly as (y0 & y1 & y2 & ->),
      lz as (z0 & z1 & z2 & ->). unfold gap. simpl. rewrite equal3. unfold at_time, times. simpl. intros (e0 & e1 & e2).
    repeat (f_equal; try lra).
  - intro l. apply not_all in r. destruct r as (y & iy & r). apply not_all in r. destruct r as (z & iz & r). apply r.
    apply area_means; try (apply len_t; simpl; auto).
    apply (line_has_no_area both); auto; try (apply len); apply held; simpl; auto.
Qed.
Lemma same_place : forall x, plus x (times 0 x) = x.
Proof. induction x as [|c x IH]; simpl; auto. fold (times 0 x). rewrite IH. f_equal. ring. Qed.
Theorem triangle_triangle_unique : forall a b v w, triangle_triangle_spec a b v -> triangle_triangle_spec a b w ->
  v = w.
Proof.
  intros a b v w (_ & _ & g) (_ & _ & h). cbv zeta in g, h.
  set (both := fun x => hull 3 a x /\ hull 3 b x) in *.
  assert (no_line : (forall x, ~ both x) -> on_one_line both).
  { intro n. exists [], []. intros y hy. exfalso. apply (n y hy). }
  assert (one_line : (exists x, forall y, both y <-> y = x) -> on_one_line both).
  { intros [x n]. exists x, x. intros y hy. exists 0. apply n in hy. rewrite hy. symmetry. apply same_place. }
  destruct v, w; auto; exfalso.
  - destruct h as [x h]. apply (g x), h; auto.
  - destruct h as (_ & x & _ & hx & _). apply (g x hx).
  - apply h, no_line, g.
  - destruct g as [x g]. apply (h x), g; auto.
  - destruct g as [x g], h as (_ & y & z & hy & hz & n). apply g in hy, hz. congruence.
  - apply h, one_line, g.
  - destruct g as (_ & x & _ & hx & _). apply (h x hx).
  - destruct h as [x h], g as (_ & y & z & hy & hz & n). apply h in hy, hz. congruence.
  - apply h, g.
  - apply g, no_line, h.
  - apply g, one_line, h.
  - apply g, h.
Qed.
