#!/bin/sh
# add_subdirectory() and flashbvh_add_mesh(): bakes when a mesh, an option or the tool changes, and
# not otherwise, with Ninja and with make.
. "$SOURCES/common.sh"
mkdir tool
cp "$FLASHBVH" tool/flashbvh

for generator in Ninja "Unix Makefiles"; do
  configure built -DWAY=add_subdirectory "-DFLASHBVH_ROOT=$ROOT" \
    "-DFLASHBVH_HOST_TOOL=$PWD/tool/flashbvh" "-DOPTIONS=CELL;0.01" $bare
  bakes built "the first time"
  built/consumer || fail "wrong answers"
  rests built "nothing changed"
  configure built "-DOPTIONS=CELL;0.01"
  rests built "configured anew"
  touch firmware/main.cpp
  rests built "another source changed"
  touch firmware/peg.obj
  bakes built "a mesh changed"
  rests built "nothing changed since the mesh"
  configure built "-DOPTIONS=CELL;0.02"
  bakes built "an option changed"
  grep -q 'kCell = 0.02;' built/flashbvh/parts/peg.fbvh.hpp || fail "the option has no effect"
  rests built "nothing changed since the option"
  touch tool/flashbvh
  bakes built "the tool changed"
  built/consumer || fail "wrong answers"
  [ ! -e built/parts/peg.fbvh ] || fail "an image that nobody asked for"
  rm -r built
done

# What is wrong is said by its name.
wrong() {
  said=$1
  shift
  rm -rf wrong
  "$CMAKE" -S firmware -B wrong -DWAY=add_subdirectory "-DFLASHBVH_ROOT=$ROOT" "$@" >log 2>&1 &&
    fail "accepted: $*"
  tr -s '\n ' '  ' <log | grep -qF -- "$said" || fail "no '$said'"
}
wrong "flashbvh_add_mesh(parts): give SOURCES mesh... and options with their values; not understood: CEL;1" \
  "-DFLASHBVH_HOST_TOOL=$FLASHBVH" "-DOPTIONS=CEL;1"
wrong "not understood: CELL" "-DFLASHBVH_HOST_TOOL=$FLASHBVH" "-DOPTIONS=CELL"
wrong "FLASHBVH_HOST_TOOL: there is no /nowhere/flashbvh; give the path" \
  -DFLASHBVH_HOST_TOOL=/nowhere/flashbvh
