#!/usr/bin/env python3
"""Tests that baseline.py finds the instructions of later machines, and no others.

usage: baseline_test.py
"""

import unittest

from baseline import later_in


def listing(*instructions):
    return "".join(f"  401{place:03x}:\t{each}\n" for place, each in enumerate(instructions))


class Baseline(unittest.TestCase):
    def test_later_instructions_are_found_once_and_in_order(self):
        later = listing("popcnt %rax,%rdx", "pshufb %xmm1,%xmm0", "pmulld %xmm1,%xmm0", "vpaddd %ymm1,%ymm0,%ymm0", "popcnt %rcx,%rdx")
        self.assertEqual(later_in(later), ["pmulld", "popcnt", "pshufb", "vpaddd"])

    def test_those_of_every_machine_are_not(self):
        every = listing("pshufd $0x4e,%xmm0,%xmm1", "pmuludq %xmm1,%xmm0", "movmskpd %xmm0,%eax", "tzcnt %rax,%rax", "bsr %rax,%rax",
                        "pextrw $0,%xmm0,%eax", "pinsrw $0,%eax,%xmm0", "pmaxub %xmm1,%xmm0", "pminsw %xmm1,%xmm0", "cmpxchg8b (%rdi)",
                        "sar %rax", "call 401000 <popcnt>")  # fmt: skip
        self.assertEqual(later_in(every), [])


if __name__ == "__main__":
    unittest.main()
