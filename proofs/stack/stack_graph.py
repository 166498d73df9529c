"""stack_graph.py PROGRAM ROOTS CALLS TAGS FOLDER:... OUTPUT

The worst-case stack of the functions listed in the file ROOTS, by the call graph of the linked PROGRAM's machine code.
Each function's frame must equal the compiler's, which -fcallgraph-info=su left in each FOLDER.

CALLS (calls.txt) names everything but plain calls of functions compiled here. Recursion, a frame of no fixed size, an
indirect call or an unknown function are errors unless it names them. TAGS: the core's tags, separated by commas.
Writes to OUTPUT, in the order of ROOTS,
    stack ROOT graph BYTES
    path ROOT FUNCTION BYTES > ...    the frame of each function on the deepest path
"""
from __future__ import annotations

import re
import sys
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from machine_code.frames import Frame, frame_of
from machine_code.graph import Graph
from machine_code.instruction import Refused
from machine_code.program import Function, Program

NODE = re.compile(r'title: "(?:[^"]*:)?\*?([^":]*)".*?(\d+) bytes \((.*?)\)')


class Calls:
    """The table calls.txt."""

    def __init__(self, path: str, tags: list[str]):
        rows = [line.split() for line in Path(path).read_text().splitlines()
                if line and not line.startswith("#")]
        self.outside = "^(" + "|".join(row[1] for row in rows if row[0] == "outside") + ")$"
        self.assembly = {row[1]: int(row[2]) for row in rows
                         if row[0] == "assembly" and row[3] in tags}
        self.never = {row[1]: row[2] for row in rows if row[0] == "never"}


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
    def __init__(self, program: Program, calls: Calls, frames: dict[str, set[int]]):
        self._program, self._calls, self._frames = program, calls, frames

    def of(self, root: str) -> Depth:
        never = self._calls.never.get(root)
        known: dict[Function, Depth | None] = {}  # None: on the path

        def depth_of(function: Function) -> Depth:
            if never and function.matches(never):
                return Depth(0, ())
            if function not in known:
                known[function] = None
                frame, callees = self._checked(function)
                deepest = Depth(frame.size, ((str(function), frame.size),))
                for address, callee in callees.items():
                    below = depth_of(callee)
                    size = frame.held[address] + below.size
                    if size > deepest.size:
                        deepest = Depth(size, ((str(function), frame.size),) + below.path)
                known[function] = deepest
            found = known[function]
            if found is None:
                raise Refused(f"recursion through {function}")
            return found

        return depth_of(self._program.matching(f"^{root}$"))

    @cache
    def _checked(self, function: Function) -> tuple[Frame, dict[int, Function]]:
        compilers = set().union(*(self._frames.get(name, ()) for name in function.names))
        if not compilers and not any(re.match(self._calls.outside, n) for n in function.names):
            raise Refused(f"not in the table: {function}")
        graph = Graph(self._program, function)
        frame = frame_of(graph)
        wanted = {size for pattern, size in self._calls.assembly.items()
                  if function.matches(pattern)} or compilers
        if compilers and frame.size not in wanted:
            raise Refused(f"{function}: the machine code takes {frame.size} bytes, not " +
                          " or ".join(map(str, sorted(wanted))))
        for address in graph.code:
            if graph.unknown_call(address):
                raise Refused(f"indirect call in {function}")
        return frame, graph.callees


def main() -> None:
    program, roots, calls, tags, folder, output = sys.argv[1:]
    graph = StackGraph(Program(program), Calls(calls, tags.split(",")), compilers_frames(folder))
    Path(output).unlink(missing_ok=True)
    lines = []
    for root in Path(roots).read_text().split():
        depth = graph.of(root)
        path = " > ".join(f"{name} {size}" for name, size in depth.path)
        lines += [f"stack {root} graph {depth.size}", f"path {root} {path}"]
    print("\n".join(lines))
    Path(output).write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    try:
        main()
    except Refused as refusal:
        sys.exit(f"stack_graph.py: {refusal}")
