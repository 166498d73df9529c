#!/bin/sh
# Poses and pairs of images that can't be answered are refused by line, before anything is written.
. "$SOURCES/common.sh"

"$FLASHBVH" bake meshes/ring.stl meshes/coarse.stl -o post --cell 0.01 >/dev/null
"$FLASHBVH" bake meshes/ring.stl meshes/coarse.stl -o pre --layout pre --cell 0.01 >/dev/null
"$FLASHBVH" bake meshes/ring.stl -o wide --index-bits 32 --cell 0.01 >/dev/null
"$FLASHBVH" bake meshes/ring.stl -o coarser --cell 0.02 >/dev/null
good='1 0 0 0 1 0 0 0 1 0 0 0'

# bad WHAT LINE: a file of poses with LINE as its fourth line.
bad() {
  printf '# comment\n%s # comment\n\n%s\n' "$good" "$2" >poses
  refused "poses:4: $1" collide post/ring.fbvh post/coarse.fbvh --poses poses --pairs out --json
}
bad "has 11 numbers" "1 0 0 0 1 0 0 0 1 0 0"
bad "has 13 numbers" "1 0 0 0 1 0 0 0 1 0 0 0 0"
bad "has 1 numbers" "nonsense"
bad "'x'" "1 0 0 0 1 0 0 0 1 0 0 x"
bad "'nan'" "1 0 0 0 1 0 0 0 1 0 0 nan"
bad "'inf'" "1 0 0 0 1 0 0 0 1 0 inf 0"
bad "'0x1'" "1 0 0 0 1 0 0 0 1 0 0x1 0"
bad "'1,5'" "1 0 0 0 1 0 0 0 1 0 1,5 0"
no_rotation="the first 9 numbers are no rotation"
bad "$no_rotation" "2 0 0 0 1 0 0 0 1 0 0 0"
bad "$no_rotation" "1.001 0 0 0 1 0 0 0 1 0 0 0"
bad "$no_rotation" "1 0.001 0 0 1 0 0 0 1 0 0 0"
bad "$no_rotation" "0.67 -0.33 0.67 0.67 0.67 -0.33 -0.33 0.67 0.67 0 0 0"
bad "$no_rotation" "0 0 0 0 0 0 0 0 0 0 0 0"
bad "$no_rotation" "1e300 0 0 0 1 0 0 0 1 0 0 0"
bad "$no_rotation" "1 0 0 5 0 1 0 6 0 0 1 7" # row by row with the translation
bad "the matrix mirrors" "1 0 0 0 1 0 0 0 -1 0 0 0"
bad "the matrix mirrors" "0 1 0 1 0 0 0 0 1 0 0 0"
bad "the pose translates B" "0 -1 0 1 0 0 0 0 1 0 0 5368709.13"
bad "the pose translates B" "1 0 0 0 1 0 0 0 1 1e9 0 0"
bad "the pose translates B" "1 0 0 0 1 0 0 0 1 0 -1e300 0"

printf '# nothing\n' >none
refused "none: has no poses" collide post/ring.fbvh post/coarse.fbvh --poses none
: >empty
refused "empty: is empty" collide post/ring.fbvh post/coarse.fbvh --poses empty
refused "missing: can't be opened" collide post/ring.fbvh post/coarse.fbvh --poses missing

printf '%s\n' "$good" >poses
refused "bake both" collide post/ring.fbvh pre/coarse.fbvh --poses poses --pairs out
refused "bake both" collide wide/ring.fbvh post/coarse.fbvh --poses poses --pairs out
refused "cell of 0.01, but coarser/ring.fbvh one of 0.02" \
  collide coarser/ring.fbvh post/coarse.fbvh --poses poses --pairs out
for algorithm in ranked ranked-stack stackless-post; do
  refused "$algorithm can't walk; bake it with --layout post" \
    collide pre/ring.fbvh pre/coarse.fbvh --poses poses --algorithm $algorithm --pairs out
done
refused "stackless can't walk; bake it with --layout pre" \
  collide post/ring.fbvh post/coarse.fbvh --poses poses --algorithm stackless --pairs out
refused "--algorithm" collide post/ring.fbvh post/coarse.fbvh --poses poses --algorithm magic
refused "required" collide post/ring.fbvh post/coarse.fbvh
refused "required" collide post/ring.fbvh --poses poses

# The last cell that a pose may reach, and Windows line ends.
printf '%s\r\n' "1 0 0 0 1 0 0 0 1 5368709.12 0 0" "0 -1 0 1 0 0 0 0 1 0 0 -5368709.12" >poses
exits 0 collide post/ring.fbvh post/coarse.fbvh --poses poses --json
exits 0 export post/ring.fbvh -o far.obj --pose "$(tail -n 1 poses)"
