# Sourced: begins in the empty folder WORK; runs pages' queries in node, and drives pages in Debian's chromium.
set -eu
rm -rf "$WORK"
mkdir -p "$WORK"
cd "$WORK"

fail() {
  echo "FAILED: $*" >&2
  exit 1
}

# browse PAGE [OPTION...]: prints the page after its scripts have run.
browse() {
  shown=$1
  shift
  timeout 300 chromium --headless=new --no-sandbox --hide-scrollbars --use-gl=angle --use-angle=swiftshader \
    --enable-unsafe-swiftshader --disable-dev-shm-usage --user-data-dir="$WORK/profile" --window-size=1000,900 \
    --virtual-time-budget=20000 "$@" --dump-dom "file://$PWD/$shown" 2>browser_log
}

# can_browse: succeeds, or prints why not.
can_browse() {
  command -v chromium >/dev/null || { echo "no chromium; apt-get install chromium"; return 1; }
  echo '<p>hello' >hello.html
  browse hello.html | grep -q '<p>hello' || { echo "chromium does not start here"; return 1; }
}

# with_script PAGE OUTPUT: copies the page and appends a script from standard input.
with_script() {
  sed '$d' "$1" | sed '$d' >"$2"
  { echo '<script>'; cat; echo '</script></body></html>'; } >>"$2"
}

# drive PAGE CLAIMS SCRIPT...: each line that the scripts add is a claim, which must be `true`.
drive() {
  driven=$1
  count=$2
  shift 2
  (cd "$SOURCES" && cat draws.js claims.js "$@") | with_script "$driven" driven.html
  browse driven.html >dom || fail "$(cat browser_log)"
  grep -o '<p>claim [^<]*' dom | sed 's/<p>claim //' >claims || fail "the page's script did not run: $(tail -c 300 dom)"
  cat claims
  ! grep -v ': true$' claims | grep -v '^answers ' || fail "$driven is not as it should be"
  [ "$(wc -l <claims)" -eq "$count" ] || fail "claims are missing"
}

# need_answers PAGE: skips the test if the page cannot answer, or node is missing.
need_answers() {
  grep -q 'id=live-data' "$1" || { echo "SKIPPED: built without Clang for WebAssembly"; exit 77; }
  command -v node >/dev/null || { echo "SKIPPED: no node; apt-get install nodejs"; exit 77; }
}

# same_in_node PAGE SCRIPT COUNT WANTED
same_in_node() {
  echo "$4"
  found=$(node_answers "$1" "$2" "$3")
  [ "$found" = "$4" ] || fail "node has $found"
}

# node_answers PAGE SCRIPT COUNT: the script's `answers_of`, run with the page's library and images.
node_answers() {
  {
    (cd "$SOURCES" && cat draws.js "$2")
    cat <<'JS'
import { readFileSync } from "node:fs";
const [page, count] = process.argv.slice(2);
const data = JSON.parse(/id=live-data>(.*?)<\/script>/.exec(readFileSync(page, "utf8"))[1]);
const compiled = await WebAssembly.compile(Buffer.from(data.library, "base64"));
if (WebAssembly.Module.imports(compiled).length !== 0) throw new Error("the library imports something");
const library = (await WebAssembly.instantiate(compiled)).exports;
(data.meshes || [data]).forEach(({ image }, i) => {
  const bytes = Buffer.from(image, "base64");
  const place = library.room(bytes.length);
  new Uint8Array(library.memory.buffer).set(bytes, place);
  if ((data.meshes ? library.open(i, bytes.length) : library.open(bytes.length)) !== 0) throw new Error("an image is refused");
});
console.log(answers_of(library, +count));
JS
  } >answers.mjs
  node answers.mjs "$1" "$3"
}
