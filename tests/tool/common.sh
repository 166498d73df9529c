#!/bin/sh
# Sourced by every script: a folder of its own, and what the tests say.
set -eu
rm -rf "$WORK"
mkdir -p "$WORK"
cd "$WORK"
"$TOOLS/tool_test_meshes" meshes

fail() {
  echo "FAILED: $*" >&2
  exit 1
}

# thorough: whether all is asked for, however long it takes.
thorough() { [ -n "${FLASHBVH_THOROUGH:-}" ]; }

# refused WHAT ARGUMENT...: the program must exit with 2 and one line on standard error that holds
# WHAT, print nothing else, and leave no folder or file named out*.
refused() {
  what=$1
  shift
  code=0
  "$FLASHBVH" "$@" >stdout 2>stderr || code=$?
  [ $code -eq 2 ] || fail "exit $code, not 2: $* ($(cat stderr))"
  [ "$(wc -l <stderr)" -eq 1 ] || fail "not one line: $* ($(cat stderr))"
  [ ! -s stdout ] || fail "output on stdout: $*"
  grep -q '^flashbvh: ' stderr || fail "$(cat stderr)"
  grep -qF -- "$what" stderr || fail "no '$what' in: $(cat stderr)"
  [ -z "$(find . -name 'out*')" ] || fail "something written: $*"
}

# exits CODE ARGUMENT...
exits() {
  wanted=$1
  shift
  code=0
  "$FLASHBVH" "$@" >stdout 2>stderr || code=$?
  [ $code -eq "$wanted" ] || fail "exit $code, not $wanted: $* ($(cat stderr))"
}

# holds PAGE TEXT...
holds() {
  page=$1
  shift
  for text; do
    grep -qF -- "$text" "$page" || fail "no '$text' in $page"
  done
}

# self_contained PAGE: no address but those that hold their data, no path, and no number that is none.
self_contained() {
  if grep -noE '(https?:|file:|src=|url\(|@import|<script|<link)[^>]{0,40}' "$1"; then
    fail "$1 needs something from elsewhere"
  fi
  if grep -oE 'href="[^"]{5}' "$1" | grep -vE 'href="(data:|#m[0-9]|#quer)'; then
    fail "$1 leads elsewhere"
  fi
  if grep -nE "$PWD|20[0-9][0-9]-[0-9][0-9]-" "$1" | cut -c 1-200 | grep .; then
    fail "a path or a date in $1"
  fi
  if sed 's/base64,[^"]*//' "$1" | grep -niE '[^a-z](nan|inf)[^a-z]'; then
    fail "no number in $1"
  fi
}

# What URDFs of tests are made of.
# link NAME INSIDE
link() { printf '<link name="%s">%s</link>\n' "$1" "$2"; }
# shape GEOMETRY [ORIGIN]
shape() { printf '<collision>%s<geometry>%s</geometry></collision>' "${2-}" "$1"; }
# box SIZE PLACE
box() { shape "<box size=\"$1\"/>" "<origin xyz=\"$2\"/>"; }
# joint NAME TYPE PARENT CHILD INSIDE
joint() {
  printf '<joint name="%s" type="%s"><parent link="%s"/><child link="%s"/>%s</joint>\n' "$@"
}
# limits LOWER UPPER
limits() { printf '<limit lower="%s" upper="%s" effort="1" velocity="1"/>' "$@"; }
