#!/bin/sh
# What rays hit, by the firmware's own code: in the mesh's frame and unit, from points or from an
# origin and a direction.
. "$SOURCES/common.sh"

# Two boxes of 10 mm, one behind the other along x, 100 mm off their frame's origin.
awk 'BEGIN {
  for (b = 0; b < 2; ++b)
    for (i = 0; i < 8; ++i)
      print "v", 100 + 20 * b + 10 * (i % 2), 10 * (int(i / 2) % 2), 10 * int(i / 4)
  for (b = 0; b < 16; b += 8) {
    split("1 3 4 2 5 6 8 7 1 2 6 5 3 7 8 4 1 5 7 3 2 4 8 6", c, " ")
    for (f = 0; f < 24; f += 4)
      print "f", b + c[f + 1], b + c[f + 2], b + c[f + 3], b + c[f + 4]
  }
}' >boxes.obj
"$FLASHBVH" bake boxes.obj -o shut --cell 0.01 --unit mm >/dev/null
cat >rays <<'RAYS'
90 5 4  150 5 4       # through both
90 5 4  105 5 4       # into the first one
90 0 0  150 0 0       # along edges
115 5 4  150 5 4      # between them
90 11 4  150 11 4     # past them
90 5 4  2 0 0  60     # the first again, by a direction of any length
90 5 4  1 0 0  9.5    # too short
RAYS
exits 0 ray shut/boxes.fbvh --rays rays --json
sed 's/.*"hit":\([a-z]*\).*/\1/' stdout | tr '\n' ' ' >hits
[ "$(cat hits)" = "true true true true false true false " ] || fail "$(cat stdout)"
sed -n 1p stdout | grep -q '"distance":10.0,"point":\[100.0,5.0,4.0\],"side":"front"' || fail "$(cat stdout)"
sed -n 4p stdout | grep -q '"distance":5.0,' || fail "$(cat stdout)"
sed -n 6p stdout | grep -q '"distance":10.0,' || fail "$(cat stdout)"
sed 's/.*"crossings":\([-0-9]*\).*/\1/' stdout | tr '\n' ' ' >crossings
[ "$(cat crossings)" = "0 -1 0 0 0 0 0 " ] || fail "$(cat stdout)"

exits 0 ray shut/boxes.fbvh --rays rays --all --json
sed -n 1p stdout | grep -o '"distance":[0-9.]*' | tr '\n' ' ' >distances
[ "$(cat distances)" = '"distance":10.0 "distance":20.0 "distance":30.0 "distance":40.0 ' ] ||
  fail "$(cat stdout)"
sed -n 1p stdout | grep -o '"side":"[a-z]*"' | tr '\n' ' ' >sides
[ "$(cat sides)" = '"side":"front" "side":"back" "side":"front" "side":"back" ' ] || fail "$(cat stdout)"
exits 0 ray shut/boxes.fbvh --rays rays
[ "$(awk '$2 == 10' stdout | wc -l)" -eq 4 ] || fail "$(cat stdout)"

exits 0 ray shut/boxes.fbvh --rays rays
head -n 1 stdout | grep -q '^boxes, distances in mm$' || fail "$(cat stdout)"
exits 0 ray shut/boxes.fbvh --rays rays --json
[ "$(grep -c '"unit":"mm"' stdout)" -eq 7 ] || fail "$(cat stdout)"

# An open mesh is hit, and has no crossings.
sed '$d' boxes.obj >open.obj
"$FLASHBVH" bake open.obj -o open --cell 0.01 >/dev/null 2>&1
exits 0 ray open/open.fbvh --rays rays --json
grep -q crossings stdout && fail "$(cat stdout)"
"$FLASHBVH" bake boxes.obj -o pre --layout pre --cell 0.01 >/dev/null
refused "pre-indexed" ray pre/boxes.fbvh --rays rays
echo "1 2 3 4 5" >bad
refused "bad:1: has 5 numbers; a ray has 6" ray shut/boxes.fbvh --rays bad
echo "1 2 3 4 5 x" >bad
refused "bad:1: 'x' is no finite number" ray shut/boxes.fbvh --rays bad
echo "1 2 3 0 0 0 1" >bad
refused "bad:1: is no ray" ray shut/boxes.fbvh --rays bad
echo "1 2 3 0 0 1 -1" >bad
refused "bad:1: is no ray" ray shut/boxes.fbvh --rays bad
echo "1 2 3 0 0 1 -1e-50" >bad  # a float rounds it to 0
refused "bad:1: is no ray: the reach is negative; give one from 0" ray shut/boxes.fbvh --rays bad
echo "0 0 0 9000 0 0" >bad
refused "ray 0 ends too far off" ray shut/boxes.fbvh --rays bad
: >bad
refused "bad: is empty" ray shut/boxes.fbvh --rays bad
