#!/bin/sh
# Which points lie inside, by the firmware's own code: in the mesh's frame and unit.
. "$SOURCES/common.sh"

# A ring of radii 20 and 6 about the z axis, 100 mm off its frame's origin.
"$FLASHBVH" bake meshes/ring.stl -o near --cell 0.01 >/dev/null
"$FLASHBVH" export near/ring.fbvh -o ring.obj
awk '$1 == "v" { $2 += 100; $4 -= 1000 } { print }' ring.obj >far.obj
"$FLASHBVH" bake far.obj -o far --cell 0.01 --unit mm >/dev/null
cat >points <<'POINTS'
100 0 -1000   # the hole
120 0 -1000
120 0 -994.5
126 0 -1000   # a corner
126.01 0 -1000
100 20 -1002
1e4 0 0
POINTS
printf '"outside"\n"inside"\n"inside"\n"surface"\n"outside"\n"inside"\n"outside"\n' >wanted
exits 0 inside far/far.fbvh --points points --json
sed 's/.*"where":\([^,]*\),.*/\1/' stdout | cmp wanted - || fail "$(cat stdout)"
exits 0 inside far/far.fbvh --points points
[ "$(awk '$2 == "inside"' stdout | wc -l)" -eq 3 ] || fail "$(cat stdout)"

sed '$d' far.obj >open.obj
"$FLASHBVH" bake open.obj -o open --cell 0.01 >/dev/null 2>&1
refused "is no closed surface and has no inside" inside open/open.fbvh --points points --json
"$FLASHBVH" bake far.obj -o pre --layout pre --cell 0.01 >/dev/null
refused "pre-indexed" inside pre/far.fbvh --points points --json
echo "1 2" >bad
refused "bad:1: has 2 numbers; a point has 3" inside far/far.fbvh --points bad --json
echo "1 2 x" >bad
refused "bad:1: 'x' is no finite number" inside far/far.fbvh --points bad --json
echo "1 2 1e9" >bad
refused "bad:1: the point lies at 1e+09" inside far/far.fbvh --points bad --json
echo "# none" >bad
refused "bad: is empty" inside far/far.fbvh --points bad --json
