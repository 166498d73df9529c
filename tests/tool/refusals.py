"""What the host program refuses in one line: command lines that make no sense, and files that break readers."""
import os
import re
import shutil
import zipfile
from pathlib import Path

from command_line import HOME, THOROUGH, flashbvh, hold, refused, same, write

CRASHED = "can't be read: its reader crashed ("


def bad_options():
    """Each is refused with one line that says where the help is."""
    refused("a command is missing")
    refused("no command 'cook'", "cook")
    refused("--frobnicate", "--frobnicate")
    refused("required", "bake")
    refused("required", "info")
    refused("--output", "bake", "meshes/ring.stl")
    ring, bake = ["bake", "meshes/ring.stl", "-o", "out"], ["bake", "missing.stl", "-o", "out"]
    refused("--frobnicate", *ring, "--frobnicate")
    for option, *values in (("--format", "xml"), ("--layout", "random"), ("--builder", "sah2"),
                            ("--leaf-size", 0, 17), ("--arity", 1, 9), ("--index-bits", 8),
                            ("--cell", 0, -1, "nan", "inf", "1e-300", "1e300", "abc", "")):
        for value in values:
            refused(option, *ring, option, value)
    refused("--index-bits: x not in {16,32}", *ring, "--index-bits", "x")
    for size in "-1", "0", "1.5", "4294967296", "99999999999999999999", "many", "":
        refused(f"--max-bytes {size}: is no number of bytes; give one from 1 to 4294967295", *bake, "--max-bytes",
                size)
    # Before any file is read.
    for option, value in ("--cell", "abc"), ("--max-deviation", "abc"), ("--unit", "yard"):
        refused(f"{option} {value}", *bake, option, value)
    refused("--name", "bake", "meshes/ring.stl", "meshes/coarse.stl", "-o", "out", "--name", "both")
    for what, name in (("--name class", "class"), ("--name: is empty; give a name", ""),
                       ("--name __x: is a name that C or C++ takes; use another, such as m__x", "__x"),
                       ("--name 2nd", "2nd")):
        refused(what, *ring, "--name", name)
    refused("missing.fbvh: can't be opened", "info", "missing.fbvh")
    write("empty.fbvh", "")
    refused("empty.fbvh: is empty", "info", "empty.fbvh")
    refused("ring.stl: is no flashbvh image", "check", "meshes/ring.stl")

    flashbvh("bake", "meshes/ring.stl", "-o", "images")
    image = "images/ring.fbvh"
    refused("required", "export", image)
    for what, pose in (("has 3 numbers", "1 2 3"),
                       ("the first 9 numbers are no rotation", "1 0 0 0 1 0 0 0 1.1 0 0 0"),
                       ("the matrix mirrors", "-1 0 0 0 -1 0 0 0 -1 0 0 0"),
                       ("the pose translates B", f"{HOME} 0 0 1e30")):
        refused(f"--pose: {what}", "export", image, "-o", "out.obj", "--pose", pose)
    refused("meshes: is a folder", "export", image, "-o", "meshes")
    slips(image)

    # Where nothing can be written, nothing is left over.
    write("plain_file", "")
    refused("plain_file: is no folder; write elsewhere", "bake", "meshes/ring.stl", "-o", "plain_file/out")
    Path("taken/ring.fbvh.cpp").mkdir(parents=True)
    refused("ring.fbvh.cpp: is a folder", "bake", "meshes/ring.stl", "-o", "taken")
    hold(os.listdir("taken") == ["ring.fbvh.cpp"], f"left over: {os.listdir('taken')}")

    for command in [], *([name] for name in ("bake", "info", "check", "export", "report", "collide")):
        flashbvh(*command, "--help").holds("Usage")
    flashbvh("--version").holds(r"^flashbvh [0-9]*\.[0-9]*\.[0-9]*$")


def slips(image):
    """A slip costs no file that was read, and no image."""
    shutil.copy(image, "kept.fbvh")
    os.symlink(image, "link.obj")
    for mesh in image, "kept.fbvh", "link.obj":
        refused(f"{mesh}: is an image, which would be replaced; write elsewhere", "export", image, "-o", mesh)
    write("poses", f"{HOME} 0 0 0")
    os.link("poses", "same_poses")
    for pairs in "poses", "./poses", "same_poses":
        refused(f"{pairs}: would replace poses, which is read; write elsewhere", "collide", image, image, "--poses",
                "poses", "--pairs", pairs)
    refused("kept.fbvh: is an image", "collide", image, image, "--poses", "poses", "--pairs", "kept.fbvh")
    same(image, "kept.fbvh")
    Path("linked").mkdir()
    os.link("meshes/ring.stl", "linked/ring.fbvh.hpp")
    refused("linked/ring.fbvh.hpp: would replace meshes/ring.stl", "bake", "meshes/ring.stl", "-o", "linked")


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
GLTF = """{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],
"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":"BUFFER"}]}
"""


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
        warnings = refused(f"bad.dae: {what}", "bake", "bad.dae", "-o", "out")
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
        write("refers.gltf", GLTF.replace("BUFFER", buffer))
        refused("refers.gltf: can't be read", "bake", "refers.gltf", "-o", "out")
