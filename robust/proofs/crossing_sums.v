(* SPDX-License-Identifier: Apache-2.0 *)
(* The sums of robust/polygons/point_in_polygon.cpp, of any number of edges. filters.v says what one lane adds, and what
   is answered of two; which edges they add, from the point's differences to the vertices, is said here. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool List.
From Filters Require Import model constants filters steps ghost tactics choices.
Import ListNotations.
Open Scope R_scope.

(* a vertex, and as it is seen from the point: its x, its y and the sign bit of that *)
Record corner := { vx : R; vy : R; cx : R; cy : R; minus : bool }.
Record lane := { sum_x : R; sum_y : R; least : R; parity : bool }.
(* of each edge what Q says of it, and the parity of those that count *)
Inductive tallied (Q : corner -> corner -> bool -> Prop) : list corner -> bool -> Prop :=
| no_edge c : tallied Q [c] false
| one_edge c d ds p f : tallied Q (d :: ds) p -> Q d c f -> tallied Q (c :: d :: ds) (xorb p f).
Lemma tallied_impl (Q Q' : corner -> corner -> bool -> Prop) ds p : (forall d c f, Q d c f -> Q' d c f) ->
  tallied Q ds p -> tallied Q' ds p.
Proof. intros I. induction 1; constructor; auto. Qed.

Section Crossings.
Variable F : format.
Hypothesis G : fits F (third F) 1 1.
Variables px py most : R.
Notation M := (growing F). Notation n := (n F). Notation u := (u F).
Definition seen c := sub M (Plain (vx c)) (Plain px) (cx c) /\ sub M (Plain (vy c)) (Plain py) (cy c) /\
  signed M (cy c) (minus c).
(* A zero has the sign bit that it has, at both of its edges. (Of two zeros with other bits the determinant is none that
   is trusted.) *)
Definition of_edge d c : machine R := {| constant := constant M; magnitude := Rabs; opposite := Ropp;
  square_root := square_root M; mul := mul M; add := add M; sub := sub M; greater := greater M;
  at_most := at_most M; choose := choose M;
  signed x b := signed M x b /\ (x = cy d -> b = minus d) /\ (x = cy c -> b = minus c) |}.
Definition added a d c a' := crossings_add F R (of_edge d c) (sum_x a) (sum_y a) (least a) (cx d) (cy d) (cx c) (cy c)
  (parity a) (sum_x a') (sum_y a') (least a') (parity a').
(* The vertices, the last one first, and the lanes after their edges: each edge in one lane, or in both, of which then
   one counts it. *)
Inductive run : list corner -> lane -> lane -> Prop :=
| started c : seen c -> run [c] {| sum_x := Rabs (cx c); sum_y := Rabs (cy c); least := most; parity := false |}
    {| sum_x := 0; sum_y := 0; least := most; parity := false |}
| in_first c d ds a b a' : run (d :: ds) a b -> seen c -> added a d c a' -> run (c :: d :: ds) a' b
| in_second c d ds a b b' : run (d :: ds) a b -> seen c -> added b d c b' -> run (c :: d :: ds) a b'
| in_both c d ds a b a' b' : run (d :: ds) a b -> seen c -> added a d c a' -> added b d c b' ->
    run (c :: d :: ds) a'
      {| sum_x := sum_x b'; sum_y := sum_y b'; least := least b'; parity := parity b |}.
Definition answered a b answer :=
  crossings_location F R M (sum_x a) (sum_x b) (sum_y a) (sum_y b) (least a) (least b) (parity a) (parity b) answer.

(* sums of magnitudes *)
Definition near p q S := (1 - u) * (p + q) - 4 * n <= S \/ p + q <= 16 * n.
Definition joined p q A B := near p q A \/ near p q B \/ (below F p A /\ below F q B) \/ (below F p B /\ below F q A).
Definition inside p A B := below F p A \/ below F p B.
Lemma n0 : 0 < n. Proof. apply G. Qed.
Lemma u0 : 0 < u <= 1 / 1024. Proof. destruct G. lra. Qed.
Lemma below_nonneg p S : below F p S -> 0 <= p -> 0 <= S -> p <= S + n.
Proof. pose proof n0. unfold below. rewrite !abs_lt. lra. Qed.
Lemma near_below p q S S' : near p q S -> 0 <= p -> 0 <= q -> 0 <= S' -> below F S S' -> near p q S'.
Proof.
pose proof n0. pose proof u0. unfold near, below. rewrite !abs_lt.
intros [N|N] P Q S0 [B|B]; try (left; lra); try (right; lra).
right. assert ((1 - 1 / 1024) * (p + q) <= (1 - u) * (p + q)) by (apply Rmult_le_compat_r; lra). lra.
Qed.
Lemma joined_below p q A B A' B' : joined p q A B -> 0 <= p -> 0 <= q -> 0 <= A' -> 0 <= B' -> below F A A' ->
  below F B B' -> joined p q A' B'.
Proof.
unfold joined. intros J P Q A0 B0 X Y. destruct J as [J|[J|[[J J']|[J J']]]].
- left. now apply near_below with A.
- right. left. now apply near_below with B.
- right. right. left. split; eapply below_trans; eassumption.
- right. right. right. split; eapply below_trans; eassumption.
Qed.
Lemma inside_below p A B A' B' : inside p A B -> below F A A' -> below F B B' -> inside p A' B'.
Proof. unfold inside. intros [I|I] X Y; [left|right]; eapply below_trans; eassumption. Qed.
Lemma grow A q A' : add M (Plain A) (Plain q) A' -> 0 <= A -> 0 <= q ->
  0 <= A' /\ below F A A' /\ below F q A' /\ forall p, 0 <= p -> below F p A -> near p q A'.
Proof.
pose proof n0. pose proof u0. intros (A1 & q1 & RA & Rq & Z & Gr) A0 Q0. simpl in RA, Rq.
assert (A10 : 0 <= A1) by (destruct RA as [->|[-> _]]; lra).
assert (q10 : 0 <= q1) by (destruct Rq as [->|[-> _]]; lra).
assert (A'0 : 0 <= A') by (apply Z; lra). split; [exact A'0|].
assert (B : below F A1 A' /\ below F q1 A').
{ destruct (Gr A10 q10) as [[L1 L2]|[-> L]]; [now split; left|]. unfold below. rewrite !abs_lt. split; right; lra. }
split; [apply (below_trans F) with A1; [apply (read_below F n0), RA|apply B]|].
split; [apply (below_trans F) with q1; [apply (read_below F n0), Rq|apply B]|].
intros p P L. pose proof (below_nonneg p A L P A0) as L'. left.
destruct Z as [(e & h & E & Hh & ->) _]. apply (ratio u) in E. apply abs_le in Hh.
assert (A - n <= A1) by (destruct RA as [->|[-> RA%Rabs_def2]]; lra).
assert (q - n <= q1) by (destruct Rq as [->|[-> Rq%Rabs_def2]]; lra).
assert ((A1 + q1) * (1 - u) <= (A1 + q1) * (1 + e)) by (apply Rmult_le_compat_l; lra).
assert ((1 - u) * (p + q - 3 * n) <= (1 - u) * (A1 + q1)) by (apply Rmult_le_compat_l; lra). nra.
Qed.
Lemma all_joined p q A B S : joined p q A B -> add M (Plain A) (Plain B) S -> 0 <= A -> 0 <= B -> 0 <= p -> 0 <= q ->
  (1 - u) * (p + q) - 20 * n <= S.
Proof.
pose proof n0. pose proof u0. intros J Z A0 B0 P Q. destruct (grow _ _ _ Z A0 B0) as (S0 & BA & BB & _).
assert (N : near p q S -> (1 - u) * (p + q) - 20 * n <= S).
{ intros [N|N]; [lra|]. assert ((1 - u) * (p + q) <= 1 * (p + q)) by (apply Rmult_le_compat_r; lra). lra. }
assert (L : forall A1 B1, below F p A1 -> below F q B1 -> 0 <= A1 -> 0 <= B1 -> A1 + B1 = A + B ->
  (1 - u) * (p + q) - 20 * n <= S).
{ intros A1 B1 L1 L2 P1 P2 EQ. pose proof (below_nonneg p A1 L1 P P1). pose proof (below_nonneg q B1 L2 Q P2).
  destruct Z as (A' & B' & RA & RB & [(e & h & E & Hh & ->) _] & _). simpl in RA, RB. apply (ratio u) in E.
  apply abs_le in Hh.
  assert (A - n <= A' /\ 0 <= A') by (destruct RA as [->|[-> RA%Rabs_def2]]; lra).
  assert (B - n <= B' /\ 0 <= B') by (destruct RB as [->|[-> RB%Rabs_def2]]; lra).
  assert ((A' + B') * (1 - u) <= (A' + B') * (1 + e)) by (apply Rmult_le_compat_l; lra).
  assert ((1 - u) * (p + q - 4 * n) <= (1 - u) * (A' + B')) by (apply Rmult_le_compat_l; lra). nra. }
destruct J as [J|[J|[[J1 J2]|[J1 J2]]]].
- apply N, near_below with A; auto.
- apply N, near_below with B; auto.
- apply (L A B); auto.
- apply (L B A); auto; lra.
Qed.

(* after any number of edges *)
Definition determinant d c det := exists t t1, mul M (cx d) (cy c) t /\ mul M (cy d) (cx c) t1 /\
  sub M (Product (cx d) (cy c) t) (Product (cy d) (cx c) t1) det.
Definition grown a a' := (0 <= sum_x a' /\ 0 <= sum_y a') /\ below F (sum_x a) (sum_x a') /\
  below F (sum_y a) (sum_y a') /\ below F (least a') (least a).
(* the sign rule *)
Definition counts d c det f := exists b, signed M det b /\ f = (xorb (minus d) (minus c) && negb (xorb b (minus
  c)))%bool.
Definition bounded_edge a b d c f := seen d /\ seen c /\
  joined (Rabs (cx d)) (Rabs (cx c)) (sum_x a) (sum_x b) /\ joined (Rabs (cy d)) (Rabs (cy c)) (sum_y a) (sum_y b) /\
  (inside (Rabs (cx d)) (sum_x a) (sum_x b) /\ inside (Rabs (cx c)) (sum_x a) (sum_x b)) /\
  (inside (Rabs (cy d)) (sum_y a) (sum_y b) /\ inside (Rabs (cy c)) (sum_y a) (sum_y b)) /\
  exists det, determinant d c det /\ counts d c det f /\
    (below F (least a) (Rabs det) \/ below F (least b) (Rabs det)).
Definition head_in a b ds := match ds with
  | c :: _ => seen c /\ inside (Rabs (cx c)) (sum_x a) (sum_x b) /\ inside (Rabs (cy c)) (sum_y a) (sum_y b)
  | [] => False end.
Definition nonneg_lane a := 0 <= sum_x a /\ 0 <= sum_y a.

Lemma grown_refl a : nonneg_lane a -> grown a a.
Proof. intros P. split; [exact P|]. auto using below_refl. Qed.
Lemma bounded_grown a b a' b' d c f : grown a a' -> grown b b' -> bounded_edge a b d c f -> bounded_edge a' b' d c f.
Proof.
pose proof n0. intros ([A1 A2] & A3 & A4 & A5) ([B1 B2] & B3 & B4 & B5) (S & S' & J & J' & I & I' & det & D & C & L).
split; [exact S|]. split; [exact S'|].
split; [eapply joined_below; eauto using Rabs_pos|]. split; [eapply joined_below; eauto using Rabs_pos|].
destruct I as [I1 I2], I' as [I3 I4]. split; [split; eapply inside_below; eassumption|].
split; [split; eapply inside_below; eassumption|].
exists det. split; [exact D|]. split; [exact C|]. destruct L; [left|right]; eapply below_trans; eassumption.
Qed.
Definition taken a a' d c f := below F (Rabs (cx c)) (sum_x a') /\ below F (Rabs (cy c)) (sum_y a') /\
  (forall p, 0 <= p -> below F p (sum_x a) -> near p (Rabs (cx c)) (sum_x a')) /\
  (forall p, 0 <= p -> below F p (sum_y a) -> near p (Rabs (cy c)) (sum_y a')) /\
  exists det, determinant d c det /\ below F (least a') (Rabs det) /\ counts d c det f /\ parity a' = xorb (parity a) f.
Lemma added_grown a d c a' : added a d c a' -> nonneg_lane a -> grown a a' /\ exists f, taken a a' d c f.
Proof.
intros R [P Q]. unfold added, crossings_add in R. unpack. destruct R as (E1 & E2 & E3 & E4). unfold grown, taken.
rewrite E1, E2, E3, E4. change (greater (of_edge d c)) with (greater (reals F)) in *.
change (choose (of_edge d c)) with (choose (reals F)) in *. change (add (of_edge d c)) with (add M) in *.
cbn [magnitude of_edge] in *. destruct (lesser_right F n0 _ _ _ _ S2 S3) as (L1 & L2 & _).
destruct (grow _ _ _ S4 P (Rabs_pos _)) as (X1 & X2 & X3 & X4).
destruct (grow _ _ _ S5 Q (Rabs_pos _)) as (Y1 & Y2 & Y3 & Y4).
destruct S6 as (_ & -> & _); [|easy]. destruct S7 as (_ & _ & ->); [|easy]. destruct S9 as (_ & _ & ->); [|easy].
split; [auto|]. eexists. repeat (split; [eassumption|]). exists x1. split; [exists x, x0; auto|]. split; [exact L1|].
split; [|reflexivity]. exists x8. split; [apply S8|reflexivity].
Qed.
Lemma new_edge a b a' b' d c f : seen d -> seen c -> inside (Rabs (cx d)) (sum_x a) (sum_x b) ->
  inside (Rabs (cy d)) (sum_y a) (sum_y b) -> grown a a' -> grown b b' -> 
  taken a a' d c f \/ taken b b' d c f -> bounded_edge a' b' d c f /\ head_in a' b' (c :: [d]).
Proof.
intros Sd Sc Ix Iy (_ & GA1 & GA2 & _) (_ & GB1 & GB2 & _) T. pose proof (Rabs_pos (cx d)) as Px.
pose proof (Rabs_pos (cy d)) as Py.
pose proof (inside_below _ _ _ _ _ Ix GA1 GB1) as Jx. pose proof (inside_below _ _ _ _ _ Iy GA2 GB2) as Jy.
unfold bounded_edge, head_in. destruct T as [(X & Y & NX & NY & det & D & L & C & _)|(X & Y & NX & NY & det & D & L &
  C & _)].
- assert (Kx : inside (Rabs (cx c)) (sum_x a') (sum_x b')) by now left.
  assert (Ky : inside (Rabs (cy c)) (sum_y a') (sum_y b')) by now left.
  assert (J : joined (Rabs (cx d)) (Rabs (cx c)) (sum_x a') (sum_x b')).
  { destruct Ix as [I|I]; [left; auto|]. right. right. right. split; [eapply below_trans; eassumption|auto]. }
  assert (J' : joined (Rabs (cy d)) (Rabs (cy c)) (sum_y a') (sum_y b')).
  { destruct Iy as [I|I]; [left; auto|]. right. right. right. split; [eapply below_trans; eassumption|auto]. }
  split; [|easy]. do 6 (split; [easy|]). exists det. auto.
- assert (Kx : inside (Rabs (cx c)) (sum_x a') (sum_x b')) by now right.
  assert (Ky : inside (Rabs (cy c)) (sum_y a') (sum_y b')) by now right.
  assert (J : joined (Rabs (cx d)) (Rabs (cx c)) (sum_x a') (sum_x b')).
  { destruct Ix as [I|I]; [|right; left; auto]. right. right. left. split; [eapply below_trans; eassumption|auto]. }
  assert (J' : joined (Rabs (cy d)) (Rabs (cy c)) (sum_y a') (sum_y b')).
  { destruct Iy as [I|I]; [|right; left; auto]. right. right. left. split; [eapply below_trans; eassumption|auto]. }
  split; [|easy]. do 6 (split; [easy|]). exists det. auto.
Qed.
Definition bounded a b ds := nonneg_lane a /\ nonneg_lane b /\ head_in a b ds /\ 
  tallied (bounded_edge a b) ds (xorb (parity a) (parity b)).
Lemma bounded_next a b a' b' d c f ds : bounded a b (d :: ds) -> seen c -> grown a a' -> grown b b' ->
  taken a a' d c f /\ parity b' = parity b \/ taken b b' d c f /\ parity a' = parity a -> bounded a' b' (c :: d :: ds).
Proof.
intros (A & B & (Sd & Ix & Iy) & E) S GA GB T.
assert (T' : taken a a' d c f \/ taken b b' d c f) by (destruct T as [[T _]|[T _]]; auto).
destruct (new_edge _ _ _ _ _ _ _ Sd S Ix Iy GA GB T') as [N Hd].
split; [apply GA|]. split; [apply GB|]. split; [exact Hd|].
replace (xorb (parity a') (parity b')) with (xorb (xorb (parity a) (parity b)) f).
- apply one_edge; [|exact N]. revert E. apply tallied_impl. intros d' c' f'. now apply bounded_grown.
- destruct T as [[(_ & _ & _ & _ & det & _ & _ & _ & ->) ->]|[(_ & _ & _ & _ & det & _ & _ & _ & ->) ->]];
    destruct (parity a), (parity b), f; reflexivity.
Qed.
Lemma run_bounded ds a b : run ds a b -> bounded a b ds.
Proof.
induction 1 as [c S|c d ds a b a' R I S Ad|c d ds a b b' R I S Ad|c d ds a b a' b' R I S Ad Bd].
- pose proof (Rabs_pos (cx c)). pose proof (Rabs_pos (cy c)).
  split; [split; simpl; lra|]. split; [split; simpl; lra|]. split; [|apply no_edge].
  split; [exact S|]. split; left; apply below_refl.
- pose proof I as (A & B & _). apply (added_grown _ _ _ _ Ad) in A as (GA & f & T).
  apply bounded_next with a b f; auto using grown_refl.
- pose proof I as (A & B & _). apply (added_grown _ _ _ _ Ad) in B as (GB & f & T).
  apply bounded_next with a b f; auto using grown_refl.
- pose proof I as (A & B & _). apply (added_grown _ _ _ _ Ad) in A as (GA & f & T).
  apply (added_grown _ _ _ _ Bd) in B as (GB & f' & T'). apply bounded_next with a b f; auto.
Qed.
End Crossings.
