(* SPDX-License-Identifier: Apache-2.0 *)
(* point_in_obb of obb_filter.h. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Filters Require Import model constants filters steps ghost tactics tracked obb.
Open Scope R_scope.

Definition c_in := let p := c_rounded 1 (c_size + 1024 + (c_size + 1024)) in
  c_rounded 1 (c_way + 1024 + (c_rounded 1 (p + 1024 + (c_size + 1024)) + 1024)).

(* x = a - v, a of |n . d| and v of the volume *)
Lemma one_axis F a ta Ta v tv Tv x B X : fits F (quarter F) 1 1 -> tracked F (quarter F) 2 (c2 3074) m2 6 a ta Ta ->
  tracked F (quarter F) 2 (c2 0) m2 5 v tv Tv -> sub (reals F) (Plain a) (Plain v) x ->
  bounding F (quarter F) 2 512 (c_bound c_in) 13 B (relative 16 384 (u F) * X) -> 0 <= Ta + Tv <= X ->
  (greater (reals F) x B true -> ta > tv) /\
  (forall z, sub (reals F) (Plain 0) (Plain x) z -> greater (reals F) z B true -> ta < tv).
Proof.
intros G A V S Y E. assert (Hu : 0 < u F <= 1/1024) by (destruct G; lra).
pose proof (added_plain _ _ G _ _ _ _ _ _ _ A) as PA. pose proof (added_plain _ _ G _ _ _ _ _ _ _ V) as PV.
split.
- intros K. pose proof (difference_once _ _ G _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ PA PV eq_refl S) as O.
  enough (ta - tv > 0) by lra. apply (beyond_bound _ _ G _ _ _ _ _ _ _ _ _ _ _ O Y ltac:(vm_compute; discriminate));
    [|exact K]. apply obb_enough; [exact Hu|simpl; lia|exact E].
- intros z Z K. pose proof (tracked_sub _ _ G _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ PA PV eq_refl S) as O.
  pose proof (difference_once _ _ G _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ (added_plain _ _ G _ _ _ _ _ _ _ (tracked_zero _ _ 2))
    (added_plain _ _ G _ _ _ _ _ _ _ O) eq_refl Z) as Q.
  enough (0 - (ta - tv) > 0) by lra.
  apply (beyond_bound _ _ G _ _ _ _ _ _ _ _ _ _ _ Q Y ltac:(vm_compute; discriminate)); [|exact K].
  apply obb_enough; [exact Hu|simpl; lia|lra].
Qed.

Lemma within_sum a b c d S Ta Tv : 0 <= a -> 0 <= b -> 0 <= Ta <= a * b * d -> 0 <= Tv <= a * b * c -> c <= S ->
  0 <= Ta + Tv <= a * b * (d + S).
Proof.
intros A B TA TV C. pose proof (Rmult_le_compat_l _ _ _ (Rmult_le_pos _ _ A B) C). rewrite Rmult_plus_distr_l. lra.
Qed.

Theorem point_in_obb_right F cx cy cz ux uy uz vx vy vz wx wy wz px py pz answer : fits F (quarter F) 1 1 ->
  point_in_obb F R (reals F) cx cy cz ux uy uz vx vy vz wx wy wz px py pz answer ->
  let volume := Rabs (triple ux uy uz vx vy vz wx wy wz) in
  let along := fun vx vy vz wx wy wz => Rabs (triple vx vy vz wx wy wz (px - cx) (py - cy) (pz - cz)) in
  let along_u := along vx vy vz wx wy wz in let along_v := along wx wy wz ux uy uz in
  let along_w := along ux uy uz vx vy vz in
  (answer = Some Outside -> volume > 0 /\ (along_u > volume \/ along_v > volume \/ along_w > volume)) /\
  (answer = Some Inside -> volume > 0 /\ along_u < volume /\ along_v < volume /\ along_w < volume).
Proof.
intros G R volume along along_u along_v along_w. unfold point_in_obb in R. unpack. constants.
match type of R with answer = if negb ?a || negb ?b then _ else _ =>
  destruct a; [|subst; split; discriminate]; destruct b; [|subst; split; discriminate] end.
cbn [negb orb] in R. nonneg. guarded G. parts G.
assert (Hu : 0 < u F <= 1/1024) by (destruct G; lra).
assert (VU : vector F 0 0 ux uy uz ux uy uz) by (split; [|split]; apply tracked_input; in_reach G).
assert (VV : vector F 0 0 vx vy vz vx vy vz) by (split; [|split]; apply tracked_input; in_reach G).
assert (VW : vector F 0 0 wx wy wz wx wy wz) by (split; [|split]; apply tracked_input; in_reach G).
assert (VD : vector F 3074 1 x x0 x1 (px - cx) (py - cy) (pz - cz)) by
  (split; [|split]; apply tracked_difference; solve [assumption|in_reach G]).
assert (BU : small (quarter F) 1 m0 x3) by in_reach G. assert (BV : small (quarter F) 1 m0 x5) by in_reach G.
assert (BW : small (quarter F) 1 m0 x7) by in_reach G.
pose proof (size_least F G _ _ _ _ _ S2 S3) as LU. pose proof (size_least F G _ _ _ _ _ S4 S5) as LV.
pose proof (size_least F G _ _ _ _ _ S6 S7) as LW.
pose proof (way_least F G _ _ _ _ _ _ _ _ _ _ _ S S0 S1 S8 S9) as LD.
set (su := size ux uy uz) in *. set (sv := size vx vy vz) in *. set (sw := size wx wy wz) in *.
set (sd := size (px - cx) (py - cy) (pz - cz)) in *.
assert (L : least F (quarter F) 0 c_in 6 x12 (sd + (su + sv + sw))).
{ apply (least_more _ _ G _ _ 5); [lia|]. exact (least_sum _ _ G _ _ _ _ _ _ _ _ _ _ LD (least_sum _ _ G _ _ _ _ _ _ _ _
    _ _ (least_sum _ _ G _ _ _ _ _ _ _ _ _ _ LU LV S10) LW S11) S12). }
pose proof (crossed F G _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ VV VW S13 S14 S15 S16 S17 S18 S19 S20 S21) as NU.
pose proof (crossed F G _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ VW VU S22 S23 S24 S25 S26 S27 S28 S29 S30) as NV.
pose proof (crossed F G _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ VU VV S31 S32 S33 S34 S35 S36 S37 S38 S39) as NW.
pose proof (along_once F G _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ NU VU S40 S41 S42 S43 S44) as A.
destruct (dot_once F G _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ NU VU S40 S41 S42 S43 S44) as [A0 _].
pose proof (along_once F G _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ NU VD S45 S46 S47 S48 S49) as AU.
pose proof (along_once F G _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ NV VD S51 S52 S53 S54 S55) as AV.
pose proof (along_once F G _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ NW VD S57 S58 S59 S60 S61) as AW.
pose proof (bound_of_axis F G _ _ _ _ _ _ _ _ _ _ _ _ _ LV BV LW BW L H S63 S64 eq_refl S66 eq_refl S68) as EU.
pose proof (bound_of_axis F G _ _ _ _ _ _ _ _ _ _ _ _ _ LW BW LU BU L H S69 S70 eq_refl S72 eq_refl S74) as EV.
pose proof (bound_of_axis F G _ _ _ _ _ _ _ _ _ _ _ _ _ LU BU LV BV L H S75 S76 eq_refl S78 eq_refl S80) as EW.
replace (triple vx vy vz wx wy wz ux uy uz) with (triple ux uy uz vx vy vz wx wy wz) in A, A0 by (unfold triple; ring).
assert (U0 : 0 <= su) by apply size_pos. assert (V0 : 0 <= sv) by apply size_pos.
assert (W0 : 0 <= sw) by apply size_pos. assert (D0 : 0 <= sd) by apply size_pos.
pose proof (terms_pos vx vy vz wx wy wz ux uy uz) as TA0.
pose proof (terms_at_most vx vy vz wx wy wz ux uy uz) as TA. fold sv sw su in TA.
pose proof (terms_pos vx vy vz wx wy wz) as TU0. pose proof (terms_pos wx wy wz ux uy uz) as TV0.
pose proof (terms_pos ux uy uz vx vy vz) as TW0.
pose proof (terms_at_most vx vy vz wx wy wz (px - cx) (py - cy) (pz - cz)) as TU.
pose proof (terms_at_most wx wy wz ux uy uz (px - cx) (py - cy) (pz - cz)) as TV.
pose proof (terms_at_most ux uy uz vx vy vz (px - cx) (py - cy) (pz - cz)) as TW. fold su sv sw sd in TU, TV, TW.
set (TT := terms vx vy vz wx wy wz ux uy uz) in *. specialize (TU0 (px - cx) (py - cy) (pz - cz)).
specialize (TV0 (px - cx) (py - cy) (pz - cz)). specialize (TW0 (px - cx) (py - cy) (pz - cz)).
destruct (one_axis F _ _ _ _ _ _ _ _ _ G AU A S50 EU) as [OU IU].
{ apply within_sum with (c := su); lra. }
destruct (one_axis F _ _ _ _ _ _ _ _ _ G AV A S56 EV) as [OV IV].
{ apply within_sum with (c := sv); lra. }
destruct (one_axis F _ _ _ _ _ _ _ _ _ G AW A S62 EW) as [OW IW].
{ apply within_sum with (c := sw); lra. }
assert (Z : volume > 0).
{ apply Rlt_gt, Rabs_pos_lt. apply (not_zero _ _ G _ _ _ _ _ _ _ _ _ _ _ A0 EU ltac:(vm_compute; discriminate));
    [|exact S83]. apply obb_enough; [exact Hu|lia|]. split; [exact TA0|].
  pose proof (within_sum sv sw su 0 (sd + (su + sv + sw)) 0 TT V0 W0). lra. }
specialize (IU _ S88). specialize (IV _ S91). specialize (IW _ S94).
clear - R S84 S85 S86 S89 S92 S95 OU OV OW IU IV IW Z.
split; intros ->; (split; [exact Z|]); destruct x84, x85, x86, x89, x92, x95; try discriminate; auto.
Qed.

(* What that says of the solid: all c + r u + s v + t w with r, s, t from -1 to 1, and its interior. *)
Definition at_place cx cy cz ux uy uz vx vy vz wx wy wz r s t px py pz := px = cx + r * ux + s * vx + t * wx /\
  py = cy + r * uy + s * vy + t * wy /\ pz = cz + r * uz + s * vz + t * wz.

Theorem point_in_obb_solid F cx cy cz ux uy uz vx vy vz wx wy wz px py pz answer : fits F (quarter F) 1 1 ->
  point_in_obb F R (reals F) cx cy cz ux uy uz vx vy vz wx wy wz px py pz answer ->
  let place := fun r s t => at_place cx cy cz ux uy uz vx vy vz wx wy wz r s t px py pz in
  (answer = Some Outside -> ~ exists r s t, Rabs r <= 1 /\ Rabs s <= 1 /\ Rabs t <= 1 /\ place r s t) /\
  (answer = Some Inside -> exists r s t, Rabs r < 1 /\ Rabs s < 1 /\ Rabs t < 1 /\ place r s t).
Proof.
intros G A place. pose proof (point_in_obb_right F cx cy cz ux uy uz vx vy vz wx wy wz px py pz answer G A) as [O I].
clear A. cbv zeta in O, I. set (D := triple ux uy uz vx vy vz wx wy wz) in *. split; intros E.
- specialize (O E). destruct O as [D0 O]. intros (r & s & t & R1 & S1 & T1 & X & Y & Z).
  assert (one : forall q y, Rabs q <= 1 -> y = q * D -> Rabs y <= Rabs D).
  { intros q y Q ->. rewrite Rabs_mult. pose proof (Rmult_le_compat_r _ _ _ (Rabs_pos D) Q). lra. }
  assert (U : Rabs (triple vx vy vz wx wy wz (px - cx) (py - cy) (pz - cz)) <= Rabs D)
    by (apply (one r _ R1); rewrite X, Y, Z; unfold D, triple; ring).
  assert (V : Rabs (triple wx wy wz ux uy uz (px - cx) (py - cy) (pz - cz)) <= Rabs D)
    by (apply (one s _ S1); rewrite X, Y, Z; unfold D, triple; ring).
  assert (W : Rabs (triple ux uy uz vx vy vz (px - cx) (py - cy) (pz - cz)) <= Rabs D)
    by (apply (one t _ T1); rewrite X, Y, Z; unfold D, triple; ring).
  lra.
- specialize (I E). destruct I as (D0 & U & V & W).
  assert (N : D <> 0) by (intros Z; rewrite Z, Rabs_R0 in D0; lra).
  assert (one : forall y, Rabs y < Rabs D -> Rabs (y / D) < 1).
  { intros y Y. unfold Rdiv. rewrite Rabs_mult, Rabs_inv. apply Rmult_lt_reg_r with (Rabs D); [lra|].
    rewrite Rmult_assoc, Rinv_l, Rmult_1_l, Rmult_1_r by lra. exact Y. }
  exists (triple vx vy vz wx wy wz (px - cx) (py - cy) (pz - cz) / D),
    (triple wx wy wz ux uy uz (px - cx) (py - cy) (pz - cz) / D),
    (triple ux uy uz vx vy vz (px - cx) (py - cy) (pz - cz) / D).
  repeat (split; [apply one; assumption|]).
  split; [|split]; apply Rmult_eq_reg_r with D; auto; unfold Rdiv; clear - N; unfold D, triple in *; field; exact N.
Qed.
