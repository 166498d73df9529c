"""traceability.py finds each gap, on copies of the safety page with one change each."""
import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))
import traceability as trace

PAGE = trace.PAGE.read_text()
TITLES = list(trace.titles_of_tests())
BREAKS = {
    "a test that does not exist": ('"no verdict is', '"no such verdict is'),
    "a statement without a test": (r'(\| G2 \|.*\|) "[^|]*" \|', r"\1 by design |"),
    "an assumption without a check": (r"(\| U6 \|.*\|) you \|", r"\1  |"),
    "a status without a duty": (r"`full` \|", "`empty` |"),
    "a number that occurs twice": (r"\| G2 \|", "| G1 |"),
    "rows that are not read": (r"\| [A-Z](\d+) \|", r"| \1 |"),
}


def main():
    assert not list(trace.gaps_of(PAGE, TITLES)), "the page as it is"
    for name, (pattern, change) in BREAKS.items():
        changed = re.sub(pattern, change, PAGE, count=0 if "not read" in name else 1)
        assert changed != PAGE and list(trace.gaps_of(changed, TITLES)), name


main()
