"""The program's help texts with their examples."""
import re
import shlex
import shutil
from pathlib import Path

from checks import ROOT, flashbvh, hold

def names():
    return re.findall(r"^  (\w+)  ", flashbvh("--help").split("Subcommands:")[1], re.M)


def files_here():
    return set(Path(".").rglob("*"))


def try_example(*command):
    """A command's help ends in an example that works: it prints something or makes files, and the files that it names
    exist."""
    text = flashbvh(*command, "--help")
    found = re.search(r"\n\nExample:\n  flashbvh (.*)  # (.+)\n\Z", text)
    hold(found, f"no example: {text}")
    before = files_here()
    said = flashbvh(*shlex.split(found[1]))
    hold(said or files_here() > before, f"prints and makes nothing: {found[1]}")
    for name in re.findall(r"\S+\.\w+", found[2]):
        hold(Path(name).exists(), f"no {name}: {found[0]}")


def try_examples():
    for folder in "quick_start/plate.obj", "quick_start/peg.obj", "robot_guard/cell_arm/cell_arm.urdf":
        shutil.copy(ROOT / "firmware_examples" / folder, ".")
    Path("cell_arm.urdf").rename("arm.urdf")
    Path("poses.txt").write_text("1 0 0 0 1 0 0 0 1 0 0 -5\n1 0 0 0 1 0 0 0 1 0 0 5\n")
    Path("points.txt").write_text("0 0 -5\n0 0 5\n")
    Path("rays.txt").write_text("0 0 5 0 0 -5\n")
    Path("motion.csv").write_text("turn,shoulder,elbow,roll\n0,0,0,0\n0.01,0,0,0\n")
    try_example()
    for name in names():
        try_example(name)

