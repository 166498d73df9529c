#!/bin/sh
# What assimp reads: nodes' transforms and units count, bodies are nodes, floats are said to be floats.
. "$SOURCES/common.sh"

# vertices MESH CELL: those of the lattice mesh, one a line.
vertices() {
  "$FLASHBVH" bake "$1" -o lattice --cell "$2" --format image >table 2>warnings || fail "$(cat warnings)"
  name=${1##*/}
  "$FLASHBVH" export --cells "lattice/${name%.*}.fbvh" -o lattice.obj
  grep '^v' lattice.obj
}

# Collada: a triangle in millimetres; the result is in metres, turned by its nodes, not by its up axis.
cat >arm.dae <<'DAE'
<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit meter="0.001" name="millimeter"/><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g" name="g"><mesh>
<source id="p"><float_array id="a" count="9">0 0 0 2 0 0 0 4 8</float_array><technique_common>
<accessor source="#a" count="3" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="upper" name="upper arm">
<translate>100 0 0</translate><rotate>0 0 1 90</rotate><instance_geometry url="#g"/>
<node id="lower" name="lower"><scale>2 2 2</scale><instance_geometry url="#g"/></node>
</node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene>
</COLLADA>
DAE
vertices arm.dae 0.001 >found
printf 'v %s\n' '100 0 0' '100 2 0' '96 0 8' '100 4 0' '92 0 16' >wanted
cmp wanted found || fail "DAE: $(cat found)"
sed 's/Z_UP/X_UP/' arm.dae >x_up.dae
vertices x_up.dae 0.001 >found
cmp wanted found || fail "DAE, X up: $(cat found)"
exits 0 bake arm.dae -o mm --cell 1 --unit mm --unit arm.dae=m --format image
exits 0 check mm/arm.fbvh --mesh arm.dae --unit mm --unit arm.dae=m
exits 0 bake arm.dae -o bodies --cell 0.001 --split
[ "$(cd bodies && echo *.fbvh)" = "lower.fbvh upper_arm.fbvh" ] || fail "$(ls bodies)"
exits 0 check bodies/lower.fbvh --mesh arm.dae --body lower
exits 1 check bodies/lower.fbvh --mesh arm.dae --body upper_arm
cut=$(head -c 700 arm.dae)
printf '%s' "$cut" >cut.dae
refused "cut.dae: can't be read" bake cut.dae -o out

# glTF: a triangle (0 0 0), (1 0 0), (0 1 0), a million away.
buffer=$(printf '\0\0\0\0\0\0\0\0\0\0\0\0\0\0\200\77\0\0\0\0\0\0\0\0\0\0\0\0\0\0\200\77\0\0\0\0' | base64)
gltf() {
  cat <<GLTF
{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
"nodes":[{"mesh":0,"name":"far","translation":[$1,0,0]}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],
"bufferViews":[{"buffer":0,"byteLength":36}],
"buffers":[{"byteLength":36,"uri":"$2"}]}
GLTF
}
gltf 1000000 "data:application/octet-stream;base64,$buffer" >far.gltf
vertices far.gltf 0.0625 >found
printf 'v %s\n' '16000000 0 0' '16000016 0 0' '16000000 16 0' >wanted
cmp wanted found || fail "glTF: $(cat found)"
grep 'floats' warnings && fail "a warning, though floats are as fine as half a cell"
exits 0 bake far.gltf -o far --cell 0.0625 --format image
exits 0 bake far.gltf -o far --cell 0.05 --format image
grep -q "far.gltf: warning: its coordinates are read as 32-bit floats, which may be off by 0.03125, \
more than half a cell of 0.05; export it as STL or PLY, or nearer to its origin" stderr || fail "$(cat stderr)"
exits 0 bake far.gltf -o far --cell 50 --format image --unit mm --unit far.gltf=m
grep -q 'may be off by 31.25, more than half a cell of 50;' stderr || fail "$(cat stderr)"
exits 0 bake far.gltf -o far --cell 62.5 --format image --unit mm --unit far.gltf=m
grep 'floats' stderr && fail "$(cat stderr)"
gltf 1 triangle.bin >beside.gltf
refused "beside.gltf: can't be read" bake beside.gltf -o out
printf '%s' "$buffer" | base64 -d >triangle.bin
vertices beside.gltf 1 >found
grep -q '^v 2 0 0$' found || fail "glTF with a file beside it: $(cat found)"

# GLB: the same in one binary file; its first version, which assimp misreads, is refused.
le32() {
  printf "\\$(printf %o $(($1 % 256)))\\$(printf %o $(($1 / 256 % 256)))\\0\\0"
}
gltf 1 "" | sed 's/,"uri":""//' | tr '\n' ' ' >json
while [ $(($(wc -c <json) % 4)) -ne 0 ]; do printf ' ' >>json; done
size=$(wc -c <json)
{
  printf 'glTF\2\0\0\0' && le32 $((12 + 8 + size + 8 + 36)) && le32 "$size" && printf JSON && cat json
  le32 36 && printf 'BIN\0' && cat triangle.bin
} >part.glb
vertices part.glb 1 >other
cmp found other || fail "GLB: $(cat other)"
{ printf 'glTF\1' && tail -c +6 part.glb; } >first.glb
refused "first.glb: is of glTF 1; export it as glTF 2" bake first.glb -o out
cp part.glb part.GLB
exits 0 info part.GLB

# 3MF: objects placed by items and components, numbers as they are whatever the unit.
mkdir -p 3mf/_rels 3mf/3D
cat >'3mf/[Content_Types].xml' <<'XML'
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>
XML
cat >3mf/_rels/.rels <<'XML'
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target="/3D/3dmodel.model" Id="r" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>
XML
cat >3mf/3D/3dmodel.model <<'XML'
<model unit="inch" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources>
<object id="1" type="model"><mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/>
<vertex x="0" y="2" z="3"/></vertices><triangles><triangle v1="0" v2="1" v3="2"/></triangles></mesh></object>
<object id="2" type="model"><components>
<component objectid="1" transform="1 0 0 0 1 0 0 0 1 0 0 50"/></components></object>
</resources><build><item objectid="2" transform="0 1 0 -1 0 0 0 0 1 10 20 30"/>
<item objectid="1" transform="1 0 0 0 1 0 0 0 1 5 6 7"/></build></model>
XML
(cd 3mf && python3 -m zipfile -c ../parts.3mf '[Content_Types].xml' _rels 3D)
vertices parts.3mf 1 >found
printf 'v %s\n' '10 20 80' '10 21 80' '8 20 83' '5 6 7' '6 6 7' '5 8 10' >wanted
cmp wanted found || fail "3MF: $(cat found)"
exits 0 bake parts.3mf -o objects --cell 1 --split
[ "$(cd objects && echo *.fbvh)" = "Object_1.fbvh Object_1_2.fbvh" ] || fail "$(ls objects)"

# What is no mesh, with what to do.
for name in part.step part.STP part.igs part.fcstd part.f3d part.sldprt; do
  echo x >$name
  refused "$name: is a model of CAD, not a mesh; export it as STL or 3MF from CAD" bake $name -o out
done
refused "part.step: is a model of CAD" info part.step
for name in arm.urdf arm.xacro; do
  echo x >$name
  refused "$name: is a robot, not a mesh; bake its meshes one by one" bake $name -o out
done
for name in part.fbx part.3ds part.blend; do
  echo x >$name
  refused "$name: is no mesh by its extension; convert it to one of STL, OBJ, PLY, OFF, DAE, glTF, GLB, \
3MF" bake $name -o out
done

# Pipes and devices.
mkfifo pipe.obj pipe.glb
cat meshes/ring.stl >pipe.glb &
refused "pipe.glb: is a pipe, from which this format can't be read; name a file" bake pipe.glb -o out
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >pipe.obj &
exits 0 bake pipe.obj -o piped
ln -s /dev/zero zero.stl
refused "zero.stl: is a device; name a file or a pipe" bake zero.stl -o out
refused "/dev/zero: is a device" info /dev/zero
truncate -s 4G sparse.stl
refused "sparse.stl: has 4 GiB or more; cut it in parts" bake sparse.stl -o out
