"""Robots, guards and motions, against the program `flashbvh`."""
import pickle
import threading
import time
import unittest
import warnings

import numpy as np

import arm
import flashbvh
import program
import shapes
from flashbvh import Verdict

NAMES = {"free": Verdict.FREE, "warn": Verdict.WARN, "not_yet_known": Verdict.NOT_YET_KNOWN, "stop": Verdict.STOP,
         "refused": Verdict.REFUSED}


def trajectory(count, seed=1):
    """Random waypoints within the limits, joined by straight lines; a few values are beyond them."""
    random = np.random.default_rng(seed)
    ways = random.uniform([-9, -3, -0.09], [9, 3, 0.1], (count // 50 + 2, 3))
    rows = np.array([np.interp(np.arange(count) / 50, np.arange(len(ways)), way) for way in ways.T]).T
    rows[count // 2, 1] = 3.5
    return rows


class Scene(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = program.folder(cls.addClassCleanup)
        cls.urdf = cls.folder / "arm.urdf"
        cls.urdf.write_text(arm.URDF)
        cls.robot = flashbvh.Robot.from_urdf(cls.urdf, stop=0.01, warn=0.05)

    def replayed(self, rows, *options):
        (self.folder / "rows.csv").write_text("turn,fold,grip\n" + "".join(
            ",".join(map(repr, row)) + "\n" for row in rows.tolist()))
        self.robot.save(self.folder / "arm.robot")
        return program.lines("guard", self.folder / "arm.robot", self.folder / "rows.csv", *options, exits=(0, 1, 3))


class RobotTest(Scene):
    def test_the_image_is_that_of_the_program(self):
        program.run("robot", self.urdf, "--stop", "0.01", "--warn", "0.05", "--format", "image", "-o", self.folder)
        self.assertEqual(self.robot.image, (self.folder / "arm.robot").read_bytes())

    def test_options_are_those_of_the_program(self):
        (self.folder / "arm.srdf").write_text(
            '<robot name="arm"><disable_collisions link1="left" link2="right" reason="User"/></robot>')
        program.run("robot", self.urdf, "--stop", "0.01", "--format", "image", "-o", self.folder / "more", "--srdf",
                    self.folder / "arm.srdf", "--believe", "left,right", "--cell", "0.0001", "--leaf-size", "4",
                    "--pair", "upper,fore=0.02,0.03", "--zone", "grip=0.01", "--time", "60")
        with self.assertWarnsRegex(flashbvh.BakeWarning, "not guarded: fore - left within 0.01 m about grip"):
            robot = flashbvh.Robot.from_urdf(
                self.urdf, stop=0.01, srdf=self.folder / "arm.srdf", believe=[("left", "right")], cell=0.0001,
                leaf_size=4, pairs={("upper", "fore"): (0.02, 0.03)}, zones={"grip": 0.01}, time=60)
        self.assertEqual(robot.image, (self.folder / "more/arm.robot").read_bytes())
        self.assertIn(("left", "right"), [(pair.a, pair.b) for pair in robot.unguarded])

    def test_files_and_sizes_are_those_of_the_program(self):
        (self.folder / "elsewhere").mkdir()
        program.write_obj(self.folder / "elsewhere/peg.obj", *shapes.torus(24, 12, 0.03, 0.01))
        mesh = '<mesh filename="package://parts/peg.obj"/>'
        urdf = self.folder / "meshes.urdf"
        urdf.write_text(arm.URDF.replace('<box size="0.02 0.02 0.1"/>', mesh, 1).replace("<collision>", "<visual>", 1)
                        .replace("</collision>", "</visual>", 1))
        for options, words in (({}, []), ({"visual_too": True}, ["--visual-too"]),
                               ({"simplify": 0.002}, ["--simplify", "0.002"]), ({"fit": 12000}, ["--fit", "12000"]),
                               ({"fit": 12000, "leaf_size": 2}, ["--fit", "12000", "--leaf-size", "2"])):
            with self.subTest(words), warnings.catch_warnings():
                warnings.simplefilter("ignore")
                program.run("robot", urdf, "--package", f"parts={self.folder / 'elsewhere'}", "--format", "image", "-o",
                            self.folder / "more", *words)
                robot = flashbvh.Robot.from_urdf(urdf, packages={"parts": str(self.folder / "elsewhere")}, **options)
                self.assertEqual(robot.image, (self.folder / "more/arm.robot").read_bytes())

    def test_what_it_knows(self):
        self.assertEqual(self.robot.name, "arm")
        self.assertEqual(self.robot.joint_names, ["turn", "fold", "grip"])
        self.assertEqual(self.robot.link_names, ["column", "upper", "fore", "left", "right"])
        np.testing.assert_allclose(self.robot.limits, [[-np.inf, np.inf], [-3, 3], [-0.09, 0.1]], atol=1e-5)
        printed, = program.lines("robot", self.urdf, "--stop", "0.01", "--warn", "0.05", "--dry-run")
        self.assertEqual([(row.a, row.b, row.verdict, row.reason, row.is_guarded) for row in self.robot.matrix],
                         [(pair["a"], pair["b"], pair["verdict"], pair["reason"], pair["guarded"])
                          for pair in printed["pairs"]])
        guarded = [(row.a, row.b) for row in self.robot.matrix if row.is_guarded]
        self.assertEqual([(pair.a, pair.b) for pair in self.robot.pairs], guarded)
        self.assertTrue(all(0.01 <= pair.stop < 0.0101 and 0.05 <= pair.warn < 0.0501 for pair in self.robot.pairs))

    def test_a_witness_collides(self):
        for row in self.robot.matrix:
            if row.witness is not None:
                self.assertEqual(flashbvh.Guard(self.robot).update(row.witness).verdict, Verdict.STOP)

    def test_an_image_is_opened_again(self):
        self.robot.save(self.folder / "saved.robot")
        for opened in (flashbvh.Robot.load(self.robot.image), flashbvh.Robot.load(self.folder / "saved.robot"),
                       pickle.loads(pickle.dumps(self.robot))):
            self.assertEqual(opened.image, self.robot.image)
            self.assertEqual(opened.pairs, self.robot.pairs)
            self.assertIsNone(opened.matrix)


class GuardTest(Scene):
    def test_a_trajectory_as_the_program(self):
        rows = trajectory(3000)
        rows[:2, 1] = 3.5  # refused values do not prime
        for work in (flashbvh.ALL_WORK, 40):
            checked = flashbvh.Guard(self.robot).check(rows, work)
            lines = self.replayed(rows, "--work", work)
            self.assertEqual(len(lines), len(rows))
            self.assertEqual(checked.verdicts.dtype, np.uint8)
            self.assertEqual(checked.verdicts.tolist(), [NAMES[line["verdict"]] for line in lines])
            pairs = self.robot.pairs
            self.assertEqual([(pairs[i].a, pairs[i].b) if i >= 0 else (None, None) for i in checked.pairs],
                             [(line["a"], line["b"]) for line in lines])
            self.assertEqual(checked.work.tolist(), [line["work"] for line in lines])
            stopped = [i for i, line in enumerate(lines) if line["distance"] is not None]
            np.testing.assert_allclose(checked.distances[stopped], [lines[i]["distance"] for i in stopped])
            seen = set(checked.verdicts.tolist())
            self.assertTrue(seen >= {Verdict.FREE, Verdict.WARN, Verdict.STOP, Verdict.REFUSED}, seen)
        self.assertIn(Verdict.NOT_YET_KNOWN, seen)

    def test_periods_one_by_one_are_the_trajectory(self):
        rows = trajectory(500)
        checked = flashbvh.Guard(self.robot).check(rows, 100)
        guard = flashbvh.Guard(self.robot)
        for i, row in enumerate(rows):
            answer = guard.update(row, flashbvh.ALL_WORK if i == 0 else 100)
            self.assertEqual((answer.verdict, -1 if answer.pair is None else answer.pair, answer.work),
                             (checked.verdicts[i], checked.pairs[i], checked.work[i]))
            self.assertEqual(answer.links is None, answer.pair is None)
        for again, first in zip(guard.check(rows, 100), checked):
            np.testing.assert_array_equal(again, first, "check() begins with nothing known")

    def test_more_work_decides(self):
        guard = flashbvh.Guard(self.robot)
        answer = guard.update([0, 2.4, 0.05], 1)
        self.assertEqual(answer.verdict, Verdict.NOT_YET_KNOWN)
        periods = 1
        while answer.verdict == Verdict.NOT_YET_KNOWN:
            answer = guard.go_on(20)
            periods += 1
        self.assertGreater(periods, 2)
        self.assertEqual(answer.verdict, flashbvh.Guard(self.robot).update([0, 2.4, 0.05]).verdict)

    def test_what_is_forgotten_is_primed_again(self):
        guard = flashbvh.Guard(self.robot)
        first = guard.update([0, 0, 0.05])
        guard.update([0, 0.1, 0.05])
        guard.forget()
        self.assertEqual(guard.update([0, 0, 0.05]), first)

    def test_threads_share_a_guard(self):
        guard = flashbvh.Guard(self.robot)
        rows = trajectory(60000)
        expected = flashbvh.Guard(self.robot).check(rows, 100)
        found = []
        threads = [threading.Thread(target=lambda: found.append(guard.check(rows, 100))) for _ in range(3)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(found), 3)
        for checked in found:
            np.testing.assert_array_equal(checked.verdicts, expected.verdicts)
            np.testing.assert_array_equal(checked.work, expected.work)

    def test_a_free_period_takes_microseconds(self):
        rows = np.zeros((50000, 3))
        rows[:, 0] = np.linspace(0, 30, len(rows))
        rows[:, 2] = 0.05
        began = time.perf_counter()
        checked = flashbvh.Guard(self.robot).check(rows)
        took = (time.perf_counter() - began) / len(rows)
        print(f"a period of a guard: {took * 1e6:.3f} us")
        self.assertTrue((checked.verdicts == Verdict.FREE).all())
        self.assertLess(took, 5e-6)


class MotionTest(Scene):
    def test_motions_as_the_program(self):
        rows = trajectory(120)[::6]
        motion = flashbvh.Motion(self.robot)
        outcomes = set()
        for i, line in enumerate(self.replayed(rows, "--motion")[1:]):
            answer, expected = motion.certify(rows[i], rows[i + 1]), line["motion"]
            outcomes.add(answer.outcome)
            self.assertEqual(answer.outcome, expected["outcome"])
            self.assertEqual(answer.is_free, answer.outcome == "free")
            if answer.values is not None:
                self.assertEqual((answer.part, list(answer.links)), (expected["part"], [expected["a"], expected["b"]]))
                np.testing.assert_array_equal(answer.values, [expected["values"][n] for n in self.robot.joint_names])
            if answer.outcome == "hit":
                self.assertEqual(list(answer.triangles), expected["triangles"])
        self.assertTrue(outcomes >= {"free", "hit", "refused"}, outcomes)


class RefusalTest(Scene):
    def test_descriptions_as_the_program(self):
        for name, text in (("none.urdf", None), ("text.urdf", "no robot"), ("root.urdf", "<house/>"),
                           ("loop.urdf", arm.URDF.replace('child link="upper"', 'child link="column"'))):
            if text is not None:
                (self.folder / name).write_text(text)
            with self.assertRaises(flashbvh.Error) as raised:
                flashbvh.Robot.from_urdf(self.folder / name)
            self.assertEqual(str(raised.exception), program.message("robot", self.folder / name, "--dry-run"))

    def test_options_as_the_program(self):
        for options, words in (({"stop": -1}, ["--stop", "-1.0"]),
                               ({"stop": 0.02, "warn": 0.01}, ["--stop", "0.02", "--warn", "0.01"]),
                               ({"stop": float("nan")}, ["--stop", "nan"]), ({"stop": 1e9}, ["--stop", "1000000000.0"]),
                               ({"believe": [("left", "right")]}, ["--believe", "left,right"]),
                               ({"pairs": {("left", "no"): (0.1, 0.2)}}, ["--pair", "left,no=0.1,0.2"]),
                               ({"zones": {"no": 0.1}}, ["--zone", "no=0.1"]), ({"fit": 10}, ["--fit", "10"]),
                               ({"simplify": 0}, ["--simplify", "0.0"]), ({"time": 0}, ["--time", "0.0"]),
                               ({"cell": 0}, ["--cell", "0.0"])):
            with self.subTest(words), self.assertRaises(flashbvh.Error) as raised:
                flashbvh.Robot.from_urdf(self.urdf, **options)
            self.assertEqual(str(raised.exception), program.message("robot", self.urdf, "--dry-run", *words))
        with self.assertRaisesRegex(ValueError, "^leaf_size: is out of range; give 1 to 16$"):
            flashbvh.Robot.from_urdf(self.urdf, leaf_size=0)

    def test_an_srdf_that_disables_what_can_collide(self):
        (self.folder / "wrong.srdf").write_text(
            '<robot name="arm"><disable_collisions link1="left" link2="right" reason="Never"/></robot>')
        with self.assertRaisesRegex(flashbvh.Error, "left - right|left and right"):
            flashbvh.Robot.from_urdf(self.urdf, srdf=self.folder / "wrong.srdf")

    def test_images(self):
        image = self.robot.image
        for text, wrong in (("^image: is truncated", image[:-4]),
                            ("^image: is corrupt", image[:200] + b"\7" + image[201:]),
                            ("^image: is no image of a robot", bytes(200)),
                            ("^image: has 4 bytes after", image + bytes(4))):
            with self.subTest(text), self.assertRaisesRegex(flashbvh.Error, text):
                flashbvh.Robot.load(wrong)
        with self.assertRaises(TypeError):
            flashbvh.Robot(None)
        for wants_robot in (flashbvh.Guard, flashbvh.Motion):
            with self.subTest(wants_robot), self.assertRaisesRegex(TypeError, "^robot: give a Robot$"):
                wants_robot("x")

    def test_values(self):
        guard = flashbvh.Guard(self.robot)
        for text, values in ((r"^values: has the shape \(2,\); give \(3,\)", [0, 0]),
                             ("^values: holds NaN", [0, np.nan, 0]),
                             ("^values: has the dtype <U1", ["a", "b", "c"]),
                             ("^values: is a batch", np.zeros((2, 3)))):
            with self.subTest(text), self.assertRaisesRegex(ValueError, text):
                guard.update(values)
        for text, rows in ((r"^trajectory: has the shape \(3,\); give \(N, 3\)$", [0, 0, 0]),
                           ("^trajectory: holds infinity in element 1", [[0, 0, 0], [0, np.inf, 0]])):
            with self.subTest(text), self.assertRaisesRegex(ValueError, text):
                guard.check(rows)
        for work in (0, -1, 2**40):
            with self.assertRaisesRegex(ValueError, "^work: is "):
                guard.update([0, 0, 0], work)
        self.assertEqual(len(guard.check(np.zeros((0, 3))).verdicts), 0)
        self.assertEqual(guard.go_on().verdict, Verdict.REFUSED)
        self.assertEqual(guard.update([0, 1e300, 0]).status, "not_a_coordinate")
        for start, end, text in (([0, 0], [0, 0, 0], "^start: has the shape"),
                                 ([0, 0, 0], [[0, 0, 0]], "^end: is a batch")):
            with self.assertRaisesRegex(ValueError, text):
                flashbvh.Motion(self.robot).certify(start, end)


if __name__ == "__main__":
    unittest.main()
