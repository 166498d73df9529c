#!/usr/bin/env python3
"""check_nodiscard.py INCLUDE_FOLDER: dropping a status, verdict or outcome gives a warning. In C++ each enumeration of
them is marked, and each struct with one; in C each function that returns one, or a struct with one."""
import re
import sys
from pathlib import Path

# Results that may be dropped, since the error stays in the object: in a pose or a motion, with which each query then
# ends; in a query, a guard or a workcell, whose later calls report it.
STICKY = {"flashbvh_" + name for name in (
    "pose_relative", "pose_of_matrix", "pose_rigid", "body_motion_between", "first_contact_start", "query_start",
    "clearance_start", "guard_init", "motion_init", "motion_start", "workcell_init")}
MEMORY = {"MotionCore", "MotionStateOf"}  # a query's state, which no function returns
SEEDS = ["Status", "Verdict", "MotionOutcome", "ContactOutcome"]


def structs_of(text):
    """Marks, names and own fields of the structs in any scope."""
    for found in re.finditer(r"\bstruct (\[\[nodiscard\]\] |FLASHBVH_KEEP )?(\w+)[^;{()]*\{", text):
        body, inner = text[found.end():], 1
        end = next(i for i, letter in enumerate(body) if (inner := inner + (letter == "{") - (letter == "}")) == 0)
        yield found[1] or "", found[2], re.sub(r"\{[^{}]*\}", "", body[:end])


def main(folder):
    texts = {path: re.sub(r"/\*.*?\*/", "", re.sub(r"//.*", "", path.read_text()), flags=re.S)
             for path in Path(folder).rglob("*.h*") if "detail" not in path.parts}
    of_cpp = "\n".join(text for path, text in texts.items() if path.suffix == ".hpp" or path.parent.name == "plain")
    of_c = "\n".join(text for path, text in texts.items() if path.suffix == ".h")
    wrong = [f"{name} is not marked" for name in SEEDS if f"enum class [[nodiscard]] {name} " not in of_cpp]
    carriers, before = set(), None
    while before != carriers:  # also structs with a field of such a struct
        before = set(carriers)
        kinds = "|".join([*SEEDS, *carriers, "flashbvh_status"])
        field = rf"^\s+(FLASHBVH_BYTE\()?({kinds})\)?(<.*>)? \w*[a-z]( =.*)?;"
        carriers = {name for _, name, body in structs_of(of_cpp + of_c) if re.search(field, body, re.M)}
    wrong += [f"{name} carries a status and is not marked" for mark, name, body in structs_of(of_cpp)
              if re.search(field, body, re.M) and not mark and name not in MEMORY]
    functions = [(name, bool(mark)) for mark, kind, name in
                 re.findall(r"^(FLASHBVH_NODISCARD\s+)?(\w+)\s+(flashbvh_\w+)\(", of_c, re.M)
                 if kind == "flashbvh_status" or kind in carriers]
    wrong += [f"{name}() is {'marked, and an exception' if is_marked else 'not marked'}"
              for name, is_marked in functions if is_marked == (name in STICKY)]
    print(f"{len(functions)} functions of C return a status, {len(carriers)} types carry one")
    if len(functions) < 30 or not {"Answer", "PairDetail", "flashbvh_guard_answer"} <= carriers:
        wrong.append("too few were found: this script no longer reads the headers")
    print("\n".join(wrong))
    sys.exit(bool(wrong))


main(*sys.argv[1:])
