#!/bin/sh
# The digest on this machine: by each compiler that is here, unoptimised and optimised, with 64 and
# 32 bits; with FLASHBVH_THOROUGH each of them in each way, with vector instructions and without, on x86
# and Arm. Every program must print the same and end with 0.
set -eu
cd "$SOURCE"
mkdir -p "$WORK"
failed=0
programs=0
emulator=

# one_source SOURCE...    It takes half the time, and the library is to bear it.
one_source() {
  printf '#include "%s"\n' "$@" tests/digest/*.cpp
}
one_source lib/src/*/*.cpp >"$WORK/all.cpp"
# What the digest is of.
one_source lib/src/box/*.cpp lib/src/geometry/*.cpp lib/src/image/*.cpp \
  lib/src/query/[!s]*.cpp lib/src/query/solid.cpp >"$WORK/needed.cpp"

# digest COMPILER OPTION...    Unoptimised, the whole library.
digest() {
  program=$WORK/digest_$programs
  text=needed
  case " $* " in *" -O0 "*) text=all ;; esac
  "$@" -std=c++17 -Wall -Wextra -Werror -I. -Ilib/include -Itests "$WORK/$text.cpp" \
    -o "$program" || { echo "compilers.sh: does not build: $*" >&2; exit 1; }
  programs=$((programs + 1))
  if answer=$($emulator "$program"); then
    echo "$answer: $*"
  else
    echo "DIFFERENT $answer: $*"
    failed=1
  fi
}

thorough() { [ -n "${FLASHBVH_THOROUGH:-}" ]; }

portable=
for compiler in g++ clang++; do
  if ! command -v $compiler >/dev/null; then
    echo "no $compiler here"
    continue
  fi
  if ! thorough; then
    # shellcheck disable=SC2086
    digest $compiler -O0 $portable
    digest $compiler -O2
    portable=-DFLASHBVH_PORTABLE
    continue
  fi
  digest $compiler -O0
  digest $compiler -O0 -DFLASHBVH_PORTABLE
  digest $compiler -O3
  digest $compiler -O3 -march=native
done
! thorough || digest g++ -O3 -DFLASHBVH_PORTABLE
# A compiler for 32 bits, whose programs an x86-64 kernel runs.
if command -v i686-linux-gnu-g++ >/dev/null && [ "$(uname -m)" = x86_64 ]; then
  digest i686-linux-gnu-g++ -static -O0
  ! thorough || digest i686-linux-gnu-g++ -static -O3 -msse2 -mfpmath=sse
else
  echo "no compiler for 32 bits here"
fi
# NEON, on an emulated core.
if ! thorough; then
  echo "the other ways: FLASHBVH_THOROUGH=1 ctest --preset native-sanitize -R compiler"
elif command -v aarch64-linux-gnu-g++ >/dev/null && command -v qemu-aarch64-static >/dev/null; then
  emulator=qemu-aarch64-static
  digest aarch64-linux-gnu-g++ -static -O3
else
  echo "no 64-bit Arm here"
fi
[ $programs -ge 3 ] || { echo "compilers.sh: hardly a compiler was found" >&2; exit 1; }
exit $failed
