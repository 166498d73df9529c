"""CollisionManager against queries of all pairs, and against formulas for boxes."""
import unittest
from types import SimpleNamespace

import numpy as np

import flashbvh
import shapes

BOX = flashbvh.Mesh.from_arrays(*shapes.box(1, 1, 1), name="box")
TORUS = flashbvh.Mesh.from_arrays(*shapes.torus(24, 12, 3, 1), name="torus")


def row_of_boxes(*places):
    manager = flashbvh.CollisionManager()
    for name, place in zip("abcdef", places):
        manager.add_object(name, BOX, shapes.translated(place, 0, 0))
    return manager


class CollisionTest(unittest.TestCase):
    def test_internal(self):
        manager = row_of_boxes(0, 5, 6.5)
        self.assertIs(manager.in_collision_internal(), True)
        self.assertEqual(manager.in_collision_internal(return_names=True), (True, {("b", "c")}))
        manager.set_transform("b", shapes.translated(3, 0, 0))
        self.assertEqual(manager.in_collision_internal(return_names=True), (False, set()))
        distance, names = manager.min_distance_internal(return_names=True)
        self.assertAlmostEqual(distance, 1, places=3)
        self.assertEqual(names, ("a", "b"))
        manager.remove_object("a")
        self.assertAlmostEqual(manager.min_distance_internal(), 1.5, places=3)

    def test_single(self):
        manager = row_of_boxes(0, 5, 6.5)
        self.assertEqual(manager.in_collision_single(BOX, shapes.translated(5.5, 1.5, 0), return_names=True),
                         (True, {"b", "c"}))
        self.assertIs(manager.in_collision_single(BOX, shapes.translated(0, 9, 0)), False)
        distance, name = manager.min_distance_single(BOX, shapes.translated(0, 4, 0), return_name=True)
        self.assertAlmostEqual(distance, 2, places=3)
        self.assertEqual(name, "a")
        self.assertEqual(manager.min_distance_single(BOX), 0)

    def test_other(self):
        left, right = row_of_boxes(0, 5), flashbvh.CollisionManager()
        right.add_object("ring", TORUS, shapes.translated(-4, 0, 0))
        self.assertEqual(left.in_collision_other(right, return_names=True), (True, {("a", "ring")}))
        self.assertEqual(right.in_collision_other(left, return_names=True), (True, {("ring", "a")}))
        right.set_transform("ring", shapes.translated(-7, 0, 0))
        self.assertIs(left.in_collision_other(right), False)
        distance, names = left.min_distance_other(right, return_names=True)
        self.assertAlmostEqual(distance, 2, places=3)
        self.assertEqual(names, ("a", "ring"))

    def test_random_scenes_as_the_queries(self):
        small, large = flashbvh.bake([BOX, TORUS])
        for seed in range(5):
            poses = shapes.poses(8, 6, seed)
            manager = flashbvh.CollisionManager()
            meshes = [(BOX, small), (TORUS, large)] * 4
            for i, pose in enumerate(poses):
                manager.add_object(str(i), meshes[i][0], pose)
            pairs, distances = set(), []
            for i in range(8):
                for j in range(i + 1, 8):
                    pose = np.linalg.inv(poses[i]) @ poses[j]
                    distances.append(float(flashbvh.distance(meshes[i][1], meshes[j][1], pose).distance))
                    if flashbvh.intersects(meshes[i][1], meshes[j][1], pose):
                        pairs.add((str(i), str(j)))
            self.assertEqual(manager.in_collision_internal(return_names=True), (bool(pairs), pairs))
            self.assertAlmostEqual(manager.min_distance_internal(), min(distances), places=3)

    def test_a_larger_object_later(self):
        manager = row_of_boxes(0, 1)
        self.assertTrue(manager.in_collision_internal())
        manager.add_object("hall", SimpleNamespace(vertices=shapes.box(90, 90, 90)[0], faces=shapes.box(1, 1, 1)[1]))
        self.assertEqual(manager.in_collision_internal(return_names=True), (True, {("a", "b")}))
        self.assertEqual(manager.min_distance_single(BOX, shapes.translated(89, 0, 0), return_name=True), (0, "hall"))

    def test_a_moved_matrix_of_the_caller_moves_nothing(self):
        matrix = shapes.translated(5, 0, 0)
        manager = row_of_boxes(0)
        manager.add_object("z", BOX, matrix)
        matrix[0, 3] = 0
        self.assertFalse(manager.in_collision_internal())

    def test_nothing_to_test(self):
        manager = flashbvh.CollisionManager()
        self.assertFalse(manager.in_collision_internal())
        self.assertEqual(manager.min_distance_internal(), np.inf)
        self.assertFalse(manager.in_collision_single(BOX))
        self.assertFalse(manager.in_collision_other(row_of_boxes(0)))

    def test_errors(self):
        manager = row_of_boxes(0)
        scaled = np.diag([2.0, 2, 2, 1])
        for text, call in (("^name: there is no object 'x'$", lambda: manager.remove_object("x")),
                           ("^name: there is no object 'x'$", lambda: manager.set_transform("x", np.eye(4))),
                           (r"^transform: has the shape \(3, 3\)", lambda: manager.set_transform("a", np.eye(3))),
                           ("^transform: is no rigid motion", lambda: manager.set_transform("a", scaled)),
                           ("^transform: holds a number", lambda: manager.set_transform("a", scaled * np.nan)),
                           ("^transform: is no array", lambda: manager.set_transform("a", [["a"]])),
                           ("^transform: has the shape", lambda: manager.add_object("b", BOX, [1, 2]))):
            with self.subTest(text), self.assertRaisesRegex(ValueError, text):
                call()
        with self.assertRaisesRegex(TypeError, "^mesh: is a str"):
            manager.add_object("b", "box.stl")
        fine = flashbvh.CollisionManager(cell=1e-6)
        fine.add_object("a", BOX)
        fine.add_object("b", BOX)
        with self.assertRaisesRegex(flashbvh.Error, "^box: is too large for a cell of 1e-06"):
            fine.in_collision_internal()


if __name__ == "__main__":
    unittest.main()
