#!/bin/sh
# release.sh [DIR]         Packages for where firmware is built, in DIR (build/release), a folder each:
#                          lib/docs/packages.md. Installs what is missing. Debian's, and the program for three
#                          machines without Debian, take a quarter of an hour.
# release.sh --test [DIR]  Those, made a second time and compared, then built and run as their users would.
#
# FLASHBVH_URL, FLASHBVH_AUTHOR, FLASHBVH_EMAIL: what the packages say of where they are from. Without
# them they name a host that can't exist, for no one's is right (RFC 2606).
set -eu
cd "$(dirname "$0")/.."
. tools/packages.sh
. tools/quietly.sh
tested=
[ "${1:-}" != --test ] || { tested=yes && shift; }
mkdir -p "${1:-build/release}" build/log
release=$(cd "${1:-build/release}" && pwd)
ensure_packages $host_packages $board_packages $release_packages $archive_packages $python_packages

# FLASHBVH_NATIVE: the preset of the host program that bakes.
native=${FLASHBVH_NATIVE:-native}
quiet_log=build/log/release
quietly cmake --preset "$native"
quietly cmake --build --preset "$native" --target flashbvh_tool
flashbvh=$PWD/build/$native/bin/flashbvh

/usr/bin/python3 tools/release/release.py "$release" "$flashbvh"
tree=$(echo "$release"/debian/flashbvh-*)
if command -v ccache >/dev/null; then # debhelper's home is another one
  CCACHE_DIR=$(ccache -k cache_dir)
  export CCACHE_DIR CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
fi
build_debs() (
  cd "$tree"
  SOURCE_DATE_EPOCH=$(dpkg-parsechangelog -S Timestamp)
  export SOURCE_DATE_EPOCH DEB_BUILD_OPTIONS="parallel=$(nproc) noautodbgsym"
  dpkg-buildpackage --unsigned-source --unsigned-changes --build=binary
)
quietly build_debs
quietly /usr/bin/python3 -B tools/release/archives.py "$release"
# Removes files that are specific to one build on one machine.
rm -rf "$tree" "$release"/debian/*.buildinfo "$release"/debian/*.changes
echo "packages: ${release#"$PWD/"}"
[ -n "${FLASHBVH_URL:-}" ] && [ -n "${FLASHBVH_EMAIL:-}" ] ||
  echo "not to be published: FLASHBVH_URL and FLASHBVH_EMAIL are not set, the packages say flashbvh.example"
[ -n "$tested" ] || exit 0

again=$PWD/build/release-again
/usr/bin/python3 tools/release/release.py "$again" "$flashbvh"
rm -rf "$again"/debian/flashbvh-*/
quietly /usr/bin/python3 -B tools/release/archives.py "$again"
diff -r --exclude='*.deb' "$release" "$again" || { echo "release: not the same bytes" >&2; exit 1; }
echo "made again, the same bytes; not compared: .deb files; not compiled again: the programs in archives and npm"

export ROOT="$PWD" PACKAGES="$release" FLASHBVH="$flashbvh"
echo archives debian arduino cmake amalgamation copied manifests python | xargs -n 1 -P "$(nproc)" sh -c '
  began=$(date +%s)
  WORK=$ROOT/build/release-test/$0 sh "$ROOT/tests/release/$0.sh" >build/log/release-$0 2>&1 ||
    { tail -n 60 build/log/release-$0; echo "== $0 FAILED"; exit 255; }
  echo "== $0 passed in $(($(date +%s) - began)) s"'
