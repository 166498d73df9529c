"""What a path through machine code adds up: instructions, cycles, or reads of flash.

A measure has `of`, what an instruction takes wherever it stands; `jump`, what it takes in addition if it
goes on elsewhere; and `after`, what an instruction takes in addition behind another one.
"""
from __future__ import annotations

import re
import subprocess
from dataclasses import dataclass

from .instruction import Instruction, Refused
from .program import Program

# What ports/cycles decodes as `alu` may be nothing but these.
ALU = re.compile(r"(adc|add|and|asr|bfc|bfi|bic|clz|cmn|cmp|eor|lsl|lsr|mov|movt|mvn|neg|nop|orn|orr|pld|rbit|"
                 r"ror|rrx|rsb|sbc|sbfx|sub|[su]xt[abh]+|teq|tst|ubfx|[su]sat(16)?|rev(16|sh)?|sel|pkh(bt|tb)|"
                 r"(s|u|q|sh|uh|uq)(add8|sub8|add16|sub16|asx|sax)|qd?(add|sub))[sw]?"
                 r"(eq|ne|cs|cc|mi|pl|vs|vc|hi|ls|ge|lt|gt|le)?(\.[nw])?")

# Loads and stores of words, which some cores take from a halfword's address; others want aligned ones.
WORD = re.compile(r"(ldr|str)(eq|ne|cs|cc|mi|pl|vs|vc|hi|ls|ge|lt|gt|le)?(\.[nw])?")
LITERAL, STACK = 0, 1 << 13  # what an address is made of


class Instructions:
    """Each counts 1."""

    def of(self, found: Instruction) -> int:
        return 1

    def jump(self, found: Instruction) -> int:
        return 0

    def after(self, found: Instruction, following: Instruction) -> int:
        return 0


@dataclass(frozen=True)
class Taken:
    """By an instruction: as flashbvh_most_cycles prints it."""
    kind: str
    cycles: int
    jump: int
    reads: int
    address: int


class Cycles:
    """The most by a core's table, in memory without wait states. Nothing is saved by overlapping; each wide
    instruction is taken to lie in two words, and each target of a jump to be one. decoder: the command
    flashbvh_most_cycles."""
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
        """What the decoder prints."""
        if code not in self._lines:
            print(code, file=self._decoder.stdin, flush=True)
            self._lines[code] = self._decoder.stdout.readline().split()
        return self._lines[code]

    def taken(self, found: Instruction) -> Taken:
        """Refuses what the table has no bound of, by name."""
        kind, *numbers = self._line(found.code)
        if kind.startswith("no_") or kind == "barrier" or kind == "alu" and not ALU.fullmatch(found.mnemonic):
            raise Refused(f"{self._program.place(found.address)}: no most cycles of '{found.mnemonic}', {kind}")
        return Taken(kind, *map(int, numbers))

    def unaligned(self, found: Instruction) -> int:
        """What a word at a halfword's address takes more, as two coordinates of a vertex may be."""
        address = self.taken(found).address
        # Narrow offsets from the stack pointer are of words.
        is_aligned = address == LITERAL or address == STACK and found.size == 2
        return self._unaligned_word if WORD.fullmatch(found.mnemonic) and not is_aligned else 0

    def of(self, found: Instruction) -> int:
        return self.taken(found).cycles + self.unaligned(found)

    def jump(self, found: Instruction) -> int:
        return self.taken(found).jump + self._wide_target

    def after(self, found: Instruction, following: Instruction) -> int:
        return int(self._line(f"{found.code} / {following.code}")[0])


class FlashReads(Cycles):
    """Reads of flash, each of which takes its wait states, in parts of LINE: no cache keeps anything but
    the line that is executed. Where execution goes on after a jump, the first line and the last one may be
    touched by a byte only, the core may have fetched AHEAD bytes that it does not execute, and the flash
    a line of its own accord."""
    UNIT = LINE = 8  # bytes, or more
    AHEAD = 12  # the prefetch unit of a Cortex-M3 and M4 has three words

    def of(self, found: Instruction) -> int:
        reads = self.taken(found).reads
        return found.size + self.LINE * (reads + (self.unaligned(found) if reads else 0))

    def jump(self, found: Instruction) -> int:
        return 3 * self.LINE + self.AHEAD

    def after(self, found: Instruction, following: Instruction) -> int:
        return 0
