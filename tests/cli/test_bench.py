"""`flashbvh bench`: its tables."""
import re

from cli import Case, flashbvh, long, refuse_each


class BenchTest(Case):
    @long
    def test_the_tables_and_the_data_of_figure_33(self):
        out = flashbvh("bench --table 3 --table 6 --repetitions-scale 0.0001 --rounds 2")
        out.matches(
            "^Table 3: Separation$",
            "^Table 6: Scalability$",
            "^Figure 33",
            r"^ *796  *[0-9.]+",
            r"^203776  *[0-9.]+")
        out.lacks("Table 2")
        for row in ("volume-stack", "alternating-stack", "stackless", "stackless-post", "leaf", "ranked",
                    "ranked, default tree"):
            with self.subTest(row):
                self.assertEqual(len(re.findall(rf"^{row}  *[0-9.]+ ", out, re.M)), 8)

    def test_options_that_are_refused(self):
        refuse_each("bench", {
            "--table --table 1": "--table",
            "--table 9": "--table",
            "--table 3 --rounds 0": "--rounds",
            "--table 3 --repetitions-scale 0": "--repetitions-scale",
            "--table 3 --repetitions-scale nan": "--repetitions-scale",
        })
