"""Thumb, Armv6-M to Armv8.1-M: where an instruction leads and how it moves sp.

Encodings: Arm DDI 0553, chapter C2. What is known to leave pc and sp alone is plain; what is
neither that nor understood is Flow.STOP, or moves sp by no constant.
"""
from __future__ import annotations

from dataclasses import replace
from typing import Iterator

from .instruction import Flow, Instruction, signed

SP, LR, PC = 13, 14, 15
CONDITIONS = "eq ne cs cc mi pl vs vc hi ls ge lt gt le".split()
NARROW_NOPS = (0x0000, 0x46C0, 0xBF00)  # movs r0, r0; mov r8, r8; nop


def decode(code: bytes, address: int) -> Iterator[Instruction]:
    """All instructions of a range, one after the other."""
    conditional = 0  # instructions left in an IT block
    at = 0
    while at + 2 <= len(code):
        first = int.from_bytes(code[at:at + 2], "little")
        if first < 0xE800:
            found = narrow(address + at, first)
        else:
            found = wide(address + at, first, int.from_bytes(code[at + 2:at + 4], "little"))
        if conditional:
            conditional -= 1
            found = skippable(found)
        elif first >> 8 == 0xBF and first & 15:
            conditional = 5 - (first & -first).bit_length()
        yield found
        at += found.size


def skippable(found: Instruction) -> Instruction:
    """An instruction that its condition may skip."""
    if found.flow in (Flow.JUMP, Flow.CALL, Flow.LEAVE):
        return replace(found, falls_through=True)
    return replace(found, grows=None) if found.grows else found


def narrow(at: int, code: int) -> Instruction:
    """Of 16 bits."""
    top = code >> 8
    if code in NARROW_NOPS:
        return Instruction(at, 2, name="nop")
    if top >> 4 == 0xD and top < 0xDE:
        return Instruction(at, 2, Flow.JUMP, at + 4 + 2 * signed(code, 8),
                           name="b" + CONDITIONS[top & 15])
    if code >> 11 == 0b11100:
        return Instruction(at, 2, Flow.JUMP, at + 4 + 2 * signed(code, 11), falls_through=False)
    if code & 0xF500 == 0xB100:  # cbz, cbnz
        return Instruction(at, 2, Flow.JUMP, at + 4 + (code >> 3 & 0x40 | code >> 2 & 0x3E))
    if code & 0xFF87 == 0x4700 and code >> 3 & 15 == LR:
        return Instruction(at, 2, Flow.LEAVE, falls_through=False)
    if top == 0x47:  # bx, blx
        return Instruction(at, 2, Flow.CALL, falls_through=bool(code & 0x80))
    if top in (0x44, 0x46):  # add and mov with all registers
        return writes(at, 2, code & 7 | code >> 4 & 8)
    if top == 0xB0:
        return Instruction(at, 2, grows=4 * (code & 0x7F) * (1 if code & 0x80 else -1))
    if code & 0xFE00 == 0xB400:
        return Instruction(at, 2, grows=4 * (code & 0x1FF).bit_count())
    if code & 0xFE00 == 0xBC00:
        return pops(at, 2, 4 * (code & 0x1FF).bit_count(), bool(code & 0x100))
    if top in (0xDE, 0xDF, 0xBE) or code & 0xFFC0 == 0xBA80:  # udf, svc, bkpt, hlt
        return Instruction(at, 2, Flow.STOP)
    return Instruction(at, 2)


def writes(at: int, size: int, register: int) -> Instruction:
    """A register is written with what only the run knows."""
    if register == PC:
        return Instruction(at, size, Flow.JUMP, falls_through=False)
    return Instruction(at, size, grows=None if register == SP else 0)


def pops(at: int, size: int, bytes_: int, returns: bool) -> Instruction:
    if returns:
        return Instruction(at, size, Flow.LEAVE, falls_through=False, grows=-bytes_)
    return Instruction(at, size, grows=-bytes_)


def wide(at: int, first: int, second: int) -> Instruction:
    """Of 32 bits."""
    group = first >> 9
    if first & 0xEC00 == 0xEC00:
        return coprocessor(at, first, second)
    if group == 0x74:
        return several(at, first, second)
    if group == 0x7C:
        return single(at, first, second)
    if first >> 11 == 0b11110 and second & 0x8000:
        return branch(at, first, second)
    if group == 0x75 or first >> 11 == 0b11110:
        return arithmetic(at, first, second)
    return Instruction(at, 4)  # group 0x7D: arithmetic with registers, neither sp nor pc


def arithmetic(at: int, first: int, second: int) -> Instruction:
    """With a shifted register or a constant."""
    target = second >> 8 & 15
    if first & 0xFB4F in (0xF10D, 0xF20D) and target == SP:
        # add, sub, addw, subw: sp and a constant
        constant = (first & 0x400) << 1 | second >> 4 & 0x700 | second & 0xFF
        constant = constant if first & 0x200 else expanded(constant)
        return Instruction(at, 4, grows=constant if first & 0xA0 == 0xA0 else -constant)
    if target == PC:
        return Instruction(at, 4, Flow.NEXT if first & 0x10 else Flow.STOP)  # a comparison
    return writes(at, 4, target)


def expanded(constant: int) -> int:
    """ThumbExpandImm."""
    byte = constant & 0xFF
    if constant < 0x400:
        return byte * (1, 0x10001, 0x1000100, 0x1010101)[constant >> 8]
    return (byte | 0x80) << 32 >> (constant >> 7) & 0xFFFFFFFF


def coprocessor(at: int, first: int, second: int) -> Instruction:
    """Floating point and vectors; of these, only loads and stores that write sp back move it."""
    if first & 0xEE20 != 0xEC20 or first & 15 != SP:
        return Instruction(at, 4)
    if first & 0xFE00 != 0xEC00 or second & 0x0E00 != 0x0A00:
        return Instruction(at, 4, grows=None)
    bytes_ = 4 * (second & 0xFF)  # vpush, vpop
    return Instruction(at, 4, grows=-bytes_ if first & 0x80 else bytes_)


def several(at: int, first: int, second: int) -> Instruction:
    """Loads and stores of several registers, and branches by a table."""
    is_load, writes_back, up = bool(first & 0x10), bool(first & 0x20), bool(first & 0x80)
    base = first & 15
    if first & 0xFFF0 == 0xE8D0 and second & 0xFFE0 == 0xF000:  # tbb, tbh
        return Instruction(at, 4, Flow.JUMP, falls_through=False)
    if first & 0x40:  # two registers
        bytes_, returns = 4 * (second & 0xFF), False
    else:
        bytes_, returns = 4 * second.bit_count(), is_load and bool(second & 0x8000)
        if bool(first & 0x100) == up or returns and base != SP:
            return Instruction(at, 4, Flow.STOP)
    if base != SP or not writes_back:
        return Instruction(at, 4, Flow.STOP if returns else Flow.NEXT)
    return pops(at, 4, bytes_, returns) if up else Instruction(at, 4, grows=bytes_)


def single(at: int, first: int, second: int) -> Instruction:
    """Loads and stores of one register."""
    loads_word, base, register = first & 0x170 == 0x50, first & 15, second >> 12
    writes_back = not first & 0x80 and base != PC and second & 0x900 == 0x900
    bytes_ = second & 0xFF if second & 0x200 else -(second & 0xFF)
    if loads_word and register == PC:
        if base == SP and writes_back and bytes_ > 0 and not second & 0x400:
            return pops(at, 4, bytes_, True)
        return Instruction(at, 4, Flow.JUMP, falls_through=False)
    if loads_word and register == SP:
        return Instruction(at, 4, grows=None)
    return Instruction(at, 4, grows=-bytes_ if writes_back and base == SP else 0)


def branch(at: int, first: int, second: int) -> Instruction:
    """Branches and what stands among them."""
    sign = first >> 10 & 1
    if second & 0x5000 == 0x4000:
        return low_overhead(at, first, second)
    if second & 0x1000:  # bl, b.w
        high = sign << 2 | (~(second >> 13 ^ sign) & 1) << 1 | ~(second >> 11 ^ sign) & 1
        offset = signed(high << 22 | (first & 0x3FF) << 12 | (second & 0x7FF) << 1, 25)
        if second & 0x4000:
            return Instruction(at, 4, Flow.CALL, at + 4 + offset)
        return Instruction(at, 4, Flow.JUMP, at + 4 + offset, falls_through=False)
    if first >> 7 & 7 != 7:
        high = sign << 2 | second >> 10 & 2 | second >> 13 & 1
        offset = signed(high << 18 | (first & 0x3F) << 12 | (second & 0x7FF) << 1, 21)
        return Instruction(at, 4, Flow.JUMP, at + 4 + offset,
                           name="b" + CONDITIONS[first >> 6 & 15])
    if first >> 5 == 0xF380 >> 5:  # msr, maybe of a stack's pointer
        return Instruction(at, 4, grows=None if second & 0x7E == 8 else 0)
    plain = first >> 4 in (0xF3A, 0xF3B, 0xF3E, 0xF3F)  # hints, barriers, mrs
    return Instruction(at, 4, Flow.NEXT if plain else Flow.STOP,
                       name="nop" if (first, second) == (0xF3AF, 0x8000) else "")


def low_overhead(at: int, first: int, second: int) -> Instruction:
    """The loops of Armv8.1-M: le, wls, dls."""
    offset = (second & 0x7FE) << 1 | second >> 10 & 2
    if second & 0xF001 == 0xC001 and first in (0xF00F, 0xF02F):
        return Instruction(at, 4, Flow.JUMP, at + 4 - offset)
    if second & 0xF001 == 0xC001 and first & 0xFFF0 == 0xF040:
        return Instruction(at, 4, Flow.JUMP, at + 4 + offset)
    if second == 0xE001 and first & 0xFFF0 == 0xF040:
        return Instruction(at, 4)
    return Instruction(at, 4, Flow.STOP)
