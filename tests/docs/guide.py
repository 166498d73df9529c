"""guide.py WORK FLASHBVH: runs the guide's commands in order."""
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
GUIDE = (ROOT / "lib/docs/guide.md").read_text()


def run(*command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode:
        sys.exit(f"{done.stdout}failed: {command}")
    return done.stdout


def commands():
    return "".join(re.findall(r"^```sh\n(.*?)^```$", GUIDE, re.M | re.S))


def main(work, flashbvh):
    shutil.rmtree(work, ignore_errors=True)
    folder = Path(work, "firmware")
    folder.mkdir(parents=True)
    os.chdir(folder)
    for mesh in (ROOT / "firmware_examples/quick_start").glob("*.obj"):
        shutil.copy(mesh, ".")
    shutil.copy(ROOT / "firmware_examples/robot_guard/cell_arm/cell_arm.urdf", ".")
    os.environ["PATH"] = f"{Path(flashbvh).parent}:{os.environ['PATH']}"

    log = run("sh", "-euc", commands())
    for line in "^ *0 .* 0$", "^any pose: at most", "^go$", "^stay$":
        if not re.search(line, log, re.M):
            sys.exit(f"{log}no '{line}'")
    for file in map(Path, ("pairs.txt", "report.html")):
        if not file.exists() or not file.stat().st_size:
            sys.exit(f"{log}no {file}")


if __name__ == "__main__":
    main(*sys.argv[1:])
