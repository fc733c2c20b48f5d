#!/usr/bin/env python3
"""Tests that the compiler option of the target platon_integers_only refuses every calculation with a float.

usage: integers_only_test.py COMPILER. Code that only folds or copies a float, and `long double`, passes the compiler;
check_structure.py refuses their names and literals.
"""

import subprocess
import sys
import unittest

COMPILER = sys.argv.pop() if len(sys.argv) == 2 else "g++"

FLOATS = (
    "float f(float x) { return x; }",
    "int f(int x) { return static_cast<int>(x * 0.5); }",
    "bool f(int x) { return x / 3.0f > 1; }",
    "struct S { double d; }; void f(S& s, int x) { s.d = x; }",
    "#include <cmath>\nint f(int x) { return static_cast<int>(std::sqrt(x)); }",
)


def compiles(code):
    command = [COMPILER, "-std=c++20", "-O0", "-mgeneral-regs-only", "-S", "-x", "c++", "-o", "/dev/null", "-"]
    return subprocess.run(command, input=code, capture_output=True, text=True).returncode == 0


class IntegersOnly(unittest.TestCase):
    def test_floats_are_refused(self):
        for code in FLOATS:
            self.assertFalse(compiles(code), code)

    def test_integers_are_accepted(self):
        code = "#include <map>\n#include <string>\n#include <vector>\n__int128 f(__int128 x, long y) { return x / y; }"
        self.assertTrue(compiles(code))


if __name__ == "__main__":
    unittest.main()
