"""check.py TAGS BUDGETS ENTRIES OUTPUT FIGURES...

Checks that the figures agree and keep their budgets; writes them to OUTPUT, for other scripts, in lines
    code ENTRY Os|O2 BYTES
    stack ENTRY graph|painted BYTES
    object NAME BYTES
Ignores other lines of FIGURES. A stack's two figures must differ by at most 16 bytes, and the painted one must not
exceed the call graph's. TAGS: the tags of the board's core, separated by commas. Checks BUDGETS (budgets.txt) with one
of these tags, and on Thumb-2 those of ENTRIES (entries.inc).
"""
from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import Iterator

MOST_APART = 16
ENTRY = re.compile(r"^ENTRY\((\w+), \w+, (\d+),", re.M)
FIGURE = re.compile(r"((?:code|stack) [a-z_]+ [A-Za-z0-9]+|object [A-Za-z]+) ([0-9]+)")


def budgets(tags: list[str], lines: list[str]) -> dict[str, int]:
    """The limits by their subject: the least of all that apply."""
    limits: dict[str, int] = {}
    for line in lines:
        tag, *what, most = line.split() if line and not line.startswith("#") else ("", "")
        if tag in tags:
            limits[" ".join(what)] = min(int(most), limits.get(" ".join(what), int(most)))
    return limits


def problems(limits: dict[str, int], figures: dict[str, int]) -> Iterator[str]:
    if not figures:
        yield "no figures"
    stacks = sorted({name.rsplit(" ", 1)[0] for name in figures if name.startswith("stack ")})
    for stack in stacks:
        graph, painted = figures.get(f"{stack} graph"), figures.get(f"{stack} painted")
        if graph is None or painted is None:
            yield f"{stack}: only one of the two figures"
        elif painted > graph:
            yield f"{stack}: painted {painted}, above the call graph's {graph}"
        elif graph - painted > MOST_APART:
            yield f"{stack}: painted {painted}, {graph - painted} below the call graph"
    for what, most in limits.items():
        if not sizes_of(what, figures):
            yield f"a budget for what was not measured: {what}"
        for size in sizes_of(what, figures):
            if size > most:
                yield f"{what}: {size} bytes, more than {most}"


def sizes_of(what: str, figures: dict[str, int]) -> list[int]:
    """The sizes of a budget's subject: a stack's budget holds for both figures."""
    return [size for name, size in figures.items()
            if what == name or what.startswith("stack ") and name.startswith(f"{what} ")]


def read(lines: list[str]) -> dict[str, int]:
    matches = map(FIGURE.fullmatch, lines)
    return {match[1]: int(match[2]) for match in matches if match}


def main() -> int:
    tags, table, entries, output, *paths = sys.argv[1:]
    Path(output).unlink(missing_ok=True)
    figures = read([line for path in paths for line in Path(path).read_text().splitlines()])
    stacks = [f"thumb2 stack {name} {most}" for name, most in ENTRY.findall(Path(entries).read_text())]
    limits = budgets(tags.split(","), Path(table).read_text().splitlines() + stacks)
    for what, most in limits.items():
        for size in sizes_of(what, figures):
            print(f"budget: {what}: {size} bytes, at most {most}")
    found = list(problems(limits, figures))
    if found:
        print("\n".join(f"check.py: {problem}" for problem in found), file=sys.stderr)
        return 1
    Path(output).write_text("".join(f"{name} {size}\n" for name, size in figures.items()))
    return 0


if __name__ == "__main__":
    sys.exit(main())
