#!/bin/sh
# A browser shows the pages, light and dark, wide and narrow. Needs Debian's chromium, else the test is skipped.
. "$SOURCES/browser.sh"
python3 -B "$SOURCES/meshes.py" meshes
can_browse || { echo SKIPPED; exit 77; }
"$FLASHBVH" bake meshes/ring.stl meshes/tetrahedron.stl -o baked --format image >/dev/null

# Also the pages of a robot with long names and of its guard: the matrix scrolls in its card, and the names at its left
# leave space for it.
link() {
  printf '<link name="%s"><collision><geometry><box size="%s"/></geometry></collision></link>' "$@"
}
{
  echo '<robot name="gantry">'
  link a_link_with_a_rather_long_name "0.1 0.1 0.1"
  for i in 1 2 3 4 5; do
    link "another_link_whose_name_is_long_$i" "0.1 0.1 0.1"
    echo "<joint name=\"slide_$i\" type=\"prismatic\"><parent link=\"a_link_with_a_rather_long_name\"/>"
    echo "<child link=\"another_link_whose_name_is_long_$i\"/><origin xyz=\"0 $((10 * i - 9)) 0\"/><axis xyz=\"0 1 0\"/>"
    echo '<limit lower="-1" upper="1"/></joint>'
  done
  echo '</robot>'
} >gantry.urdf
printf 'slide_1,slide_2,slide_3,slide_4,slide_5\n0,0,0,0,0\n-1,0,0,0,0\n' >way.csv
"$FLASHBVH" robot gantry.urdf -o gantry --format image --stop 0.01 --report page.html >/dev/null
"$FLASHBVH" guard gantry/gantry.robot way.csv --report guard.html >/dev/null || [ $? -eq 1 ]
"$FLASHBVH" report baked/ring.fbvh baked/tetrahedron.fbvh -o meshes.html

# Scripts check the style's effects: the page is not wider than its window, tables scroll;
# canvases show meshes in more than one colour, if the program was built with them.
for page in page guard meshes; do
  with_script $page.html probe_$page.html <<'JS'
const all = (places, holds) => [...document.querySelectorAll(places)].every(holds);
const drawn = () => {
  if (!window.live) return true;
  const { canvas, view } = live, { gl } = view;
  view.draw(live.matrices(), live.colours(), live.colour("--ground"), live.marks());
  const pixels = new Uint8Array(4 * canvas.width * canvas.height);
  gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return new Set(new Uint32Array(pixels.buffer)).size > 4;
};
onload = () => setTimeout(() => {
  const matrix = document.querySelector('.matrix');
  const seen = {
    wide: document.documentElement.scrollWidth > innerWidth, drawn: drawn(),
    matrix: innerWidth > 400 || !matrix || (matrix.parentNode.scrollWidth > matrix.parentNode.clientWidth &&
      matrix.querySelector('tbody th').offsetWidth < matrix.parentNode.clientWidth / 2),
    live: all('#live *', part => part.getBoundingClientRect().right <= innerWidth),
    ground: getComputedStyle(document.body).backgroundColor };
  parent.postMessage(`${location.pathname.split('/').pop()} ${innerWidth} ${JSON.stringify(seen)}`, '*');
}, 500);
JS
done
# A window is at least 500 pixels wide; a frame may be narrower.
{
  echo '<script>onmessage = event => { document.body.append(Object.assign(document.createElement("p"), { textContent: event.data })); }</script>'
  for frame in page.400 guard.400 meshes.400 meshes.500 meshes.1400; do
    echo "<iframe src='probe_${frame%.*}.html' style='width:${frame#*.}px;height:900px;border:0'></iframe>"
  done
} >frames.html
for scheme in 1,246,247,249 0,13,17,23; do
  browse frames.html --blink-settings=preferredColorScheme="${scheme%%,*}" >dom || fail "$(cat browser_log)"
  ground=$(echo "${scheme#*,}" | sed 's/,/, /g')
  wanted='{"wide":false,"drawn":true,"matrix":true,"live":true,"ground":"rgb('$ground')"}'
  grep -o '<p>probe_[^<]*' dom >found || fail "no frame answers: $(tail -c 300 dom)"
  ! grep -vF "$wanted" found || fail "not $wanted"
  [ "$(wc -l <found)" -eq 5 ] || fail "frames are missing"
done
