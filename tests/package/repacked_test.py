#!/usr/bin/env python3
"""Tests that the packages of another version are what they are said to be."""

import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import repacked

CONTROL = """Package: {package}
Version: 0.2.0
Architecture: all
Maintainer: Platon contributors <contributors@platon.invalid>
Depends: platon-data (= 0.2.0), libc6 (>= 2.36)
Description: a package
"""


class Repacked(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="platon-repacked-"))
        self.addCleanup(shutil.rmtree, self.folder)

    def packed(self, package, files, scripts=()):
        """A package with these files, each of which holds its own path."""
        tree = self.folder / package
        for path in [*files, *(f"DEBIAN/{script}" for script in scripts)]:
            (tree / path).parent.mkdir(parents=True, exist_ok=True)
            (tree / path).write_text(f"#!/bin/sh\n# {path}\n", encoding="utf-8")
            (tree / path).chmod(0o755)
        (tree / "DEBIAN").mkdir(exist_ok=True)
        (tree / "DEBIAN/control").write_text(CONTROL.format(package=package), encoding="utf-8")
        deb = self.folder / f"{package}_0.2.0_all.deb"
        subprocess.run(["dpkg-deb", "-b", tree, deb], stdout=subprocess.DEVNULL, check=True)
        return deb

    def unpacked(self, deb):
        tree = self.folder / f"{deb.stem}-unpacked"
        subprocess.run(["dpkg-deb", "-R", deb, tree], check=True)
        return tree

    def old(self, package, files, scripts=()):
        repacked.repack(self.packed(package, files, scripts), self.folder, repacked.OLD_VERSION, repacked.as_old)
        return self.unpacked(self.folder / f"{package}_{repacked.OLD_VERSION}.deb")

    def test_the_version_is_another_one_also_among_the_dependencies(self):
        tree = self.old("platon-tools", ["usr/bin/platon-sim"])
        control = (tree / "DEBIAN/control").read_text(encoding="utf-8")
        self.assertIn("\nVersion: 0.1.0\n", control)
        self.assertIn("platon-data (= 0.1.0), libc6 (>= 2.36)", control)
        self.assertTrue((tree / "usr/bin/platon-sim").exists())

    def test_the_old_release_has_its_own_files(self):
        tree = self.old("platon-data", ["usr/share/platon/levels/a.level", "usr/share/doc/platon-data/docs/new.md"])
        files = {path.relative_to(tree).as_posix() for path in tree.rglob("*") if path.is_file()}
        listed = {"usr/share/doc/platon-data/changelog.gz", "usr/share/doc/platon-data/copyright", "usr/share/lintian/overrides/platon-data"}
        self.assertEqual(files, {"DEBIAN/control", "usr/share/platon/levels/a.level"} | listed)

    def test_the_old_server_has_its_own_scripts_and_configuration(self):
        tree = self.old("platon-server", ["etc/platon/server.toml", "usr/bin/platon-server"], ("preinst", "prerm"))
        for name in ("postinst", "prerm", "postrm"):
            self.assertEqual((tree / "DEBIAN" / name).read_bytes(), (repacked.OLD_RELEASE / name).read_bytes())
            self.assertTrue((tree / "DEBIAN" / name).stat().st_mode & 0o111)
        self.assertFalse((tree / "DEBIAN/preinst").exists())
        configuration = (tree / "etc/platon/server.toml").read_text(encoding="utf-8")
        self.assertIn('metrics = "127.0.0.1:9100"', configuration)

    def test_the_next_release_has_another_configuration(self):
        deb = self.packed("platon-server", ["etc/platon/server.toml"])
        repacked.repack(deb, self.folder, repacked.NEXT_VERSION, repacked.as_next)
        tree = self.unpacked(self.folder / f"platon-server_{repacked.NEXT_VERSION}.deb")
        text = (tree / "etc/platon/server.toml").read_text(encoding="utf-8")
        self.assertEqual(text, f"#!/bin/sh\n# etc/platon/server.toml\n{repacked.NEXT_COMMENT}\n")


if __name__ == "__main__":
    if not shutil.which("dpkg-deb"):
        print("skipped: dpkg-deb is not installed")
        sys.exit(77)
    unittest.main()
