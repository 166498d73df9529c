#!/usr/bin/env python3
"""both.py ARGUMENT...: replaces the program in tests/cli/runner.py. Runs the program NATIVE, and OTHER in a copy of the
original folder; adds a line to the file COMPARED: "same", or the differences of exit codes, output and files. Exits
like NATIVE. A named pipe can be written only once, so if the folder has one, NATIVE runs alone."""
import os
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path


def plain(text, folder):
    """Wine's output with Linux's line ends and paths, instead of Windows'."""
    return (text.replace(b"\r\n", b"\n").replace(b"\\", b"/").replace(b"Z:/", b"/")
            .replace(os.fsencode(folder), os.fsencode(Path.cwd())))


def files_of(folder):
    files = {str(path.relative_to(folder)): path.read_bytes() for path in Path(folder).rglob("*") if path.is_file()}
    return {name: plain(text, folder) if name.endswith(".d") else text for name, text in files.items()}


def difference(native, other, copy):
    if other.returncode != native.returncode:
        return f"ends with {other.returncode}, not {native.returncode}"
    if any(plain(getattr(other, name), copy) != plain(getattr(native, name), Path.cwd()) for name in ("stdout", "stderr")):
        return "prints something else"
    here, there = files_of(Path.cwd()), files_of(copy)
    names = sorted(name for name in {*here, *there} if here.get(name) != there.get(name))
    return f"writes other {' '.join(names)}" if names else ""


def main(*arguments):
    if any(path.is_fifo() for path in Path.cwd().iterdir()):
        os.execv(os.environ["NATIVE"], [os.environ["NATIVE"], *arguments])
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder, "copy")
        subprocess.run(["cp", "--archive", ".", copy], check=True)  # hard links stay
        native = subprocess.run([os.environ["NATIVE"], *arguments], capture_output=True)
        other = subprocess.run([*shlex.split(os.environ["OTHER"]), *arguments], capture_output=True, cwd=copy,
                               stdin=subprocess.DEVNULL)
        found = difference(native, other, copy)
    said = f"{found}: {' '.join(arguments)}: {other.stderr} not {native.stderr}" if found else "same"
    with open(os.environ["COMPARED"], "a") as compared:
        compared.write(ascii(said)[1:-1] + "\n")
    sys.stdout.buffer.write(native.stdout)
    sys.stderr.buffer.write(native.stderr)
    return native.returncode


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
