"""shipped.py BOUND HEADER [--write]: fails unless the constants of HEADER are those that prove.py or
guard_prove.py wrote to BOUND, which may have several cores. HEADER: one of TABLES.

--write: changes HEADER to the constants of the cores in BOUND, if it has others of them.
"""
import re
import sys
from collections import defaultdict
from pathlib import Path

# The constants of each header, in groups.
TABLES = {
    "run_costs.h": [("start", "ascent", "later-sibling", "leaf-triangle", "work")],
    "guard_costs.hpp": [("guard-start", "guard-joint", "guard-turn", "guard-pair", "guard-between",
                         "guard-table", "guard-measure", "guard-ascent", "guard-within", "guard-work")],
}
# Cycles, and reads of flash.
for of, name in (("run_costs.h", "run_cycles.h"), ("guard_costs.hpp", "guard_cycles.hpp")):
    TABLES[name] = TABLES[of] + [tuple(f"reads-{field}" for field in TABLES[of][0])]
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


def values(costs, groups):
    """Groups are in braces, unless there is one."""
    lists = [", ".join(costs[field] for field in group) for group in groups]
    return lists[0] if len(lists) == 1 else ", ".join(f"{{{values}}}" for values in lists)


def rows(proven, groups):
    """The rows of the header by core."""
    return {core: f"  core({core.replace('-', '').replace('+', 'Plus')}, "
                  f"{core.replace('-', '_').replace('+', 'plus').lower()}, \"{core}\", "
                  f"{values(costs, groups)})" for core, costs in proven.items()}


def main(bound, header, *options):
    wanted = rows(proven_in(Path(bound).read_text()), TABLES[Path(header).name])
    if not wanted:
        sys.exit("shipped.py: nothing proven")
    text = Path(header).read_text()
    shipped = {found[1]: found[0] for found in re.finditer(CORE, text)}
    if options == ("--write",):
        rest = re.sub(rf"{CORE}.*\n", "", text)
        end = rest.index("\n", rest.index("#define FLASHBVH_FOR_EACH_")) + 1
        new = rest[:end] + " \\\n".join({**shipped, **wanted}.values()) + "\n" + rest[end:]
        if new != text:
            Path(header).write_text(new)
        return
    differing = [core for core, row in wanted.items() if shipped.get(core) != row]
    for core in differing:
        print(f"shipped: {shipped.get(core, '').strip()}\nproven:  {wanted[core].strip()}\nrun tools/figures.sh")
    sys.exit(bool(differing))


if __name__ == "__main__":
    main(*sys.argv[1:])
