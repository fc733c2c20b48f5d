"""Checks that a report can be written from the measurements of platon-bench.

usage: write_report_test.py PLATON_BENCH
"""

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

    def test_writes_every_section_and_picture(self):
        measured = subprocess.run([self.bench, "--quick", "--json"], check=True, capture_output=True).stdout
        with tempfile.TemporaryDirectory() as name:
            root = Path(name)
            (root / "docs/pictures").mkdir(parents=True)
            (root / "bench.json").write_bytes(measured)
            write_report.main([str(root / "bench.json"), str(root)])
            page = (root / "docs/speed_vs_error.md").read_text(encoding="utf-8")
            pictures = re.findall(r"\]\((pictures/[^)]+)\)", page)
            self.assertTrue(pictures)
            for picture in pictures:
                self.assertTrue((root / "docs" / picture).stat().st_size > 0, picture)
        self.assertEqual(re.findall(r"^## (.*)$", page, re.MULTILINE), SECTIONS)


if __name__ == "__main__":
    WriteReportTest.bench = sys.argv.pop()
    unittest.main()
