#!/usr/bin/env python3
"""Tests each structure check on a tree with one violation, and on code that only resembles one."""

import re
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

import check_functions
import check_globals
import source_text
from check_structure import check_tree
from dependency_table import DependencyTable, TableError
from unit_tests import check_registered, check_units

ARCHITECTURE = (Path(__file__).parents[2] / "docs/architecture.md").read_text(encoding="utf-8")

SHARED = ["exact", "physics", "game"]
LEVELS = ["check", "drawing", "picture", "reach", "solve", "tool"]
CLIENT = ["time", "job", "net", "netcode", "desync", "session", "bot", "demo", "quality", "scene", "ui", "hud", "audio", "menu", "menu/pages", "lobby", "editor", "replay", "files", "gl", "play"]
FOLDERS = (
    [f"shared/include/platon/{name}" for name in SHARED]
    + [f"shared/{name}" for name in SHARED]
    + ["shared/examples", "protocol", "protocol/files", "protocol/transport", "server/match", "server/net", "server/base", "server/admin", "server/fleet", "server/service", "server/times", "server/app"]
    + [f"levels/{name}" for name in LEVELS]
    + [f"client/{name}" for name in CLIENT]
    + ["levels", "tests"]
)


class Tree(unittest.TestCase):
    """A temporary tree with the real docs/architecture.md and one header in every folder."""

    def setUp(self):
        self.root = Path(tempfile.mkdtemp(prefix="platon-structure-"))
        self.addCleanup(shutil.rmtree, self.root)
        self.write("docs/architecture.md", ARCHITECTURE)
        for folder in FOLDERS:
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
    def test_every_pair_of_folders(self):
        public = [f"shared/include/platon/{name}" for name in SHARED]
        rooms = {
            "time": [], "job": [], "net": ["time"], "netcode": ["time"], "desync": [],
            "session": ["time", "net", "netcode", "desync"],
            "bot": ["time", "net", "netcode", "desync", "session"],
            "demo": ["netcode"], "quality": ["time"], "scene": ["netcode"], "ui": ["netcode", "quality", "scene"],
            "hud": ["netcode", "scene", "ui"],
            "gl": ["job", "quality", "scene", "ui", "hud"],
            "audio": ["job", "scene"],
            "menu": ["netcode", "scene", "ui"],
            "menu/pages": ["netcode", "quality", "scene", "ui", "menu"],
            "lobby": ["time", "job", "net", "netcode", "scene", "ui", "menu", "menu/pages"],
            "editor": ["netcode", "scene", "ui", "menu", "menu/pages"],
            "replay": ["job", "netcode", "scene", "ui"],
            "files": ["time", "net", "netcode", "desync", "session", "scene", "ui"],
            "play": [name for name in CLIENT if name not in ("bot", "play")],
        }  # fmt: skip
        drawn = ("scene", "ui", "hud", "audio", "menu", "menu/pages", "editor")
        solving = ["levels/check", "levels/reach", "levels/solve"]
        wordless = ("demo", "scene", "ui", "hud", "audio", "menu", "menu/pages", "editor", "gl")
        protocol = ["protocol", "protocol/files", "protocol/transport"]
        allowed = {
            **{folder: public[:index] for index, folder in enumerate(public)},
            "shared/exact": public[:1],
            "shared/physics": public[:2] + ["shared/exact"],
            "shared/game": public + ["shared/exact", "shared/physics"],
            "shared/examples": public,
            **{"protocol": public, "protocol/files": []},
            "protocol/transport": ["protocol", "protocol/files"],
            "server/match": public + protocol,
            "server/net": public + protocol + ["server/match"],
            "server/base": ["protocol/files"],
            "server/admin": public + protocol + ["server/match", "server/net", "server/base"],
            **{"server/fleet": protocol + ["server/net", "server/admin"], "server/service": protocol + ["server/net"]},
            "server/times": public + protocol + ["server/match", "server/base"],
            "server/app": public + protocol + ["server/match", "server/net", "server/base", "server/admin", "server/fleet", "server/service", "server/times"],
            **{
                f"client/{room}": public
                + ([] if room in wordless else protocol)
                + (["levels/drawing"] if room in drawn else [])
                + (solving if room == "editor" else [])
                + [f"client/{o}" for o in others]
                for room, others in rooms.items()
            },
            "levels/drawing": public,
            "levels/picture": public + ["levels/drawing"],
            "levels/reach": public,
            "levels/check": public + ["levels/reach"],
            "levels/solve": public,
            "levels/tool": public + ["levels/check", "levels/picture", "levels/reach", "levels/solve"],
            "levels": [],
            "tests": FOLDERS,
        }
        self.assertEqual(sorted(allowed), sorted(FOLDERS))
        for source in FOLDERS:
            for target in FOLDERS:
                header = f"{target.removeprefix('shared/include/')}/thing.h"
                text = f'\n#include "{header}"\n'
                if target == source or target in allowed[source]:
                    self.assert_allowed(f"{source}/file.cpp", text)
                else:
                    self.assert_refused(f"{source}/file.cpp", text, 2, f"may not include {header}")

    def test_only_the_embedded_server_includes_both_sides(self):
        text = '#include "server/app/thing.h"\n'
        self.assert_allowed("client/play/match/embedded_server.cpp", text)
        self.assert_allowed("client/play/main.cpp", text)
        self.assert_refused("client/play/main_menu.cpp", text, 1, "server/app/thing.h")
        self.assert_refused("server/app/main.cpp", '#include "client/play/thing.h"\n', 1, "client/play/thing.h")

    def test_includes_name_existing_files_from_the_root(self):
        self.assert_refused("server/app/file.cpp", '#include "thing.h"\n', 1, "thing.h")
        self.assert_refused("server/app/file.cpp", '#include "../shared/exact/thing.h"\n', 1, "../shared")
        self.assert_refused("server/app/file.cpp", '#include "server/app/lost.h"\n', 1, "does not exist")
        self.assert_refused("server/app/file.cpp", "#include <client/play/thing.h>\n", 1, "client/play/thing.h")
        self.assert_allowed("protocol/file.cpp", '#include "to_server_generated.h"\n')
        self.assert_refused("server/app/file.cpp", '#include "to_server_generated.h"\n', 1, "to_server_generated.h")

    def test_outside_headers_have_their_files(self):
        self.assert_allowed("server/net/host.cpp", "#include <enet/enet.h>\n")
        self.assert_refused("server/match/match.cpp", "#include <enet/enet.h>\n", 1, "enet/enet.h")
        self.assert_refused("server/match/match.cpp", "#include <sys/socket.h>\n", 1, "sys/socket.h")
        self.assert_refused("server/match/match.cpp", "  #  include <GL/glew.h>\n", 1, "GL/glew.h")
        self.assert_refused("protocol/file.cpp", '#include "sys/socket.h"\n', 1, "sys/socket.h")
        self.assert_refused("client/play/file.cpp", "#include <unheard_of.h>\n", 1, "unheard_of.h")
        self.assert_allowed("tests/file.cpp", "#include <gtest/gtest.h>\n")
        self.assert_allowed("client/play/file.cpp", "#include <vector>\n#include <chrono>\n")

    def test_only_gl_calls_opengl(self):
        for header in ("GL/glew.h", "GLFW/glfw3.h", "EGL/egl.h"):
            self.assert_allowed("client/gl/file.cpp", f"#include <{header}>\n")
            for room in ("scene", "ui", "play", "bot"):
                self.assert_refused(f"client/{room}/file.cpp", f"#include <{header}>\n", 1, header)
        self.assert_allowed("client/ui/file.cpp", "#include <glm/vec2.hpp>\n")

    def test_comments_and_strings_include_nothing(self):
        self.assert_allowed("shared/exact/file.cpp", '// #include "server/app/thing.h"\n/*\n#include <iostream>\n*/\n')

    def test_folder_without_a_row(self):
        self.assert_refused("shared/utils/file.cpp", "\n", 1, "no row")


class Purity(Tree):
    def test_headers_of_shared(self):
        for header in ("iostream", "chrono", "random", "unordered_map", "unordered_set", "fstream", "sstream", "cmath",
                       "thread", "cstdio", "ctime", "filesystem", "spdlog/spdlog.h", "sodium.h"):  # fmt: skip
            self.assert_refused("shared/game/file.cpp", f"#include <{header}>\n", 1, header)
        self.assert_allowed("shared/game/file.cpp", "#include <charconv>\n#include <string>\n#include <map>\n")

    def test_words_of_shared(self):
        for word in ("float", "double", "std::hash<int>", "rand", "std::random_device", "std::unordered_map<int, int>",
                     "std::chrono", "printf", "std::cerr", "thread_local", "std::time", "1.5", "2.", "1e3", "1.f",
                     "0x1p3"):  # fmt: skip
            self.assert_refused("shared/physics/file.cpp", f"\n\nauto x = {word};\n", 3, word.partition("<")[0])

    def test_examples_are_programs(self):
        self.assert_allowed("shared/examples/file.cpp", "#include <cstdio>\ndouble x = 1.5;\nlong y = printf;\n")
        self.assert_refused("shared/examples_of_mine/file.cpp", "\n", 1, "no row")
        self.assert_refused("shared/examples/file.cpp", "#include <enet/enet.h>\n", 1, "enet/enet.h")

    def test_what_differs_between_machines(self):
        for statement, word in (
            ("long x = 1", "long"), ("unsigned long x = 1", "long"), ("auto x = std::uintptr_t{}", "uintptr_t"),
            ("auto x = reinterpret_cast<char*>(p)", "reinterpret_cast"), ("std::memcpy(&a, &b, 4)", "memcpy"),
            ("memset(&a, 0, 4)", "memset"), ("auto x = std::bit_cast<Point>(y)", "bit_cast"),
            ("auto x = std::this_thread::get_id()", "this_thread"), ("std::shuffle(a, b, c)", "shuffle"),
            ("std::partition(a, b, c)", "partition"), ("std::pop_heap(a, b)", "pop_heap"),
            ("std::priority_queue<int> x", "priority_queue"), ("auto x = typeid(y).name()", "typeid"),
            ("std::uniform_int_distribution<int> x", "uniform_int_distribution"), ("wchar_t x", "wchar_t"),
            ("auto x = __builtin_sqrt(y)", "__builtin_sqrt"), ("auto x = __atomic_load_n(p, 0)", "__atomic_load_n"),
        ):  # fmt: skip
            self.assert_refused("shared/physics/file.cpp", f"\n{statement};\n", 2, word)

    def test_layout_and_addresses(self):
        for member in ("std::uint32_t a : 3;", "  bool a : 1;", "unsigned a : 4, b : 4;", "Kind kind : 2;",
                       "const int a : kBits;", "char a:7{};"):  # fmt: skip
            self.assert_refused("shared/physics/file.h", f"#pragma once\n{member}\n", 2, "bit-field")
        for order in ("std::map<const Convex*, int> a;", "std::set<Entity*> a;", "std::set<int, std::less<int*>> a;",
                      "std::multimap<std::shared_ptr<Convex>, int> a;", "std::map<std::pair<int*, int>, int> a;",
                      "std::sort(a, b, std::less<const int*>());"):  # fmt: skip
            found = self.violations("shared/game/file.cpp", f"\n{order}\n")
            self.assertIn("shared/game/file.cpp:2: ", " ".join(found))
            self.assertIn("an order by address", " ".join(found), order)

    def test_order_by_value_is_allowed(self):
        self.assert_allowed(
            "shared/game/file.cpp",
            "std::map<std::pair<int, int>, const Convex*> a;\nstd::set<std::string, std::less<>> b;\n"
            "std::map<std::string, int> c; int* d = nullptr;\nswitch (x) {\n  case 1: return y;\n"
            "  case kOne: return {1, 2};\nenum class Side : int { kA };\nenum Way : int { kB };\nstruct C : D {};\n"
            "  default: z = x ? a : 1;\n}\nclass A : public B {};\nfor (const int i : values) {}\n"
            "public:\nA() : a_(1), b_{2} {}\nconst auto v = p ? q : 3;\n",
        )

    def test_sorts_that_leave_the_order_of_equal_elements_open(self):
        for name in ("sort", "partial_sort", "nth_element"):
            self.assert_refused("shared/game/file.cpp", f"\nstd::{name}(a, b);\n", 2, f"std::{name}")
        self.assert_allowed("shared/game/file.cpp", "std::stable_sort(a, b);\nauto x = sort(a);\n")
        self.assert_allowed("shared/physics/grid.cpp", "std::sort(a, b);\n")
        self.assert_allowed("server/app/file.cpp", "std::sort(a, b);\n")

    def test_algorithms_that_wasm32_lacks(self):
        self.assert_refused("shared/physics/grid.cpp", "\nstd::ranges::find(a, b);\n", 2, "std::ranges::")
        self.assert_allowed("server/app/file.cpp", "std::ranges::find(a, b);\n")

    def test_names_that_look_impure_but_are_not(self):
        self.assert_allowed(
            "shared/game/file.cpp",
            "// float\n/* double\n 1.5 */ auto s = \"std::hash 1.5 // \" + std::string(R\"(double\n\")\");\n"
            "auto h = world.hash(); auto c = round.clock; auto t = time; auto n = 1'000 + 0x1e5 + a.b1 + v[0].x;\n"
            "char q = '\"'; auto floatless = doubled;\n",
        )

    def test_code_after_a_tricky_literal_is_still_read(self):
        for literal in ("'\"'", "'\\''", '"\\\\"', '"/*"', 'R"x(")x"', "1'000'000", "u8\"//\""):
            self.assert_refused("shared/game/file.cpp", f"auto a = {literal}; double b;\n", 1, "double")

    def test_clocks_outside_the_thin_files(self):
        text = "auto now = std::chrono::steady_clock::now();\n"
        self.assert_refused("server/match/match.cpp", text, 1, "clock::now")
        self.assert_refused("protocol/file.cpp", text, 1, "clock::now")
        self.assert_refused("client/play/file.cpp", "std::this_thread::sleep_for(pause);\n", 1, "sleep_for")
        self.assert_allowed("server/app/server_program.cpp", text)
        self.assert_allowed("server/match/match.cpp", 'auto s = "clock::now"; auto r = R"(clock::now)";  // clock::now\n')
        self.assert_allowed("server/match/match.cpp", "void advance(std::chrono::steady_clock::time_point now);\n")


class Form(Tree):
    def test_long_file(self):
        self.assert_allowed("levels/file.cpp", "\n" * 400)
        self.assert_refused("levels/file.cpp", "\n" * 401, 401, "401 lines")
        self.assert_refused("tests/CMakeLists.txt", "\n" * 401, 401, "401 lines")

    def test_leftovers(self):
        for word in ("TO" "DO", "FIX" "ME", "XX" "X", "HA" "CK"):
            for path, text in (("client/play/file.cpp", f"// {word}: later\n"), ("docs/page.md", f"{word}\n")):
                self.assert_refused(path, text, 1, word)
        self.assert_allowed("client/play/file.cpp", "// TO" "DOS\n")

    def test_machine_paths(self):
        for path in ("/ho" "me/somebody/x", "/wo" "rk/main", "/ro" "ot/.cache"):
            self.assert_refused("client/play/file.cpp", f'auto path = "{path}";\n', 1, "path of one machine")
        self.assert_allowed("docs/page.md", "See levels/root/a and /etc/platon/server.toml and https://a.org/home/x\n")

    def test_headers_and_names(self):
        for file, why in (("file.h", "pragma once"), ("FileName.cpp", "snake_case"), ("a_test.cpp", "platon::a_test")):
            self.assert_refused(f"client/play/{file}", "// #pragma once\n", 1, why)

    def test_full_folders(self):
        for index in range(39):  # with the header of the folder 40 files
            self.write(f"client/play/file_{index}.cpp", "\n")
        self.assertEqual(list(check_tree(self.root)), [])
        self.write("client/play/one_more.cpp", "\n")
        self.assertEqual(list(check_tree(self.root)), ["client/play:1: 41 files, more than 40"])

    def test_top_level(self):
        self.write("extra/file.txt", "\n")
        found = list(check_tree(self.root))
        self.assertEqual(len(found), 1, found)
        self.assertTrue(found[0].startswith("extra:1: "), found)


class Tables(Tree):
    def test_the_table_decides(self):
        text = '#include "protocol/thing.h"\n'
        self.assert_refused("levels/tool/file.cpp", text, 1, "protocol/thing.h")
        row = "| `levels/tool` | `platon-level`: its commands | `platon` `levels/check`"
        self.assertIn(row, ARCHITECTURE)
        self.write("docs/architecture.md", ARCHITECTURE.replace(row, row + " `protocol`"))
        self.assert_allowed("levels/tool/file.cpp", text)

    def test_rows_go_one_way(self):
        for cell in ("`platon` `server/app`", "`platon` `server`", "`client/time`"):
            page, changes = re.subn(r"^(\| `protocol` \|[^|]*\|) `platon` \|", rf"\1 {cell} |", ARCHITECTURE, flags=re.MULTILINE)
            self.assertEqual(changes, 1)
            with self.assertRaisesRegex(TableError, "protocol may include .*, whose row comes later"):
                DependencyTable(page)

    def test_row_without_a_folder(self):
        shutil.rmtree(self.root / "server/base")
        found = list(check_tree(self.root))
        self.assertEqual(len(found), 1, found)
        self.assertIn("server/base", found[0])

    def test_missing_or_broken_table(self):
        for name in ("folders", "headers", "words"):
            with self.assertRaisesRegex(TableError, name):
                DependencyTable(ARCHITECTURE.replace(f"<!-- table: {name} -->", ""))
        with self.assertRaisesRegex(TableError, "cells"):
            DependencyTable(ARCHITECTURE.replace("| `toml++/` | `server/app/config_file.cpp` |", "| `toml++/` |"))


class Functions(Tree):
    def test_lengths(self):
        ctags = shutil.which("ctags-universal") or shutil.which("ctags")
        if ctags is None:
            self.skipTest("universal-ctags is not installed")
        for lines in (80, 81):
            self.write("client/play/file.cpp", "int f() {\n" + "  g();\n" * (lines - 2) + "}\nint h() { return 1; }\n")
            functions = check_functions.function_lengths(ctags, self.root)
            self.assertEqual([(f[0], f[2], f[3]) for f in functions], [(lines, "f", 1), (1, "h", lines + 1)])
            over = [v for v in check_functions.violations(functions) if "more than 80" in v]
            self.assertEqual(len(over), lines - 80, over)

    def test_percentiles(self):
        self.assertEqual(check_functions.percentile([1, 2, 3, 4], 50), 2)
        self.assertEqual(check_functions.percentile(range(1, 101), 95), 95)
        self.assertEqual(check_functions.percentile([7], 95), 7)
        short = [(1, "client/play/a.cpp", "f", 1)] * 100
        self.assertEqual(list(check_functions.violations(short)), [])
        self.assertEqual(len(list(check_functions.violations([(9, "client/play/a.cpp", "f", 1)] * 100))), 1)
        self.assertEqual(len(list(check_functions.violations(short + [(41, "client/play/a.cpp", "f", 1)] * 10))), 1)
        self.assertEqual(len(list(check_functions.violations([(1, "tests/a.cpp", "f", 1)]))), 1)


class Units(unittest.TestCase):
    def test_every_unit_has_a_test(self):
        paths = ["server/app/log.cpp", "server/app/log.h", "tests/server/app/log_test.cpp", "tests/support/helper.cpp"]
        self.assertEqual(list(check_units(paths, {})), [])
        found = list(check_units([*paths, "levels/tool/main.cpp"], {}))
        self.assertEqual(len(found), 1)
        self.assertTrue(found[0].startswith("levels/tool/main.cpp:1: no test file is called main_test.cpp"), found)

    def test_exceptions(self):
        self.assertEqual(list(check_units(["server/app/main.cpp"], {"server/app/main.cpp": "reason"})), [])

    def test_needless_exceptions_are_refused(self):
        tested = ["server/app/log.cpp", "tests/server/app/log_test.cpp"]
        self.assertRegex(next(check_units(tested, {"server/app/log.cpp": "reason"})), "^server/app/log.cpp:1: it has a test")
        self.assertRegex(next(check_units([], {"server/app/log.cpp": "reason"})), "^server/app/log.cpp:1: it does not exist")


class Registered(unittest.TestCase):
    TEST = "tests/server/match/match_test.cpp"

    def refused(self, **builds):
        files = {f"{folder.replace('_', '/')}/CMakeLists.txt": text for folder, text in builds.items()}
        return list(check_registered({self.TEST: "", **files}))

    def test_a_folder_above_may_name_a_test(self):
        for folder, name in (("tests_server_match", "match_test.cpp"), ("tests_server", "match/match_test.cpp")):
            for text in (f"platon_tests(SOURCES {name})", f"set(sources\n  a_test.cpp\n  {name}\n)"):
                self.assertEqual(self.refused(**{folder: text}), [])

    def test_a_test_that_is_never_built_is_refused(self):
        for text in ("", "# match/match_test.cpp", "match/match_test.cpp.in", "other/match/match_test.cpp", "match_test.cpp",
                     "match/rematch_test.cpp", "match/match_test"):  # fmt: skip
            found = self.refused(tests_server=text, tests_client="match/match_test.cpp match_test.cpp")
            self.assertEqual(len(found), 1, text)
            self.assertTrue(found[0].startswith(f"{self.TEST}:1: no CMakeLists.txt names it"), found)


class Globals(unittest.TestCase):
    def test_writable_sections(self):
        dump = (
            "0000000000000000 l    d  .data\t0000000000000000 .data\n"
            "0000000000000040 l     O .bss\t0000000000000004 f()::calls\n"
            "0000000000000000 g       .tdata\t0000000000000004 perThread\n"
            "0000000000000000 u     O .data.w\t0000000000000004 w\n"
            "0000000000000000  w    O .data.rel.ro._ZTV1W\t0000000000000028 vtable for W\n"
            "0000000000000000 g     O .rodata\t0000000000000008 table\n"
        )
        self.assertEqual([name for _, name in check_globals.writable_objects(dump)], ["f()::calls", "perThread", "w"])


class SourceText(unittest.TestCase):
    def test_blanks_keep_lines_and_columns(self):
        text = 'int a; // b\nauto s = "c\\"d"; /* e\nf */ g\n'
        code = source_text.code_of(text)
        self.assertEqual(len(code), len(text))
        self.assertEqual(code.split(), ["int", "a;", "auto", "s", "=", ";", "g"])
        self.assertEqual(code.count("\n"), 3)


if __name__ == "__main__":
    sys.exit(unittest.main())
