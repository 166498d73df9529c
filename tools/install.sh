#!/bin/sh
# install.sh                   Builds the program `flashbvh` and installs it below /usr/local, with the library and
#                              its CMake package.
# install.sh --prefix FOLDER   The same below FOLDER.
#
# No tests. Installs Debian's packages that are missing.
set -eu
here=$(cd "$(dirname "$0")/.." && pwd)
prefix=/usr/local
case ${1:-} in
  "") ;;
  --prefix) prefix=${2:?--prefix takes a folder} ;;
  *) sed -n '2,6s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
esac
mkdir -p "$prefix" 2>/dev/null || true
as_root=
if [ ! -w "$prefix" ]; then
  command -v sudo >/dev/null || { echo "$0: $prefix can't be written: --prefix \$HOME/.local, or as root" >&2; exit 2; }
  as_root=sudo
fi
. "$here/tools/packages.sh"
ensure_packages $host_packages $live_packages

build=$here/build/install
mkdir -p "$build"
{
  cmake -S "$here" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$prefix" \
    -DFLASHBVH_BUILD_TESTS=OFF && cmake --build "$build"
} >"$build/log" 2>&1 || { tail -n 30 "$build/log" >&2; echo "$0: did not build; all of it: $build/log" >&2; exit 1; }
$as_root cmake --install "$build" >>"$build/log"
echo "$prefix/bin/flashbvh: $("$prefix/bin/flashbvh" --version)"
