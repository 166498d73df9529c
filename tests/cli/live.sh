#!/bin/sh
# A robot's page answers as the npm package does, which answers as C++ (tests/one_hash): in node, and in a browser, which
# also drives it. Without Clang for WebAssembly or node the test counts as skipped; without chromium its part is left out.
set -eu
rm -rf "$WORK"
mkdir -p "$WORK"
cd "$WORK"

fail() {
  echo "FAILED: $*" >&2
  exit 1
}

"$FLASHBVH" robot "$ARM" -o . --format image --stop 0.01 --warn 0.05 --report page.html >/dev/null
grep -q 'id=live-data' page.html || { echo "SKIPPED: built without Clang for WebAssembly"; exit 77; }
command -v node >/dev/null || { echo "SKIPPED: no node; apt-get install nodejs"; exit 77; }
[ "$(wc -c <page.html)" -lt 1000000 ] || fail "the page takes 1 MB"

mkdir inputs
"$INPUTS" 0 10000 inputs >/dev/null
cat "$SOURCES/answers.js" - >answers.mjs <<'JS'
import { readFileSync, writeFileSync } from "node:fs";
const [, , folder, image] = process.argv;
const { Guard, Robot } = await import(`${folder}/index.js`);
const robot = new Robot(readFileSync(image)), guard = new Guard(robot);
const values = robot.values(new Float32Array(new Uint8Array(readFileSync("inputs/values")).buffer));
const rows = Array.from({ length: values.length / robot.jointNames.length }, (_, row) =>
  values.subarray(row * robot.jointNames.length, (row + 1) * robot.jointNames.length));
console.log(hashed(rows.map(row => {
  const { verdicts, pairs, distances } = guard.prime(row);
  return [verdicts[0], pairs[0], distances[0]];
})));
writeFileSync("values.js", `const driven_values = [${values}];\n`);

const data = JSON.parse(/id=live-data>(.*?)<\/script>/.exec(readFileSync("page.html", "utf8"))[1]);
const compiled = await WebAssembly.compile(Buffer.from(data.library, "base64"));
if (WebAssembly.Module.imports(compiled).length !== 0) throw new Error("the library imports something");
const arm = (await WebAssembly.instantiate(compiled)).exports;
const page_image = Buffer.from(data.image, "base64");
const place = arm.room(page_image.length);
new Uint8Array(arm.memory.buffer).set(page_image, place);
if (arm.open(page_image.length) !== 0) throw new Error("the image is refused");
console.log(answers_of(arm, values));
JS
node answers.mjs "$NPM_LIBRARY" ./*.robot >found
cat found
wanted=$(head -n 1 found)
[ "$(sort -u found)" = "$wanted" ] || fail "the page's library has other answers"
case $wanted in *" 0 free"* | *" 0 warn"* | *" 0 stop"*) fail "not all verdicts occur" ;; esac

browse() {
  timeout 300 chromium --headless=new --no-sandbox --hide-scrollbars --use-gl=angle --use-angle=swiftshader \
    --enable-unsafe-swiftshader --disable-dev-shm-usage --user-data-dir="$WORK/profile" --window-size=1000,900 \
    --virtual-time-budget=20000 --dump-dom "file://$PWD/$1" 2>browser_log
}
command -v chromium >/dev/null || { echo "no chromium: its part is left out; apt-get install chromium"; exit 0; }
echo '<p>hello' >hello.html
browse hello.html | grep -q '<p>hello' || { echo "chromium does not start here: its part is left out"; exit 0; }

# drive PAGE CLAIMS: each line that the script adds is a claim; `true` is what is wanted of it.
drive() {
  sed '$d' "$1" | sed '$d' >driven.html
  {
    echo '<script>'
    cat values.js "$SOURCES/answers.js" "$SOURCES/drive.js"
    echo '</script></body></html>'
  } >>driven.html
  browse driven.html >dom || fail "$(cat browser_log)"
  grep -o '<p>claim [^<]*' dom | sed 's/<p>claim //' >claims || fail "the page's script did not run: $(tail -c 300 dom)"
  cat claims
  ! grep -v ': true$' claims | grep -v '^answers ' || fail "$1 is not as it should be"
  [ "$(wc -l <claims)" -eq "$2" ] || fail "claims are missing"
}
drive page.html 10
grep -qF "answers $wanted" claims || fail "the browser has other answers"

# To where two links collide, straight from where they do not.
python3 -B - page.html >way.csv <<'PYTHON'
import re, sys
page = open(sys.argv[1]).read()
end = [float(value) for value in re.search('data-values="(.*?)"', page)[1].split()]
print(",".join(re.findall('<th scope=row>([^<]*)</th><td>[^<]*</td><td>(?:revolute|prismatic|continuous)', page)))
for i in range(101):
    print(",".join(str(i / 100 * value) for value in end))
PYTHON
"$FLASHBVH" guard ./*.robot way.csv --report guard.html >/dev/null 2>&1 || [ $? -eq 1 ]
drive guard.html 6
