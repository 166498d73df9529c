#!/bin/sh
# Runs the main task end to end: bakes a robot's meshes and joints, lets a microcontroller decide whether the
# arm hits itself, and compares all answers with the host's. Installs missing packages; works in build/demo.
set -eu
cd "$(dirname "$0")/.."
. tools/packages.sh
. tools/quietly.sh
. tools/kr5.sh
ensure_packages $host_packages $live_packages $board_packages

demo=build/demo
quiet_log=$demo/log
# FLASHBVH_NATIVE: the preset whose host program bakes. FLASHBVH_DEMO_OF_MESHES: without the arm's guard,
# whose pairs of links take half a minute to decide, three times.
native=${FLASHBVH_NATIVE:-native}
flashbvh=build/$native/bin/flashbvh
bake=${FLASHBVH_BAKE:-$PWD/$flashbvh}
links="base_link shoulder bicep elbow forearm wrist palm"
board=cortex-m4f
last=
mkdir -p $demo

step() { printf '\n== %s\n' "$1"; }
# build PRESET TARGET [OPTION...]: prints a line for each compiled part.
build() {
  preset=$1
  target=$2
  shift 2
  quietly cmake --preset $preset "$@"
  { cmake --build --preset $preset --target $target 2>&1 && echo "built $target"; } | tee $demo/log |
    sed -u -n 's|.*Building .* \([a-z_/]*\)/CMakeFiles/.*|\1|p' | while read -r part; do
      [ "$part" = "$last" ] || echo "  compiled: $part"
      last=$part
    done
  grep -qx "built $target" $demo/log ||
    { cat $demo/log >&2; echo "demo: building $target failed" >&2; exit 1; }
}
# run_arm OUTPUT [ARGUMENT]: runs the firmware in QEMU; prints a line when it begins a configuration.
run_arm() {
  output=$1
  shift
  {
    FLASHBVH_TIMEOUT=300 FLASHBVH_ICOUNT=8 ports/run mps2-an386 build/$board/bin/robot_arm.elf "$@" &&
      echo ended
  } | tee $output | while read -r kind name answer _; do
    [ "$kind" != answer ] || echo "  $name: hits itself? $answer. What each pair costs ..."
  done
  grep -qx ended $output || { cat $output; echo "demo: the firmware failed" >&2; exit 1; }
}

step "1. The arm: a KUKA KR5 from Debian's package dart-doc (BSD-2-Clause)"
fetch_kr5 build/kr5
echo "Seven links, $(ls "$kr5"/*.STL | wc -l) STL files in $kr5"
echo "Six joints, in $urdf"

step "2. The host program"
echo "Compiled once, which takes a minute:"
build $native flashbvh_tool -DFLASHBVH_KR5="$PWD/${kr5%/*}"
echo "$flashbvh"

step "3. Bake: mesh in, images out, one common cell for all"
meshes=$(for link in $links; do echo "$kr5/$link.STL"; done)
$flashbvh bake $meshes -o $demo/kr5
quietly $flashbvh bake $meshes -o $demo/kr5/post --levels --format c
quietly $flashbvh bake $meshes -o $demo/kr5/pre --layout pre --format image
echo "The same links with levels and pre-indexed, for the paper's stackless algorithms: $demo/kr5/post, $demo/kr5/pre"

step "4. Firmware for a Cortex-M4 with all seven links in its flash"
python3 firmware_examples/robot_arm/joints.py "$urdf" >$demo/kr5/joints.hpp
build $board robot_arm -DFLASHBVH_HOST_TOOL="$bake" -DFLASHBVH_ROBOT_ARM="$PWD/$demo/kr5"
arm-none-eabi-size build/$board/bin/robot_arm.elf
echo "text: flash, with every link twice, for both layouts; data and bss: static RAM"

step "5. The arm's configurations, on the microcontroller (QEMU) and on this machine"
echo "Eight configurations; for each, every pair of links by seven traversals:"
run_arm $demo/target

echo "The same questions to this machine"
python3 tools/demo.py host $flashbvh

status=0
python3 tools/demo.py table || status=1

step "6. The same arm with five triangles in a leaf: less flash"
mkdir -p $demo/compact
$flashbvh bake $meshes -o $demo/compact --leaf-size 5 2>$demo/log >$demo/compact/table
cat $demo/compact/table
quietly $flashbvh bake $meshes -o $demo/compact/post --leaf-size 5 --levels --format c
quietly $flashbvh bake $meshes -o $demo/compact/pre --leaf-size 5 --layout pre --format image
cp $demo/kr5/joints.hpp $demo/compact/
build $board robot_arm -DFLASHBVH_ROBOT_ARM="$PWD/$demo/compact"
run_arm $demo/target_compact ranked
python3 tools/demo.py compact || status=1

step "7. A page in which the arm's links answer: flash, RAM, time"
# Leaves out neighbours, which the arm does not test.
rm -rf $demo/queried
cp -r $demo/poses $demo/queried
for link in $links; do
  rm -f $demo/queried/$last-$link
  last=$link
done
$flashbvh report $(for link in $links; do echo $demo/kr5/$link.fbvh; done) --poses $demo/queried \
  --core $board --hz 1000 --clock 168MHz -o $demo/arm.html
echo "Open $PWD/$demo/arm.html"

if [ -n "${FLASHBVH_DEMO_OF_MESHES:-}" ]; then
  echo "Left to tools/test.sh --all: 8 to 10, the arm's guard"
  exit $status
fi
step "8. Behind a fence, on a pedestal: which links can collide is proven, not sampled"
guarded=build/$native/firmware_examples/robot_guard/kr5_cell.urdf
$flashbvh robot $guarded -o $demo/robot --stop 0.005 --warn 0.03 --pair forearm,palm=0.001 \
  --format image --name kr5_cell --report $demo/robot.html

step "9. The guard at 1 kHz, in SysTick's interrupt: the arm is stopped before it hits itself or the fence"
build $native robot_guard_kr5
build $board robot_guard_kr5 -DFLASHBVH_KR5="$PWD/${kr5%/*}"
arm-none-eabi-size build/$board/bin/robot_guard_kr5.elf
FLASHBVH_TIMEOUT=300 FLASHBVH_ICOUNT=8 ports/run mps2-an386 build/$board/bin/robot_guard_kr5.elf |
  tee $demo/guarded
# Leaves out durations, which differ here, and views, which hold pointers.
answers_in() { sed '/^  a period/d; s/views of the robot [0-9]* bytes/views of the robot/' "$1"; }
build/$native/bin/robot_guard_kr5 >$demo/guarded_here
answers_in $demo/guarded >$demo/guarded_there
if answers_in $demo/guarded_here | cmp - $demo/guarded_there; then
  echo "This machine, sent the same set points, says the same."
else
  status=1
fi

step "10. A page about a motion that 10,000 random configurations mostly miss"
python3 tools/demo.py motion >$demo/motion.csv
$flashbvh guard $demo/robot/kr5_cell.robot $demo/motion.csv --work 500 --report $demo/motion.html || [ $? -eq 1 ]

step "What happened"
if [ $status -eq 0 ]; then
  cat <<TEXT
The microcontroller took the angles of the joints, computed where the links are, and reported exactly
which triangles intersect. Every query gave the same counts as on this machine, under the same poses, from
the same baked meshes, with every traversal; all traversals found the same pairs. No heap was linked,
and no query used more than the stack printed above. The query object and the pose, 196 bytes, are the
caller's. A guard of the whole arm stopped it before it hit anything, at every moment between two
periods, in the interrupt of a timer at 1 kHz.

Look:  $demo/robot.html                   what of the arm can collide, and where
       $demo/motion.html                  the motion that was stopped
       $demo/arm.html                     the arm, its costliest pose, what fits a period
Next:  $flashbvh bake your.stl -o baked        your own mesh
       firmware_examples/quick_start/          the smallest firmware, a page long
       firmware_examples/robot_guard/          an arm that can't hit itself
       README.md                               what is promised, and what it is not for
TEXT
else
  echo "The microcontroller and this machine disagree: see DIFFERS above. That is a bug in flashbvh."
fi
exit $status
