(* SPDX-License-Identifier: Apache-2.0 *)
(** Vectors as lists of terms, and what they mean. *)
Require Import Reals Qreals QArith ZArith List Arith.
From Certificates Require Import solids language.
Import ListNotations.

Definition leaves {A} (x : list A) : list (term A) := map Leaf x.
Fixpoint inner {A} (x y : list (term A)) : term A :=
  match x, y with a :: x', b :: y' => Add (Mul a b) (inner x' y') | _, _ => zero end.
Fixpoint sum_of {A} (x y : list (term A)) : list (term A) :=
  match x, y with a :: x', b :: y' => Add a b :: sum_of x' y' | _, _ => nil end.
Fixpoint difference {A} (x y : list (term A)) : list (term A) :=
  match x, y with a :: x', b :: y' => Sub a b :: difference x' y' | _, _ => nil end.
Definition scaled {A} (t : term A) (x : list (term A)) : list (term A) := map (Mul t) x.
Fixpoint same_vector {A} (x y : list (term A)) : cond A :=
  match x, y with a :: x', b :: y' => And (Eq a b) (same_vector x' y') | nil, nil => Yes | _, _ => No end.
Fixpoint all {B} {A} (f : B -> cond A) (l : list B) : cond A :=
  match l with nil => Yes | x :: l' => And (f x) (all f l') end.
Definition not_zero {A} (x : list A) : cond A := Not (all (fun a => Eq (Leaf a) zero) x).
Definition of_length {A B} (n : nat) (x : list B) : cond A := if_so (length x =? n).

Definition rl (x : list Q) : list R := map Q2R x.
Definition values (x : list (term Q)) : list R := map (value Q2R) x.

Lemma leaves_mean : forall x, values (leaves x) = rl x.
Proof. intro x; unfold values, leaves, rl; rewrite map_map; apply map_ext; auto. Qed.
Lemma inner_means : forall x y, value Q2R (inner x y) = dot (values x) (values y).
Proof. induction x as [|a x IH]; destruct y as [|b y]; simpl; auto. rewrite IH; auto. Qed.
Lemma sum_means : forall x y, values (sum_of x y) = plus (values x) (values y).
Proof. induction x as [|a x IH]; destruct y as [|b y]; simpl; auto. unfold values in *. rewrite <- IH; auto. Qed.
Lemma difference_means : forall x y, values (difference x y) = minus (values x) (values y).
Proof. induction x as [|a x IH]; destruct y as [|b y]; simpl; auto. unfold values in *. rewrite <- IH; auto. Qed.
Lemma scaled_means : forall t x, values (scaled t x) = times (value Q2R t) (values x).
Proof. intros t x; unfold values, scaled, times; rewrite !map_map; apply map_ext; auto. Qed.
Lemma same_vector_means : forall x y, means Q2R (same_vector x y) <-> values x = values y.
Proof.
  induction x as [|a x IH]; destruct y as [|b y]; simpl; try (split; intros; discriminate || tauto).
  rewrite IH. split; [intros [-> ->]; auto | intro h; injection h; auto].
Qed.
Lemma all_means : forall {B} (f : B -> cond Q) l, means Q2R (all f l) <-> forall x, In x l -> means Q2R (f x).
Proof.
  induction l as [|a l IH]; simpl; [tauto|]. rewrite IH. split.
  - intros [h k] x [-> | i]; auto.
  - intro h; split; auto.
Qed.
Lemma not_zero_means : forall x, means Q2R (not_zero x) -> nonzero (rl x).
Proof.
  intros x h. unfold not_zero in h; simpl in h. rewrite all_means in h.
  induction x as [|a x IH]; [exfalso; apply h; simpl; tauto|].
  destruct (Req_dec (Q2R a) 0) as [e | e].
  - destruct IH as [b [i n]].
    + intro g. apply h. intros y [<- | i]; [simpl; exact e | apply g; auto].
    + exists b; split; auto. right; auto.
  - exists (Q2R a); split; auto. left; auto.
Qed.
Lemma of_length_means : forall {A} n (x : list A), means Q2R (of_length n x) <-> length x = n.
Proof. intros; unfold of_length; rewrite if_so_means, Nat.eqb_eq; tauto. Qed.
Lemma rl_length : forall x, length (rl x) = length x.
Proof. intro; apply map_length. Qed.
Ltac read_vectors h :=
  repeat rewrite ?inner_means, ?sum_means, ?difference_means, ?scaled_means, ?same_vector_means, ?leaves_mean,
    ?if_so_means, ?of_length_means, ?Nat.eqb_eq, ?Nat.ltb_lt in h.
