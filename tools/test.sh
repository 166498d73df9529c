#!/bin/sh
# test.sh          The library and the program on this machine; the digests of all answers on a Cortex-M4F, a Cortex-M0
#                  and an RV32IMAC under QEMU.
# test.sh --all    With sanitizers and fuzzers' corpora. Also style, lint, long tests, the Python package, all boards of
#                  ports/cores.json with their tests, WebAssembly; figures, stacks and bounds of two cores.
#
# Steps (tools/test_step.sh) run side by side; build/log has what each prints. Installs what is missing.
set -eu
cd "$(dirname "$0")/.."
. tools/packages.sh

packages="$host_packages $test_packages"
case ${1:-} in
  "") first="native digests" then= ;;
  --all)
    first="native style $(tools/cores.py --answers)"
    then="lint long python $(tools/cores.py --measured)"
    packages="$packages $board_packages $riscv_packages $style_packages $wasm_packages $digest_packages $page_packages"
    packages="$packages $python_packages $measure_packages ccache"
    export FLASHBVH_TEST_ALL=yes
    # The cache avoids repeated compilations by boards of one core and tests that build the library.
    export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
    export CCACHE_DIR="$PWD/build/ccache" CCACHE_BASEDIR="$PWD" CCACHE_NOHASHDIR=1 CCACHE_DEPEND=1
    export CCACHE_SLOPPINESS=include_file_ctime,pch_defines,time_macros ;;
  *) sed -n '2,7s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
esac
ensure_packages $packages

rm -rf build/log
mkdir -p build/log
# The steps of `then` need what `native` builds. xargs starts no step after one that failed.
for steps in "$first" "$then"; do
  [ -z "$steps" ] || echo $steps | xargs -n 1 -P "$(nproc)" tools/test_step.sh
done
echo "== All tests passed"
