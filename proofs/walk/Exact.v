(* The complete answers of a query: for any two opened images and any pose, they are exactly the pairs of triangles with
   a common point, each once, wherever the query is cut. Query.v leaves open which pairs boxes and slabs reject, and
   Rejects.v which tests a query makes; this file has the data of each node of an image, and so the tests of each pair.

   Remaining premises: a rotation's columns are orthogonal within its defect (Near_rotation), and leaves share no
   triangle. Slabs that a query makes may have any directions of 13 bits; baked ones are any that open accepts. gappa
   and cvc5 prove the widths of integers.

   Part 1  definitions.   Part 2  the theorems.   Part 3  their proofs. *)
From Coq Require Import List ZArith Lia Bool FinFun.
Require Import Constants Ranked Code Query Image Margins Slabs Triangle Segment Test Rejects.
Import ListNotations.
Local Open Scope Z_scope.

(* ============================================================== Part 1: definitions *)

(* Decides comparisons and their disjunctions. *)
Class Dec (P : Prop) := dec : {P} + {~ P}.
Local Instance dec_less a b : Dec (a < b) := Z_lt_dec a b.
Local Instance dec_or P Q : Dec P -> Dec Q -> Dec (P \/ Q).
Proof. intros [] []; [left | left | left | right]; tauto. Defined.
Definition decide P {d : Dec P} : bool := if d then true else false.

(* ---- A slab, and its baked form: a direction of bytes, the thickness's code, and the extent's begin in units.
   code: include/flashbvh/detail/lattice/baked_slab.hpp | const int32_t least = slabs.least[which] * (1 << kSlabUnitBits); const uint32_t thickness = (d.thickness & 31u) << (kSlabUnitBits + 2 * (d.thickness >> 5));
   code: include/flashbvh/detail/lattice/baked_slab.hpp | return {{join_halves(static_cast<uint16_t>(d.x * scale), static_cast<uint16_t>(d.y * scale)), d.z * scale}, least, least + static_cast<int32_t>(thickness)}; *)
Record Slab := { direction : Point; from : Z; to : Z }.
Record Baked := { towards : Point; thickness : Z; units : Z }.
Definition begun b : Slab :=
  let scaled c := c * @baked_slab.hpp:scale@ in let start := units b * @2**kSlabUnitBits@ in
  {| direction := {| x := scaled (x (towards b)); y := scaled (y (towards b)); z := scaled (z (towards b)) |};
    from := start; to := start + (thickness b mod 32) * 2 ^ (@kSlabUnitBits@ + 2 * (thickness b / 32)) |}.

(* ---- An image: nodes, their boxes, and triangles by their slots; for a leaf, by its node, its triangles and its
   slabs, the plane's first: baked, or made along directions. *)
Record Image := { cells : list Cell; box : nat -> Box; corners : nat -> Point * Point * Point;
  own_triangles : nat -> list nat; directions : nat -> list Point; baked : nat -> list Baked }.
Definition triangles m n := if (n <? length (cells m))%nat then own_triangles m n else [].
Definition points (t : Point * Point * Point) : list Point := let '(p, q, r) := t in [p; q; r].
Definition leaf_points m n := flat_map (fun i => points (corners m i)) (triangles m n).

(* The checks of opening, in addition to those in Image.v.
   code: src/lattice/tree_check.cpp | return ((box.upper_xy | box.lower_xy | box.z) & 0x80008000u) == 0;
   code: src/lattice/tree_check.cpp | return is_inside(pack({p, p}), box) && is_inside(pack({q, q}), box) && is_inside(pack({r, r}), box); *)
Definition is_inside (s t : Box) : bool :=
  (x (low t) <=? x (low s)) && (y (low t) <=? y (low s)) && (z (low t) <=? z (low s)) &&
  (x (high s) <=? x (high t)) && (y (high s) <=? y (high t)) && (z (high s) <=? z (high t)).
Definition lattice : Box :=
  let at_ c := {| x := c; y := c; z := c |} in {| low := at_ (- kMaxCoordinate); high := at_ kMaxCoordinate |}.
(* code: src/lattice/tree_check.cpp | return d.x != INT8_MIN && d.y != INT8_MIN && d.z != INT8_MIN && least + ((d.thickness & 31) << 2 * (d.thickness >> 5)) <= most;
   code: src/lattice/tree_check.cpp | if (!is_in_range(slabs.of[which], slabs.least[which])) { return false; }
   code: src/lattice/tree_check.cpp | const Index* const corner_end = tree_.triangles[end].corner; for (const Index* corner = tree_.triangles[first].corner; corner != corner_end; ++corner) {
   code: src/lattice/tree_check.cpp | if (along < within.least || along > within.most) { return false; }
   code: src/lattice/tree_check.cpp | if (tree_.slabs != nullptr && !slabs(tree_.slabs[leaves_], first, end)) { return false; } *)
Definition is_in_range b : bool := let '{| x := p; y := q; z := r |} := towards b in
  negb (p =? -128) && negb (q =? -128) && negb (r =? -128) &&
  (units b + (thickness b mod 32) * 2 ^ (2 * (thickness b / 32)) <=? @tree_check.cpp:most@).
Definition holds s those : bool :=
  forallb (fun p => (from s <=? dot (direction s) p) && (dot (direction s) p <=? to s)) those.
Definition opens m : bool :=
  accepts (cells m) (fun inner outer => is_inside (box m inner) (box m outer)) &&
  forallb (fun n => is_inside (box m n) lattice &&
    forallb (fun p => is_inside {| low := p; high := p |} (box m n)) (leaf_points m n) &&
    forallb (fun b => is_in_range b && holds (begun b) (leaf_points m n)) (baked m n)) (seq 0 (length (cells m))).
Definition within most e : Prop := Z.abs (x e) <= most /\ Z.abs (y e) <= most /\ Z.abs (z e) <= most.
Definition has_widths b : Prop := let byte c := -128 <= c < 128 in
  byte (x (towards b)) /\ byte (y (towards b)) /\ byte (z (towards b)) /\ 0 <= thickness b < 256 /\
  - 2 ^ 15 <= units b < 2 ^ 15.
Definition sound m : Prop :=
  (forall n, (forall e, In e (directions m n) -> within most_part e) /\ (forall b, In b (baked m n) -> has_widths b)) /\
  (forall n, NoDup (triangles m n)) /\
  (forall n k i, In i (triangles m n) -> In i (triangles m k) -> n = k).

(* The coordinates of points along a direction.
   code: include/flashbvh/detail/bounds/slab.hpp | Extent along = {at, at}; along.add(dot(direction, q)); along.add(dot(direction, r));
   code: include/flashbvh/detail/walk/leaf_planes.hpp | extent.add(triangle(m, i).extent(direction)); *)
Definition extreme (choose : Z -> Z -> Z) e (those : list Point) : Z :=
  match those with [] => 0 | p :: r => fold_right (fun q => choose (dot e q)) (dot e p) r end.
Definition least := extreme Z.min.
Definition most := extreme Z.max.

(* A leaf's slabs.
   code: include/flashbvh/detail/walk/leaf_planes.hpp | if (m.slabs != nullptr) { plane.begin(BakedSlab::of(m.slabs[node_->leaf()], 0)); return true; }
   code: include/flashbvh/detail/walk/leaf_planes.hpp | if (m.slabs != nullptr) { edge.begin(BakedSlab::of(m.slabs[node_->leaf()], 1)); return true; } *)
Definition baked_slabs m n : list Slab := map begun (baked m n).
Definition slabs m n : list Slab := match baked_slabs m n with
  | [] => let those := leaf_points m n in
      map (fun e => {| direction := e; from := least e those; to := most e those |}) (directions m n)
  | those => those
  end.

(* ---- The pose of B: translated by whole cells, or rotated (rows a1 b1 c1, ... of 22 fraction bits, offsets of 14)
   with a defect of kDefectBits. *)
Record Rotation := { a1 : Z; a2 : Z; a3 : Z; b1 : Z; b2 : Z; b3 : Z; c1 : Z; c2 : Z; c3 : Z;
  o1 : Z; o2 : Z; o3 : Z; defect : Z }.
Inductive Pose := Moved (by_ : Point) | Turned (r : Rotation).

Definition with_entries {T} (f : Z -> Z -> Z -> Z -> Z -> Z -> Z -> Z -> Z -> T) r : T :=
  f (a1 r) (a2 r) (a3 r) (b1 r) (b2 r) (b3 r) (c1 r) (c2 r) (c3 r).
Definition with_all {T} (f : Z -> Z -> Z -> Z -> Z -> Z -> Z -> Z -> Z -> Z -> Z -> Z -> T) r : T :=
  with_entries f r (o1 r) (o2 r) (o3 r).
(* code: src/bounds/rotated_transform.cpp | most = size > most ? size : most; *)
Definition most_rest r : Z :=
  let size k := Z.abs (rest k) in
  Z.max (Z.max (Z.max (size (a1 r)) (size (b1 r))) (Z.max (size (c1 r)) (size (a2 r))))
    (Z.max (Z.max (size (b2 r)) (size (c2 r))) (Z.max (Z.max (size (a3 r)) (size (b3 r))) (size (c3 r)))).

Definition Near_rotation r : Prop :=
  let one := one22 * one22 in
  let small u := Z.abs u <= defect r * (one / @2**kDefectBits@) in
  0 <= defect r <= 3 * @kMaxEntryDefect@ /\
  small (a1 r * a1 r + a2 r * a2 r + a3 r * a3 r - one) /\ small (b1 r * b1 r + b2 r * b2 r + b3 r * b3 r - one) /\
  small (c1 r * c1 r + c2 r * c2 r + c3 r * c3 r - one) /\ small (a1 r * b1 r + a2 r * b2 r + a3 r * b3 r) /\
  small (a1 r * c1 r + a2 r * c2 r + a3 r * c3 r) /\ small (b1 r * c1 r + b2 r * c2 r + b3 r * c3 r).
Definition fits (pose : Pose) : Prop := match pose with Moved _ => True | Turned r => Near_rotation r end.

(* code: include/flashbvh/detail/bounds/transform.hpp | return {v.x + o.x, v.y + o.y, v.z + o.z}; *)
Definition put pose (u : Point) : Point :=
  match pose with
  | Moved o => {| x := x u + x o; y := y u + y o; z := z u + z o |}
  | Turned r => with_all place r u
  end.

(* code: include/flashbvh/detail/lattice/box_packed.hpp | return static_cast<int32_t>(upper > lower ? upper : lower) - kBoundBias; *)
Definition reach_along (c : Point -> Z) (t : Box) : Z := Z.max (c (high t)) (- c (low t)).
Definition reach t : Z := reach_along x t + reach_along y t + reach_along z t.

(* ---- The tests of a pair. Under a translation, plain boxes (box_test.smt2). *)
Definition moved_boxes_reject o s t : Prop :=
  (x (high t) + x o < x (low s) \/ y (high t) + y o < y (low s) \/ z (high t) + z o < z (low s)) \/
  (x (high s) < x (low t) + x o \/ y (high s) < y (low t) + y o \/ z (high s) < z (low t) + z o).
Definition on_a r root s t : Prop :=
  with_all rejects_on_a r (reach root) (most_rest r) s t.
Definition on_b r root s t : Prop :=
  with_all rejects_on_b r (reach root) (defect r) s t.

Definition box_beyond t e lower upper offset margin : bool := decide (slab_rejects e lower upper offset margin t).
Definition corners_beyond those e lower upper offset margin : bool := corners_reject e lower upper offset margin those.

Section Two.
Variables A B : Image.
Variable pose : Pose.
Let root_b := box B 0.

(* Two boxes; the window of a leaf of one side, and its slabs; `beyond_`: whether a part of the other tree lies beyond
   one.
   code: include/flashbvh/detail/walk/leaf_planes.hpp | window = side == Side::a ? rotated_->window_of_a(box) : rotated_->window_of_b(box);
   code: include/flashbvh/detail/walk/leaf_planes.hpp | return halves_reach({{box.upper_xy, box.lower_xy, box.z}}, window) && may_touch_both(plane, edge, box);
   code: include/flashbvh/detail/walk/leaf_planes.hpp | return reached == nullptr || edge.may_touch *)
Definition boxes_overlap s t : bool :=
  match pose with
  | Moved o => negb (decide (moved_boxes_reject o s t))
  | Turned r => negb (decide (on_a r root_b s t)) && negb (decide (on_b r root_b s t))
  end.
Definition window_passes (side : Side) s t : bool :=
  match pose, side with
  | Moved o, _ => negb (decide (moved_boxes_reject o s t))
  | Turned r, LeafB => negb (decide (on_a r root_b s t))
  | Turned r, _ => negb (decide (on_b r root_b s t))
  end.
Definition slab_of_a s (beyond_ : Point -> Z -> Z -> Z -> Z -> bool) : bool :=
  negb match pose with
  | Moved o => beyond_ (direction s) (from s) (to s) (- dot (direction s) o) 0
  | Turned r => beyond_ (with_entries seen_from_b r (direction s)) (from s) (to s)
      (- dot (direction s) (origin (o1 r) (o2 r) (o3 r))) (slab_margin (reach root_b) (defect r))
  end.
Definition slab_of_b s (beyond_ : Point -> Z -> Z -> Z -> Z -> bool) : bool :=
  negb match pose with
  | Moved o => beyond_ (direction s) (from s) (to s) (dot (direction s) o) 0
  | Turned r => let seen := with_entries seen_from_a r (direction s) in
      beyond_ seen (from s) (to s) (dot seen (origin (o1 r) (o2 r) (o3 r))) (slab_margin (reach root_b) (defect r))
  end.

(* The parts that Code.v leaves open. *)
Let leaf_a n := is_leaf (cells A) n.
Let leaf_b n := is_leaf (cells B) n.
Definition bound n k : bool := boxes_overlap (box A n) (box B k).
Definition slabs_pass_a those beyond_ : bool := forallb (fun s => slab_of_a s beyond_) those.
Definition slabs_pass_b those beyond_ : bool := forallb (fun s => slab_of_b s beyond_) those.
Definition box_passes_a n k : bool := slabs_pass_a (slabs A n) (box_beyond (box B k)).
Definition box_passes_b n k : bool := slabs_pass_b (slabs B k) (box_beyond (box A n)).
Definition begin n k : bool := if leaf_a n then box_passes_a n k else if leaf_b k then box_passes_b n k else true.

(* Below a leaf, a leaf whose box passes is tested against the first slab, the plane's, by its corners; then the leaf
   above against the first baked slab of the one below.
   code: include/flashbvh/detail/walk/leaf_planes.hpp | return rejects_corners(node, progress) || is_rejected_by(node, progress);
   code: include/flashbvh/detail/walk/leaf_planes.hpp | return slab.may_touch(m.vertices, m.triangles[m.first_triangle(leaf)].corner, m.triangles[m.end_triangle(leaf)].corner);
   code: include/flashbvh/detail/walk/leaf_planes.hpp | if (may_touch_corners(plane, other_mesh(), leaf)) { return false; }
   code: include/flashbvh/detail/walk/leaf_planes.hpp | slab.begin(BakedSlab::of(slabs[other_mesh().nodes[node].leaf()], 0)); see_other(slab); if (may_touch_corners(slab, mesh(), node_->leaf())) { return false; }
   code: include/flashbvh/detail/walk/leaf_planes.hpp | see(slab, side_ == Side::a ? Side::b : Side::a);
   code: include/flashbvh/detail/walk/leaf_planes.hpp | const Mesh& other_mesh() const { return side_ == Side::a ? b : a; }
   code: include/flashbvh/detail/walk/leaf_planes.hpp | static constexpr bool kComparesLeaves = true;
   code: include/flashbvh/detail/walk/walk_below.hpp | if (!at.node().is_leaf()) { at.descend(); continue; } progress.go_on(work_left, overlaps); const bool go_on = found(at.node_index());
   code: include/flashbvh/detail/walk/walk_below.hpp | if constexpr (Shapes::kComparesLeaves) { if (shapes.rejects_leaf(other, run.progress)) { return true; } } *)
Definition corners_pass_a (those : Image -> nat -> list Slab) n k : bool :=
  slabs_pass_a (firstn 1 (those A n)) (corners_beyond (leaf_points B k)).
Definition corners_pass_b (those : Image -> nat -> list Slab) n k : bool :=
  slabs_pass_b (firstn 1 (those B k)) (corners_beyond (leaf_points A n)).
Definition leaves_pass (side : Side) n k : bool := if leaf_a n && leaf_b k then
  match side with
  | LeafB => corners_pass_b slabs n k && corners_pass_a baked_slabs n k
  | _ => corners_pass_a slabs n k && corners_pass_b baked_slabs n k
  end else true.
Definition touch (side : Side) n k : bool :=
  match side with
  | LeafB =>
      if leaf_b k then window_passes LeafB (box A n) (box B k) && box_passes_b n k && leaves_pass side n k else true
  | _ =>
      if leaf_a n then window_passes LeafA (box A n) (box B k) && box_passes_a n k && leaves_pass side n k else true
  end.

(* Each of A's triangles with each of B's, from the last ones on.
   code: include/flashbvh/detail/query/leaf_tests.hpp | return a_->first_triangle(leaf_a_) + i % a_->triangles_in(leaf_a_);
   code: include/flashbvh/detail/query/leaf_tests.hpp | return b_->first_triangle(leaf_b_) + i / a_->triangles_in(leaf_a_); *)
Definition pairs_of (p : nat * nat) : list (nat * nat) :=
  flat_map (fun j => map (fun i => (i, j)) (rev (triangles A (fst p)))) (rev (triangles B (snd p))).

(* A triangle of A and one of B, placed in A's lattice, have a common point; and the code's answer, with or without
   B's current normal.
   code: include/flashbvh/detail/query/triangle_test.hpp | return narrow_ ? near_triangles_intersect(a, kept_b_, normal_) : wide_triangles_intersect(a, kept_b_); *)
Definition of_pair {T} (f : Point -> Point -> Point -> Point -> Point -> Point -> T) (i j : nat) : T :=
  let '(p, q, r) := corners A i in let '(s, t, o) := corners B j in f p q r (put pose s) (put pose t) (put pose o).
Definition common_point : nat -> nat -> Prop := of_pair meet.
Definition intersects (narrow : bool) (p : nat * nat) : bool :=
  of_pair (if narrow then near_triangles_intersect else triangles_intersect) (fst p) (snd p).
End Two.

(* ============================================================== Part 2: the theorems *)

Definition has m i := exists n, is_leaf (cells m) n = true /\ In i (triangles m n).

(* Runs of a query from one cursor to another, with their answers. *)
Definition runs A B pose narrow := Rounds (cells A) (cells B) (bound A B pose) (begin A B pose) (touch A B pose)
  (nat * nat) (pairs_of A B) (intersects A B pose narrow).

(* For two images that open accepts, any pose of B and any division of a query into runs: its answers are the pairs of
   triangles with a common point, each once. *)
Definition Answers_are_the_pairs_with_a_common_point := forall A B pose narrow,
  opens A = true -> opens B = true -> sound A -> sound B -> fits pose ->
  forall answers, runs A B pose narrow Fresh answers Finished ->
  (forall i j, In (i, j) answers <-> has A i /\ has B j /\ common_point A B pose i j) /\ NoDup answers.

(* The decisions of a query before its walk change nothing: roots far apart are rejected in any case; and a triangle
   of B outside the box of A's leaf meets none of its triangles.
   code: src/bounds/rotated_transform.cpp | return (most >> kSplitBits) + lower < 2 * kBoundBias || (least >> kSplitBits) + upper < 2 * kBoundBias;
   code: src/bounds/rotated_transform.cpp | on_a[axis] = start_of(row, offset_along(axis), kWidestMargin); if (may_stop && far_apart(row, on_a[axis], root_b, root_a, axis)) { return false; }
   code: src/bounds/rotated_transform.cpp | if (may_stop && far_apart(column, on_b[axis], root_a, root_b, axis)) { return false; }
   code: src/predicates/triangle.cpp | return (((above - u) & (above - v) & (above - w)) | ((negated_below + u) & (negated_below + v) & (negated_below + w))) < 0; *)
Definition far_along e offset margin t lower upper : Prop :=
  bound_sum (start_of e offset margin) e t / cell14 + (bias - lower) < 2 * bias \/
  bound_sum (start_of e (- offset) margin) (negated e) t / cell14 + (upper + bias) < 2 * bias.
Definition far_apart r s t : Prop :=
  let on_a kx ky kz o := far_along (column kx ky kz) o @kWidestMargin@ t in
  let on_b k1 k2 k3 := far_along (column k1 k2 k3) (clamped (- back (o1 r) (o2 r) (o3 r) k1 k2 k3))
    (axis_margin (reach t) (defect r)) s in
  (on_a (a1 r) (b1 r) (c1 r) (o1 r) (x (low s)) (x (high s)) \/
   on_a (a2 r) (b2 r) (c2 r) (o2 r) (y (low s)) (y (high s)) \/
   on_a (a3 r) (b3 r) (c3 r) (o3 r) (z (low s)) (z (high s))) \/
  (on_b (a1 r) (a2 r) (a3 r) (x (low t)) (x (high t)) \/ on_b (b1 r) (b2 r) (b3 r) (y (low t)) (y (high t)) \/
   on_b (c1 r) (c2 r) (c3 r) (z (low t)) (z (high t))).
Definition beside t (p q r : Point) : Prop :=
  let along c := (c (high t) < c p /\ c (high t) < c q /\ c (high t) < c r) \/
    (c p < c (low t) /\ c q < c (low t) /\ c r < c (low t)) in along x \/ along y \/ along z.

Definition Early_ends_are_right := forall A B r j, opens A = true -> opens B = true -> has B j ->
  far_apart r (box A 0) (box B 0) -> bound A B (Turned r) 0 0 = false.
Definition Left_out_rightly := forall A B pose n i j, opens A = true -> In i (triangles A n) ->
  (let '(p, q, r) := corners B j in beside (box A n) (put pose p) (put pose q) (put pose r)) ->
  ~ common_point A B pose i j.

(* ============================================================== Part 3: the proofs *)

Lemma opened_cells m : opens m = true -> accepts (cells m) (fun n k => is_inside (box m n) (box m k)) = true.
Proof. unfold opens. now rewrite andb_true_iff. Qed.
Definition is_tree m (opened : opens m = true) := accepted_is_tree _ _ (opened_cells m opened).

Ltac bools := repeat rewrite ?andb_true_iff, ?Z.leb_le, ?Nat.ltb_lt in *.
Lemma decided P {d : Dec P} : negb (decide P) = true <-> ~ P.
Proof. unfold decide. destruct d; cbn; split; auto; discriminate || tauto. Qed.

Lemma inside_box s t p : is_inside s t = true -> in_box s p -> in_box t p.
Proof. unfold is_inside, in_box. bools. lia. Qed.
Lemma inside_point p t : is_inside {| low := p; high := p |} t = true -> in_box t p.
Proof. unfold is_inside, in_box. cbn [low high]. bools. lia. Qed.

Lemma extreme_bounds e those p : In p those -> least e those <= dot e p <= most e those.
Proof.
  destruct those as [|f r]; [easy|]. unfold least, most, extreme.
  assert (fold_right (fun q => Z.min (dot e q)) (dot e f) r <= dot e f <= fold_right (fun q => Z.max (dot e q)) (dot e f) r
    /\ (In p r -> fold_right (fun q => Z.min (dot e q)) (dot e f) r <= dot e p <= fold_right (fun q => Z.max (dot e q)) (dot e f) r)) as [F G].
  { induction r as [|g r [IF IG]]; cbn [fold_right]; [split; [lia | easy]|]. split; [lia|].
    intros [-> | I]; [lia|]. specialize (IG I). lia. }
  intros [<- | I]; auto.
Qed.

(* slab.g's premise about baked slabs. *)
Theorem baked_slabs_fit b : has_widths b -> is_in_range b = true -> let s := begun b in
  let most := @tree_check.cpp:most * 2**kSlabUnitBits@ in
  within (127 * @baked_slab.hpp:scale@) (direction s) /\ - most <= from s /\ to s <= most.
Proof.
  destruct b as [[p q r] t u]. unfold has_widths, is_in_range, within, begun.
  cbn [towards thickness units direction from to x y z]. cbv zeta. intros (P & Q & R & T & U). rewrite !andb_true_iff, !negb_true_iff, !Z.eqb_neq, Z.leb_le.
  pose proof (Z.div_pos t 32 (proj1 T) eq_refl). rewrite Z.pow_add_r, (Z.mul_comm (2 ^ _)), Z.mul_assoc by lia. lia.
Qed.

Section OfImage.
Variable m : Image.
Hypothesis opened : opens m = true.
Let F := proj1 (is_tree m opened).

Lemma checked n : (n < length (cells m))%nat -> is_inside (box m n) lattice = true /\
  (forall p, In p (leaf_points m n) -> is_inside {| low := p; high := p |} (box m n) = true) /\
  (forall b, In b (baked m n) -> is_in_range b && holds (begun b) (leaf_points m n) = true).
Proof.
  intros L. pose proof opened as H. unfold opens in H. rewrite andb_true_iff, forallb_forall in H. destruct H as [_ H].
  specialize (H n ltac:(apply in_seq; lia)). now rewrite !andb_true_iff, !forallb_forall, and_assoc in H.
Qed.
Lemma node_in n p : (n < length (cells m))%nat -> is_inside (box m n) lattice = true /\
  (In p (leaf_points m n) -> in_box (box m n) p).
Proof. intros L. destruct (checked n L) as (H & G & _). split; auto. intros I. now apply inside_point, G. Qed.

Lemma slab_fits n s : sound m -> (n < length (cells m))%nat -> In s (slabs m n) ->
  within most_part (direction s) /\ forall p, In p (leaf_points m n) -> Rejects.between (direction s) (from s) (to s) p.
Proof.
  intros [S _] L. destruct (checked n L) as (_ & _ & G), (S n) as [D W]. unfold slabs.
  destruct (baked_slabs m n) eqn:E; [|rewrite <- E]; intros I; apply in_map_iff in I as (e & <- & I).
  - split; [now apply D | intros p; apply extreme_bounds].
  - specialize (G e I). apply andb_true_iff in G as [G H]. destruct (baked_slabs_fit e (W e I) G) as [N _]. split.
    + unfold within, most_part in *. lia.
    + intros p P. unfold holds in H. rewrite forallb_forall in H. specialize (H p P). bools. exact H.
Qed.

Lemma has_in_range n i : In i (triangles m n) -> (n < length (cells m))%nat.
Proof. unfold triangles. now destruct (Nat.ltb_spec n (length (cells m))). Qed.

Lemma below n k : Under (T := array_tree _ _ F) n k -> (k < length (cells m))%nat ->
  (n < length (cells m))%nat /\ forall p, in_box (box m k) p -> in_box (box m n) p.
Proof.
  intros U L. induction U as [n | n k l I U IH]; auto. destruct (IH L) as [K H]. cbn in I.
  split; [now apply (fmt_inside _ _ F n k)|]. intros p P.
  apply (inside_box (box m k)); auto. now apply (proj2 (is_tree m opened) n k).
Qed.

Lemma corners_in n k i p : Under (T := array_tree _ _ F) n k -> In i (triangles m k) ->
  In p (points (corners m i)) -> in_box (box m n) p /\ (n < length (cells m))%nat /\ In p (leaf_points m k).
Proof.
  intros U I P. pose proof (has_in_range _ _ I) as L. destruct (below n k U L) as [N H].
  assert (In p (leaf_points m k)) as G by (unfold leaf_points; apply in_flat_map; eauto).
  split; auto. now apply H, node_in.
Qed.

Lemma leaf_below n k : Under (T := array_tree _ _ F) n k -> is_leaf (cells m) n = true -> n = k.
Proof.
  intros U L. apply (leaf_spec _ _ F) in L. destruct U as [|n k l I U]; auto. cbn in I. now rewrite L in I.
Qed.
End OfImage.

Section Pair.
Variables A B : Image.
Hypothesis opened_a : opens A = true.
Hypothesis opened_b : opens B = true.
Let FA := proj1 (is_tree A opened_a).
Let FB := proj1 (is_tree B opened_b).
Variable pose : Pose.
Hypothesis pose_fits : fits pose.
Hypothesis sound_a : sound A.
Hypothesis sound_b : sound B.

(* Some points of A, and some of B in its pose. *)
Definition apart (these those : Point -> Prop) := Apart these (fun v => exists u, those u /\ v = put pose u).

Lemma apart_no_common these those i j : apart these those ->
  (forall p, In p (points (corners A i)) -> these p) -> (forall p, In p (points (corners B j)) -> those p) ->
  ~ common_point A B pose i j.
Proof.
  unfold common_point, of_pair. intros S T U. destruct (corners A i) as [[p q] r], (corners B j) as [[s t] o]. cbn in T, U.
  apply (apart_not_meet _ _ _ _ _ _ _ _ S); eauto 9.
Qed.

Lemma rests_small r : let small k := Z.abs (rest k) <= most_rest r in
  (small (a1 r) /\ small (b1 r) /\ small (c1 r)) /\ (small (a2 r) /\ small (b2 r) /\ small (c2 r)) /\
  small (a3 r) /\ small (b3 r) /\ small (c3 r).
Proof.
  unfold most_rest. cbv zeta. generalize (Z.abs (rest (a1 r))) (Z.abs (rest (b1 r))) (Z.abs (rest (c1 r)))
    (Z.abs (rest (a2 r))) (Z.abs (rest (b2 r))) (Z.abs (rest (c2 r))) (Z.abs (rest (a3 r))) (Z.abs (rest (b3 r)))
    (Z.abs (rest (c3 r))). clear. intros. repeat split; rewrite !Z.max_le_iff; auto 8 using Z.le_refl.
Qed.

(* Boxes of two nodes that contain some points. *)
Definition filled m n := (n < length (cells m))%nat /\ exists p, in_box (box m n) p.

Lemma filled_of m O n k i : Under (T := array_tree _ _ (proj1 (is_tree m O))) n k -> In i (triangles m k) -> filled m n.
Proof.
  intros U I. destruct (corners m i) as [[p q] r] eqn:E.
  destruct (corners_in m O n k i p U I) as (P & L & _); [rewrite E; now left|]. split; eauto.
Qed.

Lemma filled_box m n : opens m = true -> filled m n -> let t := box m n in
  (x (low t) <= x (high t) /\ y (low t) <= y (high t) /\ z (low t) <= z (high t)) /\
  (- kMaxCoordinate <= x (low t) /\ x (high t) <= kMaxCoordinate /\ - kMaxCoordinate <= y (low t) /\
   y (high t) <= kMaxCoordinate /\ - kMaxCoordinate <= z (low t) /\ z (high t) <= kMaxCoordinate).
Proof.
  intros O [L (p & P)]. destruct (node_in m O n p L) as [H _]. unfold is_inside, lattice in H. cbn [low high x y z] in H.
  unfold in_box in P. bools. cbv zeta. lia.
Qed.

Let mx := reach_along x (box B 0).
Let my := reach_along y (box B 0).
Let mz := reach_along z (box B 0).

Lemma in_reach k u : (k < length (cells B))%nat -> in_box (box B k) u -> reached mx my mz u.
Proof.
  intros L U. assert (in_box (box B 0) u) as R.
  { apply (below B opened_b 0%nat k); auto. now apply all_under. }
  unfold reached, mx, my, mz, reach_along, in_box in *. lia.
Qed.

Let boxes_reject n k := match pose with
  | Moved o => moved_boxes_reject o (box A n) (box B k)
  | Turned r => on_a r (box B 0) (box A n) (box B k) \/ on_b r (box B 0) (box A n) (box B k)
  end.
Lemma boxes_apart n k : filled A n -> filled B k -> boxes_reject n k ->
  apart (in_box (box A n)) (in_box (box B k)).
Proof.
  intros FN FK H. destruct (filled_box A n opened_a FN) as [OA LA], (filled_box B k opened_b FK) as [OB LB].
  unfold apart, fits, boxes_reject in *. destruct pose as [o | r].
  - unfold Apart, moved_boxes_reject, in_box, put in *. clear - H. destruct H as [[H | [H | H]] | [H | [H | H]]];
      on_some_axis ltac:(intros w v W (u & U & ->); cbn [x y z]; lia).
  - destruct pose_fits as (D & aa & bb & cc & ab & ac & bc).
    assert (reach (box B 0) <= 3 * kMaxCoordinate) as Most.
    { destruct FK as [K (p & P)]. destruct (below B opened_b 0%nat k) as [Z0 In0]; auto; [now apply all_under|].
      destruct (filled_box B 0 opened_b) as [O L]; [split; eauto|]. unfold reach, reach_along. cbv zeta in L. lia. }
    apply (boxes_reject_safely _ _ _ _ _ _ _ _ _ _ _ _ mx my mz (reach (box B 0)) (most_rest r) (defect r)
      eq_refl Most D aa bb cc ab ac bc); auto.
    + exact (rests_small r).
    + intros u U. now apply (in_reach k); auto; apply FK.
Qed.

(* A test that correctly decides whether a box, or corners, lie beyond a slab. *)
Definition right_of (beyond_ : Point -> Z -> Z -> Z -> Z -> bool) (other : Point -> Prop) :=
  forall e lower upper offset margin, beyond_ e lower upper offset margin = true ->
  beyond e lower upper offset margin other.
Lemma box_beyond_right t : right_of (box_beyond t) (in_box t).
Proof.
  intros e l u o g. unfold box_beyond, decide. destruct (dec_or _ _ _ _); [intros _; now apply slab_separates | easy].
Qed.
Lemma corners_beyond_right those : right_of (corners_beyond those) (fun p => In p those).
Proof. intros e l u o g. apply corners_separate. Qed.

Let between s := Rejects.between (direction s) (from s) (to s).
Lemma slab_a_apart k s beyond_ (other : Point -> Prop) : (k < length (cells B))%nat ->
  (forall u, other u -> in_box (box B k) u) -> right_of beyond_ other -> within most_part (direction s) ->
  slab_of_a B pose s beyond_ = false -> apart (between s) other.
Proof.
  intros K O R P H. unfold slab_of_a, fits, apart in *. apply negb_false_iff in H. destruct pose as [o | r]; apply R in H.
  - exact (proj1 (translated_slabs_reject_safely _ _ _ o _) H).
  - destruct pose_fits as (D & _).
    apply (slab_of_a_rejects_safely _ _ _ _ _ _ _ _ _ _ _ _ mx my mz (reach (box B 0)) (defect r)); auto.
    intros u U. apply (in_reach k); auto.
Qed.

Lemma slab_b_apart s beyond_ (other : Point -> Prop) : right_of beyond_ other -> within most_part (direction s) ->
  slab_of_b B pose s beyond_ = false -> apart other (fun u => reached mx my mz u /\ between s u).
Proof.
  intros R P H. unfold slab_of_b, fits, apart in *. apply negb_false_iff in H. destruct pose as [o | r]; apply R in H.
  - destruct (proj2 (translated_slabs_reject_safely _ _ _ o _) H) as (d & G). exists d.
    destruct G as [G | G]; [left | right]; intros w v W (u & (_ & U) & V); apply G; auto; now exists u.
  - destruct pose_fits as (D & aa & bb & cc & ab & ac & bc).
    exact (slab_of_b_rejects_safely _ _ _ _ _ _ _ _ _ _ _ _ mx my mz (reach (box B 0)) (defect r)
      eq_refl D aa bb cc ab ac bc _ P _ _ _ H).
Qed.

(* ---- The premises of Query.v on each test. *)
Let exact_meets (exact : nat * nat -> bool) := forall i j, exact (i, j) = true <-> common_point A B pose i j.
Let safely exact := rejects_safely (cells A) (cells B) _ _ FA FB (nat * nat) (pairs_of A B) exact.

Lemma in_pairs n k i j : In (i, j) (pairs_of A B (n, k)) <-> In i (triangles A n) /\ In j (triangles B k).
Proof.
  unfold pairs_of. cbn [fst snd]. rewrite in_flat_map. setoid_rewrite in_map_iff. setoid_rewrite <- in_rev. split.
  - intros (j' & J & i' & [= -> ->] & I). auto.
  - intros [I J]. exists j. split; auto. now exists i.
Qed.

Section Common.
Variable exact : nat * nat -> bool.
Hypothesis right : exact_meets exact.
Variables n k l m i j : nat.
Hypothesis below_n : Under (T := array_tree _ _ FA) n l.
Hypothesis below_k : Under (T := array_tree _ _ FB) k m.
Hypothesis I : In i (triangles A l).
Hypothesis J : In j (triangles B m).
Hypothesis yes : exact (i, j) = true.

Lemma never (these those : Point -> Prop) : (forall p, In p (points (corners A i)) -> these p) ->
  (forall p, In p (points (corners B j)) -> those p) -> ~ apart these those.
Proof. intros T U S. apply right in yes. revert yes. now apply (apart_no_common these those). Qed.

Lemma filled_a : filled A n. Proof. now apply (filled_of A opened_a n l i). Qed.
Lemma filled_b : filled B k. Proof. now apply (filled_of B opened_b k m j). Qed.
Lemma in_a p : In p (points (corners A i)) -> in_box (box A n) p.
Proof. intros P. now apply (corners_in A opened_a n l i p). Qed.
Lemma in_b p : In p (points (corners B j)) -> in_box (box B k) p.
Proof. intros P. now apply (corners_in B opened_b k m j p). Qed.

Lemma boxes_stay : ~ boxes_reject n k.
Proof. intros R. apply (never _ _ in_a in_b). apply boxes_apart; auto using filled_a, filled_b. Qed.

Lemma boxes_say : boxes_overlap B pose (box A n) (box B k) = true.
Proof.
  pose proof boxes_stay as S. unfold boxes_reject, boxes_overlap in *. destruct pose; rewrite ?andb_true_iff, !decided; tauto.
Qed.
Lemma windows_say side : window_passes B pose side (box A n) (box B k) = true.
Proof.
  pose proof boxes_stay as S. unfold boxes_reject, window_passes in *. destruct pose, side; rewrite decided; tauto.
Qed.
Lemma slabs_of_a_say those beyond_ (other : Point -> Prop) : is_leaf (cells A) n = true -> incl those (slabs A n) ->
  (forall u, other u -> in_box (box B k) u) -> (forall p, In p (points (corners B j)) -> other p) ->
  right_of beyond_ other -> slabs_pass_a B pose those beyond_ = true.
Proof.
  intros L Those O C R. pose proof (leaf_below A opened_a n l below_n L) as E. apply forallb_forall. intros s D.
  destruct (slab_fits A opened_a n s sound_a (proj1 filled_a) (Those s D)) as [P G].
  destruct (slab_of_a B pose s _) eqn:S; auto. exfalso. apply (slab_a_apart k s _ other) in S; auto; [|apply filled_b].
  revert S. apply never; [|exact C]. intros p T. apply G. rewrite E. now apply (corners_in A opened_a n l i p).
Qed.
Lemma slabs_of_b_say those beyond_ (other : Point -> Prop) : is_leaf (cells B) k = true -> incl those (slabs B k) ->
  (forall p, In p (points (corners A i)) -> other p) ->
  right_of beyond_ other -> slabs_pass_b B pose those beyond_ = true.
Proof.
  intros L Those C R. pose proof (leaf_below B opened_b k m below_k L) as E. apply forallb_forall. intros s D.
  destruct (slab_fits B opened_b k s sound_b (proj1 filled_b) (Those s D)) as [P G].
  destruct (slab_of_b B pose s _) eqn:S; auto. exfalso. apply (slab_b_apart s _ other) in S; auto.
  revert S. apply never; [exact C|]. intros p T. split; [apply (in_reach k); [apply filled_b | now apply in_b]|].
  apply G. rewrite E. now apply (corners_in B opened_b k m j p).
Qed.
Lemma boxes_against_a_say : is_leaf (cells A) n = true -> box_passes_a A B pose n k = true.
Proof. intros L. apply (slabs_of_a_say _ _ (in_box (box B k))); auto using box_beyond_right, in_b, incl_refl. Qed.
Lemma boxes_against_b_say : is_leaf (cells B) k = true -> box_passes_b A B pose n k = true.
Proof. intros L. apply (slabs_of_b_say _ _ (in_box (box A n))); auto using box_beyond_right, in_a, incl_refl. Qed.
Lemma first_of {T} (those : list T) : incl (firstn 1 those) those.
Proof. destruct those; intros e; cbn; tauto. Qed.
Lemma first_baked mesh leaf : incl (firstn 1 (baked_slabs mesh leaf)) (slabs mesh leaf).
Proof. unfold slabs. destruct (baked_slabs mesh leaf); [easy | apply first_of]. Qed.
Lemma leaves_say side : leaves_pass A B pose side n k = true.
Proof.
  unfold leaves_pass. destruct (is_leaf (cells A) n) eqn:L, (is_leaf (cells B) k) eqn:K; auto. cbn [andb].
  assert (forall those, incl (firstn 1 (those A n)) (slabs A n) -> corners_pass_a A B pose those n k = true) as OfA.
  { intros those In_. pose proof (leaf_below B opened_b k m below_k K) as E. destruct filled_b as [F _].
    apply (slabs_of_a_say _ _ (fun p => In p (leaf_points B k))); auto using corners_beyond_right.
    - intros u U. now apply node_in.
    - intros p P. rewrite E. now apply (corners_in B opened_b k m j p). }
  assert (forall those, incl (firstn 1 (those B k)) (slabs B k) -> corners_pass_b A B pose those n k = true) as OfB.
  { intros those In_. pose proof (leaf_below A opened_a n l below_n L) as E.
    apply (slabs_of_b_say _ _ (fun p => In p (leaf_points A n))); auto using corners_beyond_right.
    intros p P. rewrite E. now apply (corners_in A opened_a n l i p). }
  destruct side; rewrite OfA, OfB; auto using first_of, first_baked.
Qed.
End Common.

Lemma all_reject_safely exact : exact_meets exact ->
  safely exact (bound A B pose) /\ safely exact (begin A B pose) /\ forall side, safely exact (touch A B pose side).
Proof.
  intros R. repeat split; [| | intros side]; intros n k l m [i j] UN UK _ _ P Y; apply in_pairs in P as [I J].
  - apply (boxes_say exact R n k l m i j); auto.
  - unfold begin. destruct (is_leaf (cells A) n) eqn:L; [now apply (boxes_against_a_say exact R n k l m i j)|].
    destruct (is_leaf (cells B) k) eqn:K; auto. now apply (boxes_against_b_say exact R n k l m i j).
  - pose proof (windows_say exact R n k l m i j UN UK I J Y) as W.
    pose proof (boxes_against_a_say exact R n k l m i j UN UK I J Y) as S.
    pose proof (boxes_against_b_say exact R n k l m i j UN UK I J Y) as T.
    pose proof (leaves_say exact R n k l m i j UN UK I J Y) as C.
    unfold touch. destruct side; [destruct (is_leaf (cells A) n) | destruct (is_leaf (cells A) n) |
      destruct (is_leaf (cells B) k)]; auto; rewrite W, ?S, ?T, C; auto.
Qed.
End Pair.

Lemma NoDup_product (is js : list nat) : NoDup is -> NoDup js ->
  NoDup (flat_map (fun j => map (fun i => (i, j)) (rev is)) (rev js)).
Proof.
  intros I J. apply NoDup_flat_map; [now apply NoDup_rev | |].
  - intros j. apply Injective_map_NoDup; [now intros ? ? [= ->] | now apply NoDup_rev].
  - intros j k p P Q. apply in_map_iff in P as (i & <- & _), Q as (l & [= _ ->] & _). reflexivity.
Qed.

Theorem answers_are_the_pairs_with_a_common_point : Answers_are_the_pairs_with_a_common_point.
Proof.
  intros A B pose narrow opened_a opened_b SA SB F e Q. set (exact := intersects A B pose narrow).
  assert (forall i j, exact (i, j) = true <-> common_point A B pose i j) as R.
  { intros i j. unfold exact, intersects, common_point, of_pair. cbn [fst snd].
    destruct (corners A i) as [[p q] r], (corners B j) as [[s t] o]. destruct narrow; apply test_is_exact. }
  destruct (all_reject_safely A B opened_a opened_b pose F SA SB exact R) as (RB & RG & RT).
  destruct (answers_are_exact _ _ _ _ (proj1 (is_tree A opened_a)) (proj1 (is_tree B opened_b)) _ _ _ _ _ exact RB RG RT e Q) as [Exact Once]. split.
  - intros i j. rewrite Exact. pose proof (is_tree A opened_a) as [TA _]. pose proof (is_tree B opened_b) as [TB _].
    split.
    + intros (n & k & L & K & LN & LK & P & Y). apply in_pairs in P as [I J].
      repeat split; [exists n | exists k | now apply R]; split; auto; [now apply (leaf_spec _ _ TA) | now apply (leaf_spec _ _ TB)].
    + intros ((n & L & I) & (k & K & J) & Y). exists n, k.
      repeat split; eauto using has_in_range; [now apply (leaf_spec _ _ TA) | now apply (leaf_spec _ _ TB) | now apply in_pairs | now apply R].
  - apply Once.
    + intros [n k]. apply NoDup_product; [apply SA | apply SB].
    + intros [n k] [l m] [i j] P P'. apply in_pairs in P as [I J], P' as [I' J'].
      f_equal; [now apply (proj2 (proj2 SA) _ _ i) | now apply (proj2 (proj2 SB) _ _ j)].
Qed.

Theorem left_out_rightly : Left_out_rightly.
Proof.
  intros A B pose n i j O I H. unfold common_point, of_pair.
  assert (forall p, In p (points (corners A i)) -> in_box (box A n) p) as In_a.
  { intros p P. apply node_in; [exact O | now apply (has_in_range A n i)|]. apply in_flat_map. eauto. }
  destruct (corners A i) as [[p q] r], (corners B j) as [[s t] o]. cbn in In_a.
  apply (apart_not_meet (in_box (box A n)) (fun v => v = put pose s \/ v = put pose t \/ v = put pose o)); auto 8.
  unfold beside, in_box in *. generalize dependent (put pose s). generalize (put pose t) (put pose o).
  clear. intros t o s H. unfold Apart.
  destruct H as [[H | H] | [[H | H] | [H | H]]]; on_some_axis ltac:(intros w v W [-> | [-> | ->]]; lia).
Qed.

Lemma far_is_rejected e offset margin wide t lower upper : - kMaxCoordinate <= lower -> upper <= kMaxCoordinate ->
  margin <= wide -> far_along e offset wide t lower upper -> axis_rejects e offset margin t lower upper.
Proof.
  assert (forall g o f b, margin <= wide -> 0 < b -> bound_sum (start_of g o wide) f t / cell14 < b ->
    whole (bound_sum (start_of g o margin) f t) < b) as G.
  { intros g o f b M P H. unfold whole. assert (bound_sum (start_of g o margin) f t <= bound_sum (start_of g o wide) f t)
      as L by (unfold bound_sum, start_of; lia). apply (Z.div_le_mono _ _ cell14 eq_refl) in L. lia. }
  intros L U M [H | H]; [left | right].
  - enough (whole (bound_sum (start_of e offset margin) e t) < bias + lower) by lia.
    apply G; [exact M | unfold bias, kMaxCoordinate in *; lia | lia].
  - enough (whole (bound_sum (start_of e (- offset) margin) (negated e) t) < bias - upper) by lia.
    apply G; [exact M | unfold bias, kMaxCoordinate in *; lia | lia].
Qed.

Theorem early_ends_are_right : Early_ends_are_right.
Proof.
  intros A B r j OA OB (k & _ & J) H.
  assert (filled B 0) as F
    by (apply (filled_of B OB 0%nat k j); [apply all_under; now apply has_in_range in J | exact J]).
  destruct (filled_box B 0 OB F) as [O L']. cbv zeta in L'.
  assert (box_margin (most_rest r) (reach (box B 0)) + kHalf <= @kWidestMargin@) as M.
  { apply widest_margin.
    - pose proof (rests_small r) as S. cbv zeta in S. unfold most_rest.
      assert (forall e, Z.abs (rest e) <= 128) as R by (intros e; pose proof (rest_fits e); lia).
      split; [apply (Z.le_trans _ (Z.abs (rest (a1 r)))); [apply Z.abs_nonneg | apply S]|].
      repeat apply Z.max_lub; apply R.
    - unfold reach, reach_along. lia. }
  destruct (node_in A OA 0%nat (low (box A 0))) as [L _].
  { apply (fmt_some _ _ (proj1 (is_tree A OA))). }
  unfold is_inside, lattice in L. cbn [low high x y z] in L. bools.
  unfold bound, boxes_overlap. apply not_true_iff_false. rewrite andb_true_iff, !decided. intros [N1 N2].
  unfold far_apart, on_a, on_b, with_all, with_entries, rejects_on_a, rejects_on_b in *. cbv zeta in *.
  destruct H as [H | H]; [apply N1 | apply N2]; (destruct H as [H | [H | H]]; [left | right; left | right; right]);
    (eapply far_is_rejected; [| | | exact H]; lia).
Qed.

(* ---- The premises can be met, by tests that reject some pairs: two triangles, and a quarter turn. *)
Definition at_ p q r := {| x := p; y := q; z := r |}.
Definition two_with along slabs_ : Image := {|
  cells := [ {| c_link := 3; c_rank := 5; c_parent_rank := kRootParentRank |};
    {| c_link := 2; c_rank := -7; c_parent_rank := 0 |}; {| c_link := 1; c_rank := -7; c_parent_rank := 0 |} ];
  box n := match n with 1%nat => {| low := at_ 10 0 0; high := at_ 19 9 9 |} |
    2%nat => {| low := at_ 40 0 0; high := at_ 49 9 9 |} | _ => {| low := at_ 10 0 0; high := at_ 49 9 9 |} end;
  corners i := match i with O => (at_ 10 0 0, at_ 19 9 0, at_ 15 0 9) | _ => (at_ 40 0 0, at_ 49 9 0, at_ 45 0 9) end;
  own_triangles n := match n with 1%nat => [0%nat] | 2%nat => [1%nat] | _ => [] end;
  directions n := along; baked n := match n with 1%nat => slabs_ | _ => [] end |}.
Definition flat := two_with [at_ 0 0 @2**kDirectionBits@] [].
Definition two := two_with [at_ @2**kDirectionBits@ (- @2**kDirectionBits@) 0; at_ 0 0 @2**kDirectionBits@] [].
Definition two_baked := two_with [] [{| towards := at_ 127 (-127) 0; thickness := 4; units := 4 |}].
Definition quarter : Rotation := {| a1 := 0; a2 := one22; a3 := 0; b1 := - one22; b2 := 0; b3 := 0; c1 := 0; c2 := 0;
  c3 := one22; o1 := 20 * cell14; o2 := -2 * cell14; o3 := 0; defect := 0 |}.
Example premises_met : Forall (fun m => opens m = true /\ sound m) [two; two_baked] /\ fits (Turned quarter) /\
  bound two two (Turned quarter) 1 1 = true /\ bound two two (Turned quarter) 1 2 = false.
Proof.
  split; [|repeat split; vm_compute; easy]. repeat constructor.
  all: try (intros [|[|[|n]]]; repeat constructor; easy).
  all: try (intros [|[|[|n]]] [|[|[|k]]] i; unfold triangles; cbn; intuition congruence).
  all: destruct n as [|[|n]]; cbn in H; repeat destruct H as [<- | H]; easy.
Qed.

(* The corners' test rejects leaves that all boxes pass, of either side, under a translation and under a rotation, here
   by no angle. *)
Definition moved_by_ d := Moved (at_ d (- d) 0).
Definition rotated_by d := Turned {| a1 := one22; a2 := 0; a3 := 0; b1 := 0; b2 := one22; b3 := 0; c1 := 0; c2 := 0;
  c3 := one22; o1 := d * cell14; o2 := - d * cell14; o3 := 0; defect := 0 |}.
Example corners_reject_more : Forall (fun pose => fits pose /\ bound two two pose 1 1 = true /\
  box_passes_a two two pose 1 1 = true /\ touch two two pose LeafA 1 1 = false /\
  box_passes_b two two pose 1 1 = true /\ touch two two pose LeafB 1 1 = false) [moved_by_ 3; rotated_by 5].
Proof. apply Forall_forall. intros pose [<- | [<- | []]]; vm_compute; easy. Qed.
(* So does the other leaf's baked slab. *)
Example baked_slabs_reject_more : Forall (fun pose => fits pose /\
  touch flat flat pose LeafA 1 1 = true /\ touch flat two_baked pose LeafA 1 1 = false /\
  touch flat flat pose LeafB 1 1 = true /\ touch two_baked flat pose LeafB 1 1 = false) [moved_by_ 4; rotated_by 6].
Proof. apply Forall_forall. intros pose [<- | [<- | []]]; vm_compute; easy. Qed.

Print Assumptions baked_slabs_fit.
Print Assumptions early_ends_are_right.
Print Assumptions left_out_rightly.
Print Assumptions answers_are_the_pairs_with_a_common_point.
