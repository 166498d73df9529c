"""figures.py COMMAND: the figures of lib/docs/figures.md.

    run OUTPUT PROGRAM...    runs the programs of the figures, by the command in RUN if they are firmware, and
                             writes what they print (report.hpp) to OUTPUT, lines `CORE NAME VALUE`; the core
                             is `all` for what all cores and this machine must agree about. Fails if a program
                             does
    compare RESULTS...       compares measured figures with figures.txt, of which the page was made; lists those
                             that differ by more than 2 %, either way, and counts that differ at all, and fails
    merge RESULTS...         puts the measured figures into figures.txt
    measure MODE URDF NATIVE [PRESET...]    see tools/figures.sh
    page [--check]           writes lib/docs/*.md of pages/*.md and figures.txt; --check fails if that would
                             change them
"""
import difflib
import os
import re
import subprocess
import sys
from pathlib import Path

import measuring
from page import Missing, page_of

HERE = Path(__file__).resolve().parent
DATA = HERE / "figures.txt"
ROOT = HERE.parents[1]
PAGES = ROOT / "lib/docs"
SHIPPED = ROOT / "proofs/time/shipped.py"
COSTS = ROOT / "lib/include/flashbvh/detail/walk/run_costs.hpp"
SLACK = 2  # percent


class Refused(Exception):
    pass


def figures_in(*files):
    """Core and name, and the value as text."""
    for file in files:
        for line in Path(file).read_text().splitlines():
            words = line.split()
            if len(words) != 3 or not re.fullmatch(r"-?[0-9.]+", words[2]):
                raise Refused(f"not a figure: {file}: {line}")
            yield (words[0], words[1]), words[2]


def read(*files):
    """The figures by core and name; the first of a name counts."""
    figures = {}
    for figure, value in figures_in(*files):
        figures.setdefault(figure, value)
    return figures


def group_of(figure):
    """The first word of a name (kr5, tori, stack, ...). Groups come from programs of their own, which not
    every build has; of a group that was measured nothing may be missing."""
    core, name = figure
    return core, name.split(".")[0]


def merged(old, new):
    """The data with each group that was measured replaced. Cores stay in the order in which they came,
    figures too."""
    measured = set(map(group_of, new))
    kept = {figure: value for figure, value in old.items() if group_of(figure) not in measured}
    order = dict.fromkeys([*old, *new])
    cores, names = (list(dict.fromkeys(figure[i] for figure in order)) for i in (0, 1))
    values = {**kept, **new}
    return {(core, name): values[core, name] for core in cores for name in names if (core, name) in values}


def difference(core, now, was):
    """Why a measured figure is not the documented one, if it is not."""
    if was is None:
        return f"{now}, and not documented: run tools/figures.sh"
    if core == "all":
        return float(now) != float(was) and f"{now}, on the page {was}: every core has to count the same"
    if float(now) * 100 > float(was) * (100 + SLACK):
        return f"{now}, more than {SLACK} % above the {was} on the page"
    if float(now) * 100 < float(was) * (100 - SLACK):
        return f"{now}, better than documented, {was}: run tools/figures.sh"
    return ""


def compare(documented, files):
    """Prints what differs; whether nothing does."""
    failures, compared, measured = 0, 0, set()
    for (core, name), value in figures_in(*files):
        compared += 1
        measured.add((core, name))
        why = difference(core, value, documented.get((core, name)))
        if why:
            print(f"{core} {name}: {why}")
            failures += 1
    groups = set(map(group_of, measured))
    for figure in documented:
        if group_of(figure) in groups and figure not in measured:
            print(f"{' '.join(figure)}: on the page, and was not measured")
            failures += 1
    if not compared:
        print("figures.py: nothing was measured")
        return False
    print(f"figures: {compared} compared, {failures} differ")
    return not failures


def write(figures):
    DATA.write_text("".join(f"{core} {name} {value}\n" for (core, name), value in figures.items()))


def pages(check):
    """Writes the pages, or prints how they differ; whether none does."""
    good = True
    figures, parts = read(DATA), (HERE / "parts.txt").read_text()
    for source in sorted((HERE / "pages").glob("*.md")):
        page = PAGES / source.name
        new, old = page_of(figures, parts, source.read_text()), page.read_text() if page.exists() else ""
        if not check:
            page.write_text(new)
        elif new != old:
            sys.stdout.writelines(difflib.unified_diff(
                old.splitlines(True), new.splitlines(True), f"lib/docs/{page.name}", "of the data", n=0))
            print(f"figures.py: lib/docs/{page.name} is not what the data give: run tools/figures.sh",
                  file=sys.stderr)
            good = False
    return good


def figures_of(text):
    """The figures in what a program of the figures printed."""
    core = ""
    for words in map(str.split, text.splitlines()):
        if words[:1] == ["core"]:
            core = words[1]
        elif words[:1] in (["figure"], ["count"]):
            yield core if words[0] == "figure" else "all", words[1], words[2]


def run(output, *programs):
    output = Path(output)
    output.unlink(missing_ok=True)
    lines = []
    for program in programs:
        done = subprocess.run([*os.environ.get("RUN", "").split(), program], stdout=subprocess.PIPE, text=True,
                              env={"FLASHBVH_TIMEOUT": "240", **os.environ})
        if done.returncode:
            print(done.stdout, end="")
            sys.exit(f"figures.py: {program} ended with status {done.returncode}")
        lines += [f"{' '.join(figure)}\n" for figure in figures_of(done.stdout)]
    output.write_text("".join(lines))
    print("".join(lines), end="")


def measure(mode, urdf, native, *presets):
    robot = measuring.Robot(Path(urdf).resolve(), native)
    if mode in ("prepare", "trees"):
        robot.prepare(for_boards_alone=mode == "prepare")
        return robot.trees(*presets or ("cortex-m4f",)) if mode == "trees" else print(measuring.FOLDER)
    presets = presets or ("native", *measuring.boards())
    if mode != "compare":
        robot.prepare(for_boards_alone=False)
        for preset in presets:
            robot.measure(preset)
    files = list(map(measuring.gather, presets))
    if mode == "write":
        write(merged(read(DATA), read(*files)))
        pages(check=False)
        subprocess.run([sys.executable, "-B", SHIPPED, DATA, COSTS, "--write"], check=True)
    # After writing, too: two boards may have one core.
    good = True
    for file in files:
        print(file)
        good &= compare(read(DATA), [file])
    return pages(check=True) and good


def main(command="", *arguments):
    try:
        if command == "run" and len(arguments) > 1:
            return run(*arguments)
        if command == "compare" and arguments:
            return compare(read(DATA), arguments)
        if command == "merge" and arguments:
            return write(merged(read(DATA), read(*arguments)))
        if command == "measure" and len(arguments) > 2:
            return measure(*arguments)
        if command == "page" and arguments in ((), ("--check",)):
            return pages(check=bool(arguments))
    except (OSError, Refused, Missing) as why:
        sys.exit(f"figures.py: {why}")
    sys.exit(__doc__)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]) is False)
