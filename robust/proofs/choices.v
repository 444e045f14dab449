(* SPDX-License-Identifier: Apache-2.0 *)
(* Least and greatest of several numbers, by comparisons that may read a number below n as zero. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Filters Require Import model steps ghost.
Open Scope R_scope.

Section Choices.
Variable F : format.
Hypothesis n_low : 0 < n F.
Notation n := (n F). Notation M := (reals F). Notation read := (read F).

(* at most x, or nobody can tell *)
Definition below d x := d <= x \/ (Rabs d < n /\ Rabs x < n).

Lemma abs_lt x a : Rabs x < a <-> - a < x < a.
Proof. split; intros L; [now apply Rabs_def2 in L|apply Rabs_def1; lra]. Qed.
Lemma below_refl x : below x x.
Proof. left. lra. Qed.
Lemma below_trans x y z : below x y -> below y z -> below x z.
Proof.
unfold below. rewrite !abs_lt.
intros [A|[A A']] [B|[B B']]; try (left; lra); try (right; lra).
- destruct (Rlt_or_le (- n) x); [right|left]; lra.
- destruct (Rlt_or_le z n); [right|left]; lra.
Qed.
Lemma read_trans x y z : read x y -> read y z -> read x z.
Proof. intros [->|[-> L]] [->|[-> L']]; unfold model.read; auto. Qed.
Lemma read_refl x : read x x.
Proof. now left. Qed.
Lemma read_below x z : read x z -> below z x /\ below x z.
Proof. unfold below. rewrite !abs_lt. intros [->|[-> L%abs_lt]]; split; try (left; lra); right; lra. Qed.

(* b ? x : y where b is x < y *)
Lemma lesser_right x y b z : greater M y x b -> choose M b x y z ->
  below z x /\ below z y /\ (read x z \/ read y z).
Proof.
intros (y' & x' & Ry & Rx & B) K. simpl in K. destruct b.
- assert (L : y' > x') by now apply B. apply read_below in K as K'. repeat split; auto; [apply K'|].
  apply below_trans with (1 := proj1 K'). unfold below. rewrite !abs_lt.
  destruct Rx as [->|[-> Rx%abs_lt]], Ry as [->|[-> Ry%abs_lt]]; try (left; lra).
  + destruct (Rlt_or_le (- n) x); [right|left]; lra.
  + destruct (Rlt_or_le y n); [right|left]; lra.
- assert (L : y' <= x') by (apply Rnot_gt_le; intros N; apply B in N; discriminate).
  apply read_below in K as K'. repeat split; auto; [|apply K'].
  apply below_trans with (1 := proj1 K'). unfold below. rewrite !abs_lt.
  destruct Rx as [->|[-> Rx%abs_lt]], Ry as [->|[-> Ry%abs_lt]]; try (left; lra); try (right; lra).
  + destruct (Rlt_or_le x n); [right|left]; lra.
  + destruct (Rlt_or_le (- n) y); [right|left]; lra.
Qed.
(* b ? x : y where b is x > y *)
Lemma greater_right x y b z : greater M x y b -> choose M b x y z ->
  below x z /\ below y z /\ (read x z \/ read y z).
Proof.
intros (x' & y' & Rx & Ry & B) K. simpl in K. destruct b.
- assert (L : x' > y') by now apply B. apply read_below in K as K'. repeat split; auto; [apply K'|].
  apply below_trans with (2 := proj2 K'). unfold below. rewrite !abs_lt.
  destruct Rx as [->|[-> Rx%abs_lt]], Ry as [->|[-> Ry%abs_lt]]; try (left; lra).
  + destruct (Rlt_or_le x n); [right|left]; lra.
  + destruct (Rlt_or_le (- n) y); [right|left]; lra.
- assert (L : x' <= y') by (apply Rnot_gt_le; intros N; apply B in N; discriminate).
  apply read_below in K as K'. repeat split; auto; [|apply K'].
  apply below_trans with (2 := proj2 K'). unfold below. rewrite !abs_lt.
  destruct Rx as [->|[-> Rx%abs_lt]], Ry as [->|[-> Ry%abs_lt]]; try (left; lra); try (right; lra).
  + destruct (Rlt_or_le (- n) x); [right|left]; lra.
  + destruct (Rlt_or_le y n); [right|left]; lra.
Qed.
Lemma read_nonneg x z : read x z -> 0 <= x -> 0 <= z.
Proof. intros [->|[-> _]]; lra. Qed.

(* Where all operations read alike, a choice is the least of what they read. *)
Variable zeros : bool.
Notation M1 := (one_mode F zeros). Notation seen := (seen F zeros).
Lemma seen_read x : read x (seen x).
Proof. unfold model.seen, model.read. destruct zeros; [|auto]. destruct (Rlt_dec (Rabs x) n); auto. Qed.
Lemma seen_mono x y : x <= y -> seen x <= seen y.
Proof.
unfold model.seen. destruct zeros; [|easy]. intros L.
destruct (Rlt_dec (Rabs x) n) as [X|X], (Rlt_dec (Rabs y) n) as [Y|Y]; rewrite abs_lt in X, Y; lra.
Qed.
Lemma seen_seen x : seen (seen x) = seen x.
Proof.
unfold model.seen. destruct zeros; [|easy]. destruct (Rlt_dec (Rabs x) n) as [X|X].
- destruct (Rlt_dec (Rabs 0) n); easy.
- now destruct (Rlt_dec (Rabs x) n).
Qed.
Lemma seen_zero : seen 0 = 0.
Proof. unfold model.seen. destruct zeros; [|easy]. now destruct (Rlt_dec (Rabs 0) n). Qed.
Lemma seen_positive x : seen x > 0 -> x > 0.
Proof. intros S. apply Rnot_le_gt. intros L%seen_mono. rewrite seen_zero in L. lra. Qed.
Lemma lesser_seen x y b z : greater M1 y x b -> choose M1 b x y z -> seen z <= seen x /\ seen z <= seen y.
Proof.
simpl. intros B K. assert (E : seen z = seen (if b then x else y))
  by (destruct K as [->| ->]; rewrite ?seen_seen; easy).
rewrite E. destruct b.
- assert (seen y > seen x) by now apply B. lra.
- assert (~ seen y > seen x) by (intros N; apply B in N; discriminate). lra.
Qed.
Lemma seen_of_uses p x : seen_of F zeros p x -> uses F p x.
Proof.
destruct p as [y|a b t]; simpl.
- intros ->. apply seen_read.
- intros [->| ->]; [left; apply seen_read|right]. eauto using seen_read.
Qed.
(* one way to read is among all *)
Lemma mul_in x y z : mul M1 x y z -> mul M x y z.
Proof. simpl. eauto 6 using seen_read. Qed.
Lemma add_in p q z : add M1 p q z -> add M p q z.
Proof. intros (x & y & X & Y & Z). exists x, y. auto using seen_of_uses. Qed.
Lemma sub_in p q z : sub M1 p q z -> sub M p q z.
Proof. intros (x & y & X & Y & Z). exists x, y. auto using seen_of_uses. Qed.
Lemma greater_in x y b : greater M1 x y b -> greater M x y b.
Proof. simpl. eauto 6 using seen_read. Qed.
Lemma at_most_in x y b : at_most M1 x y b -> at_most M x y b.
Proof. simpl. eauto 6 using seen_read. Qed.
Lemma keep_in b x y z : choose M1 b x y z -> choose M b x y z.
Proof. simpl. intros [->| ->]; auto using seen_read, read_refl. Qed.
End Choices.

Section Greatest.
Variable F : format.
Hypothesis G : fits F (third F) 1 1.
Notation n := (n F). Notation small := (small (third F) 1). Notation close := (close F (third F)).
Lemma below_small o g m : (1 <= m)%Z -> below F o g -> 0 <= o -> small m g -> small m o.
Proof.
intros M1 B P [M0 L]. split; [exact M0|]. rewrite Rabs_right by lra. destruct B as [B|[B _]].
- apply Rle_trans with (1 := B), Rle_trans with (2 := L), Rle_abs.
- rewrite Rabs_right in B by lra. apply Rle_trans with n; [lra|]. destruct G. apply IZR_le in M1. unfold q. simpl. nra.
Qed.
(* the ghost of the greatest sum of magnitudes, g, is not below one of them, o *)
Lemma below_low o o0 g c j T : below F o g -> 0 <= o -> 0 <= g -> close 0 c o o0 -> low (u F) j o0 T ->
  exists g0, close 0 (c + 1024) g g0 /\ low (u F) j g0 T.
Proof.
intros B P P' [C N] [T0 L]. assert (Q : q c * (n * third F ^ 0) + n = q (c + 1024) * (n * third F ^ 0))
  by (rewrite q_plus, q_one; simpl; ring). assert (N0 : 0 < n) by apply G.
destruct B as [B|[B _]].
- exists (o0 + (g - o)). split; [split; [lia|]|split; lra]. replace (g - (o0 + (g - o))) with (o - o0) by ring. lra.
- exists (o0 + g). split; [split; [lia|]|split; lra]. replace (g - (o0 + g)) with (- o0) by ring. rewrite Rabs_Ropp.
  rewrite Rabs_right in B by lra. apply abs_le in N. apply le_abs. lra.
Qed.
(* the ghost of what is kept, d, is not above that of x *)
Lemma below_close c d x x0 : below F d x -> close 1 c x x0 -> exists d0, close 1 (c + 2048) d d0 /\ d0 <= x0.
Proof.
intros B [C L]. assert (N0 : 0 < n) by apply G. pose proof (n_pow F (third F) 1 1 G 1) as N1.
assert (Q : q (c + 2048) = q c + 2) by (rewrite q_plus; unfold q; lra).
destruct B as [B|[B B']].
- exists (d - (x - x0)). apply abs_le in L as L'. split; [|lra]. split; [lia|].
  replace (d - (d - (x - x0))) with (x - x0) by ring. rewrite Q. lra.
- exists x0. split; [|lra]. split; [lia|]. replace (d - x0) with ((d - x) + (x - x0)) by ring.
  rewrite Q. apply Rle_trans with (1 := Rabs_triang _ _).
  apply abs_lt in B, B'. assert (Rabs (d - x) <= 2 * n) by (apply le_abs; lra). lra.
Qed.
(* a multiple of A that is itself computed *)
Lemma two_roundings k a e e' : Rabs e <= u F -> Rabs e' <= u F -> 0 <= k * a ->
  15 / 16 * (k * a) <= k * a * (1 + e) * (1 + e').
Proof.
intros E%abs_le E'%abs_le P. destruct G as [U0 U _ _ _ _ _ _]. rewrite Rmult_assoc, (Rmult_comm _ (k * a)).
apply Rmult_le_compat_l; [exact P|]. apply Rle_trans with ((1 - 1 / 1024) * (1 - 1 / 1024)); [lra|].
apply Rmult_le_compat; lra.
Qed.
(* a number beyond a bound *)
Lemma beyond_bound cV cB V V0 B B0 X : close 1 cV V V0 -> close 1 cB B B0 -> 0 <= X ->
  X + q (cV + cB + 1024) * (n * third F) <= B0 -> greater (reals F) V B true -> V0 > X.
Proof.
intros [P C] [P' C'] X0 L (V' & B' & RV & RB & K). pose proof (basics F (third F) 1 1 G).
rewrite !q_plus, q_one in L. simpl in C, C'. rewrite Rmult_1_r in C, C'. set (N := n * third F) in *.
assert (n <= N) by (unfold N; nra). assert (0 <= q cV * N) by (pose proof (q_nonneg _ P); apply Rmult_le_pos; lra).
apply abs_le in C, C'. assert (K' : V' > B') by now apply K.
assert (B' = B) as -> by (destruct RB as [->|[_ RB%Rabs_def2]]; [easy|lra]).
assert (V' = V) as -> by (destruct RV as [->|[-> _]]; [easy|lra]). lra.
Qed.
End Greatest.
