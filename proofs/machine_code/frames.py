"""The stack of a function, from its machine code: follows sp along all branches."""
from __future__ import annotations

from dataclasses import dataclass

from .graph import Graph
from .instruction import Flow

DEEPEST = 1 << 20  # A loop that pushes has no end.


@dataclass(frozen=True)
class Frame:
    size: int  # the lowest value of sp
    held: dict[int, int]  # the frame's size at each call: usually 0 at a call in tail position


def frame_of(graph: Graph) -> Frame:
    start = graph.function.address
    before = {start: 0}  # the depth before each instruction, the largest over all paths to it
    pending = [start]
    size = 0
    while pending:
        address = pending.pop()
        found = graph.code[address]
        if found.flow is Flow.STOP:
            raise graph.refuse(address, "not understood")
        if found.grows is None:
            raise graph.refuse(address, f"{graph.function} has a frame of no fixed size")
        # Code after a return has not executed the return.
        depth = before[address] + (0 if found.flow is Flow.LEAVE else found.grows)
        if depth > DEEPEST:
            raise graph.refuse(address, "the stack's depth has no end")
        size = max(size, depth)
        for after in graph.successors[address]:
            if depth > before.get(after, -1):
                before[after] = depth
                pending.append(after)
    return Frame(size, {address: before[address] for address in graph.callees})
