#!/bin/sh
# `flashbvh bench`: its tables, its JSON, its figure, and what it refuses.
set -eu
rm -rf "$WORK"
mkdir -p "$WORK"
cd "$WORK"

fail() {
  echo "bench.sh: $*" >&2
  exit 1
}

quick="--repetitions-scale 0.0001 --rounds 2"

# shellcheck disable=SC2086
"$FLASHBVH" bench --table 3 --table 7 $quick >out.md 2>progress
grep -q '^### Table 3: Separation$' out.md || fail "table 3 is missing"
grep -q '^### Table 7' out.md || fail "table 7 is missing"
grep -q '^### Table 2' out.md && fail "table 2 was not asked for"
for row in volume-stack alternating-stack stackless stackless-post leaf ranked ranked-stack \
    "best rule"; do
  [ "$(grep -c "^| $row  *|" out.md)" = 4 ] || fail "not four rows of $row"
done
grep -q '^### The default tree$' out.md || fail "the default tree is missing"
grep -q '^| total of the intersecting  *| *0 |' out.md || fail "tables 3 and 7 don't intersect"
[ "$(grep -c '^table' progress)" = 4 ] || fail "progress: $(cat progress)"

# shellcheck disable=SC2086
"$FLASHBVH" bench --table 7 $quick --builder median --json 2>/dev/null >out.json
[ "$(grep -c '"algorithm":' out.json)" = 8 ] || fail "not eight JSON lines"
grep '"algorithm":"ranked",' out.json | grep -q '"triangle_pairs":0' || fail "no ranked line"
grep '"setup":"Different sizes"' out.json | grep '"default_tree":' | grep -q '"ranked_visits":' ||
  fail "no default tree"
grep '"default_tree_totals":' out.json | grep -q '"ranked_to_best":' || fail "no default tree's totals"
tail -n 1 out.json | grep -q '"ranked_to_volume":' || fail "no summary"

# bench_test has the figure of made-up results.
if [ -n "${FLASHBVH_THOROUGH:-}" ]; then
  # shellcheck disable=SC2086
  "$FLASHBVH" bench --table 6 $quick --svg figure.svg >/dev/null 2>&1
  grep -q '</svg>' figure.svg || fail "no figure"
  for name in ranked leaf volume-stack Iterations Time 203776; do
    grep -q ">$name</text>" figure.svg || fail "the figure lacks $name"
  done
fi

refused() {
  wanted=$1
  shift
  status=0
  "$FLASHBVH" bench "$@" >/dev/null 2>message || status=$?
  [ "$status" = 2 ] || fail "exit $status from: bench $*"
  [ "$(wc -l <message)" = 1 ] || fail "not one line: $(cat message)"
  grep -q -e "$wanted" message || fail "no '$wanted' in: $(cat message)"
}
refused "--table" --table 1
refused "--table" --table 9
refused "--rounds" --table 3 --rounds 0
refused "--repetitions-scale" --table 3 --repetitions-scale 0
refused "--repetitions-scale" --table 3 --repetitions-scale nan
refused "--builder" --table 3 --builder random
refused "--svg" --table 3 --svg figure.svg
"$FLASHBVH" bench --help | grep -q Usage || fail "no help"
