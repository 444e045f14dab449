(* SPDX-License-Identifier: Apache-2.0 *)
(* Segments and rays with triangles in a lane: what the signs of volumes say. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Filters Require Import model floats lanes lane_faces.
Import ListNotations.
Open Scope R_scope.
#[local] Coercion value : float >-> R.

(* Of d, with the normal of a plane through a, b and c; the volume of four points. *)
Definition rise ax ay az bx by_ bz cx cy cz dx dy dz :=
  face_exact (bx - ax) (by_ - ay) (bz - az) (cx - ax) (cy - ay) (cz - az) dx dy dz.
Definition volume ax ay az bx by_ bz cx cy cz px py pz :=
  rise ax ay az bx by_ bz cx cy cz (px - ax) (py - ay) (pz - az).

(* The point at t of the line from p along w, with weights of the corners. *)
Definition common (low : R -> Prop) px py pz wx wy wz ax ay az bx by_ bz cx cy cz t i j k :=
  low t /\ 0 <= i /\ 0 <= j /\ 0 <= k /\ i + j + k = 1 /\ px + t * wx = i * ax + j * bx + k * cx /\
  py + t * wy = i * ay + j * by_ + k * cy /\ pz + t * wz = i * az + j * bz + k * cz.

Section Line.
Variables px py pz wx wy wz ax ay az bx by_ bz cx cy cz : R.
Let at_p := volume ax ay az bx by_ bz cx cy cz px py pz.
Let along := rise ax ay az bx by_ bz cx cy cz wx wy wz.
(* Of the line with each edge. *)
Let ab := rise px py pz ax ay az bx by_ bz wx wy wz.
Let bc := rise px py pz bx by_ bz cx cy cz wx wy wz.
Let ca := rise px py pz cx cy cz ax ay az wx wy wz.

Lemma edges_sum : ab + bc + ca = along.
Proof. unfold ab, bc, ca, along, rise, face_exact. ring. Qed.
Lemma crossing_x : along * px - at_p * wx = bc * ax + ca * bx + ab * cx.
Proof. unfold ab, bc, ca, along, at_p, volume, rise, face_exact. ring. Qed.
Lemma crossing_y : along * py - at_p * wy = bc * ay + ca * by_ + ab * cy.
Proof. unfold ab, bc, ca, along, at_p, volume, rise, face_exact. ring. Qed.
Lemma crossing_z : along * pz - at_p * wz = bc * az + ca * bz + ab * cz.
Proof. unfold ab, bc, ca, along, at_p, volume, rise, face_exact. ring. Qed.

Variable low : R -> Prop.
Notation is_common := (common low px py pz wx wy wz ax ay az bx by_ bz cx cy cz).

(* In the plane, and of the weights two products for each corner. *)
Lemma common_in_plane t i j k : is_common t i j k -> at_p + t * along = 0.
Proof.
intros (_ & _ & _ & _ & S & X & Y & Z). assert (K : k = 1 - i - j) by lra. subst k.
replace (at_p + t * along) with (rise ax ay az bx by_ bz cx cy cz (px + t * wx - ax) (py + t * wy - ay)
    (pz + t * wz - az))
  by (unfold at_p, along, volume, rise, face_exact; ring).
rewrite X, Y, Z. unfold rise, face_exact. ring.
Qed.
Lemma common_weights t i j k : is_common t i j k -> i * ab = k * bc /\ j * bc = i * ca /\ k * ca = j * ab.
Proof.
intros (_ & _ & _ & _ & S & X & Y & Z).
assert (UX : i * (ax - px) + j * (bx - px) + k * (cx - px) = t * wx).
{ replace (t * wx) with (i * ax + j * bx + k * cx - (i + j + k) * px) by (rewrite S; lra). ring. }
assert (UY : i * (ay - py) + j * (by_ - py) + k * (cy - py) = t * wy).
{ replace (t * wy) with (i * ay + j * by_ + k * cy - (i + j + k) * py) by (rewrite S; lra). ring. }
assert (UZ : i * (az - pz) + j * (bz - pz) + k * (cz - pz) = t * wz).
{ replace (t * wz) with (i * az + j * bz + k * cz - (i + j + k) * pz) by (rewrite S; lra). ring. }
assert (V : forall x y z, face_exact (i * (ax - px) + j * (bx - px) + k * (cx - px))
  (i * (ay - py) + j * (by_ - py) + k * (cy - py)) (i * (az - pz) + j * (bz - pz) + k * (cz - pz)) x y z wx wy wz = 0).
{ intros. rewrite UX, UY, UZ. unfold face_exact. ring. }
repeat split; apply Rminus_diag_uniq.
- rewrite <- (V (bx - px) (by_ - py) (bz - pz)). unfold ab, bc, rise, face_exact. ring.
- rewrite <- (V (cx - px) (cy - py) (cz - pz)). unfold bc, ca, rise, face_exact. ring.
- rewrite <- (V (ax - px) (ay - py) (az - pz)). unfold ca, ab, rise, face_exact. ring.
Qed.

(* Two edges on different sides of the line: nothing is common. *)
Lemma outside_says t i j k : (ab > 0 \/ bc > 0 \/ ca > 0) -> (ab < 0 \/ bc < 0 \/ ca < 0) -> ~ is_common t i j k.
Proof.
intros P N C. destruct (common_weights t i j k C) as (A & B & D). destruct C as (_ & I & J & K & S & _).
assert (Q : forall x y s r, 0 <= x -> 0 <= y -> x * s = y * r -> s > 0 -> r < 0 -> x = 0 /\ y = 0).
{ intros x y s r X Y E G L. assert (0 <= x * s) by nra. assert (y * r <= 0) by nra.
  split; [destruct (Rmult_integral x s); lra|destruct (Rmult_integral y r); lra]. }
destruct P as [P|[P|P]], N as [N|[N|N]]; try lra.
- destruct (Q i k ab bc I K A P N) as [-> ->]. assert (j = 1) as -> by lra. lra.
- destruct (Q j k ab ca J K) as [-> ->]; try lra. assert (i = 1) as -> by lra. lra.
- destruct (Q k i bc ab K I) as [-> ->]; try lra. assert (j = 1) as -> by lra. lra.
- destruct (Q j i bc ca J I) as [-> ->]; try lra. assert (k = 1) as -> by lra. lra.
- destruct (Q k j ca ab K J) as [-> ->]; try lra. assert (i = 1) as -> by lra. lra.
- destruct (Q i j ca bc I J) as [-> ->]; try lra. assert (k = 1) as -> by lra. lra.
Qed.

(* All three on one side, and the line crosses the plane at t: that point is common, and no other. *)
Lemma inside_says t : (ab > 0 /\ bc > 0 /\ ca > 0) \/ (ab < 0 /\ bc < 0 /\ ca < 0) -> at_p + t * along = 0 -> low t ->
  (exists i j k, 0 < i /\ 0 < j /\ 0 < k /\ is_common t i j k) /\ forall t' i j k, is_common t' i j k -> t' = t.
Proof.
intros E T L. pose proof edges_sum as S. assert (N : along <> 0) by lra. split.
- assert (H : at_p = - t * along) by lra.
  assert (W : forall x, (0 < along -> 0 < x) -> (along < 0 -> x < 0) -> 0 < x / along).
  { intros x P M. unfold Rdiv. destruct (Rtotal_order along 0) as [Q|[Q|Q]]; [|lra|].
    - rewrite <- (Rmult_opp_opp x). apply Rmult_lt_0_compat; [specialize (M Q); lra|].
      pose proof (Rinv_lt_0_compat _ Q). lra.
    - apply Rmult_lt_0_compat; [exact (P Q)|now apply Rinv_0_lt_compat]. }
  exists (bc / along), (ca / along), (ab / along).
  assert (I : 0 < bc / along) by (apply W; lra). assert (J : 0 < ca / along) by (apply W; lra).
  assert (K : 0 < ab / along) by (apply W; lra). split; [exact I|]. split; [exact J|]. split; [exact K|].
  split; [exact L|]. split; [lra|]. split; [lra|]. split; [lra|].
  assert (M : forall x w a b c, along * x - at_p * w = bc * a + ca * b + ab * c ->
    x + t * w = bc / along * a + ca / along * b + ab / along * c).
  { intros x w a b c Q. rewrite H in Q. replace (bc / along * a + ca / along * b + ab / along * c) with
      ((bc * a + ca * b + ab * c) / along) by (field; exact N). rewrite <- Q. field. exact N. }
  split; [rewrite <- S; field; lra|]. auto using crossing_x, crossing_y, crossing_z.
- intros t' i j k C. apply common_in_plane in C. apply Rmult_eq_reg_r with along; [lra|exact N].
Qed.
End Line.

Definition sign_at s (b c : bool) := (b = true -> s > 0) /\ (c = true -> s < 0).
Ltac bools := repeat match goal with
  | H : _ && _ = true |- _ => apply andb_prop in H as [? ?]
  | H : _ || _ = true |- _ => apply orb_prop in H as [?|?]
  | H : negb _ = true |- _ => apply negb_true_iff in H end.
Ltac signs_of := repeat match goal with S : sign_at _ ?b ?c, H : ?b = true |- _ => apply (proj1 S) in H
  | S : sign_at _ ?b ?c, H : ?c = true |- _ => apply (proj2 S) in H end.
Lemma sign_opposite s p : sign_at (- s) (fst p) (snd p) -> sign_at s (snd p) (fst p).
Proof. intros [A B]. split; intros K; [specialize (B K)|specialize (A K)]; lra. Qed.

(* A segment or a ray and a triangle, by five signs: of its line and the edges, and of its ends. *)
Definition on_both_sides (e f g : bool * bool) := (fst e || fst f || fst g) && (snd e || snd f || snd g).
Definition on_one_side (e f g : bool * bool) := fst e && fst f && fst g || snd e && snd f && snd g.
Definition beside (e f : bool * bool) := fst e && fst f || snd e && snd f.
Definition known_side (s : bool * bool) := fst s || snd s.
Section Signs.
Variables px py pz wx wy wz ax ay az bx by_ bz cx cy cz : R.
Variables ab bc ca start stop : bool * bool.
Let at_p := volume ax ay az bx by_ bz cx cy cz px py pz.
Let along := rise ax ay az bx by_ bz cx cy cz wx wy wz.
Definition signs_of_line := sign_at (rise px py pz ax ay az bx by_ bz wx wy wz) (fst ab) (snd ab) /\
  sign_at (rise px py pz bx by_ bz cx cy cz wx wy wz) (fst bc) (snd bc) /\
  sign_at (rise px py pz cx cy cz ax ay az wx wy wz) (fst ca) (snd ca) /\ sign_at at_p (fst start) (snd start).
(* At the other end, or of the direction. *)
Definition signs_of_segment := signs_of_line /\ sign_at (at_p + along) (fst stop) (snd stop).
Definition signs_of_ray := signs_of_line /\ sign_at along (fst stop) (snd stop).
Notation is_common low := (common low px py pz wx wy wz ax ay az bx by_ bz cx cy cz).
Notation unit := (fun t => 0 <= t <= 1).
Notation ahead := (fun t => 0 <= t).

Lemma line_passes (low : R -> Prop) t i j k : signs_of_line -> on_both_sides ab bc ca = true -> ~ is_common low t i j k.
Proof.
intros (AB & BC & CA & _) [K1 K2]%andb_prop C. apply (outside_says _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ t i j k) in C;
  [exact C| |]; [clear K2|clear K1]; bools; signs_of; auto.
Qed.
Lemma segment_passes t i j k : signs_of_segment -> on_both_sides ab bc ca || beside start stop = true ->
  ~ is_common unit t i j k.
Proof.
intros [L Q] [K|K]%orb_prop C; [exact (line_passes _ _ _ _ _ L K C)|]. destruct L as (_ & _ & _ & P).
pose proof (common_in_plane _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ C) as Z. fold at_p along in Z.
assert (T : 0 <= t <= 1) by apply C. unfold beside in K. destruct (Rle_or_lt 0 along) as [M|M]; bools; signs_of; nra.
Qed.
Lemma ray_passes t i j k : signs_of_ray -> on_both_sides ab bc ca || beside start stop = true ->
  ~ is_common ahead t i j k.
Proof.
intros [L Q] [K|K]%orb_prop C; [exact (line_passes _ _ _ _ _ L K C)|]. destruct L as (_ & _ & _ & P).
pose proof (common_in_plane _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ C) as Z. fold at_p along in Z.
assert (T : 0 <= t) by apply C. unfold beside in K. bools; signs_of; nra.
Qed.
Lemma line_crosses (low : R -> Prop) t : signs_of_line -> on_one_side ab bc ca = true -> at_p + t * along = 0 ->
  low t ->
  (exists i j k, 0 < i /\ 0 < j /\ 0 < k /\ is_common low t i j k) /\
  forall t' i j k, is_common low t' i j k -> t' = t.
Proof.
intros (AB & BC & CA & _) I Z L. apply inside_says; [|exact Z|exact L]. unfold on_one_side in I. bools; signs_of; auto.
Qed.
Lemma segment_crosses : signs_of_segment -> known_side start = true -> known_side stop = true ->
  on_one_side ab bc ca = true -> beside start stop = false ->
  exists t, 0 < t < 1 /\ (exists i j k, 0 < i /\ 0 < j /\ 0 < k /\ is_common unit t i j k) /\
  forall t' i j k, is_common unit t' i j k -> t' = t.
Proof.
intros [L Q] KP KQ I B. assert (T : exists t, 0 < t < 1 /\ at_p + t * along = 0).
{ assert (O : (at_p > 0 /\ at_p + along < 0) \/ (at_p < 0 /\ at_p + along > 0)).
  { destruct L as (_ & _ & _ & P). unfold beside, known_side in *.
    destruct (fst start), (snd start), (fst stop), (snd stop); try discriminate; destruct P, Q; intuition lra. }
  exists (at_p / - along). assert (along <> 0) by lra. split; [|field; assumption]. destruct O as [[O1 O2]|[O1 O2]].
  - split; [apply Rdiv_lt_0_compat; lra|]. apply Rmult_lt_reg_r with (- along); [lra|]. field_simplify; lra.
  - replace (at_p / - along) with (- at_p / along) by (field; assumption).
    split; [apply Rdiv_lt_0_compat; lra|]. apply Rmult_lt_reg_r with along; [lra|]. field_simplify; lra. }
destruct T as (t & T & Z). exists t. split; [exact T|]. apply line_crosses; auto. lra.
Qed.
Lemma ray_crosses : signs_of_ray -> known_side start = true -> known_side stop = true ->
  on_one_side ab bc ca = true -> beside start stop = false ->
  exists t, 0 < t /\ (exists i j k, 0 < i /\ 0 < j /\ 0 < k /\ is_common ahead t i j k) /\
  forall t' i j k, is_common ahead t' i j k -> t' = t.
Proof.
intros [L Q] KP KW I B. assert (T : exists t, 0 < t /\ at_p + t * along = 0).
{ assert (O : (at_p > 0 /\ along < 0) \/ (at_p < 0 /\ along > 0)).
  { destruct L as (_ & _ & _ & P). unfold beside, known_side in *.
    destruct (fst start), (snd start), (fst stop), (snd stop); try discriminate; destruct P, Q; intuition lra. }
  exists (at_p / - along). assert (along <> 0) by lra. split; [|field; assumption].
  destruct O as [[O1 O2]|[O1 O2]]; [apply Rdiv_lt_0_compat; lra|].
  replace (at_p / - along) with (- at_p / along) by (field; assumption). apply Rdiv_lt_0_compat; lra. }
destruct T as (t & T & Z). exists t. split; [exact T|]. apply line_crosses; auto. lra.
Qed.
End Signs.
