(* SPDX-License-Identifier: Apache-2.0 *)
(* beyond_interval and ball_and_box of sphere_box_filter.h. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Filters Require Import model constants filters steps ghost tactics squares.
Open Scope R_scope.

(* how far c is beyond min .. max *)
Definition beyond c min max := Rmax 0 (Rmax (min - c) (c - max)).

Section Beyond.
Variable F : format.
Hypothesis G : fits F (third F) 1 1.
Notation u := (u F). Notation n := (n F). Notation M := (reals F).

(* a difference has the wrong sign only where it is below n, and one of its numbers is read as zero *)
Lemma difference_sign p q z : p <= q -> (sub M (Plain p) (Plain q) z -> z <= 0 \/ z <= 3 * n /\ q - p < n) /\
  (sub M (Plain q) (Plain p) z -> 0 <= z \/ - (3 * n) <= z /\ q - p < n).
Proof.
intros L. pose proof (basics F (third F) 1 1 G) as B.
assert (S : forall r e h, Rabs e <= u -> Rabs h <= n -> - n < r < n -> - (3 * n) <= r * (1 + e) + h <= 3 * n).
{ intros r e h E%abs_le Hh%abs_le Hr. nra. }
split; intros (p' & q' & P & Q & (e & h & E & Hh & ->) & P1 & P2); destruct P as [->|[-> P%Rabs_def2]];
  destruct Q as [->|[-> Q%Rabs_def2]]; lazymatch goal with P1 : 0 <= ?r -> _ |- _ =>
    destruct (Rle_or_lt 0 r); destruct (Rle_or_lt r 0); auto; right; (split; [apply S; trivial|]; lra) end.
Qed.

(* rule (1) for what is beyond, and what the comparisons and choices read as zero: 2 n more *)
Theorem beyond_interval_near c min max below above b more b1 x : min <= max ->
  sub M (Plain min) (Plain c) below -> sub M (Plain c) (Plain max) above -> greater M above below b ->
  choose M b above below more -> greater M 0 more b1 -> choose M b1 0 more x ->
  exists e, Rabs e <= u /\ close F (third F) 0 5122 x (beyond c min max * (1 + e)).
Proof.
intros L S1 S2 (a' & b' & Ra & Rb & B) Rm (z & m' & Rz & Rm' & B1) Rx.
pose proof (basics F (third F) 1 1 G) as Bs.
destruct (difference_close F (third F) 1 1 G _ _ below _ S1 eq_refl) as (e1 & E1 & _ & N1).
destruct (difference_close F (third F) 1 1 G _ _ above _ S2 eq_refl) as (e2 & E2 & _ & N2).
assert (Z : z = 0) by (destruct Rz as [->|[-> _]]; reflexivity). clear Rz. subst z.
assert (N : forall s, Rabs s < n -> - n < s < n) by (intros s A%Rabs_def2; lra).
change (c_rounded 1 2048) with 3074%Z in *.
assert (K : q 3074 * (n * third F ^ 0) <= q 5122 * (n * third F ^ 0) - 2 * n /\ 5 * n <= q 5122 * (n * third F ^ 0)).
{ unfold q. simpl. lra. }
assert (close_k : forall e,
  - (q 5122 * (n * third F ^ 0)) <= x - beyond c min max * (1 + e) <= q 5122 * (n * third F ^ 0) ->
  close F (third F) 0 5122 x (beyond c min max * (1 + e))) by (intros; split; [lia|now apply le_abs]).
apply abs_le in N1, N2. set (k := q 5122 * (n * third F ^ 0)) in *. clearbody k.
set (k1 := q 3074 * (n * third F ^ 0)) in *. clearbody k1.
assert (T : forall d e, 0 <= d -> Rabs e <= u -> 0 <= d * (1 + e) <= d + d / 16) by (intros d e Hd E%abs_le; nra).
(* what the comparisons say of the differences themselves *)
assert (Q : b = true /\ (above > below \/ - n < below < n /\ above > 0 \/ - n < above < n /\ below < 0) \/
  b = false /\ (above <= below \/ - n < below < n /\ above <= 0 \/ - n < above < n /\ 0 <= below \/
    - n < below < n /\ - n < above < n)).
{ clear - B Ra Rb N Bs. destruct b; [left|right]; (split; [reflexivity|]).
  - apply proj1 in B. specialize (B eq_refl). destruct Ra as [->|[-> A%N]], Rb as [->|[-> A'%N]]; lra.
  - assert (a' <= b') by (apply Rnot_lt_le; intros Y; apply B in Y; discriminate).
    destruct Ra as [->|[-> A%N]], Rb as [->|[-> A'%N]]; lra. }
assert (Q1 : (x = more \/ x = 0 /\ - n < more < n) /\ more > - n \/ x = 0 /\ more < 0).
{ clear - B1 Rm' Rx N Bs. destruct b1.
  - right. apply proj1 in B1. specialize (B1 eq_refl).
    split; [destruct Rx as [->|[-> _]]; reflexivity|destruct Rm' as [->|[-> A%N]]; lra].
  - left. assert (0 <= m') by (apply Rnot_lt_le; intros Y; apply B1 in Y; discriminate).
    split; [|destruct Rm' as [->|[-> A%N]]; lra]. destruct Rx as [->|[-> A%N]]; auto. }
assert (Q2 : more = (if b then above else below) \/ more = 0 /\ - n < (if b then above else below) < n).
{ clear - Rm N. destruct Rm as [->|[-> A%N]]; auto. }
clear B B1 Ra Rb Rm Rm' Rx N.
destruct (Rle_or_lt c min) as [C|C]; [|destruct (Rle_or_lt max c) as [D|D]].
- exists e1. split; [exact E1|]. apply close_k. clear close_k.
  replace (beyond c min max) with (min - c) by (unfold beyond, Rmax; repeat destruct Rle_dec; lra).
  assert (S1' : 0 <= below \/ - (3 * n) <= below /\ min - c < n) by (apply (difference_sign c min); assumption).
  assert (S2' : above <= 0 \/ above <= 3 * n /\ max - c < n) by (apply (difference_sign c max); [lra|assumption]).
  specialize (T (min - c) e1 ltac:(lra) E1). set (t := (min - c) * (1 + e1)) in *. clearbody t. clear S1 S2 E1 E2 N2.
  destruct Q as [[-> Q]|[-> Q]]; repeat match goal with H : _ \/ _ |- _ => destruct H end; lra.
- exists e2. split; [exact E2|]. apply close_k. clear close_k.
  replace (beyond c min max) with (c - max) by (unfold beyond, Rmax; repeat destruct Rle_dec; lra).
  assert (S1' : below <= 0 \/ below <= 3 * n /\ c - min < n) by (apply (difference_sign min c); [lra|assumption]).
  assert (S2' : 0 <= above \/ - (3 * n) <= above /\ c - max < n) by (apply (difference_sign max c); [lra|assumption]).
  specialize (T (c - max) e2 ltac:(lra) E2). set (t := (c - max) * (1 + e2)) in *. clearbody t. clear S1 S2 E1 E2 N1.
  destruct Q as [[-> Q]|[-> Q]]; repeat match goal with H : _ \/ _ |- _ => destruct H end; lra.
- exists e1. split; [exact E1|]. apply close_k. clear close_k.
  replace (beyond c min max) with 0 by (unfold beyond, Rmax; repeat destruct Rle_dec; lra).
  assert (S1' : below <= 0 \/ below <= 3 * n /\ c - min < n) by (apply (difference_sign min c); [lra|assumption]).
  assert (S2' : above <= 0 \/ above <= 3 * n /\ max - c < n) by (apply (difference_sign c max); [lra|assumption]).
  clear S1 S2 E1 E2 N1 N2 T.
  destruct Q as [[-> Q]|[-> Q]]; repeat match goal with H : _ \/ _ |- _ => destruct H end; lra.
Qed.
End Beyond.

Ltac axis G L := match goal with
  | S1 : sub (reals ?F) (Plain ?min) (Plain ?c) ?below, S2 : sub (reals ?F) (Plain ?c) (Plain ?max) ?above,
    S3 : greater (reals ?F) ?above ?below ?b, S4 : choose (reals ?F) ?b ?above ?below ?more,
    S5 : greater (reals ?F) 0 ?more ?b1, S6 : choose (reals ?F) ?b1 0 ?more ?x |- _ =>
    lazymatch type of L with min <= max =>
    let e := fresh "e" in let E := fresh "E" in let N := fresh "N" in
    destruct (beyond_interval_near F G c min max below above b more b1 x L S1 S2 S3 S4 S5 S6) as (e & E & N);
    clear S1 S2 S3 S4 S5 S6 end end.

Lemma ball_and_box_enough u : 0 < u <= 1/1024 -> enough_squares u 1 5 (3 * u + 3 * u ^ 2) (relative 6 18 u).
Proof. prove_enough. Qed.
Lemma ball_and_box_2_enough u : 0 < u <= 1/1024 -> enough_squares u 1 4 (3 * u + 3 * u ^ 2) (relative 6 18 u).
Proof. prove_enough. Qed.

Theorem ball_and_box_2_right F radius cx minx maxx cy miny maxy answer : fits F (third F) 1 1 ->
  minx <= maxx -> miny <= maxy -> ball_and_box_2 F R (reals F) radius cx minx maxx cy miny maxy answer ->
  let exact := radius * radius -
    (beyond cx minx maxx * beyond cx minx maxx + beyond cy miny maxy * beyond cy miny maxy) in
  (answer = positive -> exact > 0) /\ (answer = negative -> exact < 0).
Proof.
intros G X Y R exact. unfold ball_and_box_2 in R. unpack. constants. axis G X. axis G Y. flags R.
squares_nonneg. squared_guard G. square_parts G. normal G 6 18 4%Z. inputs G radius. steps G.
assert (Hf : 0 < u F <= 1/1024) by (destruct G; lra).
compare_squares G 64%Z (3 * u F + 3 * u F ^ 2) (ball_and_box_2_enough (u F) Hf) Pos Neg P' Q' W1 W2.
unfold exact. signs R Pos Neg P' Q' W1 W2.
Qed.

Theorem ball_and_box_3_right F radius cx minx maxx cy miny maxy cz minz maxz answer : fits F (third F) 1 1 ->
  minx <= maxx -> miny <= maxy -> minz <= maxz ->
  ball_and_box_3 F R (reals F) radius cx minx maxx cy miny maxy cz minz maxz answer ->
  let exact := radius * radius - (beyond cx minx maxx * beyond cx minx maxx +
    (beyond cy miny maxy * beyond cy miny maxy + beyond cz minz maxz * beyond cz minz maxz)) in
  (answer = positive -> exact > 0) /\ (answer = negative -> exact < 0).
Proof.
intros G X Y Z R exact. unfold ball_and_box_3 in R. unpack. constants. axis G X. axis G Y. axis G Z. flags R.
squares_nonneg. squared_guard G. square_parts G. normal G 6 18 4%Z. inputs G radius. steps G.
assert (Hf : 0 < u F <= 1/1024) by (destruct G; lra).
compare_squares G 64%Z (3 * u F + 3 * u F ^ 2) (ball_and_box_enough (u F) Hf) Pos Neg P' Q' W1 W2.
unfold exact. signs R Pos Neg P' Q' W1 W2.
Qed.
