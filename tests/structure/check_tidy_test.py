#!/usr/bin/env python3
"""Tests that check_tidy.py finds a complaint on a changed line, and only there, in small git repositories."""

import contextlib
import io
import json
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import check_tidy

GOOD = "int good() { return 0; }\n"
BAD = "int Bad_name() { return 0; }\n"


class Repository(unittest.TestCase):
    def setUp(self):
        self.root = Path(tempfile.mkdtemp(prefix="platon-tidy-")).resolve()
        self.addCleanup(shutil.rmtree, self.root)

    def git(self, *arguments):
        names = ["-c", "user.name=test", "-c", "user.email=test@localhost"]
        subprocess.run(["git", *names, *arguments], cwd=self.root, check=True, capture_output=True)

    def commit(self, **files):
        for name, text in files.items():
            (self.root / f"{name}.cpp").write_text(text, encoding="utf-8")
        self.git("add", "-A")
        self.git("commit", "-q", "-m", " ".join(files))
        return check_tidy.git(self.root, "rev-parse", "HEAD")


class Base(Repository):
    def test_without_a_commit_to_compare_with_it_is_skipped(self):
        with self.assertRaises(check_tidy.Skipped):
            check_tidy.base_of(self.root)
        self.git("init", "-q", "-b", "main")
        self.commit(a="")
        with self.assertRaises(check_tidy.Skipped):
            check_tidy.base_of(self.root)

    def test_main_is_compared_with_its_previous_commit_and_a_branch_with_its_merge_base(self):
        self.git("init", "-q", "-b", "main")
        first, second = self.commit(a=""), self.commit(b="")
        self.git("update-ref", "refs/remotes/origin/main", "HEAD")
        self.assertEqual(check_tidy.base_of(self.root), first)
        self.commit(c="")
        self.assertEqual(check_tidy.base_of(self.root), second)


class Complaints(Repository):
    def setUp(self):
        super().setUp()
        self.git("init", "-q", "-b", "main")
        shutil.copy(Path(__file__).parents[2] / ".clang-tidy", self.root)
        # Two sources compiled together, with an option and a precompiled header of another compiler.
        together = self.root / "unity_0_cxx.cxx"
        together.write_text("".join(f'#include "{self.root}/{name}.cpp"\n' for name in "ab"), encoding="utf-8")
        command = f"/usr/bin/c++ -fpch-preprocess -include lost.hxx -flto=auto -std=c++20 -c {together}"
        entry = {"directory": str(self.root), "file": str(together), "command": command}
        (self.root / "compile_commands.json").write_text(json.dumps([entry]), encoding="utf-8")
        self.commit(a=BAD + GOOD, b=GOOD)

    def output_of(self, accepted):
        with contextlib.redirect_stdout(io.StringIO()) as output:
            self.assertEqual(check_tidy.check(self.root, self.root), accepted, output.getvalue())
        return output.getvalue()

    def test_a_complaint_on_an_unchanged_line_is_no_error(self):
        self.commit(a=BAD + GOOD.replace("0", "1"), b=GOOD + GOOD.replace("good", "better"))
        self.assertIn("checking 2 of 2 changed files", self.output_of(True))

    def test_a_complaint_on_a_changed_line_is_an_error(self):
        self.commit(b=GOOD + BAD)
        self.assertRegex(self.output_of(False), r"b\.cpp:2:5: error: invalid case style for function 'Bad_name'")

    def test_files_that_are_not_committed_and_headers_are_checked(self):
        self.commit(b=GOOD + GOOD.replace("good", "better"))
        (self.root / "b.h").write_text(f"#pragma once\ninline {BAD}", encoding="utf-8")
        self.assertRegex(self.output_of(False), r"b\.h:2:12: error: invalid case style for function 'Bad_name'")

    def test_a_file_that_cannot_be_parsed_is_an_error(self):
        self.commit(b='#include "lost.h"\n' + GOOD)
        self.git("commit", "--allow-empty", "-q", "-m", "d")
        (self.root / "b.cpp").write_text('#include "lost.h"\n' + GOOD.replace("0", "1"), encoding="utf-8")
        self.output_of(False)


if __name__ == "__main__":
    sys.exit(unittest.main())
