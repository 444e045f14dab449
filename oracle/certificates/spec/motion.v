(* SPDX-License-Identifier: Apache-2.0 *)
(** What the answers claim of shapes that move along straight lines: when they first have a common point. *)
Require Import Reals List.
From Certificates Require Import solids.
Open Scope R_scope.

(** [swept_sphere_sphere]: two balls that move, c + t v with radius r and d + t w with radius s, for 0 <= t <= 1; the
    first time, p + q sqrt(k), at which they have a common point *)
Inductive surd (A : Type) := Surd (p q k : A).
Arguments Surd {A}.
Definition surd_value (t : surd R) : R := let '(Surd p q k) := t in p + q * sqrt k.
Fixpoint moved (c v : list R) (t : R) : list R :=
  match c, v with a :: c', b :: v' => a + t * b :: moved c' v' t | _, _ => nil end.
Definition meet (c : list R) (r : R) (v d : list R) (s : R) (w : list R) (t : R) : Prop :=
  exists x, length x = 3%nat /\ ball (moved c v t) r x /\ ball (moved d w t) s x.
Inductive swept (A : Type) := first_at (t : surd A) | never.
Arguments first_at {A}. Arguments never {A}.
Definition swept_sphere_sphere_spec c r v d s w (answer : swept R) : Prop :=
  length c = 3%nat /\ length v = 3%nat /\ length d = 3%nat /\ length w = 3%nat /\ 0 <= r /\ 0 <= s /\
  match answer with
  | first_at t => let t := surd_value t in
      0 <= t <= 1 /\ meet c r v d s w t /\ forall u, 0 <= u < t -> ~ meet c r v d s w u
  | never => forall u, 0 <= u <= 1 -> ~ meet c r v d s w u
  end.
