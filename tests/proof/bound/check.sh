#!/bin/sh
# check.sh BOUND MEASURED MACHINE PROGRAM
#
# Runs the firmware of this folder under QEMU and holds what it measures against what prove.py wrote
# to BOUND; see check.awk. What was measured goes to MEASURED, too. Fails if a run takes more than
# was proven.
set -eu
[ $# -eq 4 ] || { sed -n '2,6s/^# \{0,1\}//p' "$0" >&2; exit 2; }
here=$(dirname "$0")
[ -r "$1" ] || { echo "check.sh: no bounds in $1: run the test that proves them first" >&2; exit 2; }
trap 'rm -f "$2.runs"' EXIT
FLASHBVH_TIMEOUT=120 "$here/../../../ports/run" "$3" "$4" >"$2.runs" ||
  { echo "check.sh: the firmware failed with status $?" >&2; exit 1; }
status=0
awk -f "$here/formula.awk" -f "$here/check.awk" "$1" "$2.runs" >"$2" || status=$?
cat "$2"
exit $status
