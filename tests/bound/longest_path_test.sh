#!/bin/sh
# longest_path.sh finds the longest path of code that is known, and refuses what has none.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$WORK"
mkdir -p "$WORK"
cd "$WORK"

fail() {
  echo "FAILED: $*" >&2
  exit 1
}

printf 'int f(void)\nfor (i)\n  for (j)\nvisit\nascend\n' >source.c
: >none

# code CORE TEXT: a function f at 0; a line a text, "ADDRESS: MNEMONIC OPERANDS" or "/source.c:N".
code() {
  core=$1
  printf '00000000 <f>:\n' >code.dis
  printf '%s\n' "$2" | sed 's/^ *//' | awk -F '|' '
    /^\// || /^[0-9a-f]+ </ { print; next }
    { sub(/ /, "\t", $2); print "  " $1 ":\t" $2 }' >>code.dis
}

# longest NAME WANTED TABLE
longest() {
  sh "$here/longest_path.sh" "$core" "$3" . code.dis '^f$' >found 2>errors ||
    fail "$1: $(cat errors)"
  [ "$(cut -d ' ' -f 2- found)" = "$2" ] || fail "$1: $(cat found), not $2"
}

# refused NAME WHAT TABLE
refused() {
  if sh "$here/longest_path.sh" "$core" "$3" . code.dis '^f$' >found 2>errors; then
    fail "$1: not refused: $(cat found)"
  fi
  grep -qF -- "$2" errors || fail "$1: no '$2' in: $(cat errors)"
}

# shellcheck source=tests/bound/known_arm.sh
. "$here/known_arm.sh"
# shellcheck source=tests/bound/known_riscv.sh
. "$here/known_riscv.sh"
# shellcheck source=tests/bound/known_loops.sh
. "$here/known_loops.sh"
