#!/bin/sh
# No command replaces a file that it reads: every output of every command against every input.
. "$SOURCES/common.sh"

"$FLASHBVH" bake meshes/ring.stl -o images --format image >/dev/null
echo "1 0 0 0 1 0 0 0 1 0 0 0" >poses
mkdir asked
cp poses asked/ring-ring
mkdir elsewhere
cp meshes/tetrahedron.stl elsewhere/part.stl
cat >arm.urdf <<'URDF'
<robot name="arm"><link name="base"><collision><geometry><mesh filename="elsewhere/part.stl" scale="0.1 0.1 0.1"/>
</geometry></collision></link><link name="tip"><collision><geometry><box size="0.1 0.1 0.1"/></geometry></collision>
</link><joint name="turn" type="revolute"><parent link="base"/><child link="tip"/><origin xyz="2 0 0"/>
<axis xyz="0 0 1"/><limit lower="-1" upper="1"/></joint></robot>
URDF
echo '<robot name="arm"></robot>' >arm.srdf
printf 'turn\n0\n' >way.csv
"$FLASHBVH" robot arm.urdf -o baked --format image >/dev/null 2>&1

# kept INPUT LINK ARGUMENT...: with LINK, another name of INPUT, as output. It is refused, and INPUT
# is what it was.
kept() {
  input=$1
  link=$2
  shift 2
  mkdir -p "$(dirname "$link")"
  ln "$input" "$link"
  cp "$input" before
  code=0
  "$FLASHBVH" "$@" >stdout 2>stderr || code=$?
  [ $code -eq 2 ] || fail "exit $code, not 2: $*"
  grep -q 'would replace\|is an image, which would be replaced' stderr || fail "$(cat stderr)"
  cmp "$input" before || fail "$input is replaced: $*"
  rm "$link"
}

a=images/ring.fbvh
for file in ring.fbvh ring.fbvh.hpp ring.fbvh.cpp; do
  kept meshes/ring.stl to/$file bake meshes/ring.stl -o to --format both
done
for file in ring.fbvh.h ring.fbvh.c; do
  kept meshes/ring.stl to/$file bake meshes/ring.stl -o to --format c
done
kept $a to/x.obj export $a -o to/x.obj
for input in $a poses; do
  kept $input to/x report $a $a --poses poses -o to/x
  kept $input to/x collide $a $a --poses poses --pairs to/x
  kept $input to/x clearance $a $a --poses poses --within 1 --pairs to/x
  kept $input to/x collide $a $a --poses poses --contacts to/x
done
kept asked/ring-ring to/x report $a $a --poses asked -o to/x
robot="robot arm.urdf --srdf arm.srdf -o to"
for input in arm.urdf arm.srdf elsewhere/part.stl; do
  for file in arm.robot arm.robot.hpp arm.robot.cpp; do
    kept $input to/$file $robot --format both
  done
  for file in arm.robot.h arm.robot.c; do
    kept $input to/$file $robot --format c
  done
  kept $input to/x $robot --depfile to/x
  kept $input to/x $robot --report to/x
done
for input in arm.urdf arm.srdf elsewhere/part.stl way.csv; do
  kept $input to/x guard arm.urdf way.csv --srdf arm.srdf --report to/x
done
for input in baked/arm.robot way.csv; do
  kept $input to/x guard baked/arm.robot way.csv --report to/x
done
