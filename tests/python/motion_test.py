"""Motions of a body, against the program `flashbvh` and against numpy."""
import unittest

import numpy as np

import flashbvh
import program
import shapes
from flashbvh import BodyMotion, ContactOutcome


class MotionTest(unittest.TestCase):
    """A torus stays, a box moves."""

    @classmethod
    def setUpClass(cls):
        cls.folder = program.folder(cls.addClassCleanup)
        cls.a, cls.b = flashbvh.bake([flashbvh.Mesh.from_arrays(*shapes.torus(24, 12, 30, 10), name="torus"),
                                      flashbvh.Mesh.from_arrays(*shapes.box(5, 6, 7), name="box")], cell=0.01)
        cls.images = [cls.folder / "a.fbvh", cls.folder / "b.fbvh"]
        cls.a.save(cls.images[0])
        cls.b.save(cls.images[1])
        cls.start, cls.end = shapes.poses(60, 60, seed=4), shapes.poses(60, 60, seed=5)

    def compare(self, found, i, *arguments):
        line, = program.lines("motion", *self.images, *arguments, exits=(0, 1))
        self.assertEqual(ContactOutcome(found.outcome[i]).name.lower(), line["outcome"])
        for name, of_program in ((found.start, "from"), (found.end, "to")):
            self.assertAlmostEqual(name[i], line.get(of_program, 1), delta=2e-4)
        return line

    def pose_file(self, name, pose):
        program.write_poses(self.folder / name, pose[None])
        return self.folder / name

    def test_between_two_poses_as_the_program(self):
        for within in (0, 2.5):
            found = flashbvh.first_contact(self.a, self.b, BodyMotion(self.start, self.end), within)
            self.assertTrue(min((found.outcome[found.start > 0] == kind).sum() for kind in (0, 1)) > 5)
            np.testing.assert_array_equal(found.is_free, (found.triangles == -1).all(axis=1))
            for i in range(0, 60, 5):
                self.compare(found, i, "--from", self.pose_file("from", self.start[i]), "--to",
                             self.pose_file("to", self.end[i]), "--within", within)

    def test_the_bodies_touch_at_the_end(self):
        found = flashbvh.first_contact(self.a, self.b, BodyMotion(self.start, self.end))
        touches = found.outcome == ContactOutcome.CONTACT
        self.assertTrue(flashbvh.intersects(self.a, self.b, found.pose[touches]).all())
        np.testing.assert_allclose(found.pose[found.is_free], self.end[found.is_free], atol=1e-4)

    def test_a_batch_is_its_motions_one_by_one(self):
        batch = flashbvh.first_contact(self.a, self.b, BodyMotion(self.start[:5], self.end[:5]))
        for i in range(5):
            single = flashbvh.first_contact(self.a, self.b, BodyMotion(self.start[i], self.end[i]))
            self.assertEqual(single.outcome.shape, ())
            for one, of_batch in zip(single, batch):
                np.testing.assert_array_equal(one, of_batch[i])
        none = flashbvh.first_contact(self.a, self.b, BodyMotion(self.start[:0], self.end[:0]))
        self.assertEqual(none.pose.shape, (0, 4, 4))

    def test_moves_as_the_program_and_by_formula(self):
        start = shapes.translated(60, 0, 0)
        moves = [[0, 0, 0, 0, 0, 2, np.pi, 0, 0, 0], [0, 0, 0, 0, 0, 0, 0, -35, 0, 0]]
        found = flashbvh.first_contact(self.a, self.b, BodyMotion.of_moves(start[None], moves))
        (self.folder / "moves").write_text("0 0 0 0 0 2 180 0 0 0\n0 0 0 0 0 0 0 -35 0 0\n")
        self.compare(found, 0, "--from", "60 0 0", "--moves", self.folder / "moves")
        angle, radius = np.pi * found.end[0], 60 - 35 * found.end[0]
        np.testing.assert_allclose(found.pose[0, :2], [[np.cos(angle), -np.sin(angle), 0, radius * np.cos(angle)],
                                                       [np.sin(angle), np.cos(angle), 0, radius * np.sin(angle)]],
                                   atol=1e-3)
        # The box lies across the ring's outer rim, which is a polygon.
        self.assertTrue(38.5 < radius - 5 < 40.01, radius)

    def test_indices_of_32_bits_answer_alike(self):
        a, b = flashbvh.bake([flashbvh.Mesh.from_arrays(*shapes.torus(24, 12, 30, 10)),
                              flashbvh.Mesh.from_arrays(*shapes.box(5, 6, 7))], cell=0.01, index_bits=32)
        motion = BodyMotion(self.start, self.end)
        for wide, narrow in zip(flashbvh.first_contact(a, b, motion), flashbvh.first_contact(self.a, self.b, motion)):
            np.testing.assert_array_equal(wide, narrow)

    def test_refusals(self):
        pose, scaled = np.eye(4), np.diag([1.1, 1.1, 1.1, 1])
        move = [0, 0, 0, 0, 0, 1, 1, 0, 0, 0]
        for text, error, motion in (
                ("^start: has the shape", ValueError, BodyMotion(np.eye(3), pose)),
                ("^end: has the shape", ValueError, BodyMotion(pose, np.eye(3))),
                ("^end: has another shape than start", ValueError, BodyMotion(pose[None], pose)),
                ("^end: the last row of matrix 0", ValueError, BodyMotion(pose, pose * 2)),
                (r"^end\[0\]: the first 9 numbers are no rotation", flashbvh.Error, BodyMotion(pose, scaled)),
                (r"^motion\[0\]: may take B farther than 2\^19 cells, 5242.88", flashbvh.Error,
                 BodyMotion(pose, shapes.translated(9000, 0, 0))),
                (r"^moves: has the shape \(10,\); give \(N, 10\)", ValueError, BodyMotion.of_moves(pose, move)),
                ("^moves: has 65 rows; give at most 64", ValueError, BodyMotion.of_moves(pose, [move] * 65)),
                (r"^moves\[1\]: turns about an axis without a direction", flashbvh.Error,
                 BodyMotion.of_moves(pose, [move, [0, 0, 0, 0, 0, 0, 1, 0, 0, 0]]))):
            with self.subTest(text), self.assertRaisesRegex(error, text):
                flashbvh.first_contact(self.a, self.b, motion)
        for within in (-1, float("nan"), 6000):
            with self.assertRaisesRegex(flashbvh.Error, "^within .*: is out of range: 0 to 320"):
                flashbvh.first_contact(self.a, self.b, BodyMotion(pose, pose), within)


if __name__ == "__main__":
    unittest.main()
