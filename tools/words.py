#!/usr/bin/env python3
"""words.py [FILE...]: fails if comments, documents or texts that the programs print use a word of tools/words.txt.

Prints path:line: "word" -> what to write. Without arguments it reads all tracked files of the kinds below.
"""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
# History keeps its words; golden files and corpora are not prose; Coq quotes the code.
EXEMPT = re.compile(r"^(lib/docs/(changelog\.md|decisions/)|tools/words\.|LICENSE)|(^|/)(golden|corpus)/|\.v$")
TEXT = {".md"}
C_COMMENT = re.compile(r'"(?:\\.|[^"\\\n])*"|//[^\n]*|/\*.*?\*/', re.S)
HASH_COMMENT = re.compile(r'"""(?:.*?)"""|"(?:\\.|[^"\\\n])*"|(?<![\w$&{])#[^\n]*', re.S)
OF_C = {".c", ".h", ".cpp", ".hpp", ".inc", ".js", ".mjs", ".ts", ".css", ".ld"}
OF_HASH = {".py", ".sh", ".cmake", ".txt", ".yml", ".yaml", ".toml", ".ini", ".g"}


def rules():
    """The rules of the list, each a regular expression, a tab and the replacement."""
    for line in (ROOT / "tools/words.txt").read_text().splitlines():
        if line and not line.startswith("#"):
            word, instead = line.split("\t")
            yield re.compile(rf"\b(?:{word})\b", re.I), instead


def prose_in(path, text):
    """(offset, text) of everything for human readers: comments, and literals that contain a blank."""
    if path.suffix in TEXT:
        yield 0, re.sub(r"`[^`\n]*`", lambda code: " " * len(code[0]), text)
        return
    kind = C_COMMENT if path.suffix in OF_C else HASH_COMMENT if path.suffix in OF_HASH else None
    for part in kind.finditer(text) if kind else ():
        if not part[0].startswith('"') or " " in part[0]:
            yield part.start(), re.sub(r"`[^`\n]*`", lambda code: " " * len(code[0]), part[0])


def findings(name, rules):
    path = ROOT / name
    try:
        text = path.read_text()
    except UnicodeDecodeError:
        return
    for start, prose in prose_in(path, text):
        for word, instead in rules:
            for found in word.finditer(prose):
                line = text.count("\n", 0, start + found.start()) + 1
                yield line, f'{name}:{line}: "{" ".join(found[0].split())}" -> {instead}'


def main(names):
    if not names:
        listed = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True)
        names = [name for name in listed.stdout.splitlines() if (ROOT / name).is_file()]
    listed = list(rules())
    found = [text for name in names if not EXEMPT.search(name)
             for _, text in sorted(findings(name, listed))]
    print("\n".join(found) or "words.py: no word of tools/words.txt")
    sys.exit(bool(found))


if __name__ == "__main__":
    main(sys.argv[1:])
