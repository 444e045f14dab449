(* SPDX-License-Identifier: Apache-2.0 *)
(* Tactics that take the definition of a filter operation by operation: every operation of the run gets its ghost. *)
From Coq Require Import Reals ZArith Lra Bool.
From Filters Require Import model constants steps ghost.
Open Scope R_scope.

Ltac unpack := repeat match goal with
  | R : exists _, _ |- _ => let x := fresh "x" in let S := fresh "S" in destruct R as (x & S & R)
  | R : add _ _ _ _ /\ _ |- _ => let S := fresh "S" in destruct R as (S & R) end.
Ltac constants := repeat match goal with S : constant (reals _) _ ?x |- _ => simpl in S; subst x end;
  repeat match goal with |- context [magnitude (reals _) ?x] => change (magnitude (reals _) x) with (Rabs x) end;
  change @magnitude with @magnitude in *; cbn [magnitude opposite reals] in *.

(* sums of magnitudes are not negative *)
Ltac nonneg := repeat match goal with
  | S : add (reals ?F) (Plain ?x) (Plain ?y) ?z |- _ =>
    lazymatch goal with P : 0 <= z |- _ => fail | _ => idtac end;
    let P := fresh "P" in
    assert (P : 0 <= z) by (eapply sum_nonneg; [ | | exact S]; first [assumption | apply Rabs_pos])
  end.

(* what the guard says of the parts of its sum *)
Ltac parts G := repeat (match type of G with fits _ _ ?w ?v => match goal with
  | B : small ?H (S ?k) ?m ?z, S : add (reals ?F) (Plain ?x) (Plain ?y) ?z |- _ =>
    lazymatch goal with _ : small H _ _ x |- _ => fail | _ => idtac end;
    let m' := eval vm_compute in (m_guard w v m) in
    let A1 := fresh "B" in let A2 := fresh "B" in
    destruct (sum_guard F H w v G x y z k m m' ltac:(first [assumption|apply Rabs_pos]) ltac:(first [assumption|apply
      Rabs_pos])
      S B eq_refl) as [A1 A2] end end);
  repeat match goal with B : small ?H ?k ?m (Rabs ?x) |- _ =>
    lazymatch goal with _ : small H _ _ x |- _ => fail | _ => pose proof (smaller H k m x B) end end.

(* ghosts of the numbers that the filter starts from: inputs, and differences of two of them *)
Ltac as_input G x := match type of G with fits ?F ?H _ _ => pose proof (input_close F H 0 x) end.
Ltac inputs G l := match l with (?a, ?b) => inputs G a; as_input G b | ?a => as_input G a end.
Ltac difference G S := match type of G with fits ?F ?H ?w ?v => match type of S with
  | sub (reals F) (Plain ?a) (Plain ?b) ?x =>
    let c := eval vm_compute in (c_rounded w 2048) in let e := fresh "e" in let E := fresh "E" in let N := fresh "N" in
    destruct (difference_close F H w v G a b x c S eq_refl) as (e & E & N); clear S
  | add (reals F) (Plain ?a) (Plain ?b) ?x =>
    let c := eval vm_compute in (c_rounded w 2048) in let e := fresh "e" in let E := fresh "E" in let N := fresh "N" in
    destruct (sum_close F H w v G a b x c S eq_refl) as (e & E & N); clear S end end.
Ltac differences G := repeat match type of G with fits ?F ?H ?w ?v => match goal with
  | B : small H 1 _ ?x, S : sub (reals F) (Plain ?a) (Plain ?b) ?x |- _ => is_var a; is_var b; difference G S end end.

Ltac sum_of_inputs G a b := match goal with S : add (reals _) (Plain a) (Plain b) _ |- _ => difference G S end.

Ltac know G x := lazymatch type of G with fits ?F ?H ?w ?v => lazymatch goal with
  | _ : close F H _ _ x _ |- _ => idtac
  | _ => lazymatch x with
    | Rabs ?y => know G y; match goal with N : close F H ?k ?c y ?y0 |- _ => pose proof (abs_close F H k c y y0 N) end
    | _ => tryif is_var x then fail else pose proof (input_close F H 0 x) end end end;
  try match x with Rabs ?y => match type of G with fits ?F ?H _ _ =>
    lazymatch goal with _ : small H _ _ x |- _ => fail | _ => idtac end;
    match goal with B : small H ?k ?m y |- _ => pose proof (abs_small H k m y B) end end end.

Ltac step_mul G S := lazymatch type of G with fits ?F ?H ?w ?v => lazymatch type of S with mul (reals F) ?x ?y ?z =>
  first [
    match goal with C : n F <= x <= q ?mC |- _ => know G y;
      match goal with N : close F H ?k ?c y ?y0 |- _ =>
        let r := eval vm_compute in (c_rounded w (up mC (c + 1024))) in
        let e := fresh "e" in let E := fresh "E" in let T := fresh "N" in let U := fresh "U" in
        destruct (times_close F H w v G k c x mC y y0 z r C N S eq_refl) as (e & E & T & U) end;
      try match goal with B : small H (Datatypes.S ?k) ?m y |- _ =>
        let r := eval vm_compute in (up (1024 + w) (up mC m) + v)%Z in
        pose proof (times_small F H w v G k m x mC y z r ltac:(destruct G; lra) B S eq_refl) end;
      clear S
    end
  | know G x; know G y;
    match goal with Nx : close F H ?k1 ?c1 x ?x0 |- _ => match goal with Ny : close F H ?k2 ?c2 y ?y0 |- _ =>
    match goal with Bx : small H (Datatypes.S k1) ?m1 x |- _ => match goal with By : small H (Datatypes.S k2) ?m2 y |-
      _ =>
      let c := eval vm_compute in (c_product w v c1 m1 c2 m2) in let m := eval vm_compute in (m_product w v m1 m2) in
      let e := fresh "e" in let E := fresh "E" in let T := fresh "N" in
      let k := eval vm_compute in (Datatypes.S (k1 + k2)) in
      destruct (mul_close F H w v G k1 c1 m1 x x0 k2 c2 m2 y y0 z c Nx Bx Ny By S eq_refl
        : exists e, Rabs e <= u F /\ close F H k c z (x0 * y0 * (1 + e))) as (e & E & T);
      pose proof (mul_small F H w v G k1 m1 x k2 m2 y z m Bx By S eq_refl : small H (Datatypes.S k) m z);
      clear S end end end end ] end end.

Ltac step_use G U := lazymatch type of G with fits ?F ?H ?w ?v => lazymatch type of U with
  | uses F (Plain ?x) ?x' => know G x; change (read F x x') in U;
    match goal with N : close F H ?k ?c x ?x0 |- _ => let c' := eval vm_compute in (c + 1024)%Z in
      pose proof (read_close F H w v G k c x x0 x' N U : close F H k c' x' x0) end;
    try match goal with B : small H ?k ?m x |- _ => pose proof (read_small F H k m x x' B U) end
  | uses F (Product ?x ?y ?z) ?z' => first [
      match goal with T : forall z' r', uses F (Product x y z) z' -> (?r + 1024)%Z = r' -> _ |- _ =>
        let r' := eval vm_compute in (r + 1024)%Z in
        let e := fresh "e" in let E := fresh "E" in let D := fresh "D" in let N := fresh "N" in
        destruct (T z' r' U eq_refl) as (e & E & D & N) end
    | know G x; know G y;
      match goal with Nx : close F H ?k1 ?c1 x ?x0 |- _ => match goal with Ny : close F H ?k2 ?c2 y ?y0 |- _ =>
      match goal with Bx : small H (Datatypes.S k1) ?m1 x |- _ => match goal with By : small H (Datatypes.S k2) ?m2 y
        |- _ =>
      match goal with Nz : close F H _ _ z (x0 * y0 * (1 + ?e)), E : Rabs ?e <= u F, Bz : small H _ ?mz z |- _ =>
        let c := eval vm_compute in (c_product w v c1 m1 c2 m2 + 1024)%Z in
        let e' := fresh "e" in let E' := fresh "E" in let D := fresh "D" in let N := fresh "N" in
let k := eval vm_compute in (Datatypes.S (k1 + k2)) in
        destruct (use_product F H w v G k1 c1 m1 x x0 k2 c2 m2 y y0 z e z' c Nx Bx Ny By Nz E U eq_refl
          : exists e', Rabs e' <= u F /\ (e' = e \/ e' = 0) /\ close F H k c z' (x0 * y0 * (1 + e'))) as (e' & E' & D
            & N);
        pose proof (use_product_small F H w v G k1 m1 x k2 m2 y z z' Bx By Bz U : small H (Datatypes.S k) mz z') end
          end end end end ] end end.

Ltac step_sum G S := lazymatch type of G with fits ?F ?H ?w ?v =>
  let x' := fresh "x" in let y' := fresh "y" in let U1 := fresh "U" in let U2 := fresh "U" in let R := fresh "R" in
  lazymatch type of S with
  | add (reals F) ?p ?q ?z => destruct S as (x' & y' & U1 & U2 & R); step_use G U1; step_use G U2;
    match goal with Nx : close F H ?k1 ?c1 x' ?x0 |- _ => match goal with Ny : close F H ?k2 ?c2 y' ?y0 |- _ =>
      let k := eval vm_compute in (Nat.max k1 k2) in let c := eval vm_compute in (c_rounded w (c1 + c2)) in
      let e := fresh "e" in let E := fresh "E" in let N := fresh "N" in
      destruct (add_close F H w v G k1 c1 x' x0 k2 c2 y' y0 z k c Nx Ny R eq_refl eq_refl) as (e & E & N) end end;
    try match goal with Bx : small H (Datatypes.S ?k1) ?m1 x' |- _ => match goal with By : small H (Datatypes.S ?k2)
      ?m2 y' |- _ =>
      lazymatch goal with _ : small H _ _ z |- _ => fail | _ => idtac end;
      let k := eval vm_compute in (Nat.max k1 k2) in let m := eval vm_compute in (up (1024 + w) (m1 + m2) + v)%Z in
      pose proof (add_small F H w v G k1 m1 x' k2 m2 y' z k m Bx By R eq_refl eq_refl) end end
  | sub (reals F) ?p ?q ?z => destruct S as (x' & y' & U1 & U2 & R); step_use G U1; step_use G U2;
    match goal with Nx : close F H ?k1 ?c1 x' ?x0 |- _ => match goal with Ny : close F H ?k2 ?c2 y' ?y0 |- _ =>
      let k := eval vm_compute in (Nat.max k1 k2) in let c := eval vm_compute in (c_rounded w (c1 + c2)) in
      let e := fresh "e" in let E := fresh "E" in let N := fresh "N" in
      destruct (sub_close F H w v G k1 c1 x' x0 k2 c2 y' y0 z k c Nx Ny R eq_refl eq_refl) as (e & E & N) end end;
    try match goal with Bx : small H (Datatypes.S ?k1) ?m1 x' |- _ => match goal with By : small H (Datatypes.S ?k2)
      ?m2 y' |- _ =>
      lazymatch goal with _ : small H _ _ z |- _ => fail | _ => idtac end;
      let k := eval vm_compute in (Nat.max k1 k2) in let m := eval vm_compute in (up (1024 + w) (m1 + m2) + v)%Z in
      pose proof (sub_small F H w v G k1 m1 x' k2 m2 y' z k m Bx By R eq_refl eq_refl) end end
  end end.

Ltac steps G := repeat match goal with
  | S : mul (reals _) _ _ _ |- _ => step_mul G S
  | S : add (reals _) _ _ _ |- _ => step_sum G S
  | S : sub (reals _) _ _ _ |- _ => step_sum G S end.

(* all flags but the sign's are true, or the answer is unknown *)
Ltac flags R := repeat match type of R with _ = (if negb ?c then unknown else _) =>
    let C := fresh "C" in destruct c eqn:C; cbn [negb] in R; [|subst; split; discriminate] end;
  repeat match goal with C : (_ && _)%bool = true |- _ => apply andb_prop in C; destruct C end;
  repeat match goal with C : ?b = true |- _ => is_var b; subst b end.

Ltac guarded G := lazymatch type of G with fits ?F ?H ?w ?v => match goal with
  | S : at_most (reals F) ?z H true, P : 0 <= ?z |- _ => pose proof (guard_holds F H w v G z S P) end end.

(* what is known of a value's ghost: beyond what is left of the bound's, whose absolute term is num n H^k *)
Ltac bounded G num lows Pos Neg :=
  let Hu := fresh "Hu" in pose proof (fits_u _ _ _ _ G) as Hu;
  lazymatch type of G with fits ?F ?H ?w ?v =>
  match goal with K : greater (reals F) (Rabs ?x) ?b true |- _ =>
  match goal with S : greater (reals F) x 0 ?s |- _ =>
  match goal with NV : close F H ?k ?cv x ?V0 |- _ =>
  match goal with NB : close F H k ?cb b ((?P + ?A) * (1 + ?e)) |- _ =>
  match goal with E : Rabs e <= u F |- _ =>
    let L := fresh "L" in eassert (L : low (u F) _ P _) by lows Hu; cbn [Nat.add Nat.max] in L;
    let N := fresh "N" in assert (N : A = IZR num * (n F * H ^ k)) by (simpl; ring);
    match type of L with low _ ?i _ ?T =>
    destruct (certain_ghost F H w v G k cv cb x V0 b P A e s i T num NV NB E L N ltac:(vm_compute; discriminate) K S)
      as [Pos Neg]
    end end end end end end end.

(* a sum of products of magnitudes is at most a product of sums of them *)
Ltac positive_terms := match goal with
  | |- 0 <= _ + _ => apply Rplus_le_le_0_compat; positive_terms
  | |- 0 <= _ * _ => apply Rmult_le_pos; positive_terms
  | |- 0 <= _ ^ _ => apply pow_le; positive_terms
  | |- 0 <= _ => first [assumption | lra] end.
Ltac magnitudes := repeat match goal with |- context [Rabs ?x] =>
  let P := fresh "P" in pose proof (Rabs_pos x) as P; let y := fresh "y" in set (y := Rabs x) in *; clearbody y end.
Ltac units := magnitudes; match goal with |- ?x <= ?y => cut (0 <= y - x); [lra|]; ring_simplify; positive_terms end.

(* The sign of a polynomial whose roundings are taken for independent, by certain_polynomial. What is left to show is
   that the constant is enough. *)
Ltac polynomial G num Right :=
  repeat match goal with D : _ = _ \/ _ = _ |- _ => clear D end; (* lra would look at each choice *)
  let Hu := fresh "Hu" in pose proof (fits_u _ _ _ _ G) as Hu;
  lazymatch type of G with fits ?F ?H ?w ?v =>
  match goal with K : greater (reals F) (Rabs ?x) ?b true |- _ =>
  match goal with S : greater (reals F) x 0 ?s |- _ =>
  match goal with NV : close F H ?k ?cv x (?D * (1 + ?e')) |- _ =>
  match goal with NB : close F H k ?cb b ((?P + ?A) * (1 + ?e)) |- _ =>
  match goal with E : Rabs e <= u F |- _ =>
  match goal with E' : Rabs e' <= u F |- _ =>
    let L := fresh "L" in eassert (L : low (u F) _ P _) by lows Hu; cbn [Nat.add Nat.max] in L;
    let O := fresh "O" in eassert (O : off (u F) _ D _ _) by (offs_last Hu); cbn [Nat.add Nat.max] in O;
    let N := fresh "N" in assert (N : A = IZR num * (n F * H ^ k)) by (simpl; ring);
    match type of L with low _ ?i _ ?T => match type of O with off _ ?j' _ ?t ?TT =>
    let C := fresh "C" in
    assert (C : (1 + u F) * ((1 + u F) ^ j' - 1) * TT <= (1 - u F) ^ Datatypes.S i * T);
    [clear - Hu G | pose proof (certain_polynomial F H w v G k cv cb x D e' b P A e s i T num j' t TT NV E' NB E L N
       ltac:(vm_compute; discriminate) K S O C) as Right]
    end end end end end end end end end.

(* rule (5) for such a polynomial: relative c d with c >= 2 j *)
Ltac constant_is_enough G d := match goal with |- _ * ((1 + u ?F) ^ ?j - 1) * ?TT <= (1 - u ?F) ^ ?m * ?T =>
  match T with context [relative ?twice_j ?d' ?u'] =>
    let C := constr:(relative twice_j d' u') in
    let T' := match (eval pattern C in T) with ?f _ => eval cbv beta in (f 1) end in
    let E := fresh "E" in let L := fresh "L" in let P := fresh "P" in
    assert (E : (1 + u F) * ((1 + u F) ^ j - 1) <= (1 - u F) ^ m * C);
    [ apply Rle_trans with ((1 - u F) ^ m * (INR j * u F + INR d * u F * u F));
      [ apply enough; [assumption| destruct G; simpl; lra | destruct G; simpl; lra]
      | apply Rmult_le_compat_l; [apply pow_le; lra|unfold relative; simpl; lra] ]
    | replace T with (C * T') by ring;
      assert (L : TT <= T') by units;
      assert (P : 0 <= TT) by (magnitudes; positive_terms);
      apply Rle_trans with ((1 - u F) ^ m * C * TT); [apply Rmult_le_compat_r; assumption|];
      rewrite <- Rmult_assoc; apply Rmult_le_compat_l; [|exact L];
      apply Rle_trans with (2 := E); apply Rmult_le_pos; [lra|]; assert (1 <= (1 + u F) ^ j) by (apply pow_R1_Rle;
        lra); lra ] end end.

(* C of these is normal, and below mC / 1024 *)
Ltac normal G c d mC := match type of G with fits ?F _ _ _ =>
  let HC := fresh "HC" in let C0 := fresh "C0" in
  assert (HC : n F <= relative c d (u F) <= q mC) by (destruct G; unfold relative, q; split; nra);
  assert (C0 : 0 <= relative c d (u F)) by (destruct G; lra) end.
Ltac answers R Right := match type of R with _ = if ?s then positive else negative =>
  split; intros ->; destruct s; try discriminate; apply Right; reflexivity end.

(* from the two halves: beyond the bound, and no further where the sign is wrong *)
Ltac signs R Pos Neg P Q W1 W2 := split; intros ->;
  match type of R with _ = (if ?s then _ else _) => destruct s; try discriminate end; apply Rnot_le_lt; intros NN;
  first [ specialize (P (Pos eq_refl)) | specialize (Q (Neg eq_refl)) ];
  first [ specialize (W1 ltac:(lra)); lra | specialize (W2 ltac:(lra)); lra ].

(* a bound C ex ey: beyond K, in units of the extents *)
Ltac in_extents G Pos K enough P' Q' := lazymatch type of G with fits ?F _ _ _ =>
  match type of Pos with _ -> ?V * (1 + ?e) > (1 - _) ^ ?m * (?C * ?X * ?Y) =>
  match goal with Hu : 0 < u F <= 1/16 |- _ =>
    destruct (beyond_extents (u F) Hu V e K C X Y m) as [P' Q'];
    [assumption|clear - Hu; pose proof (power (u F) Hu 1); pose proof (power (u F) Hu 2); lra
    |clear; repeat apply Rplus_le_le_0_compat; apply Rabs_pos
    |clear; repeat apply Rplus_le_le_0_compat; apply Rabs_pos|exact enough|] end end end.
