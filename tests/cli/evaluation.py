"""`flashbvh bench`: what it prints and writes, and what it refuses."""
import re
from pathlib import Path

from checks import THOROUGH, flashbvh, hold, same

QUICK = "--repetitions-scale", "0.0001", "--rounds", "2"


def refused(what, *arguments):
    """As command_line.refused(), but that tables may have been printed."""
    warnings = flashbvh("bench", *arguments, code=2).warnings
    hold(warnings.count("\n") == 1, f"not one line: {warnings}")
    hold(what in warnings, f"no '{what}' in: {warnings}")


def bench():
    """Its tables, and the iterations that it adds up."""
    said = flashbvh("bench", "--table", 3, "--table", 7, *QUICK)
    said.holds("^### Table 3: Separation$", "^### Table 7", "^### The default tree$", "^### Time of one query",
               r"^\| total of the intersecting  *\| *0 \|",
               r"^\| total  *\| *96 \| *7410 \| *34886 \| *96 \| *96 \|",
               r"^\| total  *\| *7410 \| *22 \| *22 \|")
    hold("### Table 2" not in said, "table 2 was not requested")
    for row in ("volume-stack", "alternating-stack", "stackless", "stackless-post", "leaf", "ranked", "ranked-stack",
                "best rule", "ranked, default tree", "best rule, default tree"):
        hold(len(re.findall(rf"^\| {row}  *\|", said, re.M)) == 4, f"not four rows of {row}")
    hold(len(re.findall("^table", said.warnings, re.M)) == 4, f"progress: {said.warnings}")

    if THOROUGH:  # the paper's 20 setups: lib/docs/evaluation.md
        flashbvh("bench", "--repetitions-scale", "1e-9", "--rounds", 1).holds(
            r"^\| total  *\| *553230 \| *625382 \| *4108174 \| *544790 \| *- \|",
            r"^\| total where the best rule is known  *\| *83495 \| *98747 \| *171164 \| *80525 \| *65979 \|",
            r"^\| total of the intersecting  *\| *588360 \| *315471 \| *291658 \|",
            r"^\| total  *\| *625382 \| *329182 \| *303831 \|")

    refused("--table", "--table", 1)
    refused("--table", "--table", 9)
    for option, value in (("--rounds", 0), ("--repetitions-scale", 0), ("--repetitions-scale", "nan")):
        refused(option, "--table", 3, option, value)
    flashbvh("bench", "--help").holds("Usage")


def setups_in(file, table, first):
    """How many rows of a table of C++ begin so."""
    found = re.findall(rf"{table}.*?^    \{{\}}\}}", Path(file).read_text(), re.M | re.S)
    return sum(len(re.findall(rf"^    {first}", text, re.M)) for text in found)


def bench_firmware():
    """`bench --firmware`: the same files each time."""
    def writes(folder, setups, left_out, *options):
        """So many setups in all images, and so many left out, listed in the first."""
        flashbvh("bench", "--firmware", folder, *options)
        images = sorted(Path(folder).glob("setups_*.cpp"))
        found = sum(setups_in(image, "kSetups", r"\{\{") for image in images)
        hold(found == setups, f"{found} setups, not {setups}, in {folder}")
        found = [setups_in(image, "kLeftOut", r"\{[0-9]") for image in images]
        hold(found == [left_out] + [0] * (len(images) - 1), f"{found} setups left out, not {left_out}, of {folder}")
        # Every tree is there that a table includes.
        for image in images:
            for tree in re.findall(r'^#include "(.*fbvh)\.cpp"$', image.read_text(), re.M):
                for file in Path(folder, f"{tree}.cpp"), Path(folder, f"{tree}.hpp"):
                    hold(file.exists() and file.stat().st_size, f"{image}: no {file}")
        return len(images)

    writes("all", 16, 4)  # all but subdivisions 3 and 4, which take 32-bit trees
    writes("again", 16, 4)
    hold({file.name for file in Path("all").iterdir()} == {file.name for file in Path("again").iterdir()},
         "other files the second time")
    for file in Path("all").iterdir():
        same(file, Path("again", file.name))
    hold(writes("small", 14, 6, "--images", 3, "--max-bytes", 200000) == 3, "not three images")
    hold(writes("one", 10, 10, "--max-bytes", 200000) == 1, "two images, not one")
    writes("none", 0, 20, "--max-bytes", 80000)  # the smallest object takes 81 KB

    refused("--max-bytes", "--max-bytes", 80000)
    for option, value in ("--images", 0), ("--max-bytes", 0), ("--table", 2):
        refused(option, "--firmware", "refused", option, value)
    Path("file").touch()
    refused("file", "--firmware", "file")
    hold(not Path("refused").exists(), "something written")
