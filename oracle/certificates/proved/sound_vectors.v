(* SPDX-License-Identifier: Apache-2.0 *)
(** Real geometry of half-spaces: scalar products, and interiors. *)
Require Import Reals Lra Lia List Arith.
From Certificates Require Import solids formulas_vectors sound_solids.
Import ListNotations.
Open Scope R_scope.

Lemma dot_sym : forall x y, dot x y = dot y x.
Proof. induction x as [|a x IH]; destruct y as [|b y]; simpl; auto. rewrite IH; ring. Qed.
Lemma dot_plus : forall n x y, length x = length y -> dot n (plus x y) = dot n x + dot n y.
Proof.
  induction n as [|c n IH]; intros [|a x] [|b y] l; simpl in *; try discriminate; try ring.
  rewrite IH; [ring | lia].
Qed.
Lemma dot_minus : forall n x y, length x = length y -> dot n (minus x y) = dot n x - dot n y.
Proof.
  induction n as [|c n IH]; intros [|a x] [|b y] l; simpl in *; try discriminate; try ring.
  rewrite IH; [ring | lia].
Qed.
Lemma dot_times : forall n t x, dot n (times t x) = t * dot n x.
Proof. unfold times; induction n as [|c n IH]; intros t [|a x]; simpl; try ring. rewrite IH; ring. Qed.
Lemma times_dot : forall t x n, dot (times t x) n = t * dot x n.
Proof. intros; rewrite dot_sym, dot_times, dot_sym; auto. Qed.
Lemma minus_dot : forall x y n, length x = length y -> dot (minus x y) n = dot x n - dot y n.
Proof. intros; rewrite dot_sym, dot_minus, !(dot_sym n); auto. Qed.
Lemma square_of_difference : forall x y, length x = length y ->
  dot (minus x y) (minus x y) = dot x x - 2 * dot x y + dot y y.
Proof. intros; rewrite dot_minus, !minus_dot, (dot_sym y x); auto; ring. Qed.
Lemma plus_length : forall x y, length x = length y -> length (plus x y) = length y.
Proof. induction x as [|a x IH]; intros [|b y] l; simpl in *; try discriminate; auto. Qed.
Lemma minus_length : forall x y, length x = length y -> length (minus x y) = length y.
Proof. induction x as [|a x IH]; intros [|b y] l; simpl in *; try discriminate; auto. Qed.
Lemma times_length : forall t x, length (times t x) = length x.
Proof. intros; apply map_length. Qed.
Lemma dot_self : forall x, 0 <= dot x x.
Proof. induction x as [|a x IH]; simpl; [lra|]. assert (g := square a). lra. Qed.
Lemma dot_nonzero : forall x, nonzero x -> 0 < dot x x.
Proof.
  induction x as [|a x IH]; intros [b [i n]]; simpl in *; [tauto|].
  assert (g := square a). assert (k := dot_self x). destruct i as [-> | i].
  - assert (b * b <> 0) by (intro z; apply n; destruct (Rmult_integral _ _ z); auto). lra.
  - assert (0 < dot x x) by (apply IH; exists b; auto). lra.
Qed.
Lemma zero_vector : forall x, dot x x = 0 -> ~ nonzero x.
Proof. intros x z h. apply dot_nonzero in h. lra. Qed.
Lemma sqdist_dot : forall x y, length x = length y -> sqdist x y = dot (minus x y) (minus x y).
Proof. induction x as [|a x IH]; intros [|b y] l; simpl in *; try discriminate; auto. rewrite IH; auto. Qed.

(** The inequality of Cauchy and Schwarz *)
Lemma cauchy : forall x y, length x = length y -> dot x y * dot x y <= dot x x * dot y y.
Proof.
  intros x y l.
  assert (h : forall t, 0 <= dot x x - 2 * t * dot x y + t * t * dot y y).
  { intro t. assert (g := dot_self (minus x (times t y))).
    assert (l' : length x = length (times t y)) by (rewrite times_length; auto).
    rewrite dot_minus, dot_times, (dot_sym _ x), (dot_sym _ y), !dot_minus, !dot_times, (dot_sym y x) in g; auto. lra. }
  destruct (Req_dec (dot y y) 0) as [z | z].
  - rewrite z in *. assert (e : dot x y = 0).
    { destruct (Req_dec (dot x y) 0) as [|n]; auto. exfalso.
      assert (k := h ((dot x x + 1) / (2 * dot x y))).
      replace (2 * ((dot x x + 1) / (2 * dot x y)) * dot x y) with (dot x x + 1) in k by (field; auto). lra. }
    rewrite e; lra.
  - assert (p := dot_self y). assert (0 < dot y y) by lra.
    assert (k := h (dot x y / dot y y)).
    replace (dot x x - 2 * (dot x y / dot y y) * dot x y + dot x y / dot y y * (dot x y / dot y y) * dot y y)
      with ((dot x x * dot y y - dot x y * dot x y) / dot y y) in k by (field; lra).
    apply (Rmult_le_compat_r (dot y y)) in k; [|lra].
    unfold Rdiv in k. rewrite Rmult_assoc, Rinv_l in k; lra.
Qed.

(** ** Interiors *)
Lemma interior_subset : forall n (S T : list R -> Prop) x, (forall y,
  length y = n -> S y -> T y) -> interior n S x -> interior n T x.
Proof. intros n S T x h [l [e [he g]]]; split; auto. exists e; split; auto. Qed.
Lemma interior_both : forall n (S T : list R -> Prop) x, interior n S x -> interior n T x ->
  interior n (fun y => S y /\ T y) x.
Proof.
  intros n S T x [l [d [hd g]]] [_ [e [he h]]]; split; auto. exists (Rmin d e).
  split; [apply Rmin_glb_lt; auto|]. intros y ly k.
  assert (0 < Rmin d e) by (apply Rmin_glb_lt; auto). assert (a := Rmin_l d e). assert (b := Rmin_r d e).
  split; [apply g | apply h]; auto; eapply Rlt_le_trans; try exact k; apply Rmult_le_compat; lra.
Qed.
Lemma interior_each : forall {B} n (P : B -> list R -> Prop) l x, length x = n ->
  (forall s, In s l -> interior n (P s) x) -> interior n (fun y => forall s, In s l -> P s y) x.
Proof.
  intros B n P l x lx. induction l as [|s l IH]; intro h.
  - split; auto. exists 1; split; [lra|]. simpl; tauto.
  - apply (interior_subset n (fun y => P s y /\ forall t, In t l -> P t y)).
    + intros y _ [a b] t [<- | i]; auto.
    + apply interior_both; [apply h; left; auto | apply IH; intros; apply h; right; auto].
Qed.

Lemma interior_half_space : forall n normal offset x, length normal = n -> length x = n ->
  dot normal x + offset < 0 -> interior n (half_space normal offset) x.
Proof.
  intros n N d x lN lx h. split; auto.
  set (H := - (dot N x + d)). set (Q := dot N N + 1). assert (q := dot_self N).
  assert (0 < H) by (unfold H; lra). assert (0 < Q) by (unfold Q; lra).
  exists (H / Q). split; [apply Rdiv_lt_0_compat; auto|]. intros y ly k. unfold half_space.
  apply Rnot_lt_le; intro g.
  assert (c := cauchy N (minus y x)). rewrite minus_length in c by congruence. specialize (c ltac:(congruence)).
  rewrite dot_minus in c by congruence. rewrite <- sqdist_dot in c by congruence. rewrite (sqdist_sym y x) in c.
  assert (s := sqdist_nonneg x y).
  assert (e : H * H < (dot N y - dot N x) * (dot N y - dot N x)) by (apply Rmult_le_0_lt_compat; unfold H in *; lra).
  assert (f : dot N N * sqdist x y <= Q * (H / Q * (H / Q))).
  { apply Rle_trans with (Q * sqdist x y); [apply Rmult_le_compat_r; unfold Q; lra | apply Rmult_le_compat_l; lra]. }
  replace (Q * (H / Q * (H / Q))) with (H * H / Q) in f by (field; lra).
  assert (H * H / Q <= H * H).
  { apply (Rmult_le_reg_r Q); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
    rewrite <- (Rmult_1_r (H * H)) at 1. apply Rmult_le_compat_l; [apply square | unfold Q; lra]. }
  lra.
Qed.
Lemma half_space_interior : forall n normal offset x, length normal = n -> nonzero normal ->
  interior n (half_space normal offset) x -> dot normal x + offset < 0.
Proof.
  intros n N d x lN nz [lx [e [he h]]]. apply dot_nonzero in nz. apply Rnot_le_lt; intro k.
  set (t := e / (dot N N + 1)). assert (0 < t) by (apply Rdiv_lt_0_compat; lra).
  assert (te : t * (dot N N + 1) = e) by (unfold t; field; lra). clearbody t.
  assert (m : half_space N d (plus x (times t N))).
  { assert (l : length x = length (times t N)) by (rewrite times_length; congruence).
    apply h; [rewrite plus_length, times_length; auto|].
    assert (sq : sqdist x (plus x (times t N)) = t * t * dot N N).
    { clear - l. unfold times in *. rewrite map_length in l. revert N l.
      induction x as [|a x IH]; intros [|b N] l; simpl in *; try discriminate; try ring. rewrite IH by lia. ring. }
    rewrite sq.
    assert (0 < t * t) by (apply Rmult_lt_0_compat; auto).
    rewrite <- te. replace (t * (dot N N + 1) * (t * (dot N N + 1))) with (t * t * ((dot N N + 1) * (dot N N + 1)))
      by ring.
    apply Rmult_lt_compat_l; auto. assert (g := square (dot N N)). lra. }
  unfold half_space in m. rewrite dot_plus, dot_times in m by (rewrite times_length; congruence).
  assert (0 < t * dot N N) by (apply Rmult_lt_0_compat; auto). lra.
Qed.

(** A point of a set at which the way to the center makes no acute angle with the way to any other is the nearest. *)
Lemma nearest_by_angle : forall c x y, length c = length x -> length y = length x ->
  dot (minus c x) (minus y x) <= 0 -> sqdist c x <= sqdist c y.
Proof.
  intros c x y lc ly h.
  assert (e : sqdist c y = sqdist c x + sqdist x y - 2 * dot (minus c x) (minus y x)).
  { clear h. revert c y lc ly. induction x as [|a x IH]; intros [|b c] [|d y] lc ly; simpl in *; try discriminate;
      try ring.
    rewrite (IH c y); [ring | lia | lia]. }
  assert (g := sqdist_nonneg x y). lra.
Qed.
