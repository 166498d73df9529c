#!/usr/bin/env python3
"""conditions.py PROGRAM PROFILE UNSEEN

Checks that a run of PROGRAM, by its profile, has seen each condition of the guard's source both true and false. Prints
a row per file. Fails if an unseen condition has no reason in the list UNSEEN, or if UNSEEN names a condition that was
seen. A line of the list: FILE | CONDITION | the way not seen, true or false | reason. Its first line names the files.
Fails for any other profiled file of lib/src/robot with conditions, unless the list has a line: # FILE: reason.
"""
import json
import os
import re
import subprocess
import sys
import tempfile


def exported(program, profile):
    with tempfile.TemporaryDirectory() as folder:
        merged = os.path.join(folder, "merged")
        subprocess.run(["llvm-profdata", "merge", "-o", merged, profile], check=True)
        text = subprocess.run(["llvm-cov", "export", "-format=text", "-instr-profile", merged, program], check=True,
                              capture_output=True).stdout
    return json.loads(text)["data"][0]["files"]


def conditions_of(file):
    """How often each condition is true and false, by its place, over all instances of templates."""
    counts = {}
    for line, column, last_line, last_column, true, false, *_ in file["branches"]:
        sums = counts.setdefault((line, column, last_line, last_column), [0, 0])
        sums[0] += true
        sums[1] += false
    return counts


def text_at(lines, place):
    line, column, last_line, last_column = place
    if line == last_line:
        return lines[line - 1][column - 1:last_column - 1]
    parts = [lines[line - 1][column - 1:], *lines[line:last_line - 1], lines[last_line - 1][:last_column - 1]]
    return " ".join(part.strip() for part in parts)


def main(program, profile, list_of_unseen):
    rows = (line.split("|") for line in open(list_of_unseen) if "|" in line and not line.startswith("#"))
    reasons = {tuple(part.strip() for part in row[:3]): row[3].strip() for row in rows}
    names = {name for name, _, _ in reasons} | set(open(list_of_unseen).readline().lstrip("# ").split())
    excluded = set(re.findall(r"^# (\w+\.[ch]pp): .", open(list_of_unseen).read(), re.M))
    unseen, gaps, in_all, both_in_all = set(), [], 0, 0
    print("conditions  both ways  source")
    for file in exported(program, profile):
        name = os.path.basename(file["filename"])
        conditions = conditions_of(file)
        if "/lib/src/robot/" not in file["filename"] or name in excluded or (name not in names and not conditions):
            continue
        if name not in names:
            gaps.append(f"{name}: neither in the first line of the list nor excluded")
            continue
        lines = open(file["filename"]).read().split("\n")
        both = 0
        for place, (true, false) in sorted(conditions.items()):
            missing = [way for way, count in (("true", true), ("false", false)) if count == 0]
            both += not missing
            for way in missing:
                key = (name, text_at(lines, place), way)
                unseen.add(key)
                if key not in reasons:
                    gaps.append(f"{name}:{place[0]}: {key[1]}: never {way}, and not in the list")
        print(f"{len(conditions):10}  {both:9}  {name}")
        in_all += len(conditions)
        both_in_all += both
    print(f"{in_all:10}  {both_in_all:9}  in all; of the others the list has the reasons")
    gaps += [f"{name}: {text}: was {way}, or is no condition: take it off the list"
             for name, text, way in sorted(set(reasons) - unseen)]
    print(*gaps, sep="\n")
    return 1 if gaps or not in_all else 0


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
