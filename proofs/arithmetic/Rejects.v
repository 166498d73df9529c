(* Triangles that the tests under a rotation reject do not intersect: tests of boxes on A's axes and on B's, and of
   boxes or a leaf's corners against slabs of leaves of either side. With Slabs.v and Margins.v, this gives the premises of
   Query.v on `bound`, `begin` and `touch`. Sums are integers here; slab.g and box_rotated.smt2 prove that they fit
   32 bits. *)
From Coq Require Import List ZArith Lia Bool Psatz.
Require Import Margins Slabs Triangle.
Import ListNotations.
Local Open Scope Z_scope.

(* ============================================================== Definitions *)

Definition bias := @kBoundBias@.
Record Box := { low : Point; high : Point }.
Definition in_box (t : Box) (p : Point) : Prop :=
  x (low t) <= x p <= x (high t) /\ y (low t) <= y p <= y (high t) /\ z (low t) <= z p <= z (high t).
Definition on_lattice (t : Box) : Prop := forall p, in_box t p ->
  Z.abs (x p) <= kMaxCoordinate /\ Z.abs (y p) <= kMaxCoordinate /\ Z.abs (z p) <= kMaxCoordinate.

(* A row's products with a biased box: the upper bound, from `start` on; for the negated row, the negated lower bound.
   code: include/flashbvh/detail/lattice/split_matrix.hpp | return {join_halves(positive(x), positive(y)), join_halves(positive(-x), positive(-y)), join_halves(positive(z), positive(-z))};
   code: src/arch/portable/rotate_box.hpp | return whole_bound(add_products(add_products(add_products(start, row.positive_xy, box.upper_xy), row.negative_xy, box.lower_xy), row.z, box.z)); *)
Definition part (e : Z) : Z := Z.max e 0.
Definition bound_sum (start : Z) (e : Point) (t : Box) : Z :=
  start + (part (x e) * (x (high t) + bias) + part (- x e) * (bias - x (low t))) +
  (part (y e) * (y (high t) + bias) + part (- y e) * (bias - y (low t))) +
  (part (z e) * (z (high t) + bias) + part (- z e) * (bias - z (low t))).
Definition negated e := {| x := - x e; y := - y e; z := - z e |}.
Definition sizes_sum e := Z.abs (x e) + Z.abs (y e) + Z.abs (z e).

(* code: src/bounds/rotated_transform.cpp | const int32_t bias = (kSplitOne - row.sum()) * kBoundBias; return {bias + margin + offset, bias + margin - offset}; *)
Definition start_of (e : Point) (offset margin : Z) : Z := (cell14 - sizes_sum e) * bias + margin + offset.
(* code: src/arch/portable/rotate_box.hpp | return saturated<15>(bound >> kSplitBits); *)
Definition whole (sum : Z) : Z := Z.max 0 (Z.min 32767 (sum / cell14)).
(* code: include/flashbvh/detail/lattice/box_packed.hpp | ~((a.upper_xy + b.lower_xy) & (a.lower_xy + b.upper_xy) & (a.z + swap_halves(b.z))); *)
Definition axis_rejects (e : Point) (offset margin : Z) (t : Box) (lower upper : Z) : Prop :=
  whole (bound_sum (start_of e offset margin) e t) + (bias - lower) < 2 * bias \/
  whole (bound_sum (start_of e (- offset) margin) (negated e) t) + (upper + bias) < 2 * bias.

(* code: include/flashbvh/detail/bounds/slab.hpp | row_.z, box.z) >= least_upper_ &&
   code: include/flashbvh/detail/bounds/slab.hpp | least_upper_ = bias + along.least + offset - margin;
   code: include/flashbvh/detail/bounds/slab.hpp | least_lower_ = bias - along.most - offset - margin; *)
Definition slab_rejects (e : Point) (least most_ offset margin : Z) (t : Box) : Prop :=
  bound_sum 0 e t < sizes_sum e * bias + least + offset - margin \/
  bound_sum 0 (negated e) t < sizes_sum e * bias - most_ - offset - margin.

(* A leaf's corners against a slab: without the bias of boxes' bounds.
   code: include/flashbvh/detail/bounds/slab.hpp | const PackedVector seen = seen_direction(); const int32_t bias = row_.sum() * kBoundBias;
   code: include/flashbvh/detail/bounds/slab.hpp | const int32_t least = least_upper_ - bias; const int32_t least_negated = least_lower_ - bias;
   code: include/flashbvh/detail/bounds/slab.hpp | return {signed_difference(row_.positive_xy, row_.negative_xy), row_.z_entry()};
   code: include/flashbvh/detail/bounds/slab.hpp | const auto along = [&](Index i) { return dot(seen, PackedVector::of(vertices[i])); }; const int32_t first = along( *corner);
   code: include/flashbvh/detail/bounds/slab.hpp | if (first < least) { while (++corner != end && along( *corner) < least) { } } else if (-first < least_negated) { while (++corner != end && -along( *corner) < least_negated) { } } return corner != end; *)
Definition corners_reject (e : Point) (least most_ offset margin : Z) (those : list Point) : bool :=
  let least_upper := sizes_sum e * bias + least + offset - margin - sizes_sum e * bias in
  let least_lower := sizes_sum e * bias - most_ - offset - margin - sizes_sum e * bias in
  match those with
  | [] => false
  | p :: r =>
      if dot e p <? least_upper then forallb (fun q => dot e q <? least_upper) r
      else if - dot e p <? least_lower then forallb (fun q => - dot e q <? least_lower) r
      else false
  end.

(* All points lie on one side of a slab. *)
Definition beyond (e : Point) (least most_ offset margin : Z) (those : Point -> Prop) : Prop :=
  (forall p, those p -> dot e p < least + offset - margin) \/
  (forall p, those p -> most_ + offset + margin < dot e p).

(* Some plane has all points of one on one side, and all of the other on the other side. *)
Definition Apart (these those : Point -> Prop) : Prop := exists n,
  (forall w v, these w -> those v -> dot n w < dot n v) \/
  (forall w v, these w -> those v -> dot n v < dot n w).

(* Proves Apart along an axis, if the tactic proves one of its sides. *)
Ltac on_some_axis tac := let on n := exists n; unfold dot; cbn [x y z]; first [left; tac | right; tac] in
  first [on {| x := 1; y := 0; z := 0 |} | on {| x := 0; y := 1; z := 0 |} | on {| x := 0; y := 0; z := 1 |}].

(* ============================================================== Statements, and their proofs *)

Theorem apart_not_meet these those p q r s t o : Apart these those ->
  these p -> these q -> these r -> those s -> those t -> those o -> ~ meet p q r s t o.
Proof.
  assert (forall (these those : Point -> Prop) n p q r s t o, (forall w v, these w -> those v -> dot n w < dot n v) ->
    these p -> these q -> these r -> those s -> those t -> those o -> ~ meet p q r s t o) as G.
  { clear. intros these those n p q r s t o H P Q R S T O M.
    assert (exists a, these a /\ dot n p <= dot n a /\ dot n q <= dot n a /\ dot n r <= dot n a) as (a & A & L).
    { destruct (Z.le_ge_cases (dot n p) (dot n q)), (Z.le_ge_cases (dot n q) (dot n r)), (Z.le_ge_cases (dot n p) (dot n r));
        first [exists p; split; [assumption | lia] | exists q; split; [assumption | lia] | exists r; split; [assumption | lia]]. }
    assert (forall u, dot n (sub u a) = dot n u - dot n a) as E by (intros; unfold dot, sub; cbn [x y z]; ring).
    pose proof (H a s A S). pose proof (H a t A T). pose proof (H a o A O).
    apply (separates n a p q r s t o M); rewrite E; lia. }
  intros (n & [H | H]) P Q R S T O M; [now apply (G these those n p q r s t o)|].
  apply (G those these n s t o p q r); auto. now apply meet_swap.
Qed.

Lemma part_holds e u l p : l <= p <= u -> e * p + Z.abs e * bias <= part e * (u + bias) + part (- e) * (bias - l).
Proof.
  intros H. unfold part. destruct (Z.le_ge_cases 0 e) as [E|E].
  - rewrite (Z.abs_eq e), (Z.max_l e), (Z.max_r (- e)) by lia.
    assert (e * p <= e * u) by (apply Z.mul_le_mono_nonneg_l; lia). lia.
  - rewrite (Z.abs_neq e), (Z.max_r e), (Z.max_l (- e)) by lia.
    assert (- e * l <= - e * p) by (apply Z.mul_le_mono_nonneg_l; lia). lia.
Qed.

Lemma sum_holds start e t p : in_box t p -> start + dot e p + sizes_sum e * bias <= bound_sum start e t.
Proof.
  intros (X & Y & Z0). pose proof (part_holds (x e) _ _ _ X). pose proof (part_holds (y e) _ _ _ Y).
  pose proof (part_holds (z e) _ _ _ Z0). unfold bound_sum, dot, sizes_sum. lia.
Qed.
Lemma dot_negated e p : dot (negated e) p = - dot e p.
Proof. unfold dot, negated. cbn [x y z]. ring. Qed.
Lemma sizes_negated e : sizes_sum (negated e) = sizes_sum e.
Proof. unfold sizes_sum, negated. cbn [x y z]. lia. Qed.

Lemma whole_below sum b : 0 < b <= 32767 -> whole sum < b -> sum < cell14 * b.
Proof. unfold whole. intros B H. pose proof (floor sum cell14 eq_refl). unfold cell14 in *. lia. Qed.

Lemma axis_separates e offset margin t lower upper :
  - kMaxCoordinate <= lower -> upper <= kMaxCoordinate -> lower <= upper ->
  axis_rejects e offset margin t lower upper ->
  (forall p, in_box t p -> dot e p + offset + margin < cell14 * lower) \/
  (forall p, in_box t p -> cell14 * upper < dot e p + offset - margin).
Proof.
  unfold kMaxCoordinate. intros L U LU [H | H]; [left | right]; intros p P.
  - pose proof (sum_holds (start_of e offset margin) e t p P) as S.
    assert (bound_sum (start_of e offset margin) e t < cell14 * (bias + lower)) as W
      by (apply whole_below; unfold bias in *; lia).
    unfold start_of in S, W. lia.
  - pose proof (sum_holds (start_of e (- offset) margin) (negated e) t p P) as S.
    rewrite dot_negated, sizes_negated in S.
    assert (bound_sum (start_of e (- offset) margin) (negated e) t < cell14 * (bias - upper)) as W
      by (apply whole_below; unfold bias in *; lia).
    unfold start_of in S, W. lia.
Qed.

Theorem slab_separates e least most_ offset margin t : slab_rejects e least most_ offset margin t ->
  beyond e least most_ offset margin (in_box t).
Proof.
  intros [H | H]; [left | right]; intros p P.
  - pose proof (sum_holds 0 e t p P). lia.
  - pose proof (sum_holds 0 (negated e) t p P) as S. rewrite dot_negated, sizes_negated in S. lia.
Qed.

Theorem corners_separate e least most_ offset margin those : corners_reject e least most_ offset margin those = true ->
  beyond e least most_ offset margin (fun p => In p those).
Proof.
  destruct those as [|f r]; [easy|]. unfold corners_reject.
  destruct (Z.ltb_spec (dot e f) (sizes_sum e * bias + least + offset - margin - sizes_sum e * bias)) as [L|_];
    [|destruct (Z.ltb_spec (- dot e f) (sizes_sum e * bias - most_ - offset - margin - sizes_sum e * bias))
        as [L|_]; [|easy]];
    intros H; rewrite forallb_forall in H; [left | right]; intros p [<- | P]; try lia;
    specialize (H p P); apply Z.ltb_lt in H; lia.
Qed.

(* ---- A's axes, one at a time: kx ky kz is the row, along that axis. *)
Lemma box_on_a_axis kx ky kz offset most reach t lower upper :
  - kMaxCoordinate <= lower -> upper <= kMaxCoordinate -> lower <= upper ->
  Z.abs (rest kx) <= most /\ Z.abs (rest ky) <= most /\ Z.abs (rest kz) <= most ->
  axis_rejects {| x := coarse kx; y := coarse ky; z := coarse kz |} offset
    (box_margin most reach + kHalf) t lower upper ->
  (forall p, in_box t p -> Z.abs (x p) + Z.abs (y p) + Z.abs (z p) <= reach ->
     placed kx ky kz offset (x p) (y p) (z p) < lower) \/
  (forall p, in_box t p -> Z.abs (x p) + Z.abs (y p) + Z.abs (z p) <= reach ->
     upper < placed kx ky kz offset (x p) (y p) (z p)).
Proof.
  intros L U LU M H.
  assert (forall p, Z.abs (x p) + Z.abs (y p) + Z.abs (z p) <= reach -> let v := placed kx ky kz offset (x p) (y p) (z p) in
    cell14 * v <= coarse kx * x p + coarse ky * y p + coarse kz * z p + offset + (box_margin most reach + kHalf) /\
    coarse kx * x p + coarse ky * y p + coarse kz * z p + offset - (box_margin most reach + kHalf) <= cell14 * v) as Near.
  { intros p R v. set (mz := reach - Z.abs (x p) - Z.abs (y p)).
    assert (forall a q, times_upper a q q = a * q) as T by (intros; unfold times_upper; now destruct (_ <? _)).
    pose proof (below_upper_bound kx ky kz offset most reach (x p) (y p) (z p) (x p) (y p) (z p) (x p) (y p) (z p)
      (Z.abs (x p)) (Z.abs (y p)) mz ltac:(lia) ltac:(lia) ltac:(lia) M) as B.
    pose proof (above_lower_bound kx ky kz offset most reach (x p) (y p) (z p) (x p) (y p) (z p) (x p) (y p) (z p)
      (Z.abs (x p)) (Z.abs (y p)) mz ltac:(lia) ltac:(lia) ltac:(lia) M) as A.
    rewrite !T in A, B. fold v in A, B. clear M R. clearbody v. revert A B.
    generalize (box_margin most reach). intros g A B. unfold kHalf, cell14 in *. divisions. lia. }
  destruct (axis_separates _ _ _ _ _ _ L U LU H) as [S | S]; [left | right]; intros p P R;
    specialize (S p P); specialize (Near p R); unfold dot in S; cbn [x y z] in S; cbv zeta in Near;
    unfold cell14 in *; lia.
Qed.

(* ---- B's axes: n, a column.
   code: src/bounds/rotated_transform.cpp | const bool within = high == low >> 31 && static_cast<uint32_t>(low) + most <= 2u * most;
   code: src/bounds/rotated_transform.cpp | return within ? low : high < 0 ? -most : most; *)
Definition clamped (offset : Z) : Z :=
  Z.max (- (@kMaxOffset@ * cell14)) (Z.min (@kMaxOffset@ * cell14) offset).

Lemma box_on_b_axis n back margin t (those : Point -> Prop) (place : Point -> Point) (along : Point -> Z) lower upper :
  on_lattice t -> - kMaxCoordinate <= lower -> upper <= kMaxCoordinate -> lower <= upper ->
  0 <= margin <= 360000 -> dot n n <= 269000000 ->
  (forall u, those u -> Z.abs (dot n (place u) - back - cell14 * along u) <= margin /\ lower <= along u <= upper) ->
  axis_rejects n (clamped (- back)) margin t lower upper ->
  Apart (in_box t) (fun v => exists u, those u /\ v = place u).
Proof.
  intros T L U LU M N Near H.
  assert (forall w, in_box t w -> - 467000000 <= dot n w <= 467000000) as Far.
  { intros w W. destruct (T w W) as (X & Y & Z0). unfold kMaxCoordinate in *.
    apply (cauchy _ _ _ _ _ _ 269000000 805208067 467000000); [exact N | | easy | easy].
    now apply (squares_bound 16383). }
  exists n. unfold kMaxCoordinate, cell14, clamped in *. clear N T.
  destruct (axis_separates _ _ _ _ _ _ L U LU H) as [S | S]; [left | right]; intros w v W (u & P & ->);
    specialize (S w W); specialize (Far w W); destruct (Near u P) as [A B]; unfold cell14 in *; lia.
Qed.

(* ---- All tests, for one pose. *)
Lemma placed_swap kx ky kz o p q s : placed ky kx kz o q p s = placed kx ky kz o p q s.
Proof. unfold placed, before_rounding. do 4 f_equal; [ring | f_equal; ring]. Qed.
Lemma placed_turn kx ky kz o p q s : placed kz kx ky o s p q = placed kx ky kz o p q s.
Proof. unfold placed, before_rounding. do 4 f_equal; [ring | f_equal; ring]. Qed.

Lemma coarse_column k1 k2 k3 d : 0 <= d <= 6442450944 ->
  Z.abs (k1 * k1 + k2 * k2 + k3 * k3 - one22 * one22) <= d ->
  dot {| x := coarse k1; y := coarse k2; z := coarse k3 |} {| x := coarse k1; y := coarse k2; z := coarse k3 |} <= 269000000.
Proof.
  intros D K. unfold dot. cbn [x y z].
  pose proof (coarse_square k1). pose proof (coarse_square k2). pose proof (coarse_square k3). unfold one22 in *. lia.
Qed.

Section Turned.
Variables a1 a2 a3 b1 b2 b3 c1 c2 c3 : Z.   (* rows of the rotation: (a1, b1, c1), ... *)
Variables o1 o2 o3 mp mq ms reach most defect : Z.
Let one := one22 * one22.
Let d := defect * (one / @2**kDefectBits@).
Hypothesis reaches : mp + mq + ms = reach.
Hypothesis reach_most : reach <= 3 * kMaxCoordinate.
Hypothesis defects : 0 <= defect <= 3 * @kMaxEntryDefect@.
Hypothesis aa : Z.abs (a1 * a1 + a2 * a2 + a3 * a3 - one) <= d.
Hypothesis bb : Z.abs (b1 * b1 + b2 * b2 + b3 * b3 - one) <= d.
Hypothesis cc : Z.abs (c1 * c1 + c2 * c2 + c3 * c3 - one) <= d.
Hypothesis ab : Z.abs (a1 * b1 + a2 * b2 + a3 * b3) <= d.
Hypothesis ac : Z.abs (a1 * c1 + a2 * c2 + a3 * c3) <= d.
Hypothesis bc : Z.abs (b1 * c1 + b2 * c2 + b3 * c3) <= d.
Let small k := Z.abs (rest k) <= most.
Hypothesis rests : (small a1 /\ small b1 /\ small c1) /\ (small a2 /\ small b2 /\ small c2) /\ (small a3 /\ small b3 /\ small c3).
Variables box_a box_b : Box.
Let ordered t := x (low t) <= x (high t) /\ y (low t) <= y (high t) /\ z (low t) <= z (high t).
Let limited t := - kMaxCoordinate <= x (low t) /\ x (high t) <= kMaxCoordinate /\ - kMaxCoordinate <= y (low t) /\
  y (high t) <= kMaxCoordinate /\ - kMaxCoordinate <= z (low t) /\ z (high t) <= kMaxCoordinate.
Hypothesis orders : ordered box_a /\ ordered box_b.
Hypothesis limits : limited box_a /\ limited box_b.
Definition reached (u : Point) : Prop := Z.abs (x u) <= mp /\ Z.abs (y u) <= mq /\ Z.abs (z u) <= ms.
Hypothesis in_reach : forall u, in_box box_b u -> reached u.

Definition place (u : Point) : Point := {| x := placed a1 b1 c1 o1 (x u) (y u) (z u);
  y := placed a2 b2 c2 o2 (x u) (y u) (z u); z := placed a3 b3 c3 o3 (x u) (y u) (z u) |}.
Definition placed_of (these : Point -> Prop) (v : Point) : Prop := exists u, these u /\ v = place u.
Definition column k1 k2 k3 := {| x := coarse k1; y := coarse k2; z := coarse k3 |}.
Definition back k1 k2 k3 := (coarse k1 * o1 + coarse k2 * o2 + coarse k3 * o3) / cell14.

(* A box of B on A's axes, a box of A on B's; a window is one of the two tests. *)
Definition rejects_on_a : Prop :=
  let on_a kx ky kz o := axis_rejects (column kx ky kz) o (box_margin most reach + kHalf) box_b in
  on_a a1 b1 c1 o1 (x (low box_a)) (x (high box_a)) \/ on_a a2 b2 c2 o2 (y (low box_a)) (y (high box_a)) \/
  on_a a3 b3 c3 o3 (z (low box_a)) (z (high box_a)).
Definition rejects_on_b : Prop :=
  let on_b k1 k2 k3 := axis_rejects (column k1 k2 k3) (clamped (- back k1 k2 k3)) (axis_margin reach defect) box_a in
  on_b a1 a2 a3 (x (low box_b)) (x (high box_b)) \/ on_b b1 b2 b3 (y (low box_b)) (y (high box_b)) \/
  on_b c1 c2 c3 (z (low box_b)) (z (high box_b)).
Definition boxes_reject : Prop := rejects_on_a \/ rejects_on_b.

Lemma lattice_a : on_lattice box_a.
Proof. destruct limits as [L _]. intros p P. unfold in_box, limited, kMaxCoordinate in *. clear - L P. rewrite !Z.abs_le. lia. Qed.
Lemma reach_sum u : reached u -> Z.abs (x u) + Z.abs (y u) + Z.abs (z u) <= reach.
Proof. unfold reached. clear - reaches. lia. Qed.
Lemma small_axis_margin u : reached u -> 0 <= axis_margin reach defect <= 360000.
Proof.
  intros R. apply reach_sum in R. unfold axis_margin, cell14, kMaxCoordinate in *.
  assert (0 <= reach) by (clear - R; lia). assert (0 <= reach * defect <= 49149 * 6144) by (clear - H reach_most defects; nia).
  clear - H H0 reach_most. change (16384 / 8) with 2048. set (rd := reach * defect) in *. clearbody rd. divisions. lia.
Qed.

(* A point of B along each of B's axes, by the theorem of the first one. *)
Lemma near_on_b u : reached u ->
  let near k1 k2 k3 k := Z.abs (dot (column k1 k2 k3) (place u) - back k1 k2 k3 - cell14 * k) <= axis_margin reach defect in
  near a1 a2 a3 (x u) /\ near b1 b2 b3 (y u) /\ near c1 c2 c3 (z u).
Proof.
  intros (X & Y & Z0). split; [|split].
  - apply (within_axis_margin a1 a2 a3 b1 b2 b3 c1 c2 c3 _ _ _ mp mq ms); auto.
  - unfold dot, place, column. cbn [x y z]. rewrite <- (placed_swap a1), <- (placed_swap a2), <- (placed_swap a3).
    apply (within_axis_margin b1 b2 b3 a1 a2 a3 c1 c2 c3 _ _ _ mq mp ms); auto; [|clear - ab; subst d one; lia].
    clear - X Y Z0 reaches. lia.
  - unfold dot, place, column. cbn [x y z]. rewrite <- (placed_turn a1), <- (placed_turn a2), <- (placed_turn a3).
    apply (within_axis_margin c1 c2 c3 a1 a2 a3 b1 b2 b3 _ _ _ ms mp mq); auto; [|clear - ac; subst d one; lia|clear - bc; subst d one; lia].
    clear - X Y Z0 reaches. lia.
Qed.

Theorem boxes_reject_safely : boxes_reject -> Apart (in_box box_a) (placed_of (in_box box_b)).
Proof.
  destruct rests as (R1 & R2 & R3). destruct orders as [(OX & OY & OZ) (PX & PY & PZ)].
  destruct limits as [(LX & HX & LY & HY & LZ & HZ) (MX & NX & MY & NY & MZ & NZ)].
  intros [[H | [H | H]] | [H | [H | H]]].
  1: pose proof (box_on_a_axis _ _ _ _ _ _ _ _ _ LX HX OX R1 H) as Side.
  2: pose proof (box_on_a_axis _ _ _ _ _ _ _ _ _ LY HY OY R2 H) as Side.
  3: pose proof (box_on_a_axis _ _ _ _ _ _ _ _ _ LZ HZ OZ R3 H) as Side.
  1-3: destruct Side as [S | S]; on_some_axis ltac:(intros w v (WX & WY & WZ) (u & U & ->);
    specialize (S u U (reach_sum u (in_reach u U))); cbn [place x y z]; clear - S WX WY WZ; lia).
  all: assert (in_box box_b (low box_b)) as Some_ by (unfold in_box; clear - PX PY PZ; lia);
    pose proof (small_axis_margin _ (in_reach _ Some_)) as Margin; pose proof (entry_limit defect defects) as D.
  1: apply (box_on_b_axis _ (back a1 a2 a3) _ _ (in_box box_b) place x _ _ lattice_a MX NX PX Margin
    (coarse_column _ _ _ d D aa)) in H; auto.
  2: apply (box_on_b_axis _ (back b1 b2 b3) _ _ (in_box box_b) place y _ _ lattice_a MY NY PY Margin
    (coarse_column _ _ _ d D bb)) in H; auto.
  3: apply (box_on_b_axis _ (back c1 c2 c3) _ _ (in_box box_b) place z _ _ lattice_a MZ NZ PZ Margin
    (coarse_column _ _ _ d D cc)) in H; auto.
  all: intros u U; pose proof (near_on_b u (in_reach u U)) as N; cbv zeta in N; split; [apply N | apply U].
Qed.

(* ---- Slabs. `e`: a direction of 13 bits, of a leaf of A, and then of B. *)
Variable e : Point.
Hypothesis parts : Z.abs (x e) <= most_part /\ Z.abs (y e) <= most_part /\ Z.abs (z e) <= most_part.
Variables least most_ : Z.
Definition between (p : Point) : Prop := least <= dot e p <= most_.
Definition origin := {| x := whole_cells o1; y := whole_cells o2; z := whole_cells o3 |}.
Definition seen_from_b := {| x := turned a1 a2 a3 (x e) (y e) (z e); y := turned b1 b2 b3 (x e) (y e) (z e);
  z := turned c1 c2 c3 (x e) (y e) (z e) |}.
Definition seen_from_a := {| x := turned a1 b1 c1 (x e) (y e) (z e); y := turned a2 b2 c2 (x e) (y e) (z e);
  z := turned a3 b3 c3 (x e) (y e) (z e) |}.

(* code: src/bounds/slab.cpp | const PackedVector seen = rotated(of_a ? rotation.columns : rotation.matrix->rows, own);
   code: src/bounds/slab.cpp | const int32_t along = origin_along(of_a ? own : seen, rotation);
   code: src/bounds/slab.cpp | set_row(seen, of_a ? -along : along, transform.slab_margin()); *)
Theorem slab_of_a_rejects_safely (those : Point -> Prop) : (forall u, those u -> reached u) ->
  beyond seen_from_b least most_ (- dot e origin) (slab_margin reach defect) those ->
  Apart between (placed_of those).
Proof.
  destruct parts as (P1 & P2 & P3). intros R H. exists e.
  assert (forall u, those u -> Z.abs (dot e (place u) - dot seen_from_b u - dot e origin) <= slab_margin reach defect) as Near.
  { intros u U. destruct (R u U) as (Q1 & Q2 & Q3).
    exact (slab_of_a a1 a2 a3 b1 b2 b3 c1 c2 c3 (x u) (y u) (z u) mp mq ms reach defect o1 o2 o3
      (conj Q1 (conj Q2 (conj Q3 reaches))) defects (x e) (y e) (z e) P1 P2 P3). }
  clear - H Near. destruct H as [S | S]; [right | left];
    intros w v W (u & U & ->); specialize (S u U); specialize (Near u U); unfold between in W; lia.
Qed.

Theorem slab_of_b_rejects_safely (these : Point -> Prop) :
  beyond seen_from_a least most_ (dot seen_from_a origin) (slab_margin reach defect) these ->
  Apart these (placed_of (fun u => reached u /\ between u)).
Proof.
  destruct parts as (P1 & P2 & P3). intros H. exists seen_from_a.
  assert (forall u, reached u -> Z.abs (dot seen_from_a (place u) - dot e u - dot seen_from_a origin) <= slab_margin reach defect) as Near.
  { intros u (Q1 & Q2 & Q3).
    exact (slab_of_b a1 a2 a3 b1 b2 b3 c1 c2 c3 (x u) (y u) (z u) mp mq ms reach defect o1 o2 o3
      (conj Q1 (conj Q2 (conj Q3 reaches))) defects aa bb cc ab ac bc (x e) (y e) (z e) P1 P2 P3). }
  clear - H Near. destruct H as [S | S]; [left | right];
    intros w v W (u & (U & B) & ->); specialize (S w W); specialize (Near u U); unfold between in B; lia.
Qed.
End Turned.

(* ---- Slabs under a translation by o have no margin.
   code: include/flashbvh/detail/bounds/slab.hpp | set_row(d, of == Side::a ? -along : along, 0); *)
Definition moved_by (o : Point) (these : Point -> Prop) (v : Point) : Prop :=
  exists u, these u /\ v = {| x := x u + x o; y := y u + y o; z := z u + z o |}.
Theorem translated_slabs_reject_safely e least most_ o (those : Point -> Prop) :
  (beyond e least most_ (- dot e o) 0 those -> Apart (between e least most_) (moved_by o those)) /\
  (beyond e least most_ (dot e o) 0 those -> Apart those (moved_by o (between e least most_))).
Proof.
  assert (forall u, dot e {| x := x u + x o; y := y u + y o; z := z u + z o |} = dot e u + dot e o) as E
    by (intros u; unfold dot; cbn [x y z]; ring).
  split; intros [S | S]; exists e; [right | left | left | right];
    intros w v W (u & U & ->); rewrite E; unfold between in *;
    [specialize (S u U) | specialize (S u U) | specialize (S w W) | specialize (S w W)]; lia.
Qed.

Print Assumptions apart_not_meet.
Print Assumptions boxes_reject_safely.
Print Assumptions slab_separates.
Print Assumptions corners_separate.
Print Assumptions slab_of_a_rejects_safely.
Print Assumptions slab_of_b_rejects_safely.
Print Assumptions translated_slabs_reject_safely.
