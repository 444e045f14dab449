(* SPDX-License-Identifier: Apache-2.0 *)
(* What numbers, factors, terms and enclosures of enclosed.h say of real numbers; differences and products. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Filters Require Import arithmetic enclosed nearest.
Open Scope R_scope.

Notation T := (/ 2 ^ 25).
Ltac numbers := unfold cut, half_ulp in *; lra.
(* The proof is about this constant and no other. *)
Ltac names c H := lazymatch type of H with context [c] => idtac | _ => fail "another constant than" c end.
Ltac bounds := repeat match goal with H : Rabs _ <= _ |- _ => apply abs_le in H end.

Lemma seen_value p : seen p (value p).
Proof. destruct p; [reflexivity|now left]. Qed.
Lemma seen_negated p x : seen (negated p) x -> seen p (- x).
Proof. destruct p; simpl; [intros ->; ring|intros [->| ->]; [left|right]; ring]. Qed.
Lemma value_negated p : value (negated p) = - value p.
Proof. now destruct p. Qed.
Lemma magnitude_seen p x : seen (magnitude p) x -> x = Rabs (value p).
Proof. easy. Qed.
Lemma size x : 0 <= Rabs x /\ - Rabs x <= x <= Rabs x.
Proof. pose proof (Rabs_pos x). pose proof (abs_le x (Rabs x) (Rle_refl _)). lra. Qed.

Section Meaning.
Variable choice : Z -> bool.
Hypothesis symmetric : forall x, choice x = negb (choice (- (x + 1))).
Notation rnd := (nearest choice).

(* x itself, contracted or not *)
Definition exactly p x := float x /\ forall y, seen p y -> y = x.
(* a product is rounded *)
Definition sound p := match p with Plain _ => True | Product a b t => t = rnd (a * b) end.

Lemma exactly_value p x : exactly p x -> value p = x.
Proof. intros [_ H]. apply H, seen_value. Qed.
Lemma exactly_plain x : float x -> exactly (Plain x) x.
Proof. intros D. now split. Qed.
Lemma exactly_negated p x : exactly p x -> exactly (negated p) (- x).
Proof.
intros [D H]. split; [now apply generic_format_opp|]. intros y S. apply seen_negated, H in S. lra.
Qed.
Lemma sound_negated p : sound p -> sound (negated p).
Proof. destruct p; simpl; [easy|]. intros ->. rewrite <- nearest_opp by exact symmetric. f_equal. ring. Qed.
Lemma seen_near p x : sound p -> seen p x -> Rabs (x - value p) <= u * Rabs (value p).
Proof.
destruct p; simpl; [intros _ -> | intros -> [-> | ->]].
- rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. pose proof (Rabs_pos x0). numbers.
- rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. pose proof (Rabs_pos (rnd (a * b))). numbers.
- rewrite Rabs_minus_sym. apply near_own.
Qed.

(* r is the number x + y, rounded, and what that leaves *)
Definition pair_of r x := exists h l, r = Pair (Plain h) (Plain l) /\ h = rnd x /\ float l /\ h + l = x.
Theorem two_sum_right a b x y r : exactly a x -> exactly b y -> two_sum rnd a b r -> pair_of r (x + y).
Proof.
intros [A HA] [B HB]. unfold two_sum, added, subtracted. intros R.
repeat match goal with H : exists _, _ |- _ => destruct H | H : _ /\ _ |- _ => destruct H end.
repeat match goal with H : seen a _ |- _ => apply HA in H; subst | H : seen b _ |- _ => apply HB in H; subst
  | H : ?z = Plain _ |- _ => subst z | H : seen (Plain _) _ |- _ => simpl in H; subst end.
eexists _, _. split; [reflexivity|]. split; [reflexivity|]. split; [apply nearest_digits|].
now apply two_sum_exact with (choice := choice) (o := rnd (rnd (x + y) - x)).
Qed.
Theorem difference_right a b x y r : exactly a x -> exactly b y -> difference rnd a b r -> pair_of r (x - y).
Proof.
intros [A HA] [B HB]. unfold difference, added, subtracted. intros R.
repeat match goal with H : exists _, _ |- _ => destruct H | H : _ /\ _ |- _ => destruct H end.
repeat match goal with H : seen a _ |- _ => apply HA in H; subst | H : seen b _ |- _ => apply HB in H; subst
  | H : ?z = Plain _ |- _ => subst z | H : seen (Plain _) _ |- _ => simpl in H; subst end.
eexists _, _. split; [reflexivity|]. split; [reflexivity|]. split; [apply nearest_digits|].
now apply difference_exact with (choice := choice) (o := rnd (x - rnd (x - y))).
Qed.

(* X is head + tail, but for E; whole is X, but for c u *)
Definition factors c f X := exists h, exactly (factor_head f) h /\ digits kept h /\
  let t := value (factor_tail f) in
  Rabs (X - (h + t)) <= (1 + / 2 ^ 20) * E * Rabs h /\ Rabs t <= (1 + / 2 ^ 20) * T * Rabs h /\
  Rabs (value (factor_whole f) - X) <= c * u * Rabs h.

Lemma factor_of_pair_right p x f : pair_of p x -> factor_of_pair rnd p f -> factors (1 + / 2 ^ 20) f x.
Proof.
intros (h & l & -> & Hh & L & S) (t1 & (x1 & x2 & S1 & S2 & ->) & t2 & (x3 & x4 & S3 & S4 & ->) & ->).
cbn [seen pair_high pair_low] in S1, S2, S3, S4. unfold head in S2; cbn in S2. subst x1 x2 x3 x4.
unfold factors. cbn [factor_head factor_tail factor_whole]. 
unfold head. cbn [pair_high pair_low value].
set (k := round radix2 (FLX_exp kept) Ztrunc h).
assert (D : float h) by (rewrite Hh; apply nearest_digits).
pose proof (head_digits h : digits kept k) as K. exists k.
split; [apply exactly_plain; now apply digits_up with kept|]. split; [exact K|].
rewrite (nearest_exact choice (h - k)) by now apply head_rest.
pose proof (head_near h : Rabs (h - k) <= T * Rabs k) as N.
pose proof (near_own choice x) as O. rewrite <- Hh in O.
destruct (size k) as [P0 P]. assert (Hk : Rabs h <= (1 + T) * Rabs k).
{ replace h with ((h - k) + k) by ring. apply Rle_trans with (1 := Rabs_triang _ _). lra. }
assert (Bl : Rabs (h - x) <= u * (1 + T) * Rabs k).
{ apply Rle_trans with (1 := O). rewrite Rmult_assoc. apply Rmult_le_compat_l; [numbers|exact Hk]. }
bounds.
assert (Bt : Rabs (h - k + l) <= (1 + / 2 ^ 21) * T * Rabs k) by (apply le_abs; numbers).
pose proof (near choice _ _ Bt) as Nt. bounds.
repeat split; apply le_abs; numbers.
Qed.
Lemma factor_of_number_right p x f : exactly p x -> factor_of_number rnd p f -> factors 0 f x.
Proof.
intros X (t1 & (x1 & x2 & S1 & S2 & ->) & ->). destruct X as [D X].
pose proof (X _ (seen_value p)) as Vx. apply X in S1.
simpl in S2. subst x1 x2. unfold factors. cbn [factor_head factor_tail factor_whole].
unfold head. cbn [value]. rewrite Vx.
set (k := round radix2 (FLX_exp kept) Ztrunc x). pose proof (head_digits x : digits kept k) as K. exists k.
split; [apply exactly_plain; now apply digits_up with kept|]. split; [exact K|].
rewrite (nearest_exact choice (x - k)) by now apply head_rest.
pose proof (head_near x : Rabs (x - k) <= T * Rabs k) as N. destruct (size k) as [P0 P]. bounds.
repeat split; apply le_abs; numbers.
Qed.

(* Z is head + tail, but for a E *)
Definition term a r Z := exists h, exactly (term2_head r) h /\ sound (term2_tail r) /\
  forall t, seen (term2_tail r) t ->
    Rabs (Z - (h + t)) <= a * E * Rabs h /\ Rabs t <= (2 + / 2 ^ 16) * T * Rabs h.

(* The sum of two products in a tail; that of x may be off its bound by r. *)
Lemma product_tail hx tx hy ty wy t c r X Y : 0 <= c <= 2 -> 0 <= r ->
  Rabs (X - (hx + tx)) <= (1 + / 2 ^ 20) * E * Rabs hx -> Rabs tx <= (1 + / 2 ^ 20) * T * Rabs hx + r ->
  Rabs (Y - (hy + ty)) <= (1 + / 2 ^ 20) * E * Rabs hy -> Rabs ty <= (1 + / 2 ^ 20) * T * Rabs hy ->
  Rabs (wy - Y) <= c * u * Rabs hy ->
  added rnd (Product hx ty (rnd (hx * ty))) (Product tx wy (rnd (tx * wy))) (Plain t) ->
  Rabs (X * Y - (hx * hy + t)) <= (6 + c + / 2 ^ 16) * E * Rabs (hx * hy) + 5 * u * (r * Rabs hy) /\
  Rabs t <= (2 + / 2 ^ 16) * T * Rabs (hx * hy) + (1 + / 2 ^ 20) * (r * Rabs hy).
Proof.
intros C R0 BX Bx BY By BW (a & b & Sa & Sb & Ht). injection Ht as Ht.
destruct (size hx) as [Px _], (size hy) as [Py [L1 L2]]. set (A := Rabs hx) in *. set (B := Rabs hy) in *.
assert (C2 : c * B <= 2 * B) by (apply Rmult_le_compat_r; lra).
assert (C0 : 0 <= c * B) by (apply Rmult_le_pos; lra).
assert (HY : Rabs Y <= (1 + / 2 ^ 23) * B) by (bounds; apply le_abs; numbers).
assert (HW : Rabs wy <= (1 + / 2 ^ 22) * B) by (bounds; apply le_abs; numbers).
assert (Hx : Rabs hx <= 1 * A) by (unfold A; lra).
rewrite <- (Rmult_1_l (_ + r)) in Bx.
pose proof (prod_le _ _ _ _ _ _ BX HY) as P1. pose proof (prod_le _ _ _ _ _ _ Hx BY) as P2.
pose proof (prod_le _ _ _ _ _ _ Hx By) as P3. pose proof (prod_le _ _ _ _ _ _ Bx HW) as P4.
pose proof (prod_le _ _ _ _ _ _ Bx BW) as P5.
rewrite Rabs_mult. fold A B. rewrite Rmult_plus_distr_r, (Rmult_assoc _ A B) in P4, P5.
set (P := A * B) in *. set (W := r * B) in *.
assert (P0 : 0 <= P) by (apply Rmult_le_pos; assumption).
assert (W0 : 0 <= W) by (apply Rmult_le_pos; assumption).
assert (CP : c * P <= 2 * P) by (apply Rmult_le_compat_r; lra).
assert (CP0 : 0 <= c * P) by (apply Rmult_le_pos; lra).
assert (CW : c * W <= 2 * W) by (apply Rmult_le_compat_r; lra).
assert (Na : Rabs (a - hx * ty) <= (1 + / 2 ^ 20) * E * P).
{ destruct Sa as [-> | ->]; [pose proof (near choice _ _ P3); apply le_abs; numbers|].
  rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. numbers. }
assert (Nb : Rabs (b - tx * wy) <= (1 + / 2 ^ 19) * E * P + (1 + / 2 ^ 20) * u * W).
{ destruct Sb as [-> | ->]; [pose proof (near choice _ _ P4); apply le_abs; numbers|].
  rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. numbers. }
assert (S : Rabs (a + b) <= (2 + / 2 ^ 17) * T * P + (1 + / 2 ^ 21) * W) by (bounds; apply le_abs; numbers).
pose proof (near choice _ _ S) as Nt. rewrite <- Ht in Nt.
replace (X * Y - (hx * hy + t)) with ((X - (hx + tx)) * Y + hx * (Y - (hy + ty)) - (a - hx * ty) - (b - tx * wy)
  - tx * (wy - Y) - (t - (a + b))) by ring.
set (v1 := (X - (hx + tx)) * Y) in *. set (v2 := hx * (Y - (hy + ty))) in *. set (v5 := tx * (wy - Y)) in *.
set (v3 := hx * ty) in *. set (v4 := tx * wy) in *. clearbody v1 v2 v3 v4 v5 P W A B.
clear BX BY BW HY HW Hx Sa Sb. bounds. split; apply le_abs; numbers.
Qed.
Theorem product_right c d f g X Y r : 0 <= d <= 2 -> factors c f X -> factors d g Y -> product rnd f g r ->
  term (6 + d + / 2 ^ 16) r (X * Y).
Proof.
intros C (hx & Hx & Dx & BX & Bx & _) (hy & Hy & Dy & BY & By & BW) (t1 & -> & t2 & -> & t3 & -> & t4 & S & ->).
apply exactly_value in Hx, Hy. rewrite Hx, Hy in *.
destruct S as (x & y & S1 & S2 & ->). unfold term. cbn [term2_head term2_tail]. exists (hx * hy).
pose proof (head_product _ _ Dx Dy) as D. split.
- split; [exact D|]. intros y' [-> | ->]; [now apply nearest_exact|reflexivity].
- split; [easy|]. intros t ->. destruct (product_tail hx (value (factor_tail f)) hy (value (factor_tail g))
    (value (factor_whole g)) (rnd (x + y)) d 0 X Y); auto; try lra. exists x, y. auto.
Qed.

(* X is within error of high + low *)
Definition encloses r X := exists h, exactly (enclosed_high r) h /\ sound (enclosed_low r) /\
  sound (enclosed_error r) /\
  forall l e, seen (enclosed_low r) l -> seen (enclosed_error r) e -> Rabs (X - (h + l)) <= e.
End Meaning.
