(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of boxes and balls are enough. *)
Require Import Reals Qreals QArith Lra Lia List Arith Bool.
From Certificates Require Import solids language formulas_vectors formulas_solids.
Import ListNotations.
Open Scope R_scope.


(** ** Distances *)
Lemma square : forall a, 0 <= a * a.
Proof. intro a; apply (Rle_0_sqr a). Qed.
Lemma sqdist_nonneg : forall x y, 0 <= sqdist x y.
Proof. induction x as [|a x IH]; destruct y as [|b y]; simpl; try lra. specialize (IH y).
  assert (g := square (a - b)). lra. Qed.
Lemma sqdist_sym : forall x y, sqdist x y = sqdist y x.
Proof. induction x as [|a x IH]; destruct y as [|b y]; simpl; auto. rewrite IH; ring. Qed.
Lemma sqdist_self : forall x, sqdist x x = 0.
Proof. induction x as [|a x IH]; simpl; auto. rewrite IH; ring. Qed.
Lemma sqdist_zero : forall x y, length x = length y -> sqdist x y <= 0 -> x = y.
Proof.
  induction x as [|a x IH]; destruct y as [|b y]; simpl; intros l h; auto; try discriminate.
  assert (g := sqdist_nonneg x y). injection l; intro l'.
  assert (0 <= (a - b) * (a - b)) by apply square.
  rewrite (IH y); auto; [|lra]. f_equal. assert (z : (a - b) * (a - b) = 0) by lra.
  destruct (Rmult_integral _ _ z); lra.
Qed.

(** The triangle inequality without roots, first weighted *)
Lemma weighted : forall r s x y z, length x = length z -> length y = length z -> 0 < r -> 0 < s ->
  r * s * sqdist x y <= s * (r + s) * sqdist x z + r * (r + s) * sqdist z y.
Proof.
  induction x as [|a x IH]; destruct y as [|b y], z as [|c z]; simpl; intros; try discriminate; try lra.
  assert (g : r * s * sqdist x y <= s * (r + s) * sqdist x z + r * (r + s) * sqdist z y) by (apply IH; auto).
  assert (0 <= (s * (a - c) - r * (c - b)) * (s * (a - c) - r * (c - b))) by apply square.
  replace (r * s * ((a - b) * (a - b) + sqdist x y)) with
    (s * (r + s) * ((a - c) * (a - c)) + r * (r + s) * ((c - b) * (c - b))
     - (s * (a - c) - r * (c - b)) * (s * (a - c) - r * (c - b)) + r * s * sqdist x y) by ring.
  lra.
Qed.
Lemma triangle_strict : forall r s x y z, length x = length z -> length y = length z -> 0 <= r -> 0 <= s ->
  sqdist x z < r * r -> sqdist z y < s * s -> sqdist x y < (r + s) * (r + s).
Proof.
  intros r s x y z lx ly hr hs h k. assert (n := sqdist_nonneg x z). assert (m := sqdist_nonneg z y).
  assert (0 < r) by (destruct (Req_dec r 0); [subst; lra | lra]).
  assert (0 < s) by (destruct (Req_dec s 0); [subst; lra | lra]).
  assert (w := weighted r s x y z lx ly H H0).
  assert (0 < r * s) by (apply Rmult_lt_0_compat; auto).
  assert (s * (r + s) * sqdist x z < s * (r + s) * (r * r)) by (apply Rmult_lt_compat_l; auto;
    apply Rmult_lt_0_compat; lra).
  assert (r * (r + s) * sqdist z y < r * (r + s) * (s * s)) by (apply Rmult_lt_compat_l; auto;
    apply Rmult_lt_0_compat; lra).
  apply (Rmult_lt_reg_l (r * s)); auto. lra.
Qed.
Lemma triangle : forall r s x y z, length x = length z -> length y = length z -> 0 <= r -> 0 <= s ->
  sqdist x z <= r * r -> sqdist z y <= s * s -> sqdist x y <= (r + s) * (r + s).
Proof.
  intros r s x y z lx ly hr hs h k.
  destruct (Req_dec r 0) as [e | nr]; [subst; apply sqdist_zero in h || (rewrite Rmult_0_l in h;
    apply sqdist_zero in h); auto; subst; rewrite Rplus_0_l; auto|].
  destruct (Req_dec s 0) as [e | ns]; [subst; rewrite Rmult_0_l in k; apply sqdist_zero in k; auto; subst;
    rewrite Rplus_0_r; auto|].
  assert (hr' : 0 < r) by lra. assert (hs' : 0 < s) by lra.
  assert (w := weighted r s x y z lx ly hr' hs').
  assert (0 < r * s) by (apply Rmult_lt_0_compat; auto).
  assert (s * (r + s) * sqdist x z <= s * (r + s) * (r * r)) by (apply Rmult_le_compat_l; auto; apply Rmult_le_pos;
    lra).
  assert (r * (r + s) * sqdist z y <= r * (r + s) * (s * s)) by (apply Rmult_le_compat_l; auto; apply Rmult_le_pos;
    lra).
  apply (Rmult_le_reg_l (r * s)); auto. lra.
Qed.

(** ** What is inside a set is in it *)
Lemma interior_in : forall n S x, interior n S x -> S x.
Proof. intros n S x [l [e [he h]]]. apply h; auto. rewrite sqdist_self. apply Rmult_lt_0_compat; auto. Qed.

(** ** The interior of a ball *)
Lemma inside_ball : forall n c r x, length c = n -> length x = n -> 0 <= r -> sqdist c x < r * r ->
  interior n (ball c r) x.
Proof.
  intros n c r x lc lx hr h. split; auto. assert (g := sqdist_nonneg c x).
  set (q := sqrt (sqdist c x)). assert (q2 : q * q = sqdist c x) by (apply sqrt_def; auto).
  assert (q0 : 0 <= q) by apply sqrt_pos.
  assert (qr : q < r) by (apply Rsqr_incrst_0; unfold Rsqr; lra).
  set (d := (q + r) / 2). assert (0 < d) by (unfold d; lra).
  assert (sqdist c x < d * d). { rewrite <- q2. apply Rmult_le_0_lt_compat; unfold d; lra. }
  exists (r - d). split; [unfold d; lra|]. intros y ly k. unfold ball. left.
  replace (r * r) with ((d + (r - d)) * (d + (r - d))) by ring.
  apply (triangle_strict d (r - d) c y x); auto; try congruence; unfold d; lra.
Qed.

(** A point moved on the ray from c through x *)
Fixpoint further (d : R) (c x : list R) : list R :=
  match c, x with a :: c', b :: x' => b + d * (b - a) :: further d c' x' | _, _ => nil end.
Lemma further_length : forall d c x, length c = length x -> length (further d c x) = length x.
Proof. induction c as [|a c IH]; destruct x as [|b x]; simpl; intros; try discriminate; auto. Qed.
Lemma further_moved : forall d c x, sqdist x (further d c x) = d * d * sqdist c x.
Proof. induction c as [|a c IH]; destruct x as [|b x]; simpl; intros; try ring. rewrite IH; ring. Qed.
Lemma further_away : forall d c x, sqdist c (further d c x) = (1 + d) * (1 + d) * sqdist c x.
Proof. induction c as [|a c IH]; destruct x as [|b x]; simpl; intros; try ring. rewrite IH; ring. Qed.

(** A point moved along an axis *)
Fixpoint shift (k : nat) (d : R) (x : list R) : list R :=
  match x, k with b :: x', O => b + d :: x' | b :: x', S k' => b :: shift k' d x' | nil, _ => nil end.
Lemma shift_length : forall x k d, length (shift k d x) = length x.
Proof. induction x as [|b x IH]; destruct k; simpl; intros; auto. Qed.
Lemma shift_moved : forall x k d, (k < length x)%nat -> sqdist x (shift k d x) = d * d.
Proof.
  induction x as [|b x IH]; destruct k; simpl; intros; try lia.
  - rewrite sqdist_self; ring.
  - rewrite IH; [ring | lia].
Qed.
Lemma shift_nth : forall x k d, (k < length x)%nat -> nth k (shift k d x) 0 = nth k x 0 + d.
Proof. induction x as [|b x IH]; destruct k; simpl; intros; try lia; auto. apply IH; lia. Qed.

Lemma interior_ball : forall n c r x, (0 < n)%nat -> length c = n -> 0 <= r -> interior n (ball c r) x ->
  sqdist c x < r * r.
Proof.
  intros n c r x hn lc hr [lx [e [he h]]]. apply Rnot_le_lt; intro k.
  assert (g := sqdist_nonneg c x).
  destruct (Req_dec (sqdist c x) 0) as [z | z].
  - assert (c = x) by (apply sqdist_zero; [congruence | lra]). subst c.
    assert (r0 : r * r = 0) by nra.
    assert (m : ball x r (shift 0 (e / 2) x)).
    { apply h; [rewrite shift_length; auto | rewrite shift_moved; [nra | lia]]. }
    unfold ball in m. rewrite shift_moved in m; [nra | lia].
  - assert (in_x : ball c r x) by (apply h; auto; rewrite sqdist_self; nra). unfold ball in in_x.
    assert (eq : sqdist c x = r * r) by lra. assert (0 < r) by (destruct (Req_dec r 0); [subst; lra | lra]).
    set (d := e / (2 * r)). assert (0 < d) by (apply Rdiv_lt_0_compat; lra).
    assert (dr : d * r = e / 2) by (unfold d; field; lra).
    assert (m : ball c r (further d c x)).
    { apply h; [rewrite further_length; congruence | rewrite further_moved, eq].
      replace (d * d * (r * r)) with ((d * r) * (d * r)) by ring. rewrite dr. nra. }
    unfold ball in m. rewrite further_away, eq in m.
    assert (0 < r * r) by (apply Rmult_lt_0_compat; auto). nra.
Qed.

(** ** The interior of a box *)
Lemma interior_box : forall n l h x k, interior n (box l h) x -> (k < n)%nat -> nth k l 0 < nth k x 0 < nth k h 0.
Proof.
  intros n l h x k [lx [e [he H]]] hk. subst n.
  assert (up : box l h (shift k (e / 2) x)).
  { apply H; [apply shift_length | rewrite shift_moved; [nra | auto]]. }
  assert (down : box l h (shift k (- (e / 2)) x)).
  { apply H; [apply shift_length | rewrite shift_moved; [nra | auto]]. }
  specialize (up k); specialize (down k). rewrite shift_length, shift_nth in up, down; auto.
  specialize (up hk); specialize (down hk). lra.
Qed.

Lemma inside_box : forall x l h, (forall k, (k < length x)%nat -> nth k l 0 < nth k x 0 < nth k h 0) ->
  interior (length x) (box l h) x.
Proof.
  induction x as [|b x IH]; intros l h H.
  - split; auto. exists 1. split; [lra|]. intros y ly _ k hk. rewrite ly in hk; simpl in hk; lia.
  - assert (H0 := H O ltac:(simpl; lia)). simpl in H0.
    destruct (IH (tl l) (tl h)) as [_ [e [he He]]].
    { intros k hk. assert (Hk := H (S k) ltac:(simpl; lia)). simpl in Hk. destruct l, h; simpl in *; auto;
        destruct k; auto. }
    split; auto. exists (Rmin e (Rmin (b - nth 0 l 0) (nth 0 h 0 - b))). split.
    { repeat apply Rmin_glb_lt; lra. }
    set (m := Rmin e _). assert (m1 : m <= e) by apply Rmin_l.
    assert (m2 : m <= b - nth 0 l 0) by (eapply Rle_trans; [apply Rmin_r | apply Rmin_l]).
    assert (m3 : m <= nth 0 h 0 - b) by (eapply Rle_trans; [apply Rmin_r | apply Rmin_r]).
    assert (mp : 0 < m) by (repeat apply Rmin_glb_lt; lra).
    intros [|c y] ly d; simpl in ly; [discriminate|]. injection ly; intro ly'. simpl in d.
    assert (g := sqdist_nonneg x y).
    intros k hk. destruct k; simpl.
    + change (match l with nil => 0 | x0 :: _ => x0 end) with (nth 0 l 0).
      change (match h with nil => 0 | x0 :: _ => x0 end) with (nth 0 h 0).
      assert (0 <= (b - c) * (b - c)) by apply square.
      assert (near : Rsqr (b - c) < Rsqr m) by (unfold Rsqr; lra).
      apply Rsqr_lt_abs_0 in near. rewrite (Rabs_right m) in near by lra. apply Rabs_def2 in near. lra.
    + assert (me : m * m <= e * e) by (apply Rmult_le_compat; lra).
      assert (g' := square (b - c)). assert (B : box (tl l) (tl h) y) by (apply He; auto; lra).
      specialize (B k ltac:(simpl in hk; lia)). destruct l, h; simpl in *; auto; destruct k; auto.
Qed.

(** ** What the checks mean *)
Lemma squared_distance_means : forall x y, value Q2R (squared_distance x y) = sqdist (rl x) (rl y).
Proof.
  induction x as [|a x IH]; destruct y as [|b y]; simpl; auto. rewrite IH; auto.
Qed.
Lemma coordinate_means : forall x k, value Q2R (coordinate k x) = nth k (rl x) 0.
Proof. induction x as [|a x IH]; destruct k; simpl; auto. apply IH. Qed.
Lemma on_each_means : forall f n, means Q2R (on_each n f) <-> forall k, (k < n)%nat -> means Q2R (f k).
Proof.
  induction n; simpl.
  - split; intros; auto; lia.
  - rewrite IHn. split.
    + intros [g h] k hk. destruct (Nat.eq_dec k n); [subst; auto | apply g; lia].
    + intro g; split; intros; apply g; lia.
Qed.
Lemma two_or_three_means : forall x : list Q, two_or_three x = true -> (length x = 2 \/ length x = 3)%nat.
Proof. unfold two_or_three; intros x h; apply orb_true_iff in h; rewrite !Nat.eqb_eq in h; auto. Qed.

Theorem sphere_sphere_sound : forall c r d s w facts, decide (check_sphere_sphere c r d s w facts) = true ->
  sphere_sphere_spec (rl c) (Q2R r) (rl d) (Q2R s) w.
Proof.
  intros c r d s w facts h. apply decide_means in h. unfold check_sphere_sphere, as_long in h.
  cbv zeta in h. simpl in h. rewrite !if_so_means, !Nat.eqb_eq in h. destruct h as (n & ld & hr & hs & h).
  apply two_or_three_means in n. exists (length c). unfold proper_ball. rewrite !rl_length. repeat (split; auto).
  assert (pos : (0 < length c)%nat) by (destruct n; lia).
  destruct w, facts; simpl in h; try tauto; rewrite ?if_so_means, ?Nat.eqb_eq, ?squared_distance_means in h; simpl.
  - destruct h as [-> far]. intros x lx [a b]. unfold ball in a, b. rewrite sqdist_sym in b.
    assert (t := triangle (Q2R r) (Q2R s) (rl c) (rl d) x). rewrite !rl_length in t.
    specialize (t ltac:(congruence) ltac:(congruence) hr hs a b). lra.
  - destruct h as (lx & a & b & e). split.
    + exists (rl x). rewrite rl_length; auto.
    + intros y [a' b']. assert (ly := proj1 a').
      apply interior_ball in a', b'; auto; try (rewrite rl_length; congruence).
      rewrite sqdist_sym in b'.
      assert (t := triangle_strict (Q2R r) (Q2R s) (rl c) (rl d) y). rewrite !rl_length in t.
      specialize (t ltac:(congruence) ltac:(congruence) hr hs a' b'). lra.
  - destruct h as (lx & a & b & e). split.
    + exists (rl x). rewrite rl_length; auto.
    + intros y [a' b']. apply interior_ball in a', b'; auto; try (rewrite rl_length; congruence).
      assert (g := sqdist_nonneg (rl c) y). assert (g' := sqdist_nonneg (rl d) y).
      destruct e as [z | z]; rewrite z in *; lra.
  - destruct h as (lx & a & b). exists (rl x). split; apply inside_ball; auto; rewrite rl_length; congruence.
Qed.

Lemma box_means : forall n x l h, length x = n ->
  means Q2R (on_each n (fun k => And (Le (coordinate k l) (coordinate k x)) (Le (coordinate k x) (coordinate k h)))) ->
  box (rl l) (rl h) (rl x).
Proof.
  intros n x l h lx m k hk. rewrite on_each_means in m. rewrite rl_length, lx in hk. specialize (m k hk).
  simpl in m. rewrite !coordinate_means in m. auto.
Qed.
Lemma inside_means : forall n x l h, length x = n ->
  means Q2R (on_each n (fun k => And (Lt (coordinate k l) (coordinate k x)) (Lt (coordinate k x) (coordinate k h)))) ->
  interior n (box (rl l) (rl h)) (rl x).
Proof.
  intros n x l h lx m. subst n. rewrite <- (rl_length x). apply inside_box. rewrite rl_length.
  intros k hk. rewrite on_each_means in m. specialize (m k hk). simpl in m. rewrite !coordinate_means in m. auto.
Qed.

Theorem aabb_aabb_sound : forall la ha lb hb w facts, decide (check_aabb_aabb la ha lb hb w facts) = true ->
  aabb_aabb_spec (rl la) (rl ha) (rl lb) (rl hb) w.
Proof.
  intros la ha lb hb w facts h. apply decide_means in h. unfold check_aabb_aabb, as_long in h.
  cbv zeta in h. simpl in h. rewrite !if_so_means, !Nat.eqb_eq in h. destruct h as (n & e1 & e2 & e3 & va & vb & h).
  apply two_or_three_means in n. exists (length la). unfold proper_box. rewrite !rl_length. repeat (split; auto).
  { intros k H. rewrite on_each_means in va. specialize (va k H). simpl in va. rewrite !coordinate_means in va. auto. }
  { intros k H. rewrite on_each_means in vb. specialize (vb k H). simpl in vb. rewrite !coordinate_means in vb. auto. }
  clear va vb n.
  destruct w, facts; simpl in h; try tauto; rewrite ?if_so_means, ?Nat.eqb_eq, ?Nat.ltb_lt, ?coordinate_means in h;
    simpl.
  - destruct h as [k sep]. intros x lx [a b]. rewrite <- lx in k. specialize (a axis k); specialize (b axis k).
    destruct sep; lra.
  - destruct h as (k & lx & a & b & sup). apply box_means in a, b; auto. split.
    + exists (rl x). rewrite rl_length; auto.
    + intros y [a' b']. assert (A := interior_box _ _ _ _ _ a' k). assert (B := interior_box _ _ _ _ _ b' k).
      destruct sup; lra.
  - destruct h as (k & lx & a & b & flat). apply box_means in a, b; auto. split.
    + exists (rl x). rewrite rl_length; auto.
    + intros y [a' b']. assert (A := interior_box _ _ _ _ _ a' k). assert (B := interior_box _ _ _ _ _ b' k).
      destruct flat; lra.
  - destruct h as (lx & a & b). exists (rl x). split; apply inside_means; auto.
Qed.

(** ** A ball and a box *)
Lemma nearest : forall c x y, length x = length c -> length y = length c ->
  (forall k, (k < length c)%nat -> (nth k c 0 - nth k x 0) * (nth k c 0 - nth k x 0) <= (nth k c 0 - nth k y 0) *
    (nth k c 0 - nth k y 0)) ->
  sqdist c x <= sqdist c y.
Proof.
  induction c as [|a c IH]; intros [|b x] [|d y]; simpl; intros lx ly H; try discriminate; try lra.
  assert (H0 := H O ltac:(lia)). simpl in H0. apply Rplus_le_compat; auto.
  apply IH; auto. intros k hk. apply (H (S k)); lia.
Qed.
Lemma nearest_means : forall p x l h y, length x = length p -> length y = length p -> box (rl l) (rl h) y ->
  means Q2R (on_each (length p) (fun k => And (Or (Le (coordinate k x) (coordinate k p)) (Eq (coordinate k x)
    (coordinate k l)))
     (Or (Le (coordinate k p) (coordinate k x)) (Eq (coordinate k x) (coordinate k h))))) ->
  sqdist (rl p) (rl x) <= sqdist (rl p) y.
Proof.
  intros p x l h y lx ly B m. apply nearest; rewrite ?rl_length; auto.
  intros k hk. rewrite on_each_means in m. specialize (m k hk). simpl in m. rewrite !coordinate_means in m.
  assert (b : nth k (rl l) 0 <= nth k y 0 <= nth k (rl h) 0) by (apply B; lia).
  set (P := nth k (rl p) 0) in *; set (V := nth k (rl x) 0) in *; set (U := nth k y 0) in *.
  destruct (Rle_lt_dec V P).
  - destruct (Rle_lt_dec P V).
    + replace (P - V) with 0 by lra. assert (g := square (P - U)). lra.
    + destruct m as [_ [m | m]]; [lra|]. apply Rmult_le_compat; lra.
  - destruct m as [[m | m] _]; [lra|].
    replace ((P - V) * (P - V)) with ((V - P) * (V - P)) by ring.
    replace ((P - U) * (P - U)) with ((U - P) * (U - P)) by ring. apply Rmult_le_compat; lra.
Qed.

Theorem sphere_aabb_sound : forall p r l h w facts, decide (check_sphere_aabb p r l h w facts) = true ->
  sphere_aabb_spec (rl p) (Q2R r) (rl l) (rl h) w.
Proof.
  intros p r l h w facts H. apply decide_means in H. unfold check_sphere_aabb, as_long in H.
  cbv zeta in H. simpl in H. rewrite !if_so_means, !Nat.eqb_eq in H. destruct H as (n & e1 & e2 & hr & v & H).
  apply two_or_three_means in n. exists (length p). unfold proper_ball, proper_box. rewrite !rl_length.
  repeat (split; auto).
  { intros k hk. rewrite on_each_means in v. specialize (v k hk). simpl in v. rewrite !coordinate_means in v. auto. }
  assert (pos : (0 < length p)%nat) by (destruct n; lia).
  clear v n.
  destruct w, facts; simpl in H; try tauto; rewrite ?if_so_means, ?Nat.eqb_eq, ?Nat.ltb_lt, ?coordinate_means,
    ?squared_distance_means in H; simpl.
  - destruct H as (lx & a & m & far). intros y ly [b b'].
    assert (g := nearest_means p x l h y lx ly b' m). unfold ball in b. lra.
  - destruct H as (lx & a & m & e). assert (a0 := a). apply box_means in a; auto. split.
    + exists (rl x). rewrite rl_length; unfold ball; repeat split; auto; try apply a; auto. lra.
    + intros y [b b']. assert (ly := proj1 b). apply interior_in in b'.
      assert (g := nearest_means p x l h y lx ly b' m).
      apply interior_ball in b; auto; [lra | rewrite rl_length; auto].
  - destruct H as (k & lx & a & q & flat). apply box_means in a; auto. split.
    + exists (rl x). rewrite rl_length; auto.
    + intros y [_ b]. assert (B := interior_box _ _ _ _ _ b k). lra.
  - destruct H as (lx & a & q). exists (rl x). split; [apply inside_ball; rewrite ?rl_length;
      auto | apply inside_means; auto].
Qed.
