(* Two triangles without area: if flat_intersect() finds no separating edge in any projection, no skew lines and no gap
   between the boxes, there is a common point. *)
From Coq Require Import ZArith Lia Bool Nsatz.
Require Import Triangle Segment Helly Flat.
Local Open Scope Z_scope.

(* code: src/predicates/triangle.cpp | if (a_low > b_high) { return -1; } *)
Definition apart_along (c : Point -> Z) a0 a1 a2 b0 b1 b2 : Prop :=
  let least p q r := Z.min (c p) (Z.min (c q) (c r)) in let most p q r := Z.max (c p) (Z.max (c q) (c r)) in
  most b0 b1 b2 < least a0 a1 a2 \/ most a0 a1 a2 < least b0 b1 b2.
Definition boxes_apart a0 a1 a2 b0 b1 b2 : Prop := apart_along x a0 a1 a2 b0 b1 b2 \/
  apart_along y a0 a1 a2 b0 b1 b2 \/ apart_along z a0 a1 a2 b0 b1 b2.

Definition Segments_are_exact := forall a0 a1 a2 b0 b1 b2, no_area a0 a1 a2 -> no_area b0 b1 b2 ->
  ~ boxes_apart a0 a1 a2 b0 b1 b2 ->
  flat_intersect a0 a1 a2 b0 b1 b2 = true -> meet a0 a1 a2 b0 b1 b2.

(* ---- Proof. *)

Definition zero p := x p = 0 /\ y p = 0 /\ z p = 0.
Lemma zero_dec p : zero p \/ ~ zero p.
Proof. unfold zero. lia. Qed.
Lemma same p q : zero (sub q p) -> q = p.
Proof. unfold zero, sub. cbn [x y z]. intros. apply point_eq; lia. Qed.

(* ---- All on one line: their coordinates along an axis decide. *)
Lemma weigh a0 a1 a2 r v : r = a0 \/ r = a1 \/ r = a2 -> 0 <= v -> exists i j k, 0 <= i /\ 0 <= j /\ 0 <= k /\
  i + j + k = v /\ forall c : Point -> Z, i * c a0 + j * c a1 + k * c a2 = v * c r.
Proof.
  intros [-> | [-> | ->]] V; [exists v, 0, 0 | exists 0, v, 0 | exists 0, 0, v]; repeat split; try lia; intros; ring.
Qed.

Lemma between_meets a0 a1 a2 b0 b1 b2 r s t i j : r = a0 \/ r = a1 \/ r = a2 -> s = a0 \/ s = a1 \/ s = a2 ->
  t = b0 \/ t = b1 \/ t = b2 -> 0 <= i -> 0 <= j -> 0 < i + j ->
  (forall c, c = x \/ c = y \/ c = z -> i * c r + j * c s = (i + j) * c t) -> meet a0 a1 a2 b0 b1 b2.
Proof.
  intros R S T I J P E. destruct (weigh a0 a1 a2 r i R I) as (i0 & i1 & i2 & I0 & I1 & I2 & IS & IC).
  destruct (weigh a0 a1 a2 s j S J) as (j0 & j1 & j2 & J0 & J1 & J2 & JS & JC).
  destruct (weigh b0 b1 b2 t (i + j) T) as (k0 & k1 & k2 & K0 & K1 & K2 & KS & KC); [lia|].
  exists (i0 + j0), (i1 + j1), (i2 + j2), k0, k1, k2,
    {| x := (i + j) * x t; y := (i + j) * y t; z := (i + j) * z t |}.
  repeat split; cbn [x y z]; try lia; auto;
    [rewrite <- (E x), <- IC, <- JC by auto | rewrite <- (E y), <- IC, <- JC by auto |
     rewrite <- (E z), <- IC, <- JC by auto]; ring.
Qed.

(* Along d, from o. *)
Definition on_line d o p := zero (cross d (sub p o)).

Definition axis (w : Point -> Z) := w = x \/ w = y \/ w = z.
Lemma off_line d o p c w : axis c -> axis w -> on_line d o p -> w d * (c p - c o) - c d * (w p - w o) = 0.
Proof.
  unfold on_line, zero, cross, sub. cbn [x y z].
  intros [-> | [-> | ->]] [-> | [-> | ->]] (H1 & H2 & H3); lia.
Qed.
Lemma cancel a b : a <> 0 -> a * b = 0 -> b = 0.
Proof. intros A B. apply Z.mul_eq_0 in B. tauto. Qed.
Lemma line_axis d o w r s t c : axis w -> axis c -> w d <> 0 -> on_line d o r -> on_line d o s -> on_line d o t ->
  (w s - w t) * c r + (w t - w r) * c s = (w s - w r) * c t.
Proof.
  intros W C D R S T. apply (off_line d o _ c w) in R, S, T; auto. apply Zminus_eq, (cancel _ _ D).
  clear D. nsatz.
Qed.
Lemma line_point d o w r t c : axis w -> axis c -> w d <> 0 -> on_line d o r -> on_line d o t -> w r = w t -> c r = c t.
Proof.
  intros W C D R T E. apply (off_line d o _ c w) in R, T; auto. apply Zminus_eq, (cancel _ _ D). clear D. nsatz.
Qed.

Definition corner_of (a0 a1 a2 r : Point) := r = a0 \/ r = a1 \/ r = a2.
Lemma extremes (c : Point -> Z) a0 a1 a2 : exists r s, corner_of a0 a1 a2 r /\ corner_of a0 a1 a2 s /\
  c r = Z.min (c a0) (Z.min (c a1) (c a2)) /\ c s = Z.max (c a0) (Z.max (c a1) (c a2)) /\ c r <= c s.
Proof.
  assert (forall choose : Z -> Z -> Z, (forall m n, choose m n = m \/ choose m n = n) ->
    exists r, corner_of a0 a1 a2 r /\ c r = choose (c a0) (choose (c a1) (c a2))) as G.
  { unfold corner_of. intros choose H. destruct (H (c a1) (c a2)) as [-> | ->];
      [destruct (H (c a0) (c a1)) as [-> | ->] | destruct (H (c a0) (c a2)) as [-> | ->]]; eauto. }
  destruct (G Z.min) as (r & R & E); [lia|]. destruct (G Z.max) as (s & S & F); [lia|].
  exists r, s. do 4 (split; [assumption|]). rewrite E, F. lia.
Qed.

Lemma one_line_meets d o a0 a1 a2 b0 b1 b2 : ~ zero d -> (forall p, corner_of a0 a1 a2 p \/ corner_of b0 b1 b2 p -> on_line d o p) ->
  ~ boxes_apart a0 a1 a2 b0 b1 b2 -> meet a0 a1 a2 b0 b1 b2.
Proof.
  intros D On Boxes.
  assert (exists w, axis w /\ w d <> 0) as (w & W & V).
  { unfold zero in D. assert (x d <> 0 \/ y d <> 0 \/ z d <> 0) as [V | [V | V]] by lia;
      [exists x | exists y | exists z]; unfold axis; auto. }
  destruct (extremes w a0 a1 a2) as (r & s & R & S & Er & Es & L).
  destruct (extremes w b0 b1 b2) as (t & u & T & U & Et & Eu & M).
  assert (w t <= w s /\ w r <= w u) as [TS RU].
  { assert (~ apart_along w a0 a1 a2 b0 b1 b2) as A by (intros A; apply Boxes; unfold boxes_apart; destruct W as [-> | [-> | ->]]; auto).
    unfold apart_along in A. lia. }
  assert (forall c0 c1 c2 e0 e1 e2 r s t, corner_of c0 c1 c2 r -> corner_of c0 c1 c2 s -> corner_of e0 e1 e2 t ->
    on_line d o r -> on_line d o s -> on_line d o t -> w r <= w t <= w s -> meet c0 c1 c2 e0 e1 e2) as G.
  { clear - D W V. intros c0 c1 c2 e0 e1 e2 r s t R S T Or Os Ot B. destruct (Z.eq_dec (w r) (w s)) as [E | E].
    - apply (between_meets _ _ _ _ _ _ r s t 1 0 R S T); try lia. intros c C.
      assert (c r = c t) as F; [|rewrite F; ring]. apply (line_point d o w); auto; lia.
    - apply (between_meets _ _ _ _ _ _ r s t (w s - w t) (w t - w r) R S T); try lia. intros c C.
      rewrite (line_axis d o w r s t c); auto. ring. }
  destruct (Z.le_gt_cases (w r) (w t)).
  - apply (G a0 a1 a2 b0 b1 b2 r s t); auto.
  - apply meet_swap, (G b0 b1 b2 a0 a1 a2 t u r); auto. lia.
Qed.

(* ---- An edge of non-zero length, if there is one. *)
Definition spine (a0 a1 a2 p q : Point) := (p = a0 /\ q = a1) \/ (p = a2 /\ q = a0).
Lemma spine_or_point a0 a1 a2 : (a1 = a0 /\ a2 = a0) \/ exists p q, spine a0 a1 a2 p q /\ ~ zero (sub q p).
Proof.
  unfold spine. destruct (zero_dec (sub a1 a0)) as [E | E]; [|right; eauto 6].
  destruct (zero_dec (sub a0 a2)) as [F | F]; [|right; eauto 6].
  left. split; [now apply same | symmetry; now apply same].
Qed.
Lemma spine_line a0 a1 a2 p q r : no_area a0 a1 a2 -> spine a0 a1 a2 p q -> corner_of a0 a1 a2 r ->
  on_line (sub q p) p r.
Proof.
  unfold no_area, normal, on_line, zero, cross, sub. cbn [x y z].
  intros (N1 & N2 & N3) [[-> ->] | [-> ->]] [-> | [-> | ->]]; lia.
Qed.
Lemma spine_crossed u v a0 a1 a2 b0 b1 b2 p q : axes u v -> no_area a0 a1 a2 -> spine a0 a1 a2 p q ->
  edge_separates u v a0 a1 a2 b0 b1 b2 = false ->
  crossed (cross (onto u v p) (onto u v q)) (onto u v b0) (onto u v b1) (onto u v b2).
Proof.
  intros X N S F. unfold edge_separates, turn in F. cbv zeta in F.
  rewrite (no_area_flat u v a0 a1 a2 X N), !orb_false_iff in F. cbn [Z.sgn] in F. destruct F as [[F0 F1] F2].
  destruct S as [[-> ->] | [-> ->]]; now apply beside_line.
Qed.
Lemma spine_volume a0 a1 a2 b0 b1 b2 p q s t : coplanar a0 a1 a2 b0 b1 b2 = true -> spine a0 a1 a2 p q ->
  spine b0 b1 b2 s t -> dot (cross (sub q p) (sub t s)) (sub s p) = 0.
Proof.
  unfold coplanar. rewrite !andb_true_iff, !Z.eqb_eq. unfold volume, dot, cross, sub. cbn [x y z].
  intros (((V1 & V2) & V3) & V4) [[-> ->] | [-> ->]] [[-> ->] | [-> ->]]; lia.
Qed.

Lemma parallel_on_line p q b0 b1 b2 :
  (forall u v, axes u v -> crossed (cross (onto u v p) (onto u v q)) (onto u v b0) (onto u v b1) (onto u v b2)) ->
  (forall r, corner_of b0 b1 b2 r -> zero (cross (sub q p) (sub r b0))) ->
  forall r, corner_of b0 b1 b2 r -> on_line (sub q p) p r.
Proof.
  intros X P.
  assert (forall u v s, dot (cross (onto u v p) (onto u v q)) (onto u v s) = area u v p q s) as D by (intros; apply det_area).
  (* Along p, q all have one coordinate. *)
  assert (forall u v, axes u v -> forall r, corner_of b0 b1 b2 r -> area u v p q r = 0) as Off.
  { intros u v Y. destruct (X u v Y) as [N M]. rewrite !D in N, M. clear X D.
    assert (forall r, corner_of b0 b1 b2 r -> area u v p q r = area u v p q b0) as Same.
    { intros r R. apply Zminus_eq. destruct (P r R) as (P1 & P2 & P3). clear - Y P1 P2 P3.
      unfold area, cross, sub in *. cbn [x y z] in *. destruct Y as [[-> ->] | [[-> ->] | [-> ->]]];
        [rewrite <- P3 | rewrite <- P1 | rewrite <- P2]; ring. }
    rewrite (Same b1), (Same b2) in N, M by (unfold corner_of; auto).
    intros r R. rewrite (Same r R). clear - N M. lia. }
  intros r R. unfold on_line, zero. split; [|split];
    [rewrite <- (Off y z) with (r := r) | rewrite <- (Off z x) with (r := r) | rewrite <- (Off x y) with (r := r)];
    unfold axes; auto; unfold area, cross, sub; cbn [x y z]; ring.
Qed.

Lemma zero_cross d e f : ~ zero d -> zero (cross e d) -> zero (cross d f) -> zero (cross e f).
Proof.
  unfold zero, cross. cbn [x y z]. intros D (E1 & E2 & E3) (F1 & F2 & F3).
  assert (forall w, axis w -> w d <> 0 -> (forall c, axis c -> w d * c e = c d * w e /\ w d * c f = c d * w f) ->
    forall b c, axis b -> axis c -> b e * c f - c e * b f = 0) as G.
  { intros w W V Along b c B C. destruct (Along b B) as [Be Bf], (Along c C) as [Ce Cf].
    apply (cancel _ _ V), (cancel _ _ V).
    clear V. nsatz. }
  assert (x d <> 0 \/ y d <> 0 \/ z d <> 0) as [V | [V | V]] by lia; repeat split;
    [apply (G x) | apply (G x) | apply (G x) | apply (G y) | apply (G y) | apply (G y) | apply (G z) | apply (G z) | apply (G z)];
    unfold axis; auto; intros c [-> | [-> | ->]]; lia.
Qed.

Lemma spine_meets a0 a1 a2 b0 b1 b2 p q : no_area a0 a1 a2 -> no_area b0 b1 b2 -> ~ boxes_apart a0 a1 a2 b0 b1 b2 ->
  coplanar a0 a1 a2 b0 b1 b2 = true ->
  (forall u v, axes u v -> edge_separates u v a0 a1 a2 b0 b1 b2 = false /\ edge_separates u v b0 b1 b2 a0 a1 a2 = false) ->
  spine a0 a1 a2 p q -> ~ zero (sub q p) -> meet a0 a1 a2 b0 b1 b2.
Proof.
  intros NA NB Boxes Co Clear S D.
  assert (forall u v, axes u v -> crossed (cross (onto u v p) (onto u v q)) (onto u v b0) (onto u v b1) (onto u v b2)) as XA
    by (intros u v X; apply (spine_crossed u v a0 a1 a2); auto; now apply Clear).
  assert ((forall r, corner_of b0 b1 b2 r -> zero (cross (sub q p) (sub r b0))) -> meet a0 a1 a2 b0 b1 b2) as Parallel.
  { intros P. apply (one_line_meets (sub q p) p); auto. intros r [R | R]; [now apply (spine_line a0 a1 a2)|].
    now apply (parallel_on_line p q b0 b1 b2). }
  destruct (spine_or_point b0 b1 b2) as [[-> ->] | (s & t & T & E)].
  { apply Parallel. intros r R. assert (r = b0) as -> by (unfold corner_of in R; tauto).
    unfold zero, cross, sub. cbn [x y z]. lia. }
  pose proof (spine_line b0 b1 b2 s t) as LB. pose proof (spine_volume _ _ _ _ _ _ p q s t Co S T) as V.
  destruct (zero_dec (cross (sub q p) (sub t s))) as [Z0 | N].
  - apply Parallel. intros r R. apply (zero_cross (sub t s)); auto.
    pose proof (LB r NB T R) as Lr. pose proof (LB b0 NB T (or_introl eq_refl)) as L0.
    unfold on_line, zero, cross, sub in *. cbn [x y z] in *. lia.
  - assert (exists u v, axes u v /\ faces u v (cross (sub q p) (sub t s))) as (u & v & X & F).
    { unfold zero in N. unfold axes, faces. set (n := cross (sub q p) (sub t s)) in *.
      assert (z n <> 0 \/ x n <> 0 \/ y n <> 0) as [M | [M | M]] by lia;
        [exists x, y | exists y, z | exists z, x]; auto 8. }
    assert (forall r, on_line (sub q p) p r -> in_plane (cross (sub q p) (sub t s)) p r) as PA.
    { intros r (L1 & L2 & L3). unfold in_plane, dot, cross, sub in *. cbn [x y z] in *. clear - L1 L2 L3. nsatz. }
    assert (forall r, on_line (sub t s) s r -> in_plane (cross (sub q p) (sub t s)) p r) as PB.
    { intros r (L1 & L2 & L3). unfold in_plane, dot, cross, sub in *. cbn [x y z] in *. clear - V L1 L2 L3. nsatz. }
    assert (forall u v r, axes u v -> on_line (sub q p) p r -> dot (cross (onto u v p) (onto u v q)) (onto u v r) = 0) as OA.
    { intros u' v' r Y (L1 & L2 & L3). change (det (onto u' v' p) (onto u' v' q) (onto u' v' r) = 0). rewrite det_area.
      unfold area, cross, sub in *. cbn [x y z] in *. destruct Y as [[-> ->] | [[-> ->] | [-> ->]]]; lia. }
    assert (forall u v r, axes u v -> on_line (sub t s) s r -> dot (cross (onto u v s) (onto u v t)) (onto u v r) = 0) as OB.
    { intros u' v' r Y (L1 & L2 & L3). change (det (onto u' v' s) (onto u' v' t) (onto u' v' r) = 0). rewrite det_area.
      unfold area, cross, sub in *. cbn [x y z] in *. destruct Y as [[-> ->] | [[-> ->] | [-> ->]]]; lia. }
    assert (forall r, corner_of a0 a1 a2 r -> on_line (sub q p) p r) as LA by (intros; now apply (spine_line a0 a1 a2)).
    unfold corner_of in *.
    apply (lift u v (cross (sub q p) (sub t s)) p); auto 8.
    apply (lines_meet (cross (onto u v p) (onto u v q)) (cross (onto u v s) (onto u v t)));
      try apply onto_corner; try (apply OA; auto); try (apply OB; auto).
    + unfold faces, cross, sub, onto in *. cbn [x y z] in *. destruct F as [(-> & -> & F) | [(-> & -> & F) | (-> & -> & F)]]; lia.
    + now apply XA.
    + apply (spine_crossed u v b0 b1 b2); auto. now apply Clear.
Qed.

Theorem segments_are_exact : Segments_are_exact.
Proof.
  intros a0 a1 a2 b0 b1 b2 NA NB Boxes F. pose proof (flat_decides a0 a1 a2 b0 b1 b2) as T. cbv zeta in T. rewrite F in T.
  clear F. destruct T as [(u & v & X & _ & A) | [F C]]; [destruct A; unfold turn; now rewrite (no_area_flat u v)|].
  assert (forall u v, axes u v -> edge_separates u v a0 a1 a2 b0 b1 b2 = false /\
    edge_separates u v b0 b1 b2 a0 a1 a2 = false) as Clear by (intros u v X; apply orb_false_iff; now apply C).
  destruct (spine_or_point a0 a1 a2) as [[-> ->] | (p & q & S & D)]; [|now apply (spine_meets _ _ _ _ _ _ p q)].
  destruct (spine_or_point b0 b1 b2) as [[-> ->] | (p & q & S & D)].
  - assert (a0 = b0) as -> by (unfold boxes_apart, apart_along in Boxes; apply point_eq; lia).
    exists 1, 0, 0, 1, 0, 0, b0. unfold mean. lia.
  - apply meet_swap, (spine_meets _ _ _ _ _ _ p q); auto.
    + unfold boxes_apart, apart_along in *. tauto.
    + unfold coplanar in *. rewrite !andb_true_iff, !Z.eqb_eq in *. unfold volume, dot, cross, sub in *. cbn [x y z] in *. lia.
    + intros u v X. destruct (Clear u v X). auto.
Qed.

Print Assumptions segments_are_exact.
