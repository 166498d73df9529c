#!/bin/sh
# mutations.sh OUT   Changes a definition, a constant or a line at a time, in a copy; each change must be
#                    refused by one of the proofs that are named. OUT: what check.sh checked.
set -eu
cd "$(dirname "$0")/.."
out=$1 work=$1/mutations
refused=0 survived=0

# mutate WHAT FILE OLD NEW PROOF...: FILE below the root has OLD, which becomes NEW.
mutate() {
  what=$1 file=$2 old=$3 new=$4
  shift 4
  rm -rf "$work"
  mkdir -p "$work/out"
  cp -r lib "$work/lib"
  cp -r proofs "$work/proofs"
  cp "$out"/*.vo "$work/out"
  python3 - "$work/$file" "$old" "$new" <<'PY'
import pathlib, sys
path, old, new = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3]
text = path.read_text()
assert old in text, f"{path} has no: {old}"
path.write_text(text.replace(old, new, 1))
PY
  if "$work/proofs/check.sh" "$work/lib" "$work/out" "$@" >"$work/said" 2>&1; then
    echo "SURVIVED: $what"
    survived=$((survived + 1))
  else
    echo "refused: $what ($(grep -m 1 -oE '[A-Za-z_]+\.(v|g|smt2):|no longer has' "$work/said" | head -n 1 | tr -d :))"
    refused=$((refused + 1))
  fi
}
stackless=proofs/walk/Stackless.v paper=lib/include/flashbvh/paper
walk=proofs/walk arithmetic=proofs/arithmetic
mesh=lib/include/flashbvh/mesh.hpp detail=lib/include/flashbvh/detail

# All names, nothing changed: what is refused below is refused for the change.
rm -rf "$work"
mkdir -p "$work/out"
cp "$out"/*.vo "$work/out"
proofs/check.sh lib "$work/out" Ranked.v Code.v Query.v Image.v Exact.v >/dev/null

mutate "a margin's line that is quoted" lib/src/bounds/rotated_transform.cpp '>> kRestBits) + 1;' '>> kRestBits);' Margins.v
mutate "the box test's margin is two units less, of which one is spare" $arithmetic/Margins.v \
  'most * reach / rest8 + 1' 'most * reach / rest8 - 1' Margins.v
mutate "the margin on B's axes lacks an eighth of a cell" $arithmetic/Margins.v \
  '7 * (cell14 / 8) + 7 * reach / 8' '6 * (cell14 / 8) + 7 * reach / 8' Margins.v
mutate "a tie in the rule goes to B" $walk/Ranked.v \
  'if rank A a <? rank B b then map' 'if rank A a <=? rank B b then map' Ranked.v
mutate "B is left on < instead of <=" $walk/Ranked.v \
  'if parent_rank B b <=? parent_rank A a then' 'if parent_rank B b <? parent_rank A a then' Ranked.v
mutate "a real rank can be the root's parent's" $mesh 'kMaxRank = 126' 'kMaxRank = 127' Constants.v Ranked.v
mutate "a root's missing parent ranks lower" $mesh 'kRootParentRank = 127' 'kRootParentRank = 100' \
  Constants.v Ranked.v
mutate "ranks may grow by one downwards" $walk/Ranked.v \
  'In x (kids n) -> rank x <= rank n;' 'In x (kids n) -> rank x <= rank n + 1;' Ranked.v
mutate "can_visit() takes equal ranks on both sides" $walk/Ranked.v \
  'rank A a < parent_rank B b /\' 'rank A a <= parent_rank B b /\' Ranked.v
mutate "an ascent keeps the parent's rank" $walk/Code.v \
  'let i := node p - 1 in {| node := i; place_rank := c_parent_rank (cell cells i) |}' \
  'let i := node p - 1 in {| node := i; place_rank := place_rank p |}' Code.v
mutate "a descent keeps the parent's rank" $walk/Code.v 'place_rank := rank |}' 'place_rank := place_rank p |}' Code.v
mutate "a last child's link is a sibling" $walk/Code.v 'if i <? node p then Some' 'if i <=? node p then Some' Code.v
mutate "the first child is the next node" $walk/Code.v \
  'Definition first_child (i : nat) : nat := c_link (cell cells (i + 1))' \
  'Definition first_child (i : nat) : nat := i + 1' Code.v
mutate "the end is seen a node late" $walk/Code.v 'None => if node b =? 0 then CDone' \
  'None => if node b =? 1 then CDone' Code.v
mutate "a walk below a leaf ends a node early" $walk/Code.v 'if i =? root then next_turn resumed a b' \
  'if i - 1 =? root then next_turn resumed a b' Code.v
mutate "below a leaf the other one is taken for it" $walk/Code.v \
  'then if is_leaf cells_a (node a) then LeafA else NoLeaf' \
  'then if is_leaf cells_b (node b) then LeafB else NoLeaf' Code.v
mutate "a resumed walk does not look below which leaf it is" $walk/Code.v \
  'if resumed then enter true a b else CVisit a b' 'CVisit a b' Code.v
mutate "a position forgets what is untested" $walk/Query.v \
  '(At_leaf_pair p (u - v))' '(At_leaf_pair p 0)' Query.v
mutate "a batch that is left goes on behind its last pair" $walk/Query.v \
  'found_in n (load at_) = l ++ p :: r ->' 'found_in n (load at_) = l ++ r ++ [p] ->' Query.v
mutate "opening does not look whether the ring closes" $walk/Image.v \
  '(link (last node) =? node) && ' '' Image.v
mutate "opening takes a link to itself for a sibling" $walk/Image.v \
  'Definition enter_sibling (i : nat) : bool := (link i <? i)' \
  'Definition enter_sibling (i : nat) : bool := (link i <=? i)' Image.v
mutate "opening does not climb from the last leaf" $walk/Image.v \
  'leaf (count - 1) && leave_to count (count - 1) 0' 'leaf (count - 1)' Image.v
mutate "opening does not compare ranks" $walk/Image.v '(rank child <=? rank parent)' 'true' Image.v
mutate "opening takes a box that ends outside its parent" $walk/Exact.v \
  '(x (high s) <=? x (high t))' '(x (high t) <=? x (high s))' Exact.v
mutate "opening does not look whether a leaf's box holds its triangles" $walk/Exact.v \
  'is_inside {| low := p; high := p |} (box m n)) (leaf_points m n)) (seq' 'true) (leaf_points m n)) (seq' Exact.v
mutate "a slab begins where its triangles end" $walk/Exact.v 'least := extreme Z.min' 'least := extreme Z.max' Exact.v
mutate "a rotated leaf's slabs have no margin" $walk/Exact.v '(slab_margin (reach root_b) (defect r)) s)' '0 s)' Exact.v
mutate "B's reach is its upper bounds'" $walk/Exact.v 'Z.max (c (high t)) (- c (low t))' 'c (high t)' Exact.v
mutate "one entry's rest is left out of the margin" $walk/Exact.v '(Z.max (size (a1 r)) (size (b1 r)))' \
  '(size (b1 r))' Exact.v
mutate "a triangle that touches its leaf's box is beside it" $walk/Exact.v 'c (high t) < c p' 'c (high t) <= c p' Exact.v
mutate "roots are far apart by half of the margin" $walk/Exact.v 'start_of e offset @kWidestMargin@' \
  'start_of e offset (@kWidestMargin@ / 2)' Exact.v
mutate "a line of the leaf's test that is quoted" $detail/bounds/slab_dsp.hpp 'may_touch_both(tests.plane, tests.edge, box)' \
  'may_touch_both(tests.edge, tests.plane, box)' Exact.v
mutate "a line of the walk that is quoted" $detail/walk/ranked.hpp \
  'if (b_.parent_rank <= a_.parent_rank)' 'if (b_.parent_rank < a_.parent_rank)' Code.v
mutate "one leaf of two nodes counts as none" $detail/walk/walk.hpp '(a.rank() | b.rank()) >= 0' \
  '(a.rank() & b.rank()) >= 0' Code.v
mutate "a high word lets farther offsets by" $arithmetic/Margins.v 'farthest / 2 ^ 24' 'farthest / 2 ^ 23' Margins.v
mutate "whole cells let a farther offset by" $arithmetic/Margins.v '(whole <? most_cells)' '(whole <=? most_cells)' \
  Margins.v
mutate "a line of the paper's walk that is quoted" $paper/stackless.hpp 'if (rcl_b < lag) {' 'if (rcl_b <= lag) {' \
  Stackless.v
mutate "a tie of levels goes to A" $stackless 'if ((level_a a <? level_b b)' 'if ((level_a a <=? level_b b)' Stackless.v
mutate "a climb in A goes on into B's turn" $stackless 'if rcl_a <=? l then' 'if rcl_a <=? l + 1 then' Stackless.v
mutate "a climb in B goes on into A's turn" $stackless 'if rcl_b <? lag then' 'if rcl_b <=? lag then' Stackless.v
mutate "A's left child wins a tie too late" $stackless 'if rcl_a - l <=? rcl_b then' 'if rcl_a - l <? rcl_b then' Stackless.v
mutate "A is left a level low" $stackless '(at_a s) (l + rcl_b + 1)' '(at_a s) (l + rcl_b)' Stackless.v
mutate "levels may differ by two without a leaf" $stackless '(level_b b - level_a a <=? 1)' \
  '(level_b b - level_a a <=? 2)' Stackless.v
mutate "a level is one too large below the root" $stackless 'nth x levels 0 = S (nth n levels 0)' \
  'nth x levels 0 = S (S (nth n levels 0))' Stackless.v
mutate "slabs have half of the margin for vertices" lib/include/flashbvh/detail/bounds/transform.hpp "33'500" "16'500" Slabs.v
mutate "slabs' margin lacks what turning adds to an edge" $arithmetic/Slabs.v 'turned / 2 + each / 4 * 3' \
  'each / 4 * 3' Slabs.v
mutate "a slab is placed by cells rounded down" $arithmetic/Slabs.v '(2 * offset + cell14) / (2 * cell14)' \
  'offset / cell14' Slabs.v
mutate "a slab's margin has the wrong sign" $arithmetic/Rejects.v 'bias + least + offset - margin' \
  'bias + least + offset + margin' Rejects.v
mutate "no half cell for rounded vertices" $arithmetic/Rejects.v '(box_margin most reach + kHalf) box_b' \
  '(box_margin most reach) box_b' Rejects.v
mutate "offsets are cut to 30,000 cells" lib/include/flashbvh/detail/bounds/rotated_transform.hpp 'kMaxOffset = 48000' \
  'kMaxOffset = 30000' Rejects.v
mutate "a bound that touches is rejected" $arithmetic/Rejects.v '+ (bias - lower) < 2 * bias' \
  '+ (bias - lower) <= 2 * bias' Rejects.v
mutate "a product's rounding counts 12" lib/src/lattice/pose.cpp 'kRoundingDefect = 13' 'kRoundingDefect = 12' composed.g
mutate "a sine within 2^-28" $arithmetic/chain.g '1.414214 * 1b-29' '1.414214 * 1b-28' chain.g
mutate "a segment that touches an edge misses" $arithmetic/Segment.v '(u <? 0) || (v <? 0) || (w <? 0))).' \
  '(u <=? 0) || (v <? 0) || (w <? 0))).' Segment.v
mutate "a coordinate has 16 bits" lib/include/flashbvh/lattice.hpp 'kMaxCoordinate = 16383' \
  'kMaxCoordinate = 16385' box_test.smt2
mutate "a threshold is off by one" $arithmetic/box_test.smt2 \
  '(bvneg zero) (bvsub zero #x00000001)' '(bvneg zero) (bvsub zero #x00000002)' box_test.smt2
mutate "Helium looks at what lies behind a box" $arithmetic/box_forms.smt2 \
  '(hi #x00000000 (add16 a3 b2))' '(hi #x00000001 (add16 a3 b2))' box_forms.smt2
mutate "a clamp to 15 bits is one to 14" $arithmetic/box_rotated.smt2 \
  '(ite (bvugt s most) most s)' '(ite (bvugt s most) (bvlshr most #x00000001) s)' box_rotated.smt2
mutate "differences of 2^21" $detail/predicates/triangle.hpp '(1 << 20) - 1' '(1 << 21) - 1' determinant.g
mutate "narrow differences of 2^15" lib/src/predicates/triangle.cpp '(1 << 15) - 1' '(1 << 15) + 1' \
  determinant_narrow.g
mutate "directions of 14 bits" $detail/bounds/slab.hpp 'kDirectionBits = 13' 'kDirectionBits = 14' slab.g
mutate "distances of 2^18" $detail/predicates/triangle_distance.hpp '(1 << 17) - 1' '(1 << 18) - 1' distance.g
mutate "rays of 2^21" $detail/walk/segment_walk.hpp '(1 << 19) - 1' '(1 << 21) - 1' ray.g
mutate "a coefficient of the sine is off by 4" lib/src/robot/sine.hpp '-346799333' '-346799329' sine.g
mutate "a triangle's tip on the plane is not one" $arithmetic/Triangle.v \
  'then negb (below g) else 0 <? g' 'then 0 <? g else 0 <? g' Triangle.v
mutate "corners are not mirrored" $arithmetic/Triangle.v \
  'if up_b then (na, pa) else (pa, na) in' 'if up_a then (na, pa) else (pa, na) in' Triangle.v
mutate "touching does not count" $arithmetic/Triangle.v '(volume ta ha tb hb <=? 0)' \
  '(volume ta ha tb hb <? 0)' Triangle.v
mutate "an edge that touches separates" $arithmetic/Flat.v \
  'negb (side =? 0) && negb (side =? inner) && (side' 'negb (side =? inner) && (side' Flat.v
mutate "an edge separates from what lies on its inner side" $arithmetic/Flat.v 'negb (side =? inner) && ' '' Flat.v
mutate "two corners beyond an edge suffice" $arithmetic/Flat.v ' && (side =? turn u v p q b2).' '.' Flat.v
mutate "one projection decides, whatever its area" $arithmetic/Flat.v \
  'negb (turn u v a0 a1 a2 =? 0) then true' 'negb (turn u v a0 a1 a2 =? 1) then true' Flat.v
mutate "skew segments meet" $arithmetic/Flat.v '(volume a0 a1 b0 b1 =? 0) && ' '' Flat.v Lines.v
mutate "segments on one line are not asked for their boxes" $arithmetic/Test.v \
  'boxes_overlap a0 a1 a2 b0 b1 b2 && intersect' 'intersect' Test.v
mutate "boxes that touch do not overlap" $arithmetic/Test.v 'least a0 a1 a2 <=? most' 'least a0 a1 a2 <? most' Test.v
mutate "two corners on a side separate" $arithmetic/Test.v '(0 <? g0) && (0 <? g1) && (0 <? g2)' \
  '(0 <? g0) && (0 <? g1)' Test.v
mutate "a tip's segment takes another corner" $arithmetic/Test.v "let '(s0, s1, _) :=" "let '(s0, _, s1) :=" Test.v
mutate "a line of the flat case that is quoted" lib/src/predicates/triangle.cpp 'side != inner && side ==' \
  'side == inner && side ==' Flat.v
mutate "a step that takes more leaves work" $walk/Work.v 'then left - spent else 0' 'then left - spent else 1' Work.v
mutate "pairs that are not paid for are tested" $walk/Work.v 'then 0 else 1' 'then 0 else 2' Work.v
rm -rf "$work"
echo "== $refused changes refused, $survived survived"
[ "$survived" -eq 0 ]
