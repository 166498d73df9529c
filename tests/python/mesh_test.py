"""Meshes and their queries, against the program `flashbvh` and against numpy."""
import pickle
import threading
import time
import unittest

import numpy as np

import flashbvh
import program
import shapes


class Scene(unittest.TestCase):
    """A torus and a box, baked by the package and by the program."""

    @classmethod
    def setUpClass(cls):
        cls.folder = program.folder(cls.addClassCleanup)
        cls.torus, cls.box = shapes.torus(24, 12, 30, 10), shapes.box(5, 6, 7)
        program.write_obj(cls.folder / "torus.obj", *cls.torus)
        program.write_obj(cls.folder / "box.obj", *cls.box)
        program.run("bake", cls.folder / "torus.obj", cls.folder / "box.obj", "--unit", "mm", "--format", "image",
                    "-o", cls.folder)
        cls.a, cls.b = flashbvh.bake([flashbvh.Mesh.from_file(cls.folder / name) for name in ("torus.obj", "box.obj")])
        cls.poses = shapes.poses(200, 45)
        program.write_poses(cls.folder / "poses.txt", cls.poses)

    def posed(self, command, *arguments):
        return program.lines(command, self.folder / "torus.fbvh", self.folder / "box.fbvh", "--poses",
                             self.folder / "poses.txt", "--float", *arguments)


class BakeTest(Scene):
    def test_an_image_is_that_of_the_program(self):
        for baked, name in ((self.a, "torus"), (self.b, "box")):
            self.assertEqual(baked.image, (self.folder / f"{name}.fbvh").read_bytes())
            self.assertEqual(flashbvh.Baked.load(self.folder / f"{name}.fbvh").image, baked.image)

    def test_arrays_bake_to_the_image_of_a_file(self):
        from_arrays = flashbvh.bake([flashbvh.Mesh.from_arrays(*self.torus, name="torus"),
                                     flashbvh.Mesh.from_arrays(*self.box, name="box")])
        self.assertEqual([baked.image for baked in from_arrays], [self.a.image, self.b.image])

    def test_an_image_survives_a_file_and_a_pickle(self):
        self.a.save(self.folder / "saved.fbvh")
        self.assertEqual(flashbvh.Baked.load(str(self.folder / "saved.fbvh")).image, self.a.image)
        self.assertEqual(flashbvh.Baked.load(self.a.image).image, self.a.image)
        self.assertEqual(pickle.loads(pickle.dumps(self.a)).image, self.a.image)

    def test_properties(self):
        self.assertEqual((self.b.name, self.b.unit, self.b.triangle_count, self.b.is_closed), ("box", "mm", 12, True))
        self.assertEqual(self.a.cell, self.b.cell)
        self.assertEqual(self.a.cell, flashbvh.Mesh.from_arrays(*self.torus).finest_cell)
        np.testing.assert_allclose(self.b.bounds, [[-5, -6, -7], [5, 6, 7]], atol=self.b.cell)
        np.testing.assert_array_equal(self.b.triangle_ids, np.arange(12))
        corners = self.a.vertices[self.a.triangles]
        np.testing.assert_allclose(corners, self.torus[0][self.torus[1]], atol=self.a.cell)
        self.assertLessEqual(np.abs(corners - self.torus[0][self.torus[1]]).max(), self.a.deviation)

    def test_scale_and_cell(self):
        mesh = flashbvh.Mesh.from_file(self.folder / "box.obj", scale=0.1, cell=0.01)
        np.testing.assert_allclose(mesh.bounds, [[-0.5, -0.6, -0.7], [0.5, 0.6, 0.7]])
        self.assertEqual(flashbvh.bake(mesh, unit="cm").cell, 0.01)
        self.assertEqual(flashbvh.bake(mesh, unit=None).unit, "")

    def test_a_simplified_mesh_has_fewer_triangles(self):
        mesh = flashbvh.Mesh.from_arrays(*self.torus)
        simple = flashbvh.bake(mesh, simplify=2.0)
        self.assertLess(simple.triangle_count, mesh.triangle_count / 2)
        self.assertLessEqual(simple.deviation, 2.0)

    def test_an_open_surface_is_warned_of(self):
        vertices, triangles = self.box
        with self.assertWarnsRegex(flashbvh.BakeWarning, "sheet: .*boundary") as warned:
            baked = flashbvh.bake(flashbvh.Mesh.from_arrays(vertices, triangles[1:], name="sheet"))
        self.assertFalse(baked.is_closed)
        self.assertEqual(warned.filename, __file__, "the line that called")


class QueryTest(Scene):
    def test_intersects_and_pairs_as_the_program(self):
        found = flashbvh.intersects(self.a, self.b, self.poses)
        answers = self.posed("collide", "--pairs", self.folder / "pairs.txt")
        self.assertTrue(0 < found.sum() < len(found))
        self.assertEqual([line["intersects"] for line in answers], found.tolist())
        expected = np.loadtxt(self.folder / "pairs.txt", dtype=int, ndmin=2)
        for i, pose in enumerate(self.poses):
            pairs = flashbvh.pairs(self.a, self.b, pose)
            self.assertEqual(sorted(map(tuple, pairs)), list(map(tuple, expected[expected[:, 0] == i, 1:])))

    def test_the_first_pair_is_one_of_all(self):
        found = flashbvh.first_pair(self.a, self.b, self.poses)
        np.testing.assert_array_equal(found[:, 0] >= 0, flashbvh.intersects(self.a, self.b, self.poses))
        for pose, pair in zip(self.poses, found):
            self.assertIn(tuple(pair), [*map(tuple, flashbvh.pairs(self.a, self.b, pose)), (-1, -1)])
        np.testing.assert_array_equal(flashbvh.first_pair(self.a, self.b, self.poses[0]), found[0])

    def test_distance_as_the_program(self):
        found = flashbvh.distance(self.a, self.b, self.poses, is_motion=True)
        lines = self.posed("clearance")
        for rows, name in ((found.distance, "lower"), (found.upper, "upper"), (found.point_a, "point_a"),
                           (found.point_b, "point_b"), (found.triangles, "triangles")):
            np.testing.assert_array_equal(rows, [line[name] for line in lines], name)
        apart = found.distance > 0
        between = np.linalg.norm(found.point_b - found.point_a, axis=1)
        np.testing.assert_allclose(between[apart], found.distance[apart], atol=self.a.cell / 64)

    def test_a_motion_has_the_distances_of_its_poses(self):
        single = flashbvh.distance(self.a, self.b, self.poses)
        motion = flashbvh.distance(self.a, self.b, self.poses, is_motion=True)
        np.testing.assert_array_equal(motion.distance, single.distance)
        np.testing.assert_array_equal(motion.upper, single.upper)

    def test_closer_than_is_the_distance_compared(self):
        found = flashbvh.distance(self.a, self.b, self.poses)
        sure = np.abs(found.distance - 3) > self.a.cell / 64
        np.testing.assert_array_equal(flashbvh.closer_than(self.a, self.b, self.poses, 3)[sure],
                                      (found.distance < 3)[sure])

    def test_closer_than_rounds_a_length_up(self):
        box = flashbvh.bake(flashbvh.Mesh.from_arrays(*shapes.box(9, 9, 9)), cell=1.0)
        pose = shapes.translated(19, 19, 0)  # edges sqrt(2) apart
        for length in (1.4143, 1.4155, 1.4179, 1.418):
            self.assertTrue(flashbvh.closer_than(box, box, pose, length), length)
        self.assertFalse(flashbvh.closer_than(box, box, pose, 1.414))

    def test_distance_of_boxes_by_formula(self):
        box = flashbvh.bake(flashbvh.Mesh.from_arrays(*shapes.box(1, 1, 1)), cell=0.001)
        gaps = np.linspace(0.5, 3, 11)
        poses = np.array([shapes.translated(2 + gap, 0.25, 0) for gap in gaps])
        found = flashbvh.distance(box, box, poses)
        np.testing.assert_allclose(found.distance, gaps, atol=0.001)
        np.testing.assert_allclose(found.point_a[:, 0], 1)

    def test_a_batch_is_its_poses_one_by_one(self):
        for query in (flashbvh.intersects, flashbvh.solids_intersect,
                      lambda a, b, poses: flashbvh.closer_than(a, b, poses, 2.5),
                      lambda a, b, poses: flashbvh.distance(a, b, poses).distance):
            batch = query(self.a, self.b, self.poses)
            self.assertEqual(batch.shape, (200,))
            self.assertEqual(query(self.a, self.b, self.poses[0]).shape, ())
            self.assertEqual(query(self.a, self.b, self.poses[:0]).shape, (0,))
            self.assertEqual(batch.tolist(), [query(self.a, self.b, pose).tolist() for pose in self.poses])

    def test_too_far_to_measure(self):
        found = flashbvh.distance(self.a, self.b, shapes.translated(2e6 * self.a.cell, 0, 0))
        self.assertTrue(np.isnan(found.point_a).all() and (found.triangles == -1).all())
        between = 2e6 * self.a.cell - 40 - 5
        self.assertTrue(1e6 * self.a.cell < found.distance < between < found.upper + self.a.cell)

    def test_a_solid_in_another_one(self):
        outer = flashbvh.bake(flashbvh.Mesh.from_arrays(*shapes.box(9, 9, 9), name="outer"), cell=self.b.cell)
        self.assertFalse(flashbvh.intersects(outer, self.b, np.eye(4)))
        self.assertTrue(flashbvh.solids_intersect(outer, self.b, np.eye(4)))

    def test_indices_of_32_bits_answer_alike(self):
        meshes = [flashbvh.Mesh.from_arrays(*self.torus), flashbvh.Mesh.from_arrays(*self.box)]
        a, b = flashbvh.bake(meshes, index_bits=32)
        np.testing.assert_array_equal(flashbvh.intersects(a, b, self.poses),
                                      flashbvh.intersects(self.a, self.b, self.poses))
        np.testing.assert_array_equal(flashbvh.distance(a, b, self.poses).distance,
                                      flashbvh.distance(self.a, self.b, self.poses).distance)


class RayAndPointTest(Scene):
    def test_rays_as_the_program(self):
        random = np.random.default_rng(2)
        origins = random.uniform(-60, 60, (100, 3))
        directions = random.uniform(-30, 30, (100, 3)) - origins
        rays = np.column_stack([origins, directions, np.full(100, 150.0)])
        (self.folder / "rays.txt").write_text("".join(" ".join(map(repr, ray)) + "\n" for ray in rays.tolist()))
        hits = flashbvh.nearest_hit(self.a, origins, directions, 150)
        lines = program.lines("ray", self.folder / "torus.fbvh", "--rays", self.folder / "rays.txt")
        self.assertEqual(hits.hit.tolist(), [line["hit"] for line in lines])
        self.assertTrue(0 < hits.hit.sum() < 100)
        for i, line in enumerate(lines):
            self.assertEqual(hits.triangle[i], line.get("triangle", -1))
            self.assertEqual(hits.distance[i], line.get("distance", np.inf))
        single = flashbvh.nearest_hit(self.a, origins[0], directions[0], 150)
        self.assertEqual(single.hit.shape, ())

    def test_inside_by_formula(self):
        points = np.random.default_rng(3).uniform(-10, 10, (2000, 3))
        expected = (np.abs(points) <= [5, 6, 7]).all(axis=1)
        sure = (np.abs(np.abs(points) - [5, 6, 7]) > 0.01).all(axis=1)
        np.testing.assert_array_equal(flashbvh.inside(self.b, points)[sure], expected[sure])
        self.assertTrue(flashbvh.inside(self.b, [5, 0, 0]), "on the surface")


class BatchTest(Scene):
    def test_a_batch_runs_without_the_lock(self):
        poses = shapes.poses(3000, 30)
        ticks = []
        thread = threading.Thread(target=lambda: flashbvh.distance(self.a, self.b, poses))
        thread.start()
        while thread.is_alive():
            ticks.append(time.perf_counter())
            time.sleep(0.001)
        self.assertGreater(len(ticks), 5)

    def test_a_query_of_a_batch_takes_microseconds(self):
        poses = shapes.poses(20000, 1000)
        seconds = []
        for _ in range(5):
            began = time.perf_counter()
            flashbvh.intersects(self.a, self.b, poses)
            seconds.append(time.perf_counter() - began)
        print(f"a separated pose: {min(seconds) / len(poses) * 1e6:.3f} us")
        self.assertLess(min(seconds) / len(poses), 2e-6)


if __name__ == "__main__":
    unittest.main()
