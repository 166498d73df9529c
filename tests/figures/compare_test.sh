#!/bin/sh
# What compare.sh lets pass and what it does not, on figures made up here.
set -eu
here=$(dirname "$0")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cat >"$work/data" <<DATA
all set.visits 1000
M4 set.query 1000
M4 set.visit 50.00
M4 stack.query 252
DATA

# expect STATUS WORDS LINE...: the lines, measured, compare with that status and say WORDS.
expect() {
  wanted=$1
  words=$2
  shift 2
  printf '%s\n' "$@" >"$work/measured"
  status=0
  DATA=$work/data "$here/compare.sh" "$work/measured" >"$work/said" || status=$?
  [ $status = "$wanted" ] && grep -q -e "$words" "$work/said" ||
    { echo "compare_test.sh: status $status, not $wanted with '$words': $*" >&2; cat "$work/said" >&2
      exit 1; }
}

expect 0 "3 compared, 0 differ" "all set.visits 1000" "M4 set.query 1000" "M4 set.visit 50.00"
expect 0 "0 differ" "all set.visits 1000" "M4 set.query 1020" "M4 set.visit 49.00"
expect 0 "0 differ" "M4 stack.query 252"
expect 1 "M4 set.query: 1021, more than 2 %" "M4 set.query 1021" "M4 set.visit 50"
expect 1 "better than documented" "M4 set.query 979" "M4 set.visit 50"
expect 1 "M4 set.visit: 51.01" "M4 set.query 1000" "M4 set.visit 51.01"
expect 1 "every core has to count the same" "all set.visits 1001"
expect 1 "M4 set.visit: on the page, and was not measured" "M4 set.query 1000"
expect 1 "not documented" "M4 set.query 1000" "M4 set.visit 50" "M4 set.other 1"
expect 1 "not documented" "M5 set.query 1000"
expect 1 "not a figure" "M4 set.query"
expect 1 "nothing was measured" ""
