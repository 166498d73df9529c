#!/bin/sh
# Every algorithm, layout, index width, leaf size and arity finds exactly the pairs that brute force
# finds on the exported meshes.
. "$SOURCES/common.sh"

cat >poses <<'POSES'
# apart, touching boxes, crossing, almost the same place, the same place
1 0 0 0 1 0 0 0 1  80 0 0

1 0 0 0 1 0 0 0 1  51.9 0.5 0   # side by side
1 0 0 0 1 0 0 0 1  20 3.3 2
1 0 0 0 1 0 0 0 1  0.1 -0.2 0.05
1 0 0 0 1 0 0 0 1  0 0 0
1 0 0 0 1 0 0 0 1  -7.25 1e1 -.5
POSES

# brute NAME: all pairs for the two images in NAME.
brute() {
  "$FLASHBVH" export "$1/ring.fbvh" -o a.obj
  grep -v '^#' poses | grep . | sed 's/#.*//' | {
    i=0
    while read -r pose; do
      "$FLASHBVH" export "$1/coarse.fbvh" -o b.obj --placed "$pose"
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
    awk '{ n[$1]++ } END { for (i = 0; i < 6; ++i) print n[i] + 0 }' wanted | cmp - counts ||
      fail "counts of $images, $algorithm"
    [ "$(grep -c "\"algorithm\":\"$algorithm\".*\"status\":\"ok\"" json)" -eq 6 ] || fail "$(cat json)"
  done
}

both="volume-stack alternating-stack leaf"
for options in "" "--builder median" "--leaf-size 4 --arity 3" "--index-bits 32"; do
  # shellcheck disable=SC2086
  "$FLASHBVH" bake meshes/ring.stl meshes/coarse.stl -o post $options --cell 0.01 >/dev/null
  # shellcheck disable=SC2086
  "$FLASHBVH" bake meshes/ring.stl meshes/coarse.stl -o pre --layout pre $options --cell 0.01 >/dev/null
  brute post >wanted
  [ "$(cut -d ' ' -f 1 wanted | sort -u | wc -l)" -ge 3 ] || fail "too few poses with pairs"
  # shellcheck disable=SC2086
  agree post ranked ranked-stack stackless-post $both
  # shellcheck disable=SC2086
  agree pre stackless $both
done

# The defaults, the first pair alone, and the table.
"$FLASHBVH" collide post/ring.fbvh post/coarse.fbvh --poses poses --json >json
grep -q '"algorithm":"ranked"' json || fail "$(cat json)"
"$FLASHBVH" collide pre/ring.fbvh pre/coarse.fbvh --poses poses --json >json
grep -q '"algorithm":"stackless"' json || fail "$(cat json)"
"$FLASHBVH" collide post/ring.fbvh post/coarse.fbvh --poses poses --first --pairs first --json >json
[ "$(cut -d ' ' -f 1 first | sort -u | wc -l)" -eq "$(wc -l <first)" ] || fail "$(cat first)"
[ "$(cut -d ' ' -f 1 first)" = "$(cut -d ' ' -f 1 wanted | sort -u)" ] || fail "$(cat first)"
if grep -qE '"triangle_pairs":([2-9]|1[0-9])' json; then
  fail "$(cat json)"
fi
[ "$("$FLASHBVH" collide post/ring.fbvh post/coarse.fbvh --poses poses | wc -l)" -eq 8 ] || fail table
"$FLASHBVH" collide post/ring.fbvh post/coarse.fbvh --poses poses --pairs /dev/null >/dev/null
[ -c /dev/null ] || fail "a device was replaced"
