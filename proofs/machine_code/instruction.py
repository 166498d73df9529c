"""What the proofs need to know of a machine instruction."""
from __future__ import annotations

from dataclasses import dataclass
from enum import Enum


class Flow(Enum):
    NEXT = "plain"
    JUMP = "jump"  # to the target
    CALL = "call"  # of the target, which comes back
    LEAVE = "return"
    STOP = "not understood"  # a trap, or what no proof should rely on


@dataclass(frozen=True)
class Instruction:
    address: int
    size: int
    flow: Flow = Flow.NEXT
    target: int | None = None  # None: only the run knows
    falls_through: bool = True  # the next instruction may follow
    grows: int | None = 0  # the stack's growth in bytes; None: not a constant
    name: str = ""  # of conditional branches, and "nop"
    mnemonic: str = ""  # and code: as objdump has them
    code: str = ""

    @property
    def end(self) -> int:
        return self.address + self.size

    @property
    def is_padding(self) -> bool:
        """What may stand between functions; a bare return is harmless."""
        return self.name == "nop" or (self.flow is Flow.LEAVE and self.grows == 0)


class Refused(Exception):
    """What cannot be proven, and where."""
