#!/bin/sh
# The same input gives the same bytes, wherever it lies and whatever is baked beside it; a failed
# bake leaves older files as they were.
. "$SOURCES/common.sh"

mkdir -p elsewhere
cp meshes/ring.stl elsewhere/ring.stl
for options in "" "--layout pre" "--builder median" "--leaf-size 3 --arity 5" "--index-bits 32"; do
  # shellcheck disable=SC2086
  "$FLASHBVH" bake meshes/ring.stl -o one --cell 0.01 $options >table_one
  # shellcheck disable=SC2086
  TZ=Asia/Tokyo LC_ALL=C "$FLASHBVH" bake meshes/coarse.stl elsewhere/ring.stl -o two --cell 0.01 \
    $options >/dev/null
  for file in ring.fbvh ring.fbvh.hpp ring.fbvh.cpp; do
    cmp one/$file two/$file
  done
  awk 'length > 100 { exit 1 }' one/ring.fbvh.cpp one/ring.fbvh.hpp || fail "lines over 100"
done
if grep -nE "$PWD|elsewhere|20[0-9][0-9]-" two/ring.fbvh.hpp; then
  fail "a path or a date"
fi

# Without --cell, the finest that all fit; given back, it changes nothing.
"$FLASHBVH" bake meshes/tetrahedron.stl meshes/ring.stl -o one >table
cell=$(sed -n 's/^cell \([^;]*\);.*/\1/p' table)
"$FLASHBVH" bake meshes/tetrahedron.stl meshes/ring.stl -o two --cell "$cell" >/dev/null
cmp one/ring.fbvh two/ring.fbvh
cmp one/tetrahedron.fbvh two/tetrahedron.fbvh
cmp one/tetrahedron.fbvh.cpp two/tetrahedron.fbvh.cpp

cp one/ring.fbvh before
exits 2 bake meshes/ring.stl meshes/nan.stl -o one --cell 1
exits 2 bake meshes/ring.stl meshes/many_triangles.stl -o one --cell 0.5
cmp before one/ring.fbvh
[ -z "$(find one -name '*.tmp*')" ] || fail "temporary files left"

# Only what is asked for.
"$FLASHBVH" bake meshes/ring.stl -o image --format image >/dev/null
[ "$(ls image)" = ring.fbvh ] || fail "$(ls image)"
"$FLASHBVH" bake meshes/ring.stl -o cpp --format cpp >/dev/null
[ "$(ls cpp | tr '\n' ' ')" = "ring.fbvh.cpp ring.fbvh.hpp " ] || fail "$(ls cpp)"
