#!/bin/sh
# Files that make assimp abort, read out of bounds or take all memory, or that refer to files without
# an end: refused in one line, whatever assimp does.
. "$SOURCES/common.sh"

cat >good.dae <<'DAE'
<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<library_geometries><geometry id="g" name="g"><mesh>
<source id="p"><float_array id="a" count="12">0 0 0 9 0 0 0 9 0 0 0 9</float_array><technique_common>
<accessor source="#a" count="4" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/>
<p>0 2 1 0 1 3 1 2 3 2 0 3</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/></node>
</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>
DAE
exits 0 bake good.dae -o good
[ "$(awk '$1 == "good" { print $5 }' stdout)" -eq 4 ] || fail "$(cat stdout)"
crashed="can't be read: its reader crashed ("
# damaged WHAT SCRIPT: good.dae once sed changed it.
damaged() {
  sed "$2" good.dae >bad.dae
  cmp -s good.dae bad.dae && fail "nothing changed by $2"
  refused "bad.dae: $1" bake bad.dae -o out
  grep -q "; export the mesh again" stderr || fail "no fix: $(cat stderr)"
}
damaged "$crashed" 's/count="12"/count="#"/'
damaged "$crashed" 's/stride="3"/stride="2147483647"/'
damaged "can't be read: " 's/offset="0"/offset="99999999999"/'
# An index that is no integer: assimp appends triangles without end.
damaged "can't be read: takes over 1024 MiB of memory" 's/ 0 3</ 0 1e30</'

# The parts of a 3MF, and its checksums.
mkdir -p parts/_rels parts/3D
types='http://schemas.openxmlformats.org/package/2006'
cat >'parts/[Content_Types].xml' <<XML
<Types xmlns="$types/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/></Types>
XML
# relations MODEL
relations() {
  cat >parts/_rels/.rels <<XML
<Relationships xmlns="$types/relationships"><Relationship Target="/3D/$1" Id="r" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>
XML
}
# model COUNT: a tetrahedron, and COUNT vertices that nothing uses.
model() {
  echo '<model xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources><object id="1" type="model"><mesh><vertices>'
  printf '<vertex x="%s" y="%s" z="%s"/>' 0 0 0 9 0 0 0 9 0 0 0 9
  yes '<vertex x="0" y="0" z="0"/>' | head -n "$1"
  echo '</vertices><triangles>'
  printf '<triangle v1="%s" v2="%s" v3="%s"/>' 0 2 1 0 1 3 1 2 3 2 0 3
  echo '</triangles></mesh></object></resources><build><item objectid="1"/></build></model>'
}
# pack NAME
pack() { (cd parts && python3 -m zipfile -c "../$1" '[Content_Types].xml' _rels 3D); }
relations model.model
model 0 >parts/3D/model.model
pack good.3mf
exits 0 bake good.3mf -o good
[ "$(awk '$1 == "good" { print $5 }' stdout)" -eq 4 ] || fail "$(cat stdout)"
# The checksum of the model, in its local header and in the directory.
python3 - <<'PYTHON'
import zipfile
bytes = open("good.3mf", "rb").read()
crc = zipfile.ZipFile("good.3mf").getinfo("3D/model.model").CRC.to_bytes(4, "little")
open("checksum.3mf", "wb").write(bytes.replace(crc, b"\1\2\3\4"))
open("cut.3mf", "wb").write(bytes[:-30])
PYTHON
refused "checksum.3mf: $crashed" bake checksum.3mf -o out
refused "cut.3mf: can't be read" bake cut.3mf -o out
relations another.model
pack lacking.3mf
refused "lacking.3mf: $crashed" bake lacking.3mf -o out
if thorough; then
  relations model.model
  model 20000000 >parts/3D/model.model
  pack bomb.3mf
  rm parts/3D/model.model
  [ "$(wc -c <bomb.3mf)" -lt 2000000 ] || fail "not packed"
  refused "bomb.3mf: can't be read: takes over 1" bake bomb.3mf -o out
fi

# What a file refers to may have no end, or nobody who writes it.
mkfifo pipe.bin
ln -s /dev/zero zero.bin
for buffer in pipe.bin zero.bin missing.bin; do
  cat >refers.gltf <<GLTF
{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],
"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":"$buffer"}]}
GLTF
  refused "refers.gltf: can't be read" bake refers.gltf -o out
done
