#!/bin/sh
# page.sh            writes lib/docs/*.md of pages/*.md, with the numbers of figures.txt
# page.sh --check    fails if that would change them
set -eu
here=$(cd "$(dirname "$0")" && pwd)
case ${1:-} in
  --check | '') ;;
  *) sed -n '2,3s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
esac
new=$(mktemp)
trap 'rm -f "$new"' EXIT
status=0
for source in "$here"/pages/*.md; do
  page=$here/../../lib/docs/${source##*/}
  awk -f "$here/../benchmark/markdown.awk" -f "$here/../proof/bound/formula.awk" -f "$here/page.awk" \
    "$here/figures.txt" "$here/parts.txt" "$source" >"$new"
  if [ $# -eq 0 ]; then
    cat "$new" >"$page"
  elif ! diff "$page" "$new"; then
    echo "page.sh: lib/docs/${page##*/} is not what the data give: run tools/figures.sh" >&2
    status=1
  fi
done
exit $status
