(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of bodies that are in several contacts at once. *)
Require Import ZArith List Arith.
From Certificates Require Import solids language formulas_vectors.
Import ListNotations.
Local Open Scope check_scope.

Section checks.
Context {A : Type}.
Notation T := (term A). Notation C := (cond A).
Notation contact_list := (list (nat * nat * list A)).

Definition parting_term (v : list (list A)) (c : nat * nat * list A) : T :=
  let '(a, b, n) := c in inner (leaves n) (difference (leaves (nth a v nil)) (leaves (nth b v nil))).
(** All that pushes the i-th body *)
Fixpoint push_on (i : nat) (contacts : contact_list) (impulses : list A) : list T :=
  match contacts, impulses with
  | (a, b, n) :: contacts', j :: impulses' =>
      let others := push_on i contacts' impulses' in
      if a =? i then sum_of (scaled (Leaf j) (leaves n)) others
      else if b =? i then sum_of (scaled (zero - Leaf j) (leaves n)) others else others
  | _, _ => repeat zero 3
  end.
(** Of bodies, the first of which is the i-th: the impulses change each velocity to that in [v]; *)
Fixpoint are_pushed (i : nat) (bodies : list (A * list A)) (contacts : contact_list) (impulses : list A)
    (v : list (list A)) : C :=
  match bodies, v with
  | (w, before) :: bodies', after :: v' =>
      of_length 3 after /\
      same_vector (difference (leaves after) (leaves before)) (scaled (Leaf w) (push_on i contacts impulses)) /\
      are_pushed (S i) bodies' contacts impulses v'
  | [], [] => Yes
  | _, _ => No
  end.
(** and they push none that can move. *)
Fixpoint cancel (i : nat) (bodies : list (A * list A)) (contacts : contact_list) (impulses : list A) : C :=
  match bodies with
  | [] => Yes
  | (w, _) :: bodies' =>
      (Leaf w = zero \/ all (fun t => t = zero) (push_on i contacts impulses)) /\ cancel (S i) bodies' contacts impulses
  end.
Definition demand (before : list (list A)) (e : A) (c : nat * nat * list A) : T :=
  Leaf e * Max zero (zero - parting_term before c).
(** How much faster all are asked to part than they did, each as often as its weight says *)
Fixpoint missing (before : list (list A)) (e : A) (contacts : contact_list) (weights : list A) : T :=
  match contacts, weights with
  | c :: contacts', j :: weights' =>
      Leaf j * (demand before e c - parting_term before c) + missing before e contacts' weights'
  | _, _ => zero
  end.

Inductive contact_facts := impulses_push (impulses : list A) | weights_contradict (weights : list A).
(** [simultaneous_collisions] *)
Definition check_simultaneous_collisions (bodies : list (A * list A)) (contacts : contact_list) (e : A)
    (answer : option (list (list A))) (facts : contact_facts) : C :=
  let before := map snd bodies in
  let right_contact c := let '(a, b, n) := c in
    if_so (a <? length bodies) /\ if_so (b <? length bodies) /\ if_so (negb (a =? b)) /\ of_length 3 n /\ not_zero n in
  let not_negative l := if_so (length l =? length contacts) /\ all (fun j => zero <= Leaf j) l in
  all (fun body => zero <= Leaf (fst body) /\ of_length 3 (snd body)) bodies /\ zero <= Leaf e /\ Leaf e <= one /\
  all right_contact contacts /\
  match answer, facts with
  | Some v, impulses_push impulses =>
      not_negative impulses /\ are_pushed 0 bodies contacts impulses v /\
      all (fun pair => let '(j, c) := pair in demand before e c <= parting_term v c /\
        (Leaf j = zero \/ parting_term v c = demand before e c)) (combine impulses contacts)
  | None, weights_contradict weights =>
      not_negative weights /\ cancel 0 bodies contacts weights /\ zero < missing before e contacts weights
  | _, _ => No
  end.
End checks.
Arguments contact_facts : clear implicits.
