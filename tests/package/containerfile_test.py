#!/usr/bin/env python3
"""Tests what deploy/Containerfile and .dockerignore say. container_test.py builds and runs the container.

usage: containerfile_test.py ROOT
"""

import re
import sys
import unittest
from pathlib import Path

from containerfile import ContainerfileError, read, sent

ROOT = Path(sys.argv[1]).resolve()
IMAGE = read((ROOT / "deploy/Containerfile").read_text(encoding="utf-8"))
STOP_SECONDS = 30  # beyond the drain, docs/hosting.md
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

    def test_the_page_says_how_a_stop_waits_for_a_drain(self):
        page = (ROOT / "docs/hosting.md").read_text(encoding="utf-8")
        stop = re.search(r"`--stop-timeout (\d+)` before the name of the image, and `--drain (\d+)` after it", page)
        self.assertTrue(stop, "docs/hosting.md does not tell how a container drains")
        self.assertEqual(int(stop[1]), int(stop[2]) + STOP_SECONDS)
        self.assertIn("kill the server after 10 s", page)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
