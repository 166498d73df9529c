#!/bin/sh
# with_frames.sh COMPILER ARGUMENT...
#
# Compiles, with or without ccache before the compiler. ccache restores another build's object, but not the .ci file
# that the compiler writes next to it: then compiles again.
frames= previous=
for argument; do
  [ "$previous" != -o ] || frames=${argument%.*}.ci
  previous=$argument
done
rm -f "$frames"
"$@" || exit
[ -e "$frames" ] || CCACHE_DISABLE=1 "$@"
