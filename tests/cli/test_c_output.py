"""The C output: strict C99 with the image's bytes and constants, under names that collide neither with another mesh's
nor with C's. It refuses another version of the library."""
import os
import re
import shutil
from pathlib import Path

from cli import Case, compiled, fixture, flashbvh, INCLUDE, long, run, same, STRICTLY, text, write
from inputs import meshes

# Names similar to each other, and names of C, C++, POSIX and the compilers; and their names in C.
NAMES = [(name, name) for name in ("part", "Part", "PART", "part_image", "part_IMAGE", "part_LEAF", "a_H", "int", "abs",
                                   "size_t", "INT32_MAX", "EOF", "SIGINT", "M_PI", "va_arg", "jmp_buf", "stdin", "y0",
                                   "errno", "typeof", "linux", "class", "xor_eq", "std", "link", "timeval")]
NAMES += [("3rd", "_3rd"), ("_Bool", "m_Bool"), ("__arm__", "m__arm__"), ("base link-2", "base_link_2")]


@fixture
def in_c():
    """One mesh at a time, since some names differ in case alone."""
    meshes()
    for name, _ in NAMES:
        Path("named").mkdir(exist_ok=True)
        shutil.copy("meshes/ring.stl" if "link" in name else "meshes/tetrahedron.stl", f"named/{name}.stl")
        flashbvh(f'bake "named/{name}.stl" -o baked --format c --unit mm')
        flashbvh(f'bake "named/{name}.stl" -o images --format image --unit mm')


def other_version(folder):
    """A copy of the library's headers with another version number."""
    shutil.copytree(f"{INCLUDE}/flashbvh", f"{folder}/flashbvh")
    version = Path(folder, "flashbvh/version.hpp")
    version.write_text(re.sub("(VERSION_(MINOR|MAJOR)) [0-9]*", r"\1 9999", version.read_text()))


def program_in_c(words):
    """A C program that writes the images baked under these names, and prints the constants of the last one."""
    includes = [f"#include <{header}.h>" for header in (
        "stdlib", "math", "string", "stdio", "errno", "setjmp", "signal", "stdarg", "unistd", "sys/time")]
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


class COutputTest(Case):
    inputs = in_c,

    @long
    def test_it_compiles_strictly_and_has_the_images_bytes_and_numbers(self):
        self.assertEqual(len(os.listdir("baked")), 2 * len(NAMES))
        write("main.c", program_in_c([word for _, word in NAMES]))
        for compiler in ("c99", "gnu17"):
            with self.subTest(compiler):
                for cc in {os.environ["CC"], "clang"}:
                    if shutil.which(cc):
                        run(cc, f"-std={compiler}", *STRICTLY, f"-I{INCLUDE}", "-Ibaked", "main.c",
                            *Path("baked").glob("*.c"), "-o", "program", "-lm")
        found = run("./program").split()
        for name, word in NAMES:
            same(f"{word}.written", f"images/{name}.fbvh")
        out = flashbvh('info "images/base link-2.fbvh" --json')
        self.assertEqual(list(map(float, found)), [out.json[name] for name in (
            "nodes", "leaves", "depth", "stack_need", "triangles", "vertices", "leaf_size", "arity", "cell")])
        text("baked/part.fbvh.h").matches("part_CELL .* in mm")

    @long
    def test_cpp_may_include_the_headers_too(self):
        for header in Path("baked").glob("*.h"):
            compiled("-std=c++17", "-x", "c++", "-fsyntax-only", header)

    def test_another_version_of_the_library_and_a_big_endian_core_are_refused(self):
        other_version("other_library")
        out = compiled("-std=c99", "-c", "baked/part.fbvh.c", "-o", "object", language="cc", include="other_library",
                       strict=(), code=1)
        out.err.matches("part was baked by .*; bake it again")
        out = compiled("-std=c99", "-U__BYTE_ORDER__", "-D__BYTE_ORDER__=__ORDER_BIG_ENDIAN__", "-c",
                       "baked/part.fbvh.c", "-o", "object", language="cc", strict=(), code=1)
        out.err.contains("big-endian")

    def test_an_older_cpp_is_the_first_error_of_each_public_header_and_the_next_ends_it(self):
        for header in Path(INCLUDE, "flashbvh").rglob("*.h*"):
            if "detail" not in header.parts and '"flashbvh/' in text(header):
                with self.subTest(header):
                    err = compiled("-std=c++14", "-x", "c++", "-fsyntax-only", header, strict=(), code=1).err
                    err.matches(r"\A(?:(?! error: ).*\n)*.* error: .*flashbvh needs C\+\+17: set -std=gnu\+\+17")
                    self.assertEqual(len(re.findall("error: ", err)), 2)

    def test_what_c_cant_open_is_said_where_c_declares_it(self):
        flashbvh("bake meshes/ring.stl -o pre --format c --layout pre")
        text("pre/ring.fbvh.h").contains("C has no such meshes")
        text("baked/part.fbvh.h").contains("flashbvh_view_unchecked()")
