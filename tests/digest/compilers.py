"""compilers.py WORK: the digest on this machine by each installed compiler, unoptimised and optimised, with 64 and 32
bits; with FLASHBVH_THOROUGH all combinations, with vector instructions and without, on x86 and Arm. Every program must
print equal output and exit with 0."""
import os
import platform
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
THOROUGH = bool(os.environ.get("FLASHBVH_THOROUGH"))
PORTABLE = "-DFLASHBVH_PORTABLE"
FLAGS = ("-std=c++17", "-Wall", "-Wextra", "-Werror", "-I.", "-Ilib/include", "-Itests")


def ways():
    """Compiler and options of each program, and the command that runs it."""
    found = [compiler for compiler in ("g++", "clang++") if shutil.which(compiler)]
    for i, compiler in enumerate(found):
        if THOROUGH:
            for options in ["-O0"], ["-O0", PORTABLE], ["-O3"], ["-O3", "-march=native"]:
                yield [], compiler, *options
        else:
            yield [], compiler, "-O0", *[PORTABLE] * (i > 0)
            yield [], compiler, "-Os" if i > 0 else "-O2"
    if THOROUGH:
        yield [], "g++", "-O3", PORTABLE
    # A 32-bit compiler, whose programs an x86-64 kernel runs.
    if shutil.which("i686-linux-gnu-g++") and platform.machine() == "x86_64":
        yield [], "i686-linux-gnu-g++", "-static", "-O0"
        if THOROUGH:
            yield [], "i686-linux-gnu-g++", "-static", "-O3", "-msse2", "-mfpmath=sse"
    else:
        print("no compiler for 32 bits here")
    # NEON, on an emulated core.
    if not THOROUGH:
        print("the other ways: FLASHBVH_THOROUGH=1 ctest --preset native-sanitize -R compiler")
    elif shutil.which("aarch64-linux-gnu-g++") and shutil.which("qemu-aarch64-static"):
        yield ["qemu-aarch64-static"], "aarch64-linux-gnu-g++", "-static", "-O3"
    else:
        print("no 64-bit Arm here")


def one_source(file, *patterns):
    """One source file compiles in half the time, and the library must support it."""
    sources = [path.relative_to(ROOT) for pattern in (*patterns, "tests/digest/*.cpp")
               for path in sorted(ROOT.glob(pattern))]
    file.write_text("".join(f'#include "{source}"\n' for source in sources))
    return file


def main(work):
    work = Path(work)
    work.mkdir(parents=True, exist_ok=True)
    whole = one_source(work / "all.cpp", "lib/src/*/*.cpp")
    # The sources that the digest needs.
    needed = one_source(work / "needed.cpp", "lib/src/[blpw]*/*.cpp", "lib/src/query/[!ds]*.cpp",
                        "lib/src/query/solid.cpp")
    answers = []
    for emulator, *command in ways():
        program = work / f"digest_{len(answers)}"
        source = whole if "-O0" in command else needed
        if subprocess.run([*command, *FLAGS, source, "-o", program], cwd=ROOT).returncode:
            sys.exit(f"compilers.py: does not build: {' '.join(command)}")
        try:
            done = subprocess.run([*emulator, program], stdout=subprocess.PIPE, text=True)
        except OSError as why:  # a kernel without 32-bit programs
            print(f"does not run here: {why.strerror}: {' '.join(command)}")
            continue
        answers.append((done.returncode, done.stdout))
        print(f"{'DIFFERENT ' if done.returncode else ''}{done.stdout.strip()}: {' '.join(command)}", flush=True)
    if len(answers) < 3:
        sys.exit("compilers.py: hardly a compiler was found")
    sys.exit(any(answer != (0, answers[0][1]) for answer in answers))


if __name__ == "__main__":
    main(*sys.argv[1:])
