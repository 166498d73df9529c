"""Finds each gap in the safety manual's requirements, on copies of the manual with one change each."""
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
import traceability as trace

MANUAL = trace.MANUAL.read_text()
TESTS = list(trace.names_of_tests())
BREAKS = {
    "a test that is none": ('- tests: "', '- tests: "there is no such test"; "'),
    "no test at all": (r"- tests: .*?\n", "- tests: none\n"),
    "a file that is none": (r"- source: `", "- source: `no/such/file.cpp`; `"),
    "a section that is none": (r"derivations\.md#robots", "derivations.md#rabots"),
    "a source without a requirement": (r"`robot/guard_explain\.cpp`; ", ""),
    "a proof without a requirement": (r"; `proofs/arithmetic/Helly\.v`", ""),
    "a status without an obligation": (r"`not_a_rotation`, ", ""),
    "a number that is there twice": (r"\*\*G2\*\*", "**G1**"),
    "a requirement without derivation": (r"\n- derived: .*?\n", "\n"),
}


def main():
    assert not list(trace.gaps_of(MANUAL, TESTS)), "the manual as it is"
    missed = []
    for name, (pattern, change) in BREAKS.items():
        changed = re.sub(pattern, change, MANUAL, count=1)
        assert changed != MANUAL, name
        if not list(trace.gaps_of(changed, TESTS)):
            missed.append(name)
    sys.exit("not found: " + ", ".join(missed) if missed else 0)


main()
