"""check_snippets.py: the C++ and C in README.md and the guide are lines of programs that the tests compile, and the
guide names each status."""
import re
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
SHOWN = (("README.md", "cpp", ["guide.cpp"]), ("lib/docs/guide.md", "cpp", ["guide.cpp"]),
         ("lib/docs/guide.md", "c", ["guide.c", "guide_robot.c"]))


def problems():
    for page, language, programs in SHOWN:
        source = "".join((HERE / program).read_text() for program in programs)
        blocks = re.findall(rf"^```{language}\n(.*?^)```$", (ROOT / page).read_text(), re.M | re.S)
        if not blocks:
            yield f"{page} shows nothing of {programs}"
        yield from (f"{page} shows what {programs} don't have:\n{block}" for block in blocks if f"\n{block}" not in source)
    guide = (ROOT / "lib/docs/guide.md").read_text()
    statuses = re.findall("FLASHBVH_STATUS_([A-Z_]+) =", (ROOT / "lib/include/flashbvh/plain/status.h").read_text())
    yield from (f"the guide does not say what to do about {status.lower()}" for status in statuses
                if not re.search(rf"^\|[^|]*`{status.lower()}`[^|]*\|", guide, re.M))


found = list(problems())
print("\n".join(found))
sys.exit(bool(found))
