#!/bin/sh
# compare.sh    Compares with OPCODE and a tree in floats: instructions on a Cortex-M4F under QEMU, on the same
#               meshes in the same poses. Writes lib/docs/comparison.md.
#
# A report, not a test. Installs what is missing; works in build/compare.
set -eu
cd "$(dirname "$0")/.."
. tools/packages.sh
. tools/quietly.sh

folder=$PWD/build/compare
quiet_log=$folder/log
# FLASHBVH_NATIVE: the preset of the host program that bakes.
native=${FLASHBVH_NATIVE:-native}

# from_sources ARGUMENT...: apt-get with its own lists, because this machine may not have Debian's sources.
from_sources() {
  apt-get -o Dir::Etc::sourcelist="$apt/sources.list" -o Dir::Etc::sourceparts=/dev/null \
    -o Dir::State::lists="$apt/lists" -o Dir::Cache::pkgcache= -o Dir::Cache::srcpkgcache= \
    -o APT::Sandbox::User= "$@"
}

# fetch_ode: unpacks the source of the installed ODE in `ode`. OPCODE's code is in libode; no package has its
# headers.
fetch_ode() {
  version=$(dpkg-query -W -f '${source:Version}' libode-dev)
  ode=$folder/ode-$version
  [ ! -r "$ode/OPCODE/Opcode.h" ] || return 0
  apt=$folder/apt
  rm -rf "$apt" "$ode"
  mkdir -p "$apt/lists/partial" "$ode"
  keys=/usr/share/keyrings/debian-archive-keyring.gpg
  apt-get indextargets --format "deb-src [signed-by=$keys] \$(REPO_URI) \$(RELEASE) \$(COMPONENT)" \
    'Created-By: Packages' 'Origin: Debian' | sort -u >"$apt/sources.list"
  quietly from_sources update
  (cd "$apt" && quietly from_sources source --download-only "ode=$version")
  tar -xf "$apt"/ode_*.orig.tar.* -C "$ode" --strip-components=1
}

# on_board BOARD: measures instructions on a board, for page.py.
on_board() {
  quietly cmake -S tools/compare -B "$folder/$1" -G Ninja -DFLASHBVH_BOARD="$1" \
    -DCMAKE_TOOLCHAIN_FILE="$PWD/ports/toolchain/arm-none-eabi.cmake" \
    -DCOMPARE_ODE_SOURCE="$ode" -DCOMPARE_FIGURES="$PWD/build/figures" -DCOMPARE_SCENES="$folder/scenes"
  quietly cmake --build "$folder/$1"
  FLASHBVH_TIMEOUT=600 FLASHBVH_ICOUNT=8 ports/run "$1" "$folder/$1/bin/compare_firmware.elf" \
    >"$folder/$1.txt"
}

boards="mps2-an386"
mkdir -p "$folder"
ensure_packages $host_packages $board_packages libstdc++-arm-none-eabi-newlib libode-dev debian-archive-keyring
fetch_ode
FLASHBVH_NATIVE=$native quietly tools/figures.sh --prepare
quietly python3 tools/compare/scenes.py "build/$native/bin/flashbvh" "$folder/scenes"
for board in $boards; do
  on_board "$board"
done
python3 tools/compare/page.py lib/docs/comparison.md "$folder" $boards
