(* SPDX-License-Identifier: Apache-2.0 *)
(** A closed surface that has no vertex in front of a face bounds the hull of its vertices: what is behind all faces is
    between the vertices. *)
Require Import Reals Lra Lia List Arith Bool Permutation FinFun.
From Certificates Require Import hulls solids formulas_meshes sound_solids sound_vectors sound_nearest sound_hulls.
Import ListNotations.
Open Scope R_scope.

(** ** Sums over lists *)
Definition sum_over {B} (f : B -> R) (l : list B) : R := fold_right (fun x s => f x + s) 0 l.
Lemma sum_permuted : forall {B} (f : B -> R) l l', Permutation l l' -> sum_over f l = sum_over f l'.
Proof. intros B f l l' h. induction h; simpl; try lra. Qed.
Lemma sum_difference : forall {B} (f g : B -> R) l, sum_over (fun x => f x - g x) l = sum_over f l - sum_over g l.
Proof. induction l as [|x l IH]; simpl; [ring|]. rewrite IH; ring. Qed.
Lemma sum_times : forall {B} (f : B -> R) t l, sum_over (fun x => t * f x) l = t * sum_over f l.
Proof. induction l as [|x l IH]; simpl; [ring|]. rewrite IH; ring. Qed.
Lemma sum_same : forall {B} (f g : B -> R) l, (forall x, In x l -> f x = g x) -> sum_over f l = sum_over g l.
Proof. induction l as [|x l IH]; intro h; simpl; auto. rewrite IH, h; simpl; auto. intros; apply h; simpl; auto. Qed.
Lemma sum_joined : forall {B D} (f : B -> R) (g : D -> list B) l,
  sum_over f (flat_map g l) = sum_over (fun x => sum_over f (g x)) l.
Proof.
  assert (two : forall {B} (f : B -> R) l l', sum_over f (l ++ l') = sum_over f l + sum_over f l').
  { induction l as [|x l IH]; intro l'; simpl; [ring|]. rewrite IH; ring. }
  induction l as [|x l IH]; simpl; auto. rewrite two, IH; auto.
Qed.
Lemma sum_not_positive : forall {B} (f : B -> R) l, (forall x, In x l -> f x <= 0) -> sum_over f l <= 0.
Proof.
  induction l as [|x l IH]; intro h; simpl; [lra|]. assert (a := h x ltac:(simpl; auto)).
  assert (b := IH ltac:(intros; apply h; simpl; auto)). lra.
Qed.
Lemma sum_negative : forall {B} (f : B -> R) l y, (forall x, In x l -> f x <= 0) -> In y l -> f y < 0 ->
  sum_over f l < 0.
Proof.
  induction l as [|x l IH]; intros y h i n; simpl in *; [tauto|].
  assert (b := sum_not_positive f l ltac:(auto)). assert (a := h x ltac:(auto)).
  destruct i as [-> | i]; [lra|]. assert (c := IH y ltac:(auto) i n). lra.
Qed.

(** ** Closed surfaces *)
Definition swapped (e : nat * nat) : nat * nat := (snd e, fst e).
Lemma closed_means : forall faces, is_closed faces = true ->
  Permutation (flat_map edges_of faces) (map swapped (flat_map edges_of faces)).
Proof.
  intros faces h. unfold is_closed in h. cbv zeta in h. set (edges := flat_map edges_of faces) in *. clearbody edges.
  rewrite forallb_forall in h.
  assert (once : forall e, In e edges -> count_occ same_edge edges e = 1%nat).
  { intros e i. specialize (h e i). apply andb_true_iff in h. destruct h as [h _]. apply Nat.eqb_eq; auto. }
  assert (back : forall e, In e edges -> In (swapped e) edges).
  { intros e i. specialize (h e i). apply andb_true_iff in h. destruct h as [_ h]. apply Nat.eqb_eq in h.
    apply (count_occ_In same_edge). unfold swapped. rewrite h. lia. }
  assert (twice : forall e, swapped (swapped e) = e) by (intros [a b]; auto).
  assert (distinct : NoDup edges) by (apply (NoDup_count_occ' same_edge); auto).
  apply NoDup_Permutation; auto.
  - apply Injective_map_NoDup; auto. intros e f q. rewrite <- (twice e), q. apply twice.
  - intro e. split; intro i.
    + rewrite <- (twice e). apply in_map. auto.
    + apply in_map_iff in i. destruct i as (f & <- & i). auto.
Qed.
(** The two other corners of a face that has the corner i *)
Definition across (i : nat) (face : list nat) : list (nat * nat) :=
  match face with
  | [a; b; c] => (if a =? i then [(b, c)] else []) ++ (if b =? i then [(c, a)] else []) ++
                 (if c =? i then [(a, b)] else [])
  | _ => []
  end.
(** What is around a vertex closes. *)
Lemma around_closes : forall i (f : nat -> R) faces,
  Permutation (flat_map edges_of faces) (map swapped (flat_map edges_of faces)) ->
  sum_over (fun e => f (snd e) - f (fst e)) (flat_map (across i) faces) = 0.
Proof.
  intros i f faces closed. set (mark := fun (k : nat) (x : R) => if k =? i then x else 0).
  assert (e : sum_over (fun e => f (snd e) - f (fst e)) (flat_map (across i) faces) =
    sum_over (fun e => mark (snd e) (f (fst e)) - mark (fst e) (f (snd e))) (flat_map edges_of faces)).
  { rewrite !sum_joined. apply sum_same. intros face _. destruct face as [|a [|b [|c [|]]]]; try reflexivity.
    simpl. unfold mark. destruct (a =? i), (b =? i), (c =? i); simpl; ring. }
  rewrite e, sum_difference, (sum_permuted (fun e => mark (snd e) (f (fst e))) _ _ closed).
  assert (g : forall l, sum_over (fun e => mark (snd e) (f (fst e))) (map swapped l) =
    sum_over (fun e => mark (fst e) (f (snd e))) l).
  { induction l as [|[a b] l IH]; simpl; auto. rewrite IH; auto. }
  rewrite g. ring.
Qed.

(** ** Products of vectors of space *)
Definition rcross (p q : list R) : list R :=
  match p, q with
  | [a; b; c], [x; y; z] => [b * z - c * y; c * x - a * z; a * y - b * x]
  | _, _ => []
  end.
Definition rheight (vertices : list (list R)) (face : list nat) (x : list R) : R :=
  match face with
  | [i; j; k] =>
      let corner k := nth k vertices nil in
      dot (rcross (minus (corner j) (corner i)) (minus (corner k) (corner i))) (minus x (corner i))
  | _ => 0
  end.
Lemma space : forall p : list R, length p = 3%nat -> exists a b c, p = [a; b; c].
Proof. intros [|a [|b [|c [|]]]] len; try discriminate. exists a, b, c; auto. Qed.
Ltac coordinates :=
  repeat match goal with
  | l : length ?p = 3%nat |- _ => is_var p; apply space in l; destruct l as (? & ? & ? & ->)
  end.
Lemma rcross_length : forall p q, length p = 3%nat -> length q = 3%nat -> length (rcross p q) = 3%nat.
Proof. intros p q lp lq. coordinates. auto. Qed.
Lemma turned : forall p q r x, length p = 3%nat -> length q = 3%nat -> length r = 3%nat -> length x = 3%nat ->
  dot (rcross (minus q p) (minus r p)) (minus x p) = dot (rcross (minus r q) (minus p q)) (minus x q).
Proof. intros p q r x lp lq lr lx. coordinates. simpl. ring. Qed.
(** Of two neighbours of the vertex, p and q, as seen from it *)
Lemma pair_identity : forall n z u p q, length n = 3%nat -> length z = 3%nat -> length u = 3%nat -> length p = 3%nat ->
  length q = 3%nat -> dot n p <> 0 -> dot n q <> 0 ->
  dot n u * (dot (rcross p q) z / (dot n p * dot n q)) - dot n z * (dot (rcross p q) u / (dot n p * dot n q)) =
  dot (rcross z u) q / dot n q - dot (rcross z u) p / dot n p.
Proof.
  intros n z u p q ln lz lu lp lq hp hq.
  assert (key : dot n u * dot (rcross p q) z - dot n z * dot (rcross p q) u =
    dot (rcross z u) q * dot n p - dot (rcross z u) p * dot n q).
  { clear hp hq. coordinates. simpl. ring. }
  transitivity ((dot n u * dot (rcross p q) z - dot n z * dot (rcross p q) u) / (dot n p * dot n q)); [field; auto|].
  rewrite key. field. auto.
Qed.

(** ** Far away, behind all vertices, is a point from which they are less far than some way along the normal. *)
Lemma far_enough : forall y m vertices, (forall v, In v vertices -> dot m v < dot m y) ->
  exists t, 0 < t /\ forall v, In v vertices -> dot (minus v y) (minus v y) < t * (dot m y - dot m v).
Proof.
  intros y m. induction vertices as [|v vertices IH]; intro h.
  - exists 1. split; [lra|]. intros v [].
  - destruct (IH ltac:(intros; apply h; simpl; auto)) as (t & ht & near). assert (g := h v ltac:(simpl; auto)).
    set (d := dot m y - dot m v) in *. assert (0 < d) by (unfold d; lra).
    set (s := (dot (minus v y) (minus v y) + 1) / d).
    assert (sd : s * d = dot (minus v y) (minus v y) + 1) by (unfold s; field; lra).
    exists (Rmax t s). split; [eapply Rlt_le_trans; [exact ht | apply Rmax_l]|]. intros w [<- | i].
    + fold d. assert (s * d <= Rmax t s * d) by (apply Rmult_le_compat_r; [lra | apply Rmax_r]). lra.
    + assert (k := near w i). assert (k' := h w ltac:(simpl; auto)).
      assert (t * (dot m y - dot m w) <= Rmax t s * (dot m y - dot m w))
        by (apply Rmult_le_compat_r; [lra | apply Rmax_l]).
      lra.
Qed.
Lemma some_element : forall {B} (l : list B), l <> [] -> exists x, In x l.
Proof. intros B [|x l] h; [tauto | exists x; simpl; auto]. Qed.

Section mesh.
Variables (vertices : list (list R)) (faces : list (list nat)) (side : R).
Hypothesis lengths : forall v, In v vertices -> length v = 3%nat.
Hypothesis right : forall face, In face faces -> is_face (length vertices) face = true.
Hypothesis closed : is_closed faces = true.
Hypothesis some : faces <> [].
Hypothesis none_in_front : forall face v, In face faces -> In v vertices -> side * rheight vertices face v <= 0.
Hypothesis some_behind : forall face, In face faces ->
  exists v, In v vertices /\ side * rheight vertices face v < 0.
Let corner (k : nat) : list R := nth k vertices nil.

Lemma three_corners : forall face, In face faces -> exists a b c, face = [a; b; c] /\
  In (corner a) vertices /\ In (corner b) vertices /\ In (corner c) vertices.
Proof.
  intros face i. assert (h := right face i). unfold is_face in h. destruct face as [|a [|b [|c [|]]]]; try discriminate.
  exists a, b, c. cbv iota in h. rewrite !andb_true_iff, !Nat.ltb_lt in h. unfold corner.
  split; [auto|]. repeat split; apply nth_In; tauto.
Qed.
Lemma across_corner : forall i p q, In (p, q) (flat_map (across i) faces) -> exists face, In face faces /\
  In (corner i) vertices /\ In (corner p) vertices /\ In (corner q) vertices /\
  (exists r, In (p, r) (flat_map edges_of faces)) /\ (exists r, In (q, r) (flat_map edges_of faces)) /\
  forall x, length x = 3%nat -> rheight vertices face x =
    dot (rcross (minus (corner p) (corner i)) (minus (corner q) (corner i))) (minus x (corner i)).
Proof.
  intros i p q h. apply in_flat_map in h. destruct h as (face & hf & h). exists face. split; [auto|].
  destruct (three_corners face hf) as (a & b & c & -> & ia & ib & ic).
  assert (edge : forall e, In e (edges_of [a; b; c]) -> In e (flat_map edges_of faces))
    by (intros e j; apply in_flat_map; exists [a; b; c]; auto).
  assert (la := lengths _ ia). assert (lb := lengths _ ib). assert (lc := lengths _ ic).
  assert (starts : forall k, k = a \/ k = b \/ k = c -> exists r, In (k, r) (flat_map edges_of faces)).
  { intros k [-> | [-> | ->]]; eexists; apply edge; simpl; eauto. }
  simpl in h. apply in_app_or in h. destruct h as [h | h].
  - destruct (a =? i) eqn:e; [|destruct h]. apply Nat.eqb_eq in e. destruct h as [q0 | []]. injection q0; intros; subst.
    do 3 (split; [auto|]). do 2 (split; [apply starts; auto|]). intros x lx. reflexivity.
  - apply in_app_or in h. destruct h as [h | h].
    + destruct (b =? i) eqn:e; [|destruct h]. apply Nat.eqb_eq in e. destruct h as [q0 | []].
      injection q0; intros; subst. do 3 (split; [auto|]). do 2 (split; [apply starts; auto|]). intros x lx.
      simpl. apply turned; auto.
    + destruct (c =? i) eqn:e; [|destruct h]. apply Nat.eqb_eq in e. destruct h as [q0 | []].
      injection q0; intros; subst. do 3 (split; [auto|]). do 2 (split; [apply starts; auto|]). intros x lx.
      simpl. etransitivity; apply turned; auto.
Qed.

Lemma behind_all_is_between : forall y, length y = 3%nat ->
  (forall face, In face faces -> side * rheight vertices face y <= 0) -> hull 3 vertices y.
Proof.
  intros y ly behind. destruct (separated 3 vertices y lengths ly) as [|(m & lm & front)]; auto. exfalso.
  destruct (far_enough y m vertices front) as (t & ht & near). set (c := minus y (times t m)).
  assert (lc : length c = 3%nat) by (unfold c; rewrite minus_length; rewrite times_length; congruence).
  assert (edges : flat_map edges_of faces <> []).
  { destruct (some_element faces some) as (face & hf). destruct (three_corners face hf) as (a & b & d & -> & _).
    intro z. assert (i : In (a, b) (flat_map edges_of faces)) by (apply in_flat_map; exists [a; b; d]; simpl; auto).
    rewrite z in i. destruct i. }
  destruct (greatest_of (fun e => sqdist c (corner (fst e))) _ edges) as ([i j] & ij & farthest). simpl in farthest.
  assert (star : exists p q, In (p, q) (flat_map (across i) faces)).
  { apply in_flat_map in ij. destruct ij as (face & hf & ij).
    destruct (three_corners face hf) as (a & b & d & -> & _).
    assert (go : forall p q, In (p, q) (across i [a; b; d]) -> exists p q, In (p, q) (flat_map (across i) faces))
      by (intros p q h; exists p, q; apply in_flat_map; exists [a; b; d]; auto).
    simpl in ij. destruct ij as [e | [e | [e | []]]]; injection e; intros -> ->.
    - apply (go j d). simpl. rewrite Nat.eqb_refl. simpl; auto.
    - apply (go j a). simpl. rewrite Nat.eqb_refl. apply in_or_app. right. simpl; auto.
    - apply (go j b). simpl. rewrite Nat.eqb_refl. apply in_or_app. right. apply in_or_app. right. simpl; auto. }
  destruct star as (p0 & q0 & h0).
  destruct (across_corner i p0 q0 h0) as (f0 & hf0 & iv & ip0 & _ & _ & _ & height0).
  set (v := corner i) in *. assert (lv := lengths v iv). set (n := minus v c). set (z := minus y v).
  assert (ln : length n = 3%nat) by (unfold n; rewrite minus_length; congruence).
  assert (lz : length z = 3%nat) by (unfold z; rewrite minus_length; congruence).
  assert (up : 0 < dot n z).
  { assert (k := near v iv). rewrite square_of_difference in k by congruence. unfold n, z, c.
    rewrite dot_minus, !minus_dot, !times_dot by (rewrite ?minus_length; rewrite ?times_length; congruence).
    rewrite (dot_sym y v). lra. }
  assert (down : forall face p q, In face faces -> In (corner p) vertices -> length q = 3%nat ->
    (exists r, In (p, r) (flat_map edges_of faces)) ->
    (forall x, length x = 3%nat -> rheight vertices face x = dot (rcross (minus (corner p) v) q) (minus x v)) \/
    (forall x, length x = 3%nat -> rheight vertices face x = dot (rcross q (minus (corner p) v)) (minus x v)) ->
    dot n (minus (corner p) v) < 0).
  { intros face p q hf ip lq (r & hr) height. assert (far := farthest (p, r) hr). simpl in far. fold v in far.
    assert (lp := lengths _ ip). set (w := corner p) in *.
    assert (lw : length (minus w v) = 3%nat) by (rewrite minus_length; congruence).
    assert (less : 2 * dot n (minus w v) + dot (minus w v) (minus w v) <= 0).
    { rewrite !sqdist_dot, !square_of_difference in far by congruence. rewrite square_of_difference by congruence.
      unfold n. rewrite dot_minus, !minus_dot by congruence. rewrite (dot_sym w v). lra. }
    apply Rnot_le_lt. intro no. assert (g := dot_self (minus w v)).
    assert (nothing : minus w v = [0; 0; 0]).
    { rewrite (zero_of_square (minus w v)) by lra. rewrite lw. reflexivity. }
    destruct (some_behind face hf) as (x & ix & less'). assert (lx := lengths x ix).
    assert (lxv : length (minus x v) = 3%nat) by (rewrite minus_length; congruence).
    assert (flat : rheight vertices face x = 0).
    { destruct height as [height | height]; rewrite height, nothing by auto; clear - lq lxv;
        revert lxv; generalize (minus x v); intros x0 lxv; coordinates; simpl; ring. }
    rewrite flat in less'. lra. }
  set (shares := fun (x : list R) (e : nat * nat) =>
    let p := minus (corner (fst e)) v in let q := minus (corner (snd e)) v in
    dot (rcross p q) x / (dot n p * dot n q)).
  set (all_around := flat_map (across i) faces) in *.
  assert (neighbours : forall p q, In (p, q) all_around ->
    length (minus (corner p) v) = 3%nat /\ length (minus (corner q) v) = 3%nat /\
    dot n (minus (corner p) v) < 0 /\ dot n (minus (corner q) v) < 0).
  { intros p q h. destruct (across_corner i p q h) as (face & hf & _ & ip & iq & sp & sq & height). fold v in height.
    assert (lp : length (minus (corner p) v) = 3%nat) by (rewrite minus_length; rewrite lengths; auto; congruence).
    assert (lq : length (minus (corner q) v) = 3%nat) by (rewrite minus_length; rewrite lengths; auto; congruence).
    split; [auto|]. split; [auto|]. split.
    - apply (down face p (minus (corner q) v) hf ip lq sp). left. exact height.
    - apply (down face q (minus (corner p) v) hf iq lp sq). right. exact height. }
  assert (share_of : forall p q x, In (p, q) all_around -> exists k face, 0 < k /\ In face faces /\
    (length x = 3%nat -> side * shares (minus x v) (p, q) = k * (side * rheight vertices face x))).
  { intros p q x h. destruct (neighbours p q h) as (lp & lq & np & nq).
    destruct (across_corner i p q h) as (face & hf & _ & _ & _ & _ & _ & height).
    exists (/ (dot n (minus (corner p) v) * dot n (minus (corner q) v))), face. split; [|split; [auto|]].
    - apply Rinv_0_lt_compat. replace (dot n (minus (corner p) v) * dot n (minus (corner q) v)) with
        ((- dot n (minus (corner p) v)) * (- dot n (minus (corner q) v))) by ring. apply Rmult_lt_0_compat; lra.
    - intro lx. rewrite height by auto. fold v. unfold shares. simpl. field. repeat split; lra. }
  assert (shares_down : forall x, length x = 3%nat ->
    (forall face, In face faces -> side * rheight vertices face x <= 0) ->
    forall e, In e all_around -> side * shares (minus x v) e <= 0).
  { intros x lx h [p q] k. destruct (share_of p q x k) as (s & face & hs & hf & e). rewrite e by auto.
    specialize (h face hf).
    assert (0 <= s * - (side * rheight vertices face x)) by (apply Rmult_le_pos; lra). lra. }
  assert (balance : forall u, length u = 3%nat ->
    dot n u * sum_over (fun e => side * shares z e) all_around =
    dot n z * sum_over (fun e => side * shares u e) all_around).
  { intros u lu.
    assert (k := around_closes i (fun k => dot (rcross z u) (minus (corner k) v) / dot n (minus (corner k) v)) faces
      (closed_means faces closed)).
    fold all_around in k.
    assert (pull : forall t x, sum_over (fun e => t * shares x e) all_around = t * sum_over (shares x) all_around)
      by (intros; apply (sum_times (shares x))).
    assert (same : dot n u * sum_over (shares z) all_around - dot n z * sum_over (shares u) all_around = 0).
    { rewrite <- (pull (dot n u) z), <- (pull (dot n z) u), <- sum_difference. etransitivity; [|exact k].
      apply sum_same. intros [p q] h. destruct (neighbours p q h) as (lp & lq & np & nq).
      unfold shares. simpl. apply pair_identity; auto; lra. }
    rewrite !(pull side). transitivity (side * (dot n u * sum_over (shares z) all_around)); [ring|].
    transitivity (side * (dot n z * sum_over (shares u) all_around)); [|ring]. f_equal. lra. }
  assert (below := sum_not_positive (fun e => side * shares z e) all_around (shares_down y ly behind)).
  destruct (neighbours p0 q0 h0) as (lp0 & _ & np0 & _).
  assert (level : sum_over (fun e => side * shares z e) all_around = 0).
  { assert (b := balance _ lp0).
    assert (g := sum_not_positive (fun e => side * shares (minus (corner p0) v) e) all_around
      (shares_down (corner p0) (lengths _ ip0) ltac:(intros; apply none_in_front; auto))).
    set (Z := sum_over (fun e => side * shares z e) all_around) in *.
    set (U := sum_over (fun e => side * shares (minus (corner p0) v) e) all_around) in *.
    assert (0 <= dot n (minus (corner p0) v) * Z).
    { replace (dot n (minus (corner p0) v) * Z) with ((- dot n (minus (corner p0) v)) * (- Z)) by ring.
      apply Rmult_le_pos; lra. }
    assert (0 <= dot n z * - U) by (apply Rmult_le_pos; lra).
    assert (zero : dot n (minus (corner p0) v) * Z = 0) by lra. destruct (Rmult_integral _ _ zero); lra. }
  destruct (some_behind f0 hf0) as (x & ix & less). assert (lx := lengths x ix).
  assert (b := balance (minus x v) ltac:(rewrite minus_length; congruence)). rewrite level in b.
  assert (g := shares_down x lx ltac:(intros; apply none_in_front; auto)).
  assert (strictly : side * shares (minus x v) (p0, q0) < 0).
  { destruct (neighbours p0 q0 h0) as (_ & _ & a1 & a2).
    assert (pos : 0 < / (dot n (minus (corner p0) v) * dot n (minus (corner q0) v))).
    { apply Rinv_0_lt_compat. replace (dot n (minus (corner p0) v) * dot n (minus (corner q0) v)) with
        ((- dot n (minus (corner p0) v)) * (- dot n (minus (corner q0) v))) by ring. apply Rmult_lt_0_compat; lra. }
    assert (e : side * shares (minus x v) (p0, q0) = / (dot n (minus (corner p0) v) * dot n (minus (corner q0) v)) *
      (side * rheight vertices f0 x)) by (rewrite height0 by auto; unfold shares; simpl; field; repeat split; lra).
    rewrite e.
    assert (0 < / (dot n (minus (corner p0) v) * dot n (minus (corner q0) v)) * - (side * rheight vertices f0 x))
      by (apply Rmult_lt_0_compat; lra).
    lra. }
  assert (g' := sum_negative (fun e => side * shares (minus x v) e) all_around (p0, q0) g h0 strictly).
  assert (0 < dot n z * - sum_over (fun e => side * shares (minus x v) e) all_around)
    by (apply Rmult_lt_0_compat; lra).
  lra.
Qed.
End mesh.
