"""`flashbvh motion`: two bodies during a motion from one pose to another."""
from cli import Case, fixture, flashbvh, refuse, refuse_each, write
from inputs import box


# Boxes of 10 and 2 mm, each with its lower corner at its origin: B moves down by 10 mm and meets A after 5 mm.
@fixture
def boxes():
    write("a.obj", box(size=10))
    write("b.obj", box(size=2))
    flashbvh("bake a.obj b.obj -o baked --cell 0.01 --unit mm --leaf-size 2 --format image")
    flashbvh("bake a.obj b.obj -o wide --cell 0.01 --unit mm --format image --index-bits 32")
    flashbvh("bake a.obj b.obj -o pre --cell 0.01 --format image --layout pre")
    flashbvh("bake b.obj -o coarse --cell 0.02 --format image")


class MotionTest(Case):
    inputs = boxes,

    def test_where_bodies_touch_first_at_each_width_of_the_indices(self):
        for folder in ("baked", "wide"):
            way = f"motion {folder}/a.fbvh {folder}/b.fbvh --from '0 0 15' --to"
            with self.subTest(folder):
                found = flashbvh(f"{way} '0 0 5' --json", code=1).json
                self.assertEqual((found["outcome"], found["unit"]), ("contact", "mm"))
                self.assertTrue(0.499 < found["from"] < 0.5)
                self.assertAlmostEqual(found["to"], 0.5, delta=0.001)
                self.assertEqual(found["to_pose"][:11], [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0])
                self.assertAlmostEqual(found["to_pose"][11], 10, delta=0.01)
                self.assertLess(max(found["triangles"]), 12)
                found = flashbvh(f"{way} '0 0 5' --within 2 --json", code=1).json
                self.assertAlmostEqual(found["to"], 0.3, delta=0.001)
        self.assertEqual(flashbvh(f"{way} '20 0 15' --within 4.97 --json"), '{"outcome":"free","unit":"mm"}\n')
        self.assertEqual(flashbvh(f"{way} '20 0 15' --within 4.97"), "a and b, within 4.97 mm: free\n")
        flashbvh(f"{way} '0 0 5'", code=1).matches(
            r"\Aa and b: contact$", r"^contact  0\.49\d+ +0\.5\d* +\d+, \d+ +0 0 (10|9\.99\d*)$")

    # An edge of B, which is rotated, moves down across an edge of A.
    def test_close_how_near_at_most(self):
        turned = "-0.552008 -0.218820 0.804615 0.599278 0.566843 0.565293 -0.579787 0.794234 -0.181768"
        way = f'motion baked/a.fbvh baked/b.fbvh --from "{turned} 6.1148 3 16.1148" --to "{turned}'
        found = flashbvh(f'{way} 16.1148 4 6.1148" --json', code=1).json
        self.assertEqual(found["distance_at_most"], 0.02015625)  # two cells, and 4 / 256 of the path
        self.assertTrue(0.494 < found["from"] < found["to"] < 0.4952)
        # To where they are close.
        found = flashbvh(f'{way} 11.0638 3.4949 11.1658" --json', code=1).json
        self.assertEqual((found["outcome"], found["to"]), ("close", 1))
        out = flashbvh(f'{way} 11.0638 3.4949 11.1658"', code=1)
        out.matches(r"\Aa and b: close, at most 0\.020156[23] mm apart$", r"^close  .* 1 ")

    def test_what_is_no_motion_is_refused_with_the_place_and_the_remedy(self):
        refuse_each("motion baked/a.fbvh baked/b.fbvh", {
            '--to "0 0 1"': "--from is required",
            '--from "0 0 1"': "--to is required",
            '--from "0 0 1" --to "1 0 0 0 1 0 0 0 2 0 0 1"': "--to: the first 9 numbers are no rotation",
            '--from "0 0 1" --to "0 0 9000"': "--to: may take B farther than 2^19 cells, 5242.88, from A's origin; cut",
            '--from "0 0 1" --to "0 0 1e9"': "--to: the pose translates B by",
            '--from "0 0 1" --to "0 0 2" --within -1': "--within -1: is out of range: 0 to 320",
            '--from "0 0 1" --to "0 0 2" --within 320.1': "--within 320.1: is out of range: 0 to 320, 32000 cells",
        })
        refuse('motion pre/a.fbvh pre/b.fbvh --from "0 0 1" --to "0 0 2"',
               "pre/a.fbvh: is pre-indexed, which has no distances")
        refuse('motion baked/a.fbvh coarse/b.fbvh --from "0 0 1" --to "0 0 2"', "coarse/b.fbvh")
