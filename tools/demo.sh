#!/bin/sh
# Runs the main task end to end: bakes a robot's meshes and joints, lets a microcontroller guard the arm, and compares
# its answers with the host's. Installs missing packages; works in build/demo.
set -eu
cd "$(dirname "$0")/.."
. tools/packages.sh
. tools/quietly.sh
. tools/kr5.sh
ensure_packages $host_packages $live_packages

demo=build/demo
quiet_log=$demo/log
# FLASHBVH_NATIVE: the preset whose host program bakes.
native=${FLASHBVH_NATIVE:-native}
flashbvh=build/$native/bin/flashbvh
board=cortex-m4f
last=
status=0
mkdir -p $demo
# While the host program is compiled.
ensure_packages $board_packages $measure_packages >$demo/installed 2>&1 &
installing=$!

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

step "1. The arm: a KUKA KR5 from Debian's package dart-doc (BSD-2-Clause)"
fetch_kr5 build/kr5
echo "Its meshes and joints: ${kr5%/*}"

step "2. The host program $flashbvh, compiled once: some minutes"
build $native flashbvh_tool -DFLASHBVH_KR5="$PWD/${kr5%/*}"

step "3. Bake two links: meshes in, images out, with one cell; and a page to turn one about the other"
$flashbvh bake "$kr5/forearm.STL" "$kr5/palm.STL" --unit m -o $demo/kr5
echo "1 0 0  0 1 0  0 0 1  0.3 0 0" >$demo/poses
$flashbvh report $demo/kr5/forearm.fbvh $demo/kr5/palm.fbvh --poses $demo/poses -o $demo/scene.html

step "4. Behind a fence, on a pedestal: which links can collide is proven, not sampled"
guarded=build/$native/firmware_examples/robot_guard/kr5_cell.urdf
$flashbvh robot $guarded -o $demo/robot --stop 0.005 --warn 0.03 --pair forearm,palm=0.001 \
  --format image --name kr5_cell --report $demo/robot.html >$demo/robot.txt
grep -E '^pair|  can  |^cell' $demo/robot.txt
echo "All pairs, with the reasons: $demo/robot.txt"

step "5. The guard at 1 kHz, in SysTick's interrupt: the arm is stopped before it hits itself or the fence"
build $native robot_guard_kr5
wait $installing || { cat $demo/installed >&2; exit 2; }
build $board robot_guard_kr5 -DFLASHBVH_KR5="$PWD/${kr5%/*}" -DFLASHBVH_HOST_TOOL="$PWD/$flashbvh"
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

step "6. The paper's traversals on that core: a ring and its copy, moved and turned"
build $board paper_main
FLASHBVH_ICOUNT=8 ports/run mps2-an386 build/$board/bin/paper_main.elf

step "7. A page about a motion that 10,000 random configurations mostly miss"
python3 - >$demo/motion.csv <<'PYTHON'
print("shoulder_yaw,shoulder_pitch,elbow_pitch,elbow_roll,wrist_pitch,wrist_roll")
for t in (i / 1000 for i in range(1000)):
    s = t * t * (3 - 2 * t)
    print(f"0,0.3,{-2.5 - 1.14 * s:.6f},{-0.1 * s:.6f},0,0")
PYTHON
$flashbvh guard $demo/robot/kr5_cell.robot $demo/motion.csv --work 500 --report $demo/motion.html \
  >$demo/motion.txt 2>&1 || [ $? -eq 1 ]
sed -n '/^verdict/,/^refused/p; /^closest/p' $demo/motion.txt

step "What happened"
if [ $status -eq 0 ]; then
  cat <<TEXT
The microcontroller took set points a thousand times a second, in a timer's interrupt. It stopped the arm before it
hit itself or the fence, at every moment between two periods, and said the same as this machine, without a heap.

Look:  $demo/robot.html                   what of the arm can collide, and where
       $demo/motion.html                  the motion that was stopped
       $demo/scene.html                   two links, and how far apart they are
Next:  $flashbvh bake your.stl --unit mm -o baked
       and lib/docs/guide.md, from your mesh to the control loop
TEXT
else
  echo "The microcontroller and this machine disagree: see DIFFERS above. That is a bug in flashbvh."
fi
exit $status
