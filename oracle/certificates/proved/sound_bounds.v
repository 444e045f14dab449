(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of boxes and slabs around points are enough, and their specifications leave no choice. *)
Require Import Reals Qreals QArith Lra Lia List Arith Bool.
From Certificates Require Import solids language formulas_vectors formulas_solids formulas_slabs formulas_bounds
  sound_solids sound_slabs.
Import ListNotations.
Open Scope R_scope.

Lemma chosen_means : forall (points : list (list Q)) places, means Q2R (are_places points places) ->
  forall p, In p (chosen_from points places) -> In p points.
Proof.
  intros points places h p i. unfold are_places in h. rewrite all_means in h. apply in_map_iff in i.
  destruct i as (k & <- & i). specialize (h k i). rewrite if_so_means, Nat.ltb_lt in h. apply nth_In; auto.
Qed.
Lemma ends_mean : forall vs low high i j, means Q2R (ends_at vs low high i j) ->
  least_interval (values vs) (value Q2R low) (value Q2R high).
Proof.
  intros vs low high i j (a & b & c). apply at_index_means in a, b. rewrite all_means in c.
  destruct a as (v & iv & a), b as (w & iw & b). simpl in a, b. rewrite <- a, <- b. unfold values.
  split; [apply in_map; auto|]. split; [apply in_map; auto|].
  intros x h. apply in_map_iff in h. destruct h as (t & <- & h). rewrite a, b. exact (c t h).
Qed.
Lemma least_interval_unique : forall vs l h l' h', least_interval vs l h -> least_interval vs l' h' -> l = l' /\ h = h'.
Proof.
  intros vs l h l' h' (a & b & c) (a' & b' & c').
  assert (x := c l' a'). assert (y := c h' b'). assert (z := c' l a). assert (w := c' h b). lra.
Qed.

Theorem aabb_of_points_sound : forall points low high least greatest,
  decide (check_aabb_of_points points low high least greatest) = true ->
  aabb_of_points_spec (map rl points) (rl low) (rl high).
Proof.
  intros points low high least greatest h. apply decide_means in h. unfold check_aabb_of_points, as_long in h.
  cbv zeta in h. destruct h as (n & lh & lp & _ & _ & h). rewrite if_so_means in n, lh. rewrite Nat.eqb_eq in lh.
  apply two_or_three_means in n. rewrite all_means in lp. rewrite on_each_means in h.
  exists (length low). rewrite !rl_length. do 3 (split; [auto|]). split.
  - intros p i. apply in_map_iff in i. destruct i as (q & <- & i). specialize (lp q i). rewrite of_length_means in lp.
    rewrite rl_length; auto.
  - intros k hk. specialize (h k hk). apply ends_mean in h. rewrite !coordinate_means in h.
    replace (map (fun p => nth k p 0) (map rl points)) with (values (map (coordinate k) points)); auto.
    unfold values. rewrite !map_map. apply map_ext. intro p. apply coordinate_means.
Qed.
Lemma same_coordinates : forall x y, length x = length y -> (forall k,
  (k < length y)%nat -> nth k x 0 = nth k y 0) -> x = y.
Proof. intros x y l h. apply (nth_ext _ _ 0 0); auto. intros k hk. apply h. congruence. Qed.
Theorem aabb_of_points_unique : forall points l h l' h',
  aabb_of_points_spec points l h -> aabb_of_points_spec points l' h' -> l = l' /\ h = h'.
Proof.
  intros points l h l' h' (n & hn & l1 & l2 & p & g) (m & hm & l3 & l4 & q & k).
  destruct points as [|x points].
  - destruct (g O) as (i & _); [lia | destruct i].
  - assert (e : m = n) by (rewrite <- (p x), <- (q x); simpl; auto). subst m.
    split; apply same_coordinates; try congruence; intros c hc;
      destruct (least_interval_unique _ _ _ _ _ (g c ltac:(lia)) (k c ltac:(lia))); auto.
Qed.

Definition r_end (s : Q * Q) : R * R := (Q2R (fst s), Q2R (snd s)).
Lemma slabs_end_mean : forall points normals slabs least greatest,
  means Q2R (slabs_end points normals slabs least greatest) ->
  (forall n, In n (map rl normals) -> length n = 3%nat /\ nonzero n) /\
  Forall2 (fun n s => least_interval (map (dot n) (map rl points)) (fst s) (snd s)) (map rl normals) (map r_end slabs).
Proof.
  induction normals as [|n normals IH]; intros [|[low high] slabs] [|i least] [|j greatest] h; simpl in h; try tauto.
  - split; [simpl; tauto | constructor].
  - destruct h as (ln & nz & e & h). destruct (IH _ _ _ h) as [a b]. rewrite of_length_means in ln.
    split.
    + intros m [<- | k]; [rewrite rl_length; split; [auto | apply not_zero_means; auto] | auto].
    + simpl. constructor; auto. apply ends_mean in e. simpl in e. simpl.
      replace (map (dot (rl n)) (map rl points)) with (values (map (fun p => inner (leaves n) (leaves p)) points));
        auto.
      unfold values. rewrite !map_map. apply map_ext. intro p. rewrite inner_means, !leaves_mean. auto.
Qed.
Theorem kdop_of_points_sound : forall points normals slabs least greatest,
  decide (check_kdop_of_points points normals slabs least greatest) = true ->
  kdop_of_points_spec (map rl points) (map rl normals) (map r_end slabs).
Proof.
  intros points normals slabs least greatest h. apply decide_means in h. destruct h as (lp & some & h).
  rewrite all_means in lp. rewrite if_so_means, negb_true_iff, Nat.eqb_neq in some. apply slabs_end_mean in h.
  destruct h as [a b]. split; [|split; [exact a | split; [|exact b]]].
  - intros p i. apply in_map_iff in i. destruct i as (q & <- & i). specialize (lp q i). rewrite of_length_means in lp.
    rewrite rl_length; auto.
  - destruct normals; [simpl in some; tauto | discriminate].
Qed.
Theorem kdop_of_points_unique : forall points normals s t,
  kdop_of_points_spec points normals s -> kdop_of_points_spec points normals t -> s = t.
Proof.
  intros points normals s t (_ & _ & _ & g) (_ & _ & _ & h). revert t h.
  induction g as [|n [l k] normals s e g IH]; intros t h; inversion h as [|m [l' k'] normals' t' f h']; subst; auto.
  rewrite (IH t' h'). simpl in e, f. destruct (least_interval_unique _ _ _ _ _ e f) as [-> ->]. auto.
Qed.
