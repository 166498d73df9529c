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
GENERATORS = "Ninja", "Unix Makefiles"
# No package but the compiler's: the build must not look for these.
BARE = [f"-DCMAKE_DISABLE_FIND_PACKAGE_{name}=TRUE" for name in
        ("assimp", "CLI11", "nlohmann_json", "Catch2", "urdfdom")]
LAUNCHER = os.environ.get("CMAKE_CXX_COMPILER_LAUNCHER", "")
IN_SOURCES = ["-DWAY=add_subdirectory", f"-DFLASHBVH_ROOT={ROOT}"]
WITH_TOOL = [*IN_SOURCES, f"-DFLASHBVH_HOST_TOOL={FLASHBVH}"]
log = ""


class Failed(Exception):
    pass


def hold(good, otherwise):
    if not good:
        raise Failed(otherwise)


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


def cmake(build, *options, source="firmware", generator="Ninja"):
    return run(CMAKE, "-G", generator, "-S", source, "-B", build, *options)


def configure(build, *options, **more):
    hold(cmake(build, *options, **more), f"configure: {options}")


def refuses(said, *options, **more):
    """CMake fails with this message."""
    shutil.rmtree("wrong", ignore_errors=True)
    hold(not cmake("wrong", *options, **more), f"accepted: {options}")
    hold(re.search(said, " ".join(log.split())), f"no '{said}'")


def build(folder):
    hold(run(CMAKE, "--build", folder), f"build {folder}")


def bakes(folder, why, baked="parts"):
    build(folder)
    hold(f"Baking {baked}" in log, f"not baked: {why}")


def rests(folder, why="nothing changed", baked="parts"):
    """The build does not call the tool."""
    build(folder)
    hold(f"Baking {baked}" not in log, f"baked without a reason: {why}")


def answers(*programs):
    for program in programs:
        hold(run(f"./{program}"), f"wrong answers: {program}")


def holds(file, pattern):
    return re.search(pattern, Path(file).read_text(errors="replace"))


def edit(file, *changes):
    text = Path(file).read_text()
    for old, new in changes:
        text = text.replace(old, new)
    Path(file).write_text(text)


def package_in(prefix):
    return next(Path(prefix).absolute().rglob("flashbvhConfig.cmake")).parent


def enter_cross_environment():
    """Sets the compiler of a cross build in the environment."""
    need("arm-none-eabi-g++")
    Path("toolchain.cmake").write_text("set(CMAKE_SYSTEM_NAME Generic)\nset(CMAKE_SYSTEM_PROCESSOR arm)\n"
                                       "set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)\n")
    flags = "-mcpu=cortex-m4 -mthumb -DFOR_THE_TARGET"
    os.environ.update(CC="arm-none-eabi-gcc", CXX="arm-none-eabi-g++", LDFLAGS="--specs=nosys.specs", CFLAGS=flags,
                      CXXFLAGS=flags, CMAKE_TOOLCHAIN_FILE=str(Path("toolchain.cmake").absolute()))


def for_the_target(program):
    hold(run("arm-none-eabi-readelf", "-h", program) and re.search("Machine: *ARM", log), f"{program} is no ARM program")


def bakes_on_change(baked, program, others, sources, options, header, effect):
    """With Ninja and with make: bakes if one of the sources, the options or the tool changes, and not if others do.
    `options`: the first ones and other ones, which have an effect on the header."""
    Path("tool").mkdir()
    tool = shutil.copy(FLASHBVH, Path("tool/flashbvh").absolute())  # to be touched
    for generator in GENERATORS:
        configure("built", *IN_SOURCES, f"-DFLASHBVH_HOST_TOOL={tool}", options[0], *BARE, generator=generator)
        bakes("built", "the first time", baked)
        answers(program)
        rests("built", baked=baked)
        configure("built", options[0], generator=generator)
        rests("built", "configured again", baked)
        for file in others:
            Path("firmware", file).touch()
        rests("built", f"{others} changed", baked)
        for file in sources:
            Path("firmware", file).touch()
            bakes("built", f"{file} changed", baked)
            rests("built", f"nothing changed since {file}", baked)
        configure("built", options[1], generator=generator)
        bakes("built", "an option changed", baked)
        hold(holds(header, effect), "the option has no effect")
        rests("built", "nothing changed since the option", baked)
        Path(tool).touch()
        bakes("built", "the tool changed", baked)
        answers(program)
        shutil.rmtree("built")


def add_subdirectory():
    """add_subdirectory() and flashbvh_add_mesh()."""
    bakes_on_change("parts", "built/consumer", ["main.cpp"], ["peg.obj"], ["-DOPTIONS=CELL;0.01", "-DOPTIONS=CELL;0.02"],
                    "built/flashbvh/parts/peg.fbvh.h", "_CELL 0.02 ")
    # Each error is named.
    refuses(r"flashbvh_add_mesh\(parts\): give SOURCES mesh... and options with their values; not understood: CEL;1",
            *WITH_TOOL, "-DOPTIONS=CEL;1")
    refuses("not understood: CELL", *WITH_TOOL, "-DOPTIONS=CELL")
    refuses("FLASHBVH_HOST_TOOL: there is no /nowhere/flashbvh; give the path", *IN_SOURCES,
            "-DFLASHBVH_HOST_TOOL=/nowhere/flashbvh")


def robot():
    """flashbvh_add_robot()."""
    bakes_on_change("arm", "built/guard", ["guard.cpp", "plate.obj"], ["peg.obj", "arm.urdf"],
                    ["-DROBOT=STOP;0.001;WARN;0.002", "-DROBOT=LEAF_SIZE;2;CELL;0.0001"],
                    "built/flashbvh/arm/arm.robot.h", "_CELL (1e-04|0.0001) ")
    # Each error is named.
    words = (r"flashbvh_add_robot\(arm\): give URDF file and options with their values, PACKAGE as name=folder, PAIR "
             "as link,link=length, ZONE as joint=length; not understood:")
    refuses(f"{words} CEL;1", *WITH_TOOL, "-DROBOT=CEL;1")
    refuses(f"{words} WAR=1", *WITH_TOOL, "-DROBOT=VISUAL_TOO;WAR=1")
    refuses(f"{words} CELL", *WITH_TOOL, "-DROBOT=CELL")
    refuses(f"{words} parts", *WITH_TOOL, "-DROBOT=PACKAGE;parts")
    edit("firmware/CMakeLists.txt", ("URDF arm.urdf PACKAGE", "PACKAGE"))
    refuses(words, *WITH_TOOL, "-DROBOT=")
    edit("firmware/CMakeLists.txt", ("(arm PACKAGE", "(arm-1 URDF arm.urdf PACKAGE"), ("arm::arm", "arm-1"))
    refuses(r"flashbvh_add_robot\(arm-1\): names in the code begin with the name", *WITH_TOOL, "-DROBOT=")


def cells():
    """Meshes that are queried together need one cell: a program that links two libraries of meshes with different cells
    fails to configure, and the message gives the fix."""
    shutil.copy("firmware/peg.obj", "firmware/tool.obj")

    def of(options, more):
        """The options of the first library and the second."""
        shutil.rmtree("built", ignore_errors=True)
        return [*WITH_TOOL, *BARE, f"-DOPTIONS={options}", f"-DMORE={more}"]

    for options, more in (("", ""), ("CELL;0.01", ""), ("CELL;0.01", "CELL;0.02"),
                          ("CELL;0.01;FORMAT;both", "CELL;0.02;FORMAT;image")):
        refuses(r"need the same cell: name them in one flashbvh_add_mesh\(\), or give each the same CELL, written "
                r'alike; OWN_CELL for meshes that are not\] property of "more" does not agree', *of(options, more))
    configure("built", *of("CELL;0.01", "CELL;0.01"))
    configure("built", *of("", "OWN_CELL"))
    configure("built", *of("OWN_CELL", "CELL;0.01"))
    build("built")
    answers("built/consumer")
    # A C compiler accepts them, too.
    edit("firmware/CMakeLists.txt", ("LANGUAGES CXX", "LANGUAGES C CXX"))
    configure("built", *of("CELL;0.01", "CELL;0.01;FORMAT;c"))
    build("built")
    hold(Path("built/flashbvh/more/tool.fbvh.c").exists(), "no C")
    hold(not Path("built/flashbvh/more/tool.fbvh").exists(), "an image that was not requested")


def cross():
    """A cross build with its compiler, flags and toolchain file in the environment: they apply to the library and the
    baked code, not to the tool, which the project builds for this machine."""
    enter_cross_environment()
    configure("built", *IN_SOURCES, "-DOPTIONS=CELL;0.01")
    bakes("built", "the first time")
    for_the_target("built/consumer")
    hold(holds("built/build.ninja", "FOR_THE_TARGET"), "the flags don't reach the firmware")
    host = Path("built/flashbvh-host")
    hold(os.access(host / "bin/flashbvh", os.X_OK), "no tool")
    for file in "CMakeCache.txt", "build.ninja":
        hold(not holds(host / file, "FOR_THE_TARGET"), f"the target's flags reach the tool: {file}")
    rests("built")


def find_package():
    """An installed package: natively with its libraries and its tool; in a cross build it compiles the libraries for
    the target. It can be moved, and contains no path of the machine that built it."""
    made = Path("made").absolute()
    need("arm-none-eabi-g++")
    hold(run(CMAKE, "--install", f"{FOLDER}/cross/built/flashbvh-host", "--prefix", made), "install")
    prefix = made.rename(made.parent / "moved here")
    # A path that begins there; "${folder}/project" does not refer to a checkout in /project.
    place = rf"(^|[^A-Za-z0-9_.}}/-])({re.escape(ROOT)}|{re.escape(FOLDER)})(/|[^A-Za-z0-9_.-]|$)"
    for folder in prefix / "include", prefix / "share", *prefix.glob("lib*/cmake"):
        for file in filter(Path.is_file, folder.rglob("*")):
            hold(not re.search(place, file.read_text(errors="replace"), re.M), f"absolute paths: {file}")
    hold(run(prefix / "bin/flashbvh", "--version") and "flashbvh" in log, "no tool")
    version = re.match(r"flashbvh (\d+\.\d+)", log)[1]
    hold(any(prefix.rglob("libflashbvh.a")), "no library")

    at = f"-DCMAKE_PREFIX_PATH={prefix}"
    configure("built", at, f"-DVERSION={version}", "-DROBOT=STOP;0.001", *BARE)
    bakes("built", "the first time")
    answers("built/consumer", "built/guard")
    rests("built")
    (prefix / "bin/flashbvh").touch()
    bakes("built", "the tool changed")
    refuses('compatible with requested version "99"', at, "-DVERSION=99")

    enter_cross_environment()
    configure("cross", f"-Dflashbvh_DIR={package_in(prefix)}", "-DROBOT=")
    bakes("cross", "the first time, crossing")
    for_the_target("cross/consumer")
    for_the_target("cross/guard")


def machine_target():
    """The machine's flags reach firmware only by a target, like Zephyr's: FLASHBVH_LINK passes them to the library and
    the baked meshes, from sources and from a package."""
    enter_cross_environment()
    os.environ.update(CXXFLAGS="", CFLAGS="")
    flags = "-mcpu=cortex-m4;-mthumb;-mfloat-abi=hard;-mfpu=fpv4-sp-d16"
    configure("library", "-DFLASHBVH_BUILD_TOOL=OFF", *BARE, source=ROOT)
    hold(run(CMAKE, "--install", "library", "--prefix", "prefix"), "install")
    for way in "add_subdirectory", "find_package":
        configure(way, f"-DWAY={way}", f"-DFLASHBVH_ROOT={ROOT}", f"-DFLASHBVH_HOST_TOOL={FLASHBVH}",
                  f"-Dflashbvh_DIR={package_in('prefix')}", f"-DMACHINE={flags}", "-DROBOT=",
                  "-DFLASHBVH_LINK=machine", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON", *BARE)
        commands = [line for line in Path(f"{way}/compile_commands.json").read_text().splitlines()
                    if '"command"' in line]
        hold(len(commands) > 10, f"few sources: {way}")
        for command in commands:
            hold(flags.split(";")[-1] in command, f"compiled for another machine: {way}: {command}")
        build(way)
        for_the_target(f"{way}/consumer")
    # Without it, linking fails.
    configure("wrong", *WITH_TOOL, f"-DMACHINE={flags}", *BARE)
    hold(not run(CMAKE, "--build", "wrong"), "linked with a library for another machine")


def runtime_only():
    """Firmware that links prebaked arrays needs neither the tool nor assimp, CLI11, nlohmann_json, urdfdom or
    Catch2, whichever way it includes the library."""
    hold(run(FLASHBVH, "bake", "firmware/plate.obj", "firmware/peg.obj", "-o", "baked", "--format", "c"), "bake")
    configure("library", "-DFLASHBVH_BUILD_TOOL=OFF", *BARE, source=ROOT)
    build("library")
    hold(run(CMAKE, "--install", "library", "--prefix", "prefix"), "install")
    hold(not Path("prefix/bin").exists(), "a program was installed")
    at = f"-DCMAKE_PREFIX_PATH={Path('prefix').absolute()}"
    for way in "add_subdirectory", "fetch_content", "find_package":  # FetchContent from a local folder
        configure(way, f"-DWAY={way}", f"-DFLASHBVH_ROOT={ROOT}", f"-DBAKED={Path('baked').absolute()}", at, *BARE)
        build(way)
        answers(f"{way}/consumer")
        hold(not Path(way, "flashbvh-host").exists(), "the tool was built")
    # The package without the tool reports that it needs one to bake, and uses a given one.
    refuses("set FLASHBVH_HOST_TOOL to its path", at)
    configure("with_tool", at, f"-DFLASHBVH_HOST_TOOL={FLASHBVH}")
    bakes("with_tool", "the first time")
    answers("with_tool/consumer")
    # flashbvh's own build does look for them, and its message names the option to avoid this.
    refuses("assimp not found: apt-get install .*FLASHBVH_BUILD_TOOL=OFF", *BARE, source=ROOT)


def two_files():
    """The two files, compiled with all warnings, answer like the library: the digest and a robot's guard; C's is C99."""
    hold(run(f"{ROOT}/tools/amalgamation.py", "two"), "two files")
    warnings = "-Wall -Wextra -Wconversion -Wshadow -Wdouble-promotion -Werror -Wno-sign-conversion".split()
    cxx = [*LAUNCHER.split(), "g++", "-std=c++17", "-ffp-contract=off", "-Itwo"]
    for file in "flashbvh", "flashbvh_robot":
        hold(run(*cxx, *warnings, "-c", f"two/{file}.cpp", "-o", f"{file}.o"), file)
    # The digest uses names of detail/ that the two files hide; everything else comes from them.
    hold(run(*cxx, *Path(ROOT, "tests/digest").glob("*.cpp"), "flashbvh.o", f"-I{ROOT}/tests", "-idirafter",
             f"{ROOT}/lib/include", "-o", "digest"), "the digest")
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
    # After Arduino.h, whose macros take these names; an older C++ is reported.
    macros = [f"#define {name}(...) +\n" for name in "min max abs round radians degrees sq bit word constrain F".split()]
    macros += [f"#define {name} +\n" for name in "PI B0 B1 A0 A1 HIGH LOW INPUT OUTPUT CHANGE DEFAULT EULER".split()]
    Path("sketch.cpp").write_text("#include <stdlib.h>\n" + "".join(macros) + "#include <flashbvh.h>\n#include <flashbvh_robot.hpp>\n")
    hold(run(*cxx, "-fsyntax-only", "sketch.cpp"), "Arduino's macros")
    hold(not run(*cxx, "-std=c++14", "-fsyntax-only", "sketch.cpp") and "flashbvh is C++17: set" in log, "C++14")


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
    edit("copied/plate.obj", (" 0\n", " 1\n"))
    hold(not run(*make, "run") and "0.5 mm above the plate: touches\n" in log, "not the plate as it is")
    # In C: the guide's program, which exits with 0 if its answers are right.
    shutil.copy(f"{ROOT}/firmware_examples/quick_start/plate.obj", "copied")
    for file in "copied/main.cpp", "copied/cortex_m4/build/main.o", "copied/cortex_m4/build/main.d":
        os.remove(file)
    shutil.copy(f"{ROOT}/tests/docs/guide.c", "copied/main.c")
    hold(run(sys.executable, f"{ROOT}/tests/docs/snippets.py", "copied"), "snippets")
    hold(run(*make, "run"), "C")


def version():
    return ".".join(re.findall(r"_(?:MAJOR|MINOR|PATCH) (\d+)", Path(ROOT, "lib/include/flashbvh/version.hpp").read_text()))


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


def lib_alone():
    """`lib`, copied alone, builds by its CMake file and by `g++ -c` of its sources."""
    shutil.copytree(f"{ROOT}/lib", "alone")
    configure("built", "-Werror=dev", source="alone")
    build("built")
    hold(Path("built/libflashbvh_robot.a").exists(), "no library")
    hold(run(*LAUNCHER.split(), "g++", "-std=c++17", "-Ialone/include", "-c", *Path("alone/src").glob("*/*.cpp")), "g++ -c")


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
        Path("all" + suffix).write_text('#include "vendor_macros.h"\n' + "".join(f'#include "{h}"\n' for h in found))
    sources = [source for source in lib.glob("src/*/*.cpp")]
    hold(len(headers) > 40 and len(sources) > 60, "few files")
    strictly = ["-std=c++17", "-fno-exceptions", "-fno-rtti", "-fsyntax-only", "-I", lib / "include", "-I", HERE,
                *("-Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Wundef -Wold-style-cast"
                  " -Wdouble-promotion -Weffc++ -Werror").split()]
    arm = "arm-none-eabi-g++", "-mthumb"
    for compiler in (["g++"], ["clang++"], [*arm, "-mcpu=cortex-m0"], [*arm, "-mcpu=cortex-m3"],
                     [*arm, "-mcpu=cortex-m4", "-mfloat-abi=hard"], [*arm, "-mcpu=cortex-m55", "-mfloat-abi=hard"]):
        if shutil.which(compiler[0]):
            hold(run(*compiler, *strictly, "all.cpp", *sources), f"warnings: {' '.join(compiler)}")
    hold(run("gcc", "-std=c99", "-fsyntax-only", "-I", lib / "include", "-I", HERE, "-Wall", "-Wextra", "-Wpedantic",
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


WAYS = (add_subdirectory, cells, machine_target, runtime_only, robot, warnings, cross, find_package, two_files,
        copied, manifests, lib_alone, npm)
THOROUGH_WAYS = (machine_target, cross, find_package, npm)

if __name__ == "__main__":
    chosen = next(way for way in WAYS if way.__name__ == sys.argv[1])
    if chosen in THOROUGH_WAYS and not os.environ.get("FLASHBVH_THOROUGH"):
        print(f"left out: FLASHBVH_THOROUGH=1 ctest --preset native-sanitize -R packaging/{chosen.__name__}")
        sys.exit(77)
    enter(chosen.__name__)
    try:
        chosen()
    except Failed as failure:
        sys.exit("\n".join([f"FAILED: {failure}", *log.splitlines()[-40:]]))
