#!/bin/sh
# painted.sh OUTPUT COMMAND...: keeps what the firmware of painted.cpp prints, if it ends well.
set -eu
output=$1
shift
rm -f "$output"
"$@" >"$output.new" || { cat "$output.new"; exit 1; }
cat "$output.new"
mv "$output.new" "$output"
