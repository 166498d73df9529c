"""Common functions of the command line's cases and longer tests: they run the program and check its output."""
import base64
import json
import os
import random
import re
import shutil
import struct
import subprocess
import zlib
from math import sqrt
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
BUILD = ROOT / "build/native-sanitize"
for variable, value in (("FLASHBVH", BUILD / "bin/flashbvh"), ("TOOLS", BUILD / "tests/cli"), ("NM", "nm"),
                        ("WORK", BUILD / "tests/cli/by_hand"), ("INCLUDE", ROOT / "lib/include"), ("CC", "clang"),
                        ("CXX", "clang++")):
    os.environ.setdefault(variable, str(value))
FLASHBVH, TOOLS, INCLUDE = os.environ["FLASHBVH"], Path(os.environ["TOOLS"]), os.environ["INCLUDE"]
THOROUGH = bool(os.environ.get("FLASHBVH_THOROUGH"))
HOME = "1 0 0 0 1 0 0 0 1"  # not rotated
STRICTLY = "-pedantic", "-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Werror"


class Failed(Exception):
    pass


def hold(good, otherwise):
    if not good:
        raise Failed(otherwise)


class Said(str):
    """The program's standard output; `warnings` is its standard error."""
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
    hold(done.returncode in (code if isinstance(code, tuple) else (code,)),
         f"exit {done.returncode}, not {code}: {command} ({done.stdout}{done.stderr})")
    said = Said(done.stdout)
    said.warnings = done.stderr
    return said


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


def flashbvh(*arguments, **options):
    said = run(FLASHBVH, *arguments, **options)
    if "--json" in arguments:
        command = arguments[0]
        listed = listed_fields()[command]
        found = set(fields_of(said.json(), listed))
        # A field may be a number or null instead of such an object.
        others = {name for name in found if name not in listed and f"{name}{{}}" not in listed}
        hold(not others, f"tests/cli/json_fields.txt lists no {sorted(others)} of {command}")
        SEEN_FIELDS.update((command, name) for name in found)
    return said


def elsewhere(*arguments, folder="elsewhere", **options):
    """Runs the program in another folder, time zone and locale."""
    return flashbvh(*arguments, cwd=folder, env={**os.environ, "TZ": "Asia/Tokyo", "LC_ALL": "C.UTF-8"}, **options)


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


def kept(file, link, *arguments):
    """With `link`, another name of a file, as output, the command is refused and the file unchanged."""
    Path(link).parent.mkdir(exist_ok=True)
    os.link(file, link)
    before = Path(file).read_bytes()
    said = flashbvh(*arguments, code=2)
    hold(re.search("would replace|is an image, which would be replaced", said.warnings), said.warnings)
    hold(Path(file).read_bytes() == before, f"{file} is replaced: {arguments}")
    os.remove(link)


def compiled(*arguments, language="cxx", strict=STRICTLY, include=INCLUDE, **options):
    """The compiler's output."""
    return run(os.environ[language.upper()], *strict, f"-I{include}", *arguments, **options)


def same(a, b, otherwise=""):
    hold(Path(a).read_bytes() == Path(b).read_bytes(), f"{a} and {b} differ {otherwise}")


def text(file):
    return Path(file).read_text(errors="replace")


def size(file):
    return Path(file).stat().st_size


def write(file, content):
    """Writes a file of these lines."""
    Path(file).write_text(content if not content or content.endswith("\n") else content + "\n")
    return file


def search(pattern, content):
    """The first group of the first match."""
    found = re.search(pattern, content, re.M)
    hold(found, f"no '{pattern}' in: {content}")
    return found[1]


def at(value, path):
    """The value at the path a.0.b in JSON's values; * stands for each element of a list."""
    for number, part in enumerate(path.split(".")):
        if part == "*":
            rest = ".".join(path.split(".")[number + 1:])
            return [at(each, rest) for each in value]
        value = value[int(part) if isinstance(value, list) else part]
    return value


def damaged(file, offset, content, target, checksum=False):
    """A copy with these bytes at the offset, by default one inverted byte; optionally with a corrected checksum."""
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
    """Poses of 17 digits, one per line: a rotation by a random unit quaternion, every fourth one by quarter turns about
    an axis, and a translation within +-reach."""
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
    """The vertices of an OBJ file."""
    return [tuple(map(float, line.split()[1:])) for line in text(file).splitlines() if line.startswith("v ")]


def faces(file):
    """The faces of an OBJ file, with vertex numbers from 0; negative numbers unchanged."""
    return [tuple(int(word) - (int(word) > 0) for word in line.split()[1:]) for line in text(file).splitlines()
            if line.startswith("f ")]


def edit_vertices(source, target, change):
    """Copies an OBJ file with the words of each vertex changed."""
    lines = (line.split() for line in text(source).splitlines())
    write(target, "\n".join(" ".join(["v", *map(str, change(*words[1:]))] if words[0] == "v" else words)
                            for words in lines if words[0] in ("v", "f")))


def box(x=0, y=0, z=0, size=1, first=0, inwards=False):
    """A box in OBJ, from its lower corner; `first`: the number of vertices before it."""
    corners = [(x + size * (i % 2), y + size * (i // 2 % 2), z + size * (i // 4)) for i in range(8)]
    sides = [side[::-1] if inwards else side for side in ("1342", "5687", "1265", "3784", "1573", "2486")]
    return "".join([*("v {:.15g} {:.15g} {:.15g}\n".format(*corner) for corner in corners),
                    *("f " + " ".join(str(first + int(c)) for c in side) + "\n" for side in sides)])


def self_contained(page):
    """The page has no address except data addresses, no path, and no number that is not finite."""
    content = re.sub('"(image|library|values)":"[^"]*"', "", text(page))
    for pattern in (r"(https?:|file:|src=|url\(|@import|<link|fetch\(|import\(|XMLHttp)[^>]{0,40}",
                    r'href="(?!data:|#m[0-9]|#quer)', f"{re.escape(os.getcwd())}|20[0-9][0-9]-[0-9][0-9]-"):
        found = re.search(pattern, content)
        hold(not found, f"{page} holds {found}")
    found = re.search("(?i)[^a-z](nan|inf)[^a-z]", re.sub('base64,[^"]*', "", content))
    hold(not found, f"no number in {page}: {found}")


def cell_of(image):
    return flashbvh("info", image, "--json").json()[0]["cell"]


def transformed_right(image, lattice, cell, slack, poses):
    """Checks that each exported vertex lies where the pose puts it, rounded, within `slack`, for each pose."""
    for pose in poses.splitlines():
        flashbvh("export", "--cells", image, "-o", "rotated.obj", "--pose", pose)
        p, found, before = list(map(float, pose.split())), vertices("rotated.obj"), vertices(lattice)
        hold(found and len(found) == len(before), f"{len(found)} vertices")
        for point, vertex in zip(found, before):
            for i in range(3):
                off = sum(p[3 * i + j] * vertex[j] for j in range(3)) + p[9 + i] / cell - point[i]
                hold(abs(off) <= 0.5 + slack, f"misplaced by {off}: {vertex} at {pose}")


def numbers(file):
    """The numbers of each line."""
    return [list(map(int, line.split())) for line in text(file).splitlines()]


def poses_of(lines):
    return [list(map(float, line.split())) for line in (re.sub("#.*", "", line) for line in lines.splitlines())
            if line.strip()]


def inverse(poses):
    return "\n".join(" ".join(f"{x:.17g}" for x in (
        *(p[3 * i + j] for j in range(3) for i in range(3)),
        *(-sum(p[3 * i + j] * p[9 + i] for i in range(3)) for j in range(3)))) for p in poses_of(poses))


def lattice(mesh, cell):
    """The vertices in a mesh's image."""
    flashbvh("bake", mesh, "-o", "lattice", "--cell", cell, "--format", "image")
    flashbvh("export", "--cells", f"lattice/{Path(mesh).stem}.fbvh", "-o", "lattice.obj")
    return vertices("lattice.obj")


TRIANGLE = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0)  # a buffer of glTF
INLINE = "data:application/octet-stream;base64," + base64.b64encode(TRIANGLE).decode()


def gltf(x, buffer):
    """A glTF of one triangle, translated along x; its buffer's address may be empty."""
    return (f'{{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],\n'
            f'"nodes":[{{"mesh":0,"name":"far","translation":[{x},0,0]}}],\n'
            '"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],\n'
            '"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],\n'
            f'"bufferViews":[{{"buffer":0,"byteLength":36}}],"buffers":[{{"byteLength":36,"uri":"{buffer}"}}]}}\n')


def other_version(folder):
    """A copy of the library's headers with another version number."""
    shutil.copytree(f"{INCLUDE}/flashbvh", f"{folder}/flashbvh")
    version = Path(folder, "flashbvh/version.hpp")
    version.write_text(re.sub("(VERSION_(MINOR|MAJOR)) [0-9]*", r"\1 9999", version.read_text()))


def program_in_c(words):
    """A C program that writes the images baked under these names, and prints the constants of the last one."""
    includes = [f"#include <{header}.h>" for header in ("stdlib", "math", "string", "stdio")]
    includes += [f'#include "{file.name}"' for file in sorted(Path("baked").glob("*.h"))]
    writes = [f'  write_image("{word}.written", {word}_image, {word}_IMAGE_BYTES);\n'
              f"  if (sizeof {word}_image != {word}_IMAGE_BYTES) return 1;" for word in words]
    last = ", ".join(f"{words[-1]}_{name}" for name in (
        "NODE_COUNT", "LEAF_COUNT", "DEPTH", "STACK_NEED", "TRIANGLE_COUNT", "VERTEX_COUNT", "LEAF_SIZE", "ARITY",
        "CELL"))
    return "\n".join([*includes, """
static void write_image(const char* path, const uint32_t* image, size_t size) {
  FILE* file = fopen(path, "wb");
  fwrite(image, 1, size, file);
  fclose(file);
}
int main(void) {""", *writes, f"""
  printf("%d %d %d %d %d %d %d %d %.17g\\n", {last});
  return fabs({words[-1]}_CELL * (double){words[-1]}_CELLS_PER_UNIT - 1) < 1e-6 ? 0 : 1;
}}"""])


def in_json(file):
    return json.loads(text(file))


# Parts of URDFs: links with one or several collision primitives, and joints.
def shape(geometry, place=""):
    return f'<collision><origin xyz="{place or "0 0 0"}"/><geometry>{geometry}</geometry></collision>'


def box_of(sides, place=""):
    return shape(f'<box size="{sides}"/>', place)


def link(name, *shapes):
    return f'<link name="{name}">{"".join(shapes)}</link>\n'


def joint(name, kind, parent, child, inside="", limits=None):
    limit = '<limit lower="{}" upper="{}" effort="1" velocity="1"/>'.format(*limits) if limits else ""
    return (f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>{inside}{limit}'
            "</joint>\n")


def robot(name, *parts):
    """Writes a URDF file."""
    return write(f"{name}.urdf", f'<robot name="{name}">\n{"".join(parts)}</robot>\n')


def disables(a, b):
    """An SRDF element that disables a pair."""
    return f'<disable_collisions link1="{a}" link2="{b}" reason="Never"/>'


def sized(first, second, third, reach):
    """A robot of three boxes, whose last joint slides by up to `reach`."""
    return robot("sized", link("a", box_of(first)), link("b", box_of(second)), link("c", box_of(third)),
                 joint("one", "revolute", "a", "b", '<origin xyz="0 0 0.3"/><axis xyz="0 0 1"/>', (-1, 1)),
                 joint("two", "prismatic", "b", "c", '<origin xyz="0 0 0.3"/><axis xyz="0 0 1"/>', (0, reach)))


def line_up(file, names, first, last, steps):
    """A trajectory on the straight line in between, one line per step."""
    write(file, "\n".join([names, *(", ".join(f"{a + (b - a) * i / steps:.6f}" for a, b in zip(first, last))
                                    for i in range(steps + 1))]))
