"""Runs the firmware of this folder under QEMU."""
import os
import subprocess
import sys
from pathlib import Path

PORTS_RUN = Path(__file__).resolve().parents[2] / "ports/run"


def run(machine, program, timeout, options=""):
    """Returns its output; exits if it fails."""
    environment = {**os.environ, "FLASHBVH_TIMEOUT": str(timeout)}
    if options:
        environment["FLASHBVH_QEMU_OPTIONS"] = options
    done = subprocess.run([PORTS_RUN, machine, program], stdout=subprocess.PIPE, text=True, env=environment)
    if done.returncode:
        sys.exit(f"{Path(sys.argv[0]).name}: the firmware failed with status {done.returncode}")
    return done.stdout
