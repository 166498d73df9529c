"""Tables of Markdown that show budgets.csv, rewritten in place.

A comment above a table names the figure of each row, with braces as in a shell, but for blanks after commas:
    <!-- figures kr5.rotated.{small, close}.query.{mean, max} -->
Cells below a core's name are its figures; cells below `every core` are counts. Names after a colon give the last
columns, all of which are counts:
    <!-- figures leaf.{1,2,4}: flash work.close.mean work.close.max -->
All other cells, with the first of each row, are text, and stay unchanged.
"""
import re

from results import ALL, Refused

MARK = re.compile("<!-- figures")
TABLE = re.compile(MARK.pattern + r"(\s[^>]*)-->\n((?:\|.*\n)+)")
EVERY_CORE = "every core"


def expanded(word):
    """Expands a.{b,c} to a.b, a.c."""
    braces = re.search(r"\{([^{}]*)\}", word)
    if not braces:
        return [word]
    return [name for choice in braces[1].split(",")
            for name in expanded(word[:braces.start()] + choice + word[braces.end():])]


def grouped(text):
    """The number with commas from 10,000 on; a dash for an empty text."""
    return f"{int(text):,}" if text.isdecimal() and int(text) >= 10000 else text or "-"


def lines_of(rows):
    """The lines of a table with a head: the first column aligned left, the others right."""
    widths = [max(map(len, column)) for column in zip(*rows)]

    def line(cells):
        return "| " + " | ".join(cell.rjust(width) if i else cell.ljust(width)
                                 for i, (cell, width) in enumerate(zip(cells, widths))) + " |\n"

    rule = ["-" * (width - 1) + ":" if i else "-" * width for i, width in enumerate(widths)]
    return "".join(map(line, [rows[0], rule, *rows[1:]]))


def cells_in(line):
    return [cell.strip() for cell in line.strip().strip("|").split("|")]


def table_of(budgets, found):
    marked, table = found.groups()
    rows, _, columns = re.sub(r",\s+", ",", marked).partition(":")
    names = [name for word in rows.split() for name in expanded(word)]
    columns = columns.split()
    head, _, *rows = map(cells_in, table.splitlines())
    if len(names) != len(rows):
        raise Refused(f"{len(names)} figures, {len(rows)} rows of a table: {marked}")
    for name, cells in zip(names, rows):
        if columns:
            cells[-len(columns):] = [grouped(budgets.value(ALL, f"{name}.{column}")) for column in columns]
            continue
        for i, column in enumerate(head):
            if column in budgets.columns or column == EVERY_CORE:
                cells[i] = grouped(budgets.value(ALL if column == EVERY_CORE else column, name))
    return f"<!-- figures{marked}-->\n{lines_of([head, *rows])}"


def rewritten(budgets, text):
    """A page's text with rewritten tables of figures."""
    new, tables = TABLE.subn(lambda found: table_of(budgets, found), text)
    if tables != len(MARK.findall(text)):
        raise Refused("a comment `<!-- figures` without a table")
    return new
