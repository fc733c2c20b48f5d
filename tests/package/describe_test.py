#!/usr/bin/env python3
"""Tests the man pages and completions that deploy/describe makes of what the programs print for --help.

usage: describe_test.py ROOT BIN
"""

import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT, BIN = Path(sys.argv[1]), Path(sys.argv[2])
sys.path.insert(0, str(ROOT / "deploy/describe"))

import completions  # noqa: E402
from help_text import parse, read_help, version_of  # noqa: E402
from man_page import FILES, PROGRAMS, man_page  # noqa: E402

PAGE = """Does what it can. And more.
Usage: thing [OPTIONS] FILE

Positionals:
  FILE TEXT REQUIRED          A file

Options:
  -h,--help                   Print this help message and exit
  -o,--output FILE REQUIRED   Where to; it isn't read
  --chat on|off               Talk: "on"
  --width INT:INT in [160 - 8192]=1600
                              Width, in pixels


Other things:
  --long-name FLOAT Excludes: --chat
                              .5 of it
"""


class Parts(unittest.TestCase):
    def setUp(self):
        self.page = parse("thing", PAGE)
        self.options = {entry.long: entry for entry in self.page.options()}

    def test_a_page_has_its_parts(self):
        self.assertEqual(self.page.summary, "Does what it can. And more.")
        self.assertEqual(self.page.usage, "thing [OPTIONS] FILE")
        self.assertEqual(list(self.page.groups), ["Positionals", "Options", "Other things"])
        self.assertEqual(list(self.options), ["--help", "--output", "--chat", "--width", "--long-name"])

    def test_an_option_has_its_parts(self):
        output = self.options["--output"]
        self.assertEqual((output.short, output.value, output.text), ("-o", "FILE", "Where to; it isn't read"))
        self.assertEqual((self.options["--help"].short, self.options["--help"].value), ("-h", ""))
        self.assertEqual((self.options["--width"].value, self.options["--width"].text), ("INT", "Width, in pixels"))
        self.assertEqual((self.options["--long-name"].value, self.options["--long-name"].text), ("FLOAT", ".5 of it"))

    def test_another_form_is_kept(self):
        page = parse("thing", "thing: does it.\n\n  thing run\n")
        self.assertEqual((page.summary, page.verbatim, page.options()), ("does it.", "  thing run", []))

    def test_a_man_page_names_everything(self):
        page = man_page(self.page, "1", "0.1.0", "/usr/share/doc/platon/docs")
        self.assertIn("thing \\- Does what it can\n", page)
        self.assertIn(".B \\-o,\\-\\-output FILE REQUIRED\nWhere to; it isn't read\n", page)
        self.assertIn("\n\\&.5 of it\n", page)
        self.assertIn(".SH ARGUMENTS\n.TP\n.B FILE\nA file\n", page)
        self.assertIn(".SH OTHER THINGS\n", page)

    def test_a_man_page_names_files_and_the_other_pages(self):
        page = parse("platon-server", PAGE.replace("thing", "platon-server"))
        man = man_page(page, "8", "0.1.0", "/usr/share/doc/platon/docs")
        for path, _ in FILES["platon-server"]:
            self.assertIn(".SH FILES\n", man)
            self.assertIn(f".B {path}\n", man)
        self.assertIn(".SH SEE ALSO\n.BR platon\\-client (6),\n.BR platon\\-level (1),\n", man)
        self.assertNotIn(".BR platon\\-server (8)", man)
        self.assertIn("\n.BR /usr/share/doc/platon/docs .\n", man)

    def test_sections_are_those_that_are_installed(self):
        text = (ROOT / "deploy/install.cmake").read_text(encoding="utf-8")
        installed = dict(re.findall(r"platon_install_program\((platon-\w+) COMPONENT \w+ SECTION (\d)", text))
        for tool in re.search(r"foreach\(tool (.*)\)", text)[1].split():
            installed[f"platon-{tool}"] = "1"
        self.assertEqual(PROGRAMS, installed)

    def test_completions_quote_texts(self):
        self.assertIn("'--output[Where to; it isn'\\''t read]:FILE:_files'", completions.zsh(self.page))
        self.assertIn("-l output -s o -r -d 'Where to; it isn\\'t read'", completions.fish(self.page))
        self.assertIn("--chat) words='on off' ;;", completions.bash(self.page))


class Programs(unittest.TestCase):
    def test_every_option_is_described_and_completed(self):
        for name in PROGRAMS:
            page = read_help(BIN / name, name)
            man = man_page(page, "1", version_of(BIN / name), "/usr/share/doc/platon/docs")
            options = [entry for one in (page, *page.commands) for entry in one.options()]
            self.assertTrue(options or page.verbatim, name)
            for entry in options:
                self.assertIn(entry.long.replace("-", "\\-"), man, name)
                self.assertNotEqual(entry.text, "", f"{name} {entry.long}")
                self.assertIn(entry.long, completions.bash(page))
                self.assertIn(f"'{entry.long}[", completions.zsh(page))
                self.assertIn(f" -l {entry.long[2:]} ", completions.fish(page))

    def test_options_for_files_complete_files(self):
        page = read_help(BIN / "platon-client", "platon-client")
        values = {entry.long: entry.value for entry in page.options()}
        for option in ("--level", "--password-file", "--screenshot", "--replay", "--edit"):
            self.assertEqual(values[option], "FILE", option)

    def complete(self, name, *words):
        script = completions.bash(read_help(BIN / name, name))
        line = " ".join(f"'{word}'" for word in (name, *words))
        script += f'COMP_WORDS=({line}) COMP_CWORD={len(words)}\n_{name.replace("-", "_")}\nprintf "%s\\n" "${{COMPREPLY[@]}}"'
        return subprocess.run(["bash", "-c", script], stdout=subprocess.PIPE, text=True, check=True).stdout.split()

    def test_bash_completes(self):
        self.assertEqual(self.complete("platon-server", "--max-p"), ["--max-players", "--max-per-address"])
        self.assertEqual(self.complete("platon-server", "--chat", ""), ["on", "off"])
        self.assertEqual(self.complete("platon-level", "s"), ["solve"])
        self.assertEqual(self.complete("platon-level", "preview", "--w"), ["--width"])

    def test_shells_accept_the_completions(self):
        for shell, script in (("bash", completions.bash), ("zsh", completions.zsh), ("fish", completions.fish)):
            with self.subTest(shell):
                self.check_completions(shell, script)

    def check_completions(self, shell, script):
        if not shutil.which(shell):
            print(f"completions not checked: {shell} is not installed")
            self.skipTest("no shell")
        for name in PROGRAMS:
            text = script(read_help(BIN / name, name))
            result = subprocess.run([shell, "-n"], input=text, capture_output=True, text=True)
            self.assertEqual((result.returncode, result.stderr), (0, ""), name)

    def test_man_accepts_the_pages(self):
        if not shutil.which("groff"):
            self.skipTest("groff is not installed")
        folder = Path(tempfile.mkdtemp(prefix="platon-man-"))
        self.addCleanup(shutil.rmtree, folder)
        for name in PROGRAMS:
            page = folder / f"{name}.1"
            page.write_text(man_page(read_help(BIN / name, name), "1", "0.1.0", "/usr/share/doc/platon/docs"), encoding="utf-8")
            result = subprocess.run(["groff", "-man", "-ww", "-z", "-Tutf8", "-Kutf8", page], capture_output=True, text=True)
            self.assertEqual(re.sub(r".*can't break line.*\n", "", result.stderr), "", name)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
