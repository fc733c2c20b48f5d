#!/usr/bin/env python3
"""Tests where draw.py puts faults, that a seed repeats them, which of them are explained, and in which builds."""

import tempfile
import unittest
from pathlib import Path

import draw
from shared_build import BuildError, SharedBuild
from sites import Finder, changed_constants

FUNCTION = "void f() {{\n  {}\n}}\n"


def changes(text, operator=None):
    """(original, changed) of every site, one line each."""
    return [
        (draw.one_line(text[site.begin : site.end]), draw.one_line(site.replaced))
        for site in Finder(text).sites()
        if operator in (None, site.operator)
    ]


class Operators(unittest.TestCase):
    def assert_changes(self, statement, operator, *expected):
        self.assertEqual(changes(FUNCTION.format(statement), operator), list(expected), statement)

    def test_a_comparison_is_exchanged_with_its_neighbour(self):
        pairs = {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "=="}
        for original, changed in pairs.items():
            self.assert_changes(f"return a {original} b;", "comparison", (original, changed))

    def test_a_template_is_no_comparison(self):
        for statement in ("std::vector<int> v = g<B>(a);", "auto x = a <=> b;", "auto y = a >> b;", "auto z = std::get<E>(x);"):
            self.assert_changes(statement, "comparison")

    def test_logic_is_exchanged_but_no_reference(self):
        self.assert_changes("if (a && b || c) g(d);", "logic", ("&&", "||"), ("||", "&&"))
        self.assert_changes("auto&& x = g();", "logic")

    def test_sums_are_exchanged_but_no_signs(self):
        self.assert_changes("x = a + b - c;", "arithmetic", ("+", "-"), ("-", "+"))
        self.assert_changes("x += -a;", "arithmetic", ("+=", "-="))
        self.assert_changes("++x;", "arithmetic", ("++", "--"))

    def test_the_step_of_a_loop_stays(self):
        self.assert_changes("for (int i = a; i < n; ++i) g(h(x++));", "arithmetic", ("++", "--"))

    def test_a_constant_becomes_its_neighbours_and_zero(self):
        self.assertEqual(changed_constants("7"), ["8", "6", "0"])
        self.assertEqual(changed_constants("0"), ["1"])
        self.assertEqual(changed_constants("1u"), ["2u", "0u"])
        self.assertEqual(changed_constants("1'000'000"), ["1000001", "999999", "0"])
        self.assertEqual(changed_constants("0x10"), ["17", "15", "0"])
        self.assertEqual(changed_constants("0.5f"), ["1.5f", "0.0f"])
        self.assertEqual(changed_constants("20ms"), ["21ms", "19ms", "0ms"])
        self.assert_changes("return true;", "constant", ("true", "false"))
        self.assert_changes("x = uint8;", "constant")

    def test_a_condition_is_negated(self):
        self.assert_changes("if (a < b) g();", "negation", ("a < b", "!(a < b)"))
        self.assert_changes("while (next()) g();", "negation", ("next()", "!(next())"))
        self.assert_changes("if (int x = g(); x > y) g();", "negation", ("x > y", "!(x > y)"))
        self.assert_changes("if (const auto x = g()) g();", "negation")
        self.assert_changes("if constexpr (kA) g();", "negation")

    def test_assignments_and_unused_calls_are_dropped(self):
        for statement in ("x_ = a;", "x_.reset();", "a->b[i + j].clear();", "++x;", "x_ |= bit;", "*p = a;", "ns::g(a);",
                          "std::get<A>(x).g();", "a.b = [&](int c) { return c; };"):  # fmt: skip
            self.assert_changes(statement, "statement", (statement, ";"))
        self.assert_changes("if (a) x_.reset();", "statement", ("x_.reset();", ";"))
        self.assert_changes("for (A a : b) g(a);", "statement", ("g(a);", ";"))
        self.assert_changes("switch (a) {\n case A: g(); break;\n}", "statement", ("g();", ";"))

    def test_declarations_and_returns_are_not_dropped(self):
        for statement in ("int x = a;", "const A& x = g();", "A x(b);", "std::vector<A> v(b);", "return g();", "auto x = g();",
                          "A* x = g();", "std::optional<A> x;", "using namespace a;", "delete x;"):  # fmt: skip
            self.assert_changes(statement, "statement")

    def test_a_declaration_outside_a_function_is_no_statement(self):
        for text in ("class A {\n  A(int a);\n  A() = default;\n  int b = 0;\n};\n", "namespace a {\ng(b);\n}\n"):
            self.assertEqual(changes(text, "statement"), [])

    def test_statements_of_lambdas_and_members_are_found(self):
        self.assertEqual(changes("class A {\n  void g() { a_ = b; }\n};\n", "statement"), [("a_ = b;", ";")])
        self.assertEqual(changes("A::A(int a) : b_{a} {\n  g();\n}\n", "statement"), [("g();", ";")])
        self.assertEqual(
            changes("void f() {\n  const auto g = [&] { h(); };\n}\nauto k() -> int { l(); }\n", "statement"),
            [("h();", ";"), ("l();", ";")],
        )

    def test_checks_that_only_leave_are_dropped(self):
        for statement in ("if (a) return;", "if (a) continue;", "if (!b) throw C(d);", "if (a) { return b; }"):
            self.assert_changes(statement, "check", (statement, ";"))
        for statement in ("if (a) g();", "if (a) { g(); return; }", "if (a) return b; else g();"):
            self.assert_changes(statement, "check")

    def test_neighbouring_arguments_are_exchanged(self):
        self.assert_changes("x = g(a, h(b, c));", "arguments", ("a, h(b, c)", "h(b, c), a"), ("b, c", "c, b"))
        self.assert_changes("g<A>(a, b);", "arguments", ("a, b", "b, a"))
        self.assert_changes("g(A<b, c>(d), e);", "arguments", ("A<b, c>(d), e", "e, A<b, c>(d)"))

    def test_arguments_that_cannot_matter_or_matter_too_much_stay(self):
        for statement in ("x = std::min(a, b);", "g(a, a);", "sort(v.begin(), v.end());", "for (A a = b, c; d;) {}"):
            self.assert_changes(statement, "arguments")
        self.assertEqual(changes("void f(int a, int b);\nclass A { A(int a, int b); };\n", "arguments"), [])


class Skipped(unittest.TestCase):
    def test_text_that_is_no_code_has_no_fault(self):
        for text in ("// a < 1;\n", "/* if (a) return 1; */\n", "/// True for 1 + 1.\nint f();\n", '#include "a/1.h"\n',
                     "#define A 1\n", 'auto kA = "a < 1 && true";\n', 'auto kA = R"(x = 1;)";\n', "char kA = '1';\n",
                     "static_assert(1 < 2);\n", "using A = B<1>;\n", "namespace a {\n}\n"):  # fmt: skip
            self.assertEqual(changes(text), [], text)
        self.assertEqual(changes(FUNCTION.format("assert(a < 1);")), [])


class Seeds(unittest.TestCase):
    TEXTS = {f"{name}.cpp": FUNCTION.format("\n".join(f"x{i} = a + {i};" for i in range(100))) for name in "abc"}

    def drawn(self, seed):
        faults = draw.Faults(self.TEXTS, seed)
        return [fault for number in range(1, len(faults) + 1) for fault in faults.drawn(number)]

    def test_the_same_seed_draws_the_same(self):
        self.assertEqual(self.drawn(7), self.drawn(7))
        self.assertNotEqual(self.drawn(7), self.drawn(8))

    def test_no_line_is_drawn_twice(self):
        places = [(fault.file, fault.line) for fault in self.drawn(7)]
        self.assertGreater(len(places), 250)
        self.assertEqual(len(places), len(set(places)))

    def test_one_line_of_the_text_changes(self):
        for fault in self.drawn(7):
            lines = self.TEXTS[fault.file].splitlines()
            changed = fault.text.splitlines()
            self.assertEqual(lines[fault.line - 1].strip(), fault.original)
            self.assertEqual(changed[fault.line - 1].strip(), fault.changed)
            lines[fault.line - 1] = changed[fault.line - 1]
            self.assertEqual(lines, changed)


class Reports(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="platon-draw-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def test_explanations_are_read(self):
        path = self.folder / "equivalent.txt"
        path.write_text("# Why.\n\na.cpp\nx = 1;\n;\nnobody reads it\n\n\nb.cpp\ny\nz\nslower\n", encoding="utf-8")
        expected = {("a.cpp", "x = 1;", ";"): "nobody reads it", ("b.cpp", "y", "z"): "slower"}
        self.assertEqual(draw.explained(path), expected)
        path.write_text("a.cpp\nx = 1;\n;\n", encoding="utf-8")
        with self.assertRaises(ValueError):
            draw.explained(path)

    def test_every_explanation_fits_the_tree(self):
        root = Path(__file__).resolve().parents[2]
        for file, original, _ in draw.explained():
            self.assertIn(original, draw.one_line((root / file).read_text(encoding="utf-8")), file)

    def test_what_is_explained_counts_and_results_are_kept(self):
        file = self.folder / "results"
        report = draw.Report(7, {("a.cpp", "x", "y"): "why"}, file)
        for number, changed in enumerate("yz", 1):
            report.add(draw.Drawn(number, "a.cpp", 1, "constant", "x", changed, "text"), {"stage": "wide", "test": None}, 1)
        caught = {"stage": "narrow", "test": "a_test", "how": "fails"}
        report.add(draw.Drawn(3, "a.cpp", 1, "constant", "x", "z", "text"), caught, 1)
        rate, summary = report.rate([1, 2, 3])
        self.assertAlmostEqual(rate, 200 / 3)
        self.assertEqual(summary, "seed 7: 1 caught, 1 explained, 1 survived of 3 faults: 66.7 %")
        self.assertEqual(draw.Report(7, {}, file).results, report.results)
        self.assertEqual(draw.Report(8, {}, file).results, {})


class Builds(unittest.TestCase):
    def test_a_build_without_shared_libraries_is_refused(self):
        """Before, no fault changed a program of such a build, and all were said to survive."""
        with tempfile.TemporaryDirectory() as folder:
            rules = "rule link\n  command = c++ a.o -o $out\nbuild program: link\nbuild all: phony program\n"
            Path(folder, "build.ninja").write_text(rules, encoding="utf-8")
            with self.assertRaisesRegex(BuildError, "no shared libraries: give a build with the preset 'faults'"):
                SharedBuild(Path(folder), Path(folder))


if __name__ == "__main__":
    unittest.main(argv=[__file__], buffer=True)
