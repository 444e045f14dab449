(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of numbers that are rounded are enough, and their specifications leave no choice. *)
Require Import Reals Qreals QArith ZArith Lra Lia Bool.
From Certificates Require Import numbers motion language formulas_motion formulas_rounding sound_motion.
Open Scope R_scope.

(** ** Powers of two *)
Definition two (e : Z) : R := powerRZ 2 e.
Lemma two_pos : forall e, 0 < two e.
Proof. intro e. apply powerRZ_lt. lra. Qed.
Lemma two_plus : forall e f, two (e + f) = two e * two f.
Proof. intros. apply powerRZ_add. lra. Qed.
Lemma two_next : forall e, two (e + 1) = 2 * two e.
Proof. intro e. rewrite two_plus. replace (two 1) with 2 by (unfold two; simpl; ring). ring. Qed.
Lemma two_whole : forall e, (0 <= e)%Z -> two e = IZR (2 ^ e).
Proof.
  intros [|p|p] h; [reflexivity | | lia]. unfold two. symmetry. apply (Zpower_pos_powerRZ 2).
Qed.
Lemma grow : forall e a b, (a <= b)%Z -> IZR a * two e <= IZR b * two e.
Proof. intros e a b h. apply Rmult_le_compat_r; [left; apply two_pos | apply IZR_le, h]. Qed.
Lemma grows : forall e a b, IZR a * two e < IZR b * two e -> (a < b)%Z.
Proof. intros e a b h. apply lt_IZR, (Rmult_lt_reg_r (two e)); auto. apply two_pos. Qed.
Lemma two_le : forall e f, (e <= f)%Z -> two e <= two f.
Proof.
  intros e f h. replace f with (f - e + e)%Z by lia. rewrite two_plus, (two_whole (f - e)) by lia.
  assert (1 <= 2 ^ (f - e))%Z by (assert (0 < 2 ^ (f - e))%Z by (apply Z.pow_pos_nonneg; lia); lia).
  assert (g := grow e _ _ H). lra.
Qed.
Lemma shift : forall n e f, (e <= f)%Z -> IZR n * two f = IZR (n * 2 ^ (f - e)) * two e.
Proof.
  intros n e f h. replace (two f) with (two (f - e + e)) by (f_equal; lia).
  rewrite two_plus, two_whole, mult_IZR by lia. ring.
Qed.
Lemma power_is : forall p, power_of_two p = (2 ^ Zpos p)%Z.
Proof.
  induction p as [p IH | p IH |]; [| | reflexivity]; cbn [power_of_two]; rewrite IH.
  - rewrite (Pos2Z.inj_xI p), Z.pow_add_r, Z.pow_twice_r by lia. change (2 ^ 1)%Z with 2%Z. ring.
  - rewrite (Pos2Z.inj_xO p), Z.pow_twice_r. reflexivity.
Qed.
Lemma scale_pos : forall e, (0 < scale e)%Z.
Proof. intros [|p|p]; simpl scale; try rewrite power_is; try apply Z.pow_pos_nonneg; lia. Qed.
Lemma scales : forall e, IZR (scale e) = IZR (scale (- e)) * two e.
Proof.
  intros [|p|p]; simpl Z.opp; unfold scale; rewrite ?power_is.
  - unfold two. simpl. ring.
  - rewrite two_whole by lia. ring.
  - rewrite <- two_whole, <- two_plus by lia. replace (Zpos p + Zneg p)%Z with 0%Z by lia. reflexivity.
Qed.
Lemma units_le : forall e q n t,
  IZR (q * scale (- e)) * t <= IZR (n * scale e) <-> IZR q * t <= IZR n * two e.
Proof.
  intros e q n t. rewrite !mult_IZR, (scales e). assert (s : 0 < IZR (scale (- e))) by (apply (IZR_lt 0), scale_pos).
  set (u := IZR (scale (- e))) in *. split; intro h.
  - apply (Rmult_le_reg_l u); auto. lra.
  - apply (Rmult_le_compat_l u) in h; lra.
Qed.
Lemma units_ge : forall e q n t,
  IZR (n * scale e) <= IZR (q * scale (- e)) * t <-> IZR n * two e <= IZR q * t.
Proof.
  intros e q n t. rewrite !mult_IZR, (scales e). assert (s : 0 < IZR (scale (- e))) by (apply (IZR_lt 0), scale_pos).
  set (u := IZR (scale (- e))) in *. split; intro h.
  - apply (Rmult_le_reg_l u); auto. lra.
  - apply (Rmult_le_compat_l u) in h; lra.
Qed.

(** ** Doubles, and what is next to one *)
Definition mantissa (m e : Z) : Prop := (Z.abs m <= most_digits /\ -1074 <= e <= 971)%Z.
Definition full (m e : Z) : Prop := mantissa m e /\ (e <= -1074 \/ least_normal <= Z.abs m)%Z.
Ltac constants := unfold full, mantissa, least_normal, most_digits in *;
  change (2 ^ 53)%Z with 9007199254740992%Z in *; change (2 ^ 52)%Z with 4503599627370496%Z in *.

Ltac gaps := unfold gap in *;
  match goal with
  | |- context [Zeq_bool ?m least_normal] =>
      let h := fresh in destruct (Zeq_bool m least_normal) eqn:h; [apply Zeq_bool_eq in h | apply Zeq_bool_neq in h]
  end; repeat match goal with |- context [Z.leb ?a ?b] => destruct (Z.leb_spec a b) end; constants; lia.

Lemma is_binary : forall m e, mantissa m e -> binary 53 (IZR m * two e).
Proof. intros m e h. exists m, e. split; [reflexivity|]. constants. lia. Qed.
Lemma even_is_binary : forall m e, mantissa m e -> Z.even m = true -> binary 52 (IZR m * two e).
Proof.
  intros m e h g. apply Z.even_spec in g. destruct g as [n ->]. exists n, (e + 1)%Z. split.
  - change (powerRZ 2 (e + 1)) with (two (e + 1)). rewrite two_next, mult_IZR. ring.
  - constants. lia.
Qed.
Lemma binary_opp : forall k d, binary k d -> binary k (- d).
Proof.
  intros k d [m [e [-> h]]]. exists (- m)%Z, e. rewrite opp_IZR, Z.abs_opp. split; [ring | auto].
Qed.
Lemma full_opp : forall m e, full m e -> full (- m) e.
Proof. unfold full, mantissa. intros m e. rewrite Z.abs_opp. auto. Qed.

Lemma beyond : forall m e y, (0 <= m)%Z -> full m e -> binary 53 y -> IZR m * two e < y ->
  IZR (m + 1) * two e <= y.
Proof.
  intros m e y hm hf [n [f [-> hn]]] lt. change (powerRZ 2 f) with (two f) in *.
  destruct (Z_le_gt_dec e f) as [le | gt].
  - rewrite (shift n e f le) in *. apply grow. apply grows in lt. lia.
  - exfalso. assert (a := two_le f (e - 1) ltac:(lia)). assert (b := two_next (e - 1)).
    replace (e - 1 + 1)%Z with e in b by lia. assert (p := two_pos f).
    assert (c : IZR n * two f <= IZR 9007199254740991 * two f) by (apply grow; constants; lia).
    assert (d : IZR 4503599627370496 * two e <= IZR m * two e) by (apply grow; constants; lia). lra.
Qed.
Lemma short : forall m e y, (0 <= m)%Z -> full m e -> binary 53 y -> y < IZR m * two e ->
  2 * y <= IZR (2 * m - gap m e) * two e.
Proof.
  intros m e y hm hf [n [f [-> hn]]] lt. change (powerRZ 2 f) with (two f) in *.
  destruct (Z_le_gt_dec e f) as [le | gt].
  - rewrite (shift n e f le) in *. apply grows in lt. rewrite <- Rmult_assoc, <- mult_IZR. apply grow. gaps.
  - assert (a := two_le f (e - 1) ltac:(lia)). assert (b := two_next (e - 1)).
    replace (e - 1 + 1)%Z with e in b by lia. assert (p := two_pos f).
    assert (c : IZR n * two f <= IZR 9007199254740991 * two f) by (apply grow; constants; lia).
    assert (d : IZR 9007199254740991 * two e <= IZR (2 * m - gap m e) * two e) by (apply grow; constants; gaps).
    lra.
Qed.
Lemma greatest_is : IZR greatest = 9007199254740991 * two 971.
Proof. unfold greatest. rewrite power_is, mult_IZR, <- two_whole by lia. reflexivity. Qed.
Lemma within_range : forall y, binary 53 y -> - IZR greatest <= y <= IZR greatest.
Proof.
  intros y [n [f [-> hn]]]. change (powerRZ 2 f) with (two f). rewrite greatest_is.
  assert (a := two_le f 971 ltac:(lia)). assert (p := two_pos f).
  assert (c : IZR n * two f <= IZR 9007199254740991 * two f) by (apply grow; constants; lia).
  assert (d : IZR (-9007199254740991) * two f <= IZR n * two f) by (apply grow; constants; lia). lra.
Qed.

(** ** The nearest double *)
Definition nearest (x d : R) : Prop := binary 53 d /\ forall y, binary 53 y ->
  Rabs (x - d) <= Rabs (x - y) /\ (Rabs (x - d) = Rabs (x - y) -> y = d \/ binary 52 d).
Ltac magnitudes := unfold Rabs in *; repeat destruct (Rcase_abs _); lra.

Lemma near_is_nearest : forall m e t, (0 <= m)%Z -> full m e ->
  IZR (4 * m - gap m e) * two e <= 4 * t <= IZR (4 * m + 2) * two e ->
  Z.even m = true \/ IZR (4 * m - gap m e) * two e < 4 * t < IZR (4 * m + 2) * two e ->
  nearest t (IZR m * two e).
Proof.
  intros m e t hm hf [lo hi] even. split; [apply is_binary, hf |]. intros y hy.
  assert (tie : IZR (4 * m - gap m e) * two e = 4 * t \/ 4 * t = IZR (4 * m + 2) * two e ->
                binary 52 (IZR m * two e)).
  { intro h. destruct even as [ev | st]; [apply even_is_binary; [apply hf | auto] |]. destruct h; lra. }
  assert (below := short m e y hm hf hy). assert (above := beyond m e y hm hf hy).
  rewrite ?minus_IZR, ?plus_IZR, ?mult_IZR in *.
  destruct (Rtotal_order y (IZR m * two e)) as [lt | [-> | gt]].
  - apply below in lt as far. split; [magnitudes |]. intro q. right. apply tie. left. magnitudes.
  - split; [lra | auto].
  - apply above in gt as far. split; [magnitudes |]. intro q. right. apply tie. right. magnitudes.
Qed.
Lemma nearest_itself : forall m e, mantissa m e -> nearest (IZR m * two e) (IZR m * two e).
Proof. intros m e h. split; [apply is_binary, h |]. intros y hy. split; [| intro; left]; magnitudes. Qed.
Lemma nearest_opp : forall x d, nearest (- x) (- d) -> nearest x d.
Proof.
  intros x d [b h]. split; [rewrite <- (Ropp_involutive d); apply binary_opp, b |]. intros y hy.
  destruct (h (- y) (binary_opp _ _ hy)) as [less tie].
  replace (- x - - d) with (- (x - d)) in * by ring. replace (- x - - y) with (- (x - y)) in * by ring.
  rewrite !Rabs_Ropp in *. split; auto. intro q. destruct (tie q) as [i | i].
  - left. lra.
  - right. rewrite <- (Ropp_involutive d). apply binary_opp, i.
Qed.

Lemma two_971 : two 971 = 2 * two 970.
Proof. apply (two_next 970). Qed.
Lemma limit_two : IZR limit = 18014398509481983 * two 970.
Proof. unfold limit. rewrite power_is, mult_IZR, <- two_whole by lia. reflexivity. Qed.
Lemma limit_is : powerRZ 2 1024 - powerRZ 2 970 = IZR limit.
Proof.
  rewrite limit_two. change (powerRZ 2 1024) with (two (54 + 970)). change (powerRZ 2 970) with (two 970).
  rewrite two_plus, (two_whole 54) by lia. change (2 ^ 54)%Z with 18014398509481984%Z. ring.
Qed.
Lemma limit_pos : 0 < IZR limit.
Proof. rewrite limit_two. assert (h := two_pos 970). lra. Qed.
Lemma near_in_limit : forall m e t, (0 <= m)%Z -> mantissa m e ->
  IZR (4 * m - gap m e) * two e <= 4 * t <= IZR (4 * m + 2) * two e ->
  Z.even m = true \/ IZR (4 * m - gap m e) * two e < 4 * t < IZR (4 * m + 2) * two e -> Rabs t < IZR limit.
Proof.
  intros m e t hm hf [lo hi] even. rewrite limit_two. assert (p := two_pos e).
  assert (a := two_le e 971 ltac:(constants; lia)). rewrite two_971 in a.
  assert (low : IZR (-2) * two e <= IZR (4 * m - gap m e) * two e) by (apply grow; gaps).
  apply Rabs_def1; [| lra]. destruct even as [ev | st].
  - apply Z.even_spec in ev. destruct ev as [n en].
    assert (IZR (4 * m + 2) * two e <= IZR 36028797018963962 * two e) by (apply grow; constants; lia). lra.
  - assert (IZR (4 * m + 2) * two e <= IZR 36028797018963966 * two e) by (apply grow; constants; lia). lra.
Qed.
Lemma double_in_limit : forall m e, mantissa m e -> Rabs (IZR m * two e) < IZR limit.
Proof.
  intros m e h. assert (g := within_range _ (is_binary m e h)). rewrite greatest_is in g. rewrite limit_two.
  rewrite two_971 in g. assert (p := two_pos 970). apply Rabs_def1; lra.
Qed.

(** ** What the formulas mean *)
Definition in_reals (w : double (Z * Z)) : double R :=
  match w with finite (m, e) => finite (IZR m * two e) | infinity => infinity | minus_infinity => minus_infinity end.
Definition at_terms (x y k : term Q) : R := value Q2R x + value Q2R y * sqrt (value Q2R k).
Section of_terms.
Variables (x y k : term Q).
Hypothesis hk : 0 <= value Q2R k.
Lemma at_most_means : forall b, means Q2R (at_most x y k b) <-> at_terms x y k <= value Q2R b.
Proof.
  intro b. unfold at_most, at_terms. rewrite not_positive_means by exact hk. cbn [value]. lra.
Qed.
Lemma at_least_means : forall b, means Q2R (at_least x y k b) <-> value Q2R b <= at_terms x y k.
Proof.
  intro b. unfold at_least, at_terms. rewrite not_positive_means by exact hk. cbn [value]. lra.
Qed.
Lemma at_scaled : forall c, at_terms (Mul (Num c) x) (Mul (Num c) y) k = IZR c * at_terms x y k.
Proof. intro c. unfold at_terms. cbn [value]. ring. Qed.
Lemma at_opposite : at_terms (Sub zero x) (Sub zero y) k = - at_terms x y k.
Proof. unfold at_terms. cbn [value]. ring. Qed.
Lemma equals_means : forall m e, means Q2R (equals x y m e) -> at_terms x y k = IZR m * two e.
Proof.
  intros m e [a b]. cbn [means value] in a, b. unfold at_terms. rewrite a, Rmult_0_l, Rplus_0_r.
  rewrite mult_IZR, (scales e) in b. apply (Rmult_eq_reg_l (IZR (scale (- e)))); [lra |].
  apply Rgt_not_eq, (IZR_lt 0), scale_pos.
Qed.
End of_terms.

Lemma near_means : forall x y k m e, 0 <= value Q2R k -> means Q2R (near x y k m e) ->
  let t := at_terms x y k in
  IZR (4 * m - gap m e) * two e <= 4 * t <= IZR (4 * m + 2) * two e /\
  (Z.even m = true \/ IZR (4 * m - gap m e) * two e < 4 * t < IZR (4 * m + 2) * two e).
Proof.
  intros x y k m e hk h t. unfold near in h. destruct (Z.even m); cbn [means] in h;
    rewrite at_least_means, at_most_means, at_scaled in h by exact hk; cbn [value] in h;
    rewrite units_ge, units_le in h; fold t in h; [auto |].
  destruct h as [a b]. apply Rnot_le_lt in a, b. lra.
Qed.
Lemma is_double_means : forall m e, means Q2R (if_so (is_double m e)) -> mantissa m e.
Proof.
  intros m e h. apply if_so_means in h. unfold is_double in h. rewrite !andb_true_iff, !Z.leb_le in h.
  unfold mantissa. tauto.
Qed.
Lemma has_all_digits_means : forall m e, mantissa m e -> means Q2R (if_so (has_all_digits m e)) -> full m e.
Proof.
  intros m e g h. apply if_so_means in h. unfold has_all_digits in h. rewrite orb_true_iff, !Z.leb_le in h.
  split; auto.
Qed.

Lemma finite_nearest : forall x d, Rabs x < IZR limit -> nearest x d -> rounded_spec x (finite d).
Proof. intros x d h g. unfold rounded_spec. cbv zeta. rewrite limit_is. split; auto. Qed.

Theorem rounds_to_nearest_sound : forall t w, decide (rounds_to_nearest t w) = true ->
  rounded_spec (r_surd t) (in_reals w).
Proof.
  intros [x y k] w h. apply decide_means in h. unfold rounds_to_nearest in h. cbn [means] in h. destruct h as [hk h].
  change (r_surd (Surd x y k)) with (at_terms (Leaf x) (Leaf y) (Leaf k)). change (0 <= value Q2R (Leaf k)) in hk.
  destruct w as [[m e] | |].
  - cbn [means] in h. destruct h as [d h]. apply is_double_means in d. unfold in_reals.
    destruct h as [h | [f h]].
    + apply (equals_means (Leaf x) (Leaf y) (Leaf k)) in h. rewrite h.
      apply finite_nearest; [apply double_in_limit, d | apply nearest_itself, d].
    + apply has_all_digits_means in f; auto. destruct (Z.leb_spec 0 m) as [s | s].
      * apply near_means in h; auto. destruct h as [h g].
        apply finite_nearest; [apply (near_in_limit m e) | apply near_is_nearest]; auto.
      * apply near_means in h; auto. rewrite at_opposite in h. destruct h as [h g]. apply full_opp in f as f'.
        apply finite_nearest.
        -- rewrite <- Rabs_Ropp. apply (near_in_limit (- m) e); auto; [lia | apply f'].
        -- apply nearest_opp. rewrite Ropp_mult_distr_l, <- opp_IZR. apply near_is_nearest; auto. lia.
  - apply at_least_means in h; auto. unfold rounded_spec, in_reals. cbv zeta. rewrite limit_is. exact h.
  - apply at_least_means in h; auto. rewrite at_opposite in h. unfold rounded_spec, in_reals. cbv zeta.
    rewrite limit_is. cbn [value] in h. lra.
Qed.

(** ** No number has two nearest doubles: between two that both end with 0 there is another one. *)
Lemma between_on : forall n f p g, (Z.abs n < 2 ^ 52 /\ -1073 <= f <= 972)%Z -> (f <= g)%Z ->
  IZR n * two f <> IZR p * two g -> exists y, binary 53 y /\
  (IZR n * two f < y < IZR p * two g \/ IZR p * two g < y < IZR n * two f).
Proof.
  intros n f p g hn le ne. rewrite (shift p f g le) in *. set (q := (p * 2 ^ (g - f))%Z) in *.
  assert (b := two_next (f - 1)). replace (f - 1 + 1)%Z with f in b by lia. assert (u := two_pos (f - 1)).
  destruct (Rdichotomy _ _ ne) as [lt | gt].
  - exists (IZR (2 * n + 1) * two (f - 1)). split; [apply is_binary; constants; lia |]. left.
    apply grows in lt. assert (c := grow f (n + 1) q ltac:(lia)).
    rewrite !plus_IZR, ?mult_IZR in *. rewrite b in *. lra.
  - exists (IZR (2 * n - 1) * two (f - 1)). split; [apply is_binary; constants; lia |]. right.
    apply Rgt_lt, grows in gt. assert (c := grow f q (n - 1) ltac:(lia)).
    rewrite !minus_IZR, ?mult_IZR in *. rewrite b in *. lra.
Qed.
Lemma between : forall c d, binary 52 c -> binary 52 d -> c <> d ->
  exists y, binary 53 y /\ (c < y < d \/ d < y < c).
Proof.
  intros c d [n [f [-> hn]]] [p [g [-> hp]]] ne. destruct (Z_le_gt_dec f g) as [le | gt].
  - apply (between_on n f p g); auto.
  - destruct (between_on p g n f) as [y [b o]]; auto; [lia |]. exists y. split; auto. tauto.
Qed.
Lemma nearest_unique : forall x c d, nearest x c -> nearest x d -> c = d.
Proof.
  intros x c d [bc hc] [bd hd]. destruct (Req_dec c d) as [| ne]; auto. exfalso.
  destruct (hc d bd) as [c1 c2], (hd c bc) as [d1 d2].
  assert (same : Rabs (x - c) = Rabs (x - d)) by lra.
  destruct (c2 same) as [| ec]; [congruence |]. destruct (d2 (eq_sym same)) as [| ed]; [congruence |].
  destruct (between c d ec ed ne) as [y [b o]]. destruct (hc y b) as [less _].
  assert (middle : 2 * x = c + d) by (clear - same ne; magnitudes). clear - o less middle. destruct o; magnitudes.
Qed.
Theorem rounds_to_nearest_unique : forall x v w, rounded_spec x v -> rounded_spec x w -> v = w.
Proof.
  intros x v w. unfold rounded_spec. cbv zeta. rewrite limit_is. assert (p := limit_pos).
  destruct v as [c | |], w as [d | |]; intros a b; auto; try (exfalso; first [destruct a as [a _] | idtac];
    first [destruct b as [b _] | idtac]; magnitudes).
  f_equal. apply (nearest_unique x); [apply a | apply b].
Qed.

(** ** The greatest double that is not above a number *)
Lemma down_is : forall m e t, full m e -> IZR m * two e <= t ->
  (most_digits <= m /\ 971 <= e)%Z \/ 2 * t < IZR (next m e) * two e ->
  rounded_down_spec t (finite (IZR m * two e)).
Proof.
  intros m e t hf h up. split; [apply is_binary, hf |]. split; auto. intros y hy below.
  destruct (Rle_lt_dec y (IZR m * two e)) as [| lt]; auto. exfalso. destruct up as [top | up].
  - apply within_range in hy. rewrite greatest_is in hy. assert (m = most_digits) by (constants; lia).
    assert (e = 971%Z) by (constants; lia). subst m e. unfold most_digits in *. lra.
  - unfold next in up. destruct (Z.leb_spec 0 m) as [s | s].
    + apply beyond in lt; auto. rewrite !plus_IZR, ?mult_IZR in *. lra.
    + assert (g : - y < IZR (- m) * two e) by (rewrite opp_IZR; lra).
      apply short in g; [| lia | apply full_opp, hf | apply binary_opp, hy].
      rewrite ?plus_IZR, ?minus_IZR, ?mult_IZR, ?opp_IZR in *. lra.
Qed.
Lemma down_sound : forall x y k w, means Q2R (down x y k w) -> rounded_down_spec (at_terms x y k) (in_reals w).
Proof.
  intros x y k w h. unfold down in h. cbn [means] in h. destruct h as [hk h]. change (0 <= value Q2R k) in hk.
  destruct w as [[m e] | |]; unfold in_reals.
  - cbn [means] in h. destruct h as [d [h | [f [a b]]]]; apply is_double_means in d.
    + apply (equals_means x y k) in h. rewrite h. split; [apply is_binary, d |]. split; [lra | auto].
    + apply has_all_digits_means in f; auto. rewrite at_least_means, at_scaled in a, b by exact hk.
      cbn [value] in a, b. rewrite units_ge in a, b. apply down_is; auto.
      * rewrite mult_IZR in a. lra.
      * rewrite if_so_means, andb_true_iff, !Z.leb_le in b. destruct b as [b | b]; [left; tauto | right]. lra.
  - destruct h.
  - cbn [means] in h. rewrite at_least_means in h by exact hk. cbn [value] in h. rewrite opp_IZR in h.
    intros z hz. apply within_range in hz. lra.
Qed.
Theorem rounds_down_sound : forall t w, decide (rounds_down t w) = true ->
  rounded_down_spec (r_surd t) (in_reals w).
Proof. intros [x y k] w h. apply decide_means in h. apply down_sound in h. exact h. Qed.
Theorem rounds_up_sound : forall t w, decide (rounds_up t w) = true -> rounded_up_spec (r_surd t) (in_reals w).
Proof.
  intros [x y k] w h. apply decide_means in h. apply down_sound in h. rewrite at_opposite in h.
  destruct w as [[m e] | |]; try exact h. unfold in_reals in *. rewrite opp_IZR, <- Ropp_mult_distr_l in h. exact h.
Qed.
Theorem rounds_down_unique : forall x v w, rounded_down_spec x v -> rounded_down_spec x w -> v = w.
Proof.
  intros x [c | |] [d | |] a b; simpl in a, b; auto; try contradiction.
  - destruct a as [bc [lc hc]], b as [bd [ld hd]]. f_equal. apply Rle_antisym; auto.
  - destruct a as [bc [lc _]]. specialize (b c bc). lra.
  - destruct b as [bd [ld _]]. specialize (a d bd). lra.
Qed.
Theorem rounds_up_unique : forall x v w, rounded_up_spec x v -> rounded_up_spec x w -> v = w.
Proof.
  intros x v w a b. assert (h := rounds_down_unique _ _ _ a b).
  destruct v, w; try discriminate; auto. injection h as h. f_equal. lra.
Qed.
