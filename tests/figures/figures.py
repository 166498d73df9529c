"""figures.py COMMAND: what calls cost on the measured cores.

    run OUTPUT PROGRAM...   runs the measuring programs, by the command in RUN if they are firmware, and writes the sums
                            of their output to OUTPUT. Fails if a program does
    check OUTPUT...         compares those OUTPUTs of programs that exist with budgets.csv; lists figures that differ by
                            more than 2 %, either way, and counts that differ at all, and fails if there are any
    write OUTPUT...         writes the figures of OUTPUTs that have a row into budgets.csv, and the page
    page [--check]          writes the tables of lib/docs/figures.md and of the program's period_costs.hpp; --check fails
                            if this would change them

These lines of a program count:
    core CORE                      the core of the following figures
    figure NAME VALUE              a value that depends on the core: instructions, bytes
    count NAME VALUE               a value that is equal on every core and this machine
    code|stack|object WORD... VALUE          from proofs/stack, as figures
    measured NAME OBSERVED of PROVEN, ...    from proofs/time
"""
import csv
import io
import os
import re
import subprocess
import sys
from pathlib import Path

BUDGETS = Path(__file__).resolve().with_name("budgets.csv")
PAGE = BUDGETS.parents[2] / "lib/docs/figures.md"
COSTS = BUDGETS.parents[2] / "tools/robot/replay/period_costs.hpp"
OF_PERIOD = [f"guard.{name}" for name in ("fixed.period", "fixed.joint", "fixed.pair", "fixed.between", "kinematics",
                                          "work.max")]
SLACK = 2  # percent
ALL = "all"  # the column of counts
MANY = 10000  # values with a thousandth


class Refused(Exception):
    pass


def run(output, *programs):
    Path(output).unlink(missing_ok=True)
    texts = []
    for program in programs:
        done = subprocess.run([*os.environ.get("RUN", "").split(), program], stdout=subprocess.PIPE, text=True,
                              errors="replace", env={"FLASHBVH_TIMEOUT": "600", **os.environ})
        texts.append(summary(done.stdout))
        print(texts[-1], end="", flush=True)
        if done.returncode:
            raise Refused(f"{program} ended with status {done.returncode}")
    Path(output).write_text("".join(texts))


def summary(text):
    """A program's output with the values of each name summed up: mean, maximum, and of many values the one that a
    thousandth of them exceed."""
    lines, values = [], {}
    for line in text.splitlines():
        match line.split():
            case ["figure" | "count" as kind, name, value] if value.isdecimal():
                values.setdefault((kind, name), []).append(int(value))
            case _:
                lines.append(line)
    for (kind, name), all_values in values.items():
        count = len(all_values)
        sums = {".mean": (2 * sum(all_values) + count) // (2 * count), ".max": max(all_values)}
        if count >= MANY:
            sums[".thousandth"] = sorted(all_values)[-(count // 1000) - 1]
        lines += [f"{kind} {name}{word} {value}" for word, value in (sums if count > 1 else {"": all_values[0]}).items()]
    return "".join(f"{line}\n" for line in lines)


def lines_in(texts):
    """Yields core, name and value of each figure."""
    core = ""
    for words in (line.split() for text in texts for line in text.splitlines()):
        match words:
            case ["core", core]:
                pass
            case ["count", name, value]:
                yield ALL, name, value
            case ["figure", name, value]:
                yield core, name, value
            case ["code" | "stack" | "object", *_, value] if value.isdecimal():
                yield core, ".".join(words[:-1]), value
            case ["measured", name, observed, "of", proven, *_]:
                yield core, f"runs.{name}.observed", observed
                yield core, f"runs.{name}.proven", proven.rstrip(",")


def measured_in(texts):
    """The figures by core and name. If several programs print a figure, the largest counts."""
    values = {}
    for core, name, value in lines_in(texts):
        if not value.isdecimal():
            raise Refused(f"not a number: {name} {value}")
        known = values.get((core, name), int(value))
        if core == ALL and known != int(value):
            raise Refused(f"{name}: {value}, elsewhere {known}: every core has to count the same")
        values[core, name] = max(known, int(value))
    return values


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
        writer.writerows([name, *cells.values()] for name, cells in self.rows.items())
        return output.getvalue()

    def missing_in(self, measured):
        """Budgets missing from a group that was measured: its name is the first word of a figure's. Not every build
        has each group."""
        groups = {(core, name.split(".")[0]) for core, name in measured}
        return [(core, name) for name, cells in self.rows.items() for core, value in cells.items()
                if value and (core, name.split(".")[0]) in groups and (core, name) not in measured]

    def complaints(self, measured):
        """Yields a line for each budget that is not kept."""
        for (core, name), now in measured.items():
            if name not in self.rows:
                continue
            was = self.rows[name].get(core, "")
            if not was:
                yield f"{core} {name}: {now}, and has no budget: run tools/figures.sh"
            elif core == ALL and now != int(was):
                yield f"{name}: {now}, its budget is {was}: every core has to count the same"
            elif now * 100 > int(was) * (100 + SLACK):
                yield f"{core} {name}: {now}, more than {SLACK} % above its budget, {was}"
            elif now * 100 < int(was) * (100 - SLACK):
                yield f"{core} {name}: {now}, better than its budget, {was}: run tools/figures.sh"
        for core, name in self.missing_in(measured):
            yield f"{core} {name}: has a budget, and was not measured"

    def update(self, measured):
        for (core, name), value in measured.items():
            if name in self.rows and core in self.columns:
                self.rows[name][core] = str(value)

    def table(self, group):
        """The figures of a group as Markdown, without counts: a mean and its maximum in one row."""
        rows = {name: cells for name, cells in self.rows.items() if name.split(".")[0] == group and not cells[ALL]}
        columns = [column for column in self.columns if any(cells[column] for cells in rows.values())]
        lines = [["", *columns]]
        for name, cells in rows.items():
            most = rows.get(name.removesuffix(".mean") + ".max") if name.endswith(".mean") else None
            if not name.endswith(".max") or name.removesuffix(".max") + ".mean" not in rows:
                label = name.partition(".")[2].replace(".", ", ") + (" / max" if most else "")
                lines.append([label, *(" / ".join(f"{int(of[column]):,}" for of in (cells, most) if of and of[column])
                                       or "-" for column in columns)])
        widths = [max(map(len, column)) for column in zip(*lines)]
        lines.insert(1, ["-" * width if i == 0 else "-" * (width - 1) + ":" for i, width in enumerate(widths)])
        return "".join("| " + " | ".join(cell.rjust(width) if i else cell.ljust(width)
                                         for i, (cell, width) in enumerate(zip(cells, widths))) + " |\n"
                       for cells in lines)

    def shown_in(self, page):
        """The page with its tables rewritten, each below a comment `<!-- GROUP -->`."""
        return re.sub(r"^<!-- (\w+) -->\n(\|.*\n)*", lambda found: f"<!-- {found[1]} -->\n{self.table(found[1])}", page,
                      flags=re.M)

    def costs_in(self, header):
        """The header with its table of the parts of a guard's period rewritten."""
        cells = {core: [self.rows[name][core] for name in OF_PERIOD] for core in self.columns}
        rows = "".join(f'    {{"{core.lower()}", {{"{core}", {", ".join(costs)}}}}},\n' for core, costs in cells.items() if all(costs))
        return re.sub(r'(    \{".*\n)+', rows, header)


def check(book, measured):
    complaints = list(book.complaints(measured))
    print("".join(f"{line}\n" for line in complaints), end="")
    held = sum(name in book.rows for _, name in measured)
    print(f"figures: {held} held, {len(complaints)} complaints")
    return bool(measured) and not complaints


def write_page(book, only_check):
    for file, shown_in in (PAGE, book.shown_in), (COSTS, book.costs_in):
        old = file.read_text()
        new = shown_in(old)
        if not only_check:
            file.write_text(new)
        elif new != old:
            raise Refused(f"{file.name} does not show budgets.csv: run figures.py page")


def main(command="", *arguments):
    if command == "run" and len(arguments) > 1:
        return run(*arguments)
    book = Budgets(BUDGETS.read_text())
    if command == "page":
        return write_page(book, arguments == ("--check",))
    if command not in ("check", "write") or not arguments:
        sys.exit(__doc__)
    measured = measured_in(Path(file).read_text() for file in arguments if Path(file).exists())
    if command == "check":
        return check(book, measured)
    book.update(measured)
    BUDGETS.write_text(book.text())
    return write_page(book, False)


if __name__ == "__main__":
    try:
        sys.exit(main(*sys.argv[1:]) is False)
    except (OSError, Refused) as why:
        sys.exit(f"figures.py: {why}")
