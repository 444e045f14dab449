(* SPDX-License-Identifier: Apache-2.0 *)
(* SlabDepths on all of binary64, of any number of slabs. NaN and infinities never leave the sum, and the greatest sum
   of a normal's magnitudes bounds all of them; the ends of slabs need no guard. *)
From Coq Require Import Reals ZArith Lra Lia Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model constants filters steps tactics choices format floats float_steps float_guards.
From Filters Require Import float_run overflow maxima slab.
Import ListNotations.
Open Scope R_scope.

Definition real_slab (s : slab float) : slab R :=
  {| nx := value (nx s); ny := value (ny s); nz := value (nz s); bottom := value (bottom s); top := value (top s) |}.
Definition finite_slab (s : slab float) := Forall finite [nx s; ny s; nz s; bottom s; top s].

Section Slab.
Variables px py pz : float.
Notation found := (found floats px py pz).
Notation found_real := (slab.found M (value px) (value py) (value pz)).

(* a slab whose numbers over and under are finite *)
Lemma found_finite s over under depth width o : found s over under depth width o -> finite over -> finite under ->
  finite_slab s /\ finite depth /\ up o /\ is_nan o = false.
Proof.
intros R A B. unfold slab.found in R. unpack. destruct R as (D1 & D2 & (b & C & K) & _ & t9 & A1 & A2).
destruct (sub_finite _ _ _ D1 A) as [V E1]. destruct (sub_finite _ _ _ D2 B) as [E2 _].
destruct (terms_finite _ _ _ _ _ _ _ _ _ _ _ S S0 S1 S2 S3 V) as (X & Y & Z).
assert (U : up t9) by (apply (add_up _ _ _ A1); apply up_abs).
repeat split.
- repeat apply Forall_cons; auto.
- destruct b; exact (finite_reads _ _ K ltac:(assumption)).
- apply (add_up _ _ _ A2); [exact U|apply up_abs].
- apply (sum_number _ _ _ A2); [|now apply number_abs|exact U|apply up_abs].
  apply (sum_number _ _ _ A1); try apply up_abs; now apply number_abs.
Qed.
Lemma found_is_real s over under depth width o : found s over under depth width o -> finite over -> finite under ->
  mag px 345 -> mag py 345 -> mag pz 345 -> mag o 342 ->
  exists width', found_real (real_slab s) (value over) (value under) (value depth) width' (value o).
Proof.
intros R A B PX PY PZ O. destruct (found_finite _ _ _ _ _ _ R A B) as (E & _). unfold finite_slab in E.
repeat match goal with E : Forall _ (_ :: _) |- _ => inversion_clear E; subst end.
unfold slab.found in R. unpack. destruct R as (D1 & D2 & (b & C & K) & _ & t9 & A1 & A2).
float_constants. rising. back.
exists (value (top s) - value (bottom s)). unfold slab.found. cbn [nx ny nz bottom top real_slab].
do 4 advance.
lazymatch goal with S : add floats _ _ ?v, D : sub floats (Plain ?v) _ over |- _ => forward S; exists (value v);
  let W := bound_of v in split; [exact (add_real _ _ v _ S W eq_refl)|];
  split; [exact (off_real _ _ _ _ D1 A (conj W I : within (Plain v) _) eq_refl)|];
  split; [exact (less_real _ _ _ _ D2 B (conj W I : within (Plain v) _) eq_refl)|] end.
split; [exists b; split; [exact (greater_real _ _ _ C B A)|exact (choose_real _ _ _ _ K)]|].
split. { exists (value (top s)), (value (bottom s)). split; [now left|]. split; [now left|apply rounded_itself]. }
exists (value t9). split; as_real; [let W := bound_of t9 in exact (add_real _ _ t9 _ A1 W eq_refl)|].
exact (add_real _ _ o _ A2 O eq_refl).
Qed.

(* Of the state the proof on real numbers asks for the depth and the greatest sum alone. *)
Definition real_state (t : state float) : state R :=
  {| depth_ := value (depth_ t); width_ := 1; least_ := 1; greatest_ := value (greatest_ t); sum_ := 0 |}.
Lemma folded_real ss t : folded binary64 floats px py pz ss t -> finite (sum_ t) -> up (greatest_ t) /\
  finite (depth_ t) /\ Forall finite_slab ss /\
  (mag px 345 -> mag py 345 -> mag pz 345 -> mag (greatest_ t) 342 ->
   Forall (in_state binary64 (value px) (value py) (value pz) (real_state t)) (map real_slab ss) /\
   Exists (deepest binary64 (value px) (value py) (value pz) (real_state t)) (map real_slab ss)).
Proof.
assert (N0 : 0 < n binary64) by apply bpow_gt_0.
induction 1 as [s t R|s ss t t' R IH A]; intros F.
- apply first_found in R as (over & under & Fo & EG & S). destruct (sub_finite _ _ _ S F) as [A B].
  destruct (found_finite _ _ _ _ _ _ Fo A B) as (E & D & U & N). rewrite EG.
  split; [exact U|]. split; [exact D|]. split; [apply Forall_cons; [exact E|apply Forall_nil]|]. intros PX PY PZ G.
  destruct (found_is_real _ _ _ _ _ _ Fo A B PX PY PZ G) as [w Fr]. pose proof Fr as Q.
  unfold slab.found in Q. unpack. destruct Q as (_ & _ & (b & C & K) & _).
  destruct (lesser_right binary64 N0 _ _ _ _ C K) as (B1 & B2 & E').
  split; [apply Forall_cons; [|apply Forall_nil]|apply Exists_cons_hd];
    exists (value over), (value under), (value (depth_ t)), w, (value (least_ t)); cbn [depth_ greatest_ real_state];
    rewrite EG; auto using below_refl.
- apply added_found in A as (over & under & depth & width & o & Fo & (b1 & C1 & K1) & _ & _ & (b4 & C4 & K4) &
    d & S & T).
  destruct (add_finite _ _ _ T F) as [F' FD]. destruct (sub_finite _ _ _ S FD) as [A B].
  destruct (IH F') as (U' & D' & E' & Q). destruct (found_finite _ _ _ _ _ _ Fo A B) as (E & D & U & N).
  split; [destruct b4; [exact (reads_up _ _ K4 U)|exact (reads_up _ _ K4 U')]|].
  split; [destruct b1; [exact (finite_reads _ _ K1 D')|exact (finite_reads _ _ K1 D)]|].
  split; [apply Forall_cons; [exact E|exact E']|]. intros PX PY PZ G.
  destruct (greater_mag _ _ _ _ _ C4 K4 G ltac:(lia) U U' N) as [GO GT]. destruct (Q PX PY PZ GT) as [All Ex].
  destruct (found_is_real _ _ _ _ _ _ Fo A B PX PY PZ GO) as [w Fr]. pose proof Fr as P.
  unfold slab.found in P. unpack. destruct P as (_ & _ & (b & C & K) & _).
  destruct (lesser_right binary64 N0 _ _ _ _ C K) as (B1 & B2 & E2). apply greater_real in C1, C4; try apply GO; auto.
  2: apply GT. apply choose_real in K1, K4.
  destruct (lesser_right binary64 N0 _ _ _ _ C1 K1) as (L1 & L2 & E1).
  destruct (greater_right binary64 N0 _ _ _ _ C4 K4) as (G1 & G2 & _).
  split; simpl.
  + constructor.
    * exists (value over), (value under), (value depth), w, (value o). cbn [depth_ greatest_ real_state].
      repeat split; eauto using below_trans.
    * apply Forall_impl with (2 := All). intros s' (o1 & o2 & o3 & o4 & o5 & Fo' & Q1 & Q2 & Q3).
      exists o1, o2, o3, o4, o5. cbn [depth_ greatest_ real_state] in *. repeat split; eauto using below_trans.
  + destruct E1 as [E1|E1].
    * apply Exists_cons_tl. apply Exists_exists in Ex as (s' & Is & o1 & o2 & o3 & o4 & o5 & Fo' & Q1 & Q2).
      apply Exists_exists. exists s'. split; [exact Is|]. exists o1, o2, o3, o4, o5.
      cbn [depth_ greatest_ real_state] in *. repeat split; eauto using below_trans.
      destruct Q2; [left|right]; eauto using read_trans.
    * apply Exists_cons_hd. exists (value over), (value under), (value depth), w, (value o).
      cbn [depth_ greatest_ real_state]. repeat split; eauto using below_trans.
      destruct E2; [left|right]; eauto using read_trans.
Qed.
End Slab.

(* Positive: strictly within all slabs; negative: beyond an end of one. *)
Theorem slab_binary64 (px py pz : float) ss answer : depths binary64 floats px py pz ss answer ->
  let height s := value (nx s) * value px + value (ny s) * value py + value (nz s) * value pz in
  (answer <> unknown -> Forall finite [px; py; pz] /\ Forall finite_slab ss) /\
  (answer = positive -> Forall (fun s => value (bottom s) < height s < value (top s)) ss) /\
  (answer = negative -> Exists (fun s => height s < value (bottom s) \/ value (top s) < height s) ss).
Proof.
intros (t & Fo & S) height. unfold slab_sign in S. unpack.
match type of S with _ = (if negb ?c then _ else _) => destruct c eqn:C; cbn [negb] in S;
  [|subst; repeat split; intros; discriminate || easy] end.
repeat match goal with C : (_ && _)%bool = true |- _ => apply andb_prop in C; destruct C end.
repeat match goal with C : ?b = true |- _ => is_var b; subst b end.
float_constants.
assert (F : finite (sum_ t)).
{ match goal with S : sub floats (Plain (sum_ t)) _ ?d, A : at_most floats ?d _ true |- _ =>
    exact (difference_finite _ _ _ S A) end. }
destruct (folded_real _ _ _ _ _ Fo F) as (UG & FD & FS & Q). rising. guards. back.
assert (P : mag px 345 /\ mag py 345 /\ mag pz 345).
{ split; [|split]; match goal with B : mag ?x ?k |- mag ?x 345 => exact (mag_up x k 345 B ltac:(discriminate)) end. }
destruct P as (PX & PY & PZ). destruct (Q PX PY PZ ltac:(assumption)) as [All Ex]. pose proof (finite_mag _ FD) as DM.
split; [intros _; split; [all_finite|exact FS]|].
assert (V : slab_sign binary64 R M (value px) (value py) (value pz) (value (depth_ t)) 1 1 (value (greatest_ t)) 0
  answer).
{ repeat match goal with S : greater floats (least_ t) _ _ |- _ => clear S
    | S : greater floats (width_ t) _ _ |- _ => clear S
    | S : at_most floats ?d _ _, D : sub floats (Plain (sum_ t)) _ ?d |- _ => clear S D end.
  repeat match goal with C : constant floats 0 ?c |- _ =>
    lazymatch goal with _ : value c = 0 |- _ => fail | _ => pose proof (proj2 C : value c = 0) end end.
  assert (L : forall v w b, (b = true <-> v > w) -> greater M v w b)
    by (intros v w b K; exists v, w; split; [now left|]; split; [now left|exact K]).
  unfold slab_sign. repeat advance.
  exists true. split; [apply L; split; [lra|easy]|]. advance. exists true. split; [apply L; split; [lra|easy]|].
  exists 0. split. { exists 0, 0. split; [now left|]. split; [now left|]. rewrite Rminus_0_r. apply rounded_itself. }
  advance. lazymatch goal with |- exists b, at_most M 0 (value ?c) b /\ _ => exists true; split;
    [exists 0, (value c); split; [now left|]; split; [now left|]; split; [lra|easy]|] end.
  repeat advance. exact S. }
destruct (sign_of binary64 fits_third _ _ _ _ (real_state t) answer (up_value _ UG) All Ex V) as [P N].
split; intros A; [apply P, Forall_map in A; exact A|apply N in A].
apply Exists_exists in A as (s & I & L). apply in_map_iff in I as (s' & <- & I).
apply Exists_exists. exists s'. split; [exact I|exact L].
Qed.
