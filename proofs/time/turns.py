"""turns.py CUTS MACHINE PROGRAM

Follows the firmware of this folder instruction by instruction at the places where prove.py cut the loops, and fails if
an instruction executes more often than its table allows, in a call or in a run. CUTS: the file that it wrote.

Counting lasts from the call of a function of RUNS, or of bound_make_query, to that of bound_done. A number in the table
holds for each call; an open count holds for each run: the k-th execution of a function of RUNS is the k-th line "run".
"""
import os
import sys
from collections import Counter, defaultdict
from pathlib import Path

from check import run

LEAST = 1000
RUNS = "bound_run", "bound_run_itself"


def allowed_in(line):
    """run KIND WORK VISITS LEAF_PAIRS DEPTHS LEAF_SIZE INSTRUCTIONS: the largest count of each kind in this run. Two
    sides of a walk have two children per node, and the test of the last child finds no sibling."""
    _, _, work, visits, leaf_pairs, depths, leaf_size, *_ = line.split()
    work, visits, walks, depths = int(work), int(visits), int(leaf_pairs) + 1, int(depths)
    pairs, shapes = (work + 31) // 32, (work + 7) // 8 + 1
    turns = walks + shapes + min(visits, work // 2)
    visited = visits + 2 * walks + turns
    corners = 3 * int(leaf_size) * visited
    return {"visit": visited, "vertex": 2 * corners, "turn": turns, "sibling": 8 * walks,
            "row": pairs, "triangle": pairs, "other": 2 * (int(leaf_size) - 1) * shapes, "test": pairs + walks + 2,
            "ascent": depths + visits, "skipped": 2 * (depths + visits), "corner": 6 * pairs,
            "climb": depths + visits + turns}


class Cuts:
    """The places of cut loops: addresses as QEMU prints them, without leading zeros."""
    def __init__(self, lines):
        self.symbol, self.kind, self.limit, self.at_entry = {}, {}, {}, defaultdict(list)
        for what, at, *words in map(str.split, lines):
            if what == "symbol":
                self.symbol[at] = words[0]
            elif what == "cut":
                entry, self.kind[at], limit = words
                self.limit[at] = int(limit)
                self.at_entry[entry].append(at)

    def filter(self):
        """The addresses for QEMU's filter."""
        return ",".join(f"0x{at}+1" for at in sorted({*self.symbol, *self.kind, *self.at_entry}))


class Turns:
    def __init__(self, cuts, allowed):
        self.cuts, self.allowed = cuts, allowed
        self.traced, self.counts, self.failures = 0, False, 0
        self.in_call, self.most, self.in_run, self.all, self.all_allowed = (Counter() for _ in range(5))

    def over(self, what, count, most):
        print(f"executed {count} times, not at most {most}: {what}")
        self.failures += 1

    def end_run(self):
        of_run = self.allowed[self.traced - 1] if 0 < self.traced <= len(self.allowed) else {}
        for kind, count in self.in_run.items():
            most = of_run.get(kind, 0)
            if count > most:
                self.over(f"{kind} in run {self.traced}", count, most)
            self.all[kind] += count
            self.all_allowed[kind] += most
        self.in_run.clear()

    def execute(self, at):
        cuts = self.cuts
        if at in cuts.symbol:
            self.counts = cuts.symbol[at] != "bound_done"
            if cuts.symbol[at] in RUNS:
                self.end_run()
                self.traced += 1
        for inside in cuts.at_entry.get(at, ()):
            self.in_call[inside] = 0
        if self.counts and at in cuts.kind:
            self.in_call[at] += 1
            if cuts.limit[at] < 0:
                self.in_run[cuts.kind[at]] += 1
            elif self.in_call[at] > cuts.limit[at]:
                self.over(f"{cuts.kind[at]} at {at}", self.in_call[at], cuts.limit[at])
            self.most[at] = max(self.most[at], self.in_call[at])

    def follow(self, trace):
        """QEMU withdraws a block that it logged but did not execute."""
        last = ""
        for line in trace:
            if line.startswith("Trace"):
                self.execute(last)
                last = line.split("/")[1].lstrip("0")
            elif line.startswith("Stopped"):
                last = ""
        self.execute(last)
        self.end_run()

    def report(self):
        """Prints the counts; returns whether all are allowed."""
        lines = [f"{kind}: {count} in all runs, at most {self.all_allowed[kind]}"
                 for kind, count in self.all.items()]
        lines += [f"{self.cuts.kind[at]} at {at}: {self.most[at]} a call, at most {limit}"
                  for at, limit in self.cuts.limit.items() if limit >= 0]
        print("\n".join(sorted(lines)))
        if self.traced != len(self.allowed) or self.traced < LEAST:
            print(f"{self.traced} runs traced, {len(self.allowed)} measured")
            return False
        return not self.failures


def main(file, machine, program):
    cuts, trace = Cuts(Path(file).read_text().splitlines()), f"{file}.trace"
    try:
        # One instruction per block, and each block logged.
        text = run(machine, program, 240, f"-singlestep -d exec,nochain -dfilter {cuts.filter()} -D {trace}")
        turns = Turns(cuts, [allowed_in(line) for line in text.splitlines() if line.startswith("run ")])
        with open(trace) as lines:
            turns.follow(lines)
    finally:
        if os.path.exists(trace):
            os.remove(trace)
    sys.exit(not turns.report())


if __name__ == "__main__":
    main(*sys.argv[1:])
