#!/usr/bin/env python3
"""Tests that each structure check finds a violation in a small tree."""

import re
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

import check_functions
import check_globals
from check_structure import check_tree
from dependency_table import DependencyTable, TableError
from unit_tests import check_registered, check_units

ARCHITECTURE = (Path(__file__).parents[2] / "docs/architecture.md").read_text(encoding="utf-8")


class Tree(unittest.TestCase):
    """A temporary tree with the real docs/architecture.md and one header in every folder."""

    def setUp(self):
        self.root = Path(tempfile.mkdtemp(prefix="platon-structure-"))
        self.addCleanup(shutil.rmtree, self.root)
        self.write("docs/architecture.md", ARCHITECTURE)
        for folder in DependencyTable(ARCHITECTURE).folders():
            self.write(f"{folder}/thing.h", "#pragma once\n")

    def write(self, path, text):
        (self.root / path).parent.mkdir(parents=True, exist_ok=True)
        (self.root / path).write_text(text, encoding="utf-8")

    def violations(self, path, text):
        self.write(path, text)
        found = list(check_tree(self.root))
        (self.root / path).unlink()
        return found

    def assert_refused(self, path, text, line, word):
        found = self.violations(path, text)
        self.assertEqual(len(found), 1, f"{path}: {text!r}: {found}")
        self.assertTrue(found[0].startswith(f"{path}:{line}: "), found[0])
        self.assertIn(word, found[0])

    def assert_allowed(self, path, text):
        self.assertEqual(self.violations(path, text), [], f"{path}: {text!r}")


class Includes(Tree):
    def test_a_folder_includes_what_its_row_names(self):
        for folder, header in (("shared/game", "platon/physics"), ("protocol/transport", "protocol"), ("client/play", "server/app"),
                               ("client/scene", "levels/drawing"), ("tests", "client/gl"), ("server/net", "server/net")):  # fmt: skip
            path = f"{folder}/main.cpp"
            self.assert_allowed(path, f'// #include "lost.h"\n#include "{header}/thing.h"\n')
        for folder, header in (("shared/physics", "platon/game"), ("protocol", "server/match"), ("server/match", "server/net"),
                               ("server/app", "client/play"), ("client/scene", "protocol"), ("levels/check", "levels/tool")):  # fmt: skip
            path = f"{folder}/file.cpp"
            self.assert_refused(path, f'\n#include "{header}/thing.h"\n', 2, f"may not include {header}/thing.h")

    def test_includes_name_existing_files_from_the_root(self):
        self.assert_refused("server/app/file.cpp", '#include "thing.h"\n', 1, "thing.h")
        self.assert_refused("server/app/file.cpp", '#include "server/app/lost.h"\n', 1, "does not exist")

    def test_outside_headers_have_their_files(self):
        self.assert_allowed("client/gl/file.cpp", "#include <GL/glew.h>\n#include <chrono>\n")
        self.assert_refused("client/scene/file.cpp", "  #  include <GL/glew.h>\n", 1, "GL/glew.h")
        self.assert_refused("client/play/file.cpp", "#include <unheard_of.h>\n", 1, "unheard_of.h")

    def test_a_folder_without_a_row_is_refused(self):
        self.assert_refused("shared/utils/file.cpp", "\n", 1, "no row")


class Purity(Tree):
    def test_headers_and_words_of_shared(self):
        for header in ("iostream", "unordered_map", "spdlog/spdlog.h"):
            self.assert_refused("shared/game/file.cpp", f"#include <{header}>\n", 1, header)
        for word in ("double", "std::hash", "1.5", "1e3", "long", "reinterpret_cast", "std::shuffle", "__builtin_sqrt"):
            self.assert_refused("shared/physics/file.cpp", f"\n\nauto x = {word};\n", 3, word)
        self.assert_allowed("shared/examples/file.cpp", "#include <cstdio>\ndouble x = 1.5;\n")

    def test_layout_and_addresses(self):
        for member in ("std::uint32_t a : 3;", "Kind kind : kBits;"):
            self.assert_refused("shared/physics/file.h", f"#pragma once\n{member}\n", 2, "bit-field")
        for order in ("std::map<const Convex*, int> a;", "std::set<int, std::less<int*>> a;", "std::map<std::shared_ptr<A>, int> a;"):
            self.assertIn("an order by address", " ".join(self.violations("shared/game/file.cpp", order)), order)

    def test_words_of_a_few_files(self):
        self.assert_refused("shared/game/file.cpp", "\nstd::sort(a, b);\n", 2, "std::sort")
        self.assert_allowed("shared/physics/grid.cpp", "std::sort(a, b);\n")
        self.assert_refused("server/match/match.cpp", "auto now = std::chrono::steady_clock::now();\n", 1, "clock::now")
        self.assert_allowed("protocol/work/worker.cpp", "std::thread thread;\n")
        self.assert_refused("client/lobby/thing.cpp", "std::jthread thread;\n", 1, "std::jthread")
        self.assert_refused("server/app/log.cpp", "spdlog::init_thread_pool(1, 1);\n", 1, "thread_pool")

    def test_threads_are_in_their_table(self):
        member = "#pragma once\nWorker<int> worker_;\n"
        self.assert_allowed("client/lobby/name_lookup.h", member)
        self.assert_refused("client/lobby/hidden_work.h", member, 1, "HiddenWork has a worker")

    def test_code_after_a_tricky_literal_is_still_read(self):
        for literal in ("'\"'", '"\\\\"', '"/*"', 'R"x(")x"', "1'000'000"):
            self.assert_refused("shared/game/file.cpp", f"auto a = {literal}; double b;\n", 1, "double")


class Form(Tree):
    def test_long_file(self):
        self.assert_allowed("levels/tool/file.cpp", "\n" * 600)
        self.assert_refused("tests/CMakeLists.txt", "\n" * 601, 601, "601 lines")

    def test_leftovers_and_machine_paths(self):
        self.assert_refused("docs/page.md", "FIX" "ME\n", 1, "leftover")
        self.assert_refused("client/play/file.cpp", 'auto path = "/ho' 'me/somebody/x";\n', 1, "path of one machine")
        self.assert_allowed("docs/page.md", "TO" "DOS: levels/root/a and https://a.org/home/x\n")

    def test_headers_and_names(self):
        for file, why in (("file.h", "pragma once"), ("FileName.cpp", "snake_case"), ("a_test.cpp", "platon::a_test")):
            self.assert_refused(f"client/play/{file}", "// #pragma once\n", 1, why)

    def test_top_level(self):
        self.write("extra/file.txt", "\n")
        self.assertRegex("".join(check_tree(self.root)), "^extra:1: ")


class Tables(Tree):
    def test_rows_go_one_way(self):
        page, changes = re.subn(r"^(\| `protocol` \|[^|]*\|) `platon` \|", r"\1 `platon` `server/app` |", ARCHITECTURE, flags=re.MULTILINE)
        self.assertEqual(changes, 1)
        with self.assertRaisesRegex(TableError, "protocol may include server/app, whose row comes later"):
            DependencyTable(page)


class Functions(Tree):
    def test_lengths(self):
        ctags = shutil.which("ctags-universal") or shutil.which("ctags")
        if ctags is None:
            self.skipTest("universal-ctags is not installed")
        self.write("client/play/file.cpp", "int f() {\n" + "  g();\n" * 79 + "}\nint h() { return 1; }\n")
        functions = check_functions.function_lengths(ctags, self.root)
        self.assertEqual([(f[0], f[2], f[3]) for f in functions], [(81, "f", 1), (1, "h", 82)])
        self.assertIn("client/play/file.cpp:1: f has 81 lines, more than 80", list(check_functions.violations(functions)))

    def test_percentiles(self):
        short = [(8, "client/play/a.cpp", "f", 1)] * 100
        self.assertEqual(list(check_functions.violations(short)), [])
        self.assertEqual(len(list(check_functions.violations([(9, "client/play/a.cpp", "f", 1)] * 100))), 1)
        self.assertEqual(len(list(check_functions.violations(short + [(41, "client/play/a.cpp", "f", 1)] * 10))), 1)
        self.assertEqual(len(list(check_functions.violations([(1, "tests/a.cpp", "f", 1)]))), 1)


class Units(unittest.TestCase):
    def test_every_unit_has_a_test_or_an_exception(self):
        tested = ["server/app/log.cpp", "tests/server/app/log_test.cpp"]
        self.assertEqual(list(check_units(tested, {})), [])
        self.assertEqual(list(check_units(tested[:1], {tested[0]: "reason"})), [])
        self.assertRegex("".join(check_units(tested[:1], {})), "^server/app/log.cpp:1: no test file is called log_test.cpp")
        self.assertRegex("".join(check_units(tested, {tested[0]: "reason"})), "^server/app/log.cpp:1: it has a test")

    def test_every_test_is_built(self):
        test = "tests/server/match/match_test.cpp"
        for text in ("platon_tests(SOURCES match/match_test.cpp)", "set(sources\n  match/match_test.cpp\n)"):
            self.assertEqual(list(check_registered({test: "", "tests/server/CMakeLists.txt": text})), [])
        for text in ("", "# match/match_test.cpp", "match_test.cpp", "match/rematch_test.cpp"):
            found = "".join(check_registered({test: "", "tests/server/CMakeLists.txt": text}))
            self.assertRegex(found, f"^{test}:1: no CMakeLists.txt names it", text)


class Globals(unittest.TestCase):
    def test_writable_sections(self):
        dump = (
            "0000000000000000 l    d  .data\t0000000000000000 .data\n"
            "0000000000000040 l     O .bss\t0000000000000004 f()::calls\n"
            "0000000000000000 g       .tdata\t0000000000000004 perThread\n"
            "0000000000000000  w    O .data.rel.ro._ZTV1W\t0000000000000028 vtable for W\n"
            "0000000000000000 g     O .rodata\t0000000000000008 table\n"
        )
        self.assertEqual([name for _, name in check_globals.writable_objects(dump)], ["f()::calls", "perThread"])


if __name__ == "__main__":
    sys.exit(unittest.main())
