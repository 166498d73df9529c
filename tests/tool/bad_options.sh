#!/bin/sh
# Command lines that make no sense are refused with one line that says where the help is.
. "$SOURCES/common.sh"

refused "a command is missing"
refused "no command 'cook'" cook
refused "--frobnicate" bake meshes/ring.stl -o out --frobnicate
refused "--frobnicate" --frobnicate
refused "required" bake
refused "--output" bake meshes/ring.stl
refused "--format" bake meshes/ring.stl -o out --format xml
refused "--layout" bake meshes/ring.stl -o out --layout random
refused "--builder" bake meshes/ring.stl -o out --builder sah2
refused "--leaf-size" bake meshes/ring.stl -o out --leaf-size 0
refused "--leaf-size" bake meshes/ring.stl -o out --leaf-size 17
refused "--arity" bake meshes/ring.stl -o out --arity 1
refused "--arity" bake meshes/ring.stl -o out --arity 9
refused "--index-bits" bake meshes/ring.stl -o out --index-bits 8
refused "--index-bits: x not in {16,32}" bake meshes/ring.stl -o out --index-bits x
for bytes in -1 0 1.5 4294967296 99999999999999999999 many ""; do
  refused "--max-bytes $bytes: is no number of bytes; give one from 1 to 4294967295" \
    bake missing.stl -o out --max-bytes "$bytes"
done
for cell in 0 -1 nan inf 1e-300 1e300 abc ""; do
  refused "--cell" bake meshes/ring.stl -o out --cell "$cell"
done
# Before any file is read.
refused "--cell abc" bake missing.stl -o out --cell abc
refused "--max-deviation abc" bake missing.stl -o out --max-deviation abc
refused "--unit yard" bake missing.stl -o out --unit yard
refused "--name" bake meshes/ring.stl meshes/coarse.stl -o out --name both
refused "--name class" bake meshes/ring.stl -o out --name class
refused "--name: is empty; give a name" bake meshes/ring.stl -o out --name ""
refused "--name __x: is a name that C or C++ takes; use another, such as m__x" \
  bake meshes/ring.stl -o out --name __x
refused "--name 2nd" bake meshes/ring.stl -o out --name 2nd
refused "required" info
refused "missing.fbvh: can't be opened" info missing.fbvh
: >empty.fbvh
refused "empty.fbvh: is empty" info empty.fbvh
refused "ring.stl: is no flashbvh image" check meshes/ring.stl

"$FLASHBVH" bake meshes/ring.stl -o images >/dev/null
refused "required" export images/ring.fbvh
refused "--pose: has 3 numbers" export images/ring.fbvh -o out.obj --pose "1 2 3"
refused "--pose: the first 9 numbers are no rotation" \
  export images/ring.fbvh -o out.obj --pose "1 0 0 0 1 0 0 0 1.1 0 0 0"
refused "--pose: the matrix mirrors" \
  export images/ring.fbvh -o out.obj --pose "-1 0 0 0 -1 0 0 0 -1 0 0 0"
refused "--pose: the pose translates B" \
  export images/ring.fbvh -o out.obj --pose "1 0 0 0 1 0 0 0 1 0 0 1e30"
refused "meshes: is a folder" export images/ring.fbvh -o meshes

# A slip costs no file that was read, and no image.
cp images/ring.fbvh kept.fbvh
ln -s images/ring.fbvh link.obj
for mesh in images/ring.fbvh kept.fbvh link.obj; do
  refused "$mesh: is an image, which would be replaced; write elsewhere" \
    export images/ring.fbvh -o $mesh
done
echo "1 0 0 0 1 0 0 0 1 0 0 0" >poses
ln poses same_poses
for pairs in poses ./poses same_poses; do
  refused "$pairs: would replace poses, which is read; write elsewhere" \
    collide images/ring.fbvh images/ring.fbvh --poses poses --pairs $pairs
done
refused "kept.fbvh: is an image" \
  collide images/ring.fbvh images/ring.fbvh --poses poses --pairs kept.fbvh
cmp images/ring.fbvh kept.fbvh
mkdir linked
ln meshes/ring.stl linked/ring.fbvh.hpp
refused "linked/ring.fbvh.hpp: would replace meshes/ring.stl" bake meshes/ring.stl -o linked

# Where nothing can be written, nothing is left over.
: >plain_file
refused "plain_file: is no folder; write elsewhere" bake meshes/ring.stl -o plain_file/out
mkdir -p taken/ring.fbvh.cpp
refused "ring.fbvh.cpp: is a folder" bake meshes/ring.stl -o taken
[ "$(ls taken)" = ring.fbvh.cpp ] || fail "left over: $(ls taken)"

for command in "" bake info check export report collide; do
  # shellcheck disable=SC2086
  "$FLASHBVH" $command --help | grep -q Usage || fail "no help for '$command'"
done
"$FLASHBVH" --version | grep -q '^flashbvh [0-9]*\.[0-9]*\.[0-9]*$' || fail "no version"
