(* SPDX-License-Identifier: Apache-2.0 *)
(* extreme_filter.h, of any number of points. filters.v says what its functions compute; how robust/volumes/
   kdop_of_points.cpp calls them for one normal is said here. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool List.
From Filters Require Import model constants filters steps ghost tactics choices.
Import ListNotations.
Open Scope R_scope.

Record point T := { x : T; y : T; z : T }.
Arguments x {T}. Arguments y {T}. Arguments z {T}.

Section Run.
Variable F : format.
Context {T : Type}.
Variables (M : machine T) (nx ny nz : T).
(* greatest_extent. The point that was looked at last comes first. *)
Inductive extents : list (point T) -> T -> Prop :=
| no_extent g : constant M 0 g -> extents [] g
| one_extent p ps g g' : extents ps g -> kdop_greater_extent F T M (x p) (y p) (z p) g g' -> extents (p :: ps) g'.
Definition height p v := kdop_height F T M nx ny nz (x p) (y p) (z p) v.
(* The least and the greatest. They start from infinities: the first number is kept, for it is finite. *)
Inductive extremes : list (point T) -> T -> T -> Prop :=
| first_extreme p v low high : height p v -> choose M true v v low -> choose M true v v high -> extremes [p] low high
| more_extremes p ps v low high low' high' : extremes ps low high -> height p v ->
    kdop_lower F T M v low low' -> kdop_higher F T M v high high' -> extremes (p :: ps) low' high'.
(* p is no candidate. Where doubt is infinite (None), every point is. *)
Definition passed_over ps p := exists of_points low high apart value, extents ps of_points /\ extremes ps low high /\
  kdop_doubt F T M nx ny nz of_points (Some apart) /\ height p value /\ kdop_between F T M value low high apart true.
(* the sum of a point's magnitudes *)
Definition extent p size := exists t, add M (Plain (magnitude M (x p))) (Plain (magnitude M (y p))) t /\
  add M (Plain t) (Plain (magnitude M (z p))) size.
End Run.

Section Kdop.
Variable F : format.
Hypothesis G : fits F (third F) 1 1.
Variables nx ny nz : R.
Notation M := (reals F). Notation n := (n F).
Notation small := (small (third F) 1). Notation close := (close F (third F)).
Notation height := (height F M nx ny nz). Notation extent := (extent M).
Definition exact p := nx * x p + ny * y p + nz * z p.
Definition normal := Rabs nx + Rabs ny + Rabs nz.
Definition size p := Rabs (x p) + Rabs (y p) + Rabs (z p).
Definition terms p := Rabs nx * Rabs (x p) + Rabs ny * Rabs (y p) + Rabs nz * Rabs (z p).
Definition within g p := exists s, extent p s /\ below F s g.

Lemma extents_invariant ps g : extents F M ps g -> 0 <= g /\ Forall (within g) ps.
Proof.
assert (N0 : 0 < n) by apply G. induction 1 as [g Z|p ps g g' R [P I] S].
{ simpl in Z. subst. split; [lra|constructor]. }
unfold kdop_greater_extent in S. unpack. subst. cbn [magnitude reals] in *. nonneg.
destruct (greater_right F N0 _ _ _ _ S2 S3) as (B1 & B2 & E).
split; [destruct E; eapply read_nonneg; eassumption|]. constructor.
- exists x1. split; [|exact B1]. exists x0. now split.
- apply Forall_impl with (2 := I). intros p' (s & S' & B). exists s. eauto using below_trans.
Qed.
Lemma extremes_invariant ps low high : extremes F M nx ny nz ps low high ->
  (exists p v, In p ps /\ height p v /\ read F v low) /\ (exists p v, In p ps /\ height p v /\ read F v high).
Proof.
assert (N0 : 0 < n) by apply G.
induction 1 as [p v low high V L H|p ps v low high low' high' R [(a & va & A & A1 & A2) (b & vb & B & B1 & B2)] V L H].
- split; exists p, v; simpl; auto.
- unfold kdop_lower, kdop_higher in *. unpack. subst.
  destruct (lesser_right F N0 _ _ _ _ S1 S2) as (_ & _ & E1).
  destruct (greater_right F N0 _ _ _ _ S S0) as (_ & _ & E2).
  split; [destruct E1|destruct E2];
    [exists p, v|exists a, va|exists p, v|exists b, vb]; simpl; eauto 6 using read_trans.
Qed.

Lemma height_ghost p g v : within g p -> 0 <= g -> small 1028 g -> small 1036 nx -> small 1036 ny -> small 1032 nz ->
  height p v -> (exists g0, close 0 7176 g g0 /\ low (u F) 2 g0 (size p)) /\
  exists v0, close 1 15457 v v0 /\ off (u F) 3 v0 (exact p) (terms p).
Proof.
intros (s & (t & A1 & A2) & B) P Sg Sx Sy Sz V. unfold kdop.height, kdop_height in V. unpack. subst v.
cbn [magnitude reals] in *. nonneg. assert (So : small 1028 s) by (apply (below_small F G) with g; auto; lia).
parts G. inputs G (nx, ny, nz, x p, y p, z p). steps G. pose proof (fits_u _ _ _ _ G) as Hu. split.
- match goal with C : close 0 ?c s ?o0 |- _ => eassert (L : low (u F) _ o0 _) by lows_here Hu;
    pose proof (below_low F G _ _ _ _ _ _ B ltac:(assumption) P C L) as Q end. exact Q.
- match goal with C : close 1 _ x4 ?v |- _ =>
    exists v; split; [exact C|]; eassert (O : off (u F) _ v _ _) by offs Hu end. exact O.
Qed.

Lemma doubt_guard g apart : 0 <= g -> kdop_doubt F R M nx ny nz g (Some apart) ->
  small 1028 g /\ small 1036 nx /\ small 1036 ny /\ small 1032 nz.
Proof.
intros P R. unfold kdop_doubt in R. unpack. constants.
match type of R with _ = (if negb ?c then _ else _) => destruct c eqn:C; [subst|easy] end.
nonneg. guarded G. parts G. auto.
Qed.
(* A multiple of A that is computed pays for what both sides are off; N is a point's sum of magnitudes. *)
Lemma doubt_ghost g apart g0 N : 0 <= g -> kdop_doubt F R M nx ny nz g (Some apart) -> close 0 7176 g g0 ->
  low (u F) 2 g0 N -> exists b0, close 1 9402 apart b0 /\
  (1 - u F) ^ 7 * (relative 18 144 (u F) * (normal * N)) + q 61440 * (n * third F) <= b0.
Proof.
intros P R C L. unfold kdop_doubt in R. unpack. constants.
match type of R with _ = (if negb ?c then _ else _) => destruct c eqn:E; [subst|easy] end.
nonneg. guarded G. parts G. normal G 18 144 10%Z. inputs G (nx, ny, nz).
assert (C4 : n <= 4 <= q 4096) by (destruct G; unfold q; split; lra).
steps G. injection R as <-. pose proof (fits_u _ _ _ _ G) as Hu.
match goal with C : close 1 9402 apart ((?p + 4 * (64 * ?a) * (1 + ?e)) * (1 + ?e')) |- _ =>
  exists ((p + 4 * (64 * a) * (1 + e)) * (1 + e')); split; [exact C|];
  eassert (L' : low (u F) _ p _) by lows_here Hu;
  pose proof (low_rounded (u F) Hu _ _ _ e' L' ltac:(assumption)) as [_ L2];
  assert (A : q 61440 * a <= 4 * (64 * a) * (1 + e) * (1 + e')) end.
{ assert (NH : 0 <= n * third F) by (destruct G; apply Rmult_le_pos; lra).
  pose proof (two_roundings F G (4 * 64) (n * third F) e5 e6 E5 E6 ltac:(lra)) as TR.
  replace (q 61440) with 60 by (unfold q; lra). clear - TR NH. rewrite Rmult_assoc in *. lra. }
unfold normal. cbn [Nat.add Nat.max] in L2. lra.
Qed.

(* of a and b, which are looked at, the computed heights *)
Lemma apart_right a b va vb r s d g apart : within g a -> within g b -> 0 <= g ->
  kdop_doubt F R M nx ny nz g (Some apart) -> height a va -> height b vb -> read F va r -> read F vb s ->
  sub M (Plain r) (Plain s) d -> greater M d apart true ->
  exact b < exact a.
Proof.
intros Wa Wb P D Ha Hb Ra Rb S K. destruct (doubt_guard _ _ P D) as (Sg & Sx & Sy & Sz).
pose proof (fits_u _ _ _ _ G) as Hu.
destruct (height_ghost _ _ _ Wa P Sg Sx Sy Sz Ha) as ((ga & Ca & La) & a0 & Na & Oa).
destruct (height_ghost _ _ _ Wb P Sg Sx Sy Sz Hb) as ((gb & Cb & Lb) & b0 & Nb & Ob).
destruct (doubt_ghost _ _ _ _ P D Ca La) as (xa & Xa & Ya). destruct (doubt_ghost _ _ _ _ P D Cb Lb) as (xb & Xb & Yb).
assert (Nr : close 1 16481 r a0) by exact (read_close F _ 1 1 G _ _ _ _ _ Na Ra).
assert (Ns : close 1 16481 s b0) by exact (read_close F _ 1 1 G _ _ _ _ _ Nb Rb).
destruct S as (r' & s' & Rr & Rs & Z). change (read F r r') in Rr. change (read F s s') in Rs.
apply (read_close F _ 1 1 G _ _ _ _ _ Nr) in Rr. apply (read_close F _ 1 1 G _ _ _ _ _ Ns) in Rs.
destruct (sub_close F _ 1 1 G 1 17505 _ _ 1 17505 _ _ d 1 36069 Rr Rs Z eq_refl eq_refl) as (e & E & C).
assert (X : forall p b', close 1 9402 apart b' -> 0 <= size p ->
  (1 - u F) ^ 7 * (relative 18 144 (u F) * (normal * size p)) + q 61440 * (n * third F) <= b' ->
  (a0 - b0) * (1 + e) > (1 - u F) ^ 7 * (relative 18 144 (u F) * (normal * size p))).
{ intros p b' B P0 L. apply (beyond_bound F G _ _ _ _ _ _ _ C B); [|clear - L G|exact K].
  - normal G 18 144 10%Z. apply Rmult_le_pos; [apply pow_le; lra|]. apply Rmult_le_pos; [exact C0|].
    apply Rmult_le_pos; [unfold normal; magnitudes; positive_terms|exact P0].
  - assert (q (36069 + 9402 + 1024) <= q 61440) by (unfold q; simpl; lra). destruct G.
    assert (q (36069 + 9402 + 1024) * (n * third F) <= q 61440 * (n * third F))
      by (apply Rmult_le_compat_r; [apply Rmult_le_pos|]; lra). lra. }
assert (Sa : forall p, 0 <= size p) by (intros p; unfold size; magnitudes; positive_terms).
apply X in Ya, Yb; auto. clear - Hu G E Oa Ob Ya Yb.
assert (K : forall p, 0 <= ((1 + u F) ^ 3 - 1) * terms p /\ (1 + u F) * (2 * (((1 + u F) ^ 3 - 1) * terms p)) <=
  (1 - u F) ^ 7 * (relative 18 144 (u F) * (normal * size p))).
{ intros p. clear - Hu G. assert (T0 : 0 <= terms p) by (unfold terms; magnitudes; positive_terms).
  assert (T : terms p <= normal * size p) by (unfold terms, normal, size; units). pose proof (upward (u F) Hu 3).
  assert (L : (1 + u F) * ((1 + u F) ^ 3 - 1) <= (1 - u F) ^ 7 * (INR 3 * u F + INR 72 * u F * u F))
    by (apply enough; [exact Hu|destruct G; simpl; lra|destruct G; simpl; lra]).
  split; [apply Rmult_le_pos; lra|].
  apply Rle_trans with ((1 - u F) ^ 7 * (2 * (INR 3 * u F + INR 72 * u F * u F)) * terms p);
    [replace ((1 + u F) * (2 * (((1 + u F) ^ 3 - 1) * terms p))) with
      (2 * ((1 + u F) * ((1 + u F) ^ 3 - 1)) * terms p) by ring; apply Rmult_le_compat_r; lra|].
  rewrite Rmult_assoc. apply Rmult_le_compat_l; [apply pow_le; lra|]. apply Rmult_le_compat; try lra.
  - simpl. assert (0 <= u F * u F) by nra. lra.
  - unfold relative. simpl. assert (0 <= u F * u F) by nra. lra. }
destruct (K a) as [Ka La], (K b) as [Kb Lb]. destruct Oa as [_ Oa%abs_le], Ob as [_ Ob%abs_le].
set (ka := ((1 + u F) ^ 3 - 1) * terms a) in *. set (kb := ((1 + u F) ^ 3 - 1) * terms b) in *.
destruct (beyond (u F) Hu (a0 - b0) e (ka + kb) ((1 + u F) * (ka + kb)) E) as [B _]; [lra|lra|].
assert (a0 - b0 > ka + kb) by (apply B; lra). lra.
Qed.
End Kdop.

(* A point that is passed over has neither the least nor the greatest N . P. *)
Theorem kdop_right F nx ny nz ps p : fits F (third F) 1 1 -> passed_over F (reals F) nx ny nz ps p -> In p ps ->
  let height p := nx * x p + ny * y p + nz * z p in
  exists a b, In a ps /\ In b ps /\ height a < height p < height b.
Proof.
intros G (g & low & high & apart & v & E & X & D & V & B) I.
destruct (extents_invariant F G _ _ E) as [P W]. rewrite Forall_forall in W.
destruct (extremes_invariant F G _ _ _ _ _ _ X) as [(a & va & Ia & Va & Ra) (b & vb & Ib & Vb & Rb)].
unfold kdop_between in B. unpack. symmetry in B. apply andb_prop in B as [-> ->].
exists a, b. split; [exact Ia|]. split; [exact Ib|]. split.
- exact (apart_right F G nx ny nz _ _ _ _ _ _ _ _ _ (W _ I) (W _ Ia) P D V Va (read_refl F v) Ra S S0).
- exact (apart_right F G nx ny nz _ _ _ _ _ _ _ _ _ (W _ Ib) (W _ I) P D Vb V Rb (read_refl F v) S1 S2).
Qed.
