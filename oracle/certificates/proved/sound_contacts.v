(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of bodies in several contacts are enough, and their specification leaves no choice. *)
Require Import Reals Qreals QArith Lra Lia List Arith Bool.
From Certificates Require Import response solids language formulas_vectors formulas_contacts sound_solids sound_vectors
  sound_slabs unique_slabs sound_nearest.
Import ListNotations.
Open Scope R_scope.

Definition r_point_body (body : Q * list Q) : R * list R := (Q2R (fst body), rl (snd body)).
Definition r_contact (c : nat * nat * list Q) : nat * nat * list R := (fst c, rl (snd c)).
Definition keeps (body : R * list R) (after : list R) : Prop :=
  length after = 3%nat /\ (fst body = 0 -> after = snd body).
Definition right_bodies (bodies : list (R * list R)) : Prop :=
  forall body, In body bodies -> 0 <= fst body /\ length (snd body) = 3%nat.
Definition right_contacts (count : nat) (contacts : list (nat * nat * list R)) : Prop :=
  forall a b n, In (a, b, n) contacts -> (a < count)%nat /\ (b < count)%nat /\ a <> b /\ length n = 3%nat /\ nonzero n.

(** ** How fast contacts part *)
Lemma parting_means : forall v c, value Q2R (parting_term v c) = parting (map rl v) (r_contact c).
Proof.
  intros v [[a b] n]. simpl. rewrite inner_means, difference_means, !leaves_mean.
  rewrite <- (map_nth rl v nil a), <- (map_nth rl v nil b). reflexivity.
Qed.
Definition asked (before : list (list R)) (e : R) (c : nat * nat * list R) : R := e * Rmax 0 (- parting before c).
Lemma demand_means : forall before e c,
  value Q2R (demand before e c) = asked (map rl before) (Q2R e) (r_contact c).
Proof.
  intros. unfold demand, asked. simpl. rewrite parting_means. f_equal. f_equal. apply Rminus_0_l.
Qed.
Lemma dot_nothing : forall n, dot n nil = 0.
Proof. intros [|a n]; auto. Qed.
Lemma parting_apart : forall v a b n, (forall x, In x v -> length x = 3%nat) -> (a < length v)%nat ->
  (b < length v)%nat -> parting v (a, b, n) = dot n (nth a v nil) - dot n (nth b v nil).
Proof.
  intros v a b n h la lb. simpl. apply dot_minus. rewrite (h (nth a v nil)), (h (nth b v nil)); auto; apply nth_In;
    auto.
Qed.
Arguments parting : simpl never. Arguments parting_term : simpl never.
Lemma kept_lengths : forall bodies v, Forall2 keeps bodies v ->
  length v = length bodies /\ forall x, In x v -> length x = 3%nat.
Proof.
  intros bodies v k. induction k as [|body x bodies v [l _] k [e IH]]; simpl; [split; [auto | tauto]|].
  split; [auto|]. intros y [<- | i]; auto.
Qed.

(** ** What impulses do to bodies, and what they do to contacts *)
Fixpoint push (i : nat) (contacts : list (nat * nat * list R)) (impulses : list R) : list R :=
  match contacts, impulses with
  | (a, b, n) :: contacts', j :: impulses' =>
      let others := push i contacts' impulses' in
      if a =? i then plus (times j n) others else if b =? i then plus (times (0 - j) n) others else others
  | _, _ => repeat 0 3
  end.
Lemma push_means : forall i contacts impulses,
  values (push_on i contacts impulses) = push i (map r_contact contacts) (rl impulses).
Proof.
  intro i. induction contacts as [|[[a b] n] contacts IH]; intros [|j impulses]; try reflexivity.
  simpl. destruct (a =? i); [|destruct (b =? i)]; rewrite ?sum_means, ?scaled_means, ?leaves_mean, IH; auto.
Qed.
Lemma push_length : forall i contacts impulses, (forall a b n, In (a, b, n) contacts -> length n = 3%nat) ->
  length (push i contacts impulses) = 3%nat.
Proof.
  intro i. induction contacts as [|[[a b] n] contacts IH]; intros [|j impulses] h; try reflexivity.
  assert (l := h a b n ltac:(simpl; auto)). assert (k := IH impulses ltac:(intros; eapply h; simpl; eauto)).
  simpl. destruct (a =? i); [|destruct (b =? i)]; rewrite ?plus_length; auto; rewrite times_length; congruence.
Qed.
Fixpoint work (i : nat) contacts impulses (d : list (list R)) : R :=
  match d with [] => 0 | x :: d' => dot (push i contacts impulses) x + work (S i) contacts impulses d' end.
Fixpoint picked (i k : nat) (n : list R) (d : list (list R)) : R :=
  match d with [] => 0 | x :: d' => (if k =? i then dot n x else 0) + picked (S i) k n d' end.
Lemma picked_before : forall d i k n, (k < i)%nat -> picked i k n d = 0.
Proof.
  induction d as [|x d IH]; intros i k n h; simpl; auto.
  replace (k =? i) with false by (symmetry; apply Nat.eqb_neq; lia). rewrite IH by lia. ring.
Qed.
Lemma picked_nth : forall d i k n, picked i (i + k) n d = dot n (nth k d nil).
Proof.
  induction d as [|x d IH]; intros i k n; simpl.
  - destruct k; rewrite dot_nothing; auto.
  - destruct k as [|k].
    + rewrite Nat.add_0_r, Nat.eqb_refl, picked_before by lia. ring.
    + replace (i + S k =? i) with false by (symmetry; apply Nat.eqb_neq; lia).
      replace (i + S k)%nat with (S i + k)%nat by lia. rewrite IH. ring.
Qed.
Lemma work_step : forall d i a b n j contacts impulses, a <> b -> length n = 3%nat ->
  (forall a b n, In (a, b, n) contacts -> length n = 3%nat) ->
  work i ((a, b, n) :: contacts) (j :: impulses) d =
  j * (picked i a n d - picked i b n d) + work i contacts impulses d.
Proof.
  induction d as [|x d IH]; intros i a b n j contacts impulses ne l h; [simpl; ring|].
  assert (k := push_length i contacts impulses h). simpl work. simpl picked. rewrite IH by auto.
  destruct (a =? i) eqn:ea; [destruct (b =? i) eqn:eb|destruct (b =? i) eqn:eb].
  - apply Nat.eqb_eq in ea, eb. congruence.
  - rewrite (dot_sym (plus _ _)), dot_plus, dot_times, !(dot_sym x) by (rewrite times_length; congruence). ring.
  - rewrite (dot_sym (plus _ _)), dot_plus, dot_times, !(dot_sym x) by (rewrite times_length; congruence). ring.
  - ring.
Qed.
Fixpoint parted (contacts : list (nat * nat * list R)) (impulses : list R) (v : list (list R)) : R :=
  match contacts, impulses with
  | c :: contacts', j :: impulses' => j * parting v c + parted contacts' impulses' v
  | _, _ => 0
  end.
Lemma work_nothing : forall v i contacts impulses, contacts = [] \/ impulses = [] -> work i contacts impulses v = 0.
Proof.
  induction v as [|x v IH]; intros i contacts impulses h; simpl; auto. rewrite IH by auto.
  assert (e : push i contacts impulses = repeat 0 3).
  { destruct h as [-> | ->]; [reflexivity|]. destruct contacts as [|[[? ?] ?] ?]; reflexivity. }
  rewrite e, dot_sym, dot_zeros. ring.
Qed.
(** The impulses on the bodies move the contacts. *)
Lemma work_parts : forall contacts impulses v, right_contacts (length v) contacts ->
  (forall x, In x v -> length x = 3%nat) -> work 0 contacts impulses v = parted contacts impulses v.
Proof.
  induction contacts as [|[[a b] n] contacts IH]; intros [|j impulses] v h l; try (apply work_nothing; auto).
  - destruct (h a b n ltac:(simpl; auto)) as (la & lb & ne & ln & _).
    rewrite work_step, IH; auto.
    + simpl parted. rewrite parting_apart by auto. rewrite (picked_nth v 0 a), (picked_nth v 0 b). auto.
    + intros a' b' n' i. apply (h a' b' n'). simpl; auto.
    + intros a' b' n' i. apply (h a' b' n'). simpl; auto.
Qed.

(** ** Velocities that the impulses make change least *)
Lemma zero_times : forall x y z, length x = length y -> minus x y = times 0 z -> x = y.
Proof.
  unfold times. induction x as [|a x IH]; intros [|b y] [|c z] l e; simpl in *; try discriminate; auto.
  injection e; intros e' e0. rewrite (IH y z) by (auto; lia). f_equal. lra.
Qed.
Lemma body_changes : forall w p u v x, 0 <= w -> length v = length u -> length x = length u -> length p = length u ->
  minus v u = times w p -> (w = 0 -> x = u) -> sqdist u v / w + 2 * (dot p x - dot p v) <= sqdist u x / w.
Proof.
  intros w p u v x hw lv lx lp e still. destruct (Req_dec w 0) as [z | nz].
  - rewrite still by auto. rewrite z in e. rewrite (zero_times v u p) by auto. lra.
  - assert (d : forall z, w * dot p z = dot v z - dot u z).
    { intro z. rewrite <- times_dot, <- e, minus_dot; auto. }
    assert (g := dot_self (minus x v)). rewrite square_of_difference in g by congruence. rewrite (dot_sym x v) in g.
    apply (Rmult_le_reg_l w); [lra|].
    replace (w * (sqdist u v / w + 2 * (dot p x - dot p v))) with (sqdist u v + 2 * (w * dot p x - w * dot p v))
      by (field; auto).
    replace (w * (sqdist u x / w)) with (sqdist u x) by (field; auto). rewrite !d.
    rewrite !sqdist_dot, !square_of_difference by congruence. rewrite (dot_sym u v). lra.
Qed.
Lemma change_least : forall contacts impulses bodies i v x,
  (forall a b n, In (a, b, n) (map r_contact contacts) -> length n = 3%nat) ->
  right_bodies (map r_point_body bodies) -> means Q2R (are_pushed i bodies contacts impulses v) ->
  Forall2 keeps (map r_point_body bodies) x ->
  change (map r_point_body bodies) (map rl v) +
    2 * (work i (map r_contact contacts) (rl impulses) x - work i (map r_contact contacts) (rl impulses) (map rl v))
  <= change (map r_point_body bodies) x.
Proof.
  intros contacts impulses bodies. induction bodies as [|[w u] bodies IH]; intros i [|after v] x hn hb h k;
    try solve [destruct h]; simpl in k; inversion k as [|? y ? x' [ly ky] k']; subst; simpl; [lra|].
  destruct h as (la & e & h). rewrite of_length_means in la.
  rewrite same_vector_means, difference_means, scaled_means, !leaves_mean, push_means in e.
  destruct (hb (r_point_body (w, u)) ltac:(simpl; auto)) as [hw lu]. simpl in hw, lu, ky, e.
  assert (r := IH (S i) v x' hn ltac:(intros body j; apply hb; simpl; auto) h k').
  assert (s := body_changes (Q2R w) (push i (map r_contact contacts) (rl impulses)) (rl u) (rl after) y hw
    ltac:(rewrite !rl_length in *; congruence) ltac:(congruence)
    ltac:(rewrite push_length; [congruence | exact hn]) e ky).
  lra.
Qed.
Lemma pushed_keeps : forall contacts impulses bodies i v, right_bodies (map r_point_body bodies) ->
  means Q2R (are_pushed i bodies contacts impulses v) -> Forall2 keeps (map r_point_body bodies) (map rl v).
Proof.
  intros contacts impulses. induction bodies as [|[w u] bodies IH]; intros i [|after v] hb h; try solve [destruct h];
    [constructor|].
  destruct h as (la & e & h). rewrite of_length_means in la.
  rewrite same_vector_means, difference_means, scaled_means, !leaves_mean, push_means in e.
  destruct (hb (r_point_body (w, u)) ltac:(simpl; auto)) as [_ lu]. simpl in lu, e.
  simpl. constructor; [|apply (IH (S i)); auto; intros body j; apply hb; simpl; auto].
  split; [rewrite rl_length; auto|]. simpl. intro z. rewrite z in e. eapply zero_times; [|exact e].
  rewrite !rl_length in *. congruence.
Qed.
Lemma none_pulls : forall before e v x contacts impulses, length impulses = length contacts ->
  (forall j, In j impulses -> 0 <= j) ->
  (forall j c, In (j, c) (combine impulses contacts) -> j = 0 \/ parting v c = asked before e c) ->
  (forall c, In c contacts -> asked before e c <= parting x c) ->
  parted contacts impulses v <= parted contacts impulses x.
Proof.
  intros before e v x. induction contacts as [|c contacts IH]; intros [|j impulses] l pos h k; try discriminate;
    simpl; [lra|].
  assert (r := IH impulses ltac:(simpl in l; lia) ltac:(intros; apply pos; simpl; auto)
    ltac:(intros; apply h; simpl; auto) ltac:(intros; apply k; simpl; auto)).
  assert (hj := pos j ltac:(simpl; auto)). assert (hk := k c ltac:(simpl; auto)).
  destruct (h j c ltac:(simpl; auto)) as [-> | e']; [lra|].
  assert (j * parting v c <= j * parting x c) by (apply Rmult_le_compat_l; lra). lra.
Qed.

(** ** A contradiction *)
Lemma zeros_dot : forall x y, means Q2R (all (fun t => t = zero)%check x) -> dot (values x) y = 0.
Proof. induction x as [|a x IH]; intros [|b y] h; simpl; auto. destruct h as [e h]. simpl in e. rewrite e.
  fold (values x). rewrite IH; auto. ring. Qed.
Lemma cancel_means : forall contacts weights bodies i v, means Q2R (cancel i bodies contacts weights) ->
  Forall2 keeps (map r_point_body bodies) v ->
  work i (map r_contact contacts) (rl weights) v =
  work i (map r_contact contacts) (rl weights) (map snd (map r_point_body bodies)).
Proof.
  intros contacts weights. induction bodies as [|[w u] bodies IH]; intros i v h k; simpl in k;
    inversion k as [|? y ? v' [_ ky] k']; subst; simpl; auto.
  destruct h as [h g]. rewrite (IH (S i) v' g k'). destruct h as [z | z].
  - simpl in z, ky. rewrite ky; auto.
  - rewrite <- push_means, !zeros_dot by exact z. auto.
Qed.
Lemma missing_means : forall before e v contacts weights, (forall j, In j weights -> 0 <= Q2R j) ->
  (forall c, In c (map r_contact contacts) -> asked (map rl before) (Q2R e) c <= parting v c) ->
  value Q2R (missing before e contacts weights) + parted (map r_contact contacts) (rl weights) (map rl before)
  <= parted (map r_contact contacts) (rl weights) v.
Proof.
  intros before e v. induction contacts as [|c contacts IH]; intros [|j weights] pos h; simpl; try lra.
  assert (r := IH weights ltac:(intros; apply pos; simpl; auto) ltac:(intros; apply h; simpl; auto)).
  assert (hj := pos j ltac:(simpl; auto)). assert (hc := h (r_contact c) ltac:(simpl; auto)).
  change (Q2R e * Rmax 0 (0 - value Q2R (parting_term before c))) with (value Q2R (demand before e c)).
  rewrite demand_means, parting_means.
  assert (Q2R j * asked (map rl before) (Q2R e) (r_contact c) <= Q2R j * parting v (r_contact c))
    by (apply Rmult_le_compat_l; lra).
  lra.
Qed.

Definition r_velocities (w : option (list (list Q))) : option (list (list R)) := option_map (map rl) w.
Lemma velocities_before : forall bodies, map snd (map r_point_body bodies) = map rl (map snd bodies).
Proof. intro. rewrite !map_map. auto. Qed.
Theorem simultaneous_collisions_sound : forall bodies contacts e answer facts,
  decide (check_simultaneous_collisions bodies contacts e answer facts) = true ->
  simultaneous_collisions_spec (map r_point_body bodies) (map r_contact contacts) (Q2R e) (r_velocities answer).
Proof.
  intros bodies contacts e answer facts h. apply decide_means in h. unfold check_simultaneous_collisions in h.
  cbv zeta in h. destruct h as (hb & e0 & e1 & hc & h). rewrite all_means in hb.
  rewrite all_means in hc. simpl in e0, e1.
  assert (rb : right_bodies (map r_point_body bodies)).
  { intros body i. apply in_map_iff in i. destruct i as (q & <- & i). destruct (hb q i) as [a b].
    rewrite of_length_means in b. simpl in a. split; [exact a | simpl; rewrite rl_length; auto]. }
  assert (rc : right_contacts (length bodies) (map r_contact contacts)).
  { intros a b n i. apply in_map_iff in i. destruct i as ([[a' b'] n'] & q & i).
    unfold r_contact in q. simpl in q. injection q; intros; subst.
    assert (g := hc _ i). cbv beta iota in g. destruct g as (ha & hb' & ne & ln & nz).
    rewrite if_so_means in ha, hb', ne. rewrite Nat.ltb_lt in ha, hb'. rewrite negb_true_iff, Nat.eqb_neq in ne.
    rewrite of_length_means in ln. rewrite rl_length. do 4 (split; [assumption|]).
    apply not_zero_means; auto. }
  assert (normals : forall a b n, In (a, b, n) (map r_contact contacts) -> length n = 3%nat)
    by (intros a b n i; apply (rc a b n i)).
  assert (lengths : forall v, Forall2 keeps (map r_point_body bodies) v ->
    length v = length bodies /\ forall x, In x v -> length x = 3%nat).
  { intros v k. rewrite <- (map_length r_point_body bodies). apply kept_lengths; auto. }
  split; [exact rb|]. split; [lra|]. split; [rewrite map_length; exact rc|].
  destruct answer as [v|], facts as [impulses | weights]; try solve [destruct h]; simpl r_velocities; cbv iota.
  - destruct h as ((l & pos) & pushed & h). rewrite if_so_means, Nat.eqb_eq in l. rewrite all_means in pos.
    rewrite all_means in h.
    assert (kv := pushed_keeps _ _ _ _ _ rb pushed).
    assert (met : forall j c, In (j, c) (combine (rl impulses) (map r_contact contacts)) ->
      asked (map rl (map snd bodies)) (Q2R e) c <= parting (map rl v) c /\
      (j = 0 \/ parting (map rl v) c = asked (map rl (map snd bodies)) (Q2R e) c)).
    { intros j c i. assert (q : combine (rl impulses) (map r_contact contacts) =
        map (fun p => (Q2R (fst p), r_contact (snd p))) (combine impulses contacts)).
      { clear. revert contacts. induction impulses as [|k impulses IH]; intros [|c contacts]; simpl; auto.
        rewrite IH; auto. }
      rewrite q in i. apply in_map_iff in i. destruct i as ([j' c'] & q' & i). simpl in q'. injection q'; intros <- <-.
      specialize (h _ i). simpl in h. destruct h as [a b].
      change (Q2R e * Rmax 0 (0 - value Q2R (parting_term (map snd bodies) c'))) with
        (value Q2R (demand (map snd bodies) e c')) in a, b.
      rewrite demand_means, parting_means in a, b. auto. }
    assert (pos' : forall j, In j (rl impulses) -> 0 <= j).
    { intros j i. apply in_map_iff in i. destruct i as (q & <- & i). exact (pos q i). }
    assert (l' : length (rl impulses) = length (map r_contact contacts)) by (rewrite rl_length, map_length; auto).
    split.
    + split; [exact kv|]. intros c i. rewrite velocities_before.
      destruct (with_each (rl impulses) (map r_contact contacts) c l' i) as [j ij].
      exact (proj1 (met j c ij)).
    + intros x [kx hx]. rewrite velocities_before in hx.
      assert (r := change_least _ _ _ _ _ _ normals rb pushed kx). destruct (lengths _ kv) as [lv lv'].
      destruct (lengths _ kx) as [lx lx'].
      rewrite (work_parts _ _ x), (work_parts _ _ (map rl v)) in r by (rewrite ?lx, ?lv; assumption).
      assert (s := none_pulls (map rl (map snd bodies)) (Q2R e) (map rl v) x (map r_contact contacts) (rl impulses) l'
        pos' ltac:(intros j c i; exact (proj2 (met j c i))) hx).
      lra.
  - destruct h as ((l & pos) & c & less). rewrite all_means in pos. simpl in less. intros v [kv hv].
    rewrite velocities_before in hv. destruct (lengths _ kv) as [lv lv'].
    assert (r := missing_means (map snd bodies) e v contacts weights pos hv).
    assert (s := cancel_means _ _ _ _ _ c kv). rewrite velocities_before in s.
    assert (lb : forall x, In x (map rl (map snd bodies)) -> length x = 3%nat).
    { rewrite <- velocities_before. intros x i. apply in_map_iff in i. destruct i as (q & <- & i). apply (rb q i). }
    rewrite (work_parts _ _ v) in s by (rewrite ?lv; assumption).
    rewrite (work_parts _ _ (map rl (map snd bodies))) in s by (rewrite ?map_length; assumption). lra.
Qed.

(** ** The middle of two answers *)
Fixpoint middles (x y : list (list R)) : list (list R) :=
  match x, y with a :: x', b :: y' => middle a b :: middles x' y' | _, _ => nil end.
Lemma nth_middles : forall x y k, length x = length y -> nth k (middles x y) nil = middle (nth k x nil) (nth k y nil).
Proof. induction x as [|a x IH]; intros [|b y] [|k] l; simpl in *; try discriminate; auto. Qed.
Lemma dot_middle : forall n x y, length x = length y -> dot n (middle x y) = (dot n x + dot n y) / 2.
Proof.
  induction n as [|c n IH]; intros [|a x] [|b y] l; simpl in *; try discriminate; try lra. rewrite IH by lia. field.
Qed.
Lemma middle_same : forall x, middle x x = x.
Proof. induction x as [|a x IH]; simpl; auto. rewrite IH. f_equal. field. Qed.
Lemma middles_keep : forall bodies v x, Forall2 keeps bodies v -> Forall2 keeps bodies x ->
  Forall2 keeps bodies (middles v x).
Proof.
  intros bodies v x h. revert x. induction h as [|body y bodies v [l k] h IH]; intros x g;
    inversion g as [|? z ? x' [l' k'] g']; subst; simpl; constructor; auto.
  split; [rewrite middle_length; congruence|]. intro e. rewrite k, k' by auto. apply middle_same.
Qed.
Lemma middles_change : forall bodies v x, right_bodies bodies -> Forall2 keeps bodies v -> Forall2 keeps bodies x ->
  2 * change bodies (middles v x) <= change bodies v + change bodies x /\
  (change bodies v + change bodies x <= 2 * change bodies (middles v x) -> v = x).
Proof.
  intros bodies v x rb h. revert x. induction h as [|[w u] y bodies v [l k] h IH]; intros x g;
    inversion g as [|? z ? x' [l' k'] g']; subst; simpl; [split; [lra | auto]|].
  destruct (rb (w, u) ltac:(simpl; auto)) as [hw lu]. simpl in hw, lu, k, k'.
  destruct (IH ltac:(intros body i; apply rb; simpl; auto) x' g') as [c d].
  destruct (Req_dec w 0) as [e | ne].
  - rewrite k, k' by auto. rewrite middle_same. split; [lra|]. intro f. rewrite d; auto. lra.
  - assert (m := middle_nearer u y z ltac:(congruence) ltac:(congruence)). assert (q := sqdist_nonneg y z).
    assert (m' : 2 * (sqdist u (middle y z) / w) + sqdist y z / 2 / w = sqdist u y / w + sqdist u z / w).
    { apply (Rmult_eq_reg_l w); auto. transitivity (2 * sqdist u (middle y z) + sqdist y z / 2); [field; auto|].
      transitivity (sqdist u y + sqdist u z); [lra | field; auto]. }
    assert (q' : 0 <= sqdist y z / 2 / w).
    { apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; lra]. }
    split; [lra|]. intro f. rewrite d by lra. f_equal. apply sqdist_zero; [congruence|].
    assert (z0 : sqdist y z / 2 / w <= 0) by lra. apply (Rmult_le_compat_l w) in z0; [|lra].
    replace (w * (sqdist y z / 2 / w)) with (sqdist y z / 2) in z0 by (field; auto). lra.
Qed.
Lemma middles_allowed : forall bodies contacts e v x, right_contacts (length bodies) contacts ->
  allowed bodies contacts e v -> allowed bodies contacts e x -> allowed bodies contacts e (middles v x).
Proof.
  intros bodies contacts e v x rc [kv hv] [kx hx]. split; [apply middles_keep; auto|]. intros [[a b] n] i.
  destruct (rc a b n i) as (la & lb & _). specialize (hv _ i). specialize (hx _ i).
  destruct (kept_lengths _ _ kv) as [lv lv'], (kept_lengths _ _ kx) as [lx lx'].
  destruct (kept_lengths _ _ (middles_keep _ _ _ kv kx)) as [lm lm'].
  rewrite (parting_apart (middles v x) a b n lm') by (rewrite lm; assumption).
  rewrite (parting_apart v a b n lv') in hv by (rewrite lv; assumption).
  rewrite (parting_apart x a b n lx') in hx by (rewrite lx; assumption).
  assert (at_a : length (nth a v nil) = length (nth a x nil))
    by (rewrite (lv' (nth a v nil)), (lx' (nth a x nil)); auto; apply nth_In; lia).
  assert (at_b : length (nth b v nil) = length (nth b x nil))
    by (rewrite (lv' (nth b v nil)), (lx' (nth b x nil)); auto; apply nth_In; lia).
  rewrite !nth_middles, !dot_middle by congruence. lra.
Qed.
Theorem simultaneous_collisions_unique : forall bodies contacts e v w,
  simultaneous_collisions_spec bodies contacts e v -> simultaneous_collisions_spec bodies contacts e w -> v = w.
Proof.
  intros bodies contacts e v w (rb & _ & rc & g) (_ & _ & _ & h).
  destruct v as [v|], w as [w|]; auto.
  - destruct g as [g least], h as [h least']. f_equal. assert (m := middles_allowed _ _ _ _ _ rc g h).
    destruct (middles_change bodies v w rb (proj1 g) (proj1 h)) as [_ same]. apply same.
    assert (a := least _ m). assert (b := least' _ m). lra.
  - exfalso. apply (h v), g.
  - exfalso. apply (g w), h.
Qed.
