#!/usr/bin/env python3
"""Tests that names_test.py and figures_test.py find errors."""

import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "docs/pictures"))

import figures_test  # noqa: E402
import names_test  # noqa: E402
import pages  # noqa: E402
import seeded_times  # noqa: E402

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

    def test_existing_links_are_accepted(self):
        self.assertEqual(self.links("[a](page.md) [b](page.md#one-head-two) [c](https://example.org)"), [])

    def test_a_missing_file_is_an_error(self):
        self.assertEqual(self.links("[a](other.md)"), ["the link other.md leads nowhere"])

    def test_a_missing_heading_is_an_error(self):
        self.assertEqual(self.links("[a](page.md#three)"), ["page.md has no heading for the link page.md#three"])

    def test_existing_names_are_accepted(self):
        self.assertEqual(self.words("docs/page.md", "docs/*.md", "known_test", "--known", "Known::kKnown", "word", "Known::member(x)"), [])

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
        self.page = Path(folder.name) / "page.md"
        self.page.write_text("It has 1 234 legs, 5 faces.\n", encoding="utf-8")

    def errors(self, *actual, write=False, sentence="{} legs, {} faces"):
        figures = figures_test.Figures("page.md", sentence, lambda sources: list(actual))
        return list(figures_test.compare(self.sources, figures, write))

    def test_right_figures_are_accepted(self):
        self.assertEqual(self.errors("1 234", "5"), [])

    def test_a_wrong_figure_is_an_error(self):
        self.assertEqual(self.errors("1 235", "5"), ["page.md: '1 234 legs, 5 faces' should be '1 235 legs, 5 faces'"])

    def test_a_missing_sentence_is_an_error(self):
        self.assertEqual(self.errors("5", sentence="{} edges"), ["page.md: no sentence '{} edges'"])

    def test_write_corrects_the_page(self):
        self.assertEqual(self.errors("9", "5", write=True), [])
        self.assertEqual(self.page.read_text(encoding="utf-8"), "It has 9 legs, 5 faces.\n")


class SeededTimes(unittest.TestCase):
    def test_the_hash_is_that_of_the_program(self):
        # As hash_test: MatchesKnownValues.
        self.assertEqual(seeded_times.hash_of([]), 0xCBF29CE484222325)
        self.assertEqual(seeded_times.hash_of([0]), 0xF8BB92C91B3F5CC0)
        self.assertEqual(seeded_times.hash_of([1, 2, 3]), 0xC07B167C3203D34)

    def test_there_is_a_time_for_each_of_the_first_levels(self):
        lines = seeded_times.text(ROOT).splitlines()
        self.assertEqual(len(lines), len(seeded_times.SHARES))
        for line in lines:
            self.assertRegex(line, r"^[0-9a-f]{16} \d+ \d+ 2026-01-01T12:00:00Z Ada$")


if __name__ == "__main__":
    sys.exit(unittest.main())
