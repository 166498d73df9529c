"""An interrupted bake."""
import os
import signal
import subprocess
import time
from pathlib import Path

from checks import FLASHBVH, hold


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
