"""What tests of the host program share: they run it in a folder of their own and hold what it says.

From the environment: FLASHBVH, the program; TOOLS, the folder of the tests' own programs; WORK; INCLUDE; CXX
and NM; FLASHBVH_THOROUGH, with which all is tested, however long it takes.
"""
import json
import os
import random
import re
import shutil
import subprocess
import sys
from pathlib import Path

import poses

FLASHBVH, TOOLS = os.environ["FLASHBVH"], Path(os.environ["TOOLS"])
HERE = Path(__file__).resolve().parent
THOROUGH = bool(os.environ.get("FLASHBVH_THOROUGH"))
HOME = "1 0 0 0 1 0 0 0 1"  # not rotated


class Failed(Exception):
    pass


def hold(good, otherwise):
    if not good:
        raise Failed(otherwise)


class Said(str):
    """What the program printed; `warnings` is what it wrote to standard error."""
    warnings = ""

    def json(self):
        return [json.loads(line) for line in self.splitlines()]

    def holds(self, *patterns):
        for pattern in patterns:
            hold(re.search(pattern, self, re.M), f"no '{pattern}' in: {self}")


def run(*command, code=0, **options):
    command = list(map(str, command))
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **options)
    hold(done.returncode == code, f"exit {done.returncode}, not {code}: {command} ({done.stderr})")
    said = Said(done.stdout)
    said.warnings = done.stderr
    return said


def flashbvh(*arguments, **options):
    return run(FLASHBVH, *arguments, **options)


def refused(what, *arguments):
    """The program must exit with 2 and one line on standard error that holds `what`, print nothing else, and
    leave no folder or file named out*. Returns the line."""
    said = flashbvh(*arguments, code=2)
    hold(said.warnings.count("\n") == 1, f"not one line: {arguments} ({said.warnings})")
    hold(not said, f"output on stdout: {arguments}")
    hold(said.warnings.startswith("flashbvh: "), said.warnings)
    hold(what in said.warnings, f"no '{what}' in: {said.warnings}")
    hold(not any(Path(".").rglob("out*")), f"something written: {arguments}")
    return said.warnings


def same(a, b, otherwise=""):
    hold(Path(a).read_bytes() == Path(b).read_bytes(), f"{a} and {b} differ {otherwise}")


def write(file, text):
    """A file of these lines."""
    Path(file).write_text(text if not text or text.endswith("\n") else text + "\n")
    return file


def any_poses(count, seed, reach):
    return "\n".join(poses.any_poses(count, random.Random(seed), reach))


def vertices(file):
    """Of a mesh in OBJ."""
    return [tuple(map(float, line.split()[1:])) for line in Path(file).read_text().splitlines()
            if line.startswith("v ")]


def edit_vertices(source, target, change):
    """A mesh in OBJ, with words of each vertex changed."""
    lines = (line.split() for line in Path(source).read_text().splitlines())
    write(target, "\n".join(" ".join(["v", *map(str, change(*words[1:]))] if words[0] == "v" else words)
                            for words in lines if words[0] in ("v", "f")))


def box(x=0, y=0, z=0, size=1, first=0):
    """A box in OBJ from its lower corner; `first`: how many vertices come before."""
    corners = [(x + size * (i % 2), y + size * (i // 2 % 2), z + size * (i // 4)) for i in range(8)]
    faces = "1342", "5687", "1265", "3784", "1573", "2486"
    return "".join([*("v {:g} {:g} {:g}\n".format(*corner) for corner in corners),
                    *("f " + " ".join(str(first + int(c)) for c in face) + "\n" for face in faces)])


def main(*modules):
    """Runs the test named on the command line, a function of one of the modules."""
    work = Path(os.environ["WORK"])
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    os.chdir(work)
    run(TOOLS / "tool_test_meshes", "meshes")
    test = next(getattr(module, sys.argv[1]) for module in modules if hasattr(module, sys.argv[1]))
    try:
        test()
    except Failed as failure:
        sys.exit(f"FAILED: {failure}")
