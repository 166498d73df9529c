#!/bin/sh
# `flashbvh bench --firmware`: what it writes, the same each time, and what it refuses.
set -eu
rm -rf "$WORK"
mkdir -p "$WORK"
cd "$WORK"

fail() {
  echo "firmware_files.sh: $*" >&2
  exit 1
}

# setups COUNT FILE...: of both tables in the files.
setups() {
  count=$1
  shift
  found=$(cat "$@" | sed -n '/kSetups/,/^    {}}/p' | grep -c '^    {{') || true
  [ "$found" = "$count" ] || fail "$found setups, not $count, in $*"
}

# left_out COUNT FILE
left_out() {
  found=$(sed -n '/kLeftOut/,/^    {}}/p' "$2" | grep -c '^    {[0-9]') || true
  [ "$found" = "$1" ] || fail "$found setups left out, not $1, of $2"
}

"$FLASHBVH" bench --firmware all
"$FLASHBVH" bench --firmware again
diff -r all again || fail "not the same files twice"
setups 16 all/setups_1.cpp  # all but subdivisions 3 and 4, which take 32-bit trees
left_out 4 all/setups_1.cpp

"$FLASHBVH" bench --firmware small --images 3 --max-bytes 200000
setups 14 small/setups_1.cpp small/setups_2.cpp small/setups_3.cpp
left_out 6 small/setups_1.cpp
left_out 0 small/setups_2.cpp
"$FLASHBVH" bench --firmware one --max-bytes 200000
setups 10 one/setups_1.cpp
[ ! -e one/setups_2.cpp ] || fail "two images, not one"
"$FLASHBVH" bench --firmware none --max-faces 795
setups 0 none/setups_1.cpp
left_out 20 none/setups_1.cpp

# Every tree is there that a table includes.
for file in */setups_*.cpp; do
  sed -n 's/^#include "\(.*fbvh\).cpp"$/\1/p' "$file" | while read -r tree; do
    [ -s "${file%/*}/$tree.cpp" ] && [ -s "${file%/*}/$tree.hpp" ] || fail "$file: no $tree"
  done
done

refused() {
  wanted=$1
  shift
  status=0
  "$FLASHBVH" bench "$@" >/dev/null 2>message || status=$?
  [ "$status" = 2 ] || fail "exit $status from: bench $*"
  [ "$(wc -l <message)" = 1 ] || fail "not one line: $(cat message)"
  grep -q -e "$wanted" message || fail "no '$wanted' in: $(cat message)"
}
refused "--max-faces" --max-faces 796
refused "--images" --firmware refused --images 0
refused "--max-bytes" --firmware refused --max-bytes 0
refused "--table" --firmware refused --table 2
: >file
refused "file" --firmware file
[ ! -e refused ] || fail "something written"
