"""Accepted and refused figures, and rewritten budgets, for invented figures."""
import unittest

from figures import Budgets, Refused, measured_in

BUDGETS = "figure,all,M4,M5\nset.visits,1000,,\nset.query,,1000,\nstack.query.graph,,252,260\n"


class FiguresTest(unittest.TestCase):
    def expect(self, said, *lines):
        """The budgets' complaints about these measurements."""
        measured = measured_in(["core M4\n" + "".join(f"{line}\n" for line in lines)])
        self.assertEqual(list(Budgets(BUDGETS).complaints(measured)), said, lines)

    def test_near_the_budgets(self):
        self.expect([], "count set.visits 1000", "figure set.query 1020", "figure set.other 3")
        self.expect([], "count set.visits 1000", "figure set.query 980", "stack query graph 252")

    def test_differences(self):
        self.expect(["M4 set.query: 1021, more than 2 % above its budget, 1000"], "figure set.query 1021")
        self.expect(["M4 set.query: 979, better than its budget, 1000: run tools/figures.sh"], "figure set.query 979")
        self.expect(["set.visits: 1001, its budget is 1000: every core has to count the same"], "count set.visits 1001")
        self.expect(["M4 set.query: has a budget, and was not measured"], "figure set.other 3")
        self.expect(["M5 set.query: 7, and has no budget: run tools/figures.sh"], "core M5", "figure set.query 7")

    def test_refused(self):
        for lines in "count a 1\ncount a 2\n", "figure a none\n":
            with self.assertRaises(Refused):
                measured_in([lines])

    def test_update(self):
        book = Budgets(BUDGETS)
        book.update(measured_in(["core M4\nfigure set.query 900\nfigure set.more 3\n"]))
        self.assertEqual(book.text(), BUDGETS.replace("1000,\n", "900,\n"))


if __name__ == "__main__":
    unittest.main()
