"""stack.py PROGRAM TABLE TAGS FOLDER:... OUTPUT RUN...

The worst-case stack of the functions with a limit in TABLE (stack.txt), by the call graph of the linked PROGRAM's
machine code. Each function's frame must equal the compiler's, which -fcallgraph-info=su left in each FOLDER.

Fails if a stack exceeds its limit, or if a painted stack, which the command RUN prints, is above its call graph or more
than 16 bytes below. Recursion, a frame of no fixed size, an indirect call or an unknown function are
errors unless the table names them. TAGS: the core's tags, separated by commas. Writes to OUTPUT
    stack NAME graph|painted BYTES
    object NAME BYTES                 the caller's, as RUN prints it
    path NAME FUNCTION BYTES > ...    the frame of each function on the deepest path
"""
from __future__ import annotations

import re
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Iterator

from machine_code.frames import Frame, frame_of
from machine_code.graph import Graph
from machine_code.instruction import Refused
from machine_code.program import Function, Program

NODE = re.compile(r'title: "(?:[^"]*:)?\*?([^":]*)".*?(\d+) bytes \((.*?)\)')
PAINTED = re.compile(r"^stack (\w+) painted (\d+)$", re.M)
OUTPUT = re.compile(r"^(?:stack|object) .*$", re.M)
MOST_APART = 16  # a frame's lower end may never be written
COLUMNS = "thumb2", "thumb1", "riscv"  # of a function's limits


class Table:
    def __init__(self, path: str, tags: list[str]):
        rows = [line.split(None, 5) for line in Path(path).read_text().splitlines() if line and line[0] != "#"]
        self.outside = "^(" + "|".join(row[1] for row in rows if row[0] == "outside") + ")$"
        self.assembly = {row[1]: int(row[2]) for row in rows if row[0] == "assembly" and row[3] in tags}
        column = next(i for i, tag in enumerate(COLUMNS) if tag in tags)
        self.limits = {row[1]: (row[5], int(row[2 + column])) for row in rows if row[0] == "limit"}


def compilers_frames(folders: str) -> dict[str, set[int]]:
    """The frames of each function compiled here; a template's instance may have several."""
    frames: dict[str, set[int]] = {}
    for path in (path for folder in folders.split(":") for path in Path(folder).rglob("*.ci")):
        for name, size, kind in NODE.findall(path.read_text()):
            if kind != "static":
                raise Refused(f"{name} has a frame of no fixed size")
            frames.setdefault(name, set()).add(int(size))
    if not frames:
        raise Refused(f"no call graph in {folders}")
    return frames


@dataclass(frozen=True)
class Depth:
    size: int
    path: tuple[tuple[str, int], ...]  # each function with its frame


class StackGraph:
    def __init__(self, program: Program, table: Table, frames: dict[str, set[int]]):
        self._program, self._table, self._frames = program, table, frames
        self._known: dict[Function, Depth | None] = {}  # None: on the path

    def of(self, pattern: str) -> Depth:
        return self._depth(self._program.matching(pattern))

    def _depth(self, function: Function) -> Depth:
        if function not in self._known:
            self._known[function] = None
            frame, callees = self._checked(function)
            deepest = Depth(frame.size, ((str(function), frame.size),))
            for address, callee in callees.items():
                below = self._depth(callee)
                size = frame.held[address] + below.size
                if size > deepest.size:
                    deepest = Depth(size, ((str(function), frame.size),) + below.path)
            self._known[function] = deepest
        found = self._known[function]
        if found is None:
            raise Refused(f"recursion through {function}")
        return found

    def _checked(self, function: Function) -> tuple[Frame, dict[int, Function]]:
        compilers = set().union(*(self._frames.get(name, ()) for name in function.names))
        if not compilers and not any(re.match(self._table.outside, name) for name in function.names):
            raise Refused(f"not in the table: {function}")
        graph = Graph(self._program, function)
        frame = frame_of(graph)
        wanted = {size for pattern, size in self._table.assembly.items() if function.matches(pattern)} or compilers
        if compilers and frame.size not in wanted:
            raise Refused(f"{function}: the machine code takes {frame.size} bytes, not " +
                          " or ".join(map(str, sorted(wanted))))
        if any(map(graph.unknown_call, graph.code)):
            raise Refused(f"indirect call in {function}")
        return frame, graph.callees


def painted(run: tuple[str, ...], graphs: dict[str, int]) -> Iterator[str]:
    """The lines about stacks and objects. Refuses a painted stack that disagrees with its call graph."""
    text = subprocess.run(run, check=True, stdout=subprocess.PIPE, text=True).stdout
    for name, size in PAINTED.findall(text):
        if not 0 <= graphs[name] - int(size) <= MOST_APART:
            raise Refused(f"{name}: painted {size} bytes, by the call graph {graphs[name]}")
    yield from OUTPUT.findall(text)


def main(program: str, table: str, tags: str, folders: str, output: str, *run: str) -> None:
    Path(output).unlink(missing_ok=True)
    limits = Table(table, tags.split(","))
    graph = StackGraph(Program(program), limits, compilers_frames(folders))
    lines, over, graphs = [], [], {}
    for name, (pattern, most) in limits.limits.items():
        depth = graph.of(pattern)
        graphs[name] = depth.size
        lines += [f"stack {name} graph {depth.size}",
                  f"path {name} " + " > ".join(f"{function} {size}" for function, size in depth.path)]
        over += [f"{name}: {depth.size} bytes, more than {most}"] if depth.size > most else []
    if not over:
        lines += painted(run, graphs)
    print("\n".join(lines))
    if over:
        raise Refused("\n".join(over))
    Path(output).write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except Refused as refusal:
        sys.exit(f"stack.py: {refusal}")
