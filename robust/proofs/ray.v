(* SPDX-License-Identifier: Apache-2.0 *)
(* ray of filters.h. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Filters Require Import model constants filters steps ghost tactics segments.
Open Scope R_scope.

Section Wrong.
Variable u : R.
Hypothesis Hu : 0 < u <= 1/1024.

Lemma sizes p : Rabs p = p /\ 0 <= p \/ Rabs p = - p /\ p <= 0.
Proof. destruct (Rle_or_lt 0 p); [left; rewrite Rabs_right|right; rewrite Rabs_left]; lra. Qed.
Lemma around x e : Rabs e <= u -> Rabs x * (1 - u) <= Rabs (x * (1 + e)) <= Rabs x * (1 + u).
Proof. intros E. pose proof (near _ _ _ (rounding u x e E)). lra. Qed.
Lemma powers_times T : 0 <= T -> 0 <= u * T /\ 0 <= u ^ 2 * T <= 1/1024 * (u * T) /\
  0 <= u ^ 3 * T <= 1/1024 * (u ^ 2 * T) /\ 0 <= u ^ 4 * T <= 1/1024 * (u ^ 3 * T).
Proof.
intros P. fine_powers u Hu.
repeat split; try (apply Rmult_le_pos; lra); rewrite <- Rmult_assoc; apply Rmult_le_compat_r; lra.
Qed.
(* a rounding neither turns a sign nor adds more than u *)
Lemma at_most_rounded x e W : Rabs e <= u -> 0 <= W -> x <= W -> x * (1 + e) <= (1 + u) * W.
Proof. intros E%abs_le P L. destruct (Rle_or_lt 0 x); nra. Qed.

(* One and two, of which the smaller decides: o is at most W1 off where its sign is wrong, and at most B1 at all; t
   likewise. *)
Section Smaller.
Variables o t W1 B1 W2 B2 K e1 e2 : R.
Hypothesis E1 : Rabs e1 <= u.
Hypothesis E2 : Rabs e2 <= u.
Hypothesis P : 0 <= W1 /\ 0 <= B1 /\ 0 <= W2 /\ 0 <= B2.
Hypothesis K1 : 2 * W1 + 2 * u * (W1 + B2) <= K.
Hypothesis K2 : 2 * W2 + 2 * u * (W2 + B1) <= K.

Lemma smaller_rounded : Rabs (Rabs ((o - t) * (1 + e1)) - (o + t) * (1 + e2) - (Rabs (o - t) - (o + t))) <=
  u * (Rabs (o - t) + Rabs (o + t)).
Proof.
pose proof (around (o - t) e1 E1). pose proof (rounding u (o + t) e2 E2) as A. apply abs_le in A. apply le_abs. lra.
Qed.
Lemma not_positive : o <= B1 -> t <= B2 -> - o <= W1 -> - t <= W2 ->
  Rabs ((o - t) * (1 + e1)) - (o + t) * (1 + e2) <= K.
Proof.
intros. pose proof smaller_rounded as A. apply abs_le in A.
assert (u * o <= u * B1 /\ u * t <= u * B2 /\ u * - o <= u * W1 /\ u * - t <= u * W2)
  by (repeat split; apply Rmult_le_compat_l; lra).
assert (0 <= u * W1 /\ 0 <= u * W2 /\ 0 <= u * B1 /\ 0 <= u * B2) by (repeat split; apply Rmult_le_pos; lra).
destruct (sizes (o - t)) as [[S ?]|[S ?]], (sizes (o + t)) as [[T ?]|[T ?]]; rewrite S, T in A; clear S T; lra.
Qed.
Lemma not_negative : o <= B1 -> t <= B2 -> o <= W1 \/ t <= W2 ->
  (o + t) * (1 + e2) - Rabs ((o - t) * (1 + e1)) <= K.
Proof.
intros X Y D. pose proof smaller_rounded as A. apply abs_le in A.
assert (u * o <= u * B1 /\ u * t <= u * B2) by (split; apply Rmult_le_compat_l; lra).
assert (0 <= u * W1 /\ 0 <= u * W2 /\ 0 <= u * B1 /\ 0 <= u * B2) by (repeat split; apply Rmult_le_pos; lra).
assert (NEG : forall x, x <= 0 -> 2 * x - 2 * u * x <= 0) by (intros; nra).
destruct D as [D|D].
- assert (u * o <= u * W1) by (apply Rmult_le_compat_l; lra).
  destruct (sizes (o - t)) as [[S ?]|[S ?]], (sizes (o + t)) as [[T ?]|[T ?]]; rewrite S, T in A; clear S T;
    first [lra|pose proof (NEG t); lra|pose proof (NEG o); lra].
- assert (u * t <= u * W2) by (apply Rmult_le_compat_l; lra).
  destruct (sizes (o - t)) as [[S ?]|[S ?]], (sizes (o + t)) as [[T ?]|[T ?]]; rewrite S, T in A; clear S T;
    first [lra|pose proof (NEG t); lra|pose proof (NEG o); lra].
Qed.
End Smaller.

(* one: of vs and vf as computed; a and b: the sums of the magnitudes of their exact terms *)
Lemma off_three x t T : off u 3 x t T -> 0 <= T /\ Rabs t <= T /\ Rabs (x - t) <= (3 * u + 4 * u ^ 2) * T.
Proof. apply off_by. fine_powers u Hu. lra. Qed.
Lemma one_wrong vs0 vf0 vs vf a b e1 e2 e3 : off u 3 vs vs0 a -> off u 3 vf vf0 b ->
  Rabs e1 <= u -> Rabs e2 <= u -> Rabs e3 <= u ->
  let one := (Rabs vs - Rabs (((vf + vf) * (1 + e1) + vs) * (1 + e2))) * (1 + e3) in
  let one0 := Rabs vs0 - Rabs (2 * vf0 + vs0) in
  let W := (7 * u + 36 * u ^ 2) * a + (8 * u + 36 * u ^ 2) * b in
  one <= (1 + 5 * u) * a /\ (one0 <= 0 -> one <= W) /\ (0 <= one0 -> - one <= W).
Proof.
intros (a0 & A0 & DA)%off_three (b0 & B0 & DB)%off_three E1 E2 E3 one one0 W.
set (j := 3 * u + 4 * u ^ 2) in *.
pose proof (near _ _ _ DA) as NA. pose proof (near _ _ _ DB) as NB. apply abs_le in DA, DB.
assert (NH : Rabs (2 * vf0 + vs0) - j * (a + 2 * b) <= Rabs (2 * vf + vs) <= Rabs (2 * vf0 + vs0) + j * (a + 2 * b))
  by (apply near, le_abs; lra).
pose proof (rounding u (vf + vf) e1 E1) as RF. set (q := (vf + vf) * (1 + e1) + vs) in *.
assert (NQ : Rabs (2 * vf + vs) - u * (2 * Rabs vf) <= Rabs q <= Rabs (2 * vf + vs) + u * (2 * Rabs vf)).
{ apply near. replace (q - (2 * vf + vs)) with ((vf + vf) * (1 + e1) - (vf + vf)) by (unfold q; ring).
  replace (2 * Rabs vf) with (Rabs (vf + vf)); [exact RF|]. replace (vf + vf) with (2 * vf) by ring.
  rewrite Rabs_mult, (Rabs_right 2); lra. }
pose proof (around q e2 E2) as NX. unfold one, one0. clear RF DA DB one one0.
pose proof (Rabs_pos (q * (1 + e2))) as X0. pose proof (Rabs_pos q) as Q0. pose proof (Rabs_pos vf) as F0.
generalize dependent (Rabs (q * (1 + e2))). generalize dependent (Rabs q). generalize dependent (Rabs (2 * vf + vs)).
generalize dependent (Rabs (2 * vf0 + vs0)). generalize dependent (Rabs vf). generalize dependent (Rabs vs).
generalize dependent (Rabs vs0). generalize dependent (Rabs vf0). clear q e1 e2 E1 E2 vs vf.
intros f0 B0 v0 A0 v NA f NB F0 h0 h NH q NQ Q0 x NX X0.
fine_powers u Hu. assert (j0 : 0 <= j <= (3 + 1/64) * u) by (unfold j; lra).
assert (ja : j * a <= (3 + 1/64) * u * a) by (apply Rmult_le_compat_r; lra).
assert (v1 : v <= (1 + (3 + 1/64) * u) * a) by lra.
assert (f1 : u * f <= u * ((1 + j) * b)) by (apply Rmult_le_compat_l; lra).
pose proof (powers_times _ a0) as UA. pose proof (powers_times _ b0) as UB.
set (w := (7 * u + 26 * u ^ 2) * a + (8 * u + 26 * u ^ 2) * b).
assert (w0 : 0 <= w) by (unfold w; lra).
assert (wW : (1 + u) * w <= W) by (unfold w, W; lra).
split; [|split].
- apply Rle_trans with ((1 + u) * ((1 + (3 + 1/64) * u) * a)); [apply at_most_rounded; lra|lra].
- intros C. apply Rle_trans with (2 := wW). apply at_most_rounded; auto.
  apply Rnot_lt_le. intros N. assert (q1 : u * q <= 1/1024 * q) by (apply Rmult_le_compat_r; lra).
  assert (q2 : q <= 11/10 * v) by lra. assert (q3 : u * q <= u * (11/10 * v)) by (apply Rmult_le_compat_l; lra).
  assert (q4 : u * q <= u * (v + 11/10 * u * v)) by (apply Rmult_le_compat_l; lra).
  assert (q5 : (u + 11/10 * u ^ 2) * v <= (u + 11/10 * u ^ 2) * ((1 + (3 + 1/64) * u) * a))
    by (apply Rmult_le_compat_l; lra).
  unfold w, j in *. lra.
- intros C. apply Rle_trans with (2 := wW). rewrite Ropp_mult_distr_l. apply at_most_rounded; auto.
  assert (q1 : u * q <= u * (a + j * (a + 2 * b) + 2 * (u * f))) by (apply Rmult_le_compat_l; lra).
  assert (u * (u * f) <= u * (u * ((1 + j) * b))) by (apply Rmult_le_compat_l; lra).
  unfold w, j in *. lra.
Qed.

Lemma no_more x x0 d : x * x0 <= 0 -> Rabs (x - x0) <= d -> Rabs x <= d.
Proof.
intros N L. apply Rle_trans with (2 := L). apply Rsqr_le_abs_0. unfold Rsqr. pose proof (Rle_0_sqr x0) as P.
unfold Rsqr in P. lra.
Qed.
(* two, of any two numbers p and q that came of p0 and q0 *)
Lemma two_wrong p0 q0 p q c a e1 e2 e3 : Rabs e1 <= u -> Rabs e2 <= u -> Rabs e3 <= u ->
  0 <= c -> Rabs p0 <= c -> Rabs (p - p0) <= (4 * u + 7 * u ^ 2) * c ->
  0 <= a -> Rabs q0 <= a -> Rabs (q - q0) <= (3 * u + 4 * u ^ 2) * a ->
  let two := (Rabs ((p + q) * (1 + e1)) - Rabs ((p - q) * (1 + e2))) * (1 + e3) in
  two <= (1 + 10 * u) * (a + c) /\
  (p0 * q0 <= 0 -> two <= (6 * u + 36 * u ^ 2) * a + (8 * u + 36 * u ^ 2) * c).
Proof.
intros E1 E2 E3 c0 C0 DC a0 A0 DA two.
pose proof (around (p + q) e1 E1) as NY. pose proof (around (p - q) e2 E2) as NZ.
set (k := 4 * u + 7 * u ^ 2) in *. set (j := 3 * u + 4 * u ^ 2) in *.
pose proof (near _ _ _ DC) as NP. pose proof (near _ _ _ DA) as NQ. fine_powers u Hu.
assert (k1 : k * c <= (4 + 1/64) * u * c) by (apply Rmult_le_compat_r; unfold k; lra).
assert (j1 : j * a <= (3 + 1/64) * u * a) by (apply Rmult_le_compat_r; unfold j; lra).
pose proof (Rabs_triang p q) as T1. pose proof (Rabs_triang p (- q)) as T2. rewrite Rabs_Ropp in T2. fold (p - q) in T2.
pose proof (Rabs_triang (p - q) (2 * q)) as T3. replace (p - q + 2 * q) with (p + q) in T3 by ring.
pose proof (Rabs_triang (q - p) (2 * p)) as T4. replace (q - p + 2 * p) with (p + q) in T4 by ring.
rewrite Rabs_mult, (Rabs_right 2) in T3, T4 by lra. rewrite (Rabs_minus_sym q p) in T4.
pose proof (powers_times _ a0) as UA. pose proof (powers_times _ c0) as UC.
assert (S : Rabs p + Rabs q <= (1 + (4 + 1/64) * u) * (a + c)) by lra.
assert (B : u * Rabs (p + q) + u * Rabs (p - q) <= u * (2 * (Rabs p + Rabs q)))
  by (rewrite <- Rmult_plus_distr_l; apply Rmult_le_compat_l; lra).
assert (B' : u * (2 * (Rabs p + Rabs q)) <= u * (2 * ((1 + (4 + 1/64) * u) * (a + c))))
  by (apply Rmult_le_compat_l; lra).
split.
- apply Rle_trans with ((1 + u) * ((1 + (17/2) * u) * (a + c))); [apply at_most_rounded; [exact E3|lra|lra]|lra].
- intros D. apply Rle_trans with ((1 + u) * ((6 * u + 26 * u ^ 2) * a + (8 * u + 26 * u ^ 2) * c)); [|lra].
  apply at_most_rounded; [exact E3|lra|].
  destruct (Rle_or_lt (p * q) 0) as [N|N].
  + (* the signs differ as they should *)
    assert (Rabs (p + q) <= Rabs (p - q)).
    { apply Rsqr_le_abs_0. unfold Rsqr. lra. }
    lra.
  + (* p or q has the wrong sign, so it is no more than it is off *)
    assert (W : Rabs p <= k * c \/ Rabs q <= j * a).
    { destruct (Rle_or_lt (p * p0) 0) as [X|X]; [left; now apply no_more with p0|right].
      apply no_more with q0; [|exact DA]. apply Rnot_lt_le. intros Y.
      pose proof (Rmult_lt_0_compat _ _ X Y). pose proof (Rmult_le_compat_l _ _ _ (Rlt_le _ _ N) D). lra. }
    destruct W as [W|W].
    * assert (u * (Rabs p + Rabs q) <= u * (k * c + (1 + j) * a)) by (apply Rmult_le_compat_l; lra).
      unfold k, j in *. lra.
    * assert (u * (Rabs p + Rabs q) <= u * ((1 + k) * c + j * a)) by (apply Rmult_le_compat_l; lra).
      unfold k, j in *. lra.
Qed.

Lemma two_sign p q : (Rabs (p + q) - Rabs (p - q) <= 0 -> p * q <= 0) /\
  (0 <= Rabs (p + q) - Rabs (p - q) -> p * - q <= 0).
Proof.
split; intros L.
- assert (S : Rabs (p + q) <= Rabs (p - q)) by lra. apply Rsqr_le_abs_1 in S. unfold Rsqr in S. lra.
- assert (S : Rabs (p - q) <= Rabs (p + q)) by lra. apply Rsqr_le_abs_1 in S. unfold Rsqr in S. lra.
Qed.
Theorem ray_wrong vs0 vf0 fs0 vs vf fs a b c E e1 e2 e3 e4 e5 e6 e7 e8 :
  off u 3 vs vs0 a -> off u 3 vf vf0 b -> off u 4 fs fs0 c -> a + b + c <= E ->
  Rabs e1 <= u -> Rabs e2 <= u -> Rabs e3 <= u -> Rabs e4 <= u -> Rabs e5 <= u -> Rabs e6 <= u -> Rabs e7 <= u ->
  Rabs e8 <= u ->
  let one := (Rabs vs - Rabs (((vf + vf) * (1 + e1) + vs) * (1 + e2))) * (1 + e3) in
  let two := (Rabs ((fs + vs) * (1 + e4)) - Rabs ((fs - vs) * (1 + e5))) * (1 + e6) in
  let value := Rabs ((one - two) * (1 + e7)) - (one + two) * (1 + e8) in
  let one0 := Rabs vs0 - Rabs (2 * vf0 + vs0) in
  let two0 := Rabs (fs0 + vs0) - Rabs (fs0 - vs0) in
  let exact := Rabs (one0 - two0) - (one0 + two0) in
  let K := (16 * u + 120 * u ^ 2) * E in
  (exact <= 0 -> value <= K) /\ (0 <= exact -> - value <= K).
Proof.
intros OA OB OC L E1 E2 E3 E4 E5 E6 E7 E8 one two value one0 two0 exact K.
destruct (one_wrong vs0 vf0 vs vf a b e1 e2 e3 OA OB E1 E2 E3) as (X1 & X2 & X3).
fold one one0 in X1, X2, X3.
apply off_three in OA as (a0 & A0 & DA). apply off_three in OB as (b0 & _ & _).
apply off_four in OC as (c0 & C0 & DC); [|exact Hu].
destruct (two_wrong fs0 vs0 fs vs c a e4 e5 e6 E4 E5 E6 c0 C0 DC a0 A0 DA) as [Y1 Y2].
destruct (two_wrong fs0 (- vs0) fs (- vs) c a e5 e4 e6 E5 E4 E6 c0 C0 DC a0) as [_ Y3].
{ now rewrite Rabs_Ropp. }
{ replace (- vs - - vs0) with (- (vs - vs0)) by ring. now rewrite Rabs_Ropp. }
destruct (two_sign fs0 vs0) as [S1 S2]. fold two0 in S1, S2.
assert (Y3' : 0 <= two0 -> - two <= (6 * u + 36 * u ^ 2) * a + (8 * u + 36 * u ^ 2) * c).
{ intros T. apply Rle_trans with (2 := Y3 (S2 T)). right. unfold two. unfold Rminus. rewrite Ropp_involutive. ring. }
fold two in Y1, Y2. fine_powers u Hu.
pose proof (powers_times _ a0) as UA. pose proof (powers_times _ b0) as UB. pose proof (powers_times _ c0) as UC.
assert (LK : (16 * u + 120 * u ^ 2) * (a + b + c) <= K) by (apply Rmult_le_compat_l; lra).
clearbody one two one0 two0 K. unfold value, exact.
split; intros X.
- assert (0 <= one0 /\ 0 <= two0) as [P1 P2].
  { destruct (sizes (one0 - two0)) as [[S ?]|[S ?]]; rewrite S in X; lra. }
  eapply (not_positive one two _ _ _ _ K e7 e8 E7 E8); [| | |exact X1|exact Y1|exact (X3 P1)|exact (Y3' P2)]; lra.
- assert (P : one0 <= 0 \/ two0 <= 0).
  { destruct (sizes (one0 - two0)) as [[S ?]|[S ?]]; rewrite S in X; lra. }
  rewrite Ropp_minus_distr.
  eapply (not_negative one two _ _ _ _ K e7 e8 E7 E8); [| | |exact X1|exact Y1|
    destruct P as [P|P]; [left; exact (X2 P)|right; exact (Y2 (S1 P))]].
  all: lra.
Qed.
End Wrong.

Lemma ray_enough u : 0 < u <= 1/1024 -> (1 + u) * (16 * u + 120 * u ^ 2) <= (1 - u) ^ 9 * relative 32 320 u.
Proof.
intros Hu. pose proof (nine u Hu). unfold relative. pose proof (power_fine u 1 Hu). pose proof (power_fine u 2 Hu).
apply Rle_trans with ((1 - 9 * u) * (32 * (u / 2) + 320 * u * u)); [|apply Rmult_le_compat_r]; lra.
Qed.

(* exact: twice the smaller of one and two, the sign turned; ray_meets says what that means *)
Theorem ray_right F ox oy vx vy sax say sbx sby answer : fits F (third F) 1 1 ->
  ray F R (reals F) ox oy vx vy sax say sbx sby answer ->
  let vs := vx * (sby - say) - vy * (sbx - sax) in
  let vf := vx * (say - oy) - vy * (sax - ox) in
  let fs := (sax - ox) * (sby - say) - (say - oy) * (sbx - sax) in
  let one := Rabs vs - Rabs (2 * vf + vs) in
  let two := Rabs (fs + vs) - Rabs (fs - vs) in
  let exact := Rabs (one - two) - (one + two) in
  (answer = positive -> exact > 0) /\ (answer = negative -> exact < 0).
Proof.
intros G R vs vf fs one two exact. unfold ray in R. unpack. constants. flags R. nonneg. guarded G. parts G.
differences G. normal G 32 320 17%Z. inputs G (vx, vy). steps G.
bounded G 512%Z lows Pos Neg.
assert (Hf : 0 < u F <= 1/1024) by (destruct G; lra).
match type of Pos with _ -> (Rabs (((Rabs ?vs1 - Rabs (((?vf1 + ?vf1) * (1 + ?ea) + ?vs1) * (1 + ?eb))) * (1 + ?ec) -
  (Rabs ((?fs1 + ?vs1) * (1 + ?ed)) - Rabs ((?fs1 - ?vs1) * (1 + ?ee))) * (1 + ?ef)) * (1 + ?eg)) -
  _ * (1 + ?eh)) * _ > _ * (_ * ?X * ?Y) =>
  eassert (Ovs : off (u F) _ vs1 _ _) by offs Hu; eassert (Ovf : off (u F) _ vf1 _ _) by offs Hu;
  eassert (Ofs : off (u F) _ fs1 _ _) by offs Hu; cbn [Nat.add Nat.max] in Ovs, Ovf, Ofs;
  match type of Ovs with off _ _ _ _ ?a => match type of Ovf with off _ _ _ _ ?b =>
  match type of Ofs with off _ _ _ _ ?c =>
    assert (LE : a + b + c <= X * Y) by units;
    destruct (ray_wrong (u F) Hf vs vf fs vs1 vf1 fs1 a b c (X * Y) ea eb ec ed ee ef eg eh Ovs Ovf Ofs LE) as [W1 W2];
      try assumption end end end end.
in_extents G Pos (16 * u F + 120 * u F ^ 2) (ray_enough (u F) Hf) P' Q'.
fold one two exact in W1, W2. clear - Pos Neg P' Q' W1 W2 R. clearbody exact. signs R Pos Neg P' Q' W1 W2.
Qed.

(* where the answer is negative, they cross within both, nowhere else; where it is positive, they do not meet *)
Theorem ray_meets F ox oy vx vy sax say sbx sby answer : fits F (third F) 1 1 ->
  ray F R (reals F) ox oy vx vy sax say sbx sby answer ->
  let meet t w := ox + t * vx = sax + w * (sbx - sax) /\ oy + t * vy = say + w * (sby - say) in
  (answer = negative -> exists t w, 0 < t /\ 0 < w < 1 /\ meet t w /\ forall t' w', meet t' w' -> t' = t /\ w' = w) /\
  (answer = positive -> forall t w, 0 <= t -> 0 <= w <= 1 -> ~ meet t w).
Proof.
intros G A meet. destruct (ray_right _ _ _ _ _ _ _ _ _ _ G A) as [Pos Neg].
set (vs := vx * (sby - say) - vy * (sbx - sax)) in *. set (vf := vx * (say - oy) - vy * (sax - ox)) in *.
set (fs := (sax - ox) * (sby - say) - (say - oy) * (sbx - sax)) in *.
set (one := Rabs vs - Rabs (2 * vf + vs)) in *. set (two := Rabs (fs + vs) - Rabs (fs - vs)) in *.
assert (W : forall t w, meet t w -> fs = t * vs /\ vf = - w * vs).
{ intros t w [X Y]. assert (FX : sax - ox = t * vx - w * (sbx - sax)) by lra.
  assert (FY : say - oy = t * vy - w * (sby - say)) by lra. unfold fs, vf, vs. rewrite FX, FY. split; ring. }
split.
- intros N. specialize (Neg N).
  assert (0 < one /\ 0 < two) as [One Two] by (destruct (sizes (one - two)) as [[S ?]|[S ?]]; rewrite S in Neg; lra).
  destruct (between_ends (- vf) vs) as [D B].
  { replace (2 * - vf - vs) with (- (2 * vf + vs)) by ring. rewrite Rabs_Ropp. unfold one in One. lra. }
  exists (fs / vs), (- vf / vs). split; [|split; [exact B|split]].
  + assert (P : 0 < fs * vs). { apply Rnot_le_lt. intros Q. unfold two in Two.
      assert (S : Rabs (fs + vs) <= Rabs (fs - vs)) by (apply Rsqr_le_abs_0; unfold Rsqr; lra). lra. }
    replace (fs / vs) with (fs * vs * (/ vs * / vs)) by (now field). apply Rmult_lt_0_compat; [exact P|].
    apply Rlt_0_sqr. now apply Rinv_neq_0_compat.
  + clear - D. split; apply Rmult_eq_reg_r with vs; auto; unfold fs, vf, vs in *; field; auto.
  + intros t w M. destruct (W t w M) as [-> ->]. split; now field.
- intros P t w T B M. specialize (Pos P). destruct (W t w M) as [EA EB].
  assert (One : 0 <= one).
  { unfold one. replace (2 * vf + vs) with (- (2 * (w * vs) - vs)) by (rewrite EB; ring). rewrite Rabs_Ropp.
    pose proof (not_beyond w vs B). lra. }
  assert (Two : 0 <= two).
  { unfold two. assert (Rabs (fs - vs) <= Rabs (fs + vs)); [|lra]. apply Rsqr_le_abs_0. unfold Rsqr. rewrite EA.
    pose proof (Rmult_le_pos _ _ T (Rle_0_sqr vs)) as Q. unfold Rsqr in Q. lra. }
  destruct (sizes (one - two)) as [[S ?]|[S ?]]; rewrite S in Pos; lra.
Qed.
