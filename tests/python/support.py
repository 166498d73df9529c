"""The program `flashbvh`, with which answers are compared, and inputs made by formulas: meshes, poses, a robot."""
import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

sys.path.append(str(Path(__file__).parents[1] / "cli"))
import inputs


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


ARM = f'<robot name="arm">{"".join(inputs.ARM)}</robot>\n'
