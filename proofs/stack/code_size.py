"""code_size.py PROGRAM TABLE TAGS OUTPUT: the bytes that each function with a limit in TABLE (stack.txt) links, at -Os
and -O2.

Links it only with the library, libgcc and the memory functions of C's library. Of equal functions the library's
come first. Writes "code NAME LEVEL BYTES". PROGRAM
has all functions, by which names in the source become the linker's. Environment: LINK is compiler and flags, LIBRARIES
the last arguments; ARCHIVE_OS and ARCHIVE_O2 hold the functions at the two levels; SIZE is the program `size`.
"""
import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

from machine_code.instruction import Refused
from machine_code.program import Program

from stack import Table


def bytes_in(sizes: str, symbol: str) -> int:
    """Code and constants; neither data nor exception tables may exist."""
    total = 0
    for name, size in re.findall(r"^(\.\S+)\s+(\d+)", sizes, re.M):
        if re.match(r"\.s?(data|bss)", name) and int(size):
            raise Refused(f"{symbol} has data")
        if re.match(r"\.s?(text|rodata)", name):
            total += int(size)
    if total == 0:
        raise Refused(f"{symbol} is no program")
    return total


def size_of(symbol: str, archive: str, program: str) -> int:
    subprocess.run([*shlex.split(os.environ["LINK"]), f"-Wl,-e,{symbol}", f"-Wl,-u,{symbol}",
                    f"-Wl,--whole-archive,{archive},--no-whole-archive", *shlex.split(os.environ["LIBRARIES"]), "-o", program], check=True)
    sizes = subprocess.run([os.environ["SIZE"], "-A", program], check=True, stdout=subprocess.PIPE, text=True)
    return bytes_in(sizes.stdout, symbol)


def main(file: str, table: str, tags: str, output: str) -> None:
    Path(output).unlink(missing_ok=True)
    program, lines = Program(file), []
    for name, (pattern, _) in Table(table, tags.split(",")).limits.items():
        if not name.startswith("painted_"):
            symbol = program.matching(pattern).names[0]
            lines += [f"code {name} {level} {size_of(symbol, os.environ[f'ARCHIVE_{level.upper()}'], f'{output}.elf')}"
                      for level in ("Os", "O2")]
    print("\n".join(lines))
    Path(output).write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except (Refused, subprocess.CalledProcessError) as refusal:
        sys.exit(f"code_size.py: {refusal}")
