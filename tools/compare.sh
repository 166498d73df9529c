#!/bin/sh
# compare.sh    The time of flashbvh's queries as a ratio to OPCODE's and FCL's, and of its distances to
#               FCL's, on the same meshes in the same poses, in one run: lib/docs/compare.md. A report,
#               not a test. Installs what is missing; works in build/compare, where times.txt keeps the
#               times of each pair.
set -eu
cd "$(dirname "$0")/.."
. tools/packages.sh
. tools/kr5.sh

folder=$PWD/build/compare
meshes=$folder/meshes
# FLASHBVH_NATIVE: the preset whose host program bakes.
native=${FLASHBVH_NATIVE:-native}
flashbvh=build/$native/bin/flashbvh

# quietly COMMAND...: its output goes to a log, which is shown if it fails.
quietly() {
  "$@" >"$folder/log" 2>&1 || { cat "$folder/log" >&2; echo "compare: this failed: $*" >&2; exit 1; }
}

# from_sources ARGUMENT...: apt-get with lists of its own, since Debian's sources may not be among those
# of this machine.
from_sources() {
  apt-get -o Dir::Etc::sourcelist="$apt/sources.list" -o Dir::Etc::sourceparts=/dev/null \
    -o Dir::State::lists="$apt/lists" -o Dir::Cache::pkgcache= -o Dir::Cache::srcpkgcache= \
    -o APT::Sandbox::User= "$@"
}

# fetch_ode: the source of the ODE that is installed, unpacked in `ode`. OPCODE's code is in libode, its
# headers are in no package.
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

# torus NAME AROUND ACROSS RING TUBE: as in tests/figures.
torus() {
  awk -v around="$2" -v across="$3" -v ring="$4" -v tube="$5" -f tests/figures/torus.awk \
    >"$meshes/$1.obj"
}

# bake MESH...: those that are queried together share a cell. With one triangle a leaf, too, for poses
# to be searched with.
bake() {
  quietly "$flashbvh" bake "$@" -o "$meshes" --format image
  quietly "$flashbvh" bake "$@" -o "$meshes/searched" --format image --leaf-size 1
}

# cached NAME: what CMake has of that name for the program.
cached() {
  sed -n "s/^$1:[A-Z]*=//p" "$program/CMakeCache.txt"
}

mkdir -p "$meshes"
ensure_packages $host_packages libode-dev libfcl-dev debian-archive-keyring
fetch_ode
fetch_kr5 build/kr5
fetch_mug
quietly cmake --preset "$native"
quietly cmake --build --preset "$native" --target flashbvh_tool
torus thick 20 20 6000 2000
torus thin 40 10 7000 800
bake "$meshes/thick.obj" "$meshes/thin.obj" --cell 1
bake "$kr5/bicep.STL" "$kr5/forearm.STL" "$kr5/palm.STL" "$kr5/wrist.STL"
bake "$mug"

program=$folder/program
quietly cmake -S tools/compare -B "$program" -G Ninja -DCOMPARE_ODE_SOURCE="$ode"
quietly cmake --build "$program"
pairs="thick-thin bicep-palm forearm-palm bicep-forearm bicep-wrist mug-mug"
"$program/compare" "$meshes" $pairs >"$folder/times.txt"

dpkg-query -W -f '${Package} ${Version}\n' libode-dev libfcl-dev
echo "$("$(cached CMAKE_CXX_COMPILER)" --version | head -n 1), $(cached CMAKE_CXX_FLAGS_RELWITHDEBINFO), $(uname -m)"
echo "meshes: $pairs"
echo
awk -f tools/compare/table.awk "$folder/times.txt"
