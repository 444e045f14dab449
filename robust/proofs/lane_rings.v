(* SPDX-License-Identifier: Apache-2.0 *)
(* Points against rings in a lane: what the filters say of all edges. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model constants steps format floats ghost lanes.
From Filters Require Import lane_bounds lane_turns lane_values lane_sums lane_boxes lane_faces lane_ray_box lane_beside.
From Filters Require Import lane_linear lane_linear_sides lane_shape_filters lane_linear_filters.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.
#[local] Existing Instances p53 fexp_valid below_1024.

(* The least and the greatest of values, as they are found one after another. *)
Definition both '(l, g) z := (lesser l z, greater_of g z).
Lemma extremes zs : Forall finite zs -> forall l g, finite l -> finite g ->
  let '(l', g') := fold_left both zs (l, g) in
  finite l' /\ finite g' /\ l' <= l /\ g <= g' /\ Forall (fun z : float => l' <= z <= g') zs /\
  (l' = l \/ In l' zs) /\ (g' = g \/ In g' zs).
Proof.
induction 1 as [|z zs Z _ IH]; intros l g L G; cbn [fold_left].
- repeat split; try assumption; try apply Rle_refl; try constructor; reflexivity.
- cbn [both]. destruct (lesser_value _ _ L Z) as [FL VL], (greater_value _ _ G Z) as [FG VG].
  pose proof (Rmin_l l z). pose proof (Rmin_r l z). pose proof (Rmax_l g z). pose proof (Rmax_r g z).
  rewrite <- VL in *. rewrite <- VG in *. specialize (IH _ _ FL FG).
  assert (E1 : lesser l z = l \/ lesser l z = z) by (unfold lesser; destruct (above z l); auto).
  assert (E2 : greater_of g z = g \/ greater_of g z = z) by (unfold greater_of; destruct (above g z); auto).
  destruct (fold_left both zs _) as [l' g']. destruct IH as (F1 & F2 & L1 & G1 & All & I1 & I2).
  repeat split; try assumption; try lra.
  + constructor; [lra|exact All].
  + destruct I1 as [->|I1]; [|right; now right]. destruct E1 as [->| ->]; [now left|right; now left].
  + destruct I2 as [->|I2]; [|right; now right]. destruct E2 as [->| ->]; [now left|right; now left].
Qed.

(* A value beyond an error, or beyond its opposite. *)
Lemma error_opposite (e z : float) : above (minus zero e) z = true -> up e ->
  finite e /\ (finite z -> above (size z) e = true /\ negative_lane z = true).
Proof.
intros A U. destruct zero_is as [Z0 V0].
assert (FE : finite e) by (destruct (finite_case e) as [E|[->|[->| ->]]]; [exact E|discriminate U| |];
  destruct (finite_case z) as [F|[->|[->| ->]]]; try discriminate; now destruct z).
split; [exact FE|]. intros FZ. assert (M : finite (minus zero e) /\ value (minus zero e) = - e).
{ assert (R : rnd (value zero - e) = - e).
  { rewrite V0. replace (0 - value e) with (- e) by ring. rewrite rnd_opp, rnd_held; [reflexivity|apply held_value]. }
  unfold minus. cases_of (Bminus_correct 53 1024 _ _ mode_NE zero e Z0 FE); fold (rnd (value zero - value e)) in *.
  - intros (V & F & _). rewrite V. now split.
  - rewrite R, Rabs_Ropp in L. pose proof (below_high e). lra. }
destruct M as [M V]. apply (above_finite _ _ M FZ) in A. rewrite V in A. apply up_value in U.
assert (N : negative_lane z = true).
{ unfold negative_lane. destruct (Bsign z) eqn:S; [reflexivity|]. apply sign_value in S. lra. }
split; [|exact N]. apply above_finite; [now destruct z|exact FE|].
unfold size, value in *. rewrite B2R_Babs, Rabs_left; lra.
Qed.
Lemma above_further (x y z : float) : finite y -> finite z -> z <= y -> above x y = true -> above x z = true.
Proof.
intros Y Z L A. apply above_true in A as [[X A]| ->]; [|now destruct z|exact Y].
apply (above_finite _ _ X Z). lra.
Qed.
Lemma difference_sign (x y : float) : finite x -> finite y ->
  (x < y -> negative_lane (minus x y) = true) /\ (y < x -> negative_lane (minus x y) = false).
Proof.
intros X Y. unfold negative_lane, minus.
cases_of (Bminus_correct 53 1024 _ _ mode_NE x y X Y).
- intros (_ & _ & S). rewrite S. split; intros Q; [now rewrite Rcompare_Lt by lra|now rewrite Rcompare_Gt by lra].
- intros [E%not_finite_overflow S]. rewrite E. destruct (sign_value x), (sign_value y). simpl. rewrite S in *.
  destruct (Bsign y); simpl in *; split; intros; try reflexivity; intuition lra.
Qed.
Lemma finite_numbers (p : float) : not_below (number 9007199254740991 971) (size p) = true -> finite p.
Proof.
destruct (number_value 9007199254740991 971) as [F _]; [lia|lia|]. unfold not_below. now destruct p, (number _ _).
Qed.

(* What is beyond the box is beyond all that is in it. *)
Lemma below_box (o g x p : float) : finite x -> finite p -> in_box o g x -> above o p = true -> p < x.
Proof.
intros X P [A _] H. destruct (finite_case o) as [O|[->|[->| ->]]]; [|now destruct p|now destruct x|now destruct p].
apply (above_finite _ _ O P) in H. apply Rnot_le_lt. intros C.
assert (T : above o x = true) by (apply (above_finite _ _ O X); lra). congruence.
Qed.
Lemma above_box (o g x p : float) : finite x -> finite p -> in_box o g x -> above p g = true -> x < p.
Proof.
intros X P [_ A] H. destruct (finite_case g) as [G|[->|[->| ->]]]; [|now destruct x|now destruct p|now destruct p].
apply (above_finite _ _ P G) in H. apply Rnot_le_lt. intros C.
assert (T : above x g = true) by (apply (above_finite _ _ X G); lra). congruence.
Qed.

(* The edges of a ring, each with the one at whose end it begins. *)
Definition point := (float * float)%type.
Fixpoint edges_from (a : point) points :=
  match points with [] => [] | b :: rest => (a, b) :: edges_from b rest end.
Definition edges points := edges_from (last points (zero, zero)) points.
Definition at_ends points (edge : point * point) := In (fst edge) points /\ In (snd edge) points.
Lemma last_in (points : list point) v : points <> [] -> In (last points v) points.
Proof.
intros N. rewrite (app_removelast_last v N) at 2. apply in_or_app. right. now left.
Qed.
Lemma ends_from all points : forall a, In a all -> incl points all -> Forall (at_ends all) (edges_from a points).
Proof.
induction points as [|b points IH]; intros a A I; simpl; constructor.
- split; [exact A|apply I; now left].
- apply IH; [apply I; now left|]. intros x X. apply I. now right.
Qed.
Lemma ends points : Forall (at_ends points) (edges points).
Proof.
destruct points as [|v points]; [constructor|]. apply ends_from; [now apply last_in|apply incl_refl].
Qed.
Definition turn_of (edge : point * point) (p0 p1 : R) :=
  let '(a, b) := edge in turn (fst a) (snd a) (fst b) (snd b) p0 p1.
Definition beyond_2 (points : list point) (p0 p1 : R) :=
  Forall (fun v : point => p0 < fst v) points \/ Forall (fun v : point => fst v < p0) points \/
  Forall (fun v : point => p1 < snd v) points \/ Forall (fun v : point => snd v < p1) points.

Section Ring.
Variables (fused : bool) (points : list point) (p0 p1 : float).
Hypothesis F : Forall finite_2 points.
Let o0 := let '(o0, o1, g0, g1) := box_2 points in o0.
Let o1 := let '(o0, o1, g0, g1) := box_2 points in o1.
Let g0 := let '(o0, o1, g0, g1) := box_2 points in g0.
Let g1 := let '(o0, o1, g0, g1) := box_2 points in g1.
Let beyond := let '(beyond, d0, d1) := lane_framed_2 o0 o1 g0 g1 p0 p1 in beyond.
Let d0 := let '(beyond, d0, d1) := lane_framed_2 o0 o1 g0 g1 p0 p1 in d0.
Let d1 := let '(beyond, d0, d1) := lane_framed_2 o0 o1 g0 g1 p0 p1 in d1.
Let error := line_error o0 o1 g0 g1.
Definition numbers_of (edge : point * point) :=
  let '(a, b) := edge in lane_line_numbers (fst a) (snd a) (fst b) (snd b) o0 o1.
Definition value_of edge : float := let '(n0, n1, n2) := numbers_of edge in lane_linear_2 fused n0 n1 n2 d0 d1.

Lemma in_boxes : Forall (fun p => in_box o0 g0 (fst p) /\ in_box o1 g1 (snd p)) points.
Proof. unfold o0, o1, g0, g1. assert (B := box_2_right points F). now destruct (box_2 points) as [[[? ?] ?] ?]. Qed.
Lemma beyond_box : points <> [] -> finite p0 -> finite p1 -> beyond = true -> beyond_2 points p0 p1.
Proof.
intros N P0 P1. unfold beyond, lane_framed_2. simpl orb. intros B.
assert (I := in_boxes). rewrite Forall_forall in I. rewrite Forall_forall in F.
apply orb_true_iff in B as [[B|B]%orb_true_iff|[B|B]%orb_true_iff]; [left|right; left|do 2 right; left|do 3 right];
  apply Forall_forall; intros v V; destruct (I v V) as [I0 I1]; destruct (F v V);
  [apply (below_box _ _ _ _ H P0 I0 B)|apply (above_box _ _ _ _ H P0 I0 B)|apply (below_box _ _ _ _ H0 P1 I1 B)|
   apply (above_box _ _ _ _ H0 P1 I1 B)].
Qed.

(* Within the box: finite values, and a sign that is certain is right. *)
Lemma error_up : points <> [] -> up error.
Proof.
intros N. assert (V := last_in points (zero, zero) N). set (v := last points (zero, zero)) in *.
assert (I := in_boxes). rewrite Forall_forall in I. destruct (I v V) as [I0 I1].
assert (F' := F). rewrite Forall_forall in F'. destruct (F' v V) as [V0 V1].
assert (KF : forall x : float, finite x -> known x) by (now intros []).
apply up_error, up_times; [apply (up_extent _ _ _ (KF _ V0) I0)|apply (up_extent _ _ _ (KF _ V1) I1)].
Qed.
Lemma edge_right edge : In edge (edges points) -> beyond = false -> finite p0 -> finite p1 -> finite error ->
  finite (value_of edge) /\ (above (size (value_of edge)) error = true ->
    (negative_lane (value_of edge) = true -> turn_of edge p0 p1 < 0) /\
    (negative_lane (value_of edge) = false -> turn_of edge p0 p1 > 0)).
Proof.
intros I B P0 P1 FE. assert (E := ends points). rewrite Forall_forall in E. destruct (E _ I) as [A C].
assert (Box := in_boxes). rewrite Forall_forall in Box. destruct (Box _ A) as [A0 A1], (Box _ C) as [C0 C1].
assert (F' := F). rewrite Forall_forall in F'. destruct (F' _ A), (F' _ C).
destruct edge as [a b]. cbn [fst snd] in *.
destruct (lane_line_right fused o0 o1 g0 g1 (fst a) (snd a) (fst b) (snd b) p0 p1 A0 A1 C0 C1 B) as [S Z].
split; [apply Z; [exact FE|repeat constructor; assumption]|]. intros K. apply (S K).
Qed.

Definition convex_ring : bool * bool := match map numbers_of (edges points) with
  | [] => (false, false)
  | (n0, n1, n2) :: rest =>
      let '(l, g) := fold_left (fun '(l, g) '(n0, n1, n2) => lane_convex_ring_next fused l g n0 n1 n2 d0 d1) rest
        (lane_convex_ring_first fused n0 n1 n2 d0 d1) in
      lane_convex_ring_answer l g error p0 p1 beyond end.
Lemma folded rest : forall l g, fold_left (fun '(l, g) '(n0, n1, n2) =>
    lane_convex_ring_next fused l g n0 n1 n2 d0 d1) (map numbers_of rest) (l, g) =
  fold_left both (map value_of rest) (l, g).
Proof.
induction rest as [|e rest IH]; intros l g; cbn [map fold_left]; [reflexivity|]. unfold value_of at 2.
destruct (numbers_of e) as [[n0 n1] n2]. apply IH.
Qed.

Theorem lane_convex_ring_right : let '(known, outside) := convex_ring in known = true ->
  finite p0 /\ finite p1 /\
  (outside = false -> Forall (fun e => turn_of e p0 p1 > 0) (edges points) \/
    Forall (fun e => turn_of e p0 p1 < 0) (edges points)) /\
  (outside = true -> beyond_2 points p0 p1 \/ (Exists (fun e => turn_of e p0 p1 > 0) (edges points) /\
    Exists (fun e => turn_of e p0 p1 < 0) (edges points))).
Proof.
unfold convex_ring. destruct (edges points) as [|e rest] eqn:E; [discriminate|]. cbn [map].
assert (N : points <> []) by (intros H; rewrite H in E; discriminate E).
assert (V : lane_convex_ring_first fused = fun n0 n1 n2 d0 d1 => (lane_linear_2 fused n0 n1 n2 d0 d1,
  lane_linear_2 fused n0 n1 n2 d0 d1)) by reflexivity.
rewrite V. clear V. set (z := value_of e). assert (Z : z = value_of e) by reflexivity. clearbody z.
unfold value_of in Z. destruct (numbers_of e) as [[n0 n1] n2] eqn:NE. rewrite <- Z.
rewrite folded. destruct (fold_left both (map value_of rest) (z, z)) as [l g] eqn:L.
unfold lane_convex_ring_answer. cbv zeta. intros [[[_ K0]%andb_prop K1]%andb_prop K]%andb_prop.
assert (P0 := finite_numbers _ K0). assert (P1 := finite_numbers _ K1). clear K0 K1.
split; [exact P0|]. split; [exact P1|].
destruct beyond eqn:B.
{ split; [discriminate|]. intros _. left. now apply beyond_box. }
cbn [orb] in *. assert (U := error_up N).
assert (FE : finite error).
{ apply orb_true_iff in K as [[[A _]%andb_prop|A]%orb_true_iff|A];
    [exact (above_bound _ _ A U)|exact (above_bound _ _ A U)|exact (proj1 (error_opposite _ _ A U))]. }
assert (R : forall x, In x (e :: rest) -> finite (value_of x) /\ (above (size (value_of x)) error = true ->
  (negative_lane (value_of x) = true -> turn_of x p0 p1 < 0) /\
  (negative_lane (value_of x) = false -> turn_of x p0 p1 > 0))).
{ intros x I. apply edge_right; try assumption. now rewrite E. }
assert (Z' : value_of e = z) by (unfold value_of; now rewrite NE).
assert (FZ : finite z) by (rewrite <- Z'; apply R; now left).
assert (FR : Forall finite (map value_of rest)).
{ apply Forall_forall. intros y [x [<- I]]%in_map_iff. apply R. now right. }
assert (X := extremes _ FR z z FZ FZ). rewrite L in X. destruct X as (FL & FG & L1 & G1 & All & IL & IG).
assert (Between : forall x, In x (e :: rest) -> l <= value_of x <= g).
{ intros x [<-|I]; [rewrite Z'; lra|]. rewrite Forall_forall in All. apply All. now apply in_map. }
assert (XL : exists x, In x (e :: rest) /\ value_of x = l).
{ destruct IL as [->|[x [<- I]]%in_map_iff]; [exists e; split; [now left|exact Z']|exists x; split; [now right|easy]]. }
assert (XG : exists x, In x (e :: rest) /\ value_of x = g).
{ destruct IG as [->|[x [<- I]]%in_map_iff]; [exists e; split; [now left|exact Z']|exists x; split; [now right|easy]]. }
assert (Left : forall x, In x (e :: rest) -> error < value_of x -> turn_of x p0 p1 > 0).
{ intros x I C. destruct (R x I) as [FX S]. apply (above_finite _ _ FX FE) in C.
  destruct (above_itself _ _ C U FE) as [C' NS]. now apply S. }
assert (Right : forall x, In x (e :: rest) -> above (minus zero error) (value_of x) = true -> turn_of x p0 p1 < 0).
{ intros x I C. destruct (R x I) as [FX S]. destruct (error_opposite _ _ C U) as [_ W].
  destruct (W FX) as [C' NS]. now apply S. }
split; intros O.
- rewrite O in K. cbn [orb] in K. apply orb_true_iff in K as [K|K].
  + left. apply Forall_forall. intros x I. apply Left; [exact I|]. apply (above_finite _ _ FL FE) in K.
    destruct (Between x I). lra.
  + right. apply Forall_forall. intros x I. apply Right; [exact I|]. destruct (Between x I) as [_ B'].
    exact (above_further _ _ _ FG (proj1 (R x I)) B' K).
- apply andb_prop in O as [O1 O2]. right. split; apply Exists_exists.
  + destruct XG as (x & I & Q). exists x. split; [exact I|]. apply Left; [exact I|]. rewrite Q.
    now apply (above_finite _ _ FG FE).
  + destruct XL as (x & I & Q). exists x. split; [exact I|]. apply Right; [exact I|]. now rewrite Q.
Qed.

(* Whether an edge crosses the ray to +x from a point off its line: a vertex at the height of the point counts as lower
   or not, but for both its edges. *)
Definition crosses (low : point -> bool) (q0 q1 : R) (edge : point * point) :=
  xorb (low (fst edge)) (low (snd edge)) && negb (xorb (Rlt_bool (turn_of edge q0 q1) 0) (low (snd edge))).
Definition lower_of (v : point) := negative_lane (minus (snd v) p1).
Definition counted edge := xorb (lower_of (fst edge)) (lower_of (snd edge)) &&
  negb (xorb (negative_lane (value_of edge)) (lower_of (snd edge))).
Definition next_edge '(least, odd, from) (edge : point * point) := let '(n0, n1, n2) := numbers_of edge in
  lane_ring_next fused least n0 n1 n2 d0 d1 p1 (snd (snd edge)) odd from.
Definition ring : bool * bool :=
  let '(least, odd, _) := fold_left next_edge (edges points) (lane_ring_first p1 (snd (last points (zero, zero)))) in
  lane_ring_answer least error p0 p1 odd beyond.
Lemma ring_folded rest : forall a l odd, exists from, fold_left next_edge (edges_from a rest) (l, odd, lower_of a) =
  (fold_left lesser (map (fun e => size (value_of e)) (edges_from a rest)) l,
   fold_left xorb (map counted (edges_from a rest)) odd, from).
Proof.
induction rest as [|b rest IH]; intros a l odd; cbn [edges_from fold_left map]; [now exists (lower_of a)|].
assert (S : next_edge (l, odd, lower_of a) (a, b) =
  (lesser l (size (value_of (a, b))), xorb odd (counted (a, b)), lower_of b)).
{ unfold next_edge, counted, value_of. now destruct (numbers_of (a, b)) as [[n0 n1] n2]. }
rewrite S. apply IH.
Qed.

Lemma lesser_of_all zs : Forall finite zs -> forall l, finite l -> let l' := fold_left lesser zs l in
  finite l' /\ Forall (fun z : float => l' <= z) zs.
Proof.
intros FZ l L. assert (X := extremes zs FZ l l L L).
assert (S : forall zs l g, fst (fold_left both zs (l, g)) = fold_left lesser zs l).
{ clear. induction zs as [|z zs IH]; intros l g; [reflexivity|]. apply IH. }
specialize (S zs l l). destruct (fold_left both zs (l, l)) as [l' g'] eqn:Q. cbn [fst] in S. rewrite <- S. cbv zeta.
destruct X as (F1 & _ & _ & _ & All & _). split; [exact F1|]. apply Forall_impl with (2 := All).
intros z [H _]. exact H.
Qed.

Theorem lane_ring_right : points <> [] -> let '(known, outside) := ring in known = true -> finite p0 /\ finite p1 /\
  ((outside = true /\ beyond_2 points p0 p1) \/
   exists low : point -> bool,
     Forall (fun v : point => (snd v < p1 -> low v = true) /\ (p1 < snd v -> low v = false)) points /\
     Forall (fun e => turn_of e p0 p1 <> 0) (edges points) /\
     outside = negb (fold_left xorb (map (crosses low p0 p1) (edges points)) false)).
Proof.
intros N. unfold ring. set (most := number 9007199254740991 971).
change (lane_ring_first p1 (snd (last points (zero, zero)))) with
  (most, negative_lane zero, lower_of (last points (zero, zero))).
destruct (ring_folded points (last points (zero, zero)) most (negative_lane zero)) as [from S].
change (edges_from (last points (zero, zero)) points) with (edges points) in S. rewrite S. clear from S.
set (least := fold_left lesser _ _). set (odd := fold_left xorb _ _).
unfold lane_ring_answer. cbv zeta. intros [[[_ K0]%andb_prop K1]%andb_prop K]%andb_prop.
assert (P0 := finite_numbers _ K0). assert (P1 := finite_numbers _ K1). clear K0 K1.
split; [exact P0|]. split; [exact P1|].
destruct beyond eqn:B.
{ left. split; [reflexivity|]. now apply beyond_box. }
right. cbn [orb] in *. assert (FE := above_bound _ _ K (error_up N)).
assert (R := fun x I => edge_right x I B P0 P1 FE).
assert (FM : finite most) by (destruct (number_value 9007199254740991 971) as [M _]; [lia|lia|exact M]).
assert (FS : Forall finite (map (fun e => size (value_of e)) (edges points))).
{ apply Forall_forall. intros y [x [<- I]]%in_map_iff. destruct (R x I) as [FX _]. now destruct (value_of x). }
destruct (lesser_of_all _ FS most FM) as [FL All]. fold least in FL, All.
assert (Sure : forall x, In x (edges points) -> (negative_lane (value_of x) = true -> turn_of x p0 p1 < 0) /\
  (negative_lane (value_of x) = false -> turn_of x p0 p1 > 0)).
{ intros x I. destruct (R x I) as [FX S]. apply S. rewrite Forall_forall in All.
  assert (L := All _ (in_map (fun e => size (value_of e)) _ _ I)). apply (above_finite _ _ FL FE) in K.
  apply above_finite; [now destruct (value_of x)|exact FE|lra]. }
exists lower_of. split; [|split].
- apply Forall_forall. intros v V. rewrite Forall_forall in F. destruct (F v V) as [_ V1].
  apply difference_sign; assumption.
- apply Forall_forall. intros x I. destruct (Sure x I). destruct (negative_lane (value_of x)); [specialize (H eq_refl)|
  specialize (H0 eq_refl)]; lra.
- unfold odd. assert (Z : negative_lane zero = false) by reflexivity. rewrite Z. do 2 f_equal.
  apply map_ext_in. intros x I. unfold counted, crosses. do 3 f_equal. destruct (Sure x I) as [S1 S2].
  destruct (negative_lane (value_of x)); symmetry; [apply Rlt_bool_true|apply Rlt_bool_false].
  + now apply S1.
  + specialize (S2 eq_refl). lra.
Qed.
End Ring.
