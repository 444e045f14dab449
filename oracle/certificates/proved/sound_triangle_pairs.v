(* SPDX-License-Identifier: Apache-2.0 *)
(** The formula of two triangles is enough, and its specification leaves no choice. *)
Require Import Reals Qreals QArith Lra Lia List Arith Bool.
From Certificates Require Import hulls solids response language formulas_vectors formulas_nearest formulas_triangles
  formulas_triangle_pairs sound_solids sound_vectors sound_nearest sound_courses sound_response sound_triangles
  sound_ray_triangle.
Import ListNotations.
Open Scope R_scope.

Lemma decided : forall c, means Q2R c \/ ~ means Q2R c.
Proof.
  intro c. destruct (decide c) eqn:e; [left; apply decide_means; auto|]. right. intro h. apply decide_means in h.
  congruence.
Qed.

(** ** What the planes leave holds all common points *)
Definition weighs (l : list (@corner Q)) (x : list R) (a b c : R) : Prop :=
  match l with
  | [(p, k); (q, m); (r, n)] =>
      0 <= a /\ 0 <= b /\ 0 <= c /\ a + b + c = 1 /\
      x = [a * nth 0 (rl p) 0 + b * nth 0 (rl q) 0 + c * nth 0 (rl r) 0;
           a * nth 1 (rl p) 0 + b * nth 1 (rl q) 0 + c * nth 1 (rl r) 0;
           a * nth 2 (rl p) 0 + b * nth 2 (rl q) 0 + c * nth 2 (rl r) 0] /\
      (means Q2R k \/ a = 0) /\ (means Q2R m \/ b = 0) /\ (means Q2R n \/ c = 0)
  | _ => False
  end.
Definition supported (l : list (@corner Q)) (x : list R) : Prop := exists a b c, weighs l x a b c.
Definition of_three (l : list (@corner Q)) : Prop := forall c, In c l -> length (fst c) = 3%nat.
Lemma one_side : forall s n d l x, s <> 0 -> length n = 3%nat -> of_three l -> supported l x ->
  (forall c, In c l -> means Q2R (snd c) -> s * (dot (rl n) (rl (fst c)) - Q2R d) <= 0) ->
  s * (dot (rl n) x - Q2R d) <= 0 /\
  (s * (dot (rl n) x - Q2R d) = 0 -> supported (map (still_left n d) l) x).
Proof.
  intros s n d l x ns ln len (a & b & c & h) side.
  destruct l as [|[p k] [|[q m] [|[r o] [|]]]]; try (simpl in h; tauto).
  assert (lp := len (p, k) ltac:(simpl; auto)). assert (lq := len (q, m) ltac:(simpl; auto)).
  assert (lr := len (r, o) ltac:(simpl; auto)). simpl in lp, lq, lr.
  apply three_numbers in ln, lp, lq, lr. destruct ln as (n0 & n1 & n2 & ->), lp as (p0 & p1 & p2 & ->),
    lq as (q0 & q1 & q2 & ->), lr as (r0 & r1 & r2 & ->).
  assert (sp := side ([p0; p1; p2], k) ltac:(simpl; auto)). assert (sq := side ([q0; q1; q2], m) ltac:(simpl; auto)).
  assert (sr := side ([r0; r1; r2], o) ltac:(simpl; auto)). clear side len.
  destruct h as (ha & hb & hc & one & -> & wa & wb & wc). simpl in sp, sq, sr, wa, wb, wc. simpl rl. simpl nth.
  set (hp := Q2R n0 * Q2R p0 + (Q2R n1 * Q2R p1 + (Q2R n2 * Q2R p2 + 0)) - Q2R d) in *.
  set (hq := Q2R n0 * Q2R q0 + (Q2R n1 * Q2R q1 + (Q2R n2 * Q2R q2 + 0)) - Q2R d) in *.
  set (hr := Q2R n0 * Q2R r0 + (Q2R n1 * Q2R r1 + (Q2R n2 * Q2R r2 + 0)) - Q2R d) in *.
  match goal with |- s * (?dot - _) <= 0 /\ _ => assert (e : dot - Q2R d = a * hp + b * hq + c * hr) end.
  { transitivity (dot (rl [n0; n1; n2]) [a * Q2R p0 + b * Q2R q0 + c * Q2R r0; a * Q2R p1 + b * Q2R q1 + c * Q2R r1;
      a * Q2R p2 + b * Q2R q2 + c * Q2R r2] - Q2R d * (a + b + c)); [rewrite one, Rmult_1_r; reflexivity|].
    unfold hp, hq, hr. simpl. ring. }
  rewrite e. clear e.
  assert (term : forall w h (k' : cond Q), 0 <= w -> (means Q2R k' -> s * h <= 0) -> means Q2R k' \/ w = 0 ->
    w * (s * h) <= 0).
  { intros w h k' hw f [g | ->]; [|lra]. specialize (f g). assert (0 <= w * - (s * h)) by (apply Rmult_le_pos; lra).
    lra. }
  assert (ta := term a hp k ha sp wa). assert (tb := term b hq m hb sq wb). assert (tc := term c hr o hc sr wc).
  split; [lra|]. intro z. exists a, b, c. simpl. fold hp hq hr. do 4 (split; [assumption|]). split; [reflexivity|].
  assert (left_ : forall w h (k' : cond Q), w * (s * h) = 0 -> means Q2R k' \/ w = 0 ->
    (means Q2R k' /\ h = 0) \/ w = 0).
  { intros w h k' f [g | g]; [|auto]. destruct (Rmult_integral _ _ f) as [i | i]; [auto|].
    destruct (Rmult_integral _ _ i); [tauto | auto]. }
  split; [|split]; apply left_; auto; lra.
Qed.
Lemma still_of_three : forall n d l, of_three l -> of_three (map (still_left n d) l).
Proof. intros n d l h c i. apply in_map_iff in i. destruct i as (e & <- & i). exact (h e i). Qed.
Lemma cut_by_means : forall planes a b rest, of_three a -> of_three b -> means Q2R (cut_by planes a b rest) ->
  exists a' b', of_three a' /\ of_three b' /\ means Q2R (rest a' b') /\
    forall x, supported a x -> supported b x -> supported a' x /\ supported b' x.
Proof.
  induction planes as [|[n d] planes IH]; intros a b rest la lb h.
  - exists a, b. auto.
  - destruct h as (ln & ha & hb & h). rewrite of_length_means in ln. rewrite all_means in ha, hb.
    destruct (IH _ _ _ (still_of_three n d a la) (still_of_three n d b lb) h) as (a' & b' & la' & lb' & r & s).
    exists a', b'. do 3 (split; [assumption|]). intros x sa sb.
    destruct (one_side 1 n d a x ltac:(lra) ln la sa) as [g1 g2].
    { intros c i k. specialize (ha c i). simpl in ha.
      rewrite inner_means, !leaves_mean in ha. destruct ha; [tauto | lra]. }
    destruct (one_side (-1) n d b x ltac:(lra) ln lb sb) as [g3 g4].
    { intros c i k. specialize (hb c i). simpl in hb.
      rewrite inner_means, !leaves_mean in hb. destruct hb; [tauto | lra]. }
    apply s; [apply g2 | apply g4]; lra.
Qed.
Lemma hull_supported : forall points x, points_of 3 3 (map rl points) -> hull 3 (map rl points) x ->
  supported (map (fun p => (p, Yes)) points) x.
Proof.
  intros points x hp hx. destruct hp as [cp hp]. rewrite map_length in cp. apply three_numbers in cp.
  destruct cp as (p & q & r & ->). apply mixture_three in hx; try (apply hp; simpl; auto).
  destruct hx as (a & b & c & ha & hb & hc & one & e). exists a, b, c. simpl. tauto.
Qed.

(** ** The ways between common points *)
Definition gap (x y : list R) : vec3 R :=
  (nth 0 y 0 - nth 0 x 0, nth 1 y 0 - nth 1 x 0, nth 2 y 0 - nth 2 x 0).
Definition guarded (l : list (@corner Q)) (d : vec3 R) : Prop :=
  match l with
  | [(p, k); (q, m); (r, n)] =>
      means Q2R k /\ means Q2R m /\ d = gap (rl p) (rl q) \/ means Q2R k /\ means Q2R n /\ d = gap (rl p) (rl r) \/
      means Q2R m /\ means Q2R n /\ d = gap (rl q) (rl r)
  | _ => False
  end.
Definition linear (P : vec3 R -> Prop) : Prop :=
  P (0, 0, 0) /\ (forall t d, P d -> P (times3 t d)) /\ forall d e, P d -> P e -> P (add3 d e).
Lemma ways_span : forall l x y (P : vec3 R -> Prop), linear P -> supported l x -> supported l y ->
  (forall d, guarded l d -> P d) -> P (gap x y).
Proof.
  intros l x y P (zero & multiple & sum) (a & b & c & h) (a' & b' & c' & h') all.
  destruct l as [|[p k] [|[q m] [|[r n] [|]]]]; try (simpl in h; tauto). simpl in h, h', all.
  destruct h as (_ & _ & _ & one & -> & wa & wb & wc), h' as (_ & _ & _ & one' & -> & wa' & wb' & wc').
  assert (ka : means Q2R k \/ a' - a = 0) by (destruct wa, wa'; auto; right; lra).
  assert (kb : means Q2R m \/ b' - b = 0) by (destruct wb, wb'; auto; right; lra).
  assert (kc : means Q2R n \/ c' - c = 0) by (destruct wc, wc'; auto; right; lra).
  assert (part : forall t d, P d \/ t = 0 -> P (times3 t d)).
  { intros t d [g | ->]; [apply multiple; auto|]. destruct d as [[d0 d1] d2]. simpl.
    replace (0 * d0, 0 * d1, 0 * d2) with (0, 0, 0); [auto | rewrite equal3; repeat split; ring]. }
  destruct ka as [ka | ka].
  - assert (g : P (add3 (times3 (b' - b) (gap (rl p) (rl q))) (times3 (c' - c) (gap (rl p) (rl r))))).
    { apply sum; apply part; [destruct kb | destruct kc]; auto; left; apply all; tauto. }
    match goal with |- P ?z => match type of g with P ?w => replace z with w; [exact g|] end end.
    unfold gap. simpl. rewrite equal3. replace a with (1 - b - c) by lra. replace a' with (1 - b' - c') by lra.
    repeat split; ring.
  - assert (g : P (times3 (c' - c) (gap (rl q) (rl r)))).
    { apply part. destruct kc as [kc | kc]; [|auto]. destruct kb as [kb | kb]; [left; apply all; tauto | right; lra]. }
    match goal with |- P ?z => match type of g with P ?w => replace z with w; [exact g|] end end.
    unfold gap. simpl. rewrite equal3. replace b with (1 - a - c) by lra. replace b' with (1 - a - c') by lra.
    replace a' with a by lra. repeat split; ring.
Qed.
Lemma linear_zero : linear (fun d => d = (0, 0, 0)).
Proof.
  split; [auto|]. split; [intros t d -> | intros d e -> ->]; simpl; rewrite equal3; repeat split; ring.
Qed.
Lemma linear_cross : forall e, linear (fun d => cross3 d e = (0, 0, 0)).
Proof.
  intros [[e0 e1] e2]. split; [simpl; rewrite equal3; repeat split; ring|]. split.
  - intros t [[d0 d1] d2] h. simpl in *. rewrite equal3 in *. destruct h as (h0 & h1 & h2).
    repeat split; [rewrite <- (Rmult_0_r t), <- h0 | rewrite <- (Rmult_0_r t), <- h1 | rewrite <- (Rmult_0_r t), <- h2];
      ring.
  - intros [[d0 d1] d2] [[f0 f1] f2] h k. simpl in *. rewrite equal3 in *. lra.
Qed.
Lemma linear_dot : forall e, linear (fun d => dot3 d e = 0).
Proof.
  intros [[e0 e1] e2]. split; [simpl; ring|]. split.
  - intros t [[d0 d1] d2] h. simpl in *. rewrite <- (Rmult_0_r t), <- h. ring.
  - intros [[d0 d1] d2] [[f0 f1] f2] h k. simpl in *. lra.
Qed.
Lemma cross_turned : forall d e, cross3 d e = (0, 0, 0) -> cross3 e d = (0, 0, 0).
Proof. intros [[d0 d1] d2] [[e0 e1] e2] h. simpl in *. rewrite equal3 in *. lra. Qed.
Lemma nonzero_or_not : forall d : vec3 R, d = (0, 0, 0) \/ d <> (0, 0, 0).
Proof.
  intros [[a b] c]. rewrite equal3. destruct (Req_dec a 0), (Req_dec b 0), (Req_dec c 0); tauto.
Qed.

Definition tri (x : list R) : vec3 R := (nth 0 x 0, nth 1 x 0, nth 2 x 0).
Definition rnormal (l : list (@corner Q)) : vec3 R := tri (values (normal_of l)).
Lemma gap_means : forall p q, length p = 3%nat -> length q = 3%nat ->
  length (difference (leaves q) (leaves p)) = 3%nat /\
  tri (values (difference (leaves q) (leaves p))) = gap (rl p) (rl q).
Proof.
  intros p q lp lq. apply three_numbers in lp, lq. destruct lp as (p0 & p1 & p2 & ->), lq as (q0 & q1 & q2 & ->). auto.
Qed.
Lemma no_vector_three : forall x : list (term Q), length x = 3%nat ->
  (means Q2R (no_vector x) <-> tri (values x) = (0, 0, 0)).
Proof.
  intros x l. apply three_numbers in l. destruct l as (a & b & c & ->). unfold tri. simpl. rewrite equal3. tauto.
Qed.
Lemma outer_means : forall x y : list (term Q), length x = 3%nat -> length y = 3%nat ->
  length (outer_product x y) = 3%nat /\ tri (values (outer_product x y)) = cross3 (tri (values x)) (tri (values y)).
Proof.
  intros x y lx ly. apply three_numbers in lx, ly. destruct lx as (a & b & c & ->), ly as (d & e & f & ->). auto.
Qed.
Lemma inner_three : forall x y : list (term Q), length x = 3%nat -> length y = 3%nat ->
  value Q2R (inner x y) = dot3 (tri (values x)) (tri (values y)).
Proof.
  intros x y lx ly. apply three_numbers in lx, ly. destruct lx as (a & b & c & ->), ly as (d & e & f & ->).
  unfold tri. simpl. ring.
Qed.
Lemma some_way_means : forall l f, of_three l -> means Q2R (some_way l f) ->
  exists d, length d = 3%nat /\ guarded l (tri (values d)) /\ means Q2R (f d).
Proof.
  intros l f len h. destruct l as [|[p k] [|[q m] [|[r n] [|]]]]; try (simpl in h; tauto).
  assert (lp := len (p, k) ltac:(simpl; auto)). assert (lq := len (q, m) ltac:(simpl; auto)).
  assert (lr := len (r, n) ltac:(simpl; auto)). simpl in lp, lq, lr.
  destruct (gap_means p q lp lq) as [l1 e1], (gap_means p r lp lr) as [l2 e2], (gap_means q r lq lr) as [l3 e3].
  destruct h as [(hk & hm & h) | [(hk & hn & h) | (hm & hn & h)]]; eexists; (split; [|split; [|exact h]]); auto; simpl;
    rewrite ?e1, ?e2, ?e3; tauto.
Qed.
Lemma no_way_means : forall l f, of_three l -> ~ means Q2R (some_way l f) -> forall d, guarded l d ->
  exists t, length t = 3%nat /\ tri (values t) = d /\ ~ means Q2R (f t).
Proof.
  intros l f len h d g. destruct l as [|[p k] [|[q m] [|[r n] [|]]]]; try (simpl in g; tauto).
  assert (lp := len (p, k) ltac:(simpl; auto)). assert (lq := len (q, m) ltac:(simpl; auto)).
  assert (lr := len (r, n) ltac:(simpl; auto)). simpl in lp, lq, lr.
  destruct (gap_means p q lp lq) as [l1 e1], (gap_means p r lp lr) as [l2 e2], (gap_means q r lq lr) as [l3 e3].
  simpl means in h.
  destruct g as [(hk & hm & ->) | [(hk & hn & ->) | (hm & hn & ->)]]; eexists; (split; [|split]);
    [exact l1 | exact e1 | tauto | exact l2 | exact e2 | tauto | exact l3 | exact e3 | tauto].
Qed.
Lemma normal_means : forall l, of_three l -> length l = 3%nat -> length (normal_of l) = 3%nat /\
  forall d, guarded l d -> dot3 d (rnormal l) = 0.
Proof.
  intros l len c. apply three_numbers in c. destruct c as ([p k] & [q m] & [r n] & ->).
  assert (lp := len (p, k) ltac:(simpl; auto)). assert (lq := len (q, m) ltac:(simpl; auto)).
  assert (lr := len (r, n) ltac:(simpl; auto)). simpl in lp, lq, lr.
  destruct (gap_means p q lp lq) as [l1 e1], (gap_means p r lp lr) as [l2 e2].
  destruct (outer_means _ _ l1 l2) as [l3 e3]. unfold rnormal. simpl normal_of. split; [auto|].
  rewrite e3, e1, e2. intros d [(_ & _ & ->) | [(_ & _ & ->) | (_ & _ & ->)]]; unfold gap; simpl; ring.
Qed.
Lemma parallel : forall l, of_three l -> ~ means Q2R (has_plane l) -> forall d e, guarded l d -> guarded l e ->
  cross3 d e = (0, 0, 0).
Proof.
  intros l len h d e gd ge. destruct l as [|[p k] [|[q m] [|[r n] [|]]]]; try (simpl in gd; tauto).
  assert (lp := len (p, k) ltac:(simpl; auto)). assert (lq := len (q, m) ltac:(simpl; auto)).
  assert (lr := len (r, n) ltac:(simpl; auto)). simpl in lp, lq, lr.
  destruct (gap_means p q lp lq) as [l1 e1], (gap_means p r lp lr) as [l2 e2].
  destruct (outer_means _ _ l1 l2) as [l3 e3].
  assert (z : means Q2R k -> means Q2R m -> means Q2R n -> cross3 (gap (rl p) (rl q)) (gap (rl p) (rl r)) = (0, 0, 0)).
  { intros hk hm hn. rewrite <- e1, <- e2, <- e3. apply no_vector_three; [exact l3|].
    destruct (decided (no_vector (normal_of [(p, k); (q, m); (r, n)]))) as [y | y]; [exact y|]. exfalso. apply h.
    exact (conj hk (conj hm (conj hn y))). }
  unfold gap in *. simpl in z, gd, ge.
  destruct gd as [(h1 & h2 & ->) | [(h1 & h2 & ->) | (h1 & h2 & ->)]],
    ge as [(h3 & h4 & ->) | [(h3 & h4 & ->) | (h3 & h4 & ->)]]; simpl; rewrite equal3;
    first [repeat split; ring |
      assert (y := z ltac:(assumption) ltac:(assumption) ltac:(assumption)); rewrite equal3 in y; lra].
Qed.
