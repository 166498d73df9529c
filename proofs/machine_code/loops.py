"""The table of loop bounds, and of the functions to prove.

    cut FUNCTION KIND COUNT FILE TEXT   In functions that match, an instruction of a line of FILE
                                        that contains TEXT executes at most COUNT times per call
                                        ("-": the proof leaves it open). With "-" for FILE, TEXT is
                                        a branch's condition: for code without lines.
    apart FUNCTION                      Calls of it cost only the call instruction.
    root NAME FUNCTION                  A function to prove, under a name.

FUNCTION: a regular expression for names as in the source, with arguments. FILE: a file name in any
subfolder of the sources; the file must contain TEXT.
"""
from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from .instruction import Instruction, Refused
from .program import Function, Program


@dataclass(frozen=True)
class Kind:
    """The name of a loop's turns, and their number per call; None: left open."""
    name: str
    count: int | None


@dataclass(frozen=True)
class Cut:
    function: str
    kind: Kind
    file: str
    text: str
    lines: frozenset[int]

    def has(self, program: Program, instruction: Instruction) -> bool:
        if self.file == "-":
            return instruction.name == self.text
        file, line = program.line_at(instruction.address)
        return line in self.lines and file == self.file


class Loops:
    def __init__(self, table: str, sources: str):
        self.cuts: list[Cut] = []
        self.roots: dict[str, str] = {}
        self._sources = Path(sources)
        self._apart: list[str] = []
        self._read_table(Path(table))

    def _read_table(self, path: Path) -> None:
        for line in path.read_text().splitlines():
            if line.strip() and not line.startswith("#"):
                self._read(line, path)

    def _read(self, line: str, path: Path) -> None:
        word, *rest = line.split(None, 5)
        match word, rest:
            case "cut", [function, name, count, file, text]:
                kind = Kind(name, None if count == "-" else int(count))
                self.cuts.append(Cut(function, kind, file, text, self._lines(file, text)))
            case "apart", [function]:
                self._apart.append(function)
            case "root", [name, function]:
                self.roots[name] = function
            case _:
                raise Refused(f"not understood: {line}")

    def _lines(self, file: str, text: str) -> frozenset[int]:
        """The lines of all files with this name."""
        if file == "-":
            return frozenset()
        found = frozenset(number for path in self._sources.rglob(file) for number, line
                          in enumerate(path.read_text().splitlines(), 1) if text in line)
        if not found:
            raise Refused(f"no '{text}' in {file}")
        return found

    def is_apart(self, function: Function) -> bool:
        return any(map(function.matches, self._apart))

    def marks(self, program: Program, function: Function,
              code: dict[int, Instruction]) -> dict[int, Kind]:
        """The instructions of a function that the table mentions."""
        return {address: cut.kind for cut in self.cuts if function.matches(cut.function)
                for address, found in code.items() if cut.has(program, found)}
