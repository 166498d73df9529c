"""A linked program: its functions, their code, and their source lines."""
from __future__ import annotations

import re
import subprocess
from bisect import bisect_left, bisect_right
from dataclasses import dataclass
from functools import cached_property
from pathlib import PurePath
from typing import Iterator

from elftools.dwarf.lineprogram import LineProgram
from elftools.elf.constants import SH_FLAGS
from elftools.elf.elffile import ELFFile

from .disassembly import disassemble
from .instruction import Instruction, Refused


@dataclass(frozen=True)
class Function:
    address: int
    end: int
    names: tuple[str, ...]  # in the linker's form
    titles: tuple[str, ...]  # in the source's form, with their arguments

    def matches(self, pattern: str) -> bool:
        return any(re.search(pattern, title) for title in self.titles)

    def __str__(self) -> str:
        return self.names[0]


class Program:
    def __init__(self, path: str):
        self._path = path
        with open(path, "rb") as file:
            elf = ELFFile(file)
            self._machine = elf["e_machine"]
            self._sections = {i: range(s["sh_addr"], s["sh_addr"] + s["sh_size"])
                              for i, s in enumerate(elf.iter_sections())
                              if s["sh_flags"] & SH_FLAGS.SHF_EXECINSTR}
            self._read_symbols(elf)

    def _read_symbols(self, elf: ELFFile) -> None:
        names: dict[int, list[str]] = {}
        sizes: dict[int, int] = {}
        for symbol in elf.get_section_by_name(".symtab").iter_symbols():
            kind, address = symbol["st_info"]["type"], symbol["st_value"]
            is_marked = symbol.name[:1] in ("", "$")  # the start of code or data
            if address in self._sections.get(symbol["st_shndx"], ()) and not is_marked and \
                    kind in ("STT_FUNC", "STT_NOTYPE"):
                address &= ~1 if self._machine == "EM_ARM" else ~0
                names.setdefault(address, []).append(symbol.name)
                sizes[address] = max(sizes.get(address, 0), symbol["st_size"])
        self._names, self._sizes = names, sizes

    @cached_property
    def functions(self) -> dict[int, Function]:
        """By address: everything between two symbols of the code is a function, up to its size."""
        starts = sorted(self._names)
        flat = [name for start in starts for name in self._names[start]]
        titles = dict(zip(flat, subprocess.run(["c++filt"], input="\n".join(flat), text=True,
                                               capture_output=True, check=True).stdout.split("\n")))
        found = {}
        for start, following in zip(starts, starts[1:] + [1 << 32]):
            section = next(section for section in self._sections.values() if start in section)
            names = tuple(self._names[start])
            # Constants may follow the last function.
            size = self._sizes[start] or section.stop - start
            found[start] = Function(start, min(following, section.stop, start + size), names,
                                    tuple(titles[name] for name in names))
        return found

    def matching(self, pattern: str) -> Function:
        """The one function that a regular expression matches."""
        found = [f for f in self.functions.values() if f.matches(pattern)]
        if len(found) != 1:
            raise Refused(f"{len(found)} functions match {pattern}")
        return found[0]

    def at(self, address: int) -> Function:
        """The function that contains an instruction."""
        starts = self._starts
        function = self.functions[starts[bisect_right(starts, address) - 1]]
        if not function.address <= address < function.end:
            raise Refused(f"{address:x}: out of the code")
        return function

    @cached_property
    def _starts(self) -> list[int]:
        return sorted(self.functions)

    def code_of(self, function: Function) -> dict[int, Instruction]:
        """All instructions of a function, in the order of their addresses."""
        first, last = (bisect_left(self.code, at, key=lambda found: found.address)
                       for at in (function.address, function.end))
        return {found.address: found for found in self.code[first:last]}

    @cached_property
    def code(self) -> list[Instruction]:
        return sorted(disassemble(self._path, self._machine), key=lambda found: found.address)

    def line_at(self, address: int) -> tuple[str, int]:
        """File, without its folder, and line."""
        i = bisect_right(self._lines, address, key=lambda line: line[0]) - 1
        return self._lines[i][1:] if i >= 0 else ("", 0)

    @cached_property
    def _lines(self) -> list[tuple[int, str, int]]:
        with open(self._path, "rb") as file:
            return _read_lines(ELFFile(file))

    def place(self, address: int) -> str:
        """The place of an instruction, for messages."""
        file, line = self.line_at(address)
        return f"{address:x} in {self.at(address)}" + (f" ({file}:{line})" if file else "")


def _read_lines(elf: ELFFile) -> list[tuple[int, str, int]]:
    """The starts of source lines; an empty file name if unknown."""
    rows: dict[int, tuple[str, int]] = {}
    dwarf = elf.get_dwarf_info() if elf.has_dwarf_info() else None
    for unit in dwarf.iter_CUs() if dwarf else ():
        program = dwarf.line_program_for_CU(unit)
        if program is not None:
            files = [PurePath(entry.name.decode()).name for entry in program["file_entry"]]
            first = 0 if program["version"] >= 5 else 1
            for sequence in _sequences(program):
                for state in sequence[:-1]:
                    rows[state.address] = (files[state.file - first], state.line)
                rows.setdefault(sequence[-1].address, ("", 0))
    return sorted((address, *line) for address, line in rows.items())


def _sequences(program: LineProgram) -> Iterator[list]:
    """Rows of one stretch of code each, with the row after it last; code removed by the linker is at 0."""
    sequence: list = []
    for entry in program.get_entries():
        if entry.state is not None:
            sequence.append(entry.state)
            if entry.state.end_sequence:
                if sequence[0].address != 0:
                    yield sequence
                sequence = []
