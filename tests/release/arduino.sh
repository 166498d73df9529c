#!/bin/sh
# The library for Arduino: arduino-builder builds its examples with the test's own core, whose Arduino.h has the macros
# of Arduino's. QEMU runs them, and they must print the output of the firmware from which they were made.
. "$(dirname "$0")/common.sh"
hardware=hardware/flashbvh/arm
mkdir -p $hardware/cores/qemu libraries tools built cache
cp "$ROOT"/tests/release/arduino/*.txt $hardware
cp "$ROOT"/tests/release/arduino/Arduino.h "$ROOT"/tests/release/arduino/core.cpp $board_sources \
  "$ROOT"/ports/common/*.h "$ROOT"/ports/common/*.hpp "$ROOT"/ports/common/sections.ld $hardware/cores/qemu
# An example has its own text.hpp.
mv $hardware/cores/qemu/text.hpp $hardware/cores/qemu/port_text.hpp
sed -i 's/"text.hpp"/"port_text.hpp"/' $hardware/cores/qemu/*.cpp
cp -r "$PACKAGES/arduino/flashbvh" libraries

# runs EXAMPLE: its output must be that of `expected`.
runs() {
  example=libraries/flashbvh/examples/$1/$1.ino
  quietly arduino-builder -compile -hardware /usr/share/arduino-builder -hardware "$PWD/hardware" \
    -tools "$PWD/tools" -libraries "$PWD/libraries" -fqbn flashbvh:arm:an386 -build-path "$PWD/built" \
    -build-cache "$PWD/cache" "$example"
  on_board "built/$1.ino.elf"
  is_expected "$1"
}

{ cat "$ROOT/firmware_examples/quick_start/expected.txt"; echo "as it should be"; } >expected
runs quick_start
sed 's/#/[0-9]*/g' "$ROOT/firmware_examples/robot_guard/cell_arm/expected.txt" >expected
echo "as it should be" >>expected
runs robot_guard

# The page's commands.
cp "$ROOT"/firmware_examples/quick_start/*.obj .
shown Arduino >command
PATH=$(dirname "$FLASHBVH"):$PATH quietly sh -e command
[ -s MySketch/plate.fbvh.h ] && [ -s MySketch/peg.fbvh.c ] || fail "the page's command"

# The files that the IDE lists and opens.
version=$(sed -n 's/^version=//p' libraries/flashbvh/library.properties)
[ -s "$PACKAGES/arduino/flashbvh-$version.zip" ] || fail "the archive's name"
python3 -m zipfile -e "$PACKAGES"/arduino/flashbvh-*.zip unpacked
diff -r unpacked/flashbvh "$PACKAGES/arduino/flashbvh" >log || fail "the archive holds something else"

# In C it is the C interface; a core with older C++ fails with a message that names the missing version.
echo '#include <flashbvh.h>' >include.c
quietly cc -std=c99 -Ilibraries/flashbvh/src -c include.c
! c++ -std=c++14 -x c++ -Ilibraries/flashbvh/src -c include.c >log 2>&1 && grep -q "flashbvh is C++17" log ||
  fail "no message for C++14"
