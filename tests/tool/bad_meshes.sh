#!/bin/sh
# Every kind of unusable mesh is refused by its name and place, and nothing is written.
. "$SOURCES/common.sh"

bad() {
  refused "$1" bake meshes/tetrahedron.stl "$2" -o out
}

refused "missing.stl: can't be opened" bake missing.stl -o out
refused "is a folder" bake meshes -o out
: >empty.stl
bad "empty.stl: is empty" empty.stl
: >empty.obj
bad "empty.obj: is empty" empty.obj
bad "triangle" meshes/no_triangles.stl
bad "is no mesh by its extension; convert it to one of STL, OBJ" "$SOURCES/common.sh"
cp meshes/tetrahedron.stl mesh.xyz
bad "mesh.xyz: is no mesh" mesh.xyz

# Not a mesh.
head -c 300 "$FLASHBVH" >program.stl
cp program.stl program.obj
cp program.stl program.ply
cp program.stl program.off
for kind in stl obj ply off; do
  bad "program.$kind" program.$kind
done
printf 'solid in words only, and long enough to be taken for a header of eighty bytes or more.\n' >words.stl
bad "words.stl" words.stl
printf 'just words\n' >words.obj
bad "words.obj:1: 'just'" words.obj

# Coordinates that are no numbers.
bad "nan.stl: polygon 2" meshes/nan.stl
bad "infinite.stl: polygon 2" meshes/infinite.stl
printf 'v 0 0 0\nv 1 0 0\nv 0 nan 0\nf 1 2 3\n' >nan.obj
bad "nan.obj:3: 'nan'" nan.obj
printf 'v 0 0 0\nv 1 0 0\nv 0 1e999 0\nf 1 2 3\n' >huge.obj
bad "huge.obj:3: '1e999'" huge.obj
printf 'v 0 0 0\nv 1 0 0\nv 0 1e39 0\nf 1 2 3\n' >float.obj
bad "float.obj:3: '1e39' is no finite number of at most 3.4e38" float.obj
printf 'OFF\n3 1 0\n0 0 0\n1 0 inf\n0 1 0\n3 0 1 2\n' >inf.off
bad "inf.off:4: 'inf'" inf.off
printf 'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n' >nan.ply
bad "nan.ply: vertex 1" nan.ply

# Truncated at many places, with FLASHBVH_THOROUGH at more: each is refused, whatever is left.
head -c 1000 meshes/ring.stl >cut.stl
bad "cut.stl: is truncated" cut.stl
printf '%s\n' 'solid a' 'facet normal 0 0 1' 'outer loop' 'vertex 0 0 0' 'vertex 1 0 0' \
  'vertex 0 1 0' 'endloop' 'endfacet' 'facet normal 0 0 1' 'outer loop' 'vertex 0 0 0' \
  'vertex 1 0 1' 'vertex 0 1.25 0' 'endloop' 'endfacet' 'endsolid a' >whole.stl
"$FLASHBVH" bake whole.stl -o whole >/dev/null
printf 'OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 2 3\n' >whole.off
"$FLASHBVH" bake whole.off -o whole >/dev/null
sed 's/float y/float y\nproperty uchar red/; s/nan/0 255/; s/^0 0 0$/0 0 255 0/; s/^1 0 0 255$/1 0 255 0/; s/^0 1 0$/0 1 255 0/' \
  nan.ply >whole.ply
"$FLASHBVH" bake whole.ply -o whole >/dev/null
step=29
! thorough || step=7
for kind in stl off ply; do
  # The last bytes may go: a line end, the name after 'endsolid', none of the last index.
  size=$(($(wc -c <whole.$kind) - 6))
  for length in $(seq 1 $step $size) $size; do
    head -c "$length" whole.$kind >cut.$kind
    bad "cut.$kind" cut.$kind
  done
done

# Indices and counts that don't fit.
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n' >range.obj
bad "range.obj:4: a corner at vertex '4'" range.obj
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n' >before.obj
bad "before.obj:4: a corner at vertex '-4'" before.obj
printf 'v 0 0 0\nv 1 0\nv 0 1 0\nf 1 2 3\n' >short.obj
bad "short.obj:2: a vertex of 2" short.obj
printf 'v 0 0 0\nv 1 0 0\nf 1 2\n' >segment.obj
bad "segment.obj:3: a polygon of 2" segment.obj
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2 3\n' >line.obj
bad "no polygons" line.obj 2>/dev/null || true
sed 's/^3 0 2 3$/3 0 2 4/' whole.off >range.off
bad "range.off:8: a corner at vertex '4'" range.off
sed 's/^3 0 1 2$/3 0 1 7/' whole.ply >range.ply
bad "range.ply: face 0 of 1: a corner at vertex 7" range.ply
sed 's/element face 1/element face 2/' whole.ply >more.ply
bad "more.ply: face 1 of 2: the file ends here" more.ply
cat whole.off whole.off >twice.off
bad "twice.off:9: there is more" twice.off

# Too large for the cell: the message names one that fits.
refused "too large for a cell of 1e-04" bake meshes/ring.stl -o out --cell 0.0001
cell=$(sed 's/.*--cell //' stderr)
"$FLASHBVH" bake meshes/ring.stl -o fitting --cell "$cell" >/dev/null

# Too many for 16 bits: the message names the mend, and the mend works (--index-bits 32: large() in bakes.py).
refused "many_nodes.stl: 79999 nodes, but 16-bit indices reach 65535; use a larger --leaf-size" \
  bake meshes/many_nodes.stl -o out --leaf-size 1 --builder median
! thorough || refused "many_nodes.stl: 79999 nodes" \
  bake meshes/many_nodes.stl -o out --leaf-size 1 --arity 2
refused "many_nodes.stl: 40000 leaves, but 16-bit indices reach 32768; use a larger --leaf-size" \
  bake meshes/many_nodes.stl -o out --leaf-size 1
"$FLASHBVH" bake meshes/many_nodes.stl -o many >/dev/null
refused "many_vertices.stl: 66000 vertices, but" bake meshes/many_vertices.stl -o out --cell 0.25 \
  --builder median
refused "many_triangles.stl: 66000 triangles, but" bake meshes/many_triangles.stl -o out \
  --builder median

# Over budget.
refused "takes 1" bake meshes/ring.stl -o out --max-bytes 9000
grep -qF 'allows 9000' stderr || fail "$(cat stderr)"

# Two meshes that would be written to one file.
mkdir other
cp meshes/ring.stl other/ring.STL
refused "other/ring.STL" bake meshes/ring.stl other/ring.STL -o out

cp meshes/ring.stl other/RING.stl
refused "other/RING.stl: would be written as 'RING' like 'ring' but for the case, which some file systems \
ignore; rename one of the files" bake meshes/ring.stl other/RING.stl -o out

# Counts that no file can hold are refused at once.
printf 'ply\nformat ascii 1.0\nelement vertex 9000000000000000000\nend_header\n' >endless.ply
refused "endless.ply: vertex 0 of 9000000000000000000: no properties" bake endless.ply -o out
printf 'OFF\n4000000000 4000000000 0\n0 0 0\n' >endless.off
refused "endless.off:3: the file ends at vertex 1" bake endless.off -o out

# Named where an image is expected: what it is, and what to do.
echo BLENDER >part.blend
refused "part.blend: is no mesh by its extension; convert it to one of STL" info part.blend
echo ISO-10303-21 >part.step
refused "part.step: is a model of CAD, not a mesh; export it" info part.step
for name in part.blend part.step meshes/ring.stl; do
  refused "$name: is no flashbvh image but a mesh; name its image, and the mesh by --mesh" check $name
done
echo few >few.fbvh
echo few >few
refused "few.fbvh: is no flashbvh image; name a .fbvh file" check few.fbvh
refused "few: is no flashbvh image; name a .fbvh file" info few
echo few >few.robot
refused "few.robot: is no image of a robot; name one that" check few.robot
for folder in folder.stl folder.robot folder.fbvh; do
  mkdir $folder
  refused "$folder: is a folder; name a file" info $folder
done
ln -s /dev/null null.stl
refused "null.stl: is a device; name a file or a pipe" info null.stl
for content in '{}' '{"asset":{"version":"2.0"}}' \
  '{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}]}'; do
  echo "$content" >part.gltf
  refused "part.gltf: can't be read: " bake part.gltf -o out
done
