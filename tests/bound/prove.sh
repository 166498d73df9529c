#!/bin/sh
# prove.sh OUTPUT CORE OBJDUMP PROGRAM
#
# Finds what a run of a query can cost at worst in the machine code of PROGRAM, the firmware of this
# folder, and writes it to OUTPUT: see bound.awk. CORE: arm or riscv.
set -eu
[ $# -eq 4 ] || { sed -n '2,5s/^# \{0,1\}//p' "$0" >&2; exit 2; }
here=$(dirname "$0")
output=$1 core=$2 objdump=$3 program=$4
trap 'rm -f "$output.dis" "$output.paths" "$output.new"' EXIT
# Else binutils 2.40 does not know the conditional selects of Armv8.1-M.
[ "$core" != arm ] || objdump="$objdump -m armv8.1-m.main"
# shellcheck disable=SC2086
$objdump -dl --no-show-raw-insn "$program" >"$output.dis"
sh "$here/longest_path.sh" "$core" "$here/loops.txt" "$here/../.." "$output.dis" \
  '6Ranked.*3run.*17TranslatedOverlap' '6Ranked.*3run.*11RotatedTest' next_triangles_intersect \
  '^bound_run$' '^bound_make_query$' >"$output.paths"
awk -f "$here/bound.awk" "$output.paths" >"$output.new"
mv "$output.new" "$output"
cat "$output"
