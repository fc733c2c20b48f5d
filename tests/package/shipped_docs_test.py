#!/usr/bin/env python3
"""Tests the pages and the examples that the packages ship.

usage: shipped_docs_test.py ROOT BUILD
"""

import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "docs"))
from names_test import check_links
from pages import pages

DEBIAN = "deploy/debian"
PAGES = "usr/share/doc/platon-data/docs"


def broken_links(folder):
    """Every link that leads nowhere, of the pages that lie in a folder as in the tree."""
    return [f"{page}: {fault}" for page, text in pages(folder) for fault in check_links(folder, page, text)]


class ShippedDocs(unittest.TestCase):
    def setUp(self):
        folder = tempfile.mkdtemp(prefix="platon-docs-")
        self.addCleanup(shutil.rmtree, folder)
        subprocess.run(["cmake", "--install", BUILD, "--component", "data", "--prefix", folder], stdout=subprocess.DEVNULL, check=True)
        self.docs = Path(folder) / "share/doc/platon"

    def test_every_link_of_a_shipped_page_leads_somewhere(self):
        self.assertEqual(broken_links(self.docs), [])
        self.assertEqual({page for page, _ in pages(self.docs)}, {page for page, _ in pages(ROOT)})

    def test_a_page_that_is_missing_is_found(self):
        (self.docs / "docs/fleet.md").unlink()
        self.assertIn("docs/hosting.md: the link fleet.md leads nowhere", broken_links(self.docs))

    def test_every_package_leads_to_the_pages(self):
        control = (ROOT / DEBIAN / "control").read_text(encoding="utf-8")
        for package, depends in re.findall(r"(?m)^Package: (.*)$(?:\n(?!Depends:).+)*\nDepends: (.*)$", control):
            if package == "platon-data":
                continue
            with self.subTest(package):
                links = (ROOT / DEBIAN / f"{package}.links").read_text(encoding="utf-8")
                self.assertEqual(links, f"{PAGES} usr/share/doc/{package}/docs\n")
                self.assertIn("platon-data (= ${source:Version})", depends)

    def test_no_page_is_compressed_or_renamed(self):
        rules = (ROOT / DEBIAN / "rules").read_text(encoding="utf-8")
        for command in ("dh_compress --exclude=.md --exclude=.v", "dh_installchangelogs --exclude=CHANGELOG.md"):
            self.assertIn(f"\t{command}\n", rules)

    def test_the_server_ships_alerts_dashboard_and_manifests(self):
        folders = (ROOT / DEBIAN / "platon-server.examples").read_text(encoding="utf-8").split()
        shipped = {path.name for folder in folders for path in (ROOT / folder).iterdir()}
        self.assertLessEqual({"alerts.yaml", "platon.json", "fleet.yaml", "gameserver_allocation.yaml"}, shipped)


if __name__ == "__main__":
    ROOT, BUILD = (Path(argument).resolve() for argument in sys.argv[1:3])
    unittest.main(argv=sys.argv[:1])
