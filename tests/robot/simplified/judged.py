"""judged.py BIN OUT CONFIGURATIONS KR5.urdf SO_ARM MOVEIT [MORE]

Bakes five robots, simplified, with BIN/flashbvh into OUT; their verdicts must be those of the unsimplified robots.
Judges each guard by the URDF's own meshes with BIN/flashbvh_judge and prints its rows: no pair may come nearer than
the stop distance. With MORE, a length in metres, each guard is held to a stop distance larger by MORE, which it
cannot keep.
KR5.urdf: tools/kr5.sh; SO_ARM: TheRobotStudio/SO-ARM100; MOVEIT: moveit/moveit_resources.
"""
from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

STOP = "0.005"


def robots(kr5: str, so_arm: str, moveit: str) -> dict[str, tuple[list[str], list[str]]]:
    """Arguments that describe the robot and its simplification, by name."""
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


def verdicts(flashbvh: str, *arguments: str) -> tuple[str, list[list[str]]]:
    """Returns the report on simplifying, and each pair's verdict."""
    command = [flashbvh, "robot", *arguments, "--stop", STOP, "--warn", "0.03", "--json"]
    said = json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout)
    deviation = f"{said['flash_bytes']} bytes, leaves of {said['leaf_size']}, within {1000 * said['deviation']:.3f} mm"
    return deviation, [[pair["a"], pair["b"], pair["verdict"]] for pair in said["pairs"]]


def main() -> int:
    binaries, out, configurations, kr5, so_arm, moveit, *more = sys.argv[1:]
    is_bad = False
    for name, (robot, simplified) in robots(kr5, so_arm, moveit).items():
        folder = Path(out) / name
        flashbvh = f"{binaries}/flashbvh"
        said, made = verdicts(flashbvh, *robot, *simplified, "--format", "image", "-o", str(folder))
        # Firmware cannot hold all of SO-101's triangles; the verdicts are of all triangles.
        options = [*simplified[2:], *(["--simplify", "0.0001"] if name == "so101" else [])]
        _, full = verdicts(flashbvh, *robot, *options, "--format", "image", "-o", f"{folder}-full")
        differing = [pair for pair, other in zip(made, full) if pair != other]
        print(f"{name}: {said}; {len(made)} verdicts, {len(differing)} of them others than of all triangles", *differing,
              flush=True)
        is_bad = is_bad or bool(differing)
        image = str(next(folder.glob("*.robot")))
        ran = subprocess.run([f"{binaries}/flashbvh_judge", image, *robot, "--stop", STOP, "--configurations",
                              configurations, *(["--more", more[0]] if more else [])], check=False)
        is_bad = is_bad or ran.returncode != 0
    return 1 if is_bad else 0


if __name__ == "__main__":
    sys.exit(main())
