#!/bin/sh
# compare.sh SMALL REAL: the small header against Catch2, on sample.cpp compiled with each.
set -u
small=$1
real=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0

complain() {
  echo "$*"
  failed=1
}

# The steps that a program traces, and whether it passes.
outcome() {
  "$@" >"$work/output" 2>&1 && verdict=passes || verdict=fails
  grep '^trace: ' "$work/output"
  echo "$verdict"
}

compare() {
  outcome "$small" "$@" >"$work/of_small"
  outcome "$real" "$@" >"$work/of_real"
  diff "$work/of_small" "$work/of_real" >"$work/difference" ||
    complain "$*: the small header and Catch2 differ:" "$(cat "$work/difference")"
}

# What both list, with the escapes of Catch.cmake; hidden test cases are not listed.
"$small" --list-test-names-only | sort >"$work/list"
"$real" --list-test-names-only | sort | diff "$work/list" - || complain "other test cases"
[ "$(wc -l <"$work/list")" -ge 18 ] || complain "test cases are missing"
while IFS= read -r name; do
  compare "$(printf '%s' "$name" | sed 's/[],[]/\\&/g')"
done <"$work/list"
for tag in '[nested]' '[values]' '[types]' '[print]'; do
  compare "$tag"
done

"$small" --list-test-names-only >/dev/null
[ $? -eq "$(wc -l <"$work/list")" ] || complain "the status of a list is not its length"
"$small" "no such test" >/dev/null && complain "that nothing runs is no failure"
"$small" --unknown >/dev/null && complain "an unknown option is no failure"
"$small" "a failed REQUIRE stops" >/dev/null
[ $? -eq 120 ] || complain "a failed REQUIRE does not end with 120"

expect() {
  printf '%s\n' "$@" | while IFS= read -r line; do
    grep -qF -- "$line" "$work/printed" || echo "not printed: $line"
  done >"$work/missing"
  [ ! -s "$work/missing" ] || complain "$(cat "$work/missing" "$work/printed")"
}

"$small" "values print" >"$work/printed"
expect 'sample.cpp:' 'failed in "values print"' 'CHECK( text == nullptr )' \
  'with -9000000000000000000 == 9000000000000000000' 'with 200 == 201' 'with "text" == nullptr' \
  'with 0x' '00001234 == nullptr' 'with false == true' 'with 0 == 1' "with 'a' == 'b'" \
  'with {?} == {?}' 'with 1.5 == 2.0' 'with 0.5f == -0.1000000015f' ' * 2^' 'with -0.3333333333 == 1000000000000000000.0' \
  'test cases: 1, failures: 13'
[ "$(grep -cx '  with false' "$work/printed")" -eq 1 ] || complain "a lone value is not printed"

"$small" "messages print" >"$work/printed"
expect 'about all' 'about a section' 'in a section' 'round := 2' 'round + 5 := 7' \
  '"letters" := "letters"' 'opaque := {?}'
[ "$(tail -4 "$work/printed" | grep -c ' := ')" -eq 0 ] || complain "a CAPTURE outlives its scope"
exit $failed
