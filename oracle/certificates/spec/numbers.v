(* SPDX-License-Identifier: Apache-2.0 *)
(** What [rounded] claims of the numbers of an answer. *)
Require Import Reals ZArith. Open Scope R_scope.
(** Of so many binary digits, in the range of doubles: of 53 it is a double, of 52 a double whose last digit is 0. *)
Definition binary (digits : Z) (d : R) : Prop := exists m e : Z, d = IZR m * powerRZ 2 e /\
  (Z.abs m < 2 ^ digits /\ -1021 - digits <= e <= 1024 - digits)%Z.
Inductive double (A : Type) := finite (d : A) | infinity | minus_infinity.
Arguments finite {A}. Arguments infinity {A}. Arguments minus_infinity {A}.
(** The nearest; of two as near, the one whose last digit is 0; from half a unit beyond the greatest on, infinity *)
Definition rounded_spec (x : R) (w : double R) : Prop :=
  let limit := powerRZ 2 1024 - powerRZ 2 970 in
  match w with
  | finite d => Rabs x < limit /\ binary 53 d /\ forall y, binary 53 y ->
      Rabs (x - d) <= Rabs (x - y) /\ (Rabs (x - d) = Rabs (x - y) -> y = d \/ binary 52 d)
  | infinity => limit <= x
  | minus_infinity => x <= - limit
  end.
(** The greatest that is not above x, and the least that is not below: the slabs of [kdop_of_points] hold all points. *)
Definition rounded_down_spec (x : R) (w : double R) : Prop :=
  match w with
  | finite d => binary 53 d /\ d <= x /\ forall y, binary 53 y -> y <= x -> y <= d
  | infinity => False
  | minus_infinity => forall y, binary 53 y -> x < y
  end.
Definition rounded_up_spec (x : R) (w : double R) : Prop := rounded_down_spec (- x)
  match w with finite d => finite (- d) | infinity => minus_infinity | minus_infinity => infinity end.
