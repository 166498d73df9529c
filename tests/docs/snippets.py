"""snippets.py FOLDER: writes the C++, C and text that README.md and lib/docs show into FOLDER, a file for each section
of a page: readme.cpp, readme.text, guide_05.cpp. Fails if no program of this folder includes one of the guide's."""
import re
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]


def snippets(page):
    """The text of each file by its name. Errors of compilers name lines of the page."""
    name = page.stem.lower()
    made, language = {}, ""
    for number, line in enumerate(page.read_text().splitlines(keepends=True), 1):
        if section := re.match(r"## (\d+)\. ", line):
            name = f"{page.stem}_{int(section[1]):02}"
        if line.startswith("```"):
            language = line[3:].strip()
            line = "" if language in ("", "text") else f'#line {number + 1} "{page.relative_to(ROOT)}"\n'
        if language in ("cpp", "c", "text"):
            file = f"{name}.{language}"
            made[file] = made.get(file, "") + line
    return made


def main(folder):
    programs = "".join(path.read_text() for path in HERE.glob("*.c*"))
    for page in ROOT / "README.md", *sorted(ROOT.glob("lib/docs/*.md")):
        for name, text in snippets(page).items():
            if page.name != "README.md" and not name.endswith(".text") and f'#include "{name}"' not in programs:
                sys.exit(f"{page.relative_to(ROOT)}: no program of tests/docs includes {name}")
            Path(folder, name).write_text(text)


main(*sys.argv[1:])
