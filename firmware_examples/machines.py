"""Bodies of the toolhead example, in millimetres: of a printer from the nozzle's tip on, on its bed from the middle of
their foot on."""
from math import copysign, cos, pi, sin


def ring(middle, u, v, around=48, power=2):
    """Points on a closed curve about `middle` through middle + u and middle + v: an ellipse for power 2; a larger
    power brings it nearer to a rectangle."""
    def part(x):
        return copysign(abs(x) ** (2 / power), x)

    turns = [2 * pi * i / around for i in range(around)]
    return [tuple(m + part(cos(t)) * a + part(sin(t)) * b for m, a, b in zip(middle, u, v)) for t in turns]


def skin(mesh, rings):
    """Connects rings, each counter-clockwise as seen from the next; a point closes each end."""
    around = len(rings[0])
    corners = [[mesh.corner(*point) for point in points] for points in rings]
    for low, high in zip(corners, corners[1:]):
        mesh.band(low, high)
    for points, end, order in (rings[0], corners[0], -1), (rings[-1], corners[-1], 1):
        middle = mesh.corner(*(sum(p[axis] for p in points) / around for axis in range(3)))
        for i in range(around):
            mesh.face(middle, *(end[i], end[(i + 1) % around])[::order])


def upright(mesh, profile, at=(0, 0), around=48, power=2):
    """Connects horizontal rings: (z, half width in x, half width in y)."""
    skin(mesh, [ring((*at, z), (x, 0, 0), (0, y, 0), around, power) for z, x, y in profile])


def steps(begin, end, count):
    return [begin + (end - begin) * i / count for i in range(count + 1)]


def bent(mesh, middle, radius, turns, widths, **how):
    """A tube along an arc in the plane of x and z: for each angle its half widths across the arc and along y."""
    rings = []
    for turn, (across, along) in zip(turns, widths):
        out = cos(turn), 0, sin(turn)
        rings.append(ring([m + radius * o for m, o in zip(middle, out)], [across * o for o in out],
                          (0, -along, 0), **how))
    skin(mesh, rings)


def head(mesh):
    upright(mesh, [(0, .4, .4), (2, 2.5, 2.5), (2.2, 4, 4), (5, 4, 4), (5.2, 3, 3), (8, 3, 3)])  # the nozzle
    upright(mesh, [(z, 8, 11) for z in steps(7.5, 19, 8)], (-3, 0), 64, 8)  # the heater block
    upright(mesh, [(z, 11 - i % 2 * 4, 11 - i % 2 * 4) for i, z in enumerate(steps(20, 48, 28))])  # the heat sink
    upright(mesh, [(z, 24, 20) for z in steps(48, 60, 4)], (0, 6), 64, 8)  # the carriage
    # The fan's duct leads down from the carriage and opens towards the nozzle; its wall is 1 mm thick.
    turns = steps(0, -pi / 2, 20)
    walls = [(4 - i * .075, 9 - i * .19) for i in range(21)]
    bent(mesh, (8, 0, 21.5), 16, turns + turns[:1:-1], walls + [(x - 1, y - 1) for x, y in walls[:1:-1]],
         around=32, power=6)
    upright(mesh, [(z, 4.5, 9.5) for z in steps(21, 49, 8)], (24, 0), 32, 6)


def gantry(mesh):
    """Two rods behind the head and a belt between them, along the whole bed."""
    for y, z, wide, high in (34, 42, 5, 5), (34, 66, 5, 5), (31, 54, 1, 3):
        skin(mesh, [ring((x, y, z), (0, wide, 0), (0, 0, high), 24) for x in steps(-140, 140, 14)])


def clamp(mesh):
    """A plate that holds down the bed's sheet, and its screw."""
    upright(mesh, [(z, 12, 7) for z in steps(0, 5, 2)], power=6)
    upright(mesh, [(4.5, 3, 3), (9, 3, 3), (9, 5, 5), (12, 5, 5)])


def vase(mesh):
    def radius(z):
        return 20 + 6 * sin(z / 16)
    heights = steps(0, 80, 24)
    upright(mesh, [(z, radius(z), radius(z)) for z in heights]
            + [(z, radius(z) - 1.2, radius(z) - 1.2) for z in heights[:0:-1]], around=64)


def wheel(mesh):
    """A wheel with twelve teeth."""
    def outline(z, part):
        return [(r * cos(t), r * sin(t), z) for i in range(96)
                for t, r in [(2 * pi * i / 96, part * (25 if i // 4 % 2 else 21))]]
    skin(mesh, [outline(z, part) for z, part in [(0, .97), *((z, 1) for z in steps(.6, 11.4, 6)), (12, .97)]])


def arch(mesh):
    """An arch that stands on both feet."""
    bent(mesh, (0, 0, 0), 28, steps(pi, 0, 44), [(5, 5)] * 45, around=32)


BODIES = head, gantry, clamp, vase, wheel, arch
