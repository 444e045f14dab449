(* SPDX-License-Identifier: Apache-2.0 *)
(* Two triangles in a lane: where the planes of both part the other's corners, their edges say what is common. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model floats lanes lane_faces lane_triangles.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.

(* Numbers that are not negative, with slopes: when the first of them is 0, and that none is so at once. *)
Definition held_up (s : R) (p : R * R) := 0 <= fst p + s * snd p.
Definition ends_at (s : R) (p : R * R) := fst p + s * snd p = 0.
Lemma first_end l : Forall (fun p => 0 <= fst p) l ->
  Forall (fun p => 0 <= snd p) l \/ exists s, 0 <= s /\ Forall (held_up s) l /\ Exists (ends_at s) l.
Proof.
induction l as [|[x a] l IH]; intros F; [left; constructor|]. apply Forall_cons_iff in F as [X F]. simpl in X.
destruct (Rle_or_lt 0 a) as [A|A].
- destruct (IH F) as [K|(s & S & H & E)]; [left; constructor; assumption|]. right. exists s.
  split; [exact S|]. split; [constructor; [unfold held_up; simpl; nra|exact H]|now constructor 2].
- right. set (r := x / - a). assert (P : 0 <= r) by (apply Rmult_le_pos; [exact X|left; apply Rinv_0_lt_compat; lra]).
  assert (Z : x + r * a = 0) by (unfold r; field; lra).
  destruct (IH F) as [K|(s & S & H & E)].
  + exists r. split; [exact P|]. split; [|constructor 1; exact Z]. constructor; [unfold held_up; simpl; lra|].
    apply Forall_forall. intros [y b] I. rewrite Forall_forall in F, K. specialize (F _ I). specialize (K _ I).
    unfold held_up. simpl in *. nra.
  + destruct (Rle_or_lt s r) as [L|L].
    * exists s. split; [exact S|]. split; [|now constructor 2]. constructor; [|exact H]. unfold held_up. simpl. nra.
    * exists r. split; [exact P|]. split; [|constructor 1; exact Z]. constructor; [unfold held_up; simpl; lra|].
      apply Forall_forall. intros [y b] I. rewrite Forall_forall in F, H. specialize (F _ I). specialize (H _ I).
      unfold held_up in *. simpl in *. nra.
Qed.
Lemma small_step l : Forall (fun p => 0 < fst p \/ fst p = 0 /\ 0 <= snd p) l -> exists s, 0 < s /\ Forall (held_up s)
  l.
Proof.
induction l as [|[x a] l IH]; intros F; [exists 1; split; [lra|constructor]|].
apply Forall_cons_iff in F as [X F]. simpl in X. destruct (IH F) as (s & S & H).
assert (W : forall r, 0 < r <= s -> Forall (held_up r) l).
{ intros r R. apply Forall_forall. intros [y b] I. rewrite Forall_forall in F, H. specialize (F _ I).
  specialize (H _ I). unfold held_up in *. simpl in *. nra. }
destruct (Rle_or_lt 0 a) as [A|A].
- exists s. split; [exact S|]. constructor; [unfold held_up; simpl; nra|exact H].
- assert (0 < x) by lra. set (r := x / - a).
  assert (P : 0 < r) by (apply Rmult_lt_0_compat; [lra|apply Rinv_0_lt_compat; lra]).
  assert (Z : x + r * a = 0) by (unfold r; field; lra). exists (Rmin r s). pose proof (Rmin_l r s).
  pose proof (Rmin_r r s).
  assert (0 < Rmin r s) by (now apply Rmin_glb_lt). split; [assumption|].
  constructor; [unfold held_up; simpl; nra|apply W; lra].
Qed.

(* Weights of three corners, and the point that they make of them. *)
Definition weights i j k := 0 <= i /\ 0 <= j /\ 0 <= k /\ i + j + k = 1.

Section Pair.
Variables ax ay az bx by_ bz cx cy cz px py pz qx qy qz rx ry rz : R.
(* How far the corners of one are beyond the other's plane. *)
Let at_a := volume px py pz qx qy qz rx ry rz ax ay az.
Let at_b := volume px py pz qx qy qz rx ry rz bx by_ bz.
Let at_c := volume px py pz qx qy qz rx ry rz cx cy cz.
Let at_p := volume ax ay az bx by_ bz cx cy cz px py pz.
Let at_q := volume ax ay az bx by_ bz cx cy cz qx qy qz.
Let at_r := volume ax ay az bx by_ bz cx cy cz rx ry rz.

Definition meeting i j k l m n := weights i j k /\ weights l m n /\
  i * ax + j * bx + k * cx = l * px + m * qx + n * rx /\ i * ay + j * by_ + k * cy = l * py + m * qy + n * ry /\
  i * az + j * bz + k * cz = l * pz + m * qz + n * rz.

(* Along the line of both planes: changes of weights that lead the same way in both triangles. *)
Let dx := (at_b - at_c) * ax + (at_c - at_a) * bx + (at_a - at_b) * cx.
Let dy := (at_b - at_c) * ay + (at_c - at_a) * by_ + (at_a - at_b) * cy.
Let dz := (at_b - at_c) * az + (at_c - at_a) * bz + (at_a - at_b) * cz.
Lemma along_x : dx = (at_r - at_q) * px + (at_p - at_r) * qx + (at_q - at_p) * rx.
Proof. unfold dx, at_a, at_b, at_c, at_p, at_q, at_r, volume, rise, face_exact. ring. Qed.
Lemma along_y : dy = (at_r - at_q) * py + (at_p - at_r) * qy + (at_q - at_p) * ry.
Proof. unfold dy, at_a, at_b, at_c, at_p, at_q, at_r, volume, rise, face_exact. ring. Qed.
Lemma along_z : dz = (at_r - at_q) * pz + (at_p - at_r) * qz + (at_q - at_p) * rz.
Proof. unfold dz, at_a, at_b, at_c, at_p, at_q, at_r, volume, rise, face_exact. ring. Qed.

Lemma meeting_moved i j k l m n s : meeting i j k l m n ->
  0 <= i + s * (at_b - at_c) -> 0 <= j + s * (at_c - at_a) -> 0 <= k + s * (at_a - at_b) ->
  0 <= l + s * (at_r - at_q) -> 0 <= m + s * (at_p - at_r) -> 0 <= n + s * (at_q - at_p) ->
  meeting (i + s * (at_b - at_c)) (j + s * (at_c - at_a)) (k + s * (at_a - at_b))
    (l + s * (at_r - at_q)) (m + s * (at_p - at_r)) (n + s * (at_q - at_p)).
Proof.
intros ((_ & _ & _ & S) & (_ & _ & _ & T) & X & Y & Z) ? ? ? ? ? ?. split; [repeat split; try assumption; lra|].
split; [repeat split; try assumption; lra|]. pose proof along_x as DX. pose proof along_y as DY.
pose proof along_z as DZ.
unfold dx in DX. unfold dy in DY. unfold dz in DZ. clear - X Y Z DX DY DZ.
set (u := at_b - at_c) in *. set (v := at_c - at_a) in *. set (w := at_a - at_b) in *.
set (u' := at_r - at_q) in *. set (v' := at_p - at_r) in *. set (w' := at_q - at_p) in *.
clearbody u v w u' v' w'. apply (f_equal (Rmult s)) in DX, DY, DZ. repeat split; lra.
Qed.

(* Where no edge of one meets the other, nothing does. *)
Notation unit := (fun t => 0 <= t <= 1).
Lemma edges_decide : ~ (at_a = at_b /\ at_b = at_c) ->
  (forall t x y z, ~ common unit ax ay az (bx - ax) (by_ - ay) (bz - az) px py pz qx qy qz rx ry rz t x y z) ->
  (forall t x y z, ~ common unit bx by_ bz (cx - bx) (cy - by_) (cz - bz) px py pz qx qy qz rx ry rz t x y z) ->
  (forall t x y z, ~ common unit cx cy cz (ax - cx) (ay - cy) (az - cz) px py pz qx qy qz rx ry rz t x y z) ->
  (forall t x y z, ~ common unit px py pz (qx - px) (qy - py) (qz - pz) ax ay az bx by_ bz cx cy cz t x y z) ->
  (forall t x y z, ~ common unit qx qy qz (rx - qx) (ry - qy) (rz - qz) ax ay az bx by_ bz cx cy cz t x y z) ->
  (forall t x y z, ~ common unit rx ry rz (px - rx) (py - ry) (pz - rz) ax ay az bx by_ bz cx cy cz t x y z) ->
  forall i j k l m n, ~ meeting i j k l m n.
Proof.
intros D EA EB EC EP EQ ER i j k l m n M.
set (list := [(i, at_b - at_c); (j, at_c - at_a); (k, at_a - at_b); (l, at_r - at_q); (m, at_p - at_r); (n, at_q -
  at_p)]).
destruct (first_end list) as [K|(s & S & H & E)].
- destruct M as ((I & J & K & _) & (L & M & N & _) & _).
  repeat (apply Forall_cons; [simpl; assumption|]). apply Forall_nil.
- apply D. unfold list in K. repeat apply Forall_cons_iff in K as [? K]. simpl in *. lra.
- unfold list in H, E. repeat apply Forall_cons_iff in H as [? H]. unfold held_up in *. simpl in *.
  assert (M' := meeting_moved _ _ _ _ _ _ s M ltac:(assumption) ltac:(assumption) ltac:(assumption) ltac:(assumption)
    ltac:(assumption) ltac:(assumption)).
  set (i' := i + s * (at_b - at_c)) in *. set (j' := j + s * (at_c - at_a)) in *.
  set (k' := k + s * (at_a - at_b)) in *.
  set (l' := l + s * (at_r - at_q)) in *. set (m' := m + s * (at_p - at_r)) in *.
  set (n' := n + s * (at_q - at_p)) in *.
  destruct M' as ((I & J & K & W) & (L & N & O & V) & X & Y & Z).
  repeat apply Exists_cons in E as [E|E]; [| | | | | |now apply Exists_nil in E]; unfold ends_at in E; simpl in E.
  + fold i' in E. clearbody i' j' k' l' m' n'. apply (EB k' l' m' n'). rewrite E in *.
  assert (j' = 1 - k') as -> by lra.
    repeat split; lra.
  + fold j' in E. clearbody i' j' k' l' m' n'. apply (EC i' l' m' n'). rewrite E in *.
  assert (k' = 1 - i') as -> by lra.
    repeat split; lra.
  + fold k' in E. clearbody i' j' k' l' m' n'. apply (EA j' l' m' n'). rewrite E in *.
  assert (i' = 1 - j') as -> by lra.
    repeat split; lra.
  + fold l' in E. clearbody i' j' k' l' m' n'. apply (EQ n' i' j' k'). rewrite E in *.
  assert (m' = 1 - n') as -> by lra.
    repeat split; lra.
  + fold m' in E. clearbody i' j' k' l' m' n'. apply (ER l' i' j' k'). rewrite E in *.
  assert (n' = 1 - l') as -> by lra.
    repeat split; lra.
  + fold n' in E. clearbody i' j' k' l' m' n'. apply (EP m' i' j' k'). rewrite E in *.
  assert (l' = 1 - m') as -> by lra.
    repeat split; lra.
Qed.

(* Points of both are on that line, for it is across both normals. *)
Definition in_both x y z := exists i j k l m n, meeting i j k l m n /\
  x = i * ax + j * bx + k * cx /\ y = i * ay + j * by_ + k * cy /\ z = i * az + j * bz + k * cz.
Let nx := (by_ - ay) * (cz - az) - (bz - az) * (cy - ay).
Let ny := (bz - az) * (cx - ax) - (bx - ax) * (cz - az).
Let nz := (bx - ax) * (cy - ay) - (by_ - ay) * (cx - ax).
Let ox := (qy - py) * (rz - pz) - (qz - pz) * (ry - py).
Let oy := (qz - pz) * (rx - px) - (qx - px) * (rz - pz).
Let oz := (qx - px) * (ry - py) - (qy - py) * (rx - px).
Lemma across_both : dx = oy * nz - oz * ny /\ dy = oz * nx - ox * nz /\ dz = ox * ny - oy * nx.
Proof.
unfold dx, dy, dz, nx, ny, nz, ox, oy, oz, at_a, at_b, at_c, volume, rise, face_exact. repeat split; ring.
Qed.
Lemma in_planes x y z : in_both x y z ->
  (x - ax) * nx + (y - ay) * ny + (z - az) * nz = 0 /\ (x - px) * ox + (y - py) * oy + (z - pz) * oz = 0.
Proof.
intros (i & j & k & l & m & n & ((_ & _ & _ & S) & (_ & _ & _ & T) & X & Y & Z) & E1 & E2 & E3). split.
- rewrite E1, E2, E3. assert (i = 1 - j - k) as -> by lra. unfold nx, ny, nz. ring.
- rewrite E1, E2, E3, X, Y, Z. assert (l = 1 - m - n) as -> by lra. unfold ox, oy, oz. ring.
Qed.
Lemma on_line x y z x' y' z' : in_both x y z -> in_both x' y' z' -> ~ (dx = 0 /\ dy = 0 /\ dz = 0) ->
  exists t, x' = x + t * dx /\ y' = y + t * dy /\ z' = z + t * dz.
Proof.
intros P%in_planes Q%in_planes N. destruct P as [P1 P2], Q as [Q1 Q2], across_both as (DX & DY & DZ).
set (u := x' - x). set (v := y' - y). set (w := z' - z).
assert (A : u * nx + v * ny + w * nz = 0) by (unfold u, v, w; lra).
assert (B : u * ox + v * oy + w * oz = 0) by (unfold u, v, w; lra).
assert (C1 : v * dz - w * dy = 0).
{ replace (v * dz - w * dy) with (ox * (u * nx + v * ny + w * nz) - nx * (u * ox + v * oy + w * oz))
    by (rewrite DY, DZ; ring). rewrite A, B. ring. }
assert (C2 : w * dx - u * dz = 0).
{ replace (w * dx - u * dz) with (oy * (u * nx + v * ny + w * nz) - ny * (u * ox + v * oy + w * oz))
    by (rewrite DX, DZ; ring). rewrite A, B. ring. }
assert (C3 : u * dy - v * dx = 0).
{ replace (u * dy - v * dx) with (oz * (u * nx + v * ny + w * nz) - nz * (u * ox + v * oy + w * oz))
    by (rewrite DX, DY; ring). rewrite A, B. ring. }
clear - N C1 C2 C3. set (e := dx) in *. set (f := dy) in *. set (g := dz) in *. clearbody e f g.
assert (E : 0 < e * e + f * f + g * g).
{ pose proof (Rle_0_sqr e). pose proof (Rle_0_sqr f). pose proof (Rle_0_sqr g). unfold Rsqr in *.
  apply Rnot_le_lt. intros L. apply N. repeat split; apply Rsqr_0_uniq; unfold Rsqr; lra. }
exists ((u * e + v * f + w * g) / (e * e + f * f + g * g)).
assert (M : forall a b, a * (e * e + f * f + g * g) = (u * e + v * f + w * g) * b ->
  a = (u * e + v * f + w * g) / (e * e + f * f + g * g) * b).
{ intros a b H. apply Rmult_eq_reg_r with (e * e + f * f + g * g); [|lra]. rewrite H. field. lra. }
assert (K1 : u * (e * e + f * f + g * g) = (u * e + v * f + w * g) * e).
{ replace (u * (e * e + f * f + g * g)) with ((u * e + v * f + w * g) * e + f * (u * f - v * e) - g * (w * e - u * g))
    by ring. rewrite C2, C3. ring. }
assert (K2 : v * (e * e + f * f + g * g) = (u * e + v * f + w * g) * f).
{ replace (v * (e * e + f * f + g * g)) with ((u * e + v * f + w * g) * f - e * (u * f - v * e) + g * (v * g - w * f))
    by ring. rewrite C1, C3. ring. }
assert (K3 : w * (e * e + f * f + g * g) = (u * e + v * f + w * g) * g).
{ replace (w * (e * e + f * f + g * g)) with ((u * e + v * f + w * g) * g + e * (w * e - u * g) - f * (v * g - w * f))
    by ring. rewrite C1, C2. ring. }
apply M in K1, K2, K3. rewrite <- K1, <- K2, <- K3. unfold u, v, w. repeat split; ring.
Qed.
Lemma line_is_there : at_p <> 0 -> ~ (at_a = at_b /\ at_b = at_c) -> ~ (dx = 0 /\ dy = 0 /\ dz = 0).
Proof.
intros P D (X & Y & Z).
assert (A : (at_c - at_a) * at_p = face_exact dx dy dz (cx - ax) (cy - ay) (cz - az) (px - ax) (py - ay) (pz - az)).
{ unfold dx, dy, dz, at_p, volume, rise, face_exact. ring. }
assert (B : (at_a - at_b) * at_p = face_exact (bx - ax) (by_ - ay) (bz - az) dx dy dz (px - ax) (py - ay) (pz - az)).
{ unfold dx, dy, dz, at_p, volume, rise, face_exact. ring. }
rewrite X, Y, Z in A, B. unfold face_exact in A, B.
assert (A0 : (at_c - at_a) * at_p = 0) by lra. assert (B0 : (at_a - at_b) * at_p = 0) by lra.
apply Rmult_integral in A0, B0. apply D. lra.
Qed.

(* All corners of one beyond the other's plane: nothing is common. *)
Lemma heights_cancel i j k l m n : meeting i j k l m n ->
  l * at_p + m * at_q + n * at_r = 0 /\ i * at_a + j * at_b + k * at_c = 0.
Proof.
intros ((_ & _ & _ & S) & (_ & _ & _ & T) & X & Y & Z).
assert (I : i = 1 - j - k) by lra. assert (L : l = 1 - m - n) by lra. split.
- replace (l * at_p + m * at_q + n * at_r) with (rise ax ay az bx by_ bz cx cy cz (l * px + m * qx + n * rx - ax)
    (l * py + m * qy + n * ry - ay) (l * pz + m * qz + n * rz - az))
    by (rewrite L; unfold at_p, at_q, at_r, volume, rise, face_exact; ring).
  rewrite <- X, <- Y, <- Z, I. unfold rise, face_exact. ring.
- replace (i * at_a + j * at_b + k * at_c) with (rise px py pz qx qy qz rx ry rz (i * ax + j * bx + k * cx - px)
    (i * ay + j * by_ + k * cy - py) (i * az + j * bz + k * cz - pz))
    by (rewrite I; unfold at_a, at_b, at_c, volume, rise, face_exact; ring).
  rewrite X, Y, Z, L. unfold rise, face_exact. ring.
Qed.
Lemma no_sum x y z i j k : weights i j k -> (x > 0 /\ y > 0 /\ z > 0) \/ (x < 0 /\ y < 0 /\ z < 0) ->
  i * x + j * y + k * z <> 0.
Proof.
intros (I & J & K & S) [(X & Y & Z)|(X & Y & Z)] E.
- assert (0 <= i * x) by nra. assert (0 <= j * y) by nra. assert (0 <= k * z) by nra.
  destruct (Rmult_integral i x); [lra| |lra]. destruct (Rmult_integral j y); [lra| |lra].
  destruct (Rmult_integral k z); lra.
- assert (i * x <= 0) by nra. assert (j * y <= 0) by nra. assert (k * z <= 0) by nra.
  destruct (Rmult_integral i x); [lra| |lra]. destruct (Rmult_integral j y); [lra| |lra].
  destruct (Rmult_integral k z); lra.
Qed.

(* More than one point, and all on one line. *)
Definition in_a_segment := exists x y z u v w, ~ (u = 0 /\ v = 0 /\ w = 0) /\ in_both x y z /\
  in_both (x + u) (y + v) (z + w) /\
  forall x' y' z', in_both x' y' z' -> exists t, x' = x + t * u /\ y' = y + t * v /\ z' = z + t * w.
Definition slopes (i j k l m n f : R) := [(i, f * (at_b - at_c)); (j, f * (at_c - at_a)); (k, f * (at_a - at_b));
  (l, f * (at_r - at_q)); (m, f * (at_p - at_r)); (n, f * (at_q - at_p))].
Lemma crossing_in_a_segment i j k l m n f : meeting i j k l m n -> f = 1 \/ f = -1 ->
  at_p <> 0 -> ~ (at_a = at_b /\ at_b = at_c) ->
  Forall (fun p => 0 < fst p \/ fst p = 0 /\ 0 <= snd p) (slopes i j k l m n f) -> in_a_segment.
Proof.
intros M O P D F. destruct (small_step _ F) as (s & S & H). clear F.
assert (M' := meeting_moved _ _ _ _ _ _ (s * f) M). unfold slopes in H. repeat apply Forall_cons_iff in H as [? H].
unfold held_up in *. simpl in *.
assert (N := line_is_there P D). assert (W : forall r, s * f * r = s * (f * r)) by (intros; ring).
rewrite !W in M'. specialize (M' ltac:(assumption) ltac:(assumption) ltac:(assumption) ltac:(assumption)
  ltac:(assumption) ltac:(assumption)).
exists (i * ax + j * bx + k * cx), (i * ay + j * by_ + k * cy), (i * az + j * bz + k * cz).
exists (s * f * dx), (s * f * dy), (s * f * dz). assert (SF : s * f <> 0) by (destruct O; subst f; lra).
assert (I : in_both (i * ax + j * bx + k * cx) (i * ay + j * by_ + k * cy) (i * az + j * bz + k * cz))
  by (exists i, j, k, l, m, n; auto).
split; [|split; [exact I|split]].
- intros (X & Y & Z). apply N. apply Rmult_integral in X, Y, Z. intuition.
- do 6 eexists. split; [exact M'|]. unfold dx, dy, dz. repeat split; ring.
- intros x' y' z' Q. destruct (on_line _ _ _ _ _ _ I Q N) as (t & -> & -> & ->). exists (t / (s * f)).
  assert (S0 : s <> 0) by lra. assert (F0 : f <> 0) by (destruct O; lra). repeat split; field; auto.
Qed.
End Pair.
