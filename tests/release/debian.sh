#!/bin/sh
# Debian's packages: lintian has no error and no warning, and what autopkgtest would run in a system of its
# own passes with the packages unpacked.
. "$(dirname "$0")/common.sh"
quietly lintian --allow-root --fail-on error,warning "$PACKAGES"/debian/*.deb "$PACKAGES"/debian/*.dsc
for package in libflashbvh-dev flashbvh; do
  dpkg-deb -x "$PACKAGES"/debian/${package}_*.deb root
done
quietly dpkg-source -x "$PACKAGES"/debian/*.dsc tree
[ ! -e root/usr/lib/debug ] && [ -s root/usr/share/man/man1/flashbvh.1.gz ] || fail "other files"
cd tree
FLASHBVH_PREFIX=$WORK/root/usr quietly debian/tests/consumer

# Without the program the library serves, and says what it needs to bake.
cd "$WORK"
dpkg-deb -x "$PACKAGES"/debian/libflashbvh-dev_*.deb alone
cp -r tree/tests/packaging/consumer .
! cmake -S consumer -B wrong "-DCMAKE_PREFIX_PATH=$WORK/alone/usr" >log 2>&1 || fail "nothing to bake with"
tr -s '\n ' '  ' <log | grep -q "set FLASHBVH_HOST_TOOL to its path" || fail "no mend"
"$FLASHBVH" bake tree/firmware_examples/quick_start/*.obj -o baked --format cpp >log
quietly cmake -G Ninja -S consumer -B built "-DCMAKE_PREFIX_PATH=$WORK/alone/usr" "-DBAKED=$WORK/baked"
quietly cmake --build built
built/consumer || fail "wrong answers"
