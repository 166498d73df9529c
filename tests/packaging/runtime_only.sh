#!/bin/sh
# Firmware that links arrays baked before needs neither the tool nor assimp, CLI11, nlohmann_json,
# urdfdom, zlib or Catch2, whichever way it gets the library.
. "$SOURCES/common.sh"
"$FLASHBVH" bake firmware/plate.obj firmware/peg.obj -o baked --format cpp >log 2>&1 || fail bake

# shellcheck disable=SC2086
"$CMAKE" -G Ninja -S "$ROOT" -B library -DFLASHBVH_BUILD_TOOL=OFF $bare >log 2>&1 || fail configure
build library
"$CMAKE" --install library --prefix prefix >log 2>&1 || fail install
[ ! -e prefix/bin ] || fail "a program was installed"
for way in add_subdirectory fetch_content find_package; do
  # shellcheck disable=SC2086
  configure "$way" -DWAY=$way "-DFLASHBVH_ROOT=$ROOT" "-DBAKED=$PWD/baked" \
    "-DCMAKE_PREFIX_PATH=$PWD/prefix" $bare
  build "$way"
  "$way/consumer" || fail "wrong answers: $way"
  [ ! -e "$way/flashbvh-host" ] || fail "the tool was built"
done

# The package without the tool says what it needs to bake, and takes it.
"$CMAKE" -S firmware -B wrong "-DCMAKE_PREFIX_PATH=$PWD/prefix" >log 2>&1 && fail "nothing to bake with"
tr -s '\n ' '  ' <log | grep -q "set FLASHBVH_HOST_TOOL to its path" || fail "no mend"
configure with_tool "-DCMAKE_PREFIX_PATH=$PWD/prefix" "-DFLASHBVH_HOST_TOOL=$FLASHBVH"
bakes with_tool "the first time"
with_tool/consumer || fail "wrong answers"

# flashbvh's own build does look for them, and names the way out.
# shellcheck disable=SC2086
"$CMAKE" -S "$ROOT" -B wrong_too $bare >log 2>&1 && fail "configured without assimp"
tr -s '\n ' '  ' <log | grep -q "assimp not found: apt-get install .*FLASHBVH_BUILD_TOOL=OFF" ||
  fail "no mend"
