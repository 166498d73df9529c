#!/bin/sh
# test_step.sh STEP    One step of tools/test.sh:
#   formatting   clang-format and the checks of style report nothing
#   configured   a build folder of this machine, with the address and undefined-behaviour sanitizers; for --quick that
#                of the preset dev, without
#   tool         the host program, which bakes for all that follows, what tests it, and what figures
#                are measured on
#   native       the tests on this machine, but for
#   long         those that damage meshes and images in many ways, or compile projects of their own
#   library      the tests that need nothing of the host program but `bake`: --quick
#   python       the Python package, and one hash of queries and guard periods in it and in C++
#   lint         clang-tidy: the library and the host program
#   PRESET       the tests on a board, under QEMU, or in node; on cortex-m4f with --all tools/demo.sh as well. Without --all
#                of cores that run another one's code the digest alone, of a Cortex-M3 and M55,
#                which have forms of their own, answers and arithmetic; in the core's form. For
#                --quick the digest and the arithmetic
# On one core but for formatting, the tool, which the others wait for, native and those of --quick. What it prints goes
# to build/log/STEP, its duration and the time it computed to build/log/seconds.
set -eu
cd "$(dirname "$0")/.."

sources() {
  find lib ports tools tests firmware_examples -name '*.[ch]pp' -o -name '*.h' -o -name '*.c'
}

tool() {
  cmake --build --preset native-sanitize --target flashbvh_tool write_poses \
    cli_brute_force cli_float_poses
  touch -r build/native-sanitize/bin/flashbvh build/bake_once.sh
  FLASHBVH_NATIVE=native-sanitize tools/figures.sh --prepare
  cmake --preset native-sanitize -DFLASHBVH_KR5_FIGURES="$PWD/build/figures"
}

board() {
  all=${FLASHBVH_ALL_TESTS:-OFF}
  figures= jobs=1
  [ -z "${FLASHBVH_QUICK:-}" ] || jobs=$(nproc)
  case $1-$all in
    cortex-m4f-* | *-ON) figures=$PWD/build/figures ;;
    *) echo "Of the figures those of the KR5 are left to the Cortex-M4F: --all measures them here, too" ;;
  esac
  cmake --preset "$1" -DFLASHBVH_HOST_TOOL="$PWD/build/bake_once.sh" \
    -DFLASHBVH_KR5_FIGURES="$figures" -DFLASHBVH_ALL_TESTS=$all
  tests=$(tools/cores.py "$1")
  case $tests-${FLASHBVH_QUICK:+quick-}$all in
    digest-OFF)
      cmake --build --preset "$1" -j 1 --target digest
      ctest --preset "$1" -R "the digest is every core's$"
      return ;;
    *-quick-* | arithmetic-OFF)
      cmake --build --preset "$1" -j $jobs --target digest board_tests
      ctest --preset "$1" -j $jobs -R "the digest is every core's$|_board_test$"
      return ;;
  esac
  cmake --build --preset "$1" -j 1
  ctest --preset "$1"
  [ "$tests" != release ] || return 0 # not measured
  grep -a "^budget: " "build/$1/Testing/Temporary/LastTest.log"
  [ "$1-$all" != cortex-m4f-ON ] ||
    FLASHBVH_NATIVE=native-sanitize FLASHBVH_BAKE=$PWD/build/bake_once.sh tools/demo.sh
}

run() {
  case $1 in
    formatting)
      sources | xargs -n 200 -P "$(nproc)" clang-format --dry-run -Werror
      tools/cores.py --check
      tools/rooms.py ;;
    configured)
      if [ "${FLASHBVH_QUICK:-}" ]; then
        cmake --preset dev
      else
        cmake --preset native-sanitize -DFLASHBVH_KR5_FIGURES= # `tool` bakes them again
      fi
      cp tools/bake_once.sh build/ ;;
    tool) tool ;;
    native)
      cmake --build --preset native-sanitize
      ctest --preset native-sanitize -LE long -j "$(nproc)" ;;
    long) ctest --preset native-sanitize -L long ;;
    library)
      cmake --build --preset dev
      ctest --preset dev ;;
    python)
      cmake --preset dev -B build/python -DFLASHBVH_BUILD_PYTHON=ON -DFLASHBVH_WASM_COMPILER=OFF \
        -DFLASHBVH_HOST_TOOL="$PWD/build/native-sanitize/bin/flashbvh"
      cmake --build build/python -j 1 --target flashbvh_python one_hash
      ctest --test-dir build/python --output-on-failure --no-tests=error -R "/python|/one_hash" ;;
    lint) tools/lint.sh ${FLASHBVH_DEEP_LINT:+--deep} 2>build/log/lint.warnings ;;
    *) board "$1" ;;
  esac
}

# After a failure no step starts. The tests need the tool; the long ones need the native builds.
case $1${FLASHBVH_QUICK:+-quick} in
  formatting | configured | tool | lint | *-quick) wanted=/dev/null ;;
  long) wanted=build/log/native.passed ;;
  *) wanted=build/log/tool.passed ;;
esac
until [ -e $wanted ] || [ -e build/log/failed ]; do
  sleep 1
done
[ ! -e build/log/failed ] || exit 1

finish() {
  status=$?
  took=$(($(date +%s) - began))
  if [ $status -eq 0 ]; then
    times >build/log/times.$1
    echo "$took $1 $(sed -n 2p build/log/times.$1)" >>build/log/seconds
    touch "build/log/$1.passed"
    printf '== %s passed in %d s\n' "$1" $took >&3
    grep -a "^budget: " "build/log/$1" >&3 || true
  else
    touch build/log/failed
    { tail -n 60 "build/log/$1"; printf '\n== %s FAILED; all of it: build/log/%s\n' "$1" "$1"; } >&3
    exit 1
  fi
}
began=$(date +%s)
exec 3>&1 >"build/log/$1" 2>&1
trap 'finish "$1"' EXIT
run "$1"
