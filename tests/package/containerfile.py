"""Reads a Containerfile and does its steps in a folder, where podman is missing or cannot build. It knows what
deploy/Containerfile uses, and refuses everything else.
"""

import json
import re
import shutil
import subprocess
import sys
from dataclasses import dataclass, field
from fnmatch import fnmatchcase

# A root with mounts and processes of its own: they end with the command.
IN_ROOT = ["unshare", "--mount", "--pid", "--ipc", "--fork", "--kill-child"]
CLEAN = ["env", "-i", "PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin"]
BUILD = """set -e
mount --rbind /dev "$1/dev"
mount -t proc proc "$1/proc"
touch "$1/etc/resolv.conf"
mount --bind /etc/resolv.conf "$1/etc/resolv.conf"
exec chroot "$1" /bin/sh -c "$2"
"""
# A line of Python, without apostrophes, for a network of its own: it has nothing but the loopback device.
LOOPBACK_UP = 'import fcntl, socket, struct; fcntl.ioctl(socket.socket(), 0x8914, struct.pack("16sH22x", b"lo", 1))'
# The user has no capability, and cannot get one.
START = f"""set -e
"$1" -c '{LOOPBACK_UP}'
root=$2
owner=$3
script=$4
shift 4
mount --bind "$root" "$root"
mount -o remount,bind,ro "$root"
mount --rbind /dev "$root/dev"
mount -t proc proc "$root/proc"
for folder; do mount -t tmpfs -o "mode=0700,uid=$owner" tmpfs "$root$folder"; done
exec chroot "$root" setpriv --reuid="$owner" --regid="$owner" --clear-groups --inh-caps=-all --bounding-set=-all \
  --no-new-privs /bin/bash -c "$script"
"""


class ContainerfileError(Exception):
    """A step fails or is unknown."""


@dataclass
class Image:
    """What a Containerfile describes."""

    base: str = ""
    user: str = "root"
    steps: list = field(default_factory=list)  # (COPY or RUN, what follows)
    volumes: list = field(default_factory=list)
    entrypoint: list = field(default_factory=list)
    command: list = field(default_factory=list)
    health: list = field(default_factory=list)


def words_of(text):
    """The words of a command or of a list; a command for the shell is unknown."""
    try:
        return json.loads(text)
    except json.JSONDecodeError as error:
        raise ContainerfileError(f"'{text}' is no list of words") from error


def read(text):
    """The image that the text of a Containerfile describes."""
    image = Image()
    for line in re.sub(r"(?m)^\s*#.*\n", "", text).replace("\\\n", "").splitlines():
        word, _, rest = line.strip().partition(" ")
        if word == "FROM":
            image.base = rest
        elif word in ("COPY", "RUN") and image.user == "root" and not rest.startswith("--"):
            image.steps.append((word, rest))
        elif word == "USER":
            image.user = rest
        elif word == "VOLUME":
            image.volumes = words_of(rest)
        elif word == "HEALTHCHECK":
            image.health = words_of(rest.partition("CMD ")[2])
        elif word == "ENTRYPOINT":
            image.entrypoint = words_of(rest)
        elif word == "CMD":
            image.command = words_of(rest)
        elif word not in ("", "EXPOSE"):
            raise ContainerfileError(f"the step '{line}' is unknown")
    return image


def sent(ignore, path):
    """Whether the rules of a .dockerignore let a path through. A rule fits a path and all that is in it."""
    through, names = True, path.split("/")
    for rule in ignore.split():
        patterns = rule.removeprefix("!").split("/")
        if len(patterns) <= len(names) and all(map(fnmatchcase, names, patterns)):
            through = rule.startswith("!")
    return through


def copy(root, folder, words):
    """Does COPY: the last word is a folder of the image, the others are files of the tree."""
    *sources, target = words.split()
    ignore = (root / ".dockerignore").read_text(encoding="utf-8")
    for source in sources:
        files = [path for path in sorted(root.glob(source)) if sent(ignore, path.relative_to(root).as_posix())]
        if not files:
            raise ContainerfileError(f"COPY finds no file {source} that .dockerignore lets through")
        for file in files:
            shutil.copy(file, folder / target.strip("/"))


def build(image, root, folder):
    """Does the steps in the folder, which holds the base."""
    for word, rest in image.steps:
        if word == "COPY":
            copy(root, folder, rest)
            continue
        result = subprocess.run([*CLEAN, *IN_ROOT, "/bin/sh", "-c", BUILD, "sh", folder, rest], stdin=subprocess.DEVNULL,
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=1200)  # fmt: skip
        if result.returncode != 0:
            raise ContainerfileError(f"RUN {rest} fails:\n{result.stdout[-4000:]}")


def uid_of(user, folder):
    """The number of a user of the system in the folder."""
    lines = (folder / "etc/passwd").read_text(encoding="utf-8").splitlines()
    return {line.split(":")[0]: line.split(":")[2] for line in lines}[user]


def start(image, folder, script):
    """Runs a script in the folder as the user of the image, without network, on a root of which only the volumes can be
    written. Returns its exit status and what it prints.
    """
    words = [sys.executable, folder, uid_of(image.user, folder), script, *image.volumes]
    result = subprocess.run([*CLEAN, *IN_ROOT, "--net", "/bin/sh", "-c", START, "sh", *words], stdin=subprocess.DEVNULL,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=60)  # fmt: skip
    return result.returncode, result.stdout
