(* SPDX-License-Identifier: Apache-2.0 *)
(** The specifications of discs, half-spaces and slabs leave no choice. *)
Require Import Reals Lra Lia List.
From Certificates Require Import solids sound_solids sound_vectors unique_solids.
Import ListNotations.
Open Scope R_scope.

Theorem location_unique : forall n S x v w, location_spec n S x v -> location_spec n S x w -> v = w.
Proof.
  intros n S x [] [] [_ g] [_ h]; auto; exfalso; simpl in g, h.
  - tauto.
  - apply h, (interior_in n); auto.
  - tauto.
  - tauto.
  - apply g, (interior_in n); auto.
  - tauto.
Qed.

Theorem implicit_circle_unique : forall c r p v w, implicit_circle_spec c r p v -> implicit_circle_spec c r p w ->
  v = w.
Proof. intros c r p v w (_ & g) (_ & h). apply (location_unique _ _ _ _ _ g h). Qed.
Theorem point_in_kdop_unique : forall l p v w, point_in_kdop_spec l p v -> point_in_kdop_spec l p w -> v = w.
Proof. intros l p v w (_ & _ & g) (_ & _ & h). apply (location_unique _ _ _ _ _ g h). Qed.
Theorem sphere_plane_unique : forall c r n d v w, sphere_plane_spec c r n d v -> sphere_plane_spec c r n d w -> v = w.
Proof. intros c r n d v w (_ & _ & _ & g) (_ & _ & _ & h). apply (contact_unique _ _ _ _ _ g h). Qed.
Theorem aabb_plane_unique : forall l k n d v w, aabb_plane_spec l k n d v -> aabb_plane_spec l k n d w -> v = w.
Proof. intros l k n d v w (_ & _ & _ & g) (_ & _ & _ & h). apply (contact_unique _ _ _ _ _ g h). Qed.

Theorem kdop_kdop_unique : forall a b v w, kdop_kdop_spec a b v -> kdop_kdop_spec a b w -> v = w.
Proof.
  intros a b v w (_ & _ & _ & g) (_ & _ & _ & h). cbv zeta in g, h.
  destruct v, w; auto; exfalso.
  - destruct g as (s & t & i & g), h as [h _]. destruct (h s t i) as [u k]. apply (g u); auto.
  - destruct g as (s & t & i & g). destruct (h s t i) as (u & _ & _ & k & _). apply (g u); auto.
  - destruct h as (s & t & i & h), g as [g _]. destruct (g s t i) as [u k]. apply (h u); auto.
  - destruct g as [_ (s & t & i & g)]. destruct (h s t i) as (x & y & l & hx & hy). assert (e := g x y hx hy). lra.
  - destruct h as (s & t & i & h). destruct (g s t i) as (u & _ & _ & k & _). apply (h u); auto.
  - destruct h as [_ (s & t & i & h)]. destruct (g s t i) as (x & y & l & hx & hy). assert (e := h x y hx hy). lra.
Qed.

Fixpoint middle (x y : list R) : list R := match x, y with a :: x', b :: y' => (a + b) / 2 :: middle x' y' | _,
  _ => nil end.
Lemma middle_length : forall x y, length x = length y -> length (middle x y) = length y.
Proof. induction x as [|a x IH]; intros [|b y] l; simpl in *; try discriminate; auto. Qed.
Lemma middle_nth : forall x y k, length x = length y -> nth k (middle x y) 0 = (nth k x 0 + nth k y 0) / 2.
Proof. induction x as [|a x IH]; intros [|b y] [|k] l; simpl in *; try discriminate; auto; try lra. Qed.
Lemma middle_nearer : forall p x y, length x = length p -> length y = length p ->
  4 * sqdist p (middle x y) = 2 * sqdist p x + 2 * sqdist p y - sqdist x y.
Proof.
  induction p as [|c p IH]; intros [|a x] [|b y] lx ly; simpl in *; try discriminate; try lra.
  assert (h := IH x y ltac:(lia) ltac:(lia)).
  replace (4 * ((c - (a + b) / 2) * (c - (a + b) / 2) + sqdist p (middle x y))) with
    (4 * ((c - (a + b) / 2) * (c - (a + b) / 2)) + 4 * sqdist p (middle x y)) by ring.
  rewrite h. field.
Qed.

Theorem closest_point_on_aabb_unique : forall p low high x y,
  closest_point_on_aabb_spec p low high x -> closest_point_on_aabb_spec p low high y -> x = y.
Proof.
  intros p low high x y (n & _ & lp & lx & bx & nx) (m & _ & lp' & ly & by_ & ny).
  assert (e : m = n) by congruence. rewrite e in *.
  assert (lm : length (middle x y) = n) by (rewrite middle_length; congruence).
  assert (b : box low high (middle x y)).
  { intros k hk. rewrite middle_nth by congruence. specialize (bx k ltac:(lia)). specialize (by_ k ltac:(lia)). lra. }
  assert (hx := nx (middle x y) lm b). assert (hy := ny (middle x y) lm b).
  assert (q := middle_nearer p x y ltac:(congruence) ltac:(congruence)).
  apply sqdist_zero; [congruence | lra].
Qed.
