"""compare.py SMALL REAL: the small header against Catch2, on sample.cpp compiled with each."""
import difflib
import re
import subprocess
import sys

PRINTED = {
    "values print": [
        "sample.cpp:", 'failed in "values print"', "CHECK( text == nullptr )",
        "with -9000000000000000000 == 9000000000000000000", "with 200 == 201", 'with "text" == nullptr', "with 0x",
        "00001234 == nullptr", "with false == true", "with 0 == 1", "with 'a' == 'b'", "with {?} == {?}",
        "with 1.5 == 2.0", "with 0.5f == -0.1000000015f", " * 2^", "with -0.3333333333 == 1000000000000000000.0",
        "test cases: 1, failures: 13"],
    "messages print": [
        "about all", "about a section", "in a section", "round := 2", "round + 5 := 7", '"letters" := "letters"',
        "opaque := {?}"],
}


def run(program, *arguments):
    """Its status and what it prints."""
    done = subprocess.run([program, *arguments], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          errors="replace")
    return done.returncode, done.stdout.splitlines()


def outcome(program, test):
    """The steps that a program traces, and whether it passes."""
    status, lines = run(program, test)
    return [line for line in lines if line.startswith("trace: ")] + ["fails" if status else "passes"]


def complaints(small, real):
    # What both list, with the escapes of Catch.cmake; hidden test cases are not listed.
    (count, names), (_, others) = (run(program, "--list-test-names-only") for program in (small, real))
    if sorted(names) != sorted(others):
        yield "\n".join(["other test cases", *difflib.ndiff(sorted(names), sorted(others))])
    if len(names) < 18:
        yield "test cases are missing"
    if count != len(names):
        yield "the status of a list is not its length"
    for test in [*(re.sub(r"([],[])", r"\\\1", name) for name in names), "[nested]", "[values]", "[types]", "[print]"]:
        of_small, of_real = (outcome(program, test) for program in (small, real))
        if of_small != of_real:
            yield "\n".join([f"{test}: the small header and Catch2 differ:", *difflib.ndiff(of_small, of_real)])

    if run(small, "no such test")[0] == 0:
        yield "that nothing runs is no failure"
    if run(small, "--unknown")[0] == 0:
        yield "an unknown option is no failure"
    if run(small, "a failed REQUIRE stops")[0] != 120:
        yield "a failed REQUIRE does not end with 120"

    for test, wanted in PRINTED.items():
        _, lines = run(small, test)
        missing = [text for text in wanted if not any(text in line for line in lines)]
        if missing:
            yield "\n".join([f"not printed: {missing}", *lines])
        if test == "values print" and lines.count("  with false") != 1:
            yield "a lone value is not printed"
        if test == "messages print" and any(" := " in line for line in lines[-4:]):
            yield "a CAPTURE outlives its scope"


if __name__ == "__main__":
    found = list(complaints(*sys.argv[1:]))
    print("\n".join(found))
    sys.exit(bool(found))
