#!/bin/sh
# check.sh TAGS OUTPUT FIGURES...: check.awk over all figures, which OUTPUT gets, in lines
#     code ENTRY Os|O2 BYTES
#     stack ENTRY graph|painted BYTES
#     object NAME BYTES
# with the entries of entries.inc. Other scripts read that file.
set -eu
tags=$1
output=$2
shift 2
here=$(dirname "$0")
rm -f "$output"
awk -f "$here/check.awk" "$tags" "$here/budgets.txt" "$@" >"$output.new"
mv "$output.new" "$output"
