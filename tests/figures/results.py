"""The output of measuring programs, and the budgets for some of it.

These lines of a program count:
    core CORE                      the core of the following figures
    figure NAME VALUE              a value that depends on the core: instructions, bytes
    count NAME VALUE               a value that is equal on every core and this machine
    quotient NAME PART WHOLE       a figure: PART / WHOLE, each summed over all programs
    code|stack|object|bound WORD... VALUE       from proofs/stack and proofs/time, as figures
    measured NAME OBSERVED of PROVEN, ...       from proofs/time
"""
import csv
import io
from pathlib import Path

BUDGETS = Path(__file__).resolve().with_name("budgets.csv")
SLACK = 2  # percent
ALL = "all"  # the column of counts
OTHERS = "lump", "gear", "spindle"  # sets of meshes by the first of their pairs, in addition to the robot's links


class Refused(Exception):
    pass


def is_number(word):
    return word.replace(".", "", 1).isdecimal()


def lines_in(texts):
    """Yields core, name and value of each figure; a quotient's value is a pair."""
    core = ""
    for words in (line.split() for text in texts for line in text.splitlines()):
        match words:
            case ["core", core]:
                pass
            case ["count", name, value]:
                yield ALL, name, value
            case ["figure", name, value]:
                yield core, name, value
            case ["quotient", name, part, whole]:
                yield core, name, (int(part), int(whole))
            case ["code" | "stack" | "object" | "bound", *_, value] if is_number(value):
                yield core, ".".join(words[:-1]), value
            case ["measured", name, observed, "of", proven, *_]:
                yield core, f"runs.{name}.observed", observed
                yield core, f"runs.{name}.proven", proven.rstrip(",")


def queries():
    """The queries with figures for each set of meshes: their name in `meshes`, and in the sets."""
    for motion in "translated", "rotated":
        for proximity, what in (("separated", "query"), ("small", "query"), ("close", "query"),
                                ("intersecting", "query"), ("small", "first"), ("close", "first"),
                                ("intersecting", "first"), ("intersecting", "held")):
            name = f"{motion}.{proximity}.{what}"
            yield name, [f"{of}.{name}" for of in ("kr5", *OTHERS)]
        for proximity in "separated", "small", "close":
            for what in "cold", "hint":
                name = f"{motion}.{proximity}.{what}"
                yield name, [f"{of}.{name}" for of in ("distance", *OTHERS)]


def add_means(values):
    """Adds the mean over all sets of meshes, and the worst set."""
    for core in {core for core, _ in values}:
        for name, sets in queries():
            means = [int(values[core, f"{of}.mean"]) for of in sets if (core, f"{of}.mean") in values]
            if len(means) == len(sets):
                values[core, f"meshes.{name}.mean"] = str(round(sum(means) / len(means)))
                values[core, f"meshes.{name}.worst"] = str(max(means))


def measured_in(texts):
    """The figures by core and name, as text. If several programs print a figure, the largest counts."""
    values, quotients = {}, {}
    for core, name, value in lines_in(texts):
        figure = core, name
        if isinstance(value, tuple):
            quotients[figure] = tuple(map(sum, zip(value, quotients.get(figure, (0, 0)))))
            continue
        known = values.get(figure, value)
        if not is_number(value):
            raise Refused(f"not a number: {name} {value}")
        if core == ALL and known != value:
            raise Refused(f"{name}: {value}, elsewhere {known}: every core has to count the same")
        values[figure] = max(known, value, key=float)
    for figure, (part, whole) in quotients.items():
        if whole:
            values[figure] = f"{part / whole:.2f}"
    add_means(values)
    return values


def group_of(figure):
    """The first word of a name (kr5, tori, stack, ...). Groups come from separate programs, which not every build has;
    a measured group must be complete."""
    core, name = figure
    return core, name.split(".")[0]


class Budgets:
    """budgets.csv: a row per figure, a column per core. The rows are chosen by hand."""

    def __init__(self, text):
        head, *rows = csv.reader(io.StringIO(text))
        self.columns = head[1:]
        self.rows = {name: dict(zip(self.columns, cells)) for name, *cells in rows}

    def text(self):
        output = io.StringIO()
        writer = csv.writer(output, lineterminator="\n")
        writer.writerow(["figure", *self.columns])
        writer.writerows([name, *(cells.get(column, "") for column in self.columns)]
                         for name, cells in self.rows.items())
        return output.getvalue()

    def value(self, core, name):
        if name not in self.rows:
            raise Refused(f"there is no figure {name}")
        return self.rows[name].get(core, "")

    def missing_in(self, measured):
        """Budgets missing from a group that was measured."""
        groups = set(map(group_of, measured))
        return [(core, name) for name, cells in self.rows.items() for core, value in cells.items()
                if value and group_of((core, name)) in groups and (core, name) not in measured]

    def held(self, measured):
        """The measured figures with a budget, by core and name."""
        return {figure: value for figure, value in measured.items() if figure[1] in self.rows}

    def complaints(self, measured):
        """Yields a line for each exceeded budget."""
        for (core, name), now in self.held(measured).items():
            was = self.value(core, name)
            if not was:
                yield f"{core} {name}: {now}, and has no budget: run tools/figures.sh"
            elif core == ALL:
                if float(now) != float(was):
                    yield f"{name}: {now}, its budget is {was}: every core has to count the same"
            elif float(now) * 100 > float(was) * (100 + SLACK):
                yield f"{core} {name}: {now}, more than {SLACK} % above its budget, {was}"
            elif float(now) * 100 < float(was) * (100 - SLACK):
                yield f"{core} {name}: {now}, better than its budget, {was}: run tools/figures.sh"
        for core, name in self.missing_in(measured):
            yield f"{core} {name}: has a budget, and was not measured"

    def update(self, measured):
        for core, name in self.missing_in(measured):
            self.rows[name][core] = ""
        for (core, name), value in self.held(measured).items():
            if core not in self.columns:
                self.columns.append(core)
            self.rows[name][core] = value


def budgets():
    return Budgets(BUDGETS.read_text())
