"""collide in both layouts, inside, ray, clearance. Answers in the images' unit and frame; what can't be answered.
Answers themselves: tests/query; all traversals against brute force: tests/walk."""
import math
from pathlib import Path

from cli import Case, fixture, flashbvh, refuse, refuse_each, text, write
from inputs import any_poses, box, HOME, images, meshes, numbers


# Two boxes of 8 mm, the second one's lower corner at (0, 0, 0) of its own frame, a metre off the first one's; face to
# face, edge to edge, corner to corner, touching, intersecting.
@fixture
def boxes_of_8():
    write("there.obj", box(1000, 1000, 1000, 8))
    write("here.obj", box(size=8))
    flashbvh("bake there.obj here.obj -o mm --cell 0.01 --unit mm")
    write("poses", f"""
        {HOME}  1020.5 1001 1002
        {HOME}  1011 1012 1002
        {HOME}  1010 1014 1011
        {HOME}  1008 1000 1000
        {HOME}  1004 1003 1002""")


# Boxes of 10 mm, one after the other along x, 100 mm off their frame's origin: closed, less a side, and pre-indexed.
@fixture
def boxes():
    write("boxes.obj", box(100, size=10) + box(120, size=10, first=8))
    write("open.obj", "\n".join(text("boxes.obj").splitlines()[:-1]))
    flashbvh("bake boxes.obj open.obj -o mm --cell 0.01 --unit mm")
    flashbvh("bake boxes.obj -o pre --layout pre --cell 0.01")


def refuse_lines(command, refusals):
    """Refuses the command with a file `bad` of each key of `refusals`."""
    for line, wanted in refusals.items():
        write("bad", line)
        refuse(command, wanted)


class QueriesTest(Case):
    def test_the_defaults_the_first_pair_alone_and_the_table(self):
        images()
        write("poses", any_poses(22, 25))
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
        meshes()
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

    def test_points_inside_a_mesh(self):
        boxes()
        write("points", """
            115 5 5   # between the boxes
            105 5 5
            110 5 5   # on a face
            110.01 5 5
            1e4 0 0""")
        out = flashbvh("inside mm/boxes.fbvh --points points --json")
        self.assertEqual(out.each("where"), ["outside", "inside", "surface", "outside", "outside"])
        flashbvh("inside mm/boxes.fbvh --points points").matches("^ *1  *inside")
        refuse("inside mm/open.fbvh --points points --json", "is no closed surface and has no inside")
        refuse("inside pre/boxes.fbvh --points points --json", "pre-indexed")
        refuse_lines("inside mm/boxes.fbvh --points bad --json", {
            "1 2": "bad:1: has 2 numbers; a point has 3",
            "1 2 x": "bad:1: 'x' is no finite number",
            "1 2 1e9": "bad:1: the point lies at 1e+09",
            "# none": "bad: is empty",
        })

    def test_hits_of_rays(self):
        boxes()
        write("rays", """
            90 5 4  150 5 4       # through both
            90 0 0  150 0 0       # along edges
            90 11 4  150 11 4     # past them""")
        out = flashbvh("ray mm/boxes.fbvh --rays rays --json")
        self.assertEqual(out.each("hit"), [True, True, False])
        hit = out.lines[0]
        self.assertEqual([hit[name] for name in ("distance", "point", "side", "unit", "crossings")],
                         [10, [100, 5, 4], "front", "mm", 0])
        flashbvh("ray mm/boxes.fbvh --rays rays").matches(r"\Aboxes, distances in mm$", "^ *0  *10 ", "^ *2  *none")
        # An open mesh is hit, and has no crossings.
        flashbvh("ray mm/open.fbvh --rays rays --json").lacks("crossings")
        refuse("ray pre/boxes.fbvh --rays rays", "pre-indexed")
        refuse_lines("ray mm/boxes.fbvh --rays bad", {
            "1 2 3 4 5": "bad:1: has 5 numbers; a ray has 6",
            "1 2 3 4 5 x": "bad:1: 'x' is no finite number",
            "0 0 0 9000 0 0": "ray 0 ends too far off",
            "": "bad: is empty",
        })

    def test_distances_with_their_points(self):
        boxes_of_8()
        out = flashbvh("clearance mm/there.fbvh mm/here.fbvh --poses poses --json")
        for name in ("distance", "lower", "upper"):
            self.assertEqual(out.each(name), [12.5, 5, 7, 0, 0])
        self.assertEqual(out.each("status"), ["ok"] * 5)
        self.assertEqual(out.each("unit"), ["mm"] * 5)
        points = [(line["point_a"], line["point_b"]) for line in out.lines]
        self.assertEqual(points[2], ([1008, 1008, 1008], [1010, 1014, 1011]))
        flashbvh("clearance mm/there.fbvh mm/here.fbvh --poses poses").matches("^ *2 *7 mm")

    # As far away as 400,000 cells, still exact; then so far that the answer is only "at least"; then farther than 1/256
    # cells can express.
    def test_distances_of_bodies_that_are_far_apart(self):
        boxes_of_8()
        write("far", f"{HOME}  5000 0 0\n{HOME}  20000 0 0\n{HOME}  5000000 0 0\n")
        near, far, farther = flashbvh("clearance mm/there.fbvh mm/here.fbvh --poses far --json").lines
        self.assertEqual([near["status"], far["status"]], ["ok", "out_of_range"])
        self.assertAlmostEqual(near["distance"], math.hypot(3992, 992, 992))
        self.assertTrue(0 < far["lower"] <= 19043 and 19044 <= far["upper"] < 19200)
        self.assertEqual([far[name] for name in ("distance", "triangles", "point_a", "point_b")], [None] * 4)
        self.assertIsNone(farther["upper"])
        flashbvh("clearance mm/there.fbvh mm/here.fbvh --poses far").matches(">= .* out of range")

    def test_distances_that_cant_be_queried(self):
        boxes_of_8()
        flashbvh("bake there.obj here.obj -o pre --cell 0.01 --layout pre")
        refuse_each("clearance", {
            "mm/there.fbvh mm/here.fbvh": "poses",
            "pre/there.fbvh pre/here.fbvh --poses poses": "pre-indexed, which has no distances",
        })

    def test_what_collide_bound_prints_of_any_pose_and_of_the_given_ones(self):
        images()
        collide = "collide post/ring.fbvh post/coarse.fbvh --bound"
        out = flashbvh(collide)
        out.matches("^any pose: at most [0-9]* work: [0-9]* visits, of which [0-9]* pairs of leaves")
        self.assertEqual(out.count("\n"), 3)
        write("poses", any_poses(40, 20))
        out = flashbvh(f"{collide} --poses poses")
        out.matches("^40 poses: at most [0-9]* work, 99 % of them at most [0-9]*, the mean [0-9]*$")
        self.assertEqual(out.count("\n"), 4)
        bound = flashbvh(f"{collide} --poses poses --json").json
        self.assertTrue(0 < bound["poses_mean_work"] <= bound["poses_99_percent_work"] <= bound["poses_most_work"]
                        <= bound["most_work"])
        visits = flashbvh("collide post/ring.fbvh post/coarse.fbvh --poses poses --json").each("visits")
        self.assertLessEqual(max(visits), bound["most_visits"])
        # Of 100 poses, 99 are disjoint and need one visit's work.
        write("hundred", f"{HOME}  100 0 0\n" * 99 + f"{HOME}  0 0 0")
        out = flashbvh("collide post/ring.fbvh post/ring.fbvh --bound --poses hundred --json")
        self.assertEqual(out.json["poses_99_percent_work"], 1)
        self.assertGreater(out.json["poses_most_work"], 64)
        refuse_each("collide post/ring.fbvh post/coarse.fbvh", {
            "": "--poses or --bound",
            "--bound --first": "excludes",
            "--bound --pairs found": "excludes",
        })
