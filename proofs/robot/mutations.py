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
KINDS = {}


def kind(function):
    KINDS[function.__name__] = function
    return function


class NoSuchRow(Exception):
    pass


def any_of(random, choices):
    if not choices:
        raise NoSuchRow
    return random.choice(choices)


def any_row(random, rows, wanted=lambda row: True):
    """The number of a random row among the wanted ones."""
    return any_of(random, [i for i, row in enumerate(rows) if wanted(row)])


def pair_name(image, pair):
    return f"{image.name(pair['a'])} - {image.name(pair['b'])}"


def row_kind(name, array, refused, fields, wanted=lambda row: True):
    """A kind that changes fields of one row; `refused`: the refusal, with the row's name."""
    def change(image, random, said):
        rows = getattr(image, array)
        i = any_row(random, rows, wanted)
        rows.set(i, **fields(rows[i], random))
        named = {"links": image.name, "joints": image.joint_names.__getitem__, "header": lambda i: ""}
        return refused.format(named.get(array, lambda i: pair_name(image, rows[i]))(i))

    KINDS[name] = change


def reach_kind(name, factor, slides=False):
    """A kind that changes the reach of a joint that slides or turns."""
    def change(image, random, said):
        number, joint, link = any_of(random, [
            (image.links[link]["first"] + n, joint, link) for link in range(len(image.links))
            for n, joint in enumerate(image.branch(link)) if (image.joints[joint]["type"] == 2) == slides])
        image.reaches.set(number, value=int(image.reaches[number]["value"] * factor))
        image.repair_sums()
        return rf"reach of joint {image.joint_names[joint]}, link {image.name(link)}"

    KINDS[name] = change


reach_kind("lower_a_reach", 0.93)
reach_kind("raise_a_reach", 5)
reach_kind("change_a_slides_reach", 0.5, slides=True)
row_kind("change_a_sum", "pairs", "reach of pair {}",
         lambda row, random: {"reach": row["reach"] - random.randrange(1, 1000)})
row_kind("shrink_a_sphere", "links", "sphere of link {}", lambda row, _: {"radius": int(row["radius"] * 0.95)})
row_kind("move_a_sphere", "links", "sphere of link {}", lambda row, _: {"z": row["z"] + row["radius"] // 4})
row_kind("exchange_joints_between", "pairs", "joints of pair {}",
         lambda row, _: {"joints_a": row["joints_b"], "joints_b": row["joints_a"]},
         lambda row: row["joints_a"] != row["joints_b"])
row_kind("exchange_a_pairs_links", "pairs", "pair {}", lambda row, _: {"a": row["b"], "b": row["a"]})
row_kind("warn_nearer_than_stop", "pairs", "distances of pair {}", lambda row, _: {"warn": row["stop"] - 1},
         lambda row: row["stop"] > 0)
row_kind("lower_the_slack", "header", "slack", lambda row, random: {"slack": row["slack"] - random.randrange(8, 100)})
row_kind("shrink_a_zone", "unguarded", "zone of {}", lambda row, _: {"radius": int(row["radius"] * 0.6)},
         lambda row: row["why"] == 0)
row_kind("bend_a_frame", "joints", "frame of joint {}",
         lambda row, random: {"r1": row["r1"] + random.choice([-1, 1]) * 100000})
row_kind("lower_a_deviation", "links", "deviation of link {}", lambda row, _: {"deviation": row["deviation"] // 2})
row_kind("change_first_reach", "links", "first_reach of link {}", lambda row, _: {"first": row["first"] - 1},
         lambda row: row["first"] > 0)
row_kind("change_a_mimic", "joints", "limits of joint {}", lambda row, _: {"multiplier": row["multiplier"] // 2},
         lambda row: row["shift"] > 0)
row_kind("hang_a_link_elsewhere", "links", "first_reach of link|reaches: ", lambda row, _: {"joint": row["joint"] - 1},
         lambda row: row["joint"] not in (0, 255))


@kind
def remove_a_pair(image, random, said):
    colliding = {(pair["a"], pair["b"]) for pair in said["pairs"] if pair["verdict"] == "can"}
    zones = {tuple(sorted((row["a"], row["b"]))) for row in image.unguarded}
    i = any_row(random, image.pairs, lambda pair: (image.link_names[pair["a"]], image.link_names[pair["b"]]) in colliding
                and (pair["a"], pair["b"]) not in zones and image.whole_of(pair["a"]) == pair["a"]
                and image.whole_of(pair["b"]) == pair["b"])
    name = pair_name(image, image.pairs[i])
    image.remove_pair(i)
    return f"pair {name}, in no array"


@kind
def raise_a_table_byte(image, random, said):
    i = any_row(random, image.tables, lambda row: 0 < row["byte"] < 200)
    image.tables.set(i, byte=image.tables[i]["byte"] + 40)
    for pair in image.pairs:
        if i < image.table_size(pair):
            return f"table of {pair_name(image, pair)}, byte {i}:"
        i -= image.table_size(pair)


@kind
def widen_a_limit(image, random, said):
    """Widens a slide beyond a turning joint, or a joint with a mimic: reaches or tables no longer hold."""
    joints = list(image.joints)
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
def move_a_vertex(image, random, said):
    link = any_row(random, image.links)
    *_, (vertices, count) = image.mesh(link)
    at = vertices + 6 * random.randrange(count) + 2 * random.randrange(3)
    value = struct.unpack_from("<h", image.data, at)[0]
    struct.pack_into("<h", image.data, at, max(-16383, min(16383, value + (9000 if value > 0 else -9000))))
    return f"(sphere|mesh) of link {image.name(link)}"


@kind
def shrink_a_box(image, random, said):
    link = any_row(random, image.links)
    (nodes, count), *_ = image.mesh(link)
    at = nodes + 16 * random.randrange(count) + 2 * random.randrange(6)
    struct.pack_into("<H", image.data, at, max(1, struct.unpack_from("<H", image.data, at)[0] - 200))
    return f"mesh of link {image.name(link)}"


@kind
def name_another_joint_of_a_zone(image, random, said):
    i = any_row(random, image.unguarded, lambda row: row["why"] == 0)
    image.unguarded.set(i, joint=(image.unguarded[i]["joint"] + 1) % len(image.joints))
    return "unguarded pair " + pair_name(image, image.unguarded[i])


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
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor() as pool:
        folder = pathlib.Path(folder)
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
        for name in itertools.islice(itertools.cycle(KINDS), 10 * arguments.count):
            said, data = random.choice(baked)
            image = Image(data)
            try:
                expected = KINDS[name](image, random, said)
            except NoSuchRow:
                continue
            if bytes(image.data) != data and len(made) < arguments.count:
                path = folder / f"{len(made)}.robot"
                path.write_bytes(image.repaired())
                made.append((name, path, expected))
        results = list(pool.map(lambda made: judged(arguments.checker, *made[1:]), made))
    survivors = [(name, result) for (name, _, _), result in zip(made, results) if result is not None]
    for name, result in survivors:
        print(f"{name}: {result}")
    print(f"{len(urdfs)} robots confirmed; {len(survivors)} of {len(made)} mutations of {len({name for name, _, _ in made})} kinds survive, "
          f"seed {arguments.seed}")
    sys.exit(1 if survivors or len(made) < arguments.count else 0)


if __name__ == "__main__":
    main()
