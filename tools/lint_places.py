"""lint_places.py TEXT SOURCE...: copies standard input. TEXT is the concatenation of the sources; at the start of a
line, a position in TEXT is replaced by the position in the source."""
import re
import sys
from bisect import bisect_left
from itertools import accumulate
from pathlib import Path

text, *sources = sys.argv[1:]
ends = list(accumulate(Path(source).read_bytes().count(b"\n") for source in sources))
for line in sys.stdin:
    found = re.search(rf"{re.escape(text)}:(\d+)", line)
    if found:
        at = min(bisect_left(ends, int(found[1])), len(ends) - 1)
        line = f"{sources[at]}:{int(found[1]) - ([0] + ends)[at]}{line[found.end():]}"
    print(line, end="")
