#!/bin/sh
# budget.sh RESULTS FIGURE LIMIT
#
# Prints a figure of the firmware benchmark and its budget; fails if the budget is not kept.
# RESULTS is what run.sh wrote. FIGURE is one of
#   per-visit=NAME   instructions of algorithm NAME per visit, over the setups of more than ten visits
#   of-volume-stack  instructions of `ranked` as part of those of `volume-stack`, in each setup of
#                    more than ten visits
#   of-ranked-stack  instructions of `ranked` as part of those of `ranked-stack`, over the same
#   separated        instructions of a whole query on separated objects: one visit
set -eu
here=$(dirname "$0")
[ $# -eq 3 ] || { sed -n '2,12s/^# \{0,1\}//p' "$0" >&2; exit 2; }
[ -r "$1" ] || { echo "budget.sh: no results in $1: run the benchmark first" >&2; exit 2; }
exec awk -v what="$2" -v limit="$3" -f "$here/fields.awk" -f "$here/budget.awk" "$1"
