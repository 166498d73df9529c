#!/usr/bin/env python3
"""traceability.py    Reads lib/docs/safety.md and fails on a gap: a statement without a test, a test that does not exist,
                   an assumption without a check, a number that occurs twice, a status without a duty."""
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PAGE = ROOT / "lib/docs/safety.md"
STATUSES = ROOT / "lib/include/flashbvh/plain/status.h"
ROW = re.compile(r"^\| ([A-Z]\d+) \| (.+) \| (.*) \|$", re.M)
# Titles of Catch2, CTest and unittest.
TITLE = re.compile(r'(?:TEST_CASE|_test)\("((?:[^"\\\n]|\\.)*)"|"\$\{\w+\}/([^"\n]*)"|def test_(\w+)', re.M)
FILES = ("tests/**/*.cpp", "tests/**/*.cmake", "tests/**/CMakeLists.txt", "tests/**/*.py",
         "firmware_examples/**/CMakeLists.txt", "proofs/**/CMakeLists.txt")


def titles_of_tests():
    for pattern in FILES:
        for file in ROOT.glob(pattern):
            for groups in TITLE.findall(file.read_text()):
                yield next(filter(None, groups), "").replace("_", " ") if groups[2] else "".join(groups)


def gaps_of(page, titles):
    names = [name for name, _, _ in ROW.findall(page)]
    if len(names) < 30:
        yield f"only {len(names)} rows were read"
    yield from (f"{name} occurs twice" for name in sorted(set(names)) if names.count(name) > 1)
    for name, _, check in ROW.findall(page):
        tests = re.findall(r'"([^"]+)"', check)
        if not check.strip() or (not tests and not name.startswith("U")):
            yield f"{name}: no test"
        yield from (f'{name}: no test begins with "{test}"' for test in tests
                    if not any(title.startswith(test) for title in titles))
    duties = re.findall(r"^\|((?: `\w+`,?)+) \|", page, re.M)
    for status in re.findall(r"FLASHBVH_STATUS_(\w+) =", STATUSES.read_text()):
        if not any(f"`{status.lower()}`" in row for row in duties):
            yield f"{status.lower()}: no duty"


def main():
    page = PAGE.read_text()
    gaps = list(gaps_of(page, list(titles_of_tests())))
    print(*gaps, sep="\n", end="\n" if gaps else "")
    print(f"traceability.py: {len(ROW.findall(page))} rows, {len(gaps)} gaps")
    return 1 if gaps else 0


if __name__ == "__main__":
    sys.exit(main())
