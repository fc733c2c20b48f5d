#!/usr/bin/env python3
"""Tests what the package of the server does with the second servers of a machine, platon-server@NAME.

usage: maintainer_scripts_test.py ROOT
"""

import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(sys.argv[1]).resolve()
SCRIPT = (ROOT / "deploy/debian/platon-server.prerm").read_text(encoding="utf-8")


class Prerm(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="platon-prerm-"))
        self.addCleanup(shutil.rmtree, self.folder)
        self.units = self.folder / "etc/systemd/system"
        self.wants = self.units / "multi-user.target.wants"
        self.wants.mkdir(parents=True)
        (self.folder / "run/systemd/system").mkdir(parents=True)
        for name in ("platon-server.service", "platon-server@second.service", "platon-server@third.service", "other@second.service"):
            (self.wants / name).symlink_to(f"/lib/systemd/system/{name}")
        invoke = self.folder / "deb-systemd-invoke"
        invoke.write_text(f'#!/bin/sh\necho "$@" >>{self.folder}/calls\nexit 1\n', encoding="utf-8")
        invoke.chmod(0o755)

    def run_script(self, *arguments):
        """Runs the script with the folders of the test; the calls of deb-systemd-invoke."""
        text = SCRIPT.replace("/etc/systemd", f"{self.folder}/etc/systemd").replace("/run/systemd", f"{self.folder}/run/systemd")
        subprocess.run(["sh", "-c", text, "prerm", *arguments], env={"PATH": f"{self.folder}:/usr/bin:/bin"}, check=True)
        calls = self.folder / "calls"
        return calls.read_text(encoding="utf-8") if calls.exists() else ""

    def enabled(self):
        return sorted(path.name for path in self.wants.iterdir())

    def test_a_removal_stops_and_disables_second_servers(self):
        self.assertEqual(self.run_script("remove"), "stop platon-server@*.service\n")
        self.assertEqual(self.enabled(), ["other@second.service", "platon-server.service"])

    def test_an_upgrade_leaves_second_servers_alone(self):
        self.assertEqual(self.run_script("upgrade", "0.9"), "")
        self.assertEqual(len(self.enabled()), 4)

    def test_a_removal_without_systemd_succeeds(self):
        shutil.rmtree(self.folder / "run")
        shutil.rmtree(self.units)
        self.assertEqual(self.run_script("remove"), "")

    def test_what_the_operator_has_masked_stays_masked(self):
        (self.units / "platon-server@fourth.service").symlink_to("/dev/null")
        self.run_script("remove")
        self.assertTrue((self.units / "platon-server@fourth.service").is_symlink())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
