#!/bin/sh
# What is odd about a mesh is told in a line each, by triangle ids; the triangles stay unless told
# otherwise, and those that stay keep their numbers.
. "$SOURCES/common.sh"

# warned LINE...: exactly these warnings, of mesh.obj.
warned() {
  for line; do
    echo "flashbvh: mesh.obj: warning: $line"
  done >wanted
  cmp wanted stderr || fail "$(diff wanted stderr)"
}
open="no closed surface"
inside="what lies inside the solid can't be told"
kept_degenerate="kept (--drop degenerate leaves them out)"
kept_duplicate="kept (--drop duplicate leaves them out)"

# A closed box says nothing.
cat >box.obj <<'OBJ'
v 0 0 0
v 8 0 0
v 8 8 0
v 0 8 0
v 0 0 8
v 8 0 8
v 8 8 8
v 0 8 8
f 4 3 2 1
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
OBJ
exits 0 bake box.obj -o box --cell 1
[ ! -s stderr ] || fail "$(cat stderr)"
exits 0 bake meshes/ring.stl meshes/coarse.stl meshes/tetrahedron.stl -o rings
[ ! -s stderr ] || fail "$(cat stderr)"

# Triangle 12 lies on a line, 13 is smaller than a cell, 14 and 15 repeat 0 and 2, turned about.
{
  cat box.obj
  printf 'v 0.1 0.2 0\nv 0.2 0.1 0\n'
  printf 'f 1 3 3\nf 1 9 10\nf 2 4 3\nf 6 5 7\n'
} >mesh.obj
exits 0 bake mesh.obj -o all --cell 1
warned "without area: 1 triangle (12); $kept_degenerate" \
  "without area once rounded: 1 triangle (13); $kept_degenerate" \
  "with the three vertices of an earlier one, once rounded: 2 triangles (14 and 15); $kept_duplicate"
exits 0 check all/mesh.fbvh --mesh mesh.obj
grep -q '16 triangles.*equal to mesh.obj$' stdout || fail "$(cat stdout)"

exits 0 bake mesh.obj -o some --cell 1 --drop degenerate
warned "without area: 1 triangle (12); left out" \
  "without area once rounded: 1 triangle (13); left out" \
  "with the three vertices of an earlier one, once rounded: 2 triangles (14 and 15); $kept_duplicate"
exits 0 check some/mesh.fbvh --mesh mesh.obj
grep -q '14 triangles.*without 2 degenerate and 0 duplicate triangles' stdout || fail "$(cat stdout)"
"$FLASHBVH" export --cells some/mesh.fbvh -o some.obj
[ "$(grep '^# triangle' some.obj)" = "# triangle 14" ] || fail "$(cat some.obj)"
[ "$(grep -c '^v' some.obj)" -eq 8 ] || fail "vertices that nothing uses"

exits 0 bake mesh.obj -o few --cell 1 --drop degenerate,duplicate
exits 0 check few/mesh.fbvh --mesh mesh.obj
grep -q '12 triangles.*without 2 degenerate and 2 duplicate triangles' stdout || fail "$(cat stdout)"
exits 1 check few/mesh.fbvh --mesh meshes/tetrahedron.stl
exits 1 check box/box.fbvh --mesh meshes/tetrahedron.stl
# checked CODE JSON ARGUMENT...: what `check --json` prints.
checked() {
  code=$1
  json=$2
  shift 2
  exits "$code" check "$@" --json
  [ "$(cat stdout)" = "$json" ] || fail "$(cat stdout)"
}
checked 0 '{"image":"few/mesh.fbvh","ok":true,"kind":"mesh","triangles":12,"nodes":8,"mesh":"mesh.obj","equal":true,"left_out_degenerate":2,"left_out_duplicate":2,"warnings":[]}' \
  few/mesh.fbvh --mesh mesh.obj
checked 1 '{"image":"box/box.fbvh","ok":false,"kind":"mesh","triangles":12,"nodes":8,"mesh":"meshes/tetrahedron.stl","equal":false,"difference":"corner 0 of triangle 0 lies at (0 8 0) in the image, at (0 0 0) in the mesh","warnings":[]}' \
  box/box.fbvh --mesh meshes/tetrahedron.stl
checked 2 '{"image":"box.obj","ok":false,"wrong":"box.obj: is no flashbvh image but a mesh; name its image, and the mesh by --mesh"}' \
  box.obj
sed '$d' box.obj >open.obj
exits 0 bake open.obj -o open --cell 1
exits 1 check open/open.fbvh --mesh box.obj
grep -q 'the image lacks triangle 10' stdout || fail "$(cat stdout)"
exits 1 check box/box.fbvh --mesh open.obj
grep -q 'the image has a triangle 10, the mesh only 10' stdout || fail "$(cat stdout)"

# Answers speak of the file's numbers, whatever was left out before them.
{ grep '^v' mesh.obj; printf 'f 1 3 3\nf 1 9 10\n'; grep '^f' box.obj; } >late.obj
"$FLASHBVH" bake late.obj -o late --cell 1 --drop degenerate >/dev/null 2>&1
"$FLASHBVH" bake box.obj -o late --cell 1 >/dev/null
echo "1 0 0 0 1 0 0 0 1  8 1 1" >pose
"$FLASHBVH" collide late/late.fbvh box/box.fbvh --poses pose --pairs late_pairs >/dev/null
"$FLASHBVH" collide box/box.fbvh box/box.fbvh --poses pose --pairs box_pairs >/dev/null
awk '{ print $1, $2 + 2, $3 }' box_pairs | sort >wanted
[ -s wanted ] || fail "nothing touches"
sort late_pairs | cmp wanted -
refused "late.obj: --drop leaves no triangle" bake late.obj -o out --cell 100 --drop degenerate
refused "--drop" bake box.obj -o out --drop sharp
refused "--drop" bake box.obj -o out --drop

# Boundary, non-manifold, twisted.
sed 's/^f 4 1 5 8$//' box.obj >mesh.obj
exits 0 bake mesh.obj -o odd --cell 1
warned "$open (4 boundary edges of one triangle): $inside"
{ cat box.obj; echo 'v 4 4 12'; echo 'f 7 8 9'; } >mesh.obj
exits 0 bake mesh.obj -o odd --cell 1
warned "$open (2 boundary edges of one triangle, 1 non-manifold edge of more than two): $inside"
sed 's/^f 4 1 5 8$/f 8 5 1 4/' box.obj >mesh.obj
exits 0 bake mesh.obj -o odd --cell 1
warned "$open (4 edges of two that face opposite ways): $inside, nor which way normals face"
exits 0 check odd/mesh.fbvh
grep -q '^flashbvh: odd/mesh.fbvh: warning: .*, nor which way normals face$' stderr || fail "$(cat stderr)"
exits 0 check odd/mesh.fbvh --json
grep -q '"warnings":\[{"place":"odd/mesh.fbvh","warning":"no closed surface' stdout || fail "$(cat stdout)"
# Inside out, told by the volume: wherever the mesh lies, and beside a smaller shell that is not. A
# hollow box is none.
# box SIZE X inwards|outwards: from (X X X).
box() {
  awk -v size="$1" -v x="$2" -v turned="$3" '
    $1 == "v" { print $1, $2 / 8 * size + x, $3 / 8 * size + x, $4 / 8 * size + x }
    $1 == "f" && turned == "inwards" { print $1, $5 - 9, $4 - 9, $3 - 9, $2 - 9 }
    $1 == "f" && turned == "outwards" { print $1, $2 - 9, $3 - 9, $4 - 9, $5 - 9 }' box.obj
}
turned="is inside out: normals face into the solid; turn the triangles round in the program that made it, \
or leave them if it is a room, seen from within"
for x in -1000 -4 0 1000; do
  box 8 $x inwards >mesh.obj
  exits 0 bake mesh.obj -o odd --cell 1
  warned "$turned"
  exits 0 check odd/mesh.fbvh
  [ "$(cat stderr)" = "flashbvh: odd/mesh.fbvh: warning: $turned" ] || fail "$(cat stderr)"
done
{ box 8 0 inwards; box 4 100 outwards; } >mesh.obj
exits 0 bake mesh.obj -o odd --cell 1
warned "$turned"
{ box 8 0 outwards; box 4 2 inwards; } >mesh.obj
exits 0 bake mesh.obj -o odd --cell 1
[ ! -s stderr ] || fail "$(cat stderr)"

# Two boxes side by side that rounding joins along a wall.
{
  cat box.obj
  awk '$1 == "v" { print $1, $2 + 8.25, $3, $4 } $1 == "f" { print $1, $2 + 8, $3 + 8, $4 + 8, $5 + 8 }' \
    box.obj
} >mesh.obj
exits 0 bake mesh.obj -o odd --cell 0.25
[ ! -s stderr ] || fail "$(cat stderr)"
exits 0 bake mesh.obj -o odd --cell 1
grep -q "once rounded $open (.*$inside; a finer --cell keeps it closed" stderr || fail "$(cat stderr)"

# Out of range: which triangles, and what would fit.
{ cat box.obj; printf 'v 900 0 0\nv 900 1 0\nf 9 10 1\n'; } >far.obj
refused "far.obj: is too large for a cell of 0.015: out of range are 13 triangles (0, 1, 2, 3, 4 and \
8 more); the finest that it fits is --cell " bake far.obj -o out --cell 0.015
exits 0 bake far.obj -o far --cell "$(sed 's/.*--cell //' stderr)"

# Far from its frame's origin: 2^18 cells are near enough, along all axes together.
far() { awk -v x="$1" '$1 == "v" { $2 += x } { print }' box.obj; }
far 262132 >mesh.obj
exits 0 bake mesh.obj -o near --cell 1
[ ! -s stderr ] || fail "$(cat stderr)"
far 262133 >mesh.obj
exits 0 bake mesh.obj -o near --cell 1
warned "lies far from its frame's origin: rotated, it is placed within 0.54 cells instead of 0.51; \
draw it nearer, or use a larger --cell"

# How far rounding may move a vertex.
printf 'v 0 0 0\nv 1 0 0\nv 0 0.25 1\nf 1 2 3\n' >thin.obj
exits 0 bake thin.obj -o thin --cell 0.5 --max-deviation 0.25
exits 0 bake thin.obj -o thin --cell 0.25 --max-deviation 0
refused "thin.obj: rounding moves a vertex by 0.25, --max-deviation allows 0.125; a cell of 0.144" \
  bake thin.obj -o out --cell 0.5 --max-deviation 0.125
exits 0 bake thin.obj -o thin --cell "$(sed 's/.*a cell of \([^ ]*\) .*/\1/' stderr)" \
  --max-deviation 0.125
refused "thin.obj: rounding moves a vertex by 0.25, --max-deviation allows 1e-09; the mesh is too \
large for so fine a cell: cut it in parts" bake thin.obj -o out --cell 0.5 --max-deviation 1e-9
for length in -1 nan abc ""; do
  refused "--max-deviation" bake thin.obj -o out --max-deviation "$length"
done

# A bar only where it is asked for or seen; quick work shows none on a terminal either.
exits 0 bake box.obj -o bar --cell 1 --progress
tr '\r' '\n' <stderr | grep -q '50 %  baking box.obj' || fail "$(cat stderr)"
if command -v script >/dev/null; then
  script -qec "'$FLASHBVH' bake box.obj -o bar --cell 1" /dev/null >terminal
  grep -q '%' terminal && fail "$(cat terminal)"
fi
:
