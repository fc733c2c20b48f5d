#!/usr/bin/env python3
"""Tests that check_counterparts.py sees a change of either side, and no other."""

import contextlib
import io
import shutil
import tempfile
import unittest
from pathlib import Path

import check_counterparts
from check_proof import ProofError

TABLE = "| C++ | in |\n|---|---|\n| `Box::grow` | `shared/box.cpp` | `grow`, `twice` | `box.v` | 000000 000000 |\n"
CPP = "void Box::grow(int by);\nvoid use() { box.grow(1); }\nint Box::grow(int by) const {\n  if (by) { return 2 * by; }  // a comment\n  return 0;\n}\n"
PROOF = "(* Definition grow. *)\nDefinition grow (by : Z) := 2 * by.\nFixpoint twice n := n.\nTheorem grows : 1 = 1.\nTheorem grows_twice : 2 = 2.\n"


class CheckCounterparts(unittest.TestCase):
    def setUp(self):
        self.root = Path(tempfile.mkdtemp(prefix="platon-counterparts-"))
        self.addCleanup(shutil.rmtree, self.root)
        (self.root / "shared/proof").mkdir(parents=True)
        (self.root / "docs").mkdir()
        self.write("shared/proof/README.md", TABLE)
        for page in ("exactness", "proof"):
            self.write(f"docs/{page}.md", "It grows ([`grows`, `grows_twice`](../shared/proof/box.v)), see [`box.v`](../shared/proof/box.v).\n")
        self.write("shared/box.cpp", CPP)
        self.write("shared/proof/box.v", PROOF)
        check_counterparts.main([str(self.root), "--accept"])

    def write(self, name, text):
        (self.root / name).write_text(text, encoding="utf-8")

    def changes(self):
        return list(check_counterparts.changes(self.root, (self.root / check_counterparts.TABLE).read_text(encoding="utf-8")))

    def test_what_was_accepted_has_not_changed(self):
        self.assertEqual(self.changes(), [])
        with contextlib.redirect_stdout(io.StringIO()) as told:
            check_counterparts.main([str(self.root)])
        self.assertIn("1 definitions are as they were", told.getvalue())

    def test_comments_spaces_and_other_functions_do_not_count(self):
        self.write("shared/box.cpp", "int other() { return 3; }\n" + CPP.replace("// a comment", "// another").replace("  ", " "))
        self.write("shared/proof/box.v", PROOF.replace("2 * by", "2  *\n by") + "Definition other := 3.\n")
        self.assertEqual(self.changes(), [])

    def test_each_side_that_changes_is_named(self):
        self.write("shared/box.cpp", CPP.replace("2 * by", "3 * by"))
        self.assertEqual(len(self.changes()), 1)
        self.assertRegex(self.changes()[0], r"^Box::grow in shared/box\.cpp has changed: compare it with `grow`, `twice`")
        self.write("shared/proof/box.v", PROOF.replace(":= n", ":= n + n"))
        self.assertRegex(self.changes()[1], r"^`grow`, `twice` in shared/proof/box\.v has changed: compare it with Box::grow")
        with self.assertRaisesRegex(SystemExit, "has changed"):
            check_counterparts.main([str(self.root)])

    def test_a_type_and_a_constant_are_definitions(self):
        self.write("shared/proof/README.md", TABLE.replace("Box::grow", "Box"))
        self.write("shared/box.cpp", "struct Box;\nvoid use(Box box);\nstruct Box {\n  int low = 0;\n};\n")
        check_counterparts.main([str(self.root), "--accept"])
        self.write("shared/box.cpp", "struct Box {\n  long low = 0;\n};\n")
        self.assertEqual(len(self.changes()), 1)
        self.write("shared/proof/README.md", TABLE.replace("Box::grow", "kBox"))
        self.write("shared/box.cpp", "int use = kBox + 1;\nconstexpr int kBox = 3;\n")
        check_counterparts.main([str(self.root), "--accept"])
        for changed in ("constexpr int kBox = 4;", "constexpr long kBox = 3;"):
            self.write("shared/box.cpp", f"int use = kBox + 2;\n{changed}\n")
            self.assertEqual(len(self.changes()), 1, changed)

    def test_the_type_of_a_result_counts(self):
        self.write("shared/box.cpp", CPP.replace("int Box::grow", "long Box::grow"))
        self.assertEqual(len(self.changes()), 1)

    def test_what_is_gone_is_told(self):
        self.write("shared/box.cpp", CPP.replace("int Box::grow", "int Box::enlarge"))
        with self.assertRaisesRegex(ProofError, r"Box::grow in shared/box\.cpp is not defined: mend the table"):
            self.changes()
        self.write("shared/box.cpp", CPP)
        self.write("shared/proof/box.v", PROOF.replace("twice", "once"))
        with self.assertRaisesRegex(ProofError, r"twice in box\.v is not defined"):
            self.changes()

    def test_a_theorem_that_a_page_names_exists(self):
        self.assertEqual(list(check_counterparts.unknown_theorems(self.root)), [])
        self.write("docs/proof.md", "It shrinks ([`shrinks`](../shared/proof/box.v)).\n")
        self.write("shared/proof/README.md", TABLE + "| `box.v` | it grows (`grows_twice`, `grows_thrice`), see `Box` | `Box::grow` |\n")
        self.assertEqual(
            list(check_counterparts.unknown_theorems(self.root)),
            [
                "docs/proof.md: shrinks is no theorem of shared/proof/box.v: mend the page",
                "shared/proof/README.md: grows_thrice is no theorem of shared/proof/box.v: mend the page",
            ],
        )


if __name__ == "__main__":
    unittest.main()
