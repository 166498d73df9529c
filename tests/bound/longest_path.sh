#!/bin/sh
# longest_path.sh ARCHITECTURE TABLE ROOT DISASSEMBLY FUNCTION...
#
# Prints for each function (a regular expression that one symbol of the disassembly matches) the
# most instructions that a call can execute, whatever its input:
#   FUNCTION SUM = fixed N [KIND COUNT*N | KIND N]...
# SUM leaves out the kinds whose count the table leaves open: to it comes N for each of them.
# Fails, and says where, if it meets anything that it doesn't understand: an indirect branch, a
# recursive call, a loop that the table doesn't bound.
#
# ARCHITECTURE: arm or riscv. DISASSEMBLY: of the linked program, by objdump -dl --no-show-raw-insn.
# ROOT: the folder that the table's files lie in. TABLE has lines
#   cut FUNCTION KIND COUNT FILE TEXT   In functions that match, an instruction of a line of FILE
#                                       that holds TEXT is executed at most COUNT times a call ("-":
#                                       left open). With "-" for FILE, TEXT is a mnemonic: for code
#                                       without lines.
#   apart FUNCTION                      Calls of it count as the call alone.
#
# CUTS=1   prints where loops were cut, too: cut ADDRESS FUNCTION'S-ADDRESS KIND COUNT, -1: left open
set -eu
[ $# -ge 5 ] || { sed -n '2,20s/^# \{0,1\}//p' "$0" >&2; exit 2; }
here=$(dirname "$0")
architecture=$1 table=$2 root=$3 disassembly=$4
shift 4
# Not by -v: awk would take the backslashes of the expressions.
FUNCTIONS="$*" exec awk -v table="$table" -v root="$root" -f "$here/disassembly.awk" \
  -f "$here/$architecture.awk" -f "$here/table.awk" -f "$here/longest_path.awk" "$disassembly"
