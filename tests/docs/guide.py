"""guide.py WORK FLASHBVH: the guide's commands, one after the other, and its Makefile, with this machine's
compilers."""
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]


def run(*command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode:
        sys.exit(f"{done.stdout}failed: {command}")
    return done.stdout


def blocks(language):
    return "".join(re.findall(rf"^```{language}\n(.*?)^```$", (ROOT / "lib/docs/guide.md").read_text(), re.M | re.S))


def main(work, flashbvh):
    shutil.rmtree(work, ignore_errors=True)
    folder = Path(work, "firmware")
    folder.mkdir(parents=True)
    os.chdir(folder)
    for mesh in (ROOT / "firmware_examples/quick_start").glob("*.obj"):
        shutil.copy(mesh, ".")
    shutil.copy(ROOT / "firmware_examples/robot_guard/cell_arm/cell_arm.urdf", ".")
    shutil.copy(HERE / "guide.c", "main.c")
    os.environ["PATH"] = f"{Path(flashbvh).parent}:{os.environ['PATH']}"

    log = run("sh", "-euc", blocks("sh"))
    for line in "^ *0 .* 0$", "^any pose: at most":
        if not re.search(line, log, re.M):
            sys.exit(f"{log}no '{line}'")
    for file in map(Path, ("pairs.txt", "report.html")):
        if not file.exists() or not file.stat().st_size:
            sys.exit(f"{log}no {file}")

    if not shutil.which("make"):
        sys.exit(77)
    Path("Makefile").write_text(blocks("make").replace("-O2", "-O0"))  # what it says of firmware is not run here
    run("make", f"FLASHBVH={ROOT}", f"BAKE={flashbvh} bake", f"CC={os.environ.get('CC', 'cc')}",
        f"CXX={os.environ.get('CXX', 'c++')}", "CPU=", "LDFLAGS=")
    run("./firmware.elf")


if __name__ == "__main__":
    main(*sys.argv[1:])
