"""The control-flow graph of a function: the code reachable from its entry, and its callees."""
from __future__ import annotations

from .instruction import Flow, Instruction, Refused
from .program import Function, Program

# The functions of libgcc for a `switch` on Armv6-M: they read the table at their return address and jump.
BRANCHES_BY_TABLE = "__gnu_thumb1_case_"


class Graph:
    def __init__(self, program: Program, function: Function):
        self.program = program
        self.function = function
        self.code: dict[int, Instruction] = {}  # the reachable code
        self.successors: dict[int, list[int]] = {}
        self.callees: dict[int, Function] = {}  # by call, or by jump in tail position
        self.computed_jumps: list[int] = []
        self._all = program.code_of(function)
        self._reach(function.address)
        self._reach_by_tables()
        self.code = {address: self.code[address] for address in sorted(self.code)}

    def refuse(self, address: int, why: str) -> Refused:
        return Refused(f"{self.program.place(address)}: {why}")

    def unknown_call(self, address: int) -> bool:
        """Whether an instruction calls a function that is known only at run time."""
        return self.code[address].flow is Flow.CALL and self.code[address].target is None

    def _reach(self, start: int) -> None:
        pending = [start]
        while pending:
            address = pending.pop()
            if address in self.code:
                continue
            if address not in self._all:
                raise self.refuse(start, f"leads to {address:x}, which is no code of the function")
            self.code[address] = self._all[address]
            self.successors[address] = self._follow(self._all[address])
            pending += self.successors[address]

    def _follow(self, found: Instruction) -> list[int]:
        """The instructions that may execute next in the function."""
        after = []
        if found.target is not None:
            if found.target in self._all and (found.flow is Flow.JUMP or
                                              found.target != self.function.address):
                after.append(found.target)
                if found.flow is Flow.CALL:  # Armv6-M's far jump: lr is saved before
                    return after
            else:
                self.callees[found.address] = self.program.at(found.target)
        if self._is_computed_jump(found):
            self.computed_jumps.append(found.address)
        elif found.falls_through and found.flow is not Flow.STOP:
            if found.end == self.function.end:
                raise self.refuse(found.address, "the function's end is reached")
            after.append(found.end)
        return after

    def _is_computed_jump(self, found: Instruction) -> bool:
        if found.flow is Flow.CALL and found.address in self.callees:
            return self.callees[found.address].names[0].startswith(BRANCHES_BY_TABLE)
        return found.flow is Flow.JUMP and found.target is None

    def _reach_by_tables(self) -> None:
        """A computed jump leads wherever a table says: to all code that is not reachable otherwise."""
        cases = []
        for address, found in self._all.items():
            if address not in self.code and not found.is_padding:
                if not self.computed_jumps:
                    raise self.refuse(address, "nothing leads here")
                self._reach(address)
                cases.append(address)
        for jump in self.computed_jumps:
            self.successors[jump] += cases
