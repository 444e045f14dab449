(* SPDX-License-Identifier: Apache-2.0 *)
(* plane on all of binary64. Nothing guards the offset: overflow.v. *)
From Coq Require Import Reals ZArith Lra Lia Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model constants filters steps tactics format floats float_steps float_guards float_run.
From Filters Require Import overflow plane.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.

Theorem plane_binary64 (nx ny nz offset px py pz : float) answer :
  plane binary64 float floats nx ny nz offset px py pz answer ->
  correct answer [nx; ny; nz; offset; px; py; pz] (nx * px + ny * py + nz * pz + offset).
Proof.
intros R. unfold plane in R. float_guards R.
lazymatch goal with
| V : add floats _ (Plain offset) ?v, T : add floats ?p (Plain (Babs offset)) ?terms, C : mul floats _ ?terms ?t,
  A : add floats (Product _ ?terms ?t) _ ?bound, K : greater floats (Babs ?v) ?bound true, U : up ?bound |- _ =>
  pose proof (bound_terms _ _ _ _ _ C A (bound_finite _ _ K U)) as F; pose proof (finite_mag _ F) as B';
  pose proof (right_finite _ _ _ T F) as F'; rewrite finite_abs in F'; pose proof (finite_mag _ F') as B'' end.
split; [intros _; all_finite|].
apply plane_right with binary64; [fits|]. unfold plane. repeat advance.
lazymatch goal with V : add floats (Plain ?r) (Plain offset) ?v |- _ => lazymatch goal with B : mag r ?k |- _ =>
  destruct (add_stands _ _ _ k V (conj B I) eq_refl F') as (v0 & V0 & D); exists v0; split; [exact V0|clear V] end end.
repeat advance.
lazymatch goal with T : add floats (Product ?a ?b ?t) (Plain (Babs offset)) ?terms |- _ => exists (value terms);
  split; [as_real; let W := within_of (Product a b t) in exact (terms_real _ _ _ _ T F W eq_refl)|clear T] end.
repeat advance.
lazymatch goal with K : greater floats (Babs ?v) ?b true, B : mag ?b ?k |- _ => exists true;
  split; [exact (stands_greater _ _ _ _ _ _ K (stands_abs _ _ _ D) B ltac:(reflexivity))|clear K] end.
repeat advance.
lazymatch goal with K : greater floats ?v ?b ?s, B : mag ?b ?k |- _ => exists s;
  split; [exact (stands_greater _ _ _ _ _ _ K D B ltac:(reflexivity))|exact R] end.
Qed.
