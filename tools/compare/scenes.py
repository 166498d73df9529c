"""scenes.py PROGRAM FOLDER: meshes of well-shaped triangles, and poses of pairs of them, for compare_firmware.

Makes the meshes, bakes them by PROGRAM, and finds by it the poses of each pair: from any direction B comes until it
touches A, then it moves on or back. Writes FOLDER/NAME.fbvh.c and FOLDER/scenes.cpp.
"""
import json
import math
import random
import subprocess
import sys
from pathlib import Path

POSES = 8  # of a pair, motion and class
CELL = "0.001"
TURN = 2 * math.pi


class Mesh:
    def __init__(self):
        self.vertices, self.triangles = [], []

    def grid(self, point, rows, columns, closes=(True, True)):
        """The surface point(u, v), u and v from 0 to 1, in quads; it closes along an axis or ends."""
        first, wide = len(self.vertices), columns + (not closes[1])
        self.vertices += [point(i / rows, j / columns) for i in range(rows + (not closes[0])) for j in range(wide)]
        high = rows + (not closes[0])

        def at(i, j):
            return first + i % high * wide + j % wide
        for i in range(rows):
            for j in range(columns):
                a, b, c, d = at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)
                self.triangles += [(a, b, c), (a, c, d)] if (i + j) % 2 else [(a, b, d), (b, c, d)]
        return self

    def text(self):
        lines = ["v %.6f %.6f %.6f" % v for v in self.vertices]
        lines += ["f %d %d %d" % tuple(i + 1 for i in t) for t in self.triangles]
        return "\n".join(lines) + "\n"


def ball(radius, bumps, rows):
    """A sphere with waves: six faces of a cube, so that no triangles are thin."""
    mesh = Mesh()
    for axis in range(3):
        for side in (1, -1):
            def point(u, v, axis=axis, side=side):
                p, q = math.tan((u - .5) * TURN / 4), math.tan((v - .5) * TURN / 4)
                to = [0, 0, 0]
                to[axis], to[(axis + 1) % 3], to[(axis + 2) % 3] = side, p * side, q
                size = math.sqrt(sum(x * x for x in to))
                x, y, z = (c / size for c in to)
                r = radius * (1 + bumps * math.sin(5 * x + 1) * math.sin(4 * y) * math.cos(6 * z))
                return r * x, r * y, r * z
            mesh.grid(point, rows, rows, (False, False))
    return mesh


def tube(middle, radius, around, across):
    """A tube round a closed curve."""
    def frame(u):
        p, q = middle(u), middle(u + 1e-4)
        along = [b - a for a, b in zip(p, q)]
        size = math.sqrt(sum(c * c for c in along))
        x, y, z = (c / size for c in along)
        side = (-y, x, 0) if x * x + y * y > .04 else (0, -z, y)
        size = math.sqrt(sum(c * c for c in side))
        side = [c / size for c in side]
        up = (y * side[2] - z * side[1], z * side[0] - x * side[2], x * side[1] - y * side[0])
        return p, side, up

    def point(u, v):
        p, side, up = frame(u)
        c, s = radius * math.cos(TURN * v), radius * math.sin(TURN * v)
        return tuple(p[i] + c * side[i] + s * up[i] for i in range(3))
    return Mesh().grid(point, around, across)


def knot(u):
    r = 5 + 2.5 * math.cos(3 * TURN * u)
    return r * math.cos(2 * TURN * u), r * math.sin(2 * TURN * u), 2.5 * math.sin(3 * TURN * u)


def ring(u):
    return 6 * math.cos(TURN * u), 6 * math.sin(TURN * u), 0


def terrain(u, v):
    return 20 * u - 10, 20 * v - 10, math.sin(9 * u) * math.cos(7 * v) + .5 * math.sin(23 * u + 11 * v)


def gear(teeth):
    """A cog with a hole: walls and faces in quads."""
    def radius(u):
        return 8 if math.cos(TURN * teeth * u) > 0 else 6.5

    def point(u, v):
        r, z = [(radius(u), -2), (radius(u), 2), (3, 2), (3, -2)][int(v * 4) % 4]
        part, (s, w) = v * 4 % 1, [(radius(u), 2), (3, 2), (3, -2), (radius(u), -2)][int(v * 4) % 4]
        r, z = r + (s - r) * part, z + (w - z) * part
        return r * math.cos(TURN * u), r * math.sin(TURN * u), z
    return Mesh().grid(point, 8 * teeth, 12)


MESHES = {"ball": ball(7, .12, 16), "shell": ball(7.6, .1, 14), "pebble": ball(2.5, .2, 9),
          "knot": tube(knot, .8, 120, 9), "ring": tube(ring, 2.2, 60, 18),
          "terrain": Mesh().grid(terrain, 32, 32, (False, False)), "gear": gear(16)}
# A, B, and whether B comes from inside A.
PAIRS = [("ball", "knot", False), ("knot", "knot", False), ("ring", "terrain", False), ("gear", "ring", False),
         ("gear", "gear", False), ("shell", "ball", True), ("terrain", "pebble", False), ("ball", "pebble", False)]
CLASSES = "separated", "close", "intersecting"


def rotation(w, x, y, z):
    s = 2 / (w * w + x * x + y * y + z * z)
    return [1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w),
            s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w),
            s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y)]


class Finder:
    """Queries of a pair in the poses of some directions at once."""

    def __init__(self, program, folder, pair, turned, draw):
        self.a, self.b, self.inside = pair
        self.program, self.folder = program, folder
        self.quaternions, self.directions = [], []
        for _ in range(POSES):
            self.quaternions.append([draw.randint(-9999, 9999) for _ in range(4)] if turned else [1, 0, 0, 0])
            to = [draw.gauss(0, 1) for _ in range(3)]
            size = math.sqrt(sum(c * c for c in to))
            self.directions.append([c / size for c in to])

    def cells(self, places):
        return [[round(c * place * 1000) for c in to] for to, place in zip(self.directions, places)]

    def query(self, places):
        lines = [" ".join(f"{x:.12f}" for x in [row for part in zip(*[iter(rotation(*q))] * 3) for row in part]
                          ) + " " + " ".join(f"{c / 1000:.3f}" for c in at)
                 for q, at in zip(self.quaternions, self.cells(places))]
        poses = self.folder / "poses.txt"
        poses.write_text("\n".join(lines) + "\n")
        out = subprocess.run([self.program, "collide", self.folder / f"{self.a}.fbvh", self.folder / f"{self.b}.fbvh",
                              "--poses", poses, "--json", "--first"], check=True, capture_output=True, text=True).stdout
        return [json.loads(line) for line in out.splitlines()]

    def touch(self):
        """How far B is from A's origin when it just does not touch it."""
        free, met = ([.0] * POSES, [3.0] * POSES) if self.inside else ([40.0] * POSES, [.0] * POSES)
        for start in range(40) if not self.inside else []:  # from the middle outwards, the last place that meets
            place = start * .5
            for i, answer in enumerate(self.query([place] * POSES)):
                if answer["triangle_pairs"]:
                    met[i] = place
        for _ in range(14):
            middle = [(f + m) / 2 for f, m in zip(free, met)]
            for i, answer in enumerate(self.query(middle)):
                (met if answer["triangle_pairs"] else free)[i] = middle[i]
        return free

    def apart(self, free, draw):
        """Where one visit, of the roots, decides: from just there to half as far again."""
        places = [f if not self.inside else 5.0 for f in free]
        for _ in range(100):
            answers = self.query(places)
            if all(answer["visits"] == 1 for answer in answers):
                break
            places = [p + (answer["visits"] > 1) * .3 for p, answer in zip(places, answers)]
        return [place * draw.uniform(1, 1.5) for place in places]

    def poses(self, draw):
        free = self.touch()
        back = -1 if self.inside else 1
        apart = self.apart(free, draw)
        close = [f + back * (.004 + .004 * i) for i, f in enumerate(free)]
        within = [f - back * (.1 + .25 * i) for i, f in enumerate(free)]
        return [self.cells(places) for places in (apart, close, within)]


def main(program, folder):
    folder.mkdir(parents=True, exist_ok=True)
    for name, mesh in MESHES.items():
        (folder / f"{name}.obj").write_text(mesh.text())
    subprocess.run([program, "bake", *(folder / f"{name}.obj" for name in MESHES), "--cell", CELL, "-o", folder],
                   check=True)
    draw = random.Random(1)
    poses = []
    for pair in PAIRS:
        for turned in (False, True):
            finder = Finder(program, folder, pair, turned, draw)
            for places in finder.poses(draw):
                poses += ["    {%s}," % ", ".join(map(str, q + at)) for q, at in zip(finder.quaternions, places)]
    (folder / "scenes.cpp").write_text(source(poses))


def source(poses):
    """The table of compare/scenes.hpp."""
    lines = ["// Written by scenes.py.", '#include "scenes.hpp"', "", '#include "flashbvh/image.hpp"']
    lines += [f'#include "{name}.fbvh.h"' for name in MESHES]
    lines += ["", "using flashbvh::Mesh;", "namespace compare {", "namespace {"]
    lines += [f"const Mesh {name} = flashbvh::view_unchecked<Mesh>({name}_image);" for name in MESHES]
    lines += ["}  // namespace", "const figures::LinkPair kScenes[] = {"]
    lines += [f'    {{"{a}", "{b}", &{a}, &{b}}},' for a, b, _ in PAIRS]
    lines += ["};", f"const uint32_t kSceneCount = {len(PAIRS)};", "const int32_t kScenePoses[][7] = {", *poses, "};"]
    return "\n".join(lines + ["}  // namespace compare"]) + "\n"


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], Path(sys.argv[2]))
