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
    """The core; then mean, most and pairs found, by group, pair of meshes, motion, class and library."""
    core, of = "", {}
    for core, *key, mean, most, found in map(str.split, file.read_text().splitlines()):
        of[tuple(key)] = float(mean), float(most), int(found)
    if not core:
        sys.exit(f"page.py: nothing in {file}")
    return core, of


def rows(of, group):
    """Motion and title of each row, and for each library the costs of all pairs of meshes."""
    pairs = list(dict.fromkeys(key[1] for key in of if key[0] == group))
    for motion in MOTIONS:
        for kind, title in QUERIES:
            costs = [[of[(group, pair, motion, kind, library)] for pair in pairs] for library in LIBRARIES]
            yield motion, title, costs
        found = [sum(of[(group, pair, motion, "intersecting", library)][2] for pair in pairs) for library in LIBRARIES]
        if any(20 * abs(other - found[0]) > found[0] for other in found):
            sys.exit(f"page.py: {group}, {motion}: pairs found differ: {found}")


def board(file):
    core, of = costs_in(file)
    yield f"{core}, well-shaped meshes: instructions of a query, and parts of the other libraries': mean (worst pair)"
    yield ""
    yield "B           class                     flashbvh       of OPCODE's   of a float tree's"
    for motion, title, costs in rows(of, "made"):
        means = [[mean for mean, _, _ in library] for library in costs]
        line = "%-10s  %-23s %9d" % (motion, title, sum(means[0]) / len(means[0]))
        for other in means[1:]:
            parts = [ours / theirs for ours, theirs in zip(means[0], other)]
            line += "       %5.2f (%.2f)" % (sum(parts) / len(parts), max(parts))
        yield line
    yield ""
    yield f"{core}, a robot's links: instructions of a query"
    yield ""
    yield "                                                  flashbvh                OPCODE         a tree in floats"
    yield "B           class                         mean       most       mean       most       mean       most"
    for motion, title, costs in rows(of, "links"):
        yield "%-10s  %-23s" % (motion, title) + "".join("  %9d  %9d" % (
            sum(mean for mean, _, _ in library) / len(library), max(most for _, most, _ in library))
            for library in costs)
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
