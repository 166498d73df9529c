"""The package and an example of its use pass `mypy --strict`; wrong uses do not; all public names have docstrings."""
import inspect
import os
import subprocess
import sys
import unittest
from pathlib import Path

import flashbvh
import program

HERE = Path(__file__).resolve().parent
PACKAGE = Path(os.environ["SOURCES"]) / "tools/python/flashbvh"
HAS_MYPY = subprocess.run([sys.executable, "-c", "import mypy"], capture_output=True).returncode == 0


@unittest.skipUnless(HAS_MYPY, "no mypy: apt-get install mypy")
class TypesTest(unittest.TestCase):
    def setUp(self):
        self.folder = program.folder(self.addCleanup)

    def mypy(self, *paths):
        return subprocess.run([sys.executable, "-m", "mypy", "--strict", "--cache-dir", self.folder / "cache", *paths],
                              capture_output=True, text=True, cwd=PACKAGE.parent,
                              env={**os.environ, "MYPYPATH": str(PACKAGE.parent)})

    def test_the_package_and_an_example(self):
        done = self.mypy(PACKAGE, HERE / "typed.py")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_wrong_uses(self):
        wrong = self.folder / "wrong.py"
        wrong.write_text("import flashbvh\n"
                         "mesh = flashbvh.Mesh.from_file(7)\n"
                         "flashbvh.bake(mesh, leaf_size='2')\n"
                         "flashbvh.Guard(mesh)\n"
                         "flashbvh.bake([mesh]).image\n")
        done = self.mypy(wrong)
        for line in range(2, 6):
            self.assertIn(f"wrong.py:{line}: error", done.stdout)


class DocstringTest(unittest.TestCase):
    def test_all_that_is_public_has_one(self):
        for name in flashbvh.__all__:
            thing = getattr(flashbvh, name)
            if name == "ALL_WORK":
                continue
            self.assertTrue(thing.__doc__, name)
            if inspect.isclass(thing) and thing.__module__.startswith("flashbvh."):
                for member, value in vars(thing).items():
                    if not member.startswith("_") and (callable(value) or isinstance(value, (property, classmethod))):
                        self.assertTrue(getattr(value, "__doc__", None), f"{name}.{member}")


if __name__ == "__main__":
    unittest.main()
