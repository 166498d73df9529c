"""prove.py OUTPUT CUTS CORE PROGRAM SOURCES

Finds the worst-case cost of a query's run in the machine code of PROGRAM, the firmware of this folder, and writes it to
OUTPUT, "bound NAME VALUE" per line: flashbvh::RunCosts (time_bound.hpp), for translations and for rotations. Writes the
places of cut loops to CUTS: see turns.py. CORE: its name; SOURCES: the folder of loops.txt's files.
"""
from __future__ import annotations

import sys
from pathlib import Path
from typing import Iterator

from machine_code.cost import Cost, Costs
from machine_code.instruction import Refused
from machine_code.loops import Loops
from machine_code.program import Program

# Units of work. Programs of this folder and of tests/figures have them, too.
GO_ON, OTHER_PLANE, SHAPE, TRIANGLE_PAIR = 2, 3, 8, 32


WORK = "include/flashbvh/detail/walk/work.hpp"
UNITS = [(WORK, f"kGoOnWork = {GO_ON};"), (WORK, f"kOtherPlaneWork = {OTHER_PLANE};"),
         (WORK, f"kShapeWork = {SHAPE};"),
         (WORK, f"kTrianglePairWork = {TRIANGLE_PAIR};")]


def bounds(costs: Costs, roots: dict[str, str]) -> Iterator[tuple[str, int]]:
    def part(name: str) -> Cost:
        return costs.of(roots[name])

    run, on_below, below, answer = (part(name) for name in (
        "run", "walk-on-below", "walk-below", "next-answer"))
    slabs = [part("make-plane"), part("make-edge")]
    tests = run.term("test") + answer.fixed
    turn = on_below.term("turn") + below.fixed + below.term("climb")
    again = part("take-again").total
    made = sum(slab.fixed for slab in slabs)
    # A leaf's corners, three per triangle, against the plane; then the leaf above against its baked plane. Both have
    # at most as many triangles as pairs of triangles. A rejection by the latter spends the larger number, and more.
    corners = 3 * part("compare-leaf").term("vertex")
    rejected = part("compare-leaf").fixed + corners
    compared = 2 * rejected + part("compare-other").total
    # Loading a leaf's planes: reached, or the next one after the leaf at which a run resumed.
    reached = part("reach-leaf").total + part("below-reached").total
    shape = made + max(reached + below.fixed + below.term("climb"), again + turn)
    # Transformed, tested, and possibly reported.
    transform = max(part("translate").total, part("rotate").total)
    pair = compared + part("found").total + tests + sum(map(answer.term, ("row", "triangle"))) + transform
    walks = [part(f"walk-{kind}") for kind in ("translated", "rotated")]
    ascent = max([below.term("climb"), on_below.term("ascent")] +
                 [walk.term("ascent") for walk in walks])
    visit = max([below.term("visit")] + [walk.term("visit") for walk in walks]) + ascent
    # From the start of one path to the end of another, a turn without a visit, and no answer left.
    once = part("walk").total + max(walk.fixed for walk in walks) + on_below.fixed + turn + tests
    triangle = pair + once + max(part("near-test").total, part("wide-test").total)
    other = sum(slab.term("other") for slab in slabs) + 2 * corners
    # Before the first walk, and for a pair of leaves that the next run gets.
    yield "start", run.fixed + once + again + made + 2 * tests + compared + part("found").total
    yield "ascent", ascent
    yield "later-sibling", on_below.term("sibling") + max(walk.term("sibling") for walk in walks)
    yield "leaf-triangle", other
    yield "work", max(visit, rejected, -(-compared // (OTHER_PLANE + 1)), -(-turn // GO_ON), -(-shape // SHAPE),
                      other, -(-triangle // TRIANGLE_PAIR))
    yield "make-query", costs.of(roots["make-query"]).total


def check_itself(costs: Costs, roots: dict[str, str], bound: dict[str, int]) -> None:
    """Whether runs of a mesh against itself keep most_of_itself() in check.py. An ascent passes as many siblings as
    the arity, a walk's begin as many in both trees. Compares the costs at an arity of 1, and those of one more, for
    which the formula adds two siblings."""
    run, answer, walk, rotated = (costs.of(roots[name]) for name in (
        "self-run", "self-next-answer", "self-walk", "self-walk-rotated"))
    found, test = (costs.of(roots[name]).total for name in ("found", "near-test"))
    looks, skipped = 2 * walk.term("sibling"), walk.term("skipped")
    tests = run.term("test") + answer.fixed
    way = costs.of(roots["self-way"]).total
    once = way + max(walk.fixed, rotated.fixed) + looks + tests
    pair = found + tests + sum(map(answer.term, ("row", "triangle"))) + 6 * answer.term("corner")
    ascent = walk.term("ascent") + skipped
    sibling = bound["later-sibling"]
    unit = bound["work"] + sibling
    for name, most, given in (
            ("start", run.fixed + once + 2 * tests + found, bound["start"]),
            ("ascent", ascent, bound["ascent"] + sibling),
            ("sibling", max(looks, skipped), 2 * sibling),
            ("visit", walk.term("visit") + ascent, unit),
            ("triangle-pair", pair + once + test, TRIANGLE_PAIR * unit)):
        print(f"itself {name} {most} of {given}")
        if most > given:
            raise Refused(f"{name} of a mesh against itself: {most}, more than {given}")


def cut_lines(program: Program, costs: Costs) -> Iterator[str]:
    for function, cost in costs.known.items():
        for address, kind in cost.cuts.items():
            count = -1 if kind.count is None else kind.count
            yield f"cut {address:x} {function.address:x} {kind.name} {count}"
    for function in program.functions.values():
        if function.names[0].startswith("bound_"):
            yield f"symbol {function.address:x} {function}"


def main(output: str, cuts: str, core: str, file: str, sources: str) -> None:
    for name, text in UNITS:
        if text not in (Path(sources) / name).read_text():
            raise Refused(f"no '{text}' in {name}: change this program, check.py, turns.py and the pages, too")
    program, loops = Program(file), Loops(str(Path(__file__).with_name("loops.txt")), sources)
    costs = Costs(program, loops)
    found = dict(bounds(costs, loops.roots))
    check_itself(costs, loops.roots, found)
    lines = [f"core {core}"] + [f"bound {name} {value}" for name, value in found.items()]
    Path(cuts).write_text("\n".join(cut_lines(program, costs)) + "\n")
    Path(output).write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except Refused as refusal:
        sys.exit(f"prove.py: {refusal}")
