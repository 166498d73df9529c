"""packaging.py WAY: flashbvh as its users build it, in a folder of the way: in a firmware project (consumer/), as the two
files, as a package.

WAY names a function below. Environment: FLASHBVH, the tool; ROOT, the repository; FOLDER, the parent of the ways'
folders; CMAKE.
"""
import json
import os
import re
import shutil
import subprocess
import sys
import tarfile
from pathlib import Path

ROOT, FOLDER, FLASHBVH, CMAKE = (os.environ[name] for name in ("ROOT", "FOLDER", "FLASHBVH", "CMAKE"))
HERE = Path(__file__).resolve().parent
LAUNCHER = os.environ.get("CMAKE_CXX_COMPILER_LAUNCHER", "")
log = ""
# No package but the compiler's: the build must not look for these.
BARE = [f"-DCMAKE_DISABLE_FIND_PACKAGE_{name}=TRUE" for name in
        ("assimp", "CLI11", "EXPAT", "nlohmann_json", "Catch2", "urdfdom")]
IN_SOURCES = ["-DWAY=add_subdirectory", f"-DFLASHBVH_ROOT={ROOT}", f"-DFLASHBVH_HOST_TOOL={FLASHBVH}"]
# Macros of Arduino, Windows, newlib, POSIX, CMSIS, vendors' kits and compilers for 8 and 16 bits, some with what no code
# compiles with.
FUNCTION_MACROS = """abs barrier bit bitRead byte clamp close constrain connect container_of degrees index interrupts likely
lowByte max min radians read round send sq swap unlikely word write BIT F MAX MIN""".split()
MACROS = {name: "@" for name in "eeprom hyper interrupt persistent ram I".split()} | {
    name: "" for name in "far near huge cdecl pascal IN OPTIONAL OUT".split()} | {
    name: "1" for name in """linux unix A0 A1 B0 B1 CHANGE DEFAULT DELETE DISABLE DONE ENABLE ERROR EULER EXTERNAL FALSE HIGH
INPUT INTERNAL LOW OPAQUE OUTPUT PI RELATIVE RESET SET SUCCESS TRUE""".split()} | {
    "interface": "struct", "noinline": "__attribute__((noinline))", "rom": "const", "small": "char", "CONST": "const",
    "VOID": "void"}
# Flags of a machine that reach firmware by a target alone, like Zephyr's.
MACHINE = "-mcpu=cortex-m4;-mthumb;-mfloat-abi=hard;-mfpu=fpv4-sp-d16"


def hold(good, otherwise):
    if not good:
        sys.exit("\n".join([f"FAILED: {otherwise}", *log.splitlines()[-40:]]))


def need(*programs):
    missing = [program for program in programs if not shutil.which(program)]
    if missing:
        print(f"left out, not installed: {' '.join(missing)}")
        sys.exit(77)


def run(*command):
    """Whether it succeeds; its output is in `log`."""
    global log
    done = subprocess.run(list(map(str, command)), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          errors="replace")
    log = done.stdout
    return done.returncode == 0


def cmake(folder, *options, source="firmware"):
    return run(CMAKE, "-G", "Ninja", "-S", source, "-B", folder, *options)


def configure(folder, *options, source="firmware"):
    hold(cmake(folder, *options, source=source), f"configure: {options}")


def refuses(said, *options):
    """CMake fails with this message."""
    shutil.rmtree("wrong", ignore_errors=True)
    hold(not cmake("wrong", *options) and re.search(said, " ".join(log.split())), f"no '{said}'")


def build(folder, *options):
    hold(run(CMAKE, "--build", folder, *options), f"build {folder}")


def bakes(folder, baked, why):
    """The build bakes these, and the next one does not."""
    for times in 1, 0:
        build(folder)
        hold(log.count(f"Baking {baked}") == times, f"{why}: baked {baked} otherwise than {times} times")


def answers(*programs):
    for program in programs:
        hold(run(f"./{program}"), f"wrong answers: {program}")


def after_macros(*headers):
    """A source that includes the standard's headers, as those macros' headers do, then defines the macros, then includes
    these."""
    standard = [f"#include <{name}.h>" for name in "ctype math stddef stdint stdlib string".split()]
    return "\n".join([*standard, "#ifdef __cplusplus", "#include <new>", "#endif",
                      *(f"#define {name}(...) @" for name in FUNCTION_MACROS),
                      *(f"#define {name} {value}" for name, value in MACROS.items()),
                      *(f"#include <{header}>" for header in headers), ""])


def version():
    return ".".join(re.findall(r"_(?:MAJOR|MINOR|PATCH) (\d+)", Path(ROOT, "lib/include/flashbvh/version.hpp").read_text()))


def add_subdirectory():
    """add_subdirectory(), flashbvh_add_mesh() and flashbvh_add_robot() bake again when a source or an option changes."""
    shutil.copy("firmware/peg.obj", "firmware/tool.obj")
    options = [*IN_SOURCES, *BARE, "-DMORE=CELL;0.01"]
    configure("built", *options, "-DOPTIONS=CELL;0.01", "-DROBOT=STOP;0.001;WARN;0.002")
    build("built")
    answers("built/consumer", "built/guard")
    for file, baked in ("plate.obj", "parts"), ("peg.obj", "parts"), ("arm.urdf", "arm"), ("peg.obj", "arm"):
        Path("firmware", file).touch()
        bakes("built", baked, f"{file} changed")
    configure("built", "-DROBOT=STOP;0.001;CELL;0.0001")
    bakes("built", "arm", "an option changed")
    # Each error is named. Meshes that are queried together need one cell.
    mesh, arm = r"flashbvh_add_mesh\(parts\): give SOURCES mesh", r"flashbvh_add_robot\(arm\): give URDF file"
    refuses(mesh + ".* not understood: CEL;1", *options, "-DOPTIONS=CEL;1")
    refuses(arm + ".* not understood: CEL;1", *options, "-DOPTIONS=CELL;0.01", "-DROBOT=CEL;1")
    refuses("FLASHBVH_HOST_TOOL: there is no /nowhere/flashbvh; give the path", *options, "-DFLASHBVH_HOST_TOOL=/nowhere/flashbvh")
    refuses(r"need the same cell: name them in one flashbvh_add_mesh\(\)", *options, "-DOPTIONS=CELL;0.02")
    configure("apart", *options, "-DOPTIONS=CELL;0.02;OWN_CELL")


def find_package():
    """`lib` and `tools` build without `tests`. What they install can be moved, and has no path of the machine that built
    it. Natively a project links its libraries; crossing it compiles them for the flags of the targets FLASHBVH_LINK."""
    need("arm-none-eabi-g++")
    Path("copy").mkdir()
    shutil.copy(f"{ROOT}/CMakeLists.txt", "copy")
    for folder in "lib", "tools":
        shutil.copytree(f"{ROOT}/{folder}", f"copy/{folder}")
    configure("library", "-DFLASHBVH_BUILD_TESTS=OFF", "-DFLASHBVH_WASM_COMPILER=OFF", source="copy")
    build("library")
    os.environ["PATH"] += f":{Path('library/bin').absolute()}"
    refuses('package configuration file provided by "flashbvh"', "-DCMAKE_FIND_USE_CMAKE_SYSTEM_PATH=FALSE")
    made = Path("made").absolute()
    hold(run(CMAKE, "--install", "library", "--prefix", made), "install")
    prefix = made.rename(made.parent / "moved here")
    for folder in prefix / "include", prefix / "share", *prefix.glob("lib*/cmake"):
        for file in filter(Path.is_file, folder.rglob("*")):
            hold(FOLDER not in file.read_text(errors="replace"), f"absolute paths: {file}")
    at = f"-DCMAKE_PREFIX_PATH={prefix}"
    configure("built", at, f"-DVERSION={version()}", "-DROBOT=STOP;0.001", *BARE)
    build("built")
    answers("built/consumer", "built/guard")
    refuses('compatible with requested version "99"', at, "-DVERSION=99")
    Path("toolchain.cmake").write_text("set(CMAKE_SYSTEM_NAME Generic)\nset(CMAKE_SYSTEM_PROCESSOR arm)\n"
                                       "set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)\n")
    os.environ.update(CC="arm-none-eabi-gcc", CXX="arm-none-eabi-g++")
    package = next(prefix.rglob("flashbvhConfig.cmake")).parent
    configure("cross", f"-DCMAKE_TOOLCHAIN_FILE={Path('toolchain.cmake').absolute()}", f"-Dflashbvh_DIR={package}",
              f"-DMACHINE={MACHINE}", "-DFLASHBVH_LINK=machine", "-DROBOT=", *BARE)
    build("cross", "--target", "parts", "arm", "flashbvh", "flashbvh_robot_lib", "--", "-v")
    compiled = [line for line in log.splitlines() if " -c " in line]
    hold(len(compiled) > 50, "few sources")
    hold(all(MACHINE.split(";")[-1] in line for line in compiled), "compiled for another machine")


def lib_alone():
    """`lib`, copied alone, builds by its CMake file and by `g++ -c` of its sources."""
    shutil.copytree(f"{ROOT}/lib", "alone")
    configure("built", "-Werror=dev", source="alone")
    build("built")
    hold(Path("built/libflashbvh_robot.a").exists(), "no library")
    hold(run(*LAUNCHER.split(), "g++", "-std=c++17", "-Ialone/include", "-c", *Path("alone/src").glob("*/*.cpp")), "g++ -c")
    answers_as_the_readme("-Ialone/include", "built/libflashbvh.a")


def answers_as_the_readme(*library):
    """The README's program, built with this library, prints its output."""
    hold(run(sys.executable, f"{ROOT}/tests/docs/snippets.py", "."), "snippets")
    hold(run(FLASHBVH, "bake", "firmware/plate.obj", "firmware/peg.obj", "--unit", "mm", "--format", "c", "-o", "."), "bake")
    hold(run("g++", "-std=gnu++17", "-I.", "readme.cpp", "plate.fbvh.c", "peg.fbvh.c", *library, "-o", "readme"), "README")
    hold(run("./readme") and log == Path("readme.text").read_text(), "other answers of the README")


def two_files():
    """The two files, compiled with all warnings, answer like the library: the digest and a robot's guard; C's is C99."""
    hold(run(f"{ROOT}/tools/amalgamation.py", "two"), "two files")
    warnings = "-Wall -Wextra -Wconversion -Wshadow -Wdouble-promotion -Werror -Wno-sign-conversion".split()
    cxx = [*LAUNCHER.split(), "g++", "-std=c++17", "-ffp-contract=off", "-Itwo"]
    for file in "flashbvh", "flashbvh_robot":
        hold(run(*cxx, *warnings, "-c", f"two/{file}.cpp", "-o", f"{file}.o"), file)
    answers_as_the_readme("-Itwo", "flashbvh.o")
    # The digest includes headers of detail/. Those in the two files become stubs, the others are copied.
    whole = Path("two/flashbvh.hpp").read_text()
    for file in Path(ROOT, "lib/include/flashbvh").glob("detail/*/*"):
        name = file.relative_to(f"{ROOT}/lib/include")
        Path("two", name).parent.mkdir(parents=True, exist_ok=True)
        is_held = re.sub(r"\W", "_", f"{name}").upper() in whole
        Path("two", name).write_text('#include "flashbvh.hpp"\n' if is_held else file.read_text())
    hold(run(*cxx, *Path(ROOT, "tests/digest").glob("*.cpp"), "flashbvh.o", f"-I{ROOT}/tests", "-o", "digest"),
         "the digest")
    answers("digest")
    hold("3584 queries" in log, "no digest")
    example = Path(ROOT, "firmware_examples/robot_guard")
    arm = example / "cell_arm"
    hold(run(FLASHBVH, "robot", arm / "cell_arm.urdf", "--stop", "0.005", "--warn", "0.03", "-o", "."), "robot")
    hold(run(*cxx, "-I.", f"-I{example}", f"-I{arm}", f"-I{ROOT}/firmware_examples/host", example / "main.cpp", "-x", "c++",
             "cell_arm.robot.c", "-x", "none", "flashbvh.o", "flashbvh_robot.o", "-o", "guard"), "the guard")
    answers("guard")
    hold(re.fullmatch(re.escape((arm / "expected.txt").read_text()).replace(r"\#", r"\d*"), log), "the guard's answers")
    Path("c.c").write_text('#include "flashbvh.h"\nint main(void) { return FLASHBVH_STATUS_DONE; }\n')
    hold(run("cc", "-std=c99", "-pedantic", *warnings, "-Itwo", "-c", "c.c"), "C99")
    # After other vendors' macros; an older C++ is reported.
    Path("sketch.cpp").write_text(after_macros("flashbvh.h", "flashbvh_robot.hpp"))
    hold(run(*cxx, "-fsyntax-only", "sketch.cpp"), "macros")
    hold(not run(*cxx, "-std=c++14", "-fsyntax-only", "sketch.cpp") and "flashbvh needs C++17: set" in log, "C++14")


def copied():
    """quick_start, copied out of the tree: make builds it with the two files for a Cortex-M4F; QEMU runs it."""
    need("arm-none-eabi-g++", "qemu-system-arm", "make")
    hold(run(f"{ROOT}/tools/amalgamation.py", "two"), "two files")
    shutil.copytree(f"{ROOT}/firmware_examples/quick_start", "copied", ignore=shutil.ignore_patterns("build"))
    del os.environ["FLASHBVH"]  # which the Makefile reads, too
    os.environ["PATH"] = f"{Path(FLASHBVH).parent}:{os.environ['PATH']}"
    make = ["make", "-s", "--no-print-directory", "-C", "copied/cortex_m4", f"CC={LAUNCHER} arm-none-eabi-gcc -Werror",
            f"CXX={LAUNCHER} arm-none-eabi-g++ -Werror"]
    hold(not run(*make) and "no flashbvh in FLASHBVH=../../flashbvh: name the folder" in log, "no message")
    make.append(f"FLASHBVH={Path('two').absolute()}")
    hold(run(*make), "make")
    hold(run(*make, "run") and log == Path("copied/expected.txt").read_text(), "other answers")
    # A changed mesh is baked again: over a plate a millimetre higher, the peg is not free.
    plate = Path("copied/plate.obj")
    plate.write_text(plate.read_text().replace(" 0\n", " 1\n"))
    hold(not run(*make, "run") and "0.5 mm above the plate: touches\n" in log, "not the plate as it is")
    # The README's program, and its scale: two gears. QEMU's instruction takes 1 ns.
    hold(run(sys.executable, f"{ROOT}/tests/docs/snippets.py", "copied"), "snippets")
    shutil.copy(f"{ROOT}/firmware_examples/quick_start/plate.obj", "copied")
    shutil.copy("copied/readme.cpp", "copied/main.cpp")
    hold(run(*make, "run") and log.endswith(Path("copied/readme.text").read_text()), "other answers of the README")
    counts_of_gears(make)
    # In C: the guide's program, which exits with 0 if its answers are right.
    shutil.copy(f"{ROOT}/firmware_examples/quick_start/plate.obj", "copied")
    shutil.copy(f"{ROOT}/firmware_examples/quick_start/peg.obj", "copied")
    for file in "copied/main.cpp", "copied/cortex_m4/build/main.o", "copied/cortex_m4/build/main.d":
        os.remove(file)
    shutil.copy(f"{ROOT}/tests/docs/guide.c", "copied/main.c")
    hold(run(*make, "run"), "C")


def counts_of_gears(make):
    """The README's scale: bytes of two gears, as they are and within 0.05 mm, and instructions of a query of both."""
    hold(run(sys.executable, "-B", f"{ROOT}/firmware_examples/meshes.py", "gear", 25, 6, 50000), "gear")
    for name in "plate", "peg":
        Path(f"copied/{name}.obj").write_text(log)  # in thousandths of a millimetre
    shutil.copy(HERE / "consumer/gears.cpp", "copied/main.cpp")
    gears = "copied/plate.obj", "copied/peg.obj", "--unit", "um", "-o", "gears"
    said = []
    for command in [FLASHBVH, "bake", *gears, "--simplify", 50], [*make, "run", "QEMU=-icount shift=0"]:
        hold(run(*command), "gears")
        said.append(f"{round(int(re.search(r'^total +([0-9]+)', log, re.M)[1]) / 1000)} KB")
    said = f"take {said[1]}, or {said[0]} within 0.05 mm", f"takes {round(int(log.split()[-1]), -4):,} instructions"
    readme = " ".join(Path(ROOT, "README.md").read_text().split())
    hold(all(words in readme for words in said), f"the README does not say: {said}")


def manifests():
    """Each manifest has the library's version and names what is there; ESP-IDF and Zephyr are given all sources."""
    hold(run(f"{ROOT}/tools/amalgamation.py", "two"), "two files")
    lib = Path(ROOT, "lib")
    arduino = dict(line.split("=", 1) for line in Path("two/library.properties").read_text().splitlines())
    platformio = json.loads((lib / "library.json").read_text())
    esp_idf, zephyr = (dict(re.findall(r"^ *(\w+): *(.*)$", (lib / file).read_text(), re.M))
                       for file in ("idf_component.yml", "zephyr/module.yml"))
    build = platformio["build"]
    versions = arduino["version"], platformio["version"], esp_idf["version"].strip('"')
    for folder in lib, Path("two"), Path(ROOT, "tools/npm"):
        hold("](" not in (folder / "README.md").read_text(), f"{folder}/README.md links what its package has not")
    hold({*versions} == {version()}, f"versions: {versions}")
    for path in (Path("two", arduino["includes"]), lib / build["srcDir"], lib / zephyr["cmake"] / "CMakeLists.txt",
                 lib / zephyr["kconfig"], *(lib / build["includeDir"] / name for name in platformio["headers"])):
        hold(path.exists(), f"no {path}")
    calls = "idf_component_register", "zephyr_include_directories", "zephyr_library_named", "zephyr_library_sources"
    Path("calls.cmake").write_text("".join(f'macro({call})\nmessage("{call};${{ARGN}}")\nendmacro()\n' for call in calls)
                                   + "include(${FILE})\n")
    sources = {file.resolve() for file in lib.glob("src/*/*.cpp")}
    robot = {file for file in sources if re.search(r"/(robot/|c/c_robot_)[^/]*$", str(file))}
    for file, options, given in (("CMakeLists.txt", ["ESP_PLATFORM"], sources), ("zephyr/CMakeLists.txt", [], set()),
                                 ("zephyr/CMakeLists.txt", ["CONFIG_FLASHBVH"], sources - robot),
                                 ("zephyr/CMakeLists.txt", ["CONFIG_FLASHBVH", "CONFIG_FLASHBVH_ROBOT"], sources)):
        hold(run(CMAKE, f"-DFILE={lib / file}", *(f"-D{option}=y" for option in options), "-P", "calls.cmake"), file)
        named = {Path(name).resolve() for name in re.findall(r"[^;\n]+\.cpp", log)}
        hold(named == given, f"{file}, {options}: other sources")


def npm():
    """The program as npm package, from nothing, bakes what this one bakes."""
    need("emcc", "node")
    hold(run(f"{ROOT}/tools/npm/build.py"), "build.py")
    tarfile.open(f"{ROOT}/build/npm/flashbvh-{version()}.tgz").extractall()
    for folder, program in ("native", FLASHBVH), ("node", "package/flashbvh.js"):
        hold(run(program, "bake", "firmware/plate.obj", "firmware/peg.obj", "--unit", "mm", "-o", folder), program)
    hold(run("diff", "-r", "native", "node"), "other bytes")


def warnings():
    """The public headers compile after other vendors' macros, and they and the sources under warnings of users that
    ours do not include, as errors."""
    lib = Path(ROOT, "lib")
    headers = sorted(str(header.relative_to(lib / "include")) for header in lib.glob("include/flashbvh/**/*.h*")
                     if "detail" not in header.parts)
    for suffix, found in (".cpp", headers), (".c", [name for name in headers if name.endswith(".h")]):
        Path("all" + suffix).write_text(after_macros(*found))
    sources = [source for source in lib.glob("src/*/*.cpp")]
    hold(len(headers) > 40 and len(sources) > 60, "few files")
    strictly = ["-std=c++17", "-fno-exceptions", "-fno-rtti", "-fsyntax-only", "-I", lib / "include",
                *("-Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Wundef -Wold-style-cast"
                  " -Wdouble-promotion -Weffc++ -Werror").split()]
    arm = "arm-none-eabi-g++", "-mthumb"
    for compiler in (["g++"], ["clang++"], [*arm, "-mcpu=cortex-m0"], [*arm, "-mcpu=cortex-m3"],
                     [*arm, "-mcpu=cortex-m4", "-mfloat-abi=hard"], [*arm, "-mcpu=cortex-m55", "-mfloat-abi=hard"]):
        if shutil.which(compiler[0]):
            hold(run(*compiler, *strictly, "all.cpp", *sources), f"warnings: {' '.join(compiler)}")
    hold(run("gcc", "-std=c99", "-fsyntax-only", "-I", lib / "include", "-Wall", "-Wextra", "-Wpedantic",
             "-Wconversion", "-Wsign-conversion", "-Wundef", "-Werror", "all.c"), "C")


def enter(way):
    """A separate folder with the firmware project. Programs compiled there hardly run, so they are unoptimised."""
    work = Path(FOLDER, way)
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    os.chdir(work)
    shutil.copytree(HERE / "consumer", "firmware")
    for mesh in Path(ROOT, "firmware_examples/quick_start").glob("*.obj"):
        shutil.copy(mesh, "firmware")
    launcher = Path("unoptimised").absolute()
    launcher.write_text(f'#!/bin/sh\nexec {LAUNCHER} "$@" -O0\n')
    launcher.chmod(0o755)
    os.environ.update(CMAKE_C_COMPILER_LAUNCHER=str(launcher), CMAKE_CXX_COMPILER_LAUNCHER=str(launcher))


if __name__ == "__main__":
    way = globals()[sys.argv[1]]
    enter(way.__name__)
    way()
