#!/bin/sh
# figures.sh [PRESET...]             measures what queries cost, prints it, and writes tests/figures/budgets.csv
#                                    and the pages that show it
# figures.sh --check [PRESET...]     measures and prints, and fails if a budget is not kept
# figures.sh --print [PRESET...]     prints what the tests left in the build folders
# figures.sh --trees [PRESET]        whole queries on trees of other leaf sizes and arities: the table of
#                                    lib/docs/decisions.md; default: Cortex-M4F
# figures.sh --prepare               makes build/figures, which builds are given to measure a robot:
#                                    cmake --preset cortex-m4f -DFLASHBVH_KR5_FIGURES="$PWD/build/figures"
#
# PRESET: of CMakePresets.json; all boards by default. budgets.csv holds the figures that it names; to hold
# another one, add a row with its name. Installs what is missing.
set -eu
cd "$(dirname "$0")/.."
. tools/packages.sh
. tools/kr5.sh

mode=write
case ${1:-} in
  --check | --print | --prepare | --trees) mode=${1#--}; shift ;;
  -*) sed -n '2,12s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
esac
case $mode in
  print) urdf= ;;
  prepare) ensure_packages $host_packages ;;
  *) ensure_packages $host_packages $board_packages $riscv_packages $measure_packages ;;
esac
[ $mode = print ] || fetch_kr5 build/kr5
# FLASHBVH_NATIVE: the preset of the host program that bakes.
exec python3 -B tests/figures/figures.py measure $mode "$urdf" "${FLASHBVH_NATIVE:-native}" "$@"
