(* SPDX-License-Identifier: Apache-2.0 *)
(* SlabDepths of slab_filter.h, of any number of slabs. Of its operations (the constructor, add, sign) filters.v says
   what they compute; how they follow each other, which robust/volumes/point_in_kdop.cpp has, is said here. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool List.
From Filters Require Import model constants filters steps ghost tactics choices.
Import ListNotations.
Open Scope R_scope.

Record slab T := { nx : T; ny : T; nz : T; bottom : T; top : T }.
Record state T := { depth_ : T; width_ : T; least_ : T; greatest_ : T; sum_ : T }.
Arguments nx {T}. Arguments ny {T}. Arguments nz {T}. Arguments bottom {T}. Arguments top {T}.
Arguments depth_ {T}. Arguments width_ {T}. Arguments least_ {T}. Arguments greatest_ {T}. Arguments sum_ {T}.

Section Run.
Variable F : format.
Context {T : Type}.
Variables (M : machine T) (px py pz : T).
Definition first s t :=
  slab_first F T M px py pz (nx s) (ny s) (nz s) (bottom s) (top s) (depth_ t) (width_ t) (least_ t) (greatest_ t)
    (sum_ t).
Definition added t s t' :=
  slab_add F T M px py pz (depth_ t) (width_ t) (least_ t) (greatest_ t) (sum_ t) (nx s) (ny s) (nz s) (bottom s)
    (top s) (depth_ t') (width_ t') (least_ t') (greatest_ t') (sum_ t').
(* the slab that was added last comes first *)
Inductive folded : list (slab T) -> state T -> Prop :=
| one s t : first s t -> folded [s] t
| more s ss t t' : folded ss t -> added t s t' -> folded (s :: ss) t'.
Definition depths ss answer := exists t, folded ss t /\
  slab_sign F T M px py pz (depth_ t) (width_ t) (least_ t) (greatest_ t) (sum_ t) answer.

(* what the constructor and add compute of a slab *)
Definition found s over under depth width of_normal :=
  exists t, mul M (nx s) px t /\ exists t1, mul M (ny s) py t1 /\
  exists t2, add M (Product (nx s) px t) (Product (ny s) py t1) t2 /\ exists t3, mul M (nz s) pz t3 /\
  exists value, add M (Plain t2) (Product (nz s) pz t3) value /\
  sub M (Plain value) (Plain (bottom s)) over /\ sub M (Plain (top s)) (Plain value) under /\
  (exists b, greater M under over b /\ choose M b over under depth) /\
  sub M (Plain (top s)) (Plain (bottom s)) width /\
  exists t9, add M (Plain (magnitude M (nx s))) (Plain (magnitude M (ny s))) t9 /\
  add M (Plain t9) (Plain (magnitude M (nz s))) of_normal.
Lemma first_found s t : first s t -> exists over under, found s over under (depth_ t) (width_ t) (least_ t) /\
  greatest_ t = least_ t /\ sub M (Plain over) (Plain under) (sum_ t).
Proof.
intros R. unfold first, slab_first in R. unpack. destruct R as (E1 & E2 & E3 & E4 & E5).
exists x4, x5. rewrite E1, E2, E3, E4, E5. split; [|easy]. unfold found. repeat eexists; eassumption.
Qed.
Lemma added_found t s t' : added t s t' -> exists over under depth width of_normal,
  found s over under depth width of_normal /\
  (exists b, greater M depth (depth_ t) b /\ choose M b (depth_ t) depth (depth_ t')) /\
  (exists b, greater M width (width_ t) b /\ choose M b (width_ t) width (width_ t')) /\
  (exists b, greater M of_normal (least_ t) b /\ choose M b (least_ t) of_normal (least_ t')) /\
  (exists b, greater M of_normal (greatest_ t) b /\ choose M b of_normal (greatest_ t) (greatest_ t')) /\
  (exists d, sub M (Plain over) (Plain under) d /\ add M (Plain (sum_ t)) (Plain d) (sum_ t')).
Proof.
intros R. unfold added, slab_add in R. unpack. destruct R as (E1 & E2 & E3 & E4 & E5).
exists x4, x5, x7, x8, x10. rewrite E1, E2, E3, E4, E5. split; [|repeat split; eexists; split; eassumption].
unfold found. repeat eexists; eassumption.
Qed.
End Run.

Section Slab.
Variable F : format.
Hypothesis G : fits F (third F) 1 1.
Variables px py pz : R.
Notation M := (reals F). Notation n := (n F).
Notation small := (small (third F) 1). Notation close := (close F (third F)).
Definition height s := nx s * px + ny s * py + nz s * pz.

(* of each slab the numbers are beyond those kept, and the depth is one of them *)
Definition in_state t s := exists over under depth width of_normal, found M px py pz s over under depth width of_normal
  /\ below F (depth_ t) over /\ below F (depth_ t) under /\ below F of_normal (greatest_ t).
Definition deepest t s := exists over under depth width of_normal, found M px py pz s over under depth width of_normal
  /\ below F of_normal (greatest_ t) /\ (read F over (depth_ t) \/ read F under (depth_ t)).

Lemma of_normal_nonneg s over under depth width o : found M px py pz s over under depth width o -> 0 <= o.
Proof. intros R. unfold found in R. unpack. destruct R as (_ & _ & _ & _ & t9 & A1 & A2). nonneg. assumption. Qed.

Theorem folded_invariant ss t : folded F M px py pz ss t -> 0 <= greatest_ t /\ Forall (in_state t) ss /\ Exists
  (deepest t) ss.
Proof.
assert (N0 : 0 < n) by apply G.
induction 1 as [s t R|s ss t t' R [P [I [i [E D]]%Exists_exists]] A].
- apply first_found in R as (over & under & Fo & EG & _). pose proof (of_normal_nonneg _ _ _ _ _ _ Fo) as P.
  split; [now rewrite EG|]. assert (C : exists b, greater M under over b /\ choose M b over under (depth_ t))
    by (unfold found in Fo; unpack; apply Fo).
  destruct C as (b & C & K). destruct (lesser_right F N0 _ _ _ _ C K) as (B1 & B2 & E).
  split; [apply Forall_cons; [|apply Forall_nil]|apply Exists_cons_hd].
  + exists over, under, (depth_ t), (width_ t), (least_ t). rewrite EG. auto using below_refl.
  + exists over, under, (depth_ t), (width_ t), (least_ t). rewrite EG. auto using below_refl.
- apply added_found in A as (over & under & depth & width & o & Fo & (b1 & C1 & K1) & _ & _ & (b4 & C4 & K4) & _).
  pose proof (of_normal_nonneg _ _ _ _ _ _ Fo) as P'.
  assert (C : exists b, greater M under over b /\ choose M b over under depth) by (unfold found in Fo; unpack; apply Fo).
  destruct C as (b & C & K). destruct (lesser_right F N0 _ _ _ _ C K) as (B1 & B2 & E').
  destruct (lesser_right F N0 _ _ _ _ C1 K1) as (L1 & L2 & E1).
  destruct (greater_right F N0 _ _ _ _ C4 K4) as (G1 & G2 & E4).
  split; [destruct E4; eapply read_nonneg; eassumption|]. split.
  + constructor.
    * exists over, under, depth, width, o. repeat split; eauto using below_trans.
    * apply Forall_impl with (2 := I). intros s' (o1 & o2 & o3 & o4 & o5 & Fo' & Q1 & Q2 & Q3).
      exists o1, o2, o3, o4, o5. repeat split; eauto using below_trans.
  + destruct E1 as [E1|E1].
    * apply Exists_cons_tl, Exists_exists. exists i. split; [exact E|].
      destruct D as (o1 & o2 & o3 & o4 & o5 & Fo' & Q & D). exists o1, o2, o3, o4, o5.
      repeat split; eauto using below_trans. destruct D; [left|right]; eauto using read_trans.
    * apply Exists_cons_hd. exists over, under, depth, width, o. repeat split; eauto using below_trans.
      destruct E'; [left|right]; eauto using read_trans.
Qed.

(* The ghosts of one slab. g is what the bound is made of. *)
Lemma ghosts s over under depth width o g : found M px py pz s over under depth width o -> below F o g -> 0 <= g ->
  small 1028 g -> small 1036 px -> small 1036 py -> small 1032 pz ->
  (exists g0, close 0 7176 g g0 /\ low (u F) 2 g0 (Rabs (nx s) + Rabs (ny s) + Rabs (nz s))) /\
  exists v e e', Rabs e <= u F /\ Rabs e' <= u F /\ close 1 18547 over ((v - bottom s) * (1 + e)) /\
    close 1 18547 under ((top s - v) * (1 + e')) /\
    off (u F) 3 v (height s) (Rabs (nx s) * Rabs px + Rabs (ny s) * Rabs py + Rabs (nz s) * Rabs pz).
Proof.
intros R B P Sg Sx Sy Sz. unfold found in R. unpack. destruct R as (D1 & D2 & _ & _ & t9 & A3 & A4).
cbn [magnitude reals] in *.
nonneg. assert (So : small 1028 o) by (apply (below_small F G) with g; auto; lia).
parts G. inputs G (nx s, ny s, nz s, px, py, pz, bottom s, top s). steps G.
pose proof (fits_u _ _ _ _ G) as Hu. split.
- match goal with C : close 0 ?c o ?o0 |- _ => eassert (L : low (u F) _ o0 _) by lows_here Hu;
    pose proof (below_low F G _ _ _ _ _ _ B ltac:(assumption) P C L) as Q end. exact Q.
- match goal with C : close 1 _ over ((?v - bottom s) * (1 + ?e)) |- _ =>
    match goal with C' : close 1 _ under ((top s - v) * (1 + ?e')) |- _ =>
    exists v, e, e'; repeat (split; [assumption|]); eassert (O : off (u F) _ v _ _) by offs Hu end end.
  exact O.
Qed.

Lemma guarded t answer :
  slab_sign F R M px py pz (depth_ t) (width_ t) (least_ t) (greatest_ t) (sum_ t) answer ->
  0 <= greatest_ t -> answer <> unknown ->
  small 1028 (greatest_ t) /\ small 1036 px /\ small 1036 py /\ small 1032 pz.
Proof.
intros R P U. unfold slab_sign in R. unpack. constants.
match type of R with _ = (if negb ?c then _ else _) => destruct c eqn:C; [|now subst] end.
repeat match goal with C : (_ && _)%bool = true |- _ => apply andb_prop in C; destruct C end; subst.
nonneg. guarded G. parts G. auto.
Qed.
Lemma signs t answer g0 N D0 : 0 <= greatest_ t -> close 0 7176 (greatest_ t) g0 -> low (u F) 2 g0 N ->
  close 1 20595 (depth_ t) D0 ->
  slab_sign F R M px py pz (depth_ t) (width_ t) (least_ t) (greatest_ t) (sum_ t) answer ->
  let X := (1 - u F) ^ 7 * (relative 6 48 (u F) * (N * (Rabs px + Rabs py + Rabs pz))) in
  (answer = positive -> D0 > X) /\ (answer = negative -> D0 < - X).
Proof.
intros P C L D R X. unfold slab_sign in R. unpack. constants. flags R. nonneg. guarded G. parts G.
normal G 6 48 4%Z. inputs G (px, py, pz). steps G. bounded G 64%Z lows_here Pos Neg.
split; intros ->; destruct x18; try discriminate; auto.
Qed.

Lemma read_depth d x x0 : read F x d -> close 1 18547 x x0 -> close 1 20595 d x0.
Proof.
intros R C. destruct (read_close F (third F) 1 1 G _ _ _ _ _ C R) as [_ L]. split; [lia|].
assert (N0 : 0 < n) by apply G. pose proof (n_pow F (third F) 1 1 G 1) as N1. apply Rle_trans with (1 := L).
apply Rmult_le_compat_r; [lra|]. unfold q. simpl. lra.
Qed.

(* rule (5), and that the greatest sum of a normal's magnitudes times the point's is more than the slab's terms *)
Lemma bound_enough a b c : let T := Rabs a * Rabs px + Rabs b * Rabs py + Rabs c * Rabs pz in
  let K := ((1 + u F) ^ 3 - 1) * T in 0 <= K /\ (1 + u F) * K <=
  (1 - u F) ^ 7 * (relative 6 48 (u F) * ((Rabs a + Rabs b + Rabs c) * (Rabs px + Rabs py + Rabs pz))).
Proof.
pose proof (fits_u _ _ _ _ G) as Hu. intros T K. pose proof (upward (u F) Hu 3) as U.
assert (T0 : 0 <= T) by (unfold T; magnitudes; positive_terms).
split; [apply Rmult_le_pos; lra|]. unfold K. rewrite <- Rmult_assoc.
normal G 6 48 4%Z. assert (L : (1 + u F) * ((1 + u F) ^ 3 - 1) * T <=
  (1 - u F) ^ 7 * (relative 6 48 (u F) * ((Rabs a + Rabs b + Rabs c) * (Rabs px + Rabs py + Rabs pz)))); [|exact L].
clear U. unfold T in *. constant_is_enough G 48%nat.
Qed.

Lemma sign_of ss t answer : 0 <= greatest_ t -> Forall (in_state t) ss -> Exists (deepest t) ss ->
  slab_sign F R M px py pz (depth_ t) (width_ t) (least_ t) (greatest_ t) (sum_ t) answer ->
  (answer = positive -> Forall (fun s => bottom s < height s < top s) ss) /\
  (answer = negative -> Exists (fun s => height s < bottom s \/ top s < height s) ss).
Proof.
pose proof (fits_u _ _ _ _ G) as Hu. intros P All Ex S.
assert (U : answer <> unknown -> small 1028 (greatest_ t) /\ small 1036 px /\ small 1036 py /\ small 1032 pz)
  by (intros U; exact (guarded _ _ S P U)).
split; intros A; destruct (U ltac:(now rewrite A)) as (Sg & Sx & Sy & Sz).
- apply Forall_impl with (2 := All). intros s (over & under & depth & width & o & Fo & B1 & B2 & B3).
  destruct (ghosts _ _ _ _ _ _ _ Fo B3 P Sg Sx Sy Sz) as ((g0 & C & L) & v & e & e' & E & E' & C1 & C2 & _ & O).
  destruct (bound_enough (nx s) (ny s) (nz s)) as [K0 K].
  destruct (below_close F G _ _ _ _ B1 C1) as (d1 & D1 & L1).
  destruct (below_close F G _ _ _ _ B2 C2) as (d2 & D2 & L2).
  pose proof (proj1 (signs _ _ _ _ _ P C L D1 S) A) as X1. pose proof (proj1 (signs _ _ _ _ _ P C L D2 S) A) as X2.
  apply abs_le in O.
  match type of K with _ * ?k <= _ =>
    assert (v - bottom s > k) by (apply (beyond (u F) Hu _ _ _ _ E K0 K); lra);
    assert (top s - v > k) by (apply (beyond (u F) Hu _ _ _ _ E' K0 K); lra) end.
  lra.
- apply Exists_exists in Ex as (s & I & over & under & depth & width & o & Fo & B3 & D).
  apply Exists_exists. exists s. split; [exact I|].
  destruct (ghosts _ _ _ _ _ _ _ Fo B3 P Sg Sx Sy Sz) as ((g0 & C & L) & v & e & e' & E & E' & C1 & C2 & _ & O).
  destruct (bound_enough (nx s) (ny s) (nz s)) as [K0 K]. apply abs_le in O.
  destruct D as [D|D]; [left|right].
  + pose proof (proj2 (signs _ _ _ _ _ P C L (read_depth _ _ _ D C1) S) A) as X.
    apply (beyond (u F) Hu _ _ _ _ E K0 K) in X. lra.
  + pose proof (proj2 (signs _ _ _ _ _ P C L (read_depth _ _ _ D C2) S) A) as X.
    apply (beyond (u F) Hu _ _ _ _ E' K0 K) in X. lra.
Qed.
Lemma sign_right ss answer : depths F M px py pz ss answer ->
  (answer = positive -> Forall (fun s => bottom s < height s < top s) ss) /\
  (answer = negative -> Exists (fun s => height s < bottom s \/ top s < height s) ss).
Proof.
intros (t & R & S). destruct (folded_invariant _ _ R) as (P & All & Ex). exact (sign_of ss t answer P All Ex S).
Qed.

(* Where all operations read alike, a sign is answered of valid slabs only. *)
Variable zeros : bool.
Notation M1 := (one_mode F zeros). Notation seen := (seen F zeros).
Definition valid s := ~ (nx s = 0 /\ ny s = 0 /\ nz s = 0) /\ bottom s < top s.
Definition shown t s := (seen (least_ t) > 0 -> ~ (nx s = 0 /\ ny s = 0 /\ nz s = 0)) /\
  (seen (width_ t) > 0 -> bottom s < top s).

Lemma found_valid s over under depth width o : found M1 px py pz s over under depth width o ->
  (seen o > 0 -> ~ (nx s = 0 /\ ny s = 0 /\ nz s = 0)) /\ (seen width > 0 -> bottom s < top s).
Proof.
assert (N0 : 0 < n) by apply G. intros R. unfold found in R. unpack. destruct R as (_ & _ & _ & W & R). unpack.
split; intros P; apply (seen_positive F N0) in P.
- intros (X & Y & Z). rewrite X, Y, Z in *. cbn [magnitude one_mode] in *. rewrite Rabs_R0 in *.
  destruct S4 as (x' & y' & -> & -> & _ & _ & S4). destruct R as (x'' & y'' & -> & -> & _ & _ & R).
  cbn [seen_of] in *. rewrite (seen_zero F) in *. specialize (S4 ltac:(lra)). apply (seen_mono F N0 zeros) in S4.
  rewrite (seen_zero F) in *. specialize (R ltac:(lra)). lra.
- destruct W as (x' & y' & -> & -> & _ & _ & W). cbn [seen_of] in *. apply Rnot_le_lt. intros L.
  apply (seen_mono F N0 zeros) in L. specialize (W ltac:(lra)). lra.
Qed.
Theorem folded_valid ss t : folded F M1 px py pz ss t -> Forall (shown t) ss.
Proof.
induction 1 as [s t R|s ss t t' R I A].
- apply first_found in R as (over & under & Fo & _). apply Forall_cons; [|apply Forall_nil].
  exact (found_valid _ _ _ _ _ _ Fo).
- apply added_found in A as (over & under & depth & width & o & Fo & _ & (b2 & C2 & K2) & (b3 & C3 & K3) & _).
  apply (lesser_seen F) in K2 as [W1 W2]; [|exact C2]. apply (lesser_seen F) in K3 as [L1 L2]; [|exact C3].
  apply found_valid in Fo as [V1 V2]. constructor.
  + split; intros; [apply V1|apply V2]; lra.
  + apply Forall_impl with (2 := I). intros s' [V3 V4]. split; intros; [apply V3|apply V4]; lra.
Qed.
Lemma all_valid ss answer : depths F M1 px py pz ss answer -> answer <> unknown -> Forall valid ss.
Proof.
intros (t & R & S) U. apply folded_valid in R. unfold slab_sign in S. unpack. cbn [constant one_mode] in *. subst.
match type of U with (if negb ?c then _ else _) <> _ => destruct c eqn:C; [|easy] end.
repeat match goal with C : (_ && _)%bool = true |- _ => apply andb_prop in C; destruct C end.
repeat match goal with B : greater _ _ _ ?b, C : ?b = true |- _ => apply B in C; clear B end.
rewrite (seen_zero F) in *. apply Forall_impl with (2 := R). intros s [V1 V2]. split; auto.
Qed.
(* such a run is among all *)
Ltac among R := lazymatch type of R with
  | exists _, _ => let x := fresh "x" in let S := fresh "S" in destruct R as (x & S & R); exists x; split;
    [first [exact S | exact (mul_in _ _ _ _ _ S) | exact (add_in _ _ _ _ _ S) | exact (sub_in _ _ _ _ _ S)
      | exact (greater_in _ _ _ _ _ S) | exact (at_most_in _ _ _ _ _ S) | exact (keep_in _ _ _ _ _ _ S)] | among R]
  | _ => exact R end.
Lemma depths_in ss answer : depths F M1 px py pz ss answer -> depths F M px py pz ss answer.
Proof.
intros (t & R & S). exists t. split.
- clear S. induction R as [s t R|s ss t t' _ I R]; [apply one|apply more with (1 := I)].
  + unfold first, slab_first in *. among R.
  + unfold added, slab_add in *. among R.
- unfold slab_sign in *. among S.
Qed.
End Slab.

(* Positive: strictly within all slabs; negative: beyond an end of one. Where all operations read alike, all of the
   slabs are valid then. *)
Theorem slab_right F px py pz ss answer : fits F (third F) 1 1 ->
  let height s := nx s * px + ny s * py + nz s * pz in
  let signs := (answer = positive -> Forall (fun s => bottom s < height s < top s) ss) /\
    (answer = negative -> Exists (fun s => height s < bottom s \/ top s < height s) ss) in
  (depths F (reals F) px py pz ss answer -> signs) /\
  (forall zeros, depths F (one_mode F zeros) px py pz ss answer -> signs /\ (answer <> unknown ->
    Forall (fun s => ~ (nx s = 0 /\ ny s = 0 /\ nz s = 0) /\ bottom s < top s) ss)).
Proof.
intros G height signs. assert (S : depths F (reals F) px py pz ss answer -> signs) by
  exact (sign_right F G px py pz ss answer).
split; [exact S|]. intros zeros R. split.
- exact (S (depths_in F px py pz zeros ss answer R)).
- exact (all_valid F G px py pz zeros ss answer R).
Qed.
