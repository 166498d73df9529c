"""runner.py [--long] [WORD...]: runs the cases of cases/*.txt in parallel, each in its own folder; with words, only
those whose file or title contains a word. Prints each failure with its line.

The environment sets, by default for build/native-sanitize: FLASHBVH, the program; TOOLS, the folder of the tests' own
programs; WORK; INCLUDE; CC, CXX and NM. FLASHBVH_THOROUGH runs all tests, at any length. A case consists of these
lines:

    == TITLE                    begins a case; (long): runs with --long; (thorough): with FLASHBVH_THOROUGH
    fixture NAME                begins a case that runs once; its folder is copied into each case with `use NAME`, or
                                into all cases of a table that begins with `use NAME`
    each NAME | NAME            runs the case for each of the rows below, which give the names' values; a row that
                                begins with `thorough: ` needs FLASHBVH_THOROUGH
    for NAME | NAME ... end     runs the lines up to `end` for each of the rows below; - is an empty cell. For one name
                                also `for NAME: CELL | CELL`, `each NAME: CELL | CELL`
    file NAME: TEXT             writes a file, with \\n and other escapes; without a text, the indented lines below
    run ARGUMENTS => EXIT       runs flashbvh, which must exit with 0 or with EXIT
    refuse ARGUMENTS => TEXT    it must exit with 2, print only one line, which contains TEXT, and write no out*; with
                                ... among the arguments, for each of the lines below: MORE ARGUMENTS => TEXT
    out: TEXT                   the output contains TEXT; `out~ ` matches a regular expression, `out= ` compares all of
                                it; `no ` before it negates it; `err` is standard error, any other word is a file;
                                without a text, tests each of the indented lines below
    json PATH = VALUE           one value of the printed JSON; * means all
    same FILE FILE              two files or folders with equal bytes
    let NAME = EXPRESSION       evaluates Python with all names of checks.py, and out, err, json, lines (JSON per line)
    check EXPRESSION            must be true
    do EXPRESSION               evaluates it; output of a program becomes `out` and `err`

In all but expressions, {NAME} stands for the value of a name of `each`, `for` or `let`.
"""
import ast
import codecs
import fcntl
import filecmp
import json
import math
import multiprocessing
import os
import re
import resource
import shlex
import shutil
import sys
import traceback
import zipfile
from pathlib import Path

import c_names
import checks
import commands
import interrupted
import meshes
import pages
from checks import THOROUGH, Failed, flashbvh, hold

HERE = Path(__file__).resolve().parent
WORK = Path(os.environ["WORK"]).resolve()
MODULES = {module.__name__: module for module in (c_names, commands, interrupted, math, meshes, pages,
                                                    resource, zipfile)}
TAKES_BLOCK = re.compile(r"(file|each|for) (?!.*: )|refuse .*\.\.\.|(no )?\S+[:~]$")


class Case:
    def __init__(self, title, table, values=None, fixture=False):
        self.title, self.table, self.steps, self.values, self.fixture = title, table, [], values or {}, fixture

    def wanted(self, long, words):
        return (long == ("(long)" in self.title) and (THOROUGH or "(thorough)" not in self.title)
                and not self.fixture and (not words or any(word in f"{self.table}: {self.title}" for word in words)))


def rows_of(names, lines):
    """The rows below `each` or `for`, or on its line, as values of the names."""
    names, beside, cells = names.partition(": ")
    if beside:
        lines = cells.split(" | ")
    names = [name.strip() for name in names.split("|")]
    for line in lines:
        if line.startswith("thorough: ") and not THOROUGH or line.startswith("#") or not line:
            continue
        cells = [cell.strip() for cell in re.split(r" \|(?= |$)", line.removeprefix("thorough: "))]
        hold(len(cells) == len(names), f"{len(names)} names, but: {line}")
        yield dict(zip(names, ("" if cell == "-" else cell for cell in cells)))


def steps_of(table):
    """(line number, text, indented lines below if the step takes any) of a table. A trailing \\ continues a line in the
    next one, except in files."""
    taking, begun, word = None, "", ""
    for number, line in enumerate(table.read_text().splitlines(), 1):
        if begun:
            line = begun + line.lstrip()
            begun = ""
        in_file = word == "file" and taking is not None and line.startswith("  ")
        if line.endswith("\\") and not in_file:
            begun = line[:-1]
            continue
        if taking is not None and (line.startswith("  ") or not line):
            taking.append(line[2:])
            continue
        taking = None
        text = line.strip()
        if not text or text.startswith("#"):
            continue
        step = number, text, []
        word = text.split()[0]
        if TAKES_BLOCK.match(text):
            taking = step[2]
        yield step


def read_cases(table):
    cases, rows, first = [], None, []
    for number, text, block in list(steps_of(table)):
        while block and not block[-1]:
            block.pop()
        word, _, rest = text.partition(" ")
        if word in ("==", "fixture"):
            cases.append(Case(rest, table.stem, fixture=word == "fixture"))
        elif word == "each":
            cases[-1].rows = list(rows_of(rest, block))
        else:
            (cases[-1].steps if cases else first).append((number, text, block))
    for case in cases:
        for row in getattr(case, "rows", [{}]):
            rows = Case(case.title, case.table, row, case.fixture)
            rows.steps = case.steps if case.fixture else first + case.steps
            yield rows


def inside(steps):
    """The steps up to the `end` that belongs to the `for` before them, and those after it."""
    depth = 1
    for i, (_, text, _) in enumerate(steps):
        depth += text.startswith("for ") - (text == "end")
        if not depth:
            return steps[:i], steps[i + 1:]
    raise Failed("no end")


class Run:
    """A running case, in its folder."""

    def __init__(self, case, fixtures):
        self.case, self.fixtures, self.at, self.said = case, fixtures, "", checks.Said()
        self.names = {**vars(checks), **MODULES, **case.values, "out": "", "err": ""}

    def all(self):
        self.block(self.case.steps)

    def block(self, steps):
        steps = list(steps)
        while steps:
            number, text, lines = steps.pop(0)
            word, _, rest = text.partition(" ")
            if word == "for":
                inner, steps = inside(steps)
                for row in rows_of(rest, lines):
                    self.names.update((name, self.filled(cell)) for name, cell in row.items())
                    self.block(inner)
                continue
            self.at = f"{self.case.table}.txt:{number}: {self.filled(text)}"
            step = getattr(self, "do_" + word, None)
            if not step:
                for line in [f"{text} {line}" for line in lines if not line.startswith("#")] or [text]:
                    self.compare(line)
            elif word in ("file", "refuse"):
                step(rest, lines)
            else:
                step(rest)

    def filled(self, text):
        return re.sub(r"\{(\w+)\}", lambda name: str(self.names.get(name[1], name[0])), text)

    def heard(self, said):
        self.said = said
        self.names.update(out=str(said), err=said.warnings)

    def do_use(self, name):
        for fixture in self.fixtures:
            if fixture.title == name:
                shutil.copytree(made_once(fixture, self.fixtures), ".", dirs_exist_ok=True, symlinks=True)
                return
        raise Failed("no such fixture")

    def do_file(self, rest, lines):
        name, of_line, text = self.filled(rest).partition(": ")
        content = codecs.escape_decode(text)[0] if of_line else "".join(
            self.filled(line) + "\n" for line in lines).encode()
        name = name.rstrip(":")
        Path(name).parent.mkdir(parents=True, exist_ok=True)
        Path(name).write_bytes(content)

    def do_run(self, rest):
        arguments, _, code = self.filled(rest).partition(" => ")
        self.heard(flashbvh(*shlex.split(arguments), code=int(code or 0)))

    def do_refuse(self, rest, lines=()):
        for line in lines:
            if not line.startswith("#"):
                self.do_refuse(rest.replace("...", line.removeprefix("- ")))
        if lines:
            return
        arguments, _, text = self.filled(rest).partition(" => ")
        self.heard(checks.refused(text, *shlex.split(arguments)))

    def do_json(self, rest):
        path, _, wanted = self.filled(rest).partition(" = ")
        found = checks.at(json.loads(self.names["out"]), path)
        hold(found == json.loads(wanted), f"it is {json.dumps(found)}")

    def do_same(self, rest):
        a, b = shlex.split(self.filled(rest))
        if Path(a).is_dir():
            hold(sorted(os.listdir(a)) == sorted(os.listdir(b)), f"{os.listdir(a)}, {os.listdir(b)}")
            hold(not any(filecmp.cmpfiles(a, b, os.listdir(a), shallow=False)[1:]), "other bytes")
        else:
            checks.same(a, b)

    def do_let(self, rest):
        name, _, expression = rest.partition(" = ")
        self.names[name] = self.value(expression)

    def do_check(self, rest):
        names = {node.id for node in ast.walk(ast.parse(rest)) if isinstance(node, ast.Name)}
        hold(self.value(rest), {name: self.names[name] for name in names
                                if name in self.names and not hasattr(checks, name)})

    def do_do(self, rest):
        said = self.value(rest)
        if isinstance(said, checks.Said):
            self.heard(said)

    def value(self, expression):
        return eval(expression, {**self.names, "json": self.parsed(), "lines": self.parsed(by_line=True)})

    def parsed(self, by_line=False):
        try:
            return self.said.json() if by_line else json.loads(self.names["out"])
        except ValueError:
            return None

    def compare(self, text):
        match = re.fullmatch(r"(no )?(\S+?)([:~=])(?: (.*))?", text)
        hold(match, "no such step")
        no, subject, how, wanted = match.groups()
        wanted = self.filled(wanted or "")
        subject = self.filled(subject)
        found = self.names[subject] if subject in ("out", "err") else Path(subject).read_text(errors="replace")
        good = (wanted in found if how == ":" else re.search(wanted, found, re.M) if how == "~" else
                found.rstrip("\n") == codecs.escape_decode(wanted)[0].decode())
        hold(bool(good) != bool(no), f"{subject} is: {found[:2000]}")


def made_once(fixture, fixtures):
    folder = WORK / "fixtures" / fixture.title
    folder.parent.mkdir(parents=True, exist_ok=True)
    with open(f"{folder}.lock", "w", encoding="utf-8") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not folder.exists():
            here, making = os.getcwd(), Path(f"{folder}.making")
            making.mkdir()
            os.chdir(making)
            Run(fixture, fixtures).all()
            os.chdir(here)
            making.rename(folder)
    return folder


def failure_of(numbered):
    """Runs a case; returns the reason of a failure, or None, and the JSON fields that it saw."""
    checks.SEEN_FIELDS.clear()
    return run_case(*numbered), checks.SEEN_FIELDS


def run_case(number, case, fixtures):
    folder = WORK / f"{case.table}-{number}"
    folder.mkdir(parents=True)
    os.chdir(folder)
    run = Run(case, fixtures)
    try:
        run.all()
    except Failed as failure:
        return f"FAILED: {case.title} {case.values or ''}\n  {run.at}\n  {failure}\n  in {folder}"
    except Exception:  # a step raised an exception
        return f"FAILED: {case.title} {case.values or ''}\n  {run.at}\n{traceback.format_exc()}"
    os.chdir(WORK)
    shutil.rmtree(folder)
    return None


def main():
    words = [word for word in sys.argv[1:] if word != "--long"]
    found = [case for table in sorted((HERE / "cases").glob("*.txt")) for case in read_cases(table)]
    fixtures = [case for case in found if case.fixture]
    cases = [case for case in found if case.wanted("--long" in sys.argv, words)]
    shutil.rmtree(WORK, ignore_errors=True)
    failures, seen = [], set()
    with multiprocessing.Pool(os.cpu_count(), maxtasksperchild=1) as pool:
        numbered = [(number, case, fixtures) for number, case in enumerate(cases)]
        for failure, fields in pool.imap_unordered(failure_of, numbered):
            failures += [failure] if failure else []
            seen |= fields
    unseen = set()
    if not words and "--long" not in sys.argv:
        listed = {(command, name) for command, names in checks.listed_fields().items() for name in names}
        unseen = {f"FAILED: no case's JSON of {command} has {name}" for command, name in listed - seen}
    print("\n".join([*failures, *sorted(unseen), f"{len(cases) - len(failures)} of {len(cases)} cases passed"]))
    sys.exit(bool(failures) or bool(unseen) or not cases)


if __name__ == "__main__":
    main()
