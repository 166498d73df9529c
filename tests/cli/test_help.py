"""Help with its examples, and mistyped words."""
import re
import shutil
from pathlib import Path

from cli import Case, flashbvh, refuse_each, ROOT, write
from inputs import images


def try_example(command):
    """A command's help ends in an example that works: it prints something or makes files, and the files that it names
    exist."""
    said = flashbvh(f"{command} --help")
    found = re.search(r"\n\nExample:\n  flashbvh (.*)  # (.+)\n\Z", said)
    assert found, f"no example: {said}"
    before = set(Path(".").rglob("*"))
    assert flashbvh(found[1]) or set(Path(".").rglob("*")) > before, f"prints and makes nothing: {found[1]}"
    for name in re.findall(r"\S+\.\w+", found[2]):
        assert Path(name).exists(), f"no {name}: {found[0]}"


class HelpTest(Case):
    def test_the_help_of_each_command_ends_with_an_example_which_works(self):
        for folder in "quick_start/plate.obj", "quick_start/peg.obj", "robot_guard/cell_arm/cell_arm.urdf":
            shutil.copy(ROOT / "firmware_examples" / folder, ".")
        Path("cell_arm.urdf").rename("arm.urdf")
        write("poses.txt", "1 0 0 0 1 0 0 0 1 0 0 -5\n1 0 0 0 1 0 0 0 1 0 0 5\n")
        write("points.txt", "0 0 -5\n0 0 5\n")
        write("rays.txt", "0 0 5 0 0 -5\n")
        write("motion.csv", "turn,shoulder,elbow,roll\n0,0,0,0\n0.01,0,0,0\n")
        try_example("")
        for name in re.findall(r"^  (\w+)  ", flashbvh("--help").split("Subcommands:")[1], re.M):
            with self.subTest(name):
                try_example(name)

    def test_a_mistyped_word_is_named_and_nothing_is_run(self):
        images()
        refuse_each("", {
            "bak": "bak; see flashbvh --help",
            "--vesion": "--vesion; see flashbvh --help",
            "bake meshes/ring.stl -o out --formt=c": "--formt=c; see flashbvh bake --help",
            "bake meshes/ring.stl -o out --format cc": "--format: cc not in {c,image,both}",
            "info -- post/ring.fbvh --josn": "not expected",
        })
