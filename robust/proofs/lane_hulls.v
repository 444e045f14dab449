(* SPDX-License-Identifier: Apache-2.0 *)
(* A point that a filter finds outside of a convex shape is not in the hull of the vertices. *)
From Coq Require Import Reals Lra Psatz Bool List.
From Filters Require Import floats lane_rings lane_solids.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.

(* The sum of weights times what a function is of the points. *)
Fixpoint weighted {A} (ws : list R) (f : A -> R) (points : list A) :=
  match ws, points with w :: ws, x :: points => w * f x + weighted ws f points | _, _ => 0 end.
Definition weights {A} (ws : list R) (points : list A) :=
  Forall (fun w => 0 <= w) ws /\ weighted ws (fun _ => 1) points = 1.
Definition hull_2 (points : list point) (p0 p1 : R) := exists ws, weights ws points /\
  weighted ws (fun v : point => value (fst v)) points = p0 /\
  weighted ws (fun v : point => value (snd v)) points = p1.
Definition x_of (v : corner) : R := let '(x, _, _) := v in value x.
Definition y_of (v : corner) : R := let '(_, y, _) := v in value y.
Definition z_of (v : corner) : R := let '(_, _, z) := v in value z.
Definition hull_3 (points : list corner) (p0 p1 p2 : R) := exists ws, weights ws points /\
  weighted ws x_of points = p0 /\ weighted ws y_of points = p1 /\ weighted ws z_of points = p2.

Lemma weighted_below {A} ws f (points : list A) : Forall (fun w => 0 <= w) ws -> Forall (fun x => f x <= 0) points ->
  weighted ws f points <= 0.
Proof.
intros W. revert points. induction W as [|w ws P W IH]; intros [|x points] F; simpl; try lra.
apply Forall_cons_iff in F as [X F]. specialize (IH _ F). nra.
Qed.
Lemma weighted_beyond {A} ws f (points : list A) : Forall (fun w => 0 <= w) ws -> Forall (fun x => f x < 0) points ->
  0 < weighted ws (fun _ => 1) points -> weighted ws f points < 0.
Proof.
intros W. revert points. induction W as [|w ws P W IH]; intros [|x points] F; simpl; try lra.
apply Forall_cons_iff in F as [X F]. intros S. destruct (Rle_lt_or_eq_dec _ _ P) as [Q|<-].
- assert (weighted ws f points <= 0); [|nra]. apply weighted_below; [exact W|].
  apply Forall_impl with (2 := F). intros y Y. lra.
- specialize (IH _ F). lra.
Qed.
Lemma weighted_sum {A} ws f g (points : list A) : weighted ws (fun x => f x + g x) points =
  weighted ws f points + weighted ws g points.
Proof.
revert points. induction ws as [|w ws IH]; intros [|x points]; simpl; try lra. rewrite IH. lra.
Qed.
Lemma weighted_times {A} ws c f (points : list A) : weighted ws (fun x => c * f x) points = c * weighted ws f points.
Proof.
revert points. induction ws as [|w ws IH]; intros [|x points]; simpl; try lra. rewrite IH. lra.
Qed.
Lemma weighted_same {A} ws f g (points : list A) : (forall x, f x = g x) -> weighted ws f points = weighted ws g points.
Proof.
intros E. revert points. induction ws as [|w ws IH]; intros [|x points]; simpl; try lra. now rewrite IH, E.
Qed.
(* Of a linear function: its value at the point that has these weights. *)
Lemma weighted_linear {A} ws (f g h k : A -> R) a b c d (points : list A) :
  (forall x, f x = a * g x + b * h x + c * k x + d) -> weights ws points ->
  weighted ws f points = a * weighted ws g points + b * weighted ws h points + c * weighted ws k points + d.
Proof.
intros E [_ S]. rewrite (weighted_same ws f (fun x => a * g x + (b * h x + (c * k x + d * 1)))) by (intros; rewrite E;
  ring). rewrite !weighted_sum, !weighted_times, S. ring.
Qed.

Lemma hull_2_below points p0 p1 f a b d : (forall v : point, f v = a * value (fst v) + b * value (snd v) + d) ->
  hull_2 points p0 p1 -> (Forall (fun v => f v <= 0) points -> a * p0 + b * p1 + d <= 0) /\
  (Forall (fun v => f v < 0) points -> a * p0 + b * p1 + d < 0).
Proof.
intros E (ws & W & P0 & P1). assert (L := weighted_linear ws f (fun v : point => value (fst v))
  (fun v : point => value (snd v)) (fun _ => 0) a b 0 d points ltac:(intros; rewrite E; ring) W).
change (@weighted (float * float)) with (@weighted point) in *. rewrite P0, P1, Rmult_0_l in L.
destruct W as [W S]. split; intros F.
- pose proof (weighted_below ws f points W F). lra.
- pose proof (weighted_beyond ws f points W F ltac:(lra)). lra.
Qed.
Lemma hull_3_below points p0 p1 p2 (f : corner -> R) a b c d :
  (forall x y z : float, f (x, y, z) = a * x + b * y + c * z + d) ->
  hull_3 points p0 p1 p2 -> (Forall (fun v : corner => f v <= 0) points -> a * p0 + b * p1 + c * p2 + d <= 0) /\
  (Forall (fun v : corner => f v < 0) points -> a * p0 + b * p1 + c * p2 + d < 0).
Proof.
intros E (ws & W & P0 & P1 & P2). assert (L := weighted_linear ws f x_of y_of z_of a b c d points
  ltac:(intros [[x y] z]; apply E) W).
rewrite P0, P1, P2 in L.
destruct W as [W S]. split; intros F.
- pose proof (weighted_below ws f points W F). lra.
- pose proof (weighted_beyond ws f points W F ltac:(lra)). lra.
Qed.

Ltac apart H f a b d := match goal with B : Forall _ ?points |- False =>
  destruct (hull_2_below points _ _ f a b d ltac:(intros; cbn beta; ring) H) as [_ L];
  specialize (L ltac:(apply Forall_impl with (2 := B); intros v V; cbn beta in *; lra)); lra end.
Lemma beyond_hull_2 points p0 p1 : beyond_2 points p0 p1 -> ~ hull_2 points p0 p1.
Proof.
intros B H. destruct B as [B|[B|[B|B]]].
- apart H (fun v : point => p0 - value (fst v)) (-1) 0 p0.
- apart H (fun v : point => value (fst v) - p0) 1 0 (- p0).
- apart H (fun v : point => p1 - value (snd v)) 0 (-1) p1.
- apart H (fun v : point => value (snd v) - p1) 0 1 (- p1).
Qed.
Lemma turn_of_hull points e s p0 p1 :
  Forall (fun v : point => s * turn_of e (value (fst v)) (value (snd v)) <= 0) points -> hull_2 points p0 p1 ->
  s * turn_of e p0 p1 <= 0.
Proof.
intros F H. destruct e as [[a0 a1] [b0 b1]]. unfold turn_of, lane_linear.turn in *. cbn [fst snd] in *.
destruct (hull_2_below points p0 p1 _ (- s * (b1 - a1)) (s * (b0 - a0)) (s * ((b1 - a1) * a0 - (b0 - a0) * a1))
  ltac:(intros v; instantiate (1 := fun v => s * ((b0 - a0) * (value (snd v) - a1) - (b1 - a1) * (value (fst v) - a0)));
    cbn beta; ring) H) as [L _].
specialize (L F). lra.
Qed.

(* With a vertex, and with two points of the hull all between. *)
Fixpoint blend (s t : R) (ws us : list R) := match ws, us with
  | [], us => map (Rmult t) us
  | ws, [] => map (Rmult s) ws
  | w :: ws, u :: us => s * w + t * u :: blend s t ws us end.
Lemma weighted_scaled {A} t ws f (points : list A) : weighted (map (Rmult t) ws) f points = t * weighted ws f points.
Proof.
revert points. induction ws as [|w ws IH]; intros [|x points]; simpl; try lra. rewrite IH. lra.
Qed.
Lemma blended {A} s t f : forall ws us (points : list A),
  weighted (blend s t ws us) f points = s * weighted ws f points + t * weighted us f points.
Proof.
induction ws as [|w ws IH]; intros us points.
- change (blend s t [] us) with (map (Rmult t) us). rewrite weighted_scaled. simpl. lra.
- destruct us as [|u us].
  + change (blend s t (w :: ws) []) with (map (Rmult s) (w :: ws)). rewrite weighted_scaled. simpl. lra.
  + destruct points as [|x points]; simpl; [lra|]. rewrite IH. lra.
Qed.
Lemma blend_pos s t ws us : 0 <= s -> 0 <= t -> Forall (fun w => 0 <= w) ws -> Forall (fun w => 0 <= w) us ->
  Forall (fun w => 0 <= w) (blend s t ws us).
Proof.
intros S T W. revert us. induction W as [|w ws P W IH]; intros us U.
- change (blend s t [] us) with (map (Rmult t) us). apply Forall_forall. intros y [x [<- I]]%in_map_iff.
  rewrite Forall_forall in U. apply Rmult_le_pos; auto.
- destruct U as [|u us Q U].
  + change (blend s t (w :: ws) []) with (map (Rmult s) (w :: ws)). apply Forall_forall.
    intros y [x [<- I]]%in_map_iff. apply Rmult_le_pos; [exact S|]. destruct I as [<-|I]; [exact P|].
    rewrite Forall_forall in W. auto.
  + simpl. constructor; [|now apply IH]. assert (0 <= s * w) by now apply Rmult_le_pos.
    assert (0 <= t * u) by now apply Rmult_le_pos. lra.
Qed.
Lemma hull_vertex points (v : point) : In v points -> hull_2 points (value (fst v)) (value (snd v)).
Proof.
intros I. enough (E : exists ws, Forall (fun w => 0 <= w) ws /\
  forall f : point -> R, weighted ws f points = f v).
{ destruct E as (ws & W & E). exists ws. split; [split; [exact W|apply E]|]. split; apply E. }
induction points as [|u points IH]; [easy|]. destruct I as [->|I].
- exists [1]. split; [repeat constructor; lra|]. intros f. simpl. lra.
- destruct (IH I) as (ws & W & E). exists (0 :: ws). split; [constructor; [lra|exact W]|]. intros f. simpl.
  rewrite E. lra.
Qed.
Lemma hull_between points a0 a1 b0 b1 s t : 0 <= s -> 0 <= t -> s + t = 1 -> hull_2 points a0 a1 ->
  hull_2 points b0 b1 -> hull_2 points (s * a0 + t * b0) (s * a1 + t * b1).
Proof.
intros S T E (ws & [W1 W2] & WA & WB) (us & [U1 U2] & UA & UB). exists (blend s t ws us).
unfold weights. rewrite !blended, W2, U2, WA, WB, UA, UB. split; [split; [now apply blend_pos|lra]|]. now split.
Qed.
Lemma hull_triangle (points : list point) (a b c : point) p0 p1 : In a points -> In b points -> In c points ->
  0 < turn_of (b, c) p0 p1 -> 0 <= turn_of (c, a) p0 p1 -> 0 <= turn_of (a, b) p0 p1 -> hull_2 points p0 p1.
Proof.
intros A B C TA TB TC. destruct a as [a0 a1], b as [b0 b1], c as [c0 c1]. unfold turn_of, lane_linear.turn in *.
cbn [fst snd] in *. set (ta := _ - _) in TA. set (tb := _ - _) in TB. set (tc := _ - _) in TC.
assert (Q := hull_between points _ _ _ _ (ta / (ta + tb)) (tb / (ta + tb)) ltac:(apply Rle_mult_inv_pos; lra)
  ltac:(apply Rle_mult_inv_pos; lra) ltac:(field; lra) (hull_vertex _ _ A) (hull_vertex _ _ B)).
assert (S := hull_between points _ _ _ _ ((ta + tb) / (ta + tb + tc)) (tc / (ta + tb + tc))
  ltac:(apply Rle_mult_inv_pos; lra) ltac:(apply Rle_mult_inv_pos; lra) ltac:(field; lra) Q (hull_vertex _ _ C)).
cbn [fst snd] in S.
assert (E0 : p0 * (ta + tb + tc) = ta * a0 + tb * b0 + tc * c0) by (unfold ta, tb, tc; ring).
assert (E1 : p1 * (ta + tb + tc) = ta * a1 + tb * b1 + tc * c1) by (unfold ta, tb, tc; ring).
replace p0 with ((ta + tb) / (ta + tb + tc) * (ta / (ta + tb) * a0 + tb / (ta + tb) * b0) + tc / (ta + tb + tc) * c0).
replace p1 with ((ta + tb) / (ta + tb + tc) * (ta / (ta + tb) * a1 + tb / (ta + tb) * b1) + tc / (ta + tb + tc) * c1).
- exact S.
- apply Rmult_eq_reg_r with (ta + tb + tc); [|lra]. rewrite E1. field. split; lra.
- apply Rmult_eq_reg_r with (ta + tb + tc); [|lra]. rewrite E0. field. split; lra.
Qed.
Lemma turn_back (a b : point) p0 p1 : turn_of (b, a) p0 p1 = - turn_of (a, b) p0 p1.
Proof. unfold turn_of, lane_linear.turn. ring. Qed.
Lemma last_any {A} (rest : list A) c a b : last (c :: rest) a = last (c :: rest) b.
Proof. revert c. induction rest as [|d rest IH]; intros c; [reflexivity|]. exact (IH d). Qed.
Lemma last_begun {A} (rest : list A) c a : last (c :: rest) a = last rest c.
Proof.
destruct rest as [|d rest]; [reflexivity|]. exact (last_any rest d a c).
Qed.
(* As seen from a vertex, the others go from one side of a point to the other. *)
Lemma passes s (o : point) p0 p1 all rest : forall a : point, In a all -> incl rest all ->
  s * turn_of (o, a) p0 p1 > 0 ->
  Forall (fun e => s * turn_of e p0 p1 > 0) (edges_from a rest) -> s * turn_of (o, last rest a) p0 p1 <= 0 ->
  exists b c : point, In b all /\ In c all /\ s * turn_of (o, b) p0 p1 > 0 /\ s * turn_of (o, c) p0 p1 <= 0 /\
    s * turn_of (b, c) p0 p1 > 0.
Proof.
induction rest as [|c rest IH]; intros a A R HA E L; [exfalso; cbn [last] in L; lra|]. cbn [edges_from] in E.
apply Forall_cons_iff in E as [E1 E]. assert (C : In c all) by (apply R; now left).
destruct (Rle_or_lt (s * turn_of (o, c) p0 p1) 0) as [Q|Q]; [exists a, c; auto|].
apply (IH c C); auto.
- intros x X. apply R. now right.
- now rewrite <- (last_begun rest c a).
Qed.
Lemma surrounded (points : list point) p0 p1 s : s = 1 \/ s = -1 -> points <> [] ->
  Forall (fun e => s * turn_of e p0 p1 > 0) (edges points) -> hull_2 points p0 p1.
Proof.
intros S N E. destruct points as [|o rest]; [easy|]. unfold edges in E. cbn [edges_from] in E.
apply Forall_cons_iff in E as [E0 E]. assert (O : In o (o :: rest)) by now left.
destruct rest as [|a rest].
{ exfalso. cbn [last] in E0. pose proof (turn_back o o p0 p1) as Z.
  assert (W : forall x, x = - x -> x = 0) by (intros; lra). apply W in Z. rewrite Z in E0. lra. }
cbn [edges_from] in E. apply Forall_cons_iff in E as [E1 E].
set (all := o :: a :: rest) in *. change (last all (lane_boxes.zero, lane_boxes.zero)) with
  (last (a :: rest) (lane_boxes.zero, lane_boxes.zero)) in E0.
rewrite last_begun, turn_back in E0.
destruct (passes s o p0 p1 all rest a ltac:(right; now left) ltac:(intros x X; right; now right) E1 E ltac:(lra))
  as (b & c & B & C & HB & HC & T).
destruct S as [-> | ->].
- apply (hull_triangle all o b c); auto; try lra. rewrite turn_back. lra.
- apply (hull_triangle all o c b); auto; rewrite ?(turn_back b c), ?(turn_back o b); lra.
Qed.

Theorem convex_ring_inside fused points (p0 p1 : float) : Forall lane_linear_sides.finite_2 points ->
  let '(known, outside) := convex_ring fused points p0 p1 in known = true -> outside = false -> hull_2 points p0 p1.
Proof.
intros F. assert (W := lane_convex_ring_right fused points p0 p1 F).
assert (N : points = [] -> fst (convex_ring fused points p0 p1) = false) by (intros ->; reflexivity).
destruct (convex_ring fused points p0 p1) as [known outside]. intros K O. simpl in N.
assert (N' : points <> []) by (intros Q; rewrite (N Q) in K; discriminate).
destruct (W K) as (_ & _ & W' & _). destruct (W' O) as [L|L];
  [apply (surrounded points p0 p1 1)|apply (surrounded points p0 p1 (-1))]; auto;
  apply Forall_impl with (2 := L); intros e E; lra.
Qed.

(* All vertices are on one side of each edge's line. *)
Theorem convex_ring_outside fused points (p0 p1 : float) : Forall lane_linear_sides.finite_2 points ->
  (exists s, (s = 1 \/ s = -1) /\ Forall (fun e => Forall (fun v : point =>
    s * turn_of e (value (fst v)) (value (snd v)) <= 0) points) (edges points)) ->
  let '(known, outside) := convex_ring fused points p0 p1 in known = true -> outside = true ->
  ~ hull_2 points p0 p1.
Proof.
intros F (s & S & C). assert (W := lane_convex_ring_right fused points p0 p1 F).
destruct (convex_ring fused points p0 p1) as [known outside]. intros K O.
destruct (W K) as (_ & _ & _ & W'). destruct (W' O) as [B|[P N]]; [now apply beyond_hull_2|]. intros H.
apply Exists_exists in P as (e & E & P). apply Exists_exists in N as (e' & E' & N). rewrite Forall_forall in C.
pose proof (turn_of_hull points e s _ _ (C e E) H). pose proof (turn_of_hull points e' s _ _ (C e' E') H).
destruct S as [-> | ->]; lra.
Qed.

Ltac apart_3 H f a b c d := match goal with B : Forall _ ?points |- False =>
  destruct (hull_3_below points _ _ _ f a b c d ltac:(intros; cbn; ring) H) as [_ L];
  specialize (L ltac:(apply Forall_impl with (2 := B); intros [[x y] z] V; cbn in *; lra)); lra end.
Lemma beyond_hull_3 points p0 p1 p2 : beyond_3 points p0 p1 p2 -> ~ hull_3 points p0 p1 p2.
Proof.
intros B H. destruct B as [B|[B|[B|[B|[B|B]]]]].
- apart_3 H (fun v => p0 - x_of v) (-1) 0 0 p0.
- apart_3 H (fun v => x_of v - p0) 1 0 0 (- p0).
- apart_3 H (fun v => p1 - y_of v) 0 (-1) 0 p1.
- apart_3 H (fun v => y_of v - p1) 0 1 0 (- p1).
- apart_3 H (fun v => p2 - z_of v) 0 0 (-1) p2.
- apart_3 H (fun v => z_of v - p2) 0 0 1 (- p2).
Qed.
Definition side_at f (v : corner) := let '(x, y, z) := v in side_of f (value x) (value y) (value z).
Lemma side_of_hull points f p0 p1 p2 : Forall (fun v => side_at f v <= 0) points -> hull_3 points p0 p1 p2 ->
  side_of f p0 p1 p2 <= 0.
Proof.
intros F H. destruct f as [[[[[a0 a1] a2] [[b0 b1] b2]] [[c0 c1] c2]] o].
set (n0 := (b1 - a1) * (c2 - a2) - (b2 - a2) * (c1 - a1)). set (n1 := (b2 - a2) * (c0 - a0) - (b0 - a0) * (c2 - a2)).
set (n2 := (b0 - a0) * (c1 - a1) - (b1 - a1) * (c0 - a0)).
destruct (hull_3_below points p0 p1 p2 (side_at (a0, a1, a2, (b0, b1, b2), (c0, c1, c2), o)) (o * n0) (o * n1) (o * n2)
  (- (o * (n0 * a0 + n1 * a1 + n2 * a2)))) as [L _]; [|exact H|].
- intros x y z. unfold side_at, side_of, lane_linear_sides.volume, lane_faces.face_exact, n0, n1, n2. ring.
- specialize (L F). unfold side_of, lane_linear_sides.volume, lane_faces.face_exact. unfold n0, n1, n2 in L. lra.
Qed.

(* No vertex is in front of a face's plane. *)
Theorem convex_solid_outside fused faces (p0 p1 p2 : float) : Forall valid_face faces ->
  Forall (fun f => Forall (fun v => side_at f v <= 0) (all_corners faces)) faces ->
  let '(known, outside) := convex_solid fused faces p0 p1 p2 in known = true -> outside = true ->
  ~ hull_3 (all_corners faces) p0 p1 p2.
Proof.
intros F C. assert (W := lane_convex_solid_right fused faces p0 p1 p2 F).
destruct (convex_solid fused faces p0 p1 p2) as [known outside]. intros K O.
destruct (W K) as (_ & _ & _ & _ & W'). destruct (W' O) as [B|P]; [now apply beyond_hull_3|]. intros H.
apply Exists_exists in P as (f & I & P). rewrite Forall_forall in C.
pose proof (side_of_hull (all_corners faces) f _ _ _ (C f I) H). lra.
Qed.
