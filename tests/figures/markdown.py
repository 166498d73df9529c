"""Markdown tables, aligned so that they read as they stand: the first column left, the others right."""


def table(rows):
    """The lines of a table with a head, and an empty one after it."""
    rows = [[str(cell) for cell in row] for row in rows]
    widths = [max(map(len, column)) for column in zip(*rows)]

    def line(cells):
        return "| " + " | ".join(cell.rjust(width) if i else cell.ljust(width)
                                 for i, (cell, width) in enumerate(zip(cells, widths))) + " |"

    rule = ["-" * (width - 1) + ":" if i else "-" * width for i, width in enumerate(widths)]
    return [line(rows[0]), line(rule), *map(line, rows[1:]), ""]
