(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of segments and rays that meet triangles are enough, and their specifications leave no choice. *)
Require Import Reals Qreals QArith Lra Lia List Arith Bool.
From Certificates Require Import hulls motion solids response language formulas_vectors formulas_solids formulas_heights
  formulas_nearest formulas_triangles sound_solids sound_vectors sound_heights sound_nearest sound_motion sound_courses
  sound_response.
Import ListNotations.
Open Scope R_scope.

(** ** Triangles, written out *)
Lemma three_numbers : forall {B} (p : list B), length p = 3%nat -> exists a b c, p = [a; b; c].
Proof. intros B [|a [|b [|c [|]]]] len; try discriminate. exists a, b, c; auto. Qed.
Lemma mixture_three : forall P p q r x, length p = 3%nat -> length q = 3%nat -> length r = 3%nat ->
  (mixture P 3 [p; q; r] x <-> exists a b c, P a /\ P b /\ P c /\ a + b + c = 1 /\
   x = [a * nth 0 p 0 + b * nth 0 q 0 + c * nth 0 r 0; a * nth 1 p 0 + b * nth 1 q 0 + c * nth 1 r 0;
        a * nth 2 p 0 + b * nth 2 q 0 + c * nth 2 r 0]).
Proof.
  intros P p q r x lp lq lr. apply three_numbers in lp, lq, lr. destruct lp as (p0 & p1 & p2 & ->),
    lq as (q0 & q1 & q2 & ->), lr as (r0 & r1 & r2 & ->). split.
  - intros (w & lw & pos & one & ->). apply three_numbers in lw. destruct lw as (a & b & c & ->). exists a, b, c.
    do 3 (split; [apply pos; simpl; auto|]). simpl in one. split; [lra|]. simpl. repeat (f_equal; try ring).
  - intros (a & b & c & ha & hb & hc & one & ->). exists [a; b; c]. split; [auto|]. split; [|split].
    + intros t [<- | [<- | [<- | []]]]; auto.
    + simpl. lra.
    + simpl. repeat (f_equal; try ring).
Qed.
Lemma three_points : forall points, points_of 3 3 points -> exists p q r, points = [p; q; r] /\ length p = 3%nat /\
  length q = 3%nat /\ length r = 3%nat.
Proof.
  intros points [l h]. apply three_numbers in l. destruct l as (p & q & r & ->). exists p, q, r.
  split; [auto|]. repeat split; apply h; simpl; auto.
Qed.
Lemma hull_between : forall points start way s t u, points_of 3 3 points -> length start = length way ->
  hull 3 points (at_time start way s) -> hull 3 points (at_time start way u) -> s <= t <= u ->
  hull 3 points (at_time start way t).
Proof.
  intros points start way s t u hp l hs hu i. destruct (Req_dec s u) as [e | ne].
  { replace t with s by lra. auto. }
  assert (ls := hull_length _ _ _ (proj2 hp) hs). rewrite at_time_length in ls by auto.
  apply three_points in hp. destruct hp as (p & q & r & -> & lp & lq & lr).
  apply mixture_three in hs, hu; auto. destruct hs as (a & b & c & ha & hb & hc & one & e),
    hu as (a' & b' & c' & ha' & hb' & hc' & one' & e').
  apply (mixture_three (Rle 0)); auto. set (k := (t - s) / (u - s)).
  assert (tk : t = s + k * (u - s)) by (unfold k; field; lra).
  assert (k0 : 0 <= k) by (apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; lra]).
  assert (k1 : k <= 1) by (apply (Rmult_le_reg_r (u - s)); lra).
  assert (mixed : forall x y, 0 <= x -> 0 <= y -> 0 <= (1 - k) * x + k * y).
  { intros x y hx hy. assert (0 <= (1 - k) * x) by (apply Rmult_le_pos; lra).
    assert (0 <= k * y) by (apply Rmult_le_pos; lra). lra. }
  exists ((1 - k) * a + k * a'), ((1 - k) * b + k * b'), ((1 - k) * c + k * c').
  do 3 (split; [apply mixed; auto|]). split; [transitivity ((1 - k) * (a + b + c) + k * (a' + b' + c')); [ring |
    rewrite one, one'; ring]|].
  assert (lst : length start = 3%nat) by congruence. apply three_numbers in lst, ls.
  destruct lst as (x0 & x1 & x2 & ->), ls as (v0 & v1 & v2 & ->). unfold at_time, times in *. simpl in e, e'.
  injection e; intros e2 e1 e0. injection e'; intros f2 f1 f0. simpl map. simpl plus.
  assert (only : forall x v g h, x + s * v = g -> x + u * v = h -> x + t * v = (1 - k) * g + k * h).
  { intros x v g h <- <-. rewrite tk. ring. }
  f_equal; [|f_equal; [|f_equal]].
  - rewrite (only _ _ _ _ e0 f0). ring.
  - rewrite (only _ _ _ _ e1 f1). ring.
  - rewrite (only _ _ _ _ e2 f2). ring.
Qed.

(** ** A plane that has no corner in front *)
Lemma hull_below : forall points n d x, (forall p, In p points -> length p = 3%nat) ->
  (forall p, In p points -> dot n p <= d) -> hull 3 points x -> dot n x <= d.
Proof.
  intros points n d x l below hx. assert (g : - d <= dot (times (-1) n) x); [|rewrite times_dot in g; lra].
  apply (hull_above 3 points); auto. intros p i. rewrite times_dot. specialize (below p i). lra.
Qed.
Lemma corners_below : forall n d points,
  means Q2R (all (fun p => inner (leaves n) (leaves p) <= Leaf d)%check points) ->
  forall p, In p (map rl points) -> dot (rl n) p <= Q2R d.
Proof.
  intros n d points h p i. rewrite all_means in h. apply in_map_iff in i. destruct i as [q [<- i]]. specialize (h q i).
  simpl in h. rewrite inner_means, !leaves_mean in h. exact h.
Qed.
Lemma plane_keeps_means : forall plane points outside x start way e t, points_of 3 3 (map rl points) ->
  length start = length way -> values outside = at_time start way e -> values x = at_time start way t ->
  hull 3 (map rl points) (at_time start way t) -> means Q2R (plane_keeps plane points outside x) ->
  forall u, 0 < (u - t) * (e - t) -> ~ hull 3 (map rl points) (at_time start way u).
Proof.
  intros plane points outside x start way e t [_ hp] l eo ex hx h u s hu.
  destruct plane as [|n1 [|n2 [|n3 [|d [|]]]]]; try (simpl in h; tauto). unfold plane_keeps in h.
  set (n := [n1; n2; n3]) in *. destruct h as (below & front & behind).
  assert (g := hull_below _ (rl n) (Q2R d) _ hp (corners_below n d points below) hx).
  assert (k := hull_below _ (rl n) (Q2R d) _ hp (corners_below n d points below) hu).
  change (Q2R d < value Q2R (inner (leaves n) outside)) in front.
  change (Q2R d <= value Q2R (inner (leaves n) x)) in behind.
  rewrite inner_means, (leaves_mean n), eo in front. rewrite inner_means, (leaves_mean n), ex in behind.
  rewrite dot_at_time in * by auto.
  set (c := dot (rl n) start) in *. set (m := dot (rl n) way) in *.
  assert (p1 : 0 < (e - t) * m) by lra. assert (p2 : (u - t) * m <= 0) by lra.
  assert (p3 : 0 < ((u - t) * (e - t)) * ((e - t) * m)) by (apply Rmult_lt_0_compat; auto).
  assert (p4 : 0 <= - ((u - t) * m) * ((e - t) * (e - t))) by (apply Rmult_le_pos; [lra | apply square]). lra.
Qed.
Lemma has_weights_means : forall w points x, means Q2R (has_weights w points x) -> hull 3 (map rl points) (values x).
Proof.
  intros w points x [h e]. apply (weights_mean 3) in h. rewrite same_vector_means, mixed_means in e.
  rewrite <- e. exact h.
Qed.
Lemma is_empty_means : forall {B} (l : list B), means Q2R (is_empty l) -> l = [].
Proof. intros B [|b l] h; auto. simpl in h. tauto. Qed.
Lemma no_vector_means : forall x, means Q2R (no_vector x) <-> still (values x).
Proof. exact still_means. Qed.

(** ** Segments *)
Definition r_common (w : common Q) : common R :=
  match w with
  | no_point => no_point | common_point t p => common_point (Q2R t) (rl p)
  | common_segment p q => common_segment (rl p) (rl q)
  end.
Section segment.
Variables (a b : list R) (points : list (list R)).
Hypothesis (la : length a = 3%nat) (lb : length b = 3%nat) (hp : points_of 3 3 points).
Let way := minus b a.
Let lw : length a = length way.
Proof. unfold way. rewrite minus_length; congruence. Qed.
Let x := at_time a way.
Lemma segment_part : forall t u, 0 <= t -> t <= u -> u <= 1 -> (a = b -> t = u) -> hull 3 points (x t) ->
  hull 3 points (x u) -> (t = 0 \/ forall s, 0 < (s - t) * (0 - t) -> ~ hull 3 points (x s)) ->
  (u = 1 \/ still way \/ forall s, 0 < (s - u) * (1 - u) -> ~ hull 3 points (x s)) ->
  passage_spec (segment_in (hull 3 points) a b) (Some (t, u)).
Proof.
  intros t u t0 tu u1 one ht hu first last.
  assert (at_start : a = b -> t = 0).
  { intro e. destruct first as [z | keeps]; auto. destruct (Req_dec t 0) as [|n]; auto. exfalso. apply (keeps 0).
    - assert (0 < t * t) by (apply Rmult_lt_0_compat; lra). lra.
    - replace (x 0) with (x t); auto. apply (same_ends a b) in e; [|congruence]. fold way in e. unfold x, at_time.
      clear - e. revert e. generalize way. generalize a. induction a0 as [|c l IH]; intros [|v w] e; simpl; auto.
      unfold still in e. rewrite (e v) by (simpl; auto). f_equal; [ring|]. apply IH. intros k i. apply e. simpl; auto. }
  simpl. split; [auto|]. intro s. split.
  - intros (i & z & h). fold way in h. fold (x s) in h. split; apply Rnot_lt_le; intro bad.
    + destruct first as [e | keeps]; [lra|]. apply (keeps s); auto.
      replace ((s - t) * (0 - t)) with ((t - s) * t) by ring. apply Rmult_lt_0_compat; lra.
    + destruct last as [e | [e | keeps]]; [lra | |].
      * apply (same_ends a b) in e; [|congruence]. specialize (z e). lra.
      * apply (keeps s); auto. apply Rmult_lt_0_compat; lra.
  - intro i. split; [lra|]. split; [intro e; specialize (at_start e); specialize (one e); lra|].
    apply (hull_between points a way t s u); auto.
Qed.
End segment.
Lemma hull_strictly_apart : forall points n d x, (forall p, In p (map rl points) -> length p = 3%nat) ->
  means Q2R (all (fun p => inner (leaves n) (leaves p) < Leaf d)%check points) -> hull 3 (map rl points) x ->
  dot (rl n) x <= Q2R d.
Proof.
  intros points n d x l h hx. apply (hull_below (map rl points)); auto. intros p i. rewrite all_means in h.
  apply in_map_iff in i. destruct i as [q [<- i]]. specialize (h q i). simpl in h.
  rewrite inner_means, !leaves_mean in h. lra.
Qed.
Theorem segment_triangle_sound : forall a b points w facts,
  decide (check_segment_triangle a b points w facts) = true ->
  segment_triangle_spec (rl a) (rl b) (map rl points) (r_common w).
Proof.
  intros a b points w facts h. apply decide_means in h. unfold check_segment_triangle in h. cbv zeta in h.
  destruct h as (la & lb & hp & h). rewrite of_length_means in la, lb. apply points_mean in hp.
  assert (la' := rl_length a). assert (lb' := rl_length b). rewrite la in la'. rewrite lb in lb'.
  unfold segment_triangle_spec. do 3 (split; [assumption|]). cbv zeta.
  assert (lw : length (rl a) = length (minus (rl b) (rl a))) by (rewrite minus_length; congruence).
  assert (x : forall t, values (at_term (leaves a) (difference (leaves b) (leaves a)) (Leaf t)) =
    at_time (rl a) (minus (rl b) (rl a)) (Q2R t)) by (intro t; rewrite at_term_means, way_means, leaves_mean; auto).
  assert (at0 : rl a = at_time (rl a) (minus (rl b) (rl a)) 0).
  { apply three_numbers in la', lb'. destruct la' as (a0 & a1 & a2 & ->), lb' as (b0 & b1 & b2 & ->).
    unfold at_time, times; simpl. repeat (f_equal; try ring). }
  assert (at1 : rl b = at_time (rl a) (minus (rl b) (rl a)) 1).
  { apply three_numbers in la', lb'. destruct la' as (a0 & a1 & a2 & ->), lb' as (b0 & b1 & b2 & ->).
    unfold at_time, times; simpl. repeat (f_equal; try ring). }
  assert (starts : forall t before, hull 3 (map rl points) (at_time (rl a) (minus (rl b) (rl a)) (Q2R t)) ->
    means Q2R (is_empty before /\ Leaf t = zero \/ plane_keeps before points (leaves a)
      (at_term (leaves a) (difference (leaves b) (leaves a)) (Leaf t)))%check ->
    Q2R t = 0 \/ forall s, 0 < (s - Q2R t) * (0 - Q2R t) -> ~ hull 3 (map rl points) (at_time (rl a) (minus (rl b)
      (rl a)) s)).
  { intros t before ht [[_ z] | k]; [left; exact z | right]. eapply plane_keeps_means; eauto.
    rewrite leaves_mean; auto. }
  assert (ends : forall t after, hull 3 (map rl points) (at_time (rl a) (minus (rl b) (rl a)) (Q2R t)) ->
    means Q2R (is_empty after /\ (Leaf t = one \/ no_vector (difference (leaves b) (leaves a))) \/
      plane_keeps after points (leaves b) (at_term (leaves a) (difference (leaves b) (leaves a)) (Leaf t)))%check ->
    Q2R t = 1 \/ still (minus (rl b) (rl a)) \/ forall s, 0 < (s - Q2R t) * (1 - Q2R t) ->
      ~ hull 3 (map rl points) (at_time (rl a) (minus (rl b) (rl a)) s)).
  { intros t after ht [[_ [z | z]] | k]; [left; exact z | right; left | right; right].
    - apply no_vector_means in z. rewrite way_means in z. auto.
    - eapply plane_keeps_means; eauto. rewrite leaves_mean; auto. }
  destruct w as [| t p | p q], facts as [n d | ts weights before after]; try solve [destruct h].
  - destruct h as (ln & fa & fb & apart). simpl in fa, fb. rewrite inner_means, !leaves_mean in fa, fb. simpl.
    intros u (i & _ & hu). apply (hull_strictly_apart points n d) in hu; [|apply hp|exact apart].
    rewrite dot_at_time, dot_minus in hu by congruence.
    assert (0 <= u * (dot (rl n) (rl b) - Q2R d)) by (apply Rmult_le_pos; lra).
    assert (0 <= (1 - u) * (dot (rl n) (rl a) - Q2R d)) by (apply Rmult_le_pos; lra).
    destruct (Req_dec u 0) as [-> | nz]; [lra|].
    assert (0 < u * (dot (rl n) (rl b) - Q2R d)) by (apply Rmult_lt_0_compat; lra). lra.
  - destruct ts as [|t0 [|]]; try solve [destruct h]. destruct h as (h0 & h1 & hw & first & last & et & ep).
    apply has_weights_means in hw. rewrite x in hw. rewrite same_vector_means, leaves_mean, x in ep.
    simpl in h0, h1, et. simpl r_common. cbv iota. rewrite et, ep. split; [|auto].
    apply segment_part; auto; [lra | eapply starts; eauto | eapply ends; eauto].
  - destruct ts as [|t0 [|t1 [|]]]; try solve [destruct h].
    destruct weights as [|w0 [|w1 [|w2 [|u0 [|u1 [|u2 [|]]]]]]]; try solve [destruct h].
    destruct h as (h0 & h1 & h2 & moves & hw & hu & first & last & ep & eq).
    apply has_weights_means in hw, hu. rewrite x in hw, hu. rewrite same_vector_means, leaves_mean, x in ep, eq.
    simpl in h0, h1, h2. change (~ means Q2R (no_vector (difference (leaves b) (leaves a)))) in moves.
    rewrite no_vector_means, way_means in moves. simpl r_common. cbv iota. exists (Q2R t0), (Q2R t1).
    split; [exact h1|]. split; [|auto].
    apply segment_part; auto; [lra | intro e; exfalso; apply moves, same_ends; congruence | eapply starts; eauto |
      eapply ends; eauto].
Qed.
Theorem segment_triangle_unique : forall a b points v w,
  segment_triangle_spec a b points v -> segment_triangle_spec a b points w -> v = w.
Proof.
  intros a b points v w (_ & _ & _ & g) (_ & _ & _ & h). cbv zeta in g, h.
  destruct v as [| t p | p q], w as [| t' p' | p' q']; auto.
  - destruct h as [h _]. assert (e := passage_unique _ _ _ g h). discriminate.
  - destruct h as (s & u & _ & h & _). assert (e := passage_unique _ _ _ g h). discriminate.
  - destruct g as [g _]. assert (e := passage_unique _ _ _ g h). discriminate.
  - destruct g as [g ->], h as [h ->]. assert (e := passage_unique _ _ _ g h). injection e; intros; subst; auto.
  - destruct g as [g _], h as (s & u & l & h & _). assert (e := passage_unique _ _ _ g h). injection e; intros. lra.
  - destruct g as (s & u & _ & g & _). assert (e := passage_unique _ _ _ g h). discriminate.
  - destruct g as (s & u & l & g & _), h as [h _]. assert (e := passage_unique _ _ _ g h). injection e; intros. lra.
  - destruct g as (s & u & _ & g & -> & ->), h as (s' & u' & _ & h & -> & ->).
    assert (e := passage_unique _ _ _ g h). injection e; intros; subst; auto.
Qed.
