"""The library as a header and a source: flashbvh.hpp and .cpp, flashbvh.h for C, and the layer for robots as
flashbvh_robot.hpp and .cpp.

Each file appears once, where it is first included, with its own include guard. A file that is first included
within a condition appears there and again at its next include; the guard keeps the first copy that is compiled.
flashbvh/ has a header of one line for each of the library's headers, so that baked files and the documents'
examples compile unchanged.
"""
from __future__ import annotations

import re
from pathlib import Path

INCLUDE = re.compile(r'\s*#\s*include\s+"([^"]+)"')
CONDITION = re.compile(r"\s*#\s*(if|endif)")


class Amalgamation:
    def __init__(self, include: Path, files: list[Path], *known: Amalgamation) -> None:
        self.include = include
        self.whole = set().union(*(one.whole for one in known))  # files included outside of conditions
        self.lines: list[str] = []
        for file in files:
            self.add(file, True)

    def find(self, name: str, includer: Path) -> Path:
        beside = (includer.parent / name).resolve()
        return beside if beside.is_file() else self.include / name

    def add(self, file: Path, everywhere: bool) -> None:
        if file in self.whole:
            return
        if everywhere:
            self.whole.add(file)
        guard = 1 if file.suffix in (".h", ".hpp") else 0
        depth = 0
        for line in file.read_text().split("\n"):
            included = INCLUDE.match(line)
            if included:
                self.add(self.find(included[1], file), everywhere and depth == guard)
                continue
            condition = CONDITION.match(line)
            if condition:
                depth += 1 if condition[1] == "if" else -1
            self.lines.append(line)

    def write(self, file: Path, title: str, includes: list[str]) -> None:
        head = [f"/* {title}: made of lib/ by tools/release.sh. MIT licence: LICENSE. */"]
        once = "#pragma once" if file.suffix != ".cpp" else ""
        text = "\n".join([*head, once, *(f'#include "{name}"' for name in includes), "", *self.lines])
        file.write_text(re.sub(r"\n{3,}", "\n\n", text).rstrip("\n") + "\n")


def write_amalgamation(lib: Path, target: Path, sources: list[str], robot_sources: list[str]) -> None:
    include = (lib / "include").resolve()
    headers = [h for h in sorted(include.rglob("*.h*"))
               if "detail" not in h.relative_to(include).parts]
    robot = [header for header in headers if header.parent.name == "robot"]
    c = Amalgamation(include, [h for h in headers if h.suffix == ".h"])
    cxx = Amalgamation(include, [h for h in headers if h.suffix == ".hpp" and h not in robot])
    guards = Amalgamation(include, robot, cxx)
    code = Amalgamation(include, [(lib / name).resolve() for name in sources], c, cxx)
    guards_code = Amalgamation(include, [(lib / name).resolve() for name in robot_sources], c, guards)

    c.write(target / "flashbvh.h", "flashbvh, from C", [])
    cxx.write(target / "flashbvh.hpp", "flashbvh", [])
    code.write(target / "flashbvh.cpp", "flashbvh", ["flashbvh.h", "flashbvh.hpp"])
    guards.write(target / "flashbvh_robot.hpp", "flashbvh's layer for robots", ["flashbvh.hpp"])
    guards_code.write(target / "flashbvh_robot.cpp", "flashbvh's layer for robots",
                      ["flashbvh.h", "flashbvh_robot.hpp"])
    for header in headers:
        name = header.relative_to(include)
        whole = ("flashbvh.h" if header in c.whole else
                 "flashbvh.hpp" if header in cxx.whole else "flashbvh_robot.hpp")
        (target / name).parent.mkdir(parents=True, exist_ok=True)
        (target / name).write_text(f'#include "{"../" * (len(name.parts) - 1)}{whole}"\n')
