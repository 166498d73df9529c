#!/bin/sh
# picture.sh    lib/docs/arm.png, the README's picture: where two links of a KUKA KR5 collide, as `flashbvh
#               robot --report` shows it. Installs what is missing.
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
# The last collision's robot; its two links follow.
grep -o 'data:image/png;base64,[^"]*' $work/arm.html | tail -n 2 | head -n 1 | sed 's/.*,//' |
  base64 -d >lib/docs/arm.png
echo "lib/docs/arm.png: $(wc -c <lib/docs/arm.png) bytes"
