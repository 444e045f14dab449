(* SPDX-License-Identifier: Apache-2.0 *)
(** The specifications of motion leave no choice: of one input no two different answers are true.
  So an accepted answer is
    not only a true one, it is the one. *)
Require Import Reals Lra Lia List.
From Certificates Require Import solids motion.
Open Scope R_scope.

(** Two ways to write the time are the same number. *)
Theorem swept_sphere_sphere_unique : forall c r v d s w x y,
  swept_sphere_sphere_spec c r v d s w x -> swept_sphere_sphere_spec c r v d s w y ->
  match x, y with first_at t, first_at u => surd_value t = surd_value u | never, never => True | _, _ => False end.
Proof.
  intros c r v d s w x y (_ & _ & _ & _ & _ & _ & g) (_ & _ & _ & _ & _ & _ & h).
  destruct x as [t |], y as [u |]; auto.
  - destruct g as (g1 & g2 & g3), h as (h1 & h2 & h3).
    destruct (Rtotal_order (surd_value t) (surd_value u)) as [l | [e | l]]; auto; exfalso.
    + apply (h3 (surd_value t)); auto; lra.
    + apply (g3 (surd_value u)); auto; lra.
  - destruct g as (g1 & g2 & _). apply (h (surd_value t)); auto.
  - destruct h as (h1 & h2 & _). apply (g (surd_value u)); auto.
Qed.
