#!/usr/bin/env python3
"""Builds the container of deploy/Containerfile on a Debian made here, and runs it: as its user, on a root that cannot be
written, with and without an option. Where podman can, it builds and runs it. Else its steps are done in a folder, and what
it starts is started there; the test prints which way was taken.

usage: container_test.py ROOT. Exit 77 where neither can be done.
"""

import json
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import containerfile
from packages_test import built_packages, debian_image, run, skip, skip_without

FILE = "deploy/Containerfile"
NAME = "platon-server-test"
UID = 10000
MOST_BYTES = 40_000_000  # beyond the base
FIGURE = re.compile(r"about (\d+) MB larger than `debian:12-slim`")
# Like the base, it installs no documentation, but for the copyrights.
SLIM = ("path-exclude=/usr/share/doc/*", "path-include=/usr/share/doc/*/copyright")
OPTION = ["--name", "Tested"]  # an option keeps the others: health check, key and bans are where they were
# As docs/hosting.md shows it. The limits that podman sets by itself can be beyond those of this machine.
RESTRICTED = ["--read-only", "--cap-drop", "all", "--network", "none", "--ulimit", "nofile=1024:1024", "--ulimit", "nproc=1024:1024"]
# What holds in a container that runs.
INSIDE = r"""
id -u | grep -qx {uid} || {{ echo 'it runs as another user'; exit 1; }}
! touch /usr/written 2>/dev/null || {{ echo 'its root can be written'; exit 1; }}
grep -qx 'CapEff:\s*0000000000000000' /proc/self/status || {{ echo 'it has capabilities'; exit 1; }}
[ -f /var/lib/platon/server.key ] || {{ echo 'the key is not kept'; exit 1; }}
{health} | grep -qx 'server: {name}' || {{ echo 'the server has another name'; exit 1; }}
"""
SCRIPT = """
{start} &
server=$!
end=$((SECONDS + 20))
until {health} >/dev/null 2>&1; do [ $SECONDS -lt $end ] || {{ echo 'it is not healthy'; exit 1; }}; sleep 0.2; done
{inside}
kill $server
wait $server
"""


def newest_source(root):
    """When a file was changed last of which packages are made, seconds since 1970."""
    skipped = ("build", "docs", "tests")
    folders = [path for path in root.iterdir() if path.name not in skipped and not path.name.startswith(".")]
    files = [file for folder in folders for file in (folder.rglob("*") if folder.is_dir() else [folder])]
    return max(file.stat().st_mtime for file in files if file.is_file() and file != root / FILE)


def provide_packages(root):
    """Builds the packages, unless those of the test `packages` are newer than the sources."""
    found = [list((root / "build/packages").glob(f"{name}_*.deb")) for name in ("platon-data", "platon-server")]
    if any(len(files) != 1 or files[0].stat().st_mtime < newest_source(root) for files in found):
        skip_without("dpkg-buildpackage", "dpkg-deb", "lintian")
        built_packages(root)


def files_of(folder):
    """Size and time of every file, by its path."""
    found = {path: path.lstat() for path in folder.rglob("*") if path.is_file() and not path.is_symlink()}
    return {path: (status.st_size, status.st_mtime_ns) for path, status in found.items()}


def check_size(root, size):
    """The size beyond the base is within its limit, and about what the page says."""
    print(f"{size / 1e6:.1f} MB beyond the base")
    if size > MOST_BYTES:
        sys.exit(f"that is more than {MOST_BYTES / 1e6:g} MB")
    stated = int(FIGURE.search((root / "docs/hosting.md").read_text(encoding="utf-8"))[1])
    if not 0.8 * size <= stated * 1e6 <= 1.2 * size:
        sys.exit(f"docs/hosting.md says about {stated} MB")


def inside(image, name):
    return INSIDE.format(uid=UID, health=shlex.join(image.health), name=name)


def names_of(default):
    """The options after the name of the image, each with the name that the server then has."""
    return (([], default), (OPTION, OPTION[1]))


def default_name(folder):
    """The name that the installed configuration gives the server."""
    return re.search(r'(?m)^name = "(.*)"$', (folder / "etc/platon/server.toml").read_text(encoding="utf-8"))[1]


def check_folder(image, folder):
    """Starts in a folder what the image would start."""
    print("run by unshare, as podman cannot run containers here")
    for volume in image.volumes:
        if (folder / volume.strip("/")).stat().st_uid != UID:
            sys.exit(f"{volume} belongs to another user")
    for options, name in names_of(default_name(folder)):
        start = shlex.join(image.entrypoint + (options or image.command))
        script = SCRIPT.format(start=start, health=shlex.join(image.health), inside=inside(image, name))
        status, output = containerfile.start(image, folder, script)
        print(output)
        if status != 0:
            sys.exit(f"the container with {options} ends with {status}")


class Podman:
    """Podman with a store of its own, in a folder."""

    def __init__(self, folder):
        self.words = ["podman", "--root", f"{folder}/root", "--runroot", f"{folder}/run", "--storage-driver", "vfs",
                      "--cgroup-manager", "cgroupfs"]  # fmt: skip

    def __call__(self, *words):
        return run(*self.words, *words).strip()

    def can(self, *words):
        result = subprocess.run([*self.words, *words], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if result.returncode != 0:
            print(f"podman {words[0]} fails here: {result.stdout.strip()[-300:]}")
        return result.returncode == 0

    def build(self, file, root):
        return ["build", "--format", "docker", "--network", "host", "--isolation", "chroot", "-f", file, "-t", NAME, root]

    def size(self, image):
        return json.loads(self("image", "inspect", image))[0]["Size"]

    def config(self):
        """What the image starts, as podman has read it."""
        image = json.loads(self("image", "inspect", NAME))[0]
        config = image["Config"]
        return containerfile.Image(user=config["User"], volumes=list(config["Volumes"]), entrypoint=config["Entrypoint"],
                                   command=config.get("Cmd") or [], health=image["Healthcheck"]["Test"][1:])  # fmt: skip

    def check(self, image):
        print("run by podman")
        folder = Path(self("image", "mount", NAME))
        for options, name in names_of(default_name(folder)):
            self("run", "--detach", "--name", NAME, *RESTRICTED, NAME, *options)
            end = time.monotonic() + 20
            while not self.can("healthcheck", "run", NAME):
                if time.monotonic() > end:
                    sys.exit(f"the container with {options} is not healthy: {self('logs', NAME)}")
                time.sleep(0.2)
            self("exec", NAME, "/bin/bash", "-c", inside(image, name))
            self("stop", NAME)
            if self("wait", NAME) != "0":
                sys.exit(f"the container with {options} fails: {self('logs', NAME)}")
            print(self("logs", NAME))
            self("rm", NAME)


def build_in_folder(root, archive, folder):
    print("built by chroot, as podman is missing or cannot build here")
    image = containerfile.read((root / FILE).read_text(encoding="utf-8"))
    run("tar", "-C", folder, "-xf", archive)
    before = files_of(folder)
    containerfile.build(image, root, folder)
    after = files_of(folder)
    check_size(root, sum(status[0] for path, status in after.items() if before.get(path) != status))
    check_folder(image, folder)


def build_by_podman(podman, root):
    print("built by podman")
    podman(*podman.build(root / FILE, root))
    check_size(root, podman.size(NAME) - podman.size(containerfile.read((root / FILE).read_text(encoding="utf-8")).base))
    image = podman.config()
    if podman.can("run", "--rm", *RESTRICTED, NAME, "--version"):
        podman.check(image)
    else:
        check_folder(image, Path(podman("image", "mount", NAME)))


def podman_in(folder, root, archive):
    """Podman with the base, if it can build here."""
    if not shutil.which("podman"):
        return None
    podman = Podman(folder)
    base = containerfile.read((root / FILE).read_text(encoding="utf-8")).base
    probe = folder / "Containerfile"
    probe.write_text(f"FROM {base}\nRUN true\n", encoding="utf-8")
    return podman if podman.can("import", archive, base) and podman.can(*podman.build(probe, folder)) else None


def main(arguments):
    root = Path(arguments[1]).resolve()
    skip_without("mmdebstrap", "unshare")
    if subprocess.run([*containerfile.IN_ROOT, "--net", "true"], stderr=subprocess.DEVNULL).returncode != 0:
        skip("this machine allows no mounts of its own")
    provide_packages(root)
    archive = debian_image(root, "slim_without_docs", "ca-certificates", *SLIM)
    folder, podman = Path(tempfile.mkdtemp(prefix="platon-container-", dir="/var/tmp")), None
    try:
        podman = podman_in(folder, root, archive)
        if podman:
            build_by_podman(podman, root)
        else:
            (folder / "root").mkdir(exist_ok=True)
            build_in_folder(root, archive, folder / "root")
    finally:
        if podman:
            podman("rm", "--all", "--force")
        shutil.rmtree(folder)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
