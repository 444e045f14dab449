(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of bodies are enough, and their specifications leave no choice. *)
Require Import Reals Qreals QArith Lra Lia List.
From Certificates Require Import response language formulas_response.
Import ListNotations.
Open Scope R_scope.

Definition r3 (p : vec3 Q) : vec3 R := let '(a, b, c) := p in (Q2R a, Q2R b, Q2R c).
Definition v3 (p : vec3 (term Q)) : vec3 R := let '(a, b, c) := p in (value Q2R a, value Q2R b, value Q2R c).
Definition r_body (b : Q * vec3 Q) : R * vec3 R := (Q2R (fst b), r3 (snd b)).

Lemma equal3 : forall a b c x y z : R, (a, b, c) = (x, y, z) <-> a = x /\ b = y /\ c = z.
Proof. intros; split; [intro h; injection h; auto | intros (-> & -> & ->); auto]. Qed.
Lemma same3_means : forall p q, means Q2R (same3 p q) <-> v3 p = v3 q.
Proof. intros [[a b] c] [[x y] z]; simpl; rewrite equal3; tauto. Qed.
Lemma nonzero3 : forall a b c : R, (a, b, c) <> (0, 0, 0) -> 0 < a * a + b * b + c * c.
Proof.
  intros a b c h. rewrite equal3 in h. assert (x := Rle_0_sqr a). assert (y := Rle_0_sqr b). assert (z := Rle_0_sqr c).
  unfold Rsqr in *. assert (a * a + b * b + c * c <> 0); [|lra]. intro e. apply h.
  assert (a * a = 0) by lra. assert (b * b = 0) by lra. assert (c * c = 0) by lra.
  repeat split; [destruct (Rmult_integral a a) | destruct (Rmult_integral b b) | destruct (Rmult_integral c c)]; auto.
Qed.

(** What has the cross product 0 with the normal is along it. *)
Lemma along_normal : forall u n : vec3 R, n <> (0, 0, 0) -> cross3 u n = (0, 0, 0) -> exists s, u = times3 s n.
Proof.
  intros [[u1 u2] u3] [[n1 n2] n3] nz hc. apply nonzero3 in nz. simpl in hc. rewrite equal3 in hc.
    destruct hc as (c1 & c2 & c3).
  set (q := n1 * n1 + n2 * n2 + n3 * n3) in *. set (s := (u1 * n1 + u2 * n2 + u3 * n3) / q).
  assert (sq : s * q = u1 * n1 + u2 * n2 + u3 * n3) by (unfold s; field; lra).
  assert (only : forall a b, (a - b) * q = 0 -> a = b).
  { intros a b e. destruct (Rmult_integral _ _ e); lra. }
  assert (e1 : u1 = s * n1).
  { apply only. transitivity (u1 * q - s * q * n1); [ring|]. rewrite sq. unfold q.
    transitivity (n3 * (u1 * n3 - u3 * n1) + n2 * (u1 * n2 - u2 * n1)); [ring|].
    rewrite c3. replace (u1 * n3 - u3 * n1) with 0 by lra. ring. }
  assert (e2 : u2 = s * n2).
  { apply only. transitivity (u2 * q - s * q * n2); [ring|]. rewrite sq. unfold q.
    transitivity (n3 * (u2 * n3 - u3 * n2) - n1 * (u1 * n2 - u2 * n1)); [ring|]. rewrite c3, c1. ring. }
  assert (e3 : u3 = s * n3).
  { apply only. transitivity (u3 * q - s * q * n3); [ring|]. rewrite sq. unfold q.
    transitivity (n1 * (u3 * n1 - u1 * n3) - n2 * (u2 * n3 - u3 * n2)); [ring|]. rewrite c2, c1. ring. }
  exists s. simpl. rewrite equal3. auto.
Qed.

Lemma reflection : forall (v n : vec3 R) (k : R) (after along across : vec3 R), n <> (0, 0, 0) ->
  add3 along across = v -> cross3 along n = (0, 0, 0) -> dot3 across n = 0 -> after = minus3 across (times3 k along) ->
  damped_reflection_spec v n k after.
Proof.
  intros v n k after along across nz <- hc hw ->. split; auto. destruct (along_normal _ _ nz hc) as [s ->].
  exists s, across. repeat split; auto. destruct n as [[n1 n2] n3], across as [[w1 w2] w3].
  unfold minus3; simpl. rewrite equal3. repeat split; ring.
Qed.

Ltac three := repeat match goal with p : vec3 Q |- _ => let q := fresh in destruct p as [[? ?] ?] end.
Ltac numbers h := apply decide_means in h; cbv zeta in h; simpl in h.
Theorem damped_reflection_sound : forall v n k after along across,
  decide (check_damped_reflection v n k after along across) = true ->
  damped_reflection_spec (r3 v) (r3 n) (Q2R k) (r3 after).
Proof.
  intros v n k after along across h. apply (reflection _ _ _ _ (r3 along) (r3 across)); three; numbers h;
    unfold minus3; simpl; rewrite ?equal3; lra || tauto.
Qed.
Theorem reflect_plane_sound : forall v n after along across,
  decide (check_reflect_plane v n after along across) = true -> reflect_plane_spec (r3 v) (r3 n) (r3 after).
Proof.
  intros v n after along across h. apply (reflection _ _ _ _ (r3 along) (r3 across)); three; numbers h;
    unfold minus3; simpl; rewrite ?equal3; lra || tauto.
Qed.
Theorem damped_reflection_unique : forall v n k x y,
  damped_reflection_spec v n k x -> damped_reflection_spec v n k y -> x = y.
Proof.
  intros v [[n1 n2] n3] k x y (nz & s & [[w1 w2] w3] & e & d & ->) (_ & t & [[z1 z2] z3] & f & g & ->).
  apply nonzero3 in nz. rewrite e in f. simpl in *. rewrite equal3 in f. destruct f as (f1 & f2 & f3).
  assert (st : s = t).
  { assert (m : (s - t) * (n1 * n1 + n2 * n2 + n3 * n3) = 0).
    { transitivity ((s * n1 + w1) * n1 + (s * n2 + w2) * n2 + (s * n3 + w3) * n3 - (w1 * n1 + w2 * n2 + w3 * n3)
        - t * (n1 * n1 + n2 * n2 + n3 * n3)); [ring|]. rewrite f1, f2, f3, d.
      transitivity (z1 * n1 + z2 * n2 + z3 * n3); [ring | auto]. }
    destruct (Rmult_integral _ _ m); lra. }
  subst t. unfold minus3; simpl. rewrite equal3. lra.
Qed.
Theorem reflect_plane_unique : forall v n x y, reflect_plane_spec v n x -> reflect_plane_spec v n y -> x = y.
Proof. intros v n x y; apply damped_reflection_unique. Qed.

Lemma masses_mean : forall l, means Q2R (positive_masses l) -> have_mass (map r_body l).
Proof.
  induction l as [|[m v] l IH]; simpl; intros h body i; [tauto|]. destruct h as [hm h].
  destruct i as [<- | i]; [simpl; lra | apply IH; auto].
Qed.
Lemma sum3_means : forall p q, v3 (sum3 p q) = add3 (v3 p) (v3 q).
Proof. intros [[a b] c] [[x y] z]; auto. Qed.
Lemma momenta_mean : forall l, v3 (momenta l) = total_momentum (map r_body l).
Proof.
  induction l as [|[m [[x y] z]] l IH]; [reflexivity|]. change (momenta ((m, (x, y,
    z)) :: l)) with (sum3 (scaled3 (Leaf m) (term3 (x, y, z))) (momenta l)).
  rewrite sum3_means, IH. reflexivity.
Qed.
Lemma energies_mean : forall l, value Q2R (doubled_energies l zero3) = 2 * total_energy (map r_body l).
Proof.
  induction l as [|[m [[x y] z]] l IH]; simpl; [ring|]. rewrite IH. simpl. field.
Qed.
Lemma term3_means : forall p, v3 (term3 p) = r3 p.
Proof. intros [[a b] c]; auto. Qed.
Theorem momentum_sound : forall l p, decide (check_momentum l p) = true -> momentum_spec (map r_body l) (r3 p).
Proof.
  intros l p h. apply decide_means in h. destruct h as [m h]. rewrite same3_means, term3_means, momenta_mean in h.
  split; auto. apply masses_mean; auto.
Qed.
Theorem momentum_unique : forall l p q, momentum_spec l p -> momentum_spec l q -> p = q.
Proof. intros l p q [_ ->] [_ ->]; auto. Qed.
Theorem kinetic_energy_sound : forall l e m c f g, decide (check_kinetic_energy l e m c f g) = true ->
  kinetic_energy_spec (map r_body l) (Q2R e).
Proof.
  intros l e m c f g h. apply decide_means in h. unfold check_kinetic_energy in h. cbv zeta in h.
  destruct h as (hm & _ & _ & _ & _ & _ & h & _). split; [apply masses_mean; auto|].
  assert (k : 2 * Q2R e = value Q2R (doubled_energies l zero3)) by exact h. rewrite energies_mean in k. lra.
Qed.
Theorem kinetic_energy_unique : forall l x y, kinetic_energy_spec l x -> kinetic_energy_spec l y -> x = y.
Proof. intros l x y [_ ->] [_ ->]; auto. Qed.
Theorem inelastic_collision_sound : forall a b v p, decide (check_inelastic_collision a b v p) = true ->
  inelastic_collision_spec (r_body a) (r_body b) (r3 v).
Proof.
  intros a b v p h. apply decide_means in h. destruct h as (m & e & k).
  rewrite same3_means, momenta_mean, term3_means in e. rewrite same3_means, term3_means in k.
  split; [apply (masses_mean [a; b]); auto|]. simpl map in e. rewrite <- e, <- k. destruct v as [[x y] z]; reflexivity.
Qed.
Theorem inelastic_collision_unique : forall a b v w,
  inelastic_collision_spec a b v -> inelastic_collision_spec a b w -> v = w.
Proof.
  intros a b [[x y] z] [[x' y'] z'] [m e] [_ f]. rewrite e in f. simpl in f. rewrite equal3 in *.
    destruct f as (f1 & f2 & f3).
  assert (ha := m a ltac:(simpl; auto)). assert (hb := m b ltac:(simpl; auto)).
  assert (only : forall s t, (fst a + fst b) * s = (fst a + fst b) * t -> s = t).
  { intros s t g. apply (Rmult_eq_reg_l (fst a + fst b)); auto; lra. }
  auto.
Qed.

Definition r_moving (b : vec3 Q * vec3 Q * vec3 Q) : vec3 R * vec3 R * vec3 R := let '(p, v, w) := b in (r3 p, r3 v,
  r3 w).
Lemma velocity_means : forall b p, v3 (velocity_term b p) = velocity_at (r_moving b) (r3 p).
Proof.
  intros [[[[a1 a2] a3] [[b1 b2] b3]] [[c1 c2] c3]] [[x y] z]. unfold velocity_at, minus3;
    simpl. rewrite equal3. repeat split; ring.
Qed.
Theorem contact_state_sound : forall a b p n w of_a of_b, decide (check_contact_state a b p n w of_a of_b) = true ->
  contact_state_spec (r_moving a) (r_moving b) (r3 p) (r3 n) w.
Proof.
  intros a b p n w of_a of_b h. apply decide_means in h. unfold check_contact_state in h. cbv zeta in h.
  destruct h as (nz & ea & eb & h). simpl in nz. rewrite same3_means, term3_means in nz.
  rewrite same3_means, term3_means, velocity_means in ea, eb. split; [auto|]. cbv zeta. rewrite <- ea, <- eb.
  destruct n as [[n1 n2] n3], of_a as [[a1 a2] a3], of_b as [[b1 b2] b3]. unfold minus3; simpl.
  destruct w; simpl in h; lra.
Qed.
Theorem contact_state_unique : forall a b p n v w, contact_state_spec a b p n v -> contact_state_spec a b p n w ->
  v = w.
Proof. intros a b p n v w [_ g] [_ h]. cbv zeta in *. destruct v, w; auto; lra. Qed.
