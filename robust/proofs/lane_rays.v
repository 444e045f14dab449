(* SPDX-License-Identifier: Apache-2.0 *)
(* The faces that a filter counts are those that the ray to +x meets. *)
From Coq Require Import Reals ZArith Lra Psatz Bool List.
From Flocq Require Import Core.
From Filters Require Import floats lanes lane_linear lane_linear_sides lane_rings lane_solids lane_hulls.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.

(* Three products that are not on different sides of 0. *)
Lemma all_zero x y z a b c : x <> 0 -> y <> 0 -> z <> 0 -> x * a + y * b + z * c = 0 ->
  (0 <= x * a /\ 0 <= y * b /\ 0 <= z * c) \/ (x * a <= 0 /\ y * b <= 0 /\ z * c <= 0) -> a = 0 /\ b = 0 /\ c = 0.
Proof.
intros X Y Z S D. assert (x * a = 0 /\ y * b = 0 /\ z * c = 0) as (A & B & C) by (destruct D as [D|D]; lra).
apply Rmult_integral in A, B, C. repeat split; tauto.
Qed.
Definition counts (la lb : bool) t := xorb la lb && negb (xorb (Rlt_bool t 0) lb).
(* Heights of corners over the point, and turns of edges: what the heights say together with the turns. *)
Lemma parity_says (la lb lc : bool) za zb zc x y z :
  (if la then za <= 0 else 0 <= za) -> (if lb then zb <= 0 else 0 <= zb) -> (if lc then zc <= 0 else 0 <= zc) ->
  x <> 0 -> y <> 0 -> z <> 0 -> x * zc + y * za + z * zb = 0 -> ~ (za = 0 /\ zb = 0 /\ zc = 0) ->
  let odd := xorb (xorb (xorb false (counts la lb x)) (counts lb lc y)) (counts lc la z) in
  let left := counts la lb x && negb (Rlt_bool x 0) || (counts lb lc y && negb (Rlt_bool y 0) ||
    (counts lc la z && negb (Rlt_bool z 0) || false)) in
  (odd = true /\ left = true /\ 0 < x /\ 0 < y /\ 0 < z) \/ (odd = true /\ left = false /\ x < 0 /\ y < 0 /\ z < 0) \/
  (odd = false /\ ~ (0 <= x /\ 0 <= y /\ 0 <= z) /\ ~ (x <= 0 /\ y <= 0 /\ z <= 0)).
Proof.
intros A B C X Y Z S N odd left.
assert (Q : (0 <= x * zc /\ 0 <= y * za /\ 0 <= z * zb) \/ (x * zc <= 0 /\ y * za <= 0 /\ z * zb <= 0) -> False).
{ intros D. destruct (all_zero x y z zc za zb X Y Z S D) as (? & ? & ?). tauto. }
unfold odd, left, counts. clear odd left.
destruct (Rlt_bool_spec x 0) as [LX|LX], (Rlt_bool_spec y 0) as [LY|LY], (Rlt_bool_spec z 0) as [LZ|LZ];
  destruct la, lb, lc; cbn [xorb negb andb orb];
  first [left; repeat split; lra | right; left; repeat split; lra | right; right; split; [reflexivity|split; lra] |
    exfalso; apply Q; left; repeat split; nra | exfalso; apply Q; right; repeat split; nra].
Qed.

Lemma hull_of_three a b c q0 q1 q2 : hull_3 [a; b; c] q0 q1 q2 <-> exists r s t, 0 <= r /\ 0 <= s /\ 0 <= t /\
  r + s + t = 1 /\ q0 = r * x_of a + s * x_of b + t * x_of c /\ q1 = r * y_of a + s * y_of b + t * y_of c /\
  q2 = r * z_of a + s * z_of b + t * z_of c.
Proof.
split.
- intros (ws & [W S] & A & B & C). exists (nth 0 ws 0), (nth 1 ws 0), (nth 2 ws 0).
  assert (N : forall n, 0 <= nth n ws 0).
  { intros n. destruct (nth_in_or_default n ws 0) as [I|E]; [|rewrite E; apply Rle_refl].
    rewrite Forall_forall in W. now apply W. }
  repeat (split; [apply N|]). rewrite <- A, <- B, <- C. clear A B C.
  destruct ws as [|r [|s [|t [|u ws]]]]; cbn [weighted nth] in *; repeat split; lra.
- intros (r & s & t & R & S & T & E & -> & -> & ->). exists [r; s; t]. split; [split|]; cbn [weighted].
  + apply Forall_cons; [exact R|apply Forall_cons; [exact S|apply Forall_cons; [exact T|apply Forall_nil]]].
  + lra.
  + repeat split; ring.
Qed.

(* A point of the ray is in the face. *)
Definition meets f (p0 p1 p2 : R) := exists t, 0 <= t /\ hull_3 (corners f) (p0 + t) p1 p2.
Section Face.
Variables (f : face) (low : point -> bool) (p0 p1 p2 : float).
Hypothesis outwards : let '(_, _, _, o) := f in o = number 1 0.
Hypothesis lows : Forall (fun c => let v := seen c in (value (snd v) < p2 -> low v = true) /\
  (p2 < value (snd v) -> low v = false)) (corners f).

Lemma height_says (v : point) : (snd v < p2 -> low v = true) /\ (p2 < snd v -> low v = false) ->
  if low v then snd v - p2 <= 0 else 0 <= snd v - p2.
Proof.
intros [A B]. destruct (Rtotal_order (snd v) p2) as [L|[L|L]]; [rewrite (A L); lra| |rewrite (B L); lra].
destruct (low v); lra.
Qed.
Hypothesis off_lines : Forall (fun e => turn_of e p1 p2 <> 0) (edges_of f).
Hypothesis off_plane : contains p1 p2 low f = true -> side_of f p0 p1 p2 <> 0.
Lemma crosses_says : (crosses_face p0 p1 p2 low f = true <-> meets f p0 p1 p2) /\ ~ hull_3 (corners f) p0 p1 p2.
Proof.
destruct f as [[[[[a0 a1] a2] [[b0 b1] b2]] [[c0 c1] c2]] o]. subst o.
change (corners _) with [(a0, a1, a2); (b0, b1, b2); (c0, c1, c2)] in *.
apply Forall_cons_iff in lows as [LA [LB [LC _]%Forall_cons_iff]%Forall_cons_iff].
cbn [edges_of] in off_lines. apply Forall_cons_iff in off_lines as [X [Y [Z _]%Forall_cons_iff]%Forall_cons_iff].
cbv zeta in LA, LB, LC. apply height_says in LA, LB, LC.
unfold crosses_face, contains, left_of, side_of in *. cbn [edges_of map fold_left existsb] in *.
unfold crosses in *. cbn [seen fst snd] in *.
set (x := turn_of (a1, a2, (b1, b2)) p1 p2) in *. set (y := turn_of (b1, b2, (c1, c2)) p1 p2) in *.
set (z := turn_of (c1, c2, (a1, a2)) p1 p2) in *.
assert (EX : x = turn a1 a2 b1 b2 p1 p2) by reflexivity. assert (EY : y = turn b1 b2 c1 c2 p1 p2) by reflexivity.
assert (EZ : z = turn c1 c2 a1 a2 p1 p2) by reflexivity. unfold turn in EX, EY, EZ.
destruct (number_value 1 0) as [_ VO]; [easy|easy|]. rewrite Rmult_1_l in VO. change (bpow radix2 0) with 1 in VO.
rewrite VO, Rmult_1_l in *. set (side := volume _ _ _ _ _ _ _ _ _ _ _ _) in *.
assert (S : side = (x + y + z) * p0 - (y * a0 + z * b0 + x * c0))
  by (unfold side, volume, lane_faces.face_exact; rewrite EX, EY, EZ; ring).
assert (P := parity_says (low (a1, a2)) (low (b1, b2)) (low (c1, c2)) (a2 - p2) (b2 - p2) (c2 - p2) x y z
  LA LB LC X Y Z ltac:(rewrite EX, EY, EZ; ring)).
set (la := low (a1, a2)) in *. set (lb := low (b1, b2)) in *. set (lc := low (c1, c2)) in *. cbv zeta in P.
set (odd := xorb (xorb (xorb false (counts la lb x)) (counts lb lc y)) (counts lc la z)) in P.
set (left := counts la lb x && negb (Rlt_bool x 0) || _) in P.
change (odd = true -> side <> 0) in off_plane.
change ((odd && negb (xorb left (Rlt_bool side 0)) = true <-> exists t, 0 <= t /\
  hull_3 [(a0, a1, a2); (b0, b1, b2); (c0, c1, c2)] (p0 + t) p1 p2) /\
  ~ hull_3 [(a0, a1, a2); (b0, b1, b2); (c0, c1, c2)] p0 p1 p2).
clearbody odd left. specialize (P ltac:(intros (A & B & C); apply X; change (x = 0); rewrite EX;
  replace (b2 - a2) with 0 by lra; replace (p2 - a2) with 0 by lra; ring)).
clearbody x y z side la lb lc.
(* the face has a point on the line only where all turns have the same sign, and at one place *)
assert (H : forall q0, hull_3 [(a0, a1, a2); (b0, b1, b2); (c0, c1, c2)] q0 p1 p2 ->
  ((0 <= x /\ 0 <= y /\ 0 <= z) \/ (x <= 0 /\ y <= 0 /\ z <= 0)) /\ (x + y + z) * q0 = y * a0 + z * b0 + x * c0).
{ intros q0 (r & s & t & R & S' & T & E & -> & E1 & E2)%hull_of_three. cbn [x_of y_of z_of] in *.
  set (n := (b1 - a1) * (c2 - a2) - (b2 - a2) * (c1 - a1)).
  assert (r = 1 - s - t) as -> by lra.
  assert (Yn : y = (1 - s - t) * n) by (rewrite EY, E1, E2; unfold n; ring).
  assert (Zn : z = s * n) by (rewrite EZ, E1, E2; unfold n; ring).
  assert (Xn : x = t * n) by (rewrite EX, E1, E2; unfold n; ring).
  split; [|rewrite Xn, Yn, Zn; ring]. rewrite Xn, Yn, Zn. clearbody n. clear - R S' T.
  destruct (Rle_or_lt 0 n); [left|right]; repeat split; nra. }
assert (G : forall k, x + y + z <> 0 -> 0 <= y / (x + y + z) -> 0 <= z / (x + y + z) -> 0 <= x / (x + y + z) ->
  p0 + k = (y * a0 + z * b0 + x * c0) / (x + y + z) ->
  hull_3 [(a0, a1, a2); (b0, b1, b2); (c0, c1, c2)] (p0 + k) p1 p2).
{ intros k N R1 R2 R3 E. apply hull_of_three. exists (y / (x + y + z)), (z / (x + y + z)), (x / (x + y + z)).
  cbn [x_of y_of z_of]. repeat (split; [assumption|]). split; [field; exact N|]. split; [rewrite E; field; exact N|].
  assert (Q1 : p1 * (x + y + z) = y * a1 + z * b1 + x * c1) by (rewrite EX, EY, EZ; ring).
  assert (Q2 : p2 * (x + y + z) = y * a2 + z * b2 + x * c2) by (rewrite EX, EY, EZ; ring).
  split; apply Rmult_eq_reg_r with (x + y + z); try exact N; [rewrite Q1|rewrite Q2]; field; exact N. }
clear EX EY EZ.
destruct P as [(-> & -> & PX & PY & PZ)|[(-> & -> & PX & PY & PZ)|(-> & N1 & N2)]]; cbn [andb xorb].
- specialize (off_plane eq_refl). split.
  + split.
    * intros L. destruct (Rlt_bool_spec side 0) as [LS|LS]; [|discriminate L]. exists (- side / (x + y + z)). split.
      -- apply Rle_mult_inv_pos; lra.
      -- apply G; try (apply Rle_mult_inv_pos; lra); try lra. rewrite S. field. lra.
    * intros (t & T & [_ E]%H). rewrite Rlt_bool_true; [reflexivity|]. assert ((x + y + z) * t = - side) by lra.
      assert (0 <= (x + y + z) * t) by (apply Rmult_le_pos; lra). lra.
  + intros [_ E]%H. lra.
- specialize (off_plane eq_refl). split.
  + split.
    * intros L. destruct (Rlt_bool_spec side 0) as [LS|LS]; [discriminate L|]. exists (- side / (x + y + z)).
      assert (I : forall r, r <= 0 -> 0 <= r / (x + y + z)).
      { intros r R. replace (r / (x + y + z)) with (- r / - (x + y + z)) by (field; lra). apply Rle_mult_inv_pos; lra. }
      split; [apply I; lra|]. apply G; try (apply I; lra); try lra. rewrite S. field. lra.
    * intros (t & T & [_ E]%H). rewrite Rlt_bool_false; [reflexivity|]. assert ((x + y + z) * t = - side) by lra.
      assert (0 <= - (x + y + z) * t) by (apply Rmult_le_pos; lra). lra.
  + intros [_ E]%H. lra.
- split; [|intros [[A|A] _]%H; tauto]. split; [discriminate|]. intros (t & _ & [[A|A] _]%H); tauto.
Qed.
End Face.

(* The box of a face holds its corners. *)
Definition boxed (boxes : face -> float * float * float * float * float) f := let '(l1, h1, l2, h2, h0) := boxes f in
  Forall finite [l1; h1; l2; h2; h0] /\
  Forall (fun v => l1 <= y_of v <= h1 /\ l2 <= z_of v <= h2 /\ x_of v <= h0) (corners f).
Lemma not_near_misses boxes f (p0 p1 p2 : float) t : boxed boxes f -> finite p0 -> finite p1 -> finite p2 ->
  near_face p0 p1 p2 boxes f = false -> 0 <= t -> ~ hull_3 (corners f) (p0 + t) p1 p2.
Proof.
unfold boxed, near_face. destruct (boxes f) as [[[[l1 h1] l2] h2] h0]. intros [F B] P0 P1 P2 N T.
repeat apply Forall_cons_iff in F as [? F]. apply beyond_hull_3. apply negb_false_iff in N.
assert (K : forall g : float -> float -> float -> Prop, (forall x y z, l1 <= value y <= h1 /\ l2 <= value z <= h2 /\
  value x <= h0 -> g x y z) -> Forall (fun '(x, y, z) => g x y z) (corners f)).
{ intros g G. apply Forall_impl with (2 := B). intros [[x y] z] V. now apply G. }
unfold beyond_3. apply orb_true_iff in N as [[[[N|N]%orb_true_iff|N]%orb_true_iff|N]%orb_true_iff|N];
  apply above_finite in N; try assumption.
- do 2 right. left. apply (K (fun _ y _ => p1 < y)). intros; lra.
- do 3 right. left. apply (K (fun _ y _ => y < p1)). intros; lra.
- do 4 right. left. apply (K (fun _ _ z => p2 < z)). intros; lra.
- do 5 right. apply (K (fun _ _ z => z < p2)). intros; lra.
- right. left. apply (K (fun x _ _ => x < p0 + t)). intros; lra.
Qed.

(* Where it answers, a point is outside because it is beyond all corners; or it is on no face, and outside if and only
   if the ray to +x meets an even number of faces. *)
Theorem solid_counts fused faces (p0 p1 p2 : float) boxes others : Forall valid_face faces ->
  Forall (fun '(_, _, _, o) => o = number 1 0) faces -> Forall (boxed boxes) faces ->
  let '(known, outside) := solid fused faces p0 p1 p2 boxes others in known = true ->
  (outside = true /\ beyond_3 (all_corners faces) p0 p1 p2) \/
  (Forall (fun f => ~ hull_3 (corners f) p0 p1 p2) faces /\ exists met : face -> bool,
    Forall (fun f => met f = true <-> meets f p0 p1 p2) faces /\
    outside = negb (fold_left xorb (map met faces) false)).
Proof.
intros F O B. assert (W := lane_solid_right fused faces p0 p1 p2 F boxes others O).
destruct (solid fused faces p0 p1 p2 boxes others) as [known outside]. intros K.
destruct (W K) as (P0 & P1 & P2 & [W'|(low & looked & L & M & E & ->)]); [now left|]. right. clear W K.
rewrite Forall_forall in O, B, L, M, E.
assert (C : forall f, In f faces -> ((looked f && crosses_face p0 p1 p2 low f = true) <->
  meets f p0 p1 p2) /\ ~ hull_3 (corners f) p0 p1 p2).
{ intros f I. destruct (looked f) eqn:N; cbn [andb].
  - destruct (E f I N) as [T S]. apply crosses_says; [exact (O f I)| |exact T|exact S].
    apply Forall_forall. intros c V. apply L. apply in_flat_map. now exists f.
  - assert (A := fun t => not_near_misses boxes f p0 p1 p2 t (B f I) P0 P1 P2 (M f I N)). split.
    + split; [discriminate|]. intros (t & T & H). now destruct (A t T).
    + intros H. apply (A 0 (Rle_refl 0)). now rewrite Rplus_0_r. }
split; [apply Forall_forall; intros f I; now apply C|].
exists (fun f => looked f && crosses_face p0 p1 p2 low f). split; [|reflexivity].
apply Forall_forall. intros f I. now apply C.
Qed.
