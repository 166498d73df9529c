"""An image has the mesh's triangles, and info what was baked."""
import struct
from pathlib import Path

from cli import Case, fixture, flashbvh, search, size, text, write
from inputs import meshes
from meshes import torus

MESH = """
        v 0.24 -0.26 0
        v 10 0.5 -0.5
        v 3.74 10.01 1.5
        v 0.3 -0.2 4
        v 9.99 9.99 9.99
        f 3 2 1
        f 1 2 4
        f 5 4 2"""


@fixture
def few():
    write("mesh.obj", MESH)
    write("table", flashbvh("bake mesh.obj -o baked --cell 0.5 --leaf-size 1"))


def triangles_in(file):
    """An image's triangles by their numbers in the mesh, of points in cells of the mesh's frame (lib/docs/format.md)."""
    data = Path(file).read_bytes()
    index = "I" if data[7] == 32 else "H"
    nodes, leaves, triangles, vertices = struct.unpack_from("<4I", data, 16)
    arrays, at = [], 80
    levels = nodes * (data[79] & 1)
    for form, count in ((f"12x2{index}", nodes), (index, levels), (index, levels), (f"3{index}", triangles),
                        (index, triangles), (index, (leaves + 1) * (leaves != triangles)),
                        ("12x", leaves * (data[79] >> 2)), ("3h", vertices)):
        length = struct.calcsize(f"<{form}") * count
        arrays.append(list(struct.iter_unpack(f"<{form}", data[at:at + length])))
        at += (length + 3) // 4 * 4
    corners, numbers, points = arrays[3], arrays[4], arrays[7]
    framed = [tuple(map(sum, zip(point, struct.unpack_from("<3i", data, 44)))) for point in points]
    return {number: [framed[i] for i in triangle] for (number,), triangle in zip(numbers, corners)}


def rounded(triangles, cell):
    """Halves of a cell are rounded away from zero."""
    return {number: [tuple(int(abs(x) / cell + 0.5) * (1 if x > 0 else -1) for x in corner) for corner in triangle]
            for number, triangle in enumerate(triangles)}


def of_mesh():
    lines = [line.split() for line in MESH.splitlines()[1:]]
    points = [tuple(map(float, line[1:])) for line in lines if line[0] == "v"]
    return rounded([[points[int(i) - 1] for i in line[1:]] for line in lines if line[0] == "f"], 0.5)


class RoundTripTest(Case):
    inputs = few,

    def test_an_image_has_the_meshs_triangles_whatever_it_was_baked_with(self):
        self.assertEqual(triangles_in("baked/mesh.fbvh"), of_mesh())
        meshes()
        for options in ("--layout post", "--layout pre", "--leaf-size 4 --arity 3", "--builder median --arity 8",
                        "--index-bits 32 --layout pre"):
            with self.subTest(options):
                flashbvh(f"bake meshes/ring.stl meshes/coarse.stl -o rings --cell 0.01 {options}")
                flashbvh("info rings/ring.fbvh").matches("^ring: well-formed, a mesh$")
                self.assertEqual(triangles_in("rings/ring.fbvh"), rounded(torus(20, 10), 0.01))

    def test_corners_that_deformable_turned_are_the_meshs_and_make_refits_cheaper(self):
        flashbvh("bake mesh.obj -o soft --cell 0.5 --deformable")
        flashbvh("bake mesh.obj -o hard --cell 0.5")
        for number, corners in triangles_in("soft/mesh.fbvh").items():
            self.assertIn(of_mesh()[number], [corners[i:] + corners[:i] for i in range(3)])
        soft, hard = (int(search("^refit instructions *([0-9]*)", flashbvh(f"info {name}/mesh.fbvh")))
                      for name in ("soft", "hard"))
        self.assertLess(soft, hard)

    def test_info_has_what_was_baked_and_the_deviation(self):
        out = flashbvh("info baked/mesh.fbvh --json")
        self.assertLessEqual({
            "name": "mesh", "layout": "post", "index_bits": 16, "nodes": 4, "leaves": 3, "depth": 1, "triangles": 3,
            "vertices": 5, "leaf_size": 1, "arity": 3, "cell": 0.5, "stack_need": 2, "bytes": size("baked/mesh.fbvh"),
            "box": {"lower": [0, -0.5, -0.5], "upper": [10, 10, 10]},
            "box_cells": {"lower": [0, -1, -1], "upper": [20, 20, 20]}}.items(), out.json.items())
        out = flashbvh("info baked/mesh.fbvh")
        out.matches("^nodes  ", "^depth  ", "^bytes per triangle  ", "^box  ", "^deviation  ")
        self.assertTrue(0.339411 < float(search("^deviation *([^ ]*) ", out)) < 0.339412)
        text("table").matches("^mesh .*  0.3394")
