"""machines.py SHAPE: prints a body of a machine of the examples in OBJ, in millimetres.

    head gantry             of a printer, from the nozzle's tip on: what goes with it
    clamp vase wheel arch   on its bed, from the middle of their foot on
    tube weights            of an equatorial mount, from where its axes meet on: the polar axis is z, the
                            declination axis x, the tube points along z
    tripod                  under it, in the same frame, at a latitude of 48 degrees
"""
import sys
from math import copysign, cos, pi, radians, sin

from meshes import Mesh


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


def tube(mesh):
    """The tube, across the declination axis, 240 mm from the polar axis."""
    for profile in ([(z, 105, 105) for z in steps(-420, 520, 24)], [(z, 118, 118) for z in steps(490, 620, 4)],
                    [(z, 40, 40) for z in steps(-520, -410, 4)],  # the focuser
                    [(z, 45, 45) for z in steps(-640, -515, 4)]):  # the camera
        upright(mesh, profile, (240, 0))
    skin(mesh, [ring((x, 0, 0), (0, 45, 0), (0, 0, 45), 32) for x in steps(75, 150, 4)])  # the saddle


def weights(mesh):
    """The weights at the other end of the declination axis; they turn with the polar axis."""
    for begin, end, radius in (-330, -60, 12), (-320, -230, 65):
        skin(mesh, [ring((x, 0, 0), (0, radius, 0), (0, 0, radius), 40) for x in steps(begin, end, 8)])


def tripod(mesh):
    def placed(points):
        c, s = cos(radians(48)), sin(radians(48))
        return [(c * up - s * north, east, s * up + c * north) for east, north, up in points]

    # The pier under the polar axis, and three legs; one points north.
    skin(mesh, [placed(ring((0, 0, up), (60, 0, 0), (0, 60, 0))) for up in steps(-300, -110, 8)])
    for turn in 90, 210, 330:
        out = cos(radians(turn)), sin(radians(turn))
        legs = [(60 + 500 * i / 24, -190 - 780 * i / 24) for i in range(25)]
        skin(mesh, [placed(ring((r * out[0], r * out[1], up), (-28 * out[1], 28 * out[0], 0),
                                (-24 * out[0], -24 * out[1], -14), 32)) for r, up in reversed(legs)])


def main():
    shapes = {shape.__name__: shape for shape in (head, gantry, clamp, vase, wheel, arch, tube, weights, tripod)}
    if len(sys.argv) != 2 or sys.argv[1] not in shapes:
        sys.exit(__doc__)
    mesh = Mesh()
    shapes[sys.argv[1]](mesh)
    print("\n".join(mesh.lines))


if __name__ == "__main__":
    main()
