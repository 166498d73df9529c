#!/bin/sh
# code_size.sh ROOTS OUTPUT: the bytes that each query links, its entry's own code included, at -Os
# and -O2.
#
# Linked with nothing but the library, libgcc and the memory functions of C's library, from the
# entry on. LINK is compiler and flags, LIBRARIES what comes last; ARCHIVE_OS and ARCHIVE_O2 hold
# the entries and the library at the two levels.
set -eu
roots=$1
output=$2
rm -f "$output"

# bytes_of ENTRY ARCHIVE
bytes_of() {
  # Words of flags.
  # shellcheck disable=SC2086
  $LINK -Wl,-e,"$1" -Wl,-u,"$1" "$2" $LIBRARIES -o "$output.elf" 2>"$output.log" ||
    { cat "$output.log" >&2; exit 1; }
  # Code and constants; neither data nor tables of exceptions may be there.
  "$SIZE" -A "$output.elf" | awk '
    $1 ~ /^\.s?(text|rodata)/ { bytes += $2 }
    $1 ~ /^\.s?(data|bss)/ && $2 > 0 { print "data"; exit }
    END { print bytes }'
}

while read -r entry; do
  small=$(bytes_of "$entry" "$ARCHIVE_OS")
  fast=$(bytes_of "$entry" "$ARCHIVE_O2")
  [ "$small" -gt 20 ] || { echo "code_size.sh: $entry is no program" >&2; exit 1; }
  echo "budget: code of $entry: $small bytes at -Os, $fast at -O2" >&2
  echo "code $entry Os $small"
  echo "code $entry O2 $fast"
done <"$roots" >"$output.new"
mv "$output.new" "$output"
