#!/bin/sh
# test.sh           Everything that has to hold before a change is one: formatting, lint, and all tests,
#                   natively with sanitizers, on each board under QEMU, and as WebAssembly in node.
# test.sh --quick   What most changes of the library break: formatting, the library's tests on this
#                   machine without sanitizers, answers and arithmetic on a Cortex-M4F.
# test.sh --all     Also a plain RV32IM; on every board all tests that fit it, which
#                   otherwise run natively and on the Cortex-M4F (on a Cortex-M0 what a core has of
#                   its own: answers, arithmetic, stack, bounds, figures; of the others answers and
#                   arithmetic); random tests with all their tries, compilers in all ways, libFuzzer;
#                   builds of others that build the host program; a deeper lint.
#
# A step (tools/test_step.sh) a core, side by side; what each prints is in build/log. Says at the end
# where the minutes went. Installs what is missing.
set -eu
cd "$(dirname "$0")/.."
. tools/packages.sh

host_steps="tool lint native long python"
cores= list=--steps at_once=$(nproc)
packages="$riscv_packages $wasm_packages $digest_packages $python_packages clang-tidy"
case ${1:-} in
  "") ;;
  --quick) host_steps=library cores=netduinoplus2 packages= at_once=1
    export FLASHBVH_QUICK=ON ;;
  --all) list=--all
    export FLASHBVH_ALL_TESTS=ON FLASHBVH_THOROUGH=yes FLASHBVH_DEEP_LINT=yes ;;
  *) sed -n '2,10s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
esac
ensure_packages $host_packages $sanitizer_packages $oracle_packages $board_packages $packages $test_packages

# The cache avoids repeated compilations by boards of one core and tests that build the library.
export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
export CCACHE_DIR="$PWD/build/ccache" CCACHE_BASEDIR="$PWD" CCACHE_NOHASHDIR=1 CCACHE_DEPEND=1
export CCACHE_SLOPPINESS=include_file_ctime,pch_defines,time_macros

[ -n "$cores" ] || cores=$(tools/cores.py $list)

began=$(date +%s)
rm -rf build/log
mkdir -p build/log
echo formatting configured | xargs -n 1 -P "$(nproc)" tools/test_step.sh
# The longest steps start first, so that none is left over at the end. All wait for `tool` except lint, which keeps
# the other core busy while `tool` bakes.
echo $host_steps $cores | xargs -n 1 -P "$at_once" tools/test_step.sh
python3 - "$(($(date +%s) - began))" "$(nproc)" <<'PYTHON'
import sys
def seconds_in(time):
    minutes, seconds = time.rstrip("s").split("m")
    return 60 * int(minutes) + float(seconds)

steps = [(took, sum(map(seconds_in, times)), name) for took, name, *times in map(str.split, open("build/log/seconds"))]
row = "{:7.1f}  {:9.1f}  {}".format
print("\nminutes  computing  step")
for took, computed, name in steps:
    print(row(float(took) / 60, float(computed) / 60, name))
print(row(int(sys.argv[1]) / 60, sum(float(step[1]) for step in steps) / 60, f"in all, on {sys.argv[2]} cores"))
print("\n== All tests passed")
PYTHON
