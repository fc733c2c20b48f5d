#!/usr/bin/env python3
"""Tests the units of systemd offline: they are valid, and what they let a server do is little.

usage: units_test.py FOLDER, which holds the units as they are installed. Exit 77 without systemd.
"""

import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

FOLDER = Path(sys.argv[1])
UNITS = ("platon-server.service", "platon-server@.service")
MOST_EXPOSED = 1.5  # of 10, as systemd-analyze rates it


def analyze(*arguments):
    return subprocess.run(["systemd-analyze", *arguments], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


class Units(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="platon-units-"))
        self.addCleanup(shutil.rmtree, self.folder)
        self.names = []
        for unit in UNITS:
            text = (FOLDER / unit).read_text(encoding="utf-8")
            # The program need not be installed here.
            (self.folder / unit).write_text(re.sub(r"(?m)^ExecStart=\S+", "ExecStart=/bin/true", text), encoding="utf-8")

    def test_they_are_valid(self):
        for unit in UNITS:
            result = analyze("verify", "--man=no", self.folder / unit.replace("@", "@other"))
            self.assertEqual((result.returncode, result.stdout), (0, ""), unit)

    def test_only_what_stays_wrong_is_not_tried_again(self):
        for unit in UNITS:
            keys = dict(line.split("=", 1) for line in (FOLDER / unit).read_text(encoding="utf-8").splitlines() if "=" in line and line[:1].isupper())
            self.assertEqual((keys["Restart"], keys["RestartPreventExitStatus"], keys["StartLimitIntervalSec"]), ("on-failure", "2 3", "0"), unit)

    def test_they_expose_little(self):
        for unit in UNITS:
            result = analyze("security", "--offline=true", "--no-pager", self.folder / unit)
            exposure = re.search(r"Overall exposure level for \S+: ([0-9.]+)", result.stdout)
            self.assertTrue(exposure, result.stdout)
            self.assertLessEqual(float(exposure[1]), MOST_EXPOSED, result.stdout)

    def test_they_differ_in_names_and_folders_alone(self):
        one, many = ((FOLDER / unit).read_text(encoding="utf-8") for unit in UNITS)
        many = many.replace("/%i.toml", "/server.toml").replace("/%i", "").replace(" %i", "")
        self.assertEqual(many, one)


if __name__ == "__main__":
    if not shutil.which("systemd-analyze"):
        print("skipped: systemd-analyze is not installed")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
