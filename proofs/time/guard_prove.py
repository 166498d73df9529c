"""guard_prove.py OUTPUT CUTS CORE PROGRAM SOURCES [DECODER TABLES CORE...]

Finds the worst-case cost of a guard's period in the machine code of PROGRAM, bound_guard, and writes it to OUTPUT,
"bound guard-NAME VALUE" per line: flashbvh::GuardCosts (robot/period_bound.hpp). Writes the places of cut loops to
CUTS: see turns.py. CORE: its name; SOURCES: the folder of guard_loops.txt's files. With DECODER: see prove.py.

Counts that the table leaves open apply to a whole period, and lib/docs/bounded_time.md gives them. So a call costs the
part outside such loops, and this program adds up their turns.
"""
from __future__ import annotations

from typing import Iterator

from machine_code.cost import Costs
from machine_code.instruction import Refused
from machine_code.loops import Loops
from machine_code.measure import Instructions
from machine_code.program import Program

from formula import AIM, EXACT, LEVER, NEAR, NEARER, PAIR, PLACED, POSE
from prove import GO_ON, SHAPE, UNITS, WORK, Found, main

# Pairs of leaves that a walk collects, except in the last batch.
BATCH = 4
# A run's first two batches, and one without work.
FIRST_BATCHES = 3
# The largest arity; a walk begins twice among siblings in both trees, and a resumed cursor is checked.
ARITY = 4
SIBLINGS = 2 * (ARITY - 1)
# The largest leaf: the bound excludes resuming inside a larger one.
LEAF = 7


GUARD_UNITS = [(WORK, f"kAlongPairWork = {PAIR};"), (WORK, f"kPlacedPairWork = {PLACED};"),
               (WORK, f"kExactPairWork = {EXACT};"), (WORK, f"kNearPairWork = {NEAR};"),
               ("include/flashbvh/detail/query/proximity.hpp", f"kBatch = {BATCH};"),
               (WORK, f"kPoseWork = {POSE};"),
               (WORK, f"kLeverWork = {LEVER};"),
               (WORK, f"kAimWork = {AIM};")]


def parts(value: int, by: int) -> int:
    return -(-value // by)


def bounds(costs: Costs, closed: Costs, roots: dict[str, str]) -> Iterator[tuple[str, int]]:
    total = {name: costs.of(pattern).total for name, pattern in roots.items()}
    turn = costs.turns()
    # For searches within a limit.
    within = closed.of(roots["within"]).total
    # To load a leaf's planes: `begin` checks whether they are loaded.
    begun = total["begin"] + 2 * total["take"]
    batch = turn["batch"] + turn["turn"] + begun + 2 * SIBLINGS * turn["sibling"]
    run = turn["run"] + FIRST_BATCHES * batch + SIBLINGS * turn["sibling"] + total["found"]
    triangles = total["found"] + turn["triangle"] + parts(batch, BATCH)
    ascent = max(turn["ascent"], turn["climb"])
    placed = triangles + total["placed"]
    # A witness nearer than the limit, found by an exact test.
    nearer = placed + within + run + total["witness"]
    work = max(turn["visit"] + ascent, turn["other"], parts(turn["turn"], GO_ON),
               parts(max(total["shape"] + total["reached"], turn["turn"]) + begun, SHAPE), parts(triangles, PAIR),
               parts(placed, PAIR + PLACED), parts(placed + within, PAIR + PLACED + EXACT),
               parts(nearer, NEARER),
               parts(turn["run"], POSE), parts(turn["lever"], LEVER))
    if batch > NEAR * work:
        raise Refused("a walk of 65,535 is not paid for")
    measured = turn["measured"] + run
    # The cost of a measurement that its own work does not cover.
    measure = max(0, measured - POSE * work, measured + total["witness"] - (POSE + AIM) * work)
    # A pair that an earlier period began to measure, and a cursor that its state does not have.
    yield "guard-start", (total["period"] + turn["measured"] + 2 * run + 2 * (LEAF - 1) * turn["other"])
    yield "guard-joint", (turn["set"] + turn["one-way"] + turn["step"] + turn["frame"]
                          + 3 * turn["third"] + 3 * turn["power"])
    yield "guard-turn", max(turn[name] for name in ("master", "begun", "longest", "next", "skipped", "kept"))
    yield "guard-pair", turn["pair"]
    yield "guard-between", (4 * turn["motion"] + turn["rate"] + turn["since"] + turn["moved"]
                             + turn["certified"])
    yield "guard-table", max(turn["table"], turn["axis"])
    yield "guard-measure", measure
    yield "guard-ascent", ascent
    yield "guard-within", within
    yield "guard-work", work


def prove(program: Program, loops: Loops, measure: Instructions) -> Found:
    costs, closed = (Costs(program, loops, special, together=True, measure=measure) for special in (False, True))
    return costs, dict(bounds(costs, closed, loops.roots))


if __name__ == "__main__":
    main("guard_loops.txt", UNITS + GUARD_UNITS, prove)
