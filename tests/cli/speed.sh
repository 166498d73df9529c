#!/bin/sh
# speed.sh: times the first picture of pages, and their frames per second while all moves, each frame with its queries.
# In headless Chromium on one core without a GPU: a KUKA KR5's robot page and the page of two of its links. Prints both
# numbers of each, for a running browser and a newly started one, and the idle share of the core. FLASHBVH is the
# program, by default that of build/native.
set -eu
cd "$(dirname "$0")/../.."
. tools/packages.sh
. tools/kr5.sh
FLASHBVH=${FLASHBVH:-$PWD/build/native/bin/flashbvh}
SOURCES=$PWD/tests/cli
WORK=$PWD/build/speed
fetch_kr5 build/kr5
kr5=$PWD/$kr5 urdf=$PWD/$urdf
. "$SOURCES/browser.sh"

"$FLASHBVH" robot "$urdf" -o . --format image --stop 0.005 --warn 0.03 --report robot.html >/dev/null 2>&1
"$FLASHBVH" bake "$kr5/forearm.STL" "$kr5/palm.STL" -o . --format image --unit m >/dev/null 2>&1
"$FLASHBVH" report forearm.fbvh palm.fbvh -o pair.html
for page in robot pair; do
  with_script $page.html timed.html <<'JS'
const frame = () => new Promise(requestAnimationFrame);
const finish = () => live.view.gl.readPixels(0, 0, 1, 1, live.view.gl.RGBA, live.view.gl.UNSIGNED_BYTE, new Uint8Array(4));
(async () => {
  while (!window.live || !live.view || live.drawing !== 0) await frame();
  finish();
  const first = performance.now();
  if (!window.name) {
    window.name = first.toFixed(0);
    location.reload();
    return;
  }
  const size = live.meshes && live.cell * live.meshes.all[live.b].size;
  for (let i = 0; i < 120; ++i) {
    if (live.arm) live.set(i % 6, live.arm.values[i % 6] + 0.02 * Math.sin(i / 20));
    else live.set(live.pose.map((part, k) => (k < 9 ? part : part + size * Math.sin(i / 20 + k) / 40)));
    live.turn(0.03, 0);
    await frame();
  }
  finish();
  const seconds = (performance.now() - first) / 1000;
  console.log(`speed: first picture after ${first.toFixed(0)} ms (started ${window.name} ms), ${(120 / seconds).toFixed(0)} frames a second`);
})();
JS
  taskset -c 0 chromium --headless=new --no-sandbox --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader \
    --disable-dev-shm-usage --user-data-dir="$WORK/profile" --window-size=1400,900 --enable-logging=stderr \
    "file://$PWD/timed.html" >/dev/null 2>log &
  browser=$!
  for _ in $(seq 120); do
    grep -q 'speed: ' log && break
    sleep 0.5
  done
  { kill $browser && wait $browser; } 2>/dev/null || true
  free=$(taskset -c 0 python3 -c 'import time
begin = time.perf_counter()
while time.perf_counter() < begin + 1: pass
print(f"{100 * time.process_time():.0f}")')
  echo "$page page, $(wc -c <$page.html) bytes: $(grep -o 'speed: [^"]*' log | sed 's/speed: //' || echo 'no answer within a minute'); ${free} % of the core free"
done
