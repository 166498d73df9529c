#!/bin/sh
# A cross build with its compiler, flags and toolchain file in the environment: they reach the library
# and the baked code, not the tool, which is built for this machine beside it.
. "$SOURCES/common.sh"
enter_cross_environment
configure built -DWAY=add_subdirectory "-DFLASHBVH_ROOT=$ROOT" "-DOPTIONS=CELL;0.01"
bakes built "the first time"
for_the_target built/consumer
grep -rq FOR_THE_TARGET built/build.ninja || fail "the flags don't reach the firmware"
host=built/flashbvh-host
[ -x $host/bin/flashbvh ] || fail "no tool"
if grep -l FOR_THE_TARGET $host/CMakeCache.txt $host/build.ninja; then
  fail "the target's flags reach the tool"
fi
rests built "nothing changed"
