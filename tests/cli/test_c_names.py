"""C and C++ output under any name of a mesh."""
import re
import shutil
from collections import Counter
from pathlib import Path

from cli import Case, flashbvh, INCLUDE, long, run, text, write
from inputs import meshes

HEADERS = ("assert complex ctype errno fenv float inttypes iso646 limits locale math setjmp signal stdalign stdarg "
           "stdbool stddef stdint stdio stdlib string tgmath time wchar wctype unistd search strings sys/stat "
           "sys/types sys/socket pthread fcntl sched").split()
CPP_HEADERS = "algorithm atomic cmath cstdlib cstring ctime iostream string thread".split()
C_HEADERS = ("assert complex ctype errno fenv inttypes limits locale math setjmp signal stdarg stddef stdint stdio "
             "stdlib string time wchar wctype").split()
TAKEN = ("abs exit size_t uint32_t INT32_MAX UINT8_C typeof asm linux unix class and xor_eq co_yield char8_t nullptr "
         "std flashbvh posix main __arm__ _Bool __x _Upper errno stdin NULL EOF SIGINT E2BIG link pipe socket stat "
         "timeval tm div_t y0 sinf strtol I M_PI va_arg jmp_buf int8_t restrict _Alignas noreturn bool true complex "
         "index select").split()
FREE = "arm base_link tool left torso leaf_2 Base island structure memory signals timeout".split()


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


class CNamesTest(Case):
    inputs = meshes,

    # Before and after all headers of C and C++. Keywords, and all names that those headers declare or define, as the
    # compilers print them.
    @long
    def test_c_output_compiles_as_cpp_whatever_the_mesh_is_called(self):
        headers = [f"{header}.h" for header in HEADERS] + CPP_HEADERS
        write("headers.hpp", "\n".join(f"#if __has_include(<{header}>)\n#include <{header}>\n#endif"
                                       for header in headers))
        for prefix in "", "arm-none-eabi-":
            if not shutil.which(f"{prefix}gcc"):
                continue
            for folder in "named", "baked":
                shutil.rmtree(folder, ignore_errors=True)
            spellings, folders, taken = Counter(), {}, names_of(f"{prefix}gcc")
            self.assertGreater(len(taken), 500)
            for name in taken:
                spellings[name.lower()] += 1  # one call takes only one of several names that differ in case alone
                folder = Path("named", str(spellings[name.lower()]))
                folder.mkdir(parents=True, exist_ok=True)
                folders.setdefault(folder, []).append(
                    write(folder / f"{name}.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3"))
            for files in folders.values():
                flashbvh("bake -o baked --format c --cell 1", *map(str, files))
            write("meshes.hpp", "\n".join(f'#include "{file.name}"' for file in sorted(Path("baked").glob("*.h"))))
            write("both.cpp", '#include "headers.hpp"\n#include "meshes.hpp"\n#include "headers.hpp"')
            compiles(f"{prefix}g++", "-std=gnu++20", "-I.")
            if not prefix and shutil.which("clang++"):
                compiles("clang++", "-std=gnu++20", "-I.")
            write("both.cpp", '#include "meshes.hpp"\n#include "headers.hpp"')
            compiles(f"{prefix}g++", "-std=gnu++17", "-I.")

        # These names stay unchanged.
        Path("free").mkdir()
        for name in FREE:
            shutil.copy("meshes/tetrahedron.stl", f"free/{name}.stl")
        flashbvh("bake -o freely --format c", *(f"free/{name}.stl" for name in FREE))
        for name in FREE:
            text(f"freely/{name}.fbvh.h").contains(f"const uint32_t {name}_image[")
        flashbvh("bake meshes/ring.stl -o images --name abs")
