(* SPDX-License-Identifier: Apache-2.0 *)
(* The separating axis theorem of boxes with any half axes: where no cross product of two of their edges separates
  them,
   they have a common interior point. Over lists of edges, three of which are independent: edges are eliminated one
   after the other, which is a question of intervals that meet in pairs. *)
From Coq Require Import Reals Lra Lia Psatz List.
Import ListNotations.
Open Scope R_scope.

Record vector := Vector { vx : R; vy : R; vz : R }.
Definition origin := Vector 0 0 0.
Definition dot a b := vx a * vx b + vy a * vy b + vz a * vz b.
Definition cross a b :=
  Vector (vy a * vz b - vz a * vy b) (vz a * vx b - vx a * vz b) (vx a * vy b - vy a * vx b).
Definition less a r g := Vector (vx a - r * vx g) (vy a - r * vy g) (vz a - r * vz g).
Definition mix r a s b := Vector (r * vx a - s * vx b) (r * vy a - s * vy b) (r * vz a - s * vz b).
Ltac coordinates := unfold dot, cross, less, mix, origin; simpl; ring.

(* d is a sum of the edges, each times a number between -1 and 1; and how far such sums lead along n. *)
Fixpoint reaches (l : list vector) d := match l with
  | [] => d = origin
  | g :: l' => exists r, Rabs r < 1 /\ reaches l' (less d r g) end.
Fixpoint width (l : list vector) n := match l with [] => 0 | g :: l' => Rabs (dot n g) + width l' n end.
Definition within l d w := Rabs (dot w d) < width l w \/ (width l w = 0 /\ dot w d = 0).

Lemma dot_less w d r g : dot w (less d r g) = dot w d - r * dot w g. Proof. coordinates. Qed.
Lemma dot_mix r a s b d : dot (mix r a s b) d = r * dot a d - s * dot b d. Proof. coordinates. Qed.
Lemma less_none d g : less d 0 g = d.
Proof. destruct d. unfold less. simpl. f_equal; ring. Qed.
Lemma less_swapped d r g s h : less (less d r g) s h = less (less d s h) r g.
Proof. unfold less. simpl. f_equal; ring. Qed.
Lemma width_pos l n : 0 <= width l n.
Proof. induction l as [|g l IH]; simpl; [lra|]. pose proof (Rabs_pos (dot n g)). lra. Qed.
Lemma width_app l m n : width (l ++ m) n = width l n + width m n.
Proof. induction l as [|g l IH]; simpl; [ring|]. rewrite IH. ring. Qed.
Lemma width_some l n g : In g l -> dot n g <> 0 -> 0 < width l n.
Proof.
intros I N. apply Rabs_pos_lt in N. induction l as [|h l IH]; [destruct I|]. simpl. pose proof (width_pos l n).
pose proof (Rabs_pos (dot n h)). destruct I as [->|I]; [lra|]. specialize (IH I). lra.
Qed.
Lemma width_mix l r a s b : width l (mix r a s b) <= Rabs r * width l a + Rabs s * width l b.
Proof.
induction l as [|g l IH]; simpl; [lra|]. rewrite dot_mix. unfold Rminus at 1.
pose proof (Rabs_triang (r * dot a g) (- (s * dot b g))) as T. rewrite Rabs_Ropp, !Rabs_mult in T. lra.
Qed.
Lemma within_mix l d r a : Rabs (dot a d) < width l a -> within l d (mix r a 0 a).
Proof.
intros A. assert (W : forall m, width m (mix r a 0 a) = Rabs r * width m a).
{ induction m as [|g m IH]; simpl; [ring|]. rewrite IH, dot_mix.
  replace (r * dot a g - 0 * dot a g) with (r * dot a g)
    by ring. rewrite Rabs_mult. ring. }
unfold within. rewrite W, dot_mix. replace (r * dot a d - 0 * dot a d) with (r * dot a d) by ring.
destruct (Req_dec r 0) as [->|N].
- right. rewrite Rabs_R0. split; ring.
- left. rewrite Rabs_mult. apply Rmult_lt_compat_l; [now apply Rabs_pos_lt|exact A].
Qed.
Lemma reaches_within l : forall d w, reaches l d -> within l d w.
Proof.
induction l as [|g l IH]; simpl; intros d w R.
- right. simpl. subst d. split; [reflexivity|coordinates].
- destruct R as (r & L & R). specialize (IH _ w R). unfold within in *. simpl. rewrite dot_less in IH.
  set (x := dot w d) in *. set (y := dot w g) in *. pose proof (Rabs_pos y). pose proof (Rabs_pos r).
  assert (B : Rabs (r * y) <= Rabs y) by (rewrite Rabs_mult; nra).
  assert (T : Rabs x <= Rabs (x - r * y) + Rabs (r * y)).
  { replace x with (x - r * y + r * y) at 1 by ring. apply Rabs_triang. }
  destruct IH as [S|[Z E]]; [left; lra|]. rewrite Z. rewrite E, Rabs_R0 in T.
  destruct (Req_dec y 0) as [Y|Y].
  + right. rewrite Y, Rabs_R0 in *. split; [ring|lra].
  + left. apply Rabs_pos_lt in Y. assert (Rabs (r * y) < Rabs y) by (rewrite Rabs_mult; nra). lra.
Qed.

(* Intervals that meet in pairs have a common point. *)
Lemma extremes (p0 : R * R) l : exists p q, In p (p0 :: l) /\ In q (p0 :: l) /\
  forall x, In x (p0 :: l) -> fst x <= fst p /\ snd q <= snd x.
Proof.
induction l as [|a l (p & q & P & Q & B)].
- exists p0, p0. split; [now left|]. split; [now left|]. intros x [<-|[]]. lra.
- assert (I : forall x, In x (p0 :: l) -> In x (p0 :: a :: l)) by (intros x [X|X]; [now left|right; now right]).
  exists (if Rle_dec (fst a) (fst p) then p else a), (if Rle_dec (snd q) (snd a) then q else a).
  split; [destruct (Rle_dec (fst a) (fst p)); [now apply I|right; now left]|].
  split; [destruct (Rle_dec (snd q) (snd a)); [now apply I|right; now left]|].
  intros x X. assert (W : x = a \/ In x (p0 :: l)).
  { destruct X as [X|[X|X]]; [right; now left|left; now symmetry|right; now right]. }
  destruct W as [->|W].
  + destruct (Rle_dec (fst a) (fst p)), (Rle_dec (snd q) (snd a)); lra.
  + destruct (B x W). destruct (Rle_dec (fst a) (fst p)), (Rle_dec (snd q) (snd a)); lra.
Qed.
Lemma common_point (l : list (R * R)) : (forall p q, In p l -> In q l -> fst p < snd q) ->
  exists r, forall p, In p l -> fst p < r < snd p.
Proof.
destruct l as [|p0 l]; intros H; [exists 0; intros p []|]. destruct (extremes p0 l) as (p & q & P & Q & B).
specialize (H p q P Q). exists ((fst p + snd q) / 2). intros x X. destruct (B x X). lra.
Qed.

(* One edge g less: a number r for it that leaves d - r g within all widths along the normals N. *)
Definition interval l g d n := let k := dot n g in if Req_EM_T k 0 then (-1, 1) else
  (dot n d / k - width l n / Rabs k, dot n d / k + width l n / Rabs k).
Lemma interval_says l g d n : n = origin \/ 0 < width l n -> (dot n g = 0 /\ interval l g d n = (-1, 1)) \/
  exists a u, dot n g <> 0 /\ dot n d = a * dot n g /\ width l n = u * Rabs (dot n g) /\ 0 < u /\
    interval l g d n = (a - u, a + u).
Proof.
intros W. unfold interval. cbv zeta. destruct (Req_EM_T (dot n g) 0) as [Z|Z]; [left; auto|right].
pose proof (Rabs_pos_lt _ Z) as P. assert (K : Rabs (dot n g) <> 0) by now apply Rabs_no_R0.
assert (W' : 0 < width l n). { destruct W as [->|W]; [|exact W]. exfalso. apply Z. coordinates. }
exists (dot n d / dot n g), (width l n / Rabs (dot n g)).
split; [exact Z|]. split; [field; exact Z|]. split; [field; exact K|].
  split; [now apply Rdiv_lt_0_compat|reflexivity].
Qed.
Lemma one_less N g l d : (forall n, In n N -> n = origin \/ Rabs (dot n d) < Rabs (dot n g) + width l n) ->
  (forall n, In n N -> n = origin \/ 0 < width l n) ->
  (forall n m a b, In n N -> In m N -> dot (mix a n b m) g = 0 -> within l d (mix a n b m)) ->
  exists r, Rabs r < 1 /\ forall n, In n N -> n = origin \/ Rabs (dot n (less d r g)) < width l n.
Proof.
intros A P W.
assert (U : forall n, In n N -> fst (interval l g d n) < 1 /\ -1 < snd (interval l g d n)).
{ intros n I. destruct (interval_says l g d n (P n I)) as [[_ ->]|(a & u & Z & D & E & U & ->)];
    cbn [fst snd]; [lra|]. destruct (A n I) as [->|L]; [exfalso; apply Z; coordinates|].
  rewrite D, E, Rabs_mult in L. pose proof (Rabs_pos_lt _ Z) as K.
  assert (B : Rabs a < 1 + u) by (apply Rmult_lt_reg_r with (1 := K); lra). apply Rabs_def2 in B. lra. }
destruct (common_point ((-1, 1) :: map (interval l g d) N)) as (r & R).
- intros p q [<-|I] [<-|J].
  + cbn [fst snd]. lra.
  + apply in_map_iff in J as (m & <- & J). exact (proj2 (U m J)).
  + apply in_map_iff in I as (n & <- & I). exact (proj1 (U n I)).
  + apply in_map_iff in I as (n & <- & I). apply in_map_iff in J as (m & <- & J).
    destruct (U n I) as [U1 _]. destruct (U m J) as [_ U2].
    destruct (interval_says l g d n (P n I)) as [[_ E1]|(a & u & Z & D & E & V & E1)]; rewrite E1 in U1 |- *;
      [exact U2|].
    destruct (interval_says l g d m (P m J)) as [[_ E2]|(b & w & Z' & D' & E' & V' & E2)]; rewrite E2 in U2 |- *;
      [exact U1|]. cbn [fst snd]. clear E1 E2 U1 U2.
    specialize (W n m (dot m g) (dot n g) I J ltac:(rewrite dot_mix; ring)).
    pose proof (width_mix l (dot m g) n (dot n g) m) as B. unfold within in W. rewrite dot_mix, D, D' in W.
    rewrite E, E' in B. set (k := dot n g) in *. set (h := dot m g) in *. clearbody k h.
    pose proof (Rabs_pos_lt _ Z) as K. pose proof (Rabs_pos_lt _ Z') as H.
    replace (h * (a * k) - k * (b * h)) with (h * k * (a - b)) in W by ring.
    destruct W as [S|[_ S]].
    * assert (L : Rabs (a - b) < u + w); [|apply Rabs_def2 in L; lra].
      apply Rmult_lt_reg_l with (Rabs h * Rabs k); [now apply Rmult_lt_0_compat|].
      rewrite !Rabs_mult in S. lra.
    * apply Rmult_integral in S as [S|S]; [apply Rmult_integral in S as [S|S]; contradiction|lra].
- exists r. split; [destruct (R (-1, 1) ltac:(now left)) as [R1 R2]; cbn [fst snd] in *; apply Rabs_def1; lra|].
  intros n I. specialize (R (interval l g d n) ltac:(right; now apply in_map)). rewrite dot_less.
  destruct (interval_says l g d n (P n I)) as [[Z _]|(a & u & Z & D & E & U' & E1)].
  + destruct (A n I) as [->|L]; [now left|right]. rewrite Z, Rabs_R0 in *. replace (dot n d - r * 0) with (dot n d)
      by ring. lra.
  + right. rewrite E1 in R. cbn [fst snd] in R. rewrite D, E. replace (a * dot n g - r * dot n g) with
      ((a - r) * dot n g) by ring. rewrite Rabs_mult. apply Rmult_lt_compat_r; [now apply Rabs_pos_lt|].
    apply Rabs_def1; lra.
Qed.

(* Vectors and their products. *)
Lemma independent a b c n : dot a (cross b c) <> 0 -> dot n a = 0 -> dot n b = 0 -> dot n c = 0 -> n = origin.
Proof.
intros D A B C. destruct n as [x y z]. unfold origin.
assert (E : forall p q r, p * dot (Vector x y z) a + q * dot (Vector x y z) b + r * dot (Vector x y z) c = 0).
{ intros. rewrite A, B, C. ring. }
f_equal; apply Rmult_eq_reg_l with (2 := D); rewrite Rmult_0_r.
- rewrite <- (E (vx (cross b c)) (vx (cross c a)) (vx (cross a b))). coordinates.
- rewrite <- (E (vy (cross b c)) (vy (cross c a)) (vy (cross a b))). coordinates.
- rewrite <- (E (vz (cross b c)) (vz (cross c a)) (vz (cross a b))). coordinates.
Qed.
Lemma dot_self u : u <> origin -> dot u u <> 0.
Proof.
intros N E. apply N. destruct u as [x y z]. unfold dot in E. simpl in E. unfold origin. f_equal; nra.
Qed.
(* What is across both g and h is a multiple of their product. *)
Lemma across g h w : cross g h <> origin -> dot w g = 0 -> dot w h = 0 ->
  exists c, w = mix c (cross g h) 0 (cross g h).
Proof.
intros N G H. set (u := cross g h) in *. pose proof (dot_self u N) as K. exists (dot w u / dot u u).
assert (X : cross u w = origin).
{ unfold u. replace (cross (cross g h) w) with (mix (dot w g) h (dot w h) g)
    by (unfold cross, mix, dot; simpl; f_equal; ring).
  rewrite G, H. unfold mix, origin. f_equal; ring. }
clearbody u. destruct w as [x y z]. destruct u as [p q r]. unfold cross, origin in X. simpl in X.
  injection X as X1 X2 X3.
unfold mix, dot in *. simpl in *. set (s := p * p + q * q + r * r) in *. set (t := x * p + y * q + z * r).
assert (F : forall a b, t * a = s * b -> b = t / s * a - 0 * a).
{ intros a b E. replace (t / s * a) with (t * a / s) by (field; exact K). rewrite E. field. exact K. }
unfold t, s in F. f_equal; apply F; apply Rminus_diag_uniq.
- replace (_ - _) with (q * (p * y - q * x) - r * (r * x - p * z)) by ring. rewrite X2, X3. ring.
- replace (_ - _) with (r * (q * z - r * y) - p * (p * y - q * x)) by ring. rewrite X1, X3. ring.
- replace (_ - _) with (p * (r * x - p * z) - q * (q * z - r * y)) by ring. rewrite X1, X2. ring.
Qed.
Lemma opposite a b : cross a b = origin -> cross b a = origin.
Proof. unfold cross, origin. intros E. injection E as E1 E2 E3. f_equal; lra. Qed.
Lemma triple_turned a b c : dot a (cross b c) = dot b (cross c a). Proof. coordinates. Qed.
Lemma across_first g h : dot (cross g h) g = 0. Proof. coordinates. Qed.
Lemma across_second g h : dot (cross g h) h = 0. Proof. coordinates. Qed.
Lemma triple_swapped g k h : dot (cross g k) h = - dot (cross g h) k. Proof. coordinates. Qed.

(* Seen along g. *)
Lemma in_plane g rest a b : dot g (cross a b) <> 0 -> forall d,
  (forall k, In k (rest ++ [a; b]) -> cross g k = origin \/
    Rabs (dot (cross g k) d) < width (rest ++ [a; b]) (cross g k)) ->
  exists t, reaches (rest ++ [a; b]) (less d t g).
Proof.
intros D. induction rest as [|h l IH]; intros d H.
- cbn [app] in *. assert (DA : Rabs (dot d (cross g a)) < Rabs (dot g (cross a b))).
  { destruct (H a ltac:(now left)) as [Z|L].
    - exfalso. apply D. replace (dot g (cross a b)) with (dot (cross g a) b) by coordinates. rewrite Z. coordinates.
    - cbn [width] in L. rewrite across_second, Rabs_R0 in L.
      replace (dot (cross g a) b) with (dot g (cross a b)) in L by coordinates.
      replace (dot d (cross g a)) with (dot (cross g a) d) by coordinates. lra. }
  assert (DB : Rabs (dot d (cross b g)) < Rabs (dot g (cross a b))).
  { destruct (H b ltac:(right; now left)) as [Z|L].
    - exfalso. apply D. replace (dot g (cross a b)) with (- dot (cross g b) a) by coordinates. rewrite Z. coordinates.
    - cbn [width] in L. rewrite across_second, Rabs_R0 in L.
      replace (dot (cross g b) a) with (- dot g (cross a b)) in L by coordinates. rewrite Rabs_Ropp in L.
      replace (dot d (cross b g)) with (- dot (cross g b) d) by coordinates. rewrite Rabs_Ropp. lra. }
  set (V := dot g (cross a b)) in *. pose proof (Rabs_pos_lt _ D) as P.
  assert (Q : forall x, Rabs x < Rabs V -> Rabs (x / V) < 1).
  { intros x X. apply Rmult_lt_reg_r with (1 := P). rewrite <- Rabs_mult.
    replace (x / V * V) with x by (field; exact D).
    lra. }
  exists (dot d (cross a b) / V). cbn [reaches].
  exists (dot d (cross b g) / V). split; [now apply Q|]. exists (dot d (cross g a) / V). split; [now apply Q|].
  unfold less, origin. simpl. f_equal; apply Rmult_eq_reg_r with (2 := D); rewrite Rmult_0_l; unfold V;
    unfold V in D; unfold dot, cross in *; simpl in *; field; intros E; apply D; lra.
- cbn [app] in *. set (m := l ++ [a; b]) in *.
  assert (M : In a m /\ In b m) by (unfold m; split; apply in_or_app; right; [now left|right; now left]).
  destruct (Req_EM_T (dot (cross g h) (cross g h)) 0) as [Z|Z].
  + assert (O : cross g h = origin).
    { destruct (cross g h) as [x y z]. unfold dot in Z. simpl in Z. unfold origin. f_equal; nra. }
    destruct (IH d) as (t & T).
    * intros k K. destruct (H k ltac:(now right)) as [E|L]; [now left|right]. cbn [width] in L.
      rewrite (triple_swapped g k h), O in L. replace (dot origin k) with 0 in L by coordinates.
      rewrite Ropp_0, Rabs_R0 in L. lra.
    * exists t. cbn [reaches]. exists 0. rewrite Rabs_R0, less_none. split; [lra|exact T].
  + assert (O : cross g h <> origin) by (intros E; apply Z; rewrite E; coordinates).
    destruct (one_less (map (cross g) m) h m d) as (r & R & L).
    * intros n I. apply in_map_iff in I as (k & <- & I). exact (H k ltac:(now right)).
    * intros n I. apply in_map_iff in I as (k & <- & I).
      destruct (Req_dec (dot (cross g k) a) 0) as [A|A]; [|right; exact (width_some _ _ a (proj1 M) A)].
      destruct (Req_dec (dot (cross g k) b) 0) as [B|B]; [|right; exact (width_some _ _ b (proj2 M) B)].
      left. exact (independent g a b _ D (across_first g k) A B).
    * intros n k r s I J E. apply in_map_iff in I as (i & <- & I). apply in_map_iff in J as (j & <- & J).
      assert (G : dot (mix r (cross g i) s (cross g j)) g = 0) by (rewrite dot_mix, !across_first; ring).
      destruct (across g h _ O G E) as (c & ->). apply within_mix.
      destruct (H h ltac:(now left)) as [E1|L]; [contradiction|]. cbn [width] in L.
      rewrite across_second, Rabs_R0 in L. lra.
    * destruct (IH (less d r h)) as (t & T).
      { intros k K. apply L. now apply in_map. }
      exists t. cbn [reaches]. exists r. split; [exact R|]. now rewrite less_swapped.
Qed.
Lemma beside h l rest a b d w : dot h (cross a b) <> 0 -> (forall n, width (rest ++ [a; b]) n = width l n) ->
  (forall k, In k (rest ++ [a; b]) -> In k l) ->
  (forall k, In k l -> cross h k = origin \/ Rabs (dot (cross h k) d) < width l (cross h k)) ->
  dot w h = 0 -> within l d w.
Proof.
intros D E I H Z. destruct (in_plane h rest a b D d) as (t & T).
- intros k K. rewrite E. auto.
- pose proof (reaches_within _ _ w T) as S. unfold within in *. rewrite E, dot_less, Z in S.
  replace (dot w d - t * 0) with (dot w d) in S by ring. exact S.
Qed.

Theorem in_space rest a b c : dot a (cross b c) <> 0 -> forall d,
  (forall i j, In i (rest ++ [a; b; c]) -> In j (rest ++ [a; b; c]) -> cross i j = origin \/
    Rabs (dot (cross i j) d) < width (rest ++ [a; b; c]) (cross i j)) ->
  reaches (rest ++ [a; b; c]) d.
Proof.
intros D. induction rest as [|h l IH]; intros d H.
- cbn [app] in *. set (V := dot a (cross b c)) in *. pose proof (Rabs_pos_lt _ D) as P.
  assert (Q : forall x, Rabs x < Rabs V -> Rabs (x / V) < 1).
  { intros x X. apply Rmult_lt_reg_r with (1 := P). rewrite <- Rabs_mult.
    replace (x / V * V) with x by (field; exact D).
    lra. }
  assert (K : forall i j k, dot k (cross i j) = V -> In i [a; b; c] -> In j [a; b; c] ->
    width [a; b; c] (cross i j) = Rabs V -> Rabs (dot d (cross i j) / V) < 1).
  { intros i j k E I J W. apply Q. destruct (H i j I J) as [Z|L].
    - exfalso. apply D. rewrite <- E, Z. coordinates.
    - rewrite W in L. now replace (dot d (cross i j)) with (dot (cross i j) d) by coordinates. }
  exists (dot d (cross b c) / V). split.
  { apply (K b c a); [reflexivity|right; now left|right; right; now left|]. cbn [width].
    rewrite across_first, across_second. replace (dot (cross b c) a) with V by (unfold V; coordinates).
    rewrite Rabs_R0. ring. }
  exists (dot d (cross c a) / V). split.
  { apply (K c a b); [unfold V; coordinates|right; right; now left|now left|]. cbn [width].
    rewrite across_first, across_second. replace (dot (cross c a) b) with V by (unfold V; coordinates).
    rewrite Rabs_R0. ring. }
  exists (dot d (cross a b) / V). split.
  { apply (K a b c); [unfold V; coordinates|now left|right; now left|]. cbn [width].
    rewrite across_first, across_second. replace (dot (cross a b) c) with V by (unfold V; coordinates).
    rewrite Rabs_R0. ring. }
  unfold reaches, less, origin. simpl. f_equal; apply Rmult_eq_reg_r with (2 := D); rewrite Rmult_0_l; unfold V;
    unfold V in D; unfold dot, cross in *; simpl in *; field; intros E; apply D; lra.
- cbn [app] in *. set (m := l ++ [a; b; c]) in *.
  assert (M : In a m /\ In b m /\ In c m).
  { unfold m. split; [|split]; apply in_or_app; right; [now left|right; now left|right; right; now left]. }
  destruct (Req_EM_T (dot h h) 0) as [Z|Z].
  + assert (O : h = origin).
    { destruct h as [x y z]. unfold dot in Z. simpl in Z. unfold origin. f_equal; nra. }
    cbn [reaches]. exists 0. rewrite Rabs_R0, less_none. split; [lra|]. apply IH. intros i j I J.
    destruct (H i j ltac:(now right) ltac:(now right)) as [E|L]; [now left|right]. cbn [width] in L.
    replace (dot (cross i j) h) with 0 in L by (rewrite O; coordinates). rewrite Rabs_R0 in L. lra.
  + assert (O : h <> origin) by (intros E; apply Z; rewrite E; coordinates).
    destruct (one_less (flat_map (fun i => map (cross i) m) m) h m d) as (r & R & L).
    * intros n I. apply in_flat_map in I as (i & I & J). apply in_map_iff in J as (j & <- & J).
      exact (H i j ltac:(now right) ltac:(now right)).
    * intros n _. destruct M as (MA & MB & MC).
      destruct (Req_dec (dot n a) 0) as [A|A]; [|right; exact (width_some _ _ a MA A)].
      destruct (Req_dec (dot n b) 0) as [B|B]; [|right; exact (width_some _ _ b MB B)].
      destruct (Req_dec (dot n c) 0) as [C|C]; [|right; exact (width_some _ _ c MC C)].
      left. exact (independent a b c n D A B C).
    * intros n k r s _ _ E.
      assert (HH : forall j, In j m -> cross h j = origin \/ Rabs (dot (cross h j) d) < width m (cross h j)).
      { intros j J. destruct (H h j ltac:(now left) ltac:(now right)) as [X|X]; [now left|right]. cbn [width] in X.
        rewrite across_first, Rabs_R0 in X. lra. }
      assert (NI : forall q, q = a \/ q = b \/ q = c \/ In q l -> In q m).
      { intros q [->|[->|[->|I]]]; try apply M. unfold m. apply in_or_app. now left. }
      destruct (Req_dec (dot h (cross a b)) 0) as [AB|AB].
      2:{ apply (beside h m (c :: l) a b); try assumption.
          - intros q. unfold m. cbn [app width]. rewrite !width_app. simpl. ring.
          - intros q [<-|I]; [apply NI; auto|]. apply NI. apply in_app_or in I as [I|[I|[I|[]]]]; auto. }
      destruct (Req_dec (dot h (cross b c)) 0) as [BC|BC].
      2:{ apply (beside h m (a :: l) b c); try assumption.
          - intros q. unfold m. cbn [app width]. rewrite !width_app. simpl. ring.
          - intros q [<-|I]; [apply NI; auto|]. apply NI. apply in_app_or in I as [I|[I|[I|[]]]]; auto. }
      destruct (Req_dec (dot h (cross c a)) 0) as [CA|CA].
      2:{ apply (beside h m (b :: l) c a); try assumption.
          - intros q. unfold m. cbn [app width]. rewrite !width_app. simpl. ring.
          - intros q [<-|I]; [apply NI; auto|]. apply NI. apply in_app_or in I as [I|[I|[I|[]]]]; auto. }
      exfalso. apply O. apply (independent (cross a b) (cross b c) (cross c a)); try assumption.
      replace (dot (cross a b) (cross (cross b c) (cross c a))) with (dot a (cross b c) * dot a (cross b c))
        by coordinates. now apply Rmult_integral_contrapositive_currified.
    * cbn [reaches]. exists r. split; [exact R|]. apply IH. intros i j I J. apply L. apply in_flat_map.
      exists i. split; [exact I|]. now apply in_map.
Qed.

(* The sum as numbers, one for each edge. *)
Fixpoint total (l : list vector) (r : nat -> R) := match l with
  | [] => origin
  | g :: l' => mix 1 (total l' (fun k => r (S k))) (- r 0%nat) g end.
Lemma reaches_total l : forall d, reaches l d -> exists r, (forall k, Rabs (r k) < 1) /\ d = total l r.
Proof.
induction l as [|g l IH]; cbn [reaches]; intros d R.
- exists (fun _ => 0). split; [intros _; rewrite Rabs_R0; lra|exact R].
- destruct R as (s & S & R). destruct (IH _ R) as (r & B & E).
  exists (fun k => match k with O => s | Datatypes.S k => r k end). split; [now intros [|k]|].
  change (d = mix 1 (total l r) (- s) g). rewrite <- E. destruct d. unfold mix, less. simpl. f_equal; ring.
Qed.

(* What is in a box: center + r u + s v + t w, the numbers r, s, t being between -1 and 1. *)
Definition in_box (between : R -> Prop) (cx cy cz ux uy uz vx vy vz wx wy wz px py pz : R) := exists r s t,
  between r /\ between s /\ between t /\ px = cx + r * ux + s * vx + t * wx /\ py = cy + r * uy + s * vy + t * wy /\
  pz = cz + r * uz + s * vz + t * wz.
Definition at_most_1 r := Rabs r <= 1.
Definition less_than_1 r := Rabs r < 1.
Definition volume ux uy uz vx vy vz wx wy wz := dot (Vector ux uy uz) (cross (Vector vx vy vz) (Vector wx wy wz)).
