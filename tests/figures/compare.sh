#!/bin/sh
# compare.sh RESULTS...
#
# Compares measured figures with those that lib/docs/figures.md was made of, tests/figures/figures.txt
# unless DATA names another file; fails, and says which, if they differ by more than 2 %, either way,
# or if counts differ at all.
set -eu
here=$(dirname "$0")
[ $# -ge 1 ] || { sed -n '2,6s/^# \{0,1\}//p' "$0" >&2; exit 2; }
for results; do
  [ -r "$results" ] || { echo "compare.sh: no results in $results" >&2; exit 2; }
done
exec awk -v slack=2 -f "$here/compare.awk" "${DATA:-$here/figures.txt}" "$@"
