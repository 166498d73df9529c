#!/bin/sh
# Each format gives the same tree for the same mesh; polygons are cut up in place; nothing is lost.
. "$SOURCES/common.sh"

# A box of two units: as quadrilaterals with groups, materials, normals and comments.
cat >box.obj <<'OBJ'
# a box
mtllib missing.mtl
o first
v -1 -1 -1
v 1 -1 -1
v 1 1 -1
v -1 1 -1
vn 0 0 1
v -1 -1 1 1.0
v 1 -1 1
v 1 1 1 0.5 0.5 0.5
v -1 1 1
usemtl red
f 4 3 2 1
usemtl blue
g one
f 5//1 6//1 7//1 8//1
  f 1 2 6 5
o second
usemtl red
f -6 -5 -1 \
  -2
o first
f 3 4 8 7
g one
f 4 1 5 8
OBJ
cat >box.off <<'MESH'
OFF # a box
8 6 0

-1 -1 -1
1 -1 -1
1 1 -1   # with a comment
-1 1 -1
-1 -1 1
1 -1 1
1 1 1
-1 1 1
4 3 2 1 0
4 4 5 6 7
4 0 1 5 4
4 2 3 7 6 255 0 0
4 2 3 7 6
4 3 0 4 7
MESH
sed -i 's/^f -6 -5 -1 \\$/f 3 4 8 \\/; s/^  -2$/  -2/' box.obj
cat >box.ply <<'PLY'
ply
format ascii 1.0
comment a box
element vertex 8
property float x
property float y
property float z
element face 6
property list uchar int vertex_indices
end_header
-1 -1 -1
1 -1 -1
1 1 -1
-1 1 -1
-1 -1 1
1 -1 1
1 1 1
-1 1 1
4 3 2 1 0
4 4 5 6 7
4 0 1 5 4
4 2 3 7 6
4 2 3 7 6
4 3 0 4 7
PLY
for kind in obj off ply; do
  "$FLASHBVH" bake box.$kind -o $kind --cell 0.25 >table 2>warnings
  grep -q 'without area' warnings && fail "$(cat warnings)"
  grep -q "^flashbvh: box.$kind: warning: with the three vertices of an earlier one, once rounded: \
2 triangles (8 and 9); kept" warnings || fail "repeated triangles: $(cat warnings)"
done
cmp off/box.fbvh ply/box.fbvh
"$FLASHBVH" check obj/box.fbvh --mesh box.off >verdict || fail "$(cat verdict)"
"$FLASHBVH" export --cells off/box.fbvh -o off.obj
[ "$(grep -c '^f' off.obj)" -eq 12 ] || fail "not 12 triangles"
# Binary PLY, big-endian: a triangle with corners 0 0 0, 2 0 0, 0 2 0.
{
  printf 'ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty float x\n'
  printf 'property float y\nproperty float z\nelement face 1\n'
  printf 'property list uchar int vertex_indices\nend_header\n'
  printf '\0\0\0\0\0\0\0\0\0\0\0\0\100\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\100\0\0\0\0\0\0\0'
  printf '\3\0\0\0\0\0\0\0\1\0\0\0\2'
} >big.ply
printf 'v 0 0 0\nv 2 0 0\nv 0 2 0\nf 1 2 3\n' >big.obj
"$FLASHBVH" bake big.ply -o big --cell 0.5 >/dev/null
"$FLASHBVH" check big/big.fbvh --mesh big.obj >/dev/null || fail "big-endian PLY"

# A polygon with a notch, tiny, and one of nine corners: all of their triangles are there.
printf 'v 0 0 0\nv 4e-4 0 0\nv 4e-4 4e-4 0\nv 2e-4 1e-4 0\nv 0 4e-4 0\nf 1 2 3 4 5\n' >notch.obj
"$FLASHBVH" bake notch.obj -o notch --cell 1e-4 >/dev/null
"$FLASHBVH" export --cells notch/notch.fbvh -o notch.txt
[ "$(grep -c '^f' notch.txt)" -eq 3 ] || fail "not 3 triangles"
# Twice the area, summed over the triangles, is that of the polygon: none lies in the notch.
area=$(awk '$1 == "v" { x[++n] = $2; y[n] = $3 }
  $1 == "f" { d = (x[$3] - x[$2]) * (y[$4] - y[$2]) - (x[$4] - x[$2]) * (y[$3] - y[$2])
              sum += d < 0 ? -d : d }
  END { print sum }' notch.txt)
[ "$area" -eq 20 ] || fail "twice the area of the notched polygon is $area, not 20"

# ASCII STL, capitals, two solids, with a name that holds keywords.
cat >solids.stl <<'STL'
SOLID facet vertex
 FACET NORMAL 0 0 1
  OUTER LOOP
   VERTEX 0 0 0
   VERTEX 2.0E0 0 0
   VERTEX 0 +2 0
  ENDLOOP
 ENDFACET
ENDSOLID facet vertex
solid two
facet normal 0 0 1
outer loop
vertex 0 0 1
vertex 2 0 1
vertex 0 2 1
endloop
endfacet
endsolid two
STL
printf 'v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 1\nv 2 0 1\nv 0 2 1\nf 1 2 3\nf 4 5 6\nl 1 2\n' >solids.obj
"$FLASHBVH" bake solids.stl -o solids --cell 0.5 >/dev/null
"$FLASHBVH" check solids/solids.fbvh --mesh solids.obj 2>warning >/dev/null || fail "ASCII STL"
grep -q 'solids.obj: warning: 1 points or lines left out' warning || fail "no warning"

# One triangle is a tree; so is one that rounding makes a point.
printf 'v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nf 1 2 3\n' >point.obj
"$FLASHBVH" bake point.obj -o point --cell 1 >/dev/null 2>warnings
grep -q 'without area once rounded: 1 triangle (0); kept' warnings || fail "$(cat warnings)"
"$FLASHBVH" check point/point.fbvh --mesh point.obj >/dev/null
"$FLASHBVH" bake point.obj -o point >/dev/null

# A text file whose last number may be cut is read, with a warning.
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3' >cut.obj
"$FLASHBVH" bake cut.obj -o cut >/dev/null 2>warning
grep -q 'cut.obj: warning: the last line has no end' warning || fail "no warning"
