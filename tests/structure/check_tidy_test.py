#!/usr/bin/env python3
"""Tests which files check_tidy.py checks, in small git repositories, and how it adapts compile commands."""

import json
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import check_tidy


class Repository(unittest.TestCase):
    def setUp(self):
        self.root = Path(tempfile.mkdtemp(prefix="platon-tidy-"))
        self.addCleanup(shutil.rmtree, self.root)

    def git(self, *arguments):
        names = ["-c", "user.name=test", "-c", "user.email=test@localhost"]
        subprocess.run(["git", *names, *arguments], cwd=self.root, check=True, capture_output=True)

    def commit(self, *files):
        for file in files:
            (self.root / file).write_text(file, encoding="utf-8")
        self.git("add", "-A")
        self.git("commit", "-q", "-m", " ".join(files))
        return check_tidy.git(self.root, "rev-parse", "HEAD")

    def test_without_a_repository_it_is_skipped(self):
        with self.assertRaises(check_tidy.Skipped):
            check_tidy.base_of(self.root)

    def test_a_single_commit_is_skipped(self):
        self.git("init", "-q", "-b", "main")
        self.commit("a.cpp")
        with self.assertRaises(check_tidy.Skipped):
            check_tidy.base_of(self.root)

    def test_main_is_compared_with_its_previous_commit(self):
        self.git("init", "-q", "-b", "main")
        first = self.commit("a.cpp")
        self.commit("b.cpp")
        self.assertEqual(check_tidy.base_of(self.root), first)
        self.git("update-ref", "refs/remotes/origin/main", "HEAD")
        self.assertEqual(check_tidy.base_of(self.root), first)

    def test_a_branch_is_compared_with_its_merge_base(self):
        self.git("init", "-q", "-b", "main")
        base = self.commit("a.cpp")
        self.git("update-ref", "refs/remotes/origin/main", "HEAD")
        self.commit("b.cpp")
        self.commit("c.cpp")
        (self.root / "d.cpp").write_text("not committed", encoding="utf-8")
        self.assertEqual(check_tidy.base_of(self.root), base)
        self.assertEqual(check_tidy.changed_files(self.root, base), ["b.cpp", "c.cpp", "d.cpp"])


class Choice(unittest.TestCase):
    def test_headers_are_checked_through_their_sources(self):
        changed = ["shared/include/platon/game/game.h", "client/menu/menu.h", "client/menu/menu.cpp", "server/app/pacing.h", "README.md"]
        compiled = ["shared/game/game.cpp", "client/menu/menu.cpp", "client/hud/hud.cpp"]
        self.assertEqual(check_tidy.sources_of(changed, compiled), ["client/menu/menu.cpp", "shared/game/game.cpp"])

    def test_a_sample_is_evenly_spread(self):
        self.assertEqual(check_tidy.sample([1, 2, 3], 3), [1, 2, 3])
        self.assertEqual(check_tidy.sample(list(range(10)), 5), [0, 2, 4, 6, 8])

    def test_compile_commands_lose_what_only_gcc_understands(self):
        command = "env A=b ccache /usr/bin/c++ -O1 -flto=auto -Winvalid-pch -include /build/pch.hxx -Wno-restrict -c a.cpp"
        self.assertEqual(check_tidy.for_clang(command), "/usr/bin/c++ -O1 -c a.cpp")

    def test_files_compiled_together_have_a_command_each(self):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            together = root / "unity_0_cxx.cxx"
            together.write_text(f'/* by CMake */\n#include "{root}/a.cpp"\n\n#include "{root}/b.cpp"\n', encoding="utf-8")
            entry = {"directory": folder, "file": str(together), "command": f"c++ -O1 -c {together}"}
            (root / "compile_commands.json").write_text(json.dumps([entry]), encoding="utf-8")
            commands = check_tidy.compile_commands(root, root)
        self.assertEqual({path: entry["command"] for path, entry in commands.items()},
                         {name: f"c++ -O1 -c {root}/{name}" for name in ("a.cpp", "b.cpp")})  # fmt: skip


if __name__ == "__main__":
    sys.exit(unittest.main())
