(* SPDX-License-Identifier: Apache-2.0 *)
(** A point that is not in the hull of finitely many points is in front of a plane that has all of them behind it
    (Farkas). *)
Require Import Reals Lra Lia List Arith.
From Certificates Require Import hulls solids formulas_vectors sound_solids sound_vectors sound_nearest.
Import ListNotations.
Open Scope R_scope.

Lemma plus_dot : forall x y n, length x = length y -> dot (plus x y) n = dot x n + dot y n.
Proof. intros. rewrite dot_sym, dot_plus, !(dot_sym n); auto. Qed.
Lemma zero_of_square : forall x, dot x x = 0 -> x = repeat 0 (length x).
Proof.
  induction x as [|a x IH]; intro h; simpl in *; auto. assert (g := square a). assert (k := dot_self x).
  rewrite <- IH by lra. f_equal. assert (e : a * a = 0) by lra. destruct (Rmult_integral _ _ e); auto.
Qed.
Lemma plus_nothing : forall a n, length a = n -> plus (repeat 0 n) (times 0 a) = repeat 0 n.
Proof. unfold times. induction a as [|c a IH]; intros n <-; simpl; auto. rewrite IH by auto. f_equal. ring. Qed.
Lemma greatest_of : forall {B} (f : B -> R) l, l <> [] -> exists x, In x l /\ forall y, In y l -> f y <= f x.
Proof.
  induction l as [|x [|y l] IH]; intro some; [tauto | |].
  - exists x. split; [simpl; auto|]. intros y [<- | []]. lra.
  - destruct (IH ltac:(discriminate)) as (z & i & h). destruct (Rle_lt_dec (f z) (f x)) as [le | lt].
    + exists x. split; [simpl; auto|]. intros w [<- | j]; [lra|]. specialize (h w j). lra.
    + exists z. split; [right; auto|]. intros w [<- | j]; [lra | auto].
Qed.
(** p seen along a *)
Definition flattened (v a : list R) (p : list R) : list R := plus p (times (- (dot v p / dot v a)) a).
Lemma combined_flattened : forall n v a l w, length a = n -> (forall p, In p l -> length p = n) ->
  combined n w (map (flattened v a) l) = flattened v a (combined n w l).
Proof.
  intros n v a l. induction l as [|p l IH]; intros w la ll.
  - assert (e : combined n w [] = repeat 0 n) by (destruct w; auto). simpl map. rewrite e. unfold flattened.
    rewrite dot_zeros. unfold Rdiv. rewrite Rmult_0_l, Ropp_0, plus_nothing; auto.
  - destruct w as [|b w].
    + simpl. unfold flattened. rewrite dot_zeros. unfold Rdiv. rewrite Rmult_0_l, Ropp_0, plus_nothing; auto.
    + assert (lp := ll p ltac:(simpl; auto)). assert (lc := combined_length n l w ltac:(intros; apply ll; simpl; auto)).
      simpl. rewrite IH by (auto; intros; apply ll; simpl; auto). unfold flattened.
      assert (e : dot v (plus (times b p) (combined n w l)) = b * dot v p + dot v (combined n w l))
        by (rewrite dot_plus, dot_times; auto; rewrite times_length; congruence).
      rewrite e. replace (- ((b * dot v p + dot v (combined n w l)) / dot v a)) with
        (b * - (dot v p / dot v a) + - (dot v (combined n w l) / dot v a)) by (unfold Rdiv; ring).
      generalize (- (dot v p / dot v a)) (- (dot v (combined n w l) / dot v a)). intros s t.
      clear - lp lc la. revert lc. generalize (combined n w l). intros c lc. revert n p c la lp lc. unfold times.
      induction a as [|a0 a IH]; intros n [|p0 p] [|c0 c] la lp lc; simpl in *; subst n; try discriminate; auto.
      rewrite (IH (length a) p c) by (auto; lia). f_equal. ring.
Qed.
Lemma dot_combined_sign : forall n v l w, (forall p, In p l -> length p = n) -> (forall a, In a w -> 0 <= a) ->
  (forall p, In p l -> dot v p <= 0) -> dot v (combined n w l) <= 0.
Proof.
  induction l as [|p l IH]; intros [|a w] ll pos h; try (simpl; rewrite dot_zeros; lra).
  rewrite dot_combined by auto.
  assert (i := IH w ltac:(intros; apply ll; simpl; auto) ltac:(intros; apply pos; simpl; auto)
    ltac:(intros; apply h; simpl; auto)).
  assert (0 <= a * - dot v p).
  { apply Rmult_le_pos; [apply pos; simpl; auto|]. assert (q := h p ltac:(simpl; auto)). lra. }
  lra.
Qed.
Lemma farkas : forall n k l b, length l = k -> (forall p, In p l -> length p = n) -> length b = n ->
  (exists w, length w = length l /\ (forall a, In a w -> 0 <= a) /\ b = combined n w l) \/
  (exists v, length v = n /\ (forall p, In p l -> dot v p <= 0) /\ 0 < dot v b).
Proof.
  intros n k. induction k as [|k IH]; intros [|a l] b lk ll lb; try discriminate.
  - destruct (Req_dec (dot b b) 0) as [z | nz].
    + left. exists []. split; [auto|]. split; [intros ? []|]. apply zero_of_square in z. rewrite lb in z. exact z.
    + right. exists b. assert (g := dot_self b). split; [auto|]. split; [intros ? []|]. lra.
  - assert (la := ll a ltac:(simpl; auto)). assert (ll' : forall p, In p l -> length p = n) by (intros; apply ll; simpl;
      auto).
    destruct (IH l b ltac:(simpl in lk; lia) ll' lb) as [(w & lw & pos & e) | (v & lv & h & hb)].
    { left. exists (0 :: w). split; [simpl; congruence|]. split; [intros c [<- | i]; [lra | auto]|].
      simpl. rewrite <- e. clear - la lb. revert n b la lb. unfold times.
      induction a as [|a0 a IH]; intros n [|b0 b] la lb; simpl in *; subst n; try discriminate; auto.
      rewrite <- (IH (length a) b) by (auto; lia). f_equal. ring. }
    destruct (Rle_lt_dec (dot v a) 0) as [na | pa].
    { right. exists v. split; [auto|]. split; [intros p [<- | i]; auto | auto]. }
    assert (lf : forall p, length p = n -> length (flattened v a p) = n).
    { intros p lp. unfold flattened. rewrite plus_length; rewrite times_length; congruence. }
    assert (lf' : forall p, In p (map (flattened v a) l) -> length p = n).
    { intros p i. apply in_map_iff in i. destruct i as (q & <- & i). auto. }
    assert (lk' : length (map (flattened v a) l) = k) by (rewrite map_length; simpl in lk; lia).
    destruct (IH _ (flattened v a b) lk' lf' (lf b lb)) as [(w & lw & pos & e) | (u & lu & g & gb)].
    + left. rewrite map_length in lw. rewrite combined_flattened in e by auto.
      assert (s := dot_combined_sign n v l w ll' pos h). assert (lc := combined_length n l w ll').
      exists ((dot v b / dot v a - dot v (combined n w l) / dot v a) :: w). split; [simpl; congruence|]. split.
      * intros c [<- | i]; auto.
        replace (dot v b / dot v a - dot v (combined n w l) / dot v a) with
          ((dot v b - dot v (combined n w l)) * / dot v a) by (unfold Rdiv; ring).
        apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; auto].
      * simpl. unfold flattened in e. revert e. generalize (dot v b / dot v a) (dot v (combined n w l) / dot v a).
        intros s0 t0 e. clear - e la lb lc. revert lc e. generalize (combined n w l). intros c lc e.
        revert n b c la lb lc e. unfold times.
        induction a as [|a0 a IH]; intros n [|b0 b] [|c0 c] la lb lc e; simpl in *; subst n; try discriminate; auto.
        injection e; intros e' e0. rewrite <- (IH (length a) b c) by (auto; lia). f_equal. lra.
    + right. exists (plus u (times (- (dot u a / dot v a)) v)).
      assert (luv : length u = length (times (- (dot u a / dot v a)) v)) by (rewrite times_length; congruence).
      assert (same : forall p, length p = n ->
        dot (plus u (times (- (dot u a / dot v a)) v)) p = dot u (flattened v a p)).
      { intros p lp. unfold flattened. rewrite plus_dot, times_dot, dot_plus, dot_times by
          (rewrite ?times_length; congruence). unfold Rdiv. ring. }
      split; [rewrite plus_length, times_length; congruence|]. split.
      * intros p [<- | i].
        -- rewrite plus_dot, times_dot by auto. replace (- (dot u a / dot v a) * dot v a) with (- dot u a)
             by (field; lra). lra.
        -- rewrite same by auto. apply g. apply in_map; auto.
      * rewrite same by auto. exact gb.
Qed.

Lemma combined_lifted : forall n l w, length w = length l ->
  combined (S n) w (map (cons 1) l) = fold_right Rplus 0 w :: combined n w l.
Proof.
  intros n. induction l as [|p l IH]; intros [|a w] e; simpl in *; try discriminate; auto.
  rewrite IH by lia. simpl. f_equal. ring.
Qed.
(** What is outside of the hull is in front of a plane. *)
Theorem separated : forall n l y, (forall p, In p l -> length p = n) -> length y = n ->
  hull n l y \/ exists m, length m = n /\ forall p, In p l -> dot m p < dot m y.
Proof.
  intros n l y ll ly.
  assert (ll' : forall p, In p (map (cons 1) l) -> length p = S n).
  { intros p i. apply in_map_iff in i. destruct i as (q & <- & i). simpl. f_equal; auto. }
  destruct (farkas (S n) (length l) (map (cons 1) l) (1 :: y) (map_length _ _) ll' ltac:(simpl; f_equal; auto))
    as [(w & lw & pos & e) | (v & lv & h & hy)].
  - left. rewrite map_length in lw. rewrite combined_lifted in e by auto. injection e; intros e' one.
    exists w. split; [auto|]. split; [auto|]. split; auto.
  - right. destruct v as [|c m]; [discriminate|]. exists m. split; [simpl in lv; lia|]. intros p i.
    assert (g := h (1 :: p) ltac:(apply in_map; auto)). simpl in g, hy. lra.
Qed.
(** What is between some of the points is between all of them. *)
Lemma hull_of_some : forall n some l x, (forall p, In p l -> length p = n) -> (forall p, In p some -> In p l) ->
  hull n some x -> hull n l x.
Proof.
  intros n some l x ll sub h. assert (ls : forall p, In p some -> length p = n) by auto.
  assert (lx := hull_length n some x ls h). destruct (separated n l x ll lx) as [|(m & lm & g)]; auto. exfalso.
  destruct some as [|p some].
  - destruct h as ([|a w] & lw & _ & one & _); [simpl in one; lra | discriminate].
  - destruct (greatest_of (dot m) (p :: some) ltac:(discriminate)) as (q & i & above).
    assert (k := hull_above n (p :: some) (times (-1) m) (- dot m q) x ls h).
    assert (k' := k ltac:(intros r j; rewrite times_dot; specialize (above r j); lra)).
    rewrite times_dot in k'. assert (l' := g q (sub q i)). lra.
Qed.
