"""The programs of lib/docs/python.md run in order, with the documented results."""
import os
import re
import unittest
from pathlib import Path

import arm
import program
import shapes

PAGE = (Path(os.environ["SOURCES"]) / "lib/docs/python.md").read_text()


class PageTest(unittest.TestCase):
    def test_its_programs(self):
        folder = program.folder(self.addCleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder)
        os.environ["MPLBACKEND"] = "svg"
        program.write_obj(Path("plate.obj"), *shapes.box(40, 40, 2))
        program.write_obj(Path("peg.obj"), *shapes.box(5, 5, 10))
        Path("arm.urdf").write_text(arm.URDF)
        names = {}
        for code in re.findall(r"^```python\n(.*?)^```$", PAGE, re.M | re.S):
            try:
                exec(code, names)
            except ModuleNotFoundError as missing:
                self.assertEqual(missing.name, "matplotlib")
                self.skipTest("no matplotlib; apt-get install python3-matplotlib")
        self.assertAlmostEqual(names["near"].distance[0], 28, places=2)
        self.assertTrue(0 < names["touches"].sum() < 1000)
        self.assertTrue(0 < names["stopped"].sum() < 2000)
        for name in ("plate.fbvh", "arm.robot", "guard.svg"):
            self.assertTrue(Path(name).exists(), name)


if __name__ == "__main__":
    unittest.main()
