"""Each kind of unusable mesh is refused with its name and place; no file is written."""
import os
import shutil
from pathlib import Path

from cli import Case, flashbvh, long, refuse, refuse_each, search, write
from inputs import large_meshes, meshes


class BadMeshesTest(Case):
    inputs = meshes,

    def test_beside_a_good_mesh_a_file_of_one_of_these_contents_is_refused(self):
        for name, content, wanted in (
                ("empty.stl", "", "empty.stl: is empty"),
                ("mesh.xyz", "solid", "mesh.xyz: is no mesh by its extension; convert it to one of STL, OBJ"),
                ("part.step", "ISO-10303-21", "part.step: is no mesh by its extension"),
                ("part.off", "OFF\n", "part.off: is OFF, which is not read; convert it to STL, OBJ or PLY"),
                ("short.obj", "v 0 0 0\nv 1 0\nv 0 1 0\nf 1 2 3\n", "short.obj:2: a vertex of 2"),
                ("segment.obj", "v 0 0 0\nv 1 0 0\nf 1 2\n", "segment.obj:3: a polygon of 2"),
                ("line.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2 3\n", "line.obj: has no polygons"),
                # A count that no file can hold is refused at once.
                ("endless.ply", "ply\nformat ascii 1.0\nelement vertex 9000000000000000000\nend_header\n",
                 "endless.ply: vertex 0 of 9000000000000000000: no properties"),
                ("part.gltf", "{}", "part.gltf: can't be read:")):
            write(name, content)
            refuse(f"bake meshes/tetrahedron.stl {name} -o out", wanted)

    def test_of_these_meshes_too_nothing_is_baked(self):
        refuse_each("bake -o out meshes/tetrahedron.stl", {
            "missing.stl": "missing.stl: can't be opened",
            "meshes": "is a folder",
            "meshes/no_triangles.stl": "triangle",
            "meshes/nan.stl": "nan.stl: polygon 2",
        })

    def test_too_large_for_the_cell_the_message_names_one_that_fits(self):
        out = refuse("bake meshes/ring.stl -o out --cell 0.0001", "too large for a cell of 1e-04")
        cell = search("--cell (.*)", out.err)
        flashbvh(f"bake meshes/ring.stl -o fitting --cell {cell}")

    @long
    def test_too_many_for_16_bits_the_message_names_the_fix_and_the_fix_works(self):
        large_meshes()
        refuse_each("bake -o out", {
            "meshes/many_nodes.stl --leaf-size 1 --builder median":
                "many_nodes.stl: 79999 nodes, but 16-bit indices reach 65535; use a larger --leaf-size",
            "meshes/many_nodes.stl --leaf-size 1":
                "many_nodes.stl: 40000 leaves, but 16-bit indices reach 32768; use a larger --leaf-size",
            "meshes/many_vertices.stl --cell 0.25 --builder median": "many_vertices.stl: 66000 vertices, but",
            "meshes/many_triangles.stl --builder median": "many_triangles.stl: 66000 triangles, but",
        })
        flashbvh("bake meshes/many_nodes.stl -o many")

    def test_two_meshes_that_would_be_written_to_one_file(self):
        shutil.copytree("meshes", "other")
        os.rename("other/ring.stl", "other/ring.STL")
        refuse("bake meshes/ring.stl other/ring.STL -o out", "other/ring.STL")
        os.rename("other/ring.STL", "other/RING.stl")
        refuse("bake meshes/ring.stl other/RING.stl -o out",
               "other/RING.stl: would be written as 'RING' like 'ring' but for the case, which some file "
               "systems ignore; rename one of the files")

    def test_named_where_an_image_is_expected_what_it_is_and_what_to_do(self):
        write("few", "few\n")
        write("few.robot", "few\n")
        for kind in ("stl", "robot", "fbvh"):
            Path(f"folder.{kind}").mkdir()
        os.symlink("/dev/null", "null.stl")
        refuse_each("", {
            "info few": "few: is no flashbvh image; name a .fbvh file",
            "info few.robot": "few.robot: is no image of a robot; name one that",
            **{f"info folder.{kind}": f"folder.{kind}: is a folder; name a file" for kind in ("stl", "robot", "fbvh")},
            "info null.stl": "null.stl: is a device; name a file or a pipe",
        })
