#!/usr/bin/env python3
"""Builds the Debian packages and lives through a server's life with them, in a machine booted by systemd-nspawn: the
commands of docs/hosting.md, players, reload, watchdog, upgrade and purge. Where no machine can be booted, or with
--chroot, it does in a chroot what needs no systemd.

usage: packages_test.py ROOT [--chroot]. Exit 77 where that cannot be done.
"""

import contextlib
import os
import re
import shutil
import subprocess
import sys
import tempfile
import threading
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from baseline import later_instructions
from containerfile import LOOPBACK_UP
from repacked import NEXT_COMMENT, NEXT_VERSION, OLD_VERSION, as_next, as_old, repack
from shipped_docs_test import broken_links

TOOLS = ("mmdebstrap", "systemd-nspawn", "dpkg-buildpackage", "dpkg-deb", "lintian")
INCLUDED = "ca-certificates,dbus,systemd,systemd-sysv"
BOOT_LIMIT = 60  # seconds until the script begins
SCRIPT_LIMIT = 300  # seconds until it has ended
ISOLATED = ("unshare", "--mount", "--net", "--pid", "--fork", "--kill-child")
PAGE_COMMANDS = re.compile(r"<!-- commands: [^\n]*-->\n```\n(.*?)```", re.DOTALL)
SERVICE = """[Unit]
Description=Test of the packages
After=multi-user.target

[Service]
Type=oneshot
ExecStart=/bin/bash /opt/test/test.sh
ExecStopPost=/bin/systemctl poweroff --no-block
StandardOutput=append:/opt/test/log
StandardError=append:/opt/test/log
"""
BEGIN = f"""set -uo pipefail
debs=/opt/test/debs
old_version={OLD_VERSION}
next_comment={NEXT_COMMENT!r}
cd "$debs"
export EDITOR=/opt/test/editor DEBIAN_FRONTEND=noninteractive HOME=/
"""
# What a host finds beside the program.
PAGES = ("docs/hosting.md", "examples/agones/fleet.yaml", "examples/monitoring/alerts.yaml", "examples/monitoring/platon.json")
IN_OWN_NETWORK = f"{LOOPBACK_UP}; import os, sys; os.execvp(sys.argv[1], sys.argv[1:])"


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


def script(root, way):
    """The whole script of the machine, which is `booted` or a `chroot`. There the last two commands of the page, which ask
    systemd, are left out."""
    parts = [(root / f"tests/package/machine_{part}.sh").read_text(encoding="utf-8") for part in (way, "script")]
    commands = commands_of((root / "docs/hosting.md").read_text(encoding="utf-8"))
    lines = [f"printf 'command: %s\\n' {quoted(each)}\nbash -c {quoted(each)} || {{ echo failed; exit 1; }}" for each in commands]
    if way == "chroot":
        # Without /proc, which cannot be mounted everywhere, systemd-tmpfiles makes no folders for the package.
        lines = [lines[0], "[[ -e /proc/self ]] || make_folders", lines[1], "start_server"]
    return "\n".join([BEGIN, *parts, *lines, "all_steps", ""])


def quoted(text):
    return "'" + text.replace("'", "'\\''") + "'"


def built_packages(root):
    """The packages of the tree, newly built and accepted by lintian."""
    run(root / "platon", "package", limit=2400)
    return [deb for deb in sorted((root / "build/packages").glob("*.deb")) if "-dbgsym_" not in deb.name]


def debian_image(root, name, included, *options):
    """A minimal Debian 12 with some more packages, as an archive that is made once. `options`: of dpkg, kept in it."""
    image = root / f"build/packages/work/{name}.tar"
    if not image.exists():
        partial = image.with_name(f"{name}-partial.tar")
        kept = [f"--dpkgopt={option}" for option in options]
        result = subprocess.run(["mmdebstrap", "--variant=minbase", *kept, f"--include={included}", "bookworm", partial],
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=600)  # fmt: skip
        if result.returncode != 0:
            skip(f"mmdebstrap cannot make a Debian 12 here: {result.stdout.strip().splitlines()[-1]}")
        partial.rename(image)
    return image


def check_baseline(debs, folder):
    """The server runs on every machine of the architecture."""
    for deb in debs:
        if deb.name.startswith("platon-server_") and deb.name.endswith("_amd64.deb"):
            run("dpkg-deb", "-x", deb, folder)
            found = later_instructions(folder / "usr/bin/platon-server")
            if found:
                sys.exit(f"the packaged server has instructions that amd64 lacks: {' '.join(found)}")


def check_pages(debs, folder):
    """Every link of the pages leads somewhere, also in the packages, and so does the one to the pages."""
    for deb in debs:
        if deb.name.startswith(("platon-data_", "platon-server_")):
            run("dpkg-deb", "-x", deb, folder)
    documents = folder / "usr/share/doc"
    faults = broken_links(documents / "platon-data")
    faults += [f"{name} is missing" for name in PAGES if not (documents / "platon-server" / name).is_file()]
    if faults:
        sys.exit("\n".join(faults))


def check_ways(debs, folder):
    """The demonstration finds the recorded way of every level."""
    for deb in debs:
        if deb.name.startswith("platon-data_"):
            run("dpkg-deb", "-x", deb, folder)
            levels = folder / "usr/share/platon/levels"
            names = {path.stem for path in levels.rglob("*.level")}
            if not names or names != {path.stem for path in levels.glob("ways/*.recording")}:
                sys.exit("the packaged levels and the packaged recordings of ways differ")


def write_program(path, script):
    path.write_text(f"#!/bin/sh\n{script}")
    path.chmod(0o755)


def furnish(machine, debs):
    """Puts the packages, also of other versions, and what they depend on into the machine."""
    folder = machine / "opt/test/debs"
    for other in ("next", OLD_VERSION):
        (folder / other).mkdir(parents=True)
    for deb in debs:
        if deb.name.split("_")[0] in ("platon-data", "platon-server", "platon-tools"):
            shutil.copy(deb, folder)
            repack(deb, folder / "next", NEXT_VERSION, as_next)
            repack(deb, folder / OLD_VERSION, OLD_VERSION, as_old)
    shutil.copy("/etc/resolv.conf", machine / "etc/resolv.conf")
    (machine / "etc/apt/apt.conf.d/90test").write_text('APT::Get::Assume-Yes "true";\nAPT::Install-Recommends "false";\n')
    run("chroot", machine, "apt-get", "update")
    names = [f"/opt/test/debs/{deb.name}" for deb in folder.glob("*.deb")]
    run("chroot", machine, "apt-get", "install", "--download-only", "wget", *names)
    write_program(machine / "opt/test/editor", """sed -i 's/^name = .*/name = "Edited"/' "$1"\n""")
    write_program(machine / "opt/test/unit_editor", """sed -i '/^### Anything between/r /opt/test/drop_in' "$1"\n""")


def boot(machine, root):
    """Boots the machine, which runs the script and ends. What that printed, or None with what the machine printed if it
    does not boot."""
    (machine / "opt/test/test.sh").write_text(script(root, "booted"), encoding="utf-8")
    units = machine / "etc/systemd/system"
    (units / "packages-test.service").write_text(SERVICE)
    (units / "multi-user.target.wants").mkdir(exist_ok=True)
    (units / "multi-user.target.wants/packages-test.service").symlink_to("../packages-test.service")
    log = machine / "opt/test/log"
    command = ["systemd-nspawn", "--directory", machine, "--register=no", "--keep-unit", "--private-network", "--boot"]
    process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    not_booted = threading.Timer(BOOT_LIMIT, lambda: log.exists() or process.kill())
    not_booted.start()
    try:
        console = process.communicate(timeout=SCRIPT_LIMIT)[0]
    except subprocess.TimeoutExpired:
        process.kill()
        console = process.communicate()[0] + "\nthe machine did not end in time"
    not_booted.cancel()
    return (log.read_text(encoding="utf-8", errors="replace") if log.exists() else None), console


def can_isolate():
    return subprocess.run([*ISOLATED, "true"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode == 0


def live_in_chroot(machine, root):
    """Runs the script in a chroot, with a network and processes of its own where that can be had; what it printed."""
    write_program(machine / "usr/sbin/policy-rc.d", "exit 101\n")  # packages start no service
    (machine / "opt/test/test.sh").write_text(script(root, "chroot"), encoding="utf-8")
    isolated = [*ISOLATED, f"--mount-proc={machine / 'proc'}", sys.executable, "-c", IN_OWN_NETWORK] if can_isolate() else []
    log = machine / "opt/test/log"
    with log.open("wb") as output, contextlib.suppress(subprocess.TimeoutExpired):  # then the log has no end
        subprocess.run([*isolated, "chroot", machine, "/bin/bash", "/opt/test/test.sh"], stdin=subprocess.DEVNULL,
                       stdout=output, stderr=subprocess.STDOUT, timeout=SCRIPT_LIMIT)  # fmt: skip
    return log.read_text(encoding="utf-8", errors="replace")


def live(machine, root, reason):
    """Lives through a server's life, in a chroot if there is a reason not to boot, or if booting fails. What the script
    printed."""
    if not reason:
        log, console = boot(machine, root)
        if log is not None:
            return log
        reason = f"systemd-nspawn cannot boot a machine here: {(console.strip() or 'it printed nothing').splitlines()[-1]}"
    print(f"ran in a chroot, not booted: {reason}")
    return live_in_chroot(machine, root)


def skip_without(*tools):
    if os.geteuid() != 0:
        skip("only root can make a machine")
    missing = [tool for tool in tools if not shutil.which(tool)]
    if missing:
        skip(f"these programs are missing: {' '.join(missing)}")


def main(arguments):
    root = Path(arguments[1]).resolve()
    reason = "--chroot asks for it" if "--chroot" in arguments[2:] else ""
    skip_without(*TOOLS)
    with ThreadPoolExecutor() as threads:  # one computes, the other waits for the network
        image = threads.submit(debian_image, root, "machine", INCLUDED)
        debs = built_packages(root)
        image = image.result()
    machine = Path(tempfile.mkdtemp(prefix="platon-machine-", dir="/var/tmp"))
    try:
        check_baseline(debs, machine / "server")
        check_pages(debs, machine / "pages")
        check_ways(debs, machine / "data")
        run("tar", "-C", machine, "-xf", image)
        machine.chmod(0o755)
        furnish(machine, debs)
        log = live(machine, root, reason)
    finally:
        shutil.rmtree(machine)
    print("\n".join(line for line in log.splitlines() if line.startswith(("command:", "step:", "all steps"))))
    if not log.endswith("all steps done\n"):
        sys.exit(log[-8000:])
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
