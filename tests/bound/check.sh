#!/bin/sh
# check.sh BOUND MACHINE PROGRAM
#
# Runs the firmware of this folder under QEMU and holds what it measures against what prove.sh wrote
# to BOUND. Fails if a run takes more than was proven, or if the bounds are so far off that a wrong
# one would not be noticed.
set -eu
[ $# -eq 3 ] || { sed -n '2,6s/^# \{0,1\}//p' "$0" >&2; exit 2; }
here=$(dirname "$0")
[ -r "$1" ] || { echo "check.sh: no bounds in $1: run the test that proves them first" >&2; exit 2; }
trap 'rm -f "$1.measured"' EXIT
FLASHBVH_TIMEOUT=120 "$here/../../ports/run" "$2" "$3" >"$1.measured" ||
  { echo "check.sh: the firmware failed with status $?" >&2; exit 1; }
awk -f "$here/check.awk" "$1" "$1.measured"
