"""Measures that a path through machine code sums up: instructions, cycles, or reads of flash.

A measure has `of`, the cost of an instruction anywhere; `jump`, its additional cost if it jumps; and `after`, its
additional cost after another instruction.
"""
from __future__ import annotations

import re
import subprocess
from dataclasses import dataclass

from .instruction import Instruction, Refused
from .program import Program

# The only instructions that ports/cycles may decode as `alu`.
ALU = re.compile(r"(adc|add|and|asr|bfc|bfi|bic|clz|cmn|cmp|eor|lsl|lsr|mov|movt|mvn|neg|nop|orn|orr|pld|rbit|"
                 r"ror|rrx|rsb|sbc|sbfx|sub|[su]xt[abh]+|teq|tst|ubfx|[su]sat(16)?|rev(16|sh)?|sel|pkh(bt|tb)|"
                 r"(s|u|q|sh|uh|uq)(add8|sub8|add16|sub16|asx|sax)|qd?(add|sub))[sw]?"
                 r"(eq|ne|cs|cc|mi|pl|vs|vc|hi|ls|ge|lt|gt|le)?(\.[nw])?")

# Loads and stores of words, which some cores also accept at a halfword's address; others require alignment.
WORD = re.compile(r"(ldr|str)(eq|ne|cs|cc|mi|pl|vs|vc|hi|ls|ge|lt|gt|le)?(\.[nw])?")
LITERAL, STACK = 0, 1 << 13  # the base of an address


class Instructions:
    """Counts each instruction as 1."""

    def of(self, found: Instruction) -> int:
        return 1

    def jump(self, found: Instruction) -> int:
        return 0

    def after(self, found: Instruction, following: Instruction) -> int:
        return 0


@dataclass(frozen=True)
class Taken:
    """The cost of an instruction, as flashbvh_most_cycles prints it."""
    kind: str
    cycles: int
    jump: int
    reads: int
    address: int


class Cycles:
    """The most cycles by a core's table, in memory without wait states. Nothing overlaps; each wide instruction counts
    as lying in two words, and so does each target of a jump. decoder: the command flashbvh_most_cycles."""
    UNIT = 1

    def __init__(self, program: Program, decoder: list[str]):
        self._program = program
        self._decoder = subprocess.Popen(decoder, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self._lines: dict[str, list[str]] = {}
        first = self._decoder.stdout.readline().split()
        if not first:
            raise Refused("no answer of " + " ".join(decoder))
        self._wide_target, self._unaligned_word = map(int, first)

    def close(self) -> None:
        self._decoder.communicate()

    def _line(self, code: str) -> list[str]:
        """The decoder's output for an instruction."""
        if code not in self._lines:
            print(code, file=self._decoder.stdin, flush=True)
            self._lines[code] = self._decoder.stdout.readline().split()
        return self._lines[code]

    def taken(self, found: Instruction) -> Taken:
        """Refuses, by name, an instruction without a bound in the table."""
        kind, *numbers = self._line(found.code)
        if kind.startswith("no_") or kind == "barrier" or kind == "alu" and not ALU.fullmatch(found.mnemonic):
            raise Refused(f"{self._program.place(found.address)}: no most cycles of '{found.mnemonic}', {kind}")
        return Taken(kind, *map(int, numbers))

    def unaligned(self, found: Instruction) -> int:
        """The additional cost of a word at a halfword's address, such as two coordinates of a vertex."""
        address = self.taken(found).address
        # Narrow offsets from the stack pointer are multiples of a word.
        is_aligned = address == LITERAL or address == STACK and found.size == 2
        return self._unaligned_word if WORD.fullmatch(found.mnemonic) and not is_aligned else 0

    def of(self, found: Instruction) -> int:
        return self.taken(found).cycles + self.unaligned(found)

    def jump(self, found: Instruction) -> int:
        return self.taken(found).jump + self._wide_target

    def after(self, found: Instruction, following: Instruction) -> int:
        return int(self._line(f"{found.code} / {following.code}")[0])


class FlashReads(Cycles):
    """Reads of flash, each of which costs its wait states, in parts of LINE: no cache holds more than the current
    line. After a jump, the first line and the last one may be used by a single byte, the core may have prefetched AHEAD
    bytes that it does not execute, and the flash may have prefetched a line."""
    UNIT = LINE = 8  # bytes, or more
    AHEAD = 12  # the prefetch unit of a Cortex-M3 and M4 has three words

    def of(self, found: Instruction) -> int:
        reads = self.taken(found).reads
        return found.size + self.LINE * (reads + (self.unaligned(found) if reads else 0))

    def jump(self, found: Instruction) -> int:
        return 3 * self.LINE + self.AHEAD

    def after(self, found: Instruction, following: Instruction) -> int:
        return 0
