"""RV32IM, compressed instructions or not: where an instruction leads and how it moves sp."""
from __future__ import annotations

from typing import Iterator

from .instruction import Flow, Instruction, signed

RA, SP = 1, 2


def decode(code: bytes, address: int) -> Iterator[Instruction]:
    """All instructions of a range, one after the other."""
    at = 0
    while at + 2 <= len(code):
        half = int.from_bytes(code[at:at + 2], "little")
        if half & 3 == 3:
            found = full(address + at, int.from_bytes(code[at:at + 4], "little"))
        else:
            found = compressed(address + at, half)
        yield found
        at += found.size


def scattered(code: int, *runs: tuple[int, ...]) -> int:
    """A constant with sign, its bits anywhere: each run has its first bit in the code, and which
    bits of the constant that one and those after it are. The first of all is the sign."""
    value = 0
    for first, *places in runs:
        for i, place in enumerate(places):
            value |= (code >> (first - i) & 1) << place
    return signed(value, runs[0][1] + 1)


def full(at: int, code: int) -> Instruction:
    """Of 32 bits."""
    kind, target, base = code & 0x7F, code >> 7 & 31, code >> 15 & 31
    if kind == 0x6F:  # jal
        to = at + scattered(code, (31, 20), (30, *range(10, 0, -1)), (20, 11),
                            (19, *range(19, 11, -1)))
        return linked(at, 4, target, to)
    if kind == 0x67:  # jalr
        if target == 0 and base == RA and code >> 20 == 0:
            return Instruction(at, 4, Flow.LEAVE, falls_through=False)
        return linked(at, 4, target, None)
    if kind == 0x63:
        offset = scattered(code, (31, 12), (30, *range(10, 4, -1)), (11, *range(4, 0, -1)), (7, 11))
        return Instruction(at, 4, Flow.JUMP, at + offset)
    if kind == 0x73 and code >> 12 & 7 == 0:  # ecall, ebreak, mret, wfi
        return Instruction(at, 4, Flow.STOP)
    if kind in (0x23, 0x27):  # stores
        return Instruction(at, 4)
    if target != SP:
        return Instruction(at, 4, name="nop" if code == 0x13 else "")
    is_constant = kind == 0x13 and code >> 12 & 7 == 0 and base == SP  # addi sp, sp
    return Instruction(at, 4, grows=-signed(code >> 20, 12) if is_constant else None)


def linked(at: int, size: int, link: int, to: int | None) -> Instruction:
    """A jump that keeps where it came from in a register."""
    if link == RA:
        return Instruction(at, size, Flow.CALL, to)
    if link != 0:
        return Instruction(at, size, Flow.STOP)
    # Only the run knows where to: maybe to a function.
    flow = Flow.JUMP if to is not None else Flow.CALL
    return Instruction(at, size, flow, to, falls_through=False)


def compressed(at: int, code: int) -> Instruction:
    """Of 16 bits."""
    kind = (code & 3, code >> 13)
    target, other = code >> 7 & 31, code >> 2 & 31
    if code in (0, 1):  # Zero is no instruction, and fills gaps.
        return Instruction(at, 2, Flow.NEXT if code else Flow.STOP, name="nop")
    if kind in ((1, 1), (1, 5)):  # c.jal, c.j
        offset = scattered(code, (12, 11, 4, 9, 8, 10, 6, 7, 3, 2, 1, 5))
        return linked(at, 2, RA if kind == (1, 1) else 0, at + offset)
    if kind in ((1, 6), (1, 7)):  # c.beqz, c.bnez
        offset = scattered(code, (12, 8, 4, 3), (6, 7, 6, 2, 1, 5))
        return Instruction(at, 2, Flow.JUMP, at + offset)
    if kind == (2, 4) and other == 0:  # c.jr, c.jalr, c.ebreak
        if code == 0x8082:
            return Instruction(at, 2, Flow.LEAVE, falls_through=False)
        return linked(at, 2, code >> 12 & 1, None) if target else Instruction(at, 2, Flow.STOP)
    if target != SP or kind[0] == 0 or kind in ((1, 4), (2, 5), (2, 6), (2, 7)):
        return Instruction(at, 2)  # stores, and what writes no more than eight registers
    if kind == (1, 3):
        return Instruction(at, 2, grows=-scattered(code, (12, 9), (6, 4, 6, 8, 7, 5)))
    if kind == (1, 0):
        return Instruction(at, 2, grows=-scattered(code, (12, 5), (6, 4, 3, 2, 1, 0)))
    return Instruction(at, 2, grows=None)
