#!/bin/sh
# page.sh            writes lib/docs/figures.md: page.md with the numbers of figures.txt
# page.sh --check    fails if that would change it
set -eu
here=$(cd "$(dirname "$0")" && pwd)
page=$here/../../lib/docs/figures.md
new=$(mktemp)
trap 'rm -f "$new"' EXIT
awk -f "$here/../benchmark/markdown.awk" -f "$here/../proof/bound/formula.awk" -f "$here/page.awk" \
  "$here/figures.txt" "$here/parts.txt" "$here/page.md" >"$new"
case ${1:-} in
  --check)
    diff "$page" "$new" ||
      { echo "page.sh: lib/docs/figures.md is not what the data give: run tools/figures.sh" >&2; exit 1; }
    ;;
  '') cat "$new" >"$page" ;;
  *) sed -n '2,3s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
esac
