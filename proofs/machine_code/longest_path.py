"""The most instructions that a function can take for any input: the longest path of its control-flow graph,
calls included.

Loops are cut where an instruction belongs to a source line that the table names (loops.py): every cycle of the graph
passes a cut. Between two cuts the graph has no cycle, and a longest path is found in topological order. Paths from cut
to cut form a graph of a few nodes. A path leaves each strongly connected component once; inside, it makes at most as
many steps from cuts of a kind as the table allows. So, with n(k) steps from kind k and inside(k) the longest of them,
    instructions <= fixed + sum over k of n(k) * inside(k)
where `fixed` is the longest path from the entry to a return that steps from component to component.
This holds for irreducible loops, too.
"""
from __future__ import annotations

from dataclasses import dataclass
from functools import cache

from .graph import Graph
from .instruction import Flow
from .loops import Kind

OUT = -1  # leaves the function, in place of an address


@dataclass(frozen=True)
class Term:
    """The turns of a loop beyond the first, None if left open, and the cost of each."""
    kind: str
    turns: int | None
    cost: int

    def __str__(self) -> str:
        return f"{self.kind} " + ("" if self.turns is None else f"{self.turns}*") + \
            str(self.cost)


class Paths:
    """The paths of one function. called: the cost of its instructions' calls; marks: the places where the table allows
    a cut."""

    def __init__(self, graph: Graph, called: dict[int, int], marks: dict[int, Kind]):
        self._graph, self._called = graph, called
        self._weight = {address: 1 + called[address] for address in graph.code}
        self._successors = graph.successors
        self._exits = {address for address, found in graph.code.items()
                       if found.flow is Flow.LEAVE or
                       found.flow is Flow.JUMP and address in graph.callees}
        self.cuts = self._choose(marks)
        order, _ = self._sort(self.cuts)
        self._steps = {start: self._longest_from(start, order) for start in self.cuts}
        self._reach = {start: self._reached(start) for start in self.cuts}
        self._refuse_double_cuts()
        steps = self._longest_from(graph.function.address, order)
        self.fixed = max([steps.pop(OUT, 0)] +
                         [length + self._way_out(cut) for cut, length in steps.items()])
        self.terms = self._turns()

    def _sort(self, cuts: dict[int, Kind]) -> tuple[list[int], int | None]:
        """The topological order (Kahn) without edges into cuts; and a remaining instruction, if there is one."""
        into = dict.fromkeys(self._graph.code, 0)
        for after in self._successors.values():
            for to in after:
                into[to] += to not in cuts
        order = [address for address, count in into.items() if count == 0]
        for address in order:
            for to in self._successors[address]:
                if to not in cuts:
                    into[to] -= 1
                    if into[to] == 0:
                        order.append(to)
        return order, next((address for address, count in into.items() if count), None)

    def _choose(self, marks: dict[int, Kind]) -> dict[int, Kind]:
        """A minimal set of cuts: of equivalent instructions it keeps a call, or the last."""
        left = self._sort(marks)[1]
        if left is not None:
            raise self._graph.refuse(left, "a loop without a bound in the table")
        cuts = dict(sorted(marks.items()))
        plain = [address for address in cuts if not self._called[address]]
        for address in plain + list(cuts):
            kind = cuts.pop(address, None)
            if kind and self._sort(cuts)[1] is not None:
                cuts[address] = kind
        return dict(sorted(cuts.items()))

    def _longest_from(self, start: int, order: list[int]) -> dict[int, int]:
        """The longest paths from an instruction to each cut, exclusive, and to a return."""
        far = {start: self._weight[start]}
        steps: dict[int, int] = {}
        for address in order:
            if address not in far:
                continue
            if address in self._exits:
                steps[OUT] = max(steps.get(OUT, 0), far[address])
            for to in self._successors[address]:
                if to in self.cuts:
                    steps[to] = max(steps.get(to, 0), far[address])
                else:
                    far[to] = max(far.get(to, 0), far[address] + self._weight[to])
        return steps

    def _reached(self, start: int) -> set[int]:
        found: set[int] = set()
        pending = [start]
        while pending:
            new = self._steps[pending.pop()].keys() - found - {OUT}
            found |= new
            pending += new
        return found

    def _component(self, cut: int) -> list[int]:
        """The cuts of this cut's strongly connected component."""
        return [cut] + [to for to in sorted(self._reach[cut])
                        if to != cut and cut in self._reach[to]]

    @cache
    def _way_out(self, cut: int) -> float:
        """The longest path from a cut's component out of the function, without steps inside."""
        component = self._component(cut)
        return max((length + (0 if to == OUT else self._way_out(to))
                    for member in component for to, length in self._steps[member].items()
                    if to not in component), default=float("-inf"))

    def _refuse_double_cuts(self) -> None:
        """Allows a kind with a count only once in a loop: two places might count a turn twice."""
        for cut, kind in self.cuts.items():
            others = self._component(cut)[1:]
            if kind.count is not None and kind.name in (self.cuts[to].name for to in others):
                raise self._graph.refuse(cut, "a loop that the table cuts in two places")

    def _turns(self) -> list[Term]:
        """The costs of turns beyond the first: per component, or of the worst one if left open."""
        inside: dict[tuple[Kind, int], int] = {}
        for cut, kind in self.cuts.items():
            component = self._component(cut)
            longest = max(self._steps[cut].get(to, 0) for to in component)
            key = kind, OUT if kind.count is None else min(component)
            inside[key] = max(inside.get(key, 0), longest)
        return [Term(kind.name, None if kind.count is None else kind.count - 1, longest)
                for (kind, _), longest in inside.items()]
