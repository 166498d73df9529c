"""prove.py OUTPUT CUTS CORE PROGRAM SOURCES

Finds what a run of a query can cost at worst in the machine code of PROGRAM, the firmware of this
folder, and writes it to OUTPUT, "bound NAME VALUE" a line: flashbvh::RunCosts (bound.hpp), for
poses that translate and for those that rotate. Where loops were cut goes to CUTS: see turns.sh.
CORE: its name; SOURCES: the folder that loops.txt speaks of.
"""
from __future__ import annotations

import sys
from pathlib import Path
from typing import Iterator

from machine_code.cost import Cost, Costs
from machine_code.instruction import Refused
from machine_code.loops import Loops
from machine_code.program import Program


def bounds(costs: Costs, general: Costs, roots: dict[str, str]) -> Iterator[tuple[str, int]]:
    def part(name: str, which: Costs = costs) -> Cost:
        return which.of(roots[name])

    run, on_below, below, answer = (
        part(name) for name in ("run", "walk-on-below", "walk-below", "next-answer"))
    # A leaf is taken as a shape, and its two slabs are made, at most once a visit.
    others = part("other-triangles")
    shape = part("make-shape").total + 2 * others.fixed
    turn = on_below.term("turn") + below.fixed
    climb = below.term("climb")
    for kind in ("translated", "rotated"):
        walk = part(f"walk-{kind}")
        # In at one end and out at the other, a turn without a visit, and no answer left.
        once = walk.fixed + on_below.fixed + turn + shape + run.term("test") + answer.fixed
        yield f"run-{kind}", run.fixed + once
        yield f"visit-{kind}", shape + max(walk.term("visit") + below.fixed,
                                           turn + climb + below.term("visit"))
        yield f"ascent-{kind}", max(climb, walk.term("ascent"), on_below.term("ascent"))
        yield f"leaf-pair-{kind}", run.term("walk") + once
        yield f"later-sibling-{kind}", walk.term("sibling") + on_below.term("sibling")
    yield "leaf-triangle", 2 * others.term("other")
    # Transformed and tested, and maybe answered. triangle-pair-general: of triangles with area that
    # do not lie in one plane.
    transform = max(part("translate").total, part("rotate").total)
    pair = run.term("test") + answer.fixed + sum(map(answer.term, ("row", "triangle")))
    for name, which in (("triangle-pair", costs), ("triangle-pair-general", general)):
        yield name, pair + transform + part("triangle-test", which).total
    yield "make-query", costs.of(roots["make-query"]).total


def cut_lines(program: Program, costs: Costs) -> Iterator[str]:
    for function, cost in costs.known.items():
        for address, kind in cost.cuts.items():
            count = -1 if kind.count is None else kind.count
            yield f"cut {address:x} {function.address:x} {kind.name} {count}"
    for function in program.functions.values():
        if function.names[0].startswith("bound_"):
            yield f"symbol {function.address:x} {function}"


def main() -> None:
    output, cuts, core, file, sources = sys.argv[1:]
    program = Program(file)
    loops = Loops(str(Path(__file__).with_name("loops.txt")), sources)
    costs = Costs(program, loops)
    found = bounds(costs, Costs(program, loops, general=True), loops.roots)
    text = "\n".join([f"core {core}"] + [f"bound {name} {value}" for name, value in found])
    Path(output).write_text(text + "\n")
    Path(cuts).write_text("\n".join(cut_lines(program, costs)) + "\n")
    print(text)


if __name__ == "__main__":
    try:
        main()
    except Refused as refusal:
        sys.exit(f"prove.py: {refusal}")
