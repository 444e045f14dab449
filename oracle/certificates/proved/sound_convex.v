(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of closed convex meshes are enough, and their specifications leave no choice. *)
Require Import Reals Qreals QArith Lra Lia List Arith Bool.
From Certificates Require Import hulls solids language formulas_vectors formulas_solids formulas_slabs formulas_bounds
  formulas_nearest formulas_triangles formulas_meshes sound_solids sound_vectors sound_slabs unique_slabs sound_nearest
  sound_bounds sound_hulls sound_meshes.
Import ListNotations.
Open Scope R_scope.

Lemma outer_product_means : forall p q, values (outer_product p q) = rcross (values p) (values q).
Proof. intros [|? [|? [|? [|? ?]]]] [|? [|? [|? [|? ?]]]]; reflexivity. Qed.
Lemma nth_corner : forall (vertices : list (list Q)) k, rl (nth k vertices nil) = nth k (map rl vertices) nil.
Proof. intros. rewrite <- (map_nth rl). reflexivity. Qed.
Lemma height_over_means : forall vertices face x,
  value Q2R (height_over vertices face x) = rheight (map rl vertices) face (values x).
Proof.
  intros vertices [|i [|j [|k [|]]]] x; try reflexivity. unfold height_over, rheight.
  rewrite inner_means, outer_product_means, !difference_means, !leaves_mean, !nth_corner. reflexivity.
Qed.
Lemma nonzero_of_square : forall x, dot x x <> 0 -> nonzero x.
Proof.
  induction x as [|a x IH]; simpl; intro h; [lra|]. destruct (Req_dec a 0) as [-> | n].
  - destruct IH as (b & i & nb); [lra|]. exists b. split; [right; auto | auto].
  - exists a. split; [left; auto | auto].
Qed.

(** ** The planes of the faces *)
Section mesh.
Variables (vertices : list (list R)) (faces : list (list nat)) (side : R).
Hypothesis lengths : forall v, In v vertices -> length v = 3%nat.
Hypothesis right : forall face, In face faces -> is_face (length vertices) face = true.
Hypothesis closed : is_closed faces = true.
Hypothesis some : faces <> [].
Hypothesis none_in_front : forall face v, In face faces -> In v vertices -> side * rheight vertices face v <= 0.
Hypothesis some_behind : forall face, In face faces ->
  exists v, In v vertices /\ side * rheight vertices face v < 0.
Lemma plane_of_face : forall face, In face faces -> exists normal offset, plane_of vertices face normal offset /\
  forall x, length x = 3%nat -> dot normal x + offset = side * rheight vertices face x.
Proof.
  intros face i. destruct (three_corners vertices faces right face i) as (a & b & c & -> & ia & ib & ic).
  assert (la := lengths _ ia). assert (lb := lengths _ ib). assert (lc := lengths _ ic).
  set (n := rcross (minus (nth b vertices nil) (nth a vertices nil)) (minus (nth c vertices nil) (nth a vertices nil))).
  assert (ln : length n = 3%nat) by (apply rcross_length; rewrite minus_length; congruence).
  assert (same : forall x, length x = 3%nat ->
    dot (times side n) x + - (side * dot n (nth a vertices nil)) = side * rheight vertices [a; b; c] x).
  { intros x lx. simpl. fold n. rewrite times_dot, dot_minus by congruence. ring. }
  exists (times side n), (- (side * dot n (nth a vertices nil))). split; [|exact same].
  split; [rewrite times_length; auto|]. split; [|split].
  - apply nonzero_of_square. intro z. destruct (some_behind _ i) as (v & iv & less). rewrite <- same in less by auto.
    assert (none : forall x, dot (times side n) x = 0)
      by (intro x; rewrite (zero_of_square (times side n) z), dot_sym; apply dot_zeros).
    rewrite none in less. assert (e := none (nth a vertices nil)). rewrite times_dot in e. lra.
  - intros k [<- | [<- | [<- | []]]]; rewrite same by auto; simpl; clear - la lb lc; revert la lb lc;
      generalize (nth a vertices nil) (nth b vertices nil) (nth c vertices nil); intros p q r lp lq lr; coordinates;
      simpl; ring.
  - intros v iv. unfold half_space. rewrite same by auto. apply none_in_front; auto.
Qed.
Lemma hull_is_behind : forall x face normal offset, plane_of vertices face normal offset -> hull 3 vertices x ->
  half_space normal offset x.
Proof.
  intros x face normal offset (ln & _ & _ & behind) hx. unfold half_space.
  assert (g := hull_above 3 vertices (times (-1) normal) offset x lengths hx).
  assert (h := g ltac:(intros p i; rewrite times_dot; specialize (behind p i); unfold half_space in behind; lra)).
  rewrite times_dot in h. lra.
Qed.
Lemma behind_faces_is_between : forall x, length x = 3%nat ->
  (forall face, In face faces -> side * rheight vertices face x <= 0) -> hull 3 vertices x.
Proof. intros x lx h. apply (behind_all_is_between vertices faces side); auto. Qed.
Lemma bounds_hull : convex_mesh vertices faces.
Proof.
  split; [exact lengths|]. split.
  - intros face i. destruct (plane_of_face face i) as (n & d & h & _). exists n, d. exact h.
  - intros x lx. split.
    + intros hx face n d _ h. apply (hull_is_behind x face); auto.
    + intro h. apply behind_faces_is_between; auto. intros face i. destruct (plane_of_face face i) as (n & d & hp & e).
      rewrite <- e by auto. apply (h face n d i hp).
Qed.
Lemma strictly_behind_is_inside : forall x, length x = 3%nat ->
  (forall face, In face faces -> side * rheight vertices face x < 0) -> interior 3 (hull 3 vertices) x.
Proof.
  intros x lx h.
  apply (interior_subset 3 (fun y => forall face, In face faces -> side * rheight vertices face y <= 0)).
  - intros y ly k. apply behind_faces_is_between; auto.
  - apply (interior_each 3 (fun face y => side * rheight vertices face y <= 0)); auto.
    intros face i. destruct (plane_of_face face i) as (n & d & (ln & _) & e).
    assert (k : interior 3 (half_space n d) x) by (apply interior_half_space; auto; rewrite e; auto).
    apply (interior_subset 3 (half_space n d)); auto. intros y ly hy. rewrite <- e by auto. exact hy.
Qed.
Lemma on_face_is_boundary : forall x face, length x = 3%nat -> In face faces -> rheight vertices face x = 0 ->
  ~ interior 3 (hull 3 vertices) x.
Proof.
  intros x face lx i z h. destruct (plane_of_face face i) as (n & d & hp & e). assert (nz := hp).
  destruct nz as (ln & nz & _).
  assert (k : dot n x + d < 0).
  { apply (half_space_interior 3); auto. apply (interior_subset 3 (hull 3 vertices)); auto.
    intros y ly hy. apply (hull_is_behind y face); auto. }
  rewrite e, z in k by auto. lra.
Qed.
End mesh.

Lemma right_mesh_means : forall side vertices faces, means Q2R (right_mesh vertices faces) ->
  means Q2R (convex_mesh_from side vertices faces) -> value Q2R side <> 0 ->
  (forall v, In v (map rl vertices) -> length v = 3%nat) /\
  (forall face, In face faces -> is_face (length (map rl vertices)) face = true) /\ is_closed faces = true /\
  faces <> [] /\
  (forall face v, In face faces -> In v (map rl vertices) -> value Q2R side * rheight (map rl vertices) face v <= 0) /\
  (forall face, In face faces -> exists v, In v (map rl vertices) /\
     value Q2R side * rheight (map rl vertices) face v < 0).
Proof.
  intros side vertices faces (lv & four & right & closed) h nz. rewrite all_means in lv. unfold convex_mesh_from in h.
  rewrite all_means in h. rewrite if_so_means in four, right, closed. rewrite Nat.leb_le in four.
  rewrite forallb_forall in right.
  assert (front : forall face v, In face faces -> In v (map rl vertices) ->
    value Q2R side * rheight (map rl vertices) face v <= 0).
  { intros face v i iv. apply in_map_iff in iv. destruct iv as (q & <- & iv). destruct (h face i) as [a _].
    rewrite all_means in a. specialize (a q iv). simpl in a. rewrite height_over_means, leaves_mean in a. exact a. }
  split; [|split; [|split; [|split; [|split]]]]; auto.
  - intros v i. apply in_map_iff in i. destruct i as (q & <- & i). specialize (lv q i). rewrite of_length_means in lv.
    rewrite rl_length; auto.
  - rewrite map_length. exact right.
  - destruct faces; [simpl in four; lia | discriminate].
  - intros face i. destruct (h face i) as [_ b].
    assert (dec : forall v, {rheight (map rl vertices) face v <> 0} + {~ rheight (map rl vertices) face v <> 0})
      by (intro v; destruct (Req_EM_T (rheight (map rl vertices) face v) 0); [right; tauto | left; auto]).
    destruct (Exists_dec _ (map rl vertices) dec) as [e | e].
    + apply Exists_exists in e. destruct e as (v & iv & ne). exists v. split; [auto|].
      assert (g := front face v i iv). assert (k : value Q2R side * rheight (map rl vertices) face v <> 0)
        by (apply Rmult_integral_contrapositive; auto). lra.
    + exfalso. apply b. apply all_means. intros q iq. simpl. rewrite height_over_means, leaves_mean.
      destruct (Req_dec (rheight (map rl vertices) face (rl q)) 0) as [z | z]; auto. exfalso. apply e.
      apply Exists_exists. exists (rl q). split; [apply in_map; auto | auto].
Qed.
Lemma between_some : forall vertices corners weights x, (forall v, In v (map rl vertices) -> length v = 3%nat) ->
  means Q2R (are_places vertices corners) -> means Q2R (are_weights weights (chosen_from vertices corners)) ->
  means Q2R (same_vector x (mixed 3 weights (chosen_from vertices corners))) -> hull 3 (map rl vertices) (values x).
Proof.
  intros vertices corners weights x lv hp hw e. apply (weights_mean 3) in hw.
  rewrite same_vector_means, mixed_means in e. rewrite <- e in hw.
  apply (hull_of_some 3 (map rl (chosen_from vertices corners))); auto.
  intros p i. apply in_map_iff in i. destruct i as (q & <- & i). apply in_map, (chosen_means _ corners); auto.
Qed.

Theorem point_in_convex_polyhedron_sound : forall vertices faces p w facts,
  decide (check_point_in_convex_polyhedron vertices faces p w facts) = true ->
  point_in_convex_polyhedron_spec (map rl vertices) faces (rl p) w.
Proof.
  intros vertices faces p w facts h. apply decide_means in h. unfold check_point_in_convex_polyhedron in h.
  cbv zeta in h. destruct h as (hm & lp & h). rewrite of_length_means in lp.
  assert (lp' : length (rl p) = 3%nat) by (rewrite rl_length; auto).
  assert (from : exists side, value Q2R side <> 0 /\ means Q2R (convex_mesh_from side vertices faces /\
    match w, facts with
    | outside, separating_face f =>
        at_index f faces (fun face => zero < side * height_over vertices face (leaves p))
    | outside, _ => No
    | _, barycentric corners weights =>
        let some := chosen_from vertices corners in
        let on_a_face := ~ all (fun face => ~ height_over vertices face (leaves p) = zero) faces in
        of_length 4 corners /\ are_places vertices corners /\ are_weights weights some /\
        same_vector (leaves p) (mixed 3 weights some) /\
        match w with boundary => on_a_face | _ => ~ on_a_face end
    | _, _ => No
    end)%check).
  { destruct h as [h | h]; [exists one | exists (zero - one)%check]; (split; [simpl; lra | exact h]). }
  clear h. destruct from as (side & nz & hc & h).
  destruct (right_mesh_means side vertices faces hm hc nz) as (lv & right & closed & some & front & behind).
  split; [apply (bounds_hull _ faces (value Q2R side)); auto|]. split; [exact lp'|].
  assert (height : forall face,
    value Q2R (height_over vertices face (leaves p)) = rheight (map rl vertices) face (rl p))
    by (intro face; rewrite height_over_means, leaves_mean; auto).
  destruct w, facts as [f | corners weights]; try solve [destruct h].
  - destruct h as (_ & hp & hw & e & off). apply (between_some vertices corners weights) in e; auto.
    rewrite leaves_mean in e. apply (strictly_behind_is_inside _ faces (value Q2R side)); auto. intros face i.
    destruct (plane_of_face _ _ _ lv right front behind face i) as (n & d & hpl & same).
    assert (le := hull_is_behind _ lv _ _ _ _ hpl e). unfold half_space in le. rewrite same in le by auto.
    assert (ne : rheight (map rl vertices) face (rl p) <> 0).
    { intro z. apply off. intro all_off. apply (proj1 (all_means _ _) all_off face i). simpl. rewrite height. exact z. }
    assert (k : value Q2R side * rheight (map rl vertices) face (rl p) <> 0)
      by (apply Rmult_integral_contrapositive; auto). lra.
  - destruct h as (_ & hp & hw & e & on). apply (between_some vertices corners weights) in e; auto.
    rewrite leaves_mean in e. split; [exact e|]. intro inside. apply on. apply all_means. intros face i z.
    simpl in z. rewrite height in z.
    apply (on_face_is_boundary _ _ _ lv right front behind (rl p) face lp' i z inside).
  - intro inside. apply at_index_means in h. destruct h as (face & i & less). simpl in less. rewrite height in less.
    destruct (plane_of_face _ _ _ lv right front behind face i) as (n & d & hpl & same).
    assert (le := hull_is_behind _ lv _ _ _ _ hpl inside). unfold half_space in le. rewrite same in le by auto. lra.
Qed.
Theorem point_in_convex_polyhedron_unique : forall vertices faces p v w,
  point_in_convex_polyhedron_spec vertices faces p v -> point_in_convex_polyhedron_spec vertices faces p w -> v = w.
Proof. intros vertices faces p v w [_ g] [_ h]. apply (location_unique _ _ _ _ _ g h). Qed.

(** ** Two solids *)
Lemma convex_means : forall vertices faces, means Q2R (right_mesh vertices faces /\
    (convex_mesh_from one vertices faces \/ convex_mesh_from (zero - one) vertices faces))%check ->
  convex_mesh (map rl vertices) faces /\ forall v, In v (map rl vertices) -> length v = 3%nat.
Proof.
  intros vertices faces [hm h].
  assert (from : exists side, value Q2R side <> 0 /\ means Q2R (convex_mesh_from side vertices faces)).
  { destruct h as [h | h]; [exists one | exists (zero - one)%check]; (split; [simpl; lra | exact h]). }
  destruct from as (side & nz & hc).
  destruct (right_mesh_means side vertices faces hm hc nz) as (lv & right & closed & some & front & behind).
  split; [apply (bounds_hull _ faces (value Q2R side)); auto | exact lv].
Qed.
Lemma none_before_means : forall points direction x, (forall p, In p (map rl points) -> length p = 3%nat) ->
  length (values x) = 3%nat -> means Q2R (none_before points direction x) -> forall z, hull 3 (map rl points) z ->
  0 <= dot (values direction) (minus z (values x)).
Proof.
  intros points direction x lp lx h z hz. assert (lz := hull_length _ _ _ lp hz). rewrite dot_minus by congruence.
  assert (g : dot (values direction) (values x) <= dot (values direction) z); [|lra].
  apply (hull_above 3 (map rl points)); auto. intros p i. assert (l := lp p i). apply in_map_iff in i.
  destruct i as (q & <- & i). unfold none_before in h. rewrite all_means in h. specialize (h q i). simpl in h.
  rewrite inner_means, difference_means, leaves_mean, dot_minus in h by congruence. lra.
Qed.
Definition r_pair (w : option (list Q * list Q)) : option (list R * list R) :=
  match w with Some (x, y) => Some (rl x, rl y) | None => None end.
Theorem convex_distance_sound : forall va fa vb fb w square distance facts,
  decide (check_convex_distance va fa vb fb w square distance facts) = true ->
  convex_distance_spec (map rl va) fa (map rl vb) fb (r_pair w) (Q2R square) (Q2R distance).
Proof.
  intros va fa vb fb w square distance facts h. apply decide_means in h. unfold check_convex_distance in h.
  cbv zeta in h. destruct h as (ha & hb & h). apply convex_means in ha, hb. destruct ha as [ca la], hb as [cb lb].
  split; [exact ca|]. split; [exact cb|].
  destruct w as [[x y]|], facts as [on_a on_b | on_a on_b first]; try solve [destruct h]; simpl r_pair; cbv iota.
  - destruct h as (wa & wb & ex & ey & na & nb & ne & lf & before_a & before_b & dist).
    apply (weights_mean 3) in wa, wb. rewrite same_vector_means, leaves_mean, mixed_means in ex, ey.
    rewrite <- ex in wa. rewrite <- ey in wb. rewrite of_length_means in lf.
    assert (lf' : length (rl first) = 3%nat) by (rewrite rl_length; auto).
    assert (lx := hull_length _ _ _ la wa). assert (ly := hull_length _ _ _ lb wb).
    assert (pa : points_of (length va) 3 (map rl va)) by (split; [apply map_length | exact la]).
    assert (pb : points_of (length vb) 3 (map rl vb)) by (split; [apply map_length | exact lb]).
    assert (lx' : length (values (leaves x)) = 3%nat) by (rewrite leaves_mean; exact lx).
    assert (ly' : length (values (leaves y)) = 3%nat) by (rewrite leaves_mean; exact ly).
    assert (na' := none_nearer_means 3 va (leaves x) (leaves y) pa lx' na).
    assert (nb' := none_nearer_means 3 vb (leaves y) (leaves x) pb ly' nb).
    assert (fa' := none_before_means va (leaves first) (leaves x) la lx' before_a).
    assert (fb' := none_before_means vb _ (leaves y) lb ly' before_b). clear lx' ly'.
    apply distance_means in dist; [|rewrite !leaves_mean; congruence].
    rewrite !leaves_mean in *. rewrite !difference_means, !leaves_mean in fb'.
    split; [|split; [|exact dist]].
    + intro e. apply ne. apply same_vector_means. rewrite !leaves_mean. exact e.
    + split; [exact wa|]. split; [exact wb|]. intros x' y' hx hy.
      assert (lx' := hull_length _ _ _ la hx). assert (ly' := hull_length _ _ _ lb hy).
      destruct (pair_nearest 3 (rl x) (rl y) x' y') as [g k]; auto. split; [exact g|]. intro e.
      assert (same := k ltac:(lra)). specialize (fa' x' hx). specialize (fb' y' hy).
      destruct va as [|a0 va].
      { destruct wa as ([|? ?] & lw & _ & one & _); [simpl in one; lra | discriminate]. }
      simpl hd in *. assert (la0 := la (rl a0) ltac:(simpl; auto)).
      assert (step : forall v, dot v y' - dot v (rl y) = dot v x' - dot v (rl x)).
      { intro v. assert (q : dot v (minus (rl x) (rl y)) = dot v (minus x' y')) by congruence.
        rewrite !dot_minus in q by congruence. lra. }
      rewrite dot_minus in fa', fb' by congruence. rewrite step in fb'.
      rewrite !minus_dot in fb' by (rewrite ?minus_length; congruence).
      rewrite !sqdist_dot, !square_of_difference by congruence.
      assert (s := dot_self (minus x' (rl x))). rewrite square_of_difference in s by congruence.
      rewrite (dot_sym x' (rl x)) in s. lra.
  - destruct h as (wa & wb & e & zs & zd). apply (weights_mean 3) in wa, wb.
    rewrite same_vector_means, !mixed_means in e. split; [|auto].
    exists (combined 3 (rl on_a) (map rl va)). split; [exact wa|]. rewrite e. exact wb.
Qed.
Theorem convex_distance_unique : forall va fa vb fb v s d w s' d', convex_distance_spec va fa vb fb v s d ->
  convex_distance_spec va fa vb fb w s' d' -> v = w /\ s = s' /\ d = d'.
Proof.
  intros va fa vb fb v s d w s' d' ([la _] & [lb _] & g) (_ & _ & h).
  assert (zero : forall x y, hull 3 va x -> hull 3 vb y -> sqdist x y <= 0 -> x = y).
  { intros x y hx hy. assert (lx := hull_length _ _ _ la hx). assert (ly := hull_length _ _ _ lb hy).
    apply sqdist_zero. congruence. }
  destruct v as [[x y]|], w as [[x' y']|].
  - destruct g as (_ & near & dist), h as (_ & near' & dist').
    assert (some : va <> []).
    { intros ->. destruct near as [([|? ?] & lw & _ & one & _) _]; [simpl in one; lra | discriminate]. }
    destruct (nearest_pair_unique 3 va vb x y x' y' la lb some near near') as [<- <-].
    destruct (distance_unique x y s d s' d' dist dist') as [<- <-]. auto.
  - exfalso. destruct g as (ne & (hx & hy & near) & _), h as ((z & ha & hb) & _). apply ne, zero; auto.
    destruct (near z z ha hb) as [k _]. rewrite sqdist_self in k. exact k.
  - exfalso. destruct h as (ne & (hx & hy & near) & _), g as ((z & ha & hb) & _). apply ne, zero; auto.
    destruct (near z z ha hb) as [k _]. rewrite sqdist_self in k. exact k.
  - destruct g as (_ & -> & ->), h as (_ & -> & ->). auto.
Qed.
