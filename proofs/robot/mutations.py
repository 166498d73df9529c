"""mutations.py CHECKER FLASHBVH URDF [--count N] [--seed N]: bakes random arms and a URDF, which the checker must
confirm. Then changes one field of each in an unsafe or inconsistent way, with repaired checksums; the checker must
refuse each, by the name of the row. Prints the number of survivors."""
import argparse
import concurrent.futures
import itertools
import json
import math
import pathlib
import random as randoms
import re
import struct
import subprocess
import sys
import tempfile

from arms import Image, any_arm
from urdf import Urdf, refusals

ARMS = ["revolute prismatic mimic", "revolute revolute", "continuous revolute prismatic", "prismatic revolute revolute",
        "revolute continuous mimic", "continuous revolute"]
KINDS = []


def kind(function):
    KINDS.append(function)
    return function


class NoSuchRow(Exception):
    pass


def any_of(random, choices):
    if not choices:
        raise NoSuchRow
    return random.choice(choices)


def any_row(random, rows, wanted=lambda row: True):
    """The number of a random row among the wanted ones."""
    return any_of(random, [i for i in range(len(rows)) if wanted(rows[i])])


def change_reach(image, random, factor, slides=False):
    number, joint, link = any_of(random, [
        (image.links[link]["first"] + n, joint, link) for link in range(len(image.links))
        for n, joint in enumerate(image.branch(link)) if (image.joints[joint]["type"] == 2) == slides])
    image.reaches.set(number, value=int(image.reaches[number]["value"] * factor))
    image.repair_sums()
    return rf"reach of joint {image.joint_names[joint]}, link {image.name(link)}"


def pair_name(image, pair):
    return f"{image.name(pair['a'])} - {image.name(pair['b'])}"


@kind
def lower_a_reach(image, random, said):
    return change_reach(image, random, 0.93)


@kind
def raise_a_reach(image, random, said):
    return change_reach(image, random, 5)


@kind
def change_a_slides_reach(image, random, said):
    return change_reach(image, random, 0.5, slides=True)


@kind
def change_a_sum(image, random, said):
    i = any_row(random, image.pairs)
    image.pairs.set(i, reach=image.pairs[i]["reach"] - random.randrange(1, 1000))
    return "reach of pair " + pair_name(image, image.pairs[i])


@kind
def shrink_a_sphere(image, random, said):
    i = any_row(random, image.links)
    image.links.set(i, radius=int(image.links[i]["radius"] * 0.95))
    return f"sphere of link {image.name(i)}"


@kind
def move_a_sphere(image, random, said):
    i = any_row(random, image.links)
    image.links.set(i, z=image.links[i]["z"] + image.links[i]["radius"] // 4)
    return f"sphere of link {image.name(i)}"


@kind
def exchange_joints_between(image, random, said):
    i = any_row(random, image.pairs, lambda pair: pair["joints_a"] != pair["joints_b"])
    pair = image.pairs[i]
    image.pairs.set(i, joints_a=pair["joints_b"], joints_b=pair["joints_a"])
    return "joints of pair " + pair_name(image, pair)


@kind
def remove_a_pair(image, random, said):
    colliding = {(pair["a"], pair["b"]) for pair in said["pairs"] if pair["verdict"] == "can"}
    zones = {tuple(sorted((row["a"], row["b"]))) for row in map(image.unguarded.__getitem__, range(len(image.unguarded)))}
    i = any_row(random, image.pairs, lambda pair: (image.link_names[pair["a"]], image.link_names[pair["b"]]) in colliding
                and (pair["a"], pair["b"]) not in zones and image.whole_of(pair["a"]) == pair["a"]
                and image.whole_of(pair["b"]) == pair["b"])
    name = pair_name(image, image.pairs[i])
    image.remove_pair(i)
    return f"pair {name}, in no array"


@kind
def exchange_a_pairs_links(image, random, said):
    i = any_row(random, image.pairs)
    pair = image.pairs[i]
    image.pairs.set(i, a=pair["b"], b=pair["a"])
    return "pair " + pair_name(image, image.pairs[i])


@kind
def warn_nearer_than_stop(image, random, said):
    i = any_row(random, image.pairs, lambda pair: pair["stop"] > 0)
    image.pairs.set(i, warn=image.pairs[i]["stop"] - 1)
    return "distances of pair " + pair_name(image, image.pairs[i])


@kind
def lower_the_slack(image, random, said):
    image.header.set(0, slack=image.header[0]["slack"] - random.randrange(8, 100))
    return "slack"


@kind
def raise_a_table_byte(image, random, said):
    i = any_row(random, image.tables, lambda row: 0 < row["byte"] < 200)
    image.tables.set(i, byte=image.tables[i]["byte"] + 40)
    for pair in map(image.pairs.__getitem__, range(len(image.pairs))):
        if i < image.table_size(pair):
            return f"table of {pair_name(image, pair)}, byte {i}:"
        i -= image.table_size(pair)


@kind
def shrink_a_zone(image, random, said):
    i = any_row(random, image.unguarded, lambda row: row["why"] == 0)
    image.unguarded.set(i, radius=int(image.unguarded[i]["radius"] * 0.6))
    return "zone of " + pair_name(image, image.unguarded[i])


@kind
def widen_a_limit(image, random, said):
    """Widens a slide beyond a turning joint, or a joint with a mimic: reaches or tables no longer hold."""
    joints = [image.joints[i] for i in range(len(image.joints))]
    i = any_row(random, image.joints, lambda row: row["shift"] == 0 and row["type"] != 1 and (
        any(other["shift"] and other["variable"] == row["variable"] for other in joints) or
        row["type"] == 2 and row["parent"] != 255 and joints[row["parent"]]["type"] != 2))
    image.joints.set(i, lower=joints[i]["lower"] * 4, upper=joints[i]["upper"] * 4)
    return rf"limits of joint|reach of joint|distance tables.*{image.joint_names[i]}|table of"


@kind
def move_a_joint(image, random, said):
    """Moves a joint farther from the axis of the joint that carries it."""
    def is_far(row):
        return row["parent"] != 255 and image.joints[row["parent"]]["type"] != 2 and math.hypot(row["x"], row["y"]) > 1 << 21
    i = any_row(random, image.joints, is_far)
    row = image.joints[i]
    image.joints.set(i, x=row["x"] * 3, y=row["y"] * 3)
    return rf"reach of joint {image.joint_names[row['parent']]}, link|slack"


@kind
def bend_a_frame(image, random, said):
    i = any_row(random, image.joints)
    image.joints.set(i, r1=image.joints[i]["r1"] + random.choice([-1, 1]) * 100000)
    return f"frame of joint {image.joint_names[i]}"


@kind
def lower_a_deviation(image, random, said):
    i = any_row(random, image.links)
    image.links.set(i, deviation=image.links[i]["deviation"] // 2)
    return f"deviation of link {image.name(i)}"


@kind
def move_a_vertex(image, random, said):
    link = any_row(random, image.links)
    _, (vertices, count), _ = image.mesh(link)
    at = vertices + 6 * random.randrange(count) + 2 * random.randrange(3)
    value = struct.unpack_from("<h", image.data, at)[0]
    struct.pack_into("<h", image.data, at, max(-16383, min(16383, value + (9000 if value > 0 else -9000))))
    return f"(sphere|mesh) of link {image.name(link)}"


@kind
def shrink_a_box(image, random, said):
    link = any_row(random, image.links)
    (nodes, count), _, _ = image.mesh(link)
    at = nodes + 16 * random.randrange(count) + 2 * random.randrange(6)
    struct.pack_into("<H", image.data, at, max(1, struct.unpack_from("<H", image.data, at)[0] - 200))
    return f"mesh of link {image.name(link)}"


@kind
def change_first_reach(image, random, said):
    i = any_row(random, image.links, lambda row: row["first"] > 0)
    image.links.set(i, first=image.links[i]["first"] - 1)
    return f"first_reach of link {image.name(i)}"


@kind
def change_a_mimic(image, random, said):
    i = any_row(random, image.joints, lambda row: row["shift"] > 0)
    image.joints.set(i, multiplier=image.joints[i]["multiplier"] // 2)
    return f"limits of joint {image.joint_names[i]}"


@kind
def name_another_joint_of_a_zone(image, random, said):
    i = any_row(random, image.unguarded, lambda row: row["why"] == 0)
    image.unguarded.set(i, joint=(image.unguarded[i]["joint"] + 1) % len(image.joints))
    return "unguarded pair " + pair_name(image, image.unguarded[i])


@kind
def hang_a_link_elsewhere(image, random, said):
    i = any_row(random, image.links, lambda row: row["joint"] not in (0, 255))
    image.links.set(i, joint=image.links[i]["joint"] - 1)
    return "first_reach of link|reaches: "


class Checked:
    def __init__(self, checker, path, *options):
        run = subprocess.run([checker, path, "--first", *options], capture_output=True, text=True, errors="replace")
        self.status, self.text = run.returncode, run.stdout + run.stderr


def bake(flashbvh, urdf, folder):
    run = subprocess.run([flashbvh, "robot", urdf, "-o", folder, "--stop", "0.002", "--warn", "0.01", "--format", "image",
                          "--json", "--name", urdf.stem], capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(f"{urdf}: {run.stderr}")
    return json.loads(run.stdout), (folder / f"{urdf.stem}.robot").read_bytes()


def judged(checker, path, expected):
    """None if this row refuses it; else a description of the result."""
    checked = Checked(checker, path)
    named = re.search(rf"refused: .*({expected})", checked.text)
    return None if checked.status == 1 and named else f"exit {checked.status}, expected {expected}: {checked.text}"


def check_exits(checker, path, folder):
    """Checks the exit status: 2 for damaged files, 3 for rows without boxes or time."""
    data = path.read_bytes()
    damaged = folder / "damaged.robot"
    for wrong, what in ((data[:-4], "size"), (data[:60] + b"\xaa" + data[61:], "checksum"), (data[:30], "size"),
                        (b"", "ends"), (b"FBVH" + data[4:], "no robot")):
        damaged.write_bytes(wrong)
        checked = Checked(checker, damaged)
        if checked.status != 2 or what not in checked.text or "byte " not in checked.text:
            sys.exit(f"damaged, {what}: exit {checked.status}, {checked.text}")
    statuses = [Checked(checker, path, "--boxes", "0").status, Checked(checker, path, "--boxes", "-1").status,
                Checked(checker, folder / "none.robot").status]
    if statuses != [3, 2, 2]:
        sys.exit(f"without boxes, with -1 and without a file: exits {statuses}, not 3, 2 and 2")
    late = Checked(checker, path, "--time", "0")
    if late.status != 3 or "in no array: after 1 boxes" not in late.text:
        sys.exit(f"without time: exit {late.status}, {late.text}")


def check_urdf(path, data):
    """urdf.py confirms it, but not with a joint a cell farther, nor with a wider limit."""
    image, urdf = Image(data), Urdf(path)
    before = refusals(image, urdf)
    last = len(image.joints) - 1
    row = image.joints[last]
    image.joints.set(last, x=row["x"] + 2048)
    moved = refusals(image, urdf)
    image.joints.set(last, **row)
    limited = any_row(randoms, image.joints, lambda row: row["type"] != 1 and row["shift"] == 0)
    image.joints.set(limited, upper=image.joints[limited]["upper"] + 2000)
    wider = refusals(image, urdf)
    if before or not moved or not any(f"limits of joint {image.joint_names[limited]}" in row for row in wider):
        sys.exit(f"urdf.py of {path}: {before}, of a joint moved {moved}, of a limit widened {wider}")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("checker")
    parser.add_argument("flashbvh")
    parser.add_argument("urdf", type=pathlib.Path)
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    random = randoms.Random(arguments.seed)
    with tempfile.TemporaryDirectory() as name, concurrent.futures.ThreadPoolExecutor() as pool:
        folder = pathlib.Path(name)
        urdfs = [arguments.urdf] + [folder / f"arm{i}.urdf" for i in range(len(ARMS))]
        for urdf, joints in zip(urdfs[1:], ARMS):
            urdf.write_text(any_arm(random, joints.split()))
        baked = list(pool.map(lambda urdf: bake(arguments.flashbvh, urdf, folder), urdfs))
        for urdf, checked in zip(urdfs, pool.map(lambda urdf: Checked(arguments.checker, folder / f"{urdf.stem}.robot"),
                                                 urdfs)):
            if checked.status != 0:
                sys.exit(f"seed {arguments.seed}: {urdf} is not confirmed: exit {checked.status}\n{checked.text}")
            check_urdf(urdf, (folder / f"{urdf.stem}.robot").read_bytes())
        check_exits(arguments.checker, folder / f"{arguments.urdf.stem}.robot", folder)
        made = []
        for change in itertools.islice(itertools.cycle(KINDS), 10 * arguments.count):
            said, data = random.choice(baked)
            image = Image(data)
            try:
                expected = change(image, random, said)
            except NoSuchRow:
                continue
            if bytes(image.data) != data and len(made) < arguments.count:
                path = folder / f"{len(made)}.robot"
                path.write_bytes(image.repaired())
                made.append((change.__name__, path, expected))
        results = list(pool.map(lambda made: judged(arguments.checker, *made[1:]), made))
    survivors = [(name, result) for (name, _, _), result in zip(made, results) if result is not None]
    for name, result in survivors:
        print(f"{name}: {result}")
    print(f"{len(urdfs)} robots confirmed; {len(survivors)} of {len(made)} mutations of {len({name for name, _, _ in made})} kinds survive, "
          f"seed {arguments.seed}")
    sys.exit(1 if survivors or len(made) < arguments.count else 0)


if __name__ == "__main__":
    main()
