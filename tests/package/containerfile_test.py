#!/usr/bin/env python3
"""Tests how containerfile.py reads a Containerfile, and what deploy/Containerfile and .dockerignore say. container_test.py
builds and runs the container.

usage: containerfile_test.py ROOT
"""

import sys
import tempfile
import unittest
from pathlib import Path

from containerfile import ContainerfileError, copy, read, sent

ROOT = Path(sys.argv[1]).resolve()
IMAGE = read((ROOT / "deploy/Containerfile").read_text(encoding="utf-8"))
IGNORE = (ROOT / ".dockerignore").read_text(encoding="utf-8")


class Containerfile(unittest.TestCase):
    def test_steps_and_what_is_started_are_read(self):
        image = read('FROM base:1\n# No step.\nRUN a \\\n && b\nCOPY x y /z/\nUSER u\nEXPOSE 1/udp\nVOLUME ["/v"]\n'
                     'HEALTHCHECK --timeout=5s CMD ["h"]\nENTRYPOINT ["e"]\nCMD []\n')  # fmt: skip
        self.assertEqual((image.base, image.user, image.steps), ("base:1", "u", [("RUN", "a  && b"), ("COPY", "x y /z/")]))
        self.assertEqual((image.volumes, image.health, image.entrypoint, image.command), (["/v"], ["h"], ["e"], []))

    def test_what_is_not_known_is_refused(self):
        for line in ("ADD x y", "USER u\nRUN a", "COPY --chown=u x /y/", "ENV A=b", "CMD a", "HEALTHCHECK NONE"):
            with self.assertRaises(ContainerfileError, msg=line):
                read(f"FROM base\n{line}\n")

    def test_the_last_rule_that_fits_decides_what_is_sent(self):
        self.assertTrue(sent("*\n!a/*.deb\n", "a/b.deb"))
        self.assertFalse(sent("*\n!a/*.deb\n", "a/b.txt"))
        self.assertFalse(sent("!a/*.deb\n*\n", "a/b.deb"))
        self.assertFalse(sent("*\n!a/*.deb\n", "a/c/b.deb"))

    def test_a_file_that_is_not_sent_cannot_be_copied(self):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            (root / ".dockerignore").write_text("*\n!*.deb\n", encoding="utf-8")
            (root / "image/tmp").mkdir(parents=True)
            (root / "a.deb").write_text("a", encoding="utf-8")
            (root / "b.txt").write_text("b", encoding="utf-8")
            copy(root, root / "image", "*.deb /tmp/")
            self.assertEqual([file.name for file in (root / "image/tmp").iterdir()], ["a.deb"])
            with self.assertRaises(ContainerfileError):
                copy(root, root / "image", "b.txt /tmp/")

    def test_only_the_packages_are_sent(self):
        self.assertTrue(sent(IGNORE, "build/packages/platon-server_0.1.0_amd64.deb"))
        for path in ("build", "build/release/bin/platon-server", "build/packages/work/machine.tar", ".git/HEAD", "README.md"):
            self.assertFalse(sent(IGNORE, path), path)

    def test_options_keep_the_configuration_that_the_health_check_asks(self):
        option = "platon-server --config /etc/platon/server.toml"
        self.assertTrue(IMAGE.entrypoint[2].endswith(f'exec {option} "$@"'), IMAGE.entrypoint)
        self.assertIn("platon-server --console --config /etc/platon/server.toml", IMAGE.health[-1])
        self.assertEqual((IMAGE.command, IMAGE.user), ([], "platon"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
