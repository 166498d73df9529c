#!/bin/sh
# firmware_examples/quick_start, copied out of the tree: make builds it and QEMU runs it. With replacements of the
# Pico's SDK and of ESP-IDF, its other builds run there, too.
#     copied.sh quick    only by make, with the amalgamation
. "$(dirname "$0")/common.sh"
{ command -v arm-none-eabi-g++ && command -v qemu-system-arm && command -v make; } >log || exit 77
PATH=$(dirname "$FLASHBVH"):$PATH
unset FLASHBVH # which the folder's builds read, too
launcher=${CMAKE_CXX_COMPILER_LAUNCHER:-}

copy() {
  rm -rf copied
  cp -r "$ROOT/firmware_examples/quick_start" copied
  rm -rf copied/*/build
}
# make_in_copy ARGUMENT...
make_in_copy() {
  make -s --no-print-directory -C copied/cortex_m4 "CC=$launcher arm-none-eabi-gcc -Werror" \
    "CXX=$launcher arm-none-eabi-g++ -Werror" "$@"
}
# answers_by_make LIBRARY
answers_by_make() {
  quietly make_in_copy "FLASHBVH=$1"
  make_in_copy run "FLASHBVH=$1" >answer 2>&1 || fail "it ended with $?: $(cat answer)"
  cmp answer copied/expected.txt || fail "other answers: $(cat answer)"
}
copy
! make_in_copy >log 2>&1 && grep -q "no flashbvh in FLASHBVH=../../flashbvh: name the folder" log || fail "no message"
answers_by_make "$PACKAGES/amalgamation"

# A changed mesh is baked again: over a plate a millimetre higher, the peg is not free.
sed -i 's/ 0$/ 1/' copied/plate.obj
! make_in_copy run "FLASHBVH=$PACKAGES/amalgamation" >log 2>&1 || fail "the plate that was"
grep -qx "0.5 mm above the plate: touches" log || fail "not the plate as it is"
# In C: the guide's program, which exits with 0 if its answers are right.
rm copied/main.cpp copied/cortex_m4/build/main.*
cp "$ROOT/tests/docs/guide.c" copied/main.c
python3 "$ROOT/tests/docs/snippets.py" copied
cp "$ROOT/firmware_examples/quick_start/plate.obj" copied
quietly make_in_copy run "FLASHBVH=$PACKAGES/amalgamation"
[ "${1:-}" != quick ] || exit 0

copy
answers_by_make "$ROOT"

# configure FOLDER CPU LIBRARY
configure() {
  flags="-O0 -Wall -Wextra -Werror $machine $2"
  cmake -G Ninja -S "copied/$1" -B "$1" -DCMAKE_SYSTEM_NAME=Generic -DCMAKE_TRY_COMPILE_TARGET_TYPE=STATIC_LIBRARY \
    -DCMAKE_C_COMPILER=arm-none-eabi-gcc -DCMAKE_CXX_COMPILER=arm-none-eabi-g++ \
    "-DCMAKE_C_FLAGS=$(echo "$flags" | sed 's/-fno-rtti//; s/-fno-threadsafe-statics//')" \
    "-DCMAKE_CXX_FLAGS=$flags" "-DSOURCES=$(printf '%s;' $board_sources "$ROOT/ports/common/syscalls.cpp")" \
    "-DINCLUDES=$ROOT/ports/common;$ROOT/ports/cortex-m" "-DFLASHBVH=$3"
}
# answers_by_cmake FOLDER CPU LIBRARY TARGET MACHINE
answers_by_cmake() {
  ! configure "$1" "$2" /none >log 2>&1 && tr -s '\n ' '  ' <log | grep -q "in FLASHBVH=/none: name the folder" ||
    fail "$1: no message"
  quietly configure "$1" "$2" "$3"
  quietly cmake --build "$1"
  FLASHBVH_TIMEOUT=60 "$ROOT/ports/run" "$5" "$1/$4" >answer || fail "$1 ended with $?: $(cat answer)"
  grep -e "^0.5 mm" -e "^2 mm" copied/expected.txt | cmp - answer || fail "$1: $(cat answer)"
  touch copied/plate.obj
  quietly cmake --build "$1"
  grep -q "^plate .*100 x 60 x 40 mm" log || fail "$1: a changed mesh is not baked again"
}
small="-Wl,--defsym=__flash_size=256K -Wl,--defsym=__ram_size=16K"
export PICO_SDK_PATH="$ROOT/tests/release/sdk/pico-sdk" IDF_PATH="$ROOT/tests/release/sdk/esp-idf"
answers_by_cmake pico "-mthumb -mcpu=cortex-m0plus $small" "$ROOT" firmware microbit
[ -s pico/firmware.bin ] || fail "nothing to load to a Pico"
answers_by_cmake esp32 "$cpu" "$PACKAGES/esp-idf" quick_start mps2-an386
quietly cmake "-DPACKAGE=$WORK/copied/esp32/main" -P "$ROOT/tests/release/firmware/esp-idf.cmake"
grep -qx "requires: flashbvh " log || fail "esp32: requires something else"
