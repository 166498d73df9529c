#!/bin/sh
# The guide's commands, one after the other, and its Makefile, with this machine's compilers.
set -eu
rm -rf "$WORK"
mkdir -p "$WORK/firmware"
cd "$WORK/firmware"
cp "$ROOT"/firmware_examples/quick_start/*.obj .
cp "$ROOT/firmware_examples/robot_guard/cell_arm/cell_arm.urdf" "$SOURCES/guide.c" .
mv guide.c main.c
PATH=$(dirname "$FLASHBVH"):$PATH

# blocks LANGUAGE: of the guide.
blocks() {
  awk -v fence="\`\`\`$1" '$0 == "```" { inside = 0 } inside; $0 == fence { inside = 1 }' \
    "$ROOT/lib/docs/guide.md"
}

blocks sh >commands
sh -eu commands >log 2>&1 || { cat log; exit 1; }
grep -q '^ *0 .* 0$' log && grep -q '^any pose: at most' log && [ -s pairs.txt ] && [ -s report.html ] ||
  { cat log; exit 1; }

command -v make >/dev/null || exit 77
blocks make | sed s/-O2/-O0/ >Makefile  # what it says of firmware is not run here
make FLASHBVH="$ROOT" BAKE="$FLASHBVH bake" CC="${CC:-cc}" CXX="${CXX:-c++}" CPU= LDFLAGS= >log 2>&1 ||
  { tail -n 20 log; exit 1; }
./firmware.elf
