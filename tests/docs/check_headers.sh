#!/bin/sh
# Doxygen reads the public headers' comments without a warning. Every type and every function has one;
# fields, constants and aliases may speak for themselves, and so may what an order of paper/ has, which
# is what detail/walk.hpp asks of it.
set -eu
command -v doxygen >/dev/null || exit 77
cd "$ROOT/lib/include"
rm -rf "$WORK"
mkdir -p "$WORK"
{
  cat "$SOURCES/Doxyfile"
  echo "INPUT = flashbvh flashbvh/paper flashbvh/robot $SOURCES/scopes.dox"
  echo "OUTPUT_DIRECTORY = $WORK"
} | doxygen - >"$WORK/log" 2>&1 || true
[ -s "$WORK/xml/classflashbvh_1_1Pose.xml" ] || { cat "$WORK/log"; exit 1; }
! grep -Ev '\((variable|typedef|macro definition)\) .* is not documented|/paper/.*: Member .* of (class|struct) .* is not documented' \
  "$WORK/log"
