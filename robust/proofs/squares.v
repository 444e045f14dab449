(* SPDX-License-Identifier: Apache-2.0 *)
(* Filters that compare the square of a radius with a sum of squares: the sum of both is itself the extent. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Filters Require Import model constants steps ghost tactics.
Open Scope R_scope.

Section Squares.
Variable u : R.
Hypothesis Hu : 0 < u <= 1/16.

(* x came of t >= 0 by j roundings *)
Definition between j x t := 0 <= t /\ (1 - u) ^ j * t <= x <= (1 + u) ^ j * t.

Lemma between_pos j x t : between j x t -> 0 <= x.
Proof. intros [P [L _]]. apply Rle_trans with (2 := L). apply Rmult_le_pos; [apply pow_le; lra|exact P]. Qed.
Lemma between_rounded j x t e : between j x t -> Rabs e <= u -> between (S j) (x * (1 + e)) t.
Proof.
intros B E%(ratio u). pose proof (between_pos _ _ _ B). destruct B as [P [L U]]. split; [exact P|].
rewrite <- !tech_pow_Rmult, !Rmult_assoc, !(Rmult_comm x).
split; apply Rmult_le_compat; try lra. apply Rmult_le_pos; [apply pow_le; lra|exact P].
Qed.
Lemma between_more i j x t : (i <= j)%nat -> between i x t -> between j x t.
Proof.
intros L [P [A B]]. split; [exact P|]. split.
- apply Rle_trans with (2 := A). apply Rmult_le_compat_r; [exact P|now apply down_more].
- apply Rle_trans with (1 := B). apply Rmult_le_compat_r; [exact P|now apply upward_more].
Qed.
Lemma between_sum i j x y s t e k : between i x s -> between j y t -> Rabs e <= u -> S (Nat.max i j) = k ->
  between k ((x + y) * (1 + e)) (s + t).
Proof.
intros X Y E <-. apply between_rounded; [|exact E]. apply between_more with (j := Nat.max i j) in X; [|lia].
apply between_more with (j := Nat.max i j) in Y; [|lia]. destruct X as [P [A B]], Y as [Q [C D]].
split; [lra|]. rewrite !Rmult_plus_distr_l. lra.
Qed.
Lemma between_square d e : Rabs e <= u -> between 1 (d * d * (1 + e)) (d * d).
Proof. intros E. apply between_rounded; [|exact E]. split; [nra|]. simpl. lra. Qed.
Lemma between_rounded_square d e e' : Rabs e <= u -> Rabs e' <= u ->
  between 3 (d * (1 + e) * (d * (1 + e)) * (1 + e')) (d * d).
Proof.
intros E E'. replace (d * (1 + e) * (d * (1 + e))) with (d * d * (1 + e) * (1 + e)) by ring.
repeat (apply between_rounded; [|assumption]). split; [nra|]. simpl. lra.
Qed.

(* i and o the exact squares, I and J two roundings of i, of which one may be contracted, O of o *)
Theorem squares a b K i o I J O : between a I i -> between a J i -> (1 - u) * I <= J -> between b O o -> 0 <= K <= 1 ->
  (1 + u) ^ a * (1 - K * (1 - u)) <= (1 + K) * (1 - u) ^ b -> (1 - K) * (1 + u) ^ b <= (1 - u) ^ a * (1 + K) ->
  (i <= o -> I - O <= K * (J + O)) /\ (o <= i -> O - I <= K * (J + O)).
Proof.
intros [Pi [I0 I1]] [_ [J0 _]] IJ [Po [O0 O1]] HK C1 C2.
assert (Q0 : 0 < (1 - u) ^ b) by (apply pow_lt; lra). assert (Q1 : 0 < (1 + u) ^ b) by (apply pow_lt; lra).
assert (P1 : 0 < (1 + u) ^ a) by (apply pow_lt; lra).
set (p0 := (1 - u) ^ a) in *. set (p1 := (1 + u) ^ a) in *. set (q0 := (1 - u) ^ b) in *. set (q1 := (1 + u) ^ b) in *.
clearbody p0 p1 q0 q1. split; intros L.
- assert (X : q0 * i <= O) by (apply Rle_trans with (q0 * o); [apply Rmult_le_compat_l|]; lra).
  assert (Y : K * ((1 - u) * I) <= K * J) by (apply Rmult_le_compat_l; lra).
  assert (B1 : 0 <= 1 - K * (1 - u)) by nra.
  assert (Z : I * (1 - K * (1 - u)) <= p1 * i * (1 - K * (1 - u))) by (apply Rmult_le_compat_r; lra).
  assert (W : p1 * (1 - K * (1 - u)) * i <= (1 + K) * q0 * i) by (apply Rmult_le_compat_r; lra).
  assert (V : (1 + K) * (q0 * i) <= (1 + K) * O) by (apply Rmult_le_compat_l; lra). lra.
- assert (X : O <= q1 * i) by (apply Rle_trans with (q1 * o); [|apply Rmult_le_compat_l]; lra).
  assert (Y : K * (p0 * i) <= K * J) by (apply Rmult_le_compat_l; lra).
  assert (W : (1 - K) * q1 * i <= p0 * (1 + K) * i) by (apply Rmult_le_compat_r; lra).
  assert (V : (1 - K) * O <= (1 - K) * (q1 * i)) by (apply Rmult_le_compat_l; lra). lra.
Qed.

(* two roundings with the same error, or without *)
Lemma contracted x e e1 e2 : 0 <= x -> Rabs e <= u -> e1 = e \/ e1 = 0 -> e2 = e \/ e2 = 0 ->
  (1 - u) * (x * (1 + e1)) <= x * (1 + e2).
Proof.
intros X E%(ratio u) D1 D2. assert (B : (1 - u) * (1 + e1) <= 1 + e2) by (destruct D1, D2; subst; nra).
replace ((1 - u) * (x * (1 + e1))) with (x * ((1 - u) * (1 + e1))) by ring. now apply Rmult_le_compat_l.
Qed.
End Squares.

(* rule (5): K is what a wrong sign can come to, with a roundings in I and b in O *)
Definition enough_squares u a b K C :=
  0 <= K <= 1 /\ (1 + u) ^ a * (1 - K * (1 - u)) <= (1 + K) * (1 - u) ^ b /\ (1 - K) * (1 + u) ^ b <= (1 - u) ^ a * (1
    + K) /\
  (1 + u) * K <= (1 - u) ^ 3 * C.
Ltac prove_enough := let Hu := fresh "Hu" in intros Hu; match type of Hu with 0 < ?u <= _ => fine_powers u Hu end;
  unfold enough_squares, relative; repeat split; lra.

Definition taken (z : R) := True.

Section Guard.
Variables (F : format) (H : R) (w v : Z).
Hypothesis G : fits F H w v.
Notation u := (u F). Notation n := (n F). Notation M := (reals F).

Lemma plain_nonneg x x' : 0 <= x -> uses F (Plain x) x' -> 0 <= x'.
Proof. intros P [->|[-> _]]; lra. Qed.
Lemma same_factors x a b : read F x a -> read F x b -> 0 <= a * b.
Proof. intros [->|[-> _]] [->|[-> _]]; nra. Qed.
Lemma square_nonneg x t : mul M x x t -> 0 <= t.
Proof. intros (a & b & A & B & _ & P & _). apply P. now apply same_factors with x. Qed.
Lemma product_nonneg x t x' : mul M x x t -> uses F (Product x x t) x' -> 0 <= x'.
Proof.
intros S [[->|[-> _]]|(a & b & A & B & ->)]; [now apply square_nonneg with x|lra|now apply same_factors with x].
Qed.
Lemma add_nonneg p r z : (forall x', uses F p x' -> 0 <= x') -> (forall x', uses F r x' -> 0 <= x') -> add M p r z ->
  0 <= z.
Proof.
intros A B (x' & y' & X & Y & _ & P & _). apply P. apply Rplus_le_le_0_compat; auto.
Qed.
Lemma parts_of_sum p r z k m m' : (forall x', uses F p x' -> 0 <= x') -> (forall x', uses F r x' -> 0 <= x') ->
  add M p r z -> small H (S k) m z -> m_guard w v m = m' ->
  exists x' y', uses F p x' /\ uses F r y' /\ x' + n <= q m' * H ^ S k /\ y' + n <= q m' * H ^ S k.
Proof.
intros A B (x' & y' & X & Y & (e & h & E & Hh & ->) & _) [M0 L] <-. exists x', y'. pose proof (basics F H w v G).
specialize (A _ X). specialize (B _ Y). apply abs_le in E, Hh, L.
assert ((x' + y') * (1 - u) <= (x' + y') * (1 + e)) by (apply Rmult_le_compat_l; lra).
assert (T : (x' + y') + n <= q (m_guard w v m) * H ^ S k) by (apply (guard_real F H w v G); [lra|exact M0]).
repeat split; auto; lra.
Qed.
Lemma plain_part x x' k m : 0 <= x -> uses F (Plain x) x' -> x' + n <= q m * H ^ k -> small H k m x.
Proof.
intros P U L. pose proof (basics F H w v G). assert (X : x <= x' + n).
{ destruct U as [->|[-> R]]; [lra|]. rewrite Rabs_right in R; lra. }
pose proof (pow_one F H w v G k). split; [|rewrite Rabs_right; lra].
apply le_IZR. assert (0 <= q m) by (apply Rmult_le_reg_r with (H ^ k); lra). unfold q in *. lra.
Qed.
Lemma square_part x t x' m s : mul M x x t -> uses F (Product x x t) x' -> x' + n <= q m * H ^ 2 -> (0 <= m)%Z ->
  (0 <= s)%Z -> (v <= s)%Z -> (1024 * m_guard w v m <= s * s)%Z -> small H 1 s x.
Proof.
intros S U L M0 S0 VS SS. pose proof (basics F H w v G) as B. split; [exact S0|]. rewrite pow_1.
assert (VQ : q v <= q s) by (apply IZR_le in VS; unfold q; lra).
destruct (Rlt_or_le (Rabs x) n) as [X|X].
{ apply Rle_trans with (q v * H); [lra|apply Rmult_le_compat_r; lra]. }
assert (Q : x * x * (1 - u) - n <= q m * H ^ 2).
{ assert (R : forall a, read F x a -> a = x) by (intros a [->|[_ Y]]; [easy|lra]).
  destruct U as [U|(a & b & A & C & ->)].
  - destruct S as (a & b & A & C & (e & h & E & Hh & E') & _). rewrite (R a A), (R b C) in E'. apply abs_le in E, Hh.
    assert (T : t <= x' + n). { destruct U as [->|[-> Y]]; [lra|]. apply Rlt_le, abs_le in Y. lra. }
    assert (x * x * (1 - u) <= x * x * (1 + e)) by (apply Rmult_le_compat_l; nra). lra.
  - rewrite (R a A), (R b C) in L. assert (0 <= x * x) by nra. assert (x * x * (1 - u) <= x * x) by nra. lra. }
apply (guard_real F H w v G 1) in Q; [|exact M0].
assert (K : q (m_guard w v m) <= q s * q s). { apply IZR_le in SS. rewrite !mult_IZR in SS. unfold q. lra. }
assert (XX : x * x <= q s * H * (q s * H)).
{ assert (0 <= H ^ 2) by (apply pow2_ge_0). assert (q (m_guard w v m) * H ^ 2 <= q s * q s * H ^ 2) by (apply
  Rmult_le_compat_r; lra).
  simpl in *. lra. }
assert (P : 0 <= q s * H) by (apply Rmult_le_pos; [apply q_nonneg, S0|lra]).
apply Rsqr_le_abs_0 in XX. now rewrite (Rabs_right (q s * H)) in XX by lra.
Qed.
End Guard.

Ltac square_uses := match goal with
  | |- forall x', uses _ (Plain ?x) x' -> 0 <= x' => intros ? ?; eapply plain_nonneg; [|eassumption]; assumption
  | S : mul (reals _) ?x ?x ?t |- forall x', uses _ (Product ?x ?x ?t) x' -> 0 <= x' =>
    intros ? ?; eapply product_nonneg; [exact S|eassumption] end.
Ltac squares_nonneg := repeat match goal with S : add (reals ?F) ?p ?r ?z |- _ =>
  lazymatch goal with P : 0 <= z |- _ => fail | _ => idtac end;
  let P := fresh "P" in assert (P : 0 <= z) by (eapply add_nonneg; [ | |exact S]; square_uses) end.
Ltac squared_guard G := lazymatch type of G with fits ?F ?H ?w ?v => match goal with
  | S : at_most (reals F) ?z (H * H) true, P : 0 <= ?z |- _ => pose proof (guard_squared F H w v G z S P) end end.
Ltac square_factor G U L := lazymatch type of G with fits ?F ?H ?w ?v => lazymatch type of U with
  | uses F (Plain ?x) ?x' => match goal with P : 0 <= x |- _ => pose proof (plain_part F H w v G x x' _ _ P U L) end
  | uses F (Product ?x ?x ?t) ?x' => match type of L with _ <= q ?m * _ =>
    let s := eval vm_compute in (Z.sqrt_up (1024 * m_guard w v m)) in
    match goal with S : mul (reals F) x x t |- _ =>
      pose proof (square_part F H w v G x t x' m s S U L ltac:(vm_compute; discriminate) ltac:(vm_compute; discriminate)
        ltac:(vm_compute; discriminate) ltac:(vm_compute; discriminate)) end end end end.
Ltac square_parts G := repeat (lazymatch type of G with fits ?F ?H ?w ?v => match goal with
  | B : small H 2 ?m ?z, S : add (reals F) ?p ?r ?z |- _ =>
    lazymatch goal with D : taken z |- _ => fail | _ => idtac end;
    let D := fresh "D" in assert (D : taken z) by exact I;
    let m' := eval vm_compute in (m_guard w v m) in
    let x' := fresh "x" in let y' := fresh "y" in let U1 := fresh "U" in let U2 := fresh "U" in
    let L1 := fresh "L" in let L2 := fresh "L" in
    destruct (parts_of_sum F H w v G p r z 1 m m' ltac:(square_uses) ltac:(square_uses) S B eq_refl)
      as (x' & y' & U1 & U2 & L1 & L2); square_factor G U1 L1; square_factor G U2 L2; clear x' y' U1 U2 L1 L2 || idtac
        end end).

Lemma square_pos r : 0 <= r * r. Proof. nra. Qed.
Ltac betweens Hu := match goal with
  | |- between _ _ ((?x + ?y) * (1 + ?e)) _ => eapply between_sum; [exact Hu| | |eassumption|reflexivity]; betweens Hu
  | |- between _ _ (?d * (1 + ?e) * (?d * (1 + ?e)) * (1 + ?e')) _ => apply between_rounded_square; assumption
  | |- between _ _ (?d * ?d * (1 + ?e')) _ => apply between_square; assumption end.

(* The last steps: a value I - O or O - I, a bound C (J + O) + num n H^k, C against K by enough. *)
Ltac compare_squares G num K enough Pos Neg P' Q' W1 W2 :=
  let Hu := fresh "Hu" in pose proof (fits_u _ _ _ _ G) as Hu;
  lazymatch type of G with fits ?F ?H ?w ?v =>
  match goal with X : greater (reals F) (Rabs ?x) ?b true |- _ =>
  match goal with S : greater (reals F) x 0 ?s |- _ =>
  match goal with NV : close F H ?k ?cv x (?D * (1 + ?e')) |- _ =>
  match goal with NB : close F H k ?cb b ((?C * (?Z * (1 + ?es)) * (1 + ?ec) + ?A) * (1 + ?e)) |- _ =>
  match goal with E : Rabs e <= u F |- _ =>
  match goal with E' : Rabs e' <= u F |- _ =>
    let I := match D with ?y - ?z => match Z with y + ?o => z | z + _ => y | ?i + y => z | ?i + z => y end end in
    let O := match D with I - ?o => o | ?o - I => o end in
    let J := match Z with ?y + O => y | O + ?y => y end in
    let L := fresh "L" in let N := fresh "N" in let BI := fresh "BI" in let BJ := fresh "BJ" in let BO := fresh "BO" in
    let IJ := fresh "IJ" in
    eassert (BI : between (u F) _ I _) by betweens Hu; eassert (BJ : between (u F) _ J _) by betweens Hu;
    eassert (BO : between (u F) _ O _) by betweens Hu; cbn [Nat.max] in BI, BJ, BO;
    assert (IJ : (1 - u F) * I <= J) by
      (match I with ?y * (1 + _) => match goal with Ei : Rabs ?e0 <= u F |- _ =>
         apply (contracted (u F) Hu y e0); [apply square_pos|exact Ei|first [assumption|now left]|first
           [assumption|now left]] end end);
    assert (T0 : 0 <= J + O) by
      (apply Rplus_le_le_0_compat; [apply (between_pos (u F) Hu _ _ _ BJ)|apply (between_pos (u F) Hu _ _ _ BO)]);
    assert (L : low (u F) 2 (C * (Z * (1 + es)) * (1 + ec)) (C * Z)) by
      (apply low_times with (i := 1%nat); [exact Hu|lra| |assumption|reflexivity];
       apply low_rounded; [exact Hu| |assumption]; apply low_self; lra);
    assert (N : A = IZR num * (n F * H ^ k)) by (simpl; ring);
    destruct (certain_ghost F H w v G k cv cb x (D * (1 + e')) b _ A e s 2 (C * Z) num NV NB E L N
      ltac:(vm_compute; discriminate) X S) as [Pos Neg];
    destruct enough as (K0 & K1 & K2 & K3);
    destruct (beyond (u F) Hu D e' (K * (J + O)) ((1 - u F) ^ 3 * (C * Z)) E') as [P' Q'];
      [apply Rmult_le_pos; lra
      |apply Rle_trans with ((1 + u F) * K * (J + O)); [right; ring|];
       apply Rle_trans with ((1 - u F) ^ 3 * C * (J + O)); [apply Rmult_le_compat_r; [exact T0|exact K3]|right; ring]|];
    destruct (squares (u F) Hu _ _ K _ _ I J O BI BJ IJ BO K0 K1 K2) as [W1 W2]
    end end end end end end end.
