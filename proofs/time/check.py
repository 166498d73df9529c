"""check.py BOUND MEASURED MACHINE PROGRAM

Runs the firmware of this folder under QEMU and compares its measurements with the bounds that prove.py wrote to BOUND.
Writes to MEASURED and to standard output, for each kind of run, the most instructions, this run's bound, and the largest
share of its own bound that a run of the kind used:
    measured NAME INSTRUCTIONS of BOUND, nearest PART
boxes-KIND-N: runs of work N without a pair of leaves; run-KIND-N: those with one. Fails if a run exceeds its bound.
"""
import os
import subprocess
import sys
from pathlib import Path

from shipped import proven_in

PORTS_RUN = Path(__file__).resolve().parents[2] / "ports/run"
LEAST = 1000


def run(machine, program, timeout, options=""):
    """The output of a firmware under QEMU; exits if it fails."""
    environment = {**os.environ, "FLASHBVH_TIMEOUT": str(timeout)}
    if options:
        environment["FLASHBVH_QEMU_OPTIONS"] = options
    done = subprocess.run([PORTS_RUN, machine, program], stdout=subprocess.PIPE, text=True, env=environment)
    if done.returncode:
        sys.exit(f"{Path(sys.argv[0]).name}: the firmware failed with status {done.returncode}")
    return done.stdout


def most_instructions(cost, depths, siblings, leaf_size, work):
    """Like flashbvh::most_instructions(). cost: the values of prove.py; leaf_size: of the larger leaves."""
    step = max(leaf_size + 8, 32)
    unit = cost["work"] + (siblings * cost["later-sibling"] + 31) // 32
    return (cost["start"] + depths * cost["ascent"] + siblings * cost["later-sibling"]
            + (leaf_size - 1) * cost["leaf-triangle"] + (work + step - 1) * unit)


def most_of_itself(cost, depths, siblings, leaf_size, work):
    """The bound for a mesh against itself; `depths` is twice its depth."""
    passed = (siblings + 1) * cost["later-sibling"]
    return (cost["start"] + depths * (cost["ascent"] + passed) + siblings * cost["later-sibling"]
            + (leaf_size - 1) * cost["leaf-triangle"] + (work + 31) * (cost["work"] + passed))


class Kind:
    def __init__(self):
        self.most, self.bound, self.nearest = 0, 0, 0.0

    def add(self, measured, bound):
        if measured > self.most:
            self.most, self.bound = measured, bound
        self.nearest = max(self.nearest, measured / bound)


def runs_in(lines, cost):
    """Name, instructions and bound of each run, and its line."""
    for line in lines:
        kind, *words = line.split() or [""]
        if kind == "run":
            of, (work, _, leaf_pairs, depths, leaf_size, measured) = words[0], map(int, words[1:7])
            formula = most_of_itself if of == "itself" else most_instructions
            # The trees are binary: each has one later sibling per level.
            yield (f"{'run' if leaf_pairs else 'boxes'}-{of}-{work}", measured,
                   formula(cost, depths, 2, leaf_size, work), line)
        elif kind == "make":
            yield "make-query", int(words[0]), cost["make-query"], line


def report(cost, lines):
    """The lines to print, and whether all runs keep their bounds."""
    kinds, over, held = {}, [], 0
    for name, measured, bound, line in runs_in(lines, cost):
        held += 1
        kinds.setdefault(name, Kind()).add(measured, bound)
        if measured > bound:
            over.append(f"OVER THE BOUND of {bound}: {line}")
    text = over + [f"measured {name} {kind.most} of {kind.bound}, nearest {kind.nearest:.2f}"
                   for name, kind in sorted(kinds.items())]
    if held < LEAST:
        return [*text, "too little was measured"], False
    return [*text, f"{held} measured, {len(over)} over the bound"], not over


def main(bound, measured, machine, program):
    if not Path(bound).exists():
        sys.exit(f"check.py: no bounds in {bound}: run the test that proves them first")
    (costs,) = proven_in(Path(bound).read_text()).values()
    cost = {name: int(value) for name, value in costs.items()}
    text, good = report(cost, run(machine, program, 120).splitlines())
    Path(measured).write_text("".join(f"{line}\n" for line in text))
    print("\n".join(text))
    sys.exit(not good)


if __name__ == "__main__":
    main(*sys.argv[1:])
