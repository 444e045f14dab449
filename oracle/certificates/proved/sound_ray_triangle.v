(* SPDX-License-Identifier: Apache-2.0 *)
(** The formula of rays that meet triangles is enough, and its specification leaves no choice. *)
Require Import Reals Qreals QArith Lra Lia List Arith Bool.
From Certificates Require Import hulls motion solids response language formulas_vectors formulas_solids formulas_heights
  formulas_nearest formulas_triangles sound_solids sound_vectors sound_heights sound_nearest sound_motion sound_courses
  sound_response sound_triangles.
Import ListNotations.
Open Scope R_scope.

(** ** Areas *)
Definition ways_cross (p q r : list R) : vec3 R :=
  let at_ k x := nth k x 0 in
  cross3 (at_ 0%nat q - at_ 0%nat p, at_ 1%nat q - at_ 1%nat p, at_ 2%nat q - at_ 2%nat p)
    (at_ 0%nat r - at_ 0%nat p, at_ 1%nat r - at_ 1%nat p, at_ 2%nat r - at_ 2%nat p).
Lemma nth_plus : forall k x y, (k < length (plus x y))%nat -> nth k (plus x y) 0 = nth k x 0 + nth k y 0.
Proof.
  induction k as [|k IH]; intros [|a x] [|b y] l; simpl in *; try lia; auto. apply IH. lia.
Qed.
Lemma nth_times : forall k t x, nth k (times t x) 0 = t * nth k x 0.
Proof. unfold times. induction k as [|k IH]; intros t [|a x]; simpl; try ring. apply IH. Qed.
Lemma coordinate_at_time : forall k x v t, (k < length (at_time x v t))%nat ->
  nth k (at_time x v t) 0 = nth k x 0 + t * nth k v 0.
Proof. intros. unfold at_time in *. rewrite nth_plus, nth_times; auto. Qed.
Lemma line_has_no_area : forall S p q r, length p = 3%nat -> length q = 3%nat -> length r = 3%nat -> on_one_line S ->
  S p -> S q -> S r -> ways_cross p q r = (0, 0, 0).
Proof.
  intros S p q r lp lq lr (x & v & on) hp hq hr. apply on in hp, hq, hr.
  destruct hp as [s ep], hq as [t eq], hr as [u er]. unfold ways_cross.
  rewrite ep in *. rewrite eq in *. rewrite er in *.
  rewrite !coordinate_at_time by lia. simpl. rewrite equal3. repeat split; ring.
Qed.
Lemma corners_in_hull : forall p q r, length p = 3%nat -> length q = 3%nat -> length r = 3%nat ->
  hull 3 [p; q; r] p /\ hull 3 [p; q; r] q /\ hull 3 [p; q; r] r.
Proof.
  intros p q r lp lq lr. assert (ep := three_numbers _ lp). assert (eq := three_numbers _ lq).
  assert (er := three_numbers _ lr). destruct ep as (p0 & p1 & p2 & ->), eq as (q0 & q1 & q2 & ->),
    er as (r0 & r1 & r2 & ->).
  split; [|split]; apply (mixture_three (Rle 0)); auto; [exists 1, 0, 0 | exists 0, 1, 0 | exists 0, 0, 1]; simpl;
    repeat split; try lra; repeat (f_equal; try ring).
Qed.
Lemma no_area_on_line : forall p q r, length p = 3%nat -> length q = 3%nat -> length r = 3%nat ->
  ways_cross p q r = (0, 0, 0) -> on_one_line (hull 3 [p; q; r]).
Proof.
  intros p q r lp lq lr z. assert (ep := three_numbers _ lp). assert (eq := three_numbers _ lq).
  assert (er := three_numbers _ lr). destruct ep as (p0 & p1 & p2 & ->), eq as (q0 & q1 & q2 & ->),
    er as (r0 & r1 & r2 & ->).
  unfold ways_cross in z. cbn [nth] in z. set (u := (q0 - p0, q1 - p1, q2 - p2)) in *.
  set (v := (r0 - p0, r1 - p1, r2 - p2)) in *.
  assert (d : u = (0, 0, 0) \/ u <> (0, 0, 0)).
  { unfold u. rewrite equal3. destruct (Req_dec (q0 - p0) 0), (Req_dec (q1 - p1) 0), (Req_dec (q2 - p2) 0); tauto. }
  destruct d as [d | d].
  - unfold u in d. rewrite equal3 in d. exists [p0; p1; p2], [r0 - p0; r1 - p1; r2 - p2]. intros y hy.
    apply (mixture_three (Rle 0)) in hy; auto. destruct hy as (a & b & c & _ & _ & _ & one & ->). exists c.
    simpl nth. unfold at_time, times; simpl. replace a with (1 - b - c) by lra.
    replace q0 with p0 by lra. replace q1 with p1 by lra. replace q2 with p2 by lra. repeat (f_equal; try ring).
  - assert (z' : cross3 v u = (0, 0, 0)).
    { unfold u, v in *. simpl in *. rewrite equal3 in *. lra. }
    destruct (along_normal v u d z') as [s e]. unfold u, v in e. simpl in e. rewrite equal3 in e.
    destruct e as (e0 & e1 & e2).
    exists [p0; p1; p2], [q0 - p0; q1 - p1; q2 - p2]. intros y hy.
    apply (mixture_three (Rle 0)) in hy; auto. destruct hy as (a & b & c & _ & _ & _ & one & ->). exists (b + c * s).
    simpl nth. unfold at_time, times; simpl. replace a with (1 - b - c) by lra.
    replace r0 with (p0 + s * (q0 - p0)) by lra. replace r1 with (p1 + s * (q1 - p1)) by lra.
    replace r2 with (p2 + s * (q2 - p2)) by lra. repeat (f_equal; try ring).
Qed.
(** Where there is an area, a point has its weights once. *)
Lemma weights_once : forall p q r a b c a' b' c', ways_cross p q r <> (0, 0, 0) -> a + b + c = 1 -> a' + b' + c' = 1 ->
  (forall k, (k < 3)%nat -> a * nth k p 0 + b * nth k q 0 + c * nth k r 0 =
    a' * nth k p 0 + b' * nth k q 0 + c' * nth k r 0) -> a = a' /\ b = b' /\ c = c'.
Proof.
  intros p q r a b c a' b' c' nz one one' e. unfold ways_cross in nz.
  set (u0 := nth 0 q 0 - nth 0 p 0) in *. set (u1 := nth 1 q 0 - nth 1 p 0) in *.
  set (u2 := nth 2 q 0 - nth 2 p 0) in *. set (v0 := nth 0 r 0 - nth 0 p 0) in *.
  set (v1 := nth 1 r 0 - nth 1 p 0) in *. set (v2 := nth 2 r 0 - nth 2 p 0) in *.
  assert (f : forall k, (k < 3)%nat -> (b - b') * (nth k q 0 - nth k p 0) + (c - c') * (nth k r 0 - nth k p 0) = 0).
  { intros k hk. specialize (e k hk). replace a with (1 - b - c) in e by lra. replace a' with (1 - b' - c') in e by lra.
    lra. }
  assert (f0 := f 0%nat ltac:(lia)). assert (f1 := f 1%nat ltac:(lia)). assert (f2 := f 2%nat ltac:(lia)).
  fold u0 v0 in f0. fold u1 v1 in f1. fold u2 v2 in f2. clear e f.
  assert (zero : forall d x y z, d * x = 0 -> d * y = 0 -> d * z = 0 -> (x, y, z) <> (0, 0, 0) -> d = 0).
  { intros d x y z hx hy hz n. destruct (Req_dec d 0) as [|nd]; auto. exfalso. apply n. rewrite equal3.
    repeat split; [destruct (Rmult_integral _ _ hx) | destruct (Rmult_integral _ _ hy) |
      destruct (Rmult_integral _ _ hz)]; tauto. }
  set (d := b - b') in *. set (d' := c - c') in *. simpl in nz.
  assert (d = 0).
  { apply (zero _ _ _ _) with (4 := nz).
    - transitivity ((d * u1 + d' * v1) * v2 - (d * u2 + d' * v2) * v1); [ring | rewrite f1, f2; ring].
    - transitivity ((d * u2 + d' * v2) * v0 - (d * u0 + d' * v0) * v2); [ring | rewrite f2, f0; ring].
    - transitivity ((d * u0 + d' * v0) * v1 - (d * u1 + d' * v1) * v0); [ring | rewrite f0, f1; ring]. }
  assert (d' = 0).
  { apply (zero _ _ _ _) with (4 := nz).
    - transitivity ((d * u2 + d' * v2) * u1 - (d * u1 + d' * v1) * u2); [ring | rewrite f1, f2; ring].
    - transitivity ((d * u0 + d' * v0) * u2 - (d * u2 + d' * v2) * u0); [ring | rewrite f2, f0; ring].
    - transitivity ((d * u1 + d' * v1) * u0 - (d * u0 + d' * v0) * u1); [ring | rewrite f0, f1; ring]. }
  unfold d, d' in *. lra.
Qed.
Lemma has_area_means : forall p q r, length p = 3%nat -> length q = 3%nat -> length r = 3%nat ->
  (means Q2R (has_area [p; q; r]) <-> ways_cross (rl p) (rl q) (rl r) <> (0, 0, 0)).
Proof.
  intros p q r lp lq lr. apply three_numbers in lp, lq, lr. destruct lp as (p0 & p1 & p2 & ->),
    lq as (q0 & q1 & q2 & ->), lr as (r0 & r1 & r2 & ->). unfold ways_cross. simpl. rewrite equal3. tauto.
Qed.

(** ** Rays *)
Definition r_ray_common (w : ray_common Q) : ray_common R :=
  match w with
  | ray_misses => ray_misses | ray_hits t p within => ray_hits (Q2R t) (rl p) within
  | ray_enters t p => ray_enters (Q2R t) (rl p)
  end.
Lemma within_means : forall points weights x, points_of 3 3 (map rl points) ->
  means Q2R (has_weights weights points x) ->
  (means Q2R (has_area points /\ all (fun a => zero < Leaf a) weights)%check <->
   ~ on_one_line (hull 3 (map rl points)) /\ mixture (Rlt 0) 3 (map rl points) (values x)).
Proof.
  intros points weights x hp [hw e]. destruct hp as [cp hp]. rewrite map_length in cp. apply three_numbers in cp.
  destruct cp as (p & q & r & ->). assert (lp := hp (rl p) ltac:(simpl; auto)).
  assert (lq := hp (rl q) ltac:(simpl; auto)). assert (lr := hp (rl r) ltac:(simpl; auto)).
  rewrite same_vector_means, mixed_means in e. destruct hw as (lw & pos & one). rewrite if_so_means, Nat.eqb_eq in lw.
  apply three_numbers in lw. destruct lw as (a & b & c & ->). simpl map. 
  assert (area := has_area_means p q r ltac:(rewrite <- rl_length; auto) ltac:(rewrite <- rl_length; auto)
    ltac:(rewrite <- rl_length; auto)).
  assert (ex : values x = [Q2R a * nth 0 (rl p) 0 + Q2R b * nth 0 (rl q) 0 + Q2R c * nth 0 (rl r) 0;
    Q2R a * nth 1 (rl p) 0 + Q2R b * nth 1 (rl q) 0 + Q2R c * nth 1 (rl r) 0;
    Q2R a * nth 2 (rl p) 0 + Q2R b * nth 2 (rl q) 0 + Q2R c * nth 2 (rl r) 0]).
  { rewrite <- e. clear - lp lq lr. rewrite rl_length in *. apply three_numbers in lp, lq, lr.
    destruct lp as (p0 & p1 & p2 & ->), lq as (q0 & q1 & q2 & ->), lr as (r0 & r1 & r2 & ->). simpl.
    repeat (f_equal; try ring). }
  simpl in one. simpl means. rewrite area. split.
  - intros [nz (ha & hb & hc & _)]. split.
    + intro l. destruct (corners_in_hull (rl p) (rl q) (rl r) lp lq lr) as (h1 & h2 & h3).
      apply nz, (line_has_no_area (hull 3 [rl p; rl q; rl r])); auto.
    + apply mixture_three; auto. exists (Q2R a), (Q2R b), (Q2R c). rewrite ex. repeat split; auto; lra.
  - intros [nl m].
    assert (nz : ways_cross (rl p) (rl q) (rl r) <> (0, 0, 0)) by (intro z; apply nl, no_area_on_line; auto).
    split; [exact nz|]. apply mixture_three in m; auto. destruct m as (a' & b' & c' & ha & hb & hc & one' & ey).
    rewrite ex in ey. injection ey; intros e2 e1 e0.
    destruct (weights_once (rl p) (rl q) (rl r) (Q2R a) (Q2R b) (Q2R c) a' b' c') as (f & g & k); auto; [lra| |].
    { intros k hk. destruct k as [|[|[|k]]]; auto. lia. }
    rewrite f, g, k. auto.
Qed.
Lemma hull_strictly_below : forall points n d x, points_of 3 3 points -> (forall p, In p points -> dot n p < d) ->
  hull 3 points x -> dot n x < d.
Proof.
  intros points n d x hp below hx. assert (h := three_points _ hp). destruct h as (p & q & r & -> & _).
  set (m := Rmax (dot n p) (Rmax (dot n q) (dot n r))).
  assert (dot n x <= m).
  { apply (hull_below [p; q; r]); auto; [apply hp|]. intros y [<- | [<- | [<- | []]]]; unfold m.
    - apply Rmax_l.
    - eapply Rle_trans; [|apply Rmax_r]. apply Rmax_l.
    - eapply Rle_trans; [|apply Rmax_r]. apply Rmax_r. }
  assert (m < d). { unfold m. repeat apply Rmax_lub_lt; apply below; simpl; auto. }
  lra.
Qed.
Theorem ray_triangle_sound : forall o v points w facts, decide (check_ray_triangle o v points w facts) = true ->
  ray_triangle_spec (rl o) (rl v) (map rl points) (r_ray_common w).
Proof.
  intros o v points w facts h. apply decide_means in h. unfold check_ray_triangle in h. cbv zeta in h.
  destruct h as (lo & lv & nz & hp & h). rewrite of_length_means in lo, lv. apply points_mean in hp.
  assert (lo' := rl_length o). assert (lv' := rl_length v). rewrite lo in lo'. rewrite lv in lv'.
  apply not_zero_means in nz. unfold ray_triangle_spec. do 4 (split; [assumption|]). cbv zeta.
  assert (lov : length (rl o) = length (rl v)) by congruence.
  assert (x : forall t, values (at_term (leaves o) (leaves v) t) = at_time (rl o) (rl v) (value Q2R t))
    by (intro t; rewrite at_term_means, !leaves_mean; auto).
  assert (at0 : rl o = at_time (rl o) (rl v) 0).
  { apply three_numbers in lo', lv'. destruct lo' as (a0 & a1 & a2 & ->), lv' as (b0 & b1 & b2 & ->).
    unfold at_time, times; simpl. repeat (f_equal; try ring). }
  set (H := hull 3 (map rl points)) in *. set (X := at_time (rl o) (rl v)) in *.
  assert (starts : forall t before, 0 <= Q2R t -> H (X (Q2R t)) ->
    means Q2R (is_empty before /\ Leaf t = zero \/ plane_keeps before points (leaves o)
      (at_term (leaves o) (leaves v) (Leaf t)))%check ->
    forall u, 0 <= u -> H (X u) -> Q2R t <= u).
  { intros t before t0 ht k u u0 hu. apply Rnot_lt_le; intro bad. destruct k as [[_ z] | k]; [simpl in z; lra|].
    assert (keeps : forall s, 0 < (s - Q2R t) * (0 - Q2R t) -> ~ H (X s)).
    { eapply plane_keeps_means; eauto; [rewrite leaves_mean; auto | apply x]. }
    apply (keeps u); auto.
    replace ((u - Q2R t) * (0 - Q2R t)) with ((Q2R t - u) * Q2R t) by ring. apply Rmult_lt_0_compat; lra. }
  destruct w as [| t p within | t p], facts as [n d until | ts weights before after]; try solve [destruct h].
  - destruct h as (ln & fo & fe & apart & ahead). simpl in fo, fe. rewrite inner_means, leaves_mean in fo, fe.
    rewrite leaves_mean in fo. rewrite x in fe. simpl value in fe. simpl. intros u [u0 hu].
    assert (far := hull_strictly_apart points n d _ (proj2 hp) apart hu).
    unfold X in far, fe. rewrite dot_at_time in far, fe by auto.
    set (A := dot (rl n) (rl o)) in *. set (B := dot (rl n) (rl v)) in *.
    destruct (Rlt_le_dec u (Q2R until)) as [l | l].
    + assert (0 <= u * (A + Q2R until * B - Q2R d)) by (apply Rmult_le_pos; lra).
      assert (0 < (Q2R until - u) * (A - Q2R d)) by (apply Rmult_lt_0_compat; lra).
      assert (0 <= Q2R until * (Q2R d - (A + u * B))) by (apply Rmult_le_pos; lra). lra.
    + assert (g : dot (rl v) (X u) < dot (rl v) (X (Q2R until))).
      { apply (hull_strictly_below (map rl points)); auto. intros y i. rewrite all_means in ahead.
        assert (ly := proj2 hp y i). apply in_map_iff in i. destruct i as [q [<- i]]. specialize (ahead q i).
        simpl in ahead. rewrite inner_means, difference_means, !leaves_mean, x in ahead. simpl value in ahead.
        fold (X (Q2R until)) in ahead. rewrite dot_minus in ahead; [lra|]. unfold X.
        rewrite at_time_length; congruence. }
      unfold X in g. rewrite !dot_at_time in g by auto. assert (q := dot_nonzero _ nz).
      assert (0 <= (u - Q2R until) * dot (rl v) (rl v)) by (apply Rmult_le_pos; lra). lra.
  - destruct ts as [|t0 [|]]; try solve [destruct h]. destruct h as (h0 & hw & first & last & et & ep & inside).
    assert (ht := has_weights_means _ _ _ hw). rewrite x in ht. rewrite same_vector_means, leaves_mean, x in ep.
    simpl in h0, et. simpl r_ray_common. cbv iota. rewrite et, ep. simpl value in *. split; [|split; [auto|]].
    + intro u. split.
      * intros [u0 hu]. apply Rle_antisym; [|apply (starts t0 before); auto].
        apply Rnot_lt_le; intro bad.
        assert (keeps : forall s, 0 < (s - Q2R t0) * (Q2R t0 + 1 - Q2R t0) -> ~ H (X s)).
        { eapply plane_keeps_means; eauto; apply x. }
        apply (keeps u); auto. replace ((u - Q2R t0) * (Q2R t0 + 1 - Q2R t0)) with (u - Q2R t0) by ring. lra.
      * intros ->. split; auto.
    + assert (k := within_means points weights _ hp hw). rewrite x in k. simpl value in k.
      unfold H. rewrite <- k. destruct within; simpl in inside |- *; [tauto|]. split; [discriminate | tauto].
  - destruct ts as [|t0 [|t1 [|]]]; try solve [destruct h].
    destruct weights as [|w0 [|w1 [|w2 [|u0 [|u1 [|u2 [|]]]]]]]; try solve [destruct h].
    destruct h as (h0 & h1 & hw & hu & first & _ & et & ep).
    apply has_weights_means in hw, hu. rewrite x in hw, hu. rewrite same_vector_means, leaves_mean, x in ep.
    simpl in h0, h1, et. simpl r_ray_common. cbv iota. rewrite et, ep. simpl value in *. unfold ray_in. fold H X.
    split; [auto|]. split; [auto|]. split.
    + intros u [i k]. apply (starts t0 before); auto.
    + exists (Q2R t1). split; [auto|]. split; [lra | auto].
Qed.
Theorem ray_triangle_unique : forall o v points x y,
  ray_triangle_spec o v points x -> ray_triangle_spec o v points y -> x = y.
Proof.
  intros o v points x y (_ & _ & _ & _ & g) (_ & _ & _ & _ & h). cbv zeta in g, h.
  destruct x as [| t p i | t p], y as [| t' p' i' | t' p']; auto.
  - destruct h as (h & _). exfalso. apply (g t'), h; auto.
  - destruct h as (h & _). exfalso. apply (g t'); auto.
  - destruct g as (g & _). exfalso. apply (h t), g; auto.
  - destruct g as (g & -> & k), h as (h & -> & l). assert (e : t = t') by (apply h, g; auto). subst t'.
    f_equal. destruct i, i'; auto; [symmetry; apply l, k; auto | apply k, l; auto].
  - destruct g as (g & _), h as (h1 & _ & _ & u & l & h2). exfalso. apply g in h1, h2. lra.
  - destruct g as (g & _). exfalso. apply (h t); auto.
  - destruct h as (h & _), g as (h1 & _ & _ & u & l & h2). exfalso. apply h in h1, h2. lra.
  - destruct g as (g & -> & k & _), h as (h & -> & l & _). assert (e : t = t') by (apply Rle_antisym; auto).
    rewrite e. auto.
Qed.
