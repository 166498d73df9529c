"""compare.py SMALL REAL: the small header against Catch2, on sample.cpp compiled with each."""
import re
import subprocess
import sys

PRINTED = {
    "values print": [
        "sample.cpp:", 'failed in "values print"', "CHECK( text == nullptr )",
        "with -9000000000000000000 == 9000000000000000000", "with 200 == 201", 'with "text" == nullptr',
        "with address 4660 == nullptr", "with false == true", "with 0 == 1", "with {?} == {?}",
        "with 3 * 2^-1 == -1 * 2^1", "with 1 * 2^-1 == 0 * 2^", "test cases: 1, failures: 10"],
    "messages print": [
        '"about all"', "round := 2", "round + 5 := 7", '"letters" := "letters"', "opaque := {?}"],
}


def run(program, *arguments):
    """Returns its status and its output lines."""
    done = subprocess.run([program, *arguments], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          errors="replace")
    return done.returncode, done.stdout.splitlines()


def outcome(program, test):
    """Returns the steps that a program traces, and whether it passes."""
    status, lines = run(program, test)
    return [line for line in lines if line.startswith("trace: ")] + ["fails" if status else "passes"]


def complaints(small, real):
    (count, names), (_, others) = (run(program, "--list-test-names-only") for program in (small, real))
    if sorted(names) != sorted(others) or len(names) < 12:
        yield f"test cases: {names}, of Catch2 {others}"
    if count != len(names):
        yield "the status of a list is not its length"
    for test in [*(re.sub(r"([],[])", r"\\\1", name) for name in names), *PRINTED]:
        of_small, of_real = (outcome(program, test) for program in (small, real))
        if of_small != of_real:
            yield f"{test}: the small header {of_small}, Catch2 {of_real}"

    for argument, wanted in (("no such test", 101), ("--unknown", 101), ("a failed REQUIRE stops", 120)):
        if run(small, argument)[0] != wanted:
            yield f"{argument}: the status is not {wanted}"
    for test, texts in PRINTED.items():
        _, lines = run(small, test)
        yield from (f"{test}: not printed: {text}" for text in texts if not any(text in line for line in lines))
        if test == "messages print" and any("round :=" in line for line in lines[-4:]):
            yield "a CAPTURE outlives its scope"
        if test == "values print" and lines.count("  with false") != 1:
            yield "a lone value is not printed"


if __name__ == "__main__":
    found = list(complaints(*sys.argv[1:]))
    print("\n".join(found))
    sys.exit(bool(found))
