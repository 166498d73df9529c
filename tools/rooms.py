#!/usr/bin/env python3
"""rooms.py: fails if an #include in lib refers upwards: each room may include only rooms before it in this order."""
import pathlib
import re
import sys

LIB = pathlib.Path(__file__).resolve().parents[1] / "lib"
ORDER = ["plain", "arch", "lattice", "predicates", "bounds", "walk", "query", "motion", "robot", "c"]
# Public headers lie in one folder; headers not listed here belong to the room query.
PUBLIC = {"lattice": ["lattice", "memory_region", "mesh", "image", "pose", "units", "status", "version"],
          "predicates": ["triangle"], "motion": ["first_contact", "flashbvh"]}
ROOM_OF = {f"{name}.hpp": room for room, names in PUBLIC.items() for name in names}


def room_of(path):
    if path.parts[:2] == ("src", "arch"):  # kernels of bounds, by core
        return "bounds"
    folder = path.parent.name
    if folder in ORDER:
        return folder
    if folder == "traversal":
        return "walk"
    return "c" if path.suffix == ".h" else ROOM_OF.get(path.name, "query")


def main():
    wrong = []
    for file in sorted(LIB.rglob("*.[hc]*")):
        for name in re.findall(r'#include "([^"]+)"', file.read_text()):
            taken = (LIB / "include" / name) if name.startswith("flashbvh/") else file.parent / name
            taken = taken.resolve().relative_to(LIB)
            if ORDER.index(room_of(taken)) > ORDER.index(room_of(file.relative_to(LIB))):
                wrong.append(f"lib/{file.relative_to(LIB)} includes {taken}, of a room above it")
    sys.exit("\n".join(wrong) or 0)


if __name__ == "__main__":
    main()
