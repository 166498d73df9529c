#!/bin/sh
# compare.sh           Compares with OPCODE, FCL, Bullet and Embree: times as ratios, answers, allocations, on the same
#                      meshes in the same poses, in one run; instructions on two boards under QEMU;
#                      capsules, spheres, hulls and distance fields. Writes lib/docs/comparison.md.
# compare.sh --page    writes the page from the last run's files in build/compare
#
# A report, not a test. Installs what is missing; works in build/compare.
set -eu
cd "$(dirname "$0")/.."
. tools/packages.sh
. tools/quietly.sh
. tools/kr5.sh

case ${1:-} in
  "" | --page) ;;
  *) sed -n '2,7s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
esac
folder=$PWD/build/compare
quiet_log=$folder/log
meshes=$folder/meshes
# FLASHBVH_NATIVE: the preset of the host program that bakes.
native=${FLASHBVH_NATIVE:-native}
flashbvh=build/$native/bin/flashbvh

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

# fetch_mug: a mesh of 24,544 triangles from Debian's package libmujoco-samples (Apache-2.0).
fetch_mug() {
  mug=$folder/mujoco/usr/share/mujoco/model/mug/mug.obj
  [ ! -r "$mug" ] || return 0
  (cd "$folder" && quietly apt-get download libmujoco-samples)
  dpkg-deb -x "$folder"/libmujoco-samples_*.deb "$folder/mujoco"
}

# mesh NAME SHAPE SIZE...: makes a mesh with firmware_examples/meshes.py.
mesh() {
  name=$1
  shift
  python3 firmware_examples/meshes.py "$@" >"$meshes/$name.obj"
}

# bake MESH...: bakes meshes that are queried together, with one cell. Bakes them again with one triangle per
# leaf, to search poses.
bake() {
  quietly "$flashbvh" bake "$@" -o "$meshes" --format image
  quietly "$flashbvh" bake "$@" -o "$meshes/searched" --format image --leaf-size 1
}

# on_board BOARD FIGURES OUTPUT: measures instructions on a board for the meshes of a folder, for page.py.
on_board() {
  quietly cmake -S tools/compare/firmware -B "$folder/$3" -G Ninja -DFLASHBVH_BOARD="$1" \
    -DCMAKE_TOOLCHAIN_FILE="$PWD/ports/toolchain/arm-none-eabi.cmake" \
    -DCOMPARE_ODE_SOURCE="$ode" -DCOMPARE_FIGURES="$2"
  quietly cmake --build "$folder/$3"
  FLASHBVH_TIMEOUT=600 FLASHBVH_ICOUNT=8 ports/run "$1" "$folder/$3/bin/compare_firmware.elf" \
    >"$folder/$3.txt"
}

# cached NAME: the value of a CMake variable in the program's cache.
cached() {
  sed -n "s/^$1:[A-Z]*=//p" "$program/CMakeCache.txt"
}

pairs="thick-thin bicep-palm forearm-palm bicep-forearm bicep-wrist mug-mug"
boards="mps2-an386 mps2-an500"
program=$folder/program

measure() {
  mkdir -p "$meshes"
  ensure_packages $host_packages $board_packages libbullet-dev libembree-dev libode-dev libfcl-dev pkg-config \
    debian-archive-keyring
  fetch_ode
  fetch_kr5 build/kr5
  fetch_mug
  FLASHBVH_NATIVE=$native quietly tools/figures.sh --prepare
  mesh thick torus 20 20 6000 2000
  mesh thin torus 40 10 7000 800
  mesh crate box 1000 700 400
  mesh brick box 300 200 100
  bake "$meshes/thick.obj" "$meshes/thin.obj" --cell 1
  bake "$meshes/crate.obj" "$meshes/brick.obj" --cell 1
  bake "$kr5/bicep.STL" "$kr5/forearm.STL" "$kr5/palm.STL" "$kr5/wrist.STL"
  bake "$mug"

  quietly cmake -S tools/compare -B "$program" -G Ninja -DCOMPARE_ODE_SOURCE="$ode"
  quietly cmake --build "$program"
  for board in $boards; do
    on_board "$board" "$PWD/build/figures" "$board"
    on_board "$board" "$PWD/build/figures/meshes" "$board-others"
  done
  "$program/compare" "$meshes" crate-brick $pairs >"$folder/lines.txt"
}

# with: prints the versions of the libraries and of the compiler.
with() {
  dpkg-query -W -f '${Package} ${Version}\n' libode-dev libfcl-dev libbullet-dev libembree-dev
  echo "$("$(cached CMAKE_CXX_COMPILER)" --version | head -n 1), $(cached CMAKE_CXX_FLAGS_RELWITHDEBINFO), $(uname -m)"
  echo "meshes: $pairs"
}

[ "${1:-}" = --page ] || measure
with >"$folder/with"
python3 tools/compare/page.py lib/docs/comparison.md "$folder" $boards
