"""Meshes and their queries, against the program `flashbvh` and against numpy."""
import pickle
import unittest

import numpy as np

import flashbvh
from flashbvh import Baked, Error, Mesh
from support import Case, box, lines, poses, torus, translated, write_rows


class Scene(Case):
    """A torus and a box, baked by the package and saved for the program."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.torus, cls.box = torus(24, 12, 30, 10), box(5, 6, 7)
        cls.a, cls.b = flashbvh.bake([Mesh.from_arrays(*cls.torus, name="torus"),
                                      Mesh.from_arrays(*cls.box, name="box")])
        cls.files = [cls.folder / "torus.fbvh", cls.folder / "box.fbvh"]
        cls.a.save(cls.files[0])
        cls.b.save(cls.files[1])
        cls.poses = poses(200, 45)
        cls.pose_file = write_rows(cls.folder / "poses", np.hstack([cls.poses[:, :3, :3].reshape(-1, 9),
                                                                    cls.poses[:, :3, 3]]))


class BakeTest(Scene):
    def test_an_image_says_what_it_is(self):
        self.assertEqual((self.b.name, self.b.unit, self.b.triangle_count, self.b.is_closed), ("box", "mm", 12, True))
        for baked, file in zip((self.a, self.b), self.files):
            info, = lines("info", file)
            self.assertEqual(baked.cell, info["cell"])

    def test_a_file_bakes_to_the_image_of_the_program(self):
        (self.folder / "two words.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0.3\nf 1 2 3\n")
        lines("bake", self.folder / "two words.obj", "--unit", "m", "--cell", "0.001", "--format", "image", "-o",
              self.folder / "more")
        with self.assertWarnsRegex(flashbvh.BakeWarning, "two words.obj: warning: no closed surface") as warned:
            baked = flashbvh.bake(Mesh.from_file(self.folder / "two words.obj"), unit="m", cell=0.001)
        self.assertEqual(warned.filename, __file__, "the line that called")
        self.assertEqual((baked.name, baked.unit, baked.cell, baked.is_closed), ("two words", "m", 0.001, False))
        self.assertEqual(baked.image, (self.folder / "more/two words.fbvh").read_bytes())

    def test_an_image_survives_a_file_and_a_pickle(self):
        self.assertEqual(Baked.load(str(self.files[0]), unit="mm").image, self.a.image)
        self.assertEqual(pickle.loads(pickle.dumps(self.a)).image, self.a.image)

    def test_refusals(self):
        vertices, triangles = self.box
        self.refused(ValueError, r"^vertices: has the shape \(8, 2\)", Mesh.from_arrays, vertices[:, :2], triangles)
        self.refused(ValueError, "^vertices: holds a number", Mesh.from_arrays, vertices * np.nan, triangles)
        self.refused(ValueError, "^triangles: names a vertex beyond the 8", Mesh.from_arrays, vertices, triangles + 1)
        self.refused(ValueError, "^triangles: float64", Mesh.from_arrays, vertices, triangles * 1.0)
        self.refused(ValueError, "^name: '../box'", Mesh.from_arrays, vertices, triangles, name="../box")
        self.refused(Error, "missing.stl: can't be opened", flashbvh.bake, Mesh.from_file(self.folder / "missing.stl"))
        mesh = Mesh.from_arrays(vertices, triangles, name="part")
        self.refused(Error, "^part: is too large for a cell of 1e-06 mm", flashbvh.bake, mesh, cell=1e-6)
        self.refused(Error, "^--arity", flashbvh.bake, mesh, arity=9)
        self.refused(Error, "would be written as 'part' like one of a mesh before it", flashbvh.bake, [mesh, mesh])
        for kind, command in (Baked, "bake --unit mm"), (flashbvh.Robot, "robot"):
            self.refused(Error, f"_test.py: image_not_flashbvh; bake it: flashbvh {command} ", kind.load, __file__)
        self.refused(Error, "fbvh: is an image of another kind; open it by Baked", flashbvh.Robot.load, self.files[1])
        self.refused(TypeError, "^'part' is no Baked; bake it", flashbvh.intersects, self.a, mesh, np.eye(4))
        self.refused(TypeError, "^meshes: holds a str", flashbvh.bake, ["box.stl"])
        for status, wrong in (("image_truncated", self.b.image[:-4]), ("image_corrupt", self.b.image[:-1] + b"\1"),
                              ("image_truncated", b""), ("has bytes after", self.b.image + bytes(4))):
            self.refused(Error, f"^image: {status}", Baked.load, wrong)
        self.refused(Error, "^box: is in mm, not in m;", Baked.load, self.files[1], unit="m")


class QueryTest(Scene):
    def posed(self, command, *arguments):
        return lines(command, *self.files, "--poses", self.pose_file, *arguments)

    def test_intersects_and_pairs_as_the_program(self):
        found = flashbvh.intersects(self.a, self.b, self.poses)
        answers = self.posed("collide", "--pairs", self.folder / "pairs.txt")
        self.assertTrue(0 < found.sum() < len(found))
        self.assertEqual([line["intersects"] for line in answers], found.tolist())
        expected = np.loadtxt(self.folder / "pairs.txt", dtype=int, ndmin=2)
        for i, pose in enumerate(self.poses):
            pairs = [tuple(pair) for pair in flashbvh.pairs(self.a, self.b, pose)]
            self.assertEqual(sorted(pairs), list(map(tuple, expected[expected[:, 0] == i, 1:])))

    def test_distance_as_the_program(self):
        answers = self.posed("clearance")
        for is_motion, fields in ((False, []), (True, ["point_a", "point_b", "triangles"])):
            found = flashbvh.distance(self.a, self.b, self.poses, is_motion=is_motion)
            np.testing.assert_array_equal(found.distance, [line["lower"] for line in answers])
            for field in ["upper", *fields]:
                np.testing.assert_array_equal(found[field], [line[field] for line in answers], field)

    def test_closer_than_rounds_a_length_up(self):
        mesh = flashbvh.bake(Mesh.from_arrays(*box(9, 9, 9)), cell=1.0)
        pose = translated(19, 19, 0)  # edges sqrt(2) apart
        for length in (1.4143, 1.4155, 1.4179, 1.418):
            self.assertTrue(flashbvh.closer_than(mesh, mesh, pose, length), length)
        self.assertFalse(flashbvh.closer_than(mesh, mesh, pose, 1.414))

    def test_a_translation_is_not_rounded_to_32_bits(self):
        cell = 2.0 ** -12
        vertices, triangles = box(1, 1, 1)
        with self.assertWarnsRegex(flashbvh.BakeWarning, "far from its frame's origin"):
            a = flashbvh.bake(Mesh.from_arrays(vertices + [8192, 0, 0], triangles), cell=cell)
        b = flashbvh.bake(Mesh.from_arrays(vertices, triangles), cell=cell)
        gaps = [translated(8194 + gap, 0, 0) for gap in (0, cell)]
        self.assertEqual(flashbvh.intersects(a, b, gaps).tolist(), [True, False])

    def test_a_batch_is_its_poses_one_by_one(self):
        for query in (flashbvh.intersects, flashbvh.solids_intersect,
                      lambda a, b, at: flashbvh.closer_than(a, b, at, 2.5),
                      lambda a, b, at: flashbvh.distance(a, b, at).distance):
            batch = query(self.a, self.b, self.poses[:20])
            self.assertEqual(query(self.a, self.b, self.poses[:0]).shape[0], 0)
            self.assertEqual(batch.tolist(), [query(self.a, self.b, pose).tolist() for pose in self.poses[:20]])

    def test_too_far_to_measure(self):
        found = flashbvh.distance(self.a, self.b, translated(2e6 * self.a.cell, 0, 0))
        self.assertTrue(np.isnan(found.point_a).all() and (found.triangles == -1).all())
        between = 2e6 * self.a.cell - 40 - 5
        self.assertTrue(1e6 * self.a.cell < found.distance < between < found.upper + self.a.cell)

    def test_solids_and_points_by_formula(self):
        outer = flashbvh.bake(Mesh.from_arrays(*box(9, 9, 9)), cell=self.b.cell)
        self.assertFalse(flashbvh.intersects(outer, self.b, np.eye(4)))
        self.assertTrue(flashbvh.solids_intersect(outer, self.b, np.eye(4)))
        points = np.random.default_rng(3).uniform(-10, 10, (2000, 3))
        sure = (np.abs(np.abs(points) - [5, 6, 7]) > 0.01).all(axis=1)
        np.testing.assert_array_equal(flashbvh.inside(self.b, points)[sure],
                                      (np.abs(points) <= [5, 6, 7]).all(axis=1)[sure])
        self.assertTrue(flashbvh.inside(self.b, [5, 0, 0]), "on the surface")

    def test_refusals(self):
        batch = poses(3, 1)
        mirrored, scaled, far, nan, last = (batch.copy() for _ in range(5))
        mirrored[1, :3, 0] *= -1
        scaled[2, :3, :3] *= 1.01
        far[0, 0, 3] = 1e300
        nan[2, 1, 1] = np.nan
        last[1, 3, 3] = 2
        for text, error, wrong in ((r"^poses\[1\]: not_a_rotation$", Error, mirrored),
                                   (r"^poses\[2\]: not_a_rotation$", Error, scaled),
                                   (r"^poses\[0\]: translation_out_of_range$", Error, far),
                                   ("^poses: holds a number that is not finite$", ValueError, nan),
                                   ("^poses: a last row is not 0 0 0 1", ValueError, last),
                                   (r"^poses: has the shape \(3, 3\); give \(4, 4\)", ValueError, np.eye(3)),
                                   ("^poses: has the dtype <U1", ValueError, "x")):
            self.refused(error, text, flashbvh.intersects, self.a, self.b, wrong)
        self.refused(ValueError, "^pose: is a batch", flashbvh.pairs, self.a, self.b, batch)
        for length in (-1, np.nan, np.inf):
            self.refused(ValueError, "^length: is no length", flashbvh.closer_than, self.a, self.b, batch, length)
        self.refused(Error, "distance_out_of_range", flashbvh.closer_than, self.a, self.b, batch, 1e9)
        for options in ({"cell": 0.1}, {"cell": self.a.cell, "unit": "m"}):
            other = flashbvh.bake(Mesh.from_arrays(*self.box, name="other"), **options)
            self.refused(Error, "^other: has a cell of", flashbvh.intersects, self.a, other, np.eye(4))
        far = [[0, 0, 0], [1e20, 0, 0]]
        self.refused(Error, r"^points\[1\]: translation_out_of_range", flashbvh.inside, self.a, far)
        with self.assertWarns(flashbvh.BakeWarning):
            sheet = flashbvh.bake(Mesh.from_arrays(self.box[0], self.box[1][1:], name="sheet"), cell=self.a.cell)
        with self.assertRaises(Error) as raised:
            flashbvh.solids_intersect(self.a, sheet, np.eye(4))
        self.assertEqual(raised.exception.status, "not_closed")


if __name__ == "__main__":
    unittest.main()
