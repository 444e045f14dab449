(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of collisions are enough, and their specifications leave no choice. *)
Require Import Reals Qreals QArith Lra Lia List.
From Certificates Require Import response language formulas_response formulas_collisions sound_response.
Import ListNotations.
Open Scope R_scope.

Theorem reflect_wall_sound : forall v w after first last,
  decide (check_reflect_wall v w after first last) = true -> reflect_wall_spec (r3 v) w (r3 after).
Proof.
  intros [[x y] z] w [[a b] c] first last h. apply decide_means in h. destruct h as (_ & _ & _ & h). simpl.
  destruct w; simpl in h; rewrite equal3; lra.
Qed.
Theorem reflect_wall_unique : forall v w x y, reflect_wall_spec v w x -> reflect_wall_spec v w y -> x = y.
Proof. intros [[x y] z] w a b -> ->; auto. Qed.

Lemma impulse_means : forall a b n e v w j first last, 0 <= value Q2R e <= 1 ->
  means Q2R (impulse_proves a b n e v w j first last) -> Q2R last <= Q2R first ->
  restitution_collision_spec (r_body a) (r_body b) (r3 n) (value Q2R e) (r3 v) (r3 w) /\
  Q2R first = 2 * total_energy [r_body a; r_body b] /\
  Q2R last = 2 * total_energy [(Q2R (fst a), r3 v); (Q2R (fst b), r3 w)].
Proof.
  intros a b n e v w j first last he h le. destruct h as (m & nz & pa & pb & apart & f & l).
  assert (mass := masses_mean _ m). simpl in nz. rewrite same3_means, term3_means in nz.
  simpl means in f, l. change (value Q2R (Leaf first)) with (Q2R first) in f.
  change (value Q2R (Leaf last)) with (Q2R last) in l.
  assert (ef : Q2R first = 2 * total_energy [r_body a; r_body b]) by (rewrite f; apply (energies_mean [a; b])).
  assert (el : Q2R last = 2 * total_energy [(Q2R (fst a), r3 v); (Q2R (fst b), r3 w)])
    by (rewrite l; apply (energies_mean [(fst a, v); (fst b, w)])).
  split; [|auto]. assert (ha := mass (r_body a) ltac:(simpl; auto)). assert (hb := mass (r_body b) ltac:(simpl; auto)).
  clear f l m. split; [exact mass|]. split; [exact nz|]. split; [exact he|]. clear mass nz.
  split; [|split; [|split]].
  - destruct a as [ma [[a1 a2] a3]], n as [[n1 n2] n3], v as [[v1 v2] v3]. simpl in pa, ha.
    exists (Q2R j / Q2R ma). simpl. rewrite equal3.
    assert (only : forall x y t, Q2R ma * (x - y) = Q2R j * t -> x = y + Q2R j / Q2R ma * t).
    { intros x y t g. apply (Rmult_eq_reg_l (Q2R ma)); [|lra].
      replace (Q2R ma * (y + Q2R j / Q2R ma * t)) with (Q2R ma * y + Q2R j * t) by (field; lra). lra. }
    destruct pa as (p1 & p2 & p3). auto.
  - destruct a as [ma [[a1 a2] a3]], b as [mb [[b1 b2] b3]], n as [[n1 n2] n3], v as [[v1 v2] v3], w as [[w1 w2] w3].
    simpl in pa, pb. simpl. rewrite equal3. lra.
  - destruct a as [ma [[a1 a2] a3]], b as [mb [[b1 b2] b3]], n as [[n1 n2] n3], v as [[v1 v2] v3], w as [[w1 w2] w3].
    simpl in apart. unfold minus3; simpl. lra.
  - simpl fst. lra.
Qed.
Theorem elastic_collision_sound : forall a b n v w j first last,
  decide (check_elastic_collision a b n v w j first last) = true ->
  elastic_collision_spec (r_body a) (r_body b) (r3 n) (r3 v) (r3 w).
Proof.
  intros a b n v w j first last h. apply decide_means in h. destruct h as [h e]. simpl in e.
  destruct (impulse_means _ _ _ one _ _ _ _ _ ltac:(simpl; lra) h ltac:(lra)) as (k & f & l).
  split; [exact k | simpl fst; lra].
Qed.
Theorem restitution_collision_sound : forall a b n e v w j first last,
  decide (check_restitution_collision a b n e v w j first last) = true ->
  restitution_collision_spec (r_body a) (r_body b) (r3 n) (Q2R e) (r3 v) (r3 w).
Proof.
  intros a b n e v w j first last h. apply decide_means in h. destruct h as (e0 & e1 & h & le & _). simpl in e0, e1, le.
  destruct (impulse_means _ _ _ (Leaf e) _ _ _ _ _ ltac:(simpl; lra) h le) as (k & _). exact k.
Qed.
Theorem restitution_collision_unique : forall a b n e v w v' w',
  restitution_collision_spec a b n e v w -> restitution_collision_spec a b n e v' w' -> v = v' /\ w = w'.
Proof.
  intros [ma [[a1 a2] a3]] [mb [[b1 b2] b3]] [[n1 n2] n3] e v [[w1 w2] w3] v' [[z1 z2] z3]
    (m & nz & _ & [j ->] & p & d & _) (_ & _ & _ & [k ->] & q & f & _).
  assert (ha := m (ma, (a1, a2, a3)) ltac:(simpl; auto)). assert (hb := m (mb, (b1, b2, b3)) ltac:(simpl; auto)).
  apply nonzero3 in nz. unfold minus3 in d, f. simpl in p, q, d, f, ha, hb. rewrite equal3 in p, q.
  set (s := n1 * n1 + n2 * n2 + n3 * n3) in *.
  assert (g : (j - k) * ((ma + mb) * s) = 0).
  { destruct p as (p1 & p2 & p3), q as (q1 & q2 & q3).
    assert (d1 : mb * (w1 - z1) = - ma * (j - k) * n1) by lra.
    assert (d2 : mb * (w2 - z2) = - ma * (j - k) * n2) by lra.
    assert (d3 : mb * (w3 - z3) = - ma * (j - k) * n3) by lra.
    assert (h : mb * (n1 * ((j - k) * n1) + n2 * ((j - k) * n2) + n3 * ((j - k) * n3)) =
                n1 * (mb * (w1 - z1)) + n2 * (mb * (w2 - z2)) + n3 * (mb * (w3 - z3))).
    { transitivity (mb * (n1 * (w1 - z1) + n2 * (w2 - z2) + n3 * (w3 - z3))); [|ring]. f_equal. lra. }
    rewrite d1, d2, d3 in h. unfold s. lra. }
  assert (0 < (ma + mb) * s) by (apply Rmult_lt_0_compat; lra).
  assert (jk : j = k) by (destruct (Rmult_integral _ _ g); lra). subst k. split; auto.
  assert (only : forall x y, mb * x = mb * y -> x = y) by (intros x y h; apply (Rmult_eq_reg_l mb); auto; lra).
  rewrite equal3. repeat split; apply only; lra.
Qed.
Theorem elastic_collision_unique : forall a b n v w v' w',
  elastic_collision_spec a b n v w -> elastic_collision_spec a b n v' w' -> v = v' /\ w = w'.
Proof. intros a b n v w v' w' [g _] [h _]. apply (restitution_collision_unique _ _ _ _ _ _ _ _ g h). Qed.

Theorem penalty_force_sound : forall p v n d k c force facts,
  decide (check_penalty_force p v n d k c force facts) = true ->
  penalty_force_spec (r3 p) (r3 v) (r3 n) (Q2R d) (Q2R k) (Q2R c) (r3 force).
Proof.
  intros p v n d k c force facts h. apply decide_means in h. destruct h as [nz h]. simpl in nz.
  rewrite same3_means, term3_means in nz. split; [exact nz|]. destruct facts as [| foot along].
  - destruct h as [e h]. rewrite same3_means, term3_means in h.
    destruct p as [[p1 p2] p3], n as [[n1 n2] n3]. simpl in e. split; [auto | simpl; lra].
  - destruct h as (e & z & cf & ca & across & h).
    split; [destruct p as [[p1 p2] p3], n as [[n1 n2] n3]; simpl in *; lra | intros _].
    rewrite same3_means in cf, ca, h. rewrite term3_means in h.
    destruct (along_normal (minus3 (r3 foot) (r3 p)) (r3 n) nz) as [t ht].
    { etransitivity; [|exact cf]. destruct foot as [[f1 f2] f3], p as [[p1 p2] p3], n as [[n1 n2] n3]. unfold minus3;
        simpl.
      rewrite equal3. repeat split; ring. }
    destruct (along_normal (r3 along) (r3 n) nz) as [s hs].
    { etransitivity; [|exact ca]. destruct along as [[f1 f2] f3], n as [[n1 n2] n3]. reflexivity. }
    exists t, s, (minus3 (r3 v) (r3 along)). rewrite <- ht, <- hs.
    destruct foot as [[f1 f2] f3], p as [[p1 p2] p3], n as [[n1 n2] n3], v as [[v1 v2] v3], along as [[a1 a2] a3],
      force as [[g1 g2] g3]. unfold minus3 in *; simpl in *. rewrite equal3 in h. rewrite !equal3. lra.
Qed.
Theorem penalty_force_unique : forall p v n d k c f g,
  penalty_force_spec p v n d k c f -> penalty_force_spec p v n d k c g -> f = g.
Proof.
  intros p v n d k c f g (nz & f0 & f1) (_ & g0 & g1). destruct (Rle_lt_dec 0 (dot3 n p + d)) as [h | h].
  - rewrite f0, g0; auto.
  - destruct (f1 h) as (t & s & w & e & hv & hw & ->). destruct (g1 h) as (t' & s' & w' & e' & hv' & hw' & ->).
    destruct n as [[n1 n2] n3], p as [[p1 p2] p3], w as [[w1 w2] w3], w' as [[z1 z2] z3]. apply nonzero3 in nz.
    rewrite hv in hv'. simpl in *. rewrite equal3 in hv'. destruct hv' as (v1 & v2 & v3).
    assert (et : (t - t') * (n1 * n1 + n2 * n2 + n3 * n3) = 0) by lra.
    assert (es : (s - s') * (n1 * n1 + n2 * n2 + n3 * n3) = 0).
    { transitivity (((s * n1 + w1) - (s' * n1 + z1)) * n1 + ((s * n2 + w2) - (s' * n2 + z2)) * n2 +
        ((s * n3 + w3) - (s' * n3 + z3)) * n3 - (w1 * n1 + w2 * n2 + w3 * n3) + (z1 * n1 + z2 * n2 + z3 * n3)); [ring|].
      rewrite v1, v2, v3, hw, hw'. ring. }
    assert (t = t') by (destruct (Rmult_integral _ _ et); lra).
    assert (s = s') by (destruct (Rmult_integral _ _ es); lra). subst; auto.
Qed.

(** ** Rigid bodies *)
Definition r_rigid (b : rigid Q) : rigid_body :=
  let '((mass, (x, y, z)), motion) := b in ((Q2R mass, (r3 x, r3 y, r3 z)), r_moving motion).

(** Squares completed, of a symmetric matrix with positive leading minors *)
Lemma positive_definite : forall a b c d f g x y z, 0 < a -> 0 < a * d - b * b ->
  0 < a * (d * g - f * f) - b * (b * g - f * c) + c * (b * f - d * c) -> ~ (x = 0 /\ y = 0 /\ z = 0) ->
  0 < x * (a * x + b * y + c * z) + y * (b * x + d * y + f * z) + z * (c * x + f * y + g * z).
Proof.
  intros a b c d f g x y z ha hm hd nz. set (m := a * d - b * b) in *. set (k := a * f - b * c).
  set (det := a * (d * g - f * f) - b * (b * g - f * c) + c * (b * f - d * c)) in *.
  set (q := x * (a * x + b * y + c * z) + y * (b * x + d * y + f * z) + z * (c * x + f * y + g * z)).
  assert (e : a * m * q = m * ((a * x + b * y + c * z) * (a * x + b * y + c * z)) +
    ((m * y + k * z) * (m * y + k * z) + a * det * (z * z))) by (unfold q, m, k, det; ring).
  assert (s1 := Rle_0_sqr (a * x + b * y + c * z)). assert (s2 := Rle_0_sqr (m * y + k * z)).
    assert (s3 := Rle_0_sqr z).
  unfold Rsqr in *. assert (am : 0 < a * m) by (apply Rmult_lt_0_compat; auto).
  assert (ad : 0 < a * det) by (apply Rmult_lt_0_compat; auto).
  assert (t1 := Rmult_le_pos m _ (Rlt_le _ _ hm) s1). assert (t3 := Rmult_le_pos (a * det) _ (Rlt_le _ _ ad) s3).
  apply Rnot_le_lt; intro n.
  assert (0 <= a * m * - q) by (apply Rmult_le_pos; lra).
  assert (z3 : a * det * (z * z) = 0) by lra. assert (z2 : (m * y + k * z) * (m * y + k * z) = 0) by lra.
  assert (z1 : m * ((a * x + b * y + c * z) * (a * x + b * y + c * z)) = 0) by lra.
  assert (hz : z = 0). { destruct (Rmult_integral _ _ z3) as [i | i]; [lra | destruct (Rmult_integral _ _ i); auto]. }
  subst z. assert (hy : m * y = 0) by (destruct (Rmult_integral _ _ z2); lra).
  assert (y = 0) by (destruct (Rmult_integral _ _ hy); lra). subst y.
  assert (hx : a * x = 0). { destruct (Rmult_integral _ _ z1) as [i | i]; [lra | destruct (Rmult_integral _ _ i);
    lra]. }
  assert (x = 0) by (destruct (Rmult_integral _ _ hx); lra). apply nz; auto.
Qed.
Lemma right_mass_means : forall b, means Q2R (right_mass b) -> right_body (r_rigid b).
Proof.
  intros [[mass [[[[a1 a2] a3] [[b1 b2] b3]] [[c1 c2] c3]]] [[p v] w]] h. simpl in h. simpl.
  destruct h as (hm & e1 & e2 & e3 & ha & hm2 & hd). rewrite e1, e2, e3 in *. split; [auto|]. split.
  - intros [[x1 x2] x3] [[y1 y2] y3]; simpl. ring.
  - intros [[x y] z] nz. rewrite equal3 in nz. simpl. apply positive_definite; auto; lra.
Qed.
Lemma pushed_means : forall b p push v w, means Q2R (is_pushed b p push v w) ->
  pushed (r_rigid b) (r3 p) (v3 push) (r3 v) (r3 w).
Proof.
  intros [[mass [[[[a1 a2] a3] [[b1 b2] b3]] [[c1 c2] c3]]] [[[[x1 x2] x3] [[y1 y2] y3]] [[z1 z2] z3]]] [[p1 p2] p3]
    [[q1 q2] q3] [[v1 v2] v3] [[w1 w2] w3] h. simpl in h. simpl. unfold minus3; simpl. rewrite !equal3. lra.
Qed.
Theorem rigid_body_collision_sound : forall a b p n e va wa vb wb j first last,
  decide (check_rigid_body_collision a b p n e va wa vb wb j first last) = true ->
  rigid_body_collision_spec (r_rigid a) (r_rigid b) (r3 p) (r3 n) (Q2R e) (r3 va, r3 wa) (r3 vb, r3 wb).
Proof.
  intros a b p n e va wa vb wb j first last h. apply decide_means in h. unfold check_rigid_body_collision in h.
  cbv zeta in h. destruct h as (ra & rb & nz & e0 & e1 & pa & pb & apart & _). simpl in nz.
  rewrite same3_means, term3_means in nz. apply right_mass_means in ra, rb. apply pushed_means in pa, pb.
  unfold rigid_body_collision_spec. cbv zeta. do 3 (split; [assumption|]). split; [exact (conj e0 e1)|]. split.
  - assert (after : forall (c : rigid Q) v w, v3 (motion_at c v w p) =
      velocity_at (fst (fst (snd (r_rigid c))), r3 v, r3 w) (r3 p)).
    { intros [[mass [[i1 i2] i3]] [[x y] z]] v w. apply velocity_means. }
    assert (before : forall c : rigid Q, v3 (motion_before c p) = velocity_at (snd (r_rigid c)) (r3 p)).
    { intros [[mass [[i1 i2] i3]] [[x y] z]]. apply velocity_means. }
    assert (inner : forall x y z : vec3 (term Q), value Q2R (inner3 x (gap3 y z)) = dot3 (v3 x) (minus3 (v3 y) (v3 z))).
    { intros [[x1 x2] x3] [[y1 y2] y3] [[z1 z2] z3]. unfold minus3; simpl. ring. }
    simpl means in apart. change (value Q2R (Sub zero (Leaf e) * ?t)%check) with ((0 - Q2R e) * value Q2R t) in apart.
    rewrite !inner, !after, !before, term3_means in apart. simpl fst. simpl snd. rewrite apart. simpl. ring.
  - exists (Q2R j). simpl fst. simpl snd. destruct n as [[n1 n2] n3]. split; [exact pa|].
    assert (t : v3 (scaled3 (zero - Leaf j)%check (term3 (n1, n2, n3))) = times3 (- Q2R j) (r3 (n1, n2, n3))).
    { simpl. rewrite equal3. repeat split; ring. }
    rewrite t in pb. exact pb.
Qed.

(** What another impulse changes has energy. *)
Lemma two_pushes : forall body p n s t v w v' w', right_body body -> pushed body p (times3 s n) v w ->
  pushed body p (times3 t n) v' w' -> exists g, 0 <= g /\
  (s - t) * dot3 n (minus3 (velocity_at (fst (fst (snd body)), v, w) p) (velocity_at (fst (fst (snd body)), v',
    w') p)) =
    (s - t) * (s - t) * dot3 n n / fst (fst body) + g.
Proof.
  intros [[m i] [[[[x1 x2] x3] [[y1 y2] y3]] [[z1 z2] z3]]] [[p1 p2] p3] [[n1 n2] n3] s t [[v1 v2] v3] [[w1 w2] w3]
    [[v1' v2'] v3'] [[w1' w2'] w3'] (hm & sym & pos) [h k] [h' k'].
  exists (dot3 (w1 - w1', w2 - w2', w3 - w3') (matrix_times i (w1 - w1', w2 - w2', w3 - w3'))). split.
  { destruct (Req_dec (w1 - w1') 0), (Req_dec (w2 - w2') 0), (Req_dec (w3 - w3') 0);
      try (apply Rlt_le, pos; rewrite equal3; tauto).
    rewrite H, H0, H1. destruct i as [[[[? ?] ?] [[? ?] ?]] [[? ?] ?]]; simpl; lra. }
  destruct i as [[[[a1 a2] a3] [[b1 b2] b3]] [[c1 c2] c3]]. unfold minus3 in *. simpl in *. rewrite !equal3 in *.
  destruct h as (h1 & h2 & h3), h' as (h1' & h2' & h3'), k as (k1 & k2 & k3), k' as (k1' & k2' & k3').
  assert (split3 : forall x y r, m * (x + -1 * y) = s * r -> forall x',
    m * (x' + -1 * y) = t * r -> x - x' = (s - t) * r / m).
  { intros x y r e x' f. apply (Rmult_eq_reg_l m); [|lra]. replace (m * ((s - t) * r / m)) with ((s - t) * r) by
      (field; lra). lra. }
  assert (d1 := split3 _ _ _ h1 _ h1'). assert (d2 := split3 _ _ _ h2 _ h2'). assert (d3 := split3 _ _ _ h3 _ h3').
  assert (i1 : a1 * (w1 - w1') + a2 * (w2 - w2') + a3 * (w3 - w3') = (s - t) * ((p2 + -1 * x2) * n3 - (p3 + -1 * x3)
    * n2)) by lra.
  assert (i2 : b1 * (w1 - w1') + b2 * (w2 - w2') + b3 * (w3 - w3') = (s - t) * ((p3 + -1 * x3) * n1 - (p1 + -1 * x1)
    * n3)) by lra.
  assert (i3 : c1 * (w1 - w1') + c2 * (w2 - w2') + c3 * (w3 - w3') = (s - t) * ((p1 + -1 * x1) * n2 - (p2 + -1 * x2)
    * n1)) by lra.
  rewrite i1, i2, i3.
  transitivity ((s - t) * (n1 * (v1 - v1') + n2 * (v2 - v2') + n3 * (v3 - v3')) +
    (s - t) * (n1 * ((w2 - w2') * (p3 + -1 * x3) - (w3 - w3') * (p2 + -1 * x2)) +
      n2 * ((w3 - w3') * (p1 + -1 * x1) - (w1 - w1') * (p3 + -1 * x3)) +
      n3 * ((w1 - w1') * (p2 + -1 * x2) - (w2 - w2') * (p1 + -1 * x1)))); [ring|].
  rewrite d1, d2, d3. field. lra.
Qed.
Lemma same_push : forall body p push v w v' w', right_body body -> pushed body p push v w -> pushed body p push v' w' ->
  v = v' /\ w = w'.
Proof.
  intros [[m i] [[[[x1 x2] x3] [[y1 y2] y3]] [[z1 z2] z3]]] p push [[v1 v2] v3] [[w1 w2] w3]
    [[v1' v2'] v3'] [[w1' w2'] w3'] (hm & sym & pos) [h k] [h' k']. rewrite <- h' in h. rewrite <- k' in k. split.
  - unfold minus3 in h. simpl in h. rewrite equal3 in *.
    assert (only : forall x y z, m * (x + -1 * z) = m * (y + -1 * z) -> x = y).
    { intros x y z e. apply (Rmult_eq_reg_l m) in e; lra. }
    destruct h as (h1 & h2 & h3). repeat split; eapply only; eauto.
  - assert (e : dot3 (w1 - w1', w2 - w2', w3 - w3') (matrix_times i (w1 - w1', w2 - w2', w3 - w3')) = 0).
    { destruct i as [[[[a1 a2] a3] [[b1 b2] b3]] [[c1 c2] c3]]. unfold minus3 in k. simpl in *. rewrite equal3 in k.
      destruct k as (k1 & k2 & k3).
      assert (i1 : a1 * (w1 - w1') + a2 * (w2 - w2') + a3 * (w3 - w3') = 0) by lra.
      assert (i2 : b1 * (w1 - w1') + b2 * (w2 - w2') + b3 * (w3 - w3') = 0) by lra.
      assert (i3 : c1 * (w1 - w1') + c2 * (w2 - w2') + c3 * (w3 - w3') = 0) by lra. rewrite i1, i2, i3. ring. }
    destruct (Req_dec (w1 - w1') 0), (Req_dec (w2 - w2') 0), (Req_dec (w3 - w3') 0);
      try (assert (g : (w1 - w1', w2 - w2', w3 - w3') <> (0, 0, 0)) by (rewrite equal3; tauto); apply pos in g; lra).
    rewrite equal3. lra.
Qed.
Theorem rigid_body_collision_unique : forall a b p n e x y x' y',
  rigid_body_collision_spec a b p n e x y -> rigid_body_collision_spec a b p n e x' y' -> x = x' /\ y = y'.
Proof.
  intros a b p n e [va wa] [vb wb] [va' wa'] [vb' wb'] (ra & rb & nz & _ & d & j & pa & pb) (_ & _ & _ & _ & d' & k &
    pa' & pb').
  cbv zeta in d, d'. simpl fst in *. simpl snd in *.
  destruct (two_pushes _ _ _ _ _ _ _ _ _ ra pa pa') as (ga & hga & ea).
  destruct (two_pushes _ _ _ _ _ _ _ _ _ rb pb pb') as (gb & hgb & eb).
  assert (hma : 0 < fst (fst a)) by (destruct a as [[m i] [[q v] w]]; apply ra).
  assert (hmb : 0 < fst (fst b)) by (destruct b as [[m i] [[q v] w]]; apply rb).
  assert (jk : j = k).
  { rewrite <- d in d'. set (A := velocity_at _ p) in d' at 1. 
    assert (split3 : forall n x y z w, dot3 n (minus3 x y) = dot3 n (minus3 z w) ->
      dot3 n (minus3 x z) = dot3 n (minus3 y w)).
    { intros [[n1 n2] n3] [[x1 x2] x3] [[y1 y2] y3] [[z1 z2] z3] [[w1 w2] w3]. unfold minus3; simpl. intro. lra. }
    unfold A in d'. symmetry in d'. apply split3 in d'. rewrite d' in ea.
    assert (s : 0 < dot3 n n) by (destruct n as [[n1 n2] n3]; apply nonzero3 in nz; exact nz).
    assert (c : 0 < dot3 n n / fst (fst a) + dot3 n n / fst (fst b)) by (apply Rplus_lt_0_compat;
      apply Rdiv_lt_0_compat; auto).
    assert (q := Rle_0_sqr (j - k)). unfold Rsqr in q.
    assert (f : (j - k) * (j - k) * (dot3 n n / fst (fst a) + dot3 n n / fst (fst b)) + (ga + gb) = 0).
    { unfold Rdiv in *. lra. }
    assert (0 <= (j - k) * (j - k) * (dot3 n n / fst (fst a) + dot3 n n / fst (fst b))) by (apply Rmult_le_pos; lra).
    assert (z : (j - k) * (j - k) * (dot3 n n / fst (fst a) + dot3 n n / fst (fst b)) = 0) by lra.
    destruct (Rmult_integral _ _ z) as [i | i]; [destruct (Rmult_integral _ _ i); lra | lra]. }
  subst k. destruct (same_push _ _ _ _ _ _ _ ra pa pa') as [-> ->].
    destruct (same_push _ _ _ _ _ _ _ rb pb pb') as [-> ->]. auto.
Qed.
