(* SPDX-License-Identifier: Apache-2.0 *)
(** The formula of two triangles: planes that leave some of their corners, and points that both have. *)
Require Import ZArith List Arith.
From Certificates Require Import hulls language formulas_vectors formulas_nearest formulas_triangles.
Import ListNotations.
Local Open Scope check_scope.

Section checks.
Context {A : Type}.
Notation T := (term A). Notation C := (cond A).

(** A corner, and whether the planes so far leave it *)
Definition corner : Type := list A * C.
Definition plane_height (n : list A) (d : A) (p : list A) : T := inner (leaves n) (leaves p) - Leaf d.
Definition still_left (n : list A) (d : A) (c : corner) : corner :=
  (fst c, snd c /\ plane_height n d (fst c) = zero).
(** No plane has what is left of a in front, or what is left of b behind; [rest] is asked of what all of them leave. *)
Fixpoint cut_by (planes : list (list A * A)) (a b : list corner) (rest : list corner -> list corner -> C) : C :=
  match planes with
  | [] => rest a b
  | (n, d) :: planes' =>
      of_length 3 n /\ all (fun c => ~ snd c \/ plane_height n d (fst c) <= zero) a /\
      all (fun c => ~ snd c \/ zero <= plane_height n d (fst c)) b /\
      cut_by planes' (map (still_left n d) a) (map (still_left n d) b) rest
  end.

(** Ways between two corners that are left *)
Definition some_way (l : list corner) (f : list T -> C) : C :=
  match l with
  | [(p, k); (q, m); (r, n)] =>
      let way x y := difference (leaves y) (leaves x) in
      k /\ m /\ f (way p q) \/ k /\ n /\ f (way p r) \/ m /\ n /\ f (way q r)
  | _ => No
  end.
Definition normal_of (l : list corner) : list T :=
  match l with
  | [(p, _); (q, _); (r, _)] =>
      outer_product (difference (leaves q) (leaves p)) (difference (leaves r) (leaves p))
  | _ => []
  end.
Definition has_plane (l : list corner) : C :=
  match l with [(_, k); (_, m); (_, n)] => k /\ m /\ n /\ ~ no_vector (normal_of l) | _ => No end.
Definition has_line (l : list corner) : C := some_way l (fun d => ~ no_vector d).
Definition leaves_plane (a b : list corner) : C := some_way b (fun d => ~ inner (normal_of a) d = zero).
Definition at_most_line (a b : list corner) : C := ~ has_plane a \/ ~ has_plane b \/ leaves_plane a b.
Definition at_most_point (a b : list corner) : C :=
  ~ has_line a \/ ~ has_line b \/
  ~ has_plane a /\ ~ has_plane b /\ some_way a (fun d => some_way b (fun e => ~ no_vector (outer_product d e))) \/
  has_plane a /\ ~ has_plane b /\ leaves_plane a b \/ has_plane b /\ ~ has_plane a /\ leaves_plane b a.

(** [triangle_triangle] *)
Definition check_triangle_triangle (a b : list (list A)) (w : dimension) (planes : list (list A * A))
    (on_a on_b : list (list A)) : C :=
  let corners := map (fun p => (p, Yes)) in
  let common := map (fun w => mixed 3 w a) on_a in
  let equal x y := no_vector (difference x y) in
  are_points 3 3 a /\ are_points 3 3 b /\ if_so (length on_a =? length on_b) /\
  all (fun w => are_weights w a) on_a /\ all (fun w => are_weights w b) on_b /\
  all (fun w => equal (mixed 3 (fst w) a) (mixed 3 (snd w) b)) (combine on_a on_b) /\
  cut_by planes (corners a) (corners b) (fun a b =>
    match w, common with
    | common_none, [] => all (fun c => ~ snd c) a \/ all (fun c => ~ snd c) b
    | common_one, x :: others => all (equal x) others /\ at_most_point a b
    | common_line, x :: others =>
        ~ all (equal x) others /\ at_most_line a b /\
        all (fun y => all (fun z => no_vector (outer_product (difference y x) (difference z x))) others) others
    | common_area, x :: others =>
        ~ all (fun y => all (fun z => no_vector (outer_product (difference y x) (difference z x))) others) others
    | _, _ => No
    end).
End checks.
