#!/bin/sh
# Everything that has to hold before a change is one: formatting, lint, and all tests, natively
# with sanitizers and on each board under QEMU. Installs what is missing.
set -eu
cd "$(dirname "$0")/.."
. tools/packages.sh
ensure_packages $host_packages $board_packages $riscv_packages $fuzz_packages $digest_packages \
  clang-format clang-tidy

step() { printf '\n== %s\n' "$1"; }

sources() {
  find lib ports tools tests firmware_examples -name '*.[ch]pp' -o -name '*.h' -o -name '*.c'
}

step "Formatting (clang-format -i mends it)"
sources | xargs clang-format --dry-run -Werror

step "Tests on this machine, with the address and undefined-behaviour sanitizers"
cmake --preset native-sanitize
cmake --build --preset native-sanitize
# A robot's links and poses, of which the figures are; and what is tested bakes for the boards.
FLASHBVH_NATIVE=native-sanitize tools/figures.sh --prepare
cmake --preset native-sanitize -DFLASHBVH_KR5_FIGURES="$PWD/build/figures"
cmake --build --preset native-sanitize
ctest --preset native-sanitize -j2

step "Lint (clang-tidy): the library and the host program"
sources | grep -E '^(lib|tools)/.*\.cpp$' |
  xargs -n 4 -P 2 clang-tidy --quiet -p build/native-sanitize --extra-arg=-Wno-unknown-warning-option \
    2>build/lint.log

for preset in cortex-m0 cortex-m3 cortex-m4f cortex-m7 cortex-m33 cortex-m55 rv32imac \
  stm32vldiscovery netduinoplus2 sifive_e; do
  step "Tests on $preset under QEMU"
  cmake --preset $preset -DFLASHBVH_HOST_TOOL="$PWD/build/native-sanitize/bin/flashbvh" \
    -DFLASHBVH_KR5_FIGURES="$PWD/build/figures"
  cmake --build --preset $preset
  ctest --preset $preset -j2
  tools/figures.sh --compare $preset
  grep -E "^budget: |, budget: (at most|below)" build/$preset/Testing/Temporary/LastTest.log
done

step "All tests passed"
