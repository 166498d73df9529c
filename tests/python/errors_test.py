"""Refusals: messages name a wrong argument; a refusal of the program has its own message."""
import unittest

import numpy as np

import flashbvh
import program
import shapes


class MeshErrors(unittest.TestCase):
    def setUp(self):
        self.vertices, self.triangles = shapes.box(1, 1, 1)

    def refused(self, text, vertices=None, triangles=None, error=ValueError, **options):
        with self.assertRaisesRegex(error, text):
            flashbvh.Mesh.from_arrays(self.vertices if vertices is None else vertices,
                                      self.triangles if triangles is None else triangles, **options)

    def test_vertices(self):
        for text, vertices in ((r"^vertices: has the shape \(8, 2\); give \(N, 3\)$", self.vertices[:, :2]),
                               (r"^vertices: has the shape \(3,\); give \(N, 3\)$", [1, 2, 3]),
                               (r"^vertices: has the dtype object; give numbers", np.array([[None] * 3])),
                               ("^vertices: has the dtype <U1", [["a", "b", "c"]]),
                               ("^vertices: has the dtype complex128", self.vertices * 1j),
                               ("^vertices: has the dtype bool", self.vertices > 0),
                               ("^vertices: is no array", [[1, 2], [3]]),
                               ("^vertices: holds NaN in element 2;", np.where(np.eye(8, 3, -2), np.nan, 1)),
                               ("^vertices: holds infinity in element 0;", self.vertices * np.inf),
                               ("^vertices: row 0 is too large", self.vertices * 1e300)):
            with self.subTest(text):
                self.refused(text, vertices=vertices)

    def test_triangles(self):
        for text, triangles in ((r"^triangles: has the dtype float64; give integers$", self.triangles * 1.0),
                                (r"^triangles: has the shape \(6, 6\); give \(N, 3\)$", self.triangles.reshape(6, 6)),
                                ("^triangles: row 0 names the vertex 8; give 0 to 7$", self.triangles * 0 + 8),
                                ("^triangles: row 0 names the vertex -1; give 0 to 7$", self.triangles * 0 - 1),
                                ("^triangles: row 0 names the vertex ", np.array([[2**63, 0, 0]], np.uint64))):
            with self.subTest(text):
                self.refused(text, triangles=triangles)
        self.refused("^triangles: row 0 names the vertex 0; give vertices, too: there are none$",
                     vertices=np.zeros((0, 3)), triangles=np.array([[0, 1, 2]]))
        self.refused("no triangle|no polygon", triangles=np.zeros((0, 3), int), error=flashbvh.Error)
        self.refused("^cell: is -1; give a positive, finite number$", cell=-1)
        self.refused("^cell: is nan", cell=float("nan"))

    def test_files_as_the_program(self):
        folder = program.folder(self.addCleanup)
        (folder / "cut.stl").write_bytes(b"\0" * 90)
        (folder / "text.obj").write_text("v 1 2 three\n")
        for name in ("missing.stl", "cut.stl", "text.obj", "name.txt", "two\nlines.stl"):
            with self.assertRaises(flashbvh.Error) as raised:
                flashbvh.Mesh.from_file(folder / name)
            self.assertEqual(str(raised.exception), program.message("info", folder / name)
                             if name != "name.txt" else program.message("bake", folder / name, "--dry-run"))
        with self.assertRaises(TypeError):
            flashbvh.Mesh.from_file(7)
        with self.assertRaisesRegex(ValueError, "^scale: is 0;"):
            flashbvh.Mesh.from_file(folder / "text.obj", scale=0)
        with self.assertRaises(flashbvh.Error):
            flashbvh.Mesh.from_file(b"no\xff.stl")

    def test_baking(self):
        mesh = flashbvh.Mesh.from_arrays(self.vertices, self.triangles, name="box")
        for text, options in (("^cell: is 0; give", {"cell": 0}),
                              ("^leaf_size: is 17; give 1 to 16$", {"leaf_size": 17}),
                              ("^arity: is 1; give 2 to 8$", {"arity": 1}),
                              ("^index_bits: is 8; give 16 or 32$", {"index_bits": 8}),
                              ("^--unit ell: 'ell' is no unit; give nm", {"unit": "ell"}),
                              ("^box: is too large for a cell of 1e-06 mm", {"cell": 1e-6}),
                              ("^box: rounding moves a vertex by", {"cell": 0.3, "max_deviation": 0.001}),
                              ("^max_deviation: is no length", {"max_deviation": float("nan")}),
                              ("^simplify: is -1;", {"simplify": -1})):
            with self.subTest(text), self.assertRaisesRegex(ValueError, text):
                flashbvh.bake(mesh, **options)
        with self.assertRaisesRegex(TypeError, "^meshes: holds a str"):
            flashbvh.bake(["box.stl"])
        with self.assertRaises(TypeError):
            flashbvh.bake([None])
        self.assertEqual(flashbvh.bake([]), [])
        other = flashbvh.Mesh.from_arrays(self.vertices, self.triangles, cell=0.1)
        with self.assertRaisesRegex(ValueError, "^cell: mesh has the cell 0.1 and not 0.2; meshes share one$"):
            flashbvh.bake([mesh, other], cell=0.2)
        for made in (flashbvh.Mesh, flashbvh.Baked):
            with self.assertRaises(TypeError):
                made(None)

    def test_images(self):
        image = flashbvh.bake(flashbvh.Mesh.from_arrays(self.vertices, self.triangles)).image
        for text, wrong in (("^image: is truncated", image[:-4]), ("^image: is corrupt", image[:-1] + b"\1"),
                            ("^image: is no flashbvh image", b"\0" * 100),
                            ("^image: has 4 bytes after", image + image[:4]),
                            ("^image: ", b"")):
            with self.subTest(text), self.assertRaisesRegex(flashbvh.Error, text):
                flashbvh.Baked.load(wrong)


class QueryErrors(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.a, cls.b = flashbvh.bake([flashbvh.Mesh.from_arrays(*shapes.box(1, 1, 1), name=name) for name in "ab"])

    def test_poses(self):
        poses = np.tile(np.eye(4), (3, 1, 1))
        mirrored, scaled, far, beyond, nan, last, weight = (poses.copy() for _ in range(7))
        weight[2, 3, 3] = 2
        mirrored[1, 0, 0] = -1
        scaled[2, :3, :3] *= 1.01
        far[0, 0, 3] = 1e30
        beyond[0, 0, 3] = 1e300
        nan[2, 1, 1] = np.nan
        last[1, 3] = 1, 0, 0, 1
        for text, error, wrong in (
                (r"^poses\[1\]: the matrix mirrors", flashbvh.Error, mirrored),
                (r"^poses\[2\]: the first 9 numbers are no rotation", flashbvh.Error, scaled),
                (r"^poses\[0\]: the pose translates B by 1e\+30", flashbvh.Error, far),
                (r"^poses\[0\]: the pose translates B by 1e\+300", flashbvh.Error, beyond),
                ("^poses: holds NaN in element 2; give finite numbers$", ValueError, nan),
                ("^poses: the last row of matrix 1 is not 0 0 0 1", ValueError, last),
                ("^poses: the last row of matrix 2 is not 0 0 0 1", ValueError, weight),
                (r"^poses: has the shape \(3, 3\); give \(4, 4\) or \(N, 4, 4\)$", ValueError, np.eye(3)),
                (r"^poses: has the shape \(1, 1, 4, 4\)", ValueError, poses[:1, None]),
                (r"^poses: has the shape \(\)", ValueError, 7)):
            for query in (flashbvh.intersects, flashbvh.solids_intersect, flashbvh.distance,
                          lambda a, b, p: flashbvh.closer_than(a, b, p, 1)):
                with self.subTest(text), self.assertRaisesRegex(error, text):
                    query(self.a, self.b, wrong)
        with self.assertRaisesRegex(ValueError, "^pose: is a batch"):
            flashbvh.pairs(self.a, self.b, poses)
        with self.assertRaisesRegex(ValueError, "^length: is no length"):
            flashbvh.closer_than(self.a, self.b, poses, float("nan"))

    def test_meshes_of_two_cells_or_widths(self):
        mesh = flashbvh.Mesh.from_arrays(*shapes.box(1, 1, 1), name="c")
        for other in (flashbvh.bake(mesh, cell=0.1), flashbvh.bake(mesh, index_bits=32)):
            with self.assertRaisesRegex(flashbvh.Error, "^a and c|^c"):
                flashbvh.intersects(self.a, other, np.eye(4))
        with self.assertRaises((TypeError, AttributeError)):
            flashbvh.intersects(self.a, None, np.eye(4))

    def test_rays_and_points(self):
        for text, rays in ((r"^rays\[0\]: is no ray", ([0, 0, 5], [0, 0, 0], 9)),
                           (r"^rays\[1\]: is no ray", (np.zeros((2, 3)), np.ones((2, 3)), [1, -1])),
                           (r"^rays\[0\]: is no ray", ([0, 0, 1e30], [0, 0, 1], 9)),
                           (r"^origins: has the shape \(2,\)", ([0, 0], [0, 0, 1], 9)),
                           ("^directions: has another shape", ([0, 0, 0], np.ones((2, 3)), 9)),
                           ("^length: has another shape", (np.zeros((2, 3)), np.ones((2, 3)), [1, 2, 3])),
                           ("^length: holds NaN", ([0, 0, 0], [0, 0, 1], np.nan))):
            with self.subTest(text), self.assertRaisesRegex(ValueError, text):
                flashbvh.nearest_hit(self.a, *rays)
        with self.assertRaisesRegex(flashbvh.Error, r"^points\[1\]: the point lies at 1e\+20"):
            flashbvh.inside(self.a, [[0, 0, 0], [1e20, 0, 0]])
        with self.assertWarns(flashbvh.BakeWarning):
            vertices, triangles = shapes.box(1, 1, 1)
            sheet = flashbvh.bake(flashbvh.Mesh.from_arrays(vertices, triangles[1:], name="sheet"), cell=self.a.cell)
        with self.assertRaisesRegex(flashbvh.Error, "^sheet: is no closed surface"):
            flashbvh.inside(sheet, [0, 0, 0])
        with self.assertRaisesRegex(flashbvh.Error, "^sheet: is no closed surface"):
            flashbvh.solids_intersect(self.a, sheet, np.eye(4))


class OddArguments(unittest.TestCase):
    def test_no_argument_crashes(self):
        a, b = flashbvh.bake([flashbvh.Mesh.from_arrays(*shapes.box(1, 1, 1)) for _ in range(2)])
        odd = [None, 0, -1, 1e308, float("nan"), 2**70, "x", "\ud800", b"\xff", [], [[]], [[1, 2, 3]], {}, object(),
               np.eye(4), np.zeros((0, 3)), np.zeros((3, 0)), np.array(5), np.zeros((4, 4), object), np.eye(4)[::-1],
               np.asfortranarray(np.eye(4)), np.eye(4, dtype=">f8"), np.zeros((2, 3), np.uint64) - 1, np.zeros((1,) * 32),
               np.zeros((2, 3), "M8[s]"), np.ma.masked_array(np.eye(4), True), a, a._native, True, range(3)]
        native = flashbvh._native
        calls = [(flashbvh.intersects, 3), (flashbvh.distance, 3), (flashbvh.closer_than, 4), (flashbvh.pairs, 3),
                 (flashbvh.nearest_hit, 4), (flashbvh.inside, 2), (flashbvh.Mesh.from_arrays, 2), (flashbvh.bake, 1),
                 (flashbvh.Mesh.from_file, 1), (flashbvh.Baked.load, 1), (flashbvh.Robot.load, 1), (flashbvh.Guard, 1),
                 (flashbvh.Robot.from_urdf, 1), (native.bake, 8), (native.robot_of_urdf, 15), (native.certify, 3),
                 (native.mesh_of_arrays, 4), (native.mesh_of_file, 3), (native.Guard, 1), (native.Baked, 0)]
        random = np.random.default_rng(4)
        for _ in range(6000):
            call, count = calls[random.integers(len(calls))]
            arguments = [odd[i] for i in random.integers(len(odd), size=count)]
            if call.__module__ == "flashbvh._queries":
                arguments[:2] = [a, arguments[1]] if call in (flashbvh.nearest_hit, flashbvh.inside) else [a, b]
            try:
                call(*arguments)
            except (ValueError, TypeError, AttributeError):
                pass


if __name__ == "__main__":
    unittest.main()
