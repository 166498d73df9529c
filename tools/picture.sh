#!/bin/sh
# picture.sh    lib/docs/arm.png, the README's picture: the page of a KUKA KR5 where two of its links collide.
#               Installs what is missing.
set -eu
cd "$(dirname "$0")/.."
. tools/packages.sh
. tools/kr5.sh
ensure_packages $host_packages $live_packages chromium
native=${FLASHBVH_NATIVE:-native}
work=build/picture
mkdir -p $work
fetch_kr5 build/kr5
{ cmake --preset "$native" && cmake --build --preset "$native" --target flashbvh_tool; } >$work/log
"build/$native/bin/flashbvh" robot "$urdf" --name arm --stop 0.005 --warn 0.03 -o $work --report $work/arm.html >>$work/log
# Shows only the robot, at the last collision of the matrix.
{
  sed '$d' $work/arm.html | sed '$d'
  cat <<'HTML'
<script>addEventListener("load", () => setTimeout(() => {
  document.querySelectorAll("header, footer, section:not(#live)").forEach(part => { part.hidden = true; });
  [...document.querySelectorAll(".is-can[data-values]")].pop().click();
  live.view.turn = { yaw: 2.4, pitch: 0.3 };
  live.view.distance = 1;
}, 1000))</script></body></html>
HTML
} >$work/shown.html
chromium --headless=new --no-sandbox --hide-scrollbars --use-gl=angle --use-angle=swiftshader \
  --enable-unsafe-swiftshader --user-data-dir=$work/profile --window-size=1240,735 --virtual-time-budget=5000 \
  --screenshot=lib/docs/arm.png "file://$PWD/$work/shown.html" 2>>$work/log
echo "lib/docs/arm.png: $(wc -c <lib/docs/arm.png) bytes"
