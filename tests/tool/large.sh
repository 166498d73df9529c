#!/bin/sh
# 66,000 triangles, with FLASHBVH_THOROUGH 200,000, bake and check; anything quadratic in their
# number would not end.
. "$SOURCES/common.sh"

mesh=meshes/many_triangles
count=66000
ulimit -t 30 # seconds of computing, a process
if thorough; then
  ulimit -t 90
  "$TOOLS/tool_test_meshes" large large
  mesh=large/large
  count=200000
fi
exits 0 bake $mesh.stl -o baked --index-bits 32 --format image
[ ! -s stderr ] || fail "$(cat stderr)"
exits 0 check baked/${mesh#*/}.fbvh --mesh $mesh.stl
grep -q "$count triangles, .* nodes, equal to" stdout || fail "$(cat stdout)"
refused "${mesh#*/}.stl: is too large for a cell of 1e-06: out of range are $count triangles (0, 1, 2, 3, 4 \
and $((count - 5)) more)" bake $mesh.stl -o out --cell 1e-6
