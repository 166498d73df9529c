#!/bin/sh
# Distances by the firmware's own code: in the unit, with points, within a length, in every layout of
# options; and what can't be asked is refused.
. "$SOURCES/common.sh"

# Two boxes of 8 mm, the second one's lower corner at (0, 0, 0) of its own frame, a metre off the
# first one's.
box() {
  awk -v x="$1" -v y="$2" -v z="$3" 'BEGIN {
    for (i = 0; i < 8; ++i)
      print "v", x + 8 * (i % 2), y + 8 * (int(i / 2) % 2), z + 8 * int(i / 4)
    print "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6"
  }'
}
box 1000 1000 1000 >there.obj
box 0 0 0 >here.obj
"$FLASHBVH" bake there.obj here.obj -o mm --cell 0.01 --unit mm >/dev/null 2>&1
value() { sed "s/.*\"$1\":\([^,}]*\).*/\1/" "${2:-stdout}"; }

# Face to face, edge to edge, corner to corner, touching, intersecting, and one inside the other.
cat >poses <<'POSES'
1 0 0 0 1 0 0 0 1  1020.5 1001 1002
1 0 0 0 1 0 0 0 1  1011 1012 1002
1 0 0 0 1 0 0 0 1  1010 1014 1011
1 0 0 0 1 0 0 0 1  1008 1000 1000
1 0 0 0 1 0 0 0 1  1004 1003 1002
POSES
printf '12.5\n5\n7\n0\n0\n' >wanted
exits 0 clearance mm/there.fbvh mm/here.fbvh --poses poses --json
value distance | awk '{ print $1 + 0 }' | cmp wanted - || fail "$(cat stdout)"
value lower | awk '{ print $1 + 0 }' | cmp wanted - || fail "$(cat stdout)"
value upper | awk '{ print $1 + 0 }' | cmp wanted - || fail "$(cat stdout)"
[ "$(grep -c '"status":"ok"' stdout)" -eq 5 ] || fail "$(cat stdout)"
[ "$(grep -c '"unit":"mm"' stdout)" -eq 5 ] || fail "$(cat stdout)"
# In A's frame, as it was drawn.
sed -n 3p stdout | grep -q '"point_a":\[1008.0,1008.0,1008.0\],"point_b":\[1010.0,1014.0,1011.0\]' ||
  fail "$(cat stdout)"
sed -n 1p stdout | sed 's/.*"point_a":\[\([^]]*\)\],"point_b":\[\([^]]*\)\].*/\1,\2/' |
  awk -F , '$1 != 1008 || $4 != 1020.5 || $2 != $5 || $3 != $6 { exit 1 }' || fail "$(cat stdout)"
exits 0 clearance mm/there.fbvh mm/here.fbvh --poses poses
grep -q '^ *2 *7 mm ' stdout || fail "$(cat stdout)"
exits 0 clearance mm/there.fbvh mm/here.fbvh --poses poses --cold --json
value distance | awk '{ print $1 + 0 }' | cmp wanted - || fail "$(cat stdout)"

# Within: closed, at the last digit, with all pairs.
exits 0 clearance mm/there.fbvh mm/here.fbvh --poses poses --within 7 --json
[ "$(value within | tr '\n' ' ')" = "false true true true true " ] || fail "$(cat stdout)"
grep -q distance stdout && fail "that of any pair is not the meshes': $(cat stdout)"
exits 0 clearance mm/there.fbvh mm/here.fbvh --poses poses --within 6.999 --json
[ "$(value within | tr '\n' ' ')" = "false true false true true " ] || fail "$(cat stdout)"
exits 0 clearance mm/there.fbvh mm/here.fbvh --poses poses --within 0 --pairs near
exits 0 collide mm/there.fbvh mm/here.fbvh --poses poses --pairs found
cmp near found || fail "within nothing at all are the pairs that intersect"
[ -s near ] || fail "nothing touches"
exits 0 clearance mm/there.fbvh mm/here.fbvh --poses poses --within 13 --pairs near
[ "$(cut -d ' ' -f 1 near | sort -u | tr -d '\n')" = 01234 ] || fail "$(cat near)"

# Any shape, rotated, of any tree: one answer.
"$TOOLS/tool_test_meshes" meshes
python3 "$SOURCES/poses.py" 30 3 35 >any
for options in "" "--leaf-size 5 --arity 6" "--builder median --leaf-size 1" "--index-bits 32"; do
  # shellcheck disable=SC2086
  "$FLASHBVH" bake meshes/ring.stl meshes/coarse.stl -o post $options --cell 0.01 >/dev/null
  exits 0 clearance post/ring.fbvh post/coarse.fbvh --poses any --json
  value distance >answers
  [ -f first_answers ] || cp answers first_answers
  cmp first_answers answers || fail "$options"
done
awk '$1 > 1 { ++apart } $1 == 0 { ++touch } END { exit !(apart > 5 && touch > 2) }' answers ||
  fail "$(cat answers)"
exits 0 clearance post/ring.fbvh post/coarse.fbvh --poses any --float --json

# So far off that only "at least" can be told.
echo "1 0 0 0 1 0 0 0 1  5000 0 0" >far
exits 0 clearance mm/there.fbvh mm/here.fbvh --poses far --json
grep -q '"status":"out_of_range"' stdout || fail "$(cat stdout)"
# The truth is 4231, of 3992, 992 and 992; nothing is told but what holds.
awk -v lower="$(value lower)" -v upper="$(value upper)" \
  'BEGIN { exit !(lower > 0 && lower <= 4231 && upper >= 4232 && upper < 4500) }' || fail "$(cat stdout)"
grep -q '"distance":null.*"triangles":null,"point_a":null,"point_b":null' stdout || fail "$(cat stdout)"
exits 0 clearance mm/there.fbvh mm/here.fbvh --poses far
grep -q '>= .* out of range' stdout || fail "$(cat stdout)"
# Farther than 1/256 cells are counted; and a pose that follows begins anew.
echo "1 0 0 0 1 0 0 0 1  5000000 0 0" >farther
head -n 1 poses >>farther
exits 0 clearance mm/there.fbvh mm/here.fbvh --poses farther --json
[ "$(value upper | head -n 1)" = null ] || fail "$(cat stdout)"
[ "$(value distance | tail -n 1)" = 12.5 ] || fail "$(cat stdout)"
exits 0 clearance mm/there.fbvh mm/here.fbvh --poses far --within 5

refused "0 to 327.67, 32,767 cells" clearance mm/there.fbvh mm/here.fbvh --poses poses --within 328
refused "--within -1: is out of range" clearance mm/there.fbvh mm/here.fbvh --poses poses --within -1
refused "--within" clearance mm/there.fbvh mm/here.fbvh --poses poses --pairs out
refused "poses" clearance mm/there.fbvh mm/here.fbvh
refused "excludes" clearance mm/there.fbvh mm/here.fbvh --poses poses --within 1 --cold
refused "poses" clearance mm/there.fbvh mm/here.fbvh --poses poses --within 1 --pairs poses
"$FLASHBVH" bake there.obj here.obj -o pre --cell 0.01 --layout pre >/dev/null 2>&1
refused "pre-indexed, on which distances can't be asked" clearance pre/there.fbvh pre/here.fbvh \
  --poses poses
