"""A page of lib/docs, made of its text in pages/ and of the figures.

Lines of the text that begin with @ become tables:
    @table LABEL | HEAD...       the cores are the columns, after one for each HEAD
    @row LABEL | NAME... | NAME  what all cores count under each HEAD; what each core takes
    @end OTHERWISE               the table; if it has no rows, the rest of the line instead
    @parts MOTION                what fits in a period of 1 ms, by part
    @visits                      the most visits of each pair of meshes: proven and observed
    @bounded                     the worst queries observed on the links, and the bounds on them
    @leaf_sizes CORE NUMBER      flash and work by leaf size; work that NUMBER instructions suffice for
    @worked CORE MOTION CLASS    the arithmetic of one of these figures
and @{CORE NAME} in any other line the value. A row of which nothing is known is left out.
"""
import re
import sys
from pathlib import Path

from markdown import table

sys.path.append(str(Path(__file__).resolve().parents[2] / "proofs/time"))
from formula import most_instructions  # noqa: E402

CLASSES = "separated", "small", "close", "intersecting"


class Missing(Exception):
    pass


def grouped(number):
    """With commas from 10,000 on."""
    text = str(number)
    return f"{int(text):,}" if text.isdecimal() and int(text) >= 10000 else text


def rounded(number):
    """Two digits or three, or as many as the whole part has."""
    if number >= 100:
        return grouped(f"{number:.0f}")
    return f"{number:.{1 if number >= 10 else 2 if number >= 0.1 else 3}f}"


def cells_of(line):
    """The cells after the command."""
    return [cell.strip(" ") for cell in line.partition(" ")[2].split("|")]


class Page:
    def __init__(self, figures, parts):
        """figures: by core and name, as text. parts: the lines of parts.txt."""
        self.value = figures
        self.cores = list(dict.fromkeys(core for core, _ in figures if core != "all"))
        self.names = list(dict.fromkeys(name for _, name in figures))
        words = [line.split() for line in parts]
        self.parts = [(core, int(mhz), " ".join(name)) for kind, core, mhz, *name in
                      (line for line in words if line[0] == "part")]
        self.cycles = next(line[1] for line in words if line[0] == "cycles_per_instruction")
        self.rows = []

    def number(self, core, name):
        if (core, name) not in self.value:
            raise Missing(f"no figure {core} {name}")
        return float(self.value[core, name])

    def shown(self, core, name):
        return grouped(self.value.get((core, name), "-"))

    def instructions(self, mhz):
        """Of a period of 1 ms."""
        return mhz * 1000 / float(self.cycles)

    def lines_of(self, line):
        command, *words = line.split() or [""]
        if command.startswith("@") and hasattr(self, command[1:] + "_lines"):
            return getattr(self, command[1:] + "_lines")(line, *words)
        return [re.sub(r"@\{([^}]*)\}", lambda what: self.asked(*what[1].split()), line)]

    def asked(self, core, name):
        self.number(core, name)
        return self.shown(core, name)

    def table_lines(self, line, *_):
        self.rows = [cells_of(line) + self.cores]
        return []

    def row_lines(self, line, *_):
        label, *counts, name = cells_of(line)
        if any((core, name) in self.value for core in self.cores):
            self.rows.append([label, *(self.shown("all", count) for count in counts),
                              *(self.shown(core, name) for core in self.cores)])
        return []

    def end_lines(self, line, *words):
        if len(self.rows) > 1:
            return table(self.rows)
        return [*cells_of(line), ""] if words else []

    def parts_lines(self, _, motion):
        rows = [["part", "core", "MHz", "cycles", "instructions", "visits", *CLASSES, "first pair"]]
        for core, mhz, name in self.parts:
            if core in self.cores:
                instructions = self.instructions(mhz)
                figures = [f"visit.{motion}", *(f"query.{motion}.{of_class}" for of_class in CLASSES),
                           f"first.{motion}.intersecting"]
                rows.append([name, core, mhz, grouped(mhz * 1000), grouped(f"{instructions:.0f}"),
                             *(rounded(instructions / self.number(core, f"kr5.{figure}.mean"))
                               for figure in figures)])
        return table(rows)

    def visits_lines(self, *_):
        rows = [["pair of links", "any traversal", "`ranked`", "most of 128 poses"]]
        for name in self.names:
            pair = re.fullmatch(r"visits\.(.*)\.observed", name)
            if pair:
                counts = (self.shown("all", f"visits.{pair[1]}.{of}") for of in ("any", "ranked", "observed"))
                rows.append([pair[1].replace("-", ", ", 1), *counts])
        return table(rows)

    def costs(self, core):
        """What prove.py wrote."""
        return {name.removeprefix("bound."): int(self.number(core, name)) for name in self.names
                if name.startswith("bound.")}

    def most_of_pairs(self, of):
        """Of the pairs of links; `of`: depths, siblings or leaf_size."""
        return int(max(self.number("all", name) for name in self.names
                       if re.fullmatch(rf"visits\..*\.{of}", name)))

    def bound_of_query(self, core, motion, of_class):
        """A query made and run to its end takes at most so much: by the most work of the class."""
        cost = self.costs(core)
        return cost["make-query"] + most_instructions(
            cost, *map(self.most_of_pairs, ("depths", "siblings", "leaf_size")),
            int(self.number("all", f"kr5.work.{motion}.{of_class}.max")))

    def leaf_sizes_lines(self, _, core, enough):
        rows = [["triangles a leaf", "bytes a triangle", "two leaves, at most", f"work in {grouped(enough)}",
                 "close, mean", "most", "intersecting, mean", "most"]]
        cost, depths, siblings = self.costs(core), self.most_of_pairs("depths"), self.most_of_pairs("siblings")
        for size in range(1, 9):
            none, one = (most_instructions(cost, depths, siblings, size, work) for work in (0, 1))
            rows.append([size, self.value["all", f"leaf.{size}.flash"], 32 * size * size,
                         int((int(enough) - none) / (one - none)),
                         *(self.shown("all", f"leaf.{size}.work.{of_class}.{of}")
                           for of_class in ("close", "intersecting") for of in ("mean", "max"))])
        return table(rows)

    def bounded_lines(self, *_):
        rows = [["the worst query observed, 64 poses", *self.cores]]
        for motion in "translated", "rotated":
            for of_class in CLASSES[1:]:
                rows.append([f"B {motion}, {of_class}: at most",
                             *(grouped(self.bound_of_query(core, motion, of_class)) for core in self.cores)])
                rows.append(["observed", *(self.shown(core, f"kr5.query.{motion}.{of_class}.max")
                                           for core in self.cores)])
        return table(rows)

    def worked_lines(self, _, core, motion, of_class):
        mhz = next((mhz for of, mhz, _ in self.parts if of == core), None)
        if mhz is None:
            raise Missing(f"no part with {core}")
        instructions = self.instructions(mhz)
        cycles, fit = grouped(mhz * 1000), grouped(f"{instructions:.0f}")
        query = self.number(core, f"kr5.query.{motion}.{of_class}.mean")
        shown = self.shown(core, f"kr5.query.{motion}.{of_class}.mean")
        yield f"    {grouped(mhz * 1000000)} Hz / 1,000 Hz = {cycles} cycles a period of the loop"
        yield f"    {cycles} cycles / {self.cycles} = {fit} instructions a period"
        yield (f"    {fit} / {shown} = {rounded(instructions / query)} queries a period "
               f"({motion}, {of_class}, the mean)")
        if query > instructions:
            yield f"    {shown} / {fit} = {rounded(query / instructions)} periods a query"
        visit = f"kr5.visit.{motion}.mean"
        yield (f"    {fit} / {self.value[core, visit]} = {rounded(instructions / self.number(core, visit))} "
               f"visits a period ({motion})")


def page_of(figures, parts, text):
    """Raises Missing if a figure or a part is missing that the text names."""
    page = Page(figures, parts.splitlines())
    return "".join(f"{new}\n" for line in text.splitlines() for new in page.lines_of(line))
