"""page.py PAGE FOLDER BOARD...: prints the tables of PAGE, lib/docs/comparison.md, and rewrites them in place.

The block of the page below `<!-- boards -->` is made of FOLDER's files BOARD.txt, which compare_firmware printed.
Status 1, and the old page, if the libraries find other pairs of triangles than flashbvh, by more than a twentieth: then
something is set up wrong.
"""
import re
import sys
from pathlib import Path

MOTIONS = "translated", "rotated"
QUERIES = [("separated", "separated"), ("close", "close"),
           ("intersecting", "intersecting, all pairs"), ("first", "intersecting, first hit")]
LIBRARIES = "flashbvh", "opcode", "float"


def costs_in(file):
    """The core; then mean, most and pairs found, by pair of meshes, motion, class and library."""
    core, of = "", {}
    for core, *key, mean, most, found in map(str.split, file.read_text().splitlines()):
        of[tuple(key)] = float(mean), float(most), int(found)
    if not core:
        sys.exit(f"page.py: nothing in {file}")
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


def main(page, folder, *boards):
    lines = "\n".join(line for name in boards for line in board(folder / f"{name}.txt"))
    print(lines)
    made = f"<!-- boards -->\n```text\n{lines}\n```"
    page.write_text(re.sub(r"^<!-- boards -->\n```text\n(?s:.*?)```$", lambda _: made, page.read_text(), flags=re.M))


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    main(Path(sys.argv[1]), Path(sys.argv[2]), *sys.argv[3:])
