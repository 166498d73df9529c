#!/bin/sh
# The program for machines without Debian: started as it is unpacked and installed, with nothing else there, each command
# of the command line's tests ends, prints and writes as the native program's does.
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
quietly npm install --offline --global --prefix "$WORK/npm" "$PACKAGES/npm/flashbvh-$version.tgz"
[ "$(npm/bin/flashbvh --version)" = "flashbvh $version" ] || fail "npm's other version"

# compare NAME "PROGRAM" "LEFT OUT" WORD...: runs the tests' cases, of which those words are wanted. LEFT OUT: what differs
# by design, as a regular expression.
compare() {
  name=$1 OTHER=$2 left_out=$3 COMPARED=$WORK/compared-$1 NATIVE=$FLASHBVH
  shift 3
  export OTHER COMPARED NATIVE
  FLASHBVH=$ROOT/tests/release/both.py TOOLS=$WORK WORK=$WORK/cases ARM=$arm/cell_arm.urdf CC=cc CXX=c++ \
    python3 -B "$ROOT/tests/cli/runner.py" "$@" >log 2>&1 || true
  [ "$(grep -c '^same$' "$COMPARED")" -ge 100 ] || fail "$name: too few commands"
  ! grep -Ev "^same\$|reads no (MJCF|SDF)$left_out" "$COMPARED" || fail "$name: differs"
  echo "$name: $(grep -c '^same$' "$COMPARED") commands alike, $(grep -vc '^same$' "$COMPARED") left out"
}
compare linux "$linux/flashbvh" "" scenes bad_meshes odd_meshes bodies robot
compare npm "$WORK/npm/bin/flashbvh" "" scenes bad_meshes odd_meshes bodies robot
compare windows "$wine $WORK/flashbvh-$version-windows-x86_64/flashbvh.exe" "" scenes robot
