#!/bin/sh
# The main job, end to end: a robot's meshes go in, a microcontroller answers collision queries, and
# the answers are compared with the host's. Installs what is missing; works in build/demo.
set -eu
cd "$(dirname "$0")/.."
. tools/packages.sh
ensure_packages $host_packages $board_packages

demo=build/demo
flashbvh=build/native/bin/flashbvh
links="base_link shoulder bicep elbow forearm wrist palm"
board=cortex-m4f
mkdir -p $demo

step() { printf '\n== %s\n' "$1"; }
# quietly COMMAND...: its output goes to a log, which is shown if it fails.
quietly() {
  "$@" >$demo/log 2>&1 || { cat $demo/log >&2; echo "demo: this failed: $*" >&2; exit 1; }
}

step "1. The arm: a KUKA KR5 from Debian's package dart-doc (BSD-2-Clause)"
package=dart-doc
kr5=$demo/dart/usr/share/doc/dart/data/urdf/KR5/meshes
if [ ! -r $kr5/palm.STL ]; then
  (cd $demo && apt-get download $package >log 2>&1) ||
    { cat $demo/log >&2; echo "demo: 'apt-get download $package' failed; is there a network, and has
'apt-get update' been run?" >&2; exit 1; }
  dpkg-deb -x $demo/${package}_*.deb $demo/dart
fi
echo "Seven links, $(ls $kr5/*.STL | wc -l) STL files in $kr5"

step "2. The host program"
quietly cmake --preset native
quietly cmake --build --preset native --target flashbvh_tool
echo "$flashbvh"

step "3. Bake: mesh in, C++ arrays and images out, one common cell for all"
meshes=$(for link in $links; do echo "$kr5/$link.STL"; done)
$flashbvh bake $meshes -o $demo/kr5
$flashbvh bake $meshes -o $demo/kr5/pre --layout pre --format image >$demo/log
echo "The same links pre-indexed, for the paper's first stackless algorithm: $demo/kr5/pre"

step "4. Firmware for a Cortex-M4 with all seven links in its flash"
quietly cmake --preset $board -DFLASHBVH_HOST_TOOL="$PWD/$flashbvh" \
  -DFLASHBVH_ROBOT_ARM="$PWD/$demo/kr5"
quietly cmake --build --preset $board --target robot_arm
arm-none-eabi-size build/$board/bin/robot_arm.elf

step "5. The queries, on the microcontroller (QEMU) and on this machine"
ports/run mps2-an386 build/$board/bin/robot_arm.elf >$demo/target ||
  { failed=$?; cat $demo/target; echo "demo: the firmware ended with status $failed" >&2; exit 1; }

# host_results: the same questions to `flashbvh collide`, in the same lines but for the stack.
host_results() {
  awk '$1 == "result" { print $2, $3, $4, $5, $6, $7 }' $demo/target |
    while read -r a b x y z algorithm; do
      images=$demo/kr5
      [ "$algorithm" = stackless ] && images=$demo/kr5/pre
      echo "1 0 0  0 1 0  0 0 1  $x $y $z" >$demo/pose
      $flashbvh collide $images/$a.fbvh $images/$b.fbvh --poses $demo/pose \
        --algorithm $algorithm --json >$demo/answer
      counts=$(sed 's/.*"visits": *\([0-9]*\),.*"overlaps": *\([0-9]*\),.*"leaf_pairs": *\([0-9]*\),.*"triangle_pairs": *\([0-9]*\),.*/\1 \2 \3 \4/' $demo/answer)
      echo "result $a $b $x $y $z $algorithm $counts"
    done
}
host_results >$demo/host

status=0
awk -v host=$demo/host -f tools/demo_table.awk $demo/target || status=1

step "What happened"
if [ $status -eq 0 ]; then
  cat <<TEXT
Every query gave the same counts on the microcontroller as on this machine, from the same baked
images, with every traversal; all traversals found the same pairs. No heap was linked, and no query
used more than the stack printed above. The query object is 64 bytes and the caller's.

Next:  $flashbvh bake your.stl -o baked        your own mesh
       firmware_examples/quick_start/          the smallest firmware, a page long
       README.md                               what is promised, and what it is not for
TEXT
else
  echo "The microcontroller and this machine disagree: see DIFFERS above. That is a bug in flashbvh."
fi
exit $status
