#!/bin/sh
# lint.sh          clang-tidy on the library and the host program.
# lint.sh --deep   The analyzer takes as many steps a function as it usually does. On the host program
#                  most of them go into the insides of the standard library.
set -eu
cd "$(dirname "$0")/.."
texts=build/lint
rm -rf $texts
mkdir -p $texts
steps=20000
[ "${1:-}" != --deep ] || steps=225000
status=0

# lint NAME SOURCE...    The sources as one text, since they include the same headers; what is found is
# said by source and line.
lint() {
  text=$texts/$1.cpp
  shift
  cat "$@" >"$text"
  # shellcheck disable=SC2046
  clang-tidy --quiet --config-file=.clang-tidy "$text" -- -std=c++17 -Wno-unknown-warning-option \
    -Xclang -analyzer-config -Xclang max-nodes=$steps -Ilib/include -Itools \
    $(printf '%s\n' "$@" | sed 's#/[^/]*$##; s/^/-I/' | sort -u) >"$text.found" || status=1
  awk -v text="$text:" '
    FILENAME != found { if (FNR == 1) { source[++n] = FILENAME; before[n] = lines } ++lines; next }
    at = index($0, text) {
      split(substr($0, at + length(text)), where, ":")
      for (i = n; before[i] >= where[1]; --i);
      $0 = source[i] ":" where[1] - before[i] substr($0, at + length(text where[1]))
    }
    { print }' found="$text.found" "$@" "$text.found"
}

lint lib lib/src/*/*.cpp
for room in tools/*/; do
  room=$(basename "$room")
  # tools/compare wants the headers of the libraries that it compares; tools/release has no source.
  [ "$room" = compare ] || [ "$room" = release ] || lint "$room" "tools/$room"/*.cpp
done
exit $status
