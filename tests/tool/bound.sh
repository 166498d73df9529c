#!/bin/sh
# No pose makes a query visit more than `collide --bound` says; where all boxes overlap, `ranked`
# visits exactly that, for all pairs of sizes 1 to 8, and some of trees baked otherwise.
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
for options in "" "--arity 2" "--builder median --arity 8" "--leaf-size 3" "--index-bits 32"; do
  # shellcheck disable=SC2086
  "$FLASHBVH" bake star?.obj -o baked --cell 0.01 $options >/dev/null 2>&1
  sizes="1 2 5 8"
  [ -n "$options" ] || sizes="1 2 3 4 5 6 7 8"
  for a in $sizes; do
    for b in $sizes; do
      set -- "baked/star$a.fbvh" "baked/star$b.fbvh" --json
      "$FLASHBVH" collide "$@" --bound >bound
      "$FLASHBVH" collide "$@" --poses here >found
      [ "$(field most_visits <bound)" -eq "$(field visits <found)" ] &&
        [ "$(field most_leaf_pairs <bound)" -eq "$(field leaf_pairs <found)" ] &&
        [ "$(field most_triangle_pairs <bound)" -eq $((a * b)) ] ||
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
    awk -v most="$most" '$1 > most { exit 1 } END { exit NR < 40 }' visits ||
      fail "$algorithm: more than $most: $(cat visits)"
  done
}
awk -v count=40 -v seed=5 -v reach=20 -f "$SOURCES/poses.awk" >poses
"$FLASHBVH" bake meshes/ring.stl meshes/coarse.stl -o post --cell 0.01 >/dev/null
"$FLASHBVH" bake meshes/ring.stl meshes/coarse.stl -o pre --layout pre --cell 0.01 >/dev/null
kept post ranked ranked-stack volume-stack alternating-stack stackless-post leaf
kept pre stackless volume-stack alternating-stack leaf

"$FLASHBVH" collide post/ring.fbvh post/coarse.fbvh --bound >text
[ "$(wc -l <text)" -eq 3 ] && grep -q '^at most [0-9]* visits, of which [0-9]* pairs of leaves' text ||
  fail "$(cat text)"
refused "--poses or --bound" collide post/ring.fbvh post/coarse.fbvh
for option in "--poses poses" "--first" "--pairs found"; do
  # shellcheck disable=SC2086
  refused "excludes" collide post/ring.fbvh post/coarse.fbvh --bound $option
done
