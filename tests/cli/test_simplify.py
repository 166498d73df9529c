"""Simplified meshes and robots: within the requested length, or as near as fits the requested bytes."""
from cli import Case, flashbvh, long, refuse, refuse_each, same, search, text, write
from inputs import box_of, joint, link, meshes, OPTIONS, robot, shape, two_fingers


class SimplifyTest(Case):
    inputs = meshes,

    def test_fewer_triangles_within_the_length_in_the_image_and_in_c_the_same_bytes_again(self):
        bake = "bake meshes/many_sides.stl --unit mm --simplify 0.2"
        out = flashbvh(f"{bake} -o made")
        triangles, deviation = (out.splitlines()[1].split()[i] for i in (3, 7))
        self.assertLess(int(triangles), 1000)
        self.assertTrue(0.1 < float(deviation) <= 0.2)
        out.contains(f"simplified: 1200 triangles -> {triangles}, leaves of 4; every point within 0.2 mm of the "
                     "file's mesh,")
        said = flashbvh(f"{bake} --dry-run --json").json["meshes"][0]
        self.assertEqual(said["source_triangles"], 1200)
        for found in (search("_DEVIATION ([0-9.e-]*) ", text("made/many_sides.fbvh.h")), said["deviation"],
                      flashbvh("info made/many_sides.fbvh --json").json["deviation"]):
            self.assertAlmostEqual(float(found), float(deviation), delta=1e-4)
        flashbvh(f"{bake} --max-deviation 0.2 -o again")
        same("made", "again")
        refuse("bake meshes/many_sides.stl -o out --simplify 0.2 --max-deviation 0.1",
               "many_sides.stl: the simplified mesh deviates by 0.19")

    def test_what_fits_as_near_to_the_file_as_it_can_be_in_the_leaves_that_it_takes(self):
        for fit, leaves in ((18000, "2 5"), (6000, "2 5 10")):
            out = flashbvh(f"bake meshes/many_sides.stl --fit {fit} -o made")
            self.assertTrue(fit * 0.7 < int(out.splitlines()[1].split()[1]) <= fit)
            self.assertIn(search("leaves of ([0-9]*);", out), leaves.split())
        out = flashbvh("bake meshes/many_sides.stl meshes/ring.stl --fit 12000 --leaf-size 3 -o both")
        self.assertLessEqual(int(out.splitlines()[3].split()[1]), 12000)
        self.assertIn("leaves of 3;", out)
        flashbvh("bake meshes/ring.stl --fit 40000 -o ring").lacks("simplified")
        refuse_each("bake meshes/many_sides.stl -o out --fit", {
            "100": "--fit 100: is not reached by simplifying to",
            "6000 --max-deviation 0.01":
                "--fit 6000: is not reached by simplifying to 0.01, --max-deviation; give more bytes or a larger "
                "--max-deviation",
            # The limit that holds is named.
            "100 --max-deviation 1000": "a twentieth of the largest mesh; give more bytes or bake fewer meshes",
        })

    def test_bytes_are_predicted_to_the_last_one_unchanged_and_simplified(self):
        bake = "bake meshes/many_sides.stl --name a_long_name_of_a_mesh --json"
        predicted = flashbvh(f"{bake} -o made --format image").json["meshes"][0]["flash_bytes"]
        fits = flashbvh(f"{bake} --fit {predicted} -o fits").json["meshes"][0]
        self.assertEqual(fits["triangles"], 1200)
        less = flashbvh(f"{bake} --fit {predicted - 1} -o less").json["meshes"][0]
        self.assertLess(less["flash_bytes"], predicted)

    def test_options_that_are_refused(self):
        refuse_each("bake meshes/ring.stl -o out", {
            "--simplify 0.1 --fit 1000": "--fit: chooses what --simplify says; give one of the two",
            "--simplify 0": "--simplify 0: is no length",
            "--fit 1e3": "--fit 1e3: is no number of bytes; give one from 1 to 4294967295",
            "--simplify 0.1 --deformable": "--deformable: keeps the file's vertices",
            "--simplify 0.01 --cell 0.1": "--simplify 0.01: is less than rounding moves a vertex of meshes/ring.stl",
        })

    def test_time_ends_simplifying_too_and_links_that_it_was_too_short_for_are_named(self):
        robot("round", link("base", shape('<mesh filename="meshes/many_sides.stl" scale="0.001 0.001 0.001"/>')),
              link("arm", box_of("0.1 0.1 0.1")), joint("turn", "revolute", "base", "arm", "", (-1, 1)))
        late, less, full = (flashbvh(f"robot round.urdf --dry-run --json {options}") for options in
                            ("--simplify 0.0002 --time 1e-9", "--simplify 0.0002 --time 1000", ""))
        late.err.contains("--time 1e-9: warning: left too little to simplify 'arm', 'base': they may have more "
                              "triangles",
                          "--time 1e-9: warning: left 1 of 1 pairs of links undecided; give more")
        less.err.lacks("--time")
        late, less, full = (out.json["links"][0]["triangles"] for out in (late, less, full))
        self.assertEqual(late, full)
        self.assertLess(less, full)
        refuse("robot round.urdf --dry-run --fit 6000 --time 1e-9",
               "--fit 6000: is not reached in --time 1e-9; give more of either, or --simplify")

    @long
    def test_a_robots_links_are_simplified_for_firmware_alone_verdicts_witnesses_and_zones_stay(self):
        two_fingers()
        full = flashbvh(f"robot arm.urdf -o full {OPTIONS} --json --format image").json
        less = flashbvh(f"robot arm.urdf -o less {OPTIONS} --simplify 0.002 --json --format image").json
        for pair, simplified in zip(full["pairs"], less["pairs"], strict=True):
            self.assertEqual([pair[name] for name in ("a", "b", "verdict", "witness")],
                             [simplified[name] for name in ("a", "b", "verdict", "witness")])
        self.assertLess(less["flash_bytes"], full["flash_bytes"])
        self.assertEqual((less["simplified"], less["leaf_size"]), (0.002, 4))
        self.assertTrue(0.001 < less["deviation"] <= 0.002)
        self.assertLess(sum(link["triangles"] for link in less["links"]),
                        0.7 * sum(link["source_triangles"] for link in less["links"]))
        out = flashbvh(f"robot arm.urdf -o again {OPTIONS} --simplify 0.002 --format image")
        same("less", "again")
        early = search("^simplified: [0-9]* triangles -> [0-9]*, leaves of 4; (firmware's links and the URDF's lie "
                       "within 0.00[0-9]* m of each other, so a guard stops up to 0.00[0-9]* m earlier); ", out)
        write("still.csv", "turn,slide,wrist,left\n0,-0.9,0,0\n")
        flashbvh("guard less/two_fingers.robot still.csv").contains(f"simplified: {early}\n")
        out = flashbvh("guard less/two_fingers.robot still.csv --json")
        self.assertAlmostEqual(out.lines[0]["deviation"], less["deviation"], delta=1e-6)
        flashbvh("guard full/two_fingers.robot still.csv").lacks("simplified")
        two_thirds = full["flash_bytes"] * 2 // 3
        out = flashbvh(f"robot arm.urdf -o fit {OPTIONS} --fit {two_thirds} --json")
        self.assertTrue(two_thirds * 0.8 < out.json["flash_bytes"] <= two_thirds)
        refuse_each(f"robot arm.urdf -o out {OPTIONS}", {
            "--simplify 0": "--simplify 0: simplifies nothing",
            "--simplify 1e-7": "--simplify 1e-7: is less than rounding moves link",
            "--fit 1000": "--fit 1000: is ",
        })
