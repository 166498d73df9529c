(* A triangle without area that crosses the other's plane: segment_intersects() of lib/src/predicates/triangle.cpp. Its
   line turns about all edges of the other in one direction exactly if the two have a common point. The tip is corner
   a0, as tip_of() finds it; t may lie anywhere. *)
From Coq Require Import ZArith Lia Bool.
Require Import Triangle.
Local Open Scope Z_scope.

(* code: src/predicates/triangle.cpp | const int64_t turn = detail::volume<Wide>(from, to, t.corner[i], t.corner[next(i)]);
   code: src/predicates/triangle.cpp | left |= turn > 0; right |= turn < 0; } return !(left && right); *)
Definition segment_intersects s0 s1 t0 t1 t2 : bool :=
  let u := volume s0 s1 t0 t1 in let v := volume s0 s1 t1 t2 in let w := volume s0 s1 t2 t0 in
  negb (((0 <? u) || (0 <? v) || (0 <? w)) && ((u <? 0) || (v <? 0) || (w <? 0))).
Definition no_area a0 a1 a2 : Prop := x (normal a0 a1 a2) = 0 /\ y (normal a0 a1 a2) = 0 /\ z (normal a0 a1 a2) = 0.

Definition Segment_is_exact := forall a0 a1 a2 t0 t1 t2, no_area a0 a1 a2 ->
  let h := height t0 t1 t2 in
  tip (h a0) (h a1) (h a2) \/ tip (- h a0) (- h a1) (- h a2) ->
  segment_intersects a0 a1 t0 t1 t2 = true <-> meet a0 a1 a2 t0 t1 t2.

Lemma one_way u v w : negb (((0 <? u) || (0 <? v) || (0 <? w)) && ((u <? 0) || (v <? 0) || (w <? 0))) = true <->
  (0 <= u /\ 0 <= v /\ 0 <= w) \/ (u <= 0 /\ v <= 0 /\ w <= 0).
Proof. rewrite negb_true_iff, andb_false_iff, !orb_false_iff, !Z.ltb_ge. lia. Qed.

Lemma same_sign s q share total : 0 < s -> 0 <= share -> s * q = share * total ->
  (0 <= total -> 0 <= q) /\ (total <= 0 -> q <= 0).
Proof. intros S H E. split; intros T; nia. Qed.
Section Proof.
Variables a0 a1 a2 t0 t1 t2 : Point.
Let u := volume a0 a1 t0 t1.
Let v := volume a0 a1 t1 t2.
Let w := volume a0 a1 t2 t0.
Let h := height t0 t1 t2.

Lemma turns_sum : exists f, (f = 1 \/ f = -1) /\ u + v + w = f * (h a1 - h a0) /\
  (forall c, (c = x \/ c = y \/ c = z) -> u * c t2 + v * c t0 + w * c t1 = f * (h a1 * c a0 - h a0 * c a1)).
Proof.
  first [exists 1; split; [now left|]; split; [unfold u, v, w, h, volume, height, normal, dot, cross, sub; cbn [x y z]; ring |]
        | exists (-1); split; [now right|]; split; [unfold u, v, w, h, volume, height, normal, dot, cross, sub; cbn [x y z]; ring |]].
  intros c [-> | [-> | ->]]; unfold u, v, w, h, volume, height, normal, dot, cross, sub; cbn [x y z]; ring.
Qed.

(* Along a line through a common point. *)
Lemma turns_share i j k l m n c : no_area a0 a1 a2 -> i + j + k = l + m + n ->
  mean i j k a0 a1 a2 c -> mean l m n t0 t1 t2 c ->
  l * u = n * v /\ m * v = l * w /\ n * w = m * u.
Proof.
  intros (N1 & N2 & N3) E (X1 & Y1 & Z1) (X2 & Y2 & Z2).
  unfold normal, cross, sub in N1, N2, N3. cbn [x y z] in N1, N2, N3.
  assert (i = l + m + n - j - k) as -> by lia.
  set (D1 := j * (x a1 - x a0) + k * (x a2 - x a0)). set (D2 := j * (y a1 - y a0) + k * (y a2 - y a0)).
  set (D3 := j * (z a1 - z a0) + k * (z a2 - z a0)).
  assert (l * (x t0 - x a0) + m * (x t1 - x a0) + n * (x t2 - x a0) = D1) as F1 by (unfold D1; lia).
  assert (l * (y t0 - y a0) + m * (y t1 - y a0) + n * (y t2 - y a0) = D2) as F2 by (unfold D2; lia).
  assert (l * (z t0 - z a0) + m * (z t1 - z a0) + n * (z t2 - z a0) = D3) as F3 by (unfold D3; lia).
  set (e1 := x a1 - x a0) in *. set (e2 := y a1 - y a0) in *. set (e3 := z a1 - z a0) in *.
  assert (e2 * D3 - e3 * D2 = k * (e2 * (z a2 - z a0) - e3 * (y a2 - y a0))) as C1 by (unfold D2, D3; ring).
  assert (e3 * D1 - e1 * D3 = k * (e3 * (x a2 - x a0) - e1 * (z a2 - z a0))) as C2 by (unfold D1, D3; ring).
  assert (e1 * D2 - e2 * D1 = k * (e1 * (y a2 - y a0) - e2 * (x a2 - x a0))) as C3 by (unfold D1, D2; ring).
  rewrite N1 in C1. rewrite N2 in C2. rewrite N3 in C3. rewrite Z.mul_0_r in C1, C2, C3.
  assert (forall t, (e2 * D3 - e3 * D2) * (x t - x a0) + (e3 * D1 - e1 * D3) * (y t - y a0) +
    (e1 * D2 - e2 * D1) * (z t - z a0) = 0) as G by (intros t; rewrite C1, C2, C3; ring).
  rewrite <- F1, <- F2, <- F3 in G. clear - G.
  pose proof (G t0) as G0. pose proof (G t1) as G1. pose proof (G t2) as G2. clear G.
  unfold u, v, w, volume, dot, cross, sub, e1, e2, e3 in *. cbn [x y z].
  repeat split; apply Z.sub_move_0_r; [rewrite <- G1 | rewrite <- G2 | rewrite <- G0]; ring.
Qed.

(* So each turn is the corner's share of the sum. *)
Lemma shares i j k l m n c : no_area a0 a1 a2 -> i + j + k = l + m + n ->
  mean i j k a0 a1 a2 c -> mean l m n t0 t1 t2 c ->
  (l + m + n) * u = n * (u + v + w) /\ (l + m + n) * v = l * (u + v + w) /\ (l + m + n) * w = m * (u + v + w).
Proof.
  intros N E M1 M2. destruct (turns_share i j k l m n c N E M1 M2) as (A & B & C). clearbody u v w.
  repeat split; lia.
Qed.

End Proof.

Theorem segment_is_exact : Segment_is_exact.
Proof.
  intros a0 a1 a2 t0 t1 t2 N h T. unfold segment_intersects. cbv zeta. rewrite one_way.
  set (u := volume a0 a1 t0 t1). set (v := volume a0 a1 t1 t2). set (w := volume a0 a1 t2 t0). split.
  - intros S. destruct (turns_sum a0 a1 t0 t1 t2) as (f & F & Sum & Each). fold u v w h in Sum, Each.
    pose proof (Each x (or_introl eq_refl)) as X. pose proof (Each y (or_intror (or_introl eq_refl))) as Y.
    pose proof (Each z (or_intror (or_intror eq_refl))) as Z0. clear Each.
    assert (Z.abs (h a0) + Z.abs (h a1) = Z.abs (u + v + w) /\ 0 < Z.abs (u + v + w)) as [Total Positive].
    { rewrite Sum. unfold tip in T. clear - F T. destruct F; subst f; lia. }
    assert (exists g, (g = 1 \/ g = -1) /\ Z.abs u = g * u /\ Z.abs v = g * v /\ Z.abs w = g * w /\
      Z.abs (u + v + w) = g * (u + v + w) /\ Z.abs (h a1) = g * (f * h a1) /\ Z.abs (h a0) = - (g * (f * h a0)))
      as (g & Gs & U & V & W & A & H1 & H0).
    { unfold tip in T. clearbody u v w h. destruct S as [S | S]; [exists 1 | exists (-1)]; clear X Y Z0 N;
        destruct F; subst f; destruct T; lia. }
    exists (Z.abs (h a1)), (Z.abs (h a0)), 0, (Z.abs v), (Z.abs w), (Z.abs u).
    exists {| x := Z.abs (h a1) * x a0 + Z.abs (h a0) * x a1; y := Z.abs (h a1) * y a0 + Z.abs (h a0) * y a1;
      z := Z.abs (h a1) * z a0 + Z.abs (h a0) * z a1 |}.
    do 6 (split; [apply Z.abs_nonneg || apply Z.le_refl|]). split; [clear - Total Positive; lia|].
    split; [rewrite Z.add_0_r, Z.add_comm, Total, A, U, V, W; ring|].
    unfold mean. cbn [x y z]. split; [repeat split; ring|]. rewrite U, V, W, H1, H0. repeat split.
    + transitivity (g * (u * x t2 + v * x t0 + w * x t1)); [ring | rewrite X; ring].
    + transitivity (g * (u * y t2 + v * y t0 + w * y t1)); [ring | rewrite Y; ring].
    + transitivity (g * (u * z t2 + v * z t0 + w * z t1)); [ring | rewrite Z0; ring].
  - intros (i & j & k & l & m & n & c & I & J & K & L & M & N' & P & E & M1 & M2).
    destruct (shares a0 a1 a2 t0 t1 t2 i j k l m n c N E M1 M2) as (A & B & C). fold u v w in A, B, C.
    assert (0 < l + m + n) as P' by lia.
    destruct (same_sign _ u n _ P' N' A), (same_sign _ v l _ P' L B), (same_sign _ w m _ P' M C).
    destruct (Z.le_ge_cases 0 (u + v + w)); [left | right]; auto 6.
Qed.

Print Assumptions segment_is_exact.
