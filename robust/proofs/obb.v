(* SPDX-License-Identifier: Apache-2.0 *)
(* ObbAxes of obb_filter.h: its constructor, its volumes and its axes. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Filters Require Import model constants filters steps ghost tactics tracked.
Open Scope R_scope.

(* v x w . d, its terms' magnitudes, and the size of a vector *)
Definition triple vx vy vz wx wy wz dx dy dz :=
  (vy * wz - vz * wy) * dx + (vz * wx - vx * wz) * dy + (vx * wy - vy * wx) * dz.
Definition terms vx vy vz wx wy wz dx dy dz := (Rabs vy * Rabs wz + Rabs vz * Rabs wy) * Rabs dx +
  (Rabs vz * Rabs wx + Rabs vx * Rabs wz) * Rabs dy + (Rabs vx * Rabs wy + Rabs vy * Rabs wx) * Rabs dz.
Definition size x y z := Rabs x + Rabs y + Rabs z.
Lemma size_pos x y z : 0 <= size x y z.
Proof. unfold size. pose proof (Rabs_pos x). pose proof (Rabs_pos y). pose proof (Rabs_pos z). lra. Qed.
Lemma terms_at_most vx vy vz wx wy wz dx dy dz :
  terms vx vy vz wx wy wz dx dy dz <= size vx vy vz * size wx wy wz * size dx dy dz.
Proof. unfold terms, size. units. Qed.
Lemma terms_pos vx vy vz wx wy wz dx dy dz : 0 <= terms vx vy vz wx wy wz dx dy dz.
Proof. unfold terms. magnitudes. positive_terms. Qed.

(* of six sizes, four different ones, or one *)
Definition six (f : nat -> R) := f 0%nat + f 1%nat + f 2%nat + (f 3%nat + f 4%nat + f 5%nat).
Definition different (others : nat -> nat) := (forall k, (k < 4)%nat -> (others k < 6)%nat) /\
  (forall k l, (k < l < 4)%nat -> others k <> others l).
Lemma four_of_six f others : (forall k, 0 <= f k) -> different others ->
  f (others 0%nat) + f (others 1%nat) + (f (others 2%nat) + f (others 3%nat)) <= six f.
Proof.
intros P [L D]. set (one := fun a i => if Nat.eqb a i then 1 else 0).
assert (pick : forall a, (a < 6)%nat -> f a = six (fun i => one a i * f i)).
{ intros a A. unfold six, one. do 6 (destruct a as [|a]; [simpl; lra|]). lia. }
assert (count : forall i,
  one (others 0%nat) i + one (others 1%nat) i + (one (others 2%nat) i + one (others 3%nat) i) <= 1).
{ intros i. pose proof (D 0 1 ltac:(lia))%nat. pose proof (D 0 2 ltac:(lia))%nat. pose proof (D 0 3 ltac:(lia))%nat.
  pose proof (D 1 2 ltac:(lia))%nat. pose proof (D 1 3 ltac:(lia))%nat. pose proof (D 2 3 ltac:(lia))%nat. unfold one.
  repeat match goal with |- context [Nat.eqb ?a i] => destruct (Nat.eqb_spec a i) end; first [lra|congruence]. }
rewrite (pick (others 0%nat)), (pick (others 1%nat)), (pick (others 2%nat)), (pick (others 3%nat)) by (apply L; lia).
assert (each : forall i, one (others 0%nat) i * f i + one (others 1%nat) i * f i +
  (one (others 2%nat) i * f i + one (others 3%nat) i * f i) <= f i).
{ intros i. specialize (count i). specialize (P i). pose proof (Rmult_le_compat_r _ _ _ P count). lra. }
pose proof (each 0%nat). pose proof (each 1%nat). pose proof (each 2%nat). pose proof (each 3%nat).
pose proof (each 4%nat). pose proof (each 5%nat). unfold six. clearbody one. lra.
Qed.
Definition rest v w (others : nat -> nat) :=
  forall k, (k < 6)%nat -> k = v \/ k = w \/ exists l, (l < 4)%nat /\ k = others l.
Lemma six_of_all f v w others : (forall k, 0 <= f k) -> f v = 0 -> f w = 0 -> rest v w others ->
  six f <= f (others 0%nat) + f (others 1%nat) + (f (others 2%nat) + f (others 3%nat)).
Proof.
intros P V W C. set (one := fun a i => if Nat.eqb a i then f i else 0).
assert (pick : forall a, six (one a) <= f a).
{ intros a. pose proof (P a). unfold six, one. do 6 (destruct a as [|a]; [simpl; lra|]). simpl. lra. }
assert (each : forall i, (i < 6)%nat -> f i <= one (others 0%nat) i + one (others 1%nat) i +
  (one (others 2%nat) i + one (others 3%nat) i)).
{ intros i I. assert (O : forall a, 0 <= one a i) by (intros a; unfold one; destruct (Nat.eqb a i); [apply P|lra]).
  pose proof (O (others 0%nat)). pose proof (O (others 1%nat)). pose proof (O (others 2%nat)).
  pose proof (O (others 3%nat)). destruct (C i I) as [->|[->|(l & L & ->)]]; [lra|lra|].
  assert (S : one (others l) (others l) = f (others l)) by (unfold one; now rewrite Nat.eqb_refl).
  do 4 (destruct l as [|l]; [lra|]). lia. }
pose proof (pick (others 0%nat)). pose proof (pick (others 1%nat)). pose proof (pick (others 2%nat)).
pose proof (pick (others 3%nat)). pose proof (each 0%nat ltac:(lia)). pose proof (each 1%nat ltac:(lia)).
pose proof (each 2%nat ltac:(lia)). pose proof (each 3%nat ltac:(lia)). pose proof (each 4%nat ltac:(lia)).
pose proof (each 5%nat ltac:(lia)). clearbody one. unfold six in *. lra.
Qed.
Lemma one_of_six f k : (forall k, 0 <= f k) -> (k < 6)%nat -> f k <= six f.
Proof.
intros P K. pose proof (P 0%nat). pose proof (P 1%nat). pose proof (P 2%nat). pose proof (P 3%nat).
pose proof (P 4%nat). pose proof (P 5%nat). unfold six. do 6 (destruct k as [|k]; [lra|]). lia.
Qed.

(* Boxes that an axis separates have no common point. *)
Definition common_point (x y z : nat -> R) ax ay az bx by_ bz (r : nat -> R) :=
  ax + r 0%nat * x 0%nat + r 1%nat * x 1%nat + r 2%nat * x 2%nat =
    bx + r 3%nat * x 3%nat + r 4%nat * x 4%nat + r 5%nat * x 5%nat /\
  ay + r 0%nat * y 0%nat + r 1%nat * y 1%nat + r 2%nat * y 2%nat =
    by_ + r 3%nat * y 3%nat + r 4%nat * y 4%nat + r 5%nat * y 5%nat /\
  az + r 0%nat * z 0%nat + r 1%nat * z 1%nat + r 2%nat * z 2%nat =
    bz + r 3%nat * z 3%nat + r 4%nat * z 4%nat + r 5%nat * z 5%nat.
Lemma separated (x y z : nat -> R) ax ay az bx by_ bz v w others : rest v w others ->
  let along := triple (x v) (y v) (z v) (x w) (y w) (z w) in
  let reach := fun k => Rabs (along (x (others k)) (y (others k)) (z (others k))) in
  Rabs (along (bx - ax) (by_ - ay) (bz - az)) -
    (reach 0%nat + reach 1%nat + (reach 2%nat + reach 3%nat)) > 0 ->
  ~ exists r, (forall k, Rabs (r k) <= 1) /\ common_point x y z ax ay az bx by_ bz r.
Proof.
intros C along reach Q (r & B & X & Y & Z). unfold reach in Q. clear reach.
pose proof (six_of_all (fun k => Rabs (along (x k) (y k) (z k))) v w others (fun k => Rabs_pos _)) as P. cbv beta in P.
specialize (P ltac:(replace (along _ _ _) with 0 by (unfold along, triple; ring); apply Rabs_R0)
  ltac:(replace (along _ _ _) with 0 by (unfold along, triple; ring); apply Rabs_R0) C).
enough (Rabs (along (bx - ax) (by_ - ay) (bz - az)) <= six (fun k => Rabs (along (x k) (y k) (z k)))) by lra.
replace (along (bx - ax) (by_ - ay) (bz - az)) with
  (r 0%nat * along (x 0%nat) (y 0%nat) (z 0%nat) + r 1%nat * along (x 1%nat) (y 1%nat) (z 1%nat) +
   r 2%nat * along (x 2%nat) (y 2%nat) (z 2%nat) - (r 3%nat * along (x 3%nat) (y 3%nat) (z 3%nat) +
   r 4%nat * along (x 4%nat) (y 4%nat) (z 4%nat) + r 5%nat * along (x 5%nat) (y 5%nat) (z 5%nat))).
2: { replace bx with (ax + r 0%nat * x 0%nat + r 1%nat * x 1%nat + r 2%nat * x 2%nat -
       (r 3%nat * x 3%nat + r 4%nat * x 4%nat + r 5%nat * x 5%nat)) by lra.
     replace by_ with (ay + r 0%nat * y 0%nat + r 1%nat * y 1%nat + r 2%nat * y 2%nat -
       (r 3%nat * y 3%nat + r 4%nat * y 4%nat + r 5%nat * y 5%nat)) by lra.
     replace bz with (az + r 0%nat * z 0%nat + r 1%nat * z 1%nat + r 2%nat * z 2%nat -
       (r 3%nat * z 3%nat + r 4%nat * z 4%nat + r 5%nat * z 5%nat)) by lra.
     unfold along, triple. ring. }
assert (one : forall k, Rabs (r k * along (x k) (y k) (z k)) <= Rabs (along (x k) (y k) (z k))).
{ intros k. rewrite Rabs_mult. pose proof (Rmult_le_compat_r _ _ _ (Rabs_pos (along (x k) (y k) (z k))) (B k)). lra. }
pose proof (abs_le _ _ (one 0%nat)). pose proof (abs_le _ _ (one 1%nat)). pose proof (abs_le _ _ (one 2%nat)).
pose proof (abs_le _ _ (one 3%nat)). pose proof (abs_le _ _ (one 4%nat)). pose proof (abs_le _ _ (one 5%nat)).
unfold six. apply le_abs. lra.
Qed.

(* rule (5): seven roundings that are not shared, fourteen in the bound *)
Lemma obb_enough u j T X : 0 < u <= 1/1024 -> (j <= 7)%nat -> 0 <= T <= X ->
  (1 + u) * ((1 + u) ^ j - 1) * T <= (1 - u) ^ 14 * (relative 16 384 u * X).
Proof.
intros Hu J [T0 TX]. assert (Hu' : 0 < u <= 1/16) by lra.
assert (E : (1 + u) * ((1 + u) ^ j - 1) <= (1 - u) ^ 14 * relative 16 384 u).
{ apply Rle_trans with ((1 + u) * ((1 + u) ^ 7 - 1)).
  - apply Rmult_le_compat_l; [lra|]. pose proof (upward_more u Hu' j 7 J). lra.
  - apply Rle_trans with ((1 - u) ^ 14 * (INR 7 * u + INR 384 * u * u)); [apply enough; simpl; lra|].
    apply Rmult_le_compat_l; [apply pow_le; lra|]. unfold relative. simpl. lra. }
assert (P : 0 <= (1 + u) * ((1 + u) ^ j - 1)) by (apply Rmult_le_pos; [lra|]; pose proof (upward u Hu' j); lra).
rewrite <- Rmult_assoc. now apply Rmult_le_compat.
Qed.

Section Obb.
Variable F : format.
Hypothesis G : fits F (quarter F) 1 1.
Notation H := (quarter F). Notation u := (u F). Notation n := (n F). Notation M := (reals F).
Notation tracked := (tracked F H). Notation least := (least F H). Notation small := (small H).
Let Hu : 0 < u <= 1/1024. Proof. destruct G. lra. Qed.

Definition m0 : Z := 1048.
Definition c1 := c_rounded 1 (c_product 1 1 0 m0 0 m0 + 1024 + (c_product 1 1 0 m0 0 m0 + 1024)).
Definition m1 := (up 1025 (m_product 1 1 m0 m0 + m_product 1 1 m0 m0) + 1)%Z.
Definition c2 c := let p := (c_product 1 1 c1 m1 c m0 + 1024)%Z in c_rounded 1 (c_rounded 1 (p + p) + 1024 + p).
Definition m2 := let p := m_product 1 1 m1 m0 in (up 1025 (up 1025 (p + p) + 1 + p) + 1)%Z.

(* a coordinate of a normal, and its product with another vector *)
Lemma coordinate a b c d p r z : small 1 m0 a -> small 1 m0 b -> small 1 m0 c -> small 1 m0 d ->
  mul M a b p -> mul M c d r -> sub M (Product a b p) (Product c d r) z ->
  tracked 1 c1 m1 2 z (a * b - c * d) (Rabs a * Rabs b + Rabs c * Rabs d).
Proof.
intros A B C D P R Z.
exact (tracked_sub F H G _ _ _ _ _ _ _ _ _ _ _ _ _ _ _
  (added_product F H G _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ (tracked_input F H _ _ A) (tracked_input F H _ _ B) P)
  (added_product F H G _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ (tracked_input F H _ _ C) (tracked_input F H _ _ D) R) eq_refl Z).
Qed.
Definition vector c j x y z x0 y0 z0 := tracked 0 c m0 j x x0 (Rabs x0) /\ tracked 0 c m0 j y y0 (Rabs y0) /\
  tracked 0 c m0 j z z0 (Rabs z0).
Definition normal vx vy vz wx wy wz x y z :=
  tracked 1 c1 m1 2 x (vy * wz - vz * wy) (Rabs vy * Rabs wz + Rabs vz * Rabs wy) /\
  tracked 1 c1 m1 2 y (vz * wx - vx * wz) (Rabs vz * Rabs wx + Rabs vx * Rabs wz) /\
  tracked 1 c1 m1 2 z (vx * wy - vy * wx) (Rabs vx * Rabs wy + Rabs vy * Rabs wx).
Lemma dot_once j c vx vy vz wx wy wz x y z dx dy dz d0x d0y d0z p q r s t :
  normal vx vy vz wx wy wz x y z -> vector c j dx dy dz d0x d0y d0z ->
  mul M x dx p -> mul M y dy q -> add M (Product x dx p) (Product y dy q) r -> mul M z dz s ->
  add M (Plain r) (Product z dz s) t ->
  rounded_once F H 2 (c2 c) (S (S (S (S j)))) t (triple vx vy vz wx wy wz d0x d0y d0z)
    (terms vx vy vz wx wy wz d0x d0y d0z) /\ small 3 m2 t.
Proof.
intros (X & Y & Z) (DX & DY & DZ) P Q R S' T.
pose proof (added_product F H G _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ X DX P) as AX.
pose proof (added_product F H G _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ Y DY Q) as AY.
pose proof (added_product F H G _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ Z DZ S') as AZ.
pose proof (tracked_sum F H G _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ AX AY (Nat.max_id _) R) as B.
split.
- refine (sum_once F H G _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ (added_plain F H G _ _ _ _ _ _ _ B) AZ _ T). lia.
- refine (proj1 (tracked_sum F H G _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ (added_plain F H G _ _ _ _ _ _ _ B) AZ _ T)).
  reflexivity.
Qed.
Lemma along_once j c vx vy vz wx wy wz x y z dx dy dz d0x d0y d0z p q r s t :
  normal vx vy vz wx wy wz x y z -> vector c j dx dy dz d0x d0y d0z ->
  mul M x dx p -> mul M y dy q -> add M (Product x dx p) (Product y dy q) r -> mul M z dz s ->
  add M (Plain r) (Product z dz s) t ->
  tracked 2 (c2 c) m2 (S (S (S (S (S j))))) (Rabs t) (Rabs (triple vx vy vz wx wy wz d0x d0y d0z))
    (terms vx vy vz wx wy wz d0x d0y d0z).
Proof.
intros N D P Q R S' T. destruct (dot_once _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ N D P Q R S' T) as [A B].
apply tracked_abs. now apply tracked_once.
Qed.
Lemma crossed vx vy vz wx wy wz p q r s t o x y z : vector 0 0 vx vy vz vx vy vz -> vector 0 0 wx wy wz wx wy wz ->
  mul M vy wz p -> mul M vz wy q -> sub M (Product vy wz p) (Product vz wy q) x ->
  mul M vz wx r -> mul M vx wz s -> sub M (Product vz wx r) (Product vx wz s) y ->
  mul M vx wy t -> mul M vy wx o -> sub M (Product vx wy t) (Product vy wx o) z -> normal vx vy vz wx wy wz x y z.
Proof.
intros ([VX _] & [VY _] & [VZ _]) ([WX _] & [WY _] & [WZ _]) P Q X R S Y T O Z.
split; [|split]; [apply (coordinate _ _ _ _ p q)|apply (coordinate _ _ _ _ r s)|apply (coordinate _ _ _ _ t o)];
  assumption.
Qed.

(* sizes *)
Definition c_size := c_rounded 1 (c_rounded 1 2048 + 2048).
Lemma size_least x y z t s : add M (Plain (Rabs x)) (Plain (Rabs y)) t -> add M (Plain t) (Plain (Rabs z)) s ->
  least 0 c_size 2 s (size x y z).
Proof.
intros S T. exact (least_sum F H G _ _ _ _ _ _ _ _ _ _ (least_sum F H G _ _ _ _ _ _ _ _ _ _ (least_input F H x)
  (least_input F H y) S) (least_input F H z) T).
Qed.
Definition c_way := c_rounded 1 (c_rounded 1 8196 + 1024 + 4098).
Lemma way_least ax ay az bx by_ bz x y z t s : sub M (Plain bx) (Plain ax) x -> sub M (Plain by_) (Plain ay) y ->
  sub M (Plain bz) (Plain az) z -> add M (Plain (Rabs x)) (Plain (Rabs y)) t ->
  add M (Plain t) (Plain (Rabs z)) s -> least 0 c_way 3 s (size (bx - ax) (by_ - ay) (bz - az)).
Proof.
intros X Y Z S T. exact (least_sum F H G _ _ _ _ _ _ _ _ _ _ (least_sum F H G _ _ _ _ _ _ _ _ _ _
  (least_difference F H G _ _ x X) (least_difference F H G _ _ y Y) S) (least_difference F H G _ _ z Z) T).
Qed.

(* the error bound of v x w, for a sum of sizes *)
Definition c_bound c := let p := c_product 1 1 (c_product 1 1 c_size m0 c_size m0) (m_product 1 1 m0 m0) c 1024 in
  c_rounded 1 (c_rounded 1 (up 9 (p + 1024)) + 1024 + 1024).
Lemma bound_of_axis c sv sw sum s t S pr qr z A B C : least 0 c_size 2 sv s -> small 1 m0 sv ->
  least 0 c_size 2 sw t -> small 1 m0 sw -> least 0 c 6 sum S -> small 1 1024 sum -> mul M sv sw pr ->
  mul M pr sum qr -> C = relative 16 384 u -> mul M C qr z -> A = 512 * (n * (H * H)) ->
  add M (Product C qr z) (Plain A) B -> bounding F H 2 512 (c_bound c) 13 B (relative 16 384 u * (s * t * S)).
Proof.
intros V BV W BW L BL P Q -> Z -> R.
apply (bound F H G 2 512 (relative 16 384 u) 9 _ 12 qr (s * t * S) z (512 * (n * (H * H))) B).
- refine (least_product F H G 1 _ _ _ _ _ 0 _ _ _ _ _ _ (least_product F H G 0 _ _ _ _ _ 0 _ _ _ _ _ _ V BV W BW P)
    _ L BL Q).
  exact (mul_small F H 1 1 G 0 _ _ 0 _ _ _ _ BV BW P eq_refl).
- destruct G. unfold relative, q. split; nra.
- exact Z.
- simpl. ring.
- lia.
- exact R.
Qed.

Section Axes.
Variables (x y z : nat -> R) (ax ay az bx by_ bz wx wy wz : R) (sizes : nat -> R) (sum : R).
Hypothesis WX : sub M (Plain bx) (Plain ax) wx.
Hypothesis WY : sub M (Plain by_) (Plain ay) wy.
Hypothesis WZ : sub M (Plain bz) (Plain az) wz.
Definition size_at i := size (x i) (y i) (z i).
Definition all_sizes := size (bx - ax) (by_ - ay) (bz - az) + six size_at.
Definition c_sum := let p := c_rounded 1 (c_rounded 1 (c_size + 1024 + (c_size + 1024)) + 1024 + (c_size + 1024)) in
  c_rounded 1 (c_way + 1024 + (c_rounded 1 (p + 1024 + (p + 1024)) + 1024)).
(* what the constructor computed: the sizes, and a sum that no number of the input exceeds where the guard holds *)
Definition made := (forall i, (i < 6)%nat -> vector 0 0 (x i) (y i) (z i) (x i) (y i) (z i) /\
    least 0 c_size 2 (sizes i) (size_at i) /\ small 1 m0 (sizes i)) /\
  vector 3074 1 wx wy wz (bx - ax) (by_ - ay) (bz - az) /\ least 0 c_sum 6 sum all_sizes /\ small 1 1024 sum.

Theorem obb_axes_right : obb_axes F R M x y z wx wy wz sizes sum -> at_most M sum H true -> made.
Proof.
intros R A. unfold obb_axes in R. unpack. constants. nonneg.
guarded G. parts G.
assert (near : forall a, small 1 m0 a -> tracked 0 0 m0 0 a a (Rabs a)) by (intros; now apply tracked_input).
split; [|split; [|split; [|assumption]]].
- intros i I. do 6 (destruct i as [|i]; [clear I; split; [split; [|split]; apply near; in_reach G|]; split;
    [eapply size_least; eassumption|in_reach G] |]). lia.
- split; [|split]; apply tracked_difference; solve [assumption|in_reach G].
- assert (L : forall i, (i < 6)%nat -> least 0 c_size 2 (sizes i) (size_at i)).
  { intros i I. do 6 (destruct i as [|i]; [eapply size_least; eassumption|]). lia. }
  pose proof (way_least _ _ _ _ _ _ _ _ _ _ _ WX WY WZ S11 S12) as W.
  assert (L0 := L 0%nat ltac:(lia)). assert (L1 := L 1%nat ltac:(lia)). assert (L2 := L 2%nat ltac:(lia)).
  assert (L3 := L 3%nat ltac:(lia)). assert (L4 := L 4%nat ltac:(lia)). assert (L5 := L 5%nat ltac:(lia)).
  clear - G W L0 L1 L2 L3 L4 L5 S13 S14 S15 S16 S17 R.
  exact (least_sum F H G _ _ _ _ _ _ _ _ _ _ W (least_sum F H G _ _ _ _ _ _ _ _ _ _
    (least_sum F H G _ _ _ _ _ _ _ _ _ _ (least_sum F H G _ _ _ _ _ _ _ _ _ _ L0 L1 S13) L2 S14)
    (least_sum F H G _ _ _ _ _ _ _ _ _ _ (least_sum F H G _ _ _ _ _ _ _ _ _ _ L3 L4 S15) L5 S16) S17) R).
Qed.

Lemma axis_guard v w others answer : obb_axis F R M x y z wx wy wz sizes sum v w others answer -> answer <> unknown ->
  at_most M sum H true.
Proof.
intros R A. unfold obb_axis in R. unpack. constants. subst.
match goal with S : at_most M sum H ?b |- _ => destruct b; [exact S|] end.
rewrite Bool.andb_false_r in A. now destruct A.
Qed.

(* where an axis is certain, the edges i, i + 1, i + 2 are independent if volume_is_certain(i) *)
Theorem obb_volume_right v w others answer i : obb_axes F R M x y z wx wy wz sizes sum ->
  obb_axis F R M x y z wx wy wz sizes sum v w others answer -> answer <> unknown ->
  obb_volume F R M x y z wx wy wz sizes sum i true -> (i + 2 < 6)%nat ->
  triple (x i) (y i) (z i) (x (i + 1)%nat) (y (i + 1)%nat) (z (i + 1)%nat) (x (i + 2)%nat) (y (i + 2)%nat)
    (z (i + 2)%nat) <> 0.
Proof.
intros S A N R I. destruct (obb_axes_right S (axis_guard _ _ _ _ A N)) as (E & _ & L & B). clear S A N.
assert (P : size_at (i + 2) <= all_sizes).
{ unfold all_sizes. pose proof (size_pos (bx - ax) (by_ - ay) (bz - az)).
  pose proof (one_of_six size_at (i + 2) (fun k => size_pos (x k) (y k) (z k)) I). lra. }
unfold obb_volume in R. unpack. constants.
destruct (E i ltac:(lia)) as (E0 & L0 & B0). destruct (E (i + 1)%nat ltac:(lia)) as (E1 & L1 & B1).
destruct (E (i + 2)%nat ltac:(lia)) as (E2 & _ & _). clear E.
subst.
pose proof (crossed _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ E0 E1 S S0 S1 S2 S3 S4 S5 S6 S7) as N.
destruct (dot_once _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ N E2 S8 S9 S10 S11 S12) as [V _].
pose proof (bound_of_axis _ _ _ _ _ _ _ _ _ _ _ _ _ L0 B0 L1 B1 L B S13 S14 eq_refl S16 eq_refl S18) as X.
apply (not_zero F H G _ _ _ _ _ _ _ _ _ _ _ V X ltac:(vm_compute; discriminate)); [|exact S19].
apply obb_enough; [exact Hu|lia|split; [apply terms_pos|]]. apply Rle_trans with (1 := terms_at_most _ _ _ _ _ _ _ _ _).
apply Rmult_le_compat_l; [apply Rmult_le_pos; apply size_pos|exact P].
Qed.

(* n = v x w for edges v and w, and four different others *)
Theorem obb_axis_right v w others answer : obb_axes F R M x y z wx wy wz sizes sum ->
  obb_axis F R M x y z wx wy wz sizes sum v w others answer -> (v < 6)%nat -> (w < 6)%nat -> different others ->
  let along := triple (x v) (y v) (z v) (x w) (y w) (z w) in
  let reach := fun k => Rabs (along (x (others k)) (y (others k)) (z (others k))) in
  let exact := Rabs (along (bx - ax) (by_ - ay) (bz - az)) -
    (reach 0%nat + reach 1%nat + (reach 2%nat + reach 3%nat)) in
  (answer = positive -> exact > 0) /\ (answer = negative -> exact < 0).
Proof.
intros S R V W D along reach exact.
unfold obb_axis in R. unpack. constants. flags R.
destruct (obb_axes_right S ltac:(assumption)) as (E & EW & L & B). clear S.
destruct (E v V) as (EV & LV & BV), (E w W) as (EW' & LW & BW).
destruct (E _ (proj1 D 0%nat ltac:(lia))) as [E0 _], (E _ (proj1 D 1%nat ltac:(lia))) as [E1 _],
  (E _ (proj1 D 2%nat ltac:(lia))) as [E2 _], (E _ (proj1 D 3%nat ltac:(lia))) as [E3 _]. clear E.
pose proof (crossed _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ EV EW' S0 S1 S2 S3 S4 S5 S6 S7 S8) as N.
pose proof (along_once _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ N E0 S9 S10 S11 S12 S13) as A0.
pose proof (along_once _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ N E1 S14 S15 S16 S17 S18) as A1.
pose proof (along_once _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ N E2 S20 S21 S22 S23 S24) as A2.
pose proof (along_once _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ N E3 S25 S26 S27 S28 S29) as A3.
pose proof (along_once _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ N EW S38 S39 S40 S41 S42) as AW.
pose proof (sum_of F H G 2 _ _ _ _ _ _ _ _ _ _ _ _ _ A0 A1 S19) as R0.
pose proof (sum_of F H G 2 _ _ _ _ _ _ _ _ _ _ _ _ _ A2 A3 S30) as R1.
pose proof (sum_of F H G 2 _ _ _ _ _ _ _ _ _ _ _ _ _ R0 R1 S31) as RR.
pose proof (difference_once F H G 2 _ _ _ _ _ _ _ _ _ _ _ _ _ _ (added_plain F H G _ _ _ _ _ _ _ AW)
  (added_plain F H G _ _ _ _ _ _ _ RR) eq_refl S43) as X.
pose proof (bound_of_axis _ _ _ _ _ _ _ _ _ _ _ _ _ LV BV LW BW L B S32 S33 eq_refl S35 eq_refl S37) as Y.
clear - F G Hu R D X Y S44 S48 exact.
assert (Right : (x48 = true -> exact > 0) /\ (x48 = false -> exact < 0)).
{ apply (sign_is_right F H G _ _ _ _ _ _ _ _ _ _ _ X Y ltac:(vm_compute; discriminate)); [|exact S44|exact S48].
  apply obb_enough; [exact Hu|simpl; lia|]. clear - D.
  pose proof (four_of_six size_at others (fun k => size_pos (x k) (y k) (z k)) D) as Q.
  pose proof (terms_at_most (x v) (y v) (z v) (x w) (y w) (z w)) as T.
  split; [repeat match goal with |- 0 <= _ + _ => apply Rplus_le_le_0_compat end; apply terms_pos|].
  pose proof (Rmult_le_pos (size_at v) (size_at w) (size_pos _ _ _) (size_pos _ _ _)) as P.
  apply (Rmult_le_compat_l _ _ _ P) in Q. unfold all_sizes. rewrite Rmult_plus_distr_l.
  apply Rplus_le_compat; [apply T|]. apply Rle_trans with (2 := Q). rewrite !Rmult_plus_distr_l.
  repeat match goal with |- _ + _ <= _ => apply Rplus_le_compat end; apply T. }
answers R Right.
Qed.

(* where it separates, the boxes have no common point *)
Theorem obb_axis_separates v w others : obb_axes F R M x y z wx wy wz sizes sum ->
  obb_axis F R M x y z wx wy wz sizes sum v w others positive -> (v < 6)%nat -> (w < 6)%nat -> different others ->
  rest v w others -> ~ exists r, (forall k, Rabs (r k) <= 1) /\ common_point x y z ax ay az bx by_ bz r.
Proof.
intros S A V W D C. destruct (obb_axis_right v w others positive S A V W D) as [Q _].
exact (separated _ _ _ _ _ _ _ _ _ _ _ _ C (Q eq_refl)).
Qed.
End Axes.
End Obb.
