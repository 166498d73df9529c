#!/bin/sh
# Bodies of a file: one mesh together, or each by itself, named after it.
. "$SOURCES/common.sh"

facet() {
  printf 'facet normal 0 0 1\nouter loop\nvertex 0 0 %s\nvertex 1 0 %s\nvertex 0 1 %s\nendloop\nendfacet\n' \
    "$1" "$1" "$1"
}
{
  echo "solid left wheel" && facet 0 && facet 1 && echo endsolid
  echo "solid" && facet 2 && echo endsolid
  echo "solid left-wheel" && facet 3 && echo endsolid
  echo "solid new" && facet 0.25 && echo endsolid
} >"robot arm.stl"

exits 0 bake "robot arm.stl" -o whole --cell 0.25
[ "$(cd whole && echo *.fbvh)" = "robot arm.fbvh" ] || fail "$(ls whole)"
exits 0 info "robot arm.stl" --json
grep -q '"bodies":\["left wheel","","left-wheel","new"\]' stdout || fail "$(cat stdout)"

exits 0 bake "robot arm.stl" -o split --cell 0.25 --split
grep -q "robot arm.stl, body 0 'left wheel': warning: no closed surface" stderr || fail "$(cat stderr)"
[ "$(cd split && echo *.fbvh)" = "left_wheel.fbvh left_wheel_2.fbvh new.fbvh robot_arm.fbvh" ] ||
  fail "$(ls split)"
grep -q 'namespace left_wheel_2 ' split/left_wheel_2.fbvh.hpp || fail "$(cat split/left_wheel_2.fbvh.hpp)"
# Each is what a file of its own would give.
{ echo solid && facet 3 && echo endsolid; } >left_wheel_2.stl
exits 0 bake left_wheel_2.stl -o alone --cell 0.25
for file in fbvh fbvh.hpp fbvh.cpp; do
  cmp split/left_wheel_2.$file alone/left_wheel_2.$file
done
for body in left_wheel left_wheel_2 new robot_arm; do
  exits 0 check split/$body.fbvh --mesh "robot arm.stl" --body $body
done
exits 1 check split/left_wheel.fbvh --mesh "robot arm.stl" --body new
exits 1 check split/left_wheel.fbvh --mesh "robot arm.stl"
exits 0 bake "robot arm.stl" -o units --cell 0.25 --split --unit mm --unit "robot arm.stl=in"
exits 0 check units/new.fbvh --mesh "robot arm.stl" --body new --unit mm --unit "robot arm.stl=in"

# Bodies share the cell that the largest needs, and what they are called in all files.
printf 'o big\nv 0 0 0\nv 900 0 0\nv 0 900 0\nf 1 2 3\no small\nv 1 0 0\nv 0 1 0\nf 1 4 5\n' >sizes.obj
exits 0 bake sizes.obj -o shared --split --format image
for body in big small; do
  "$FLASHBVH" info shared/$body.fbvh | grep '^cell ' >$body
done
cmp big small
cp sizes.obj again.obj
refused "again.obj, body 0 'big': would be written as 'big' like one of a mesh before it" \
  bake sizes.obj again.obj -o out --split
refused "--name: names one mesh, but --split makes one of each body" bake sizes.obj -o out --split --name x
refused "--body huge: is none of sizes.obj; it has big, small" \
  check shared/big.fbvh --mesh sizes.obj --body huge
refused "--body big: names a body of no file; give --mesh, too" check shared/big.fbvh --body big

# Names that compilers keep for themselves are changed, and those that differ in case alone numbered.
{
  for name in __wheel _Wheel Arm arm; do
    echo "solid $name" && facet 0 && echo endsolid
  done
} >named.stl
exits 0 bake named.stl -o named --cell 0.25 --split --format cpp
[ "$(cd named && echo *.hpp)" = "Arm.fbvh.hpp arm_2.fbvh.hpp m_Wheel.fbvh.hpp m__wheel.fbvh.hpp" ] ||
  fail "$(ls named)"
grep -q '^namespace m__wheel ' named/m__wheel.fbvh.hpp || fail "$(cat named/m__wheel.fbvh.hpp)"

# A mesh 50 times as long as the others is one of another unit, by the look of it.
for size in 1 49 51; do
  for body in a b c; do
    printf 'o %s\nv 0 0 0\nv %s 0 0\nv 0 1 0\nf -3 -2 -1\n' $body "$([ $body = c ] && echo $size || echo 1)"
  done >odd.obj
  exits 0 bake odd.obj -o odd --split --unit mm
  grep "times as long" stderr >odd_sizes || :
  [ "$(wc -l <odd_sizes)" -eq $((size > 50)) ] || fail "$size: $(cat stderr)"
done
grep -qF "odd.obj, body 2 'c': warning: is 51 x 1 x 0 mm, 51 times as long as the other meshes; if its \
unit or its scale is another one, --unit FILE=UNIT converts it" odd_sizes || fail "$(cat odd_sizes)"
"$FLASHBVH" info odd/c.fbvh | grep -q '^size  *51 x 0.999 x 0  mm$' || fail "$("$FLASHBVH" info odd/c.fbvh)"
"$FLASHBVH" info odd/c.fbvh --json | grep -q '"size":\[51.0,' || fail "$("$FLASHBVH" info odd/c.fbvh --json)"
"$FLASHBVH" bake odd.obj --split --dry-run --json 2>/dev/null |
  grep -qF '{"place":"odd.obj, body 2 '"'c'"'","warning":"is 51 x 1 x 0, ' || fail "no warning in JSON"

# What baking a mesh would take is what baking it takes.
exits 0 info meshes/ring.stl --json
cp stdout facts
for size in 1 2 4 8; do
  "$FLASHBVH" bake meshes/ring.stl -o sized --leaf-size $size --format cpp >table
  bytes=$(awk '$1 == "ring" { print $2 }' table)
  grep -q "{\"leaf_size\":$size,\"index_bits\":16,\"bytes\":$bytes,\"bytes_per_triangle\":" facts ||
    fail "$bytes at $size: $(cat facts)"
done
cell=$(sed -n 's/^cell \(.*\); flash.*/\1/p' table)
grep -qF "\"triangles\":400,\"vertices\":200,\"bodies\":[\"\"],\"box\":{\"lower\":[-26.0,-26.0,-5.7" facts ||
  fail "$(cat facts)"
grep -qF "\"finest_cell\":$cell," facts || fail "$(cat facts)"
exits 0 info meshes/ring.stl
grep -q '^size  *52 x 52 x 11.4$' stdout || fail "$(cat stdout)"
grep -q '^flash, leaf size 2  10016 bytes, 25.0 a triangle, with 16-bit indices$' stdout || fail "$(cat stdout)"
exits 0 info meshes/many_nodes.stl
grep -q '^flash, leaf size 1 .* 32-bit indices$' stdout || fail "$(cat stdout)"
grep -q '^flash, leaf size 4 .* 16-bit indices$' stdout || fail "$(cat stdout)"
exits 0 info sizes.obj --json
grep -q 'sizes.obj: warning: no closed surface' stderr || fail "$(cat stderr)"
grep -q '"boundary_edges":6,' stdout || fail "$(cat stdout)"
refused "missing.obj: can't be opened" info missing.obj

# Text is read in double precision, and deviations are those from the text.
printf 'v 1000000.03 0 0\nv 1000010 0 0\nv 1000000.01 10 0\nf 1 2 3\n' >far.obj
exits 0 bake far.obj -o far --cell 0.01 --max-deviation 1e-9
"$FLASHBVH" export --cells far/far.fbvh -o lattice.obj
grep -q '^v 100000003 0 0$' lattice.obj || fail "$(cat lattice.obj)"
printf 'v 5000000.3 0 0\nv 5000010 0 0\nv 5000000 10 0\nf 1 2 3\n' >off.obj
refused "off.obj: rounding moves a vertex by 0.0499999998" bake off.obj -o out --cell 0.25 \
  --max-deviation 0.01
