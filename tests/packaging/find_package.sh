#!/bin/sh
# An installed package: natively with its libraries and its tool; in a cross build it compiles the
# libraries for the target. It may be moved, and names no place on the machine that built it.
. "$SOURCES/common.sh"
"$CMAKE" --install "$FOLDER/cross/built/flashbvh-host" --prefix "$PWD/made" >log 2>&1 || fail install
mv made "moved here"
prefix="$PWD/moved here"
# A path that begins there; "${folder}/project" is no sign of a checkout in /project.
if grep -rlE "(^|[^A-Za-z0-9_.}/-])($ROOT|$FOLDER)(/|[^A-Za-z0-9_.-]|\$)" "$prefix"/include \
    "$prefix"/share "$prefix"/lib*/cmake; then
  fail "absolute paths"
fi
"$prefix/bin/flashbvh" --version | grep -q flashbvh || fail "no tool"
[ -n "$(find "$prefix" -name libflashbvh.a)" ] || fail "no library"

version=$("$prefix/bin/flashbvh" --version | sed 's/^flashbvh \([0-9]*\.[0-9]*\).*/\1/')
configure built "-DCMAKE_PREFIX_PATH=$prefix" -DVERSION="$version" "-DROBOT=STOP;0.001" $bare
bakes built "the first time"
built/consumer && built/guard || fail "wrong answers"
rests built "nothing changed"
touch "$prefix"/bin/flashbvh
bakes built "the tool changed"
"$CMAKE" -S firmware -B wrong "-DCMAKE_PREFIX_PATH=$prefix" -DVERSION=99 >log 2>&1 &&
  fail "version 99 accepted"

enter_cross_environment
configure cross "-Dflashbvh_DIR=$(dirname "$(find "$prefix" -name flashbvhConfig.cmake)")" -DROBOT=
bakes cross "the first time, crossing"
for_the_target cross/consumer
for_the_target cross/guard
