#!/bin/sh
# turns.sh CUTS MACHINE PROGRAM
#
# Follows the firmware of this folder instruction by instruction where prove.py cut the loops, and
# fails if one is executed more often than loops.txt says, in a call or in a run: see turns.awk.
# CUTS: what prove.py wrote.
set -eu
[ $# -eq 3 ] || { sed -n '2,6s/^# \{0,1\}//p' "$0" >&2; exit 2; }
here=$(dirname "$0")
cuts=$1
trap 'rm -f "$cuts.runs" "$cuts.trace"' EXIT
filter=$(awk '{ print $2 } $1 == "cut" { print $3 }' "$cuts" | sort -u | sed 's/.*/0x&+1/' |
  paste -s -d , -)
# One instruction a block, each block logged.
FLASHBVH_QEMU_OPTIONS="-singlestep -d exec,nochain -dfilter $filter -D $cuts.trace" \
  FLASHBVH_TIMEOUT=240 "$here/../../../ports/run" "$2" "$3" >"$cuts.runs" ||
  { echo "turns.sh: the firmware failed with status $?" >&2; exit 1; }
awk -f "$here/turns.awk" "$cuts" "$cuts.runs" "$cuts.trace"
