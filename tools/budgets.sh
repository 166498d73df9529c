#!/bin/sh
# budgets.sh    Fails if a folder has more lines of text than tools/budgets.txt grants it. Growth is a decision: raise the
#               budget in the commit that needs it.
set -eu
cd "$(dirname "$0")/.."
status=0
while read -r folder most; do
  lines=$(git ls-files -- "$folder" | grep -vE '\.(fbvh|robot|png)$|/corpus/' | tr '\n' '\0' | xargs -0 cat | wc -l)
  [ "$lines" -le "$most" ] || { echo "$folder has $lines lines, $most are granted" && status=1; }
done <tools/budgets.txt
exit $status
