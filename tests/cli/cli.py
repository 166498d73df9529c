"""What the tests in test_*.py are made of: they run the program in a folder of their own and check its output. run.py
runs them.

The environment sets, by default for build/native-sanitize: FLASHBVH, the program; TOOLS, the folder of the tests' own
programs; WORK, where tests run; INCLUDE; CC and CXX.
"""
import fcntl
import filecmp
import functools
import inspect
import json
import os
import re
import shlex
import shutil
import subprocess
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
BUILD = ROOT / "build/native-sanitize"
for variable, value in (("FLASHBVH", BUILD / "bin/flashbvh"), ("TOOLS", BUILD / "tests/cli"),
                        ("WORK", BUILD / "tests/cli/by_hand"), ("INCLUDE", ROOT / "lib/include"), ("CC", "clang"),
                        ("CXX", "clang++")):
    os.environ.setdefault(variable, str(value))
FLASHBVH, TOOLS, INCLUDE = os.environ["FLASHBVH"], Path(os.environ["TOOLS"]), os.environ["INCLUDE"]
WORK = Path(os.environ["WORK"]).resolve()
STRICTLY = "-pedantic", "-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Werror"


class Case(unittest.TestCase):
    """A class of tests. Each runs in a folder of its own, with the files of `inputs`, which are fixtures."""
    inputs = ()

    def setUp(self):
        folder = WORK / self.id()
        folder.mkdir(parents=True)
        os.chdir(folder)
        for make in self.inputs:
            make()


def long(test):
    """Marks a test that only `run.py --long` runs."""
    test.is_long = True
    return test


def fixture(make):
    """Marks a function that makes files. They are made once; a call copies them into the current folder."""
    @functools.wraps(make)
    def copied():
        folder = WORK / "fixtures" / f"{make.__module__}.{make.__name__}"
        folder.parent.mkdir(parents=True, exist_ok=True)
        with open(f"{folder}.lock", "w", encoding="utf-8") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            if not folder.exists():
                here, making = os.getcwd(), Path(f"{folder}.making")
                making.mkdir()
                os.chdir(making)
                make()
                os.chdir(here)
                making.rename(folder)
        shutil.copytree(folder, ".", dirs_exist_ok=True, symlinks=True)
    return copied


def hold(good, otherwise):
    if not good:
        raise AssertionError(otherwise)


class Text(str):
    """A file's text, or what a program printed on standard output; then `err` is its standard error."""
    err = ""

    def contains(self, *texts):
        for text in texts:
            hold(text in self, f"no '{text}' in: {self[:2000]}")

    def lacks(self, *texts):
        for text in texts:
            hold(text not in self, f"'{text}' in: {self[:2000]}")

    def matches(self, *patterns):
        """Each pattern matches somewhere; ^ and $ also match at the ends of lines."""
        for pattern in patterns:
            hold(re.search(pattern, self, re.M), f"no '{pattern}' in: {self[:2000]}")

    @property
    def json(self):
        return json.loads(self)

    @property
    def lines(self):
        """A value for each line of JSON."""
        return [json.loads(line) for line in self.splitlines()]

    def each(self, name):
        """The field of this name in each line of JSON."""
        return [line[name] for line in self.lines]


def run(*command, code=0, **options):
    """Runs a program, which must exit with the code. Returns its output."""
    command = list(map(str, command))
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, errors="replace",
                          **options)
    hold(done.returncode == code, f"exit {done.returncode}, not {code}: {command} ({done.stdout}{done.stderr})")
    out = Text(done.stdout)
    out.err = Text(done.stderr)
    return out


def flashbvh(command, *arguments, **options):
    """Runs flashbvh with the arguments in `command`, which are split as by a shell, and with further ones."""
    arguments = [*shlex.split(command), *arguments]
    out = run(FLASHBVH, *arguments, **options)
    if "--json" in arguments:
        look_at_fields(arguments[0], out.lines)
    return out


def refuse(command, wanted):
    """The program must exit with 2 and one line on standard error that contains `wanted`, print nothing else, and leave
    no folder or file named out*."""
    out = flashbvh(command, code=2)
    hold(out.err.count("\n") == 1, f"not one line: {command} ({out.err})")
    hold(not out, f"output on stdout: {command}")
    hold(out.err.startswith("flashbvh: "), out.err)
    hold(wanted in out.err, f"no '{wanted}' in: {out.err} ({command})")
    hold(not any(Path(".").rglob("out*")), f"something written: {command}")
    return out


def refuse_each(command, refusals):
    """Refuses the command with each key of `refusals` appended, and its value as what is wanted."""
    for more, wanted in refusals.items():
        refuse(f"{command} {more}", wanted)


def elsewhere(command, **options):
    """Runs the program in the folder `elsewhere`, and in another time zone and locale."""
    return flashbvh(command, cwd="elsewhere", env={**os.environ, "TZ": "Asia/Tokyo", "LC_ALL": "C.UTF-8"}, **options)


def compiled(*arguments, language="cxx", strict=STRICTLY, include=INCLUDE, **options):
    """The compiler's output."""
    return run(os.environ[language.upper()], *strict, f"-I{include}", *arguments, **options)


def text(file):
    return Text(Path(file).read_text(errors="replace"))


def size(file):
    return Path(file).stat().st_size


def write(file, content):
    """Writes a file of these lines, and its folder. Of a text that begins with \\n, the indentation is removed."""
    content = inspect.cleandoc(content) if content.startswith("\n") else content
    Path(file).parent.mkdir(parents=True, exist_ok=True)
    Path(file).write_text(content if not content or content.endswith("\n") else content + "\n")
    return file


def same(a, b):
    """Two files, or two folders of files, have the same bytes."""
    if Path(a).is_dir():
        names = sorted(os.listdir(a))
        hold(names == sorted(os.listdir(b)), f"{names}, {os.listdir(b)}")
        hold(not any(filecmp.cmpfiles(a, b, names, shallow=False)[1:]), f"{a} and {b} differ")
    else:
        hold(Path(a).read_bytes() == Path(b).read_bytes(), f"{a} and {b} differ")


def search(pattern, content):
    """The first group of the first match."""
    found = re.search(pattern, content, re.M)
    hold(found, f"no '{pattern}' in: {content}")
    return found[1]


def page_data(page):
    """What a page's tables are made of."""
    return json.loads(search("id=page-data>(.*?)</script>", text(page)))


def headlines(page):
    return [line for _, line in page_data(page)["headlines"]]


def self_contained(page):
    """The page has no address except data addresses, no path, and no number that is not finite."""
    content = re.sub('"(image|library|values)":"[^"]*"', "", text(page))
    for pattern in (r"(https?:|file:|src=|url\(|@import|<link|fetch\(|import\(|XMLHttp)[^>]{0,40}",
                    r'href="(?!data:|#m[0-9]|#quer)', f"{re.escape(os.getcwd())}|20[0-9][0-9]-[0-9][0-9]-"):
        found = re.search(pattern, content)
        hold(not found, f"{page} holds {found}")
    found = re.search("(?i)[^a-z](nan|inf)[^a-z]", re.sub('base64,[^"]*', "", content))
    hold(not found, f"no number in {page}: {found}")


def listed_fields():
    """json_fields.txt: for each command the names in its JSON, with {} if an object's own names are no fields."""
    content = re.sub("^#.*\n", "", text(HERE / "json_fields.txt"), flags=re.M)
    return {command: set(names.split()) for command, names in re.findall(r"^(\w+):((?:\s+[\w{}]+)*)$", content, re.M)}


def fields_of(value, listed):
    """The names of all fields in JSON's values."""
    if isinstance(value, list):
        for each in value:
            yield from fields_of(each, listed)
    elif isinstance(value, dict):
        for name, inner in value.items():
            is_keyed = isinstance(inner, dict) and f"{name}{{}}" in listed
            yield f"{name}{{}}" if is_keyed else name
            yield from fields_of(list(inner.values()) if is_keyed else inner, listed)


SEEN_FIELDS = set()  # (command, name) in all outputs of this process


def look_at_fields(command, values):
    listed = listed_fields()[command]
    found = set(fields_of(values, listed))
    # A field may be a number or null instead of such an object.
    others = {name for name in found if name not in listed and f"{name}{{}}" not in listed}
    hold(not others, f"tests/cli/json_fields.txt lists no {sorted(others)} of {command}")
    SEEN_FIELDS.update((command, name) for name in found)
