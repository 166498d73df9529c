#!/bin/sh
# code_size.sh PROGRAM LIMIT: the bytes that one question links, the caller's own code included, at
# -Os and, for comparison, at -O2. LIMIT is for -Os; 0 is none.
#
# Linked with nothing but the library, libgcc and the memory functions of libc, from `entry` on.
set -eu
program=$1
limit=$2
mkdir -p "$WORK"

# bytes_at LEVEL
bytes_at() {
  elf=$WORK/$program$1.elf
  $COMPILER $1 -std=c++17 -ffunction-sections -fdata-sections -fno-exceptions -fno-rtti \
    -I"$SOURCE/lib/include" "$SOURCE/tests/budget/code_size/$program.cpp" "$SOURCE"/lib/src/*.cpp \
    -nostartfiles -Wl,--gc-sections -Wl,-e,entry -o "$elf" 2>"$WORK/log" ||
    { cat "$WORK/log" >&2; exit 1; }
  # Code and constants; neither data nor tables of exceptions may be there.
  $SIZE -A "$elf" | awk '
    $1 ~ /^\.(text|rodata)/ { bytes += $2 }
    $1 ~ /^\.(data|bss)/ && $2 > 0 { print "data" ; exit }
    END { print bytes }'
}

small=$(bytes_at -Os)
fast=$(bytes_at -O2)
allowed=
[ "$limit" -eq 0 ] || allowed=" (at most $limit)"
echo "budget: code of $program: $small bytes at -Os$allowed, $fast at -O2"
[ "$small" -gt 100 ] || { echo "code_size.sh: that is no program" >&2; exit 1; }
[ "$limit" -eq 0 ] || [ "$small" -le "$limit" ]
