"""The program `flashbvh`, with which the package's answers are compared."""
import json
import os
import subprocess
import tempfile
from pathlib import Path

FLASHBVH = os.environ["FLASHBVH"]


def completed(arguments, exits):
    done = subprocess.run([FLASHBVH, *map(str, arguments)], capture_output=True, text=True)
    if done.returncode not in exits:
        raise AssertionError(f"flashbvh {' '.join(map(str, arguments))}: {done.returncode}: {done.stderr}")
    return done


def run(*arguments, exits=(0,)):
    """Returns its output; the exit code must be one of `exits`."""
    return completed(arguments, exits).stdout


def lines(*arguments, exits=(0,)):
    """Its JSON objects, one per line."""
    return [json.loads(line) for line in run(*arguments, "--json", exits=exits).splitlines()]


def message(*arguments):
    """Returns its error message; the program must refuse."""
    return completed(arguments, (2,)).stderr.strip().removeprefix("flashbvh: ")


def folder(add_cleanup):
    """A folder that is removed at the end. `add_cleanup`: of a test or of its class."""
    made = tempfile.TemporaryDirectory(prefix="flashbvh_python_")
    add_cleanup(made.cleanup)
    return Path(made.name)


def write_obj(path, vertices, triangles):
    path.write_text("".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in vertices.tolist()) +
                    "".join(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in triangles.tolist()))


def write_poses(path, poses):
    path.write_text("".join(" ".join(map(repr, pose[:3, :3].ravel().tolist() + pose[:3, 3].tolist())) + "\n"
                            for pose in poses))
