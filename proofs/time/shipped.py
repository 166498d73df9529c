"""shipped.py BOUND FOLDER [--write]: fails unless the constants of core_costs.h or core_cycles.h in FOLDER equal
those that prove.py or guard_prove.py wrote to BOUND, which may contain several cores.

--write: updates the header to the constants of the cores in BOUND.
"""
import re
import sys
from collections import defaultdict
from pathlib import Path

# The constants of a row, by the macro that has it.
TABLES = {
    "FLASHBVH_FOR_EACH_CORE": ("start", "ascent", "later-sibling", "leaf-triangle", "work"),
    "FLASHBVH_FOR_EACH_GUARD_CORE": ("guard-start", "guard-joint", "guard-turn", "guard-pair", "guard-between",
                                     "guard-table", "guard-measure", "guard-ascent", "guard-within", "guard-work"),
}
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


def row(core, costs, fields):
    """Cycles come in two groups, the second one with the reads of flash."""
    lists = [", ".join(costs[name] for name in fields)]
    if f"reads-{fields[0]}" in costs:
        lists = [f"{{{values}}}" for values in (*lists, ", ".join(costs[f"reads-{name}"] for name in fields))]
    return (f"  core({core.replace('-', '').replace('+', 'Plus')}, {core.replace('-', '_').replace('+', 'plus').lower()}, "
            f"\"{core}\", {', '.join(lists)})")


def main(bound, folder, *options):
    proven = proven_in(Path(bound).read_text())
    is_cycles = any(name.startswith("reads-") for costs in proven.values() for name in costs)
    header = Path(folder, f"core_{'cycles' if is_cycles else 'costs'}.h")
    text, differing, known = header.read_text(), [], 0
    for macro, fields in TABLES.items():
        wanted = {core: row(core, costs, fields) for core, costs in proven.items() if fields[0] in costs}
        known += len(wanted)
        head = rf"#define {macro}{'_IN_CYCLES' if is_cycles else ''}\(core\) \\\n"
        rows = re.search(rf"(?<={head})(?:  core\(.*\n)+", text)[0]
        shipped = {found[1]: found[0] for found in re.finditer(CORE, rows)}
        text = text.replace(rows, " \\\n".join({**shipped, **wanted}.values()) + "\n")
        differing += [(shipped.get(core, ""), row) for core, row in wanted.items() if shipped.get(core) != row]
    if not known:
        sys.exit("shipped.py: nothing proven")
    if options == ("--write",):
        header.write_text(text)
        return
    for shipped, row_proven in differing:
        print(f"shipped: {shipped.strip()}\nproven:  {row_proven.strip()}\nrun tools/figures.sh")
    sys.exit(bool(differing))


if __name__ == "__main__":
    main(*sys.argv[1:])
