"""What cases and longer tests of the command line share: they run the program and hold what it says."""
import json
import os
import random
import re
import shutil
import struct
import subprocess
import zlib
from math import ceil, cos, sin, sqrt
from pathlib import Path

FLASHBVH, TOOLS, INCLUDE = os.environ["FLASHBVH"], Path(os.environ["TOOLS"]), os.environ["INCLUDE"]
HERE = Path(__file__).resolve().parent
THOROUGH = bool(os.environ.get("FLASHBVH_THOROUGH"))
HOME = "1 0 0 0 1 0 0 0 1"  # not rotated
STRICTLY = "-pedantic", "-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Werror"


class Failed(Exception):
    pass


def hold(good, otherwise):
    if not good:
        raise Failed(otherwise)


class Said(str):
    """What the program printed; `warnings` is what it wrote to standard error."""
    warnings = ""

    def json(self):
        return [json.loads(line) for line in self.splitlines()]

    def holds(self, *patterns):
        for pattern in patterns:
            hold(re.search(pattern, self, re.M), f"no '{pattern}' in: {self}")


def run(*command, code=0, **options):
    command = list(map(str, command))
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, errors="replace",
                          **options)
    hold(done.returncode == code, f"exit {done.returncode}, not {code}: {command} ({done.stdout}{done.stderr})")
    said = Said(done.stdout)
    said.warnings = done.stderr
    return said


def flashbvh(*arguments, **options):
    return run(FLASHBVH, *arguments, **options)


def elsewhere(*arguments, folder="elsewhere"):
    """The program in another folder, place and language."""
    return flashbvh(*arguments, cwd=folder, env={**os.environ, "TZ": "Asia/Tokyo", "LC_ALL": "C.UTF-8"})


def refused(what, *arguments):
    """The program must exit with 2 and one line on standard error that holds `what`, print nothing else, and leave no
    folder or file named out*."""
    said = flashbvh(*arguments, code=2)
    hold(said.warnings.count("\n") == 1, f"not one line: {arguments} ({said.warnings})")
    hold(not said, f"output on stdout: {arguments}")
    hold(said.warnings.startswith("flashbvh: "), said.warnings)
    hold(what in said.warnings, f"no '{what}' in: {said.warnings}")
    hold(not any(Path(".").rglob("out*")), f"something written: {arguments}")
    return said


def compiled(*arguments, language="cxx", strict=STRICTLY, include=INCLUDE, **options):
    """What the compiler says."""
    return run(os.environ[language.upper()], *strict, f"-I{include}", *arguments, **options)


def same(a, b, otherwise=""):
    hold(Path(a).read_bytes() == Path(b).read_bytes(), f"{a} and {b} differ {otherwise}")


def text(file):
    return Path(file).read_text(errors="replace")


def size(file):
    return Path(file).stat().st_size


def write(file, content):
    """A file of these lines."""
    Path(file).write_text(content if not content or content.endswith("\n") else content + "\n")
    return file


def search(pattern, content):
    """Its first group's first match."""
    found = re.search(pattern, content, re.M)
    hold(found, f"no '{pattern}' in: {content}")
    return found[1]


def at(value, path):
    """What is at a.0.b of JSON's values; * is each of a list."""
    for number, part in enumerate(path.split(".")):
        if part == "*":
            rest = ".".join(path.split(".")[number + 1:])
            return [at(each, rest) for each in value]
        value = value[int(part) if isinstance(value, list) else part]
    return value


def damaged(file, offset, content, target, checksum=False):
    """A copy with these bytes at the offset, by default all bits of one turned round; with a checksum that matches."""
    data = bytearray(Path(file).read_bytes())
    content = bytes([~data[offset] & 255]) if content is None else content
    data[offset:offset + len(content)] = content
    if checksum:
        data[12:16] = struct.pack("<I", zlib.crc32(data[:12] + data[16:]))
    Path(target).write_bytes(data)


def rotation(w, x, y, z):
    return (w * w + x * x - y * y - z * z, 2 * (x * y - z * w), 2 * (x * z + y * w),
            2 * (x * y + z * w), w * w - x * x + y * y - z * z, 2 * (y * z - x * w),
            2 * (x * z - y * w), 2 * (y * z + x * w), w * w - x * x - y * y + z * z)


def any_poses(count, seed, reach):
    """Poses, one a line, of 17 digits: a unit quaternion of any direction, every fourth about an axis by whole
    quarters, and a translation within +-reach."""
    any_of, lines = random.Random(seed), []
    for n in range(count):
        if n % 4 == 0:
            turned = [1, 0, 0, 0]
            turned[any_of.randint(1, 3)] = any_of.randint(-1, 1)
        else:
            turned = [any_of.uniform(-1, 1) for _ in range(4)]
        length = sqrt(sum(part * part for part in turned))
        place = [any_of.uniform(-reach, reach) for _ in range(3)]
        lines.append(" ".join(f"{entry:.17g}" for entry in (*rotation(*(part / length for part in turned)), *place)))
    return "\n".join(lines)


def vertices(file):
    """Of a mesh in OBJ."""
    return [tuple(map(float, line.split()[1:])) for line in text(file).splitlines() if line.startswith("v ")]


def faces(file):
    """Of a mesh in OBJ, by numbers from 0; negative ones as they are."""
    return [tuple(int(word) - (int(word) > 0) for word in line.split()[1:]) for line in text(file).splitlines()
            if line.startswith("f ")]


def edit_vertices(source, target, change):
    """A mesh in OBJ, with the words of each vertex changed."""
    lines = (line.split() for line in text(source).splitlines())
    write(target, "\n".join(" ".join(["v", *map(str, change(*words[1:]))] if words[0] == "v" else words)
                            for words in lines if words[0] in ("v", "f")))


def box(x=0, y=0, z=0, size=1, first=0, inwards=False):
    """A box in OBJ from its lower corner; `first`: how many vertices come before."""
    corners = [(x + size * (i % 2), y + size * (i // 2 % 2), z + size * (i // 4)) for i in range(8)]
    sides = [side[::-1] if inwards else side for side in ("1342", "5687", "1265", "3784", "1573", "2486")]
    return "".join([*("v {:.15g} {:.15g} {:.15g}\n".format(*corner) for corner in corners),
                    *("f " + " ".join(str(first + int(c)) for c in side) + "\n" for side in sides)])


def self_contained(page):
    """No address but those that hold their data, no path, and no number that is none."""
    content = text(page)
    for pattern in (r"(https?:|file:|src=|url\(|@import|<script|<link)[^>]{0,40}",
                    r'href="(?!data:|#m[0-9]|#quer)', f"{re.escape(os.getcwd())}|20[0-9][0-9]-[0-9][0-9]-"):
        found = re.search(pattern, content)
        hold(not found, f"{page} holds {found}")
    found = re.search("(?i)[^a-z](nan|inf)[^a-z]", re.sub('base64,[^"]*', "", content))
    hold(not found, f"no number in {page}: {found}")


def solids(*bodies):
    """An STL in text: of each body its name and the heights of its triangles."""
    facet = ("facet normal 0 0 1\nouter loop\nvertex 0 0 {0}\nvertex 1 0 {0}\nvertex 0 1 {0}\nendloop\n"
             "endfacet\n")
    return "".join(f"solid {name}".rstrip() + "\n" + "".join(map(facet.format, heights)) + "endsolid\n"
                   for name, *heights in bodies)


def cell_of(image):
    return flashbvh("info", image, "--json").json()[0]["cell"]
