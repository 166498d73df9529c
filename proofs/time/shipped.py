"""shipped.py BOUND HEADER [--write]: fails unless the constants of HEADER, flashbvh/detail/walk/run_costs.hpp,
are those that prove.py wrote to BOUND. BOUND may have several cores.

--write: changes HEADER to the constants of all cores in BOUND, if it has others.
"""
import re
import sys
from collections import defaultdict
from pathlib import Path

FIELDS = "start", "ascent", "later-sibling", "leaf-triangle", "work"
CONSTANT = r"constexpr RunCosts k(\w+) = .*;\n"


def proven_in(bound):
    """The costs by core and name."""
    proven, core = defaultdict(dict), ""
    for first, *words in map(str.split, bound.splitlines()):
        if first == "core":
            core = words[0]
        elif first == "bound":
            proven[core][words[0]] = words[1]
    return proven


def constants(proven):
    """The lines of the header by core's name in C++."""
    return {core.replace("-", ""): f"constexpr RunCosts k{core.replace('-', '')} = "
                                   f"{{{', '.join(costs[field] for field in FIELDS)}}};\n"
            for core, costs in sorted(proven.items())}


def main(bound, header, *options):
    wanted = constants(proven_in(Path(bound).read_text()))
    if not wanted:
        sys.exit("shipped.py: nothing proven")
    text = Path(header).read_text()
    if options == ("--write",):
        begin = re.search(CONSTANT, text).start()
        new = re.sub(CONSTANT, "", text)
        new = new[:begin] + "".join(wanted.values()) + new[begin:]
        if new != text:
            Path(header).write_text(new)
        return
    shipped = {found[1]: found[0] for found in re.finditer(CONSTANT, text)}
    differing = [core for core, line in wanted.items() if shipped.get(core) != line]
    for core in differing:
        print(f"shipped: {shipped.get(core, '').strip()}\nproven:  {wanted[core]}run tools/figures.sh")
    sys.exit(bool(differing))


if __name__ == "__main__":
    main(*sys.argv[1:])
