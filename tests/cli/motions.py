"""Certified motions of two bodies, against the two bodies at poses along the motion."""
import random
from math import cos, hypot, radians, sin

from checks import any_poses, at, flashbvh, hold, poses_of, rotation, write

IMAGES = "post/ring.fbvh", "post/coarse.fbvh"
CELL = 0.01


def moved(start, moves, share):
    """A body's pose at a share of its motion, as 12 numbers: the last move acts first."""
    r, t = start[:9], start[9:]
    for *point, u, v, w, degrees, x, y, z in reversed(moves):
        half = radians(degrees * share) / 2
        length = hypot(u, v, w)
        turn = rotation(cos(half), *(sin(half) * along / length for along in (u, v, w)))
        r = [sum(turn[3 * i + k] * r[3 * k + j] for k in range(3)) for i in range(3) for j in range(3)]
        t = [point[i] + sum(turn[3 * i + j] * (t[j] - point[j]) for j in range(3)) + share * travel
             for i, travel in enumerate((x, y, z))]
    return [*r, *t]


def line(values):
    return " ".join(f"{value:.17g}" for value in values)


def any_moves(any_of, start, number):
    """Moves past the ring's middle: one about the body's own origin, or two about random axes."""
    def numbers(reach):
        return [any_of.uniform(-reach, reach) for _ in range(3)]
    travel = [any_of.uniform(-25, 25) - 1.5 * along for along in start[9:]]
    first = [*start[9:], *numbers(1), any_of.uniform(-170, 170), *travel]
    return [first] if number % 2 else [first, [*numbers(30), *numbers(1), any_of.uniform(-300, 300), *numbers(30)]]


def free_before(start, moves, share):
    """No earlier pose has an intersection, even when rounded to the lattice, since the bodies keep a cell apart."""
    write("poses", "\n".join(line(moved(start, moves, share * i / 60)) for i in range(60)))
    hold(not any(at(flashbvh("collide", *IMAGES, "--poses", "poses", "--json").json(), "*.intersects")), moves)


def check_motion(start, moves, way):
    """Checks the outcome of a motion that keeps a cell's distance, and the reported details."""
    command = "motion", *IMAGES, "--from", line(start), *way, "--json"
    kept = flashbvh(*command, "--within", CELL, code=(0, 1)).json()[0]
    if kept["outcome"] == "free":
        hold(flashbvh(*command).json()[0]["outcome"] == "free", "a larger distance is free")
        free_before(start, moves, 1)
        return "free"
    if kept["from"] == 0:
        return "at once"
    free_before(start, moves, kept["from"])
    found = flashbvh(*command, "--all", code=(0, 1)).json()[-1]
    if found["outcome"] == "contact":
        hold(kept["from"] <= found["to"], f"{kept}, {found}")
        for share, pose in (found["from"], found["from_pose"]), (found["to"], found["to_pose"]):
            off = max(abs(p - q) for p, q in zip(pose, moved(start, moves, share)))
            hold(off < CELL / 16, f"{pose} is off by {off}")
        write("there", line(found["to_pose"]))
        hold(flashbvh("collide", *IMAGES, "--poses", "there", "--json").json()[0]["intersects"], found)
    return found["outcome"]


def certified(count):
    any_of, seen = random.Random(7), {"free": 0, "contact": 0, "at once": 0}
    for number, start in enumerate(poses_of(any_poses(count, 8, 90))):
        moves = any_moves(any_of, start, number)
        write("moves", "\n".join(map(line, moves)))
        outcome = check_motion(start, moves, ("--moves", "moves"))
        seen[outcome] += 1
        if len(moves) == 1:
            to = line(moved(start, moves, 1))
            hold(check_motion(start, moves, ("--to", to)) == outcome, "by its ends as by its move")
    hold(min(seen["free"], seen["contact"]) >= count / 6, seen)
