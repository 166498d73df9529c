#!/bin/sh
# lint.sh          clang-tidy on the library and the host program.
# lint.sh --deep   Also what takes two thirds of the time and has found little: on the host program the
#                  analyzer, most of whose steps go into the insides of the standard library,
#                  performance-unnecessary-value-param and bugprone-stringview-nullptr, and
#                  bugprone-reserved-identifier, most of which readability-identifier-naming finds;
#                  on the library as many of the analyzer's steps a function as it usually takes.
set -eu
cd "$(dirname "$0")/.."
texts=build/lint
rm -rf $texts
mkdir -p $texts
steps=20000
expensive=-clang-analyzer-*,-performance-unnecessary-value-param
expensive=$expensive,-bugprone-stringview-nullptr,-bugprone-reserved-identifier
[ "${1:-}" != --deep ] || { steps=225000; expensive=; }
status=0

# lint NAME CHECKS SOURCE...    checks the sources as one text, because they include the same headers;
# reports findings by source and line.
lint() {
  text=$texts/$1.cpp
  checks=$2
  shift 2
  cat "$@" >"$text"
  # shellcheck disable=SC2046
  clang-tidy --quiet --config-file=.clang-tidy --checks="$checks" "$text" -- -std=c++17 \
    -Wno-unknown-warning-option -Xclang -analyzer-config -Xclang max-nodes=$steps -Ilib/include -Itools -Itests -I$texts \
    $(printf '%s\n' "$@" | sed 's#/[^/]*$##; s/^/-I/' | sort -u) >"$text.found" || status=1
  python3 tools/lint_places.py "$text" "$@" <"$text.found"
}

lint lib "" lib/src/*/*.cpp
# Components whose names do not clash are checked together: the standard library's headers are half of the work.
# Sources that replace others, where there are no processes, are checked separately.
instead=tools/mesh/import_here.cpp
lint bakes "$expensive" $(printf '%s\n' tools/text/*.cpp tools/mesh/*.cpp tools/bake/*.cpp tools/image/*.cpp \
  tools/robot/*.cpp tools/robot/*/*.cpp | grep -vxF "$(printf '%s\n' $instead)")
lint instead "$expensive" $instead
lint cli "$expensive" tools/cli/*.cpp tools/cli/*/*.cpp tools/evaluate/*.cpp
for room in tools/*/; do
  case $(basename "$room") in
    bake | cli | evaluate | image | mesh | robot | text) ;;
    # tools/compare needs the headers of OPCODE; tools/npm has no source.
    compare | npm | python) ;;
    viewer) lint viewer "$expensive" tools/viewer/live_section.cpp ;; # arm.cpp is for another machine
    *) lint "$(basename "$room")" "$expensive" "$room"*.cpp ;;
  esac
done
exit $status
