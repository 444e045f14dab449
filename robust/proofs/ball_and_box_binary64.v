(* SPDX-License-Identifier: Apache-2.0 *)
(* ball_and_box on all of binary64. Of the two differences of beyond_interval the guard bounds only the chosen one, or
   none where 0 is chosen; the box's own extent bounds the other. *)
From Coq Require Import Reals ZArith Lra Lia Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model constants filters steps tactics format floats float_steps float_guards float_run.
From Filters Require Import ball_and_box.
Import ListNotations.
Open Scope R_scope.
#[local] Existing Instances p53 fexp_valid below_1024.
#[local] Coercion value : float >-> R.

(* at least 1; an infinity too *)
Definition great (x : float) := (finite x /\ 1 <= value x) \/ x = B754_infinity false.
Definition bad (x : float) := x = B754_nan \/ great x.
Lemma least_small : 0 < least < 1.
Proof.
split; [apply bpow_gt_0|]. change 1 with (bpow radix2 0). unfold least. apply bpow_lt. lia.
Qed.
Lemma reads_bad x x' : reads x x' -> bad x -> x' = x.
Proof.
intros [->|(F & L & _)] B; [reflexivity|]. exfalso. pose proof least_small. apply Rabs_def2 in L.
destruct B as [->|[[_ G]| ->]]; try discriminate. lra.
Qed.
Lemma reads_mild x x' : reads x x' -> ~ bad x -> ~ bad x'.
Proof.
intros [->|(_ & _ & s & ->)] N; [exact N|]. intros [E|[[_ G]|E]]; try discriminate. rewrite value_zero in G. lra.
Qed.
(* what is not bad is less than 1 *)
Lemma mild x : ~ bad x -> (finite x /\ value x < 1) \/ x = B754_infinity true.
Proof.
intros N. destruct (finite_or x) as [F|F].
- left. split; [exact F|]. apply Rnot_le_lt. intros L. apply N. right. now left.
- right. destruct x as [|[]| |]; try easy; exfalso; apply N; [right; now right|now left].
Qed.
Lemma great_greater x y : great x -> ~ bad y -> Bcompare x y = Some Gt.
Proof.
intros G [[F L]| ->]%mild; destruct G as [[E K]| ->].
- rewrite (compared x y _ E F eq_refl). rewrite Rcompare_Gt by lra. reflexivity.
- destruct y; try discriminate; reflexivity.
- destruct x; try discriminate; reflexivity.
- reflexivity.
Qed.
Lemma not_greater x y : ~ bad x -> bad y -> Bcompare x y <> Some Gt.
Proof.
intros [[F L]| ->]%mild [->|[[E K]| ->]]; try (destruct x; discriminate); try discriminate.
- rewrite (compared x y _ F E eq_refl). rewrite Rcompare_Lt by lra. discriminate.
- destruct y; discriminate.
Qed.

(* where 0 is chosen, neither difference is great, and the greater one is a number *)
Lemma inside above below b more z0 : greater floats above below b -> choose floats b above below more ->
  finite z0 -> value z0 = 0 -> greater floats z0 more true -> ~ great above /\ ~ great below /\
  (if b then above else below) <> B754_nan.
Proof.
intros (a & c & A & C & E) R F V (z & m & Z & M & G).
assert (Z0 : ~ bad z0) by (intros [->|[[_ L]| ->]]; try discriminate; lra).
assert (N : ~ bad more).
{ intros B. rewrite (reads_bad _ _ M B) in G. apply (not_greater z more (reads_mild _ _ Z Z0)) in B.
  destruct (Bcompare z more) as [[]|]; congruence. }
assert (D : ~ bad (if b then above else below)) by (intros B; apply N; now rewrite (reads_bad _ _ R B)).
destruct b.
- split; [|split]; try (intros ->; apply D; now left); intros B; [apply D; now right|].
  rewrite (reads_bad _ _ C (or_intror B)) in E.
  apply (not_greater a below (reads_mild _ _ A D) (or_intror B)). now destruct (Bcompare a below) as [[]|].
- split; [|split]; try (intros ->; apply D; now left); intros B; [|apply D; now right].
  rewrite (reads_bad _ _ A (or_intror B)), (great_greater _ _ B (reads_mild _ _ C D)) in E. discriminate.
Qed.

Lemma sub_plain p q z : sub floats (Plain p) (Plain q) z ->
  exists m x y, reads p x /\ reads q y /\ yields (value x - value y) (Bminus m x y) z.
Proof. intros (m & [(x & y & S)|[(a & b & y & [] & _)|(x & a & b & _ & [] & _)]]). exists m, x, y. exact S. Qed.
Lemma reads_infinite x x' : reads x x' -> infinite x -> x' = x.
Proof. intros [->|(F & _)] I; [reflexivity|]. now destruct x. Qed.
Lemma finite_infinite x : finite x -> ~ infinite x. Proof. now destruct x. Qed.
Lemma yields_infinite r f z : yields r f z -> infinite f -> z = f.
Proof. intros [->|(F & _)] I; [reflexivity|]. now destruct f. Qed.
(* the center is a number *)
Lemma center_finite c min max below above (b : bool) : finite min -> finite max ->
  sub floats (Plain min) (Plain c) below -> sub floats (Plain c) (Plain max) above ->
  ~ great above -> ~ great below -> (if b then above else below) <> B754_nan -> finite c.
Proof.
intros A B (m & x & y & X & Y & Z)%sub_plain (m' & x' & y' & X' & Y' & Z')%sub_plain N1 N2 D.
destruct (finite_or c) as [F|F]; [exact F|]. exfalso.
rewrite (reads_infinite _ _ Y F) in Z. rewrite (reads_infinite _ _ X' F) in Z'.
apply finite_reads in X; [|exact A]. apply finite_reads in Y'; [|exact B].
destruct c as [|[]| |]; try easy.
- apply N2. right. destruct x; try discriminate; exact (yields_infinite _ _ _ Z I).
- apply N1. right. destruct y'; try discriminate; exact (yields_infinite _ _ _ Z' I).
- apply D. destruct b; [destruct y'|destruct x]; try discriminate;
    first [exact (yields_infinite _ _ _ Z I)|exact (yields_infinite _ _ _ Z' I)].
Qed.

Lemma reads_near x x' : reads x x' -> Rabs (value x' - value x) <= least.
Proof.
pose proof least_small. intros [->|(_ & L & s & ->)]; [rewrite Rminus_diag_eq, Rabs_R0 by reflexivity; lra|].
rewrite value_zero. unfold Rminus. rewrite Rplus_0_l, Rabs_Ropp. lra.
Qed.
Lemma sub_near p q z : sub floats (Plain p) (Plain q) z -> finite z \/ (finite p /\ finite q) ->
  exists r, outcome r z /\ Rabs (r - (value p - value q)) <= 2.
Proof.
intros (m & x & y & X & Y & Z)%sub_plain D. exists (value x - value y). assert (A : finite x /\ finite y).
{ destruct D as [D|[]]; [|eauto using finite_reads]. now apply (minus_finite m), (yields_finite _ _ _ Z). }
destruct A. split; [eauto using outcome_yields, outcome_sub|].
apply reads_near in X, Y. pose proof least_small. apply abs_le in X, Y. apply le_abs. lra.
Qed.
Lemma sub_distance p q z k : sub floats (Plain p) (Plain q) z -> mag z k -> fair k -> (1 <=? k)%Z = true ->
  finite p /\ finite q /\ Rabs (value p - value q) <= bpow radix2 (k + 2).
Proof.
intros S Z K L%Z.leb_le. destruct (sub_finite _ _ _ S (proj1 Z)) as [P Q]. split; [exact P|]. split; [exact Q|].
destruct (sub_near _ _ _ S (or_introl (proj1 Z))) as (r & O & N). pose proof (outcome_back _ _ _ O Z K) as B.
assert (2 <= bpow radix2 (k + 1)) by (change 2 with (bpow radix2 1); apply bpow_le; lia).
replace (k + 2)%Z with (1 + (k + 1))%Z by lia. rewrite bpow_plus. simpl (bpow radix2 1).
apply abs_le in N, B. apply le_abs. lra.
Qed.
Lemma distance_sub p q z k : sub floats (Plain p) (Plain q) z -> finite p -> finite q ->
  Rabs (value p - value q) <= bpow radix2 k -> (1 <=? k)%Z = true -> fair (k + 1) -> mag z (k + 1).
Proof.
intros S P Q L K%Z.leb_le F. destruct (sub_near _ _ _ S (or_intror (conj P Q))) as (r & O & N).
apply (outcome_mag _ _ _ O); [|exact F]. rewrite Z.add_comm, bpow_plus. simpl (bpow radix2 1).
assert (2 <= bpow radix2 k) by (change 2 with (bpow radix2 1); apply bpow_le; lia). apply abs_le in N, L.
apply le_abs. lra.
Qed.
Lemma great_sub p q z : sub floats (Plain p) (Plain q) z -> finite p -> finite q -> ~ great z -> value p - value q <= 4.
Proof.
intros S P Q N. destruct (sub_near _ _ _ S (or_intror (conj P Q))) as (r & O & D). apply abs_le in D.
apply Rnot_lt_le. intros L. apply N. assert (R1 : 1 <= r) by lra. pose proof (outcome_up _ _ O ltac:(lra)) as U.
destruct (finite_or z) as [F|F].
- left. split; [exact F|]. pose proof least_small.
  destruct O as (m & [(_ & _ & ->)|[(B & s & _ & _ & E)|(A & _)]]).
  + apply round_ge_generic; [apply _|apply _| |exact R1]. change 1 with (bpow radix2 0).
    apply generic_format_bpow. unfold fexp, FLT_exp. lia.
  + destruct (overflowed _ _ _ E F) as [T _]. apply up_value in U. rewrite Rabs_right in T by lra.
    assert (bpow radix2 0 <= bpow radix2 1023) by (apply bpow_le; lia). simpl (bpow radix2 0) in *. lra.
  + rewrite Rabs_right in A by lra. lra.
- right. destruct z as [|s| |]; try easy; [simpl in U; now subst|]. exfalso.
  destruct O as (m & [(_ & Z & _)|[(_ & s & _ & _ & E)|(_ & Z & _)]]); try discriminate.
  unfold binary_overflow in E. destruct (overflow_to_inf m s); discriminate.
Qed.

Theorem interval_mag c min max below above b more z0 b1 z1 x extent :
  sub floats (Plain min) (Plain c) below -> sub floats (Plain c) (Plain max) above -> greater floats above below b ->
  choose floats b above below more -> finite z0 -> value z0 = 0 -> greater floats z0 more b1 ->
  choose floats b1 z1 more x -> sub floats (Plain max) (Plain min) extent -> mag extent 700 -> mag x 700 ->
  mag below 704 /\ mag above 704.
Proof.
intros Lo Hi G C F0 V0 G1 C1 E ME MX.
destruct (sub_distance _ _ _ 700 E ME eq_refl eq_refl) as (Fmax & Fmin & De). apply abs_le in De.
change (700 + 2)%Z with 702%Z in *. assert (B : bpow radix2 703 = 2 * bpow radix2 702).
{ change 703%Z with (1 + 702)%Z. now rewrite bpow_plus. }
assert (S : 4 <= bpow radix2 702) by (change 4 with (bpow radix2 2); apply bpow_le; lia).
assert (T : finite c -> Rabs (value min - value c) <= bpow radix2 703 ->
  Rabs (value c - value max) <= bpow radix2 703 -> mag below 704 /\ mag above 704).
{ intros Fc X Y. split; [exact (distance_sub min c below 703 Lo Fmin Fc X eq_refl eq_refl)
  |exact (distance_sub c max above 703 Hi Fc Fmax Y eq_refl eq_refl)]. }
destruct b1.
- destruct (inside _ _ _ _ _ G C F0 V0 G1) as (N1 & N2 & D).
  pose proof (center_finite _ _ _ _ _ b Fmin Fmax Lo Hi N1 N2 D) as Fc.
  pose proof (great_sub _ _ _ Lo Fmin Fc N2). pose proof (great_sub _ _ _ Hi Fc Fmax N1).
  apply T; auto; apply le_abs; lra.
- assert (MM : mag more 700) by (apply (reads_back more x 700 C1 (reads_finite _ _ C1 (proj1 MX)) (proj2 MX)); lia).
  destruct b.
  + assert (MA : mag above 700) by (apply (reads_back above more 700 C (reads_finite _ _ C (proj1 MM)) (proj2 MM));
      lia).
    destruct (sub_distance _ _ _ 700 Hi MA eq_refl eq_refl) as (Fc & _ & D). change (700 + 2)%Z with 702%Z in *.
    apply abs_le in D. apply T; auto; apply le_abs; lra.
  + assert (MA : mag below 700) by (apply (reads_back below more 700 C (reads_finite _ _ C (proj1 MM)) (proj2 MM));
      lia).
    destruct (sub_distance _ _ _ 700 Lo MA eq_refl eq_refl) as (_ & Fc & D). change (700 + 2)%Z with 702%Z in *.
    apply abs_le in D. apply T; auto; apply le_abs; lra.
Qed.
(* for each axis *)
Ltac axis := match goal with
  | Lo : sub floats (Plain ?min) (Plain ?c) ?below, Hi : sub floats (Plain ?c) (Plain ?max) ?above,
    G : greater floats ?above ?below ?b, C : choose floats ?b ?above ?below ?more, S0 : constant floats 0 ?z0,
    G1 : greater floats ?z0 ?more ?b1, C1 : choose floats ?b1 ?z1 ?more ?x, E : sub floats (Plain ?max) (Plain ?min) ?e,
    ME : mag ?e ?i, MX : mag ?x ?j |- _ => lazymatch goal with _ : mag above _ |- _ => fail | _ => idtac end;
    destruct (interval_mag c min max below above b more z0 b1 z1 x e Lo Hi G C (proj1 S0) (proj2 S0) G1 C1 E
      (mag_up e i 700 ME ltac:(discriminate)) (mag_up x j 700 MX ltac:(discriminate))) end.

Theorem ball_and_box_2_binary64 (radius cx minx maxx cy miny maxy : float) answer : minx <= maxx -> miny <= maxy ->
  ball_and_box_2 binary64 float floats radius cx minx maxx cy miny maxy answer ->
  correct answer [radius; cx; minx; maxx; cy; miny; maxy] (radius * radius -
    (beyond cx minx maxx * beyond cx minx maxx + beyond cy miny maxy * beyond cy miny maxy)).
Proof.
intros X Y R. unfold ball_and_box_2 in R. float_guards R. axis. axis. split; [intros _; all_finite|].
apply ball_and_box_2_right with binary64; auto; [fits|unfold ball_and_box_2; repeat advance; exact R].
Qed.

Theorem ball_and_box_3_binary64 (radius cx minx maxx cy miny maxy cz minz maxz : float) answer :
  minx <= maxx -> miny <= maxy -> minz <= maxz ->
  ball_and_box_3 binary64 float floats radius cx minx maxx cy miny maxy cz minz maxz answer ->
  correct answer [radius; cx; minx; maxx; cy; miny; maxy; cz; minz; maxz] (radius * radius -
    (beyond cx minx maxx * beyond cx minx maxx + (beyond cy miny maxy * beyond cy miny maxy +
     beyond cz minz maxz * beyond cz minz maxz))).
Proof.
intros X Y Z R. unfold ball_and_box_3 in R. float_guards R. axis. axis. axis. split; [intros _; all_finite|].
apply ball_and_box_3_right with binary64; auto; [fits|unfold ball_and_box_3; repeat advance; exact R].
Qed.
