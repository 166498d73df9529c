#!/bin/sh
# run.sh OUTPUT MACHINE IMAGE...
#
# Runs the images of the firmware benchmark one after the other; what they print goes to OUTPUT
# and to standard output. Fails if one of them does.
set -u
[ $# -ge 3 ] || { sed -n '2,5s/^# \{0,1\}//p' "$0" >&2; exit 2; }
output=$1
machine=$2
shift 2
run=$(dirname "$0")/../../ports/run

status=0
: >"$output.new"
for image; do
  FLASHBVH_ICOUNT="${FLASHBVH_ICOUNT:-8}" FLASHBVH_TIMEOUT="${FLASHBVH_TIMEOUT:-240}" \
    "$run" "$machine" "$image" >"$output.part" || status=$?
  cat "$output.part"
  cat "$output.part" >>"$output.new"
done
rm -f "$output.part"
if [ $status -ne 0 ]; then
  rm -f "$output.new"
  echo "run.sh: the benchmark failed with status $status" >&2
  exit $status
fi
mv "$output.new" "$output"
