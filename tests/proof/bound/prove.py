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

# In work. The awk programs of this folder and of tests/figures have them, too.
GO_ON, SHAPE, TRIANGLE_PAIR = 2, 8, 32


def check_units(sources: str) -> None:
    header = (Path(sources) / "include/flashbvh/detail/work.hpp").read_text()
    for name, units in (("GoOn", GO_ON), ("Shape", SHAPE), ("TrianglePair", TRIANGLE_PAIR)):
        if f"k{name}Work = {units};" not in header:
            raise Refused(f"k{name}Work is not {units} in work.hpp: change formula.awk, turns.awk, "
                          "tests/figures/page.awk and the pages, too")



def bounds(costs: Costs, general: Costs, roots: dict[str, str]) -> Iterator[tuple[str, int]]:
    def part(name: str, which: Costs = costs) -> Cost:
        return which.of(roots[name])

    run, on_below, below, answer, others = (part(name) for name in (
        "run", "walk-on-below", "walk-below", "next-answer", "other-triangles"))
    tests = run.term("test") + answer.fixed
    turn = on_below.term("turn") + below.fixed + below.term("climb")
    again = part("take-again").total
    begin = part("make-shape").total + 2 * others.fixed
    # A leaf taken as a shape: reached, or the next one after a leaf that a run went on with.
    shape = begin + max(part("reach-leaf").total + below.fixed + below.term("climb"), again + turn)
    # Transformed and tested, and maybe answered. triangle-pair-general: of triangles with area that
    # do not lie in one plane.
    transform = max(part("translate").total, part("rotate").total)
    pair = part("found").total + tests + sum(map(answer.term, ("row", "triangle"))) + transform
    walks = [part(f"walk-{kind}") for kind in ("translated", "rotated")]
    ascent = max([below.term("climb"), on_below.term("ascent")] +
                 [walk.term("ascent") for walk in walks])
    visit = max([below.term("visit")] + [walk.term("visit") for walk in walks]) + ascent
    # In at one end and out at the other, a turn without a visit, and no answer left.
    once = max(walk.fixed for walk in walks) + on_below.fixed + turn + tests
    triangle = pair + once + part("triangle-test").total
    other = 2 * others.term("other")
    # Before the first walk, and for a pair of leaves that is left to the next run.
    yield "start", run.fixed + once + again + begin + 2 * tests + part("found").total
    yield "ascent", ascent
    yield "later-sibling", on_below.term("sibling") + max(walk.term("sibling") for walk in walks)
    yield "leaf-triangle", other
    yield "work", max(visit, -(-turn // GO_ON), -(-shape // SHAPE), other, -(-triangle // TRIANGLE_PAIR))
    for kind, walk in zip(("translated", "rotated"), walks):
        yield f"visit-{kind}", max(below.term("visit"), walk.term("visit")) + ascent
    yield "shape", shape
    yield "triangle-pair", triangle
    yield "triangle-pair-general", pair + once + part("triangle-test", general).total
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
    check_units(sources)
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
