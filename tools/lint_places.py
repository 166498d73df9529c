"""lint_places.py TEXT SOURCE...: copies standard input; a line that begins with a place in TEXT, which is the
sources one after the other, then names the place in the source."""
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
