"""meshes.py SHAPE [SIZE...]: prints a mesh of the examples and of the figures in OBJ.

    torus AROUND ACROSS RING TUBE           about the z axis, 2 * AROUND * ACROSS triangles, on whole numbers
    sheet COLUMNS ROWS PITCH LEAN HEIGHT    square meshes, 2 * COLUMNS * ROWS triangles, diagonals that
                                            alternate; stands on one edge along y, HEIGHT above the origin,
                                            each column LEAN further along x
    room                                    5 x 4 x 2.5 m with a pillar, a table and shelves, in millimetres
    lump PARTS RADIUS                       a ball with bumps, 12 * PARTS^2 triangles, all well shaped
    gear TEETH RINGS RADIUS                 a spur gear with a bore, of well-shaped triangles
    head | gantry                           of a printer, what goes with its nozzle
    clamp | vase | wheel | arch             on its bed
"""
import sys
from math import copysign, cos, pi, sin, sqrt

from machines import BODIES


def nearest(value):
    """The nearest whole number; halves round away from zero."""
    return int(value + copysign(0.5, value))


class Mesh:
    def __init__(self):
        self.lines = []
        self.corners = 0

    def corner(self, *point):
        self.lines.append("v " + " ".join(x if isinstance(x, str) else f"{x:.6g}" for x in point))
        self.corners += 1
        return self.corners

    def face(self, *corners):
        self.lines.append("f " + " ".join(map(str, corners)))

    def quad(self, a, b, c, d):
        self.face(a, b, c)
        self.face(a, c, d)

    def band(self, low, high):
        """Connects two closed rings of corners, both counter-clockwise as seen from `high`."""
        for i in range(len(low)):
            j = (i + 1) % len(low)
            self.quad(low[i], low[j], high[j], high[i])


def torus(mesh, around, across, ring, tube):
    def corner(i, j):
        return i % around * across + j % across + 1

    places = [(i, j) for i in range(around) for j in range(across)]
    for i, j in places:
        radius = ring + tube * cos(2 * pi * j / across)
        mesh.corner(*map(nearest, (radius * cos(2 * pi * i / around), radius * sin(2 * pi * i / around),
                                   tube * sin(2 * pi * j / across))))
    for i, j in places:
        mesh.quad(corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1))


def sheet(mesh, columns, rows, pitch, lean, height):
    up = sqrt(pitch * pitch - lean * lean)
    for j in range(rows + 1):
        for i in range(columns + 1):
            mesh.corner(*(f"{x:.3f}" for x in (i * lean, (j - rows / 2) * pitch, height + i * up)))
    for j in range(rows):
        for i in range(columns):
            a = j * (columns + 1) + i + 1
            c = a + columns + 1
            if (i + j) % 2 == 0:
                mesh.face(a, a + 1, c)
                mesh.face(a + 1, c + 1, c)
            else:
                mesh.quad(a, a + 1, c + 1, c)


def room(mesh):
    """The walls are a box turned inside out: their triangles face inwards, the objects' outwards. So a sensor in
    the room sees only front faces. Winding numbers add up: -1 in the room's air, and 0 in the pillar. inside()
    finds the air, so no two parts overlap."""
    def block(x0, y0, z0, x1, y1, z1, inwards=False):
        a, b, c, d, e, f, g, h = (mesh.corner(x, y, z) for z in (z0, z1)
                                  for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1)))
        for side in (((a, b, c, d), (e, h, g, f), (a, e, f, b), (c, g, h, d), (d, h, e, a), (b, f, g, c))
                     if inwards else
                     ((a, d, c, b), (e, f, g, h), (a, b, f, e), (c, d, h, g), (d, a, e, h), (b, c, g, f))):
            mesh.quad(*side)

    def pillar(x, y, radius, height, around):
        low, high = [], []
        for i in range(around):
            turn = 2 * pi * i / around
            foot = nearest(x + radius * cos(turn)), nearest(y + radius * sin(turn))
            low.append(mesh.corner(*foot, 0))
            high.append(mesh.corner(*foot, height))
        mesh.band(low, high)
        for i in range(1, around - 1):
            mesh.face(low[0], low[i + 1], low[i])
            mesh.face(high[0], high[i], high[i + 1])

    block(0, 0, 0, 5000, 4000, 2500, inwards=True)
    pillar(3000, 1500, 200, 2500, 16)
    # The table: a top on four legs.
    block(3500, 2500, 700, 4700, 3300, 740)
    for x in 3540, 4600:
        for y in 2540, 3200:
            block(x, y, 0, x + 60, y + 60, 700)
    # Shelves between two boards, at the wall x = 0.
    block(0, 1000, 0, 350, 1020, 2000)
    block(0, 2180, 0, 350, 2200, 2000)
    for z in range(100, 2000, 450):
        block(0, 1020, z, 350, 2180, z + 20)


def lump(mesh, parts, radius):
    corners = {}

    def corner(*place):
        """A point of a cube's surface, `parts` to a side, projected to a ball with bumps."""
        if place not in corners:
            angles = [(2 * x / parts - 1) * pi / 4 for x in place]
            x, y, z = (sin(angle) / cos(angle) for angle in angles)
            length = sqrt(x * x + y * y + z * z)
            x, y, z = x / length, y / length, z / length
            bump = 1 + 0.2 * sin(3 * x + 2 * y) + 0.12 * sin(5 * y - 4 * z + 1) + 0.06 * sin(9 * z + 7 * x)
            corners[place] = mesh.corner(*(nearest(radius * bump * part) for part in (x, y, z)))
        return corners[place]

    for axis in range(3):
        for side in 0, parts:
            def on_face(i, j):
                place = [i, j]
                place.insert(axis, side)
                return corner(*place)
            for i in range(parts):
                for j in range(parts):
                    square = on_face(i, j), on_face(i + 1, j), on_face(i + 1, j + 1), on_face(i, j + 1)
                    # The triangles face outwards: the order of the axes is reversed for y.
                    mesh.quad(*(square if (side != 0) == (axis != 1) else reversed(square)))


def gear(mesh, teeth, rings, radius):
    """Both faces have rings from the bore to the teeth; the rims are as high as four rings are wide."""
    around, bore, height = 4 * teeth, 0.45 * radius, 0.3 * radius
    # The root of a tooth, its flanks and its tip.
    outer = [radius * (1 if i % 4 in (1, 2) else 0.86) for i in range(around)]
    layers = 4

    def ring(at, z):
        corners = []
        for i in range(around):
            r, turn = bore + (outer[i] - bore) * at / rings, 2 * pi * i / around
            corners.append(mesh.corner(nearest(r * cos(turn)), nearest(r * sin(turn)), nearest(z)))
        return corners

    low = [ring(at, 0) for at in range(rings + 1)]
    rims = [[ring(at, height * layer / layers) for layer in range(1, layers)] for at in (0, rings)]
    high = [ring(at, height) for at in range(rings + 1)]

    for at in range(rings):
        mesh.band(low[at], low[at + 1])
        mesh.band(high[at + 1], high[at])
    walls = [low[0], *rims[0], high[0]], [low[rings], *rims[1], high[rings]]
    for layer in range(layers):
        mesh.band(walls[0][layer + 1], walls[0][layer])
        mesh.band(walls[1][layer], walls[1][layer + 1])


def main():
    shapes = {"torus": (torus, 4), "sheet": (sheet, 5), "room": (room, 0), "lump": (lump, 2), "gear": (gear, 3),
              **{body.__name__: (body, 0) for body in BODIES}}
    shape, sizes = shapes.get(sys.argv[1] if len(sys.argv) > 1 else "", (None, 0))
    if not shape or len(sys.argv) != 2 + sizes:
        sys.exit(__doc__)
    mesh = Mesh()
    shape(mesh, *map(int, sys.argv[2:]))
    print("\n".join(mesh.lines))


if __name__ == "__main__":
    main()
