"""figures.py COMMAND: the costs of queries on each core.

    run OUTPUT PROGRAM...     runs measuring programs, by the command in RUN if they are firmware, and writes their
                              output (results.py) to OUTPUT. Fails if a program does
    hold OUTPUT...            compares those OUTPUTs of programs that exist with budgets.csv; lists figures that
                              differ by more than 2 %, either way, and counts that differ at all, and fails if
                              there are any
    pages [--check]           writes the tables of README.md and lib/docs/*.md that show budgets.csv (pages.py);
                              --check fails if this would change them
    measure MODE URDF NATIVE [PRESET...]    see tools/figures.sh
"""
import difflib
import os
import subprocess
import sys
from pathlib import Path

import pages
from robot import BUILD, FOLDER, ROOT, Robot, boards, quietly
from results import ALL, BUDGETS, Refused, budgets, measured_in

DOCS = ROOT / "lib/docs"
SHIPPED = ROOT / "proofs/time/shipped.py"
COSTS = ROOT / "lib/include/flashbvh/plain"
# The measuring tests: the figures, the memory (proofs/stack) and the bounds (proofs/time).
TESTS = "figures: .* measured|memory, and both stacks|bound: no run takes more"


def run(output, *programs):
    output = Path(output)
    output.parent.mkdir(parents=True, exist_ok=True)
    output.unlink(missing_ok=True)
    texts = []
    for program in programs:
        done = subprocess.run([*os.environ.get("RUN", "").split(), program], stdout=subprocess.PIPE, text=True,
                              errors="replace", env={"FLASHBVH_TIMEOUT": "240", **os.environ})
        print(done.stdout, end="", flush=True)
        if done.returncode:
            sys.exit(f"figures.py: {program} ended with status {done.returncode}")
        texts.append(done.stdout)
    measured_in(texts)
    output.write_text("".join(texts))


def held(measured):
    """Prints the exceeded budgets; returns whether there are none."""
    book = budgets()
    complaints = list(book.complaints(measured))
    print("".join(f"{line}\n" for line in complaints), end="")
    print(f"figures: {len(measured)} measured, {len(book.held(measured))} of them held, "
          f"{len(complaints)} complaints")
    return bool(measured) and not complaints


def hold(*files):
    return held(measured_in(Path(file).read_text() for file in files if Path(file).exists()))


def write_pages(check):
    """Writes the pages, or prints how they differ; returns whether none does."""
    book, good = budgets(), True
    for page in [ROOT / "README.md", *sorted(DOCS.glob("*.md"))]:
        old = page.read_text()
        new = pages.rewritten(book, old)
        if not check:
            page.write_text(new)
        elif new != old:
            sys.stdout.writelines(difflib.unified_diff(
                old.splitlines(True), new.splitlines(True), str(page.relative_to(ROOT)), "of budgets.csv", n=0))
            print(f"figures.py: {page.relative_to(ROOT)} does not show budgets.csv: run figures.py pages",
                  file=sys.stderr)
            good = False
    return good


def texts_of(preset):
    """The output of measuring programs in the preset's build folder; the core comes first."""
    build = BUILD / preset
    files = [*sorted((build / "figures").glob("*.txt")), *(build / f"{name}.txt" for name in (
        "memory", "bound", "bound_measured")), *([FOLDER / "host.txt"] if preset == "native" else [])]
    texts = [file.read_text() for file in files if file.exists()]
    if not texts:
        sys.exit(f"figures.py: nothing measured in build/{preset}: run its tests, or tools/figures.sh")
    return texts


def table_of(measured):
    """All figures, the cores side by side."""
    cores = list(dict.fromkeys(core for core, _ in measured))
    return pages.lines_of([["figure", *cores], *([name, *(pages.grouped(measured.get((core, name), ""))
                                                          for core in cores)]
                                                 for name in dict.fromkeys(name for _, name in measured))])


def write(measured):
    """Writes the budgets, the pages, and the library's proven constants."""
    book = budgets()
    book.update(measured)
    BUDGETS.write_text(book.text())
    write_pages(check=False)
    bounds = FOLDER / "bounds.txt"
    bounds.write_text("".join(
        f"core {core}\n" + "".join(f"bound {name.removeprefix('bound.')} {cells[core]}\n"
                                   for name, cells in book.rows.items() if name.startswith("bound."))
        for core in book.columns if core != ALL))
    quietly(sys.executable, "-B", SHIPPED, bounds, COSTS, "--write")


def measure(mode, urdf, native, *presets):
    robot = Robot(Path(urdf).resolve(), native)
    if mode in ("prepare", "trees"):
        robot.prepare(for_boards_alone=mode == "prepare")
        return robot.trees(*presets or ("cortex-m4f",)) if mode == "trees" else print(FOLDER)
    presets = presets or ("native", *boards())
    if mode != "print":
        robot.prepare(for_boards_alone=False)
        for preset in presets:
            robot.measure(preset, TESTS)
    measured = measured_in(text for preset in presets for text in texts_of(preset))
    print(table_of(measured))
    if mode == "write":
        write(measured)
    # Also after writing: two boards may have one core.
    good = [held(measured_in(texts_of(preset))) for preset in presets] if mode != "print" else []
    return all(good) and write_pages(check=True)


def main(command="", *arguments):
    try:
        if command == "run" and len(arguments) > 1:
            return run(*arguments)
        if command == "hold" and arguments:
            return hold(*arguments)
        if command == "pages" and arguments in ((), ("--check",)):
            return write_pages(check=bool(arguments))
        if command == "measure" and len(arguments) > 2:
            return measure(*arguments)
    except (OSError, Refused) as why:
        sys.exit(f"figures.py: {why}")
    sys.exit(__doc__)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]) is False)
