#!/bin/sh
# figures.sh [PRESET...]           measures what calls cost, writes tests/figures/budgets.csv, its page, and the proven
#                                  constants of the library
# figures.sh --check [PRESET...]   measures, and fails if a budget is not kept
# figures.sh --prepare             makes build/figures, a robot's links, which builds are given to measure them:
#                                  cmake --preset cortex-m4f -DFLASHBVH_KR5_FIGURES="$PWD/build/figures"
#
# PRESET: native cortex-m4f cortex-m0 cortex-m3 rv32imac by default. To hold another figure that a program prints, add a
# row with its name to budgets.csv. Installs what is missing.
set -eu
cd "$(dirname "$0")/.."
. tools/packages.sh
. tools/quietly.sh
. tools/kr5.sh

mode=write
case ${1:-} in
  --check | --prepare) mode=${1#--}; shift ;;
  -*) sed -n '2,9s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
esac
native=${FLASHBVH_NATIVE:-native} # the preset of the host program that bakes
folder=$PWD/build/figures
quiet_log=$PWD/build/figures.log
figures() {
  python3 -B tests/figures/figures.py "$@"
}

ensure_packages $host_packages
mkdir -p "$folder"
fetch_kr5 build/kr5
quietly cmake --preset "$native"
quietly cmake --build --preset "$native" --target flashbvh_tool
flashbvh=$PWD/build/$native/bin/flashbvh
quietly "$flashbvh" bake "$kr5/bicep.STL" "$kr5/forearm.STL" "$kr5/palm.STL" "$kr5/wrist.STL" -o "$folder"
# Without the neighbours that can collide: the motions avoid contact of all other pairs.
quietly "$flashbvh" robot "$urdf" --zone shoulder_pitch=0.15 --name kr5_arm -o "$folder/robot"
[ $mode != prepare ] || exit 0

ensure_packages $board_packages $riscv_packages $measure_packages
[ $# -gt 0 ] || set -- native cortex-m4f cortex-m0 cortex-m3 rv32imac
outputs=
for preset; do
  echo "Measuring $preset"
  quietly cmake --preset "$preset" -DFLASHBVH_HOST_TOOL="$flashbvh" -DFLASHBVH_KR5_FIGURES="$folder"
  quietly cmake --build --preset "$preset" --target figures
  quietly ctest --preset "$preset" -R "figures: measured|memory: (code|stack) of|bound: no run takes more"
  outputs="$outputs build/$preset/figures.txt build/$preset/memory_code.txt build/$preset/memory_stack.txt"
  outputs="$outputs build/$preset/bound_measured.txt"
  [ $mode = check ] || [ ! -e "build/$preset/bound.txt" ] ||
    python3 -B proofs/time/shipped.py "build/$preset/bound.txt" lib/include/flashbvh/plain --write
done
[ $mode = check ] || figures write $outputs
figures check $outputs
figures page --check
