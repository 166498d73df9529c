"""Cards of work and instructions in pages; and an interrupted bake."""
import os
import re
import signal
import subprocess
import time
from math import ceil
from pathlib import Path

from checks import FLASHBVH, INCLUDE, flashbvh, hold, search, text


def cards(*arguments):
    """(work, instructions, verdict) of each of the eight cards."""
    flashbvh("report", *arguments, "-o", "page.html")
    found = re.findall(r"</h4><b>([^<]*)<.*<small>([0-9,]*) work<br>at most ([0-9.,]*)[a-z ]* instr", text("page.html"))
    return [(int(work.replace(",", "")), instructions.replace(",", ""), verdict.replace(",", ""))
            for verdict, work, instructions in found]


def cards_agree(core, constants, hz, mhz, bound, arguments):
    """The cards' instructions equal the formulas of time_bound.hpp for the numbers of `collide --bound`."""
    period, siblings, size = int(mhz * 1000000 / hz), bound["later_siblings"], bound["leaf_size"]

    def costs(constants):
        start, depth, sibling, leaf, unit = map(int, constants.split(", "))
        return (start + bound["depths"] * depth + siblings * sibling + (size - 1) * leaf,
                unit + ceil(siblings * sibling / 32))

    first, each = costs(search(f'"{constants}", (.*)\\)', text(f"{INCLUDE}/flashbvh/plain/core_costs.h")))
    in_cycles = re.search(f'"{constants}", {{([^}}]*)}}', text(f"{INCLUDE}/flashbvh/plain/core_cycles.h"))
    start, unit = costs(in_cycles[1]) if in_cycles else (first, each)
    within = int((period - start - (max(size + 8, 32) - 1) * unit) / unit)
    found = cards(*arguments, "--core", core, "--hz", hz, "--clock", f"{mhz}MHz")
    for work, instructions, verdict in found:
        most = first + work * each
        hold(instructions in (str(most), f"{most / 1e6:.3g}"), f"instructions: {instructions}, not {most}")
        most = start + work * unit
        wanted = (f"needs at most {ceil(work / within)} slices of {within} work" if most > period else
                  f"fits in {100 * most / period:.{int(most < period / 10)}f} % of the period")
        hold(verdict == wanted, f"{verdict}, not {wanted}")
    hold(len({verdict.split()[0] for _, _, verdict in found}) == 2, "all fit, or none")


def until_full(reader, writer, **options):
    """Starts `bake` with a full pipe as standard output, and waits until all bytes are on the disk, under temporary
    names."""
    os.set_blocking(writer, False)
    try:
        while True:
            os.write(writer, b"0" * 64)
    except BlockingIOError:
        os.set_blocking(writer, True)
    baking = subprocess.Popen([FLASHBVH, "bake", "meshes/ring.stl", "-o", "out"], stdout=writer,
                              stderr=subprocess.DEVNULL, **options)
    os.close(writer)
    for _ in range(500):
        if sum(file.stat().st_size > 512 for file in Path("out").rglob("*.tmp*")) == 3:
            return baking
        time.sleep(0.02)
    baking.kill()
    os.close(reader)
    hold(False, "no temporary files")
    return None


def ended_by(how):
    """(the exit code, the number of files)."""
    ignoring = {"preexec_fn": lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN)} if how == "nohup" else {}
    reader, writer = os.pipe()
    baking = until_full(reader, writer, **ignoring)
    if how != "closed":
        baking.send_signal(signal.SIGHUP if how == "nohup" else getattr(signal, how))
        while os.read(reader, 65536):
            pass
    os.close(reader)
    code = baking.wait()
    hold(Path("out").exists() == (code == 0), "a folder left behind")
    return code, sum(1 for _ in Path("out").rglob("*"))
