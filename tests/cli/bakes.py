"""Images and code that the host program bakes, under any name; and `bench`."""
import os
import re
import resource
import shutil
from collections import Counter
from pathlib import Path

import meshes
from checks import (HOME, INCLUDE, THOROUGH, TOOLS, any_poses, box, compiled, edit_vertices, elsewhere, flashbvh, hold,
                    other_version, refused, run, same, write)

HEADERS = ("assert complex ctype errno fenv float inttypes iso646 limits locale math setjmp signal stdalign stdarg "
           "stdbool stddef stdint stdio stdlib string tgmath time wchar wctype unistd search strings sys/stat sys/types "
           "sys/socket pthread fcntl sched").split()
CPP_HEADERS = "algorithm atomic cmath cstdlib cstring ctime iostream string thread".split()
C_HEADERS = ("assert complex ctype errno fenv inttypes limits locale math setjmp signal stdarg stddef stdint stdio "
             "stdlib string time wchar wctype").split()
TAKEN = ("abs exit size_t uint32_t INT32_MAX UINT8_C typeof asm linux unix class and xor_eq co_yield char8_t nullptr "
         "std flashbvh posix main __arm__ _Bool __x _Upper errno stdin NULL EOF SIGINT E2BIG link pipe socket stat "
         "timeval tm div_t y0 sinf strtol I M_PI va_arg jmp_buf int8_t restrict _Alignas noreturn bool true complex "
         "index select").split()
FREE = "arm base_link tool left torso leaf_2 Base island structure memory signals timeout".split()
QUICK = "--repetitions-scale", "0.0001", "--rounds", "2"


def large():
    """Bakes and checks 66,000 triangles, with FLASHBVH_THOROUGH 200,000; an algorithm quadratic in their number
    would not end."""
    mesh, count, seconds = "meshes/many_triangles", 66000, 30  # of processor time, per process
    if THOROUGH:
        Path("large").mkdir()
        meshes.write_stl("large/large.stl", meshes.torus(400, 250))
        mesh, count, seconds = "large/large", 200000, 90
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
    name = mesh.split("/")[1]
    hold(not flashbvh("bake", f"{mesh}.stl", "-o", "baked", "--index-bits", 32, "--format", "image").warnings,
         "warnings")
    flashbvh("check", f"baked/{name}.fbvh", "--mesh", f"{mesh}.stl").holds(f"{count} triangles, .* nodes, equal to")
    refused(f"{name}.stl: is too large for a cell of 1e-06: out of range are {count} triangles (0, 1, 2, 3, 4 and "
            f"{count - 5} more)", "bake", f"{mesh}.stl", "-o", "out", "--cell", "1e-6")


def scales():
    """A mesh in a unit a thousand times smaller or larger gives the lattice mesh and the answers of the original, under
    equal poses: the library knows no unit of length."""
    flashbvh("bake", "meshes/ring.stl", "-o", "plain", "--cell", 0.013)
    flashbvh("export", "--cells", "plain/ring.fbvh", "-o", "ring.obj")
    poses = any_poses(15, 7, 25).splitlines()
    for exponent, cell in (0, "8"), (3, "8e3"), (-3, "8e-3"):
        # The mesh's own lattice points as lengths, times ten to the exponent.
        folder = Path(f"by{exponent}")
        folder.mkdir()
        edit_vertices("ring.obj", folder / "ring.obj", lambda *point: (f"{x}e{exponent}" for x in point))
        write(folder / "poses", "\n".join(" ".join([*words[:9], *(f"{x}e{exponent}" for x in words[9:])])
                                          for words in map(str.split, poses)))
        flashbvh("bake", folder / "ring.obj", "-o", folder, "--cell", cell)
        flashbvh("export", "--cells", folder / "ring.fbvh", "-o", folder / "lattice.obj")
        write(folder / "answers", flashbvh("collide", folder / "ring.fbvh", folder / "ring.fbvh", "--poses",
                                           folder / "poses", "--json", "--pairs", folder / "pairs"))
    for folder in "by3", "by-3":
        for file in "lattice.obj", "pairs", "answers":
            same(f"by0/{file}", f"{folder}/{file}")
    hold(len(Path("by0/pairs").read_text().splitlines()) > 100, "hardly a pair was found")


def cpp_output():
    """The arrays answer in C++ like the image, link no unused data, refuse another version of the library, and are
    named after the mesh."""
    flashbvh("bake", "meshes/ring.stl", "-o", "images", "--format", "image", "--cell", 0.125)
    write("poses", f"{HOME} 6 2 1")
    flashbvh("collide", "images/ring.fbvh", "images/ring.fbvh", "--poses", "poses", "--pairs", "tool_pairs")
    write("cpp_pairs", run(TOOLS / "cli_cpp_query"))
    same("tool_pairs", "cpp_pairs")

    run(TOOLS / "cli_tree_alone")
    symbols = run(os.environ["NM"], TOOLS / "cli_tree_alone")
    symbols.holds(" ring_image")
    hold("grouped_image" not in symbols, "linked without use")

    Path("names").mkdir()
    names = {"base link-2": "base_link_2", "3rd": "_3rd", "class": "class"}
    for name in names:
        shutil.copy("meshes/tetrahedron.stl", f"names/{name}.stl")
    flashbvh("bake", *(f"names/{name}.stl" for name in names), "-o", "named")
    for name, space in names.items():
        hold(f"const uint32_t {space}_image[" in Path(f"named/{name}.fbvh.h").read_text(), name)
        compiled("-std=c++17", "-x", "c++", "-c", f"named/{name}.fbvh.c", "-o", "object")

    other_version("other_library")
    said = compiled("-std=c++17", "-x", "c++", "-c", "named/class.fbvh.c", "-o", "object", include="other_library", code=1)
    hold("bake it again" in said.warnings, said.warnings)


def determinism():
    """Equal input gives equal bytes, in any folder and with any other meshes; a failed bake leaves older files
    unchanged."""
    shutil.copytree("meshes", "elsewhere/meshes")
    for options in "", "--layout pre", "--builder median", "--leaf-size 3 --arity 5", "--index-bits 32":
        flashbvh("bake", "meshes/ring.stl", "-o", "one", "--cell", 0.01, *options.split())
        elsewhere("bake", "../meshes/coarse.stl", "meshes/ring.stl", "-o", "../two", "--cell", 0.01, *options.split())
        for file in "ring.fbvh", "ring.fbvh.h", "ring.fbvh.c":
            same(f"one/{file}", f"two/{file}", options)
        for file in "ring.fbvh.h", "ring.fbvh.c":
            hold(all(len(line) <= 100 for line in Path("one", file).read_text().splitlines()), "lines over 100")
    header = Path("two/ring.fbvh.h").read_text()
    hold(not re.search(f"{re.escape(os.getcwd())}|elsewhere|20[0-9][0-9]-", header), "a path or a date")

    # Without --cell, the finest cell that fits all meshes; passing it changes nothing.
    both = "meshes/tetrahedron.stl", "meshes/ring.stl"
    cell = re.search("^cell ([^;]*);", flashbvh("bake", *both, "-o", "one"), re.M)[1]
    flashbvh("bake", *both, "-o", "two", "--cell", cell)
    for file in "ring.fbvh", "tetrahedron.fbvh", "tetrahedron.fbvh.c":
        same(f"one/{file}", f"two/{file}")

    shutil.copy("one/ring.fbvh", "before")
    flashbvh("bake", "meshes/ring.stl", "meshes/nan.stl", "-o", "one", "--cell", 1, code=2)
    flashbvh("bake", "meshes/ring.stl", "meshes/many_sides.stl", "-o", "one", "--cell", 0.5, "--max-bytes", 20000, code=2)
    same("before", "one/ring.fbvh")
    hold(not any(Path("one").rglob("*.tmp*")), "temporary files left")

    # Only the requested files.
    for form, files in ("image", ["ring.fbvh"]), ("c", ["ring.fbvh.c", "ring.fbvh.h"]):
        flashbvh("bake", "meshes/ring.stl", "-o", form, "--format", form)
        hold(sorted(os.listdir(form)) == files, f"{form}: {os.listdir(form)}")


def units():
    """Files of different units are converted to one unit, which all given and printed lengths use."""
    Path("parts").mkdir()
    for name, side in ("mm", 254), ("m", 0.254), ("in", 10):
        write(f"parts/{name}.obj", box(size=side))
    parts = [f"parts/{name}.obj" for name in ("mm", "m", "in")]
    said = flashbvh("bake", *parts, "-o", "out", "--cell", 0.5, "--unit", "mm", "--unit", "m.obj=m", "--unit",
                    "parts/in.obj=in")
    hold(not said.warnings, said.warnings)
    said.holds("^cell 0.5 mm;")
    of_mm, of_in = (flashbvh("info", f"out/{name}.fbvh", "--json") for name in ("mm", "in"))
    hold(of_mm.replace('"name":"mm"', '"name":"in"') == of_in, f"{of_mm}{of_in}")
    of_in.holds('"unit":"mm"')
    flashbvh("info", "out/in.fbvh").holds("^cell  *0.5  mm$")
    hold("m_CELL 0.5 /* in mm */" in Path("out/m.fbvh.h").read_text(), "out/m.fbvh.h")
    for name in "mm", "m", "in":
        flashbvh("export", "--cells", f"out/{name}.fbvh", "-o", f"{name}.obj")
        same("mm.obj", f"{name}.obj")

    # A common unit changes no number; the image stores it.
    flashbvh("bake", "parts/in.obj", "-o", "plain", "--cell", 0.5, "--format", "image").holds("^cell 0.5;")
    plain = flashbvh("info", "plain/in.fbvh", "--json")
    for unit in "nm", "um", "mm", "cm", "m", "mil", "in", "ft":
        flashbvh("bake", "parts/in.obj", "-o", "alone", "--cell", 0.5, "--unit", unit, "--format", "image").holds(
            f"^cell 0.5 {unit};")
        found = flashbvh("info", "alone/in.fbvh", "--json")
        hold(found.replace(f'"unit":"{unit}"', '"unit":""') == plain, found)
        flashbvh("export", "alone/in.fbvh", "-o", "alone.obj")
        lines = Path("alone.obj").read_text().splitlines()
        hold(lines[0] == f"# in {unit}" and "v 10 10 10" in lines, lines)

    # To feet and back: 12 inches to a foot.
    flashbvh("bake", "parts/in.obj", "-o", "feet", "--cell", 0.5, "--unit", "in.obj=in", "--unit", "ft", "--format",
             "image")
    flashbvh("export", "--cells", "feet/in.fbvh", "-o", "feet.obj")
    hold("v 2 2 2" in Path("feet.obj").read_text().splitlines(), "10 in are not 2 cells of half a foot")

    # check reads the mesh as bake does.
    flashbvh("check", "out/in.fbvh", "--mesh", "parts/in.obj", code=1)
    flashbvh("check", "out/in.fbvh", "--mesh", "parts/in.obj", "--unit", "mm", "--unit", "in.obj=in")

    shutil.rmtree("out")
    for what, options in (
            ("--unit yard: 'yard' is no unit; give nm, um", "yard"),
            ("--unit mm.obj=yard: 'yard' is no unit", "mm.obj=yard"),
            ("--unit cm: the unit is mm already; give a file's own unit as --unit FILE=cm", "mm --unit cm"),
            ("--unit other.obj=mm: no mesh 'other.obj' is given", "m --unit other.obj=mm"),
            ("--unit parts/mm.obj=in: parts/mm.obj is in cm already",
             "m --unit mm.obj=cm --unit parts/mm.obj=in"),
            ("--unit mm.obj=mm: says nothing of the unit of the results; add it", "mm.obj=mm"),
            ("--unit", "")):
        refused(what, "bake", "parts/mm.obj", "-o", "out", "--unit", *options.split())


def names_of(compiler):
    """Names that may collide: keywords, macros, tags, and all words before a bracket or a semicolon in the headers of
    C, a superset of the declared names."""
    write("c_headers.c", "\n".join(f"#include <{header}.h>" for header in C_HEADERS))
    macros, text = (run(compiler, "-std=gnu11", "-D_GNU_SOURCE", "-E", option, "c_headers.c")
                    for option in ("-dM", "-P"))
    found = {*TAKEN, *re.findall(r"^#define ([A-Za-z]\w*)", macros, re.M)}
    for name, tag in re.findall(r"\b([A-Za-z]\w*) *[(;]|\b(?:enum|struct|union) (\w+)", text, re.A):
        found.add(name or tag)
    return sorted(found)


def compiles(*command):
    run(*command, f"-I{INCLUDE}", "-Ibaked", "-fsyntax-only", "both.cpp")


def names():
    """The output compiles as C++ under any mesh name, before and after all headers of C and C++. Tests keywords and all
    names that those headers declare or define, as the compilers print them; by one standard, with FLASHBVH_THOROUGH
    by others, too."""
    headers = [f"{header}.h" for header in HEADERS] + CPP_HEADERS
    write("headers.hpp", "\n".join(f"#if __has_include(<{header}>)\n#include <{header}>\n#endif"
                                   for header in headers))
    standards = ("c++17", "gnu++17", "gnu++20") if THOROUGH else ("gnu++20",)
    for prefix in "", "arm-none-eabi-":
        if not shutil.which(f"{prefix}gcc"):
            continue
        for folder in "named", "baked":
            shutil.rmtree(folder, ignore_errors=True)
        spellings, folders, taken = Counter(), {}, names_of(f"{prefix}gcc")
        hold(len(taken) > 500, "few names")
        for name in taken:
            spellings[name.lower()] += 1  # one call takes only one of several names that differ in case alone
            folder = Path("named", str(spellings[name.lower()]))
            folder.mkdir(parents=True, exist_ok=True)
            folders.setdefault(folder, []).append(
                write(folder / f"{name}.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3"))
        for meshes in folders.values():
            flashbvh("bake", *meshes, "-o", "baked", "--format", "c", "--cell", 1)
        write("meshes.hpp", "\n".join(f'#include "{file.name}"' for file in sorted(Path("baked").glob("*.h"))))
        write("both.cpp", '#include "headers.hpp"\n#include "meshes.hpp"\n#include "headers.hpp"')
        for standard in standards:
            compiles(f"{prefix}g++", f"-std={standard}", "-I.")
            if not prefix and shutil.which("clang++"):
                compiles("clang++", f"-std={standard}", "-I.")
        write("both.cpp", '#include "meshes.hpp"\n#include "headers.hpp"')
        compiles(f"{prefix}g++", "-std=gnu++17", "-I.")

    # These names stay unchanged.
    Path("free").mkdir()
    for name in FREE:
        shutil.copy("meshes/tetrahedron.stl", f"free/{name}.stl")
    flashbvh("bake", *(f"free/{name}.stl" for name in FREE), "-o", "freely", "--format", "c")
    for name in FREE:
        hold(f"const uint32_t {name}_image[" in Path(f"freely/{name}.fbvh.h").read_text(), f"{name} is called otherwise")
    flashbvh("bake", "meshes/ring.stl", "-o", "images", "--name", "abs")


def bench_refused(what, *arguments):
    """Like refused(), but the command may have printed tables before."""
    warnings = flashbvh("bench", *arguments, code=2).warnings
    hold(warnings.count("\n") == 1, f"not one line: {warnings}")
    hold(what in warnings, f"no '{what}' in: {warnings}")


def bench():
    """Its tables, and the iterations that it sums up."""
    said = flashbvh("bench", "--table", 3, "--table", 7, *QUICK)
    said.holds("^### Table 3: Separation$", "^### Table 7", "^### The default tree$", "^### Time of one query",
               r"^\| total of the intersecting  *\| *0 \|",
               r"^\| total  *\| *96 \| *7410 \| *34886 \| *96 \| *96 \|",
               r"^\| total  *\| *7410 \| *22 \| *22 \|")
    hold("### Table 2" not in said, "table 2 was not requested")
    for row in ("volume-stack", "alternating-stack", "stackless", "stackless-post", "leaf", "ranked", "ranked-stack",
                "best rule", "ranked, default tree", "best rule, default tree"):
        hold(len(re.findall(rf"^\| {row}  *\|", said, re.M)) == 4, f"not four rows of {row}")
    hold(len(re.findall("^table", said.warnings, re.M)) == 4, f"progress: {said.warnings}")

    if THOROUGH:  # the paper's 20 setups: lib/docs/evaluation.md
        flashbvh("bench", "--repetitions-scale", "1e-9", "--rounds", 1).holds(
            r"^\| total  *\| *553230 \| *625382 \| *4108174 \| *544790 \| *- \|",
            r"^\| total where the best rule is known  *\| *83495 \| *98747 \| *171164 \| *80525 \| *65979 \|",
            r"^\| total of the intersecting  *\| *588360 \| *315471 \| *291658 \|",
            r"^\| total  *\| *625382 \| *329182 \| *303831 \|")

    bench_refused("--table", "--table", 1)
    bench_refused("--table", "--table", 9)
    for option, value in (("--rounds", 0), ("--repetitions-scale", 0), ("--repetitions-scale", "nan")):
        bench_refused(option, "--table", 3, option, value)
    flashbvh("bench", "--help").holds("Usage")


def setups_in(file, table, first):
    """The number of rows in a C++ table that begin with `first`."""
    found = re.findall(rf"{table}.*?^    \{{\}}\}}", Path(file).read_text(), re.M | re.S)
    return sum(len(re.findall(rf"^    {first}", text, re.M)) for text in found)


def bench_firmware():
    """`bench --firmware` writes equal files each time."""
    def writes(folder, setups, left_out, *options):
        """Checks the number of setups in all images, and of the omitted ones, which the first image lists."""
        flashbvh("bench", "--firmware", folder, *options)
        images = sorted(Path(folder).glob("setups_*.cpp"))
        found = sum(setups_in(image, "kSetups", r"\{\{") for image in images)
        hold(found == setups, f"{found} setups, not {setups}, in {folder}")
        found = [setups_in(image, "kLeftOut", r"\{[0-9]") for image in images]
        hold(found == [left_out] + [0] * (len(images) - 1), f"{found} setups left out, not {left_out}, of {folder}")
        # Every tree that a table includes exists.
        for image in images:
            for tree in re.findall(r'^#include "(.*fbvh)\.c"$', image.read_text(), re.M):
                for file in Path(folder, f"{tree}.c"), Path(folder, f"{tree}.h"):
                    hold(file.exists() and file.stat().st_size, f"{image}: no {file}")
        return len(images)

    writes("all", 16, 4)  # all but subdivisions 3 and 4, which take 32-bit trees
    writes("again", 16, 4)
    hold({file.name for file in Path("all").iterdir()} == {file.name for file in Path("again").iterdir()},
         "other files the second time")
    for file in Path("all").iterdir():
        same(file, Path("again", file.name))
    hold(writes("small", 14, 6, "--images", 3, "--max-bytes", 200000) == 3, "not three images")
    hold(writes("one", 10, 10, "--max-bytes", 200000) == 1, "two images, not one")
    writes("none", 0, 20, "--max-bytes", 80000)  # the smallest object takes 81 KB

    bench_refused("--max-bytes", "--max-bytes", 80000)
    for option, value in ("--images", 0), ("--max-bytes", 0), ("--table", 2):
        bench_refused(option, "--firmware", "refused", option, value)
    Path("file").touch()
    bench_refused("file", "--firmware", "file")
    hold(not Path("refused").exists(), "something written")
