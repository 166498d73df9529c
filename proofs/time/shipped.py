"""shipped.py BOUND HEADER [--write]: fails unless the constants of HEADER, flashbvh/plain/run_costs.h,
are those that prove.py wrote to BOUND. BOUND may have several cores.

--write: changes HEADER to the constants of all cores in BOUND, in their order, if it has others.
"""
import re
import sys
from collections import defaultdict
from pathlib import Path

FIELDS = "start", "ascent", "later-sibling", "leaf-triangle", "work"
CORE = r'  core\(.*"(.*)", .*\)'


def proven_in(bound):
    """The costs by core and name."""
    proven, core = defaultdict(dict), ""
    for first, *words in map(str.split, bound.splitlines()):
        if first == "core":
            core = words[0]
        elif first == "bound":
            proven[core][words[0]] = words[1]
    return proven


def rows(proven):
    """The rows of the header by core."""
    return {core: f"  core({core.replace('-', '')}, {core.replace('-', '_').lower()}, \"{core}\", "
                  f"{', '.join(costs[field] for field in FIELDS)})" for core, costs in proven.items()}


def main(bound, header, *options):
    wanted = rows(proven_in(Path(bound).read_text()))
    if not wanted:
        sys.exit("shipped.py: nothing proven")
    text = Path(header).read_text()
    if options == ("--write",):
        rest = re.sub(rf"{CORE}.*\n", "", text)
        end = rest.index("\n", rest.index("#define FLASHBVH_FOR_EACH_CORE")) + 1
        new = rest[:end] + " \\\n".join(wanted.values()) + "\n" + rest[end:]
        if new != text:
            Path(header).write_text(new)
        return
    shipped = {found[1]: found[0] for found in re.finditer(CORE, text)}
    differing = [core for core, row in wanted.items() if shipped.get(core) != row]
    for core in differing:
        print(f"shipped: {shipped.get(core, '').strip()}\nproven:  {wanted[core].strip()}\nrun tools/figures.sh")
    sys.exit(bool(differing))


if __name__ == "__main__":
    main(*sys.argv[1:])
