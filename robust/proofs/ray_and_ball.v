(* SPDX-License-Identifier: Apache-2.0 *)
(* RayAndBall of ray_filter.h. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Filters Require Import model constants filters steps ghost tactics squares.
Open Scope R_scope.

Lemma square_of_size x : x * x = Rabs x * Rabs x.
Proof. rewrite <- Rabs_mult. symmetry. apply Rabs_pos_eq, Rle_0_sqr. Qed.
Lemma cauchy a b c x y z : (a * x + b * y + c * z) * (a * x + b * y + c * z) <=
  (x * x + y * y + z * z) * (a * a + b * b + c * c).
Proof.
pose proof (Rle_0_sqr (a * y - b * x)). pose proof (Rle_0_sqr (b * z - c * y)).
pose proof (Rle_0_sqr (c * x - a * z)). unfold Rsqr in *. lra.
Qed.

Lemma cauchy_and_more a b c x y z r : (a * x + b * y + c * z) * (a * x + b * y + c * z) <=
  (x * x + y * y + z * z) * (a * a + b * b + c * c + r * r).
Proof.
apply Rle_trans with (1 := cauchy a b c x y z). 
apply Rmult_le_compat_l; pose proof (Rle_0_sqr r); unfold Rsqr in *; nra.
Qed.

(* the square of a number of any sign is that of its magnitude *)
Ltac lows Hu ::= match goal with
  | |- low _ _ ((?x + ?y) * (1 + ?e)) _ => eapply low_add; [exact Hu| | |eassumption|reflexivity]; lows Hu
  | |- low _ _ (?x * ?x * (1 + ?e)) _ => rewrite (square_of_size x);
    eapply low_mul; [exact Hu| | |eassumption|reflexivity]; lows Hu
  | |- low _ _ (?x * ?y * (1 + ?e)) _ => eapply low_mul; [exact Hu| | |eassumption|reflexivity]; lows Hu
  | |- low _ _ (Rabs (?x * (1 + ?e))) _ => apply low_abs_rounded; [exact Hu|eassumption]
  | |- low _ _ (Rabs ?x) _ => apply low_self; apply Rabs_pos
  | |- low _ _ ?x _ => apply low_self; lra
  end.

Section Certain.
Variables (F : format) (H : R).
Hypothesis G : fits F H 1 1.
Notation u := (u F). Notation n := (n F). Notation M := (reals F).

Lemma fine : 0 < u <= 1/1024.
Proof. destruct G. lra. Qed.
Lemma own_sign x : exists s, greater M x 0 s /\ (s = true <-> x > 0).
Proof.
destruct (Rlt_dec 0 x) as [P|P]; [exists true|exists false]; split; try (split; lra || easy);
  exists x, 0; (split; [now left|]); (split; [now left|]); split; lra || easy.
Qed.

(* As certain_ghost, but of the absolute term, `more` is left over. *)
Lemma certain_and_more k cV cB V V0 B P A e s i T num more : close F H k cV V V0 ->
  close F H k cB B ((P + A) * (1 + e)) -> Rabs e <= u -> low u i P T -> A = IZR (num + more) * (n * H ^ k) ->
  (0 <= more)%Z -> (cV + cB + 1024 <= num * (1024 - 1))%Z -> greater M (Rabs V) B true -> greater M V 0 s ->
  let D := IZR more * (n * H ^ k) in
  (s = true -> V0 > (1 - u) ^ S i * (T + D)) /\ (s = false -> V0 < - ((1 - u) ^ S i * (T + D))).
Proof.
intros CV CB E L EA M0 N K S D. pose proof fine as Hu. pose proof (basics F H 1 1 G) as B0.
apply IZR_le in M0. pose proof (n_pow F H 1 1 G k) as NP.
assert (D0 : 0 <= D) by (apply Rmult_le_pos; lra).
apply (certain_ghost F H 1 1 G k cV cB V V0 B (P + D) (IZR num * (n * H ^ k)) e s i (T + D) num); auto.
- replace (P + D + IZR num * (n * H ^ k)) with (P + A); [exact CB|]. rewrite EA, plus_IZR. unfold D. ring.
- destruct L as [T0 L]. split; [lra|]. pose proof (down u ltac:(lra) i) as Di. nra.
Qed.
(* a number whose ghost is as far from 0 has its sign, and is read as it is *)
Lemma seen_as_it_is c x x0 : close F H 1 c x x0 -> (c <= 65536)%Z -> 66 * (n * H) <= Rabs x0 ->
  n <= Rabs x /\ (x > 0 -> x0 > 0) /\ (x < 0 -> x0 < 0).
Proof.
intros [_ C] L B. pose proof (basics F H 1 1 G) as B0. apply IZR_le in L. rewrite pow_1 in C.
assert (Q : q c <= 64) by (unfold q; lra). assert (NH : 2 * n <= n * H) by nra.
assert (X : Rabs (x - x0) <= 64 * (n * H)) by (apply Rle_trans with (1 := C), Rmult_le_compat_r; lra).
unfold Rabs in *. repeat destruct Rcase_abs; lra.
Qed.

(* The slope: off from p by four roundings in units of t <= sqrt X. *)
Lemma slope_certain s0 p t X e e' z D : off u 4 s0 p t -> t * t <= X -> Rabs e <= u -> Rabs e' <= u -> 0 <= z ->
  0 <= D -> (s0 * s0 * (1 + e) - z) * (1 + e') > (1 - u) ^ 12 * (relative 40 1024 u * X + D) ->
  D / 2 <= s0 * s0 /\ (s0 > 0 -> p > 0) /\ (s0 < 0 -> p < 0).
Proof.
intros O TX E E' Z D0 V. pose proof fine as Hu.
apply (ratio u) in E, E'. destruct O as [Op O].
assert (X0 : 0 <= X) by nra. assert (UX : 0 <= u * X) by nra.
assert (R0 : 20 * u * X <= relative 40 1024 u * X).
{ apply Rmult_le_compat_r; [exact X0|]. unfold relative. simpl. nra. }
assert (L : 1000 / 1024 <= (1 - u) ^ 12).
{ pose proof (bernoulli_down u ltac:(lra) 12) as B. simpl INR in B. lra. }
assert (W : s0 * s0 * (1 + e) * (1 + e') <= s0 * s0 * (1 + 3 * u)).
{ rewrite Rmult_assoc. apply Rmult_le_compat_l; [nra|]. nra. }
assert (Q : (1000 / 1024) * (20 * (u * X) + D) < s0 * s0 * (1 + 3 * u)).
{ apply Rlt_le_trans with ((s0 * s0 * (1 + e) - z) * (1 + e')).
  - apply Rle_lt_trans with (2 := V).
    apply Rmult_le_compat; try lra. 
  - apply Rle_trans with (2 := W). rewrite Rmult_minus_distr_r. nra. }
assert (S1 : s0 * s0 * (1 + 3 * u) <= s0 * s0 * (1027 / 1024)) by (apply Rmult_le_compat_l; nra).
split; [lra|].
assert (K : (1 + u) ^ 4 - 1 <= 5 * u) by (simpl; nra).
assert (T0 : 0 <= t) by (apply Rle_trans with (2 := Op), Rabs_pos).
assert (B : Rabs (s0 - p) <= 5 * u * t) by (apply Rle_trans with (1 := O), Rmult_le_compat_r; lra).
assert (BB : (5 * u * t) * (5 * u * t) <= u * X / 40).
{ replace (5 * u * t * (5 * u * t)) with (u * (25 * u) * (t * t)) by ring.
  apply Rle_trans with (u * (25 * u) * X); [apply Rmult_le_compat_l; nra|]. nra. }
apply abs_le in B.
split; intros S; apply Rnot_le_gt; intros N.
- assert (s0 * s0 <= (5 * u * t) * (5 * u * t)) by (apply Rmult_le_compat; lra). lra.
- assert (s0 * s0 <= (5 * u * t) * (5 * u * t)) by nra. lra.
Qed.
(* the leftovers of both bounds *)
Lemma far_slope s0 D : D = IZR 3584 * (n * H ^ 3) -> D / 2 <= s0 * s0 -> 66 * (n * H) <= Rabs s0.
Proof.
intros -> L. pose proof (basics F H 1 1 G) as B0. assert (NH : 0 < n * H) by nra. 
rewrite <- (Rabs_right (66 * _)) by lra.
apply Rsqr_le_abs_0. unfold Rsqr. apply Rle_trans with (2 := L).
assert (NL : n <= H / 1024) by (unfold q in B0; lra).
assert (N : n * H * (n * H) <= n * H * (H / 1024 * H)).
{ apply Rmult_le_compat_l; [lra|]. apply Rmult_le_compat_r; lra. }
assert (0 <= n * H * (H * H)) by (apply Rmult_le_pos; nra). simpl. lra.
Qed.
Lemma far_start (s : bool) s0 T : 0 <= T -> let B := (1 - u) ^ 8 * (T + IZR 3584 * (n * H ^ 1)) in
  (s = true -> s0 > B) -> (s = false -> s0 < - B) -> 66 * (n * H) <= Rabs s0 /\ (s = true -> s0 > 0).
Proof.
intros T0 B P N. pose proof fine as Hu. pose proof (basics F H 1 1 G) as B0. assert (NH : 0 < n * H) by nra.
assert (L : 66 * (n * H) <= B).
{ pose proof (bernoulli_down u ltac:(lra) 8) as D. simpl INR in D. unfold B. rewrite pow_1.
  apply Rle_trans with ((1000 / 1024) * (T + 3584 * (n * H))); [lra|apply Rmult_le_compat_r; lra]. }
destruct s.
- specialize (P eq_refl). rewrite Rabs_right; lra.
- specialize (N eq_refl). rewrite Rabs_left; [split; [lra|discriminate]|lra].
Qed.
End Certain.

(* The last comparisons. b: slope > start, as they are read; z: the less of the two. *)
Section Choice.
Variables (F : format) (start slope z : R) (b s : bool).
Hypotheses (N : 0 < n F) (S : n F <= Rabs start) (B : greater (reals F) slope start b)
  (C : choose (reals F) b start slope z) (Z : greater (reals F) 0 z s).
Lemma less_than_zero : s = true -> start < 0 \/ slope < 0.
Proof using All.
intros ->. destruct Z as (o & z' & O & RZ & E). apply proj1 in E. specialize (E eq_refl).
assert (O0 : o = 0) by (destruct O as [->|[-> _]]; reflexivity). subst o.
assert (Z0 : z < 0) by (destruct RZ as [->|[-> _]]; lra). simpl in C.
destruct b, C as [->|[-> _]]; lra.
Qed.
Lemma not_less_than_zero : s = false -> start > 0 /\ (n F <= Rabs slope -> slope > 0).
Proof using All.
intros ->. destruct Z as (o & z' & O & RZ & E).
assert (O0 : o = 0) by (destruct O as [->|[-> _]]; reflexivity). subst o.
assert (Z0 : 0 <= z') by (apply Rnot_lt_le; intros X; apply E in X; discriminate).
assert (A : forall x y, read F x y -> n F <= Rabs x -> y = x) by (intros x y [->|[_ X]] L; [reflexivity|lra]).
destruct B as (f & g & RF & RG & EB). rewrite (A _ _ RG S) in EB. simpl in C.
assert (D : start < 0 -> False).
{ intros L. destruct b.
  - rewrite (A _ _ C S) in RZ. rewrite (A _ _ RZ S) in Z0. lra.
  - assert (FL : f <= start) by (apply Rnot_lt_le; intros X; apply EB in X; discriminate).
    assert (SL : f = slope /\ n F <= Rabs slope).
    { rewrite Rabs_left in S by exact L. destruct RF as [->|[-> _]]; [|lra]. split; [reflexivity|].
      rewrite Rabs_left; lra. }
    destruct SL as [-> SL]. rewrite (A _ _ C SL) in RZ. rewrite (A _ _ RZ SL) in Z0. lra. }
assert (P : start > 0) by (unfold Rabs in S; destruct Rcase_abs; lra).
split; [exact P|]. intros SL. apply Rnot_le_gt. intros L.
rewrite (A _ _ RF SL) in EB. destruct b.
- apply proj1 in EB. specialize (EB eq_refl). lra.
- rewrite (A _ _ C SL) in RZ. rewrite (A _ _ RZ SL) in Z0. unfold Rabs in SL. destruct Rcase_abs; lra.
Qed.
End Choice.

(* of x and its bound: on which side of zero its ghost is, by `more` than the bound; and the sign of the polynomial *)
Ltac sides G x num more Pos Neg Right :=
  let Hu := fresh "Hu" in pose proof (fits_u _ _ _ _ G) as Hu;
  lazymatch type of G with fits ?F ?H ?w ?v =>
  match goal with K : greater (reals F) (Rabs x) ?b true |- _ =>
  match goal with S : greater (reals F) x 0 ?s |- _ =>
  match goal with NV : close F H ?k ?cv x (?D * (1 + ?e')) |- _ =>
  match goal with NB : close F H k ?cb b ((?P + ?A) * (1 + ?e)) |- _ =>
  match goal with E : Rabs e <= u F |- _ =>
  match goal with E' : Rabs e' <= u F |- _ =>
    let L := fresh "L" in eassert (L : low (u F) _ P _) by lows Hu; cbn [Nat.add Nat.max] in L;
    let O := fresh "O" in eassert (O : off (u F) _ D _ _) by (offs_last Hu); cbn [Nat.add Nat.max] in O;
    let N := fresh "N" in assert (N : A = IZR (num + more) * (n F * H ^ k)) by (simpl; ring);
    match type of L with low _ ?i _ ?T => match type of O with off _ ?j' _ ?t ?TT =>
    destruct (certain_and_more F H G k cv cb x (D * (1 + e')) b P A e s i T num more NV NB E L N ltac:(discriminate)
      ltac:(vm_compute; discriminate) K S) as [Pos Neg];
    let C := fresh "C" in
    assert (C : (1 + u F) * ((1 + u F) ^ j' - 1) * TT <= (1 - u F) ^ Datatypes.S i * T);
    [clear - Hu G | 
     pose proof (certain_polynomial F H w v G k cv cb x D e' b P A e s i T (num + more) j' t TT NV E' NB E L N
       ltac:(vm_compute; discriminate) K S O C) as Right]
    end end end end end end end end end.

Lemma one_more u e : 0 < u <= 1/16 -> Rabs e <= u -> 0 <= 1 + e.
Proof. intros Hu E%(ratio u). lra. Qed.
Ltac nonnegative := match goal with
  | Hu : 0 < u ?F <= 1/16, E : Rabs ?e <= u ?F |- 0 <= 1 + ?e => exact (one_more _ _ Hu E)
  | |- 0 <= _ + _ => apply Rplus_le_le_0_compat; nonnegative
  | |- 0 <= ?x * ?x => apply Rle_0_sqr
  | |- 0 <= _ * _ => apply Rmult_le_pos; nonnegative end.

Theorem ray_and_ball_right F ox oy oz vx vy vz kx ky kz radius answer : fits F (sixth F) 1 1 -> 0 <= radius ->
  ray_and_ball F R (reals F) ox oy oz vx vy vz kx ky kz radius answer ->
  let start := (ox - kx) * (ox - kx) + (oy - ky) * (oy - ky) + (oz - kz) * (oz - kz) - radius * radius in
  let slope := (ox - kx) * vx + (oy - ky) * vy + (oz - kz) * vz in
  let value := slope * slope - (vx * vx + vy * vy + vz * vz) * start in
  (answer = positive -> value > 0 /\ (start < 0 \/ slope < 0)) /\
  (answer = negative -> value < 0 \/ (start > 0 /\ slope > 0)).
Proof.
intros G UP R start slope value. unfold ray_and_ball in R. unpack. constants. flags R. squares_nonneg. squared_guard G.
square_parts G. differences G. inputs G (vx, vy, vz, radius). normal G 10 128 6%Z. normal G 40 1024 22%Z. steps G.
repeat match goal with D : _ = _ \/ _ = _ |- _ => clear D end.
match goal with C : choose (reals F) ?b ?x ?y ?z |- _ =>
  set (near := z) in *; set (begin := x) in *; set (fall := y) in *; rename C into Choice end.
destruct (own_sign F begin) as (sb & Sb & Eb).
match goal with S : greater (reals F) ?x 0 ?s, K : greater (reals F) (Rabs ?x) _ true |- _ =>
  lazymatch x with begin => fail | _ => rename S into Sv; set (total := x) in * end end.
sides G begin 512%Z 3584%Z PosB NegB RightB.
{ constant_is_enough G 128%nat. }
sides G total 512%Z 3584%Z PosV NegV RightV.
{ match goal with Hv : 0 < u F <= 1/16 |- _ => rename Hv into Hw end.
  assert (Hf : u F <= 1/1024) by (destruct G; lra).
  assert (E : (1 + u F) * ((1 + u F) ^ 10 - 1) <= (1 - u F) ^ 12 * relative 20 512 (u F)).
  { apply Rle_trans with ((1 - u F) ^ 12 * (INR 10 * u F + INR 512 * u F * u F)).
    - apply enough; [exact Hw|simpl; lra|simpl; lra].
    - apply Rmult_le_compat_l; [apply pow_le; lra|unfold relative; simpl; lra]. }
  assert (E0 : 0 <= (1 + u F) * ((1 + u F) ^ 10 - 1)).
  { apply Rmult_le_pos; [lra|]. assert (1 <= (1 + u F) ^ 10) by (apply pow_R1_Rle; lra). lra. }
  match goal with |- _ * ?A <= _ * (_ * (?B * ?C)) => 
    assert (TT : A <= 2 * (B * C)); [|set (T := A) in *; set (W := B * C) in *] end.
  { match goal with |- ?p * ?p + ?v * ?w <= _ => assert (p * p <= v * w) by apply cauchy_and_more; lra end. }
  apply Rle_trans with ((1 + u F) * ((1 + u F) ^ 10 - 1) * (2 * W)); [now apply Rmult_le_compat_l|].
  assert (W0 : 0 <= W) by (unfold W; magnitudes; positive_terms).
  apply Rle_trans with ((1 - u F) ^ 12 * relative 20 512 (u F) * (2 * W)); [apply Rmult_le_compat_r; lra|].
  right. unfold relative. simpl. field. }
assert (Nz : 0 < n F) by (destruct G; lra).
match goal with N : close _ _ 1 ?c begin _ |- _ =>
  pose proof (seen_as_it_is F (sixth F) G c begin _ N ltac:(discriminate)) as SB end.
match goal with N : close _ _ 1 ?c fall _ |- _ =>
  pose proof (seen_as_it_is F (sixth F) G c fall _ N ltac:(discriminate)) as SF end.
match type of PosB with _ -> _ > (1 - _) ^ _ * (?T + _) =>
  assert (T0 : 0 <= T) by (magnitudes; positive_terms);
  destruct (far_start F (sixth F) G sb _ T T0 PosB NegB) as [FB SignB] end.
destruct (SB FB) as (NB & _ & _). clear SB FB PosB NegB.
assert (Slope : x40 = true -> sb = true -> n F <= Rabs fall /\ (fall > 0 -> slope > 0) /\ (fall < 0 -> slope < 0)).
{ intros TV TB. specialize (PosV TV). specialize (SignB TB).
  match goal with Hv : 0 < u F <= 1/16 |- _ => rename Hv into Hw end.
  lazymatch type of SF with _ <= Rabs ?s0 -> _ => eassert (O4 : off (u F) _ s0 _ _) by offs Hw end.
  cbn [Nat.add Nat.max] in O4.
  lazymatch type of PosV with (_ * (1 + ?e0) - ?w * ?b * (1 + ?e1)) * (1 + ?e2) > _ * (relative _ _ _ * ?X + ?D) =>
  lazymatch goal with A0 : Rabs e0 <= u F, A2 : Rabs e2 <= u F |- _ =>
  lazymatch type of O4 with off _ _ _ _ ?t =>
    assert (W0 : 0 <= w * b * (1 + e1));
    [|assert (D1' : 0 <= D); [|assert (TX : t * t <= X);
      [|destruct (slope_certain F (sixth F) G _ _ t X e0 e2 _ D O4 TX A0 A2 W0 D1' PosV)
        as (Far & Rises & Falls)]]] end end end.
  - apply Rmult_le_pos; [apply Rmult_le_pos; [nonnegative|apply Rlt_le, SignB]|nonnegative].
  - clear - G Nz. apply Rmult_le_pos; [lra|]. apply Rmult_le_pos; [lra|]. apply pow_le. destruct G. lra.
  - apply cauchy_and_more.
  - pose proof (far_slope F (sixth F) G _ _ eq_refl Far) as FS. destruct (SF FS) as (NF & PF & MF).
    split; [exact NF|]. split; intros Y; [apply Rises, PF, Y|apply Falls, MF, Y]. }
destruct RightB as [StartP StartN]. destruct RightV as [ValueP ValueN].
split; intros ->; destruct x40; try discriminate; cbn [andb] in R.
- split; [exact (ValueP eq_refl)|]. destruct x42; [|discriminate].
  destruct sb.
  + right. destruct (less_than_zero F begin fall near x37 true Nz NB S37 Choice S42 eq_refl) as [LB|LF];
    [exfalso; apply proj1 in Eb; specialize (Eb eq_refl); clear - Eb LB; lra|].
    apply Slope; auto.
  + left. apply StartN. reflexivity.
- right. destruct x42; [discriminate|].
  destruct (not_less_than_zero F begin fall near x37 false Nz NB S37 Choice S42 eq_refl) as [LB LF].
  assert (TB : sb = true) by (now apply Eb). destruct (Slope eq_refl TB) as (NF & PF & _).
  split; [now apply StartP|]. apply PF, LF, NF.
- left. now apply ValueN.
Qed.
