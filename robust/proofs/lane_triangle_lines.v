(* SPDX-License-Identifier: Apache-2.0 *)
(* Segments and rays with triangles in a lane: five volumes decide. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model constants steps format floats ghost lanes.
From Filters Require Import lane_bounds lane_turns lane_values lane_faces lane_moderate.
From Filters Require Import lane_triangle_filters lane_volumes lane_volume_bounds lane_triangles.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.
#[local] Existing Instances p53 fexp_valid below_1024.

(* Opposites, and sums and differences of two volumes. *)
Lemma opposite_is (x : float) : finite x -> finite (minus (number 0 0) x) /\ value (minus (number 0 0) x) = - x.
Proof.
intros F. destruct (number_value 0 0) as [FZ VZ]; [lia|lia|]. rewrite Rmult_0_l in VZ.
assert (E : rnd (value (number 0 0) - x) = - x).
{ rewrite VZ, Rminus_0_l, rnd_opp, rnd_held by apply held_value. reflexivity. }
unfold minus in *. cases_of (Bminus_correct 53 1024 _ _ mode_NE (number 0 0) x FZ F);
  fold (rnd (value (number 0 0) - value x)) in *.
- intros (V & Z & _). split; [exact Z|]. now rewrite V.
- intros _. rewrite E, Rabs_Ropp in L. pose proof (below_high x). lra.
Qed.
#[local] Opaque plus minus times multiply_add.
Lemma lane_opposite j x t T : lane j 0 x t T -> lane j 0 (minus (number 0 0) x) (- t) T.
Proof.
intros [F E]. destruct (opposite_is x F) as [F' V]. split; [exact F'|]. rewrite V. apply exact_est in E as [A B].
apply est_exact. split; [now rewrite Rabs_Ropp|]. replace (- x - - t) with (- (x - t)) by ring. now rewrite Rabs_Ropp.
Qed.
Lemma total_room A1 A2 A3 B1 B2 B3 C1 C2 C3 : three A1 A2 A3 -> three B1 B2 B3 -> three C1 C2 C3 ->
  0 <= total (A1, A2, A3) (B1, B2, B3) (C1, C2, C3) <= room / 128.
Proof.
intros (A & B & C) (D & E & F) (G & H & I). destruct rooms as (_ & L & _). cbn [total].
pose proof (unit_volume _ _ _ B F G). pose proof (unit_volume _ _ _ C E G). pose proof (unit_volume _ _ _ C D H).
pose proof (unit_volume _ _ _ A F H). pose proof (unit_volume _ _ _ A E I). pose proof (unit_volume _ _ _ B D I). lra.
Qed.
Section Sums.
Variable T : R.
Hypothesis small : 0 <= T <= room / 128.
Definition one_volume z t := lane 8 0 z t (T + rest).
Definition two_volumes z t := lane 9 0 z t (2 * (T + rest)).
Lemma volumes_plus x y s t : one_volume x s -> one_volume y t -> two_volumes (plus x y) (s + t).
Proof.
intros X Y. destruct small_rests as (_ & S & _). pose proof room_is.
assert (K := lane_plus _ _ 8 _ _ _ _ _ _ _ _ X Y eq_refl ltac:(lia) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)).
unfold two_volumes. replace 0 with (2 * (0 + 0)) by ring. replace (2 * (T + rest)) with (T + rest + (T + rest)) by ring.
exact K.
Qed.
Lemma volumes_minus x y s t : one_volume x s -> one_volume y t -> two_volumes (minus x y) (s - t).
Proof.
intros X Y. destruct small_rests as (_ & S & _). pose proof room_is.
assert (K := lane_minus _ _ 8 _ _ _ _ _ _ _ _ X Y eq_refl ltac:(lia) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)).
unfold two_volumes. replace 0 with (2 * (0 + 0)) by ring. replace (2 * (T + rest)) with (T + rest + (T + rest)) by ring.
exact K.
Qed.
(* Before a last sum or difference: 33 / 4 T of one, 111 / 4 T of three, 37 T of four. *)
Lemma enough c k b : 0 <= c -> c + 1 / 4 <= k -> k <= 42 -> k * v * T + paid / 4 <= b -> c * v * (T + rest) <= b.
Proof.
intros C K L B. destruct paid_is as [_ P]. destruct small_rests as (S & R & _). pose proof v_small.
assert (0 <= v * T) by (apply Rmult_le_pos; lra). assert (0 <= v * rest) by (apply Rmult_le_pos; lra).
assert (c * v * T <= k * v * T) by nra. assert (c * v * rest <= 42 * (v * rest)) by nra.
assert (0 <= spare * v) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma finite_four x y s t : two_volumes x s -> two_volumes y t -> finite (plus x y) /\ finite (minus x y).
Proof.
intros X Y. destruct small_rests as (_ & S & _). pose proof room_is.
split; [apply (lane_plus _ _ 9 _ _ _ _ _ _ _ _ X Y)|apply (lane_minus _ _ 9 _ _ _ _ _ _ _ _ X Y)]; try reflexivity;
  lia || lra.
Qed.
Variable b : float.
Hypothesis finite_b : finite b.
Lemma signed_one k z t : k * v * T + paid / 4 <= b -> 9 <= k <= 42 -> one_volume z t -> signed z b t.
Proof.
intros L K Z. apply (signed_lane _ _ _ _ _ Z); [lia|exact finite_b|].
replace (INR 8) with 8 by (simpl; lra). apply (enough _ k); lra.
Qed.
Lemma signed_three x y s t : 31 * v * T + paid / 4 <= b -> two_volumes x s -> one_volume y t ->
  signed (minus x y) b (s - t).
Proof.
intros L X Y. apply (signed_minus 9 8 9 _ _ _ _ _ _ _ X Y); [reflexivity|lia|exact finite_b|].
replace (INR 9) with 9 by (simpl; lra). replace ((9 + 1 / 4) * v * (2 * (T + rest) + (T + rest)))
  with (111 / 4 * v * (T + rest)) by field.
apply (enough _ 31); lra.
Qed.
Hypothesis large : 42 * v * T + paid / 4 <= b.
Lemma signed_four_plus x y s t : two_volumes x s -> two_volumes y t -> signed (plus x y) b (s + t).
Proof.
intros X Y. apply (signed_plus 9 9 9 _ _ _ _ _ _ _ X Y); [reflexivity|lia|exact finite_b|].
replace (INR 9) with 9 by (simpl; lra). replace ((9 + 1 / 4) * v * (2 * (T + rest) + 2 * (T + rest)))
  with (37 * v * (T + rest)) by field.
apply (enough _ 42); lra.
Qed.
Lemma signed_four_minus x y s t : two_volumes x s -> two_volumes y t -> signed (minus x y) b (s - t).
Proof.
intros X Y. apply (signed_minus 9 9 9 _ _ _ _ _ _ _ X Y); [reflexivity|lia|exact finite_b|].
replace (INR 9) with 9 by (simpl; lra). replace ((9 + 1 / 4) * v * (2 * (T + rest) + 2 * (T + rest)))
  with (37 * v * (T + rest)) by field.
apply (enough _ 42); lra.
Qed.
End Sums.

(* What the least and the greatest of three say of each. *)
Lemma above_is a b : finite a -> finite b -> above a b = Rlt_bool b a.
Proof.
intros A B. destruct (above_finite a b A B) as [P Q]. destruct (above a b), (Rlt_bool_spec b a) as [L|L]; auto.
specialize (P eq_refl). lra.
Qed.
Lemma finite_lesser x y : finite x -> finite y -> finite (lesser x y) /\ finite (greater_of x y).
Proof. intros X Y. unfold lesser, greater_of. now destruct (above y x), (above x y). Qed.
Ltac comparisons := rewrite ?above_is by assumption; repeat match goal with |- context [Rlt_bool ?a ?b] =>
  destruct (Rlt_bool_spec a b) end; try reflexivity; lra.
Lemma above_lesser x y z : finite x -> finite y -> finite z -> above (lesser x y) z = above x z && above y z.
Proof. intros X Y Z. unfold lesser. destruct (above y x) eqn:A; rewrite above_is in A by assumption; revert A;
  comparisons. Qed.
Lemma below_lesser x y z : finite x -> finite y -> finite z -> above z (lesser x y) = above z x || above z y.
Proof. intros X Y Z. unfold lesser. destruct (above y x) eqn:A; rewrite above_is in A by assumption; revert A;
  comparisons. Qed.
Lemma above_greater x y z : finite x -> finite y -> finite z -> above (greater_of x y) z = above x z || above y z.
Proof. intros X Y Z. unfold greater_of. destruct (above x y) eqn:A; rewrite above_is in A by assumption; revert A;
  comparisons. Qed.
Lemma below_greater x y z : finite x -> finite y -> finite z -> above z (greater_of x y) = above z x && above z y.
Proof. intros X Y Z. unfold greater_of. destruct (above x y) eqn:A; rewrite above_is in A by assumption; revert A;
  comparisons. Qed.

(* The sign that a value has beyond the bound. *)
Definition side_of z b := (above z b, above (minus (number 0 0) b) z).
Lemma side_says z b t : signed z b t -> finite z -> finite b -> 0 <= value b ->
  sign_at t (fst (side_of z b)) (snd (side_of z b)).
Proof.
intros S Z B P. destruct (opposite_is b B) as [O V]. unfold side_of. cbn [fst snd].
assert (F : finite (size z)) by now destruct z. assert (E : value (size z) = Rabs (value z)) by apply B2R_Babs.
destruct (sign_value z) as [S1 S2].
split; intros A; apply above_finite in A; try assumption.
- destruct S as [_ S]; [apply above_finite; try assumption; rewrite E, Rabs_right; lra|]. apply S. unfold negative_lane.
  destruct (Bsign z); [specialize (S1 eq_refl); lra|reflexivity].
- rewrite V in A. destruct S as [S _]; [apply above_finite; try assumption; rewrite E, Rabs_left; lra|]. apply S.
  unfold negative_lane.
  destruct (Bsign z); [reflexivity|specialize (S2 eq_refl); lra].
Qed.
Lemma edges_say ab bc ca b : finite ab -> finite bc -> finite ca -> finite b ->
  let least := lesser (lesser ab bc) ca in let greatest := greater_of (greater_of ab bc) ca in
  let other := minus (number 0 0) b in
  above least b || above other greatest = on_one_side (side_of ab b) (side_of bc b) (side_of ca b) /\
  above greatest b && above other least = on_both_sides (side_of ab b) (side_of bc b) (side_of ca b).
Proof.
intros AB BC CA B. cbv zeta. destruct (opposite_is b B) as [O _]. destruct (finite_lesser _ _ AB BC) as [L G].
rewrite !above_lesser, !below_greater, !above_greater, !below_lesser by assumption. split; reflexivity.
Qed.
(* The sign of a value that is certain. *)
Definition sign_of z := (negb (negative_lane z), negative_lane z).
Definition turned (s : bool * bool) := (snd s, fst s).
Lemma certain_says z b t : signed z b t -> above (size z) b = true -> sign_at t (fst (sign_of z)) (snd (sign_of z)).
Proof.
intros S A. destruct (S A) as [N P]. unfold sign_of. cbn [fst snd].
split; intros K; [apply P; now apply negb_true_iff|now apply N].
Qed.
Lemma known_sign z : known_side (sign_of z) = true.
Proof. unfold known_side, sign_of. cbn [fst snd]. now destruct (negative_lane z). Qed.
Lemma known_turned z : known_side (turned (sign_of z)) = true.
Proof. unfold known_side, turned, sign_of. cbn [fst snd]. now destruct (negative_lane z). Qed.
Lemma known_dot a1 a2 a3 b1 b2 b3 : known (lane_dot a1 a2 a3 b1 b2 b3) -> Forall known [a1; a2; a3; b1; b2; b3].
Proof. unfold lane_dot. intros K. knowns. repeat constructor; assumption. Qed.
Lemma apart_is x y : xorb (negative_lane x) (negative_lane y) = beside (turned (sign_of x)) (sign_of y).
Proof. unfold beside, turned, sign_of. cbn [fst snd]. now destruct (negative_lane x), (negative_lane y). Qed.
Ltac displaced := refine (conj _ (conj _ (conj _ _))); [assumption|apply entry_minus; assumption..].
Ltac all_known := repeat match goal with
  | H : known (lane_dot _ _ _ _ _ _) |- _ => apply known_dot in H; repeat apply Forall_cons_iff in H as [? H];
    clear H end;
  knowns.
Ltac by_ring := match goal with W : sign_at ?x _ _ |- sign_at ?y _ _ => replace y with x; [exact W|] end;
  cbn [det]; unfold volume, rise, face_exact; ring.
Ltac all_finite := repeat match goal with
  | H : Forall (fun x : float => finite x /\ _) _ |- _ => repeat apply Forall_cons_iff in H as [[? ?] H]; clear H end.

(* Where it answers none, no point of the segment is in the triangle; where a point, exactly one is, inside of both. *)
Theorem lane_segment_triangle_right fused (px py pz qx qy qz ax ay az bx by_ bz cx cy cz : float) :
  let '(known, set) := lane_segment_triangle fused px py pz qx qy qz ax ay az bx by_ bz cx cy cz in
  let is_common := common (fun t => 0 <= t <= 1) px py pz (qx - px) (qy - py) (qz - pz) ax ay az bx by_ bz cx cy cz in
  known = true -> Forall finite [px; py; pz; qx; qy; qz; ax; ay; az; bx; by_; bz; cx; cy; cz] /\
  (set = true -> exists t, 0 < t < 1 /\ (exists i j k, 0 < i /\ 0 < j /\ 0 < k /\ is_common t i j k) /\
    forall t' i j k, is_common t' i j k -> t' = t) /\
  (set = false -> forall t i j k, ~ is_common t i j k).
Proof.
unfold lane_segment_triangle. set (x0 := minus qx px). set (y0 := minus qy py). set (z0 := minus qz pz).
set (x1 := minus ax px). set (y1 := minus ay py). set (z1 := minus az pz).
set (x2 := minus bx px). set (y2 := minus by_ py). set (z2 := minus bz pz).
set (x3 := minus cx px). set (y3 := minus cy py). set (z3 := minus cz pz). cbv zeta.
match goal with |- context [lane_moderate ?x ?y ?z] => set (X := x); set (Y := y); set (Z := z) end.
set (b := lane_bound_of fused X Y Z).
match goal with |- context [minus (plus ?x ?y) (plus ?z ?h)] =>
  set (ab := x); set (bc := y); set (ac := z); set (height := h) end.
set (beyond := minus (plus ab bc) (plus ac height)).
intros [[[M A1]%andb_prop A2]%andb_prop K]%andb_prop.
assert (KH := known_above _ _ A1). assert (KB := known_above _ _ A2). unfold beyond in KB. knowns.
assert (KA : known ab) by assumption. unfold ab in KA. unfold height in KH. all_known.
assert (LX : largest X [x0; x1; x2; x3]) by (repeat apply (largest_greater _ _ [_; _] [_; _]);
  apply (largest_greater _ _ [_] [_]); now apply largest_size).
assert (LY : largest Y [y0; y1; y2; y3]) by (repeat apply (largest_greater _ _ [_; _] [_; _]);
  apply (largest_greater _ _ [_] [_]); now apply largest_size).
assert (LZ : largest Z [z0; z1; z2; z3]) by (repeat apply (largest_greater _ _ [_; _] [_; _]);
  apply (largest_greater _ _ [_] [_]); now apply largest_size).
destruct (moderate_says _ _ _ (proj1 LX) (proj1 LY) (proj1 LZ) M) as (SX & SY & SZ).
destruct (volume_bound fused X Y Z SX SY SZ) as [FB B]. fold b in FB, B. set (U := units X Y Z) in *.
assert (T := units_three _ _ _ SX SY SZ). assert (R := total_room _ _ _ _ _ _ _ _ _ T T T).
change (0 <= total U U U <= room / 128) in R. set (E := total U U U) in *.
destruct LX as [_ LX], LY as [_ LY], LZ as [_ LZ].
specialize (LX (proj1 (proj1 SX))). specialize (LY (proj1 (proj1 SY))). specialize (LZ (proj1 (proj1 SZ))).
clearbody X Y Z. all_finite.
assert (V0 : vector (x0, y0, z0) (qx - px, qy - py, qz - pz) U) by displaced.
assert (V1 : vector (x1, y1, z1) (ax - px, ay - py, az - pz) U) by displaced.
assert (V2 : vector (x2, y2, z2) (bx - px, by_ - py, bz - pz) U) by displaced.
assert (V3 : vector (x3, y3, z3) (cx - px, cy - py, cz - pz) U) by displaced.
assert (PB : 0 <= value b).
{ apply Rle_trans with (2 := B). pose proof v_small. pose proof (bpow_gt_0 radix2 (-700)).
  assert (0 <= v * E) by (apply Rmult_le_pos; lra). lra. }
assert (JAB := det_says _ _ _ _ _ _ _ _ _ V0 V1 V2 : one_volume E ab _).
assert (JAC := det_says _ _ _ _ _ _ _ _ _ V0 V1 V3 : one_volume E ac _).
assert (JBC := det_says _ _ _ _ _ _ _ _ _ V2 V3 V0 : one_volume E bc _).
assert (JH := det_says _ _ _ _ _ _ _ _ _ V2 V3 V1 : one_volume E height _).
assert (S4 := signed_four_minus E R b FB B _ _ _ _ (volumes_plus E R _ _ _ _ JAB JBC)
  (volumes_plus E R _ _ _ _ JAC JH)).
assert (F : Forall finite [px; py; pz; qx; qy; qz; ax; ay; az; bx; by_; bz; cx; cy; cz]).
{ repeat match goal with H : finite ?x |- _ => unfold x in H; apply minus_finite in H as (? & ? & _) end.
  repeat constructor; assumption. }
split; [exact F|]. clear F. assert (JCA := lane_opposite _ _ _ _ JAC : one_volume E (minus (number 0 0) ac) _).
destruct (edges_say ab bc (minus (number 0 0) ac) b (proj1 JAB) (proj1 JBC) (proj1 JCA) FB) as [EI EO].
rewrite EI, EO, apart_is in *. clear EI EO.
assert (S1 : forall z t, one_volume E z t -> signed z b t) by (intros; apply (signed_one E R b FB 42);
  [exact B|lra|assumption]).
assert (S : signs_of_segment px py pz (qx - px) (qy - py) (qz - pz) ax ay az bx by_ bz cx cy cz (side_of ab b)
  (side_of bc b)
  (side_of (minus (number 0 0) ac) b) (turned (sign_of height)) (sign_of beyond)).
{ split; [split; [|split; [|split]]|].
  - assert (W := side_says _ _ _ (S1 _ _ JAB) (proj1 JAB) FB PB). by_ring.
  - assert (W := side_says _ _ _ (S1 _ _ JBC) (proj1 JBC) FB PB). by_ring.
  - assert (W := side_says _ _ _ (S1 _ _ JCA) (proj1 JCA) FB PB). by_ring.
  - apply sign_opposite. assert (W := certain_says _ _ _ (S1 _ _ JH) A1). by_ring.
  - assert (W := certain_says _ _ _ S4 A2). by_ring. }
assert (KP := known_turned height). assert (KQ := known_sign beyond). clear - S K KP KQ.
split; intros C.
- apply andb_prop in C as [I A]. apply negb_true_iff in A. exact (segment_crosses _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _
    _ _ S KP KQ I A).
- intros t i j k. apply (segment_passes _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ t i j k S).
  apply orb_true_iff. apply orb_prop in K as [[K|K]%orb_prop|K]; auto.
  apply andb_false_iff in C as [C|C]; [congruence|].
  right. now apply negb_false_iff.
Qed.

(* The same of a ray, which has an origin and a direction; the direction is not 0. *)
Theorem lane_ray_triangle_right fused (px py pz wx wy wz ax ay az bx by_ bz cx cy cz : float) :
  let '(known, set) := lane_ray_triangle fused px py pz wx wy wz ax ay az bx by_ bz cx cy cz in
  let is_common := common (fun t => 0 <= t) px py pz wx wy wz ax ay az bx by_ bz cx cy cz in
  known = true -> Forall finite [px; py; pz; wx; wy; wz; ax; ay; az; bx; by_; bz; cx; cy; cz] /\
  ~ (value wx = 0 /\ value wy = 0 /\ value wz = 0) /\
  (set = true -> exists t, 0 < t /\ (exists i j k, 0 < i /\ 0 < j /\ 0 < k /\ is_common t i j k) /\
    forall t' i j k, is_common t' i j k -> t' = t) /\
  (set = false -> forall t i j k, ~ is_common t i j k).
Proof.
unfold lane_ray_triangle.
set (x1 := minus ax px). set (y1 := minus ay py). set (z1 := minus az pz).
set (x2 := minus bx px). set (y2 := minus by_ py). set (z2 := minus bz pz).
set (x3 := minus cx px). set (y3 := minus cy py). set (z3 := minus cz pz). cbv zeta.
match goal with |- context [lane_bound_of _ ?x ?y ?z] => set (X := x); set (Y := y); set (Z := z) end.
set (c := lane_bound_of fused X Y Z).
match goal with |- context [multiply_add fused ?s ?k ?l] => set (b := multiply_add fused s k l) end.
match goal with |- context [minus (plus ?x ?y) ?z] => set (ab := x); set (bc := y); set (ac := z) end.
match goal with |- context [above (size ?h) c] => set (height := h) end.
set (way := minus (plus ab bc) ac).
intros [[[M A1]%andb_prop A2]%andb_prop K]%andb_prop.
assert (KH := known_above _ _ A1). assert (KB := known_above _ _ A2). unfold way in KB. knowns.
assert (KA : known ab) by assumption. unfold ab in KA. unfold height in KH. all_known.
assert (LX : largest X [x1; x2; x3]) by (apply (largest_greater _ _ [_; _] [_]); [apply (largest_greater _ _ [_] [_])|];
  now apply largest_size).
assert (LY : largest Y [y1; y2; y3]) by (apply (largest_greater _ _ [_; _] [_]); [apply (largest_greater _ _ [_] [_])|];
  now apply largest_size).
assert (LZ : largest Z [z1; z2; z3]) by (apply (largest_greater _ _ [_; _] [_]); [apply (largest_greater _ _ [_] [_])|];
  now apply largest_size).
assert (LP : largest (size wx) [wx]) by now apply largest_size.
assert (LQ : largest (size wy) [wy]) by now apply largest_size.
assert (LR : largest (size wz) [wz]) by now apply largest_size.
destruct (moderate_says _ _ _ (magnitude_greater _ _ (proj1 LX) (proj1 LP)) (magnitude_greater _ _ (proj1 LY)
  (proj1 LQ))
  (magnitude_greater _ _ (proj1 LZ) (proj1 LR)) M) as (SX & SY & SZ).
apply sized_parts in SX as [SX SP]; [|apply LX|apply LP]. apply sized_parts in SY as [SY SQ]; [|apply LY|apply LQ].
apply sized_parts in SZ as [SZ SR]; [|apply LZ|apply LR].
destruct (volume_bound fused X Y Z SX SY SZ) as [FC C]. fold c in FC, C.
destruct (ray_bound fused _ _ _ X Y Z SP SQ SR SX SY SZ) as (FB & B & EW). fold b in FB, B.
set (U := units X Y Z) in *. set (W := units (size wx) (size wy) (size wz)) in *.
assert (T := units_three _ _ _ SX SY SZ). assert (TW := units_three _ _ _ SP SQ SR).
assert (R := total_room _ _ _ _ _ _ _ _ _ T T T). change (0 <= total U U U <= room / 128) in R.
assert (RW := total_room _ _ _ _ _ _ _ _ _ TW T T). change (0 <= total W U U <= room / 128) in RW.
destruct LX as [_ LX], LY as [_ LY], LZ as [_ LZ], LP as [_ LP], LQ as [_ LQ], LR as [_ LR].
specialize (LX (proj1 (proj1 SX))). specialize (LY (proj1 (proj1 SY))). specialize (LZ (proj1 (proj1 SZ))).
specialize (LP (proj1 (proj1 SP))). specialize (LQ (proj1 (proj1 SQ))). specialize (LR (proj1 (proj1 SR))).
clearbody X Y Z. all_finite.
assert (V0 : vector (wx, wy, wz) (value wx, value wy, value wz) W)
  by (refine (conj TW (conj _ (conj _ _))); apply entry_given; assumption).
assert (V1 : vector (x1, y1, z1) (ax - px, ay - py, az - pz) U) by displaced.
assert (V2 : vector (x2, y2, z2) (bx - px, by_ - py, bz - pz) U) by displaced.
assert (V3 : vector (x3, y3, z3) (cx - px, cy - py, cz - pz) U) by displaced.
assert (PB : 0 <= value b).
{ apply Rle_trans with (2 := B). pose proof v_small. pose proof (bpow_gt_0 radix2 (-700)).
  assert (0 <= v * total W U U) by (apply Rmult_le_pos; lra). lra. }
set (E := total W U U) in *.
assert (JAB := det_says _ _ _ _ _ _ _ _ _ V0 V1 V2 : one_volume E ab _).
assert (JAC := det_says _ _ _ _ _ _ _ _ _ V0 V1 V3 : one_volume E ac _).
assert (JBC := det_says _ _ _ _ _ _ _ _ _ V2 V3 V0). rewrite EW in JBC. change (one_volume E bc
  (det (bx - px, by_ - py, bz - pz) (cx - px, cy - py, cz - pz) (value wx, value wy, value wz))) in JBC.
assert (JH := det_says _ _ _ _ _ _ _ _ _ V2 V3 V1 : one_volume (total U U U) height _).
assert (JCA := lane_opposite _ _ _ _ JAC : one_volume E (minus (number 0 0) ac) _).
assert (S3 := signed_three E RW b FB _ _ _ _ B (volumes_plus E RW _ _ _ _ JAB JBC) JAC).
assert (S1 : forall z t, one_volume E z t -> signed z b t)
  by (intros; apply (signed_one E RW b FB 31); [exact B|lra|assumption]).
assert (SH := signed_one _ R c FC 42 _ _ C ltac:(lra) JH).
destruct (edges_say ab bc (minus (number 0 0) ac) b (proj1 JAB) (proj1 JBC) (proj1 JCA) FB) as [EI EO].
rewrite EI, EO, apart_is in *. clear EI EO.
assert (S : signs_of_ray px py pz wx wy wz ax ay az bx by_ bz cx cy cz (side_of ab b) (side_of bc b)
  (side_of (minus (number 0 0) ac) b) (turned (sign_of height)) (sign_of way)).
{ split; [split; [|split; [|split]]|].
  - assert (G := side_says _ _ _ (S1 _ _ JAB) (proj1 JAB) FB PB). by_ring.
  - assert (G := side_says _ _ _ (S1 _ _ JBC) (proj1 JBC) FB PB). by_ring.
  - assert (G := side_says _ _ _ (S1 _ _ JCA) (proj1 JCA) FB PB). by_ring.
  - apply sign_opposite. assert (G := certain_says _ _ _ SH A1). by_ring.
  - assert (G := certain_says _ _ _ S3 A2). by_ring. }
split.
{ repeat match goal with H : finite ?x |- _ => unfold x in H; apply minus_finite in H as (? & ? & _) end.
  repeat constructor; assumption. }
assert (KP := known_turned height). assert (KQ := known_sign way). clear - S K KP KQ. split.
{ intros (Z1 & Z2 & Z3). destruct S as [_ S]. rewrite Z1, Z2, Z3 in S. destruct S as [P N].
  replace (rise ax ay az bx by_ bz cx cy cz 0 0 0) with 0 in P, N by (unfold rise, face_exact; ring).
  apply orb_prop in KQ as [Q|Q]; [specialize (P Q)|specialize (N Q)]; lra. }
split; intros C.
- apply andb_prop in C as [I A]. apply negb_true_iff in A. exact (ray_crosses _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _
    S KP KQ I A).
- intros t i j k. apply (ray_passes _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ t i j k S).
  apply orb_true_iff. apply orb_prop in K as [[K|K]%orb_prop|K]; auto.
  apply andb_false_iff in C as [C|C]; [congruence|].
  right. now apply negb_false_iff.
Qed.
