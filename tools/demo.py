"""demo.py COMMAND: parts of tools/demo.sh, on the files of build/demo.

    host FLASHBVH   writes the poses that the firmware printed in `target`, a file for each pair of links,
                    to poses/; runs `FLASHBVH collide` and writes its results to `host`, as lines of the
                    firmware (firmware_examples/robot_arm/main.cpp) up to the counts
    table           prints `target` as tables: a configuration each, then the traversals; compares each result
                    with `host`. Status 1 if one differs, if one side has another number of them, or if two
                    traversals of a pair find other triangles
    compact         status 1 unless the results of `ranked` in `target` and `target_compact` are the same
                    triangles for at most 1.3 times the instructions, and those of compact/table take at
                    most 20 bytes a triangle
    motion          prints a motion of the arm, a row for each millisecond
"""
import json
import re
import shutil
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

DEMO = Path("build/demo")
CHAIN = "base_link shoulder bicep elbow forearm wrist palm".split()
NEIGHBOURS = set(zip(CHAIN, CHAIN[1:]))
TRAVERSALS = "ranked stackless-post stackless leaf ranked-stack volume-stack alternating-stack".split()
COUNTS = "visits", "overlaps", "leaf_pairs", "triangle_pairs"
ROW = "{:<30} {:>7} {:>8} {:>6} {:>9} {:>12} {:>7} {:>5}  {}"


def lines(name, *kinds):
    """The words of each line; with `kinds`, only of lines that start with one of them."""
    for line in (DEMO / name).read_text().splitlines():
        words = line.split()
        if words and (not kinds or words[0] in kinds):
            yield words


def run(flashbvh, *arguments):
    return subprocess.run([flashbvh, *arguments], check=True, stdout=subprocess.PIPE, text=True).stdout


def host(flashbvh):
    cell = json.loads(run(flashbvh, "info", DEMO / "kr5/palm.fbvh", "--json"))["cell"]
    poses = defaultdict(list)
    for _, configuration, a, b, *numbers in lines("target", "pose"):
        entries = [int(number) / 2**30 for number in numbers[:9]]
        place = [(int(numbers[i]) + int(numbers[i + 3]) / 65536) * cell for i in (9, 10, 11)]
        poses[a, b].append((configuration, "".join(f"{x:.17g} " for x in entries + place)))
    shutil.rmtree(DEMO / "poses", ignore_errors=True)
    (DEMO / "poses").mkdir()
    results = []
    for (a, b), of_pair in sorted(poses.items()):
        file = DEMO / "poses" / f"{a}-{b}"
        file.write_text("".join(f"{pose}\n" for _, pose in of_pair))
        for traversal in TRAVERSALS:
            images = DEMO / ("kr5/pre" if traversal == "stackless" else "kr5")
            answers = run(flashbvh, "collide", images / f"{a}.fbvh", images / f"{b}.fbvh", "--poses", file,
                          "--algorithm", traversal, "--json").splitlines()
            for (configuration, _), answer in zip(of_pair, map(json.loads, answers)):
                counts = " ".join(str(answer[count]) for count in COUNTS)
                results.append(f"result {configuration} {a} {b} {traversal} {counts}\n")
    (DEMO / "host").write_text("".join(results))


def milliseconds(instructions):
    return instructions / 168000


def print_head():
    print(ROW.format("", "visits", "overlaps", "leaf", "triangle", "instructions", "ms", "stack", "same as"))
    print(ROW.format("", "", "", "pairs", "pairs", "", "", "bytes", "the host"))


def print_row(title, counts, instructions, stack, same):
    print(ROW.format("  " + title, *counts, instructions, f"{milliseconds(instructions):.2f}", stack,
                     "yes" if same else "DIFFERS"))


class Total:
    def __init__(self):
        self.counts, self.instructions, self.stack, self.same = [0] * 4, 0, 0, True

    def add(self, counts, instructions, stack, same):
        self.counts = [a + b for a, b in zip(self.counts, counts)]
        self.instructions += instructions
        self.stack = max(self.stack, stack)
        self.same &= same


class Configuration:
    """A table: for each pair the first traversal's row, and whether all traversals agree with the host."""
    def __init__(self, name, answer, check):
        self.name, self.answer, self.check, self.kinematics = name, answer, int(check), 0
        self.pairs = {}

    def add(self, pair, row, same):
        first, all_same = self.pairs.setdefault(pair, (row, True))
        same &= first[0][3] == row[0][3]
        self.pairs[pair] = first, all_same and same
        return same

    def print(self, angles):
        print(f"\n{self.name.replace('_', ' ')}: joints at {' '.join(angles)} degrees")
        print_head()
        disjoint = 0
        for (a, b), ((counts, instructions, stack), same) in self.pairs.items():
            # Pairs that are disjoint at the roots are only counted.
            if counts[0] == 1 and same:
                disjoint += 1
            else:
                print_row(f"{a} against {b}{' *' * ((a, b) in NEIGHBOURS)}", counts, instructions, stack, same)
        if disjoint:
            print(f"  {disjoint} pairs of links disjoint after one visit, on both")
        if NEIGHBOURS & self.pairs.keys():
            print("  * neighbours, which share a bearing: not tested")
        print(f"  Does it hit itself? {'YES' if self.answer == 'yes' else 'no'}: {self.check} instructions "
              f"for the answer, {milliseconds(self.check):.2f} ms, of these {self.kinematics} for the kinematics")


def table():
    print("\nLinks next to each other share a bearing: there they intersect in every configuration. Whether the\n"
          "arm hits itself is tested on the other pairs. Neighbours are shown once, at home, for what they cost.\n"
          "ms: at 168 MHz and one instruction a cycle; wait states of the flash come on top.")
    on_host = [tuple(words) for words in lines("host")]
    wanted = set(on_host)
    configurations, angles, totals, results = [], {}, defaultdict(Total), 0
    for kind, name, *words in lines("target", "arm", "answer", "kinematics", "result"):
        if kind == "arm":
            angles[name] = words
        elif kind == "answer":
            configurations.append(Configuration(name, *words))
        elif kind == "kinematics":
            configurations[-1].kinematics = int(words[0])
        else:
            a, b, traversal, *numbers = words
            *counts, stack, instructions = map(int, numbers)
            same = (kind, name, *words[:7]) in wanted
            same = configurations[-1].add((a, b), (counts, instructions, stack), same)
            totals[traversal].add(counts, instructions, stack, same)
            results += 1
    for configuration in configurations:
        configuration.print(angles[configuration.name])
    hits = sum(configuration.answer == "yes" for configuration in configurations)
    print(f"\n{hits} of {len(configurations)} configurations hit. All of their questions, by traversal:")
    print_head()
    for traversal, total in totals.items():
        print_row(traversal, total.counts, total.instructions, total.stack, total.same)
    print("Instructions: of whole queries, poses prepared and triangles tested. Stack: of a call of run().")
    if results != len(on_host):
        print(f"demo: {results} results of the board, {len(on_host)} of the host")
    return results > 0 and results == len(on_host) and all(total.same for total in totals.values())


def compact():
    def ranked(name):
        return {tuple(words[1:4]): (words[8], int(words[10]))
                for words in lines(name, "result") if words[4] == "ranked"}

    usual, smaller = ranked("target"), ranked("target_compact")
    instructions, before = (sum(cost for _, cost in of.values()) for of in (smaller, usual))
    print(f"All questions, by ranked: {instructions} instructions, {instructions / before:.2f} times those of "
          "two triangles a leaf.")
    good = instructions <= 1.3 * before
    if any(found != smaller[pair][0] for pair, (found, _) in usual.items()):
        print("The two trees found different triangles: DIFFERS")
        good = False
    for words in lines("compact/table"):
        if len(words) > 2 and re.fullmatch("[0-9.]+", words[2]) and float(words[2]) > 20:
            print(f"{words[0]}: more than 20 bytes a triangle")
            good = False
    return good


def motion():
    print("shoulder_yaw,shoulder_pitch,elbow_pitch,elbow_roll,wrist_pitch,wrist_roll")
    for t in (i / 1000 for i in range(1000)):
        s = t * t * (3 - 2 * t)
        print(f"0,0.3,{-2.5 - 1.14 * s:.6f},{-0.1 * s:.6f},0,0")


if __name__ == "__main__":
    commands = {"host": host, "table": table, "compact": compact, "motion": motion}
    if len(sys.argv) < 2 or sys.argv[1] not in commands:
        sys.exit(__doc__)
    sys.exit(commands[sys.argv[1]](*sys.argv[2:]) is False)
