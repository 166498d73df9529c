"""Robots and guards, against the program `flashbvh`; the page's code."""
import os
import pickle
import re
import unittest
from pathlib import Path

import numpy as np

import flashbvh
from flashbvh import Error, Robot, Verdict
from support import ARM, Case, box, lines

PAGE = Path(__file__).parents[2] / "lib/docs/guide.md"


class RobotTest(Case):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.urdf = cls.folder / "arm.urdf"
        cls.urdf.write_text(ARM)
        cls.robot = Robot.from_urdf(cls.urdf, stop=0.01, warn=0.05)

    def test_the_image_is_that_of_the_program(self):
        (self.folder / "arm.srdf").write_text(
            '<robot name="arm"><disable_collisions link1="left" link2="right" reason="User"/></robot>')
        lines("robot", self.urdf, "--stop", "0.01", "--format", "image", "-o", self.folder, "--srdf",
              self.folder / "arm.srdf", "--believe", "left,right", "--cell", "0.0001", "--leaf-size", "4",
              "--pair", "upper,fore=0.02,0.03", "--zone", "grip=0.01", "--time", "60")
        with self.assertWarnsRegex(flashbvh.BakeWarning, "fore - left within 0.01 m about grip"):
            robot = Robot.from_urdf(
                self.urdf, stop=0.01, srdf=self.folder / "arm.srdf", believe=[("left", "right")], cell=0.0001,
                leaf_size=4, pairs={("upper", "fore"): (0.02, 0.03)}, zones={"grip": 0.01}, time=60)
        self.assertEqual(robot.image, (self.folder / "arm.robot").read_bytes())
        self.assertIn(("left", "right"), [(pair.a, pair.b) for pair in robot.unguarded])

    def test_a_robot_says_what_it_is(self):
        robot = pickle.loads(pickle.dumps(self.robot))
        self.assertEqual((robot.name, robot.joint_names, robot.link_names, robot.matrix), (
            "arm", ["turn", "fold", "grip"], ["column", "upper", "fore", "left", "right"], None))
        np.testing.assert_allclose(robot.limits, [[-np.inf, np.inf], [-3, 3], [-0.09, 0.1]], atol=1e-5)
        self.assertEqual([(row.a, row.b) for row in self.robot.matrix if row.guarded],
                         [(pair.a, pair.b) for pair in robot.pairs])
        self.assertEqual(len(self.robot.matrix), 10)
        np.testing.assert_allclose([(pair.stop, pair.warn) for pair in robot.pairs], [[0.01, 0.05]] * 6, atol=1e-6)

    def test_a_trajectory_is_checked_as_by_the_program(self):
        random = np.random.default_rng(1)
        ways = random.uniform([-9, -3, -0.09], [9, 3, 0.1], (42, 3))
        rows = np.array([np.interp(np.arange(2000) / 50, np.arange(42), way) for way in ways.T]).T
        rows[1000, 1] = 3.5  # beyond the limit
        (self.folder / "rows.csv").write_text("turn,fold,grip\n" + "".join(
            ",".join(map(repr, row)) + "\n" for row in rows.tolist()))
        self.robot.save(self.folder / "checked.robot")
        found = flashbvh.Guard(self.robot).check(rows, work=40)
        periods = lines("guard", self.folder / "checked.robot", self.folder / "rows.csv", "--work", 40, exits=(0, 1, 3))
        self.assertEqual([period["verdict"] for period in periods],
                         [Verdict(number).name.lower() for number in found.verdicts])
        self.assertEqual([period["work"] for period in periods], found.work.tolist())
        self.assertEqual(set(found.verdicts) | {Verdict.LEAVING}, set(Verdict))
        guard = flashbvh.Guard(self.robot)
        for i, row in enumerate(rows[:300]):
            answer = guard.update(row, 40 if i else flashbvh.ALL_WORK)
            pair = -1 if answer.pair is None else answer.pair
            self.assertEqual((answer.verdict, pair, answer.distance, answer.work), found[i].tolist())
            self.assertEqual(answer.links or (None, None), (periods[i]["a"], periods[i]["b"]))

    def test_commands_are_let_through_as_the_program_does(self):
        rows = np.array([[0.1 * i / 40, 1 + 2 * i / 40, 0.05] for i in range(40)] + [[0, 1, 0.05]] * 3)
        (self.folder / "wanted.csv").write_text("turn,fold,grip\n" + "".join(
            ",".join(map(repr, row)) + "\n" for row in rows.tolist()))
        self.robot.save(self.folder / "limited.robot")
        periods = lines("guard", self.folder / "limited.robot", self.folder / "wanted.csv", "--limit",
                        self.folder / "granted.csv", exits=(0, 1))
        granted = np.loadtxt(self.folder / "granted.csv", delimiter=",", skiprows=1)
        guard = flashbvh.Guard(self.robot)
        guard.update(rows[0])
        for row, period, values in zip(rows, periods, granted):
            answer = guard.limit(row)
            said = period["limit"]
            self.assertEqual((answer.verdict.name.lower(), answer.share), (said["verdict"], said["share"]))
            self.assertEqual(answer.links, (said["a"], said["b"]) if answer.links else None)
            np.testing.assert_allclose(answer.granted, values, atol=1e-6)
            guard.update(answer.granted)
        self.assertLess({"granted", "shortened"}, {period["limit"]["verdict"] for period in periods} | {"held"})
        self.refused(Error, "^pair: guard_state_invalid", guard.release, 99, 0.001)
        guard.release(0, 0.001)

    def test_a_period_goes_on(self):
        guard = flashbvh.Guard(self.robot)
        self.assertEqual(guard.go_on().verdict, Verdict.REFUSED)
        self.assertEqual(guard.update([0, 1, 0], 1).verdict, Verdict.NOT_YET_KNOWN)
        self.assertEqual(guard.go_on().verdict, Verdict.FREE)
        self.assertEqual(guard.update([0, 1e300, 0]).status, "not_a_coordinate")
        self.assertEqual(guard.update([0, 3.1, 0])[::5], (Verdict.REFUSED, "joint_out_of_limits"))

    def test_refusals(self):
        guard = flashbvh.Guard(self.robot)
        image = self.robot.image
        self.refused(ValueError, r"^values: has the shape \(2,\)", guard.update, [0, 0])
        self.refused(ValueError, "^values: holds a number that is not finite", guard.update, [0, np.nan, 0])
        self.refused(ValueError, r"^values: has the shape \(2, 3\)", guard.update, np.zeros((2, 3)))
        self.refused(ValueError, r"^trajectory: has the shape \(3,\)", guard.check, [0, 0, 0])
        self.refused(ValueError, "^work: is 0", guard.update, [0, 0, 0], 0)
        self.refused(TypeError, "^robot: give a Robot", flashbvh.Guard, "x")
        self.refused(Error, "^--time", Robot.from_urdf, self.urdf, time=0)
        for status, wrong in (("image_truncated", image[:-4]), ("image_corrupt", image[:200] + b"\7" + image[201:]),
                              ("image_truncated", b"")):
            self.refused(Error, f"^image: {status}", Robot.load, wrong)


class PageTest(Case):
    def test_the_code_of_the_page(self):
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)
        Path("arm.urdf").write_text(ARM)
        for name, (vertices, triangles) in (("plate", box(40, 40, 2)), ("peg", box(5, 5, 10))):
            Path(f"{name}.obj").write_text(flashbvh.Mesh.from_arrays(vertices, triangles)._obj)
        names = {}
        exec("".join(re.findall(r"^```python\n(.*?)^```$", PAGE.read_text(), re.M | re.S)), names)
        self.assertAlmostEqual(names["near"].distance[0], 28, places=2)
        self.assertTrue(0 < names["touches"].sum() < 1000)
        self.assertTrue(0 < (names["checked"].verdicts >= Verdict.STOP).sum() < 2000)


if __name__ == "__main__":
    unittest.main()
