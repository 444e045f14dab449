(* SPDX-License-Identifier: Apache-2.0 *)
(* runs.v for filters of any number of slabs and points. *)
From Coq Require Import Reals ZArith Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model constants filters format floats runs.
From Filters Require Import slab.

Section Slabs.
Variables (m : mode) (px py pz : float).
Lemma first_runs s : exists t, first binary64 floats px py pz s t.
Proof. unfold first, slab_first. in_mode m. eexists (Build_state _ _ _ _ _ _). cbn. repeat split. Qed.
Lemma added_runs t s : exists t', added binary64 floats px py pz t s t'.
Proof. unfold added, slab_add. in_mode m. eexists (Build_state _ _ _ _ _ _). cbn. repeat split. Qed.
Lemma folded_runs ss : forall s, exists t, folded binary64 floats px py pz (s :: ss) t.
Proof.
induction ss as [|s' ss IH]; intros s.
- destruct (first_runs s) as [t R]. exists t. now apply one.
- destruct (IH s') as [t R]. destruct (added_runs t s) as [t' A]. exists t'. now apply more with t.
Qed.
(* of one slab and any number of others *)
Theorem slab_runs s ss : exists answer, depths binary64 floats px py pz (s :: ss) answer.
Proof.
destruct (folded_runs ss s) as [t R].
assert (E : exists answer, slab_sign binary64 float floats px py pz (depth_ t) (width_ t) (least_ t) (greatest_ t)
  (sum_ t) answer) by runs slab_sign m.
destruct E as [answer S]. exists answer, t. now split.
Qed.
End Slabs.
