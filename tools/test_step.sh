#!/bin/sh
# test_step.sh STEP    One step of tools/test.sh:
#   native       the library and the program on this machine; with --all with sanitizers, and what later steps need
#   long         the tests that damage meshes and images in many ways, or compile projects of their own
#   python       the Python package, and one hash of queries and guard periods in it and in C++
#   style        formatting, the order of the library's rooms, generated presets, budgets of lines
#   lint         clang-tidy
#   digests      the digests of all answers on three boards, whose compilers it installs while `native` compiles
#   PRESET       a board under QEMU, or node: what ports/cores.json says
# What it prints goes to build/log/STEP. Its status is 255 if it fails, which ends xargs.
set -eu
cd "$(dirname "$0")/.."
native=native-sanitize

sources() {
  find lib ports tools tests firmware_examples -name '*.[ch]pp' -o -name '*.h' -o -name '*.c'
}

# board PRESET TESTS [JOBS]
board() {
  case $2 in
    digest) targets=digest names="the digest is every core's$" ;;
    digests) targets="digest motion_digest_board_test" names="the digest is every core's$|_digest_board_test$" ;;
    answers) targets="digest board_tests" names="the digest is every core's$|_board_test$" ;;
    measured)
      cmake --preset "$1" -DFLASHBVH_HOST_TOOL="$PWD/build/$native/bin/flashbvh" \
        -DFLASHBVH_KR5_FIGURES="$PWD/build/figures"
      cmake --build --preset "$1" -j 1
      ctest --preset "$1"
      return ;;
  esac
  cmake --preset "$1" -DFLASHBVH_IS_MEASURED=OFF
  cmake --build --preset "$1" -j "${3:-1}" --target $targets
  ctest --preset "$1" -R "$names"
}

run() {
  case $1 in
    native)
      preset=$native
      [ -n "${FLASHBVH_TEST_ALL:-}" ] || preset=dev
      cmake --preset $preset -DFLASHBVH_KR5_FIGURES=
      cmake --build build/$preset
      ctest --test-dir build/$preset --output-on-failure --no-tests=error -LE long -j "$(nproc)"
      [ -z "${FLASHBVH_TEST_ALL:-}" ] || FLASHBVH_NATIVE=$native tools/figures.sh --prepare ;;
    long) ctest --preset $native -L long ;;
    python)
      cmake --preset dev -B build/python -DFLASHBVH_BUILD_PYTHON=ON -DFLASHBVH_WASM_COMPILER=OFF \
        -DFLASHBVH_HOST_TOOL="$PWD/build/$native/bin/flashbvh"
      cmake --build build/python -j 1 --target flashbvh_python one_hash
      ctest --test-dir build/python --output-on-failure --no-tests=error -R "/python|/one_hash" ;;
    style)
      sources | xargs -n 200 clang-format --dry-run -Werror
      tools/cores.py --check
      tools/rooms.py
      tools/budgets.sh ;;
    lint) tools/lint.sh ;;
    digests)
      . tools/packages.sh
      ensure_packages $board_packages $riscv_packages
      for preset in cortex-m4f cortex-m0 rv32imac; do
        board $preset digests 2
      done ;;
    *) board "$1" "$(tools/cores.py "$1")" ;;
  esac
}

finish() {
  if [ $? -eq 0 ]; then
    times >build/log/times.$1
    echo "== $1 passed in $(($(date +%s) - began)) s, computing $(sed -n 2p build/log/times.$1)" >&3
  else
    { tail -n 60 "build/log/$1"; printf '\n== %s FAILED; all of it: build/log/%s\n' "$1" "$1"; } >&3
    exit 255
  fi
}
began=$(date +%s)
exec 3>&1 >"build/log/$1" 2>&1
trap 'finish "$1"' EXIT
run "$1"
