# Sourced by every script. ROOT: the repository, PACKAGES: the folder that tools/release.sh made, FLASHBVH: the host
# program, WORK: this script's folder.
set -eu
rm -rf "$WORK"
mkdir -p "$WORK"
cd "$WORK"

fail() {
  echo "FAILED: $*" >&2
  [ ! -r log ] || tail -n 40 log >&2
  exit 1
}

# quietly COMMAND...: sends its output to a log, and shows the log if it fails.
quietly() {
  "$@" >log 2>&1 || fail "$*"
}

warnings="-Wall -Wextra -Wconversion -Wshadow -Wdouble-promotion -Werror -Wno-sign-conversion"

# A Cortex-M4F on which QEMU runs programs with a linked package: ports/boards/mps2-an386.
cpu="-mthumb -mcpu=cortex-m4 -mfpu=fpv4-sp-d16 -mfloat-abi=hard"
machine="--specs=nano.specs -nostartfiles -ffunction-sections -fdata-sections -fno-exceptions -fno-rtti"
machine="$machine -fno-threadsafe-statics -Wl,--gc-sections -Wl,--no-warn-rwx-segments"
machine="$machine -T$ROOT/ports/common/sections.ld -Wl,--defsym=__flash=0 -Wl,--defsym=__flash_size=4M"
machine="$machine -Wl,--defsym=__ram=0x20000000 -Wl,--defsym=__ram_size=4M"
board_sources="$ROOT/ports/cortex-m/startup.cpp $ROOT/ports/common/start.cpp $ROOT/ports/common/stack.cpp
  $ROOT/ports/common/text.cpp"
board_includes="-I$ROOT/ports/common -I$ROOT/ports/cortex-m"

# shown SECTION: prints the page's command lines of this section.
shown() {
  sed -n "/^## $1\$/,/^## /s/^    //p" "$ROOT/lib/docs/packages.md" | sed 's/arm\.stl/plate.obj/; s/gripper\.obj/peg.obj/'
}

on_board() {
  FLASHBVH_TIMEOUT=120 "$ROOT/ports/run" mps2-an386 "$1" >answer || fail "$1 ended with $?: $(cat answer)"
}

# is_expected NAME: each line of `answer` must match the regular expression on the same line of `expected`.
is_expected() {
  [ "$(wc -l <answer)" -eq "$(wc -l <expected)" ] || fail "$1: $(cat answer)"
  paste -d '\n' expected answer | while read -r line && read -r said; do
    expr "x$said" : "x$line\$" >/dev/null || fail "$1 says '$said', not '$line'"
  done
}

# same_digest PROGRAM [RUN]: the program must exit with 0, that is, print the digest of every core.
same_digest() {
  ${2:-} "$1" >answer || fail "another digest: $(cat answer)"
  grep -q "^3584 queries" answer || fail "no digest"
}
