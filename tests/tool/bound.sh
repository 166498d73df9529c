#!/bin/sh
# No pose makes a query visit more, or take more work, than `collide --bound` says; where all boxes
# overlap, `ranked` visits exactly that, for all pairs of sizes 1 to 8, and some of trees baked
# otherwise, with FLASHBVH_THOROUGH more. And what it says that poses needed.
. "$SOURCES/common.sh"

echo "1 0 0 0 1 0 0 0 1  0 0 0" >here
# field NAME <JSON
field() {
  sed "s/.*\"$1\":\([0-9]*\).*/\1/"
}

# Triangles that all contain the origin, each rotated about it.
for size in 1 2 3 4 5 6 7 8; do
  awk -v size=$size 'BEGIN {
    for (i = 0; i < size; ++i) {
      s = sin(i); c = cos(i)
      printf "v %f %f %f\nv %f %f %f\nv %f %f %f\n", 9 * c, 9 * s, i, -9 * s, 9 * c, -i,
        -9 * c + 9 * s, -9 * s - 9 * c, 0
      printf "f %d %d %d\n", 3 * i + 1, 3 * i + 2, 3 * i + 3
    }
  }' >"star$size.obj"
done
for options in "" "--leaf-size 1" "--arity 2" "--builder median --arity 8" "--leaf-size 3" "--index-bits 32"; do
  # shellcheck disable=SC2086
  "$FLASHBVH" bake star?.obj -o baked --cell 0.01 $options >/dev/null 2>&1
  sizes="5 8"
  ! thorough || sizes="1 2 5 8"
  [ -n "$options" ] || sizes="1 2 3 4 5 6 7 8"
  for a in $sizes; do
    for b in $sizes; do
      set -- "baked/star$a.fbvh" "baked/star$b.fbvh" --json
      "$FLASHBVH" collide "$@" --bound --poses here >bound
      "$FLASHBVH" collide "$@" --poses here >found
      [ "$(field most_visits <bound)" -eq "$(field visits <found)" ] &&
        [ "$(field most_leaf_pairs <bound)" -eq "$(field leaf_pairs <found)" ] &&
        [ "$(field most_triangle_pairs <bound)" -eq $((a * b)) ] &&
        [ "$(field poses_most_work <bound)" -le "$(field most_work <bound)" ] &&
        [ "$(field poses_most_work <bound)" -ge $(($(field visits <found) + 32 * a * b)) ] ||
        fail "$options: $a and $b: $(cat bound found)"
    done
  done
done

# kept IMAGES ALGORITHM...
kept() {
  images=$1
  shift
  for algorithm; do
    set -- "$images/ring.fbvh" "$images/coarse.fbvh" --json --algorithm "$algorithm"
    most=$("$FLASHBVH" collide "$@" --bound | field most_visits)
    "$FLASHBVH" collide "$@" --poses poses | field visits >visits
    "$FLASHBVH" collide "$@" --poses poses --bound >bound
    mean=$(field poses_mean_work <bound)
    [ "$mean" -gt 0 ] && [ "$mean" -le "$(field poses_99_percent_work <bound)" ] &&
      [ "$(field poses_99_percent_work <bound)" -le "$(field poses_most_work <bound)" ] &&
      [ "$(field poses_most_work <bound)" -le "$(field most_work <bound)" ] &&
      [ "$(field poses <bound)" -eq 40 ] || fail "$algorithm: $(cat bound)"
    awk -v most="$most" '$1 > most { exit 1 } END { exit NR < 40 }' visits ||
      fail "$algorithm: more than $most: $(cat visits)"
  done
}
python3 "$SOURCES/poses.py" 40 5 20 >poses
"$FLASHBVH" bake meshes/ring.stl meshes/coarse.stl -o post --cell 0.01 >/dev/null
"$FLASHBVH" bake meshes/ring.stl meshes/coarse.stl -o pre --layout pre --cell 0.01 >/dev/null
kept post ranked ranked-stack volume-stack alternating-stack stackless-post leaf
kept pre stackless volume-stack alternating-stack leaf

"$FLASHBVH" collide post/ring.fbvh post/coarse.fbvh --bound >text
[ "$(wc -l <text)" -eq 3 ] &&
  grep -q '^any pose: at most [0-9]* work: [0-9]* visits, of which [0-9]* pairs of leaves' text ||
  fail "$(cat text)"
"$FLASHBVH" collide post/ring.fbvh post/coarse.fbvh --bound --poses poses >text
[ "$(wc -l <text)" -eq 4 ] &&
  grep -q '^40 poses: at most [0-9]* work, 99 % of them at most [0-9]*, the mean [0-9]*$' text ||
  fail "$(cat text)"
# Of 99 poses that are apart and 1 that is not, 99 need a visit's work.
awk 'BEGIN { for (i = 0; i < 99; ++i) print "1 0 0 0 1 0 0 0 1  100 0 0" }' | cat - here >hundred
"$FLASHBVH" collide baked/star8.fbvh baked/star8.fbvh --bound --poses hundred --json >bound
[ "$(field poses_99_percent_work <bound)" -eq 1 ] && [ "$(field poses_most_work <bound)" -gt 64 ] ||
  fail "$(cat bound)"
refused "--poses or --bound" collide post/ring.fbvh post/coarse.fbvh
for option in "--first" "--pairs found"; do
  # shellcheck disable=SC2086
  refused "excludes" collide post/ring.fbvh post/coarse.fbvh --bound $option
done
