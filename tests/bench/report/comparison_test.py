"""Checks how the comparison of the report names rows in which Platon is behind."""

import unittest

from comparison import Measure


class MeasureTest(unittest.TestCase):
    @staticmethod
    def measure(values, why=""):
        return Measure("time, ns", ["small", "large"], lambda row, engine: values.get(engine, {}).get(row), why)

    def test_is_ahead_where_its_value_is_lower(self):
        measure = self.measure({"platon": {"small": 1, "large": 2}, "float32": {"small": 2, "large": 3}})
        self.assertEqual(measure.cell("float32"), "ahead")
        self.assertIsNone(measure.line())

    def test_counts_equal_rows(self):
        measure = self.measure({"platon": {"small": 1, "large": 2}, "float32": {"small": 1, "large": 3}, "float64": {"small": 1, "large": 2}})
        self.assertEqual(measure.cell("float32"), "ahead in 1 of 2, else equal")
        self.assertEqual(measure.cell("float64"), "equal")
        self.assertIsNone(measure.line())

    def test_names_the_row_in_which_it_is_most_behind_and_why(self):
        values = {"platon": {"small": 3, "large": 30}, "float64": {"small": 2, "large": 10}, "box2d-2.4": {"small": 4, "large": 40}}
        measure = self.measure(values, {"float64": "It rounds."})
        self.assertEqual(measure.cell("float64"), "behind in 2 of 2")
        self.assertEqual(measure.line(), "time, ns: float64 in 2 of 2, most in large: 30 against 10. It rounds.")

    def test_a_peer_of_zero_is_the_most_ahead(self):
        measure = self.measure({"platon": {"small": 1, "large": 30}, "float64": {"small": 0, "large": 10}})
        self.assertIn("most in small: 1 against 0", measure.line())

    def test_says_that_the_reason_is_not_known(self):
        measure = self.measure({"platon": {"small": 3}, "float32": {"small": 2}})
        self.assertIn("This run does not show why.", measure.line())

    def test_leaves_out_engines_without_a_result(self):
        measure = self.measure({"platon": {"small": 3}})
        self.assertEqual(measure.cell("chipmunk-7.0"), "")
        self.assertIsNone(measure.line())


if __name__ == "__main__":
    unittest.main()
