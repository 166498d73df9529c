#!/bin/sh
# The program for machines without Debian, unpacked and installed: it runs with no other files, and commands of the
# command line's tests exit, print and write like the native program's.
. "$(dirname "$0")/common.sh"
(cd "$PACKAGES/archives" && quietly sha256sum --check --strict SHA256SUMS)
version=$("$FLASHBVH" --version | cut -d ' ' -f 2)
arm=$ROOT/firmware_examples/robot_guard/cell_arm

tar -xf "$PACKAGES/archives/flashbvh-$version-linux-x86_64.tar.xz"
linux=$WORK/flashbvh-$version-linux-x86_64
! ldd "$linux/flashbvh" >log 2>&1 || fail "needs libraries"
cp -r "$linux" alone
cp "$ROOT"/firmware_examples/quick_start/*.obj alone
quietly env -i unshare --map-root-user --root="$WORK/alone" /flashbvh bake plate.obj peg.obj -o baked
"$FLASHBVH" bake alone/*.obj -o native >log
quietly diff -r native alone/baked

/usr/bin/python3 -m zipfile -e "$PACKAGES/archives/flashbvh-$version-windows-x86_64.zip" .
wine=/usr/lib/wine/wine64
export WINEPREFIX="$WORK/wine" WINEDEBUG=-all
quietly "$wine" "flashbvh-$version-windows-x86_64/flashbvh.exe" --version
if command -v npm >/dev/null; then
  quietly npm install --offline --global --prefix "$WORK/npm" "$PACKAGES/npm/flashbvh-$version.tgz"
else # Debian's node comes without it
  mkdir -p npm/bin
  tar -xf "$PACKAGES/npm/flashbvh-$version.tgz"
  ln -s ../../package/flashbvh.js npm/bin/flashbvh
fi
[ "$(npm/bin/flashbvh --version)" = "flashbvh $version" ] || fail "npm's other version"

# Differences by design (lib/docs/packages.md, "Where the programs differ"): omitted readers, other words for a crash,
# a glTF that other readers would accept, time.
differs="its reader crashed|takes over 1024 MiB|Unsupported glTF version|no time was left"

# compare NAME "PROGRAM" "DIFFERS" WORD...: compares the tests' cases that these words select.
compare() {
  export COMPARED="$WORK/compared-$1" OTHER="$2" NATIVE="$FLASHBVH"
  name=$1 differs_too=$3
  shift 3
  FLASHBVH=$ROOT/tests/release/both.py TOOLS=$WORK WORK=$WORK/cases ARM=$arm/cell_arm.urdf CC=cc CXX=c++ \
    python3 -B "$ROOT/tests/cli/runner.py" "$@" >log 2>&1 || true
  alike=$(grep -c '^same$' "$COMPARED")
  [ "$alike" -ge 50 ] || fail "$name: $alike commands alike"
  ! grep -Ev "^same\$|$differs$differs_too" "$COMPARED" || fail "$name: differs"
  echo "$name: $alike commands alike, $(grep -vc '^same$' "$COMPARED") differ by design"
}
compare linux "$linux/flashbvh" "" scenes odd_meshes robot
# In memory without gaps, a stride of 2^31 leads to other numbers of the file.
compare npm "$WORK/npm/bin/flashbvh" "|without area: 2 triangles" scenes odd_meshes robot
compare windows "$wine $WORK/flashbvh-$version-windows-x86_64/flashbvh.exe" "" scenes robot
