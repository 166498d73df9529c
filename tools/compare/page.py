"""page.py PAGE FOLDER BOARD...: prints the tables of PAGE, lib/docs/comparison.md, and rewrites them in place.

A block of the page below a comment, `<!-- part -->`, is made of the measurements, in FOLDER: lines.txt,
which `compare` printed, BOARD.txt and BOARD-others.txt, which compare_firmware printed of the robot's links
and of other meshes, and the file `with`, the libraries' versions. Status 1, and the old page, if a twentieth of the pairs of triangles differs, or a distance by
more than a cell: then something is set up wrong.
"""
import re
import sys
from collections import defaultdict
from math import exp, log
from pathlib import Path

MOTIONS = "translated", "rotated"
NEAR = "separated", "small", "close"
QUERIES = [(name, name) for name in NEAR] + [("intersecting", "intersecting, all pairs"),
                                              ("first", "intersecting, first hit")]
LIBRARIES = [("flashbvh", "flashbvh"), ("opcode", "OPCODE"), ("fcl", "FCL"), ("bullet", "Bullet")]
FINDERS = LIBRARIES + [("embree", "Embree")]  # finders of pairs; Embree is used for no other query


def words_of(file, kind=None):
    """The words of each line; with `kind`, only of lines that start with it, without that word."""
    for line in file.read_text().splitlines():
        words = line.split()
        if kind is None:
            yield words
        elif words[0] == kind:
            yield words[1:]


def sums(rows):
    """Adds up the numbers of each key."""
    of = {}
    for key, *numbers in rows:
        of[key] = [a + float(b) for a, b in zip(of.get(key, [0] * len(numbers)), numbers)]
    return of


class Times:
    def __init__(self, file):
        self.time = {tuple(key): float(time) for *key, time in words_of(file, "time")}
        self.meshes = list(dict.fromkeys(key[0] for key in self.time))
        if not self.meshes:
            sys.exit("page.py: no times were measured")

    def ratios(self, motion, kind, ours, theirs):
        return [self.time[pair, motion, kind, ours] / self.time[pair, motion, kind, theirs]
                for pair in self.meshes]

    def mean(self, *what):
        """The geometric mean: each pair of meshes has the same weight."""
        return exp(sum(map(log, self.ratios(*what))) / len(self.meshes))

    def range(self, *what):
        return "%.2f to %.2f" % (min(self.ratios(*what)), max(self.ratios(*what)))

    def queries(self):
        for motion in MOTIONS:
            for kind, title in QUERIES:
                at = motion, kind
                # These libraries do not stop at the first hit.
                bullet, embree, worst = ("-", "-", "-") if kind == "first" else (
                    "%.3f" % self.mean(*at, "flashbvh", "bullet"), "%.2f" % self.mean(*at, "flashbvh", "embree"),
                    "%.2f" % max(self.ratios(*at, "flashbvh", "embree")))
                yield "%-10s  %-23s  %6.2f  %12s  %5.2f  %9.2f  %10.2f  %6.2f  %6s  %6s  %6s" % (
                    motion, title, self.mean(*at, "flashbvh", "opcode"), self.range(*at, "flashbvh", "opcode"),
                    self.mean(*at, "flashbvh_alone", "opcode_alone"), self.mean(*at, "flashbvh_pose", "opcode"),
                    self.mean(*at, "flashbvh", "opcode_one"), self.mean(*at, "flashbvh", "fcl"), bullet, embree, worst)

    def distances(self):
        for motion in MOTIONS:
            for kind in NEAR:
                ours, hinted = (motion, kind, "distance"), (motion, kind, "distance_hinted")
                yield "%-10s  %-9s  %6.2f  %12s  %6.2f  %6.2f  %12s" % (
                    motion, kind, self.mean(*ours, "distance_fcl"), self.range(*ours, "distance_fcl"),
                    self.mean(*ours, "distance_rss"), self.mean(*hinted, "distance_fcl"),
                    self.range(*hinted, "distance_fcl"))


def times(file):
    measured = Times(file)
    found = sums(((motion, library), *n) for _, motion, library, *n in words_of(file, "pairs"))
    lengths, farthest = {}, defaultdict(float)
    for _, motion, _, library, poses, differing, most, _ in words_of(file, "length"):
        before = lengths.get((motion, library), (0, 0))
        lengths[motion, library] = before[0] + int(poses), before[1] + int(differing)
        farthest[motion, library] = max(farthest[motion, library], float(most))
    yield from (
        "Time of a query of flashbvh, divided by another library's: below 1, flashbvh is faster.",
        "",
        " " * 39 + "OPCODE                                             FCL  Bullet          Embree",
        "B           class                      mean   of one pair  alone  pose made  one matrix"
        "    mean    mean    mean   worst",
        *measured.queries(),
        "",
        "Pairs of triangles that intersect, under all poses:",
        "",
        "B           library   flashbvh   library   one alone")
    wrong = False
    for motion in MOTIONS:
        for library, title in FINDERS[1:]:
            pairs, theirs, alone = found[motion, library]
            yield "%-10s  %-8s  %8d  %8d  %9d" % (motion, title, pairs, theirs, alone)
            wrong |= library != "bullet" and 20 * alone > pairs
    yield from (
        "",
        "Time of a distance of flashbvh, divided by FCL's:",
        "",
        "                       OBBRSS                   RSS  hinted, OBBRSS",
        "B           class        mean   of one pair    mean    mean   of one pair",
        *measured.distances(),
        "",
        "Distances, against flashbvh's; differing: by more than 1e-6 of it; the most, in cells:",
        "",
        "B           library          poses  differing      most")
    for motion in MOTIONS:
        for library, title in (("distance_hinted", "flashbvh hinted"), ("distance_fcl", "FCL, OBBRSS"),
                               ("distance_rss", "FCL, RSS")):
            at = motion, library
            yield "%-10s  %-15s  %5d  %9d  %8.2g" % (motion, title, *lengths[at], farthest[at])
            wrong |= farthest[at] > 1
    if wrong:
        yield "The libraries did not run the same queries: DIFFERS"


def known(file):
    """Counts each library's wrong answers to queries with known answers: of boxes, then of other meshes."""
    lines = {tuple(key): numbers for *key, queried, wrong in words_of(file, "known")
             for numbers in [(queried, wrong)]}
    of = sums(((kind, "boxes" if mesh.startswith(("crate", "brick")) else "others", library), *numbers)
              for (kind, mesh, library), numbers in lines.items())
    row = "%-44s  %-10s  %12s  %13s  %10s  %13s"
    yield row % ("wrong answers", "meshes", *(title for _, title in LIBRARIES))
    for meshes in "boxes", "others":
        for kind, title in (("touching", "touching in a vertex, an edge or a face"),
                            ("gap", "the same, a cell farther off"), ("distance", "distance, to a millionth"),
                            ("vertex", "a ray through a vertex"), ("edge", "a ray through the middle of an edge"),
                            ("beside", "a ray past a vertex, a cell or less off")):
            if kind == "distance" and meshes == "others":
                continue
            counts = [of.get((kind, meshes, library)) for library, _ in LIBRARIES]
            yield row % (title, meshes, *("%d of %d" % (c[1], c[0]) if c else "-" for c in counts))


def heap(file):
    """The bytes per triangle of each library, and its allocations; means over the pairs of meshes."""
    images = [(float(size), float(count)) for pair, size, count in words_of(file, "image")
              if pair != "crate-brick"]
    size, triangles = map(sum, zip(*images))
    # Each pair is measured with both motions.
    of = sums((library, *numbers) for _, _, library, *numbers in words_of(file, "heap"))
    yield "           bytes a triangle:                  allocations:"
    yield "library             flash              RAM     to make two meshes    of a query, mean"
    for library, title in LIBRARIES:
        made, held, query = (number / 2 for number in of[library])
        yield "%-9s  %15.1f  %15.1f  %21.0f  %19.2f" % (
            title, size / triangles if library == "flashbvh" else 0, held / triangles, made / len(images),
            query / len(images))


def approximations(file):
    """The percentage of poses of a class at which an approximation reports a collision."""
    lines = list(words_of(file, "approximation"))
    of = sums(((kind, of_class), poses, alarms) for _, _, of_class, kind, poses, alarms, _ in lines)
    sizes = sums((kind, size, 1) for *_, kind, _, _, size in lines)
    yield "                                          false alarms, % of the poses:   collisions missed,"
    yield "A and B each as                   bytes  separated    small    close  % of those that are"
    for kind, title in (("capsule", "a capsule"), ("spheres", "32 spheres"), ("hull", "a convex hull"),
                        ("field", "A a field 24 x 24 x 24, B points")):
        shares = [100 * alarms / poses for poses, alarms in
                  (of[kind, of_class] for of_class in (*NEAR, "intersecting"))]
        yield "%-31s  %6.0f  %8.1f  %8.1f  %8.1f  %14.1f" % (
            title, sizes[kind][0] / sizes[kind][1], *shares[:3], 100 - shares[3])


def costs_in(file):
    """The core; then mean, most and pairs found, by pair of meshes, motion, class and library."""
    core, of = "", {}
    for core, *key, mean, most, found in words_of(file):
        of[tuple(key)] = float(mean), float(most), int(found)
    if not core:
        sys.exit(f"page.py: nothing in {file}")
    return core, of


def board(file):
    """Instructions per query for the robot's links: each pair has the same number of poses."""
    core, of = costs_in(file)
    libraries = "flashbvh", "opcode", "float"
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
                "  %9d  %9d" % costs(motion, kind, library)[:2] for library in libraries)
    pairs = (costs(motion, "intersecting", library)[2] for library in libraries for motion in MOTIONS)
    yield "pairs found: flashbvh %d and %d, OPCODE %d and %d, the tree in floats %d and %d" % tuple(pairs)
    yield ""


def board_ratios(*files):
    """flashbvh's instructions divided by the others': the geometric mean of all pairs of meshes, and the worst."""
    core, of = costs_in(files[0])
    of = {key: costs for file in files for key, costs in costs_in(file)[1].items()}
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
            for library in "opcode", "float":
                ratios = [of[pair, motion, kind, "flashbvh"][0] / of[pair, motion, kind, library][0]
                          for pair in meshes]
                cells += "  %6.2f  %10.2f     " % (exp(sum(map(log, ratios)) / len(ratios)), max(ratios))
            yield f"{motion:10}  {title:23}{cells}".rstrip()
    yield ""


def main(page, folder, *boards):
    file = folder / "lines.txt"
    parts = {"times": list(times(file)), "known": list(known(file)), "heap": list(heap(file)),
             "boards": [line for name in boards for line in board(folder / f"{name}.txt")],
             "ratios": [line for name in boards for line in board_ratios(folder / f"{name}.txt",
                                                                         folder / f"{name}-others.txt")],
             "approximations": list(approximations(file))}
    print("\n".join(line for part in parts.values() for line in part))
    if "DIFFERS" in parts["times"][-1]:
        sys.exit(1)
    parts["with"] = (folder / "with").read_text().splitlines()
    page.write_text(re.sub(r"^<!-- (\w+) -->\n```text\n(?s:.*?)```$",
                           lambda block: "<!-- %s -->\n```text\n%s\n```" % (block[1], "\n".join(parts[block[1]])),
                           page.read_text(), flags=re.M))


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    main(Path(sys.argv[1]), Path(sys.argv[2]), *sys.argv[3:])
