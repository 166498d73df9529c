"""Accepted and refused figures, rewritten budgets, and a page's tables, for invented figures."""
import unittest

from figures import Budgets, Refused, measured_in, summary

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

    def test_programs(self):
        self.assertEqual(measured_in(["hello\ncore M4\nfigure a 3\nfigure a 10\ncount b 4\ncode query Os 70\n"
                                      "code query O2 -\nmeasured run-400 3 of 8, nearest 0.4\n"]),
                         {("M4", "a"): 10, ("all", "b"): 4, ("M4", "code.query.Os"): 70,
                          ("M4", "runs.run-400.observed"): 3, ("M4", "runs.run-400.proven"): 8})
        for lines in "count a 1\ncount a 2\n", "figure a none\n":
            with self.assertRaises(Refused):
                measured_in([lines])

    def test_sums(self):
        self.assertEqual(summary("core M4\nfigure a 3\nfigure b 7\nfigure a 10\nhello\n"),
                         "core M4\nhello\nfigure a.mean 7\nfigure a.max 10\nfigure b 7\n")
        many = "".join(f"count c {i}\n" for i in range(20000))
        self.assertEqual(summary(many), "count c.mean 10000\ncount c.max 19999\ncount c.thousandth 19979\n")

    def test_update(self):
        book = Budgets(BUDGETS)
        book.update(measured_in(["core M4\nfigure set.query 900\nfigure set.more 3\n"]))
        self.assertEqual(book.text(), BUDGETS.replace("1000,\n", "900,\n"))

    def test_page(self):
        page = "text\n\n<!-- set -->\n{}\nmore\n"
        table = ("|                  |       M4 |\n| ---------------- | -------: |\n"
                 "| query            |    1,000 |\n| walk, mean / max | 20 / 300 |\n")
        for old in "", "| old |\n":
            book = Budgets(BUDGETS + "set.walk.mean,,20,\nset.walk.max,,300,\n")
            self.assertEqual(book.shown_in(page.format(old)), page.format(table))


if __name__ == "__main__":
    unittest.main()
