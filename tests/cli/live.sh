#!/bin/sh
# A robot's page answers like the native guard: in node, and in a browser, which also drives it. Without Clang for
# WebAssembly or node the test is skipped; without chromium, only the browser's part is.
. "$SOURCES/browser.sh"

"$FLASHBVH" robot "$ARM" -o . --format image --stop 0.01 --warn 0.05 --report page.html >/dev/null
need_answers page.html
[ "$(wc -c <page.html)" -lt 1000000 ] || fail "the page takes 1 MB"
"$TOOLS/cli_live_answers" ./*.robot >known.js || fail "not all verdicts occur"
try_in_node page.html answers.js

can_browse || { echo "passed in node; not run: the page and its answers in a browser"; exit 0; }

drive page.html 11 answers.js drive.js

# A trajectory to a collision of two links, straight from values without one.
python3 -B - page.html >way.csv <<'PYTHON'
import json, re, sys
page = json.loads(re.search("id=page-data>(.*?)</script>", open(sys.argv[1]).read())[1])["facts"][0]
witness = next(pair["witness"] for pair in page["pairs"] if pair["witness"])
end = list(witness.values())
print(",".join(witness))
for i in range(101):
    print(",".join(str(i / 100 * value) for value in end))
PYTHON
"$FLASHBVH" guard ./*.robot way.csv --report guard.html >/dev/null 2>&1 || [ $? -eq 1 ]
drive guard.html 6 drive.js
