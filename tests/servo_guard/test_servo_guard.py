"""The servo guard's firmware in QEMU, against a bus, a hostile host and a judge.

FIRMWARE on QEMU's MACHINE. ARM: the servos' file. JUDGE: the program that judges. ROBOT: URDF, image, and how much
nearer than the stop distance servos may bring links, in metres; then packages. COMMANDS: how many, by SEED.
"""
import os
import random
import subprocess
import tempfile
import unittest

from rig import ALL, READ, SYNC_READ, TURN, WRITE, Rig, goals, hostile, packet


class ServoGuard(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.rig = Rig(os.environ["MACHINE"], os.environ["FIRMWARE"], os.environ["ARM"], self.folder.name)
        self.addCleanup(self.close)
        self.assertTrue(self.rig.says("free"), self.rig.text()[-3:])

    def close(self):
        self.rig.close()
        print(*self.rig.text()[-1:])
        self.folder.cleanup()

    def judge(self):
        self.rig.positions.flush()
        urdf, image, brake, *packages = os.environ["ROBOT"].split()
        words = " ".join([urdf, image, f"{self.folder.name}/positions", brake, *packages])
        judged = subprocess.run([os.environ["JUDGE"], "[judge]"], env={**os.environ, "FLASHBVH_JUDGE": words},
                                capture_output=True, text=True)
        print(judged.stdout)
        self.assertEqual(judged.returncode, 0, judged.stdout + judged.stderr)
        return judged.stdout

    def go(self, to, seconds=10, near=4):
        """Whether the arm comes there, sent there again and again."""
        def is_there():
            return all(abs(at - to[number]) <= near for number, at in self.rig.at().items())
        for _ in range(int(seconds / 0.02)):
            self.rig.send(goals(to))
            if self.rig.run(0.02, is_there):
                return True
        return False

    def test_hostile_host(self):
        rig = self.rig
        home = rig.at()
        unanswered = rig.text()[-1].split()[-1]
        hostile(rig, int(os.environ.get("COMMANDS", 2000)), os.environ.get("SEED", "1"))
        rig.run(1.5)
        self.assertEqual(rig.to_bus.junk, 0)
        if rig.text()[-1].split()[-1] == unanswered:  # else this machine's bus is late
            self.assertEqual(rig.to_host.junk, 0)
        self.judge()
        draw = random.Random(1)  # the straight way home may be closed

        def comes_home():
            for number in draw.sample(list(home), len(home)):
                self.go({**rig.at(), number: home[number]}, 2)
            return self.go(home, 2)
        self.assertTrue(any(comes_home() for _ in range(20)))
        self.assertIn("shortened", rig.text()[-1])

    def test_a_goal_beyond_a_limit_ends_at_it(self):
        rig = self.rig
        rig.send(goals({1: TURN - 1}))
        self.assertTrue(rig.run(10, lambda: rig.servos[1].goal == 3873))  # 2.8 radians
        rig.run(1.5)
        self.assertEqual(rig.at()[1], 3873)
        self.assertIn("free", rig.text()[-1])

    def test_what_moves_nothing_passes_unchanged(self):
        rig = self.rig
        for sent in [packet(1, READ, 62, 3), packet(2, WRITE, 21, 16), packet(3, 1), packet(1, WRITE, 55, 1)] * 20:
            answer = rig.ask(sent)
            self.assertIn(sent, rig.heard)
            self.assertEqual(answer, packet(sent[2], 0, *rig.servos[1].memory[62:65] if sent[4] == READ else []))
        rig.ask(packet(ALL, SYNC_READ, 56, 2, *rig.servos))
        rig.run(0.1)
        self.assertEqual([answer[2] for answer in rig.answers], list(rig.servos))
        for sent in [packet(1, WRITE, 31, 0, 1), packet(1, WRITE, 40, 128), packet(1, WRITE, 33, 1), packet(ALL, 5),
                     packet(1, 4, 42, 0, 8), packet(1, 6), packet(ALL, WRITE, 42, 0, 8), packet(1, WRITE, 46, 1, 0)]:
            self.assertIsNone(rig.ask(sent, 0.1))
            self.assertNotIn(sent, rig.heard)
        self.assertTrue(rig.says("withheld 8"))

    def test_unplugged_servo_junk_and_silence(self):
        rig = self.rig
        home = rig.at()
        near = {number: at + 100 for number, at in home.items()}
        rig.servos[3].is_plugged = False
        self.assertTrue(rig.says("servo 3 is silent"))
        rig.send(goals(near))
        rig.run(0.3)
        self.assertEqual(rig.at(), home)
        rig.servos[3].is_plugged = True
        self.assertTrue(rig.says("free"))
        self.assertTrue(self.go(near))
        rig.run(1.5)  # a silent host
        self.assertEqual({number: servo.goal for number, servo in rig.servos.items()}, near)
        for i in range(100):  # a second of junk, as much as QEMU's UART takes
            rig.send(bytes((i * 37 + j * j * 11) % 256 for j in range(30)))
            rig.run(0.01)
        rig.run(0.5)
        self.assertEqual({number: servo.goal for number, servo in rig.servos.items()}, near)
        self.assertTrue(self.go(home))

    def test_torque_on_moves_nothing(self):
        rig = self.rig
        home = rig.at()
        rig.ask(packet(1, WRITE, 40, 0))
        self.assertTrue(rig.says("servo 1 is loose"))
        rig.servos[1].at += 150
        rig.servos[1].memory[42:44] = bytes([0, 1])  # an old goal, far away
        rig.run(0.1)
        rig.ask(packet(1, WRITE, 40, 1))
        rig.run(0.5)
        self.assertEqual(rig.at(), {**home, 1: home[1] + 150})
        self.assertTrue(self.go(home))
        self.judge()

    def test_folded_starts_come_out(self):
        rig = self.rig
        home = rig.at()
        starts = 0
        for fold in FOLDS:
            self.go(fold, 4)
            self.assertIn("held by", " ".join(rig.text()[-2:]))
            held = rig.at()
            for number in rig.servos:
                rig.ask(packet(number, WRITE, 40, 0))
            rig.is_judged = False
            for number, servo in rig.servos.items():  # by hand, some millimetres farther
                servo.at += max(-5, min(5, fold[number] - held[number]))
            rig.run(0.3)
            rig.start()
            for number in rig.servos:
                rig.ask(packet(number, WRITE, 40, 1))
            self.assertTrue(self.go(home, 60), rig.text()[-2:])
            starts += 1
        self.assertIn(f"starts inside {starts}, came out {starts}", self.judge())


# Where the arm would hit its base, its turret and its upper arm.
FOLDS = [{1: 2048, 2: 700, 3: 2048, 4: 2048}, {1: 2048, 2: 1800, 3: 3900, 4: 2048}]

if __name__ == "__main__":
    unittest.main()
