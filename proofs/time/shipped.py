"""shipped.py BOUND FOLDER [--write]: fails unless the constants of core_costs.h in FOLDER equal those that prove.py
wrote to BOUND, which may contain several cores.

--write: updates the header to the constants of the cores in BOUND.
"""
import re
import sys
from collections import defaultdict
from pathlib import Path

FIELDS = "start", "ascent", "later-sibling", "leaf-triangle", "work"
ROW = re.compile(r'  core\(.*"(.*)", .*\)')


def proven_in(bound):
    """The costs by core and name."""
    proven, core = defaultdict(dict), ""
    for first, *words in map(str.split, bound.splitlines()):
        if first == "core":
            core = words[0]
        elif first == "bound":
            proven[core][words[0]] = words[1]
    return proven


def row(core, costs):
    return (f"  core({core.replace('-', '')}, {core.replace('-', '_').lower()}, \"{core}\", "
            f"{', '.join(costs[name] for name in FIELDS)})")


def main(bound, folder, *options):
    header = Path(folder, "core_costs.h")
    text = header.read_text()
    shipped = {found[1]: found[0] for found in ROW.finditer(text)}
    proven = proven_in(Path(bound).read_text())
    wanted = {core: row(core, costs) for core, costs in proven.items() if FIELDS[0] in costs}
    if not wanted:
        sys.exit("shipped.py: nothing proven")
    if options == ("--write",):
        old, new = (" \\\n".join(rows.values()) for rows in (shipped, {**shipped, **wanted}))
        header.write_text(text.replace(old, new))
        return
    differing = {core: wanted[core] for core in wanted if shipped.get(core) != wanted[core]}
    for core, row_proven in differing.items():
        print(f"shipped: {shipped.get(core, '').strip()}\nproven:  {row_proven.strip()}\nrun tools/figures.sh")
    sys.exit(bool(differing))


if __name__ == "__main__":
    main(*sys.argv[1:])
