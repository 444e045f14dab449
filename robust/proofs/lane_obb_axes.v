(* SPDX-License-Identifier: Apache-2.0 *)
(* Two boxes with any half axes in a lane: axes that are exactly zero, and all axes together. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import zonotope obb.
From Filters Require Import model constants steps format floats ghost lanes.
From Filters Require Import lane_bounds lane_filters lane_turns lane_values lane_sums lane_segments lane_boxes.
From Filters Require Import lane_shape_filters lane_faces lane_ray_box lane_moderate lane_solid_filters lane_obb.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.
#[local] Existing Instances p53 fexp_valid below_1024.
#[local] Opaque plus minus times multiply_add.

(* An exact zero: no product of two coordinates but 0, or edges that are equal or opposite. *)
Lemma equal_zero x : equal x zero = true -> finite x /\ value x = 0.
Proof.
intros E. destruct zero_is as [Z V]. assert (F : finite x) by (destruct x as [|[]| |]; easy).
split; [exact F|]. unfold equal in E. rewrite Bcompare_correct in E by assumption. revert E.
change (@B2R 53 1024) with value. rewrite V. destruct (Rcompare_spec (value x) 0); easy.
Qed.
Lemma no_extent (x y z : float) : equal (plus (plus (size x) (size y)) (size z)) zero = true ->
  value x = 0 /\ value y = 0 /\ value z = 0.
Proof.
intros [F V]%equal_zero. destruct (extent_least x y z F) as (X & Y & Z). unfold extent in *. rewrite V in *.
assert (K : forall r, Rabs r <= 0 -> r = 0).
{ intros r L. destruct (Req_dec r 0) as [E|N]; [exact E|]. apply Rabs_pos_lt in N. lra. }
auto.
Qed.
Lemma sum_zero (x y : float) : value (plus x y) = 0 -> finite (plus x y) -> x + y = 0.
Proof.
intros E F. destruct (plus_finite _ _ F) as (_ & _ & V). rewrite V in E.
destruct (rnd_sum x y (held_value _) (held_value _)) as (e & B & R). rewrite R in E. apply abs_le in B.
pose proof v_small. apply Rmult_integral in E as [E|E]; lra.
Qed.
Lemma difference_zero (x y : float) : value (minus x y) = 0 -> finite (minus x y) -> x - y = 0.
Proof.
intros E F. destruct (minus_finite _ _ F) as (_ & _ & V). rewrite V in E.
destruct (rnd_difference x y (held_value _) (held_value _)) as (e & B & R). rewrite R in E. apply abs_le in B.
pose proof v_small. apply Rmult_integral in E as [E|E]; lra.
Qed.
Definition no_cross ex ey ez fx fy fz :=
  ey * fz - ez * fy = 0 /\ ez * fx - ex * fz = 0 /\ ex * fy - ey * fx = 0.
Lemma zero_right (ex ey ez fx fy fz : float) : finite ex -> finite ey -> finite ez -> finite fx -> finite fy ->
  finite fz -> lane_obb_zero ex ey ez fx fy fz = true -> no_cross ex ey ez fx fy fz.
Proof.
intros EX EY EZ FX FY FZ. cbv beta zeta delta [lane_obb_zero]. intros [[Z|Z]%orb_prop|Z]%orb_prop.
- apply equal_zero in Z as [_ Z].
  assert (S : forall x, finite x -> finite (size x) /\ value (size x) = Rabs x)
    by (intros x X; split; [now destruct x|apply size_value]).
  destruct (S ex EX) as [SEX VEX]. destruct (S ey EY) as [SEY VEY]. destruct (S ez EZ) as [SEZ VEZ].
  destruct (S fx FX) as [SFX VFX]. destruct (S fy FY) as [SFY VFY]. destruct (S fz FZ) as [SFZ VFZ]. clear S.
  destruct (lesser_value _ _ SEY SFZ) as [L1 V1]. destruct (lesser_value _ _ SEZ SFY) as [L2 V2].
  destruct (lesser_value _ _ SEZ SFX) as [L3 V3]. destruct (lesser_value _ _ SEX SFZ) as [L4 V4].
  destruct (lesser_value _ _ SEX SFY) as [L5 V5]. destruct (lesser_value _ _ SEY SFX) as [L6 V6].
  destruct (greater_value _ _ L1 L2) as [G1 W1]. destruct (greater_value _ _ L3 L4) as [G2 W2].
  destruct (greater_value _ _ L5 L6) as [G3 W3]. destruct (greater_value _ _ G2 G3) as [G4 W4].
  destruct (greater_value _ _ G1 G4) as [_ W5]. rewrite W5, W1, W4, W2, W3, V1, V2, V3, V4, V5, V6 in Z.
  rewrite VEX, VEY, VEZ, VFX, VFY, VFZ in Z. clear - Z.
  assert (M : forall a b, Rmax a b <= 0 -> a <= 0 /\ b <= 0)
    by (intros a b L; pose proof (Rmax_l a b); pose proof (Rmax_r a b); lra).
  assert (P : forall a b, Rmin (Rabs a) (Rabs b) <= 0 -> a * b = 0).
  { intros a b L. assert (Q : a = 0 \/ b = 0); [|destruct Q as [->| ->]; ring].
    destruct (Req_dec a 0) as [A|A]; [now left|right]. destruct (Req_dec b 0) as [B|B]; [exact B|exfalso].
    apply Rabs_pos_lt in A, B. revert L. apply Rlt_not_le. now apply Rmin_glb_lt. }
  destruct (M _ _ (Req_le _ _ Z)) as [[A1%P A2%P]%M [[A3%P A4%P]%M [A5%P A6%P]%M]%M].
  unfold no_cross. lra.
- assert (F : finite (plus (plus (size (plus ex fx)) (size (plus ey fy))) (size (plus ez fz))))
    by now apply equal_zero in Z.
  apply no_extent in Z as (X & Y & Z). finites. apply sum_zero in X, Y, Z; try assumption. unfold no_cross.
  replace (value fx) with (- ex) by lra. replace (value fy) with (- ey) by lra. replace (value fz) with (- ez) by lra.
  repeat split; ring.
- assert (F : finite (plus (plus (size (minus ex fx)) (size (minus ey fy))) (size (minus ez fz))))
    by now apply equal_zero in Z.
  apply no_extent in Z as (X & Y & Z). finites. apply difference_zero in X, Y, Z; try assumption. unfold no_cross.
  replace (value fx) with (value ex) by lra. replace (value fy) with (value ey) by lra.
  replace (value fz) with (value ez) by lra. repeat split; ring.
Qed.

Section Boxes.
Variables (fused : bool) (x y z : nat -> float) (ax ay az bx by_ bz : float).
Notation wx := (minus bx ax).
Notation wy := (minus by_ ay).
Notation wz := (minus bz az).
Notation sum := (lane_obb.sum x y z ax ay az bx by_ bz).
Notation error := (lane_obb.error fused x y z ax ay az bx by_ bz).
Notation gap := (lane_obb.gap x y z ax ay az bx by_ bz).
Notation gap_exact := (lane_obb.gap_exact x y z ax ay az bx by_ bz).

(* One axis. *)
Notation an_axis := (nat * nat * (nat * nat * nat * nat))%type.
Definition separates (a : an_axis) := let '(e, f, (p, q, r, s)) := a in gap_exact e f p q r s > 0.
Definition overlaps (a : an_axis) := let '(e, f, (p, q, r, s)) := a in
  no_cross (x e) (y e) (z e) (x f) (y f) (z f) \/ gap_exact e f p q r s < 0.
Definition proper (a : an_axis) := let '(e, f, (p, q, r, s)) := a in
  (e < 6)%nat /\ (f < 6)%nat /\ different (four p q r s) /\ rest e f (four p q r s).
Lemma axis_right others e f p q r s apart meets : finite sum -> proper (e, f, (p, q, r, s)) ->
  let '(apart', meets') := lane_obb_axis fused others x y z wx wy wz sum e f p q r s apart meets in
  (apart' = true -> apart = true \/ separates (e, f, (p, q, r, s))) /\ (apart' = false -> apart = false) /\
  (apart' = false -> meets' = true -> meets = true /\ overlaps (e, f, (p, q, r, s))).
Proof.
intros FS (IE & IF & D & _).
change (lane_obb_axis fused others x y z wx wy wz sum e f p q r s apart meets) with
  (let apart1 := apart || above (gap e f p q r s) (error e f) in
   let here := above (minus zero (gap e f p q r s)) (error e f) in
   (apart1, meets && (here || negb (others && (apart1 || here)) && lane_obb_zero (x e) (y e) (z e) (x f) (y f) (z
     f)))).
cbv zeta. assert (UB : up (error e f)) by (apply up_bound; [apply up_sizes|lia]).
pose proof (gap_right fused x y z ax ay az bx by_ bz e f p q r s FS IE IF D) as G.
split; [|split].
- intros [A|A]%orb_prop; [now left|right]. pose proof (above_bound _ _ A UB) as FB.
  destruct (above_itself _ _ A UB FB) as [A' N]. exact (proj2 (G A') N).
- now intros [A _]%orb_false_elim.
- intros NA [M Q]%andb_prop. split; [exact M|]. apply orb_prop in Q as [Q|Q].
  + right. pose proof (above_bound _ _ Q UB) as FB. destruct (above_opposite _ _ Q UB FB) as [A' N].
    exact (proj1 (G A') N).
  + left. apply andb_prop in Q as [_ Q]. destruct (sum_parts x y z ax ay az bx by_ bz FS) as [_ FE].
    destruct (edge_finite x y z e (FE e IE)) as (X & Y & Z).
    destruct (edge_finite x y z f (FE f IF)) as (X' & Y' & Z'). now apply zero_right.
Qed.

(* All axes. Where a loop ends because all lanes are apart, this one is. *)
Lemma axes_right others ends l : finite sum -> Forall proper l -> forall apart meets,
  let '(apart', meets') := lane_obb_axes fused others ends x y z wx wy wz sum l apart meets in
  (apart' = true -> apart = true \/ Exists separates l) /\ (apart' = false -> apart = false) /\
  (apart' = false -> meets' = true -> meets = true /\ Forall overlaps l).
Proof.
intros FS. induction l as [|[[e f] [[[p q] r] s]] l IH]; intros P apart meets; cbn [lane_obb_axes].
- repeat split; auto.
- apply Forall_cons_iff in P as [P Q].
  pose proof (axis_right (others (length l)) e f p q r s apart meets FS P) as A.
  revert A. destruct (lane_obb_axis fused (others (length l)) x y z wx wy wz sum e f p q r s apart meets) as [apart1
    meets1].
  intros (A1 & A2 & A3). destruct (apart1 && ends (length l)) eqn:B.
  + apply andb_prop in B as [-> _]. split; [|split; discriminate]. intros _.
    destruct (A1 eq_refl) as [K|K]; [now left|right]. now apply Exists_cons_hd.
  + specialize (IH Q apart1 meets1). revert IH.
    destruct (lane_obb_axes fused others ends x y z wx wy wz sum l apart1 meets1) as [apart2 meets2].
    intros (I1 & I2 & I3). split; [|split].
    * intros K. destruct (I1 K) as [K1|K1]; [|right; now apply Exists_cons_tl].
      destruct (A1 K1) as [K2|K2]; [now left|right]. now apply Exists_cons_hd.
    * auto.
    * intros K M. destruct (I3 K M) as [M1 O]. destruct (A3 (I2 K) M1) as [M2 O2]. split; [exact M2|].
      now apply Forall_cons.
Qed.
Lemma table_proper : Forall proper lane_obb_table.
Proof.
unfold lane_obb_table. repeat (apply Forall_cons; [|]); [..|apply Forall_nil].
all: unfold proper; cbv beta iota; (split; [lia|]; split; [lia|]; split;
  [split; [intros k K; do 4 (destruct k as [|k]; [cbn; lia|]); lia
          |intros k l K; do 4 (destruct k as [|k]; [do 4 (destruct l as [|l]; [first [lia|cbn; lia]|]); lia|]); lia]
  |intros k K; do 6 (destruct k as [|k];
     [first [left; reflexivity|right; left; reflexivity|right; right; exists 0%nat; split; [lia|reflexivity]
            |right; right; exists 1%nat; split; [lia|reflexivity]|right; right; exists 2%nat; split; [lia|reflexivity]
            |right; right; exists 3%nat; split; [lia|reflexivity]]|]); lia]).
Qed.

(* Axes that overlap or are zero, each of two edges: the boxes have a common interior point. *)
Definition edge k := Vector (x k) (y k) (z k).
Definition edges := [edge 3; edge 4; edge 5; edge 0; edge 1; edge 2].
Definition way := Vector (bx - ax) (by_ - ay) (bz - az).
Definition shadows_meet a b := cross a b = origin \/ Rabs (dot (cross a b) way) < width edges (cross a b).
Lemma width_is n : width edges n = six (fun k => Rabs (dot n (edge k))).
Proof. unfold six. cbn [width edges]. ring. Qed.
Lemma along_is e f dx dy dz :
  along_exact x y z e f dx dy dz = dot (cross (edge e) (edge f)) (Vector dx dy dz).
Proof. reflexivity. Qed.
Lemma overlap_meets e f p q r s : proper (e, f, (p, q, r, s)) -> overlaps (e, f, (p, q, r, s)) ->
  shadows_meet (edge e) (edge f).
Proof.
intros (_ & _ & D & _) [(X & Y & Z)|L].
- left. unfold cross, origin. simpl. f_equal; assumption.
- right. rewrite width_is. unfold lane_obb.gap_exact, reach_exact in L. rewrite !along_is in L. fold way in L.
  pose proof (four_of_six (fun k => Rabs (dot (cross (edge e) (edge f)) (edge k))) (four p q r s)
    (fun k => Rabs_pos _) D) as Q. cbn [four nth] in Q. unfold edge at 3 6 9 12 in Q. lra.
Qed.
Lemma meet_swapped a b : shadows_meet a b -> shadows_meet b a.
Proof.
assert (E : forall d, dot (cross b a) d = - dot (cross a b) d) by (intros; coordinates).
intros [Z|L]; [left; now apply zonotope.opposite|right]. rewrite E, Rabs_Ropp. apply Rlt_le_trans with (1 := L).
  right.
rewrite !width_is. unfold six. rewrite !E, !Rabs_Ropp. reflexivity.
Qed.
Lemma all_meet : Forall overlaps lane_obb_table -> forall e f, (e < 6)%nat -> (f < 6)%nat ->
  shadows_meet (edge e) (edge f).
Proof.
intros O. assert (K : forall e f o, In (e, f, o) lane_obb_table -> shadows_meet (edge e) (edge f)).
{ intros e f [[[p q] r] s] I. apply (overlap_meets e f p q r s).
  - exact (proj1 (Forall_forall _ _) table_proper _ I).
  - exact (proj1 (Forall_forall _ _) O _ I). }
clear O. intros e f E F.
do 6 (destruct e as [|e]; [do 6 (destruct f as [|f]; [first
  [ left; unfold cross, origin; simpl; f_equal; ring
  | eapply K; unfold lane_obb_table; cbn [In]; repeat (first [left; reflexivity|right]); fail
  | apply meet_swapped; eapply K; unfold lane_obb_table; cbn [In]; repeat (first [left; reflexivity|right]); fail]|]);
  lia|]). lia.
Qed.
Lemma overlapping : dot (edge 0) (cross (edge 1) (edge 2)) <> 0 -> Forall overlaps lane_obb_table ->
  exists r, (forall k, Rabs (r k) < 1) /\ common_point x y z ax ay az bx by_ bz r.
Proof.
intros D O. assert (R : reaches edges way).
{ apply (in_space [edge 3; edge 4; edge 5] (edge 0) (edge 1) (edge 2) D). intros i j I J.
  assert (S : forall i, In i edges -> exists e, (e < 6)%nat /\ i = edge e).
  { intros k [<-|[<-|[<-|[<-|[<-|[<-|[]]]]]]]; eexists; (split; [|reflexivity]); lia. }
  destruct (S i I) as (e & E & ->). destruct (S j J) as (f & F & ->). exact (all_meet O e f E F). }
destruct (reaches_total _ _ R) as (r & B & T).
exists (fun k => match k with 0 => r 3 | 1 => r 4 | 2 => r 5 | 3 => - r 0 | 4 => - r 1 | _ => - r 2 end%nat).
split; [intros k; do 5 (destruct k as [|k]; [rewrite ?Rabs_Ropp; apply B|]); rewrite Rabs_Ropp; apply B|].
assert (X := f_equal vx T). assert (Y := f_equal vy T). assert (Z := f_equal vz T). simpl in X, Y, Z.
unfold common_point. split; [|split]; lra.
Qed.

Lemma boxes_right others ends :
  let '(apart, meets) := lane_obb_axes fused others ends x y z wx wy wz sum lane_obb_table false true in
  lane_obb_volume fused x y z sum 0 && lane_obb_volume fused x y z sum 3 && (apart || meets) = true ->
  finite sum /\ dot (edge 0) (cross (edge 1) (edge 2)) <> 0 /\ dot (edge 3) (cross (edge 4) (edge 5)) <> 0 /\
  (apart = true -> ~ exists r, (forall k, Rabs (r k) <= 1) /\ common_point x y z ax ay az bx by_ bz r) /\
  (apart = false -> exists r, (forall k, Rabs (r k) < 1) /\ common_point x y z ax ay az bx by_ bz r).
Proof.
destruct (lane_obb_axes fused others ends x y z wx wy wz sum lane_obb_table false true) as [apart meets] eqn:Q.
intros [[V0 V3]%andb_prop K]%andb_prop.
destruct (volume_right fused x y z ax ay az bx by_ bz 0 ltac:(lia) V0) as [FS D0].
destruct (volume_right fused x y z ax ay az bx by_ bz 3 ltac:(lia) V3) as [_ D3].
pose proof (axes_right others ends lane_obb_table FS table_proper false true) as A. rewrite Q in A.
destruct A as (A1 & _ & A3). rewrite along_is in D0, D3.
assert (V0' : dot (edge 0) (cross (edge 1) (edge 2)) <> 0).
{ intros E. apply D0. rewrite <- E. unfold edge. coordinates. }
assert (V3' : dot (edge 3) (cross (edge 4) (edge 5)) <> 0).
{ intros E. apply D3. rewrite <- E. unfold edge. coordinates. }
split; [exact FS|]. split; [exact V0'|]. split; [exact V3'|]. split.
- intros S. destruct (A1 S) as [N|N]; [discriminate N|]. apply Exists_exists in N as ([[e f] [[[p q] r] s]] & I & G).
  pose proof (proj1 (Forall_forall _ _) table_proper _ I) as (_ & _ & _ & R).
  exact (separated (fun k => value (x k)) (fun k => value (y k)) (fun k => value (z k)) ax ay az bx by_ bz e f
    (four p q r s) R G).
- intros S. rewrite S, orb_false_l in K. destruct (A3 S K) as [_ O]. now apply overlapping.
Qed.
End Boxes.

(* Where it answers, all numbers are finite, and the half axes of both boxes are independent; disjoint boxes have no
   common point, and overlapping ones a point in the interior of both. *)
Theorem lane_obb_obb_right fused others ends (ax ay az aux auy auz avx avy avz awx awy awz
    bx by_ bz bux buy buz bvx bvy bvz bwx bwy bwz : float) :
  let '(known, set) := lane_obb_obb fused others ends ax ay az aux auy auz avx avy avz awx awy awz
    bx by_ bz bux buy buz bvx bvy bvz bwx bwy bwz in
  known = true -> Forall finite [ax; ay; az; aux; auy; auz; avx; avy; avz; awx; awy; awz;
    bx; by_; bz; bux; buy; buz; bvx; bvy; bvz; bwx; bwy; bwz] /\
  volume aux auy auz avx avy avz awx awy awz <> 0 /\ volume bux buy buz bvx bvy bvz bwx bwy bwz <> 0 /\
  (set = true -> forall x y z, ~ (in_box at_most_1 ax ay az aux auy auz avx avy avz awx awy awz x y z /\
    in_box at_most_1 bx by_ bz bux buy buz bvx bvy bvz bwx bwy bwz x y z)) /\
  (set = false -> exists x y z, in_box less_than_1 ax ay az aux auy auz avx avy avz awx awy awz x y z /\
    in_box less_than_1 bx by_ bz bux buy buz bvx bvy bvz bwx bwy bwz x y z).
Proof.
cbv beta zeta delta [lane_obb_obb].
set (X := fun k => nth k [aux; avx; awx; bux; bvx; bwx] aux).
set (Y := fun k => nth k [auy; avy; awy; buy; bvy; bwy] auy).
set (Z := fun k => nth k [auz; avz; awz; buz; bvz; bwz] auz).
pose proof (boxes_right fused X Y Z ax ay az bx by_ bz others ends) as B.
fold (way_size ax ay az bx by_ bz). fold (lane_obb.sum X Y Z ax ay az bx by_ bz).
destruct (lane_obb_axes fused others ends X Y Z _ _ _ _ lane_obb_table false true) as [apart meets].
intros K. destruct (B K) as (FS & V0 & V3 & D & O). clear B K.
destruct (sum_parts X Y Z ax ay az bx by_ bz FS) as [FW FE]. destruct (way_finite ax ay az bx by_ bz FW) as (WX & WY
  & WZ).
split.
{ destruct (edge_finite X Y Z _ (FE 0%nat ltac:(lia))) as (E0 & E0' & E0'').
  destruct (edge_finite X Y Z _ (FE 1%nat ltac:(lia))) as (E1 & E1' & E1'').
  destruct (edge_finite X Y Z _ (FE 2%nat ltac:(lia))) as (E2 & E2' & E2'').
  destruct (edge_finite X Y Z _ (FE 3%nat ltac:(lia))) as (E3 & E3' & E3'').
  destruct (edge_finite X Y Z _ (FE 4%nat ltac:(lia))) as (E4 & E4' & E4'').
  destruct (edge_finite X Y Z _ (FE 5%nat ltac:(lia))) as (E5 & E5' & E5'').
  clear - WX WY WZ E0 E0' E0'' E1 E1' E1'' E2 E2' E2'' E3 E3' E3'' E4 E4' E4'' E5 E5' E5''.
  unfold X, Y, Z in *. cbn [nth] in *. finites. repeat constructor; assumption. }
split; [exact V0|]. split; [exact V3|]. split.
- intros S x y z [(r & s & t & R & R' & R'' & E & E' & E'') (r' & s' & t' & Q & Q' & Q'' & G & G' & G'')].
  apply (D S). exists (fun k => match k with 0 => r | 1 => s | 2 => t | 3 => r' | 4 => s' | _ => t' end%nat).
  split; [intros k; do 5 (destruct k as [|k]; [assumption|]); assumption|].
  unfold common_point, X, Y, Z. cbn [nth]. split; [|split]; lra.
- intros S. destruct (O S) as (r & R & C). unfold common_point, X, Y, Z in C. cbn [nth] in C.
  destruct C as (C1 & C2 & C3).
  exists (ax + r 0%nat * aux + r 1%nat * avx + r 2%nat * awx), (ay + r 0%nat * auy + r 1%nat * avy + r 2%nat * awy),
    (az + r 0%nat * auz + r 1%nat * avz + r 2%nat * awz).
  split; [exists (r 0%nat), (r 1%nat), (r 2%nat)|exists (r 3%nat), (r 4%nat), (r 5%nat)]; repeat (split; [apply R|]);
    auto.
Qed.
