#!/usr/bin/env python3
"""cycles.py FOLDER    the model of cycles (lib/docs/cycles.md) against published figures

FOLDER holds checkouts of programs that others have published, with cycles measured on silicon, each in the folder
that ports/cycles/programs/published.csv names; programs that are missing are left out. Builds them for the
board of their core, runs them under the plugin, and prints each figure, what the model counts, and its error in
percent. Fails if an answer is wrong, or a figure misses the bar that published.csv sets.
"""
import csv
import os
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
BUILD = ROOT / "build/cycles"
TABLES = ROOT / "ports/cycles/tables"
PUBLISHED = ROOT / "ports/cycles/programs/published.csv"
MACHINES = {"cortex-m0": "microbit", "cortex-m3": "mps2-an385", "cortex-m4f": "mps2-an386"}


def quietly(*command):
    done = subprocess.run(command, cwd=ROOT, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode:
        sys.exit(f"{done.stdout}cycles.py: this failed: {' '.join(map(str, command))}")


def build(preset, folder):
    quietly("cmake", "--preset", preset, "-B", BUILD / preset, "-DFLASHBVH_BUILD_TESTS=OFF",
            f"-DFLASHBVH_CYCLES_PROGRAMS={folder}")
    quietly("cmake", "--build", BUILD / preset, "--target", "cycles_programs")


def options(row):
    plugin = [BUILD / row["preset"] / "bin/flashbvh_cycles.so", f"tables={TABLES}", f"core={row['core']}",
              "result=flashbvh.cycles"]
    if row["flash"]:
        plugin += [f"flash={row['flash']}", "flash_begin=0", "flash_kb=4096"]
    return f"-plugin {','.join(map(str, plugin))}"


def program_of(row):
    return BUILD / row["preset"] / "bin" / f"cycles_{row['program']}.elf"


def counted(row):
    """The program's figures, by name."""
    program = program_of(row)
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([ROOT / "ports/run", MACHINES[row["preset"]], program], cwd=folder, text=True,
                              stdout=subprocess.PIPE, env={**os.environ, "FLASHBVH_QEMU_OPTIONS": options(row)})
    if done.returncode:
        sys.exit(f"{done.stdout}cycles.py: {program.name} ended with status {done.returncode}")
    return {name: int(cycles) for _, name, cycles in map(str.split, done.stdout.splitlines())}


def main(*arguments):
    if len(arguments) != 1 or not Path(arguments[0]).is_dir():
        sys.exit(__doc__)
    folder = Path(arguments[0]).resolve()
    with PUBLISHED.open() as file:
        rows = [row for row in csv.DictReader(file) if (folder / row["folder"]).is_dir()]
    if not rows:
        sys.exit(f"cycles.py: {folder} has none of the folders that {PUBLISHED.relative_to(ROOT)} names")
    for preset in dict.fromkeys(row["preset"] for row in rows):
        build(preset, folder)
    rows = [row for row in rows if program_of(row).exists()]
    print("| program | core | flash | figure | published | model | error, % |\n|---|---|---|---|--:|--:|--:|")
    runs, misses = {}, 0
    for row in rows:
        run = row["program"], row["core"], row["flash"]
        if run not in runs:
            runs[run] = counted(row)
        published, model = float(row["cycles"]), runs[run][row["figure"]]
        error = 100 * (model / published - 1)
        missed = bool(row["bar"]) and abs(error) > float(row["bar"])
        misses += missed
        print(f"| {row['program']} | {row['core']} | {row['flash'] or '-'} | {row['figure']} | {row['cycles']} | {model} "
              f"| {error:+.1f}{' (missed)' * missed} |")
    return misses == 0


if __name__ == "__main__":
    sys.exit(not main(*sys.argv[1:]))
