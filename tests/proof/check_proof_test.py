#!/usr/bin/env python3
"""Tests that check_proof.py accepts what is proved and nothing else."""

import shutil
import tempfile
import unittest
from pathlib import Path

import check_proof

BASE = "Definition one := 1.\nTheorem one_is_one : one = 1.\nProof. reflexivity. Qed.\n"
USER = "From Platon Require Import base.\nTheorem two : one + one = 2.\nProof. reflexivity. Qed.\n"


class CheckProof(unittest.TestCase):
    def setUp(self):
        folder = Path(tempfile.mkdtemp(prefix="platon-proof-"))
        self.addCleanup(shutil.rmtree, folder)
        self.source, self.work = folder / "source", folder / "work"
        self.source.mkdir()
        self.write("base", BASE)

    def write(self, name, text):
        (self.source / f"{name}.v").write_text(text, encoding="utf-8")

    def assert_refused(self, text, sentence):
        self.write("user", text)
        with self.assertRaisesRegex(check_proof.ProofError, sentence):
            check_proof.check(self.source, self.work)

    def test_what_is_proved_is_listed_in_the_order_of_its_files(self):
        self.write("a_user", USER)
        self.assertEqual(check_proof.check(self.source, self.work), [("base", "one_is_one"), ("a_user", "two")])

    def test_a_comment_is_no_proof(self):
        self.write("user", "(* Axiom: (* Admitted. *) *)\n" + USER)
        self.assertEqual(len(check_proof.check(self.source, self.work)), 2)

    def test_what_does_not_follow_is_refused(self):
        self.assert_refused(USER.replace("= 2", "= 3"), r"shared/proof/user\.v does not hold:")

    def test_what_is_not_proved_is_refused(self):
        self.assert_refused(USER.replace("Qed", "Admitted"), r"shared/proof/user\.v:3: 'Admitted' lets something unproved pass")
        self.assert_refused("Axiom a : 1 = 2.\n" + USER, r"user\.v:1: 'Axiom'")
        self.assert_refused("Hypothesis h : 1 = 2.\n" + USER, r"user\.v:1: 'Hypothesis'")

    def test_an_assumption_of_the_library_is_refused(self):
        text = "From Coq Require Import Classical.\nTheorem decided (P : Prop) : P \\/ ~ P.\nProof. apply classic. Qed.\n"
        self.assert_refused(text, r"a theorem rests on an assumption:\n(.*\n)*Axioms:")

    def test_files_that_require_each_other_are_refused(self):
        self.write("base", "From Platon Require Import user.\n" + BASE)
        self.assert_refused(USER, "shared/proof: base, user: these files require each other")


if __name__ == "__main__":
    unittest.main()
