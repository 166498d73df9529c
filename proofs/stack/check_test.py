"""check.py on valid figures, and on invalid ones."""
import unittest

from check import budgets, problems, read

LIMITS = budgets(["any", "small"], ["# one", "", "any stack walk 100", "small code walk Os 600",
                                    "small code walk Os 700", "large code walk Os 1"])


class CheckTest(unittest.TestCase):
    def check(self, wanted: str, *lines: str) -> None:
        """The only problem contains `wanted`; or there is none."""
        found = list(problems(LIMITS, read(list(lines))))
        self.assertEqual(bool(wanted), bool(found), found)
        self.assertTrue(any(wanted in problem for problem in found) or not wanted, found)

    def test_figures(self) -> None:
        code = "code walk Os 600"
        self.check("", code, "stack walk graph 100", "stack walk painted 84", "path walk walk 100")
        self.check("painted 83, 17 below", code, "stack walk graph 100", "stack walk painted 83")
        self.check("painted 84, above", code, "stack walk graph 80", "stack walk painted 84")
        self.check("more than 100", code, "stack walk graph 104", "stack walk painted 100")
        self.check("more than 600", "code walk Os 601", "stack walk graph 80",
                   "stack walk painted 80")
        self.check("only one of the two", code, "stack walk graph 80")
        self.check("not measured: code walk Os", "stack walk graph 80", "stack walk painted 80")
        self.check("no figures", "nothing")


if __name__ == "__main__":
    unittest.main()
