#!/usr/bin/env python3
"""Tests that names_test.py, figures_test.py and quotes_test.py find errors."""

import sys
import tempfile
import unittest
from pathlib import Path

import figures_test
import names_test
import pages
import quotes_test

PAGE = Path("docs/page.md")


class Names(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        (self.root / "docs").mkdir()
        (self.root / PAGE).write_text("# One head, `two`\n", encoding="utf-8")

    def links(self, text):
        return list(names_test.check_links(self.root, PAGE, text))

    def words(self, *words):
        return list(names_test.check_words(self.root, words, "--known kKnown", {"known_test"}, {"Known": {"member", "kKnown"}}))

    def test_missing_files_and_headings_are_errors(self):
        self.assertEqual(self.links("[a](page.md) [b](page.md#one-head-two) [c](https://example.org)"), [])
        self.assertEqual(self.links("[a](other.md)"), ["the link other.md leads nowhere"])
        self.assertEqual(self.links("[a](page.md#three)"), ["page.md has no heading for the link page.md#three"])

    def test_missing_names_are_errors(self):
        self.assertEqual(self.words("docs/other.md"), ["the path docs/other.md does not exist"])
        self.assertEqual(self.words("other_test"), ["there is no test other_test"])
        self.assertEqual(self.words("--other"), ["no source has the option --other"])
        self.assertEqual(self.words("Known::other"), ["no class has the member Known::other"])
        self.assertEqual(self.words("Other::member"), ["no class has the member Other::member"])
        self.assertEqual(self.words("kOther"), ["no source has the constant kOther"])

    def test_words_are_taken_from_spans_and_blocks(self):
        self.assertEqual(pages.code_words("a `b c` d\n```\ne (f)\n```\n"), ["```", "e", "f", "```", "b", "c"])


class Figures(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.sources = figures_test.Sources(Path(folder.name), Path(folder.name))
        (Path(folder.name) / "page.md").write_text("It has 1 234 legs, 5 faces.\n", encoding="utf-8")

    def errors(self, *actual, sentence="{} legs, {} faces"):
        figures = figures_test.Figures("page.md", sentence, lambda sources: list(actual))
        return list(figures_test.compare(self.sources, figures, False))

    def test_a_wrong_figure_is_an_error(self):
        self.assertEqual(self.errors("1 234", "5"), [])
        self.assertEqual(self.errors("1 235", "5"), ["page.md: '1 234 legs, 5 faces' should be '1 235 legs, 5 faces'"])

    def test_a_missing_sentence_is_an_error(self):
        self.assertEqual(self.errors("5", sentence="{} edges"), ["page.md: no sentence '{} edges'"])


class Builds(unittest.TestCase):
    MACHINES = (quotes_test.Machine("a", "ARM, GCC", (), (), ("qemu-arm",)), quotes_test.Machine("b", "x86-64, GCC", (), ()),
                quotes_test.Machine("c", "x86-64, Clang", (), ()))  # fmt: skip

    def errors(self, text):
        return list(quotes_test.build_errors("page.md", text, self.MACHINES))

    def test_a_wrong_count_of_builds_is_an_error(self):
        self.assertEqual(self.errors("Three builds for two\narchitectures, one of them emulated"), [])
        self.assertEqual(self.errors("four builds for two architectures"),
                         ["page.md: 'four builds for two architectures', but there are three builds for two architectures"])  # fmt: skip
        self.assertEqual(self.errors("three builds for three architectures"),
                         ["page.md: 'three builds for three architectures', but there are three builds for two architectures"])  # fmt: skip
        self.assertEqual(self.errors("three builds for two architectures, all two emulated"),
                         ["page.md: 'two emulated', but one architectures are emulated"])  # fmt: skip

    def test_builds_are_not_machines(self):
        self.assertEqual(len(self.errors("the same to the last bit on three machines")), 1)
        self.assertEqual(len(self.errors("three machines are compared")), 1)
        self.assertEqual(self.errors("play on three machines"), [])

class Steps(unittest.TestCase):
    def test_a_program_without_its_folder_is_an_error(self):
        text = "`platon-level check FILE`\n```\n./platon play\nbuild/release/bin/platon-level check a\n```\n1. Then\n\n   ```\n   platon-level check b\n   ```\n"
        self.assertEqual(list(quotes_test.step_errors("page.md", text)),
                         ["page.md: 'platon-level check b' is not found in a checkout: write ./platon or build/release/bin/"])  # fmt: skip


if __name__ == "__main__":
    sys.exit(unittest.main())
