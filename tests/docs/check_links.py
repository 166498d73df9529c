"""check_links.py ROOT    Checks the documents' references: relative links and their anchors, paths of this repository
and names of its sources between backticks, and sections named after a document, as in `lib/docs/guide.md`, "Builds".
External links are not fetched.
"""
from __future__ import annotations

import re
import sys
from itertools import chain
from pathlib import Path

LINK = re.compile(r"\[[^\]]*\]\(([^)\s]+)\)")
PATH = re.compile(r"`((?:\./)?(?:lib|ports|tools|tests|proofs|firmware_examples|\.github)/[A-Za-z0-9_./\-]+)(?::\d+)?`")
# The end of a source's path. Texts about other projects, and what earlier versions had, name other files.
SOURCE = re.compile(r"`([A-Za-z0-9_./\-]+\.(?:cpp|hpp|inc|py|v|g|smt2|csv))(?::\d+)?`")
FOREIGN = re.compile(r"/(changelog|guide)\.md$")
# A reference may name several sections.
SECTION = re.compile(r'`([A-Za-z0-9_./\-]+\.md)`[,:]? (?:section )?((?:"[^"]+"(?:, | and )?)+)')


def without_code(text: str) -> str:
    return re.sub(r"^```.*?^```", "", text, flags=re.M | re.S)


def headings(document: Path) -> list[str]:
    return re.findall(r"^#+ (.+)$", without_code(document.read_text()), re.M)


def sections(document: Path) -> list[str]:
    """Headings without their numbers, and the bold beginnings of paragraphs."""
    bold = re.findall(r"\*\*([^*]+?)\.?\*\*", without_code(document.read_text()))
    return [re.sub(r"^\d+\. ", "", title) for title in headings(document)] + bold


def anchor_of(title: str) -> str:
    return re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")


def find(root: Path, document: Path, name: str) -> Path | None:
    """Finds a file next to the document, at the root, or among the documents, as `guide.md` from `design.md`."""
    candidates = (document.parent / name, root / name, root / "lib/docs" / name)
    return next((path for path in candidates if path.exists()), None)


def problems_of_links(root: Path, document: Path, text: str) -> list[str]:
    problems = []
    for link in LINK.findall(text):
        if re.match(r"[a-z]+:", link):
            continue
        name, _, anchor = link.partition("#")
        target = document if not name else document.parent / name
        if not target.exists():
            problems.append(f"no {link}")
        elif anchor and anchor not in map(anchor_of, headings(target)):
            problems.append(f"no section {link}")
    return problems


def sources(root: Path) -> list[str]:
    folders = ("lib", "ports", "tests", "tools", "proofs", "firmware_examples")
    return [str(path) for folder in folders for path in (root / folder).rglob("*.*")]


def problems_of(root: Path, document: Path, files: list[str]) -> list[str]:
    text = document.read_text()
    problems = problems_of_links(root, document, text)
    prose = re.sub(r"\s+", " ", without_code(text))
    for name in PATH.findall(prose):
        if not (root / name).exists() and not list(root.glob(f"{name}.*")):
            problems.append(f"no `{name}`")
    for name in () if FOREIGN.search(str(document)) else SOURCE.findall(prose):
        ends = "/" + name.removeprefix("./")
        if not any(file.endswith(ends) for file in files):
            problems.append(f"no source `{name}`")
    for name, quoted in SECTION.findall(prose):
        target = find(root, document, name)
        for section in re.findall(r'"([^"]+)"', quoted):
            if target is None or section.rstrip(",.;") not in sections(target):
                problems.append(f'no section "{section}" in `{name}`')
    return problems


def main(root: Path) -> int:
    files = sources(root)
    documents = sorted(chain(root.glob("*.md"), root.glob("lib/docs/**/*.md"), root.glob("ports/*.md"),
                             root.glob(".github/*.md"), root.glob("tests/*.md"), root.glob("tools/npm/*.md"),
                             root.glob("firmware_examples/*/*.md")))
    found = [f"{document.relative_to(root)}: {problem}" for document in documents
             for problem in problems_of(root, document, files)]
    print("\n".join(found) or f"{len(documents)} documents")
    return 1 if found or len(documents) < 10 else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]).resolve()))
