(* SPDX-License-Identifier: Apache-2.0 *)
(* extreme_filter.h on all of binary64, of any number of points. Least and greatest start from the infinities, as
   kdop_of_points.cpp has it. *)
From Coq Require Import Reals ZArith Lra Lia Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model constants filters steps tactics format floats float_steps float_guards.
From Filters Require Import float_run maxima kdop.
Import ListNotations.
Open Scope R_scope.

Definition real_point (p : point float) : point R := {| x := value (x p); y := value (y p); z := value (z p) |}.
Definition finite_point (p : point float) := finite (x p) /\ finite (y p) /\ finite (z p).
Definition near (p : point float) := mag (x p) 345 /\ mag (y p) 345 /\ mag (z p) 345.
Notation extents := (extents binary64).
Ltac up_to := match goal with B : mag ?x ?i |- mag ?x ?k => exact (mag_up x i k B ltac:(discriminate)) end.

Lemma extents_up ps g : extents floats ps g -> up g.
Proof.
induction 1 as [g [F E]|p ps g g' R IH S]; [apply up_finite; [exact F|]; rewrite E; apply Rle_refl|].
unfold kdop_greater_extent in S. unpack. subst. float_constants. rising.
match goal with C : choose floats ?b _ _ _ |- _ => destruct b; apply (reads_up _ _ C); assumption end.
Qed.
Lemma extents_real ps g : extents floats ps g -> Forall finite_point ps -> mag g 342 ->
  extents M (map real_point ps) (value g) /\ Forall near ps.
Proof.
induction 1 as [g [F E]|p ps g g' R IH S]; intros A G; [split; [now apply no_extent|apply Forall_nil]|].
apply Forall_cons_iff in A as [(X & Y & Z) A']. pose proof (extents_up _ _ R) as U.
unfold kdop_greater_extent in S. unpack. subst. float_constants. rising.
lazymatch goal with S : add floats _ _ ?t, S' : add floats (Plain ?t) _ ?s, C : greater floats ?s g ?b,
  K : choose floats ?b ?s g _ |- _ =>
  assert (N : is_nan s = false) by (apply (sum_number _ _ _ S'); try apply up_abs; try assumption;
    [apply (sum_number _ _ _ S); try apply up_abs|]; now apply number_abs);
  destruct (greater_mag _ _ _ _ _ C K G ltac:(lia)) as [GS GG]; try assumption end.
destruct (IH A' GG) as [I J]. back. split.
- apply one_extent with (1 := I). unfold kdop_greater_extent. cbn [kdop.x y z real_point]. repeat advance. reflexivity.
- apply Forall_cons; [|exact J]. split; [|split]; up_to.
Qed.

Section Extremes.
Variables nx ny nz : float.
Notation height := (height binary64 floats nx ny nz).
Inductive extremes : list (point float) -> float -> float -> Prop :=
| no_extreme : extremes [] (B754_infinity false) (B754_infinity true)
| one_extreme p ps v low high low' high' : extremes ps low high -> height p v ->
    kdop_lower binary64 float floats v low low' -> kdop_higher binary64 float floats v high high' ->
    extremes (p :: ps) low' high'.
(* p is no candidate *)
Definition passed_over ps p := exists of_points low high apart value, extents floats ps of_points /\
  extremes ps low high /\ kdop_doubt binary64 float floats nx ny nz of_points (Some apart) /\ height p value /\
  kdop_between binary64 float floats value low high apart true.

Hypothesis NX : mag nx 345.
Hypothesis NY : mag ny 345.
Hypothesis NZ : mag nz 345.
Lemma height_real p v : near p -> height p v -> mag v 692 /\
  kdop.height binary64 M (value nx) (value ny) (value nz) (real_point p) (value v).
Proof.
intros (X & Y & Z) R. unfold kdop.height, kdop_height in R. unpack. subst.
repeat match reverse goal with S : _ floats _ _ ?t |- _ =>
  lazymatch goal with _ : mag t _ |- _ => fail | _ => forward S end end.
split; [up_to|]. unfold kdop.height, kdop_height. cbn [kdop.x y z real_point]. repeat advance. reflexivity.
Qed.
(* the first number is kept, for it is finite *)
Lemma first_kept v b : finite v ->
  greater floats (B754_infinity false) v b \/ greater floats v (B754_infinity true) b -> b = true.
Proof.
intros F [(w & v' & [->|[W _]] & V & ->)|(v' & w & V & [->|[W _]] & ->)]; try discriminate;
  pose proof (finite_reads _ _ V F) as F'; destruct v' as [[]|[]| |[]]; easy.
Qed.
Lemma extremes_real ps low high : extremes ps low high -> Forall near ps -> ps <> [] -> mag low 692 /\ mag high 692 /\
  kdop.extremes binary64 M (value nx) (value ny) (value nz) (map real_point ps) (value low) (value high).
Proof.
induction 1 as [|p ps v low high low' high' R IH H L K]; intros N E; [easy|]. clear E.
apply Forall_cons_iff in N as [NP N]. destruct (height_real _ _ NP H) as [V HV]. unfold kdop_lower, kdop_higher in L, K.
destruct L as (b & L & l & CL & ->), K as (c & K & h & CH & ->). destruct ps as [|p' ps].
- inversion R; subst. assert (b = true) as -> by (apply (first_kept v); [apply V|now left]).
  assert (c = true) as -> by (apply (first_kept v); [apply V|now right]).
  split; [exact (reads_mag _ _ _ CL V)|]. split; [exact (reads_mag _ _ _ CH V)|].
  apply first_extreme with (1 := HV); [exact (choose_real true v v _ CL)|exact (choose_real true v v _ CH)].
- destruct (IH N ltac:(discriminate)) as (ML & MH & X). split; [exact (choose_mag _ _ _ _ _ _ _ CL V ML eq_refl)|].
  split; [exact (choose_mag _ _ _ _ _ _ _ CH V MH eq_refl)|]. apply more_extremes with (1 := X) (2 := HV).
  + exists b. split; [exact (greater_real _ _ _ L (proj1 ML) (proj1 V))|]. exists (value l).
    split; [exact (choose_real _ _ _ _ CL)|reflexivity].
  + exists c. split; [exact (greater_real _ _ _ K (proj1 V) (proj1 MH))|]. exists (value h).
    split; [exact (choose_real _ _ _ _ CH)|reflexivity].
Qed.
End Extremes.

Lemma doubt_real nx ny nz g apart : up g -> kdop_doubt binary64 float floats nx ny nz g (Some apart) ->
  (mag nx 345 /\ mag ny 345 /\ mag nz 345 /\ mag g 342 /\ mag apart 800) /\
  kdop_doubt binary64 R M (value nx) (value ny) (value nz) (value g) (Some (value apart)).
Proof.
intros U R. unfold kdop_doubt in R. unpack.
match type of R with _ = (if negb ?c then _ else _) => destruct c eqn:C; cbn [negb] in R; [|discriminate] end.
injection R as <-. subst. float_constants. rising. guards. back.
lazymatch goal with C : constant floats 4 ?c |- _ => assert (mag c 2) by (split; [apply C|]; rewrite (proj2 C);
  rewrite Rabs_right by lra; apply Rle_refl) end.
split.
- repeat match reverse goal with S : _ floats _ _ ?t |- _ =>
    lazymatch goal with _ : mag t _ |- _ => fail | _ => forward S end end.
  split; [up_to|]. split; [up_to|]. split; [up_to|]. split; up_to.
- unfold kdop_doubt. repeat advance. reflexivity.
Qed.

(* Of finite points: one that is passed over has neither the least nor the greatest N . P. *)
Theorem kdop_binary64 nx ny nz ps p : Forall finite_point ps -> passed_over nx ny nz ps p -> In p ps ->
  let height p := value nx * value (x p) + value ny * value (y p) + value nz * value (z p) in
  Forall finite [nx; ny; nz] /\ exists a b, In a ps /\ In b ps /\ height a < height p < height b.
Proof.
intros A (g & low & high & apart & v & E & X & D & V & B) I height.
destruct (doubt_real _ _ _ _ _ (extents_up _ _ E) D) as [(NX & NY & NZ & G & MA) D'].
destruct (extents_real _ _ E A G) as [E' N].
destruct (extremes_real _ _ _ NX NY NZ _ _ _ X N) as (ML & MH & X'); [now intros ->|].
assert (NP : near p) by (rewrite Forall_forall in N; auto).
destruct (height_real _ _ _ NX NY NZ _ _ NP V) as [MV V'].
split; [all_finite|].
assert (P : kdop.passed_over binary64 M (value nx) (value ny) (value nz) (map real_point ps) (real_point p)).
{ exists (value g), (value low), (value high), (value apart), (value v). repeat (split; [assumption|]).
  unfold kdop_between in B. unpack. unfold kdop_between. repeat advance. assumption. }
destruct (kdop_right _ _ _ _ _ _ fits_third P (in_map _ _ _ I)) as (a & b & IA & IB & L).
apply in_map_iff in IA as (a' & <- & IA), IB as (b' & <- & IB). exists a', b'. auto.
Qed.
