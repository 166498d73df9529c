#!/bin/sh
# Meshes that are queried together need one cell: what links two libraries of meshes does not configure
# unless they are given the same, and the message says what to do.
. "$SOURCES/common.sh"
cp firmware/peg.obj firmware/tool.obj

# tries "OPTIONS" "MORE": of the first library and the second.
tries() {
  rm -rf built
  "$CMAKE" -G Ninja -S firmware -B built -DWAY=add_subdirectory "-DFLASHBVH_ROOT=$ROOT" \
    "-DFLASHBVH_HOST_TOOL=$FLASHBVH" $bare "-DOPTIONS=$1" "-DMORE=$2" >log 2>&1
}
refuses() {
  tries "$1" "$2" && fail "accepted: '$1' and '$2'"
  tr -s '\n ' '  ' <log | grep -qF 'need the same cell: name them in one flashbvh_add_mesh(), or give each the same CELL, written alike; OWN_CELL for meshes that are not] property of "more" does not agree' ||
    fail "no mend: '$1' and '$2'"
}
refuses "" ""
refuses "CELL;0.01" ""
refuses "CELL;0.01" "CELL;0.02"
refuses "CELL;0.01;FORMAT;both" "CELL;0.02;FORMAT;image"
tries "CELL;0.01" "CELL;0.01" || fail "refused: the same cell"
tries "" OWN_CELL || fail "refused: another mesh with a cell of its own"
tries OWN_CELL "CELL;0.01" || fail "refused: meshes with a cell of their own"
build built
built/consumer || fail "wrong answers"

# C needs a compiler of C.
tries "FORMAT;c" OWN_CELL && fail "C without a compiler of it"
tr -s '\n ' '  ' <log | grep -qF "flashbvh_add_mesh(parts): FORMAT c makes C; name C in project()'s LANGUAGES" ||
  fail "no mend"
sed -i 's/LANGUAGES CXX/LANGUAGES C CXX/' firmware/CMakeLists.txt
tries "CELL;0.01" "CELL;0.01;FORMAT;c" || fail "no C"
build built
[ -e built/flashbvh/more/tool.fbvh.c ] || fail "no C"
[ ! -e built/flashbvh/more/tool.fbvh ] || fail "an image that nobody asked for"
