(* SPDX-License-Identifier: Apache-2.0 *)
(** The specifications of the plane leave no choice: of one input no two different answers are true.
  So an accepted answer is
    not only a true one, it is the one. *)
Require Import Reals Lra Lia List.
From Certificates Require Import plane sound_plane sound_solids.
Open Scope R_scope.

Lemma beside_once : forall p0 p1 p t h u k, p0 <> p1 -> beside p0 p1 p t h -> beside p0 p1 p u k -> h = k.
Proof.
  intros [ax ay] [bx by_] [px py] t h u k ne. unfold beside; simpl.
  set (dx := bx - ax); set (dy := by_ - ay). intros [e f] [g i].
  assert (q : (h - k) * (dx * dx + dy * dy) = 0).
  { assert (x : (h - k) * dy = (t - u) * dx) by lra. assert (y : (h - k) * dx = - ((t - u) * dy)) by lra.
    transitivity ((h - k) * dx * dx + (h - k) * dy * dy); [ring|]. rewrite x, y; ring. }
  apply zero_product in q; [lra|]. intro z. apply ne. assert (a := square dx). assert (b := square dy).
  assert (zx : dx * dx = 0) by lra. assert (zy : dy * dy = 0) by lra.
  apply Rmult_integral in zx, zy. unfold dx, dy in zx, zy. rewrite same_points; lra.
Qed.

Theorem orientation_unique : forall p0 p1 p v w,
  orientation_spec p0 p1 p v -> orientation_spec p0 p1 p w -> v = w.
Proof.
  intros p0 p1 p.
  assert (on_0 : p0 <> p1 -> p0 = p1 \/ on_line (p0, p1) p -> exists t, beside p0 p1 p t 0).
  { intros ne [e | [t e]]; [tauto|]. exists t. destruct p0, p1, p. unfold along in e. rewrite same_points in e.
    unfold beside; simpl in *; lra. }
  assert (sign : forall w, orientation_spec p0 p1 p w -> p0 <> p1 ->
    exists t h, beside p0 p1 p t h /\ match w with left => 0 < h | right => h < 0 | on => h = 0 end).
  { intros w a ne; destruct w; simpl in a; [tauto | tauto |]. destruct (on_0 ne a) as [t b]. exists t, 0; auto. }
  intros v w a b.
  assert (same_or_not : p0 = p1 \/ p0 <> p1).
  { destruct p0 as [ax ay], p1 as [bx by_]. rewrite same_points.
    destruct (Req_dec ax bx), (Req_dec ay by_); tauto. }
  destruct same_or_not as [e | ne].
  - destruct v, w; simpl in a, b; auto; tauto.
  - destruct (sign v a ne) as (t & h & g & i), (sign w b ne) as (u & k & l & m).
    assert (x := beside_once _ _ _ _ _ _ _ ne g l). destruct v, w; auto; lra.
Qed.

Lemma parameter_once : forall s t u p, parameter s t p -> parameter s u p -> t = u.
Proof.
  intros [[ax ay] [bx by_]] t u p (_ & e & e0) (_ & f & f0). simpl in *. rewrite e in f. rewrite same_points in f.
  destruct (Req_dec (bx - ax) 0) as [zx | zx]; [destruct (Req_dec (by_ - ay) 0) as [zy | zy] |].
  - rewrite e0, f0; auto; rewrite same_points; lra.
  - apply (one_parameter ay (by_ - ay) t u (ay + u * (by_ - ay))); lra.
  - apply (one_parameter ax (bx - ax) t u (ax + u * (bx - ax))); lra.
Qed.

Theorem point_on_segment_unique : forall p s v w,
  point_on_segment_spec p s v -> point_on_segment_spec p s w -> v = w.
Proof.
  intros p s [|t] [|u]; simpl; auto.
  - intros no (h & e & _). exfalso; apply no. exists u; auto.
  - intros (h & e & _) no. exfalso; apply no. exists t; auto.
  - intros a b. f_equal. apply (parameter_once s t u p); auto.
Qed.

Lemma ends : forall p q : vec2 R, on_segment (p, q) p /\ on_segment (p, q) q.
Proof.
  intros [a b] [c d]; split; [exists 0 | exists 1]; (split; [lra|]); unfold along; rewrite same_points; split; ring.
Qed.

(** In a segment (p, q) with p before q, p is the first point and q the last. *)
Lemma first_last : forall p q x, before p q -> on_segment (p, q) x -> (x = p \/ before p x) /\ (x = q \/ before x q).
Proof.
  intros [px py] [qx qy] [x y] lex [t [ht e]]. unfold along in e. rewrite same_points in e |- *. unfold before in *;
    simpl in *.
  rewrite same_points. destruct e as [-> ->].
  destruct lex as [l | [<- l]].
  - assert (0 <= t * (qx - px)) by (apply Rmult_le_pos; lra). assert (0 <= (1 - t) * (qx - px)) by (apply
      Rmult_le_pos; lra).
    split.
    + destruct (Req_dec t 0) as [-> | n]; [left; lra | right; left].
      assert (0 < t * (qx - px)) by (apply Rmult_lt_0_compat; lra). lra.
    + destruct (Req_dec t 1) as [-> | n]; [left; lra | right; left].
      assert (0 < (1 - t) * (qx - px)) by (apply Rmult_lt_0_compat; lra). lra.
  - assert (z : px + t * (px - px) = px) by ring. rewrite z. split.
    + destruct (Req_dec t 0) as [-> | n]; [left; lra | right; right].
      assert (0 < t * (qy - py)) by (apply Rmult_lt_0_compat; lra). lra.
    + destruct (Req_dec t 1) as [-> | n]; [left; lra | right; right].
      assert (0 < (1 - t) * (qy - py)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.
Lemma before_not_after : forall p q, before p q -> before q p -> False.
Proof. unfold before; intros p q [a | [a b]] [c | [c d]]; lra. Qed.
Lemma before_not_same : forall p, ~ before p p.
Proof. unfold before; intros p [a | [a b]]; lra. Qed.

Theorem segment_segment_unique : forall a b v w,
  segment_segment_spec a b v -> segment_segment_spec a b w -> v = w.
Proof.
  intros a b v w g h; destruct v as [| ta tb p | p q], w as [| sa sb r | r s]; auto; simpl in g, h.
  - exfalso. destruct h as [h _]. apply (g r), h; auto.
  - exfalso. destruct h as [h _]. apply (g r), h, ends.
  - exfalso. destruct g as [g _]. apply (h p), g; auto.
  - destruct g as (g & ga & gb), h as (h & ha & hb). assert (e : p = r) by (apply h, g; auto). subst r.
    rewrite (parameter_once a ta sa p), (parameter_once b tb sb p); auto.
  - exfalso. destruct g as (g & _), h as (h & lex). assert (r = p) by (apply g, h, ends).
      assert (s = p) by (apply g, h, ends).
    subst. apply (before_not_same p); auto.
  - exfalso. destruct g as (g & _). apply (h p), g, ends.
  - exfalso. destruct g as (g & lex), h as (h & _). assert (e : p = r) by (apply h, g, ends).
      assert (f : q = r) by (apply h, g, ends).
    subst. apply (before_not_same r); auto.
  - destruct g as (g & lex), h as (h & lex').
    assert (pr : on_segment (r, s) p) by (apply h, g, ends). assert (qr : on_segment (r, s) q) by (apply h, g, ends).
    assert (rp : on_segment (p, q) r) by (apply g, h, ends). assert (sp : on_segment (p, q) s) by (apply g, h, ends).
    apply first_last in pr, qr, rp, sp; auto.
    assert (e : p = r).
    { destruct pr as [[e | pr] _]; auto. destruct rp as [[e | rp] _]; auto. exfalso; apply (before_not_after p r);
        auto. }
    assert (f : q = s).
    { destruct qr as [_ [f | qr]]; auto. destruct sp as [_ [f | sp]]; auto. exfalso; apply (before_not_after q s);
        auto. }
    subst; auto.
Qed.

Lemma line_parameter_once : forall s t u p, fst s <> snd s -> p = along s t -> p = along s u -> t = u.
Proof.
  intros [[ax ay] [bx by_]] t u p ne e f. simpl in *. rewrite e in f. rewrite same_points in f, ne.
  destruct (Req_dec (bx - ax) 0) as [zx | zx]; [destruct (Req_dec (by_ - ay) 0) as [zy | zy] |].
  - exfalso; apply ne; lra.
  - apply (one_parameter ay (by_ - ay) t u (ay + u * (by_ - ay))); lra.
  - apply (one_parameter ax (bx - ax) t u (ax + u * (bx - ax))); lra.
Qed.
Theorem line_line_unique : forall a b v w, line_line_spec a b v -> line_line_spec a b w -> v = w.
Proof.
  intros a b v w (na & nb & g) (_ & _ & h).
  assert (two : forall s, on_line s (along s 0) /\ on_line s (along s 1)).
  { intro s; split; [exists 0 | exists 1]; auto. }
  assert (only_one : forall p, (forall x, on_line a x /\ on_line b x <-> x = p) -> ~ (forall x,
    on_line a x <-> on_line b x)).
  { intros p one sm. assert (e : along a 0 = p) by (apply one; rewrite <- sm; split; apply two).
    assert (f : along a 1 = p) by (apply one; rewrite <- sm; split; apply two).
    assert (0 = 1) by (apply (line_parameter_once a 0 1 p); auto). lra. }
  destruct v as [ta tb p | |], w as [sa sb r | |]; auto.
  - destruct g as (g & ga & gb), h as (h & ha & hb). assert (e : p = r) by (apply h, g; auto). rewrite <- e in *.
    rewrite (line_parameter_once a ta sa p), (line_parameter_once b tb sb p); auto.
  - exfalso. destruct g as (g & _). apply (h p), g; auto.
  - exfalso. destruct g as (g & _). apply (only_one p); auto.
  - exfalso. destruct h as (h & _). apply (g r), h; auto.
  - exfalso. apply (g (along a 0)). rewrite <- h. split; apply two.
  - exfalso. destruct h as (h & _). apply (only_one r); auto.
  - exfalso. apply (h (along a 0)). rewrite <- g. split; apply two.
Qed.

Lemma ray_parameter_once : forall o d t u p, d <> (0, 0) -> on_ray_at o d t p -> on_ray_at o d u p -> t = u.
Proof.
  intros [ox oy] [dx dy] t u p ne [_ e] [_ f]. simpl in *. rewrite e in f. rewrite same_points in f, ne.
  destruct (Req_dec dx 0) as [zx | zx]; [destruct (Req_dec dy 0) as [zy | zy] |].
  - exfalso; apply ne; auto.
  - apply (one_parameter oy dy t u (oy + u * dy)); lra.
  - apply (one_parameter ox dx t u (ox + u * dx)); lra.
Qed.
(** Points of a segment whose ends are on a ray are there in between. *)
Lemma ray_between : forall o d t u p q x, on_ray_at o d t p -> on_ray_at o d u q -> t < u -> on_segment (p, q) x ->
  exists r, on_ray_at o d r x /\ t <= r <= u.
Proof.
  intros [ox oy] [dx dy] t u [px py] [qx qy] [x y] [ht e] [hu f] lt [l [hl g]]. simpl in *. unfold along in g.
  rewrite same_points in e, f, g. exists (t + l * (u - t)).
  assert (0 <= l * (u - t)) by (apply Rmult_le_pos; lra). assert (0 <= (1 - l) * (u - t)) by (apply Rmult_le_pos; lra).
  split; [| lra]. unfold on_ray_at; simpl. split; [lra |].
  rewrite same_points, (proj1 g), (proj2 g), (proj1 e), (proj2 e), (proj1 f), (proj2 f). split; ring.
Qed.
Theorem ray_segment_unique : forall o d s v w, ray_segment_spec o d s v -> ray_segment_spec o d s w -> v = w.
Proof.
  intros o d s v w (nz & g) (_ & h). destruct v as [| t p | t p q], w as [| u r | u r k]; auto.
  - exfalso. destruct h as [h _]. apply (g r), h; auto.
  - exfalso. destruct h as [h _]. apply (g r), h, ends.
  - exfalso. destruct g as [g _]. apply (h p), g; auto.
  - destruct g as [g ga], h as [h ha]. assert (e : p = r) by (apply h, g; auto). subst r.
    rewrite (ray_parameter_once o d t u p); auto.
  - exfalso. destruct g as [g ga], h as (h & ha & l & lt & hb). assert (e : r = p) by (apply g, h, ends).
    assert (f : k = p) by (apply g, h, ends). subst. assert (u = l) by (apply (ray_parameter_once o d u l p);
      auto). lra.
  - exfalso. destruct g as [g _]. apply (h p), g, ends.
  - exfalso. destruct h as [h ha], g as (g & ga & l & lt & gb). assert (e : p = r) by (apply h, g, ends).
    assert (f : q = r) by (apply h, g, ends). subst. assert (t = l) by (apply (ray_parameter_once o d t l r);
      auto). lra.
  - destruct g as (g & ga & l & lt & gb), h as (h & ha & m & mt & hb).
    destruct (ray_between o d t l p q r) as (x1 & y1 & z1); auto; [apply g, h, ends|].
    destruct (ray_between o d t l p q k) as (x2 & y2 & z2); auto; [apply g, h, ends|].
    destruct (ray_between o d u m r k p) as (x3 & y3 & z3); auto; [apply h, g, ends|].
    destruct (ray_between o d u m r k q) as (x4 & y4 & z4); auto; [apply h, g, ends|].
    assert (x1 = u) by (apply (ray_parameter_once o d x1 u r); auto).
    assert (x2 = m) by (apply (ray_parameter_once o d x2 m k); auto).
    assert (x3 = t) by (apply (ray_parameter_once o d x3 t p); auto).
    assert (x4 = l) by (apply (ray_parameter_once o d x4 l q); auto).
    assert (eu : t = u) by lra. assert (em : l = m) by lra.
    assert (e : p = r) by (rewrite (proj2 ga), (proj2 ha), eu;
      auto). assert (f : q = k) by (rewrite (proj2 gb), (proj2 hb), em; auto).
    rewrite e, f, eu; auto.
Qed.
