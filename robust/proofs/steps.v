(* SPDX-License-Identifier: Apache-2.0 *)
(* How far a run on a machine is from its ghost: the run with the same relative errors that nothing underflows in. Every
   lemma here takes one operation; coefficients are integers, in units of 1/1024, so that a proof computes them. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Filters Require Import model.
Open Scope R_scope.

Lemma abs_le x a : Rabs x <= a -> - a <= x <= a.
Proof. intros H. split; [|apply Rle_trans with (2 := H), Rle_abs]. generalize (Rle_abs (- x)); rewrite Rabs_Ropp; lra.
  Qed.
Lemma le_abs x a : - a <= x <= a -> Rabs x <= a.
Proof. intros H. apply Rabs_le; lra. Qed.
Lemma mul_le x y a b : Rabs x <= a -> Rabs y <= b -> Rabs (x * y) <= a * b.
Proof. intros. rewrite Rabs_mult. apply Rmult_le_compat; auto using Rabs_pos. Qed.

Section Steps.
Variable F : format.
Variable H : R.
Variables w v : Z.
Notation u := (u F). Notation n := (n F). Notation M := (reals F).

(* u <= w / 1024, n <= v / 1024 H, the constants are normal *)
Record fits := {
  u_low : 0 < u; u_high : 1024 * u <= IZR w; w_high : (w <= 64)%Z;
  n_low : 0 < n; n_high : 1024 * n <= IZR v * H; v_high : (v <= 64)%Z;
  n_u : n <= u; H_low : 2 <= H }.
Hypothesis G : fits.

Definition q (c : Z) := IZR c / 1024.
Definition close k c x x0 := (0 <= c)%Z /\ Rabs (x - x0) <= q c * (n * H ^ k).
Definition small k m x := (0 <= m)%Z /\ Rabs x <= q m * H ^ k.

Definition up (a b : Z) := (- (- (a * b) / 1024))%Z.
Lemma up_q a b : q a * q b <= q (up a b).
Proof.
unfold up, q. assert (L : (a * b <= 1024 * - (- (a * b) / 1024))%Z).
{ pose proof (Z.mul_div_le (- (a * b)) 1024). lia. }
apply IZR_le in L. rewrite !mult_IZR in L. lra.
Qed.
Lemma up_nonneg a b : (0 <= a -> 0 <= b -> 0 <= up a b)%Z.
Proof. intros. unfold up. assert (- (a * b) / 1024 <= 0)%Z by (apply Z.div_le_upper_bound; nia). lia. Qed.
Lemma q_nonneg c : (0 <= c)%Z -> 0 <= q c.
Proof. intros L. apply IZR_le in L. unfold q. lra. Qed.
Lemma q_plus a b : q (a + b) = q a + q b.
Proof. unfold q. rewrite plus_IZR. lra. Qed.
Lemma q_one : q 1024 = 1. Proof. unfold q. lra. Qed.

Lemma basics : 0 < u /\ u <= q w /\ u <= 1/16 /\ 0 < n /\ n <= q v * H /\ n <= 1/16 /\ 2 <= H /\ (0 <= w)%Z /\ (0 <=
  v)%Z.
Proof.
destruct G as [A B C D E E' N L]. apply IZR_le in C, E'.
assert (0 < IZR w) by lra. assert (0 < IZR v * H) by lra. assert (0 < IZR v) by (apply Rmult_lt_reg_r with H; lra).
unfold q. repeat split; try lra; apply le_IZR; lra.
Qed.
Lemma pow_one k : 1 <= H ^ k.
Proof. apply pow_R1_Rle. pose proof basics. lra. Qed.
Lemma pow_up j k : (j <= k)%nat -> H ^ j <= H ^ k.
Proof. intros. apply Rle_pow; [pose proof basics; lra|assumption]. Qed.
Lemma n_pow k : n <= n * H ^ k.
Proof. pose proof basics. pose proof (pow_one k). nra. Qed.
Lemma n_pow_S k : n * H ^ k <= q v * H ^ S k.
Proof.
pose proof basics. pose proof (pow_one k). simpl. rewrite <- Rmult_assoc. apply Rmult_le_compat_r; lra.
Qed.
Lemma one_e e : Rabs e <= u -> Rabs (1 + e) <= q (1024 + w).
Proof. intros E%abs_le. pose proof basics. rewrite q_plus, q_one. apply le_abs; lra. Qed.

Lemma read_close k c x x0 x' : close k c x x0 -> read F x x' -> close k (c + 1024) x' x0.
Proof.
intros [C L] R. split; [lia|]. rewrite q_plus, q_one. pose proof (n_pow k).
assert (N : Rabs (x' - x) <= n).
{ pose proof basics. destruct R as [->|[-> R]]; [rewrite Rminus_diag_eq, Rabs_R0 by reflexivity; lra|].
  unfold Rminus; rewrite Rplus_0_l, Rabs_Ropp. lra. }
apply abs_le in N, L. apply le_abs. lra.
Qed.
Lemma read_small k m x x' : small k m x -> read F x x' -> small k m x'.
Proof.
intros [C L] [->|[-> R]]; (split; [lia|]); [exact L|]. rewrite Rabs_R0. pose proof (Rabs_pos x). lra.
Qed.
Lemma abs_close k c x x0 : close k c x x0 -> close k c (Rabs x) (Rabs x0).
Proof. intros [C L]. split; [exact C|]. apply Rle_trans with (2 := L), Rabs_triang_inv2. Qed.
Lemma abs_small k m x : small k m x -> small k m (Rabs x).
Proof. intros [C L]. split; [exact C|]. now rewrite Rabs_Rabsolu. Qed.
Lemma input_close k x : close k 0 x x.
Proof. split; [lia|]. rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. unfold q. lra. Qed.
Lemma close_up j k c x x0 : (j <= k)%nat -> close j c x x0 -> close k c x x0.
Proof.
intros J [C L]. split; [exact C|]. apply Rle_trans with (1 := L). apply Rmult_le_compat_l; [apply q_nonneg, C|].
apply Rmult_le_compat_l; [pose proof basics; lra|apply pow_up, J].
Qed.
Lemma small_up j k m x : (j <= k)%nat -> small j m x -> small k m x.
Proof.
intros J [C L]. split; [exact C|]. apply Rle_trans with (1 := L). apply Rmult_le_compat_l; [apply q_nonneg, C|apply
  pow_up, J].
Qed.

Definition c_rounded c := (up (1024 + w) c + 1024)%Z.
Lemma rounded_close k c r r0 z : close k c r r0 -> rounded F r z ->
  exists e, Rabs e <= u /\ close k (c_rounded c) z (r0 * (1 + e)).
Proof.
intros [C L] [(e & h & E & Hh & ->) _]. exists e. split; [exact E|]. pose proof basics. split.
- assert (0 <= up (1024 + w) c)%Z by (apply up_nonneg; lia). unfold c_rounded. lia.
- replace (r * (1 + e) + h - r0 * (1 + e)) with ((1 + e) * (r - r0) + h) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _). unfold c_rounded. rewrite q_plus, q_one.
  pose proof (mul_le _ _ _ _ (one_e _ E) L). pose proof (up_q (1024 + w) c). pose proof (n_pow k).
  assert (q (1024 + w) * q c * (n * H ^ k) <= q (up (1024 + w) c) * (n * H ^ k)) by (apply Rmult_le_compat_r; lra). lra.
Qed.
Lemma rounded_small k m r z : small (S k) m r -> rounded F r z -> small (S k) (up (1024 + w) m + v) z.
Proof.
intros [C L] [(e & h & E & Hh & ->) _]. pose proof basics. split.
- assert (0 <= up (1024 + w) m)%Z by (apply up_nonneg; lia). lia.
- apply Rle_trans with (1 := Rabs_triang _ _). rewrite q_plus, (Rmult_comm r).
  pose proof (mul_le _ _ _ _ (one_e _ E) L). pose proof (up_q (1024 + w) m). pose proof (n_pow k). pose proof (n_pow_S
    k).
  pose proof (pow_one (S k)).
  assert (q (1024 + w) * q m * H ^ S k <= q (up (1024 + w) m) * H ^ S k) by (apply Rmult_le_compat_r; lra). lra.
Qed.

(* products *)
Definition c_exact c1 m1 c2 m2 := (up (c1 + 1024) m2 + up (m1 + up c1 v) (c2 + 1024))%Z.
Definition c_product c1 m1 c2 m2 := (c_rounded (c_exact c1 m1 c2 m2))%Z.
Definition m_product m1 m2 := (up (1024 + w) (up m1 m2) + v)%Z.

Lemma exact_close k1 c1 m1 x x0 k2 c2 m2 y y0 x' y' : close k1 c1 x x0 -> small (S k1) m1 x -> close k2 c2 y y0 ->
  small (S k2) m2 y -> read F x x' -> read F y y' -> close (S (k1 + k2)) (c_exact c1 m1 c2 m2) (x' * y') (x0 * y0).
Proof.
intros X Sx Y Sy Rx Ry. pose proof basics.
destruct (read_close _ _ _ _ _ X Rx) as [Cx Lx]. destruct (read_close _ _ _ _ _ Y Ry) as [Cy Ly].
destruct (read_small _ _ _ _ Sy Ry) as [My By]. destruct X as [Cx0 Lx0]. destruct Sx as [Mx Bx].
assert (U1 : (0 <= up c1 v)%Z) by (apply up_nonneg; lia).
assert (B0 : Rabs x0 <= q (m1 + up c1 v) * H ^ S k1).
{ pose proof (n_pow_S k1). pose proof (up_q c1 v). pose proof (pow_one (S k1)). pose proof (q_nonneg _ Cx0).
  assert (q c1 * (n * H ^ k1) <= q c1 * (q v * H ^ S k1)) by (apply Rmult_le_compat_l; lra).
  assert (q c1 * q v * H ^ S k1 <= q (up c1 v) * H ^ S k1) by (apply Rmult_le_compat_r; lra).
  rewrite q_plus. replace x0 with (x + - (x - x0)) by ring. apply Rle_trans with (1 := Rabs_triang _ _).
  rewrite Rabs_Ropp. lra. }
split.
- pose proof (up_nonneg (c1 + 1024) m2 Cx My).
  assert (0 <= up (m1 + up c1 v) (c2 + 1024))%Z by (apply up_nonneg; lia). unfold c_exact. lia.
- replace (x' * y' - x0 * y0) with ((x' - x0) * y' + x0 * (y' - y0)) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _). unfold c_exact. rewrite q_plus, Rmult_plus_distr_r.
  assert (P : 0 <= n * H ^ S (k1 + k2)) by (apply Rmult_le_pos; [lra|apply pow_le; lra]).
  apply Rplus_le_compat.
  + apply Rle_trans with (1 := mul_le _ _ _ _ Lx By).
    apply Rle_trans with (q (c1 + 1024) * q m2 * (n * H ^ S (k1 + k2))); [|apply Rmult_le_compat_r; [exact P|apply
      up_q]].
    right. replace (S (k1 + k2)) with (k1 + S k2)%nat by lia. rewrite pow_add. ring.
  + apply Rle_trans with (1 := mul_le _ _ _ _ B0 Ly).
    apply Rle_trans with (q (m1 + up c1 v) * q (c2 + 1024) * (n * H ^ S (k1 + k2)));
      [|apply Rmult_le_compat_r; [exact P|apply up_q]].
    right. replace (S (k1 + k2)) with (S k1 + k2)%nat by lia. rewrite pow_add. ring.
Qed.
Lemma exact_small k1 m1 x k2 m2 y x' y' : small (S k1) m1 x -> small (S k2) m2 y -> read F x x' -> read F y y' ->
  small (S (S (k1 + k2))) (up m1 m2) (x' * y').
Proof.
intros Sx Sy Rx Ry. destruct (read_small _ _ _ _ Sx Rx) as [Mx Bx]. destruct (read_small _ _ _ _ Sy Ry) as [My By].
split; [now apply up_nonneg|]. apply Rle_trans with (1 := mul_le _ _ _ _ Bx By).
apply Rle_trans with (q m1 * q m2 * H ^ S (S (k1 + k2))).
- right. replace (S (S (k1 + k2))) with (S k1 + S k2)%nat by lia. rewrite pow_add. ring.
- apply Rmult_le_compat_r; [pose proof (pow_one (S (S (k1 + k2)))); lra|apply up_q].
Qed.
Lemma mul_close k1 c1 m1 x x0 k2 c2 m2 y y0 z c : close k1 c1 x x0 -> small (S k1) m1 x -> close k2 c2 y y0 ->
  small (S k2) m2 y -> mul M x y z -> c_product c1 m1 c2 m2 = c ->
  exists e, Rabs e <= u /\ close (S (k1 + k2)) c z (x0 * y0 * (1 + e)).
Proof.
intros X Sx Y Sy (x' & y' & Rx & Ry & Z) <-.
exact (rounded_close _ _ _ _ _ (exact_close _ _ _ _ _ _ _ _ _ _ _ _ X Sx Y Sy Rx Ry) Z).
Qed.
Lemma mul_small k1 m1 x k2 m2 y z m : small (S k1) m1 x -> small (S k2) m2 y -> mul M x y z -> m_product m1 m2 = m ->
  small (S (S (k1 + k2))) m z.
Proof.
intros Sx Sy (x' & y' & Rx & Ry & Z) <-. exact (rounded_small _ _ _ _ (exact_small _ _ _ _ _ _ _ _ Sx Sy Rx Ry) Z).
Qed.
Lemma up_grows c : (0 <= c)%Z -> (c <= up (1024 + w) c)%Z.
Proof. intros. pose proof basics. unfold up. pose proof (Z.mul_div_le (- ((1024 + w) * c)) 1024). nia. Qed.
(* a product where it is added: rounded, with the error that it has elsewhere, or contracted *)
Lemma use_product k1 c1 m1 x x0 k2 c2 m2 y y0 z e z' c : close k1 c1 x x0 -> small (S k1) m1 x -> close k2 c2 y y0 ->
  small (S k2) m2 y -> close (S (k1 + k2)) (c_product c1 m1 c2 m2) z (x0 * y0 * (1 + e)) -> Rabs e <= u ->
  uses F (Product x y z) z' -> (c_product c1 m1 c2 m2 + 1024)%Z = c ->
  exists e', Rabs e' <= u /\ (e' = e \/ e' = 0) /\ close (S (k1 + k2)) c z' (x0 * y0 * (1 + e')).
Proof.
intros X Sx Y Sy Z E [U|(x' & y' & Rx & Ry & ->)] <-.
- exists e. split; [exact E|]. split; [now left|]. now apply read_close with z.
- exists 0. rewrite Rabs_R0. pose proof basics. split; [lra|]. split; [now right|].
  destruct (exact_close _ _ _ _ _ _ _ _ _ _ _ _ X Sx Y Sy Rx Ry) as [C L]. rewrite Rplus_0_r, Rmult_1_r.
  pose proof (up_grows _ C). split; [unfold c_product, c_rounded; lia|]. apply Rle_trans with (1 := L).
  apply Rmult_le_compat_r; [apply Rmult_le_pos; [lra|apply pow_le; lra]|].
  unfold q. apply Rmult_le_compat_r; [lra|]. apply IZR_le. unfold c_product, c_rounded. lia.
Qed.
Lemma use_product_small k1 m1 x k2 m2 y z z' : small (S k1) m1 x -> small (S k2) m2 y ->
  small (S (S (k1 + k2))) (m_product m1 m2) z -> uses F (Product x y z) z' ->
  small (S (S (k1 + k2))) (m_product m1 m2) z'.
Proof.
intros Sx Sy Sz [U|(x' & y' & Rx & Ry & ->)]; [now apply read_small with z|].
destruct (exact_small _ _ _ _ _ _ _ _ Sx Sy Rx Ry) as [C L]. pose proof basics. pose proof (up_grows _ C).
split; [unfold m_product; lia|]. apply Rle_trans with (1 := L). apply Rmult_le_compat_r; [apply pow_le; lra|].
unfold q. apply Rmult_le_compat_r; [lra|]. apply IZR_le. unfold m_product. lia.
Qed.

(* constants times numbers *)
Lemma times_close k c c0 mC y y0 z r : n <= c0 <= q mC -> close k c y y0 -> mul M c0 y z ->
  c_rounded (up mC (c + 1024)) = r ->
  exists e, Rabs e <= u /\ close k r z (c0 * y0 * (1 + e)) /\
    forall z' r', uses F (Product c0 y z) z' -> (r + 1024)%Z = r' ->
      exists e', Rabs e' <= u /\ (e' = e \/ e' = 0) /\ close k r' z' (c0 * y0 * (1 + e')).
Proof.
intros C0 Y (c' & y' & Rc & Ry & Z) <-. pose proof basics.
assert (Z0 : forall c'' y'', read F c0 c'' -> read F y y'' -> close k (up mC (c + 1024)) (c'' * y'') (c0 * y0)).
{ intros c'' y'' Rc'' Ry''. assert (c'' = c0) as -> by (destruct Rc'' as [->|[_ R]]; [easy|rewrite Rabs_right in R;
  lra]).
  destruct (read_close _ _ _ _ _ Y Ry'') as [C L].
  assert (P : (0 <= mC)%Z) by (apply le_IZR; unfold q in C0; lra).
  split; [now apply up_nonneg|]. replace (c0 * y'' - c0 * y0) with (c0 * (y'' - y0)) by ring.
  assert (A : Rabs c0 <= q mC) by (rewrite Rabs_right; lra). apply Rle_trans with (1 := mul_le _ _ _ _ A L).
  rewrite <- Rmult_assoc. apply Rmult_le_compat_r; [apply Rmult_le_pos; [lra|apply pow_le; lra]|apply up_q]. }
destruct (rounded_close _ _ _ _ _ (Z0 _ _ Rc Ry) Z) as (e & E & N). exists e. split; [exact E|]. split; [exact N|].
intros z' r' [U|(a' & b' & Ra & Rb & ->)] <-.
- exists e. split; [exact E|]. split; [now left|]. now apply read_close with z.
- exists 0. rewrite Rabs_R0. split; [lra|]. split; [now right|]. destruct (Z0 _ _ Ra Rb) as [C L].
  pose proof (up_grows _ C). rewrite Rplus_0_r, Rmult_1_r. split; [unfold c_rounded; lia|].
  apply Rle_trans with (1 := L). apply Rmult_le_compat_r; [apply Rmult_le_pos; [lra|apply pow_le; lra]|].
  unfold q. apply Rmult_le_compat_r; [lra|]. apply IZR_le. unfold c_rounded. lia.
Qed.
Lemma times_small k m c0 mC y z r : 0 <= c0 <= q mC -> small (S k) m y -> mul M c0 y z -> (up (1024 + w) (up mC m) +
  v)%Z = r ->
  small (S k) r z.
Proof.
intros C0 Y (c' & y' & Rc & Ry & Z) <-. apply rounded_small with (c' * y'); [|exact Z].
destruct (read_small _ _ _ _ Y Ry) as [C L]. assert (P : (0 <= mC)%Z) by (apply le_IZR; unfold q in C0; lra).
split; [now apply up_nonneg|].
assert (A : Rabs c' <= q mC) by (destruct Rc as [->|[-> _]]; [rewrite Rabs_right; lra|rewrite Rabs_R0; lra]).
apply Rle_trans with (1 := mul_le _ _ _ _ A L). rewrite <- Rmult_assoc. pose proof (pow_one (S k)).
apply Rmult_le_compat_r; [lra|apply up_q].
Qed.

(* sums *)
Lemma add_close k1 c1 x x0 k2 c2 y y0 z k c : close k1 c1 x x0 -> close k2 c2 y y0 -> rounded F (x + y) z ->
  Nat.max k1 k2 = k -> c_rounded (c1 + c2) = c -> exists e, Rabs e <= u /\ close k c z ((x0 + y0) * (1 + e)).
Proof.
intros X Y Z <- <-. apply rounded_close with (x + y); [|exact Z].
apply close_up with (k := Nat.max k1 k2) in X; [|lia]. apply close_up with (k := Nat.max k1 k2) in Y; [|lia].
destruct X as [C1 X], Y as [C2 Y]. split; [lia|]. rewrite q_plus.
apply abs_le in X, Y. apply le_abs. lra.
Qed.
Lemma sub_close k1 c1 x x0 k2 c2 y y0 z k c : close k1 c1 x x0 -> close k2 c2 y y0 -> rounded F (x - y) z ->
  Nat.max k1 k2 = k -> c_rounded (c1 + c2) = c -> exists e, Rabs e <= u /\ close k c z ((x0 - y0) * (1 + e)).
Proof.
intros X [C Y] Z K C'. unfold Rminus in *. apply (add_close k1 c1 x x0 k2 c2 (- y)); auto. split; [exact C|].
replace (- y - - y0) with (- (y + - y0)) by ring. now rewrite Rabs_Ropp.
Qed.
Lemma add_small k1 m1 x k2 m2 y z k m : small (S k1) m1 x -> small (S k2) m2 y -> rounded F (x + y) z ->
  Nat.max k1 k2 = k -> (up (1024 + w) (m1 + m2) + v)%Z = m -> small (S k) m z.
Proof.
intros X Y Z <- <-. apply rounded_small with (x + y); [|exact Z].
apply small_up with (k := S (Nat.max k1 k2)) in X; [|lia]. apply small_up with (k := S (Nat.max k1 k2)) in Y; [|lia].
destruct X as [C1 X], Y as [C2 Y]. split; [lia|]. rewrite q_plus. apply abs_le in X, Y. apply le_abs. lra.
Qed.
Lemma sub_small k1 m1 x k2 m2 y z k m : small (S k1) m1 x -> small (S k2) m2 y -> rounded F (x - y) z ->
  Nat.max k1 k2 = k -> (up (1024 + w) (m1 + m2) + v)%Z = m -> small (S k) m z.
Proof.
intros X [C Y] Z K K'. unfold Rminus in *. apply (add_small k1 m1 x k2 m2 (- y)); auto. split; [exact C|]. now rewrite
  Rabs_Ropp.
Qed.

(* rule (1): a difference, or a sum, of two numbers of the input *)
Lemma difference_close a b D c : sub M (Plain a) (Plain b) D -> c_rounded 2048 = c ->
  exists e, Rabs e <= u /\ close 0 c D ((a - b) * (1 + e)).
Proof.
intros (a' & b' & A & B & Z) <-. pose proof (input_close 0 a) as Ca. pose proof (input_close 0 b) as Cb.
exact (sub_close _ _ _ _ _ _ _ _ _ _ _ (read_close _ _ _ _ _ Ca A) (read_close _ _ _ _ _ Cb B) Z eq_refl eq_refl).
Qed.
Lemma sum_close a b D c : add M (Plain a) (Plain b) D -> c_rounded 2048 = c ->
  exists e, Rabs e <= u /\ close 0 c D ((a + b) * (1 + e)).
Proof.
intros (a' & b' & A & B & Z) <-. pose proof (input_close 0 a) as Ca. pose proof (input_close 0 b) as Cb.
exact (add_close _ _ _ _ _ _ _ _ _ _ _ (read_close _ _ _ _ _ Ca A) (read_close _ _ _ _ _ Cb B) Z eq_refl eq_refl).
Qed.

(* guards *)
Lemma sum_nonneg x y z : 0 <= x -> 0 <= y -> add M (Plain x) (Plain y) z -> 0 <= z.
Proof.
intros X Y (x' & y' & Rx & Ry & _ & P & _). apply P.
destruct Rx as [->|[-> _]], Ry as [->|[-> _]]; lra.
Qed.
Definition m_guard m := ((- (- ((m + v) * 1024) / (1024 - w))) + v)%Z.
Lemma guard_real k m X : X * (1 - u) - n <= q m * H ^ S k -> (0 <= m)%Z -> X + n <= q (m_guard m) * H ^ S k.
Proof.
intros L M0. pose proof basics. pose proof (n_pow k). pose proof (n_pow_S k). pose proof (pow_one (S k)).
assert (w64 : (w <= 64)%Z) by apply G.
set (D := (- (- ((m + v) * 1024) / (1024 - w)))%Z).
assert (LD : ((m + v) * 1024 <= (1024 - w) * D)%Z).
{ unfold D. pose proof (Z.mul_div_le (- ((m + v) * 1024)) (1024 - w)). lia. }
apply IZR_le in LD. rewrite !mult_IZR, minus_IZR, plus_IZR in LD.
assert (E : q (m + v) <= (1 - q w) * q D) by (unfold q; rewrite plus_IZR; lra).
assert (N : n <= q v * H ^ S k) by lra.
assert (X * (1 - u) <= q (m + v) * H ^ S k) by (rewrite q_plus; lra).
assert (D0 : 0 <= q D). { assert (0 < 1 - q w) by (apply IZR_le in w64; unfold q; lra).
  assert (0 <= q (m + v)) by (apply q_nonneg; lia). apply Rmult_le_reg_l with (1 - q w); lra. }
assert ((1 - q w) * q D * H ^ S k <= (1 - u) * q D * H ^ S k).
{ apply Rmult_le_compat_r; [lra|]. apply Rmult_le_compat_r; lra. }
assert (q (m + v) * H ^ S k <= (1 - q w) * q D * H ^ S k) by (apply Rmult_le_compat_r; lra).
assert (X <= q D * H ^ S k).
{ apply Rmult_le_reg_r with (1 - u); [lra|]. lra. }
change (m_guard m) with (D + v)%Z. rewrite q_plus. lra.
Qed.
Lemma sum_guard x y z k m m' : 0 <= x -> 0 <= y -> add M (Plain x) (Plain y) z -> small (S k) m z -> m_guard m = m' ->
  small (S k) m' x /\ small (S k) m' y.
Proof.
intros X Y (x' & y' & Rx & Ry & (e & h & E & Hh & ->) & _) [M0 L] <-. pose proof basics.
apply abs_le in E, Hh, L.
assert (x - n <= x' /\ 0 <= x') as [] by (destruct Rx as [->|[-> Hx%Rlt_le%abs_le]]; lra).
assert (y - n <= y' /\ 0 <= y') as [] by (destruct Ry as [->|[-> Hy%Rlt_le%abs_le]]; lra).
assert ((x' + y') * (1 - u) <= (x' + y') * (1 + e)) by (apply Rmult_le_compat_l; lra).
assert (T : (x' + y') + n <= q (m_guard m) * H ^ S k) by (apply guard_real; [lra|exact M0]).
assert (P : (0 <= m_guard m)%Z). { apply le_IZR. pose proof (pow_one (S k)).
  assert (0 <= q (m_guard m)) by (apply Rmult_le_reg_r with (H ^ S k); lra). unfold q in *. lra. }
split; (split; [exact P|]); rewrite Rabs_right; lra.
Qed.
Lemma guard_holds z : at_most M z H true -> 0 <= z -> small 1 1024 z.
Proof.
intros (z' & h' & Rz & Rh & B) P. pose proof basics. split; [lia|]. rewrite q_one, Rmult_1_l, pow_1, Rabs_right by lra.
assert (h' = H) as -> by (destruct Rh as [->|[_ R]]; [easy|rewrite Rabs_right in R; lra]).
destruct Rz as [->|[-> R]]; [now apply B|]. rewrite Rabs_right in R; lra.
Qed.
Lemma guard_squared z : at_most M z (H * H) true -> 0 <= z -> small 2 1024 z.
Proof.
intros (z' & h' & Rz & Rh & B) P. pose proof basics. assert (1 < H * H) by nra.
split; [lia|]. rewrite q_one, Rmult_1_l, Rabs_right by lra. simpl. rewrite Rmult_1_r.
assert (h' = H * H) as -> by (destruct Rh as [->|[_ R]]; [easy|rewrite Rabs_right in R; lra]).
destruct Rz as [->|[-> R]]; [now apply B|]. rewrite Rabs_right in R; lra.
Qed.
Lemma smaller k m x : small k m (Rabs x) -> small k m x.
Proof. intros [C L]. split; [exact C|]. now rewrite Rabs_Rabsolu in L. Qed.

(* the comparison with the bound *)
Lemma certain k a cV cB V V0 B B0 X s : close k cV V V0 -> close k cB B B0 -> X + q a * (n * H ^ k) <= B0 -> 0 <= X ->
  (cV + cB + 1024 <= a)%Z -> greater M (Rabs V) B true -> greater M V 0 s ->
  (s = true -> V0 > X) /\ (s = false -> V0 < - X).
Proof.
intros [_ LV] [_ LB] L X0 A (V' & B' & RV & RB & [K _]) (V2 & z & RV2 & Rz & S). specialize (K eq_refl). pose proof
  basics.
pose proof (n_pow k) as N. set (N0 := n * H ^ k) in *.
assert (A' : q cV + q cB + 1 <= q a). { apply IZR_le in A. rewrite !plus_IZR in A. unfold q. lra. }
assert (T : (q cV + q cB + 1) * N0 <= q a * N0) by (apply Rmult_le_compat_r; lra).
assert (C0 : 0 <= q cV * N0) by (apply Rle_trans with (2 := LV), Rabs_pos).
apply abs_le in LV, LB.
assert (BN : B >= N0) by lra.
assert (BB : B' = B) by (destruct RB as [->|[_ R]]; [easy|exfalso; rewrite Rabs_right in R; lra]).
assert (z = 0) as -> by (destruct Rz as [->|[-> _]]; easy).
assert (VV : Rabs V >= V'). { destruct RV as [->|[-> _]]; [lra|]. generalize (Rabs_pos V); lra. }
assert (big : Rabs V > B) by lra.
assert (V2 = V) as -> by (destruct RV2 as [->|[_ R]]; [easy|exfalso; lra]).
split.
- intros ->. apply proj1 in S. specialize (S eq_refl). rewrite Rabs_right in big; lra.
- intros ->. assert (V <= 0) by (apply Rnot_lt_le; intros Q; apply S in Q; discriminate). rewrite Rabs_left1 in big;
  lra.
Qed.
End Steps.
