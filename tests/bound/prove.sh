#!/bin/sh
# prove.sh OUTPUT CORE ARCHITECTURE OBJDUMP PROGRAM
#
# Finds what a run of a query can cost at worst in the machine code of PROGRAM, the firmware of this
# folder, and writes it to OUTPUT: see bound.awk. CORE: its name; ARCHITECTURE: arm or riscv.
set -eu
[ $# -eq 5 ] || { sed -n '2,5s/^# \{0,1\}//p' "$0" >&2; exit 2; }
here=$(dirname "$0")
output=$1 core=$2 architecture=$3 objdump=$4 program=$5
trap 'rm -f "$output.dis" "$output.paths" "$output.table" "$output.new"' EXIT
# Else binutils 2.40 does not know the conditional selects of Armv8.1-M.
[ "$architecture" != arm ] || objdump="$objdump -m armv8.1-m.main"
# shellcheck disable=SC2086
$objdump -dl --no-show-raw-insn "$program" >"$output.dis"
longest() {
  table=$1
  shift
  sh "$here/longest_path.sh" "$architecture" "$table" "$here/../.." "$output.dis" "$@"
}
longest "$here/loops.txt" '6Ranked.*3run.*17TranslatedOverlap' '6Ranked.*3run.*11RotatedTest' \
  next_triangles_intersect '^bound_run$' '^bound_make_query$' >"$output.paths"
# Triangles in general position: what is for those in one plane and those without area, apart.
{
  cat "$here/loops.txt"
  echo "apart 9flat_meet"
  echo "apart 13segment_meets"
} >"$output.table"
longest "$output.table" next_triangles_intersect | sed 's/^/general_/' >>"$output.paths"
{
  echo "core $core"
  awk -f "$here/bound.awk" "$output.paths"
} >"$output.new"
mv "$output.new" "$output"
cat "$output"
