#!/bin/sh
# run.sh OUTPUT PROGRAM...
#
# Runs the programs of the figures, by the command in RUN if they are firmware, and gathers what they
# print (report.hpp) in OUTPUT: lines `CORE NAME VALUE`, with the core `all` for what all cores and
# this machine must agree about. Fails if a program does.
set -eu
[ $# -ge 2 ] || { sed -n '2,6s/^# \{0,1\}//p' "$0" >&2; exit 2; }
output=$1
shift

rm -f "$output"
: >"$output.new"
for program; do
  status=0
  FLASHBVH_TIMEOUT="${FLASHBVH_TIMEOUT:-240}" ${RUN:-} "$program" >"$output.part" || status=$?
  if [ $status -ne 0 ]; then
    cat "$output.part"
    echo "run.sh: $program ended with status $status" >&2
    exit 1
  fi
  awk '$1 == "core" { core = $2 }
    $1 == "figure" { print core, $2, $3 }
    $1 == "count" { print "all", $2, $3 }' "$output.part" >>"$output.new"
done
rm -f "$output.part"
mv "$output.new" "$output"
cat "$output"
