#!/bin/sh
# A page of two meshes answers like the firmware's queries: in node, and in a browser, which also drives it. Skips
# as live.sh does.
. "$SOURCES/browser.sh"

python3 -B "$SOURCES/meshes.py" meshes
printf 'v 0 0 0\nv 5 0 0\nv 0 5 0\nv 0 0 5\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n' >small.obj
"$FLASHBVH" bake meshes/ring.stl small.obj -o . --format image --unit mm >/dev/null
python3 -c 'for i in range(105): print(f"0.6 -0.8 0  0.8 0.6 0  0 0 1  {i % 9 * 3 - 4}.25 {i % 7 * 4} 0.{i}")' >poses
"$FLASHBVH" report ring.fbvh small.fbvh --poses poses -o page.html
need_answers page.html
"$TOOLS/cli_live_pair_answers" ring.fbvh small.fbvh >known.js || fail "not all answers occur"
try_in_node page.html pair_answers.js
printf 'v 0 0 0\nv 5 0 0\nv 0 5 0\nf 1 3 2\n' >open.obj
"$FLASHBVH" bake meshes/ring.stl open.obj -o . --format image --unit mm >/dev/null 2>&1
"$FLASHBVH" report ring.fbvh open.fbvh --poses poses -o open.html
try_in_node open.html open_answers.js

can_browse || { echo "passed in node; not run: the pages and their answers in a browser"; exit 0; }
drive page.html 27 pair_answers.js drive_pair.js
