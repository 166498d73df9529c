"""damaged.py ELF RUN...: flips a bit of sealed firmware in its code, its constants, an initial value and the list
of regions. The command RUN runs each copy, which must refuse to start. Fails if one starts."""
import random
import subprocess
import sys
import tempfile
from pathlib import Path

from elftools.elf.elffile import ELFFile

LIST = "flashbvh_sealed_region_list"
SEED = 20261127


def places(elf):
    """Names and file offsets of bytes that no code runs or reads before the test of memory has failed."""
    rng = random.Random(SEED)
    some = [rng.random() for _ in range(4)]
    for name, shares in (("plate_image", some), ("peg_image", some), ("_ZN12_GLOBAL__N_16heightE", [0.5]),
                         ("_ZN8flashbvh16test_known_pairsEv", [0.2, 0.9])):
        begin, size = symbol_at(elf, name)
        yield from ((f"{name}+{int(share * size)}", begin + int(share * size)) for share in shares)
    begin, _ = symbol_at(elf, LIST)
    yield from ((f"{LIST}+{byte}", begin + byte) for byte in (4, 5, 8, 11))  # the first size and checksum


def symbol_at(elf, name):
    """The symbol's offset in the file, and its size in bytes."""
    symbol = elf.get_section_by_name(".symtab").get_symbol_by_name(name)[0]
    section = elf.get_section(symbol["st_shndx"])
    return (symbol["st_value"] & ~1) - section["sh_addr"] + section["sh_offset"], symbol["st_size"]


def output(run, image):
    done = subprocess.run([*run, str(image)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return done.returncode, done.stdout


def main(path, *run):
    data = Path(path).read_bytes()
    print(f"seed {SEED}")
    with open(path, "rb") as file, tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / Path(path).name
        for name, offset in places(ELFFile(file)):
            copy.write_bytes(data[:offset] + bytes([data[offset] ^ 0x10]) + data[offset + 1:])
            status, text = output(run, copy)
            print(f"{name}: {text.strip()}")
            if status != 1 or not text.startswith("refused to start: memory"):
                sys.exit(f"a flipped bit in {name} was not found: status {status}")


main(*sys.argv[1:])
