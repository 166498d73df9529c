"""What `compare` lets pass and what it does not, `merge` and tables, on figures made up here."""
import contextlib
import io
import tempfile
import unittest

from figures import Refused, compare, figures_of, merged
from page import Missing, page_of

DATA = {("all", "set.visits"): "1000", ("M4", "set.query"): "1000", ("M4", "set.visit"): "50.00",
        ("M4", "stack.query"): "252"}
PARTS = "cycles_per_instruction 1.5\npart M4 168 A part\n"


class FiguresTest(unittest.TestCase):
    def expect(self, good, said, *lines):
        """The lines, measured, compare so and print this."""
        output = io.StringIO()
        with tempfile.NamedTemporaryFile("w") as file, contextlib.redirect_stdout(output):
            file.write("".join(f"{line}\n" for line in lines))
            file.flush()
            self.assertEqual(compare(DATA, [file.name]), good, lines)
        self.assertIn(said, output.getvalue())

    def test_near_the_page(self):
        self.expect(True, "3 compared, 0 differ", "all set.visits 1000", "M4 set.query 1000", "M4 set.visit 50.00")
        self.expect(True, "0 differ", "all set.visits 1000", "M4 set.query 1020", "M4 set.visit 49.00")
        self.expect(True, "0 differ", "M4 stack.query 252")

    def test_differences(self):
        self.expect(False, "M4 set.query: 1021, more than 2 %", "M4 set.query 1021", "M4 set.visit 50")
        self.expect(False, "better than documented", "M4 set.query 979", "M4 set.visit 50")
        self.expect(False, "M4 set.visit: 51.01", "M4 set.query 1000", "M4 set.visit 51.01")
        self.expect(False, "every core has to count the same", "all set.visits 1001")
        self.expect(False, "every core has to count the same", "all set.visits 1000", "all set.visits 1001")
        self.expect(False, "M4 set.visit: on the page, and was not measured", "M4 set.query 1000")
        self.expect(False, "not documented", "M4 set.query 1000", "M4 set.visit 50", "M4 set.other 1")
        self.expect(False, "not documented", "M5 set.query 1000")
        self.expect(False, "nothing was measured")
        for line in "M4 set.query", "M4 set.query none", "":
            with self.assertRaisesRegex(Refused, "not a figure"):
                self.expect(False, "", line)

    def test_merge(self):
        new = {("M5", "set.query"): "7", ("M4", "set.query"): "900", ("M4", "new.one"): "1"}
        self.assertEqual(list(merged(DATA, new).items()), [
            (("all", "set.visits"), "1000"), (("M4", "set.query"), "900"), (("M4", "stack.query"), "252"),
            (("M4", "new.one"), "1"), (("M5", "set.query"), "7")])

    def test_programs(self):
        self.assertEqual(list(figures_of("core M4\nhello\nfigure set.query 3\ncount set.visits 4\n")),
                         [("M4", "set.query", "3"), ("all", "set.visits", "4")])

    def test_page(self):
        self.assertEqual(page_of(DATA, PARTS, "@table query | visits\n@row a | set.visits | set.query\n"
                                              "@row none | set.visits | set.none\n@end none\n@{M4 set.visit}\n"),
                         "| query | visits |   M4 |\n| ----- | -----: | ---: |\n| a     |   1000 | 1000 |\n\n50.00\n")
        self.assertEqual(page_of(DATA, PARTS, "@table a\n@row a | set.none\n@end no rows\n"), "no rows\n\n")
        with self.assertRaisesRegex(Missing, "no figure M4 set.none"):
            page_of(DATA, PARTS, "so @{M4 set.none} instructions\n")


if __name__ == "__main__":
    unittest.main()
