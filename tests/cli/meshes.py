"""The meshes of the command line's tests."""
import struct
from math import cos, pi, sin
from pathlib import Path


def on_torus(i, j, rings, sides):
    u, v = 2 * pi * (i % rings) / rings, 2 * pi * (j % sides) / sides
    r = 20 + 6 * cos(v)
    return r * cos(u), r * sin(u), 6 * sin(v)


def torus(rings, sides):
    points = [[on_torus(i, j, rings, sides) for j in range(sides + 1)] for i in range(rings + 1)]
    for here, there in zip(points, points[1:]):
        for j in range(sides):
            yield here[j], there[j], there[j + 1]
            yield here[j], there[j + 1], here[j + 1]


def loose(count):
    """Triangles with three own vertices each."""
    for i in range(count):
        x, y = i % 200, i // 200
        yield (x, y, 0), (x + 0.5, y, 0), (x, y + 0.5, 0)


def tetrahedron(odd=10):
    """A tetrahedron; `odd` replaces one coordinate of one corner."""
    o, x, y, z = (0, 0, 0), (10, 0, 0), (0, 10, 0), (0, 0, 10)
    return (o, y, x), (o, z, y), (o, (odd, 0, 0), z), (x, y, z)


def write_stls(folder, **meshes):
    """Writes a file of each of these lists of triangles."""
    Path(folder).mkdir(parents=True, exist_ok=True)
    for name, triangles in meshes.items():
        records = [struct.pack("<12x9f2x", *(x for corner in triangle for x in corner)) for triangle in triangles]
        header = b"solid".ljust(80, b"s")  # as some programs write it
        Path(folder, f"{name}.stl").write_bytes(header + struct.pack("<I", len(records)) + b"".join(records))
