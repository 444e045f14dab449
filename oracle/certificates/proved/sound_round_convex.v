(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of a ball or a capsule and a convex mesh are enough, and their specifications leave no choice. *)
Require Import Reals Qreals QArith Lra Lia List Arith Bool.
From Certificates Require Import hulls solids language formulas_vectors formulas_solids formulas_slabs formulas_bounds
  formulas_nearest formulas_triangles formulas_capsules formulas_meshes sound_solids sound_vectors sound_slabs
  unique_solids unique_slabs sound_nearest sound_bounds sound_hulls sound_meshes sound_capsules sound_round
  sound_convex.
Import ListNotations.
Open Scope R_scope.

(** ** Points of a mesh's interior *)
Section mesh.
Variables (vertices : list (list R)) (faces : list (list nat)) (side : R).
Hypothesis lengths : forall v, In v vertices -> length v = 3%nat.
Hypothesis right : forall face, In face faces -> is_face (length vertices) face = true.
Hypothesis closed : is_closed faces = true.
Hypothesis some : faces <> [].
Hypothesis none_in_front : forall face v, In face faces -> In v vertices -> side * rheight vertices face v <= 0.
Hypothesis some_behind : forall face, In face faces ->
  exists v, In v vertices /\ side * rheight vertices face v < 0.
Let height face x := side * rheight vertices face x.

Lemma height_between : forall face x y t, In face faces -> length x = 3%nat -> length y = 3%nat ->
  height face (plus x (times t (minus y x))) = (1 - t) * height face x + t * height face y.
Proof.
  intros face x y t i lx ly. unfold height.
  destruct (plane_of_face _ _ _ lengths right none_in_front some_behind face i) as (n & d & _ & e).
  assert (lm : length (minus y x) = 3%nat) by (rewrite minus_length; congruence).
  rewrite <- !e; auto.
  - rewrite dot_plus, dot_times, dot_minus by (rewrite ?times_length; congruence). ring.
  - rewrite plus_length; rewrite times_length; congruence.
Qed.
(** Half way from what is behind some of the faces to a vertex behind one more *)
Lemma some_point_inside : exists x, length x = 3%nat /\ forall face, In face faces -> height face x < 0.
Proof.
  assert (g : forall some, incl some faces -> exists x, length x = 3%nat /\
    (forall face, In face faces -> height face x <= 0) /\ forall face, In face some -> height face x < 0).
  { induction some0 as [|face l IH]; intro within.
    - destruct faces as [|f fs] eqn:ef; [congruence|].
      destruct (some_behind f ltac:(left; auto)) as (v & iv & _). exists v. split; [auto|]. split.
      + intros face i. apply none_in_front; auto.
      + intros face [].
    - destruct IH as (x & lx & behind & inside); [intros f i; apply within; simpl; auto|].
      assert (i0 : In face faces) by (apply within; simpl; auto).
      destruct (some_behind face i0) as (v & iv & less). assert (lv := lengths v iv).
      exists (plus x (times (1 / 2) (minus v x))).
      split; [rewrite plus_length; rewrite times_length, minus_length; congruence|]. split.
      + intros f i. rewrite height_between by auto. assert (a := behind f i). assert (b := none_in_front f v i iv).
        fold (height f v) in b. lra.
      + intros f [<- | i].
        * rewrite height_between by auto. assert (a := behind face i0). fold (height face v) in less. lra.
        * assert (j : In f faces) by (apply within; simpl; auto). rewrite height_between by auto.
          assert (a := inside f i). assert (b := none_in_front f v j iv). fold (height f v) in b. lra. }
  destruct (g faces (incl_refl _)) as (x & lx & _ & h). exists x. auto.
Qed.
(** If a point of the solid is inside of a ball, there are points of its interior that are. *)
Lemma ball_reaches_solid : forall p r y, length p = 3%nat -> 0 <= r -> hull 3 vertices y -> sqdist p y < r * r ->
  exists z, interior 3 (ball p r) z /\ interior 3 (hull 3 vertices) z.
Proof.
  intros p r y lp hr hy near. assert (ly := hull_length _ _ _ lengths hy).
  destruct some_point_inside as (c & lc & inside).
  assert (lm : length (minus y c) = 3%nat) by (rewrite minus_length; congruence).
  assert (same : plus c (minus y c) = y).
  { clear - lc ly. coordinates. simpl. repeat (f_equal; try ring). }
  destruct (nearer_on_the_way p r c (minus y c)) as (t & ht & m); [congruence | congruence | rewrite same; auto |].
  exists (plus c (times (1 - t) (minus y c))).
  assert (lz : length (plus c (times (1 - t) (minus y c))) = 3%nat)
    by (rewrite plus_length; rewrite times_length; congruence).
  split; [apply inside_ball; auto|].
  apply (strictly_behind_is_inside vertices faces side); auto. intros face i.
  change (height face (plus c (times (1 - t) (minus y c))) < 0). rewrite height_between by auto.
  assert (a := inside face i). assert (b : height face y <= 0).
  { destruct (plane_of_face _ _ _ lengths right none_in_front some_behind face i) as (n & d & hp & e).
    assert (k := hull_is_behind vertices lengths y face n d hp hy). unfold half_space in k. rewrite e in k; auto. }
  assert (0 < t * - height face c) by (apply Rmult_lt_0_compat; lra).
  assert (0 <= (1 - t) * - height face y) by (apply Rmult_le_pos; lra). lra.
Qed.
End mesh.

(** ** Their contact *)
Lemma round_means : forall points x r va fa w facts weights, points_of (length points) 3 (map rl points) ->
  flat (map rl points) -> hull 3 (map rl points) (values x) ->
  means Q2R (round_meets points x r va fa w facts weights) -> 0 <= Q2R r /\ convex_mesh (map rl va) fa /\
  contact_spec 3 (capsule (map rl points) (Q2R r)) (hull 3 (map rl va)) w.
Proof.
  intros points x r va fa w facts weights pa fp hx (hr & mesh & wb & h). simpl in hr. split; [assumption|].
  destruct (convex_means va fa mesh) as [convex lb]. split; [exact convex|].
  apply (weights_mean 3) in wb. rewrite <- mixed_means in wb. set (y := mixed 3 weights va) in *.
  assert (pa' := proj2 pa). assert (lx := hull_length _ _ _ pa' hx). assert (ly := hull_length _ _ _ lb wb).
  assert (pb : points_of (length va) 3 (map rl va)) by (split; [apply map_length | exact lb]).
  unfold gap_proves, gap_decides in h. cbv zeta in h.
  assert (q : value Q2R (inner (difference x y) (difference x y)) = sqdist (values x) (values y)).
  { rewrite inner_means, difference_means, <- sqdist_dot; auto; congruence. }
  assert (nb : means Q2R (none_nearer va y x) -> forall v, length v = 3%nat -> hull 3 (map rl va) v ->
    0 <= dot (minus (values y) (values x)) (minus v (values y)))
    by (intros n v _ hv; apply (none_nearer_means 3 va); auto).
  destruct w, facts; try (simpl in h; tauto).
  - destruct h as ((na & n) & far). simpl in far. rewrite q in far. unfold contact_spec.
    apply (set_apart (map rl points) _ (values x) (values y)); auto. apply (none_nearer_means 3 points); auto.
  - destruct h as ((na & n) & e). simpl in e. rewrite q in e. split.
    + exists (values y). split; [auto|]. split; [exists (values x); split; [auto | lra] | auto].
    + intros z [i j]. apply interior_in in j.
      apply (set_tangent (map rl points) (hull 3 (map rl va)) (values x) (values y) (Q2R r)) with z; auto.
      apply (none_nearer_means 3 points); auto.
  - destruct h as (e & z). simpl in e, z. rewrite q in e. split.
    + exists (values y). split; [auto|]. split; [exists (values x); split; [auto | lra] | auto].
    + intros v [i _]. rewrite z in i. apply (flat_has_no_interior (map rl points) v) in i; auto.
  - destruct h as (e & _). simpl in e. rewrite q in e. destruct mesh as [hm hc].
    assert (from : exists side, value Q2R side <> 0 /\ means Q2R (convex_mesh_from side va fa)).
    { destruct hc as [c | c]; [exists one | exists (zero - one)%check]; (split; [simpl; lra | exact c]). }
    destruct from as (side & nz & c).
    destruct (right_mesh_means side va fa hm c nz) as (lv & right & closed & some & front & behind).
    destruct (ball_reaches_solid (map rl va) fa (value Q2R side)) with (p := values x) (r := Q2R r) (y := values y)
      as (z & i & j); auto.
    exists z. split; [|exact j]. apply (interior_subset 3 (ball (values x) (Q2R r))); auto.
    intros u _ hb. exists (values x). auto.
Qed.

Theorem capsule_convex_sound : forall points r va fa w facts on_a on_b,
  decide (check_capsule_convex points r va fa w facts on_a on_b) = true ->
  capsule_convex_spec (map rl points) (Q2R r) (map rl va) fa w.
Proof.
  intros points r va fa w facts on_a on_b h. apply decide_means in h. destruct h as (pa & wa & h).
  apply points_mean in pa. apply (weights_mean 3) in wa. rewrite <- mixed_means in wa.
  assert (fp : flat (map rl points)) by (eapply flat_points; [eauto | lia]).
  destruct (round_means _ _ _ _ _ _ _ _ (counted _ _ _ pa) fp wa h) as (hr & convex & c).
  split; [exact convex|]. split; [split; assumption | exact c].
Qed.
Theorem sphere_convex_sound : forall c r va fa w facts weights,
  decide (check_sphere_convex c r va fa w facts weights) = true ->
  sphere_convex_spec (rl c) (Q2R r) (map rl va) fa w.
Proof.
  intros c r va fa w facts weights h. apply decide_means in h. destruct h as (lc & h).
  rewrite of_length_means in lc. assert (lc' := rl_length c). rewrite lc in lc'.
  assert (pc : points_of 1 3 (map rl [c])) by (split; [auto | intros p [<- | []]; auto]).
  assert (fp : flat (map rl [c])) by (eapply flat_points; [eauto | lia]).
  assert (hx : hull 3 (map rl [c]) (values (leaves c))) by (rewrite leaves_mean; apply hull_of_one; auto).
  destruct (round_means _ _ _ _ _ _ _ _ (counted _ _ _ pc) fp hx h) as (hr & convex & k).
  split; [split; auto|]. split; [exact convex|].
  apply (contact_of_same_sets 3 (capsule (map rl [c]) (Q2R r)) (hull 3 (map rl va))); [|tauto | exact k].
  intros x _. unfold ball. split.
  - intros (y & hy & d). simpl in hy. rewrite (hull_of_one (rl c) y lc') in hy. subst y. auto.
  - intro d. exists (rl c). split; [apply hull_of_one; auto | auto].
Qed.
Theorem capsule_convex_unique : forall points r va fa v w, capsule_convex_spec points r va fa v ->
  capsule_convex_spec points r va fa w -> v = w.
Proof. intros points r va fa v w (_ & _ & g) (_ & _ & h). apply (contact_unique _ _ _ _ _ g h). Qed.
Theorem sphere_convex_unique : forall c r va fa v w, sphere_convex_spec c r va fa v ->
  sphere_convex_spec c r va fa w -> v = w.
Proof. intros c r va fa v w (_ & _ & g) (_ & _ & h). apply (contact_unique _ _ _ _ _ g h). Qed.
