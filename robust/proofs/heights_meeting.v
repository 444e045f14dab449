(* SPDX-License-Identifier: Apache-2.0 *)
(* Heights::meeting of height_filter.h. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Filters Require Import model constants filters steps ghost tactics squares heights.
Open Scope R_scope.

Section Meeting.
Variable F : format.
Hypothesis G : fits F (two_to 500) 1 1.
Hypothesis n_high : n F <= two_to (-1022).
Hypothesis u_low : two_to (-52) <= u F.
Notation u := (u F). Notation n := (n F). Notation M := (reals F).

Lemma small_more H k m m' x : (m <= m')%Z -> 0 <= H -> small H k m x -> small H k m' x.
Proof.
intros L P [A B]. split; [lia|]. apply Rle_trans with (1 := B). apply Rmult_le_compat_r; [now apply pow_le|].
apply IZR_le in L. unfold q. lra.
Qed.
Lemma low_normal : n < two_to (-900).
Proof.
apply Rle_lt_trans with (1 := n_high). replace (-900)%Z with (-1022 + (1 + 121))%Z by lia. rewrite !two_to_plus.
pose proof (two_to_pos (-1022)). pose proof (two_to_one 121 ltac:(lia)). change (two_to 1) with (2 * 1). nra.
Qed.
Lemma low_far : 18 * n <= u / 16 * two_to (-900).
Proof.
apply Rle_trans with (18 * two_to (-1022)); [lra|].
apply Rle_trans with (two_to (-52) / 16 * two_to (-900)).
- replace (-1022)%Z with (-52 + -900 + (-10 + -60))%Z by lia. rewrite !two_to_plus.
  pose proof (two_to_le (-60) 0 ltac:(lia)). pose proof (two_to_pos (-60)). change (two_to 0) with 1 in *.
  assert (T : two_to (-10) = / 1024) by (unfold two_to; simpl; lra). rewrite T.
  pose proof (Rmult_lt_0_compat _ _ (two_to_pos (-52)) (two_to_pos (-900))). nra.
- apply Rmult_le_compat_r; [apply Rlt_le, two_to_pos|lra].
Qed.
Lemma low_one : two_to (-900) <= 1.
Proof. apply (two_to_le (-900) 0). lia. Qed.
Lemma least_pays : IZR 4194304 * (n * two_to 500 ^ 1) <= two_to (-500).
Proof.
rewrite pow_1. apply Rle_trans with (IZR 4194304 * (two_to (-1022) * two_to 500)).
- apply Rmult_le_compat_l; [lra|]. apply Rmult_le_compat_r; [apply Rlt_le, two_to_pos|exact n_high].
- right. replace (-500)%Z with (22 + (-1022 + 500))%Z by lia. rewrite !two_to_plus. f_equal. unfold two_to. simpl. ring.
Qed.

Lemma pays (j m d : nat) c T TT : 0 <= TT -> (1 - u) ^ 3 * TT <= T -> INR j * u + INR d * u * u <= c * u ->
  INR j * u <= 1 -> INR d - INR (m + 3) * INR j - INR j ^ 2 - INR j >= (INR d * INR (m + 3) + INR j ^ 2) * u ->
  (1 + u) * ((1 + u) ^ j - 1) * TT <= (1 - u) ^ m * (c * u * T).
Proof.
intros P L C J D. pose proof (fits_u _ _ _ _ G) as Hu. pose proof (enough u Hu j (m + 3) d J D) as E.
pose proof (down u Hu m). pose proof (down u Hu (m + 3)) as D3.
apply Rle_trans with ((1 - u) ^ (m + 3) * (c * u) * TT).
- apply Rmult_le_compat_r; [exact P|]. apply Rle_trans with (1 := E). apply Rmult_le_compat_l; lra.
- rewrite pow_add.
  replace ((1 - u) ^ m * (1 - u) ^ 3 * (c * u) * TT) with ((1 - u) ^ m * (c * u * ((1 - u) ^ 3 * TT)))
    by ring.
  apply Rmult_le_compat_l; [lra|]. apply Rmult_le_compat_l; [|exact L].
  assert (0 <= INR j * u + INR d * u * u) by
    (pose proof (pos_INR j); pose proof (pos_INR d); apply Rplus_le_le_0_compat; repeat apply Rmult_le_pos; lra). lra.
Qed.

Lemma start_pays T TT : 0 <= TT -> (1 - u) ^ 3 * TT <= T ->
  (1 + u) * ((1 + u) ^ 4 - 1) * TT <= (1 - u) ^ 9 * (5 * u * T).
Proof.
intros P L. assert (U : 0 < u /\ 1024 * u <= 1) by (destruct G; lra). clear - P L U G.
apply (pays 4 9 900); auto; rewrite !INR_IZR_INZ; simpl Z.of_nat; simpl pow; nra.
Qed.
Lemma end_pays T TT : 0 <= TT -> (1 - u) ^ 3 * TT <= T ->
  (1 + u) * ((1 + u) ^ 5 - 1) * TT <= (1 - u) ^ 10 * (7 * u * T).
Proof.
intros P L. assert (U : 0 < u /\ 1024 * u <= 1) by (destruct G; lra). clear - P L U G.
apply (pays 5 10 900); auto; rewrite !INR_IZR_INZ; simpl Z.of_nat; simpl pow; nra.
Qed.

(* what a comparison K with a bound says of the value's ghost *)
Ltac past K Hu extra Name := match type of K with greater _ ?V ?B true =>
  match goal with NV : close F ?H ?k ?cv V ?V0 |- _ =>
  match goal with NB : close F H k ?cb B ((?P + ?A) * (1 + ?e)) |- _ =>
  match goal with E : Rabs e <= _ |- _ =>
    let L := fresh "L" in eassert (L : low u _ P _) by lows Hu; cbn [Nat.add Nat.max] in L;
    match type of L with low _ ?i _ ?T =>
    pose proof (above_ghost F H G k cv cb V V0 B P A e i T 4194304 extra NV NB E L least_pays
      ltac:(vm_compute; discriminate) ltac:(vm_compute; discriminate) K) as Name; clear L end end end end end.

Theorem heights_meeting_right cx cy cz r vx vy vz nx ny nz d answer : 0 <= r ->
  heights_meeting F R M cx cy cz r vx vy vz nx ny nz d answer ->
  let height := nx * cx + ny * cy + nz * cz + d in
  let rise := nx * vx + ny * vy + nz * vz in
  let reach := r * sqrt (nx * nx + ny * ny + nz * nz) in
  let at_end := if Rlt_dec height 0 then - (height + rise) else height + rise in
  (answer = meets_at_start -> Rabs height < reach) /\
  (answer = meets_later -> Rabs height > reach /\ at_end < reach) /\
  (answer = meets_never -> Rabs height > reach /\ at_end > reach).
Proof.
intros RP R height rise reach at_end. unfold heights_meeting in R. unpack. constants.
match type of R with _ = (if negb ?c then _ else _) => destruct c eqn:C; cbn [negb] in R;
  [|subst; repeat split; intros; discriminate] end.
apply andb_prop in C as [C C3]. apply andb_prop in C as [C1 C2].
repeat match goal with C : ?b = true |- _ => is_var b; subst b end.
nonneg. guarded G. parts G.
match goal with
| A : mul M nx nx ?a, B : mul M ny ny ?b, C : mul M nz nz ?c, T : add M (Product nx nx ?a) (Product ny ny ?b) ?t,
  Q : add M (Plain ?t) (Product nz nz ?c) ?q, L : at_most M (two_to (-900)) ?q true, X : square_root M ?q ?s |- _ =>
  pose proof (root F _ G _ _ _ _ _ _ _ _ _ _ low_normal low_far low_one A B C T Q L X) as RS;
  set (l := sqrt _) in RS; assert (SS : small (two_to 500) 1 4096 s);
  [|clear A B C T Q L X; pose proof (input_close F (two_to 500) 0 s)]
end.
{ apply (root_size F _ G nx ny nz); [exact RS| | |];
  (eapply small_more; [|apply Rlt_le, two_to_pos|eassumption]; lia). }
assert (HC5 : n <= 5 * u <= q 5) by (destruct G; unfold q; lra).
assert (HC7 : n <= 7 * u <= q 7) by (destruct G; unfold q; lra).
inputs G (nx, ny, nz, cx, cy, cz, vx, vy, vz, d, r).
match goal with C : choose M _ _ _ ?x, A : add M _ (Plain ?x) _ |- _ => revert A C end.
pose proof (fits_u _ _ _ _ G) as Hu. pose proof (between_pos u Hu _ _ _ RS) as SP.
steps G. repeat match goal with D : _ = _ \/ _ = _ |- _ => clear D end.
lazymatch goal with N : close F _ _ _ ?g ((Rabs ?E - r * ?s * (1 + ?e)) * (1 + ?f)) |- _ =>
  rename N into N_gap, g into gap, s into s', e into er, f into eg;
  set (ghost := E) in *; set (Q := r * s' * (1 + er)) in * end.
match goal with E1 : Rabs er <= _, E2 : Rabs eg <= _ |- _ => rename E1 into Er, E2 into Eg end.
match goal with N : close F _ _ _ ?h ghost |- _ => rename N into N_h, h into h' end.
eassert (OE : off u _ ghost height _) by (unfold ghost; offs Hu). cbn [Nat.add Nat.max] in OE.
assert (QP : 0 <= Q) by (apply (ratio u) in Er; apply Rmult_le_pos; [apply Rmult_le_pos|]; lra).
assert (OQ : off u 4 Q reach reach).
{ pose proof (off_self u r) as OR. rewrite (Rabs_right r) in OR by lra.
  exact (off_mul u Hu 0 3 _ _ _ _ _ _ _ 4 OR (off_between u 3 _ _ Hu RS) Er eq_refl). }
match type of OE with off _ _ _ _ ?T => set (T1 := T) in * end.
pose proof (off_difference u Hu 4 4 _ _ _ _ _ _ 4 (off_abs u 4 _ _ _ OE) OQ eq_refl) as OV.
assert (T1P : 0 <= T1) by (destruct OE as [OE' _]; exact (Rle_trans _ _ _ (Rabs_pos height) OE')).
assert (reachP : 0 <= reach) by (unfold reach; apply Rmult_le_pos; [exact RP|apply sqrt_pos]).
assert (D3 : 0 <= (1 - u) ^ 3 <= 1) by (pose proof (down u Hu 3); lra).
assert (reach_s : (1 - u) ^ 3 * reach <= r * s').
{ destruct RS as [_ [RS _]]. replace ((1 - u) ^ 3 * reach) with (r * ((1 - u) ^ 3 * l)) by (unfold reach, l; ring).
  apply Rmult_le_compat_l; assumption. }
pose (NN := Rabs nx + Rabs ny + Rabs nz).
assert (F1 : (1 - u) ^ 3 * (T1 + reach) <= NN * (Rabs cx + Rabs cy + Rabs cz) + Rabs d + r * s').
{ rewrite Rmult_plus_distr_l. apply Rplus_le_compat; [|exact reach_s].
  apply Rle_trans with (1 * T1); [apply Rmult_le_compat_r; lra|]. unfold T1, NN. clear. units. }
match type of R with _ = (if ?b then _ else if negb ?b' then _ else _) => destruct b; [|destruct b';
    cbn [negb] in R] end.
3: { intros; subst; repeat split; discriminate. }
- intros _ _. subst. repeat split; try discriminate. intros _.
  match goal with K : greater M (- _) gap true |- _ => apply (greater_opposite F) in K;
    apply (close_opposite F) in N_gap; past K Hu 0%Z PB end.
  match type of PB with _ > ?X + _ =>
  destruct (decided u Hu 4 _ eg _ _ X OV Eg
    ltac:(apply start_pays; [apply Rplus_le_le_0_compat; assumption|exact F1])) as [_ W];
  specialize (W ltac:(unfold q in PB; clear - PB; lra)) end. clear - W. lra.
- match goal with K : greater M gap _ true |- _ => past K Hu 1048576%Z PB end.
  set (unit := n * two_to 500 ^ 1) in *.
  assert (unitP : n <= unit /\ 0 < n)
    by (pose proof (n_pow F _ 1 1 G 1); pose proof (basics F _ 1 1 G); unfold unit; lra).
  match type of PB with _ > ?X' + _ =>
  assert (X : (1 + u) * ((1 + u) ^ 4 - 1) * (T1 + reach) <= X')
    by (apply start_pays; [apply Rplus_le_le_0_compat; assumption|exact F1]); set (X0 := X') in * end.
  assert (KP : 0 <= ((1 + u) ^ 4 - 1) * (T1 + reach))
    by (clear - Hu T1P reachP; pose proof (upward u Hu 4); apply Rmult_le_pos; lra).
  assert (PX : (Rabs ghost - Q) * (1 + eg) > X0) by (clear - PB unitP; unfold q in PB; lra).
  destruct (decided u Hu 4 _ eg _ _ X0 OV Eg X) as [W _]. specialize (W PX).
  assert (X1 : (1 + u) * (((1 + u) ^ 4 - 1) * (T1 + reach)) <= X0) by (clear - X; lra).
  destruct (beyond u Hu (Rabs ghost - Q) eg _ X0 Eg KP X1) as [Y _]. specialize (Y PX). clear X1.
  assert (big : Rabs ghost > 400 * unit).
  { clear - PB X KP QP Hu Eg unitP Y.
    assert (X0P : 0 <= X0) by (apply Rle_trans with (2 := X); rewrite Rmult_assoc; apply Rmult_le_pos; lra).
    pose proof (ratio u eg Eg). assert ((Rabs ghost - Q) * (1 + eg) <= (Rabs ghost - Q) * 2)
      by (apply Rmult_le_compat_l; lra). unfold q in PB. lra. }
  assert (near : Rabs (h' - ghost) <= 20 * unit)
    by (clear - N_h unitP; destruct N_h as [_ N_h]; fold unit in N_h; unfold q in N_h; lra).
  assert (nearer : Rabs (ghost - height) < Rabs ghost).
  { clear - OE Y QP Hu reachP. destruct OE as [_ OE]. apply Rle_lt_trans with (1 := OE).
    assert (0 <= ((1 + u) ^ 4 - 1) * reach) by (pose proof (upward u Hu 4); apply Rmult_le_pos; lra). lra. }
  match goal with K : greater M 0 h' ?b |- _ => assert (side : b = true /\ height < 0 \/ b = false /\ height > 0);
    [clear - K big near nearer unitP; destruct K as (z & x & Z & X & B)|] end.
  { assert (z = 0) as -> by (destruct Z as [->|[-> _]]; reflexivity).
    apply abs_le in near. assert (x = h') as ->.
    { destruct X as [->|[_ X%Rabs_def2]]; [reflexivity|exfalso]. unfold Rabs in big. destruct (Rcase_abs ghost); lra. }
    unfold Rabs in big, nearer.
    match type of B with ?b = true <-> _ => destruct b end; [left|right]; (split; [reflexivity|]).
    - apply proj1 in B. specialize (B eq_refl). destruct (Rcase_abs ghost), (Rcase_abs (ghost - height)); lra.
    - assert (0 <= h') by (apply Rnot_lt_le; intros Y; apply B in Y; discriminate).
      destruct (Rcase_abs ghost), (Rcase_abs (ghost - height)); lra. }
  assert (late : answer = meets_at_start -> False) by (intros ->;
    repeat match type of R with _ = (if ?b then _ else _) => destruct b end; discriminate).
  intros A C. split; [intros Z; destruct (late Z)|]. clear late.
  match type of C with choose _ _ _ ?g _ =>
    match goal with N : close F _ _ _ g ?S |- _ => rename N into N_r; set (gain := S) in * end end.
  eassert (OS : off u _ gain rise _) by (unfold gain; offs Hu). cbn [Nat.add Nat.max] in OS.
  match type of OS with off _ _ _ _ ?T => set (T2 := T) in * end.
  assert (T2P : 0 <= T2) by (destruct OS as [OS' _]; exact (Rle_trans _ _ _ (Rabs_pos rise) OS')).
  assert (F2 : (1 - u) ^ 3 * ((T1 + reach) + T2) <=
    NN * (Rabs cx + Rabs cy + Rabs cz) + Rabs d + r * s' + NN * (Rabs vx + Rabs vy + Rabs vz)).
  { rewrite Rmult_plus_distr_l. apply Rplus_le_compat; [exact F1|].
    apply Rle_trans with (1 * T2); [apply Rmult_le_compat_r; [exact T2P|apply D3]|]. unfold T2, NN. clear. units. }
  assert (TP : 0 <= (T1 + reach) + T2) by (clear - T1P T2P reachP; lra).
  pose proof (off_rounded u 4 _ _ _ eg OV Eg) as OW.
  assert (E_end : Rabs height - reach + (if Rlt_dec height 0 then - rise else rise) = at_end - reach).
  { unfold at_end. destruct (Rlt_dec height 0) as [L|L];
      [rewrite Rabs_left by exact L|rewrite Rabs_right by (clear - L; lra)]; ring. }
  assert (NX : exists g c, close F (two_to 500) 1 c x46 g /\ c = 16517%Z /\
    off u 3 g (if Rlt_dec height 0 then - rise else rise) T2).
  { destruct side as [[-> L]|[-> L]]; simpl in C; destruct (Rlt_dec height 0) as [L'|L'];
      try (exfalso; clear - L L'; lra).
    - exists (- gain), 16517%Z. split; [|split; [reflexivity|now apply off_opposite]].
      apply (read_close F _ 1 1 G 1 15493 (- x14)); [now apply close_opposite|exact C].
    - exists gain, 16517%Z. split; [|split; [reflexivity|exact OS]].
      apply (read_close F _ 1 1 G 1 15493 x14); [exact N_r|exact C]. }
  destruct NX as (g & c & NX & -> & OG). clear C N_r.
  steps G.
  match goal with N : close F _ _ _ _ (((Rabs ghost - Q) * (1 + eg) + g) * (1 + ?e)), E : Rabs ?e <= u |- _ =>
    rename N into N_last, e into el, E into El end.
  pose proof (off_sum u Hu 5 3 _ _ _ _ _ _ 5 OW OG eq_refl) as OL. rewrite E_end in OL.
  match type of R with _ = (if ?b then _ else _) => destruct b end.
  + subst. split; [discriminate|]. intros _. split; [clear - W; lra|].
    match goal with K : greater M _ _ true, N : close F _ _ _ ?V _ |- _ =>
      match type of N_last with close _ _ _ _ V _ =>
      match type of K with greater _ V _ _ => past K Hu 0%Z PE end end end.
    match type of PE with _ > ?X' + _ => destruct (decided u Hu 5 _ el _ _ X' OL El
      ltac:(apply end_pays; [exact TP|exact F2])) as [Z _]; specialize (Z ltac:(unfold q in PE; clear - PE; lra)) end.
    clear - Z. lra.
  + match type of R with _ = (if ?b then _ else _) => destruct b end; [|subst; split; discriminate].
    subst. split; [|discriminate]. intros _. split; [clear - W; lra|].
    match goal with K : greater M (- _) ?V true |- _ => match type of N_last with close _ _ _ _ V _ =>
      apply (greater_opposite F) in K; apply (close_opposite F) in N_last; past K Hu 0%Z PE end end.
    match type of PE with _ > ?X' + _ => destruct (decided u Hu 5 _ el _ _ X' OL El
      ltac:(apply end_pays; [exact TP|exact F2])) as [_ Z]; specialize (Z ltac:(unfold q in PE; clear - PE; lra)) end.
    clear - Z. lra.
Qed.
End Meeting.
