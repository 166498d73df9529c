"""code_size.py ROOTS OUTPUT: the bytes that each query links, its entry's own code included, at -Os and -O2.

Links it only with the library, libgcc and the memory functions of C's library, from the entry on. Environment: LINK is
compiler and flags, LIBRARIES the last arguments; ARCHIVE_OS and ARCHIVE_O2 hold the entries and the library at the two
levels; SIZE is the program `size`.
"""
import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

from machine_code.instruction import Refused


def bytes_in(sizes: str, entry: str) -> int:
    """Code and constants; neither data nor exception tables may exist."""
    total = 0
    for name, size in re.findall(r"^(\.\S+)\s+(\d+)", sizes, re.M):
        if re.match(r"\.s?(data|bss)", name) and int(size):
            raise Refused(f"{entry} has data")
        if re.match(r"\.s?(text|rodata)", name):
            total += int(size)
    if total <= 20:
        raise Refused(f"{entry} is no program")
    return total


def size_of(entry: str, archive: str, program: str) -> int:
    subprocess.run([*shlex.split(os.environ["LINK"]), f"-Wl,-e,{entry}", f"-Wl,-u,{entry}", archive,
                    *shlex.split(os.environ["LIBRARIES"]), "-o", program], check=True)
    sizes = subprocess.run([os.environ["SIZE"], "-A", program], check=True, stdout=subprocess.PIPE, text=True)
    return bytes_in(sizes.stdout, entry)


def main(roots: str, output: str) -> None:
    Path(output).unlink(missing_ok=True)
    lines = []
    for entry in Path(roots).read_text().split():
        small, fast = (size_of(entry, os.environ[archive], f"{output}.elf")
                       for archive in ("ARCHIVE_OS", "ARCHIVE_O2"))
        print(f"budget: code of {entry}: {small} bytes at -Os, {fast} at -O2", file=sys.stderr)
        lines += [f"code {entry} Os {small}\n", f"code {entry} O2 {fast}\n"]
    Path(output).write_text("".join(lines))


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except (Refused, subprocess.CalledProcessError) as refusal:
        sys.exit(f"code_size.py: {refusal}")
