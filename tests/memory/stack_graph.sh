#!/bin/sh
# stack_graph.sh PROGRAM ROOTS FOLDER OUTPUT: the worst-case stack of the functions listed in the
# file ROOTS, by call graph, with the path that takes it.
#
# PROGRAM is linked of objects that were compiled with -fcallgraph-info=su; what that wrote lies in
# FOLDER. NM and OBJDUMP are the board's, TAGS says what its core is
# (budgets.txt). All paths are absolute.
set -eu
program=$1
roots=$2
folder=$3
output=$4
here=$(dirname "$0")

"$NM" "$program" >"$output.nm"
"$OBJDUMP" -d "$program" >"$output.code"
awk -f "$here/frames.awk" "$output.nm" "$output.code" >"$output.frames"
cd "$folder"
find . -name '*.ci' | sort >"$output.ci"
[ -s "$output.ci" ] || { echo "stack_graph.sh: no call graph in $folder" >&2; exit 1; }
# Within the folder, no name has blanks.
# shellcheck disable=SC2046
awk -v tags="$TAGS" -f "$here/stack_graph.awk" "$roots" "$here/calls.txt" "$output.frames" \
  $(cat "$output.ci") >"$output.new" || { rm -f "$output"; exit 1; }
cat "$output.new"
mv "$output.new" "$output"
