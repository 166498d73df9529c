"""Files that break readers, which the host program refuses in one line."""
import os
import zipfile
from pathlib import Path

from checks import THOROUGH, flashbvh, gltf, hold, refused, write

CRASHED = "can't be read: its reader crashed ("


COLLADA = """<?xml version="1.0"?>
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
"""
TYPES = "http://schemas.openxmlformats.org/package/2006"
MODEL = ('<model xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources>'
         '<object id="1" type="model"><mesh><vertices>', "</vertices><triangles>",
         '</triangles></mesh></object></resources><build><item objectid="1"/></build></model>\n')


def bakes_tetrahedron(file):
    said = flashbvh("bake", file, "-o", "good")
    hold(["4"] == [line.split()[4] for line in said.splitlines() if line.startswith("good ")], said)


def pack(name, target="model.model", unused=0):
    """A 3MF of a tetrahedron and so many vertices that nothing uses; its relations name `target`."""
    vertices = "".join(f'<vertex x="{x}" y="{y}" z="{z}"/>' for x, y, z in
                       ((0, 0, 0), (9, 0, 0), (0, 9, 0), (0, 0, 9)))
    triangles = "".join(f'<triangle v1="{a}" v2="{b}" v3="{c}"/>' for a, b, c in
                        ((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)))
    with zipfile.ZipFile(name, "w", zipfile.ZIP_DEFLATED) as file:
        file.writestr("[Content_Types].xml", f'<Types xmlns="{TYPES}/content-types"><Default Extension="rels" '
                      'ContentType="application/vnd.openxmlformats-package.relationships+xml"/></Types>\n')
        file.writestr("_rels/.rels", f'<Relationships xmlns="{TYPES}/relationships"><Relationship '
                      f'Target="/3D/{target}" Id="r" '
                      'Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>\n')
        file.writestr("3D/model.model", MODEL[0] + vertices + '<vertex x="0" y="0" z="0"/>\n' * unused
                      + MODEL[1] + triangles + MODEL[2])


def damaged_scenes():
    """Files that make assimp abort, read out of bounds or take all memory, or that refer to files without an end:
    refused in one line, whatever assimp does."""
    write("good.dae", COLLADA)
    bakes_tetrahedron("good.dae")
    for what, old, new in (
            (CRASHED, 'count="12"', 'count="#"'), (CRASHED, 'stride="3"', 'stride="2147483647"'),
            ("can't be read: ", 'offset="0"', 'offset="99999999999"'),
            # An index that is no integer: assimp appends triangles without end.
            ("can't be read: takes over 1024 MiB of memory", " 0 3<", " 0 1e30<")):
        hold(old in COLLADA, f"nothing changed: {old}")
        write("bad.dae", COLLADA.replace(old, new))
        warnings = refused(f"bad.dae: {what}", "bake", "bad.dae", "-o", "out").warnings
        hold("; export the mesh again" in warnings, f"no fix: {warnings}")

    # The parts of a 3MF, and its checksums: of the model, in its local header and in the directory.
    pack("good.3mf")
    bakes_tetrahedron("good.3mf")
    whole = Path("good.3mf").read_bytes()
    checksum = zipfile.ZipFile("good.3mf").getinfo("3D/model.model").CRC.to_bytes(4, "little")
    Path("checksum.3mf").write_bytes(whole.replace(checksum, b"\1\2\3\4"))
    Path("cut.3mf").write_bytes(whole[:-30])
    refused(f"checksum.3mf: {CRASHED}", "bake", "checksum.3mf", "-o", "out")
    refused("cut.3mf: can't be read", "bake", "cut.3mf", "-o", "out")
    pack("lacking.3mf", target="another.model")
    refused(f"lacking.3mf: {CRASHED}", "bake", "lacking.3mf", "-o", "out")
    if THOROUGH:
        pack("bomb.3mf", unused=20000000)
        hold(Path("bomb.3mf").stat().st_size < 2000000, "not packed")
        refused("bomb.3mf: can't be read: takes over 1", "bake", "bomb.3mf", "-o", "out")

    # What a file refers to may have no end, or nobody who writes it.
    os.mkfifo("pipe.bin")
    os.symlink("/dev/zero", "zero.bin")
    for buffer in "pipe.bin", "zero.bin", "missing.bin":
        write("refers.gltf", gltf(0, buffer))
        refused("refers.gltf: can't be read", "bake", "refers.gltf", "-o", "out")
