#!/bin/sh
# A mesh in a unit a thousand times smaller or larger is the same lattice mesh and gives the same
# answers under the same poses: nothing in the library knows a length.
. "$SOURCES/common.sh"

"$TOOLS/tool_test_meshes" meshes
"$FLASHBVH" bake meshes/ring.stl -o plain --cell 0.013 >log
"$FLASHBVH" export --cells plain/ring.fbvh -o ring.obj
python3 "$SOURCES/poses.py" 15 7 25 >poses

# scaled EXPONENT CELL: the mesh's own lattice points as lengths, times ten to the exponent.
scaled() {
  mkdir -p "by$1"
  awk -v e="$1" '$1 == "v" { print "v", $2 "e" e, $3 "e" e, $4 "e" e } $1 == "f"' ring.obj \
    >"by$1/ring.obj"
  awk -v e="$1" '{ for (i = 10; i <= 12; ++i) $i = $i "e" e; print }' poses >"by$1/poses"
  "$FLASHBVH" bake "by$1/ring.obj" -o "by$1" --cell "$2" >log
  "$FLASHBVH" export --cells "by$1/ring.fbvh" -o "by$1/lattice.obj"
  "$FLASHBVH" collide "by$1/ring.fbvh" "by$1/ring.fbvh" --poses "by$1/poses" --json \
    --pairs "by$1/pairs" >"by$1/answers"
}
scaled 0 8
scaled 3 8e3
scaled -3 8e-3
for exponent in 3 -3; do
  for file in lattice.obj pairs answers; do
    cmp "by0/$file" "by$exponent/$file" || fail "$file differs at a scale of 1e$exponent"
  done
done
[ "$(wc -l <by0/pairs)" -gt 100 ] || fail "hardly a pair was found"
