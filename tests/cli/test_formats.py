"""Meshes in formats other than STL: placements and units apply, and float coordinates are reported. What readers read
and refuse: tests/mesh."""
import base64
import os
import shutil
import struct
import subprocess
import zipfile
from pathlib import Path

from cli import Case, fixture, flashbvh, refuse, refuse_each, text, write
from inputs import box_in_cells, meshes


# One triangle in inches.
@fixture
def parts():
    write("3mf/_rels/.rels", """
        <Relationships><Relationship Target="/3D/3dmodel.model" Id="r"
        Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>""")
    write("3mf/3D/3dmodel.model", """
        <model unit="inch" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources>
        <object id="1" type="model"><mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/>
        <vertex x="0" y="2" z="5"/></vertices><triangles><triangle v1="0" v2="1" v3="2"/></triangles></mesh></object>
        </resources><build><item objectid="1"/></build></model>""")
    os.rename(shutil.make_archive("parts", "zip", "3mf"), "parts.3mf")


TRIANGLE = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0)  # a buffer of glTF
INLINE = "data:application/octet-stream;base64," + base64.b64encode(TRIANGLE).decode()


def gltf(x, buffer):
    """A glTF of one triangle, translated along x; its buffer's address may be empty."""
    return (f'{{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],\n'
            f'"nodes":[{{"mesh":0,"name":"far","translation":[{x},0,0]}}],\n'
            '"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],\n'
            '"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],\n'
            f'"bufferViews":[{{"buffer":0,"byteLength":36}}],"buffers":[{{"byteLength":36,"uri":"{buffer}"}}]}}\n')


def baked_box(mesh, cell):
    """A mesh's box in cells."""
    flashbvh(f"bake {mesh} -o lattice --format image --cell {cell}")
    return box_in_cells(f"lattice/{Path(mesh).stem}.fbvh")


class FormatsTest(Case):
    # A triangle (0 0 0), (1 0 0), (0 1 0), a million away.
    def test_gltf_is_read_as_floats_which_is_said_where_they_are_coarser_than_half_a_cell(self):
        write("far.gltf", gltf(1000000, INLINE))
        self.assertEqual(baked_box("far.gltf", 0.0625), [[16000000, 0, 0], [16000016, 16, 0]])
        for options, warning in (
                ("--cell 0.0625", ""),
                ("--cell 0.05", "far.gltf: warning: its coordinates are read as 32-bit floats, which may be off by "
                    "0.03125, more than half a cell of 0.05; export it as STL or PLY, or nearer to its origin"),
                ("--cell 50 --unit mm --unit far.gltf=m", "may be off by 31.25, more than half a cell of 50;"),
                ("--cell 62.5 --unit mm --unit far.gltf=m", "")):
            with self.subTest(options):
                out = flashbvh(f"bake far.gltf -o far {options} --format image")
                self.assertIn(warning, out.err)
                self.assertEqual("floats" in out.err, bool(warning))
        # What its reader may be off by is part of each proven length.
        out = flashbvh("bake far.gltf -o far --cell 0.0625 --json")
        self.assertTrue(0.0541 < out.json["meshes"][0]["deviation"] < 0.0542)
        out = flashbvh("bake far.gltf -o far --cell 0.0625 --simplify 0.25 --json")
        self.assertTrue(0.0541 < out.json["meshes"][0]["deviation"] <= 0.25)
        refuse_each("bake far.gltf -o out --cell 0.0625", {
            "--max-deviation 0.05": "far.gltf: rounding moves a vertex by 0.0541",
            "--simplify 0.25 --max-deviation 0.05": "0.0541",
            "--simplify 0.05": "--simplify 0.05: is less than rounding moves a vertex of far.gltf, 0.0541",
        })

    def test_glb_and_its_first_version_which_assimp_misreads(self):
        scene = gltf(1, "").replace(',"uri":""', "").replace("\n", " ").encode()
        scene = scene + b" " * (-len(scene) % 4)
        chunks = struct.pack("<I4s", len(scene), b"JSON") + scene + struct.pack("<I4s", 36, b"BIN\0") + TRIANGLE
        Path("part.glb").write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks)
        self.assertEqual(baked_box("part.glb", 1), [[1, 0, 0], [2, 1, 0]])
        Path("first.glb").write_bytes(struct.pack("<4sII", b"glTF", 1, 12 + len(chunks)) + chunks)
        refuse("bake first.glb -o out", "first.glb: is of glTF 1; export it as glTF 2")
        os.rename("part.glb", "part.GLB")
        flashbvh("bake part.GLB --dry-run")

    def test_the_unit_that_a_file_carries_converts_it(self):
        parts()
        write("part.gltf", gltf(1, INLINE))
        write("b.obj", "v 0 0 0\nv 900 0 0\nv 0 900 0\nf 1 2 3\n")
        out = flashbvh("bake part.gltf parts.3mf b.obj --cell 0.1 --unit mm -o mm --json")
        self.assertEqual([mesh["size"] for mesh in out.json["meshes"]],
                         [[1000, 1000, 0], [25.4, 50.8, 127], [900, 900, 0]])
        out.err.lacks("unit")
        out = flashbvh("bake parts.3mf --unit mm --unit parts.3mf=m -o taken --json")
        self.assertEqual(out.json["meshes"][0]["size"], [1000, 2000, 5000])
        out.err.contains("parts.3mf: warning: carries the unit in, but --unit FILE=m takes its numbers for m")
        refuse("bake part.gltf parts.3mf -o out",
               "parts.3mf: carries the unit in, part.gltf m; give the unit of the results")
        out = flashbvh("bake part.gltf b.obj -o both")
        out.err.contains("part.gltf: warning: carries the unit m, other files none; give the unit of the results, "
                         "such as --unit mm")

    def test_damaged_3mf_a_checksum_in_its_local_header_and_in_the_directory_the_end_a_part_that_is_not_there(self):
        parts()
        whole = Path("parts.3mf").read_bytes()
        crc = zipfile.ZipFile("parts.3mf").getinfo("3D/3dmodel.model").CRC.to_bytes(4, "little")
        Path("checksum.3mf").write_bytes(whole.replace(crc, b"\1\2\3\4"))
        refuse("bake checksum.3mf -o out", "checksum.3mf: can't be read: its part '3D/3dmodel.model' is damaged")
        Path("cut.3mf").write_bytes(whole[:-30])
        refuse("bake cut.3mf -o out", "cut.3mf: can't be read")
        write("3mf/_rels/.rels", text("3mf/_rels/.rels").replace("/3D/3dmodel.model", "/3D/another.model"))
        os.rename(shutil.make_archive("lacking", "zip", "3mf"), "lacking.3mf")
        refuse("bake lacking.3mf -o out",
               "lacking.3mf: can't be read: its part '3D/another.model' is damaged or not there")

    def test_what_a_gltf_refers_to_may_have_no_end_or_no_writer(self):
        os.mkfifo("pipe.bin")
        os.symlink("/dev/zero", "zero.bin")
        for buffer in ("pipe.bin", "zero.bin", "missing.bin"):
            write("refers.gltf", gltf(0, buffer))
            refuse("bake refers.gltf -o out", "refers.gltf: can't be read")

    def test_pipes_and_devices(self):
        meshes()
        for name in ("pipe.obj", "pipe.glb"):
            os.mkfifo(name)
        feeding = subprocess.Popen(
            "cat meshes/ring.stl >pipe.glb; printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >pipe.obj", shell=True,
            stderr=subprocess.DEVNULL)
        refuse("bake pipe.glb -o out", "pipe.glb: is a pipe, from which this format can't be read; name a file")
        flashbvh("bake pipe.obj -o piped")
        feeding.wait()
        os.symlink("/dev/zero", "zero.stl")
        refuse("bake zero.stl -o out", "zero.stl: is a device; name a file or a pipe")
        refuse("info /dev/zero", "/dev/zero: is a device")
        Path("sparse.stl").touch()
        os.truncate("sparse.stl", 2 ** 32)
        refuse("bake sparse.stl -o out", "sparse.stl: has 4 GiB or more; cut it in parts")
