#!/usr/bin/env python3
"""Tests that each structure check finds a violation in a small tree."""

import json
import os
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

import check_functions
import check_globals
from check_includes import PAGE, Plan, read_plan, with_table
from check_structure import check_tree
from unit_tests import check_registered, check_units

ARCHITECTURE = (Path(__file__).parents[2] / PAGE).read_text(encoding="utf-8")

# A part of the tree, and the files that need its links. {target: (beginnings, links, those that are PUBLIC)}
PARTS = {
    "platon_exact": (["shared/exact/", "shared/include/platon/exact/"], [], []),
    "platon_physics": (["shared/physics/", "shared/include/platon/physics/"], ["platon_exact"], ["platon_exact"]),
    "platon_game": (["shared/game/", "shared/include/platon/game/"], [], []),
    "platon_protocol": (["protocol/"], ["platon_physics", "PkgConfig::UTF8PROC"], ["platon_physics"]),
    "platon_server_app": (["server/app/"], ["platon_protocol"], ["platon_protocol"]),
    "platon_client_scene": (["client/scene/"], ["platon_exact"], ["platon_exact"]),
    "platon_client_play": (["client/play/"], ["platon_client_scene", "platon_server_app"], ["platon_client_scene"]),
}
FILES = {
    "shared/include/platon/exact/thing.h": "",
    "shared/include/platon/physics/thing.h": '#include "platon/exact/thing.h"\n',
    "shared/physics/private.h": "",
    "protocol/thing.h": '#include "platon/physics/thing.h"\n',
    "protocol/thing.cpp": "#include <utf8proc.h>\n#include <vector>\n",
    "server/app/thing.h": '#include "protocol/thing.h"\n',
    "client/scene/thing.h": '#include "platon/exact/thing.h"\n',
    "client/play/thing.h": '#include "client/scene/thing.h"\n',
    "client/play/match/embedded_server.cpp": '#include "server/app/thing.h"\n',
}


def plan_of(parts):
    rows = {part: {"platon_beginnings": row[0], "LINK_LIBRARIES": row[1], "INTERFACE_LINK_LIBRARIES": row[2]} for part, row in parts.items()}
    return {"parts": rows, "outside": {"utf8proc.h": "PkgConfig::UTF8PROC", "GL/": "platon_opengl"}}


class Tree(unittest.TestCase):
    """A temporary tree of a few folders with the words of the real docs/architecture.md."""

    def setUp(self):
        self.root = Path(tempfile.mkdtemp(prefix="platon-structure-"))
        self.addCleanup(shutil.rmtree, self.root)
        self.use(PARTS)
        for path, text in FILES.items():
            self.write(path, ("#pragma once\n" if path.endswith(".h") else "") + text)

    def use(self, parts):
        self.plan = Plan(plan_of(parts))
        self.write(PAGE, with_table(self.plan, ARCHITECTURE))

    def write(self, path, text):
        (self.root / path).parent.mkdir(parents=True, exist_ok=True)
        (self.root / path).write_text(text, encoding="utf-8")

    def violations(self, path, text):
        self.write(path, text)
        found = list(check_tree(self.root, self.plan))
        (self.root / path).unlink()
        return found

    def assert_refused(self, path, text, line, word):
        found = self.violations(path, text)
        self.assertEqual(len(found), 1, f"{path}: {text!r}: {found}")
        self.assertTrue(found[0].startswith(f"{path}:{line}: "), found[0])
        self.assertIn(word, found[0])

    def assert_allowed(self, path, text):
        self.assertEqual(self.violations(path, text), [], f"{path}: {text!r}")


class Choices(Tree):
    def test_a_member_that_nothing_obeys_is_named(self):
        parts = {**PARTS, "platon_client_ui": (["client/ui/"], [], []), "platon_client_quality": (["client/quality/"], [], [])}
        self.use(parts)
        self.write("client/ui/settings.h", "#pragma once\nstruct Settings {\n  int zoom = 1;\n  double lost;  ///< that nobody reads\n};\n")
        self.write("client/ui/settings.cpp", "int written(Settings s) { return s.zoom + s.lost; }\n")
        self.write("client/quality/quality.h", "#pragma once\nstruct Quality {\n  int samples;\n  static constexpr int kMost = 4;\n  bool fine;\n};\n")
        uses = "settings_.lost = 1; other.fine = sky.fine; /* settings.lost */ return settings().zoom + quality->samples;"
        found = self.violations("client/play/desk.cpp", f"int Desk::f() {{ {uses} }}\n")
        self.assertEqual(found, ["client/ui/settings.h:4: nothing obeys Settings::lost", "client/quality/quality.h:5: nothing obeys Quality::fine"])


class Includes(Tree):
    def test_a_file_includes_what_its_target_links(self):
        self.assert_allowed("client/play/file.cpp", '// #include "lost.h"\n#include "client/scene/thing.h"\n#include <chrono>\n')
        for path, header, target in (("client/scene/file.cpp", "protocol/thing.h", "platon_protocol"),
                                     ("server/app/file.cpp", "client/play/thing.h", "platon_client_play"),
                                     ("protocol/file.cpp", "platon/exact/thing.h", "platon_exact")):  # fmt: skip
            self.assert_refused(path, f'\n#include "{header}"\n', 2, f"does not link {target}, which has {header}")

    def test_libraries_from_outside_are_linked_too(self):
        self.assert_allowed("protocol/file.cpp", "#include <utf8proc.h>\n")
        self.assert_refused("client/scene/file.cpp", "  #  include <GL/glew.h>\n", 1, "does not link platon_opengl")
        self.assert_refused("client/play/file.cpp", "#include <unheard_of.h>\n", 1, "unheard_of.h is neither")

    def test_includes_name_existing_files_from_the_root(self):
        self.assert_refused("server/app/file.cpp", '#include "thing.h"\n', 1, "thing.h is neither")
        self.assert_refused("server/app/file.cpp", '#include "tests/thing.h"\n', 1, "tests/thing.h is neither")
        self.assert_refused("server/app/file.cpp", '#include "server/app/lost.h"\n', 1, "does not exist")

    def test_every_file_has_a_target(self):
        self.assert_refused("shared/utils/file.cpp", "\n", 1, "no target of CMake has this file")

    def test_headers_beside_the_sources_of_shared_are_private(self):
        self.assert_allowed("shared/physics/file.cpp", '#include "shared/physics/private.h"\n')
        self.assert_refused("protocol/file.cpp", '#include "shared/physics/private.h"\n', 1, "private to shared/")

    def test_of_the_client_only_the_embedded_server_includes_the_server(self):
        self.assert_refused("client/play/file.cpp", '#include "server/app/thing.h"\n', 1, "only the embedded server")


class Links(Tree):
    def assert_refused_link(self, part, links, public, word):
        self.use(PARTS | {part: (PARTS[part][0], [*PARTS[part][1], *links], [*PARTS[part][2], *public])})
        found = [line for line in check_tree(self.root, self.plan) if word in line]
        self.assertEqual(len(found), 1, word)
        self.assertTrue(found[0].startswith(f"{PARTS[part][0][0].split('/')[0]}/CMakeLists.txt:1: {part} "), found[0])

    def test_every_link_is_needed(self):
        self.assert_refused_link("platon_server_app", ["platon_exact"], [], "links platon_exact, of which it includes nothing")

    def test_public_is_what_headers_include(self):
        self.assert_refused_link("platon_protocol", [], ["PkgConfig::UTF8PROC"], "must link PkgConfig::UTF8PROC PRIVATE")
        self.use(PARTS)
        self.write("protocol/other.h", "#pragma once\n#include <utf8proc.h>\n")
        self.assertRegex("".join(check_tree(self.root, self.plan)), "platon_protocol must link PkgConfig::UTF8PROC PUBLIC: a header")

    def test_links_go_one_way(self):
        self.assert_refused_link("platon_client_scene", ["platon_client_play"], [], "links platon_client_play, which CMake defines later")
        for part, link, word in (("platon_physics", "platon_game", "physics may not use game"),
                                 ("platon_protocol", "platon_server_app", "protocol may not use server"),
                                 ("platon_server_app", "platon_client_scene", "server may not use client")):  # fmt: skip
            self.assert_refused_link(part, [link], [], word)


class Page(Tree):
    def test_its_table_is_that_of_the_links(self):
        page = with_table(self.plan, ARCHITECTURE)
        self.assert_refused(PAGE, page.replace("| `shared/exact` |", "| `shared/game` |"), 1, "not that of the links")
        self.assertIn("\n| `protocol` | message schemas", page)
        self.assertIn(" | `shared/physics` | PkgConfig::UTF8PROC | open a socket", page)

    def test_its_rows_say_what_the_files_hold(self):
        self.use(PARTS | {"platon_new": (["client/new/"], [], [])})
        self.assertRegex("".join(check_tree(self.root, self.plan)), "the row of `client/new` does not say what they hold")

    def test_the_plan_is_that_of_the_newest_build(self):
        with self.assertRaisesRegex(ValueError, "configure with"):
            read_plan(self.root)
        for build, parts, time in (("release", PARTS, 3), ("debug", {}, 2)):
            self.write(f"build/{build}/plan.json", json.dumps(plan_of(parts)))
            os.utime(self.root / f"build/{build}/plan.json", (time, time))
        self.write("CMakeLists.txt", "")
        with self.assertRaisesRegex(ValueError, "release/plan.json is older than .*/CMakeLists.txt: configure again"):
            read_plan(self.root)
        os.utime(self.root / "CMakeLists.txt", (1, 1))
        self.assertEqual(read_plan(self.root).links, self.plan.links)
        self.assertEqual(read_plan(self.root, self.root / "build/debug/plan.json").links, {})


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
        self.assert_refused("server/app/other.cpp", "auto now = std::chrono::steady_clock::now();\n", 1, "clock::now")
        self.assert_refused("client/play/thing.cpp", "std::jthread thread;\n", 1, "std::jthread")
        self.assert_refused("server/app/log.cpp", "spdlog::init_thread_pool(1, 1);\n", 1, "thread_pool")

    def test_threads_are_in_their_table(self):
        def owner(name):
            return f"class {name} {{\n  Worker<int> worker_;\n}};\n"

        head = "#pragma once\n"
        self.assert_allowed("client/play/replay_screen.h", head + owner("ReplayPlay"))
        self.assert_refused("client/play/hidden_work.h", head + owner("HiddenWork"), 3, "HiddenWork has a worker")
        self.assert_refused("client/play/work.h", head + owner("ReplayPlay") + owner("HiddenWork"), 6, "HiddenWork has")

    def test_code_after_a_tricky_literal_is_still_read(self):
        for literal in ("'\"'", '"\\\\"', '"/*"', 'R"x(")x"', "1'000'000"):
            self.assert_refused("shared/game/file.cpp", f"auto a = {literal}; double b;\n", 1, "double")


class Form(Tree):
    def test_long_file(self):
        self.assert_allowed("server/app/file.cpp", "\n" * 600)
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
        self.assertRegex("".join(check_tree(self.root, self.plan)), "^extra:1: ")


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
