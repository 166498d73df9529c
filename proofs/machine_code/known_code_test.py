"""known_code_test.py arm|riscv COMPILER FLAG...

Checks the longest paths and the frames of known code, and refusals of code without them. COMPILER, with its flags,
assembles and links all cases at once.
"""
from __future__ import annotations

import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from known_code import CASES, LOOP_CASES, SOURCE, Case
from machine_code.cost import Costs
from machine_code.frames import frame_of
from machine_code.graph import Graph
from machine_code.instruction import Refused
from machine_code.loops import Loops
from machine_code.program import Program


def own_names(text: str, number: int) -> str:
    """Renames the functions f and g of a case, so that each case has its own."""
    return re.sub(r"\b([fg])\b", rf"\1_{number}", text)


def assembly(cases: list[Case], is_arm: bool) -> str:
    lines = ['.file 1 "source.c"', ".text"]
    if is_arm:
        lines += [".syntax unified", ".arch armv8.1-m.main", ".thumb"]
    for number, case in enumerate(cases):
        lines += [".balign 4", ".loc 1 1", "f:"]
        for part in re.split(r"[;\n]", case.code):
            part = part.strip()
            lines.append(f".loc 1 {part[1:]}" if part.startswith("/") else part)
        lines = [own_names(line, number) for line in lines]
        names = [name[:-1] for name in lines if re.fullmatch(rf"[fg]_{number}:", name)]
        lines += [f".type {name}, %function" for name in names]
    return "\n".join(lines) + "\n"


class KnownCode(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        (self.folder / "source.c").write_text(SOURCE)
        architecture, *compiler = sys.argv[1:]
        self.cases = CASES[architecture] + (LOOP_CASES if architecture == "arm" else [])
        (self.folder / "code.s").write_text(assembly(self.cases, architecture == "arm"))
        (self.folder / "layout.ld").write_text("SECTIONS { .text 0x1000 : { KEEP(*(.text)) } }")
        subprocess.run([*compiler, "-g", "-nostdlib", "-T", "layout.ld", "code.s", "-o",
                        "code.elf"], cwd=self.folder, check=True)
        self.program = Program(str(self.folder / "code.elf"))

    def found(self, number: int, case: Case) -> str:
        """The longest path and the frame, or the refusal."""
        table = self.folder / "table"
        table.write_text(own_names(case.table, number))
        root = f"^f_{number}$"
        try:
            if case.what.endswith("frame"):
                graph = Graph(self.program, self.program.matching(root))
                frame = frame_of(graph)
                return " ".join(map(str, [frame.size, *frame.held.values()]))
            costs = Costs(self.program, Loops(str(table), str(self.folder)))
            return str(costs.of(root))
        except Refused as refusal:
            return f"refused: {refusal}"

    def test_cases(self) -> None:
        for number, case in enumerate(self.cases):
            with self.subTest(case.name):
                found = self.found(number, case)
                if case.what.startswith("refused"):
                    self.assertIn("refused: ", found)
                    self.assertIn(case.wanted, found)
                else:
                    self.assertEqual(case.wanted, found)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
