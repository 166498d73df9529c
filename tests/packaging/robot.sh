#!/bin/sh
# flashbvh_add_robot(): bakes when the URDF, one of its meshes, an option or the tool changes, and not
# otherwise, with Ninja and with make.
. "$SOURCES/common.sh"
mkdir tool
cp "$FLASHBVH" tool/flashbvh
baked=arm

for generator in Ninja "Unix Makefiles"; do
  # shellcheck disable=SC2086
  configure built -DWAY=add_subdirectory "-DFLASHBVH_ROOT=$ROOT" \
    "-DFLASHBVH_HOST_TOOL=$PWD/tool/flashbvh" "-DROBOT=STOP;0.001;WARN;0.002" $bare
  bakes built "the first time"
  built/guard || fail "wrong answers"
  rests built "nothing changed"
  touch firmware/guard.cpp firmware/plate.obj
  rests built "what is none of the robot's changed"
  touch firmware/peg.obj
  bakes built "a mesh changed"
  rests built "nothing changed since the mesh"
  touch firmware/arm.urdf
  bakes built "the URDF changed"
  configure built "-DROBOT=LEAF_SIZE;2;CELL;0.0001"
  bakes built "an option changed"
  grep -q 'kCell = 1e-04\|kCell = 0.0001' built/flashbvh/arm/arm.robot.hpp || fail "the option has no effect"
  rests built "nothing changed since the option"
  touch tool/flashbvh
  bakes built "the tool changed"
  built/guard || fail "wrong answers"
  rm -r built
done

# What is wrong is said by its name.
wrong() {
  rm -rf wrong
  "$CMAKE" -S firmware -B wrong -DWAY=add_subdirectory "-DFLASHBVH_ROOT=$ROOT" \
    "-DFLASHBVH_HOST_TOOL=$FLASHBVH" "-DROBOT=$1" >log 2>&1 && fail "accepted: $1"
  tr -s '\n ' '  ' <log | grep -qF -- "flashbvh_add_robot(arm): $2" || fail "no '$2'"
}
words="give URDF file and options with their values, PACKAGE as name=folder, PAIR as link,link=length; not understood:"
wrong "CEL;1" "$words CEL;1"
wrong CELL "$words CELL"
wrong "PACKAGE;parts" "$words parts"
sed -i 's/URDF arm.urdf PACKAGE/PACKAGE/' firmware/CMakeLists.txt
wrong "" "$words"
sed -i 's/(arm PACKAGE/(arm-1 URDF arm.urdf PACKAGE/; s/arm::arm/arm-1/' firmware/CMakeLists.txt
rm -rf wrong
"$CMAKE" -S firmware -B wrong -DWAY=add_subdirectory "-DFLASHBVH_ROOT=$ROOT" \
  "-DFLASHBVH_HOST_TOOL=$FLASHBVH" -DROBOT= >log 2>&1 && fail "a name that is none"
tr -s '\n ' '  ' <log | grep -q "flashbvh_add_robot(arm-1): the name is that of a C++ namespace" ||
  fail "no mend"
