(* SPDX-License-Identifier: Apache-2.0 *)
(** The formulas of the plane are enough. *)
Require Import Reals Qreals QArith Lra List.
From Certificates Require Import plane language formulas_plane.
Open Scope R_scope.

Definition r2 (p : vec2 Q) : vec2 R := (Q2R (fst p), Q2R (snd p)).
Definition rs (s : seg2 Q) : seg2 R := (r2 (fst s), r2 (snd s)).
Definition r_incidence (w : incidence Q) : incidence R :=
  match w with off => off | at_parameter t => at_parameter (Q2R t) end.
Definition r_meeting (w : meeting Q) : meeting R :=
  match w with
  | apart => apart | point ta tb p => point (Q2R ta) (Q2R tb) (r2 p) | overlap p q => overlap (r2 p) (r2 q) end.
Definition r_lines (w : lines Q) : lines R :=
  match w with crossing ta tb p => crossing (Q2R ta) (Q2R tb) (r2 p) | parallel => parallel | same => same end.

(** Real geometry: what a linear form or a parameter says of a segment *)
Lemma along_form : forall nx ny ax ay bx by_ t x y, (x, y) = along ((ax, ay), (bx, by_)) t ->
  nx * x + ny * y = (1 - t) * (nx * ax + ny * ay) + t * (nx * bx + ny * by_).
Proof. unfold along; intros until y; intro h; injection h; intros -> ->; ring. Qed.

Lemma mix_lt : forall t a b c, 0 <= t <= 1 -> a < c -> b < c -> (1 - t) * a + t * b < c.
Proof. intros; destruct (Req_dec t 0); [subst; lra|]. assert (0 < t * (c - b)) by (apply Rmult_lt_0_compat; lra).
  assert (0 <= (1 - t) * (c - a)) by (apply Rmult_le_pos; lra). lra. Qed.
Lemma mix_le : forall t a b c, 0 <= t <= 1 -> a <= c -> b <= c -> (1 - t) * a + t * b <= c.
Proof. intros. assert (0 <= t * (c - b)) by (apply Rmult_le_pos; lra).
  assert (0 <= (1 - t) * (c - a)) by (apply Rmult_le_pos; lra). lra. Qed.
Lemma mix_gt : forall t a b c, 0 <= t <= 1 -> c < a -> c < b -> c < (1 - t) * a + t * b.
Proof. intros. assert (h := mix_lt t (- a) (- b) (- c)). lra. Qed.
Lemma mix_ge : forall t a b c, 0 <= t <= 1 -> c <= a -> c <= b -> c <= (1 - t) * a + t * b.
Proof. intros. assert (h := mix_le t (- a) (- b) (- c)). lra. Qed.

Lemma same_points : forall x y u v : R, (x, y) = (u, v) <-> x = u /\ y = v.
Proof. split; [intro h; injection h; auto | intros [-> ->]; auto]. Qed.

Lemma zero_product : forall a b, a * b = 0 -> b <> 0 -> a = 0.
Proof. intros a b h k; destruct (Rmult_integral _ _ h); tauto. Qed.

(** Two points of a line with the same level of a form that is not constant on it have one parameter. *)
Lemma one_parameter : forall a d s t c, a + s * d = c -> a + t * d = c -> d <> 0 -> s = t.
Proof. intros. assert ((s - t) * d = 0) by lra. apply zero_product in H2; auto. lra. Qed.

Ltac start h := apply decide_means in h; unfold not_parallel, at_parameter_of, same_point, within, end_of_one, cross,
  level, X, Y in h;
  simpl in h.

Theorem orientation_sound : forall p0 p1 p w d, decide (check_orientation p0 p1 p w d) = true ->
  orientation_spec (r2 p0) (r2 p1) (r2 p) w.
Proof.
  intros [ax ay] [bx by_] [px py] w d h; start h.
  unfold orientation_spec, r2, on_line, along, beside; simpl.
  set (dx := Q2R bx - Q2R ax) in *; set (dy := Q2R by_ - Q2R ay) in *.
  set (ex := Q2R px - Q2R ax) in *; set (ey := Q2R py - Q2R ay) in *.
  set (q := dx * dx + dy * dy).
  assert (base : (Q2R ax, Q2R ay) = (Q2R bx, Q2R by_) \/ (~ (Q2R ax, Q2R ay) = (Q2R bx, Q2R by_) /\ 0 < q)).
  { destruct (Req_dec dx 0), (Req_dec dy 0); [left | right | right | right].
    - rewrite same_points; unfold dx, dy in *; lra.
    - split; [rewrite same_points; unfold dx, dy in *; lra | unfold q; nra].
    - split; [rewrite same_points; unfold dx, dy in *; lra | unfold q; nra].
    - split; [rewrite same_points; unfold dx, dy in *; lra | unfold q; nra]. }
  destruct h as [hd hw].
  assert (put : 0 < q -> forall h, h = (dx * ey - dy * ex) / q ->
     Q2R px = Q2R ax + (dx * ex + dy * ey) / q * dx + h * - dy /\
     Q2R py = Q2R ay + (dx * ex + dy * ey) / q * dy + h * dx).
  { intros hq h ->.
    replace (Q2R px) with (Q2R ax + ex) by (unfold ex; ring).
    replace (Q2R py) with (Q2R ay + ey) by (unfold ey; ring).
    unfold q in *; split; field; lra. }
  assert (zero_q : (Q2R ax, Q2R ay) = (Q2R bx, Q2R by_) -> dx * ey - dy * ex = 0).
  { rewrite same_points; intros [e f]. assert (dx = 0) by (unfold dx; lra). assert (dy = 0) by (unfold dy; lra).
    rewrite H, H0; ring. }
  destruct w; simpl in hw; rewrite hd in hw.
  - destruct base as [e | [e hq]]; [apply zero_q in e; lra|]. split; auto.
    eexists; exists ((dx * ey - dy * ex) / q). split; [apply put; auto|].
    apply Rdiv_lt_0_compat; lra.
  - destruct base as [e | [e hq]]; [apply zero_q in e; lra|]. split; auto.
    eexists; exists ((dx * ey - dy * ex) / q). split; [apply put; auto|].
    assert (0 < (- (dx * ey - dy * ex)) / q) by (apply Rdiv_lt_0_compat; lra).
    unfold Rdiv in *; lra.
  - destruct base as [e | [e hq]]; [left; auto | right].
    exists ((dx * ex + dy * ey) / q). rewrite same_points.
    destruct (put hq 0) as [f g]; [rewrite hw; unfold Rdiv; ring|]. lra.
Qed.

Theorem point_on_segment_sound : forall p s w facts, decide (check_point_on_segment p s w facts) = true ->
  point_on_segment_spec (r2 p) (rs s) (r_incidence w).
Proof.
  intros [px py] [[ax ay] [bx by_]] w facts h; destruct w, facts; start h; try tauto;
  unfold point_on_segment_spec, parameter, on_segment, r_incidence, rs, r2; simpl.
  - intros [t [ht e]].
    assert (f := along_form (Q2R (fst normal)) (Q2R (snd normal)) _ _ _ _ _ _ _ e).
    assert (g := mix_gt t (Q2R (fst normal) * Q2R ax + Q2R (snd normal) * Q2R ay) (Q2R (fst normal) * Q2R bx + Q2R
      (snd normal) * Q2R by_) (Q2R offset)).
    lra.
  - assert (e : Q2R wa = 1 - Q2R wb) by lra. rewrite e in h. rewrite !same_points. split; [lra|].
    assert (ht : Q2R t = Q2R wb) by tauto. rewrite ht in *. split.
    + split; lra.
    + intro same. tauto.
Qed.

Lemma from_end_0 : forall s s0 s1, s0 = 0 -> 0 <= s <= 1 -> 0 <= s1 <= 1 -> s1 - s0 <> 0 -> 0 <= (s - s0) / (s1 - s0).
Proof. intros s s0 s1 -> hs h1 ne. unfold Rdiv. apply Rmult_le_pos; [lra|]. left; apply Rinv_0_lt_compat; lra. Qed.
Lemma from_end_1 : forall s s0 s1, s0 = 1 -> 0 <= s <= 1 -> 0 <= s1 <= 1 -> s1 - s0 <> 0 -> 0 <= (s - s0) / (s1 - s0).
Proof. intros s s0 s1 -> hs h1 ne. replace ((s - 1) / (s1 - 1)) with ((1 - s) / (1 - s1)) by (field; lra).
  unfold Rdiv. apply Rmult_le_pos; [lra|]. left; apply Rinv_0_lt_compat; lra. Qed.

Theorem segment_segment_sound : forall a b w facts, decide (check_segment_segment a b w facts) = true ->
  segment_segment_spec (rs a) (rs b) (r_meeting w).
Proof.
  intros [[ax ay] [bx by_]] [[cx cy] [dx dy]] w facts h.
  destruct w as [| ta tb [px py] | [px py] [qx qy]]; destruct facts; start h; try tauto;
  unfold segment_segment_spec, parameter, on_segment, r_meeting, rs, r2; simpl fst; simpl snd.
  - (* separating line *)
    intros [x y] [[s [hs e]] [t [ht f]]]. destruct normal as [nx ny]; simpl in h.
    apply (along_form (Q2R nx) (Q2R ny)) in e; apply (along_form (Q2R nx) (Q2R ny)) in f.
    assert (g := mix_lt s (Q2R nx * Q2R ax + Q2R ny * Q2R ay) (Q2R nx * Q2R bx + Q2R ny * Q2R by_) (Q2R offset)).
    assert (k := mix_gt t (Q2R nx * Q2R cx + Q2R ny * Q2R cy) (Q2R nx * Q2R dx + Q2R ny * Q2R dy) (Q2R offset)).
    lra.
  - (* transversal *)
    destruct h as (wa & wb & pa & pb & za & zb & hd). unfold along. split; [| rewrite !same_points; tauto].
    intros [x y]; split.
    + intros [[s [hs e]] [t [ht f]]]. rewrite same_points in e, f |- *.
      assert (z : (s - Q2R ta) * Q2R determinant = 0).
      { destruct hd as [-> _]. 
        assert (u : (s - Q2R ta) * (Q2R bx - Q2R ax) = (t - Q2R tb) * (Q2R dx - Q2R cx)) by lra.
        assert (v : (s - Q2R ta) * (Q2R by_ - Q2R ay) = (t - Q2R tb) * (Q2R dy - Q2R cy)) by lra.
        transitivity ((s - Q2R ta) * (Q2R bx - Q2R ax) * (Q2R dy - Q2R cy) - (s - Q2R ta) * (Q2R by_ - Q2R ay) * (Q2R
          dx - Q2R cx)); [ring|].
        rewrite u, v; ring. }
      apply zero_product in z; [|tauto]. replace s with (Q2R ta) in e by lra. lra.
    + intros ->; split; [exists (Q2R ta) | exists (Q2R tb)]; rewrite same_points; tauto.
  - (* single point *)
    destruct h as (wa & wb & pa & pb & za & zb & hd). unfold along. split; [| rewrite !same_points; tauto].
    intros [x y]; split.
    + intros [[s [hs e]] [t [ht f]]]. rewrite same_points in e, f |- *.
      destruct hd as [[g k] | [g k]]; rewrite g, k in *; lra.
    + intros ->; split; [exists (Q2R ta) | exists (Q2R tb)]; rewrite same_points; tauto.
  - (* supporting line *)
    destruct normal as [nx ny]; simpl in h.
    destruct h as (wa & wb & pa & pb & za & zb & hd). split; [| unfold along; rewrite !same_points; tauto].
    intros [x y]; split.
    + intros [[s [hs e]] [t [ht f]]].
      assert (la : (Q2R px, Q2R py) = along (Q2R ax, Q2R ay, (Q2R bx, Q2R by_)) (Q2R ta)) by (unfold along;
        rewrite same_points; tauto).
      assert (lb : (Q2R px, Q2R py) = along (Q2R cx, Q2R cy, (Q2R dx, Q2R dy)) (Q2R tb)) by (unfold along;
        rewrite same_points; tauto).
      assert (e' := along_form (Q2R nx) (Q2R ny) _ _ _ _ _ _ _ e);
        assert (f' := along_form (Q2R nx) (Q2R ny) _ _ _ _ _ _ _ f).
      assert (la' := along_form (Q2R nx) (Q2R ny) _ _ _ _ _ _ _ la);
        assert (lb' := along_form (Q2R nx) (Q2R ny) _ _ _ _ _ _ _ lb).
      set (A0 := Q2R nx * Q2R ax + Q2R ny * Q2R ay) in *; set (A1 := Q2R nx * Q2R bx + Q2R ny * Q2R by_) in *.
      set (B0 := Q2R nx * Q2R cx + Q2R ny * Q2R cy) in *; set (B1 := Q2R nx * Q2R dx + Q2R ny * Q2R dy) in *.
      assert (g := mix_le s A0 A1 (Q2R offset)). assert (k := mix_ge t B0 B1 (Q2R offset)).
      assert (g' := mix_le (Q2R ta) A0 A1 (Q2R offset)). assert (k' := mix_ge (Q2R tb) B0 B1 (Q2R offset)).
      destruct hd as [ha1 [ha2 [hb1 [hb2 hd]]]]. destruct hd as [hd | hd].
      * assert (A1 - A0 <> 0) by (intro z; apply hd; replace A1 with A0 in * by lra; lra).
        assert (s = Q2R ta) by (apply (one_parameter A0 (A1 - A0) s (Q2R ta) (Q2R offset)); auto; lra).
        subst s. rewrite e, la; auto.
      * assert (B1 - B0 <> 0) by (intro z; apply hd; replace B1 with B0 in * by lra; lra).
        assert (t = Q2R tb) by (apply (one_parameter B0 (B1 - B0) t (Q2R tb) (Q2R offset)); auto; lra).
        subst t. rewrite f, lb; auto.
    + intros ->; split; [exists (Q2R ta) | exists (Q2R tb)]; unfold along; rewrite same_points; tauto.
  - (* overlap *)
    destruct on_a as [s0 s1], on_b as [u0 u1]; simpl in h.
    destruct h as (lex & (S0 & S0') & (S1 & S1') & (U0 & U0') & (U1 & U1') & (pax & pay) & (qax & qay) & (pbx & pby)
      & (qbx & qby) & e0 & e1).
    split; [| unfold before; simpl; tauto].
    set (ux := Q2R bx - Q2R ax) in *; set (uy := Q2R by_ - Q2R ay) in *.
    set (vx := Q2R dx - Q2R cx) in *; set (vy := Q2R dy - Q2R cy) in *.
    assert (differ : Q2R px <> Q2R qx \/ Q2R py <> Q2R qy) by (destruct lex as [l | [_ l]]; [left | right]; lra).
    assert (ds : Q2R s1 - Q2R s0 <> 0).
    { intro z. assert (e : Q2R s1 = Q2R s0) by lra. rewrite e in *. lra. }
    assert (du : Q2R u1 - Q2R u0 <> 0).
    { intro z. assert (e : Q2R u1 = Q2R u0) by lra. rewrite e in *. lra. }
    intros [x y]; split.
    + intros [[s [hs e]] [t [ht f]]].
      fold ux uy in e. unfold along in e, f. fold ux uy in e. fold vx vy in f. rewrite same_points in e, f.
      set (l := (s - Q2R s0) / (Q2R s1 - Q2R s0)). set (m := (t - Q2R u0) / (Q2R u1 - Q2R u0)).
      assert (sl : s = Q2R s0 + l * (Q2R s1 - Q2R s0)) by (unfold l; field; auto).
      assert (tm : t = Q2R u0 + m * (Q2R u1 - Q2R u0)) by (unfold m; field; auto).
      assert (lx : x = Q2R px + l * (Q2R qx - Q2R px)) by (rewrite (proj1 e), pax, qax, sl; ring).
      assert (ly : y = Q2R py + l * (Q2R qy - Q2R py)) by (rewrite (proj2 e), pay, qay, sl; ring).
      assert (mx : x = Q2R px + m * (Q2R qx - Q2R px)) by (rewrite (proj1 f), pbx, qbx, tm; ring).
      assert (my : y = Q2R py + m * (Q2R qy - Q2R py)) by (rewrite (proj2 f), pby, qby, tm; ring).
      assert (lm : l = m).
      { destruct differ; [apply (one_parameter (Q2R px) (Q2R qx - Q2R px) l m x) | apply (one_parameter (Q2R py) (Q2R
          qy - Q2R py) l m y)]; lra. }
      exists l. split; [split |unfold along; rewrite same_points; auto].
      * destruct e0 as [e0 | [e0 | [e0 | e0]]]; [| | rewrite lm | rewrite lm];
          [eapply from_end_0 | eapply from_end_1 | eapply from_end_0 | eapply from_end_1]; eauto; lra.
      * cut (0 <= 1 - l); [lra|].
        assert (ml : 1 - l = (s - Q2R s1) / (Q2R s0 - Q2R s1)) by (unfold l; field; lra).
        assert (mm : 1 - m = (t - Q2R u1) / (Q2R u0 - Q2R u1)) by (unfold m; field; lra).
        destruct e1 as [e1 | [e1 | [e1 | e1]]]; [rewrite ml | rewrite ml | rewrite lm, mm | rewrite lm, mm];
          [apply (from_end_0 s (Q2R s1) (Q2R s0)) | apply (from_end_1 s (Q2R s1) (Q2R s0)) |
           apply (from_end_0 t (Q2R u1) (Q2R u0)) | apply (from_end_1 t (Q2R u1) (Q2R u0))]; lra.
    + intros [l [hl e]]. unfold along in e; rewrite same_points in e. destruct e as [ex ey]. split.
      * exists (Q2R s0 + l * (Q2R s1 - Q2R s0)).
        assert (r := mix_le l (Q2R s0) (Q2R s1) 1). assert (r' := mix_ge l (Q2R s0) (Q2R s1) 0).
        split; [lra|]. unfold along; rewrite same_points; fold ux uy. rewrite ex, ey, pax, pay, qax, qay. split; ring.
      * exists (Q2R u0 + l * (Q2R u1 - Q2R u0)).
        assert (r := mix_le l (Q2R u0) (Q2R u1) 1). assert (r' := mix_ge l (Q2R u0) (Q2R u1) 0).
        split; [lra|]. unfold along; rewrite same_points; fold vx vy. rewrite ex, ey, pbx, pby, qbx, qby. split; ring.
Qed.

Theorem line_line_sound : forall a b w facts, decide (check_line_line a b w facts) = true ->
  line_line_spec (rs a) (rs b) (r_lines w).
Proof.
  intros [[ax ay] [bx by_]] [[cx cy] [dx dy]] w facts h.
  destruct w as [ta tb [px py] | |]; destruct facts; start h; try tauto;
  unfold line_line_spec, on_line, r_lines, rs, r2; simpl fst; simpl snd; rewrite !same_points;
  destruct h as (na & nb & h); (split; [auto|]); (split; [auto|]).
  - (* transversal *)
    destruct h as (hd & pa & pb). unfold along. split; [| rewrite !same_points; tauto].
    intros [x y]; split.
    + intros [[s e] [t f]]. rewrite same_points in e, f |- *.
      assert (z : (s - Q2R ta) * Q2R determinant = 0).
      { destruct hd as [-> _].
        assert (u : (s - Q2R ta) * (Q2R bx - Q2R ax) = (t - Q2R tb) * (Q2R dx - Q2R cx)) by lra.
        assert (v : (s - Q2R ta) * (Q2R by_ - Q2R ay) = (t - Q2R tb) * (Q2R dy - Q2R cy)) by lra.
        transitivity ((s - Q2R ta) * (Q2R bx - Q2R ax) * (Q2R dy - Q2R cy) - (s - Q2R ta) * (Q2R by_ - Q2R ay) * (Q2R
          dx - Q2R cx)); [ring|].
        rewrite u, v; ring. }
      apply zero_product in z; [|tauto]. replace s with (Q2R ta) in e by lra. lra.
    + intros ->; split; [exists (Q2R ta) | exists (Q2R tb)]; rewrite same_points; tauto.
  - (* two levels *)
    intros [x y] [[s e] [t f]]. destruct normal as [nx ny]; simpl in h.
    apply (along_form (Q2R nx) (Q2R ny)) in e; apply (along_form (Q2R nx) (Q2R ny)) in f.
    destruct h as (ha & hb & h). rewrite <- ha in e; rewrite <- hb in f. apply h. lra.
  - (* same line *)
    destruct on_a as [s t]; simpl in h. destruct h as ((cx' & cy') & (dx' & dy')).
    assert (st : Q2R t - Q2R s <> 0).
    { intro z. assert (e : Q2R t = Q2R s) by lra. rewrite e in *. apply nb; lra. }
    intros [x y]; split; intros [r e]; unfold along in *; rewrite same_points in e.
    + exists ((r - Q2R s) / (Q2R t - Q2R s)). rewrite same_points.
      rewrite (proj1 e), (proj2 e), cx', cy', dx', dy'. split; field; auto.
    + exists (Q2R s + r * (Q2R t - Q2R s)). rewrite same_points.
      rewrite (proj1 e), (proj2 e), cx', cy', dx', dy'. split; ring.
Qed.

Definition r_hit (w : hit Q) : hit R :=
  match w with
  | missed => missed | hit_point t p => hit_point (Q2R t) (r2 p) | hit_overlap t p q => hit_overlap (Q2R t) (r2 p)
    (r2 q)
  end.

Theorem ray_segment_sound : forall o d s w facts, decide (check_ray_segment o d s w facts) = true ->
  ray_segment_spec (r2 o) (r2 d) (rs s) (r_hit w).
Proof.
  intros [ox oy] [vx vy] [[ax ay] [bx by_]] w facts h.
  destruct w as [| t [px py] | t [px py] [qx qy]]; destruct facts; start h; try tauto; unfold ray_at, X, Y in h;
    simpl in h;
  unfold ray_segment_spec, on_ray, on_ray_at, on_segment, r_hit, rs, r2; simpl fst; simpl snd; rewrite !same_points;
  destruct h as (nz & h); (split; [replace 0 with (IZR 0) by reflexivity; tauto |]).
  - (* separating line *)
    destruct normal as [nx ny]; simpl in h. destruct h as (ho & hv & ha & hb).
    intros [x y] [[u [hu e]] [s [hs f]]]. rewrite same_points in e.
    apply (along_form (Q2R nx) (Q2R ny)) in f.
    assert (k := mix_gt s (Q2R nx * Q2R ax + Q2R ny * Q2R ay) (Q2R nx * Q2R bx + Q2R ny * Q2R by_) (Q2R offset) hs ha
      hb).
    assert (0 <= u * - (Q2R nx * Q2R vx + Q2R ny * Q2R vy)) by (apply Rmult_le_pos; lra).
    rewrite (proj1 e), (proj2 e) in f. lra.
  - (* transversal *)
    destruct h as ((ht & pr) & hs & ps & hd & hz). split; [| tauto].
    intros [x y]; split.
    + intros [[u [hu e]] [s [hs' f]]]. unfold along in f. rewrite same_points in e, f |- *.
      assert (z : (u - Q2R t) * Q2R determinant = 0).
      { rewrite hd.
        assert (a : (u - Q2R t) * Q2R vx = (s - Q2R su) * (Q2R bx - Q2R ax)) by lra.
        assert (b : (u - Q2R t) * Q2R vy = (s - Q2R su) * (Q2R by_ - Q2R ay)) by lra.
        transitivity ((u - Q2R t) * Q2R vx * (Q2R by_ - Q2R ay) - (u - Q2R t) * Q2R vy * (Q2R bx - Q2R ax)); [ring|].
        rewrite a, b; ring. }
      apply zero_product in z; auto. replace u with (Q2R t) in e by lra. lra.
    + intros ->; split; [exists (Q2R t) | exists (Q2R su)]; unfold along; rewrite same_points; tauto.
  - (* single point *)
    destruct h as ((ht & pr) & (sx & sy) & (ex & ey)). split; [| tauto].
    intros [x y]; split.
    + intros [_ [s [hs f]]]. unfold along in f. rewrite same_points in f |- *. rewrite sx, sy in *. lra.
    + intros ->; split; [exists (Q2R t) | exists 0]; unfold along; rewrite same_points; [tauto | lra].
  - (* supporting line *)
    destruct normal as [nx ny]; simpl in h.
    destruct h as ((ht & pr) & hs & ps & ho & hv & ha & hb & hd). split; [| tauto].
    intros [x y]; split.
    + intros [[u [hu e]] [s [hs' f]]]. assert (f0 := f). unfold along in f. rewrite same_points in e, f |- *.
      apply (along_form (Q2R nx) (Q2R ny)) in f0.
      assert (g : (Q2R px, Q2R py) = along (Q2R ax, Q2R ay, (Q2R bx, Q2R by_)) (Q2R su)) by (unfold along;
        rewrite same_points; tauto).
      apply (along_form (Q2R nx) (Q2R ny)) in g.
      set (O := Q2R nx * Q2R ox + Q2R ny * Q2R oy) in *. set (V := Q2R nx * Q2R vx + Q2R ny * Q2R vy) in *.
      assert (e' : Q2R nx * x + Q2R ny * y = O + u * V) by (rewrite (proj1 e), (proj2 e); unfold O, V; ring).
      assert (pr' : Q2R nx * Q2R px + Q2R ny * Q2R py = O + Q2R t * V) by (rewrite (proj1 pr), (proj2 pr);
        unfold O, V; ring).
      assert (0 <= u * - V) by (apply Rmult_le_pos; lra). assert (0 <= Q2R t * - V) by (apply Rmult_le_pos; lra).
      set (A0 := Q2R nx * Q2R ax + Q2R ny * Q2R ay) in *; set (A1 := Q2R nx * Q2R bx + Q2R ny * Q2R by_) in *.
      assert (k := mix_ge s A0 A1 (Q2R offset) hs' ha hb). assert (k' := mix_ge (Q2R su) A0 A1 (Q2R offset) hs ha hb).
      destruct hd as [hd | hd].
      * assert (u = Q2R t) by (apply (one_parameter O V u (Q2R t) (Q2R offset)); lra). subst u. lra.
      * assert (A1 - A0 <> 0) by (intro z; apply hd; replace A1 with A0 in * by lra; lra).
        assert (s = Q2R su) by (apply (one_parameter A0 (A1 - A0) s (Q2R su) (Q2R offset)); auto; lra).
        subst s. lra.
    + intros ->; split; [exists (Q2R t) | exists (Q2R su)]; unfold along; rewrite same_points; tauto.
  - (* overlap *)
    destruct ts as [t0 t1], us as [u0 u1]; simpl in h.
    destruct h as (et & lt & (T0 & pr) & (T1 & qr) & U0 & U1 & ps & qs & e0 & e1). rewrite et in *.
    assert (differ : Q2R px <> Q2R qx \/ Q2R py <> Q2R qy).
    { destruct (Req_dec (Q2R vx) 0) as [zx | zx]; [right | left].
      - assert (zy : Q2R vy <> 0) by (intro zy; apply nz; auto).
        intro e. apply zy. apply (zero_product (Q2R vy) (Q2R t1 - Q2R t0)); lra.
      - intro e. apply zx. apply (zero_product (Q2R vx) (Q2R t1 - Q2R t0)); lra. }
    assert (du : Q2R u1 - Q2R u0 <> 0).
    { intro z. assert (e : Q2R u1 = Q2R u0) by lra. rewrite e in *. lra. }
    split; [| split; [tauto | exists (Q2R t1); rewrite same_points; tauto]].
    intros [x y]; split.
    + intros [[r [hr e]] [s [hs f]]]. unfold along in f. rewrite same_points in e, f.
      set (l := (r - Q2R t0) / (Q2R t1 - Q2R t0)). set (m := (s - Q2R u0) / (Q2R u1 - Q2R u0)).
      assert (rl : r = Q2R t0 + l * (Q2R t1 - Q2R t0)) by (unfold l; field; lra).
      assert (sm : s = Q2R u0 + m * (Q2R u1 - Q2R u0)) by (unfold m; field; lra).
      assert (lx : x = Q2R px + l * (Q2R qx - Q2R px)) by (rewrite (proj1 e), (proj1 pr), (proj1 qr), rl; ring).
      assert (ly : y = Q2R py + l * (Q2R qy - Q2R py)) by (rewrite (proj2 e), (proj2 pr), (proj2 qr), rl; ring).
      assert (mx : x = Q2R px + m * (Q2R qx - Q2R px)) by (rewrite (proj1 f), (proj1 ps), (proj1 qs), sm; ring).
      assert (my : y = Q2R py + m * (Q2R qy - Q2R py)) by (rewrite (proj2 f), (proj2 ps), (proj2 qs), sm; ring).
      assert (lm : l = m).
      { destruct differ; [apply (one_parameter (Q2R px) (Q2R qx - Q2R px) l m x) | apply (one_parameter (Q2R py) (Q2R
          qy - Q2R py) l m y)]; lra. }
      exists l. split; [split | unfold along; rewrite same_points; auto].
      * destruct e0 as [e0 | [e0 | e0]].
        -- unfold l, Rdiv. apply Rmult_le_pos; [lra|]. left; apply Rinv_0_lt_compat; lra.
        -- rewrite lm. eapply from_end_0; eauto; lra.
        -- rewrite lm. eapply from_end_1; eauto; lra.
      * cut (0 <= 1 - l); [lra|]. rewrite lm.
        replace (1 - m) with ((s - Q2R u1) / (Q2R u0 - Q2R u1)) by (unfold m; field; lra).
        destruct e1 as [e1 | e1]; [apply from_end_0 | apply from_end_1]; auto; lra.
    + intros [l [hl e]]. unfold along in e; rewrite same_points in e. destruct e as [ex ey]. split.
      * exists (Q2R t0 + l * (Q2R t1 - Q2R t0)). split.
        { assert (0 <= l * (Q2R t1 - Q2R t0)) by (apply Rmult_le_pos; lra). lra. }
        rewrite same_points, ex, ey, (proj1 pr), (proj2 pr), (proj1 qr), (proj2 qr). split; ring.
      * exists (Q2R u0 + l * (Q2R u1 - Q2R u0)).
        assert (r := mix_le l (Q2R u0) (Q2R u1) 1). assert (r' := mix_ge l (Q2R u0) (Q2R u1) 0).
        split; [lra|]. unfold along; rewrite same_points, ex, ey, (proj1 ps), (proj2 ps), (proj1 qs), (proj2 qs).
          split; ring.
Qed.
