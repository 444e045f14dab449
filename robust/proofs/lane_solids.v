(* SPDX-License-Identifier: Apache-2.0 *)
(* Points against solids in a lane: what the filters say of all faces. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model constants steps format floats ghost lanes.
From Filters Require Import lane_bounds lane_turns lane_values lane_sums lane_boxes lane_faces lane_ray_box lane_beside.
From Filters Require Import lane_linear lane_linear_sides lane_rings lane_shape_filters lane_linear_filters.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.

(* Three corners, and the side that is outside: 1 or -1. *)
Definition corner := (float * float * float)%type.
Definition face := (corner * corner * corner * float)%type.
Definition corners (f : face) :=
  let '(a, b, c, o) := f in if negative_lane o then [a; c; b] else [a; b; c].
Definition valid_face (f : face) :=
  let '(_, _, _, o) := f in Forall finite_3 (corners f) /\ finite o /\ (value o = 1 \/ value o = -1).
(* Positive outside. *)
Definition side_of (f : face) (p0 p1 p2 : R) := let '(a, b, c, o) := f in
  let '(a0, a1, a2) := a in let '(b0, b1, b2) := b in let '(c0, c1, c2) := c in
  o * volume a0 a1 a2 b0 b1 b2 c0 c1 c2 p0 p1 p2.
Definition all_corners faces := flat_map corners faces.
Definition beyond_3 (points : list corner) (p0 p1 p2 : R) :=
  let all (claim : R -> R -> R -> Prop) := Forall (fun '(x, y, z) => claim (value x) (value y) (value z)) points in
  all (fun x _ _ => p0 < x) \/ all (fun x _ _ => x < p0) \/ all (fun _ y _ => p1 < y) \/ all (fun _ y _ => y < p1) \/
  all (fun _ _ z => p2 < z) \/ all (fun _ _ z => z < p2).

Lemma greatest zs : Forall finite zs -> forall g, finite g -> let g' := fold_left greater_of zs g in
  finite g' /\ g <= g' /\ Forall (fun z : float => z <= g') zs /\ (g' = g \/ In g' zs).
Proof.
intros F g G. assert (E := extremes zs F g g G G).
assert (S : forall zs l g, snd (fold_left both zs (l, g)) = fold_left greater_of zs g).
{ clear. induction zs as [|z zs IH]; intros l g; [reflexivity|]. apply IH. }
specialize (S zs g g). destruct (fold_left both zs (g, g)) as [l' g'] eqn:Q. cbn [snd] in S. rewrite <- S. cbv zeta.
destruct E as (_ & F2 & _ & G1 & All & _ & I). repeat split; try assumption.
apply Forall_impl with (2 := All). intros z [_ L]. exact L.
Qed.

Section Solid.
Variables (fused : bool) (faces : list face) (p0 p1 p2 : float).
Hypothesis F : Forall valid_face faces.
Let o0 := let '(o0, o1, o2, g0, g1, g2) := box_3 (all_corners faces) in o0.
Let o1 := let '(o0, o1, o2, g0, g1, g2) := box_3 (all_corners faces) in o1.
Let o2 := let '(o0, o1, o2, g0, g1, g2) := box_3 (all_corners faces) in o2.
Let g0 := let '(o0, o1, o2, g0, g1, g2) := box_3 (all_corners faces) in g0.
Let g1 := let '(o0, o1, o2, g0, g1, g2) := box_3 (all_corners faces) in g1.
Let g2 := let '(o0, o1, o2, g0, g1, g2) := box_3 (all_corners faces) in g2.
Let beyond := let '(beyond, d0, d1, d2) := lane_framed_3 o0 o1 o2 g0 g1 g2 p0 p1 p2 in beyond.
Let d0 := let '(beyond, d0, d1, d2) := lane_framed_3 o0 o1 o2 g0 g1 g2 p0 p1 p2 in d0.
Let d1 := let '(beyond, d0, d1, d2) := lane_framed_3 o0 o1 o2 g0 g1 g2 p0 p1 p2 in d1.
Let d2 := let '(beyond, d0, d1, d2) := lane_framed_3 o0 o1 o2 g0 g1 g2 p0 p1 p2 in d2.
Lemma corners_finite : Forall finite_3 (all_corners faces).
Proof.
apply Forall_flat_map. apply Forall_impl with (2 := F). intros [[[a b] c] o] V. apply V.
Qed.
Lemma corners_in_box : Forall (fun '(x, y, z) => in_box o0 g0 x /\ in_box o1 g1 y /\ in_box o2 g2 z)
  (all_corners faces).
Proof.
unfold o0, o1, o2, g0, g1, g2. assert (B := box_3_right _ corners_finite).
now destruct (box_3 (all_corners faces)) as [[[[[? ?] ?] ?] ?] ?].
Qed.
Definition size_of_face (f : face) : float := let '((a0, a1, a2), (b0, b1, b2), (c0, c1, c2), o) := f in
  plane_size a0 a1 a2 b0 b1 b2 c0 c1 c2 o o0 o1 o2 g0 g1 g2.
Definition numbers_of_face (f : face) := let '((a0, a1, a2), (b0, b1, b2), (c0, c1, c2), o) := f in
  let '(x0, x1, x2, y0, y1, y2, _, _, _) := lane_plane_numbers a0 a1 a2 b0 b1 b2 c0 c1 c2 o in
  lane_plane_function x0 x1 x2 y0 y1 y2 o0 o1 o2.
Definition value_of_face f : float :=
  let '(n0, n1, n2, n3) := numbers_of_face f in lane_linear_3 fused n0 n1 n2 n3 d0 d1 d2.
Definition size_of_faces := fold_left lane_greater_size (map size_of_face faces) zero.
Let error := lane_error_of_linear size_of_faces.

Lemma first_corner f : In f faces -> let '(a, _, _, _) := f in In a (all_corners faces).
Proof.
destruct f as [[[a b] c] o]. intros I. apply in_flat_map. exists (a, b, c, o). split; [exact I|]. simpl.
destruct (negative_lane o); now left.
Qed.
Lemma beyond_box_3 : finite p0 -> finite p1 -> finite p2 -> beyond = true -> beyond_3 (all_corners faces) p0 p1 p2.
Proof.
intros P0 P1 P2. unfold beyond, lane_framed_3. simpl orb. intros B.
assert (I := corners_in_box). rewrite Forall_forall in I. assert (C := corners_finite). rewrite Forall_forall in C.
apply orb_true_iff in B as [[[B|B]%orb_true_iff|[B|B]%orb_true_iff]%orb_true_iff|[B|B]%orb_true_iff];
  [left|right; left|do 2 right; left|do 3 right; left|do 4 right; left|do 5 right]; apply Forall_forall;
  intros [[x y] z] V; destruct (I _ V) as (I0 & I1 & I2), (C _ V) as (C0 & C1 & C2);
  first [exact (below_box _ _ _ _ C0 P0 I0 B)|exact (above_box _ _ _ _ C0 P0 I0 B)|
    exact (below_box _ _ _ _ C1 P1 I1 B)|exact (above_box _ _ _ _ C1 P1 I1 B)|
    exact (below_box _ _ _ _ C2 P2 I2 B)|exact (above_box _ _ _ _ C2 P2 I2 B)].
Qed.
Lemma size_says : up size_of_faces /\ (finite size_of_faces -> forall f, In f faces ->
  not_below size_of_faces (size_of_face f) = true).
Proof.
destruct zero_is as [Z V]. assert (KZ : known zero) by (now destruct zero).
assert (UZ : up zero) by (apply up_number; lia).
destruct (greatest_size (map size_of_face faces) zero KZ UZ) as (_ & U & W). split; [exact U|]. intros FS f I.
destruct (W FS) as (_ & _ & All). rewrite Forall_forall in All. apply All. now apply in_map.
Qed.
Lemma face_of_solid f : In f faces -> beyond = false -> finite p0 -> finite p1 -> finite p2 -> finite error ->
  finite (value_of_face f) /\ (above (size (value_of_face f)) error = true ->
    (negative_lane (value_of_face f) = true -> side_of f p0 p1 p2 < 0) /\
    (negative_lane (value_of_face f) = false -> side_of f p0 p1 p2 > 0)).
Proof.
intros I B P0 P1 P2 FE. destruct size_says as [_ S]. specialize (S (error_finite _ FE) f I).
assert (A := first_corner f I). assert (F' := F). rewrite Forall_forall in F'. assert (V := F' f I).
destruct f as [[[[[a0 a1] a2] [[b0 b1] b2]] [[c0 c1] c2]] o]. destruct V as (_ & FO & O).
assert (Box := corners_in_box). rewrite Forall_forall in Box. destruct (Box _ A) as (A0 & A1 & A2).
assert (C := corners_finite). rewrite Forall_forall in C. destruct (C _ A) as (FA0 & FA1 & FA2).
destruct (lane_plane_right fused a0 a1 a2 b0 b1 b2 c0 c1 c2 o size_of_faces o0 o1 o2 g0 g1 g2 p0 p1 p2
  FO O A0 A1 A2 S B) as [W Z].
split; [apply Z; [exact FE|repeat constructor; assumption]|]. intros K. apply (W K).
Qed.

Definition convex_solid : bool * bool := match map numbers_of_face faces with
  | [] => (false, false)
  | (n0, n1, n2, n3) :: rest =>
      lane_convex_solid_answer (fold_left (fun g '(n0, n1, n2, n3) =>
        lane_convex_solid_next fused g n0 n1 n2 n3 d0 d1 d2) rest
        (lane_convex_solid_first fused n0 n1 n2 n3 d0 d1 d2)) error p0 p1 p2 beyond end.
Lemma folded_faces rest : forall g, fold_left (fun g '(n0, n1, n2, n3) =>
    lane_convex_solid_next fused g n0 n1 n2 n3 d0 d1 d2) (map numbers_of_face rest) g =
  fold_left greater_of (map value_of_face rest) g.
Proof.
induction rest as [|f rest IH]; intros g; cbn [map fold_left]; [reflexivity|]. unfold value_of_face at 2.
destruct (numbers_of_face f) as [[[n0 n1] n2] n3]. apply IH.
Qed.

Theorem lane_convex_solid_right : let '(known, outside) := convex_solid in known = true ->
  finite p0 /\ finite p1 /\ finite p2 /\
  (outside = false -> Forall (fun f => side_of f p0 p1 p2 < 0) faces) /\
  (outside = true -> beyond_3 (all_corners faces) p0 p1 p2 \/ Exists (fun f => side_of f p0 p1 p2 > 0) faces).
Proof.
unfold convex_solid. destruct (map numbers_of_face faces) as [|m rest] eqn:E; [discriminate|].
destruct (map_eq_cons _ _ E) as (f & fs & EF & NF & <-). destruct m as [[[n0 n1] n2] n3]. rewrite folded_faces.
change (lane_convex_solid_first fused n0 n1 n2 n3 d0 d1 d2) with (lane_linear_3 fused n0 n1 n2 n3 d0 d1 d2).
assert (Z : value_of_face f = lane_linear_3 fused n0 n1 n2 n3 d0 d1 d2) by (unfold value_of_face; now rewrite NF).
rewrite <- Z. set (g := fold_left greater_of _ _).
unfold lane_convex_solid_answer. cbv zeta. intros [[[[_ K0]%andb_prop K1]%andb_prop K2]%andb_prop K]%andb_prop.
assert (P0 := finite_numbers _ K0). assert (P1 := finite_numbers _ K1). assert (P2 := finite_numbers _ K2).
clear K0 K1 K2. split; [exact P0|]. split; [exact P1|]. split; [exact P2|]. destruct beyond eqn:B.
{ split; [discriminate|]. intros _. left. now apply beyond_box_3. }
cbn [orb] in *. assert (U : up error) by (apply up_error, size_says).
assert (FE : finite error).
{ apply orb_true_iff in K as [A|A]; [exact (above_bound _ _ A U)|exact (proj1 (error_opposite _ _ A U))]. }
assert (R := fun x I => face_of_solid x I B P0 P1 P2 FE).
assert (FF : Forall finite (map value_of_face fs)).
{ apply Forall_forall. intros y [x [<- I]]%in_map_iff. apply R. rewrite EF. now right. }
assert (FV : finite (value_of_face f)) by (apply R; rewrite EF; now left).
destruct (greatest _ FF _ FV) as (FG & G1 & All & IG). fold g in FG, G1, All, IG. clearbody g.
split; intros O.
- rewrite O in K. cbn [orb] in K. apply Forall_forall. intros x I.
  assert (L : value_of_face x <= g).
  { rewrite EF in I. destruct I as [<-|I]; [exact G1|]. rewrite Forall_forall in All. apply All. now apply in_map. }
  destruct (error_opposite _ _ (above_further _ _ _ FG (proj1 (R x I)) L K) U) as [_ W].
  destruct (W (proj1 (R x I))) as [A N]. now apply (R x I).
- right. assert (X : exists x, In x faces /\ value_of_face x = g).
  { rewrite EF. destruct IG as [->|[x [<- I]]%in_map_iff]; [exists f; split; [now left|easy]|].
    exists x. split; [now right|easy]. }
  destruct X as (x & I & Q). apply Exists_exists. exists x. split; [exact I|]. rewrite <- Q in O.
  destruct (above_itself _ _ O U FE) as [A N]. now apply (R x I).
Qed.

(* A closed mesh: whether the ray to +x crosses a face, from its edges as seen along x, and from its side. The box
   around a face is any numbers, and others is any bit: whether another lane's point is close to the line of an edge. *)
Variables (boxes : face -> float * float * float * float * float) (others : face -> bool).
Definition seen (c : corner) : point := let '(_, y, z) := c in (y, z).
Definition edges_of (f : face) := let '(a, b, c, _) := f in [(seen a, seen b); (seen b, seen c); (seen c, seen a)].
Definition near_face f := let '(l1, h1, l2, h2, h0) := boxes f in
  negb (above l1 p1 || above p1 h1 || above l2 p2 || above p2 h2 || above p0 h0).
Definition contains (low : point -> bool) f := fold_left xorb (map (crosses low p1 p2) (edges_of f)) false.
Definition left_of (low : point -> bool) f :=
  existsb (fun e => crosses low p1 p2 e && negb (Rlt_bool (turn_of e p1 p2) 0)) (edges_of f).
Definition crosses_face low f := contains low f && negb (xorb (left_of low f) (Rlt_bool (side_of f p0 p1 p2) 0)).

Let error_of_turns := line_error o1 o2 g1 g2.
Definition numbers_of_turn (e : point * point) :=
  lane_line_numbers (fst (fst e)) (snd (fst e)) (fst (snd e)) (snd (snd e)) o1 o2.
Definition value_of_turn (e : point * point) : float :=
  let '(n0, n1, n2) := numbers_of_turn e in lane_linear_2 fused n0 n1 n2 d1 d2.
Definition next_face '(odd, open) (f : face) :=
  let '((_, _, az), (_, _, bz), (_, _, cz), _) := f in let '(l1, h1, l2, h2, h0) := boxes f in
  match map numbers_of_turn (edges_of f) with
  | [(n0, n1, n2); (n3, n4, n5); (n6, n7, n8)] => let '(n9, n10, n11, n12) := numbers_of_face f in
      lane_solid_next fused az bz cz l1 h1 l2 h2 h0 n0 n1 n2 n3 n4 n5 n6 n7 n8 n9 n10 n11 n12 d0 d1 d2 error p0 p1 p2
        error_of_turns odd open (others f)
  | _ => (odd, open) end.
Definition solid : bool * bool := let '(odd, open) := fold_left next_face faces lane_solid_first in
  lane_solid_answer p0 p1 p2 odd open beyond.

(* What one face adds, as computed. *)
Let low := lower_of p2.
Definition counted_turn (e : point * point) := xorb (low (fst e)) (low (snd e)) &&
  negb (xorb (negative_lane (value_of_turn e)) (low (snd e))).
Definition contains_computed f := fold_left xorb (map counted_turn (edges_of f)) false.
Definition left_computed f := existsb (fun e => counted_turn e && negb (negative_lane (value_of_turn e))) (edges_of f).
Definition least_turn f : float :=
  fold_left lesser (map (fun e => size (value_of_turn e)) (edges_of f)) (number 9007199254740991 971).
Definition close f := negb (above (least_turn f) error_of_turns).
Definition adds f := contains_computed f && negb (xorb (left_computed f) (negative_lane (value_of_face f))) &&
  negb (close f).
Definition opens f := contains_computed f && negb (above (size (value_of_face f)) error) || close f && near_face f.
Lemma next_is odd open f : next_face (odd, open) f = (xorb odd (adds f), open || opens f).
Proof.
unfold next_face, adds, opens, close, near_face, contains_computed, left_computed, least_turn, counted_turn,
  value_of_turn, value_of_face.
destruct f as [[[[[a0 a1] a2] [[b0 b1] b2]] [[c0 c1] c2]] o].
set (numbers := numbers_of_face _). clearbody numbers. destruct numbers as [[[n9 n10] n11] n12].
destruct (boxes _) as [[[[l1 h1] l2] h2] h0].
cbn [edges_of map fold_left existsb].
set (m0 := numbers_of_turn (seen (a0, a1, a2), seen (b0, b1, b2))).
set (m1 := numbers_of_turn (seen (b0, b1, b2), seen (c0, c1, c2))).
set (m2 := numbers_of_turn (seen (c0, c1, c2), seen (a0, a1, a2))). clearbody m0 m1 m2. cbn [seen fst snd].
destruct m0 as [[n0 n1] n2], m1 as [[n3 n4] n5], m2 as [[n6 n7] n8].
unfold lane_solid_next, lane_linear_2, lane_linear_3. cbv zeta. change (negative_lane (number 0 0)) with false.
rewrite !andb_true_r. cbn [orb]. rewrite !orb_false_r, !orb_assoc. unfold low, lower_of. cbn [fst snd].
set (near := negb (above l1 p1 || _ || _ || _ || _)). clearbody near.
match goal with |- (if others _ || negb ?z then _ else _) = _ => destruct z; cbn [negb andb] end.
- rewrite ?orb_false_r, ?andb_true_r. now destruct (others _).
- now rewrite orb_true_r, ?andb_false_r, ?orb_assoc.
Qed.
Lemma faces_folded fs : forall odd open, fold_left next_face fs (odd, open) =
  (fold_left xorb (map adds fs) odd, open || existsb opens fs).
Proof.
induction fs as [|f fs IH]; intros odd open; cbn [fold_left map existsb]; [now rewrite orb_false_r|].
rewrite next_is, IH. now rewrite orb_assoc.
Qed.

Hypothesis outwards : Forall (fun '(_, _, _, o) => o = number 1 0) faces.
Lemma corner_of f : In f faces -> let '(a, b, c, _) := f in
  In a (all_corners faces) /\ In b (all_corners faces) /\ In c (all_corners faces).
Proof.
intros I. assert (O := outwards). rewrite Forall_forall in O. specialize (O f I).
destruct f as [[[a b] c] o]. subst o. unfold all_corners. rewrite !in_flat_map.
repeat split; exists (a, b, c, number 1 0); (split; [exact I|]); change (corners (a, b, c, number 1 0)) with [a; b; c];
  simpl; auto.
Qed.
Lemma turn_right f e : In f faces -> In e (edges_of f) -> beyond = false -> finite p1 -> finite p2 ->
  finite error_of_turns -> finite (value_of_turn e) /\ (above (size (value_of_turn e)) error_of_turns = true ->
    (negative_lane (value_of_turn e) = true -> turn_of e p1 p2 < 0) /\
    (negative_lane (value_of_turn e) = false -> turn_of e p1 p2 > 0)).
Proof.
intros I E B P1 P2 FE. assert (C := corner_of f I). destruct f as [[[a b] c] o]. destruct C as (A0 & B0 & C0).
assert (Box := corners_in_box). rewrite Forall_forall in Box. assert (FC := corners_finite).
rewrite Forall_forall in FC.
assert (Seen : forall v, In v (all_corners faces) -> (in_box o1 g1 (fst (seen v)) /\ in_box o2 g2 (snd (seen v))) /\
  finite_2 (seen v)).
{ intros [[x y] z] V. destruct (Box _ V) as (_ & ? & ?), (FC _ V) as (_ & ? & ?). repeat split; assumption || apply H
  || apply H0. }
assert (W : forall u v : point, e = (u, v) -> (in_box o1 g1 (fst u) /\ in_box o2 g2 (snd u)) /\ finite_2 u ->
  (in_box o1 g1 (fst v) /\ in_box o2 g2 (snd v)) /\ finite_2 v -> finite (value_of_turn e) /\
  (above (size (value_of_turn e)) error_of_turns = true ->
    (negative_lane (value_of_turn e) = true -> turn_of e p1 p2 < 0) /\
    (negative_lane (value_of_turn e) = false -> turn_of e p1 p2 > 0))).
{ intros u v -> ((U1 & U2) & FU1 & FU2) ((V1 & V2) & FV1 & FV2).
  assert (B' : (false || (above o1 p1 || above p1 g1)) || (above o2 p2 || above p2 g2) = false).
  { revert B. unfold beyond, lane_framed_3. intros [[_ H]%orb_false_iff H']%orb_false_iff. now rewrite H, H'. }
  destruct (lane_line_right fused o1 o2 g1 g2 (fst u) (snd u) (fst v) (snd v) p1 p2 U1 U2 V1 V2 B') as [S Z].
  split; [apply Z; [exact FE|repeat constructor; assumption]|]. intros K. apply (S K). }
destruct E as [<-|[<-|[<-|[]]]]; eapply W; try reflexivity; now apply Seen.
Qed.

Lemma error_of_turns_up f : In f faces -> up error_of_turns.
Proof.
intros I. assert (A := first_corner f I). destruct f as [[[[[a0 a1] a2] b] c] o].
assert (Box := corners_in_box). rewrite Forall_forall in Box. destruct (Box _ A) as (_ & A1 & A2).
assert (C := corners_finite). rewrite Forall_forall in C. destruct (C _ A) as (_ & C1 & C2).
assert (KF : forall x : float, finite x -> known x) by (now intros []).
apply up_error, up_times; [exact (up_extent _ _ _ (KF _ C1) A1)|exact (up_extent _ _ _ (KF _ C2) A2)].
Qed.
Lemma existsb_same (A : Type) (p q : A -> bool) l : (forall x, In x l -> p x = q x) -> existsb p l = existsb q l.
Proof.
induction l as [|x l IH]; intros H; [reflexivity|]. simpl. rewrite (H x (or_introl eq_refl)), IH; [reflexivity|].
intros y Y. apply H. now right.
Qed.
Lemma sure_right f : In f faces -> beyond = false -> finite p0 -> finite p1 -> finite p2 -> close f = false ->
  opens f = false -> Forall (fun e => turn_of e p1 p2 <> 0) (edges_of f) /\ contains_computed f = contains low f /\
  left_computed f = left_of low f /\ (contains low f = true -> side_of f p0 p1 p2 <> 0 /\
    negative_lane (value_of_face f) = Rlt_bool (side_of f p0 p1 p2) 0).
Proof.
intros I B P0 P1 P2 K O. unfold opens in O. apply orb_false_iff in O as [S _]. apply negb_false_iff in K.
assert (FE := above_bound _ _ K (error_of_turns_up f I)). assert (R := fun e E => turn_right f e I E B P1 P2 FE).
assert (FM : finite (number 9007199254740991 971))
  by (destruct (number_value 9007199254740991 971) as [M _]; [lia|lia|exact M]).
assert (FS : Forall finite (map (fun e => size (value_of_turn e)) (edges_of f))).
{ apply Forall_forall. intros y [x [<- X]]%in_map_iff. destruct (R x X) as [FX _]. now destruct (value_of_turn x). }
destruct (lesser_of_all _ FS _ FM) as [FL All]. fold (least_turn f) in FL, All.
assert (Sure : forall e, In e (edges_of f) -> turn_of e p1 p2 <> 0 /\
  negative_lane (value_of_turn e) = Rlt_bool (turn_of e p1 p2) 0).
{ intros e E. destruct (R e E) as [FX T]. rewrite Forall_forall in All.
  assert (L := All _ (in_map (fun e => size (value_of_turn e)) _ _ E)). apply (above_finite _ _ FL FE) in K.
  destruct T as [T1 T2].
  { apply above_finite; [now destruct (value_of_turn e)|exact FE|lra]. }
  destruct (negative_lane (value_of_turn e)); [specialize (T1 eq_refl)|specialize (T2 eq_refl)];
    (split; [lra|symmetry]); [apply Rlt_bool_true|apply Rlt_bool_false]; lra. }
assert (Same : forall e, In e (edges_of f) -> counted_turn e = crosses low p1 p2 e).
{ intros e E. unfold counted_turn, crosses. now rewrite (proj2 (Sure e E)). }
assert (C : contains_computed f = contains low f)
  by (unfold contains_computed, contains; f_equal; now apply map_ext_in).
split; [apply Forall_forall; intros e E; now apply Sure|]. split; [exact C|]. split.
- apply existsb_same. intros e E. now rewrite (Same e E), (proj2 (Sure e E)).
- intros T. rewrite C, T in S. cbn [andb] in S. apply negb_false_iff in S.
  assert (FE' := above_bound _ _ S (up_error _ (proj1 size_says))).
  destruct (face_of_solid f I B P0 P1 P2 FE') as [_ W]. destruct (W S) as [T1 T2].
  destruct (negative_lane (value_of_face f)); [specialize (T1 eq_refl)|specialize (T2 eq_refl)];
    (split; [lra|symmetry]); [apply Rlt_bool_true|apply Rlt_bool_false]; lra.
Qed.

Theorem lane_solid_right : let '(known, outside) := solid in known = true ->
  finite p0 /\ finite p1 /\ finite p2 /\
  ((outside = true /\ beyond_3 (all_corners faces) p0 p1 p2) \/
   exists (low : point -> bool) (looked : face -> bool),
     Forall (fun c => let v := seen c in (snd v < p2 -> low v = true) /\ (p2 < snd v -> low v = false))
       (all_corners faces) /\
     Forall (fun f => looked f = false -> near_face f = false) faces /\
     Forall (fun f => looked f = true -> Forall (fun e => turn_of e p1 p2 <> 0) (edges_of f) /\
       (contains low f = true -> side_of f p0 p1 p2 <> 0)) faces /\
     outside = negb (fold_left xorb (map (fun f => looked f && crosses_face low f) faces) false)).
Proof.
unfold solid. change lane_solid_first with (false, false). rewrite faces_folded. cbn [orb].
unfold lane_solid_answer. cbv zeta. intros [[[[_ K0]%andb_prop K1]%andb_prop K2]%andb_prop K]%andb_prop.
assert (P0 := finite_numbers _ K0). assert (P1 := finite_numbers _ K1). assert (P2 := finite_numbers _ K2).
clear K0 K1 K2. split; [exact P0|]. split; [exact P1|]. split; [exact P2|]. destruct beyond eqn:B.
{ left. split; [reflexivity|]. now apply beyond_box_3. }
right. cbn [orb] in *. apply negb_true_iff in K.
assert (Sure : forall f, In f faces -> opens f = false).
{ intros f I. apply not_true_is_false. intros T. apply not_true_iff_false in K. apply K. apply existsb_exists. now
  exists f. }
exists low, (fun f => negb (close f)). split; [|split; [|split]].
- apply Forall_forall. intros [[x y] z] V. assert (C := corners_finite). rewrite Forall_forall in C.
  destruct (C _ V) as (_ & _ & Z). apply difference_sign; assumption.
- apply Forall_forall. intros f I N. apply negb_false_iff in N. specialize (Sure f I). unfold opens in Sure.
  now apply orb_false_iff in Sure as [_ S]; rewrite N in S.
- apply Forall_forall. intros f I N. apply negb_true_iff in N.
  destruct (sure_right f I B P0 P1 P2 N (Sure f I)) as (T & _ & _ & S). split; [exact T|]. intros C. now apply S.
- do 2 f_equal. apply map_ext_in. intros f I. unfold adds, crosses_face. rewrite andb_comm.
  destruct (close f) eqn:N; [reflexivity|]. cbn [negb andb].
  destruct (sure_right f I B P0 P1 P2 N (Sure f I)) as (_ & C & L & S). rewrite C, L.
  destruct (contains low f) eqn:T; [|reflexivity]. cbn [andb]. destruct (S eq_refl) as [_ ->]. reflexivity.
Qed.
End Solid.
