#!/bin/sh
# The Zephyr module and the ESP-IDF component, in a build with the functions that they call: the digest links them and
# runs on a Cortex-M4F; the machine's flags reach every source.
. "$(dirname "$0")/common.sh"
cp "$ROOT"/tests/release/firmware/* .
sources=$(printf '%s;' "$ROOT"/tests/digest/*.cpp $board_sources)
includes="$ROOT/tests;$ROOT/ports/common;$ROOT/ports/cortex-m"

# configure SYSTEM BUILD ROBOT
configure() {
  quietly cmake -G Ninja -S . -B "$2" -DSYSTEM="$1" "-DPACKAGE=$PACKAGES/$1/flashbvh" "-DROBOT=$3" \
    "-DMACHINE=-O1 $cpu $machine" "-DSOURCES=$sources" "-DINCLUDES=$includes"
  grep '"command"' "$2/compile_commands.json" | grep -- " -c $PACKAGES/$1/" >commands
}

# builds SYSTEM
builds() {
  configure "$1" "$1" y
  [ "$(wc -l <commands)" -eq "$(find "$ROOT/lib/src" -name '*.cpp' | wc -l)" ] || fail "$1: not all sources"
  ! grep -v FROM_THE_MACHINE commands || fail "$1: compiled for another machine"
  quietly cmake --build "$1"
  same_digest "$1/digest" "$ROOT/ports/run mps2-an386"
}
builds zephyr
builds esp-idf
configure zephyr without_robot n
! grep /robot/ commands || fail "zephyr: the robot's layer, although not requested"
[ -s commands ] || fail "zephyr: no sources"

quietly cmake "-DPACKAGE=$PACKAGES/esp-idf/flashbvh" -P esp-idf.cmake
grep -qx 'requires: *' log || fail "esp-idf: requires what it need not"
