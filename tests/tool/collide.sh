#!/bin/sh
# Every algorithm, layout, index width, leaf size and arity finds exactly the pairs that brute force
# finds on the exported meshes; with FLASHBVH_THOROUGH each of them apart.
. "$SOURCES/common.sh"

cat >poses <<'POSES'
# disjoint, touching boxes, crossing, almost the same place, the same place
1 0 0 0 1 0 0 0 1  80 0 0

1 0 0 0 1 0 0 0 1  51.9 0.5 0   # side by side
1 0 0 0 1 0 0 0 1  20 3.3 2
1 0 0 0 1 0 0 0 1  0.1 -0.2 0.05
1 0 0 0 1 0 0 0 1  0 0 0
1 0 0 0 1 0 0 0 1  -7.25 1e1 -.5
# rotated: a quarter, about no axis of the lattice, with five decimals, far away, and any way
0 -1 0 1 0 0 0 0 1  20 3.3 2
0.36 0.48 -0.8 -0.8 0.6 0 0.48 0.64 0.6  1.005 -3 10.1
0.66667 -0.33333 0.66667 0.66667 0.66667 -0.33333 -0.33333 0.66667 0.66667  0 0 0
0 0 1 0 1 0 -1 0 0  -4e6 1 1
POSES
python3 "$SOURCES/poses.py" 12 1 25 >>poses
count=$(sed 's/#.*//' poses | grep -c .)

# brute NAME: all pairs for the two images in NAME.
brute() {
  "$FLASHBVH" export --cells "$1/ring.fbvh" -o a.obj
  grep -v '^#' poses | grep . | sed 's/#.*//' | {
    i=0
    while read -r pose; do
      "$FLASHBVH" export --cells "$1/coarse.fbvh" -o b.obj --pose "$pose"
      "$TOOLS/tool_test_brute_force" $i a.obj b.obj
      i=$((i + 1))
    done
  }
}

# agree NAME ALGORITHM...: each gives the pairs in the file wanted.
agree() {
  images=$1
  shift
  for algorithm in "$@"; do
    "$FLASHBVH" collide "$images/ring.fbvh" "$images/coarse.fbvh" --poses poses \
      --algorithm "$algorithm" --pairs found --json >json
    cmp wanted found || fail "$images, $algorithm"
    awk -F '"triangle_pairs":' '{ split($2, a, ","); print a[1] }' json >counts
    awk -v n="$count" '{ p[$1]++ } END { for (i = 0; i < n; ++i) print p[i] + 0 }' wanted |
      cmp - counts || fail "counts of $images, $algorithm"
    [ "$(grep -c "\"algorithm\":\"$algorithm\".*\"status\":\"ok\"" json)" -eq "$count" ] ||
      fail "$(cat json)"
  done
}

both="volume-stack alternating-stack leaf"
for options in "" "--builder median --leaf-size 4 --arity 3 --index-bits 32" "--builder median" \
  "--leaf-size 4 --arity 3" "--index-bits 32"; do
  # shellcheck disable=SC2086
  "$FLASHBVH" bake meshes/ring.stl meshes/coarse.stl -o post $options --cell 0.01 >/dev/null
  # shellcheck disable=SC2086
  "$FLASHBVH" bake meshes/ring.stl meshes/coarse.stl -o pre --layout pre $options --cell 0.01 >/dev/null
  brute post >wanted
  [ "$(cut -d ' ' -f 1 wanted | sort -u | wc -l)" -ge 10 ] || fail "too few poses with pairs"
  # shellcheck disable=SC2086
  agree post ranked ranked-stack stackless-post $both
  # shellcheck disable=SC2086
  agree pre stackless $both
  [ -z "$options" ] || thorough || break
done

# The defaults, the first pair alone, and the table.
"$FLASHBVH" collide post/ring.fbvh post/coarse.fbvh --poses poses --json >json
grep -q '"algorithm":"ranked"' json || fail "$(cat json)"
"$FLASHBVH" collide pre/ring.fbvh pre/coarse.fbvh --poses poses --json >json
grep -q '"algorithm":"stackless"' json || fail "$(cat json)"
"$FLASHBVH" collide post/ring.fbvh post/coarse.fbvh --poses poses --first --pairs first --json >json
[ "$(cut -d ' ' -f 1 first | sort -u | wc -l)" -eq "$(wc -l <first)" ] || fail "$(cat first)"
[ "$(cut -d ' ' -f 1 first)" = "$(cut -d ' ' -f 1 wanted | sort -nu)" ] || fail "$(cat first)"
if grep -qE '"triangle_pairs":([2-9]|[1-9][0-9])' json; then
  fail "$(cat json)"
fi
[ "$("$FLASHBVH" collide post/ring.fbvh post/coarse.fbvh --poses poses | wc -l)" -eq $((count + 2)) ] ||
  fail table
# What is said of each pose, and first of all: of pairs, of one mesh inside the other, of neither.
# said LINE JSON X: of a tetrahedron moved by X against itself, half a cell off.
"$FLASHBVH" bake meshes/tetrahedron.stl meshes/ring.stl -o solid --cell 0.01 >/dev/null 2>&1
awk '{ print }' <<'OBJ' >small.obj
v 1 1 1
v 1 2 1
v 2 1 1
v 1 1 2
f 1 2 3
f 1 4 2
f 1 3 4
f 3 2 4
OBJ
"$FLASHBVH" bake small.obj -o solid --cell 0.01 >/dev/null 2>&1
said() {
  echo "1 0 0 0 1 0 0 0 1  $3 0 0" >pose
  exits 0 collide solid/tetrahedron.fbvh solid/small.fbvh --poses pose
  [ "$(head -n 1 stdout)" = "tetrahedron and small, ranked: $1" ] || fail "$(cat stdout)"
  grep -q "^ *0  $1 " stdout || fail "$(cat stdout)"
  exits 0 collide solid/tetrahedron.fbvh solid/small.fbvh --poses pose --json
  grep -qF "{\"pose\":0,$2,\"algorithm\"" stdout || fail "$(cat stdout)"
}
said free '"intersects":false,"inside":false' 20
said inside '"intersects":false,"inside":true' 0
said intersect '"intersects":true' -1
exits 0 collide post/ring.fbvh post/coarse.fbvh --poses poses
intersecting=$(cut -d ' ' -f 1 wanted | sort -u | wc -l)
head -n 1 stdout | grep -q "^ring and coarse, ranked: $intersecting of $count poses intersect" ||
  fail "$(cat stdout)"
[ "$(grep -c ' intersect  ' stdout)" -eq "$intersecting" ] || fail "$(cat stdout)"
"$FLASHBVH" collide pre/ring.fbvh pre/coarse.fbvh --poses poses | grep -q ' free  ' || fail "pre-indexed"
"$FLASHBVH" collide post/ring.fbvh post/coarse.fbvh --poses poses --pairs /dev/null >/dev/null
[ -c /dev/null ] || fail "a device was replaced"

# Changed round and the pose inverted, whole turns on whole cells give the same pairs; any other
# rounds the other mesh, and gives about as many.
# inverse: 12 numbers to those of the inverse pose, a line each.
inverse() {
  awk '{ printf "%s %s %s %s %s %s %s %s %s", $1, $4, $7, $2, $5, $8, $3, $6, $9
    for (i = 1; i <= 3; ++i) printf " %.17g", -($i * $10 + $(i + 3) * $11 + $(i + 6) * $12)
    print "" }'
}
cat >poses <<'POSES'
0 -1 0 1 0 0 0 0 1  20 3.3 2
0 0 1 1 0 0 0 1 0  -7.25 1 .5
-1 0 0 0 0 1 0 1 0  3.01 0 11
1 0 0 0 0 -1 0 1 0  12 1 3
POSES
inverse <poses >inverses
"$FLASHBVH" collide post/ring.fbvh post/coarse.fbvh --poses poses --pairs there >/dev/null
"$FLASHBVH" collide post/coarse.fbvh post/ring.fbvh --poses inverses --pairs back >/dev/null
[ "$(cut -d ' ' -f 1 there | sort -u | wc -l)" -eq 4 ] || fail "too few poses with pairs"
awk '{ print $1, $3, $2 }' back | sort >back_sorted
sort there | cmp - back_sorted || fail "another answer with the arguments changed round"

python3 "$SOURCES/poses.py" 40 2 40 >poses
inverse <poses >inverses
"$FLASHBVH" collide post/ring.fbvh post/coarse.fbvh --poses poses --json >there
"$FLASHBVH" collide post/coarse.fbvh post/ring.fbvh --poses inverses --json >back
triangle_pairs() { sed 's/.*"triangle_pairs":\([0-9]*\).*/\1/' "$1"; }
triangle_pairs there >counts_there
triangle_pairs back >counts_back
paste counts_there counts_back | awk '
  { off = $1 - $2; if (off * off > 4 + $1 * $1 / 400) bad = 1; pairs += $1; none += $1 == 0 }
  END { exit bad || pairs == 0 || none == 0 || none > NR - 10 }' || fail "$(paste counts_there counts_back)"
