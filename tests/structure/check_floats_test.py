#!/usr/bin/env python3
"""Tests that check_floats.py finds every calculation with a float. usage: check_floats_test.py COMPILER OBJDUMP"""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parent / "check_floats.py"
OBJDUMP = sys.argv.pop() if len(sys.argv) == 3 else "objdump"
COMPILER = sys.argv.pop() if len(sys.argv) == 2 else "g++"

FLOATS = (
    "float f(float x) { return x + 1; }",
    "int f(int x) { return static_cast<int>(x * 0.5); }",
    "bool f(int x) { return x / 3.0f > 1; }",
    "struct S { double d; }; void f(S& s, int x) { s.d = x; }",
    "int f(long double x) { return static_cast<int>(x); }",
    "bool f(double x, double y) { return x < y; }",
    "int f(__float128 x) { return static_cast<int>(x * 3); }",
    "#include <cstdlib>\ndouble f(const char* x) { return std::strtod(x, nullptr); }",
    "#include <cmath>\nfloat f(float x) { return std::pow(x, x); }",
    "#include <cmath>\nint f(int x) { return static_cast<int>(std::sqrt(x)); }",
    "float f(const float* x) { float sum = 0; for (int i = 0; i < 64; ++i) sum += x[i]; return sum; }",
)
INTEGERS = (
    "#include <map>\n#include <string>\n#include <vector>\n__int128 f(__int128 x, long y) { return x / y; }",
    "void f(int* x) { for (int i = 0; i < 64; ++i) x[i] = x[i] < 3 ? 3 : x[i] * 7; }",
    "struct S { double d; }; S f(const S& s) { return s; }",
)


class Floats(unittest.TestCase):
    def check(self, code, option="-O3"):
        with tempfile.TemporaryDirectory() as folder:
            built = Path(folder) / "code.o"
            command = [COMPILER, "-std=c++20", option, "-march=x86-64-v2", "-c", "-x", "c++", "-o", built, "-"]
            subprocess.run(command, input=code, check=True, text=True)
            return subprocess.run([sys.executable, "-B", SCRIPT, OBJDUMP, built], capture_output=True).returncode

    def test_floats_are_refused(self):
        for code in FLOATS:
            self.assertEqual(self.check(code), 1, code)
        self.assertEqual(self.check(FLOATS[0], "-O0"), 1)

    def test_integers_are_accepted(self):
        for code in INTEGERS:
            self.assertEqual(self.check(code), 0, code)
        self.assertEqual(self.check(INTEGERS[0], "-O0"), 0)

    def test_a_library_without_code_is_refused(self):
        self.assertEqual(self.check("extern int x;"), 1)


if __name__ == "__main__":
    unittest.main()
