#!/usr/bin/env python3
"""Builds the container of deploy/Containerfile from a Debian made here, and runs what it starts: as its user, on a root
that cannot be written. systemd-nspawn runs it, because podman cannot run containers everywhere where it can build them.

usage: container_test.py ROOT. Exit 77 where that cannot be done.
"""

import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from packages_test import TOOLS, built_packages, debian_image, quoted, run, skip_without

BASE = "docker.io/library/debian:12-slim"
NAME = "platon-server-test"
MOST_BYTES = 40_000_000  # beyond the base
SCRIPT = """
{start} &
server=$!
end=$((SECONDS + 20))
until {healthy} >/dev/null 2>&1; do [ $SECONDS -lt $end ] || exit 3; sleep 0.2; done
id -u
! touch /usr/written 2>/dev/null || exit 4
kill $server
wait $server
"""


class Podman:
    def __init__(self, folder):
        self.options = ["--root", f"{folder}/root", "--runroot", f"{folder}/run", "--storage-driver", "vfs"]

    def __call__(self, *words):
        return run("podman", *self.options, "--cgroup-manager", "cgroupfs", *words).strip()

    def inspect(self, image):
        return json.loads(self("image", "inspect", image))[0]


def words_of(command):
    return " ".join(map(quoted, command))


def check(podman, root, image):
    podman("import", image, BASE)
    podman("build", "--format", "docker", "--network", "host", "--isolation", "chroot", "-f", root / "deploy/Containerfile",
           "-t", NAME, root)  # fmt: skip
    image = podman.inspect(NAME)
    beyond = image["Size"] - podman.inspect(BASE)["Size"]
    print(f"{beyond / 1e6:.1f} MB beyond the base")
    if beyond > MOST_BYTES:
        sys.exit(f"more than {MOST_BYTES / 1e6} MB")
    config = image["Config"]
    script = SCRIPT.format(start=words_of(config["Entrypoint"] + config["Cmd"]), healthy=words_of(image["Healthcheck"]["Test"][1:]))
    volumes = [f"--tmpfs={folder}:uid=10000,mode=0700" for folder in config["Volumes"]]
    result = subprocess.run(["systemd-nspawn", "--directory", podman("image", "mount", NAME), "--read-only", "--register=no",
                             "--keep-unit", "--private-network", "--as-pid2", "--quiet", f"--user={config['User']}", *volumes,
                             "/bin/bash", "-c", script], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, text=True, timeout=60)  # fmt: skip
    print(result.stdout)
    if result.returncode != 0 or "10000" not in result.stdout.splitlines():
        sys.exit(f"the container fails with {result.returncode}")


def main(arguments):
    root = Path(arguments[1]).resolve()
    skip_without("podman", *TOOLS)
    built_packages(root)
    image = debian_image(root, "slim", "ca-certificates")
    folder = Path(tempfile.mkdtemp(prefix="platon-container-", dir="/var/tmp"))
    try:
        check(Podman(folder), root, image)
    finally:
        shutil.rmtree(folder)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
