"""decoder_test.py OBJDUMP PROGRAM

All code of a firmware is cut into the instructions that objdump sees, and branches to where it
says. What moves sp needs no such test: every frame is compared with the compiler's.
"""
import re
import subprocess
import sys

from machine_code.instruction import Flow
from machine_code.program import Program

# Of what is no branch, too, objdump names the address.
NO_BRANCH = re.compile(r"v?ldr|adr|pld|pli")
LEAVES = re.compile(r"bx\w*\s+lr|(pop|ldm)\S*\s.*pc}|ldr\S*\s+pc, \[sp\], #|ret")


def objdumps(objdump: str, program: str) -> dict[int, tuple[int, str]]:
    """By address: size and text."""
    # Else binutils 2.40 does not know all of Armv8.1-M.
    options = ["-m", "armv8.1-m.main"] if "arm" in objdump else []
    text = subprocess.run([objdump, *options, "-d", program], check=True, text=True,
                          capture_output=True).stdout
    lines = re.findall(r"^ *([0-9a-f]+):\t([0-9a-f ]+?) *\t([^.\n].*?)(?:\s+[@#] .*)?$", text, re.M)
    return {int(at, 16): (len(code.replace(" ", "")) // 2, what) for at, code, what in lines}


def main() -> int:
    objdump, path = sys.argv[1:]
    program = Program(path)
    ours = {}
    for function in program.functions.values():
        ours.update(program.code_of(function))
    theirs = objdumps(objdump, path)
    wrong = 0
    for address, (size, text) in theirs.items():
        found = ours.get(address)
        target = re.search(r"\b([0-9a-f]+) <", text)
        wanted = int(target[1], 16) if target and not NO_BRANCH.match(text) else None
        if found is None or (found.size, found.target) != (size, wanted) or \
                (found.flow is Flow.LEAVE) != bool(LEAVES.match(text)):
            print(f"{address:x}: {text}: {found}")
            wrong += 1
    print(f"{len(theirs)} instructions, {wrong} read otherwise")
    return 1 if wrong or len(theirs) < 1000 else 0


if __name__ == "__main__":
    sys.exit(main())
