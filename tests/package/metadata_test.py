#!/usr/bin/env python3
"""Tests what the packages tell others: the packages that build them, and what a desktop knows of the client.

usage: metadata_test.py ROOT
"""

import re
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

from packages_test import TOOLS

ROOT = Path(sys.argv[1])
# The compiler comes with every builder of Debian packages, and only a program that draws needs the driver.
NOT_TO_BUILD = {"g++", "libgl1-mesa-dri"}


def list_of(name):
    """A list of packages of ./platon, each with the probe beside it."""
    text = (ROOT / "platon").read_text(encoding="utf-8")
    lists = re.search(r"(?m)^to_build='$.*(?=^usage\(\))", text, re.DOTALL)[0]
    script = f'{lists}\nprintf "%s" "${name}"'
    result = subprocess.run(["bash", "-uc", script], stdout=subprocess.PIPE, text=True, check=True)
    return [line.split() for line in result.stdout.splitlines() if line]


def build_depends():
    control = (ROOT / "deploy/debian/control").read_text(encoding="utf-8")
    field = re.search(r"(?m)^Build-Depends:(.*\n(?: .*\n)*)", control)[1]
    return {entry.split()[0] for entry in field.split(",")}


class Metadata(unittest.TestCase):
    def assert_accepts(self, *command):
        if not shutil.which(command[0]):
            print(f"not checked: {command[0]} is not installed")
            self.skipTest("no validator")
        result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.assertEqual(result.returncode, 0, result.stdout)

    def test_a_builder_gets_all_that_cmake_wants(self):
        self.assertEqual({words[0] for words in list_of("to_build")} - build_depends(), NOT_TO_BUILD)

    def test_who_tests_gets_all_that_the_test_of_the_packages_wants(self):
        probes = {probe for words in list_of("to_test") for probe in words[1:]}
        self.assertEqual({f"tool:{tool}" for tool in TOOLS} - probes, {"tool:dpkg-deb"})  # which no Debian lacks

    def test_the_description_for_software_centres_is_valid(self):
        self.assert_accepts("appstreamcli", "validate", "--no-net", *(ROOT / "deploy/desktop").glob("*.metainfo.xml"))

    def test_the_desktop_file_is_valid(self):
        self.assert_accepts("desktop-file-validate", ROOT / "deploy/desktop/platon.desktop")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
