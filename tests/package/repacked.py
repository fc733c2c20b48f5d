"""The packages of this build as those of another version: of a newer one, and of 0.1.0 with the scripts, the configuration
and the list of files that this release had.
"""

import re
import shutil
import stat
import subprocess
from pathlib import Path

NEXT_VERSION = "0.9999"
NEXT_COMMENT = "# Of the next version."
OLD_VERSION = "0.1.0"
OLD_RELEASE = Path(__file__).with_name(f"release_{OLD_VERSION}")
# The levels, of which no list is kept.
KEPT = "usr/share/platon/"


def repack(deb, folder, version, change):
    """Writes the same package with this version into the folder, after `change(package, tree)` has changed its files."""
    package, tree = deb.name.split("_")[0], folder / deb.stem
    subprocess.run(["dpkg-deb", "-R", deb, tree], check=True)
    control = tree / "DEBIAN/control"
    text = control.read_text(encoding="utf-8")
    before = re.search(r"(?m)^Version: (.*)$", text)[1]
    text = text.replace(f"Version: {before}\n", f"Version: {version}\n").replace(f"(= {before})", f"(= {version})")
    control.write_text(text, encoding="utf-8")
    change(package, tree)
    command = ["dpkg-deb", "-b", "-Znone", tree, folder / f"{package}_{version}.deb"]
    subprocess.run(command, stdout=subprocess.DEVNULL, check=True)
    shutil.rmtree(tree)


def as_next(package, tree):
    """Another configuration, as the next version may bring one."""
    for configuration in tree.glob("etc/platon/server.toml"):
        with configuration.open("a", encoding="utf-8") as file:
            file.write(f"{NEXT_COMMENT}\n")


def as_old(package, tree):
    """The files of the release, with the scripts of its maintainer."""
    listed = [line.split() for line in (OLD_RELEASE / "files").read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    wanted = {path for owner, path in listed if owner == package}
    if not wanted:
        return
    for path in sorted(tree.rglob("*"), reverse=True):
        name = path.relative_to(tree).as_posix()
        if name.startswith(("DEBIAN", KEPT)) or name in wanted:
            continue
        if path.is_symlink() or not path.is_dir():
            path.unlink()
        elif not any(path.iterdir()):
            path.rmdir()
    for name in wanted:
        path = tree / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if not path.exists():
            path.write_text(f"{name} of {OLD_VERSION}\n", encoding="utf-8")
    if package == "platon-server":
        shutil.copyfile(OLD_RELEASE / "server.toml", tree / "etc/platon/server.toml")
        replace_scripts(tree / "DEBIAN")


def replace_scripts(control):
    for name in ("preinst", "postinst", "prerm", "postrm"):
        script = control / name
        script.unlink(missing_ok=True)
        if (OLD_RELEASE / name).exists():
            shutil.copyfile(OLD_RELEASE / name, script)
            script.chmod(script.stat().st_mode | stat.S_IXUSR | stat.S_IXGRP | stat.S_IXOTH)
