"""info, check and export agree with the bake."""
from cli import Case, fixture, flashbvh, search, size, text, write
from inputs import faces, meshes, vertices


@fixture
def few():
    write("mesh.obj", """
        v 0.24 -0.26 0
        v 10 0.5 -0.5
        v 3.74 10.01 1.5
        v 0.3 -0.2 4
        v 9.99 9.99 9.99
        f 3 2 1
        f 1 2 4
        f 5 4 2""")
    write("table", flashbvh("bake mesh.obj -o baked --cell 0.5 --leaf-size 1"))
    flashbvh("export --cells baked/mesh.fbvh -o lattice.obj")


class RoundTripTest(Case):
    inputs = few,

    def test_a_vertex_lies_at_its_coordinate_by_the_cell_rounded_halves_away_from_zero(self):
        rounded = [tuple(int(abs(x) / 0.5 + 0.5) * (1 if x > 0 else -1) for x in vertex)
                   for vertex in vertices("mesh.obj")]
        found = vertices("lattice.obj")
        self.assertEqual([found[i] for face in faces("lattice.obj") for i in face],
                         [rounded[i] for face in faces("mesh.obj") for i in face])

    def test_corners_that_deformable_turned_are_the_meshs_and_make_refits_cheaper(self):
        flashbvh("bake mesh.obj -o soft --cell 0.5 --deformable")
        flashbvh("bake mesh.obj -o hard --cell 0.5")
        flashbvh("check soft/mesh.fbvh --mesh mesh.obj")
        soft, hard = (int(search("^refit instructions *([0-9]*)", flashbvh(f"info {name}/mesh.fbvh")))
                      for name in ("soft", "hard"))
        self.assertLess(soft, hard)

    def test_halves_of_a_cell_go_up(self):
        found = vertices("lattice.obj")
        flashbvh('export --cells baked/mesh.fbvh -o translated.obj --pose "1 0 0 0 1 0 0 0 1 1.25 -1.25 100"')
        self.assertEqual([(x - 3, y + 2, z - 200) for x, y, z in vertices("translated.obj")], found)
        flashbvh('export --cells baked/mesh.fbvh -o rotated.obj --pose "0 -1 0 1 0 0 0 0 1 1.25 -1.25 100"')
        self.assertEqual([(y + 2, 3 - x, z - 200) for x, y, z in vertices("rotated.obj")], found)

    def test_an_image_is_checked_against_its_mesh_whatever_it_was_baked_with(self):
        meshes()
        for options in ("--layout post", "--layout pre", "--leaf-size 4 --arity 3", "--builder median",
                        "--builder median --leaf-size 3 --arity 8", "--builder sah --arity 2",
                        "--index-bits 32 --layout pre"):
            with self.subTest(options):
                flashbvh(f"bake meshes/ring.stl meshes/coarse.stl -o rings {options}")
                flashbvh("check rings/ring.fbvh")
                flashbvh("check rings/ring.fbvh --mesh meshes/ring.stl").matches("^ring: well-formed")
                flashbvh("check rings/ring.fbvh --mesh meshes/coarse.stl", code=1).contains("but not")

    def test_one_corner_moved_by_one_cell_or_two_triangles_changed_round_another_mesh(self):
        write("moved_corner.obj", text("mesh.obj").replace("v 9.99 9.99 9.99", "v 9.99 9.99 9.49"))
        out = flashbvh("check baked/mesh.fbvh --mesh moved_corner.obj", code=1)
        out.contains("corner 0 of triangle 2 lies at (20 20 20) in the image, at (20 20 19)")
        write("other_order.obj", text("mesh.obj").replace("f 3 2 1\n", "") + "f 3 2 1\n")
        flashbvh("check baked/mesh.fbvh --mesh other_order.obj", code=1)
        flashbvh("check baked/mesh.fbvh --mesh missing.obj", code=2)

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
