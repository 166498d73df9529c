"""page.py PAGE FOLDER BOARD...: prints the tables of PAGE, lib/docs/comparison.md, and rewrites them in place.

A block of the page below a comment, `<!-- part -->`, is made of FOLDER's files BOARD.txt and BOARD-others.txt, which
compare_firmware printed of the robot's links and of other meshes. Status 1, and the old page, if the libraries find
other pairs of triangles than flashbvh, by more than a twentieth: then something is set up wrong.
"""
import re
import sys
from math import exp, log
from pathlib import Path

MOTIONS = "translated", "rotated"
QUERIES = [("separated", "separated"), ("small", "small"), ("close", "close"),
           ("intersecting", "intersecting, all pairs"), ("first", "intersecting, first hit")]
LIBRARIES = "flashbvh", "opcode", "float"


def costs_in(*files):
    """The core; then mean, most and pairs found, by pair of meshes, motion, class and library."""
    core, of = "", {}
    for file in files:
        for core, *key, mean, most, found in map(str.split, file.read_text().splitlines()):
            of[tuple(key)] = float(mean), float(most), int(found)
    if not core:
        sys.exit(f"page.py: nothing in {files[0]}")
    return core, of


def board(file):
    """Instructions per query for the robot's links: each pair has the same number of poses."""
    core, of = costs_in(file)
    meshes = list(dict.fromkeys(key[0] for key in of))

    def costs(*key):
        means, mosts, found = zip(*(of[(pair, *key)] for pair in meshes))
        return sum(means) / len(means), max(mosts), sum(found)

    yield f"{core}, instructions a query of the robot's links"
    yield ""
    yield "                                                  flashbvh                OPCODE         a tree in floats"
    yield "B           class                         mean       most       mean       most       mean       most"
    for motion in MOTIONS:
        for kind, title in QUERIES:
            yield "%-10s  %-23s" % (motion, title) + "".join(
                "  %9d  %9d" % costs(motion, kind, library)[:2] for library in LIBRARIES)
        ours, *theirs = (costs(motion, "intersecting", library)[2] for library in LIBRARIES)
        if any(20 * abs(found - ours) > ours for found in theirs):
            sys.exit(f"page.py: {core}, {motion}: pairs found differ: {ours}, {theirs}")
    yield ""


def ratios(*files):
    """flashbvh's instructions divided by the others': the geometric mean of all pairs of meshes, and the worst."""
    core, of = costs_in(*files)
    meshes = list(dict.fromkeys(key[0] for key in of))
    yield f"{core}, instructions of flashbvh, divided by another's"
    yield ""
    yield f"meshes: {' '.join(meshes)}"
    yield ""
    yield "                                           OPCODE              a tree in floats"
    yield "B           class                      mean  worst pair         mean  worst pair"
    for motion in MOTIONS:
        for kind, title in QUERIES:
            cells = ""
            for library in LIBRARIES[1:]:
                of_pairs = [of[pair, motion, kind, "flashbvh"][0] / of[pair, motion, kind, library][0]
                            for pair in meshes]
                cells += "  %6.2f  %10.2f     " % (exp(sum(map(log, of_pairs)) / len(of_pairs)), max(of_pairs))
            yield f"{motion:10}  {title:23}{cells}".rstrip()
    yield ""


def main(page, folder, *boards):
    parts = {"boards": [line for name in boards for line in board(folder / f"{name}.txt")],
             "ratios": [line for name in boards for line in ratios(folder / f"{name}.txt",
                                                                   folder / f"{name}-others.txt")]}
    print("\n".join(line for part in parts.values() for line in part))
    page.write_text(re.sub(r"^<!-- (\w+) -->\n```text\n(?s:.*?)```$",
                           lambda block: "<!-- %s -->\n```text\n%s\n```" % (block[1], "\n".join(parts[block[1]])),
                           page.read_text(), flags=re.M))


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    main(Path(sys.argv[1]), Path(sys.argv[2]), *sys.argv[3:])
