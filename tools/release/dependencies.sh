#!/bin/sh
# dependencies.sh TARGET PREFIX   The libraries of the host program, static, for TARGET (linux, windows or wasm), in
#                                 PREFIX: from Debian's source packages, which stay in build/sources.
set -eu
target=${1:?TARGET: linux, windows or wasm} prefix=${2:?PREFIX: a folder}
root=$(cd "$(dirname "$0")/../.." && pwd)
sources=$root/build/sources

# fetch PACKAGE...: uses its own package lists, so that the machine's lists do not change.
fetch() (
  mkdir -p "$sources/apt/lists/partial"
  cd "$sources"
  apt-get indextargets --format 'deb-src $(REPO_URI) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' 'Label: Debian' |
    sort -u >apt/list
  set -- -o "Dir::Etc::sourcelist=$PWD/apt/list" -o Dir::Etc::sourceparts=- -o "Dir::State::lists=$PWD/apt/lists" "$@"
  apt-get -q "$1" "$2" "$3" "$4" "$5" "$6" update
  apt-get -q source "$@"
)
if [ ! -e "$sources/complete" ]; then
  fetch assimp console-bridge meshoptimizer tinyxml urdfdom urdfdom-headers yaml-cpp zlib
  touch "$sources/complete"
fi

mkdir -p "$prefix"
prefix=$(cd "$prefix" && pwd)
cmake -G Ninja -S "$root/tools/release/dependencies" -B "$prefix/build" \
  --toolchain "$root/tools/release/targets/$target.cmake" \
  -DCMAKE_BUILD_TYPE=Release "-DSOURCES=$sources" "-DCMAKE_INSTALL_PREFIX=$prefix"
cmake --build "$prefix/build" --target install
