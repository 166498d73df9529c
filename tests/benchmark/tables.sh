#!/bin/sh
# tables.sh [RESULTS...]
#
# The results of the firmware benchmark as Markdown, the cores side by side. RESULTS are what run.sh
# wrote, one file a core; by default those of the three boards' builds, after
#     cmake --workflow --preset cortex-m0    (and cortex-m3, cortex-m4f)
# Fails if the cores' counts of iterations or overlaps differ.
set -eu
here=$(dirname "$0")
if [ $# -eq 0 ]; then
  build=$here/../../build
  set -- "$build/cortex-m0/benchmark.txt" "$build/cortex-m3/benchmark.txt" \
    "$build/cortex-m4f/benchmark.txt"
fi
for results; do
  if [ ! -r "$results" ]; then
    echo "tables.sh: no results in $results: run the benchmark first" >&2
    exit 2
  fi
done
exec awk -f "$here/fields.awk" -f "$here/markdown.awk" -f "$here/tables.awk" "$@"
