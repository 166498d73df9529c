"""The table of the bounds of loops, and of the functions that a proof is about.

    cut FUNCTION KIND COUNT FILE TEXT   In functions that match, an instruction of a line of FILE
                                        that has TEXT is executed at most COUNT times a call ("-":
                                        the proof leaves it open). With "-" for FILE, TEXT is a
                                        branch's condition: for code without lines.
    apart FUNCTION                      Calls of it count as the call alone.
    special FUNCTION                    The same, where only the general case is proven.
    root NAME FUNCTION                  What to prove, under a name.

FUNCTION: a regular expression of names as in the source, with arguments. FILE: its name, wherever
it lies in the folder of sources; TEXT has to be in there.
"""
from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from .instruction import Instruction, Refused
from .program import Function, Program


@dataclass(frozen=True)
class Kind:
    """What a loop's turns are called, and how many there are in a call; None: left open."""
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
        self._special: list[str] = []
        for line in Path(table).read_text().splitlines():
            if line.strip() and not line.startswith("#"):
                self._read(line)

    def _read(self, line: str) -> None:
        word, *rest = line.split(None, 5)
        match word, rest:
            case "cut", [function, name, count, file, text]:
                kind = Kind(name, None if count == "-" else int(count))
                self.cuts.append(Cut(function, kind, file, text, self._lines(file, text)))
            case "apart", [function]:
                self._apart.append(function)
            case "special", [function]:
                self._special.append(function)
            case "root", [name, function]:
                self.roots[name] = function
            case _:
                raise Refused(f"not understood: {line}")

    def _lines(self, file: str, text: str) -> frozenset[int]:
        """Of all files of that name."""
        if file == "-":
            return frozenset()
        found = frozenset(number for path in self._sources.rglob(file) for number, line
                          in enumerate(path.read_text().splitlines(), 1) if text in line)
        if not found:
            raise Refused(f"no '{text}' in {file}")
        return found

    def is_apart(self, function: Function, general: bool) -> bool:
        return any(function.matches(pattern)
                   for pattern in self._apart + (self._special if general else []))

    def marks(self, program: Program, function: Function,
              code: dict[int, Instruction]) -> dict[int, Kind]:
        """The instructions of a function that the table speaks of."""
        return {address: cut.kind for cut in self.cuts if function.matches(cut.function)
                for address, found in code.items() if cut.has(program, found)}
