#!/bin/sh
# prove.sh OUTPUT CUTS CORE ARCHITECTURE OBJDUMP PROGRAM
#
# Finds what a run of a query can cost at worst in the machine code of PROGRAM, the firmware of this
# folder, and writes it to OUTPUT: see bound.awk. Where loops were cut goes to CUTS: see turns.sh.
# CORE: its name; ARCHITECTURE: arm or riscv.
set -eu
[ $# -eq 6 ] || { sed -n '2,6s/^# \{0,1\}//p' "$0" >&2; exit 2; }
here=$(dirname "$0")
output=$1 cuts=$2 core=$3 architecture=$4 objdump=$5 program=$6
trap 'rm -f "$output.dis" "$output.paths" "$output.table" "$output.general" "$output.new"' EXIT
# Else binutils 2.40 does not know the conditional selects of Armv8.1-M.
[ "$architecture" != arm ] || objdump="$objdump -m armv8.1-m.main"
# shellcheck disable=SC2086
$objdump -dl --no-show-raw-insn "$program" >"$output.dis"

longest() {  # TABLE FUNCTION...
  table=$1
  shift
  sh "$here/longest_path.sh" "$architecture" "$table" "$here/../.." "$output.dis" "$@"
}

export CUTS=1
longest "$here/loops.txt" '6Ranked.*3run.*17TranslatedOverlap' '6Ranked.*3run.*11RotatedTest' \
  next_triangles_intersect '^bound_run$' '^bound_make_query$' >"$output.paths"
{
  grep '^cut ' "$output.paths"
  sed -n 's/^0*\([0-9a-f]*\) <\(bound_[a-z_]*\)>:$/symbol \1 \2/p' "$output.dis"
} >"$cuts"
unset CUTS
# Triangles in general position: what is for those in one plane and those without area, apart.
{
  cat "$here/loops.txt"
  echo "apart 9flat_meet"
  echo "apart 13segment_meets"
} >"$output.table"
longest "$output.table" next_triangles_intersect >"$output.general"
sed 's/^/general_/' "$output.general" >>"$output.paths"

echo "core $core" >"$output.new"
awk -f "$here/bound.awk" "$output.paths" >>"$output.new"
mv "$output.new" "$output"
cat "$output"
