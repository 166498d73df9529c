#!/usr/bin/env python3
"""seal_firmware.py ELF: writes the checksums of a linked firmware's code and constants into it.

RegionTest (flashbvh/self_test.hpp) then checks sealed_regions(): all that is loaded and stays in place, and the
initial values of variables where they lie in flash. The list of the regions itself is left out. Prints the regions.
Make .bin and .hex files of the ELF file afterwards. Needs pyelftools: apt-get install python3-pyelftools.
"""
import os
import struct
import sys
import zlib

try:
    from elftools.common.exceptions import ELFError
    from elftools.elf.constants import SH_FLAGS
    from elftools.elf.elffile import ELFFile
except ImportError:
    sys.exit("seal_firmware.py: pyelftools is missing: apt-get install python3-pyelftools")

LIST = "flashbvh_sealed_region_list"


def loaded(elf):
    """(address, bytes) of each section that stays where it was loaded."""
    segments = [segment for segment in elf.iter_segments() if segment["p_type"] == "PT_LOAD"]
    for section in elf.iter_sections():
        flags, at = section["sh_flags"], section["sh_addr"]
        if not flags & SH_FLAGS.SHF_ALLOC or section["sh_type"] == "SHT_NOBITS" or not section["sh_size"]:
            continue
        segment = next(one for one in segments if one.section_in_segment(section))
        address = at - segment["p_vaddr"] + segment["p_paddr"]
        is_variable = flags & SH_FLAGS.SHF_WRITE and not flags & SH_FLAGS.SHF_EXECINSTR
        if not is_variable or address != at:
            yield address, section.data()


def joined(runs):
    """The runs in ascending order, with adjoining runs joined."""
    whole = []
    for address, data in sorted(runs):
        if whole and whole[-1][0] + len(whole[-1][1]) == address:
            whole[-1] = whole[-1][0], whole[-1][1] + data
        else:
            whole.append((address, data))
    return whole


def without(runs, begin, end):
    """The runs without the bytes from `begin` to `end`."""
    for address, data in runs:
        parts = (address, data[:max(0, begin - address)]), (max(address, end), data[max(0, end - address):])
        yield from ((at, part) for at, part in parts if part) if address < end and begin < address + len(data) \
            else [(address, data)]


def sealed(elf):
    """The list's offset in the file, its bytes, and the regions (address, size, checksum)."""
    if not elf.little_endian:
        raise ValueError("is big-endian, the library is not")
    table = elf.get_section_by_name(".symtab")
    symbols = table.get_symbol_by_name(LIST) if table else None
    if not symbols:
        raise ValueError(f"has no symbol {LIST}: link it unstripped, with a call of sealed_regions()")
    begin, size = symbols[0]["st_value"], symbols[0]["st_size"]
    section = elf.get_section(symbols[0]["st_shndx"])
    entry = struct.Struct("<III" if elf.elfclass == 32 else "<QQI4x")
    regions = [(at, len(data), zlib.crc32(data)) for at, data in without(joined(loaded(elf)), begin, begin + size)]
    room = size // entry.size
    if len(regions) > room:
        raise ValueError(f"has {len(regions)} regions, FLASHBVH_SEALED_REGIONS is {room}: join its sections")
    words = b"".join(entry.pack(*region) for region in regions)
    return section["sh_offset"] + begin - section["sh_addr"], words.ljust(size, b"\0"), regions


def main(path):
    try:
        with open(path, "rb") as file:
            data = bytearray(file.read())
            offset, words, regions = sealed(ELFFile(file))
    except (OSError, ELFError, ValueError) as error:
        sys.exit(f"seal_firmware.py: {path}: {error}")
    data[offset:offset + len(words)] = words
    # Replaces the file atomically, so that no partial file is left behind.
    with open(path + ".sealing", "wb") as file:
        file.write(data)
    os.chmod(path + ".sealing", os.stat(path).st_mode)
    os.replace(path + ".sealing", path)
    for address, size, crc in regions:
        print(f"0x{address:08x}  {size:8} bytes  crc 0x{crc:08x}")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
