"""judged.py BIN OUT CONFIGURATIONS KR5.urdf SO_ARM MOVEIT [MORE]

Bakes five robots, simplified, with BIN/flashbvh into OUT, judges each guard by the URDF's own meshes with
BIN/flashbvh_judge and prints its rows: none may come nearer than the stop distance. With MORE, a length in metres,
each guard is held to so much more than it was baked with, which it does not hold.
KR5.urdf: tools/kr5.sh; SO_ARM: TheRobotStudio/SO-ARM100; MOVEIT: moveit/moveit_resources.
"""
from __future__ import annotations

import subprocess
import sys
from pathlib import Path

STOP = "0.005"


def robots(kr5: str, so_arm: str, moveit: str) -> dict[str, tuple[list[str], list[str]]]:
    """By name, what describes the robot and how it is simplified."""
    simplified = ["--simplify", "0.0005"]
    fitted = ["--fit", "262144"]
    panda, fanuc = (f"{moveit}/{name}_description" for name in ("panda", "fanuc"))
    return {
        "so100": ([f"{so_arm}/Simulation/SO100/so100.urdf", "--visual-too"], fitted),
        "so101": ([f"{so_arm}/Simulation/SO101/so101_new_calib.urdf"], fitted),
        "panda": ([f"{panda}/urdf/panda.urdf", "--package", f"moveit_resources_panda_description={panda}"], simplified),
        "fanuc": ([f"{fanuc}/urdf/fanuc.urdf", "--package", f"moveit_resources_fanuc_description={fanuc}"], simplified),
        "kr5": ([kr5], [*simplified, "--pair", "forearm,palm=0.0005,0.001"]),
    }


def main() -> int:
    binaries, out, configurations, kr5, so_arm, moveit, *more = sys.argv[1:]
    is_bad = False
    for name, (robot, simplified) in robots(kr5, so_arm, moveit).items():
        folder = Path(out) / name
        if not list(folder.glob("*.robot")):
            subprocess.run([f"{binaries}/flashbvh", "robot", *robot, *simplified, "--stop", STOP, "--warn", "0.03",
                            "--format", "image", "-o", str(folder)], check=True, stdout=subprocess.DEVNULL,
                           stderr=subprocess.DEVNULL)
        image = str(next(folder.glob("*.robot")))
        ran = subprocess.run([f"{binaries}/flashbvh_judge", image, *robot, "--stop", STOP, "--configurations",
                              configurations, *(["--more", more[0]] if more else [])], check=False)
        is_bad = is_bad or ran.returncode != 0
    return 1 if is_bad else 0


if __name__ == "__main__":
    sys.exit(main())
