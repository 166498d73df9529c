#!/bin/sh
# The two files, compiled with all warnings by each installed compiler, answer like the library: the digest, natively
# and on a Cortex-M4F, and a robot's guard. C's header is C99.
#     amalgamation.sh quick    by one compiler, on this machine
. "$(dirname "$0")/common.sh"
files=$PACKAGES/amalgamation
# The digest uses names of detail/ that the two files hide; everything else comes from them.
digest="$ROOT/tests/digest/main.cpp $ROOT/tests/digest/digest.cpp $ROOT/tests/digest/small_mesh.cpp
  $ROOT/tests/digest/small_tree.cpp -I$files -I$ROOT/tests -idirafter $ROOT/lib/include"
native=${CXX:-c++}
level=-O0
[ "${1:-}" = quick ] || { native="g++ clang++"; level=-O2; }

cp "$PACKAGES"/arduino/flashbvh/examples/robot_guard/cell_arm.robot.[ch] .
for compiler in $native; do
  for file in flashbvh flashbvh_robot; do
    quietly $compiler -std=c++17 $level $warnings -c "$files/$file.cpp" -o $file.o
  done
  quietly $compiler -std=c++17 $level $digest flashbvh.o -o digest
  same_digest ./digest
  quietly $compiler -std=c++17 $level -ffp-contract=off "-I$files" -I. \
    "-I$ROOT/firmware_examples/robot_guard" "-I$ROOT/firmware_examples/host" \
    "-I$ROOT/firmware_examples/robot_guard/cell_arm" "$ROOT/firmware_examples/robot_guard/main.cpp" \
    -x c++ cell_arm.robot.c -x none flashbvh.o flashbvh_robot.o -o guard
  ./guard >answer || fail "the guard ended with $?"
done
sed 's/#/[0-9]*/g' "$ROOT/firmware_examples/robot_guard/cell_arm/expected.txt" >expected
is_expected "the guard"
cat >c.c <<'end'
#include "flashbvh.h"
#include "flashbvh/version.hpp"
int main(void) { return FLASHBVH_VERSION_MAJOR > 0 ? 0 : 1; }
end
quietly ${CC:-cc} -std=c99 -pedantic $warnings "-I$files" c.c -o c
./c || fail "C"

[ "${1:-}" != quick ] || exit 0
shown "Two files" >command
ln -s "$files" amalgamation
quietly sh -e command
[ -s flashbvh.o ] || fail "the page's command"
for file in flashbvh flashbvh_robot; do
  quietly arm-none-eabi-g++ $cpu -std=c++17 -O2 $warnings -ffreestanding -c "$files/$file.cpp" -o $file.o
done
quietly arm-none-eabi-g++ $cpu $machine -std=c++17 -O2 -DFLASHBVH_ON_BOARD $digest $board_sources \
  $board_includes flashbvh.o -o digest.elf
same_digest digest.elf "$ROOT/ports/run mps2-an386"
