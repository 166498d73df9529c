#!/bin/sh
# check_test.sh FOLDER: check.awk on figures that are as they should be, and on others.
set -eu
here=$(dirname "$0")
budgets=$1/test_budgets
figures=$1/test_figures
failed=0

# expect STATUS TEXT FIGURE...
expect() {
  expected=$1
  text=$2
  shift 2
  printf '%s\n' "$@" >"$figures"
  status=0
  output=$(awk -f "$here/check.awk" any,small "$budgets" "$figures" 2>&1) || status=1
  case $output in
    *"$text"*) ;;
    *) status=2 ;;
  esac
  if [ "$status" -ne "$expected" ]; then
    printf 'check_test.sh: expected %s and "%s" of %s:\n%s\n' "$expected" "$text" "$*" "$output"
    failed=1
  fi
}

printf '%s\n' "# one" "any stack walk 100" "small code walk Os 600" "large code walk Os 1" \
  >"$budgets"
code="code walk Os 600"
expect 0 "at most 100" "$code" "stack walk graph 100" "stack walk painted 84"
expect 1 "painted 83, 17 below" "$code" "stack walk graph 100" "stack walk painted 83"
expect 1 "painted 84, above" "$code" "stack walk graph 80" "stack walk painted 84"
expect 1 "more than 100" "$code" "stack walk graph 104" "stack walk painted 100"
expect 1 "more than 600" "code walk Os 601" "stack walk graph 80" "stack walk painted 80"
expect 1 "only one of the two" "$code" "stack walk graph 80"
expect 1 "was not measured: code walk Os" "stack walk graph 80" "stack walk painted 80"
expect 1 "no figures" "nothing"
exit $failed
