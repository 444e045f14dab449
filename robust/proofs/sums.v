(* SPDX-License-Identifier: Apache-2.0 *)
(* Sum of enclosed.h. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Filters Require Import arithmetic enclosed nearest enclosures.
Open Scope R_scope.

Section Sums.
Variable choice : Z -> bool.
Hypothesis symmetric : forall x, choice x = negb (choice (- (x + 1))).
Notation rnd := (nearest choice).
Notation term := (term choice (29 / 4)).

(* M is the sum of magnitudes of n heads, w what a tail may be beyond its bound. *)
Definition holds s X M n w := exists h z, exactly (sum_high s) h /\ sum_size s = Plain z /\ sum_terms s = n /\
  sound choice (sum_low s) /\ (1 <= n)%Z /\ 0 <= M /\ 0 <= w /\
  let N := IZR n in
  Rabs h <= M + 2 * u * (N * M) /\ M - 2 * u * (N * M) <= z /\
  forall l, seen (sum_low s) l -> Rabs l <= (2 + / 2 ^ 14) * T * M + 2 * u * (N * M) + w + / 2 ^ 20 * (N * w) /\
    Rabs (X - (h + l)) <= (2 + / 2 ^ 12) * E * (N * M) + 8 * E * M + 4 * u * (N * w) + u * w.

Lemma first_holds t X s w : 0 <= w -> sum_first t s -> (exists h, exactly (term2_head t) h /\
  sound choice (term2_tail t) /\ forall l, seen (term2_tail t) l ->
    Rabs (X - (h + l)) <= 29 / 4 * E * Rabs h + 5 * u * w /\
    Rabs l <= (2 + / 2 ^ 16) * T * Rabs h + (1 + / 2 ^ 20) * w) -> exists M, holds s X M 1 w.
Proof.
intros W -> (h & Hh & Ht & B). exists (Rabs h), h, (Rabs h). destruct (size h) as [P _]. cbn -[pow].
unfold magnitude. rewrite (exactly_value _ _ Hh).
repeat (split; [assumption || reflexivity || lia|]). cbv zeta. split; [numbers|]. split; [numbers|].
intros l L. destruct (B l L). split; numbers.
Qed.

Lemma plus_holds s X M n w t Z s' : holds s X M n w -> (n < 4096)%Z -> term t Z -> sum_plus rnd s t s' ->
  exists M', holds s' (X + Z) M' (n + 1) w.
Proof.
intros (h & z & Hh & Hz & Hn & Sl & N1 & M0 & W0 & Bh & Bz & Bl) N2 (d & Hd & St & Bt) R.
destruct R as (p & R & t1 & (x1 & x2 & S1 & S2 & ->) & t2 & (l & x4 & S3 & S4 & ->) & t3 &
  (x5 & x6 & S5 & S6 & ->) & ->).
destruct (two_sum_right choice symmetric _ _ _ _ _ Hh Hd R) as (k & q & -> & Hk & Dk & Exact).
rewrite Hz, Hn in *. cbn [pair_low pair_high] in *. unfold magnitude in S6. rewrite (exactly_value _ _ Hd) in S6.
cbn [seen] in S1, S4, S5, S6. subst x1 x4 x5 x6.
destruct (Bl _ S3) as [Bl1 Bl2], (Bt _ S2) as [Bt1 Bt2]. clear Bl Bt.
exists (M + Rabs d), k, (rnd (z + Rabs d)). cbn -[pow].
assert (N1' : 1 <= IZR n) by now apply IZR_le. assert (N2' : IZR n <= 4095) by (apply IZR_le; lia).
set (N := IZR n) in *. destruct (size d) as [P0 _]. set (D := Rabs d) in *.
assert (A1 : 0 <= N * M <= 4095 * M /\ M <= N * M) by (split; [split|]; nra).
assert (A2 : 0 <= N * D <= 4095 * D /\ D <= N * D) by (split; [split|]; nra).
assert (A3 : 0 <= N * w <= 4095 * w /\ w <= N * w) by (split; [split|]; nra).
assert (DD : Rabs d <= D) by (unfold D; lra). clearbody D.
rewrite plus_IZR. fold N. replace ((N + 1) * (M + D)) with (N * M + N * D + M + D) by ring.
replace ((N + 1) * w) with (N * w + w) by ring. clearbody N. set (NM := N * M) in *. set (ND := N * D) in *.
set (NW := N * w) in *. clearbody NM ND NW.
assert (Bhd : Rabs (h + d) <= M + 2 * u * NM + D) by (bounds; apply le_abs; lra).
pose proof (near choice _ _ Bhd) as Nk. rewrite <- Hk in Nk.
assert (B1 : Rabs (q + x2) <= (1 + / 2 ^ 39) * u * (M + D) + (2 + / 2 ^ 16) * T * D) by (bounds; apply le_abs; numbers).
pose proof (near choice _ _ B1) as Ni. set (i := rnd (q + x2)) in *. clearbody i.
assert (B2 : Rabs (l + i) <= (2 + / 2 ^ 14) * T * M + 2 * u * NM + w + / 2 ^ 20 * NW + (1 + / 2 ^ 38) * u * (M + D) +
  (2 + / 2 ^ 15) * T * D) by (bounds; apply le_abs; numbers).
pose proof (near choice _ _ B2) as N3. set (low := rnd (l + i)) in *.
split; [apply exactly_plain; rewrite Hk; apply nearest_digits|]. split; [reflexivity|].
split; [reflexivity|]. split; [easy|]. split; [lia|]. split; [lra|]. split; [exact W0|].
clear Sl St Hh Hd R S2 S3.
split; [bounds; apply le_abs; numbers|]. split.
- destruct (near_pos choice (z + D)); numbers.
- intros x ->. split; [bounds; apply le_abs; numbers|].
  replace (X + Z - (k + low)) with ((X - (h + l)) + (Z - (d + x2)) - (i - (q + x2)) - (low - (l + i))) by lra.
  bounds; apply le_abs; numbers.
Qed.

(* s is what the text makes of n terms whose sum is X. *)
Inductive sum_of : sum -> R -> Z -> Prop :=
| one t X s : term t X -> sum_first t s -> sum_of s X 1
| more s X n t Z s' : sum_of s X n -> term t Z -> sum_plus rnd s t s' -> sum_of s' (X + Z) (n + 1)
| less s X n t Z s' : sum_of s X n -> term t Z -> sum_minus rnd s t s' -> sum_of s' (X - Z) (n + 1)
| number s X n p z s' : sum_of s X n -> exactly p z -> sum_plus_number rnd s p s' -> sum_of s' (X + z) (n + 1).

Lemma negated_term_right a t Z t' : enclosures.term choice a t Z -> negated_term t t' ->
  enclosures.term choice a t' (- Z).
Proof.
intros (h & Hh & St & B) ->. exists (- h). cbn -[pow]. split; [now apply exactly_negated|].
split; [now apply sound_negated|]. intros l L. destruct (B _ (seen_negated _ _ L)) as [B1 B2].
rewrite (Rabs_Ropp h), <- (Rabs_Ropp l). split; [|exact B2].
replace (- Z - (- h + l)) with (- (Z - (h + - l))) by ring. now rewrite Rabs_Ropp.
Qed.
Lemma number_term p z : exactly p z -> term (Term2 p (Plain 0)) z.
Proof.
intros X. exists z. cbn -[pow]. split; [exact X|]. split; [easy|]. intros t ->. destruct (size z) as [P _].
replace (z - (z + 0)) with 0 by ring. rewrite Rabs_R0. split; numbers.
Qed.

Lemma sum_of_terms s X n : sum_of s X n -> (1 <= n)%Z.
Proof. induction 1; lia. Qed.
Lemma sum_of_holds s X n : sum_of s X n -> (n <= 4096)%Z -> exists M, holds s X M n 0.
Proof.
induction 1 as [t X s Ht F|s X n t Z s' H IH Ht P|s X n t Z s' H IH Ht P|s X n p z s' H IH Ht P]; intros L.
- apply (first_holds t X s 0 ltac:(lra) F). destruct Ht as (h & Hh & St & B). exists h. split; [exact Hh|].
  split; [exact St|]. intros l S. destruct (B l S). lra.
- destruct IH as [M M']; [lia|]. now apply (plus_holds s X M n 0 t Z); [|lia| |].
- destruct IH as [M M']; [lia|]. destruct P as (t' & Nt & x & P & ->).
  now apply (plus_holds s X M n 0 t' (- Z)); [|lia|apply negated_term_right with t|].
- destruct IH as [M M']; [lia|]. destruct P as (x & P & ->).
  now apply (plus_holds s X M n 0 (Term2 p (Plain 0)) z); [|lia|apply number_term|].
Qed.

Lemma value_holds s X M n w r : holds s X M n w -> (n < 4096)%Z -> sum_value rnd s r ->
  exists h, exactly (enclosed_high r) h /\ sound choice (enclosed_low r) /\ sound choice (enclosed_error r) /\
    forall l e, seen (enclosed_low r) l -> seen (enclosed_error r) e ->
      0 <= e /\ Rabs (X - (h + l)) <= (1 - / 2 ^ 20) * e + 4 * u * (IZR n * w) + u * w.
Proof.
intros (h & z & Hh & Hz & Hn & Sl & N1 & M0 & W0 & Bh & Bz & Bl) L (t & -> & ->). exists h.
cbn [enclosed_high enclosed_low enclosed_error].
split; [exact Hh|]. split; [exact Sl|]. split; [easy|]. intros l e Sl' Se. destruct (Bl l Sl') as [_ B].
rewrite Hz, Hn in Se. cbn [seen value] in Se. names (2 * n + 12)%Z Se.
assert (N1' : 1 <= IZR n) by now apply IZR_le. assert (N2' : IZR n <= 4095) by (apply IZR_le; lia).
replace (IZR (2 * n + 12)) with (2 * IZR n + 12) in Se by (rewrite plus_IZR, mult_IZR; ring).
set (N := IZR n) in *. clearbody N.
assert (A1 : 0 <= N * M <= 4095 * M) by (split; nra).
assert (Z1 : (1 - / 2 ^ 40) * M <= z) by numbers.
assert (Z0 : 0 <= z) by numbers.
assert (Z2 : 2 * ((1 - / 2 ^ 40) * (N * M)) + 12 * ((1 - / 2 ^ 40) * M) <= (2 * N + 12) * z).
{ apply Rle_trans with ((2 * N + 12) * ((1 - / 2 ^ 40) * M)); [right; ring|apply Rmult_le_compat_l; lra]. }
assert (P : 0 <= cut * (2 * N + 12) * z) by (repeat apply Rmult_le_pos; numbers).
assert (V : (1 - u) * (cut * (2 * N + 12) * z) <= e).
{ destruct Se as [-> | ->]; [apply (near_pos choice _ P)|]. clear - P. numbers. }
replace (cut * (2 * N + 12) * z) with (cut * ((2 * N + 12) * z)) in V, P by ring.
set (NZ := (2 * N + 12) * z) in *. set (NM := N * M) in *. set (NW := N * w) in *. clearbody NZ NM NW.
clear Se Bl Bh. split; [numbers|]. apply Rle_trans with (1 := B). clear B. numbers.
Qed.
Theorem sum_right s X n r : sum_of s X n -> (n < 4096)%Z -> sum_value rnd s r -> encloses choice r X.
Proof.
intros S L V. destruct (sum_of_holds s X n S) as [M H]; [lia|].
destruct (value_holds s X M n 0 r H L V) as (h & Hh & Sl & Se & B). exists h. repeat (split; [assumption|]).
intros l e L1 L2. destruct (B l e L1 L2). numbers.
Qed.
End Sums.
