#!/bin/sh
# Debian's packages: lintian finds no error and no warning, and autopkgtest's commands, for a separate system, pass with
# the packages unpacked.
. "$(dirname "$0")/common.sh"
quietly lintian --allow-root --fail-on error,warning "$PACKAGES"/debian/*.deb "$PACKAGES"/debian/*.dsc
for package in libflashbvh-dev flashbvh; do
  dpkg-deb -x "$PACKAGES"/debian/${package}_*.deb root
done
quietly dpkg-source -x "$PACKAGES"/debian/*.dsc tree
[ ! -e root/usr/lib/debug ] && [ -s root/usr/share/man/man1/flashbvh.1.gz ] || fail "other files"
for script in bash-completion/completions/flashbvh zsh/vendor-completions/_flashbvh \
  fish/vendor_completions.d/flashbvh.fish; do
  [ -s "root/usr/share/$script" ] || fail "no completion: $script"
done
cd tree
FLASHBVH_PREFIX=$WORK/root/usr quietly debian/tests/consumer

# The page's commands.
cd "$WORK"
mkdir page
cp tree/tests/packaging/consumer/main.cpp tree/firmware_examples/quick_start/*.obj page
{
  printf 'cmake_minimum_required(VERSION 3.21)\nproject(page LANGUAGES CXX)\nadd_executable(firmware main.cpp)\n'
  shown Debian
} >page/CMakeLists.txt
quietly cmake -G Ninja -S page -B page/built "-DCMAKE_PREFIX_PATH=$WORK/root/usr"
quietly cmake --build page/built
page/built/firmware || fail "the page's lines"

# Without the program, the library still works, and its message names what it needs to bake.
dpkg-deb -x "$PACKAGES"/debian/libflashbvh-dev_*.deb alone
cp -r tree/tests/packaging/consumer .
! cmake -S consumer -B wrong "-DCMAKE_PREFIX_PATH=$WORK/alone/usr" >log 2>&1 || fail "nothing to bake with"
tr -s '\n ' '  ' <log | grep -q "set FLASHBVH_HOST_TOOL to its path" || fail "no remedy"
"$FLASHBVH" bake tree/firmware_examples/quick_start/*.obj -o baked --format c >log
quietly cmake -G Ninja -S consumer -B built "-DCMAKE_PREFIX_PATH=$WORK/alone/usr" "-DBAKED=$WORK/baked"
quietly cmake --build built
built/consumer || fail "wrong answers"
