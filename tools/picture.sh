#!/bin/sh
# picture.sh    lib/docs/arm.svg, the README's picture: where two links of a KUKA KR5 collide, as `flashbvh
#               robot --report` draws it. Installs what is missing.
set -eu
cd "$(dirname "$0")/.."
. tools/packages.sh
. tools/kr5.sh
ensure_packages $host_packages
native=${FLASHBVH_NATIVE:-native}
work=build/picture
mkdir -p $work
fetch_kr5 build/kr5
{ cmake --preset "$native" && cmake --build --preset "$native" --target flashbvh_tool; } >$work/log
"build/$native/bin/flashbvh" robot "$urdf" --name arm -o $work --report $work/arm.html >>$work/log
# The last collision's robot, which lies across the middle of the drawing; its two links follow.
{
  echo '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 235 1000 530">'
  echo '<style>path{stroke-width:1px;stroke-linejoin:round;vector-effect:non-scaling-stroke}'
  grep '^\.faces \.f' $work/arm.html
  echo '</style>'
  grep '^<g class="faces">' $work/arm.html | tail -n 2 | head -n 1
  echo '</svg>'
} >lib/docs/arm.svg
echo "lib/docs/arm.svg: $(wc -c <lib/docs/arm.svg) bytes"
