(* The margin of slabs under a rotation: along a direction, a placed vertex of B lies within the margin of the slab's
   place, for directions of either leaf. And the sum of a rotated direction, which slab.g uses. As in Margins.v, columns
   of the rotation are a, b, c and rows 1, 2, 3. *)
From Coq Require Import ZArith Lia Psatz.
Require Import Margins.
Local Open Scope Z_scope.

(* code: src/bounds/slab.cpp | add_signed_products(add_signed_products(kHalfUnit, row.positive_xy, xy_), row.negative_xy, negated_xy_), row.z, z_) >> kSplitBits; *)
Definition turned (kx ky kz dx dy dz : Z) : Z :=
  (coarse kx * dx + coarse ky * dy + coarse kz * dz + cell14 / 2) / cell14.
(* code: src/bounds/slab.cpp | return (start.upper - start.lower + kSplitOne) >> (kSplitBits + 1); *)
Definition whole_cells (offset : Z) : Z := (2 * offset + cell14) / (2 * cell14).
(* code: include/flashbvh/detail/bounds/transform.hpp | constexpr uint32_t most = 3u << 13;
   code: include/flashbvh/detail/bounds/transform.hpp | const uint32_t turned = (7 * static_cast<uint32_t>(reach_b) + 3) >> 2;
   code: include/flashbvh/detail/bounds/transform.hpp | const uint32_t each = turned + placed + (stretched >> 9);
   code: include/flashbvh/detail/bounds/transform.hpp | return static_cast<uint16_t>(((turned >> 1) + (each >> 2) * (most >> 13) + 20) / kMarginUnit + 1); *)
Definition slab_margin (reach defect : Z) : Z :=
  let turned := (7 * reach + 3) / 4 in
  let each := turned + @transform.hpp:placed@ + reach * defect / 512 in
  ((turned / 2 + each / 4 * 3 + 20) / @kMarginUnit@ + 1) * @kMarginUnit@.
Definition most_part := @2**kDirectionBits@.

Lemma sign u : exists s, (s = 1 \/ s = -1) /\ Z.abs u = s * u.
Proof. destruct (Z.le_ge_cases 0 u); [exists 1 | exists (-1)]; lia. Qed.
Lemma whole_near o : Z.abs (256 * o - 256 * (cell14 * whole_cells o)) <= 2097152.
Proof. unfold whole_cells, cell14. change (2 * 16384) with 32768. divisions. lia. Qed.

(* The error of a rotated part, in 2^-22: at most 5 * 2^20, that is 5/4. *)
Lemma turned_near kx ky kz dx dy dz :
  Z.abs dx <= most_part -> Z.abs dy <= most_part -> Z.abs dz <= most_part ->
  Z.abs (one22 * turned kx ky kz dx dy dz - (kx * dx + ky * dy + kz * dz)) <= 5242880.
Proof.
  intros X Y Z0. unfold most_part in *.
  assert (forall k u, Z.abs u <= 8192 -> Z.abs (rest k * u) <= 128 * 8192) as Rest.
  { intros k u U. apply product_bound; auto. pose proof (rest_fits k). lia. }
  pose proof (Rest kx dx X). pose proof (Rest ky dy Y). pose proof (Rest kz dz Z0).
  rewrite (split_product kx dx), (split_product ky dy), (split_product kz dz). unfold turned, cell14, one22.
  change (16384 / 2) with 8192.
  set (x := coarse kx * dx) in *. set (y := coarse ky * dy) in *. set (z := coarse kz * dz) in *.
  set (x' := rest kx * dx) in *. set (y' := rest ky * dy) in *. set (z' := rest kz * dz) in *.
  clearbody x y z x' y' z'. divisions. lia.
Qed.

Section Slab.
Variables a1 a2 a3 b1 b2 b3 c1 c2 c3 : Z.
Variables p q s mp mq ms reach defect : Z.        (* a vertex of B *)
Variables o1 o2 o3 : Z.
Let one := one22 * one22.
Let d := defect * (one / @2**kDefectBits@).
Hypothesis sizes : Z.abs p <= mp /\ Z.abs q <= mq /\ Z.abs s <= ms /\ mp + mq + ms = reach.
Hypothesis defects : 0 <= defect <= 3 * @kMaxEntryDefect@.
Hypothesis aa : Z.abs (a1 * a1 + a2 * a2 + a3 * a3 - one) <= d.
Hypothesis bb : Z.abs (b1 * b1 + b2 * b2 + b3 * b3 - one) <= d.
Hypothesis cc : Z.abs (c1 * c1 + c2 * c2 + c3 * c3 - one) <= d.
Hypothesis ab : Z.abs (a1 * b1 + a2 * b2 + a3 * b3) <= d.
Hypothesis ac : Z.abs (a1 * c1 + a2 * c2 + a3 * c3) <= d.
Hypothesis bc : Z.abs (b1 * c1 + b2 * c2 + b3 * c3) <= d.
Variables d1 d2 d3 : Z.                           (* the slab's own direction *)
Hypothesis part1 : Z.abs d1 <= most_part.
Hypothesis part2 : Z.abs d2 <= most_part.
Hypothesis part3 : Z.abs d3 <= most_part.
Let m1 := a1 * p + b1 * q + c1 * s.
Let m2 := a2 * p + b2 * q + c2 * s.
Let m3 := a3 * p + b3 * q + c3 * s.
Let v1 := placed a1 b1 c1 o1 p q s.
Let v2 := placed a2 b2 c2 o2 p q s.
Let v3 := placed a3 b3 c3 o3 p q s.
Let w1 := whole_cells o1.
Let w2 := whole_cells o2.
Let w3 := whole_cells o3.
(* The direction of a leaf of A in B's frame, and of a leaf of B in A's frame. *)
Let in_b1 := turned a1 a2 a3 d1 d2 d3.
Let in_b2 := turned b1 b2 b3 d1 d2 d3.
Let in_b3 := turned c1 c2 c3 d1 d2 d3.
Let in_a1 := turned a1 b1 c1 d1 d2 d3.
Let in_a2 := turned a2 b2 c2 d1 d2 d3.
Let in_a3 := turned a3 b3 c3 d1 d2 d3.

Lemma reach_range : 0 <= reach.
Proof. destruct sizes as (P & Q & S & <-). clear - P Q S. lia. Qed.

(* The margin, without its quotients. *)
Lemma margin_is : 35 * 1024 * reach + 24 * (reach * defect) + 16384 * 25100 <=
  16384 * slab_margin reach defect.
Proof.
  unfold slab_margin. cbv zeta. change (@kMarginUnit@) with 16. pose proof reach_range.
  assert (0 <= reach * defect) by (clear - H defects; nia). clear - H H0.
  set (rd := reach * defect) in *. clearbody rd.
  divisions. lia.
Qed.

Lemma vertex_off : exists e1 e2 e3, Z.abs e1 <= 2097152 /\ Z.abs e2 <= 2097152 /\ Z.abs e3 <= 2097152 /\
  one22 * v1 = m1 + 256 * o1 + e1 /\ one22 * v2 = m2 + 256 * o2 + e2 /\ one22 * v3 = m3 + 256 * o3 + e3.
Proof.
  assert (forall k l m o, exists e, Z.abs e <= 2097152 /\
    one22 * placed k l m o p q s = k * p + l * q + m * s + 256 * o + e) as G.
  { intros k l m o. exists (256 * (cell14 * placed k l m o p q s - o) - (k * p + l * q + m * s)).
    split; [|unfold one22, cell14; ring].
    pose proof (placed_off p q s k l m o) as E. cbv zeta in E.
    apply Z.abs_le. now apply root_bound. }
  destruct (G a1 b1 c1 o1) as (e1 & H1 & E1). destruct (G a2 b2 c2 o2) as (e2 & H2 & E2).
  destruct (G a3 b3 c3 o3) as (e3 & H3 & E3). exists e1, e2, e3. auto 7.
Qed.

Theorem slab_of_a : Z.abs (d1 * v1 + d2 * v2 + d3 * v3 - (in_b1 * p + in_b2 * q + in_b3 * s) -
  (d1 * w1 + d2 * w2 + d3 * w3)) <= slab_margin reach defect.
Proof.
  destruct vertex_off as (e1 & e2 & e3 & B1 & B2 & B3 & E1 & E2 & E3).
  pose proof (turned_near a1 a2 a3 d1 d2 d3 part1 part2 part3) as T1. fold in_b1 in T1.
  pose proof (turned_near b1 b2 b3 d1 d2 d3 part1 part2 part3) as T2. fold in_b2 in T2.
  pose proof (turned_near c1 c2 c3 d1 d2 d3 part1 part2 part3) as T3. fold in_b3 in T3.
  set (t1 := one22 * in_b1 - (a1 * d1 + a2 * d2 + a3 * d3)) in *.
  set (t2 := one22 * in_b2 - (b1 * d1 + b2 * d2 + b3 * d3)) in *.
  set (t3 := one22 * in_b3 - (c1 * d1 + c2 * d2 + c3 * d3)) in *.
  destruct sizes as (P & Q & S & R).
  pose proof (product_bound _ _ _ _ T1 P) as F1. pose proof (product_bound _ _ _ _ T2 Q) as F2.
  pose proof (product_bound _ _ _ _ T3 S) as F3.
  pose proof (product_bound _ _ _ _ part1 B1) as G1. pose proof (product_bound _ _ _ _ part2 B2) as G2.
  pose proof (product_bound _ _ _ _ part3 B3) as G3.
  pose proof (product_bound _ _ _ _ part1 (whole_near o1)) as H1.
  pose proof (product_bound _ _ _ _ part2 (whole_near o2)) as H2.
  pose proof (product_bound _ _ _ _ part3 (whole_near o3)) as H3.
  fold w1 in H1. fold w2 in H2. fold w3 in H3.
  set (off := d1 * v1 + d2 * v2 + d3 * v3 - (in_b1 * p + in_b2 * q + in_b3 * s) - (d1 * w1 + d2 * w2 + d3 * w3)).
  assert (one22 * off = - (t1 * p + t2 * q + t3 * s) + (d1 * e1 + d2 * e2 + d3 * e3) +
    (d1 * (256 * o1 - 256 * (cell14 * w1)) + d2 * (256 * o2 - 256 * (cell14 * w2)) +
     d3 * (256 * o3 - 256 * (cell14 * w3)))) as Off.
  { transitivity (d1 * (one22 * v1) + d2 * (one22 * v2) + d3 * (one22 * v3) -
      ((one22 * in_b1) * p + (one22 * in_b2) * q + (one22 * in_b3) * s) -
      one22 * (d1 * w1 + d2 * w2 + d3 * w3)); [unfold off; ring|].
    rewrite E1, E2, E3. unfold t1, t2, t3, m1, m2, m3, one22, cell14. ring. }
  assert (5242880 * mp + 5242880 * mq + 5242880 * ms = 5242880 * reach) as M by (rewrite <- R; ring).
  pose proof margin_is as L. pose proof reach_range as R0.
  assert (0 <= reach * defect) as R1 by (clear - R0 defects; nia).
  apply Z.abs_le in F1, F2, F3, G1, G2, G3, H1, H2, H3. apply Z.abs_le.
  revert Off F1 F2 F3 G1 G2 G3 H1 H2 H3 M L R0 R1. unfold most_part, one22.
  generalize (t1 * p) (t2 * q) (t3 * s) (d1 * e1) (d2 * e2) (d3 * e3) (reach * defect) (slab_margin reach defect)
    (d1 * (256 * o1 - 256 * (cell14 * w1))) (d2 * (256 * o2 - 256 * (cell14 * w2)))
    (d3 * (256 * o3 - 256 * (cell14 * w3))).
  clearbody off. clear. intros. lia.
Qed.
(* ---- A leaf of B. *)

Let g1 := a1 * d1 + b1 * d2 + c1 * d3.
Let g2 := a2 * d1 + b2 * d2 + c2 * d3.
Let g3 := a3 * d1 + b3 * d2 + c3 * d3.

Lemma entry_limit : 0 <= d <= 6442450944.
Proof. unfold d, one, one22. change (4194304 * 4194304 / 16777216) with 1048576. clear - defects. lia. Qed.

(* The effect on a direction of columns that are not exactly orthogonal. *)
Let skew1 := (a1 * a1 + a2 * a2 + a3 * a3 - one) * d1 + (a1 * b1 + a2 * b2 + a3 * b3) * d2 +
  (a1 * c1 + a2 * c2 + a3 * c3) * d3.
Let skew2 := (a1 * b1 + a2 * b2 + a3 * b3) * d1 + (b1 * b1 + b2 * b2 + b3 * b3 - one) * d2 +
  (b1 * c1 + b2 * c2 + b3 * c3) * d3.
Let skew3 := (a1 * c1 + a2 * c2 + a3 * c3) * d1 + (b1 * c1 + b2 * c2 + b3 * c3) * d2 +
  (c1 * c1 + c2 * c2 + c3 * c3 - one) * d3.

Lemma skews : Z.abs skew1 <= 24576 * d /\ Z.abs skew2 <= 24576 * d /\ Z.abs skew3 <= 24576 * d.
Proof.
  assert (forall u v w, Z.abs u <= d -> Z.abs v <= d -> Z.abs w <= d ->
    Z.abs (u * d1 + v * d2 + w * d3) <= 24576 * d) as G.
  { intros u v w U V W. pose proof (product_bound _ _ _ _ U part1). pose proof (product_bound _ _ _ _ V part2).
    pose proof (product_bound _ _ _ _ W part3). unfold most_part in *. revert H H0 H1.
    generalize (u * d1) (v * d2) (w * d3). clear. clearbody d. intros. lia. }
  unfold skew1, skew2, skew3. auto.
Qed.

Lemma turned_length : g1 * g1 + g2 * g2 + g3 * g3 <= 8192 * 8192 * (3 * one + 9 * d).
Proof.
  destruct skews as (K1 & K2 & K3).
  pose proof (product_bound _ _ _ _ K1 part1) as H1. pose proof (product_bound _ _ _ _ K2 part2) as H2.
  pose proof (product_bound _ _ _ _ K3 part3) as H3.
  assert (g1 * g1 + g2 * g2 + g3 * g3 = one * (d1 * d1 + d2 * d2 + d3 * d3) +
    (skew1 * d1 + skew2 * d2 + skew3 * d3)) as -> by (unfold g1, g2, g3, skew1, skew2, skew3; ring).
  pose proof (squares_bound _ _ _ _ part1 part2 part3) as S. change most_part with 8192 in S.
  assert (one * (d1 * d1 + d2 * d2 + d3 * d3) <= one * (3 * (8192 * 8192))) as S' by (now apply Z.mul_le_mono_nonneg_l).
  revert H1 H2 H3 S'. unfold most_part. generalize (skew1 * d1) (skew2 * d2) (skew3 * d3)
    (one * (d1 * d1 + d2 * d2 + d3 * d3)). clear. clearbody d one. intros. lia.
Qed.

Let h1 := one22 * in_a1 - g1.
Let h2 := one22 * in_a2 - g2.
Let h3 := one22 * in_a3 - g3.
Lemma h_small : Z.abs h1 <= 5242880 /\ Z.abs h2 <= 5242880 /\ Z.abs h3 <= 5242880.
Proof.
  split; [|split]; [apply (turned_near a1 b1 c1) | apply (turned_near a2 b2 c2) | apply (turned_near a3 b3 c3)]; auto.
Qed.

(* The sum of a rotated direction: three times 2^13, plus a rotation's stretch and rounding. *)
Theorem turned_sum : Z.abs in_a1 + Z.abs in_a2 + Z.abs in_a3 <= 3 * most_part + 18.
Proof.
  destruct h_small as (H1 & H2 & H3).
  destruct (sign in_a1) as (s1 & S1 & A1). destruct (sign in_a2) as (s2 & S2 & A2).
  destruct (sign in_a3) as (s3 & S3 & A3).
  assert (- (24590 * one22) <= s1 * g1 + s2 * g2 + s3 * g3 <= 24590 * one22) as C.
  { apply (cauchy _ _ _ _ _ _ 3 (8192 * 8192 * (3 * one + 9 * d))); [| exact turned_length | | easy].
    - clear - S1 S2 S3. destruct S1, S2, S3; subst; lia.
    - pose proof entry_limit as D. unfold one, one22. clear - D. clearbody d. lia. }
  assert (one22 * (Z.abs in_a1 + Z.abs in_a2 + Z.abs in_a3) =
    (s1 * g1 + s2 * g2 + s3 * g3) + (s1 * h1 + s2 * h2 + s3 * h3)) as E
    by (rewrite A1, A2, A3; unfold h1, h2, h3; ring).
  assert (s1 * h1 + s2 * h2 + s3 * h3 <= 3 * 5242880) as F by (clear - S1 S2 S3 H1 H2 H3; destruct S1, S2, S3; subst; lia).
  revert C E F. unfold most_part, one22. generalize (s1 * g1 + s2 * g2 + s3 * g3) (s1 * h1 + s2 * h2 + s3 * h3)
    (Z.abs in_a1 + Z.abs in_a2 + Z.abs in_a3). clear. intros. lia.
Qed.

Theorem slab_of_b : Z.abs (in_a1 * v1 + in_a2 * v2 + in_a3 * v3 - (d1 * p + d2 * q + d3 * s) -
  (in_a1 * w1 + in_a2 * w2 + in_a3 * w3)) <= slab_margin reach defect.
Proof.
  destruct vertex_off as (e1 & e2 & e3 & B1 & B2 & B3 & E1 & E2 & E3).
  destruct skews as (K1 & K2 & K3). destruct h_small as (H1 & H2 & H3).
  pose proof turned_sum as Sum. destruct sizes as (P & Q & S & R). pose proof reach_range as R0.
  pose proof entry_limit as D.
  pose proof (product_bound _ _ _ _ K1 P) as F1. pose proof (product_bound _ _ _ _ K2 Q) as F2.
  pose proof (product_bound _ _ _ _ K3 S) as F3.
  assert (- (9175040 * one22 * reach) <= h1 * m1 + h2 * m2 + h3 * m3 <= 9175040 * one22 * reach) as HM.
  { apply (cauchy _ _ _ _ _ _ (3 * (5242880 * 5242880)) ((one + d) * (reach * reach))).
    - now apply squares_bound.
    - exact (rotated_length a1 a2 a3 b1 b2 b3 c1 c2 c3 p q s mp mq ms reach defect sizes defects aa bb cc ab ac bc).
    - assert (3 * (5242880 * 5242880) * (one + d) <= 9175040 * one22 * (9175040 * one22)) as L
        by (unfold one, one22; clear - D; clearbody d; lia).
      replace (9175040 * one22 * reach * (9175040 * one22 * reach)) with
        (9175040 * one22 * (9175040 * one22) * (reach * reach)) by ring.
      rewrite Z.mul_assoc. apply Z.mul_le_mono_nonneg_r; [clear - R0; nia | exact L].
    - unfold one22. clear - R0. lia. }
  assert (forall u1 u2 u3, Z.abs u1 <= 2097152 -> Z.abs u2 <= 2097152 -> Z.abs u3 <= 2097152 ->
    Z.abs (in_a1 * u1 + in_a2 * u2 + in_a3 * u3) <= 2097152 * (3 * most_part + 18)) as Each.
  { intros u1 u2 u3 U1 U2 U3. pose proof (product_bound in_a1 u1 _ _ (Z.le_refl _) U1).
    pose proof (product_bound in_a2 u2 _ _ (Z.le_refl _) U2). pose proof (product_bound in_a3 u3 _ _ (Z.le_refl _) U3).
    revert H H0 H4 Sum. generalize (in_a1 * u1) (in_a2 * u2) (in_a3 * u3) (Z.abs in_a1) (Z.abs in_a2) (Z.abs in_a3).
    clear. intros. lia. }
  pose proof (Each _ _ _ B1 B2 B3) as T1.
  pose proof (Each _ _ _ (whole_near o1) (whole_near o2) (whole_near o3)) as T2. fold w1 w2 w3 in T2.
  set (off := in_a1 * v1 + in_a2 * v2 + in_a3 * v3 - (d1 * p + d2 * q + d3 * s) - (in_a1 * w1 + in_a2 * w2 + in_a3 * w3)).
  set (t1 := in_a1 * e1 + in_a2 * e2 + in_a3 * e3) in *.
  set (t2 := in_a1 * (256 * o1 - 256 * (cell14 * w1)) + in_a2 * (256 * o2 - 256 * (cell14 * w2)) +
    in_a3 * (256 * o3 - 256 * (cell14 * w3))) in *.
  assert (one * off = (skew1 * p + skew2 * q + skew3 * s) + (h1 * m1 + h2 * m2 + h3 * m3) + one22 * t1 + one22 * t2) as Off.
  { transitivity (one22 * (in_a1 * (one22 * v1) + in_a2 * (one22 * v2) + in_a3 * (one22 * v3)) -
      one * (d1 * p + d2 * q + d3 * s) - one22 * one22 * (in_a1 * w1 + in_a2 * w2 + in_a3 * w3));
      [unfold off, one; ring|].
    rewrite E1, E2, E3. unfold t1, t2, skew1, skew2, skew3, h1, h2, h3, g1, g2, g3, m1, m2, m3, one, one22, cell14. ring. }
  pose proof margin_is as L. assert (0 <= reach * defect) as R1 by (clear - R0 defects; nia).
  assert (24576 * d * mp + 24576 * d * mq + 24576 * d * ms = 25769803776 * (reach * defect)) as M.
  { rewrite <- R. unfold d, one, one22. change (4194304 * 4194304 / 16777216) with 1048576. ring. }
  apply Z.abs_le in F1, F2, F3, T1, T2. apply Z.abs_le.
  revert Off F1 F2 F3 HM T1 T2 L M. unfold one, one22, most_part.
  generalize (skew1 * p) (skew2 * q) (skew3 * s) (h1 * m1 + h2 * m2 + h3 * m3) (reach * defect) (slab_margin reach defect)
    (24576 * d * mp) (24576 * d * mq) (24576 * d * ms).
  clearbody off t1 t2. clear. intros. lia.
Qed.
End Slab.

Print Assumptions slab_of_a.
Print Assumptions slab_of_b.
Print Assumptions turned_sum.
