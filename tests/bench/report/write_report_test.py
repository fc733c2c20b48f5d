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

import opening
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
        opening = page.split("\n\n")[2]
        self.assertEqual(re.findall(r"(?m)^\| (\w[\w .]*?) \|", opening),
                         ["engine", "Platon", "float64", "float32", "Box2D 2.4", "Box2D 3", "Chipmunk 7"])  # fmt: skip
        self.assertNotRegex(page, r"\b(nan|inf|None)\b|[{}]")

    def test_an_aim_that_is_missed_is_marked(self):
        report = copy.deepcopy(self.measured)
        report["snapshot"]["hashNs"] = 400.5
        self.assertRegex(write_report.document(report), r"\| hash of 64 players \| ≤ 400 ns \| .* \| \*\*no\*\* \|")
        report["snapshot"]["hashNs"] = 399
        self.assertRegex(write_report.document(report), r"\| hash of 64 players \| ≤ 400 ns \| .* \| yes \|")

    def test_a_missed_aim_has_its_reason(self):
        report = copy.deepcopy(self.measured)
        for nanoseconds in (100, 1000):
            for row in report["advance"]:
                row["nsPerPlayerTick"] = nanoseconds
            self.assertEqual("a player near an edge has several instances" in write_report.document(report), nanoseconds == 1000)

    def test_a_peer_that_jammed_is_named_beside_its_time(self):
        report = copy.deepcopy(self.measured)
        for row in report["step"]:
            row["halfSeconds"], row["jammed"] = 1000, 500 if row["engine"] == "box2d-2.4" else 0
        page = write_report.document(report)
        jammed = r" × box2d-2.4 \(jammed in 50.0 % of the half seconds\)"
        self.assertRegex(page, rf"relative to the faster of Box2D and Chipmunk \| ≤ 0.5 \| .*{jammed}.* \|")
        self.assertRegex(page, r"times that of box2d-2.4 \(jammed in 50.0 % of the half seconds\) and")
        self.assertRegex(page, r" × chipmunk-7.0 \(built with assertions\)")

    def test_an_engine_that_informs_only_has_columns(self):
        report = copy.deepcopy(self.measured)
        without = write_report.document(report)
        for part in ("step", "hardCases", "trajectory"):
            report[part] += [dict(row, engine="box2d-3.9") for row in report[part] if row["engine"] == "platon"]
        page = write_report.document(report)
        self.assertIn("| Box2D 3 | not in this run: `PLATON_BOX2D3=FOLDER ./platon bench` |", without)
        self.assertRegex(page, r"\| Box2D 3 \| \d+ \| 0 \| never \| [\d.]+ mm; [\d.]+ mm \| [\d.]+ mm; [\d.]+ mm \|")
        self.assertEqual(len(re.findall(r"\| box2d-3\.9 \|\n", page)), 7)  # two of times, one each of memory and trajectories, three of hard cases
        self.assertIn("`box2d-3.9` is a checkout of Box2D 3", page)
        for section in ("## Results", "## Platon against each engine", "## Aims"):
            self.assertEqual(*(text.split(section)[1].split("\n## ")[0] for text in (page, without)))

    def test_lengths_have_units_that_suit_them(self):
        for metres, text in ((0, "0"), (0.00007, "0.07 mm"), (0.69, "690 mm"), (12.4, "12 m"), (345.4, "345 m"), (4700, "4.7 km")):
            self.assertEqual(opening.length(metres), text)


if __name__ == "__main__":
    WriteReportTest.bench = sys.argv.pop()
    unittest.main()
