"""Checks that a report can be written from the measurements of platon-bench.

usage: write_report_test.py PLATON_BENCH
"""

import copy
import json
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import write_report

SECTIONS = ["Results", "Platon against each engine", "Aims", "How each engine is used", "Sweeps", "Whole steps", "Hard cases",
            "Trajectory over time", "Resolution", "Cost of features", "Games"]  # fmt: skip


class WriteReportTest(unittest.TestCase):
    bench = ""
    measured = {}

    @classmethod
    def setUpClass(cls):
        output = subprocess.run([cls.bench, "--quick", "--json"], check=True, capture_output=True).stdout
        cls.measured = json.loads(output)

    def test_writes_every_section_and_picture(self):
        with tempfile.TemporaryDirectory() as name:
            root = Path(name)
            (root / "docs/pictures").mkdir(parents=True)
            (root / "bench.json").write_text(json.dumps(self.measured), encoding="utf-8")
            write_report.main([str(root / "bench.json"), str(root)])
            page = (root / "docs/speed_vs_error.md").read_text(encoding="utf-8")
            pictures = re.findall(r"\]\((pictures/[^)]+)\)", page)
            self.assertTrue(pictures)
            for picture in pictures:
                self.assertTrue((root / "docs" / picture).stat().st_size > 0, picture)
        self.assertEqual(re.findall(r"^## (.*)$", page, re.MULTILINE), SECTIONS)
        self.assertNotRegex(page, r"\b(nan|inf|None)\b|[{}]")

    def with_jams(self, engine):
        """The measurements, as if this engine had jammed in one row of the platformer, and no other one anywhere."""
        report = copy.deepcopy(self.measured)
        for row in report["step"]:
            here = (row["scenes"], row["engine"], row["segments"]) == ("platformer", engine, 1000)
            row["jammed"] = row["halfSeconds"] // 4 if here else 0
        return write_report.document(report)

    def test_names_the_rows_in_which_an_engine_jammed(self):
        page = self.with_jams("box2d-2.4")
        self.assertIn("- box2d-2.4, platformer: 1 000 segments, 64 bodies: 25.0 %.", page)
        self.assertIn("Engines that jammed in at least one row: box2d-2.4.", page)
        self.assertEqual(len(re.findall(r"\) †", page)), 1)

    def test_says_that_no_engine_jammed(self):
        page = self.with_jams("none of them")
        self.assertIn("No engine jammed in any row.", page)
        self.assertEqual(len(re.findall(r"\) †", page)), 0)

    def test_an_aim_that_is_missed_is_marked(self):
        report = copy.deepcopy(self.measured)
        report["snapshot"]["hashNs"] = 400.5
        self.assertRegex(write_report.document(report), r"\| hash of 64 players \| ≤ 400 ns \| .* \| \*\*no\*\* \|")
        report["snapshot"]["hashNs"] = 399
        self.assertRegex(write_report.document(report), r"\| hash of 64 players \| ≤ 400 ns \| .* \| yes \|")

    def test_a_place_farther_off_than_float64_and_a_millionth_is_above_the_aim(self):
        report = copy.deepcopy(self.measured)
        row = next(r for r in report["trajectory"] if r["engine"] == "platon+remainder")
        row["maxError"] = 0.5
        self.assertRegex(write_report.document(report), r"\| 5\.0e-01 units; above in 1 of \d+ \| \*\*no\*\* \|")


if __name__ == "__main__":
    WriteReportTest.bench = sys.argv.pop()
    unittest.main()
