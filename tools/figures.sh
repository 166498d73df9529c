#!/bin/sh
# figures.sh [PRESET...]             measures the figures of lib/docs/figures.md anew and writes the page
# figures.sh --check [PRESET...]     measures, and fails if anything differs from the page
# figures.sh --compare [PRESET...]   compares what the tests left in the build folders, no more
# figures.sh --trees [PRESET]        whole queries on trees of other leaf sizes and arities: the table of
#                                    lib/docs/decisions/0003-trees.md; default: Cortex-M4F
# figures.sh --prepare               makes build/figures, which builds are given to measure a robot:
#                                    cmake --preset cortex-m4f -DFLASHBVH_KR5_FIGURES="$PWD/build/figures"
#
# PRESET: of CMakePresets.json; all boards unless told. What is measured goes to
# tests/figures/figures.txt, lines `CORE NAME VALUE`; the page is made of that file. Installs what is
# missing.
set -eu
cd "$(dirname "$0")/.."
. tools/packages.sh
. tools/kr5.sh

mode=write
case ${1:-} in
  --check | --compare | --prepare | --trees) mode=${1#--}; shift ;;
  -*) sed -n '2,13s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
esac
case $mode in
  compare) urdf= ;;
  prepare) ensure_packages $host_packages ;;
  *) ensure_packages $host_packages $board_packages $riscv_packages ;;
esac
[ $mode = compare ] || fetch_kr5 build/kr5
# FLASHBVH_NATIVE: the preset whose host program bakes.
exec python3 -B tests/figures/figures.py measure $mode "$urdf" "${FLASHBVH_NATIVE:-native}" "$@"
