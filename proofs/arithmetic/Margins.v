(* The place of a rotated vertex, and that the box test's margins cover it: in the code's integers. Vectors have
   components x, y, z; one axis of A's lattice at a time.

   Fraction bits: given rotations 30, kept 22 (14 and 8 more), offsets and sums 14. *)
From Coq Require Import ZArith Lia Psatz.
Local Open Scope Z_scope.

Definition kMaxCoordinate := @kMaxCoordinate@.
Definition kHalf := @rotated_transform.cpp:kHalf@.        (* half a cell of 14 fraction bits *)
Definition cell14 := @kSplitOne@.
Definition rest8 := @2**kRestBits@.
Definition one22 := @2**kRotationBits@.
Definition one30 := @kRotationOne@.

Lemma floor x n : 0 < n -> n * (x / n) <= x < n * (x / n) + n.
Proof. intros N. pose proof (Z.div_mod x n). pose proof (Z.mod_pos_bound x n). lia. Qed.

(* Replaces each quotient by the defining inequalities of a floor. *)
Ltac divisions := repeat match goal with
  | |- context [?x / Zpos ?n] =>
      let q := fresh "q" in pose proof (floor x (Zpos n) eq_refl); set (q := x / Zpos n) in *; clearbody q
  | H : context [?x / Zpos ?n] |- _ =>
      let q := fresh "q" in pose proof (floor x (Zpos n) eq_refl); set (q := x / Zpos n) in *; clearbody q
  end.

Lemma product_bound e u d mu : Z.abs e <= d -> Z.abs u <= mu -> Z.abs (e * u) <= d * mu.
Proof. intros. rewrite Z.abs_mul. apply Z.mul_le_mono_nonneg; auto using Z.abs_nonneg. Qed.

Lemma seven r a b c d e f R A B C D E F :
  Z.abs r <= R -> Z.abs a <= A -> Z.abs b <= B -> Z.abs c <= C -> Z.abs d <= D -> Z.abs e <= E ->
  Z.abs f <= F -> Z.abs (r + (a + b + c + d + e + f)) <= R + (A + B + C + D + E + F).
Proof. rewrite !Z.abs_le. lia. Qed.

(* ---- Pose: an entry as given, kept, and split.
   code: src/lattice/pose.cpp | return ((given >> (kGivenBits - kKeptBits - 1)) + 1) >> 1;
   code: src/lattice/pose.cpp | coarse[j] = (r[i][j] + (1 << (detail::kRestBits - 1))) >> detail::kRestBits;
   code: src/lattice/pose.cpp | matrix_.rest[i][j] = static_cast<int8_t>(r[i][j] - coarse[j] * (1 << detail::kRestBits)); *)
Definition kept (given : Z) : Z := (given / (one30 / one22 / 2) + 1) / 2.
Definition coarse (k : Z) : Z := (k + rest8 / 2) / rest8.
Definition rest (k : Z) : Z := k - coarse k * rest8.

Theorem kept_near g : Z.abs (one30 / one22 * kept g - g) <= 128.
Proof.
  unfold kept. change (one30 / one22 / 2) with 128. change (one30 / one22) with 256. divisions. lia.
Qed.

Lemma split_product k u : k * u = 256 * (coarse k * u) + rest k * u.
Proof. unfold rest, rest8. ring. Qed.

Theorem rest_fits k : -128 <= rest k <= 127.
Proof. unfold rest, coarse, rest8. change (256 / 2) with 128. divisions. lia. Qed.

(* ---- Placing.
   code: src/bounds/rotated_transform.cpp | const int64_t sum = fraction + (1 << (kRestBits - 1)) + product(x, origin_b[0]) +
   code: src/bounds/rotated_transform.cpp | return clamp_offset(sum >> kRestBits);
   code: src/bounds/rotated_transform.cpp | const int32_t rest = add_signed_products(rest_.z * v.z, rest_.xy, v.xy);
   code: src/bounds/rotated_transform.cpp | const int32_t sum = add_signed_products(entries_.z * v.z + offset_, entries_.xy, v.xy); return (sum + (rest >> kRestBits)) >> kSplitBits;
   code: src/bounds/rotated_transform.cpp | offset_ = offset_of(transform.on_a[axis]) + kHalf; *)
Definition offset_along (cells fraction kx ky kz ox oy oz : Z) : Z :=
  (cells * one22 + fraction * (one22 / 65536) + kx * ox + ky * oy + kz * oz + rest8 / 2) / rest8.
(* If the high word passes this test, there is nothing to clamp.
   code: src/bounds/rotated_transform.cpp | constexpr int32_t most = kMaxOffset * kSplitOne >> (32 - kRestBits);
   code: src/bounds/rotated_transform.cpp | if (static_cast<uint32_t>(high + most) < 2u * most) { return static_cast<int32_t>(sum >> kRestBits); } *)
Definition farthest := @kMaxOffset * 2**kSplitBits@.
Theorem high_word_decides sum : let most := farthest / 2 ^ 24 in
  - most <= sum / 2 ^ 32 < most -> Z.abs (sum / rest8) <= farthest.
Proof.
  intros most H. change most with 46 in H. change (2 ^ 32) with 4294967296 in H. change rest8 with 256.
  unfold farthest. divisions. lia.
Qed.

(* If B's origin has coordinates of 16 bits, sums of 32 bits give equal results: coarse entries separate from the rest,
   and whole cells decide about clamping.
   code: src/bounds/rotated_transform.cpp | constexpr uint32_t half = 1u << 15;
   code: src/bounds/rotated_transform.cpp | return (raised(0) | raised(1) | raised(2)) < 2 * half;
   code: src/bounds/rotated_transform.cpp | const auto x = static_cast<int16_t>(xy); const int32_t y = static_cast<int32_t>(xy - static_cast<uint32_t>(x)) >> 16;
   code: src/bounds/rotated_transform.cpp | const int32_t parts = fraction + (1 << (kRestBits - 1)) + rest[0] * origin_b[0] + rest[1] * origin_b[1] + rest[2] * origin_b[2];
   code: src/bounds/rotated_transform.cpp | const int32_t turned = x * origin_b[0] + y * origin_b[1] + z * origin_b[2] + (parts >> kRestBits);
   code: src/bounds/rotated_transform.cpp | const auto whole = static_cast<int32_t>(static_cast<uint32_t>(turned >> kSplitBits) + static_cast<uint32_t>(cells));
   code: src/bounds/rotated_transform.cpp | if (static_cast<uint32_t>(whole) + kMaxOffset < 2u * kMaxOffset) { return static_cast<int32_t>(static_cast<uint32_t>(turned) + static_cast<uint32_t>(cells) * kSplitOne); } return whole < 0 ? -kMaxOffset * kSplitOne : kMaxOffset * kSplitOne; *)
Definition parts (fraction kx ky kz ox oy oz : Z) : Z :=
  fraction * (one22 / 65536) + rest8 / 2 + rest kx * ox + rest ky * oy + rest kz * oz.
Definition turned (fraction kx ky kz ox oy oz : Z) : Z :=
  coarse kx * ox + coarse ky * oy + coarse kz * oz + parts fraction kx ky kz ox oy oz / rest8.
Definition most_cells := @kMaxOffset@.

Theorem near_offset cells fraction kx ky kz ox oy oz :
  offset_along cells fraction kx ky kz ox oy oz = turned fraction kx ky kz ox oy oz + cells * cell14.
Proof.
  unfold offset_along, turned, parts, rest.
  replace (cells * one22 + _ + _ + _ + _ + _) with
    ((coarse kx * ox + coarse ky * oy + coarse kz * oz + cells * cell14) * rest8 +
     (fraction * (one22 / 65536) + rest8 / 2 + (kx - coarse kx * rest8) * ox +
      (ky - coarse ky * rest8) * oy + (kz - coarse kz * rest8) * oz))
    by (change one22 with (cell14 * rest8); lia).
  rewrite Z.div_add_l by easy. lia.
Qed.

(* One word contains both entries: the first is its signed low half, and the remainder the second. *)
Theorem entries_of_word x y : - 2 ^ 15 <= x < 2 ^ 15 ->
  let low := (x + 65536 * y) mod 65536 in
  let first := if low <? 2 ^ 15 then low else low - 65536 in
  first = x /\ (x + 65536 * y - first) / 65536 = y.
Proof.
  intros X. cbv zeta. change (2 ^ 15) with 32768 in *. destruct (Z.ltb_spec ((x + 65536 * y) mod 65536) 32768);
    Z.to_euclidean_division_equations; lia.
Qed.

Section Near.
Variables cells fraction kx ky kz ox oy oz : Z.
Hypothesis Kx : Z.abs kx <= one22 + 2 ^ 9.
Hypothesis Ky : Z.abs ky <= one22 + 2 ^ 9.
Hypothesis Kz : Z.abs kz <= one22 + 2 ^ 9.
Hypothesis Ox : - 2 ^ 15 <= ox < 2 ^ 15.
Hypothesis Oy : - 2 ^ 15 <= oy < 2 ^ 15.
Hypothesis Oz : - 2 ^ 15 <= oz < 2 ^ 15.
Hypothesis Part : Z.abs fraction <= 2 ^ 15.
Let turned' := turned fraction kx ky kz ox oy oz.
Let whole := turned' / cell14 + cells.

Theorem near_sums_fit :
  Z.abs (parts fraction kx ky kz ox oy oz) <= 2 ^ 24 /\ Z.abs turned' <= 2 ^ 31 - 2 ^ 28.
Proof.
  assert (forall k o, Z.abs k <= one22 + 2 ^ 9 -> - 2 ^ 15 <= o < 2 ^ 15 ->
    Z.abs (rest k * o) <= 128 * 32768 /\ Z.abs (coarse k * o) <= 16387 * 32768) as P.
  { intros k o K O. change (one22 + 2 ^ 9) with 4194816 in K. change (2 ^ 15) with 32768 in O. pose proof (rest_fits k).
    split; apply product_bound; try lia. unfold coarse, rest8. change (256 / 2) with 128. clear - K. divisions. lia. }
  destruct (P _ _ Kx Ox) as [Rx Cx], (P _ _ Ky Oy) as [Ry Cy], (P _ _ Kz Oz) as [Rz Cz].
  unfold turned', turned, parts. rewrite Z.abs_le in *. revert Part Rx Ry Rz Cx Cy Cz. clear.
  change (one22 / 65536) with 64. change rest8 with 256. change (256 / 2) with 128.
  change (2 ^ 15) with 32768. change (2 ^ 24) with 16777216. change (2 ^ 31 - 2 ^ 28) with 1879048192.
  generalize (rest kx * ox) (rest ky * oy) (rest kz * oz) (coarse kx * ox) (coarse ky * oy) (coarse kz * oz).
  intros. divisions. lia.
Qed.

(* The deciding sum does not wrap, and the result equals the clamped sum; cells times kSplitOne may wrap, their sum
   with the rest does not. *)
Theorem near_offset_clamped : Z.abs cells <= 2 ^ 30 -> Z.abs whole < 2 ^ 31 /\
  (if ((- most_cells <=? whole) && (whole <? most_cells))%bool then turned' + cells * cell14
   else if whole <? 0 then - farthest else farthest) =
  Z.max (- farthest) (Z.min farthest (offset_along cells fraction kx ky kz ox oy oz)).
Proof.
  intros Cells. rewrite near_offset. fold turned'. destruct near_sums_fit as [_ T].
  assert (Z.abs (turned' / cell14) <= 131072) as Q.
  { change (2 ^ 31 - 2 ^ 28) with 1879048192 in T. change cell14 with 16384. clearbody turned'.
    clear - T. divisions. lia. }
  change (2 ^ 30) with 1073741824 in Cells. change (2 ^ 31) with 2147483648.
  pose proof (floor turned' cell14 eq_refl) as F. fold whole in F.
  assert (cell14 * whole <= turned' + cells * cell14 < cell14 * whole + cell14) as W
    by (unfold whole; clear - F; lia).
  assert (Z.abs whole < 2147483648) as Fits by (unfold whole; clear - Cells Q; lia).
  split; [exact Fits |]. clear - W. clearbody whole turned'. unfold farthest, most_cells.
  change cell14 with 16384 in *.
  destruct (Z.leb_spec (- (48000)) whole); destruct (Z.ltb_spec whole 48000);
    destruct (Z.ltb_spec whole 0); cbn [andb]; lia.
Qed.
End Near.

Definition before_rounding (kx ky kz offset px py pz : Z) : Z :=
  coarse kx * px + coarse ky * py + coarse kz * pz +
  (rest kx * px + rest ky * py + rest kz * pz) / rest8 + offset + kHalf.
Definition placed (kx ky kz offset px py pz : Z) : Z :=
  before_rounding kx ky kz offset px py pz / cell14.

(* A vertex is placed within 0.51 cells of the exact place by the pose's given numbers, plus the turn of B's origin
   (ox, oy, oz) by keeping 22 bits: 2^-23 of its coordinates. In 2^-30 cell. *)
Theorem placed_within gx gy gz cells fraction ox oy oz px py pz :
  Z.abs px <= kMaxCoordinate -> Z.abs py <= kMaxCoordinate -> Z.abs pz <= kMaxCoordinate ->
  let offset := offset_along cells fraction (kept gx) (kept gy) (kept gz) ox oy oz in
  let exact := gx * (px + ox) + gy * (py + oy) + gz * (pz + oz) +
               cells * one30 + fraction * (one30 / 65536) in
  100 * Z.abs (one30 * placed (kept gx) (kept gy) (kept gz) offset px py pz - exact) <=
    51 * one30 + 100 * 128 * (Z.abs ox + Z.abs oy + Z.abs oz).
Proof.
  intros X Y Z0 offset exact. unfold kMaxCoordinate in *.
  assert (forall g u, Z.abs ((256 * kept g - g) * u) <= 128 * Z.abs u) as Entry.
  { intros g u. apply product_bound; [exact (kept_near g) | lia]. }
  pose proof (Entry gx px) as Ex. pose proof (Entry gy py) as Ey. pose proof (Entry gz pz) as Ez.
  pose proof (Entry gx ox) as Fx. pose proof (Entry gy oy) as Fy. pose proof (Entry gz oz) as Fz.
  pose proof (split_product (kept gx) px). pose proof (split_product (kept gy) py).
  pose proof (split_product (kept gz) pz).
  assert (one30 * placed (kept gx) (kept gy) (kept gz) offset px py pz - exact =
    (65536 * (cell14 * placed (kept gx) (kept gy) (kept gz) offset px py pz) -
      256 * (kept gx * (px + ox) + kept gy * (py + oy) + kept gz * (pz + oz) +
             cells * one22 + fraction * 64)) +
    ((256 * kept gx - gx) * px + (256 * kept gy - gy) * py + (256 * kept gz - gz) * pz +
     (256 * kept gx - gx) * ox + (256 * kept gy - gy) * oy + (256 * kept gz - gz) * oz)) as ->.
  { unfold exact, one30, one22, cell14. change (1073741824 / 65536) with 16384. ring. }
  assert (Z.abs (65536 * (cell14 * placed (kept gx) (kept gy) (kept gz) offset px py pz) -
      256 * (kept gx * (px + ox) + kept gy * (py + oy) + kept gz * (pz + oz) +
             cells * one22 + fraction * 64)) <= 536870912 + 200000) as Rounding.
  2:{ eapply Z.le_trans; [apply Z.mul_le_mono_nonneg_l; [easy | apply seven; eassumption]|].
      unfold one30. set (wx := Z.abs ox). set (wy := Z.abs oy). set (wz := Z.abs oz).
      set (vx := Z.abs px) in *. set (vy := Z.abs py) in *. set (vz := Z.abs pz) in *.
      clearbody vx vy vz wx wy wz. clear - X Y Z0. lia. }
  clear Ex Ey Ez Fx Fy Fz Entry X Y Z0 exact. apply Z.abs_le.
  unfold placed, before_rounding, offset, offset_along, kHalf, cell14, rest8, one22.
  change (4194304 / 65536) with 64. change (256 / 2) with 128.
  rewrite !Z.mul_add_distr_l.
  repeat match goal with H : kept ?k * ?u = _ |- _ => revert H end.
  generalize (coarse (kept gx) * px) (coarse (kept gy) * py) (coarse (kept gz) * pz) (rest (kept gx) * px)
    (rest (kept gy) * py) (rest (kept gz) * pz) (kept gx * px) (kept gy * py) (kept gz * pz) (kept gx * ox)
    (kept gy * oy) (kept gz * oz).
  intros. divisions. lia.
Qed.

(* ---- The rotated box on A's axes contains the placed vertices.
   code: src/bounds/rotated_transform.cpp | return ((most * reach_b) >> kRestBits) + 1;
   code: src/bounds/rotated_transform.cpp | matrix, reach_b) + kHalf);
   code: src/bounds/rotated_transform.cpp | constexpr int32_t kWidestMargin = 3 * kMaxCoordinate / 2 + 1 + kHalf; *)
Definition box_margin (most reach : Z) : Z := most * reach / rest8 + 1.
Definition times_upper (a lower upper : Z) : Z := if a <? 0 then a * lower else a * upper.

Section Box.
Variables kx ky kz offset most reach : Z.
Variables lx ly lz ux uy uz px py pz : Z.
Variables mx my mz : Z.
Hypothesis inside : lx <= px <= ux /\ ly <= py <= uy /\ lz <= pz <= uz.
Hypothesis sizes : Z.abs px <= mx /\ Z.abs py <= my /\ Z.abs pz <= mz.
Hypothesis reaches : mx + my + mz = reach.
Hypothesis rests : Z.abs (rest kx) <= most /\ Z.abs (rest ky) <= most /\ Z.abs (rest kz) <= most.

Lemma upper_product a l u p : l <= p <= u -> a * p <= times_upper a l u.
Proof. unfold times_upper. destruct (Z.ltb_spec a 0); nia. Qed.

Lemma rest_sum : Z.abs (rest kx * px + rest ky * py + rest kz * pz) <= most * reach.
Proof.
  destruct sizes as (P & Q & S), rests as (R1 & R2 & R3).
  pose proof (product_bound _ _ _ _ R1 P) as X. pose proof (product_bound _ _ _ _ R2 Q) as Y.
  pose proof (product_bound _ _ _ _ R3 S) as Z0. rewrite <- reaches, !Z.mul_add_distr_l.
  apply Z.abs_le in X, Y, Z0. apply Z.abs_le. clear - X Y Z0. lia.
Qed.

(* In whole cells, which the code compares. *)
Theorem below_upper_bound :
  placed kx ky kz offset px py pz <=
  (times_upper (coarse kx) lx ux + times_upper (coarse ky) ly uy + times_upper (coarse kz) lz uz +
   offset + box_margin most reach + kHalf) / cell14.
Proof.
  pose proof (upper_product (coarse kx) lx ux px). pose proof (upper_product (coarse ky) ly uy py).
  pose proof (upper_product (coarse kz) lz uz pz). pose proof rest_sum as R.
  apply Z.div_le_mono; [reflexivity|]. unfold before_rounding, box_margin, rest8.
  set (r := rest kx * px + rest ky * py + rest kz * pz) in *. clearbody r.
  assert (r / 256 <= most * reach / 256) by (apply Z.div_le_mono; lia). lia.
Qed.

Theorem above_lower_bound :
  - placed kx ky kz offset px py pz <=
  (times_upper (- coarse kx) lx ux + times_upper (- coarse ky) ly uy + times_upper (- coarse kz) lz uz
   - offset + box_margin most reach + kHalf) / cell14.
Proof.
  pose proof (upper_product (- coarse kx) lx ux px). pose proof (upper_product (- coarse ky) ly uy py).
  pose proof (upper_product (- coarse kz) lz uz pz). pose proof rest_sum as R.
  unfold placed, before_rounding, box_margin, rest8, cell14, kHalf.
  set (r := rest kx * px + rest ky * py + rest kz * pz) in *. clearbody r.
  assert (- (r / 256) <= most * reach / 256 + 1) by (divisions; lia).
  apply Z.div_le_lower_bound; [reflexivity|]. divisions. lia.
Qed.
End Box.

(* The test before boxes are prepared uses the margin of the largest lattice. *)
Theorem widest_margin most reach : 0 <= most <= 128 -> 0 <= reach <= 3 * kMaxCoordinate ->
  box_margin most reach + kHalf <= @kWidestMargin@.
Proof.
  unfold box_margin, rest8, kMaxCoordinate, kHalf. intros M R.
  assert (most * reach <= 128 * 49149) by nia. divisions. lia.
Qed.

(* ---- B's axes. A vertex (p, q, s) of B, placed at v in A, lies within the margin of the box test's place along B's
   first axis: the first column of the rotation, with 14 bits, times v, from the origin on. (For the other axes,
   exchange columns and coordinates.)
   code: src/bounds/rotated_transform.cpp | return 7 * (kSplitOne / 8) + ((7 * reach_b) >> 3) + static_cast<int32_t>(stretched >> 10) + 4;
   code: src/bounds/rotated_transform.cpp | on_b[axis] = start_of(column, clamp_offset(-(back >> kSplitBits)), margin); *)
Definition axis_margin (reach defect : Z) : Z :=
  7 * (cell14 / 8) + 7 * reach / 8 + reach * defect / 1024 + 4.

Lemma root_bound v b : 0 <= b -> v * v <= b * b -> - b <= v <= b.
Proof. nia. Qed.

(* The inequality of Cauchy and Schwarz, with bounds of both sums of squares. *)
Lemma cauchy u1 u2 u3 v1 v2 v3 u v b : u1 * u1 + u2 * u2 + u3 * u3 <= u ->
  v1 * v1 + v2 * v2 + v3 * v3 <= v -> u * v <= b * b -> 0 <= b ->
  - b <= u1 * v1 + u2 * v2 + u3 * v3 <= b.
Proof.
  intros U V B P. apply root_bound; auto.
  set (uu := u1 * u1 + u2 * u2 + u3 * u3) in *. set (vv := v1 * v1 + v2 * v2 + v3 * v3) in *.
  assert (uu * vv = (u1 * v1 + u2 * v2 + u3 * v3) * (u1 * v1 + u2 * v2 + u3 * v3) +
    (u1 * v2 - u2 * v1) * (u1 * v2 - u2 * v1) + (u1 * v3 - u3 * v1) * (u1 * v3 - u3 * v1) +
    (u2 * v3 - u3 * v2) * (u2 * v3 - u3 * v2)) as L by (unfold uu, vv; ring).
  assert (0 <= uu) by (unfold uu; nia). assert (0 <= vv) by (unfold vv; nia).
  assert (uu * vv <= u * v) by (apply Z.mul_le_mono_nonneg; lia).
  pose proof (Z.square_nonneg (u1 * v2 - u2 * v1)). pose proof (Z.square_nonneg (u1 * v3 - u3 * v1)).
  pose proof (Z.square_nonneg (u2 * v3 - u3 * v2)). lia.
Qed.

Lemma square_bound b e : - b <= e <= b -> e * e <= b * b.
Proof. nia. Qed.
Lemma squares_bound b u v w : Z.abs u <= b -> Z.abs v <= b -> Z.abs w <= b -> u * u + v * v + w * w <= 3 * (b * b).
Proof. intros U V W. apply Z.abs_le, square_bound in U, V, W. lia. Qed.
(* The square of an entry's 14 bits, compared with that of its 22. *)
Lemma coarse_square k : 65536 * (coarse k * coarse k) * 16384 <= 16385 * (k * k) + 16385 * 16384 * (128 * 128).
Proof.
  assert (256 * coarse k = k - rest k) as C by (unfold rest, rest8; ring).
  pose proof (rest_fits k) as F. assert (rest k * rest k <= 128 * 128) as R by (apply square_bound; lia).
  pose proof (Z.square_nonneg (k + 16384 * rest k)) as N.
  assert (65536 * (coarse k * coarse k) * 16384 = 16385 * (k * k) + 16385 * 16384 * (rest k * rest k) -
    (k + 16384 * rest k) * (k + 16384 * rest k)) as ->.
  { transitivity ((256 * coarse k) * (256 * coarse k) * 16384); [ring | rewrite C; ring]. }
  clear - R N. lia.
Qed.
Lemma term d e u v mu mv : Z.abs e <= d -> Z.abs u <= mu -> Z.abs v <= mv -> e * u * v <= d * mu * mv.
Proof.
  intros E U V. assert (Z.abs (e * u * v) <= d * mu * mv) as L by auto using product_bound.
  apply Z.abs_le in L. tauto.
Qed.

Section Axis.
Variables a1 a2 a3 b1 b2 b3 c1 c2 c3 : Z.     (* rows of the rotation: (a1, b1, c1), ... *)
Variables p q s mp mq ms reach defect : Z.
Variables o1 o2 o3 : Z.                       (* offsets along A's axes *)
Let one := one22 * one22.
Let d := defect * (one / @2**kDefectBits@).
Hypothesis sizes : Z.abs p <= mp /\ Z.abs q <= mq /\ Z.abs s <= ms /\ mp + mq + ms = reach.
Hypothesis defects : 0 <= defect <= 3 * @kMaxEntryDefect@.   (* pose.cpp refuses more *)
(* The defect bounds each entry of R^T R - 1 by its norm. *)
Hypothesis aa : Z.abs (a1 * a1 + a2 * a2 + a3 * a3 - one) <= d.
Hypothesis bb : Z.abs (b1 * b1 + b2 * b2 + b3 * b3 - one) <= d.
Hypothesis cc : Z.abs (c1 * c1 + c2 * c2 + c3 * c3 - one) <= d.
Hypothesis ab : Z.abs (a1 * b1 + a2 * b2 + a3 * b3) <= d.
Hypothesis ac : Z.abs (a1 * c1 + a2 * c2 + a3 * c3) <= d.
Hypothesis bc : Z.abs (b1 * c1 + b2 * c2 + b3 * c3) <= d.
Let m1 := a1 * p + b1 * q + c1 * s.
Let m2 := a2 * p + b2 * q + c2 * s.
Let m3 := a3 * p + b3 * q + c3 * s.

Lemma rotated_length : m1 * m1 + m2 * m2 + m3 * m3 <= (one + d) * (reach * reach).
Proof.
  destruct sizes as (P & Q & S & <-).
  pose proof (term _ _ p p _ _ aa P P) as E1. pose proof (term _ _ q q _ _ bb Q Q) as E2.
  pose proof (term _ _ s s _ _ cc S S) as E3. pose proof (term _ _ p q _ _ ab P Q) as E4.
  pose proof (term _ _ p s _ _ ac P S) as E5. pose proof (term _ _ q s _ _ bc Q S) as E6.
  assert (one * (p * p + q * q + s * s) <= one * ((mp + mq + ms) * (mp + mq + ms))) as L.
  { apply Z.mul_le_mono_nonneg_l; [easy|]. clear - P Q S.
    assert (p * p <= mp * mp) by nia. assert (q * q <= mq * mq) by nia. assert (s * s <= ms * ms) by nia.
    assert (0 <= mp * mq) by nia. assert (0 <= mp * ms) by nia. assert (0 <= mq * ms) by nia. lia. }
  assert (m1 * m1 + m2 * m2 + m3 * m3 = one * (p * p + q * q + s * s) +
    ((a1 * a1 + a2 * a2 + a3 * a3 - one) * p * p + (b1 * b1 + b2 * b2 + b3 * b3 - one) * q * q +
     (c1 * c1 + c2 * c2 + c3 * c3 - one) * s * s + 2 * ((a1 * b1 + a2 * b2 + a3 * b3) * p * q) +
     2 * ((a1 * c1 + a2 * c2 + a3 * c3) * p * s) + 2 * ((b1 * c1 + b2 * c2 + b3 * c3) * q * s))) as ->
    by (unfold m1, m2, m3; ring).
  revert E1 E2 E3 E4 E5 E6 L. clear. clearbody one d.
  generalize ((a1 * a1 + a2 * a2 + a3 * a3 - one) * p * p) ((b1 * b1 + b2 * b2 + b3 * b3 - one) * q * q)
    ((c1 * c1 + c2 * c2 + c3 * c3 - one) * s * s) ((a1 * b1 + a2 * b2 + a3 * b3) * p * q)
    ((a1 * c1 + a2 * c2 + a3 * c3) * p * s) ((b1 * c1 + b2 * c2 + b3 * c3) * q * s)
    (one * (p * p + q * q + s * s)).
  intros f1 f2 f3 f4 f5 f6 f7 E1 E2 E3 E4 E5 E6 L.
  replace ((one + d) * ((mp + mq + ms) * (mp + mq + ms))) with
    (one * ((mp + mq + ms) * (mp + mq + ms)) + (d * mp * mp + d * mq * mq + d * ms * ms +
     2 * (d * mp * mq) + 2 * (d * mp * ms) + 2 * (d * mq * ms))) by ring. lia.
Qed.

Let v1 := placed a1 b1 c1 o1 p q s.
Let v2 := placed a2 b2 c2 o2 p q s.
Let v3 := placed a3 b3 c3 o3 p q s.
Let back := coarse a1 * o1 + coarse a2 * o2 + coarse a3 * o3.

(* A placed coordinate is the rotated one plus the offset, within half a cell: in 2^-22 cell. *)
Lemma placed_off k l m o : let e := 256 * (cell14 * placed k l m o p q s - o) -
  (k * p + l * q + m * s) in e * e <= 2097152 * 2097152.
Proof.
  intros e. apply square_bound.
  unfold e. rewrite (split_product k p), (split_product l q), (split_product m s).
  unfold placed, before_rounding, kHalf, cell14, rest8.
  set (x := coarse k * p). set (y := coarse l * q). set (z := coarse m * s).
  set (x' := rest k * p). set (y' := rest l * q). set (z' := rest m * s).
  clearbody x y z x' y' z'. clear. divisions. lia.
Qed.

Theorem within_axis_margin : Z.abs (coarse a1 * v1 + coarse a2 * v2 + coarse a3 * v3 -
  back / cell14 - cell14 * p) <= axis_margin reach defect.
Proof.
  pose proof (placed_off a1 b1 c1 o1) as X1. pose proof (placed_off a2 b2 c2 o2) as X2.
  pose proof (placed_off a3 b3 c3 o3) as X3. cbn zeta in X1, X2, X3.
  fold v1 m1 in X1. fold v2 m2 in X2. fold v3 m3 in X3.
  set (e1 := 256 * (cell14 * v1 - o1) - m1) in *. set (e2 := 256 * (cell14 * v2 - o2) - m2) in *.
  set (e3 := 256 * (cell14 * v3 - o3) - m3) in *.
  pose proof rotated_length as Length.
  assert (0 <= reach) as Reach by (destruct sizes as (P & Q & S & <-); clear - P Q S; lia).
  assert (one = 17592186044416) as One by reflexivity.
  assert (d = defect * 1048576) as D by (unfold d; rewrite One; reflexivity).
  assert (0 <= d <= 6442450944) as DL by (rewrite D; pose proof defects as F; clear - F; lia).
  assert (forall k, rest k * rest k <= 128 * 128) as Rest by (intros k; apply square_bound; pose proof (rest_fits k) as F; clear - F; lia).
  pose proof (Rest a1) as H. pose proof (Rest a2) as H0. pose proof (Rest a3) as H1.
  (* the error of the column's 14 bits against 22 *)
  assert (- (939524096 * reach) <= rest a1 * m1 + rest a2 * m2 + rest a3 * m3 <= 939524096 * reach) as T2.
  { apply (cauchy _ _ _ _ _ _ (3 * (128 * 128)) ((one + d) * (reach * reach))).
    1: clear - H H0 H1; lia. 1: exact Length. 2: clear - Reach; lia.
    clear - One DL Reach. clearbody d one.
    assert (3 * (128 * 128) * (one + d) <= 939524096 * 939524096) by (rewrite One; lia).
    transitivity (939524096 * 939524096 * (reach * reach)); [|apply Z.eq_le_incl; ring].
    rewrite Z.mul_assoc. apply Z.mul_le_mono_nonneg_r; [nia | assumption]. }
  (* vertices' rounding *)
  pose proof (coarse_square a1) as H2. pose proof (coarse_square a2) as H3. pose proof (coarse_square a3) as H4.
  assert (coarse a1 * coarse a1 + coarse a2 * coarse a2 + coarse a3 * coarse a3 <= 268600000) as Column.
  { apply Z.abs_le in aa. revert H2 H3 H4 aa. rewrite One. clear - DL. clearbody d. intros. lia. }
  assert (Z.abs (coarse a1 * e1 + coarse a2 * e2 + coarse a3 * e3) <= 60129542144) as T3.
  { apply Z.abs_le. apply (cauchy _ _ _ _ _ _ 268600000 (3 * (2097152 * 2097152)));
      [exact Column | clear - X1 X2 X3; lia | easy | easy]. }
  (* columns that are not exactly orthogonal *)
  assert (Z.abs (a1 * m1 + a2 * m2 + a3 * m3 - one * p) <= d * reach) as T1.
  { destruct sizes as (P & Q & S & <-).
    assert (a1 * m1 + a2 * m2 + a3 * m3 - one * p = (a1 * a1 + a2 * a2 + a3 * a3 - one) * p +
      (a1 * b1 + a2 * b2 + a3 * b3) * q + (a1 * c1 + a2 * c2 + a3 * c3) * s) as ->
      by (unfold m1, m2, m3; ring).
    pose proof (product_bound _ p _ _ aa P) as Y1. pose proof (product_bound _ q _ _ ab Q) as Y2.
    pose proof (product_bound _ s _ _ ac S) as Y3.
    rewrite !Z.mul_add_distr_l. apply Z.abs_le in Y1, Y2, Y3. apply Z.abs_le. clear - Y1 Y2 Y3. lia. }
  pose proof (floor back cell14 eq_refl) as Back.
  set (g := coarse a1 * v1 + coarse a2 * v2 + coarse a3 * v3 - back / cell14 - cell14 * p).
  assert (1073741824 * g = (a1 * m1 + a2 * m2 + a3 * m3 - one * p) -
    (rest a1 * m1 + rest a2 * m2 + rest a3 * m3) + 256 * (coarse a1 * e1 + coarse a2 * e2 + coarse a3 * e3) +
    65536 * (back - cell14 * (back / cell14))) as G.
  { unfold g, e1, e2, e3, back. rewrite One. unfold rest, rest8, cell14. ring. }
  unfold axis_margin, cell14 in *. rewrite D in T1.
  pose proof (floor (7 * reach) 8 eq_refl) as H5. pose proof (floor (reach * defect) 1024 eq_refl) as H6.
  change (7 * (16384 / 8)) with 14336.
  apply Z.abs_le in T1, T3. apply Z.abs_le.
  assert (defect * 1048576 * reach = 1048576 * (reach * defect)) as E by ring. rewrite E in T1.
  set (rd := reach * defect) in *. clearbody rd g.
  set (t1 := a1 * m1 + a2 * m2 + a3 * m3 - one * p) in *.
  set (t2 := rest a1 * m1 + rest a2 * m2 + rest a3 * m3) in *.
  set (t3 := coarse a1 * e1 + coarse a2 * e2 + coarse a3 * e3) in *. clearbody t1 t2 t3.
  set (u := 7 * reach / 8) in *. set (w := rd / 1024) in *. set (bb' := back / 16384) in *.
  clearbody u w bb' back. clear - G T1 T2 T3 Back H5 H6 Reach. lia.
Qed.
End Axis.

Print Assumptions high_word_decides.
Print Assumptions near_offset.
Print Assumptions entries_of_word.
Print Assumptions near_sums_fit.
Print Assumptions near_offset_clamped.
Print Assumptions placed_within.
Print Assumptions below_upper_bound.
Print Assumptions above_lower_bound.
Print Assumptions widest_margin.
Print Assumptions within_axis_margin.
