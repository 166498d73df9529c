#!/bin/sh
# lint.sh    clang-tidy on the library and the host program; wants a configured build/native-sanitize.
set -eu
cd "$(dirname "$0")/.."
texts=build/lint
rm -rf $texts
mkdir -p $texts
quietly="--quiet --extra-arg=-Wno-unknown-warning-option"
status=0

# A room of the host program as one text, since its sources include the same headers; what is found
# is said by source and line. The analyzer takes a third of its usual steps a function: the others go
# into the insides of the standard library.
lint_room() {
  text=$texts/$1.cpp
  cat "tools/$1"/*.cpp >"$text"
  clang-tidy $quietly --config-file=.clang-tidy "$text" -- -std=c++17 \
    -Xclang -analyzer-config -Xclang max-nodes=75000 -Ilib/include -Itools "-Itools/$1" \
    >"$text.found" || status=1
  awk -v text="$text:" '
    FILENAME != found { if (FNR == 1) { source[++n] = FILENAME; before[n] = lines } ++lines; next }
    at = index($0, text) {
      split(substr($0, at + length(text)), where, ":")
      for (i = n; before[i] >= where[1]; --i);
      $0 = source[i] ":" where[1] - before[i] substr($0, at + length(text where[1]))
    }
    { print }' found="$text.found" "tools/$1"/*.cpp "$text.found"
}

find lib -name '*.cpp' | xargs clang-tidy $quietly -p build/native-sanitize || status=1
for room in tools/*/; do
  # tools/compare wants the headers of the libraries that it compares; tools/release has no source.
  [ "$room" = tools/compare/ ] || [ "$room" = tools/release/ ] || lint_room "$(basename "$room")"
done
exit $status
