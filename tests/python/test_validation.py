"""The solver held against exact laws: the rows of the command line."""

import csv
import unittest

import pastoso
from command_line import InFolder, run


class Validation(InFolder):
    def rows_of_the_command_line(self, *arguments):
        result = run("validate", *arguments, "-o", self.folder, "-q")
        self.assertEqual(result.returncode, 0, result.stderr)
        with open(self.folder / "validation.csv", newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def test_rows_are_those_of_the_command_line(self):
        expected = self.rows_of_the_command_line("nusselt-film", "bingham-film", "--scheme", "explicit")
        for threads in (1, 2):
            rows = pastoso.validate("nusselt-film", "bingham-film", scheme="explicit", threads=threads)
            self.assertEqual([list(row) for row in rows], [list(row) for row in expected])
            for row, line in zip(rows, expected):
                for name in ("case", "quantity", "scheme"):
                    self.assertEqual(row[name], line[name])
                for name in ("cell_mm", "angle_deg", "measured", "exact", "error_percent"):
                    # The command line writes five digits of each or more.
                    self.assertAlmostEqual(row[name], float(line[name]), delta=1e-5 * abs(row[name]) + 1e-9)
                self.assertIs(row["at_least"], line["at_least"] == "1")

    def test_errors_are_small_and_fade_with_the_cells(self):
        rows = [row for row in pastoso.validate("nusselt-film", scheme="large") if row["angle_deg"] == 0]
        # Speeds of an even film: to a hundredth.
        self.assertLess(max(abs(row["error_percent"]) for row in rows), 1)

    def test_cases_have_a_law_and_a_source(self):
        cases = pastoso.validation_cases()
        self.assertIn("nusselt-film", cases)
        for case in cases.values():
            self.assertTrue(case["law"] and case["source"])

    def test_what_there_is_not(self):
        self.assertEqual(self.input_error(lambda: pastoso.validate("nusselt")), self.sentence("validate", "nusselt"))
        self.assertIn('"fast"', self.input_error(lambda: pastoso.validate("nusselt-film", scheme="fast")))


if __name__ == "__main__":
    unittest.main()
