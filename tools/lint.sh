#!/bin/sh
# lint.sh [FILE...]    clang-tidy on the library and the host program, or on the sources whose paths match these regular
#                      expressions. Needs the build of the preset native-sanitize, whose unity sources check a room of
#                      the program at once.
set -eu
cd "$(dirname "$0")/.."
# lint CHECKS FILE...
lint() {
  checks=$1
  shift
  run-clang-tidy -quiet -p build/native-sanitize -checks="$checks" -j "$(nproc)" \
    -extra-arg=-Wno-unknown-warning-option -extra-arg=-Xclang -extra-arg=-analyzer-config -extra-arg=-Xclang \
    -extra-arg=max-nodes=20000 "$@"
}
# A unity source includes sources.
[ $# -eq 0 ] || { lint -bugprone-suspicious-include "$@"; exit; }
lint "" '/lib/src/'
# These take two thirds of the time and find little in the program: most of the analyzer's steps go into the standard
# library.
expensive=-clang-analyzer-*,-performance-unnecessary-value-param,-bugprone-stringview-nullptr
lint "$expensive,-bugprone-reserved-identifier,-bugprone-suspicious-include" '/tools/'
