"""The program `flashbvh`, with which answers are compared, and inputs made by formulas: meshes, poses, a robot."""
import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy as np


def lines(*arguments, exits=(0,)):
    """The program's JSON objects, one per line."""
    done = subprocess.run([os.environ["FLASHBVH"], *map(str, arguments), "--json"], capture_output=True, text=True)
    if done.returncode not in exits:
        raise AssertionError(f"flashbvh {' '.join(map(str, arguments))}: {done.returncode}: {done.stderr}")
    return [json.loads(line) for line in done.stdout.splitlines()]


class Case(unittest.TestCase):
    """A test with a folder."""

    @classmethod
    def setUpClass(cls):
        made = tempfile.TemporaryDirectory(prefix="flashbvh_python_")
        cls.addClassCleanup(made.cleanup)
        cls.folder = Path(made.name)

    def refused(self, error, text, call, *arguments, **options):
        with self.subTest(text), self.assertRaisesRegex(error, text):
            call(*arguments, **options)


def write_rows(path, rows):
    path.write_text("".join(" ".join(map(repr, row)) + "\n" for row in rows.tolist()))
    return path


def box(x, y, z):
    """A box about the origin with sides 2x, 2y and 2z; 12 triangles that face outwards."""
    vertices = np.array([[x if i & 1 else -x, y if i & 2 else -y, z if i & 4 else -z] for i in range(8)], float)
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return vertices, np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])


def torus(around, across, ring, tube):
    """A torus about the z axis, of 2 * around * across triangles."""
    vertices = [[(ring + tube * np.cos(v)) * np.cos(u), (ring + tube * np.cos(v)) * np.sin(u), tube * np.sin(v)]
                for u in 2 * np.pi * np.arange(around) / around for v in 2 * np.pi * np.arange(across) / across]
    i, j = (grid.ravel() for grid in np.mgrid[:around, :across])
    a, b, c, d = ((i + m) % around * across + (j + n) % across for m, n in ((0, 0), (1, 0), (1, 1), (0, 1)))
    return np.array(vertices), np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])


def poses(count, reach):
    """(count, 4, 4): random rotations, translations within +-reach."""
    random = np.random.default_rng(1)
    made = np.tile(np.eye(4), (count, 1, 1))
    made[:, :3, :3] = np.linalg.qr(random.normal(size=(count, 3, 3)))[0]
    made[:, :3, 0] *= np.linalg.det(made[:, :3, :3])[:, None]
    made[:, :3, 3] = random.uniform(-reach, reach, (count, 3))
    return made


def translated(x, y, z):
    pose = np.eye(4)
    pose[:3, 3] = x, y, z
    return pose


def _link(name, size, at="0 0 0"):
    return (f'<link name="{name}"><collision><origin xyz="{at}"/><geometry><box size="{size}"/></geometry>'
            "</collision></link>")


def _joint(name, kind, parent, child, at, axis="0 1 0", limits=(0, 0), more=""):
    return (f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>'
            f'<origin xyz="{at}"/><axis xyz="{axis}"/><limit lower="{limits[0]}" upper="{limits[1]}" effort="1" '
            f'velocity="1"/>{more}</joint>')


# An arm of boxes on a column, whose forearm folds back; its fingers mimic each other.
ARM = "".join((
    '<robot name="arm">',
    _link("column", "0.2 0.2 0.1"), _link("upper", "0.4 0.05 0.05", "0.25 0 0"),
    _link("fore", "0.3 0.04 0.04", "0.2 0 0"), _link("left", "0.02 0.02 0.1"), _link("right", "0.02 0.02 0.1"),
    _joint("turn", "continuous", "column", "upper", "0 0 0.2", "0 0 1"),
    _joint("fold", "revolute", "upper", "fore", "0.5 0 0", limits=(-3, 3)),
    _joint("grip", "prismatic", "fore", "left", "0.4 0.1 0", limits=(-0.09, 0.1)),
    _joint("other", "prismatic", "fore", "right", "0.4 -0.1 0", limits=(-0.1, 0.09),
           more='<mimic joint="grip" multiplier="-1"/>'),
    "</robot>\n"))
