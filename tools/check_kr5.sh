#!/bin/sh
# check_kr5.sh: bakes a KUKA KR5 in its cell. The programs of proofs/robot, which share no code with the baker, confirm
# the result (lib/docs/proofs.md). About a minute once everything is built.
set -eu
cd "$(dirname "$0")/.."
. tools/kr5.sh
fetch_kr5 build/kr5
cmake --preset native -DFLASHBVH_KR5="$PWD/${kr5%/*}" >build/kr5/log
cmake --build --preset native --target flashbvh_tool flashbvh_check_robot >>build/kr5/log
cell=build/native/firmware_examples/robot_guard/kr5_cell.urdf
build/native/bin/flashbvh robot "$cell" -o build/kr5 --stop 0.005 --warn 0.03 --pair forearm,palm=0.001 \
  --format image --name kr5_cell >>build/kr5/log 2>&1
python3 -B proofs/robot/urdf.py build/kr5/kr5_cell.robot "$cell"
began=$(date +%s)
build/native/bin/flashbvh_check_robot build/kr5/kr5_cell.robot
echo "confirmed in $(($(date +%s) - began)) s"
