"""results.py COMMAND: the results of the firmware benchmark.

    run OUTPUT MACHINE IMAGE...     runs the images one after the other under QEMU; what they print goes to
                                    OUTPUT and to standard output. Fails if one of them does
    budget RESULTS FIGURE LIMIT     prints a figure and its budget; fails if it is not kept. FIGURE is one of
        per-visit=NAME      instructions of algorithm NAME per visit, over the setups of more than ten visits
        of-volume-stack     instructions of `ranked` as part of those of `volume-stack`, in each setup of
                            more than ten visits
        of-ranked-stack     instructions of `ranked` as part of those of `ranked-stack`, over these setups
        separated           instructions of a whole query on separated objects: one visit
    tables [RESULTS...]             prints Markdown, the cores side by side; RESULTS: one file a core, by default
                                    those of the builds of cortex-m0, cortex-m3 and cortex-m4f. Fails if the
                                    cores' counts of iterations or overlaps differ
"""
import os
import shlex
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tests/figures"))
from markdown import table  # noqa: E402


class Setup:
    def __init__(self, line):
        self.name, self.table, self.title = line["setup"], int(line["table"]), line["title"]
        self.faces, self.geometry_overlaps = "", ""
        self.counts = {}   # of an algorithm: visits, overlaps, leaf overlaps
        self.walks = {}    # instructions by core and algorithm
        self.queries = {}  # the same of whole queries
        self.separated = {}  # by core: of a query of one visit

    def is_measured(self):
        return bool(self.counts)

    def visits(self, algorithm="ranked"):
        return self.counts[algorithm][0] if algorithm in self.counts else 0


class Results:
    def __init__(self, files):
        self.cores, self.setups, self.left_out = [], {}, {}
        self.algorithms, self.known, self.differ = [], {}, False
        for file in files:
            if not file.exists():
                sys.exit(f"results.py: no results in {file}: run the benchmark first")
            self.read(file)
        self.setups = [setup for _, setup in sorted(self.setups.items())]
        self.measured = [setup for setup in self.setups if setup.is_measured()]

    def read(self, file):
        core = ""
        for line in file.read_text().splitlines():
            kind, _, rest = line.partition(" ")
            if kind == "core":
                core = rest.strip()
                self.cores += [core] if core not in self.cores else []
            elif kind in ("row", "query", "left_out"):
                fields = dict(word.split("=", 1) for word in shlex.split(rest))
                setup = self.setups.setdefault(int(fields["number"]), Setup(fields))
                getattr(self, "add_" + kind)(core, setup, fields)

    def add_left_out(self, core, setup, _):
        self.left_out.setdefault(core, []).append(f"- table {setup.table}, {setup.name}")

    def add_row(self, core, setup, fields):
        algorithm = fields["algorithm"]
        self.algorithms += [algorithm] if algorithm not in self.algorithms else []
        setup.faces = f"{fields['faces_a']} and {fields['faces_b']} faces"
        counts = tuple(int(fields[name]) for name in ("visits", "overlaps", "leaf_overlaps"))
        setup.counts[algorithm] = counts
        setup.walks[core, algorithm] = int(fields["instructions"])
        self.hold("row", setup, algorithm, counts)

    def add_query(self, core, setup, fields):
        algorithm, visits = fields["algorithm"], int(fields["visits"])
        setup.geometry_overlaps = int(fields["geometry_overlaps"])
        setup.queries[core, algorithm] = int(fields["instructions"])
        if algorithm == "ranked" and visits == 1:
            setup.separated[core] = setup.queries[core, algorithm]
        self.hold("query", setup, algorithm, (visits, setup.geometry_overlaps))

    def hold(self, kind, setup, algorithm, counts):
        """The cores have to agree."""
        if self.known.setdefault((kind, setup, algorithm), counts) != counts:
            print(f"results.py: the cores differ: {setup.name}, {algorithm}", file=sys.stderr)
            self.differ = True

    def counting(self, core):
        """The setups of more than ten iterations that the core has."""
        return [setup for setup in self.measured if setup.visits() > 10 and (core, "ranked") in setup.walks]

    def instructions(self, core, algorithm):
        return sum(setup.walks.get((core, algorithm), 0) for setup in self.counting(core))

    def iterations(self, core, algorithm):
        return sum(setup.visits(algorithm) for setup in self.counting(core))


def core_cells(instructions, iterations, volume):
    if not instructions:
        return ["-"] * 3
    return [instructions, f"{instructions / iterations:.1f}", f"{instructions / volume:.3f}"]


def core_heads(results):
    return [head for core in results.cores for head in (core, "per iteration", "of volume-stack")]


def setup_lines(results, setup):
    yield f"**{setup.name}** ({setup.faces}, {setup.geometry_overlaps} geometry overlaps; instructions)\n"
    rows = [["algorithm", "iterations", "overlaps", "leaf overlaps", *core_heads(results)]]
    for algorithm in results.algorithms:
        rows.append([algorithm, *setup.counts[algorithm]])
        for core in results.cores:
            walk, volume = (setup.walks.get((core, of), 0) for of in (algorithm, "volume-stack"))
            rows[-1] += core_cells(walk, setup.visits(algorithm), volume)
    yield from table(rows)


def total_lines(results):
    yield "### All setups of more than ten iterations: boxes\n"
    rows = [["instructions", *core_heads(results)]]
    for algorithm in results.algorithms:
        rows.append([algorithm])
        for core in results.cores:
            rows[-1] += core_cells(results.instructions(core, algorithm), results.iterations(core, algorithm),
                                   results.instructions(core, "volume-stack"))
    yield from table(rows)
    rows = [["instructions of ranked", "of ranked-stack's, in total", "of volume-stack's, at most", "in"]]
    for core in results.cores:
        parts = [(setup.walks[core, "ranked"] / setup.walks[core, "volume-stack"], -i, setup.name)
                 for i, setup in enumerate(results.counting(core))]
        if parts:
            worst, _, where = max(parts)
            total = results.instructions(core, "ranked") / results.instructions(core, "ranked-stack")
            rows.append([core, f"{total:.3f}", f"{worst:.3f}", where])
    yield from table(rows)


def query_lines(results):
    yield "### Whole queries, triangles and all\n"
    rows = [["instructions", "iterations of ranked", "leaf overlaps", "geometry overlaps",
             *(head for core in results.cores for head in (f"{core}, volume-stack", "ranked", "ranked / volume"))]]
    for setup in results.measured:
        row = [f"table {setup.table}, {setup.name}", setup.visits(), setup.counts["ranked"][2],
               setup.geometry_overlaps]
        for core in results.cores:
            volume, ranked = (setup.queries.get((core, of)) for of in ("volume-stack", "ranked"))
            row += [volume or "-", ranked or "-", f"{ranked / volume:.3f}" if ranked else "-"]
        rows.append(row)
    yield from table(rows)


def lines(results):
    last = None
    for setup in results.measured:
        if setup.table != last:
            yield f"### Table {setup.table}: {setup.title}\n"
        last = setup.table
        yield from setup_lines(results, setup)
    yield from total_lines(results)
    yield from query_lines(results)
    for core in results.cores:
        if core in results.left_out:
            yield "\n".join([f"Too large for the flash of the board with {core}:\n", *results.left_out[core], ""])


def tables(*files):
    files = files or (f"{ROOT}/build/{board}/benchmark.txt" for board in ("cortex-m0", "cortex-m3", "cortex-m4f"))
    results = Results(list(map(Path, files)))
    print("\n".join(lines(results)))
    return not results.differ


def figures_of(results, figure):
    """What, the value, its digits, and whether it has to be below the limit."""
    core = results.cores[0] if results.cores else ""
    ranked = results.instructions(core, "ranked")
    if figure.startswith("per-visit="):
        algorithm = figure.partition("=")[2]
        if results.iterations(core, algorithm):
            yield (f"instructions of {algorithm} per visit",
                   results.instructions(core, algorithm) / results.iterations(core, algorithm), 2, False)
    elif figure == "of-ranked-stack" and ranked:
        yield ("instructions of ranked as part of ranked-stack's",
               ranked / results.instructions(core, "ranked-stack"), 4, False)
    elif figure == "of-volume-stack":
        for setup in results.counting(core):
            yield setup.name, setup.walks[core, "ranked"] / setup.walks[core, "volume-stack"], 3, True
    elif figure == "separated":
        for setup in results.setups:
            if core in setup.separated:
                yield setup.name, setup.separated[core], 0, False


def budget(file, figure, limit):
    kept = []
    for what, value, digits, strict in figures_of(Results([Path(file)]), figure):
        kept.append(value < float(limit) if strict else value <= float(limit))
        print(f"{what}: {value:.{digits}f}, budget: {'below' if strict else 'at most'} {limit}"
              f"{'' if kept[-1] else ': NOT KEPT'}")
    if not kept:
        print(f"no such figure in the results: {figure}")
    return bool(kept) and all(kept)


def run(output, machine, *images):
    Path(output).unlink(missing_ok=True)
    texts = []
    for image in images:
        done = subprocess.run([ROOT / "ports/run", machine, image], stdout=subprocess.PIPE, text=True,
                              errors="replace",
                              env={"FLASHBVH_ICOUNT": "8", "FLASHBVH_TIMEOUT": "240", **os.environ})
        print(done.stdout, end="", flush=True)
        if done.returncode:
            sys.exit(f"results.py: {image} ended with status {done.returncode}")
        texts.append(done.stdout)
    Path(output).write_text("".join(texts))


def main(command="", *arguments):
    if command == "run" and len(arguments) > 2:
        return run(*arguments)
    if command == "budget" and len(arguments) == 3:
        return budget(*arguments)
    if command == "tables":
        return tables(*arguments)
    return sys.exit(__doc__)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]) is False)
