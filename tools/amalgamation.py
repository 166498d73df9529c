#!/usr/bin/env python3
"""amalgamation.py DIR    The library as a header and a source: flashbvh.hpp and .cpp, flashbvh.h for C, and the layer for
robots as flashbvh_robot.hpp and .cpp. With library.properties, DIR is also a library of Arduino.

Each file appears once, where it is first included, with its own include guard. A file that is first included
within a condition appears there and again at its next include; the guard keeps the first copy that is compiled.
flashbvh/ has a header of one line for each of the library's headers, so that baked files and the documents'
examples compile unchanged.
"""
from __future__ import annotations

import re
import sys
from pathlib import Path

LIB = Path(__file__).resolve().parents[1] / "lib"
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
        text = file.read_text()
        if "#pragma once\n" in text:
            name = "FLASHBVH_" + re.sub(r"\W", "_", str(file.relative_to(LIB))).upper()
            text = text.replace("#pragma once\n", f"#ifndef {name}\n#define {name}\n", 1) + "\n#endif"
        guard = 1 if file.suffix in (".h", ".hpp") else 0
        depth = 0
        for line in text.split("\n"):
            included = INCLUDE.match(line)
            if included:
                self.add(self.find(included[1], file), everywhere and depth == guard)
                continue
            condition = CONDITION.match(line)
            if condition:
                depth += 1 if condition[1] == "if" else -1
            self.lines.append(line)

    def write(self, file: Path, *includes: str) -> None:
        head = ["/* flashbvh: made of lib/ by tools/amalgamation.py. MIT licence: LICENSE. */"]
        if file.suffix != ".cpp":
            head.append("#pragma once")
        text = "\n".join([*head, *(f'#include "{name}"' for name in includes), "", *self.lines])
        file.write_text(re.sub(r"\n{3,}", "\n\n", text).rstrip("\n") + "\n")


def main(target: Path) -> None:
    include = LIB / "include"
    headers = [h for h in sorted(include.rglob("*.h*")) if "detail" not in h.relative_to(include).parts]
    robot = [header for header in headers if header.parent.name == "robot"]
    sources = sorted(LIB.glob("src/*/*.cpp"))
    robot_sources = [file for file in sources if re.search(r"/(robot/|c/c_robot_)[^/]*$", str(file))]
    c = Amalgamation(include, [h for h in headers if h.suffix == ".h"])
    language = include / "flashbvh/plain/language.h"  # first, since it refuses an older C++
    cxx = Amalgamation(include, [language, *(h for h in headers if h.suffix == ".hpp" and h not in robot)])
    guards = Amalgamation(include, robot, cxx)
    code = Amalgamation(include, [file for file in sources if file not in robot_sources], c, cxx)
    guards_code = Amalgamation(include, robot_sources, c, guards)

    target.mkdir(parents=True, exist_ok=True)
    c.write(target / "flashbvh.h")
    cxx.write(target / "flashbvh.hpp")
    code.write(target / "flashbvh.cpp", "flashbvh.h", "flashbvh.hpp")
    guards.write(target / "flashbvh_robot.hpp", "flashbvh.hpp")
    guards_code.write(target / "flashbvh_robot.cpp", "flashbvh.h", "flashbvh_robot.hpp")
    for header in headers:
        name = header.relative_to(include)
        whole = ("flashbvh.h" if header in c.whole else
                 "flashbvh.hpp" if header in cxx.whole else "flashbvh_robot.hpp")
        (target / name).parent.mkdir(parents=True, exist_ok=True)
        (target / name).write_text(f'#include "{"../" * (len(name.parts) - 1)}{whole}"\n')
    for file in LIB.parent / "LICENSE", LIB / "README.md":
        (target / file.name).write_text(file.read_text())
    version = ".".join(re.findall(r"_(?:MAJOR|MINOR|PATCH) (\d+)", (include / "flashbvh/version.hpp").read_text()))
    (target / "library.properties").write_text(f"""\
name=flashbvh
version={version}
author=The flashbvh authors
maintainer=The flashbvh authors
sentence=Exact mesh-against-mesh collision and distance queries on a microcontroller.
paragraph=Meshes and robots are baked on the desktop. Answers are the same on every core.
category=Device Control
architectures=*
includes=flashbvh.hpp
license=MIT
""")


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])) if len(sys.argv) == 2 else __doc__)
