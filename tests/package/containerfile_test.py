#!/usr/bin/env python3
"""Tests what deploy/Containerfile and .dockerignore say. container_test.py builds and runs the container.

usage: containerfile_test.py ROOT
"""

import sys
import unittest
from pathlib import Path

from containerfile import ContainerfileError, read, sent

ROOT = Path(sys.argv[1]).resolve()
IMAGE = read((ROOT / "deploy/Containerfile").read_text(encoding="utf-8"))
IGNORE = (ROOT / ".dockerignore").read_text(encoding="utf-8")


class Containerfile(unittest.TestCase):
    def test_what_is_not_known_is_refused(self):
        for line in ("ADD x y", "USER u\nRUN a", "COPY --chown=u x /y/", "ENV A=b", "CMD a", "HEALTHCHECK NONE"):
            with self.assertRaises(ContainerfileError, msg=line):
                read(f"FROM base\n{line}\n")

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
