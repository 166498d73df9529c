"""run.py [--long] [WORD...]: runs the tests in test_*.py in parallel, each in a process and a folder of its own; with
words, only those whose name contains a word; with --long, those marked @long. Prints each failure with its line, and
keeps its folder.

To add a test, write a method test_WHAT_HOLDS into the class of its subject:

    def test_one_triangle_is_a_tree(self):
        write("point.obj", "v 0 0 0\\nv 0.1 0 0\\nv 0 0.1 0\\nf 1 2 3")
        flashbvh("bake point.obj -o point --cell 1").err.contains("without area once rounded: 1 triangle (0); kept")
        self.assertEqual(flashbvh("info point/point.fbvh --json").json["triangles"], 1)
        refuse("bake point.obj -o out --cell 0", "--cell")
"""
import multiprocessing
import os
import shutil
import sys
import unittest

import cli


def tests_in(suite):
    for test in suite:
        if isinstance(test, unittest.TestSuite):
            yield from tests_in(test)
        else:
            yield test


def is_wanted(test, words):
    is_long = getattr(getattr(test, test._testMethodName), "is_long", False)
    return is_long == ("--long" in sys.argv) and (not words or any(word in test.id() for word in words))


def run(number):
    """The failures of a test, and the JSON fields that it saw."""
    test, result = TESTS[number], unittest.TestResult()
    test.run(result)
    if result.wasSuccessful():
        os.chdir(cli.WORK)
        shutil.rmtree(cli.WORK / test.id(), ignore_errors=True)
    for _, reason in result.skipped:
        print(f"skipped: {test}: {reason}")
    return [f"FAILED: {at}\n{trace}  in {cli.WORK / test.id()}" for at, trace in result.errors + result.failures], \
        cli.SEEN_FIELDS


def main():
    shutil.rmtree(cli.WORK, ignore_errors=True)
    failed, failures, seen = 0, [], set()
    with multiprocessing.Pool(os.cpu_count(), maxtasksperchild=1) as pool:
        for reasons, fields in pool.imap_unordered(run, range(len(TESTS))):
            failed += bool(reasons)
            failures += reasons
            seen |= fields
    if not WORDS and "--long" not in sys.argv:
        listed = {(command, name) for command, names in cli.listed_fields().items() for name in names}
        failures += [f"FAILED: no test's JSON of {command} has {name}" for command, name in sorted(listed - seen)]
    print("\n".join([*failures, f"{len(TESTS) - failed} of {len(TESTS)} tests passed"]))
    sys.exit(bool(failures) or not TESTS)


if __name__ == "__main__":
    WORDS = [word.replace(" ", "_") for word in sys.argv[1:] if word != "--long"]
    TESTS = [test for test in tests_in(unittest.defaultTestLoader.discover(cli.HERE, "test_*.py"))
             if is_wanted(test, WORDS)]
    main()
