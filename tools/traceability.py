#!/usr/bin/env python3
"""traceability.py            Reads the requirements of lib/docs/safety_manual.md and fails on a gap: a test, derivation or
                           source of a requirement that does not exist, a source of the library or a proof without a
                           requirement, a status without an obligation. Prints how many of each are traced.
traceability.py --places   Prints each requirement's tests with their files and lines.
"""
import fnmatch
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
MANUAL = ROOT / "lib/docs/safety_manual.md"
SOURCES = ["lib/src/", "lib/include/flashbvh/", "lib/include/flashbvh/detail/", ""]
ITEM = re.compile(r"^\*\*([A-Z]\d+)\*\* (.+?)\n- tests: (.+?)\n- derived: (.+?)\n- source: (.+?)$", re.M | re.S)


def files_of(*patterns):
    return sorted(str(file.relative_to(ROOT)) for pattern in patterns for file in ROOT.glob(pattern) if file.is_file())


def names_of_tests():
    """Pairs of a test's name and its place, from Catch2, CTest and the command line's cases."""
    titles = re.compile(r'(?:TEST_CASE|_test)\("((?:[^"\\\n]|\\.)*)"|"\$\{\w+\}/([^"\n]*)"|^== (.*)$', re.M)
    for file in files_of("tests/**/*.cpp", "tests/**/CMakeLists.txt", "tests/**/*.cmake", "firmware_examples/**/CMakeLists.txt",
                         "proofs/**/CMakeLists.txt", "tests/cli/cases/*.txt"):
        text = (ROOT / file).read_text()
        for found in titles.finditer(text):
            name = next(group for group in found.groups() if group is not None)
            yield name, f"{file}:{text.count(chr(10), 0, found.start()) + 1}"


def quoted(text):
    return re.findall(r'"((?:[^"\\]|\\.)*)"', text)


def named(text):
    return re.findall(r"`([^`]+)`", text)


def anchors_of(page):
    heads = re.findall(r"^#+ (.*)$", page.read_text(), re.M)
    return {re.sub(r"[^\w -]", "", head).strip().lower().replace(" ", "-") for head in heads}


def links_missing(text):
    for target in re.findall(r"\]\(([^)]+)\)", text):
        page, _, anchor = target.partition("#")
        path = MANUAL.parent / page
        if not path.is_file() or (anchor and anchor not in anchors_of(path)):
            yield target


def sources_of(pattern):
    files = files_of("lib/src/**/*", "lib/include/**/*")
    found = {file for file in files for before in SOURCES if fnmatch.fnmatchcase(file, before + pattern)}
    return found or set(files_of(pattern, pattern + "/**/*"))


def gaps_of(manual, tests):
    requirements = ITEM.findall(manual)
    traced = set()
    if not requirements or manual.count("\n**") != len(requirements):
        yield "a requirement lacks one of the lines tests, derived, source"
    for name, _, its_tests, derived, source in requirements:
        for test in quoted(its_tests) or [None]:
            if test is None or not any(title.startswith(test) for title, _ in tests):
                yield f"{name}: no test is named {test}"
        yield from (f"{name}: no such page or section: {link}" for link in links_missing(derived))
        for pattern in named(derived) + named(source):
            files = sources_of(pattern)
            traced |= files
            if not files:
                yield f"{name}: no such file: {pattern}"
    for file in files_of("lib/src/**/*", "lib/include/**/*", "proofs/walk/*.v", "proofs/arithmetic/*"):
        if file not in traced:
            yield f"{file}: no requirement names it"
    names = [name for name, *_ in requirements]
    yield from (f"{name}: there are two" for name in set(names) if names.count(name) > 1)
    rows = set(named(manual.split("## 3.")[1].split("## 4.")[0]))
    for status in re.findall(r"FLASHBVH_STATUS_(\w+) =", (ROOT / "lib/include/flashbvh/plain/status.h").read_text()):
        if status.lower() not in rows:
            yield f"{status.lower()}: section 3 does not say what to do"


def main(arguments):
    if arguments not in ([], ["--places"]):
        sys.exit(__doc__)
    manual = MANUAL.read_text()
    requirements = ITEM.findall(manual)
    tests = list(names_of_tests())
    if arguments:
        for name, text, its_tests, *_ in requirements:
            print(f"{name}: {' '.join(text.split())}")
            for test in quoted(its_tests):
                print(*(f"    {place}: {title}" for title, place in tests if title.startswith(test)), sep="\n")
    gaps = list(gaps_of(manual, tests))
    print(*gaps, sep="\n", end="\n" if gaps else "")
    count = sum(len(quoted(row[2])) for row in requirements)
    print(f"traceability.py: {len(requirements)} requirements, {count} references to tests, {len(gaps)} gaps")
    return 1 if gaps else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
