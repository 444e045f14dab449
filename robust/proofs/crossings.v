(* SPDX-License-Identifier: Apache-2.0 *)
(* The crossings of robust/polygons/point_in_polygon.cpp: where something is answered, every determinant has the exact
   sign. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool List.
Import ListNotations.
From Filters Require Import model constants filters steps ghost tactics cross cross_sign choices crossing_sums.
Open Scope R_scope.

Section Crossings.
Variable F : format.
Hypothesis G : fits F (third F) 1 1.
Variables px py : R.
Notation M := (growing F). Notation n := (n F). Notation u := (u F). Notation joined := (joined F).
Notation inside := (inside F). Notation determinant := (determinant F). Notation answered := (answered F).
Notation seen := (seen F px py). Notation bounded_edge := (bounded_edge F px py). Notation n0 := (n0 F G).
Notation u0 := (u0 F G). Notation all_joined := (all_joined F G). Notation below_trans := (below_trans F).
(* what is answered *)
Lemma adds x y z : add M x y z -> add (reals F) x y z.
Proof. intros (x' & y' & X & Y & Z & _). now exists x', y'. Qed.
Lemma sum_ghost S T c : (0 <= c)%Z -> T - q c * n <= S -> 0 <= T -> exists S0, close F (third F) 0 c S S0 /\ T <= S0.
Proof.
intros C L T0. exists (Rmax S T). split; [|apply Rmax_r]. split; [exact C|]. pose proof n0.
pose proof (q_nonneg _ C). assert (0 <= q c * n) by (apply Rmult_le_pos; lra). simpl. rewrite Rmult_1_r.
apply le_abs. unfold Rmax. destruct (Rle_dec S T); lra.
Qed.
Notation small := (small (third F) 1). Notation close := (close F (third F)).
Lemma location_right a b answer X Y : nonneg_lane a -> nonneg_lane b -> answered a b answer -> answer <> None ->
  0 <= X -> 0 <= Y ->
  (forall S, add M (Plain (sum_x a)) (Plain (sum_x b)) S -> (1 - u) * X - q 40960 * n <= S) ->
  (forall S, add M (Plain (sum_y a)) (Plain (sum_y b)) S -> (1 - u) * Y - q 40960 * n <= S) ->
  (small 1032 (sum_x a) /\ small 1032 (sum_x b) /\ small 1032 (sum_y a) /\ small 1032 (sum_y b)) /\
  exists bound b0, close 1 9609 bound b0 /\ (1 - u) ^ 5 * (relative 3 12 u * (X * Y)) + q 122880 * (n * third F) <= b0
  /\
  forall m, below F (least a) m \/ below F (least b) m -> exists l, below F l m /\ greater (reals F) l bound true.
Proof.
intros [A1 A2] [B1 B2] R U X0 Y0 LX LY. unfold answered, crossings_location in R. unpack.
cbn [constant growing reals] in *.
subst. match type of U with (if negb ?b then _ else if negb ?b' then _ else _) <> _ =>
  destruct b; [|now destruct U]; destruct b'; [|now destruct U] end. clear U.
pose proof u0 as Hu'. assert (Hu : 0 < u <= 1 / 16) by lra. pose proof n0 as N0.
destruct (sum_ghost x ((1 - u) * X) 40960 ltac:(lia) (LX _ S) ltac:(apply Rmult_le_pos; lra)) as (gx & Cx & Gx).
destruct (sum_ghost x0 ((1 - u) * Y) 40960 ltac:(lia) (LY _ S0) ltac:(apply Rmult_le_pos; lra)) as (gy & Cy & Gy).
assert (Lx : low u 1 gx X) by (split; [exact X0|simpl; lra]).
assert (Ly : low u 1 gy Y) by (split; [exact Y0|simpl; lra]). clear LX LY Gx Gy.
apply adds in S, S0, S1, S10. nonneg.
change (at_most M) with (at_most (reals F)) in *. change (greater M) with (greater (reals F)) in *.
change (choose M) with (choose (reals F)) in *. change (mul M) with (mul (reals F)) in *.
guarded G. parts G. split.
{ auto. }
normal G 3 12 2%Z. assert (C2 : n <= 2 <= q 2048) by (destruct G; unfold q; split; lra).
clear S S0 S1. steps G. exists x10.
match goal with C : close 1 9609 x10 ((?p + 2 * (64 * ?a) * (1 + ?e)) * (1 + ?e')) |- _ =>
  exists ((p + 2 * (64 * a) * (1 + e)) * (1 + e')); split; [exact C|];
  eassert (L' : low u _ p _) by lows_here Hu;
  pose proof (low_rounded u Hu _ _ _ e' L' ltac:(assumption)) as [_ L2];
  assert (A : q 122880 * a <= 2 * (64 * a) * (1 + e) * (1 + e')) end.
{ assert (NH : 0 <= n * third F) by (destruct G; apply Rmult_le_pos; lra).
  pose proof (two_roundings F G (2 * 64) (n * third F) e3 e4 E3 E4 ltac:(lra)) as TR.
  replace (q 122880) with 120 by (unfold q; lra). clear - TR NH. rewrite Rmult_assoc in *. lra. }
cbn [Nat.add Nat.max] in L2. split; [rewrite <- (Rmult_assoc _ X Y); lra|].
destruct (lesser_right F N0 _ _ _ _ S11 S12) as (L3 & L4 & _). intros m [L5|L5]; exists x12.
- split; [exact (below_trans _ _ _ L3 L5)|exact S13].
- split; [exact (below_trans _ _ _ L4 L5)|exact S13].
Qed.

(* One edge. Each vertex may be up to 6 n above or below its place. *)
Lemma moved x a b e : close 0 3074 x (a * (1 + e)) -> Rabs e <= u -> Rabs (b - a) <= 6 * n ->
  close 0 9230 x (b * (1 + e)).
Proof.
intros [_ C] E L. split; [lia|]. pose proof u0. pose proof n0. apply (ratio u) in E. simpl in *. rewrite Rmult_1_r in *.
assert (M1 : Rabs ((a - b) * (1 + e)) <= 6 * n * (1 + 1 / 1024)) by (apply mul_le; [rewrite Rabs_minus_sym; exact
  L|apply le_abs; lra]).
replace (x - b * (1 + e)) with (x - a * (1 + e) + (a - b) * (1 + e)) by ring.
apply Rle_trans with (1 := Rabs_triang _ _).
replace (q 9230) with (q 3074 + 6156 / 1024) by (unfold q; lra). lra.
Qed.
Lemma sum_of_ghosts x y x0 y0 A B : joined (Rabs x) (Rabs y) A B -> 0 <= A -> 0 <= B -> close 0 9230 x x0 ->
  close 0 9230 y y0 -> forall S, add M (Plain A) (Plain B) S -> (1 - u) * (Rabs x0 + Rabs y0) - q 40960 * n <= S.
Proof.
intros J A0 B0 [_ X] [_ Y] S Z. pose proof u0. pose proof n0. simpl in X, Y. rewrite Rmult_1_r in X, Y.
pose proof (all_joined _ _ _ _ _ J Z A0 B0 (Rabs_pos x) (Rabs_pos y)) as L.
rewrite Rabs_minus_sym in X, Y. pose proof (Rabs_triang_inv x0 x). pose proof (Rabs_triang_inv y0 y).
replace (q 40960) with 40 by (unfold q; lra). replace (q 9230) with (9230 / 1024) in * by (unfold q; lra).
assert ((1 - u) * (Rabs x0 + Rabs y0 - 2 * (9230 / 1024 * n)) <= (1 - u) * (Rabs x + Rabs y))
  by (apply Rmult_le_compat_l; lra). nra.
Qed.
Lemma small_inside p A B : inside (Rabs p) A B -> 0 <= A -> 0 <= B -> small 1032 A -> small 1032 B -> small 1032 p.
Proof.
intros [I|I] A0 B0 SA SB; apply smaller.
- apply (below_small F G) with A; auto using Rabs_pos. lia.
- apply (below_small F G) with B; auto using Rabs_pos. lia.
Qed.
Lemma wider x x0 : close 0 3074 x x0 -> close 0 9230 x x0.
Proof.
intros [_ L]. split; [lia|]. pose proof n0. apply Rle_trans with (1 := L). simpl.
apply Rmult_le_compat_r; [lra|]. unfold q. simpl. lra.
Qed.
Lemma determinant_right a b c d e1 e2 e3 e4 x y x1 y1 t t1 det l bound b0 : Rabs e1 <= u -> Rabs e2 <= u ->
  Rabs e3 <= u -> Rabs e4 <= u -> close 0 3074 x (a * (1 + e1)) -> close 0 9230 y (b * (1 + e2)) ->
  close 0 3074 x1 (c * (1 + e3)) -> close 0 9230 y1 (d * (1 + e4)) ->
  small 1032 x -> small 1032 x1 -> small 1032 y -> small 1032 y1 -> mul M x y1 t -> mul M y x1 t1 ->
  sub M (Product x y1 t) (Product y x1 t1) det -> below F l (Rabs det) -> greater (reals F) l bound true ->
  close 1 9609 bound b0 ->
  (1 - u) ^ 5 * (relative 3 12 u * ((Rabs (a * (1 + e1)) + Rabs (c * (1 + e3))) *
    (Rabs (b * (1 + e2)) + Rabs (d * (1 + e4))))) + q 122880 * (n * third F) <= b0 ->
  (det > 0 /\ a * d - b * c > 0) \/ (det < 0 /\ a * d - b * c < 0).
Proof.
intros E1 E2 E3 E4 N1 N2 N3 N4 Sx Sx1 Sy Sy1 T T1 D L K CB LB. pose proof u0. assert (Hu : 0 < u <= 1 / 16) by lra.
change (mul M) with (mul (reals F)) in *. change (sub M) with (sub (reals F)) in *.
set (EF := (Rabs (a * (1 + e1)) + Rabs (c * (1 + e3))) * (Rabs (b * (1 + e2)) + Rabs (d * (1 + e4)))) in *.
steps G.
match goal with C : close 1 34195 det ((?p - ?q) * (1 + ?e)) |- _ =>
  set (V := p - q) in *; pose proof (abs_close F _ 1 _ _ _ C) as CA; rename C into CV; rename e into ev end.
destruct (below_close F G _ _ _ _ L CA) as (l0 & Cl & Ll).
assert (NH : 0 <= n * third F) by (destruct G; apply Rmult_le_pos; lra).
assert (C0 : 0 <= relative 3 12 u) by (unfold relative; assert (0 <= u * u) by (apply Rmult_le_pos; lra); lra).
assert (EF0 : 0 <= EF) by (unfold EF; apply Rmult_le_pos; apply Rplus_le_le_0_compat; apply Rabs_pos).
assert (P0 : 0 <= (1 - u) ^ 5 * (relative 3 12 u * EF)) by (apply Rmult_le_pos; [apply pow_le; lra|now apply
  Rmult_le_pos]).
assert (big : l0 > (1 - u) ^ 5 * (relative 3 12 u * EF) + q 34195 * (n * third F)).
{ apply (beyond_bound F G _ _ _ _ _ _ _ Cl CB); [| |exact K].
  - apply Rplus_le_le_0_compat; [exact P0|]. apply Rmult_le_pos; [unfold q; lra|exact NH].
  - assert (Q : q (34195 + 2048 + 9609 + 1024) + q 34195 <= q 122880) by (unfold q; simpl; lra).
    assert ((q (34195 + 2048 + 9609 + 1024) + q 34195) * (n * third F) <= q 122880 * (n * third F))
      by (apply Rmult_le_compat_r; lra). lra. }
assert (off_by : Rabs (det - V * (1 + ev)) <= q 34195 * (n * third F)).
{ destruct CV as [_ CV]. simpl in CV. now rewrite Rmult_1_r in CV. }
apply abs_le in off_by. set (X := (1 - u) ^ 5 * (relative 3 12 u * EF)) in *.
assert (KX : (1 + u) * ((3 * u + u ^ 3) / 2 * EF) <= X).
{ apply Rle_trans with ((1 + u) * ((3 * u + u ^ 3) / 2) * EF); [right; ring|]. unfold X. rewrite <- Rmult_assoc.
  apply Rmult_le_compat_r; [exact EF0|]. apply cross_enough, Hu. }
assert (K0 : 0 <= (3 * u + u ^ 3) / 2 * EF).
{ apply Rmult_le_pos; [pose proof (power u Hu 2); simpl in *; lra|exact EF0]. }
destruct (beyond u Hu V ev _ X ltac:(assumption) K0 KX) as [Pos Neg].
pose proof (wrong_sign u Hu a b c d e1 e4 e2 e3 e5 e6 E1 E4 E2 E3 E5 E6) as W1.
pose proof (wrong_sign u Hu c d a b e3 e2 e4 e1 e6 e5 E3 E2 E4 E1 E6 E5) as W2. cbv zeta in W1, W2. fold EF in W1.
match type of W2 with _ -> _ <= _ * ?Z => replace Z with EF in W2 by (unfold EF; ring) end.
assert (Q0 : 0 <= q 34195 * (n * third F)) by (apply Rmult_le_pos; [unfold q; lra|exact NH]).
clear - Pos Neg W1 W2 Ll big off_by P0 Q0. destruct (Rle_or_lt 0 (V * (1 + ev))) as [S|S].
- left. rewrite Rabs_right in Ll by lra. split; [lra|]. specialize (Pos ltac:(lra)). apply Rnot_le_lt. intros B.
  specialize (W1 ltac:(lra)). fold V in W1. lra.
- right. rewrite Rabs_left in Ll by lra. split; [lra|]. specialize (Neg ltac:(lra)). apply Rnot_le_lt. intros B.
  specialize (W2 ltac:(lra)). unfold V in Neg. lra.
Qed.
Definition exact_determinant d c yd yc := (vx d - px) * yc - yd * (vx c - px).
Definition sign_known d c f := exists det, determinant d c det /\ counts F d c det f /\ forall yd yc, Rabs (yd - (vy d
  - py)) <= 6 * n ->
  Rabs (yc - (vy c - py)) <= 6 * n ->
  (det > 0 /\ exact_determinant d c yd yc > 0) \/ (det < 0 /\ exact_determinant d c yd yc < 0).
Lemma edge_right a b answer d c f : nonneg_lane a -> nonneg_lane b -> answered a b answer -> answer <> None ->
  bounded_edge a b d c f -> sign_known d c f.
Proof.
intros A B R U ((Dx & Dy & _) & (Cx & Cy & _) & Jx & Jy & [Ix Ix'] & [Iy Iy'] & det & (t & t1 & T & T1 & D) & C & L).
exists det. split; [now exists t, t1|]. split; [exact C|]. intros yd yc Yd Yc. pose proof u0.
assert (Hu : 0 < u <= 1 / 16) by lra.
destruct (difference_close F _ 1 1 G _ _ _ _ Dx eq_refl) as (e1 & E1 & N1).
destruct (difference_close F _ 1 1 G _ _ _ _ Cx eq_refl) as (e2 & E2 & N2).
destruct (difference_close F _ 1 1 G _ _ _ _ Dy eq_refl) as (e3 & E3 & N3).
destruct (difference_close F _ 1 1 G _ _ _ _ Cy eq_refl) as (e4 & E4 & N4).
apply (moved _ _ yd) in N3; auto. apply (moved _ _ yc) in N4; auto.
change (close 0 3074 (cx d) ((vx d - px) * (1 + e1))) in N1.
change (close 0 3074 (cx c) ((vx c - px) * (1 + e2))) in N2.
set (X := Rabs ((vx d - px) * (1 + e1)) + Rabs ((vx c - px) * (1 + e2))).
set (Y := Rabs (yd * (1 + e3)) + Rabs (yc * (1 + e4))).
assert (X0 : 0 <= X) by (unfold X; apply Rplus_le_le_0_compat; apply Rabs_pos).
assert (Y0 : 0 <= Y) by (unfold Y; apply Rplus_le_le_0_compat; apply Rabs_pos).
destruct A as [A1 A2], B as [B1 B2].
destruct (location_right a b answer X Y (conj A1 A2) (conj B1 B2) R U X0 Y0
  (sum_of_ghosts _ _ _ _ _ _ Jx A1 B1 (wider _ _ N1) (wider _ _ N2)) (sum_of_ghosts _ _ _ _ _ _ Jy A2 B2 N3 N4))
  as [(S1 & S2 & S3 & S4) (bound & b0 & CB & LB & K)].
apply K in L as (l & L & Kl). clear K R U Jx Jy Dx Dy Cx Cy.
pose proof (small_inside _ _ _ Ix A1 B1 S1 S2). pose proof (small_inside _ _ _ Ix' A1 B1 S1 S2).
pose proof (small_inside _ _ _ Iy A2 B2 S3 S4). pose proof (small_inside _ _ _ Iy' A2 B2 S3 S4).
change (mul M) with (mul (reals F)) in *. change (sub M) with (sub (reals F)) in *.
exact (determinant_right _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ E1 E3 E2 E4 N1 N3 N2 N4 ltac:(assumption) ltac:(assumption)
  ltac:(assumption) ltac:(assumption) T T1 D L Kl CB LB).
Qed.

(* Where the sign bit of y is not that of the exact one, the vertex is moved by less than 6 n, until it is. *)
Definition place c := if minus c then if Rlt_dec (vy c - py) 0 then vy c - py else - n
  else if Rlt_dec 0 (vy c - py) then vy c - py else n.
Definition neg r := if Rlt_dec r 0 then true else false.
Lemma place_right c : seen c -> Rabs (place c - (vy c - py)) <= 6 * n /\ place c <> 0 /\ neg (place c) = minus c.
Proof.
intros (_ & D & S1 & S2). pose proof u0. pose proof n0.
destruct (difference_close F _ 1 1 G _ _ _ _ D eq_refl) as (e & E & [_ N]). simpl in N. rewrite Rmult_1_r in N.
replace (q (c_rounded 1 2048)) with (3074 / 1024) in N by (unfold q; reflexivity).
apply (ratio u) in E. apply abs_le in N. unfold place, neg. set (Y := vy c - py) in *. destruct (minus c) eqn:B.
- assert (cy c <= 0) by (apply Rnot_lt_le; intros C; now apply S2 in C). destruct (Rlt_dec Y 0) as [L|L].
  + rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. destruct (Rlt_dec Y 0); [|easy]. repeat split; lra.
  + assert (Y * (1 - u) <= Y * (1 + e)) by (apply Rmult_le_compat_l; lra). assert (Y <= 4 * n) by nra.
    destruct (Rlt_dec (- n) 0); [|lra]. split; [apply le_abs; lra|]. split; [lra|reflexivity].
- assert (0 <= cy c) by (apply Rnot_lt_le; intros C; now apply S1 in C). destruct (Rlt_dec 0 Y) as [L|L].
  + rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. destruct (Rlt_dec Y 0); [lra|]. repeat split; lra.
  + assert (0 <= - Y * (1 + e - (1 - u))) by (apply Rmult_le_pos; lra).
    assert (- 4 * n <= Y) by nra.
    destruct (Rlt_dec n 0); [lra|]. split; [apply le_abs; lra|]. split; [lra|reflexivity].
Qed.
(* the sign rule, exactly *)
Definition crosses (y : corner -> R) d c :=
  (xorb (neg (y d)) (neg (y c)) && negb (xorb (neg (exact_determinant d c (y d) (y c))) (neg (y c))))%bool.
Definition odd y := fix odd ds := match ds with c :: ((d :: _) as rest) => xorb (odd rest) (crosses y d c) | _ =>
  false end.
Lemma counts_crosses d c det f : seen d -> seen c -> counts F d c det f ->
  (det > 0 /\ exact_determinant d c (place d) (place c) > 0) \/ (det < 0 /\ exact_determinant d c (place d) (place c)
  < 0) ->
  f = crosses place d c.
Proof.
intros Sd Sc (b & [B1 B2] & ->) L. unfold crosses. destruct (place_right d Sd) as (_ & _ & ->).
destruct (place_right c Sc) as (_ & _ & ->). replace b with (neg (exact_determinant d c (place d) (place c))); [easy|].
unfold neg. destruct (Rlt_dec _ 0), L as [[L1 L2]|[L1 L2]]; try lra; [now rewrite B1|now rewrite B2].
Qed.
Definition edges (Q : corner -> corner -> Prop) := fix edges ds :=
  match ds with c :: ((d :: _) as rest) => Q d c /\ edges rest | _ => True end.
Lemma tallied_odd a b answer ds p : nonneg_lane a -> nonneg_lane b -> answered a b answer -> answer <> None ->
  tallied (bounded_edge a b) ds p -> p = odd place ds /\ edges (fun d c => exists f, sign_known d c f) ds.
Proof.
intros A B R U. induction 1 as [c|c d ds p f T [E I] Q]; [now split|].
pose proof (edge_right _ _ _ _ _ _ A B R U Q) as K. split; [|split; [now exists f|exact I]].
rewrite E. change (odd place (c :: d :: ds)) with (xorb (odd place (d :: ds)) (crosses place d c)). f_equal.
destruct Q as (Sd & Sc & _). destruct K as (det & _ & C & L).
apply (counts_crosses d c det f Sd Sc C), L; [apply (place_right d Sd)|apply (place_right c Sc)].
Qed.
Lemma answer_parity a b answer : answered a b answer -> answer <> None ->
  answer = if xorb (parity a) (parity b) then Some Inside else Some Outside.
Proof.
intros R U. unfold crossing_sums.answered, crossings_location in R. unpack. rewrite R in U |- *.
match type of U with (if negb ?b then _ else if negb ?b' then _ else _) <> _ => destruct b, b'; now simpl in * end.
Qed.
End Crossings.

(* Where something is answered, every edge's determinant has the sign of the exact one, also where its vertices are up
  to
   6 n above or below their places; and the answer is the parity of the crossings of a ring of such vertices, none of
   which is on the ray's line. *)
Theorem crossings_right F px py most ds a b answer : fits F (third F) 1 1 -> run F px py most ds a b ->
  answered F a b answer -> answer <> None ->
  edges (fun d c => exists det, determinant F d c det /\ forall yd yc,
    Rabs (yd - (vy d - py)) <= 6 * n F -> Rabs (yc - (vy c - py)) <= 6 * n F ->
    let exact := (vx d - px) * yc - yd * (vx c - px) in (det > 0 /\ exact > 0) \/ (det < 0 /\ exact < 0)) ds /\
  exists y, (forall c, In c ds -> Rabs (y c - (vy c - py)) <= 6 * n F /\ y c <> 0) /\
    answer = if odd px y ds then Some Inside else Some Outside.
Proof.
intros G R A U. pose proof (run_bounded F G _ _ _ _ _ _ R) as (P & Q & _ & T).
destruct (tallied_odd F G px py a b answer ds _ P Q A U T) as [E I]. split.
- revert I. clear. induction ds as [|c ds IH]; [easy|]. destruct ds as [|d ds]; [easy|].
  intros [(f & det & D & _ & L) I]. split; [now exists det|exact (IH I)].
- exists (place F py). split.
  + assert (S : forall c, In c ds -> seen F px py c).
    { clear - R. induction R; intros k [<-|K]; auto; destruct K. }
    intros c I'. apply S in I'. destruct (place_right F G px py c I') as (N & Z & _). now split.
  + rewrite <- E. now apply (answer_parity F).
Qed.
