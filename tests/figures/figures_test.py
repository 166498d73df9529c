"""Accepted and refused figures of `hold`, rewritten budgets, and tables, for invented figures."""
import unittest

import pages
from results import Budgets, Refused, measured_in

BUDGETS = """figure,all,M4,M5
set.visits,1000,,
set.query,,1000,
set.visit,,50.00,
stack.query.graph,,252,260
"""


def measured(*lines):
    return measured_in(["core M4\n" + "".join(f"{line}\n" for line in lines)])


class FiguresTest(unittest.TestCase):
    def expect(self, said, *lines):
        """The budgets' complaints about these measurements."""
        self.assertEqual(list(Budgets(BUDGETS).complaints(measured(*lines))), said, lines)

    def test_near_the_budgets(self):
        self.expect([], "count set.visits 1000", "figure set.query 1020", "figure set.visit 49.00")
        self.expect([], "count set.visits 1000", "figure set.query 980", "quotient set.visit 153 3")
        self.expect([], "stack query graph 252", "figure other.query 1")

    def test_differences(self):
        self.expect(["M4 set.query: 1021, more than 2 % above its budget, 1000"],
                    "figure set.query 1021", "figure set.visit 50")
        self.expect(["M4 set.query: 979, better than its budget, 1000: run tools/figures.sh"],
                    "figure set.query 979", "figure set.visit 50")
        self.expect(["set.visits: 1001, its budget is 1000: every core has to count the same"],
                    "count set.visits 1001")
        self.expect(["M4 set.visit: has a budget, and was not measured"], "figure set.query 1000")
        self.expect(["M5 set.query: 7, and has no budget: run tools/figures.sh"], "core M5", "figure set.query 7")

    def test_programs(self):
        self.assertEqual(measured("hello", "figure a 3", "figure a 10", "figure a 9", "count b 4", "quotient c 1 2",
                                  "quotient c 2 2", "code query Os 70", "code query O2 -",
                                  "measured run-400 3 of 8, nearest 0.4"),
                         {("M4", "a"): "10", ("all", "b"): "4", ("M4", "c"): "0.75", ("M4", "code.query.Os"): "70",
                          ("M4", "runs.run-400.observed"): "3", ("M4", "runs.run-400.proven"): "8"})
        with self.assertRaisesRegex(Refused, "every core has to count the same"):
            measured("count a 1", "count a 2")
        with self.assertRaisesRegex(Refused, "not a number: a none"):
            measured("figure a none")

    def test_means_over_meshes(self):
        def lines(*sets):
            return [f"figure {of}.rotated.close.query.mean {10 * i + 1}" for i, of in enumerate(sets)]

        figures = measured(*lines("lump", "gear", "kr5", "spindle"))
        self.assertEqual((figures["M4", "meshes.rotated.close.query.mean"],
                          figures["M4", "meshes.rotated.close.query.worst"]), ("16", "31"))
        # A mean of only some of the meshes would be a different figure.
        self.assertFalse([name for _, name in measured(*lines("lump", "gear", "kr5")) if name.startswith("meshes")])

    def test_update(self):
        book = Budgets(BUDGETS)
        book.update(measured("figure set.query 900", "figure set.more 3", "core M7", "figure set.visit 8"))
        self.assertEqual(book.text(), "figure,all,M4,M5,M7\nset.visits,1000,,,\nset.query,,900,,\n"
                                      "set.visit,,,,8\nstack.query.graph,,252,260,\n")

    def test_pages(self):
        def page(*cells):
            return ("text\n<!-- figures set.{query, visit} set.visits -->\n" + pages.lines_of([
                ["a table", "every core", "M4"], ["a", "-", cells[0]], ["b, c", "-", "50.00"],
                ["d", cells[1], "-"]]) + "\n<!-- figures set: visits visits -->\n" + pages.lines_of(
                    [["size", "mean", "most"], ["2", cells[1], cells[1]]]) + "\n| a | table |\n")

        book = Budgets(BUDGETS.replace("visits,1000", "visits,10000"))
        self.assertEqual(pages.rewritten(book, page("7", "8")), page("1000", "10,000"))
        with self.assertRaisesRegex(Refused, "2 figures, 1 rows"):
            pages.rewritten(book, "<!-- figures a.{b,c} -->\n| a |\n| - |\n| b |\n")
        with self.assertRaisesRegex(Refused, "without a table"):
            pages.rewritten(book, "<!-- figures a.b -->\n\n| a |\n")
        with self.assertRaisesRegex(Refused, "no figure a.b"):
            pages.rewritten(book, "<!-- figures a.b -->\n| a | M4 |\n| - | - |\n| b | 1 |\n")


if __name__ == "__main__":
    unittest.main()
