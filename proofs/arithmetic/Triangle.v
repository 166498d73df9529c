(* The general case of lib/src/predicates/triangle.cpp, intervals_overlap(): two triangles, neither of which lies in the
   other's plane or on one side of it. Two signs decide whether they have a common point. (Guigue and Devillers 2003,
   where the proof is a figure.)

   Points are integers; a common point is rational. Not here: triangles in one plane or without area, which other
   functions decide; widths of integers, in determinant.g. *)
From Coq Require Import ZArith Lia Psatz Bool Nsatz.
Local Open Scope Z_scope.

(* ============================================================== Definitions *)

Record Point := { x : Z; y : Z; z : Z }.
Definition sub p q := {| x := x p - x q; y := y p - y q; z := z p - z q |}.
Definition dot p q := x p * x q + y p * y q + z p * z q.
(* code: src/predicates/orientation.hpp | wide.y * v.z - wide.z * v.y, wide.z * v.x - wide.x * v.z, wide.x * v.y - wide.y * v.x *)
Definition cross u v :=
  {| x := y u * z v - z u * y v; y := z u * x v - x u * z v; z := x u * y v - y u * x v |}.
(* code: src/predicates/orientation.hpp | return dot(cross<Cofactors>(difference(s, r), difference(q, p)), difference(r, p)); *)
Definition volume p q r s := dot (cross (sub s r) (sub q p)) (sub r p).
(* code: src/predicates/orientation.hpp | return cross<Cofactors>(difference(t.corner[1], t.corner[0]), difference(t.corner[2], t.corner[0])); *)
Definition normal p q r := cross (sub q p) (sub r p).
Definition height p q r (of : Point) := dot (normal p q r) (sub of p).

(* A common point: the same mean of the corners of each triangle, with non-negative weights. *)
Definition mean (u v w : Z) (p q r m : Point) : Prop :=
  u * x p + v * x q + w * x r = x m /\ u * y p + v * y q + w * y r = y m /\
  u * z p + v * z q + w * z r = z m.
Definition meet p q r s t o := exists i j k l m n c,
  0 <= i /\ 0 <= j /\ 0 <= k /\ 0 <= l /\ 0 <= m /\ 0 <= n /\
  0 < i + j + k /\ i + j + k = l + m + n /\ mean i j k p q r c /\ mean l m n s t o c.

(* Tip p is on or above the other's plane, q and r are on or below it, and one of the two strictly: each edge from the
   tip has one point of the plane. *)
Definition tip (of_p of_q of_r : Z) : Prop :=
  0 <= of_p /\ of_q <= 0 /\ of_r <= 0 /\ of_q < of_p /\ of_r < of_p.

(* For three heights, the corner that is the tip, and whether it is the upper one.
   code: src/predicates/triangle.cpp | const unsigned below = bits(height[0] < 0, height[1] < 0, height[2] < 0);
   code: src/predicates/triangle.cpp | return bits(height[0] > 0, height[1] > 0, height[2] > 0);
   code: src/predicates/triangle.cpp | return below == kAllCorners ? kSeparated : kAllCorners ^ below;
   code: src/predicates/triangle.cpp | return below == 0 ? above : below == kAllCorners ? kSeparated : kAllCorners ^ below;
   code: src/predicates/triangle.cpp | {kFirst, true, {kThird, kSecond, kThird}}, {kSecond, true, {kFirst, kThird, kFirst}},
   code: src/predicates/triangle.cpp | {kThird, false, {kSecond, kFirst, kSecond}}, {kThird, true, {kSecond, kFirst, kSecond}},
   code: src/predicates/triangle.cpp | {kSecond, false, {kFirst, kThird, kFirst}}, {kFirst, false, {kThird, kSecond, kThird}}}; *)
Definition tip_of (g0 g1 g2 : Z) : nat * bool :=
  let below g := g <? 0 in
  let upper g := if below g0 || below g1 || below g2 then negb (below g) else 0 <? g in
  match upper g0, upper g1, upper g2 with
  | true, false, false => (0%nat, true) | false, true, false => (1%nat, true)
  | false, false, true => (2%nat, true) | false, true, true => (0%nat, false)
  | true, false, true => (1%nat, false) | _, _, _ => (2%nat, false)
  end.
(* A corner, the next one and the previous one. *)
Definition from {T} (corner : nat) (p q r : T) : T * T * T :=
  match corner with O => (p, q, r) | S O => (q, r, p) | _ => (r, p, q) end.

(* code: src/predicates/triangle.cpp | const Place* const others_a = fan_a.others + fan_b.up; const Place* const others_b = fan_b.others + fan_a.up;
   code: src/predicates/triangle.cpp | return dot(cross<Narrow>(difference(s, r), difference(q, p)), difference(r, p));
   code: src/predicates/triangle.cpp | return volume_of(Cofactors(), tip_a, corner_at(a, others_a[i]), tip_b, corner_at(b, others_b[i])); }; return volume(0) <= 0 && volume(1) >= 0; *)
Definition intervals_overlap a0 a1 a2 b0 b1 b2 : bool :=
  let above_b := height b0 b1 b2 in
  let above_a := height a0 a1 a2 in
  let (ca, up_a) := tip_of (above_b a0) (above_b a1) (above_b a2) in
  let (cb, up_b) := tip_of (above_a b0) (above_a b1) (above_a b2) in
  let '(ta, na, pa) := from ca a0 a1 a2 in
  let '(tb, nb, pb) := from cb b0 b1 b2 in
  let (ha, la) := if up_b then (na, pa) else (pa, na) in
  let (hb, lb) := if up_a then (nb, pb) else (pb, nb) in
  (volume ta ha tb hb <=? 0) && (0 <=? volume ta la tb lb).

(* Not all strictly on one side, and not all in the plane. *)
Definition crosses (g0 g1 g2 : Z) : Prop :=
  ~ (0 < g0 /\ 0 < g1 /\ 0 < g2) /\ ~ (g0 < 0 /\ g1 < 0 /\ g2 < 0) /\ ~ (g0 = 0 /\ g1 = 0 /\ g2 = 0).

(* ============================================================== Theorem *)

Definition General_case_is_exact := forall a0 a1 a2 b0 b1 b2,
  crosses (height b0 b1 b2 a0) (height b0 b1 b2 a1) (height b0 b1 b2 a2) ->
  crosses (height a0 a1 a2 b0) (height a0 a1 a2 b1) (height a0 a1 a2 b2) ->
  (intervals_overlap a0 a1 a2 b0 b1 b2 = true <-> meet a0 a1 a2 b0 b1 b2).

(* An intermediate result, for any corners named so that the tips are above. *)

Definition Signs_decide := forall p q r s t o,
  tip (height s t o p) (height s t o q) (height s t o r) ->
  tip (height p q r s) (height p q r t) (height p q r o) ->
  (volume p q s t <= 0 /\ 0 <= volume p r s o <-> meet p q r s t o).

(* ============================================================== Proof *)

Ltac expand := unfold height, normal, volume, cross, dot, sub in *; cbn [x y z] in *.

(* ---- If there is a common point, both signs are right. Otherwise a plane along two edges separates. *)

Lemma separates n a p q r s t o : meet p q r s t o ->
  dot n (sub p a) <= 0 -> dot n (sub q a) <= 0 -> dot n (sub r a) <= 0 ->
  0 < dot n (sub s a) -> 0 < dot n (sub t a) -> 0 < dot n (sub o a) -> False.
Proof.
  intros (i & j & k & l & m & u & c & Hi & Hj & Hk & Hl & Hm & Hu & W & E & (X1 & Y1 & Z1) & (X2 & Y2 & Z2)).
  set (P := dot n (sub p a)). set (Q := dot n (sub q a)). set (R := dot n (sub r a)).
  set (S := dot n (sub s a)). set (T := dot n (sub t a)). set (O := dot n (sub o a)).
  assert (i * P + j * Q + k * R = l * S + m * T + u * O) as B.
  { assert (i * P + j * Q + k * R = dot n c - (i + j + k) * dot n a) as ->.
    { unfold P, Q, R, dot, sub. cbn [x y z]. rewrite <- X1, <- Y1, <- Z1. ring. }
    assert (l * S + m * T + u * O = dot n c - (l + m + u) * dot n a) as ->.
    { unfold S, T, O, dot, sub. cbn [x y z]. rewrite <- X2, <- Y2, <- Z2. ring. }
    now rewrite E. }
  clearbody P Q R S T O. clear - B Hi Hj Hk Hl Hm Hu W E. intros.
  assert (i * P <= 0) by nia. assert (j * Q <= 0) by nia. assert (k * R <= 0) by nia.
  assert (0 <= l * S) by nia. assert (0 <= m * T) by nia. assert (0 <= u * O) by nia.
  assert (0 < l \/ 0 < m \/ 0 < u) as [V | [V | V]] by lia; nia.
Qed.

Definition negated p := {| x := - x p; y := - y p; z := - z p |}.

Lemma necessary p q r s t o : let h := height p q r in let g := height s t o in
  g q < g p -> g r < g p -> h t < h s -> h o < h s -> meet p q r s t o ->
  volume p q s t <= 0 /\ 0 <= volume p r s o.
Proof.
  intros h g Gq Gr Ht Ho M. split.
  - destruct (Z.le_gt_cases (volume p q s t) 0) as [|V]; auto. exfalso.
    set (n := cross (sub t s) (sub q p)).
    assert (dot n (sub p p) = 0) by (unfold n; expand; ring).
    assert (dot n (sub q p) = 0) by (unfold n; expand; ring).
    assert (dot n (sub r p) = h t - h s) by (unfold n, h; expand; ring).
    assert (dot n (sub s p) = volume p q s t) by (unfold n; expand; ring).
    assert (dot n (sub t p) = volume p q s t) by (unfold n; expand; ring).
    assert (dot n (sub o p) = volume p q s t + (g p - g q)) by (unfold n, g; expand; ring).
    clearbody n. clearbody h g. apply (separates n p p q r s t o M); lia.
  - destruct (Z.le_gt_cases 0 (volume p r s o)) as [|V]; auto. exfalso.
    set (n := negated (cross (sub o s) (sub r p))).
    assert (dot n (sub p p) = 0) by (unfold n, negated; expand; ring).
    assert (dot n (sub q p) = h o - h s) by (unfold n, negated, h; expand; ring).
    assert (dot n (sub r p) = 0) by (unfold n, negated; expand; ring).
    assert (dot n (sub s p) = - volume p r s o) by (unfold n, negated; expand; ring).
    assert (dot n (sub t p) = - volume p r s o + (g p - g r)) by (unfold n, negated, g; expand; ring).
    assert (dot n (sub o p) = - volume p r s o) by (unfold n, negated; expand; ring).
    clearbody n. clearbody h g. apply (separates n p p q r s t o M); lia.
Qed.

(* ---- If both signs are right, there is a common point, on the common line of both planes. *)

(* The point of the plane on an edge from p to q, at heights gp and gq: times gp - gq. *)
Definition edge_point gp gq p q :=
  {| x := - gq * x p + gp * x q; y := - gq * y p + gp * y q; z := - gq * z p + gp * z q |}.
(* The vector from a point p of weight v to a point q of weight w, times both weights. *)
Definition way v p w q :=
  {| x := v * x q - w * x p; y := v * y q - w * y p; z := v * z q - w * z p |}.

Lemma parallel a b w : dot a w = 0 -> dot b w = 0 -> let d := cross a b in
  dot d d * x w = dot w d * x d /\ dot d d * y w = dot w d * y d /\ dot d d * z w = dot w d * z d.
Proof.
  intros A B d.
  assert (x (cross w d) = 0 /\ y (cross w d) = 0 /\ z (cross w d) = 0) as (X & Y & Z0)
    by (unfold d; expand; clear d; repeat split; nsatz).
  clearbody d. unfold cross in X, Y, Z0. cbn [x y z] in X, Y, Z0. clear A B.
  repeat split; unfold dot; nsatz.
Qed.

(* Two vectors along one line, of lengths c and e along d: a point between them is a mean. *)
Lemma between dd c e v w d : 0 < dd -> dd * v = c * d -> dd * w = e * d -> e * v = c * w.
Proof. 
  intros P V W. apply (Z.mul_reg_l _ _ dd); [lia|].
  clear P. nsatz.
Qed.

Section Sufficient.
Variables p q r s t o : Point.
Let a := normal p q r.
Let b := normal s t o.
Let d := cross a b.
Let gp := dot b (sub p s). Let gq := dot b (sub q s). Let gr := dot b (sub r s).
Let hs := dot a (sub s p). Let ht := dot a (sub t p). Let ho := dot a (sub o p).
Hypothesis G : tip gp gq gr.
Hypothesis H : tip hs ht ho.

(* The length along d between an edge of one triangle and one of the other is the volume. *)
Lemma way_is_volume u e gu he :
  dot a (sub u p) = 0 -> dot b (sub e s) = 0 -> gu = dot b (sub u s) -> he = dot a (sub e p) ->
  gu < gp -> he < hs ->
  let w := way (gp - gu) (edge_point gp gu p u) (hs - he) (edge_point hs he s e) in
  x w = volume p u s e * x d /\ y w = volume p u s e * y d /\ z w = volume p u s e * z d.
Proof.
  intros Au Be Eu Ee Lu Le w.
  assert (dot a w = 0) as Aw.
  { assert (dot a w = (gp - gu) * (- he * dot a (sub s p) + hs * dot a (sub e p)) -
      (hs - he) * gp * dot a (sub u p)) as -> by (unfold w; expand; unfold way, edge_point; cbn [x y z]; ring).
    rewrite Au, <- Ee. fold hs. ring. }
  assert (dot b w = 0) as Bw.
  { assert (dot b w = (gp - gu) * hs * dot b (sub e s) -
      (hs - he) * (- gu * dot b (sub p s) + gp * dot b (sub u s))) as ->
      by (unfold w; expand; unfold way, edge_point; cbn [x y z]; ring).
    rewrite Be, <- Eu. fold gp. ring. }
  pose proof (parallel a b w Aw Bw) as (X & Y & Z0). cbn zeta in X, Y, Z0. fold d in X, Y, Z0.
  set (n := cross (sub e s) (sub u p)).
  assert (dot n d = (hs - he) * (gp - gu)) as N.
  { assert (dot n d = dot a (sub e s) * dot b (sub u p) - dot b (sub e s) * dot a (sub u p)) as ->
      by (unfold n, d; clearbody a b; expand; ring).
    assert (dot a (sub e s) = he - hs) as -> by (rewrite Ee; unfold hs; clearbody a; expand; ring).
    assert (dot b (sub u p) = gu - gp) as -> by (rewrite Eu; unfold gp; clearbody b; expand; ring).
    rewrite Au. ring. }
  assert (dot n w = (gp - gu) * (hs - he) * volume p u s e) as M.
  { unfold n, w, way, edge_point. clearbody a b. clear. unfold volume.
    set (n := cross (sub e s) (sub u p)).
    assert (dot n (sub e s) = 0) as E1 by (unfold n; expand; ring).
    assert (dot n (sub u p) = 0) as E2 by (unfold n; expand; ring).
    transitivity ((gp - gu) * (hs - he) * dot n (sub s p) + (gp - gu) * hs * dot n (sub e s) -
      (hs - he) * gp * dot n (sub u p)); [clearbody n; expand; ring | rewrite E1, E2; ring]. }
  assert (dot d d * dot n w = dot w d * dot n d) as K.
  { revert X Y Z0. set (dd := dot d d). set (dw := dot w d). clearbody dd dw n w d.
    clear. intros X Y Z0. unfold dot. nsatz. }
  rewrite M, N in K.
  assert (dot d d * volume p u s e = dot w d) as L.
  { apply (Z.mul_reg_l _ _ ((gp - gu) * (hs - he))); [nia|].
    transitivity (dot d d * ((gp - gu) * (hs - he) * volume p u s e)); [ring | rewrite K; ring]. }
  assert (0 < dot d d) as D.
  { assert (0 < dot n d) as P by (rewrite N; nia). clearbody n d. unfold dot in P |- *.
    assert (x d <> 0 \/ y d <> 0 \/ z d <> 0) as [E | [E | E]] by nia; nia. }
  rewrite <- L in X, Y, Z0. rewrite <- !Z.mul_assoc in X, Y, Z0.
  apply Z.mul_reg_l in X, Y, Z0; auto; lia.
Qed.

(* Edge points are means of the edges' ends; one of them lies between two of the other triangle. *)
Lemma sufficient : volume p q s t <= 0 -> 0 <= volume p r s o -> meet p q r s t o.
Proof.
  intros V W.
  assert (dot a (sub q p) = 0) as A0 by (unfold a; expand; ring).
  assert (dot a (sub r p) = 0) as A1 by (unfold a; expand; ring).
  assert (dot b (sub t s) = 0) as B0 by (unfold b; expand; ring).
  assert (dot b (sub o s) = 0) as B1 by (unfold b; expand; ring).
  destruct G as (Gp & Gq & Gr & Lq & Lr), H as (Hs & Ht & Ho & Lt & Lo).
  pose proof (way_is_volume q t gq ht A0 B0 eq_refl eq_refl Lq Lt) as (QTx & QTy & QTz).
  pose proof (way_is_volume r o gr ho A1 B1 eq_refl eq_refl Lr Lo) as (ROx & ROy & ROz).
  pose proof (way_is_volume r t gr ht A1 B0 eq_refl eq_refl Lr Lt) as (RTx & RTy & RTz).
  unfold way, edge_point in *. cbn [x y z] in *.
  set (n1 := volume p q s t) in *. set (n2 := volume p r s o) in *. set (m := volume p r s t) in *.
  clearbody n1 n2 m gp gq gr hs ht ho d. clear A0 A1 B0 B1.
  assert (forall u v w, 0 <= u -> 0 <= v -> 0 <= w -> 0 <= u * v + w) as Pos by (intros; nia).
  unfold meet, mean.
  destruct (Z.eq_dec m 0) as [-> | N]; [|destruct (Z.lt_ge_cases m 0) as [M|M]].
  - exists ((hs - ht) * - gr), 0, ((hs - ht) * gp), ((gp - gr) * - ht), ((gp - gr) * hs), 0.
    eexists {| x := _; y := _; z := _ |}. cbn [x y z]. repeat split; try reflexivity; try nia.
  - (* r's point, between those of t and o *)
    exists ((n2 * (hs - ht) - m * (hs - ho)) * - gr), 0, ((n2 * (hs - ht) - m * (hs - ho)) * gp),
      ((gp - gr) * (n2 * - ht + - m * - ho)), ((gp - gr) * (n2 * hs)), ((gp - gr) * (- m * hs)).
    assert (0 < n2 * (hs - ht) - m * (hs - ho)) by nia.
    assert (0 <= n2 * - ht) by nia. assert (0 <= - m * - ho) by nia.
    assert (0 <= n2 * hs) by nia. assert (0 <= - m * hs) by nia.
    eexists {| x := _; y := _; z := _ |}. cbn [x y z]. repeat split; try reflexivity; try nia.
  - (* t's point, between those of r and q *)
    exists ((hs - ht) * (- n1 * - gr + m * - gq)), ((hs - ht) * (m * gp)), ((hs - ht) * (- n1 * gp)),
      ((- n1 * (gp - gr) + m * (gp - gq)) * - ht), ((- n1 * (gp - gr) + m * (gp - gq)) * hs), 0.
    assert (0 < - n1 * (gp - gr) + m * (gp - gq)) by nia.
    assert (0 <= - n1 * - gr) by nia. assert (0 <= m * - gq) by nia.
    assert (0 <= m * gp) by nia. assert (0 <= - n1 * gp) by nia.
    eexists {| x := _; y := _; z := _ |}. cbn [x y z]. repeat split; try reflexivity; try nia.
Qed.
End Sufficient.

Theorem signs_decide : Signs_decide.
Proof.
  intros p q r s t o G H. split.
  - intros [V W]. now apply sufficient.
  - destruct G as (_ & _ & _ & Gq & Gr), H as (_ & _ & _ & Ht & Ho). now apply necessary.
Qed.

(* ---- The corners that the code names. *)

Lemma tip_of_is_tip g0 g1 g2 : crosses g0 g1 g2 ->
  let (c, up) := tip_of g0 g1 g2 in let s g := if up : bool then g else - g in
  let '(u, v, w) := from c g0 g1 g2 in tip (s u) (s v) (s w).
Proof.
  unfold crosses, tip_of, tip.
  destruct (Z.ltb_spec 0 g0), (Z.ltb_spec 0 g1), (Z.ltb_spec 0 g2), (Z.ltb_spec g0 0),
    (Z.ltb_spec g1 0), (Z.ltb_spec g2 0); cbn; lia.
Qed.

Lemma height_cycle p q r u : height q r p u = height p q r u.
Proof. expand; ring. Qed.
Lemma height_flip p q r u : height p r q u = - height p q r u.
Proof. expand; ring. Qed.
Lemma meet_cycle p q r s t o : meet p q r s t o -> meet q r p s t o.
Proof.
  intros (i & j & k & l & m & n & c & H). exists j, k, i, l, m, n, c. unfold mean in *. lia.
Qed.
Lemma meet_flip p q r s t o : meet p q r s t o -> meet p r q s t o.
Proof.
  intros (i & j & k & l & m & n & c & H). exists i, k, j, l, m, n, c. unfold mean in *. lia.
Qed.
Lemma meet_swap p q r s t o : meet p q r s t o -> meet s t o p q r.
Proof.
  intros (i & j & k & l & m & n & c & H). exists l, m, n, i, j, k, c. unfold mean in *. lia.
Qed.
Lemma tip_swap u v w : tip u v w -> tip u w v.
Proof. unfold tip. lia. Qed.

(* From another corner of the same triangle: equal heights, and equal points. *)
Lemma from_same c p q r : let '(u, v, w) := from c p q r in
  (forall g, height u v w g = height p q r g) /\
  (forall s t o, meet u v w s t o <-> meet p q r s t o) /\
  forall f : Point -> Z, from c (f p) (f q) (f r) = (f u, f v, f w).
Proof.
  destruct c as [|[|c]]; cbn [from]; split; [| split | | split | | split]; auto; try reflexivity.
  - intros g. apply height_cycle.
  - intros s t o. split; [intros M; now apply meet_cycle, meet_cycle | apply meet_cycle].
  - intros g. rewrite height_cycle. apply height_cycle.
  - intros s t o. split; [apply meet_cycle | intros M; now apply meet_cycle, meet_cycle].
Qed.

Theorem general_case_is_exact : General_case_is_exact.
Proof.
  intros a0 a1 a2 b0 b1 b2 A B. unfold intervals_overlap.
  apply tip_of_is_tip in A, B.
  destruct (tip_of (height b0 b1 b2 a0) _ _) as [ca up_a], (tip_of (height a0 a1 a2 b0) _ _) as [cb up_b].
  pose proof (from_same ca a0 a1 a2) as FA. pose proof (from_same cb b0 b1 b2) as FB.
  destruct (from ca a0 a1 a2) as [[ta na] pa], (from cb b0 b1 b2) as [[tb nb] pb].
  destruct FA as (HA & MA & SA), FB as (HB & MB & SB).
  rewrite (SA (height b0 b1 b2)) in A. rewrite (SB (height a0 a1 a2)) in B.
  assert (meet ta na pa tb nb pb <-> meet a0 a1 a2 b0 b1 b2) as <-.
  { rewrite MA. split; intros M; apply meet_swap; apply meet_swap in M; now apply MB. }
  rewrite <- !HB in A. rewrite <- !HA in B.
  assert (forall ha la hb lb, (ha, la) = (if up_b then (na, pa) else (pa, na)) ->
    (hb, lb) = (if up_a then (nb, pb) else (pb, nb)) ->
    (volume ta ha tb hb <= 0 /\ 0 <= volume ta la tb lb <-> meet ta ha la tb hb lb)) as Decides.
  { intros ha la hb lb EA EB. apply signs_decide.
    - destruct up_a, up_b; injection EA as -> ->; injection EB as -> ->; rewrite ?(height_flip tb nb pb);
        auto using tip_swap.
    - destruct up_a, up_b; injection EA as -> ->; injection EB as -> ->; rewrite ?(height_flip ta na pa);
        auto using tip_swap. }
  destruct (if up_b then (na, pa) else (pa, na)) as [ha la] eqn:EA,
    (if up_a then (nb, pb) else (pb, nb)) as [hb lb] eqn:EB.
  rewrite andb_true_iff, !Z.leb_le, (Decides ha la hb lb eq_refl eq_refl).
  destruct up_a, up_b; injection EA as <- <-; injection EB as <- <-; split; intros M; auto using meet_flip;
    apply meet_swap, meet_flip, meet_swap; auto using meet_flip.
Qed.

Print Assumptions general_case_is_exact.
