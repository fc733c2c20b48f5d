#!/usr/bin/env python3
"""Tests that all places name the same release, and that CHANGELOG.md names the versions of the sources.

usage: versions_test.py ROOT
"""

import re
import sys
import unittest
from datetime import datetime
from pathlib import Path

ROOT = Path(sys.argv[1])
GAME = "shared/include/platon/game"


def found(file, pattern):
    """All groups of the first place that matches."""
    match = re.search(pattern, (ROOT / file).read_text(encoding="utf-8"), re.MULTILINE)
    if not match:
        raise AssertionError(f"{file} has no {pattern}")
    return match.groups()


class Versions(unittest.TestCase):
    def setUp(self):
        (self.version,) = found("CMakeLists.txt", r"project\(platon VERSION ([\d.]+) ")
        self.heading, self.date = found("CHANGELOG.md", r"^## ([\d.]+) - (\d{4}-\d\d-\d\d)$")

    def test_the_changelog_begins_with_this_release(self):
        (first,) = found("CHANGELOG.md", r"^## (\S+)")
        self.assertEqual((first, self.heading), (self.version, self.version))

    def test_the_package_and_the_description_name_this_release_and_its_date(self):
        package, date = found("deploy/debian/changelog", r"\Aplaton \((.*)\) .*\n(?:(?!platon ).*\n)*? -- .*>  (.*)$")
        self.assertEqual(package, self.version)
        self.assertEqual(datetime.strptime(date, "%a, %d %b %Y %H:%M:%S %z").date().isoformat(), self.date)
        description = found("deploy/desktop/invalid.platon.platon.metainfo.xml", r'<releases>\s*<release version="(.*)" date="(.*)"/>')
        self.assertEqual(description, (self.version, self.date))

    def test_each_package_is_newer_than_the_one_before(self):
        entries = re.findall(r"(?m)^ -- .*>  (.*)$", (ROOT / "deploy/debian/changelog").read_text(encoding="utf-8"))
        times = [datetime.strptime(entry, "%a, %d %b %Y %H:%M:%S %z") for entry in entries]
        self.assertEqual(times, sorted(set(times), reverse=True), "lintian refuses packages of the same time")

    def test_the_library_is_looked_for_in_this_version(self):
        minor = self.version.rpartition(".")[0]
        for file in ("docs/physics.md", "shared/examples/CMakeLists.txt"):
            self.assertEqual(found(file, r"find_package\(platon ([\d.]+) "), (minor,), file)

    def test_the_changelog_names_the_versions_of_rules_protocol_and_recordings(self):
        named = found("CHANGELOG.md", r"^Versions: rules (\d+), protocol (\d+), format of recordings (\d+)\.")
        rules = found(f"{GAME}/game.h", r"kRulesVersion = (\d+);")
        protocol = found("protocol/limits.h", r"kProtocolVersion = (\d+);")
        recordings = found(f"{GAME}/recording_format.h", r'kRecordingMagic = "PLATREC(\d)";')
        self.assertEqual(named, rules + protocol + recordings)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
