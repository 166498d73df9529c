#!/bin/sh
# 200,000 triangles bake, check and export; anything quadratic in their number would not end.
. "$SOURCES/common.sh"

"$TOOLS/tool_test_meshes" large large
exits 0 bake large/large.stl -o baked --index-bits 32 --format image
[ ! -s stderr ] || fail "$(cat stderr)"
exits 0 check baked/large.fbvh --mesh large/large.stl
grep -q '200000 triangles, .* nodes, equal to' stdout || fail "$(cat stdout)"
refused "large.stl: is too large for a cell of 1e-06: out of range are 200000 triangles (0, 1, 2, 3, 4 \
and 199995 more)" bake large/large.stl -o out --cell 1e-6
