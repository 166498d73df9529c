"""sound.py BIN OUT SECONDS KR5.urdf MOVEIT DATA

Bakes six robots with BIN/flashbvh into OUT, guards each for SECONDS on moves near contact with
BIN/flashbvh_near_contact, and prints a row for each: no verdict may be contradicted by distance queries.
KR5.urdf: tools/kr5.sh; MOVEIT: moveit/moveit_resources; DATA: Gepetto/example-robot-data, with a quadruped.
"""
from __future__ import annotations

import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent


def robots(kr5: str, moveit: str, data: str) -> dict[str, list[str]]:
    """Arguments of `flashbvh robot`, by robot. A quadruped's legs never come 5 mm from their hips."""
    arm = ["--stop", "0.005", "--warn", "0.01"]
    solo = f"{data}/robots/solo_description"
    return {
        "kr5": [kr5, *arm, "--pair", "forearm,palm=0.0005,0.001"],
        "panda": [f"{moveit}/panda_description/urdf/panda.urdf", *arm, "--package",
                  f"moveit_resources_panda_description={moveit}/panda_description"],
        "fanuc": [f"{moveit}/fanuc_description/urdf/fanuc.urdf", *arm, "--package",
                  f"moveit_resources_fanuc_description={moveit}/fanuc_description"],
        "two_arms": [str(HERE.parents[2] / "firmware_examples/two_arms/two_arms.urdf"), "--stop", "0.005",
                     "--warn", "0.03"],
        "solo12": [f"{solo}/robots/solo12.urdf", "--stop", "0.001", "--warn", "0.004", "--time", "30",
                   "--package", f"example-robot-data={data}"],
    }


def baked(flashbvh: str, folder: Path, arguments: list[str]) -> str:
    """Returns the image; bakes it unless it exists."""
    if not list(folder.glob("*.robot")):
        subprocess.run([flashbvh, "robot", *arguments, "--format", "image", "-o", str(folder)], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return str(next(folder.glob("*.robot")))


def main() -> int:
    binaries, out, seconds, *sources = sys.argv[1:]
    images = [baked(f"{binaries}/flashbvh", Path(out) / name, arguments)
              for name, arguments in robots(*sources).items()]
    return subprocess.run([f"{binaries}/flashbvh_near_contact", "--sound", seconds, *images, "arms"],
                          check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
