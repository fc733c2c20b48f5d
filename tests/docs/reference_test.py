#!/usr/bin/env python3
"""Tests the reference pages that doxygen makes from the comments of the library's headers.

usage: reference_test.py ROOT
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

DOXYFILE = "shared/package/Doxyfile"
HEADERS = "shared/include/platon"
# Doxygen passes over such a name without a warning if there is no such member.
MEMBER = re.compile(r"(?<![:\w])[A-Z]\w*::\w+")


def make_pages(root, folder):
    """(exit code, warnings) of doxygen on the headers of a tree. The pages come into folder/html."""
    environment = os.environ | {"PLATON_REFERENCE": str(folder)}
    result = subprocess.run(["doxygen", DOXYFILE], cwd=root, env=environment, stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, text=True)  # fmt: skip
    return result.returncode, result.stdout


def members_named(header):
    """The members that the comments of a header name with their class."""
    comments = re.findall(r"///<? (.*)", header.read_text(encoding="utf-8"))
    return {name for comment in comments for name in MEMBER.findall(comment)}


def text_of(page):
    return " ".join(re.sub(r"<[^>]+>", " ", page).split())


class Reference(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp(prefix="platon-reference-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.code, cls.said = make_pages(ROOT, cls.folder)
        cls.pages = {path.name: path.read_text(encoding="utf-8") for path in (cls.folder / "html").glob("*.html")}

    def test_every_header_gives_pages_without_warnings(self):
        self.assertEqual((self.code, self.said), (0, ""))
        for header in (ROOT / HEADERS).rglob("*.h"):
            self.assertIn(f">{header.name}<", self.pages["files.html"])
        classes = text_of(self.pages["annotated.html"])
        self.assertIn("World A collection of map parts and of the entities that move on them &#160;", classes)
        self.assertNotIn("intern", classes)

    def test_every_member_that_a_comment_names_is_a_link(self):
        named = set().union(*(members_named(header) for header in (ROOT / HEADERS).rglob("*.h")))
        self.assertGreater(len(named), 10)
        linked = set(re.findall(r"<a [^>]*>([\w:]+)(?:\(\))?</a>", "".join(self.pages.values())))
        self.assertEqual(named - linked, set())

    def test_a_wrong_comment_is_an_error(self):
        root = self.folder / "tree"
        for name in ("exact", "physics", "game"):
            (root / HEADERS / name).mkdir(parents=True)
        (root / DOXYFILE).parent.mkdir(parents=True)
        shutil.copy(ROOT / DOXYFILE, root / DOXYFILE)
        comments = ("Calls #vanish0.", "See @ref vanish1.", "@param vanish2 Time.", "@vanish3.")
        functions = "".join(f"/// {comment}\nint f{number}(int seconds);\n" for number, comment in enumerate(comments))
        source = f"#pragma once\nnamespace platon {{\n{functions}}}\n"
        (root / HEADERS / "exact/time.h").write_text(source, encoding="utf-8")
        code, said = make_pages(root, self.folder)
        self.assertNotEqual(code, 0)
        for number in range(len(comments)):
            self.assertRegex(said, rf"exact/time\.h:\d+: .*vanish{number}")


if __name__ == "__main__":
    if shutil.which("doxygen") is None:
        sys.exit("doxygen is not installed: apt-get install doxygen")
    ROOT = Path(sys.argv.pop()).resolve()
    unittest.main()
