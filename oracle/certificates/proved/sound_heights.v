(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of heights are enough, and their specifications leave no choice. *)
Require Import Reals Qreals QArith Lra Lia List Arith Bool.
From Certificates Require Import solids planes language formulas_vectors formulas_slabs formulas_heights sound_solids
  sound_vectors.
Import ListNotations.
Open Scope R_scope.

Lemma elevation_means : forall h w y g, means Q2R (elevation_of h w) -> value Q2R h = y - g -> elevation_spec y g w.
Proof. intros h w y g m e. destruct w; simpl in *; lra. Qed.
Lemma elevation_unique : forall y g v w, elevation_spec y g v -> elevation_spec y g w -> v = w.
Proof. intros y g [] [] a b; simpl in *; auto; lra. Qed.

Theorem explicit_line_sound : forall m b p w h, decide (check_explicit_line m b p w h) = true ->
  explicit_line_spec (Q2R m) (Q2R b) (Q2R (fst p), Q2R (snd p)) w.
Proof.
  intros m b p w h k. apply decide_means in k. destruct k as [e k].
  apply (elevation_means _ _ _ _ k). simpl in *. auto.
Qed.
Theorem explicit_line_unique : forall m b p v w, explicit_line_spec m b p v -> explicit_line_spec m b p w -> v = w.
Proof. intros m b p v w; apply elevation_unique. Qed.

Theorem point_ground_plane_sound : forall p w h, decide (check_point_ground_plane p w h) = true ->
  point_ground_plane_spec (rl p) w.
Proof.
  intros p w h k. apply decide_means in k. unfold check_point_ground_plane in k.
  destruct p as [|x [|y [|z [|]]]]; simpl in k; try tauto. destruct k as [e k].
  split; auto. apply (elevation_means _ _ _ _ k). simpl in *. lra.
Qed.
Theorem point_ground_plane_unique : forall p v w, point_ground_plane_spec p v -> point_ground_plane_spec p w -> v = w.
Proof. intros p v w [_ a] [_ b]; apply (elevation_unique _ _ _ _ a b). Qed.

Lemma plus_minus : forall p x, length p = length x -> plus (minus p x) x = p.
Proof.
  intros p x l. revert p l. induction x as [|a x IH]; intros [|b p] l; simpl in *; try discriminate; auto.
  rewrite IH by lia. f_equal; lra.
Qed.

Theorem point_plane_sound : forall n d p w distance, decide (check_point_plane n d p w distance) = true ->
  point_plane_spec (rl n) (Q2R d) (rl p) w (Q2R distance).
Proof.
  intros n d p w distance h. apply decide_means in h. unfold check_point_plane in h. cbv zeta in h.
  destruct h as (ln & lp & nz & sq & h). rewrite of_length_means in ln, lp. apply not_zero_means in nz.
  assert (ln' := rl_length n). assert (lp' := rl_length p). rewrite ln in ln'. rewrite lp in lp'.
  do 3 (split; [auto|]). simpl in sq. rewrite !inner_means, !leaves_mean in sq.
  assert (q := dot_nonzero _ nz). set (Q := dot (rl n) (rl n)) in *. set (E := dot (rl n) (rl p) + Q2R d) in *.
  assert (s0 := sqrt_lt_R0 Q q). assert (s2 := sqrt_def Q ltac:(lra)). set (s := sqrt Q) in *.
  assert (ds : Q2R distance * s = E /\ match w with front => 0 < Q2R distance | on_plane => Q2R distance = 0 | back
    => Q2R distance < 0 end).
  { assert (f : (Q2R distance * s - E) * (Q2R distance * s + E) = 0).
    { transitivity (Q2R distance * Q2R distance * (s * s) - E * E); [ring | rewrite s2; lra]. }
    destruct w; simpl in h; rewrite ?inner_means, ?leaves_mean in h; fold E in h; destruct h as [hE hd];
      split; auto; destruct (Rmult_integral _ _ f); try lra.
    - assert (0 < Q2R distance * s) by (apply Rmult_lt_0_compat; auto). lra.
    - assert (0 < - Q2R distance * s) by (apply Rmult_lt_0_compat; lra). lra. }
  destruct ds as [ds side]. split; [|auto].
  assert (k : Q2R distance / s * Q = E) by (rewrite <- s2, <- ds; field; lra).
  set (t := Q2R distance / s) in *. exists (minus (rl p) (times t (rl n))).
  assert (l : length (rl p) = length (times t (rl n))) by (rewrite times_length; congruence).
  split; [rewrite minus_length, times_length; auto|]. split; [rewrite dot_minus, dot_times by auto; fold Q;
    unfold E in *; lra|].
  rewrite plus_minus; auto.
Qed.
Theorem point_plane_unique : forall n d p v x w y,
  point_plane_spec n d p v x -> point_plane_spec n d p w y -> v = w /\ x = y.
Proof.
  intros n d p v x w y (ln & lp & nz & (f & lf & hf & ef) & hv) (_ & _ & _ & (g & lg & hg & eg) & hw).
  assert (q := dot_nonzero _ nz). assert (s0 := sqrt_lt_R0 _ q).
  assert (a : dot n p + d = x / sqrt (dot n n) * dot n n).
  { rewrite ef, dot_plus, dot_times by (rewrite times_length; congruence). lra. }
  assert (b : dot n p + d = y / sqrt (dot n n) * dot n n).
  { rewrite eg, dot_plus, dot_times by (rewrite times_length; congruence). lra. }
  assert (e : x = y).
  { apply (Rmult_eq_reg_r (/ sqrt (dot n n) * dot n n)).
    - unfold Rdiv in *. lra.
    - assert (0 < / sqrt (dot n n) * dot n n) by (apply Rmult_lt_0_compat; auto; apply Rinv_0_lt_compat; auto). lra. }
  split; auto. destruct v, w; auto; lra.
Qed.

(** ** Rays and segments *)
Definition r_line_plane (w : line_plane Q) : line_plane R :=
  match w with misses_plane => misses_plane | crosses_plane t p => crosses_plane (Q2R t) (rl p) | inside_plane =>
    inside_plane end.

Lemma at_term_means : forall start way t, values (at_term start way t) = at_time (values start) (values way) (value
  Q2R t).
Proof. intros; unfold at_term, at_time. rewrite sum_means, scaled_means; auto. Qed.

Lemma heights_mean : forall (ends : bool) (D : R -> Prop) start way n d w first second,
  length (values start) = length (values way) ->
  (forall t, D t <-> 0 <= t /\ (if ends then t <= 1 else True)) ->
  means Q2R (heights_prove ends start way n d w first second) ->
  line_plane_spec D (values start) (values way) (rl n) (Q2R d) (r_line_plane w).
Proof.
  intros ends D start way n d w first second l hD h. unfold heights_prove in h. cbv zeta in h.
  destruct h as (e & c & h). simpl in e, c. rewrite !inner_means, !leaves_mean in e, c.
  assert (line : forall t, dot (rl n) (at_time (values start) (values way) t) + Q2R d = Q2R first + t * (Q2R second -
    Q2R first)).
  { intro t. unfold at_time. rewrite dot_plus, dot_times by (rewrite times_length; auto). rewrite c. lra. }
  unfold line_plane_spec. destruct w as [| t p |]; simpl.
  - intros t ht k. rewrite line in k. apply hD in ht. destruct ends; simpl in h.
    + destruct ht as [h0 h1]. destruct (Rlt_le_dec 0 (Q2R first)) as [s | s].
      * assert (0 < Q2R second).
        { apply Rnot_le_lt; intro g. assert (0 <= Q2R first * - Q2R second) by (apply Rmult_le_pos; lra). lra. }
        assert (m := Rmult_le_pos t (Q2R second)). assert (m' := Rmult_le_pos (1 - t) (Q2R first)).
        destruct (Req_dec t 0); [subst; lra|]. assert (0 < t * Q2R second) by (apply Rmult_lt_0_compat; lra). lra.
      * assert (ns : Q2R first < 0) by (destruct (Req_dec (Q2R first) 0) as [z|]; [rewrite z in h; lra | lra]).
        assert (Q2R second < 0).
        { apply Rnot_le_lt; intro g. assert (0 <= - Q2R first * Q2R second) by (apply Rmult_le_pos; lra). lra. }
        destruct (Req_dec t 0); [subst; lra|]. assert (0 < t * - Q2R second) by (apply Rmult_lt_0_compat; lra).
        assert (0 <= (1 - t) * - Q2R first) by (apply Rmult_le_pos; lra). lra.
    + destruct h as [nz m]. destruct ht as [h0 _]. set (F := Q2R first) in *. set (G := Q2R second - F) in *.
      assert (0 <= t * (F * G)) by (apply Rmult_le_pos; auto). assert (s := square F).
      assert (F * F <> 0) by (intro z; destruct (Rmult_integral _ _ z); auto).
      assert (F * (F + t * G) = 0) by (rewrite k; ring). lra.
  - simpl in h. rewrite same_vector_means, leaves_mean, at_term_means in h. destruct h as (nz & h0 & h1 & z & e').
    simpl in e'. split; [apply hD; split; [auto | destruct ends; simpl in h1; auto]|]. split; [auto|].
    intros u _. rewrite line. split.
    + intro k. assert (m : (u - Q2R t) * (Q2R second - Q2R first) = 0) by lra.
      destruct (Rmult_integral _ _ m); [lra | tauto].
    + intros ->. auto.
  - simpl in h. intros t _. rewrite line. destruct h as [-> ->]. ring.
Qed.

Theorem ray_plane_sound : forall o v n d w first second, decide (check_ray_plane o v n d w first second) = true ->
  ray_plane_spec (rl o) (rl v) (rl n) (Q2R d) (r_line_plane w).
Proof.
  intros o v n d w first second h. apply decide_means in h. destruct h as (lo & lv & ln & nv & nn & h).
  rewrite of_length_means in lo, lv, ln. apply not_zero_means in nv, nn. unfold ray_plane_spec. rewrite !rl_length.
  do 5 (split; [auto|]). rewrite <- (leaves_mean o), <- (leaves_mean v).
  apply (heights_mean false of_ray _ _ _ _ _ first second); auto; [rewrite !leaves_mean, !rl_length; congruence|].
  intro t; unfold of_ray; tauto.
Qed.
Lemma way_means : forall a b, values (difference (leaves b) (leaves a)) = minus (rl b) (rl a).
Proof. intros. rewrite difference_means, !leaves_mean; auto. Qed.
Theorem segment_plane_sound : forall a b n d w first second, decide (check_segment_plane a b n d w first second) =
  true ->
  segment_plane_spec (rl a) (rl b) (rl n) (Q2R d) (r_line_plane w).
Proof.
  intros a b n d w first second h. apply decide_means in h. destruct h as (la & lb & ln & nn & h).
  rewrite of_length_means in la, lb, ln. apply not_zero_means in nn. unfold segment_plane_spec. rewrite !rl_length.
  do 4 (split; [auto|]). rewrite <- way_means, <- (leaves_mean a).
  apply (heights_mean true of_segment _ _ _ _ _ first second); auto.
  - rewrite way_means, leaves_mean, minus_length; rewrite !rl_length; congruence.
  - intro t; unfold of_segment; tauto.
Qed.

Lemma line_plane_unique : forall (D : R -> Prop) start way n d v w, D 0 -> D 1 ->
  line_plane_spec D start way n d v -> line_plane_spec D start way n d w -> v = w.
Proof.
  intros D start way n d v w h0 h1 g h. unfold line_plane_spec in *. cbv zeta in *.
  destruct v as [| t p |], w as [| u q |]; auto; try (exfalso; apply (g 0 h0), h; auto; fail);
    try (exfalso; apply (h 0 h0), g; auto; fail).
  - destruct h as (a & b & c). exfalso. apply (g u a), c; auto.
  - destruct g as (a & b & c). exfalso. apply (h t a), c; auto.
  - destruct g as (a & b & c), h as (a' & b' & c'). assert (e : u = t) by (apply c; auto; apply c'; auto). subst; auto.
  - destruct g as (a & b & c). exfalso. assert (e0 : 0 = t) by (apply c; auto). assert (e1 : 1 = t) by (apply c;
      auto). lra.
  - destruct h as (a & b & c). exfalso. assert (e0 : 0 = u) by (apply c; auto). assert (e1 : 1 = u) by (apply c;
      auto). lra.
Qed.
Theorem ray_plane_unique : forall o v n d x y, ray_plane_spec o v n d x -> ray_plane_spec o v n d y -> x = y.
Proof.
  intros o v n d x y (_ & _ & _ & _ & _ & g) (_ & _ & _ & _ & _ & h).
  apply (line_plane_unique of_ray o v n d); auto; unfold of_ray; lra.
Qed.
Theorem segment_plane_unique : forall a b n d x y, segment_plane_spec a b n d x -> segment_plane_spec a b n d y ->
  x = y.
Proof.
  intros a b n d x y (_ & _ & _ & _ & g) (_ & _ & _ & _ & h).
  apply (line_plane_unique of_segment a (minus b a) n d); auto; unfold of_segment; lra.
Qed.
