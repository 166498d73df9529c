#!/bin/sh
# An image is refused if any byte of it is missing, added or changed, and if it is well checksummed
# nonsense. Of the bytes every seventh, with FLASHBVH_THOROUGH each; damage_test has each of them and
# more for what opens images.
. "$SOURCES/common.sh"

"$FLASHBVH" bake meshes/tetrahedron.stl -o images --format image >/dev/null
image=images/tetrahedron.fbvh
size=$(wc -c <$image)
exits 0 check $image

step=7
! thorough || step=1
for length in $(seq 1 $step $((size - 1))) $((size - 1)); do
  head -c "$length" $image >cut.fbvh
  refused "cut.fbvh: is" check cut.fbvh
done
refused "truncated" info cut.fbvh
cat $image $image >twice.fbvh
refused "twice.fbvh" check twice.fbvh

for offset in $(seq 0 $step $((size - 1))) $((size - 1)); do
  "$TOOLS/tool_test_damage" $image flip "$offset" flipped.fbvh
  refused "flipped.fbvh: " check flipped.fbvh
done
printf '1 0 0 0 1 0 0 0 1 0 0 0\n' >poses
refused "flipped.fbvh: is corrupt" info flipped.fbvh
refused "flipped.fbvh: is corrupt" export flipped.fbvh -o out.obj
refused "flipped.fbvh: is corrupt" collide flipped.fbvh $image --poses poses --pairs out
refused "flipped.fbvh: is corrupt" collide $image flipped.fbvh --poses poses --pairs out

# With a matching checksum it is the contents that count: the root's link.
"$TOOLS/tool_test_damage" $image set 0x58 0x00010001 nonsense.fbvh
refused "nonsense.fbvh: is invalid" check nonsense.fbvh
# Version 9.
"$TOOLS/tool_test_damage" $image set 4 0x10010009 later.fbvh
refused "later.fbvh: is written in version 9" check later.fbvh
# What the library leaves to `check`: of which shell a vertex is. The last words of the image are
# the vertices (four of six bytes), the shell's first vertex with two zeros, and the name.
"$FLASHBVH" bake meshes/tetrahedron.stl -o images --name t --format image >/dev/null
"$TOOLS/tool_test_damage" images/t.fbvh set $(($(wc -c <images/t.fbvh) - 8)) 2 shell.fbvh
exits 0 info shell.fbvh
refused "shell.fbvh: is invalid: its vertices of shells are not those that its triangles make; bake it again" \
  check shell.fbvh
