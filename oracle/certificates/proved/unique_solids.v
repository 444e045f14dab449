(* SPDX-License-Identifier: Apache-2.0 *)
(** The specifications of solids leave no choice: of one input no two different answers are true.
  So an accepted answer is
    not only a true one, it is the one. *)
Require Import Reals Lra Lia List.
From Certificates Require Import solids sound_solids.
Open Scope R_scope.

Theorem contact_unique : forall n S T v w, contact_spec n S T v -> contact_spec n S T w -> v = w.
Proof.
  assert (inside : forall n S T, (exists x, interior n S x /\ interior n T x) -> exists x, length x = n /\ S x /\ T x).
  { intros n S T [x [a b]]. exists x. split; [apply a | split; apply (interior_in n); auto]. }
  intros n S T [] [] g h; auto; simpl in g, h; exfalso.
  - destruct h as [[x [l m]] _]. apply (g x); auto.
  - apply inside in h. destruct h as [x [l m]]. apply (g x); auto.
  - destruct g as [[x [l m]] _]. apply (h x); auto.
  - destruct g as [_ g], h as [x m]. apply (g x); auto.
  - apply inside in g. destruct g as [x [l m]]. apply (h x); auto.
  - destruct h as [_ h], g as [x m]. apply (h x); auto.
Qed.

Theorem sphere_sphere_unique : forall c r d s v w,
  sphere_sphere_spec c r d s v -> sphere_sphere_spec c r d s w -> v = w.
Proof.
  intros c r d s v w (n & (_ & l & _) & _ & g) (m & (_ & k & _) & _ & h). rewrite l in k; subst m.
  apply (contact_unique n (ball c r) (ball d s)); auto.
Qed.
Theorem aabb_aabb_unique : forall la ha lb hb v w,
  aabb_aabb_spec la ha lb hb v -> aabb_aabb_spec la ha lb hb w -> v = w.
Proof.
  intros la ha lb hb v w (n & (_ & l & _) & _ & g) (m & (_ & k & _) & _ & h). rewrite l in k; subst m.
  apply (contact_unique n (box la ha) (box lb hb)); auto.
Qed.
Theorem sphere_aabb_unique : forall c r l h v w,
  sphere_aabb_spec c r l h v -> sphere_aabb_spec c r l h w -> v = w.
Proof.
  intros c r l h v w (n & (_ & e & _) & _ & g) (m & (_ & k & _) & _ & i). rewrite e in k; subst m.
  apply (contact_unique n (ball c r) (box l h)); auto.
Qed.
