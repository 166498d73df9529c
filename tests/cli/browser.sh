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

# drive PAGE CLAIMS SCRIPT...: each line that the scripts add is a claim, which must be `true`. The scripts may use those
# of known.js.
drive() {
  driven=$1
  count=$2
  shift 2
  (cat known.js && cd "$SOURCES" && cat claims.js "$@") | with_script "$driven" driven.html
  browse driven.html >dom || fail "$(cat browser_log)"
  grep -o '<p>claim [^<]*' dom | sed 's/<p>claim //' >claims || fail "the page's script did not run: $(tail -c 300 dom)"
  cat claims
  ! grep -v ': true$' claims || fail "$driven is not as it should be"
  [ "$(wc -l <claims)" -eq "$count" ] || fail "claims are missing"
}

# need_answers PAGE: skips the test if the page cannot answer, or node is missing.
need_answers() {
  grep -q 'id=live-data' "$1" || { echo "SKIPPED: built without Clang for WebAssembly"; exit 77; }
  command -v node >/dev/null || { echo "SKIPPED: no node; apt-get install nodejs"; exit 77; }
}

# try_in_node PAGE SCRIPT: the script's `wrong_answer` finds none in the page's library with its images.
try_in_node() {
  {
    cat known.js "$SOURCES/$2"
    cat <<'JS'
import { readFileSync } from "node:fs";
const data = JSON.parse(/id=live-data>(.*?)<\/script>/.exec(readFileSync(process.argv[2], "utf8"))[1]);
const compiled = await WebAssembly.compile(Buffer.from(data.library, "base64"));
if (WebAssembly.Module.imports(compiled).length !== 0) throw new Error("the library imports something");
const library = (await WebAssembly.instantiate(compiled)).exports;
(data.meshes || [data]).forEach(({ image }, i) => {
  const bytes = Buffer.from(image, "base64");
  const place = library.room(bytes.length);
  new Uint8Array(library.memory.buffer).set(bytes, place);
  if ((data.meshes ? library.open(i, bytes.length) : library.open(bytes.length)) !== 0) throw new Error("an image is refused");
});
const wrong = wrong_answer(library);
if (wrong) throw new Error(`node has other answers than ${JSON.stringify(wrong)}`);
JS
  } >answers.mjs
  node answers.mjs "$1"
}
