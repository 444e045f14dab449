(* SPDX-License-Identifier: Apache-2.0 *)
(** The language of conditions: sums, differences, products and maxima of numbers; comparisons of those; and, or, not.
    [decide] computes a condition on rational numbers, [means] says what it is about in the real numbers, and
    [decide_means] proves once, for all conditions, that the two agree. *)
Require Import Reals Qreals QArith ZArith Lra Bool List.
Open Scope R_scope.

Section language.
Context {A : Type}.
Inductive term := Leaf (a : A) | Num (z : Z) | Add (s t : term) | Sub (s t : term) | Mul (s t : term)
               | Max (s t : term).
Inductive cond := Le (s t : term) | Lt (s t : term) | Eq (s t : term) | Yes | No
                | And (c d : cond) | Or (c d : cond) | Not (c : cond).
Context (f : A -> R).
Fixpoint value (t : term) : R :=
  match t with
  | Leaf a => f a | Num z => IZR z
  | Add s t => value s + value t | Sub s t => value s - value t | Mul s t => value s * value t
  | Max s t => Rmax (value s) (value t)
  end.
Fixpoint means (c : cond) : Prop :=
  match c with
  | Le s t => value s <= value t | Lt s t => value s < value t | Eq s t => value s = value t
  | Yes => True | No => False
  | And c d => means c /\ means d | Or c d => means c \/ means d | Not c => ~ means c
  end.
End language.
Arguments term : clear implicits. Arguments cond : clear implicits.

Fixpoint compute (t : term Q) : Q :=
  match t with
  | Leaf a => a | Num z => inject_Z z
  | Add s t => Qplus (compute s) (compute t) | Sub s t => Qminus (compute s) (compute t)
  | Mul s t => Qmult (compute s) (compute t)
  | Max s t => let a := compute s in let b := compute t in if Qle_bool a b then b else a
  end.
Fixpoint decide (c : cond Q) : bool :=
  match c with
  | Le s t => Qle_bool (compute s) (compute t) | Lt s t => negb (Qle_bool (compute t) (compute s))
  | Eq s t => Qeq_bool (compute s) (compute t)
  | Yes => true | No => false
  | And c d => if decide c then decide d else false | Or c d => if decide c then true else decide d
  | Not c => negb (decide c)
  end.

Lemma compute_value : forall t, Q2R (compute t) = value Q2R t.
Proof.
  induction t; simpl; rewrite ?Q2R_plus, ?Q2R_minus, ?Q2R_mult, ?IHt1, ?IHt2; auto.
  - unfold Q2R, inject_Z; simpl; field.
  - rewrite <- IHt1, <- IHt2. destruct (Qle_bool (compute t1) (compute t2)) eqn:e.
    + apply Qle_bool_iff, Qle_Rle in e. rewrite Rmax_right; auto.
    + rewrite Rmax_left; auto. left. apply Rnot_le_lt; intro h. apply Rle_Qle, Qle_bool_iff in h. congruence.
Qed.

Theorem decide_means : forall c, decide c = true <-> means Q2R c.
Proof.
  induction c; simpl; rewrite <- ?compute_value.
  - rewrite Qle_bool_iff; split; [apply Qle_Rle | apply Rle_Qle].
  - rewrite negb_true_iff, <- not_true_iff_false, Qle_bool_iff. split; intro h.
    + apply Rnot_le_lt; intro g; apply h, Rle_Qle, g.
    + intro g; apply Qle_Rle in g; lra.
  - rewrite Qeq_bool_iff; split; [apply Qeq_eqR | apply eqR_Qeq].
  - tauto.
  - split; [discriminate | tauto].
  - rewrite <- IHc1, <- IHc2; destruct (decide c1), (decide c2); intuition discriminate.
  - rewrite <- IHc1, <- IHc2; destruct (decide c1), (decide c2); intuition discriminate.
  - rewrite <- IHc; destruct (decide c); intuition discriminate.
Qed.

(** Conditions are written as usual within [%check]. *)
Declare Scope check_scope.
Delimit Scope check_scope with check.
Infix "+" := Add : check_scope. Infix "-" := Sub : check_scope. Infix "*" := Mul : check_scope.
Infix "<=" := Le : check_scope. Infix "<" := Lt : check_scope. Infix "=" := Eq : check_scope.
Infix "/\" := And : check_scope. Infix "\/" := Or : check_scope. Notation "~ c" := (Not c) : check_scope.
Notation zero := (Num 0). Notation one := (Num 1).
Definition if_so {A} (b : bool) : cond A := if b then Yes else No.
Lemma if_so_means : forall {A} (f : A -> R) b, means f (if_so b) <-> b = true.
Proof. destruct b; simpl; intuition discriminate. Qed.
