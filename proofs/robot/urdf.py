"""urdf.py NAME.robot FILE.urdf [--seed N]: compares a baked robot's tree, frames and limits with its URDF, by separate
kinematics: at random joint values, each link of the URDF must lie at its mount in the image. Exit status: 0
confirmed, 1 refused, 2 usage or unreadable."""
import argparse
import math
import random as randoms
import struct
import sys
import xml.etree.ElementTree as xml

from arms import Image

TURN = 2 * math.pi / (1 << 28)
PLACES = 100
# The error of rounding each frame: cells, and rotation entries, per joint on the path.
CELLS, ENTRY = 0.01, 1e-8


def product(p, q):
    """The product of two frames, (rows of the rotation, translation)."""
    (r, t), (s, u) = p, q
    return ([[sum(r[i][k] * s[k][j] for k in range(3)) for j in range(3)] for i in range(3)],
            [t[i] + sum(r[i][k] * u[k] for k in range(3)) for i in range(3)])


def turned(axis, angle):
    """A rotation, by Rodrigues' formula."""
    x, y, z = (a / math.sqrt(sum(b * b for b in axis)) for a in axis)
    c, s = math.cos(angle), math.sin(angle)
    return [[c + x * x * (1 - c), x * y * (1 - c) - z * s, x * z * (1 - c) + y * s],
            [y * x * (1 - c) + z * s, c + y * y * (1 - c), y * z * (1 - c) - x * s],
            [z * x * (1 - c) - y * s, z * y * (1 - c) + x * s, c + z * z * (1 - c)]]


NONE = ([[1, 0, 0], [0, 1, 0], [0, 0, 1]], [0, 0, 0])


def numbers(element, name, default):
    return [float(word) for word in (element.get(name, default) if element is not None else default).split()]


class Urdf:
    def __init__(self, path):
        root = xml.parse(path).getroot()
        self.links = [link.get("name") for link in root.findall("link")]
        self.joints = root.findall("joint")
        self.limits, self.mimics = {}, {}
        for joint in self.joints:
            name, mimic = joint.get("name"), joint.find("mimic")
            if joint.get("type") in ("revolute", "prismatic"):
                self.limits[name] = tuple(float(joint.find("limit").get(end, 0)) for end in ("lower", "upper"))
            if mimic is not None:
                self.mimics[name] = (mimic.get("joint"), float(mimic.get("multiplier", 1)), float(mimic.get("offset", 0)))

    def value(self, name, values):
        if name in self.mimics:
            master, multiplier, offset = self.mimics[name]
            return multiplier * self.value(master, values) + offset
        return values[name]

    def places(self, values):
        """The frames of all links in the root's frame, in metres."""
        children = {joint.find("child").get("link") for joint in self.joints}
        places = {name: NONE for name in self.links if name not in children}
        waiting = list(self.joints)
        while waiting:
            joint = next((j for j in waiting if j.find("parent").get("link") in places), None)
            if joint is None:
                raise ValueError("its joints form no tree")
            waiting.remove(joint)
            origin, axis = joint.find("origin"), numbers(joint.find("axis"), "xyz", "1 0 0")
            roll, pitch, yaw = numbers(origin, "rpy", "0 0 0")
            frame = (turned((0, 0, 1), yaw), numbers(origin, "xyz", "0 0 0"))
            for about, angle in (((0, 1, 0), pitch), ((1, 0, 0), roll)):
                frame = product(frame, (turned(about, angle), [0, 0, 0]))
            if joint.get("type") in ("revolute", "continuous"):
                frame = product(frame, (turned(axis, self.value(joint.get("name"), values)), [0, 0, 0]))
            elif joint.get("type") == "prismatic":
                size = math.sqrt(sum(a * a for a in axis))
                way = self.value(joint.get("name"), values) / size
                frame = product(frame, (NONE[0], [a * way for a in axis]))
            places[joint.find("child").get("link")] = product(places[joint.find("parent").get("link")], frame)
        return places


def fixed_frame(r, t):
    return ([[r[3 * i + j] / 2**30 for j in range(3)] for i in range(3)], [x / 2048 for x in t])


def image_places(image, coordinates):
    """The frames of the image's mounts in the base's frame, in cells."""
    frames = {255: NONE}
    for i, (row, coordinate) in enumerate(zip(image.joints, coordinates)):
        fixed = fixed_frame([row[f"r{k}"] for k in range(9)], [row[k] for k in "xyz"])
        moved = ((NONE[0], [0, 0, coordinate / 2048]) if row["type"] == 2 else
                 (turned((0, 0, 1), coordinate * TURN), [0, 0, 0]))
        frames[i] = product(product(frames[row["parent"]], fixed), moved)
    places = {}
    for name, mount in zip(image.mount_names, image.mounts):
        joint, *rest = struct.unpack("<B3x12i", mount["bytes"])
        places[name] = product(frames[joint], fixed_frame(rest[:9], rest[9:]))
    return places


def coordinate(row, value):
    return value if row["shift"] == 0 else ((value * row["multiplier"] + (1 << row["shift"] - 1)) >> row["shift"]) + row[
        "offset"]


def check_limits(image, urdf, cell):
    """The image allows no more than the URDF, up to 2^-22 of a radian or metre, or of a longer limit."""
    for name, row in zip(image.joint_names, image.joints):
        unit = cell / 2048 if row["type"] == 2 else TURN
        if name in urdf.limits and row["type"] != 1 and row["shift"] == 0:
            lower, upper = urdf.limits[name]
            if (lower - row["lower"] * unit > 2.0**-21.9 * max(1, abs(lower)) or
                    row["upper"] * unit - upper > 2.0**-21.9 * max(1, abs(upper))):
                yield (f"limits of joint {name}: {row['lower'] * unit} to {row['upper'] * unit}, but the URDF has {lower} to "
                       f"{upper}")
        elif (name in urdf.limits) != (row["type"] != 1) and row["shift"] == 0:
            yield f"limits of joint {name}: one of image and URDF has none"


def check_places(image, urdf, cell, random):
    """The largest error of a mount, or the first row whose error is too large."""
    for _ in range(PLACES):
        values = {}
        for name, row in zip(image.joint_names, image.joints):
            if row["shift"] == 0:
                low, high = (-(1 << 27), (1 << 27) - 1) if row["type"] == 1 else (row["lower"], row["upper"])
                values[row["variable"]] = (name, random.randint(low, high), cell / 2048 if row["type"] == 2 else TURN)
        coordinates = [coordinate(row, values[row["variable"]][1]) for row in image.joints]
        places = urdf.places({name: value * unit for name, value, unit in values.values()})
        for name, (r, t) in image_places(image, coordinates).items():
            if name not in places:
                yield f"mount {name}: no link of the URDF"
                return
            s, u = places[name]
            turn = max(abs(r[i][j] - s[i][j]) for i in range(3) for j in range(3))
            off = max(abs(t[i] - u[i] / cell) for i in range(3))
            far = sum(map(abs, t))
            joints = len(image.joints) + 1
            if turn > ENTRY * joints or off > (CELLS + far * ENTRY) * joints:
                yield f"mount {name}: {off:.4g} cells and {turn:.3g} of a rotation off where the URDF has the link"
                return


def refusals(image, urdf, seed=1):
    """The rows in which the image differs from the URDF."""
    cell = struct.unpack("<d", image.data[24:32])[0]
    return [*check_limits(image, urdf, cell), *check_places(image, urdf, cell, randoms.Random(seed))]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("robot")
    parser.add_argument("urdf")
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    try:
        with open(arguments.robot, "rb") as file:
            image = Image(file.read())
        urdf = Urdf(arguments.urdf)
    except (OSError, xml.ParseError, struct.error, ValueError, AttributeError) as error:
        print(f"urdf.py: {arguments.robot}, {arguments.urdf}: cannot be read: {error}", file=sys.stderr)
        sys.exit(2)
    refused = refusals(image, urdf, arguments.seed)
    print(*(f"refused: {row}" for row in refused), sep="\n", end="\n" if refused else "")
    if not refused:
        print(f"urdf: {len(image.joints)} joints' limits, {len(image.mount_names)} links' places at {PLACES} joint values, "
              f"seed {arguments.seed}")
    sys.exit(1 if refused else 0)


if __name__ == "__main__":
    main()
