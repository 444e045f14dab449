(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of boxes and slabs around points. *)
Require Import ZArith List Arith.
From Certificates Require Import solids language formulas_vectors formulas_solids formulas_slabs.
Import ListNotations.
Local Open Scope check_scope.

Section checks.
Context {A : Type}.
Notation T := (term A). Notation C := (cond A).

(** Points by their places in a list *)
Definition chosen_from (points : list (list A)) (places : list nat) : list (list A) :=
  map (fun i => nth i points nil) places.
Definition are_places {B} (l : list B) (places : list nat) : C := all (fun i => if_so (i <? length l)) places.
(** The i-th value is the least, the j-th the greatest. *)
Definition ends_at (values : list T) (low high : T) (i j : nat) : C :=
  at_index i values (fun v => v = low) /\ at_index j values (fun v => v = high) /\
  all (fun v => low <= v /\ v <= high) values.

(** [aabb_of_points], kind [extreme_points] *)
Definition check_aabb_of_points (points : list (list A)) (low high : list A) (least greatest : list nat) : C :=
  let n := length low in
  if_so (two_or_three low) /\ as_long high low /\ all (of_length n) points /\ of_length n least /\
  of_length n greatest /\
  on_each n (fun k => ends_at (map (coordinate k) points) (coordinate k low) (coordinate k high) (nth k least 0%nat)
                              (nth k greatest 0%nat)).

(** [kdop_of_points], kind [extreme_points] *)
Fixpoint slabs_end (points normals : list (list A)) (slabs : list (A * A)) (least greatest : list nat) : C :=
  match normals, slabs, least, greatest with
  | n :: normals', (low, high) :: slabs', i :: least', j :: greatest' =>
      of_length 3 n /\ not_zero n /\
      ends_at (map (fun p => inner (leaves n) (leaves p)) points) (Leaf low) (Leaf high) i j /\
      slabs_end points normals' slabs' least' greatest'
  | nil, nil, nil, nil => Yes
  | _, _, _, _ => No
  end.
Definition check_kdop_of_points (points normals : list (list A)) (slabs : list (A * A)) (least greatest : list nat) :
  C :=
  all (of_length 3) points /\ if_so (negb (length normals =? 0)) /\ slabs_end points normals slabs least greatest.
End checks.
