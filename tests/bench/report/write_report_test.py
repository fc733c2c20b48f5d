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

    def test_an_aim_that_is_missed_is_marked(self):
        report = copy.deepcopy(self.measured)
        report["snapshot"]["hashNs"] = 400.5
        self.assertRegex(write_report.document(report), r"\| hash of 64 players \| ≤ 400 ns \| .* \| \*\*no\*\* \|")
        report["snapshot"]["hashNs"] = 399
        self.assertRegex(write_report.document(report), r"\| hash of 64 players \| ≤ 400 ns \| .* \| yes \|")


if __name__ == "__main__":
    WriteReportTest.bench = sys.argv.pop()
    unittest.main()
