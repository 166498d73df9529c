#!/usr/bin/env python3
"""Makes what lib/docs/reference.md can take from its sources, and the API index.

reference.py FLASHBVH            writes the page's generated parts again; FLASHBVH is the host program
reference.py --check FLASHBVH    fails if the page is not what the first form writes
reference.py --api FOLDER        makes doxygen's pages of all public headers in FOLDER

A generated part stands between `<!-- NAME -->` and `<!-- end -->`. Needs doxygen.
"""
import pathlib
import re
import subprocess
import sys
import tempfile
import textwrap
import xml.etree.ElementTree as ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[1]
PAGE = ROOT / "lib/docs/reference.md"
INCLUDE = ROOT / "lib/include"
DOXYFILE = ROOT / "tests/docs/Doxyfile"


def text_of(*command):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout


def run_doxygen(folder, *options):
    text = "\n".join([DOXYFILE.read_text(), f"OUTPUT_DIRECTORY = {folder}", "WARNINGS = NO",
                      "WARN_IF_UNDOCUMENTED = NO", "HAVE_DOT = NO", *options])
    subprocess.run(["doxygen", "-"], input=text, cwd=INCLUDE, text=True, check=True, stdout=subprocess.DEVNULL)


def json_fields(command):
    """The names of the fields in a command's --json output, which runner.py compares with the outputs of its cases."""
    text = (ROOT / "tests/cli/json_fields.txt").read_text()
    found = re.search(rf"^{command}:((?:\s+[\w{{}}]+)*)$", text, re.M)
    return [f"`{name.removesuffix('{}')}`" for name in found.group(1).split()]


def filled(text, indent=""):
    return textwrap.fill(text, 118, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False)


def commands(flashbvh):
    """The help of each command: arguments, options, output and exit codes."""
    names = re.findall(r"^  (\w+)  ", text_of(flashbvh, "--help").split("Subcommands:")[1], re.M)
    for name in names:
        lines = [line.rstrip() for line in text_of(flashbvh, name, "--help").splitlines()]
        lines = [line for line in lines if "--help" not in line]
        text = "\n".join(lines).strip().replace("\nOptions:\n\n", "\n")  # no option but --help
        yield f"### flashbvh {name}\n\n```\n{text}\n```\n"
        fields = json_fields(name) if "--json" in "".join(lines) else []
        if fields:
            yield filled("JSON: " + ", ".join(fields)) + "\n"


def cmake_functions():
    """The leading comment of each file of lib/cmake with a public function."""
    for name in ("flashbvh_add_mesh", "flashbvh_add_robot"):
        comment = re.match(r"(?:#.*\n)+", (ROOT / f"lib/cmake/{name}.cmake").read_text()).group()
        yield f"### {name}\n\n```\n" + re.sub(r"^# ?", "", comment, flags=re.M).strip() + "\n```\n"


def public_functions(tree):
    """Yields (header, name) of each public function in one of doxygen's files."""
    for member in tree.iter("memberdef"):
        if member.get("kind") == "function" and member.get("prot") == "public":
            yield member.find("location").get("file"), member.findtext("name")


def inherited_functions():
    """Yields (header, class, name) of each function that a class takes from its private base: `using Base::NAME;`."""
    for path in sorted(INCLUDE.rglob("*.hpp")):
        owner, access = "", ""
        for line in path.read_text().splitlines():
            if begun := re.match(r"class (\w+)", line):
                owner, access = begun.group(1), "private"
            elif level := re.match(r" *(public|protected|private):", line):
                access = level.group(1)
            elif (used := re.match(r" *using Base::(\w+);", line)) and access == "public" and used.group(1) != "Base":
                yield str(path.relative_to(INCLUDE)), owner, used.group(1)


def alias_of(owner):
    """The name that users write for a class template: `Mesh` for `BasicMesh`."""
    short = owner.removeprefix("Basic")
    used = any(f"using {short} = {owner}<" in path.read_text() for path in INCLUDE.rglob("*.hpp"))
    return short if used else owner


def calls():
    """For each header its functions, and those of its classes prefixed by the class."""
    found = {}

    def add(header, owner, name):
        call = f"`{alias_of(owner)}::{name}`" if owner else f"`{name}`"
        is_special = name.startswith(("~", "operator", owner or "~")) or name.isupper()  # a macro
        if not is_special and "detail/" not in header:
            found.setdefault(header, {})[call] = None

    with tempfile.TemporaryDirectory() as folder:
        run_doxygen(folder)
        for path in sorted(pathlib.Path(folder, "xml").glob("*.xml")):
            root = ElementTree.parse(path).getroot()
            compound = root.find("compounddef")
            if compound is None or compound.get("kind") not in ("namespace", "file", "class", "struct"):
                continue
            scope = compound.findtext("compoundname")
            if compound.get("kind") == "file" and not scope.endswith(".h") or "detail" in scope:
                continue
            is_class = compound.get("kind") in ("class", "struct")
            owner = re.sub(r"<.*", "", scope).strip().split("::")[-1] if is_class else ""
            for header, name in public_functions(root):
                add(header, owner, name)
    for inherited in inherited_functions():
        add(*inherited)
    return found


def call_lists(suffix):
    for header, names in sorted(calls().items()):
        if header.endswith(suffix):
            yield filled(f"- `{header}`: " + ", ".join(names), "  ")


def parts(flashbvh):
    yield "commands", "\n".join(commands(flashbvh))
    yield "cmake", "\n".join(cmake_functions())
    yield "c++ calls", "\n".join(call_lists(".hpp")) + "\n"
    yield "c calls", "\n".join(call_lists(".h")) + "\n"


def page(flashbvh):
    text = PAGE.read_text()
    for name, made in parts(flashbvh):
        begin, end = f"<!-- {name} -->\n", "<!-- end -->"
        before, after = text.split(begin)
        text = f"{before}{begin}\n{made}\n{after[after.index(end):]}"
    return text


def main(arguments):
    if len(arguments) == 2 and arguments[0] == "--api":
        run_doxygen(arguments[1], "GENERATE_HTML = YES", "GENERATE_XML = NO")
    elif len(arguments) == 2 and arguments[0] == "--check":
        if page(arguments[1]) != PAGE.read_text():
            sys.exit("lib/docs/reference.md differs from help texts or headers: tools/reference.py writes it")
    elif len(arguments) == 1:
        PAGE.write_text(page(arguments[0]))
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main(sys.argv[1:])
