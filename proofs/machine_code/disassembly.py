"""The targets of instructions, and their changes of sp, from objdump's output.

A plain instruction is known not to change pc and sp. An instruction that is neither plain nor understood is
Flow.STOP, or changes sp by no constant. The environment's OBJDUMP is the program's.
"""
from __future__ import annotations

import os
import re
import subprocess
from typing import Iterator

from .instruction import Flow, Instruction

LINE = re.compile(r"^ *([0-9a-f]+):\t([0-9a-f ]+?) *\t(\S+)[ \t]*(.*?)(?:[ \t]+[@;#] .*)?$", re.M)
CONDITION = "(eq|ne|cs|cc|mi|pl|vs|vc|hi|ls|ge|lt|gt|le)?"
# Traps, branch-future instructions, and instructions unknown to objdump.
STRANGE = re.compile(r"b|udf|svc|hlt|letp|[dw]lstp|\W")
# Without -m, binutils 2.40 does not know all of Armv8.1-M.
OPTIONS = {"EM_ARM": ["-m", "armv8.1-m.main"], "EM_RISCV": ["-M", "no-aliases"]}


def disassemble(path: str, machine: str) -> Iterator[Instruction]:
    """All instructions of a program, in the order of their addresses in each section."""
    text = subprocess.run([os.environ["OBJDUMP"], *OPTIONS[machine], "-dz", path], check=True, text=True,
                          stdout=subprocess.PIPE).stdout
    read = {"EM_ARM": lambda *words: Thumb(*words).read(), "EM_RISCV": riscv}[machine]
    for address, code, name, operands in LINE.findall(text):
        found = read(int(address, 16), len(code.replace(" ", "")) // 2, name, operands)
        if found:
            yield found


def target_of(operands: str) -> int | None:
    found = re.search(r"\b([0-9a-f]+) <", operands)
    return int(found[1], 16) if found else None


class Thumb:
    """Armv6-M to Armv8.1-M."""

    def __init__(self, at: int, size: int, name: str, operands: str):
        self.at, self.size, self.operands = at, size, operands
        self.name = re.sub(r"\.[nw]$", "", name)
        self.first = re.split("[,!]", operands)[0]

    def is_one_of(self, names: str) -> re.Match | None:
        """Matches names with or without a condition; in an IT block an instruction has one, and may be skipped."""
        return re.fullmatch(f"({names}){CONDITION}", self.name)

    def read(self) -> Instruction | None:
        """Returns None for data."""
        if re.fullmatch(r"\.(word|short|byte)", self.name):
            return None
        if self.name == "nop" or (self.name, self.operands) == ("movs", "r0, r0"):
            return Instruction(self.at, self.size, name="nop")
        if self.is_one_of("bfi|bfc|bic|bics|cmp|cmn|tst|teq|adr|pld|pli|vldr"):
            return Instruction(self.at, self.size)
        return self.branch() or self.plain()

    def branch(self) -> Instruction | None:
        if found := self.is_one_of("b|bl|blx|bx"):
            links, falls = found[1].startswith("bl"), bool(found[2])
            if self.operands == "lr" and not links:
                return Instruction(self.at, self.size, Flow.LEAVE, falls_through=falls)
            target = target_of(self.operands)
            # A branch to a register may be a call.
            flow = Flow.CALL if links or target is None else Flow.JUMP
            return Instruction(self.at, self.size, flow, target, links or falls, name=self.name)
        if self.name in ("cbz", "cbnz", "le", "wls"):
            return Instruction(self.at, self.size, Flow.JUMP, target_of(self.operands))
        if self.is_one_of("tbb|tbh|mov|add|ldr") and self.first in ("pc", "[pc") and \
                not re.match(r"pc, \[sp\], #\d", self.operands):
            return Instruction(self.at, self.size, Flow.JUMP, falls_through=False)
        if re.search(r"(^|[{ ])pc(}|, \[)", self.operands):
            return self.load_of_pc()
        is_strange = "<" in self.operands and not self.is_one_of("ldrs?[bh]|ldrd?")
        return Instruction(self.at, self.size, Flow.STOP) if is_strange or STRANGE.match(self.name) else None

    def load_of_pc(self) -> Instruction:
        grows, found = self.growth(), self.is_one_of("pop|ldmia|ldr")
        if not found or not grows or grows > 0:
            return Instruction(self.at, self.size, Flow.STOP)
        return Instruction(self.at, self.size, Flow.LEAVE, falls_through=bool(found[2]), grows=grows)

    def plain(self) -> Instruction:
        grows = self.growth()
        skipped = self.is_one_of("push|pop|vpush|vpop|ldmia|stmdb|addw?|subw?|strd?|ldrd?")
        return Instruction(self.at, self.size, grows=None if grows and skipped and skipped[2] else grows)

    def growth(self) -> int | None:
        """The growth of the stack; None if it is not a constant."""
        if self.is_one_of("v?push|v?pop") or self.operands.startswith("sp!") and self.is_one_of("ldmia|stmdb"):
            bytes_ = size_of_registers(self.operands)
            return bytes_ if self.is_one_of("v?push|stmdb") else -bytes_
        if found := re.search(r"\[sp, #(-?\d+)\]!|\[sp\], #(-?\d+)", self.operands):
            return None if self.first == "sp" else -int(found[1] or found[2])
        if found := re.fullmatch(r"sp(?:, sp)?, #(\d+)", self.operands):
            if self.is_one_of("addw?|subw?"):
                return int(found[1]) * (1 if self.is_one_of("subw?") else -1)
        writes_back = re.search(r"\bsp!|\[sp[^]]*\]!|\[sp\],", self.operands)
        is_written = self.first.lower() in ("sp", "msp", "psp") and not self.is_one_of("strd?|(st|ld)m(ia|db)")
        return None if writes_back or is_written else 0


def size_of_registers(operands: str) -> int:
    """The size of a register list as {r4-r6, lr} or {d8-d10}."""
    count = 0
    for one, to in re.findall(r"(\w+)(?:-(\w+))?", operands[operands.index("{"):]):
        count += int(to[1:]) - int(one[1:]) + 1 if to else 1
    return count * (8 if "{d" in operands else 4)


def riscv(at: int, size: int, name: str, operands: str) -> Instruction:
    """RV32IM, with or without compressed instructions, without aliases."""
    name = name.removeprefix("c.")
    first, *others = operands.split(",")
    if name in ("nop", "unimp") or name == "addi" and operands in ("zero,0", "zero,zero,0"):
        return Instruction(at, size, Flow.STOP if name == "unimp" else Flow.NEXT, name="nop")
    if name in ("j", "jal", "jr", "jalr"):
        link = first if others else {"j": "zero", "jr": "zero"}.get(name, "ra")
        target = target_of(operands) if name in ("j", "jal") else None
        if link == "zero" and (name, operands) in (("jr", "ra"), ("jalr", "zero,0(ra)")):
            return Instruction(at, size, Flow.LEAVE, falls_through=False)
        if link not in ("zero", "ra"):
            return Instruction(at, size, Flow.STOP)
        # The target is known only at run time: it may be a function.
        flow = Flow.JUMP if link == "zero" and target is not None else Flow.CALL
        return Instruction(at, size, flow, target, link == "ra")
    if name[0] == "b" or name == "ebreak":
        target = target_of(operands)
        return Instruction(at, size, Flow.JUMP if target is not None else Flow.STOP, target)
    if re.match(r"ecall|[msu]ret|wfi|\.", name):
        return Instruction(at, size, Flow.STOP)
    if first != "sp" or name in ("sb", "sh", "sw", "swsp"):
        return Instruction(at, size)
    is_constant = name in ("addi", "addi16sp") and others[:-1] in ([], ["sp"])
    return Instruction(at, size, grows=-int(others[-1]) if is_constant else None)
