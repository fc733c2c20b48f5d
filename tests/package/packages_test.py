#!/usr/bin/env python3
"""Builds the Debian packages and lives through a server's life with them, in a machine booted by systemd-nspawn: the
commands of docs/hosting.md, players, reload, watchdog, upgrade and purge.

usage: packages_test.py ROOT. Exit 77 where that cannot be done.
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

TOOLS = ("mmdebstrap", "systemd-nspawn", "dpkg-buildpackage", "dpkg-deb", "lintian")
INCLUDED = "ca-certificates,dbus,procps,systemd,systemd-sysv,wget"
PAGE_COMMANDS = re.compile(r"<!-- commands: [^\n]*-->\n```\n(.*?)```", re.DOTALL)
NEXT_VERSION = "0.9999"
SERVICE = """[Unit]
Description=Test of the packages
After=multi-user.target

[Service]
Type=oneshot
Environment=DEBIAN_FRONTEND=noninteractive HOME=/
ExecStart=/bin/bash /opt/test/test.sh
ExecStopPost=/bin/systemctl poweroff --no-block
StandardOutput=append:/opt/test/log
StandardError=append:/opt/test/log
"""
BEGIN = """set -uo pipefail
debs=/opt/test/debs
cd "$debs"
export EDITOR=/opt/test/editor
"""


def skip(sentence):
    print(f"skipped: {sentence}")
    sys.exit(77)


def run(*command, limit=600, **options):
    """Runs a command; ends the test with its output if it fails."""
    words = [str(word) for word in command]
    result = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=limit, **options)
    if result.returncode != 0:
        sys.exit(f"{' '.join(words)} fails:\n{result.stdout[-6000:]}")
    return result.stdout


def commands_of(page):
    """The commands of the page from nothing to a running server, without their comments."""
    found = PAGE_COMMANDS.search(page)
    if not found:
        sys.exit("docs/hosting.md has no block of commands after the comment `commands: …`")
    commands = [re.sub(r"\s+#.*", "", line) for line in found[1].splitlines()]
    if len(commands) != 4:
        sys.exit(f"docs/hosting.md promises four commands, not {len(commands)}")
    return commands


def script(page, steps):
    """The whole script of the machine."""
    lines = [f"printf 'command: %s\\n' {quoted(each)}\nbash -c {quoted(each)} || {{ echo failed; exit 1; }}" for each in commands_of(page)]
    return BEGIN + "\n".join(lines) + "\n" + steps


def quoted(text):
    return "'" + text.replace("'", "'\\''") + "'"


def built_packages(root):
    """The packages of the tree, newly built and accepted by lintian."""
    run(root / "platon", "package", limit=2400)
    return [deb for deb in sorted((root / "build/packages").glob("*.deb")) if "-dbgsym_" not in deb.name]


def debian_image(root, name, included):
    """A minimal Debian 12 with some more packages, as an archive that is made once."""
    image = root / f"build/packages/work/{name}.tar"
    if not image.exists():
        partial = image.with_name(f"{name}-partial.tar")
        result = subprocess.run(["mmdebstrap", "--variant=minbase", f"--include={included}", "bookworm", partial],
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=600)  # fmt: skip
        if result.returncode != 0:
            skip(f"mmdebstrap cannot make a Debian 12 here: {result.stdout.strip().splitlines()[-1]}")
        partial.rename(image)
    return image


def raise_version(deb, folder):
    """Writes the same package with a higher version."""
    tree = folder / deb.stem
    run("dpkg-deb", "-R", deb, tree)
    control = tree / "DEBIAN/control"
    text = control.read_text(encoding="utf-8")
    version = re.search(r"(?m)^Version: (.*)$", text)[1]
    text = text.replace(f"Version: {version}\n", f"Version: {NEXT_VERSION}\n").replace(f"(= {version})", f"(= {NEXT_VERSION})")
    control.write_text(text, encoding="utf-8")
    run("dpkg-deb", "-b", tree, folder / f"{deb.name.split('_')[0]}_{NEXT_VERSION}.deb")
    shutil.rmtree(tree)


def furnish(machine, root, debs):
    """Puts the packages, what they depend on, and the script into the machine."""
    folder = machine / "opt/test/debs"
    (folder / "next").mkdir(parents=True)
    for deb in debs:
        shutil.copy(deb, folder)
        if deb.name.split("_")[0] in ("platon-data", "platon-server", "platon-tools"):
            raise_version(deb, folder / "next")
    shutil.copy("/etc/resolv.conf", machine / "etc/resolv.conf")
    (machine / "etc/apt/apt.conf.d/90test").write_text('APT::Get::Assume-Yes "true";\nAPT::Install-Recommends "false";\n')
    run("chroot", machine, "apt-get", "update")
    names = [f"/opt/test/debs/{deb.name}" for deb in debs]
    run("chroot", machine, "apt-get", "install", "--download-only", *names)
    editor = machine / "opt/test/editor"
    editor.write_text("#!/bin/sh\nsed -i 's/^name = .*/name = \"Edited\"/' \"$1\"\n")
    editor.chmod(0o755)
    page = (root / "docs/hosting.md").read_text(encoding="utf-8")
    steps = (root / "tests/package/machine_script.sh").read_text(encoding="utf-8")
    (machine / "opt/test/test.sh").write_text(script(page, steps), encoding="utf-8")
    units = machine / "etc/systemd/system"
    (units / "packages-test.service").write_text(SERVICE)
    (units / "multi-user.target.wants").mkdir(exist_ok=True)
    (units / "multi-user.target.wants/packages-test.service").symlink_to("../packages-test.service")


def boot(machine):
    """Runs the machine until it ends; what its script printed."""
    command = ["systemd-nspawn", "--directory", machine, "--register=no", "--keep-unit", "--private-network", "--boot"]
    process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    try:
        console = process.communicate(timeout=400)[0]
    except subprocess.TimeoutExpired:
        process.kill()
        console = process.communicate()[0] + "\nthe machine did not end in time"
    log = machine / "opt/test/log"
    if not log.exists():
        skip(f"systemd-nspawn cannot boot a machine here: {console.strip()[-400:]}")
    return log.read_text(encoding="utf-8", errors="replace")


def skip_without(*tools):
    if os.geteuid() != 0:
        skip("only root can boot a machine")
    missing = [tool for tool in tools if not shutil.which(tool)]
    if missing:
        skip(f"these programs are missing: {' '.join(missing)}")


def main(arguments):
    root = Path(arguments[1]).resolve()
    skip_without(*TOOLS)
    debs = built_packages(root)
    image = debian_image(root, "machine", INCLUDED)
    machine = Path(tempfile.mkdtemp(prefix="platon-machine-", dir="/var/tmp"))
    try:
        run("tar", "-C", machine, "-xf", image)
        machine.chmod(0o755)
        furnish(machine, root, debs)
        log = boot(machine)
    finally:
        shutil.rmtree(machine)
    print("\n".join(line for line in log.splitlines() if line.startswith(("command:", "step:", "all steps"))))
    if not log.endswith("all steps done\n"):
        sys.exit(log[-8000:])
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
