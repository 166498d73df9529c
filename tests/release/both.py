#!/usr/bin/env python3
"""both.py ARGUMENT...: stands for the program in tests/cli/runner.py. Runs the program NATIVE, and OTHER in a copy of the
folder as it was; adds a line to the file COMPARED: "same", or what differs of exit codes, output and files. Ends as
NATIVE did."""
import os
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path


def files_of(folder):
    return {str(path.relative_to(folder)): path.read_bytes() for path in Path(folder).rglob("*") if path.is_file()}


def difference(native, other, copy):
    if other.returncode != native.returncode:
        return f"ends with {other.returncode}, not {native.returncode}"
    if any(getattr(other, name).replace(b"\r\n", b"\n") != getattr(native, name) for name in ("stdout", "stderr")):
        return "prints something else"
    here, there = files_of("."), files_of(copy)
    there = {name: content.replace(os.fsencode(copy), os.fsencode(Path.cwd())) for name, content in there.items()}
    names = sorted(name for name in {*here, *there} if here.get(name) != there.get(name))
    return f"writes other {' '.join(names)}" if names else ""


def main(*arguments):
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder, "copy")
        try:
            shutil.copytree(".", copy, symlinks=True)
        except shutil.Error:  # a pipe, whose bytes are there once
            os.execv(os.environ["NATIVE"], [os.environ["NATIVE"], *arguments])
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
