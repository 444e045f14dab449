(* SPDX-License-Identifier: Apache-2.0 *)
(* runs.v for filters of any number of slabs and points. *)
From Coq Require Import Reals ZArith Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model constants filters format floats runs.
From Filters Require Import kdop kdop_binary64 slab.

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

(* Of any points there are an extent, extremes and a doubt, of each a height; and it is passed over or not. *)
Theorem kdop_runs (m : mode) nx ny nz ps : exists g low high doubt, kdop.extents binary64 floats ps g /\
  extremes nx ny nz ps low high /\ kdop_doubt binary64 float floats nx ny nz g doubt /\
  forall p, exists v, kdop.height binary64 floats nx ny nz p v /\
  forall apart, exists b, kdop_between binary64 float floats v low high apart b.
Proof.
assert (E : exists g, kdop.extents binary64 floats ps g).
{ induction ps as [|p ps [g E]].
  - assert (Z : exists g, constant floats 0 g) by some_constant. destruct Z as [g Z]. exists g. now apply no_extent.
  - assert (S : exists g', kdop_greater_extent binary64 float floats (x p) (y p) (z p) g g')
      by runs kdop_greater_extent m.
    destruct S as [g' S]. exists g'. now apply one_extent with g. }
assert (H : forall p, exists v, kdop.height binary64 floats nx ny nz p v)
  by (intros p; unfold kdop.height; runs kdop_height m).
assert (X : exists low high, extremes nx ny nz ps low high).
{ clear E. induction ps as [|p ps (low & high & X)]; [do 2 eexists; apply no_extreme|]. destruct (H p) as [v V].
  assert (L : exists low', kdop_lower binary64 float floats v low low') by runs kdop_lower m.
  assert (K : exists high', kdop_higher binary64 float floats v high high') by runs kdop_higher m.
  destruct L as [low' L], K as [high' K]. exists low', high'. now apply one_extreme with v low high. }
destruct E as [g E], X as (low & high & X).
assert (D : exists doubt, kdop_doubt binary64 float floats nx ny nz g doubt) by runs kdop_doubt m.
destruct D as [doubt D]. exists g, low, high, doubt. split; [exact E|]. split; [exact X|]. split; [exact D|].
intros p. destruct (H p) as [v V]. exists v. split; [exact V|]. intros apart. runs kdop_between m.
Qed.
