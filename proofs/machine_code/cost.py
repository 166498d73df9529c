"""The most instructions that calls of functions can take.

cost.py TABLE SOURCES PROGRAM FUNCTION...   prints for each function, named by a regular expression,
    FUNCTION SUM = fixed N [KIND TURNS*N | KIND N]...
SUM excludes kinds of turns whose count the table leaves open: each such turn adds its N.
For TABLE, see loops.py. Fails with the place if it meets code that it does not understand: an indirect branch, a
recursive call, a loop without a bound in the table.
"""
from __future__ import annotations

import sys
from dataclasses import dataclass

from .graph import Graph
from .instruction import Flow, Refused
from .longest_path import Paths, Term
from .loops import Kind, Loops
from .program import Function, Program


@dataclass(frozen=True)
class Cost:
    fixed: int
    terms: list[Term]
    cuts: dict[int, Kind]

    @property
    def total(self) -> int:
        return self.fixed + sum(t.turns * t.cost for t in self.terms if t.turns is not None)

    def term(self, kind: str) -> int:
        """The cost of one turn."""
        for term in self.terms:
            if term.kind == kind:
                return term.cost
        raise Refused(f"no {kind} in: {self}")

    def __str__(self) -> str:
        return " ".join([f"{self.total} = fixed {self.fixed}"] + [str(t) for t in self.terms])


class Costs:
    def __init__(self, program: Program, loops: Loops):
        self._program, self._loops = program, loops
        self.known: dict[Function, Cost | None] = {}  # None: in progress

    def of(self, pattern: str) -> Cost:
        return self._of(self._program.matching(pattern))

    def _of(self, function: Function) -> Cost:
        if function in self.known:
            if self.known[function] is None:
                raise Refused(f"{function} calls itself")
            return self.known[function]
        self.known[function] = None
        graph = Graph(self._program, function)
        for address, found in graph.code.items():
            if found.flow is Flow.STOP or address in graph.computed_jumps or \
                    graph.unknown_call(address):
                raise graph.refuse(address, "not understood")
        called = {address: self._call(function, graph.callees.get(address)) for address in graph.code}
        paths = Paths(graph, called, self._loops.marks(self._program, function, graph.code))
        self.known[function] = cost = Cost(paths.fixed, paths.terms, paths.cuts)
        return cost

    def _call(self, caller: Function, callee: Function | None) -> int:
        """The cost of a whole call, or 0 if the table counts it separately."""
        if callee is None:
            return 0
        cost = self._of(callee)
        if self._loops.is_apart(callee):
            return 0
        left_open = [term.kind for term in cost.terms if term.turns is None]
        if left_open:
            raise Refused(f"{callee} has no bound of its own ({left_open}), but {caller} calls it")
        return cost.total


def main() -> None:
    table, sources, program, *functions = sys.argv[1:]
    costs = Costs(Program(program), Loops(table, sources))
    for function in functions:
        print(function, costs.of(function))


if __name__ == "__main__":
    try:
        main()
    except Refused as refusal:
        sys.exit(f"cost.py: {refusal}")
