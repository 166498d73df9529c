"""Pairs of triangles in both layouts. All traversals against brute force: tests/walk."""
from pathlib import Path

from cli import Case, fixture, flashbvh, write
from inputs import any_poses, images, numbers


@fixture
def poses():
    write("poses", any_poses(22, 25))


class CollideTest(Case):
    inputs = images, poses

    def test_the_defaults_the_first_pair_alone_and_the_table(self):
        out = flashbvh("collide post/ring.fbvh post/coarse.fbvh --poses poses --json --pairs wanted")
        self.assertEqual(set(out.each("algorithm")), {"ranked"})
        intersecting = sorted({pair[0] for pair in numbers("wanted")})
        self.assertGreaterEqual(len(intersecting), 5)
        out = flashbvh("collide pre/ring.fbvh pre/coarse.fbvh --poses poses --json --pairs found")
        self.assertEqual(set(out.each("algorithm")), {"stackless"})
        self.assertEqual(numbers("found"), numbers("wanted"))
        out = flashbvh("collide post/ring.fbvh post/coarse.fbvh --poses poses --first --pairs first --json")
        self.assertEqual([pair[0] for pair in numbers("first")], intersecting)
        self.assertEqual(max(out.each("triangle_pairs")), 1)
        out = flashbvh("collide post/ring.fbvh post/coarse.fbvh --poses poses")
        self.assertEqual(out.count("\n"), 22 + 2)
        count = len(intersecting)
        out.matches(rf"\Aring and coarse, ranked: {count} of 22 poses intersect")
        self.assertEqual(out.count(" intersect  "), count)
        flashbvh("collide pre/ring.fbvh pre/coarse.fbvh --poses poses").contains(" free")
        flashbvh("collide post/ring.fbvh post/coarse.fbvh --poses poses --pairs /dev/null")
        self.assertTrue(Path("/dev/null").is_char_device())

    # A tetrahedron against itself, translated by half a cell: pairs, one mesh inside the other, neither.
    def test_what_is_said_of_each_pose_and_first_of_all(self):
        write("small.obj", "v 1 1 1\nv 1 2 1\nv 2 1 1\nv 1 1 2\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 3 2 4\n")
        flashbvh("bake meshes/tetrahedron.stl small.obj -o solid --cell 0.01")
        for x, verdict, fields in (
                (20, "free", '"intersects":false,"inside":false'),
                (0, "inside", '"intersects":false,"inside":true'),
                (-1, "intersect", '"intersects":true')):
            with self.subTest(x):
                write("pose", f"1 0 0 0 1 0 0 0 1  {x} 0 0\n")
                out = flashbvh("collide solid/tetrahedron.fbvh solid/small.fbvh --poses pose")
                out.matches(rf"\Atetrahedron and small, ranked: {verdict}$", f"^ *0  {verdict}")
                out = flashbvh("collide solid/tetrahedron.fbvh solid/small.fbvh --poses pose --json")
                out.contains(f'{{"pose":0,{fields},"algorithm"')
