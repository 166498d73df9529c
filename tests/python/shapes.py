"""Meshes and poses of the tests, made by formulas."""
import numpy as np


def box(x, y, z):
    """A box about the origin with sides 2x, 2y and 2z; 12 triangles that face outwards."""
    vertices = np.array([[x if i & 1 else -x, y if i & 2 else -y, z if i & 4 else -z] for i in range(8)], float)
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return vertices, np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])


def torus(around, across, ring, tube):
    """A torus about the z axis, of 2 * around * across triangles."""
    vertices = [[(ring + tube * np.cos(v)) * np.cos(u), (ring + tube * np.cos(v)) * np.sin(u), tube * np.sin(v)]
                for u in 2 * np.pi * np.arange(around) / around for v in 2 * np.pi * np.arange(across) / across]

    def corner(i, j):
        return i % around * across + j % across

    triangles = [t for i in range(around) for j in range(across) for t in (
        (corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)), (corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)))]
    return np.array(vertices), np.array(triangles)


def poses(count, reach, seed=1):
    """(count, 4, 4): random rotations, translations within +-reach."""
    random = np.random.default_rng(seed)
    made = np.tile(np.eye(4), (count, 1, 1))
    quaternions = random.normal(size=(count, 4))
    w, x, y, z = (quaternions / np.linalg.norm(quaternions, axis=1, keepdims=True)).T
    made[:, :3, :3] = np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]).transpose(2, 0, 1)
    made[:, :3, 3] = random.uniform(-reach, reach, (count, 3))
    return made


def translated(x, y, z):
    pose = np.eye(4)
    pose[:3, 3] = x, y, z
    return pose
