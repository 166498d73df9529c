#!/bin/sh
# A browser shows the page, light and dark, wide and narrow. Needs Debian's chromium; without it the
# test counts as skipped.
set -eu
rm -rf "$WORK"
mkdir -p "$WORK"
cd "$WORK"
python3 -B "$SOURCES/meshes.py" meshes

fail() {
  echo "FAILED: $*" >&2
  exit 1
}

skip() {
  echo "SKIPPED: $*"
  exit 77
}

browse() {
  timeout 60 chromium --headless --no-sandbox --disable-gpu --hide-scrollbars \
    --disable-dev-shm-usage --user-data-dir="$WORK/profile" "$@" 2>browser_log
}

command -v chromium >/dev/null || skip "no chromium; apt-get install chromium"
echo '<p>hello' >hello.html
browse --dump-dom "file://$PWD/hello.html" | grep -q '<p>hello' || skip "chromium does not start here"

"$FLASHBVH" bake meshes/ring.stl meshes/tetrahedron.stl -o baked --format image >/dev/null
"$FLASHBVH" report baked/ring.fbvh baked/tetrahedron.fbvh -o page.html --samples 40

# Scripts see what the style does: pictures are drawn; the page is not wider than its window, and no bar
# is hidden.
sed '$d' page.html | sed '$d' >probe.html
cat >>probe.html <<'HTML'
<script>
const bars = [...document.querySelectorAll('.row, .bar, .gauge')];
const seen = bars.map(bar => bar.getBoundingClientRect())
  .filter(at => at.width > 1 && at.height > 8 && at.right <= innerWidth).length;
const wide = document.documentElement.scrollWidth - innerWidth;
const colours = getComputedStyle(document.body).backgroundColor;
const drawn = faces => {
  const at = faces.getBoundingClientRect(), frame = faces.parentNode.getBoundingClientRect();
  return at.width > frame.width / 3 && at.width <= frame.width && at.height <= frame.height &&
    [...faces.children].every(path => getComputedStyle(path).fill.startsWith('rgb('));
};
onload = () => {
  const pictures = [...document.querySelectorAll('.faces')].filter(drawn).length;
  document.body.innerHTML = `<p>${wide} ${colours} ${pictures} ${bars.length - seen}</p>`;
};
</script></body></html>
HTML
for window in 500,900 1400,900; do
  for scheme in 1,246,247,249 0,13,17,23; do
    colour=$(echo "${scheme#*,}" | sed 's/,/, /g')
    browse --blink-settings=preferredColorScheme="${scheme%%,*}" --window-size=$window \
      --virtual-time-budget=5000 --dump-dom "file://$PWD/probe.html" >dom || fail "$(cat browser_log)"
    wanted="<p>0 rgb($colour) 4 0</p>"
    grep -qF "$wanted" dom || fail "not $wanted but $(grep -o '<p>.*' dom | head -c 300)"
  done
done

# The pages of a robot with long names and of its guard, too: the matrix scrolls in its card, and the names
# at its left leave place for it.
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
# A window is no narrower than 500 pixels, a frame is.
cat >frame.html <<'HTML'
<script>onmessage = told => { document.body.innerHTML = `<p>${told.data}</p>`; }</script>
<iframe src="probe.html" style="width:400px;height:900px;border:0"></iframe>
HTML
for page in page guard; do
  sed '$d' $page.html | sed '$d' >probe.html
  cat >>probe.html <<'HTML'
<script>
const matrix = document.querySelector('.pairs');
const fits = !matrix || (matrix.parentNode.scrollWidth > matrix.parentNode.clientWidth &&
  matrix.querySelector('tbody th').offsetWidth < matrix.parentNode.clientWidth / 2);
parent.postMessage(`${document.documentElement.scrollWidth - innerWidth} ${innerWidth} ${fits}`, '*');
</script></body></html>
HTML
  browse --virtual-time-budget=5000 --dump-dom "file://$PWD/frame.html" >dom || fail "$(cat browser_log)"
  grep -qF '<p>0 400 true</p>' dom || fail "$page is too wide: $(grep -o '<p>.*' dom | head -c 300)"
done
