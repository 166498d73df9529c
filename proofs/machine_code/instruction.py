"""The properties of a machine instruction that the proofs need."""
from __future__ import annotations

from dataclasses import dataclass
from enum import Enum


class Flow(Enum):
    NEXT = "plain"
    JUMP = "jump"  # to the target
    CALL = "call"  # to the target, which returns
    LEAVE = "return"
    STOP = "not understood"  # a trap, or an instruction on which no proof should rely


@dataclass(frozen=True)
class Instruction:
    address: int
    size: int
    flow: Flow = Flow.NEXT
    target: int | None = None  # None: known only at run time
    falls_through: bool = True  # the next instruction may follow
    grows: int | None = 0  # the stack's growth in bytes; None: not a constant
    name: str = ""  # for conditional branches, and "nop"

    @property
    def end(self) -> int:
        return self.address + self.size

    @property
    def is_padding(self) -> bool:
        """Whether the instruction may stand between functions; a bare return is harmless."""
        return self.name == "nop" or (self.flow is Flow.LEAVE and self.grows == 0)


class Refused(Exception):
    """The reason why a proof fails, and the place."""
